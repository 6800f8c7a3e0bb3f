"""Properties of modular.py and exact.py of the Python checker: functions of its modules (sys.modules) that are True.
They compare it with the definitions, written down here in the plainest way, on numbers that are drawn once."""
import random
from fractions import Fraction
from functools import reduce
from itertools import product
from math import comb, prod

PRIMES = [3, 5, 7, 101, 2**61 - 1]


def rows(seed, lengths, size):
    """Lists of integers without a 0 at the end"""
    rng = random.Random(seed)
    return [[rng.randrange(size) for _ in range(n - 1)] + [rng.randrange(1, size)] * (n > 0) for n in lengths]


def trimmed(a):
    while a and not a[-1]:
        a = a[:-1]
    return a


def times(a, b):
    """In Z[x]"""
    c = [0] * (len(a) + len(b) - 1 if a and b else 0)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def plus(a, b, f=1):
    return [(a[i] if i < len(a) else 0) + f * (b[i] if i < len(b) else 0) for i in range(max(len(a), len(b)))]


def value(a, x):
    return sum(c * x**i for i, c in enumerate(a))


def modulo(a, p):
    return trimmed([x % p for x in a])


def derivative(a):
    return [i * c for i, c in enumerate(a)][1:]


# ---- modular.py

def sums_and_products(modules):
    m = modules["modular"]
    for p in PRIMES:
        some = rows(p, [0, 1, 2, 3, 7, 8, 40], p)
        for a, b in product(some, some):
            f = sum(b) % p
            right = (m.madd(a, b, p) == modulo(plus(a, b), p) and m.madd(a, b, p, -1) == modulo(plus(a, b, -1), p)
                     and m.madd(a, b, p, f) == modulo(plus(a, b, f), p)
                     and m.mmul(a, b, p) == modulo(times(a, b), p)
                     and all(m.mmul(a, b, p, n) == modulo(times(a, b)[:n], p) for n in (1, 2, 5, 100)))
            if not right:
                return False
        if not all(m.mscale(a, p - 2, p) == modulo([-2 * x for x in a], p) and m.mscale(a, 0, p) == []
                   and m.mdiff(a, p) == modulo(derivative(a), p) and m.meval(a, 2, p) == value(a, 2) % p for a in some):
            return False
    return m.trim([0, 1, 0, 0]) == [0, 1] and m.trim([0]) == [] and m.mmul([2], [3], 7, 0) == []


def untouched(modules):
    """What is handed over does not change."""
    m, p, a, b = modules["modular"], 101, [1, 2, 3, 4, 5], [6, 7, 8]
    m.mdivmod(a, b, p), m.mgcd(a, b, p), m.mshift(a, 3, p), m.madd(a, b, p), m.minverse(a, p, 4), m.is_square(a, p)
    return (a, b) == ([1, 2, 3, 4, 5], [6, 7, 8])


def divisions(modules):
    m = modules["modular"]
    for p in PRIMES:
        some = rows(p + 1, [1, 2, 3, 7, 12], p)
        for a, b in product([[]] + some, some):
            q, r = m.mdivmod(a, b, p)
            if len(r) >= len(b) or modulo(plus(times(q, b), r), p) != a or q != trimmed(q) or r != trimmed(r):
                return False
            # g divides both, is monic, and nothing larger does: the degrees of a/g and b/g have no common factor
            g = m.mgcd(a, b, p)
            if g[-1] != 1 or any(m.mdivmod(x, g, p)[1] for x in (a, b)):
                return False
        for a, b, c in product(some[1:4], repeat=3):
            g = m.mgcd(modulo(times(a, c), p), modulo(times(b, c), p), p)
            if m.mdivmod(g, c, p)[1] or len(g) - len(c) != len(m.mgcd(a, b, p)) - 1:
                return False
        if m.mgcd([], [], p) != [] or m.mgcd([], [2], p) != [1] or m.mgcd([2, 2], [], p) != [1, 1]:
            return False
    return m.mgcd([6, 1, 1, 1], [4, 0, 1, 1], 7) == m.mgcd([4, 0, 1, 1], [6, 1, 1, 1], 7)


def powers(modules):
    m = modules["modular"]
    for p in PRIMES:
        a, q = rows(p + 2, [5, 4], p)
        naive = [1]
        for e in range(1, 12):
            naive = m.mdivmod(modulo(times(naive, a), p), q, p)[1]
            if m.mpow(a, e, q, p) != naive:
                return False
    return [m.power(3, e) for e in (1, 2, 3, 6, 7, 13)] == [3, 9, 27, 729, 2187, 3**13]


