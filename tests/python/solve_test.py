"""One equation: groups, evidence, values, limits, and what an answer must never become."""

import copy
import math
import unittest
from fractions import Fraction

import kovacic
from kovacic import ByEngines, Connected, GroupType, RationalFunction, Truth


class Solve(unittest.TestCase):
    def test_groups(self):
        for r, group, abelian in (("z^2 + 3", "Borel", Truth.no), ("z", "SL2", Truth.no), ("0", "cyclic_1", Truth.yes),
                                  ("(16*z - 3)/(16*z^2)", "Dinf", Truth.yes), ("2/z^2", "cyclic_1", Truth.yes)):
            answer = kovacic.solve(r)
            self.assertEqual(repr(answer.group), f"GaloisGroup('{group}')", r)
            self.assertIs(answer.abelian, abelian, r)

    def test_names_of_the_library(self):
        answer = kovacic.solve("z^2 + 3")
        self.assertIs(answer.group.type, GroupType.Borel)
        self.assertIs(answer.component, Connected.borel)
        self.assertEqual(answer.kovacic_case, 1)
        self.assertEqual(answer.liouvillian[0].omega, RationalFunction("(z^2 + 1)/z"))
        self.assertIsNone(answer.undecided)
        self.assertIn("identity component Borel, not abelian", str(answer))

    def test_hasty_equations_are_asked_back(self):   # the table of them: tests/equation/hasty.txt
        for ode in ("xy'' = 1", "y'' = yx", "y'' = sin2x*y", "y'' = pi*y", "y'' = w^2*y", "x'' = y*x"):
            for ask in (kovacic.solve, kovacic.monodromy):
                with self.assertRaises(kovacic.InputError, msg=ode):
                    ask(ode)
        for r in ("ax^2 - E", "w^2 - E", "x + t - E"):
            with self.assertRaises(kovacic.InputError, msg=r):
                kovacic.spectrum(r)
        for ode, meant in (("xy'' = y", "x*y'' = y"), ("(xy')' + x*y = 0", "(x*y')' + x*y = 0"), ("2*x*y'' + xy' = 0", "2*x*y'' + x*y' = 0")):
            try:
                self.assertEqual(kovacic.solve(ode).r, kovacic.solve(meant).r, ode)
            except kovacic.InputError as asked:
                self.assertIn("is read as one name", str(asked))
        self.assertEqual(str(kovacic.solve("xy'' = y").r), "1/x")
        answer = kovacic.solve("xy'' = z*xy", unknown="xy")
        self.assertEqual((answer.unknown, answer.variable, str(answer.r)), ("xy", "z", "z"))
        self.assertIn("the unknown is u, the variable is t", str(kovacic.solve("u'' = t*u")))

    def test_another_equation_where_the_variable_is_none(self):   # t = exp(a*x), and a = 0
        answer = kovacic.solve("y'' + exp(a*x)*y = 0", parameters="a", variable="x")
        self.assertIs(answer.abelian, Truth.unknown)
        self.assertTrue(answer.decided)
        [(where, there)] = answer.elsewhere
        self.assertEqual((where, there.abelian), ("a = 0", Truth.yes))
        self.assertIs(kovacic.solve("y'' + exp(a*x)*y = 0", parameters="a", variable="x", assume="a > 0").abelian, Truth.no)

    def test_spectrum(self):
        weber = kovacic.spectrum("x^2 - E")
        self.assertTrue(weber.decided)
        series = next(s for piece in weber.pieces for s in piece.series)
        self.assertEqual((str(series.value), series.integer), ("2*N + 1", "N"))
        self.assertEqual([level.n for level in series.levels], [0, 1, 2, 3])
        for level in series.levels:                      # each eigenfunction solves y'' = (x^2 - E) y
            self.assertEqual(level.fixed[0], "E")
            self.assertEqual(int(str(level.fixed[1])), 2 * level.n + 1)
            self.assertIn("exp(", level.y)
        sextic = kovacic.spectrum("x^6 - (4*J + 3)*x^2 - E", energy="E", set={"J": 1}, levels=1)
        degrees = [f for piece in sextic.pieces for f in piece.families]
        self.assertIs(sextic.pieces[0].status, kovacic.SpectrumStatus.degrees)
        self.assertEqual(str(degrees[0].levels[0].equations[0]), "E^2 - 8")
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.spectrum("x^2 - E", energy="x")
        with self.assertRaises(TypeError):
            bool(weber)

    def test_both_solutions(self):
        self.assertEqual(kovacic.solve("-1/(4*z^2)").basis, ("z^(1/2)", "z^(1/2)*log(z)"))
        self.assertEqual(kovacic.solve("z*y'' + y' = 0").basis, ("1", "log(z)"))
        self.assertIsNone(kovacic.solve("z").basis)

    def test_solutions_in_the_given_letters(self):
        for ode, parameters, wanted in (("u'' = t*u", "", ["airyai(t)", "airybi(t)"]), ("w'' + 4*w = 0", "", ["cos(2*x)", "sin(2*x)"]),
                                        ("z^2*y'' + z*y' + (z^2 - n^2)*y = 0", "n", ["besselj(n, z)", "bessely(n, z)"]),
                                        ("y'' + a^2*y = 0", "a", ["cos(a*x)", "sin(a*x)"])):
            answer = kovacic.solve(ode, parameters=parameters)
            self.assertEqual(answer.equation, ode)
            self.assertEqual(answer.solutions, wanted)

    def test_polynomial_of_y(self):
        r = "-3/(16*z^2) - 2/(9*(z-1)^2) + 3/(16*z*(z-1))"
        power, factor, coefficients = kovacic.solve(r).polynomial_of_y
        self.assertEqual((power, str(factor), len(coefficients), str(coefficients[4])), (4, "z^2 - z", 7, "(5*z - 5)/2"))
        given = kovacic.solve(f"y'' + y'/z - (1/(4*z^2) + {r})*y = 0").polynomial_of_y
        self.assertEqual((str(given[1]), given[2]), ("(z - 1)/z", coefficients))
        self.assertIsNone(kovacic.solve(f"y'' + y' - (-1/4 + {r})*y = 0").polynomial_of_y)
        self.assertIsNone(kovacic.solve("z").polynomial_of_y)

    def test_evidence_by_pattern_matching(self):
        match kovacic.solve("z^2 + 3").because:
            case ByEngines(kovacic.Argument.torus_one_line, exponential=omega):
                self.assertEqual(str(omega), "(z^2 + 1)/z")
            case other:
                self.fail(repr(other))
        match kovacic.solve("z"):
            case kovacic.Decision(group, ByEngines(no_exponential=why)):
                self.assertEqual(str(group), "SL(2, C)")
                self.assertIsNotNone(why)
            case other:
                self.fail(repr(other))

    def test_forms(self):
        airy = kovacic.solve("z").r
        for same in (kovacic.solve(r="z"), kovacic.solve("y'' = z*y"), kovacic.solve(ode="diff(y,z,2) - z*y = 0"),
                     kovacic.solve(p=0, q="-z")):
            self.assertEqual(same.r, airy)
        bessel = kovacic.solve("z^2*y'' + z*y' + (z^2 - 1/4)*y = 0")
        self.assertEqual(bessel.r, -1)
        self.assertEqual(bessel.factor, "z^(-1/2)")
        self.assertIn("y = cos(z)/sqrt(z)", str(bessel))

    def test_values(self):
        f = RationalFunction("(z^2 - 1)/(2*z)")
        self.assertEqual(f.num, [Fraction(-1, 2), 0, Fraction(1, 2)])
        self.assertEqual(f(3), Fraction(4, 3))
        self.assertEqual(f(Fraction(1, 2)), Fraction(-3, 4))
        self.assertEqual((f + 1) * 2 - Fraction(2), 2 * f)
        self.assertEqual(f.diff(), RationalFunction("1/2 + 1/(2*z^2)"))
        self.assertEqual(f ** -1 * f, 1)
        self.assertEqual(kovacic.solve(f - f + RationalFunction("z")).group.type, GroupType.SL2)
        with self.assertRaises(kovacic.DomainError):
            f(0)
        with self.assertRaises(kovacic.InvalidArgument):
            f + RationalFunction("x", "x")
        for too_large in (10**6, -10**9):
            with self.assertRaises(kovacic.OutOfBudget):
                f ** too_large

    def test_integers_of_any_size(self):
        n = 10**5000 + 7
        answer = kovacic.solve(n)
        self.assertEqual(answer.r.num, [n])
        self.assertEqual(kovacic.solve(Fraction(1, n)).r(0), Fraction(1, n))
        self.assertEqual(RationalFunction("z")(-n), -n)
        self.assertEqual(RationalFunction("z")(-2**63), -2**63)

    def test_algebraic_numbers(self):
        answer = kovacic.solve("c/z^2", set={"c": "sqrt(2)"})
        self.assertIs(answer.abelian, Truth.yes)
        c, = answer.r.num
        self.assertAlmostEqual(complex(c), math.sqrt(2))
        self.assertEqual(c.minpoly, [-2, 0, 1])

    def test_no_truth_value(self):
        answer = kovacic.solve("z^2 + a", parameters="a")
        for value in (kovacic.solve("z"), kovacic.solve("z").abelian, Truth.unknown, answer, answer.strata[0],
                      kovacic.solve("z").because, kovacic.solve("z").group):
            with self.assertRaises(TypeError):
                bool(value)

    def test_answers_cannot_be_made(self):
        for type_ in (kovacic.Decision, kovacic.StrataAnswer, kovacic.Accepted, kovacic.TheoremResult):
            with self.assertRaises(TypeError):
                type_()
        with self.assertRaises(AttributeError):
            kovacic.solve("z").abelian = Truth.yes
        answer = kovacic.solve("z")
        self.assertIs(copy.copy(answer), answer)

    def test_limits(self):
        hard = "+".join(f"{7**k}/(z-{k})^2" for k in range(1, 60)) + "+1/(z^3-2)^2"
        answer = kovacic.solve("z^4 + 2002*z", max_degree=100)
        self.assertIs(answer.abelian, Truth.no)  # what is proved stays
        self.assertIsNone(answer.group)
        self.assertIs(answer.undecided.why, kovacic.Why.budget)
        with self.assertRaises(kovacic.OutOfBudget):
            kovacic.solve(hard, timeout=1e-6)  # not even read
        for wrong in (0, -1, math.nan):
            with self.assertRaises(kovacic.InvalidArgument):
                kovacic.solve("z", timeout=wrong)
        self.assertIs(kovacic.solve("z", timeout=math.inf).abelian, Truth.no)
        self.assertIs(kovacic.solve("z", timeout=None).abelian, Truth.no)

    def test_certificate(self):
        answer = kovacic.solve("z", certificate=True)
        accepted = kovacic.verify(answer.certificate)
        self.assertIsInstance(accepted, kovacic.Accepted)
        self.assertEqual(accepted.trusted_steps, 0)
        changed = answer.certificate.replace('"SL2"', '"Borel"')
        self.assertIsInstance(kovacic.verify(changed), kovacic.Rejected)
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.verify("{}")
        self.assertIsNone(kovacic.solve("z").certificate)

    def test_html(self):
        for answer in (kovacic.solve("z^2 + 3"), kovacic.solve("z^2 + a", parameters="a")):
            self.assertIn("<table>", answer._repr_html_())
        self.assertTrue(kovacic.solve("z").r._repr_latex_().startswith("$"))


