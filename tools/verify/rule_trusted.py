"""A step that nothing repeats (docs/theory/theorem_certificates.md 14)."""
from certificate_format import right
from core import Said
from theorem_format import COND, read_class

FIELDS = {"system": "text", "says": "text", "step": "text", "regions": [[COND]], "class?": "any"}


def said(theorem, d):
    x = theorem.family(d)
    right(d["says"] in ("integrable", "not integrable") and d["regions"] and 0 < len(d["step"]) <= 4000, "a trusted step")
    no = d["says"] == "not integrable"
    right(no == (d["class"] is not None), "the class of first integrals")
    return Said("N" if no else "J", x, [x.region(rows) for rows in d["regions"]], [read_class(d["class"])] if no else (),
                (), (), [(d["id"], d["step"])], several=True, trusted=d["step"])
