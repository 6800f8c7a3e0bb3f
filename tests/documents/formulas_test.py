#!/usr/bin/env python3
"""Formulas of the pages are whole: braces close, and nothing of a formula stands beside its dollars.

usage: formulas_test.py
"""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE = re.compile(r"(?ms)^(```|~~~).*?^\1[^\n]*$|`[^`\n]+`|^(?: {4,}).*$")
MATH = re.compile(r"\$\$.+?\$\$|\$[^$\n]+(?:\n[^$\n]+)?\$", re.S)
BESIDE = {
    "a sign that belongs to a name": re.compile(r"\$(?:±|∓|\+-|[+−-](?=[,;.:)/=]))|\$[²³ⁿ]|√[$\w(]"),
    "a power or an index after the dollar": re.compile(r"\$(?:\^|_\w)|\^\{\$|\^\(\$"),
    "an argument that is cut off": re.compile(r"\\(?:exp|log|sqrt|sin|cos|det)\s*\$\("),
    "an integral in letters": re.compile(r"(?<!\\)\bint (?:\$|\()"),
    "a name in letters": re.compile(r"(?<!\\)\b(?:omega|lambda|delta|alpha|beta|theta|tau|sum|nabla)(?:bar\b|[_^]\w)"),
}


def formulas(text):
    return [m.group(0).strip("$") for m in MATH.finditer(CODE.sub(" ", text))]


class Formulas(unittest.TestCase):
    def pages(self):
        for page in sorted((ROOT / "docs").rglob("*.md")):
            if page.name not in ("CHANGELOG.md", "classified.md"):
                yield page, page.read_text(encoding="utf-8")

    def test_what_is_inside(self):
        count = 0
        for page, text in self.pages():
            for formula in formulas(text):
                count += 1
                plain = re.sub(r"\\[{}]", "", formula)
                with self.subTest(page=page.name, formula=formula[:60]):
                    self.assertEqual(plain.count("{"), plain.count("}"))
                    self.assertNotRegex(formula, r"\^\{2/[2-9]\}")  # p^2/2 is not p^(2/2)
                    self.assertNotRegex(formula, r"\b0 F_\{1\}|A i\(|\\mathrm\{\w+bar\}")
        self.assertGreater(count, 5000)

    def test_what_stands_beside(self):
        for page, text in self.pages():
            text = CODE.sub(" ", text)
            for what, pattern in BESIDE.items():
                for found in pattern.finditer(text):
                    line = text[max(0, found.start() - 40):found.end() + 30].replace("\n", " ")
                    with self.subTest(page=page.name, what=what, line=line):
                        self.fail(what)


if __name__ == "__main__":
    unittest.main()
