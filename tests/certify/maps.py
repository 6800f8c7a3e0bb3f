"""Properties of map.py of the Python checker: functions of its modules (sys.modules) that are True.  Linear maps between small
systems; whole theorems take longer than a mutant is given."""
from lowest import CANONICAL, family, refused

TWO = {"name": "v", "inverse": "2", "times": "1", "norm": "2",
       "by": {"node": "empty", "terms": [["2", "1"]], "zeros": [["1", "-1"]]}}
SCALED = {"q1": "2*q1 + a", "q2": "3*q2", "p1": "3*p1", "p2": "2*p2"}
INVERSE = [["1", "2"], ["1", "3"], ["1", "3"], ["1", "2"]]
H, OF_SCALED = "p1^2 + 2*p2^2 + q1^3 + q2", "9*p1^2 + 8*p2^2 + 8*q1^3 + 12*q1^2*a + 6*q1*a^2 + a^3 + 3*q2"


def diagonal(entries):
    return [[x if i == j else "0" for j in range(len(entries))] for i, x in enumerate(entries)]


def mapped(m, x, y, values, back, bracket, energy=("1", "1"), adjoined=(), conditions=None, shown=()):
    """The Map of a system x to a system y without parameters, or None if it is refused"""
    m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000
    found = []

    def make():
        X, Y = family(m, x), family(m, **({"parameters": [], "assumed": []} | (y if isinstance(y, dict) else {"h": y})))
        target = m["family"].Target(Y.space, Y.parameters, conditions(Y) if conditions else [])
        d = {"adjoined": list(adjoined), "values": values, "back": back, "bracket": list(bracket), "energy": list(energy),
             "shown": list(shown)}
        schema = {key: m["map"].MAP[key] for key in ("bracket", "energy")}
        d |= m["certificate_format"].read(schema, {key: d[key] for key in schema}, "units")
        found.append(m["map"].Map(m["family"].Here(X), target, d))
    return None if refused(m, make) else found[0]


def linear(m):
    six = ["6", ["1", "6"]]

    def accepts(values=(), back=None, bracket=six, x=OF_SCALED, y=H, **more):
        return mapped(m, x, y, SCALED | dict(values), back or diagonal(INVERSE), bracket, **more) is not None
    rows = diagonal(INVERSE)
    other = {"h": H, "brackets": [["q1", "p1", "2"], ["q2", "p2", "2"]], "parameters": [], "assumed": []}
    uneven = {"h": H, "brackets": [["q1", "p1", "1"], ["q2", "p2", "2"]], "parameters": [], "assumed": []}
    one = {"h": "p1^2 + q1", "coordinates": ["q1", "p1"], "brackets": CANONICAL[:1], "parameters": [], "assumed": []}
    return (accepts() and not accepts({"q2": "3*q2 + q1"}) and not accepts({"q1": "2*q1"}) and not accepts({"q1": "2*q1^2 + a"})
            and not accepts({"p1": "-3*p1"}) and not accepts({"p1": "3*p2", "p2": "2*p1"}) and not accepts({"z": "1"})
            and not accepts(back=diagonal(["1"] * 4)) and not accepts(back=diagonal(INVERSE[1:] + INVERSE[:1])) and not accepts(back=rows[:3])
            and not accepts(back=[*rows, rows[0]]) and not accepts(back=[[*row, "0"] for row in rows]) and not accepts(back=[
                [*rows[0], "0"], *rows[1:]]) and not accepts(back=[["q1", *rows[0][1:]], *rows[1:]])
            and not accepts(bracket=["5", ["1", "5"]]) and not accepts(bracket=["6", ["1", "5"]]) and not accepts(bracket=[*six, "1"])
            and not accepts(bracket=["6"]) and not accepts(bracket=["1", "1"]) and accepts(y=other, bracket=["3", ["1", "3"]])
            and not accepts(y=uneven) and not accepts(x=OF_SCALED + " + 1") and not accepts(x="2*p1^2")
            and accepts(x=[OF_SCALED, "2"], energy=[["1", "2"], "2"]) and not accepts(x=[OF_SCALED, "2"], energy=["2", ["1", "2"]])
            and not accepts(x=[OF_SCALED, "2"], energy=[["1", "2"], "1"]) and not accepts(energy=["q1", "1"])
            and mapped(m, OF_SCALED, one, {"q1": "2*q1 + a", "p1": "3*p1"}, rows, six) is None)


