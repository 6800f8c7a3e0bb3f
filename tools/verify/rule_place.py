"""The fact of another system, carried over by a map (docs/theory/theorem_certificates.md 4, 12)."""
from certificate_format import COND, need
from core import Said
from family import Target
from map import Map, carried

FIELDS = {"of": "text", "system": "text", "at": [["text", "any"]], "region": [COND], "shown": ["any"], "levels?": [["text", "any"]]}


def said(theorem, d):
    """The fact of another system: by the values of its names, or by the same names and some levels"""
    by_names = "values" not in d
    here, of = theorem.here(d, not by_names), theorem.proved(d["of"], "N", *["I"] * (not by_names))
    if by_names:
        need(of.target is not None, "the step says something else")
        d = d | {"levels": theorem.put(d["levels"] or [], here.free)}
    else:
        need(not of.only_stratum and (of.family is None or of.family.is_plain()), "another class")
    map = Map(here, of.target or Target.of(of.family, of.regions[0], of.kind == "N"), d)
    there = theorem.functions_there(of, here) if by_names else of.there
    return Said(of.kind, here.family, [here.conditions()], [carried(c, map) for c in of.classes], of.integrals, (), (),
                [*of.way, *([] if by_names else there), *map.shown()], shows_way=by_names or of.shows_way, there=there if by_names else ())
