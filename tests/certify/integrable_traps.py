"""Traps of the rule for integrable strata (theorem_certificates.md 13): equations between parameters, and functions in minors."""
import json

from theorems import small
from traps import changed

EMPTY = {"node": "empty", "terms": [["1", "1"]]}


def by_zero(i, factor):
    """1 + factor f_i = 0"""
    return EMPTY | {"zeros": [[str(i), factor]]}


def bundle(functions, hamiltonian, claims, minor, region, parameters=("a",), relations=(), brackets=(("x", "u", "1"), ("y", "v", "1")), at=()):
    """Integrable where the region's equations hold, and nothing is said elsewhere"""
    system = {"coordinates": ["x", "y", "u", "v"], "functions": list(functions), "relations": list(relations),
              "hamiltonian": hamiltonian, "brackets": [list(b) for b in brackets]}
    family = {"name": "F", "parameters": list(parameters), "complex": list(parameters), "system": system, "assumptions": []}
    where = [{"p": p, "sign": "zero"} for p in region]
    rank = {"columns": ["x", "y", "u", "v"], "monomial": ["0"] * 4, "value": "1", "by": by_zero(len(where), "-1")}
    step = {"id": "i", "rule": "integrable", "system": "F", "at": list(at), "region": where, "fields": [], "independent": minor, "rank": rank,
            "claims": [{"name": f"I{k}", "value": f} for k, f in enumerate(claims)]}
    equations = [{"p": f"{x} - {value}", "sign": "zero"} for x, value in at] + where
    open_ = {"id": "o", "rule": "open", "system": "F", "regions": [[{"p": e["p"], "sign": "nonzero"}] for e in equations]}
    shown = [EMPTY | {"terms": [["1", "1", [str(len(equations)), "1"]]], "zeros": [[str(i), "-1"]]} for i in range(len(equations))]
    tree = {"node": "part", "part": "0", "word": [], "shown": shown}
    for i in reversed(range(len(equations))):
        leaf = {"node": "part", "part": "1", "word": [], "region": str(i),
                "shown": [EMPTY | {"terms": [["1", "1", [str(i), "1"]]], "zeros": [[str(i + 1), "-1"]]}]}
        tree = {"node": "zero", "p": equations[i]["p"], "zero": tree, "nonzero": leaf}
    parts = ["i", "o"] if equations else ["i"]
    return {"format": "kovacic-theorem/1", "title": "T", "systems": [family],
            "steps": [step, *([open_] if equations else []),
                      {"id": "main", "rule": "cover", "system": "F", "symmetries": [], "parts": parts, "tree": tree}]}


def minor(columns, monomial, value, by):
    return {"columns": list(columns), "monomial": [str(e) for e in monomial], "value": value, "by": by}


# u and v are integrals of (u^2 + v^2)/2; with a multiple of an equation they are so where it holds
H = ["u^2 + v^2", "2"]


