#!/usr/bin/env python3
"""Random families with assumptions: both checkers accept what the program claims, state the same, and state all that
was assumed; they refuse a changed claim; and the statement is true at points, by the solver without parameters.

usage: families_test.py KOVACIC [SEED [COUNT]]     (run by ctest; a failure prints the line that reproduces it)
"""
import copy
import itertools
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import families  # noqa: E402
import kovacic_verify as V  # noqa: E402

KOVACIC = sys.argv[1]
SEED, COUNT = (int(x) for x in (sys.argv[2:4] + ["13", "24"][len(sys.argv[2:4]):]))
GRID = [Fraction(x) for x in ("0", "1", "-1", "2", "1/2", "-1/2", "3", "1/3", "3/2", "-2", "5/2", "4")]
POINTS = 6                                  # of each family


def solve(lines, *more):
    said = subprocess.run([KOVACIC, "solve", "--batch", "-", "--timeout", "3", *more], input="\n".join(lines), text=True,
                          stdout=subprocess.PIPE, check=False).stdout
    return {x["id"]: x for x in map(json.loads, said.splitlines())}


def verdicts(paths):
    """The first word and the statement of `kovacic verify` for each file"""
    said = subprocess.run([KOVACIC, "verify", *paths], text=True, stdout=subprocess.PIPE, check=False).stdout
    found = {}
    for line in said.splitlines():
        if line.startswith("  "):
            found[path][1].append(line[2:])
        else:
            path, _, rest = line.partition(": ")
            found[path] = (rest.split(" ")[0].rstrip(":"), [])
    return found


def ours(text):
    try:
        return "accepted", V.check(text)[2]
    except V.Rejected:
        return "rejected", []
    except V.Malformed:
        return "malformed", []


def changed_claims(top):
    """The same proof, of another claim"""
    for claim in (True, False):
        if top["claim"]["abelian"] is not claim:
            yield top | {"claim": {"abelian": claim}}

    def leaves(node):
        for v in node.values():
            if isinstance(v, dict):
                yield from leaves(v)
        if node.get("node") == "leaf" or node.get("zero") == "root":
            yield node
    for i, _ in enumerate(leaves(top["tree"])):
        said = next(itertools.islice(leaves(top["tree"]), i, None))["abelian"]
        for false in {"yes": ["no"], "no": ["yes"], "where": ["yes", "no"]}[said]:
            other = copy.deepcopy(top)
            next(itertools.islice(leaves(other["tree"]), i, None))["abelian"] = false
            other["claim"]["abelian"] = None
            yield other


class At:
    """The statement at a point"""

    def __init__(self, statement, point):
        self.statement, self.point = statement, point

    def value(self, polynomial):
        return eval(re.sub(r"\b([0-9]+)\b(?!\))", r"Fraction(\1)", polynomial).replace("^", "**").replace(
            "**Fraction", "**int"), {"Fraction": Fraction, "int": int}, dict(self.point))

    def holds(self, condition):
        membership = re.fullmatch(r"\((.*)\)/\((.*)\) (not )?in Z", condition)
        if membership:
            top, bottom = map(self.value, membership.groups()[:2])
            return bool(bottom) and (Fraction(top, bottom).denominator == 1) != bool(membership[3])
        left, relation, _ = condition.rsplit(" ", 2)
        x = self.value(left)
        return {">": x > 0, ">=": x >= 0, "!=": x != 0, "=": x == 0}[relation]

    def admitted(self):
        first, *rest = self.statement
        given = first.partition(" with ")[2]
        return all(map(self.holds, given.split(", ") if given else [])) and not any(
            all(self.value(f) == 0 for f in x[13:].split(" = ")[:-1]) for x in rest
            if x.startswith("except where") and not x.endswith("for all z"))

    def equation(self):
        r = next(re.search(r"y'' = (.*) y is", x)[1] for x in self.statement if "y'' = " in x)
        for name, v in self.point.items():
            r = re.sub(rf"\b{name}\b", f"({v})", r)
        return r

    def said(self):
        """abelian, not abelian, a criterion, undecided or, at a point of no stratum, None"""
        found = []
        for line in self.statement:
            where = re.match(r"  (.*?): (abelian exactly where|abelian|not abelian|undecided|no points)", line)
            if where and (where[1] == "always" or all(map(self.holds, where[1].split(", ")))):
                found.append(where[2])
        assert len(found) <= 1, "the strata are not disjoint"
        return found[0] if found else None


