"""The sentences of an answer about parameters ("some a +- b is an odd integer"), read as a reader reads them, at one point: names
with values in Q(i).  It shares nothing with the program that wrote them.  Needs mpmath, for roots that are not in Q(i)."""
import math
import re
from fractions import Fraction
from itertools import permutations, product

import mpmath

mpmath.mp.dps = 60
SMALL = mpmath.mpf(10)**-38

# The table of Schwarz and Kimura
TABLE = {"A4": ("1/2 1/3 1/3", "2/3 1/3 1/3"), "S4": ("1/2 1/3 1/4", "2/3 1/4 1/4"),
         "A5": ("1/2 1/3 1/5", "2/5 1/3 1/3", "2/3 1/5 1/5", "1/2 2/5 1/5", "3/5 1/3 1/5", "2/5 2/5 2/5", "2/3 1/3 1/5", "4/5 1/5 1/5",
                "1/2 2/5 1/3", "3/5 2/5 1/3")}


class Unread(Exception):
    """A sentence that this reader does not know."""


class NoValue(Exception):
    """A division by 0."""


def root_of(q):
    if q < 0:
        return None
    a, b = math.isqrt(q.numerator), math.isqrt(q.denominator)
    return Fraction(a, b) if (a * a, b * b) == (q.numerator, q.denominator) else None


class Number:
    """re + im I; or only near `near`, and not in Q(i) as far as it is known."""

    def __init__(self, re=None, im=0, near=None):
        self.exact = near is None
        if self.exact:
            self.re, self.im = Fraction(re), Fraction(im)
        self.near = near if near is not None else mpmath.mpc(*(mpmath.mpf(x.numerator) / x.denominator for x in (self.re, self.im)))

    def both(self, other, exact, near):
        return Number(*exact(self, other)) if self.exact and other.exact else Number(near=near(self.near, other.near))

    def __add__(self, other):
        return self.both(other, lambda x, y: (x.re + y.re, x.im + y.im), lambda x, y: x + y)

    def __mul__(self, other):
        return self.both(other, lambda x, y: (x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re), lambda x, y: x * y)

    def __neg__(self):
        return self * Number(-1)

    def __sub__(self, other):
        return self + -other

    def __truediv__(self, other):
        if other.is_zero():
            raise NoValue
        if not other.exact:
            return self * Number(near=1 / other.near)
        size = other.re**2 + other.im**2
        return self * Number(other.re / size, -other.im / size)

    def __pow__(self, n):
        return Number(1) / self**-n if n < 0 else math.prod([self] * n, start=Number(1))

    def is_zero(self):
        return self.re == self.im == 0 if self.exact else abs(self.near) < SMALL

    def rational(self):
        """As a Fraction, or None; sums of roots may be rational."""
        if self.exact:
            return self.re if self.im == 0 else None
        x = self.near.real
        q = Fraction(mpmath.nstr(x, 45)).limit_denominator(10**6)
        return q if abs(self.near.imag) < SMALL and abs(x - mpmath.mpf(q.numerator) / q.denominator) < SMALL else None

    def sqrt(self):
        if self.exact:
            size = root_of(self.re**2 + self.im**2)
            re, im = (None, None) if size is None else (root_of((size + self.re) / 2), root_of((size - self.re) / 2))
            if re is not None and im is not None:
                return Number(re, im if self.im >= 0 else -im)
        return Number(near=mpmath.sqrt(self.near))

    def __repr__(self):
        return (f"{self.re}" if self.im == 0 else f"({self.re}+({self.im})*I)") if self.exact else str(self.near)


# ---- formulas

