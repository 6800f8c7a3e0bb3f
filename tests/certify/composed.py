"""Properties of theorem.py of the Python checker: functions of its modules (sys.modules) that are True.  Each rule makes a Fact of
facts that are put there, so that nothing else of a theorem has to be paid for."""
import copy
from types import SimpleNamespace
from typing import NamedTuple

from lowest import CANONICAL, SHOWN, family, refused
from maps import diagonal

NAMES = ("q1", "q2", "p1", "p2")
ONE, SAME = diagonal(["1"] * 4), {x: x for x in NAMES}
FREE = {"parameters": [], "assumed": []}
MOVED = {"system": "X", "at": None, "region": None}
SPACE = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"]


class Class(NamedTuple):
    """As first_integrals.IntegralClass, by itself: the checker that is tested may be a mutant."""
    kind: str = "meromorphic"
    place: str = "curve"
    on_leaf: bool = False
    functions: tuple = ()
    without: tuple = ()
    through: tuple = ()
    frame: str = ""
    liouville: bool = True

    def sentence(self):
        return f"{self.kind} {self.place}"

    def contains(self, _):
        return False

    def has_rational(self):
        return self.kind == "meromorphic" and self.place != "level" and not self.on_leaf and not self.without


NEAR, LEAVES, ORIGIN, LEAF = Class(), Class(place="level"), Class(place="origin"), Class(on_leaf=True)
REAL = Class("real-analytic", "phase space")


def ready(m):
    m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000


def theorem(m, families=(), **facts):
    """A Theorem with these families and facts, and no steps"""
    ready(m)
    t = object.__new__(m["theorem"].Theorem)
    t.families, t.led, t.prove = dict(families), set(), None
    known(m, t, **facts)
    return t


def known(m, t, **facts):
    """Nothing else"""
    t.facts = m["core"].Facts()
    for name, said in facts.items():
        t.facts.derive(name, said)


def derived(t, said):
    return t.facts.derive("derived", said)


def fact(m, kind, family, region=(), classes=(), integrals=(), used=(), **more):
    """That rests on nothing, of one region"""
    return m["core"].Said(kind, family, [region], classes, integrals, used, **more)


def a_map(**more):
    return {"adjoined": [], "values": SAME, "back": ONE, "bracket": ["1", "1"], "energy": ["1", "1"], "shown": []} | more


def facts(m):
    """What a step may name; a fact has what its premises have, those that were looked at since the one before"""
    ready(m)
    y = family(m, "p1^2 + q1")
    t = theorem(m, {"Y": y}, n=fact(m, "N", y), s=fact(m, "S", y))
    return (t.fact("n", "N", "I").kind == "N" and t.facts.named == {"n"} and t.fact("s", "S").kind == "S" and t.facts.named == {"n", "s"}
            and refused(m, lambda: t.fact("s", "N", "I")) and refused(m, lambda: t.fact("n", "S")) and t.family({"system": "Y"}) is y
            and united(m))


def united(m):
    t = theorem(m, a=fact(m, "N", None, used=["A"], trusts=["on trust"]), b=fact(m, "N", None, used=["B"], only_stratum=True))
    alone = derived(t, fact(m, "N", None, used=["C"], trusts=["too"]))
    t.facts.premise("a"), t.facts.premise("b")
    both, none = fact(m, "N", None, used=["C"]), fact(m, "N", None)
    first, second = derived(t, both), derived(t, none)
    return (both is not first and (alone.used, alone.trusts, alone.only_stratum) == ({"C"}, {"too"}, False)
            and (first.used, first.trusts, first.only_stratum) == ({"A", "B", "C"}, {"on trust"}, True)
            and (second.used, second.trusts, second.only_stratum) == (set(), set(), False) and "a" in t.facts and "c" not in t.facts
            and refused(m, lambda: t.facts.premise("c")))