class Families(unittest.TestCase):
    def test_strata(self):
        answer = kovacic.solve("a/z", parameters="a")
        self.assertIs(answer.abelian, Truth.unknown)
        self.assertEqual(len(answer.strata), 2)
        self.assertIs(answer.at({"a": 0}).abelian, Truth.yes)
        self.assertIs(answer.at({"a": Fraction(-7, 2)}).abelian, Truth.no)
        self.assertEqual({s.where for s in answer.strata}, {"a = 0", "a != 0"})

    def test_same_everywhere(self):
        answer = kovacic.solve("z + a", parameters=["a"])
        self.assertIs(answer.abelian, Truth.no)
        self.assertIs(answer.group.type, GroupType.SL2)
        match answer.strata[0].because:
            case [*_, kovacic.NoExponential()]:
                pass
            case other:
                self.assertTrue(any(isinstance(e, kovacic.NoExponential) for e in other), other)

    def test_assumptions_are_kept(self):
        answer = kovacic.solve("z^2/4 - 1/2 - n", assume="n not an integer")
        self.assertIs(answer.abelian, Truth.no)
        self.assertEqual(answer.assumed, ["n is not an integer"])
        self.assertIn("n is not an integer", str(answer))
        self.assertIn("n is not an integer", answer._repr_html_())

    def test_open_is_not_decided(self):
        answer = kovacic.solve("(a*z^5 + b)/(z^3 - 1)^2 + 1/z^2", parameters=["a", "b"])
        self.assertIs(answer.abelian, Truth.unknown)
        self.assertTrue(any(s.undecided for s in answer.strata))

    def test_closed_answers_are_strata(self):
        answer = kovacic.solve("(n^2 - 1/4)/z^2 - 1", parameters="n")
        self.assertEqual({(*s.conditions, s.abelian) for s in answer.strata},
                         {("n is in 1/2 + Z", Truth.yes), ("n is not in 1/2 + Z", Truth.no)})
        self.assertEqual(answer.family.family, "Bessel")
        self.assertIn("1/2 + Z", str(answer))
        self.assertIn("1/2 + Z", answer._repr_html_())

    def test_contradictory_assumptions(self):
        try:
            answer = kovacic.solve("z^2 + a", assume=["a > 0", "a < 0"])
        except kovacic.InputError:
            return
        self.assertTrue(answer.contradictory)
        self.assertIs(answer.abelian, Truth.unknown)

    def test_certificate(self):
        answer = kovacic.solve("z + a", parameters="a", certificate=True)
        self.assertIsInstance(kovacic.verify(answer.certificate), kovacic.Accepted)


