"""Properties of strata_leaves.py of the Python checker, functions of its modules (sys.modules) that are True: what the exponents at
the places of a leaf exclude (strata_certificates.md 7.4, 7.6, 7.7).  The places are put there."""
from fractions import Fraction as F
from itertools import product
from types import SimpleNamespace

from lowest import refused
from places_of_leaves import bare, state
from places_of_leaves import leaf as leaf_of


def place(m, order=2, delta=None, side=-1, n=1, **more):
    x = m["places"].Place(None, n, order)
    x.side, x.open, x.b, x.chi, x.irrational = side, False, None, None, order == 2 and delta is None
    if delta is not None:
        x.delta = x.real = F(delta)
    vars(x).update(more)
    return x


def leaf(m, *finite, infinity=None, **more):
    """At infinity an ordinary point, if nothing is said"""
    local = m["places"].Local(list(finite), infinity or place(m, 0, side=1))
    x = bare(m, local=local, open=[y for y in local.all if y.open], qs=[], orders=[], content=m["multivariate"].ONE)
    x.torus = any(y.order >= 3 or y.irrational and not y.open for y in local.all)
    vars(x).update(more)
    return x


def exponents(m):
    """Of an exponential solution, and of the square of a product of two solutions"""
    line, twice = m["strata_leaves"].Leaf.line, m["strata_leaves"].Leaf.product

    def of(order, delta=None, side=-1, **more):
        x = place(m, order, delta, side, **more)
        return (line(x) if x.delta is not None else None), set(twice(x))
    both = {F(0), F(1)}
    return (of(0, side=1) == (both, {0, 2, 4}) and of(-3, side=1) == (both, {0, 2, 4}) and of(1) == ({F(-1)}, {-4, -2, 0})
            and of(1, side=1) == ({F(0)}, {0, 2, 4}) and of(2, "1/3") == ({F(-2, 3), F(-1, 3)}, {-2})
            and of(2, "1/3", 1) == ({F(1, 3), F(2, 3)}, {2}) and of(2, 3, logs=1) == ({F(-2)}, {-8, -2, 4})
            and of(2, 3, 1, logs=1) == ({F(-1)}, {-4, 2, 8}) and of(2, "5/2") == ({F(-7, 4), F(3, 4)}, {-7, -2, 3})
            and of(2, "2/3", 1)[1] == {2} and of(2) == (None, {-2}) and of(2, side=1) == (None, {2})
            and of(3) == (None, {-3}) and of(5) == (None, {-5}) and of(3, side=1) == (None, {1}) and of(6, side=1) == (None, {-2}))


def sums(m):
    x = leaf(m)
    two, three = place(m, 2, 0, n=2), place(m, 2, 1, n=1)

    def choice(y):
        return {1, 10} if y is two else {100}
    found = x.sums(choice, [two, three], [F(1, 2)])
    return (found == {F(205, 2) + k for k in (0, 9, 18)} and x.sums(choice, []) == {0}
            and x.sums(lambda y: range(3999), [three]) is not None and x.sums(lambda y: range(4001), [three]) is None)


def lines(m):
    """No exponential solution: a ramified place, D_1 < 0, or no sum of exponents that is natural"""
    def at(*deltas, last=1):
        return leaf(m, *[place(m, 2, x) for x in deltas], infinity=place(m, 2, last, 1))
    a, halves = place(m, 2, "1/3"), [F(1, 2**i) for i in range(1, 14)]
    open_one = place(m, 2, real=F(1))
    return (leaf(m, place(m, 3), a).irreducible() and leaf(m, a, place(m, 5)).irreducible() and leaf(m, place(m, 3), a).no_line()
            and at("1/3", "1/5", last="1/7").irreducible() and at("1/3", "1/5", last="1/7").no_line()
            and not at(1, 1, last=5).irreducible() and not at("1/3", "1/3").irreducible() and not at("1/3", "1/3").no_line()
            and not at("1/2", last="1/3").irreducible() and at("1/2", last="1/3").no_line()
            and leaf(m, open_one, a, infinity=place(m, 2, 1, 1)).no_line() is False
            # 2^13 sums, none of them natural, are too many
            and at(*halves[:2], last=3).no_line() and at(*halves, last=30).no_line() is False)


