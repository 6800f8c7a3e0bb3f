"""Checks certificates over strata, kovacic-strata/1 (docs/theory/strata_certificates.md; (1) to (7) are its sections).

Nothing is searched for: the tree covers all values of the parameters by construction, a node changes the state as (3) to (5) say, and a leaf
is recomputed from the state and its own data.  multivariate.py has the polynomials; z has the first field, so it is variable 0."""
import re
from collections import Counter
from copy import copy
from fractions import Fraction
from math import ceil, isqrt, lcm

from certificate_format import Malformed, Rejected, need, read
from exact import ZERO, K, Poly, exact_sqrt
from multivariate import (FIELD, MASK, ONE, P, Work, determinant, parse, product, pseudo_remainder, quotient, ratio, remove, resultant,
                          spend)
from places import Local, Place

FORMAT, Z = "kovacic-strata/1", 0
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")
FRACTION = {"num": "text", "den": "text"}
TOP = {"format": "text", "variable": "text", "parameters": ["text"], "real": ["text"], "generic": [["text"]], "r": FRACTION,
       "assumptions": [{"p": "text", "sign": "text"}], "claim": {"abelian": "any"}, "tree": "any"}
LEMMA = {"p": "text", "times?": "text", "sign": "text", "terms": ["any"]}
REGULAR = {"chi?": ["text"], "irrational?": "text", "log?": "truth", "bound?": "rational"}
PLACED = {"content": "text", "places": [REGULAR | {"q": "text", "order": "int"}], "infinity": REGULAR,
          "absent?": [{"m": "int", "minors": [{"rows": ["int"], "times": "text"}]}]}
LEAVES = {"number": {"certificate": "any"},
          "invariant": {"content": "text", "places": [{"q": "text", "order": "int", "e": "int"}], "m": "int", "p": "text"}}
LEAVES |= dict.fromkeys(("torus-log", "torus", "irreducible-log", "rational", "one-open", "open"), PLACED)
ENDS = {"empty": {"terms?": ["any"]}, "outside": {"generic?": "int"}, "open": {"reason": "text"},
        "trusted": {"abelian": "text", "theorem": "text", "statement": "text"}}
NODES = ENDS | {"split": {"p": "text", "nonzero": "any", "zero": "any"}, "assumed": {"condition": "int", "p": "text", "zero": "any"},
                "lemmas": {"lemmas": [LEMMA], "then": "any"}, "leaf": {"abelian": "text", "by": LEAVES}}
ZEROS = ENDS | {"solve": {"variable": "text", "r?": FRACTION, "then": "any"},
                "root": {"variable": "text", "certificate": "any", "abelian": "text"}}


def choose(table, key, v):
    """The name of the variant, and its data."""
    name = v.get(key) if isinstance(v, dict) else None
    if not isinstance(name, str) or name not in table:
        raise Malformed(f"{key!r} is unknown: {str(name)[:60]!r}")
    return name, read(table[name] | {key: "text"}, v, name)