def certificates(m):
    """A certificate is one of a system, without trust, about all of it, and its class of integrals is one of (5)"""
    ready(m)
    module = m["rule_certificate"]
    real = module.system, module.read_system, module.integrals, module.Shown
    space = family(m, "p1^2 + q1^3", **FREE).space
    curve = SimpleNamespace(space=space, variable="z")
    top = {"format": real[0].FORMAT, "parameters": [], "title": "a title", "claim": {"not_integrable": True},
           "curve": {"denominators": ["z^2 - 3"]}, "equation": {"certificate": {"format": "kovacic-certificate/1"}}}

    def accepts(top, said=NEAR, trust=0, space=space):
        curve.space = space
        no = not trust and top["claim"]["not_integrable"]
        inner = SimpleNamespace(trust=trust, denials=[SimpleNamespace(whole=False, path=(), trust=0)] if no else [], criteria=[])
        module.system = SimpleNamespace(FORMAT=real[0].FORMAT, accept=lambda top, prove: (curve, [], inner))
        module.read_system, module.integrals = (lambda d: d), (lambda curve, denials, casimirs: said)
        module.Shown = lambda curve: SimpleNamespace(phase_curve=lambda top: "a curve", functions_explained=lambda: ([], ()))
        t = theorem(m)
        found = []
        if refused(m, lambda: found.append(t.said("certificate", {"certificate": top}))):
            return None
        f, = found
        one = (f.kind, f.family, f.regions[0], f.classes, f.way) == ("N", None, [], [said], ['a curve of "a title"'])
        return one and f.target.conditions[0][1] == "some" and (f.used, f.only_stratum)
    try:
        without = SimpleNamespace(**vars(space) | {"brackets": None})
        anywhere, stratum = ({"Morales-Ramis"}, False), ({"Morales-Ramis"}, True)
        return (accepts(top) == anywhere and accepts(top, trust=1) is None and accepts(top, trust=2) is None
                and accepts(top | {"claim": {"not_integrable": False}}) is None and accepts(top | {"format": "kovacic-system/2"}) is None
                and accepts(top, Class(functions=("q1",))) == stratum and accepts(top, Class(without=("t",))) == stratum
                and accepts(top, LEAF) == anywhere and accepts(top, space=without) == ({"Ayoul-Zung"}, True))
    finally:
        module.system, module.read_system, module.integrals, module.Shown = real


def a_leaf(m):
    """A leaf of a certificate has its own conditions and class, what the certificate has besides, and no trust"""
    ready(m)
    target = SimpleNamespace(space="X", parameters=["a"], conditions=[("a", "real")], curve="a curve")
    module = m["rule_certificate"]
    real, module.Target = module.Target, lambda *given: SimpleNamespace(given=given)
    try:
        there = [module.Target("X", ["a"], [("a", "real"), ("a", sign)], "a curve") for sign in ("zero", "nonzero")]
        leaves = [(there[0], 1, lambda: NEAR), (there[1], 0, lambda: LEAF)]
        t = theorem(m, c=fact(m, "L", None, classes=[NEAR], used=["a theorem"], way=["a way"], only_stratum=True, target=target, leaves=leaves,
                              there=["s = 0"], names={"s"}), y=fact(m, "N", None), i=fact(m, "I", None, leaves=leaves))

        def said(of, k):
            found = []
            if refused(m, lambda: found.append(derived(t, t.said("leaf", {"of": of, "leaf": k})))):
                return None
            f, = found
            return (f.kind, f.classes, f.used, f.way, f.only_stratum, f.there, f.names, f.target.given, f.leaves)
        right = ("N", [LEAF], {"a theorem"}, ["a way"], True, ["s = 0"], {"s"},
                 ("X", ["a"], [("a", "real"), ("a", "nonzero")], "a curve"), [])
        return (said("c", 1) == right and said("c", 0) is None and said("c", 2) is None and said("c", -1) is None and said("y", 0) is None
                and said("i", 1) is None)
    finally:
        module.Target = real


