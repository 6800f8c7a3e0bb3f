"""The leaves of a certificate over strata that say "not abelian" (docs/theory/strata_certificates.md 7): what the places
prove.  s is the state at the leaf, a Stratum of stratum.py."""
from fractions import Fraction
from functools import reduce
from itertools import count
from math import ceil, isqrt, lcm

from certificate_format import need, right
from exact import exact_sqrt
from modular import is_prime, mgcd, trim
from multivariate import FIELD, ONE, P, determinant, pseudo_remainder, quotient, ratio, resultant, spend, sylvester
from places import Local, Place
from stratum import Z, factors, has_differences, squared_difference, symmetric_power

MOST = 1000                                 # values of n (7.9)


def natural(x):
    return x >= 0 and x.denominator == 1


def root_above(x, k):
    """The least j/k, j natural, with (j/k)^2 >= x."""
    n = max(0, ceil(x * k * k))
    return Fraction(isqrt(n) + (isqrt(n)**2 < n), k)


def fractions(b, numbers):
    """The a/n up to b, a >= 1, for these n; with 4 those for 1 and 2 as well"""
    return [Fraction(a, n) for n in numbers for a in range(1, int(b * n) + 1)]


class Leaf:
    """An equation that is nowhere abelian (7).  A Place is that of places.py, where an open one counts as irrational.
    Besides it has chi; open; b >= Delta, or None; side, 1 at infinity and -1 elsewhere."""

    def __init__(self, s, d):
        self.s, self.by, self.absent = s, d["by"], {x["m"]: x for x in d["absent"] or []}
        self.growth = d["growth"]
        need(not self.growth or self.by == "separated", "the theorem has no growth")
        right(len(self.absent) == len(d["absent"] or []), "a degree occurs twice")
        need(s.num, "r is 0")
        self.content, self.qs, self.orders = factors(s, d["content"], d["places"])
        for i, (q, k) in enumerate(zip(self.qs, self.orders)):
            need(q.degree(Z) == 1 or s.is_unit(resultant(q, q.diff(Z), Z)), "two roots of a place may meet")
            need(all(s.is_unit(resultant(q, f, Z)) for f in self.qs[:i]), "two places may meet")
            need(k == 2 or s.is_unit(resultant(q, s.num, Z)), "the order of a pole may drop")
        order = 4 - s.den.degree(Z) + s.num.degree(Z)
        need(order <= 0 or order == 2 or s.is_unit(s.num.lead(Z)), "the order at infinity may drop")
        finite = [self.place(*x) for x in zip(self.qs, self.orders, d["places"])]
        self.local = Local(finite, self.place(None, order, d["infinity"]))
        self.open = [x for x in self.local.all if x.open]
        self.torus = any(x.order >= 3 or x.irrational and not x.open for x in self.local.all)

    # -- places

    def place(self, q, order, d):
        x = Place(q, q.degree(Z) if q else 1, order)
        x.chi, x.open, x.b, x.side = None, False, None, -1 if q else 1
        if order != 2:
            given = {k for k in d if k not in ("q", "order") and d[k] is not None}
            need(given <= ({"log"} if order == 1 else set()), "not a regular place")
            return x
        x.chi = None if d["chi"] is None else self.chi(q, [self.s.poly(f) for f in d["chi"]])
        linear = x.chi and len(x.chi) == 2
        square = ratio(x.chi[0] * -1, x.chi[1]) if linear else None
        x.delta = x.real = exact_sqrt(square) if square is not None else None
        if d["bound"] is not None:
            need(linear and self.is_bound(d["bound"], *x.chi), "the bound is not proved")
            x.b = root_above(d["bound"], 2)
        if d["irrational"]:
            proved = x.delta is None and x.chi and self.is_irrational(d["irrational"], x.chi, square)
            need(proved, "an exponent difference is not proved irrational")
            negative = linear and d["irrational"] == "positive"
            x.real = Fraction(0) if negative else root_above(square, 8) if square is not None else None
        elif x.delta is None:
            x.open, x.real = True, x.b
            need(linear or self.by in ("irreducible-log", "torus-log"), "an exponent difference is not known")
        x.irrational = x.delta is None
        if d["log"] and x.delta != 0:
            need(x.n == 1 and x.delta in range(1, 41), "no logarithm can be seen here")
            need(self.s.is_unit(self.defect(q, int(x.delta))), "no logarithm is seen")
        x.logs = x.n if d["log"] or x.delta == 0 else 0
        return x

    def chi(self, q, chi):
        """All Delta^2 at the place are roots of chi, of constant degree (7.2)."""
        right(len(chi) >= 2, "chi has degree 1 at least")
        need(self.s.is_unit(chi[-1]), "chi may lose degree")
        need(has_differences(self.s.num, self.s.den, q, chi), "Delta^2 is not a root of chi")
        return chi

    def is_bound(self, B, a, b):
        """B - Delta^2 = (B b + a) b/b^2 >= 0, b real (7.5)"""
        c = (b * B.numerator + a * B.denominator) * b
        return not c or self.s.is_positive(c) and self.s.is_real(b)

    def is_irrational(self, why, chi, square):
        """chi has no root that is the square of a rational number, at any point (7.2)."""
        positive = self.s.is_positive
        if why == "constant":
            return square is not None
        if why == "positive":
            return all(map(positive, chi)) or all(positive(f * -1) for f in chi)
        need(why == "discriminant" and len(chi) == 3 and all(map(self.s.is_real, chi)), "not a real quadratic polynomial")
        return positive(chi[2] * chi[0] * 4 - chi[1]**2)

    def defect(self, q, N):
        """A numerator of the defect at the root of q, or at infinity (7.3).  t^2 r = f/g in the parameter q (infinity: 1/z); the
        solution has the coefficients u_k/(g_0^k prod_(0 < i <= k) 4 i(i - N)), and u_N, made by the same rule, is the defect."""
        if q:
            (low, lead), w = q.coefficients(Z), quotient(self.s.den, q**2)
            shift, e = low - P({1: 1}), w.degree(Z) - self.s.num.degree(Z) - 2
            f, g = (v.substitute(Z, lead, shift, v.degree(Z)).coefficients(Z) for v in (self.s.num, w))
            f, g = [v * lead**max(0, e) for v in f[:N + 1]], [v * lead**max(0, -e) for v in g[:N + 1]]
        else:
            f, g = (v.coefficients(Z)[::-1] for v in (self.s.num, self.s.den))
        f, g = (v + [P()] * (N + 1 - len(v)) for v in (f, g))
        u = [ONE]
        for k in range(1, N + 1):
            total = P()
            for j in range(k):
                total = total * g[0] * (4 * j * (j - N)) + (f[k - j] * 4 - g[k - j] * ((2 * j - N)**2 - 1)) * u[j]
            u.append(total)
        return u[N] * g[0]**N

    # -- what is excluded (7.4)

    def irreducible(self):
        return any(x.ramified for x in self.local.all) or self.local.degree_bound_1() < 0

    def sums(self, choice, places, start=()):
        """All sums of one choice at each point; None if there are more than 4000."""
        total = {Fraction(sum(start))}
        for x in places:
            for _ in range(x.n):
                values = choice(x)
                spend(20 + len(total) * len(values))
                total = {a + b for a in total for b in values}
                if len(total) > 4000:
                    return None
        return total

    @staticmethod
    def line(x):
        """1 - alpha at infinity, -alpha at a finite point, for an exponential solution; 0 and 1 if infinity is ordinary"""
        half = Fraction(x.side, 2)
        return {half - x.delta / 2} if x.logs else {half - x.delta / 2, half + x.delta / 2}

    @staticmethod
    def product(x):
        """4 - (the order of (y1 y2)^2) at infinity, -order at a finite point, where no place is a log place (7.7)"""
        if x.order >= 3:
            return {4 - x.order if x.side == 1 else -x.order}
        if x.irrational:
            return {2 * x.side}
        return {2 * x.side + i * x.delta for i in ((-2, 0, 2) if (2 * x.delta).denominator == 1 else (0,))}

    def no_line(self):
        if self.irreducible():
            return True
        lines = self.sums(self.line, self.local.all) if all(x.delta is not None for x in self.local.all) else None
        return lines is not None and not any(map(natural, lines))

    def no_invariant(self, m):
        """Of degree m, at any point: by D_m, or by a system of full rank."""
        need(m <= 200, "the degree of an invariant is too large")
        if (D := self.local.degree_bound(m)) < 0:
            return True
        need(D < 40 and m in self.absent, f"an invariant of degree {m} is not excluded")
        data = [(q, k, x.lowest(m)) for q, k, x in zip(self.qs, self.orders, self.local.finite)]
        powers = symmetric_power(self.s, self.content, data, m, [P({j: 1}) for j in range(D + 1)])
        columns, minors, absent = [f.coefficients(Z) for f in powers], [], self.absent[m]
        for rows in (minor["rows"] for minor in absent["minors"]):
            need(len(set(rows)) == len(rows) == D + 1, "D + 1 rows are expected")
            minors.append(determinant([[c[i] if i < len(c) else P() for c in columns] for i in rows]))
        times = [self.s.poly(minor["times"]) for minor in absent["minors"]]
        if absent["prime"] is not None:
            need(len(times) >= 2 and all(f == ONE for f in times), "a prime separates two or more minors themselves")
            return self.no_common_root([self.s.rest(f) for f in minors if f], absent["prime"])
        return self.s.is_unit(sum((f * t for f, t in zip(minors, times)), P()))

    @staticmethod
    def no_common_root(fs, p):
        """A common root would be one of a factor over Q, and modulo p, as the degree of the first does not drop."""
        xs = set().union(*(f.variables() for f in fs))
        need(fs and len(xs) <= 1, "no minors, or more than one parameter")
        need(2 <= p < 2**31 and is_prime(p), "not a prime below 2^31")
        x = min(xs, default=0)
        rows = [[c.constant() % p for c in f.coefficients(x)] for f in fs]
        spend(sum(map(len, rows))**2)
        return bool(rows[0][-1]) and len(reduce(lambda a, b: mgcd(a, b, p), map(trim, rows))) == 1

    def excluded(self, x, v):
        """Delta is nowhere v."""
        return self.s.is_unit(x.chi[1] * v.numerator**2 + x.chi[0] * v.denominator**2)

    # -- theorems (7.6)

    def prove(self):
        local, by = self.local, self.by
        proved = {
            "torus-log": lambda: self.torus and local.log,
            "torus": lambda: self.torus and not self.open and self.no_invariant(4),
            "irreducible-log": lambda: local.log and self.irreducible(),
            "rational": self.rational,
            "open": self.several_open,
            "one-open": lambda: len(self.open) == 1 and self.no_invariant(4) and self.one_open(self.open[0]),
            "separated": lambda: separated(self.s, local.all, self.growth)}
        need(proved[by](), f"the premises of {by} are not all given")

    def rational(self):
        self.local.need_rational()
        n = lcm(2, self.local.character_order())
        return (self.local.log or self.no_invariant(12)) and (self.no_line() or self.no_invariant(n))

    def several_open(self):
        need(self.open and all(x.b is not None for x in self.open), "an open place has no bound")
        numbers = [(2,) if self.torus or self.local.log or x is not self.open[0] else (3, 4, 5) for x in self.open]
        return (self.torus or self.irreducible()) and self.no_invariant(4) and \
            all(self.excluded(x, v) for x, ns in zip(self.open, numbers) for v in fractions(x.b, ns))

    def one_open(self, x):
        """No value of Delta at the place x allows an abelian component (7.7, strata.md 6.1)."""
        local, others, values = self.local, [y for y in self.local.all if y is not x], set()
        need(x.b is not None or self.torus and local.log, "the open place has no bound")
        if not local.log:                       # (i)
            found = self.sums(self.product, others, [2 * x.side * x.n])
            need(found, "too many sums")
            for v in fractions(x.b, [2]):
                spend(10 * len(found) * (2 * x.n + 1))
                if any(natural(f / 2 + j * v) for f in found for j in range(-x.n, x.n + 1)):
                    values.add(v)
        if not self.torus:
            if not local.log and all(y.order != 2 or y.delta.denominator <= 5 for y in others):
                spend(300 * ceil(x.b))
                values |= {v for v in fractions(x.b, (3, 4, 5)) if self.primitive(x, v)}    # (ii)
            lines = self.sums(self.line, others, [Fraction(x.side * x.n, 2)])
            need(lines and not (x.n % 2 == 0 and any(map(natural, lines))), "lines with j = 0 are not excluded")
            for f in lines:                     # (iii)
                for j in range(x.n, 0, -2):
                    low, high = max(0, ceil(f - x.b * j / 2)), int(f + x.b * j / 2 + 1)
                    spend(20 * max(1, high - low))
                    values |= {v for k in range(low, high + 1) if (v := abs(2 * (k - f) / j)) <= x.b}
        return all(self.excluded(x, v) for v in values)

    def primitive(self, x, v):
        """(ii): a finite primitive group is possible for Delta = v."""
        spend(20 * len(self.local.all))
        x.delta, x.irrational = v, False
        possible = self.local.degree_bound(12) >= 0
        x.delta, x.irrational = None, True
        return possible


