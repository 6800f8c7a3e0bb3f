"""Checks kovacic-homoclinic/1: a transverse homoclinic point of a section map (docs/theory/chaos.md; the numbers in brackets are
its sections).  The numbers of the certificate are guesses; everything is enclosed again, in integers (enclosures.py).

usage: kovacic_verify.py FILE..."""
import re
from fractions import Fraction
from itertools import combinations

import checked
from certificate_format import NAME, Rejected, need, read, refusing, right
from enclosures import ONE, UNIT, ZERO, Ball, Flow, Polynomials, adjugate, determinant, matrix, total
from multivariate import FIELD, P, parse

FORMAT = "kovacic-homoclinic/1"
FAR = ONE >> 20                 # a guess is better than that
TOP = {"format": "text", "variables": ["text"], "hamiltonian": ["text"], "level": "any", "section": ["text"],
       "direction": ("upward", "downward"), "where": "any", "period": "int", "point": ["any"], "chart": ["int"], "axes": [["any"]],
       "reach": "any", "xi": "any", "eta": "any", "orbit": [["any"]]}
NUMBER = re.compile(r"-?([0-9]+/0*[1-9][0-9]*|([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?0*(?P<power>[0-9]{1,3}))?)\Z")


def number(v):
    right(isinstance(v, str) and len(v) < 60, "a number is a short string")
    found = NUMBER.match(v)
    right(found, "a number is expected")
    right(int(found["power"] or 0) < 400, "a number is too small or large")
    return Fraction(v)


def numbers(v, n):
    right(len(v) == n, f"{n} numbers are expected")
    return [number(x) for x in v]


def read_homoclinic(top):
    d = read(TOP, top, "certificate")
    names = d["variables"]
    right(len(names) == 4 == len(set(names)) and all(map(NAME.match, names)), "four names are expected")
    at = {x: FIELD * i for i, x in enumerate(names)}

    def polynomial(v):
        right(len(v) == 2, "a polynomial over an integer is expected")
        f, n = parse(v[0], at), int(v[1]) if re.fullmatch("[1-9][0-9]{0,999}", v[1]) else 0
        right(n > 0 and len(f) < 200 and all(f.degree(x) <= 16 for x in at.values()), "a polynomial is not of this format")
        return f, n
    d["hamiltonian"], d["section"] = polynomial(d["hamiltonian"]), polynomial(d["section"])
    d["where"] = (P({0: 1}), 1) if d["where"] is None else polynomial(read(["text"], d["where"], "where"))
    right(1 <= d["period"] <= 64, "a period is 1 to 64")
    right(d["chart"] in [[i, j] for i, j in combinations(range(4), 2)], "a chart is two places")
    right(1 <= len(d["orbit"]) * d["period"] <= 400, "an orbit has up to 400 points")
    right(len(d["axes"]) == 2, "axes are a matrix")
    d["axes"] = [[Ball.of(x).middle() for x in numbers(row, 2)] for row in d["axes"]]
    d["point"], d["orbit"] = numbers(d["point"], 4), [numbers(x, 4) for x in d["orbit"]]
    d["level"], d["reach"], d["xi"], d["eta"] = (number(d[k]) for k in ("level", "reach", "xi", "eta"))
    right(0 < d["reach"] < 1, "the reach is not in (0, 1)")
    return d


def inverse(a):
    d = determinant(a)
    return [[x / d for x in row] for row in adjugate(a)]


def apply(a, v):
    return [total(x * y for x, y in zip(row, v)) for row in a]


