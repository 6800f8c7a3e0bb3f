"""The same system in all units (docs/theory/theorem_certificates.md 18)."""
from fractions import Fraction

from certificate_format import need, right
from core import Said
from monomials import weight
from multivariate import P

FIELDS = {"of": "text", "system": "text", "parameter": "text", "weights": ["int"]}


def said(theorem, d):
    x, of = theorem.family(d), theorem.proved(d["of"], "N")
    need(of.family is x, "the step says something else")
    need(x.complex == frozenset(x.names.values()), "complex parameters are expected")
    right(d["parameter"] in x.names, "a parameter is expected")
    p, weights = x.names[d["parameter"]], read_weights(x, d["weights"])
    need_homogeneous(x.space, weights)
    need(weights[p] != 0, "the parameter has the weight 0")
    rows = [f for f, sign in of.regions[0] if sign == "zero" and f.variables() == {p}]
    region = [(f, sign) for f, sign in of.regions[0] if not (sign == "zero" and f.variables() == {p})]
    need(len(rows) == 1, "the parameter has no value, or two")
    line = rows[0].coefficients(p)
    need(len(line) == 2 and line[0], "a value other than 0 is expected")
    for f, sign in region + x.assumptions:
        need(sign in ("zero", "nonzero"), "a sign that depends on the units")
        degree(f, weights)
    for c in of.classes:
        need(not (c.functions or c.through or c.without or c.frame) and c.kind != "real-analytic" and c.place != "level",
             "a class that other units may change")
    unit, value = (P({1 << p: 1}), "nonzero"), Fraction(-line[0].constant(), line[1].constant())
    moved = [f"{name} {weights[x.space.at[name]]}" for name in (*x.space.coordinates, *x.parameters) if weights[x.space.at[name]]]
    text = f"in units in which {d['parameter']} = {value}, by the weights {', '.join(moved)}"
    return Said("N", x, [region + [unit] * (unit not in region)], of.classes, of.integrals, way=[*of.way, text],
                shows_way=of.shows_way, there=of.there, names=of.names)


def read_weights(x, rows):
    """By variable: x_i -> s^(w_i) x_i, p_j -> s^(v_j) p_j"""
    space, names = x.space, [*x.space.coordinates, *x.parameters]
    right(len(rows) == len(names) and all(abs(w) <= 1000 for w in rows), "weights up to 1000 are expected, for each name")
    weights = {space.at[name]: 0 for name in space.functions} | {space.at[name]: w for name, w in zip(names, rows)}
    return weights | {u: -degree(h.p, weights) for u, h in space.denominators.items()}


def degree(f, weights):
    """Of each term; others are refused"""
    all = {weight(k, weights) for k in f}
    need(len(all) <= 1, "not homogeneous")
    return max(all, default=0)


def need_homogeneous(space, weights):
    """Each part of the system is, and the bracket or the time as a whole"""
    need(not any(any(g.values()) for g in space.gradients.values()), "a function of the coordinates")
    for f in space.relations:
        degree(f.p, weights)
    at = [weights[space.at[name]] for name in space.coordinates]
    if space.hamiltonian is None:
        shifts = {degree(f.p, weights) - w for f, w in zip(space.field, at) if f.p}
    else:
        degree(space.hamiltonian.p, weights)
        shifts = {degree(f.p, weights) - at[i] - at[j] for i, j, f in space.pairs if f.p}
    need(len(shifts) <= 1, "not homogeneous")