# -- three places, two of them with exponent differences d1, d2 that are not rational (7.9): abelian only if the third is a
# natural number n with +-d1 +- d2 among n - 1, n - 3, ..., 1 - n

def pair(s, places):
    """c with the roots d1^2, d2^2; those at the roots of q of degree 2 are the roots of the norm of Y T - X (7.2).  They are roots of chi,
    so that it has no other one if the sum of its roots is theirs."""
    need(len(places) == 1 or all(len(x.chi) == 2 for x in places), "chi is not linear")
    if len(places[0].chi) == 2:
        (a, b), (c, d) = places[0].chi, places[-1].chi
        return a * c, a * d + b * c, b * d
    c, q, T = places[0].chi, places[0].q, FIELD * (len(s.all) + 1)
    X, Y = squared_difference(s.num, s.den, q)
    norm = sylvester(q.coefficients(Z), pseudo_remainder(Y * P({1 << T: 1}) - X, q, Z).coefficients(Z))
    v = norm.coefficients(T)
    need(len(c) == 3 and c[1] * v[2] == c[2] * v[1], "chi has not the values at both roots")
    return tuple(c)


def grows(s, c, e, factor, shift):
    """2 (d1^2 + d2^2) >= factor Delta^2 - shift, and d1^2, d2^2 are conjugate complex numbers"""
    real = all(map(s.is_real, c)) and s.is_positive(c[2] * c[0] * 4 - c[1]**2)
    need(real and factor >= 1, "the squares are not known to be conjugate, or the factor is less than 1")
    d = factor.denominator * shift.denominator
    room = c[2] * e[0] * int(factor * d) - c[1] * e[1] * (2 * d) + c[2] * e[1] * int(shift * d)
    return not room or s.is_real(e[1]) and s.is_positive(room * c[2] * e[1])