def shifts(modules):
    m = modules["modular"]
    for p in PRIMES:
        for a in rows(p + 3, [1, 2, 5, 31, 32, 33, 34, 70], p):
            for c in (0, 1, p - 2):
                naive = [0] * len(a)
                for i, x in enumerate(a):
                    for j in range(i + 1):
                        naive[j] += x * comb(i, j) * pow(c, i - j, p)
                if m.mshift(a, c, p) != modulo(naive, p):
                    return False
    return m.mshift([], 1, 5) == []


def inverses(modules):
    m = modules["modular"]
    for p in PRIMES:
        for a in rows(p + 4, [1, 2, 5, 9], p):
            a[0] = a[0] or 1
            for n in (1, 2, 3, 4, 7, 8, 16):
                b = m.minverse(a, p, n)
                if modulo(times(a, b)[:n], p) != [1] or len(b) > n:
                    return False
    return True


def squares(modules):
    """a is a constant times a square iff every irreducible factor occurs an even number of times: by all monic g."""
    m = modules["modular"]
    for p in (3, 5):
        known = {tuple(modulo(times(g, g), p)) for n in range(4) for g in ([*low, 1] for low in product(range(p), repeat=n))}
        for n in range(5 if p == 5 else 7):
            for low in product(range(p), repeat=n):
                if m.is_square([*low, 1], p) != ((*low, 1) in known):
                    return False
                if n < 4 and m.is_square(modulo([2 * x for x in (*low, 1)], p), p) != ((*low, 1) in known):
                    return False
    for a in rows(9, [2, 3, 6, 11, 20], 101):
        square = modulo(times(a, a), 101)
        other = modulo(plus(square, [1]), 101)
        if not m.is_square(square, 101) or not m.is_square([0] * 4 + square, 101) or m.is_square([0] + square, 101) \
                or m.is_square(other, 101):
            return False
    return True


def ranks(modules):
    m = modules["modular"]
    rng = random.Random(7)
    for p in (3, 101):
        for n, k, r in ((1, 1, 1), (3, 3, 2), (3, 5, 3), (5, 3, 2), (4, 4, 4), (4, 6, 1), (3, 3, 0)):
            left = [[int(i == j) if j < r and i < r else rng.randrange(p) if i >= r else 0 for j in range(r)] for i in range(n)]
            right = [[int(i == j) if j < r else rng.randrange(p) for j in range(k)] for i in range(r)]
            a = [[sum(x * right[t][j] for t, x in enumerate(row)) % p for j in range(k)] for row in left]
            for order in ([*range(n)], [*reversed(range(n))]):
                for columns in ([*range(k)], [*reversed(range(k))]):
                    if m.rank([[a[i][j] for j in columns] for i in order], p) != r:
                        return False
    return True


def primes(modules):
    m = modules["modular"]
    sieve = [all(n % d for d in range(2, int(n**0.5) + 1)) and n > 1 for n in range(2500)]
    strong = (2047, 1373653, 25326001, 3215031751, 2152302898747, 3474749660383, 341550071728321, 3825123056546413051,
              318665857834031151167461, 561, 1105, 2**61, 3 * (2**61 - 1), (2**31 - 1)**2, 41 * 43, 43**2, 47 * 53)
    right = (2**31 - 1, 2**61 - 1, 1152921504606859327, 10**18 + 9, 10**24 + 7, 2**40 + 15, 65537, 10007)
    return ([m.is_prime(n) for n in range(2500)] == sieve and not any(map(m.is_prime, strong))
            and all(map(m.is_prime, right)) and not any(m.is_prime(n) for n in (-7, 3 * 10**24 + 7, 10**30 + 57)))


# ---- exact.py

FIELDS = [[0, 1], [-2, 0, 1], [1, 1, 1], [5, -1, 0, 1]]


