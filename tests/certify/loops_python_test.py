#!/usr/bin/env python3
"""The judges of certificates of matrices of loops: both accept those of the solver and state the same, both refuse systems
whose groups are smaller, words that prove nothing and whatever is hostile, and they agree on changed certificates.

usage: loops_python_test.py KOVACIC TEST_CERTIFY"""
import copy
import glob
import itertools
import json
import os
import random
import subprocess
import sys
import time
import unittest
from fractions import Fraction as F

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import kovacic_verify as V  # noqa: E402
import tamper  # noqa: E402
import traps  # noqa: E402

KOVACIC, TEST_CERTIFY = sys.argv[1:3]
PATHS = sorted(glob.glob(os.path.join(HERE, "data/loops/*.json")))


def genuine(name):
    return json.loads(traps.read("data/loops", name + ".json"))


def verdict(top):
    """a accepted, r rejected, m malformed"""
    try:
        V.check(top if isinstance(top, str) else json.dumps(top))
        return "a"
    except V.Rejected:
        return "r"
    except V.Malformed:
        return "m"


def product(*fs):
    out = [F(1)]
    for f in fs:
        out = [sum((out[i] * f[k - i] for i in range(len(out)) if 0 <= k - i < len(f)), F(0)) for k in range(len(out) + len(f) - 1)]
    return [str(x) for x in out]


def hypergeometric(a, b, c):
    """Rows of z (1 - z) y'' + (c - (a + b + 1) z) y' - a b y = 0."""
    return [{"den": ["1"], "num": [[], ["1"]]},
            {"den": product([F(0), F(1)], [F(1), F(-1)]), "num": [[str(F(a) * F(b))] if F(a) * F(b) else [], [str(-F(c)), str(F(a) + F(b) + 1)]]}]


def words():
    short = [list(w) for n in (1, 2) for w in itertools.product("01", repeat=n)]
    return [dict(zip("ABC", x)) for x in itertools.product(short, repeat=3)]


