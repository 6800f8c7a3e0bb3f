"""Homogeneous potentials, or such parts of them, at their Darboux points (docs/theory/theorem_certificates.md 16)."""
from fractions import Fraction
from itertools import combinations_with_replacement

from certificate_format import COND, need, read, right
from core import Said
from exact import exact_sqrt
from family import brackets
from first_integrals import IntegralClass
from multivariate import FIELD, MASK, ONE, P, parse, spend, sylvester
from phase_space import Function
from tower import compose, variable

DEGREE, CHART, POWER, POINTS, CHOICES, TABLE = 20, 1000, 12, 8, 200000, 200000
EXTRA = {3: ((1, 3), (1, 4), (1, 5), (2, 5)), 4: ((1, 3),), 5: ((1, 3), (2, 5))}
ORDER = {"order": "int", "scale": "text", "rest": "text", "lines?": {"factors": ["text", "text"], "over": "text", "order": "int"}}
IMPROPER = {"scale": "text", "cofactor": "text", "power": "int"}
SHOWN = {"value": "text", "by": "any"}
CHOICE = {"values": ["rational"], "equations": ["text"], "by": "any"}
FIELDS = {"system": "text", "at": [["text", "any"]], "region": [COND], "coordinates": ["text"] * 2, "momenta": ["text"] * 2,
          "part": ("all", "highest", "lowest"), "degree": "int", "chart": ["int"] * 2, "says": ("relation", "multiple"), "unit": "text",
          "proper": "text", "rest": "text", "improper?": "any", "isotropic": "any", "zeros": ["any"], "shown": ["any"], "choices": ["any"]}


class Table:
    """Lambda = lambda - 1 = (k/2) (nu^2 - (1/2 + 1/k)^2), nu or -nu in a class modulo 1 (Morales-Ruiz and Ramis)"""

    def __init__(self, k):
        self.k, self.top, self.looked = k, Fraction(1, 2) + Fraction(1, k), 0
        classes = [Fraction(1, 2), self.top, *(Fraction(*c) for c in EXTRA.get(k, ()))]
        self.classes = {nu for c in classes for nu in (c, 1 - c)}
        self.negative = self.up_to(0)

    def up_to(self, most):
        """All Lambda != 0 that are not larger"""
        found = set()
        for nu in self.classes:
            while (value := Fraction(self.k, 2) * (nu * nu - self.top**2)) <= most:
                self.looked += 1
                need(self.looked < TABLE, "a limit: too many eigenvalues")
                spend(20)
                found |= {value} - {0}
                nu += 1
        return sorted(found)

    def contains(self, value):
        nu = exact_sqrt(Fraction(2, self.k) * value + self.top**2)
        return nu is not None and nu % 1 in self.classes

    def sets(self, n, total):
        """Multisets of n values with this sum of 1/Lambda, ascending"""
        found, self.steps = set(), 0
        for m in range(n + 1):
            for low in combinations_with_replacement(self.negative, m):
                rest = total - sum(1 / v for v in low)
                found |= {low + high for high in self.positive(n - m, rest, Fraction(0))}
        return sorted(found)

    def positive(self, n, rest, least):
        self.steps += 1
        need(self.steps <= CHOICES, "a limit: too many eigenvalues")
        spend(20)
        if n == 0:
            if rest == 0:
                yield ()
        elif rest <= 0:
            return
        elif n == 1:
            if self.contains(1 / rest):                 # it is not smaller than the one before (by the bound below)
                yield (1 / rest,)
        else:
            for value in self.up_to(n / rest):          # the smallest of n is at most n/rest
                if value >= least:
                    yield from ((value, *more) for more in self.positive(n - 1, rest - 1 / value, value))


