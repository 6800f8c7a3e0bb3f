"""One transport of facts: a system X(p) is a system Y(q) in other coordinates, at the points p of a stratum of X
(docs/theory/calculus.md 4; docs/theory/theorem_certificates.md 4, 7, 12).  What a map is not known to carry over is refused.

A Map is read from the data of a place or a symmetry, or has the names of X for those of Y: a stratum."""
from itertools import combinations

from certificate_format import need, read, right
from condition import SIGNED
from monomials import parts
from multivariate import FIELD, MASK, ONE, P, parse
from phase_space import NOTHING, Function, total
from statement import polynomial
from system_format import entries
from system_statement import function
from theorem_statement import RIGID
from tower import Tower, compose, variable

SHOWN = {"over": "text", "value": "text", "by": "any", "square?": "true"}
CHOSEN = {"chosen": [["int", "text", "text"]], "by": "any"}
ROOT = {"name": "text", "square": "any"}
INVERSE = {"name": "text", "inverse": "text", "times": "text", "norm": "text", "by": "any"}
MAP = {"adjoined": ["any"], "values": "any", "back": [["any"]], "bracket": ["any", "any"], "energy": ["any", "any"],
       "shown": ["any"]}
PARTS, UNIT = 500, Function(ONE)


def read_adjoined(v):
    return read(ROOT if isinstance(v, dict) and "square" in v else INVERSE, v, "adjoined")


def carried(c, map):
    """The class, of the system in other coordinates, as it is named there; what is not known of it is refused (4)."""
    if map.by_name:
        return c
    need(not (c.functions or c.through or c.frame), "a class that speaks of functions, or of coordinates of a frame")
    need(not c.without or map.keeps_others(c.without), "a class without coordinates that the map mixes with others")
    need(c.kind != "real-analytic" or not map.tower.roots, "a real system, and a root")
    need(c.place != "origin" or not map.affine, "the origin moves")
    if c.place == "level":
        map.need_level(RIGID)
    return c


def without_root(f, sign, v, square):
    """Conditions without the root v of a polynomial that hold only where that of f does, for both of its values"""
    need(square.n == 1, "a number below")
    even, odd = (Tower.even(rows, square) for rows in (f.coefficients(v)[::2], f.coefficients(v)[1::2]))
    if not odd:
        return [(even, sign)]
    need(sign in ("zero", "nonzero"), "a sign that depends on a root")
    return [(even, sign), (odd, sign)] if sign == "zero" else [(even * even - odd * odd * square.p, sign)]


