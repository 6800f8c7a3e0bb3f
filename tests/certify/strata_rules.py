"""Properties of condition.py, stratum.py, strata.py and stratum.py of the Python checker, functions of its modules (sys.modules) that are
True: what is known at a node of a certificate over strata (strata_certificates.md 3 to 6)."""
import copy
from fractions import Fraction as F
from types import SimpleNamespace

import leaf_certificates
from lowest import refused
from places_of_leaves import state


def silent(**more):
    return {"membership": None, "value": None, "terms": None, "times": None, "prime": None} | more


def done(m, f):
    """What f returns, or "refused" """
    found = []
    return "refused" if refused(m, lambda: found.append(f())) else found[0]


def signs(m):
    """What is known to be positive; conditions and memberships by their numbers"""
    s = state(m, membership=("a", "2"), positive=["a", "0"], nonnegative=["b"], nonzero=["a - b"], zero=["a - 2"])
    a, b, two = (s.poly(f) for f in ("a", "b", "2"))

    def condition(i, *given):
        return done(m, lambda: s.condition(i, *given))
    known = state(m, nonnegative=["b"], nonzero=["b"])

    def factor(s, *v):
        """Of a term: is it 0 nowhere, and >= 0 everywhere?"""
        return done(m, lambda: [f(s.product_of(["1", list(v)])) for f in (s.is_strict, s.has_sign)])
    return (s.is_positive(a) and s.is_positive(a * 3) and not s.is_positive(a * -1) and not s.is_positive(b)
            and not s.is_positive(s.poly("0"))
            and s.is_positive(two) and not s.is_positive(two * -1) and refused(m, lambda: s.poly("z")) and s.poly("z", True) == {1: 1}
            and condition(0, "positive") == a and condition(2, "nonnegative", "positive") == b and condition(0, "zero") == "refused"
            and condition(5, "zero") == "refused" and condition(-1, "zero") == "refused" and condition(4, "zero") == s.poly("a - 2")
            and factor(s, "condition", "0", "1") == [True, True] and factor(s, "condition", "2", "1") == [False, True]
            and factor(known, "condition", "0", "3") == [True, True]
            and factor(s, "square", "a", "1") == [True, True] and factor(s, "square", "b", "1") == [False, True]
            and factor(state(m, real="a"), "square", "b", "1") == [False, False]
            and factor(s, "condition", "3", "1") == [True, False] and factor(s, "condition", "3", "2") == [True, True]
            and factor(s, "square", "a", "0") == "refused" and factor(s, "cube", "a", "1") == "refused"
            and done(m, lambda: s.need_violated(0, F(1, 2), s.poly("a - 1"))) is None
            and done(m, lambda: s.need_violated(0, F(1), s.poly("a - 2"))) == "refused"
            and done(m, lambda: s.need_violated(0, F(1, 2), s.poly("a - 2"))) == "refused"
            and done(m, lambda: s.need_violated(1, F(1, 2), s.poly("a - 1"))) == "refused"
            and done(m, lambda: s.need_violated(-1, F(1, 2), s.poly("a - 1"))) == "refused")


