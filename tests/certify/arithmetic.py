"""Properties of the arithmetic of the Python checker: functions of its modules (sys.modules) that are True.  They compare
it with the definitions, written down here in the plainest way, on numbers that are drawn once."""
import random
from fractions import Fraction
from functools import reduce
from itertools import permutations, product
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
            and all(map(m.is_prime, right)) and not any(m.is_prime(n) for n in (-7, 3 * 10**24 + 43, 10**30 + 57)))


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
    at = [Fraction(0)] * k.d
    for c in reversed(f):
        at = [-3 * x + y for x, y in zip(at, c)]
    cube = k.times(k.times(f, f), f)
    constant = len(f) <= 1 and not any(x for c in f for x in c[1:])
    return (a.degree() == len(f) - 1 and row == [k.trim([x]) for x in [zero, *f, zero, zero]]
            and k.back(a.lead()) == f[-1:] and k.back(a.cut(2)) == k.trim(f[:2])
            and k.back(a.reverse(len(f) + 1)) == k.trim(([zero] * (len(f) + 2))[len(f):] + f[::-1])
            and k.back(a.diff()) == k.trim([[i * x for x in c] for i, c in enumerate(f)][1:])
            and a.rational() == ((f[0][0] if f else 0) if constant else None)
            and k.back(a.at(-3)) == k.trim([at]) and k.back(a.taylor(2)) == third and k.back(a**3) == cube
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
    some += [[Fraction(-10**30), Fraction(1)], [Fraction(-1, 10**6), Fraction(0), Fraction(1)], [Fraction(7), Fraction(0), Fraction(-2)]]
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
           [2, 0, 0, 1], [3, 0, 0, 0, 0, 0, 1], [-5, 1, 1], [7, -3, 0, 2, 1], [1, 0, 0, 1, 0, 0, 1])
    return all(map(modules["exact"].irreducible, yes))


def factors_of_degree_1(modules):
    return not any(map(modules["exact"].irreducible, ([0, 0, 1], [-6, 11, -6, 1], times([2, 1], [-3, 0, 0, 0, 1]))))


def factors_of_degree_2(modules):
    return not any(map(modules["exact"].irreducible, ([1, 0, 1, 0, 1], times([1, 0, 1], [-2, 0, 0, 0, 1]), times([3, 0, 1], [3, 0, 1]))))


def factors_of_small_values(modules):
    """Where a factor takes the value 1 or -1, or is one of the few that are tried"""
    return not any(map(modules["exact"].irreducible, ([-1, 0, 1], times([-97, 1], [1, 1, 1]), [0, 1, 1], [-10**12, 0, 1])))


# ---- multivariate.py

NAMES = {"z": 0, "A": 32, "B": 64}


def text(terms):
    """{(i, j, k): c} as a polynomial of the format"""
    parts = []
    for e, c in terms.items():
        powers = [n if i == 1 else f"{n}^{i}" for n, i in zip(NAMES, e) if i]
        parts.append(("-" if c < 0 else "+", "*".join([str(abs(c)), *powers] if abs(c) != 1 or not powers else powers)))
    first = ("-" if parts[0][0] == "-" else "") + parts[0][1] if parts else "0"
    return first + "".join(f" {s} {t}" for s, t in parts[1:])


def several(seed, n):
    """Pairs of a polynomial as {exponents: coefficient} and as text"""
    rng = random.Random(seed)
    found = [{}, {(0, 0, 0): 3}, {(1, 0, 0): -1}]
    for _ in range(n):
        found.append({tuple(rng.choice([0, 0, 1, 1, 2, 3]) for _ in range(3)): rng.choice([-6, -2, -1, 1, 2, 3])
                      for _ in range(rng.randint(1, 4))})
    return found


def mtimes(f, g):
    h = {}
    for a, u in f.items():
        for b, v in g.items():
            e = tuple(x + y for x, y in zip(a, b))
            h[e] = h.get(e, 0) + u * v
    return {e: c for e, c in h.items() if c}


