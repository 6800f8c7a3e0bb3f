"""Properties of group_rules.py, equation.py and places.py of the Python checker, functions of its modules (sys.modules) that are
True: what a certificate says of one singular point (local_exponents.md 1)."""
from fractions import Fraction as F

from lowest import refused

P = 101


def poly(m, *c):
    """Over Q, ascending"""
    m["exact"].K.m, m["exact"].K.d, m["exact"].K.s = [0, 1], 1, 1
    f, n = list(map(F, c)), 1
    for x in f:
        n *= x.denominator
    return m["exact"].Poly([int(x * n) for x in f], n)


def checker(m, num, den, kind="Checker"):
    m["equation"].Equation.spent = 0
    return getattr(m["group_rules"], kind)(poly(m, *num), poly(m, *den))


def accepted(m, f):
    found = []
    return None if refused(m, lambda: found.append(f())) else found[0]


def logarithms(m):
    """Delta is a natural number below p"""
    def seen(square, tail, delta, p=P):
        x = checker(m, [F(square - 1, 4), *tail], (0, 0, 1))
        return not refused(m, lambda: x.need_log({"p": p, "a": 0}, 0, delta))
    return (seen(4, (1,), F(2)) and seen(4, (0, 1), F(2)) and not seen(4, (0, 0, 1), F(2)) and seen(9, (0, 0, 1), F(3))
            and not seen(9, (0, 0, 0, 1), F(3)) and not seen(4, (1,), None) and not seen(F(1, 4), (1,), F(1, 2)) and not seen(0, (1,), F(0))
            and not seen(4, (1,), F(3)) and not seen(4, (1,), F(-2)) and seen(25, (0, 0, 0, 0, 1), F(5), 7)
            and not seen(25, (0, 0, 0, 0, 1), F(5), 5) and not seen(49, (0,) * 6 + (1,), F(7), 5))


def products(m):
    """All places together: their product, and the square of each difference (1.8)"""
    def local(squares, given, extra=(), num=None):
        """Poles 0, 1, 2, ... of order 2 with these squares"""
        m["equation"].Equation.spent = 0
        q = [poly(m, -c, 1) for c in range(len(squares))]
        den, total = m["exact"].product(f * f for f in q), poly(m)
        for f, square in zip(q, squares):
            rest = m["exact"].division(den, f * f)[0]
            total = total + rest * F(F(square) - 1, 4)
        x = m["group_rules"].Checker(total if num is None else poly(m, *num), den)
        rows = [{"q": f, "order": 2, "delta2": None if c is None else poly(m, c), "annihilator": None, "irrational": None, "log": None,
                 "eps2": None} for f, c in zip(q, given)]
        rows += [dict(rows[0] if rows else {}, q=f, order=k, delta2=None) for f, k in extra]
        d = {"places": rows, "prime": {"p": 1009, "a": 0}, "infinity": {"log": None, "eps2": None, "annihilator": None}}
        found = accepted(m, lambda: x.local(d))
        return found and [y.delta for y in found.finite]
    squares, roots = (4, 9, 16, 25, F(1, 4)), [2, 3, 4, 5, F(1, 2)]
    wrong = [[c + (i == j) for j, c in enumerate(squares[:n])] for n in (1, 2, 3, 4, 5) for i in range(n)]
    return (all(local(squares[:n], squares[:n]) == roots[:n] for n in (1, 2, 3, 4, 5))
            and not any(local(squares[:len(v)], v) for v in wrong)
            and local(squares[:3], (4, None, 16)) == [2, None, 4] and local(squares[:2], squares[:2], [(poly(m, 1), 3)]) is None
            and local(squares[:2], squares[:2], [(poly(m), 1)]) is None and local((4,), (4,), [(poly(m, 1), 1)]) is None)


SILENT = {"delta2": None, "annihilator": None, "irrational": None, "log": None, "eps2": None}