class Patch:
    """(1.1) Over each point of the box of the chart's two coordinates one point of the surface; x: those points, with
    derivatives by the chart's coordinates; sheet: where there is no other one"""

    def __init__(self, surface, chart, box, near):
        self.chart, self.box, self.rest = chart, box, [i for i in range(4) if i not in chart]
        y, middle = [near[i].middle() for i in self.rest], [b.middle() for b in box]
        for _ in range(8):
            value, slope = surface.at(self.joined(middle, y), self.rest)
            y = [(a - b).middle() for a, b in zip(y, apply(inverse(slope), value))]
        value, _ = surface.at(self.joined(box, y), self.rest)
        for room in range(6, 60, 3):
            self.sheet = [b.wider(ONE >> room) for b in y]
            try:
                _, slope = surface.at(self.joined(box, self.sheet), self.rest)
                found = [a - b for a, b in zip(y, apply(inverse(slope), value))]
            except Rejected:
                continue                # a larger sheet than there is
            if all(a.inside(b) for a, b in zip(found, self.sheet)):
                break
        else:
            raise Rejected("a piece of the surface is not enclosed")
        x = self.joined(box, found)
        _, by_rest = surface.at(x, self.rest)
        _, by_chart = surface.at(x, chart)
        self.x = [[b, ZERO, ZERO] for b in x]
        slopes = matrix(inverse(by_rest), by_chart)
        for part in (0, 1):
            self.x[chart[part]][1 + part] = UNIT
            for i, place in enumerate(self.rest):
                self.x[place][1 + part] = -slopes[i][part]

    def joined(self, free, rest):
        x = [ZERO] * 4
        for i, b in zip([*self.chart, *self.rest], [*free, *rest]):
            x[i] = b
        return x

    def holds(self, x):
        """A point with chart coordinates in the box whose other coordinates are those of x is a point of the patch"""
        return all(x[i][0].inside(b) for i, b in zip(self.rest, self.sheet))


def gradient(f, c=1):
    """c times that of a polynomial over a number"""
    return [(f[0].diff(FIELD * i) * c, f[1]) for i in range(4)]


class Surface:
    """section = 0, H = level"""

    def __init__(self, d):
        self.d, h, s = d, d["hamiltonian"], d["section"]
        self.values, self.slopes, self.level = Polynomials([s, h]), Polynomials(gradient(s) + gradient(h)), Ball.of(d["level"])
        self.flows = {}
        for way in (1, -1):                 # along -X the section's function grows where it falls along X
            up = way if d["direction"] == "upward" else -way
            field, section, slope = gradient(h, way)[2:] + gradient(h, -way)[:2], (s[0] * up, s[1]), gradient(s, up)
            self.flows[way] = Flow(*map(Polynomials, (field, [section], slope, [d["where"]])))

    def at(self, x, places):
        """The two equations and their derivatives by two coordinates"""
        s, h = self.values.at(x)
        by = self.slopes.at(x)
        return [s, h - self.level], [[by[i] for i in places], [by[4 + i] for i in places]]

    def chart(self, x):
        """The coordinates for which the others are determined best"""
        _, by = self.at(x, range(4))
        return max(combinations(range(4), 2), key=lambda c: abs(
            determinant([[row[i] for i in range(4) if i not in c] for row in by]).about()))

    def carried(self, patch, way=1):
        """(1.2) Q, or its inverse, over a patch: where its points land, with derivatives; and where that of the middle does"""
        middle = [b.middle() for b in patch.box]
        off = [a - b for a, b in zip(patch.box, middle)]
        thin = Patch(self, patch.chart, middle, [row[0] for row in patch.x])
        need(patch.holds(thin.x), "the middle of a patch is not known to lie on its sheet")
        x, y = patch.x, [row[:1] for row in thin.x]
        for _ in range(self.d["period"]):
            x, y = self.flows[way].returned(x, y, off)
        return x, y


def by_chart(x, chart):
    return [[x[i][1], x[i][2]] for i in chart]


def cone(m):
    """(3.1) The least kappa = 2^-k for which the matrices keep the cone around the first axis and stretch it"""
    (a, b), (c, d) = m
    for k in range(40, 3, -1):
        kappa = Fraction(1, 2**k)
        stretch = abs(a.m) - a.r - b.most() * kappa
        if a.sign() and c.most() + d.most() * kappa < kappa * stretch and stretch > ONE:
            return Ball.of(kappa)
    raise Rejected("no cone is kept")


