"""Properties of group_rules.py of the Python checker, functions of its modules (sys.modules) that are True: series, torsion functions
and good reduction modulo a prime (riccati_one_place.md, dihedral_torsion.md)."""
from fractions import Fraction as F
from types import SimpleNamespace

from local_rules import accepted, checker, poly
from lowest import refused


def series(m):
    """No exponential solution: r = (2 + z + ...)/z^2, Delta = 3, with s0 = 2 and -1; modulo 7 and to few terms"""
    def accepts(D1=-2, place=0, num=(2, 1), den=(0, 0, 1), orders=(2,), infinity=3, stub=False, **more):
        x = checker(m, num, den)
        if stub:
            x.expansion = lambda p, n, d, root, order: ([2, 1], [1])
        finite = [m["places"].Place(poly(m, -c, 1), 1, k) for c, k in enumerate(orders)]
        local = SimpleNamespace(finite=finite, infinity=m["places"].Place(None, 1, infinity), degree_bound_1=lambda: D1)
        d = {"p": 7, "a": 0, "root": 0, "terms": 2, "delta": 3, "place": place, "by": "series", "lines": two} | more
        return not refused(m, lambda: x.series(d, local))

    def lines(*rows):
        return [{"length": n, "approximant": list(c)} for n, c in rows]
    one, two, long = (0, [1]), lines((0, [1]), (0, [1])), lines((1, [1]), (1, [1]))
    far = ((1, 2), (0, 0, 1))
    # L = D_1 + 2; there is an entry beyond `length` at 0, or 1
    return (accepts() and not accepts(-1) and accepts(lines=lines(one, (1, [1]))) and accepts(lines=long) and not accepts(-1, lines=long)
            and not accepts(lines=lines(one)) and not accepts(lines=two + two[:1]) and not accepts(terms=1)
            and not accepts(terms=1, lines=two, D1=-9)
            and accepts(delta=4) and not accepts(delta=10) and not accepts(delta=7, num=(F(-1, 4), 1), lines=lines(one))
            and accepts(delta=0, num=(F(-1, 4), 1), lines=lines(one)) and not accepts(delta=2) and not accepts(lines=lines(one, (0, [8])))
            and not accepts(lines=lines(one, (0, [1, 1]))) and accepts(lines=lines(one, (1, [1, 1])))
            and not accepts(lines=lines(one, (1, [1, 7])))
            # nothing beyond `length`
            and not accepts(-9, num=(2,), lines=long) and not accepts(num=(2,), lines=long) and accepts(num=(2,))
            and not accepts(-9, lines=lines((2, [1]), (2, [1]))) and accepts(-9, root=0) and not accepts(-9, root=7)
            and not accepts(-9, root=1)
            and not accepts(-9, stub=True, root=7) and accepts(-9, stub=True) and not accepts(-9, place=1) and not accepts(-9, place=-1)
            and accepts(-9, place=-1, orders=(2, 2)) is False
            and accepts(-9, place="infinity", num=far[0], den=far[1], delta=0, infinity=1, stub=True) is False
            and accepts(-9, place="infinity", num=(1, 0, 2), den=(0, 0, 0, 0, 1), infinity=2) and not accepts(
                -9, place="infinity", num=(1,), den=(0, 0, 0, 0, 1), delta=1, infinity=0, lines=two)
            and not accepts(-9, place="infinity", stub=True, infinity=0)
            and accepts(-9, place="infinity", stub=True, infinity=1, delta=1, lines=lines(one)))


def root_of(m, branch, p=(1,), factors=((1, "1/2"), (-1, "1/2")), square=1):
    """v = sqrt(z^2 - 1), w^2 = 1, or as is said"""
    return m["equation"].Invariant("invariant", m=2, p=poly(m, *p), factors=[(poly(m, -c, 1), F(e)) for c, e in factors],
                                   branch=poly(m, *branch), w_squared=poly(m, square))


CIRCLE = (-1, 0, 1)


def torsion(m):
    """h = z + sqrt(z^2 - 1) has h' = h/v, and h^n has n times that"""
    v = root_of(m, CIRCLE)

    def accepts(n, a, b, c=(1,), minimal=(), v=v, L=None):
        x = checker(m, (1,), (1,))
        x.need_not_a_power = lambda t, *given: m["certificate_format"].need(t["right"], "a power")
        local = L and SimpleNamespace(residue_denominator=lambda _: L)
        d = {"n": n, "a": poly(m, *a), "b": poly(m, *b), "den": poly(m, *c), "minimal": [dict(zip(("l", "right"), t)) for t in minimal]}
        f = accepted(m, lambda: x.torsion_function(d, local, v))
        return f is not None and (f.n, f.of) == (n, v)
    one, square = ((0, 1), (1,)), ((-1, 0, 2), (0, 2))
    cube = (0, -3, 0, 4), (-1, 0, 4)
    half = root_of(m, CIRCLE, square="1/4")
    return (accepts(1, *one) and accepts(1, (0, 2), (2,), (2,)) and not accepts(1, (0, 1), (-1,)) and not accepts(2, *one)
            and not accepts(-1, *one)
            and not accepts(1, *one, v=root_of(m, CIRCLE, square=4))
            and not accepts(1, *one, v=half) and accepts(2, (0, 1), (2,), v=half, minimal=[(2, True)])
            and not accepts(0, (1,), ()) and not accepts(0, (5,), (), (2,)) and not accepts(1, (), ()) and not accepts(1, *one, c=())
            and not accepts(-1, (0, 1), (-1,)) and not accepts(2, *square) and accepts(2, *square, minimal=[(2, True)])
            and not accepts(2, *square, minimal=[(2, False)]) and not accepts(2, *square, minimal=[(3, True)]) and accepts(2, *square, L=2)
            and not accepts(2, *square, L=3) and accepts(3, *cube, minimal=[(3, True)]) and not accepts(3, *cube, minimal=[(2, True)])
            and accepts(3, *cube, L=6) and not accepts(3, *cube, L=4))


