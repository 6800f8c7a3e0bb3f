#!/usr/bin/env python3
"""Changes every field of every test certificate, one at a time, and writes the results as JSON lines.

usage: tamper.py DIR OUT.jsonl [MAX_PER_FILE]     each line: {"file", "path", "kind", "text"} (text = the changed certificate)
       tamper.py --judge IN.jsonl OUT             verdicts of the Python checker, one letter per line: a r m
       tamper.py --changed TEST_CERTIFY           writes false/changed.jsonl: a few changes of each kind at each key of each
                                                  rule, and false steps of adversary.py, with the verdicts of the C++ checker
"""
import copy
import glob
import json
import os
import random
import re
import sys
import time
from collections import defaultdict

NUMBER = re.compile(r"-?[0-9]+(/[0-9]+)?\Z")
THEOREMS = ["sl2-p-curvature", "sl2-irreducible-log", "sl2-irreducible-infinite", "sl2-irreducible-12", "borel", "additive", "diagonal",
            "dihedral-genus-0", "dihedral-infinite", "dihedral-finite", "dihedral-torsion", "quaternion", "tetrahedral", "octahedral",
            "icosahedral", "invariant-abelian", "torus-nonabelian"]
RULES = ["local", "exponential", "invariant", "no-exponential", "p-curvature", "no-invariant", "torsion-function", "good-reduction", "conclude",
         "apply-theorem"]
WORDS = {"group": ["SL2", "Borel", "T", "Gm", "cyclic", "Dinf", "D", "A4", "S4", "A5"], "component": ["trivial", "Ga", "Gm", "Borel", "SL2"],
         "theorem": THEOREMS, "rule": RULES, "by": ["parity", "degree", "series"], "shows": ["nonzero", "irreducible", "sl2"],
         "place": ["0", "1", "2", "infinity"]}


def numbers(s):
    n, _, d = s.partition("/")
    yield str(int(n) + 1) + ("/" + d if d else "")
    yield str(int(n) - 1) + ("/" + d if d else "")
    yield str(-int(n)) + ("/" + d if d else "") if int(n) else "2"
    yield s + "0"
    if d:
        yield n + "/" + str(int(d) + 1)
        yield n


def mutations(node, path, key):
    """(path, kind, function that changes the parent in place)"""
    if isinstance(node, dict):
        for k in list(node):
            yield path + (k,), "drop", None
            yield from mutations(node[k], path + (k,), k)
    elif isinstance(node, list):
        for i, v in enumerate(node):
            yield path + (i,), "drop", None
            if i + 1 < len(node) and node[i + 1] != v:
                yield path + (i,), "swap", None
            yield path + (i,), "double", None
            yield from mutations(v, path + (i,), key)
        yield path, "empty", []
    elif isinstance(node, bool):
        yield path, "flip", not node
        yield path, "null", None
    elif node is None:
        for v in ("1", "2", "SL2", True, False):
            yield path, "set", v
    else:
        for w in WORDS.get(key, []):
            if w != node:
                yield path, "word", w
        if key in ("group", "n", "component"):
            yield path, "null", None
        if NUMBER.match(node):
            for v in numbers(node):
                if v != node:
                    yield path, "number", v
        yield path, "text", node + "x"
        yield path, "text", ""


def apply(top, path, kind, value):
    top = copy.deepcopy(top)
    parent = top
    for k in path[:-1]:
        parent = parent[k]
    k = path[-1]
    if kind == "drop":
        del parent[k]
    elif kind == "swap":
        parent[k], parent[k + 1] = parent[k + 1], parent[k]
    elif kind == "double":
        parent.insert(k, parent[k])
    else:
        parent[k] = value
    return top


