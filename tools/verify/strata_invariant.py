"""What every leaf of a certificate over strata needs (docs/theory/strata_certificates.md 6): den as a product, and the
recurrence of a symmetric power; the leaf `invariant` is a solution of one.  s is the state there, a Stratum."""
from certificate_format import need
from multivariate import P, product, quotient

Z = 0                                       # the variable z


def factors(s, content, rows):
    """The q of den = content prod q^order: at every point they keep their degrees, and den is not 0 (6)."""
    qs, orders, c = [s.poly(e["q"], True) for e in rows], [e["order"] for e in rows], s.poly(content)
    need(s.is_unit(c), "the content may vanish")
    need(all(q.degree(Z) >= 1 and s.is_unit(q.lead(Z)) for q in qs), "a factor may lose degree")
    need(all(k >= 1 for k in orders), "an order is not positive")
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
    need(1 <= m <= 200, "m is out of range")
    need(all(abs(e) <= 10**7 for e in es), "an exponent is too large")
    need(any(s.is_unit(f) for f in p.coefficients(Z)), "the solution may vanish")
    need(not any(symmetric_power(s, c, list(zip(qs, orders, es)), m, [p])), "the symmetric power does not vanish on v")
