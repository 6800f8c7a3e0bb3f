"""Certificates of theorems: what `kovacic prove` wrote (data/theorem), and beside each rule of
docs/theory/theorem_certificates.md ways to cheat that a plausible mistake in it would accept.  certificates() yields what is
stated, the text and whether it is right."""
import copy
import json
import os

HERE = os.path.dirname(os.path.abspath(__file__))


def read(name):
    with open(os.path.join(HERE, "data/theorem", name + ".json"), encoding="utf-8") as f:
        return json.load(f)


HEAVY, SLIDING = read("heavy_top"), read("sliding_top")


def step(top, name):
    return next(s for s in top["steps"] if s["id"] == name)


def system(top, name):
    return next(s for s in top["systems"] if s["name"] == name)


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
    """L + M1 Omega2 - M2 Omega1 has the same energy, and its derivatives are no functions of the velocities alone"""
    l = lagrangian(top)
    value, n = l["value"]
    l["value"] = [f"{value} + {n}*M1*Omega2 - {n}*M2*Omega1", n]


def cubic_lagrangian(top):
    l = lagrangian(top)
    value, n = l["value"]
    l["value"] = [f"{value} + {n}*Omega1^3", n]


HEAVY_TRAPS = {
    # signs
    "a leaf without what is strict": lambda t: [to(n, "terms", []) for n in nodes(tree(t), "empty")][:1],
    "a term of sign unknown": lambda t: to(first_empty(t)["terms"][0][2], 1, "1"),
    "a negative factor": lambda t: to(first_empty(t)["terms"][0], 0, "-2"),
    "a sum that is not 0": lambda t: to(first_empty(t)["terms"][0], 0, "3"),
    "a condition that is no equation": lambda t: to(first_empty(t)["zeros"][0], 0, "0"),
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
    "an unknown theorem": lambda t: to(step(t, "symmetric-step"), "theorem", "Ziglin 1982"),
    # integrals
    "no integral": lambda t: to(step(t, "lagrange-step")["claims"][0], "value", "M1"),
    "a forgotten level": forgotten_level,
    "a level that is not invariant": moved_level,
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


def cheated(of, top, changes):
    """Names and certificates that must be refused"""
    for name, change in changes.items():
        false = copy.deepcopy(top)
        change(false)
        yield f"{of}: {name}", json.dumps(false)


def traps():
    yield from cheated("heavy top", HEAVY, HEAVY_TRAPS)
    yield from cheated("sliding top", SLIDING, SLIDING_TRAPS)


def certificates():
    """The quick ones: name, text, is it right?"""
    yield "heavy top", json.dumps(HEAVY), True
    yield from ((name, text, False) for name, text in cheated("heavy top", HEAVY, HEAVY_TRAPS))
