#!/usr/bin/env python3
"""verify --explain and --needs: both judges print the same steps, and the same needs but for their own lines.

usage: explain_test.py KOVACIC"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
KOVACIC = str(pathlib.Path(sys.argv.pop(1)).resolve())
VERIFY = HERE.parents[1] / "tools/verify/kovacic_verify.py"
FLAGS = ["--explain", "--needs"]


def printed(command, files):
    done = subprocess.run([*command, *FLAGS, *map(str, files)], capture_output=True, text=True, check=True)
    return [line for line in done.stdout.splitlines() if line.startswith("  ")]


def json_of(file, *flags):
    done = subprocess.run([KOVACIC, "verify", "--format", "json", *flags, str(file)], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


class Explained(unittest.TestCase):
    def compare(self, files):
        ours, others = printed([KOVACIC, "verify"], files), printed([sys.executable, str(VERIFY)], files)
        self.assertEqual(*([x for x in lines if not x.startswith("  judge ")] for lines in (ours, others)))
        for lines in (ours, others):
            for label in ("judge", "rules", "literature", "on trust", "limits"):
                self.assertEqual(sum(x.startswith(f"  {label:<12}") for x in lines), len(files))
        return ours

    def test_equations(self):
        self.compare(sorted((HERE / "data").glob("*.json")))

    def test_higher_orders(self):
        self.compare(sorted((HERE / "data/jets").glob("*.json"))[:4])

    def test_theorems(self):
        lines = self.compare(sorted((HERE / "false/theorem").glob("*.tru*.json")))
        self.assertTrue(any("as in" in x for x in lines))

    def test_strata_and_loops(self):
        with tempfile.TemporaryDirectory() as folder:
            def made(name, *command):
                subprocess.run([KOVACIC, *command, "--certificate", f"{folder}/{name}"], check=True, capture_output=True)
                return f"{folder}/{name}"
            files = [made("poles.json", "solve", "-r", "a/(z^3-z)", "--parameter", "a"),
                     made("bessel.json", "solve", "-r", "-(4*z+1-nu^2)/(4*z^2)", "--parameter", "nu"),
                     made("loops.json", "monodromy", "-r", "-3/16/z^2 + 1/z - 2/9/(z-1)^2", "--digits", "10")]
            self.assertIn("; strata_certificates.md 4: split, ", "\n".join(self.compare(files)))

    def test_nothing_is_lost_beside_it(self):
        file = HERE / "data/her-2.json"
        plain, told = json_of(file), json_of(file, *FLAGS)
        self.assertEqual(plain, {k: v for k, v in told.items() if k not in ("explain", "needs")})
        self.assertEqual(len(told["needs"]), 5)
        steps = json.loads(file.read_text(encoding="utf-8"))["steps"]
        self.assertEqual(sum(line[0] != " " for line in told["explain"]), len(steps))


if __name__ == "__main__":
    unittest.main()
