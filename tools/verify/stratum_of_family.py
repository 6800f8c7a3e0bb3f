"""What is said of a family where some of its parameters are functions of the others, in its own coordinates
(docs/theory/theorem_certificates.md 12, 13)."""
from itertools import combinations

from certificate_format import need, read
from condition import SIGNED
from first_integrals import IntegralClass
from multivariate import FIELD, MASK, ONE, P, parse, ratio, resultant
from phase_space import NOTHING, Function, total
from place import equations
from strata_format import NAME
from system_format import right
from tower import Tower, compose

MINOR, PARTS = 8, 500
CLASS = {"kind": "text", "near": "text", "on_leaf": "text", "liouville": "text", "functions": ["text"], "without": ["text"],
         "through": ["text"], "frame": "text"}


def read_class(v):
    d, truth = read(CLASS, v, "class"), {"yes": True, "no": False}
    right(d["kind"] in ("rational", "meromorphic", "real-analytic"), "an unknown word")
    right(d["near"] in ("curve", "closed curve", "origin", "phase space"), "an unknown word")
    right(d["kind"] != ("meromorphic" if d["near"] == "phase space" else "real-analytic"),
          "real-analytic functions are those on the phase space, meromorphic ones are not")
    right(d["on_leaf"] in truth and d["liouville"] in truth, "an unknown word")
    right(all(NAME.match(x) for key in ("functions", "without", "through") for x in d[key]), "a name is expected")
    right(all(" " <= x <= "~" for x in d["frame"]), "one line is expected")
    return IntegralClass(d["kind"], d["near"], truth[d["on_leaf"]], *(tuple(d[key]) for key in ("functions", "without", "through")),
                         d["frame"], truth[d["liouville"]])


class Stratum:
    """at: {name: Function}, parameters of the family that are put in; region: conditions besides"""

    def __init__(self, family, at, region):
        self.family, self.space, self.values, self.region = family, family.space, at, region
        space = self.space
        self.images = {v: Function(P({1 << v: 1})) for v in space.at.values()}
        self.images |= {family.names[x]: f for x, f in at.items()}
        self.tower = Tower(space.at)
        for u in space.inverses:
            self.adjoin(space.at[u], self.put(space.denominators[space.at[u]]), self.images, space.at[u])
        self.given = family.where([(self.put(Function(f)).p.primitive(), says) for f, says in family.assumptions + region])

    def adjoin(self, variable, h, images, name):
        """The variable stands for 1/p, h = p/n; `name` has the value 1/h."""
        need(h, "a denominator is 0")
        self.tower.steps.append((variable, None, h.p))
        images[name] = Function(P({1 << variable: h.n}))

    def put(self, f):
        return compose(f, self.images)

    def conditions(self):
        return equations(self.family, self.values) + self.region

    def monic(self, v):
        """A relation with v as the last of its functions, whose leading coefficient in v is a number; or None"""
        functions = {self.space.at[s] for s in self.space.functions}
        for r in self.space.relations:
            p = self.put(r).p
            if p.degree(v) > 0 and max(p.variables() & functions) == v and p.coefficients(v)[-1].constant() is not None:
                return p
        return None

    def need_zero(self, f, why):
        """Cleared to 0, also modulo relations that are monic in a function of their own and equations of the stratum that are
        monic in a parameter"""
        p = self.cleared(f.p)
        for s in reversed(self.space.functions):
            v = self.space.at[s]
            r = self.monic(v) if p else None
            if r:
                p = remainder(p, r, v, r.degree(v))
        need(not modulo_equations(p, [g for g, says in self.given.conditions if says == "zero"]), why)

    def norm(self, p):
        """Not 0 only where p is not, for all branches of the functions: resultants with such relations; other functions stay"""
        for s in reversed(self.space.functions):
            v = self.space.at[s]
            r = self.monic(v) if p.degree(v) > 0 else None
            if r is not None:
                p = resultant(r, p, v)
        return p

    def arguments(self):
        """The coordinates on which a function depends"""
        return {j for gradient in self.space.gradients.values() for j in gradient}

    def cleared(self, p):
        for x, _, h in reversed(self.tower.steps):
            n = p.degree(x)
            if n > 0:
                p = p.substitute(x, h, ONE * -1, n)
        return p


def remainder(p, r, v, d):
    """A multiple of p by a number, less a multiple of r, of degree < d in v; the leading coefficient of r is a number."""
    lead = r.coefficients(v)[-1].constant()
    while p and p.degree(v) >= d:
        top = p.coefficients(v)[-1]
        p = p * lead - r * top * P({p.degree(v) - d << v: 1})
    return p


