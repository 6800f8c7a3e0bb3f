"""What kovacic-theorem/1 consists of (docs/theory/theorem_certificates.md 1): types; nothing is judged here."""
from certificate_format import read, right
from first_integrals import IntegralClass
from strata_format import NAME
from system_format import SYSTEM

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
CLASS = {"kind": "text", "near": "text", "on_leaf": "text", "liouville": "text", "functions": ["text"], "without": ["text"],
         "through": ["text"], "frame": "text"}
FAMILIES, STEPS, NODES = 40, 200, 200000


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
