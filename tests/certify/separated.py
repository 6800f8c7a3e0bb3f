"""Leaves `separated` of certificates over strata (strata_certificates.md 7.9), each beside one that has a hypothesis less or a bound
that is too weak.  Either the places +-i, with Delta^2 = u +- i v, and 0, where it is D; or 0, 1 (S and T) and infinity (D)."""
import json


def top(num, den, leaf, lemmas=(), real=("c", "d", "e"), assumptions=()):
    leaf = {"node": "leaf", "abelian": "no", "by": "separated"} | leaf
    return {"format": "kovacic-strata/1", "variable": "z", "parameters": ["c", "d", "e"], "real": list(real),
            "assumptions": [{"p": p, "sign": sign} for p, sign in assumptions], "generic": [], "r": {"num": num, "den": den},
            "claim": {"abelian": False}, "tree": {"node": "lemmas", "lemmas": list(lemmas), "then": leaf} if lemmas else leaf}


def square(x, c="1"):
    """c x^2 > 0, where x is known not to be 0"""
    return {"p": f"{x}^2", "sign": "positive", "terms": [[c, ["square", x, "1"]]]}


def third(chi, **more):
    return {"q": "z", "order": "2", "chi": chi} | more


def conjugate(num, content, chi, first, why="discriminant", **more):
    """r = num/(content z^2 (z^2 + 1)^2)"""
    pair = {"q": "z^2 + 1", "order": "2", "chi": chi, "irrational": why}
    leaf = {"content": str(content), "places": [first, pair], "infinity": {}}
    growth = more.pop("growth", None)
    leaf |= {"growth": {"factor": growth[0], "shift": growth[1]}} if growth else {}
    return top(num, f"{content}*z^6 + {2 * content}*z^4 + {content}*z^2", leaf, **more)


def top_in_a_field(**changes):
    """D = 4c, u = 2c - 7/4, v = -4d: the symmetric heavy top; 2 (u + u) = 2 D - 7"""
    data = {"growth": ("2", "7"), "lemmas": [square("d")], "assumptions": [("d", "nonzero")]} | changes
    return conjugate("-4*z^2*c + 10*z^2 - 16*z*d + 4*c - 1", 4, ["64*c^2 - 112*c + 49 + 256*d^2", "-64*c + 56", "16"],
                     third(["-4*c", "1"]), **data)


def shifted(s, factor=2, **changes):
    """D = 4c, v = d, 4 u = factor D - s: u = factor c - s/4.  num: (D - 1) + 4 v z + (D + 3 - 4 u) z^2"""
    data = {"growth": (str(factor), str(s)), "lemmas": [square("d")], "assumptions": [("d", "nonzero")]} | changes
    chi = [f"{16 * factor**2}*c^2 - {8 * factor * s}*c + {s * s} + 16*d^2", f"-{32 * factor}*c + {8 * s}", "16"]
    return conjugate(f"4*c - 1 + 4*z*d + {4 - 4 * factor}*z^2*c + {3 + s}*z^2".replace("+ -", "- "), 4, chi,
                     third(["-4*c", "1"]), **data)


