"""Leaves of certificates over strata (kovacic-strata/1), each with all the conditions that it needs and with one of them
missing.  The poles are 0, 1, ..., or as they are named; Delta^2 at a place is a number or a polynomial in A and B.  Which
polynomials have to be known not to be 0, or to be positive, is read off from the Python checker once; the C++ checker judges
what is made of it, too (python_test.py)."""
import json
import random
from fractions import Fraction as F
from itertools import combinations
from math import lcm

import stratum
from kovacic_verify import Rejected, check
from several_variables import mplus, mtimes, text
from statement import polynomial

A, B = {(0, 1, 0): F(1)}, {(0, 0, 1): F(1)}


def poly(x):
    return x if isinstance(x, dict) else {(0, 0, 0): F(x)} if x else {}


def degree(f):
    return max(e[0] for e in f)


def scaled(f, k):
    return {e: c * F(k) for e, c in f.items() if k}


def over(f):
    """f times the least natural number that makes its coefficients integers, and that number"""
    n = lcm(1, *(c.denominator for c in f.values()))
    return {e: int(c * n) for e, c in f.items()}, n


def root(c):
    """Of the pole c: q = d z - n for c = n/d"""
    return mplus({(1, 0, 0): F(c).denominator}, poly(-F(c).numerator))


def power(f, k):
    g = poly(1)
    for _ in range(k):
        g = mtimes(g, f)
    return g


class Fraction:
    """num/(content prod q^k) for the poles {c: k}"""

    def __init__(self, num, orders):
        den = poly(1)
        for c, k in orders.items():
            den = mtimes(den, power(root(c), k))
        self.orders, (self.num, self.content) = orders, over(num)
        self.den = {e: int(c * self.content) for e, c in den.items()}

    @classmethod
    def sum(cls, terms, whole=()):
        """Of a polynomial in z and terms {(c, i): coefficient of 1/(z - c)^i}"""
        orders = {}
        for c, i in terms:
            orders[c] = max(i, orders.get(c, 0))
        num = {}
        for i, x in enumerate(whole):
            for c, k in orders.items():
                x = mtimes(poly(x), power(root(c), k))
            num = mplus(num, mtimes(poly(x), {(i, 0, 0): F(1)}))
        for (c, i), x in terms.items():
            x = scaled(poly(x), F(c).denominator**i)
            for d, k in orders.items():
                x = mtimes(x, power(root(d), k - i if d == c else k))
            num = mplus(num, x)
        return cls(num, orders)

    def places(self, together):
        """q and order of the places; `together`: poles that are one place"""
        for c, k in self.orders.items():
            row = next((row for row in together if c in row), [c])
            if c == row[0]:
                q = mtimes(root(c), root(row[1])) if len(row) > 1 else root(c)
                yield {"q": text({e: int(x) for e, x in q.items()}), "order": str(k)}


def regular(squares, infinity, residues=()):
    """r with Delta^2 = squares at 0, 1, ... and at infinity, and residues at 2, 3, ..."""
    squares, rest = [poly(x) for x in squares], [poly(x) for x in residues]
    h = scaled(mplus(poly(infinity), poly(1), -1), F(1, 4))
    for x in squares:
        h = mplus(h, scaled(mplus(x, poly(1), -1), F(1, 4)), -1)
    for c, x in enumerate(rest, 2):
        h = mplus(h, scaled(x, c), -1)
    first = scaled(h, -1)
    for x in rest:
        first = mplus(first, x, -1)
    terms = {(c, 2): scaled(mplus(x, poly(1), -1), F(1, 4)) for c, x in enumerate(squares)}
    return terms | {(c, 1): x for c, x in enumerate([first, h, *rest])}


def place(square, **more):
    """What is said of a place: chi, and a bound or a log"""
    if square is None:
        return more
    f, n = over(poly(square))
    return {"chi": [text({e: -c for e, c in f.items()}), str(n)]} | more


def certificate(by, r, places, infinity=None, together=(), **more):
    parameters = [x for i, x in ((1, "A"), (2, "B")) if any(e[i] for e in {**r.num, **r.den})]
    leaf = {"node": "leaf", "abelian": "no", "by": by, "content": str(r.content), "infinity": infinity or {},
            "places": [p | q for p, q in zip(r.places(together), places, strict=True)]} | more
    return {"format": "kovacic-strata/1", "variable": "z", "parameters": parameters, "real": parameters, "assumptions": [], "generic": [],
            "r": {"num": text(r.num), "den": text(r.den)}, "claim": {"abelian": False}, "tree": leaf}


