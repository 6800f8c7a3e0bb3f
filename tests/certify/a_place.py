"""Properties of family.py, map.py and theorem.py of the Python checker, functions of its modules (sys.modules) that are True: a system
at a place of another (theorem_certificates.md 1, 4).  maps.py has the linear maps themselves."""
from types import SimpleNamespace

from lowest import CANONICAL, SHOWN, family, refused
from maps import diagonal

NAMES = ("q1", "q2", "p1", "p2")
SAME, ONE = {x: x for x in NAMES}, diagonal(["1"] * 4)
PLAIN = {"parameters": [], "assumed": []}


def ready(m):
    m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000


def mapped(m, X, Y, values=SAME, back=ONE, at=(), region=(), adjoined=(), target=None, **more):
    """The Map of X to Y, both of what family() makes a system; None if it is refused"""
    ready(m)
    found, place = [], m["family"]
    X = X if isinstance(X, place.Family) else family(m, **(X if isinstance(X, dict) else {"h": X}))
    Y = Y if isinstance(Y, place.Family) else family(m, **(PLAIN | (Y if isinstance(Y, dict) else {"h": Y})))
    parse, Function = m["multivariate"].parse, m["phase_space"].Function
    at = {x: Function(parse(v, {})) for x, v in dict(at).items()}
    region = [(parse(f, X.names), sign) for f, sign in region]
    d = {"adjoined": list(adjoined), "values": values, "back": back, "bracket": ["1", "1"], "energy": ["1", "1"], "shown": []} | more
    if refused(m, lambda: found.append(m["map"].Map(place.Here(X, at, region), target or place.Target(Y.space, Y.parameters, []), d))):
        return None
    return found[0]


def systems(m):
    """Inverses and functions of a system, and what is to be shown of its parameters"""
    ready(m)
    Target, PhaseSpace = m["family"].Target, m["phase_space"].PhaseSpace

    def space(h, functions=(), of="q1 + 1"):
        return PhaseSpace({"coordinates": list(NAMES), "functions": [{"name": x, "gradient": g} for x, g in functions], "field": None,
                           "inverses": [{"name": "u", "of": of}], "relations": [], "brackets": CANONICAL, "hamiltonian": h}, ["a"])
    f = family(m, "u*q2", inverses=[("u", "q1 + a")], parameters=("a", "b"), assumed=("b",))
    region = [(m["multivariate"].parse("a - b", f.names), "zero")]
    kinds = [[(sign, dict(x.p), x.n) for x, sign in Target.of(f, region, *real).conditions] for real in ((), (True,), (False,))]
    a, b = (1 << f.names[x] for x in "ab")
    rest = [("positive", {b: 1}, 1), ("zero", {a: 1, b: -1}, 1)]
    sine = [("s", {"q1": "c"}), ("c", {"q1": "-s"})]
    uses = {x for x, v in space("u*q2").at.items() if v in Target(space("u*q2", of="q1 + a"), [], []).uses}
    return (not refused(m, lambda: family(m, "u", inverses=[("u", "q1 + 1")]))
            and refused(m, lambda: family(m, "q1", inverses=[("u", "q1 + 1")]))
            and kinds == [[("real", {a: 1}, 1), ("real", {b: 1}, 1), *rest]] * 2 + [rest] and uses == {"q1", "q2", "u", "a"}
            and not refused(m, Target(space("u*p1", sine), [], []).need_no_functions) and refused(m, Target(space("s*p1", sine), [], []).need_no_functions)
            and refused(m, Target(space("u*p1", sine, "s + 2"), [], []).need_no_functions)
            and not refused(m, Target(space("q1", sine, "s + 2"), [], []).need_no_functions))


def inverses(m):
    """Denominators with a content, and values of inverses"""
    x = {"h": "u*p1^2 + q2", "inverses": [("u", "6*q1 + 2")]}
    y = x | PLAIN

    def accepts(x, y, u, **more):
        return mapped(m, x, y, SAME | {"u": u}, **more) is not None
    twice = {"h": "2*u*p1^2 + q2", "inverses": [("u", "6*q1 + 2")]}
    of_a = {"h": "u*p1^2 + q2", "inverses": [("u", "a - 2")]}
    # u is 1/(3 q1 + 1) there
    return (accepts(x, y, ["u", "2"]) and not accepts(x, y, "u") and not accepts(twice, y, "u") and not accepts(twice, y, ["u", "2"])
            and mapped(m, of_a, "p1^2 + q2", at={"a": "3"}) is not None and mapped(m, of_a, "p1^2 + q2", at={"a": "4"}) is None
            and mapped(m, of_a, "p1^2 + q2", at={"a": "2"}) is None)


def unused(m):
    """The target may have an inverse that is not used: it has no value"""
    ready(m)
    place, system = m["family"], {"coordinates": list(NAMES), "functions": [], "field": None, "relations": [], "brackets": CANONICAL,
                                 "inverses": [{"name": "u", "of": "q1 + 1"}], "hamiltonian": "p1^2 + q2"}
    target = place.Target(m["phase_space"].PhaseSpace(system, []), [], [])
    return (mapped(m, "p1^2 + q2", "p1", target=target) is not None
            and mapped(m, "p1^2 + q2", "p1", SAME | {"u": "1"}, target=target) is None)


