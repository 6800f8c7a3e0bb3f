"""Small certificates of matrices of loops (kovacic-loops/1), each rule of loop_certificates.md broken alone beside what is right at the
same bound.  Around 0 and 1 the system y1' = y2/z, y2' = y3/(z - 1), y3' = 0 has unipotent matrices that do not commute; what
stands beside it decides which powers are allowed."""
import json
from fractions import Fraction as F
from math import lcm

from traps import changed, read



def walk(*corners, step=F(1, 4)):
    """Through these points, parallel to the axes; a series needs short steps."""
    path = [tuple(map(F, corners[0]))]
    for corner in corners[1:]:
        (x, y), (u, v) = path[-1], map(F, corner)
        n = max(1, int(max(abs(u - x), abs(v - y)) / step))
        path += [(x + (u - x) * k / n, y + (v - y) * k / n) for k in range(1, n + 1)]
    return [[str(x), str(y)] for x, y in path]


BASE = ["1/2", "-1/2"]
AROUND_0 = walk(BASE, ("1/2", "1/2"), ("-1/2", "1/2"), ("-1/2", "-1/2"), BASE)
AROUND_1 = walk(BASE, ("3/2", "-1/2"), ("3/2", "1/2"), ("1/2", "1/2"), BASE)
RATIONALS, GAUSS = {"name": "", "minpoly": ["0", "1"]}, {"name": "i", "minpoly": ["1", "0", "1"]}


# ---- polynomials and fractions over Q, ascending

def texts(f):
    return [str(x) for x in plus(f, [])]


def times(f, g):
    out = [F(0)] * max(0, len(f) + len(g) - 1)
    for i, x in enumerate(f):
        for j, y in enumerate(g):
            out[i + j] += x * y
    return out


def plus(f, g, c=1):
    n = max(len(f), len(g))
    out = [x + c * y for x, y in zip(f + [F(0)] * (n - len(f)), g + [F(0)] * (n - len(g)))]
    while out and not out[-1]:
        out.pop()
    return out


def row(den, *num):
    return {"den": texts(den), "num": [texts(f) for f in num]}


# ---- systems

def system(*more):
    """The three unknowns above and those of `more`: rows with the entries of their own unknowns only"""
    n, at, rows = 3 + len(more), 3, []
    rows += [row([F(0), F(1)], [], [F(1)], *[[]] * (n - 2)), row([F(-1), F(1)], [], [], [F(1)], *[[]] * (n - 3)), row([F(1)], *[[]] * n)]
    while at < n:
        size = len(more[at - 3][1])
        rows += [row(den, *[[]] * at, *num, *[[]] * (n - at - size)) for den, num in more[at - 3:at - 3 + size]]
        at += size
    return rows


def block(*unknowns, factors=(), certificate=None):
    x = {"unknowns": list(map(str, unknowns)), "factors": [{"q": texts(q), "e": str(e)} for q, e in factors]}
    return x if certificate is None else x | {"certificate": certificate}


BLOCKS = [block(2), block(1), block(0)]


def certificate(rows, blocks, power=1, **more):
    """The entry 0, 2 of A B - B A, for these powers of the loops"""
    element = [{"word": [i], "power": str(power)} for i in "01"]
    return {"format": "kovacic-loops/1", "title": "", "field": RATIONALS, "system": rows, "bits": "64", "loops": [AROUND_0, AROUND_1],
            "shows": {"by": "not-abelian", "A": element[0], "B": element[1], "row": "0", "column": "2", "blocks": blocks}} | more


