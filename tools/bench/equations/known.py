"""Equations with a known group, drawn at random: nothing of what the solver does is used to make them.

Each family is a function of a random generator; it returns the text of r and the groups that may come out
(types, with the order where the construction fixes it).
"""

import math
from dataclasses import dataclass
from fractions import Fraction as Q

from . import build
from .rational import Rational, Z, add, derivative, gcd, mul, poly, power, product, scale, text
from .targets import PRIMITIVE

FAMILIES = {}


@dataclass
class Known:
    family: str
    r: str
    groups: frozenset
    minpoly: str = ""


def family(make):
    FAMILIES[make.__name__.replace("_", " ")] = make
    return make


# ----- pieces

def number(rng, most=5):
    return Q(rng.choice([i for i in range(-most, most + 1) if i]))


def fraction(rng, digits=1):
    """A rational number that is not a half integer."""
    den = rng.choice((3, 5, 7, 9, 11))
    return Q(rng.randrange(1, den), den) + rng.randrange(-10**digits, 10**digits)


def random_poly(rng, d, most=5):
    return poly(*[rng.randrange(-most, most + 1) for _ in range(d)], number(rng, most))


def points(rng, n):
    return [Q(c) for c in rng.sample(range(-n - 2, n + 3), n)]


def common_denominator(numbers):
    return math.lcm(*(x.denominator for x in numbers))


def squarefree(f):
    return len(gcd(f, derivative(f))) <= 1


def generic_map(rng, degree):
    """f in Q(z) of that degree whose critical values are none of 0, 1, infinity: the cover z -> f(z) and the
    field of solutions are disjoint, and the pull-back has the whole group."""
    while True:
        a, b = random_poly(rng, degree), random_poly(rng, rng.choice((degree, max(degree - 1, 0))))
        f = Rational(a, b)
        d = add(f.num, scale(f.den, Q(-1)))
        if max(len(f.num), len(f.den)) == degree + 1 and all(map(squarefree, (f.num, f.den, d))) and \
                all(len(g) >= degree for g in (f.num, f.den, d)):
            return f


def of_product(F, w_squared):
    """y1 y2 = sqrt F, F a rational function; the Wronskian is w."""
    phi = F.derivative() / F * Q(1, 2)
    return str(Rational(poly(w_squared)) / (F * 4) + phi.derivative() * Q(1, 2) + phi * phi * Q(1, 4))


# ----- families

@family
def primitive_pulled_back(rng):
    group = rng.choice(("A4", "S4", "A5"))
    degree = rng.randrange(1, 7)
    return str(build.pull_back(build.riemann(*PRIMITIVE[group]), generic_map(rng, degree))), {group}


@family
def primitive_shifted(rng):
    group = rng.choice(("A4", "S4", "A5"))
    deltas = list(PRIMITIVE[group])
    deltas[rng.randrange(3)] += 2 * rng.randrange(0, 40)
    return str(build.riemann(*deltas)), {group}


@family
def primitive_with_apparent_singularities(rng):
    group = rng.choice(("A4", "S4", "A5"))
    a = Rational(random_poly(rng, rng.randrange(0, 8)), poly(-number(rng, 9), 1))
    return str(build.gauge(build.riemann(*PRIMITIVE[group]), a)), {group}


@family
def one_line(rng):
    """Residues whose sum is not a half integer: a second line would be a polynomial of that degree."""
    n, digits = rng.randrange(2, 7), rng.randrange(0, 3)
    while True:
        rho = [fraction(rng, digits) for _ in range(n)]
        if (2 * sum(rho)).denominator > 1:
            break
    return build.exponential(list(zip(points(rng, n), rho))), {f"T_{common_denominator(rho)}"}


@family
def one_line_far_exponents(rng):
    """The same with exponents up to 10^20."""
    n = rng.randrange(2, 5)
    while True:
        rho = [fraction(rng, rng.choice((0, 3, 5, 8, 12, 20))) for _ in range(n)]
        if (2 * sum(rho)).denominator > 1:
            break
    return build.exponential(list(zip(points(rng, n), rho))), {f"T_{common_denominator(rho)}"}


@family
def one_line_and_irregular(rng):
    """exp(a z^k) beside the residues: Borel, for a second line would grow like z^(1-k) with a zero at each pole."""
    n, k = rng.randrange(1, 5), rng.randrange(1, 4)
    w = Rational(scale(power(Z, k), number(rng, 30)))
    for c in points(rng, n):
        w = w + Rational(poly(fraction(rng, rng.choice((0, 1, 3, 6)))), poly(-c, 1))
    return build.from_omega(w), {"Borel"}


