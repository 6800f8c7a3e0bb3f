"""Exact arithmetic: polynomials over a number field K = Q[x]/(m); modular.py has those modulo a prime."""
import decimal
from fractions import Fraction
from math import ceil, gcd, isqrt, lcm

from modular import is_prime, madd, mdiff, mdivmod, meval, mgcd, mpow, power, trim

# ---- K[z] -----------------------------------------------------------------------------------------------------------

class K:
    """The field Q[x]/(m), of degree d; an element is a block of s = 2d - 1 integers: room for one product."""
    m, d, s = [0, 1], 1, 1


def convolve(a, b):
    """The product in Z[x]; of long polynomials as one product of two large integers (Kronecker)."""
    n, short = max(0, len(a) + len(b) - 1), min(len(a), len(b))
    if short < 9:
        c = [0] * n
        for i, x in enumerate(a if len(a) == short else b):
            if x:
                c[i:] = [u + x * v for u, v in zip(c[i:], b if len(a) == short else a)] + c[i + n - short + 1:]
        return c if short else []
    # |c_i| < 10^width/2; decimal has a fast product of long numbers, int has not
    width = (sum(max(map(abs, v)).bit_length() for v in (a, b)) + short.bit_length()) * 302 // 1000 + 2

    def pack(v, sign):
        return decimal.Decimal("".join(str(max(0, sign * x)).zfill(width) for x in reversed(v)))
    with decimal.localcontext(decimal.Context(prec=decimal.MAX_PREC, Emax=decimal.MAX_EMAX)):
        value = (pack(a, 1) - pack(a, -1)) * (pack(b, 1) - pack(b, -1))
        digits = str(value + decimal.Decimal(("5" + "0" * (width - 1)) * n)).zfill(width * n)
    half = 5 * 10**(width - 1)                 # was added to each c_i, so that no digit is borrowed
    return [int(digits[i:i + width]) - half for i in range(width * (n - 1), -1, -width)]


def reduce_blocks(c):
    """Each block modulo m."""
    for start in range(0, len(c) if K.d > 1 else 0, K.s):
        for i in range(min(start + K.s, len(c)) - 1, start + K.d - 1, -1):
            top, c[i] = c[i], 0
            for j in range(K.d if top else 0):
                c[i - K.d + j] -= top * K.m[j]
    return trim(c)