def with_equations():
    uv = minor("uv", (0, 0, 0, 0), "1", by_zero(1, "-1"))

    def one(claims, region, m=uv, **more):
        return bundle([], H, claims, m, region, **more)
    yield "where a^2 = 2", one(["u + a^2*x - 2*x", "v"], ["a^2 - 2"]), True
    yield "where 3 a^2 = 2", one(["u + 3*a^2*x - 2*x", "v"], ["3*a^2 - 2"]), True
    yield "where -a^2 = 2, a^3", one(["u + a^4*x - 4*x", "v + a^3*y + 2*a*y"], ["-a^2 - 2"]), True
    yield "another constant", one(["u + a^2*x - 3*x", "v"], ["a^2 - 2"]), False
    yield "a multiple of an equation only", one(["u + a*x", "v"], ["a^2 - 2"]), False
    yield "one root of two", one(["u + a*x - x", "v"], ["a^2 - 1"]), False
    yield "everywhere", one(["u + a^2*x - 2*x", "v"], [], minor("uv", (0, 0, 0, 0), "1", by_zero(0, "-1"))), False
    # two equations: a^2 = 2, b = a; the second one is divided first
    two = minor("uv", (0, 0, 0, 0), "1", by_zero(2, "-1"))
    ab = {"parameters": ("a", "b")}
    for region in (["a^2 - 2", "b - a"], ["b - a", "a^2 - 2"]):
        yield f"two equations {region[0]}", one(["u + b^2*x - 2*x", "v"], region, two, **ab), True
        yield f"two equations {region[0]}, a b", one(["u + a*b*x - 2*x", "v + a*y - b*y"], region, two, **ab), True
        yield f"two equations {region[0]}, another", one(["u + a*b*x + 2*x", "v"], region, two, **ab), False
    # a leading coefficient that is not a number, and vanishes somewhere: a b = 0, b^2 = 0 at a = 0 says nothing of b
    yield "a leading coefficient that vanishes", one(["u + b*x", "v"], ["a*b"], **ab), False
    yield "a leading coefficient that may vanish", one(["u + a^2*b*x - b*x", "v"], ["a^2*b - b"], **ab), False
    yield "an equation that is solved", bundle([], H, ["u + a*x - b^2*x", "v"], uv, ["b^2 - 2"], ("a", "b"), at=[["a", "2"]]), True
    yield "an equation that is solved otherwise", bundle([], H, ["u + a*x - b^2*x", "v"], uv, ["b^2 - 2"], ("a", "b"), at=[["a", "3"]]), False
    # in involution and independent on the stratum only
    for region, right in (("a^2 - 2", True), ("a^2 - 3", False)):        # {u + (a^2 - 2) y, v} = a^2 - 2
        yield f"in involution where {region}", bundle([], ["u^2", "2"], ["u + a^2*y - 2*y", "v"], uv, [region]), right
    yield "dependent there", one(["u + v", "u + a^2*v - v"], ["a^2 - 2"], minor("uv", (0, 0, 0, 0), "a^2 - 2", by_zero(0, "1"))), False
    yield "independent there", one(["u + v", "u + a^2*v"], ["a^2 - 2"], minor("uv", (0, 0, 0, 0), "a^2 - 1", EMPTY | {"zeros": [["0", "1"], ["1", "-1"]]})), True


def function(name, gradient, meaning="f"):
    return {"name": name, "meaning": meaning, "gradient": gradient}


def with_functions():
    """H = u^2/2 + f(x) + v^2/2 and u^2/2 + f: the minor of u, v is u v up to the sign, that of x, v is v f' """
    f = [function("f", {"x": "f"})]
    h, g = ["u^2 + v^2 + 2*f", "2"], ["u^2 + 2*f", "2"]
    none = by_zero(0, "1")

    def one(m, functions=f, claims=(h, g), hamiltonian=h, **more):
        return bundle(functions, hamiltonian, claims, m, [], (), **more)
    yield "no function beside u v", one(minor("uv", (0, 0, 1, 1), "-1", none)), True
    yield "another value", one(minor("uv", (0, 0, 1, 1), "1", by_zero(0, "-1"))), True
    yield "a value that is 0", one(minor("uv", (0, 0, 1, 1), "0", none)), False
    yield "another monomial", one(minor("uv", (0, 0, 2, 1), "-1", none)), False
    yield "a function beside v", one(minor("xv", (0, 0, 0, 1), "-1", none)), False
    yield "a power of x beside a function", one(minor("xv", (1, 0, 0, 1), "-1", none)), False
    # f is y in disguise if its gradient may be 1: y - f is constant, and the minor of these two vanishes
    y = [function("f", {"y": "1"})]
    k = ["u^2 + v^2", "2"]
    exact = by_zero(0, "-1")
    yield "a function that is a coordinate", one(minor("uv", (0, 1, 0, 0), "1", exact), y, ["u*y - u*f", "v"], k), False
    yield "the same beside u", one(minor("uv", (0, 1, 0, 0), "1", exact), y, [["v^2", "2"], "u*y - u*f + v^2"], k), False
    yield "the same beside another power", one(minor("uv", (0, 0, 0, 0), "1", exact), y, ["u", "v + u^2*y - u^2*f"], k), True
    # with a relation that is monic: it is put in before the minor is looked at
    root = [function("f", {"x": ["f", "2"]})]
    yield "a root", one(minor("uv", (0, 0, 2, 2), "1", exact), [function("f", {})], ["u + f*v", "v"], k, relations=["f^2 - 2"]), False
    yield "a root that is a constant", one(minor("uv", (0, 0, 0, 0), "1", exact), [function("f", {})], ["u + f*v", "v"], k, relations=["f^2 - 2"]), True
    yield "a root as a factor", one(minor("uv", (0, 0, 0, 0), "2", {"node": "empty", "terms": [["2", "1"]], "zeros": [["0", "-1"]]}), [function("f", {})], ["u", "f*v"], k, relations=["f^2 - 2"]), True
    yield "a function without a relation as a factor", one(minor("uv", (0, 0, 0, 0), "1", exact), root, ["u", "f*v"], k), False
    yield "a constant without a relation", one(minor("uv", (0, 0, 0, 0), "1", exact), [function("f", {})], ["u", "v"], k, relations=()), False
    yield "a root that is not there", one(minor("uv", (0, 0, 1, 0), "1", exact), [function("f", {})], ["u^2", "v"], k, relations=["f^2 - 2"]), True
    # 2 v^2 - 2 f u^2, where f is some constant; and 2 a u + 1 beside a function of u
    yield "a root of a root", one(minor("uv", (0, 0, 0, 0), "1", exact), [function("f", {}), function("g", {})], ["u", "v*g"], k, relations=["f^2 - 2", "g^2 - f"]), True
    yield "a function at another monomial", one(minor("xv", (0, 0, 0, 1), "1", exact), f, ["x", "v^2 + v*f"], "v"), True
    yield "another power of an argument", bundle([function("f", {"u": "f"})], k, ["u^2*a + u", "v"], minor("uv", (0, 0, 0, 0), "1", exact), []), True
    yield "different denominators", one(minor("uv", (0, 0, 0, 0), "1", exact), [], [["3*u + 2*v", "6"], "v"], k), True
    yield "an exponent more", one(minor("uv", (0, 0, 0, 0, 0), "1", exact), [], ["u", "v"], k), False


