"""Properties of strata_leaves.py of the Python checker, functions of its modules (sys.modules) that are True: three places
(strata_certificates.md 7.9), beside an enumeration of n and k.  separated.py has such leaves as certificates."""
import random
from fractions import Fraction as F
from math import lcm
from types import SimpleNamespace

from lowest import refused
from places_of_leaves import state

POINTS = {3: {1: 1, 0: -3}, -2: {2: 1, 1: 1, 0: -2}, 1j: {2: 1, 0: 1}}      # values of a; what is 0 there, by the powers of a


def poly(m, f):
    return m["multivariate"].P((e * 2**m["multivariate"].FIELD, c) for e, c in f.items() if c)


def value(m, f, a):
    return sum(c * a**(k >> m["multivariate"].FIELD) for k, c in f.items())


def states(m):
    """{a: a state that knows what is right at this point}"""
    found = {}
    for a in POINTS:
        def is_real(f, a=a):
            return complex(value(m, f, a)).imag == 0
        s = found[a] = state(m)
        s.is_unit, s.is_real = (lambda f, a=a: value(m, f, a) != 0), is_real
        s.is_positive = lambda f, a=a, real=is_real: real(f) and complex(value(m, f, a)).real > 0
    m["multivariate"].Work.left = 10**9
    return found


def over(m, values, a, rng, kind):
    """Polynomials in a whose values have these ratios at one point; kind: numbers, all of them times a, or one with more than that"""
    n = lcm(*(F(v).denominator for v in values)) * rng.choice((1, -2))
    fs = [poly(m, {int(kind == "times a"): int(v * n)}) for v in values]
    if kind in (0, 1, 2):
        fs[kind] += poly(m, POINTS[a]) * n
    return fs


def squares(rng):
    """P = d1^2 + d2^2 and Q = d1^2 d2^2; conjugate complex numbers if P^2 < 4 Q"""
    x, y = F(rng.randint(0, 8), rng.choice((2, 2, 4))), F(rng.randint(1, 6), 2)
    if rng.random() < .5:                   # x + i y and x - i y
        return 2 * (x * x - y * y), (x * x + y * y)**2
    p, q = rng.choice(((x * x, y * y), (F(2), F(3)), (F(3), F(3)), (F(-3), F(-3)), (F(-3), F(3)), (-x - 1, -y), (-x, y)))
    return p + q, p * q


def is_sum(P, Q, k):
    """Is k = +-d1 +- d2?"""
    return (k * k - P)**2 == 4 * Q


def growth(m):
    """2 (d1^2 + d2^2) >= f Delta^2 - s for conjugate complex squares"""
    rng, at, seen = random.Random(3), states(m), set()
    for _ in range(400):
        a, s = rng.choice(list(at.items()))
        (P, Q), square = squares(rng), F(rng.randint(-8, 20), 3)
        f, shift = F(rng.randint(1, 9), rng.choice((2, 3, 4))), F(rng.randint(-9, 9), rng.choice((2, 3, 4)))
        if rng.random() < .3:
            shift = f * square - 2 * P      # as much, and not more
        c = over(m, [Q, -P, 1], a, rng, rng.choice(("numbers", "numbers", "times a", 0, 1)))
        e = over(m, [-square, 1], a, rng, rng.choice(("numbers", "times a", 0, 1)))
        d = f.denominator * shift.denominator
        left, right = (c[2] * e[0] * int(f * d) + c[2] * e[1] * int(shift * d)), c[1] * e[1] * (2 * d)
        expected = "refused"
        if f >= 1 and P * P < 4 * Q and all(map(s.is_real, c)):
            expected = left == right or 2 * P > f * square - shift and s.is_real(e[1])
        found = ["refused"]
        refused(m, lambda c=c, e=e, f=f, shift=shift, s=s: found.append(m["strata_leaves"].grows(s, c, e, f, shift)))
        seen.add(expected)
        if found[-1] != expected:
            return False
    return len(seen) == 3


def sums(m):
    """The k, if they are constant, or d1 and d2 imaginary"""
    rng, at, seen = random.Random(4), states(m), set()
    for _ in range(300):
        a, s = rng.choice(list(at.items()))
        (P, Q), kind = squares(rng), rng.choice(("numbers", "times a", 0, 1, 2))
        c = over(m, [Q, -P, 1], a, rng, kind)
        places = [SimpleNamespace(real=rng.choice((F(0), F(0), F(1, 2), None))) for _ in range(rng.choice((1, 2)))]
        expected = None
        if kind in ("numbers", "times a") or kind == 2 and P == Q == 0:
            expected = {k for k in range(40) if is_sum(P, Q, k)}
        elif all(x.real == 0 for x in places):
            expected = {0} if is_sum(P, Q, 0) else set()
        seen.add(expected if expected is None else len(expected))
        if m["strata_leaves"].possible_sums(s, places, c, lambda k, c=c: (c[2] * k**2 + c[1])**2 - c[2] * c[0] * 4) != expected:
            return False
    return seen == {None, 0, 1, 2}