class Map:
    """y = S x + s and the parameters of Y, checked.  values: what stands for the names of Y (without some levels, which no value of
    a function depends on); constants: the variables of parameters of X, and what is adjoined to them"""

    def __init__(self, here, target, d):
        self.here, self.family, self.target, self.space = here, here.family, target, here.space
        self.tower, self.given, self.by_name, self.affine = here.tower, here.given, "values" not in d, False
        self.constants, y = set(here.free.values()), target.space
        need(len(self.space.coordinates) == len(y.coordinates), "another number of coordinates")
        need((self.space.hamiltonian is None) == (y.hamiltonian is None), "a bracket, or none")
        if self.by_name:
            self.read_names(d["levels"])
            self.S, c, k = [self.row(self.values[y.at[x]]) for x in y.coordinates], UNIT, UNIT
            self.need_same_functions()
        else:
            target.need_no_functions()
            self.adjoin(d["adjoined"])
            self.read_values(d["values"])
            self.S = [self.row(self.values[y.at[x]]) for x in y.coordinates]
            self.need_inverse(d["back"])
            c, k = (self.unit(d[key]) for key in ("bracket", "energy"))
        self.need_same(c, k)
        self.need_shown(d["shown"])

    # -- adjoined names (M1)

    def adjoin(self, rows):
        for v in rows:
            d = read_adjoined(v)
            right(d["name"] not in self.space.at, "another name is expected")
            names = {x: k for x, k in self.tower.names.items() if k in self.constants}
            if "square" in d:
                square = self.tower.read(d["square"])
                need(square.p.variables() <= self.constants, "a root of what is not constant")
                self.tower.adjoin(d["name"], square=square)
            else:
                h, times, norm = parse(d["inverse"], names), parse(d["times"], names), parse(d["norm"], self.here.free)
                need(h, "the inverse of 0")
                self.tower.need_zero(Function(h * times - norm), "the norm is another one")
                self.given.show(norm, "nonzero", d["by"])
                self.tower.adjoin(d["name"], h=h)
            self.constants.add(self.tower.names[d["name"]])

    # -- the change of variables (M2)

    def constant(self, f):
        need(f.p.variables() <= self.constants, "not a function of the parameters")
        return f

    def read_values(self, values):
        y = self.target.space
        wanted = [*y.coordinates, *self.target.parameters, *(u for u in y.inverses if y.at[u] in self.target.uses)]
        entries(values, wanted, "values")
        right(len(values) == len(wanted), "a value is missing")
        self.values = {y.at[x]: self.tower.read(v) for x, v in values.items()}
        for x in self.target.parameters:
            self.constant(self.values[y.at[x]])

    def read_names(self, levels):
        """The names of Y are those of X, or levels, which some values are put to; its inverses stand beside those of X."""
        x, y, curve = self.space, self.target.space, self.target.curve
        for names, known in ((y.coordinates, x.coordinates), (y.functions, x.functions)):
            need(set(names) <= set(known), "the system has another name")
        self.values = {y.at[name]: variable(x.at[name]) for name in (*y.coordinates, *y.functions)}
        need(not set(levels) & set(x.at) and set(levels) <= set(self.target.parameters), "a level is expected")
        self.levels, chosen = levels, curve.chosen_by_functions() if curve else ()
        for name in self.target.parameters:
            need(name not in x.at or name in self.here.free, "a parameter that has a value")
            need(name in x.at or name not in chosen, "a level in the value of a function, or of what it depends on")
            if name in x.at or name in levels:
                self.values[y.at[name]] = levels[name] if name in levels else variable(x.at[name])
        for u in y.inverses:
            self.values[y.at[u]] = self.tower.invert(self.tower.above(), self.phi(y.denominators[y.at[u]]))

    def phi(self, f):
        return compose(f, self.values)

    def row(self, f):
        """{j: S_ij} of phi(y_i)"""
        row, rest = {}, f.p
        for j in self.space.indices:
            parts = f.p.coefficients(FIELD * j)
            need(len(parts) <= 2, "the map is not affine")
            if len(parts) == 2:
                row[j] = self.constant(Function(parts[1], f.n))
                rest = rest - parts[1] * P({1 << FIELD * j: 1})
        self.affine = self.affine or bool(self.constant(Function(rest)))
        return row

    def need_inverse(self, back):
        n = len(self.S)
        right(len(back) == n and all(len(row) == n for row in back), "a square matrix is expected")
        back = [[self.constant(self.tower.read(v)) for v in row] for row in back]
        for i, row in enumerate(self.S):
            for j in range(n):
                f = total(s * back[k][j] for k, s in row.items())
                self.tower.need_zero(f - UNIT if i == j else f, "not the inverse matrix")

    def unit(self, pair):
        c, d = (self.constant(self.tower.read(v)) for v in pair)            # a number and its inverse
        self.tower.need_zero(c * d - UNIT, "not an inverse")
        return c

    # -- the same system (M3, T1)

    def need_same(self, c, k):
        x, y, put = self.space, self.target.space, self.here.put
        for u, h in y.denominators.items():
            if u in self.values:
                self.tower.need_zero(self.values[u] * self.phi(h) - UNIT, "the value of an inverse is another one")
        if y.hamiltonian is None:
            for row, f in zip(self.S, y.field):
                self.tower.need_zero(total(s * put(x.field[j]) for j, s in row.items()) - c * k * self.phi(f), "another field")
            return
        self.tower.need_zero(put(x.hamiltonian) - k * self.phi(y.hamiltonian), "another Hamiltonian")
        ours, rows = {pair: put(f) for pair, f in x.brackets.items() if f}, list(enumerate(self.S))
        for (i, left), (j, other) in combinations(rows, 2):
            f = total(s * t * ours[a, b] for a, s in left.items() for b, t in other.items() if (a, b) in ours)
            self.tower.need_zero(f - c * self.phi(y.brackets.get((i, j), NOTHING)), "another bracket")

    def need_same_functions(self):
        x, y, put = self.space, self.target.space, self.here.put
        for s in y.functions:
            ours, theirs = x.gradients[x.at[s]], y.gradients[y.at[s]]
            for j, row in enumerate(self.S):
                f = put(ours.get(next(iter(row)), NOTHING)) - self.phi(theirs.get(j, NOTHING))
                self.tower.need_zero(f, "another gradient")
        ours, theirs = [put(f).p.primitive() for f in x.relations], [self.phi(f).p.primitive() for f in y.relations]
        need(all(p in ours or p * -1 in ours for p in theirs), "a relation that the system has not")
        functions = {x.at[s] for s in y.functions}
        for p in ours:
            need(p in theirs or p * -1 in theirs or not p.variables() & functions or self.holds(p),
                 "a relation does not hold along the curve")

    def holds(self, p):
        """Is it 0 along the curve?"""
        y, curve = self.target.space, self.target.curve
        names = [*y.coordinates, *y.functions, *(x for x in self.target.parameters if x in self.space.at)]
        f = compose(Function(p), {self.space.at[s]: variable(y.at[s]) for s in names})
        return f.p.variables() <= set(curve.known) and not curve.value(f)

    # -- conditions on the parameters of Y (M4, T2)

    def need_shown(self, rows):
        rows, bounded = iter(rows), set()
        for f, says in self.target.conditions:
            if not self.is_plain(f, says, bounded):
                d = next(rows, None)
                right(d is not None, "not everything is shown")
                (self.show_by_name if self.by_name else self.show_some if says == "some" else self.show)(f, says, d)
        right(next(rows, None) is None, "more is shown than is needed")

    def is_plain(self, f, says, bounded):
        """Is nothing to be shown: an equation between values; the value of a level in an interval; what is real by its names?"""
        if says == "zero" and not self.by_name:
            self.tower.need_zero(self.phi(f), "an equation does not hold")
            return True
        if says == "real" and self.by_name:
            used = set().union(*(self.values[v].p.variables() for v in f.p.variables() & set(self.values)))
            need(used <= self.given.real, "a parameter that need not be real")
            return True
        used = list(f.p.variables()) if says in SIGNED else []
        if len(used) != 1 or used[0] in self.values:
            return False
        need(f.p.degree(used[0]) == 1, "a condition on a level")
        need(used[0] not in bounded, "two conditions on a level")
        bounded.add(used[0])
        return True

    def show(self, f, says, d):
        d, f = read(SHOWN, d, "shown"), self.phi(f)
        if d["square"]:
            need(says in ("real", "nonzero"), "a square has no other sign")
            f, says = f * f, "positive" if says == "real" else says
        over, value = self.value(f, d["over"], d["value"])
        if says == "real":
            value, says = over, "nonzero"
        if says == "nonnegative" and not over.constant():
            says = "positive"
        self.given.show(value, says, d["by"])

    def value(self, f, *texts):
        """over and value, of f over^2 = value"""
        over, value = (parse(text, self.here.free) for text in texts)
        self.tower.need_zero(self.constant(f) * Function(over * over) - Function(value), "another value")
        return over, value

    def show_some(self, members, _, d):
        """Not all of them are 0: the values would be."""
        d, values = read(CHOSEN, d, "shown"), []
        for i, *pair in d["chosen"]:
            right(0 <= i < len(members), "no such member")
            values.append(self.value(self.phi(members[i]), *pair)[1])
        self.given.show(values, "some", d["by"])

    def show_by_name(self, f, says, by):
        if says in ("some", "nonzero"):
            self.given.show([part for g in (f if says == "some" else [f]) for part in self.by_levels(g.p)[1]], "some", by)
            return
        levels, coefficients = self.by_levels(f.p)
        need(levels == [0], "a condition on a level")
        self.given.show(coefficients[0], says, by)

    def by_levels(self, f):
        """The monomials in the levels without a value, and the parts of f by them, in the names of X"""
        names = sorted(self.target.space.at[x] for x in self.target.parameters)
        need(f.variables() <= set(names), "a condition on the parameters is expected")
        found = parts(f, [v for v in names if v not in self.values])
        need(len(found) <= PARTS, "a limit: too many monomials in the levels")
        order = sorted(found, key=lambda k: [k >> v & MASK for v in names]) or [0]
        return order, [self.phi(Function(found.get(level, P()))).p for level in order]

    # -- carried over

    def before(self, conditions):
        """Conditions of the parameters of Y as conditions of those of X, for each choice of the roots (8)"""
        found = [(self.phi(Function(f)).p, sign) for f, sign in conditions]
        for v, square, _ in reversed(self.tower.steps):
            if square is not None:
                found = [c for f, sign in found for c in without_root(f, sign, v, square)]
        need(all(f.variables() <= set(self.here.free.values()) for f, _ in found), "a polynomial in the parameters is expected")
        return found

    def keeps_others(self, names):
        """phi of each coordinate that is not among these contains none of these; both systems call them alike."""
        x = self.space.coordinates
        if x != self.target.space.coordinates or not set(names) <= set(x):
            return False
        return not any(x[j] in names for i, row in enumerate(self.S) if x[i] not in names for j in row)

    def need_level(self, f):
        """phi(f) is f or -f, f a function of coordinates of the same names"""
        need(self.space.coordinates == self.target.space.coordinates, "other coordinates")
        y, x = (Function(parse(f, space.at)) for space in (self.target.space, self.space))
        image = self.phi(y)
        need(any(self.tower.is_zero(g.p, len(self.tower.steps)) for g in (image - x, image + x)), "another level")

    # -- as text

    def texts(self, moved):
        """What stands for names of Y, as text, without those that stay; and the adjoined names"""
        t = self.tower
        names = [""] * (max(t.names.values()) // FIELD + 1)
        for x, v in t.names.items():
            names[v // FIELD] = x
        rows = [(x, self.values[self.target.space.at[x]]) for x in moved]
        said = [(x, function(f, names)) for x, f in rows if x not in t.names or f.n != 1 or f.p != {1 << t.names[x]: 1}]
        adjoined = [(names[v // FIELD], square, h) for v, square, h in t.steps if v in self.constants]
        where = [f"{x} = 1/({polynomial(h, names)})" if square is None else f"{x}^2 = {function(square, names)}"
                 for x, square, h in adjoined]
        return said, [f"where {', '.join(where)}"] * bool(where)

    def shown(self):
        """What stands for the names of Y, as text (10); nothing if they are the same"""
        if self.by_name:
            levels = (f"{h} = {function(self.levels[h], self.space.names)}" for h in sorted(self.levels))
            return [f"at {', '.join(levels)}"] * bool(self.levels)
        said, where = self.texts((*self.target.space.coordinates, *self.target.parameters))
        return [f"its names: {', '.join(f'{x} = {f}' for x, f in said)}"] * bool(said) + where
