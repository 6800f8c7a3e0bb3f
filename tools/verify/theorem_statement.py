"""What a certificate of a theorem states, as text (docs/theory/theorem_certificates.md 9, 10)."""
from first_integrals import IntegralClass
from statement import RELATION, polynomial, quoted
from system_statement import function, system_lines

REAL = IntegralClass("real-analytic", "phase space")
ORIGIN = IntegralClass(place="origin")
LEAVES = IntegralClass(place="level")
RIGID = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"
CHECKED, STATED, OPEN = "checked", "part of the statement", "NOT CHECKED"
LITERATURE = {
    "Morales-Ramis": ("Morales-Ruiz and Ramis (2001)", [
        (CHECKED, "the system is Hamiltonian on the leaves of a Poisson structure (S2)"),
        (CHECKED, "the curve is a phase curve and no equilibrium (C4, C5)"),
        (STATED, "the first integrals are meromorphic near the curve, and independent together with the Casimir functions (or on its leaf)")]),
    "Morales-Ramis-Simo": ("Morales-Ruiz, Ramis and Simo (2007)", [
        (CHECKED, "the curve is a phase curve of a Hamiltonian system (J1, J2)"),
        (STATED, "the first integrals are meromorphic near the curve")]),
    "Morales-Ramis, potentials": ("Morales-Ruiz and Ramis on homogeneous potentials (2001)", [
        (CHECKED, "all Darboux points are known; the sum over their eigenvalues, and the table (16)"),
        (STATED, "the first integrals are meromorphic near the phase curves through these points")]),
    "Morales-Ramis-Simo, potentials": ("Morales-Ruiz, Ramis and Simo on homogeneous potentials (2007)", [
        (CHECKED, "a Darboux point is multiple (16)"),
        (STATED, "the first integrals are meromorphic near the phase curve through this point")]),
    "Ziglin, parts": ("Ziglin's lemma on parts of highest or lowest degree (1982)", [
        (CHECKED, "all other terms of the Hamiltonian have lower, or higher, weights (16)"),
        (STATED, "the first integrals are rational")]),
    "Ayoul-Zung": ("Ayoul and Zung (2010)", [
        (CHECKED, "the curve is a phase curve and no equilibrium (C4, C5)"),
        (STATED, "first integrals and commuting vector fields are meromorphic near the curve")]),
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


def first_integrals(classes):
    at_once, fields = "at once " * (len(classes) > 1), "and commuting vector fields " * any(not c.liouville for c in classes)
    *first, last = (c.sentence(len(classes) == 1) for c in classes)
    return f"first integrals {fields}that are {at_once}" + f"{', '.join(first)} and " * bool(first) + last


def conditions(rows, space):
    return ", ".join(f"{polynomial(f, space.names)} {RELATION[sign]}" for f, sign in rows)


def system(family):
    space = family.space
    real, complex = ([x for x, v in family.names.items() if (v in family.complex) == wanted] for wanted in (False, True))
    kinds = [f"{kind} parameters {', '.join(names)}" for kind, names in (("real", real), ("complex", complex)) if names]
    yield f"the system {quoted(family.name)}" + f" with {' and '.join(kinds)}" * bool(kinds)
    for line in system_lines(space, family.data):
        yield "  " + line
    if family.lagrangian:
        yield family.lagrangian.line()
    if family.assumptions:
        yield "  " + conditions(family.assumptions, space)


def place(fact):
    return "; or ".join(f"where {conditions(r, fact.family.space)}" if r else "everywhere" for r in fact.regions)


def integrals(y, claims):
    return [f"first integral {quoted(name)}: {function(f, y.space.names)}" for name, f in claims]


def exception(fact, led):
    """Where it is not said that the system is not integrable; led: does a symmetry lead there?"""
    where = place(fact) + ", or where a symmetry leads there" * bool(led)
    if fact.kind == "O":
        return f"  nothing is said {where}"
    if fact.kind == "J":
        if fact.trusted:
            return f"  TRUSTED: integrable {where}: {quoted(fact.trusted)}"
        (y, claims, fields, not_shown), names = fact.integrals[0], fact.family.space.names
        said = integrals(y, claims) + [f"commuting field ({', '.join(function(f, names) for f in row)})" for row in fields]
        return f"  integrable {where}: {', '.join(said)}" + f" (TRUSTED: {', '.join(not_shown)})" * bool(not_shown)
    text = f"  except possibly {where}"
    for y, claims, level in fact.integrals:
        on = f"; on {', '.join(f'{function(g, y.space.names)} = 0' for g in level)}" if level else ""
        text += f": {', '.join(integrals(y, claims))} (of {'; '.join([quoted(y.name) + on, *fact.way])})"
    return text


def moved(f):
    """Where a symmetry holds, the parameters that it moves and what it adjoins"""
    moves, adjoined = f.map.texts(f.family.parameters)
    said = [f"{x} -> {value}" for x, value in moves] or ["none of the parameters"]
    return f"a symmetry{f' {place(f)}' * bool(f.regions[0])}: {', '.join(said + adjoined)}"


def shown(f):
    """The fact of one step, for a reader"""
    of = f"{quoted(f.family.name)}, {place(f)}" if f.family else "; ".join(f.way)
    claims = ", ".join(quoted(name) for _, rows, *_ in f.integrals for name, _ in rows)
    if f.kind == "S":
        return f"{quoted(f.family.name)}, {moved(f)}"
    if f.kind == "N":
        return f"{of}: " + (f"not integrable with {first_integrals(f.classes)}" if f.classes else "integrable")
    return f"{of}: " + {"L": f"not integrable at {len(f.leaves)} leaves", "O": "nothing is said", "I": f"first integrals {claims}",
                        "J": "integrable" + f" with {claims}" * bool(claims)}[f.kind]


def statement(last, theorem):
    lines = list(system(last.family))
    kinds = {f.kind for f in theorem.parts}
    but = ", but where it is integrable" * ("J" in kinds and bool(last.classes)) + ", but where nothing is said" * ("O" in kinds)
    there = {text: [f for f in theorem.parts if text in f.there] for g in theorem.parts for text in g.there}
    several = len(there) > 1                # each is said of its parts only
    there = ", or ".join(text + f" ({'; or '.join(place(f) for f in parts)})" * several for text, parts in there.items())
    verdict = f"is not integrable{there and f', {there},'} with {first_integrals(last.classes)}" if last.classes else "is integrable"
    lines.append(f"{verdict}, where the denominators are not 0 for all coordinates{but}" + ", if what is marked TRUSTED holds" * bool(last.trusts))
    for f in theorem.parts:
        if f.kind == "N" and f.trusted:
            lines.append(f"  TRUSTED: not integrable with {first_integrals(f.classes)} {place(f)}: {quoted(f.trusted)}")
        elif f.shows_way or any(c.on_leaf for c in f.classes):
            lines.append(f"  {place(f)}: {'; '.join([*f.way, *f.there])}")
    lines += [exception(f, theorem.symmetries if kind == "I" else f in theorem.led) for kind in "JOI" for f in theorem.parts if f.kind == kind]
    lines += [f"  {moved(f)}" for f in theorem.symmetries]
    for name, (title, hypotheses) in LITERATURE.items():
        if name in last.used:
            lines.append(f"given {title}")
            lines += [f"  {how}: {text}" for how, text in hypotheses]
    return lines
