"""The class of first integrals that a verdict speaks of (docs/theory/system_certificates.md 7)."""
from itertools import combinations
from typing import NamedTuple

from exact import K
from modular import is_prime, mdiff, meval, mgcd
from multivariate import FIELD, spend


def falls(num, den):
    """Has r of these degrees a pole of order <= 2 in dz at infinity (or none)?"""
    return num < 0 or den - num >= 2


class Denial(NamedTuple):
    """What says "not abelian": is it regular, and is the group SL(2)?  trust: its steps on trust; path: of a leaf, the conditions
    on the way to it, pairs of a text and a sign; whole: it is about the variation on the whole Poisson manifold"""
    regular: bool = False
    sl2: bool = False
    trust: int = 0
    path: tuple = ()
    whole: bool = False


def denial(num, den, claim, trust=0):
    """Of an ordinary certificate that says "not abelian" of y'' = num/den y"""
    regular = falls(num.degree(), den.degree()) and not triple_root(den)
    return Denial(regular, claim.get("group") == "SL2", trust)


def triple_root(f):
    """Is no prime found that shows that the monic f in K[z] has no root of order >= 3?  (A common factor over K of f, f' and
    f'' has an image modulo a prime ideal of degree 1 that divides no denominator.)"""
    tried = 0
    for p in filter(is_prime, range(1009, 4000)):
        a = next((a for a in range(p) if meval(K.m, a, p) == 0), None) if f.q % p else None
        if a is not None and tried < 40:
            tried += 1
            spend(len(f.c)**2 // 16)
            g = f.image(a, p)
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

    def has_rational(self):
        """Are rational functions in it?"""
        return self.contains(IntegralClass("rational", self.place))

    def contains(self, inner):
        """Is each complete set of integrals of the class `inner` one of this class?  False: not known."""
        here = self[:2] == inner[:2] or self.kind == "meromorphic" and (
            inner.kind == "rational" and (self.place == "curve" or self.place != "level" and not inner.functions)
            or inner[:2] == ("meromorphic", "closed curve") and self.place == "curve")
        parts = (inner.functions, self.functions), (self.without, inner.without), (inner.through, ())
        return here and self[-2:] == inner[-2:] and self.on_leaf <= inner.on_leaf and all(set(a) <= set(b) for a, b in parts)

    def sentence(self, alone=True):
        """alone: no other class is named beside it; then "meromorphic" is enough"""
        text = self.kind + ("" if self.kind == "rational" else {
            "curve": "" if alone else " near the phase curves", "level": " on the leaves with F2 = 0", "origin": " near the origin",
            "phase space": " on the whole real phase space",
            "closed curve": " also at the ends of the phase curve (points at infinity, equilibria, poles of the system)"}[self.place])
        if self.functions:
            text += f" (in the coordinates and {', '.join(self.functions)})"
        text += " and independent on the symplectic leaf of the phase curve" * self.on_leaf
        text += f" and do not depend on {', '.join(self.without)}" * bool(self.without)
        text += f" otherwise than through {', '.join(self.through)}" * bool(self.through)
        return text + f" (in the coordinates {self.frame})" * bool(self.frame)


def least(classes):
    """Without those that contain another one: what is of all of them at once is the same"""
    kept = []
    for c in classes:
        if not any(known == c or c.contains(known) for known in kept):
            kept = [known for known in kept if not known.contains(c)] + [c]
    return kept


def casimirs(claims):
    """Of the pairs (claim, its function)"""
    return [f for claim, f in claims if claim["kind"] == "casimir"]


def nowhere_zero(f):
    """A function of z alone, with a coefficient that is a number, is not 0 for all z, whatever the parameters are."""
    return not f.in_tower() and any(c.constant() for c in f.p.coefficients(0))


def regular_leaves(curve, casimirs):
    """The leaves around the curve are regular, of dimension four, and cut out by Casimir functions (7)."""
    space, n = curve.space, len(curve.space.coordinates)
    if space.brackets is None or not 4 < n <= 8 or not all(map(curve.has, space.coordinates)):
        return False
    constants = not any(space.gradients[space.at[x]] for x in space.functions)
    if not constants or any(f.p.variables() & {FIELD * j for j in range(n)} for f in space.relations):
        return False
    rows = [[curve.value(space.d(f, j)) for j in space.indices] for f in casimirs[:6]]
    if not any(nowhere_zero(curve.R.determinant([[row[j] for j in columns] for row in some]))
               for some in combinations(rows, n - 4) for columns in combinations(range(n), n - 4)):
        return False
    zero = curve.R.sum([])
    bracket = {(i, j): curve.value(space.brackets[i, j]) if (i, j) in space.brackets else zero for i in range(n) for j in range(n)}

    def pfaffian(i, j, k, l):
        return bracket[i, j] * bracket[k, l] - bracket[i, k] * bracket[j, l] + bracket[i, l] * bracket[j, k]
    return any(nowhere_zero(pfaffian(*four)) for four in combinations(range(n), 4))


def integrals(curve, denials, casimirs=()):
    """The class; denials: those of the leaves that say "not abelian"; casimirs: functions that are claimed"""
    space = curve.space
    symbols = [s for s in space.functions if curve.has(s) and space.gradients[space.at[s]]]
    place = "curve" if all(d.regular for d in denials) else "closed curve"
    on_leaf = space.brackets is not None and not space.one_leaf() and not any(d.whole for d in denials)
    moving = [] if all(d.regular and d.sl2 for d in denials) else curve.moving()
    if on_leaf and place == "curve" and not symbols and not moving:
        on_leaf = not regular_leaves(curve, casimirs)
    return IntegralClass("meromorphic", place, on_leaf, tuple(symbols), tuple(moving), liouville=space.brackets is not None)
