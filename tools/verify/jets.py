"""Checks certificates of higher variational equations, kovacic-jets/1 (docs/theory/jet_certificates.md; J1 to J7 are its rules).

Nothing is searched for: motion.py puts the series into the equations of motion again and compares the residues at the first
resonance that fails; here are the reasons why the group of the normal equation is infinite (J7)."""
from fractions import Fraction

import checked
from certificate_format import need, refusing
from exact import K, from_rows
from jets_format import FORMAT, read_jets, statement
from motion import Jets
from multivariate import MASK


class NormalGroup:
    """J7: why the group of the normal equation is infinite; energy: with a certificate of that group"""

    def __init__(self, jets, group, prove):
        self.jets, self.R, self.energy, self.trust, self.lines = jets, jets.R, None, 0, []
        self.delta = jets.rho[1] - jets.rho[0]
        by = group["by"]
        if by in ("first-family", "homogeneous"):
            sizes = [(jets.k - 2) * (self.delta + one) / (2 * jets.k) for one in (1, -1)]
            need(any(x.denominator == 1 for x in sizes), "the exponents are not in the first family")
        if by == "homogeneous":
            terms = [len(f.p.parts(MASK << jets.y)) for f in (jets.g, jets.w)]
            need(terms == [1, self.delta != 1], "the first variational equation is not homogeneous")
            need(not jets.entry(0), "the form has a power of c2 alone")
        if by == "equilibria":
            slope = jets.v.diff(jets.y)
            self.need_one(group["first"], slope, group["second"], slope.diff(jets.y))
            total = (self.delta**2 - 1) / (4 * jets.sigma * (jets.sigma - 1))
            need(no_sum_of_squares(total.numerator * total.denominator, jets.k - 1), "the exponents may be rational")
        if by == "group":
            self.of_certificate(group, prove)

    def need_one(self, first, f, second, g):
        """first f + second g = 1"""
        y = self.R.name(self.jets.y)
        a, b = (self.R.sum(self.jets.constant(x) * y**i for i, x in enumerate(side)) for side in (first, second))
        need(not a * f + b * g - self.R.one, "a polynomial is not proved to have simple roots")

    def number(self, f, e=0):
        """The value at this e of an element without parameters and constants"""
        need(f.p.variables() <= {0} and not any(f.e), "a number is expected")
        return Fraction(sum(c * e**k for k, c in f.p.items())) / f.n

    def of_certificate(self, group, prove):
        jets, e = self.jets, group["e"]
        need(not jets.d["parameters"] and not jets.d["constants"], "there are parameters or constants")
        self.energy = self.number(self.level(), e)
        kinetic = self.R.divided(self.R.one * self.energy.numerator, self.energy.denominator) - jets.v
        self.need_one(group["first"], kinetic, group["second"], jets.v.diff(jets.y))
        need(self.number(jets.value, e), "the obstruction is 0 there")
        num, den, claim, self.trust, self.lines = prove(group["certificate"])
        need(K.d == 1, "the equation is over another field")
        m, g, w = (from_rows([[self.number(f.part(jets.y, i))] for i in range(f.p.degree(jets.y) + 1)])
                   for f in (kinetic * jets.line["inertias"][1] * 2, jets.g, jets.w))
        right = g * g * Fraction(-3, 4) + m * (g.diff() * Fraction(1, 2) + w)
        need(num * m * m == den * right, "the certificate is about another equation")
        need(claim.get("component", "trivial") != "trivial", "the group is not said to be infinite")

    def level(self):
        """H on the solution: y_t^2/(2 A scale) + v(y), of s^0"""
        jets = self.jets
        y_t, lead = jets.solution.derivative(jets.turns), 2 * jets.sigma * (jets.sigma - 1)
        down = jets.v.part(jets.y, jets.k) * (-jets.k * lead.denominator)
        return self.R.divided(down * y_t.coefficient(y_t, 0), lead.numerator) + jets.at_solution(jets.v)[0]


def no_sum_of_squares(m, n):
    """m is not a sum of n >= 2 squares of rational numbers (jets.md 2.9)"""
    need(m < 10**12, "the sum of the squares is too large")
    if m <= 0 or n > 3:
        return m < 0
    if n == 3:
        while m % 4 == 0:
            m //= 4
        return m % 8 == 7
    p, odd = 2, []
    while p * p <= m:
        exponent = 0
        while m % p == 0:
            m, exponent = m // p, exponent + 1
        odd += [p] * (exponent % 2)
        p += 1
    return any(p % 4 == 3 for p in [*odd, m])


@checked.file()
def accept(top, prove):
    """What was read, checked: the series and why the group is infinite.  prove checks ordinary certificates."""
    d = read_jets(top)
    with refusing():
        jets = Jets(d)
        group = NormalGroup(jets, d["group"], prove)
    checked.label(FORMAT, "J1 J2 J3 J4 J5 J6")
    checked.add(FORMAT, "by", d["group"]["by"])
    return d, jets, group


def verify(top, prove, _=False):
    """The number of trusted steps, a summary and the statement"""
    d, jets, group = accept(top, prove)
    checked.conclude(["Morales-Ramis-Simo"], "first integrals that are meromorphic near the phase curve, at the energies and for "
                     "the parameters of the statement")
    return group.trust, "not integrable; ", list(statement(d, jets, group))
