"""Every reference that a reader meets leads somewhere: [Key] to docs/references.bib, pages, their numbered
statements, headers of the library and files.  Usage: references_test.py SOURCE_DIR"""
import os
import re
import subprocess
import sys

root = sys.argv[1]
wrong = []


def listed():
    """The files of the checkout; without git (an unpacked archive), those on the disk."""
    git = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True)
    if git.returncode == 0 and git.stdout:
        return git.stdout.split("\n")[:-1]
    found = []
    for folder in ("lib", "tools", "tests", "cases", "docs"):
        for where, _, names in os.walk(os.path.join(root, folder)):
            found += [os.path.relpath(os.path.join(where, n), root) for n in names]
    return found


def text(path):
    with open(os.path.join(root, path), encoding="utf-8") as f:
        return f.read()


files = [f for f in listed() if os.path.isfile(os.path.join(root, f))]
sources = [f for f in files if f.endswith((".hpp", ".cpp", ".h", ".c", ".inl", ".py", ".toml", ".md", ".txt"))
           and f != "tests/references_test.py" and not f.startswith("tests/corpus/")]
keys = set(re.findall(r"^@\w+\{([^,\s]+)", text("docs/references.bib"), re.M))
pages = {os.path.basename(f): text(f) for f in files if f.startswith("docs/") and f.endswith(".md")}


def statements(page):
    """What can be cited: (5) or 5 from headings and bold openings, 2.3 from numbered statements."""
    found = set(re.findall(r"^#+ \(?(\d+(?:\.\d+)*)\)?", page, re.M))
    found |= set(re.findall(r"\*\*\(?(\d+(?:\.\d+)*)", page))
    found |= set(re.findall(r"^\(?(\d+(?:\.\d+)*)\)? ", page, re.M))
    found |= set(re.findall(r"\((\d+(?:\.\d+)*)\)", page))
    return found


cited_keys = set()
for f in sources:
    t = text(f)
    for key in re.findall(r"\[([A-Z][A-Za-z]+(?:18|19|20)\d\d[a-z]?)\]", t):
        cited_keys.add(key)
        if key not in keys:
            wrong.append(f"{f}: [{key}] is not in docs/references.bib")
    for key in re.findall(r"\"([A-Z][A-Za-z]+(?:18|19|20)\d\d[a-z]?)\"", t) if f.endswith(".toml") else []:
        cited_keys.add(key)
        if key not in keys:
            wrong.append(f"{f}: {key} is not in docs/references.bib")
    joined = re.sub(r"\n\s*(?:///?|#|\*)?\s*", " ", t)  # a reference may be broken at the end of a line
    for path in re.findall(r"\b(docs/(?:theory/|guide/)?[A-Za-z0-9_-]+\.md)\b", joined):
        if path not in files:
            wrong.append(f"{f}: {path} does not exist")
    for name, numbers in re.findall(r"\b([a-z0-9_]+\.md),? (?:section )?\(?(\d+(?:\.\d+)*(?:\)?,? (?:and )?\(?\d+(?:\.\d+)*(?![\w.]))*)", joined):
        if name not in pages:
            continue
        for number in re.findall(r"\d+(?:\.\d+)*", numbers):
            if number not in statements(pages[name]):
                wrong.append(f"{f}: {name} has no statement {number}")
    if re.search(r"\bTHEORY\b|\bCorrections? \d", t):
        wrong.append(f"{f}: cites a text that is not in the repository")
    if f.startswith("docs/"):
        for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", t):
            if "://" not in target and not os.path.exists(os.path.join(root, os.path.dirname(f), target)):
                wrong.append(f"{f}: the link {target} leads nowhere")
for f in [f for f in files if f.startswith("docs/") and f.endswith(".md")] + ["README.md"]:
    for path in re.findall(r"`((?:lib|tools|tests|cases|docs)/[A-Za-z0-9_./-]+)`", text(f)):
        if not os.path.exists(os.path.join(root, path)):
            wrong.append(f"{f}: {path} does not exist")
    for header in re.findall(r"`([a-z_]+(?:/[a-z_]+)?/[a-z0-9_]+\.hpp)`", text(f)):
        if not os.path.exists(os.path.join(root, "lib", header)) and not os.path.exists(os.path.join(root, header)):
            wrong.append(f"{f}: the header {header} does not exist")
types = {}  # one definition of each name in a namespace: the linker keeps one of two without a word
for f in [f for f in files if f.startswith("lib/") and f.endswith(".hpp")]:
    space = re.search(r"^namespace ([a-z:]+) \{", text(f), re.M)
    for name in re.findall(r"^(?:struct|class|enum class) (\w+)[^;\n]*\{", text(f), re.M):
        types.setdefault((space.group(1) if space else "", name), []).append(f)
wrong += [f"{name} is defined in {' and '.join(found)}" for (_, name), found in types.items() if len(found) > 1]
index = text("tools/site_source/index.md")
for f in [f for f in files if f.startswith("docs/") and f.endswith(".md") and f != "docs/README.md"]:
    page = f[len("docs/"):-len(".md")]
    if not re.search(rf"^(?:.* <)?(?:{page}|{os.path.dirname(page) or '-'}/\*)>?$", index, re.M):
        wrong.append(f"{f}: no table of contents of tools/site_source/index.md leads there")
for f in [f for f in sources if f.startswith("tests/")]:  # tests run beside each other
    if re.search(r"TempDir\(\)|\"/tmp/", text(f)):
        wrong.append(f"{f}: writes where other tests write, see tests/support/own_folder.hpp")
for key in sorted(keys - cited_keys):
    wrong.append(f"docs/references.bib: nobody cites {key}")

print("\n".join(sorted(set(wrong))) or f"{len(cited_keys)} keys and the references of {len(sources)} files resolve")
sys.exit(1 if wrong else 0)
