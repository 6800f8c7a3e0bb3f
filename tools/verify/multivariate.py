"""Exact arithmetic for strata.py and system.py: polynomials over Z in several variables, as dictionaries {monomial: coefficient}.

A monomial is one integer with the exponents in fields of 32 bits, so that products of monomials are sums and the order
of the integers is lexicographic.  A variable is the position of its field.  Products of terms are counted (spend)."""
import re
from fractions import Fraction
from functools import reduce
from heapq import heapify, heappop, heappush
from math import gcd
from operator import or_

from certificate_format import Malformed, need, right
from modular import power

FIELD, MASK, NAMES = 32, 2**32 - 1, 64
DEGREE, LONG = 10**6, 10**6
HIGH = sum(3 << FIELD * i + 30 for i in range(NAMES))           # no exponent reaches these bits, nor does a sum of two
POWER = r"[A-Za-z_][A-Za-z0-9_]*(\^(0|[1-9][0-9]{0,3}))?"
TERM = re.compile(rf"(0|[1-9][0-9]{{0,9999}}|{POWER})(\*{POWER})*\Z")


class Work:
    left = 0


def spend(products):
    Work.left -= products
    need(Work.left >= 0, "more work than the limit allows")


def cost(f, g):
    """Of a product of two coefficients, long ones counting more"""
    m, n = f.bits(), g.bits()
    return 1 + (m + n >> 9) + (m * n >> 18)


def product_of_numbers(m, n):
    """m n; long ones count."""
    a, b = m.bit_length(), n.bit_length()
    need(a + b <= LONG, "a limit: the length of a number")
    spend((a + b >> 9) + (a * b >> 18))
    return m * n


