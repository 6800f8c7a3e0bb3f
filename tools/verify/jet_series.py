"""Laurent series over the algebra of a certificate, with their ends, and such series by degree in c1, c2
(docs/theory/jet_certificates.md 3)."""
from certificate_format import need
from multivariate import spend

EXACT = 1 << 40
ELEMENT, TERM = 300, 30                     # work of a product of two elements: long series of short ones are much, too


def pair(x, y):
    spend(ELEMENT + TERM * (len(x.p) + len(y.p)))
    return x * y


class Series:
    """The sum of c[m] s^m, + O(s^end); no c[m] is 0.  Without an end: exactly this."""

    def __init__(self, algebra, c=(), end=EXACT):
        self.algebra, self.end = algebra, end
        self.c = {m: x for m, x in dict(c).items() if x and m < end}

    def zero(self):
        """Exactly 0?"""
        return not self.c and self.end == EXACT

    def start(self):
        """Below this exponent there is nothing."""
        return min(self.c, default=self.end)

    def __getitem__(self, m):
        need(m < self.end, "a series is too short")
        return self.c.get(m) or self.algebra.sum([])

    def __add__(self, o):
        c = dict(self.c)
        for m, x in o.c.items():
            c[m] = c[m] + x if m in c else x
        return Series(self.algebra, c, min(self.end, o.end))

    def __sub__(self, o):
        return self + o * -1

    def __mul__(self, o):
        if not isinstance(o, Series):
            return Series(self.algebra, {m: x * o for m, x in self.c.items()}, self.end) if o else Series(self.algebra)
        if self.zero() or o.zero():
            return Series(self.algebra)
        end = self.end_of_product(o)
        c = {}
        for i, x in self.c.items():
            for j, y in o.c.items():
                if i + j < end:
                    c.setdefault(i + j, []).append((x, y))
        return Series(self.algebra, {m: self.algebra.sum(pair(x, y) for x, y in pairs) for m, pairs in c.items()}, end)

    def end_of_product(self, o):
        return min(self.end + o.start() if self.end < EXACT else EXACT, o.end + self.start() if o.end < EXACT else EXACT)

    def coefficient(self, o, m):
        """Of s^m in the product with o"""
        if self.zero() or o.zero():
            return self.algebra.sum([])
        need(m < self.end_of_product(o), "a series is too short")
        return self.algebra.sum(pair(x, o.c[m - i]) for i, x in self.c.items() if m - i in o.c)

    def derivative(self, d):
        """By t, t = s^d"""
        c = {m - d: self.algebra.divided(x * m, d) for m, x in self.c.items()}
        return Series(self.algebra, c, self.end - d if self.end < EXACT else EXACT)


class Jet:
    """Series by degree in c1, c2, up to one degree"""

    def __init__(self, parts):
        self.parts = parts

    def __getitem__(self, j):
        return self.parts[j]

    def __add__(self, o):
        return Jet([a + b for a, b in zip(self.parts, o.parts)])

    def __mul__(self, o):
        f, g = self.parts, o.parts
        return Jet([sum((f[i] * g[j - i] for i in range(j + 1)), Series(f[0].algebra)) for j in range(len(f))])
