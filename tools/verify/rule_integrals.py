"""First integrals of a family, or of a level of functions (docs/theory/theorem_certificates.md 5)."""
from certificate_format import right
from core import Said
from phase_space import total

CLAIM = {"name": "text", "value": "any", "cofactors": ["any"]}
FIELDS = {"system": "text", "claims": [CLAIM], "level": ["any"]}


def said(theorem, d):
    y = theorem.family(d)
    space = y.space
    right(d["claims"], "nothing is claimed")
    level = [space.read(v) for v in d["level"]]
    for g in level:
        space.need_zero(along_field(space, g), "the level is not invariant")
    lines = []
    for claim in d["claims"]:
        f, cofactors = space.read(claim["value"]), [space.read(v) for v in claim["cofactors"]]
        right(len(cofactors) == len(level), "a cofactor for each function of the level is expected")
        rest = along_field(space, f) - total(c * g for c, g in zip(cofactors, level))
        space.need_zero(rest, "not a first integral")
        lines.append((claim["name"], f))
    return Said("I", y, [()], (), [(y, lines, level)])


def along_field(space, f):
    return total(x * space.d(f, j) for j, x in enumerate(space.field))
