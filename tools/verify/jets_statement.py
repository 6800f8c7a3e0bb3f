"""What a certificate of higher variational equations states, as text (docs/theory/jet_certificates.md 5): lines made from what
was read and from nothing else."""
from jets_format import hamiltonian
from multivariate import MASK
from statement import joined, polynomial, quoted
from system_format import fraction

GROUP = {"first-family": "the normal equation of the highest terms is in the first family",
         "homogeneous": "the normal equation is homogeneous and in the first family",
         "equilibria": "the exponents at the equilibria are not all rational",
         "group": "the group of the normal equation is infinite:"}


class Shown:
    """The names are shown from the last constant down to the variables."""

    def __init__(self, d, algebra):
        self.R, e = algebra, d["variables"][0]
        self.order = [*(x["name"] for x in reversed(d["constants"])), e, *d["parameters"], *d["variables"][1:]]

    def polynomial(self, p):
        places = [self.R.at[x] for x in self.order]
        return joined(sorted((([k >> x & MASK for x in places], c) for k, c in p.items()), reverse=True), self.order)

    def element(self, v):
        """as it was given"""
        p, n, es = fraction(v, self.R.at, len(self.R.denominators))
        below = [str(n)] * (n != 1)
        below += [f"({self.polynomial(d)})" + f"^{e}" * (e > 1) for d, e in zip(self.R.shown, es) if e]
        return f"({self.polynomial(p)})/({'*'.join(below)})" if below else self.polynomial(p)

    def pair(self, two):
        return f"({self.element(two[0])}, {self.element(two[1])})"


def level(d, energy):
    by = d["group"]["by"]
    return f"at the energy {energy}" if by == "group" else \
        f"for all but {'finitely' if by == 'homogeneous' else 'countably'} many values of the energy"


def exceptions(d, shown):
    for f in shown.R.shown:
        if f.variables():
            yield f"  except where {shown.polynomial(f)} = 0"
    value = fraction(d["obstruction"]["value"], shown.R.at, len(shown.R.denominators))[0]
    if value.variables() & {shown.R.at[x] for x in d["parameters"]}:
        yield f"  except where {shown.polynomial(value)} = 0 for all {d['variables'][0]}"


def statement(d, jets, group):
    shown, (h, n, names), line = Shown(d, jets.R), hamiltonian(d), d["line"]
    text = polynomial(h, names)
    yield f"the system {quoted(d['title'])}" + f" with parameters {', '.join(d['parameters'])}" * bool(d["parameters"])
    pairs = zip(d["system"]["coordinates"], d["system"]["momenta"])
    yield "  " + "".join(f"{{{q}, {p}}} = 1, " for q, p in pairs) + "H = " + (f"({text})/{n}" if n != 1 else text)
    yield from (f"  {x['name']}^{x['degree']} = {shown.element(x['value'])}" for x in d["constants"])
    yield f"along the line ({', '.join(names[:2])}) = {shown.pair(line['start'])} + y*{shown.pair(line['along'])}" \
        + "".join(f", {x} = 0" for x in d["system"]["coordinates"][2:])
    yield from exceptions(d, shown)
    yield "is not integrable in Liouville's sense with first integrals that are meromorphic near the phase curve, " \
        f"{level(d, group.energy)} (Morales-Ruiz, Ramis and Simo), as"
    yield f"  VE_{jets.order} has the logarithm R = {shown.element(d['jets']['form'])} at the exponents {jets.rho[0]}, {jets.rho[1]}"
    yield f"  {GROUP[d['group']['by']]}"
    yield from (f"  {x}" for x in group.lines)
