#!/usr/bin/env python3
"""The Python checker of certificates of higher variational equations: accepts those of the solver, refuses what
false/jets.jsonl makes of them and whatever is hostile, and agrees with the C++ checker on changed ones and on what is stated.

A line of jets.jsonl is {"of": name, "at": path, "value": what is put there, "rule": of the C++ checker, "why"};
without a rule the change is true.

usage: jets_python_test.py KOVACIC TEST_CERTIFY"""
import glob
import json
import os
import random
import subprocess
import sys
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import kovacic_verify as V  # noqa: E402
import tamper  # noqa: E402
import traps  # noqa: E402

KOVACIC, TEST_CERTIFY = sys.argv[1:3]
PATHS = sorted(glob.glob(os.path.join(HERE, "data/jets/*.json")))


def genuine(name):
    return json.loads(traps.read("data/jets", name + ".json"))


def verdict(text):
    """a accepted, r rejected, m malformed"""
    try:
        V.check(text)
        return "a"
    except V.Rejected:
        return "r"
    except V.Malformed:
        return "m"


class Jets(unittest.TestCase):
    def test_accepts_those_of_the_solver_and_states_the_same(self):
        self.assertGreaterEqual(len(PATHS), 8)
        for path in PATHS:
            with self.subTest(os.path.basename(path)), open(path, encoding="utf-8") as f:
                trusted, summary, lines = V.check(f.read())
                self.assertEqual(trusted, 0)
                theirs = subprocess.run([KOVACIC, "verify", path], capture_output=True, text=True, check=True).stdout
                self.assertEqual(theirs.splitlines()[1:], ["  " + x for x in lines])
                self.assertIn(f"accepted ({summary}", theirs)

    def test_refuses_the_false_ones(self):
        for line in map(json.loads, traps.read("false/jets.jsonl").splitlines()):
            with self.subTest(line):
                text = json.dumps(traps.changed(genuine(line["of"]), line["at"], line["value"]))
                self.assertEqual(verdict(text), {"malformed": "m", "": "a"}.get(line["rule"], "r"))

    def test_agrees_with_the_judge_on_changed_ones(self):
        random.seed(20261122)
        texts = []
        for path in PATHS:
            top = genuine(os.path.basename(path)[:-5])
            todo = list(tamper.mutations(top, (), ""))
            texts += [json.dumps(tamper.apply(top, *change)) for change in random.sample(todo, min(15, len(todo)))]
        theirs = traps.judged(TEST_CERTIFY, texts)
        self.assertEqual(len(theirs), len(texts))
        for text, letter in zip(texts, theirs):
            self.assertEqual(verdict(text) == "a", letter == "a", text[:2000])

    def test_says_which_momentum_belongs_to_which_coordinate(self):
        """With two masses another order of the momenta is another system"""
        one = genuine("three_degrees")
        momenta = one["system"]["momenta"]
        text = json.dumps(traps.changed(one, ["system", "momenta"], [momenta[1], momenta[0], momenta[2]]))
        self.assertEqual(verdict(text), "a")
        lines = [V.check(x)[2] for x in (json.dumps(one), text)]
        self.assertTrue(lines[0][1].startswith("  {q1, p1} = 1, {q2, p2} = 1, {q3, p3} = 1, H = "), lines[0][1])
        self.assertTrue(lines[1][1].startswith("  {q1, p2} = 1, {q2, p1} = 1, {q3, p3} = 1, H = "), lines[1][1])

    def test_long_series(self):
        """Many products of short elements are work, too"""
        one = genuine("henon_heiles_n3")

        def dense(low, f):
            return {"low": low, "terms": [f(i) for i in range(2000)]}

        def form(j):
            return " + ".join(f"c1^{k}*c2^{j - k}" for k in range(j + 1))

        texts = [json.dumps(traps.changed(one, ["place", "solution"],
                                          dense("-2", lambda i: ["1", "e"][i == 6] if i in (0, 6) else f"A^{i % 9}*B^{i % 7} + e"))),
                 json.dumps(traps.changed(one, ["jets"], one["jets"] | {"order": "12"} | dict.fromkeys(
                     ("across", "along"), [dense("-30", lambda i, j=j: form(j)) for j in range(2, 12)])))]
        for text in texts:
            start = time.process_time()
            self.assertEqual(verdict(text), "r")
            self.assertLess(time.process_time() - start, 30, text[:300])
        start = time.time()
        self.assertEqual(traps.judged(TEST_CERTIFY, texts), ["r"] * 2)
        self.assertLess(time.time() - start, 20)

    def test_hostile_texts(self):
        one, texts = genuine("henon_heiles_n4"), []
        for path in (["system"], ["line"], ["place"], ["jets"], ["obstruction"], ["group"], ["constants"], ["denominators"],
                     ["place", "solution"], ["place", "normal"], ["jets", "across"], ["jets", "form"], ["line", "start"],
                     ["line", "across", 0], ["obstruction", "columns"], ["group", "first"], ["place", "time_scale"],
                     ["system", "hamiltonian"], ["place", "solution", "terms", 3]):
            for value in (None, 1, "x", "", [], {}, [[]], True, "9" * 10**6, {"a": "1"}, [None], [{}], [["x"]], ["e", "9" * 10**5],
                          "c1^9999", "e^9999", "q1^9999*p1^2 + p2^2 + A^999*q2^40", "A" + " + B" * 25000, ["1", "1"] + ["1000"] * 500):
                top = traps.changed(one, path, value)
                if top != one:
                    texts.append(json.dumps(top))
        for text in texts:
            start = time.process_time()
            self.assertIn(verdict(text), "rm", text[:300])
            self.assertLess(time.process_time() - start, 30, text[:300])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