class Stratum:
    """The state at a node (3): names {name: variable} and real, of the parameters that are left; conditions, pairs (f, sign); members, what
    vanishes nowhere; groups of `generic`, the last one being the coefficients of the den that was stated; num and den, None if den became 0."""

    def __init__(self, variable, names, real, num, den):
        self.variable, self.names, self.real, self.conditions, self.members, self.groups = variable, names, real, [], [], []
        self.num, self.den = self.poly(num, True), self.poly(den, True)

    def poly(self, text, z=False):
        return parse(text, self.names | {self.variable: Z} if z else self.names)

    def copy(self):
        s = copy(self)
        s.names, s.real, s.conditions, s.members = s.names.copy(), s.real.copy(), s.conditions[:], s.members[:]
        return s

    def assume(self, f, sign):
        self.conditions.append((f, sign))
        if sign in ("positive", "nonzero"):
            self.add(f)

    def rest(self, f):
        """f, not 0, divided by all members"""
        f = f.primitive()
        for g in self.members:
            f = remove(f, g) if g else f
        return f

    def add(self, f):
        """A new member; it and the old ones are divided by each other, so that divisions find products of all that was ever added."""
        f = self.rest(f) if f else f
        if f.constant() is None:
            self.members = [g for g in (remove(g, f) if g else g for g in self.members) if not g or g.constant() is None]
        if not f or f.constant() is None:
            self.members.append(f)

    def is_nonzero(self, f):
        return bool(f) and self.rest(f).constant() is not None

    def is_positive(self, f):
        c = f.constant()
        if c is not None:
            return c > 0
        return any(sign == "positive" and g and (ratio(f, g) or 0) > 0 for g, sign in self.conditions)

    def condition(self, i, *signs):
        need(0 <= i < len(self.conditions) and self.conditions[i][1] in signs, "the condition has another sign, or there is none")
        return self.conditions[i][0]

    def total(self, terms):
        """The sum of the terms times k, k > 0, and whether one is positive (5)."""
        total, k, positive = P(), 1, False
        for term in terms:
            if not isinstance(term, list) or not term:
                raise Malformed("a term is an array")
            c, factors = read("rational", term[0], "a term"), [self.factor(v) for v in term[1:]]
            need(c > 0, "a term has no positive coefficient")
            scale = lcm(k, c.denominator)
            total = total * (scale // k) + product(f for f, _ in factors) * int(c * scale)
            k, positive = scale, positive or all(sure for _, sure in factors)
        return total, k, positive

    def factor(self, v):
        """A factor >= 0, and whether it is > 0."""
        kind, what, e = read(["text"], v, "a factor") if isinstance(v, list) and len(v) == 3 else (None, "", "")
        e = read("int", e, "a factor")
        need(1 <= e < 10000, "a power out of range")
        if kind == "condition":
            f = self.condition(i := read("int", what, "a factor"), "positive", "nonnegative")
            return f**e, self.conditions[i][1] == "positive" or self.is_nonzero(f)
        f = self.poly(what)
        need(kind == "square" and f.variables() <= self.real, "not the square of something real")
        return f**(2 * e), self.is_nonzero(f)

    def solve(self, p, name, r):
        """The stratum p = 0, by p = l x + m (4, `solve`)."""
        need(name in self.names and p.degree(x := self.names[name]) == 1, f"p is not linear in {name[:60]}")
        (m, l), s, others = p.coefficients(x), self.copy(), p.variables() - {x}
        need(self.is_nonzero(l), "the coefficient may vanish")
        s.members, s.conditions, s.real = [], [], self.real - {x}

        def starred(f, n=0):
            return f.substitute(x, l, m, max(n, f.degree(x), 0))
        for f in (l, *self.members):
            s.add(starred(f))
        for f, sign in self.conditions:
            n = f.degree(x)
            if sign in ("positive", "nonnegative") and n > 0 and not l.variables() <= self.real:
                sign = "dropped"            # positive: f* is among the members already
            s.conditions.append((starred(f, n + n % 2 if sign in ("positive", "nonnegative") and n > 0 else n), sign))
        s.groups = [[starred(f) for f in group] for group in self.groups]
        if x in self.real and len(others) == 1 and not others & self.real and p.degree(u := min(others)) == 1:
            (b, a), (d, c) = (f.coefficients(u) + [P()] * (1 - f.degree(u)) for f in (l, m))
            if a * c != b * d:              # p = (a x + c') u + ...: u is a real fraction of x
                s.real.add(u)
        del s.names[name]
        s.fraction(starred, max(self.num.degree(x), self.den.degree(x)) if self.den else 0, r)
        return s

    def fraction(self, starred, n, r):
        num, den = (starred(self.num, n), starred(self.den, n)) if self.den else (None, None)
        need(bool(den) == (r is not None), "r must be given if its denominator is not 0, and only then")
        self.num, self.den = (self.poly(r["num"], True), self.poly(r["den"], True)) if r else (None, None)
        need(not r or self.den and self.num * den == num * self.den, "r is not what it becomes where p = 0")


class Tree:
    """Walks through the nodes (4); counts leaves and trusted steps."""

    def __init__(self, prove):
        self.prove, self.leaves, self.nodes, self.trust = prove, Counter(), 0, 0

    def node(self, s, v, depth):
        self.nodes += 1
        need(self.nodes <= 10000 and depth <= 64, "the tree is too large")
        name, d = choose(NODES, "node", v)
        if name in ENDS:
            return getattr(self, name)(s, d)
        return getattr(self, name)(s, d, depth)

    def zero(self, s, p, v, depth):
        name, d = choose(ZEROS, "zero", v)
        if name == "solve":
            self.node(s.solve(p, d["variable"], d["r"]), d["then"], depth + 1)
        elif name == "root":
            self.root(s, p, d)
        else:
            getattr(self, name)(s, d, p)

    def split(self, s, d, depth):
        p, t = s.poly(d["p"]), s.copy()
        need(p.constant() is None, "a split needs a polynomial that is not constant")
        t.add(p)
        self.node(t, d["nonzero"], depth + 1)
        self.zero(s, p, d["zero"], depth)

    def assumed(self, s, d, depth):
        f, p = s.condition(d["condition"], "zero"), s.poly(d["p"])
        need(f and p.constant() is None, "nothing follows from 0 = 0, or for a constant")
        left = quotient(s.rest(f), p.primitive())
        need(left is not None and remove(left, p.primitive()).constant() is not None, "p = 0 does not follow from the condition")
        self.zero(s, p, d["zero"], depth)

    def lemmas(self, s, d, depth):
        """Signs, by sums of squares and known signs (5)."""
        s = s.copy()
        for lemma in d["lemmas"]:
            p, times, sign = s.poly(lemma["p"]), s.poly(lemma["times"] or "1"), lemma["sign"]
            total, k, positive = s.total(lemma["terms"])
            need(positive and p * times * k == total, "the terms do not prove the lemma")
            need(sign == "nonzero" or sign == "positive" and s.is_positive(times), "the lemma does not have this sign")
            s.assume(p, sign) if sign == "positive" else s.add(p)
        self.node(s, d["then"], depth + 1)

    def empty(self, s, d, p=None):
        if d["terms"] is not None:          # a positive sum that is 0 wherever p is
            total, _, positive = s.total(d["terms"])
            need(positive and (not total or p is not None and quotient(total, p.primitive()) is not None), "no contradiction")
        elif p is not None:
            need(s.is_nonzero(p), "p may vanish")
        else:
            wrong = {"zero": s.is_nonzero, "positive": lambda f: not f}
            need(not all(s.members) or any(wrong.get(sign, lambda f: False)(f) for f, sign in s.conditions), "no contradiction")
        self.leaves["empty"] += 1

    def outside(self, s, d, p=None):
        i = len(s.groups) - 1 if d["generic"] is None else d["generic"]
        need(0 <= i < len(s.groups) - (d["generic"] is not None), "no such group")
        need(all(not f or p is not None and quotient(f, p.primitive()) is not None for f in s.groups[i]), "not outside")
        self.leaves["outside"] += 1

    def open(self, s, d, p=None):
        self.leaves["open"] += 1

    def trusted(self, s, d, p=None):
        need(d["abelian"] in ("yes", "no", "empty"), "yes, no or empty is expected")
        self.trust += 1
        self.leaves[d["abelian"]] += 1

    def leaf(self, s, d, _):
        need(s.den, "r is not defined here")
        if d["by"] == "number":
            need(s.num.variables() | s.den.variables() <= {Z}, "r depends on parameters")
            num, den = self.nested(d)
            need(K.d == 1 and over_field(s.num, FIELD, [Poly([1])]) * den == num * over_field(s.den, FIELD, [Poly([1])]), "the certificate is about another equation")
        elif d["by"] == "invariant":
            self.leaves["yes"] += 1
            need(d["abelian"] == "yes", "an invariant proves abelian")
            invariant(s, d)
        else:
            self.leaves["no"] += 1
            need(d["abelian"] == "no", "the places prove not abelian")
            Leaf(s, d).prove()

    def nested(self, d):
        """num and den of an ordinary certificate; the field K is set to its own."""
        trusted, num, den, abelian = self.prove(d["certificate"])
        need(d["abelian"] in ("yes", "no") and abelian is (d["abelian"] == "yes"), "the certificate claims something else")
        self.trust += trusted
        self.leaves[d["abelian"]] += 1
        return num, den

    def root(self, s, p, d):
        """All roots of p: one equation over Q[x]/(p) (4, `root`)."""
        x, n = s.names.get(d["variable"]), 0
        need(s.den and p.variables() == {x} and s.num.variables() | s.den.variables() <= {Z, x}, "another parameter occurs")
        *low, c = (f.constant() for f in p.coefficients(x))
        num, den = self.nested(d)
        need(len(low) == K.d >= 2, "the field has another degree")
        need(K.m == [v * c**(K.d - 1 - i) for i, v in enumerate(low)] + [1], "the field belongs to another polynomial")
        n = max(s.num.degree(x), s.den.degree(x))
        spend(n * n * K.d**2 * (p.bits() // 64 + 1))
        powers = [Poly([1])]                # (a/c)^k c^n = a^k c^(n - k)
        for _ in range(n):
            powers.append(powers[-1] * Poly([0, 1]))
        powers = [f * c**(n - k) for k, f in enumerate(powers)]
        top, bottom = over_field(s.num, x, powers), over_field(s.den, x, powers)
        need(bottom.c and top * den == num * bottom, "the certificate is about another equation")


def over_field(f, x, powers):
    """f with x^k replaced by powers[k], as a polynomial in z over K"""
    spend(len(powers) * (len(f) * K.d + 20) * (1 + powers[-1].bits() // 64))
    blocks = (sum((powers[k >> x & MASK] * c for k, c in row.items()), ZERO).c for row in f.coefficients(Z))
    return Poly([v for block in blocks for v in block + [0] * (K.s - len(block))])


# ---- leaves -----------------------------------------------------------------------------------------------------------

def factors(s, content, rows):
    """The q of den = content prod q^order: at every point they keep their degrees, and den is not 0 (6)."""
    qs, orders, c = [s.poly(e["q"], True) for e in rows], [e["order"] for e in rows], s.poly(content)
    need(s.is_nonzero(c), "the content may vanish")
    need(all(k >= 1 and q.degree(Z) >= 1 and s.is_nonzero(q.lead(Z)) for q, k in zip(qs, orders)), "a factor may lose degree")
    need(sum(q.degree(Z) * k for q, k in zip(qs, orders)) == s.den.degree(Z), "the degrees do not add up to deg den")
    need(product(q**k for q, k in zip(qs, orders)) * c == s.den, "the product is not den")
    return c, qs, orders


def symmetric_power(s, c, factors, m, ps):
    """T_(m+1) for v = p prod q^e, for each p; factors: (q, order, e) (6)."""
    S = product(q**((k + 1) // 2) for q, k, _ in factors)
    theta, W = P(), s.num * c * product(q for q, k, _ in factors if k % 2)
    for q, _, e in factors:
        theta += q.diff(Z) * quotient(S, q) * e
    for p in ps:
        last = P()
        for i in range(m + 1):
            last, p = p, c * (S * p.diff(Z) + (theta - S.diff(Z) * i) * p) - W * last * (i * (m - i + 1))
        yield p


def invariant(s, d):
    """A solution of Sym^m at every point (strata.md 5.3)."""
    c, qs, orders = factors(s, d["content"], d["places"])
    m, p, es = d["m"], s.poly(d["p"], True), [e["e"] for e in d["places"]]
    need(1 <= m <= 200 and all(abs(e) <= 10**7 for e in es), "m or an exponent is out of range")
    need(any(s.is_nonzero(f) for f in p.coefficients(Z)), "the solution may vanish")
    need(not any(symmetric_power(s, c, list(zip(qs, orders, es)), m, [p])), "the symmetric power does not vanish on v")


def natural(x):
    return x >= 0 and x.denominator == 1


def root_above(x, k):
    """The least j/k, j natural, with (j/k)^2 >= x."""
    n = max(0, ceil(x * k * k))
    return Fraction(isqrt(n) + (isqrt(n)**2 < n), k)


class Leaf:
    """An equation that is nowhere abelian (7).  A Place is used as in places.py: an open one counts as irrational in the degree bounds.
    Besides: chi; open; b >= Delta, or None; side, 1 at infinity and -1 elsewhere."""

    def __init__(self, s, d):
        self.s, self.by, self.absent = s, d["by"], {x["m"]: x["minors"] for x in d["absent"] or []}
        need(s.num, "r is 0")
        self.content, self.qs, self.orders = factors(s, d["content"], d["places"])
        for i, (q, k) in enumerate(zip(self.qs, self.orders)):
            need(q.degree(Z) == 1 or s.is_nonzero(resultant(q, q.diff(Z), Z)), "two roots of a place may meet")
            need(all(s.is_nonzero(resultant(q, f, Z)) for f in self.qs[:i]), "two places may meet")
            need(k == 2 or s.is_nonzero(resultant(q, s.num, Z)), "the order of a pole may drop")
        order = 4 - s.den.degree(Z) + s.num.degree(Z)
        need(order <= 0 or order == 2 or s.is_nonzero(s.num.lead(Z)), "the order at infinity may drop")
        finite = [self.place(*x) for x in zip(self.qs, self.orders, d["places"])]
        self.local = Local(finite, self.place(None, order, d["infinity"]))
        self.open = [x for x in self.local.all if x.open]
        self.torus = any(x.order >= 3 or x.irrational and not x.open for x in self.local.all)

    # -- places

    def place(self, q, order, d):
        x = Place(q, q.degree(Z) if q else 1, order)
        x.chi, x.open, x.b, x.side = None, False, None, -1 if q else 1
        if order != 2:
            need(not (d["chi"] or d["irrational"] or d["bound"] is not None or d["log"] and order != 1), "not a regular place")
            return x
        x.chi = d["chi"] and self.chi(q, [self.s.poly(f) for f in d["chi"]])
        linear = x.chi and len(x.chi) == 2
        square = ratio(x.chi[0] * -1, x.chi[1]) if linear else None
        x.delta = x.real = exact_sqrt(square) if square is not None else None
        if d["bound"] is not None:
            need(linear and self.is_bound(d["bound"], *x.chi), "the bound is not proved")
            x.b = root_above(d["bound"], 2)
        if d["irrational"]:
            need(x.delta is None and x.chi and self.is_irrational(d["irrational"], x.chi, square), "it is not proved irrational")
            negative = linear and d["irrational"] == "positive"
            x.real = Fraction(0) if negative else root_above(square, 8) if square is not None else None
        elif x.delta is None:
            x.open, x.real = True, x.b
            need(linear or self.by == "irreducible-log", "an exponent difference is not known")
        x.irrational = x.delta is None
        if d["log"] and x.delta != 0:
            need(x.n == 1 and x.delta in range(1, 41) and self.s.is_nonzero(self.defect(q, int(x.delta))), "no logarithm is seen")
        x.logs = x.n if d["log"] or x.delta == 0 else 0
        return x

    def chi(self, q, chi):
        """All Delta^2 at the place are roots of chi, of constant degree: Delta^2 = X/Y (7.2)."""
        s, n = self.s, len(chi) - 1
        need(n >= 1 and s.is_nonzero(chi[n]), "chi may lose degree")
        if q:
            Y = q.diff(Z)**2 * quotient(s.den, q**2)
            X = Y + s.num * 4
        else:
            X, Y = s.den.lead(Z) + s.num.lead(Z) * 4, s.den.lead(Z)
        total = P()
        for i, f in enumerate(reversed(chi)):       # Horner
            total = total * X + f * Y**i
        need(not (pseudo_remainder(total, q, Z) if q else total), "Delta^2 is not a root of chi")
        return chi

    def is_real(self, *fs):
        return all(f.variables() <= self.s.real for f in fs)

    def is_bound(self, B, a, b):
        """B - Delta^2 = (B b + a) b/b^2 >= 0, b real (7.5)"""
        c, signs = (b * B.numerator + a * B.denominator) * b, (b, b * -1)
        return (not c or self.s.is_positive(c)) and (self.is_real(b) or any(map(self.s.is_positive, signs)))

    def is_irrational(self, why, chi, square):
        """chi has no root that is the square of a rational number, at any point (7.2)."""
        positive = self.s.is_positive
        if why == "constant":
            return square is not None
        if why == "positive":
            return all(map(positive, chi)) or all(positive(f * -1) for f in chi)
        return why == "discriminant" and len(chi) == 3 and self.is_real(*chi) and positive(chi[2] * chi[0] * 4 - chi[1]**2)

    def defect(self, q, N):
        """A numerator of the defect at the root of q, or at infinity (7.3).  t^2 r = f/g in s = q (finite: t = s/lead); its
        coefficients are a_k/g_0^(k+1), those of the solution u_k/(g_0^(2k) prod_(i <= k) i(i-N)), and u_N is the defect."""
        if q:
            (low, lead), w = q.coefficients(Z), quotient(self.s.den, q**2)
            shift, e = low - P({1: 1}), w.degree(Z) - self.s.num.degree(Z) - 2
            f, g = (v.substitute(Z, lead, shift, v.degree(Z)).coefficients(Z) for v in (self.s.num, w))
            f, g = [v * lead**max(0, e) for v in f[:N + 1]], [v * lead**max(0, -e) for v in g[:N + 1]]
        else:
            f, g = (v.coefficients(Z)[::-1] for v in (self.s.num, self.s.den))
        f, g = (v + [P()] * (N + 1 - len(v)) for v in (f, g))
        powers, a, u = [ONE], [], [ONE]
        for k in range(N + 1):
            powers.append(powers[-1] * g[0])
            a.append(sum((g[i] * powers[i - 1] * a[k - i] * -1 for i in range(1, k + 1)), f[k] * powers[k]))
        for k in range(1, N + 1):
            total, scale = P(), 1
            for j in reversed(range(k)):
                total += a[k - j] * u[j] * powers[k - j - 1] * scale
                scale *= j * (j - N)
            u.append(total)
        return u[N]

    # -- what is excluded (7.4)

    def irreducible(self):
        return any(x.ramified for x in self.local.all) or self.local.degree_bound_1() < 0

    def sums(self, choice, places, start=()):
        """All sums of one choice at each point; None if there are more than 4000."""
        total = {Fraction(sum(start))}
        for x in places:
            for _ in range(x.n):
                values = choice(x)
                spend(20 + len(total) * len(values))
                total = {a + b for a in total for b in values}
                if len(total) > 4000:
                    return None
        return total

    @staticmethod
    def line(x):
        """1 - alpha at infinity, -alpha at a finite point, for an exponential solution"""
        if x.order <= 0:
            return {Fraction(0), Fraction(1)}
        half = Fraction(x.side, 2)
        return {half} if x.open else {half - x.delta / 2} if x.logs else {half - x.delta / 2, half + x.delta / 2}

    @staticmethod
    def product(x):
        """4 - (the order of (y1 y2)^2) at infinity, -order at a finite point (7.7)"""
        if x.order <= 0:
            return {0, 2, 4}
        if x.order >= 3:
            return {4 - x.order if x.side == 1 else -x.order}
        if x.irrational:
            return {2 * x.side}
        if x.logs:
            return {2 * x.side - 2 * x.delta}
        return {2 * x.side + i * x.delta for i in ((-2, 0, 2) if (2 * x.delta).denominator == 1 else (0,))}

    def no_line(self):
        if self.irreducible():
            return True
        lines = self.sums(self.line, self.local.all) if all(x.delta is not None for x in self.local.all) else None
        return lines is not None and not any(map(natural, lines))

    def no_invariant(self, m):
        """Of degree m, at any point: by D_m, or by a system of full rank."""
        D = self.local.degree_bound(m)
        if D < 0:
            return True
        need(m <= 200 and D < 40 and m in self.absent, f"an invariant of degree {m} is not excluded")
        data = [(q, k, x.lowest(m)) for q, k, x in zip(self.qs, self.orders, self.local.finite)]
        powers = symmetric_power(self.s, self.content, data, m, [P({j: 1}) for j in range(D + 1)])
        columns, total = [f.coefficients(Z) for f in powers], P()
        for minor in self.absent[m]:
            rows = minor["rows"]
            need(len(set(rows)) == len(rows) == D + 1 and min(rows) >= 0, "D + 1 rows are expected")
            minors = determinant([[c[i] if i < len(c) else P() for c in columns] for i in rows])
            total += minors * self.s.poly(minor["times"])
        return self.s.is_nonzero(total)

    def excluded(self, x, v):
        """Delta is nowhere v."""
        return self.s.is_nonzero(x.chi[1] * v.numerator**2 + x.chi[0] * v.denominator**2)

    # -- theorems (7.6)

    def prove(self):
        local, by = self.local, self.by
        if by == "torus-log":
            right = self.torus and local.log
        elif by == "torus":
            right = self.torus and not self.open and self.no_invariant(4)
        elif by == "irreducible-log":
            right = local.log and self.irreducible()
        elif by == "rational":
            local.need_rational()
            n = lcm(2, local.character_order())
            right = (local.log or self.no_invariant(12)) and (self.no_line() or self.no_invariant(n))
        elif by == "open":
            right = self.several_open()
        else:
            right = len(self.open) == 1 and self.no_invariant(4) and self.one_open(self.open[0])
        need(right, f"the premises of {by} are not all given")

    def several_open(self):
        need(self.open and all(x.b is not None for x in self.open), "an open place has no bound")
        right = (self.torus or self.irreducible()) and self.no_invariant(4)
        for x in self.open if right else []:
            primitive = x is self.open[0] and not self.torus and not self.local.log
            right = right and all(self.excluded(x, Fraction(a, n)) for n in ((2, 3, 4, 5) if primitive else (2,))
                                  for a in range(1, int(x.b * n) + 1))
        return right

    def one_open(self, x):
        """No value of Delta at the place x allows an abelian component (7.7, strata.md 6.1)."""
        local, others, values = self.local, [y for y in self.local.all if y is not x], set()
        need(self.torus or x.b is not None, "the open place has no bound")
        if not local.log:                       # (i)
            found = self.sums(self.product, others, [2 * x.side * x.n])
            need(found, "too many sums")
            last = 2 * x.b if x.b is not None else ceil(max(map(abs, found))) + 4
            for k in range(1, int(last) + 1):
                spend(len(found) * (2 * x.n + 1))
                if any(natural((f + j * k) / 2) for f in found for j in range(-x.n, x.n + 1)):
                    need(x.b is not None, "infinitely many values are possible")
                    values.add(Fraction(k, 2))
        if not self.torus:
            if not local.log and all(y.order != 2 or y.delta.denominator <= 5 for y in others):
                values |= {v for n in range(1, 6) for a in range(1, int(x.b * n) + 1) if self.primitive(x, v := Fraction(a, n))}
            lines = self.sums(self.line, others, [Fraction(x.side * x.n, 2)])
            need(lines and not (x.n % 2 == 0 and any(map(natural, lines))), "lines with j = 0 are not excluded")
            for f in lines:                     # (iii)
                for j in range(x.n, 0, -2):
                    low, high = max(0, ceil(f - x.b * j / 2)), int(f + x.b * j / 2 + 1)
                    spend(max(1, high - low))
                    values |= {v for k in range(low, high + 1) if (v := abs(2 * (k - f) / j)) <= x.b}
        return all(self.excluded(x, v) for v in values)

    def primitive(self, x, v):
        """(ii): a finite primitive group is possible for Delta = v."""
        spend(20 * len(self.local.all))
        x.delta, x.irrational = v, False
        possible = self.local.degree_bound(12) >= 0
        x.delta, x.irrational = None, True
        return possible


def verify(top, prove):
    """The number of trusted steps and a summary; prove checks an ordinary certificate.  Raises Malformed or Rejected."""
    top, Work.left = read(TOP, top, "certificate"), 4 * 10**7
    variable, parameters, claim = top["variable"], top["parameters"], top["claim"]["abelian"]
    names = [variable, *parameters]
    if not all(map(NAME.match, names)) or len(set(names)) < len(names) or len(parameters) > 12:
        raise Malformed("a variable and at most 12 parameters with different names are expected")
    if not set(top["real"]) <= set(parameters) or claim not in (True, False, None):
        raise Malformed("real parameters are parameters; the claim is true, false or null")
    try:
        shifts = {x: FIELD * (i + 1) for i, x in enumerate(parameters)}
        s, tree = Stratum(variable, shifts, {shifts[x] for x in top["real"]}, **top["r"]), Tree(prove)
        need(s.den, "the denominator is 0")
        for x in top["assumptions"]:
            need(x["sign"] in ("positive", "nonnegative", "nonzero", "zero"), "an unknown sign")
            s.assume(s.poly(x["p"]), x["sign"])
        s.groups = [[s.poly(f) for f in group] for group in top["generic"]] + [s.den.coefficients(Z)]
        tree.node(s, top["tree"], 1)
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as why:
        raise Rejected(f"{type(why).__name__}: {why}") from None
    others = {"yes", "no", "open"} & set(tree.leaves) - {"yes" if claim else "no"}
    need(claim is None or not others, "the claim does not follow")
    words = {"no": "not abelian", "yes": "abelian", "open": "undecided", "empty": "empty", "outside": "outside"}
    counts = ", ".join(f"{tree.leaves[k]} {word}" for k, word in words.items() if tree.leaves[k])
    return tree.trust, f"{sum(tree.leaves.values())} strata: {counts}; "
