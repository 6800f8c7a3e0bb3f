"""Certificates over strata (kovacic-strata/1) by hand: at each node of data/strata one requirement is changed that the rule
names, and true ones beside them.  certificates() yields what is stated, the text and whether it is right."""
import json

from traps import changed, read

LEAF = {"node": "leaf", "abelian": "no", "by": "torus", "content": "1", "places": [], "infinity": {}}
AIRY = json.loads(read("data/strata/number.json"))["tree"]["certificate"]


def certificate(parameters, num, tree, abelian=False, den="1", **more):
    return {"format": "kovacic-strata/1", "variable": "z", "parameters": parameters, "real": [], "assumptions": [], "generic": [],
            "r": {"num": num, "den": den}, "claim": {"abelian": abelian}, "tree": tree} | more


def lemma(p, sign, then=None, **how):
    return {"node": "lemmas", "lemmas": [{"p": p, "sign": sign} | how], "then": then or LEAF}


def positive(*names):
    return [{"p": x, "sign": "positive"} for x in names]


FALSE = [                                   # of, why, then path and value, or pairs of them
    ("invariant", "a claim that is neither true nor false", "claim abelian", "yes"),
    ("invariant", "an empty claim", "claim abelian", ""),
    ("invariant", "abelian is not what an invariant denies", "tree abelian", "no"),
    ("number", "13 parameters", "parameters", [f"a{i}" for i in range(13)]),
    ("number", "a parameter twice", "parameters", ["a", "a"]),
    ("number", "a parameter called as the variable", "parameters", ["z"]),
    ("number", "no name", "parameters", ["2a"]),
    ("number", "real is not a parameter", "real", ["a"]),
    ("empty", "real twice", "real", ["a", "a", "b"]),
    ("empty", "an empty group", "generic", [[]]),
    ("empty", "an unknown sign", "assumptions 0 sign", "large"),
    ("rational_prime", "rational twice", "rational", ["n", "n"]),
    ("rational_prime", "rational is not a parameter", "rational", ["n", "m"]),
    ("rational_prime", "a prime and terms", "tree lemmas 0 terms", [["1", ["square", "n", "1"]]]),
    ("rational_prime", "a root modulo the prime", "tree lemmas 0 prime", "5"),
    ("rational_prime", "the first coefficient vanishes modulo the prime", "tree lemmas 0 prime", "2"),
    ("rational_prime", "9 is not a prime", "tree lemmas 0 prime", "9"),
    ("rational_prime", "1 is not a prime", "tree lemmas 0 prime", "1"),
    ("rational_prime", "a prime shows no sign", "tree lemmas 0 sign", "positive"),
    ("rational_prime", "real is not rational", ("rational", []), ("real", ["n"])),
    ("number", "a split at a number", "tree", {"node": "split", "p": "2", "nonzero": LEAF, "zero": {"zero": "empty"}}),
    ("number", "a split at 0", "tree", {"node": "split", "p": "0", "nonzero": {"node": "empty"}, "zero": {"zero": "open", "reason": ""}}),
    ("assumed", "another factor may be the one that is 0", "assumptions 1 p", "a*b^2 - 3*a*b + 2*a"),
    ("assumed", "nothing follows from 0 = 0", "assumptions 1 p", "0"),
    ("assumed", "p is a number", "tree p", "1"),
    ("assumed", "no such condition", "tree condition", "2"),
    ("assumed", "the condition says something else", "tree condition", "0"),
    ("membership_empty", "terms beside a membership", "tree zero terms", [["1"]]),
    ("membership_empty", "no value", "tree zero value"),
    ("membership_empty", "no membership", "tree zero membership"),
    ("membership_empty", "membership -1", "tree zero membership", "-1"),
    ("membership_empty", "membership 1", "tree zero membership", "1"),
    ("membership_empty", "an integral value", "tree zero value", "1"),
    ("membership_empty", "another value", "tree zero value", "1/3"),
    ("membership_empty", "b is in Z", "memberships 0", {"num": "b", "den": "1", "integral": True}),
    ("outside_group", "group -1", "tree zero then zero then generic", "-1"),
    ("outside_group", "group 1", "tree zero then zero then generic", "1"),
    ("outside_group", "b is not 0 in the group", "generic 0", ["a", "b + 1"]),
    ("number", "another parameter in r", ("parameters", ["a", "b"]), ("r num", "b*z")),
    ("number", "the claim inside says nothing", "tree certificate claim abelian", None),
    ("number", "neither yes nor no", "tree abelian", "maybe"),
    ("number", "a certificate shows no emptiness", "tree abelian", "empty"),
    ("number", "the equation is another one by a sign", "r num", "-z"),
    ("number", "a certificate over another field", ("tree certificate field", {"name": "a", "minpoly": ["-2", "0", "1"]}),
     ("tree certificate steps 0 data prime", {"p": "1009", "a": "439"})),
    ("root", "another parameter in r", ("parameters", ["a", "b"]), ("r num", "a*b*z")),
    ("root", "a p of another variable", ("parameters", ["a", "b"]), ("tree zero variable", "b")),
    ("root", "no such variable", "tree zero variable", "z"),
    ("root", "the polynomial of another root", "tree p", "2*a^2 - 3"),
    ("root", "a p of degree 3", "tree p", "2*a^3 - a"),
    ("lemmas", "a negative term", "tree", lemma("-a", "positive", {"node": "empty"}, terms=[["-1", ["condition", "0", "1"]]])),
    ("lemmas", "a term 0", "tree", lemma("0", "positive", {"node": "empty"}, terms=[["0"]])),
    ("lemmas", "no terms", "tree", lemma("0", "nonzero", {"node": "empty"}, terms=[])),
    ("lemmas", "the power 0", "tree", lemma("1", "positive", terms=[["1", ["condition", "0", "0"]]])),
    ("lemmas", "no power", "tree lemmas 0 terms 0 1", ["condition", "0"]),
    ("lemmas", "no term", "tree lemmas 0 terms 0", []),
    ("lemmas", "neither a condition nor a square", "tree lemmas 2 terms 0 1 0", "cube"),
    ("lemmas", "condition -1", "tree lemmas 0 terms 0 1 1", "-2"),
    ("lemmas", "condition 2", "tree lemmas 0 terms 0 1 1", "2"),
    ("lemmas", "not the square of something real", "real", ["a"]),
    ("lemmas", "another denominator", "tree", lemma("a", "positive", terms=[["1/2", ["condition", "0", "1"]], ["1/5", ["condition", "0", "1"]]])),
    ("lemmas", "nonnegative is not shown", "tree lemmas 0 sign", "nonnegative"),
    ("lemmas", "nothing shows it", "tree", lemma("a - b", "nonzero")),
    ("lemmas", "a factor alone shows no sign", "tree", lemma("a", "positive", times="b")),
    ("lemmas", "the square of a nonzero number may be that of another", "tree", lemma("a - b", "nonzero", terms=[["1", ["square", "a - b", "1"]]])),
    ("membership", "a membership shows no sign", "tree lemmas 0 sign", "positive"),
    ("membership", "a membership about a number", "tree lemmas 0 p", "5"),
    ("membership", "a membership about 0", ("tree lemmas 0 p", "0"), ("tree then", {"node": "empty"})),
    ("solve_signs", "no such variable", "tree zero variable", "d"),
    ("solve_signs", "the coefficient may vanish", "assumptions 0 sign", "zero"),
    ("moebius", "another coefficient may vanish", "tree p", "b - 2"),
    ("outside_node", "r is given where den is 0", "tree zero then zero r", {"num": "0", "den": "0"}),
    ("empty_zero", "a value without a membership", "tree zero then value", "1"),
    ("empty_zero", "r is missing", "tree zero r"),
    ("empty_zero", "another r", "tree nonzero zero r num", "2*a*z"),
    ("empty_zero", "the denominator vanishes for b = 0", "tree nonzero zero r", {"num": "b*z", "den": "b"}),
]