def contraction(c, value, slope, radius):
    """Krawczyk's test (2): K - m of each unknown is smaller than its radius"""
    n = len(value)
    shift = [-total(a * b for a, b in zip(row, value) if a.m) for row in c]
    for j in range(n):
        column = [(k, slope[k][j]) for k in range(n) if slope[k][j].m or slope[k][j].r]
        for i in range(n):
            entry = (UNIT if i == j else ZERO) - total(c[i][k] * b for k, b in column)
            shift[i] = shift[i] + entry * Ball(0, radius[j])
    return shift


def approximate_inverse(a):
    """In floating point, as exact numbers"""
    n = len(a)
    a = [[b.about() for b in row] + [float(i == j) for j in range(n)] for i, row in enumerate(a)]
    for i in range(n):
        k = max(range(i, n), key=lambda k: abs(a[k][i]))
        a[i], a[k] = a[k], a[i]
        need(a[i][i], "a matrix is singular, or nearly")
        a[i] = [x / a[i][i] for x in a[i]]
        for k in range(n):
            if k != i and a[k][i]:
                f = a[k][i]
                a[k] = [x - f * y for x, y in zip(a[k], a[i])]
    return [[Ball.of(x).middle() for x in row[n:]] for row in a]


def solved(equations, radius, what):
    """The unknowns minus their guesses, by Krawczyk's test for boxes of larger and larger radii; and the radii"""
    inverse = None
    for _ in range(4):
        value, slope = equations(radius)
        inverse = inverse or approximate_inverse(slope)
        shift = contraction(inverse, value, slope, radius)
        need(all(s.most() < FAR for s in shift), f"{what} is not near its guess")
        if all(s.most() < r for s, r in zip(shift, radius)):
            return shift, radius
        radius = [2 * max(r, s.most()) + 1 for r, s in zip(radius, shift)]
    raise Rejected(f"{what} is not proved")


