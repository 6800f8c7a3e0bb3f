"""Leaves that rest on a closed criterion (strata_certificates.md 7.8), at the bounds of its rules: the last one that is right
beside the first that is wrong.  r is computed here from the change of variable and the equation; criteria.py has it written
out.  A, B, C are the parameters."""
import itertools
import json
from fractions import Fraction
from math import lcm

from criteria import certificate, fraction, shown

NAMES = "zABC"


class Poly(dict):
    """A polynomial in z, A, B, C: {exponents: rational number}"""

    def __add__(self, o):
        o = poly(o)
        return Poly({k: c for k in {*self, *o} if (c := self.get(k, 0) + o.get(k, 0))})

    def __mul__(self, o):
        total = Poly()
        for j, a in self.items():
            total = total + Poly({tuple(map(sum, zip(j, k))): a * b for k, b in poly(o).items()})
        return total

    def __pow__(self, n):
        return product([self] * n)

    def __sub__(self, o):
        return self + poly(o) * -1

    def __rsub__(self, o):
        return poly(o) - self

    def __neg__(self):
        return self * -1

    def __truediv__(self, n):
        return self * Fraction(1, n)

    __radd__, __rmul__ = __add__, __mul__

    def diff(self):
        return Poly({(k[0] - 1, *k[1:]): c * k[0] for k, c in self.items() if k[0]})

    def coefficient(self, n):
        return Poly({(0, *k[1:]): c for k, c in self.items() if k[0] == n})

    def degree(self):
        return max(k[0] for k in self)

    def of(self, p, q, n):
        """q^n self(p/q), in z"""
        return sum((self.coefficient(i) * p**i * q**(n - i) for i in range(self.degree() + 1)), Poly())

    def __str__(self):
        """Of integral coefficients"""
        def term(k, c):
            powers = [x if e == 1 else f"{x}^{e}" for x, e in zip(NAMES, k) if e]
            return "*".join([str(abs(c)), *powers])
        text = "".join((" + " if c > 0 else " - ") + term(k, c) for k, c in sorted(self.items(), reverse=True))
        return text.replace(" + ", "", 1) if text[:3] == " + " else text.replace(" - ", "-", 1) or "0"


def poly(x):
    if isinstance(x, str):
        names = {n: Poly({tuple(int(n == y) for y in NAMES): Fraction(1)}) for n in NAMES}
        return poly(eval(x.replace("^", "**"), {}, names))      # pylint: disable=eval-used (texts of this file)
    return x if isinstance(x, Poly) else Poly({(0,) * len(NAMES): Fraction(x)} if x else {})


def product(fs):
    total = poly(1)
    for f in fs:
        total = total * f
    return total


z, A, B, C = map(poly, NAMES)
HALF = Fraction(1, 2)


def over(num, den=1):
    """num/den with integers"""
    num, den = poly(num), poly(den)
    n = lcm(*(c.denominator for f in (num, den) for c in f.values()))
    return fraction(str(num * n), str(den * n))


def squared(x):
    """A number that is known by its square alone"""
    return {"square": over(x)}


def root(x):
    return {"square": over(poly(x)**2), "root": over(x)}


def pulled_back(num, den, p, q):
    """f'^2 R(f) - S(f)/2 for R = num/den and f = p/q"""
    W = p.diff() * q - p * q.diff()
    U, Wq = W.diff() * q - W * q.diff() * 2, W * q
    n = max(num.degree(), den.degree())
    top, bottom = num.of(p, q, n), den.of(p, q, n)
    S = (U.diff() * Wq - U * Wq.diff()) * 2 - U * U
    return W**4 * top * 4 - q**2 * bottom * S, W**2 * q**4 * bottom * 4


def leaf(num, den, by, numbers, said="where", p="z", q="1", **more):
    num, den, p, q = map(poly, (num, den, p, q))
    r = (num, den) if (p, q) == (z, poly(1)) else pulled_back(num, den, p, q)
    return json.dumps(certificate(over(*r), by, numbers, said, over(num, den), over(p, q), **more))


