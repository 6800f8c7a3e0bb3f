"""The algebra R = K(z)[w_1, ..., w_k]/(w_i^d_i - v_i), K = Q(parameters), with its derivation: where a phase curve has its
coordinates (docs/theory/system_certificates.md 4, C1 and C2)."""
from itertools import product
from math import gcd, lcm, prod

from certificate_format import need, right
from modular import power
from multivariate import FIELD, MASK, ONE, P, determinant, parse, quotient, remove
from system_format import DEGREES, fraction

BASE = FIELD * 13                           # z and the parameters are below, the tower is above
LOW = (1 << BASE) - 1


class Element:
    """rows {monomial of the tower: polynomial in z and the parameters} over n prod d_k^e_k"""

    def __init__(self, algebra, rows, n=1, e=None):
        self.algebra, self.rows, self.n, self.e = algebra, rows, n, e or [0] * len(algebra.denominators)

    def __bool__(self):
        return bool(self.rows)

    def over(self, n, e):
        """The rows over a larger denominator"""
        up = [(d, k - j) for d, j, k in zip(self.algebra.denominators, self.e, e) if k > j]
        rows, scale = self.rows, n // self.n
        for d, k in up:
            factor = d**k
            rows = {w: f * factor for w, f in rows.items()}
        return {w: f * scale for w, f in rows.items()} if scale != 1 else rows

    def __add__(self, o):
        if not self or not o:
            return self or o
        n, e = lcm(self.n, o.n), list(map(max, self.e, o.e))
        rows = dict(self.over(n, e))
        for w, f in o.over(n, e).items():
            rows[w] = rows[w] + f if w in rows else f
        return self.algebra.element({w: f for w, f in rows.items() if f}, n, e)

    def __sub__(self, o):
        return self + o * -1

    def times(self, o):
        """The product, not reduced"""
        rows = {}
        for a, f in self.rows.items():
            for b, g in o.rows.items():
                h = f * g
                rows[a + b] = rows[a + b] + h if a + b in rows else h
        return Element(self.algebra, {w: f for w, f in rows.items() if f}, self.n * o.n, list(map(int.__add__, self.e, o.e)))

    def __mul__(self, o):
        if isinstance(o, int):
            return Element(self.algebra, {w: f * o for w, f in self.rows.items()} if o else {}, self.n, self.e)
        return self.algebra.reduced(self.times(o))

    def __pow__(self, k):
        return power(self, k) if k else self.algebra.one

    def derivative(self):
        """D: by z, by the tower, and by the denominators (the quotient rule)"""
        a, out = self.algebra, []
        out.append(a.element({w: g for w, f in self.rows.items() if (g := f.diff(0))}, self.n, self.e))
        for i, slope in enumerate(a.slopes):
            at = FIELD * i
            rows = {w - (1 << at): f * (w >> at & MASK) for w, f in self.rows.items() if w >> at & MASK}
            out.append(Element(a, rows, self.n, self.e) * slope)
        for k, e in enumerate(self.e):
            dk = a.denominators[k].diff(0)
            if e and dk:
                unit = [int(i == k) for i in range(len(self.e))]
                out.append(self * Element(a, {0: dk * -e}, 1, unit))
        return a.sum(out)


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
        self.one, self.z = Element(self, {0: ONE}), Element(self, {0: P({1: 1})})
        self.tower = curve["tower"]
        self.at = self.names | {w["name"]: BASE + FIELD * i for i, w in enumerate(self.tower)}
        self.adjoin()

    def sum(self, terms):
        return sum(terms, Element(self, {}))

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
            lead = Element(self, {d - 1 << FIELD * i: ONE * d}) * self.slopes[i]
            need(not lead - self.values[i].derivative(), f"{self.tower[i]['name'][:60]} has another derivative")

    def norm(self, x):
        """The determinant of the multiplication by x, times denominators and a number: x has an inverse in R unless it is 0."""
        if set(x.rows) <= {0}:
            return x.rows.get(0, P())
        basis = [sum(e << FIELD * i for i, e in enumerate(es)) for es in product(*map(range, self.degrees))]
        images = [(x * Element(self, {w: ONE})).rows for w in basis]
        return determinant([[row.get(w, P()) for w in basis] for row in images])

    def is_unit(self, norm, where=()):
        """Is the norm not 0 for all z wherever no denominator is, and none of these?"""
        for d in (*self.denominators, *where):
            norm = remove(norm, d) if norm and d.constant() is None else norm
        return any(c.constant() for c in norm.coefficients(0))

    def raw(self, p, n, es):
        """p/(n prod d_k^e_k), not reduced"""
        rows = {}
        for k, c in p.items():
            rows.setdefault(k >> BASE, P())[k & LOW] = c
        for content, e in zip(self.contents, es):
            need(abs(content).bit_length() * e < 10**6, "a number is too large")
            n *= content**e
        if n < 0:
            n, rows = -n, {w: f * -1 for w, f in rows.items()}
        return Element(self, rows, n, [0 if d is ONE else e for d, e in zip(self.denominators, es)])

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
        terms = []
        for k, c in p.items():
            term = self.one * c
            for x in range(0, k.bit_length(), FIELD):
                if e := k >> x & MASK:
                    need(x in values, "a name has no value")
                    term = term * self.power(values[x], e)
            terms.append(term)
        return self.divided(self.sum(terms), n)

    def power(self, known, e):
        """x^e; known: {k: x^k}"""
        if e not in known:
            known[e] = self.power(known, e // 2) * self.power(known, e - e // 2)
        return known[e]

    def divided(self, x, n):
        return self.element(x.rows, x.n * n, x.e)

    def row(self, v, n):
        need(len(v) == n, f"a row of length {n} is expected")
        return [self.read(x) for x in v]

    def reduced(self, x):
        """w_i^d_i replaced by v_i, beginning with the last w"""
        for i in reversed(range(len(self.values))):
            at, d = FIELD * i, self.degrees[i]
            while True:
                high = {w - (d << at): f for w, f in x.rows.items() if w >> at & MASK >= d}
                if not high:
                    break
                low = Element(self, {w: f for w, f in x.rows.items() if w >> at & MASK < d}, x.n, x.e)
                x = low + Element(self, high, x.n, x.e).times(self.values[i])
        return self.element(x.rows, x.n, x.e)

    def element(self, rows, n, e):
        """What rows and denominators have in common is cancelled."""
        if not rows:
            return Element(self, {})
        e = list(e)
        for k, d in enumerate(self.denominators):
            while e[k]:
                lower = {}
                for w, f in rows.items():
                    lower[w] = quotient(f, d)
                    if lower[w] is None:
                        break
                if None in lower.values():
                    break
                rows, e[k] = lower, e[k] - 1
        g = n
        for f in rows.values():
            g = gcd(g, *f.values()) if g > 1 else 1
        if g > 1:
            rows, n = {w: P((k, c // g) for k, c in f.items()) for w, f in rows.items()}, n // g
        return Element(self, rows, n, e)
