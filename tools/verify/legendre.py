"""A Hamiltonian that comes from a Lagrangian (docs/theory/theorem_certificates.md 1, (L1) to (L3))."""
from certificate_format import need, right
from multivariate import FIELD, MASK
from phase_space import Function, total
from strata_format import NAME
from system_format import PHASE
from system_statement import function
from tower import compose, variable


class Lagrangian:
    """names: of phase space, then the velocities; momenta: the variables of the coordinates dL/dv"""

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
        need(not self.value.p.variables() & set(self.momenta), "the Lagrangian depends on a momentum")
        for u, h in self.space.denominators.items():
            need(u not in self.value.p.variables() or not h.p.variables() & set(self.momenta),
                 "the Lagrangian depends on a momentum")
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