def radicals():
    """One unknown more, z^a (z - 1)^b"""
    for a, b in ((F(1, 3), F(0)), (F(1, 4), F(1, 6)), (F(-5, 2), F(0)), (F(2), F(-3))):
        given = [x for x in (([F(0), F(1)], a), ([F(-1), F(1)], b)) if x[1]]
        num = plus(times([a], [F(-1), F(1)]), times([b], [F(0), F(1)]))
        rows, n = system(([F(0), F(-1), F(1)], [num])), lcm(a.denominator, b.denominator)

        def of(power, given=given, **more):
            return certificate(rows, [*BLOCKS, block(3, factors=given)], power, **more)
        yield f"z^{a} (z - 1)^{b}", of(n), True
        yield f"z^{a} (z - 1)^{b}: twice", of(2 * n), True
        for power in {1, n - 1, n + 1, n // 2} - {0} if n > 1 else ():
            yield f"z^{a} (z - 1)^{b}: power {power}", of(power), False
        yield f"z^{a} (z - 1)^{b}: power 0", of(0), False
        yield f"z^{a} (z - 1)^{b}: -{n}", of(-n), False
        wrong = {"another sign": [(q, -e) for q, e in given], "one more": [*given, ([F(3), F(1)], F(1))], "none": [],
                 "a constant": [*given, ([F(5)], F(1, 7))], "a factor 0": [*given, ([], F(1))], "twice": given * 2}
        for why, factors in wrong.items():
            yield f"z^{a} (z - 1)^{b}: {why}", of(n * 7, given=factors), False
    rows = system(([F(0), F(1)], [[F(1, 1000)]]))
    yield "order 1000", certificate(rows, [*BLOCKS, block(3, factors=[([F(0), F(1)], F(1, 1000))])], 1000), True
    rows = system(([F(0), F(1)], [[F(1, 1001)]]))
    yield "order 1001", certificate(rows, [*BLOCKS, block(3, factors=[([F(0), F(1)], F(1, 1001))])], 1001), False
    two = system(([F(0), F(1)], [[F(1, 4)]]), ([F(-1), F(1)], [[F(1, 6)]]))
    for power, right in ((12, True), (4, False), (6, False)):
        blocks = [*BLOCKS, block(3, factors=[([F(0), F(1)], F(1, 4))]), block(4, factors=[([F(-1), F(1)], F(1, 6))])]
        yield f"orders 4 and 6: power {power}", certificate(two, blocks, power), right


def of_second_order(name, a=F(0), d=F(0), k=0):
    """Rows (a/z, z^k; c, d/z) of u, v such that the normal form of u'' + ... is that of a certificate; factors"""
    inner = json.loads(read("data", name + ".json"))
    num, den = ([F(x) for x in inner["r"][key]] for key in ("num", "den"))
    # e = (k + d)/z, p = -(a + e)/z, q = p^2/4 + p'/2 - r, z^k c = a e - a' - q, in units of 1/z^2
    e = k + d
    p = -(a + e)
    constant = a * e + a - (p * p / 4 - p / 2)
    top = plus(times([constant], den), times([F(0), F(0), F(1)], num))                      # z^k c = top/(z^2 den)
    rows = [([F(0), F(1)], [[a], [F(0)] * (k + 1) + [F(1)]]), (times([F(0)] * (k + 2) + [F(1)], den), [top, times(
        times([d], [F(0)] * (k + 1) + [F(1)]), den)])]
    return rows, [([F(0), F(1)], -p / 2)] if p else [], inner


def equations():
    """Two unknowns more, with the finite groups and T"""
    orders = {"hyp-000-naive": 12, "hyp-006-naive": 60, "mec-cubic-8-naive": 24, "mec-cubic-1-naive": 12, "giac-2": 4,
              "mec-quartic-1-naive": 8, "giac-5-naive": 2}
    for name, n in orders.items():
        rows, factors, inner = of_second_order(name)
        for power in sorted({n, *(n // p for p in (2, 3, 5) if n % p == 0)}):
            blocks = [*BLOCKS, block(3, 4, factors=factors, certificate=inner)]
            yield f"{name}: power {power}", certificate(system(*rows), blocks, power), power == n
    for a, d, k in ((F(1, 3), F(1, 2), 0), (F(-1, 2), F(1), 1), (F(2), F(1, 5), 0)):
        rows, factors, inner = of_second_order("giac-2", a, d, k)
        n, what = lcm(4, (a + k + d).denominator * (2 if (a + k + d).numerator % 2 else 1)), f"a = {a}, d = {d}, b = z^{k}"

        def of(change=None, power=n, rows=rows, given=(3, 4), factors=factors, inner=inner):
            made = [*BLOCKS, block(*given, factors=factors, certificate=inner)]
            return certificate(system(*(change(rows) if change else rows)), made, power)
        yield what, of(), True
        yield f"{what}: half the power", of(power=n // 2), False
        yield f"{what}: the power 4", of(power=4), n == 4
        yield f"{what}: the other unknown", of(given=(4, 3)), False
        yield f"{what}: another c", of(lambda x: [x[0], (x[1][0], [plus(x[1][1][0], [F(1)]), x[1][1][1]])]), False
        yield f"{what}: another sign of c", of(lambda x: [x[0], (x[1][0], [[-c for c in x[1][1][0]], x[1][1][1]])]), False
        yield f"{what}: another b", of(lambda x: [(x[0][0], [x[0][1][0], [2 * c for c in x[0][1][1]]]), x[1]]), False
        yield f"{what}: triangular", of(lambda x: [(x[0][0], [x[0][1][0], []]), x[1]]), False
        yield f"{what}: factors", of(factors=[(q, -e) for q, e in factors]), False
        yield f"{what}: no factors", of(factors=()), False
        yield f"{what}: without a certificate", of(inner=None), False
        other = json.loads(read("data/mec-cubic-1-naive.json"))
        yield f"{what}: another certificate", of(inner=other, power=60), False
    for name in ("airy-naive", "lag-2-naive", "her-2"):
        rows, factors, inner = of_second_order(name)
        yield f"{name}: an infinite group", certificate(system(*rows), [*BLOCKS, block(3, 4, factors=factors, certificate=inner)]), False
    rows, factors, inner = of_second_order("giac-2")
    made = certificate(system(*rows), [*BLOCKS, block(3, 4, factors=factors, certificate=inner)], 4)
    yield "the group is not claimed", changed(made, ["shows", "blocks", "3", "certificate", "claim"], {"abelian": True}), False
    yield "over Q(i), by a certificate over Q", made | {"field": GAUSS}, True


def gaussian():
    """Over Q(i), with i in the coefficients"""
    rows = system(([F(0), F(1)], [[F(0)]]))
    rows[0]["num"][1] = [["1", "2"]]                                                # y1' = (1 + 2 i) y2/z
    rows[1] = {"den": [["0", "-1"], ["0", "1"]], "num": [[], [], ["1"], []]}        # i (z - 1) y2' = y3
    rows[3] = {"den": [["0"], ["0", "1/3"]], "num": [[], [], [], [["0", "1/6"]]]}   # (i/3) z y4' = (i/6) y4
    for power, right in ((2, True), (1, False)):
        yield f"Q(i): power {power}", certificate(rows, [*BLOCKS, block(3, factors=[([F(0), F(1)], F(1, 2))])], power, field=GAUSS), right
    rows[3] = {"den": ["0", "1"], "num": [[], [], [], [["0", "1/2"]]]}              # z y4' = (i/2) y4
    yield "Q(i): z^(i/2)", certificate(rows, [*BLOCKS, block(3, factors=[([F(0), F(1)], F(1, 2))])], 2, field=GAUSS), False
    for minpoly in (["-1", "0", "1"], ["2", "0", "1"], ["1", "1", "1"], ["1", "1"], ["2", "1"], ["1", "0", "0", "1"]):
        yield f"the field {minpoly}", certificate(system(), BLOCKS, field={"name": "i", "minpoly": minpoly}), False


def partitions():
    rows, three = system(([F(0), F(1)], [[F(1, 2)]])), block(3, factors=[([F(0), F(1)], F(1, 2))])
    for why, blocks, right in (
            ("another order that is right", [three, *BLOCKS], True), ("between", [BLOCKS[0], three, *BLOCKS[1:]], True),
            ("1 before 2", [BLOCKS[1], BLOCKS[0], BLOCKS[2], three], False), ("0 first", [BLOCKS[2], *BLOCKS[:2], three], False),
            ("one is missing", BLOCKS, False), ("one twice", [*BLOCKS, three, three], False), ("none", [], False),
            ("an empty one", [*BLOCKS, three, block()], False), ("of three", [block(0, 1, 2), three], False),
            ("there is no 4", [*BLOCKS, three, block(4)], False), ("of two, triangular", [BLOCKS[0], block(0, 1), three], False),
            ("a certificate for one", [*BLOCKS[:2], block(0, certificate=json.loads(read("data/giac-2.json"))), three], False)):
        yield f"blocks: {why}", certificate(rows, blocks, 2), right
    zeros = [block(k) for k in range(3, 9)]
    yield "eight unknowns", certificate(system(*[([F(1)], [[]])] * 5), [*BLOCKS, *zeros[:5]]), True
    yield "nine unknowns", certificate(system(*[([F(1)], [[]])] * 6), [*BLOCKS, *zeros]), False
    yield "no unknown", certificate([], []), False


def words():
    one = certificate(system(), BLOCKS)

    def of(*word, row="0", column="2", b=("1",)):
        shows = one["shows"]
        return one | {"shows": shows | {"A": shows["A"] | {"word": list(word)}, "B": shows["B"] | {"word": list(b)}, "row": row,
                                        "column": column}}
    for word, right in ((("0",) * 12, True), (("0",) * 13, False), ((), False), (("2",), False), (("-1",), False), (("1",), False),
                        (("1", "1"), False), (("0", "1"), True), (("1", "0", "1"), True), (("0", "2"), False), (("2", "0"), False)):
        yield f"the word {' '.join(word)}", of(*word), right
    yield "the second word is empty", of("0", b=()), False
    for i in range(-1, 4):
        for j in range(-1, 4):
            yield f"the entry {i}, {j}", of("0", row=str(i), column=str(j)), (i, j) == (0, 2)
    yield "power 1000", certificate(system(), BLOCKS, 1000), True
    yield "power 1001", certificate(system(), BLOCKS, 1001), False
    other = json.loads(json.dumps(one))
    other["shows"]["B"]["power"] = "-1"
    yield "the other power", other, False


def polygons():
    one = certificate(system(), BLOCKS)

    def of(second, **more):
        return one | {"loops": [AROUND_0, second]} | more
    far, last = ["1/2", "-3/2"], AROUND_1[6:]
    for why, second, right in (
            ("not closed", AROUND_1[:-1], False), ("another base", [*AROUND_1[1:], AROUND_1[1]], False), ("no point", [], False),
            ("one point", [BASE], False), ("two points", [BASE, BASE], False), ("there and back", [*AROUND_1[:5], *AROUND_1[3::-1]], False),
            ("a point twice", [BASE, BASE, *AROUND_1[1:]], True), ("the other way", AROUND_1[::-1], True),
            ("a long step", [BASE, *AROUND_1[5:]], False), ("to 1", [*walk(BASE, ("1", "-1/2"), ("1", "0"), ("1/2", "0"), BASE)], False),
            ("near 1", walk(BASE, ("1", "-1/2"), ("1", "-1/1024"), ("1/2", "-1/1024"), BASE), False),
            ("no loop around 1", walk(BASE, ("3/2", "-1/2"), ("3/2", "-3/2"), far, BASE), False), ("around both", AROUND_1 + AROUND_0, True),
            ("three coordinates", [[*x, "0"] for x in AROUND_1], False), ("one coordinate", [x[:1] for x in AROUND_1], False),
            ("a third", [*AROUND_1[:5], ["4/3", "-1/2"], *last], False), ("a third above", [*AROUND_1[:5], ["3/2", "-1/3"], *last], False),
            ("sixths", [*AROUND_1[:5], ["9/6", "-7/12"], *last], False), ("eighths", [*AROUND_1[:5], ["13/8", "-5/16"], *last], True),
            ("a point far away", [*AROUND_1[:5], [str(2**400), "0"], *last], False)):
        yield f"a polygon: {why}", of(second), right
    whole = system()
    whole[1] = row([F(-8), F(1)], [], [], [F(1)])                               # at 8 in the place of 1
    loops = [walk(("4", "-4"), ("4", "4"), (x, "4"), (x, "-4"), ("4", "-4"), step=1) for x in ("-4", "12")]
    yield "whole points, and a denominator 1", certificate(whole, BLOCKS, loops=loops), True
    yield "another base of the first", one | {"loops": [AROUND_0[1:] + AROUND_0[1:2], AROUND_1]}, False
    yield "both end elsewhere", one | {"loops": [[*AROUND_0[:-1], far], [*AROUND_1[:-1], far]]}, False
    yield "no loops", one | {"loops": []}, False
    yield "16 loops", one | {"loops": [AROUND_0, AROUND_1, *[[BASE] * 3] * 14]}, True
    yield "17 loops", one | {"loops": [AROUND_0, AROUND_1, *[[BASE] * 3] * 15]}, False
    yield "2001 points", one | {"loops": [AROUND_0, AROUND_1, [BASE] * 1991]}, False
    for bits, right in (("32", True), ("31", False), ("8193", False), ("0", False)):
        yield f"{bits} bits", one | {"bits": bits}, right
    for den, num in (([], ["1"]), ([["0"]], ["1"])):
        yield "a denominator 0", changed(changed(one, ["system", "1", "den"], den), ["system", "1", "num", "2"], num), False
    yield "a row too short", changed(one, ["system", "2", "num"], [[], []]), False
    yield "a row too long", changed(one, ["system", "2", "num"], [[], [], [], []]), False
    yield "degree 101", changed(one, ["system", "2", "den"], ["1", *["0"] * 100, "1"]), False
    yield "degree 101 of an entry", changed(one, ["system", "0", "num", "1"], ["1", *["0"] * 100, "1"]), False


def hypergeometric(a, b, c):
    """z (1 - z) y'' + (c - (a + b + 1) z) y' - a b y = 0"""
    return [row([F(1)], [], [F(1)]), row([F(0), F(1), F(-1)], [a * b], [-c, a + b + 1])]


def full_groups():
    """The image in PGL(2, C) is everything"""
    def of(rows, a="0", b="1", c="001", **more):
        return {"format": "kovacic-loops/1", "title": "", "field": RATIONALS, "system": rows, "bits": "64", "loops": [AROUND_0, AROUND_1],
                "shows": {"by": "sl2", "A": list(a), "B": list(b), "C": list(c)}} | more
    # the exponents differ by 1 - c at 0, c - a - b at 1, a - b at infinity
    legendre = hypergeometric(F(1, 2), F(1, 2), F(1))
    for words, right in ((("0", "1", "001"), True), (("0", "1", "01"), False), (("0", "1", "0"), False), (("0", "0", "001"), False),
                         (("0", "00", "001"), False), (("0", "01", "001"), True), (("01", "1", "011"), True), (("0", "1", "0000"), False),
                         (("", "1", "001"), False), (("0", "", "001"), False), (("0", "1", ""), False), (("0", "1", "2"), False)):
        yield f"Legendre: {' '.join(words)}", of(legendre, *words), right
    for n, right in ((2, False), (3, False), (4, False), (5, False), (6, True), (7, True)):
        # at 0 an element of order n; differences 1/n, 1/7, 1/8
        a = (1 - F(1, n) - F(1, 7) - F(1, 8)) / 2
        yield f"C of order {n}", of(hypergeometric(a, a + F(1, 8), 1 - F(1, n)), "01", "10", "0"), right
        yield f"C of order {n}, or not", of(hypergeometric(a, a + F(1, 8), 1 - F(1, n)), "01", "001", "001"), n > 2 or None
    yield "reducible", of(hypergeometric(F(0), F(1, 3), F(1, 5))), False
    yield "reducible, of two other orders", of(hypergeometric(F(1, 3), F(3, 4), F(3, 4)), "0", "1", "01"), False
    yield "dihedral", of(hypergeometric(F(1, 7), F(-1, 7), F(1, 2)), "0", "1", "01"), False
    yield "dihedral, the other loops", of(hypergeometric(F(1, 7), F(-1, 7), F(1, 2)), "01", "1", "01"), False
    yield "three unknowns", of([*map(lambda x: x | {"num": [*x["num"], []]}, legendre), row([F(1)], [], [], [])]), False
    yield "one unknown", of([row([F(0), F(1)], [F(1)])]), False
    yield "few bits", of(legendre, bits="32"), True


def certificates():
    """(name, text, is it right?)"""
    for some in (radicals, equations, gaussian, partitions, words, polygons, full_groups):
        for name, top, right in some():
            if right is not None:
                yield name, json.dumps(top), right