def asked(m):
    """The conditions of a point, in their order"""
    ready(m)
    field = m["multivariate"].FIELD
    curve = SimpleNamespace(space=SimpleNamespace(at={"a": 0, "b": field, "q1": 2 * field}), variable="z")
    inner = {"format": m["strata"].FORMAT, "parameters": ["a", "b"], "real": ["b"], "assumptions": [{"p": "a*b^2", "sign": "positive"}],
             "generic": [["a", "b - 2"], ["a - b"]], "variable": "z", "r": {"num": "z", "den": "a*z^2 + 3*b"}}
    denominators = ["b*z + 5"]

    def said(inner=inner, denominators=denominators, **more):
        top = {"parameters": ["a", "b"], "equation": {"certificate": inner | more}, "curve": {"denominators": denominators}}
        found = []
        if refused(m, lambda: found.extend(m["rule_certificate"].asked(top, curve))):
            return None
        return [(sign, [dict(f.p) for f in v] if isinstance(v, list) else dict(v.p)) for v, sign in found]
    a, b = 1, 1 << field
    right = [("real", {b: 1}), ("positive", {a + 2 * b: 1}), ("some", [{a: 1}, {b: 1, 0: -2}]), ("some", [{a: 1, b: -1}]),
             ("some", [{b: 3}, {}, {a: 1}]), ("some", [{0: 5}, {b: 1}])]
    return (said() == right and said(parameters=["a"]) == right and said(parameters=["a", "c"]) is None
            and said(parameters=["a", "b", "q1"]) is None and said(memberships=[1]) is None and said(rational=["a"]) is None
            and said(memberships=[], rational=[]) == right and said({"format": "kovacic-certificate/1"}) == right[-1:]
            and said({"format": "kovacic-certificate/1"}, []) == [] and said({"format": "kovacic-certificate/1"}, ["0"]) == [("some", [{}])])


def literature(m):
    """Ziglin's theorem is about this system only"""
    known = m["theorem_statement"].SYMMETRIC_TOP

    def accepts(change=lambda d: None, name="Ziglin 1983"):
        d, found = copy.deepcopy(known), []
        change(d)
        t = theorem(m, {"Y": m["family"].Family(d)})
        if refused(m, lambda: found.append(t.said("literature", {"system": "Y", "theorem": name}))):
            return False
        f, = found
        return (f.kind, f.family, f.regions[0], f.classes, f.used) == ("N", t.families["Y"], [], [LEAVES], {"Ziglin 1983"})

    def put(key, value):
        return lambda d: d["system"].__setitem__(key, value)

    def renamed(x, y):
        def change(d):
            d["system"] = {key: eval(repr(v).replace(x, y)) for key, v in d["system"].items()}
        return change
    h = known["system"]["hamiltonian"]
    # of M1, M2/2, M3/2 and Gamma: the same polynomials, over 1, 2 and 4
    over = [[i, j, [f, str(2 ** ((i in ("M2", "M3")) + (j in ("M2", "M3") and i != "M1"))) if i != "M1" else "1"]]
            for i, j, f in known["system"]["brackets"]]
    return (accepts() and not accepts(name="Ziglin 1980") and not accepts(renamed("M1", "N1"))
            and not accepts(put("hamiltonian", [h[0], "3"])) and not accepts(put("hamiltonian", [h[0] + " + Gamma3*u1*u2*A*C", "2"]))
            and not accepts(lambda d: d["assumptions"].pop()) and not accepts(lambda d: d["assumptions"].append({"p": "L3", "sign": "zero"}))
            and not accepts(put("inverses", [{"name": "u1", "of": "C^2"}, {"name": "u2", "of": "A"}]))
            and not accepts(put("brackets", over))
            and not accepts(put("brackets", [[i, j, "-" + f if f[0] != "-" else f[1:]] for i, j, f in known["system"]["brackets"]])))


