"""What is known at a node of a certificate over strata (docs/theory/strata_certificates.md 3 to 5): a set of conditions, in
the words of this format, and the equation there; and what its leaves need (6): den as a product, and symmetric powers."""
from certificate_format import need, read, right
from condition import ConditionSet, vanishes
from multivariate import ONE, P, parse, product, pseudo_remainder, quotient

Z = 0                                       # the variable z


class Stratum(ConditionSet):
    """The state at a node (3).  num and den: of r, None if den became 0: where den vanishes identically in z that of the
    certificate does."""

    def __init__(self, variable, names, real, rational, num, den):
        super().__init__(names, real, rational)
        self.variable, self.all = variable, names
        self.num, self.den = self.poly(num, True), self.poly(den, True)

    def poly(self, text, z=False):
        f = parse(text, self.all | {self.variable: Z})
        need(f.variables() <= {*self.names.values(), *[Z][:z]}, "a polynomial in the parameters is expected, without those that are solved for")
        return f

    def sum_of(self, rows, positive=False):
        """The sum of the terms [c, FACTOR, ...] times k, and k (5)"""
        return self.total([self.product_of(row) for row in rows], positive)

    def product_of(self, row):
        """FACTOR: ["condition", i, e] or ["square", Q, e]"""
        right(isinstance(row, list) and row, "a term is an array")
        c, q, conditions = read("rational", row[0], "a term"), ONE, []
        right(c > 0, "a positive number is expected")
        for kind, what, e in read([[("condition", "square"), "text", "int"]], row[1:], "a term"):
            right(1 <= e < 10000, "a power out of range")
            if kind == "condition":
                conditions.append((read("natural", what, "a factor"), e))
            else:
                q *= self.poly(what)**e
        return c, q, conditions

    def lemma(self, d):
        """The stratum, where p has a sign, by sums of squares and known signs, or is not 0, also by a membership or a prime (5)"""
        p, sign, given = self.poly(d["p"]), d["sign"], {k for k in d if k not in ("p", "sign") and d[k] is not None}
        times = self.poly(d["times"]) if "times" in given else ONE
        right(given in ({"membership", "value"}, {"prime"}, {"times"}, {"terms"}, {"terms", "times"}), "one proof of the lemma is expected")
        right(sign == "nonzero" or "terms" in given, "terms show a sign")
        if "membership" in given:
            need(p.constant() is None, "a membership shows that p is not 0")
            self.need_violated(d["membership"], d["value"], p)
        elif "prime" in given:
            self.need_no_rational_root(p, d["prime"])
        elif given == {"times"}:
            need(self.is_unit(p * times), "p times its factor is not known")
        else:
            total, k = self.sum_of(d["terms"], sign == "positive")
            need(p * times * k == total, "the terms do not prove the lemma")
            need(sign == "nonzero" or self.is_positive(times), "the lemma does not have this sign")
        return self.also((p, sign)) if sign == "positive" else self.also(units=[p])

    def solve(self, p, name, r):
        """The stratum p = 0, by p = l x + m (4, `solve`)."""
        s, put = super().solve(p, name)
        num, den, x = self.num, self.den, self.names[name]
        if den:
            num, den = (put(f, max(num.degree(x), den.degree(x))) for f in (num, den))
        need(bool(den) == (r is not None), "r must be given if its denominator is not 0, and only then")
        s.num, s.den = (s.poly(r["num"], True), s.poly(r["den"], True)) if r else (None, None)
        need(not r or s.den and s.num * den == num * s.den, "r is not what it becomes where p = 0")
        need(not r or vanishes(den, s.den), "the denominator vanishes where it did not")
        return s


def factors(s, content, rows):
    """The q of den = content prod q^order: at every point they keep their degrees, and den is not 0 (6)."""
    qs, orders, c = [s.poly(e["q"], True) for e in rows], [e["order"] for e in rows], s.poly(content)
    need(s.is_unit(c), "the content may vanish")
    need(all(q.degree(Z) >= 1 and s.is_unit(q.lead(Z)) for q in qs), "a factor may lose degree")
    need(all(k >= 1 for k in orders), "an order is not positive")
    need(product(q**k for q, k in zip(qs, orders)) * c == s.den, "the product is not den")
    return c, qs, orders


def squared_difference(num, den, q=None):
    """X and Y: Delta^2 = X/Y at the roots of q, q^2 divides den, or at infinity, for a pole of order 2 at most (7.2)"""
    if q is None:
        X, Y = sum(num.coefficients(Z)[den.degree(Z) - 2:], P()), den.lead(Z)
    else:
        X, Y = num, q.diff(Z)**2 * quotient(den, q**2)
    return X * 4 + Y, Y


def has_differences(num, den, q, chi):
    """Are all Delta^2 there roots of the polynomial chi?"""
    (X, Y), total = squared_difference(num, den, q), P()
    for i, f in enumerate(reversed(chi)):       # Horner
        total = total * X + f * Y**i
    return not (pseudo_remainder(total, q, Z) if q else total)


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
    need(1 <= m <= 200, "m is out of range")
    need(all(abs(e) <= 10**7 for e in es), "an exponent is too large")
    need(any(s.is_unit(f) for f in p.coefficients(Z)), "the solution may vanish")
    need(not any(symmetric_power(s, c, list(zip(qs, orders, es)), m, [p])), "the symmetric power does not vanish on v")
