"""Reads kovacic-certificate/1 (docs/theory/certificates.md): syntax, types and sizes; nothing is judged here.

A schema says what each key holds, a tuple which words, a list of one what the entries of an array are, a longer one what each is;
'?' marks optional keys; 'by' chooses a variant."""
import json
import re
import sys
from contextlib import contextmanager
from fractions import Fraction
from math import lcm

from exact import K, Poly

getattr(sys, "set_int_max_str_digits", lambda n: None)(0)
LENGTH, BULK = 200001, 4 * 10**9            # coefficients of a polynomial; the same times the bits of the largest


class Malformed(Exception):
    """Not a certificate of this format."""


class Rejected(Exception):
    """A certificate that proves nothing."""


def need(condition, why):
    if not condition:
        raise Rejected(why)


def right(condition, what):
    if not condition:
        raise Malformed(what)


@contextmanager
def refusing(where=""):
    """An error that the data lead to is a refusal; where: said before the reason."""
    try:
        yield
    except Rejected as why:
        raise Rejected(f"{where}{why}") from None
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as why:
        raise Rejected(f"{where}{type(why).__name__}: {why}") from None


PRIME = {"p": "int", "a": "residue"}
LOG = PRIME | {"roots?": ["residue"]}
SERIES = PRIME | {"place": "place", "root": "residue", "delta": "residue", "terms": "int",
                  "lines": [{"length": "int", "approximant": ["residue"]}]}
PLACE = {"q": "poly", "order": "int", "delta2?": "poly", "eps2?": "poly", "irrational?": PRIME, "log?": LOG,
         "annihilator?": "poly"}
POINTS = PRIME | {"l": "int"} | dict.fromkeys(("w", "x1", "s1", "x2", "s2"), "residue")
THEOREMS = ("sl2-p-curvature", "sl2-irreducible-log", "sl2-irreducible-infinite", "sl2-irreducible-12", "borel", "additive", "diagonal",
            "dihedral-infinite", "dihedral-holomorphic", "dihedral-genus-0", "dihedral-finite", "dihedral-torsion", "quaternion",
            "tetrahedral", "octahedral", "icosahedral", "invariant-abelian", "torus-nonabelian")
RULES = {
    "local": {"prime": PRIME, "places": [PLACE], "infinity": {"eps2?": "poly", "log?": LOG, "annihilator?": "poly"}},
    "exponential": {"p": "poly", "num": "poly", "den": "poly"},
    "invariant": {"prime": PRIME, "m": "int", "p": "poly", "factors": [{"q": "poly", "e": "rational"}]},
    "no-exponential": {"by": {"parity": {}, "degree": {}, "series": SERIES}},
    "p-curvature": PRIME | {"shows": "text"},
    "no-invariant": {"m": "int", "by": {"degree": {}, "series": PRIME | {"x0": "residue", "terms": "int"}}},
    "torsion-function": {"n": "int", "a": "poly", "b": "poly", "den": "poly", "minimal": [POINTS]},
    "good-reduction": PRIME,
    "conclude": {"theorem": THEOREMS},
    "apply-theorem": {"theorem": "text", "statement": "text"},
}
CLAIM = {"group": "text", "n": "int", "component": "text", "abelian": "truth"}
STEP = {"id": "text", "rule": "text", "premises": ["text"], "data": "any"}
COND = {"p": "text", "sign": ("positive", "nonnegative", "nonzero", "zero")}
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,999}\Z")
INTEGER = re.compile(r"(0|-?[1-9][0-9]{0,199999})\Z")
RATIONAL = re.compile(r"(0|-?[1-9][0-9]{0,199999}(/[1-9][0-9]{0,199999})?)\Z")


