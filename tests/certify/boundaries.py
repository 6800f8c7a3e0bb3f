"""Certificates at the bounds of the rules of kovacic-certificate/1, true ones beside the nearest false ones: equations with
places of every order, whose lines, ranks and p-curvatures are as short as the rules allow, and one term shorter; and
equations with an invariant, for which no rank may be full.  certificates() yields what is stated, the text and whether it is
right; the C++ checker judges all of it, too (python_test.py)."""
import json
from fractions import Fraction as F
from functools import cache
from itertools import combinations
from math import isqrt, prod

import traps
from adversary import approximants
from asymmetric import certificate, conclude, invariant, local, plus, scaled, texts, times
from certificate_format import RULES, Rejected, load, read
from group_rules import Checker
from modular import is_prime


def power(a, n):
    b = [F(1)]
    for _ in range(n):
        b = times(b, a)
    return b


def quotient(a, b):
    """Of polynomials, where b divides a"""
    a, q = [F(x) for x in a], []
    while len(a) >= len(b):
        q.insert(0, a[-1] / F(b[-1]))
        a = plus(a, scaled(times([0] * (len(a) - len(b)) + [1], b), -q[0]))[:-1]
    return q


def derivative(a):
    return [i * x for i, x in enumerate(a)][1:]


def at(a, x):
    return sum(F(c) * F(x)**i for i, c in enumerate(a))


class Equation:
    """y'' = r y, r = num/den with rational poles {root: order}.  Its places with what is needed for D_1 and D_m."""

    def __init__(self, num, poles, without=()):
        self.num, self.poles, self.without = [F(x) for x in num], poles, without
        self.den = [F(1)]
        for c, k in poles.items():
            self.den = times(self.den, power([-F(c), 1], k))
        self.order = 4 - (len(self.den) - len(self.num))

    def laurent(self, c, n):
        """The first n coefficients of t^order r at the pole c; c None: of r(1/t)/t^4 at t = 0"""
        if c is None:
            a, b = self.num[::-1], self.den[::-1]
        else:
            a = shifted(self.num, c)
            b = shifted(quotient(self.den, power([-F(c), 1], self.poles[c])), c)
        a, b, out = a + [F(0)] * n, b + [F(0)] * n, []
        for i in range(n):
            out.append((a[i] - sum(b[j] * out[i - j] for j in range(1, i + 1))) / b[0])
        return out

    def place(self, c, order):
        if order == 2 and c is not None and c not in self.without:
            return {"delta2": texts([1 + 4 * self.laurent(c, 1)[0]])}
        if order >= 4 and order % 2 == 0:
            nu, a = order // 2, self.laurent(c, order // 2)
            root = [F(1)]                   # the square root of 1 + ...
            for i in range(1, nu):
                root.append((a[i] / a[0] - sum(root[j] * root[i - j] for j in range(1, i))) / 2)
            return {"eps2": texts([4 * a[0] * root[nu - 1]**2])}
        return {}

    def local(self):
        rule, none, data = local(*({"q": texts([-F(c), 1]), "order": str(k)} | self.place(c, k) for c, k in self.poles.items()))
        return rule, none, data | {"infinity": self.place(None, self.order)}

    @property
    def r(self):
        return texts(self.num), texts(self.den)

    def certificate(self, claim, *steps):
        return certificate(self.r, claim, self.local(), *steps)

    def checked(self):
        """The rules of the checker, and the places"""
        num, den, *_ = load(json.loads(certificate(self.r, {"group": "SL2"}, self.local())))
        checker = Checker(num, den)
        return checker, checker.local(read(RULES["local"], self.local()[2], ""))


def shifted(a, c):
    """a(z + c)"""
    b = []
    for x in reversed(a):
        b = plus(times(b, [F(c), 1]), [F(x)])
    return b or [F(0)]


# ---- no exponential solution

