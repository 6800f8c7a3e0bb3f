"""Traps of the rule for Darboux points (theorem_certificates.md 16): bundles, and what a plausible mistake would accept."""
import json
from fractions import Fraction as F
from random import Random

from traps import changed, names, read

STEP = {"degree": "4", "says": "multiple", "part": "first", "unit": "2", "chart": ["1", "1"], "choices": [], "shown": [], "zeros": ["1"],
        "coordinates": ["y", "x"], "momenta": ["v", "u"]}


def cheated(top):
    for k, step in enumerate(top["steps"]):
        if step["rule"] != "darboux":
            continue
        for key, value in STEP.items():
            if step[key] != value:
                yield f"{k}: {key}", changed(top, ["steps", k, key], value)
        yield f"{k}: says nothing", changed(top, ["steps", k, "says"], "nothing")
        yield f"{k}: proper", changed(top, ["steps", k, "proper"], step["proper"] + " + 1")
        yield f"{k}: rest", changed(top, ["steps", k, "rest"], step["rest"] + " + x")
        for i, row in enumerate(step["shown"]):
            yield f"{k}: value {i}", changed(top, ["steps", k, "shown", i, "value"], row["value"] + " + 7")
        for i, choice in enumerate(step["choices"]):
            yield f"{k}: values {i}", changed(top, ["steps", k, "choices", i, "values", 0], "17")
            yield f"{k}: equations {i}", changed(top, ["steps", k, "choices", i, "equations", 0], "1")
        if step["says"] == "relation" and step["isotropic"]["order"] == "0":
            yield f"{k}: order", changed(top, ["steps", k, "isotropic", "order"], "1")
            yield f"{k}: scale", changed(top, ["steps", k, "isotropic", "scale"], "2")
        yield from in_lines(top, k, step["isotropic"])
    for more in ("u^3", "x*u^2", "x^2*u", "x^9", "x*y*u*v"):
        h = top["systems"][0]["system"]["hamiltonian"]
        text = h[0] if isinstance(h, list) else h
        value = [f"{text} + {more}", h[1]] if isinstance(h, list) else f"{text} + {more}"
        yield f"H + {more}", changed(top, ["systems", 0, "system", "hamiltonian"], value)


def in_lines(top, k, isotropic):
    """The order of the potential along two lines, of which the product is c up to a factor"""
    at = ["steps", k, "isotropic"]
    if "lines" not in isotropic:
        if top["steps"][k]["says"] == "multiple":
            yield f"{k}: lines of nothing", changed(top, [*at, "lines"], {"factors": ["x", "x"], "over": "1", "order": "0"})
        return
    lines = isotropic["lines"]
    first, second = lines["factors"]
    for what, value in (("the same line twice", [first, first]), ("another order", [second, first]), ("one line", [first]),
                        ("three lines", [first, second, "1"]), ("no line", [first, "1"]), ("another line", [first, second + " + 1"])):
        yield f"{k}: {what}", changed(top, [*at, "lines", "factors"], value)
    for what, value in (("order", "1"), ("order", "-1"), ("order", "17"), ("over", lines["over"] + " + 1"), ("over", "0"), ("over", "x")):
        yield f"{k}: {what} {value}", changed(top, [*at, "lines", what], value)
    for value in ("0", "2", "-1"):
        yield f"{k}: the first order {value}", changed(top, [*at, "order"], value)
    yield f"{k}: both directions alike", changed(top, [*at, "lines"])
    yield f"{k}: a key more", changed(top, [*at, "lines", "rest"], "1")


def certificates():
    for name in names("darboux_data"):
        top = json.loads(read("darboux_data", name))
        yield f"darboux {name}", json.dumps(top), True
        for what, false in cheated(top):
            yield f"darboux {name} {what}", json.dumps(false), False


# ---- the table of Morales-Ruiz and Ramis, in its published form: lambda = r + s (t + q p)^2 for integers p

PUBLISHED = {3: ((F(-1, 24), F(1, 6), 1, 3), (F(-1, 24), F(3, 32), 1, 4), (F(-1, 24), F(3, 50), 1, 5), (F(-1, 24), F(3, 50), 2, 5)),
             4: ((F(-1, 8), F(2, 9), 1, 3),),
             5: ((F(-9, 40), F(5, 18), 1, 3), (F(-9, 40), F(1, 10), 2, 5)),
             6: (), 7: ()}


def published(k):
    for p in range(-8, 9):
        yield p + F(k, 2) * p * (p - 1)
        yield (F(k - 1, k) + p * (p + 1) * k) / 2
        for r, s, t, q in PUBLISHED[k]:
            yield r + s * (t + q * p) ** 2


def table_of_numbers(modules):
    modules["multivariate"].Work.left, Table = 10**9, modules["rule_darboux"].Table
    for k in PUBLISHED:
        known, table = set(published(k)), Table(k)
        for value in known:
            assert table.contains(value - 1), (k, value)
        for d in (1, 2, 3, 5, 7, 8, 24, 40, 96, 200, 600):
            for a in range(-4 * d, 4 * d + 1):
                assert table.contains(F(a, d) - 1) == (F(a, d) in known), (k, F(a, d))
        assert set(table.negative) == {value - 1 for value in known if value < 1}, k
        for most in (F(0), F(1, 2), F(7), F(40)):
            assert table.up_to(most) == sorted({value - 1 for value in known if value - 1 <= most and value != 1}), (k, most)
    return True


def sets_of_numbers(modules):
    """Each set that is found has its sum and members of the table, ascending; sets of members are found"""
    modules["multivariate"].Work.left, Table = 10**9, modules["rule_darboux"].Table
    for k in PUBLISHED:
        table = Table(k)
        members = sorted({v - 1 for v in published(k) if v != 1})
        some, small = [v for v in members if v <= 11], members[:5]
        random = Random(k)
        for n in (1, 1, 2, 2, 2, 3, 3, 3, 4):
            values = sorted(random.choices(some if n < 4 else small, k=n))
            total = sum(1 / v for v in values)
            found = table.sets(n, total)
            assert tuple(values) in found == sorted(set(found)), (k, values)
            assert all(len(x) == n and list(x) == sorted(x) and sum(1 / v for v in x) == total and all(map(table.contains, x))
                       for x in found), (k, found)
        assert not table.sets(1, F(0)) and table.sets(0, F(0)) == [()] and not table.sets(2, F(-100)), k
    return True


def properties():
    """(name, function, True)"""
    return [(f"darboux_traps.{f.__name__}", f, True) for f in (table_of_numbers, sets_of_numbers)]