class Poly:
    """A polynomial over K: integers c over one denominator q > 0; the coefficient of z^i is c[i s : i s + d]."""

    def __init__(self, c, q=1):
        g = gcd(q, *c) if q > 1 else 1
        self.c, self.q = trim([x // g for x in c] if g > 1 else c), q // g

    def __add__(self, o):
        q = lcm(self.q, o.q)
        f, g, c = q // self.q, q // o.q, [0] * max(len(self.c), len(o.c))
        for i, x in enumerate(self.c):
            c[i] = f * x
        for i, x in enumerate(o.c):
            c[i] += g * x
        return Poly(c, q)

    def __sub__(self, o):
        return self + o * -1

    def __mul__(self, o):
        if isinstance(o, Poly):
            return Poly(reduce_blocks(convolve(self.c, o.c)), self.q * o.q)
        o = Fraction(o)
        return Poly([o.numerator * x for x in self.c], self.q * o.denominator)

    def __pow__(self, e):
        return power(self, e) if e else ONE

    def __eq__(self, o):
        return not (self - o).c

    def degree(self):
        return (len(self.c) + K.s - 1) // K.s - 1

    def coefficient(self, i):
        return Poly(self.c[i * K.s:i * K.s + K.d] if i >= 0 else [], self.q)

    def lead(self):
        return self.coefficient(self.degree())

    def blocks(self):
        """The numerators of each coefficient"""
        return [self.c[i:i + K.d] for i in range(0, len(self.c), K.s)]

    def image(self, a, p):
        """Modulo a prime p that does not divide the denominator, the generator at a"""
        return madd([], [meval(block, a, p) for block in self.blocks()], p, pow(self.q, -1, p))

    def cut(self, n):
        """modulo z^n"""
        return Poly(self.c[:n * K.s], self.q)

    def reverse(self, n):
        """z^n f(1/z), deg f <= n"""
        c = self.c + [0] * ((n + 1) * K.s - len(self.c))
        return Poly([x for i in range(n, -1, -1) for x in c[i * K.s:(i + 1) * K.s]], self.q)

    def diff(self):
        return Poly([x * (i // K.s) for i, x in enumerate(self.c)][K.s:], self.q)

    def rational(self):
        """The value of a constant in Q, else None."""
        return Fraction(sum(self.c), self.q) if len(self.c) <= 1 else None

    def taylor(self, i):
        """The i-th derivative divided by i!."""
        c, b = [], 1
        for k in range(i, self.degree() + 1):
            c += [b * x for x in self.c[k * K.s:(k + 1) * K.s]]
            b = b * (k + 1) // (k + 1 - i)
        return Poly(c, self.q)

    def bits(self):
        """Of the largest numerator and of the denominator."""
        return max(map(abs, self.c), default=0).bit_length() + self.q.bit_length()


ZERO, ONE = Poly([]), Poly([1])


def from_rows(rows):
    """The coefficients of 1, z, ... as lists of rational numbers"""
    q = lcm(1, *(x.denominator for row in rows for x in row))
    return Poly([x for row in rows for x in [int(y * q) for y in row] + [0] * (K.s - len(row))], q)


def division(f, q):
    """Quotient and remainder by the monic q; 1/q at infinity by Newton's iteration."""
    n, m, inverse, size = f.degree(), q.degree(), ONE, 1
    if n < m:
        return ZERO, f
    while size < n - m + 1:
        size = min(2 * size, n - m + 1)
        inverse = (inverse * (ONE * 2 - q.reverse(m).cut(size) * inverse).cut(size)).cut(size)
    quotient = (f.reverse(n).cut(n - m + 1) * inverse).cut(n - m + 1).reverse(n - m)
    return quotient, f - quotient * q


def product(polys):
    """By halves."""
    polys = list(polys) or [ONE]
    while len(polys) > 1:
        polys = [a * b for a, b in zip(polys[::2], polys[1::2] + [ONE])]
    return polys[0]


# ---- square roots, roots, the field --------------------------------------------------------------------------------

def exact_sqrt(x):
    s = isqrt(max(0, x.numerator * x.denominator))
    return Fraction(s, x.denominator) if s * s == x.numerator * x.denominator else None


def sqrt_above(x):
    """A rational number >= Re sqrt(x) (docs/theory/local_exponents.md 4)."""
    s = exact_sqrt(max(x, Fraction(0)))
    return s if s is not None else Fraction(isqrt((x.numerator * x.denominator) << 64) + 1, x.denominator << 32)


def root_bound(c):
    """B >= |T| for every complex root T of sum c_i T^i: |c_n| B^n >= sum over i < n of |c_i| B^i (Cauchy)."""
    c = [abs(x) for x in c]
    if not any(c[:-1]):
        return Fraction(0)

    def holds(b):
        return c[-1] * b**(len(c) - 1) >= sum(x * b**i for i, x in enumerate(c[:-1]))
    k = ceil(1 + max(c[:-1]) / c[-1]).bit_length()
    if k >= 4096:
        raise ValueError("the roots are too large")
    while k > -64 and holds(Fraction(2)**(k - 1)):
        k -= 1
    low, high = Fraction(2)**(k - 1), Fraction(2)**k
    for _ in range(8):
        mid = (low + high) / 2
        low, high = (low, mid) if holds(mid) else (mid, high)
    return high


def irreducible(m):
    """Is the monic m in Z[x] proved irreducible over Q?  (docs/theory/certificates.md 3)  Either the degrees of its
    factors modulo some primes leave no degree for a factor over Q, or |m(n)| is k times a prime for some
    n > k + (all roots)."""
    degrees = set(range(1, len(m) - 1))
    for p in filter(is_prime, range(3, 600)):
        f, x, k, sums = [c % p for c in m], [0, 1], 0, {0}
        if len(mgcd(f, mdiff(f, p), p)) != 1:
            continue
        while len(f) > 1:                   # g: the product of the irreducible factors of degree k
            k, x = k + 1, mpow(x, p, f, p)
            g = mgcd(f, madd(x, [0, 1], p, -1), p)
            for _ in range((len(g) - 1) // k):
                sums |= {i + k for i in sums}
            f = mdivmod(f, g, p)[0]
            x = mdivmod(x, f, p)[1] if len(f) > 1 else x
        degrees &= sums
        if not degrees:
            return True
    far = ceil(root_bound([Fraction(c) for c in m]))
    values = ((n, abs(sum(c * n**i for i, c in enumerate(m)))) for n in range(far + 2, far + 2000))
    return any(v % k == 0 and is_prime(v // k) for n, v in values for k in range(1, min(50, n - far)))