def modulo_equations(p, equations):
    """A multiple of p by a number, less multiples of the equations: from the last variable to the first it is divided by the first
    of those whose last variable this is, with a number as its leading coefficient there."""
    last = {}
    for g in equations:
        v = max(g.variables(), default=None)
        if v is not None and g.coefficients(v)[-1].constant() is not None:
            last.setdefault(v, g)
    for v in sorted(last, reverse=True):
        p = remainder(p, last[v], v, last[v].degree(v))
    return p


class Restriction:
    """The system of the target is that of the family on the stratum."""

    def __init__(self, here, target, levels):
        self.here, self.family, self.x, self.y, self.target = here, here.family, here.space, target.space, target
        x, y = self.x, self.y
        need(len(x.coordinates) == len(y.coordinates), "another number of coordinates")
        need((x.hamiltonian is None) == (y.hamiltonian is None), "a bracket, or none")
        self.images = {}
        for names, known in ((y.coordinates, x.coordinates), (y.functions, x.functions)):
            for name in names:
                need(name in known, "the system has another name")
                self.images[y.at[name]] = Function(P({1 << x.at[name]: 1}))
        chosen = target.curve.chosen_by_functions() if target.curve else ()
        for name in target.parameters:
            if name in x.at:
                need(name in self.family.names and name not in here.values, "a parameter that has a value")
                self.images[y.at[name]] = Function(P({1 << x.at[name]: 1}))
            need(name in x.at or name not in chosen, "a level in the value of a function, or of what it depends on")
            if name in levels:
                need(name not in x.at, "a level is expected")
                self.images[y.at[name]] = here.put(levels[name])
        need(set(levels) <= set(target.parameters), "a level is expected")
        for k, u in enumerate(y.inverses):
            h = compose(y.denominators[y.at[u]], self.images)
            here.adjoin(FIELD * (len(x.names) + k), h, self.images, y.at[u])
        self.place = [x.coordinates.index(name) for name in y.coordinates]
        self.need_same_functions()
        self.need_same_system()

    def need_same(self, ours, theirs, why):
        self.here.tower.need_zero(self.here.put(ours) - compose(theirs, self.images), why)

    def need_same_functions(self):
        for s in self.y.functions:
            left, right_ = self.x.gradients[self.x.at[s]], self.y.gradients[self.y.at[s]]
            for j, i in enumerate(self.place):
                self.need_same(left.get(i, NOTHING), right_.get(j, NOTHING), "another gradient")
        ours = [self.here.put(f).p.primitive() for f in self.x.relations]
        theirs = [compose(f, self.images).p.primitive() for f in self.y.relations]
        need(all(p in ours or p * -1 in ours for p in theirs), "a relation that the system has not")
        functions = {self.x.at[s] for s in self.y.functions}
        for p in ours:
            need(p in theirs or p * -1 in theirs or not p.variables() & functions or self.holds(p),
                 "a relation does not hold along the curve")

    def holds(self, p):
        """Is it 0 along the curve?"""
        names = [*self.y.coordinates, *self.y.functions, *(x for x in self.target.parameters if x in self.x.at)]
        back, curve = {self.x.at[s]: Function(P({1 << self.y.at[s]: 1})) for s in names}, self.target.curve
        f = compose(Function(p), back)
        return f.p.variables() <= set(curve.known) and not curve.value(f)

    def need_same_system(self):
        x, y = self.x, self.y
        if y.hamiltonian is None:
            for j, f in enumerate(y.field):
                self.need_same(x.field[self.place[j]], f, "another field")
            return
        self.need_same(x.hamiltonian, y.hamiltonian, "another Hamiltonian")
        for i, j in combinations(range(len(self.place)), 2):
            self.need_same(x.brackets.get((self.place[i], self.place[j]), NOTHING), y.brackets.get((i, j), NOTHING),
                           "another bracket")

    # -- what is asked of the parameters, for some values of the levels

    def is_level(self, v):
        return v not in self.images

    def by_levels(self, f):
        """The parts of f by the monomials in the levels, in the names of the family"""
        names = {self.y.at[x] for x in self.target.parameters}
        need(f.variables() <= names, "a condition on the parameters is expected")
        parts = {}
        for k, c in f.items():
            level = sum((k >> v & MASK) << v for v in names if self.is_level(v))
            parts.setdefault(level, []).append((k - level, c))
        need(len(parts) <= PARTS, "a limit: too many monomials in the levels")
        order = sorted(parts, key=lambda k: [k >> v & MASK for v in sorted(names)])
        return {level: compose(Function(P(parts[level])), self.images).p for level in order} or {0: P()}

    def need_asked(self, rows):
        rows, bounded, given = iter(rows), set(), self.here.given
        for f, says in self.target.conditions:
            if says == "real":
                used = set().union(*(self.images[v].p.variables() for v in f.p.variables() if not self.is_level(v)))
                need(used <= given.real, "a parameter that need not be real")
                continue
            used = list(f.p.variables()) if says in SIGNED else []
            if len(used) == 1 and self.is_level(used[0]):
                need(f.p.degree(used[0]) == 1, "a condition on a level")
                need(used[0] not in bounded, "two conditions on a level")
                bounded.add(used[0])
                continue
            by = next(rows, None)
            right(by is not None, "not everything is shown")
            if says in ("some", "nonzero"):
                members = f if says == "some" else [f]
                given.show([part for g in members for part in self.by_levels(g.p).values()], "some", by)
                continue
            parts = self.by_levels(f.p)
            need(list(parts) == [0], "a condition on a level")
            given.show(parts[0], says, by)
        right(next(rows, None) is None, "more is shown than is needed")


