"""The traps of the Python checker: texts with the answer that is right, and properties of its functions."""
import copy
import importlib
import json
import os
import re
import subprocess
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
VERIFY = os.path.normpath(os.path.join(HERE, "../../tools/verify"))


def read(*path):
    with open(os.path.join(HERE, *path), encoding="utf-8") as f:
        return f.read()


def names(*path):
    """Of the certificates in a folder"""
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


def with_step(top, rule, premises, data):
    """The certificate with one more step, which its conclusion names and does not need."""
    top = copy.deepcopy(top)
    at = next(i for i, s in enumerate(top["steps"]) if s["rule"] == "conclude")
    top["steps"][at]["premises"].append("idle")
    top["steps"].insert(at, {"id": "idle", "rule": rule, "premises": premises, "data": data})
    return top


def changes(lines, folder=""):
    """What the lines {"of", "at", ["value"], "why", ["right"]} or {"of", "step", "why"} make of the certificates of a folder:
    name, text, right."""
    cache = {}
    for i, line in enumerate(lines):
        name = os.path.join(folder, line["of"])
        if name not in cache:
            cache[name] = json.loads(read(name + ".json"))
        if "step" in line:
            text = with_step(cache[name], **line["step"])
        else:
            text = changed(cache[name], line["at"], *([line["value"]] if "value" in line else []))
        yield f"{name} {i + 1}: {line['why']}", json.dumps(text), line.get("right", False)


def lines_of(*path):
    return map(json.loads, read(*path).splitlines())


def beside(function):
    """The modules beside this one that define certificates() or properties(), as (name, module)"""
    for name in sorted(x[:-3] for x in os.listdir(HERE) if x.endswith(".py") and x != os.path.basename(__file__)):
        if re.search(rf"^def {function}\(\)", read(name + ".py"), re.MULTILINE):
            yield name, importlib.import_module(name)


def certificates():
    """(name, text, is it right?): whatever is in data and false, and what the modules beside this one make"""
    for top, right in (("data", True), ("false", False)):
        for folder, *_ in sorted(os.walk(os.path.join(HERE, top))):
            folder = os.path.relpath(folder, HERE)
            yield from ((os.path.join(folder, name), read(folder, name), right or name.endswith((".true.json", ".trusted.json")))
                        for name in names(folder))
    yield from changes(lines_of("false/strata.jsonl"), "data/strata")
    yield from changes(lines_of("false/jets.jsonl"), "data/jets")
    yield from changes(lines_of("false/changed.jsonl"))
    yield from changes(lines_of("false/verdicts.jsonl"))
    for module, m in beside("certificates"):
        yield from ((f"{module}: {name}", text, right) for name, text, right in m.certificates())


def properties():
    """(name, function of the modules, True)"""
    return [x for _, m in beside("properties") for x in m.properties()]


def of_the_judge(program):
    """(name, text, is it right?): what the C++ tests of certificates over strata put together, and what they say to it"""
    with tempfile.TemporaryDirectory() as out:
        texts = os.path.join(out, "texts")
        subprocess.run([program, "--gtest_filter=Strata*-StrataHostile*:StrataCorpus*"], check=True,
                       stdout=subprocess.DEVNULL, env=os.environ | {"KOV_CERTIFICATE_TEXTS": texts})
        with open(texts, encoding="utf-8") as f:
            lines = dict.fromkeys(f.read().splitlines())
    return [(f"C++ text {i}", line[2:], line[0] == "a") for i, line in enumerate(lines, 1)]


def judged(program, texts):
    """What the C++ checker says to each text: a accepted, r rejected, m malformed"""
    with tempfile.TemporaryDirectory() as out:
        lines = os.path.join(out, "lines")
        with open(lines, "w", encoding="utf-8") as f:
            f.writelines(json.dumps({"text": x}) + "\n" for x in texts)
        subprocess.run([program, "--gtest_filter=Lines.Verdicts"], check=True, stdout=subprocess.DEVNULL,
                       env=os.environ | {"KOV_CERTIFICATE_LINES": lines})
        with open(lines + ".cpp", encoding="utf-8") as f:
            return f.read().split()