def plain(coordinates, claims, independent, rank, fields=(), parameters=(), assumptions=(), tree=None, real=(), **system):
    """One step for all parameters; independent, rank: (columns, monomial) of a minor with a coefficient that is a number"""
    def shown(v):
        return v and minor(v[0], v[1], "1", by_zero(len(assumptions), "-1"))
    family = {"name": "F", "parameters": list(parameters), "complex": [x for x in parameters if x not in real], "assumptions": list(assumptions),
              "system": {"coordinates": list(coordinates)} | system}
    step = {"id": "i", "rule": "integrable", "system": "F", "at": [], "region": [], "fields": [list(row) for row in fields],
            "claims": [{"name": f"I{k}", "value": f} for k, f in enumerate(claims)], "independent": shown(independent), "rank": shown(rank)}
    return {"format": "kovacic-theorem/1", "title": "T", "systems": [family], "steps": [step, {
        "id": "main", "rule": "cover", "system": "F", "symmetries": [], "parts": ["i"],
        "tree": tree or {"node": "part", "part": "0", "word": [], "shown": []}}]}


def by_fields():
    """Commuting fields, the first of them the system, with the integrals of all of them"""
    x, z = ("x", (0, 0, 0)), ("z", (0, 0, 0))

    def three(field, claims, fields, independent, rank):
        return plain("xyz", claims, independent, rank, fields, field=list(field))
    turned = three(("-y", "x", "1"), ["x^2 + y^2"], [("0", "0", "1")], ("x", (1, 0, 0)), ("xz", (0, 1, 0)))
    yield "a rotation", turned, True
    yield "a rotation and what scales", three(("-y", "x", "0"), ["z"], [("x", "y", "0")], z, ("xy", (2, 0, 0))), True
    yield "an entry more", three(("-y", "x", "1"), ["x^2 + y^2"], [("0", "0", "1", "0")], ("x", (1, 0, 0)), ("xz", (0, 1, 0))), False
    yield "not constant along a field", three("001", ["x"], ["100"], x, ("xz", (0, 0, 0))), False
    yield "constant along both", three("001", ["y"], ["100"], ("y", (0, 0, 0)), ("xz", (0, 0, 0))), True
    yield "fields that do not commute", three("001", ["y"], [("z", "0", "0")], ("y", (0, 0, 0)), ("xz", (0, 0, 1))), False
    yield "the same field twice", three("001", ["y"], ["002"], ("y", (0, 0, 0)), ("xz", (0, 0, 0))), False
    yield "one field", plain("xz", ["x"], ("x", (0, 0)), ("z", (0, 0)), field=["0", "1"]), True
    for independent, right in (None, True), (("", (0,)), True), (("x", (0,)), False):
        yield f"the field alone, {independent}", plain("x", [], independent, ("x", (0,)), field=["1"]), right
    for rank in None, z:
        yield f"one integral too few, {rank}", three("001", ["y"], [], ("y", (0, 0, 0)), rank), False
    for second, right in (("w", True), ("2*z", False)):
        yield f"integrals z and {second}", plain("xyzw", ["z", second], ("zw", (0,) * 4), ("xy", (0,) * 4), ["0100"], field=list("1000")), right
    for rank, fields in (None, []), (("x", (0, 0)), []), (None, ["00"]), (("", (0, 0)), []):
        yield f"equilibria, {rank}, {fields}", plain("xy", ["x", "y"], ("xy", (0, 0)), rank, fields, field=["0", "0"]), rank is None and not fields
    yield "on trust", three(("-y", "x", "1"), ["x^2 + y^2"], [("0", "0", "1")], None, None), True


