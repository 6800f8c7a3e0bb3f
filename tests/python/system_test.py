"""Systems, theorems, integrals and sections; the files of the project come from KOV_SOURCE."""

import os
import pathlib
import subprocess
import sys
import unittest
from fractions import Fraction

import kovacic
from kovacic import Truth, VerdictKind

ROOT = pathlib.Path(os.environ["KOV_SOURCE"])
CASES = ROOT / "cases"

CUBIC = """
[system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["h"]
hamiltonian = "(p1^2 + p2^2)/2 + q1^2*q2 + q2^3/2"
[[manifold]]
name = "N"
equations = ["q1 = 0", "p1 = 0"]
level = "H = h"
"""


class Check(unittest.TestCase):
    def test_file(self):
        report = kovacic.check(CASES / "sliding_top" / "lemma3_sample.toml", set={"A": 1, "C": Fraction(3, 2)})
        self.assertIs(report.verdict, VerdictKind.non_integrable)
        manifold, = report.manifolds
        self.assertEqual(manifold.by.id, "Morales-Ramis")
        self.assertEqual(manifold.integrals, "meromorphic")
        self.assertEqual(len(manifold.trusted_steps), 0)
        self.assertEqual(report.values, {"A": 1, "C": Fraction(3, 2)})
        self.assertIs(manifold.blocks[0].answer.abelian, Truth.no)
        self.assertTrue(all(claim.proved is Truth.yes for claim in report.claims))
        for said in (str(report), report._repr_html_()):
            self.assertIn("NON-INTEGRABLE (Morales-Ramis", said)
            self.assertIn("first integrals", said)
            self.assertNotIn("trusted", said)  # the way to r(z) has a certificate

    def test_text(self):
        report = kovacic.check(CUBIC, set={"h": 1}, certificate=True)
        self.assertIs(report.verdict, VerdictKind.non_integrable)
        self.assertIsInstance(kovacic.verify(report.certificates["N"]), kovacic.Accepted)

    def test_no_obstruction_is_not_integrable(self):
        report = kovacic.check(CASES / "sliding_top" / "lemma3.toml", set={"A": 1, "C": "A"})
        self.assertIs(report.verdict, VerdictKind.no_obstruction)
        self.assertIn("does not prove integrability", str(report))

    def test_levels_are_told(self):
        report = kovacic.check(CASES / "classics" / "heavy_top_equatorial.toml", set={"C": 3})
        self.assertIs(report.verdict, VerdictKind.non_integrable)
        levels = [level for m in report.manifolds for b in m.blocks for level in b.levels]
        self.assertTrue(levels)
        for condition, why, answer, note in levels:
            for said in (str(report), report._repr_html_().replace("&lt;", "<")):
                self.assertIn(condition, said)

    def test_undecided_says_why(self):
        report = kovacic.check(CUBIC, set={"h": 1}, timeout=1e-6)
        self.assertIs(report.verdict, VerdictKind.undecided)
        self.assertTrue(report.manifolds[0].reasons)
        self.assertIn("because", str(report))

    def test_not_a_manifold(self):
        report = kovacic.check(CUBIC.replace("q1 = 0\", \"p1 = 0", "q1 = 1\", \"p1 = 0"))
        self.assertIsNotNone(report.manifolds[0].failure)
        self.assertIs(report.verdict, VerdictKind.failed)

    def test_equation_file(self):
        answer = kovacic.check("format = 'equation/1'\n[ode]\nr = 'z'\n")
        self.assertIs(answer.abelian, Truth.no)

    def test_nothing_asked(self):
        report = kovacic.check(CUBIC[:CUBIC.index("[[manifold]]")])
        self.assertIs(report.verdict, VerdictKind.undecided)
        self.assertIn("nothing was asked", str(report))

    def test_violated_assumption(self):
        with self.assertRaises(kovacic.InputError):
            kovacic.check(CASES / "sliding_top" / "lemma3.toml", set={"A": -1})


