#!/usr/bin/env python3
"""Both checkers of certificates of theorems accept what `kovacic prove` wrote, state the same, and refuse every way to cheat
of theorems.py.

usage: theorem_python_test.py KOVACIC"""
import json
import os
import subprocess
import sys
import tempfile
import time
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "../../tools/verify"), HERE]
import kovacic_verify as V  # noqa: E402
import theorems  # noqa: E402
from condition import ConditionSet  # noqa: E402
from equation import Equation  # noqa: E402
from multivariate import FIELD, Work, parse  # noqa: E402

KOVACIC = os.path.abspath(sys.argv.pop(1))


def verdict(text):
    """a accepted, r rejected, m malformed"""
    try:
        V.check(text)
        return "a"
    except V.Rejected:
        return "r"
    except V.Malformed:
        return "m"


def step_of(top):
    return next(s for s in top["steps"] if s["rule"] == "certificate")


def reports(texts):
    """Of the C++ checker, for each text"""
    with tempfile.TemporaryDirectory() as folder:
        names = []
        for i, text in enumerate(texts):
            names.append(os.path.join(folder, f"{i}.json"))
            with open(names[-1], "w", encoding="utf-8") as f:
                f.write(text)
        out = subprocess.run([KOVACIC, "verify", "--format", "json", *names], capture_output=True, text=True, check=False)
        return [json.loads(line) for line in out.stdout.splitlines()]


def on_trust(top):
    """The theorem with the symmetry, with the part to which it leads on trust"""
    top["steps"][2] = {"id": "j", "rule": "trusted", "system": "X", "says": "integrable", "step": "known",
                       "regions": [[{"p": "a", "sign": "zero"}]]}
    for leaf in (top["steps"][-1]["tree"]["zero"], top["steps"][-1]["tree"]["nonzero"]["zero"]):
        leaf["region"] = "0"
    return top


OPTIONAL = (("class", "says"), ("improper", "proper"), ("field", "coordinates"), ("hamiltonian", "field"),
            ("functions", "coordinates"), ("relations", "coordinates"), ("root", "certificate"), ("claims", "curve"), ("lagrangian", "assumptions"),
            ("complex", "assumptions"), ("region", "word"), ("square", "over"))


def with_null(top):
    """Where one more key, optional beside the other one, is null: a place for each pair"""
    seen, whole = set(), json.loads(json.dumps(top))

    def walk(v, path):
        if isinstance(v, dict):
            for new, beside in OPTIONAL:
                if beside in v and new not in v and (new, *v) not in seen:
                    seen.add((new, *v))
                    v[new] = None
                    yield f"{path}.{new}", json.dumps(whole)
                    del v[new]
        for k, x in v.items() if isinstance(v, dict) else enumerate(v) if isinstance(v, list) else ():
            yield from walk(x, f"{path}.{k}")
    yield from walk(whole, "")


