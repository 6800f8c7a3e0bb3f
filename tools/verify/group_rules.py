"""The rules of kovacic-certificate/1 (docs/theory/certificates.md 2): each method checks the data d of one step; the numbers
in brackets are those of the pages beside it, for `local` those of local_exponents.md."""
from fractions import Fraction
from math import isqrt
from operator import mul

from certificate_format import BULK, LENGTH, need
from equation import WORK, Equation, Fact, Invariant
from exact import K, ONE, ZERO, division, product
from modular import is_square, madd, mdiff, mdivmod, meval, mgcd, minverse, mmul, mpow, mshift, power, rank
from places import Local, Place


class Checker(Equation):
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
        g, power, squares, roots = times(N[0], D[0]), ONE, [ONE], [ONE]
        for i in range(1, nu):              # t^(2nu) r = (N_0/D_0) sum squares_i (t/g)^i, its root the same with roots
            total = ZERO
            for j in range(i):
                total = times(total, g) + times(D[i - j], squares[j])
            squares.append(times(power, D[0], N[i]) - times(N[0], total))
            roots.append((squares[i] - sum((times(roots[j], roots[i - j]) for j in range(1, i)), ZERO)) * Fraction(1, 2))
            power = times(power, g)
        need(times(value, D[0], power, power) == times(N[0], roots[-1], roots[-1]) * 4, "eps2 is wrong")

    def local(self, d):
        """The places are all singular points (local_exponents.md 1)."""
        rows = d["places"]
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
        return Local([self.place(e, e["q"], e["order"], e["delta2"]) for e in rows], self.infinity(d["infinity"]))

    def infinity(self, d):
        order = 4 - (self.dd - self.dn) if self.dn >= 0 else 0
        return self.place(d, None, order, ONE + self.num.lead() * 4 if order == 2 else None)

    def place(self, e, q, order, square):
        """square: Delta^2 of a pole of order 2, or None; q is None at infinity."""
        x, num, den = Place(q, q.degree() if q else 1, order), self.num, self.den
        if square is not None:
            x.set_square(square, e["annihilator"])
        if q and e["irrational"] is not None:       # 1.7, with e = u/h: u and u^k - h^k, k = (p - 1)/2, are units modulo q
            need(x.order == 2 and x.delta is None, "irrational belongs to a pole of order 2")
            p, reduce, n, h = self.good(e["irrational"])
            self.spend(100 * x.n * x.n)
            h, m = mdiff(mdiff(h, p), p), reduce(q)
            u = madd(h, n, p, 8)
            powers = [mpow(v, (p - 1) // 2, m, p) for v in (u, h)]
            unit = mmul(mmul(u, h, p), madd(*powers, p, -1), p)
            need(unit and len(mgcd(m, unit, p)) == 1, "irrationality is not seen modulo p")
            x.irrational = True
        if e["log"] is not None:
            p, reduce = self.good(e["log"])[:2]
            roots = e["log"]["roots"] or []
            need(x.order == 2 and len(roots) == len(set(roots)) and bool(roots) == bool(q), "distinct roots are expected")
            need(all(c < p and meval(reduce(q), c, p) == 0 for c in roots), "not a root of the place modulo p")
            for c in roots or [None]:
                self.need_log(e["log"], c, x.delta)
            x.logs = len(roots) or 1
        if e["eps2"] is not None:
            need(x.order >= 4 and x.order % 2 == 0 and e["eps2"].degree() < x.n, "eps2 belongs to even order >= 4")
            if q:
                self.spend(x.order * x.n * self.length * (1 + den.bits() / 64))
                self.need_eps2(x, lambda i: x.rem(num.taylor(i)), lambda i: x.rem(den.taylor(i + order)), e["eps2"])
            else:
                self.need_eps2(x, lambda i: num.coefficient(self.dn - i), lambda i: den.coefficient(self.dd - i), e["eps2"])
            x.set_square(e["eps2"], e["annihilator"])
        return x

    def exponential(self, d):
        """omega = n/e + P'/P satisfies omega' + omega^2 = r (normal_form.md 2.6)."""
        P, n, e = d["p"], d["num"], d["den"]
        need(P.c and e.c, "omega is not defined")
        left = e * e * P.diff().diff() + n * e * 2 * P.diff() + (n.diff() * e - n * e.diff() + n * n) * P
        need(self.den * left == self.num * (e * e) * P, "omega' + omega^2 is not r")
        return Fact("exponential")

    def invariant(self, d):
        """v = P prod q^e solves Sym^m (normal_form.md 2.5)."""
        m, P, factors, S, theta = d["m"], d["p"], [(f["q"], f["e"]) for f in d["factors"]], ONE, ZERO
        need(1 <= m <= 200 and P.c, "not a nonzero function of degree 1 to 200")
        need(all(q.degree() >= 1 and q.lead() == ONE for q, _ in factors), "a factor is not a monic polynomial")
        need(all((e * (2 if m == 2 else 1)).denominator == 1 for _, e in factors),
             "exponents must be integers (half-integers for m = 2)")
        need(all(abs(e) <= 10**7 for _, e in factors), "an exponent is too large")
        for q, e in factors:                # theta/S = sum e q'/q
            S, theta = S * q, theta * q + S * q.diff() * e
        self.need_squarefree(S, d["prime"])
        if division(S * S, self.den)[1].c:
            S, theta = S * self.den, theta * self.den
        rs, T = self.num * division(S * S, self.den)[0], [P, S * P.diff() + theta * P]
        length, size = P.degree() + m * S.degree(), P.bits() + (m + 1) * (S.bits() + rs.bits() + theta.bits())
        need(length * size <= BULK, "the invariant is too large")
        self.spend(m * length * (1 + size / 64))
        for i in range(1, m + 1):
            T.append(S * T[i].diff() + (theta - S.diff() * i) * T[i] - rs * T[i - 1] * (i * (m - i + 1)))
        need(not T[m + 1].c, "the symmetric power does not vanish on v")
        v = Invariant("invariant", m=m, p=P, factors=factors, w_squared=ZERO,
                      branch=product(q for q, e in factors if e.denominator == 2))
        if m == 2:                          # the leading coefficient of w^2 S^2 prod q^(-2e) (normal_form.md 2.5)
            need(4 * (T[1].degree() + 1) * T[1].bits() <= BULK, "the invariant is too large")
            v.w_squared = (T[1] * T[1] - T[0] * T[2] * 2).lead()
        return v

    def no_exponential(self, d, local):
        if d["by"] == "parity":
            need(any(x.ramified for x in local.all), "no place of odd order")
        elif d["by"] == "degree":
            need(local.degree_bound_1() < 0, "D_1 is not negative")
        else:
            self.series(d, local)
        return Fact("irreducible")

    def series(self, d, local):
        """No exponential solution, from one place modulo p (riccati_one_place.md)."""
        p, reduce, num, den = self.good(d)
        root, terms, delta = d["root"], d["terms"], d["delta"]
        if d["place"] == "infinity":
            x, root = local.infinity, None
            need(x.order >= 1, "infinity is not singular")
        else:
            need(0 <= d["place"] < len(local.finite), "no such place")
            x = local.finite[d["place"]]
            need(root < p and meval(reduce(x.q), root, p) == 0, "not a root of the place modulo p")
        need(terms <= LENGTH, "too many terms")
        need(terms >= 2 and delta < p, "too few terms, or delta is not reduced")
        L = local.degree_bound_1() + sum(y.n * max(1, y.order // 2) for y in local.finite)
        L += max(1, x.order // 2) if root is None else max(0, local.infinity.order // 2 - 2) + 1
        n, e = self.expansion(p, num, den, root, x.order)
        starts = dict.fromkeys((1 + s) * (p + 1) // 2 % p if x.order <= 2 else s % p for s in (delta, -delta))
        found = [S for S in (self.riccati(n, e, x.order, s, terms, p) for s in starts) if S]
        need(len(found) == len(d["lines"]), "each line that is left needs one approximant")
        for S, line in zip(found, d["lines"]):
            C, length = line["approximant"], line["length"]
            need(len(C) <= length + 1 and all(v < p for v in C), "the approximant is too long, or not reduced")
            v = mmul(C, S, p, terms)
            k = next((i for i in range(length, len(v)) if v[i]), -1)
            need(k >= 0 and k + 1 - length > L, "a solution of the allowed degree is not excluded")

    def p_curvature(self, d, local):
        """B_p and what it excludes (p_curvature.md 1, 4, 5)."""
        p, reduce, n, e = self.good(d)
        size, e1, rows = len(n) + len(e), mdiff(e, p), [([1], [])]
        need(p * size <= 10**7 and p * p * size <= WORK, "the prime is too large for a p-curvature")
        self.spend(p * p * size)
        for k in range(p + 1):              # y^(k) = (A y + B y')/den^k
            A, B = rows[-1]
            rows.append((madd(madd(mmul(e, mdiff(A, p), p), mmul(e1, A, p), p, -k), mmul(n, B, p), p),
                         madd(madd(mmul(e, A, p), mmul(e, mdiff(B, p), p), p), mmul(e1, B, p), p, -k)))
        (A, B), (C, _) = rows[-2:]
        f, rest = mdivmod(madd(mmul(mmul(A, A, p), e, p), mmul(B, C, p), p), e, p)
        need(not rest and not any(x for i, x in enumerate(f) if i % p), "the p-curvature is not a p-th power")
        b = rest = f[::p]
        need(b, "the p-curvature is nilpotent")
        if d["shows"] == "sl2":
            need(p >= 7 and local is not None, "sl2 needs p >= 7 and a local premise")
            for q in (reduce(x.q) for x in local.finite if x.exchanges_lines()):
                while len(g := mgcd(rest, q, p)) > 1:
                    rest = mdivmod(rest, g, p)[0]
            odd_infinity = len(b) % 2 == 0 and not local.infinity.exchanges_lines()
            need(odd_infinity or len(rest) > 1 and not is_square(rest, p), "no odd place of B_p is excluded")
        else:
            need(d["shows"] == "nonzero" or d["shows"] == "irreducible" and not is_square(b, p), "B_p is a square")
        return Fact("p-curvature", shows=d["shows"], p=p)

    def no_invariant(self, d, local):
        """Sym^m has no rational solution: degree, or rank m + 1 modulo p (invariants_one_point.md 1)."""
        m = d["m"]
        need(2 <= m <= 200 and m % 2 == 0, "m must be even")
        D = local.degree_bound(m)
        if d["by"] == "degree":
            need(D < 0, "D_m is not negative")
            return Fact("no-invariant", m=m)
        need(all(x.lowest(m) is not None for x in local.finite), "the degree bound is negative: use degree")
        p, reduce, num, den = self.good(d)
        T, x0, groups, U, first = d["terms"], d["x0"], {}, [1], max(D, -1) + 1
        need(first + m + 1 <= T <= p, "too few terms, or more than the prime allows")
        need(T <= first + m + 1001, "more terms than the format has")
        need((m + 1) * T <= 2 * 10**7 and T * self.length <= WORK, "too many terms")
        self.spend(T * (self.length + (m + 1)**2))
        need(x0 < p and meval(den, x0, p), "x0 is a pole modulo p")
        n, e = mshift(num, x0, p), mshift(den, x0, p)
        y1, y2 = (self.solution(n, e, y, T, p) for y in ([1, 0], [0, 1]))
        for x in local.finite:
            k = x.lowest(m)
            groups[k] = mmul(groups.get(k, [1]), mshift(reduce(x.q), x0, p), p, T)
        for k, f in groups.items():         # U = prod q^(-k)
            need(abs(k) < 10**7, "an exponent is too large")
            if k:
                f = power(minverse(f, p, T) if k > 0 else f, abs(k), lambda x, y: mmul(x, y, p, T))
                U = mmul(U, f, p, T)
        a, b = [[1]], [U]
        for i in range(m):
            a, b = a + [mmul(a[i], y1, p, T)], b + [mmul(b[i], y2, p, T)]
        rows = [(mmul(a[i], b[m - i], p, T) + [0] * T)[first:T] for i in range(m + 1)]
        need(rank(rows, p) == m + 1, "the rank is not m + 1")
        return Fact("no-invariant", m=m)

    @staticmethod
    def solution(n, e, y, T, p):
        """The solution of e y'' = n y with given y(0), y'(0), modulo t^T."""
        u, w, n, e = pow(e[0], -1, p), [], n[::-1], e[:0:-1]     # w_i = (i+2)(i+1) y_(i+2)
        for k in range(T - 2):
            s = sum(map(mul, n[-k - 1:], y[max(0, k + 1 - len(n)):k + 1]))
            s -= sum(map(mul, e[-k:] if k else [], w[max(0, k - len(e)):k]))
            w.append(s * u % p)
            y.append(w[-1] * pow((k + 2) * (k + 1), -1, p) % p)
        return y

    def torsion_function(self, d, local, v):
        """h = (a + b w s)/c has h' = n (w/v) h, and no root of h does better (dihedral_torsion.md 6)."""
        n, a, b, c, f = d["n"], d["a"], d["b"], d["den"], v.branch
        need(n >= 1 and c.c and (a.c or b.c), "not a torsion function")
        need(n <= 10**6, "n is too large")
        A, B = v.fraction()
        first = (a.diff() * c - a * c.diff()) * A == v.w_squared * b * B * c * n
        second = ((b.diff() * c - b * c.diff()) * f * 2 + b * c * f.diff()) * A == a * B * c * (2 * n)
        need(first and second, "h' = n (w/v) h fails")
        L, left, l, seen = local.residue_denominator(v) if local else 1, n, 2, {t["l"] for t in d["minimal"]}
        while left > 1:
            k = 1
            while left % l == 0:
                left, k = left // l, k * l
            need(L % k == 0 or l in seen, "it is not shown that h is not a power")
            l += 1
        for t in d["minimal"]:
            self.need_not_a_power(t, n, a, b, c, v)
        return Fact("torsion-function", n=n, of=v)

    def need_not_a_power(self, t, n, a, b, c, v):
        """h takes values at two points whose quotient is not an l-th power modulo p."""
        p, reduce, F, square = self.reduced_curve(t, v)
        l, w, h = t["l"], t["w"], []
        need(l >= 2 and p % l == 1 and n % l == 0, "l must divide n and p - 1")
        need(w < p and (w * w - square) % p == 0, "w is not a square root of w^2 modulo p")
        need(not is_square(F, p), "F0 is a square modulo p")
        for x, s in ((t["x1"], t["s1"]), (t["x2"], t["s2"])):
            u, e, g = (meval(reduce(y), x, p) for y in (a, b, c))
            need(0 < s < p and x < p and (s * s - meval(F, x, p)) % p == 0 and g, "not a point where h is defined")
            h.append((u + e * w * s) * pow(g, -1, p) % p)
        need(h[0] and h[1] and pow(h[0] * pow(h[1], -1, p), (p - 1) // l, p) != 1, "h(1)/h(2) is a power")

    def good_reduction(self, d, local, v):
        """The curve s^2 = F0 stays smooth modulo p: a bound for torsion of order prime to p (dihedral_torsion.md 7)."""
        p, _, f, _ = self.reduced_curve(d, v)
        genus = (v.branch.degree() - 1) // 2
        need(len(mgcd(f, mdiff(f, p), p)) == 1, "F0 is not squarefree modulo p")
        return Fact("good-reduction", p=p, bound=(p + 2 + isqrt(4 * p))**genus, of=v)
