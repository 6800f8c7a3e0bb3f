"""Conditions on names, sets of points, and what is shown of a set: for strata of parameters (docs/theory/strata_certificates.md 3
to 5) and for theorems (docs/theory/theorem_certificates.md 2).

A point gives each name a complex number.  A condition is a pair, f a polynomial over Z in the names:
  (f, "zero"), (f, "nonzero")            f = 0, f != 0
  (f, "positive"), (f, "nonnegative")    the value of f is real, whatever its names are, and > 0, or >= 0
  (fs, "some")                           not all of these are 0
  ((f, g), True), ((f, g), False)        g != 0 and f/g is an integer; f/g is none, which does not say that it is real
What is accepted here holds at every point of the set; nothing is searched for."""
from copy import copy
from math import lcm

from certificate_format import need, read, right
from modular import is_prime, meval
from multivariate import P, constant, parse, plus, quotient, ratio, remove, spend, times

SIGNED = ("positive", "nonnegative")
NEGATED = {"positive": ("nonnegative", -1), "nonnegative": ("positive", -1), "nonzero": ("zero", 1), "zero": ("nonzero", 1),
           "some": ("zero", 1)}
BRANCHES = {"sign": (("positive", 1, "positive"), ("zero", 1, "zero"), ("negative", -1, "positive")),
            "zero": (("nonzero", 1, "nonzero"), ("zero", 1, "zero"))}
DEPTH, TERMS, ZEROS, BITS = 64, 1000, 200, 33220                # 10000 digits


def conditions(rows, poly):
    """[{"p": P, "sign": SIGN}, ...]; poly: reads P"""
    return [(poly(row["p"]), row["sign"]) for row in rows]


def vanishes(f, p):
    """Is f = 0 wherever p = 0?  Without p: everywhere?"""
    return not f or p is not None and quotient(f, p.primitive()) is not None


