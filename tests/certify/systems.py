"""Certificates of the whole way from a system to "not integrable", by hand: true ones, and beside each rule of
docs/theory/system_certificates.md false ones that a plausible mistake in it would accept.  certificates() yields what is
stated, the text and whether it is right."""
import json

import asymmetric
from traps import changed, read

AIRY = json.loads(asymmetric.certificate(
    asymmetric.AIRY, {"group": "SL2", "abelian": False}, asymmetric.local(),
    ("no-exponential", ["s0"], {"by": "parity"}), ("no-invariant", ["s0"], {"m": "12", "by": "degree"}),
    asymmetric.conclude("sl2-irreducible-12", 0, 1, 2)))


def torus(num, den, places, parameters=(), generic=(), tree=None, variable="z"):
    leaf = {"node": "leaf", "abelian": "no", "by": "torus", "infinity": {}, **places}
    return {"format": "kovacic-strata/1", "variable": variable, "parameters": list(parameters), "real": [],
            "assumptions": [], "generic": list(generic), "r": {"num": num, "den": den}, "claim": {"abelian": False},
            "tree": tree(leaf) if tree else leaf}


def half(q, content):
    """A place with Delta = 1/2"""
    return {"content": content, "places": [{"q": q, "order": "2", "chi": ["-1", "4"]}]}


def system(title, parameters, mechanics, curve, normal, certificate, **more):
    equation = {"certificate": certificate} | ({"root": more.pop("root")} if "root" in more else {})
    curve = {"manifold": "N", "equations": [], "levels": [], "denominators": [], "tower": []} | curve
    return {"format": "kovacic-system/1", "title": title, "parameters": list(parameters), "system": mechanics, **more,
            "curve": curve, "normal": {"annihilators": [], "rest": []} | normal, "equation": equation,
            "claim": {"not_integrable": True}}


def canonical(*pairs):
    return [[q, p, "1"] for q, p in pairs]


def henon_heiles():
    """Along q1 = 0, with the energy h; the momentum is in the tower."""
    def split(leaf):
        return {"node": "split", "p": "h", "nonzero": leaf, "zero": {"zero": "outside", "generic": "0"}}
    inner = torus("8*z^3 + 3*z^2 - 16*h*z - 12*h", "4*z^4 - 16*h*z^2 + 16*h^2", half("z^2 - 2*h", "4"), ["h"], [["h"]], split)
    energy = ["p1^2 + p2^2 + q1^2 + q2^2 + 2*q1^2*q2", "2"]
    curve = {"equations": ["q1", "p1"], "levels": [["2*h - p2^2 - q2^2", "2"]], "variable": "z", "change": "q2",
             "denominators": ["2*h - z^2"],
             "tower": [{"name": "p2", "degree": "2", "value": "2*h - z^2", "derivative": ["-z*p2", "1", "1"]}],
             "values": {"q1": "0", "q2": "z", "p1": "0", "p2": "p2"}, "time": ["p2", "1", "1"]}
    normal = {"row": ["1", "0", "0", "0"], "p": ["-z", "1", "1"], "q": ["1 + 2*z", "1", "1"],
              "vectors": [["0", "0", "1", "0"], ["-p2", "0", "0", "0"]]}
    return system("a cubic potential", ["h"], {"coordinates": ["q1", "q2", "p1", "p2"], "hamiltonian": energy,
                                               "brackets": canonical(("q1", "p1"), ("q2", "p2"))},
                  curve, normal, inner, claims=[{"kind": "integral", "name": "energy", "value": energy}])


def airy_field():
    """x' = 1, y'' = x y; the first row of the equation, with an annihilator dx that is not needed by the identity."""
    curve = {"equations": ["y", "v"], "variable": "t", "change": "x", "values": {"x": "t", "y": "0", "v": "0"}, "time": "1"}
    normal = {"row": ["0", "1", "0"], "p": "0", "q": "-t", "annihilators": [{"row": ["1", "0", "0"], "matrix": ["0"]}],
              "rest": ["0"], "vectors": [["0", "1", "0"], ["0", "0", "1"]]}
    return system("a field", [], {"coordinates": ["x", "y", "v"], "field": ["1", "v", "x*y"]}, curve, normal, AIRY)


