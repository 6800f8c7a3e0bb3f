#!/usr/bin/env python3
"""Solutions that are printed for a stratum solve the given equation at its points, in numbers: generic points, special ones
(0, equal values), complex ones.  The numbers are mpmath's, the formulas SymPy's; nothing of the solver is used.

usage: parameter_solutions_test.py PROGRAM
"""

import importlib.util
import itertools
import json
import random
import re
import subprocess
import sys
import unittest

PROGRAM = sys.argv[1]
# p and q of y'' + p y' + q y = 0 in x, and the parameters
EQUATIONS = [("0", "-a**2", "a"), ("0", "-a", "a"), ("0", "a*b", "a b"), ("2*a", "b", "a b"), ("0", "-a/x**2", "a"), ("a/x", "b/x**2", "a b"),
             ("x**2*(a*x**2+(a*c+b)*x+b*c)", "-x**2*(a*x+b)", "a b c"), ("0", "-(a**2*x**2+a)", "a"), ("0", "-(x**2*a**2+3*a)", "a"),
             ("a", "0", "a"), ("a*x", "a", "a"), ("0", "-(a**2*x**6+3*a*x**2)", "a"), ("-2*a/x", "a*(a+1)/x**2+b**2", "a b"),
             ("0", "-(a+2/x**2)", "a"), ("0", "-(a**2/4+2/x**2+b/x)", "a b"), ("(a+b)", "a*b", "a b"), ("2*x/(x**2+a)", "0", "a"),
             ("0", "-(a/x**4)", "a"), ("1/(x+a)", "-b/(x+a)**2", "a b"), ("0", "-(a*x**2+1)", "a"), ("-1/x", "a*x**2", "a"),
             ("x/(x**2-1)", "-n**2/(x**2-1)", "n"), ("2/x", "k**2", "k"), ("0", "-3*a/(16*x**2)", "a"), ("a*b", "0", "a b"),
             ("0", "-(a**2-b**3)**2", "a b"), ("0", "-((a*b-1)**2-1/4)/x**2", "a b"), ("2*a/x**2", "0", "a"), ("0", "-(a-1)**2", "a"), ("0", "-(a**2-b**2)", "a b"), ("4*x/(x**2+1)", "-a/(x**2+1)", "a")]
HAVE = all(importlib.util.find_spec(m) for m in ("sympy", "mpmath"))


def answer(p, q, parameters):
    ode = f"y'' + ({p})*y' + ({q})*y = 0"
    flags = [word for name in parameters.split() for word in ("--parameter", name)]
    done = subprocess.run([PROGRAM, "solve", "-e", ode, "--variable", "x", "--format", "json", *flags], capture_output=True, text=True,
                          timeout=250)
    return json.loads(done.stdout)


