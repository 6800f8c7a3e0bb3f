"""What a certificate of a theorem states, as text (docs/theory/theorem_certificates.md 9, 10)."""
from first_integrals import IntegralClass
from statement import RELATION, polynomial, quoted
from system_statement import function

REAL = IntegralClass("real-analytic", "phase space")
ORIGIN = IntegralClass(place="origin")
LEAVES = IntegralClass(place="level")
RIGID = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"
CHECKED, STATED, OPEN = "checked", "part of the statement", "NOT CHECKED"
LITERATURE = {
    "Morales-Ramis": ("Morales-Ruiz and Ramis (2001)", [
        (CHECKED, "the system is Hamiltonian on the leaves of a Poisson structure (S2)"),
        (CHECKED, "the curve is a phase curve and no equilibrium (C4, C5)"),
        (STATED, "the first integrals are meromorphic near the curve, and independent on the symplectic leaf that carries it")]),
    "Ziglin 1980": ("Ziglin on the splitting of separatrices (1980)", [
        (CHECKED, "hypotheses 1 to 6, for a perturbation of the Euler top (Z1 to Z3)"),
        (STATED, "the first integral is real-analytic near the closure of the orbit")]),
    "Ziglin 1982": ("Ziglin's lemma on lowest-order parts (1982)", [
        (CHECKED, "the bracket and the lowest-order terms are weight-homogeneous (7)"),
        (STATED, "the first integrals are meromorphic near the origin")]),
    "Ziglin 1983": ("Ziglin on the symmetric heavy top (1983)", [
        (STATED, "the first integrals are meromorphic on the leaves with F2 = 0"),
        (OPEN, "first integrals that are independent are so on the leaves with F2 = 0")])}

# In the order of the names here: coordinates, inverses, parameters
COORDINATES = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
SYMMETRIC_TOP = {
    "name": "Ziglin 1983", "parameters": ["A", "C", "L1", "L2", "L3"],
    "system": {"coordinates": COORDINATES, "functions": [], "relations": [], "field": None,
               "inverses": [{"name": "u1", "of": "C"}, {"name": "u2", "of": "A"}],
               "hamiltonian": ["M1^2*u1*u2*C + M2^2*u1*u2*C + M3^2*u1*u2*A + 2*Gamma1*u1*u2*A*C*L1 + "
                               "2*Gamma2*u1*u2*A*C*L2 + 2*Gamma3*u1*u2*A*C*L3", "2"],
               "brackets": [["M1", "M2", "-M3"], ["M1", "M3", "M2"], ["M1", "Gamma2", "-Gamma3"], ["M1", "Gamma3", "Gamma2"],
                            ["M2", "M3", "-M1"], ["M2", "Gamma1", "Gamma3"], ["M2", "Gamma3", "-Gamma1"],
                            ["M3", "Gamma1", "-Gamma2"], ["M3", "Gamma2", "Gamma1"]]},
    "assumptions": [{"p": "A", "sign": "positive"}, {"p": "C", "sign": "positive"},
                    {"p": "L1^2 + L2^2", "sign": "positive"}, {"p": "A - C", "sign": "nonzero"},
                    {"p": "A^2 - 4*A*C + 4*C^2 + L3^2", "sign": "positive"},
                    {"p": "A^2 - 8*A*C + 16*C^2 + L3^2", "sign": "positive"}]}


def enumerated(texts):
    *first, last = texts
    return f"{', '.join(first)} and {last}" if first else last


def conditions(rows, space):
    return ", ".join(f"{polynomial(f, space.names)} {RELATION[sign]}" for f, sign in rows)


def system(family):
    space = family.space
    pairs = [f"{{{space.coordinates[i]}, {space.coordinates[j]}}} = {function(f, space.names)}" for i, j, f in space.pairs]
    yield f"the system {quoted(family.name)}" + f" with real parameters {', '.join(family.parameters)}" * bool(family.parameters)
    yield "  " + ", ".join([*pairs, f"H = {function(space.hamiltonian, space.names)}"])
    for u in space.inverses:
        yield f"  {u} = 1/({polynomial(space.denominators[space.at[u]].p, space.names)})"
    if family.lagrangian:
        yield family.lagrangian.line()
    if family.assumptions:
        yield "  " + conditions(family.assumptions, space)


def place(fact):
    return f"where {conditions(fact.region, fact.family.space)}" if fact.region else "everywhere"


def exception(fact, symmetries):
    where = place(fact)
    text = f"  except possibly {where}" + ", or where a symmetry leads there" * bool(symmetries)
    for y, claims, level in fact.integrals:
        said = [f"first integral {quoted(name)}: {function(f, y.space.names)}" for name, f in claims]
        on = f"; on {', '.join(f'{function(g, y.space.names)} = 0' for g in level)}" if level else ""
        text += f": {', '.join(said)} (of {'; '.join([quoted(y.name) + on, *fact.way])})"
    return text


def statement(last, theorem):
    lines = list(system(last.family))
    at_once = "at once " * (len(last.classes) > 1)
    lines.append(f"is not integrable with first integrals that are {at_once}{enumerated(c.sentence() for c in last.classes)}, "
                 "where the denominators are not 0 for all coordinates")
    lines += [f"  {place(f)}: {'; '.join(f.way)}" for f in theorem.parts if any(c.on_leaf for c in f.classes)]
    lines += [exception(f, theorem.symmetries) for f in theorem.parts if f.kind == "I"]
    for f in theorem.symmetries:
        space, map = f.family.space, f.map
        moved = [f"{x} -> {function(map.values[v], space.names)}" for x, v in f.family.names.items()
                 if map.values[v].p != {1 << v: 1}]
        lines.append(f"  a symmetry: {', '.join(moved) or 'none of the parameters'}")
    for name, (title, hypotheses) in LITERATURE.items():
        if name in last.used:
            lines.append(f"given {title}")
            lines += [f"  {how}: {text}" for how, text in hypotheses]
    return lines