# A simple pole is a logarithm: whoever accepts the line has proved SL(2).
SINGULAR = {
    "simple": Equation([3, 1], {0: 1}),
    "two simple": Equation([1, 2, 1], {0: 1, 3: 1}),
    "infinity of order 2": Equation([5], {0: 1, 3: 1}),
    "order 2": Equation([5, 7, 2, 1], {0: 1, 2: 2}),
    "order 2, infinity too": Equation([5, 7], {0: 1, 2: 2}),
    "order 4": Equation([1, -2, 5, 3, 1, 1], {0: 1, 1: 4}),
    "order 4, infinity of order 2": Equation([1, -2, 5, 3], {0: 1, 1: 4}),
    "order 6": Equation([4, 1, -1, 2, 1, 3], {0: 1, 1: 6}),
    "order 6 at 2": Equation([4, 1, -1, 2, 1, 3], {0: 1, 2: 6}),
    "order 8 at 3": Equation([4, 1, -1, 2, 1, 3, 1, 5], {0: 1, 3: 8}),
    "four of order 2": Equation([4, 1, -1, 2, 1, 3, 1, 5], {0: 1, 1: 2, 2: 2, 3: 2, -1: 2}),
    "Delta = 0": Equation([-1, 3, 2, 1], {0: 1, 2: 2}),
    "two irregular": Equation([9, 1, 2, 1, 2, 1, 1, 4, 1, 2], {0: 1, 1: 4, -1: 4}),
    "infinity of order 6": Equation([2, 1, -3, 1], {0: 1}),
    "infinity of order 8": Equation([1, 1, 0, 2, 1, 1], {0: 1}),
    "infinity of order 10": Equation([1, 3, 1, 0, 2, 1, 0, 1], {0: 1}),
    "infinity of order 1": Equation([2, 1], {0: 1, 1: 1, 3: 2}),
    "infinity of order 0": Equation([2, 1], {0: 1, 1: 2, 3: 2}),
    "infinity of order -1": Equation([1], {0: 1, 1: 2, 3: 2}),
}


