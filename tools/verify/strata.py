"""Checks certificates over strata, kovacic-strata/1 (docs/theory/strata_certificates.md; (1) to (7) are its sections).

Nothing is searched for: the tree covers all values of the parameters by construction, a node changes the state as (3)
to (5) say, and a leaf (strata_leaves.py) is recomputed from the state and its own data.  multivariate.py has the
polynomials; z is variable 0."""
from collections import Counter

import checked
import statement
from certificate_format import COND, NAME, need, read, refusing, right
from condition import conditions, vanishes
from exact import ZERO, K, Poly
from first_integrals import Denial, denial, falls
from multivariate import FIELD, MASK, quotient, remove, spend
from statement import RELATION, SAID, polynomial, quoted
from strata_classical import Classical
from strata_leaves import Leaf
from stratum import Stratum, Z, invariant

FORMAT = "kovacic-strata/1"
FRACTION = {"num": "text", "den": "text"}
TOP = {"format": "text", "variable": "text", "parameters": ["text"], "real": ["text"], "rational?": ["text"],
       "assumptions": [COND], "generic": [["text"]], "r": FRACTION,
       "memberships?": [FRACTION | {"integral": "truth"}],
       "claim": {"abelian": "any"}, "tree": "any"}
VIOLATED = {"membership?": "natural", "value?": "rational"}
LEMMA = VIOLATED | {"p": "text", "times?": "text", "sign": ("positive", "nonzero"), "terms?": ["any"], "prime?": "int"}
REGULAR = {"chi?": ["text"], "irrational?": "text", "log?": "true", "bound?": "rational"}
PLACED = {"content": "text", "places": [REGULAR | {"q": "text", "order": "int"}], "infinity": REGULAR,
          "absent?": [{"m": "int", "minors": [{"rows": ["natural"], "times": "text"}], "prime?": "int"}],
          "growth?": {"factor": "rational", "shift": "rational"}}
FACTOR = {"q": "text", "order": "int", "e": "int"}
LEAVES = {"number": {"certificate": "any"},
          "invariant": {"content": "text", "places": [FACTOR], "m": "int", "p": "text"}}
LEAVES |= dict.fromkeys(("torus-log", "torus", "irreducible-log", "rational", "one-open", "open", "separated"), PLACED)
NUMBER = {"square": FRACTION, "root?": FRACTION}
MULTIPLE = {"times": "int", "membership": "natural"}
CLASSICAL = {"change": FRACTION, "equation": FRACTION, "factors?": ["text"], "numbers": [NUMBER],
             "shown?": [{"value": FRACTION, "integral": "truth", "with?": [MULTIPLE]} | MULTIPLE]}
CRITERIA = ("whittaker", "bessel", "riemann", "lame")
LEAVES |= dict.fromkeys(CRITERIA, CLASSICAL)
ENDS = {"empty": VIOLATED | {"terms?": ["any"]}, "outside": {"generic?": "natural"}, "open": {"reason": "text"},
        "trusted": {"abelian": ("yes", "no", "empty"), "theorem": "text", "statement": "text"}}
NODES = ENDS | {"split": {"p": "text", "nonzero": "any", "zero": "any"},
                "assumed": {"condition": "natural", "p": "text", "zero": "any"},
                "lemmas": {"lemmas": [LEMMA], "then": "any"}, "leaf": {"abelian": ("yes", "no", "where"), "by": LEAVES}}
ZEROS = ENDS | {"solve": {"variable": "text", "r?": FRACTION, "then": "any"},
                "root": {"variable": "text", "certificate": "any", "abelian": ("yes", "no")}}


