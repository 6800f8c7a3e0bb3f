#!/usr/bin/env python3
"""docs/classified.md: what `kovacic classify` proves of each file in cases/classify, beside what is published.

usage: tools/classified.py PROGRAM              writes the page (some minutes)
       tools/classified.py PROGRAM --check NAME...   compares the theorems of these files with the page

A file says what is known of its system in a comment, "# published: ...".
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASES = ROOT / "cases" / "classify"
PAGE = ROOT / "docs" / "classified.md"
HEAD = """# Systems with parameters, classified

Written by `tools/classified.py`: one run of `kovacic classify FILE` for each file in `cases/classify`, with no hint but the system, beside what is published.
"Open" means that neither integrals nor an obstruction of order 1 to 5 were found; the command lists what was tried.
How the theorems come about: [theory/classify.md](theory/classify.md).
"""


def classified(program, path):
    ran = subprocess.run([program, "classify", path.name, "--format", "json", "--timeout", "120"],
                         cwd=path.parent, capture_output=True, text=True)
    return json.loads(ran.stdout)


def comment(path, key):
    found = re.search(rf"^# {key}: (.*)$", path.read_text(encoding="utf-8"), re.M)
    return found[1] if found else ""


def title(path):
    return re.search(r'^title\s*=\s*"(.*)"$', path.read_text(encoding="utf-8"), re.M)[1]


def sets(answer, status, limit=8):
    texts = [", ".join(s["conditions"]) or "all parameters" for s in answer["strata"] if s["status"] == status]
    if not texts:
        return []
    more = [f"and {len(texts) - limit} more"] if len(texts) > limit else []
    return [f"* {status}: " + "; ".join(f"`{t}`" for t in texts[:limit]) + ("" if not more else "; " + more[0])]


def entry(path, answer):
    lines = [f"## {title(path)}", "", f"`cases/classify/{path.name}`. Published: {comment(path, 'published')}.", "",
             f"**{answer['statement']}**", ""]
    for constant in answer["constants"]:
        lines.append("* where " + constant)
    if answer["assumptions"]:
        lines.append("* assumed: " + "; ".join(answer["assumptions"]))
    lines += sets(answer, "integrable") + sets(answer, "open")
    if answer["theorems"]:
        lines.append("* by " + "; ".join(answer["theorems"]))
    return "\n".join(lines).rstrip() + "\n"


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    if sys.argv[2:3] == ["--check"]:
        page, wrong = PAGE.read_text(encoding="utf-8"), 0
        for name in sys.argv[3:]:
            path = CASES / f"{name}.toml"
            if entry(path, classified(program, path)) not in page:
                print(f"{name}: another theorem than in {PAGE.name}")
                wrong += 1
        return 1 if wrong else 0
    parts = []
    for path in sorted(CASES.glob("*.toml")):
        answer = classified(program, path)
        print(f"{path.stem:20} {answer['status']:16} {answer['seconds']:.1f} s", file=sys.stderr)
        parts.append(entry(path, answer))
    PAGE.write_text(HEAD + "\n" + "\n".join(parts), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
