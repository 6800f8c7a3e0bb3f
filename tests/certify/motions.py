"""Certificates of higher variational equations (kovacic-jets/1) that are wrong in one rule of jet_certificates.md 4 and right in all
others, beside some that are right."""
import json

from traps import changed, read


def data(name, *rows):
    """A certificate with changes: a path in one text and a value"""
    top = json.loads(read("data/jets", name + ".json"))
    for path, *value in rows:
        top = changed(top, path.split(), *value)
    return top


def cubic(potential, *rows, kinetic="3*p1^2 + 3*p2^2", over="6"):
    """The right one has 6 H = 6 a q1^3 + 3 q1^2 q2 + 2 q2^3 + 3 p1^2 + 3 p2^2, and only a force of order 2 across the line."""
    return data("cubic", ("system hamiltonian", [f"{potential} + {kinetic}", over]), *rows)


def lines():
    """J1: masses, axes and inertias, and a force that points along the line"""
    plain, twice, half = "6*q1^3*a + 3*q1^2*q2 + 2*q2^3", "24*q1^3*a + 12*q1^2*q2 + 4*q2^3", ["1", "2"]
    heavy = ("line masses 0", "2"), ("line inertias 0", half)
    yield "the mass is 2", cubic(twice, *heavy, kinetic="3*p1^2 + 6*p2^2", over="12"), True
    yield "the mass is 1", cubic(twice, *heavy, kinetic="6*p1^2 + 6*p2^2", over="12"), False
    # x = q1 and y = q2 - q1
    skew = "12*q1^3*a - 8*q1^3 + 12*q1^2*q2 - 6*q1*q2^2 + 2*q2^3"
    yield "axes that are not orthogonal", cubic(skew, ("line across 1", "1"), ("line inertias 0", half)), False
    yield "an inertia across", cubic("6*q1^3*a + 3*q1^2*q2 + 4*q2^3", ("line inertias 0", "2"), kinetic="6*p1^2 + 6*p2^2", over="12"), False
    yield "an inertia along", cubic("6*q1^3*a + 3*q1^2*q2 + q2^3", ("line inertias 1", "2")), False
    yield "a force across the line", cubic(plain + " + q1*q2^2"), False
    for f, right in (("", True), (" + q1*p1^2", False), (" + q2*p2^2", False), (" + q1^2*p2^2", False), (" + p1^2*p2^2", False),
                     (" + p1*p2", False), (" + q2*p1", False), (" + p2^3", False)):
        yield f"kinetic energy{f}", cubic(plain, kinetic="3*p1^2 + 3*p2^2" + f), right


def constants():
    """A constant is free of e, c1 and c2."""
    for value, right in (("a", True), ("e", False), ("c1", False), ("c2", False)):
        yield f"w^2 = {value}", data("cubic", ("constants", [{"name": "w", "degree": "2", "value": value}])), right
    for start, first, right in (("1", "-2", True), ("-1", "0", True), ("e", "-e - 1", False)):
        # q2 = y + start; the solution is that of y + start, less start
        yield f"a line from {start}", data("henon_heiles_number", ("line start 1", start), ("place solution terms 2", first)), right
    for denominator, right in (("a", True), ("a^2 + 1", True), ("c2", False), ("a + e", False)):
        yield f"the denominator {denominator}", data("cubic", ("denominators", [denominator])), right


def times(f, c):
    """A polynomial times a monomial, as texts"""
    return "0" if f == "0" else " ".join(x if x in "+-" else f"{x}*{c}" for x in f.split())


def series():
    """J2 to J4: each series is a solution as far as it is given, and begins with 1."""
    short = [(f"place normal {i} terms", data("cubic")["place"]["normal"][i]["terms"][:-2]) for i in (0, 1)]
    yield "short series", data("cubic", *short), True
    yield "no solution at its end", data("cubic", *short, ("place solution terms 23", "1")), False
    for i in (0, 1):
        yield f"u_{i + 1} is not a solution at its end", data("cubic", (f"place normal {i} terms 23", "1")), False
    terms = ["2", "0", "0", "0", "0", "0", "2*e", "0", "0", "0", "0", "0", ["2*e^2", "13"], "0", "0", "0", "0", "0", ["2*e^3", "247"]]
    for k, form, over, right in ((1, "-18*a*c1^2*c2", "18", True), (2, "-72*a*c1^2*c2", "72", False)):
        v = [x if isinstance(x, list) else [x, "1"] for x in terms]
        v = [[x, str(2 * int(n))] if k == 1 and x != "0" else [x, n] for x, n in v]
        yield f"u_1 begins with {k}", data("cubic", ("place normal 0 terms", v), ("jets form", form),
                                           ("obstruction cofactor", ["-1", over])), right
    yield "a jet along the line is not a solution at its end", data("henon_heiles_number", ("jets along 0 terms 20", "c1^2")), False
    one = data("henon_heiles_number")["place"]["normal"]
    for k, n, c, right in ((0, 8, "c1^2", True), (0, 7, "c1^2", False), (1, 1, "c1*c2", True), (1, 1, "c1", False), (0, 8, "c2^3", False)):
        # c u_k, which solves the equation, and is not a part of the force of order 3; l_2 = 4
        v = [[x, "1"] if isinstance(x, str) else x for x in one[k]["terms"][:n]]
        jet = {"low": one[k]["low"], "terms": [[times(x, c), d] for x, d in v]}
        yield f"{c} u_{k + 1} to {n} terms", data("henon_heiles_number", ("jets across 0", jet)), right
    yield "a jet across the line is not a solution", data("henon_heiles_number", ("jets across 0", {"low": "30", "terms": ["c1^2"]})), False


def residues():
    """J5 and J6: the form, and a minor that is shown not to be 0"""
    for form, right in (("-18*a*c1^2*c2", True), ("-18*a*c1^2*c2 + 1", False), ("-18*a*c1^2*c2 + e", False)):
        yield f"the form {form}", data("cubic", ("jets form", form)), right
    yield "a form of two degrees", data("henon_heiles_number", ("jets form", "12*c1^3*c2 + 1")), False
    for columns, cofactor, value, power, right in (
            ("2", ["-1", "18"], "a", "1", True), ("2", ["-a", "18"], "a", "2", True), ("2", "0", "0", "1", False),
            ("2", ["-c1", "18"], "a*c1", "1", False), ("2", ["-e", "18"], "e*a", "1", True), ("2 3", ["-1", "18"], "a", "1", False),
            ("2", ["-c2", "18"], "a*c2", "1", False)):
        given = {"columns": columns.split(), "cofactor": cofactor, "value": value, "power": power}
        yield f"the entry {given}", data("cubic", ("obstruction", given)), right
    for columns, sign, right in (("2 3 4", "", True), ("3 2 4", "-", False), ("3 4 2", "", False), ("2 3 4 5", "", False)):
        yield f"the columns {columns}", data("henon_heiles_number", ("obstruction columns", columns.split()),
                                             ("obstruction cofactor", [sign + "1", "10368"])), right


def certificates():
    """(name, text, is it right?)"""
    for family in (lines, constants, series, residues):
        for name, top, right in family():
            yield f"{family.__name__}: {name}", json.dumps(top), right
