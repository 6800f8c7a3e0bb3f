"""A map of a family to itself (docs/theory/theorem_certificates.md 4)."""
from certificate_format import COND, need
from core import Said
from family import Target
from map import MAP, Map

FIELDS = MAP | {"system": "text", "at?": [["text", "any"]], "region?": [COND]}


def said(theorem, d):
    here = theorem.here(d, True)
    map = Map(here, Target.of(here.family, [], bool(d["adjoined"])), d)
    need(not map.affine, "the origin moves")
    need(all(map.values[v].n == 1 for v in here.family.names.values()), "a number below")
    return Said("S", here.family, [here.conditions()], map=map)
