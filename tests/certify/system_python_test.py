#!/usr/bin/env python3
"""The Python checker of certificates from a system to "not integrable": accepts the genuine ones of systems.py, refuses
the false ones and whatever is hostile, and states what the page says."""
import glob
import json
import os
import sys
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import kovacic_verify as V  # noqa: E402
import systems  # noqa: E402
from traps import changed  # noqa: E402

ANGLE = """the system "an angle"
  {phi, J} = 1, {q, p} = 1, H = (2*J + q^2*s + p^2)/2
  s "sin(phi)": ds/dphi = c
  c "cos(phi)": dc/dphi = -s
  e "exp(phi)": de/dphi = e
  i "1 - cos(phi)": di/dphi = s
  j "J^2/2": dj/dJ = J
  s^2 + c^2 - 1 = 0
  first integral "H": (2*J + q^2*s + p^2)/2
  first integral "H again": (2*J*s^2 + 2*J*c^2 + q^2*s + p^2)/2
along the phase curve with z = s on "N": q = 0, p = 0
  for functions with s = z, c = c there
  c^2 = -z^2 + 1
is not integrable, for functions with s = z, c = c there, in Liouville's sense with first integrals that are meromorphic also at the \
ends of the phase curve (points at infinity, equilibria, poles of the system) (in the coordinates and s, c) and do not depend on phi, e, i (Morales-Ramis), as
  for the equation
  the identity component of the differential Galois group of y'' = ((4*z^3 - z^2 - 4*z - 2)/(4*z^4 - 8*z^2 + 4)) y is not abelian
    always: not abelian (torus)""".splitlines()


def verdict(text):
    """a accepted, r rejected, m malformed"""
    try:
        V.check(text)
        return "a"
    except V.Rejected:
        return "r"
    except V.Malformed:
        return "m"


