"""Families for the comparison: increasing sizes of one kind of equation, each with its group."""

import random
from dataclasses import dataclass
from fractions import Fraction as Q

from . import build
from .rational import Quadratic, Rational, Z, poly, power, product
from .targets import PRIMITIVE, TEXTBOOK, generic, integer, jacobi, pulled_back, radical_over, solvable


@dataclass
class Equation:
    family: str
    size: object
    r: str
    group: str

    @property
    def solvable(self):
        return self.group != "SL2"


def irregular(k):
    """omega = z^k + 1/z^k + 1/(3(z-1)): an irregular pole and an irregular infinity."""
    return build.from_omega(Rational(power(Z, k)) + Rational(poly(1), power(Z, k)) + Rational(poly(1), poly(-3, 3)))


def high(digits):
    """Two poles and two residues of that many digits."""
    rng = random.Random(digits)
    number = integer(digits)
    rho = [number(rng) / 7 + Q(1, 21) for _ in range(2)]
    rho[1] = Q(1, 3) - rho[0]
    return build.exponential([(number(rng), rho[0]), (number(rng) + Q(1, 2), rho[1])])


def over_field(n, d):
    return build.exponential([(Quadratic(k, 1, d), Q(1, 3) if k % 2 else Q(2, 7)) for k in range(1, n + 1)])


def dihedral(n):
    return build.from_square(product([poly(-i, 1) for i in range(1, n + 1)]), Q(2))


def families():
    """Sizes grow inside a family; a system that needs too long at one size is not asked for larger ones."""
    for i, (r, group) in enumerate(TEXTBOOK):
        yield Equation("textbook", i + 1, r, group)
    for n in (2, 3, 4, 5, 6, 8, 16, 32, 64):
        yield Equation("no solution, equal exponents", n, build.no_solution(n), "SL2")
    for n in (2, 3, 4, 6, 8, 16, 32, 64):
        yield Equation("no solution, generic", n, generic(n, integer(1)), "SL2")
    for n in (2, 3, 4, 5, 6, 8, 16, 32, 64):
        yield Equation("reducible, rational poles", n, solvable(n), "T_7")
    for n in (3, 4, 5, 6, 8, 12, 24, 48):
        yield Equation("infinite dihedral", n, dihedral(n), "Dinf")
    for n in (2, 3, 4, 5, 7, 9, 30):
        yield Equation("finite dihedral", n, str(build.riemann(Q(1, 2), Q(1, 2), Q(1, n))), f"D_{n}")
    for group in ("A4", "S4", "A5"):
        yield Equation(f"{group} pulled back", 1, str(build.riemann(*PRIMITIVE[group])), group)
        for degree in (2, 3, 4, 6):
            yield Equation(f"{group} pulled back", degree, pulled_back(group, degree), group)
    for k in (1, 2, 3, 4, 6, 8, 12):
        yield Equation("irregular", k, irregular(k), "Borel")
    for n in (1, 10, 30, 100, 300, 1000):
        yield Equation("digits of poles and exponents", n, high(n), None)
    for n in (2, 3, 4, 5, 6, 8, 12, 16):
        yield Equation("algebraic poles", n, radical_over(build.selmer(n)), "T_3")
    for n in (2, 3, 4, 6, 8):
        yield Equation("coefficients in Q(sqrt 2)", n, over_field(n, 2), "T_21")
    for n in (2, 3, 4, 6, 8):
        yield Equation("coefficients in Q(I)", n, over_field(n, -1), "T_21")
    for n in (4, 16, 64, 256, 1024):
        yield Equation("Hermite", n, f"z^2-{2 * n + 1}", "Borel")
        yield Equation("Legendre", n, str(build.riemann(0, 0, 2 * n + 1)), "T_2")
        yield Equation("Jacobi", n, jacobi(n), "T_15")


TRAPS = [  # name, r, group, what other systems are known to do
    ("coefficients of P", "z^2-5", "Borel", "a wrong polynomial factor for deg P >= 2"),
    ("Weber", "z^2+1", "Borel", "an empty answer"),
    ("order 4", "1/z^4", "Gm", "an empty answer"),
    ("S4", str(build.riemann(*PRIMITIVE["S4"])), "S4", "a minimal polynomial cut off at degree 4"),
    ("A5", str(build.riemann(*PRIMITIVE["A5"])), "A5", "a minimal polynomial cut off at degree 4"),
    ("poles that do not split", radical_over(poly(-2, 0, 0, 1)), "T_3", "poles dropped"),
    ("poles that do not split, quintic", radical_over(build.selmer(5)), "T_3", "poles dropped"),
    ("constants that do not split", "1/z^2", "Gm", "constants dropped"),
    ("dihedral, v^2 of degree 2", str(build.riemann(Q(1, 2), Q(1, 2), Q(1, 5))), "D_5",
     "a false antiderivative of a square root"),
    ("dihedral, v^2 of degree 3", dihedral(3), "Dinf", "a false antiderivative of a square root"),
]
