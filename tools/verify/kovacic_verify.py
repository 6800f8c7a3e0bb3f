#!/usr/bin/env python3
"""Independent checker for kovacic-certificate/1 and kovacic-strata/1 (Python 3 standard library only).

A certificate proves a statement about the differential Galois group G of y'' = r(z) y, r = num/den in K(z), K = Q(a).
docs/theory/certificates.md defines the format; the pages beside it prove the theorem behind each rule, and the numbers
in brackets below are theirs.  Nothing is searched for: each step is recomputed from r, its data and its premises.
Beside this file: exact.py has the arithmetic, certificate_format.py the reading, places.py the degree bounds; strata.py
and multivariate.py are for equations with parameters (docs/theory/strata_certificates.md).

usage: kovacic_verify.py [--strict] FILE...   (- is standard input)     exit 0 accepted, 1 rejected, 2 malformed
"""
import sys
from fractions import Fraction
from math import floor, gcd, isqrt, lcm, prod
from operator import mul
from pathlib import Path

import strata
from certificate_format import BULK, CLAIM, LENGTH, Malformed, Rejected, load, need, parse
from exact import (K, ONE, ZERO, Poly, division, irreducible, is_prime, is_square, madd, mdiff, mdivmod, meval, mgcd,
                   minverse, mmul, mpow, mshift, power, product, rank)
from places import Local, Place

WORK, TOTAL = 4 * 10**9, 2 * 10**10         # elementary operations of one step, of all steps


# ---- what checked steps establish -----------------------------------------------------------------------------------

class Fact:
    def __init__(self, kind, **data):
        self.kind = kind
        self.__dict__.update(data)


class Invariant(Fact):
    """v = p prod q^e solves Sym^m.  branch = F0, the product of the q with half-integer e.  For m = 2
    w^2 = top/bottom prod c^k over (c, k) in powers, all c not 0."""

    def fraction(self):
        """v/sqrt(F0) = A/B"""
        powers = [(q, floor(e)) for q, e in self.factors]
        size = sum(abs(e) * q.bits() for q, e in powers)
        need(all(abs(e) * q.degree() * max(1, size / LENGTH) <= LENGTH for q, e in powers), "an exponent is too large")
        return product([self.p] + [q**e for q, e in powers if e > 0]), product(q**-e for q, e in powers if e < 0)

    @property
    def holomorphic_quotient(self):
        """Is w dz/v holomorphic?  (dihedral_torsion.md 8)"""
        growth = sum(e * q.degree() for q, e in self.factors)
        return self.p.degree() <= 0 and all(2 * e <= 1 for _, e in self.factors) and 2 * growth >= 3

    def need_root(self, w, p, reduce):
        """w^2 = `w`^2 modulo p, a unit?"""
        top, bottom, *cs = (sum(reduce(c)) for c in (self.top, self.bottom, *(c for c, _ in self.powers)))
        need(top and bottom and all(cs) and w < p, "w^2 is not a unit modulo p")
        square = top * pow(bottom, -1, p) * prod(pow(c, k, p) for c, (_, k) in zip(cs, self.powers))
        need((w * w - square) % p == 0, "w is not a square root of w^2 modulo p")


# ---- the rules: each method checks the data d of one step -----------------------------------------------------------

