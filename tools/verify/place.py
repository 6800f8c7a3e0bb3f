"""A system X(p) and the system Y that it is in other coordinates (docs/theory/theorem_certificates.md 4).

A Family is X; a Target is Y with the conditions that its parameters must satisfy."""
from itertools import combinations

from certificate_format import need, read
from condition import ConditionSet, conditions, texts
from legendre import Lagrangian
from multivariate import FIELD, ONE, P, parse
from phase_space import NOTHING, Function, PhaseSpace, total
from statement import polynomial
from system_format import entries, right
from system_statement import function
from theorem_format import CHOSEN, SHOWN, read_adjoined
from tower import Tower, compose

UNIT = Function(ONE)


def uses(space):
    """The names that the Hamiltonian and the brackets, or the field, and what is in them use"""
    used = set()
    left = [f.p for f in space.field] if space.hamiltonian is None else [space.hamiltonian.p, *(f.p for *_, f in space.pairs)]
    while left:
        for x in left.pop().variables() - used:
            used.add(x)
            if x in space.denominators:
                left.append(space.denominators[x].p)
            left += [g.p for g in space.gradients.get(x, {}).values()]
    return used


class Family:
    def __init__(self, d):
        self.name, self.parameters, self.data = d["name"], d["parameters"], d["system"]
        self.space = PhaseSpace(d["system"], d["parameters"])
        self.names = {x: self.space.at[x] for x in self.parameters}
        self.assumptions = conditions(d["assumptions"], self.names)
        given = d.get("lagrangian")
        self.lagrangian = Lagrangian(given, self.space) if given else None
        complex = d.get("complex") or []
        right(len(set(complex)) == len(complex) and set(complex) <= set(self.names), "a parameter is expected")
        self.complex = frozenset(self.names[x] for x in complex)
        need(uses(self.space) >= set(self.space.denominators), "an inverse that is not one of the system")

    def is_plain(self):
        """A Hamiltonian system without functions and relations, with real parameters"""
        return self.space.hamiltonian is not None and not self.space.functions and not self.space.relations and not self.complex

    def region(self, rows):
        return conditions(rows, self.names)

    def where(self, given):
        """The points at which these conditions hold"""
        return ConditionSet(self.names, set(self.names.values()) - self.complex).also(*given)


class Target:
    """conditions: pairs (f, says) of what is to be shown, f a Function of the space, or a list of them; "real" says that the value
    is real; curve: with the values of its functions"""

    def __init__(self, space, parameters, shown, curve=None):
        self.space, self.parameters, self.conditions, self.curve = space, parameters, shown, curve
        self.uses = uses(space)

    def need_no_functions(self):
        need(not any(self.space.at[s] in self.uses for s in self.space.functions), "a function occurs in the system")

    @staticmethod
    def of(family, region, real=True):
        shown = [(Function(parse(x, family.names)), "real") for x in family.parameters] if real else []
        return Target(family.space, family.parameters, shown + [(Function(f), says) for f, says in family.assumptions + region])


def equations(family, at):
    """n p - P = 0 for the parameters that are put in"""
    return [(P({1 << v: at[x].n}) - at[x].p, "zero") for x, v in family.names.items() if x in at]


def without_root(f, sign, v, square):
    """Conditions without the root v of a polynomial that hold only where that of f does, for both of its values"""
    need(square.n == 1, "a number below")
    even, odd = (Tower.even(rows, square) for rows in (f.coefficients(v)[::2], f.coefficients(v)[1::2]))
    if not odd:
        return [(even, sign)]
    need(sign in ("zero", "nonzero"), "a sign that depends on a root")
    return [(even, sign), (odd, sign)] if sign == "zero" else [(even * even - odd * odd * square.p, sign)]