class Proof:
    def __init__(self, d):
        self.d, self.surface = d, Surface(d)
        self.chart, self.near = d["chart"], [Ball.of(x).middle() for x in d["point"]]
        self.fixed_point()
        self.manifolds()
        self.connection()

    def fixed_point(self):
        """(2) p: where it is in the chart"""
        middle = [self.near[i] for i in self.chart]

        def equations(radius):
            self.at_p = Patch(self.surface, self.chart, [b.wider(r) for b, r in zip(middle, radius)], self.near)
            self.back, thin = self.surface.carried(self.at_p)
            slope = by_chart(self.back, self.chart)
            for i in (0, 1):
                slope[i][i] = slope[i][i] - UNIT
            return [thin[i][0] - b for i, b in zip(self.chart, middle)], slope
        self.p = [m + s for m, s in zip(middle, solved(equations, [ONE >> 90] * 2, "the fixed point")[0])]
        need(self.at_p.holds(self.back), "the orbit may close on another sheet")

    def manifolds(self):
        """(3) the region, and kappa of both graphs"""
        a, r = self.d["axes"], Ball(0, Ball.of(self.d["reach"]).low())
        box = [p + x * r + y * r for p, (x, y) in zip(self.p, a)]
        self.reach, self.region = r.r, Patch(self.surface, self.chart, box, self.near)
        need(self.region.holds(self.at_p.x), "the fixed point may lie on another sheet")
        self.kappa = []
        for way in (1, -1):
            x, _ = self.surface.carried(self.region, way)
            need(self.region.holds(x), "the region may come back on another sheet")
            m = matrix(inverse(a), matrix(by_chart(x, self.chart), a))
            self.kappa.append(cone(m if way > 0 else [row[::-1] for row in m[::-1]]))

    def on_graph(self, axis, along):
        off = Ball(0, self.kappa[axis].m) * along
        return [p + row[axis] * along + row[1 - axis] * off for p, row in zip(self.p, self.d["axes"])]

    def tangent(self, axis):
        return [row[axis] + row[1 - axis] * Ball(0, self.kappa[axis].m) for row in self.d["axes"]]

    def connection(self):
        """(4) Krawczyk's test for xi, z_1 ... z_(n-1), eta"""
        d = self.d
        self.xi, self.eta = Ball.of(d["xi"]).middle(), Ball.of(d["eta"]).middle()
        self.points = [[Ball.of(x).middle() for x in z] for z in d["orbit"]]
        self.charts = [self.chart, *map(self.surface.chart, self.points), self.chart]
        self.n = len(self.points) + 1
        self.ends(solved(self.equations, [0] * 2 * self.n, "the homoclinic orbit")[1])

    def links(self, radius):
        """The map over boxes around the z_k"""
        self.patches = [Patch(self.surface, self.chart, self.on_graph(0, self.xi.wider(radius[0])), self.near)]
        for k, z in enumerate(self.points):
            box = [z[i].wider(r) for i, r in zip(self.charts[k + 1], radius[2 * k + 1:2 * k + 3])]
            self.patches.append(Patch(self.surface, self.charts[k + 1], box, z))
        self.images = [self.surface.carried(p) for p in self.patches]

    def equations(self, radius):
        """Their values at the middles, and their derivatives, for all pairs of graphs"""
        self.links(radius)
        n, value = self.n, []
        slope = [[ZERO] * 2 * n for _ in range(2 * n)]
        u, s, last = self.tangent(0), self.tangent(1), self.on_graph(1, self.eta)
        off = [a - b.middle() for a, b in zip(self.on_graph(0, self.xi), self.patches[0].box)]
        for k, (x, thin) in enumerate(self.images):
            chart, by = self.charts[k + 1], by_chart(x, self.charts[k + 1])
            at = [thin[i][0] for i in chart]
            if k == 0:
                at = [a + b for a, b in zip(at, apply(by, off))]
            to = [self.points[k][i] for i in chart] if k + 1 < n else last
            value += [a - b for a, b in zip(at, to)]
            for i in (0, 1):
                row = slope[2 * k + i]
                if k == 0:
                    row[0] = by[i][0] * u[0] + by[i][1] * u[1]
                else:
                    row[2 * k - 1], row[2 * k] = by[i]
                if k + 1 < n:
                    row[2 * k + 1 + i] = -UNIT
                else:
                    row[2 * n - 1] = -s[i]
        return value, slope

    def ends(self, radius):
        for x, r in ((self.xi, radius[0]), (self.eta, radius[-1])):
            need(r < abs(x.m) and abs(x.m) + r < self.reach, "an end is the fixed point, or outside of the region")
        need(self.region.holds(self.patches[0].x), "the orbit may begin on another sheet")
        for k, (x, _) in enumerate(self.images):
            to = self.patches[k + 1] if k + 1 < self.n else self.region
            need(to.holds(x), "the orbit may come back on another sheet")


@checked.file()
def verify(top, *_):
    """One trusted step, the theorem of Smale and Moser; a summary; the statement"""
    d = read_homoclinic(top)
    with refusing():
        proof = Proof(d)
    checked.label(FORMAT, "fixed-point manifolds crossing")
    checked.conclude((), "first integrals that are real-analytic near the closure of one orbit, on one level")
    names = d["variables"]
    near = [0.0 if abs(b.about()) < 1e-12 else b.about() for b in proof.p]
    at = ", ".join(f"{names[i]} = {x:.12g}" for i, x in zip(d["chart"], near))
    where = "" if top["where"] is None else f", where ({top['where'][0]})/{top['where'][1]} > 0"
    return 1, "", [
        f"H = ({top['hamiltonian'][0]})/{top['hamiltonian'][1]} with {names[0]}' = dH/d{names[2]}, ..., on the level H = {d['level']};",
        f"the map of the section ({top['section'][0]})/{top['section'][1]} = 0, {d['direction']}{where}" +
        (f", to the power {d['period']}" if d["period"] > 1 else ""),
        f"has a hyperbolic fixed point at {at} and a transverse homoclinic point to it.",
        "So (trusted: Smale, Moser) it has a horseshoe, and every real-analytic first integral on a connected open part of the level around",
        "the closure of the homoclinic orbit is constant."]
