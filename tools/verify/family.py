"""Families of systems X(p), with Lagrangians, and what is left of one where some parameters are functions of the others
(docs/theory/theorem_certificates.md 1, 3, 12)."""
from certificate_format import COND, NAME, need, right
from condition import ConditionSet, conditions
from multivariate import FIELD, MASK, P, parse, ratio
from phase_space import Function, PhaseSpace, total
from system_format import PHASE, SYSTEM
from system_statement import function
from tower import Tower, compose, variable

VELOCITY = {"name": "text", "momentum": "text", "value": "any"}
FAMILY = {"name": "text", "parameters": ["text"], "system": SYSTEM, "assumptions": [COND],
          "lagrangian?": {"value": "any", "velocities": [VELOCITY]}, "complex?": ["text"]}


class Lagrangian:
    """(L1) to (L3).  names: of phase space, then the velocities; momenta: the variables of the coordinates dL/dv"""

    def __init__(self, d, space):
        rows = d["velocities"]
        velocities = [row["name"] for row in rows]
        self.names, self.space = [*space.names, *velocities], space
        right(rows and all(map(NAME.match, velocities)) and len(set(self.names)) == len(self.names) <= PHASE,
              "different names are expected")
        at = {x: FIELD * i for i, x in enumerate(self.names)}
        self.speeds = [at[x] for x in velocities]
        self.value = Function.read(d["value"], at)
        right(all(row["momentum"] in space.coordinates for row in rows), "a momentum is not a coordinate")
        self.momenta = [space.at[row["momentum"]] for row in rows]
        need(len(set(self.momenta)) == len(self.momenta), "a momentum occurs twice")
        self.need_quadratic()
        images = {v: variable(v) for v in space.at.values()}
        self.at = images | {v: space.read(row["value"]) for v, row in zip(self.speeds, rows)}
        self.need_legendre()

    def need_quadratic(self):
        for x in self.value.p.variables() - set(self.speeds):
            need(not self.space.arguments(x) & set(self.momenta), "the Lagrangian depends on a momentum")
        degree = max((sum(k >> v & MASK for v in self.speeds) for k in self.value.p), default=0)
        need(degree <= 2, "the Lagrangian is not quadratic in the velocities")

    def need_legendre(self):
        space, pairs = self.space, list(zip(self.speeds, self.momenta))
        for v, m in pairs:
            slope = compose(Function(self.value.p.diff(v), self.value.n), self.at)
            space.need_zero(slope - self.at[m], "a momentum is not the derivative of the Lagrangian")
        energy = total(self.at[m] * self.at[v] for v, m in pairs) - compose(self.value, self.at)
        space.need_zero(energy - space.hamiltonian, "the Hamiltonian is not that of the Lagrangian")

    def line(self):
        slopes = [f"{self.names[m // FIELD]} = dL/d{self.names[v // FIELD]}" for v, m in zip(self.speeds, self.momenta)]
        return f"  H is the energy of the Lagrangian L = {function(self.value, self.names)}, {', '.join(slopes)}"


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


def brackets(space):
    """Those of two coordinates that are not 0, to be compared"""
    return {pair: (f.p, f.n) for pair, f in space.brackets.items() if f}


class Family:
    def __init__(self, d):
        self.name, self.parameters, self.data = d["name"], d["parameters"], d["system"]
        self.space = PhaseSpace(d["system"], d["parameters"])
        self.names = {x: self.space.at[x] for x in self.parameters}
        self.assumptions = self.region(d["assumptions"])
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
        return conditions(rows, lambda text: parse(text, self.names))

    def where(self, given, names=None):
        """The points at which these conditions hold"""
        names = self.names if names is None else names
        return ConditionSet(names, set(names.values()) - self.complex).also(*given)


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


class Here:
    """X where its parameters `at` are these Functions of the others (free), and the conditions of `region` hold.  given: what holds
    there; images: what stands for each name of X in the tower, which has its inverses"""

    def __init__(self, family, at=(), region=()):
        self.family, self.space, self.values, self.region = family, family.space, dict(at), list(region)
        space = self.space
        self.free = {x: v for x, v in family.names.items() if x not in self.values}
        self.images = {v: variable(v) for v in space.at.values()} | {family.names[x]: f for x, f in self.values.items()}
        self.tower = Tower({x: v for x, v in space.at.items() if x not in self.values})
        for u in space.inverses:
            self.images[space.at[u]] = self.tower.invert(space.at[u], self.put(space.denominators[space.at[u]]))
        self.given = family.where([(self.put(Function(f)).p.primitive(), says) for f, says in family.assumptions + self.region], self.free)

    def put(self, f):
        return compose(f, self.images)

    def multiple(self, f, text):
        """The polynomial in the parameters that this text is: a multiple of f by a number other than 0"""
        value = parse(text, self.family.names)
        need(ratio(f, value) not in (None, 0) if value else not f, "another value")
        return value

    def conditions(self):
        """n p - P = 0 for the parameters that are put in, and the region"""
        return [(P({1 << v: self.values[x].n}) - self.values[x].p, "zero")
                for x, v in self.family.names.items() if x in self.values] + self.region