# -- changes of variable, and numbers that may be undefined

BESSEL = "4*A^2 - 4*z^2 - 1", "4*z^2"
ORDER = [squared(0), root("A")]


def changes():
    yield "a Moebius map", leaf(*BESSEL, "whittaker", ORDER, p="2*z + 1", q="z + 3"), True
    for p in "A*B - C", "A*B + C":
        yield f"a Moebius map, {p}", leaf(*BESSEL, "whittaker", ORDER, p="B*z + C", q="z + A", nonzero=[p]), p == "A*B - C"
    for p, q in ("z^2 + B", "C*z - 1"), ("z^2 + B*z", "z^2 - 3"), ("2*z^2 - z", "3"):
        text = leaf(*BESSEL, "whittaker", ORDER, p=p, q=q)
        yield f"({p})/({q})", text, True
        wrong = json.loads(text)
        for change in over("z^2 - B", q), over(p, "z - 1"), over(poly(p) * 2, q):
            wrong["tree"]["change"] = change
            yield f"({p})/({q}) as another", json.dumps(wrong), False
    for given in (["B"], []):
        yield "a square over B", leaf(*BESSEL, "whittaker", [squared(0), {"square": over(A**2 * B, B)}], nonzero=given), bool(given)
        number = {"square": over(A**2), "root": over(A * B, B)}
        yield "a root over B", leaf(*BESSEL, "whittaker", [squared(0), number], nonzero=given), bool(given)


# -- Whittaker and Bessel

def confluent():
    k2, m2, n2 = squared(Fraction(1, 4)), squared(HALF), squared(2)         # of 1/4 + 1/2z + 1/4z^2, and without 1/4
    for den in "4*z^2", "z^3 + 4*z^2", "4*z^2 + 1", "4*z^2 + z":
        yield f"whittaker over {den}", leaf("z^2 + 2*z + 1", den, "whittaker", [k2, m2]), den == "4*z^2"
        yield f"bessel over {den}", leaf("2*z + 1", den, "bessel", [n2]), den == "4*z^2"
    yield "bessel of degree 2", leaf("z^2 + 2*z + 1", "4*z^2", "bessel", [n2]), False
    yield "whittaker of degree 1", leaf("2*z + 1", "4*z^2", "whittaker", [k2, m2]), False
    yield "whittaker of degree 3", leaf("z^3 + z^2 + 2*z + 1", "4*z^2", "whittaker", [k2, m2]), False
    for numbers in [n2, n2], [squared(3), n2], []:
        yield f"bessel, {len(numbers)} numbers", leaf("2*z + 1", "4*z^2", "bessel", numbers), False
    for numbers in [m2], [k2, k2, m2], []:
        yield f"whittaker, {len(numbers)} numbers", leaf("z^2 + 2*z + 1", "4*z^2", "whittaker", numbers), False
    for given in (["A"], []):
        yield "A times whittaker", leaf("A*z^2 + 2*A*z + A", "4*A*z^2", "whittaker", [k2, m2], nonzero=given), bool(given)
        yield "A times bessel", leaf("2*A*z + A", "4*A*z^2", "bessel", [n2], nonzero=given), bool(given)
        yield "k = 0, m = 1 over A", leaf(z * z + 3 * A, 4 * A * z * z, "whittaker", [squared(0), squared(1)], nonzero=given), \
            bool(given)
    for k, m in ("A", "B"), ("A + 1", "B"), ("A", "B + 1"):
        yield f"k = {k}, m = {m}", leaf("z^2 - 4*A*z + 4*B^2 - 1", "4*z^2", "whittaker", [root(k), root(m)]), (k, m) == ("A", "B")
    for n in "A", "A + 1":
        yield f"n = {n}", leaf("4*B*z + A^2 - 1", "4*z^2", "bessel", [root(n)], nonzero=["B"]), n == "A"
    for n in range(5):
        for said in "yes", "no":
            yield f"n = {n}/2: {said}", leaf(z + HALF**2 * (n * n * HALF**2 - 1), z * z, "bessel", [squared((n * HALF)**2)], said), \
                (said == "yes") == (n % 2 == 1)


