"""The algebra R = K(z)[w_1, ..., w_k]/(w_i^d_i - v_i), K = Q(parameters), with its derivation: where a phase curve has its
coordinates (docs/theory/system_certificates.md 4, C1 and C2)."""
from fractions import Fraction
from itertools import product
from math import gcd, lcm, prod

from certificate_format import need, right
from modular import power
from multivariate import FIELD, MASK, ONE, P, determinant, parse, quotient, remove
from system_format import DEGREES, fraction

BASE = FIELD * 13                           # z and the parameters are below, the tower is above


class Element:
    """A polynomial in z, the parameters and the tower over n prod d_k^e_k"""

    def __init__(self, algebra, p, n=1, e=None):
        self.algebra, self.p, self.n, self.e = algebra, p, n, e or [0] * len(algebra.denominators)

    def __bool__(self):
        return bool(self.p)

    def over(self, n, e):
        """The numerator over a larger denominator"""
        p = self.p
        for d, j, k in zip(self.algebra.denominators, self.e, e):
            p = p * d**(k - j) if k > j else p
        return p * (n // self.n) if n != self.n else p

    def __add__(self, o):
        if not self or not o:
            return self or o
        n, e = lcm(self.n, o.n), list(map(max, self.e, o.e))
        return self.algebra.element(self.over(n, e) + o.over(n, e), n, e)

    def __sub__(self, o):
        return self + o * -1

    def times(self, o):
        """The product, not reduced"""
        return Element(self.algebra, self.p * o.p, self.n * o.n, list(map(int.__add__, self.e, o.e)))

    def __mul__(self, o):
        if isinstance(o, int):
            return Element(self.algebra, self.p * o, self.n, self.e)
        return self.algebra.reduced(self.times(o))

    def __pow__(self, k):
        return power(self, k) if k else self.algebra.one

    def diff(self, x):
        """The numerator differentiated by a name"""
        return self.algebra.element(self.p.diff(x), self.n, self.e)

    def part(self, x, i):
        """The coefficient of x^i, x a name that no denominator has"""
        rows = self.p.coefficients(x)
        return self.algebra.element(rows[i] if 0 <= i < len(rows) else P(), self.n, self.e)

    def derivative(self):
        """D: by z, by the tower, and by the denominators (the quotient rule)"""
        a = self.algebra
        out = [self.diff(0), *(self.diff(BASE + FIELD * i) * slope for i, slope in enumerate(a.slopes))]
        for k, e in enumerate(self.e):
            if e:
                out.append(self * Element(a, a.denominators[k].diff(0) * -e, 1, [int(i == k) for i in range(len(self.e))]))
        return a.sum(out)

    def in_tower(self):
        """Has it a name of the tower in it?"""
        return max(self.p.variables(), default=0) >= BASE

    def number(self):
        """The rational number that it is, or None"""
        c = self.p.constant()
        return None if any(self.e) or c is None else Fraction(c, self.n)


class FunctionAlgebra:
    """denominators: primitive, 1 for a constant one; the contents go into n."""

    def __init__(self, curve, parameters):
        self.names = {curve["variable"]: 0} | {x: FIELD * (i + 1) for i, x in enumerate(parameters)}
        self.denominators, self.contents, self.degrees, self.values, self.slopes = [], [], [], [], []
        self.shown = []                     # as they were given
        for text in curve["denominators"]:
            d = parse(text, self.names)
            need(d, "a denominator is 0")
            content, top = gcd(*d.values()), d.primitive()
            constant = top.constant()
            self.shown.append(d)
            self.denominators.append(top if constant is None else ONE)
            self.contents.append(content * (constant or 1))
        self.one, self.z = self.constant(ONE), self.name(0)
        self.tower = curve["tower"]
        self.at = self.names | {w["name"]: BASE + FIELD * i for i, w in enumerate(self.tower)}
        self.adjoin()

    def constant(self, p):
        return Element(self, p)

    def name(self, x):
        return Element(self, P({1 << x: 1}))

    def sum(self, terms):
        return sum(terms, Element(self, P()))

    def adjoin(self):
        """The tower, and that its derivation is one"""
        for i, w in enumerate(self.tower):
            right(2 <= w["degree"] <= DEGREES, "a degree from 2 to 64")
            self.degrees.append(w["degree"])
            need(prod(self.degrees) <= DEGREES, "the tower is too high")
            p, n, es = fraction(w["value"], self.at, len(self.denominators))
            need(all(x < BASE + FIELD * i for x in p.variables() - {BASE + FIELD * i})
                 and p.degree(BASE + FIELD * i) < w["degree"], "a value of the tower has a name that is too high")
            self.values.append(None)        # w_i itself has a smaller degree
            self.values[i] = self.reduced(self.raw(p, n, es))
        self.slopes = [self.read(w["derivative"]) for w in self.tower]
        for i, d in enumerate(self.degrees):
            lead = self.constant(P({d - 1 << BASE + FIELD * i: d})) * self.slopes[i]
            need(not lead - self.values[i].derivative(), f"{self.tower[i]['name'][:60]} has another derivative")

    def norm(self, x):
        """The determinant of the multiplication by x, times denominators and a number: x has an inverse in R unless it is 0."""
        if not x.in_tower():
            return x.p
        basis = [sum(e << BASE + FIELD * i for i, e in enumerate(es)) for es in product(*map(range, self.degrees))]
        images = [(x * self.constant(P({w: 1}))).p.parts(-1 << BASE) for w in basis]
        return determinant([[row.get(w, P()) for w in basis] for row in images])

    def dot(self, a, b):
        return self.sum(x * y for x, y in zip(a, b) if x and y)

    def determinant(self, rows):
        """Of elements, along the first row"""
        if not rows:
            return self.one
        first, *rest = rows
        return self.dot(first, (self.determinant([row[:j] + row[j + 1:] for row in rest]) * (-1)**j for j in range(len(first))))

    def is_unit(self, norm, where=()):
        """Is the norm not 0 for all z wherever no denominator is, and none of these?"""
        for d in (*self.denominators, *where):
            norm = remove(norm, d) if norm and d.constant() is None else norm
        return any(c.constant() for c in norm.coefficients(0))

    def raw(self, p, n, es):
        """p/(n prod d_k^e_k), not reduced"""
        for content, e in zip(self.contents, es):
            need(abs(content).bit_length() * e < 10**6, "a number is too large")
            n *= content**e
        return Element(self, p if n > 0 else p * -1, abs(n), [0 if d is ONE else e for d, e in zip(self.denominators, es)])

    def read(self, v):
        return self.reduced(self.raw(*fraction(v, self.at, len(self.denominators))))

    def names_in(self, v):
        """The names in an element as it was given, and in the steps of the tower that it uses"""
        found, left = set(), [v]
        while left:
            p, _, es = fraction(left.pop(), self.at, len(self.denominators))
            used = p.variables().union(*(d.variables() for d, e in zip(self.shown, es) if e))
            new = {x for x, at in self.at.items() if at in used} - found
            found |= new
            left += [w["value"] for w in self.tower if w["name"] in new]
        return found

    def put_in(self, p, n, values):
        """p/n for a polynomial p in other names, with the values {variable: {1: value}} put in"""
        need(p.variables() <= set(values), "a name has no value")
        return self.divided(p.at(values, self.constant), n)

    def divided(self, x, n):
        return self.element(x.p, x.n * n, x.e)

    def row(self, v, n):
        need(len(v) == n, f"a row of length {n} is expected")
        return [self.read(x) for x in v]

    def reduced(self, x):
        """w_i^d_i replaced by v_i, beginning with the last w"""
        for i in reversed(range(len(self.values))):
            at, d = BASE + FIELD * i, self.degrees[i]
            while x.p.degree(at) >= d:
                low, high = P(), P()
                for k, c in x.p.items():
                    if k >> at & MASK >= d:
                        high[k - (d << at)] = c
                    else:
                        low[k] = c
                x = Element(self, low, x.n, x.e) + Element(self, high, x.n, x.e).times(self.values[i])
        return self.element(x.p, x.n, x.e)

    def element(self, p, n, e):
        """What numerator and denominators have in common is cancelled."""
        if not p:
            return Element(self, p)
        e = list(e)
        for k, d in enumerate(self.denominators):
            while e[k] and (q := quotient(p, d)) is not None:
                p, e[k] = q, e[k] - 1
        g = gcd(n, *p.values()) if n > 1 else 1
        return Element(self, P((k, c // g) for k, c in p.items()) if g > 1 else p, n // g, e)