def integrals(m):
    """A first integral, or one on a level, with a cofactor for each function of the level"""
    t = theorem(m, {"Y": family(m, "p1*p2 + q1*q2", **FREE), "Z": family(m, "p1^2 + p2^2 + q1^2*q2", **FREE)})

    def accepts(system, level, *claims):
        found = []
        d = {"system": system, "level": level, "claims": [dict(zip(("name", "value", "cofactors"), c)) for c in claims]}
        if refused(m, lambda: found.append(t.said("integrals", d))):
            return False
        f, = found
        (y, lines, on), = f.integrals
        return (f.kind, f.family, f.regions[0], f.classes, f.used, y) == ("I", y, [], [], set(), t.families[system]) and (
            [x for x, _ in lines], len(on)) == ([c[0] for c in claims], len(level))
    f = ("F", "p1^2 + q2^2", [])
    return (accepts("Y", [], f) and accepts("Y", [], f, ("G", "p2^2 + q1^2", [])) and not accepts("Y", [])
            and not accepts("Y", [], ("F", "p1^2 - q2^2", [])) and not accepts("Y", [], f, ("G", "p2^2", []))
            and not accepts("Y", [], ("F", "p1^2 + q2^2", ["1"])) and not accepts("Y", ["p1^2 + q2^2"], f)
            and accepts("Y", ["p1^2 + q2^2"], ("F", "p1^2 + q2^2", ["0"])) and not accepts("Z", ["q1"], ("F", "p1", ["-2*q2"]))
            and not accepts("Z", ["p1"], ("F", "p1", ["0"])) and not accepts("Y", ["p1^2 + q2^2"], ("F", "p1", ["1"]))
            and not accepts("Y", ["p1^2 + q2^2"], ("F", "p1^2 + q2^2", ["0", "0"])))


def on_a_level(m):
    """q1 is constant where p2 = 0"""
    t = theorem(m, {"Y": family(m, "p1*p2", **FREE)})

    def accepts(value, cofactors, level):
        d = {"system": "Y", "level": level, "claims": [{"name": "F", "value": value, "cofactors": cofactors}]}
        return not refused(m, lambda: t.said("integrals", d))
    return (accepts("q1", ["1"], ["p2"]) and not accepts("q1", [], []) and not accepts("q1", ["-1"], ["p2"]) and not accepts("q1", ["1"], ["q2"])
            and accepts("q1 + q2", ["1", "1"], ["p1", "p2"]) and not accepts("q1 + 2*q2", ["1", "2"], ["p1", "p2"])
            and not accepts("q1", ["0"], ["q1"]) and not accepts("p1", ["0"], ["q1"]))


def places(m):
    """N and I of Y, at X"""
    ready(m)
    y = family(m, "p1^2 + p2^2 + q1^3*a")
    h = "p1^2 + p2^2 + q1^3*a"
    shown = {"over": "1", "value": "a", "by": {"node": "empty", "terms": [["1", "1", ["0", "1"]], ["1", "1", ["1", "1"]]], "zeros": []}}
    real = {"over": "1", "value": "a", "by": SHOWN}
    values = SAME | {"a": "a"}

    def place(of, x=h, *, parameters=("a",), assumed=("a",), **more):
        found, x = [], family(m, x, parameters=parameters, assumed=assumed)
        t = theorem(m, {"X": x}, of=of)
        d = {"system": "X", "of": "of", "at": [], "region": []} | a_map(values=values, shown=[real, shown]) | more
        return None if refused(m, lambda: found.append(derived(t, t.said("place", d)))) else found[0]
    n = fact(m, "N", y, [], [NEAR], (), ["Morales-Ramis"], way=["the curve"])
    near, leaves = fact(m, "N", y, [], [NEAR, ORIGIN]), fact(m, "N", y, [], [LEAVES])
    f, moved = place(n), "p1^2 + p2^2 + q1^3*a + 3*q1^2*a + 3*q1*a + a"
    there = {"values": values | {"q1": "q1 + 1"}}
    g = place(n, moved, **there)
    twice = {"parameters": ("a", "b"), "at": [["b", "2"], ["b", "3"]]}
    once = place(n, h, parameters=("a", "b"), at=[["b", ["2", "3"]]], region=[{"p": "a - b", "sign": "nonzero"}], shown=[
        {**real, "by": {**SHOWN, "zeros": [["2", "-1"]]}}, {**shown, "by": {"node": "empty", "terms": [["1", "1", ["0", "1"]], ["1", "1", ["2", "1"]]], "zeros": []}}])
    if not (f and g and once):
        return False
    one = (f.kind, f.family.name, f.regions[0], f.classes, f.used, f.way) == ("N", "X", [], [NEAR], {"Morales-Ramis"}, ["the curve"])
    b = once.family.names["b"]
    return (one and g.way == ["the curve", "its names: q1 = q1 + 1"] and place(near) and place(near, moved, **there) is None
            and once.regions[0][0] == ({1 << b: 3, 0: -2}, "zero") and once.regions[0][1][1] == "nonzero" and len(once.regions[0]) == 2
            and place(n, h, **twice) is None and place(fact(m, "S", y)) is None and place(leaves) is None
            and all(place(fact(m, "N", y, [], [Class(**{what: names})])) is None
                    for what, names in (("functions", ("e",)), ("through", ("q1",)), ("frame", "f")))
            and place(fact(m, "N", y, [], [NEAR], only_stratum=True)) is None
            and [place(fact(m, "N", y, [], [NEAR], shows_way=shows)).shows_way for shows in (True, False)] == [True, False])