def growing():
    yield "the heavy top", top_in_a_field(), True
    yield "the square of d forgotten", top_in_a_field(lemmas=[]), False
    yield "d may be 0", top_in_a_field(assumptions=[], lemmas=[]), False
    yield "complex c", top_in_a_field(real=["d", "e"]), False
    yield "complex d", top_in_a_field(real=["c", "e"]), False
    for growth in (("2", "13/2"), ("3", "7"), ("9/4", "7"), ("1", "7/2"), ("-2", "-7"), ("2", "-7")):
        yield f"another growth, {growth}", top_in_a_field(growth=growth), False
    yield "no growth", top_in_a_field(growth=None), False
    # Delta^2 = -2 at both roots, 1/4 at 0
    for chi, right in (("2 1", True), ("4 4 1", True), ("6 5 1", False), ("24 26 9 1", False), ("8 12 6 1", False), ("12 4 1 1", False)):
        yield f"twice the same value, {chi}", conjugate("45*z^2 - 3", 16, chi.split(), third(["-1", "4"]), "positive"), right
    # n = 2, k = 1 is left for 4 < 8 - s + ..., that is s > 7
    difference, sum_ = ("c - 1", "nonzero"), ("16*c + 4*d^2 - 9", "nonzero")
    yield "s = 7", shifted(7), True
    yield "s = 8", shifted(8), False
    yield "s = 8, D != 4", shifted(8, assumptions=[("d", "nonzero"), difference]), True
    yield "s = 8, d1 + d2 != 1", shifted(8, assumptions=[("d", "nonzero"), ("8*c + 4*d^2 - 9", "nonzero")]), True
    yield "s = 8, another sum", shifted(8, assumptions=[("d", "nonzero"), sum_]), False
    # factor 1: n < (s + 1)/2
    yield "factor 1, s = 3", shifted(3, 1), True
    yield "factor 1, s = 4", shifted(4, 1), False
    yield "factor 1, s = 4, D != 4", shifted(4, 1, assumptions=[("d", "nonzero"), difference]), True
    yield "factor 1, s = 5", shifted(5, 1, assumptions=[("d", "nonzero"), difference]), True
    yield "factor 1, s = 6", shifted(6, 1, assumptions=[("d", "nonzero"), difference]), False
    yield "factor 1, s = 6, D != 9", shifted(6, 1, assumptions=[("d", "nonzero"), difference, ("4*c - 9", "nonzero")]), True
    yield "less than 1", shifted(3, 1, growth=("3/4", "3")), False
    # more than that: u = 2c - 7/4 + e^2/4
    more = conjugate("-4*z^2*c + 10*z^2 - z^2*e^2 - 16*z*d + 4*c - 1", 4,
                     ["64*c^2 - 112*c + 49 + 256*d^2 + 16*c*e^2 - 14*e^2 + e^4", "-64*c + 56 - 8*e^2", "16"], third(["-4*c", "1"]),
                     growth=("2", "7"), lemmas=[square("d"), square("e")], assumptions=[("d", "nonzero"), ("e", "nonzero")])
    yield "more than the growth", more, True
    yield "more or as much", more | {"assumptions": [{"p": "d", "sign": "nonzero"}], "tree": more["tree"] | {"lemmas": [square("d")]}}, False


def constant():
    """Of u +- i v = 1/2 +- i: the sums are not integers.  Of -3/4 +- i: 1"""
    half = conjugate("c - 1 + 4*z + z^2*c + z^2", 4, ["5", "-4", "4"], third(["-c", "1"]))
    yield "no sum is an integer", half, True
    one = ("c - 1 + 4*z + z^2*c + 6*z^2", 4, ["25", "24", "16"])
    yield "a sum is 1", conjugate(*one, third(["-c", "1"])), False
    for b, p, right in (("9/4", "9 - 4*c", True), ("4", "4 - c", True), ("9", "9 - c", False)):
        yield f"a sum is 1, D < {b}", conjugate(*one, third(["-c", "1"], bound=b), assumptions=[(p, "positive")]), right
    yield "a sum is 1, D <= 4", conjugate(*one, third(["-c", "1"], bound="4"), assumptions=[("4 - c", "nonnegative")]), False
    yield "a sum is 1, D < 9, D != 4", conjugate(*one, third(["-c", "1"], bound="9"), assumptions=[("9 - c", "positive"), ("c - 4", "nonzero")]), True
    nine = conjugate("8 + 4*z + 15*z^2", 4, ["25", "24", "16"], third(["-9", "1"]))
    yield "a sum is 1, D = 9", nine, True
    yield "a sum is 1, D = 4", conjugate("3 + 4*z + 10*z^2", 4, ["25", "24", "16"], third(["-4", "1"])), False
    yield "a sum is 1, D = 1/4", conjugate("-3 + 16*z + 25*z^2", 16, ["25", "24", "16"], third(["-1", "4"])), True
    yield "a sum is 1, D = 25/4", conjugate("21 + 16*z + 49*z^2", 16, ["25", "24", "16"], third(["-25", "4"])), True
    # n = 2 is among the n up to the least j/2 with (j/2)^2 >= 15/4
    yield "a sum is 1, D < 15/4", conjugate(*one, third(["-c", "1"], bound="15/4"), assumptions=[("15 - 4*c", "positive")]), False


