"""The sizes to reach: name, text of r, the group that must come out, the limit in seconds.

Groups are written as the program prints them, type and order; None leaves the order open.
"""

import random
from dataclasses import dataclass
from fractions import Fraction as Q

from . import build
from .rational import Quadratic, Rational, Z, add, derivative, mul, poly, power, product, scale, text


@dataclass
class Target:
    family: str
    size: int
    r: str
    group: str
    seconds: float


def integer(n):
    """A random integer of n digits."""
    return lambda rng: Q(rng.randrange(10**(n - 1), 10**n) * rng.choice((1, -1)))


def fraction(n):
    """A random quotient of integers of n digits."""
    return lambda rng: integer(n)(rng) / abs(integer(n)(rng))


def generic(n, number, seed=1):
    """n regular poles at 1, ..., n with random coefficients: group SL2."""
    rng = random.Random(seed)
    return build.partial_fractions([(i, number(rng), number(rng)) for i in range(1, n + 1)])


def solvable(n, denominator=7, poles=None):
    """omega = sum rho_i/(z - c_i), one exponential solution, all residues in Z/denominator."""
    rng = random.Random(n)
    poles = poles or range(1, n + 1)
    rho = [Q(denominator * rng.randrange(-1, 2) + 1 + rng.randrange(denominator - 1), denominator) for _ in poles]
    return build.exponential(list(zip(poles, rho)))


def over_quadratic_field(n, d):
    """Poles k + sqrt d and residues in Q(sqrt d), one of them irrational: Borel."""
    return build.exponential([(Quadratic(k, 1, d), Quadratic(Q(1, 3), k % 2, d)) for k in range(1, n + 1)])


def jacobi(n):
    """z^(2/3) (1-z)^(3/5) times a polynomial of degree n."""
    return str(build.riemann(Q(1, 3), Q(1, 5), Q(1, 3) + Q(1, 5) + 1 + 2 * n))


PRIMITIVE = {"A4": (Q(1, 2), Q(1, 3), Q(1, 3)), "S4": (Q(1, 2), Q(1, 3), Q(1, 4)),
             "A5": (Q(1, 2), Q(1, 3), Q(1, 5))}


def pulled_back(group, degree, seed=5):
    rng = random.Random(seed)
    f = Rational(*[poly(*[rng.randrange(-5, 6) for _ in range(degree)], 1) for _ in range(2)])
    return str(build.pull_back(build.riemann(*PRIMITIVE[group]), f))


def shifted(group, by):
    """One exponent difference larger by an even integer: the same group, a polynomial part of that size."""
    a, b, c = PRIMITIVE[group]
    return str(build.riemann(a + by, b, c))


def with_apparent_singularities(group, count):
    """A gauge transform with `count` further singular points at which no solution is singular or branched."""
    r = build.riemann(*PRIMITIVE[group])
    k = (count - 4) // 2  # the numerator of r + a' - a^2, a = z^k + 1, has degree 2k + 4
    return str(build.gauge(r, Rational(add(power(Z, k), poly(1)))))


def gaussian_a4():
    i = Quadratic(0, 1, -1)
    one = Quadratic(1, 0, -1)
    f = Rational([i, one * 2, one], [one * 0 - 3, i + 1])
    return str(build.pull_back(build.riemann(*PRIMITIVE["A4"]), f))


def exponential_over(q):
    """omega = u/q, u generic of small degree, q irreducible: conjugate residues that are not rational."""
    return build.from_omega(Rational(poly(1, 2, 0, 3), q))


def radical_over(q):
    return build.from_omega(Rational(derivative(q), scale(q, Q(3))))


def no_logarithm(n):
    """-2/9 (q'/q)^2 + 1/q with q irreducible of degree n: exponent differences 1/3, no solution."""
    q = build.selmer(n)
    num = add(scale(power(derivative(q), 2), Q(-2, 9)), q)
    return f"({text(num)})/({text(q)})^2"