def eliminated():
    """q' = p + b x, p' = x q: the block of q is one only where b = 0; b is a Casimir function, as k = 3/2 is, and sl(2) beside
    it has another."""
    curve = {"equations": ["q", "p"], "variable": "z", "change": "x",
             "values": {"x": "z", "e": "0", "q": "0", "p": "0", "b": "0", "k": ["3", "2"], "f": "1", "g": "-2", "h": "5"},
             "time": "1"}
    none = ["0", "0", "0"]
    normal = {"row": ["0", "0", "1", "0", "0", "0"] + none, "p": "0", "q": "-z",
              "annihilators": [{"row": ["0", "0", "0", "0", "1", "0"] + none, "matrix": ["0"]}], "rest": ["1"],
              "vectors": [["0", "0", "0", "1", "0", "0"] + none, ["0", "0", "-1", "0", "0", "0"] + none]}
    energy = ["2*e + p^2 + 2*b*p*x - x*q^2", "2"]
    algebra = [["f", "g", "h"], ["h", "f", "2*f"], ["g", "h", "2*g"]]
    mechanics = {"coordinates": ["x", "e", "q", "p", "b", "k", "f", "g", "h"],
                 "brackets": canonical(("x", "e"), ("q", "p")) + algebra, "hamiltonian": energy}
    claims = [{"kind": "casimir", "name": "b", "value": "b"}, {"kind": "casimir", "name": "both", "value": ["2*b*k^2", "4"]},
              {"kind": "casimir", "name": "Killing", "value": "h^2 + 4*f*g"}]
    return system("a level", [], mechanics, curve, normal, AIRY, claims=claims)


def mathieu():
    """H = J + (p^2 + s q^2)/2 with the angle phi left out, s = sin(phi); z = s."""
    inner = torus("4*z^3 - z^2 - 4*z - 2", "4*z^4 - 8*z^2 + 4", half("z^2 - 1", "4"))
    energy = ["2*J + p^2 + s*q^2", "2"]
    mechanics = {"coordinates": ["phi", "J", "q", "p"], "relations": ["c^2 + s^2 - 1"],
                 "functions": [{"name": "s", "meaning": "sin(phi)", "gradient": {"phi": "c"}},
                               {"name": "c", "meaning": "cos(phi)", "gradient": {"phi": "-s"}},
                               {"name": "e", "meaning": "exp(phi)", "gradient": {"phi": "e"}},
                               {"name": "i", "meaning": "1 - cos(phi)", "gradient": {"phi": "s"}},
                               {"name": "j", "meaning": "J^2/2", "gradient": {"J": "J"}}],
                 "hamiltonian": energy, "brackets": canonical(("phi", "J"), ("q", "p"))}
    curve = {"equations": ["q", "p"], "variable": "z", "change": "s", "denominators": ["1 - z^2"],
             "tower": [{"name": "c", "degree": "2", "value": "1 - z^2", "derivative": ["-z*c", "1", "1"]}],
             "values": {"q": "0", "p": "0", "J": "0", "s": "z", "c": "c"}, "time": ["c", "1", "1"]}
    normal = {"row": ["0", "0", "1", "0"], "p": ["-z", "1", "1"], "q": ["z", "1", "1"],
              "vectors": [["0", "0", "0", "1"], ["0", "0", "-c", "0"]]}
    claims = [{"kind": "integral", "name": "H", "value": energy},
              {"kind": "integral", "name": "H again", "value": ["2*c^2*J + 2*s^2*J + p^2 + s*q^2", "2"],
               "cofactors": [[["-c*q^2", "2"]]]}]
    return system("an angle", [], mechanics, curve, normal, inner, claims=claims)


def constants(root):
    """y'' = k x y with k^2 = 2: k is a parameter of the certificate inside, or the generator of its field."""
    inner = torus("k*z", "1", {"content": "1", "places": []}, ["k"], [["k"], ["k", "k^2 - 2"]], lambda leaf: {
        "node": "split", "p": "k", "nonzero": leaf, "zero": {"zero": "outside", "generic": "0"}})
    if root:
        inner = AIRY | {"field": {"name": "a", "minpoly": ["-2", "0", "1"]}, "r": {"num": ["0", ["0", "1"]], "den": ["1"]}}
        inner = changed(inner, ["steps", 0, "data", "prime"], {"p": "1009", "a": "439"})
    curve = {"equations": ["y", "v"], "variable": "z", "change": "x", "values": {"x": "z", "y": "0", "v": "0", "k": "w"},
             "tower": [{"name": "w", "degree": "2", "value": "2", "derivative": "0"}], "time": "1"}
    normal = {"row": ["0", "1", "0"], "p": "0", "q": "-z*w", "vectors": [["0", "1", "0"], ["0", "0", "1"]]}
    mechanics = {"coordinates": ["x", "y", "v"], "field": ["1", "v", "k*x*y"], "relations": ["k^2 - 2"],
                 "functions": [{"name": "k", "meaning": "a root of 2", "gradient": {}}]}
    return system("a root", [], mechanics, curve, normal, inner, **({"root": "w"} if root else {}))


