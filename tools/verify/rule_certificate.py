"""The certificate of one system, or of higher variational equations (docs/theory/theorem_certificates.md 5)."""
from functools import partial

import jets
import strata
import system
from certificate_format import need, right
from core import Said
from family import Target
from first_integrals import IntegralClass, casimirs, integrals
from multivariate import FIELD, P, parse
from phase_space import Function, PhaseSpace
from statement import quoted
from system_format import read_system
from system_statement import Shown

FIELDS = {"certificate": "any"}


def said(theorem, d):
    if isinstance(d["certificate"], dict) and d["certificate"].get("format") == jets.FORMAT:
        return of_jets(d["certificate"], theorem.prove)
    right(isinstance(d["certificate"], dict) and d["certificate"].get("format") == system.FORMAT, "another format")
    top = read_system(d["certificate"])
    curve, claims, inner = system.accept(top, theorem.prove)
    everywhere = not inner.trust and top["claim"]["not_integrable"]
    need(everywhere or inner.denials or inner.criteria, "no leaf says \"not abelian\"")
    excluded = integrals(curve, inner.denials + [x for x, _ in inner.criteria], casimirs(claims))
    only = curve.space.brackets is None or bool(excluded.functions or excluded.without)
    target = Target(curve.space, top["parameters"], list(asked(top, curve)), curve)
    shown = Shown(curve)
    way, (there, names) = [f"{shown.phase_curve(top)} of {quoted(top['title'])}"], shown.functions_explained()
    used = "Ayoul-Zung" if curve.space.brackets is None or any(x.whole for x in inner.denials) else "Morales-Ramis"
    at = {x: curve.space.at[x] for x in top["parameters"]}

    def leaf(x, more):
        path = [(Function(parse(text, at)), says) for text, says in x.path]
        there = Target(curve.space, top["parameters"], target.conditions + path, curve)
        return there, more, partial(integrals, curve, [x], casimirs(claims))
    leaves, criteria = [leaf(x, x.trust) for x in inner.denials], [leaf(*x) for x in inner.criteria]
    return Said("N" if everywhere else "L", None, [()], [excluded], (), [used], (), way, target=target, only_stratum=only,
                there=there, names=names, leaves=leaves, criteria=criteria)


def of_jets(certificate, prove):
    """Of higher variational equations: canonical coordinates"""
    d, orders, group = jets.accept(certificate, prove)
    need(not group.trust, "not without trust")
    need(not d["constants"], "an algebraic constant among the parameters")
    q, p = d["system"]["coordinates"], d["system"]["momenta"]
    phase = {"coordinates": [*q, *p], "functions": [], "inverses": [], "relations": [], "field": None,
             "hamiltonian": d["system"]["hamiltonian"], "brackets": [[x, y, "1"] for x, y in zip(q, p)]}
    space, e = PhaseSpace(phase, d["parameters"]), d["variables"][0]
    names, value = {x: space.at[x] for x in d["parameters"]}, d["obstruction"]["value"]
    groups = [(Function(parse(text, names)), "nonzero") for text in d["denominators"]]
    groups.append(coefficients(value if isinstance(value, str) else value[0], names, e))
    way = [f"VE_{orders.order} along a line of {quoted(d['title'])}"]
    return Said("N", None, [()], [IntegralClass()], (), ["Morales-Ramis-Simo"], (), way,
                target=Target(space, d["parameters"], groups), only_stratum=True)


def coefficients(text, names, z):
    """Not all of those in z are 0."""
    rows = parse(text, names | {z: FIELD * 100}).coefficients(FIELD * 100)
    return [Function(f) for f in rows or [P()]], "some"


def asked(top, curve):
    """What the certificate asks of a point"""
    names, inner = {x: curve.space.at[x] for x in top["parameters"]}, top["equation"]["certificate"]
    if inner["format"] == strata.FORMAT:
        need(not inner.get("memberships") and not inner.get("rational"), "memberships are not looked at here")
        need(set(inner["parameters"]) <= set(names), "an algebraic constant among the parameters")
        for x in inner["real"]:
            yield Function(parse(x, names)), "real"
        for c in inner["assumptions"]:
            yield Function(parse(c["p"], names)), c["sign"]
        for group in inner["generic"]:
            yield [Function(parse(text, names)) for text in group], "some"
        yield coefficients(inner["r"]["den"], names, inner["variable"])
    for text in top["curve"]["denominators"]:
        yield coefficients(text, names, curve.variable)
