"""Properties of map.py of the Python checker: functions of its modules (sys.modules) that are True.  Maps between systems with fields
or functions, and the classes of integrals that a map carries over (docs/theory/calculus.md 4.4)."""
from types import SimpleNamespace

from composed import MOVED, NEAR, a_map, fact, theorem
from lowest import refused
from maps import diagonal

NAMES = ["q1", "q2", "p1", "p2"]
SAME = {x: x for x in NAMES}


def family(m, hamiltonian=None, field=None, coordinates=NAMES, functions=(), relations=(), parameters=(), complex=(), inverses=(),
           brackets=None):
    """functions: pairs of a name and a gradient"""
    canonical = [[x, "p" + x[1:], "1"] for x in coordinates if x[0] == "q"]
    system = {"coordinates": list(coordinates), "functions": [{"name": f, "gradient": g} for f, g in functions], "relations": list(relations),
              "inverses": [{"name": u, "of": f} for u, f in inverses], "field": field, "hamiltonian": hamiltonian,
              "brackets": None if field else canonical if brackets is None else brackets}
    return m["family"].Family({"name": "X", "parameters": list(parameters), "complex": list(complex), "system": system, "assumptions": []})


def made(m, x, y, shown=(), curve=None, at=(), **d):
    """The Map from what family() makes of x to that of y, or None if it is refused"""
    m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000
    found, read = [], m["phase_space"].Function.read

    def make():
        X, Y = family(m, **x), family(m, **y)
        here = m["family"].Here(X, {name: read(v, {k: i for k, i in X.names.items() if k != name}) for name, v in dict(at).items()})
        levels = {name: read(v, X.names) for name, v in dict(d.get("levels", ())).items()}
        asked = [(read(f, Y.names), says) for f, says in shown]
        by = {"levels": levels, "shown": []} if "values" not in d else {"adjoined": [], "shown": [], "bracket": ["1", "1"], "energy": ["1", "1"]}
        found.append(m["map"].Map(here, m["family"].Target(Y.space, Y.parameters, asked, curve), by | d | ({"levels": levels} if "levels" in d else {})))
    return None if refused(m, make) else found[0]


def fields(m):
    """(2 x)' = 15 (3 y) and (3 y)' = 15 (2 x) (3 y) where x' = y, y' = x y; a sheared one; by the same names"""
    y = {"field": ["y", "x*y"], "coordinates": "xy"}

    def accepts(*field, values=("2*x", "3*y"), back=(("1", "2"), ("1", "3")), bracket=("5", ["1", "5"]), energy=("3", ["1", "3"]), y=y):
        x = {"field": list(field), "coordinates": "xy"}
        back = diagonal([list(v) for v in back]) if len(back[0]) == 2 and isinstance(back[0], tuple) else back
        return made(m, x, y, values=dict(zip("xy", values)), back=back, bracket=list(bracket), energy=list(energy)) is not None
    sheared = {"values": ("x + 2*y", "y"), "back": [["1", "-2"], ["0", "1"]], "bracket": ("1", "1"), "energy": ("1", "1")}
    one = {"field": ["y", "x*y"], "coordinates": "xy"}
    plane, canonical = {"hamiltonian": ["p1^2", "2"], "coordinates": ["q1", "p1"]}, {"field": ["p1", "0"], "coordinates": ["q1", "p1"]}
    same = {"values": {x: x for x in ("q1", "p1")}, "back": diagonal(["1", "1"])}
    return (accepts(["45*y", "2"], "30*x*y") and not accepts(["43*y", "2"], "30*x*y") and not accepts(["45*y", "2"], "31*x*y")
            and not accepts(["45*y", "2"], "-30*x*y") and not accepts(["-45*y", "2"], "-30*x*y") and not accepts("0", "0")
            and accepts(["9*y", "2"], "6*x*y", bracket=("3", ["1", "3"]), energy=("1", "1"))
            and accepts("y - 2*x*y - 4*y^2", "x*y + 2*y^2", **sheared) and not accepts("y + 2*x*y + 4*y^2", "x*y + 2*y^2", **sheared)
            and not accepts("y", "x*y + 2*y^2", **sheared)
            and made(m, one, y) is not None and made(m, one | {"field": ["2*y", "x*y"]}, y) is None and made(m, one, y | {"field": ["y", "x"]}) is None
            and all((made(m, a, b, **how) is None) == (a is not b) for a in (plane, canonical) for b in (plane, canonical) for how in (same, {})))