def possible_sums(s, places, c, at_sum):
    """The k >= 0 with k = +-d1 +- d2 somewhere, if they are few; else None"""
    p, q = ratio(c[1] * -1, c[2]), ratio(c[0], c[2])
    if p is not None and q is not None:
        r = exact_sqrt(q)
        roots = [] if r is None else [exact_sqrt(p + 2 * r), exact_sqrt(p - 2 * r)]
        return {k for k in roots if k is not None and k.denominator == 1}
    if all(x.real == 0 for x in places):    # both imaginary
        return set() if s.is_unit(at_sum(0)) else {0}
    return None


def separated(s, places, growth):
    used = [x for x in places if x.order > 0]
    need(all(x.order == 2 for x in used), "a place is not regular")
    others = [x for x in used if x.open or x.delta is not None]
    irrational = [x for x in used if x not in others]
    need(len(others) == 1 == others[0].n and sum(x.n for x in irrational) == 2, "not three places, two irrational")
    third, c = others[0], pair(s, irrational)
    need(not growth or grows(s, c, third.chi, **growth), "the growth is not proved")

    def at_sum(k):
        return (c[2] * k**2 + c[1])**2 - c[2] * c[0] * 4
    sums = possible_sums(s, irrational, c, at_sum)
    if sums == set():
        return True

    def least(n):
        """k^2 is larger, by growth."""
        return growth["factor"] * n**2 - growth["shift"]

    def excluded(n):
        if third.delta is None and s.is_unit(third.chi[1] * n**2 + third.chi[0]):
            return True
        ks = [k for k in range(n - 1, -1, -2) if (sums is None or k in sums) and (not growth or k > 0 and k**2 > least(n))]
        return all(s.is_unit(at_sum(k)) for k in ks)
    if third.delta is not None:
        if third.delta.denominator > 1:
            return True
        need(third.delta <= MOST, "the exponent difference is too large")
        return excluded(int(third.delta))
    if not growth:
        need(third.b is not None and third.b <= MOST, "the third exponent difference has no bound up to 1000")
        return all(map(excluded, range(1, int(third.b) + 1)))
    for n in count(1):
        spend(20)
        need(n <= MOST, "too many values of the exponent difference")
        if least(n) >= (n - 1)**2:
            return True
        if not excluded(n):
            return False
