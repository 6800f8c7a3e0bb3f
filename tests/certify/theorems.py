"""Certificates of theorems: what `kovacic prove` wrote (data/theorem), and beside each rule of
docs/theory/theorem_certificates.md ways to cheat that a plausible mistake in it would accept.  certificates() yields what is
stated, the text and whether it is right."""
import copy
import json
import os
import re

HERE = os.path.dirname(os.path.abspath(__file__))


def read(name):
    with open(os.path.join(HERE, "data/theorem", name + ".json"), encoding="utf-8") as f:
        return json.load(f)


HEAVY, SLIDING, CUBIC = read("heavy_top"), read("sliding_top"), read("cubic_potential")


def step(top, name):
    return next(s for s in top["steps"] if s["id"] == name)


def system(top, name):
    return next(s for s in top["systems"] if s["name"] == name)


TOP = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
ONE = [["1" if i == j else "0" for j in range(6)] for i in range(6)]


def small():
    """The heavy top with A = B = 1, C = 3, L = (1, 0, 0), from the certificate of that system"""
    h = {"coordinates": TOP, "inverses": [], "hamiltonian": ["3*M1^2 + 3*M2^2 + M3^2 + 6*Gamma1", "6"],
         "brackets": system(HEAVY, "heavy_top.toml")["system"]["brackets"]}
    group = {"chosen": [["1", "1", "1"]], "by": {"node": "empty", "terms": [["1", "1"]], "zeros": [["0", "-1"]]}}
    place = {"id": "y", "rule": "place", "of": "flat-step", "system": "Y", "at": [], "region": [], "adjoined": [],
             "values": {x: x for x in TOP}, "back": ONE, "bracket": ["1", "1"], "energy": ["1", "1"], "shown": [group, group]}
    cover = {"id": "main", "rule": "cover", "system": "Y", "symmetries": [], "parts": ["y"],
             "tree": {"node": "part", "part": "0", "word": [], "shown": []}}
    family = {"name": "Y", "parameters": [], "system": h, "assumptions": []}
    return copy.deepcopy({"format": "kovacic-theorem/1", "title": "small", "systems": [family],
                          "steps": [step(HEAVY, "flat-step"), place, cover]})


def nodes(v, kind):
    """All nodes of this kind, the first ones first"""
    if isinstance(v, dict):
        if v.get("node") == kind:
            yield v
        for x in v.values():
            yield from nodes(x, kind)
    elif isinstance(v, list):
        for x in v:
            yield from nodes(x, kind)


def tree(top):
    return top["steps"][-1]["tree"]


def to(owner, key, value):
    owner[key] = value


def without(rows, i):
    del rows[i]


def changed(top, change):
    top = copy.deepcopy(top)
    change(top)
    return top


def swapped(owner, a, b):
    owner[a], owner[b] = owner[b], owner[a]


def renamed_part(top):
    """The leaf of another region, with what was shown for the right one"""
    leaf = next(n for n in nodes(tree(top), "part") if n["part"] == "5")
    leaf["part"] = "6"
    leaf["shown"] = leaf["shown"] + leaf["shown"][-1:]


def other_word(top):
    next(n for n in nodes(tree(top), "part") if n["word"])["word"] = []


def proof(top):
    return step(top, "three-step")["proof"]


def first_empty(top):
    return next(nodes(proof(top), "empty"))


def forgotten_level(top):
    s = step(top, "goryachev-chaplygin-step")
    s["level"] = []
    for c in s["claims"]:
        c["cofactors"] = []


def wider(top, name):
    """The region of the place without its conditions, in what is stated"""
    step(top, name)["region"] = []


def moved_level(top):
    """A level of the integral that is not invariant"""
    s = step(top, "goryachev-chaplygin-step")
    s["level"] = ["M1"]


def root_in_real_system(top):
    step(top, "three")["adjoined"] = [{"name": "r", "square": "L1^2 + L2^2"}]


def other_direction(top):
    """Only the parameters of the symmetry are exchanged"""
    values = step(top, "symmetry-2")["values"]
    for x in ("M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"):
        values[x] = x
    step(top, "symmetry-2")["back"] = [["1" if i == j else "0" for j in range(6)] for i in range(6)]