def adjoined(m):
    r, values = {"name": "r", "square": "2"}, {"q1": "r*q1", "q2": "r*q2", "p1": "r*p1", "p2": "r*p2"}
    half = [["r", "2"]] * 4

    def accepts(*rows, values=values, back=half, x="2*p1^2 + 2*q1*q2", bracket=("2", ["1", "2"])):
        return mapped(m, x, "p1^2 + q1*q2", values, diagonal(back), bracket, adjoined=rows) is not None
    by_v = {"q1": "v*q1", "q2": "v*q2", "p1": "2*p1", "p2": "2*p2"}

    def inverse(*rows):
        return accepts(*rows, values=by_v, back=["2", "2", "v", "v"], x=["16*p1^2 + q1*q2", "4"], bracket=("1", "1"))
    return (accepts(r) and not accepts() and not accepts(r | {"square": "3"}) and not accepts(r | {"square": "q1"}) and not accepts(r, r)
            and not accepts(r | {"name": "q1"}) and accepts(r, {"name": "s", "square": "r + a"}) and inverse(TWO) and not inverse()
            and not inverse(TWO | {"inverse": "3"}) and not inverse(TWO | {"norm": "3"}) and not inverse(TWO | {"times": "2"})
            and not inverse(TWO | {"by": {"node": "empty", "terms": [["1", "1"]], "zeros": [["1", "-1"]]}})
            and not inverse(TWO | {"inverse": "0", "norm": "0"}) and not inverse(TWO | {"inverse": "q1"}))


def texts(m):
    """What is stated of a map, whether it moves the origin, and levels"""
    one = diagonal(["1"] * 4)
    same = {x: x for x in ("q1", "q2", "p1", "p2")}
    f = mapped(m, OF_SCALED, H, SCALED, diagonal(INVERSE), ["6", ["1", "6"]])
    g = mapped(m, "p1^2 + q1^2", "p1^2 + q1^2", same, one, ["1", "1"])
    h = mapped(m, "p1^2 + q1^2", "p1^2 + q1^2", same | {"q1": "-q1", "p1": "-p1"}, diagonal(["-1", "1", "-1", "1"]), ["1", "1"])
    k = mapped(m, ["p1^2", "4"], "p1^2", same | {"p1": ["p1", "2"], "q1": "2*q1"}, diagonal([["1", "2"], "1", "2", "1"]), ["1", "1"])
    r = mapped(m, "p1^2", "p1^2", same, one, ["1", "1"], adjoined=[{"name": "r", "square": "a"}, TWO])
    if not (f and g and h and k and r):
        return False
    exchanged = mapped(m, "p1^2 + p2^2", "p1^2 + p2^2", {"q1": "q2", "q2": "q1", "p1": "p2", "p2": "p1"},
                       [["0", "1", "0", "0"], ["1", "0", "0", "0"], ["0", "0", "0", "1"], ["0", "0", "1", "0"]], ["1", "1"])
    return (f.shown() == ["its names: q1 = 2*q1 + a, q2 = 3*q2, p1 = 3*p1, p2 = 2*p2"] and g.shown() == [] and f.affine and not g.affine
            and h.shown() == ["its names: q1 = -q1, p1 = -p1"] and k.shown() == ["its names: q1 = 2*q1, p1 = (p1)/2"]
            and r.shown() == ["where r^2 = a, v = 1/(2)"]
            and exchanged is not None and exchanged.shown() == ["its names: q1 = q2, q2 = q1, p1 = p2, p2 = p1"]
            and not refused(m, lambda: h.need_level("q1*q2 + p1*p2")) and not refused(m, lambda: h.need_level("q2"))
            and refused(m, lambda: h.need_level("q1 + q2")) and refused(m, lambda: f.need_level("q2")))


