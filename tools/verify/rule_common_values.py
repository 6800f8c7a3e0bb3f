"""Two exponent differences that are special together at finitely many values only (docs/theory/theorem_certificates.md 17)."""
from fractions import Fraction
from itertools import product
from math import lcm

from certificate_format import COND, need, read
from core import Said
from exact import exact_sqrt
from map import Map, carried
from multivariate import ONE, P, parse, spend

# the denominators of the rows of Schwarz and Kimura
ROWS = {(2, 3, 3), (3, 3, 3), (2, 3, 4), (3, 4, 4), (2, 3, 5), (3, 3, 5), (3, 5, 5), (2, 5, 5), (5, 5, 5)}
POINTS, DEGREE, BITS, DENOMINATOR_BITS, GAP_DIGITS = 20000, 20, 1000, 400, 40
PUT = [["text", "any"]]
FIELDS = {"system": "text", "of": ["text", "text"], "leaves": ["int", "int"], "at": PUT, "region": [COND],
          "shown": [["any"], ["any"]], "function": {"num": "text", "den": "text"}, "bound": "int", "gap": "text", "by?": "any", "levels?": [PUT, PUT]}


def may_be_abelian(*three):
    """Riemann's equation with these rational differences"""
    first, *rest = three
    odd = any((first + sum(s * x for s, x in zip(signs, rest))) % 2 == 1 for signs in product((1, -1), repeat=2))
    return odd or sum(x.denominator == 2 for x in three) > 1 or tuple(sorted(x.denominator for x in three)) in ROWS


class Difference:
    """Delta with the square num/den: `times` of the three differences of Riemann's equation, beside the numbers `known`.  If the
    identity component is abelian then Delta is in (1/N)Z, and special."""

    def __init__(self, known, times, num, den):
        self.known, self.times, self.num, self.den = known, times, num, den
        need(sum(x.denominator == 2 for x in known) < 2, "abelian for each value of the difference")
        need(times != 2 or known[0] % 2 != 1, "reducible for each value of the difference")
        self.N = lcm(60, *(2 * x.denominator for x in known))
        need(self.N.bit_length() <= DENOMINATOR_BITS, "a limit: the denominators")

    def special(self, x):
        return may_be_abelian(*self.known, *[x] * self.times)


class CommonValues:
    """Delta2^2 = F(Delta1^2), F = A/B in the variable 0, where the conditions `given` hold; d: a step"""

    def __init__(self, first, second, d, given):
        self.first, self.second = first, second
        gap = None if d["gap"] == "negative" else read("int", d["gap"], "gap")
        need(gap is None or gap >= 0, "the gap is below 0")
        need(gap is None or gap < 10**GAP_DIGITS, "a limit: the gap")
        self.A, self.B = A, B = [parse(d["function"][key], {"x": 0}) for key in ("num", "den")]
        need(B, "the function has no denominator")
        n = max(A.degree(0), B.degree(0))
        need(n <= DEGREE and max(A.bits(), B.bits()) <= BITS, "a limit: the function")
        top, bottom = (f.substitute(0, first.den, first.num * -1, n) for f in (A, B))
        other = second.num * bottom - second.den * top
        if d["by"] is not None:
            given.show(other, "zero", d["by"])
        need(d["by"] is not None or not other, "another function of the difference")
        need(0 <= d["bound"] <= POINTS, "a limit: the number of values")
        self.need_bound(Fraction(d["bound"], first.N)**2, gap)
        spend(d["bound"] * 10 * (n + 1))
        self.values = [x for x in (Fraction(j, first.N) for j in range(d["bound"])) if first.special(x) and self.meets(x * x)]

    def need_bound(self, start, gap):
        """From `start` on N^2 F is negative, or between two squares of integers that follow one another."""
        A, B = (f * (1 if at(self.B, start) > 0 else -1) for f in (self.A, self.B))
        square = A * self.second.N**2
        above = [A * -1] if gap is None else [square - B * gap**2, B * (gap + 1)**2 - square]
        need(all(positive_from(f, start) for f in [B, *above]), "the bound is not shown")

    def meets(self, x):
        """May Delta2 be special where Delta1^2 = x?"""
        below = at(self.B, x)
        root = exact_sqrt(at(self.A, x) / below) if below else None
        return not below or root is not None and self.second.special(root)

    def conditions(self):
        """Delta1^2 is none of the values."""
        each = [self.first.num * x.denominator**2 - self.first.den * x.numerator**2 for x in self.values]
        each = [f.primitive() for f in each if f.constant() is None or not f]
        return [(f, "nonzero") for i, f in enumerate(each) if f not in each[:i]]


def at(f, x):
    return sum(c * x**k for k, c in f.items())


def positive_from(f, start):
    """Has f(start + t) no negative coefficient, and f(start) > 0?"""
    at_start = P.of({0: -start.numerator, 1: -start.denominator})
    f = f.substitute(0, ONE * start.denominator, at_start, max(f.degree(0), 0))
    return f.get(0, 0) > 0 and min(f.values()) > 0


def said(theorem, d):
    levels = [[], []] if d["levels"] is None else d["levels"]
    differences, classes, way = [], [], []
    for name, leaf, rows, put in zip(d["of"], d["leaves"], d["shown"], levels):
        here, of = theorem.here(d), theorem.proved(name, "N", "L")
        need(0 <= leaf < len(of.criteria), "no such leaf")
        target, difference, excluded = of.criteria[leaf]
        need(difference is not None, "not one exponent difference")
        map = Map(here, target, {"shown": rows, "levels": theorem.put(put, here.free)})
        classes.append(carried(excluded(), map))
        way += [*of.way, *map.shown()]
        need(not theorem.functions_there(of, here), "functions have values there, which may be others along the other curve")
        known, times, square = difference
        differences.append(Difference(known, times, *(in_parameters(text, target, here) for text in square)))
    found = CommonValues(*differences, d, here.given)
    return Said("N", here.family, [here.conditions() + found.conditions()], list(dict.fromkeys(classes)), (), (), (), way,
                shows_way=True)


def in_parameters(text, target, here):
    """The same polynomial in the parameters of X that are left, if they are those of Y"""
    of_y = parse(text, {x: target.space.at[x] for x in target.space.at})
    need(of_y.variables() <= {target.space.at[x] for x in target.parameters if x in here.free}, "the difference depends on a level")
    return parse(text, here.free)