def levels(m):
    """On the leaves with F2 = 0 of a top; Gamma -> 2 Gamma changes F2"""
    top = m["theorem_statement"].SYMMETRIC_TOP["system"]["brackets"]
    one = diagonal(["1"] * 6)

    def of(classes, factor, sign="", step="place"):
        y = family(m, "M1^2 + 2*M2^2 + Gamma3^2", brackets=top, coordinates=SPACE, **FREE)
        x = family(m, f"M1^2 + 2*M2^2 + {factor * factor}*Gamma3^2", brackets=top, coordinates=SPACE, **FREE)
        t = theorem(m, {"X": x, "Y": y}, of=fact(m, "N", y, [], classes))
        values = {v: v for v in SPACE} | {f"Gamma{i}": f"{sign}{factor}*Gamma{i}" for i in (1, 2, 3)}
        back = diagonal(["1"] * 3 + [[f"{sign}1", str(factor)]] * 3)
        d = {"system": "X", "of": "of", "at": [], "region": []} | a_map(values=values, back=back)
        return not refused(m, lambda: t.said("place", d))
    return (of([NEAR], 2) and not of([LEAVES], 2) and not of([NEAR, LEAVES], 2) and of([LEAVES], 1) and of([LEAVES], 1, "-")
            and len(one) == 6)


def functions(m):
    ready(m)
    f, names = m["phase_space"].Function.read, {"a": 0}

    def fails(v):
        try:
            return refused(m, lambda: f(v, names))
        except (TypeError, AttributeError, ValueError):
            return False
    g, h = f("2*a", names), f(["a + 1", "3"], names)
    return (dict(g.p), g.n, dict(h.p), h.n) == ({1: 2}, 1, {1: 1, 0: 1}, 3) and f(["a", "1"], names).n == 1 and all(
        map(fails, (["a", "0"], ["a", "-1"], ["a", 1], [["a"], "1"], [1, "2"], [1, 2], ["b", "1"])))


def symmetries(m):
    """q1 and q2 exchanged, with a and b"""
    x = family(m, "p1^2 + p2^2 + a*q1^2 + b*q2^2", parameters=("a", "b"), assumed=())
    t = theorem(m, {"X": x})
    exchange = {"q1": "q2", "q2": "q1", "p1": "p2", "p2": "p1", "a": "b", "b": "a"}
    rows = [[ONE[i ^ 1][j] for j in range(4)] for i in range(4)]

    def accepts(t=t, **more):
        found = []
        d = MOVED | a_map(values=exchange, back=rows) | more
        return not refused(m, lambda: found.append(t.said("symmetry", d))) and (found[0].kind, found[0].family) == ("S", t.families["X"])
    one = {x: x for x in exchange}
    root = [{"name": "r", "square": "2"}]
    line = family(m, "p1^2 + p2", parameters=("a", "b"), assumed=())
    half = family(m, "p1^2 + 4*a*p2^2 + b*q1*q2", parameters=("a", "b"), assumed=())
    halves = {"q1": "q1", "q2": ["q2", "2"], "p1": "p1", "p2": "2*p2", "a": ["a", "4"], "b": "2*b"}
    return (accepts() and accepts(values=one, back=ONE) and not accepts(values=one) and not accepts(values=exchange | {"a": "a", "b": "b"})
            and not accepts(adjoined=root)
            and not accepts(theorem(m, {"X": line}), values=one | {"q2": "q2 + 1"}, back=ONE)
            and accepts(theorem(m, {"X": line}), values=one | {"a": "a + 1"}, back=ONE)
            and not accepts(theorem(m, {"X": half}), values=halves, back=diagonal(["1", "2", "1", ["1", "2"]])))


