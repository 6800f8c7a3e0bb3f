"""One leaf of a certificate that says "not abelian", where it says so (docs/theory/theorem_certificates.md 5)."""
from certificate_format import need
from core import Said

FIELDS = {"of": "text", "leaf": "int"}


def said(theorem, d):
    of = theorem.fact(d["of"], "N", "L")
    need(0 <= d["leaf"] < len(of.leaves), "no such leaf")
    target, trust, excluded = of.leaves[d["leaf"]]
    need(not trust, "a leaf on trust")
    return Said("N", None, [()], [excluded()], (), (), (), of.way, target=target, there=of.there, names=of.names)