def mplus(f, g, s=1):
    h = dict(f)
    for e, c in g.items():
        h[e] = h.get(e, 0) + s * c
    return {e: c for e, c in h.items() if c}


def start(modules):
    M = modules["multivariate"]
    M.Work.left = 10**7

    def p(f):
        return M.parse(text(f), NAMES)

    def back(f):
        return {tuple(k >> 32 * i & 2**32 - 1 for i in range(3)): c for k, c in f.items()}
    return M, p, back


def several_variables(modules):
    M, p, back = start(modules)
    some = several(1, 12)
    for f, g in product(some, some):
        a, b = p(f), p(g)
        if not (back(a + b) == mplus(f, g) and back(a - b) == mplus(f, g, -1) and back(a * b) == mtimes(f, g)):
            return False
        if g and (M.quotient(a * b, b) != a or b.constant() is None and M.quotient(a * b + M.ONE, b) is not None):
            return False
    for f in some:
        a, cube = p(f), mtimes(mtimes(f, f), f)
        degrees = [max((e[i] for e in f), default=-1) for i in range(3)]
        constant = sum(f.values()) if not any(any(e) for e in f) else None
        if not (back(a) == f and back(a**3) == cube and a**0 == M.ONE and back(a * 4) == mtimes(f, {(0, 0, 0): 4}) and a * 0 == {}
                and [a.degree(x) for x in NAMES.values()] == degrees and a.constant() == constant
                and a.variables() == {x for x, d in zip(NAMES.values(), degrees) if d > 0}
                and a.bits() == max((abs(c).bit_length() for c in f.values()), default=0)
                and back(a.diff(32)) == {(i, j - 1, k): j * c for (i, j, k), c in f.items() if j}
                and sum((c * M.P({i << 32: 1}) for i, c in enumerate(a.coefficients(32))), M.P()) == a
                and len(a.coefficients(64)) == degrees[2] + 1
                and (not f or back(a.lead(0)) == {(0, j, k): c for (i, j, k), c in f.items() if i == degrees[0]})
                and (not f or a.primitive() * reduce(gcd_of, f.values(), 0) == a)):
            return False
    return M.product([]) == M.ONE and back(M.product(map(p, some[3:6]))) == mtimes(mtimes(some[3], some[4]), some[5])


def gcd_of(a, b):
    a, b = abs(a), abs(b)
    while b:
        a, b = b, a % b
    return a


def exact_quotients(modules):
    """quotient, remove and ratio"""
    M, p, _ = start(modules)
    some = [x for x in map(p, several(2, 14)) if x and x.constant() is None]
    for f, g in product(some, some):
        g = g.primitive()
        for e in (1, 3):
            rest = M.remove(f * g**e, g)
            if M.quotient(rest, g) is not None or M.quotient(f * g**e, rest) is None:
                return False
        if M.quotient(f, g * f) is not None or M.quotient(f * g, g) != f or M.quotient(M.P(), g) != M.P():
            return False
    f, g = p({(1, 0, 0): 2, (0, 1, 0): 4}), p({(1, 0, 0): 3, (0, 1, 0): 6})
    return (M.ratio(f, g) == Fraction(2, 3) and M.ratio(f * -1, g) == Fraction(-2, 3) and M.ratio(M.P(), g) == 0
            and M.ratio(f, g + M.ONE) is None and M.ratio(f, f * f) is None and M.ratio(f, p({(1, 0, 0): 2, (0, 1, 0): 5})) is None
            and M.ratio(f + M.ONE, f) is None and M.quotient(f, M.ONE * 3) is None and M.quotient(f, M.ONE * 2) * 2 == f
            and M.quotient(p({(1, 0, 0): 1}), p({(1, 0, 0): 2})) is None
            and M.quotient(p({(2, 0, 0): 1, (0, 2, 0): 1}), p({(1, 0, 0): 1, (0, 1, 0): 1})) is None)


def at(f, z, A, B):
    return sum(c * z**(k & 2**32 - 1) * A**(k >> 32 & 2**32 - 1) * B**(k >> 64) for k, c in f.items())