def coordinates(m):
    """Of the same names, all of them; by names a parameter is no other thing"""
    free = {"hamiltonian": "p1^2 + q1"}
    less = free | {"coordinates": ["q1", "p1"]}
    still = {"field": ["1", "0"], "coordinates": ["x", "c"]}
    of_u = {"hamiltonian": "p1^2 + u*q2", "inverses": [("u", "q1")]}
    return (made(m, free, free) is not None and made(m, free, less) is None and made(m, less, free) is None
            and made(m, {"field": ["1", "0"], "coordinates": ["x", "y"], "parameters": "c"}, still) is None and made(m, still, still) is not None
            and made(m, of_u, {"hamiltonian": "p1^2 + u*q2", "parameters": "u"}) is None and made(m, of_u, of_u) is not None
            and made(m, of_u | {"hamiltonian": "p1^2 + p2*q2 + u"}, of_u | {"hamiltonian": "p1^2 + u*q2 + u"}) is None
            and made(m, {"hamiltonian": "p1^2", "parameters": "ab"}, {"hamiltonian": "p1^2", "parameters": "ab"}, at={"a": "b"}) is None
            and made(m, {"hamiltonian": "p1^2", "parameters": "ab"}, {"hamiltonian": "p1^2", "parameters": "b"}, at={"a": "b"}) is not None)


def plain(m):
    """Which families a map by values may be one of"""
    h = {"hamiltonian": "p1^2 + a*q1", "parameters": "a"}
    m["multivariate"].Work.left = 10**7
    return (family(m, **h).is_plain() and not family(m, **h, complex="a").is_plain() and not family(m, **h, relations=["a^2 - a"]).is_plain()
            and not family(m, **h, functions=[("s", {"q1": "s"})]).is_plain() and not family(m, field=["0"] * 4).is_plain()
            and refused(m, lambda: family(m, **h, complex="aa")))


def functions(m):
    """By names: with the same gradients and relations, or such as hold along the curve"""
    circle, other = [("s", {"q1": "c"}), ("c", {"q1": "-s"})], [("s", {"q1": "c"}), ("c", {"q1": "s"})]
    h = {"hamiltonian": "p1^2 + p2^2 + s"}
    x, one = h | {"functions": circle}, "s^2 + c^2 - 1"
    places = {name: i * m["multivariate"].FIELD for i, name in enumerate([*NAMES, "s", "c", "a", "h"])}

    def along(chosen=(), **numbers):
        """A curve with these values"""
        known = {places[name]: {1: number} for name, number in numbers.items()}

        def value(f):
            m["certificate_format"].need(f.p.variables() <= set(known), "a name has no value")
            return f.p.at(known, lambda p: p.get(0, 0))
        return {"curve": SimpleNamespace(known=known, chosen_by_functions=lambda: chosen, value=value)}

    def accepts(x, y, **more):
        return made(m, x, y, **more) is not None

    def related(*relations, **more):
        return x | {"relations": list(relations)} | more
    unit, of_a, root = related("a*s^2 + a*c^2 - a", parameters="a"), x | {"parameters": "a"}, x | {"functions": [*circle, ("r", {})], "relations": ["r^2 - 2"]}
    return (accepts(x, x) and not accepts(x, h | {"functions": other}) and not accepts(h | {"functions": other}, x)
            and accepts(related(one), related(one)) and accepts(related(one), related("1 - s^2 - c^2"))
            and accepts(related("3 - 3*s^2 - 3*c^2"), related(one)) and not accepts(x, related(one))
            and not accepts(related("s^2 + c^2 - 2"), related(one)) and not accepts(related("s^2 + c^2 + 1"), related(one))
            and accepts(related(one), x, **along(s=1, c=0)) and not accepts(related(one), x, **along(s=1, c=1))
            and not accepts(related(one), x, **along(s=1)) and accepts(related(one), x, **along(s=0, c=1, p1=7))
            and accepts(unit, of_a, **along(s=1, c=0, a=5)) and not accepts(unit, of_a, **along(s=1, c=1, a=5))
            and accepts(unit, x | {"parameters": "ah"}, **along(s=1, c=0, a=5, h=0)) and accepts(root, x) and not accepts(x, root))


