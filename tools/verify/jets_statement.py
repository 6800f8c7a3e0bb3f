"""What a certificate of higher variational equations states, as text (docs/theory/jet_certificates.md 5): lines made from what
was read and from nothing else."""
from jets_format import hamiltonian
from phase_space import Function
from statement import quoted
from system_format import fraction
from system_statement import Elements, function

GROUP = {"first-family": "the normal equation of the highest terms is in the first family",
         "homogeneous": "the normal equation is homogeneous and in the first family",
         "equilibria": "the exponents at the equilibria are not all rational",
         "group": "the group of the normal equation is infinite:"}


class Shown(Elements):
    """The names are shown from the last constant down to the variables."""

    def __init__(self, d, algebra):
        e, *others = d["variables"]
        super().__init__(algebra, [*(x["name"] for x in reversed(d["constants"])), e, *d["parameters"], *others])

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
    yield f"the system {quoted(d['title'])}" + f" with parameters {', '.join(d['parameters'])}" * bool(d["parameters"])
    pairs = zip(d["system"]["coordinates"], d["system"]["momenta"])
    yield "  " + "".join(f"{{{q}, {p}}} = 1, " for q, p in pairs) + "H = " + function(Function(h, n), names)
    yield from (f"  {x['name']}^{x['degree']} = {shown.element(x['value'])}" for x in d["constants"])
    yield f"along the line ({', '.join(names[:2])}) = {shown.pair(line['start'])} + y*{shown.pair(line['along'])}" \
        + "".join(f", {x} = 0" for x in d["system"]["coordinates"][2:])
    yield from exceptions(d, shown)
    yield "is not integrable in Liouville's sense with first integrals that are meromorphic near the phase curve, " \
        f"{level(d, group.energy)} (Morales-Ruiz, Ramis and Simo), as"
    yield f"  VE_{jets.order} has the logarithm R = {shown.element(d['jets']['form'])} at the exponents {jets.rho[0]}, {jets.rho[1]}"
    yield f"  {GROUP[d['group']['by']]}"
    yield from (f"  {x}" for x in group.lines)