class Checker:
    spent = 0                               # of TOTAL, by all certificates of a file

    def __init__(self, num, den):
        self.num, self.den, self.dn, self.dd = num, den, num.degree(), den.degree()
        self.length = self.dn + self.dd + 2

    def spend(self, work):
        Checker.spent += work
        need(Checker.spent <= TOTAL, "the certificate is too much work")

    def good(self, d):
        """A prime p where r is integral, and the image a of the generator: p, reduction K[z] -> F_p[z], num, den."""
        p, a = d["p"], d["a"]
        self.spend(20 * self.length)
        need(2 < p < 2**62 and is_prime(p), "p is not an odd prime below 2^62")
        need(a < p and meval(K.m, a, p) == 0, "a is not a root of the minimal polynomial modulo p")

        def reduce(f):
            need(f.q % p, "p divides a denominator")
            u, c = pow(f.q, -1, p), [meval(f.c[i:i + K.d], a, p) for i in range(0, len(f.c), K.s)]
            return madd([], c, p, u)
        return p, reduce, reduce(self.num), reduce(self.den)

    def need_squarefree(self, f, d, other=ZERO):
        p, reduce = self.good(d)[:2]
        g = reduce(f)
        need(len(mgcd(g, mdiff(g, p), p)) == 1, "not squarefree modulo p")
        need(not other.c or len(mgcd(g, reduce(other), p)) == 1, "a common factor modulo p")

    @staticmethod
    def expansion(p, num, den, root, order):
        """Numerator and denominator of t^order r, as polynomials in t = z - root; root = None: of r(1/t)/t^4."""
        if root is None:
            need(len(den) - len(num) == 4 - order, "the order at infinity changes modulo p")
            return num[::-1], den[::-1]
        need(root < p and meval(den, root, p) == 0, "not a root of the place modulo p")
        n, d = mshift(num, root, p), mshift(den, root, p)
        need(n and n[0] and len(d) > order and not any(d[:order]) and d[order], "the order changes modulo p")
        return n, d[order:]

    def riccati(self, n, d, order, s0, terms, p):
        """S = t^nu omega with S_0 = s0, modulo t^terms; None when a logarithm forbids it (riccati_one_place.md 2)."""
        nu, S = max(1, order // 2), [s0]
        need(terms * (terms + self.length) <= WORK, "too many terms")
        self.spend(terms * (terms + self.length))
        r = [0] * (2 * nu - order) + mmul(n, minverse(d, p, terms), p, terms)
        r = (r + [0] * terms)[:terms]
        need((s0 * s0 - (s0 if nu == 1 else 0) - r[0]) % p == 0, "delta is not the square root that it should be")
        for i in range(1, terms):
            rhs = r[i] - sum(map(mul, S[1:], S[:0:-1]))
            lead = (2 * s0 + (i - 1 if nu == 1 else 0)) % p
            if nu > 1 and i >= nu - 1:
                rhs -= (i - 2 * nu + 1) * S[i - nu + 1]
            if not lead:
                need(rhs % p and nu == 1, "the expansion is not unique")
                return None
            S.append(rhs * pow(lead, -1, p) % p)
        return S

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
        need(len(rows) <= 20000 and all(e["q"].degree() >= 1 and e["q"].lead() == ONE for e in rows),
             "a place is not a monic polynomial")
        need(all(1 <= e["order"] <= LENGTH for e in rows), "an order is not positive")
        need(sum(e["q"].degree() * e["order"] for e in rows) == self.dd, "the degrees do not add up to deg den")
        need(self.dd * sum(e["order"] * e["q"].bits() for e in rows) <= BULK, "the places are too large")
        need(product(e["q"]**e["order"] for e in rows) == self.den, "the product of the places is not den")
        self.need_squarefree(product(e["q"] for e in rows), d["prime"], self.num if rows else ZERO)
        claims = [(e["q"], (e["delta2"] - ONE) * e["q"].diff()) for e in rows if e["delta2"] is not None]
        need(all(e["order"] == 2 and e["delta2"].degree() < e["q"].degree() for e in rows if e["delta2"] is not None),
             "delta2 belongs to a pole of order 2")
        for q, w in claims:                 # more bits than 8 num/den'' can have modulo q: Cramer's rule
            n, of_r = q.degree(), self.num.bits() + self.den.bits() + 128
            need(K.d > 1 or w.bits() <= 2 * (n + 2) * (of_r + 4 * (self.length + n) * (q.bits() + 2)), "delta2 is wrong")
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
        need(all(abs(e) <= 10**7 and (e * (2 if m == 2 else 1)).denominator == 1 for _, e in factors),
             "exponents must be integers (half-integers for m = 2)")
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
        v = Invariant("invariant", m=m, p=P, factors=factors, top=ZERO,
                      branch=product(q for q, e in factors if e.denominator == 2))
        if m == 2:                          # w^2 at a point where S does not vanish
            z = next((z for z in range(2000) if S.at(z).c), None)
            need(z is not None, "no point to evaluate w^2")
            v.top, v.bottom = T[1].at(z)**2 - T[0].at(z) * T[2].at(z) * 2, S.at(z)**2
            v.powers = [(q.at(z), int(2 * e)) for q, e in factors if e]
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
        need(2 <= terms <= LENGTH and delta < p, "too few or too many terms, or delta is not reduced")
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
        need(0 <= T - first - m - 1 <= 1000 and T <= p and (m + 1) * T <= 2 * 10**7 and T * self.length <= WORK,
             "terms out of range")
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
        need(1 <= n <= 10**6 and c.c and (a.c or b.c), "not a torsion function")
        (A, B), top, bottom = v.fraction(), v.top, v.bottom
        need(sum(abs(k) * (1 + u.bits()) for u, k in v.powers) <= 10**8, "an exponent is too large")
        for u, k in v.powers:
            top, bottom = (top * u**k, bottom) if k > 0 else (top, bottom * u**-k)
        first = (a.diff() * c - a * c.diff()) * A * bottom == top * b * B * c * n
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
        p, reduce = self.good(t)[:2]
        l, w, F, h = t["l"], t["w"], reduce(v.branch), []
        need(l >= 2 and p % l == 1 and n % l == 0, "l must divide n and p - 1")
        need(meval(mdiff(K.m, p), t["a"], p), "the prime ramifies")
        v.need_root(w, p, reduce)
        need(not is_square(F, p), "F0 is a square modulo p")
        for x, s in ((t["x1"], t["s1"]), (t["x2"], t["s2"])):
            u, e, g = (meval(reduce(y), x, p) for y in (a, b, c))
            need(0 < s < p and x < p and (s * s - meval(F, x, p)) % p == 0 and g, "not a point where h is defined")
            h.append((u + e * w * s) * pow(g, -1, p) % p)
        need(h[0] and h[1] and pow(h[0] * pow(h[1], -1, p), (p - 1) // l, p) != 1, "h(1)/h(2) is a power")

    def good_reduction(self, d, local, v):
        """The curve s^2 = F0 stays smooth modulo p: a bound for torsion of order prime to p (dihedral_torsion.md 7)."""
        p, reduce = self.good(d)[:2]
        f, genus = reduce(v.branch), (v.branch.degree() - 1) // 2
        need(len(mgcd(f, mdiff(f, p), p)) == 1, "F0 is not squarefree modulo p")
        need(meval(mdiff(K.m, p), d["a"], p), "the prime ramifies")
        need(all(sum(reduce(c)) for c in (v.top, v.bottom, *(c for c, _ in v.powers))), "w^2 is not a unit modulo p")
        return Fact("good-reduction", p=p, bound=(p + 2 + isqrt(4 * p))**genus, of=v)


# ---- conclusions (trichotomy.md) ------------------------------------------------------------------------------------

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
    quadratic = bool(v) and v.m == 2 and bool(v.top.c)
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
    need(theorem == "torus-nonabelian" and infinite and 4 in absent, f"{theorem!r} is unknown, or a premise is missing")
    return None, None, False


def run(checker, rule, data, given):
    """One step: hands the premises to the rule by their kind."""
    local, v = (next((x for x in given if x.kind == k), None) for k in ("local", "invariant"))
    check = getattr(checker, rule.replace("-", "_"))
    if rule in ("local", "exponential", "invariant"):
        need(not given, "no premises are expected")
        return check(data)
    need(local or rule in ("p-curvature", "torsion-function", "good-reduction"), "a local premise is missing")
    if rule in ("no-exponential", "p-curvature", "no-invariant"):
        return check(data, local)
    need(v and v.m == 2 and v.branch.degree() > 0 and v.top.c, "an invariant premise is missing")
    return check(data, local, v)


def prove(top):
    """Of an ordinary certificate: the number of trusted steps, num, den and the claim `abelian`."""
    num, den, claim, steps = load(top)
    size = sum(c * c for c in K.m).bit_length() // 2 + K.d + 1
    need(K.d == 1 or size < 76 and irreducible(K.m), "the minimal polynomial is too large, or not proved irreducible")
    need(den.c and den.lead() == ONE, "den is not monic")
    need(num.c or den.degree() == 0, "r = 0 must be written with den = 1")
    checker, facts, used, trusted, result = Checker(num, den), {}, set(), 0, None
    checker.spend(10**6)
    for step in steps:
        name, rule, data = step["id"], step["rule"], step["data"]
        try:
            need(name not in facts, "the id occurs twice")
            need(all(x in facts for x in step["premises"]), "a premise is not an earlier step")
            used.update(step["premises"])
            given = [facts[x] for x in step["premises"]]
            if rule == "conclude":
                result, facts[name] = conclude(data["theorem"], given), Fact("conclusion")
            elif rule == "apply-theorem":
                need(any(x.kind == "conclusion" for x in given), "the theorem is not applied to a conclusion")
                trusted, facts[name] = trusted + 1, Fact("conclusion")
            else:
                facts[name] = run(checker, rule, data, given)
        except (Rejected, ArithmeticError, ValueError, LookupError, TypeError, AttributeError, MemoryError) as why:
            raise Rejected(f"step {name!r} ({rule}): {why}") from None
    need(steps[-1]["rule"] in ("conclude", "apply-theorem") and result, "the last step is not a conclusion")
    need(used >= {s["id"] for s in steps[:-1]}, "a step is not used")
    need(claim and ("n" not in claim or "group" in claim), "nothing is claimed")
    for key, value in zip(CLAIM, (result[0], result[1], COMPONENT[result[0]], result[2])):
        need(key not in claim or claim[key] == value, f"the claim does not follow: {key}")
    return trusted, num, den, claim.get("abelian")


def check(text):
    """The number of trusted steps and a summary; raises Malformed or Rejected."""
    top, Checker.spent = parse(text), 0
    if isinstance(top, dict) and top.get("format") == strata.FORMAT:
        return strata.verify(top, prove)
    return prove(top)[0], ""


def verify(text):
    """The number of trusted steps; raises Malformed or Rejected."""
    return check(text)[0]


def judge(name, strict):
    """The exit code for one file, and its line of output."""
    try:
        text = sys.stdin.buffer.read() if name == "-" else Path(name).read_bytes()
        need(len(text) <= 2**28, "longer than 2^28 bytes")
        trusted, summary = check(text.decode("utf-8"))
        need(not trusted or not strict, f"{trusted} trusted steps, refused by --strict")
    except (Malformed, OSError, UnicodeDecodeError) as error:
        return 2, f"malformed: {error}"
    except (Rejected, MemoryError) as error:
        return 1, f"rejected: {error or 'out of memory'}"
    return 0, f"accepted ({summary}{trusted} trusted step{'s' * (trusted != 1)})"


def main(args):
    names = [x for x in args if x != "--strict"]
    if not names:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        import resource
        resource.setrlimit(resource.RLIMIT_AS, (2**32, resource.getrlimit(resource.RLIMIT_AS)[1]))
    except (ImportError, ValueError, OSError):
        pass                                # no ceiling for the memory on this system
    worst = 0
    for name in names:
        code, line = judge(name, "--strict" in args)
        print(line if len(names) == 1 else f"{name}: {line}")
        worst = max(worst, code)
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
