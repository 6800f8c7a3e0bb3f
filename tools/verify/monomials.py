"""Terms of polynomials by the exponents of some of their variables"""
from multivariate import MASK, P


def weight(k, weights):
    """Of the monomial k; weights {variable: weight}"""
    return sum(w * (k >> x & MASK) for x, w in weights.items())


def parts(f, variables):
    """f as a sum of monomials in these variables: {monomial: its coefficient}"""
    found = {}
    for k, c in f.items():
        m = sum((k >> x & MASK) << x for x in variables)
        found.setdefault(m, P())[k - m] = c
    return found