def empty(*terms, zeros=()):
    return {"node": "empty", "terms": list(terms), "zeros": list(zeros)}


def names(m):
    """Roots and values are functions of the parameters; each name has one value"""
    root = {"name": "r", "square": "2"}
    h = "p1^2 + q1*q2"

    def accepts(*rows, **more):
        return mapped(m, more.pop("x", h), more.pop("y", h), adjoined=rows, **more) is not None
    idle = empty(["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]])
    zero = {"name": "v", "inverse": "0", "times": "0", "norm": "0", "by": idle}
    one = zero | {"inverse": "a", "times": "1", "norm": "a"}
    contradiction = [("-a", "positive")]
    one_y = {"h": "p1^2 + b", "parameters": ["b"], "assumed": []}
    pair = {"h": "p1^2 + q1^2", "coordinates": ["q1", "p1"], "brackets": CANONICAL[:1]}
    more = {"h": "p1^2 + q1^2 + p2^2", "coordinates": ["q1", "p1", "q2", "p2"]}
    f = mapped(m, h, h)
    turned = mapped(m, "q1 + q2", {"h": "q1 + q2", "coordinates": ["q2", "q1", "p2", "p1"]}, back=[ONE[i] for i in (1, 0, 3, 2)])
    return (accepts(root) and not accepts(root | {"square": "q1"}) and accepts(root, at={"a": "2"})
            and not accepts(root | {"name": "a"}, at={"a": "2"})
            and accepts(one, region=contradiction) and not accepts(zero, region=contradiction)
            and refused(m, lambda: f.constant(f.tower.read("a*q1"))) and not refused(m, lambda: f.constant(f.tower.read("a + 2")))
            and accepts(values=SAME | {"b": "a^2"}, x="p1^2 + a^2", y=one_y)
            and not accepts(values=SAME | {"b": "q1"}, x="p1^2 + q1", y=one_y)
            and not accepts(values={"q1": "q1", "q2": "q2", "p1": "p1"})
            and not accepts(values={"q1": "q1", "q2": "q2", "p1": "p1", "z": "p2"})
            and not accepts(values=SAME | {"z": "p2"}) and not accepts(
                x=pair, y=more, values={"q1": "q1", "p1": "p1", "q2": "0", "p2": "0"}, back=diagonal(["1", "1"]))
            and turned is not None and refused(m, lambda: turned.need_level("q1 + q2")) and not refused(m, lambda: f.need_level("q1 + q2")))


def shown(m):
    """What is assumed of the parameters of Y, of c in the place of its only one (M4); a > 0 is given, and b is free, r^2 = a, s^2 = -a"""
    ready(m)
    map, multivariate, Function = m["map"].Map, m["multivariate"], m["phase_space"].Function
    t = m["tower"].Tower({"a": 0, "b": 32})
    t.adjoin("r", square=t.read("a"))
    t.adjoin("s", square=t.read("-a"))

    def accepts(value, *conditions, rows=(), given=(("a", "positive"),)):
        ready(m)
        x = object.__new__(map)
        free = {"a": 0, "b": 32}
        x.tower, x.constants, x.values, x.by_name = t, set(t.names.values()), {0: t.read(value)}, False
        x.here = SimpleNamespace(free=free)
        x.given = m["condition"].ConditionSet(free).also(*((multivariate.parse(f, free), sign) for f, sign in given))

        def of(f):
            return [of(g) for g in f] if isinstance(f, list) else Function(multivariate.parse(f, {"c": 0}))
        x.target = SimpleNamespace(conditions=[(of(f), sign) for sign, f in conditions])
        return not refused(m, lambda: x.need_shown(rows))

    def row(over, value, by, square=None):
        return {"over": over, "value": value, "by": by} | ({"square": square} if square else {})
    # the negation is condition 1
    sums, squares = empty(["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]), empty(["1", "1", ["0", "2"]], zeros=[["1", "1"]])
    over_1, square = SHOWN, empty(["1", "1", ["0", "2"]], ["1", "1", ["1", "1"]])
    # a or b is not 0; condition 1 is that a = 0
    chosen = {"chosen": [["0", "1", "a"]], "by": empty(["1", "1", ["0", "1"]], zeros=[["1", "-1"]])}
    of_b, b_twice = row("b", "a*b^2", empty(["1", "b", ["0", "1"]], ["1", "1", ["1", "1"]])), empty(["1", "b"], ["1", "1", ["1", "1"]])
    positive, real, nonzero = ("positive", "c"), ("real", "c"), ("nonzero", "c")
    right = row("1", "a", sums)
    return (accepts("a", positive, rows=[right]) and not accepts("a", positive) and not accepts("a", positive, rows=[right] * 2)
            and not accepts("2*a", positive, rows=[right]) and not accepts("a", positive, rows=[row("1", "a", squares)])
            and accepts("r^2", ("zero", "c")) is False and accepts("r^2 - a", ("zero", "c")) and not accepts("r^2 + a", ("zero", "c"))
            and accepts("r^2 - a", ("zero", "c"), positive, rows=[right]) is False and accepts("r^2 + s^2", ("zero", "c"), ("zero", "2*c"))
            # a square: of what is real, if it is positive
            and accepts("r", real, rows=[row("1", "a", sums, True)]) and not accepts("s", real, rows=[row("1", "-a", over_1, True)])
            and not accepts("r", real, rows=[row("1", "2*a", sums, True)])
            and not accepts("-a", positive, rows=[row("1", "a^2", square, True)])
            and accepts("s", nonzero, rows=[row("1", "-a", empty(["1", "1", ["0", "1"]], zeros=[["1", "1"]]), True)])
            and accepts("a", nonzero, rows=[row("1", "a^2", empty(["1", "1", ["0", "2"]], zeros=[["1", "-1"]]), True)])
            and not accepts("a", nonzero, rows=[row("1", "2*a", empty(["2", "1", ["0", "1"]], zeros=[["1", "-1"]]), True)])
            and accepts("b", real, rows=[row("1", "b", over_1)]) and accepts("-a", nonzero, rows=[row("a", "-a^3", empty(
                ["1", "1", ["0", "3"]], zeros=[["1", "1"]]))])
            # c b^2 = a b^2 >= 0 says nothing where b = 0
            and not accepts("a", ("nonnegative", "c"), rows=[of_b]) and accepts("a", ("nonnegative", "c"), rows=[right])
            and accepts("b^2", ("nonnegative", "c"), rows=[row("1", "b^2", b_twice)])
            and not accepts("b^2", positive, rows=[row("1", "b^2", b_twice)])
            and accepts("a", ("some", ["c", "c - 1"]), rows=[chosen]) and accepts("a", ("some", ["c"]), rows=[chosen])
            and not accepts("b", ("some", ["c"]), rows=[chosen]) and not accepts("a", ("some", ["c"]))
            and not accepts("a", ("some", ["c - 1", "c"]), rows=[chosen])
            and not accepts("a", ("some", ["c"]), rows=[chosen | {"by": sums}])
            and accepts("b", ("some", ["c"]), rows=[{"chosen": [["0", "1", "b"]], "by": SHOWN}]) is False
            and all(not accepts("a", ("some", ["c"]), rows=[chosen | {"chosen": [v]}]) for v in (
                ["0", "1"], ["0", "1", "a", "a"], ["1", "1", "a"], ["-1", "1", "a"], ["0", "1", "2*a"])))


def reading(m):
    """Systems and steps of a theorem"""
    ready(m)
    one = {"name": "X", "parameters": [], "assumptions": [],
           "system": {"coordinates": ["q", "p"], "hamiltonian": "p^2", "brackets": [["q", "p", "1"]]}}
    step = {"rule": "literature", "id": "n", "system": "X", "theorem": "Ziglin 1983"}
    read_theorem = m["theorem"].read_theorem

    def accepts(*systems, steps=(step,)):
        top = {"format": "kovacic-theorem/1", "title": "", "systems": list(systems), "steps": list(steps)}
        return not refused(m, lambda: read_theorem(top))

    def system(**more):
        d = {k: v for k, v in (one["system"] | more).items() if v is not None}
        return accepts(one | {"system": d})
    by_values = {"rule": "place", "id": "n", "of": "m", "system": "X", "at": [], "region": [], "shown": [], "adjoined": [], "values": {},
                 "back": [], "bracket": ["1", "1"], "energy": ["1", "1"]}
    gradient = {"name": "s", "meaning": "", "gradient": {"q": "1"}}
    return (accepts(one) and accepts(one, one | {"name": "Y"}) and not accepts(one, one) and accepts() and not accepts(one, steps=[])
            and system(inverses=[{"name": "u", "of": "q"}]) and system(functions=[], relations=[]) and system(functions=[gradient])
            and system(relations=["q"]) and not system(field=["1", "1"]) and not system(hamiltonian=None) and not system(brackets=None)
            and system(hamiltonian=None, brackets=None, field=["1", "1"]) and not system(coordinates=["q", "q"])
            and not any(accepts(one, steps=[v]) for v in (step | {"rule": "faith"}, step | {"rule": ["literature"]}, step | {"rule": None},
                                                          step | {"more": "1"}, "literature", None))
            and accepts(one, steps=[by_values]) and not accepts(one, steps=[by_values | {"levels": [["h", "1"]]}])
            and all(refused(m, lambda v=v: m["map"].read_adjoined(v)) for v in (None, True, "square", ["square"], {"square": "2"}))
            and not refused(m, lambda: m["map"].read_adjoined({"name": "r", "square": "2"})))


def properties():
    """(name, function, True)"""
    return [(f"a_place.{f.__name__}", f, True) for f in (systems, inverses, unused, names, shown, reading)]