def by_bracket():
    """How many integrals there are, and the rank of the bracket"""
    def free(pairs, claims, independent, rank, h="0", **more):
        names = [x for pair in pairs for x in pair]
        return plain(names, claims, independent, rank, hamiltonian=h, brackets=[[*pair, "1"] for pair in pairs if len(pair) == 2], **more)
    two, three, zeros = ("xu", "yv"), ("xu", "yv", "zw"), (0,) * 6
    yield "two degrees of freedom", free(two, "uv", ("uv", zeros[:4]), ("xuyv", zeros[:4]), "u"), True
    # a/2 - (1/3) (3 a - 6)/2 = 1
    fractions = [["x", "u", ["a", "2"]], ["x", "v", ["1", "3"]], ["y", "u", ["3*a - 6", "2"]], ["y", "v", "1"]]
    yield "brackets with denominators", plain("xyuv", "uv", ("uv", zeros[:4]), ("xyuv", zeros[:4]), (), "a", hamiltonian="u", brackets=fractions), True
    yield "fields beside a bracket", free(two, "uv", ("uv", zeros[:4]), ("xuyv", zeros[:4]), "u", fields=["1000"]), False
    yield "three degrees of freedom", free(three, "uvw", ("uvw", zeros), ("xuyvzw", zeros), "u"), True
    yield "two integrals of three", free(three, "uv", ("uv", zeros), None, "u"), False
    yield "one integral of two", free(two, "u", ("u", zeros[:4]), None, "u"), False
    yield "two integrals of two, on trust", free(two, "uv", ("uv", zeros[:4]), None, "u"), True
    for n, right in (2, True), (3, False):                 # where the bracket is 0
        yield f"no bracket, {n}", free("xyz"[:n], "xy", ("xy", zeros[:n]), ("", zeros[:n])), right
    yield "no bracket, of rank 2", free("xyz", "xy", ("xy", zeros[:3]), ("xy", zeros[:3])), False
    yield "two of three and their bracket", free(("xu", "y"), "uy", ("uy", zeros[:3]), ("xu", zeros[:3])), True


def nowhere():
    """a^2 + 1 = 0 for no real a: it is not positive, not 0 and not negative"""
    where = {"node": "sign", "p": "a", "positive": EMPTY | {"terms": [["1", "1"], ["1", "1", ["1", "2"]]], "zeros": [["0", "-1"]]},
             "zero": EMPTY | {"zeros": [["0", "-1"], ["1", "a"]]}}
    where["negative"] = where["positive"]
    for real in "a", "":
        top = plain("xu", "u", ("u", (0, 0)), ("xu", (0, 0)), (), "a", [{"p": "a^2 + 1", "sign": "zero"}], where, real, hamiltonian="u",
                    brackets=[["x", "u", "1"]])
        yield f"a sign of a, real {real}", top, real == "a"


def of_the_theorem():
    """Two systems of one name, of which a step would mean the last; a map by values that has levels"""
    top = bundle([], H, ["u", "v"], minor("uv", (0, 0, 0, 0), "1", by_zero(0, "-1")), [], ())
    other = changed(top["systems"][0], ["system", "hamiltonian"], "x^2*v^2 + y^3")
    yield "another system of the name", changed(top, ["systems"], [other, *top["systems"]]), False
    yield "another rule", changed(top, ["steps", 0, "rule"], ["integrable"]), False
    yield "values", small(), True
    yield "levels beside values", changed(small(), ["steps", 1, "levels"], []), False


def certificates():
    for name, top, right in (*of_the_theorem(), *with_equations(), *with_functions(), *by_fields(), *by_bracket(), *nowhere()):
        yield f"integrable: {name}", json.dumps(top), right