def classes(m):
    """What is carried by q1 -> q1 + q2, p2 -> p2 - p1, by other names, and by the same ones"""
    back = [["1", "-1", "0", "0"], ["0", "1", "0", "0"], ["0", "0", "1", "0"], ["0", "0", "1", "1"]]
    h, moved = "p1*p2 + q1 + q2", "p1*p2 - p1^2 + q1 + 2*q2"
    mixed = made(m, {"hamiltonian": moved}, {"hamiltonian": h}, values=SAME | {"q1": "q1 + q2", "p2": "p2 - p1"}, back=back)
    others = {"hamiltonian": h.replace("q", "x").replace("p", "y"), "coordinates": ["x1", "x2", "y1", "y2"],
              "brackets": [["x1", "y1", "1"], ["x2", "y2", "1"]]}
    named = made(m, {"hamiltonian": h}, others, values={"x1": "q1", "x2": "q2", "y1": "p1", "y2": "p2"}, back=diagonal(["1"] * 4))
    turned = made(m, {"hamiltonian": h}, {"hamiltonian": h, "coordinates": ["q2", "q1", "p2", "p1"]}, values=SAME, back=[
        [["0", "1"][j == i ^ 1] for j in range(4)] for i in range(4)])
    same = made(m, {"hamiltonian": h}, {"hamiltonian": h})
    if not (mixed and named and turned and same):
        return False

    def carries(map, **more):
        c = SimpleNamespace(**{"functions": (), "through": (), "frame": "", "without": (), "kind": "meromorphic", "place": "curve"} | more)
        return not refused(m, lambda: m["map"].carried(c, map))
    return ([mixed.keeps_others(x) for x in (["q1"], ["q2"], ["p1"], ["p2"], ["q1", "q2"], NAMES, ["z"], ["q1", "z"], [])]
            == [True, False, False, True, True, True, False, False, True] and not named.keeps_others(["q1"]) and not named.keeps_others(["x1"])
            and not turned.keeps_others(["q1"]) and carries(mixed) and carries(named) and carries(turned)
            and carries(mixed, without=("q1",)) and not carries(mixed, without=("q2",)) and not carries(named, without=("q1",))
            and all(carries(same, **c) and not carries(mixed, **c) for c in ({"functions": ("s",)}, {"through": ("q1",)}, {"frame": "f"}))
            and carries(same, without=("q2",)))


def asked(m):
    """Conditions by names: of parameters, by the monomials in the levels, in their order"""
    h, names = {"hamiltonian": "p1^2 + a*q1", "parameters": "a"}, {x: i * m["multivariate"].FIELD for i, x in enumerate([*NAMES, "a", "h", "k"])}

    def accepts(f, says, i, terms=("1", "1")):
        by = {"node": "empty", "terms": [list(terms)], "zeros": [[str(i), "-1"]] if i is not None else []}
        m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000
        of, space = m["phase_space"].Function.read(f, names), family(m, **h | {"parameters": "ahk"}).space
        return not refused(m, lambda: m["map"].Map(m["family"].Here(family(m, **h)), m["family"].Target(space, ["a", "h", "k"], [(of, says)]),
                                                   {"levels": {}, "shown": [by]}))
    return (accepts("h^2 + a*k", "nonzero", 1) and not accepts("h^2 + a*k", "nonzero", 0)
            and  accepts("k + a*h + a", "nonzero", 1)
            and not accepts("h*q1 + 1", "nonzero", 0) and accepts("a*h + 1", "nonzero", 0)
            and accepts("0", "nonnegative", None, ("1", "1", ["0", "1"])) and not accepts("0", "positive", None))