def invariants(m):
    """No invariant of degree m: D_m < 0, or D + 1 rows of full rank"""
    def of(*minors, known=("a",), degree=4, prime=None, square=1, of=4):
        s = state(m, {1: "z^2 - 2*z + 1 + a*z - a", 4: "4*z^2 - 8*z + 7 + 4*a*z - 4*a"}[square],
                  {1: "z^2 - 2*z + 1", 4: "4*z^2 - 8*z + 4"}[square], nonzero=known)
        absent = [{"m": of, "minors": [{"rows": rows, "times": times} for rows, times in minors], "prime": prime}] if minors else None
        x = leaf_of(m, s, ("z - 1", 2, {"chi": [str(-square), "1"]}), by="torus", content=str(square), absent=absent)
        found = []
        return x is not None and not refused(m, lambda: found.append(x.no_invariant(degree))) and found[0]
    # Delta = 1: D = 0, with 8 a (5 - 8 a), 8 a (16 a - 21), 64 a (3 - a) and -64 a; Delta = 2: D = 2
    ends, first, rest = ([3], "1"), ([0], "1"), ["a", "a^2 - 1"]
    return (of(ends) and not of(ends, known=()) and not of(first) and of(first, known=["a", "8*a - 5"]) and not of() and not of(ends, of=6)
            and not of(ends, degree=6) and not of(([3, 2], "1")) and not of(([], "1")) and not of(([4], "1"))
            and of(([0], "8"), ([3], "5")) and not of(([0], "8"), ([3], "5 - 8*a")) and of(([0], "0"), ends)
            and of(first, ends, prime=7) and of(ends, first, prime=2) and not of(first, ends, prime=2)
            and not of(ends, prime=7) and not of(([3], "2"), first, prime=7) and not of(first, ends, prime=7, known=())
            and not of(first, ends, prime=4)
            and of(([3, 4, 5], "1"), square=4, known=rest) and not of(([3, 4, 4], "1"), square=4, known=rest)
            and not of(([3, 4], "1"), square=4, known=rest) and not of(([3, 4, 5], "1"), square=4)
            and refused(m, lambda: leaf(m).no_invariant(202)) and leaf(m, infinity=place(m, 5, side=1)).no_invariant(200))


def common_roots(m):
    """Polynomials in one parameter without a common root, seen modulo a prime"""
    s, f = state(m), m["strata_leaves"].Leaf.no_common_root

    def of(p, *fs):
        found = []
        return not refused(m, lambda: found.append(f([s.poly(g) for g in fs], p))) and found[0]
    return (of(5, "a^2 - 2", "a - 1") and of(7, "a^2 - 2", "a^2 + 1") and not of(7, "a^2 - 2", "a - 3") and of(2, "a", "a - 1")
            and not of(2, "a^2 + 1", "a - 1")
            and not of(5, "5*a^2 + 1", "a - 1") and of(5, "a - 1", "5*a^2 + 1") and not of(5, "a", "b") and not of(5)
            and not of(5, "a", "b - 1", "1")
            and of(5, "3") and of(5, "3", "a") and not of(5, "5", "a") and not of(5, "a") and of(2**31 - 1, "a", "a + 1")
            and not of(2**31 + 11, "a", "a + 1") and not of(9, "a", "a + 1") and not of(1, "a", "a + 1") and not of(-5, "a", "a + 1"))


