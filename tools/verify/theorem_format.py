"""Reads kovacic-theorem/1 (docs/theory/theorem_certificates.md 1): syntax and types; nothing is judged here."""
from certificate_format import need, read, right
from first_integrals import IntegralClass
from strata_format import NAME
from system_format import SYSTEM, complete

FORMAT = "kovacic-theorem/1"
COND = {"p": "text", "sign": "text"}
VELOCITY = {"name": "text", "momentum": "text", "value": "any"}
FAMILY = {"name": "text", "parameters": ["text"], "system": SYSTEM, "assumptions": [COND],
          "lagrangian?": {"value": "any", "velocities": [VELOCITY]}, "complex?": ["text"]}
SHOWN = {"over": "text", "value": "text", "by": "any", "square?": "true"}
CHOSEN = {"chosen": [["any"]], "by": "any"}
ROOT = {"name": "text", "square": "any"}
INVERSE = {"name": "text", "inverse": "text", "times": "text", "norm": "text", "by": "any"}
MAP = {"adjoined": ["any"], "values": "any", "back": [["any"]], "bracket": ["any"], "energy": ["any"], "shown": ["any"]}
CLAIM = {"name": "text", "value": "any", "cofactors": ["any"]}
ORDER = {"inverse": "text", "order": "int", "part": "text", "by": "any"}
RULES = {"certificate": {"certificate": "any"},
         "leaf": {"of": "text", "leaf": "int"},
         "literature": {"system": "text", "theorem": "text"},
         "integrals": {"system": "text", "claims": [CLAIM], "level": ["any"]},
         "splitting": {"system": "text", "moments": ["text"], "small": ["text"], "order": "int", "first": "text",
                       "power": "int", "region": [COND], "proof": "any"},
         "place": {"of": "text", "system": "text", "at": [["any"]], "region": [COND], "shown": ["any"], "levels?": [["any"]]},
         "symmetry": MAP | {"system": "text", "at?": [["any"]], "region?": [COND]},
         "lowest-order": {"of": "text", "system": "text", "weights": ["int"], "degree": "int", "units": ["any"],
                          "orders": [ORDER]},
         "integrable": {"system": "text", "at": [["any"]], "region": [COND], "claims": [{"name": "text", "value": "any"}],
                        "fields": [["any"]], "independent": "any", "rank": "any"},
         "darboux": {"system": "text", "at": [["any"]], "region": [COND], "coordinates": ["text"], "momenta": ["text"],
                     "part": "text", "degree": "int", "chart": ["int"], "says": "text", "unit": "text", "proper": "text",
                     "rest": "text", "improper?": "any", "isotropic": "any", "zeros": ["any"], "shown": ["any"],
                     "choices": ["any"]},
         "common-values": {"system": "text", "of": ["text"], "leaves": ["int"], "at": [["any"]], "region": [COND], "shown": [["any"]],
                           "function": {"num": "text", "den": "text"}, "bound": "int", "gap": "text", "by?": "any", "levels?": [[["any"]]]},
         "trusted": {"system": "text", "says": "text", "step": "text", "regions": [[COND]], "class?": "any"},
         "open": {"system": "text", "regions": [[COND]]},
         "cover": {"system": "text", "symmetries": ["text"], "parts": ["text"], "tree": "any"}}
CLASS = {"kind": "text", "near": "text", "on_leaf": "text", "liouville": "text", "functions": ["text"], "without": ["text"],
         "through": ["text"], "frame": "text"}
FAMILIES, STEPS, NODES = 40, 200, 200000


def read_theorem(top):
    top = read({"format": "text", "title": "text", "systems": [FAMILY], "steps": ["any"]}, top, "certificate")
    right(len(top["systems"]) <= FAMILIES and 1 <= len(top["steps"]) <= STEPS, "too many systems or steps")
    names = [s["name"] for s in top["systems"]]
    right(len(set(names)) == len(names), "a system occurs twice")
    for family in top["systems"]:
        complete(family["system"], family["parameters"])
    top["steps"] = [read_step(v) for v in top["steps"]]
    return top


def read_step(v):
    rule = v.get("rule") if isinstance(v, dict) else None
    right(isinstance(rule, str), "a rule is expected")
    need(rule in RULES, "an unknown rule")
    more = MAP if rule == "place" and "values" in v else {}         # without: by names
    d = read(RULES[rule] | more | {"id": "text", "rule": "text"}, v, rule)
    right(not more or d["levels"] is None, "a level of a map that has values")
    return d


def read_adjoined(v):
    return read(ROOT if isinstance(v, dict) and "square" in v else INVERSE, v, "adjoined")


def read_class(v):
    d, truth = read(CLASS, v, "class"), {"yes": True, "no": False}
    right(d["kind"] in ("rational", "meromorphic", "real-analytic"), "an unknown word")
    right(d["near"] in ("curve", "closed curve", "origin", "phase space"), "an unknown word")
    right(d["kind"] != ("meromorphic" if d["near"] == "phase space" else "real-analytic"),
          "real-analytic functions are those on the phase space, meromorphic ones are not")
    right(d["on_leaf"] in truth and d["liouville"] in truth, "an unknown word")
    right(all(NAME.match(x) for key in ("functions", "without", "through") for x in d[key]), "a name is expected")
    right(all(" " <= x <= "~" for x in d["frame"]), "one line is expected")
    return IntegralClass(d["kind"], d["near"], truth[d["on_leaf"]], *(tuple(d[key]) for key in ("functions", "without", "through")),
                         d["frame"], truth[d["liouville"]])
