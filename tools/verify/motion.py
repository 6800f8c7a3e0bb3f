"""A natural system around a line of configurations, and the series of its variational equations at a place over infinity: J1 to
J6 of docs/theory/jet_certificates.md."""
from fractions import Fraction

from certificate_format import need
from function_algebra import BASE, FunctionAlgebra
from jet_series import Jet, Series
from jets_format import DEGREE, hamiltonian
from multivariate import FIELD, MASK, P
from system_format import fraction


class Motion:
    """J1: the Hamiltonian in x and y, which have the names of c1 and c2: V and the forces"""

    def __init__(self, d):
        self.d, e, self.n = d, d["variables"][0], len(d["system"]["coordinates"])
        tower = [x | {"derivative": "0"} for x in d["constants"]]
        curve = {"variable": e, "denominators": d["denominators"], "tower": tower}
        self.R = FunctionAlgebra(curve, [*d["parameters"], *d["variables"][1:]])
        self.x, self.y = self.c = [self.R.names[x] for x in d["variables"][1:]]
        self.one = self.R.one
        for f in self.R.denominators:
            need(not f.variables() & {0, *self.c}, "a denominator has a variable in it")
        for f in self.R.values:
            self.need_free(f)
        self.line = {k: [self.constant(x) for x in v] for k, v in d["line"].items()}
        self.potential = self.natural(*hamiltonian(d))
        axes, inertias = (self.line["across"], self.line["along"]), self.line["inertias"]
        need(not self.dot(*axes), "the axes are not orthogonal")
        need(not any(k * self.dot(a, a) - self.one for k, a in zip(inertias, axes)), "an inertia is not that of the axis")
        self.across, self.along = (self.potential.diff(x) * k * -1 for x, k in zip(self.c, inertias))
        need(not self.across.part(self.x, 0), "the force does not point along the line")

    def need_free(self, f, of_e=False):
        need(not f.p.variables() & {*self.c, *(() if of_e else [0])}, "a constant has a variable in it")

    def constant(self, v):
        f = self.R.read(v)
        self.need_free(f)
        return f

    def dot(self, a, b):
        return self.R.sum(m * x * y for m, x, y in zip(self.line["masses"], a, b))

    def restricted(self, h):
        """H on the subspace where all positions but the first two, and their momenta, are 0"""
        zero = [FIELD * (i + half) for half in (0, self.n) for i in range(2, self.n)]

        def at_zero(f):
            return P((k, c) for k, c in f.items() if not any(k >> x & MASK for x in zero))
        need(not any(at_zero(h.diff(x)) for x in zero), "the subspace is not invariant")
        return at_zero(h)

    def natural(self, h, n, names):
        """V; H is natural and has these masses"""
        h = self.restricted(h)
        for i in (0, 1):
            rows = h.coefficients(FIELD * (self.n + i))
            need(len(rows) == 3 and not rows[1], "H is not a natural Hamiltonian")
            need(not rows[2].variables() & {FIELD * k for k in range(2 * self.n)}, "H is not a natural Hamiltonian")
            inertia = self.R.divided(self.in_chart(rows[2], names) * 2, n)
            need(not inertia * self.line["masses"][i] - self.one, "a mass is not that of H")
            h = rows[0]
        need(h.degree(0) <= DEGREE and h.degree(FIELD) <= DEGREE, "the degree of the potential is too large")
        return self.R.divided(self.in_chart(h, names), n)

    def in_chart(self, f, names):
        """A polynomial without momenta at q = start + x across + y along"""
        values = {FIELD * i: {1: self.R.read(x)} for i, x in enumerate(names) if i >= 2 * self.n}
        x, y = map(self.R.name, self.c)
        for i, (start, across, along) in enumerate(zip(*(self.line[k] for k in ("start", "across", "along")))):
            values[FIELD * i] = {1: start + across * x + along * y}
        return self.R.put_in(f, 1, values)


