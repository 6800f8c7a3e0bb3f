"""The class of first integrals that a verdict speaks of (docs/theory/system_certificates.md 7)."""
from typing import NamedTuple

from exact import K
from modular import is_prime, mdiff, meval, mgcd, trim
from multivariate import spend


def falls(num, den):
    """Has r of these degrees a pole of order <= 2 in dz at infinity (or none)?"""
    return num < 0 or den - num >= 2


def denial(num, den, claim):
    """Of an ordinary certificate that says "not abelian": is r = num/den regular, and is the group SL(2)?"""
    regular = falls(num.degree(), den.degree()) and not triple_root(den)
    return regular, claim.get("group") == "SL2"


def triple_root(f):
    """Is no prime found that shows that the monic f in K[z] has no root of order >= 3?  (A common factor over K of f, f' and
    f'' has an image modulo a prime ideal of degree 1 that divides no denominator.)"""
    tried = 0
    for p in filter(is_prime, range(1009, 4000)):
        a = next((a for a in range(p) if meval(K.m, a, p) == 0), None) if f.q % p else None
        if a is not None and tried < 40:
            tried += 1
            spend(len(f.c)**2 // 16)
            g = trim([meval(f.c[i:i + K.d], a, p) for i in range(0, len(f.c), K.s)])
            slope = mdiff(g, p)
            if len(mgcd(mgcd(g, slope, p), mdiff(slope, p), p)) == 1:
                return False
    return True


class IntegralClass(NamedTuple):
    """A class of first integrals.  place: "curve", "closed curve" (also at its ends), "level" (the leaves with F2 = 0), "origin",
    "phase space"; functions: symbols that they may contain beside the coordinates; without: what they do not contain"""
    kind: str = "meromorphic"
    place: str = "curve"
    on_leaf: bool = False
    functions: tuple = ()
    without: tuple = ()
    through: tuple = ()
    frame: str = ""
    liouville: bool = True

    def sentence(self):
        text = self.kind + ("" if self.kind == "rational" else {
            "curve": "", "level": " on the leaves with F2 = 0", "origin": " near the origin",
            "phase space": " on the whole real phase space",
            "closed curve": " also at the ends of the phase curve (points at infinity, equilibria, poles of the system)"}[self.place])
        if self.functions:
            text += f" (in the coordinates and {', '.join(self.functions)})"
        text += " and independent on the symplectic leaf of the phase curve" * self.on_leaf
        text += f" and do not depend on {', '.join(self.without)}" * bool(self.without)
        text += f" otherwise than through {', '.join(self.through)}" * bool(self.through)
        return text + f" (in the coordinates {self.frame})" * bool(self.frame)


def integrals(curve, denials):
    """The class; denials: those of the leaves that say "not abelian" """
    space = curve.space
    symbols = [s for s in space.functions if curve.has(s) and space.gradients[space.at[s]]]
    place = "curve" if all(regular for regular, _ in denials) else "closed curve"
    on_leaf = space.brackets is not None and not space.one_leaf()
    moving = [] if all(regular and sl2 for regular, sl2 in denials) else curve.moving()
    return IntegralClass("meromorphic", place, on_leaf, tuple(symbols), tuple(moving), liouville=space.brackets is not None)