def lowest_orders(m):
    """The region of Y in the names of X, which has an inverse more"""
    ready(m)
    low = "p1^2 + p2^2 + q1^3 + q2^3"
    y = family(m, low, parameters=("a", "b"), assumed=())
    x = family(m, low + " + u*q1^4", inverses=[("u", "q2 + 1")], parameters=("a", "b"), assumed=())
    ready(m)
    region = [(m["multivariate"].parse("7*a^65*b^3 - b^2 + a", y.names), "zero"), (m["multivariate"].parse("a", y.names), "positive")]
    d = {"system": "X", "of": "of", "weights": [2, 2, 3, 3], "degree": 6, "units": [],
         "orders": [{"inverse": "u", "order": 0, "part": "1", "by": {**SHOWN, "zeros": [["0", "-1"]]}}]}

    def of(*classes, family=y, kind="N"):
        found = []
        t = theorem(m, {"X": x}, of=fact(m, kind, family, region, classes, ["line"], ["Morales-Ramis"]))
        return None if refused(m, lambda: found.append(derived(t, t.said("lowest-order", d)))) else found[0]
    f = of(NEAR)
    a, b = (1 << x.names[name] for name in ("a", "b"))
    return (f is not None and f.family is x and f.classes == [ORIGIN] and f.used == {"Morales-Ramis", "Ziglin 1982"}
            and f.integrals == ["line"] and [(dict(g), s) for g, s in f.regions[0]] == [({65 * a + 3 * b: 7, 2 * b: -1, a: 1}, "zero"), ({a: 1}, "positive")]
            and of(REAL, NEAR).classes == of(REAL, ORIGIN).classes == [REAL, ORIGIN] and of(LEAVES) is None and of(REAL, LEAVES) is None
            and of(NEAR, LEAF) is None and of(LEAF) is None and of(NEAR, family=None) is None and of(kind="I") is None)


def covers(m):
    """All real a: a > 0 and a < 0 by the symmetry a -> -a, a = 0 by a part of its own"""
    ready(m)
    h = "p1^2 + p2^2 + a*q1"
    x, other = (family(m, h, assumed=()) for _ in range(2))
    a = m["multivariate"].parse("a", x.names)
    region = [(a, "positive")]
    flip = a_map(values={"q1": "-q1", "q2": "q2", "p1": "-p1", "p2": "p2", "a": "-a"}, back=diagonal(["-1", "1", "-1", "1"]))
    idle = {"node": "empty", "terms": [["1", "1", ["1", "1"]], ["1", "1", ["0", "1"]]], "zeros": []}    # f > 0 and -f >= 0
    zero = {"node": "empty", "terms": [["1", "1", ["1", "2"]]], "zeros": [["0", "-a"]]}                 # f = 0 and f is not 0

    def part(k, *word, shown=(idle,)):
        return {"node": "part", "part": str(k), "word": list(map(str, word)), "shown": list(shown)}

    def tree(positive, nought, negative):
        return {"node": "sign", "p": "a", "positive": positive, "zero": nought, "negative": negative}
    whole = tree(part(0), part(1, shown=[zero]), part(0, 0))

    def cover(tree=whole, parts=("n", "i"), symmetries=("s",), **more):
        t = theorem(m, {"X": x})
        known(m, t, **{"s": t.said("symmetry", MOVED | flip), "n": fact(m, "N", x, region, [NEAR, ORIGIN], (), ["Morales-Ramis"]),
                       "i": fact(m, "I", x, [(a, "zero")], (), ["line"], ["nothing"]), "all": fact(m, "N", x, [], [NEAR]),
                       "there": fact(m, "N", other, region, [NEAR])} | more)
        found = []
        d = {"system": "X", "symmetries": list(symmetries), "parts": list(parts), "tree": tree}
        return None if refused(m, lambda: found.append(derived(t, t.said("cover", d)))) else found[0]
    f = cover()
    if f is None or (f.kind, f.family, f.regions[0], list(f.classes), f.used) != ("N", x, [], [NEAR, ORIGIN], {"Morales-Ramis", "nothing"}):
        return False
    everywhere, several = part(0, shown=[]), fact(m, "N", x, region, [NEAR, ORIGIN], several=True)
    several.regions.insert(0, [(a, "zero")])
    leaves = fact(m, "N", x, region, [LEAVES])
    from_there = theorem(m, {"X": other}).said("symmetry", MOVED | flip)
    return (cover(everywhere, ["all"]) is not None and cover(everywhere, ["i"], i=fact(m, "I", x)) is None and cover(parts=["n", "s"]) is None
            and cover(parts=["there", "i"]) is None and cover(symmetries=["n"]) is None and cover(s=from_there) is None
            and cover(tree(part(0), part(1, shown=[zero]), part(0))) is None and cover(tree(part(0), part(1, shown=[zero]), part(0, 0, 0))) is None
            and cover(tree(part(0, 0, 0), part(1, shown=[zero]), part(0, 0, 0, 0))) is not None
            and cover(tree(part(0, *[0] * 40), part(1, shown=[zero]), part(0, 0))) is not None
            and cover(tree(part(0, *[0] * 42), part(1, shown=[zero]), part(0, 0))) is None
            and cover(tree(part(-2), part(1, shown=[zero]), part(0, 0))) is None and cover(tree(part(2), part(1, shown=[zero]), part(0, 0))) is None
            and cover(tree(part(0), part(1, shown=[zero]), part(0, -1))) is None and cover(tree(part(0), part(1, shown=[zero]), part(0, 1))) is None
            and cover(tree(part(0), part(1, shown=[zero]) | {"node": "portion"}, part(0, 0))) is None
            and cover(tree(part(0) | {"region": "0"}, part(1, shown=[zero]), part(0, 0))) is None
            and all((cover(tree(part(0) | {"region": k}, part(1, shown=[zero]), part(0, 0) | {"region": k}), n=several) is None) == (k != "1")
                    for k in ("-1", "0", "1", "2")) and cover(n=several) is None
            and cover(tree(part(0), part(1, shown=[]), part(0, 0))) is None and cover(tree(part(0), part(1, shown=[zero, zero]), part(0, 0))) is None
            and cover(tree(part(0), part(0), part(0, 0))) is None and cover(n=leaves) is None)


