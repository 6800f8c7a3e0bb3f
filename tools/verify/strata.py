"""Checks certificates over strata, kovacic-strata/1 (docs/theory/strata_certificates.md; (1) to (7) are its sections).

Nothing is searched for: the tree covers all values of the parameters by construction, a node changes the state as (3)
to (5) say, and a leaf (strata_leaves.py) is recomputed from the state and its own data.  multivariate.py has the
polynomials; z is variable 0."""
import re
from collections import Counter
from copy import copy
from math import lcm

from certificate_format import Malformed, Rejected, need, read
from exact import ZERO, K, Poly
from multivariate import FIELD, MASK, P, Work, parse, product, quotient, ratio, remove, spend
from strata_leaves import Leaf, Z, invariant

FORMAT = "kovacic-strata/1"
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")
FRACTION = {"num": "text", "den": "text"}
TOP = {"format": "text", "variable": "text", "parameters": ["text"], "real": ["text"],
       "assumptions": [{"p": "text", "sign": "text"}], "generic": [["text"]], "r": FRACTION,
       "claim": {"abelian": "any"}, "tree": "any"}
LEMMA = {"p": "text", "times?": "text", "sign": "text", "terms?": ["any"]}
REGULAR = {"chi?": ["text"], "irrational?": "text", "log?": "truth", "bound?": "rational"}
PLACED = {"content": "text", "places": [REGULAR | {"q": "text", "order": "int"}], "infinity": REGULAR,
          "absent?": [{"m": "int", "minors": [{"rows": ["int"], "times": "text"}], "prime?": "int"}]}
FACTOR = {"q": "text", "order": "int", "e": "int"}
LEAVES = {"number": {"certificate": "any"},
          "invariant": {"content": "text", "places": [FACTOR], "m": "int", "p": "text"}}
LEAVES |= dict.fromkeys(("torus-log", "torus", "irreducible-log", "rational", "one-open", "open"), PLACED)
ENDS = {"empty": {"terms?": ["any"]}, "outside": {"generic?": "int"}, "open": {"reason": "text"},
        "trusted": {"abelian": "text", "theorem": "text", "statement": "text"}}
NODES = ENDS | {"split": {"p": "text", "nonzero": "any", "zero": "any"},
                "assumed": {"condition": "int", "p": "text", "zero": "any"},
                "lemmas": {"lemmas": [LEMMA], "then": "any"}, "leaf": {"abelian": "text", "by": LEAVES}}
ZEROS = ENDS | {"solve": {"variable": "text", "r?": FRACTION, "then": "any"},
                "root": {"variable": "text", "certificate": "any", "abelian": "text"}}


def choose(table, key, v):
    """The name of the variant, and its data."""
    name = v.get(key) if isinstance(v, dict) else None
    if not isinstance(name, str) or name not in table:
        raise Malformed(f"{key!r} is unknown: {str(name)[:60]!r}")
    return name, read(table[name] | {key: "text"}, v, name)


