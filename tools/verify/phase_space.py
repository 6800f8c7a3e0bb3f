"""A system: functions on phase space with their derivatives, its bracket and field, and what is claimed of it
(docs/theory/system_certificates.md 3).  All of it are identities between polynomials in the names of phase space."""
from itertools import combinations

from certificate_format import need, right
from multivariate import FIELD, P, spend
from system_format import entries
from tower import NOTHING, Function, Tower, total


class PhaseSpace:
    """names: coordinates, functions, inverses, parameters, in this order; at: their variables.  field: X; brackets: its
    entries by (i, j), or None."""

    def __init__(self, system, parameters):
        self.coordinates, self.functions, self.inverses = (
            system["coordinates"], *([x["name"] for x in system[key]] for key in ("functions", "inverses")))
        self.names = [*self.coordinates, *self.functions, *self.inverses, *parameters]
        self.at = {x: FIELD * i for i, x in enumerate(self.names)}
        self.indices, self.known = range(len(self.coordinates)), {}
        self.denominators = {self.at[x["name"]]: self.denominator(x["of"]) for x in system["inverses"]}
        self.tower = Tower(self.at)
        self.tower.steps = [(u, None, h.p) for u, h in self.denominators.items()]
        self.gradients = {self.at[x["name"]]: self.gradient(x["gradient"]) for x in system["functions"]}
        self.relations = [self.relation(text) for text in system["relations"]]
        self.need_functions()
        self.hamiltonian = self.brackets = None
        if system["field"] is not None:
            right(len(system["field"]) == len(self.coordinates), "the field has another length")
            self.field = [self.read(v) for v in system["field"]]
        else:
            self.hamiltonian, self.pairs = self.read(system["hamiltonian"]), list(map(self.pair, system["brackets"]))
            self.need_bracket()
            slopes = [self.d(self.hamiltonian, j) for j in self.indices]
            self.field = self.brackets_with(slopes)

    # -- functions (S1)

    def read(self, v):
        return Function.read(v, self.at)

    def without_inverses(self, f):
        return not f.p.variables() & {self.at[u] for u in self.inverses}

    def denominator(self, text):
        h = self.read(text)
        need(h and self.without_inverses(h) and h.p.constant() is None, "not the denominator of an inverse")
        return h

    def gradient(self, v):
        entries(v, self.coordinates, "gradient")
        return {self.coordinates.index(x): self.read(f) for x, f in v.items()}

    def relation(self, text):
        f = self.read(text)
        need(self.without_inverses(f), "a relation has an inverse in it")
        return f

    def partial(self, f, x):
        return Function(f.p.diff(x), f.n)

    def d(self, f, j):
        """The derivative by coordinate j"""
        terms = [self.partial(f, FIELD * j)]
        for x in f.p.variables():
            if x in self.gradients and j in self.gradients[x]:
                terms.append(self.partial(f, x) * self.gradients[x][j])
            elif x in self.denominators:
                slope = self.slope(x, j)
                if slope:
                    terms.append(self.partial(f, x) * slope)
        return total(terms)

    def slope(self, u, j):
        """d_j u = -u^2 d_j h"""
        if (u, j) not in self.known:
            self.known[u, j] = Function(P({2 << u: -1})) * self.d(self.denominators[u], j)
        return self.known[u, j]

    def cleared(self, f):
        """f times all the denominators that its inverses need (S3)"""
        return Function(self.tower.cleared(f.p), f.n)

    def need_zero(self, f, why, cofactors=None):
        """f = 0 wherever it is defined: an identity, or a combination of the relations (S3)"""
        if cofactors is not None:
            right(len(cofactors) == len(self.relations), "a cofactor for each relation is expected")
            cofactors = [self.read(c) for c in cofactors]
            need(all(map(self.without_inverses, cofactors)), "a cofactor has an inverse in it")
        f = self.cleared(f)
        need(not f - total(c * g for c, g in zip(cofactors or [], self.relations)), why)

    def need_functions(self):
        """There are functions with these gradients and relations (Frobenius)."""
        used = set().union(*(f.p.variables() for f in self.relations))
        for s, gradient in self.gradients.items():
            need(any(gradient.values()) or s in used, "a constant without a relation is a parameter")
            for i, j in combinations(self.indices, 2):
                cross = [self.d(gradient[b], a) if b in gradient else NOTHING for a, b in ((i, j), (j, i))]
                self.need_zero(cross[0] - cross[1], f"no function has the gradient of {self.names[s // FIELD][:60]}")
        for f in self.relations:
            for j in self.indices:
                self.need_zero(self.d(f, j), "a relation is not preserved")

    def algebraic(self, over, is_unit):
        """These variables and the functions that relations make algebraic over them: one after the other, by a leading
        coefficient that is a unit"""
        found, before = set(over), None
        while found != before:
            before = set(found)
            for f in self.relations:
                new = f.p.variables() - found
                if len(new) == 1 and new <= set(self.gradients) and is_unit(Function(f.p.lead(min(new)))):
                    found |= new
        return found

    def arguments(self, s):
        """The coordinates on which a function depends: those in its gradient, and in those of the functions there"""
        found, left = set(), [s]
        while left:
            x = left.pop()
            if x in found:
                continue
            found.add(x)
            left += self.denominators[x].p.variables() if x in self.denominators else ()
            for j, g in self.gradients.get(x, {}).items():
                left += [FIELD * j, *g.p.variables()] if g else []
        return {x for x in found if x < FIELD * len(self.coordinates)}

    # -- the bracket (S2)

    def pair(self, v):
        right(len(v) == 3 and all(x in self.coordinates for x in v[:2]) and v[0] != v[1],
              "a bracket of two coordinates is expected")
        return (*map(self.coordinates.index, v[:2]), self.read(v[2]))

    def need_bracket(self):
        """A Poisson bracket: Jacobi's identity"""
        self.brackets = {}
        for i, j, f in self.pairs:
            right((i, j) not in self.brackets, "a bracket occurs twice")
            self.brackets[i, j], self.brackets[j, i] = f, NOTHING - f
        rows = {i: [l for l in self.indices if self.brackets.get((i, l))] for i in self.indices}
        slopes = {pair: [self.d(f, l) for l in self.indices] for pair, f in self.brackets.items()}
        for i, j, k in combinations(self.indices, 3):
            spend(100)
            self.need_zero(total(self.brackets[a, l] * slopes[pair][l] for a, pair in ((i, (j, k)), (j, (k, i)), (k, (i, j)))
                                 if pair in slopes for l in rows[a]), "Jacobi's identity does not hold")

    def one_leaf(self):
        """Is it plainly a symplectic bracket?  Pairs of coordinates with constants"""
        seen = sorted(i for pair in self.pairs for i in pair[:2])
        return seen == list(self.indices) and all(f.p.constant() for *_, f in self.pairs)

    def brackets_with(self, slopes):
        """{x_i, f} for all i, from d_j f"""
        return [total(f * slopes[j] for (a, j), f in self.brackets.items() if a == i) for i in self.indices]

    # -- what is claimed (S4)

    def need_claim(self, d):
        f, cofactors = self.read(d["value"]), d["cofactors"]
        slopes = [self.d(f, j) for j in self.indices]
        if d["kind"] == "integral":
            right(cofactors is None or len(cofactors) == 1, "one list of cofactors is expected")
            moved, why = [total(map(Function.__mul__, self.field, slopes))], "not a first integral"
        else:
            need(self.brackets is not None, "a Casimir function needs a bracket")
            right(cofactors is None or len(cofactors) == len(self.indices), "a list of cofactors for each coordinate")
            moved, why = self.brackets_with(slopes), "not a Casimir function"
        for g, row in zip(moved, cofactors or [None] * len(moved)):
            self.need_zero(g, why, row)
        return f