def reflection(top):
    """M1 -> -M1 with its inverse: the Hamiltonian is the same, the bracket is not"""
    s = step(top, "three")
    s["values"]["M1"], s["back"][0][0] = "-M1", "-1"


def lagrangian(top):
    return system(top, "sliding_top.toml")["lagrangian"]


def momentum_in_lagrangian(top):
    """L + M1 Omega2 - M2 Omega1 has the same energy, and its derivatives are not functions of the velocities alone"""
    l = lagrangian(top)
    value, n = l["value"]
    l["value"] = [f"{value} + {n}*M1*Omega2 - {n}*M2*Omega1", n]


def cubic_lagrangian(top):
    l = lagrangian(top)
    value, n = l["value"]
    l["value"] = [f"{value} + {n}*Omega1^3", n]


def divided_level(top):
    """1/F2 as a cofactor on F2 = 0"""
    system(top, "heavy_top_goryachev_chaplygin.toml")["system"]["inverses"].append(
        {"name": "w", "of": "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"})
    step(top, "goryachev-chaplygin-step")["claims"] = [{"name": "F3", "value": "M1", "cofactors": ["3*M2*M3*u1*w"]}]


def adjoined(row):
    return lambda t: step(t, "y")["adjoined"].append(row)


def parameters(*names):
    return lambda t: t["systems"][0]["parameters"].extend(names)


TWO = {"name": "v", "inverse": "2", "times": "1", "norm": "2",
       "by": {"node": "empty", "terms": [["2", "1"]], "zeros": [["0", "-1"]]}}


def at_and_adjoined(top):
    """A name that a parameter with a value had"""
    top["systems"][0]["parameters"] = ["p"]
    step(top, "y")["at"], step(top, "y")["adjoined"] = [["p", "1"]], [{"name": "p", "square": "2"}]
    top["steps"][-1]["tree"]["shown"] = [{"node": "empty", "terms": [["1", "p"]], "zeros": []}]


def on_one_leaf(top, casimirs=1):
    """What is proved on the leaf of a phase curve, of the system of lowest order; with two Casimir functions, near the curve"""
    claims = top["steps"][0]["certificate"]["claims"]
    claims[:] = [x for x in claims if x["kind"] == "casimir"][:casimirs]
    whole = copy.deepcopy(top["systems"][0])
    whole["name"], whole["system"]["hamiltonian"][0] = "X", whole["system"]["hamiltonian"][0] + " + 6*Gamma1^2"
    top["systems"].append(whole)
    top["steps"].insert(2, {"id": "x", "rule": "lowest-order", "of": "y", "system": "X", "degree": "2",
                            "weights": ["1", "1", "1", "2", "2", "2"], "units": [], "orders": []})
    top["steps"][-1].update(system="X", parts=["x"])