class Formula:
    def __init__(self, text, values):
        self.text, self.values, self.at = text, values, 0
        self.tokens = re.findall(r"\d+|[A-Za-z_]\w*|[-+*/^()]", text)
        if "".join(self.tokens) != re.sub(r"\s", "", text):
            raise Unread(text)

    def value(self):
        x = self.sum()
        if self.next():
            raise Unread(self.text)
        return x

    def next(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self):
        self.at += 1
        return self.tokens[self.at - 1] if self.at <= len(self.tokens) else ""

    def sum(self):
        x = self.product()
        while self.next() in ("+", "-"):
            x = x + self.product() if self.take() == "+" else x - self.product()
        return x

    def product(self):
        x = self.power()
        while self.next() in ("*", "/"):
            x = x * self.power() if self.take() == "*" else x / self.power()
        return x

    def power(self):
        if self.next() in ("+", "-"):
            return self.power() if self.take() == "+" else -self.power()
        x = self.atom()
        if self.next() == "^":
            self.take()
            n = self.power().rational()
            if n is None or n.denominator != 1:
                raise Unread(self.text)
            x = x**int(n)
        return x

    def atom(self):
        token = self.take()
        if token in ("(", "sqrt"):
            if token == "sqrt":
                self.take()
            x = self.sum()
            if self.take() != ")":
                raise Unread(self.text)
            return x if token == "(" else x.sqrt()
        if token.isdigit():
            return Number(token)
        if token not in self.values:
            raise Unread(self.text)
        return self.values[token]


def value(text, values):
    return Formula(text, values | {"I": Number(0, 1)}).value()


def values_of(text, values, separators=(", ", " and ", " or ")):
    """Of the formulas in a list of words; what stands in brackets is one."""
    parts, depth, begin, i = [], 0, 0, 0
    while i < len(text):
        depth += (text[i] == "(") - (text[i] == ")")
        found = next((s for s in separators if depth == 0 and text.startswith(s, i)), None)
        if found:
            parts.append(text[begin:i])
            begin = i + len(found)
        i += len(found) if found else 1
    return [value(part, values) for part in [*parts, text[begin:]]]


# ---- classes of numbers

ROW = r"(?:(?:\+-)?-?[\d/]+ \+ )?(?:[\d/]+\*)?Z"
CLASS = rf"an integer|an even integer|an odd integer|in {ROW}(?:(?:, | or ){ROW})*|rational|irrational"
STEP = {"an integer": "Z", "an even integer": "2*Z", "an odd integer": "1 + 2*Z"}


def is_in(number, what, up_to_sign=False):
    x = number.rational()
    if what in ("rational", "irrational"):
        return (x is not None) == (what == "rational")
    if x is None:
        return False
    for row in re.split(", | or ", STEP.get(what, what.removeprefix("in "))):
        either, a, step = re.fullmatch(r"(?:(\+-)?(-?[\d/]+) \+ )?(?:([\d/]+)\*)?Z", row).groups()
        a, step = Fraction(a or 0), Fraction(step or 1)
        if ((x - a) / step).denominator == 1 or ((either or up_to_sign) and ((x + a) / step).denominator == 1):
            return True
    return False


def below(n, *numbers):
    """Is n a natural number, and one of the numbers N - 1, N - 3, ..., 1 - N?"""
    return n.denominator == 1 and n != 0 and any(x is not None and x in range(1 - abs(int(n)), abs(int(n)), 2) for x in numbers)


def without_logarithm(three):
    found = False
    for i, x in enumerate(three):
        n, (a, b) = x.rational(), three[:i] + three[i + 1:]
        if n is None or n.denominator != 1:
            continue
        if not below(n, (a + b).rational(), (a - b).rational()):
            return False
        found = True
    return found


def in_row(three, group):
    for row in TABLE[group]:
        for order in permutations(map(Fraction, row.split())):
            for signs in product((1, -1), repeat=3):
                rest = [None if x is None else x - s * y for x, s, y in zip((x.rational() for x in three), signs, order)]
                if all(x is not None and x.denominator == 1 for x in rest) and sum(rest) % 2 == 0:
                    return True
    return False


def pair(squares, products):
    """d1, d2 with these d1^2 + d2^2 and d1^2 d2^2: their sums and differences"""
    root = (squares * squares - Number(4) * products).sqrt()
    one, other = (((squares + x) / Number(2)).sqrt() for x in (root, -root))
    return [x.rational() for x in (one + other, one - other, other - one, -one - other)]


# ---- sentences

AMONG = r"among (\w+) - 1, \w+ - 3, \.\.\., 1 - \w+"
ONE = rf"(none of )?((?:(?! is ).)+?) is (not )?({CLASS})"