def leaves_of_a_cover(m):
    """A symmetry of a top maps F2 to F2 or -F2"""
    brackets = m["theorem_statement"].SYMMETRIC_TOP["system"]["brackets"]
    h, scaled = "M1^2 + 2*M2^2 + a*Gamma3^2", {f"Gamma{i}": f"2*Gamma{i}" for i in (1, 2, 3)}
    x = family(m, h, brackets=brackets, coordinates=SPACE, assumed=())
    same = {v: v for v in [*SPACE, "a"]}
    twice = a_map(values=same | scaled | {"a": ["a", "4"]}, back=diagonal(["1"] * 3 + [["1", "2"]] * 3))
    turned = a_map(values=same | {f"Gamma{i}": f"-Gamma{i}" for i in (1, 2, 3)}, back=diagonal(["1"] * 3 + ["-1"] * 3))

    def cover(classes, rows):
        t = theorem(m, {"X": x})
        d = {"system": "X"} | rows
        map = m["map"].Map(m["family"].Here(x), m["family"].Target.of(x, [], False), d)
        known(m, t, s=fact(m, "S", x, map=map), n=fact(m, "N", x, [], classes), k=fact(m, "N", x, [], [NEAR]))
        tree = {"node": "part", "part": "0", "word": ["0"], "shown": []}
        return not refused(m, lambda: t.said("cover", {"system": "X", "symmetries": ["s"], "parts": ["n", "k"], "tree": tree}))
    return (cover([NEAR], twice) and not cover([LEAVES], twice) and not cover([NEAR, LEAVES], twice)
            and cover([LEAVES], turned) and len(CANONICAL) == 2)