class Theorems(unittest.TestCase):
    def test_accepts_what_the_solver_wrote_and_states_the_same(self):
        genuine = [json.dumps(top) for top in (theorems.HEAVY, theorems.SLIDING, *theorems.RIGHT.values())]
        for text, report in zip(genuine, reports(genuine)):
            trusted, _, lines = V.check(text)
            self.assertEqual((trusted, report["verdict"], report["trusted_steps"]), (0, "accepted", 0))
            self.assertEqual(lines, report["statement"])

    def test_refuses_every_way_to_cheat(self):
        false = list(theorems.traps())
        self.assertGreaterEqual(len(false), 50)
        for (name, text), report in zip(false, reports([text for _, text in false])):
            with self.subTest(name):
                self.assertNotEqual(verdict(text), "a", "Python")
                self.assertNotEqual(report["verdict"], "accepted", "C++")


    def test_what_is_long_comes_to_an_end(self):
        long = list(theorems.long_ones())
        start = time.monotonic()
        for (name, text), report in zip(long, reports([text for _, text in long])):
            with self.subTest(name):
                self.assertEqual((verdict(text), report["verdict"]), ("r", "rejected"))
        self.assertLess(time.monotonic() - start, 60)

    def test_an_inner_certificate_of_another_kind_is_malformed(self):
        inner, texts = step_of(theorems.RIGHT["small"])["certificate"], []
        for other in ("text", [], {}, None, {"format": "kovacic-homoclinic/1"}, {"format": "kovacic-loops/1"}, theorems.RIGHT["small"],
                      {"format": ["kovacic-jets/1"]}, {"format": "kovacic-jets/1"}, inner["equation"]["certificate"]):
            top = json.loads(json.dumps(theorems.RIGHT["small"]))
            step_of(top)["certificate"] = other
            texts.append(json.dumps(top))
        for other in ("text", [], {}, None, {"format": "kovacic-homoclinic/1"}, theorems.RIGHT["small"], inner):
            top = json.loads(json.dumps(theorems.RIGHT["small"]))
            step_of(top)["certificate"]["equation"]["certificate"] = other
            texts += [json.dumps(top), json.dumps(step_of(top)["certificate"])]
        for text, report in zip(texts, reports(texts)):
            with self.subTest(text[-300:]):
                self.assertEqual((verdict(text), report["verdict"]), ("m", "malformed"))

    def test_a_proof_is_read_before_it_is_judged(self):
        """Of another shape, or of one beside a term or an index that proves nothing"""
        one = ["1", "1"]
        nodes = [{"node": x} for x in ([], {}, ["empty"], None)] + [{}, [], "empty"]
        nodes += [{"node": "empty", "terms": terms, "zeros": zeros} for terms, zeros in (
            ([["-1", "1"]], [["0"]]), ([["1", "1", ["90", "1"]]], [["0", "1", "1"]]), ([one], [["90", "1"], "0"]), ([["1", "0"]], [["x", "1"]]),
            ([["1", "1", ["0", "0"]], ["1"]], []), ([["1", "1", ["0", "101"]], ["1", "1", ["0"]]], []), ([["-1", "1"], ["1", "1 +"]], []))]
        texts, judged = [], {"node": "empty", "terms": [["-1", "1", ["90", "0"]]], "zeros": [["90", "1"]]}
        for node in (*nodes, judged):
            top = json.loads(json.dumps(theorems.read("led_by_a_symmetry")))
            top["steps"][-1]["tree"]["nonzero"]["zero"] = node
            texts.append(json.dumps(top))
        for text, report in zip(texts, reports(texts)):
            with self.subTest(text[-300:]):
                self.assertEqual((verdict(text), report["verdict"]), ("r", "rejected") if text is texts[-1] else ("m", "malformed"))

    def test_an_optional_key_is_never_null(self):
        led = on_trust(theorems.read("led_by_a_symmetry"))
        darboux = theorems.read("../../darboux_data/part")
        for name, top in (("small", theorems.RIGHT["small"]), ("led", led), ("darboux", darboux)):
            texts = list(with_null(top))
            self.assertGreater(len(texts), 5)
            for (path, text), report in zip(texts, reports([text for _, text in texts])):
                with self.subTest(f"{name}: {path}"):
                    self.assertEqual((verdict(text), report["verdict"]), ("m", "malformed"))

    def test_all_certificates_of_a_file_are_on_one_meter(self):
        top = theorems.RIGHT["small"]
        V.check(json.dumps(step_of(top)["certificate"]))
        one = Equation.spent
        again = json.loads(json.dumps(step_of(top))) | {"id": "again"}
        V.check(json.dumps(top))
        self.assertEqual(Equation.spent, one)
        with self.assertRaises(V.Rejected):     # it is used by no step
            V.check(json.dumps(top | {"steps": [again, *top["steps"]]}))
        self.assertEqual(Equation.spent, 2 * one)

    def test_names_the_exceptions_to_which_a_symmetry_leads(self):
        text = json.dumps(theorems.read("led_by_a_symmetry"))
        for part, word, line in (
                ("1", ["0"], "  integrable where a = 0, or where a symmetry leads there: "), ("1", [], "  integrable where a = 0: "),
                ("2", [], "  nothing is said where a != 0, b != 0, a - 1 != 0; or where a != 0, b != 0, b - 1 != 0")):
            top = json.loads(text)
            if not word:                    # b = 0 by itself
                top["steps"][-1]["tree"]["nonzero"]["zero"] = {
                    "node": "part", "part": "2", "word": [], "region": "2",
                    "shown": [{"node": "empty", "terms": [["1", "1", ["2", "2"]]], "zeros": [["1", "-b"]]}]}
                top["steps"][3]["regions"].append([{"p": "b", "sign": "zero"}])
            lines = V.check(json.dumps(top))[2]
            self.assertTrue(any(x.startswith(line) for x in lines), lines)
            self.assertEqual(lines, reports([json.dumps(top)])[0]["statement"])
        top = on_trust(json.loads(text))    # what is on trust, and led to
        trusted, _, lines = V.check(json.dumps(top))
        self.assertIn('  TRUSTED: integrable where a = 0, or where a symmetry leads there: "known"', lines)
        self.assertEqual((trusted, lines), (1, reports([json.dumps(top)])[0]["statement"]))

    def test_strict_refuses_a_hypothesis_that_is_not_checked(self):
        for top, code in ((theorems.HEAVY, 1), (theorems.RIGHT["small"], 0)):
            with tempfile.NamedTemporaryFile("w", suffix=".json") as f:
                json.dump(top, f)
                f.flush()
                for command in ([KOVACIC, "verify"], [sys.executable, V.__file__]):
                    out = subprocess.run([*command, "--strict", f.name], capture_output=True, text=True, check=False)
                    self.assertEqual(out.returncode, code, out.stdout)
                    self.assertEqual("1 hypothesis NOT CHECKED, refused by --strict" in out.stdout, bool(code))


