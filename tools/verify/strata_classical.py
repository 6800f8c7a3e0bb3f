"""Leaves that rest on the closed criterion of a classical equation (docs/theory/strata_certificates.md 7.8): Whittaker,
Bessel, Riemann and Lame after a change of variable.  s is the state at the leaf, a Stratum of stratum.py; a fraction is
a pair (num, den) of polynomials."""
from fractions import Fraction
from itertools import product as pairs

from certificate_format import need, right
from exact import exact_sqrt
from multivariate import ONE, constant, plus, product, quotient, resultant, times
from statement import polynomial
from stratum import Z, has_differences

HALF = Fraction(1, 2)


class Number:
    """Known by its square: a root that is a function, or irrational everywhere."""

    def __init__(self, s, d, pair):
        self.square, self.root = pair(d["square"]), d["root"] and pair(d["root"])
        if self.root:
            need(equal(tuple(f * f for f in self.root), self.square), "the root has another square")
        c = constant(self.square)
        self.value = exact_sqrt(c) if c is not None else None
        self.irrational = c is not None and self.value is None
        if self.value is not None:
            self.root = ONE * self.value.numerator, ONE * self.value.denominator
        self.rational = bool(self.root) and (self.root[0].variables() | self.root[1].variables()) <= s.rational


def equal(f, g):
    return f[0] * g[1] == g[0] * f[1]


