"""What is known at a node of a certificate over strata (docs/theory/strata_certificates.md 3 to 5): a set of conditions, in
the words of this format, and the equation there."""
from certificate_format import need, read, right
from condition import ConditionSet, texts, vanishes
from multivariate import ONE, parse
from strata_invariant import Z


class Stratum(ConditionSet):
    """The state at a node (3).  num and den: of r, None if den became 0: where den vanishes identically in z that of the
    certificate does."""

    def __init__(self, variable, names, real, rational, num, den):
        super().__init__(names, real, rational)
        self.variable = variable
        self.num, self.den = self.poly(num, True), self.poly(den, True)

    def poly(self, text, z=False):
        return parse(text, self.names | {self.variable: Z} if z else self.names)

    def sum_of(self, rows, positive=False):
        """The sum of the terms [c, FACTOR, ...] times k, and k (5)"""
        return self.total([self.product_of(row) for row in rows], positive)

    def product_of(self, row):
        """FACTOR: ["condition", i, e] or ["square", Q, e]"""
        right(isinstance(row, list) and row, "a term is an array")
        c, q, conditions = read("rational", row[0], "a term"), ONE, []
        for kind, what, e in (texts(3, v, "a kind, an index or a polynomial, and an exponent") for v in row[1:]):
            e = read("int", e, "a factor")
            need(1 <= e < 10000 and kind in ("condition", "square"), "a power out of range")
            if kind == "condition":
                conditions.append((read("int", what, "a factor"), e))
            else:
                q *= self.poly(what)**e
        return c, q, conditions

    def lemma(self, d):
        """The stratum, where p has a sign, by sums of squares and known signs, or is not 0, also by a membership or a prime (5)"""
        p, sign, given = self.poly(d["p"]), d["sign"], {k for k in d if k not in ("p", "sign") and d[k] is not None}
        times = self.poly(d["times"]) if "times" in given else ONE
        need(sign in ("nonzero", "positive"), "a lemma shows positive or nonzero")
        if given == {"membership", "value"}:
            need(sign == "nonzero" and p.constant() is None, "a membership shows that p is not 0")
            self.need_violated(d["membership"], d["value"], p)
        elif given == {"prime"}:
            need(sign == "nonzero", "a prime shows that p is not 0")
            self.need_no_rational_root(p, d["prime"])
        elif given == {"times"}:
            need(sign == "nonzero" and self.is_unit(p * times), "p times its factor is not known")
        else:
            need(given in ({"terms"}, {"terms", "times"}), "nothing shows the lemma, or too much")
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