def whittaker(k, m, said, kind=squared, **more):
    k, m = poly(k), poly(m)
    numbers = [root(k), root(m)] if kind is root else [squared(k * k), squared(m * m)]
    return leaf(z * z - 4 * k * z + 4 * m * m - 1, 4 * z * z, "whittaker", numbers, said, **more)


def verdicts_of_whittaker():
    for k, m in itertools.product(range(7), repeat=2):                      # quarters
        k, m = Fraction(k, 4), Fraction(m, 4)
        sums = k + m - HALF, k - m - HALF
        right = all(x.denominator == 1 for x in sums) and (sums[0] >= 0) != (sums[1] >= 0)
        for said in "yes", "no":
            yield f"k = {k}, m = {m}: {said}", whittaker(k, m, said), said == ("yes" if right else "no")
    integer = {"given": [(over(2 * A), True)], "known": [shown(over(2 * A), True)]}
    for said in "yes", "no", "where":
        yield f"k - m - 1/2 = 1/2: {said}", whittaker(A + 1, A, said, root), said != "yes"
        for m in A, -A:
            yield f"k - m - 1/2 = 1, of m = {m}: {said}", whittaker(A + 3 * HALF, m, said, root, **integer), said == "where"
        for numbers in [squared(A**2), root(B)], [root(A), squared(B**2)]:
            yield f"a root is unknown: {said}", leaf("z^2 - 4*A*z + 4*B^2 - 1", "4*z^2", "whittaker", numbers, said), said == "where"
    yield "a root is irrational", leaf("z^2 + 2*z + 1", "4*z^2", "whittaker", [squared(Fraction(1, 4)), squared(HALF)], "no"), True


# -- Riemann and Lame

def fuchsian(by, roots, squares, infinity=None, E=poly(1), said="where", extra=0, **more):
    """N/(E P^2) with the squares of the differences at the roots of P, and at infinity (lame: of 2n + 1); N is that of
    Lagrange, and extra P"""
    roots = [poly(a) for a in roots]
    P = product(z - a for a in roots)
    N = Poly()
    for a, s in zip(roots, squares):
        rest = [z - b for b in roots if b != a]
        N = N + (poly(s) - 1) / 4 * E * product(f.of(a, poly(1), 1) for f in rest) * product(rest)
    if infinity is not None:
        n = 2 * len(roots) - 2
        N = N + ((poly(infinity) / (4 if by == "lame" else 1) - 1) / 4 * E - N.coefficient(n)) * z**(n - len(roots)) * P
    numbers = [squared(s) for s in squares] + ([squared(infinity)] if infinity is not None else [])
    more = {"numbers": numbers, "factors": [str(z - a) for a in roots]} | more
    return leaf(N + poly(extra) * P, E * P * P, by, said=said, **more)


THREE = [Fraction(1, 4), Fraction(1, 9), Fraction(1, 25)]       # squares of 1/2, 1/3, 1/5: a finite group


