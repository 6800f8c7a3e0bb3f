"""Reads kovacic-system/1 (docs/theory/system_certificates.md 2): syntax, types and sizes; nothing is judged here."""
from certificate_format import NAME, read, right
from multivariate import parse

FORMAT = "kovacic-system/1"
ANNIHILATOR = {"row": ["any"], "matrix": ["any"]}
SYSTEM = {"coordinates": ["text"], "functions?": [{"name": "text", "meaning": "text", "gradient": "any"}],
          "inverses?": [{"name": "text", "of": "text"}], "relations?": ["text"],
          "hamiltonian?": "any", "brackets?": [["any"]], "field?": ["any"]}
CURVE = {"manifold": "text", "equations": ["any"], "levels": ["any"], "variable": "text", "change": "any",
         "denominators": ["text"], "tower": [{"name": "text", "degree": "int", "value": "any", "derivative": "any"}],
         "values": "any", "time": "any"}
NORMAL = {"annihilators": [ANNIHILATOR], "row": ["any"], "p": "any", "q": "any", "rest": ["any"], "vectors": [["any"]]}
ROWS = {"annihilators": [ANNIHILATOR], "rows": [["any"]], "rest": [["any"]], "vectors": [["any"]], "whole?": "true"}
TOP = {"format": "text", "title": "text", "parameters": ["text"], "system": SYSTEM,
       "claims?": [{"kind": ("integral", "casimir"), "name": "text", "value": "any", "cofactors?": [["any"]]}],
       "curve": CURVE, "normal": "any", "equation": {"certificate": "any", "root?": "any"},
       "claim": {"not_integrable": "truth"}}
PARAMETERS, PHASE, TOWER, COORDINATES, DEGREES = 12, 64, 32, 40, 64
EXPONENT, DENOMINATORS, ANNIHILATORS, DIGITS = 1000, 200, 40, 10000


def complete(system, parameters, field=()):
    """Coordinates, functions, inverses, parameters; z, parameters, tower: each different names, not too many"""
    for key in ("functions", "inverses", "relations"):
        system[key] = system[key] or []
    given = [system[key] is not None for key in ("hamiltonian", "brackets", "field")]
    right(given in ([True, True, False], [False, False, True]), "a Hamiltonian with brackets, or a field, is expected")
    phase = [*system["coordinates"], *(f["name"] for f in system["functions"]),
             *(u["name"] for u in system["inverses"]), *parameters]
    for names in (phase, field):
        right(all(map(NAME.match, names)) and len(set(names)) == len(names), "different names are expected")
    right(len(parameters) <= PARAMETERS and len(phase) <= PHASE, "too many names")
    right(1 <= len(system["coordinates"]) <= COORDINATES, "1 to 40 coordinates are expected")


def read_system(v):
    """The certificate, its names and its numbers of things in their limits."""
    top = read(TOP, v, "certificate")
    system, curve, normal = top["system"], top["curve"], top["normal"]
    several = isinstance(normal, dict) and "rows" in normal
    top["normal"] = normal = read(ROWS if several else NORMAL, normal, "normal")
    top["claims"] = top["claims"] or []
    complete(system, top["parameters"], [curve["variable"], *top["parameters"], *(w["name"] for w in curve["tower"])])
    right(len(curve["tower"]) <= TOWER, "too many names in the tower")
    right(len(curve["denominators"]) <= DENOMINATORS, "too many denominators")
    right(len(normal["annihilators"]) <= ANNIHILATORS, "too many annihilators")
    return top


def entries(v, names, what):
    """An object with these names as keys"""
    right(isinstance(v, dict) and set(v) <= set(names), f"{what}: an object with other keys")
    return v


def fraction(v, names, more=0):
    """P or [P, n, e_1, ...] with at most `more` exponents: the polynomial, n and the exponents."""
    v = v if isinstance(v, list) else [v, "1"]
    right(2 <= len(v) <= 2 + more and all(isinstance(x, str) for x in v), "a polynomial over a number is expected")
    right(len(v[1]) <= DIGITS, "a number is too long")
    n, *es = (read("int", x, "a number") for x in v[1:])
    right(n >= 1 and all(0 <= e <= EXPONENT for e in es), "a number is out of range")
    return parse(v[0], names), n, es + [0] * (more - len(es))