class Theorems(unittest.TestCase):
    def test_prove(self):
        theorem = kovacic.prove(CASES / "classics" / "heavy_top_theorem.toml")
        self.assertIsInstance(theorem.complete, bool)
        self.assertEqual(theorem.complete, theorem.verdict == "PROVED")
        self.assertIn("<table>", theorem._repr_html_())
        self.assertIn(theorem.conclusion, " ".join(theorem.text().split()))
        self.assertTrue(theorem.html().startswith("<!"))
        self.assertEqual(theorem.to_dict()["nodes"][0]["status"], theorem.nodes[0].status.name)
        self.assertEqual({type(c) for n in theorem.nodes for c in n.excluded}, {str})

    def test_limit_leaves_it_open(self):
        theorem = kovacic.prove(CASES / "classics" / "heavy_top_theorem.toml", timeout=1e-6)
        self.assertFalse(theorem.complete)
        self.assertEqual(theorem.statement, "")
        self.assertNotEqual(theorem.verdict, "PROVED")

    def test_proof_script(self):
        script = ROOT / "tests" / "proof_scripts" / "lemma3.py"
        ran = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=120)
        self.assertEqual(ran.stderr, "")
        self.assertTrue(ran.stdout.splitlines()[-1].startswith("Lemma 3 is proved"), ran.stdout)


class Together(unittest.TestCase):
    FILE = ROOT / "tests" / "cli" / "files" / "two_lines.toml"

    def test_nothing_is_left(self):
        report = kovacic.check(self.FILE, set={"a": 2})
        self.assertIs(report.together.status, kovacic.ClassificationStatus.non_integrable)
        self.assertIs(report.verdict, VerdictKind.non_integrable)

    def test_assumed_equations_are_values(self):
        report = kovacic.check(ROOT / "tests" / "cli" / "files" / "diagonal.toml")
        self.assertEqual([str(m.verdict) for m in report.manifolds], ["VerdictKind.non_integrable"] * 2)
        self.assertEqual(report.values["b"], Fraction(5, 2))

    # A is real; C = 1j, D = -1j satisfies all of it, and the group is then triangular
    PRODUCT = '''
[system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["A", "C", "D"]
hamiltonian = "(p1^2+p2^2)/2 + q2 - C/D*q1^2/(2*q2)"
[assume]
conditions = ["A > 0", "A = C*D"]
[[manifold]]
name = "axis"
equations = ["q1 = 0", "p1 = 0"]
level = "H = 1"
'''

    def test_assumptions_grow_no_stronger(self):
        values = '[set]\nA = "C*D"\n[assume]\nconditions = ["A > 0"]'
        by_value = self.PRODUCT.replace('[assume]\nconditions = ["A > 0", "A = C*D"]', values)
        for text in (self.PRODUCT, by_value):
            self.assertIsNot(kovacic.check(text).verdict, VerdictKind.non_integrable)
        real = self.PRODUCT.replace("[assume]", '[assume]\nC = "real"')
        self.assertIs(kovacic.check(real).verdict, VerdictKind.non_integrable)
        square = kovacic.check(self.PRODUCT.replace("A = C*D", "A = -C^2"))  # no contradiction
        self.assertIsNot(square.verdict, VerdictKind.non_integrable)

    def test_strata(self):
        report = kovacic.check(self.FILE)
        self.assertIn("If the system is integrable", report.together.statement)
        self.assertIsNot(report.verdict, VerdictKind.non_integrable)


class Integrals(unittest.TestCase):
    def test_logarithms(self):
        search = kovacic.integrals("""
[system]
kind = "vector-field"
coordinates = ["x", "y"]
[system.field]
x = "x - x*y"
y = "x*y - y"
""", 1)
        found, = search.sets[0].integrals
        self.assertEqual(repr(found), "<FoundIntegral x + y - log(x) - log(y)>")
        self.assertEqual([(str(c), str(f)) for c, f in found.logarithms], [("-1", "x"), ("-1", "y")])

    def test_henon_heiles(self):
        found = kovacic.integrals(CASES / "classics" / "henon_heiles.toml", 2)
        self.assertTrue(found.finished)
        self.assertTrue(any(len(s.values) > 1 for s in found.sets))
        self.assertIn("<table>", found._repr_html_())

    def test_what_is_assumed_is_shown(self):
        found = kovacic.integrals("""[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["b"]
hamiltonian = "(u^2 + v^2)/2 + b*x^2*y"
[assume]
conditions = ["b = 1"]
""")
        self.assertEqual(found.assumed_equations, ["b - 1"])
        self.assertIn("assumed: b - 1 = 0", found._repr_html_())

    def test_degree(self):
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.integrals(CUBIC, -1)