def of_plain_families(m):
    """A place by values, and a symmetry: of Hamiltonian systems without functions, with real parameters"""
    h, values = {"hamiltonian": "p1^2 + p2^2 + a*q1", "parameters": "a"}, SAME | {"a": "a"}
    m["multivariate"].Work.left = 10**7
    real, complex, free = family(m, **h), family(m, **h, complex="a"), family(m, hamiltonian="p1^2 + q1")

    def place(y, x=free):
        t = theorem(m, {"X": x}, of=fact(m, "N", y, [], [NEAR]))
        real = {"over": "1", "value": "1", "by": {"node": "empty", "terms": [["1", "1"]], "zeros": [["0", "-1"]]}}
        values, shown = (SAME, []) if y is free else (SAME | {"a": "1"}, [real])
        return not refused(m, lambda: t.said("place", {"of": "of", "system": "X", "at": [], "region": []} | a_map(values=values, shown=shown)))

    def symmetric(x):
        return not refused(m, lambda: theorem(m, {"X": x}).said("symmetry", MOVED | a_map(values=values)))

    def lowest(y, x):
        t = theorem(m, {"X": x}, of=fact(m, "N", y, [], [NEAR]))
        return not refused(m, lambda: t.said("lowest-order", {"of": "of", "system": "X", "weights": [2, 1, 1, 2], "degree": 2, "units": [], "orders": []}))
    one, cubic = family(m, hamiltonian="p1^2 + p2^2 + q1"), {"hamiltonian": "p1^2 + q1*a", "parameters": "a"}
    three = [family(m, **cubic), family(m, **cubic, complex="a"), family(m, **cubic)]
    return (lowest(three[0], three[2]) and not lowest(three[1], three[2]) and not lowest(three[0], three[1]) and place(real, one) and not place(complex, one) and place(free) and symmetric(real) and not symmetric(complex))


def of_jets(m):
    """What a certificate of higher variational equations says, without trust and without constants"""
    module = m["rule_certificate"]
    real, system = module.jets, {"coordinates": ["q1", "q2"], "momenta": ["p1", "p2"], "hamiltonian": "p1^2 + p2^2 + a*q1"}
    d = {"system": system, "parameters": ["a"], "variables": ["e", "c1", "c2"], "denominators": ["a + 1"], "obstruction": {"value": "a*e + 3"},
         "constants": [], "title": "a title"}

    def said(trust=0, **more):
        m["multivariate"].Work.left, found = 10**7, []
        module.jets = SimpleNamespace(FORMAT=real.FORMAT, accept=lambda top, prove: (d | more, SimpleNamespace(order=3), SimpleNamespace(trust=trust)))
        if refused(m, lambda: found.append(theorem(m).said("certificate", {"certificate": {"format": real.FORMAT}}))):
            return None
        f, = found
        a = f.target.space.at["a"]
        return (f.kind, f.used, f.only_stratum, f.way, [(says, [{k >> a: c for k, c in g.p.items()} for g in (v if says == "some" else [v])])
                                                        for v, says in f.target.conditions])
    try:
        right = ("N", {"Morales-Ramis-Simo"}, True, ['VE_3 along a line of "a title"'], [("nonzero", [{1: 1, 0: 1}]), ("some", [{0: 3}, {1: 1}])])
        return (said() == right and said(obstruction={"value": ["a*e + 3", "5"]}) == right and said(obstruction={"value": "0"})[-1][1] == (
            "some", [{}]) and said(trust=1) is None and said(constants=["j"]) is None)
    finally:
        module.jets = real


def properties():
    """(name, function, True)"""
    return [(f"transport.{f.__name__}", f, True) for f in (fields, coordinates, plain, functions, classes, asked, of_plain_families, of_jets)]
