#!/usr/bin/env python3
"""The Python checker: accepts what is genuine, refuses what is false or hostile, and agrees with the C++ judge.

usage: python_test.py KOVACIC TEST_CERTIFY     (the two programs; run by ctest)
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile
import time
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import adversary  # noqa: E402
import kovacic_verify as V  # noqa: E402
import tamper  # noqa: E402
import traps  # noqa: E402

KOVACIC, TEST_CERTIFY = sys.argv[1:3]
GROUPS = {"B": ("Borel", None), "Ga": ("T", "1"), "D": ("Gm", None), "trivial": ("cyclic", "1")}


# As for the random rounds of C++ (tests/support/random.hpp).
SEED, ROUNDS = int(os.environ.get("KOV_RANDOM_SEED") or 1), int(os.environ.get("KOV_RANDOM_ROUNDS") or 1)


def moved(entry, choose):
    """The equation of u(z) = y(c z + d)"""
    c, d = (Fraction(choose.choice([-1, 1]) * choose.randint(1, 30), choose.randint(1, 12)) for _ in range(2))
    c *= choose.choice([1, 1, 1, Fraction(1, 30030), 30030, 10**18 + 3])
    there = f"(({c})*z+({d}))"
    same = {k: entry[k] for k in ("id", "minpoly") if k in entry}
    return same | {k: f"({c})^{n}*({re.sub('[a-z]+', lambda m: there if m[0] == 'z' else m[0], entry[k])})"
                   for k, n in (("r", 2), ("p", 1), ("q", 2)) if k in entry}


def lame_one(choose, i):
    """An infinite dihedral group, or an additive one"""
    f = "*".join(f"(z-({x}))" for x in choose.sample(range(-12, 13), 3))
    p = "+".join(f"1/(2*(z-({x})))" for x in re.findall(r"z-\((-?\d+)\)", f))
    return {"id": f"lame-{i}", "p": p, "q": f"-(2*z+({choose.randint(-20, 20)}))/(4*{f})"}


def files(folder):
    directory = os.path.join(HERE, folder)
    return [os.path.join(directory, x) for x in sorted(os.listdir(directory)) if x.endswith(".json")]


def text(path):
    with open(path, encoding="utf-8") as f:
        return f.read()


def verdict(certificate):
    """a accepted, r rejected, m malformed"""
    try:
        V.check(certificate)
        return "a"
    except V.Rejected:
        return "r"
    except V.Malformed:
        return "m"


def group(name):
    """(group, n) of a certificate for the word that the corpus uses"""
    if name in GROUPS:
        return GROUPS[name]
    kind, _, n = name.partition("_")
    return {"C": "cyclic"}.get(kind, kind), None if n in ("", "SL2") else n


class Checker(unittest.TestCase):
    def test_both_say_the_same_of_what_is_malformed(self):
        rows = list(traps.lines_of("false/verdicts.jsonl"))
        texts = [text for _, text, _ in traps.changes(rows)]
        for row, text, letter in zip(rows, texts, traps.judged(TEST_CERTIFY, texts)):
            with self.subTest(row["why"]):
                self.assertEqual((verdict(text), letter), (row["is"],) * 2)

    def test_quotes_the_texts_of_others(self):
        for given, shown in (('x"y', '"x\'y"'), ("a\nb\x1b[2J", '"a?b?[2J"'), ("\u00e9\u2028\U0001F600.", '"???."')):
            top = json.loads(text(os.path.join(HERE, "data/strata/open.json")))
            top["tree"], top["claim"] = {"node": "open", "reason": given}, {"abelian": None}
            with tempfile.NamedTemporaryFile("w", suffix=".json") as f:
                json.dump(top, f)
                f.flush()
                said = subprocess.run([KOVACIC, "verify", f.name], text=True, stdout=subprocess.PIPE, check=False).stdout
            self.assertIn(f"always: undecided ({shown})\n", said)
            self.assertEqual(V.check(json.dumps(top))[2][-1], f"  always: undecided ({shown})")

    def test_accepts_whatever_the_solver_writes(self):
        for corpus in ("public", "pitfalls"):
            source = os.path.join(HERE, f"../corpus/{corpus}.jsonl")
            entries = [e for e in map(json.loads, text(source).splitlines()) if not e.get("parameters")]
            with tempfile.TemporaryDirectory() as out:
                command = [KOVACIC, "solve", "--batch", "-", "--certificate", out]
                lines = "\n".join(json.dumps({k: e[k] for k in ("id", "r", "p", "q", "minpoly") if k in e}) for e in entries)
                subprocess.run(command, input=lines, text=True, stdout=subprocess.DEVNULL, check=True)
                for e in entries:
                    with self.subTest(e["id"]):
                        certificate = text(os.path.join(out, e["id"] + ".json"))
                        self.assertEqual(V.check(certificate)[0], 0)
                        claim, expected = json.loads(certificate)["claim"], e["expected"]
                        self.assertEqual((claim["group"], claim["n"]), group(expected["group"]))
                        self.assertEqual(claim["abelian"], expected["identity_component_abelian"])

    def test_accepts_what_is_moved(self):
        """z -> c z + d: the same group, and a certificate that is accepted; both corpora, and Lame's equation with n = 1"""
        for seed in range(SEED, SEED + ROUNDS):
            choose, entries = random.Random(seed), []
            for corpus in ("public", "pitfalls"):
                entries += [e for e in map(json.loads, text(os.path.join(HERE, f"../corpus/{corpus}.jsonl")).splitlines())
                            if not e.get("parameters")]
            entries = choose.sample(entries, 60) + [lame_one(choose, i) for i in range(20)]
            with tempfile.TemporaryDirectory() as out:
                lines = "\n".join(json.dumps(moved(e, choose)) for e in entries)
                subprocess.run([KOVACIC, "solve", "--batch", "-", "--certificate", out], input=lines, text=True, stdout=subprocess.DEVNULL,
                               check=True)
                for e in entries:
                    with self.subTest(f"KOV_RANDOM_SEED={seed}: {e['id']}"):
                        certificate = text(os.path.join(out, e["id"] + ".json"))
                        self.assertEqual(V.check(certificate)[0], 0)
                        claim, expected = json.loads(certificate)["claim"], e.get("expected")
                        if expected:
                            self.assertEqual((claim["group"], claim["n"]), group(expected["group"]))

    def test_mechanics_adds_trusted_steps(self):
        with tempfile.TemporaryDirectory() as out:
            case = os.path.join(HERE, "../../cases/sliding_top/lemma3.toml")
            subprocess.run([KOVACIC, "check", case, "--certificate", out], stdout=subprocess.DEVNULL, check=True)
            self.assertGreater(len(os.listdir(out)), 3)
            for name in os.listdir(out):
                certificate = text(os.path.join(out, name))
                if json.loads(certificate)["format"] != "kovacic-certificate/1":
                    continue                # strata_python_test.py
                not_abelian = not json.loads(certificate)["claim"]["abelian"]
                self.assertEqual(V.check(certificate)[0], 2 if not_abelian else 1)
                self.assertEqual(V.judge(os.path.join(out, name), True)[0], 1)

    def test_agrees_with_the_judge_on_changed_ones(self):
        random.seed(20261121)
        changed = []
        for path in files("data"):
            top = json.loads(text(path))
            todo = list(tamper.mutations(top, (), ""))
            for path, kind, value in random.sample(todo, min(25, len(todo))):
                changed.append(json.dumps(tamper.apply(top, path, kind, value)))
        ours, theirs = [verdict(x) for x in changed], traps.judged(TEST_CERTIFY, changed)
        for a, b, certificate in zip(ours, theirs, changed, strict=True):
            self.assertEqual(a == "a", b == "a", certificate[:2000])

    def test_nothing_is_trusted_of_one_equation(self):
        for path in files("data"):
            with self.subTest(path):
                self.assertEqual(V.check(text(path))[0], 0)

    def test_both_judge_all_traps(self):
        """What tests/certify makes of certificates: both accept what is right and nothing else, and state the same of it."""
        names, texts, right = zip(*traps.certificates())
        stated = {}
        for name, certificate, letter, expected in zip(names, texts, traps.judged(TEST_CERTIFY, texts), right, strict=True):
            with self.subTest(name):
                try:
                    stated[certificate] = V.check(certificate)
                except (V.Malformed, V.Rejected):
                    pass
                self.assertEqual([letter == "a", certificate in stated], [expected] * 2)
        with tempfile.TemporaryDirectory() as folder:
            paths = {certificate: os.path.join(folder, f"{i}.json") for i, certificate in enumerate(stated)}
            for certificate, path in paths.items():
                with open(path, "w", encoding="utf-8") as f:
                    f.write(certificate)
            said = subprocess.run([KOVACIC, "verify", *paths.values()], text=True, stdout=subprocess.PIPE, check=True)
            said = said.stdout.splitlines()
            start = {x.partition(": ")[0]: i for i, x in enumerate(said)}
            for certificate, (trusted, _, lines) in stated.items():
                at = start[paths[certificate]]
                with self.subTest(said[at]):
                    self.assertIn(f"{trusted} trusted step", said[at])
                    self.assertEqual(["  " + x for x in lines], said[at + 1:at + len(lines) + 1])

    def test_an_adversary_convinces_nobody(self):
        names, texts = random.Random(20261122).sample([x[:-5] for x in traps.names("data")], 12), []
        for name, *step, _ in adversary.steps(names):
            texts.append(json.dumps(traps.with_step(json.loads(traps.read("data", name + ".json")), *step)))
        self.assertGreater(len(texts), 500)
        self.assertNotIn("a", traps.judged(TEST_CERTIFY, texts))
        for certificate in random.sample(texts, 300):
            self.assertNotEqual(verdict(certificate), "a", certificate[:2000])

    def test_a_refusal_is_one_line_of_both(self):
        one, tree = (json.loads(text(os.path.join(HERE, "data", x))) for x in ("airy-naive.json", "strata/number_zero.json"))
        evil = "x\n/other.json: accepted (0 trusted steps)\r\x1b[2J\ud800"
        changed = [one | {evil: "1"}, one | {"format": evil}, one | {"field": {"name": "a", "minpoly": ["0", evil]}},
                   traps.changed(one, ["steps", "0", "id"], evil), traps.changed(one, ["steps", "0", "rule"], evil),
                   traps.changed(one, ["steps", "0", "premises"], [evil]), traps.changed(one, ["steps", "0", "data"], {evil: "1"}),
                   traps.changed(tree, ["tree", "zero", "variable"], evil), traps.changed(tree, ["tree", "node"], evil),
                   traps.changed(tree, ["tree", "p"], evil), traps.changed(tree, ["parameters"], [evil]),
                   traps.changed(tree, ["tree", "p"], "a^-1"), traps.changed(tree, ["r", "num"], "9" * 10**6),
                   traps.changed(one, ["r", "num"], ["1" + "0" * 10**6]), traps.changed(one, ["r", "num"], [1]),
                   traps.changed(one, ["r", "num"], "1"), traps.changed(one, ["r"], None)]
        hostile = [json.dumps(x).encode() for x in changed]
        hostile += [b"", b"NaN", b"\xff", b"\xef\xbb\xbf{}", b"[" * 10**6, b'{"a":' * 10**6, b'{"a":"b","a":"b"}', b'"\\ud800"',
                    b'{"format":"kovacic-strata/1"}', b'{"format":["kovacic-strata/1"]}', b"\0", b"1" * 10**6]
        python = [sys.executable, os.path.join(HERE, "../../tools/verify/kovacic_verify.py")]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "text.json")
            for content in hostile:
                with open(path, "wb") as f:
                    f.write(content)
                for command in (python, [KOVACIC, "verify"]):
                    with self.subTest(command=command[-1], content=content[:300]):
                        said = subprocess.run([*command, path], capture_output=True, check=False)
                        self.assertIn(said.returncode, (1, 2))
                        self.assertEqual(said.stderr, b"")
                        self.assertTrue(said.stdout.endswith(b"\n"))
                        self.assertTrue(said.stdout[:-1].decode().isprintable(), said.stdout[:500])

    def test_a_reader_may_stop(self):
        path = os.path.join(HERE, "data", "airy-naive.json")
        script = os.path.join(HERE, "../../tools/verify/kovacic_verify.py")
        with subprocess.Popen([sys.executable, script, *[path] * 3000], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            self.assertIn(b"accepted", run.stdout.readline())
            run.stdout.close()
            self.assertEqual(run.stderr.read(), b"")

    def test_hostile_texts(self):
        one = json.loads(text(os.path.join(HERE, "data", sorted(os.listdir(os.path.join(HERE, "data")))[0])))
        texts = ["", "{", "NaN", "1", "[" * 10**6, '{"a":' * 10**6, '"' + "x" * 10**7, '{"a":"b","a":"b"}', "\ud800", "null"]
        for key in ("format", "field", "r", "claim", "steps"):
            for value in (None, 1, 1.5, "x", [], {}, [[]], True, "9" * 10**6, {"a": "1"}, [None]):
                texts.append(json.dumps(one | {key: value}))
        texts.append(json.dumps(one | {"r": {"num": [f"1/{10**9 + 7 + 2 * i}" for i in range(60000)], "den": ["1"]}}))
        texts.append(json.dumps(one | {"field": {"name": "a", "minpoly": ["7" * 150000] * 24 + ["1"]}}))
        for x in texts:
            start = time.process_time()
            self.assertIn(verdict(x), "rm", x[:200])
            self.assertLess(time.process_time() - start, 10, x[:200])


class Parts(unittest.TestCase):
    def test_properties(self):
        for name, holds, _ in traps.properties():
            with self.subTest(name):
                self.assertTrue(holds(sys.modules))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