def compared(m, v):
    difference = value(m[1], v) - value(m[3], v)
    if m[2] in ("=", "!="):
        return difference.is_zero() == (m[2] == "=")
    x = difference.near.real if difference.rational() is not None else None
    return x is not None and (x > SMALL or ("=" in m[2] and x > -SMALL) if ">" in m[2] else x < -SMALL or ("=" in m[2] and x < SMALL))


def separated(m, v):
    n = value(m[1], v).rational()
    return (n is not None and below(n, value(m[4], v).rational())) == (m[2] == "a")


def separated_pair(m, v):
    n = value(m[1], v).rational()
    return (n is not None and below(n, *pair(value(m[5], v), value(m[6], v)))) == (m[2] == "a")


def some_sum(m, v):
    terms = values_of(m[2], v, (" +- ",))
    sums = (sum((x if s > 0 else -x for s, x in zip(signs, terms)), Number(0)) for signs in product((1, -1), repeat=len(terms)))
    return any(is_in(x, m[3], True) for x in sums) == (m[1] == "some")


def several(m, v):
    """A is c or B is d; or none of A, B is c, and D is not d"""
    pieces = re.findall(rf"(?:^| or | and ){ONE}(?= or | and |$)", m[0])
    if re.sub(rf"(?:^| or | and ){ONE}(?= or | and |$)", "", m[0]):
        raise Unread(m[0])
    negative = any(none or no for none, _, no, _ in pieces)
    return (all if negative else any)(any(is_in(x, what) for x in values_of(who, v)) != bool(none or no) for none, who, no, what in pieces)


def rational(m, v):
    return all(x.rational() is not None for x in values_of(m, v))


KINDS = [
    (r"((?:(?! is | are ).)+) (=|!=|>=|<=|>|<) ((?:(?! is | are ).)+)", compared),
    (rf"\+-\((.+)\) is (a|not a) natural number (\w+) with (.+) {AMONG}", separated),
    (rf"\+-\((.+)\) is (a|not a) natural number (\w+) with \+-d1 \+- d2 {AMONG}, where d1\^2 \+ d2\^2 = (.+), d1\^2\*d2\^2 = (.+)",
     separated_pair),
    (r"\(one of (.+) is an integer, and there is no logarithm\)", lambda m, v: without_logarithm(values_of(m[1], v))),
    (r"\(none of (.+) is an integer, or there is a logarithm\)", lambda m, v: not without_logarithm(values_of(m[1], v))),
    (r"(.+) are in (a|no) row for (.+) of the table of Schwarz and Kimura",
     lambda m, v: any(in_row(values_of(m[1], v), group) for group in re.findall(r"[AS]\d", m[3])) == (m[2] == "a")),
    (rf"(some|no) (.+ \+- .+) is ({CLASS})", some_sum),
    (r"one of (.+) is irrational", lambda m, v: not rational(m[1], v)),
    (rf"not both of (.+) are ({CLASS})", lambda m, v: not all(is_in(x, m[2]) for x in values_of(m[1], v))),
    (rf"(two of|at most one of) (.+) (?:is|are) ({CLASS})",
     lambda m, v: (sum(is_in(x, m[3]) for x in values_of(m[2], v)) > 1) == (m[1] == "two of")),
    (r"(.+ (?:is|are) .+), or (.+) (?:is|are) rational", lambda m, v: says(m[1], v) or rational(m[2], v)),
    (r"(.+ (?:is|are) .+), and not all of (.+) are rational", lambda m, v: says(m[1], v) and not rational(m[2], v)),
    (r"(.+ (?:is|are) .+), and (.+) is irrational", lambda m, v: says(m[1], v) and not rational(m[2], v)),
    (rf"(.+ and .+) are ({CLASS})", lambda m, v: all(is_in(x, m[2]) for x in values_of(m[1], v))),
    (r".+ is .+", several)]


def says(sentence, values):
    """Is it so at the point?"""
    for pattern, holds in KINDS:
        if m := re.fullmatch(pattern, sentence.strip()):
            return holds(m, values)
    raise Unread(sentence)
