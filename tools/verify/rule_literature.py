"""A theorem of the literature about one family (docs/theory/theorem_certificates.md 9)."""
from certificate_format import need
from core import Said
from family import Family
from theorem_statement import LEAVES, SYMMETRIC_TOP

FIELDS = {"system": "text", "theorem": "text"}


def said(theorem, d):
    need(d["theorem"] == "Ziglin 1983", "an unknown theorem")
    y = theorem.plain_family(d)

    def data(x):
        h, rows = x.space.hamiltonian, [*x.space.denominators.items(), *sorted(x.space.brackets.items())]
        return x.parameters, x.space.coordinates, x.space.at, x.assumptions, h.p, h.n, [(k, f.p, f.n) for k, f in rows]
    need(data(y) == data(Family(SYMMETRIC_TOP)), "not the system of the theorem")
    return Said("N", y, [()], [LEAVES], (), ["Ziglin 1983"])