def powers(m):
    """h takes values at two points whose quotient is not an l-th power: h = z + s, modulo 7 and 13"""
    v = root_of(m, CIRCLE)

    def shows(l, p, x1, s1, x2, s2, n=6, a=(0, 1), b=(1,), c=(1,), w=1, v=v, field=None, root=0):
        x, K = checker(m, (1,), (1,)), m["exact"].K
        f, g, h = poly(m, *a), poly(m, *b), poly(m, *c)
        K.m = field or K.m
        try:
            return not refused(m,
                               lambda: x.need_not_a_power({"p": p, "a": root, "l": l, "w": w, "x1": x1, "s1": s1, "x2": x2, "s2": s2}, n,
                                                          f, g, h, v))
        finally:
            K.m = [0, 1]
    def points(p):
        return [(x, s) for x in range(p) for s in range(1, p) if (s * s - x * x + 1) % p == 0]

    def quotient(l, p, one, two, h=lambda x, s: x + s):
        (a, b), e = (h(*one) % p, h(*two) % p), (p - 1) // l
        return bool(a and b) and pow(a, e, p) != pow(b, e, p)
    right = all(shows(l, p, *one, *two) == quotient(l, p, one, two) for l in (2, 3, 6) for p in (7,
        13) for one in points(p) for two in points(p)[:5])
    p = 13
    # (1 + z s)/(z + 3) is of no constant norm
    other = all(shows(3, p, *one, *two, a=(1,), b=(0, 1), c=(3, 1)) == quotient(
        3, p, one, two, lambda x, s: (1 + x * s) * pow(x + 3, -1, p) if x != 10 else 0) for one in points(p)[:4] for two in points(p))
    (x1, s1), (x2, s2) = next((one, two) for one in points(p) for two in points(p) if quotient(3, p, one, two) and quotient(2, p, one, two))
    six = dict(l=3, p=p, x1=x1, s1=s1, x2=x2, s2=s2)

    def changed(**more):
        return shows(**six | more)
    return (right and other and changed() and not changed(n=2) and not changed(n=4) and not changed(l=1) and not changed(l=5, n=5)
            and not changed(l=4, n=6) and changed(w=12) and not changed(w=2) and not changed(w=14) and not changed(s1=s1 + p)
            and not changed(x1=x1 + p)
            and not changed(s1=2) and not changed(x1=1, s1=0) and not changed(x1=1, s1=p) and not changed(c=(-x1, 1))
            and not changed(c=(-x2, 1))
            and not changed(a=(-s1,), b=(1,)) and not changed(a=(-s2,), b=(1,)) and changed(field=[-1, 1], root=1)
            and not changed(field=[-p, 0, 1], root=0)
            and changed(w=2, v=root_of(m, CIRCLE, square=4), b=("1/2",)) and not changed(w=2, v=root_of(m, CIRCLE, square=17 * 13), b=("1/2",))
            and changed(w=8, v=root_of(m, CIRCLE, square=f"{64 + 13}"), b=(5,))
            and not changed(w=0, v=root_of(m, CIRCLE, square=13)) and not changed(w=0, v=root_of(m, CIRCLE, square="1/13"))
            and squares_are_seen(m, shows))


def squares_are_seen(m, shows):
    """F0 = (z - 1)(z - 14) is a square modulo 13"""
    v, p = root_of(m, (14, -15, 1)), 13
    points = [(x, s) for x in range(p) for s in range(1, p) if (s * s - (x - 1) * (x - 14)) % p == 0]
    return bool(points) and not any(shows(3, p, *one, *two, v=v) for one in points for two in points[:5])


def reduction(m):
    """The curve s^2 = F0 stays smooth modulo p, and w^2 is a unit"""
    def bound(p, branch=(-1, 0, 0, 0, 0, 1), field=None, a=0, **more):
        v, x, K = root_of(m, branch, **more), checker(m, (1,), (1,)), m["exact"].K
        K.m = field or K.m
        try:
            f = accepted(m, lambda: x.good_reduction({"p": p, "a": a}, None, v))
        finally:
            K.m = [0, 1]
        return f and (f.p, f.bound, f.of is v)
    return (bound(7) == (7, (7 + 2 + 5)**2, True) and bound(11, (-1, 0, 1)) == (11, 1, True)
            and bound(13, (0, -1, 0, 1)) == (13, 13 + 2 + 7, True)
            and bound(5) is None and bound(7, square=7) is None and bound(7, square="1/14") is None and bound(7, square=49) is None
            and bound(7, square="75/2") is not None
            and bound(7, field=[-7, 0, 1]) is None and bound(7, field=[-2, 0, 1], a=3) == (7, 196, True)
            and bound(7, field=[-2, 0, 1], a=2) is None)


def properties():
    """(name, function, True)"""
    return [(f"modulo_primes.{f.__name__}", f, True) for f in (series, torsion, powers, reduction)]
