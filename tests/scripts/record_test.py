#!/usr/bin/env python3
"""record_test.py PROGRAM: tools/record says what is lost between two records, and nothing else."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
RECORD = str(pathlib.Path(__file__).resolve().parents[2] / "tools/record")
LINE = {"question": "classify a.toml", "exit": 3, "verdict": "depends", "class": "meromorphic",
        "statement": "If the system is integrable with first integrals that are meromorphic, then a = 1 or a = 2.",
        "sets": [["a = 1", "integrable"], ["a = 2", "open"]], "work": 5, "trusted": 1,
        "proofs": [["accepted", 1, ["not integrable for a != 1, a != 2"]]], "rules": {"cover": 1, "place": 2}, "seconds": 1.0}
MORE = {"rules": {"cover": 1, "place": 3}}
CASES = [  # what the new line has, what is said ("": nothing)
    ({}, ""), ({"seconds": 100.0}, ""), ({"work": 50}, ""),
    ({"statement": "With first integrals that are meromorphic, a = 1 or a = 2."}, ""),
    ({"exit": 4}, "exit code 4"), ({"exit": 2}, "exit code 2"),
    ({"class": "rational"}, "the class is weaker"), ({"class": "meromorphic also at the ends of the curve"}, "the class is weaker"),
    ({"class": "None"}, "the class is weaker"),
    ({"sets": [["a = 1", "integrable"], ["a = 2", "open"], ["a = 3", "open"]]}, "open now"),
    ({"statement": "If the system is integrable with first integrals that are meromorphic, then a = 1, a = 2 or a = 3."}, "another statement"),
    ({"proofs": [["accepted", 1, ["not integrable for a != 1, a != 2, a != 3"]]]}, "another statement"),
    ({"proofs": []}, "a certificate"), ({"proofs": [["rejected", None, None]]}, "a certificate"),
    ({"trusted": 2}, "more on trust"), ({"proofs": [["accepted", 2, LINE["proofs"][0][2]]]}, "more on trust"),
    ({"trusted": 0}, "stronger without a step"), ({"proofs": [["accepted", 0, LINE["proofs"][0][2]]]}, "stronger without a step"),
    ({"trusted": 0, **MORE}, ""),
    ({"sets": [["a = 1", "integrable"]], "exit": 0}, "stronger without a step"),
    ({"sets": [["a = 1", "integrable"]], "exit": 0, **MORE}, "")]


class Record(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def compared(self, old, new):
        paths = []
        for name, line in (("old", old), ("new", new)):
            paths.append(str(pathlib.Path(self.folder.name) / name))
            pathlib.Path(paths[-1]).write_text(json.dumps(line) + "\n", encoding="utf-8")
        return subprocess.run([RECORD, "--compare", *paths], capture_output=True, text=True)

    def test_what_is_lost(self):
        for change, said in CASES:
            with self.subTest(change=change):
                ran = self.compared(LINE, {**LINE, **change})
                self.assertEqual((ran.returncode, ran.stderr), (1 if said else 0, ""), ran.stdout)
                self.assertIn(said, ran.stdout)

    def test_verdicts(self):
        decided = {**LINE, "exit": 0, "verdict": "no SL2", "sets": [], "class": "None"}
        for change, said in (({"verdict": "yes Gm"}, "another verdict"), ({"verdict": "undecided None", "exit": 3}, "it was decided"),
                             ({"verdict": "None", "exit": 4}, "it was decided"), ({}, "")):
            with self.subTest(change=change):
                ran = self.compared(decided, {**decided, **change})
                self.assertEqual(ran.returncode, 1 if said else 0)
                self.assertIn(said, ran.stdout)

    def test_the_same_program_loses_nothing(self):
        files = [str(pathlib.Path(self.folder.name) / name) for name in ("one", "two")]
        for file in files:
            subprocess.run([RECORD, file, "--program", PROGRAM, "--only", "classify/ramani", "-j", "1"], check=True)
        read = [json.loads(line) for line in pathlib.Path(files[0]).read_text().splitlines()]
        self.assertEqual([(x["verdict"], x["exit"]) for x in read], [("integrable", 0)] * 2)
        self.assertEqual(read[1]["proofs"][0][:2], ["accepted", 0])
        self.assertEqual(subprocess.run([RECORD, "--compare", *files], capture_output=True).returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