def lemmas(m):
    """Sums of terms, and what shows a sign"""
    def total(*terms):
        s = state(m, positive=["a"], nonnegative=["b"])
        found = done(m, lambda: s.sum_of(list(terms)))
        return found if found == "refused" else {k: F(c, found[1]) for k, c in found[0].items()}
    a, b = 1 << m["multivariate"].FIELD, 1 << 2 * m["multivariate"].FIELD
    one, other = ["1", ["condition", "0", "1"]], ["2/3", ["condition", "1", "1"]]

    def lemma(p, sign="nonzero", **more):
        s = state(m, membership=("a", "2"), positive=["a"], nonnegative=["b"], nonzero=["a - b"])
        found = done(m, lambda: s.lemma(silent(p=p, sign=sign, **more)))
        return found != "refused" and (found.is_unit(s.poly(p)), found.is_positive(s.poly(p)))
    terms = {"terms": [one, other]}
    half = {"membership": 0, "value": F(1, 2)}
    return (total(one) == {a: 1} and total(other) == "refused" and total(one, other) == {a: 1, b: F(2, 3)}
            and total(["1/2"], ["1/3"]) == {0: F(5, 6)} and total(["1", ["square", "a", "3"]]) == {6 * a: 1}
            and not any(total(v) != "refused" for v in ("1", [], None, {}, ["0"], ["-1"], "2/3"))
            and lemma("3*a + 2*b", "positive", times="1/3", **terms) is False
            and lemma("3*a + 2*b", "positive", terms=[["3", one[1]], ["2", other[1]]]) == (True, True)
            and lemma("-3*a - 2*b", times="-1", terms=[["3", one[1]], ["2", other[1]]]) == (True, False)
            and lemma("-3*a - 2*b", "positive", times="-1", terms=[["3", one[1]], ["2", other[1]]]) is False
            and lemma("a - 1", **half) == (True, False) and lemma("1", **half) is False and lemma("0", **half) is False
            and lemma("2", membership=0, value=F(1)) is False
            and lemma("a", membership=0) is False and lemma("a", value=F(1)) is False and lemma("a") is False
            and lemma("a", **terms, prime=7) is False
            and lemma("a", terms=[one], prime=7) is False and lemma("a", terms=[one], membership=0) is False
            and lemma("a", terms=[one]) == (True, True)
            and lemma("a^2 - a*b", times="1") == (True, False) and lemma("a^2 - b", times="1") is False
            and lemma("a", "positive", times="1") is False)


def strata(m):
    """p = l x + m: what is known where it is 0"""
    def solved(p, name="a", num="z", den="1", real="ab", r=("z", "1"), membership=None, **known):
        s = state(m, num, den, real, membership, **known)
        return done(m, lambda: s.solve(s.poly(p), name, r and dict(zip(("num", "den"), r))))

    def conditions(s):
        return [(dict(f), sign) for f, sign in s.conditions]
    b = 1 << 2 * m["multivariate"].FIELD
    one = solved("a - b", positive=["a"], nonnegative=["a^3 + b"], zero=["a^2 - 4"])
    two = solved("b*a - 1", real="a", nonzero=["b"], positive=["a", "b^2"], zero=["a - 1"], nonnegative=["b + 1"])
    real = solved("b*a - 1", nonzero=["b"], positive=["a^3"], nonnegative=["a^3"])
    of = solved("b*a - 1", nonzero=["b"], membership=("a", "a^2 + 1"))
    part = solved("b*a - 1", nonzero=["b"], membership=("a^2 + 1", "3"))
    return (conditions(one) == [({b: 1}, "positive"), ({3 * b: 1, b: 1}, "nonnegative"), ({2 * b: 1, 0: -4}, "zero")]
            and [x for x in conditions(two) if x[1] in ("positive", "zero", "nonnegative")] == [
                ({2 * b: 1}, "positive"), ({0: 1, b: -1}, "zero"), ({b: 1, 0: 1}, "nonnegative")]
            and [x for x in conditions(real) if x[1] != "nonzero"] == [({b: 1}, "positive"), ({b: 1}, "nonnegative")]
            and [(dict(f), dict(g)) for (f, g), _ in of.integers] == [({b: 1}, {0: 1, 2 * b: 1})]
            and [(dict(f), dict(g)) for (f, g), _ in part.integers] == [({0: 1, 2 * b: 1}, {2 * b: 3})]
            and solved("a - b", "c") == "refused" and solved("a^2 - b") == "refused" and solved("b*a - 1") == "refused"
            and solved("a - b", num="a*z", r=("b*z", "1")) != "refused" and solved("a - b", num="a*z", r=("a*z", "1")) == "refused"
            and solved("a - b", num="a*z", r=("b*z + 1", "1")) == "refused" and solved("a - b", num="a*z - b*z", r=("0", "0")) == "refused"
            and solved("a - b", num="a*z - b*z", den="z", r=("0", "1")) != "refused"
            and solved("a - b", den="a*z - b*z", r=None).den is None
            and solved("a - b", den="a*z - b*z", r=("z", "1")) == "refused" and solved("a - b", r=None) == "refused"
            and solved("a - b", num="a^2*z - b*z", den="a^2 - a", r=("z", "1")) != "refused"
            and solved("a - b", r=("b*z", "b")) == "refused")