def radius():
    """Functions of two coordinates, with an inverse: r = sqrt(x^2 + y^2), u = 1/r; x' = 1 on y = 0, v'' = r v."""
    mechanics = {"coordinates": ["x", "y", "v", "p"], "relations": ["r^2 - x^2 - y^2"], "inverses": [{"name": "u", "of": "r"}],
                 "functions": [{"name": "r", "meaning": "sqrt(x^2 + y^2)", "gradient": {"x": "x*u", "y": "y*u"}}],
                 "field": ["1", "0", "p", "r*v"]}
    curve = {"equations": ["y"], "variable": "z", "change": "x", "denominators": ["z"],
             "values": {"x": "z", "y": "0", "v": "0", "p": "0", "r": "z", "u": ["1", "1", "1"]}, "time": "1"}
    normal = {"row": ["0", "0", "1", "0"], "p": "0", "q": "-z", "vectors": [["0", "0", "1", "0"], ["0", "0", "0", "1"]]}
    return system("a radius", [], mechanics, curve, normal, AIRY)


def functions():
    """y'' = x y with functions of y, which have values on y = 0, and constants that relations fix."""
    def moving(name, meaning, slope):
        return {"name": name, "meaning": meaning, "gradient": {"y": slope}}
    mechanics = {"coordinates": ["x", "y", "v"], "field": ["1", "v", "x*y"],
                 "relations": ["c^2 + s^2 - 1", "k^2 - b", "m - k", "b*n - 1", "r^2 - y^2 - 1"],
                 "inverses": [{"name": "u", "of": "r"}],
                 "functions": [moving("e", "exp(y)", "e"), moving("s", "sin(y)", "c"), moving("c", "cos(y)", "-s"),
                               moving("f", "exp(sin(y))", "c*f"), moving("g", "exp(b*y)", "b*g"), moving("h", "y^8", "8*y^7"),
                               moving("r", "sqrt(y^2 + 1)", "y*u"),
                               *({"name": x, "meaning": "", "gradient": {}} for x in "kmn")]}
    values = {"x": "z", "y": "0", "v": "0", "e": "1", "s": "0", "c": "1", "f": "1", "g": "1", "h": "0", "r": "1", "u": "1", "k": "w",
              "m": "w", "n": ["1", "1", "1"]}
    curve = {"equations": ["y", "v"], "variable": "z", "change": "x", "values": values, "time": "1", "denominators": ["b"],
             "tower": [{"name": "w", "degree": "2", "value": "b", "derivative": "0"},
                       {"name": "j", "degree": "2", "value": "1", "derivative": "0"}]}
    normal = {"row": ["0", "1", "0"], "p": "0", "q": "-z", "vectors": [["0", "1", "0"], ["0", "0", "1"]]}
    return system("functions", ["b", "d"], mechanics, curve, normal, AIRY)


def one_or_two(num="k*z", den="1", generic=(["k"],), **more):
    """y'' = k x y with k^2 - 3 k + 2 = 0: on one component of the curve k is 1, on the other 2."""
    top = constants(False)
    top["equation"]["certificate"] = torus(num, den, {"content": den, "places": []}, ["k"], generic, lambda leaf: {
        "node": "split", "p": "k", "zero": {"zero": "outside", "generic": "0"}, "nonzero": leaf if den == "1" else {
            "node": "split", "p": den, "zero": {"zero": "outside"}, "nonzero": leaf}}) | more
    top["system"]["relations"], top["curve"]["tower"][0]["value"] = ["k^2 - 3*k + 2"], "1"
    top["curve"]["values"]["k"], top["normal"]["q"] = ["w + 3", "2"], ["-z*w - 3*z", "2"]
    return top


def inverse():
    """p' = x^2 - x^3/(x + v): that v = 0 is a solution with y'' = x y beside it needs the derivatives of 1/(x + v)."""
    curve = {"equations": ["v", "p"], "variable": "z", "change": "x", "denominators": ["-2*z", "3", "z + 1"],
             "values": {"x": "z", "v": "0", "p": "0", "u": ["-2", "1", "1"], "g": ["3", "1", "0", "1", "1"]}, "time": "1"}
    normal = {"row": ["0", "1", "0"], "p": "0", "q": "-z", "vectors": [["0", "1", "0"], ["0", "0", "1"]]}
    mechanics = {"coordinates": ["x", "v", "p"], "field": ["1", "p", "x^2 - x^3*u"],
                 "inverses": [{"name": "u", "of": "x + v"}, {"name": "g", "of": "x + 1"}]}
    return system("an inverse", [], mechanics, curve, normal, AIRY)


