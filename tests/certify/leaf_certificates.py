"""Certificates over strata with one leaf, each right one beside a wrong one that breaks one rule of strata_certificates.md 7 and no
other."""
import json
from fractions import Fraction as F

import leaves
from leaves import A, B


def top(num, den, by, *places, nonzero=(), positive=(), infinity=(), content="1", **more):
    """A certificate that is this leaf; a and b are real, and places are (q, order, what is said)"""
    tree = {"node": "leaf", "abelian": "no", "by": by, "content": content, "infinity": dict(infinity),
            "places": [x | {"q": q, "order": str(k)} for q, k, x in places]} | more
    signs = [{"p": p, "sign": "nonzero"} for p in nonzero] + [{"p": p, "sign": "positive"} for p in positive]
    return {"format": "kovacic-strata/1", "variable": "z", "parameters": ["a", "b"], "real": ["a", "b"], "assumptions": signs,
            "generic": [], "r": {"num": num, "den": den}, "claim": {"abelian": False}, "tree": tree}


def chi(*v, **more):
    return {"chi": list(v)} | more


def meeting():
    """Roots and places stay apart."""
    two, apart = [("z^2 - a", 1, {})], [("z", 1, {}), ("z - a", 1, {})]
    for known, right in ((["a", "b^2 - a"], True), (["b^2 - a"], False), (["a"], False)):
        yield f"two roots, {known}", top("z + b", "z^2 - a", "torus-log", *two, nonzero=known), right
    for known, right in ((["a", "a^4 + 1"], True), (["a^4 + 1"], False), (["a"], False)):
        yield f"two places, {known}", top("z^4 + 1", "z^2 - a*z", "torus-log", *apart, nonzero=known), right


def said():
    """What may be said of a place of each order"""
    for more, right in (({"log": True}, True), (chi("-1", "1"), False), ({"bound": "1"}, False), ({"irrational": "constant"}, False)):
        yield f"order 1, {more}", top("z^2 + 1", "z", "torus-log", ("z", 1, more)), right
    yield "growth", top("z^2 + 1", "z", "torus-log", ("z", 1, {}), growth={"factor": "1", "shift": "0"}), False
    for more, right in (({}, True), ({"log": True}, False), (chi("-1", "1"), False)):
        yield f"order 3, {more}", top("2*z + 1", "z^4 - z^3", "torus-log", ("z", 3, more), ("z - 1", 1, {})), right
    for more in ({}, chi("-4*a - 1", "1"), chi("16*a^2 + 8*a + 1", "-8*a - 2", "1")):
        for by in ("torus-log", "open", "one-open"):
            right = by == "torus-log" or by == "one-open" and len(more.get("chi", ())) == 2    # a torus and a logarithm
            yield f"open, {more}, {by}", top("z^5 + a*z - a", "z^3 - z^2", by, ("z", 2, more), ("z - 1", 1, {})), right


def quadratic():
    """Delta^2 = -1 +- i or -1 at the roots of z^2 + 1: all of chi is positive, and the real parts of Delta are known for -1 only;
    1 +- i, which a discriminant shows to be irrational."""
    den, simple = "z^5 + 2*z^3 + z", ("z", 1, {})
    for num, given, right in (("z^2 + 2*z + 2", chi("2", "2", "1"), False), ("z^2 + 2*z + 1", chi("1", "1"), True)):
        place = "z^2 + 1", 2, given | {"irrational": "positive"}
        yield f"a bound by signs, {given}", top(num, den, "irreducible-log", place, simple), right
    # b = i: of the values 0 and 1 at the roots of z^2 - 1
    place = "z^2 - 1", 2, chi("0", "-b", "b", irrational="discriminant")
    yield "values 0 and 1, b^2 < 0", top("1 - z", "2*z^5 - 4*z^3 + 2*z", "torus-log", place, simple, content="2", positive=["-b^2"],
                                         nonzero=["b"]) | {"real": ["a"]}, False
    for why, right in (("discriminant", True), ("faith", False), ("positive", False), ("constant", False)):
        place = "z^2 + 1", 2, chi("2", "-2", "1", irrational=why)
        yield f"a quadratic chi, {why}", top("z^2 + 2", den, "torus-log", place, simple), right


def squares():
    """Of a, which is not 0: a^2 > 0 and a^2 + 1 > 0 if a is real, and not for a = i; but a^2 is not 0.  y'' = p z y"""
    square, known = ["1", ["square", "a", "1"]], [{"p": "a", "sign": "nonzero"}]
    for real in ["a"], []:
        for p, num, terms in ("a^2 + 1", "z*a^2 + z", [["1", ["condition", "1", "1"]], ["1"]]), ("a^2", "z*a^2", [square]):
            airy = top(num, "1", "torus")
            split = {"node": "split", "p": p, "nonzero": airy["tree"], "zero": {"zero": "empty", "terms": terms}}
            lemmas = [{"p": "a^2", "sign": "positive", "terms": [square]}] if p != "a^2" else []
            tree = {"node": "lemmas", "lemmas": lemmas, "then": split}
            yield f"{p}, real {real}", airy | {"real": real, "assumptions": known, "tree": tree}, bool(real) or p == "a^2"