def theorems(m):
    """What each theorem needs (7.6); the rest of the leaf is put there"""
    def proves(by, torus=False, log=False, openings=0, irreducible=False, no_line=False, absent=(), excluded=True, order=1, rational=True):
        local = SimpleNamespace(log=log, character_order=lambda: order,
                                need_rational=lambda: m["certificate_format"].need(rational, "not rational"))
        x = bare(m, by=by, torus=torus, local=local, open=[place(m, b=F(1), open=True) for _ in range(openings)])
        vars(x).update(irreducible=lambda: irreducible, no_line=lambda: no_line, no_invariant=lambda m: m in absent,
                       one_open=lambda y: y.open and excluded)
        return not refused(m, x.prove)
    both, four = {"torus": True, "log": True}, {"absent": (4,)}
    return (proves("torus-log", **both) and not proves("torus-log", torus=True, absent=(4,))
            and not proves("torus-log", log=True, irreducible=True)
            and proves("torus", torus=True, **four) and not proves("torus", **four) and not proves("torus", torus=True, absent=(12,))
            and not proves("torus", torus=True, openings=1, **four) and not proves("torus", **both)
            and proves("irreducible-log", log=True, irreducible=True) and not proves("irreducible-log", irreducible=True, absent=(4, 12))
            and not proves("irreducible-log", log=True, no_line=True)
            and proves("rational", log=True, no_line=True) and proves("rational", no_line=True, absent=(12,))
            and not proves("rational", no_line=True)
            and not proves("rational", log=True) and proves("rational", log=True, absent=(2,))
            and not proves("rational", log=True, absent=(1, 3))
            and proves("rational", absent=(12, 6), order=3) and not proves("rational", absent=(12, 3), order=3)
            and proves("rational", absent=(12, 4), order=4) and not proves("rational", log=True, no_line=True, rational=False)
            and proves("one-open", openings=1, **four) and not proves("one-open", openings=2, **four) and not proves("one-open", **four)
            and not proves("one-open", openings=1) and not proves("one-open", openings=1, excluded=False, **four)
            and not proves("one-open", torus=True, log=True))


def several(m):
    """What several open places exclude (7.6, `open`)"""
    def asked(*bounds, torus=False, log=False, irreducible=False, absent=True):
        rows, found = [place(m, b=None if b is None else F(b), open=True) for b in bounds], []
        x = bare(m, torus=torus, local=SimpleNamespace(log=log), open=rows)
        vars(x).update(irreducible=lambda: irreducible, no_invariant=lambda n: n == 4 and absent,
                       excluded=lambda y, v: found.append((rows.index(y), v)) is None)
        right = []
        if refused(m, lambda: right.append(x.several_open())) or not right[0]:
            return None
        return set(found)
    halves = {(0, F(1, 2)), (0, F(1)), (0, F(3, 2)), (1, F(1, 2))}
    primitive = {(0, F(a, n)) for n in (2, 3, 4, 5) for a in range(1, 8) if F(a, n) <= F(3, 2)}
    return (asked("3/2", "1/2", torus=True) == asked("3/2", "1/2", log=True, irreducible=True) == halves
            and asked("3/2", "1/2", irreducible=True) == halves | primitive and asked("0", "1/2", torus=True) == {(1, F(1, 2))}
            and asked("1", "1") is None and asked("1", "1", torus=True, absent=False) is None
            and asked("1", "1", irreducible=True, absent=False) is None
            and asked("1", None, torus=True) is None and asked(None, "1", torus=True) is None
            and asked(torus=True, irreducible=True) is None)


def asked_of_one(m, b, *others, n=1, side=-1, real=lambda v: True):
    """The values that one open place has to exclude, or None"""
    x, found = place(m, 2, None, side, n, open=True, b=None if b is None else F(b)), []
    finite, infinity = [*others], place(m, 0, side=1)
    if side == 1:
        infinity = x
    else:
        finite.append(x)
    y = leaf(m, *(z for z in finite if z.side == -1), infinity=next((z for z in others if z.side == 1), infinity))
    vars(y).update(excluded=lambda z, v: found.append(v) is None, primitive=lambda z, v: real(v))
    right = []
    return None if refused(m, lambda: right.append(y.one_open(x))) or not right[0] else set(found)


