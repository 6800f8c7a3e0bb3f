"""The rule `local` of kovacic-certificate/1 (docs/theory/certificates.md 2): the singular places of r, their exponents
and logarithms (numbers are those of docs/theory/local_exponents.md)."""
from fractions import Fraction

from certificate_format import BULK, LENGTH, need
from equation import Equation
from exact import K, ONE, ZERO, division, product
from modular import madd, meval, mgcd, mmul, mpow
from places import Local, Place


class SingularPoints(Equation):
    def need_log(self, d, root, delta):
        """A logarithm at the root, or at infinity (local_exponents.md 1.4)."""
        p, _, num, den = self.good(d)
        natural = delta is not None and delta.denominator == 1 and 1 <= delta < p
        need(natural, "a logarithm needs a natural Delta below p")
        n, e = self.expansion(p, num, den, root, 2)
        start = (1 - int(delta)) * (p + 1) // 2 % p
        need(self.riccati(n, e, 2, start, int(delta) + 1, p) is None, "no logarithm is seen")

    def need_eps2(self, x, n, d, value):
        """eps^2 = value; n(i), d(i): Taylor coefficients of t^(2nu) r in K[c]/q (local_exponents.md 1.5)."""
        nu, times = x.order // 2, x.times
        size = self.num.bits() + self.den.bits() + (self.length * x.q.bits() if x.q else 0)
        need(nu <= 200 and nu * nu * x.n * size <= BULK, "the order of the pole or the coefficients are too large")
        N, D = [n(i) for i in range(nu)], [d(i) for i in range(nu)]
        G = [sum((times(N[j], D[i - j]) for j in range(i + 1)), ZERO) for i in range(nu)]
        tau, inverse, g, e = [ONE], [ONE], [ONE], [ONE]
        for j in range(1, nu):
            g, e = g + [times(g[-1], G[0])], e + [times(e[-1], D[0])]
            square = sum((times(tau[i], tau[j - i]) for i in range(1, j)), ZERO)
            tau.append((times(G[j], g[j - 1]) - square) * Fraction(1, 2))
            inverse.append(sum((times(D[i], e[i - 1], inverse[j - i]) for i in range(1, j + 1)), ZERO) * -1)
        k = nu - 1
        total = sum((times(tau[i], inverse[k - i], g[k - i], e[i]) for i in range(nu)), ZERO)
        need(times(value, D[0], D[0], g[k], e[k], g[k], e[k]) == times(G[0], total, total) * 4, "eps2 is wrong")

    def local(self, d):
        """The places are all singular points (local_exponents.md 1)."""
        rows, second = d["places"], self.den.diff().diff()
        need(len(rows) <= 20000, "too many places")
        need(all(e["q"].degree() >= 1 and e["q"].lead() == ONE for e in rows), "a place is not a monic polynomial")
        need(all(e["order"] <= LENGTH for e in rows), "an order is too large")
        need(all(e["order"] >= 1 for e in rows), "an order is not positive")
        need(sum(e["q"].degree() * e["order"] for e in rows) == self.dd, "the degrees do not add up to deg den")
        need(self.dd * sum(e["order"] * e["q"].bits() for e in rows) <= BULK, "the places are too large")
        need(product(e["q"]**e["order"] for e in rows) == self.den, "the product of the places is not den")
        self.need_squarefree(product(e["q"] for e in rows), d["prime"], self.num if rows else ZERO)
        claims = [(e["q"], (e["delta2"] - ONE) * e["q"].diff()) for e in rows if e["delta2"] is not None]
        need(all(e["order"] == 2 and e["delta2"].degree() < e["q"].degree() for e in rows if e["delta2"] is not None),
             "delta2 belongs to a pole of order 2")
        for q, w in claims:                 # more bits than 8 num/den'' can have modulo q: Cramer's rule
            n, of_r = q.degree(), self.num.bits() + self.den.bits() + 128
            most = 2 * (n + 2) * (of_r + 4 * (self.length + n) * (q.bits() + 2))
            need(K.d > 1 or w.bits() <= most, "delta2 is wrong")
        size = self.length * sum(q.bits() + w.bits() for q, w in claims)
        need(size <= BULK, "the exponents are too large")
        self.spend(4 * self.length * (1 + self.den.bits() / 64) + size / 16)
        while len(claims) > 1:              # Q = prod q, W = sum (delta2 - 1) q' Q/q   (1.8)
            claims = [(a * b, u * b + w * a) for (a, u), (b, w) in zip(claims[::2], claims[1::2] + [(ONE, ZERO)])]
        for Q, W in claims:
            test = self.num * 4 - W * Q.diff() * division(self.den, Q * Q)[0]
            need(not division(test, Q)[1].c, "delta2 is wrong")
        return Local([self.place(e, second) for e in rows], self.infinity(d["infinity"]))

    def place(self, e, second):
        x, num, den = Place(e["q"], e["q"].degree(), e["order"]), self.num, self.den
        if e["delta2"] is not None:
            x.set_square(e["delta2"], e["annihilator"])
        if e["irrational"] is not None:     # 1.7, with e = u/h: u and u^k - h^k, k = (p - 1)/2, are units modulo q
            need(x.order == 2 and x.delta is None, "irrational belongs to a pole of order 2")
            p, reduce, n, _ = self.good(e["irrational"])
            self.spend(100 * x.n * x.n)
            q, h = reduce(x.q), reduce(second)
            u = madd(h, n, p, 8)
            powers = [mpow(v, (p - 1) // 2, q, p) for v in (u, h)]
            unit = mmul(mmul(u, h, p), madd(*powers, p, -1), p)
            need(unit and len(mgcd(q, unit, p)) == 1, "irrationality is not seen modulo p")
            x.irrational = True
        if e["log"] is not None:
            roots = e["log"]["roots"] or []
            need(x.order == 2 and roots and len(set(roots)) == len(roots), "distinct roots are expected")
            p, reduce = self.good(e["log"])[:2]
            for c in roots:
                need(c < p and meval(reduce(x.q), c, p) == 0, "not a root of the place modulo p")
                self.need_log(e["log"], c, x.delta)
            x.logs = len(roots)
        if e["eps2"] is not None:
            need(x.order >= 4 and x.order % 2 == 0 and e["eps2"].degree() < x.n, "eps2 belongs to even order >= 4")
            self.spend(x.order * x.n * self.length * (1 + self.den.bits() / 64))
            self.need_eps2(x, lambda i: x.rem(num.taylor(i)), lambda i: x.rem(den.taylor(i + x.order)), e["eps2"])
            x.set_square(e["eps2"], e["annihilator"])
        return x

    def infinity(self, d):
        x = Place(None, 1, 4 - (self.dd - self.dn) if self.dn >= 0 else 0)
        if x.order == 2:
            x.set_square(ONE + self.num.lead() * 4, d["annihilator"])
        if d["log"] is not None:
            need(x.order == 2 and not d["log"]["roots"], "no logarithm to prove at infinity")
            self.need_log(d["log"], None, x.delta)
            x.logs = 1
        if d["eps2"] is not None:
            need(x.order >= 4 and x.order % 2 == 0 and d["eps2"].degree() < 1, "eps2 belongs to even order >= 4")
            n, e = (lambda i: self.num.coefficient(self.dn - i)), (lambda i: self.den.coefficient(self.dd - i))
            self.need_eps2(x, n, e, d["eps2"])
            x.set_square(d["eps2"], d["annihilator"])
        return x