def write(directory, out, most=10**9):
    total = 0
    with open(out, "w") as f:
        for name in sorted(glob.glob(os.path.join(directory, "*.json"))):
            top = json.load(open(name))
            todo = list(mutations(top, (), ""))
            step = max(1, len(todo) // most)
            for path, kind, value in todo[::step]:
                f.write(json.dumps({"file": os.path.basename(name), "path": "/".join(map(str, path)), "kind": kind,
                                    "text": json.dumps(apply(top, path, kind, value))}) + "\n")
                total += 1
    print(total, "changed certificates")


def judge(source, out):
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/verify"))
    import kovacic_verify as V
    with open(out, "w", buffering=1) as f:
        for number, line in enumerate(open(source), 1):
            start = time.time()
            try:
                V.check(json.loads(line)["text"])
                f.write("a\n")
            except V.Rejected:
                f.write("r\n")
            except V.Malformed:
                f.write("m\n")
            if time.time() - start > 5:
                print("line", number, round(time.time() - start, 1), "s", json.loads(line)["file"], json.loads(line)["path"], flush=True)


def key(top, path):
    """The rule or the leaf at a path, and the names of the keys that lead there"""
    words, node, rule = [], top, ""
    for k in path:
        if isinstance(node, dict):
            rule = next((" ".join([node[x], str(node.get("by", ""))]) for x in ("rule", "node", "zero")
                         if isinstance(node.get(x), str)), rule)
        words.append("*" if isinstance(node, list) else k)
        node = node[k]
    return rule, *words[-3:]


def line(name, top, path, kind, value):
    """The change as a line of changed.jsonl"""
    parent = top
    for k in path[:-1]:
        parent = parent[k]
    if kind in ("swap", "double"):
        for k in path[:-1]:
            value = (value if value is not None else apply(top, path, kind, None))[k]
        path = path[:-1]
    return {"of": name, "at": [str(k) for k in path], **({} if kind == "drop" else {"value": value}), "why": kind}


def change(program, most=2, longest=2500):
    """Few of the changes that make no sense, some of the others; of short certificates, as they are judged often."""
    import adversary
    import traps
    rng, found, lines = random.Random(13), defaultdict(list), []
    for folder in ("data", "data/strata"):
        for name in traps.names(folder):
            top = json.loads(traps.read(folder, name))
            for path, kind, value in mutations(top, (), "") if len(json.dumps(top)) < longest else []:
                found[key(top, path), kind].append((os.path.join(folder, name[:-5]), top, path, kind, value))
    for (where, kind), some in found.items():
        clear = kind in ("text", "null", "swap", "double") or kind == "drop" and where[0] == ""
        lines += [line(*x) for x in rng.sample(some, min(len(some), 1 if clear else most))]
    names = [x[:-5] for x in traps.names("data") if len(traps.read("data", x)) < longest]
    by_kind = defaultdict(list)
    for name, rule, premises, data, why in [*adversary.steps(names), *adversary.steps(names[::2], True)]:
        row = {"of": "data/" + name, "step": {"rule": rule, "premises": premises, "data": data}, "why": why}
        of = "infinity" if data.get("place") == "infinity" else len(data.get("lines", []))
        by_kind[rule, data.get("by"), data.get("shows"), data.get("m"), of, why.split(" (")[0]].append(row)
    for some in by_kind.values():
        lines += sorted(rng.sample(some, min(len(some), 30)), key=lambda x: len(str(x)))[:6 if "series" in str(some[0]) else 2]
    texts = [text for _, text, _ in traps.changes(lines)]
    for entry, letter in zip(lines, traps.judged(program, texts)):
        entry |= {"right": True} if letter == "a" else {}
    with open(os.path.join(traps.HERE, "false/changed.jsonl"), "w", encoding="utf-8") as f:
        f.writelines(json.dumps(x) + "\n" for x in lines if len(json.dumps(x)) < 500)


if __name__ == "__main__":
    if sys.argv[1] == "--judge":
        judge(sys.argv[2], sys.argv[3])
    elif sys.argv[1] == "--changed":
        sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/verify"))
        change(sys.argv[2])
    else:
        write(sys.argv[1], sys.argv[2], *map(int, sys.argv[3:]))