def riemann():
    def over_e(E, given):
        return fuchsian("riemann", [0, 1, -2], [A**2, B**2, C**2], E=E, nonzero=given)
    yield "three places", over_e(poly(3), []), True
    yield "over z - 5", over_e(z - 5, []), False
    for given in (["A + 1"], []):
        yield "over A + 1", over_e(A + 1, given), bool(given)
    yield "infinity is a place, too", fuchsian("riemann", [0, 1, -2], THREE, extra=1), False
    yield "irregular at infinity", fuchsian("riemann", [0, 1], THREE[:2], THREE[2], extra=z), False
    yield "degree 1", fuchsian("riemann", [0, 1], THREE[:2], 1), True
    yield "three places and infinity", fuchsian("riemann", [0, 1, -2], THREE, THREE[2]), False
    yield "one place", fuchsian("riemann", [0], [C**2], C**2, factors=["z"]), False
    yield "another square at infinity", fuchsian("riemann", [0, 1], [A**2, B**2], C**2, numbers=[
        squared(A**2), squared(B**2), squared((C + 1)**2)]), False
    for numbers in THREE[:2], [*THREE, THREE[2]], []:
        yield f"{len(numbers)} numbers", fuchsian("riemann", [0, 1, -2], THREE, numbers=list(map(squared, numbers))), False
    # the two places at the roots of P; 0 is the square there, C^2 at infinity
    for P, given, good in (z * z - A, ["A"], True), (z * z - A, [], False), (4 * A * z * z - B**2, ["A", "B"], True), \
            (4 * A * z * z - B**2, ["A*B"], False), (A * z * z - 2 * z, ["A"], True), (A * z * z - 2 * z, [], False), \
            (2 * z * z - 2, [], True):
        slope = P.diff()
        lead = P.coefficient(2)
        N = -(slope * slope) + (C**2 + 3) * lead * P                        # E = 4: 4 N = -4 P'^2 at the roots
        for n in 0, 1:
            yield f"at the roots of {P}, {given}", leaf(N, 4 * P * P, "riemann", [squared(n), squared(C**2)], factors=[str(P)],
                                                        nonzero=given), good and n == 0
        yield "three numbers for two", leaf(N, 4 * P * P, "riemann", [squared(0), squared(1), squared(C**2)], factors=[str(P)],
                                            nonzero=given), False


def verdicts_of_riemann():
    def three(said, *numbers, **more):
        return fuchsian("riemann", [0, 1, -2], [poly(x)**2 for x in numbers], said=said, **more)
    third, fifth = Fraction(1, 3), Fraction(1, 5)
    for numbers, right in (((HALF, third, fifth), "where"), ((Fraction(1, 60), third, fifth), "where"),
                           ((Fraction(1, 61), third, fifth), "no"), ((1, third, fifth), "no"), ((2, third, fifth), "no"),
                           ((HALF, 3 * HALF, fifth), "yes"), ((HALF, 3 * HALF, Fraction(1, 61)), "yes"),
                           ((HALF, 2, fifth), "no"), ((third, third, third), "yes"), ((third, 2 * third, 2), "yes"),
                           ((third, third, 5 * third), "yes"), ((third, 5 * third, third), "yes"),
                           ((5 * third, third, third), "yes"), ((third, third, 2 * third), "where")):
        for said in "yes", "no", "where":
            yield f"differences {numbers}: {said}", three(said, *numbers), said in (right, "where")
    # a place with monodromy 1 or -1: what is left is generated by one matrix
    for n, other, right in ((2, A + 1, "yes"), (2, A - 1, "yes"), (2, 1 - A, "yes"), (2, A, "where"), (2, A + 2, "where"),
                            (2, A + HALF, "where"), (2, 2 * A, "where"), (2, B, "where"), (3, A, "yes"), (3, A + 2, "yes"),
                            (3, A + 1, "where"), (3, A + 3, "where"), (3, A + 4, "where"), (5, -4 - A, "yes"),
                            (5, 6 - A, "where"), (1, A, "yes"), (1, A + 1, "where"), (1, A + 2, "where"), (0, A, "where"),
                            (0, A + 1, "where"), (5 * HALF, A + 3 * HALF, "where"), (5 * HALF, A + HALF, "where")):
        for said in "yes", "no", "where":
            for turn in range(3):
                x = [poly(n), poly(A), poly(other)]
                x = x[turn:] + x[:turn]
                yield f"{n} at one place, A and {other}, {turn}: {said}", three(said, *x, numbers=list(map(root, x))), said in (right, "where")
    for x in itertools.permutations((2, 0, A)):                     # 1 is between -1 and 1, and not the root of A^2
        yield f"differences {', '.join(map(str, x))}, without a root", three("yes", *x), False
    numbers = [root(A), root(B), root(C)]
    odd = [(A + a * B + b * C - 1) / 2 for a in (1, -1) for b in (1, -1)]
    none = [*odd, A - HALF, B - HALF, 60 * C]
    for left in range(len(none) + 1):
        rest = [over(f) for i, f in enumerate(none) if i != left]
        yield f"no without {left}", three("no", A, B, C, numbers=numbers, given=[(f, False) for f in rest], known=[
            shown(f, False, 1, i) for i, f in enumerate(rest)]), left == len(none)
    for i, f in enumerate(odd):
        for rational in ["A", "B"], ["A", "C"], ["B"], []:
            yield f"odd sum {i} of rational {rational}", three("yes", A, B, C, numbers=numbers, rational=rational, given=[
                (over(f), True)], known=[shown(over(f), True)]), len(rational) == 2
    halves = [over(A - HALF), over(B - HALF)]
    for some in numbers, [root(A), root(B), squared(C**2)]:
        for two in halves, halves[:1]:
            yield f"{len(two)} halves", three("yes", A, B, C, numbers=some, given=[(f, True) for f in two], known=[
                shown(f, True, 1, i) for i, f in enumerate(two)]), len(two) == 2