@unittest.skipUnless(HAVE, "needs SymPy and mpmath")
class Solutions(unittest.TestCase):
    def formula(self, text):
        import sympy
        names = {n: sympy.Symbol(n) for n in re.findall(r"[A-Za-z_]\w*", text)}
        names.update({n: getattr(sympy, n) for n in ("sqrt", "exp", "log", "cos", "sin", "cosh", "sinh", "erf", "erfi", "Ei", "atan", "atanh", "asin", "asinh", "acosh", "I", "pi") if n in names})
        names["Int_"] = sympy.Function("Int_")
        return sympy.sympify(re.sub(r"\bint\(", "Int_(", text.replace("^", "**")), locals=names)

    def value(self, e, point):
        """y as a function of x, with integrals from a point that is not a pole."""
        import mpmath
        import sympy
        x = sympy.Symbol("x")
        e = e.subs(point)
        base = mpmath.mpc("0.8", "0.35")
        integrals = [i for i in e.atoms(sympy.Function) if i.func.__name__ == "Int_"]
        parts = {i: sympy.lambdify(x, i.args[0], "mpmath") for i in integrals}
        names = {i: sympy.Symbol(f"i{k}") for k, i in enumerate(integrals)}
        f = sympy.lambdify([x, *names.values()], e.subs(names), "mpmath")
        return lambda z: mpmath.mpmathify(f(z, *(mpmath.quad(parts[i], [base, z]) for i in integrals)))

    def holds(self, condition, point):
        """None: a condition of another kind (an integer, ...)."""
        import sympy
        found = re.fullmatch(r"([^=<>!]+?) (=|!=|>|<|>=|<=) ([^=<>!]+)", condition)
        if not found or " is " in condition:
            return None
        difference = sympy.simplify((self.formula(found[1]) - self.formula(found[3])).subs(point))
        if found[2] in ("=", "!="):
            return (difference == 0) == (found[2] == "=")
        return bool(difference.is_real and eval(f"{float(difference)} {found[2]} 0"))  # pylint: disable=eval-used

    def points(self, names, conditions):
        import sympy
        values = [0, 1, -1, 2, sympy.Rational(1, 3), sympy.Rational(-5, 2), sympy.I, 2 - sympy.I]
        all_points = [dict(zip(names, p)) for p in itertools.product(values, repeat=len(names))]
        random.Random(7).shuffle(all_points)
        all_points.sort(key=lambda p: len(set(p.values())) > 1)  # equal values first: there a basis may collapse
        chosen = []
        for point in all_points:
            truth = [self.holds(c, point) for c in conditions]
            if all(t is True for t in truth):
                chosen.append(point)
            if len(chosen) == 10:
                break
        return chosen

    def test_solutions_solve_at_points(self):
        import mpmath
        import sympy
        mpmath.mp.dps = 30
        checked = 0
        for p, q, parameters in EQUATIONS:
            coefficients = [sympy.sympify(t) for t in (p, q)]
            for stratum in answer(p, q, parameters)["strata"]:
                for solutions in stratum.get("solutions", []):
                    conditions = [c for c in stratum["conditions"] if " is " not in c] + solutions["where"]
                    for point in self.points([sympy.Symbol(n) for n in parameters.split()], conditions):
                        with self.subTest(p=p, q=q, y=solutions["y"], point=point):
                            a, b = (sympy.lambdify(sympy.Symbol("x"), c.subs(point), "mpmath") for c in coefficients)
                            functions = [self.value(self.formula(y), point) for y in solutions["y"]]
                            at = mpmath.mpc("1.1", "0.4")
                            jets = [[mpmath.diff(y, at, k) for k in range(3)] for y in functions]
                            for y0, y1, y2 in jets:
                                size = abs(y0) + abs(y1) + abs(y2)
                                self.assertLess(abs(y2 + a(at) * y1 + b(at) * y0), 1e-8 * size)
                            if len(jets) == 2:
                                w = jets[0][0] * jets[1][1] - jets[0][1] * jets[1][0]
                                self.assertGreater(abs(w), 1e-8 * abs(jets[0][0]) * abs(jets[1][0]))
                            checked += 1
        self.assertGreater(checked, 100)

    def test_what_a_person_expects(self):
        for p, q, parameters, expected in [("0", "-a**2", "a", {"a = 0": ["1", "x"], "a != 0": ["exp(x*a)", "exp(-x*a)"]}),
                                           ("0", "-a/x**2", "a", {"a = -1/4": None})]:
            strata = answer(p, q, parameters)["strata"]
            for stratum in strata:
                self.assertTrue(stratum["solutions"], stratum)
                wanted = expected.get(", ".join(stratum["conditions"]))
                if wanted:
                    self.assertEqual([self.formula(y) for y in stratum["solutions"][0]["y"]], [self.formula(y) for y in wanted])
        lines = [[solutions["y"][0] for solutions in stratum["solutions"]] for stratum in answer(*EQUATIONS[6])["strata"]]
        for y in (y for line in lines for y in line if y != "1"):  # a = b = 0: 1, x
            self.assertEqual(self.formula(y), self.formula("x + c"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