def integrability(here, d):
    """First integrals of the family on the stratum, independent and in involution, or commuting with fields: the family, pairs of
    a name and a function, the fields, what is taken on trust"""
    space = here.space
    claims = [(c["name"], space.read(c["value"])) for c in d["claims"]]
    fields = [[space.read(v) for v in row] for row in d["fields"]]
    right(all(len(row) == len(space.coordinates) for row in fields), "an entry for each coordinate is expected")
    slopes = [[space.d(f, j) for j in space.indices] for _, f in claims]
    for df in slopes:
        here.need_zero(here.put(dot(space.field, df)), "not a first integral")
    n, m, not_shown = len(space.coordinates), len(claims), []
    if space.hamiltonian is None:
        need_commuting(here, [space.field, *fields], slopes, fields)
        if m:
            need_minor(here, d["independent"], slopes, m, not_shown, "independence")
        if m == n and not fields:                                               # all points are equilibria
            need(d["rank"] is None, "no rank is asked for")
            return here.family, claims, fields, not_shown
        need(1 + len(fields) + m == n, "not as many integrals as are needed")
        need_minor(here, d["rank"], [space.field, *fields], 1 + len(fields), not_shown, "the rank")
        return here.family, claims, fields, not_shown
    need(not fields, "fields beside a bracket")
    structure = [[space.brackets.get((i, j), NOTHING) for j in space.indices] for i in space.indices]
    for df, dg in combinations(slopes, 2):
        here.need_zero(here.put(dot(df, [dot(row, dg) for row in structure])), "not in involution")
    need_minor(here, d["independent"], slopes, m, not_shown, "independence")
    need(m <= n <= 2 * m, "not as many integrals as are needed")
    need_minor(here, d["rank"], structure, 2 * (n - m), not_shown, "the rank")
    return here.family, claims, [], not_shown


def dot(a, b):
    return total(f * g for f, g in zip(a, b) if f and g)


def need_commuting(here, all_fields, slopes, fields):
    space = here.space
    for y in fields:
        for df in slopes:
            here.need_zero(here.put(dot(y, df)), "not constant along a field")
    for x, y in combinations(all_fields, 2):
        for i in space.indices:
            f, g = (dot(a, [space.d(b[i], j) for j in space.indices]) for a, b in ((x, y), (y, x)))
            here.need_zero(here.put(f - g), "the fields do not commute")


def need_minor(here, v, rows, size, not_shown, what):
    """A minor of this size is not the zero function, at each point of the stratum; or on trust"""
    if v is None:
        not_shown.append(what)
        return
    space = here.space
    d = read({"columns": ["text"], "monomial": ["int"], "value": "text", "by": "any"}, v, "minor")
    columns = d["columns"]
    need(all(x in space.coordinates for x in columns) and len(set(columns)) == len(columns), "a coordinate is expected")
    need(len(columns) == size <= MINOR, "a minor of another size")
    columns = [space.coordinates.index(x) for x in columns]
    chosen = rows if len(rows) == size else [rows[i] for i in columns]
    p = here.norm(here.cleared(determinant([[here.put(row[j]) for j in columns] for row in chosen]).p))
    right(len(d["monomial"]) == len(space.coordinates), "an exponent for each coordinate is expected")
    rest, names, arguments = P(), set(here.family.names.values()), here.arguments()
    for k, c in p.items():
        same = [k >> FIELD * j & MASK == e for j, e in enumerate(d["monomial"])]
        if not all(same[j] or j in arguments for j in range(len(same))):
            continue
        k -= sum((k >> FIELD * j & MASK) << FIELD * j for j in range(len(same)))
        term = P({k: c})
        need(term.variables() <= names, "a name that is not a parameter")
        rest += term if all(same) else P()
    value = parse(d["value"], here.family.names)
    need(ratio(rest, value) not in (None, 0) if value else not rest, "another coefficient")
    here.given.show(value, "nonzero", d["by"])


def determinant(m):
    """By the first row"""
    if not m:
        return Function(ONE)
    terms = [Function(f.p * (-1) ** j, f.n) * determinant([row[:j] + row[j + 1:] for row in m[1:]])
             for j, f in enumerate(m[0]) if f]
    return total(terms)