TRUE = [
    ("positive", "all of -chi is positive", "tree infinity chi", ["4*a - 1", "-1"]),
    ("bound_complex", "c > 0 is real", ("real", ["a"]), ("assumptions 0", {"p": "c", "sign": "positive"})),
    ("bound_complex", "-c > 0 is real", ("real", ["a"]), ("assumptions 0", {"p": "-c", "sign": "positive"})),
    ("invariant", "nothing is claimed", "claim abelian", None),
]


def strata():
    for right, rows in ((False, FALSE), (True, TRUE)):
        for of, why, *changes in rows:
            top = json.loads(read("data/strata", of + ".json"))
            for path, *value in changes if isinstance(changes[0], tuple) else [changes]:
                top = changed(top, path.split(), *value)
            yield f"{of}: {why}", top, right
    yield "r = 0", certificate([], "0", LEAF), False
    root = {"zero": "root", "variable": "a", "certificate": AIRY, "abelian": "no"}
    yield "a root of degree 1", certificate(["a"], "a*z + z", {"node": "split", "p": "a", "nonzero": {"node": "open", "reason": ""}, "zero": root},
                                            None), False
    yield "the content may vanish", certificate(["a"], "z", LEAF | {"content": "a"}, den="a"), False
    yield "a constant place", certificate([], "z", LEAF | {"places": [{"q": "2", "order": "1"}]}, den="2"), False
    for m, right in (("200", True), ("201", False), ("0", False)):
        leaf = {"node": "leaf", "abelian": "yes", "by": "invariant", "content": "1", "places": [], "m": m, "p": "1"}
        yield f"degree {m}", certificate([], "0", leaf, True), right
    yield "no root modulo 2", certificate(["n"], "z*n^2 + z*n + z", lemma("n^2 + n + 1", "nonzero", prime="2"), rational=["n"]), True
    trusted = changed(AIRY, ["steps", "+"], {"id": "t", "rule": "apply-theorem", "premises": ["conclusion"],
                                             "data": {"theorem": "a book", "statement": "so it is"}})
    yield "a trusted step inside", changed(json.loads(read("data/strata/number.json")), ["tree", "certificate"], trusted), True
    thirds = [[c, ["condition", "0", "1"]] for c in ("1/2", "1/3", "1/6")]
    yield "thirds", certificate(["a"], "a*z", lemma("a", "positive", terms=thirds), real=["a"], assumptions=positive("a")), True
    twelve = [f"a{i}" for i in range(12)]
    yield "12 parameters", certificate(twelve, "a11^2*z + z", lemma("a11^2 + 1", "nonzero", terms=[["1"], ["1", ["square", "a11", "1"]]]),
                                       real=twelve), True
    for p, terms, right in (("a^2 + a", [["1", ["condition", "0", "2"]], ["1", ["condition", "0", "1"]]], True),
                            ("a^2 - a", [["1", ["condition", "0", "2"]], ["1", ["condition", "0", "1"]]], False)):
        yield p, certificate(["a"], "a*z", lemma(p, "positive", terms=terms), real=["a"], assumptions=positive("a")), right


