"""Reads kovacic-jets/1 (docs/theory/jet_certificates.md 2), and says what is stated (5): syntax, types and sizes; nothing is
judged here."""
from certificate_format import NAME, read, right
from multivariate import FIELD
from statement import quoted
from system_format import COORDINATES, DENOMINATORS, TOWER, fraction
from system_statement import Elements, function
from tower import Function

FORMAT = "kovacic-jets/1"
PARAMETERS, TURNS, ORDER, TERMS, DEGREE, POWER, COFACTOR = 6, 100, 12, 2000, 40, 20, 100
GROUPS = {"first-family": {}, "homogeneous": {}, "equilibria": {"first": ["any"], "second": ["any"]},
          "group": {"e": "rational", "first": ["any"], "second": ["any"], "certificate": "any"}}
LINE = dict.fromkeys(("start", "across", "along", "masses", "inertias"), ["any"])
TOP = {"format": "text", "title": "text", "parameters": ["text"], "variables": ["text"],
       "system": {"coordinates": ["text"], "momenta": ["text"], "hamiltonian": "any"},
       "denominators": ["text"], "constants": [{"name": "text", "degree": "int", "value": "any"}], "line": LINE,
       "place": {"turns": "int", "time_scale": "any", "solution": "any", "normal": ["any"]},
       "jets": {"order": "int", "across": ["any"], "along": ["any"], "form": "any"},
       "obstruction": {"columns": ["int"], "cofactor": "any", "value": "any", "power": "int"}, "group": {"by": GROUPS}}
SERIES = {"low": "int", "terms": ["any"]}
GROUP = {"first-family": "the normal equation of the highest terms is in the first family",
         "homogeneous": "the normal equation is homogeneous and in the first family",
         "equilibria": "the exponents at the equilibria are not all rational",
         "group": "the group of the normal equation is infinite:"}


def read_jets(top):
    """The certificate, with its names and numbers in their limits; a series is (low, terms) or None."""
    d = read(TOP, top, "certificate")
    system, place, jets, constants = d["system"], d["place"], d["jets"], [x["name"] for x in d["constants"]]
    right(len(d["parameters"]) <= PARAMETERS and len(constants) <= TOWER, "too many names")
    right(len(d["variables"]) == 3 and 2 <= len(system["coordinates"]) == len(system["momenta"]) <= COORDINATES // 2,
          "another number of names")
    for names in ([*d["variables"], *d["parameters"], *constants],
                  [*system["coordinates"], *system["momenta"], *d["parameters"], *constants]):
        right(all(map(NAME.match, names)) and len(set(names)) == len(names), "different names are expected")
    right(all(2 <= x["degree"] <= 64 for x in d["constants"]), "a degree from 2 to 64")
    right(len(d["denominators"]) <= DENOMINATORS, "too many denominators")
    right(all(len(x) == 2 for x in d["line"].values()) and len(place["normal"]) == 2, "pairs are expected")
    right(1 <= place["turns"] <= TURNS and 2 <= jets["order"] <= ORDER, "a number is out of range")
    right(len(jets["across"]) == len(jets["along"]) == jets["order"] - 2, "one for each lower order")
    right(all(0 <= x <= ORDER + 1 for x in d["obstruction"]["columns"]), "a column is out of range")
    right(1 <= d["obstruction"]["power"] <= POWER, "a power is out of range")
    right(all(len(d["group"].get(x) or []) <= COFACTOR for x in ("first", "second")), "too many entries")
    place["solution"], place["normal"] = series(place["solution"]), [series(x) for x in place["normal"]]
    for key in ("across", "along"):
        jets[key] = [series(x) for x in jets[key]]
    return d


def series(v):
    if v is None:
        return None
    x = read(SERIES, v, "series")
    right(abs(x["low"]) <= TERMS and len(x["terms"]) <= TERMS, "a series is too long")
    return x["low"], x["terms"]


def hamiltonian(d):
    """A polynomial in coordinates, momenta, parameters and constants, and the number it is divided by."""
    names = [*d["system"]["coordinates"], *d["system"]["momenta"], *d["parameters"], *(x["name"] for x in d["constants"])]
    return *fraction(d["system"]["hamiltonian"], {x: FIELD * i for i, x in enumerate(names)})[:2], names


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
