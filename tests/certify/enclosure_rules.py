"""Properties of enclosures.py of the Python checker, functions of its modules (sys.modules) that are True: exact numbers are inside, and
enclosures are hardly wider than they must be (chaos.md 1)."""
import random
from fractions import Fraction as F

from lowest import refused

CORNERS = (-1, 0, 1)


def units(m, q):
    return F(q) * m["enclosures"].ONE


def holds(m, ball, q, most=None):
    """Is q inside, and the radius at most so many units?"""
    return abs(units(m, q) - ball.m) <= ball.r and (most is None or ball.r <= most)


def some(m, n=60, seed=3):
    """Pairs of intervals, as (m, r)"""
    gen = random.Random(seed)
    for _ in range(n):
        yield [(gen.randrange(-2**size, 2**size), gen.randrange(2**gen.randrange(1, size))) for size in (gen.randrange(2, 130), 112)]


def arithmetic(m):
    e = m["enclosures"]
    one = e.ONE

    for (a, r), (b, s) in some(m):
        x, y = e.Ball(a, r), e.Ball(b, s)
        corners = [(F(a + i * r), F(b + j * s)) for i in CORNERS for j in CORNERS]
        product = (abs(a) * s + r * abs(b) + r * s) // one
        if not ((x + y).m == a + b and (x + y).r == r + s == (x - y).r and (x - y).m == a - b and (-x).m == -a and (-x).r == r
                and all((x * y).low() <= u * v / one <= (x * y).high() for u, v in corners) and (x * y).r <= product + 3):
            return False
        if abs(b) > s:
            quotients = [u / v * one for u, v in corners]
            least = abs(b) - s
            if not all((x / y).low() <= v <= (x / y).high() for v in quotients) or (x / y).r > (
                    r * one + abs(a * one // b) * s + abs(b)) // least + 2:
                return False
        elif not refused(m, lambda x=x, y=y: x / y):
            return False
    exact, tiny = e.Ball(one * 3), [e.Ball(a, r) for a in (0, 1, 3, -5) for r in (0, 1, 7)]
    if not all((x * y).low() * one <= min((x.m + i * x.r) * (y.m + j * y.r) for i in CORNERS for j in CORNERS) and max(
            (x.m + i * x.r) * (y.m + j * y.r) for i in CORNERS for j in CORNERS) <= (x * y).high() * one for x in tiny for y in tiny):
        return False
    return ((exact * e.Ball(one * -5)).m == one * -15 and (exact * e.Ball(0)).r == (e.Ball(0) * exact).r == (e.Ball(0) * e.Ball(0)).r == 0
            and refused(m, lambda: exact / e.Ball(5, 5)) and refused(m, lambda: exact / e.Ball(-5, 5)) and not refused(
                m, lambda: exact / e.Ball(-6, 5)) and (e.ZERO.m, e.ZERO.r, e.UNIT.m, e.UNIT.r, e.Ball(4).r) == (0, 0, one, 0, 0)
            and e.BITS == 112 and one == 2**112 and all((e.Ball(one) / e.Ball(k * one)).r <= 3 for k in (2, 3, -7))
            and (e.total([e.Ball(3, 1), e.Ball(-7, 2), e.Ball(1, 0)]).m, e.total([e.Ball(3, 1), e.Ball(-7, 2), e.Ball(1)]).r) == (-3, 3)
            and e.total([]).m == e.total([]).r == 0)


def comparisons(m):
    e = m["enclosures"]
    ball, of = e.Ball, e.Ball.of
    for a in range(-6, 7):
        for r in range(4):
            x = ball(a, r)
            if (x.low(), x.high(), x.most()) != (a - r, a + r, max(abs(a - r), abs(a + r))):
                return False
            if x.sign() != (1 if a - r > 0 else -1 if a + r < 0 else 0) or (x.middle().m, x.middle().r) != (a, 0):
                return False
            if (x.wider(5).m, x.wider(5).r) != (a, r + 5) or x.inside(x) or not x.inside(x.wider(1)):
                return False
            for b in range(-6, 7):
                y = ball(b, 2)
                apart = a + r < b - 2 or b + 2 < a - r
                if x.inside(y) != (b - 2 < a - r and a + r < b + 2) or apart != refused(m, lambda x=x, y=y: x.meet(y)):
                    return False
                if not apart:
                    z, low, high = x.meet(y), max(a - r, b - 2), min(a + r, b + 2)
                    if not (low - 2 <= z.low() <= low and high <= z.high() <= high + 2):
                        return False
            z = ball.between(a, a + r)
            if not (a - 2 <= z.low() <= a and a + r <= z.high() <= a + r + 2):
                return False
    return (all(holds(m, of(q), q, 1) for q in (F(1, 3), F(-1, 3), F(22, 7), 0.1, -0.3, F(-5, 2)))
            and all(of(q).r == 0 and of(q).m == units(m, q) for q in (0, 1, F(-3, 8), 0.75)) and of(F(1, 3)).r == 1
            and of(F(-7, 4)).about() == -1.75)


def polynomials(m):
    """In four variables, over integers, at intervals; products are shared"""
    e, parse, FIELD = m["enclosures"], m["multivariate"].parse, m["multivariate"].FIELD
    m["multivariate"].Work.left = 10**6
    at = {x: FIELD * i for i, x in enumerate("xyuv")}
    given = [("3*x^2*y - 5*u*v^3 + 7", 2), ("x*y*u*v - x - 11", 3), ("v^4 - 2*v^2", 1), ("-13", 5), ("0", 1)]
    f = e.Polynomials([(parse(v, at), n) for v, n in given])

    def exact(x, y, u, v):
        return [(3 * x**2 * y - 5 * u * v**3 + 7) / 2, (x * y * u * v - x - 11) / 3, v**4 - 2 * v**2, F(-13, 5), F(0)]
    point = [F(3, 2), F(-5, 4), F(1, 8), F(7, 2)]
    if not all(holds(m, b, q, 500) for b, q in zip(f.at([e.Ball.of(q) for q in point]), exact(*point))):
        return False
    wide = f.at([e.Ball.of(q).wider(e.ONE >> 20) for q in point])
    for i in CORNERS:
        for j in CORNERS:
            near = [q + F(k, 2**20) for q, k in zip(point, (i, j, -i, j))]
            if not all(holds(m, b, q) for b, q in zip(wide, exact(*near))):
                return False
    return max(b.r for b in wide) < e.ONE >> 10 and len(f.products) <= 11 and len(f.rows) == 5


def henon_heiles(m):
    """x' = u, y' = v, u' = -x - 2 x y, v' = -y - x^2 + y^2"""
    e, parse, FIELD = m["enclosures"], m["multivariate"].parse, m["multivariate"].FIELD
    m["multivariate"].Work.left = 10**6
    at = {x: FIELD * i for i, x in enumerate("xyuv")}
    return e.Polynomials([(parse(v, at), n) for v, n in (("u", 1), ("3*v", 3), ("-2*x - 4*x*y", 2), ("-y - x^2 + y^2 + 1", 1))])


def taylor(start, parts, n):
    """The coefficients of the same, with derivatives, in fractions"""
    rows = [[[q] + [F(0)] * n for q in row] for row in zip(start, *parts)]

    def product(f, g, k):
        return sum(f[i] * g[k - i] for i in range(k + 1))
    for k in range(n):
        x, y, u, v = rows
        for p in range(len(parts) + 1):
            def bilinear(f, g, p=p, k=k):
                return product(f[0], g[0], k) if p == 0 else product(f[0], g[p], k) + product(f[p], g[0], k)
            new = [u[p][k], v[p][k], -x[p][k] - 2 * bilinear(x, y), -y[p][k] - bilinear(x, x) + bilinear(y, y) + (k == p == 0)]
            for row, q in zip(rows, new):
                row[p][k + 1] = q / (k + 1)
    return rows


START, PARTS = (F(1, 4), F(-1, 8), F(1, 2), F(3, 8)), ((F(1), F(0), F(1, 2), F(0)), (F(0), F(1), F(-1, 4), F(2)))


def series(m):
    e, field, n = m["enclosures"], henon_heiles(m), 9
    exact = taylor(START, PARTS, n)
    given = [[e.Ball.of(q) for q in row] for row in zip(START, *PARTS)]
    s = e.Series(field, given, n)
    for k in range(n + 1):
        for row, balls in zip(exact, s.coefficient(k)):
            if len(balls) != 3 or not all(holds(m, b, q[k], 60 * (k + 1)) for b, q in zip(balls, row)):
                return False
    wide, near = e.Series(field, [[b.wider(e.ONE >> 30) for b in row] for row in given], n), [
        tuple(q + F(c, 2**30) for q, c in zip(x, (1, -1, 1, 1))) for x in (START, *PARTS)]
    other = taylor(near[0], near[1:], n)
    for k in range(n + 1):
        for row, balls in zip(other, wide.coefficient(k)):
            if not all(holds(m, b, q[k], e.ONE >> 16) for b, q in zip(balls, row)):
                return False
    t, order = F(-3, 16), 7
    for box, rows, widths, most in ((s, exact, 0, 400), (wide, other, e.ONE >> 40, e.ONE >> 20)):
        at = box.at(e.Ball.of(t).wider(widths), order)
        for time in (t, t + F(widths, e.ONE)):
            for row, balls in zip(rows, at):
                if not all(holds(m, b, sum(c * time**k for k, c in enumerate(q[:order + 1])), most) for b, q in zip(balls, row)):
                    return False
    f, g = e.Row(), e.Row()
    for a, b in ((3, 1), (-5, 2), (7, 0), (11, 4)):
        f.push(a, b)
        g.push(b - a, a * a)
    pairs = [sum(f.m[i] * g.m[k - i] for i in range(k + 1)) for k in range(4)]
    radii = [sum((abs(f.m[i]) + f.r[i]) * g.r[k - i] + f.r[i] * abs(g.m[k - i]) for i in range(k + 1)) for k in range(4)]
    return ([e.convolution(f, g, k) for k in range(4)] == list(zip(pairs, radii)) and (f.a, f.u) == ([3, 5, 7, 11], [4, 7, 7, 15])
            and [e.power(e.Ball.of(F(-3, 2)), k).m for k in range(1, 5)] == [units(m, F(-3, 2)**k) for k in range(1, 5)])


def oscillators(m):
    """x'' = -x, y'' = -y/16"""
    e, parse, FIELD = m["enclosures"], m["multivariate"].parse, m["multivariate"].FIELD
    m["multivariate"].Work.left = 10**6
    at = {x: FIELD * i for i, x in enumerate("xyuv")}

    def of(*rows):
        return e.Polynomials([(parse(v, at), n) for v, n in rows])
    return of, of(("u", 1), ("v", 1), ("-x", 1), ("-y", 16))


def trigonometric(t, n=40):
    """cos and sin, to 2^-120"""
    c = s = F(0)
    term = F(1)
    for k in range(n):
        c, s = (c + (-1)**(k // 2) * term, s) if k % 2 == 0 else (c, s + (-1)**(k // 2) * term)
        term = term * t / (k + 1)
    return c, s


def steps(m):
    """Orbits are inside of the box all the time, and at the end"""
    e = m["enclosures"]
    of, _ = oscillators(m)
    start = (F(1, 2), F(-2), F(3, 4), F(1, 3))
    for way in (1, -1):
        field = of(*((v if way > 0 else v[1:] if v[0] == "-" else "-" + v, n) for v, n in (("u", 1), ("v", 1), ("-x", 1), ("-y", 16))))
        step = e.Step(field, [[e.Ball.of(q)] for q in start])
        h = step.guess()
        if not 0.1 <= h <= 0.5 or not step.contains(h) or step.contains(5.0) or not step.contains(h):
            return False
        length = F(step.h, e.ONE)
        if abs(length - F(h)) > F(1, 2**19) or step.h <= 0:
            return False
        for k in range(9):
            t = way * length * k / 8
            (c, s), (d, r) = trigonometric(t), trigonometric(t / 4)
            exact = [start[0] * c + start[2] * s, start[1] * d + 4 * start[3] * r, start[2] * c - start[0] * s, start[3] * d - start[1] * r / 4]
            time = e.Ball.of(abs(t))
            if not all(holds(m, b, q) for b, q in zip(e.values(step.box), exact)):
                return False
            if not all(holds(m, b, q, e.EPSILON) for b, q in zip(e.values(step.at(time)), exact)):
                return False
        if not all(holds(m, b, q, e.EPSILON) and b.r < e.EPSILON for b, q in zip(e.values(step.end()), exact)):
            return False
        reach = F(step.h, e.ONE)**(e.ORDER + 1)
        if not all(abs(b.m) * reach < e.EPSILON for row in step.last for b in row) or len(e.values(step.box)) != 4:
            return False
    return e.EPSILON == 2**40 and larger_is_seen(m)


def larger_is_seen(m):
    """The box has to be that of the next coefficient: y' = x^22 from x = t, t^23/23 in y"""
    e = m["enclosures"]
    of, _ = oscillators(m)
    field = of(("1", 1), ("1000*x^22", 1), ("0", 1), ("0", 1))
    zero = [[e.ZERO] for _ in range(4)]
    # 1000 h^23/23 < 2^-72
    limit = (2.0**-72 * 23 / 1000)**(1 / 23)
    small, large = e.Step(field, zero), e.Step(field, zero)
    return small.contains(0.99 * limit) and not large.contains(1.01 * limit) and remainder(m, small)


def remainder(m, step):
    """The last coefficient times the power of the step is below EPSILON, not equal to it"""
    e = m["enclosures"]
    reach, Series = e.power(e.Ball(e.ONE // 2), e.ORDER + 1), e.Series

    def contains(c):
        e.Series = lambda field, box, order: type("S", (), {"coefficient": lambda self, k: [[e.Ball(c)]]})()
        try:
            return step.contains(0.5)
        finally:
            e.Series = Series
    equal = [c for c in (e.EPSILON - k << e.ORDER + 1 for k in range(99)) if (e.Ball(c) * reach).most() == e.EPSILON]
    return equal and not contains(equal[0]) and contains(equal[0] - (1 << e.ORDER + 1))


def crossings(m):
    """Section y - 1/2 = 0, side u > 0, field (1, v, 0, 0), from boxes at the beginning and at the end"""
    e = m["enclosures"]
    of, _ = oscillators(m)
    field = of(("1", 1), ("v", 1), ("0", 1), ("0", 1))

    def ball(a, b):
        return e.Ball.between(int(units(m, a)), int(units(m, b)))

    def found(start, end, v=(1, 2), side=(1, 2), leaving=False, sign=1):
        section, slope = (("2*y - 1", 2), ("1", 1)) if sign > 0 else (("-2*y + 1", 2), ("-1", 1))
        flow = e.Flow(field, of(section), of(("0", 1), slope, ("0", 1), ("0", 1)), of(("u", 1)))

        def point(y):
            return [[ball(*x)] for x in ((0, 0), (y, y), side, v)]
        step = e.Step(field, point(start))
        step.box = [[ball(*x)] for x in ((0, 0), (min(start, end), max(start, end)), side, v)]
        return flow.crossing(step, point(start), point(end), leaving)
    low, high, half = F(1, 4), F(3, 4), F(1, 2)
    down, both = (-2, -1), (-1, 1)
    return (found(low, high) == (1, False) and found(low, F(3, 8)) == found(high, 1) == (0, False) and found(high, low) == (None, False)
            and found(low, high, side=both) == (None, False) and found(low, high, side=down) == (0, False)
            and found(low, high, v=down) == found(high, low, v=down) == (0, False) and found(low, high, v=both) == (None, False)
            and found(low, high, v=both, leaving=True) == (None, True) and found(half, high, leaving=True) == (0, True)
            and found(half, high) == found(half, half) == (None, False) and found(low, half) == (None, False)
            and found(high, low, v=down, sign=-1) == (1, False) and found(low, high, v=down, sign=-1) == (None, False)
            and found(low, high, sign=-1) == (0, False)
            and found(low, F(3, 8), leaving=True) == (0, False) and found(low, high, v=down, leaving=True) == (0, False))


def chord(P, V, sign=1):
    """Where the line through P of the unit disc leaves it, and the time"""
    a, b, c = sum(v * v for v in V), sum(p * v for p, v in zip(P, V)), sum(p * p for p in P) - 1
    from math import isqrt
    d = b * b - a * c
    root = F(isqrt(d.numerator), isqrt(d.denominator))
    if root * root != d:
        raise ValueError("another line")
    t = (-b + sign * root) / a
    return [p + t * v for p, v in zip(P, V)], t


def chords(m):
    """Straight lines in the unit disc, with derivatives: to where they leave it; back to where they came in"""
    e = m["enclosures"]
    of, _ = oscillators(m)
    flows = {1: e.Flow(of(("u", 1), ("v", 1), ("0", 1), ("0", 1)), of(("3*x^2 + 3*y^2 - 3", 2)),
                       of(("3*x", 1), ("3*y", 1), ("0", 1), ("0", 1)), of(("1", 1))),
             -1: e.Flow(of(("-u", 1), ("-v", 1), ("0", 1), ("0", 1)), of(("3*x^2 + 3*y^2 - 3", 2)),
                        of(("3*x", 1), ("3*y", 1), ("0", 1), ("0", 1)), of(("1", 1)))}
    P, V = (F(-3, 5), F(4, 5)), (F(1, 2), F(-1, 8))
    one, two = (F(4, 5), F(3, 5), F(1), F(-2)), (F(1, 2), F(0), F(3), F(1, 7))
    off = F(1, 2**50)
    for way in (1, -1):
        start = (P, V) if way > 0 else (chord(P, V)[0], V)
        Q, t = chord(*start, way)
        thin = [[e.Ball.of(q)] for q in (*start[0], *V)]
        ball = e.Ball(0, int(units(m, off)))
        wide = [[b[0] + e.Ball.of(x) * ball + e.Ball.of(y) * ball, e.Ball.of(x), e.Ball.of(y)] for b, x, y in zip(thin, one, two)]
        found, middle = flows[way].returned(wide, thin, (ball, ball))
        exact = []
        for part in (one, two):
            d = [p + t * v for p, v in zip(part[:2], part[2:])]
            dt = -(Q[0] * d[0] + Q[1] * d[1]) / (Q[0] * V[0] + Q[1] * V[1])
            exact.append([*(x + v * dt for x, v in zip(d, V)), *part[2:]])
        if not all(holds(m, b[0], q, e.ONE >> 68) for b, q in zip(middle, (*Q, *V))):
            return False
        for i, row in enumerate(found):
            if not holds(m, row[0], [*Q, *V][i], int(units(m, 60 * off))) or not all(
                    holds(m, row[1 + k], exact[k][i], int(units(m, 2000 * off))) for k in (0, 1)):
                return False
        # a point that starts near the middle
        for k in (0, 1):
            part = (one, two)[k]
            near = chord_near(start, [off * x for x in part], way, 2**30)
            if not all(abs(units(m, q) - row[0].m) <= row[0].r + 2**20 for q, row in zip(near, found)):
                return False
    return True


def chord_near(start, shift, way, n):
    """The end of a line near the other one, to n^-3"""
    P, V = [p + s for p, s in zip(start[0], shift)], [v + s for v, s in zip(start[1], shift[2:])]
    from math import isqrt
    a, b, c = sum(v * v for v in V), sum(p * v for p, v in zip(P, V)), sum(p * p for p in P) - 1
    d = b * b - a * c
    t = (-b + way * F(isqrt(d.numerator * n**8 // d.denominator), n**4)) / a
    return [*(p + t * v for p, v in zip(P, V)), *V]


def returns(m):
    """Oscillators of periods 2 pi and 8 pi, seen where x = 0 and x' > 0: (y, v) -> (4 v, -y/4)"""
    e = m["enclosures"]
    of, field = oscillators(m)
    flows = {1: e.Flow(field, of(("x", 1)), of(("1", 1), ("0", 1), ("0", 1), ("0", 1)), of(("y + 100", 1))),
             -1: e.Flow(of(("-u", 1), ("-v", 1), ("x", 1), ("y", 16)), of(("-x", 1)), of(("-1", 1), ("0", 1), ("0", 1), ("0", 1)),
                        of(("y + 100", 1)))}
    y, v, u = F(1, 3), F(-2, 7), F(5, 4)
    parts = ((F(0), F(1), F(1, 9), F(0)), (F(0), F(0), F(-1, 5), F(1)))
    tiny = e.Ball(0, e.ONE >> 60)
    for way in (1, -1):
        thin = [[e.Ball.of(q)] for q in (0, y, u, v)]
        wide = [[b[0] + e.Ball.of(p) * tiny + e.Ball.of(q) * tiny, e.Ball.of(p), e.Ball.of(q)] for b, p, q in zip(thin, *parts)]
        found, middle = flows[way].returned(wide, thin, (tiny, tiny))
        exact = [[F(0)] * 3, [4 * way * v, F(0), F(4 * way)], [u, F(1, 9), F(-1, 5)], [-way * y / 4, F(-way, 4), F(0)]]
        for row, one, q in zip(found, middle, exact):
            if not holds(m, one[0], q[0], e.ONE >> 62) or not all(holds(m, b, x, e.ONE >> 50) for b, x in zip(row, q)):
                return False
    other = e.Flow(field, of(("x", 1)), of(("1", 1), ("0", 1), ("0", 1), ("0", 1)), of(("-1", 1)))
    e.STEPS, steps_of = 40, e.STEPS
    try:
        never = refused(m, lambda: other.returned(wide, thin, (tiny, tiny)))
    finally:
        e.STEPS = steps_of
    ten, one = e.Ball(e.ONE * 10, e.ONE), e.Ball(e.ONE)
    row = e.tightened([[ten, one, one + one]], [[ten.middle()]], (e.Ball(30, 50), e.Ball(-70, 80)))[0]
    return never and abs(row[0].m - e.ONE * 10 + 110) < 3 and 210 <= row[0].r <= 220 and row[1:] == [one, row[2]]


def short_steps(m):
    """A step is made shorter until its orbits are enclosed: x' = 1, y' = 1000 x^22, until x = 1/2; or there is none"""
    e = m["enclosures"]
    of, _ = oscillators(m)

    def landed(where):
        flow = e.Flow(of(("1", 1), ("1000*x^22", 1), ("0", 1), ("0", 1)), of((where, 2)), of(("1", 1), ("0", 1), ("0", 1), ("0", 1)), of(("1", 1)))
        start, off = [[e.Ball.of(q)] for q in (F(-1, 4), F(0), F(0), F(0))], e.Ball(0)
        wide = [[b[0], e.ZERO, e.ZERO] for b in start]
        return None if refused(m, lambda: wide.append(flow.returned(wide[:4], start, (off, off)))) else wide[4][0]
    guess, contains, e.Step.guess = e.Step.guess, e.Step.contains, lambda self: 5.0
    try:
        found = landed("2*x - 1")
        e.Step.contains = lambda self, h: False
        if landed("2*x - 1") is not None:
            return False
    finally:
        e.Step.guess, e.Step.contains = guess, contains
    return (found and holds(m, found[0][0], F(1, 2), 2**62) and holds(m, found[1][0], F(1000, 23) * (F(1, 2)**23 + F(1, 4)**23), 2**62))


def properties():
    """(name, function, True)"""
    every = (arithmetic, comparisons, polynomials, series, steps, crossings, chords, returns, short_steps)
    return [(f"enclosure_rules.{f.__name__}", f, True) for f in every]
