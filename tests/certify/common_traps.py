"""Traps of the rule for common values of exponent differences (theorem_certificates.md 17): what a plausible mistake would accept."""
import copy
import json
import re
from fractions import Fraction as F
from itertools import product
from types import SimpleNamespace

from lowest import refused
from traps import changed, names, read

# Schwarz's list, as Kimura has it; up to signs, permutations and integers with an even sum
TABLE = [(F(*a), F(*b), F(*c)) for a, b, c in (
    ((1, 2), (1, 3), (1, 3)), ((2, 3), (1, 3), (1, 3)), ((1, 2), (1, 3), (1, 4)), ((2, 3), (1, 4), (1, 4)), ((1, 2), (1, 3), (1, 5)),
    ((2, 5), (1, 3), (1, 3)), ((2, 3), (1, 5), (1, 5)), ((1, 2), (2, 5), (1, 5)), ((3, 5), (1, 3), (1, 5)), ((2, 5), (2, 5), (2, 5)),
    ((2, 3), (1, 3), (1, 5)), ((4, 5), (1, 5), (1, 5)), ((1, 2), (2, 5), (1, 3)), ((3, 5), (2, 5), (1, 3)))]


def steps(top, rule):
    return [k for k, step in enumerate(top["steps"]) if step["rule"] == rule]