def driven(name, num, den, parameters=()):
    """v'' = (num/den)(x) v with x' = 1, num given by its terms, and an angle phi' = 2 that is left out; the certificate of
    the equation is that of the file."""
    def text(sign, z):
        return " + ".join(f"{sign * c}*{term}".replace("z", z) for c, term in num).replace("+ -", "- ")
    curve = {"equations": ["v", "p"], "variable": "z", "change": "x", "denominators": [den],
             "values": {"x": "z", "v": "0", "p": "0", "u": ["1", "1", "1"]}, "time": "1"}
    normal = {"row": ["0", "0", "1", "0"], "p": "0", "q": [text(-1, "z"), "1", "1"],
              "vectors": [["0", "0", "1", "0"], ["0", "0", "0", "1"]]}
    force = " + ".join(f"{c}*{term}*u*v".replace("z", "x") for c, term in num)
    mechanics = {"coordinates": ["x", "phi", "v", "p"], "field": ["1", "2", "p", force.replace("+ -", "- ")],
                 "inverses": [{"name": "u", "of": den.replace("z", "x")}]}
    return system("driven", parameters, mechanics, curve, normal, json.loads(read("data", name + ".json")))


GENUINE = {"henon_heiles": henon_heiles(), "airy_field": airy_field(), "level": eliminated(), "angle": mathieu(),
           "root": constants(True), "constant": constants(False), "functions": functions(), "one or two": one_or_two(), "radius": radius(), "inverse": inverse(),
           "regular": driven("leg-x0-naive", [(3, "z^2"), (-7, "z^0")], "4*z^4 - 8*z^2 + 4"),
           "unipotent": driven("strata/accessory", [(-2, "z^4"), (1, "a*z^3"), (-4, "z^2"), (-1, "a*z"), (-2, "z^0")],
                               "9*z^6 - 18*z^4 + 9*z^2", ["a"]),
           "irregular": driven("kam-305-naive", [(-1, "z"), (1, "z^0")], "z^4")}


def forged_by_annihilators():
    """y'' = 0, passed off as Airy's equation: y = 0 where the annihilators vanish."""
    top = airy_field()
    top["system"]["field"] = ["1", "v", "0"]
    top["normal"] |= {"annihilators": [{"row": ["0", "1", "0"], "matrix": ["0", "1"]}, {"row": ["0", "0", "1"], "matrix": ["0", "0"]}],
                      "rest": ["-t", "0"]}
    return top


def unseen_by_the_leaf():
    """{u, p} = v, {v, p} = x u: the leaf through u = v = 0 is the plane of x and p, where H = p is all that is needed."""
    curve = {"equations": ["u", "v"], "variable": "z", "change": "x", "values": {"x": "z", "p": "0", "u": "0", "v": "0"}, "time": "1"}
    normal = {"row": ["0", "0", "1", "0"], "p": "0", "q": "-z", "vectors": [["0", "0", "1", "0"], ["0", "0", "0", "1"]]}
    mechanics = {"coordinates": ["x", "p", "u", "v"], "brackets": [["x", "p", "1"], ["u", "p", "v"], ["v", "p", "x*u"]],
                 "hamiltonian": "p"}
    return system("a leaf", [], mechanics, curve, normal, AIRY)


def singular_on_the_curve():
    """{a, b} = 1/m with m = 0 on the curve"""
    top = eliminated()
    mechanics, values = top["system"], top["curve"]["values"]
    mechanics["coordinates"] += ["a", "b2", "m"]
    mechanics |= {"brackets": mechanics["brackets"] + [["a", "b2", "u"]], "inverses": [{"name": "u", "of": "m"}]}
    values |= {"a": "0", "b2": "0", "m": "0"}
    for row in (top["normal"]["row"], top["normal"]["annihilators"][0]["row"], *top["normal"]["vectors"]):
        row += ["0", "0", "0"]
    return top


