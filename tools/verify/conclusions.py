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
    orders = {x.delta.denominator for x in local.all if x.delta is not None} if local else set()
    imprimitive = infinite or log or {4, 5} <= orders or any(k >= 6 for k in orders)

    def characters():
        return local.character_order()

    def independent():
        (a, b), (c, d) = (x.fraction() for x in vs)
        f, g = a * d, c * b
        return not f * g.lead() == g * f.lead()

    def no_torsion():
        primes = prod({x.p for x in facts if x.kind == "p-curvature"} - {reduction.p})
        return gcd(2 * local.residue_denominator(v), primes) == 1 and primes > reduction.bound
    vs = [x for x in facts if x.kind == "invariant" and x.m == 4]
    rows = {                                # the premises, the group and its n
        "sl2-p-curvature": (shows == "sl2", "SL2"),
        "sl2-irreducible-log": (irreducible_group and log, "SL2"),
        "sl2-irreducible-infinite": (irreducible_group and 4 in absent and imprimitive, "SL2"),
        "sl2-irreducible-12": (irreducible_group and 12 in absent, "SL2"),
        "borel": (triangular and infinite, "Borel"),
        "additive": (triangular and local, "T", characters),
        "diagonal": (split, "Gm") if infinite else (local and split, "cyclic", characters),
        "dihedral-infinite": (dihedral and infinite, "Dinf"),
        "dihedral-holomorphic": (dihedral and v.holomorphic_quotient, "Dinf"),
        "dihedral-genus-0": (local and dihedral and v.branch.degree() <= 2, "D", lambda: local.residue_denominator(v)),
        "dihedral-finite": (torsion and torsion.of is v, "D", lambda: torsion.n),
        "dihedral-torsion": (local and reduction and reduction.of is v and no_torsion, "Dinf"),
        "quaternion": (irreducible_group and len(vs) == 2 and independent, "D", lambda: 2),
        "invariant-abelian": (v, None),
        "torus-nonabelian": (infinite and 4 in absent, None)}
    for name, (group, m, none) in PRIMITIVE.items():
        rows[name] = irreducible_group and none <= absent and any(x.kind == "invariant" and x.m == m for x in facts), group
    given, group, *n = rows.get(theorem, (False, None))
    need(given() if callable(given) else given, f"the premises of {theorem} are not all given")
    n = n[0]() if n else None
    abelian = group not in ("SL2", "Borel") and theorem != "torus-nonabelian"
    return ("cyclic", 4, True) if (group, n) == ("D", 1) else (group, n, abelian)