def at_a_place(m):
    """What is said of one place: irrational, logarithms, eps^2"""
    def place(num, den, order, stub=False, **more):
        x = checker(m, num, den)
        if stub:
            x.need_log = lambda *given: None
        d = SILENT | more
        v = accepted(m, lambda: x.place(d, poly(m, 0, 1), order, d["delta2"]))
        return v and (v.irrational, v.logs, v.real)

    def irrational(p):
        return {"irrational": {"p": p, "a": 0}}

    def log(*roots):
        return {"log": {"p": 7, "a": 0, "roots": list(roots)}}
    z2, z4, four = (0, 0, 1), (0, 0, 0, 0, 1), poly(m, 4)
    root2, natural = ((F(1, 4), 1), z2, 2), ((F(3, 4), 1), z2, 2)
    return (place(*root2, **irrational(5)) == (True, 0, None) and place(*root2, **irrational(7)) is None
            and place(*natural, **irrational(5)) is None and place(*natural, delta2=four, **irrational(5)) is None
            # a simple pole of a polynomial whose second derivative there is 2
            and all(place((c, 1), (0, 1, 1), 1, **irrational(p)) is None for c in (1, 2, 3) for p in (3, 5, 7))
            and place(*natural, delta2=four, **log(0)) == (False, 1, 2) and place(*natural, delta2=four, **log()) is None
            and place(*natural, delta2=four, **log(0, 0)) is None and place(*natural, True, delta2=four, **log(7)) is None
            and place(*natural, True, delta2=four, **log(0)) == (False, 1, 2) and place((1, 1), (0, 1), 1, True, **log(0)) is None
            and place((1, 2), z4, 4, eps2=four) == (False, 0, 2) and place((1, 2), z4, 4, eps2=poly(m, 5)) is None
            and place((1, 2), z4, 4, eps2=poly(m, 4, 1)) is None and place(*natural, eps2=poly(m, 3)) is None
            and place((1,), (0, *z4), 5, eps2=poly(m)) is None and place((1,), (0, 0, 0, 1), 3, eps2=poly(m)) is None)


def at_infinity(m):
    def infinity(num, den, stub=False, **more):
        x = checker(m, num, den)
        if stub:
            x.need_log = lambda *given: None
        v = accepted(m, lambda: x.infinity({"eps2": None, "log": None, "annihilator": None} | more))
        return v and (v.order, v.delta, v.logs, v.real)
    log, wrong = {"log": {"p": 7, "a": 0, "roots": None}}, {"log": {"p": 7, "a": 0, "roots": [1]}}
    z = (0, 1)
    return (infinity((), (1,)) == infinity((1,), (0, 0, 0, 0, 1)) == (0, 1, 0, None) and infinity((1,), (0, 0, 0, 1)) == (1, 1, 1, None)
            and infinity((6,), (0, 0, 1)) == (2, 5, 0, 5) and infinity((6,), (0, 0, 1), True, **log) == (2, 5, 1, 5)
            and infinity((6,), (0, 0, 1), True, **wrong) is None and infinity((1,), (0, 0, 0, 1), True, **log) is None
            and infinity((1,), (0, 1), True, **log) is None and infinity((), (1,), True, **log) is None
            and infinity((2, 1), z, eps2=poly(m, 4)) == (4, None, 0, 2) and infinity((2, 1), z, eps2=poly(m, 3)) is None
            and infinity((6,), (0, 0, 1), eps2=poly(m, 24)) is None and infinity((0, 1), (1,), eps2=poly(m)) is None
            and infinity((1,), z, eps2=poly(m)) is None)