class P(dict):
    """A polynomial; no coefficient is 0, so the zero polynomial is false."""

    @staticmethod
    def of(terms):
        f = P((k, c) for k, c in terms.items() if c)
        need(not any(k & HIGH for k in f), "a degree does not fit its field")
        return f

    def __add__(self, o):
        spend(8 + len(self) + len(o))
        c = dict(self)
        for k, v in o.items():
            c[k] = c.get(k, 0) + v
        return P.of(c)

    def __sub__(self, o):
        return self + o * -1

    def __mul__(self, o):
        if isinstance(o, int):
            spend(2 + len(self) * (1 + (self.bits() >> 9) * (o.bit_length() >> 9)))
            return P((k, c * o) for k, c in self.items()) if o else P()
        spend(8 + len(self) * len(o) * cost(self, o))
        small, large = sorted((self, o), key=len)
        c = {}
        for a, u in small.items():
            for b, v in large.items():
                c[a + b] = c.get(a + b, 0) + u * v
        return P.of(c)

    def __pow__(self, e):
        return power(self, e) if e else ONE

    def bits(self):
        return max(map(int.bit_length, self.values()), default=0)

    def degree(self, x):
        return max((k >> x & MASK for k in self), default=-1)

    def variables(self):
        seen = reduce(or_, self, 0)
        return {x for x in range(0, seen.bit_length(), FIELD) if seen >> x & MASK}

    def constant(self):
        """Its value, if it is one; else None."""
        return self.get(0, 0) if not any(self) else None

    def coefficients(self, x):
        """Of x^0, x^1, ..."""
        n = self.degree(x)
        need(n <= DEGREE, "a limit: the degree of a polynomial")
        spend(n + 1)
        rows = [P() for _ in range(n + 1)]
        for k, c in self.items():
            e = k >> x & MASK
            rows[e][k - (e << x)] = c
        return rows

    def lead(self, x):
        return self.coefficients(x)[-1] if self else self

    def parts(self, fields):
        """{monomial in these fields (a mask): its coefficient}"""
        rows = {}
        for k, c in self.items():
            rows.setdefault(k & fields, P())[k & ~fields] = c
        return rows

    def at(self, known, constant):
        """The value where variables are elements of a ring, {variable: {1: this element, e: powers that are known}}; constant: what a
        polynomial in the other variables is there"""
        def value(f, xs):
            if not xs:
                return constant(f)
            x, *rest = xs
            terms = [value(row, rest) * y if e else value(row, rest) for e, row in enumerate(f.coefficients(x))
                     if row and (not e or (y := raised(known[x], e)))]
            return sum(terms[1:], terms[0]) if terms else constant(P())
        return value(self, sorted(self.variables() & known.keys()))

    def diff(self, x):
        return P((k - (1 << x), c * (k >> x & MASK)) for k, c in self.items() if k >> x & MASK)

    def primitive(self):
        """Divided by the greatest common divisor of its coefficients."""
        spend(len(self) * cost(self, self))
        g = gcd(*self.values())
        return P((k, c // g) for k, c in self.items()) if g > 1 else self

    def substitute(self, x, l, m, n):
        """l^n f(x = -m/l), n >= the degree in x"""
        rows, lift, v = self.coefficients(x), l**(n - max(0, self.degree(x))), P()
        for i, c in enumerate(reversed(rows)):
            v, lift = v * m * -1 + c * lift, lift * l if i < len(rows) - 1 else lift
        return v


ONE = P({0: 1})


def raised(known, e):
    """x^e, known: {k: x^k}"""
    if e not in known:
        known[e] = raised(known, e // 2) * raised(known, e - e // 2)
    return known[e]


def product(polys):
    return reduce(P.__mul__, polys, ONE)


def parse(text, names):
    """A polynomial in the variables {name: position} (strata_certificates.md 2)."""
    spend(1 + len(text) // 8)
    sign, rest, terms = (-1, text[1:], {}) if text[:1] == "-" else (1, text, {})
    parts = re.split(" ([+-]) ", rest)
    right(len(parts) <= 40000, "a polynomial with too many terms")
    for s, term in zip(["+"] + parts[1::2], parts[::2]):
        if not TERM.match(term):
            raise Malformed(f"not a polynomial: {text[:60]!r}")
        first, *others = term.split("*")
        c, k = (int(first), 0) if first.isdigit() else (1, 0)
        for factor in others if first.isdigit() else [first, *others]:
            name, _, e = factor.partition("^")
            if name not in names:
                raise Malformed(f"{name[:60]!r} is not a variable here")
            k += int(e or 1) << names[name]
            need(k >> names[name] & MASK < 10000, "an exponent is too large")
        terms[k] = terms.get(k, 0) + c * (sign if s == "+" else -1)
        sign = 1
    return P.of(terms)


def quotient(f, g):
    """f/g if that has integral coefficients, else None: g primitive divides f over Q iff it does so over Z (Gauss).
    If g divides, no exponent in what is left of f exceeds those of f."""
    spend(20 + len(f) + len(g))
    if not f:
        return f
    top, box, found, rest = max(g), reduce(or_, f), P(), dict(f)
    lead, row = g[top], len(g) * cost(f, g)
    fields = -(max(box, top).bit_length() // -FIELD)
    guard = ((1 << FIELD * fields) - 1) // MASK << FIELD - 1    # a bit above the exponent of each name up to the last that occurs
    if f[min(f)] % g[min(g)] or (min(f) | guard) - min(g) & guard != guard:
        return None
    heap = [-k for k in rest]
    heapify(heap)
    while heap:
        k = -heappop(heap)
        c = rest.pop(k)
        if not c:
            continue
        if c % lead or (k | guard) - top & guard != guard or (box | guard) - k & guard != guard:
            return None
        spend(row)
        c, shift = c // lead, k - top
        found[shift] = c
        for j, v in g.items():
            if j != top:
                if j + shift not in rest:
                    heappush(heap, -j - shift)
                rest[j + shift] = rest.get(j + shift, 0) - c * v
    return found


def remove(f, *gs):
    """f divided by each g, primitive and not constant, as often as it goes; f not 0."""
    for g in gs:
        while (q := quotient(f, g)) is not None:
            f = q
    return f


def ratio(f, g):
    """The rational number c with f = c g; None if there is none; f or g is not 0."""
    spend(1 + len(f))
    if f and f.keys() != g.keys():
        return None
    c = Fraction(f.get(max(g), 0), g[max(g)])
    return c if f * c.denominator == g * c.numerator else None


def constant(f):
    """num/den, if it is a constant; a fraction is a pair (num, den)."""
    return ratio(*f) if f[1] else None


def plus(f, g, c):
    """f + c g, c a rational number; g may be one"""
    c = Fraction(c)
    a, b = g if isinstance(g, tuple) else (ONE, ONE)
    return f[0] * b * c.denominator + a * f[1] * c.numerator, f[1] * b * c.denominator


def times(f, c):
    c = Fraction(c)
    return f[0] * c.numerator, f[1] * c.denominator


def pseudo_remainder(f, g, x):
    """f modulo g, times a power of the leading coefficient of g in x"""
    a, b = f.coefficients(x), g.coefficients(x)
    while len(a) >= len(b):
        top = a.pop()
        if top:
            a = [c * b[-1] for c in a]
            for i, c in enumerate(b[:-1], len(a) + 1 - len(b)):
                a[i] -= top * c
    return P((k + (i << x), c) for i, row in enumerate(a) for k, c in row.items())


def determinant(rows):
    """Bareiss: every entry that occurs is a minor, so the divisions are exact."""
    a, last, sign = [row[:] for row in rows], ONE, 1
    spend(len(a)**3)
    for k in range(len(a) - 1):
        i = min((i for i in range(k, len(a)) if a[i][k]), key=lambda i: len(a[i][k]), default=None)
        if i is None:
            return P()
        sign, a[k], a[i] = sign if i == k else -sign, a[i], a[k]
        for row in a[k + 1:]:
            head = row[k]
            row[k + 1:] = [quotient(x * a[k][k] - y * head, last) for x, y in zip(row[k + 1:], a[k][k + 1:])]
        last = a[k][k]
    return a[-1][-1] * sign


def resultant(f, g, x):
    """Res(f, g), up to sign and powers of the leading coefficient of f: Sylvester's determinant for g modulo f."""
    b = pseudo_remainder(g, f, x).coefficients(x)
    return sylvester(f.coefficients(x), b) if len(b) > 1 else b[0] if b else P()


def sylvester(f, g):
    """Res(f, g), up to its sign, by their coefficients"""
    n = len(f) + len(g) - 2
    spend(n**3)
    pad = [P()] * n
    return determinant([(pad[:i] + row[::-1] + pad)[:n] for row in (f, g) for i in range(n + 1 - len(row))]) if n else ONE
