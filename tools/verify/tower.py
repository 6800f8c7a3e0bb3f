"""Polynomials in names, to which roots and inverses are adjoined, over numbers (docs/theory/theorem_certificates.md 3)."""
from math import gcd

from certificate_format import NAME, need, right
from multivariate import FIELD, NAMES, ONE, P, product_of_numbers
from system_format import fraction


class Function:
    """A polynomial p, divided by the natural number n."""

    def __init__(self, p, n=1):
        self.p, self.n = p, n               # not reduced: shown as it was given

    @staticmethod
    def read(v, names):
        return Function(*fraction(v, names)[:2])

    def __bool__(self):
        return bool(self.p)

    def __add__(self, o):
        if not self or not o:
            return self or o
        n = product_of_numbers(self.n, o.n) // gcd(self.n, o.n)
        return Function(self.p * (n // self.n) + o.p * (n // o.n), n)

    def __sub__(self, o):
        return self + Function(o.p * -1, o.n)

    def __mul__(self, o):
        return Function(self.p * o.p, product_of_numbers(self.n, o.n))


NOTHING = Function(P())


def total(terms):
    return sum(terms, NOTHING)


def compose(f, images):
    """f with a Function for each of its variables"""
    need(f.p.variables() <= set(images), "a name has no value")
    g = f.p.at({x: {1: images[x]} for x in f.p.variables()}, Function)
    return Function(g.p, product_of_numbers(g.n, f.n))


def variable(v):
    return Function(P({1 << v: 1}))


class Tower:
    """names: {name: variable}; steps: (variable, None, h) of u = 1/h and (variable, square, None) of a root."""

    def __init__(self, names):
        self.names, self.steps, self.roots = dict(names), [], False

    def read(self, v):
        return Function.read(v, self.names)

    def adjoin(self, name, square=None, h=None):
        right(NAME.match(name) and name not in self.names and len(self.names) < NAMES, "another name is expected")
        taken = max(self.names.values(), default=-FIELD)
        self.names[name] = taken + FIELD
        self.steps.append((self.names[name], square, h))
        self.roots = self.roots or square is not None

    def invert(self, x, h):
        """1/h, where the variable x stands for 1/p, h = c p/n, p with integer coefficients without a common factor"""
        need(h, "a denominator is 0")
        p = h.p.primitive()
        self.steps.append((x, None, p))
        return Function(P({1 << x: h.n}), h.p[max(p)] // p[max(p)])

    def above(self):
        """A variable that stands for nothing yet"""
        return max([*self.names.values(), *(x for x, *_ in self.steps)]) + FIELD

    def cleared(self, p):
        """p times all that its inverses need, if there are no roots"""
        for x, _, h in reversed(self.steps):
            n = p.degree(x)
            p = p.substitute(x, h, ONE * -1, n) if n > 0 else p
        return p

    def need_zero(self, f, why):
        need(self.is_zero(f.p, len(self.steps)), why)

    def is_zero(self, p, k):
        while p and k:
            k -= 1
            x, square, h = self.steps[k]
            n = p.degree(x)
            if n <= 0:
                continue
            if square is None:
                p = p.substitute(x, h, ONE * -1, n)
            else:
                rows = p.coefficients(x)
                return all(self.is_zero(self.even(half, square), k) for half in (rows[::2], rows[1::2]))
        return not p

    @staticmethod
    def even(rows, square):
        """sum rows[j] r^(2 j), times a number"""
        value, lift = P(), 1
        for row in reversed(rows):
            value, lift = value * square.p + row * lift, product_of_numbers(lift, square.n)
        return value
