"""Traps of the rule for all units (theorem_certificates.md 18): 2 H = p1^2 + p2^2 + 2 a (q1^2 q2 + q2^3), known at a = 1."""
import json

from theorems import CUBIC

KNOWN = CUBIC["steps"][0] | {"id": "known"}
SYSTEM = {"coordinates": ["q1", "q2", "p1", "p2"], "hamiltonian": ["2*q1^2*q2*a + 2*q2^3*a + p1^2 + p2^2", "2"],
          "brackets": [["q1", "p1", "1"], ["q2", "p2", "1"]]}


def empty(zero, times, *nonzero):
    """A product of conditions that are not 0 is a multiple of one that is: nothing is there"""
    return {"node": "empty", "terms": [["1", "1", *([str(k), "1"] for k in nonzero)]], "zeros": [[str(zero), times]]}


def part(k, *shown, **region):
    return {"node": "part", "part": str(k), "word": [], "shown": list(shown)} | region


def cases(p, nonzero, zero):
    return {"node": "zero", "p": p, "nonzero": nonzero, "zero": zero}


def theorem(weights="1 1 1 1 -1 0", conditions=(), complex="ab", at=(("a", "1"),), more=(), **step):
    """conditions: of the place, one at most; the cover says nothing where its polynomial is 0.  more: of the system"""
    n, open_ones = len(conditions), [{"p": p, "sign": "zero"} for p in dict.fromkeys(("a", *(c["p"] for c in conditions)))]
    tree = part(0, empty(1, "-1", 0)) if not n or conditions[0]["p"] == "a" else cases(
        conditions[0]["p"], part(0, empty(2, "-1", 1), empty(2, "-1", 0)), part(1, empty(1, "-1", 2), region="1"))
    steps = [KNOWN,
             {"id": "at", "rule": "place", "of": "known", "system": "X", "at": list(map(list, at)), "region": list(conditions),
              "shown": [empty(n + 1, "-1"), empty(n, "1")]},
             {"id": "scale", "rule": "scale", "of": "at", "system": "X", "parameter": "a", "weights": weights.split()} | step,
             {"id": "open", "rule": "open", "system": "X", "regions": [[c] for c in open_ones]},
             {"id": "main", "rule": "cover", "system": "X", "symmetries": [], "parts": ["scale", "open"],
              "tree": cases("a", tree, part(1, empty(0, "-1", 1), region="0"))}]
    x = {"name": "X", "parameters": ["a", "b"], "complex": list(complex), "system": SYSTEM | dict(more), "assumptions": []}
    return json.dumps({"format": "kovacic-theorem/1", "title": "all units", "systems": [x], "steps": steps})


def certificates():
    yield "weights 1", theorem(), True
    for weights, right in (("0 0 1 1 2 0", True), ("0 0 1 1 2 7", True), ("-2 -2 -2 -2 2 0", True), ("0 0 0 0 0 0", False),
                           ("0 0 0 0 0 1", False), ("1 1 1 1 1 0", False), ("1 0 1 1 -1 0", False), ("1 1 1 2 -1 0", False),
                           ("1 1 1 1 -1", False), ("1 1 1 1 -1 0 0", False), ("1001 1001 1001 1001 -1001 0", False)):
        yield f"weights {weights}", theorem(weights), right
    yield "of b, which has no value", theorem("1 1 1 1 -1 1", parameter="b"), False
    yield "of a coordinate", theorem(parameter="q1"), False
    yield "of the certificate itself", theorem(of="known"), False
    yield "of nothing", theorem(of="scale"), False
    yield "a bracket with two weights", theorem("0 0 1 1 2 0", more={"brackets": [["q1", "p1", "1"], ["q2", "p2", "a"]]}), False
    for p, sign, right in (("b", "nonzero", True), ("b - 1", "nonzero", False), ("b", "positive", False)):
        yield f"where {p} is {sign}", theorem("1 1 1 1 -1 3", [{"p": p, "sign": sign}]), right
    yield "where b - 1 is not 0, b without units", theorem(conditions=[{"p": "b - 1", "sign": "nonzero"}]), True
    for at in ("1", ["1", "3"], "-2"):  # the certificate is of a = 1
        yield f"at a = {at}", theorem(at=(("a", at),)), at == "1"
    yield "a is not 0, said before", theorem(conditions=[{"p": "a", "sign": "nonzero"}]), True
    # nothing is there, so that everything would be said of it
    twice = json.loads(theorem())
    twice["steps"][1] |= {"region": [{"p": "a - 2", "sign": "zero"}], "shown": [empty(2, "-1"), empty(1, "1")]}
    yield "a is 1 and 2", json.dumps(twice), False
    for sign, right in (("nonzero", True), ("positive", False)):
        assumed = json.loads(theorem("1 1 1 1 -1 3"))
        assumed["systems"][0]["assumptions"] = [{"p": "b", "sign": sign}]
        assumed["steps"][1]["shown"] = [empty(2, "-1"), empty(1, "1")]
        assumed["steps"][4]["tree"] = cases("a", part(0, empty(2, "-1", 1)), part(1, empty(1, "-1", 2), region="0"))
        yield f"b is {sign} by assumption", json.dumps(assumed), right
    turned = [["q1", "p1", "1"], ["p2", "q2", "-1"]]
    yield "a bracket in another order", theorem("0 0 1 1 2 0", more={"brackets": turned}), True
    yield "a real parameter", theorem(complex="b"), False
    yield "b is 2 besides", theorem("1 1 1 1 -1 1", at=(("a", "1"), ("b", "2"))), False