class Map:
    """y = S x + s and the parameters of Y, checked"""

    def __init__(self, family, at, region, target, d):
        self.family, self.target, self.space = family, target, family.space
        target.need_no_functions()
        self.free = {x: v for x, v in family.names.items() if x not in at}
        self.put = {family.names[x]: f for x, f in at.items()} | {v: Function(P({1 << v: 1})) for v in self.free.values()}
        given = [(self.at(Function(f)).p.primitive(), says) for f, says in family.assumptions + region]
        self.given = ConditionSet(self.free).also(*given)
        self.start()
        self.adjoin(d["adjoined"])
        self.read_values(d["values"])
        self.need_change(d["back"])
        self.need_same(*(self.unit(d[key]) for key in ("bracket", "energy")))
        self.need_shown(d["shown"])

    def at(self, f):
        """f of X with the values of `at`"""
        for x in f.p.variables() - set(self.put):
            self.put[x] = Function(P({1 << x: 1}))
        return compose(f, self.put)

    # -- the tower (M1)

    def start(self):
        space, names = self.space, {x: v for x, v in self.space.at.items() if x not in self.family.names}
        self.tower = Tower(names | self.free)
        for u in space.inverses:
            h = self.at(space.denominators[space.at[u]])
            need(h, "a denominator is 0")
            p = h.p.primitive()                                                 # h = c p/n
            self.tower.steps.append((space.at[u], None, p))
            self.put[space.at[u]] = Function(P({1 << space.at[u]: h.n}), h.p[max(p)] // p[max(p)])
        self.constants = set(self.free.values())

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
                h, times, norm = parse(d["inverse"], names), parse(d["times"], names), parse(d["norm"], self.free)
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
        said, where = self.texts((*self.target.space.coordinates, *self.target.parameters))
        return [f"its names: {', '.join(f'{x} = {f}' for x, f in said)}"] * bool(said) + where

    def phi(self, f):
        return compose(f, self.values)

    def before(self, conditions):
        """Conditions of the parameters of Y as conditions of those of X, for each choice of the roots (8)"""
        found = [(self.phi(Function(f)).p, sign) for f, sign in conditions]
        for v, square, _ in reversed(self.tower.steps):
            if square is not None:
                found = [c for f, sign in found for c in without_root(f, sign, v, square)]
        need(all(f.variables() <= set(self.free.values()) for f, _ in found), "a polynomial in the parameters is expected")
        return found

    def row(self, f):
        """S_i1, S_i2, ... of phi(y_i)"""
        rows, coordinates = [NOTHING] * len(self.space.indices), [self.space.at[x] for x in self.space.coordinates]
        rest = f.p
        for j, x in enumerate(coordinates):
            parts = f.p.coefficients(x)
            need(len(parts) <= 2, "the map is not affine")
            if len(parts) == 2:
                rows[j] = self.constant(Function(parts[1], f.n))
                rest = rest - parts[1] * P({1 << x: 1})
        self.affine = self.affine or bool(self.constant(Function(rest)))
        return rows

    def need_change(self, back):
        n, y, self.affine = len(self.space.coordinates), self.target.space, False
        need(n == len(y.coordinates), "another number of coordinates")
        self.S = [self.row(self.values[y.at[x]]) for x in y.coordinates]
        right(len(back) == n and all(len(row) == n for row in back), "a square matrix is expected")
        back = [[self.constant(self.tower.read(v)) for v in row] for row in back]
        for i in range(n):
            for j in range(n):
                f = total(self.S[i][k] * back[k][j] for k in range(n))
                self.tower.need_zero(f - UNIT if i == j else f, "not the inverse matrix")

    def unit(self, pair):
        right(len(pair) == 2, "a number and its inverse are expected")
        c, d = (self.constant(self.tower.read(v)) for v in pair)
        self.tower.need_zero(c * d - UNIT, "not an inverse")
        return c

    # -- the same system (M3)

    def need_same(self, c, k):
        x, y = self.space, self.target.space
        for u, h in y.denominators.items():
            if u in self.target.uses:
                self.tower.need_zero(self.values[u] * self.phi(h) - UNIT, "the value of an inverse is another one")
        self.tower.need_zero(self.at(x.hamiltonian) - k * self.phi(y.hamiltonian), "another Hamiltonian")
        theirs = {(i, j): self.phi(f) for (i, j), f in y.brackets.items()}
        ours = {pair: self.at(f) for pair, f in x.brackets.items()}
        for i, j in combinations(x.indices, 2):
            f = total(self.S[i][a] * self.S[j][b] * g for (a, b), g in ours.items() if self.S[i][a] and self.S[j][b])
            self.tower.need_zero(f - c * theirs.get((i, j), NOTHING), "another bracket")

    def keeps_others(self, names):
        """phi of each coordinate that is not among these contains none of these; both systems call them alike."""
        x = self.space.coordinates
        if x != self.target.space.coordinates or not set(names) <= set(x):
            return False
        return not any(f.p and x[j] in names for i, row in enumerate(self.S) if x[i] not in names for j, f in enumerate(row))

    def need_level(self, f):
        """phi(f) is f or -f, f a function of coordinates of the same names"""
        need(self.space.coordinates == self.target.space.coordinates, "other coordinates")
        y, x = (Function(parse(f, space.at)) for space in (self.target.space, self.space))
        image = self.phi(y)
        need(any(self.tower.is_zero(g.p, len(self.tower.steps)) for g in (image - x, image + x)), "another level")

    # -- what is assumed of the parameters of Y (M4)

    def need_shown(self, rows):
        rows = iter(rows)
        for f, says in self.target.conditions:
            if says == "zero":
                self.tower.need_zero(self.phi(f), "an equation does not hold")
                continue
            d = next(rows, None)
            right(d is not None, "not everything is shown")
            if says == "some":
                self.need_some(f, d)
                continue
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
        right(next(rows, None) is None, "more is shown than is needed")

    def value(self, f, *texts):
        """over and value, of f over^2 = value"""
        over, value = (parse(text, self.free) for text in texts)
        self.tower.need_zero(self.constant(f) * Function(over * over) - Function(value), "another value")
        return over, value

    def need_some(self, members, d):
        """Not all of them are 0: the values would be."""
        d, values = read(CHOSEN, d, "shown"), []
        for v in d["chosen"]:
            i, *pair = texts(3, v, "an index and two polynomials")
            i = read("int", i, "an index")
            right(0 <= i < len(members), "no such member")
            values.append(self.value(self.phi(members[i]), *pair)[1])
        self.given.show(values, "some", d["by"])
