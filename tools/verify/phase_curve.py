"""A particular solution as functions of z, and the variational equation along it (docs/theory/system_certificates.md 4, 5):
identities in the algebra R of function_algebra.py."""
from certificate_format import need, right
from function_algebra import FunctionAlgebra
from multivariate import FIELD, ONE, P
from system_format import entries
from tower import Function

ORDER, DERIVATIVES = 8, 5000                # of a function: the highest order, and how many of one order


class PhaseCurve:
    """known: {variable: {1: value}} for the names of phase space that have one; field: X_j; time: dt/dz"""

    def __init__(self, space, curve, parameters):
        self.space, self.R = space, FunctionAlgebra(curve, parameters)
        self.variable, self.parameters = curve["variable"], parameters
        known = [*space.coordinates, *space.functions, *space.inverses]
        self.values = entries(curve["values"], known, "values")
        self.known = {space.at[x]: {1: self.R.read(v)} for x, v in self.values.items()}
        for x in parameters:
            self.known[space.at[x]] = {1: self.R.name(self.R.names[x])}
        self.time = self.R.read(curve["time"])
        self.field = [self.value(f) for f in space.field]
        self.equations, self.levels = ([space.read(v) for v in curve[key]] for key in ("equations", "levels"))
        self.change = space.read(curve["change"])
        self.need_solution()
        self.need_functions()

    def has(self, x):
        return self.space.at[x] in self.known

    def value(self, f):
        """f(x), refused if it has a name without a value"""
        return self.R.put_in(f.p, f.n, self.known)

    def along(self, gradient):
        """The sum of g_j(x) X_j(x)"""
        return self.R.sum(self.value(g) * self.field[j] for j, g in gradient.items() if g)

    def need_solution(self):
        """(C4), (C5): a solution of x' = X(x) on which z = phi(x), so that it is not constant"""
        space = self.space
        for f in space.relations:
            need(not self.value(f), "a relation does not hold along the curve")
        for u, h in space.denominators.items():
            need(u in self.known, "an inverse has no value")
            need(not self.known[u][1] * self.value(h) - self.R.one, "an inverse has another value")
        for j, x in enumerate(space.coordinates):
            if self.has(x):
                need(not self.known[FIELD * j][1].derivative() - self.time * self.field[j], f"{x[:60]} is not a solution")
        for s, gradient in space.gradients.items():
            if s in self.known:
                moved = self.known[s][1].derivative() - self.time * self.along(gradient)
                need(not moved, f"{space.names[s // FIELD][:60]} does not move as its gradient says")
        need(not self.value(self.change) - self.R.z, "the change of variable is not z")
        for f in (*self.equations, *self.levels):
            need(not self.value(f), "an equation or a level does not hold along the curve")

    # -- no function is a constant in disguise (C7)

    def need_functions(self):
        space = self.space
        self.fixed = space.algebraic({space.at[x] for x in (*space.coordinates, *self.parameters)}, self.is_unit)
        for s, gradient in space.gradients.items():
            name, slopes = space.names[s // FIELD][:60], {j: g for j, g in gradient.items() if g}
            need(slopes or s in self.fixed, f"{name} is a constant that no relation fixes")
            need(s in self.fixed or s not in self.known or self.moves(slopes) or self.moves(slopes, True),
                 f"{name} has the value of a constant: no derivative has an inverse along the curve")
        shown = set().union(*(self.R.names_in(self.values[x]) for x in self.seen_by_functions()))
        for x in shown & {*space.coordinates, *space.functions}:
            itself = not self.known[space.at[x]][1] - self.R.read(x) if self.has(x) else x == self.variable
            need(itself, f"{x[:60]} is a name of the tower and another one of the system")

    def is_unit(self, f):
        return f.p.variables() <= set(self.known) and self.R.is_unit(self.R.norm(self.value(f)))

    def moves(self, slopes, divided=False):
        """At each point at which a gradient is not 0 a derivative of the function has an inverse; divided: the entries and what is
        derived from them are divided by the factor of the entry that has no functions in it, which is not 0 where the entry is not."""
        factors, left = {j: [self.value(Function(self.content(g, True)[0])).p] for j, g in slopes.items()}, set(slopes)
        content = {j: self.content(g)[0] if divided else ONE for j, g in slopes.items()}

        def without(j, f):
            c, h = self.content(f)
            return h if content[j].constant() is None and c in (content[j], content[j] * -1) else f
        layers = [(j, 0, without(j, g)) for j, g in slopes.items()]
        for _ in range(ORDER):
            for first, _, f in layers:
                if f.p.variables() <= set(self.known):
                    norm = self.R.norm(self.value(f))
                    if content[first].constant() is not None and self.R.is_unit(norm):
                        return True
                    if first in left and self.R.is_unit(norm, factors[first]):
                        left.remove(first)
            if not left:
                return True
            layers = [(first, j, without(first, df)) for first, i, f in layers for j in self.space.indices[i:]
                      if (df := self.space.d(f, j))]
            need(len(layers) <= DERIVATIVES, "a limit: too many derivatives of a function")
        return False

    def content(self, f, constant=False):
        """c, h with f = c h up to a number, c of coordinates and parameters (constant: of parameters), h without them; (1, f) if there
        are none"""
        low, high = FIELD * len(self.space.coordinates), FIELD * (len(self.space.names) - len(self.parameters))
        parts = f.p.parts((1 << high) - (1 if constant else 1 << low))
        c = next(iter(parts.values())).primitive()
        if any(g.primitive() not in (c, c * -1) for g in parts.values()):
            return ONE, f
        return c, Function(P((k, g[max(g)] // c[max(c)]) for k, g in parts.items()))

    def seen_by_functions(self, fixed=True):
        """The functions that have a value (fixed: the fixed ones, too), and the coordinates with a value on which they depend"""
        found = [s for s in self.space.gradients if s in self.known and (fixed or s not in self.fixed)]
        seen = {*found, *(x for s in found for x in self.space.arguments(s))} & set(self.known)
        return [x for x in self.space.names if self.space.at[x] in seen]

    def chosen_by_functions(self):
        """The names in the values of those that are not fixed"""
        return set().union(*(self.R.names_in(self.values[x]) for x in self.seen_by_functions(False)))

    def moving(self):
        """What is left out and not seen to be constant along the curve (7)"""
        space = self.space
        found = [x for j, x in enumerate(space.coordinates) if not self.has(x) and self.field[j]]
        for x in space.functions:
            gradient = space.gradients[space.at[x]]
            if not self.has(x) and any(gradient.values()):
                known = all(set(g.p.variables()) <= set(self.known) for g in gradient.values())
                if not known or self.along(gradient):
                    found.append(x)
        return found


class NormalPart:
    """Covectors along the curve: one, with y'' + p y' + q y = 0, or several, with the system of the certificate"""

    def __init__(self, curve, d):
        self.curve, self.R, self.d, n = curve, curve.R, d, len(curve.space.coordinates)
        space = curve.space
        self.J = [[curve.value(space.d(f, k)) for k in range(n)] for f in space.field]
        self.annihilators = [self.R.row(a["row"], n) for a in d["annihilators"]]
        for row, a in zip(self.annihilators, d["annihilators"]):    # (N1)
            self.need_combination(self.nabla(row), a["matrix"], "an annihilator is none")

    def need_equation(self, inner):
        n = len(self.curve.space.coordinates)
        if inner.rows is None:
            need("row" in self.d, "one row is expected")
            w, p, q = self.R.row(self.d["row"], n), self.R.read(self.d["p"]), self.R.read(self.d["q"])
            first = self.nabla(w)
            left = [a + p * b + q * c for a, b, c in zip(self.nabla(first), first, w)]
            self.need_combination(left, self.d["rest"], "the row does not satisfy the equation")    # (N2)
            self.need_vectors([w, first])
            r = self.R.divided(p * p + p.derivative() * 2 - q * 4, 4)
            need(not r * inner.den - inner.num, "the certificate is about another equation")        # (N4)
            return
        need("rows" in self.d and len(self.d["rows"]) == len(inner.rows), "other rows are expected")
        right(len(self.d["rest"]) == len(self.d["rows"]), "as many lists as rows are expected")
        rows = [self.R.row(v, n) for v in self.d["rows"]]
        for w, rest, (den, nums) in zip(rows, self.d["rest"], inner.rows):                          # (N5)
            left = [x * den - self.R.dot(nums, column) for x, *column in zip(self.nabla(w), *rows)]
            self.need_combination(left, rest, "the rows do not satisfy the system")
        self.need_vectors(rows)

    def need_vectors(self, rows):
        """(N3)"""
        right(len(self.d["vectors"]) == len(rows), "as many vectors as rows are expected")
        for i, v in enumerate(self.d["vectors"]):
            b = self.tangent(self.R.row(v, len(self.curve.space.coordinates)))
            seen = [self.R.dot(a, b) for a in (*self.annihilators, *rows)]
            wanted = [0] * len(self.annihilators) + [int(i == j) for j in range(len(rows))]
            need(not any(x - self.R.one * c if c else x for x, c in zip(seen, wanted)), "a vector does not show the block")

    def nabla(self, a):
        """D a + T a J"""
        columns = zip(*self.J)
        return [x.derivative() + self.curve.time * self.R.dot(a, column) for x, column in zip(a, columns)]

    def need_combination(self, left, coefficients, why):
        coefficients = self.R.row(coefficients, len(self.annihilators))
        for k, x in enumerate(left):
            need(not x - self.R.dot(coefficients, [row[k] for row in self.annihilators]), why)

    def tangent(self, a):
        """P(x) a, tangent to the symplectic leaf; without a bracket, or on the whole manifold, a itself"""
        if self.curve.space.brackets is None or self.d.get("whole"):
            return a
        b = [self.R.sum([])] * len(a)
        for (j, k), f in self.curve.space.brackets.items():
            b[j] = b[j] + self.curve.value(f) * a[k] if f else b[j]             # each entry has a value there
        return b
