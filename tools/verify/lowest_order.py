"""The lowest-order system of a family (docs/theory/theorem_certificates.md 7)."""
from certificate_format import need
from multivariate import FIELD, MASK, P, parse
from system_format import right


def lowest_order(X, Y, d):
    """Checks that Y is the lowest-order system of X."""
    space, other, given = X.space, Y.space, X.where(X.assumptions)
    weights = d["weights"]
    right(len(weights) == len(space.coordinates) and all(w >= 1 for w in weights), "weights of 1 or more are expected")
    need(space.coordinates == other.coordinates and X.parameters == Y.parameters, "other names")
    need(X.data["brackets"] == Y.data["brackets"], "another bracket")
    theirs = [(parse_again(f, Y, X), sign) for f, sign in Y.assumptions]
    need(all(condition in X.assumptions for condition in theirs), "it assumes more")
    places = [FIELD * j for j in range(len(weights))]

    def weight(k):
        return sum(w * (k >> x & MASK) for w, x in zip(weights, places))

    def monomial(k):
        return tuple(k >> x & MASK for x in places)
    inverses = {space.at[u] for u in space.inverses}
    shifts = {weights[i] + weights[j] - weight(k) for (i, j), f in space.brackets.items() for k in f.p}
    need(len(shifts) <= 1 and not any(f.p.variables() & inverses for f in space.brackets.values()), "the bracket mixes orders")
    need(all(weight(k) == d["degree"] for k in other.hamiltonian.p), "not homogeneous")
    need(not any(monomial(k) != (0,) * len(places) for h in other.denominators.values() for k in h.p), "not a polynomial")
    right(len(d["units"]) == len(other.inverses), "a node for each denominator is expected")
    for u, by in zip(other.inverses, d["units"]):
        given.show(parse_again(other.denominators[other.at[u]].p, Y, X), "nonzero", by)
    right([row["inverse"] for row in d["orders"]] == space.inverses, "an order for each inverse is expected")
    bound = d["degree"]
    difference = space.hamiltonian - moved(other.hamiltonian, Y, X)
    for row in d["orders"]:
        u, part, h = space.at[row["inverse"]], parse(row["part"], X.names), space.denominators[space.at[row["inverse"]]]
        need(all(weight(k) >= row["order"] for k in h.p), "an order is another one")
        parts = {}
        for k, c in h.p.items():
            if weight(k) == row["order"]:
                rest = k - sum(e << x for e, x in zip(monomial(k), places))
                parts.setdefault(monomial(k), {})[rest] = c
        need(any(P(rest) == part for rest in parts.values()), "no such part of lowest order")
        given.show(part, "nonzero", row["by"])
        bound += max(0, difference.p.degree(u)) * row["order"]
    f = difference
    for u, h in [*space.denominators.items(), *((other_place(v, Y, X), moved(g, Y, X)) for v, g in other.denominators.items())]:
        n = f.p.degree(u)
        if n > 0:
            f = f.__class__(f.p.substitute(u, h.p, P({0: -1}), n), f.n)
    need(all(weight(k) > bound for k in f.p), "another system of lowest order")


def other_place(v, Y, X):
    """An inverse of Y, beside the names of X"""
    if v in Y.names.values():
        return X.names[Y.parameters[[Y.names[x] for x in Y.parameters].index(v)]]
    if v // FIELD < len(Y.space.coordinates):
        return v
    return FIELD * (len(X.space.names) + v // FIELD - len(Y.space.coordinates))


def moved(f, Y, X):
    """f of Y in the names of X"""
    need(len(X.space.names) + len(Y.space.inverses) <= 64, "too many names")
    return f.__class__(parse_again(f.p, Y, X), f.n)


def parse_again(f, Y, X):
    """The polynomial with the names of X"""
    places = {v: other_place(v, Y, X) for v in f.variables()}
    return P((sum((k >> v & MASK) << w for v, w in places.items()), c) for k, c in f.items())
