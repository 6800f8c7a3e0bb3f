#!/usr/bin/env python3
"""Every rule of a theorem (RULES of tools/verify/rules.py) has a true certificate and a false one that differs from it in
a step of this rule; both checkers accept the first and refuse the second with exit code 1.

usage: every_rule_test.py KOVACIC

Pairs are NAME.true.json (or NAME.trusted.json, which --strict refuses) and NAME.false.json in false/theorem, and the traps of the modules below beside the right ones."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / "tools/verify"), str(HERE)]
import kovacic_verify as V  # noqa: E402
import traps  # noqa: E402
from theorem import RULES  # noqa: E402

KOVACIC = str(pathlib.Path(sys.argv.pop(1)).resolve())


def steps(text):
    top = json.loads(text)
    return top.get("steps", []) if isinstance(top, dict) else []


def other_rules(true, false):
    """The rules of the steps that differ, or none where there are more or fewer steps"""
    a, b = steps(true), steps(false)
    if len(a) != len(b) or not all(isinstance(x, dict) for x in a + b):
        return []
    return [y.get("rule") for x, y in zip(a, b) if x != y]


def is_refused(text):
    """And not malformed"""
    try:
        V.check(text)
    except V.Malformed:
        return False
    except V.Rejected:
        return True
    return True  # the test says so


def of_pair(true, false, keep):
    rules = other_rules(true, false)
    for rule in rules:
        if rule != "cover" or len(rules) == 1:
            keep(rule, true, false)


def pairs():
    """rule: the smallest pair, true text and false text"""
    best = {}

    def keep(rule, true, false):
        if isinstance(rule, str) and rule in RULES and (rule not in best or len(false) < len(best[rule][1])) and is_refused(false):
            best[rule] = true, false
    for path in sorted((HERE / "false/theorem").glob("*.false.json")):
        names = (path.with_name(path.name.replace(".false.", kind)) for kind in (".true.", ".trusted."))
        for twin in (x for x in names if x.exists()):
            of_pair(twin.read_text(encoding="utf-8"), path.read_text(encoding="utf-8"), keep)
    for _, module in traps.beside("certificates"):
        known = [(text, right) for _, text, right in module.certificates() if isinstance(text, str) and text.startswith("{")]
        right_ones = [text for text, right in known if right is True]
        for false in (text for text, right in known if right is False):
            for true in right_ones:
                if len(rules := other_rules(true, false)) == 1:
                    keep(rules[0], true, false)
                    break
    return best


class EveryRule(unittest.TestCase):
    def test_has_a_true_one_and_a_false_one(self):
        found = pairs()
        self.assertEqual(sorted(found), sorted(RULES))
        for rule, (true, false) in found.items():
            with self.subTest(rule), tempfile.NamedTemporaryFile("w", suffix=".json") as f:
                for text, code in ((true, 0), (false, 1)):
                    f.seek(0)
                    f.truncate()
                    f.write(text)
                    f.flush()
                    for command in ([KOVACIC, "verify"], [sys.executable, "-B", V.__file__]):
                        self.assertEqual(subprocess.run([*command, f.name], capture_output=True, check=False).returncode, code)


if __name__ == "__main__":
    unittest.main()