class Darboux:
    def __init__(self, here, d):
        self.here, self.d, self.family, self.space = here, d, here.family, here.space
        self.chart()
        self.forms()
        self.zeros, self.shown = iter(d["zeros"]), iter(d["shown"])
        relation = d["says"] == "relation"
        self.proper_points()
        self.show(self.resultant(self.proper, self.proper.diff(self.w)), "nonzero" if relation else "zero")
        order = read(ORDER, d["isotropic"], "isotropic")
        scale, rest = self.form(order["scale"]), self.form(order["rest"])
        if relation:
            self.choices(self.isotropic(order["order"], order["lines"], scale, rest))
        else:
            right(not d["choices"], "nothing is chosen")
            right(order["lines"] is None, "nothing is asked of the isotropic directions")
        right(not [*self.shown, *self.zeros], "more is shown than is needed")

    def chart(self):
        d, space = self.d, self.space
        need(space.hamiltonian is not None and not space.functions and not space.inverses and not space.relations,
             "a polynomial Hamiltonian of two degrees of freedom is expected")
        names = d["coordinates"] + d["momenta"]
        need(sorted(names) == sorted(space.coordinates), "two coordinates and their momenta are expected")
        x, y, u, v = (space.coordinates.index(name) for name in names)
        canonical = {(x, u): 1, (y, v): 1, (u, x): -1, (v, y): -1}
        need(brackets(space) == {pair: (ONE * c, 1) for pair, c in canonical.items()}, "not a canonical bracket")
        self.x, self.y, self.u, self.v = (FIELD * i for i in (x, y, u, v))
        self.w, self.k, (self.a, self.b) = self.x, d["degree"], d["chart"]
        need(3 <= self.k <= DEGREE, "the degree of the potential")
        need(abs(self.a) <= CHART and abs(self.b) <= CHART, "a chart")

    def other(self, degree, bound):
        """Has a term of another degree another weight?"""
        part = self.d["part"]
        return part == "highest" and degree < bound or part == "lowest" and degree > bound

    def forms(self):
        h, mass, v = self.here.put(self.space.hamiltonian).p, [P(), P(), P()], P()
        for key, c in h.items():
            x, y, s, t = (key >> i & MASK for i in (self.x, self.y, self.u, self.v))
            need(s + t <= 2, "more than a quadratic form in the momenta")
            if s + t == 2:
                need(x + y == 0, "masses that are not constant")
                mass[t] += P({key - (s << self.u) - (t << self.v): c if s == t else 2 * c})
            elif s + t == 1:
                need(self.other(2 * (x + y), self.k), "a term that is linear in the momenta")
            elif x + y == self.k:
                v += P({key: c})
            elif x + y:
                need(self.other(x + y, self.k), "a term of another degree")
        a, b, (p, q, r) = self.a, self.b, mass
        m11, m12, m22 = (p * i + q * j + r * l for i, j, l in ((a * a, 2 * a * b, b * b), (-a * b, a * a - b * b, a * b),
                                                             (b * b, -2 * a * b, a * a)))
        w = P({1 << self.w: 1})
        images = {i: variable(i) for i in v.variables()}
        images |= {self.x: Function(w * a + ONE * -b), self.y: Function(w * b + ONE * a)}
        self.potential, self.m22, linear = compose(Function(v), images).p, m22, m22 * w - m12
        self.circle = (linear - m12) * w + m11
        self.masses = m11 * m22 - m12 * m12
        self.directions = self.circle * self.potential.diff(self.w) - linear * self.potential * self.k

    def resultant(self, f, g):
        """Sylvester's determinant, up to its sign"""
        return sylvester(f.coefficients(self.w), g.coefficients(self.w)) if f else P()

    def form(self, text):
        return parse(text, self.here.free | {self.space.coordinates[self.w // FIELD]: self.w})

    def row(self, rows, f, sign):
        """The next of the rows shows it."""
        d = read(SHOWN, next(rows, None), "shown")
        self.here.given.show(self.here.multiple(f, d["value"]), sign, d["by"])

    def show(self, f, sign):
        self.row(self.shown, f, sign)

    def need_identity(self, scale, f, g):
        """scale f = g; the scale is shown not to be 0 as well, and by that to be one without w."""
        for c in filter(None, (scale * f - g).coefficients(self.w)):
            self.row(self.zeros, c, "zero")

    def need_multiple(self, scale, f, g):
        """f is g, up to a factor that is not 0."""
        self.need_identity(scale, f, g)
        self.show(scale, "nonzero")

    def proper_points(self):
        """The zeros of `proper` are the directions of Darboux points; the other directions are none."""
        d = self.d
        unit, self.proper, rest = (self.form(d[key]) for key in ("unit", "proper", "rest"))
        need(self.directions.degree(self.w) == self.k, "a direction is at infinity")
        self.n = self.proper.degree(self.w)
        need(1 <= self.n <= POINTS, "the number of Darboux points")
        self.need_identity(unit, self.directions, self.proper * rest)
        for f in (self.masses, self.m22, self.directions.lead(self.w), unit, self.proper.lead(self.w),
                  self.resultant(self.proper, self.circle), self.resultant(self.proper, self.potential)):
            self.show(f, "nonzero")
        if rest.degree(self.w) > 0:
            e = read(IMPROPER, d["improper"], "improper")
            need(1 <= e["power"] <= POWER, "an exponent is out of range")
            self.need_multiple(self.form(e["scale"]), (self.potential * self.circle)**e["power"], rest * self.form(e["cofactor"]))
        else:
            right(d["improper"] is None, "all directions are those of Darboux points")

    def isotropic(self, order, lines, scale, rest):
        """The sum of 1/Lambda, by the orders of the potential in the isotropic directions; with lines, whose product is a multiple of
        c, so that each is one of these directions, by the orders along each of them"""
        orders = order, order if lines is None else lines["order"]
        need(all(0 <= m <= self.k and 2 * m != self.k for m in orders), "an order is out of range")
        if lines is None:
            power = self.circle**order
        else:
            a, b = map(self.form, lines["factors"])
            need(a.degree(self.w) == b.degree(self.w) == 1, "a line is expected")
            self.need_multiple(self.form(lines["over"]), self.circle, a * b)
            power = a**orders[0] * b**orders[1]
        self.need_multiple(scale, self.potential, power * rest)
        self.show(self.resultant(rest, self.circle), "nonzero")
        return sum(Fraction(-self.k, 2 * (self.k - 2 * m)) for m in orders)

    def choices(self, total):
        line = self.circle * self.directions.diff(self.w) - P({1 << self.y: self.k}) * self.masses * self.potential
        chi = self.resultant(self.proper, line)
        need(chi.degree(self.y) == self.n, "the polynomial of the eigenvalues")
        sets = Table(self.k).sets(self.n, total)
        need(len(sets) == len(self.d["choices"]), "other sets of eigenvalues")
        for values, v in zip(sets, self.d["choices"]):
            d = read(CHOICE, v, "choice")
            need(tuple(d["values"]) == values and len(d["equations"]) == self.n, "other eigenvalues")
            given = []
            for i, (value, text) in enumerate(zip(values, d["equations"])):
                f = chi
                for _ in range(values[:i].count(value)):
                    f = f.diff(self.y)
                f = f.substitute(self.y, ONE * value.denominator, ONE * -value.numerator, f.degree(self.y))
                given.append((self.here.multiple(f, text), "zero"))
            self.here.given.also(*given).absent(d["by"])

    def fact(self):
        """Classes, theorems, and the way, of what is said"""
        whole, relation, part = self.d["part"] == "all", self.d["says"] == "relation", self.d["part"]
        which = f"the potential, of degree {self.k}" if whole else f"the part of the potential of {part} degree, {self.k}"
        way = f"the eigenvalues at the {self.n} Darboux points of {which}, which are simple" if relation else \
            f"a multiple Darboux point of {which}"
        used = ["Morales-Ramis, potentials" if relation else "Morales-Ramis-Simo, potentials"] + ["Ziglin, parts"] * (not whole)
        return [IntegralClass() if whole else IntegralClass("rational", "phase space")], used, [way]


def said(theorem, d):
    here = theorem.here(d)
    classes, used, way = Darboux(here, d).fact()
    return Said("N", here.family, [here.conditions()], classes, (), used, (), way, shows_way=True)
