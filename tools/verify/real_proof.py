"""Signs over the reals: a NODE proves that no real point satisfies all conditions of a list
(docs/theory/theorem_certificates.md 2).  A condition is a pair (f, sign)."""
from math import lcm

from certificate_format import Malformed, need, read
from multivariate import P, parse, ratio, spend

NEGATED = {"positive": ("nonnegative", -1), "nonnegative": ("positive", -1), "nonzero": ("zero", 1), "zero": ("nonzero", 1)}
BRANCHES = {"sign": (("positive", 1, "positive"), ("zero", 1, "zero"), ("negative", -1, "positive")),
            "zero": (("nonzero", 1, "nonzero"), ("zero", 1, "zero"))}
SIGNED = ("positive", "nonnegative")
DEPTH, TERMS, ZEROS, BITS = 64, 1000, 200, 33220                # 10000 digits


class Nodes:
    left = 0
    complex = frozenset()                   # variables that need not be real


def conditions(rows, names):
    """[{"p": P, "sign": SIGN}, ...]"""
    if any(row["sign"] not in NEGATED for row in rows):
        raise Malformed("a sign is expected")
    return [(parse(row["p"], names), row["sign"]) for row in rows]


def refute(v, given, names, leaf=None, depth=DEPTH):
    """Accepts a NODE for these conditions; leaf: takes nodes of other kinds."""
    Nodes.left -= 1
    need(Nodes.left >= 0 and depth > 0, "too many nodes")
    kind = v.get("node") if isinstance(v, dict) else None
    if kind == "empty":
        return contradiction(read({"node": "text", "terms": ["any"], "zeros": ["any"]}, v, "empty"), given, names)
    if kind not in BRANCHES:
        if leaf is None or not isinstance(kind, str):
            raise Malformed("an unknown node")
        return leaf(v, given)
    d = read({"node": "text", "p": "text"} | {key: "any" for key, *_ in BRANCHES[kind]}, v, kind)
    f = parse(d["p"], names)
    need(kind != "sign" or is_real(f, given), "the sign of what need not be real")
    for key, factor, sign in BRANCHES[kind]:
        refute(d[key], [*given, (f * factor, sign)], names, leaf, depth - 1)


def is_real(f, given):
    """At each point with these conditions: its variables are, or a condition says so of a multiple by a number."""
    return not f.variables() & Nodes.complex or any(g and sign in SIGNED and ratio(f, g) is not None for g, sign in given)


def show(f, sign, v, given, names):
    """Accepts a NODE for the conditions and the negation of (f, sign); that of a sign is one for what is real only."""
    negation, factor = NEGATED[sign]
    need(sign not in SIGNED or is_real(f, given), "the sign of what need not be real")
    refute(v, [*given, (f * factor, negation)], names)


def contradiction(d, given, names):
    """sum of the TERMs + sum P f = 0, and a TERM is strict"""
    if len(d["terms"]) > TERMS or len(d["zeros"]) > ZEROS:
        raise Malformed("too many terms")
    terms = [term(v, given, names) for v in d["terms"]]
    common, total = 1, P()
    for c, *_ in terms:
        spend(common.bit_length() >> 6)
        common = short(lcm(common, short(c.denominator)))
    for c, f, *_ in terms:
        total += f * (short(c.numerator) * (common // c.denominator))
    for v in d["zeros"]:
        if not isinstance(v, list) or len(v) != 2:
            raise Malformed("an index and a polynomial are expected")
        f, sign = at(v[0], given)
        need(sign == "zero", "a condition is not one of sign zero")
        total += parse(text(v[1]), names) * f * common
    need(any(strict for *_, strict, _ in terms), "no term is strict")
    need(len(terms) == 1 or all(real for *_, real in terms), "a factor has no sign")
    need(not total, "the sum is not 0")


def short(n):
    need(n.bit_length() <= BITS, "a limit: the length of a number")
    return n


def text(v):
    return read("text", v, "a polynomial")


def at(v, given):
    i = read("int", v, "an index")
    need(0 <= i < len(given), "there is no such condition")
    return given[i]


def term(v, given, names):
    """[c, Q, [i, e], ...]: c, Q^2 prod f_i^e, whether it is strict (nowhere 0), and whether it is >= 0 at each point"""
    if not isinstance(v, list) or len(v) < 2:
        raise Malformed("a term is expected")
    c, q = read("rational", v[0], "a number"), parse(text(v[1]), names)
    need(c > 0, "a factor is not positive")
    spend(10 * len(v))
    f, strict, real = q * q, q.constant() not in (None, 0), not q.variables() & Nodes.complex
    for pair in v[2:]:
        if not isinstance(pair, list) or len(pair) != 2:
            raise Malformed("an index and an exponent are expected")
        g, sign = at(pair[0], given)
        e = read("int", pair[1], "an exponent")
        need(1 <= e <= 100, "an exponent is out of range")
        need(sign != "zero", "a factor has no sign")
        real = real and (sign != "nonzero" or e % 2 == 0 and not g.variables() & Nodes.complex)
        strict, f = strict and sign != "nonnegative", f * g**e
    return c, f, strict, real
