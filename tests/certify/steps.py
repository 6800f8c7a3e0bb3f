"""Steps of kovacic-certificate/1 by hand: beside a true certificate one in which a single requirement of its rule fails.
certificates() yields what is stated, the text and whether it is right."""
import json
from fractions import Fraction as F

from asymmetric import AIRY, AT_ZERO, PRIME, Z, abelian, certificate, conclude, diagonal, exponential, invariant, local
from boundaries import INVARIANT, SINGULAR, Equation, irreducible
from kovacic_verify import Rejected, check
from traps import changed, read

NAIVE = json.loads(read("data/strata/number.json"))["tree"]["certificate"]
SQUARE_ROOT = changed(NAIVE | {"field": {"name": "a", "minpoly": ["-2", "0", "1"]}, "r": {"num": ["0", ["0", "1"]], "den": ["1"]}},
                      ["steps", 0, "data", "prime"], {"p": "1009", "a": "439"})


FALSE = [                                   # why, of, path and value
    ("n is a JSON number", NAIVE, "claim n", 5),
    ("the claim is a JSON number", NAIVE, "claim abelian", 0),
    ("a leading coefficient 0", NAIVE, "r num", ["0", "1", "0"]),
    ("a minimal polynomial that is not irreducible", SQUARE_ROOT, "field minpoly", ["-4", "0", "1"]),
    ("a minimal polynomial that is not monic", SQUARE_ROOT, "field minpoly", ["-4", "0", "2"]),
    ("a field of degree 0", NAIVE, "field minpoly", ["1"]),
    ("r is a text", NAIVE, "r num", "01"),
    ("no such way", NAIVE, "steps 1 data by", "what"),
    ("a way that is not a text", NAIVE, "steps 1 data by", []),
    ("two coordinates over Q", NAIVE, "r num", ["0", ["1", "0"]]),
    ("no coordinate", NAIVE, "r num", ["0", []]),
    ("a is not a root modulo p", SQUARE_ROOT, "steps 0 data prime a", "438"),
    ("a is not reduced", SQUARE_ROOT, "steps 0 data prime a", str(439 + 1009)),
    ("p = 2", NAIVE, "steps 0 data prime p", "2"),
    ("p is not a prime", NAIVE, "steps 0 data prime p", "1007"),
    ("no steps", NAIVE, "steps", []),
    ("an unknown theorem", NAIVE, "steps 3 data theorem", "yes"),
    ("a premise of nothing", NAIVE, "steps 3 premises", ["none"]),
    ("a premise for the places", NAIVE, "steps 0 premises", ["local"]),
    ("nothing is claimed", NAIVE, "claim", dict.fromkeys(("group", "n", "component", "abelian"))),
]


def texts():
    """The data of the certificate itself"""
    yield "Airy's equation", NAIVE, True
    yield "over Q(sqrt 2)", SQUARE_ROOT, True
    yield from ((why, changed(top, path.split(), value), False) for why, top, path, value in FALSE)
    minus_1 = changed(changed(NAIVE, ["field", "minpoly"], ["1", "1"]), ["steps", 0, "data", "prime", "a"], "1008")
    yield "a field of degree 1 with the generator -1", minus_1, False
    yield "a character beyond the first plane", changed(NAIVE, ["steps", 3, "id"], "\U0001d53b"), True
    yield "half of it", changed(NAIVE, ["steps", 3, "id"], "\ud835"), False
    yield "the other half", changed(NAIVE, ["steps", 3, "id"], "\udd3b"), False
    yield "a key twice", json.dumps(NAIVE)[:-1] + ', "format": "kovacic-certificate/1"}', False
    yield "5000 digits", json.loads(abelian((["2"], ["0", "0", "1"]), 1, ["1" + "0" * 5000], (Z, "2"))), True
    unused = changed(NAIVE, ["steps", 1], NAIVE["steps"][1] | {"id": "again"})
    unused["steps"].insert(1, NAIVE["steps"][1])
    yield "a step is not used", unused, False
    last = changed(NAIVE, ["steps", 0], NAIVE["steps"][0])
    last["steps"].insert(3, NAIVE["steps"][1] | {"id": "again"})
    yield "the last but one is not used", last, False
    after = {"id": "after", "rule": "no-invariant", "premises": ["local", "conclusion"], "data": {"m": "2", "by": "degree"}}
    yield "a step after the conclusion", changed(NAIVE, ["steps", "+"], after), False
    two = ["4"], ["0", "0", "2"]
    yield "den is not monic", json.loads(abelian(two, 1, ["1"], (Z, "2"))), False
    yield "den is 0", json.loads(abelian((["1"], []), 1)), False
    for c in ("2^62", str(2**62), "-1", "0x1", "1.5", "01", "+1", "1/0", ""):
        yield f"{c} is not a residue", changed(NAIVE, ["steps", 0, "data", "prime", "a"], c), False


def simple_pole(equation, place, infinity=None):
    """Places of an equation with a simple pole, and that it has SL(2)"""
    rule, none, data = equation.local()
    for i, x in place.items():
        data = changed(data, ["places", i], {k: v for k, v in data["places"][i].items() if k in ("q", "order")} | x)
    return certificate(equation.r, {"group": "SL2"}, (rule, none, data | ({"infinity": infinity} if infinity else {})), irreducible(equation),
                       conclude("sl2-irreducible-log", 0, 1))