def cheated(top):
    for k in steps(top, "common-values"):
        step, at = top["steps"][k], ["steps", k]
        num, den = step["function"]["num"], step["function"]["den"]
        for what, key, value in (("another function", "num", num + " + 1"), ("another function", "den", den + " + x"),
                                 ("0 below", "den", "0"), ("a power more", "num", f"{num} + x^21")):
            yield f"{k}: {what} {key}", changed(top, [*at, "function", key], value)
        for value in ("0", "1", str(int(step["bound"]) // 8), "20001", "-1", f"-{step['bound']}"):
            if value != step["bound"]:
                yield f"{k}: bound {value}", changed(top, [*at, "bound"], value)
        gap = step["gap"]
        for value in ("negative", "0", "7") if gap == "negative" else ("negative", str(int(gap) + 1), "0" if gap != "0" else "2"):
            if value != gap:
                yield f"{k}: gap {value}", changed(top, [*at, "gap"], value)
        yield f"{k}: no such leaf", changed(top, [*at, "leaves", 0], "9")
        yield f"{k}: one curve twice", changed(top, [*at, "of", 1], step["of"][0])
        yield f"{k}: shown of the other", changed(top, [*at, "shown"], step["shown"][::-1])
        yield f"{k}: nothing shown", changed(top, [*at, "shown", 1], [])
        yield f"{k}: one leaf", changed(top, [*at, "leaves"], step["leaves"][:1])
        yield f"{k}: a value below", changed(top, [*at, "by"], {"node": "empty", "terms": [["1", "1"]], "zeros": []})
        for i in range(len(step["region"])):
            yield f"{k}: without condition {i}", changed(top, [*at, "region", i])
    for k in steps(top, "cover"):
        yield "a common value forgotten", changed(top, ["steps", k, "tree"], without_last_split(top["steps"][k]["tree"]))


def without_last_split(node):
    inner = node["nonzero"]
    return inner if inner["node"] == "part" else node | {"nonzero": without_last_split(inner)}


# ---- one premise changed, and all else as true as it was

def without_loops(top):
    """c = 4 is left open: without the step that takes long to check"""
    top = copy.deepcopy(top)
    del top["steps"][2:4]
    cover, zero = top["steps"][-1], "zero"
    top["steps"][-2]["regions"].append([{"p": "c - 4", "sign": zero}])
    cover["parts"].remove("excluded-2")
    at_0, at_2 = cover["tree"]["nonzero"][zero], cover["tree"]["nonzero"]["nonzero"]
    at_4, elsewhere = at_2["nonzero"][zero], at_2["nonzero"]["nonzero"]
    at_0["part"], elsewhere["part"] = "3", "2"
    at_4 |= {"part": "3", "region": "1"}
    return top


def renamed(step, new):
    """With another name for c: as true as before"""
    return json.loads(re.sub(r"(?<![A-Za-z0-9_])c(?![A-Za-z0-9_])", new, json.dumps(step)))


def forged(top):
    def with_other(*what):
        """The step of the rule, and those of the certificates with another name for c"""
        other = copy.deepcopy(top)
        at = {step["id"]: i for i, step in enumerate(other["steps"])}
        for name, new in what:
            other["steps"][at[name]] = renamed(other["steps"][at[name]], new)
        return other, other["steps"][at["excluded-3"]]

    for name in ("one", "two"):
        yield f"the system has no parameter of {name}", with_other((name, "d"))[0]
        text = json.dumps(next(step for step in top["steps"] if step["id"] == name))
        exchanged = re.sub("M[12]", lambda m: {"M1": "M2", "M2": "M1"}[m[0]], text)
        yield f"exchanged coordinates in {name}", json.loads(json.dumps(top).replace(text, exchanged))
    for value in ("c + 1", "2", "c"): # another system; the same one, with a difference that depends on a level
        other, step = with_other(("two", "h"))
        step["levels"] = [[], [["h", value]]]
        yield f"a level with the value {value}", other
        step["levels"] = step["levels"][::-1]
        yield f"the other has the level with the value {value}", other
    other, step = with_other(("one", "h"), ("two", "h"))
    step["levels"] = [[["h", "c"]], [["h", "c + 1"]]]
    yield "a level with two values", other
    other, step = with_other()
    step["levels"] = [[["c", "3"]], []]
    yield "a parameter as a level", other
    for key, value in (("at", [["c", "3"]]), ("leaves", ["0", "1"]), ("leaves", ["-1", "0"]), ("of", ["one", "rest"]), ("of", ["excluded-3", "two"]),
                       ("of", ["integrable-1", "two"])):
        other, step = with_other()
        step[key] = value
        yield f"{key} {value}", other
    other, step = with_other()
    step["function"] = {"num": step["function"]["den"], "den": step["function"]["num"]}
    yield "the inverse of the function", other
    for p, sign in (("c", "positive"), ("c", "zero"), ("c - 7", "zero")):
        other, step = with_other()
        step["region"][1] = {"p": p, "sign": sign}
        yield f"a region with {p} {sign}", other
    other, step = with_other()
    step["shown"][0][0], step["shown"][0][1] = step["shown"][0][1], step["shown"][0][0]
    yield "two conditions shown by one another", other
    other, step = with_other()
    other["systems"][0]["system"]["hamiltonian"][0] += " + 2*G1"
    yield "another Hamiltonian", other
    other, step = with_other()
    other["steps"].insert(2, other["steps"].pop(other["steps"].index(step)))
    yield "before its certificates", other
    other, _ = with_other()
    other["steps"].insert(3, other["steps"][2] | {"id": "two"})
    yield "two certificates of one name", other
    for here, there in ((0, 1), (1, 0)):
        other, _ = with_other()
        at_2 = other["steps"][-1]["tree"]["nonzero"]["nonzero"]
        leaves = at_2["zero"], at_2["nonzero"]["nonzero"]
        leaves[here].update(leaves[there])
        yield f"a common value in part {leaves[here]['part']}", other


def certificates():
    for name in names("common_data"):
        top = json.loads(read("common_data", name))
        yield f"common {name}", json.dumps(top), True
        light = without_loops(top)
        yield f"common light {name}", json.dumps(light), True
        for what, false in forged(light):
            yield f"common light {name} {what}", json.dumps(false), False
        for what, false in cheated(light):
            if false != light: # some steps speak of one curve twice
                yield f"common light {name} {what}", json.dumps(false), False


# ---- what is special

def in_table(*three):
    for row in TABLE:
        for a, b, c in ((row[i], row[j], row[k]) for i, j, k in product(range(3), repeat=3) if len({i, j, k}) == 3):
            for signs in product((1, -1), repeat=3):
                rest = [x - s * y for x, s, y in zip(three, signs, (a, b, c))]
                if all(x.denominator == 1 for x in rest) and sum(rest) % 2 == 0:
                    return True
    return False


def abelian(*three):
    odd = any((three[0] + s * three[1] + t * three[2]) % 2 == 1 for s, t in product((1, -1), repeat=2))
    return odd or sum(x.denominator == 2 for x in three) >= 2 or in_table(*three)


def what_is_special(modules):
    """All that may be abelian is special, and N Delta is an integer there."""
    m = modules["rule_common_values"]
    assert m.ROWS == {tuple(sorted(x.denominator for x in row)) for row in TABLE}
    values = sorted({F(a, d) for d in (1, 2, 3, 4, 5, 6, 7) for a in range(2 * d + 1)})
    for known, times in [((F(1, 3), F(1, 3)), 1), ((F(3, 4), F(3, 4)), 1), ((F(1, 2), F(2, 5)), 1), ((F(1, 3),), 2), ((F(2, 7),), 2),
                         ((F(1, 2),), 2), ((F(2),), 2), ((F(1), F(2, 3)), 1), ((), 3)]:
        d = m.Difference(list(known), times, None, None)
        for x in values:
            if abelian(*known, *[x] * times):
                assert d.special(x) and (d.N * x).denominator == 1, (known, x)
        for x in (F(1, 11), F(3, 13), F(5, 22)):
            assert not d.special(x) or abelian(*known, *[x] * times), (known, x)
    d = m.Difference([F(1, 3), F(1, 3)], 1, None, None)
    assert [x for x in values if d.special(x) and x < 1] == [F(1, 5), F(1, 3), F(2, 5), F(1, 2), F(3, 5), F(2, 3), F(4, 5)]
    assert m.Difference([F(1, 7), F(3, 8)], 1, None, None).N == 1680
    return True


def nothing_follows(modules):
    m, refused = modules["rule_common_values"], modules["certificate_format"].Rejected
    for known, times in [((F(1, 2), F(3, 2)), 1), ((F(3),), 2), ((F(1),), 2)]:
        try:
            m.Difference(list(known), times, None, None)
        except refused:
            continue
        raise AssertionError(known)
    return True


def positive(modules):
    modules["multivariate"].Work.left = 10**7

    def f(row, start):
        return modules["rule_common_values"].positive_from(modules["multivariate"].P.of(dict(enumerate(row))), F(start))
    assert f([1], 0) and f([0, 1], 1) and f([-4, 0, 1], 3) and f([1, 0, 6], 0) and f([1, -1, 1], F(5, 2)) and not f([1, -6, 4], F(3, 4))
    assert not any((f([], 0), f([0, 1], 0), f([-1, 1], 1), f([-4, 0, 1], 2), f([5, -4, 1], 1), f([-1], 5), f([3, 0, -1], 1)))
    return True


def found(modules, first, second, function, bound, gap, by=None):
    """The conditions, or why they are refused; first, second: the known differences, how many others, and texts of their square"""
    m, parse = modules["rule_common_values"], modules["multivariate"].parse
    names, modules["multivariate"].Work.left = {"a": modules["multivariate"].FIELD}, 10**7
    try:
        two = [m.Difference(list(known), times, *(parse(text, names) for text in square)) for known, times, square in (first, second)]
        step = {"function": dict(zip(("num", "den"), function)), "bound": bound, "gap": gap, "by": by}
        modules["condition"].ConditionSet.nodes = 1000
        given = modules["condition"].ConditionSet(names).also((parse("a - 2", names), "zero"))
        return sorted(str(sorted(f.items())) for f, says in m.CommonValues(*two, step, given).conditions())
    except modules["certificate_format"].Rejected as no:
        return str(no)
    except modules["certificate_format"].Malformed as no:
        return f"malformed: {no}"


def conditions(modules, *texts):
    m = modules["multivariate"]
    return sorted(str(sorted(m.parse(text, {"a": m.FIELD}).items())) for text in texts)


def bounds(modules):
    """At each bound the last one that is refused beside the first that is not"""
    third, far, other = (F(1, 3), F(1, 3)), "the bound is not shown", "another function of the difference"
    two = ((third, 1, ("a + 24", "9*a")), (third, 1, ("a - 24", "9*a")))
    assert found(modules, *two, ("2 - 9*x", "9"), 29, "negative") == [] != found(modules, *two, ("2 - 9*x", "9"), 28, "negative") == far
    assert found(modules, *two, ("-2 + 9*x", "-9"), 29, "negative") == []
    assert found(modules, *two, ("3 - 9*x", "9"), 99, "negative") == found(modules, *two, ("2 - 9*x", "8"), 99, "negative") == other
    for gap in ("0", "20"):
        assert found(modules, *two, ("2 - 9*x", "9"), 40, gap) == far
    for gap in ("x", "", "1.5"):
        assert found(modules, *two, ("2 - 9*x", "9"), 40, gap).startswith("malformed")
    assert found(modules, *two, ("2 - 9*x", "9"), 40, "-1") == "the gap is below 0"
    for bound in (-1, -29, -40):
        assert found(modules, *two, ("2 - 9*x", "9"), bound, "negative") == "a limit: the number of values"
    assert found(modules, *two, ("2 - 9*x", "0"), 40, "0") == "the function has no denominator"
    assert found(modules, *two, ("2 - 9*x", "9"), 20000, "negative") == []
    limit = "a limit: the function"
    assert found(modules, *two, ("2 - 9*x", "9"), 20001, "negative") == "a limit: the number of values"
    assert found(modules, *two, ("2 - 9*x^21", "9"), 40, "negative") == limit != found(modules, *two, ("2 - 9*x^20", "9"), 40, "negative") == other
    assert found(modules, *two, (f"2 - {2**1000}*x", "9"), 40, "negative") == limit != found(modules, *two, (f"2 - {2**999}*x", "9"), 40, "negative")
    return True


def values(modules):
    """Which values are common"""
    one, other = ((F(1, 3),), 2, ("4", "9*a")), ((F(1, 3),), 2, ("4*a", "9"))
    assert found(modules, one, other, ("16", "81*x"), 1601, "0") == conditions(modules, "4 - a", "1 - a", "1 - 4*a")
    assert found(modules, one, other, ("16", "81*x"), 1600, "0") == "the bound is not shown"
    third = (F(1, 3), F(1, 3))
    same = (third, 1, ("a", "1"))
    # F = 1/(9 x - 1) is not defined at 1/9, where the first may be special
    assert found(modules, same, (third, 1, ("1", "9*a - 1")), ("1", "9*x - 1"), 1201, "0") == conditions(modules, "9*a - 1")
    # a constant, where a = 2
    node = {"node": "empty", "terms": [["1", "1", ["1", "1"]]], "zeros": [["0", "-1"]]}
    assert found(modules, same, same, ("2", "1"), 0, "84", node) == [] != found(modules, same, same, ("3", "1"), 0, "103", node)
    assert all(found(modules, same, same, ("2", "1"), 0, gap, node) == "the bound is not shown" for gap in ("83", "85"))
    # a difference that is one of the common values: there is no point
    number = ((F(1, 3),), 2, ("4", "9"))
    assert found(modules, number, number, ("16", "81*x"), 1601, "0") == conditions(modules, "0")
    return True


def common_names(modules):
    """A name of both: a parameter of X that is an inverse or a level of Y is another one"""
    m, field = modules["rule_common_values"], modules["multivariate"].FIELD
    y = SimpleNamespace(space=SimpleNamespace(at={"a": 3 * field, "u": 4 * field, "h": 5 * field}), parameters=["a", "h"])
    x = SimpleNamespace(free={"a": 7 * field, "u": 8 * field})

    def of(text):
        found = []
        return None if refused(modules, lambda: found.append(m.in_parameters(text, y, x))) else found[0]
    return of("3*a^2 - 1") == modules["multivariate"].parse("3*a^2 - 1", x.free) and not any(map(of, ("u", "a*u", "h", "b")))


def properties():
    """(name, function, True)"""
    return [(f"common_traps.{f.__name__}", f, True) for f in (what_is_special, nothing_follows, positive, bounds, values, common_names)]