def divisions(m):
    """den as a product, and the recurrence of a symmetric power (6)"""
    def factors(den, *rows, content="1", **known):
        s = state(m, "1", den, **known)
        return not refused(m, lambda: m["stratum"].factors(s, content, [{"q": q, "order": k} for q, k in rows]))

    def invariant(num, den, M, p, *rows, content="1", **known):
        s = state(m, num, den, **known)
        d = {"content": content, "m": M, "p": p, "places": [dict(zip(("q", "order", "e"), row)) for row in rows]}
        return not refused(m, lambda: m["stratum"].invariant(s, d))
    a = {"nonzero": ["a"]}
    return (factors("a*z^2 + z", ("a*z + 1", 1), ("z", 1), **a) and not factors("a*z^2 + z", ("a*z + 1", 1), ("z", 1))
            and not factors("a*z", ("a", 1), ("z", 1), **a) and factors("a*z", ("z", 1), content="a", **a)
            and not factors("a*z", ("z", 1), content="a")
            and not factors("z", ("z", 1), ("z - 1", 0)) and not factors("z", ("z", 2), ("z", -1)) and not factors("z^2", ("z", 1))
            and not factors("z^2", ("z + a", 2)) and not factors("z^3", ("z", 2)) and factors("1")
            # z exp(1/z), with its inverse z exp(-1/z): the product is z^2
            and invariant("a", "z^4", 2, "1", ("z", 4, 2)) and invariant("a", "z^4", 2, "z", ("z", 4, 1))
            and not invariant("a", "z^4", 2, "1", ("z", 4, 1))
            and invariant("a", "4*z^4", 2, "1", ("z", 4, 2), content="4") and invariant("2", "z^2", 1, "1", ("z", 2, 2))
            and invariant("2", "z^2", 1, "1", ("z", 2, -1)) and not invariant("2", "z^2", 1, "1", ("z", 2, 1))
            and not invariant("2", "z^2", 0, "1", ("z", 2, 2))
            and not invariant("2", "z^2", 1, "0", ("z", 2, 2)) and not invariant("2", "z^2", 1, "a", ("z", 2, 2))
            and invariant("2", "z^2", 1, "a", ("z", 2, 2), **a))


def tree(m, **more):
    x = object.__new__(m["strata"].Tree)
    vars(x).update({"prove": None, "leaves": m["strata"].Counter(), "nodes": 0, "trust": 0, "names": ["z", "a", "b"], "path": [],
                    "way": [], "lines": [], "denials": [], "criteria": []} | more)
    return x


def leaves(m):
    """Nodes without points, trusted ones, and what is denied where"""
    nowhere = state(m).also(units=[m["multivariate"].P()])

    def empty(s=nowhere, **more):
        return not refused(m, lambda: tree(m).empty(s, silent(**more), None, 1))
    s = state(m, membership=("a", "1"), zero=["0", "a^2 - 2*a"])
    x = tree(m)
    for said in ("no", "yes", "no", "empty", "no"):
        x.trusted(s, {"abelian": said, "theorem": "", "statement": ""})
    classical, by = tree(m), {"abelian": "no"}
    leaf = SimpleNamespace(verdict=lambda: by["abelian"], by="bessel", criterion=lambda names: "where", one_difference=lambda names: None)
    for said in ("no", "yes", "where"):
        by["abelian"] = said
        classical.classical(leaf, dict(by))

    def denials(top):
        m["multivariate"].Work.left = 10**7
        return m["strata"].accept(copy.deepcopy(top), None)[0].denials
    make, simple = leaf_certificates.top, ("z - 1", 1, {})
    divided, no = make("z + b", "z^2 - a", "torus-log", ("z^2 - a", 1, {})), {"zero": "trusted", "abelian": "no", "theorem": "", "statement": ""}
    for p in ("a", "b^2 - a"):
        divided["tree"] = {"node": "split", "p": p, "nonzero": divided["tree"], "zero": no}
    divided["claim"] = {"abelian": None}
    m["multivariate"].Work.left = 2000
    stuck = refused(m, lambda: tree(m).assumed(s, {"condition": 0, "p": "a", "zero": None}, None, 1))
    return (empty() and not empty(membership=0) and not empty(value=F(1)) and not empty(membership=0, value=F(1), terms=[])
            and not empty(state(m))
            and empty(state(m, zero=["2"]))
            and not refused(m, lambda: tree(m).empty(s, silent(membership=0, value=F(1, 2)), s.poly("2*a - 1"), 1))
            and x.denials == [(False, False, 1, (), False)] * 3 and x.trust == 5 and dict(x.leaves) == {"no": 3, "yes": 1, "empty": 1}
            and classical.denials == [(False, False, 0, (), False)] and dict(classical.leaves) == {"no": 1, "yes": 1, "where": 1}
            and denials(make("2*z + 1", "z^4 - z^3", "torus-log", ("z", 3, {}), simple)) == [(False, False, 0, (), False)]
            and denials(make("z + b", "z^2 - a", "torus-log", ("z^2 - a", 1, {}), nonzero=["a", "b^2 - a"])) == [(False, False, 0, (), False)]
            and denials(divided) == [(False, False, 0, (("b^2 - a", "nonzero"), ("a", "nonzero")), False),
                                     (False, False, 1, (("b^2 - a", "nonzero"), ("a", "zero")), False),
                                     (False, False, 1, (("b^2 - a", "zero"),), False)]
            and stuck)


