"""A step that nothing repeats (docs/theory/theorem_certificates.md 14)."""
from certificate_format import COND, NAME, read, right
from core import Said
from first_integrals import IntegralClass

FIELDS = {"system": "text", "says": ("integrable", "not integrable"), "step": "text", "regions": [[COND]], "class?": "any"}
CLASS = {"kind": ("rational", "meromorphic", "real-analytic"), "near": ("curve", "closed curve", "origin", "phase space"),
         "on_leaf": ("yes", "no"), "liouville": ("yes", "no"), "functions": ["text"], "without": ["text"], "through": ["text"],
         "frame": "text"}


def read_class(v):
    d = read(CLASS, v, "class")
    right(d["kind"] != ("meromorphic" if d["near"] == "phase space" else "real-analytic"),
          "real-analytic functions are those on the phase space, meromorphic ones are not")
    right(all(NAME.match(x) for key in ("functions", "without", "through") for x in d[key]), "a name is expected")
    right(all(" " <= x <= "~" for x in d["frame"]), "one line is expected")
    names = (tuple(d[key]) for key in ("functions", "without", "through"))
    return IntegralClass(d["kind"], d["near"], d["on_leaf"] == "yes", *names, d["frame"], d["liouville"] == "yes")


def said(theorem, d):
    x = theorem.family(d)
    right(d["regions"] and 0 < len(d["step"]) <= 4000, "a trusted step")
    no = d["says"] == "not integrable"
    right(no == (d["class"] is not None), "the class of first integrals")
    return Said("N" if no else "J", x, [x.region(rows) for rows in d["regions"]], [read_class(d["class"])] if no else (),
                (), (), [(d["id"], d["step"])], several=True, trusted=d["step"])
