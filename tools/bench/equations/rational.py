"""Polynomials and rational functions over Q or Q(sqrt d), written out as text that every system reads.

A polynomial is a list of coefficients, ascending, without trailing zeros.  Coefficients are Fractions
or elements of one quadratic field.
"""

from fractions import Fraction


class Quadratic:
    """a + b*sqrt(d), a and b rational."""

    def __init__(self, a, b, d):
        self.a, self.b, self.d = Fraction(a), Fraction(b), d

    def _of(self, o):
        return o if isinstance(o, Quadratic) else Quadratic(o, 0, self.d)

    def __add__(self, o):
        o = self._of(o)
        return Quadratic(self.a + o.a, self.b + o.b, self.d)

    def __sub__(self, o):
        return self + -self._of(o)

    def __rsub__(self, o):
        return -self + o

    def __neg__(self):
        return Quadratic(-self.a, -self.b, self.d)

    def __mul__(self, o):
        o = self._of(o)
        return Quadratic(self.a * o.a + self.d * self.b * o.b, self.a * o.b + self.b * o.a, self.d)

    def __truediv__(self, o):
        o = self._of(o)
        norm = o.a * o.a - self.d * o.b * o.b
        return self * Quadratic(o.a / norm, -o.b / norm, self.d)

    def __rtruediv__(self, o):
        return self._of(o) / self

    def __eq__(self, o):
        o = self._of(o)
        return self.a == o.a and self.b == o.b

    def __bool__(self):
        return bool(self.a or self.b)

    def __str__(self):
        root = "I" if self.d == -1 else f"sqrt({self.d})"
        return f"({self.a}{'+' if self.b >= 0 else ''}{self.b}*{root})"

    __radd__, __rmul__ = __add__, __mul__


def trimmed(f):
    f = list(f)
    while f and not f[-1]:
        f.pop()
    return f


def poly(*coefficients):
    return trimmed(Fraction(c) if isinstance(c, (int, str)) else c for c in coefficients)


Z = poly(0, 1)


def add(f, g):
    if len(f) < len(g):
        f, g = g, f
    return trimmed([c + g[i] if i < len(g) else c for i, c in enumerate(f)])


def scale(f, c):
    return trimmed([c * x for x in f])


def mul(f, g):
    h = [Fraction(0)] * max(0, len(f) + len(g) - 1)
    for i, a in enumerate(f):
        if a:
            for j, b in enumerate(g):
                h[i + j] = h[i + j] + a * b
    return trimmed(h)


def power(f, n):
    p = poly(1)
    for _ in range(n):
        p = mul(p, f)
    return p


def derivative(f):
    return trimmed([i * c for i, c in enumerate(f)][1:])


def divrem(f, g):
    f, quotient = list(f), [Fraction(0)] * max(0, len(f) - len(g) + 1)
    for i in reversed(range(len(quotient))):
        c = quotient[i] = f[i + len(g) - 1] / g[-1]
        if c:
            for j, b in enumerate(g):
                f[i + j] = f[i + j] - c * b
    return trimmed(quotient), trimmed(f)


MERSENNE = tuple(2**e - 1 for e in (127, 521, 2203, 9689, 44497))


def reconstructed(c, p):
    """n/d = c modulo p with n, d < sqrt(p/2), or None."""
    r0, r1, t0, t1 = p, c, 0, 1
    while 2 * r1 * r1 > p:
        q = r0 // r1
        r0, r1, t0, t1 = r1, r0 - q * r1, t1, t0 - q * t1
    return Fraction(r1, t1) if t1 and 2 * t1 * t1 <= p else None


def modular_gcd(f, g, p):
    """The monic gcd modulo p, or None at a bad prime."""
    if any(c.denominator % p == 0 for c in f + g) or f[-1].numerator % p == 0 or g[-1].numerator % p == 0:
        return None
    f, g = ([c.numerator * pow(c.denominator, -1, p) % p for c in h] for h in (f, g))
    while g:
        lead = pow(g[-1], -1, p)
        g = [c * lead % p for c in g]
        while len(f) >= len(g):
            c, shift = f[-1], len(f) - len(g)
            for j, b in enumerate(g):
                f[shift + j] = (f[shift + j] - c * b) % p
            f = trimmed(f)
        f, g = g, f
    return f


def gcd(f, g):
    """Monic.  Over Q modulo a large prime: the degree there is no smaller, and what divides both is it."""
    if f and g and all(isinstance(c, Fraction) for c in f + g):
        for p in MERSENNE:
            h = modular_gcd(f, g, p)
            if h is not None and len(h) == 1:
                return poly(1)
            h = h and [reconstructed(c, p) for c in h]
            if h and None not in h and not divrem(f, h)[1] and not divrem(g, h)[1]:
                return h
    while g:
        f, g = g, divrem(f, g)[1]
        if g:
            g = scale(g, 1 / g[-1])
    return scale(f, 1 / f[-1]) if f else f


def product(factors):
    p = poly(1)
    for f in factors:
        p = mul(p, f)
    return p


class Rational:
    """num/den in lowest terms."""

    def __init__(self, num, den=None):
        den = den or poly(1)
        g = gcd(den, num) if num else den
        if len(g) > 1:
            num, den = divrem(num, g)[0], divrem(den, g)[0]
        self.num, self.den = scale(num, 1 / den[-1]), scale(den, 1 / den[-1])

    def __add__(self, o):
        return Rational(add(mul(self.num, o.den), mul(o.num, self.den)), mul(self.den, o.den))

    def __sub__(self, o):
        return self + o * -1

    def __mul__(self, o):
        if not isinstance(o, Rational):
            return Rational(scale(self.num, o), self.den)
        return Rational(mul(self.num, o.num), mul(self.den, o.den))

    def __truediv__(self, o):
        return Rational(mul(self.num, o.den), mul(self.den, o.num))

    def derivative(self):
        n, d = self.num, self.den
        return Rational(add(mul(derivative(n), d), scale(mul(n, derivative(d)), -1)), mul(d, d))

    def after(self, f):
        """self(f)."""
        d = max(len(self.num), len(self.den)) - 1

        def homogeneous(p):
            total = []
            for i, c in enumerate(p):
                total = add(total, scale(mul(power(f.num, i), power(f.den, d - i)), c))
            return total

        return Rational(homogeneous(self.num), homogeneous(self.den))

    def __str__(self):
        den = text(self.den)
        return f"({text(self.num)})" + ("" if den == "1" else f"/({den})")


def text(f):
    """Descending powers of z."""
    terms = []
    for i in reversed(range(len(f))):
        c, z = f[i], ("", "*z", f"*z^{i}")[min(i, 2)]
        if not c:
            continue
        if isinstance(c, Quadratic):
            c, sign = str(c), "+"
        else:
            sign, c = ("-" if c < 0 else "+"), str(abs(c))
        terms.append(sign + (z[1:] if c == "1" and z else c + z))
    return "".join(terms).lstrip("+") or "0"