POINTS = [(0, 1, 2), (3, -2, 5), (-1, 4, -3), (2, 7, 1)]


def eliminations(modules):
    """substitute, pseudo_remainder and resultant, by values"""
    M, p, _ = start(modules)
    some = [p(f) for f in several(3, 9)]
    z = M.P({1: 1})
    for f, l, m in product(some, some[:7], some[:7]):
        l, m = l.substitute(0, M.ONE, M.ONE * 0, 3), m.substitute(0, M.ONE, M.ONE * 0, 4)      # at z = 0
        n = max(0, f.degree(0)) + 1
        g = f.substitute(0, l, m, n)
        for x, A, B in POINTS:
            u, v = at(l, x, A, B), at(m, x, A, B)
            if u and at(g, x, A, B) != u**n * at(f, Fraction(-v, u), A, B):
                return False
    f = z * z * p({(0, 1, 0): 1}) + z * p({(0, 0, 1): 2}) + M.ONE * 3
    for g in some:
        r, row = M.pseudo_remainder(g, f, 0), f.lead(0)
        over = max(0, g.degree(0) - 1)
        if r.degree(0) >= 2 or M.quotient(r * row**3 - g * row**(over + 3), f) is None and M.quotient(r - g * row**over, f) is None:
            return False
        for x, A, B in POINTS:
            a, b, c = A, 2 * B, 3           # Res(f, u z + v) = a v^2 - b u v + c u^2
            u, v = ([at(y, 0, A, B) for y in r.coefficients(0)] + [0, 0])[1::-1]
            wanted = a * v * v - b * u * v + c * u * u if r.degree(0) > 0 else v
            if abs(at(M.resultant(f, g, 0), x, A, B)) != abs(wanted):
                return False
    return True


def determinants(modules):
    M, p, _ = start(modules)
    rng = random.Random(4)
    small = [M.P(), M.P(), M.ONE, M.ONE * -1, p({(0, 1, 0): 1}), p({(0, 0, 1): 2, (0, 0, 0): 1}), p({(1, 0, 0): 1})]
    for n in (1, 2, 3, 3, 3, 4, 4, 4):
        a = [[rng.choice(small) for _ in range(n)] for _ in range(n)]
        naive = M.P()
        for s in permutations(range(n)):
            sign = (-1)**sum(s[i] > s[j] for j in range(n) for i in range(j))
            naive = naive + M.product(a[i][s[i]] for i in range(n)) * sign
        if M.determinant(a) != naive:
            return False
    return not M.determinant([[small[4], small[5]], [small[4], small[5]]])


def limits_of_polynomials(modules):
    """What is too large or no polynomial is refused."""
    M, _, _ = start(modules)
    F = modules["certificate_format"]

    def refused(error, what):
        try:
            what()
        except error:
            return True
        return False
    texts = ("A^", "A B", "2A", "A*2", "A**2", "x", "", "-", "A +B", "A^-1", "01", "A^01", " A", "A ", "A - ", "+A", "2*3", "A^10000")
    return (all(refused(F.Malformed, lambda x=x: M.parse(x, NAMES)) for x in texts)
            and all(refused(F.Rejected, lambda x=x: M.parse(x, NAMES)) for x in ("A^9999*A", "A*B^5000*B^5000"))
            and M.parse("A^9999*B^9999", NAMES) and M.parse("A^0*B^1", NAMES) == M.parse("B", NAMES)
            and refused(F.Rejected, lambda: M.P({2**15: 1})**2**17)
            and refused(F.Rejected, lambda: reduce(lambda f, _: f * f, range(20), M.parse("A^9999", NAMES))))


def properties():
    """(name, function, True)"""
    functions = (sums_and_products, untouched, divisions, powers, shifts, inverses, squares, ranks, primes, products_of_integers,
                 polynomials, quotients, roots, bounds, fields, factors_of_degree_1, factors_of_degree_2, factors_of_small_values,
                 several_variables, exact_quotients, eliminations, determinants,
                 limits_of_polynomials)
    return [(f"arithmetic.{f.__name__}", f, True) for f in functions]