class Systems(unittest.TestCase):
    def test_what_is_right_and_what_is_not(self):
        for name, text, right in systems.certificates():
            with self.subTest(name):
                self.assertEqual(verdict(text) == "a", right)

    def test_accepts_what_the_solver_wrote(self):
        for path in sorted(glob.glob(os.path.join(HERE, "data/system/*.json"))):
            with self.subTest(os.path.basename(path)), open(path, encoding="utf-8") as f:
                self.assertEqual(V.check(f.read())[0], 0)

    def test_syntax(self):
        for of, path, *value in systems.MALFORMED:
            with self.subTest(f"{of} {path}"):
                self.assertEqual(verdict(json.dumps(changed(systems.GENUINE[of], path.split(), *value))), "m")

    def test_the_statement(self):
        self.assertEqual(V.check(json.dumps(systems.GENUINE["angle"]))[2], ANGLE)

    def lines(self, name, *path):
        return V.check(json.dumps(changed(systems.GENUINE[name], *path)))[2]

    def test_the_statement_names_what_a_curve_chooses(self):
        """k = 3/2 would be a parameter with one value; the sine of 0 is 0, and the solution of s' = c that is 3/5 is shown"""
        self.assertIn("  for functions with k = w there", self.lines("constant", ["title"], "x"))
        top = systems.GENUINE["airy_field"]
        top = changed(top, ["system", "functions"], [{"name": "s", "meaning": "sin(y)", "gradient": {"y": "c"}},
                                                     {"name": "c", "meaning": "cos(y)", "gradient": {"y": "-s"}}])
        top = changed(changed(top, ["system", "relations"], ["c^2 + s^2 - 1"]), ["curve", "values", "s"], ["3", "5"])
        top = changed(top, ["curve", "values", "c"], ["-4", "5"])
        self.assertIn("  for functions with s = (3)/(5), c = (-4)/(5) there, where y = 0", V.check(json.dumps(top))[2])

    def test_a_bundle_names_them_in_its_sentence(self):
        """With the names of the tower in them, what they depend on, and levels in them"""
        for name, said in (("exponentials-of-a-sine-that-are-0", "e = 0, g = 0, s = 0, c = 1 there, where q1 = 0"),
                           ("level-through-the-tower", "f = 0 there, where q3 = w, w^2 = l"),
                           ("level-in-a-function-that-no-relation-fixes", "f = l - 1 there, where q3 = l, for some value of l")):
            with open(os.path.join(HERE, "false/theorem", name + ".true.json"), encoding="utf-8") as f:
                lines = V.check(f.read())[2]
            self.assertTrue(any(x.startswith(f"is not integrable, for functions with {said}, with first integrals") for x in lines), lines)
            self.assertTrue(any(x.endswith("; for functions with " + said) for x in lines), lines)

    def test_the_class_of_integrals(self):
        ends = " also at the ends of the phase curve (points at infinity, equilibria, poles of the system)"
        for name, said in (("regular", ""), ("unipotent", " and do not depend on phi"),
                           ("irregular", ends + " and do not depend on phi"), ("inverse", ends)):
            lines = V.check(json.dumps(systems.GENUINE[name]))[2]
            self.assertIn("is not integrable with first integrals and commuting vector fields that are meromorphic"
                          + said + " (Ayoul-Zung), as", lines)

    def test_a_bracket_of_several_leaves(self):
        lines = V.check(json.dumps(systems.GENUINE["level"]))[2]
        self.assertTrue(any(" and independent on the symplectic leaf of the phase curve (Morales-Ramis), as" in x for x in lines))
        self.assertIn('  Casimir function "both": (2*b*k^2)/4', lines)

    def test_the_claim(self):
        lines = self.lines("airy_field", ["claim", "not_integrable"], False)
        self.assertTrue(any(x.endswith("(Ayoul-Zung) where the identity component is not abelian:") for x in lines))

    def test_hostile_texts(self):
        texts = []
        for name in ("henon_heiles", "angle", "radius"):
            one = systems.GENUINE[name]
            for path in (["system"], ["curve"], ["normal"], ["equation"], ["claim"], ["system", "coordinates"], ["curve", "tower"],
                         ["curve", "values"], ["curve", "time"], ["curve", "change"], ["normal", "row"], ["normal", "p"],
                         ["equation", "certificate"], ["system", "functions"], ["curve", "values", "q1"]):
                for value in (None, 1, "x", "", [], {}, [[]], True, "9" * 10**6, {"a": "1"}, [None], [{}], [["x"]], ["z", "9" * 10**5],
                              ["z", "1", "9" * 10**5], "z^9999", "1" + " + z" * 25000, ["1", "1"] + ["1000"] * 500):
                    top = changed(one, path, value)
                    if top != one and (path, value) != (["system", "functions"], []):   # it may have none
                        texts.append(json.dumps(top))
        one = systems.GENUINE["henon_heiles"]
        tower = [{"name": f"w{i}", "degree": "2", "value": "z", "derivative": "0"} for i in range(32)]
        texts += [json.dumps(changed(one, *x)) for x in (
            (["curve", "tower"], tower), (["curve", "tower", 0, "degree"], "65"), (["curve", "tower", 0, "degree"], "9" * 99),
            (["curve", "time"], ["p2^9999", "1", "1000"]), (["curve", "time"], ["p2*z^9999*h^9999", "1", "1000"]),
            (["curve", "denominators", 0], "2*h - z^2 + h*z^9999"), (["curve", "denominators"], ["z"] * 201),
            (["curve", "denominators", 0], "9" * 9999), (["normal", "p"], ["p2^9999 + h*z + 1", "9" * 9999, "1000"]),
            (["system", "hamiltonian"], "q1^9999*p1^9999 + q2^9999"), (["system", "hamiltonian"], "*".join(["q1^9999"] * 999)),
            (["curve", "change"], "q2^9999*p2^9999"), (["parameters"], [f"a{i}" for i in range(13)]),
            (["system", "coordinates"], [f"a{i}" for i in range(41)]), (["equation", "certificate"], one),
            (["normal", "annihilators"], [{"row": ["0"] * 4, "matrix": ["0"] * 41}] * 41))]
        field = systems.GENUINE["airy_field"]
        flat = [f"x{i}" for i in range(37)]
        wide = changed(field, ["system"], {"coordinates": ["x", "y", "v", *flat], "field": ["1", "v", "x*y"] + ["0"] * 37, "functions": [
            {"name": "e", "meaning": "", "gradient": {x: "e" for x in ["y", "v", *flat]}}]})
        texts += [json.dumps(changed(wide, ["curve", "values"], {"x": "t", "y": "0", "v": "0", "e": "0"} | {x: "0" for x in flat}))]
        brackets = [[f"x{i}", f"x{j}", "x0*x1 + x2"] for j in range(40) for i in range(j)]
        many = changed(one, ["system"], {"coordinates": [f"x{i}" for i in range(40)], "hamiltonian": "x0", "brackets": brackets})
        texts += [json.dumps(many), json.dumps(changed(one, ["curve", "time"], "@")).replace('"@"', "[" * 5000 + "]" * 5000)]
        for text in texts:
            start = time.process_time()
            self.assertIn(verdict(text), "rm", text[:300])
            self.assertLess(time.process_time() - start, 30, text[:300])


if __name__ == "__main__":
    unittest.main()