class Lame(unittest.TestCase):
    def test_numbers(self):
        answer = kovacic.lame(1, 0, 4, 0)
        self.assertIs(answer.abelian, Truth.yes)
        self.assertEqual(answer.group.type, GroupType.T)

    def test_conditions(self):
        answer = kovacic.lame(Fraction(3, 2))
        self.assertEqual([str(f) for f in answer.polynomials], [str(answer.polynomials[0])])
        self.assertIs(answer.abelian, Truth.unknown)
        self.assertFalse(answer.always)
        self.assertIs(kovacic.lame("1/7").abelian, Truth.unknown)  # the degenerate curve is not excluded
        self.assertTrue(kovacic.lame("1/7").never)
        self.assertIs(kovacic.lame("1/7", g2=4, g3=0).abelian, Truth.no)

    def test_degenerate_curve(self):
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.lame(1, g2=0, g3=0)
        self.assertIs(kovacic.lame(1, 0, 12, 8).abelian, Truth.yes)

    def test_families(self):
        self.assertTrue(all(isinstance(f, kovacic.LameFamily) for f in kovacic.lame("n")))

    def test_both(self):
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.lame(1, alpha=2)


class MonodromyOfAnEquation(unittest.TestCase):
    def test_matrices(self):
        answer = kovacic.monodromy("-3/(16*z^2) + 1/z", digits=20)
        loop, = answer.loops
        self.assertEqual(loop.place, "0")
        trace = sum(loop.matrix[i][i] for i in range(2))
        self.assertAlmostEqual(trace, 2 * math.cos(math.pi * 1.5), places=12)
        self.assertLess(float(loop.radius), 1e-19)
        self.assertIsNone(answer.proves)

    def test_sl2(self):
        r = "-3/(16*z^2) - 1/(4*(z-1)^2) + 7/(5*z*(z-1)*(z-2))"
        self.assertIs(kovacic.monodromy(r).proves, GroupType.SL2)


if __name__ == "__main__":
    unittest.main()