def place(order=2, n=1, **more):
    return SimpleNamespace(**{"order": order, "n": n, "open": False, "delta": None, "chi": None, "b": None, "q": None, "real": None} | more)


def put(m, s, places, c=None, grows=True, possible=None, growth=None):
    """What `separated` says if its parts say this"""
    live, found = m["strata_leaves"], ["refused"]
    kept = {k: vars(live)[k] for k in ("pair", "grows", "possible_sums")}
    vars(live).update(pair=lambda *_: c or [m["multivariate"].ONE] * 3, grows=lambda *_, **__: grows, possible_sums=lambda *_: possible)
    try:
        refused(m, lambda: found.append(live.separated(s, places, growth)))
    finally:
        vars(live).update(kept)
    return found[-1]


def leaf(m):
    """Is every n and k excluded at one point?"""
    rng, at, seen = random.Random(5), states(m), set()
    for _ in range(1500):
        a, s = rng.choice(list(at.items()))
        (P, Q), delta = squares(rng), F(rng.randint(0, 7), rng.choice((1, 1, 1, 2)))
        c = over(m, [Q, -P, 1], a, rng, rng.choice(("numbers", "times a", 0, 1)))
        possible, f, shift = rng.choice((None, None, set(rng.sample(range(7), 4)))), F(rng.randint(4, 7), 4), F(rng.randint(-9, 60), 3)
        growth, b, is_open = rng.choice((None, {"factor": f, "shift": shift})), F(rng.randint(0, 13), 2), rng.random() < .7
        third = place(chi=over(m, [-delta**2, 1], a, rng, 0), b=b, open=True) if is_open else place(delta=delta)

        def is_left(n, k, growth=growth, possible=possible):
            grown = not growth or k > 0 and k * k > growth["factor"] * n * n - growth["shift"]
            return is_sum(P, Q, k) and grown and (possible is None or k in possible)
        expected = not (delta.denominator == 1 and (growth or not is_open or delta <= b)
                        and any(is_left(int(delta), k) for k in range(int(delta) - 1, -1, -2)))
        seen.add((expected, is_open, bool(growth), possible is None))
        if put(m, s, [place(), place(0), third, place()], c, True, possible, growth) != expected:
            return False
    return len(seen) == 16


def premises(m):
    """Three regular places, two of them irrational, and what else is asked for"""
    s, two, one = states(m)[3], place(n=2), place()
    third, free, chi = place(delta=F(1, 2)), place(open=True, b=F(0)), [poly(m, {0: -3}), poly(m, {1: 1})]
    grown = {"factor": F(1), "shift": F(0)}

    def says(*places, **more):
        return put(m, s, list(places), **more)
    return (says(two, third) == says(one, one, third) == says(free, two, place(0)) == says(place(-3), one, free, one) == True   # noqa: E712
            and {says(two, third, place(1)), says(two, place(1)), says(two, third, place(3)), says(one, place(3), third),
                 says(place(1, delta=F(1)), two), says(two, third, third), says(two, third, free), says(one, third), says(one, two, third),
                 says(two, place(n=2, delta=F(1, 2))), says(two), says(third), says(two, two), says(two, third, growth=grown, grows=False),
                 says(two, place(open=True, chi=chi)), says(two, place(delta=F(1001)))} == {"refused"}
            and says(two, place(open=True, chi=chi), growth=grown) is says(two, place(delta=F(1001)), possible=set()) is True)


def pairs(m):
    """A polynomial with the roots d1^2 and d2^2: u + v z at the roots of z^2 + 1, where r = (1 - u - v z)/(z^2 + 1)^2"""
    def of(*chis, num="1 - a - z*b", q="z^2 + 1", den="z^4 + 2*z^2 + 1"):
        s, found = state(m, num, den), ["refused"]
        places = [place(q=s.poly(q, True), chi=[s.poly(f) for f in chi]) for chi in chis]
        refused(m, lambda: found.append([dict(f) for f in m["strata_leaves"].pair(s, places)]))
        return found[-1]

    def polys(*fs):
        return [dict(state(m).poly(f)) for f in fs]
    chi = polys("a^2 + b^2", "-2*a", "1")
    return (of(("a", "2"), ("b", "3")) == polys("a*b", "3*a + 2*b", "6") and of(("a", "2")) == polys("a^2", "4*a", "4")
            and of(("a^2 + b^2", "-2*a", "1")) == chi and of(("2*a^2 + 2*b^2", "-4*a", "2")) == [{k: 2 * c for k, c in f.items()} for f in chi]
            and of(("a", "2"), ("1", "1", "1")) == of(("1", "1", "1"), ("a", "2")) == of(("a^2 + b^2", "-2*a + 1", "1"))
            == of(("12", "4", "1", "1"), num="3") == "refused" and of(("4", "4", "1"), num="3") == polys("4", "4", "1"))


def properties():
    """(name, function, True)"""
    return [(f"three_places.{f.__name__}", f, True) for f in (growth, sums, leaf, premises, pairs)]