class Classifications(unittest.TestCase):
    GALAXY = """[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["b"]
hamiltonian = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + (x^2 + y^2)^2/4 + b*x^2*y^2/2"
"""

    def test_strata(self):
        found = kovacic.classify(self.GALAXY)
        self.assertIs(found.status, kovacic.ClassificationStatus.depends)
        self.assertEqual(found.integrals_class, "rational")
        integrable = [s.conditions for s in found.strata if s.status is kovacic.StratumStatus.integrable]
        self.assertCountEqual(integrable, [["b = 0"], ["b = 2"], ["b = -1"]])
        for stratum in found.strata:
            if stratum.status is kovacic.StratumStatus.excluded:
                self.assertTrue(stratum.by[0].solution)
        self.assertIn("integrable exactly", found.statement)
        self.assertIn("<table>", found._repr_html_())
        self.assertIn(found.statement, str(found))

    def test_almost_all(self):
        path = pathlib.Path(os.environ["KOV_SOURCE"]) / "cases/classify/satellite.toml"
        found = kovacic.classify(path)
        self.assertIs(found.status, kovacic.ClassificationStatus.open)
        self.assertIn("almost all parameters", found.statement)
        self.assertTrue(found.almost_all.reason.startswith("the monodromy matrices"))
        self.assertIsNone(kovacic.classify(self.GALAXY).almost_all)

    def test_one_value(self):
        self.assertIs(kovacic.classify(self.GALAXY, set={"b": 1}).status, kovacic.ClassificationStatus.non_integrable)
        self.assertIs(kovacic.classify(self.GALAXY, set={"b": 2}).status, kovacic.ClassificationStatus.integrable)

    def test_degree(self):
        with self.assertRaises(kovacic.InvalidArgument):
            kovacic.classify(self.GALAXY, degree=0)


class Sections(unittest.TestCase):
    SCENE = """format = "scene/1"
title = "a ball"
[body]
inertia = [1, 2, 3]
lever = [0, 0, "1/4"]
tip = "sliding"
gravity = 1
[levels]
H = 4
F2 = "1/2"
[section]
angle = "pi/2"
direction = "upward"
[orbits]
seeds = [[1, "1/3"], [2, "1/5"]]
crossings = 40
"""

    def test_points(self):
        section = kovacic.section(self.SCENE)
        self.assertEqual(len(section.x), len(section.orbit))
        self.assertGreaterEqual(len(section.x), 40)
        self.assertEqual(section.labels, ("l", "L/G"))
        self.assertLess(max(abs(y) for y in section.y), 1)
        self.assertLess(section.drift, 1e-9)
        self.assertFalse(section.stopped)
        self.assertIn("<svg", section._repr_html_())
        with self.assertRaises(TypeError):
            bool(section)

    def test_types(self):
        section = kovacic.section(self.SCENE)
        try:
            import numpy
        except ImportError:
            self.assertEqual(section.x.typecode, "d")
        else:
            self.assertIsInstance(section.x, numpy.ndarray)
            self.assertEqual(section.orbit.dtype, numpy.int64)

    def test_partial_says_so(self):
        section = kovacic.section(self.SCENE.replace("crossings = 40", "crossings = 20000000"), timeout=0.3)
        self.assertTrue(section.stopped)
        self.assertIn("PARTIAL", repr(section))
        self.assertIn("PARTIAL", section._repr_html_())

    def test_drift_is_no_picture(self):
        section = kovacic.section(self.SCENE)
        section.drift = 1.0
        self.assertNotIn("<svg", section._repr_html_())


if __name__ == "__main__":
    unittest.main()