def shifted(s, hamiltonian):
    """The same system with q1 + s in the place of q1, after the step of lowest order"""
    def change(top):
        there = copy.deepcopy(system(top, "X.toml"))
        there["name"], there["system"]["hamiltonian"] = "Z", hamiltonian
        top["systems"].append(there)
        names = ["q1", "q2", "p1", "p2"]
        values = {x: x for x in [*names, "a", "u1", "u2"]}
        values["q1"] = s
        top["steps"].insert(-1, {
            "id": "z", "rule": "place", "of": "cubic", "system": "Z", "at": [], "region": [], "adjoined": [],
            "values": values, "back": [row[:4] for row in ONE[:4]], "bracket": ["1", "1"], "energy": ["1", "1"],
            "shown": [{"over": "1", "value": "a", "by": {"node": "empty", "terms": terms, "zeros": zeros}}
                      for terms, zeros in (([["1", "1"]], [["1", "-1"]]),
                                           ([["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]], []))]})
        top["steps"][-1].update(system="Z", parts=["z"])
    return change


def one_lagrangian(value, hamiltonian, rows, inverses=(), parameters=(), bracket="1"):
    """One more system; rows: velocity, its momentum and its value; bracket: of q1 and p1"""
    def change(top):
        top["systems"].append({
            "name": "L", "parameters": list(parameters), "assumptions": [],
            "system": {"coordinates": ["q1", "q2", "p1", "p2"], "hamiltonian": hamiltonian,
                       "inverses": [{"name": u, "of": h} for u, h in inverses],
                       "brackets": [["q1", "p1", bracket], ["q2", "p2", "1"]]},
            "lagrangian": {"value": value, "velocities": [dict(zip(("name", "momentum", "value"), row)) for row in rows]}})
    return change


def with_lagrangian(value, hamiltonian, velocities):
    """v1 and v2 are the velocities of p1 and p2"""
    return one_lagrangian(value, hamiltonian, [(f"v{i + 1}", f"p{i + 1}", v) for i, v in enumerate(velocities)])


ENERGY, SPEEDS = ["3*p1^2 + p2^2 - 2*p2*q1 + 7*q1^2", "6"], ["p1", ["p2 - q1", "3"]]
FREE = ["v1^2 + 3*v2^2 + 2*q1*v2 - 2*q1^2", "2"]
# FREE + (3*v2 - p2 + q1)^2/2: the same derivatives and the same value at the velocities
WITH_MOMENTA = ["v1^2 + 12*v2^2 + 8*q1*v2 - 6*v2*p2 + p2^2 - 2*p2*q1 - q1^2", "2"]


HEAVY_TRAPS = {
    # signs
    "a leaf without what is strict": lambda t: [to(n, "terms", []) for n in nodes(tree(t), "empty")][:1],
    "a term of sign unknown": lambda t: to(first_empty(t)["terms"][0][2], 1, "1"),
    "a negative factor": lambda t: to(first_empty(t)["terms"][0], 0, "-2"),
    "a sum that is not 0": lambda t: to(first_empty(t)["terms"][0], 0, "3"),
    "a condition that is not an equation": lambda t: to(first_empty(t)["zeros"][0], 0, "0"),
    "a branch that is missing": lambda t: to(tree(t), "zero", tree(t)["nonzero"]),
    # cover
    "the leaf of another region": renamed_part,
    "a symmetry that is not applied": other_word,
    "a part that is left out": lambda t: without(t["steps"][-1]["parts"], 8),
    "parts in another order": lambda t: swapped(t["steps"][-1]["parts"], 5, 6),
    "a cover of something else": lambda t: to(t["steps"][-1], "system", "heavy_top_lagrange.toml"),
    # order of the steps
    "a step that rests on a later one": lambda t: swapped(t["steps"], 0, 1),
    "a step that rests on itself": lambda t: to(step(t, "three"), "of", "three"),
    "an id twice": lambda t: to(step(t, "long"), "id", "flat"),
    "a step that is not used": lambda t: to(step(t, "euler"), "of", "lagrange-step"),
    "no cover at the end": lambda t: without(t["steps"], -1),
    # places
    "a region that says more": lambda t: wider(t, "symmetric"),
    "another body": lambda t: to(step(t, "flat"), "at", [["B", "A"], ["C", "2*A"], ["L3", "0"]]),
    "not the third axis": lambda t: to(step(t, "lagrange"), "at", [["B", "A"], ["L1", "0"], ["L3", "0"]]),
    "another coordinate": lambda t: to(step(t, "three")["values"], "M1", "M2"),
    "a reflection": reflection,
    "a singular map": lambda t: [to(step(t, "three")["values"], x, "0") for x in ("M1", "M2", "M3")],
    "another inverse matrix": lambda t: to(step(t, "ball")["back"][0], 0, "1"),
    "another unit of energy": lambda t: to(step(t, "flat"), "energy", ["1", "1"]),
    "another factor of the bracket": lambda t: to(step(t, "flat"), "bracket", ["1", "1"]),
    "a factor that is 0": lambda t: to(step(t, "flat"), "bracket", ["0", "1"]),
    "another value of an inverse": lambda t: to(step(t, "flat")["values"], next(iter(
        x for x in step(t, "three")["values"] if x.startswith("u"))), "1"),
    "a parameter of the variables": lambda t: to(step(t, "three")["values"], "A", "A + M1 - M1^2"),
    "another norm": lambda t: to(step(t, "flat")["adjoined"][1], "norm", "A^2"),
    "what is not shown": lambda t: without(step(t, "symmetric")["shown"], -1),
    "another value of a condition": lambda t: to(step(t, "symmetric")["shown"][-1], "value", "1"),
    "a root in a real system": root_in_real_system,
    # symmetries
    "parameters without coordinates": other_direction,
    "a symmetry of the parameters with a sign": lambda t: to(step(t, "symmetry-2")["values"], "L1", "-L2"),
    # systems
    "an assumption that is left out": lambda t: without(system(t, "heavy_top.toml")["assumptions"], 0),
    "another bracket": lambda t: to(system(t, "heavy_top.toml")["system"]["brackets"][0], 2, "M3"),
    "no Poisson bracket": lambda t: to(system(t, "heavy_top.toml")["system"]["brackets"][0], 2, "-M3 - M1*M2"),
    # literature
    "a theorem about more": lambda t: without(system(t, "Ziglin 1983")["assumptions"], 3),
    "a rule that there is not": lambda t: to(step(t, "symmetric-step"), "rule", "stratum"),
    "an unknown theorem": lambda t: to(step(t, "symmetric-step"), "theorem", "Ziglin 1982"),
    # integrals
    "no integral": lambda t: to(step(t, "lagrange-step")["claims"][0], "value", "M1"),
    "a forgotten level": forgotten_level,
    "a level that is not invariant": moved_level,
    "what vanishes on the level as a denominator": divided_level,
    # splitting
    "another order": lambda t: to(step(t, "three-step"), "order", "2"),
    "a perturbation with a term forgotten": lambda t: to(
        step(t, "three-step"), "first", "2*Gamma1*A*B*C*L1 + 2*Gamma2*A*B*C*L2"),
    "a perturbation with another factor": lambda t: to(
        step(t, "three-step"), "first", "2*Gamma1*A*B*C*L1 + 2*Gamma2*A*B*C*L2 + Gamma3*A*B*C*L3"),
    "another power": lambda t: to(step(t, "three-step"), "power", "2"),
    "moments in another order": lambda t: to(step(t, "three-step"), "moments", ["C", "B", "A"]),
    "small parameters in another place": lambda t: to(step(t, "three-step"), "small", ["L1", "L2", "A"]),
    "moments that are not ordered": lambda t: without(step(t, "three-step")["region"], 1),
    "no direction": lambda t: without(step(t, "three-step")["region"], 3),
    # certificates
    "another certificate": lambda t: to(step(t, "flat-step"), "certificate", step(t, "long-step")["certificate"]),
    "a certificate that claims nothing": lambda t: to(
        step(t, "flat-step")["certificate"]["claim"], "not_integrable", False),
}
SLIDING_TRAPS = {
    "another weight": lambda t: to(step(t, "heavy-three"), "weights", ["1"] * 6),
    "a weight that mixes orders": lambda t: to(step(t, "heavy-three"), "weights", ["1", "1", "1", "2", "2", "3"]),
    "another degree": lambda t: to(step(t, "heavy-three"), "degree", "1"),
    "another order of a denominator": lambda t: to(step(t, "heavy-three")["orders"][0], "order", "1"),
    "another lowest part": lambda t: to(step(t, "heavy-three")["orders"][0], "part", "A*B"),
    "no lowest system": lambda t: to(step(t, "heavy-three"), "of", "heavy-three-step"),
    "a level where nothing is proved": lambda t: to(step(t, "kovalevskaya-body")["values"], "h", "-1"),
    "gravity at a body without": lambda t: to(step(t, "lemma-3"), "at", [["B", "A"], ["L3", "0"]]),
    "another family": lambda t: to(step(t, "long-axis"), "at", [["C", "A - B"], ["g", "0"], ["L2", "0"], ["L3", "0"]]),
    "the triangle inequality forgotten": lambda t: without(step(t, "asymmetric-step")["region"], 4),
    "another Lagrangian": lambda t: to(lagrangian(t)["value"], 1, "1"),
    "velocities of another Lagrangian": lambda t: to(lagrangian(t)["velocities"][0], "value", "M1"),
    "momenta in another order": lambda t: [to(lagrangian(t)["velocities"][i], "momentum", f"M{2 - i}") for i in (0, 1)],
    "one momentum for two velocities": lambda t: to(lagrangian(t)["velocities"][1], "momentum", "M1"),
    "a momentum that is a velocity": lambda t: to(lagrangian(t)["velocities"][0], "momentum", "Omega1"),
    "a velocity with the name of a parameter": lambda t: to(lagrangian(t)["velocities"][0], "name", "A"),
    "a Lagrangian of the momenta": momentum_in_lagrangian,
    "a Lagrangian that is not quadratic": cubic_lagrangian,
    "a Lagrangian without a velocity": lambda t: without(lagrangian(t)["velocities"], 2),
    "the energy of another system": lambda t: to(system(t, "sliding_top.toml, g = 0"), "lagrangian", lagrangian(t)),
    "the family forgotten": lambda t: without(step(t, "asymmetric-step")["region"], -1),
}


def part_of_region(shown):
    """The place is there for p >= 0, and the system is assumed to have p > 0"""
    def change(top):
        top["systems"][0].update(parameters=["p"], assumptions=[{"p": "p", "sign": "positive"}])
        y = step(top, "y")
        y["region"] = [{"p": "p", "sign": "nonnegative"}]
        for s in y["shown"]:
            s["by"]["zeros"][0][0] = "2"
        tree(top)["shown"] = shown
    return change


def twice(top):
    """A second step y, of which nobody speaks"""
    top["steps"].insert(2, copy.deepcopy(step(top, "y")))


def unused(top):
    top["steps"].insert(2, {**copy.deepcopy(step(top, "y")), "id": "another"})


def cover_of_a_cover(top):
    first = top["steps"].pop()
    top["steps"] += [first, {**first, "id": "again", "parts": ["main"]}]


def long_word(top):
    """A part with 41 symmetries, each of which does nothing"""
    idle = {key: step(top, "y")[key] for key in ("system", "adjoined", "values", "back", "bracket", "energy")}
    top["steps"].insert(2, idle | {"id": "s", "rule": "symmetry", "shown": []})
    top["steps"][-1]["symmetries"], tree(top)["word"] = ["s"], ["0"] * 41


SMALL_TRAPS = {
    "an optional key is null": lambda t: to(step(t, "flat-step")["certificate"]["equation"], "root", None),
    "an id twice": twice,
    "a step that is not used, before the cover": unused,
    "a cover as a part of a cover": cover_of_a_cover,
    "too long a word": long_word,
    "a Lagrangian of the momenta with the right derivatives": with_lagrangian(WITH_MOMENTA, ENERGY, SPEEDS),
    "a cubic Lagrangian with the right derivatives": with_lagrangian(
        ["3*v1*v2 + v2^3", "3"], ["3*p1*p2 - p1^3", "3"], ["p2 - p1^2", "p1"]),
    "another linear part of a Lagrangian": with_lagrangian(["v1^2 + 3*v2^2 - 2*q1*v2 - 2*q1^2", "2"], ENERGY, SPEEDS),
    "another sign of the potential": with_lagrangian(["v1^2 + 3*v2^2 + 2*q1*v2 + 2*q1^2", "2"], ENERGY, SPEEDS),
    "velocities exchanged": with_lagrangian(FREE, ENERGY, SPEEDS[::-1]),
    "no velocities": one_lagrangian("-q1^2", "q1^2", []),
    "a velocity with the name of a coordinate": one_lagrangian(
        [FREE[0].replace("v2", "q2"), "2"], ENERGY, [("v1", "p1", SPEEDS[0]), ("q2", "p2", SPEEDS[1])]),
    "a velocity that is not a name": one_lagrangian(FREE, ENERGY, [("v1", "p1", SPEEDS[0]), ("v 2", "p2", SPEEDS[1])]),
    "a momentum that is a parameter": one_lagrangian(["v1^2 + v2^2", "2"], ["p1^2 + A^2", "2"], [
        ("v1", "p1", "p1"), ("v2", "A", "A")], parameters=["A"]),
    "a momentum twice": one_lagrangian(["v1^2 + 2*v1*v2 + v2^2", "2"], ["p1^2", "2"], [("v1", "p1", "p1"), ("v2", "p1", "0")]),
    "a velocity half as large": one_lagrangian(["v1^2", "2"], ["3*p1^2", "8"], [("v1", "p1", ["p1", "2"])]),
    "a Lagrangian of an inverse of a momentum": one_lagrangian(["v1^2 - 2*u", "2"], ["p1^2 + 2*u", "2"], [
        ("v1", "p1", "p1")], [("u", "p1")]),
    "a parameter that forges lines": parameters("A\nis integrable by quadratures"),
    "a parameter that is a coordinate": parameters("M1"),
    "a parameter twice": parameters("a", "a"),
    "a parameter without a name": parameters(""),
    "a parameter that is not a name": parameters("a b"),
    "too many parameters": parameters(*(f"p{i}" for i in range(13))),
    "an inverse that the system has not": lambda t: t["systems"][0]["system"]["inverses"].append({"name": "w", "of": "M1"}),
    "a root that is not a name": adjoined({"name": "r 1", "square": "2"}),
    "a root that is a parameter with a value": at_and_adjoined,
    "an inverse over a number": adjoined(TWO | {"inverse": ["2", "7"]}),
    "a factor over a number": adjoined(TWO | {"times": ["2", "2"]}),
    "lowest order on one leaf": on_one_leaf,
    "a region that the part does not show": part_of_region([]),
}
CUBIC_H = system(CUBIC, "X.toml")["system"]["hamiltonian"]
SHIFTED = ["2*q1^4*u1*u2*a + 8*q1^3*u1*u2*a + 12*q1^2*u1*u2*a + 8*q1*u1*u2*a + 2*u1*u2*a + 2*q1^2*q2^2*u1*u2*a + "
           "4*q1*q2^2*u1*u2*a + 2*q2^2*u1*u2*a + 2*q1^2*q2*u1*u2*a^2 + 4*q1*q2*u1*u2*a^2 + 2*q2*u1*u2*a^2 + "
           "2*q2^4*u1*u2*a + 2*q2^3*u1*u2*a^2 + q2*p1^2*u1*u2 + q2*p2^2*u1*u2 + p1^2*u1*u2*a + p2^2*u1*u2*a", "2"]
CUBIC_TRAPS = {
    "another origin": shifted("q1 + 1", SHIFTED),
    "a denominator of lowest order that is not shown": lambda t: to(step(t, "cubic"), "units", []),
    "another denominator": lambda t: to(step(t, "cubic")["units"][0], "zeros", [["1", "-2"]]),
}
def renamed(v, old, new, names=False):
    """Everything with another name of a parameter, but for the keys of the format; names: the keys are names"""
    if isinstance(v, dict):
        return {new if names and k == old else k: renamed(x, old, new, k == "values") for k, x in v.items()}
    return [renamed(x, old, new) for x in v] if isinstance(v, list) else re.sub(rf"\b{old}\b", new, v) if isinstance(v, str) else v


RIGHT = {**{f"a parameter called {x}": renamed(CUBIC, "a", x) for x in ("_inverse0", "_inverse_0")},
         "small": small(), "small, lowest order with both Casimir functions": changed(small(), lambda t: on_one_leaf(t, 2)),
         "small, a Lagrangian": changed(small(), with_lagrangian(FREE, ENERGY, SPEEDS)),
         "small, a Lagrangian of an inverse": changed(small(), one_lagrangian(["v1^2 + 2*u", "2"], ["p1^2 - 2*u", "2"], [
             ("v1", "p1", "p1")], [("u", "q1")])),
         "small, an inverse of a momentum in the bracket": changed(small(), one_lagrangian(["v1^2", "2"], ["p1^2", "2"], [
             ("v1", "p1", "p1")], [("w", "p1")], bracket="p1*w")),
         "small, a Lagrangian of parameters": changed(small(), one_lagrangian(["A*v1^2 - 2*q1^2", "2"], ["B*p1^2 + 2*q1^2", "2"], [
             ("v1", "p1", "B*p1")], [("B", "A")], ["A"])),
         "small, a parameter": changed(small(), parameters("a")),
         "small, a part of a region": changed(small(), part_of_region(
             [{"node": "empty", "terms": [["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]], "zeros": []}])),
         "small, no functions": changed(small(), lambda t: t["systems"][0]["system"].update(functions=[], relations=[])),
         "small, a root": changed(small(), adjoined({"name": "r", "square": ["2", "3"]})),
         "small, an inverse": changed(small(), adjoined(TWO)),
         "cubic": CUBIC, "cubic, another place": changed(CUBIC, shifted("q1", CUBIC_H))}


def cheated(of, top, changes):
    """Names and certificates that must be refused"""
    for name, change in changes.items():
        false = copy.deepcopy(top)
        change(false)
        yield f"{of}: {name}", json.dumps(false)


def many_nodes(top):
    """What is known is long, and there are many nodes"""
    top["systems"][0]["parameters"] = ["p", "q"]
    top["systems"][0]["assumptions"] = [
        {"p": " + ".join(f"p^{i}*q^{j}" for i in range(10) for j in range(10)), "sign": "positive"}] * 50
    for s in step(top, "y")["shown"]:
        s["by"]["zeros"][0][0] = "50"
    node = top["steps"][-1]["tree"]
    for _ in range(13):
        node = {"node": "zero", "p": "1", "nonzero": node, "zero": node}
    node["zero"] = {"node": "empty", "terms": [], "zeros": []}
    top["steps"][-1]["tree"] = node


def denominators(top):
    """1000 terms whose common denominator has a million digits"""
    step(top, "y")["shown"][0]["by"]["terms"] = [["1/1" + f"{2 * i + 1:01000}", "1"] for i in range(1000)]


def long_powers(top):
    """p/n in p^9999, n with 9999 digits"""
    other, n = copy.deepcopy(top["systems"][0]), "7" * 9999
    other.update(name="X", parameters=["p"])
    top["systems"][0].update(parameters=["p"], assumptions=[{"p": "p^9999", "sign": "nonzero"}])
    top["systems"].append(other)
    for s in step(top, "y")["shown"]:
        s["by"]["zeros"][0][0] = "1"
    z = copy.deepcopy(step(top, "y"))
    z.update(id="z", of="y", system="X", values=z["values"] | {"p": ["p", n]})
    z["shown"] = [{"over": n, "value": n + "*p", "by": {"node": "empty", "terms": [[n, "1"]], "zeros": [["0", "-1"]]}}] * 2
    top["steps"].insert(2, z)
    top["steps"][-1].update(system="X", parts=["z"])


def high_degree(top):
    """p -> p^9000 three times"""
    top["systems"][0]["parameters"] = ["p"]
    y = step(top, "y")
    y["region"] = [{"p": "p", "sign": "nonnegative"}]
    for s in y["shown"]:
        s["by"]["zeros"][0][0] = "1"
    symmetry = {key: y[key] for key in ("system", "adjoined", "back", "bracket", "energy")}
    symmetry |= {"id": "s", "rule": "symmetry", "values": y["values"] | {"p": "p^9000"}, "shown": []}
    top["steps"].insert(2, symmetry)
    top["steps"][-1].update(symmetries=["s"], tree={"node": "part", "part": "0", "word": ["0"] * 3, "shown": [
        {"node": "empty", "terms": [["1", "1"]], "zeros": []}]})


def long_ones():
    """Small files that are much work if it is not counted"""
    for change in (many_nodes, denominators, long_powers, high_degree):
        yield change.__name__, json.dumps(changed(small(), change))


def traps():
    yield from cheated("heavy top", HEAVY, HEAVY_TRAPS)
    yield from cheated("sliding top", SLIDING, SLIDING_TRAPS)
    yield from cheated("small", small(), SMALL_TRAPS)
    yield from cheated("cubic", CUBIC, CUBIC_TRAPS)


def certificates():
    """The quick ones: name, text, is it right?"""
    yield "heavy top", json.dumps(HEAVY), True
    yield from ((name, json.dumps(top), True) for name, top in RIGHT.items())
    for of, top, changes in (("heavy top", HEAVY, HEAVY_TRAPS), ("small", small(), SMALL_TRAPS), ("cubic", CUBIC, CUBIC_TRAPS)):
        yield from ((name, text, False) for name, text in cheated(of, top, changes))
