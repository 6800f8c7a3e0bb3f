"""The rule `integrable`: enough first integrals of a family on a stratum (docs/theory/theorem_certificates.md 13)."""
from itertools import combinations
from math import lcm

from certificate_format import COND, need, read, right
from core import Said
from multivariate import FIELD, MASK, ONE, P, determinant, pseudo_remainder, resultant
from phase_space import NOTHING, total

MINOR = 8
DATA = {"columns": ["text"], "monomial": ["int"], "value": "text", "by": "any"}
FIELDS = {"system": "text", "at": [["text", "any"]], "region": [COND], "claims": [{"name": "text", "value": "any"}],
          "fields": [["any"]], "independent": "any", "rank": "any"}


def monic(rows, among=None):
    """{v: the first of the polynomials whose last variable (among these) is v, with a number as its leading coefficient in it}"""
    found = {}
    for p in rows:
        v = max(p.variables() if among is None else p.variables() & among, default=None)
        if v is not None and p.lead(v).constant() is not None:
            found.setdefault(v, p)
    return found


def dot(a, b):
    return total(f * g for f, g in zip(a, b) if f and g)


class Integrable:
    """First integrals (pairs of a name and a function), independent and in involution, or commuting with fields; not_shown: what is
    taken on trust"""

    def __init__(self, here, d):
        space = self.space = here.space
        self.here, self.not_shown = here, []
        self.relations = monic((here.put(r).p for r in space.relations), {space.at[s] for s in space.functions})
        self.equations = monic(g for g, says in here.given.conditions if says == "zero")
        self.claims = [(c["name"], space.read(c["value"])) for c in d["claims"]]
        self.fields = [[space.read(v) for v in row] for row in d["fields"]]
        right(all(len(row) == len(space.coordinates) for row in self.fields), "an entry for each coordinate is expected")
        slopes = [[space.d(f, j) for j in space.indices] for _, f in self.claims]
        for df in slopes:
            self.need_zero(dot(space.field, df), "not a first integral")
        (self.by_fields if space.hamiltonian is None else self.by_bracket)(d, slopes, len(slopes), len(space.coordinates))

    def by_bracket(self, d, slopes, m, n):
        need(not self.fields, "fields beside a bracket")
        structure = [[self.space.brackets.get((i, j), NOTHING) for j in self.space.indices] for i in self.space.indices]
        for df, dg in combinations(slopes, 2):
            self.need_zero(dot(df, [dot(row, dg) for row in structure]), "not in involution")
        self.need_minor(d["independent"], slopes, m, "independence")
        need(m <= n <= 2 * m, "not as many integrals as are needed")
        self.need_minor(d["rank"], structure, 2 * (n - m), "the rank")

    def by_fields(self, d, slopes, m, n):
        space, rows = self.space, [self.space.field, *self.fields]
        for y in self.fields:
            for df in slopes:
                self.need_zero(dot(y, df), "not constant along a field")
        for x, y in combinations(rows, 2):
            for i in space.indices:
                f, g = (dot(a, [space.d(b[i], j) for j in space.indices]) for a, b in ((x, y), (y, x)))
                self.need_zero(f - g, "the fields do not commute")
        if m or d["independent"] is not None:
            self.need_minor(d["independent"], slopes, m, "independence")
        if m == n and not self.fields:                                          # all points are equilibria
            need(d["rank"] is None, "no rank is asked for")
            return
        need(len(rows) + m == n, "not as many integrals as are needed")
        self.need_minor(d["rank"], rows, len(rows), "the rank")

    def need_zero(self, f, why):
        """Cleared to 0 modulo relations, from the last function to the first, and equations of the stratum, from the last parameter"""
        p = self.here.tower.cleared(self.here.put(f).p)
        for rows in (self.relations, self.equations):
            for v in sorted(rows, reverse=True):
                p = pseudo_remainder(p, rows[v], v)
        need(not p, why)

    def need_minor(self, v, rows, size, what):
        """A minor of this size is not the zero function, at each point of the stratum; or on trust"""
        if v is None:
            self.not_shown.append(what)
            return
        space, d, given = self.space, read(DATA, v, "minor"), self.here.family.names
        columns = d["columns"]
        need(all(x in space.coordinates for x in columns) and len(set(columns)) == len(columns), "a coordinate is expected")
        need(len(columns) == size <= MINOR, "a minor of another size")
        columns = [space.coordinates.index(x) for x in columns]
        rows = [[self.here.put(row[j]) for j in columns] for row in (rows if len(rows) == size else [rows[i] for i in columns])]
        over = [lcm(*(f.n for f in row)) for row in rows]               # the minor is taken times their product
        p = self.here.tower.cleared(determinant([[f.p * (n // f.n) for f in row] for row, n in zip(rows, over)]) if rows else ONE)
        for x in sorted(self.relations, reverse=True):      # for all branches; other functions stay
            p = resultant(self.relations[x], p, x)
        right(len(d["monomial"]) == len(space.coordinates), "an exponent for each coordinate is expected")
        rest, arguments = P(), {j for gradient in space.gradients.values() for j in gradient}
        for k, c in p.items():
            same = [k >> FIELD * j & MASK == e for j, e in enumerate(d["monomial"])]
            if not all(same[j] or j in arguments for j in space.indices):
                continue
            k -= sum((k >> FIELD * j & MASK) << FIELD * j for j in space.indices)
            need(P({k: c}).variables() <= set(given.values()), "a name that is not a parameter")
            rest += P({k: c}) if all(same) else P()
        self.here.given.show(self.here.multiple(rest, d["value"]), "nonzero", d["by"])


def said(theorem, d):
    here = theorem.here(d)
    shown = Integrable(here, d)
    return Said("J", here.family, [here.conditions()], (), [(here.family, shown.claims, shown.fields, shown.not_shown)], (),
                [(d["id"], what) for what in shown.not_shown])