def read(kind, v, path):
    """The JSON value v as what the schema says."""
    def right(condition, what):
        if not condition:
            raise Malformed(f"{path}: {what}")
    if isinstance(kind, dict):
        right(isinstance(v, dict), "an object is expected")
        if isinstance(kind.get("by"), dict):
            right(isinstance(v.get("by"), str) and v["by"] in kind["by"], "'by' is unknown")
            kind = kind | kind["by"][v["by"]] | {"by": "text"}
        names = {k.rstrip("?"): k for k in kind}
        right(set(v) <= set(names), f"unknown keys {sorted(set(v) - set(names))[:3]}")
        right(all(k in v for k in kind if k[-1] != "?"), f"keys are missing: {sorted(set(names) - set(v))}")
        right(all(v.get(k[:-1], 0) is not None for k in kind if k[-1] == "?"), "an optional key is never null")
        return {k: read(kind[full], v[k], f"{path}.{k}") if k in v else None for k, full in names.items()}
    if isinstance(kind, list):
        right(isinstance(v, list), "an array is expected")
        right(len(v) <= LENGTH, "too many entries")
        right(len(kind) in (1, len(v)), f"{len(kind)} entries are expected")
        return [read(kind[min(i, len(kind) - 1)], x, f"{path}[{i}]") for i, x in enumerate(v)]
    if kind == "poly":
        return read_poly(v, right)
    if kind in ("any", "truth", "true"):
        right(kind == "any" or v is True or v is False and kind == "truth", f"{kind} is expected")
        return v
    right(isinstance(v, str), "a string is expected")
    if isinstance(kind, tuple):
        right(v in kind, f"{', '.join(kind)} is expected")
    if isinstance(kind, tuple) or kind == "text" or kind == "place" and v == "infinity":
        return v
    right(kind != "short" or len(v) <= 40, "the coefficients are too large")
    right((RATIONAL if kind == "rational" else INTEGER).match(v), "a number is expected")
    v = Fraction(v) if kind == "rational" else int(v)
    right(kind != "residue" or 0 <= v < 2**62, "a residue is expected")
    right(kind != "natural" or v >= 0, "a natural number is expected")
    return v


def read_poly(v, right):
    right(isinstance(v, list), "a polynomial is expected")
    right(len(v) <= LENGTH, "too many coefficients")
    rows, q, largest = [], 1, 1
    for row in v:
        row = row if isinstance(row, list) else [row]
        right(1 <= len(row) <= K.d and all(isinstance(x, str) and RATIONAL.match(x) for x in row),
              "an element of the field is expected")
        rows.append([Fraction(x) for x in row])
        q, largest = lcm(q, *(x.denominator for x in rows[-1])), max(largest, *(abs(x.numerator) for x in rows[-1]))
        right(len(rows) * (largest.bit_length() + 2 * q.bit_length()) <= BULK, "the polynomial is too large")
    right(not rows or any(rows[-1]), "the leading coefficient is 0")
    return Poly([x for row in rows for x in
                 [y.numerator * (q // y.denominator) for y in row] + [0] * (K.s - len(row))], q)


def parse(text):
    """JSON in UTF-8 without numbers and without repeated keys."""
    def no_number(_):
        raise Malformed("numbers must be strings")

    def unique(pairs):
        if len(dict(pairs)) < len(pairs):
            raise Malformed("a key occurs twice")
        return dict(pairs)
    try:
        value = json.loads(text, object_pairs_hook=unique, parse_int=no_number, parse_float=no_number,
                           parse_constant=no_number)
        if re.search(r"(?i)\\ud", text):
            json.dumps(value, ensure_ascii=False).encode()  # an error for half of a pair of surrogates
        return value
    except (ValueError, RecursionError) as error:
        raise Malformed(f"not JSON: {str(error)[:80]}") from None


def minimal_polynomial(field):
    return read({"name": "text", "minpoly": ["short"]}, field, "field")["minpoly"]


def set_field(minimal):
    K.m, K.d, K.s = minimal, len(minimal) - 1, 2 * len(minimal) - 3


def load(top):
    """num, den, claim and steps of a certificate; sets the field K."""
    top = read({"format": "text", "field": "any", "r": "any", "claim": "any", "steps": [STEP]}, top, "certificate")
    field = minimal_polynomial(top["field"])
    right(top["format"] == "kovacic-certificate/1" and 1 <= len(top["steps"]) <= 1000,
          "a kovacic-certificate/1 with 1 to 1000 steps is expected")
    right(2 <= len(field) <= 25 and field[-1] == 1 and (field[0] == 0 or len(field) > 2),
          "field.minpoly: a monic polynomial of degree 1 (z itself) to 24 is expected")
    set_field(field)
    r = read({"num": "poly", "den": "poly"}, top["r"], "r")
    given = read(dict.fromkeys(CLAIM, "any"), top["claim"], "claim")
    claim = {k: read(CLAIM[k], v, f"claim.{k}") for k, v in given.items() if v is not None}
    for i, step in enumerate(top["steps"]):
        right(step["rule"] in RULES, f"steps[{i}]: unknown rule")
        step["data"] = read(RULES[step["rule"]], step["data"], f"steps[{i}].data")
    return r["num"], r["den"], claim, top["steps"]
