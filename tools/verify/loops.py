"""Checks certificates of matrices of loops, kovacic-loops/1 (docs/theory/loop_certificates.md; L1 to L4 are its rules).

continuation.py continues the fundamental matrix along the polygons that are given; here are the inequalities, and why a
power of every element of the group is unipotent."""
from fractions import Fraction
from math import lcm

import checked
from certificate_format import minimal_polynomial, need, read, refusing, right, set_field
from continuation import along
from enclosures import Gaussian, adjugate, determinant, matrix, precision
from exact import K, ONE, ZERO, from_rows
from modular import power
from statement import over_field, quoted

__all__ = ["FORMAT", "verify"]

FORMAT = "kovacic-loops/1"
SIZE, DEGREE, BITS, LOOPS, POINTS, LETTERS, POWER, FACTORS = 8, 100, 8192, 16, 2000, 12, 1000, 40
ELEMENT = {"word": ["natural"], "power": "int"}
SHOWS = {"sl2": dict.fromkeys("ABC", ["natural"]),
         "not-abelian": {"A": ELEMENT, "B": ELEMENT, "row": "natural", "column": "natural",
                         "blocks": [{"unknowns": ["natural"], "factors": [{"q": "poly", "e": "rational"}],
                                     "certificate?": "any"}]}}
TOP = {"format": "text", "title": "text", "field": "any", "system": [{"den": "poly", "num": ["poly"]}], "bits": "int",
       "loops": [[["rational"]]], "shows": {"by": SHOWS}}
GROUPS = {"cyclic": lambda n: n, "T": lambda n: n, "D": lambda n: lcm(2 * n, 4), "A4": lambda n: 12, "S4": lambda n: 24,
          "A5": lambda n: 60}


