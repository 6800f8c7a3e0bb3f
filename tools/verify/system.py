"""Checks certificates of the whole way from a system to "not integrable", kovacic-system/1
(docs/theory/system_certificates.md; (1) to (8) are its sections).

Nothing is searched for: phase_space.py has the system (3), phase_curve.py the solution and the variational equation along
it (4, 5), the certificate of y'' = r y inside is checked by the rules of its own format (6)."""

import checked
import loops
import strata
from certificate_format import need, refusing
from exact import K
from first_integrals import Denial, casimirs, denial, integrals
from multivariate import FIELD, P, parse, spend
from phase_curve import NormalPart, PhaseCurve
from phase_space import PhaseSpace
from statement import equation_text, over_field, polynomial
from system_format import FORMAT, read_system
from system_statement import Shown, statement


class Inner:
    """The certificate of y'' = (num/den) y: num and den in R, trusted steps, lines; denials: of each leaf that says
    "not abelian"; nowhere: it claims "not abelian" of all admitted points.  rows: of a system, pairs (den, nums);
    equation: as text; criteria: of its leaves that say "where"."""

    def __init__(self, curve, d, prove, whole):
        self.curve, self.R, self.rows, self.criteria, top = curve, curve.R, None, [], d["certificate"]
        if isinstance(top, dict) and top.get("format") == loops.FORMAT:
            need(not whole or curve.space.brackets is None or not curve.moving(),
                 "on the whole manifold no name is left out, because the bracket may contain it")
            inner, self.trust, self.lines = loops.accept(top, prove)
            e = self.root(d["root"])
            self.rows = [(self.at_root(row["den"], e), [self.at_root(f, e) for f in row["num"]]) for row in inner["system"]]
            self.equation = f"Y' = A(z) Y, A a matrix of size {len(self.rows)}"
            self.nowhere, self.denials = True, [Denial(True, False, self.trust, whole=bool(whole))]
            return
        if isinstance(top, dict) and top.get("format") == strata.FORMAT:
            need(d["root"] is None, "a root belongs to a number field")
            tree, _, self.lines = strata.accept(top, prove)
            self.trust, self.denials, self.criteria = tree.trust, tree.denials, tree.criteria
            self.nowhere = top["claim"]["abelian"] is False
            self.of_strata(top)
        else:
            num, den, claim, self.trust, self.lines = prove(top)
            self.nowhere = claim.get("abelian") is False
            self.denials = [denial(num, den, claim, self.trust)] if self.nowhere else []
            self.equation = equation_text(over_field(num), over_field(den))
            e = self.root(d["root"])
            self.num, self.den = (self.at_root(f, e) for f in (num, den))
        need(self.R.norm(self.den), "the denominator has no inverse")

    def of_strata(self, top):
        """num and den with the values of parameters and constants put in; these are admitted as far as it is seen (N4)."""
        curve, space, names = self.curve, self.curve.space, [top["variable"], *top["parameters"]]
        constants = {x for x in space.functions if not space.gradients[space.at[x]] and curve.has(x)}
        need(names[0] == curve.variable, "the equation has another variable")
        need(set(names[1:]) <= constants | set(curve.parameters), "a parameter of the equation is none of the system")
        at = {x: FIELD * i for i, x in enumerate(names)}
        values = {at[x]: curve.known[space.at[x]] for x in names[1:]} | {0: {1: self.R.z}}

        def put(text):
            return self.R.put_in(parse(text, at), 1, values)
        self.num, self.den = put(top["r"]["num"]), put(top["r"]["den"])
        need(all(any(self.R.norm(put(text)) for text in group) for group in top["generic"]), "the equation excludes this system")
        num, den = (polynomial(parse(top["r"][x], at), names) for x in ("num", "den"))
        self.equation = equation_text(num, den)
        constants &= set(names)
        moved = {at[x] for x in constants}

        def of_constants(text):
            return parse(text, at).variables() & moved
        need(all(put(x).number() is not None for x in constants & {*top["real"], *(top.get("rational") or ())}),
             "a constant that is not seen to be real, or rational")
        for c in top["assumptions"]:
            need(not of_constants(c["p"]) or self.holds(put(c["p"]), c["sign"]), "an assumption about a constant does not hold")
        for c in top.get("memberships") or ():
            if of_constants(c["num"]) or of_constants(c["den"]):
                num, den = (put(c[key]).number() for key in ("num", "den"))
                need(None not in (num, den) and den and ((num / den).denominator == 1) == c["integral"],
                     "an assumption about a constant does not hold")

    def holds(self, v, sign):
        """In R "not 0" is an inverse; what has parameters in it, and nothing else, is a condition on them."""
        if sign == "nonzero":
            return bool(self.R.norm(v))
        c = v.number()
        if c is None:
            return not v.in_tower()
        return {"positive": c > 0, "nonnegative": c >= 0, "zero": c == 0}[sign]

    def root(self, v):
        """A constant of R, a root of the minimal polynomial (N4)"""
        need((v is None) == (K.d == 1), "a root is needed for a number field, and only there")
        if v is None:
            return self.R.one
        e = self.R.read(v)
        need(not self.R.sum(e**i * c for i, c in enumerate(K.m) if c), "not a root of the minimal polynomial")
        need(not e.derivative(), "the root is not constant")
        return e

    def at_root(self, f, e):
        """f in K[z] at a = e"""
        spend(len(f.c) * (1 + f.bits() // 64))
        p = P((i // K.s + (i % K.s << FIELD), c) for i, c in enumerate(f.c) if c)
        return self.R.put_in(p, f.q, {0: {1: self.R.z}, FIELD: {1: e}})


@checked.file()
def accept(d, prove):
    """What was read, checked: the curve, the claims with their functions and the inner certificate.  Raises Malformed or
    Rejected."""
    with refusing():
        space = PhaseSpace(d["system"], d["parameters"])
        claims = [(claim, space.need_claim(claim)) for claim in d["claims"]]
        curve = PhaseCurve(space, d["curve"], d["parameters"])
        normal = NormalPart(curve, d["normal"])
        inner = Inner(curve, d["equation"], prove, d["normal"].get("whole"))
        normal.need_equation(inner)
        need(inner.nowhere or not d["claim"]["not_integrable"], "the claim does not follow")
    if checked.wanted:
        tell(d, curve, claims, inner)
    return curve, claims, inner


def tell(d, curve, claims, inner):
    """The rules, in an order in which they can be read"""
    checked.label(FORMAT, "S1 S2 S3 S4 C1 C2")
    checked.add(FORMAT, "label", "C4", found=Shown(curve).phase_curve(d))
    checked.label(FORMAT, "C5 C6 C7 N1 N2 N3")
    checked.add(FORMAT, "label", "N5" if inner.rows else "N4", found=inner.equation)
    excluded = integrals(curve, inner.denials, casimirs(claims))
    checked.add(FORMAT, "label", "class", found=f"first integrals that are {excluded.sentence()}" if inner.denials else "none")


def verify(top, prove, _=False):
    """The number of trusted steps, a summary and the statement; prove checks ordinary certificates."""
    d = read_system(top)
    curve, claims, inner = accept(d, prove)
    lines = statement(d, curve, claims, inner)
    excluded = integrals(curve, inner.denials, casimirs(claims))
    checked.conclude(["Ayoul-Zung" if curve.space.brackets is None or d["normal"].get("whole") else "Morales-Ramis"], f"first integrals that are "
                     f"{excluded.sentence()}, along one phase curve; parameters without the exceptions of the statement")
    proved = "not integrable" if d["claim"]["not_integrable"] else "not integrable for some parameters"
    return inner.trust, f"{proved if inner.denials else 'nothing follows'}; ", lines