def places():
    one = ["1"], ["0", "0", "1"]            # Delta^2 = 5 at 0 and at infinity
    yield "4 is not a Delta^2 of a pole of order 2", diagonal(one, "cyclic", "2", [{"q": Z, "order": "2", "eps2": ["4"]}], ["1"], (Z, "1")), False
    right = json.loads(diagonal(one, "Gm", None, [AT_ZERO], ["1"], (Z, "1")))
    yield "the same at infinity", changed(right, ["steps", 0, "data", "infinity"], {"eps2": ["4"]}), False
    yield "Delta^2 is 5, not 5 + z", diagonal(one, "Gm", None, [AT_ZERO | {"delta2": ["5", "1"]}], ["1"], (Z, "1")), False
    yield "-z is not monic", diagonal(one, "Gm", None, [AT_ZERO | {"q": ["0", "-1"]}], ["1"], (Z, "1")), False
    yield "Delta is not known", diagonal((["-2/9"], ["0", "0", "1"]), "cyclic", "1", [{"q": Z, "order": "2"}], ["1"], (Z, "1")), False
    conjugate = {"q": ["-2", "0", "1"], "order": "2", "delta2": ["0", "1/10"]}
    yield "Delta^2 is not a number", certificate((["-2", "1/5"], ["4", "0", "-4", "0", "1"]), {"abelian": False}, local(conjugate), (
        "no-invariant", ["s0"], {"m": "4", "by": "degree"}), conclude("torus-nonabelian", 0, 1)), False
    for roots, right in ((["0"], True), (["1009"], False), ([], False), (["1"], False)):
        yield f"a logarithm at 0, {roots}", certificate((["3/4", "1"], ["0", "0", "1"]), {"group": "SL2"}, local(
            {"q": Z, "order": "2", "delta2": ["4"], "log": PRIME | {"roots": roots}}), ("no-exponential", ["s0"], {"by": "parity"}),
            conclude("sl2-irreducible-log", 0, 1)), right
    third, three = SINGULAR["order 2"], (["1"], ["0", "0", "0", "1"])
    yield "a logarithm without roots", simple_pole(third, {1: third.local()[2]["places"][1] | {"log": PRIME | {"roots": []}}}), False
    yield "eps^2 at infinity of order 5", json.dumps(changed(NAIVE, ["steps", 0, "data", "infinity"], {"eps2": []})), False

    def odd(place=None, infinity=None, equation=three):
        rule, none, data = local({"q": Z, "order": "3"} | (place or {}))
        return certificate(equation, {"abelian": False}, (rule, none, data | {"infinity": infinity or {}}),
                           ("no-invariant", ["s0"], {"m": "4", "by": "degree"}), conclude("torus-nonabelian", 0, 1))
    yield "a pole of order 3", odd(), True
    yield "eps^2 at a pole of order 3", odd({"eps2": ["4"]}), False
    yield "Delta^2 at a pole of order 3", odd({"delta2": ["4"]}), False
    yield "a logarithm at a pole of order 3", odd({"log": PRIME | {"roots": ["0"]}}), False
    yield "a logarithm at infinity of order 1", odd(infinity={"log": PRIME}), False
    yield "eps^2 at infinity of order 1", odd(infinity={"eps2": ["4"]}), False
    yield "the places do not make den", odd(equation=(["1"], ["0", "0", "0", "2", "1"])), False
    for why, row in (("a constant place", {"q": ["1"], "order": "2"}), ("a negative order", {"q": ["1", "1"], "order": "-1"}),
                     ("an order 0", {"q": ["1", "1"], "order": "0"})):
        yield f"{why} more", json.dumps(changed(json.loads(odd()), ["steps", 0, "data", "places", "+"], row)), False
    two = {"q": Z, "order": "2"}
    for why, rows in (("q is not squarefree", [{"q": ["0", "0", "1"], "order": "1"}]), ("a place twice", [{"q": Z, "order": "1"}] * 2),
                      ("a constant place", [{"q": ["1"], "order": "2"}, two]), ("an order 0", [{"q": ["1", "1"], "order": "0"}, two]),
                      ("q is not monic", [{"q": ["0", "-1"], "order": "2"}]),
                      ("a negative order", [{"q": ["1", "1"], "order": "-1"}, {"q": Z, "order": "3"}])):
        yield why, certificate((["-2/9"], ["0", "0", "1"]), {"group": "T"}, local(*rows), exponential(["1"], ["1/3"], Z),
                               conclude("additive", 0, 1)), False
    yield "num and den have a common factor", odd(equation=(Z, ["0", "0", "0", "1"])), False
    four = SINGULAR["order 4, infinity of order 2"]
    eps2 = four.local()[2]["places"][1]["eps2"]
    yield "the places of an equation", simple_pole(four, {}), True
    yield "eps^2 of too high a degree", simple_pole(four, {1: {"eps2": [eps2[0], "1"]}}), False
    yield "another eps^2", simple_pole(four, {1: {"eps2": [f"-{eps2[0]}"]}}), False
    yield "Delta^2 at a simple pole", simple_pole(four, {0: {"delta2": ["1"]}, 1: {"eps2": eps2}}), False


