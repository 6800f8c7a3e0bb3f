"""kovacic.System: the same system from SymPy and from text, in every kind, and what it answers."""

import copy
import doctest
import inspect
import io
import pickle
import unittest
from fractions import Fraction

import kovacic
from kovacic import InputError, InvalidArgument, VerdictKind, WrongType

try:
    import sympy
except ImportError:
    sympy = None

HENON = "(p1^2 + p2^2)/2 + q1^2*q2 + b*q2^3/3"


def henon():
    return kovacic.System(HENON, ["q1", "q2"], ["p1", "p2"])


class Kinds(unittest.TestCase):
    def test_text(self):
        s = henon()
        self.assertEqual((s.kind, s.coordinates, s.parameters), ("hamiltonian", ["q1", "q2", "p1", "p2"], ["b"]))
        self.assertEqual({x: str(f) for x, f in s.equations().items()}["p2"], "-q1^2 - q2^2*b")
        self.assertEqual(str(kovacic.System("p^2/2 - cos(q)", "q", "p").equations()["p"]), "-sin_q")

    def test_lagrangian(self):
        s = kovacic.System.lagrangian("m*v^2/2 - k*x^2/2", ["x"], ["v"])
        self.assertEqual((s.kind, s.coordinates, s.parameters), ("lagrangian", ["x", "p_x"], ["k", "m"]))
        self.assertEqual(str(s.hamiltonian), "(x^2*k*m + p_x^2)/(2*m)")

    def test_poisson(self):
        rows = [[0, "-z", "y"], ["z", 0, "-x"], ["-y", "x", 0]]
        s = kovacic.System.poisson("x^2/a + y^2/b + z^2/c", "x y z", rows)
        self.assertEqual((s.kind, s.parameters, len(s.equations())), ("poisson", ["a", "b", "c"], 3))
        with self.assertRaises(InputError):  # no Jacobi identity
            kovacic.System.poisson("x", "x y z", [[0, "z", "x*y"], ["-z", 0, "y"], ["-x*y", "-y", 0]]).equations()

    def test_field(self):
        s = kovacic.System.field({"x": "s*(y - x)", "y": "r*x - y - x*z", "z": "x*y - b*z"})
        self.assertEqual((s.kind, s.parameters, s.hamiltonian), ("vector-field", ["b", "r", "s"], None))
        self.assertEqual(s, kovacic.System.field(["s*(y - x)", "r*x - y - x*z", "x*y - b*z"], "x y z"))

    @unittest.skipUnless(sympy, "needs SymPy")
    def test_sympy(self):
        q1, q2, p1, p2 = sympy.symbols("q1 q2 p1 p2")
        b = sympy.Symbol("b", positive=True)
        s = kovacic.System((p1**2 + p2**2) / 2 + q1**2 * q2 + b * q2**3 / 3, [q1, q2], [p1, p2])
        self.assertEqual(s.parameters, ["b"])
        self.assertIn("b > 0", s.to_text())
        self.assertNotEqual(s, henon())  # b is assumed to be positive
        plain = s.equations(sympy=True)["p1"]
        self.assertEqual(plain, -2 * q1 * q2)
        matrix = sympy.Matrix([[0, sympy.Symbol("z")], [-sympy.Symbol("z"), 0]])
        self.assertEqual(kovacic.System.poisson(sympy.Symbol("x"), "x y", sympy.Matrix([[0, 1], [-1, 0]])).coordinates, ["x", "y"])
        del matrix

    @unittest.skipUnless(sympy, "needs SymPy")
    def test_functions(self):
        theta, p = sympy.symbols("theta p")
        s = kovacic.System(p**2 / 2 - sympy.cos(theta), [theta], [p])
        self.assertEqual(s.equations(sympy=True)["p"], -sympy.sin(theta))
        self.assertEqual(s.variational_equations(), sympy.Matrix([[0, 1], [-sympy.cos(theta), 0]]))

    def test_mistakes(self):
        for wrong, error in [(lambda: kovacic.System("p^2", "q1 q2", "p"), InvalidArgument),
                             (lambda: kovacic.System(0.5, "q", "p"), WrongType),
                             (lambda: kovacic.System("p^2 +* q", "q", "p").equations(), InputError),
                             (lambda: kovacic.System("a*b"), InputError),
                             (lambda: kovacic.System.field({"x": "y"}, "x y"), InvalidArgument),
                             (lambda: bool(henon()), TypeError),
                             (lambda: kovacic.System.from_text("file.toml"), InvalidArgument)]:
            with self.assertRaises(error):
                wrong()