class Families(unittest.TestCase):
    def setUp(self):
        self.lines = families.lines(SEED, COUNT)
        self.dir = tempfile.TemporaryDirectory()
        self.addCleanup(self.dir.cleanup)
        self.answers = solve(self.lines, "--certificate", self.dir.name)
        self.certificates = {}
        for i, answer in self.answers.items():
            if "certificate_file" in answer:
                with open(answer["certificate_file"], encoding="utf-8") as f:
                    self.certificates[i] = f.read()

    def write(self, name, text):
        path = os.path.join(self.dir.name, name)
        with open(path, "w", encoding="utf-8") as f:
            f.write(text)
        return path

    def test_claims_and_assumptions(self):
        self.assertGreater(len(self.certificates), COUNT // 4)
        theirs = verdicts([self.answers[i]["certificate_file"] for i in self.certificates])
        for i, text in self.certificates.items():
            with self.subTest(self.lines[int(i[1:])]):
                top, line, answer = json.loads(text), json.loads(self.lines[int(i[1:])]), self.answers[i]
                self.assertEqual(ours(text), theirs[answer["certificate_file"]])
                word, statement = ours(text)
                self.assertEqual(word, "accepted")
                if top["claim"]["abelian"] is not None:
                    self.assertEqual(answer["abelian"], "yes" if top["claim"]["abelian"] else "no")
                for assumed in line["assumptions"]:
                    x, _, kind = assumed.partition(" ")
                    if kind in ("rational", "integer"):
                        self.assertIn(x, re.search(r"all (.*; )?(.*) in Q", statement[0])[2].split(", "), statement[0])
                    none = sum("not an" in y or "not in" in y for y in line["assumptions"])     # or half of an odd integer
                    self.assertTrue(not none or " in Z" in statement[0], statement[0])
                    self.assertLessEqual(statement[0].count("not in Z"), none, statement[0])
                    self.assertTrue(kind != "integer" or f"({x})/(1) in Z" in statement[0], statement[0])

    def test_changed_claims_are_refused(self):
        texts = {}
        for i, text in self.certificates.items():
            for k, other in enumerate(changed_claims(json.loads(text))):
                texts[self.write(f"{i}-{k}.changed", json.dumps(other))] = json.dumps(other)
        theirs = verdicts(list(texts))
        for path, text in texts.items():
            with self.subTest(text[:2000]):
                self.assertNotEqual(ours(text)[0], "accepted")
                self.assertNotEqual(theirs[path][0], "accepted")

    def test_without_an_assumption_both_say_the_same(self):
        texts = {}
        for i, text in self.certificates.items():
            top = json.loads(text)
            for key in ("real", "rational", "assumptions", "memberships"):
                for k in range(len(top.get(key, []))):
                    other = top | {key: top[key][:k] + top[key][k + 1:]}
                    texts[self.write(f"{i}-{key}-{k}.changed", json.dumps(other))] = json.dumps(other)
        theirs = verdicts(list(texts))
        for path, text in texts.items():
            with self.subTest(text[:2000]):
                self.assertEqual(ours(text)[0] == "accepted", theirs[path][0] == "accepted")

    def test_the_statement_is_true_at_points(self):
        rng, asked = random.Random(SEED), {}
        for i, text in self.certificates.items():
            statement, xs = ours(text)[1], json.loads(self.lines[int(i[1:])])["parameters"]
            points = [dict(zip(xs, p)) for p in itertools.product(GRID, repeat=len(xs))]
            inside = [p for p in points if At(statement, p).admitted()]
            for k, p in enumerate(rng.sample(inside, min(POINTS, len(inside)))):
                at = At(statement, p)
                if at.said() in ("abelian", "not abelian", "no points"):
                    asked[f"{i}-{k}"] = at
        answers = solve([json.dumps({"id": name, "r": at.equation()}) for name, at in asked.items()])
        self.assertGreater(len(asked), COUNT // 2)
        for name, at in asked.items():
            if answers[name].get("abelian") in ("yes", "no"):
                with self.subTest(line=self.lines[int(name.split("-")[0][1:])], point=str(at.point)):
                    self.assertEqual(at.said(), {"yes": "abelian", "no": "not abelian"}[answers[name]["abelian"]])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
