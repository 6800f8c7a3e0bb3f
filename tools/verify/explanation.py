"""What was checked, in the words of docs/theory/rules.toml: the steps (--explain), and what must be believed (--needs)."""
import pathlib
import re
import tomllib

import checked
from statement import quoted
from theorem_statement import LITERATURE

HERE, LONGEST = pathlib.Path(__file__).resolve().parent, 400


def rules():
    """Beside this file where it is installed"""
    places = HERE / "rules.toml", HERE.parents[1] / "docs/theory/rules.toml"
    return tomllib.loads(next(p for p in places if p.exists()).read_text(encoding="utf-8"))["rule"]


def row(table, form, key, rule):
    """The rows of `conclude` have their page and their functions from it."""
    return (table[form]["rule"]["conclude"] if key == "theorem" else {}) | table[form][key][rule]


def explained():
    table, first = rules(), {}
    for number, s in enumerate(checked.steps, 1):
        r, indent = row(table, s.form, s.key, s.rule), "  " * s.inside
        of = ", ".join(map(quoted, s.of))
        before = first.setdefault((s.form, s.key, s.rule), number)
        said = f" ({r['page']})" if before == number else f", as in {before}"
        yield f"{indent}{number}. " + f"{quoted(s.id)} by " * bool(s.id) + s.rule + said + f", from {of}" * bool(of)
        if before == number:
            yield f"{indent}   so {r['says']}"
            yield f"{indent}   checked {r['checked']}"
        if s.found:
            yield f"{indent}   here {s.found[:LONGEST]}" + " ..." * (len(s.found) > LONGEST)


def modules(names):
    """These files, and what they import"""
    found, left = {"kovacic_verify.py"}, list(names)
    while left:
        name = left.pop()
        if name not in found and (HERE / name).exists():
            found.add(name)
            left += [f"{x}.py" for x in re.findall(r"^(?:from|import) (\w+)", (HERE / name).read_text(encoding="utf-8"), re.M)]
    return found


def needed(trusted):
    """Five lines"""
    table, pages, files, used = rules(), {}, set(), [s[:3] for s in checked.steps]
    for form, keys in table.items():        # with the nodes of trees, which a file of this format may have
        used += [(form, key, x) for key in ("node", "zero") for x in keys.get(key, ()) if form in {s.form for s in checked.steps}]
    for form, key, rule in used:
        r = row(table, form, key, rule)
        pages.setdefault(r["page"], {})[rule] = None
        files.add(r["python"].split()[0])
    files = modules(files)
    lines = sum(len((HERE / x).read_text(encoding="utf-8").splitlines()) for x in files)
    literature = [title + ", if " + ", if ".join(f"{what} ({how})" for how, what in hypotheses)
                  for x, (title, hypotheses) in LITERATURE.items() if x in checked.said["uses"]]
    yield f"judge       {lines} lines of Python in {len(files)} files, its standard library, and the machine"
    yield "rules       " + "; ".join(f"{page}: {', '.join(names)}" for page, names in pages.items())
    yield "literature  " + ("; ".join(literature) or "the theorems that these pages cite")
    sentences = f"{trusted} sentence{'s' * (trusted != 1)}, which the statement quotes"
    yield "on trust    " + (sentences if trusted else "nothing")
    yield "limits      " + checked.said["limits"]