def roots(m):
    """One equation over Q[x]/(p), and 0/0 at its root"""
    exact, K = m["exact"], m["exact"].K

    def root(p, minimal, num="z", den="1"):
        s, x = state(m, num, den), tree(m)
        K.m, K.d, K.s = list(minimal), len(minimal) - 1, 2 * len(minimal) - 3
        try:
            of = [[*v] + [0] * (K.s - len(v)) for v in ([], [1])]
            x.nested = lambda d, *rule: (exact.Poly(of[0] + of[1]), exact.Poly(of[1]))
            return not refused(m, lambda: x.root(s, {"variable": "a", "abelian": "no"}, s.poly(p), 1))
        finally:
            K.m, K.d, K.s = [0, 1], 1, 1

    def same(num, den, top, bottom):
        s = state(m, num, den)
        K.m, K.d, K.s = [-2, 0, 1], 2, 3
        try:
            powers = [exact.Poly([1]), exact.Poly([0, 1]), exact.Poly([2])]
            return not refused(m,
                               lambda: m["strata"].same_equation(s, m["multivariate"].FIELD, powers, exact.Poly(top), exact.Poly(bottom)))
        finally:
            K.m, K.d, K.s = [0, 1], 1, 1
    z, one = [0, 0, 0, 1, 0, 0], [1]
    return (root("a^2 - 2", [-2, 0, 1]) and root("a^3 - a - 1", [-1, -1, 0, 1]) and not root("a^2 - 3", [-2, 0, 1])
            and not root("a", [0, 1])
            and not root("a^3 - 2", [-2, 0, 1]) and not root("a^2 - 2", [-2, 0, 0, 1]) and not root("b^2 - 2", [-2, 0, 1])
            and same("z", "1", z, one) and not same("2*z", "1", z, one) and same("a^2*z", "2", z, one)
            and not same("a^2*z - 2*z", "a^2 - 2", z, one)
            and not same("z", "a^2 - 2", z, one))


def whole(m):
    """Signs of assumptions, and what goes wrong in a tree is a refusal"""
    S, top = m["strata"], leaf_certificates.top("z^2 + 1", "z", "torus-log", ("z", 1, {}))
    true = S.Tree.walk

    def accepts(top):
        m["multivariate"].Work.left = 10**7
        return not refused(m, lambda: S.verify(copy.deepcopy(top), None))

    def fails(error):
        def raising(*_):
            raise error("no")
        S.Tree.walk = raising
        return not accepts(top)
    right = accepts(top) and all(accepts(top | {"assumptions": [{"p": "a", "sign": x}]}) for x in ("positive", "nonnegative", "nonzero",
        "zero"))
    wrong = any(accepts(top | {"assumptions": [{"p": "a", "sign": x}]}) for x in ("negative", "dropped", ""))
    try:
        return right and not wrong and all(map(fails,
                                               (ZeroDivisionError, OverflowError, ValueError, KeyError, IndexError, TypeError,
                                                AttributeError,
                                                       RecursionError, MemoryError)))
    finally:
        S.Tree.walk = true


