"""Properties of multivariate.py of the Python checker: functions of its modules (sys.modules) that are True.  Polynomials
are compared with dictionaries {exponents: coefficient} and with their values."""
import random
from fractions import Fraction
from functools import reduce
from itertools import permutations, product
from math import gcd

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
                and (not f or a.primitive() * gcd(*f.values()) == a)):
            return False
    return M.product([]) == M.ONE and back(M.product(map(p, some[3:6]))) == mtimes(mtimes(some[3], some[4]), some[5])


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
    functions = (several_variables, exact_quotients, eliminations, determinants, limits_of_polynomials)
    return [(f"several_variables.{f.__name__}", f, True) for f in functions]
