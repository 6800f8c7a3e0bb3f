"""Enclosures: all numbers within r of m, integers or m in Z[i], over a power of 2; every operation rounds outward.  Series of
real ones, and orbits of a polynomial vector field enclosed step by step (docs/theory/chaos.md 1)."""
from contextlib import contextmanager
from fractions import Fraction
from math import floor, isqrt
from operator import mul
from typing import NamedTuple

from certificate_format import Rejected, need
from modular import power
from multivariate import FIELD, MASK

BITS = 112
ONE = 1 << BITS
ORDER = 22
EPSILON = ONE >> 72             # by which a Taylor polynomial is widened
STEPS = 600                     # of a return


class Gaussian(NamedTuple):
    """x + i y"""
    x: int
    y: int = 0

    def __bool__(self):
        return any(tuple(self))

    def __add__(self, o):
        return Gaussian(self.x + o.x, self.y + o.y)

    def __radd__(self, zero):
        return self

    def __sub__(self, o):
        return Gaussian(self.x - o.x, self.y - o.y)

    def __neg__(self):
        return Gaussian(-self.x, -self.y)

    def __mul__(self, o):
        return Gaussian(self.x * o.x - self.y * o.y, self.x * o.y + self.y * o.x)

    def __rshift__(self, n):
        return Gaussian(self.x >> n, self.y >> n)

    def __abs__(self):
        """Rounded up, by at most 1"""
        return isqrt(self.x * self.x + self.y * self.y) + 1


class Ball:
    """All numbers within r 2^-bits of m 2^-bits"""
    __slots__ = ("m", "r")
    bits = BITS

    def __init__(self, m, r=0):
        self.m, self.r = m, r

    @staticmethod
    def of(q):
        """Of a fraction or a float"""
        q = Fraction(q)
        m = q.numerator * ONE // q.denominator
        return Ball(m, 0 if q.denominator * m == q.numerator * ONE else 1)

    @staticmethod
    def between(a, b):
        """From a to b (units)"""
        return Ball((a + b) >> 1, ((b - a) >> 1) + 1)

    def __add__(self, o):
        return Ball(self.m + o.m, self.r + o.r)

    def __sub__(self, o):
        return Ball(self.m - o.m, self.r + o.r)

    def __neg__(self):
        return Ball(-self.m, self.r)

    def __mul__(self, o):
        a, b = abs(self.m), abs(o.m)
        r = a * o.r + self.r * (b + o.r)
        return Ball(self.m * o.m >> Ball.bits, (r >> Ball.bits) + (3 if r or self.m and o.m else 0))

    def __truediv__(self, o):
        need(abs(o.m) > o.r, "a division by an interval with 0")
        least = abs(o.m) - o.r
        m = (self.m << BITS) // o.m
        # |a/b - m| <= (|a - m0| + |m| |b - b0|)/|b|, with m0 = m b0 to within one b0
        r = ((self.r << BITS) + abs(m) * o.r + abs(o.m)) // least + 2
        return Ball(m, r)

    def low(self):
        return self.m - self.r

    def high(self):
        return self.m + self.r

    def most(self):
        return abs(self.m) + self.r

    def sign(self):
        """1, -1; 0 if it is not known"""
        return 0 if abs(self.m) <= self.r else 1 if self.m > 0 else -1

    def not_zero(self):
        return abs(self.m) - 1 > self.r

    def middle(self):
        return Ball(self.m)

    def wider(self, r):
        return Ball(self.m, self.r + r)

    def inside(self, o):
        """Strictly"""
        return o.low() < self.low() and self.high() < o.high()

    def meet(self, o):
        a, b = max(self.low(), o.low()), min(self.high(), o.high())
        need(a <= b, "two enclosures of the same number are apart")
        return Ball.between(a, b)

    def about(self):
        return self.m / ONE


ZERO, UNIT = Ball(0), Ball(ONE)


def total(balls):
    m = r = 0
    for b in balls:
        m += b.m
        r += b.r
    return Ball(m, r)


def matrix(a, b):
    """The product"""
    columns = list(zip(*b))
    return [[total(map(mul, row, column)) for column in columns] for row in a]