class Stratum:
    """The state at a node (3).  names {name: variable} and real: of the parameters that are left; conditions: pairs
    (f, sign); members: what vanishes nowhere; groups: `generic`; num and den: None if den became 0.  Where den vanishes
    identically in z that of the certificate does: fraction."""

    def __init__(self, variable, names, real, num, den):
        self.variable, self.names, self.real = variable, names, real
        self.conditions, self.members, self.groups = [], [], []
        self.num, self.den = self.poly(num, True), self.poly(den, True)

    def poly(self, text, z=False):
        return parse(text, self.names | {self.variable: Z} if z else self.names)

    def copy(self):
        s = copy(self)
        s.names, s.real, s.conditions, s.members = s.names.copy(), s.real.copy(), s.conditions[:], s.members[:]
        return s

    def assume(self, f, sign):
        self.conditions.append((f, sign))
        if sign in ("positive", "nonzero"):
            self.add(f)

    def rest(self, f):
        """f, not 0, divided by all members"""
        f = f.primitive()
        for g in self.members:
            f = remove(f, g) if g else f
        return f

    def add(self, f):
        """A new member; it and the old ones are divided by each other: so rest finds products of all that was added."""
        f = self.rest(f) if f else f
        old = self.members if f.constant() is not None else [remove(g, f) if g else g for g in self.members]
        self.members = [g for g in (*old, f) if not g or g.constant() is None]

    def is_nonzero(self, f):
        return bool(f) and self.rest(f).constant() is not None

    def is_positive(self, f):
        c = f.constant()
        if c is not None:
            return c > 0
        return any(sign == "positive" and g and (ratio(f, g) or 0) > 0 for g, sign in self.conditions)

    def condition(self, i, *signs):
        need(0 <= i < len(self.conditions), "no such condition")
        need(self.conditions[i][1] in signs, "the condition has another sign")
        return self.conditions[i][0]

    def total(self, terms):
        """The sum of the terms times k, k > 0, and whether one is positive (5)."""
        total, k, positive = P(), 1, False
        for term in terms:
            if not isinstance(term, list) or not term:
                raise Malformed("a term is an array")
            c, factors = read("rational", term[0], "a term"), [self.factor(v) for v in term[1:]]
            need(c > 0, "a term has no positive coefficient")
            scale = lcm(k, c.denominator)
            total = total * (scale // k) + product(f for f, _ in factors) * int(c * scale)
            k, positive = scale, positive or all(sure for _, sure in factors)
        return total, k, positive

    def factor(self, v):
        """A factor >= 0, and whether it is > 0."""
        kind, what, e = read(["text"], v, "a factor") if isinstance(v, list) and len(v) == 3 else (None, "", "")
        e = read("int", e, "a factor")
        need(1 <= e < 10000, "a power out of range")
        if kind == "condition":
            f = self.condition(i := read("int", what, "a factor"), "positive", "nonnegative")
            return f**e, self.conditions[i][1] == "positive" or self.is_nonzero(f)
        f = self.poly(what)
        need(kind == "square" and f.variables() <= self.real, "not the square of something real")
        return f**(2 * e), self.is_nonzero(f)

    def solve(self, p, name, r):
        """The stratum p = 0, by p = l x + m (4, `solve`)."""
        need(name in self.names and p.degree(x := self.names[name]) == 1, f"p is not linear in {name[:60]}")
        (m, l), s, others = p.coefficients(x), self.copy(), p.variables() - {x}
        need(self.is_nonzero(l), "the coefficient may vanish")
        s.members, s.conditions, s.real = [], [], self.real - {x}

        def starred(f, n=0):
            return f.substitute(x, l, m, max(n, f.degree(x), 0))
        for f in (*self.members, l):
            s.add(starred(f))
        for f, sign in self.conditions:
            n = f.degree(x)
            if sign in ("positive", "nonnegative") and n > 0 and not l.variables() <= self.real:
                sign = "dropped"            # positive: f* is among the members already
            s.conditions.append((starred(f, n + n % 2 if sign in ("positive", "nonnegative") and n > 0 else n), sign))
        s.groups = [[starred(f) for f in group] for group in self.groups]
        if x in self.real and len(others) == 1 and not others & self.real and p.degree(u := min(others)) == 1:
            (b, a), (d, c) = (f.coefficients(u) + [P()] * (1 - f.degree(u)) for f in (l, m))
            if a * c != b * d:              # p = (a x + c') u + ...: u is a real fraction of x
                s.real.add(u)
        del s.names[name]
        s.fraction(starred, max(self.num.degree(x), self.den.degree(x)) if self.den else 0, r)
        return s

    def fraction(self, starred, n, r):
        num, den = (starred(self.num, n), starred(self.den, n)) if self.den else (None, None)
        need(bool(den) == (r is not None), "r must be given if its denominator is not 0, and only then")
        self.num, self.den = (self.poly(r["num"], True), self.poly(r["den"], True)) if r else (None, None)
        need(not r or self.den and self.num * den == num * self.den, "r is not what it becomes where p = 0")
        need(not r or vanishes(den, self.den), "the denominator vanishes where it did not")


class Tree:
    """Walks through the nodes (4); counts leaves and trusted steps."""

    def __init__(self, prove):
        self.prove, self.leaves, self.nodes, self.trust = prove, Counter(), 0, 0

    def count(self, depth):
        self.nodes += 1
        need(self.nodes <= 10000 and depth <= 64, "the tree is too large")

    def node(self, s, v, depth):
        self.count(depth)
        name, d = choose(NODES, "node", v)
        if name in ENDS:
            return getattr(self, name)(s, d)
        return getattr(self, name)(s, d, depth)

    def zero(self, s, p, v, depth):
        self.count(depth)
        name, d = choose(ZEROS, "zero", v)
        if name == "solve":
            self.node(s.solve(p, d["variable"], d["r"]), d["then"], depth + 1)
        elif name == "root":
            self.root(s, p, d)
        else:
            getattr(self, name)(s, d, p)

    def split(self, s, d, depth):
        p, t = s.poly(d["p"]), s.copy()
        need(p.constant() is None, "a split needs a polynomial that is not constant")
        t.add(p)
        self.node(t, d["nonzero"], depth + 1)
        self.zero(s, p, d["zero"], depth + 1)

    def assumed(self, s, d, depth):
        f, p = s.condition(d["condition"], "zero"), s.poly(d["p"])
        need(f and p.constant() is None, "nothing follows from 0 = 0, or for a constant")
        left = quotient(s.rest(f), p.primitive())
        follows = left is not None and remove(left, p.primitive()).constant() is not None
        need(follows, "p = 0 does not follow from the condition")
        self.zero(s, p, d["zero"], depth + 1)

    def lemmas(self, s, d, depth):
        """Signs, by sums of squares and known signs (5)."""
        s = s.copy()
        for lemma in d["lemmas"]:
            p, times, sign = s.poly(lemma["p"]), s.poly(lemma["times"] or "1"), lemma["sign"]
            if lemma["terms"] is None:
                need(lemma["times"], "a lemma without terms needs times")
                need(sign == "nonzero" and s.is_nonzero(p * times), "p times its factor is not known")
            else:
                total, k, positive = s.total(lemma["terms"])
                need(positive and p * times * k == total, "the terms do not prove the lemma")
            need(sign == "nonzero" or sign == "positive" and s.is_positive(times), "the lemma does not have this sign")
            s.assume(p, sign) if sign == "positive" else s.add(p)
        self.node(s, d["then"], depth + 1)

    def empty(self, s, d, p=None):
        if d["terms"] is not None:          # a positive sum that is 0 wherever p is
            total, _, positive = s.total(d["terms"])
            need(positive and vanishes(total, p), "no contradiction")
        else:
            zeros = [f for f, sign in s.conditions if sign == "zero"] + ([] if p is None else [p])
            need(not all(s.members) or any(map(s.is_nonzero, zeros)), "no contradiction")
        self.leaves["empty"] += 1

    def outside(self, s, d, p=None):
        i = d["generic"]
        need(i is None or 0 <= i < len(s.groups), "no such group")
        group = s.groups[i] if i is not None else s.den.coefficients(Z) if s.den else []
        need(all(vanishes(f, p) for f in group), "these points are not outside")
        self.leaves["outside"] += 1

    def open(self, s, d, p=None):
        self.leaves["open"] += 1

    def trusted(self, s, d, p=None):
        need(d["abelian"] in ("yes", "no", "empty"), "yes, no or empty is expected")
        self.trust += 1
        self.leaves[d["abelian"]] += 1

    def leaf(self, s, d, _):
        need(s.den, "r is not defined here")
        if d["by"] == "number":
            need(s.num.variables() | s.den.variables() <= {Z}, "r depends on parameters")
            num, den = self.nested(d)
            need(K.d == 1, "the certificate is not over Q")
            same_equation(s, FIELD, [Poly([1])], num, den)
        elif d["by"] == "invariant":
            self.leaves["yes"] += 1
            need(d["abelian"] == "yes", "an invariant proves abelian")
            invariant(s, d)
        else:
            self.leaves["no"] += 1
            need(d["abelian"] == "no", "the places prove not abelian")
            Leaf(s, d).prove()

    def nested(self, d):
        """num and den of an ordinary certificate; the field K is set to its own."""
        trusted, num, den, abelian = self.prove(d["certificate"])
        need(d["abelian"] in ("yes", "no"), "yes or no is expected")
        need(abelian is (d["abelian"] == "yes"), "the certificate claims something else")
        self.trust += trusted
        self.leaves[d["abelian"]] += 1
        return num, den

    def root(self, s, p, d):
        """All roots of p: one equation over Q[x]/(p) (4, `root`)."""
        x = s.names.get(d["variable"])
        need(s.den and p.variables() == {x}, "p has not just this variable, or r is not defined")
        need(s.num.variables() | s.den.variables() <= {Z, x}, "r depends on another parameter")
        *low, c = (f.constant() for f in p.coefficients(x))
        num, den = self.nested(d)
        need(len(low) == K.d >= 2, "the field has another degree")
        need(K.m == [v * c**(K.d - 1 - i) for i, v in enumerate(low)] + [1], "the field belongs to another polynomial")
        n = max(s.num.degree(x), s.den.degree(x))
        spend(n * n * K.d**2 * (p.bits() // 64 + 1))
        powers = [Poly([1])]                # (a/c)^k c^n = a^k c^(n - k)
        for _ in range(n):
            powers.append(powers[-1] * Poly([0, 1]))
        same_equation(s, x, [f * c**(n - k) for k, f in enumerate(powers)], num, den)


def vanishes(f, p):
    """Is f = 0 wherever p = 0?  Without p: everywhere?"""
    return not f or p is not None and quotient(f, p.primitive()) is not None


def same_equation(s, x, powers, num, den):
    top, bottom = over_field(s.num, x, powers), over_field(s.den, x, powers)
    spend(len(top.c) * len(den.c) + len(num.c) * len(bottom.c))
    need(bottom.c and top * den == num * bottom, "the certificate is about another equation")


def over_field(f, x, powers):
    """f with x^k replaced by powers[k], as a polynomial in z over K"""
    spend(len(powers) * (len(f) * K.d + 20) * (1 + powers[-1].bits() // 64))
    blocks = (sum((powers[k >> x & MASK] * c for k, c in row.items()), ZERO).c for row in f.coefficients(Z))
    return Poly([v for block in blocks for v in block + [0] * (K.s - len(block))])


def verify(top, prove):
    """The number of trusted steps and a summary; prove checks ordinary certificates.  Raises Malformed or Rejected."""
    top, Work.left = read(TOP, top, "certificate"), 4 * 10**7
    variable, parameters, real, claim = top["variable"], top["parameters"], top["real"], top["claim"]["abelian"]
    names = [variable, *parameters]
    if not all(map(NAME.match, names)) or len(set(names)) < len(names) or len(parameters) > 12:
        raise Malformed("a variable and at most 12 parameters with different names are expected")
    if not set(real) <= set(parameters) or len(set(real)) < len(real) or not all(top["generic"]):
        raise Malformed("real: different parameters; generic: groups with something in them")
    if claim not in (True, False, None):
        raise Malformed("the claim is true, false or null")
    try:
        shifts = {x: FIELD * (i + 1) for i, x in enumerate(parameters)}
        s, tree = Stratum(variable, shifts, {shifts[x] for x in real}, **top["r"]), Tree(prove)
        need(s.den, "the denominator is 0")
        for x in top["assumptions"]:
            need(x["sign"] in ("positive", "nonnegative", "nonzero", "zero"), "an unknown sign")
            s.assume(s.poly(x["p"]), x["sign"])
        s.groups = [[s.poly(f) for f in group] for group in top["generic"]]
        tree.node(s, top["tree"], 1)
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as why:
        raise Rejected(f"{type(why).__name__}: {why}") from None
    others = {"yes", "no", "open"} & set(tree.leaves) - {"yes" if claim else "no"}
    need(claim is None or not others, "the claim does not follow")
    words = {"yes": "abelian", "no": "not abelian", "open": "undecided"}        # strata without points are left out
    counts = ", ".join(f"{tree.leaves[k]} {word}" for k, word in words.items() if tree.leaves[k])
    total = sum(tree.leaves[k] for k in words)
    return tree.trust, f"{total} {'stratum' if total == 1 else 'strata'}{': ' * bool(counts)}{counts}; "
