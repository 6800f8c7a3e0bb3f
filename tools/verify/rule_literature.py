"""A theorem of the literature about one family (docs/theory/theorem_certificates.md 9)."""
from certificate_format import need
from core import Said
from family import Family
from theorem_statement import LEAVES, SYMMETRIC_TOP

FIELDS = {"system": "text", "theorem": "text"}


def said(theorem, d):
    need(d["theorem"] == "Ziglin 1983", "an unknown theorem")
    y, known = theorem.plain_family(d), Family(SYMMETRIC_TOP)
    same = y.data["coordinates"] == known.data["coordinates"] and y.parameters == known.parameters and \
        y.space.at == known.space.at and y.space.hamiltonian.p == known.space.hamiltonian.p and \
        y.space.hamiltonian.n == known.space.hamiltonian.n and y.assumptions == known.assumptions and \
        {u: h.p for u, h in y.space.denominators.items()} == {u: h.p for u, h in known.space.denominators.items()} and \
        {k: f.p for k, f in y.space.brackets.items()} == {k: f.p for k, f in known.space.brackets.items()} and \
        all(f.n == 1 for f in y.space.brackets.values())
    need(same, "not the system of the theorem")
    return Said("N", y, [()], [LEAVES], (), ["Ziglin 1983"])
