"""The singular places of y'' = r y, and the degree bounds that follow (docs/theory/local_exponents.md)."""
from fractions import Fraction
from math import floor, lcm

from certificate_format import need
from exact import ONE, ZERO, division, exact_sqrt, root_bound, sqrt_above


class Place:
    """n points with the same data, the roots of q (at infinity q = None); order: of the pole of r, at infinity of
    r(1/t)/t^4 at t = 0.  delta: Delta if proved rational; irrational: proved so at every point; logs: the number of
    points with a proved logarithm; real: a bound of |Re Delta| (order 2) or of |Re eps| (even order >= 4)."""

    def __init__(self, q, n, order):
        self.q, self.n, self.order, self.irrational, self.real = q, n, order, False, None
        self.delta, self.logs = (Fraction(1) if order <= 1 else None), (n if order == 1 else 0)
        self.ramified = order >= 3 and order % 2 == 1

    def rem(self, f):
        """f modulo q"""
        return f if self.q is None or f.degree() < self.n else division(f, self.q)[1]

    def times(self, *factors):
        """The product in K[c]/q."""
        v = ONE
        for f in factors:
            v = self.rem(v * f)
        return v

    def set_square(self, value, annihilator):
        """value = Delta^2 (order 2) or eps^2, a polynomial in c; annihilator(value) = 0 in K[c]/q."""
        c = value.rational()
        if self.order == 2:
            self.delta = exact_sqrt(c) if c is not None else None
            self.irrational = value.degree() <= 0 and self.delta is None
            self.logs = self.n if self.delta == 0 else 0
        if c is not None:
            self.real = sqrt_above(c)
        elif annihilator is not None:
            chi, v = [annihilator.coefficient(i).rational() for i in range(annihilator.degree() + 1)], ZERO
            need(len(chi) <= 501, "the annihilator is too large")
            need(len(chi) >= 2 and None not in chi, "the annihilator is constant or not over Q")
            for x in reversed(chi):
                v = self.times(v, value) + ONE * x
            need(not v.c, "the annihilator does not vanish")
            self.real = sqrt_above(root_bound(chi))

    def infinite_order(self):
        return self.order >= 3 or self.irrational

    def exchanges_lines(self):
        """May the two lines of an imprimitive group be exchanged around this place?  (p_curvature.md 3)"""
        half = self.delta is None or self.delta.denominator == 2
        return self.ramified or self.order == 2 and not self.irrational and half

    def lowest(self, m):
        """Lower bound for the order at each point of a rational solution of Sym^m, m even; None: there is none
        (local_exponents.md 2.1).  An ordinary point has Delta = 1 and no logarithm, which gives 0."""
        if self.order >= 3:
            return None if m * self.order % 4 else m * self.order // 4
        need(self.irrational or self.delta is not None, "a degree bound needs the exponent difference of every place")
        if self.irrational:
            return m // 2
        b = self.delta.denominator
        return int(m // 2 + (m // 2 if self.logs == self.n else -(m // 2 // b * b)) * self.delta)

    def lowest_exponent(self):
        """Lower bound for the sum over the points of Re alpha, omega = alpha/t + ... (local_exponents.md 3.1)."""
        if self.order <= 1:
            return Fraction(self.n * max(self.order, 0))
        need(self.real is not None, "D_1 needs delta2 or eps2 (and an annihilator, if it is not rational)")
        return self.n * (self.order // 2 + (1 if self.logs == self.n else -1) * self.real) / 2


class Local:
    kind = "local"

    def __init__(self, finite, infinity):
        self.finite, self.infinity, self.all = finite, infinity, finite + [infinity]
        self.infinite_order, self.log = any(x.infinite_order() for x in self.all), any(x.logs for x in self.all)

    def need_rational(self):
        need(all(x.delta is not None for x in self.all), "an exponent difference is not proved rational")

    def degree_bound(self, m):
        """D_m (local_exponents.md 2.2)"""
        e = [x.lowest(m) for x in self.all]
        return -1 if None in e else m - sum(x.n * k for x, k in zip(self.all, e))

    def degree_bound_1(self):
        """D_1 (local_exponents.md 3.2)"""
        need(not any(x.ramified for x in self.all), "use parity")
        return floor(1 - sum(x.lowest_exponent() for x in self.all))

    def character_order(self):
        self.need_rational()
        return lcm(*(((1 + x.delta) / 2).denominator for x in self.finite))

    def residue_denominator(self, v):
        """Lcm of the denominators of Delta over the places where v does not branch (dihedral_torsion.md 4)."""
        self.need_rational()
        others = [x for x in self.finite if x.rem(v.branch).c]
        branch = sum(x.n for x in self.finite) - sum(x.n for x in others)
        need(branch == v.branch.degree(), "the branch places are not places of their own")
        return lcm(*(x.delta.denominator for x in others + [self.infinity] * (branch % 2 == 0)))
