#!/usr/bin/env python3
"""The Python checker of certificates over strata: accepts the genuine ones in data/strata, one or more for each node,
leaf and theorem, and refuses what false/strata.jsonl makes of them and whatever is hostile.

A line of strata.jsonl is {"of": name, "at": path, "value": what is put there, "why"}; without "value" the entry is
taken out.

usage: strata_python_test.py KOVACIC TEST_CERTIFY     (the two programs; run by ctest)
"""
import copy
import json
import os
import random
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import certificate_format  # noqa: E402
import kovacic_verify as V  # noqa: E402
import multivariate as M  # noqa: E402
import tamper  # noqa: E402
import traps  # noqa: E402

KOVACIC, TEST_CERTIFY = sys.argv[1:3]
LEMMAS = {"lemma2": "1 stratum: 1 not abelian; ", "lemma3": "4 strata: 1 abelian, 3 not abelian; ",
          "gravity": "6 strata: 6 not abelian; ", "remark_n": "6 strata: 6 not abelian; ",
          "remark_k": "11 strata: 1 abelian, 10 not abelian; ", "euler_manifold": "1 stratum: 1 abelian; ",
          "lagrange_manifold": "18 strata: 18 abelian; "}
DATA = os.path.join(HERE, "data/strata")
SUMMARIES = {"one_open_log": "2 strata: 1 abelian, 1 not abelian; ",
             "outside": "3 strata: 1 not abelian, 2 undecided; ", "torus_log": "2 strata: 1 abelian, 1 not abelian; ",
             "lemmas": "1 stratum: 1 not abelian; "}


def genuine(name):
    with open(os.path.join(DATA, name + ".json"), encoding="utf-8") as f:
        return json.load(f)


def verdict(text):
    """a accepted, r rejected, m malformed"""
    try:
        V.check(text)
        return "a"
    except V.Rejected:
        return "r"
    except V.Malformed:
        return "m"


class Strata(unittest.TestCase):
    def test_accepts_the_genuine_ones(self):
        for name in sorted(x[:-5] for x in os.listdir(DATA)):
            with self.subTest(name):
                trusted, summary, _ = V.check(json.dumps(genuine(name)))
                self.assertEqual(trusted, 2 if name == "trusted" else 0)
                self.assertEqual(summary, SUMMARIES.get(name, summary))

    def test_refuses_the_false_ones(self):
        with open(os.path.join(HERE, "false/strata.jsonl"), encoding="utf-8") as f:
            for line in map(json.loads, f):
                with self.subTest(line):
                    value = [line["value"]] if "value" in line else []
                    self.assertIn(verdict(json.dumps(traps.changed(genuine(line["of"]), line["at"], *value))), "rm")

    def test_the_lemmas(self):
        for name, summary in LEMMAS.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as out:
                case = os.path.join(HERE, f"../../cases/sliding_top/{name}.toml")
                subprocess.run([KOVACIC, "check", case, "--certificate", out], stdout=subprocess.DEVNULL, check=False)
                start, found = time.process_time(), []
                for entry in os.scandir(out):
                    with open(entry.path, encoding="utf-8") as f:
                        found.append(V.check(json.dumps(json.load(f)["equation"]["certificate"]))[:2])
                self.assertIn((0, summary), found)
                self.assertLess(time.process_time() - start, 10)

    def test_agrees_with_the_judge_on_changed_ones(self):
        random.seed(20261121)
        texts = []
        for name in sorted(x[:-5] for x in os.listdir(DATA)):
            top = genuine(name)
            todo = list(tamper.mutations(top, (), ""))
            texts += [json.dumps(tamper.apply(top, *change)) for change in random.sample(todo, min(12, len(todo)))]
        theirs = traps.judged(TEST_CERTIFY, texts)
        self.assertEqual(len(theirs), len(texts))
        for text, letter in zip(texts, theirs):
            self.assertEqual(verdict(text) == "a", letter == "a", text[:2000])

    def test_agrees_with_the_judge_on_what_its_tests_put_together(self):
        texts = traps.of_the_judge(TEST_CERTIFY)
        self.assertGreater(len(texts), 200)
        for name, text, right in texts:
            self.assertEqual(verdict(text) == "a", right, text[:2000])

    def test_strict_refuses_trusted_steps(self):
        path = os.path.join(DATA, "trusted.json")
        self.assertEqual(V.judge(path, False)[:2], (0, "accepted (2 strata: 1 abelian, 1 not abelian; 2 trusted steps)"))
        self.assertEqual(V.judge(path, True)[0], 1)

    def test_hostile_texts(self):
        one, texts, tree = genuine("one_open_log"), [], {"node": "open", "reason": "x"}
        for key in one:
            for value in (None, 1, "x", "", [], {}, [[]], True, "9" * 10**6, {"a": "1"}, [None], [{}], [["x"]],
                          {"node": []}):
                if value != one[key] and (key, value) != ("real", []):      # these are genuine
                    texts.append(traps.changed(one, [key], value))
        for path in ("tree p", "tree nonzero infinity chi 0", "tree nonzero places 0 q", "tree zero r num", "r num"):
            for value in (None, 1, [], "", "z^", "z^99999", "9" * 20000, "z + ", "+z", "z  + 1", "z*", "2*2*z", "z^-1",
                          "z^1.5", " + ".join(["z"] * 50000), "(z)", "--z", "Z", "z\n", "\u0661*z", "z^9999",
                          "9" * 9999 + "*z^9999"):
                texts.append(traps.changed(one, path.split(), value))
        for path in ("tree nonzero places 0 order", "tree zero then m", "tree zero then places 0 e",
                     "tree nonzero infinity bound"):
            for value in ("-1", "0", "1/0", "1" + "0" * 30, "9" * 100000, "1e9", "x", None, []):
                texts.append(traps.changed(one, path.split(), value))
        for term in ([], [[]], ["1"], [["1", ["square", "a", "9" * 50]]], [["1", ["square", "2", "9999"]] * 999],
                     [["0"]], [["1", "a"]], [["1", ["square", "a", "9999"], ["square", "a - 1", "9999"]]],
                     [["1", ["condition", "-1", "1"]]], [["1", ["condition", "9" * 99, "1"]]], [["1/2", []]], [[None]],
                     [["1", [[], {}, 1]]]):
            texts.append(traps.changed(one, ["tree"], {"node": "empty", "terms": term}))
        for _ in range(100):
            tree = {"node": "lemmas", "lemmas": [], "then": tree}
        deep = texts + [traps.changed(one, ["tree"], tree), traps.changed(one, ["parameters"], [f"a{i}" for i in range(13)])]
        for x in map(json.dumps, deep):
            start = time.process_time()
            self.assertIn(verdict(x), "rm", x[:300])
            self.assertLess(time.process_time() - start, 20, x[:300])