def expansions(m):
    """t^order r modulo p, whose order does not change there, and the series of omega"""
    E, x = m["equation"].Equation, checker(m, (1,), (1,))

    def of(num, den, root, order, p=7):
        return accepted(m, lambda: E.expansion(p, list(num), list(den), root, order))

    def riccati(n, d, order, s0, terms, p=7):
        found = []
        return "refused" if refused(m, lambda: found.append(x.riccati(list(n), list(d), order, s0, terms, p))) else found[0]
    big = next(p for p in range(2**62 + 1, 2**62 + 200, 2) if m["modular"].is_prime(p))
    small = next(p for p in range(2**62 - 1, 2**62 - 200, -2) if m["modular"].is_prime(p))

    def good(p, a=0):
        return not refused(m, lambda: x.good({"p": p, "a": a}))
    return (of((1, 2), (0, 0, 3), None, 3) == ([2, 1], [3, 0, 0]) and of((1, 2), (0, 0, 3), None, 2) is None
            and of((1,), (0, 0, 3), None, 3) is None and of((1, 2), (0, 0, 3), 0, 2) == ([1, 2], [3])
            and of((0, 2), (0, 0, 3), 0, 2) is None
            and of((1, 2), (0, 0, 3), 0, 1) is None and of((1, 2), (0, 0, 3), 0, 3) is None and of((), (0, 0, 3), 0, 2) is None
            and of((3, 1), (2, 4, 1, 1), 5, 1) is None and of((3, 2), (2, 3, 1), 5, 1) == ([6, 2], [6, 1])
            # s0^2 - s0 = r_0, and 2 s0 + i - 1 = 0 at a resonance
            and riccati((6,), (1,), 2, 3, 2) == [3, 0] and riccati((6,), (1,), 2, 3, 3) == "refused"
            and riccati((6,), (1,), 2, 5, 3) == [5, 0, 0] and riccati((6,), (1,), 2, 4, 3) == "refused"
            and riccati((6,), (1,), 2, 2, 1) == "refused" and riccati((2, 0, 0, 1), (1,), 2, 6, 4) is None
            and riccati((2,), (1,), 2, 6, 4) == "refused" and riccati(*unreduced(m)) == "refused"
            and riccati((1, 1), (1,), 4, 1, 3, 5) == [1, 4, 4] and riccati((1, 1), (1,), 4, 4, 3, 5) != "refused"
            and good(small) and not good(big) and not good(2) and good(3) and not good(9) and not good(7, 7) and not good(7, 1))


def unreduced(m):
    """A resonance where r_i is the sum of the products modulo p, and not as a number: s0 = -1 and i = 3"""
    p, s0 = 7, 6
    S1 = 3 * pow(2 * s0, -1, p) % p
    S2 = (0 - S1 * S1) * pow(2 * s0 + 1, -1, p) % p
    return (2, 3, 0, 2 * S1 * S2 % p), (1,), 2, s0, 4


def units(m):
    """v/sqrt(F0), and holomorphic differentials"""
    Invariant = m["equation"].Invariant

    def of(p, *factors):
        return Invariant("invariant", m=2, p=poly(m, *p), factors=[(poly(m, -c, 1), F(e)) for c, e in factors])
    z, y = poly(m, 0, 1), poly(m, -1, 1)
    a, b = of((5,), (0, "7/2"), (1, -3)).fraction()
    c, d = of((1, 1), (0, "-1/2"), (1, 0)).fraction()
    return (a == z**3 * 5 and b == y**3 and c == poly(m, 1, 1) and d == z
            and of((1,), (0, "1/2"), (1, "1/2"), (2, "1/2")).holomorphic_quotient
            and not of((1,), (0, "1/2"), (1, "1/2")).holomorphic_quotient
            and not of((1,), (0, "1"), (1, "1/2")).holomorphic_quotient and not of((1,), (0, "3/2")).holomorphic_quotient
            and not of((1, 1), (0, "1/2"), (1, "1/2"), (2, "1/2")).holomorphic_quotient)


def of_places(m):
    """Lines that are exchanged, and what D_1 and the branch places need"""
    places = m["places"]

    def place(order, delta=None, n=1, q=None, **more):
        x = places.Place(q, n, order)
        vars(x).update({"delta": x.delta if delta is None else F(delta)} | more)
        return x
    exchanges = [place(*v, irrational=i).exchanges_lines() for *v, i in (
        (2, "1/2", False), (2, "1/3", False), (2, None, False), (2, None, True), (1, None, False), (4, None, False), (3, None, False), (0,
            None, False))]
    z, y = poly(m, 0, 1), poly(m, -1, 1)
    half, third = place(2, "1/2", q=z), place(2, "1/3", q=y)

    def denominator(branch, *finite, infinity="3/5"):
        v = m["equation"].Invariant("invariant", branch=branch)
        return accepted(m, lambda: places.Local(list(finite), place(2, infinity)).residue_denominator(v))
    return (exchanges == [True, False, True, False, False, False, True, False]
            and refused(m, lambda: place(2, "1/2").lowest_exponent()) and place(2, "1/2", real=F(1, 2)).lowest_exponent() == F(1, 4)
            and denominator(z, half, third) == 3 and denominator(z * y, half, third) == 5 and denominator(z, third) is None
            and denominator(z * y, half) is None and denominator(m["exact"].ONE, half, third) == 30)


def properties():
    """(name, function, True)"""
    return [(f"local_rules.{f.__name__}", f, True) for f in (logarithms, products, at_a_place, at_infinity, expansions, units,
                                                             of_places)]
