"""The step `conclude` of kovacic-certificate/1: the table in docs/theory/certificates.md 2, proved in trichotomy.md."""
from math import gcd, prod

from certificate_format import need

COMPONENT = {"SL2": "SL2", "Borel": "Borel", "T": "Ga", "Gm": "Gm", "cyclic": "trivial", "Dinf": "Gm", "D": "trivial",
             "A4": "trivial", "S4": "trivial", "A5": "trivial", None: None}
PRIMITIVE = {"tetrahedral": ("A4", 6, {4}), "octahedral": ("S4", 8, {4, 6}), "icosahedral": ("A5", 12, {8})}


def conclude(theorem, facts):
    """(group, n, abelian): one row of the table in certificates.md 2 for each theorem."""
    first = {x.kind: x for x in reversed(facts)}
    local, v, torsion, reduction, curvature = (
        first.get(k) for k in ("local", "invariant", "torsion-function", "good-reduction", "p-curvature"))
    absent, shows = {x.m for x in facts if x.kind == "no-invariant"}, curvature and curvature.shows
    irreducible_group = "irreducible" in first or shows in ("irreducible", "sl2")
    log, infinite = bool(local) and local.log, bool(local) and local.infinite_order
    quadratic = bool(v) and v.m == 2 and bool(v.w_squared.c)
    split, dihedral = quadratic and v.branch.degree() == 0, quadratic and v.branch.degree() > 0
    triangular = "exponential" in first and (log or 2 in absent or 4 in absent)     # and not diagonal

    def given(condition, group, n=None):
        need(condition, f"the premises of {theorem} are not all given")
        n = n() if n else None
        return ("cyclic", 4, True) if (group, n) == ("D", 1) else (group, n, group not in ("SL2", "Borel"))
    if theorem == "sl2-p-curvature":
        return given(shows == "sl2", "SL2")
    if theorem == "sl2-irreducible-log":
        return given(irreducible_group and log, "SL2")
    if theorem == "sl2-irreducible-infinite":
        orders = {x.delta.denominator for x in local.all if x.delta is not None} if local else set()
        imprimitive = infinite or log or {4, 5} <= orders or any(k >= 6 for k in orders)
        return given(irreducible_group and 4 in absent and imprimitive, "SL2")
    if theorem == "sl2-irreducible-12":
        return given(irreducible_group and 12 in absent, "SL2")
    if theorem == "borel":
        return given(triangular and infinite, "Borel")
    if theorem == "additive":
        return given(triangular and local, "T", lambda: local.character_order())
    if theorem == "diagonal":
        return given(local and split, *(("Gm",) if infinite else ("cyclic", lambda: local.character_order())))
    if theorem == "dihedral-infinite":
        return given(dihedral and infinite, "Dinf")
    if theorem == "dihedral-holomorphic":
        return given(dihedral and v.holomorphic_quotient, "Dinf")
    if theorem == "dihedral-genus-0":
        small = local and not infinite and dihedral and v.branch.degree() <= 2
        return given(small, "D", lambda: local.residue_denominator(v))
    if theorem == "dihedral-finite":
        return given(dihedral and torsion and torsion.of is v, "D", lambda: torsion.n)
    if theorem == "dihedral-torsion":
        need(dihedral and local and reduction and reduction.of is v, f"the premises of {theorem} are not all given")
        primes = prod({x.p for x in facts if x.kind == "p-curvature"} - {reduction.p})
        return given(gcd(2 * local.residue_denominator(v), primes) == 1 and primes > reduction.bound, "Dinf")
    if theorem == "quaternion":
        vs = [x for x in facts if x.kind == "invariant" and x.m == 4]
        need(irreducible_group and len(vs) == 2, f"the premises of {theorem} are not all given")
        (a, b), (c, d) = vs[0].fraction(), vs[1].fraction()
        f, g = a * d, c * b
        return given(not f * g.lead() == g * f.lead(), "D", lambda: 2)
    if theorem in PRIMITIVE:
        group, m, none = PRIMITIVE[theorem]
        found = any(x.kind == "invariant" and x.m == m for x in facts)
        return given(irreducible_group and none <= absent and found, group)
    if theorem == "invariant-abelian":
        return given(v, None)
    need(theorem == "torus-nonabelian" and infinite and 4 in absent, f"the premises of {theorem} are not all given")
    return None, None, False
