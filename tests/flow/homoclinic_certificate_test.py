"""Certificates of homoclinic points: the checker accepts what `kovacic section --homoclinic --certificate` writes and nothing
that was forged.  Usage: homoclinic_certificate_test.py KOVACIC VERIFY_DIR SCENES [all]     (all: some minutes, tools/attack)"""
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

kovacic, verify, scenes = sys.argv[1:4]
long = unittest.skipUnless("all" in sys.argv[4:], "minutes long")
sys.path.insert(0, verify)
import kovacic_verify                                   # noqa: E402
from certificate_format import Malformed, Rejected      # noqa: E402
from enclosures import BITS, Ball                       # noqa: E402


def written(scene):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "proof.json")
        subprocess.run([kovacic, "section", scenes, "--scene", scene, "--homoclinic", "--pictures", "none", "-q", "-o", folder,
                        "--certificate", path], check=True)
        with open(path, encoding="utf-8") as f:
            return json.load(f)


def uncoupled():
    """x'' = -x beside y'' = y - y^3, whose manifolds coincide: y = sqrt(2)/cosh(t), seen whenever x = 0"""
    def place(k):
        t = 2 * math.pi * k
        y = math.sqrt(2) / math.cosh(t)
        return ["0", repr(y), "1", repr(-y * math.tanh(t))]
    e = math.sqrt(2) * 2 * math.exp(-6 * math.pi)
    return {"format": "kovacic-homoclinic/1", "variables": ["x", "y", "u", "v"],
            "hamiltonian": ["2*u^2 + 2*v^2 + 2*x^2 - 2*y^2 + y^4", "4"], "level": "1/2", "section": ["x", "1"],
            "direction": "upward", "where": None, "period": "1", "point": ["0", "0", "1", "0"], "chart": ["1", "3"],
            "axes": [["1", "1"], ["1", "-1"]], "reach": repr(1.5 * e), "xi": repr(e), "eta": repr(e),
            "orbit": [place(k) for k in range(-2, 3)]}


class Certificates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.true = written("henon_heiles_8")
        cls.said = kovacic_verify.check(json.dumps(cls.true))

    def rejected(self, kinds=Rejected, **changes):
        with self.assertRaises(kinds):
            kovacic_verify.check(json.dumps(self.true | changes))

    def test_what_is_proved_is_accepted(self):
        trusted, _, lines = self.said
        self.assertEqual(trusted, 1)
        self.assertIn("1/8", lines[0])
        self.assertIn("homoclinic", lines[2])

    @long
    def test_at_other_energies(self):  # the region on which a cone is kept is another one
        for name, level in (("henon_heiles_6", "1/6"), ("henon_heiles_12", "1/12")):
            self.assertIn(level, kovacic_verify.check(json.dumps(written(name)))[2][0])

    def test_the_other_judge_says_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "proof.json")
            with open(path, "w", encoding="utf-8") as f:
                json.dump(self.true, f)
            out = subprocess.run([kovacic, "verify", path, "--format", "json"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(json.loads(out)["statement"], self.said[2])

    def test_another_system_level_or_section_is_rejected(self):
        self.rejected(level="1/7")
        self.rejected(hamiltonian=["6*x^2*y + 3*x^2 + 2*y^3 + 3*y^2 + 3*u^2 + 3*v^2", "6"])  # integrable
        self.rejected(direction="downward")

    def test_the_fixed_point_itself_is_no_homoclinic_point(self):
        self.rejected(xi="0", eta="0", orbit=[self.true["point"]] * 5)

    @long
    def test_ends_outside_of_the_region_are_rejected(self):
        self.rejected(reach=str(float(self.true["xi"]) / 2))
        self.rejected(reach="1/100")

    @long
    def test_a_section_with_an_edge_is_rejected(self):
        self.rejected(where=["-1", "1"])

    def test_a_moved_orbit_is_rejected(self):
        moved = [list(z) for z in self.true["orbit"]]
        moved[12][1] = str(float(moved[12][1]) + 1e-3)
        self.rejected(orbit=moved)
        self.rejected(axes=[["1", "0"], ["0", "1"]])

    def test_manifolds_that_coincide_are_rejected(self):
        with self.assertRaises(Rejected):
            kovacic_verify.check(json.dumps(uncoupled()))

    def test_what_is_no_certificate_is_malformed(self):
        for changes in ({"chart": ["1", "7"]}, {"level": "sqrt(2)"}, {"orbit": []}, {"period": "0"}, {"reach": "1e9999"},
                        {"level": "1E999999999"}, {"hamiltonian": ["x^2", "\u00b2"]}, {"hamiltonian": ["x^2", "9" * 5000]},
                        {"variables": ["x", "x", "u", "v"]}, {"hamiltonian": ["x^2", "0"]}, {"more": "1"},
                        {"point": ["0", "0", "1"]}, {"axes": [["1"], ["2"]]}, {"reach": "2"}):
            self.rejected(Malformed, **changes)


class Intervals(unittest.TestCase):
    """Every operation contains the exact result."""

    def test_arithmetic(self):
        gen = random.Random(3)
        for _ in range(3000):
            a, b = (Ball(gen.randrange(-2**gen.randrange(1, 130), 2**gen.randrange(1, 130)), gen.randrange(2**gen.randrange(1, 90)))
                    for _ in "ab")
            x, y = (Fraction(gen.randint(z.low(), z.high()), 2**BITS) for z in (a, b))
            q = Fraction(gen.randint(-50, 50), gen.randint(1, 50))
            pairs = [(a + b, x + y), (a - b, x - y), (a * b, x * y), (-a, -x), (a * Ball.of(q), x * q)]
            if b.sign():
                pairs.append((a / b, x / y))
            for ball, exact in pairs:
                self.assertLessEqual(ball.low(), exact * 2**BITS)
                self.assertLessEqual(exact * 2**BITS, ball.high())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
