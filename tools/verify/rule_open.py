"""Regions of which nothing is said (docs/theory/theorem_certificates.md 14)."""
from certificate_format import COND, right
from core import Said

FIELDS = {"system": "text", "regions": [[COND]]}


def said(theorem, d):
    x = theorem.family(d)
    right(d["regions"], "a region is expected")
    return Said("O", x, [x.region(rows) for rows in d["regions"]], several=True)
