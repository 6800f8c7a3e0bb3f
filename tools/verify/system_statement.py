"""What a certificate of the whole way states, as text (docs/theory/system_certificates.md 8): lines made from what was read
and from nothing else."""
from first_integrals import casimirs, integrals
from statement import polynomial, quoted
from system_format import fraction

POISSON = "in Liouville's sense with first integrals", "Morales-Ramis"
FIELD = "with first integrals and commuting vector fields", "Ayoul-Zung"


def function(f, names):
    text = polynomial(f.p, names)
    return f"({text})/{f.n}" if f.n != 1 else text


def system_lines(space, system):
    """The bracket and the Hamiltonian, or the field; the functions, the inverses and the relations: a line each"""
    names = space.names
    if space.brackets is None:
        yield ", ".join(f"{x}' = {function(f, names)}" for x, f in zip(space.coordinates, space.field))
    else:
        pairs = [f"{{{space.coordinates[i]}, {space.coordinates[j]}}} = {function(f, names)}" for i, j, f in space.pairs]
        yield ", ".join([*pairs, f"H = {function(space.hamiltonian, names)}"])
    for s in system["functions"]:
        name, gradient = s["name"], space.gradients[space.at[s["name"]]]
        slopes = [f"d{name}/d{space.coordinates[j]} = {function(g, names)}" for j, g in gradient.items() if g]
        yield f"{name} {quoted(s['meaning'])}: {', '.join(slopes) or 'constant'}"
    for u in space.inverses:
        yield f"{u} = 1/({function(space.denominators[space.at[u]], names)})"
    yield from (f"{function(f, names)} = 0" for f in space.relations)


class Elements:
    """Of R as text; order: its names, as they are shown"""

    def __init__(self, algebra, order):
        self.R, self.order = algebra, order

    def polynomial(self, p):
        """in z, the parameters and the tower"""
        return polynomial(p, self.order, [self.R.at[x] for x in self.order])

    def element(self, v):
        """as it was given"""
        p, n, es = fraction(v, self.R.at, len(self.R.denominators))
        below = [str(n)] * (n != 1)
        below += [f"({self.polynomial(d)})" + f"^{e}" * (e > 1) for d, e in zip(self.R.shown, es) if e]
        return f"({self.polynomial(p)})/({'*'.join(below)})" if below else self.polynomial(p)


class Shown(Elements):
    """names: of phase space; those of R are shown from the last of the tower down to the parameters."""

    def __init__(self, curve):
        self.curve, self.space = curve, curve.space
        super().__init__(curve.R, [w["name"] for w in reversed(curve.R.tower)] + list(curve.R.names))

    def function(self, f):
        return function(f, self.space.names)

    def zero(self, fs):
        return ", ".join(f"{self.function(f)} = 0" for f in fs)

    def phase_curve(self, d):
        """Where it lies"""
        change, where = self.function(self.curve.change), self.zero(self.curve.equations)
        line = f"the phase curve with {self.curve.variable} = {change} on {quoted(d['curve']['manifold'])}"
        return line + f": {where}" * bool(where) + f"; levels {self.zero(self.curve.levels)}" * bool(self.curve.levels)

    def values_there(self, names):
        return [f"{x} = {self.element(self.curve.values[x])}" for x in names]

    def functions_there(self, tower=()):
        """The functions meant take these values on the curve, where what they depend on has those"""
        functions, where = ([x for x in self.curve.seen_by_functions() if x in names]
                            for names in (self.space.functions, self.space.coordinates))
        where = [*self.values_there(where), *tower]
        text = f"for functions with {', '.join(self.values_there(functions))} there" + f", where {', '.join(where)}" * bool(where)
        return [text] * bool(functions)

    def functions_explained(self):
        """The same with the names of the tower that are in it; and these names"""
        names = set().union(*(self.R.names_in(self.curve.values[x]) for x in self.curve.seen_by_functions()))
        return self.functions_there([self.step(w) for w in self.R.tower if w["name"] in names]), names

    def step(self, w):
        return f"{w['name']}^{w['degree']} = {self.element(w['value'])}"

    def solution(self, d):
        """The phase curve: where it lies, the values of the functions, and its function field"""
        yield f"along {self.phase_curve(d)}"
        yield from (f"  {line}" for line in self.functions_there())
        yield from (f"  {self.step(w)}" for w in self.R.tower)
        shown = [self.polynomial(p) for p in self.R.shown if p.variables() - {0}]
        yield from (f"  except where {p} = 0 for all {self.curve.variable}" for p in dict.fromkeys(shown))


def statement(d, curve, claims, inner):
    """claims: pairs (claim, its function)"""
    shown, parameters = Shown(curve), d["parameters"]
    lines = [f"the system {quoted(d['title'])}" + f" with parameters {', '.join(parameters)}" * bool(parameters)]
    lines += [f"  {line}" for line in system_lines(curve.space, d["system"])]
    words = {"integral": "first integral", "casimir": "Casimir function"}
    lines += [f"  {words[c['kind']]} {quoted(c['name'])}: {shown.function(f)}" for c, f in claims]
    lines += shown.solution(d)
    if inner.denials:
        objects, theorem = FIELD if curve.space.brackets is None else POISSON
        theorem = FIELD[1] if inner.denials[0].whole else theorem
        there = "".join(f", {text}," for text in shown.functions_there())
        verdict = f"is not integrable{there} {objects} that are {integrals(curve, inner.denials, casimirs(claims)).sentence()} ({theorem})"
        lines.append(verdict + (", as" if d["claim"]["not_integrable"] else " where the identity component is not abelian:"))
    else:
        lines.append("nothing follows from")
    return lines + [f"  {line}" for line in inner.lines]
