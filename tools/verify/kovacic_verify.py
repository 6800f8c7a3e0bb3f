#!/usr/bin/env python3
"""Independent checker for kovacic-certificate/1 (Python 3 standard library only).

A certificate proves a statement about the differential Galois group G of y'' = r(z) y; docs/theory/certificates.md defines the
format, the pages beside it prove the theorem behind each rule.
usage: kovacic_verify.py [--strict] FILE|-        exit 0 accepted, 1 rejected, 2 malformed
"""
import json
import re
import sys
from fractions import Fraction
from math import ceil, floor, gcd, isqrt, lcm, prod
from operator import mul

LIMIT, SIZE = 4 * 10**9, 200001      # elementary operations of one step; coefficients of one polynomial

class Malformed(Exception):
    pass

class Rejected(Exception):
    pass

def need(condition, why):
    if not condition:
        raise Rejected(why)

# ---- Z[x], ascending lists; K[z] for K = Q[x]/(m): blocks of length 2d-1 (room for one product) over one denominator -------------

def trim(a):
    while a and not a[-1]:
        a.pop()
    return a

def imul(a, b):
    """Product in Z[x]; of long factors by Kronecker substitution."""
    if not a or not b:
        return []
    a, b = (a, b) if len(a) <= len(b) else (b, a)
    size = len(a) + len(b) - 1
    if len(a) <= 6:
        c = [0] * size
        for i, x in enumerate(a):
            for j, y in enumerate(b if x else [], i):
                c[j] += x * y
        return c
    n = (max(map(abs, a)).bit_length() + max(map(abs, b)).bit_length() + len(a).bit_length() + 2) // 8 + 1
    bias, unit = 1 << (8 * n - 1), bytes(n - 1) + b"\x80"
    x, y = (int.from_bytes(b"".join((t + bias).to_bytes(n, "little") for t in v), "little") -
            int.from_bytes(unit * len(v), "little") for v in (a, b))
    s = (x * y + int.from_bytes(unit * size, "little")).to_bytes(n * size + 1, "little")
    return [int.from_bytes(s[i:i + n], "little") - bias for i in range(0, n * size, n)]

class K:
    d, s, m = 1, 1, [0, 1]           # degree, length of a block, minimal polynomial

def reduce_blocks(c):
    for start in range(0, len(c) if K.d > 1 else 0, K.s):
        for i in range(min(start + K.s, len(c)) - 1, start + K.d - 1, -1):
            if c[i]:
                for j in range(K.d):
                    c[i - K.d + j] -= c[i] * K.m[j]
                c[i] = 0
    return trim(c)