def nothing_at_the_constant(generic):
    """The certificate inside says nothing where k^2 = 2, and k^2 = 2."""
    def split(p, zero):
        return lambda leaf: {"node": "split", "p": p, "nonzero": leaf, "zero": {"zero": "outside"} | zero}
    top = constants(False)
    outer, inner = split("k", {"generic": "0"}), split("k^2 - 2", {"generic": "1"} if generic else {})
    num, den = ("k*z", "1") if generic else ("k^3*z - 2*k*z", "k^2 - 2")
    top["equation"]["certificate"] = torus(num, den, {"content": den, "places": []}, ["k"], [["k"], ["k^2 - 2"]][:1 + generic],
                                           lambda leaf: outer(inner(leaf)))
    return top


def backwards():
    """The other branch of the momentum"""
    top = henon_heiles()
    top["curve"]["values"]["p2"], top["curve"]["time"] = "-p2", ["-p2", "1", "1"]
    top["normal"]["vectors"][1] = ["p2", "0", "0", "0"]
    return top


GENUINE |= {
    "negative": changed(changed(GENUINE["inverse"], ["curve", "denominators", 1], "-3"), ["curve", "values", "g"], ["-3", "1", "0", "1", "1"]),
    "a sum": constants(False), "two roots": constants(True), "pole": driven("airy-naive", [(1, "z^0")], "z"),
    "irregular pole": driven("airy-naive", [(1, "z^0")], "z^3"),
    "of nothing": changed(changed(GENUINE["henon_heiles"], ["claim", "not_integrable"], False),
                          ["equation", "certificate", "claim", "abelian"], None)}
GENUINE["pole"]["equation"]["certificate"] = torus("1", "z", {"content": "1", "places": [{"q": "z", "order": "1"}]})
GENUINE["irregular pole"]["equation"]["certificate"] = torus("1", "z^3", {"content": "1", "places": [{"q": "z", "order": "3"}]})
GENUINE["two roots"]["curve"]["tower"] += [{"name": "v", "degree": "2", "value": "v + w", "derivative": "0"},
                                           {"name": "u", "degree": "2", "value": "v*w + w", "derivative": "0"}]
for path, value in ((["system", "relations"], ["k^2 - 2*k - 1"]), (["curve", "values", "k"], "w + 1"), (["normal", "q"], "-z*w - z"),
                    (["equation", "certificate", "generic"], [["k"]])):
    GENUINE["a sum"] = changed(GENUINE["a sum"], path, value)
GENUINE["number"] = constants(False)
for path, value in ((["system", "relations"], ["k - 3"]), (["curve", "values", "k"], "3"), (["normal", "q"], "-3*z"),
                    (["equation", "certificate", "generic"], [["k"]]), (["equation", "certificate", "real"], ["k"]),
                    (["equation", "certificate", "rational"], ["k"]),
                    (["equation", "certificate", "memberships"], [{"num": "k", "den": "2", "integral": False}]),
                    (["equation", "certificate", "assumptions"], [{"p": f, "sign": sign} for f, sign in (
                        ("k", "positive"), ("k - 3", "nonnegative"), ("k - 3", "zero"), ("k - 2", "nonzero"))])):
    GENUINE["number"] = changed(GENUINE["number"], path, value)
GENUINE |= {f"functions: {value}": changed(GENUINE["functions"], ["curve", "values", "e"], value) for value in ("b", "j + 2", "w", "2")}
GENUINE["one or two: conditions"] = one_or_two(assumptions=[{"p": "k - 3", "sign": "nonzero"}, {"p": "k^2 - 3*k + 2", "sign": "zero"}],
                                               generic=[["k"], ["k - 1", "k + 1"]])