def needed(top):
    """The conditions on the parameters that a leaf asks for"""
    found, names = {}, [top["variable"], *top["parameters"]]
    true = stratum.Stratum.is_unit, stratum.Stratum.is_positive

    def record(sign, f):
        if f.constant() is not None:
            return f.constant() > 0 or sign == "nonzero" and bool(f)
        found[polynomial(f, names), sign] = {"p": polynomial(f, names), "sign": sign}
        return True
    stratum.Stratum.is_unit, stratum.Stratum.is_positive = (lambda s, f: record("nonzero", f)), (lambda s, f: record("positive", f))
    try:
        check(json.dumps(top))
    except Rejected as why:
        raise ValueError(f"not a leaf: {why}: {json.dumps(top)}") from None
    finally:
        stratum.Stratum.is_unit, stratum.Stratum.is_positive = true
    return list(found.values())


def accepted(top):
    try:
        return bool(check(json.dumps(top)))
    except Rejected:
        return False


def with_conditions(name, top, most=3):
    """The leaf with all that it needs, and without one of it; of long lists only some"""
    conditions = needed(top)
    yield name, json.dumps(top | {"assumptions": conditions}), True
    for i, x in enumerate(conditions):
        if len(conditions) > 12 and i % most:
            continue
        fewer = top | {"assumptions": conditions[:i] + conditions[i + 1:]}
        if not accepted(fewer):
            yield f"{name}, but {x['p']} is not {x['sign']}", json.dumps(fewer), False


def with_minors(by, r, places, m, D, **more):
    """The rows of the first minor that is not 0"""
    for rows in combinations(range(14), D + 1):
        top = certificate(by, r, places, absent=[{"m": str(m), "minors": [{"rows": list(map(str, rows)), "times": "1"}]}], **more)
        try:
            needed(top)
            return top
        except ValueError:
            continue
    raise ValueError("no minor")


# ---- one open place

def one_open():
    """No torus: the other differences are rational; with a bound of Delta^2"""
    for c, d, bound in (("1/3", "1/3", "7/3"), ("1/2", "1/3", "2"), ("1/4", "2/3", "3/2"), ("2/3", "1/3", "3/4"), ("1/7", "1/3", "1"),
                        ("3/5", "2/5", "3")):
        c, d = F(c)**2, F(d)**2
        for where in (0, 1, None):
            squares, infinity = ([A, c], d) if where == 0 else ([d, A], c) if where == 1 else ([c, d], A)
            r = Fraction.sum(regular(squares, infinity))
            yield f"open at {where}, {c}, {d}", certificate(
                "one-open", r, [place(x, **({"bound": bound} if x is A else {})) for x in squares],
                place(infinity, **({"bound": bound} if infinity is A else {})))
    # two roots of one place, and a residue that makes infinity an ordinary point
    terms = {(1, 2): scaled(mplus(A, poly(1), -1), F(1, 4)), (-1, 2): scaled(mplus(A, poly(1), -1), F(1, 4)), (0, 2): F(-2, 9)}
    for inf, third in ((F(1, 9), 0), (F(4, 9), 1)):
        h = mplus(poly((inf - 1) / 4 + F(2, 9)), scaled(mplus(A, poly(1), -1), F(1, 2)), -1)        # at 1 and -1
        residues = {(x, 1): mplus(scaled(h, F(x, 2)), poly(third)) for x in (1, -1)}
        r = Fraction.sum(terms | residues | {(0, 1): -2 * third})
        yield f"two roots, {inf}", certificate("one-open", r, [place(A, bound="5/4"), place(F(1, 9))], place(inf), together=[(1, -1)])


def one_open_torus():
    bound, irrational = {"bound": "13/4"}, {"irrational": "constant"}
    for d in ("1/3", "1/2", "2/5"):
        for squares in ([A, 2], [2, A]):
            r = Fraction.sum(regular(squares, F(d)**2))
            yield f"irrational, {squares[0]}, {d}", certificate(
                "one-open", r, [place(x, **(bound if x is A else irrational)) for x in squares], place(F(d)**2))
    yield "irrational at infinity", certificate("one-open", Fraction.sum(regular([A, F(1, 4)], 3)), [place(A, **bound), place(F(1, 4))],
                                                place(3, **irrational))
    yield "open at infinity", certificate("one-open", Fraction.sum(regular([F(1, 9), 3], A)), [place(F(1, 9)), place(3, **irrational)],
                                          place(A, **bound))
    for k, more in ((3, {}), (4, {(1, 3): F(2)}), (5, {(1, 3): F(1)}), (6, {(1, 5): F(1)})):
        r = Fraction.sum({(0, 2): regular([A, 1], 1)[0, 2], (1, k): F(3), (1, 1): F(1)} | more)
        yield f"irregular of order {k}, infinity of order 3", certificate("one-open", r, [place(A, **bound), {}])
        r = Fraction.sum(regular([A, 1], F(1, 9)) | {(1, k): F(3), **more})
        yield f"irregular of order {k}", certificate("one-open", r, [place(A, **bound), {}], place(F(1, 9)))
    for whole in ([1], [0, 1], [2, 0, 1], [1, 1, 0, 1]):
        r = Fraction.sum({(0, 2): regular([A, 1], 1)[0, 2], (0, 1): F(2)}, whole)
        yield f"infinity of order {3 + len(whole)}", certificate("one-open", r, [place(A, **bound)])
        r = Fraction.sum(regular([A, F(1, 4)], 1) | {(1, 1): F(3)}, whole)
        yield f"infinity of order {3 + len(whole)}, Delta = 1/2", certificate("one-open", r, [place(A, **bound), place(F(1, 4))])
    r = Fraction.sum(regular([A, 2, F(1, 9)], 1, [F(1)]))
    yield "infinity of order 1: a logarithm", certificate("one-open", r, [place(A), place(2, **irrational), place(F(1, 9))])
    yield ordinary_infinity()


