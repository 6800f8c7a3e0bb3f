"""What is known at a node of a certificate over strata (docs/theory/strata_certificates.md 3 to 5)."""
from copy import copy
from math import lcm

from certificate_format import Malformed, need, read
from modular import is_prime, meval
from multivariate import ONE, P, parse, product, quotient, ratio, remove, spend
from strata_invariant import Z


class Stratum:
    """The state at a node (3).  names {name: variable}, real and rational: of the parameters that are left; conditions:
    pairs (f, sign); memberships: (num, den, integral); members: what vanishes nowhere; groups: `generic`; num and den:
    None if den became 0.  Where den vanishes identically in z that of the certificate does: fraction."""

    def __init__(self, variable, names, real, rational, num, den):
        self.variable, self.names, self.real, self.rational = variable, names, real | rational, rational
        self.conditions, self.memberships, self.members, self.groups = [], [], [], []
        self.num, self.den = self.poly(num, True), self.poly(den, True)

    def poly(self, text, z=False):
        return parse(text, self.names | {self.variable: Z} if z else self.names)

    def copy(self):
        s = copy(self)
        s.names, s.conditions, s.members = s.names.copy(), s.conditions[:], s.members[:]
        return s

    def assume(self, f, sign):
        self.conditions.append((f, sign))
        if sign in ("positive", "nonzero"):
            self.add(f)

    def assume_membership(self, num, den, integral):
        self.memberships.append((num, den, integral))
        self.add(den)

    def rest(self, f):
        """f, not 0, divided by all members"""
        f = f.primitive()
        for g in self.members:
            f = remove(f, g) if g else f
        return f

    def add(self, f):
        """A new member; it and the old ones are divided by each other: so rest finds products of all that was added."""
        f = self.rest(f) if f else f
        old = self.members if f.constant() is not None else [remove(g, f) if g else g for g in self.members]
        self.members = [g for g in (*old, f) if not g or g.constant() is None]

    def is_nonzero(self, f):
        return bool(f) and self.rest(f).constant() is not None

    def is_positive(self, f):
        c = f.constant()
        if c is not None:
            return c > 0
        return any(sign == "positive" and g and (ratio(f, g) or 0) > 0 for g, sign in self.conditions)

    def condition(self, i, *signs):
        need(0 <= i < len(self.conditions), "no such condition")
        need(self.conditions[i][1] in signs, "the condition has another sign")
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

    def violates(self, i, c, p):
        """Where p = 0, membership i would have the value c, which it has not (5)."""
        need(0 <= i < len(self.memberships), "no such membership")
        num, den, integral = self.memberships[i]
        need((c.denominator == 1) != integral, "the membership allows this value")
        need(vanishes(num * c.denominator - den * c.numerator, p), "the membership has another value there")

    def no_rational_root(self, p, q):
        """p has no root modulo q, where the denominator of a rational one has an inverse (5)."""
        xs = p.variables()
        need(len(xs) == 1 and xs <= self.rational, "not a polynomial in one rational parameter")
        need(2 <= q < 10000 and is_prime(q), "not a prime below 10000")
        row = [c.constant() % q for c in p.coefficients(min(xs))]
        spend(q * len(row))
        need(row[-1] and all(meval(row, x, q) for x in range(q)), "a root modulo the prime")

    def lemma(self, d):
        """A sign, by sums of squares and known signs; that p is not 0 also by a membership or a prime (5)."""
        p, sign, given = self.poly(d["p"]), d["sign"], {k for k in d if k not in ("p", "sign") and d[k] is not None}
        times = self.poly(d["times"]) if "times" in given else ONE
        need(sign in ("nonzero", "positive"), "a lemma shows positive or nonzero")
        if given == {"membership", "value"}:
            need(sign == "nonzero" and p.constant() is None, "a membership shows that p is not 0")
            self.violates(d["membership"], d["value"], p)
        elif given == {"prime"}:
            need(sign == "nonzero", "a prime shows that p is not 0")
            self.no_rational_root(p, d["prime"])
        elif given == {"times"}:
            need(sign == "nonzero" and self.is_nonzero(p * times), "p times its factor is not known")
        else:
            need(given in ({"terms"}, {"terms", "times"}), "nothing shows the lemma, or too much")
            total, k, positive = self.total(d["terms"])
            need(positive and p * times * k == total, "the terms do not prove the lemma")
            need(sign == "nonzero" or self.is_positive(times), "the lemma does not have this sign")
        self.assume(p, sign) if sign == "positive" else self.add(p)

    def solve(self, p, name, r):
        """The stratum p = 0, by p = l x + m (4, `solve`)."""
        need(name in self.names and p.degree(x := self.names[name]) == 1, f"p is not linear in {name[:60]}")
        (m, l), s, others = p.coefficients(x), self.copy(), p.variables() - {x}
        need(self.is_nonzero(l), "the coefficient may vanish")
        s.members, s.conditions, s.memberships = [], [], []

        def starred(f, n=0):
            return f.substitute(x, l, m, max(n, f.degree(x), 0))
        for f in (*self.members, l):
            s.add(starred(f))
        for f, sign in self.conditions:
            n = f.degree(x)
            if sign in ("positive", "nonnegative") and n > 0 and not l.variables() <= self.real:
                sign = "dropped"            # positive: f* is among the members already
            s.conditions.append((starred(f, n + n % 2 if sign in ("positive", "nonnegative") and n > 0 else n), sign))
        for num, den, integral in self.memberships:
            n = max(num.degree(x), den.degree(x))
            s.memberships.append((starred(num, n), starred(den, n), integral))
        s.groups = [[starred(f) for f in group] for group in self.groups]
        learned = set()
        if len(others) == 1 and p.degree(u := min(others)) == 1:
            (c, a), (d, b) = (f.coefficients(u) + [P()] * (1 - f.degree(u)) for f in (l, m))
            if a * d != b * c:              # p = (a x + b) u + c x + d, of rank 2: u is a real fraction of x
                learned.add(u)
        s.real, s.rational = ((f | learned if x in f else f) - {x} for f in (self.real, self.rational))
        del s.names[name]
        s.fraction(starred, max(self.num.degree(x), self.den.degree(x)) if self.den else 0, r)
        return s

    def fraction(self, starred, n, r):
        num, den = (starred(self.num, n), starred(self.den, n)) if self.den else (None, None)
        need(bool(den) == (r is not None), "r must be given if its denominator is not 0, and only then")
        self.num, self.den = (self.poly(r["num"], True), self.poly(r["den"], True)) if r else (None, None)
        need(not r or self.den and self.num * den == num * self.den, "r is not what it becomes where p = 0")
        need(not r or vanishes(den, self.den), "the denominator vanishes where it did not")


def vanishes(f, p):
    """Is f = 0 wherever p = 0?  Without p: everywhere?"""
    return not f or p is not None and quotient(f, p.primitive()) is not None