def gaussian(f, factor):
    """The coefficients of factor f, in Z[i]; the generator is i."""
    return [Gaussian(x * factor // f.q, y * factor // f.q) for x, y, *_ in (block + [0] * 2 for block in f.blocks())]


def read_loops(top):
    field = minimal_polynomial(top.get("field"))
    right(field in ([0, 1], [1, 0, 1]), "field: Q or Q(i) is expected")
    set_field(field)
    d = read(TOP, top, "certificate")
    n = len(d["system"])
    right(1 <= n <= SIZE, "the size of the system is out of range")
    for row in d["system"]:
        right(len(row["num"]) == n and row["den"].c, "a row with a denominator is expected")
        right(all(f.degree() <= DEGREE for f in [row["den"], *row["num"]]), "a degree is out of range")
    right(32 <= d["bits"] <= BITS and 1 <= len(d["loops"]) <= LOOPS, "a number is out of range")
    right(sum(map(len, d["loops"])) <= POINTS, "too many points")
    right(all(1 <= d["shows"][x]["power"] <= POWER for x in "AB" if d["shows"]["by"] != "sl2"), "a power is out of range")
    d["loops"] = [[point(x) for x in loop] for loop in d["loops"]]
    return d


def point(x):
    """x + i y as integers over a common power of two."""
    right(len(x) == 2, "a point has two coordinates")
    scale = max(v.denominator for v in x)
    right(all(v.denominator & (v.denominator - 1) == 0 for v in x), "coordinates are dyadic")
    right(scale.bit_length() <= 400 and all(abs(v) < 2**400 for v in x), "a coordinate is too long")
    return int(x[0] * scale), int(x[1] * scale), scale


def matrices(d):
    """L1: closed polygons with one base point."""
    rows = []
    for row in d["system"]:
        factor = lcm(*(f.q for f in [row["den"], *row["num"]]))
        rows.append((gaussian(row["den"], factor), [gaussian(f, factor) for f in row["num"]]))
    base = d["loops"][0][0] if d["loops"][0] else None
    for loop in d["loops"]:
        need(len(loop) >= 3 and loop[0] == loop[-1] == base, "a loop is not closed at the base point")
    return [along(rows, loop, d["bits"]) for loop in d["loops"]]


def product(word, loops):
    need(1 <= len(word) <= LETTERS and all(0 <= i < len(loops) for i in word), "a word is out of range")
    m = loops[word[0]]
    for i in word[1:]:
        m = matrix(loops[i], m)
    return m


# ---- L2

def trace(m):
    return m[0][0] + m[1][1]


def need_sl2(d, shows, loops):
    need(len(d["system"]) == 2, "the size is not 2")
    a, b, c = (product(shows[x], loops) for x in "ABC")
    a, b = matrix(a, a), matrix(b, b)
    dets = determinant(a) * determinant(b)
    commutator = matrix(matrix(a, b), matrix(adjugate(a), adjugate(b)))
    need((trace(commutator) - dets - dets).not_zero(), "A^2 and B^2 may have a common line")
    x, det = trace(c) * trace(c), determinant(c)
    two = det + det
    value = (x * x - x * (two + det) + det * det) * x * (x - det) * (x - two) * (x - two - two)
    need(value.not_zero(), "C may be of a small order")


# ---- L3, L4

def need_not_abelian(shows, loops, n):
    u, v = ((shows[x]["word"], shows[x]["power"]) for x in "AB")
    order = len(loops[0])
    for _, e in (u, v):
        need(e % n == 0, "a power is not proved to be unipotent")
    a, b = (power(product(word, loops), e, matrix) for word, e in (u, v))
    row, column = shows["row"], shows["column"]
    need(0 <= row < order and 0 <= column < order, "an entry is out of range")
    need((matrix(a, b)[row][column] - matrix(b, a)[row][column]).not_zero(), "the entry may be 0")


class Quotient:
    """A rational function."""

    def __init__(self, num, den=ONE):
        self.num, self.den = num, den

    def __add__(self, o):
        return Quotient(self.num * o.den + o.num * self.den, self.den * o.den)

    def __mul__(self, o):
        return Quotient(self.num * o.num, self.den * o.den) if isinstance(o, Quotient) else Quotient(self.num * o, self.den)

    def diff(self):
        return Quotient(self.num.diff() * self.den - self.num * self.den.diff(), self.den * self.den)

    def __eq__(self, o):
        return self.num * o.den == o.num * self.den


def radical(f, factors):
    """m with exp(int f)^m rational: f = sum e q'/q, m the common denominator of all e."""
    need(len(factors) <= FACTORS, "too many factors")
    total = Quotient(ZERO)
    for x in factors:
        need(x["q"].degree() > 0, "a factor is constant")
        total = total + Quotient(x["q"].diff(), x["q"]) * x["e"]
    need(f == total, "the logarithmic derivative is another one")
    return lcm(1, *(x["e"].denominator for x in factors))


def order_of_two(a, unknowns, block, prove):
    """y1'' + p y1' + q y1 = 0 of the block (a b; c d)."""
    i, j = unknowns
    b, c = a[i][j], a[j][i]
    need(b.num.c, "the block is triangular")
    e = b.diff() * Quotient(b.den, b.num) + a[j][j]
    p = (a[i][i] + e) * -1
    q = a[i][i].diff() + b * c + a[i][i] * e * -1               # -q
    r = p * p * Fraction(1, 4) + p.diff() * Fraction(1, 2) + q
    m, minimal = radical(p * Fraction(-1, 2), block["factors"]), K.m
    need(block["certificate"] is not None, "a certificate is missing")
    num, den, claim, trusted, _ = prove(block["certificate"])
    need(K.m in ([0, 1], minimal), "the equation is over another field")
    parts = [coefficients(num), coefficients(den)]
    set_field(minimal)
    num, den = (from_rows(x) for x in parts)
    need(den.c and r == Quotient(num, den), "the certificate is about another equation")
    need(claim.get("group") in GROUPS, "the group is not finite, cyclic or T")
    n = claim.get("n") or 0
    need(claim["group"] in ("A4", "S4", "A5") or n >= 1, "the group has no order")
    return lcm(m, GROUPS[claim["group"]](n)), trusted


def coefficients(f):
    return [[Fraction(x, f.q) for x in block] for block in f.blocks()]


def eigenvalue_order(d, shows, prove):
    """L4: n such that all eigenvalues of every element are n-th roots of unity; block i uses blocks up to i only."""
    a = [[Quotient(f, row["den"]) for f in row["num"]] for row in d["system"]]
    blocks, seen, n, trust = shows["blocks"], [], 1, 0
    need(sorted(i for b in blocks for i in b["unknowns"]) == list(range(len(a))), "the blocks are not a partition")
    for block in blocks:
        unknowns = block["unknowns"]
        seen += unknowns
        need(all(not a[i][j].num.c for i in unknowns for j in range(len(a)) if j not in seen), "the blocks are in another order")
        need(len(unknowns) in (1, 2), "a block is larger than 2")
        if len(unknowns) == 1:
            need(block["certificate"] is None, "a certificate of a block of order 1")
            n = lcm(n, radical(a[unknowns[0]][unknowns[0]], block["factors"]))
        else:
            order, trusted = order_of_two(a, unknowns, block, prove)
            n, trust = lcm(n, order), trust + trusted
        need(n <= POWER, "the orders are too large")
    return n, trust


def statement(d):
    generator = ", a^2 + 1 = 0" if K.d == 2 else ""
    lines = [f"the system {quoted(d['title'])}{generator}"]
    for i, row in enumerate(d["system"]):
        terms = " + ".join(f"({over_field(f)}) y{j + 1}" for j, f in enumerate(row["num"]) if f.c) or "0"
        lines.append(f"  ({over_field(row['den'])}) y{i + 1}' = {terms}")
    said = {"sl2": "has a differential Galois group that is SL(2, C) up to scalars: its image in PGL(2, C) is everything",
            "not-abelian": "has a differential Galois group whose identity component is not abelian"}
    return lines + [said[d["shows"]["by"]]]


def verify(top, prove, _=False):
    """The number of trusted steps, a summary and the statement; prove checks ordinary certificates."""
    _, trust, lines = accept(top, prove)
    return trust, "", lines


@checked.file()
def accept(top, prove):
    """What was read, checked; the number of trusted steps and the statement.  K is the field of the system."""
    d, trust = read_loops(top), 0
    shows = d["shows"]
    with refusing(), precision(d["bits"]):
        if shows["by"] == "sl2":
            need_sl2(d, shows, matrices(d))
            checked.label(FORMAT, "L1")
        else:
            n, trust = eigenvalue_order(d, shows, prove)
            need_not_abelian(shows, matrices(d), n)
            checked.label(FORMAT, "L1 L4")
        checked.add(FORMAT, "by", shows["by"])
        checked.conclude((), "one system Y' = A(z) Y, over C(z)")
    return d, trust, statement(d)
