"""docs/theory/rules.toml has a row for each rule that the judges read and no other; the pages and the functions that a
row names exist, and both judges have the same table of the literature.
Usage: rules_test.py SOURCE_DIR"""
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(sys.argv[1]).resolve()
CPP, PYTHON, PAGES = ROOT / "lib/certify", ROOT / "tools/verify", ROOT / "docs/theory"
sys.path.insert(0, str(PYTHON))
import certificate_format  # noqa: E402
import conclusions  # noqa: E402
import condition  # noqa: E402
import jets_format  # noqa: E402
import strata  # noqa: E402
import theorem as theorem_rules  # noqa: E402
from theorem_statement import LITERATURE  # noqa: E402

wrong = []


def text(path):
    return path.read_text(encoding="utf-8")


def cpp(path):
    return (CPP.parent if path.startswith("proof/") else CPP) / path


def quoted(path, pattern):
    """The texts in quotes that a pattern finds around its group in a file of the C++ judge, or of the Python judge"""
    return set(re.findall(pattern, text(cpp(path) if path.endswith(("cpp", "hpp")) else PYTHON / path)))


def table(path, name):
    """The texts in the array of this name, of a file of the C++ judge"""
    return set(re.findall(r'"([a-z0-9-]+)"', re.search(name + r"\{([^}]*)\}", text(CPP / path))[1]))


GROUP, STRATA, SYSTEM, JETS, LOOPS, HOMOCLINIC, THEOREM = (
    f"kovacic-{x}/1" for x in ("certificate", "strata", "system", "jets", "loops", "homoclinic", "theorem"))
one = r'"label", ([^,]+)'                        # one of two: ... ? "N5" : "N4"


def in_quotes(texts):
    return {x for one in texts for x in re.findall(r'"([\w-]+)"', one)}


def several(lists):
    return {x for names in lists for x in re.findall(r"[\w-]+", names)}


labels = {f: (in_quotes(quoted(f"{room}/check.cpp", one)) | several(quoted(f"{room}/check.cpp", r"add_labels\([^{]*\{([^}]*)\}")),
              in_quotes(quoted(f"{room}.py", one)) | several(quoted(f"{room}.py", r'checked\.label\(FORMAT, "([^"]*)"')))
          for f, room in ((SYSTEM, "system"), (JETS, "jets"), (LOOPS, "loops"), (HOMOCLINIC, "homoclinic"))}
# (format, key): what the C++ judge reads, what the Python judge reads
READ = {
    (GROUP, "rule"): (table("equation/format.cpp", "rule_words"), set(certificate_format.RULES)),
    (GROUP, "theorem"): (quoted("equation/conclude.cpp", r'\{"([a-z0-9-]+)",'),
                         quoted("conclusions.py", r'\n {8}"([a-z0-9-]+)": \(') | set(conclusions.PRIMITIVE)),
    (STRATA, "node"): (table("strata/format.cpp", "node_words"), set(strata.NODES)),
    (STRATA, "zero"): (table("strata/format.cpp", "zero_words") - set(strata.ENDS), set(strata.ZEROS) - set(strata.ENDS)),
    (STRATA, "by"): (quoted("strata/theorems.cpp", r'\{"([a-z-]+)",') | quoted("strata/criteria.cpp", r'name == "([a-z]+)"') |
                     quoted("strata/format.cpp", r'by == "([a-z]+)"'), set(strata.LEAVES)),
    (JETS, "by"): (table("jets/format.cpp", "group_words"), set(jets_format.GROUPS)),
    (LOOPS, "by"): (table("loops/format.cpp", "shows_words"),
                    quoted("loops.py", r'"([a-z0-9-]+)": "has a differential')),
    (THEOREM, "rule"): (quoted("theorem/rules.hpp", r'TheoremRule\{"([a-z-]+)"'), set(theorem_rules.RULES)),
    (THEOREM, "node"): (quoted("proof/condition/show.cpp", r'kind [!=]= "([a-z]+)"') |
                        quoted("theorem/cover.cpp", r'"node"\)\.text\(\) [!=]= "([a-z]+)"'),
                        {"empty", "part", *condition.BRANCHES}),
    **{(f, "label"): sets for f, sets in labels.items()}}


def sections(page):
    return set(re.findall(r"^#+ \(?(\d+)", page, re.M)) | set(re.findall(r"\*\*\(?(\d+(?:\.\d+)*)", page))


def need_page(row, key, where):
    page, _, section = row[key].partition(" ")
    if not (PAGES / page).exists() or section not in sections(text(PAGES / page)):
        wrong.append(f"{where}: {key} = {row[key]!r} is no section of a page")


