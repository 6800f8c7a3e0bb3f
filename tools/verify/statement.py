"""What has been checked, as text (docs/theory/strata_certificates.md 8, certificates.md 4): lines made from what was
read and from nothing else."""
import re
from fractions import Fraction

from exact import K
from multivariate import FIELD, MASK

RELATION = {"positive": "> 0", "nonnegative": ">= 0", "nonzero": "!= 0", "zero": "= 0"}
SAID = {"yes": "abelian", "no": "not abelian", "empty": "no points"}


def quoted(text):
    """The text of somebody else; it does not end its quotation."""
    return '"' + re.sub(r"[^ -~]", "?", text).replace('"', "'") + '"'


def equation_text(num, den):
    """y'' = (num/den) y, with the parentheses that it needs"""
    num, den = ([text, f"({text})"][any(c in text for c in signs)] for text, signs in ((num, " /"), (den, " /*")))
    if den == "1":
        return "y'' = " + f"{num} " * (num != "1") + "y"
    return f"y'' = ({num}/{den}) y"


def joined(terms, names):
    """terms: pairs (exponents, coefficient), in the order in which they are shown"""
    text = ""
    for exponents, c in terms:
        sign, size = "-" if c < 0 else "+", abs(c)
        powers = [name + f"^{e}" * (e > 1) for name, e in zip(names, exponents) if e]
        text += f" {sign} " if text else "-" * (c < 0)
        text += "*".join(([str(size)] if size != 1 or not powers else []) + powers)
    return text or "0"


def polynomial(f, names, at=None):
    """f in several variables, names: of all in their order; at: these variables, if not one after the other"""
    at = [FIELD * i for i in range(len(names))] if at is None else at
    return joined(sorted((([k >> x & MASK for x in at], c) for k, c in f.items()), reverse=True), names)


def over_field(f):
    """f in K[z]; the generator is called a."""
    rows = [(i, f.c[i * K.s:i * K.s + K.d]) for i in range(f.degree(), -1, -1)]
    return joined([((i, j), Fraction(row[j], f.q)) for i, row in rows for j in range(len(row) - 1, -1, -1) if row[j]],
                  ("z", "a"))


def group(num, den, minimal, claim, trusted):
    """Of an ordinary certificate; trusted: pairs (theorem, statement)."""
    field = joined([((j,), c) for j, c in reversed(list(enumerate(minimal))) if c], ("a",))
    lines = [equation_text(over_field(num), over_field(den)) + f", {field} = 0" * (len(minimal) > 2)]
    said, word = [], {True: "abelian", False: "not abelian"}.get(claim.get("abelian"))
    if "group" in claim:
        said.append(f"the differential Galois group is {claim['group']}" + (f"_{claim['n']}" if "n" in claim else ""))
    if "component" in claim:
        said.append(f"its identity component is {claim['component']}")
    if word:
        said.append(word if "component" in claim else f"its identity component is {word}")
    return lines + [", ".join(said)] + [f"trusted, {quoted(a)}: {quoted(b)}" for a, b in trusted]


def step(rule, d):
    """The data of a step, in formulas"""
    def f(key, data=d):
        return f"({over_field(data[key])})"
    by = f"by {d.get('by')}" + f" modulo {d.get('p')}" * (d.get("by") == "series")
    if rule == "local":
        return "den = " + ("*".join(f("q", x) + f"^{x['order']}" * (x["order"] != 1) for x in d["places"]) or "1")
    if rule == "exponential":
        return f"omega = {f('num')}/{f('den')}" + f" + p'/p, p = {over_field(d['p'])}" * (d["p"].degree() > 0)
    if rule == "invariant":
        return f"m = {d['m']}, v = {f('p')}" + "".join(f"*{f('q', x)}^({x['e']})" for x in d["factors"] if x["e"])
    if rule == "torsion-function":
        return f"n = {d['n']}, h = ({f('a')} + {f('b')} w s)/{f('den')}"
    if rule == "apply-theorem":
        return f"{quoted(d['theorem'])}: {quoted(d['statement'])}"
    return {"no-exponential": by, "p-curvature": f"{d.get('shows')} modulo {d.get('p')}", "no-invariant": f"m = {d.get('m')}, {by}",
            "good-reduction": f"p = {d.get('p')}"}.get(rule, "")


def strata(s, parameters, claim, leaves):
    """Of a certificate over strata; s: the Stratum of all admitted points; leaves: the lines of the tree."""
    names = [s.variable, *parameters]

    def show(f):
        return polynomial(f, names)
    kinds = {"C": [], "R": [], "Q": []}
    for i, x in enumerate(parameters):
        x_is = FIELD * (i + 1)
        kinds["Q" if x_is in s.rational else "R" if x_is in s.real else "C"].append(x)
    points = "; ".join(f"{', '.join(xs)} in {kind}" for kind, xs in kinds.items() if xs)
    given = [f"{show(f)} {RELATION[sign]}" for f, sign in s.conditions]
    given += [f"({show(a)})/({show(b)}) {'in' if integral else 'not in'} Z" for (a, b), integral in s.integers]
    given = ", ".join(dict.fromkeys(given))
    lines = ["for " + (f"all {points}" if points else "the equation") + " with " * bool(given) + given]
    groups = [group for group in s.groups if not any(f.constant() for f in group)]
    lines += dict.fromkeys("except where " + " = ".join(map(show, group)) + " = 0" for group in groups)
    if not s.den.variables() <= {0}:
        lines.append(f"except where {show(s.den)} = 0 for all {s.variable}")
    said = {True: "abelian", False: "not abelian", None: "on these strata:"}[claim]
    subject = "the identity component of the differential Galois group of"
    return lines + [f"{subject} {equation_text(show(s.num), show(s.den))} is {said}", *leaves]
