#!/usr/bin/env python3
"""Independent checker for kovacic-certificate/1 (Python 3 standard library only).

A certificate proves a statement about the differential Galois group G of y'' = r(z) y; the format and the theorem behind
each rule are in docs/theory.  usage: kovacic_verify.py [--strict] FILE|-     exit 0 accepted, 1 rejected, 2 malformed.
"""
import json
import re
import sys
from fractions import Fraction
from math import gcd, isqrt, lcm

LIMIT = 4 * 10**9     # elementary operations that one step may ask for
SIZE = 200001         # coefficients of one polynomial


class Malformed(Exception):
    pass


class Rejected(Exception):
    pass


def need(condition, why):
    if not condition:
        raise Rejected(why)


# ---- Z[x] as ascending lists of integers -------------------------------------------------------------------------------

def trim(a):
    while a and not a[-1]:
        a.pop()
    return a


def imul(a, b):
    """Product; long factors by Kronecker substitution (one multiplication of big integers)."""
    if not a or not b:
        return []
    if min(len(a), len(b)) <= 6:
        if len(a) > len(b):
            a, b = b, a
        c = [0] * (len(a) + len(b) - 1)
        for i, x in enumerate(a):
            if x:
                for j, y in enumerate(b, i):
                    c[j] += x * y
        return c
    bits = max(map(abs, a)).bit_length() + max(map(abs, b)).bit_length() + min(len(a), len(b)).bit_length() + 2
    n = bits // 8 + 1
    bias, unit = 1 << (8 * n - 1), bytes(n - 1) + b"\x80"

    def pack(v):
        return int.from_bytes(b"".join((x + bias).to_bytes(n, "little") for x in v), "little") - int.from_bytes(unit * len(v), "little")
    size = len(a) + len(b) - 1
    s = (pack(a) * pack(b) + int.from_bytes(unit * size, "little")).to_bytes(n * size + 1, "little")
    return [int.from_bytes(s[i:i + n], "little") - bias for i in range(0, n * size, n)]


# ---- K[z], K = Q[x]/(m): integers in blocks of length 2d-1 (room for one product) over one denominator -------------------

class Field:
    d, s, m = 1, 1, [0, 1]


K = Field()


def reduce_blocks(c):
    if K.d > 1:
        for start in range(0, len(c), K.s):
            for i in range(min(start + K.s, len(c)) - 1, start + K.d - 1, -1):
                if c[i]:
                    for j in range(K.d):
                        c[i - K.d + j] -= c[i] * K.m[j]
                    c[i] = 0
    return trim(c)


