"""SymPy expressions in and out."""

import unittest
from fractions import Fraction

import kovacic
from kovacic import Truth

try:
    import sympy
    from sympy import Derivative, Eq, Function, I, Rational, Symbol, exp, sqrt, symbols
except ImportError:
    raise unittest.SkipTest("python3-sympy is not installed")

x, z, a, b = symbols("x z a b")
y = Function("y")


class In(unittest.TestCase):
    def test_rational_functions(self):
        for f in (z**2 + 3, (16*z - 3)/(16*z**2), Rational(2, 3)/z**2, I*z, sqrt(2)*z**2 - z**-3, (z - 1)**-2/7):
            again = kovacic.solve(f).r
            difference = sympy.simplify(kovacic.to_sympy(again, [z]) - f)
            self.assertEqual(difference, 0, f)

    def test_equations(self):
        bessel = Eq(x**2*y(x).diff(x, 2) + x*y(x).diff(x) + (x**2 - Rational(1, 4))*y(x), 0)
        answer = kovacic.solve(bessel)
        self.assertEqual(answer.variable, "x")
        self.assertEqual(answer.r, -1)
        self.assertEqual(kovacic.solve(bessel.lhs).r, -1)
        for solution in answer.liouvillian:
            u = kovacic.to_sympy(solution, [x]) * kovacic.to_sympy(answer.factor, [x])
            self.assertEqual(sympy.simplify(bessel.lhs.subs(y(x), u).doit()), 0)

    def test_solutions_solve(self):
        for r in (z**2 + 3, 2/z**2, z**4 + 2*z, Rational(-3, 16)/z**2, 1 + 2/z**2):
            answer = kovacic.solve(r)
            self.assertTrue(answer.liouvillian, r)
            for solution in answer.liouvillian:
                if solution.y is not None:
                    u = solution.sympy([z])
                    self.assertEqual(sympy.simplify((u.diff(z, 2) - r*u)/u), 0, r)

    def test_parameters_are_the_other_symbols(self):
        answer = kovacic.solve(a/z, variable=z)
        self.assertEqual({s.where for s in answer.strata}, {"a = 0", "a != 0"})
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.solve(a/z)

    def test_assumptions_of_symbols(self):
        c = Symbol("c", positive=True)
        answer = kovacic.solve(c/z, variable=z)
        self.assertIn("c > 0", answer.assumed)
        self.assertIs(answer.abelian, Truth.no)
        n = Symbol("n", integer=True)
        self.assertIn("n is an integer", kovacic.solve(z**2 + n, variable=z).assumed)
        different = kovacic.solve((a - b)/z, variable=z, assume=sympy.Ne(a - b, 0)).assumed
        self.assertIn(different, (["a != b"], ["b != a"]))

    def test_set(self):
        self.assertEqual(kovacic.solve(a*z, variable=z, set={a: Rational(1, 3)}).r, kovacic.RationalFunction("z/3"))

    def test_refused(self):
        for f in (0.5*z, sympy.Float("1e-30")*z, sympy.oo, sympy.nan, sympy.zoo, sympy.E*z, sympy.pi*z, sympy.true, z + sympy.GoldenRatio,
                  Eq(z, z)):
            with self.assertRaises(kovacic.Error, msg=str(f)):
                kovacic.solve(f)
        for f in (Symbol("z+1"), Symbol("z") + Symbol("z", positive=True), sympy.Dummy("z"), Symbol("I")*z,
                  Symbol("α"), Symbol("z\n")):
            with self.assertRaises(kovacic.InvalidArgument, msg=str(f)):
                kovacic.solve(f)
        for f in (z**a, sympy.gamma(z), sympy.Matrix([z]), z > 0):
            with self.assertRaises(kovacic.Error, msg=str(f)):
                kovacic.solve(f, variable="z")

    def test_after_a_change_of_variable(self):
        for f in (exp(z), sympy.sin(z), z**Rational(1, 2)):
            self.assertEqual(kovacic.solve(f, variable="z").abelian, Truth.no)

    def test_common_parts_written_out(self):
        f = z
        for _ in range(200):
            f = sympy.Add(sympy.Mul(f, f, evaluate=False), 1, evaluate=False)
        with self.assertRaises(kovacic.OutOfBudget):
            kovacic.solve(f)

    def test_huge(self):
        n = sympy.Integer(10)**5000 + 1
        self.assertEqual(kovacic.solve(n/z**2).r.num, [int(n)])


class Out(unittest.TestCase):
    def test_numbers(self):
        self.assertEqual(kovacic.to_sympy(Fraction(2, 3)), Rational(2, 3))
        self.assertEqual(kovacic.to_sympy(kovacic.RationalFunction("z^2/2"), [z]), z**2/2)

    def test_algebraic_numbers(self):
        third = sympy.real_root(2, 3)
        for c in (sqrt(2), I, sqrt(2) + sqrt(3), 1 + sqrt(-3)/2, third, sympy.CRootOf(x**5 - x - 1, 0)/3):
            r = kovacic.solve(c/z**2 + 1).r
            self.assertEqual(sympy.minimal_polynomial(r.num[0].sympy(), x), sympy.minimal_polynomial(c, x), c)
            self.assertLess(abs(complex(r.sympy([z]).subs(z, 2)) - complex(c/4 + 1)), 1e-12, c)
            self.assertLess(abs(complex(r.num[0]) - complex(c)), 1e-12, c)

    def test_letters_are_not_names(self):
        r = kovacic.solve((sqrt(2) + sqrt(3))/z**2).r
        self.assertIsNotNone(r.generator)
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.solve(r)
        self.assertEqual(kovacic.solve(kovacic.solve(sqrt(2)/z**2).r).r.num[0].minpoly, [-2, 0, 1])

    def test_names_that_sympy_knows(self):
        f = kovacic.RationalFunction("S^2 + 1", "S")
        self.assertEqual(f.sympy(), Symbol("S")**2 + 1)

    def test_symbols_keep_their_assumptions(self):
        t = Symbol("t", positive=True)
        self.assertEqual(kovacic.RationalFunction("t^2", "t").sympy([t]), t**2)

    def test_integrals(self):
        found = kovacic.integrals(kovacic.hamiltonian(
            (symbols("p1")**2 + symbols("p2")**2)/2, ["q1", "q2"], ["p1", "p2"]), 1)
        values = found.elsewhere.values if found.elsewhere is not None else found.sets[0].values
        self.assertTrue(all(isinstance(v.sympy(), sympy.Expr) for v in values))


class Hamiltonian(unittest.TestCase):
    def test_henon_heiles(self):
        q1, q2, p1, p2, h = symbols("q1 q2 p1 p2 h")
        text = kovacic.hamiltonian((p1**2 + p2**2)/2 + q1**2*q2 + q2**3/2, [q1, q2], [p1, p2], parameters=[h],
                                   manifolds={"name": "N", "equations": [q1, p1], "level": "H = h"})
        report = kovacic.check(text, set={h: 1})
        self.assertIs(report.verdict, kovacic.VerdictKind.non_integrable)

    def test_assumptions(self):
        m = Symbol("m", positive=True, integer=True)
        text = kovacic.hamiltonian(symbols("p")**2/(2*m), "q", "p", title='a "particle" \\ line\nbreak')
        self.assertIn('m = "integer"', text)
        self.assertIn("m > 0", kovacic.check(text).assumptions)

    def test_wrong(self):
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.hamiltonian("p^2", "q", "p", manifolds={"levels": "H = 1"})
        with self.assertRaises(kovacic.WrongType):
            kovacic.hamiltonian(0.5, "q", "p")


if __name__ == "__main__":
    unittest.main()