class Loops(unittest.TestCase):
    def refused(self, tops, least=1):
        """by both"""
        texts = [json.dumps(x) for x in tops]
        self.assertGreaterEqual(len(texts), least)
        self.assertEqual({verdict(x) for x in texts} - set("rm"), set())
        self.assertEqual(set(traps.judged(TEST_CERTIFY, texts)) - set("rm"), set())

    def test_accepts_those_of_the_solver_and_states_the_same(self):
        self.assertGreaterEqual(len(PATHS), 3)
        for path in PATHS:
            with self.subTest(os.path.basename(path)), open(path, encoding="utf-8") as f:
                trusted, _, lines = V.check(f.read())
                self.assertEqual(trusted, 0)
                theirs = subprocess.run([KOVACIC, "verify", path], capture_output=True, text=True, check=True).stdout
                self.assertEqual(theirs.splitlines()[1:], ["  " + x for x in lines])

    def test_smaller_groups(self):
        """Finite, dihedral and reducible groups, with the loops around 0 and 1 of another equation"""
        one = genuine("two_singularities")
        for a, b, c in (("1/4", "-1/12", "2/3"), ("-1/24", "7/24", "3/4"), ("-1/60", "11/60", "2/3"), ("1/5", "-1/5", "1/2"),
                        ("1/7", "-1/7", "1/2"), ("0", "1/3", "1/5"), ("-2", "1/3", "1/5")):
            with self.subTest((a, b, c)):
                one["system"] = hypergeometric(a, b, c)
                random.seed(a + b + c)
                self.refused([one | {"shows": one["shows"] | x} for x in random.sample(words(), 12)])

    def test_an_equation_with_the_full_group(self):
        """A unitary one: the same loops, and no word is hyperbolic"""
        one = genuine("two_singularities")
        one["system"] = hypergeometric("-3/70", "17/70", "3/5")
        tops = [one | {"shows": one["shows"] | x} for x in words()]
        self.assertTrue(any(verdict(x) == "a" for x in tops[::3]))

    def test_words_that_prove_nothing(self):
        one = genuine("two_singularities")
        shows = one["shows"]
        self.refused([one | {"shows": shows | x} for x in
                      ({"B": shows["A"]}, {"A": shows["A"] * 2, "B": shows["A"]}, {"A": [], "B": []}, {"C": []}, {"C": ["7"]}, {"A": ["-1"]},
                       {"A": ["0"] * 13})])
        two = genuine("jordan_block")
        shows = two["shows"]
        a, b = shows["A"], shows["B"]
        n = int(a["power"])
        self.assertGreater(n, 1)
        self.refused([two | {"shows": shows | x} for x in
                      ({"B": a}, {"A": a | {"power": str(n - 1)}}, {"A": a | {"power": "1"}}, {"A": a | {"power": "0"}}, {"A": a | {"power": "1001"}},
                       {"B": b | {"word": a["word"]}}, {"row": "0"}, {"row": "6"}, {"column": "8"})])

    def test_polygons(self):
        one = genuine("two_singularities")
        tops = []
        for change in (lambda p: p.pop(), lambda p: p.insert(3, ["0", "0"]), lambda p: p.insert(3, ["1", "0"]), lambda p: p.insert(0, ["9", "9"]),
                       lambda p: p.__setitem__(4, ["1/3", "0"]), lambda p: p.clear(), lambda p: p.__setitem__(slice(1, -1), [])):
            tops.append(copy.deepcopy(one))
            change(tops[-1]["loops"][0])
        self.refused(tops)

    def test_few_bits(self):
        for name in ("hill", "jordan_block"):
            self.refused([genuine(name) | {"bits": "32"}])

    def test_blocks(self):
        one = genuine("jordan_block")
        shows = one["shows"]
        blocks = shows["blocks"]
        swapped = blocks[::-1]
        other = copy.deepcopy(blocks)
        other[0]["unknowns"] = other[0]["unknowns"][::-1]          # the equation of the other unknown
        wrong = copy.deepcopy(blocks)
        wrong[0]["factors"] = wrong[0]["factors"] + [{"q": ["0", "1"], "e": "1/2"}]
        inner = copy.deepcopy(blocks)
        inner[0]["certificate"]["claim"]["n"] = "1"
        less = copy.deepcopy(blocks)
        less[0]["certificate"]["claim"] = {"group": None, "n": None, "component": None, "abelian": True}
        without = copy.deepcopy(blocks)
        del without[0]["certificate"]
        self.refused([one | {"shows": shows | {"blocks": x}} for x in
                      (swapped, other, wrong, inner, less, without, blocks[:2], blocks + blocks[:1], [])])

    def test_agree_on_changed_ones(self):
        random.seed(20261123)
        texts = []
        for path in PATHS:
            top = genuine(os.path.basename(path)[:-5])
            todo = list(tamper.mutations(top, (), ""))
            texts += [json.dumps(tamper.apply(top, *change)) for change in random.sample(todo, min(12, len(todo)))]
        for text, letter in zip(texts, traps.judged(TEST_CERTIFY, texts), strict=True):
            self.assertEqual(verdict(text) == "a", letter == "a", text[:2000])

    def test_hostile_texts(self):
        one = genuine("two_singularities")
        texts = []
        for path in (["system"], ["loops"], ["bits"], ["shows"], ["field"], ["system", 1, "den"], ["system", 1, "num"], ["loops", 0], ["loops", 0, 3],
                     ["loops", 0, 3, 0], ["shows", "A"], ["shows", "by"]):
            for value in (None, 1, "x", "", [], {}, [[]], True, "9" * 10**5, "1/" + "2" * 10**4, {"a": "1"}, [None], [{}], [["x"]],
                          ["0"] * 10**5, [["0", "0"]] * 10**5, "not-abelian", "8193"):
                texts.append(json.dumps(traps.changed(one, path, value)))
        far = copy.deepcopy(one)
        far["loops"][0][3] = [str(2**399), "0"]
        texts += [json.dumps(far), json.dumps(one | {"bits": "8192", "loops": [one["loops"][0] * 80]})]
        for text in texts:
            start = time.process_time()
            self.assertIn(verdict(text), "rm", text[:300])
            self.assertLess(time.process_time() - start, 60, text[:300])
        self.assertEqual(set(traps.judged(TEST_CERTIFY, texts)) - set("rm"), set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