class ConditionSet:
    """The points at which all conditions hold.  names {name: variable}; real, rational: the variables with such a value at each
    point; conditions: equations and signs, integers, groups ("some"): the others, each by its number."""
    nodes = 0                                       # how many may still be looked at

    def __init__(self, names, real=None, rational=()):
        self.names, self.rational = names, frozenset(rational)
        self.real = frozenset(names.values()) if real is None else self.rational.union(real)
        self.conditions, self.integers, self.groups, self.divisors, self.new = [], [], [], [], []

    def also(self, *given, units=()):
        """The points of the set at which these conditions hold, too, and `units`, which have no number, are not 0"""
        s = copy(self)
        s.conditions = [*self.conditions, *given]
        s.new = [*self.new, *(f for f, says in given if says in ("positive", "nonzero")), *units]
        return s

    def poly(self, text):
        return parse(text, self.names)

    # -- without data

    def is_real(self, f):
        """Its names are, or a condition says so of a multiple by a number."""
        return f.variables() <= self.real or \
            any(says in SIGNED and ratio(f, g) is not None for g, says in self.conditions)

    def is_unit(self, f):
        """Is f 0 nowhere: a product of what is 0 nowhere, and of a number?"""
        return bool(f) and (f.constant() is not None or self.rest(f).constant() is not None)

    def rest(self, f):
        """f, not 0, divided by all that is 0 nowhere"""
        return remove(f.primitive(), *filter(None, self.units()))

    def units(self):
        """What is 0 nowhere, divided by each other in the order in which it came: so rest finds products of all of it.  If 0 is
        among it, there is no point."""
        for f in self.new:
            f = remove(f.primitive(), *filter(None, self.divisors)) if f else f
            old = self.divisors if f.constant() is not None else [remove(g, f) if g else g for g in self.divisors]
            self.divisors = [g for g in (*old, f) if not g or g.constant() is None]
        self.new = []
        return self.divisors

    def is_positive(self, f):
        """Is it a positive multiple of what a condition says to be > 0?"""
        c = f.constant()
        if c is not None:
            return c > 0
        return any(says == "positive" and (ratio(f, g) or 0) > 0 for g, says in self.conditions)

    # -- sums

    def condition(self, i, *signs):
        need(0 <= i < len(self.conditions), "there is no such condition")
        need(self.conditions[i][1] in signs, "the condition has another sign")
        return self.conditions[i][0]

    def total(self, terms, positive=False):
        """terms: (c, Q, [(i, e), ...]), c Q^2 prod f_i^e with numbers c > 0 and conditions f_i.  Their sum times k > 0, and k.  It
        is > 0 at every point; if `positive` is not asked for and there is one term, this need not be real, but is 0 nowhere."""
        k, total = 1, P()
        for c, *_ in terms:
            need(c > 0, "a factor is not positive")
            spend(k.bit_length() >> 6)
            k = lcm(k, c.denominator)
            need(max(k, c.numerator).bit_length() <= BITS, "a limit: the length of a number")
        for c, q, factors in terms:
            spend(10 * (2 + len(factors)))
            f = q * q
            for i, e in factors:
                f *= self.condition(i, *SIGNED, "nonzero")**e
            total += f * (c.numerator * (k // c.denominator))
        need(any(map(self.is_strict, sorted(terms, key=self.strict_by_division))), "no term is strict")
        need(len(terms) == 1 and not positive or all(map(self.has_sign, terms)), "a factor has no sign")
        return total, k

    def is_strict(self, term):
        """Is it 0 nowhere?"""
        given = [self.conditions[i] for i, _ in term[2]]
        return self.is_unit(term[1]) and all(says != "nonnegative" or self.is_unit(f) for f, says in given)

    def strict_by_division(self, term):
        """Does it take one to see that it is strict?  Terms of which it does are tried last."""
        return term[1].constant() is None or any(self.conditions[i][1] == "nonnegative" for i, _ in term[2])

    def has_sign(self, term):
        """Is it >= 0 everywhere?"""
        given = [(*self.conditions[i], e) for i, e in term[2]]
        return self.is_real(term[1]) and all(says in SIGNED or e % 2 == 0 and self.is_real(f) for f, says, e in given)

    # -- the set has no point

    def absent(self, v, part=None, depth=DEPTH):
        """Accepts a NODE that proves it; part: takes nodes of other kinds, with the set of their points."""
        ConditionSet.nodes -= 1
        need(ConditionSet.nodes >= 0 and depth > 0, "too many nodes")
        kind = read("text", v.get("node") if isinstance(v, dict) else None, "the kind of a node")
        if kind == "empty":
            return self.contradiction(read({"node": "text", "terms": ["any"], "zeros": [["int", "text"]]}, v, "empty"))
        if kind not in BRANCHES:
            right(part, "an unknown node")
            return part(v, self)
        d = read({"node": "text", "p": "text"} | {key: "any" for key, *_ in BRANCHES[kind]}, v, kind)
        f = self.poly(d["p"])
        need(kind != "sign" or self.is_real(f), "the sign of what need not be real")
        for key, c, says in BRANCHES[kind]:
            self.also((f * c, says)).absent(d[key], part, depth - 1)

    def contradiction(self, d):
        """sum of the TERMs + sum P f = 0"""
        right(len(d["terms"]) <= TERMS and len(d["zeros"]) <= ZEROS, "too many terms")
        terms, zeros = list(map(self.term, d["terms"])), [(i, self.poly(p)) for i, p in d["zeros"]]
        need(all(1 <= e <= 100 for *_, factors in terms for _, e in factors), "an exponent is out of range")
        total, k = self.total(terms)
        for i, f in zeros:
            total += f * self.condition(i, "zero") * k
        need(not total, "the sum is not 0")

    def term(self, v):
        """[c, Q, [i, e], ...]"""
        right(isinstance(v, list) and len(v) >= 2, "a term is expected")
        c, q, *rows = v
        return read("rational", c, "a number"), self.poly(read("text", q, "a polynomial")), read([["int", "int"]], rows, "factors")

    def show(self, f, says, v):
        """The condition holds, as a NODE proves that its negation holds nowhere; that of a sign is one only for what is real."""
        need(says not in SIGNED or self.is_real(f), "the sign of what need not be real")
        other, c = NEGATED[says]
        self.also(*((g * c, other) for g in (f if says == "some" else [f]))).absent(v)

    def need_no_rational_root(self, p, q):
        """p is 0 nowhere: modulo q it has no root, where the denominator of a rational one has an inverse."""
        xs = p.variables()
        need(len(xs) == 1 and xs <= self.rational, "not a polynomial in one rational parameter")
        need(2 <= q < 10000 and is_prime(q), "not a prime below 10000")
        row = [c.constant() % q for c in p.coefficients(min(xs))]
        spend(q * len(row))
        need(row[-1] and all(meval(row, x, q) for x in range(q)), "a root modulo the prime")

    # -- integers

    def integer(self, i):
        need(0 <= i < len(self.integers), "no such membership")
        return self.integers[i]

    def need_violated(self, i, c, p):
        """Where p = 0, membership i would have the value c, which it has not."""
        (num, den), integral = self.integer(i)
        need((c.denominator == 1) != integral, "the membership allows this value")
        need(vanishes(num * c.denominator - den * c.numerator, p), "the membership has another value there")

    def show_integer(self, v, integral, m, i, rest):
        """v is an integer: m w + s - v is one, w that of membership i, s a sum of multiples (n, j) of integers.  Or v is none: m v + s
        differs from w, which is none, by an integer, or from the integer w by what is none."""
        need(all(abs(n) <= 10**6 for n, _ in [(m, i), *rest]), "too large a multiple")
        w, w_is = self.integer(i)
        need(self.is_unit(v[1]), "a denominator may vanish")
        need(w_is or not integral, "the membership says something else")
        left, right = (times(w, m), v) if integral else (times(v, m), w)
        for n, j in rest:
            f, is_integer = self.integer(j)
            need(is_integer, "a membership of the sum is none of integers")
            left = plus(left, f, n)
        c = constant(plus(left, right, -1))
        need(c is not None and (c.denominator == 1) == (integral or not w_is), "nothing follows from the memberships")

    # -- equations

    def solve(self, p, name):
        """Where p = l x + m is 0, l a unit: the set without x; put(f, n): l^n f at x = -m/l, n the degree of f in x at least"""
        need(name in self.names and p.degree(x := self.names[name]) == 1, f"p is not linear in {name[:60]}")
        (m, l), s, others, learned = p.coefficients(x), copy(self), p.variables() - {x}, set()
        need(self.is_unit(l), "the coefficient may vanish")

        def put(f, n=0):
            return f.substitute(x, l, m, max(n, f.degree(x), 0))
        s.names = {key: v for key, v in self.names.items() if v != x}
        s.conditions, s.divisors, s.new = [], [], [put(f) for f in (*self.units(), l)]
        for f, says in self.conditions:
            n = f.degree(x)
            if says in SIGNED and n > 0:            # l^2 > 0
                n, says = n + n % 2, says if self.is_real(l) else "dropped"
            s.conditions.append((put(f, n), says))
        s.integers = [(tuple(put(f, max(g.degree(x) for g in pair)) for f in pair), integral) for pair, integral in self.integers]
        s.groups = [[put(f) for f in group] for group in self.groups]
        if len(others) == 1 and p.degree(u := min(others)) == 1:
            (c, a), (d, b) = (f.coefficients(u) + [P()] * (1 - f.degree(u)) for f in (l, m))
            if a * d != b * c:                      # p = (a x + b) u + c x + d, of rank 2: u is a real fraction of x
                learned = {u}
        s.real, s.rational = ((f | learned if x in f else f) - {x} for f in (self.real, self.rational))
        return s, put
