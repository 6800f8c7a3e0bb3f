#!/usr/bin/env python3
"""Writes test certificates for equations with known groups (needs python3-sympy; test material only, never shipped).

usage: make_certificates.py CORPUS.jsonl OUTDIR [ID...]
The search is naive on purpose: everything modulo one prime of 2000 bits, then rational reconstruction. The expected group of
the corpus chooses the kind of proof; a wrong expectation ends in a certificate that the checkers refuse.
"""
import itertools
import json
import os
import sys
from fractions import Fraction as F

import sympy as sp

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../tools/verify"))
import kovacic_verify as V  # noqa: E402  (polynomials modulo p only)

z = sp.symbols("z")
BIG = sp.nextprime(2**2000)
P61 = 2**61 - 1


class Fail(Exception):
    pass


# ---- sympy -> strings ---------------------------------------------------------------------------------------------------

class Equation:
    def __init__(self, entry):
        def parse(text):
            return sp.sympify(text.replace("^", "**"), locals={"z": z, "I": sp.I})
        if entry.get("r", "").startswith("__dihedral"):      # F|V|w^2: r from v = V sqrt(F)
            f, v, w2 = (parse(x) for x in entry["r"].split(" ", 1)[1].split("|"))
            v = v * sp.sqrt(f)
            r = sp.simplify((w2 + 2 * v * sp.diff(v, z, 2) - sp.diff(v, z)**2) / (4 * v**2))
        elif "r" in entry:
            r = parse(entry["r"])
        else:
            p, q = parse(str(entry["p"])), parse(str(entry["q"]))
            r = p**2 / 4 + sp.diff(p, z) / 2 - q
        surds = {a for a in r.atoms(sp.Pow) if a.exp == sp.Rational(1, 2) and a.base.is_Rational}
        self.gen = None
        if r.has(sp.I):
            self.gen, self.minpoly, self.name = sp.I, [1, 0, 1], "i"
        elif surds:
            s = surds.pop()
            self.gen, self.minpoly, self.name = s, [-int(s.base), 0, 1], "s"
        else:
            self.minpoly, self.name = [0, 1], ""
        n, d = sp.fraction(sp.cancel(sp.together(r), extension=self.gen) if self.gen else sp.cancel(sp.together(r)))
        self.num, self.den = self.poly(n), self.poly(d)
        lead = self.den.LC()
        self.num, self.den = self.num.quo_ground(lead) if not self.num.is_zero else self.num, self.den.monic()
        g = self.num.gcd(self.den)
        self.num, self.den = self.num.quo(g), self.den.quo(g)
        lead = self.den.LC()
        self.num, self.den = self.num.quo_ground(lead), self.den.quo_ground(lead)
        self.K = V.K
        V.K.m, V.K.d, V.K.s = self.minpoly, len(self.minpoly) - 1, 2 * len(self.minpoly) - 3
        self.checker = V.Checker(self.vpoly(self.num), self.vpoly(self.den))
        self.local_data()

    def poly(self, e):
        return sp.Poly(e, z, extension=self.gen) if self.gen is not None else sp.Poly(e, z, domain="QQ")

    def elem(self, c):
        if self.gen is None:
            return str(sp.Rational(c))
        c = sp.expand(sp.sympify(c))
        if self.gen == sp.I:
            re, im = c.as_real_imag()
        else:
            im = c.coeff(self.gen)
            re = sp.expand(c - im * self.gen)
        re, im = sp.Rational(re), sp.Rational(im)
        return str(re) if im == 0 else [str(re), str(im)]

    def json(self, f):
        if isinstance(f, list):
            return [str(c) for c in f]
        return [] if f.is_zero else [self.elem(c) for c in reversed(f.all_coeffs())]

    def vpoly(self, f):
        return V.read("poly", self.json(f), "poly")

    def mod(self, f, p, a):
        V.need(f.q % p, "p divides a denominator")
        return V.trim(V.mscale([V.meval(f.c[i:i + V.K.d], a, p) for i in range(0, len(f.c), V.K.s)], pow(f.q, -1, p), p))

    def prime(self, start=P61, big=False, ok=lambda p, a: True):
        """A good prime of degree one with a condition."""
        p = start
        while True:
            p = sp.nextprime(p)
            a = next((a for a in self.roots(self.minpoly, p)), None)
            if a is None:
                continue
            try:
                self.mod(self.checker.num, p, a), self.mod(self.checker.den, p, a)
                if ok(p, a):
                    return int(p), int(a)
            except V.Rejected:
                pass

    @staticmethod
    def roots(f, p):
        if len(f) == 2:
            return [-f[0] * pow(f[1], -1, p) % p]
        if p < 2000:
            return [x for x in range(p) if V.meval(f, x, p) == 0]
        g = V.mgcd(f, V.madd(V.mpow([0, 1], p, f, p), [0, 1], p, -1), p)
        todo, out, s = [g], [], 0
        while todo:
            g = todo.pop()
            if len(g) == 2:
                out.append(-g[0] * pow(g[1], -1, p) % p)
            elif len(g) > 2:
                s += 1
                h = V.mgcd(g, V.madd(V.mpow([s, 1], (p - 1) // 2, g, p), [1], p, -1), p)
                todo += [h, V.mdivmod(g, h, p)[0]] if 1 < len(h) < len(g) else [g]
        return sorted(out)

    # ---- local data ------------------------------------------------------------------------------------------------------

    def local_data(self):
        self.places, self.delta, self.logs = [], [], []
        den2 = self.den.diff(z).diff(z) if self.den.degree() > 1 else self.poly(0)
        factors = [] if self.den.degree() < 1 else self.den.factor_list()[1]
        for q, k in factors:
            q = q.monic()
            e = {"q": self.json(q), "order": str(k)}
            delta = "irregular" if k > 2 else F(1)
            if k == 2:
                inv = sp.invert(den2.rem(q), q) if q.degree() > 0 else None
                d2 = (self.poly(1) + (self.num * 8 * inv).rem(q)).rem(q)
                delta = None
                if d2.degree() <= 0:
                    c = sp.expand(d2.as_expr())
                    if c.is_Rational:
                        delta = V.sqrt_exact(F(int(c.p), int(c.q)))
                    e["delta2"] = self.json(d2)
                    if not c.is_Rational:
                        e["annihilator"] = self.annihilator(c)
                else:
                    e["delta2"] = self.json(d2)
                    e["irrational"] = self.irrational(q, d2)
                    chi = sp.Poly(sp.resultant(q.as_expr(), sp.Symbol("T") - d2.as_expr(), z), sp.Symbol("T"))
                    e["annihilator"] = [str(c) for c in reversed(chi.all_coeffs())]
            if k > 2 and k % 2 == 0 and q.degree() == 1:
                c = sp.expand(-q.all_coeffs()[1])
                e["eps2"], ann = self.eps2(lambda i: self.taylor(self.num, c, i), lambda i: self.taylor(self.den, c, i + k), k)
                if ann:
                    e["annihilator"] = ann
            self.places.append((q, k, e))
            self.delta.append(delta)
        self.o = self.den.degree() - self.num.degree() if not self.num.is_zero else 99
        self.inf = {}
        self.k_inf = 4 - self.o
        self.delta_inf = F(1) if self.k_inf <= 1 else "irregular"
        if self.k_inf == 2:
            c = sp.expand(1 + 4 * self.num.LC())
            self.delta_inf = V.sqrt_exact(F(int(c.p), int(c.q))) if c.is_Rational else None
            if not c.is_Rational:
                self.inf["annihilator"] = self.annihilator(c)
        elif self.k_inf > 2 and self.k_inf % 2 == 0:
            n, d = self.num.all_coeffs(), self.den.all_coeffs()
            self.inf["eps2"], ann = self.eps2(lambda i: n[i] if i < len(n) else 0, lambda i: d[i] if i < len(d) else 0, self.k_inf)
            if ann:
                self.inf["annihilator"] = ann
        for (q, k, e), delta in zip(self.places, self.delta):
            if k == 2 and isinstance(delta, F) and delta.denominator == 1 and delta >= 1:
                w = self.log_witness(q, delta)
                if w:
                    e["log"] = w
        if self.k_inf == 2 and isinstance(self.delta_inf, F) and self.delta_inf.denominator == 1 and self.delta_inf >= 1:
            w = self.log_witness(None, self.delta_inf)
            if w:
                self.inf["log"] = w
        self.has_log = any("log" in e or k == 1 or d == 0 for (q, k, e), d in zip(self.places, self.delta)) or \
            self.k_inf == 1 or self.delta_inf == 0 or "log" in self.inf
        self.infinite = any(k > 2 or d is None for (_, k, _), d in zip(self.places, self.delta)) or self.k_inf > 2 or self.delta_inf is None

    def annihilator(self, c):
        T = sp.Symbol("T")
        return [str(x) for x in reversed(sp.Poly(sp.minimal_polynomial(c, T), T).all_coeffs())]

    def taylor(self, f, c, i):
        g = f
        for _ in range(i):
            g = g.diff(z)
        return sp.expand(g.eval(c) / sp.factorial(i))

    def eps2(self, n, d, k):
        nu = k // 2
        t = sp.Symbol("t")
        N = [sp.sympify(n(i)) for i in range(nu)]
        D = [sp.sympify(d(i)) for i in range(nu)]
        s = sp.radsimp
        inv = [1 / D[0]]
        for i in range(1, nu):
            inv.append(s(sp.expand(-sum(D[j] * inv[i - j] for j in range(1, i + 1)) / D[0])))
        R = [s(sp.expand(sum(N[j] * inv[i - j] for j in range(i + 1)))) for i in range(nu)]
        sig = [sp.Integer(1)]
        for i in range(1, nu):
            sig.append(s(sp.expand((R[i] / R[0] - sum(sig[j] * sig[i - j] for j in range(1, i))) / 2)))
        e = s(sp.expand(4 * R[0] * sig[nu - 1]**2))
        return ([] if e == 0 else [self.elem(e)]), (None if e.is_Rational else self.annihilator(e))

    def irrational(self, q, d2):
        p = 2
        while True:
            p, a = self.prime(p)
            try:
                qq = self.mod(self.vpoly(q), p, a)
                e = V.mdivmod(self.mod(self.vpoly(d2), p, a), qq, p)[1]
            except V.Rejected:
                continue
            v = V.madd(V.mpow(e, (p + 1) // 2, qq, p), e, p, -1)
            if p > 2 and v and len(V.mgcd(v, qq, p)) == 1:
                dd = self.mod(self.checker.den.diff().diff(), p, a)
                if len(V.mgcd(dd, qq, p)) == 1:
                    return {"p": str(p), "a": str(a)}

    def log_witness(self, q, delta):
        p = 10**6
        for _ in range(200):
            p, a = self.prime(p)
            if q is None:
                try:
                    self.checker.need_log({"p": p, "a": a}, None, delta)
                    return {"p": str(p), "a": str(a)}
                except V.Rejected:
                    return None
            roots = self.roots(self.mod(self.vpoly(q), p, a), p)
            good = []
            for c in roots:
                try:
                    self.checker.need_log({"p": p, "a": a}, c, delta)
                    good.append(c)
                except V.Rejected:
                    pass
            if roots and not good:
                return None
            if len(good) == q.degree() or (good and q.degree() > 3):
                return {"p": str(p), "a": str(a), "roots": [str(c) for c in good]}
        return None

    def squarefree_prime(self, f):
        p, a = self.prime()
        return {"p": str(p), "a": str(a)}

    def local_step(self):
        p, a = self.prime()
        return {"id": "local", "rule": "local", "premises": [],
                "data": {"prime": {"p": str(p), "a": str(a)}, "places": [e for _, _, e in self.places], "infinity": self.inf}}

    def facts(self):
        return self.checker.local(V.read(V.RULES["local"], self.local_step()["data"], "local"))

    # ---- engines: modulo one prime -----------------------------------------------------------------------------------------

    def kernel(self, m, exps, D, p, a, x0):
        """Polynomials P of degree <= D with P prod q^e in Sym^m, as rows modulo p (reduced echelon form)."""
        c = self.checker
        num, den = self.mod(c.num, p, a), self.mod(c.den, p, a)
        extra = sum(q.degree() * max(1, k // 2) for q, k, _ in self.places) * (m + 1) + (m + 1) * (2 + max(0, -self.o))
        T = max(D, 0) + m + 2 + extra + 10
        n, e = V.mshift(num, x0, p), V.mshift(den, x0, p)
        ys = [c.solution(n, e, y, T, p) for y in ([1, 0], [0, 1])]
        U = [1]
        for (q, _, _), ex in zip(self.places, exps):
            f = V.mshift(self.mod(self.vpoly(q), p, a), x0, p)
            f = [v * pow(f[0], -1, p) % p for v in f]
            # f^(-ex): g' f = -ex f' g
            g = [1]
            r = -ex.numerator * pow(ex.denominator, -1, p) % p
            for k in range(1, T):
                s = 0
                for j in range(1, min(k, len(f) - 1) + 1):
                    s += f[j] * g[k - j] * (r * j - (k - j))
                g.append(s * pow(k, -1, p) % p)
            U = V.mmul(U, g, p, T)
        rows = []
        for i in range(m + 1):
            v = U
            for _ in range(i):
                v = V.mmul(v, ys[0], p, T)
            for _ in range(m - i):
                v = V.mmul(v, ys[1], p, T)
            rows.append((v + [0] * T)[:T])
        # combinations with zero coefficients D+1..T-1: eliminate columns from the right end
        cols = list(range(D + 1, T))
        rows = [[v % p for v in r] for r in rows]
        live = rows
        for col in cols:
            piv = next((r for r in live if r[col]), None)
            if piv is None:
                continue
            u = pow(piv[col], -1, p)
            new = []
            for r in live:
                if r is piv:
                    continue
                if r[col]:
                    t = r[col] * u % p
                    r = [(x - t * y) % p for x, y in zip(r, piv)]
                new.append(r)
            live = new
        live = [V.mshift(r[:D + 1], -x0 % p, p) for r in live]
        out = []
        for col in range(D, -1, -1):                      # echelon form from the top degree
            piv = next((r for r in live if len(r) > col and r[col]), None)
            if piv is None:
                continue
            live.remove(piv)
            u = pow(piv[col], -1, p)
            piv = [v * u % p for v in piv]
            live = [[(x - r[col] * y) % p for x, y in zip(r, piv)] if r[col] else r for r in live]
            out = [[(x - r[col] * y) % p for x, y in zip(r, piv)] if r[col] else r for r in out] + [piv]
        return [V.trim(r) for r in out]

    def lowest(self, m, i):
        k, delta = self.places[i][1], self.delta[i]
        return self.low(k, delta, m, "log" in self.places[i][2] and len(self.places[i][2]["log"].get("roots", [])) == self.places[i][0].degree())

    @staticmethod
    def low(k, delta, m, log):
        if k <= 0:
            return F(0)
        if k == 1:
            return F(m)
        if k > 2:
            return F(m * k, 4)
        if delta is None:
            return F(m, 2)
        if log or delta == 0:
            return F(m, 2) * (1 + delta)
        i = m // 2 // delta.denominator * delta.denominator
        return F(m, 2) - i * delta

    def degree(self, m, exps):
        e_inf = self.low(self.k_inf, self.delta_inf, m, "log" in self.inf)
        return m - e_inf - sum(q.degree() * e for (q, _, _), e in zip(self.places, exps))

    def invariants(self, m):
        """(exponents, list of P over Q) or None."""
        exps = [self.lowest(m, i) for i in range(len(self.places))]
        D = self.degree(m, exps)
        if D < 0 or any(e.denominator > 1 for e in exps) or D.denominator > 1:
            return exps, []
        return exps, [self.lift(r) for r in self.kernel(m, exps, int(D), BIG, 0, 12345)]

    @staticmethod
    def lift(row, p=BIG):
        out = []
        for v in row:
            a, b = p, v
            s0, s1 = 0, 1
            while b * b * 2 > p:
                q = a // b
                a, b, s0, s1 = b, a - q * b, s1, s0 - q * s1
            out.append(F(b, s1))
        return out

    def quadratic(self, half):
        """v with v^2 rational: half = does v branch at place i?"""
        exps = []
        for i, h in enumerate(half):
            k, delta = self.places[i][1], self.delta[i]
            if h:
                if k == 2 and delta is not None and delta.denominator == 2:
                    exps.append(1 - delta)
                elif k > 2 and k % 2:
                    exps.append(F(k, 2))
                else:
                    return None
            else:
                e = self.lowest(2, i)
                if e.denominator > 1:
                    return None
                exps.append(e)
        e_inf = self.low(self.k_inf, self.delta_inf, 2, "log" in self.inf)
        if self.k_inf == 2 and self.delta_inf is not None:
            e_inf = 1 - self.delta_inf if "log" not in self.inf else 1 + self.delta_inf
        D = (2 - e_inf - sum(q.degree() * e for (q, _, _), e in zip(self.places, exps))).__floor__()
        if D < 0:
            return None
        rows = self.kernel(2, exps, D, BIG, 0, 12345)
        return (exps, rows) if rows else None

    def invariant_step(self, m, exps, P, name):
        p, a = self.prime()
        # move factors q out of P
        return {"id": name, "rule": "invariant", "premises": [], "data": {
            "prime": {"p": str(p), "a": str(a)}, "m": str(m), "p": [str(c) for c in P],
            "factors": [{"q": e["q"], "e": str(x)} for (_, _, e), x in zip(self.places, exps)]}}

    def riccati_places(self):
        """(place name, root, order, delta mod p or chosen root, p, a) to try, best first."""
        todo = []
        for i, (q, k, e) in enumerate(self.places):
            d = self.delta[i]
            kind = 0 if k == 1 or d == 0 or "log" in e else 1 if (k == 2 and (d is None or d.denominator > 1)) or (k > 2 and k % 2 == 0) else 9
            todo.append((kind, q.degree(), i))
        d = self.delta_inf
        if self.k_inf >= 1:
            kind = 0 if self.k_inf == 1 or d == 0 or "log" in self.inf else 1 if d is None or self.k_inf > 2 or d.denominator > 1 else 9
            todo.append((kind, 1, "infinity"))
        return [t[2] for t in sorted(todo, key=lambda t: t[:2]) if t[0] < 9]

    def expand(self, place, start, L):
        """Prime, root, delta, lines (S of each line)."""
        c = self.checker
        p = start
        for _ in range(400):
            p, a = self.prime(p)
            num, den = self.mod(c.num, p, a), self.mod(c.den, p, a)
            if place == "infinity":
                root, k = None, self.k_inf
            else:
                q, k, _ = self.places[place]
                roots = self.roots(self.mod(self.vpoly(q), p, a), p)
                if not roots:
                    continue
                root = roots[0]
            try:
                n, e = c.expansion(p, num, den, root, k)
            except V.Rejected:
                continue
            lead = n[0] * pow(e[0], -1, p) % p if k > 1 else 0
            d2 = (1 + 4 * lead) % p if k <= 2 else lead
            if d2 and pow(d2, (p - 1) // 2, p) != 1:
                continue
            d = int(sp.sqrt_mod(d2, p))
            if d * d % p != d2:
                continue
            dd = self.delta_inf if place == "infinity" else self.delta[place]
            if k <= 2 and isinstance(dd, F):
                d = dd.numerator * pow(dd.denominator, -1, p) % p
            terms = 2 * L + 8
            if k <= 2 and isinstance(dd, F) and dd.denominator == 1:
                terms = max(terms, int(dd) + 2)
            h = pow(2, -1, p)
            starts = [(1 + d) * h % p, (1 - d) * h % p] if k <= 2 else [d, -d % p]
            lines = [c.riccati(n, e, k, s, terms, p) for s in dict.fromkeys(starts)]
            return p, a, root, d, terms, k, [S for S in lines if S]
        raise Fail("no prime for the expansion")

    def bm(self, S, p, L):
        """Berlekamp-Massey; returns ('short', C, len) or ('long', C, len) when the complexity is proved > L."""
        C, B, l, m, b = [1], [1], 0, 1, 1
        for i, s in enumerate(S):
            d = (s + sum(C[j] * S[i - j] for j in range(1, min(l, len(C) - 1) + 1))) % p
            if not d:
                m += 1
                continue
            if 2 * l <= i and i + 1 - l > L:
                return "long", C[:l + 1], l
            T = C[:]
            f = d * pow(b, -1, p) % p
            C = C + [0] * (len(B) + m - len(C))
            for j, y in enumerate(B):
                C[j + m] = (C[j + m] - f * y) % p
            if 2 * l <= i:
                l, B, b, m = i + 1 - l, T, d, 1
            else:
                m += 1
        return "short", V.trim(C[:l + 1]), l

    def bound(self, place):
        f = self.facts()
        D1 = f.degree_bound_1()
        M = sum(y.n * max(1, y.order // 2) for y in f.places) + D1
        x = f.infinity if place == "infinity" else None
        return D1, M + (max(0, f.infinity.order // 2 - 2) + 1 if x is None else max(1, x.order // 2))

    def exponential_step(self):
        for place in self.riccati_places():
            D1, L = self.bound(place)
            start = BIG
            p, a, root, d, terms, k, lines = self.expand(place, start, L)
            for S in lines:
                kind, C, l = self.bm(S, p, L)
                if kind == "long":
                    continue
                N = V.mmul(C, S, p, max(l, 1))
                nu = max(1, k // 2)
                # t^nu omega = N/C in t = z - root
                if root is not None:
                    A = V.mshift(N, -root % p, p)
                    B = V.mmul(V.mshift(C, -root % p, p), V.mpow([-root % p, 1], nu, [0] * (nu + 1) + [1], p), p)
                else:                                   # Omega(t) = N/(C t^nu); omega = t - t^2 Omega, t = 1/z
                    n1 = V.madd(V.mmul([0] * (nu + 1) + [1], C, p), V.mmul([0, 0, 1], N, p), p, -1)
                    d1 = V.mmul([0] * nu + [1], C, p)
                    deg = max(len(n1), len(d1)) - 1
                    A = V.trim((n1 + [0] * (deg + 1 - len(n1)))[::-1])
                    B = V.trim((d1 + [0] * (deg + 1 - len(d1)))[::-1])
                g = V.mgcd(A, B, p)
                A, B = V.mdivmod(A, g, p)[0], V.mdivmod(B, g, p)[0]
                u = pow(B[-1], -1, p)
                A, B = [v * u % p for v in A], [v * u % p for v in B]
                step = {"id": "exponential", "rule": "exponential", "premises": [],
                        "data": {"p": ["1"], "num": [str(v) for v in self.lift(A, p)], "den": [str(v) for v in self.lift(B, p)]}}
                try:
                    self.checker.exponential(V.read(V.RULES["exponential"], step["data"], "e"))
                    return self.split_exponential(step)
                except V.Rejected:
                    pass
        raise Fail("no exponential found")

    def split_exponential(self, step):
        """Moves the apparent zeros into p, to exercise that field."""
        n, d = (sp.Poly([sp.Rational(c) for c in reversed(step["data"][k])], z, domain="QQ") for k in ("num", "den"))
        P = sp.Poly(1, z, domain="QQ")
        for q, k in d.factor_list()[1]:
            if k == 1 and self.den.rem(q).is_zero is False:
                P = P * q
        if P.degree() > 0:
            w = sp.cancel(n.as_expr() / d.as_expr() - P.diff(z).as_expr() / P.as_expr())
            n, d = sp.fraction(sp.together(w))
            n, d = sp.Poly(n, z, domain="QQ"), sp.Poly(d, z, domain="QQ")
            step["data"] = {"p": self.json(P), "num": self.json(n), "den": self.json(d)}
        return step

    # ---- negative steps ------------------------------------------------------------------------------------------------------

    def irreducible_step(self):
        step = {"id": "irreducible", "rule": "no-exponential", "premises": ["local"], "data": {"by": "parity"}}
        if any(k > 2 and k % 2 for _, k, _ in self.places) or self.k_inf > 2 and self.k_inf % 2:
            return step
        f = self.facts()
        try:
            if f.degree_bound_1() < 0:
                step["data"] = {"by": "degree"}
                return step
        except V.Rejected:
            pass
        for place in self.riccati_places():
            D1, L = self.bound(place)
            p, a, root, d, terms, k, lines = self.expand(place, P61, L)
            out = []
            for S in lines:
                kind, C, l = self.bm(S, p, L)
                if kind == "short":
                    break
                out.append({"length": str(l), "approximant": [str(c) for c in C]})
            else:
                step["data"] = {"by": "series", "place": str(place), "p": str(p), "a": str(a), "root": str(root or 0), "delta": str(d),
                                "terms": str(terms), "lines": out}
                return step
        raise Fail("not proved irreducible")

    def absent_step(self, m):
        name = f"no-invariant-{m}"
        step = {"id": name, "rule": "no-invariant", "premises": ["local"], "data": {"m": str(m), "by": "degree"}}
        D = self.facts().degree_bound(m)
        if D < 0:
            return step
        p, a = self.prime()
        step["data"] = {"m": str(m), "by": "series", "p": str(p), "a": str(a), "x0": "1234567", "terms": str(D + 2 * m + 8)}
        self.checker.no_invariant(V.read(V.RULES["no-invariant"], step["data"], "n"), self.facts())
        return step

    def pcurvature_step(self, shows, start=6):
        p = start
        for _ in range(6):
            p, a = self.prime(p)
            d = {"p": str(p), "a": str(a), "shows": shows}
            try:
                self.checker.p_curvature(V.read(V.RULES["p-curvature"], d, "p"), self.facts())
                return {"id": "p-curvature", "rule": "p-curvature", "premises": ["local"] if shows == "sl2" else [], "data": d}
            except V.Rejected:
                pass
        return None


def conclude(theorem, *premises):
    return {"id": "conclusion", "rule": "conclude", "premises": list(premises), "data": {"theorem": theorem}}


# ---- one proof for each group ---------------------------------------------------------------------------------------------------

def prove_sl2(E, variants):
    out = []
    local = E.local_step()
    s = E.pcurvature_step("sl2")
    if s:
        out.append([local, s, conclude("sl2-p-curvature", "p-curvature")])
        if not variants:
            return out
    try:
        irr = E.irreducible_step()
        if E.has_log:
            out.append([local, irr, conclude("sl2-irreducible-log", "local", "irreducible")])
        else:
            try:
                no = E.absent_step(4)
                out.append([local, irr, no, conclude("sl2-irreducible-infinite", "local", "irreducible", no["id"])])
                need_ok(E, out[-1], "SL2", None)
            except (V.Rejected, Fail):
                out = out[:-1] if out and out[-1][-1]["data"]["theorem"] == "sl2-irreducible-infinite" else out
                no = E.absent_step(12)
                out.append([local, irr, no, conclude("sl2-irreducible-12", "irreducible", no["id"])])
    except (Fail, V.Rejected) as e:
        if not out:
            raise
    return out


def need_ok(E, steps, group, n):
    V.verify(json.dumps(certificate(E, group, n, steps)))


def prove_nondiagonal(E):
    return [] if E.has_log else [E.absent_step(2)]


def prove_reducible(E, theorem):
    extra = prove_nondiagonal(E)
    return [[E.local_step(), E.exponential_step(), *extra, conclude(theorem, "local", "exponential", *[s["id"] for s in extra])]]


def prove_diagonal(E):
    found = E.quadratic([False] * len(E.places))
    if not found:
        raise Fail("no invariant of degree 2")
    exps, rows = found
    for row in rows + ([[(x + y) for x, y in itertools.zip_longest(rows[0], rows[1], fillvalue=0)]] if len(rows) > 1 else []):
        steps = [E.local_step(), E.invariant_step(2, exps, E.lift(row), "invariant"), conclude("diagonal", "local", "invariant")]
        try:
            x = E.checker.invariant(V.read(V.RULES["invariant"], steps[1]["data"], "i"))
            if x.top.c:
                return [steps]
        except V.Rejected:
            pass
    raise Fail("w^2 = 0 for all that was tried")


def prove_dihedral(E, n):
    half = [i for i in range(len(E.places)) if (E.places[i][1] == 2 and E.delta[i] is not None and E.delta[i].denominator == 2) or
            (E.places[i][1] > 2 and E.places[i][1] % 2)]
    for size in range(1, len(half) + 1):
        for chosen in itertools.combinations(half, size):
            found = E.quadratic([i in chosen for i in range(len(E.places))])
            if not found:
                continue
            exps, rows = found
            for row in rows:
                P = E.lift(row)
                inv = E.invariant_step(2, exps, P, "invariant")
                local = E.local_step()
                try:
                    v = E.checker.invariant(V.read(V.RULES["invariant"], inv["data"], "i"))
                except V.Rejected:
                    continue
                if not v.top.c:
                    continue
                if E.infinite:
                    return [[local, inv, conclude("dihedral-infinite", "local", "invariant")]]
                if v.branch.deg() <= 2:
                    return [[local, inv, conclude("dihedral-genus-0", "local", "invariant")]]
                if n is not None:
                    return [finite_dihedral(E, local, inv, v, n, P, exps)]
                return [infinite_dihedral(E, local, inv, v, P, exps)]
    exps, rows = E.invariants(4)
    if n == 2 and len(rows) == 2:
        return [[E.local_step(), E.irreducible_step(), E.invariant_step(4, exps, rows[0], "first"), E.invariant_step(4, exps, rows[1], "second"),
                 conclude("quaternion", "irreducible", "first", "second")]]
    raise Fail("no quadratic invariant")


def sym(poly):
    return sp.Poly([sp.Rational(int(poly.coeff(i).c[0]) if poly.coeff(i).c else 0, poly.coeff(i).q) for i in range(poly.deg(), -1, -1)] or [0], z, domain="QQ")


def square_of_w(v):
    w2 = v.top.rational() / v.bottom.rational()
    for c, k in v.powers:
        w2 *= c.rational()**k
    return sp.Rational(w2.numerator, w2.denominator)


def finite_dihedral(E, local, inv, v, n, P, exps):
    A, B = (sym(x) for x in v.fraction())
    f0 = sym(v.branch)
    w2 = square_of_w(v)
    C = sp.Poly(1, z, domain="QQ")
    if sym(v.p).degree() > 0:
        C = C * sym(v.p)**n
    for i, ((q, k, _), e) in enumerate(zip(E.places, exps)):
        if e == 1 and E.delta[i]:
            C = C * q**int(n * E.delta[i])
    extra = int(n * E.delta_inf) if f0.degree() % 2 == 0 else 0
    deg = C.degree() + extra
    # cosh(n int w/v) = a/C: v (v A')' = n^2 w^2 A, v = (A/B) sqrt(F0)
    unknowns = sp.symbols("a0:%d" % (deg + 1))
    a = sum(u * z**i for i, u in enumerate(unknowns))
    vv = A.as_expr() / B.as_expr()
    f = a / C.as_expr()
    eq = sp.numer(sp.together(vv * f0.as_expr() * sp.diff(vv * sp.diff(f, z), z) + vv**2 * sp.diff(f0.as_expr(), z) / 2 * sp.diff(f, z) - n**2 * w2 * f))
    eqs = sp.Poly(sp.expand(eq), z).all_coeffs()
    M = sp.Matrix([[sp.diff(e, u) for u in unknowns] for e in eqs])
    ns = M.nullspace()
    if not ns:
        raise Fail("no torsion function")
    a = sp.Poly(list(reversed(list(ns[0]))), z, domain="QQ")
    g = a.gcd(C)
    Af = a.as_expr() / C.as_expr()
    Bf = sp.cancel(sp.together(sp.diff(Af, z) * vv / (n * w2)))
    bn, bd = sp.fraction(Bf)
    bn, bd = sp.Poly(bn, z, domain="QQ"), sp.Poly(bd, z, domain="QQ")
    den = C.lcm(bd)
    a, b = a * den.quo(C), bn * den.quo(bd)
    lf = E.facts()
    L = lf.residue_denominator(v)
    minimal = []
    for l in sp.primefactors(n):
        if sp.multiplicity(l, n) == sp.multiplicity(l, L) if L % l == 0 else False:
            continue
        minimal.append(power_witness(E, l, f0, a, b, den, v))
    step = {"id": "torsion", "rule": "torsion-function", "premises": ["invariant", "local"],
            "data": {"n": str(n), "a": E.json(a), "b": E.json(b), "den": E.json(den), "minimal": minimal}}
    return [local, inv, step, conclude("dihedral-finite", "invariant", "torsion")]


def power_witness(E, l, f0, a, b, den, v):
    p = 50
    while True:
        p, aa = E.prime(p)
        if p % l != 1:
            continue
        try:
            fa, fb, fd, ff = (E.mod(E.vpoly(x), p, aa) for x in (a, b, den, f0))
            r = square_of_w(v)
            if r.q % p == 0:
                continue
        except V.Rejected:
            continue
        w2 = int(r.p) * pow(int(r.q), -1, p) % p
        if not w2 or pow(w2, (p - 1) // 2, p) != 1 or V.is_square(ff, p):
            continue
        w = int(sp.sqrt_mod(w2, p))
        pts = []
        for x in range(p):
            y = V.meval(ff, x, p)
            g = V.meval(fd, x, p)
            if y and g and pow(y, (p - 1) // 2, p) == 1:
                s = int(sp.sqrt_mod(y, p))
                h = (V.meval(fa, x, p) + V.meval(fb, x, p) * w * s) * pow(g, -1, p) % p
                if h:
                    pts.append((x, s, pow(h, (p - 1) // l, p)))
        for x, s, c in pts[1:]:
            if c != pts[0][2]:
                return {"l": str(l), "p": str(p), "a": str(aa), "w": str(w), "x1": str(pts[0][0]), "s1": str(pts[0][1]), "x2": str(x), "s2": str(s)}
        if p > 400:
            raise Fail("h seems to be a power of exponent %d" % l)


def infinite_dihedral(E, local, inv, v, P, exps):
    L = E.facts().residue_denominator(v)
    q, step = 2, None
    while step is None:
        q, a = E.prime(q)
        try:
            d = {"p": str(q), "a": str(a)}
            bound = E.checker.good_reduction(V.read(V.RULES["good-reduction"], d, "g"), None, v).bound
            step = {"id": "reduction", "rule": "good-reduction", "premises": ["invariant"], "data": d}
        except V.Rejected:
            pass
    curvatures, product, p = [], 1, 2
    while product <= bound:
        pc = E.pcurvature_step("nonzero", p)
        if pc is None:
            raise Fail("no p-curvature")
        p = int(pc["data"]["p"])
        if p != q and 2 * L % p:
            product *= p
            curvatures.append(pc | {"id": f"p-curvature-{p}"})
    return [local, inv, step, *curvatures, conclude("dihedral-torsion", "local", "invariant", "reduction", *[s["id"] for s in curvatures])]


def prove_primitive(E, m, absent, theorem):
    irr = E.irreducible_step()
    exps, rows = E.invariants(m)
    if not rows:
        raise Fail("no invariant")
    no = [E.absent_step(k) for k in absent]
    return [[E.local_step(), irr, *no, E.invariant_step(m, exps, rows[0], "invariant"),
             conclude(theorem, "irreducible", "invariant", *[s["id"] for s in no])]]


def certificate(E, group, n, steps):
    component = V.COMPONENT[group] if group else None
    used = {x for s in steps for x in s["premises"]} | {steps[-1]["id"]}
    return {"format": "kovacic-certificate/1", "field": {"name": E.name, "minpoly": [str(c) for c in E.minpoly]},
            "r": {"num": E.json(E.num), "den": E.json(E.den)},
            "claim": {"group": group, "n": None if n is None else str(n), "component": component, "abelian": group not in ("SL2", "Borel")},
            "steps": [s for s in steps if s["id"] in used]}


NAMES = {"SL2": ("SL2", None), "B": ("Borel", None), "Ga": ("T", 1), "D": ("Gm", None), "trivial": ("cyclic", 1), "Dinf": ("Dinf", None),
         "A4_SL2": ("A4", None), "S4_SL2": ("S4", None), "A5_SL2": ("A5", None)}


def group_of(text):
    if text in NAMES:
        return NAMES[text]
    kind, n = text.split("_")
    return {"T": "T", "C": "cyclic", "D": "D"}[kind], int(n)


def prove(entry, variants=True):
    E = Equation(entry)
    group, n = group_of(entry["expected"]["group"])
    if group == "SL2":
        proofs = prove_sl2(E, variants)
    elif group in ("Borel", "T"):
        proofs = prove_reducible(E, "borel" if group == "Borel" else "additive")
    elif group in ("Gm", "cyclic"):
        proofs = prove_diagonal(E)
    elif group in ("Dinf", "D"):
        proofs = prove_dihedral(E, n)
    else:
        proofs = prove_primitive(E, *{"A4": (6, [4], "tetrahedral"), "S4": (8, [4, 6], "octahedral"), "A5": (12, [8], "icosahedral")}[group])
    return [certificate(E, group, n, steps) for steps in proofs]


def main(corpus, out, *only):
    os.makedirs(out, exist_ok=True)
    good = bad = 0
    for line in open(corpus):
        entry = json.loads(line)
        if entry.get("parameters") or (only and entry["id"] not in only):
            continue
        try:
            for i, c in enumerate(prove(entry)):
                text = json.dumps(c, indent=None, separators=(",", ":"))
                V.verify(text)
                name = entry["id"] + ("-%d" % (i + 1) if i else "")
                with open(os.path.join(out, name + ".json"), "w") as f:
                    f.write(text + "\n")
                good += 1
        except (Fail, V.Rejected, V.Malformed) as why:
            bad += 1
            print(entry["id"], entry["expected"]["group"], type(why).__name__, why, flush=True)
    print(f"{good} certificates written, {bad} equations without one")
    return bad


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) > 0)
