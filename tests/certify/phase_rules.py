"""Properties of phase_space.py, phase_curve.py, system.py and first_integrals.py of the Python checker: functions of its modules
(sys.modules) that are True."""
from types import SimpleNamespace

from lowest import CANONICAL, refused
from motion_rules import half, motion
from systems import GENUINE


def space(m, brackets=CANONICAL, h="p1^2 + q1", inverses=(), functions=(), relations=(), field=None):
    m["multivariate"].Work.left = 10**7
    system = {"coordinates": ["q1", "q2", "p1", "p2"], "functions": [dict(zip(("name", "gradient"), x)) for x in functions],
              "inverses": [dict(zip(("name", "of"), x)) for x in inverses], "relations": list(relations),
              "hamiltonian": None if field else h, "brackets": None if field else brackets, "field": field}
    return m["phase_space"].PhaseSpace(system, ["a"])


def claims(m):
    """First integrals and Casimir functions, with cofactors of the relations"""
    circle = [("s", {"q1": "c"}), ("c", {"q1": "-s"})], ["s^2 + c^2 - 1"]
    x = space(m, CANONICAL[:1], "p1^2 + s^2", functions=circle[0], relations=circle[1])
    free = space(m, field=["1", "0", "0", "0"])

    def accepts(x, kind, value, cofactors=None):
        return not refused(m, lambda: x.need_claim({"kind": kind, "value": value, "cofactors": cofactors}))
    # {q1, F} is p1 times the relation for F = p1^2 (s^2 + c^2 - 1)/2; there is no force on q2
    casimir = "q2*s^2 + q2*c^2"
    return (accepts(x, "integral", "p1^2 + s^2") and not accepts(x, "integral", "p1^2") and accepts(x, "casimir", "q2")
            and not accepts(x, "casimir", "q1")
            and accepts(x, "casimir", "q2*p2", [["0"]] * 4) and not accepts(x, "casimir", "q2", [["0"]] * 3)
            and not accepts(x, "casimir", "q2", [[]] * 4)
            and accepts(x, "casimir", casimir) and accepts(free, "integral", "q2") and not accepts(free, "integral", "q1")
            and not accepts(free, "casimir", "q2")
            and accepts(x, "integral", "q2", [["0"]])
            and not accepts(x, "integral", "q2", [["0"], ["0"]])
            and accepts(x, "casimir", "p1^2*s^2 + p1^2*c^2 - p1^2", [["2*p1"], ["0"], ["0"], ["0"]]) and not accepts(
                x, "casimir", "p1^2*s^2 + p1^2*c^2 - p1^2", [["0"]] * 4) and inverses(m))


def inverses(m):
    """A cofactor has no inverse in it, though it should cancel"""
    x = space(m, inverses=[("u", "q1 + 1")])
    read, x.relations = x.read, [x.read("q1*p1"), x.read("q2"), x.read("p2")]
    zero = m["phase_space"].NOTHING

    def accepts(f, *cofactors):
        return not refused(m, lambda: x.need_zero(f, "", list(cofactors)))
    return (accepts(zero, "q2", "-q1*p1", "0") and not accepts(zero, "u*q2", "-u*q1*p1", "0") and not accepts(zero, "0", "u*p2", "-u*q2")
            and accepts(read("u*q2"), "0", "1", "0") and not accepts(read("u*q2"), "0", "2", "0") and not accepts(zero, "0", "0"))


def arguments(m):
    """The coordinates on which a function or an inverse depends, through others, too; a constant has a relation"""
    functions = [("s", {"q1": "c"}), ("c", {"q1": "-s", "p2": "0"})]
    x = space(m, functions=[*functions, ("r", {})], inverses=[("u", "p1 + s")], relations=["r^2 - 2"])
    x.gradients[80 * x.at["s"]] = {1: x.read("u*p2")}
    found = [x.arguments(v) for v in (x.at["s"], x.at["c"], x.at["r"], x.at["u"], 80 * x.at["s"], x.at["p2"])]
    q1, q2, p1, p2 = (x.at[name] for name in x.coordinates)
    return (found == [{q1}, {q1}, set(), {q1, p1}, {q1, q2, p1, p2}, {p2}] and refused(m, lambda: space(m, functions=[("r", {})]))
            and refused(m, lambda: space(m, functions=[("r", {"q1": "0"})])) and len(space(m, functions=functions).gradients) == 2)


def leaves(m):
    """A symplectic bracket: pairs of coordinates with constants"""
    def one(*brackets):
        return space(m, [list(v) for v in brackets]).one_leaf()
    first, second = ("q1", "p1", "1"), ("q2", "p2", ["-2", "3"])
    return (one(first, second) is True and not one(first) and not one(first, ("q2", "p2", "q2"))
            and not one(first, second, ("q1", "q2", "0"))
            and not one(("q1", "p1", "q1 + 2"), second) and one(("p1", "q1", "1"), ("p2", "q2", "a")) is False)


