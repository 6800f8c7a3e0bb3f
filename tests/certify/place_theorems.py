"""Small certificates of theorems (kovacic-theorem/1): Ziglin's theorem about the symmetric top X, and the Hamiltonian of another
system Y as a first integral of X at the place that is tried.  Each wrong one breaks one rule of theorem_certificates.md 4."""
import json

from theorem_statement import COORDINATES, SYMMETRIC_TOP

H, _ = SYMMETRIC_TOP["system"]["hamiltonian"]
ONE = [["1" if i == j else "0" for j in range(6)] for i in range(6)]
SYSTEM = {k: SYMMETRIC_TOP["system"][k] for k in ("coordinates", "inverses", "hamiltonian", "brackets")}
X = SYMMETRIC_TOP | {"name": "X", "system": SYSTEM}


def theorem(value, rest, assumptions=(), shown=(), adjoined=(), inverses=(), more=(), other=(), coordinates=(), region=(), values=()):
    """2 H_Y = 2 H + rest, b the parameter of Y that is not a parameter of X; inverses: names with polynomials and values"""
    h = [f"{H} + {rest}", "2"]
    names = {x: x for x in [*COORDINATES, *SYMMETRIC_TOP["parameters"], "u1", "u2"]}
    y = X | {"name": "Y", "parameters": [*SYMMETRIC_TOP["parameters"], "b"], "assumptions": list(assumptions),
             "system": SYSTEM | {"hamiltonian": h, "coordinates": [*COORDINATES, *coordinates],
                                 "inverses": SYSTEM["inverses"] + [{"name": u, "of": f} for u, f, _ in inverses]} | dict(other)}
    place = {"id": "place", "rule": "place", "of": "energy", "system": "X", "at": [], "region": list(region), "adjoined": list(adjoined),
             "values": names | {"b": value} | {u: v for u, _, v in inverses} | dict(values), "back": ONE,
             "bracket": ["1", "1"], "energy": ["1", "1"], "shown": list(shown)} | dict(more)
    steps = [{"id": "top", "rule": "literature", "system": "X", "theorem": "Ziglin 1983"},
             {"id": "energy", "rule": "integrals", "system": "Y", "claims": [{"name": "H", "value": h, "cofactors": []}],
              "level": []}, place,
             {"id": "main", "rule": "cover", "system": "X", "symmetries": [], "parts": ["top", "place"],
              "tree": {"node": "part", "part": "0", "word": [], "shown": []}}]
    return {"format": "kovacic-theorem/1", "title": "a place", "systems": [X, y], "steps": steps}


def empty(*terms, zeros=()):
    return {"node": "empty", "terms": list(terms), "zeros": list(zeros)}


def maps():
    """M1 to M3: what the names of Y stand for"""
    yield "b = A", theorem("A", "2*b - 2*A"), True
    yield "b = C", theorem("C", "2*b - 2*A"), False
    yield "a parameter is M1", theorem("M1", "2*b - 2*M1"), False
    for value, right in (("u2", True), ("u1", False)):
        yield f"the inverse of A is {value}", theorem("A", f"2*w - 2*{value}", inverses=[("w", "b", value)]), right
    yield "more coordinates", theorem("A", "2*N1^2 + 2*b - 2*A", coordinates=["N1", "N2"], values={"N1": "0", "N2": "0"}), False
    for square, right in (("A", True), ("M1", False), ("Gamma1^2", False)):
        yield f"r^2 = {square}", theorem("A", "2*b - 2*A", adjoined=[{"name": "r", "square": square}]), right
    for name in ("A", "M1", "u1"):
        yield f"{name}^2 = A", theorem("A", "2*b - 2*A", adjoined=[{"name": name, "square": "A"}]), False
    # A > 0 is condition 0, -A > 0 would be 6
    nothing = [{"p": "-A", "sign": "positive"}]
    for h, norm, by, right in (("A", "A", empty(["1", "1", ["0", "1"]], zeros=[["6", "-1"]]), True), ("A", "A", empty(["1", "1"]), False)):
        row = {"name": "v", "inverse": h, "times": "1", "norm": norm, "by": by}
        yield f"the inverse of {h}, {right}", theorem("A", "2*b - 2*A", adjoined=[row]), right
    row = {"name": "v", "inverse": "0", "times": "1", "norm": "0", "by": empty(["1", "1", ["0", "1"]], ["1", "1", ["6", "1"]])}
    yield "the inverse of 0, where nothing is", theorem("A", "2*b - 2*A", adjoined=[row], region=nothing), False


def shown():
    """M4: what is assumed of b"""
    def row(value, by, over="1", square=False):
        return {"over": over, "value": value, "by": by} | ({"square": True} if square else {})

    def assumed(sign, p="b"):
        return [{"p": p, "sign": sign}]
    # condition 6 is the negation
    sums, zero = empty(["1", "1", ["0", "1"]], ["1", "1", ["6", "1"]]), empty(["1", "1", ["0", "1"]], zeros=[["6", "-1"]])
    squared = empty(["1", "1", ["0", "2"]], ["1", "1", ["6", "1"]])
    over_l = empty(["1", "L3", ["0", "1"]], ["1", "1", ["6", "1"]])
    root = [{"name": "r", "square": "A"}]
    plain, minus = ("A", "2*b - 2*A"), ("-A", "2*b + 2*A")
    for name, (value, rest), sign, rows, right in (
            ("positive", plain, "positive", [row("A", sums)], True), ("nothing", plain, "positive", [], False),
            ("twice", plain, "positive", [row("A", sums)] * 2, False), ("another value", plain, "positive", [row("2*A", sums)], False),
            ("not shown", plain, "positive", [row("A", zero)], False), ("a square", minus, "positive", [row("A^2", squared, square=True)],
                False),
            ("negative", minus, "positive", [row("A", sums)], False), ("nonnegative", plain, "nonnegative", [row("A", sums)], True),
            ("over L3, which may be 0", plain, "nonnegative", [row("A*L3^2", over_l, "L3")], False),
            ("nonzero", plain, "nonzero", [row("A", zero)], True), ("nonzero, by positive terms", plain, "nonzero", [row("A", sums)],
                False)):
        yield f"{sign}: {name}", theorem(value, rest, assumed(sign), rows), right
    for square, right in ((True, True), (False, False)):
        yield f"a root, {square}", theorem("r", "2*b^2 - 2*A", assumed("nonzero"), [row("A", zero, square=square)], root), right
    yield "a root is not positive", theorem("r", "2*b^2 - 2*A", assumed("positive"), [row("A", sums, square=True)], root), False
    for value, right in (("A", True), ("C", False)):
        yield f"zero: b = {value}", theorem(value, f"2*b - 2*{value}", assumed("zero", "b - A")), right


def data():
    """What a system has, and that each has a name of its own"""
    plain = theorem("A", "2*b - 2*A")
    yield "a system twice", plain | {"systems": [*plain["systems"], X]}, False
    yield "no functions", theorem("A", "2*b - 2*A", other={"functions": [], "relations": []}), True
    yield "a function", theorem("A", "2*b - 2*A", other={"functions": [{"name": "s", "meaning": "", "gradient": {"M1": "1"}}]}), False
    yield "a relation", theorem("A", "2*b - 2*A", other={"relations": ["0"]}), False
    for rule in ("faith", None):
        steps = [plain["steps"][0] | {"rule": rule}, *plain["steps"][1:]]
        yield f"the rule {rule}", plain | {"steps": steps}, False


def certificates():
    """(name, text, is it right?)"""
    for family in (maps, shown, data):
        for name, top, right in family():
            yield f"{family.__name__}: {name}", json.dumps(top), right
