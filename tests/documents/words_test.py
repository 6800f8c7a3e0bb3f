#!/usr/bin/env python3
"""How sentences sound: phrases that readers stumbled over do not come back.

usage: words_test.py

Read are the pages (README, docs, the first page of the site), without code, and the texts that the program can print (the
string literals of lib and tools/kovacic).  A phrase is forbidden as it is written here, not each of its words: "symplectic
leaf" is a term of the field, a leaf of a tree of strata is not.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
EVERYWHERE = [
    (r"(?<![Tt]here )\b(is|are|was|were) no (?!longer|more\b|less\b|place\b|use\b|loss\b|news\b|matter\b|one\b)[a-z]", "is not a"),
    (r"\b[Cc]losed answers?\b", "the classical criterion"),
    (r"\bwhere always\b", "for all parameter values"),
    (r"\b(is|are|was|were) told\b(?! (apart|from))", "is reported; the program says"),
    (r"levels but special", "all but special energies"),
    (r"\bit is not so that\b", "say what does not hold"),
    (r"\bNo parameters are excluded\b", "nothing is proved, and what to type next"),
    (r"\bone and the same Delta that\b", "if every part implies ..."),
    (r"\bwhat couples\b", "the coupling of ... with ..."),
    (r"\b(?!append)[a-z]{4,}\(s\)", "plural by number"),
    (r"\bUNDECIDED IN PART: ", "NON-INTEGRABLE, except possibly where ..."),
    (r"places of the grid are not on", "... starting points lie outside the level"),
]
PAGES = EVERYWHERE + [
    (r"(?<!head)\brooms?\b", "a directory of lib/"),
    (r"\bdoors?\b", "say what it is for"),
    (r"(?:^|(?<=[.:] ))Of (?!course|these\b)", "a sentence names its subject"),
]
TEXTS = EVERYWHERE + [(r"^(Of|Those) ", "a sentence names its subject"), (r"\b1 (orbits|points|steps|sets|identities)\b", "plural by number")]


def running_text(page):
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    return [(page.relative_to(ROOT), line) for line in re.sub(r"`[^`\n]*`|\$[^$\n]*\$", "X", text).split("\n")]


def texts_of(source):
    """The string literals, neighbours joined; a word of code is none."""
    code = re.sub(r"^\s*//.*$", "", source.read_text(encoding="utf-8"), flags=re.M)
    for found in re.finditer(r'(?:"(?:[^"\\\n]|\\.)*"\s*)+', code):
        text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', found.group()))
        if " " in text.strip():
            yield source.relative_to(ROOT), text


def main():
    pages = [ROOT / "README.md", ROOT / "tools/site_source/index.md",
             *(page for page in sorted(ROOT.glob("docs/**/*.md")) if page.name != "CHANGELOG.md")]
    sources = [*sorted(ROOT.glob("tools/kovacic/**/*.[ch]pp")), *sorted(ROOT.glob("lib/**/*.[ch]pp"))]
    said = [(PAGES, *line) for page in pages for line in running_text(page)]
    said += [(TEXTS, *line) for line in running_text(ROOT / "tools/kovacic/texts/topics.txt")]
    said += [(TEXTS, *text) for source in sources for text in texts_of(source)]
    wrong = [f'{where}: "{text.strip()[:120]}": {better}' for rules, where, text in said for rule, better in rules
             if re.search(rule, text)]
    print("\n".join(wrong), f"{len(wrong)} phrases that should be written in another way", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