class Signs(unittest.TestCase):
    """A NODE for conditions on a and b: what it proves and what it does not."""

    def proved(self, given, node):
        Work.left, ConditionSet.nodes = 10**6, 1000
        names = {"a": 0, "b": FIELD}
        try:
            ConditionSet(names).also(*((parse(f, names), sign) for f, sign in given)).absent(node)
            return True
        except V.Rejected:
            return False

    def test_terms(self):
        def empty(terms, zeros=()):
            return {"node": "empty", "terms": terms, "zeros": list(zeros)}
        squares = empty([["1", "1", ["1", "2"]], ["1", "b"]], [["0", "-1"]])
        for right, given, node in (
                (True, [("a", "positive"), ("-a", "nonnegative")], empty([["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]])),
                (False, [("a", "nonnegative"), ("-a", "nonnegative")], empty([["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]])),
                (False, [("a", "nonzero"), ("-a", "nonnegative")], empty([["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]])),
                (True, [("a^2 + b^2", "zero"), ("a", "nonzero")], squares),
                (False, [("a^2 - b^2", "zero"), ("a", "nonzero")], squares),
                (False, [("a^2 + b^2", "nonnegative"), ("a", "nonzero")], squares),
                (True, [("a", "zero"), ("a - 2", "nonnegative")], empty([["1", "1", ["1", "1"]], ["2", "1"]], [["0", "-1"]])),
                (False, [("a", "zero"), ("a - 2", "nonnegative")], empty([["1", "1", ["1", "1"]]], [["0", "-1"]])),
                (False, [("a", "zero"), ("a + 2", "nonnegative")], empty([["1", "1", ["1", "1"]], ["2", "1"]], [["0", "-1"]])),
                (False, [("a", "positive"), ("-a", "nonnegative")], empty([["-1", "1", ["0", "1"]], ["-1", "1", ["1", "1"]]])),
                (False, [("a", "positive")], empty([])),
                (False, [("a", "positive")], empty([["1", "0", ["0", "1"]]]))):
            with self.subTest(f"{given} {node}"):
                self.assertEqual(self.proved(given, node), right)

    def test_a_sign_of_what_need_not_be_real_has_no_negation(self):
        """a is complex: from a^2 + 1 = 0 nothing follows about a > 0, but that a is not 0."""
        no_point = {"node": "empty", "terms": [["1", "1"], ["1", "1", ["1", "2"]]], "zeros": [["0", "-1"]]}
        same = {"node": "empty", "terms": [["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]], "zeros": []}
        zero = {"node": "empty", "terms": [["1", "1"]], "zeros": [["0", "-1"], ["1", "a"]]}
        cases = {"node": "sign", "p": "a", "positive": same, "zero": same, "negative": same}
        for right, given, f, sign, node in (
                (False, ("a^2 + 1", "zero"), "a", "positive", no_point), (False, ("a^2 + 1", "zero"), "-a", "nonnegative", no_point),
                (True, ("a^2 + 1", "zero"), "a", "nonzero", zero),
                (True, ("a", "positive"), "a", "positive", same), (True, ("2*a", "positive"), "a", "nonnegative", {
                    "node": "empty", "terms": [["1", "1", ["0", "1"]], ["2", "1", ["1", "1"]]], "zeros": []}),
                (False, ("a^2", "positive"), "a", "positive", same), (False, ("a", "nonzero"), "a", "positive", same),
                (False, ("a", "zero"), "a", "nonnegative", same), (False, ("a^2 + 1", "zero"), "1", "zero", cases)):
            with self.subTest(f"{given} {f} {sign}"):
                Work.left, ConditionSet.nodes = 10**6, 1000
                names = {"a": 0}
                try:
                    ConditionSet(names, ()).also((parse(given[0], names), given[1])).show(parse(f, names), sign, node)
                    shown = True
                except V.Rejected:
                    shown = False
                self.assertEqual(shown, right)

    def test_case_distinctions(self):
        def empty(i, e="1", zeros=()):
            return {"node": "empty", "terms": [["1", "1", [i, e]]], "zeros": list(zeros)}
        both = {"node": "empty", "terms": [["1", "1", ["0", "1"]], ["1", "1", ["2", "1"]]], "zeros": []}
        given = [("-a", "positive"), ("-b", "zero")]
        node = {"node": "sign", "p": "a", "positive": both, "zero": empty("0", "1", [["2", "1"]]), "negative": both}
        self.assertFalse(self.proved(given, node))
        self.assertTrue(self.proved([*given, ("a", "zero")], empty("0", "1", [["2", "1"]])))
        zero = {"node": "zero", "p": "b", "nonzero": empty("2", "2", [["1", "b"]]), "zero": empty("0", "1", [["2", "1"]])}
        self.assertFalse(self.proved(given, zero))
        self.assertTrue(self.proved([*given[1:], ("b - 1", "zero")],
                                    {"node": "zero", "p": "b", "nonzero": empty("2", "2", [["0", "b"]]),
                                     "zero": {"node": "empty", "terms": [["1", "1"]], "zeros": [["1", "1"], ["2", "-1"]]}}))


if __name__ == "__main__":
    unittest.main()