class Polynomials(unittest.TestCase):
    NAMES = {"z": 0, "A": 32, "B": 64}

    def setUp(self):
        M.Work.left = 10**7

    def p(self, text):
        return M.parse(text, self.NAMES)

    def test_parse(self):
        self.assertEqual(self.p("-A*z^2 + 3*A*B - 7 - 2"), self.p("3*B*A - 9 - A*z*z"))
        self.assertFalse(self.p("0"))
        for text in ("A^", "A B", "2A", "A*2", "A**2", "x", "", "-", "A +B"):
            with self.assertRaises(certificate_format.Malformed):
                self.p(text)

    def test_no_exponent_runs_into_the_next_field(self):
        for n in (2, 100000, 2**32 // 8192):
            with self.assertRaises(certificate_format.Rejected):
                self.p("*".join(["z^8192"] * n))

    def test_division(self):
        f, g = self.p("A^2*z^3 - 2*B*z + 7*A"), self.p("3*A - B*z^2")
        self.assertEqual(M.quotient(f * g, g), f)
        self.assertIsNone(M.quotient(f * g + M.ONE, g))
        self.assertEqual(M.remove(f * g * g, g), f)
        self.assertFalse(M.pseudo_remainder(f * g, g, 0))

    def test_resultant_and_determinant(self):
        disc = M.resultant(self.p("A*z^2 + B*z + 1"), self.p("2*A*z + B"), 0)
        self.assertIsNotNone(M.quotient(disc, self.p("B^2 - 4*A")))
        self.assertFalse(M.resultant(self.p("z^2 - A^2"), self.p("z^3*B - z^2*A*B"), 0))
        rows = [[self.p(x) for x in row] for row in (("0", "A", "1"), ("1", "B", "A"), ("B", "1", "0"))]
        self.assertEqual(M.determinant(rows), self.p("A^2*B + 1 - B^2"))
        self.assertEqual(M.determinant(rows[1::-1] + rows[2:]), self.p("B^2 - 1 - A^2*B"))

    def test_substitution(self):
        f = self.p("A^2*z - 2*A + B")
        self.assertEqual(f.substitute(32, self.p("B"), self.p("-z"), 3), self.p("z^3*B - 2*z*B^2 + B^4"))

    def test_the_limit(self):
        M.Work.left = 1000
        with self.assertRaises(certificate_format.Rejected):
            self.p("A + B + z + 1")**20


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
