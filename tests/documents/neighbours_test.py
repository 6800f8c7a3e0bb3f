#!/usr/bin/env python3
"""What is written for other programs is right there: SymPy and Maxima run the scripts and find 0.

usage: neighbours_test.py PROGRAM        (a program that is not installed is left out)
"""

import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = sys.argv[1]
# one of each group, with square roots, I, exponential integrals, and the factor of a given equation
EQUATIONS = [["-r", r] for r in ("z^2 + 3", "1/z - 3/(16*z^2)", "-3/(16*z^2)", "2/z^2", "1", "-2", "I", "z", "0", "-5/(36*z^2)",
                                 "(z^4 + 4*z^3 - z^2 - 2*z + 1/4)/z^4", "-3/(16*z^2) - 2/(9*(z-1)^2) + 3/(16*z*(z-1))")]
EQUATIONS += [["-e", e] for e in ("z^2*y'' + z*y' + (z^2 - 1/4)*y = 0", "x*y'' + y' = 0", "y'' + 2*y' + y = 0")]
# names that scripts use themselves, or that the programs have
RENAMED = [["-e", "y'' = (2/r^2+1)*y", "--variable", "r"], ["-e", "u'' = (2/y^2+1)*u", "--variable", "y"], ["-r", "2/N^2 + 4", "--variable", "N"],
           ["-r", "1/lambda - 3/(16*lambda^2)", "--variable", "lambda"], ["-r", "y1^2 + 1", "--variable", "y1"],
           ["-r", "1/w - 3/(16*w^2)", "--variable", "w"], ["-e", "E*y'' + y' = 0", "--variable", "E"]]


def said(*command, text=None):
    return subprocess.run(command, input=text, capture_output=True, encoding="utf-8", timeout=250)


def exported(program, arguments):
    return said(PROGRAM, "solve", *arguments, "--format", program).stdout


class Neighbours(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("sympy"), "needs SymPy")
    def test_sympy(self):
        scripts = [exported("sympy", arguments) for arguments in EQUATIONS + RENAMED]
        self.all_zero(said(sys.executable, "-", text="\n".join(scripts)), "\n".join(scripts).count("# 0\n"))

    @unittest.skipUnless(shutil.which("maxima"), "needs Maxima")
    def test_maxima(self):
        scripts = ["kill(all)$ display2d : false$\n" + exported("maxima", arguments) for arguments in EQUATIONS + RENAMED]
        text = re.sub(r"^(ratsimp.*);  /\* 0 \*/$", r'print("left", \1)$', "\n".join(scripts), flags=re.M)
        with tempfile.TemporaryDirectory() as directory:
            path = pathlib.Path(directory, "script.mac")
            path.write_text(text, encoding="utf-8")
            done = said("maxima", "--very-quiet", f'--batch-string=batchload("{path}")$', text="")
        left = re.findall(r"^left (.*?)\s*$", done.stdout, re.M)
        self.assertEqual(len(left), text.count('print('), done.stdout)
        self.assertEqual(set(left), {"0"}, done.stdout)

    def test_sage(self):
        for arguments in EQUATIONS + RENAMED:
            compile(exported("sage", arguments).replace(".gen()", ""), "sage", "exec")

    @unittest.skipUnless(importlib.util.find_spec("sympy"), "needs SymPy")
    def test_certificates(self):
        with tempfile.TemporaryDirectory() as directory:
            for number, arguments in enumerate(EQUATIONS[:7]):
                path = f"{directory}/{number}.json"
                said(PROGRAM, "solve", "-q", *arguments, "--certificate", path)
                script = said(sys.executable, str(ROOT / "tools/export_certificate.py"), "--to", "sympy", path)
                self.assertEqual(script.returncode, 0, script.stderr)
                self.all_zero(said(sys.executable, "-", text=script.stdout), script.stdout.count("# 0\n"))

    @unittest.skipUnless(importlib.util.find_spec("sympy"), "needs SymPy")
    def test_there_and_back(self):
        """What SymPy prints for an equation is read as this equation."""
        for arguments in (x for x in EQUATIONS if x[0] == "-r" and x[1] != "0"):
            script = exported("sympy", arguments) + "\nprint(equation)\nprint(Eq(z*equation.lhs, z*equation.rhs))"
            for line in said(sys.executable, "-", text=script).stdout.splitlines()[-2:]:
                answers = [said(PROGRAM, "solve", *x, "--format", "json").stdout for x in (arguments, ["-e", line])]
                groups = [re.search(r'"group": (\{.*?\}|null)', answer, re.S) for answer in answers]
                self.assertIsNotNone(groups[1], line)
                self.assertEqual(groups[0].group(), groups[1].group(), line)

    def all_zero(self, done, count):
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.split(), ["0"] * count, done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