def determinant(a):
    return a[0][0] * a[1][1] - a[0][1] * a[1][0]


def adjugate(a):
    return [[a[1][1], -a[0][1]], [-a[1][0], a[0][0]]]


@contextmanager
def precision(bits):
    Ball.bits, before = bits, Ball.bits
    try:
        yield
    finally:
        Ball.bits = before


class Polynomials:
    """Several polynomials {monomial: integer} over common denominators, at points and along series"""

    def __init__(self, polys):
        """polys: of (P, positive integer)"""
        self.products, self.place = [], {}
        self.rows = [([(self.node(k), c) for k, c in f.items() if k], f.get(0, 0), d) for f, d in polys]

    def node(self, k):
        """The number of a monomial: the variables are 0 to 3, then products of two earlier ones"""
        if k not in self.place:
            x = next(i for i in range(4) if k >> FIELD * i & MASK)
            rest = k - (1 << FIELD * x)
            if not rest:
                self.place[k] = x
            else:
                pair = self.node(rest), x
                self.place[k] = 4 + len(self.products)
                self.products.append(pair)
        return self.place[k]

    def at(self, x):
        """Their values at four intervals"""
        v = list(x)
        for a, b in self.products:
            v.append(v[a] * v[b])
        out = []
        for terms, c0, d in self.rows:
            m, r = c0 * ONE, 0
            for i, c in terms:
                m += c * v[i].m
                r += abs(c) * v[i].r
            out.append(Ball(m // d, -(-r // d) + 1))
        return out


class Row:
    """A series: middles, radii, and the sizes |m| and |m| + r"""
    __slots__ = ("m", "r", "a", "u")

    def __init__(self):
        self.m, self.r, self.a, self.u = [], [], [], []

    def push(self, m, r):
        self.m.append(m)
        self.r.append(r)
        self.a.append(abs(m))
        self.u.append(abs(m) + r)


def convolution(f, g, k):
    """The coefficient of t^k of f g, in units of 2^(-2 BITS)"""
    return (sum(map(mul, f.m[:k + 1], g.m[k::-1])),
            sum(map(mul, f.u[:k + 1], g.r[k::-1])) + sum(map(mul, f.r[:k + 1], g.a[k::-1])))


class Series:
    """The Taylor coefficients of x' = X(x) at four numbers, each with as many derivatives as it has parts"""

    def __init__(self, field, x, order):
        self.parts = len(x[0])
        self.nodes = [[Row() for _ in range(self.parts)] for _ in range(4 + len(field.products))]
        for row, parts in zip(self.nodes, x):
            for one, b in zip(row, parts):
                one.push(b.m, b.r)
        for k in range(order):
            self.multiply(field, k)
            for x_row, (terms, c0, d) in zip(self.nodes, field.rows):
                for part, out in enumerate(x_row):
                    m = c0 * ONE if k == part == 0 else 0
                    r = 0
                    for i, c in terms:
                        m += c * self.nodes[i][part].m[k]
                        r += abs(c) * self.nodes[i][part].r[k]
                    out.push(m // (d * (k + 1)), r // (d * (k + 1)) + 2)

    def multiply(self, field, k):
        for i, (a, b) in enumerate(field.products):
            f, g, out = self.nodes[a], self.nodes[b], self.nodes[4 + i]
            for part in range(self.parts):
                m, r = convolution(f[0], g[part], k)
                if part:
                    n, s = convolution(f[part], g[0], k)
                    m, r = m + n, r + s
                out[part].push(m >> BITS, (r >> BITS) + 2)

    def coefficient(self, k):
        return [[Ball(p.m[k], p.r[k]) for p in row] for row in self.nodes[:4]]

    def at(self, t, order):
        """The polynomial of this degree at the interval t"""
        return [[horner(p, t, order) for p in row] for row in self.nodes[:4]]


def horner(p, t, order):
    m, r, a = p.m[order], p.r[order], abs(t.m)
    for k in range(order - 1, -1, -1):
        s = abs(m) * t.r + r * (a + t.r)
        m, r = (m * t.m >> BITS) + p.m[k], (s >> BITS) + 2 + p.r[k]
    return Ball(m, r)


class Step:
    """Orbits from x during the time from 0 to h: the polynomial, the box that contains them, the next coefficient"""

    def __init__(self, field, x):
        self.field, self.series = field, Series(field, x, ORDER)

    def guess(self):
        """A step that may be right"""
        size = max(p.u[ORDER] for row in self.series.nodes[:4] for p in row) or 1
        return min(0.5, 0.9 * (EPSILON / size)**(1 / ORDER))

    def contains(self, h):
        """(chaos.md 1.2) the polynomial over the step, widened, keeps the orbits: then self.box and self.last are set"""
        self.h = floor(h * 2**20) << BITS - 20
        self.times = Ball.between(0, self.h)
        self.box = [[b.wider(EPSILON) for b in row] for row in self.series.at(self.times, ORDER)]
        self.last = Series(self.field, self.box, ORDER + 1).coefficient(ORDER + 1)
        reach = power(Ball(self.h), ORDER + 1)
        return all((b * reach).most() < EPSILON for row in self.last for b in row)

    def at(self, t):
        """The orbits at the interval t of times within the step"""
        reach = power(t, ORDER + 1)
        return [[b + reach * c for b, c in zip(row, last)] for row, last in zip(self.series.at(t, ORDER), self.last)]

    def end(self):
        return self.at(Ball(self.h))


def values(x):
    return [row[0] for row in x]


class Flow:
    """Orbits of a field to where the section's function grows through 0 and that of the side is positive"""

    def __init__(self, field, section, slope, side):
        """section, side: one polynomial each; slope: the gradient of the section's; all of Polynomials"""
        self.field, self.section, self.slope, self.side = field, section, slope, side

    def rate(self, x):
        """d(section)/dt"""
        return total(a * b for a, b in zip(self.slope.at(x), self.field.at(x)))

    def crossing(self, step, start, end, leaving):
        """1: the step has one wanted crossing; 0: none; None: not known.  And: has the start been left?"""
        box = values(step.box)
        s, side, rate = self.section.at(box)[0], self.side.at(box)[0].sign(), self.rate(box).sign()
        if s.sign() or side < 0 or rate < 0:
            return 0, False
        if rate == 0:
            return None, leaving
        if leaving:
            return 0, True              # 0 at the start, monotone since
        a, b = (self.section.at(values(x))[0].sign() for x in (start, end))
        if a < 0 < b:
            return (1, False) if side > 0 else (None, False)
        return (0, False) if a and a == b else (None, False)

    def landing(self, step):
        """Where the orbits of a step cross, with derivatives: interval Newton on the time"""
        t, x = step.times, step.box
        for _ in range(12):
            m = t.middle()
            t = t.meet(m - self.section.at(values(step.at(m)))[0] / self.rate(values(x)))
            x = step.at(t)
        v = values(x)
        rate, gradient, field = self.rate(v), self.slope.at(v), self.field.at(v)
        for part in range(1, len(x[0])):
            d = total(g * row[part] for g, row in zip(gradient, x)) / rate
            for row, f in zip(x, field):
                row[part] = row[part] - f * d
        return x

    def returned(self, x, thin, off):
        """The next wanted crossing of the orbits from x and of the one from thin, the middle; off: the box of starts minus its
        middle"""
        leaving = True
        for _ in range(STEPS):
            step = Step(self.field, x)
            h = step.guess()
            for _ in range(80):
                if step.contains(h):
                    end = step.end()
                    found, left = self.crossing(step, x, end, leaving)
                    if found is not None:
                        break
                h *= 0.7
            else:
                raise Rejected("a step of an orbit is not enclosed")
            leaving, one = left, Step(self.field, thin)
            need(one.contains(step.h / ONE), "a step of the middle orbit is not enclosed")
            if found:
                x, thin = self.landing(step), self.landing(one)
                return tightened(x, thin, off), thin
            x, thin = tightened(end, one.end(), off), one.end()
        raise Rejected("an orbit does not return")


def tightened(x, thin, off):
    """(chaos.md 1.3)"""
    return [[v.meet(t[0] + a * off[0] + b * off[1]), a, b] for (v, a, b), t in zip(x, thin)]