def logarithms():
    """Delta = 2 at 1 and at -1, with a logarithm at one of them or at both"""
    # r = 3/4 (z - 1)^-2 + 3/4 (z + 1)^-2 + b/(z - 1) + c/(z + 1): a logarithm at 1 unless b + ... = 0
    for b, c in ((F(1), F(2)), (F(1), F(0))):
        r = [str(x) for x in (F(3, 2) - b + c, -b - c, F(3, 2) + b - c, b + c)], ["1", "0", "-2", "0", "1"]

        def top(roots, one=None, other=None, r=r):
            rows = [{"q": ["-1", "0", "1"], "order": "2", "delta2": ["4"], "log": PRIME | {"roots": roots}}] if one is None else [
                {"q": ["-1", "1"], "order": "2", "delta2": ["4"]} | one, {"q": ["1", "1"], "order": "2", "delta2": ["4"]} | other]
            return certificate(r, {"group": "SL2"}, local(*rows), ("p-curvature", [], {"p": "5", "a": "0", "shows": "irreducible"}),
                               conclude("sl2-irreducible-log", 0, 1))
        yield f"{b}, {c}: one root", top(["1"]), None
        yield f"{b}, {c}: both roots", top(["1", "1008"]), None
        yield f"{b}, {c}: the other root", top(["1008"]), None
        yield f"{b}, {c}: a root twice", top(["1", "1"]), False
        yield f"{b}, {c}: no roots", top([]), False
        yield f"{b}, {c}: not a root", top(["2"]), False
        yield f"{b}, {c}: not reduced", top(["1010"]), False
        yield f"{b}, {c}: two places", top(None, {"log": PRIME | {"roots": ["1"]}}, {}), None
        yield f"{b}, {c}: a root of the other place", top(None, {"log": PRIME | {"roots": ["1008"]}}, {}), False
        yield f"{b}, {c}: a root of the first place", top(None, {}, {"log": PRIME | {"roots": ["1"]}}), False


def rules():
    v, good = INVARIANT[0], {"p": "101", "a": "0"}

    def idle(rule, premises, data, right=False):
        return certificate(v.r, {"abelian": True}, v.local(), v.v(), (rule, premises, data), conclude("invariant-abelian", 0, 1, 2)), right
    for why, (text, right) in (
            ("an invariant with a premise", idle("invariant", ["s0"], v.v()[2])),
            ("an invariant again", idle("invariant", [], v.v()[2], True)),
            ("an invariant of degree 4", idle("invariant", [], v.v(4)[2], True)),
            ("the same of degree 2", idle("invariant", [], v.v(4)[2] | {"m": "2"})),
            ("a good reduction of no curve", idle("good-reduction", ["s1"], good)),
            ("a good reduction without an invariant", idle("good-reduction", ["s0"], good)),
            ("a torsion function of no curve", idle("torsion-function", ["s1"], {"n": "1", "a": ["1"], "b": [], "den": ["1"], "minimal": []})),
            ("an approximant without places", idle("no-exponential", [], {"by": "degree"})),
            ("a rank without places", idle("no-invariant", [], {"m": "2", "by": "degree"})),
            ("sl2 without places", idle("p-curvature", [], {"p": "11", "a": "0", "shows": "sl2"})),
            ("a p-curvature that shows something else", idle("p-curvature", [], good | {"shows": "all"})),
            ("an odd degree", idle("no-invariant", ["s0"], {"m": "3", "by": "degree"}))):
        yield why, text, right
    for m, right in (("200", True), ("202", False), ("199", False), ("0", False), ("-2", False)):
        yield f"Airy, degree {m}", certificate(AIRY, {"abelian": False}, local(), ("no-invariant", ["s0"], {"m": m, "by": "degree"}),
                                               ("no-invariant", ["s0"], {"m": "4", "by": "degree"}), conclude("torus-nonabelian", 0, 1, 2)), right
    for x0, right in (("5", True), ("1009", False)):
        yield f"x0 = {x0}", certificate(AIRY, {"abelian": False}, local(), ("no-invariant", ["s0"], {
            "m": "2", "by": "series", "p": "1009", "a": "0", "x0": x0, "terms": "9"}),
            ("no-invariant", ["s0"], {"m": "4", "by": "degree"}), conclude("torus-nonabelian", 0, 1, 2)), right
    for e, right in (("1/2", False), ("1/3", False), ("1", True), ("3/2", False)):
        yield f"an invariant of degree 1 with e = {e}", abelian(([], ["1"]), 1, ["1"], (Z, e)), right


def certificates():
    for family in (texts, places, logarithms, rules):
        for why, top, right in family():
            text = top if isinstance(top, str) else json.dumps(top)
            yield f"{family.__name__}: {why}", text, accepted(text) if right is None else right


def accepted(text):
    try:
        check(text)
        return True
    except Rejected:
        return False