def by_names(m):
    """Y is X, with a level h more; what is asked of h holds for some value, or for the one that is given."""
    h, idle = "p1^2 + p2^2 + a*q1^2", {"node": "empty", "terms": [["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]], "zeros": []}
    one = {"node": "empty", "terms": [["1", "1"]], "zeros": [["2", "-1"]]}          # the second part is 1

    def accepts(*asked, rows=(), levels=(), x=h, y=h, brackets=None, names=("a", "h")):
        m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000
        parse, Function = m["multivariate"].parse, m["phase_space"].Function

        def make():
            X, Y = family(m, x), family(m, y, parameters=names, assumed=(), brackets=brackets)
            asked_of = [([Function(parse(f, Y.names)) for f in p] if isinstance(p, tuple) else Function(parse(p, Y.names)), says) for p, says in asked]
            at = {name: Function(parse(f, X.names)) for name, f in dict(levels).items()}
            m["map"].Map(m["family"].Here(X), m["family"].Target(Y.space, Y.parameters, asked_of),
                         {"levels": at, "shown": list(rows)})
        return not refused(m, make)
    some = ("h^2 + a*h", "nonzero")
    return (accepts() and not accepts(y=h + " + q1") and not accepts(y="p1^2 + p2^2 + h*q1^2") and not accepts(names=("a", "b", "q"), y=h + " + b")
            and not accepts(brackets=[["q1", "p1", "1"], ["q2", "p2", "2"]])
            and accepts(some, rows=[one]) and not accepts(some) and not accepts(some, rows=[one, one])
            and not accepts(some, rows=[{**one, "zeros": []}]) and not accepts(("h - a", "zero"), rows=[one])
            and accepts(("h", "positive"), ("a", "real"), ("h", "real")) and accepts(("2*h + 3", "nonnegative"))
            and not accepts(("h", "positive"), ("h - 1", "nonnegative")) and not accepts(("h^2 + 1", "positive"))
            and not accepts(("h*a", "positive"), rows=[idle]) and accepts(("a", "positive"), rows=[idle])
            and accepts((("h^2", "a*h"), "some"), rows=[{**one, "zeros": [["1", "-1"]]}]) and not accepts((("h^2", "a*h"), "some"), rows=[idle])
            and accepts(("h", "positive"), rows=[idle], levels={"h": "a"}) and not accepts(("h", "positive"), rows=[idle], levels={"h": "-a"})
            and not accepts(("h", "positive"), levels={"h": "a"}) and not accepts(levels={"k": "a"}) and not accepts(levels={"a": "a"})
            and not accepts(levels={"q1": "a"}) and accepts(y="p1^2 + p2^2 + h*q1^2", levels={"h": "a"})
            and not accepts(y="p1^2 + p2^2 + h*q1^2", levels={"h": "2*a"}))


def roots(m):
    """Conditions on a root r of a, as conditions on a: for both values, or refused"""
    names = {"a": 0, "r": m["multivariate"].FIELD}

    def parse(text):
        m["multivariate"].Work.left = 10**6
        return m["multivariate"].parse(text, names)

    def without(text, sign, n=1):
        found = []
        square = m["phase_space"].Function(parse("a"), n)
        if refused(m, lambda: found.extend(m["map"].without_root(parse(text), sign, names["r"], square))):
            return None
        return [(p, says) for p, says in found]
    even = [("positive", "2*a*r^2 + r^4 - 3", "3*a^2 - 3"), ("zero", "r^2", "a"), ("nonzero", "5", "5")]
    return (all(without(f, sign) == [(parse(g), sign)] for sign, f, g in even)
            and without("a + 1 + 2*r + r^3", "zero") == [(parse("a + 1"), "zero"), (parse("a + 2"), "zero")]
            and without("a + 1 + 2*r", "nonzero") == [(parse("a^2 - 2*a + 1"), "nonzero")]
            and all(without(f, sign) is None for f in ("r", "a + r", "r^3 + 1") for sign in ("positive", "nonnegative"))
            and without("r^2", "zero", 2) is None)


def properties():
    """(name, function, True)"""
    return [(f"maps.{f.__name__}", f, True) for f in (linear, adjoined, texts, by_names, roots)]
