#!/usr/bin/env python3
"""Steps about Darboux points in bundles of `kovacic classify`: both checkers accept them and refuse each forged one.

usage: darboux_python_test.py KOVACIC"""
import copy
import json
import os
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
VERIFY = os.path.join(HERE, "../../tools/verify")
KOVACIC = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, VERIFY)
from rule_darboux import Table                                       # noqa: E402
from multivariate import Work                                   # noqa: E402

HEAD = """format = "equation/1"
[system]
kind        = "hamiltonian"
coordinates = ["x", "y"]
momenta     = ["u", "v"]
"""
FILES = {
    "cubic": 'parameters = ["a"]\nhamiltonian = "(u^2 + v^2)/2 + a*x^2*y + y^3/3"',
    "masses": 'parameters = ["a"]\nhamiltonian = "(3*u^2 - v^2)/2 + a*x^2*y + y^3/3 + x*y^2"',       # indefinite, no symmetry
    "part": 'parameters = ["a", "b", "c"]\nhamiltonian = "(u^2 + v^2)/2 + (a*x^2 + b*y^2)/2 + x^2*y - c/3*y^3"',
    "quartic": 'parameters = ["a"]\nhamiltonian = "(u^2 - 2*v^2)/2 + x^4/4 + a*x^2*y^2/2 + y^4/4 + x^3*y"',
    "real": 'parameters = ["a"]\nhamiltonian = "(u^2 + v^2)/2 + a*x^2*y - y^3/3 + x*y^2"\n[assume]\na = "positive"',
    "complex": 'parameters = ["i", "a"]\nhamiltonian = "(u^2 + v^2)/2 + a*x^2*y + i*y^3/3 + x*y^2"\n[assume]\nconditions = ["i^2 = -1"]'}


def checked(path):
    said = []
    for command in ([KOVACIC, "verify"], [sys.executable, os.path.join(VERIFY, "kovacic_verify.py")]):
        p = subprocess.run([*command, path], capture_output=True, text=True)
        said.append((p.returncode, p.stdout.splitlines()[1:], p.stdout + p.stderr))
    return said