def large():
    """1000 values of n, with the only sum d1 + d2 = 1000 of 249999 +- 1000 i, or 1"""
    def of(first, p, **more):
        return conjugate("c - 1 + 4000*z + z^2*c - 999993*z^2", 4, ["62500500001", "-499998", "1"], third(["-c", "1"], **first),
                         assumptions=[(p, "positive")], **more)
    for b in 1000000, 1000001:
        yield f"D < {b}", of({"bound": str(b)}, f"{b} - c"), b == 1000000
    for s in 1998, 2000:
        yield f"n < (s + 1)/2, s = {s}", of({}, f"{999996 + s} - c", growth=("1", str(s))), s == 1998
    for n in 999, 1001:
        yield f"D = {n}^2", conjugate(f"{n * n - 1} + 4*z + {n * n + 6}*z^2", 4, ["25", "24", "16"], third([str(-n * n), "1"])), n == 999
    yield "D = 1000^2, a sum is 2", conjugate("999999 + 8*z + 1000003*z^2", 4, ["4", "0", "1"], third(["-1000000", "1"])), True


def separate(**changes):
    """0 and 1 with S = -c, T = -d, and D = e at infinity: num = ((S-1)(z-1)^2 + (T-1) z^2 + (1-S-T+D) z(z-1))"""
    num = "z^2*e - z^2 - z*e + z*c - z*d + z - c - 1"
    data = {"assumptions": [("c", "positive"), ("d", "positive"), ("c - d", "nonzero")]} | changes
    places = [{"q": "z", "order": "2", "chi": ["c", "1"], "irrational": "positive"},
              {"q": "z - 1", "order": "2", "chi": ["d", "1"], "irrational": "positive"}]
    leaf = {"content": "4", "places": places, "infinity": {"chi": ["-e", "1"]} | data.pop("infinity", {})}
    return top(num, "4*z^4 - 8*z^3 + 4*z^2", leaf, **data)


def imaginary():
    good = separate()
    yield "both imaginary, different", good, True
    yield "both imaginary", separate(assumptions=[("c", "positive"), ("d", "positive")]), False
    yield "complex e", separate(real=["c", "d"]), True
    both = [("c", "positive"), ("d", "positive"), ("2 - e", "positive")]
    yield "both imaginary, e < 2", separate(assumptions=both, infinity={"bound": "2"}), False
    yield "both imaginary, e < 2, not 1", separate(assumptions=[*both, ("e - 1", "nonzero")], infinity={"bound": "2"}), True
    yield "both imaginary, 4 e < 1", separate(assumptions=[*both[:2], ("1 - 4*e", "positive")], infinity={"bound": "1/4"}), True


def others():
    good = top_in_a_field()
    leaf = good["tree"]["then"]
    # Delta^2 = -c at both of +-i: chi has another root, and D = 1 leaves something abelian.  v = 0, u = -c
    num, both = "e - 1 + z^2*e + 4*z^2*c + 3*z^2", [("c", "positive"), ("d", "positive"), ("c - d", "nonzero"), ("2 - e", "positive")]
    one = third(["-e", "1"], bound="2")
    yield "twice the same", conjugate(num, 4, ["c", "1"], one, "positive", assumptions=both), False
    yield "one of two", conjugate(num, 4, ["c*d", "c + d", "1"], one, "positive", assumptions=both), False
    yield "twice the same, not 1", conjugate(num, 4, ["c", "1"], one, "positive", assumptions=[*both, ("e - 1", "nonzero")]), True
    for by in ("torus", "open", "one-open", "rational"):
        yield f"growth and {by}", good | {"tree": good["tree"] | {"then": leaf | {"by": by}}}, False
    yield "abelian", good | {"tree": good["tree"] | {"then": leaf | {"abelian": "yes"}}, "claim": {"abelian": True}}, False
    # one more place, at infinity: r + 1/z^2
    more = conjugate("4*z^4*e - 4*z^2*c + 8*z^2*e + 10*z^2 - 16*z*d + 4*c - 1 + 4*e", 4, ["64*c^2 - 112*c + 49 + 256*d^2", "-64*c + 56", "16"],
                     third(["-4*c - 4*e", "1"]), growth=("2", "7"), lemmas=[square("d")], assumptions=[("d", "nonzero"), ("e", "nonzero")])
    more["tree"]["then"]["infinity"] = {"chi": ["-4*e - 1", "1"]}
    yield "four places", more, False


def certificates():
    for group in (growing, constant, large, imaginary, others):
        for name, text, right in group():
            yield f"{group.__name__}: {name}", json.dumps(text), right