class Poly:
    """Polynomial over K; Poly(c, q) takes ownership of the flat list c and the denominator q > 0."""
    __slots__ = ("c", "q")

    def __init__(self, c, q=1):
        g = q
        for x in c:
            if g == 1:
                break
            g = gcd(g, x)
        self.c, self.q = (c, q) if g == 1 else ([x // g for x in c], q // g)
        trim(self.c)

    def __add__(self, o):
        q = lcm(self.q, o.q)
        f, g, n = q // self.q, q // o.q, max(len(self.c), len(o.c))
        c = [f * x for x in self.c] + [0] * (n - len(self.c))
        for i, x in enumerate(o.c):
            c[i] += g * x
        return Poly(c, q)

    def __sub__(self, o):
        return self + o.scale(-1)

    def __mul__(self, o):
        return Poly(reduce_blocks(imul(self.c, o.c)), self.q * o.q)

    def __pow__(self, e):
        r, b = ONE, self
        while e:
            r, b, e = r * b if e & 1 else r, b * b if e > 1 else b, e >> 1
        return r

    def scale(self, f):
        f = Fraction(f)
        return Poly([f.numerator * x for x in self.c], self.q * f.denominator)

    def deg(self):
        return (len(self.c) + K.s - 1) // K.s - 1

    def coeff(self, i):
        return Poly(self.c[i * K.s:i * K.s + K.d] if i >= 0 else [], self.q)

    def lead(self):
        return self.coeff(self.deg())

    def diff(self):
        return Poly([x * (i // K.s) for i, x in enumerate(self.c)][K.s:], self.q)

    def zero(self):
        return not self.c

    def __eq__(self, o):
        return (self - o).zero()

    def rational(self):
        """The value of a constant in Q, or None."""
        return Fraction(self.c[0] if self.c else 0, self.q) if len(self.c) <= 1 else None

    def at(self, x):
        """Value at a rational number x."""
        v = ZERO
        for i in range(self.deg(), -1, -1):
            v = v.scale(x) + self.coeff(i)
        return v

    def shift_coeff(self, i):
        """The i-th derivative divided by i!."""
        c, s = self.c, K.s
        out, b = [], 1
        for k in range(i, self.deg() + 1):
            out += [b * x for x in c[k * s:k * s + s]]
            b = b * (k + 1) // (k + 1 - i)
        return Poly(out, self.q)


ZERO, ONE = Poly([]), Poly([1])


def division(f, q):
    """Quotient and remainder by the monic q, of degree >= 1: z is scaled by q's denominator w, then all is integral."""
    n, m, s, d, w = f.deg(), q.deg(), K.s, K.d, q.q
    if n < m:
        return ZERO, f
    top = w**n
    a, scale = [], top
    for i in range(n + 1):
        a.append([x * scale for x in (f.c[i * s:i * s + d] + [0] * d)[:d]])
        scale //= w
    b = [Poly(q.c[i * s:i * s + d]).scale(w**(m - i - 1)).c for i in range(m)]
    for i in range(n, m - 1, -1):
        if any(a[i]):
            for j in range(m):
                if b[j]:
                    row = a[i - m + j]
                    for k, x in enumerate([a[i][0] * b[j][0]] if d == 1 else reduce_blocks(imul(a[i], b[j]))):
                        row[k] -= x

    def back(rows, power):
        out, scale = [], power
        for row in rows:
            out += [x * scale for x in row] + [0] * (s - d)
            scale *= w
        return out
    return Poly(back(a[m:], w**m), f.q * top), Poly(back(a[:m], 1), f.q * top)


def rem(f, q):
    if q.deg() == 1 and K.d == 1:          # Horner at u/w
        u, v, w, power = -q.c[0], 0, q.q, 1
        for x in reversed(f.c):
            v, power = v * u + x * power, power * w
        return Poly([v], f.q * max(1, power // w))
    return division(f, q)[1]


def divides(q, f):
    return rem(f, q).zero() if q.deg() > 0 else not q.zero()


def quotient(f, q):
    return division(f, q)[0] if q.deg() > 0 else f


def product(polys):
    polys = list(polys) or [ONE]
    while len(polys) > 1:
        polys = [a * b for a, b in zip(polys[::2], polys[1::2] + [ONE])]
    return polys[0]


# ---- F_p[z]: ascending lists ---------------------------------------------------------------------------------------------

def madd(a, b, p, f=1):
    n = max(len(a), len(b))
    return trim([(x + f * y) % p for x, y in zip(a + [0] * (n - len(a)), b + [0] * (n - len(b)))])


def mmul(a, b, p, n=None):
    """Product mod p, truncated to n terms."""
    if n is not None:
        a, b = a[:n], b[:n]
    return trim([x % p for x in imul(a, b)[:n]])


def mdiff(a, p):
    return trim([i * x % p for i, x in enumerate(a)][1:])


def mdivmod(a, b, p):
    a, m, u = a[:], len(b) - 1, pow(b[-1], -1, p)
    quotient = [0] * max(0, len(a) - m)
    for i in range(len(a) - 1, m - 1, -1):
        f = a[i] * u % p
        quotient[i - m] = f
        if f:
            a[i - m:i] = [(x - f * y) % p for x, y in zip(a[i - m:i], b)]
    return trim(quotient), trim(a[:m])


def mgcd(a, b, p):
    while b:
        a, b = b, mdivmod(a, b, p)[1]
    return [x * pow(a[-1], -1, p) % p for x in a] if a else a


def minv(a, q, p):
    """a^-1 modulo q, or Rejected."""
    r0, r1, s0, s1 = q, mdivmod(a, q, p)[1], [], [1]
    while r1:
        t, r = mdivmod(r0, r1, p)
        r0, r1, s0, s1 = r1, r, s1, madd(s0, mmul(t, s1, p), p, -1)
    need(len(r0) == 1, "an element is not invertible modulo p")
    return mdivmod([x * pow(r0[0], -1, p) % p for x in s0], q, p)[1]


def mpow(a, e, q, p):
    r = mdivmod([1], q, p)[1]
    while e:
        if e & 1:
            r = mdivmod(mmul(r, a, p), q, p)[1]
        a, e = mdivmod(mmul(a, a, p), q, p)[1], e >> 1
    return r


def mshift(a, c, p):
    """a(z + c): divide and conquer."""
    if len(a) <= 32:
        a = a[:]
        for i in range(len(a)):
            for j in range(len(a) - 2, i - 1, -1):
                a[j] = (a[j] + c * a[j + 1]) % p
        return a
    h = len(a) // 2
    power, base, e = [1], [c, 1], h
    while e:
        power, base, e = mmul(power, base, p) if e & 1 else power, mmul(base, base, p) if e > 1 else base, e >> 1
    return madd(mshift(a[:h], c, p), mmul(mshift(a[h:], c, p), power, p), p)


def mseries(a, p, n):
    """1/a modulo z^n."""
    b, k = [pow(a[0], -1, p)], 1
    while k < n:
        k = min(2 * k, n)
        t = [-x % p for x in mmul(a, b, p, k)] or [0]
        t[0] = (t[0] + 2) % p
        b = mmul(b, t, p, k)
    return b[:n]


def meval(a, x, p):
    v = 0
    for y in reversed(a):
        v = (v * x + y) % p
    return v


def is_square(b, p):
    """Is b, not 0, a constant times a square in F_p[z], p odd?"""
    if len(b) % 2 == 0:
        return False
    n, u = len(b) // 2, pow(b[-1], -1, p)
    rev = [x * u % p for x in reversed(b)]
    root, half = [1], pow(2, -1, p)
    while len(root) < n + 1:                                   # Newton: root = (root + rev/root)/2
        k = min(2 * len(root), n + 1)
        root = madd(root, mmul(rev, mseries(root, p, k), p, k), p)
        root = [x * half % p for x in root] + [0] * (k - len(root))
    return trim(mmul(root, root, p)) == trim(rev)


def is_prime(n):
    if n < 41 or any(n % q == 0 for q in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)):
        return n in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
    s = (n - 1 & 1 - n).bit_length() - 1
    for b in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37):     # proves primality below 3.3e24
        x = pow(b, n - 1 >> s, n)
        if x != 1 and not any(pow(x, 1 << i, n) == n - 1 for i in range(s)):
            return False
    return True


def irreducible(m):
    """Is the monic integer polynomial m irreducible over Q?  Factors modulo a large prime are recombined."""
    d = len(m) - 1
    if d == 1:
        return True
    p = 2**(d + 2) * (isqrt(sum(x * x for x in m)) + 1) | 1     # twice Mignotte's bound
    while True:
        p += 2
        f = [x % p for x in m]
        if is_prime(p) and len(mgcd(f, mdiff(f, p), p)) == 1:
            break
        if p > 2**81:
            raise Rejected("the field is too large")
    parts, k, x = [], 0, [0, 1]
    while len(f) > 1:                                           # distinct degrees, then equal degrees
        k, x = k + 1, mpow(x, p, f, p)
        g, seed = mgcd(f, madd(x, [0, 1], p, -1), p), 1
        todo = [g] if len(g) > 1 else []
        while todo:
            g = todo.pop()
            if len(g) - 1 == k:
                parts.append(g)
                f = mdivmod(f, g, p)[0]
                continue
            seed += 1
            t = mpow([seed * seed + i * seed + 1 for i in range(len(g) - 1)], (p**k - 1) // 2, g, p)
            h = mgcd(g, madd(t, [1], p, -1), p)
            todo += [g] if len(h) in (0, 1, len(g)) else [h, mdivmod(g, h, p)[0]]
        x = mdivmod(x, f, p)[1] if len(f) > 1 else x
    for mask in range(1, 2**len(parts) - 1):
        g = [1]
        for i, part in enumerate(parts):
            g = mmul(g, part, p) if mask >> i & 1 else g
        g = [y - p if 2 * y > p else y for y in g]
        a = m[:]
        for i in range(d, len(g) - 2, -1):
            top = a[i]
            for j, y in enumerate(g):
                a[i - len(g) + 1 + j] -= top * y
        if not any(a):
            return False
    return True


# ---- reading: a schema says what each key holds; '?' marks optional keys ---------------------------------------------------

PRIME = {"p": "int", "a": "res"}
LOG = {"p": "int", "a": "res", "roots?": ["res"]}
RULES = {
    "local": {"prime": PRIME, "places": [{"q": "poly", "order": "int", "delta2?": "poly", "eps2?": "poly", "irrational?": PRIME,
                                          "log?": LOG, "annihilator?": "poly"}],
              "infinity": {"eps2?": "poly", "log?": LOG, "annihilator?": "poly"}},
    "exponential": {"p": "poly", "num": "poly", "den": "poly"},
    "invariant": {"prime": PRIME, "m": "int", "p": "poly", "factors": [{"q": "poly", "e": "rat"}]},
    "no-exponential": {"by": "str", "place?": "str", "p?": "int", "a?": "res", "root?": "res", "delta?": "res", "terms?": "int",
                       "lines?": [{"length": "int", "approximant": ["res"]}]},
    "p-curvature": {"p": "int", "a": "res", "shows": "str"},
    "no-invariant": {"m": "int", "by": "str", "p?": "int", "a?": "res", "x0?": "res", "terms?": "int"},
    "torsion-function": {"n": "int", "a": "poly", "b": "poly", "den": "poly", "minimal": [
        {"l": "int", "p": "int", "a": "res", "w": "res", "x1": "res", "s1": "res", "x2": "res", "s2": "res"}]},
    "jacobian": {"p": "int", "a": "res", "w": "res", "multiple": "int", "branch?": "res"},
    "conclude": {"theorem": "str"},
    "apply-theorem": {"theorem": "str", "statement": "str"},
}
INTEGER = re.compile(r"(0|-?[1-9][0-9]{0,199999})\Z")
RATIONAL = re.compile(r"(0|-?[1-9][0-9]{0,199999})(/[1-9][0-9]{0,199999})?\Z")


def is_text(v, pattern=None):
    return isinstance(v, str) and (pattern is None or pattern.match(v))


def read(kind, v, path):
    def bad(what):
        raise Malformed(f"{path}: {what}")
    if isinstance(kind, dict):
        if not isinstance(v, dict):
            bad("an object is expected")
        names = {k.rstrip("?"): k for k in kind}
        for k in v:
            if k not in names:
                bad(f"unknown key {k!r}")
        for k, full in names.items():
            if k not in v and full == k:
                bad(f"key {k!r} is missing")
        return {k: read(kind[full], v[k], f"{path}.{k}") if k in v else None for k, full in names.items()}
    if isinstance(kind, list):
        if not isinstance(v, list) or len(v) > SIZE:
            bad("an array is expected")
        return [read(kind[0], x, f"{path}[{i}]") for i, x in enumerate(v)]
    if kind == "poly":
        if not isinstance(v, list) or len(v) > SIZE:
            bad("a polynomial is expected")
        return read_poly(v, bad)
    if kind == "str":
        return v if isinstance(v, str) else bad("a string is expected")
    if not is_text(v, RATIONAL if kind == "rat" else INTEGER):
        bad("a number in a string is expected")
    if kind == "rat":
        return Fraction(v)
    n = int(v)
    if kind == "res" and not 0 <= n < 2**62:
        bad("a residue is expected")
    return n


def read_poly(v, bad):
    rows = []
    for x in v:
        row = x if isinstance(x, list) else [x]
        if not 1 <= len(row) <= K.d or not all(is_text(y, RATIONAL) for y in row):
            bad("an element of the field is expected")
        rows.append([Fraction(y) for y in row])
    if rows and not any(rows[-1]):
        bad("the leading coefficient is 0")
    q = lcm(*(y.denominator for row in rows for y in row)) if rows else 1
    return Poly([y for row in rows for y in [z.numerator * (q // z.denominator) for z in row] + [0] * (K.s - len(row))], q)


def unique(pairs):
    d = dict(pairs)
    if len(d) < len(pairs):
        raise Malformed("a key occurs twice")
    return d


def load(text):
    def no_number(_):
        raise Malformed("numbers must be strings")
    try:
        top = json.loads(text, object_pairs_hook=unique, parse_int=no_number, parse_float=no_number, parse_constant=no_number)
    except (ValueError, RecursionError) as error:
        raise Malformed(f"not JSON: {str(error)[:80]}") from None
    if not isinstance(top, dict) or top.get("format") != "kovacic-certificate/1":
        raise Malformed("format: not a kovacic-certificate/1")
    if sorted(top) != ["claim", "field", "format", "r", "steps"]:
        raise Malformed("the keys must be format, field, r, claim, steps")
    K.d, K.s = 1, 1
    m = read({"name": "str", "minpoly": ["int"]}, top["field"], "field")["minpoly"]
    if not 2 <= len(m) <= 25 or m[-1] != 1 or (len(m) == 2 and m[0] != 0):
        raise Malformed("field.minpoly: a monic polynomial of degree 1 (z itself) to 24 is expected")
    K.m, K.d, K.s = m, len(m) - 1, 2 * len(m) - 3
    r = read({"num": "poly", "den": "poly"}, top["r"], "r")
    claim = top["claim"]
    if not isinstance(claim, dict) or sorted(claim) != ["abelian", "component", "group", "n"]:
        raise Malformed("claim: the keys must be group, n, component, abelian")
    if not all(v is None or isinstance(v, bool if k == "abelian" else str) for k, v in claim.items()):
        raise Malformed("claim: strings, null, or a truth value are expected")
    if claim["n"] is not None:
        claim["n"] = read("int", claim["n"], "claim.n")
    steps = []
    if not isinstance(top["steps"], list) or not 1 <= len(top["steps"]) <= 1000:
        raise Malformed("steps: an array is expected")
    for i, s in enumerate(top["steps"]):
        if not isinstance(s, dict) or sorted(s) != ["data", "id", "premises", "rule"] or not is_text(s["id"]):
            raise Malformed(f"steps[{i}]: the keys must be id, rule, premises, data")
        if not is_text(s["rule"]) or s["rule"] not in RULES:
            raise Malformed(f"steps[{i}]: unknown rule")
        premises = read(["str"], s["premises"], f"steps[{i}].premises")
        steps.append((s["id"], s["rule"], premises, read(RULES[s["rule"]], s["data"], f"steps[{i}].data")))
    return r["num"], r["den"], claim, steps


# ---- local data: docs/theory/local_exponents.md ----------------------------------------------------------------------------

def sqrt_exact(x):
    s = isqrt(x.numerator * x.denominator) if x >= 0 else 0
    return Fraction(s, x.denominator) if x >= 0 and s * s == x.numerator * x.denominator else None


def sqrt_above(x):
    """A rational number >= Re sqrt(x)."""
    if x < 0:
        return Fraction(0)
    return sqrt_exact(x) or Fraction(isqrt((x.numerator * x.denominator) << 64) + 1, x.denominator << 32) if x else Fraction(0)


def root_bound(chi):
    """B >= |T| for every complex root T of chi in Q[T]: Cauchy's criterion |c_n| B^n >= sum |c_i| B^i."""
    need(chi.deg() >= 1, "the annihilator is constant")
    c = [chi.coeff(i).rational() for i in range(chi.deg() + 1)]
    need(None not in c, "the annihilator is not over Q")
    c = [abs(x) for x in c]
    if not any(c[:-1]):
        return Fraction(0)

    def holds(b):
        v = Fraction(0)
        for x in reversed(c[:-1]):
            v = v * b + x
        return c[-1] * b**(len(c) - 1) >= v
    k = (1 + max(c[:-1]) / c[-1]).__ceil__().bit_length()
    need(k < 4096, "the annihilator is too large")
    while k > -64 and holds(Fraction(2)**(k - 1)):
        k -= 1
    low, high = Fraction(2)**(k - 1), Fraction(2)**k
    for _ in range(8):
        mid = (low + high) / 2
        low, high = (low, mid) if holds(mid) else (mid, high)
    return high


class Place:
    """n conjugate points with the same data; order is that of the pole of r (at infinity: of r(1/t)/t^4 at t = 0)."""

    def __init__(self, q, n, order):
        self.q, self.n, self.order = q, n, order
        self.delta, self.irrational, self.logs, self.real = None, False, 0, None   # real: bound of |Re Delta| or |Re eps|
        if order <= 1:
            self.delta, self.logs = Fraction(1), n if order == 1 else 0

    def set_square(self, value, annihilator):
        """value: Delta^2 (order 2) or eps^2 (even order >= 4), a polynomial in c."""
        c = value.rational()
        if self.order == 2:
            self.delta = sqrt_exact(c) if c is not None else None
            self.irrational |= value.deg() <= 0 and self.delta is None
            self.logs = self.n if self.delta == 0 else 0
        if c is not None:
            self.real = sqrt_above(c)
        elif annihilator is not None:
            v = ZERO
            need(annihilator.deg() <= 500, "the annihilator is too large")
            for i in range(annihilator.deg(), -1, -1):
                v = v * value
                v = (rem(v, self.q) if self.q is not None else v) + annihilator.coeff(i)
            need(v.zero(), "the annihilator does not vanish")
            self.real = sqrt_above(root_bound(annihilator))

    def ramified(self):
        return self.order >= 3 and self.order % 2 == 1

    def infinite_order(self):
        return self.order >= 3 or self.irrational

    def half(self):
        """May two lines be exchanged around this place?"""
        return self.ramified() or self.order == 2 and not self.irrational and (self.delta is None or self.delta.denominator == 2)

    def lowest(self, m):
        """Lower bound for the sum of the orders, over the n points, of a rational solution of Sym^m (m even); None: there is none."""
        if self.order <= 0:
            return 0
        if self.order >= 3:
            return None if m * self.order % 4 else self.n * (m * self.order // 4)
        if self.irrational:
            return self.n * (m // 2)
        need(self.delta is not None, "a degree bound needs the exponent difference of every place")
        i = m // 2 // self.delta.denominator * self.delta.denominator
        return self.n * int(m // 2 + (m // 2 if self.logs == self.n else -i) * self.delta)

    def lowest_exponent(self):
        """Lower bound for the sum of the real parts of the exponents of y'/y = omega in K(z)."""
        if self.order <= 1:
            return Fraction(self.n if self.order == 1 else 0)
        need(self.real is not None, "D_1 needs delta2 or eps2 (and an annihilator, if it is not rational)")
        if self.order >= 4:
            return self.n * (self.order // 2 - self.real) / 2
        return self.n * (1 + (1 if self.logs == self.n else -1) * self.real) / 2


class Local:
    def __init__(self, places, infinity):
        self.places, self.infinity, self.all = places, infinity, places + [infinity]

    def infinite_order(self):
        return any(x.infinite_order() for x in self.all)

    def rational(self):
        need(all(x.order <= 2 and x.delta is not None for x in self.all), "not all exponent differences are proved rational")

    def degree_bound(self, m):
        e = [x.lowest(m) for x in self.all]
        return -1 if None in e else m - sum(e)

    def degree_bound_1(self):
        need(not any(x.ramified() for x in self.all), "use parity")
        return (1 - sum(x.lowest_exponent() for x in self.all)).__floor__()

    def residue_denominator(self, v):
        """Lcm of the denominators of Delta over the places where v does not branch."""
        self.rational()
        parts = [x for x in self.places if not divides(x.q, v.branch)]
        need(sum(x.n for x in self.places) - sum(x.n for x in parts) == v.branch.deg(), "the branch places are not places of their own")
        parts += [self.infinity] if v.branch.deg() % 2 == 0 else []
        return lcm(*(x.delta.denominator for x in parts))

    def order_of_character(self):
        self.rational()
        return lcm(*(((1 + x.delta) / 2).denominator for x in self.places))


class Invariant:
    """v = p * prod q^e; branch = F0, the product of the q with half-integer e."""

    def fraction(self):
        """v/sqrt(F0) = A/B."""
        need(all(abs(e.__floor__()) * q.deg() <= 200000 for q, e in self.factors), "an exponent is too large")
        return (product([self.p if s > 0 else ONE] + [q**(s * e.__floor__()) for q, e in self.factors if s * e.__floor__() > 0]) for s in (1, -1))

    def growth(self):
        return self.p.deg() + sum(q.deg() * e for q, e in self.factors)


class Curve:
    """A p-curvature, jacobian or torsion-function fact: plain attributes."""

    def __init__(self, **data):
        self.__dict__.update(data)


class Absent(Curve):
    """Sym^m has no rational solution."""


# ---- the rules -------------------------------------------------------------------------------------------------------------

class Checker:
    def __init__(self, num, den):
        self.num, self.den = num, den
        self.dn, self.dd = num.deg(), den.deg()

    def mod(self, f, p, a):
        """Image of f in F_p[z]; Rejected if f is not p-integral."""
        need(f.q % p, f"{p} divides a denominator")
        u = pow(f.q, -1, p)
        if K.d == 1:
            return trim([x * u % p for x in f.c])
        return trim([meval(f.c[i:i + K.d], a, p) * u % p for i in range(0, len(f.c), K.s)])

    def good(self, d):
        """A prime of degree one where r is integral with monic denominator; returns (p, a, num mod p, den mod p)."""
        p, a = d["p"], d["a"]
        need(p is not None and a is not None and 2 < p < 2**62 and is_prime(p), "p is not an odd prime below 2^62")
        need(a < p and meval(K.m, a, p) == 0, "a is not a root of the minimal polynomial modulo p")
        return p, a, self.mod(self.num, p, a), self.mod(self.den, p, a)

    def squarefree(self, f, d, other=None):
        """Is f squarefree (and coprime to other), seen modulo a prime?  f monic."""
        p, a = self.good(d)[:2]
        g = self.mod(f, p, a)
        need(len(mgcd(g, mdiff(g, p), p)) == 1, "not squarefree modulo p")
        if other is not None and not other.zero():
            need(len(mgcd(g, self.mod(other, p, a), p)) == 1, "a common factor modulo p")

    def expansion(self, p, a, num, den, root, order):
        """Numerator and denominator of t^order r at the root, as polynomials in t = z - root; both nonzero at 0."""
        if root is None:                       # t = 1/z, r(1/t)/t^4
            need(len(den) - len(num) == 4 - order, "the order at infinity changes modulo p")
            return num[::-1], den[::-1]
        need(root < p and meval(den, root, p) == 0, "not a root of the place modulo p")
        n, d = mshift(num, root, p), mshift(den, root, p)
        need(n and n[0] and len(d) > order and not any(d[:order]) and d[order], "the order of the pole changes modulo p")
        return n, d[order:]

    def riccati(self, n, d, order, s0, terms, p):
        """The solution S = t^nu omega, S_0 = s0, modulo t^terms; None when a logarithm forbids it."""
        nu = max(1, order // 2)
        need(terms * terms + terms * (len(n) + len(d)) <= LIMIT, "too many terms")
        r = mmul(n, mseries(d, p, terms), p, terms)
        r = ([0] * (2 * nu - order) + r + [0] * terms)[:terms]
        need((s0 * s0 - (s0 if nu == 1 else 0) - r[0]) % p == 0, "delta is not the square root that it should be")
        S, back = [s0], []                     # back: S[i-1], ..., S[1]
        for i in range(1, terms):
            h = (i + 1) // 2                   # sum of S_a S_(i-a), 0 < a < i, by symmetry
            conv = 2 * sum(map(int.__mul__, S[1:h], back[:h - 1]))
            conv += S[i // 2]**2 if i % 2 == 0 else 0
            rhs = r[i] - conv
            lead = 2 * s0
            if nu == 1:
                lead += i - 1
            elif i >= nu - 1:
                rhs -= (i - 2 * nu + 1) * S[i - nu + 1]
            lead, rhs = lead % p, rhs % p
            if not lead:
                need(rhs, "the expansion is not unique")
                return None
            S.append(rhs * pow(lead, -1, p) % p)
            back.insert(0, S[-1])
        return S

    def is_log(self, x, d, root, delta):
        p, a, num, den = self.good(d)
        need(delta is not None and delta.denominator == 1 and 1 <= delta < p, "a logarithm needs a natural exponent difference below p")
        n, e = self.expansion(p, a, num, den, root, 2)
        s0 = (1 - int(delta)) * pow(2, -1, p) % p
        need(self.riccati(n, e, 2, s0, int(delta) + 1, p) is None, "no logarithm is seen")

    def eps2(self, x, n, d, value):
        """(beta/a)^2 at an irregular place: n, d = Taylor coefficients in K[c]/q of numerator and denominator of t^(2nu) r."""
        nu = x.order // 2
        need(nu <= 200, "the order of the pole is too large")

        def red(f):
            return rem(f, x.q) if x.q is not None else f
        g = [ZERO] * nu
        for i in range(nu):
            for j in range(i + 1):
                g[i] = red(g[i] + n(j) * d(i - j))
        d0, tau, inv, gp, dp = d(0), [ONE], [ONE], [ONE], [ONE]
        for j in range(1, nu):
            gp.append(red(gp[-1] * g[0]))
            dp.append(red(dp[-1] * d0))
            t, s = g[j] * gp[j - 1], ZERO
            for i in range(1, j):
                t = t - tau[i] * tau[j - i]
            for i in range(1, j + 1):
                s = s - red(d(i) * dp[i - 1]) * inv[j - i]
            tau.append(red(t).scale(Fraction(1, 2)))
            inv.append(red(s))
        total = ZERO
        for i in range(nu):
            total = total + red(red(tau[i] * inv[nu - 1 - i]) * red(gp[nu - 1 - i] * dp[i]))
        both = red(gp[nu - 1] * dp[nu - 1])
        left = red(red(red(value * d0) * d0) * red(both * both))
        need(red(left - red(g[0] * red(total * total)).scale(4)).zero(), "eps2 is wrong")

    def check_local(self, d):
        num, den, places = self.num, self.den, []
        need(len(d["places"]) <= 20000, "too many places")
        need(all(e["q"].deg() >= 1 and e["q"].lead() == ONE for e in d["places"]), "a place is not a monic polynomial")
        need(all(1 <= e["order"] <= SIZE for e in d["places"]), "an order is not positive")
        need(sum(e["q"].deg() * e["order"] for e in d["places"]) == self.dd, "the degrees do not add up to deg den")
        need(product([e["q"]**e["order"] for e in d["places"]]) == den, "the product of the places is not den")
        radical = product([e["q"] for e in d["places"]])
        if radical.deg() > 0:
            self.squarefree(radical, d["prime"], num)
        den2 = den.diff().diff()
        for e in d["places"]:
            x = Place(e["q"], e["q"].deg(), e["order"])
            places.append(x)
            if e["delta2"] is not None:
                need(x.order == 2 and e["delta2"].deg() < x.n, "delta2 belongs to a pole of order 2")
                need(rem(rem(num, x.q).scale(8) - (e["delta2"] - ONE) * rem(den2, x.q), x.q).zero(), "delta2 is wrong")
                x.set_square(e["delta2"], e["annihilator"])
            if e["irrational"] is not None:
                need(x.order == 2, "irrational belongs to a pole of order 2")
                p, a, n, _ = self.good(e["irrational"])
                q, dd = self.mod(x.q, p, a), self.mod(den2, p, a)
                v = mdivmod(mmul(madd(dd, n, p, 8), minv(dd, q, p), p), q, p)[1]
                v = madd(mpow(v, (p + 1) // 2, q, p), v, p, -1)
                need(v and len(mgcd(v, q, p)) == 1, "irrationality is not seen modulo p")
                need(x.delta is None, "delta2 is a rational square")
                x.irrational = True
            if e["log"] is not None:
                roots = e["log"]["roots"] or []
                need(x.order == 2 and roots and len(set(roots)) == len(roots), "distinct roots are expected")
                p, a = self.good(e["log"])[:2]
                q = self.mod(x.q, p, a)
                for c in roots:
                    need(meval(q, c, p) == 0, "not a root of the place modulo p")
                    self.is_log(x, e["log"], c, x.delta)
                x.logs = len(roots)
            if e["eps2"] is not None:
                need(x.order >= 4 and x.order % 2 == 0 and e["eps2"].deg() < x.n, "eps2 belongs to a pole of even order >= 4")
                self.eps2(x, lambda i: rem(num.shift_coeff(i), x.q), lambda i: rem(den.shift_coeff(i + x.order), x.q), e["eps2"])
                x.set_square(e["eps2"], e["annihilator"])
        return Local(places, self.infinity(d["infinity"]))

    def infinity(self, d):
        x = Place(None, 1, 4 - (self.dd - self.dn) if self.dn >= 0 else 0)
        if x.order == 2:
            x.set_square(ONE + self.num.lead().scale(4), d["annihilator"])
        if d["log"] is not None:
            need(x.order == 2 and d["log"]["roots"] is None, "no logarithm to prove at infinity")
            self.is_log(x, d["log"], None, x.delta)
            x.logs = 1
        if d["eps2"] is not None:
            need(x.order >= 4 and x.order % 2 == 0 and d["eps2"].deg() < 1, "eps2 belongs to an irregular place")
            self.eps2(x, lambda i: self.num.coeff(self.dn - i), lambda i: self.den.coeff(self.dd - i), d["eps2"])
            x.set_square(d["eps2"], d["annihilator"])
        return x

    def check_exponential(self, d):
        P, n, e = d["p"], d["num"], d["den"]
        need(not P.zero() and not e.zero(), "omega is not defined")
        s = n.diff() * e - n * e.diff() + n * n
        left = e * e * P.diff().diff() + (n * e).scale(2) * P.diff() + s * P
        need(self.den * left == self.num * (e * e) * P, "omega' + omega^2 is not r")
        return "exponential"

    def check_invariant(self, d):
        x, m, P = Invariant(), d["m"], d["p"]
        need(1 <= m <= 200 and not P.zero(), "not a nonzero function of degree 1 to 200")
        need(all(f["q"].deg() >= 1 and f["q"].lead() == ONE for f in d["factors"]), "a factor is not a monic polynomial")
        need(all(abs(f["e"]) <= 10**7 and (f["e"] * (2 if m == 2 else 1)).denominator == 1 for f in d["factors"]), "exponents must be integers (half-integers for m = 2)")
        S = product([f["q"] for f in d["factors"]])
        if S.deg() > 0:
            self.squarefree(S, d["prime"])
        parts = [f["q"].diff().scale(f["e"]) * product([g["q"] for g in d["factors"] if g is not f]) for f in d["factors"] if f["e"]] \
            if len(d["factors"]) < 50 else self.log_derivative(d["factors"])
        theta = sum(parts, ZERO)                                    # S V'/V, with v = p V
        if not divides(self.den, S * S):
            S, theta = S * self.den, theta * self.den
        rs = self.num * quotient(S * S, self.den)
        t = [P, S * P.diff() + theta * P]
        for i in range(1, m + 1):
            t.append(S * t[i].diff() + (theta - S.diff().scale(i)) * t[i] - (rs * t[i - 1]).scale(i * (m - i + 1)))
        need(t[m + 1].zero(), f"Sym^{m} does not vanish")
        x.m, x.p, x.factors, x.data = m, P, [(f["q"], f["e"]) for f in d["factors"]], d
        x.branch = product([q for q, e in x.factors if e.denominator == 2])
        if m == 2:                                                  # w^2 = x.w2[0]/x.w2[1] * prod c^k, (c, k) in x.w2[2]
            z = 0
            while S.at(z).zero():
                z += 1
            x.w2 = t[1].at(z)**2 - (t[0].at(z) * t[2].at(z)).scale(2), S.at(z)**2, [(q.at(z), int(2 * e)) for q, e in x.factors if e]
        return x

    def log_derivative(self, factors):
        def rec(fs):
            if len(fs) == 1:
                return fs[0]["q"], fs[0]["q"].diff().scale(fs[0]["e"])
            (a, x), (b, y) = rec(fs[:len(fs) // 2]), rec(fs[len(fs) // 2:])
            return a * b, x * b + a * y
        return [rec(factors)[1]]

    def check_no_exponential(self, d, local):
        by = d["by"]
        if by not in ("parity", "degree", "series") or by != "series" and any(v is not None for k, v in d.items() if k != "by"):
            raise Malformed("no-exponential: by must be parity, degree or series, with its data only")
        if by == "parity":
            need(any(x.ramified() for x in local.all), "no place of odd order")
        elif by == "degree":
            need(local.degree_bound_1() < 0, "D_1 is not negative")
        else:
            need(None not in d.values(), "by must be parity, degree or series, with all its data")
            self.series(d, local)
        return "irreducible"

    def series(self, d, local):
        p, a, num, den = self.good(d)
        terms, half = d["terms"], pow(2, -1, p)
        if d["place"] == "infinity":
            x, root = local.infinity, None
            need(x.order >= 1, "infinity is not singular")
        else:
            i = read("int", d["place"], "place") if INTEGER.match(d["place"]) else -1
            need(0 <= i < len(local.places), "no such place")
            x, root = local.places[i], d["root"]
            need(meval(self.mod(x.q, p, a), root, p) == 0, "not a root of the place modulo p")
        need(2 <= terms <= SIZE, "too few or too many terms")
        D1 = local.degree_bound_1()
        M = sum(y.n * max(1, y.order // 2) for y in local.places) + D1
        L = M + (max(0, local.infinity.order // 2 - 2) + 1 if root is not None else max(1, x.order // 2))
        n, e = self.expansion(p, a, num, den, root, x.order)
        starts = [(1 + d["delta"]) * half % p, (1 - d["delta"]) * half % p] if x.order <= 2 else [d["delta"], -d["delta"] % p]
        lines = [S for S in (self.riccati(n, e, x.order, s, terms, p) for s in dict.fromkeys(starts)) if S]
        need(len(lines) == len(d["lines"]), "each line that is left needs one approximant")
        for S, line in zip(lines, d["lines"]):
            C, ell = line["approximant"], line["length"]
            need(len(C) <= ell + 1 and all(0 <= v < p for v in C), "the approximant is longer than its length")
            v = mmul(C, S, p, terms)
            k = next((i for i in range(ell, len(v)) if v[i]), None)
            need(k is not None and k + 1 - ell > L, "a solution of the allowed degree is not excluded")

    def check_p_curvature(self, d, local):
        p, a, n, e = self.good(d)
        size = len(n) + len(e)
        need(p * size <= 10**7 and p * p * size <= LIMIT, "the prime is too large for a p-curvature")
        A, B, e1 = [1], [], mdiff(e, p)
        for k in range(p + 1):                  # y^(k) = (A y + B y')/den^k
            if k == p:
                Ap, Bp = A, B
            A, B = (madd(madd(mmul(e, mdiff(A, p), p), mmul(e1, A, p), p, -k), mmul(n, B, p), p),
                    madd(madd(mmul(e, A, p), mmul(e, mdiff(B, p), p), p), mmul(e1, B, p), p, -k))
        f, r = mdivmod(madd(mmul(mmul(Ap, Ap, p), e, p), mmul(Bp, A, p), p), e, p)
        need(not r and not any(x for i, x in enumerate(f) if i % p), "the p-curvature is not a p-th power")
        b = f[::p]
        need(b, "the p-curvature is nilpotent")
        if d["shows"] == "sl2":
            need(p >= 7 and local is not None, "sl2 needs p >= 7 and a local premise")
            rest = b
            for x in local.places:
                q = self.mod(x.q, p, a) if x.half() else [1]
                g = mgcd(rest, q, p)
                while len(g) > 1:
                    rest = mdivmod(rest, g, p)[0]
                    g = mgcd(rest, q, p)
            need(len(rest) > 1 and not is_square(rest, p) or len(b) % 2 == 0 and not local.infinity.half(), "no odd place of B_p is excluded")
        else:
            need(d["shows"] == "nonzero" or d["shows"] == "irreducible" and not is_square(b, p), "B_p is a square")
        return Curve(kind="p-curvature", shows=d["shows"], p=p)

    def check_no_invariant(self, d, local):
        m = d["m"]
        if d["by"] not in ("degree", "series") or d["by"] == "degree" and any(v is not None for k, v in d.items() if k not in ("by", "m")):
            raise Malformed("no-invariant: by must be degree or series, with its data only")
        need(2 <= m <= 200 and m % 2 == 0, "m must be even")
        D = local.degree_bound(m)
        if d["by"] == "degree":
            need(D < 0, f"D_{m} is not negative")
            return Absent(m=m)
        need(None not in d.values(), "by series needs all its data")
        p, a, num, den = self.good(d)
        T, x0 = d["terms"], d["x0"]
        need(all(x.lowest(m) is not None for x in local.places), "the degree bound is negative: use degree")
        need(0 <= T - (max(D, -1) + m + 2) <= 1000 and T <= min(p, 10 * SIZE) and T * (len(num) + len(den)) <= LIMIT, "terms out of range")
        need(x0 < p and meval(den, x0, p), "x0 is a pole modulo p")
        n, e = mshift(num, x0, p), mshift(den, x0, p)
        ys = [self.solution(n, e, y, T, p) for y in ([1, 0], [0, 1])]
        groups = {}
        for x in local.places:
            groups.setdefault(x.lowest(m) // x.n, []).append(self.mod(x.q, p, a))
        U = [1]
        for k, qs in groups.items():
            while len(qs) > 1:
                qs = [mmul(f, g, p, T) for f, g in zip(qs[::2], qs[1::2] + [[1]])]
            f, k = mshift(qs[0], x0, p), int(k)
            need(abs(k) < 10**7, "an exponent is too large")
            f, k = (mseries(f, p, T), k) if k > 0 else (f, -k)
            while k:
                U, f, k = mmul(U, f, p, T) if k & 1 else U, mmul(f, f, p, T) if k > 1 else f, k >> 1
        powers = [[[1]], [U]]
        for i in range(m):
            powers[0].append(mmul(powers[0][-1], ys[0], p, T))
            powers[1].append(mmul(powers[1][-1], ys[1], p, T))
        rows = [(mmul(powers[0][i], powers[1][m - i], p, T) + [0] * T)[max(D + 1, 0):T] for i in range(m + 1)]
        need(rank(rows, p) == m + 1, f"the rank is not {m + 1}")
        return Absent(m=m)

    @staticmethod
    def solution(n, e, y, T, p):
        """den y'' = num y, from y(0), y'(0)."""
        u, w = pow(e[0], -1, p), []                  # w_i = (i+2)(i+1) y_(i+2)
        n, e = n[::-1], e[:0:-1]
        for k in range(T - 2):
            s = sum(map(int.__mul__, n[-k - 1:], y[max(0, k + 1 - len(n)):k + 1]))
            s -= sum(map(int.__mul__, e[-k:] if k else [], w[max(0, k - len(e)):k]))
            w.append(s * u % p)
            y.append(w[-1] * pow((k + 2) * (k + 1), -1, p) % p)
        return y[:T]

    def check_torsion_function(self, d, v, local):
        """h = (a + b w s)/den with h' = n (w/(V s)) h on s^2 = F0, and h is not a power."""
        n, a, b, c, f = d["n"], d["a"], d["b"], d["den"], v.branch
        need(1 <= n <= 10**6 and f.deg() > 0 and not c.zero() and not (a.zero() and b.zero()), "not a torsion function")
        A, B = v.fraction()
        top, bottom, powers = v.w2
        need(sum(abs(k) for _, k in powers) <= 10**5, "an exponent is too large")
        for u, k in powers:
            top, bottom = (top * u**k, bottom) if k > 0 else (top, bottom * u**-k)
        need((a.diff() * c - a * c.diff()) * A * bottom == (top * b * B * c).scale(n), "h' = n (w/v) h fails")
        need((((b.diff() * c - b * c.diff()) * f).scale(2) + b * c * f.diff()) * A == (a * B * c).scale(2 * n), "h' = n (w/v) h fails")
        known = local.residue_denominator(v) if local is not None else 1
        left, l = n, 2
        seen = {t["l"] for t in d["minimal"]}
        while left > 1:
            if left % l == 0:
                k = 0
                while left % l == 0:
                    left, k = left // l, k + 1
                need(known % l**k == 0 or l in seen, f"it is not shown that h is not a power of exponent {l}")
            l += 1
        for t in d["minimal"]:
            p, aa = self.good(t)[:2]
            l, w, fp = t["l"], t["w"], self.mod(f, p, aa)
            need(l >= 2 and p % l == 1 and n % l == 0, "l must divide n and p - 1")
            need(K.d == 1 or meval([i * x for i, x in enumerate(K.m)][1:], aa, p), "the prime ramifies")
            self.check_root(v, w, p, aa)
            need(not is_square(fp, p), "F0 is a square modulo p")
            h = []
            for x, s in ((t["x1"], t["s1"]), (t["x2"], t["s2"])):
                u, e, g = (meval(self.mod(y, p, aa), x, p) for y in (a, b, c))
                need(s % p and (s * s - meval(fp, x, p)) % p == 0 and g, "not a point where h is defined")
                h.append((u + e * w * s) * pow(g, -1, p) % p)
            need(h[0] and h[1] and pow(h[0] * pow(h[1], -1, p), (p - 1) // l, p) != 1, "h(1)/h(2) is a power")
        return Curve(kind="torsion-function", n=n, of=v)

    def check_root(self, v, w, p, a):
        top, bottom, powers = v.w2
        value = [meval(self.mod(x, p, a), 0, p) for x in (top, bottom, *(c for c, _ in powers))]
        need(all(value) and w < p, "w^2 is not a unit modulo p")
        square = value[0] * pow(value[1], -1, p)
        for c, (_, k) in zip(value[2:], powers):
            square = square * pow(c, k, p) % p
        need(w * w % p == square % p, "w is not a square root of w^2 modulo p")

    def check_jacobian(self, d, local, v):
        """multiple * E is principal on s^2 = F0 modulo p; E = sum of L Delta (point - conjugate) over the zeros of v."""
        p, a, num, den = self.good(d)
        w, f, M = d["w"], self.mod(v.branch, p, a), d["multiple"]
        need(1 <= M < 10**30 and v.branch.deg() >= 3, "not a multiple, or not a curve of positive genus")
        need(len(mgcd(f, mdiff(f, p), p)) == 1, "F0 is not squarefree modulo p")
        self.check_root(v, w, p, a)
        L = local.residue_denominator(v)
        A, B = (self.mod(x, p, a) for x in v.fraction())
        need(v.p.deg() == 0 or len(mgcd(self.mod(v.p, p, a), den, p)) == 1, "zeros of v meet the poles of r")
        zeros = [(v.p, Fraction(1))] if v.p.deg() > 0 else []
        for q, e in v.factors:
            if e.denominator == 1 and e > 0:
                x = next((x for x in local.places if x.q == q), None)
                need(x is not None and e == 1, "a zero of v is not a place of r, or not simple")
                zeros.append((q, x.delta))
        points = []
        for q, delta in zeros:
            if delta:
                u = self.mod(q, p, a)
                u = [x * pow(u[-1], -1, p) % p for x in u]
                t = minv(mmul(mdiff(A, p), [delta.numerator % p], p), u, p)
                s = mdivmod(mmul(mmul(B, t, p), [w * delta.denominator % p], p), u, p)[1]
                need(not mdivmod(madd(mmul(s, s, p), f, p, -1), u, p)[1], "a zero of v is not on the curve")
                points.append((u, s, int(L * delta)))
        g = (len(f) - 2) // 2
        if len(f) % 2:                                 # two points at infinity: send a branch point there
            c = d["branch"]
            need(c is not None and meval(f, c, p) == 0, "an even curve needs a branch point modulo p")
            f, points = self.send_to_infinity(f, points, c, g, p)
            if v.growth() == 1 and local.infinity.delta:
                t = w * pow(A[-1], -1, p) * B[-1] * pow(local.infinity.delta.numerator, -1, p) * local.infinity.delta.denominator % p
                need(t in (1, p - 1), "the residue at infinity is wrong")
                points.append(([0, 1], [-t % p], int(L * local.infinity.delta)))
        total = ([1], [])
        for u, s, k in points:
            total = add_points(total, multiple(reduce_point((u, s), f, g, p), k, f, g, p), f, g, p)
        need(multiple(total, 2 * M, f, g, p)[0] == [1], "the multiple is not principal")
        return Curve(kind="jacobian", p=p, multiple=M, of=v)

    @staticmethod
    def send_to_infinity(f, points, c, g, p):
        """z = c + 1/X, s = Y/X^(g+1)."""
        def flip(h, n):
            h = mshift(h, c, p)
            return trim((h + [0] * (n + 1 - len(h)))[::-1])
        out = []
        for u, s, k in points:
            v = flip(u, len(u) - 1)
            need(len(v) == len(u), "a zero of v meets the branch point")
            v = [x * pow(v[-1], -1, p) % p for x in v]
            # Y = X^(g+1) s(c + 1/X): divide by the power of X that flip leaves over
            n = max(len(s) - 1, 0)
            y = flip(s, n)
            power = mpow([0, 1], g + 1 - n, v, p) if g + 1 >= n else mpow(minv([0, 1], v, p), n - g - 1, v, p)
            out.append((v, mdivmod(mmul(y, power, p), v, p)[1], k))
        return flip(f, len(f) - 1), out


def add_points(x, y, f, g, p):
    """Cantor's addition of (u, s) on s^2 = f, one point at infinity, genus g."""
    (a1, b1), (a2, b2) = x, y
    d1, e1, e2 = mxgcd(a1, a2, p)
    d, c1, c2 = mxgcd(d1, madd(b1, b2, p), p)
    s1, s2 = mmul(c1, e1, p), mmul(c1, e2, p)
    a = mdivmod(mmul(a1, a2, p), mmul(d, d, p), p)[0]
    b = madd(madd(mmul(mmul(s1, a1, p), b2, p), mmul(mmul(s2, a2, p), b1, p), p), mmul(c2, madd(mmul(b1, b2, p), f, p), p), p)
    return reduce_point((a, mdivmod(mdivmod(b, d, p)[0], a, p)[1]), f, g, p)


def reduce_point(x, f, g, p):
    a, b = x
    while len(a) - 1 > g:
        a = mdivmod(madd(f, mmul(b, b, p), p, -1), a, p)[0]
        b = mdivmod([-t % p for t in b], a, p)[1]
    return [t * pow(a[-1], -1, p) % p for t in a], b


def multiple(x, k, f, g, p):
    r = ([1], [])
    while k:
        if k & 1:
            r = add_points(r, x, f, g, p)
        x, k = add_points(x, x, f, g, p), k >> 1
    return r


def mxgcd(a, b, p):
    """(d, x, y) with d = x a + y b, d monic."""
    r0, r1, s0, s1, t0, t1 = a, b, [1], [], [], [1]
    while r1:
        q, r = mdivmod(r0, r1, p)
        r0, r1, s0, s1, t0, t1 = r1, r, s1, madd(s0, mmul(q, s1, p), p, -1), t1, madd(t0, mmul(q, t1, p), p, -1)
    u = [pow(r0[-1], -1, p)]
    return mmul(r0, u, p), mmul(s0, u, p), mmul(t0, u, p)


def rank(rows, p):
    found = 0
    for c in range(len(rows[0])):
        i = next((i for i in range(found, len(rows)) if rows[i][c]), None)
        if i is None:
            continue
        rows[found], rows[i] = rows[i], rows[found]
        u = pow(rows[found][c], -1, p)
        for i in range(found + 1, len(rows)):
            if rows[i][c]:
                t = rows[i][c] * u % p
                rows[i] = [(x - t * y) % p for x, y in zip(rows[i], rows[found])]
        found += 1
        if found == len(rows):
            break
    return found


# ---- conclusions: docs/theory/trichotomy.md ----------------------------------------------------------------------------------

COMPONENT = {"SL2": "SL2", "Borel": "Borel", "T": "Ga", "Gm": "Gm", "cyclic": "trivial", "Dinf": "Gm", "D": "trivial",
             "A4": "trivial", "S4": "trivial", "A5": "trivial"}


def conclude(theorem, facts):
    """(group, n, abelian) from a named theorem and the facts of the premises."""
    local = next((x for x in facts if isinstance(x, Local)), None)
    v = next((x for x in facts if isinstance(x, Invariant)), None)
    curves = {x.kind: x for x in facts if type(x) is Curve}
    shows = curves["p-curvature"].shows if "p-curvature" in curves else None
    none = [x.m for x in facts if isinstance(x, Absent)]
    irreducible = "irreducible" in facts or shows in ("irreducible", "sl2")
    log = local is not None and any(x.logs for x in local.all)
    infinite = local is not None and local.infinite_order()

    def given(*conditions):
        need(all(conditions), f"the premises of {theorem} are not all given")
    quadratic = v is not None and v.m == 2 and not v.w2[0].zero()
    split, dihedral = quadratic and v.branch.deg() <= 0, quadratic and v.branch.deg() > 0
    if theorem == "sl2-p-curvature":
        given(shows == "sl2")
        return "SL2", None, False
    if theorem == "sl2-irreducible-log":
        given(irreducible, log)
        return "SL2", None, False
    if theorem == "sl2-irreducible-infinite":
        given(irreducible, 4 in none, local)
        orders = {x.delta.denominator for x in local.all if x.delta is not None}
        given(infinite or log or any(k >= 6 for k in orders) or {4, 5} <= orders)
        return "SL2", None, False
    if theorem == "sl2-irreducible-12":
        given(irreducible, 12 in none)
        return "SL2", None, False
    if theorem in ("borel", "additive"):
        given("exponential" in facts, local, log or 2 in none or 4 in none)
        given(infinite or theorem == "additive")
        return ("Borel", None, False) if theorem == "borel" else ("T", local.order_of_character(), True)
    if theorem == "diagonal":
        given(local, split)
        return ("Gm", None, True) if infinite else ("cyclic", local.order_of_character(), True)
    if theorem == "dihedral-infinite":
        given(dihedral, infinite)
        return "Dinf", None, True
    if theorem == "dihedral-genus-0":
        given(dihedral, local, v.branch.deg() <= 2, not infinite)
        n = local.residue_denominator(v)
        return ("D", n, True) if n > 1 else ("cyclic", 4, True)
    if theorem == "dihedral-finite":
        given(dihedral, "torsion-function" in curves and curves["torsion-function"].of is v)
        n = curves["torsion-function"].n
        return ("D", n, True) if n > 1 else ("cyclic", 4, True)
    if theorem == "dihedral-torsion":
        given(dihedral, local, shows)
        jacobian, p = curves.get("jacobian"), curves["p-curvature"].p
        given(jacobian is None or jacobian.of is v)
        # without a jacobian step E must be 0: v has no zeros
        M = jacobian.multiple * jacobian.p if jacobian else 1
        given(jacobian or v.p.deg() == 0 and not any(e > 0 and e.denominator == 1 for _, e in v.factors) and
              (v.branch.deg() % 2 or v.growth() != 1))
        given(local.residue_denominator(v) * M * 2 % p)
        return "Dinf", None, True
    if theorem == "quaternion":
        vs = [x for x in facts if isinstance(x, Invariant) and x.m == 4]
        given(irreducible, len(vs) == 2)
        (a, b), (c, e) = vs[0].fraction(), vs[1].fraction()
        f, g = a * e, c * b
        given(not f * g.lead() == g * f.lead())
        return "D", 2, True
    if theorem in ("tetrahedral", "octahedral", "icosahedral"):
        group, m, absent = {"t": ("A4", 6, {4}), "o": ("S4", 8, {4, 6}), "i": ("A5", 12, {8})}[theorem[0]]
        given(irreducible, absent <= set(none), v is not None and v.m == m)
        return group, None, True
    if theorem == "invariant-abelian":
        given(v)
        return None, None, True
    if theorem == "torus-nonabelian":
        given(infinite, 4 in none)
        return None, None, False
    raise Rejected(f"unknown theorem {theorem!r}")


def verify(text):
    """Returns the number of trusted steps; raises Malformed or Rejected."""
    num, den, claim, steps = load(text)
    need(irreducible(K.m), "the minimal polynomial is reducible")
    need(not den.zero() and den.lead() == ONE, "den is not monic")
    checker, facts, used, trusted, result = Checker(num, den), {}, set(), 0, None
    for name, rule, premises, data in steps:
        try:
            need(name not in facts, "the id occurs twice")
            need(all(x in facts for x in premises), "a premise is not an earlier step")
            used.update(premises)
            given = [facts[x] for x in premises]
            if rule == "conclude":
                result = facts[name] = conclude(data["theorem"], given)
            elif rule == "apply-theorem":
                need(result in given, "the theorem is not applied to a conclusion")
                trusted, facts[name] = trusted + 1, result
            else:
                facts[name] = run(checker, rule, data, given)
        except (Rejected, ArithmeticError, ValueError, LookupError, MemoryError) as why:
            raise Rejected(f"step {name} ({rule}): {why}") from None
    need(steps[-1][1] in ("conclude", "apply-theorem") and result, "the last step is not a conclusion")
    need(used == {s[0] for s in steps[:-1]}, "a step is not used")
    group, n, abelian = result
    need(any(x is not None for x in claim.values()), "nothing is claimed")
    for key, value in (("group", group), ("n", n), ("component", COMPONENT.get(group)), ("abelian", abelian)):
        need(claim[key] is None or claim[key] == value, f"the claim does not follow: {key}")
    return trusted


def run(checker, rule, data, given):
    """Hands the premises to the rule by their kind."""
    local = next((x for x in given if isinstance(x, Local)), None)
    v = next((x for x in given if isinstance(x, Invariant)), None)
    check = getattr(checker, "check_" + rule.replace("-", "_"))
    if rule in ("local", "exponential", "invariant"):
        need(not given, "no premises are expected")
        return check(data)
    need(local is not None or rule in ("p-curvature", "torsion-function"), "a local premise is missing")
    if rule in ("no-exponential", "p-curvature", "no-invariant"):
        return check(data, local)
    need(v is not None and v.m == 2 and v.branch.deg() > 0 and not v.w2[0].zero(), "an invariant premise is missing")
    return check(data, v, local) if rule == "torsion-function" else check(data, local, v)


def main(args):
    strict = "--strict" in args
    files = [x for x in args if x != "--strict"]
    if len(files) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    sys.setrecursionlimit(10000)
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    try:
        text = sys.stdin.read() if files[0] == "-" else open(files[0], encoding="utf-8").read()
        trusted = verify(text)
        need(not (strict and trusted), f"{trusted} trusted steps, refused by --strict")
    except (Malformed, OSError, UnicodeDecodeError) as error:
        print(f"malformed: {error}")
        return 2
    except Rejected as error:
        print(f"rejected: {error}")
        return 1
    print(f"accepted ({trusted} trusted steps)")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
