#!/usr/bin/env python3
"""basis_test.py PROGRAM: SymPy differentiates the solutions that the program prints and puts them into the equation.

Integrals are functions with the derivative that they must have; after two differentiations they are random numbers, z
as well, and what is left of y'' - r y (of p y'' + q y' + s y) must vanish.
"""

import random
import subprocess
import sys

import sympy
from sympy import I, Rational, diff, sqrt, symbols

z = symbols("z")


class Primitive(sympy.Function):
    """Primitive(i, z) has the derivative integrands[i]."""
    integrands = []

    def _eval_derivative(self, _):
        return self.integrands[int(self.args[0])]


def Integral(integrand, _):  # noqa: N802 (the name in what is read)
    Primitive.integrands.append(integrand)
    return Primitive(len(Primitive.integrands) - 1, z)


EQUATIONS = [  # r, group; every shape of a basis
    ("-1/(4*z^2)", "T"), ("0", "cyclic"), ("1/z^2", "Gm"), ("-3/(16*z^2)", "cyclic"),
    ("z^2+1", "Borel"), ("z^2+3", "Borel"), ("z^2+9", "Borel"), ("4*z^2+6", "Borel"), ("-z^2+I", "Borel"),
    ("1/4-1/z", "Borel"), ("1-2/z", "Borel"), ("1+4/z", "Borel"), ("z^4+2*z", "Borel"),
    ("(4*z^6-8*z^5+12*z^4+4*z^3+7*z^2-20*z+4)/(4*z^4)", "Borel"), ("2*(z^2+1)+4*(z+1)", "SL2"),
    ("1/(4*z)-3/(16*z^2)", "Dinf"), ("2/z-3/(16*z^2)", "Dinf"), ("1/z+5/(16*z^2)", "Dinf"), ("-1/z+45/(16*z^2)", "Dinf"),
    ("-3/(16*z^2)-2/(9*(z-1)^2)+3/(16*z*(z-1))", "A4"),
    # logarithms: Legendre, one line of third order
    ("((z^2-1)*2-1)/(z^2-1)^2", "T"), ("((z^2-1)*6-1)/(z^2-1)^2", "T"),
]


def riemann(a, b, c):
    """Exponent differences at 0, 1, infinity."""
    return f"(({a})^2-1)/(4*z^2)+(({b})^2-1)/(4*(z-1)^2)+(1-({a})^2-({b})^2+({c})^2)/(4*z*(z-1))"


EQUATIONS += [(riemann("1/2", "1/2", c), "D") for c in ("1/2", "1/3", "2/3", "1/4", "3/5", "7/5")]
EQUATIONS += [(riemann("1/2", "3/2", c), "D") for c in ("1/2", "1/3", "4/3")]
EQUATIONS += [(riemann("1/3", "1/5", "8/15+1"), "T"), (riemann("1/3", "1/5", "8/15+5"), "T"),
              (riemann("0", "0", "3"), "T"), (riemann("1/2", "1/2", "sqrt(2)"), "Dinf")]
# y1 y2 = v, the Wronskian w: over Q(w), and over Q(sqrt 2) outside it
EQUATIONS += [(f"(({w})-(2*z)^2+4*(z^2+3))/(4*(z^2+3)^2)", "Gm") for w in ("5", "-7")]
# (y1 y2)^2 = F on curves of genus 0, 1 and 2, finite (a torsion function) and infinite


def of_square(f, w_squared=1):
    """(y1 y2)^2 = f, Wronskian w."""
    phi = diff(f, z) / (2 * f)
    return str(sympy.together(w_squared / (4 * f) + diff(phi, z) / 2 + phi**2 / 4)).replace("**", "^")


EQUATIONS += [(of_square(z**3 + 1), "Dinf"), (of_square((z**5 + 2) * z**2, 3), "Dinf"), (of_square((z**3 + 1) * (z - 2)**2, 9), "D"),
              (of_square(z**2 - 2, 5), "Dinf"), (of_square((z - 1) / (3 * z - 1)**2), "Dinf")]
GIVEN = ["z^2*y''+z*y'+(z^2-1/4)*y=0", "y''-2*z*y'+4*y=0", "z*y''+y'=0", "(1-z^2)*y''-2*z*y'+6*y=0",
         "z*y''+(1-z)*y'+2*y=0", "z^2*y''+3*z*y'+y=0", "2*z*(1-z)*y''+(1-2*z)*y'+y/9=0"]


def printed(program, *arguments):
    """The solutions of a script for SymPy, with our integrals in place of its own."""
    ran = subprocess.run([program, "solve", *arguments, "--format", "sympy"], capture_output=True, text=True, timeout=100)
    assert ran.returncode == 0, (arguments, ran.stderr)
    lines = [line for line in ran.stdout.splitlines() if not line.startswith(("from sympy", "print", "equation", "P1"))]
    names = {**vars(sympy), "Integral": Integral, "factor": 1}
    exec("\n".join(lines), names)  # noqa: S102 (our own output)
    return [names["factor"] * names[y] for y in ("y1", "y2") if y in names]


def vanishes(expression, rng):
    """At two random complex points; integrals and their arguments are unknown numbers."""
    unknown = {x: sympy.Float(rng.random(), 40) for x in expression.atoms(Primitive)}
    expression = expression.xreplace(unknown)
    for _ in range(2):
        point = Rational(rng.randrange(11, 40), 41) + I * Rational(rng.randrange(1, 40), 43)
        terms = [sympy.N(t.subs(z, point), 40) for t in sympy.Add.make_args(expression)]
        if abs(sum(terms)) > 1e-25 * (1 + max(map(abs, terms))):
            return False
    return True


def formula(text):
    return sympy.sympify(text.replace("^", "**"), {"z": z, "I": I, "sqrt": sqrt})


def left_side(text):
    """y -> p y'' + q y' + s y"""
    operator = formula(text.split("=")[0].replace("y''", "Y2").replace("y'", "Y1").replace("y", "Y0"))
    return lambda y: sympy.expand(operator.subs({"Y2": diff(y, z, 2), "Y1": diff(y, z), "Y0": y}))


def complaints(found, operator, expected, rng):
    if len(found) != expected:
        yield f"{len(found)} solutions instead of {expected}"
    for y in found:
        if not vanishes(operator(y), rng):
            yield f"not solved by {y}"
    if len(found) == 2 and vanishes(found[0] * diff(found[1], z) - diff(found[0], z) * found[1], rng):
        yield f"not independent: {found}"


def main():
    program, rng = sys.argv[1], random.Random(19)
    asked = [("-r", f"({r})", lambda y, r=r: diff(y, z, 2) - formula(r) * y, 0 if group in ("A4", "SL2") else 2) for r, group in EQUATIONS]
    asked += [("-e", text, left_side(text), 2) for text in GIVEN]
    failures = 0
    for option, text, operator, expected in asked:
        for complaint in complaints(printed(program, option, text), operator, expected, rng):
            failures += 1
            print(f"{text}: {complaint}")
    print(f"{len(asked)} equations, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