def starts(checker, x, p, root, delta, terms):
    """The expansions that are not a contradiction"""
    _, _, num, den = checker.good({"p": p, "a": 0})
    n, e = checker.expansion(p, num, den, root, x.order)
    some = dict.fromkeys((1 + s) * (p + 1) // 2 % p if x.order <= 2 else s % p for s in (delta, -delta))
    return [S for S in (checker.riccati(n, e, x.order, s, terms, p) for s in some) if S]


def prime(equation, c, order):
    """A prime, and a square root modulo it of Delta^2 or of the first coefficient, at the pole c or at infinity"""
    first = equation.laurent(c, 1)[0] if order > 1 else F(0)
    square = 1 + 4 * first if order <= 2 else first
    for p in filter(is_prime, range(1009, 2000)):
        wanted = square.numerator * pow(square.denominator, -1, p) % p
        delta = next((x for x in range((p + 1) // 2) if (x * x - wanted) % p == 0), None)
        if delta is not None:
            return p, delta
    raise ValueError("no prime")


def lines(equation, terms=60):
    """(data, whether it is long enough) for each place, at the least length and just below"""
    checker, places = equation.checked()
    for i, c, x in [*((i, c, x) for i, (c, x) in enumerate(zip(equation.poles, places.finite))), ("infinity", None, places.infinity)]:
        if x.order < 1:
            continue
        p, delta = prime(equation, c, x.order)
        root = c if c is None else c % p
        found, least = starts(checker, x, p, root, delta, terms), bound(places, x)
        rows = [list(approximants(S, p)) for S in found]
        for short in range(-1, len(rows)):
            chosen = [nearest(row, least, j != short) for j, row in enumerate(rows)]
            if None not in chosen:
                last = 1 + max((k for *_, k in chosen), default=1)
                while len(starts(checker, x, p, root, delta, last)) > len(found):
                    last += 1
                yield {"by": "series", "place": str(i), "p": str(p), "a": "0", "root": str(root or 0), "delta": str(delta), "terms": str(last),
                       "lines": [{"length": str(l), "approximant": list(map(str, C))} for l, C, _ in chosen]}, short < 0


def bound(places, x):
    """L (riccati_one_place.md)"""
    L = places.degree_bound_1() + sum(y.n * max(1, y.order // 2) for y in places.finite)
    return L + (max(1, x.order // 2) if x.q is None else max(0, places.infinity.order // 2 - 2) + 1)


def nearest(row, least, long):
    """The approximant that excludes just what it must, or just not"""
    some = [a for a in row if (a[2] + 1 - a[0] > least) is long]
    return (min if long else max)(some, key=lambda a: a[2] + 1 - a[0], default=None)


def variants(data, right):
    """A line and the same polynomials and numbers, written otherwise"""
    yield data, right
    p, rows = int(data["p"]), data["lines"]
    if right and rows:
        first, (start, *others) = rows[0], rows[0]["approximant"]
        zeros = ["0"] * (int(first["length"]) + 1 - len(others))
        for approximant in ([start, *others, *zeros], [str(p + int(start)), *others]):
            yield data | {"lines": [first | {"approximant": approximant}, *rows[1:]]}, False
        yield data | {"lines": rows[:-1]}, False
        yield data | {"delta": str(p + int(data["delta"]))}, False


def no_exponential():
    for name, equation in SINGULAR.items():
        for data, right in [x for data, right in lines(equation) for x in variants(data, right)]:
            yield (f"{name}, place {data['place']}, {data['terms']} terms",
                   equation.certificate({"group": "SL2"}, ("no-exponential", ["s0"], data), conclude("sl2-irreducible-log", 0, 1)), right)


# ---- no invariant

@cache
def irreducible(equation):
    return "no-exponential", ["s0"], next(data for data, right in lines(equation) if right)


def rank(m, T, p=1009, x0=5):
    return {"m": str(m), "by": "series", "p": str(p), "a": "0", "x0": str(x0), "terms": str(T)}


def no_invariant():
    for name, equation in SINGULAR.items():
        _, places = equation.checked()
        for m in (2, 4, 6):
            D = places.degree_bound(m) if None not in [x.lowest(m) for x in places.finite] else -1
            some = [({"m": str(m), "by": "degree"}, D < 0)]
            least = max(D, -1) + m + 2
            some += [(rank(m, least), True), (rank(m, least - 1), False), (rank(m, least, x0=next(iter(equation.poles))), False),
                     (rank(m, least, x0=1009 + 5), False)] if m < 6 and None not in [x.lowest(m) for x in places.finite] else []
            for data, right in some:
                yield (f"{name}: degree {m}, {data}", equation.certificate(
                    {"group": "SL2"}, irreducible(equation), ("no-invariant", ["s0"], data), conclude("sl2-irreducible-log", 0, 1, 2)), right)


def many_terms():
    """As many terms as the prime allows, and as the limit does"""
    equation = SINGULAR["order 2"]
    checker, places = equation.checked()
    D = max(-1, places.degree_bound(2))
    p = next(p for p in range(D + 4, 100) if is_prime(p) and seen(checker.no_invariant, rank(2, p, p), places))
    for data, right in ((rank(2, p, p), True), (rank(2, p + 1, p), False), (rank(2, D + 1004, 2003), True), (rank(2, D + 1005, 2003), False)):
        yield (f"{data}", equation.certificate({"group": "SL2"}, irreducible(equation), ("no-invariant", ["s0"], data),
                                               conclude("sl2-irreducible-log", 0, 1, 2)), right)


def seen(rule, data, places):
    """Does the checker accept this step?"""
    try:
        return bool(rule({k: v if k in ("by", "shows") else int(v) for k, v in data.items()}, places))
    except (Rejected, ArithmeticError, ValueError):
        return False


class Invariant(Equation):
    """y'' = r y with v = prod (z - c)^e and w: r = w^2/(4 v^2) + (v'/v)'/2 + (v'/v)^2/4"""

    def __init__(self, es, w):
        self.es = {F(c): F(e) for c, e in es.items()}
        S = [F(1)]
        for c in self.es:
            S = times(S, [-c, 1])
        A = plus(*(scaled(quotient(S, [-c, 1]), e) for c, e in self.es.items()))
        slope = plus(times(derivative(A), S), scaled(times(A, derivative(S)), -1))
        common = {c: max(2, 2 * e) for c, e in self.es.items()}
        over, below = [F(1)], [F(w) * F(w) / 4]
        for c, k in common.items():
            over, below = times(over, power([-c, 1], int(k) - 2)), times(below, power([-c, 1], int(k - 2 * self.es[c])))
        num = plus(below, times(plus(scaled(slope, F(1, 2)), scaled(times(A, A), F(1, 4))), over))
        while num and not num[-1]:
            num = num[:-1]
        poles = {c: int(k) for c, k in common.items()}
        for c in list(poles):
            while poles[c] and not at(num, c):
                num, poles[c] = quotient(num, [-c, 1]), poles[c] - 1
        super().__init__(num, {c: k for c, k in poles.items() if k})

    def v(self, m=2):
        return invariant(m, ["1"], *((texts([-c, 1]), str(e * F(m, 2))) for c, e in self.es.items()))


INVARIANT = [Invariant({0: 2, 1: 1, 3: -1}, F(1, 3)), Invariant({0: 1, 1: 1, -1: 1}, F(1, 3)), Invariant({0: 1, 2: 3}, F(1, 5)),
             Invariant({0: -1, 1: 2}, 3), Invariant({0: -2, 1: 1, 3: 1}, F(1, 7)), Invariant({0: 3, 1: -2, 2: 1, -2: 1}, F(1, 5)),
             Invariant({0: 1, 1: 1}, 2), Invariant({1: 1, 0: 1, 5: 1}, 20), Invariant({0: -1, 1: -1, 3: 2}, 1)]


def invariants():
    """No rank is full where there is an invariant; it is an invariant, and no power of another function is"""
    for i, equation in enumerate(INVARIANT):
        _, places = equation.checked()
        for m in (2, 4, 6):
            D, start = places.degree_bound(m), (equation.local(), equation.v(m))
            yield f"{i}: degree {m}", certificate(equation.r, {"abelian": True}, equation.v(m), conclude("invariant-abelian", 0)), True
            for data in ({"m": str(m), "by": "degree"}, rank(m, D + m + 2), rank(m, D + m + 6, x0=7)):
                yield f"{i}: {data}", certificate(equation.r, {"abelian": True}, *start, ("no-invariant", ["s0"], data),
                                                  conclude("invariant-abelian", 0, 1, 2)), False


# ---- p-curvatures

def p_curvatures():
    """What B_p shows: of irreducible equations all of it for some p, of those with an invariant never "sl2" """
    for name, equation in [*SINGULAR.items(), *((f"invariant {i}", x) for i, x in enumerate(INVARIANT))]:
        checker, places = equation.checked()
        for p in (5, 7):
            for shows in ("nonzero", "irreducible", "sl2"):
                data = {"p": str(p), "a": "0", "shows": shows}
                right = seen(checker.p_curvature, data, places)
                if isinstance(equation, Invariant):
                    claim, start, theorem = {"abelian": True}, equation.v(), "invariant-abelian"
                else:
                    claim, start, theorem = {"group": "SL2"}, irreducible(equation), "sl2-irreducible-log"
                yield f"{name}: {data}", equation.certificate(claim, start, ("p-curvature", ["s0"], data), conclude(theorem, 0, 1, 2)), right


def torsion():
    """The product of the primes exceeds the bound (q + 2 + floor(2 sqrt q))^g just so, or not quite; or F0 has a double root
    modulo 37."""
    for name, genus, qs, first_prime in (("x-lame0-B1-naive", 1, (3, 7, 13, 17, 37), 3), ("x-lame-p8-naive", 1, (5, 7, 13), 5),
                                         ("x-genus2-naive", 2, (3, 5, 7), 3), ("x-genus3-naive", 3, (3, 5), 3)):
        top = json.loads(traps.read("data", name + ".json"))
        first = [s for s in top["steps"] if s["rule"] in ("local", "invariant")]
        for q in qs:
            primes = [p for p in range(first_prime, 48) if is_prime(p) and p != q]
            products = sorted([(p,) for p in primes] + [x for k in (2, 3) for x in combinations(primes, k)], key=prod)
            limit = (q + 2 + isqrt(4 * q))**genus
            for chosen in (max((x for x in products if prod(x) <= limit), key=prod), min((x for x in products if prod(x) > limit), key=prod)):
                steps = [*first, {"id": "q", "rule": "good-reduction", "premises": ["invariant"], "data": {"p": str(q), "a": "0"}}]
                steps += [{"id": str(p), "rule": "p-curvature", "premises": [], "data": {"p": str(p), "a": "0", "shows": "nonzero"}} for p in chosen]
                steps.append({"id": "end", "rule": "conclude", "premises": [s["id"] for s in steps], "data": {"theorem": "dihedral-torsion"}})
                yield f"{name}, reduction at {q}: {chosen}", json.dumps(top | {"steps": steps}), prod(chosen) > limit and q != 37


def lame(roots, a):
    """Lame's equation with n = 1 and the product v = (z - a) sqrt(F0) of two solutions, w^2 = F0(a): v, num and den of r."""
    branch = [F(1)]
    for x in roots:
        branch = times(branch, [-x, 1])
    d = derivative(branch)
    num = plus(scaled(times(d, d), -3), scaled(times(branch, derivative(d)), 4), scaled(times(branch, [a - sum(roots), 2]), 4))
    return branch, scaled(num, F(1, 16)), times(branch, branch)


def good_primes():
    """A prime is good where w^2 is a unit and F0 squarefree, whatever the values of v and r at some point are."""
    for roots, a, k in (((2, 3, 5), 11, 1), ((0, 1, 3), 5, 1), ((-1, 2, 7), 13, 1), ((2, 3, 5), 11, 5), ((0, 1, 3), 5, 7), ((5, 10, -15), 1, 1)):
        roots, a = [F(x, k) for x in roots], F(a, k)
        branch, num, den = lame(roots, a)
        places = local(*({"q": texts([-x, 1]), "order": "2", "delta2": ["1/4"]} for x in roots))
        v = invariant(2, texts([-a, 1]), *((texts([-x, 1]), "1/2") for x in roots))
        top = load(json.loads(certificate((texts(num), texts(den)), {"group": "Dinf"}, places)))
        curvature = Checker(*top[:2]).p_curvature
        primes = [p for p in range(3, 48) if is_prime(p) and seen(curvature, {"p": p, "a": 0, "shows": "nonzero"}, None)]
        for q in (3, 5, 7, 11, 13):
            square = at(branch, a)
            good = k % q and square.numerator % q and len({int(x * k) % q for x in roots}) == 3
            chosen = [p for p in primes if p != q][:4]
            steps = [places, v, ("good-reduction", ["s1"], {"p": str(q), "a": "0"})]
            steps += [("p-curvature", [], {"p": str(p), "a": "0", "shows": "nonzero"}) for p in chosen]
            steps.append(conclude("dihedral-torsion", *range(len(steps))))
            yield f"roots {roots}, zero {a}: reduction at {q}", certificate((texts(num), texts(den)), {"group": "Dinf"}, *steps), bool(good)


def certificates():
    for family in (no_exponential, no_invariant, many_terms, invariants, p_curvatures, torsion, good_primes):
        for why, text, right in family():
            yield f"{family.__name__}: {why}", text, right