def integers(m):
    """Integers that a closed criterion asks of: a, a^2/b and a b + 7/2 are some, b is none; a + 1 and a + 2 are positive"""
    C = m["strata_classical"]
    x = object.__new__(C.Classical)
    x.s = s = state(m, positive=["a + 1", "a + 2"], nonzero=["b"])

    def of(num, den="1"):
        return s.poly(num), s.poly(den)
    x.shown = [(of("a"), True), (of("a^2", "b"), True), (of("b"), False), (of("2*a*b + 7", "2"), True)]
    known = [x.known(of(*f)) for f in (("a",), ("a + 3",), ("-a",), ("2*a + 1", "2"), ("a^2", "b"), ("b",), ("a*b",), ("2*a*b + 1", "2"),
                                       ("5",), ("5", "2"))]
    return (known == [True, True, True, None, True, False, None, True, True, False]
            and [x.natural(of(*f)) for f in (("a",), ("-a", "-1"), ("a + 1",), ("a + 2",), ("-a - 2",), ("a + 2", "-1"), ("a^2", "b"), ("2*a",),
                                             ("b",))] == [True, True, True, None, False, False, None, None, None]
            and [x.natural(of(*f)) for f in (("3",), ("0",), ("-1",), ("-4", "2"), ("-4", "-2"), ("1", "2"))] == [
                True, True, False, False, True, None]
            and [x.known(of(*f)) for f in (("6", "3"), ("6", "4"))] == [True, False])


def differences(m):
    """A natural difference with one of the others' sums among N - 1, N - 3, ..., 1 - N; and differences of which one is no number"""
    s, C = state(m), m["strata_classical"].Classical
    x, square = object.__new__(C), {f: (s.poly(f), s.poly("4")) for f in ("a", "b", "2")}

    def root(c, k):
        """k a + c"""
        return s.poly(f"{k * c.denominator}*a + {c.numerator}".replace("+ -", "- ")), s.poly(str(c.denominator))
    values = [F(n, 2) for n in (-7, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 8)]
    for N in (F(0), F(1), F(2), F(3), F(5), F(3, 2), F(5, 2), None):
        for c in values:
            for k in (1, -1, 2):
                found = x.trivial(SimpleNamespace(value=N), *(SimpleNamespace(root=r) for r in (root(c, k), root(F(1, 2), 1))))
                total = {1: c - F(1, 2), -1: c + F(1, 2)}.get(k)            # of the two, without a
                if found != (N is not None and N.denominator == 1 and total in range(1 - int(N), int(N), 2)):
                    return False

    def number(value=None, of="a", irrational=False):
        return SimpleNamespace(value=value, square=square[of], irrational=irrational)

    def one(*three, by="riemann"):
        vars(x).update(by=by, three=lambda: three)
        return x.one_difference(["z", "a", "b"])
    r, a, b, irrational = number(F(1, 2)), number(), number(of="b"), number(of="2", irrational=True)
    rows = [SimpleNamespace(root=None), SimpleNamespace(root=root(F(0), 0))]
    return (one(r, a, r) == ([F(1, 2), F(1, 2)], 1, ["a", "4"]) and one(b, r, b) == ([F(1, 2)], 2, ["b", "4"]) and one(a, a, a)[:2] == ([], 3)
            and all(one(*v) is None for v in ((r, a, b), (a, a, b), (r, r, r), (r, r, irrational), (irrational, r, irrational), (r, a, irrational)))
            and one(r, a, r, by="lame") is None
            and not any(x.trivial(SimpleNamespace(value=F(2)), *v) for v in (rows, rows[::-1], rows[:1] * 2)))


def properties():
    """(name, function, True)"""
    return [(f"strata_rules.{f.__name__}", f, True) for f in (signs, lemmas, strata, divisions, leaves, roots, whole, integers, differences)]