def ordinary_infinity():
    """The coefficient of z^-3 is 0, too: h = sum c rho for the residues rho, and sum c^2 rho is known."""
    squares = [A, poly(2), poly(F(1, 9))]
    double = [scaled(mplus(x, poly(1), -1), F(1, 4)) for x in squares]
    h = scaled(mplus(mplus(double[0], double[1]), double[2]), -1)
    second = scaled(mplus(mplus(double[1], scaled(double[2], 2)), scaled(h, F(1, 2))), -1)
    r = Fraction.sum({(c, 2): x for c, x in enumerate(double)} | {
        (0, 1): mplus(second, h, -1), (1, 1): mplus(h, second, -2), (2, 1): second})
    places = [place(A, bound="13/4"), place(2, irrational="constant"), place(F(1, 9))]
    return "infinity is ordinary", certificate("one-open", r, places)


def several_open():
    r, irrational = Fraction.sum(regular([A, B], 2)), {"irrational": "constant"}
    yield "two open places, a torus", certificate("open", r, [place(A, bound="9/4"), place(B, bound="2")], place(2, **irrational))
    r = Fraction.sum(regular([2, B], A))
    yield "open at infinity, a torus", certificate("open", r, [place(2, **irrational), place(B, bound="1/4")], place(A, bound="1/9"))
    d = F(1, 5)**2
    r = Fraction.sum(regular([A, d, B, d], d, [F(1), F(2)]))
    yield "two open places", certificate("open", r, [place(A, bound="9/4"), place(d), place(B, bound="1/5"), place(d)], place(d))
    r = Fraction.sum(regular([d, d, B, d], A, [F(1), F(2)]))
    yield "open at infinity", certificate("open", r, [place(d), place(d), place(B, bound="0"), place(d)], place(A, bound="2"))


def torus():
    """With A as the residue of an equation of Bessel's type, and minors of as many rows as there are unknowns"""
    for square, D in ((F(1), 0), (F(4), 2), (F(25, 4), 3), (F(9), 4)):
        yield f"Delta^2 = {square}", with_minors("torus", Fraction.sum({(0, 2): (square - 1) / 4, (0, 1): A}, [1]), [place(square)], 4, D)


def logarithms():
    """The defect at a pole and at infinity, with a torus and with an irreducible group"""
    c = F(2, 3)
    for N in (1, 2, 3, 4):
        square, log = poly(N * N), {"log": True}
        double = scaled(mplus(square, poly(1), -1), F(1, 4))
        for whole in ([1], [0, 2]):
            r = Fraction.sum({(c, 2): double, (c, 1): A, (0, 1 if N % 2 else 2): F(3, 4)}, whole)
            yield f"Delta = {N}, infinity of order {3 + len(whole)}", certificate("torus-log", r, [place(square, **log), {} if N % 2 else place(4)])
        for k, more in ((3, 0), (4, 1)):
            num = mplus(scaled(poly(N * N - 1), F(9, 4) * c**k), mtimes(A, root(c)))
            r = Fraction(num if N > 1 or not more else mtimes(num, mplus(A, {(1, 0, 0): F(1)})), {0: k, c: 2})
            if N > 1:
                yield f"Delta = {N}, a pole of order {k}", certificate("torus-log", r, [{}, place(square, **log)])
        zero = mplus(mplus(double, poly(F(-1, 4))), A, -1)
        r = Fraction.sum({(0, 2): zero, (0, 3): F(1), (1, 2): F(1, 4), (1, 1): A, (0, 1): scaled(A, -1)})
        if N > 1:
            yield f"Delta = {N} at infinity", certificate("torus-log", r, [{}, place(2, irrational="constant")], place(square, **log))