class Values(unittest.TestCase):
    def test_equality_and_copies(self):
        s = henon()
        same = kovacic.System("p1^2/2 + p2^2/2 + q2*q1^2 + b/3*q2^3", "q1 q2", "p1 p2", parameters="b")
        self.assertEqual(s, same)
        self.assertEqual(len({s, same}), 1)
        for other in (kovacic.System(HENON, ["q2", "q1"], ["p2", "p1"]), kovacic.System(HENON + " + q1", "q1 q2", "p1 p2"),
                      kovacic.System(HENON, "q1 q2", "p1 p2", assume="b > 0"), kovacic.System(HENON, "q1 q2", "p1 p2", set={"b": 2})):
            self.assertNotEqual(s, other)
        self.assertNotEqual(s, HENON)
        for again in (pickle.loads(pickle.dumps(s)), copy.deepcopy(s), kovacic.System.from_text(s.to_text())):
            self.assertEqual(again, s)
        self.assertEqual(pickle.loads(pickle.dumps(s)).to_dict(), s.to_dict())

    def test_to_dict(self):
        d = henon().to_dict()
        self.assertEqual(d["kind"], "hamiltonian")
        again = kovacic.System(d["hamiltonian"], d["coordinates"], d["momenta"])
        self.assertEqual(again, henon())
        d["momenta"].append("x")
        self.assertEqual(henon().to_dict()["momenta"], ["p1", "p2"])

    def test_repr(self):
        self.assertIn("parameters b", repr(henon()))
        self.assertIn("x' = ", repr(kovacic.System.field({"x": "x^2"})))
        self.assertLess(len(repr(kovacic.System("+".join(f"q^{i}" for i in range(2, 90)), "q", "p"))), 120)

    def test_version(self):
        self.assertRegex(kovacic.__version__, r"^\d+\.\d+")


class Answers(unittest.TestCase):
    def test_classify(self):
        s = kovacic.System("p1^2/2 + p2^2/2 + q1^2*q2 + q2^3/3", "q1 q2", "p1 p2")
        self.assertEqual(s.classify().status, kovacic.classify(s.to_text()).status)

    def test_check_looks_for_manifolds(self):
        report = henon().check(set={"b": 3})
        self.assertIs(report.verdict, VerdictKind.non_integrable)
        own = kovacic.System(HENON, "q1 q2", "p1 p2", manifolds={"name": "N", "equations": ["q1 = 0", "p1 = 0"], "level": ["H = h"]},
                             parameters="h")
        self.assertEqual([m.name for m in own.check(set={"b": Fraction(3), "h": 1}).manifolds], ["N"])

    def test_find_manifolds(self):
        found = henon().find_manifolds()
        self.assertIn(["q1 = 0", "p1 = 0"], [m.equations for m in found])
        self.assertTrue(all(m.dimension > 0 for m in found))

    def test_integrals(self):
        self.assertEqual(len(kovacic.System("(px^2 + py^2)/2 + x^2 + y^2", "x y", "px py").integrals().sets), 1)


class Help(unittest.TestCase):
    @unittest.skipUnless(sympy, "needs SymPy")
    def test_every_member_has_an_example_that_runs(self):
        names = {"kovacic": kovacic, "S": henon()}
        members = [kovacic.System] + [m for n, m in inspect.getmembers(kovacic.System) if not n.startswith("_")]
        for member in members:
            text = inspect.getdoc(member) or ""
            with self.subTest(member=getattr(member, "__name__", member)):
                self.assertIn(">>>", text)
                out = io.StringIO()
                runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
                runner.run(doctest.DocTestParser().get_doctest(text, dict(names), "System", "System", 0), out=out.write)
                self.assertEqual(runner.summarize(verbose=False).failed, 0, out.getvalue())


if __name__ == "__main__":
    unittest.main()