def logarithms():
    """At one root, where Delta is a natural number, or 0"""
    for more in ({}, {"log": True}):
        yield f"Delta = 0, {more}", top("z - 1", "4*z^2", "torus-log", ("z", 2, chi("0", "1", **more)), content="4"), True
        two = "z^2 - 1", 2, chi("0", "1", **more)
        yield f"Delta = 0 twice, {more}", top("z^3 - z - 1", "z^4 - 2*z^2 + 1", "torus-log", two), True
    yield "no logarithm is shown", top("z^3 + a*z", "z^2", "torus-log", ("z", 2, chi("-1", "1")), nonzero=["a"]), False
    for num, right in (("z^3 + a*z", True), ("z^3 + b*z", False)):
        yield f"Delta = 1, {num}", top(num, "z^2", "torus-log", ("z", 2, chi("-1", "1", log=True)), nonzero=["a"]), right
    two = "z^2 - 1", 2, chi("-1", "1", log=True)
    yield "two roots", top("z^3 - z", "z^4 - 2*z^2 + 1", "torus-log", two), False


def minors():
    """r = 1 + a/(z - 1): the conditions for an invariant of degree 4 are 8 a (5 - 8 a), 8 a (16 a - 21), 64 a (3 - a), -64 a."""
    def leaf(*rows, known=("a",), m=4, times="1", prime=None):
        absent = {"m": str(m), "minors": [{"rows": [str(i) for i in r], "times": t} for r, t in zip(rows, (times, "1"))]}
        return top("z^2 + a*z - 2*z - a + 1", "z^2 - 2*z + 1", "torus", ("z - 1", 2, chi("-1", "1")), nonzero=known,
                   absent=[absent | ({"prime": prime} if prime else {})])
    for rows, more, right in (
            ([[3]], {}, True), ([[3]], {"known": ()}, False), ([[0]], {}, False), ([[0]], {"known": ("a", "8*a - 5")}, True),
            ([[-1]], {}, False), ([[4]], {}, False), ([[3, 2]], {}, False), ([[]], {}, False), ([[3]], {"m": 6}, False),
            ([[0], [3]], {"times": "0"}, True), ([[0], [3]], {"times": "8*a"}, False),
            ([[0], [3]], {"prime": "7"}, True), ([[3]], {"prime": "7"}, False), ([[3], [0]], {"prime": "2"}, True),
            ([[0], [3]], {"prime": "2"}, False),
            ([[0], [3]], {"prime": "4"}, False), ([[0], [3]], {"prime": "7", "times": "2"}, False),
            ([[0], [3]], {"prime": "7", "known": ()}, False),
            ([[0], [1]], {"prime": "31"}, True), ([[0], [1]], {"prime": "2147483647"}, True), ([[0], [1]], {"prime": "2147483659"}, False)):
        yield f"rows {rows}, {more}", leaf(*rows, **more), right


def premises():
    """What each theorem asks for: differences at 0, 1 and infinity, with no invariant of degree 4, as D_4 < 0"""
    def leaf(by, squares, infinity, bounds=(), how=(), signs=()):
        r, more = leaves.Fraction.sum(leaves.regular(squares, infinity)), [{"bound": x} for x in bounds] + [{}, {}]
        places = [leaves.place(x, **y, **({"irrational": "constant"} if x in how else {})) for x, y in zip(squares, more)]
        return leaves.certificate(by, r, places, leaves.place(infinity)) | {"assumptions": [{"p": p, "sign": s} for p, s in signs]}
    third, seventh, fifth = F(1, 9), F(1, 49), F(1, 25)
    for by, right in (("rational", True), ("torus", False), ("irreducible-log", False), ("torus-log", False), ("open", False),
                      ("one-open", False)):
        yield f"1/3, 1/7, 1/5: {by}", leaf(by, [third, seventh], fifth), right
    for by, right in (("torus", True), ("rational", False), ("torus-log", False)):
        yield f"sqrt(2), 1/7, 1/5: {by}", leaf(by, [2, seventh], fifth, how=(2,)), right
    for by in ("one-open", "open"):
        yield f"no bound: {by}", leaf(by, [A, 2], fifth, how=(2,)), False
        yield f"no bound, no torus: {by}", leaf(by, [A, seventh], fifth), False
    values = {F(a, n) for n in (2, 3, 4, 5) for a in range(1, 8) if F(a, n) <= F(3, 2)}
    apart = [(f"{v.denominator**2}*{x} - {v.numerator**2}", "nonzero") for x in "AB" for v in sorted(values)]
    # Delta_A + Delta_B - 1/3 may be 1: the group may be reducible
    above = [*apart, ("9 - 4*A", "positive"), ("9 - 4*B", "positive")]
    yield "open: there may be a line", leaf("open", [A, B], third, ["9/4"] * 2, signs=above), False
    yield "open: D_1 < 0", leaf("open", [A, B], third, ["0"] * 2, signs=[("-A", "positive"), ("-B", "positive")]), True
    below = [*apart, ("1 - 4*A", "positive"), ("1 - 4*B", "positive")]
    yield "open: a line is not excluded by a bound of 1/4", leaf("open", [A, B], third, ["1/4"] * 2, signs=below), False


def certificates():
    """(name, text, is it right?)"""
    for family in (meeting, said, quadratic, squares, logarithms, minors, premises):
        for name, leaf, right in family():
            yield f"{family.__name__}: {name}", json.dumps(leaf), right