SMALL = [F(a, b) for a, b in ((1, 2), (1, 2), (1, 3), (2, 3), (1, 4), (3, 4), (1, 5), (1, 6), (1, 1), (3, 2), (4, 3))]


def rational():
    """Numbers only, and simple poles where Delta = 1: whether there is a line or an invariant is seen from the exponents."""
    rng = random.Random(5)
    for _ in range(60):
        deltas = [rng.choice(SMALL) for _ in range(rng.choice((3, 4, 4, 5)))]
        residues = [F(rng.choice((-3, -2, 1, 2, 3))) for _ in deltas[3:]]
        terms = {k: x for k, x in regular([d * d for d in deltas[:-1]], deltas[-1]**2, residues).items() if x}
        r = Fraction.sum(dict(sorted(terms.items())))
        order = 4 - degree(r.den) + degree(r.num)
        yield f"{', '.join(map(str, deltas))}, {residues}", certificate(
            "rational", r, [place(deltas[c]**2) if k == 2 else {} for c, k in r.orders.items()],
            place(deltas[-1]**2) if order == 2 else None)


def irreducible_log():
    """A simple pole, and D_1 < 0 by what is known of the real parts: 0 where Delta^2 < 0, the next of n/8 or n/2 above it"""
    negative, constant = {"irrational": "positive"}, {"irrational": "constant"}
    known = [(-3, negative), (2, constant), (F(9, 5), constant), (-2, constant),
             (F(1, 9), {}), (F(1, 4), {}), (A, {"bound": "1/5"}), (A, {"bound": "0"}), (A, {"bound": "9/4"}), (F(16, 9), {})]
    for i, (x, how) in enumerate(known):
        for y, more in (known[(i + 3) % len(known)], known[(i + 4) % len(known)]):
            for infinity, last in ((F(1, 9), {}), (-1, negative), (3, constant)):
                if (x is A) + (y is A) < 2:
                    terms = {k: z for k, z in regular([x, y, 1], infinity, [F(2)]).items() if z}
                    yield f"{x}, {y}, {infinity}", certificate("irreducible-log", Fraction.sum(terms), [place(x, **how), place(y, **more), {}],
                                                               place(infinity, **last))


def no_logarithms():
    """Delta = 1/2 is not a natural number, 41 too large for the format, and lines with j = 0 are not excluded."""
    for square, residue, right in ((F(1, 4), 1, False), (1600, 2, True), (1600, 1, False), (1681, 1, False)):
        r = Fraction.sum({(2, 2): F(square - 1) / 4, (2, 1): F(residue)}, [1])
        yield f"Delta^2 = {square}, {residue}", certificate("torus-log", r, [place(square, log=True)]), right
    for c, d, right in ((F(4, 3), F(2, 3), False), (F(1, 3), F(2, 3), True)):
        double, values = scaled(mplus(A, poly(1), -1), F(1, 4)), {F(a, b) for b in range(1, 13) for a in range(1, b + 1)}
        h = mplus(poly((d * d - 1) / 4 - (c * c - 1) / 4), scaled(double, 2), -1)
        terms = {(1, 2): double, (-1, 2): double, (0, 2): (c * c - 1) / 4, (1, 1): scaled(h, F(1, 2)), (-1, 1): scaled(h, F(-1, 2))}
        top = certificate("one-open", Fraction.sum(terms), [place(A, bound="1"), place(c * c)], place(d * d), together=[(1, -1)])
        excluded = [{"p": f"{v.denominator**2}*A - {v.numerator**2}", "sign": "nonzero"} for v in sorted(values)]
        excluded += [{"p": x, "sign": y} for x, y in (("A", "nonzero"), ("4*A - 1", "nonzero"), ("1 - A", "positive"))]
        yield f"two open roots, {c} and {d}", top | {"assumptions": excluded}, right


def certificates():
    for family in (one_open, one_open_torus, several_open, torus, logarithms):
        for name, top in family():
            yield from ((f"{family.__name__}: {x}", y, right) for x, y, right in with_conditions(name, top))
    for name, top in rational():
        yield f"rational: {name}", json.dumps(top), accepted(top)
    for name, top in irreducible_log():
        top |= {"assumptions": [{"p": p, "sign": "positive"} for p in ("1 - 5*A", "9 - 4*A", "-A")]} if top["parameters"] else {}
        yield f"irreducible_log: {name}", json.dumps(top), accepted(top)
    for name, top, right in no_logarithms():
        yield f"no_logarithms: {name}", json.dumps(top), right