def lame():
    quarters = [Fraction(1, 4)] * 3

    def of(x, said="where", kind=squared, **more):
        square = poly(x)**2
        numbers = [*map(squared, quarters), root(x) if kind is root else squared(square)]
        return fuchsian("lame", [0, 1, -2], quarters, square, said=said, **({"numbers": numbers} | more))
    yield "with B", fuchsian("lame", [0, 1, -2], quarters, A**2, extra=B), True
    yield "degree 5", fuchsian("lame", [0, 1, -2], quarters, A**2, extra=z**2 - z), False
    yield "degree 3", fuchsian("lame", [0, 1, -2], quarters, 4, extra=1), True
    yield "a difference of 1/3", fuchsian("lame", [0, 1, -2], [Fraction(1, 9), *quarters[1:]], A**2), False
    yield "a difference of A", fuchsian("lame", [0, 1, -2], [A**2, *quarters[1:]], A**2), False
    yield "two places", fuchsian("lame", [0, 1], quarters[1:], A**2), False
    for last in [squared((A + 1)**2)], [squared(A**2)] * 2, []:
        yield f"other numbers {len(last)}", fuchsian("lame", [0, 1, -2], quarters, A**2, numbers=[*map(squared, quarters), *last]), False
    for x, right in ((1, "yes"), (3, "yes"), (2, "where"), (4, "where"), (0, "where"), (HALF, "where"), (3 * HALF, "where"),
                     (Fraction(2, 3), "where"), (Fraction(4, 3), "where"), (Fraction(2, 5), "where"), (Fraction(4, 5), "where"),
                     (Fraction(1, 3), "no"), (Fraction(1, 5), "no"), (Fraction(1, 4), "no"), (Fraction(1, 6), "no"),
                     (Fraction(2, 7), "no"), (Fraction(1, 15), "no"), (Fraction(3, 10), "no")):
        for said in "yes", "no", "where":
            yield f"2n + 1 = {x}: {said}", of(x, said), said in (right, "where")
    for said in "yes", "no", "where":
        yield f"2n + 1 is irrational: {said}", fuchsian("lame", [0, 1, -2], quarters, 2, said=said), said != "yes"
        yield f"2n + 1 = A: {said}", of(A, said, root), said == "where"
        for k in 30, 29, 31, 60, 15:
            known = {"given": [(over(k * A), False)], "known": [shown(over(k * A), False)]}
            yield f"{k} (2n + 1) is not an integer: {said}", of(A, said, root, **known), said == "where" or said == "no" and k == 30
        integer = {"given": [(over((A - 1) / 2), True)], "known": [shown(over((A - 1) / 2), True)]}
        yield f"n is an integer: {said}", of(A, said, root, **integer), said != "no"


def certificates():
    for rule in changes, confluent, verdicts_of_whittaker, riemann, verdicts_of_riemann, lame:
        yield from rule()