class Tree:
    """Walks through the nodes (4); counts leaves and trusted steps.  path: the conditions of a node, as text; lines:
    what is said of each leaf (8); denials: of each that says "not abelian"; criteria: pairs of one and a difference, of each that
    says "where"."""

    def __init__(self, prove, names):
        self.prove, self.leaves, self.nodes, self.trust = prove, Counter(), 0, 0
        self.names, self.path, self.way, self.lines, self.denials, self.criteria = names, [], [], [], [], []

    def say(self, said, words, by, denial=Denial(), rule=None):
        """What is said of a leaf, and by what; rule: where checked.py keeps it"""
        where = f"{', '.join(self.path) or 'always'}: {words}"
        self.leaves[said] += 1
        self.lines.append(f"  {where} ({by})")
        if said == "no":
            self.denials.append(denial._replace(path=tuple(self.way)))
        if rule:
            checked.add(FORMAT, *rule, found=where)

    def walk(self, s, v, depth, p=None):
        """A NODE; or a ZERO, of the points of s with p = 0"""
        self.nodes += 1
        need(self.nodes <= 10000 and depth <= 64, "the tree is too large")
        key, table = ("node", NODES) if p is None else ("zero", ZEROS)
        name = v.get(key) if isinstance(v, dict) else None
        right(isinstance(name, str) and name in table, f"{key!r} is unknown: {str(name)[:60]!r}")
        getattr(self, name)(s, read(table[name] | {key: "text"}, v, name), p, depth)

    def below(self, s, p, text, sign, v, depth):
        """A child, of the points of s with p = 0, or p != 0; text: of p, as it is given"""
        self.path.append(f"{polynomial(p, self.names)} {RELATION[sign]}")
        self.way.append((text, sign))
        self.walk(s, v, depth + 1, p if sign == "zero" else None)
        self.path.pop()
        self.way.pop()

    def split(self, s, d, _, depth):
        p = s.poly(d["p"])
        need(p.constant() is None, "a split needs a polynomial that is not constant")
        self.below(s.also(units=[p]), p, d["p"], "nonzero", d["nonzero"], depth)
        self.below(s, p, d["p"], "zero", d["zero"], depth)

    def assumed(self, s, d, _, depth):
        f, p = s.condition(d["condition"], "zero"), s.poly(d["p"])
        need(f and p.constant() is None, "nothing follows from 0 = 0, or for a constant")
        left = quotient(s.rest(f), p.primitive())
        follows = left is not None and remove(left, p.primitive()).constant() is not None
        need(follows, "p = 0 does not follow from the condition")
        self.below(s, p, d["p"], "zero", d["zero"], depth)

    def solve(self, s, d, p, depth):
        right(d["variable"] in self.names[1:], "a parameter is expected")
        self.walk(s.solve(p, d["variable"], d["r"]), d["then"], depth + 1)

    def lemmas(self, s, d, _, depth):
        """What is proved here (5) is known below."""
        for lemma in d["lemmas"]:
            s = s.lemma(lemma)
        self.walk(s, d["then"], depth + 1)

    def empty(self, s, d, p, _):
        """No points (4): a violated membership, a positive sum that is 0 wherever p is, or what is plain."""
        if d["membership"] is not None or d["value"] is not None:
            right(None not in (d["membership"], d["value"]) and d["terms"] is None, "nothing shows it, or too much")
            s.need_violated(d["membership"], d["value"], p)
        elif d["terms"] is not None:
            need(vanishes(s.sum_of(d["terms"])[0], p), "no contradiction")
        else:
            zeros = [f for f, says in s.conditions if says == "zero"] + ([] if p is None else [p])
            need(not all(s.units()) or any(map(s.is_unit, zeros)), "no contradiction")
        self.leaves["empty"] += 1

    def outside(self, s, d, p, _):
        i = d["generic"]
        need(i is None or i < len(s.groups), "no such group")
        group = s.groups[i] if i is not None else s.den.coefficients(Z) if s.den else []
        need(all(vanishes(f, p) for f in group), "these points are not outside")
        self.leaves["outside"] += 1

    def open(self, s, d, *_):
        self.say("open", "undecided", quoted(d["reason"]))

    def trusted(self, s, d, *_):
        self.trust += 1
        by = f"trusted, {quoted(d['theorem'])}: {quoted(d['statement'])}"
        self.say(d["abelian"], SAID[d["abelian"]], by, Denial(trust=1))

    def leaf(self, s, d, *_):
        need(s.den, "r is not defined here")
        if d["by"] == "number":
            need(s.num.variables() | s.den.variables() <= {Z}, "r depends on parameters")
            num, den = self.nested(d, "by", "number")
            need(K.d == 1, "the certificate is not over Q")
            same_equation(s, FIELD, [Poly([1])], num, den)
        elif d["by"] == "invariant":
            right(d["abelian"] == "yes", "an invariant proves abelian")
            invariant(s, d)
            self.say("yes", "abelian", "invariant", rule=("by", "invariant"))
        elif d["by"] in CRITERIA:
            self.classical(Classical(s, d), d)
        else:
            right(d["abelian"] == "no", "the places prove not abelian")
            leaf = Leaf(s, d)
            leaf.prove()
            regular = all(x.order <= 2 for x in leaf.local.finite) and falls(s.num.degree(Z), s.den.degree(Z))
            self.say("no", "not abelian", d["by"], Denial(regular), ("by", d["by"]))

    def classical(self, leaf, d):
        """Everywhere, nowhere, or exactly where a criterion holds."""
        said = d["abelian"]
        need(said == "where" or said == leaf.verdict(), "the criterion is not shown to say that")
        if said == "where":                 # what is pulled back from Riemann's equation is regular
            self.criteria.append((Denial(leaf.by == "riemann", path=tuple(self.way)), leaf.one_difference(self.names)))
        words = f"abelian exactly where {leaf.criterion(self.names)}" if said == "where" else SAID[said]
        self.say(said, words, leaf.by, rule=("by", leaf.by))

    def nested(self, d, *rule):
        """num and den of an ordinary certificate; the field K is set to its own."""
        num, den, claim, trusted, _ = self.prove(d["certificate"])
        right(d["abelian"] != "where", "yes or no is expected")
        need(claim.get("abelian") is (d["abelian"] == "yes"), "the certificate claims something else")
        self.trust += trusted
        by = rule[1] + f", {trusted} trusted" * bool(trusted)
        self.say(d["abelian"], SAID[d["abelian"]], by, d["abelian"] == "no" and denial(num, den, claim, trusted), rule)
        return num, den

    def root(self, s, d, p, _):
        """All roots of p: one equation over Q[x]/(p) (4, `root`)."""
        right(d["variable"] in self.names[1:], "a parameter is expected")
        x = s.names.get(d["variable"])
        need(s.den and p.variables() == {x}, "p has not just this variable, or r is not defined")
        need(s.num.variables() | s.den.variables() <= {Z, x}, "r depends on another parameter")
        *low, c = (f.constant() for f in p.coefficients(x))
        num, den = self.nested(d, "zero", "root")
        need(len(low) == K.d >= 2, "the field has another degree")
        need(K.m == [v * c**(K.d - 1 - i) for i, v in enumerate(low)] + [1], "the field belongs to another polynomial")
        n = max(s.num.degree(x), s.den.degree(x))
        spend(n * n * K.d**2 * (p.bits() // 64 + 1))
        powers = [Poly([1])]                # (a/c)^k c^n = a^k c^(n - k)
        for _ in range(n):
            powers.append(powers[-1] * Poly([0, 1]))
        same_equation(s, x, [f * c**(n - k) for k, f in enumerate(powers)], num, den)


def same_equation(s, x, powers, num, den):
    top, bottom = over_field(s.num, x, powers), over_field(s.den, x, powers)
    spend(len(top.c) * len(den.c) + len(num.c) * len(bottom.c))
    need(bottom.c and top * den == num * bottom, "the certificate is about another equation")


def over_field(f, x, powers):
    """f with x^k replaced by powers[k], as a polynomial in z over K"""
    spend(len(powers) * (len(f) * K.d + 20) * (1 + powers[-1].bits() // 64))
    blocks = (sum((powers[k >> x & MASK] * c for k, c in row.items()), ZERO).c for row in f.coefficients(Z))
    return Poly([v for block in blocks for v in block + [0] * (K.s - len(block))])


def verify(top, prove, _=False):
    """The number of trusted steps, a summary and the statement; prove checks ordinary certificates."""
    tree, *said = accept(top, prove)
    return tree.trust, *said


@checked.file()
def accept(top, prove):
    """The tree, a summary and the statement.  Raises Malformed or Rejected."""
    top = read(TOP, top, "certificate")
    variable, parameters, real, claim = top["variable"], top["parameters"], top["real"], top["claim"]["abelian"]
    names = [variable, *parameters]
    right(all(map(NAME.match, names)) and len(set(names)) == len(names) and len(parameters) <= 12,
          "a variable and at most 12 parameters with different names are expected")
    rational, memberships = top["rational"] or [], top["memberships"] or []
    right(all(set(v) <= set(parameters) and len(set(v)) == len(v) for v in (real, rational)) and all(top["generic"]),
          "real, rational: different parameters; generic: groups with something in them")
    right(claim in (True, False, None), "the claim is true, false or null")
    with refusing():
        shifts = {x: FIELD * (i + 1) for i, x in enumerate(parameters)}
        s = Stratum(variable, shifts, {shifts[x] for x in real}, {shifts[x] for x in rational}, **top["r"])
        tree = Tree(prove, names)
        need(s.den, "the denominator is 0")
        s = s.also(*conditions(top["assumptions"], s.poly))
        for x in memberships:
            s.integers.append(((s.poly(x["num"]), s.poly(x["den"])), x["integral"]))
            s = s.also(units=[s.poly(x["den"])])
        s.groups = [[s.poly(f) for f in group] for group in top["generic"]]
        tree.walk(s, top["tree"], 1)
    others = {"yes", "no", "where", "open"} & set(tree.leaves) - {"yes" if claim else "no"}
    need(claim is None or not others, "the claim does not follow")
    words = {"yes": "abelian", "no": "not abelian", "where": "by a criterion", "open": "undecided"}
    # strata without points are left out
    counts = ", ".join(f"{tree.leaves[k]} {word}" for k, word in words.items() if tree.leaves[k])
    total = sum(tree.leaves[k] for k in words)
    summary = f"{total} {'stratum' if total == 1 else 'strata'}{': ' * bool(counts)}{counts}; "
    checked.conclude((), "parameters with the conditions of the statement, without its exceptions" +
                     "; undecided where it says so" * bool(tree.leaves["open"]))
    return tree, summary, statement.strata(s, parameters, claim, tree.lines)