class Classical:
    """The equation (7.8) and its numbers; verdict: what the criterion says everywhere, "yes", "no" or None."""

    def __init__(self, s, d):
        self.s, self.by = s, d["by"]
        self.num, self.den = (s.poly(d["equation"][k], True) for k in ("num", "den"))
        self.factors = [s.poly(q, True) for q in d["factors"] or []]
        right(len(d["numbers"]) == 2 if self.by == "whittaker" else d["numbers"], "these are not the numbers of the family")
        # no family has more; before anything is expanded
        need(self.num.degree(Z) <= 4 and self.den.degree(Z) <= 6, "the equation is not that of the family")
        need(len(d["shown"] or []) <= 1000, "a limit: the number of integers shown")
        need(sum(len(x["with"] or []) for x in d["shown"] or []) <= 1000, "a limit: the number of memberships")
        self.numbers = [Number(s, x, self.pair) for x in d["numbers"]]
        self.change(*(s.poly(d["change"][k], True) for k in ("num", "den")))
        if self.by in ("whittaker", "bessel"):
            self.confluent(self.by == "whittaker")
        else:
            self.places(self.by == "lame")
        self.shown = [self.show(x) for x in d["shown"] or []]

    def pair(self, d):
        f = tuple(self.s.poly(d[k]) for k in ("num", "den"))
        need(self.s.is_unit(f[1]), "a denominator may vanish")
        return f

    def change(self, p, q):
        """r = f'^2 equation(f) - S(f)/2 for f = p/q, f' = W/q^2, f''/f' = U/(W q)."""
        W = p.diff(Z) * q - p * q.diff(Z)
        need(any(map(self.s.is_unit, W.coefficients(Z))), "the change of variable may be constant")
        U, Wq = W.diff(Z) * q - W * q.diff(Z) * 2, W * q
        schwarz = (U.diff(Z) * Wq - U * Wq.diff(Z)) * 2 - U * U
        n = max(self.num.degree(Z), self.den.degree(Z))
        top, bottom = (f.substitute(Z, q, p * -1, n) if f else f for f in (self.num, self.den))
        r = W * W * W * W * top * 4 - q * q * bottom * schwarz, W * W * q * q * q * q * bottom * 4
        need(equal((self.s.num, self.s.den), r), "the change of variable gives another equation")

    def confluent(self, whittaker):
        """a + b/z + c/z^2, resp. b/z + c/z^2"""
        c, e = self.num.coefficients(Z), self.den.coefficients(Z)
        need(len(e) == 3 and not e[0] and not e[1] and self.s.is_unit(e[2]), "another denominator")
        need(len(c) == 2 + whittaker and self.s.is_unit(c[-1]), "another numerator")
        need(not self.factors and len(self.numbers) == 1 + whittaker, "other numbers")
        need(equal(self.numbers[-1].square, (e[2] + c[0] * 4, e[2] * (4 if whittaker else 1))), "another number")
        if whittaker:
            need(equal(self.numbers[0].square, (c[1] * c[1], c[2] * e[2] * 4)), "another number")

    def places(self, lame):
        """N/(e P^2), P the product of the finite places"""
        need(all(1 <= q.degree(Z) <= 3 for q in self.factors), "a place has no roots, or too many")
        need(len(self.factors) <= 3, "too many places")
        whole = product(self.factors)
        n = whole.degree(Z)
        need(n == 3 or n == 2 and not lame, "not enough places, or too many")
        need(self.s.is_unit(whole.lead(Z)), "a place may disappear")
        need(self.s.is_unit(resultant(whole, whole.diff(Z), Z)), "places may meet")
        e = quotient(self.den, whole * whole)
        need(e and e.degree(Z) == 0 and self.s.is_unit(e), "another denominator")
        need(self.num.degree(Z) <= (4 if lame else 2), "another place")
        need(len(self.numbers) == len(self.factors) + (lame or n == 2), "other numbers")
        for q, x in zip([*self.factors, None], self.numbers):
            a, b = x.square
            chi = a * -1, b * (4 if lame and q is None else 1)          # lame: 2n + 1 = 2 (n + 1/2) at infinity
            need(has_differences(self.num, self.den, q, chi), "another exponent difference")
            need(q is None or not lame or constant(x.square) == Fraction(1, 4), "a difference is not 1/2")

    # -- integers

    def show(self, d):
        """v in Z because w and the listed numbers are; or v not in Z, since then w (or a non-integer constant) would be in Z."""
        v, rest = tuple(self.s.poly(d["value"][k]) for k in ("num", "den")), d["with"] or []
        need(len(rest) <= 100, "a limit: the number of memberships")
        self.s.show_integer(v, d["integral"], d["times"], d["membership"], [(x["times"], x["membership"]) for x in rest])
        return v, d["integral"]

    def known(self, f):
        """Is f an integer at every point (True), at none (False)?"""
        c = constant(f)
        if c is not None:
            return c.denominator == 1
        rest = ((constant(plus(f, v, sign)), is_in) for v, is_in in self.shown for sign in (1, -1))
        return next((is_in for c, is_in in rest if c is not None and c.denominator == 1), None)

    def multiple(self, x, c, shift=0):
        """c x + shift"""
        return False if x.irrational else self.known(plus(times(x.root, c), None, shift)) if x.root else None

    def halves(self, x):
        return self.multiple(x, 1, -HALF)

    def verdict(self):
        found = getattr(self, "of_" + self.by)()
        return None if found is None else "yes" if found else "no"

    def of_bessel(self):
        return self.halves(self.numbers[0])

    def of_whittaker(self):
        k, m = self.numbers
        if not k.square[0]:
            return self.halves(m)
        if any(self.multiple(x, 2) is False for x in (k, m)):
            return False
        if not (k.root and m.root):
            return None
        both = [plus(plus(k.root, m.root, sign), None, -HALF) for sign in (1, -1)]
        if any(self.known(f) is False for f in both):
            return False
        p, q = map(self.natural, both)
        return None if p is None or q is None else p != q

    def natural(self, f):
        """Is the integer f >= 0, that is > -1, or < 0?  None: not known, or f may be none."""
        if not self.known(f):
            return None
        c, n = constant(f), f[1].constant()
        if c is not None or n is None:
            return None if c is None else c >= 0
        side = 1 if n > 0 else -1
        if self.s.is_positive(f[0] * side + f[1] * side):
            return True
        return False if self.s.is_positive(f[0] * -side) else None

    def of_lame(self):
        """x = 2n + 1; a finite group has x in 2Z, (2/3)Z, (1/2)Z or (2/5)Z, and 2Z is in (1/2)Z."""
        x = self.numbers[-1]
        if self.multiple(x, HALF, -HALF):
            return True
        if self.multiple(x, 30) is False:
            return False
        possible = x.value is None or any((x.value * c).denominator == 1 for c in (3 * HALF, 2, 5 * HALF))
        return None if possible else False

    def three(self):
        """The exponent differences of Riemann's equation"""
        return [x for i, x in enumerate(self.numbers)
                for _ in range(self.factors[i].degree(Z) if i < len(self.factors) else 1)]

    def one_difference(self, names):
        """The differences of Riemann's equation that are rational numbers, how many others there are, and the square that all of these
        have, as two texts; None: they have not"""
        if self.by != "riemann":
            return None
        known, others = ([x for x in self.three() if (x.value is None) == other] for other in (False, True))
        if not others or any(x.irrational or not equal(x.square, others[0].square) for x in others):
            return None
        return [x.value for x in known], len(others), [polynomial(f, names) for f in others[0].square]

    def of_riemann(self):
        three = self.three()
        if sum(self.halves(x) is True for x in three) >= 2:
            return True
        if any(self.trivial(x, *three[:i], *three[i + 1:]) for i, x in enumerate(three)):
            return True
        odd = self.odd_sums(three)
        if any(odd) and sum(x.rational for x in three) >= 2:
            return True
        dihedral = sum(self.halves(x) is not False for x in three) >= 2
        no_row = any(self.multiple(x, 1) or self.multiple(x, 60) is False for x in three)
        return False if all(v is False for v in odd) and not dihedral and no_row else None

    def trivial(self, x, l, m):
        """Is x a natural number N with l + m or l - m among N - 1, N - 3, ..., 1 - N?"""
        if x.value is None or x.value.denominator != 1:
            return False
        sums = [constant(plus(l.root, m.root, sign)) for sign in (1, -1)] if l.root and m.root else []
        return any(c is not None and abs(c) < x.value and (x.value - 1 - c) % 2 == 0 for c in sums)

    def odd_sums(self, three):
        """Is (l +- m +- n - 1)/2 an integer?"""
        if not all(x.root for x in three):
            return [None]
        l, m, n = (x.root for x in three)
        return [self.known(times(plus(plus(plus(l, m, a), n, b), None, -1), HALF)) for a, b in pairs((1, -1), repeat=2)]

    def criterion(self, names):
        """As text.  It says the same for both roots, and has no names but those of the certificate."""
        def text(x):
            return "({})/({})".format(*(polynomial(f, names) for f in x.square))
        first, last = (f"sqrt({text(self.numbers[i])})" for i in (0, -1))
        if self.by == "lame":
            return f"{last} is an odd integer or the group is finite"
        if self.by == "whittaker" and self.numbers[0].square[0]:
            return f"{first} + {last} - 1/2 and {first} - {last} - 1/2 are integers, one >= 0 and one < 0"
        if self.by != "riemann":
            return f"{last} + 1/2 is an integer"
        return ("two exponent differences are halves of odd integers, or they are in the table of Schwarz and Kimura, or "
                "a sum of the three with signs is an odd integer and (all are rational, or one is an integer and there "
                f"is no logarithm); their squares: {', '.join(map(text, self.three()))}")