def on_trust(m):
    """What is on trust is named by the cover only, a step on trust says of which regions, and so does an open one"""
    y = family(m, "p1^2 + q1")
    t = theorem(m, {"Y": y}, n=fact(m, "N", y), on_trust=fact(m, "N", y, trusts=["so it is"]), several=fact(m, "N", y, several=True))
    region, no = [{"p": "a - 1", "sign": "zero"}], {"kind": "meromorphic", "near": "curve", "on_leaf": "no", "liouville": "yes", "functions": [],
                                                    "without": [], "through": [], "frame": ""}
    step = {"id": "s", "system": "Y", "says": "not integrable", "step": "so it is", "regions": [region], "class": no}
    yes = step | {"says": "integrable", "class": None}
    read, line = {k: v for k, v in yes.items() if v} | {"rule": "trusted"}, {"frame": " a frame~"}
    wrong = [{"near": "phase space"}, {"kind": "real-analytic"}, *({key: ["1x"]} for key in ("functions", "without", "through")),
             {"frame": "two\nlines"}, {"frame": "\x7f"}]

    def accepts(rule, d):
        found = []
        return not refused(m, lambda: found.append(t.said(rule, d))) and (found[0].several, len(found[0].regions)) == (True, 1)
    return (not refused(m, lambda: t.proved("n", "N")) and refused(m, lambda: t.proved("on_trust", "N")) and refused(m, lambda: t.proved("several", "N"))
            and accepts("open", {"system": "Y", "regions": [region]}) and refused(m, lambda: t.said("open", {"system": "Y", "regions": []}))
            and accepts("trusted", step) and accepts("trusted", yes) and accepts("trusted", step | {"step": "s"})
            and accepts("trusted", step | {"class": no | line}) and not any(accepts("trusted", step | {"class": no | c}) for c in wrong)
            and accepts("trusted", step | {"step": "s" * 4000}) and not accepts("trusted", step | {"step": "s" * 4001})
            and not accepts("trusted", step | {"step": ""}) and refused(m, lambda: t.said("trusted", step | {"regions": []}))
            and not refused(m, lambda: m["theorem"].read_step(read))
            and refused(m, lambda: m["theorem"].read_step(read | {"says": "open"})) and not accepts("trusted", step | {"class": None})
            and not accepts("trusted", yes | {"class": no}))


def named(m):
    """A family of a Hamiltonian system, parameters of it, and the functions of which a fact speaks"""
    ready(m)
    plain = family(m, "p1^2 + q1*a")
    field = m["family"].Family({"name": "Z", "parameters": ["a"], "assumptions": [], "system": {
        "coordinates": ["x"], "functions": [], "relations": [], "inverses": [], "field": ["a*x"], "hamiltonian": None, "brackets": None}})
    t = theorem(m, {"Y": plain, "Z": field})
    place = {"system": "Y", "at": [], "region": []}
    of = SimpleNamespace(target=SimpleNamespace(parameters=["a", "h", "k"]), names={"a", "h"}, there=["s = h"])
    here = SimpleNamespace(space=SimpleNamespace(at={"a": 0}))
    free = family(m, "p1^2 + q1^3", **FREE)
    by_names = theorem(m, {"X": free}, of=fact(m, "N", free, [], [NEAR]))
    return (t.plain_family({"system": "Y"}) is plain and refused(m, lambda: t.plain_family({"system": "Z"})) and t.family({"system": "Z"}) is field
            and not refused(m, lambda: t.here(place | {"at": [["a", "2"]]})) and refused(m, lambda: t.here(place | {"at": [["q1", "2"]]}))
            and t.functions_there(of, here) == ["s = h, for some value of h"]
            and refused(m, lambda: by_names.said("place", place | {"system": "X", "of": "of", "shown": [], "levels": None})))


def strict(m):
    """An open hypothesis is refused if it is asked for"""
    from theorems import HEAVY, RIGHT

    def accepts(top, how):
        ready(m)
        return not refused(m, lambda: m["theorem"].verify(copy.deepcopy(top), m["kovacic_verify"].prove, how))
    return accepts(HEAVY, False) and not accepts(HEAVY, True) and accepts(RIGHT["small"], True)


def properties():
    """(name, function, True)"""
    return [(f"composed.{f.__name__}", f, True) for f in (facts, certificates, a_leaf, asked, literature, integrals, on_a_level, places, levels,
                                                          functions, symmetries, lowest_orders, covers, leaves_of_a_cover, on_trust,
                                                          named, strict)]
