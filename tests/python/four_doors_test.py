"""`check`, Python's check(), `report`/`prove` and `test` give one verdict, one class of first integrals and one exit
code; `classify` is nowhere weaker.  Each file uses one rule of the driver (lib/study)."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import kovacic

PROGRAM = os.environ["KOV_PROGRAM"]

QUARTIC = """
[system]
kind = "hamiltonian"
coordinates = ["x", "y"]
momenta = ["u", "v"]
parameters = ["a", "b", "h"]
hamiltonian = "(u^2 + v^2)/2 + %s"
"""
X_AXIS = '[[manifold]]\nname = "x-axis"\nequations = ["y = 0", "v = 0"]\nlevel = ["H = h"]\n'
Y_AXIS = '[[manifold]]\nname = "y-axis"\nequations = ["x = 0", "u = 0"]\nlevel = ["H = h"]\n'
DIAGONAL = '[[manifold]]\nname = "diagonal"\nequations = ["y = x", "v = u"]\nlevel = ["H = h"]\n'

TWO_LINES = QUARTIC % "(x^4 + 2*a*x^2*y^2 + b*y^4)/4"
HENON_HEILES = """
[system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["A", "B", "b", "h"]
hamiltonian = "(p1^2 + p2^2)/2 + (A*q1^2 + B*q2^2)/2 + q1^2*q2 + b/3*q2^3"
%s
[[manifold]]
name = "N"
equations = ["q1 = 0", "p1 = 0"]
level = "H = h"
"""
HARD = """[[manifold]]
name = "hard"
equations = ["(x + 3*u)^9 = y + v^3", "(u + 2*y)^7 = 5 + x*u", "(v + x)^8 = u + x*y"]
level = "H = h"
"""

# name: text, values, order, flags of the command line
FILES = {
    "one curve decides": (TWO_LINES + X_AXIS, {"a": "2", "b": "1"}, 1, {}),
    "no obstruction": (TWO_LINES + X_AXIS, {"a": "1", "b": "1"}, 1, {}),
    "it depends on the parameters": (TWO_LINES + X_AXIS, {"b": "1"}, 1, {}),
    "several manifolds together": (TWO_LINES + '[assume]\nb = "nonzero"\n' + X_AXIS + Y_AXIS, {"a": "2"}, 1, {}),
    "assumed equations are values":
        (QUARTIC % "a*x^4 + b*y^4 + x^2*y^2" + '[assume]\nconditions = ["a = b", "2*b = 5"]\n' + X_AXIS + DIAGONAL,
         {}, 1, {}),
    "something is assumed of a level":
        (TWO_LINES + '[assume]\nconditions = ["h > 0"]\n' + X_AXIS, {"a": "2", "b": "1"}, 1, {}),
    "eigenvalues": ("""
[system]
kind = "hamiltonian"
coordinates = ["x", "y", "z"]
momenta = ["u", "v", "w"]
hamiltonian = "(u^2 + v^2 + w^2)/2 + (x^4 + y^4 + z^4)/4 + (x - y)^4/2 + (y - z)^4/2 + (z - x)^4/2"
[[manifold]]
name = "m"
equations = ["x = 0", "y + z = 0", "u = 0", "v + w = 0"]
level = "H = 1"
""", {}, 1, {}),
    "order 3 where the first passes": (HENON_HEILES % "", {"b": "1", "A": "1", "B": "2", "h": "1"}, 3, {}),
    "order 3 with exceptions": (HENON_HEILES % "", {"b": "1"}, 3, {}),
    "order 3 excludes nothing that is admitted":
        (HENON_HEILES % '[assume]\nconditions = ["(A - B)^2 = 0"]', {"b": "1"}, 3, {}),
    "order 3 by quadratures": ("""
[system]
kind = "lagrangian"
coordinates = ["r", "t"]
velocities = ["dr", "dt"]
parameters = ["h"]
lagrangian = "(5*dr^2/2 + r^2*dt^2)/2 - r*(3/2 - cos(t))"
[[manifold]]
name = "vertical"
equations = ["p_t = 0", "sin_t = 0", "cos_t = 1"]
level = "H = h"
""", {}, 3, {}),
    "claims": (TWO_LINES + '[[integral]]\nname = "F"\nvalue = "u*y - v*x"\n' + X_AXIS, {"a": "1", "b": "1"}, 1, {}),
    "a manifold that is none": (TWO_LINES + X_AXIS.replace("y = 0", "y = 1"), {"a": "2", "b": "1"}, 1, {}),
    "a limit costs one manifold": (TWO_LINES + HARD + X_AXIS, {"a": "2", "b": "1"}, 1, {"max_work": 1e5}),
    "a limit, and nothing else": (TWO_LINES + HARD, {"a": "2", "b": "1"}, 1, {"max_work": 1e5}),
    "no bracket": ("""
[system]
kind = "vector-field"
coordinates = ["x", "y", "z"]
field = {x = "1", y = "z", z = "x*y"}
[[manifold]]
name = "line"
equations = ["y = 0", "z = 0"]
""", {}, 1, {}),
}

# What the doors still answer differently, and why.  Empty: nothing.
KNOWN_DIFFERENCES = {}


def exit_of(verdict):
    return {"failed": 2, "undecided": 3}.get(verdict, 0)


class Doors:
    """The answers of each door about one file: (verdict, class of first integrals, exit code)."""

    def __init__(self, folder, text, values, order, limits):
        self.path = pathlib.Path(folder) / "file.toml"
        self.path.write_text(text, encoding="utf-8")
        self.values, self.order, self.limits = values, order, limits

    def run(self, command, *more, values=True):
        arguments = [PROGRAM, command, str(self.path), *more]
        if values:
            for name, value in self.values.items():
                arguments += ["--set", f"{name}={value}"]
        for name, value in self.limits.items():
            arguments += ["--" + name.replace("_", "-"), str(value)]
        return subprocess.run(arguments, capture_output=True, text=True, check=False)

    def check(self):
        ran = self.run("check", "--order", str(self.order), "--format", "json")
        result, = json.loads(ran.stdout)["results"]
        return result["verdict"], result["integrals_class"], ran.returncode

    def python(self):
        report = kovacic.check(self.path, set=self.values, order=self.order, **self.limits)
        verdict = report.verdict.name.replace("_", "-")
        return verdict, report.integrals, exit_of(verdict)

    def report(self):
        ran = self.run("report", "--order", str(self.order), "--format", "json")
        node = json.loads(ran.stdout)["nodes"][0]
        return node["verdict"], node["integrals_class"], ran.returncode

    def test(self, verdict):
        """What `test` finds where this verdict is expected."""
        where = ", ".join(f'{name} = "{value}"' for name, value in self.values.items())
        text = self.path.read_text(encoding="utf-8")
        self.path.write_text(f'{text}\n[[expect]]\nwhere = {{{where}}}\nverdict = "{verdict}"\n', encoding="utf-8")
        ran = self.run("test", "--order", str(self.order), values=False)
        self.path.write_text(text, encoding="utf-8")
        return ran

    def classify(self):
        ran = self.run("classify", "--only-file", "--order", str(self.order), "--format", "json")
        return json.loads(ran.stdout)["status"] if ran.stdout else None


class FourDoors(unittest.TestCase):
    def test_each_rule(self):
        for name, file in FILES.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                doors = Doors(folder, *file)
                check = doors.check()
                different = KNOWN_DIFFERENCES.get(name, ())
                self.assertEqual(doors.python(), check)
                if "report" not in different:
                    self.assertEqual(doors.report(), check)
                if check[0] == "non-integrable" and "classify" not in different:
                    self.assertEqual(doors.classify(), "non-integrable")

    def test_expectations(self):
        for name in ("one curve decides", "no obstruction", "it depends on the parameters",
                     "order 3 where the first passes", "eigenvalues"):
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                doors = Doors(folder, *FILES[name])
                verdict, _, _ = doors.check()
                self.assertEqual(doors.test(verdict).returncode, 0)
                other = "depends" if verdict != "depends" else "undecided"
                ran = doors.test(other)
                self.assertEqual(ran.returncode, 1)
                self.assertTrue(re.search(f"found .*{verdict}", ran.stdout), ran.stdout)


if __name__ == "__main__":
    unittest.main()
