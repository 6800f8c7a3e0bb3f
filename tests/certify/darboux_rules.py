"""Small bundles with the rule for Darboux points (theorem_certificates.md 16): no parameters, so that all that is shown is a
number; each limit and each hypothesis of the rule has one that just meets it and one that just misses it."""
import json

from traps import changed

# ---- polynomials in w, as lists of integers without zeros at the end


def plus(f, g, c=1):
    rows = [0] * max(len(f), len(g))
    for i, a in enumerate(f):
        rows[i] += a
    for i, a in enumerate(g):
        rows[i] += c * a
    while rows and not rows[-1]:
        rows.pop()
    return rows


def times(*fs):
    out = [1]
    for f in fs:
        out, old = [], out
        for i, a in enumerate(f):
            out = plus(out, [0] * i + old, a)
    return out


def slope(f):
    return [i * a for i, a in enumerate(f)][1:]


def divided(f, g):
    """f/g, which has integral coefficients"""
    q = []
    while len(f) >= len(g):
        term = [0] * (len(f) - len(g)) + [f[-1] // g[-1]]
        f, q = plus(f, times(term, g), -1), plus(q, term)
    assert not f
    return q


def text(terms):
    """Of pairs (integer, monomial)"""
    return " + ".join(f"{a}*{m}" for a, m in terms if a).replace("+ -", "- ") or "0"


def in_w(f):
    return text((a, f"x^{i}") for i, a in enumerate(f))


# ---- bundles

def by(i):
    """Condition i is 1 = 0"""
    return {"node": "empty", "terms": [["1", "1"]], "zeros": [[str(i), "-1"]]}


NUMBER = {"value": "1", "by": by(0)}                    # is not 0
ZERO = {"value": "0", "by": {"node": "empty", "terms": [["1", "1", ["0", "1"]]], "zeros": []}}
R2 = [1, 0, 1]                                          # half of c for the usual masses, in each chart up to a number


class Forms:
    """H = l u^2 + m u v + n v^2 + sum p_j x^j y^(k - j)"""

    def __init__(self, p, masses=(1, 0, 1), chart=(1, 0)):
        (l, m, n), (a, b), self.p, self.masses, self.chart, self.k = masses, chart, p, masses, chart, len(p) - 1
        x, y = [-b, a], plus([], [a, b])
        self.potential = []
        for j, c in enumerate(p):
            self.potential = plus(self.potential, times(*[x] * j, *[y] * (self.k - j)), c)
        self.circle = plus(plus(times([2 * n], x, x), times(x, y), -2 * m), times([2 * l], y, y))
        half = [a // 2 for a in slope(self.circle)]
        self.directions = plus(times(self.circle, slope(self.potential)), times(half, self.potential), -self.k)

    def hamiltonian(self):
        potential = ((c, f"x^{j}*y^{self.k - j}") for j, c in enumerate(self.p))
        return text([*zip(self.masses, ("u^2", "u*v", "v^2")), *potential])


def bundle(f, says="multiple", rest=(1,), power=1, order=0, lines=None, choices=(), more="", system=(), **step):
    """rest: the other factor of the directions; lines: (F1, F2, the order along F2); choices: (values, equations), proved by one
    that is not 0"""
    rest, relation = list(rest), says == "relation"
    shown = [NUMBER] * (8 if len(rest) > 1 else 7) + [NUMBER if relation else ZERO] + [NUMBER] * (relation * (3 if lines else 2))
    chosen = [(values.split(), equations.split()) for values, equations in choices]
    d = {"id": "d", "rule": "darboux", "system": "X", "at": [], "region": [], "coordinates": ["x", "y"], "momenta": ["u", "v"],
         "part": "all", "degree": str(f.k), "chart": [str(x) for x in f.chart], "says": says, "unit": "1", "zeros": [],
         "proper": in_w(divided(f.directions, rest)), "rest": in_w(rest), "shown": shown,
         "choices": [{"values": values, "equations": equations, "by": by(equations.index("1"))} for values, equations in chosen]}
    if len(rest) > 1:
        both = times(*[f.potential, f.circle] * power)
        d["improper"] = {"scale": "1", "cofactor": in_w(divided(both, rest)), "power": str(power)}
    first, second, other = lines or (f.circle, [1], 0)
    scale = [1] if lines else [2**order]                # c is twice a polynomial
    both = times(*[first] * order, *[second] * other)
    left = divided(times(scale, f.potential), both) if relation else [1]
    d["isotropic"] = {"order": str(order), "scale": in_w(scale), "rest": in_w(left)}
    if lines:
        d["isotropic"]["lines"] = {"factors": [in_w(first), in_w(second)], "over": "1", "order": str(other)}
    x = {"coordinates": ["x", "y", "u", "v"], "hamiltonian": f.hamiltonian() + more,
         "brackets": [["x", "u", "1"], ["y", "v", "1"]]}
    family = {"name": "X", "parameters": [], "system": x | dict(system), "assumptions": []}
    tree = {"node": "part", "part": "0", "word": [], "shown": []}
    main = {"id": "main", "rule": "cover", "system": "X", "symmetries": [], "parts": ["d"], "tree": tree}
    return {"format": "kovacic-theorem/1", "title": "T", "systems": [family], "steps": [d | step, main]}


def multiple(k):
    """The coefficients of r^k + x^3 (...) near (0, 1), which is a multiple Darboux point"""
    p = [2, 0, k, 1] + [0] * (k - 3)
    p[-2] += k > 4                                      # so that no direction is at infinity in the chart (1, 0)
    return p


def round_(j, p):
    """r^(2 j) times it"""
    f = times(*[R2] * j, p)
    return f + [0] * (2 * j + len(p) - len(f))


CUBIC = Forms([1, 2, 3, 1])
VALUES = ("-1 -1 1", "-7/8 14 14", "-2/3 7/3 14", "-2/3 4 4")      # for k = 3 and three simple points
CHOICES = [(values, "1 1 1") for values in VALUES]


def terms():
    """Terms beside the part that is looked at"""
    rows = {"all": ("7", "x x*y y^4 x^2*y^2 u v x*u u*v^2 x*u^2 u^2*v^2"),
            "highest": ("7 x x*y u v x*u y*v", "x^4 x^2*y^2 x*y*u u*v^2 u^3 x*v^2"),
            "lowest": ("7 x^4 x^2*y^2 x*y*u y^2*v", "x x*y u v x*u y*v x^2*u^2")}
    for part, both in rows.items():
        yield part, bundle(Forms(multiple(3)), part=part), True
        for right, some in zip((True, False), both):
            for term in some.split():
                yield f"{part} + {term}", bundle(Forms(multiple(3)), part=part, more=f" + {term}"), right
    for k, part, term, right in ((4, "highest", "x*u", True), (4, "highest", "x^2*u", False), (4, "lowest", "x^2*u", False),
                                 (4, "lowest", "x^3*u", True), (4, "all", "x^3*u", False), (4, "lowest", "x^3", False),
                                 (4, "highest", "x^3", True), (5, "highest", "x^2*u", True), (5, "lowest", "x^2*u", False),
                                 (6, "highest", "x^3*u", False)):
        yield f"degree {k}, {part} + {term}", bundle(Forms(multiple(k)), part=part, more=f" + {term}"), right


def limits():
    yield "1 point", bundle(Forms(round_(1, [1, 2])), "relation", R2, order=1), True
    for k in range(3, 9):
        yield f"{k} points", bundle(Forms(multiple(k))), True
    yield "9 points", bundle(Forms(multiple(9))), False
    for k, j, right in ((19, 8, True), (20, 8, True), (21, 9, False)):
        yield f"degree {k}", bundle(Forms(round_(j, multiple(k - 2 * j))), rest=round_(j, [1])), right
    for power, right in ((1, True), (2, True), (12, True), (13, False)):
        yield f"power {power}", bundle(Forms(round_(1, multiple(3))), rest=R2, power=power), right
    for a, b, right in ((0, 1, True), (2, 3, True), (1000, 1, True), (1, 1000, True), (-1000, 7, True), (1001, 1, False),
                        (1, 1001, False), (-1001, 1, False), (1, -1001, False)):
        yield f"chart {a} {b}", bundle(Forms([4, -3, 5, 2], (3, 1, 2), (a, b)), "relation", choices=CHOICES), right


# x^3 + y^3 for the usual masses, and in the coordinates x + y, y: the sum of two systems, with the eigenvalues -1, -1, 1
SUM, SUM_TOO = Forms([1, 0, 0, 1], chart=(2, 1)), Forms([2, 3, 3, 1], (2, -2, 1), (2, 1))


def integrable():
    """What would be wrong, and what is right beside it"""
    yield "a cubic", bundle(CUBIC, "relation", choices=CHOICES), True
    for what, f in (("a sum", SUM), ("a sum, in other coordinates", SUM_TOO)):
        wrong = bundle(f, "relation", choices=CHOICES)
        yield f"{what}, of other eigenvalues", wrong, False
        yield f"{what}, with its eigenvalues", changed(wrong, ["steps", 0, "choices", 0, "equations"], ["0"] * 3), False
        yield f"{what}, of the other signs", bundle(f, "relation", choices=[(VALUES[0], "0 1 0"), *CHOICES[1:]]), False
        yield f"{what}, without choices", bundle(f, "relation"), False
        yield f"{what}, with another factor", bundle(f, proper="x^3"), False
        one = {"order": "1", "scale": "1", "rest": "1"}
        yield f"{what}, with another order", bundle(f, "relation", isotropic=one, choices=[("-1 -1 -1", "0 0 1")]), False
    # two of the three Darboux points of the sum; one is at infinity
    yield "a point at infinity", bundle(Forms([1, 0, 0, 1]), "relation"), False
    # both "lines" are c and 1: the second order may be anything, and 3 leaves no choice
    yield "c in the place of a line", bundle(SUM, "relation", lines=(SUM.circle, [1], 3)), False
    # oscillators: for k = 2 nothing follows from eigenvalues
    yield "degree 2", bundle(Forms([2, 0, 1], chart=(2, 1)), "relation", choices=[("-3/4 3", "1 1")]), False
    # u v + x^2 y has the integral v^2/2 + x^3/3, and no Darboux point
    f = Forms([0, 0, 1, 0], (0, 1, 0), (2, 1))
    yield "no point", bundle(f, rest=f.potential), False
    # H is u^2 + v^2 on the graph of f = -V
    gradient = {"x": "-6*x*y - 3*x^2", "y": "-6*y^2 - 3*x^2"}
    function = {"functions": [{"name": "f", "meaning": "-V", "gradient": gradient}]}
    yield "a function", bundle(Forms(multiple(3)), more=" + f", system=function), False
    # the forms of u^2 + v^2 would be those of other masses
    f = Forms([-2, 0, 3, 0])
    yield "masses that depend on x", bundle(f, more=" + 4*x^2*u^2 + 4*x*u*v", proper="30*x^3"), False


def nothing_there(top, *rows):
    """Of the region 1 = 0, where these rows of what is shown are 0; nothing is said elsewhere"""
    step, main = top["steps"]
    for i in rows:
        step["shown"][i] = NUMBER | {"value": "0"}
    step["region"] = [{"p": "1", "sign": "zero"}]
    main["parts"], main["tree"] = ["d", "o"], main["tree"] | {"part": "1", "region": "0"}
    return top | {"steps": [step, {"id": "o", "rule": "open", "system": "X", "regions": [[]]}, main]}


def others():
    f = Forms(multiple(3))
    plain, cubic = bundle(f), bundle(CUBIC, "relation", choices=CHOICES)
    names = ["y", "v", "x", "u"]
    for what, top in (("a multiple point", plain), ("a cubic", cubic)):
        yield f"{what}, names in another order", changed(top, ["systems", 0, "system", "coordinates"], names), True
    for what, system in (("one more coordinate", {"coordinates": ["x", "y", "u", "v", "t"]}),
                         ("an inverse", {"inverses": [{"name": "r", "of": "x"}]}),
                         ("an inverse of a momentum", {"inverses": [{"name": "r", "of": "u^2 + 1"}]}),
                         ("a bracket more", {"brackets": [["x", "u", "1"], ["y", "v", "1"], ["u", "v", "1"]]}),
                         ("another bracket", {"brackets": [["x", "u", "1"], ["y", "v", "2"]]})):
        yield what, bundle(f, more=" + r" * ("inverse" in what), system=system), False
    relation = changed(changed(plain, ["systems", 0, "parameters"], ["a"]), ["systems", 0, "system", "relations"], ["a - 1"])
    yield "a relation", relation, False
    yield "a coordinate twice", bundle(f, coordinates=["x", "x"]), False
    # V is 0 along x = 0 with the order 2: u v + x^2 (...)
    f = Forms([0, 0, 1, 1, 0, 2], (0, 1, 0), (2, 1))
    (x, y), values = ([-1, 2], [2, 1]), ("-1 -1 -1", "-3/5 -3/5 3", "-13/40 26 26")
    both, once = (x, times([-2], y), 0), Forms([0, 1, 1, 1], (0, 1, 0), (2, 1))
    yield "the order 1", bundle(once, "relation", x, order=1, lines=both, choices=[("-1 -1", "1 1")]), True
    for first, second, right in ((2, 0, True), (1, 0, False), (2, 1, False), (2, -1, False), (-1, 0, False)):
        choices = [(v, "1 1 1") for v in values]
        double = bundle(f, "relation", times(x, x), order=2, lines=both, choices=choices)
        lines = double["steps"][0]["isotropic"] | {"order": str(first)}
        lines["lines"] = lines["lines"] | {"order": str(second)}
        yield f"the orders {first} and {second}", changed(double, ["steps", 0, "isotropic"], lines), right
    for order in ("-1", "4"):
        yield f"order {order}", changed(cubic, ["steps", 0, "isotropic", "order"], order), False
    # the factor x is 0 in one direction
    for what in ("unit", "scale"):
        at, rest = (["steps", 0], [0, 1]) if what == "unit" else (["steps", 0, "isotropic"], [0, *CUBIC.potential])
        yield f"{what} x", changed(changed(cubic, [*at, what], "x"), [*at, "rest"], in_w(rest)), False
    # a point where V is 0 loses its eigenvalue
    zero = Forms([0, 0, 1, 0], chart=(2, 1))
    yield "nothing is there", nothing_there(cubic), True
    yield "nothing is there, and V is 0", nothing_there(bundle(zero, "relation", choices=CHOICES), 6), False


def written():
    """More or less than is expected"""
    plain, cubic = bundle(Forms(multiple(3))), bundle(CUBIC, "relation", choices=CHOICES)
    for key, rows in (("shown", plain["steps"][0]["shown"]), ("zeros", [])):
        for what, more in (("null", None), ("0", ZERO), ("1", NUMBER)):
            yield f"{what} more in {key}", changed(plain, ["steps", 0, key], [*rows, more]), False
    for top in (plain, cubic):
        rows = top["steps"][0]["shown"]
        yield f"{len(rows) - 1} rows", changed(top, ["steps", 0, "shown"], rows[:-1]), False
    yield "a choice of nothing", changed(plain, ["steps", 0, "choices"], cubic["steps"][0]["choices"]), False
    f = Forms(multiple(3))
    improper = {"scale": "1", "cofactor": in_w(times(f.circle, f.potential)), "power": "1"}
    yield "improper directions of nothing", changed(plain, ["steps", 0, "improper"], improper), False
    lines = {"factors": ["x", "x"], "over": "1", "order": "0"}
    yield "lines of nothing", changed(plain, ["steps", 0, "isotropic", "lines"], lines), False
    for values in VALUES[:3]:
        yield f"values {values}", changed(cubic, ["steps", 0, "choices", 3, "values"], values.split()), False
    for equations in (["1", "1"], ["1"], ["1"] * 4):
        yield f"{len(equations)} equations", changed(cubic, ["steps", 0, "choices", 1, "equations"], equations), False


def certificates():
    for part in (terms, limits, integrable, others, written):
        for name, top, right in part():
            yield f"darboux: {name}", json.dumps(top), right