def over_a_root(p, m, num, den, inner, image):
    """r for the roots a of p is inner(2 a): the field of 2 a has the polynomial m; image: of its generator modulo 1009"""
    airy = changed(AIRY | {"field": {"name": "t", "minpoly": m}, "r": {"num": inner, "den": ["1"]}}, ["steps", 0, "data", "prime"],
                   {"p": "1009", "a": str(image)})
    root = {"zero": "root", "variable": "a", "certificate": airy, "abelian": "no"}
    return certificate(["a"], num, {"node": "split", "p": p, "nonzero": {"node": "open", "reason": ""}, "zero": root}, None, den)


def roots():
    p, m = "2*a^2 + 2*a - 1", ["-2", "2", "1"]
    image = next(x for x in range(1009) if (x * x + 2 * x - 2) % 1009 == 0)
    for num, den, inner, right in (
            ("a*z", "1", ["0", ["0", "1/2"]], True), ("a^2*z", "1", ["0", ["1/2", "-1/2"]], True), ("z", "a", ["0", ["2", "1"]], True),
            ("a^2*z + a*z", "1", ["0", "1/2"], True), ("a^3*z", "a", ["0", ["1/2", "-1/2"]], True), ("a*z", "1", ["0", ["0", "1"]], False),
            ("a^2*z", "1", ["0", ["1/2", "1/2"]], False), ("z", "a", ["0", ["-2", "1"]], False)):
        yield f"r = ({num})/({den}), {inner}", over_a_root(p, m, num, den, inner, image), right
    yield "the polynomial of a, not of 2 a", over_a_root(p, ["-1", "2", "2"], "a*z", "1", ["0", ["0", "1"]], image), False
    yield "another polynomial", over_a_root(p, ["-2", "4", "1"], "a*z", "1", ["0", ["0", "1/2"]], image), False


def certificates():
    for family in (strata, roots):
        for why, top, right in family():
            yield f"{family.__name__}: {why}", json.dumps(top), right