class Jets(Motion):
    """J2 to J6: the series at the place, and the form"""

    def __init__(self, d):
        super().__init__(d)
        self.turns, self.scale = d["place"]["turns"], self.constant(d["place"]["time_scale"])
        self.need_place(d["place"])
        self.need_normal(d["place"])
        self.need_jets(d["jets"])
        self.need_minor(d["obstruction"], d["group"]["by"] == "homogeneous")

    def degree_in_c(self, f):
        """Of all terms; None if they have several"""
        degrees = {sum(k >> x & MASK for x in self.c) for k in f.p}
        return degrees.pop() if len(degrees) == 1 else None

    def series(self, v, degree):
        if v is None:
            return Series(self.R)
        terms = [self.R.read(x) for x in v[1]]
        need(all(not x or self.degree_in_c(x) == degree for x in terms), "a series is not homogeneous in c1 and c2")
        return Series(self.R, enumerate(terms, v[0]), v[0] + len(terms))

    def number(self, c):
        return Series(self.R, {0: c})

    def put(self, f, known, ring=lambda c: c):
        """f with series for x and y; ring: their constants, if they are of another one"""
        return f.p.at(known, lambda p: ring(self.number(self.R.element(p, f.n, f.e))))

    def at_solution(self, f):
        """A polynomial in y"""
        return self.put(f, {self.y: self.powers})

    def need_solution(self, x, force, last):
        """x'' = force, as far as x is given, and that is beyond the last root"""
        if x.zero():
            return need(force.zero(), "a series is not 0")
        need(x.end > last, "a series ends before the last resonance")
        rest = x.derivative(self.turns).derivative(self.turns) - force
        return need(rest.start() >= x.end - 2 * self.turns, "a series is not a solution as far as it is given")

    def need_place(self, place):
        """J2"""
        parts = (self.potential, 0), (self.along, 0), (self.across, 1)
        v, g, w = self.v, self.g, self.w = [f.part(self.x, i) for f, i in parts]
        self.k, d = v.p.degree(self.y), self.turns
        need(self.k >= 3, "the potential on the line is of degree < 3")
        need(w.p.degree(self.y) <= self.k - 2, "the normal equation is irregular at infinity")
        need(2 * d % (self.k - 2) == 0, "the number of turns is wrong")
        first = -2 * d // (self.k - 2)
        self.last = 2 * d - first
        self.sigma = Fraction(first, d)
        lead = self.sigma * (self.sigma - 1)
        scaled = self.scale * g.part(self.y, self.k - 1)
        need(not scaled * lead.denominator - self.one * lead.numerator, "the time is not scaled")
        self.solution = y = self.series(place["solution"], 0)
        self.powers = {1: y}
        need(y.start() == first and not y[first] - self.one, "the solution does not begin as it must")
        self.need_solution(y, self.at_solution(g * self.scale), self.last)
        need(not y[self.last] - self.R.z, "e is not a coefficient")

    def need_normal(self, place):
        """J3"""
        w, self.u = self.at_solution(self.w * self.scale), [self.series(x, 0) for x in place["normal"]]
        lows = [u.start() for u in self.u]
        need(all(x and x[0] == low for x, low in zip(place["normal"], lows)), "a solution does not begin with 1")
        need(sum(lows) == self.turns and lows[0] < lows[1], "the exponents are wrong")
        for u, low in zip(self.u, lows):
            need(low < u.end and not u[low] - self.one, "a solution does not begin with 1")
            self.need_solution(u, w * u, lows[1])
        self.rho = [Fraction(low, self.turns) for low in lows]

    def need_jets(self, jets):
        """J4 and J5"""
        order, none = jets["order"], Series(self.R)
        self.order, c = order, [self.R.name(x) for x in self.c]
        x, y = (Jet([*rows, *(self.series(v, j) for j, v in enumerate(jets[key], 2)), none]) for key, rows in (
            ("across", (none, self.u[0] * c[0] + self.u[1] * c[1])), ("along", (self.solution, none))))
        known = {self.x: {1: x}, self.y: {1: y}}
        forces = [self.put(f * self.scale, known, lambda k: Jet([k, *[none] * order])) for f in (self.across, self.along)]
        for j in range(2, order):
            self.need_solution(x[j], forces[0][j], self.u[1].start())
            self.need_solution(y[j], forces[1][j], self.last)
        self.form = self.R.read(jets["form"])
        need(self.form and self.degree_in_c(self.form) == order + 1, "the form has another degree")
        for u, at in zip(self.u, self.c):
            need(not forces[0][order].coefficient(u, -self.turns) + self.form.diff(at), "the form is not that of the residues")

    def entry(self, i):
        """Of c1^i c2^(order + 1 - i) in the form"""
        return self.form.part(self.x, i).part(self.y, self.order + 1 - i)

    def need_minor(self, d, alone):
        """J6: a minor of the columns of c1 R_2, c2 R_2 - c1 R_1, c2 R_1, or an entry of R"""
        columns, n = d["columns"], self.order + 1
        need(columns == sorted(set(columns)) and len(columns) == (1 if alone else 3), "other columns are expected")
        if alone:
            minor = self.entry(columns[0])
        else:
            minor = self.R.determinant([
                [self.entry(j - 1) * (n - j + 1), self.entry(j) * (n - 2 * j), self.entry(j + 1) * (j + 1)] for j in columns])
        self.value = self.R.read(d["value"])
        self.need_free(self.value, True)
        need(self.value, "the obstruction is 0")
        shown = fraction(d["value"], self.R.at, len(self.R.denominators))[0]    # w^2 may be a parameter
        need(max(shown.variables(), default=0) < BASE, "the value has an algebraic constant in it")
        need(not self.R.read(d["cofactor"]) * minor - self.value**d["power"], "the obstruction has another value")