def need_functions(row, where):
    file, _, begins = row["cpp"].partition(" ")
    if not cpp(file).exists() or begins not in text(cpp(file)):
        wrong.append(f"{where}: {cpp(file).relative_to(ROOT)} has no {begins!r}")
    file, _, function = row["python"].partition(" ")
    if not (PYTHON / file).exists() or not re.search(rf"^\s*(def|class) {function}\b", text(PYTHON / file), re.M):
        wrong.append(f"{where}: tools/verify/{file} has no {function!r}")


rules = tomllib.loads(text(PAGES / "rules.toml"))["rule"]
for (f, key), by_judge in READ.items():
    rows = set(rules.get(f, {}).get(key, {}))
    for judge, read in zip(("C++", "Python"), by_judge):
        wrong += [f"{f}: the {judge} judge reads {key} {x!r}, which has no row" for x in sorted(read - rows)]
        wrong += [f"{f}: {key} {x!r} has a row, and the {judge} judge does not read it" for x in sorted(rows - read)]
wrong += [f"{f}: nobody reads the rows of {key!r}" for f, keys in rules.items() for key in keys if (f, key) not in READ]
fields = {"says", "needs", "checked", "page", "proof", "uses", "cpp", "python"}
for where, row in ((f"{f} {key} {x}", row) for f, keys in rules.items() for key, rows in keys.items() for x, row in rows.items()):
    wrong += [f"{where}: what is {k!r}?" for k in row.keys() - fields]
    wrong += [f"{where}: {k} is not in ASCII" for k, v in row.items() if not str(v).isascii()]
    wrong += [f"{where}: {x!r} is no theorem of the judges" for x in row.get("uses", []) if x not in LITERATURE]
    if where.startswith(f"{GROUP} theorem"):        # rows of conclude
        wrong += [f"{where}: needs and says" for _ in [0] if row.keys() != {"needs", "says"}]
        continue
    wrong += [f"{where}: {k} is missing" for k in ("says", "checked", "page", "cpp", "python") if k not in row]
    if row.keys() >= {"page", "cpp", "python"}:
        need_functions(row, where)
        for k in {"page", "proof"} & row.keys():
            need_page(row, k, where)
    if "by the rules of its own format" not in row["checked"] and row["checked"] == row["says"]:
        wrong.append(f"{where}: what was checked is what follows")

# The literature: the same ids, titles and hypotheses, settled in the same way.
source = re.sub(r'"\s*\n\s*"', "", text(CPP / "theorem/statement.cpp").partition("named_theorems()")[2].partition("return all;")[0])
named = {m[1]: (m[2], re.findall(r'\{(checked|stated|open_one),\s*"([^"]*)"\}', m[3]))
         for m in re.finditer(r'\{"([^"]+)",\s*"([^"]+)",\s*\{(\{.*?\})\}\}', source, re.S)}
words = {"checked": "checked", "stated": "part of the statement", "open_one": "NOT CHECKED"}
for x in sorted(named.keys() | LITERATURE.keys()):
    ours = x in named and (named[x][0], [(words[how], what) for how, what in named[x][1]])
    if ours != LITERATURE.get(x):
        wrong.append(f"{x}: the judges do not say the same: {ours}, {LITERATURE.get(x)}")
used = {x for keys in rules.values() for rows in keys.values() for row in rows.values() for x in row.get("uses", [])}
wrong += [f"{x}: no rule uses this theorem" for x in LITERATURE.keys() - used]

# What the guide says that the judges use (docs/guide/doubt.md).
for room, below in (("proof", {"exact"}), ("certify", {"exact", "proof", "literature/integral_class.hpp"})):
    for path in (p for p in (CPP.parent / room).rglob("*") if p.suffix in (".cpp", ".hpp")):
        for used in re.findall(r'#include "([^"]+)"', text(path)):
            if not {used, used.split("/")[0]} & (below | {room}):
                wrong.append(f"{path.relative_to(ROOT)}: the C++ judge includes {used}")
ours = {p.stem for p in PYTHON.glob("*.py")}
for path in PYTHON.glob("*.py"):
    for used in re.findall(r"^\s*(?:from|import) (\w+)", text(path), re.M):
        if used not in ours | sys.stdlib_module_names:
            wrong.append(f"{path.relative_to(ROOT)}: the Python judge imports {used}")

print("\n".join(wrong) or f"{sum(len(rows) for keys in rules.values() for rows in keys.values())} rules, both judges read each")
sys.exit(bool(wrong))