@family
def two_lines(rng):
    """y1 y2 = v with simple zeros, the Wronskian w rational: all exponents rational, diagonal."""
    v = product([poly(-c, 1) for c in points(rng, rng.randrange(2, 6))])
    w = fraction(rng, rng.choice((0, 1, 2, 6, 12, 20)))
    return of_product(Rational(mul(v, v)), w * w), {"cyclic"}


@family
def torus(rng):
    v = product([poly(-c, 1) for c in points(rng, rng.randrange(2, 6))])
    return of_product(Rational(mul(v, v)), rng.choice((2, 3, -1, 5, 6)) * fraction(rng) ** 2), {"Gm"}


@family
def spherical_bessel(rng):
    """-1 + n(n+1)/z^2 after z -> f(z)."""
    n = rng.choice((1, 2, 5, 10, 30, 100))
    r = Rational(add(poly(n * (n + 1)), scale(mul(Z, Z), number(rng))), mul(Z, Z))
    degree = rng.randrange(1, 4)
    return str(build.pull_back(r, generic_map(rng, degree))), {"Gm"}


@family
def bessel_of_immense_order(rng):
    """-1 + n(n+1)/z^2, n up to 10^20, with and without z -> f(z)."""
    n = 10**rng.choice((3, 4, 5, 8, 12, 20)) // 4
    r = Rational(add(poly(n * (n + 1)), scale(mul(Z, Z), number(rng))), mul(Z, Z))
    f = generic_map(rng, rng.choice((1, 1, 2, 3)))
    return str(build.pull_back(r, f)), {"Gm"}


@family
def dihedral_of_three_points(rng):
    n = rng.choice((3, 4, 5, 6, 7, 30, 1009, 10**6 + 3, 10**15 + 37))
    r = build.riemann(Q(1, 2), Q(1, 2), Q(rng.choice([k for k in (1, 2, n - 1) if math.gcd(k, n) == 1]), n))
    degree = rng.randrange(1, 4)
    return str(build.pull_back(r, generic_map(rng, degree))), {f"D_{n}"}


@family
def dihedral_holomorphic(rng):
    f = random_poly(rng, rng.randrange(3, 23))
    while not squarefree(f):
        f = random_poly(rng, len(f) - 1)
    return of_product(Rational(f), fraction(rng) ** 2), {"Dinf"}


@family
def dihedral_with_poles(rng):
    """v = z sqrt(F), F(0) = 1, residues +-w at z = 0: a random divisor is no torsion, but nothing here proves it."""
    f = [Q(1)] + random_poly(rng, rng.randrange(2, 21))
    while not squarefree(f):
        f = [Q(1)] + random_poly(rng, len(f) - 2)
    return of_product(Rational(mul(mul(Z, Z), f)), fraction(rng) ** 2), {"Dinf", "D"}


@family
def dihedral_torsion_at_infinity(rng):
    """u^n = A + sqrt(A^2 - k): v = s/A'."""
    A = random_poly(rng, rng.randrange(2, 12))
    f = add(mul(A, A), poly(-number(rng)))
    while not squarefree(f):
        A = random_poly(rng, len(A) - 1)
        f = add(mul(A, A), poly(-number(rng)))
    n = rng.choice((2, 3, 4, 5, 7))
    d = derivative(A)
    return of_product(Rational(f, mul(d, d)), Q(1, n * n)), {f"D_{n}"}


@family
def dihedral_torsion_at_a_point(rng):
    """u^n = h/hbar, h = A + s, s^2 = A^2 - k (z-c)^m: v = s (z-c)/(2 A' (z-c) - m A)."""
    while True:
        A = random_poly(rng, rng.randrange(1, 9))
        m, c = rng.randrange(1, 8), number(rng, 3)
        x = poly(-c, 1)
        f = add(mul(A, A), scale(power(x, m), -number(rng)))
        if len(f) > 2 and squarefree(f) and sum(a * c**i for i, a in enumerate(A)):
            break
    n = rng.choice((2, 3, 5, 7))
    d = add(scale(mul(derivative(A), x), Q(2)), scale(A, Q(-m)))
    if not d:
        return dihedral_torsion_at_a_point(rng)
    return of_product(Rational(mul(f, mul(x, x)), mul(d, d)), Q(1, n * n)), {"D", "cyclic"}