def moving(m):
    """What is left out of a class of first integrals (7)"""
    class Curve:
        def __init__(self, known, field, gradients, along=()):
            x = space(m)
            at = x.at | {name: 10**4 + i for i, (name, _) in enumerate(gradients)}
            slopes = {at[name]: {x.coordinates.index(y): x.read(f) for y, f in g.items()} for name, g in gradients}
            self.space = SimpleNamespace(coordinates=x.coordinates, functions=[name for name, _ in gradients], gradients=slopes, at=at)
            self.known, self.moved = {at[x] for x in known}, along
            self.field = [m["multivariate"].P({0: c} if c else {}) for c in field]

        def has(self, x):
            return self.space.at[x] in self.known

        def along(self, gradient):
            return any(self.space.coordinates[j] in self.moved for j in gradient)

    def of(*given, **more):
        return m["phase_curve"].PhaseCurve.moving(Curve(*given, **more))
    f, k, some = ("f", {"q1": "q2", "p1": "0"}), ("k", {}), ["q1", "p1", "q2"]
    g = ("g", {"q1": "q2", "p1": "p2"})
    return (of(some, (1, 1, 1, 1), []) == ["p2"] and of(some, (1, 1, 1, 0), []) == [] and of([*some, "p2"], (1, 1, 1, 1), []) == []
            and of(some, (0, 0, 0, 0), [f]) == [] and of(some, (0, 0, 0, 0), [f], along=["q1"]) == ["f"]
            and of([*some, "f"], (0,) * 4, [f], along=["q1"]) == []
            and of(some, (0,) * 4, [k], along=["q1"]) == [] and of(some, (0,) * 4, [g]) == ["g"] and of(["q1"], (0,) * 4, [f]) == ["f"]
            and of(["q2"], (0,) * 4, [f]) == [] and of([*some, "p2"], (0,) * 4, [f, g], along=["p1"]) == ["f", "g"])


def at_roots(m):
    """f in K[z] at a root in R, K = Q(sqrt 2)"""
    exact, x = m["exact"], motion(m, half("2*q2^3"),
                                  constants=[{"name": "w", "degree": 2, "value": "2"}, {"name": "v", "degree": 2, "value": "3"}])
    inner = object.__new__(m["system"].Inner)
    inner.R, K = x.R, exact.K
    K.m, K.d, K.s = [-2, 0, 1], 2, 3
    try:
        def at(c, q, e, text):
            return not inner.at_root(exact.Poly(c, q), x.R.read(e)) - x.R.read(text)
        return (at([1], 1, "w", "1") and at([5, 7, 0, 0, 3], 4, "w", ["5 + 7*w + 3*e*w", "4"])
                and at([5, 7, 0, 0, 3], 4, "-w", ["5 - 7*w - 3*e*w", "4"])
                and not at([5, 7], 1, "w", "5*w + 14") and at([0, 1], 1, "v", "v"))
    finally:
        K.m, K.d, K.s = [0, 1], 1, 1


def errors(m):
    """What goes wrong in a system is a refusal."""
    S, d = m["system"], m["system_format"].read_system(GENUINE["airy_field"])
    true = S.PhaseSpace

    def fails(error):
        def raising(*_):
            raise error("no")
        S.PhaseSpace = raising
        return refused(m, lambda: S.accept(d, None))
    try:
        return all(map(fails,
                       (ZeroDivisionError, OverflowError, ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError,
                        MemoryError)))
    finally:
        S.PhaseSpace = true


def classes(m):
    """What a verdict says of first integrals"""
    def said(denials, moved=("x",), brackets=None, symbols=()):
        x = SimpleNamespace(functions=list(symbols), brackets=brackets, one_leaf=lambda: False, at={s: s for s in symbols}, coordinates=(),
                            gradients={s: {"q": 1} for s in symbols})
        curve = SimpleNamespace(space=x, has=lambda s: s != "hidden", moving=lambda: list(moved))
        return m["first_integrals"].integrals(curve, [m["first_integrals"].Denial(*d) for d in denials]).sentence()
    ends, moved = " also at the ends of the phase curve (points at infinity, equilibria, poles of the system)", " and do not depend on x"
    return (said([(True, True)]) == said([]) == "meromorphic" and said([(True, True), (True, False)]) == "meromorphic" + moved
            and said([(True, True), (False, True)]) == "meromorphic" + ends + moved and said([(True, False)], ()) == "meromorphic"
            and said([], symbols=["s", "hidden"]) == "meromorphic (in the coordinates and s)"
            and said([], brackets={}) == "meromorphic and independent on the symplectic leaf of the phase curve")


def triple_roots(m):
    """A root of order 3 is never missed, and others are seen not to be there"""
    exact, triple = m["exact"], m["first_integrals"].triple_root
    m["multivariate"].Work.left = 10**8

    def of(minimal, *blocks, q=1):
        K = exact.K
        K.m, K.d, K.s = list(minimal), len(minimal) - 1, 2 * len(minimal) - 3
        try:
            return triple(exact.Poly([c for block in blocks for c in [*block, *[0] * (K.s - len(block))]], q))
        finally:
            K.m, K.d, K.s = [0, 1], 1, 1
    Q, root = (0, 1), (-2, 0, 1)
    # (z - 1)^3, (z - 1)^2 (z - 2), (1009 z - 1)^3/1009^3, (z - w)^3, (z - w)^2 (z + w), w^2 = 2
    return (of(Q, [-1], [3], [-3], [1]) and not of(Q, [-2], [5], [-4], [1])
            and of(Q, [-1], [3 * 1009], [-3 * 1009**2], [1009**3], q=1009**3)
            and of(root, [0, -2], [6], [0, -3], [1]) and not of(root, [0, 2], [-2], [0, -1], [1]) and not of(Q, [1])
            and not of(root, [0, 1], [1]))


def properties():
    """(name, function, True)"""
    return [(f"phase_rules.{f.__name__}", f, True) for f in (claims, inverses, arguments, leaves, moving, at_roots, errors, classes, triple_roots)]