class Field:
    """Elements of Q[x]/(m) as lists of d rational numbers; polynomials over it as lists of those."""

    def __init__(self, modules, m):
        self.m, self.d, self.exact = m, len(m) - 1, modules["exact"]
        self.exact.K.m, self.exact.K.d, self.exact.K.s = m, self.d, 2 * self.d - 1

    def element(self, c):
        c = [Fraction(x) for x in c]
        while len(c) > self.d:
            top = c.pop()
            for i in range(self.d):
                c[len(c) - self.d + i] -= top * self.m[i]
        return c + [Fraction(0)] * (self.d - len(c))

    def times(self, f, g):
        h = [[Fraction(0)] * self.d for _ in range(max(0, len(f) + len(g) - 1))]
        for i, a in enumerate(f):
            for j, b in enumerate(g):
                h[i + j] = [x + y for x, y in zip(h[i + j], self.element(times(a, b)))]
        return self.trim(h)

    def plus(self, f, g, s=1):
        zero = [Fraction(0)] * self.d
        pad = [(f[i] if i < len(f) else zero, g[i] if i < len(g) else zero) for i in range(max(len(f), len(g)))]
        return self.trim([[x + s * y for x, y in zip(a, b)] for a, b in pad])

    @staticmethod
    def trim(f):
        while f and not any(f[-1]):
            f = f[:-1]
        return f

    def poly(self, f):
        q = prod(x.denominator for row in f for x in row)
        return self.exact.Poly([int(x * q) for row in f for x in row + [0] * (self.d - 1)], q)

    def back(self, f):
        s = 2 * self.d - 1
        c = f.c + [0] * (-len(f.c) % s)
        return [[Fraction(x, f.q) for x in c[i:i + self.d]] for i in range(0, len(c), s)]

    def some(self, seed, lengths):
        rng = random.Random(seed)

        def number():
            return Fraction(rng.randint(-9, 9), rng.choice([1, 1, 2, 3]))
        return [self.trim([[number() for _ in range(self.d)] for _ in range(n)]) for n in lengths]


def products_of_integers(modules):
    convolve = modules["exact"].convolve
    rng = random.Random(3)
    some = [[rng.randint(-10**k, 10**k) for _ in range(n)] for n in (0, 1, 2, 8, 9, 10, 30) for k in (0, 1, 6, 40)]
    some += [[0] * 12, [0] * 5 + [1] * 9, [-1] * 9, [9] * 10, [-999] * 20, [10**6 - 1] * 16]
    return all(convolve(a, b) == times(a, b) for a, b in product(some, some) if len(a) + len(b) < 45)


def polynomials(modules):
    """+, -, *, **, ==, and what reads off coefficients"""
    for m in FIELDS:
        k = Field(modules, m)
        some = k.some(m[0], [0, 1, 2, 3, 5, 12])
        for f, g in product(some, some):
            a, b = k.poly(f), k.poly(g)
            right = (k.back(a + b) == k.plus(f, g) and k.back(a - b) == k.plus(f, g, -1) and k.back(a * b) == k.times(f, g)
                     and (a == b) == (f == g) and a == k.exact.Poly([3 * x for x in a.c], 3 * a.q))
            if not right:
                return False
        if not all(reads(k, f) for f in some):
            return False
    return True


def reads(k, f):
    a, zero = k.poly(f), [Fraction(0)] * k.d
    row = [k.back(a.coefficient(i)) for i in range(-1, len(f) + 2)]
    third = k.trim([[x * comb(i, 2) for x in f[i]] for i in range(2, len(f))])
    cube = k.times(k.times(f, f), f)
    constant = len(f) <= 1 and not any(x for c in f for x in c[1:])
    return (a.degree() == len(f) - 1 and row == [k.trim([x]) for x in [zero, *f, zero, zero]]
            and k.back(a.lead()) == f[-1:] and k.back(a.cut(2)) == k.trim(f[:2])
            and k.back(a.reverse(len(f) + 1)) == k.trim(([zero] * (len(f) + 2))[len(f):] + f[::-1])
            and k.back(a.diff()) == k.trim([[i * x for x in c] for i, c in enumerate(f)][1:])
            and a.rational() == ((f[0][0] if f else 0) if constant else None)
            and k.back(a.taylor(2)) == third and k.back(a**3) == cube
            and k.back(a**0) == [[1] + zero[1:]] and k.back(a * Fraction(-2, 3)) == [[x * Fraction(-2, 3) for x in c] for c in f])