@family
def euler(rng):
    n = rng.choice((1, 2, 3, 7, 10**8 + 7, 10**20 + 39))
    k = rng.choice((1, 2, 5, 10**20 + 1))
    delta = Q(k, n)
    shift = number(rng)
    return f"({(delta**2 - 1) / 4})/(z-({shift}))^2", {"cyclic"}


@family
def euler_torus(rng):
    c = Q(rng.choice((2, 3, -1, -7))) * Q(rng.randrange(1, 10**rng.choice((1, 12))), rng.randrange(1, 100)) ** 2
    return f"({(c - 1) / 4})/z^2", {"Gm"}


@family
def legendre(rng):
    n = rng.choice((0, 1, 3, 10, 50, 300))
    return str(build.riemann(rng.choice((0, 0, 2)), 0, 2 * n + 1)), {"T", "SL2"}


@family
def jacobi(rng):
    """z^(2/3) (1-z)^(3/5) times a polynomial of degree n, of the place at infinity any Moebius image."""
    n = rng.choice((0, 1, 5, 30, 100, 500))
    r = build.riemann(Q(1, 3), Q(1, 5), Q(1, 3) + Q(1, 5) + 1 + 2 * n)
    return str(build.pull_back(r, generic_map(rng, 1))), {"T_15"}


@family
def three_points_without_solution(rng):
    """1/a + 1/b + 1/c < 1 with differences 1/a, 1/b, 1/c: a triangle group of the hyperbolic plane."""
    a, b, c = rng.choice(((2, 3, 7), (3, 3, 4), (2, 5, 6), (7, 8, 9), (2, 4, 5)))
    return str(build.pull_back(build.riemann(Q(1, a), Q(1, b), Q(1, c)), generic_map(rng, rng.randrange(1, 5)))), {"SL2"}


@family
def airy_pulled_back(rng):
    return str(build.pull_back(Rational(scale(Z, number(rng))), generic_map(rng, rng.randrange(1, 6)))), {"SL2"}


@family
def airy_with_gauge(rng):
    a = Rational(random_poly(rng, rng.randrange(0, 8)), poly(-number(rng, 9), 1))
    return str(build.gauge(Rational(Z), a)), {"SL2"}


@family
def integral_exponents(rng):
    """exp(a z) prod (z - c)^k: the lower exponent stands at each pole, or the logarithm decides."""
    w = Rational(scale(Z, number(rng, 1000)))
    for c in points(rng, rng.randrange(1, 3)):
        w = w + Rational(poly(rng.choice((-1, 1)) * rng.randrange(1, 10**rng.randrange(1, 5))), poly(-c, 1))
    return build.from_omega(w), {"Borel", "Gm"}


@family
def many_logarithms(rng):
    """Equal double poles: an exponential solution would need a sum of exponents that is not there."""
    n = rng.choice((10, 50, 100, 200))
    return build.partial_fractions([(i, Q(2), Q(0)) for i in range(n)]), {"SL2"}


@family
def many_poles(rng):
    n = rng.choice((20, 60, 120))
    rho = [Q(rng.choice((1, 2, 4, 5, 7)), 3) for _ in range(n)]
    if (2 * sum(rho)).denominator == 1:
        rho[0] += Q(1, 3)
    if (2 * sum(rho)).denominator == 1:
        rho[0] += Q(1, 3)
    return build.exponential(list(zip(range(n), rho))), {"T_3"}


# ----- the same equation, moved

MINPOLYS = ("a^2-2", "a^2+a+1", "a^3-2", "a^3-a-1", "a^4+1", "a^4-a-1", "a^5-a-1")


def moved(rng, r):
    """The variable shifted: by nothing, by 10^-40, or by a root of a polynomial."""
    kind = rng.choice(("", "", "tiny", "root"))
    if kind == "tiny":
        return r.replace("z", "(z+1/10^40)"), ""
    if kind == "root" and len(r) < 3000:
        return r.replace("z", "(z+a)"), rng.choice(MINPOLYS)
    return r, ""


def draw(rng, names):
    name = rng.choice(names)
    r, groups = FAMILIES[name](rng)
    r, minpoly = moved(rng, r)
    return Known(name, r, frozenset(groups), minpoly)
