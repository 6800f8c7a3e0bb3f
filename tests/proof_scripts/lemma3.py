"""Lemma 3: the sliding top without gravity, body symmetric (A, A, C), L perpendicular to its axis, is integrable
in Liouville's sense with meromorphic first integrals only if C = A.      Run it: tools/python lemma3.py"""

import kovacic
from kovacic import ManifoldReport, StrataAnswer, Stratum, Truth, VerdictKind

TOP = """
assume   = {A = "positive", C = "positive"}
casimir  = [{name = "F1", value = "Gamma1^2 + Gamma2^2 + Gamma3^2"},
            {name = "F2", value = "M1*Gamma1 + M2*Gamma2 + M3*Gamma3"}]
manifold = [{name = "M", equations = ["M2 = 0", "M3 = 0", "Gamma1 = 0"], level = ["F1 = 1", "M1 = mu"]}]
reduce   = {manifold = "M", variable = "M2", change = "z = Gamma3^2"}
[system]
kind             = "lagrangian"
coordinates      = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]
angular_velocity = ["Omega1", "Omega2", "Omega3"]
parameters       = ["A", "C", "mu"]
lagrangian       = "(A*Omega1^2 + A*Omega2^2 + C*Omega3^2)/2 + (Gamma2*Omega3 - Gamma3*Omega2)^2/2"
"""

top = kovacic.check(TOP)
assert all(claim.proved is Truth.yes for claim in top.claims)
match top.manifolds:
    case [ManifoldReport(VerdictKind.depends, not_checked=None, blocks=[block])]:
        assert top.assumptions == ["A positive", "C positive"] and block.unknown == "M2"
match block.answer:
    case StrataAnswer(strata, unvisited=[], contradictory=False, trusted=[]):
        for stratum in strata:  # they are disjoint and cover A, C > 0, mu != 0
            match stratum:
                case Stratum(Truth.yes):
                    assert "C = A" in stratum.conditions
                case Stratum(Truth.no):
                    print(f"{stratum.where}: G = {stratum.group_text}, not abelian, so not integrable")
print("Lemma 3 is proved, by", top.manifolds[0].by.name, "for", top.manifolds[0].integrals, "first integrals")
