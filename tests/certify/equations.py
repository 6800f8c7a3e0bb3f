"""Small certificates of the format kovacic-certificate/1, each wrong in one rule of certificates.md 2 and right in all others, beside
those that are right."""
import copy
import json

PRIME = {"p": "2305843009213693967", "a": "0"}


def step(rule, data, *premises, name=None):
    return {"id": name or rule, "rule": rule, "premises": list(premises), "data": data}


def certificate(num, den, steps, field=("0", "1"), **claim):
    return {"format": "kovacic-certificate/1", "field": {"name": "", "minpoly": list(field)},
            "r": {"num": num.split(),
                  "den": den.split()}, "claim": dict.fromkeys(("group", "n", "component", "abelian")) | claim, "steps": steps}


def place(q, order, **more):
    return {"q": q.split(), "order": str(order)} | more


def local(*places, **infinity):
    return step("local", {"prime": PRIME, "places": list(places), "infinity": infinity})


SL2 = {"group": "SL2", "component": "SL2", "abelian": False}


def parity(num, den, *places, more=(), **infinity):
    """Irreducible as an order is odd, with a logarithm"""
    names = [s["id"] for s in more]
    return certificate(num, den, [local(*places, **infinity), step("no-exponential", {"by": "parity"}, "local"), *more, step(
        "conclude", {"theorem": "sl2-irreducible-log"}, "local", "no-exponential", *names)], **SL2)


def irreducible():
    """r = z + 1/(z - 1) + 1/z^2, where infinity is of order 5"""
    def top(zero, one=None, *more, **infinity):
        return parity("-1 1 1 -1 1", "0 0 -1 1", place("0 1", 2, **zero), place("-1 1", 1, **(one or {})), *more, **infinity)
    right = {"delta2": ["5"]}
    yield "two poles", top(right), True
    yield "nothing is said of Delta", top({}), True
    yield "another Delta", top({"delta2": ["4"]}), False
    yield "eps^2 at a pole of order 2", top({"eps2": ["4"]}), False
    yield "eps^2 and Delta", top(right | {"eps2": ["4"]}), False
    yield "Delta at a simple pole", top(right, {"delta2": ["1"]}), False
    for p in ("3", "5", "7", "11", "13", "17"):
        yield f"irrational at a simple pole, {p}", top(right, {"irrational": {"p": p, "a": "0"}}), False
    yield "a logarithm at a simple pole", top(right, {"log": {"p": "7", "a": "0", "roots": ["1"]}}), False
    yield "a logarithm at infinity", top(right, log={"p": "7", "a": "0"}), False
    # y = z exp(z): a place without a point is of odd order
    z = place("0 1", 1)
    yield "no odd order", parity("2 1", "0 1", z), False
    for q, order in (("1", 3), ("1", 1), ("2", 3)):
        yield f"a place without a point, {q}, {order}", parity("2 1", "0 1", z, place(q, order)), False


def logarithms():
    """Delta = 2 at 1 and -1, with a logarithm at each: r = z + 3 (z^2 + 1)/(2 (z^2 - 1)^2) + 2/(z^2 - 1)"""
    num, den = "-1/2 1 7/2 -2 0 1", "1 0 -2 0 1"
    for roots, right in ((["1", "6"], True), (["1"], True), (["1", "8"], False), (["1", "1"], False), (["13"], False), ([], False),
                         (["2"], False)):
        yield f"{roots}", parity(num, den, place("-1 0 1", 2, delta2=["4"], log={"p": "7", "a": "0", "roots": roots})), right


def trivial():
    """y'' = 0: an invariant, and no logarithm at infinity"""
    for den, right in (("1", True), ("2", False), ("0 1", False)):
        one = step("invariant", {"prime": PRIME, "m": "1", "p": ["1"], "factors": []})
        yield f"0/({den})", certificate("", den, [one, step("conclude", {"theorem": "invariant-abelian"}, "invariant")],
                                        abelian=True), right
    line = step("exponential", {"p": ["1"], "num": [], "den": ["1"]})
    end = step("conclude", {"theorem": "additive"}, "local", "exponential")
    yield "not additive", certificate("", "1", [local(), line, end], group="T", n="1"), False
    simple = step("exponential", {"p": ["0", "1"], "num": ["1"], "den": ["1"]})
    yield "additive", certificate("2 1", "0 1", [local(place("0 1", 1)), simple, end | {"data": {"theorem": "borel"}}], group="Borel"), True


def fields():
    """Airy's equation; Q is the field of z, and of no other linear polynomial"""
    curvature = step("p-curvature", {"p": "7", "a": "0", "shows": "sl2"}, "local")
    top = certificate("0 1", "1", [local(), curvature, step("conclude", {"theorem": "sl2-p-curvature"}, "p-curvature")], **SL2)
    yield "Q", top, True
    other = copy.deepcopy(top)
    other["field"]["minpoly"] = ["1", "1"]
    other["steps"][0]["data"]["prime"]["a"], other["steps"][1]["data"]["a"] = str(int(PRIME["p"]) - 1), "6"
    yield "Q(-1)", other, False
    for shows, right in (("nonzero", True), ("irreducible", True), ("faith", False)):
        more = [step("p-curvature", {"p": "7", "a": "0", "shows": shows}, "local")]
        yield f"a p-curvature shows {shows}", parity("1 0 1", "0 1", place("0 1", 1), more=more), right


def reading():
    """A method is one of the table"""
    top = next(irreducible())[1]
    for by, right in (("parity", True), ("faith", False), (["parity"], False), (None, False)):
        other = copy.deepcopy(top)
        other["steps"][1]["data"]["by"] = by
        yield f"by {by}", other, right


def certificates():
    """(name, text, is it right?)"""
    for family in (irreducible, logarithms, trivial, fields, reading):
        for name, top, right in family():
            yield f"{family.__name__}: {name}", json.dumps(top), right