class Poly:
    """Polynomial over K: flat integers c over the denominator q > 0."""
    __slots__ = ("c", "q")

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
            return Poly(reduce_blocks(imul(self.c, o.c)), self.q * o.q)
        o = Fraction(o)
        return Poly([o.numerator * x for x in self.c], self.q * o.denominator)

    def __pow__(self, e):
        return ONE if e == 0 else self * self**(e - 1) if e % 2 else (self * self)**(e // 2)

    def __eq__(self, o):
        return not (self - o).c

    def deg(self):
        return (len(self.c) + K.s - 1) // K.s - 1

    def coeff(self, i):
        return Poly(self.c[i * K.s:i * K.s + K.d] if i >= 0 else [], self.q)

    def lead(self):
        return self.coeff(self.deg())

    def diff(self):
        return Poly([x * (i // K.s) for i, x in enumerate(self.c)][K.s:], self.q)

    def rational(self):
        """The value of a constant in Q, or None."""
        return Fraction(sum(self.c), self.q) if len(self.c) <= 1 else None

    def at(self, x):
        v = Poly([])
        for i in range(self.deg(), -1, -1):
            v = v * x + self.coeff(i)
        return v

    def taylor(self, i):
        """The i-th derivative divided by i!."""
        out, b = [], 1
        for k in range(i, self.deg() + 1):
            out += [b * x for x in self.c[k * K.s:(k + 1) * K.s]]
            b = b * (k + 1) // (k + 1 - i)
        return Poly(out, self.q)

ONE = Poly([1])

def division(f, q):
    """Quotient and remainder by the monic q: z is scaled by the denominator w of q, then all is integral."""
    n, m, s, d, w = f.deg(), q.deg(), K.s, K.d, q.q
    if n < m:
        return Poly([]), f
    a = [[x * w**(n - i) for x in (f.c[i * s:i * s + d] + [0] * d)[:d]] for i in range(n + 1)]
    b = [(Poly(q.c[i * s:i * s + d]) * w**(m - i - 1)).c for i in range(m)]
    for i in range(n, m - 1, -1):
        for j in range(m if any(a[i]) else 0):
            row = a[i - m + j]
            for k, x in enumerate([a[i][0] * y for y in b[j]] if d == 1 else reduce_blocks(imul(a[i], b[j]))):
                row[k] -= x
    quotient, rest = ([x * w**(i + e) for i, row in enumerate(rows) for x in row + [0] * (s - d)] for rows, e in ((a[m:], m), (a[:m], 0)))
    return Poly(quotient, f.q * w**n), Poly(rest, f.q * w**n)

def rem(f, q):
    if q is None or f.deg() < q.deg():
        return f
    if q.deg() > 1 or K.d > 1:
        return division(f, q)[1]
    u, v, w, power = -q.c[0], 0, q.q, 1            # Horner at u/w
    for x in reversed(f.c):
        v, power = v * u + x * power, power * w
    return Poly([v], f.q * (power // w))

def product(polys):
    polys = list(polys) or [ONE]
    while len(polys) > 1:
        polys = [a * b for a, b in zip(polys[::2], polys[1::2] + [ONE])]
    return polys[0]

# ---- F_p[z]: ascending lists -----------------------------------------------------------------------------------------------------

def madd(a, b, p, f=1):
    """a + f b"""
    n = max(len(a), len(b))
    return trim([(x + f * y) % p for x, y in zip(a + [0] * (n - len(a)), b + [0] * (n - len(b)))])

def mmul(a, b, p, n=None):
    """a b, truncated to n terms"""
    return trim([x % p for x in imul(a[:n], b[:n])[:n]])

def mdiff(a, p):
    return trim([i * x % p for i, x in enumerate(a)][1:])

def mscale(a, f, p):
    return [x * f % p for x in a]

def mdivmod(a, b, p):
    a, m, u = a[:], len(b) - 1, pow(b[-1], -1, p)
    quotient = [0] * max(0, len(a) - m)
    for i in range(len(a) - 1, m - 1, -1):
        quotient[i - m] = f = a[i] * u % p
        if f:
            a[i - m:i] = [(x - f * y) % p for x, y in zip(a[i - m:i], b)]
    return trim(quotient), trim(a[:m])

def mxgcd(a, b, p):
    """(d, x, y): d = x a + y b, monic"""
    s, t = ([1], []), ([], [1])
    while b:
        q, r = mdivmod(a, b, p)
        a, b, s, t = b, r, t, tuple(madd(x, mmul(q, y, p), p, -1) for x, y in zip(s, t))
    u = pow(a[-1], -1, p) if a else 1
    return mscale(a, u, p), mscale(s[0], u, p), mscale(s[1], u, p)

def mgcd(a, b, p):
    while b:
        a, b = b, mdivmod(a, b, p)[1]
    return mscale(a, pow(a[-1], -1, p), p) if a else a

def minv(a, q, p):
    """1/a modulo q"""
    d, x, _ = mxgcd(mdivmod(a, q, p)[1], q, p)
    need(len(d) == 1, "an element is not invertible modulo p")
    return mdivmod(x, q, p)[1]

def mpow(a, e, q, p):
    """a^e modulo q"""
    r, a = mdivmod([1], q, p)[1], mdivmod(a, q, p)[1]
    while e:
        r = mdivmod(mmul(r, a, p), q, p)[1] if e & 1 else r
        a, e = mdivmod(mmul(a, a, p), q, p)[1], e >> 1
    return r

def power_series(a, e, p, n):
    """a^e modulo z^n"""
    r = [1]
    while e:
        r, a, e = mmul(r, a, p, n) if e & 1 else r, mmul(a, a, p, n) if e > 1 else a, e >> 1
    return r

def mshift(a, c, p):
    """a(z + c)"""
    if len(a) > 32:
        h = len(a) // 2
        return madd(mshift(a[:h], c, p), mmul(mshift(a[h:], c, p), power_series([c, 1], h, p, None), p), p)
    a = a[:]
    for i in range(len(a)):
        for j in range(len(a) - 2, i - 1, -1):
            a[j] = (a[j] + c * a[j + 1]) % p
    return a

def mseries(a, p, n):
    """1/a modulo z^n"""
    b, k = [pow(a[0], -1, p)], 1
    while k < n:
        k = min(2 * k, n)
        b = mmul(b, madd([2], mmul(a, b, p, k), p, -1), p, k)
    return b[:n]

def meval(a, x, p):
    v = 0
    for y in reversed(a):
        v = (v * x + y) % p
    return v

def is_square(b, p):
    """Is b (not 0) a constant times a square over the algebraic closure of F_p, p odd?"""
    n, rev, root = len(b) // 2, mscale(b[::-1], pow(b[-1], -1, p), p), [1]
    while len(root) < n + 1 and len(b) % 2:        # Newton: root = (root + rev/root)/2
        k = min(2 * len(root), n + 1)
        root = mscale(madd(root, mmul(rev, mseries(root, p, k), p, k), p), (p + 1) // 2, p)
        root += [0] * (k - len(root))
    return len(b) % 2 == 1 and trim(mmul(root, root, p)) == trim(rev)

def rank(rows, p):
    found = 0
    for c in range(len(rows[0])):
        i = next((i for i in range(found, len(rows)) if rows[i][c]), None)
        if i is not None:
            rows[found], rows[i], top = rows[i], rows[found], rows[i]
            for i in range(found + 1, len(rows)):
                t = rows[i][c] * pow(top[c], -1, p)
                rows[i] = [(x - t * y) % p for x, y in zip(rows[i], top)] if t else rows[i]
            found += 1
            if found == len(rows):
                break
    return found

def is_prime(n):
    small = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)       # as bases they prove primality below 3.3e24
    if n < 41 or not all(n % q for q in small):
        return n in small
    s = (n - 1 & 1 - n).bit_length() - 1
    return all(pow(b, n - 1 >> s, n) == 1 or any(pow(b, (n - 1 >> s) << i, n) == n - 1 for i in range(s)) for b in small)

def irreducible(m):
    """Is the monic m in Z[x] irreducible over Q?  Its factors modulo a prime beyond Mignotte's bound are recombined."""
    d = len(m) - 1
    need(sum(x * x for x in m).bit_length() // 2 + d + 1 < 76, "the minimal polynomial is too large")
    p, f = 2**(d + 2) * (isqrt(sum(x * x for x in m)) + 1) | 1, []
    while not is_prime(p) or len(mgcd(f, mdiff(f, p), p)) != 1:
        p += 2
        need(p % 2**12 != 1, "the minimal polynomial is not squarefree")
        f = [x % p for x in m]
    parts, k, x, seed = [], 0, [0, 1], 1
    while len(f) > 1:                              # the product of the factors of degree k, then these by random splitting
        k, x = k + 1, mpow(x, p, f, p)
        todo = [mgcd(f, madd(x, [0, 1], p, -1), p)]
        while todo:
            g, seed = todo.pop(), seed + 1
            if len(g) == k + 1:
                parts, f = parts + [g], mdivmod(f, g, p)[0]
            elif len(g) > 1:
                t = mpow([seed * seed + i * seed + 1 for i in range(len(g) - 1)], (p**k - 1) // 2, g, p)
                h = mgcd(g, madd(t, [1], p, -1), p)
                todo += [h, mdivmod(g, h, p)[0]] if 1 < len(h) < len(g) else [g]
        x = mdivmod(x, f, p)[1] if len(f) > 1 else x
    for mask in range(1, 2**len(parts) - 1):
        g, a = [1], m[:]
        for i, part in enumerate(parts):
            g = mmul(g, part, p) if mask >> i & 1 else g
        g = [y - p if 2 * y > p else y for y in g]
        for i in range(d, len(g) - 2, -1):
            a[i - len(g) + 1:i + 1] = [x - a[i] * y for x, y in zip(a[i - len(g) + 1:i + 1], g)]
        if not any(a):
            return False
    return True

# ---- reading: a schema says what each key holds; '?' marks optional keys; "by" chooses a variant -----------------------------------

PRIME, RES = {"p": "int", "a": "res"}, "res"
LOG = PRIME | {"roots?": [RES]}
RULES = {
    "local": {"prime": PRIME, "places": [{"q": "poly", "order": "int", "delta2?": "poly", "eps2?": "poly", "irrational?": PRIME,
                                          "log?": LOG, "annihilator?": "poly"}],
              "infinity": {"eps2?": "poly", "log?": LOG, "annihilator?": "poly"}},
    "exponential": {"p": "poly", "num": "poly", "den": "poly"},
    "invariant": {"prime": PRIME, "m": "int", "p": "poly", "factors": [{"q": "poly", "e": "rat"}]},
    "no-exponential": {"by": {"parity": {}, "degree": {}, "series": PRIME | {
        "place": "place", "root": RES, "delta": RES, "terms": "int", "lines": [{"length": "int", "approximant": [RES]}]}}},
    "p-curvature": PRIME | {"shows": "str"},
    "no-invariant": {"m": "int", "by": {"degree": {}, "series": PRIME | {"x0": RES, "terms": "int"}}},
    "torsion-function": {"n": "int", "a": "poly", "b": "poly", "den": "poly", "minimal": [
        PRIME | {"l": "int", "w": RES, "x1": RES, "s1": RES, "x2": RES, "s2": RES}]},
    "good-reduction": PRIME,
    "conclude": {"theorem": "str"},
    "apply-theorem": {"theorem": "str", "statement": "str"},
}
INTEGER = re.compile(r"(0|-?[1-9][0-9]{0,199999})\Z")
RATIONAL = re.compile(r"(0|-?[1-9][0-9]{0,199999}(/[1-9][0-9]{0,199999})?)\Z")
CLAIM = {"group": "str", "n": "int", "component": "str", "abelian": "bool"}

def read(kind, v, path):
    def right(condition, what):
        if not condition:
            raise Malformed(f"{path}: {what}")
        return v
    if isinstance(kind, dict):
        right(isinstance(v, dict), "an object is expected")
        if isinstance(kind.get("by"), dict):
            right(isinstance(v.get("by"), str) and v["by"] in kind["by"], "'by' is unknown")
            kind = kind | kind["by"][v["by"]] | {"by": "str"}
        names = {k.rstrip("?"): k for k in kind}
        right(set(v) <= set(names), f"unknown key {sorted(set(v) - set(names))[:1]}")
        right(all(k in v for k in kind if k[-1] != "?"), f"a key is missing: {sorted(set(names) - set(v))}")
        return {k: read(kind[full], v[k], f"{path}.{k}") if k in v else None for k, full in names.items()}
    if isinstance(kind, list):
        right(isinstance(v, list) and len(v) <= SIZE, "an array is expected")
        return [read(kind[0], x, f"{path}[{i}]") for i, x in enumerate(v)]
    if kind == "poly":
        right(isinstance(v, list) and len(v) <= SIZE, "a polynomial is expected")
        rows = [x if isinstance(x, list) else [x] for x in v]
        right(all(1 <= len(row) <= K.d and all(isinstance(y, str) and RATIONAL.match(y) for y in row) for row in rows),
              "an element of the field is expected")
        rows = [[Fraction(y) for y in row] for row in rows]
        right(not rows or any(rows[-1]), "the leading coefficient is 0")
        q = lcm(*(y.denominator for row in rows for y in row))
        return Poly([x for row in rows for x in [y.numerator * (q // y.denominator) for y in row] + [0] * (K.s - len(row))], q)
    if kind == "bool":
        return right(isinstance(v, bool), "true or false is expected")
    right(isinstance(v, str), "a string is expected")
    if kind == "str" or kind == "place" and v == "infinity":
        return v
    right((RATIONAL if kind == "rat" else INTEGER).match(v), "a number is expected")
    right(kind != "res" or 0 <= int(v) < 2**62, "a residue is expected")
    return Fraction(v) if kind == "rat" else int(v)

def load(text):
    def no_number(_):
        raise Malformed("numbers must be strings")

    def unique(pairs):
        if len(dict(pairs)) < len(pairs):
            raise Malformed("a key occurs twice")
        return dict(pairs)
    try:
        top = json.loads(text, object_pairs_hook=unique, parse_int=no_number, parse_float=no_number, parse_constant=no_number)
    except (ValueError, RecursionError) as error:
        raise Malformed(f"not JSON: {str(error)[:80]}") from None
    K.d, K.s = 1, 1
    if not isinstance(top, dict) or sorted(top) != ["claim", "field", "format", "r", "steps"] or top["format"] != "kovacic-certificate/1":
        raise Malformed("not a kovacic-certificate/1 with format, field, r, claim, steps")
    m = read({"name": "str", "minpoly": ["int"]}, top["field"], "field")["minpoly"]
    if not 2 <= len(m) <= 25 or m[-1] != 1 or (len(m) == 2 and m[0] != 0):
        raise Malformed("field.minpoly: a monic polynomial of degree 1 (z itself) to 24 is expected")
    K.m, K.d, K.s = m, len(m) - 1, 2 * len(m) - 3
    r = read({"num": "poly", "den": "poly"}, top["r"], "r")
    claim = top["claim"]
    if not isinstance(claim, dict) or set(claim) != set(CLAIM):
        raise Malformed("claim: the keys must be group, n, component, abelian")
    claim = {k: read(CLAIM[k], v, f"claim.{k}") for k, v in claim.items() if v is not None}
    if not isinstance(top["steps"], list) or not 1 <= len(top["steps"]) <= 1000:
        raise Malformed("steps: 1 to 1000 are expected")
    steps = []
    for i, s in enumerate(top["steps"]):
        if not isinstance(s, dict) or sorted(s) != ["data", "id", "premises", "rule"] or not isinstance(s["rule"], str) or s["rule"] not in RULES:
            raise Malformed(f"steps[{i}]: id, rule, premises and data of a known rule are expected")
        head = read({"id": "str", "premises": ["str"]}, {k: s[k] for k in ("id", "premises")}, f"steps[{i}]")
        steps.append((head["id"], s["rule"], head["premises"], read(RULES[s["rule"]], s["data"], f"steps[{i}].data")))
    return r["num"], r["den"], claim, steps

# ---- facts: what checked steps establish (docs/theory/local_exponents.md) ---------------------------------------------------------

def sqrt_exact(x):
    s = isqrt(max(0, x.numerator * x.denominator))
    return Fraction(s, x.denominator) if s * s == x.numerator * x.denominator else None

def sqrt_above(x):
    """A rational number >= Re sqrt(x)."""
    s = sqrt_exact(max(x, Fraction(0)))
    return s if s is not None else Fraction(isqrt((x.numerator * x.denominator) << 64) + 1, x.denominator << 32)

def root_bound(chi):
    """B >= |T| for every complex root T of chi in Q[T]: Cauchy's criterion |c_n| B^n >= sum |c_i| B^i."""
    c = [chi.coeff(i).rational() for i in range(chi.deg() + 1)]
    need(len(c) > 1 and None not in c, "the annihilator is constant or not over Q")
    c = [abs(x) for x in c]
    if not any(c[:-1]):
        return Fraction(0)

    def holds(b):
        return c[-1] * b**(len(c) - 1) >= sum(x * b**i for i, x in enumerate(c[:-1]))
    k = ceil(1 + max(c[:-1]) / c[-1]).bit_length()
    need(k < 4096, "the annihilator is too large")
    while k > -64 and holds(Fraction(2)**(k - 1)):
        k -= 1
    low, high = Fraction(2)**(k - 1), Fraction(2)**k
    for _ in range(8):
        mid = (low + high) / 2
        low, high = (low, mid) if holds(mid) else (mid, high)
    return high

class Place:
    """n conjugate points with the same data; order is that of the pole of r (at infinity, q = None: of r(1/t)/t^4 at t = 0).
    delta: Delta if proved rational; irrational: proved, at every point; logs: number of points with a proved logarithm;
    real: a bound of |Re Delta| (order 2) or |Re eps| (even order >= 4)."""

    def __init__(self, q, n, order):
        self.q, self.n, self.order, self.irrational, self.real = q, n, order, False, None
        self.delta, self.logs = (Fraction(1) if order <= 1 else None), (n if order == 1 else 0)
        self.ramified = order >= 3 and order % 2 == 1

    def set_square(self, value, annihilator):
        """value = Delta^2 (order 2) or eps^2, a polynomial in c"""
        c = value.rational()
        if self.order == 2:
            self.delta = sqrt_exact(c) if c is not None else None
            self.irrational = value.deg() <= 0 and self.delta is None
            self.logs = self.n if self.delta == 0 else 0
        if c is not None:
            self.real = sqrt_above(c)
        elif annihilator is not None:
            need(annihilator.deg() <= 500, "the annihilator is too large")
            v = Poly([])
            for i in range(annihilator.deg(), -1, -1):
                v = rem(v * value, self.q) + annihilator.coeff(i)
            need(not v.c, "the annihilator does not vanish")
            self.real = sqrt_above(root_bound(annihilator))

    def infinite_order(self):
        return self.order >= 3 or self.irrational

    def exchanges_lines(self):
        """May the two lines of an imprimitive group be exchanged around this place?"""
        return self.ramified or self.order == 2 and not self.irrational and (self.delta is None or self.delta.denominator == 2)

    def lowest(self, m):
        """Lower bound for the order at each point of a rational solution of Sym^m, m even; None: there is none."""
        if self.order <= 0:
            return 0
        if self.order >= 3:
            return None if m * self.order % 4 else m * self.order // 4
        need(self.irrational or self.delta is not None, "a degree bound needs the exponent difference of every place")
        if self.irrational:
            return m // 2
        return int(m // 2 + (m // 2 if self.logs == self.n else -(m // 2 // self.delta.denominator * self.delta.denominator)) * self.delta)

    def lowest_exponent(self):
        """Lower bound for the sum of Re alpha over the points, omega = alpha/t + ..."""
        if self.order <= 1:
            return Fraction(self.n if self.order == 1 else 0)
        need(self.real is not None, "D_1 needs delta2 or eps2 (and an annihilator, if it is not rational)")
        return self.n * (self.order // 2 + (1 if self.logs == self.n and self.order == 2 else -1) * self.real) / 2

class Fact:
    def __init__(self, kind, **data):
        self.kind = kind
        self.__dict__.update(data)

class Local(Fact):
    def infinite_order(self):
        return any(x.infinite_order() for x in self.all)

    def need_rational(self):
        need(all(x.order <= 2 and x.delta is not None for x in self.all), "not all exponent differences are proved rational")

    def degree_bound(self, m):
        e = [x.lowest(m) for x in self.all]
        return -1 if None in e else m - sum(x.n * k for x, k in zip(self.all, e))

    def degree_bound_1(self):
        need(not any(x.ramified for x in self.all), "use parity")
        return floor(1 - sum(x.lowest_exponent() for x in self.all))

    def character_order(self):
        self.need_rational()
        return lcm(*(((1 + x.delta) / 2).denominator for x in self.places))

    def residue_denominator(self, v):
        """Lcm of the denominators of Delta over the places where v does not branch."""
        self.need_rational()
        parts = [x for x in self.places if rem(v.branch, x.q).c]
        need(sum(x.n for x in self.places) - sum(x.n for x in parts) == v.branch.deg(), "the branch places are not places of their own")
        return lcm(*(x.delta.denominator for x in parts + [self.infinity] * (v.branch.deg() % 2 == 0)))

class Invariant(Fact):
    """v = p prod q^e; branch = F0 = the product of the q with half-integer e; w^2 = top/bottom prod c^k, (c, k) in powers."""

    def fraction(self):
        """v/sqrt(F0) = A/B"""
        powers = [(q, floor(e)) for q, e in self.factors]
        need(all(abs(e) * q.deg() <= 200000 for q, e in powers), "an exponent is too large")
        return product([self.p] + [q**e for q, e in powers if e > 0]), product(q**-e for q, e in powers if e < 0)

    def need_root(self, w, p, reduce):
        """w^2 = `w`^2 modulo p?"""
        value = [sum(reduce(c)) for c in (self.top, self.bottom, *(c for c, _ in self.powers))]
        need(all(value) and w < p, "w^2 is not a unit modulo p")
        square = value[0] * pow(value[1], -1, p)
        for c, (_, k) in zip(value[2:], self.powers):
            square = square * pow(c, k, p) % p
        need((w * w - square) % p == 0, "w is not a square root of w^2 modulo p")

# ---- the rules --------------------------------------------------------------------------------------------------------------------

class Checker:
    def __init__(self, num, den):
        self.num, self.den, self.dn, self.dd = num, den, num.deg(), den.deg()

    def good(self, d):
        """A prime of degree one where r is integral: p, reduction K[z] -> F_p[z], num and den modulo p."""
        p, a = d["p"], d["a"]
        need(2 < p < 2**62 and is_prime(p), "p is not an odd prime below 2^62")
        need(a < p and meval(K.m, a, p) == 0, "a is not a root of the minimal polynomial modulo p")

        def reduce(f):
            need(f.q % p, "p divides a denominator")
            return trim(mscale([meval(f.c[i:i + K.d], a, p) for i in range(0, len(f.c), K.s)], pow(f.q, -1, p), p))
        return p, reduce, reduce(self.num), reduce(self.den)

    def need_squarefree(self, f, d, other=Poly([])):
        p, reduce = self.good(d)[:2]
        g, h = reduce(f), reduce(other)
        need(len(mgcd(g, mdiff(g, p), p)) == 1, "not squarefree modulo p")
        need(not other.c or len(mgcd(g, h, p)) == 1, "a common factor modulo p")

    @staticmethod
    def expansion(p, num, den, root, order):
        """Numerator and denominator of t^order r, as polynomials in t = z - root; root = None: of r(1/t)/t^4."""
        if root is None:
            need(len(den) - len(num) == 4 - order, "the order at infinity changes modulo p")
            return num[::-1], den[::-1]
        need(root < p and meval(den, root, p) == 0, "not a root of the place modulo p")
        n, d = mshift(num, root, p), mshift(den, root, p)
        need(n and n[0] and len(d) > order and not any(d[:order]) and d[order], "the order of the pole changes modulo p")
        return n, d[order:]

    @staticmethod
    def riccati(n, d, order, s0, terms, p):
        """S = t^nu omega with S_0 = s0, modulo t^terms; None when a logarithm forbids it (riccati_one_place.md 2)."""
        nu, S = max(1, order // 2), [s0]
        need(terms * terms + terms * (len(n) + len(d)) <= LIMIT, "too many terms")
        r = ([0] * (2 * nu - order) + mmul(n, mseries(d, p, terms), p, terms) + [0] * terms)[:terms]
        need((s0 * s0 - (s0 if nu == 1 else 0) - r[0]) % p == 0, "delta is not the square root that it should be")
        for i in range(1, terms):
            h = (i + 1) // 2                       # the sum of S_a S_(i-a), 0 < a < i, by symmetry
            rhs = r[i] - 2 * sum(map(mul, S[1:h], S[i - 1:i - h:-1])) - (S[i // 2]**2 if i % 2 == 0 else 0)
            lead = (2 * s0 + (i - 1 if nu == 1 else 0)) % p
            if nu > 1 and i >= nu - 1:
                rhs -= (i - 2 * nu + 1) * S[i - nu + 1]
            if not lead:
                need(rhs % p and nu == 1, "the expansion is not unique")
                return None
            S.append(rhs * pow(lead, -1, p) % p)
        return S

    def need_log(self, d, root, delta):
        p, _, num, den = self.good(d)
        need(delta is not None and delta.denominator == 1 and 1 <= delta < p, "a logarithm needs a natural exponent difference below p")
        n, e = self.expansion(p, num, den, root, 2)
        need(self.riccati(n, e, 2, (1 - int(delta)) * (p + 1) // 2 % p, int(delta) + 1, p) is None, "no logarithm is seen")

    @staticmethod
    def need_eps2(x, n, d, value):
        """eps^2 = (beta/a)^2; n(i), d(i): Taylor coefficients of t^(2nu) r in K[c]/q (local_exponents.md 1.5)."""
        nu = x.order // 2
        need(nu <= 200, "the order of the pole is too large")

        def times(*f):
            v = ONE
            for y in f:
                v = rem(v * y, x.q)
            return v
        N, D = [n(i) for i in range(nu)], [d(i) for i in range(nu)]
        G = [sum((times(N[j], D[i - j]) for j in range(i + 1)), Poly([])) for i in range(nu)]
        tau, inv, g, e = [ONE], [ONE], [ONE], [ONE]
        for j in range(1, nu):
            g, e = g + [times(g[-1], G[0])], e + [times(e[-1], D[0])]
            tau.append((times(G[j], g[j - 1]) - sum((times(tau[i], tau[j - i]) for i in range(1, j)), Poly([]))) * Fraction(1, 2))
            inv.append(sum((times(D[i], e[i - 1], inv[j - i]) for i in range(1, j + 1)), Poly([])) * -1)
        k = nu - 1
        total = sum((times(tau[i], inv[k - i], g[k - i], e[i]) for i in range(nu)), Poly([]))
        need(times(value, D[0], D[0], g[k], e[k], g[k], e[k]) == times(G[0], total, total) * 4, "eps2 is wrong")

    def local(self, d):
        num, den, rows = self.num, self.den, d["places"]
        need(len(rows) <= 20000 and all(e["q"].deg() >= 1 and e["q"].lead() == ONE for e in rows), "a place is not a monic polynomial")
        need(all(1 <= e["order"] <= SIZE for e in rows), "an order is not positive")
        need(sum(e["q"].deg() * e["order"] for e in rows) == self.dd, "the degrees do not add up to deg den")
        need(product(e["q"]**e["order"] for e in rows) == den, "the product of the places is not den")
        if rows:
            self.need_squarefree(product(e["q"] for e in rows), d["prime"], num)
        self.tests, self.second = {}, den.diff().diff()
        places, infinity = [self.place(e) for e in rows], self.infinity(d["infinity"])
        return Local("local", places=places, infinity=infinity, all=places + [infinity])

    def place(self, e):
        x, num, den = Place(e["q"], e["q"].deg(), e["order"]), self.num, self.den
        if e["delta2"] is not None:
            value = e["delta2"]
            need(x.order == 2 and value.deg() < x.n, "delta2 belongs to a pole of order 2")
            key = (tuple(value.c), value.q)
            if key not in self.tests:
                self.tests = dict(list(self.tests.items())[-15:]) | {key: num * 8 - (value - ONE) * self.second}
            need(not rem(self.tests[key], x.q).c, "delta2 is wrong")
            x.set_square(value, e["annihilator"])
        if e["irrational"] is not None:            # local_exponents.md 1.7
            need(x.order == 2 and x.delta is None, "irrational belongs to a pole of order 2")
            p, reduce, n, _ = self.good(e["irrational"])
            q, h = reduce(x.q), reduce(self.second)
            v = mdivmod(mmul(madd(h, n, p, 8), minv(h, q, p), p), q, p)[1]
            v = madd(mpow(v, (p + 1) // 2, q, p), v, p, -1)
            need(v and len(mgcd(v, q, p)) == 1, "irrationality is not seen modulo p")
            x.irrational = True
        if e["log"] is not None:
            roots = e["log"]["roots"] or []
            need(x.order == 2 and roots and len(set(roots)) == len(roots), "distinct roots are expected")
            p, reduce = self.good(e["log"])[:2]
            for c in roots:
                need(meval(reduce(x.q), c, p) == 0 and c < p, "not a root of the place modulo p")
                self.need_log(e["log"], c, x.delta)
            x.logs = len(roots)
        if e["eps2"] is not None:
            need(x.order >= 4 and x.order % 2 == 0 and e["eps2"].deg() < x.n, "eps2 belongs to a pole of even order >= 4")
            self.need_eps2(x, lambda i: rem(num.taylor(i), x.q), lambda i: rem(den.taylor(i + x.order), x.q), e["eps2"])
            x.set_square(e["eps2"], e["annihilator"])
        return x

    def infinity(self, d):
        x = Place(None, 1, 4 - (self.dd - self.dn) if self.dn >= 0 else 0)
        if x.order == 2:
            x.set_square(ONE + self.num.lead() * 4, d["annihilator"])
        if d["log"] is not None:
            need(x.order == 2 and not d["log"]["roots"], "no logarithm to prove at infinity")
            self.need_log(d["log"], None, x.delta)
            x.logs = 1
        if d["eps2"] is not None:
            need(x.order >= 4 and x.order % 2 == 0 and d["eps2"].deg() < 1, "eps2 belongs to an irregular place")
            self.need_eps2(x, lambda i: self.num.coeff(self.dn - i), lambda i: self.den.coeff(self.dd - i), d["eps2"])
            x.set_square(d["eps2"], d["annihilator"])
        return x

    def exponential(self, d):
        P, n, e = d["p"], d["num"], d["den"]
        need(P.c and e.c, "omega is not defined")
        left = e * e * P.diff().diff() + n * e * 2 * P.diff() + (n.diff() * e - n * e.diff() + n * n) * P
        need(self.den * left == self.num * (e * e) * P, "omega' + omega^2 is not r")
        return Fact("exponential")

    def invariant(self, d):
        m, P, factors = d["m"], d["p"], [(f["q"], f["e"]) for f in d["factors"]]
        need(1 <= m <= 200 and P.c, "not a nonzero function of degree 1 to 200")
        need(all(q.deg() >= 1 and q.lead() == ONE for q, _ in factors), "a factor is not a monic polynomial")
        need(all(abs(e) <= 10**7 and (e * (2 if m == 2 else 1)).denominator == 1 for _, e in factors),
             "exponents must be integers (half-integers for m = 2)")

        def sums(f):                               # prod q and the numerator of sum e q'/q
            if len(f) < 2:
                return (f[0][0], f[0][0].diff() * f[0][1]) if f else (ONE, Poly([]))
            (a, x), (b, y) = sums(f[:len(f) // 2]), sums(f[len(f) // 2:])
            return a * b, x * b + a * y
        S, theta = sums(factors)
        if S.deg() > 0:
            self.need_squarefree(S, d["prime"])
        if rem(S * S, self.den).c and self.dd > 0:
            S, theta = S * self.den, theta * self.den
        rs, T = self.num * division(S * S, self.den)[0], [P, S * P.diff() + theta * P]
        for i in range(1, m + 1):                  # normal_form.md 2.5
            T.append(S * T[i].diff() + (theta - S.diff() * i) * T[i] - rs * T[i - 1] * (i * (m - i + 1)))
        need(not T[m + 1].c, "the symmetric power does not vanish on v")
        x = Invariant("invariant", m=m, p=P, factors=factors, branch=product(q for q, e in factors if e.denominator == 2), top=Poly([]))
        if m == 2:
            z = next((z for z in range(2000) if S.at(z).c), None)
            need(z is not None, "no point to evaluate w^2")
            x.top, x.bottom = T[1].at(z)**2 - T[0].at(z) * T[2].at(z) * 2, S.at(z)**2
            x.powers = [(q.at(z), int(2 * e)) for q, e in factors if e]
        return x

    def no_exponential(self, d, local):
        if d["by"] == "parity":
            need(any(x.ramified for x in local.all), "no place of odd order")
        elif d["by"] == "degree":
            need(local.degree_bound_1() < 0, "D_1 is not negative")
        else:
            self.series(d, local)
        return Fact("irreducible")

    def series(self, d, local):                    # riccati_one_place.md
        p, reduce, num, den = self.good(d)
        root, terms, delta = d["root"], d["terms"], d["delta"]
        if d["place"] == "infinity":
            x, root = local.infinity, None
            need(x.order >= 1, "infinity is not singular")
        else:
            need(0 <= d["place"] < len(local.places), "no such place")
            x = local.places[d["place"]]
            need(root < p and meval(reduce(x.q), root, p) == 0, "not a root of the place modulo p")
        need(2 <= terms <= SIZE and delta < p, "too few or too many terms, or delta is not reduced")
        L = local.degree_bound_1() + sum(y.n * max(1, y.order // 2) for y in local.places)
        L += max(1, x.order // 2) if root is None else max(0, local.infinity.order // 2 - 2) + 1
        n, e = self.expansion(p, num, den, root, x.order)
        starts = [(1 + s) * (p + 1) // 2 % p if x.order <= 2 else s % p for s in (delta, -delta)]
        lines = [S for S in (self.riccati(n, e, x.order, s, terms, p) for s in dict.fromkeys(starts)) if S]
        need(len(lines) == len(d["lines"]), "each line that is left needs one approximant")
        for S, line in zip(lines, d["lines"]):
            C, length = line["approximant"], line["length"]
            need(len(C) <= length + 1 and all(v < p for v in C), "the approximant is longer than its length, or not reduced")
            v = mmul(C, S, p, terms)
            k = next((i for i in range(length, len(v)) if v[i]), -1)
            need(k >= 0 and k + 1 - length > L, "a solution of the allowed degree is not excluded")

    def p_curvature(self, d, local):               # p_curvature.md
        p, reduce, n, e = self.good(d)
        size, e1, rows = len(n) + len(e), mdiff(e, p), [([1], [])]
        need(p * size <= 10**7 and p * p * size <= LIMIT, "the prime is too large for a p-curvature")
        for k in range(p + 1):                     # y^(k) = (A y + B y')/den^k
            A, B = rows[-1]
            rows.append((madd(madd(mmul(e, mdiff(A, p), p), mmul(e1, A, p), p, -k), mmul(n, B, p), p),
                         madd(madd(mmul(e, A, p), mmul(e, mdiff(B, p), p), p), mmul(e1, B, p), p, -k)))
            rows = rows[-2:]
        (A, B), (next_A, _) = rows
        f, r = mdivmod(madd(mmul(mmul(A, A, p), e, p), mmul(B, next_A, p), p), e, p)
        need(not r and not any(x for i, x in enumerate(f) if i % p), "the p-curvature is not a p-th power")
        b = rest = f[::p]
        need(b, "the p-curvature is nilpotent")
        if d["shows"] == "sl2":
            need(p >= 7 and local is not None, "sl2 needs p >= 7 and a local premise")
            for q in (reduce(x.q) for x in local.places if x.exchanges_lines()):
                while len(g := mgcd(rest, q, p)) > 1:
                    rest = mdivmod(rest, g, p)[0]
            need(len(rest) > 1 and not is_square(rest, p) or len(b) % 2 == 0 and not local.infinity.exchanges_lines(),
                 "no odd place of B_p is excluded")
        else:
            need(d["shows"] == "nonzero" or d["shows"] == "irreducible" and not is_square(b, p), "B_p is a square")
        return Fact("p-curvature", shows=d["shows"], p=p)

    def no_invariant(self, d, local):              # invariants_one_point.md
        m = d["m"]
        need(2 <= m <= 200 and m % 2 == 0, "m must be even")
        D = local.degree_bound(m)
        if d["by"] == "degree":
            need(D < 0, "D_m is not negative")
            return Fact("no-invariant", m=m)
        need(all(x.lowest(m) is not None for x in local.places), "the degree bound is negative: use degree")
        p, reduce, num, den = self.good(d)
        T, x0, groups, U, D = d["terms"], d["x0"], {}, [1], max(D, -1)
        need(0 <= T - D - m - 2 <= 1000 and T <= min(p, 10 * SIZE) and T * (len(num) + len(den)) <= LIMIT, "terms out of range")
        need(x0 < p and meval(den, x0, p), "x0 is a pole modulo p")
        n, e = mshift(num, x0, p), mshift(den, x0, p)
        y1, y2 = (self.solution(n, e, y, T, p) for y in ([1, 0], [0, 1]))
        for x in local.places:
            groups.setdefault(x.lowest(m), []).append(reduce(x.q))
        for k, qs in groups.items():
            need(abs(k) < 10**7, "an exponent is too large")
            while len(qs) > 1:
                qs = [mmul(f, g, p) for f, g in zip(qs[::2], qs[1::2] + [[1]])]
            f = mshift(qs[0], x0, p)
            U = mmul(U, power_series(mseries(f, p, T) if k > 0 else f, abs(k), p, T), p, T)
        a, b = [[1]], [U]
        for i in range(m):
            a.append(mmul(a[i], y1, p, T))
            b.append(mmul(b[i], y2, p, T))
        need(rank([(mmul(a[i], b[m - i], p, T) + [0] * T)[D + 1:T] for i in range(m + 1)], p) == m + 1, "the rank is not m + 1")
        return Fact("no-invariant", m=m)

    @staticmethod
    def solution(n, e, y, T, p):
        """den y'' = num y with given y(0), y'(0)"""
        u, w, n, e = pow(e[0], -1, p), [], n[::-1], e[:0:-1]     # w_i = (i+2)(i+1) y_(i+2)
        for k in range(T - 2):
            s = sum(map(mul, n[-k - 1:], y[max(0, k + 1 - len(n)):k + 1])) - sum(map(mul, e[-k:] if k else [], w[max(0, k - len(e)):k]))
            w.append(s * u % p)
            y.append(w[-1] * pow((k + 2) * (k + 1), -1, p) % p)
        return y

    def torsion_function(self, d, local, v):       # dihedral_torsion.md 6
        n, a, b, c, f = d["n"], d["a"], d["b"], d["den"], v.branch
        need(1 <= n <= 10**6 and c.c and (a.c or b.c), "not a torsion function")
        (A, B), top, bottom = v.fraction(), v.top, v.bottom
        need(sum(abs(k) for _, k in v.powers) <= 10**5, "an exponent is too large")
        for u, k in v.powers:
            top, bottom = (top * u**k, bottom) if k > 0 else (top, bottom * u**-k)
        need((a.diff() * c - a * c.diff()) * A * bottom == top * b * B * c * n and
             ((b.diff() * c - b * c.diff()) * f * 2 + b * c * f.diff()) * A == a * B * c * (2 * n), "h' = n (w/v) h fails")
        L, left, l, seen = local.residue_denominator(v) if local else 1, n, 2, {t["l"] for t in d["minimal"]}
        while left > 1:
            k = 1
            while left % l == 0:
                left, k = left // l, k * l
            need(L % k == 0 or l in seen, "it is not shown that h is not a power")
            l += 1
        for t in d["minimal"]:
            p, reduce = self.good(t)[:2]
            l, w, F, h = t["l"], t["w"], reduce(f), []
            need(l >= 2 and p % l == 1 and n % l == 0, "l must divide n and p - 1")
            need(meval(mdiff(K.m, p), t["a"], p), "the prime ramifies")
            v.need_root(w, p, reduce)
            need(not is_square(F, p), "F0 is a square modulo p")
            for x, s in ((t["x1"], t["s1"]), (t["x2"], t["s2"])):
                u, e, g = (meval(reduce(y), x, p) for y in (a, b, c))
                need(0 < s < p and x < p and (s * s - meval(F, x, p)) % p == 0 and g, "not a point where h is defined")
                h.append((u + e * w * s) * pow(g, -1, p) % p)
            need(h[0] and h[1] and pow(h[0] * pow(h[1], -1, p), (p - 1) // l, p) != 1, "h(1)/h(2) is a power")
        return Fact("torsion-function", n=n, of=v)

    def good_reduction(self, d, local, v):         # dihedral_torsion.md 7
        p, reduce = self.good(d)[:2]
        f, genus = reduce(v.branch), (v.branch.deg() - 1) // 2
        need(len(mgcd(f, mdiff(f, p), p)) == 1, "F0 is not squarefree modulo p")
        need(meval(mdiff(K.m, p), d["a"], p), "the prime ramifies")
        need(all(sum(reduce(c)) for c in (v.top, v.bottom, *(c for c, _ in v.powers))), "w^2 is not a unit modulo p")
        return Fact("good-reduction", p=p, bound=(p + 2 + isqrt(4 * p))**genus, of=v)

# ---- conclusions (docs/theory/trichotomy.md) ----------------------------------------------------------------------------------------

COMPONENT = {"SL2": "SL2", "Borel": "Borel", "T": "Ga", "Gm": "Gm", "cyclic": "trivial", "Dinf": "Gm", "D": "trivial",
             "A4": "trivial", "S4": "trivial", "A5": "trivial", None: None}
PRIMITIVE = {"tetrahedral": ("A4", 6, {4}), "octahedral": ("S4", 8, {4, 6}), "icosahedral": ("A5", 12, {8})}

def conclude(theorem, facts):
    """(group, n, abelian); each theorem is a row of the table in certificates.md."""
    first = {x.kind: x for x in reversed(facts)}
    local, v, torsion, reduction, curvature = (first.get(k) for k in ("local", "invariant", "torsion-function", "good-reduction", "p-curvature"))
    shows, absent = curvature and curvature.shows, {x.m for x in facts if x.kind == "no-invariant"}
    irreducible = "irreducible" in first or shows in ("irreducible", "sl2")
    log, infinite = bool(local) and any(x.logs for x in local.all), bool(local) and local.infinite_order()
    quadratic = bool(v) and v.m == 2 and bool(v.top.c)
    split, dihedral = quadratic and v.branch.deg() == 0, quadratic and v.branch.deg() > 0
    non_diagonal = log or 2 in absent or 4 in absent

    def given(condition, group, n=None):
        need(condition, f"the premises of {theorem} are not all given")
        n = n() if n else None
        return ("cyclic", 4, True) if (group, n) == ("D", 1) else (group, n, group not in ("SL2", "Borel"))
    if theorem == "sl2-p-curvature":
        return given(shows == "sl2", "SL2")
    if theorem == "sl2-irreducible-log":
        return given(irreducible and log, "SL2")
    if theorem == "sl2-irreducible-infinite":
        orders = {x.delta.denominator for x in local.all if x.delta is not None} if local else set()
        return given(irreducible and 4 in absent and (infinite or log or {4, 5} <= orders or any(k >= 6 for k in orders)), "SL2")
    if theorem == "sl2-irreducible-12":
        return given(irreducible and 12 in absent, "SL2")
    if theorem == "borel":
        return given("exponential" in first and non_diagonal and infinite, "Borel")
    if theorem == "additive":
        return given("exponential" in first and local and non_diagonal, "T", lambda: local.character_order())
    if theorem == "diagonal":
        return given(local and split, *(("Gm",) if infinite else ("cyclic", lambda: local.character_order())))
    if theorem == "dihedral-infinite":
        return given(dihedral and infinite, "Dinf")
    if theorem == "dihedral-genus-0":
        return given(dihedral and local and not infinite and v.branch.deg() <= 2, "D", lambda: local.residue_denominator(v))
    if theorem == "dihedral-finite":
        return given(dihedral and torsion and torsion.of is v, "D", lambda: torsion.n)
    if theorem == "dihedral-torsion":
        need(dihedral and local and reduction and reduction.of is v, "a premise is missing")
        primes = {x.p for x in facts if x.kind == "p-curvature"} - {reduction.p}
        return given(gcd(2 * local.residue_denominator(v), prod(primes)) == 1 and prod(primes) > reduction.bound, "Dinf")
    if theorem == "quaternion":
        vs = [x for x in facts if x.kind == "invariant" and x.m == 4]
        need(irreducible and len(vs) == 2, "a premise is missing")
        (a, b), (c, d) = vs[0].fraction(), vs[1].fraction()
        f, g = a * d, c * b
        return given(not f * g.lead() == g * f.lead(), "D", lambda: 2)
    if theorem in PRIMITIVE:
        group, m, none = PRIMITIVE[theorem]
        return given(irreducible and none <= absent and any(x.kind == "invariant" and x.m == m for x in facts), group)
    if theorem == "invariant-abelian":
        return given(v, None)
    need(theorem == "torus-nonabelian" and infinite and 4 in absent, f"the premises of {theorem!r} are not all given, or it is unknown")
    return None, None, False

def run(checker, rule, data, given):
    """One step: hands the premises to the rule by their kind."""
    local, v = (next((x for x in given if x.kind == k), None) for k in ("local", "invariant"))
    check = getattr(checker, rule.replace("-", "_"))
    if rule in ("local", "exponential", "invariant"):
        need(not given, "no premises are expected")
        return check(data)
    need(local or rule in ("p-curvature", "torsion-function", "good-reduction"), "a local premise is missing")
    if rule in ("no-exponential", "p-curvature", "no-invariant"):
        return check(data, local)
    need(v and v.m == 2 and v.branch.deg() > 0 and v.top.c, "an invariant premise is missing")
    return check(data, local, v)

def verify(text):
    """The number of trusted steps; raises Malformed or Rejected."""
    num, den, claim, steps = load(text)
    need(len(K.m) == 2 or irreducible(K.m), "the minimal polynomial is reducible")
    need(den.c and den.lead() == ONE, "den is not monic")
    need(num.c or den.deg() == 0, "r = 0 must be written with den = 1")
    checker, facts, used, trusted, result = Checker(num, den), {}, set(), 0, None
    for name, rule, premises, data in steps:
        try:
            need(name not in facts, "the id occurs twice")
            need(all(x in facts for x in premises), "a premise is not an earlier step")
            used.update(premises)
            given = [facts[x] for x in premises]
            if rule == "conclude":
                result = conclude(data["theorem"], given)
                facts[name] = Fact("conclusion")
            elif rule == "apply-theorem":
                need(any(x.kind == "conclusion" for x in given), "the theorem is not applied to a conclusion")
                trusted, facts[name] = trusted + 1, Fact("conclusion")
            else:
                facts[name] = run(checker, rule, data, given)
        except (Rejected, ArithmeticError, ValueError, LookupError, TypeError, AttributeError, MemoryError) as why:
            raise Rejected(f"step {name!r} ({rule}): {why}") from None
    need(steps[-1][1] in ("conclude", "apply-theorem") and result, "the last step is not a conclusion")
    need(used >= {s[0] for s in steps[:-1]}, "a step is not used")
    need(claim, "nothing is claimed")
    for key, value in zip(CLAIM, (result[0], result[1], COMPONENT[result[0]], result[2])):
        need(key not in claim or claim[key] == value, f"the claim does not follow: {key}")
    return trusted

def main(args):
    files = [x for x in args if x != "--strict"]
    if len(files) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    getattr(sys, "set_int_max_str_digits", lambda n: None)(0)
    try:
        text = sys.stdin.buffer.read() if files[0] == "-" else open(files[0], "rb").read()
        trusted = verify(text.decode("utf-8"))
        need(not trusted or "--strict" not in args, f"{trusted} trusted steps, refused by --strict")
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