CHANGES = [                                 # of, what is false, then path and value, or pairs of them
    ("inverse", "an inverse with another value", "curve values g", ["1", "1", "0", "1", "1"]),
    ("inverse", "an inverse without a value", "curve values g"),
    ("negative", "another sign", "curve values g", ["3", "1", "0", "1", "1"]),
    ("a sum", "another root", "curve values k", "w"),
    ("two roots", "the first is made of the second", "curve tower", [{"name": "v", "degree": "2", "value": "w", "derivative": "0"},
                                                                     {"name": "w", "degree": "2", "value": "2", "derivative": "0"}]),
    ("root", "a step of degree 1", "curve tower +", {"name": "v", "degree": "1", "value": "2", "derivative": "0"}),
    ("airy_field", "one entry more", "system field +", "0"),
    ("airy_field", "a parameter twice", "parameters", ["a", "a"]),
    ("airy_field", "0/0", "curve values y", ["0", "0"]),
    ("angle", "too high a power", "curve values q", ["0", "1", "1001"]),
    ("level", "neither an integral nor a Casimir function", "claims 0 kind", "constant"),
    ("henon_heiles", "{q1, q1} = 0", "system brackets +", ["q1", "q1", "0"]),
    ("henon_heiles", "four entries", "system brackets 0", ["q1", "p1", "1", "1"]),
    ("inverse", "another solution", "curve values u", ["1", "1", "1"]),
    ("inverse", "the inverse of a number", ("system inverses 1 of", "3"), ("curve values g", ["1", "3"])),
    ("inverse", "the inverse of an inverse", ("system inverses 1 of", "u"), ("curve values g", "z")),
    ("inverse", "a force with another derivative", "system field 2", "x^2 - x^4*u^2"),
    ("inverse", "the denominator of another component", "curve denominators 0", "2*z"),
    ("angle", "the cosine has another sign", ("curve values c", "-c")),
    ("angle", "one cofactor too many", "claims 1 cofactors +", ["0"]),
    ("level", "no Jacobi identity", ("claims",), ("system brackets +", ["b", "k", "x"])),
    ("level", "another sign in sl(2)", ("claims",), ("system brackets 4", ["g", "h", "-2*g"])),
    ("level", "another sign in sl(2)", ("claims",), ("system brackets 3", ["h", "f", "-2*f"])),
    ("level", "cofactors for one coordinate", "claims 0 cofactors", [[]]),
    ("regular", "another sign", "normal q 0", "3*z^2 - 7"),
    ("regular", "the equation has another numerator", "system field 3", "3*x^2*u*v - 8*u*v"),
    ("constant", "the equation excludes the constant", ("equation certificate generic 0", ["k^2 - 2"])),
    ("radius", "a gradient that is none", "system functions 0 gradient y", "0"),
    ("radius", "no gradient has this curl", "system functions +", {"name": "g", "meaning": "", "gradient": {"x": "y"}}),
    ("radius", "an inverse without a value", "system inverses +", {"name": "g", "of": "y"}),
    ("radius", "the inverse of a number", "system inverses +", {"name": "g", "of": "2"}),
    ("radius", "the inverse of an inverse", "system inverses +", {"name": "g", "of": "u"}),
    ("radius", "another inverse", "curve values u", "1"),
    ("radius", "an inverse where none may stand", "system relations +", "r*u - 1"),
    ("radius", "a relation that holds on the curve only", "system relations +", "r - x"),
    ("radius", "a relation of coordinates", "system relations +", "y"),
    ("radius", "a relation that does not hold", "system relations 0", "r^2 - x^2 - y^2 - 1"),
    ("radius", "no relation", "system relations +", "1"),
    ("angle", "a cosine that is a hyperbolic one", "system functions 1 gradient phi", "s"),
    ("angle", "a constant that is a parameter", "system functions +", {"name": "g", "meaning": "", "gradient": {}}),
    ("angle", "a constant with the gradient 0", "system functions +", {"name": "g", "meaning": "", "gradient": {"q": "0"}}),
    ("angle", "the sine of another angle", "curve values s", "-z"),
    ("angle", "no point of the circle", "curve values c", "0"),
    ("angle", "a relation needs its cofactor", "claims 1 cofactors 0 0", "0"),
    ("angle", "the cofactor has another sign", "claims 1 cofactors 0 0", ["c*q^2", "2"]),
    ("angle", "not an integral", "claims 0 value", "J"),
    ("angle", "not an integral, but where q = 0", "claims 0 value", "q"),
    ("angle", "not a Casimir function", "claims 0 kind", "casimir"),
    ("level", "the sign of a bracket", "system brackets 0", ["e", "x", "1"]),
    ("level", "a bracket twice", "system brackets +", ["p", "q", "-1"]),
    ("level", "not a Casimir function", "claims 0 value", "b + q"),
    ("level", "H has no Casimir function x", "claims 0 value", "x"),
    ("level", "the block where b is not 0", "normal annihilators 0 row 4", "0"),
    ("level", "not what is left", "normal rest 0", "0"),
    ("level", "not what is left", "normal rest 0", "-1"),
    ("level", "an annihilator is not constant", "normal annihilators 0 matrix 0", "1"),
    ("level", "an annihilator that is none", "normal annihilators 0 row 5", "z"),
    ("airy_field", "a vector that the annihilator sees", "normal vectors 0 0", "1"),
    ("henon_heiles", "another energy", "curve tower 0 value", "h - z^2"),
    ("henon_heiles", "another derivation", "curve tower 0 derivative", ["-z*p2", "2", "1"]),
    ("henon_heiles", "a value of too high a degree", "curve tower 0 value", "2*h - z^2 + p2^2"),
    ("henon_heiles", "another time", "curve time", ["p2", "1"]),
    ("henon_heiles", "time runs backwards", "curve time", ["-p2", "1", "1"]),
    ("henon_heiles", "not on the manifold", "curve equations +", "q2"),
    ("henon_heiles", "not on the level", "curve levels 0", ["2*h - p2^2 + q2^2", "2"]),
    ("henon_heiles", "another variable", "curve change", "p2"),
    ("henon_heiles", "a constant variable", "curve change", "q1"),
    ("henon_heiles", "an equilibrium", "curve values", {"q1": "0", "q2": "0", "p1": "0", "p2": "0"}),
    ("henon_heiles", "not a solution", "curve values q1", "z"),
    ("henon_heiles", "X without a value", "curve values", {"q1": "0", "q2": "z", "p1": "0"}),
    ("henon_heiles", "the damping has a sign", "normal p", ["z", "1", "1"]),
    ("henon_heiles", "another coupling", "normal q", ["1 + z", "1", "1"]),
    ("henon_heiles", "w = 0", "normal row 0", "0"),
    ("henon_heiles", "w twice", "normal row 0", "2"),
    ("henon_heiles", "the other block", "normal row", ["0", "1", "0", "0"]),
    ("henon_heiles", "a row of three entries", "normal row", ["1", "0", "0"]),
    ("henon_heiles", "a coefficient of no annihilator", "normal rest", ["1"]),
    ("henon_heiles", "a vector that is not a gradient", "normal vectors 0", ["1", "0", "0", "0"]),
    ("henon_heiles", "one vector twice", "normal vectors 1", ["0", "0", "1", "0"]),
    ("henon_heiles", "the sign of P", "normal vectors 1 0", "p2"),
    ("henon_heiles", "the potential has a sign", "system hamiltonian", ["p1^2 + p2^2 + q1^2 + q2^2 - 2*q1^2*q2", "2"]),
    ("henon_heiles", "another equation", "equation certificate", AIRY),
    ("henon_heiles", "a root is not needed", "equation root", "1"),
    ("henon_heiles", "the claim inside is open", "equation certificate claim abelian", None),
    ("airy_field", "another variable inside", "equation certificate", torus("y", "1", {"content": "1", "places": []}, variable="y")),
    ("airy_field", "a root over Q", "equation root", "0"),
    ("root", "r at no root", ("system field 2", "5*x*y"), ("normal q", "-5*z"), ("equation root", "5")),
    ("henon_heiles", "a denominator 0", "curve denominators +", "0"),
    ("airy_field", "another equation", "normal q", "t"),
    ("airy_field", "the equation of another system", "system field 2", "-x*y"),
    ("airy_field", "not autonomous", "system field 0", "x"),
    ("airy_field", "a parameter of nothing", "equation certificate",
     torus("t", "1", {"content": "1", "places": []}, ["A"], variable="t")),
    ("airy_field", "no bracket for a Casimir function", "claims", [{"kind": "casimir", "name": "", "value": "1"}]),
    ("root", "the other root", "equation root", "-w"),
    ("root", "no root", "equation root", "1"),
    ("root", "a root is missing", "equation root"),
    ("root", "the root of 3", "curve tower 0 value", "3"),
    ("root", "no constant", "curve tower 0 derivative", "1"),
    ("functions", "exp(y) = 0", "curve values e", "0"),
    ("functions", "exp(y) may be 0", "curve values e", "d"),
    ("functions", "exp(y) is 0 on one component", "curve values e", "j + 1"),
    ("functions", "exp(sin(y)) = 0: its friend moves", "curve values f", "0"),
    ("functions", "exp(b*y) = 0", "curve values g", "0"),
    ("functions", "exp(b*y) may be 0 where b is not", "curve values g", "b + d"),
    ("functions", "too flat", ("system functions 5 gradient y", "9*y^8 + s*y^9")),
    ("functions", "y is a name of the tower, and another coordinate", ("curve tower 1 name", "y"), ("curve values e", "y + 2")),
    ("functions", "no sine and no cosine: no relation, and the circle through 0",
     ("system relations 0", "0"), ("curve values c", "0")),
    ("functions", "the gradient is 0 on the circle", "system functions 5 gradient y", "c^2 + s^2 - 1"),
    ("functions", "a constant times 0", ("system relations 1", "k*m"), ("system relations 2", "k*m"), ("curve values m", "0")),
    ("functions", "each constant is the other", "system relations 1", "k - m"),
    ("functions", "a constant that is any where d = 0", ("system relations 1", "d*k - d*m"), ("system relations 2", "d*m - d"),
     ("curve values k", "1"), ("curve values m", "1")),
    ("one or two", "k - 1 is not 0 on one component", "equation certificate generic +", ["k - 1"]),
    ("one or two", "k - 1 is not 0 on one component", "equation certificate assumptions +", {"p": "k - 1", "sign": "nonzero"}),
    ("one or two", "k = 1 on one component", "equation certificate assumptions +", {"p": "k - 1", "sign": "zero"}),
    ("one or two", "the sign of a root", "equation certificate assumptions +", {"p": "k", "sign": "positive"}),
    ("one or two", "a root that is not seen to be real", "equation certificate real", ["k"]),
    ("number", "k = 3", "equation certificate assumptions +", {"p": "k - 3", "sign": "nonzero"}),
    ("number", "k is not 2", "equation certificate assumptions +", {"p": "k - 2", "sign": "zero"}),
    ("number", "-k is negative", "equation certificate assumptions +", {"p": "-k", "sign": "nonnegative"}),
    ("number", "k = 3", "equation certificate assumptions +", {"p": "k - 3", "sign": "positive"}),
    ("number", "k is an integer", "equation certificate memberships", [{"num": "k", "den": "1", "integral": False}]),
    ("number", "k/2 is none", "equation certificate memberships", [{"num": "k", "den": "2", "integral": True}]),
    ("constant", "an equation for the other root", "equation certificate r num", "-k*z"),
    ("constant", "a parameter that is not a constant", "system functions 0 gradient", {"x": "0", "y": "0"}),
]
MALFORMED = [
    ("henon_heiles", "system field", ["p1", "p2", "0", "0"]), ("henon_heiles", "system brackets"),
    ("henon_heiles", "system brackets 0", ["q1", "q1", "1"]), ("henon_heiles", "system brackets 0", ["q1", "h", "1"]),
    ("henon_heiles", "system brackets 0", ["q1", "p1"]), ("henon_heiles", "curve values h", "1"),
    ("henon_heiles", "system coordinates 1", "q1"), ("henon_heiles", "parameters 0", "q1"), ("henon_heiles", "parameters 0", "2"),
    ("henon_heiles", "curve variable", "h"), ("henon_heiles", "curve variable", "p2"), ("henon_heiles", "curve time", ["p2"]),
    ("henon_heiles", "curve time", ["p2", "0"]), ("henon_heiles", "curve time", ["p2", "1", "-1"]), ("henon_heiles", "curve time", []),
    ("henon_heiles", "curve time", ["p2", "1", "1", "1"]), ("henon_heiles", "curve time", ["p2", "1", "1001"]),
    ("henon_heiles", "curve time", "q2"), ("henon_heiles", "curve change", "z"), ("henon_heiles", "curve change", ["q2", "1", "0"]),
    ("henon_heiles", "normal vectors", [["0", "0", "1", "0"]]), ("henon_heiles", "claim", {}), ("henon_heiles", "more", "1"),
    ("henon_heiles", "claims 0 kind", "energy"), ("henon_heiles", "claims 0 cofactors", [["0"]]), ("henon_heiles", "title", None),
    ("airy_field", "system field", ["1", "v"]), ("airy_field", "system coordinates", []), ("airy_field", "system brackets", []),
    ("radius", "system functions 0 gradient z", "1"), ("radius", "curve denominators 0", "x"),
    ("root", "curve tower 0 degree", "2/1"), ("root", "curve tower 0 name", "z"),
]


def certificates():
    for name, top in GENUINE.items():
        yield name, json.dumps(top), True
    for of, why, *changes in CHANGES:
        top = GENUINE[of]
        for path, *value in changes if isinstance(changes[0], tuple) else [changes]:
            top = changed(top, path.split(), *value)
        yield f"{of}: {why}", json.dumps(top), False
    for of, path, *value in MALFORMED:
        yield f"{of}: {path}", json.dumps(changed(GENUINE[of], path.split(), *value)), False
    for why, top in (("annihilators that make y = 0", forged_by_annihilators()), ("a block off the leaf", unseen_by_the_leaf()),
                     ("a bracket that is singular on the curve", singular_on_the_curve()),
                     ("its denominator is 0 at the constant", nothing_at_the_constant(False)),
                     ("it excludes the constant", nothing_at_the_constant(True)),
                     ("its denominator is 0 on one component", one_or_two("k^2*z - k*z", "k - 1"))):
        yield why, json.dumps(top), False
    yield "backwards", json.dumps(backwards()), True