def targets():
    for n in (25, 50, 100):
        yield Target("no solution, 100-digit integers", n, generic(n, integer(100)), "SL2", 0.1)
    for n in (250, 500, 1000):
        yield Target("no solution", n, generic(n, integer(3)), "SL2", 3)
    for n in (25, 50, 100):
        yield Target("no solution, equal exponents", n, build.no_solution(n), "SL2", 0.1)
    # r has 200 different denominators of 100 digits: 8 MB of text as one quotient
    yield Target("no solution, 100-digit fractions", 100, generic(100, fraction(100)), "SL2", 1)
    for n in (16, 32, 64):
        yield Target("reducible", n, solvable(n), "T_7", 0.2)
    yield Target("irreducible denominator, no solution", 24, no_logarithm(24), "SL2", 0.2)
    yield Target("irreducible denominator, radical", 24, radical_over(build.selmer(24)), "T_3", 0.2)
    yield Target("Legendre", 10000, str(build.riemann(0, 0, 20001)), "T_2", 30)
    for n in (30, 60, 120):
        f = product([poly(-i, 1) for i in range(1, n + 1)])
        yield Target("infinite dihedral", n, build.from_square(f, Q(2)), "Dinf", 5)
    yield Target("D_3, polynomial part", 320, str(build.riemann(Q(321, 2), Q(321, 2), Q(1, 3))), "D_3", 5)
    for n in (625, 1250, 2500):
        yield Target("Legendre", n, str(build.riemann(0, 0, 2 * n + 1)), "T_2", 5)
        yield Target("Hermite", n, f"z^2-{2 * n + 1}", "Borel", 5)
        yield Target("Jacobi", n, jacobi(n), "T_15", 5)
    for group, pulled, gauged in (("A4", 1, 0.5), ("S4", 3, 2), ("A5", 5, 5)):
        yield Target(f"{group} pulled back", 6, pulled_back(group, 6), group, pulled)
        yield Target(f"{group} shifted", 20, shifted(group, 20), group, gauged)
        yield Target(f"{group} apparent", 20, with_apparent_singularities(group, 20), group, gauged)
    rng = random.Random(3)
    poles = [fraction(2000)(rng) for _ in range(3)]
    yield Target("2000-digit coefficients, reducible", 3, solvable(3, poles=poles), "T_7", 5)
    yield Target("2000-digit coefficients, no solution", 3, generic(3, fraction(2000)), "SL2", 5)
    yield Target("irreducible denominator, exponential", 16, exponential_over(build.selmer(16)), "Borel", 5)
    yield Target("irreducible denominator, radical", 16, radical_over(build.selmer(16)), "T_3", 5)
    yield Target("irreducible denominator, dihedral", 48, build.from_square(build.selmer(48), Q(2)), "Dinf", 5)
    yield Target("over Q(I)", 24, over_quadratic_field(24, -1), "Borel", 5)
    yield Target("over Q(sqrt 2)", 24, over_quadratic_field(24, 2), "Borel", 5)
    yield Target("A4 over Q(I)", 2, gaussian_a4(), "A4", 0.5)


TEXTBOOK = [  # Airy, Bessel, Weber, Whittaker, Kovacic's examples, hypergeometric, Lame
    ("z", "SL2"), ("1", "Gm"), ("-1+2/z^2", "Gm"), ("-1+3/(4*z^2)", "SL2"), ("z^2+1", "Borel"),
    ("z^2+2", "SL2"), ("1/z", "SL2"), ("1/z^4", "Gm"), ("1/(4*z)-3/(16*z^2)", "Dinf"),
    ("1/4-1/z", "Borel"), ("1/4-1/(3*z)-5/(36*z^2)", "SL2"),
    ("(4*z^6-8*z^5+12*z^4+4*z^3+7*z^2-20*z+4)/(4*z^4)", "Borel"),
    ("-3/(16*z^2)", "cyclic_4"), ("z^4+2*z", "Borel"), ("1/z^2", "Gm"),
    (str(build.riemann(Q(1, 2), Q(1, 2), Q(1, 5))), "D_5"),
    (str(build.riemann(Q(1, 2), Q(1, 3), Q(1, 7))), "SL2"),
    (str(build.riemann(0, 0, 0)), "SL2"), (str(build.riemann(0, 0, 13)), "T_2"),
    (str(build.riemann(*PRIMITIVE["A4"])), "A4"), (str(build.riemann(*PRIMITIVE["S4"])), "S4"),
    (str(build.riemann(*PRIMITIVE["A5"])), "A5"),
]