class DarbouxPoints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.tops = {}
        for name, text in FILES.items():
            path = os.path.join(cls.folder.name, name)
            with open(path + ".toml", "w", encoding="utf-8") as f:
                f.write(HEAD + text)
            subprocess.run([KOVACIC, "classify", path + ".toml", "--certificate", path + ".json", "--timeout", "0"],
                           capture_output=True, text=True)
            if os.path.exists(path + ".json"):
                with open(path + ".json", encoding="utf-8") as f:
                    cls.tops[name] = json.load(f)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def both(self, top):
        path = os.path.join(self.folder.name, "forged.json")
        with open(path, "w", encoding="utf-8") as f:
            json.dump(top, f)
        return checked(path)

    def forged(self, top, what):
        for code, _, said in self.both(top):
            self.assertIn(code, (1, 2), f"{what}: {said}")

    def steps(self, name):
        return [k for k, s in enumerate(self.tops[name]["steps"]) if s["rule"] == "darboux"]

    def test_both_accept_and_state_the_same(self):
        said = set()
        for name in self.tops:
            (one, lines, text), (other, same, more) = self.both(self.tops[name])
            self.assertEqual((one, other), (0, 0), name + text + more)
            self.assertEqual(lines, same, name)
            said |= {s["says"] + " " + s["part"] for s in self.tops[name]["steps"] if s["rule"] == "darboux"}
        self.assertLessEqual({"relation all", "relation highest", "multiple all"}, said)
        self.assertEqual({name for name in self.tops if self.steps(name)}, set(FILES))

    def test_each_field(self):
        for name, number in (("cubic", 0), ("complex", 0), ("part", 0)):
            top, k = self.tops[name], self.steps(name)[number]
            step = top["steps"][k]
            relation = step["says"] == "relation"
            changes = {"degree": str(int(step["degree"]) + 1), "says": "multiple" if relation else "relation", "part": "all" if step["part"] != "all" else "first", "unit": "2",
                       "rest": step["rest"] + " + x", "proper": step["proper"] + " + 1",
                       "chart": [step["chart"][0], str(int(step["chart"][1]) + 1)], "coordinates": step["coordinates"][::-1],
                       "momenta": step["momenta"][::-1], "choices": step["choices"][1:] or ["1"],
                       "shown": step["shown"][:-1]} | ({"isotropic": {**step["isotropic"], "order": "1"}} if relation else {})
            for key, value in changes.items():
                other = copy.deepcopy(top)
                other["steps"][k][key] = value
                self.forged(other, f"{name}: {key}")
            for key in step if name == "part" else ():
                other = copy.deepcopy(top)
                del other["steps"][k][key]
                self.forged(other, f"{name}: without {key}")

    def test_each_value_and_proof(self):
        top, k = self.tops["masses"], next(k for k in self.steps("masses") if self.tops["masses"]["steps"][k]["choices"])
        gap = {"node": "empty", "terms": [["1", "1"]], "zeros": []}
        for i in range(len(top["steps"][k]["shown"])):
            for key, value in (("value", "a + 5"), ("by", gap))[i % 2:i % 2 + 1]:
                other = copy.deepcopy(top)
                other["steps"][k]["shown"][i][key] = value
                self.forged(other, (i, key))
        for i, choice in enumerate(top["steps"][k]["choices"]):
            for key, value in (("by", gap), ("equations", ["1"] * len(choice["equations"])), ("values", choice["values"][::-1] + ["7"]),
                               ("values", [str(Fraction(v) + 1) for v in choice["values"]])):
                other = copy.deepcopy(top)
                other["steps"][k]["choices"][i][key] = value
                self.forged(other, (i, key))

    def test_other_masses_or_another_potential(self):
        for name in ("masses", "part"):
            top = self.tops[name]
            h = top["systems"][0]["system"]["hamiltonian"]
            for more in ("u^2", "y^3", "u*v", "x^5", "x*u", "x^2*u^2"):
                other = copy.deepcopy(top)
                text = h[0] if isinstance(h, list) else h
                changed = f"{text} + 6*{more}"
                other["systems"][0]["system"]["hamiltonian"] = [changed, h[1]] if isinstance(h, list) else changed
                self.forged(other, f"{name} + {more}")
            other = copy.deepcopy(top)
            other["systems"][0]["system"]["brackets"][0][2] = "2"
            self.forged(other, name)

    def test_conditions_that_are_needed(self):
        """Without a = 1, say, among what is excluded: some condition of each region must be missed."""
        top, k = self.tops["cubic"], self.steps("cubic")[0]
        needed = 0
        for i in range(len(top["steps"][k]["region"])):
            other = copy.deepcopy(top)
            del other["steps"][k]["region"][i]
            needed += all(code in (1, 2) for code, *_ in self.both(other))
        self.assertEqual(needed, len(top["steps"][k]["region"]))

    def test_the_table(self):
        """As printed in 2001, and the sets of 2005 and 2009 for three and four simple points"""
        Work.left = 10**8

        def printed(k, p):
            yield p + Fraction(p * (p - 1) * k, 2)
            yield Fraction(1, 2) * (Fraction(k - 1, k) + p * (p + 1) * k)
            for degree, c, w, u, v in ((3, Fraction(-1, 24), Fraction(1, 6), 1, 3), (3, Fraction(-1, 24), Fraction(3, 32), 1, 4),
                                       (3, Fraction(-1, 24), Fraction(3, 50), 1, 5), (3, Fraction(-1, 24), Fraction(3, 50), 2, 5),
                                       (4, Fraction(-1, 8), Fraction(2, 9), 1, 3), (5, Fraction(-9, 40), Fraction(5, 18), 1, 3),
                                       (5, Fraction(-9, 40), Fraction(1, 10), 2, 5)):
                if degree == k:
                    yield c + w * (u + v * p)**2
        for k in range(3, 10):
            values = {x for p in range(-40, 41) for x in printed(k, p) if x != 1 and x <= 300}
            self.assertEqual({v + 1 for v in Table(k).up_to(299)}, values, k)
            self.assertTrue(all(Table(k).contains(v - 1) for v in values))
            self.assertFalse(Table(k).contains(Fraction(1, 7) - 1))
        self.assertEqual(len(Table(3).sets(3, Fraction(-1))), 4)
        self.assertEqual(len(Table(4).sets(4, Fraction(-1))), 5)
        self.assertEqual(Table(3).sets(2, Fraction(-1)), [])

    def classified(self, name, rest):
        path = os.path.join(self.folder.name, name)
        with open(path + ".toml", "w", encoding="utf-8") as f:
            f.write(HEAD + rest)
        subprocess.run([KOVACIC, "classify", path + ".toml", "--certificate", path + ".json", "--timeout", "0"], capture_output=True, check=False)
        with open(path + ".json", encoding="utf-8") as f:
            top = json.load(f)
        (one, lines, text), (other, same, more) = checked(path + ".json")
        self.assertEqual((one, other, lines), (0, 0, same), text + more)
        return top

    def test_what_has_no_certificate_says_why(self):
        top = self.classified("rational", 'hamiltonian = "(u^2 + v^2)/2 + 5*x^4/y + y^3/3"')
        trusted = [s["step"] for s in top["steps"] if s["rule"] == "trusted" and "Darboux" in s["step"]]
        self.assertTrue(trusted)
        for step in trusted:
            self.assertIn("[no certificate: the rule does not apply: a polynomial Hamiltonian of two degrees of freedom is expected]", step)

    def test_along_one_isotropic_direction(self):
        """V vanishes there for two values of a, and along both directions of x^2 y + y^3"""
        for name, rest, orders in (("isotropic", 'parameters = ["a"]\nhamiltonian = "(u^2 + v^2)/2 + x^2*y/2 + a*x^3/3 + y^3/15"', {(0, 0), (1, 0)}),
                                   ("both", 'hamiltonian = "(u^2 + v^2)/2 + x^2*y + y^3"', {(1, 1)})):
            top = self.classified(name, rest)
            self.assertEqual([s["id"] for s in top["steps"] if s["rule"] == "trusted"], [], name)
            found = set()
            for s in top["steps"]:
                if s["rule"] == "darboux" and s["says"] == "relation":
                    e = s["isotropic"]
                    first, second = int(e["order"]), int(e["lines"]["order"] if "lines" in e else e["order"])
                    found.add((max(first, second), min(first, second)))
            self.assertLessEqual(found, orders, name)

    def test_a_direction_that_is_at_infinity_somewhere(self):
        """In a chart a direction is at infinity for some m, in another one for other m; no exponent difference has to be special"""
        top = self.classified("charts", 'parameters = ["m"]\nhamiltonian = "(u^2 - v^2)/2 + m*x^2*y^2/2 + m^2*x^4/4 + y^4/4"')
        self.assertEqual([s["id"] for s in top["steps"] if s["rule"] == "trusted"], [])
        charts = {tuple(s["chart"]) for s in top["steps"] if s["rule"] == "darboux"}
        pairs = [s for s in top["steps"] if s["rule"] == "common-values"]  # which need no Darboux point
        self.assertTrue(len(charts) > 1 or pairs)


if __name__ == "__main__":
    unittest.main()