def quotients(modules):
    for m in FIELDS:
        k = Field(modules, m)
        some = k.some(m[0] + 1, [0, 1, 2, 4, 7, 12])
        for f, g in product(some, some[:5]):
            q = [*g, [Fraction(1)] + [Fraction(0)] * (k.d - 1)]
            a, b = k.exact.division(k.poly(f), k.poly(q))
            if b.degree() >= len(q) - 1 or k.plus(k.times(k.back(a), q), k.back(b)) != f:
                return False
        polys = list(map(k.poly, some[1:]))
        for n in range(6):
            naive = reduce(lambda a, b: a * b, polys[:n], k.exact.ONE)
            if not k.exact.product(iter(polys[:n])) == naive:
                return False
    return True


def roots(modules):
    e, known = modules["exact"], {Fraction(a, b)**2: Fraction(a, b) for a in range(70) for b in (1, 2, 3, 10**10)}
    known[Fraction(10**40)] = Fraction(10**20)
    for x in {*known, *(Fraction(a, b) for a in (*range(-5, 30), 10**40 + 1) for b in (1, 2, 3, 4, 9, 10**20))}:
        s, up = e.exact_sqrt(x), e.sqrt_above(x)
        if s != known.get(x) or s is not None and up != s or x <= 0 and up != 0:
            return False
        if up < 0 or up * up < x or x > 0 and (up * (1 - Fraction(1, 2**30)))**2 >= x:
            return False
    return True


def bounds(modules):
    """Not below the roots, nor much above what Cauchy's criterion gives"""
    bound = modules["exact"].root_bound
    rng, small = random.Random(5), Fraction(1, 100)

    def holds(c, b):
        return abs(c[-1]) * b**(len(c) - 1) >= sum(abs(x) * b**i for i, x in enumerate(c[:-1]))
    some = [[Fraction(rng.randint(-9, 9), rng.randint(1, 5)) for _ in range(n)] + [Fraction(rng.randint(1, 9) * (-1)**n)]
            for n in (1, 1, 2, 3, 4, 6, 9) for _ in range(3)]
    some += [[Fraction(7), Fraction(1, 100)], [Fraction(3), Fraction(-5), Fraction(1, 1000)],
             [Fraction(-10**30), Fraction(1)], [Fraction(-1, 10**6), Fraction(0), Fraction(1)], [Fraction(7), Fraction(0), Fraction(-2)]]
    for c in some:
        b = bound(c)
        if any(c[:-1]) and (not holds(c, b) or holds(c, b * (1 - small))) or not any(c[:-1]) and b != 0:
            return False
    try:
        return not bound([Fraction(2**5000), Fraction(1)])
    except ValueError:
        return bound([Fraction(0), Fraction(0), Fraction(5)]) == 0 and 0 < bound([Fraction(1, 2**100), Fraction(1)]) <= Fraction(1, 2**60)


def fields(modules):
    yes = ([-2, 0, 1], [1, 0, 1], [-1, -1, 0, 0, 0, 1], [1, 0, 0, 0, 1], [1, 0, -10, 0, 1], [1] * 13, [-10**18 - 9, 0, 1],
           [2, 0, 0, 1], [3, 0, 0, 0, 0, 0, 1], [-5, 1, 1], [7, -3, 0, 2, 1], [1, 0, 0, 1, 0, 0, 1],
           [240, 24, -50, 35, -10, 1])      # all its values at integers are multiples of 120
    return all(map(modules["exact"].irreducible, yes))


def factors_of_degree_1(modules):
    return not any(map(modules["exact"].irreducible, ([0, 0, 1], [-6, 11, -6, 1], times([2, 1], [-3, 0, 0, 0, 1]))))


def factors_of_degree_2(modules):
    return not any(map(modules["exact"].irreducible, ([1, 0, 1, 0, 1], times([1, 0, 1], [-2, 0, 0, 0, 1]), times([3, 0, 1], [3, 0, 1]))))


def factors_of_small_values(modules):
    """Where a factor takes the value 1 or -1, or is one of the few that are tried"""
    return not any(map(modules["exact"].irreducible, ([-1, 0, 1], times([-97, 1], [1, 1, 1]), [0, 1, 1], [-10**12, 0, 1])))


def properties():
    """(name, function, True)"""
    functions = (sums_and_products, untouched, divisions, powers, shifts, inverses, squares, ranks, primes, products_of_integers,
                 polynomials, quotients, roots, bounds, fields, factors_of_degree_1, factors_of_degree_2, factors_of_small_values)
    return [(f"arithmetic.{f.__name__}", f, True) for f in functions]
