"""The lowest-order system of a family (docs/theory/theorem_certificates.md 7)."""
from certificate_format import need, right
from core import Said
from monomials import parts, weight
from multivariate import FIELD, ONE, parse
from phase_space import Function
from theorem_statement import ORIGIN, REAL
from tower import compose, variable

ORDER = {"inverse": "text", "order": "int", "part": "text", "by": "any"}
FIELDS = {"of": "text", "system": "text", "weights": ["int"], "degree": "int", "units": ["any"], "orders": [ORDER]}


def said(theorem, d):
    x, of = theorem.plain_family(d), theorem.proved(d["of"], "N")
    need(of.family is not None and of.family.is_plain(), "the step is about a system of a certificate")
    kept = [c for c in of.classes if not c.has_rational()]
    need(set(kept) <= {REAL}, "a class that parts of lowest order need not have")
    region = region_of(x, of.family, d, of.regions[0])
    return Said("N", x, [region], [*kept, ORIGIN], of.integrals, ["Ziglin 1982"])


def region_of(X, Y, d, region):
    """Checks that Y is the lowest-order system of X; conditions on the parameters of Y in the names of X"""
    space, other, given = X.space, Y.space, X.where(X.assumptions)
    weights = d["weights"]
    right(len(weights) == len(space.coordinates) and all(1 <= w <= 1000 for w in weights), "weights of 1 to 1000 are expected")
    right(all(0 <= k <= 10**6 for k in (d["degree"], *(row["order"] for row in d["orders"]))), "a degree or an order is out of range")
    need(space.coordinates == other.coordinates and X.parameters == Y.parameters, "other names")
    need(X.data["brackets"] == Y.data["brackets"], "another bracket")
    need(len(space.names) + len(other.inverses) <= 64, "too many names")
    names = {v: variable(space.at[x] if x in (*other.coordinates, *Y.parameters) else FIELD * (len(space.names) + other.inverses.index(x)))
             for x, v in other.at.items()}

    def moved(f):
        return compose(f, names)

    def conditions(rows):
        return [(moved(Function(f)).p, sign) for f, sign in rows]
    need(all(condition in X.assumptions for condition in conditions(Y.assumptions)), "it assumes more")
    at = {FIELD * j: w for j, w in enumerate(weights)}
    inverses = {space.at[u] for u in space.inverses}
    shifts = {weights[i] + weights[j] - weight(k, at) for (i, j), f in space.brackets.items() for k in f.p}
    need(len(shifts) <= 1 and not any(f.p.variables() & inverses for f in space.brackets.values()), "the bracket mixes orders")
    need(all(weight(k, at) == d["degree"] for k in other.hamiltonian.p), "not homogeneous")
    need(not any(h.p.variables() & set(at) for h in other.denominators.values()), "not a polynomial")
    right(len(d["units"]) == len(other.inverses), "a node for each denominator is expected")
    for h, by in zip(other.denominators.values(), d["units"]):
        given.show(moved(h).p, "nonzero", by)
    right([row["inverse"] for row in d["orders"]] == space.inverses, "an order for each inverse is expected")
    bound = d["degree"]
    difference = space.hamiltonian - moved(other.hamiltonian)
    for row in d["orders"]:
        u, part, h = space.at[row["inverse"]], parse(row["part"], X.names), space.denominators[space.at[row["inverse"]]]
        need(all(weight(k, at) >= row["order"] for k in h.p), "an order is another one")
        need(any(weight(k, at) == row["order"] and f == part for k, f in parts(h.p, at).items()), "no such part of lowest order")
        given.show(part, "nonzero", row["by"])
        bound += max(0, difference.p.degree(u)) * row["order"]
    f = space.cleared(difference).p
    for v, h in other.denominators.items():
        u = max(names[v].p.variables())
        f = f.substitute(u, moved(h).p, ONE * -1, max(f.degree(u), 0))
    need(all(weight(k, at) > bound for k in f), "another system of lowest order")
    return conditions(region)
