"""A natural system around a line of configurations, and the series of its variational equations at a place over infinity: J1 to
J6 of docs/theory/jet_certificates.md."""
from fractions import Fraction

from certificate_format import need
from function_algebra import BASE, Element, FunctionAlgebra
from jet_series import Series, value
from jets_format import DEGREE, hamiltonian
from multivariate import FIELD, MASK, P
from system_format import fraction


class Motion:
    """J1: the Hamiltonian in x and y; tables {(i, j): coefficient of x^i y^j} of V and of the forces"""

    def __init__(self, d):
        self.d, e, self.n = d, d["variables"][0], len(d["system"]["coordinates"])
        tower = [x | {"derivative": "0"} for x in d["constants"]]
        curve = {"variable": e, "denominators": d["denominators"], "tower": tower}
        self.R = FunctionAlgebra(curve, [*d["parameters"], *d["variables"][1:]])
        self.c = [self.R.names[x] for x in d["variables"][1:]]
        self.one, self.zero = self.R.one, self.R.sum([])
        for f in self.R.denominators:
            need(not f.variables() & {0, *self.c}, "a denominator has a variable in it")
        for f in self.R.values:
            self.need_free(f)
        self.line = {k: [self.constant(x) for x in v] for k, v in d["line"].items()}
        self.potential = self.natural(*hamiltonian(d))
        axes, (alpha, beta) = (self.line["across"], self.line["along"]), self.line["inertias"]
        need(not self.dot(*axes), "the axes are not orthogonal")
        need(not alpha * self.dot(axes[0], axes[0]) - self.one and not beta * self.dot(axes[1], axes[1]) - self.one,
             "an inertia is not that of the axis")
        self.across = {(i - 1, j): alpha * k * -i for (i, j), k in self.potential.items() if i}
        self.along = {(i, j - 1): beta * k * -j for (i, j), k in self.potential.items() if j}
        need(not self.column(self.across, 0), "the force does not point along the line")

    def need_free(self, f, of_e=False):
        places = set() if of_e else {0}
        for row in f.rows.values():
            need(not row.variables() & {*places, *self.c}, "a constant has a variable in it")

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
        """V as a table; H is natural and has these masses"""
        h = self.restricted(h)
        for i in (0, 1):
            rows = h.coefficients(FIELD * (self.n + i))
            need(len(rows) == 3 and not rows[1], "H is not a natural Hamiltonian")
            need(not rows[2].variables() & {FIELD * k for k in range(2 * self.n)}, "H is not a natural Hamiltonian")
            inertia = self.R.divided(self.in_chart(rows[2], names).get((0, 0), self.zero) * 2, n)
            need(not inertia * self.line["masses"][i] - self.one, "a mass is not that of H")
            h = rows[0]
        return {e: self.R.divided(k, n) for e, k in self.in_chart(h, names).items()}

    def in_chart(self, f, names):
        """A polynomial at q = start + x across + y along"""
        values = {FIELD * i: {1: self.R.read(x)} for i, x in enumerate(names) if i >= 2 * self.n}
        q = [self.table(zip([(0, 0), (1, 0), (0, 1)], (self.line[k][i] for k in ("start", "across", "along")))) for i in (0, 1)]
        powers, total = [[self.table([((0, 0), self.one)]), x] for x in q], []
        for k, c in f.items():
            a, b = k & MASK, k >> FIELD & MASK
            need(max(a, b) <= DEGREE, "the degree of the potential is too large")
            need(not any(k >> FIELD * i & MASK for i in range(2, 2 * self.n)), "H is not a natural Hamiltonian")
            for known, n in ((powers[0], a), (powers[1], b)):
                while len(known) <= n:
                    known.append(self.times(known[-1], known[1]))
            scale = self.R.put_in(P({k >> 2 * FIELD << 2 * FIELD: c}), 1, values)
            total += [(e, x * scale) for e, x in self.times(powers[0][a], powers[1][b]).items()]
        return self.table(total)

    def table(self, terms):
        all_terms = {}
        for e, k in terms:
            all_terms[e] = all_terms[e] + k if e in all_terms else k
        return {e: k for e, k in all_terms.items() if k}

    def times(self, f, g):
        return self.table(((a + i, b + j), k * m) for (a, b), k in f.items() for (i, j), m in g.items())

    def column(self, table, i):
        """Of x^i: the polynomial in y, ascending"""
        rows = {b: k for (a, b), k in table.items() if a == i}
        return [rows.get(b, self.zero) for b in range(max(rows, default=-1) + 1)]


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
        degrees = {sum(k >> x & MASK for x in self.c) for row in f.rows.values() for k in row}
        return degrees.pop() if len(degrees) == 1 else None

    def series(self, v, degree):
        if v is None:
            return Series(self.R)
        terms = [self.R.read(x) for x in v[1]]
        need(all(not x or self.degree_in_c(x) == degree for x in terms), "a series is not homogeneous in c1 and c2")
        return Series(self.R, enumerate(terms, v[0]), v[0] + len(terms))

    def number(self, c, m=0):
        return Series(self.R, {m: c})

    def at_solution(self, f):
        """A polynomial in y, in the time t"""
        total = Series(self.R)
        for k in reversed(f):
            total = total * self.y + self.number(k * self.scale)
        return total

    def need_solution(self, x, force, last):
        """x'' = force, as far as x is given, and that is beyond the last root"""
        if x.zero():
            return need(force.zero(), "a series is not 0")
        need(x.end > last, "a series ends before the last resonance")
        rest = x.derivative(self.turns).derivative(self.turns) - force
        return need(rest.start() >= x.end - 2 * self.turns, "a series is not a solution as far as it is given")

    def need_place(self, place):
        """J2"""
        v, g, w, d = self.column(self.potential, 0), self.column(self.along, 0), self.column(self.across, 1), self.turns
        self.k = len(v) - 1
        need(self.k >= 3, "the potential on the line is of degree < 3")
        need(len(w) <= self.k - 1, "the normal equation is irregular at infinity")
        need(2 * d % (self.k - 2) == 0, "the number of turns is wrong")
        self.first = -2 * d // (self.k - 2)
        self.last = 2 * d - self.first
        self.sigma = Fraction(self.first, d)
        lead = self.sigma * (self.sigma - 1)
        need(not self.scale * g[-1] * lead.denominator - self.one * lead.numerator, "the time is not scaled")
        self.y = self.series(place["solution"], 0)
        need(self.y.start() == self.first and not self.y[self.first] - self.one, "the solution does not begin as it must")
        self.need_solution(self.y, self.at_solution(g), self.last)
        need(not self.y[self.last] - self.R.z, "e is not a coefficient")
        self.v, self.g, self.w = v, g, w

    def need_normal(self, place):
        """J3"""
        w, self.u = self.at_solution(self.w), [self.series(x, 0) for x in place["normal"]]
        lows = [u.start() for u in self.u]
        need(all(x and x[0] == low for x, low in zip(place["normal"], lows)), "a solution does not begin with 1")
        need(sum(lows) == self.turns and lows[0] < lows[1], "the exponents are wrong")
        for u, low in zip(self.u, lows):
            need(low < u.end and not u[low] - self.one, "a solution does not begin with 1")
            self.need_solution(u, w * u, lows[1])
        self.rho = [Fraction(low, self.turns) for low in lows]

    def need_jets(self, jets):
        """J4 and J5"""
        order = self.order = jets["order"]
        one = [self.number(self.one)] + [Series(self.R)] * order
        x, y = ([Series(self.R)] * (order + 1) for _ in range(2))
        c = [Element(self.R, {0: P({1 << at: 1})}) for at in self.c]
        y[0], x[1] = self.y, self.u[0] * c[0] + self.u[1] * c[1]
        for j in range(2, order):
            x[j], y[j] = self.series(jets["across"][j - 2], j), self.series(jets["along"][j - 2], j)
        forces = [[f * self.scale for f in value(table, x, y, one)] for table in (self.across, self.along)]
        for j in range(2, order):
            self.need_solution(x[j], forces[0][j], self.u[1].start())
            self.need_solution(y[j], forces[1][j], self.last)
        self.form = self.R.read(jets["form"])
        need(self.form and self.degree_in_c(self.form) == order + 1, "the form has another degree")
        for u, at in zip(self.u, self.c):
            slope = self.R.element({k: g for k, f in self.form.rows.items() if (g := f.diff(at))}, self.form.n, self.form.e)
            need(not forces[0][order].coefficient(u, -self.turns) + slope, "the form is not that of the residues")

    def entry(self, i):
        """Of c1^i c2^(order + 1 - i) in the form"""
        at = self.c[0]
        rows = {k: P((m - (i << at) - (self.order + 1 - i << self.c[1]), c) for m, c in f.items() if m >> at & MASK == i)
                for k, f in self.form.rows.items()}
        return self.R.element({k: f for k, f in rows.items() if f}, self.form.n, self.form.e)

    def need_minor(self, d, alone):
        """J6: a minor of the columns of c1 R_2, c2 R_2 - c1 R_1, c2 R_1, or an entry of R"""
        columns, n = d["columns"], self.order + 1
        need(columns == sorted(set(columns)) and len(columns) == (1 if alone else 3), "other columns are expected")
        if alone:
            minor = self.entry(columns[0])
        else:
            m = [(self.entry(j - 1) * (n - j + 1), self.entry(j) * (n - 2 * j), self.entry(j + 1) * (j + 1)) for j in columns]
            minor = self.R.sum(m[k][0] * (m[(k + 1) % 3][1] * m[(k + 2) % 3][2] - m[(k + 1) % 3][2] * m[(k + 2) % 3][1])
                               for k in range(3))
        self.value = self.R.read(d["value"])
        self.need_free(self.value, True)
        need(self.value, "the obstruction is 0")
        shown = fraction(d["value"], self.R.at, len(self.R.denominators))[0]    # w^2 may be a parameter
        need(all(x < BASE for x in shown.variables()), "the value has an algebraic constant in it")
        need(not self.R.read(d["cofactor"]) * minor - self.value**d["power"], "the obstruction has another value")