def expected(m, b, *others, n=1, side=-1, primitive=True):
    """7.7, with all j and many k tried"""
    b, log, found = F(b), any(x.logs for x in others), set()
    if all(x.side == -1 for x in others) and side == -1:
        others = [*others, place(m, 0, side=1)]
    torus = any(x.order >= 3 or x.irrational for x in others)

    def all_sums(choice, start):
        return {sum(v, F(start)) for v in product(*(choice(x) for x in others for _ in range(x.n)))}

    def natural(v):
        return v >= 0 and v.denominator == 1
    leaf_class = m["strata_leaves"].Leaf
    if not log:
        for f in all_sums(leaf_class.product, 2 * side * n):
            found |= {F(k, 2) for k in range(1, int(2 * b) + 1) if any(natural((f + j * k) / 2) for j in range(-n, n + 1))}
    if not torus:
        if not log and primitive:
            found |= {F(a, k) for k in (1, 2, 3, 4, 5) for a in range(1, 60) if F(a, k) <= b}
        for f in all_sums(leaf_class.line, F(side * n, 2)):
            found |= {abs(2 * (k - f) / j) for j in range(-n, n + 1, 2) if j for k in range(60)}
    return {v for v in found if v <= b}


def one_open(m):
    """The values of Delta at one open place (7.7) are these and no others"""
    def irrational(side=-1):
        return place(m, 2, None, side)

    def regular(delta, side=-1, **more):
        return place(m, 2, delta, side, **more)
    irregular, log = place(m, 3), regular(1, logs=1)
    cases = [("2", [regular("1/3"), regular("1/4", 1)], {}), ("7/2", [regular("1/3"), regular("1/3", 1)], {"n": 3}),
             ("4", [log, regular("1/3", 1)], {"n": 4}), ("3", [log, regular("2/7", 1)], {"n": 2}),
             ("3/2", [regular("1/2"), regular("1/2")], {"side": 1}),
             ("5/2", [irrational()], {}), ("4", [irrational(), regular("1/3", 1)], {"n": 2}), ("3", [irregular], {}),
             ("7/2", [irrational()], {"side": 1}),
             ("3", [irrational(), regular("5/2", 1)], {}), ("9/2", [log, regular("1/2", 1)], {"n": 3}), ("6", [log, regular("1/2", 1)], {}),
             ("5", [log, regular("3/5"), regular("1/2", 1)], {"n": 3}), ("2", [regular("1/2"), place(m, 1, side=1)], {}),
             ("5/2", [log, regular("31/3", 1)], {"n": 3})]
    right = all(asked_of_one(m, b, *others, **more) == expected(m, b, *others, **more) for b, others, more in cases)
    six, none = [regular("1/6"), regular("1/4", 1)], {"real": lambda v: False}
    many = [regular(F(1, 2**i)) for i in range(1, 14)]
    return (right and asked_of_one(m, "2", *six) == asked_of_one(m, "2", *six, **none) == expected(m, "2", *six, primitive=False)
            and asked_of_one(m, None, log, irregular) == set() and asked_of_one(m, None, irregular) is None
            and asked_of_one(m, None, log) is None and asked_of_one(m, None, regular("1/3")) is None
            # j = 0: 5/3 - 2/3 - 1 = 0, and 2 - 1 - 1 = 0
            and asked_of_one(m, "1", regular("1/3"), regular("7/3", 1), n=2) is None
            and asked_of_one(m, "1", log, regular(3, 1), n=2) is None
            and asked_of_one(m, "1", log, regular(2, 1), n=2) is not None and asked_of_one(m, "1", log, *many, regular("1/3", 1)) is None)


def primitive(m):
    """A finite primitive group, and the place is open again"""
    x = place(m, 2, open=True)
    y = leaf(m, x, place(m, 2, "1/3"), infinity=place(m, 2, "1/2", 1))
    found = [v for v in (F(1, 5), F(2, 5), F(1, 4), F(1, 3), F(1, 6), F(1, 7), F(1)) if y.primitive(x, v) or x.delta is not None
             or not x.irrational]
    return found == [F(1, 5), F(2, 5), F(1, 4), F(1, 3), F(1, 6), F(1)]


def properties():
    """(name, function, True)"""
    return [(f"exponents_of_leaves.{f.__name__}", f, True) for f in (exponents, sums, lines, invariants, common_roots, theorems,
                                                                    several, one_open, primitive)]
