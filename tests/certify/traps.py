"""The traps of the Python checker: texts with the answer that is right."""
import copy
import json
import os
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
VERIFY = os.path.normpath(os.path.join(HERE, "../../tools/verify"))


def read(*path):
    with open(os.path.join(HERE, *path), encoding="utf-8") as f:
        return f.read()


def names(*path):
    return sorted(x for x in os.listdir(os.path.join(HERE, *path)) if x.endswith(".json"))


def changed(top, path, *value):
    """A copy with another value at the path, or with the entry taken out."""
    top = parent = copy.deepcopy(top)
    *path, last = path
    for key in path:
        parent = parent[int(key) if isinstance(parent, list) else key]
    last = int(last) if isinstance(parent, list) and last != "+" else last
    if last == "+":
        parent.append(value[0])
    elif value:
        parent[last] = value[0]
    else:
        del parent[last]
    return top


def changes(folder, lines):
    """What the lines {"of", "at", ["value"], "why", ["right"]} make of the certificates of a folder: name, text, right."""
    cache = {}
    for i, line in enumerate(map(json.loads, lines)):
        name = line["of"]
        if name not in cache:
            cache[name] = json.loads(read(folder, name + ".json"))
        value = [line["value"]] if "value" in line else []
        text = json.dumps(changed(cache[name], line["at"], *value))
        yield f"{folder}/{name} {i + 1}: {line['why']}", text, line.get("right", False)


def certificates():
    """(name, text, is it right?)"""
    for folder, right in (("data", True), ("data/strata", True), ("false", False)):
        for name in names(folder):
            yield f"{folder}/{name}", read(folder, name), right
    yield from changes("data/strata", read("false/strata.jsonl").splitlines())
    yield from changes("data", read("false/changed.jsonl").splitlines())
    for i, text in enumerate(read("false/texts.jsonl").splitlines()):
        yield f"text {i + 1}", json.loads(text), False


def of_the_judge(program):
    """(name, text, is it right?): what the C++ tests of certificates over strata put together, and what they say to it"""
    with tempfile.TemporaryDirectory() as out:
        texts = os.path.join(out, "texts")
        subprocess.run([program, "--gtest_filter=Strata*-StrataHostile*:StrataCorpus*"], check=True,
                       stdout=subprocess.DEVNULL, env=os.environ | {"KOV_CERTIFICATE_TEXTS": texts})
        with open(texts, encoding="utf-8") as f:
            lines = dict.fromkeys(f.read().splitlines())
    return [(f"C++ text {i}", line[2:], line[0] == "a") for i, line in enumerate(lines, 1)]
