"""Traps of the rule for all units (theorem_certificates.md 18): 2 H = p1^2 + p2^2 + 2 a (q1^2 q2 + q2^3), known at a = 1."""
import json

from composed import LEAF, LEAVES, NEAR, ORIGIN, REAL, Class, fact
from composed import theorem as with_facts
from lowest import refused
from theorems import CUBIC
from transport import family

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


# ---- the rule alone

CONSTANT = {"functions": [("r", {})], "relations": ["r^2 - 2"]}
ALONE = {"parameters": "ab", "complex": "ab"}


def units(m):
    """p1^2 + p2^2 + a q1^3 and others, where a has a value, and the fields (y, a x^2)"""
    weights = "1 1 1 1 -1 3"

    def scaled(h="p1^2 + p2^2 + a*q1^3", region=("a - 2",), weights=weights, classes=(NEAR,), parameter="a", nonzero=(), same=True, **more):
        m["multivariate"].Work.left = 10**7
        x, other = (family(m, h, **ALONE | more) for _ in range(2))
        parse, found = m["multivariate"].parse, []
        conditions = [(parse(p, x.names), sign) for sign, rows in (("zero", region), ("nonzero", nonzero)) for p in rows]
        t = with_facts(m, {"X": x}, of=fact(m, "N", x if same else other, conditions, classes))
        d = {"of": "of", "system": "X", "parameter": parameter, "weights": list(map(int, weights.split()))}
        if refused(m, lambda: found.append(t.said("scale", d))):
            return None
        f, = found
        return f.classes, f.way, [("ab"[min(g.variables()) != x.names["a"]], says) for g, says in f.regions[0]]
    right = ([NEAR], ["in units in which a = 2, by the weights q1 1, q2 1, p1 1, p2 1, a -1, b 3"], [("a", "nonzero")])
    plane = {"h": None, "field": ["y", "a*x^2"], "coordinates": "xy"}
    of_r, of_u = CONSTANT | {"h": "p1^2 + p2^2 + r*a*q1^3"}, {"h": "p1^2 + p2^2 + a*u*q1^4", "inverses": [("u", "q1")]}
    return (scaled() == right and scaled(same=False) is None and scaled(parameter="q1") is None and scaled(parameter="c") is None
            and scaled(region=["a - 2", "b"])[2] == [("b", "zero"), ("a", "nonzero")] and scaled(nonzero=["b"])[2] == [("b", "nonzero"), ("a", "nonzero")]
            and scaled(nonzero=["a - 3"]) is None and scaled(nonzero=["a"])[2] == [("a", "nonzero")] and scaled(region=["a - 2", "a - b"]) is None
            and all(scaled(region=rows) is None for rows in (["a"], ["a^2 + 2*a - 3"], ["a - 2", "a - 3"], [], ["a - b"], ["a^2"]))
            and scaled(region=["3*a + 1"])[1][0].startswith("in units in which a = -1/3, ")
            and all(scaled(classes=[NEAR, c]) for c in (ORIGIN, LEAF)) and not any(scaled(classes=[NEAR, c]) for c in (
                REAL, LEAVES, *(Class(**{key: ("q1",)}) for key in ("functions", "through", "without", "frame"))))
            and scaled(weights="1000 1000 1000 1000 -1000 0") and not scaled(weights="1001 1001 1001 1001 -1001 0") and scaled(**of_r) and scaled(**of_u)
            and not scaled(**of_r | {"relations": ["r^2 - a"]}) and not scaled(functions=[("s", {"q1": "s"})])
            and scaled(**plane, weights="1 2 1 0") and not scaled(**plane, weights="1 2 2 0") and not scaled(**plane, weights="1 1 1 0"))


def properties():
    """(name, function, True)"""
    return [("scale_traps.units", units, True)]
