"""Exact arithmetic with polynomials modulo a prime, as lists of residues, ascending; primes."""
from operator import mul


def trim(a):
    """Drops leading zeros; lists of coefficients are ascending."""
    while a and not a[-1]:
        a.pop()
    return a


def power(a, e, times=mul):
    """a^e, e >= 1, by repeated squaring."""
    if e == 1:
        return a
    b = power(times(a, a), e // 2, times)
    return times(a, b) if e % 2 else b


def madd(a, b, p, f=1):
    """a + f b"""
    n = max(len(a), len(b))
    return trim([(x + f * y) % p for x, y in zip(a + [0] * (n - len(a)), b + [0] * (n - len(b)))])


def mmul(a, b, p, n=None):
    """a b modulo z^n, as a product of two large integers (Kronecker)."""
    a, b = a[:n], b[:n]
    if not a or not b:
        return []
    size = (2 * p.bit_length() + len(a).bit_length()) // 8 + 1
    x, y = (int.from_bytes(b"".join(t.to_bytes(size, "little") for t in v), "little") for v in (a, b))
    c = (x * y).to_bytes(size * (len(a) + len(b)), "little")
    return trim([int.from_bytes(c[i:i + size], "little") % p for i in range(0, len(c), size)][:n])


def mscale(a, f, p):
    return trim([x * f % p for x in a])


def mdiff(a, p):
    return trim([i * x % p for i, x in enumerate(a)][1:])


def mdivmod(a, b, p):
    a, m, u = a[:], len(b) - 1, pow(b[-1], -1, p)
    quotient = [0] * max(0, len(a) - m)
    for i in range(len(a) - 1, m - 1, -1):
        quotient[i - m] = f = a[i] * u % p
        if f:
            a[i - m:i] = [(x - f * y) % p for x, y in zip(a[i - m:i], b)]
    return trim(quotient), trim(a[:m])


def mgcd(a, b, p):
    """Monic."""
    while b:
        a, b = b, mdivmod(a, b, p)[1]
    return mscale(a, pow(a[-1], -1, p), p) if a else a


def mpow(a, e, q, p):
    """a^e modulo q, e >= 1"""
    return power(mdivmod(a, q, p)[1], e, lambda x, y: mdivmod(mmul(x, y, p), q, p)[1])


def meval(a, x, p):
    v = 0
    for y in reversed(a):
        v = (v * x + y) % p
    return v


def mshift(a, c, p):
    """a(z + c), by halves"""
    if len(a) > 32:
        h = len(a) // 2
        top = mmul(mshift(a[h:], c, p), power([c, 1], h, lambda x, y: mmul(x, y, p)), p)
        return madd(mshift(a[:h], c, p), top, p)
    a = a[:]
    for i in range(len(a)):
        for j in range(len(a) - 2, i - 1, -1):
            a[j] = (a[j] + c * a[j + 1]) % p
    return a


def minverse(a, p, n):
    """1/a modulo z^n, by Newton's iteration"""
    b, k = [pow(a[0], -1, p)], 1
    while k < n:
        k = min(2 * k, n)
        b = mmul(b, madd([2], mmul(a, b, p, k), p, -1), p, k)
    return b


def is_square(b, p):
    """Is b, not 0, a constant times a square over the algebraic closure of F_p, p odd?"""
    if len(b) % 2 == 0:
        return False
    n, root = len(b) // 2 + 1, [1]
    reverse = mscale(b[::-1], pow(b[-1], -1, p), p)
    while len(root) < n:                    # Newton: root = (root + reverse/root)/2
        k = min(2 * len(root), n)
        root = mscale(madd(root, mmul(reverse, minverse(root, p, k), p, k), p), (p + 1) // 2, p)
        root += [0] * (k - len(root))
    return mmul(root, root, p) == reverse


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
    return found


def is_prime(n):
    """Miller and Rabin; these bases prove primality below 3.3e24, larger numbers are refused."""
    bases = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41)
    if n < 43 or not all(n % q for q in bases) or n > 3 * 10**24:
        return n in bases
    s = (n - 1 & 1 - n).bit_length() - 1
    return all(pow(b, n - 1 >> s, n) == 1 or any(pow(b, n - 1 >> s - i, n) == n - 1 for i in range(s)) for b in bases)
