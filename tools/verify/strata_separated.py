"""Three places, two of them with exponent differences d1, d2 that are not rational (docs/theory/strata_certificates.md 7.9):
abelian only if the third is a natural number n with +-d1 +- d2 among n - 1, n - 3, ..., 1 - n."""
from itertools import count

from certificate_format import need
from exact import exact_sqrt
from multivariate import P, quotient, ratio, spend
from strata_invariant import Z

MOST = 1000                                 # values of n


def remainder(f, q, n):
    """lead(q)^(n-1) f modulo q of degree 2, n >= deg f: the coefficients of 1 and z"""
    c, rest = q.coefficients(Z), f.coefficients(Z)
    rest += [P()] * (n + 1 - len(rest))
    while len(rest) > 2:
        top = rest.pop()
        rest = [v * c[2] for v in rest]
        for i in (0, 1):
            rest[len(rest) - 2 + i] -= top * c[i]
    return rest


def values_at_roots(s, q):
    """a polynomial of degree 2 whose roots are Delta^2 at the two roots of q: the norm of Y T - X, up to a factor"""
    Y = q.diff(Z)**2 * quotient(s.den, q**2)
    X = Y + s.num * 4
    n, c = max(X.degree(Z), Y.degree(Z), 1), q.coefficients(Z)
    x, y = remainder(X, q, n), remainder(Y, q, n)

    def trace(u, v):                        # of u v', times c[2]
        return (c[2] * u[0] * v[0] + c[0] * u[1] * v[1]) * 2 - c[1] * (u[0] * v[1] + u[1] * v[0])
    return trace(x, x), trace(x, y) * -2, trace(y, y)


def pair(s, places):
    """c with the roots d1^2, d2^2"""
    need(len(places) == 1 or all(len(x.chi) == 2 for x in places), "chi is not linear")
    if len(places[0].chi) == 2:
        (a, b), (c, d) = places[0].chi, places[-1].chi
        return a * c, a * d + b * c, b * d
    c, v = places[0].chi, values_at_roots(s, places[0].q)
    need(len(c) == 3 and all(c[i] * v[2] == c[2] * v[i] for i in (0, 1)), "chi has not the values at both roots")
    return tuple(c)


def grows(s, c, e, growth):
    """2 (d1^2 + d2^2) >= factor Delta^2 - shift, and d1^2, d2^2 are conjugate complex numbers"""
    factor, shift = growth
    real = all(map(s.is_real, c)) and s.is_positive(c[2] * c[0] * 4 - c[1]**2)
    need(real and factor >= 1, "the squares are not known to be conjugate, or the factor is less than 1")
    d = factor.denominator * shift.denominator
    room = c[2] * e[0] * int(factor * d) - c[1] * e[1] * (2 * d) + c[2] * e[1] * int(shift * d)
    return not room or s.is_real(e[1]) and s.is_positive(room * c[2] * e[1])


def natural_root(x):
    k = exact_sqrt(x) if x >= 0 else None
    return k if k is not None and k.denominator == 1 else None


def possible_sums(s, places, c, at_sum):
    """The k >= 0 with k = +-d1 +- d2 somewhere, if they are few; else None"""
    p, q = ratio(c[1] * -1, c[2]), ratio(c[0], c[2])
    if p is not None and q is not None:
        r = exact_sqrt(q) if q >= 0 else None
        return {natural_root(p + 2 * r), natural_root(p - 2 * r)} - {None} if r is not None else set()
    if all(len(x.chi) == 2 and x.real == 0 for x in places):    # both imaginary
        return set() if s.is_unit(at_sum(0)) else {0}
    return None


def separated(s, places, growth):
    used = [x for x in places if x.order > 0]
    need(all(x.order == 2 for x in used), "a place is not regular")
    others = [x for x in used if x.open or x.delta is not None]
    irrational = [x for x in used if x not in others]
    need(len(others) == 1 == others[0].n and sum(x.n for x in irrational) == 2, "not three places, two irrational")
    third = others[0]
    c = pair(s, irrational)
    need(third.chi is not None and len(third.chi) == 2, "chi of the third place is not linear")
    need(not growth or grows(s, c, third.chi, growth), "the growth is not proved")

    def at_sum(k):
        return (c[2] * k**2 + c[1])**2 - c[2] * c[0] * 4
    sums = possible_sums(s, irrational, c, at_sum)
    if sums == set():
        return True

    def excluded(n):
        if third.delta is None and s.is_unit(third.chi[1] * n**2 + third.chi[0]):
            return True
        ks = [k for k in range(n - 1, -1, -2) if (sums is None or k in sums)
              and (not growth or k > 0 and growth[0] * n**2 - growth[1] < k**2)]
        return all(s.is_unit(at_sum(k)) for k in ks)
    if third.delta is not None:
        if third.delta.denominator > 1 or third.delta == 0:
            return True
        need(third.delta <= MOST, "the exponent difference is too large")
        return excluded(int(third.delta))
    need(growth or third.b is not None, "the third exponent difference has no bound")
    for n in count(1):
        spend(20)
        if growth and growth[0] * n**2 - growth[1] >= (n - 1)**2 or not growth and n > third.b:
            return True
        need(n <= MOST, "too many values of the exponent difference")
        if not excluded(n):
            return False
