"""Properties of condition.py of the Python checker, functions of its modules (sys.modules) that are True: whatever is accepted of a
set holds at each of its points, which are random Gaussian numbers here; and what once proved that 1 = 0 is refused."""
from fractions import Fraction as F
from random import Random

from lowest import refused

A, B = 0, 32                                    # the names a and b


class Point:
    """Values of a and b, pairs of the real and the imaginary part"""

    def __init__(self, *values):
        self.values = values

    def __call__(self, f):
        """The value of a polynomial"""
        total = F(0), F(0)
        for k, c in f.items():
            v = F(c), F(0)
            for x, (s, t) in zip((A, B), self.values):
                for _ in range(k >> x & 2**32 - 1):
                    v = v[0] * s - v[1] * t, v[0] * t + v[1] * s
            total = total[0] + v[0], total[1] + v[1]
        return total

    def fraction(self, f):
        (s, t), (u, v) = map(self, f)
        n = u * u + v * v
        return (s * u + t * v) / n, (t * u - s * v) / n

    def holds(self, f, says):
        if says == "some":
            return any(self.holds(g, "nonzero") for g in f)
        if isinstance(says, bool):
            return self(f[1]) != (0, 0) and is_integer(self.fraction(f)) == says
        s, t = self(f)
        return {"zero": s == t == 0, "nonzero": (s, t) != (0, 0), "positive": t == 0 < s, "nonnegative": t == 0 <= s}[says]


def is_integer(value):
    return value[1] == 0 and value[0].denominator == 1


class Case:
    """A point and a set in which it is: of each name it is drawn whether it is real"""

    def __init__(self, m, seed):
        self.m, self.random = m, Random(seed)
        m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000
        draw = self.random.randint
        self.real = {x for x in (A, B) if draw(0, 1)}
        self.point = Point(*((F(draw(-2, 2)), F(0 if x in self.real else draw(-2, 2))) for x in (A, B)))
        self.set = m["condition"].ConditionSet({"a": A, "b": B}, self.real)
        for _ in range(draw(1, 4)):
            self.set = self.set.also(self.condition(self.polynomial()))

    def polynomial(self, degree=2):
        draw, P = self.random.randint, self.m["multivariate"].P
        return P.of({(draw(0, degree) << A) + (draw(0, degree) << B): draw(-3, 3) for _ in range(draw(1, 3))})

    def condition(self, f):
        """One that holds at the point: of f, or of f less its value"""
        s, t = self.point(f)
        if t == 0 and s.denominator == 1 and self.random.random() < 0.3:
            f = f - self.m["multivariate"].P({0: int(s)}) if s else f
        s, t = self.point(f)
        signs = ["zero" if s == t == 0 else "nonzero"] + ["positive", "nonnegative"] * (t == 0 < s) + ["nonnegative"] * (s == t == 0)
        return f, self.random.choice(signs)

    def term(self):
        draw, one = self.random.randint, self.m["multivariate"].ONE
        q = self.random.choice([one, one, one * 2, self.polynomial(1), self.random.choice(self.set.conditions)[0]])
        usable = [i for i, (_, says) in enumerate(self.set.conditions) if says != "zero"]
        return F(draw(1, 3), draw(1, 2)), q, [(self.random.choice(usable), draw(1, 3)) for _ in range(draw(0, 2)) if usable]

    def text(self, f):
        return self.m["statement"].polynomial(f, ["a", "b"])

    def node(self, terms, zeros=()):
        return {"node": "empty", "terms": [[str(c), self.text(q), *([str(i), str(e)] for i, e in rows)] for c, q, rows in terms],
                "zeros": [[str(i), self.text(f)] for i, f in zeros]}

    def value_of(self, terms):
        """The sum of the terms, without a common denominator, times 6"""
        total = self.m["multivariate"].P()
        for c, q, rows in terms:
            f = q * q * int(6 * c)
            for i, e in rows:
                f *= self.set.conditions[i][0]**e
            total += f
        return total


def cases(m, n, first=0):
    return (Case(m, 1000 * first + seed) for seed in range(n))


def without_data(m):
    """is_real, is_unit, is_positive"""
    seen = {"is_real": 0, "is_unit": 0, "is_positive": 0}
    for x in cases(m, 100, 1):
        for _ in range(6):
            given = [f for f, _ in x.set.conditions]
            f = x.random.choice([x.polynomial(), x.random.choice(given) * x.random.choice([-2, 1, 3]), x.random.choice(given) * x.random.choice(given),
                                 m["multivariate"].P({0: x.random.choice([-1, 2])})])
            s, t = x.point(f)
            right = {"is_real": t == 0, "is_unit": (s, t) != (0, 0), "is_positive": t == 0 < s}
            for name, holds in right.items():
                if getattr(x.set, name)(f):
                    seen[name] += 1
                    if not holds:
                        return False
    return min(seen.values()) > 50


def sums(m):
    """A sum of terms is > 0, or, if it need not be, not 0"""
    seen = 0
    for x in cases(m, 300, 2):
        terms, found = [x.term() for _ in range(x.random.randint(1, 3))], []
        for positive in (True, False):
            if not refused(m, lambda: found.append(x.set.total(terms, positive))):
                total, k = found[-1]
                s, t = x.point(total)
                seen += 1
                if k <= 0 or (s, t) == (0, 0) or (positive or len(terms) > 1) and (t or s < 0) or total * 6 != x.value_of(terms) * k:
                    return False
    return seen > 100


def contradictions(m):
    """There is a point: sums that are 0 contradict nothing, whatever sign the last condition has there"""
    for x in cases(m, 150, 3):
        terms = [x.term() for _ in range(x.random.randint(1, 2))]
        rest, n = x.value_of(terms) * -1, len(x.set.conditions)
        terms = [(6 * c, q, rows) for c, q, rows in terms]
        f, says = x.condition(rest)
        if f != rest:
            continue
        x.set = x.set.also((f, says))
        one = m["multivariate"].ONE
        node = x.node(terms, [(n, one * -1)]) if says == "zero" else x.node([*terms, (F(1), one, [(n, 1)])])
        if says == "zero":
            node["zeros"] = [[str(n), "1"]]
        if not refused(m, lambda: x.set.absent(node)):
            return False
        for p in (x.polynomial(), rest):            # nor do they in one branch of a case distinction, the others being as they are
            for kind in ("zero", "sign"):
                branches = {"zero": node, "nonzero": node, "positive": node, "negative": node}
                tree = {"node": kind, "p": x.text(p)} | {b: branches[b] for b, *_ in m["condition"].BRANCHES[kind]}
                if not refused(m, lambda: x.set.absent(tree)):
                    return False
    return True


def shown(m):
    """A condition that is shown holds"""
    seen = dict.fromkeys(("positive", "nonnegative", "nonzero", "zero", "some"), 0)
    for x in cases(m, 1000, 4):
        says, c = x.random.choice(list(seen)), x.random.choice([1, 1, -1])
        terms, n = [x.term() for _ in range(x.random.randint(1, 2))], len(x.set.conditions)
        f, one = x.value_of(terms) * c, m["multivariate"].ONE
        terms = [(6 * t, q, rows) for t, q, rows in terms]
        if says == "zero":                          # f as a multiple of a condition, or f^2 - f * f
            g, sign = x.random.choice(x.set.conditions)
            f = g if sign == "zero" and x.random.randint(0, 2) else f
            i = next((i for i, (h, sign) in enumerate(x.set.conditions) if sign == "zero"), 0)
            node = x.node([(F(1), one, [(n, 2)])], [(i, f * -1)])
        elif says in ("nonzero", "some"):
            node = x.node(terms, [(n, one * -c)])
        else:
            node = x.node([*terms, (F(1), one, [(n, 1)])])
        if not refused(m, lambda: x.set.show([f] if says == "some" else f, says, node)):
            seen[says] += 1
            if not x.point.holds([f] if says == "some" else f, says):
                return False
    return min(seen.values()) > 10


def integers(m):
    """A value that is shown to be an integer, or none; and one that a membership has not"""
    seen, M = [0, 0, 0], m["multivariate"]
    for x in cases(m, 800, 5):
        draw, units = x.random.randint, []
        for _ in range(2):
            f, g = x.polynomial(1), x.random.choice([M.ONE, M.P({0: 2}), M.P({1 << A: 1})])
            if x.point(g) == (0, 0):
                continue
            units.append(g)
            x.set.integers.append(((f, g), is_integer(x.point.fraction((f, g)))))
        if not x.set.integers:
            continue
        x.set = x.set.also(units=units)
        i, j, k, n, c = draw(0, len(x.set.integers) - 1), draw(0, len(x.set.integers) - 1), draw(1, 2), draw(-1, 1), F(draw(-2, 2), draw(1, 2))
        (w, is_in), (u, _), integral = x.set.integers[i], x.set.integers[j], bool(draw(0, 1))
        v = M.plus(M.plus(M.times(w, k), u, n), None, -c) if integral else M.times(M.plus(M.plus(w, u, -n), None, c), F(1, k))
        if not integral and v[1].constant() is None and draw(0, 1):
            v = v[0], M.ONE
        if not refused(m, lambda: x.set.show_integer(v, integral, k, i, [(n, j)])):
            seen[integral] += 1
            if is_integer(x.point.fraction(v)) != integral:
                return False
        p = w[0] * c.denominator - w[1] * c.numerator
        p = p if draw(0, 2) else p + M.ONE
        if p.constant() is None and not refused(m, lambda: x.set.need_violated(i, c, p)):
            seen[2] += 1
            if x.point(p) == (0, 0):
                return False
    return min(seen) > 20


def solved(m):
    """What is known where p = 0 holds at a point with p = 0"""
    seen = 0
    for x in cases(m, 600, 6):
        M = m["multivariate"]
        l, shift = x.random.choice([M.ONE, M.P({1 << A: 1}), M.P({1 << A: 1, 0: 1}), M.P({0: -2})]), x.polynomial(1)
        rest = M.P({k: c for k, c in shift.items() if not k >> B})
        (s, t), (u, v), (p, q) = x.point(l), x.point.values[1], x.point(rest)
        value = s * u - t * v + p, s * v + t * u + q
        if value[1] or value[0].denominator > 1 or (s, t) == (0, 0):
            continue
        p = l * M.P({1 << B: 1}) + rest - M.P({0: int(value[0])}) if value[0] else l * M.P({1 << B: 1}) + rest
        x.set.integers.append(((M.P({1 << B: 1}), M.ONE), is_integer((u, v))))
        x.set.groups.append([M.P({1 << B: 1, 0: 7})])
        x.set = x.set.also(units=[l] if x.random.randint(0, 3) else [])
        found = []
        if refused(m, lambda: found.append(x.set.solve(p, "b"))):
            continue
        seen += 1
        s, put = found[0]
        kept = [(f, says) for f, says in s.conditions if says != "dropped"]
        if len(s.conditions) != len(x.set.conditions) or not all(x.point.holds(*c) for c in kept + s.integers) or \
                any(f and x.point(f) == (0, 0) for f in s.units()) or any(x.point.holds(g, "zero") for group in s.groups for g in group) or \
                any(x.point.values[0][1] for name in s.real if name == A) or B in s.real | s.rational or "b" in s.names or \
                any(f.variables() - {A} for f, _ in s.conditions) or not x.point.holds(put(p), "zero"):
            return False
    return seen > 100


def rational_roots(m):
    """What has no root modulo a prime has no rational root"""
    seen, M = 0, m["multivariate"]
    for seed in range(300):
        draw = Random(seed).randint
        M.Work.left = 10**6
        s = m["condition"].ConditionSet({"a": A}, (), {A} if draw(0, 9) else ())
        r, x = F(draw(-3, 3), draw(1, 3)), M.P({1 << A: 1})
        p = (x * r.denominator - M.P.of({0: r.numerator})) * M.P.of({1 << A: draw(1, 2), 0: draw(-2, 2)}) if draw(0, 1) else \
            M.P.of({2 << A: draw(1, 5), 1 << A: draw(-3, 3), 0: draw(-5, 5)})
        for q in (2, 3, 4, 5, 7):
            if not refused(m, lambda: s.need_no_rational_root(p, q)):
                seen += 1
                discriminant = p.get(1 << A, 0)**2 - 4 * p.get(2 << A, 0) * p.get(0, 0)
                if not s.rational or discriminant >= 0 and m["exact"].exact_sqrt(F(discriminant)) is not None or q == 4:
                    return False
    return seen > 50


def names_anywhere(m):
    """What is 0 nowhere does not depend on the positions of the names"""
    M, S = m["multivariate"], m["condition"].ConditionSet
    for i, j in ((0, 1), (13, 14), (14, 3), (14, 15), (15, 40), (40, 14), (0, 63), (63, 62)):
        M.Work.left = 10**6
        s = S({"a": i * M.FIELD, "b": j * M.FIELD})
        s = s.also(*((s.poly(f), "nonzero") for f in ("a", "a*b - 1")))
        if any(s.is_unit(s.poly(f)) != unit for f, unit in (
                ("a", True), ("a^3", True), ("b", False), ("a*b", False), ("a + b", False), ("a*b^2 - b", False), ("a^3*b - a^2", True),
                ("a^2 - b", False), ("b*a - 1", True), ("1", True), ("0", False))) or \
                M.quotient(s.poly("a"), s.poly("b")) is not None or M.quotient(s.poly("b"), s.poly("a")) is not None or \
                M.quotient(s.poly("a^2*b - a"), s.poly("a*b - 1")) != s.poly("a"):
            return False
    return True


def traps(m):
    """Each proved 1 = 0 once (and the one beside it, which is right)"""
    M, S = m["multivariate"], m["condition"].ConditionSet
    M.Work.left, S.nodes = 10**7, 1000

    def of(*given, real=(), integers=(), rational=()):
        s = S({"a": A, "b": B}, {"ab".index(x) * 32 for x in real}, rational)
        s = s.also(*((s.poly(f), says) for f, says in given))
        for f, g, integral in integers:
            s.integers.append(((s.poly(f), s.poly(g)), integral))
            s = s.also(units=[s.poly(g)])
        return s

    def shows(s, f, says, *node):
        terms, zeros = (*node, ())[:2]
        return not refused(m, lambda: s.show(s.poly(f), says, {"node": "empty", "terms": terms, "zeros": list(zeros)}))

    def shows_integer(s, v, integral, *data):
        return not refused(m, lambda: s.show_integer(tuple(map(s.poly, v)), integral, *data))
    a, x, none = of(("a", "nonzero")), of(integers=[("a", "1", True)]), of(integers=[("a", "1", False)])
    square = [["1", "1", ["0", "2"]], ["1", "1", ["1", "1"]]]               # a^2 + (-a^2)
    minus = of(("a^2 + 1", "zero"))
    return (
        # x/2 for an integer x; 2 x, and 2 x + 1/2
        shows_integer(x, ("2*a", "1"), True, 2, 0, []) and not shows_integer(x, ("a", "2"), True, 1, 0, [])
        and not shows_integer(x, ("4*a + 1", "2"), True, 2, 0, []) and shows_integer(x, ("4*a + 1", "2"), False, 1, 0, [(-1, 0)])
        # what is no integer is not real, nor is 2 x one that is none
        and not none.is_real(none.poly("a")) and not shows_integer(none, ("2*a", "1"), False, 1, 0, [])
        and shows_integer(none, ("a", "2"), False, 2, 0, [])
        # 1/x at x = 0, and (x^2 - x)/(x - 1) at x = 1
        and not shows_integer(of(integers=[("1", "1", True)]), ("a", "a"), True, 1, 0, [])
        and not shows_integer(x, ("a^2 - a", "a - 1"), True, 1, 0, [])
        # a^2 where a is not 0, at a = i; and -1 > 0 from -a^2 = 1
        and not shows(a, "a^2", "positive", square) and shows(of(("a", "nonzero"), real="a"), "a^2", "positive", square)
        and not shows(of(("a^2 + 1", "zero")), "-1", "positive", [["1", "a"], ["1", "1", ["1", "1"]]], [["0", "-1"]])
        and not minus.is_real(minus.poly("a")) and minus.is_real(minus.poly("3"))
        # a sign is the value of f, not of its names: f g > 0 says nothing of f
        and not shows(of(("a*b", "positive")), "a", "nonnegative", [["1", "1", ["0", "1"]], ["1", "b", ["1", "1"]]])
        and of(("a*b", "positive")).is_real(minus.poly("-2*a*b")) and not of(("a*b", "nonzero")).is_real(minus.poly("a*b"))
        # Q = 0, and a Q that may be 0, in one term
        and not shows(a, "0", "nonzero", [["1", "0"]], []) and not shows(of(), "b", "nonzero", [["1", "b"]], [["0", "-b"]])
        and shows(of(("b", "nonzero")), "b^2", "nonzero", [["1", "b"]], [["1", "-1"]])
        # 0 f is not 0
        and not a.is_unit(a.poly("0")) and not refused(m, lambda: a.also((M.P(), "nonzero")).absent(
            {"node": "empty", "terms": [["1", "1", ["1", "2"]]], "zeros": []}))
        # one term of which nothing says that it is real has no sign
        and refused(m, lambda: a.total([(F(1), a.poly("1"), [(0, 1)])], True)) and not refused(m, lambda: a.total([(F(1), a.poly("1"), [(0, 1)])]))
        # the square of a name that is real in another set only
        and refused(m, lambda: of().total([(F(1), a.poly("b"), []), (F(1), a.poly("1"), [])]))
        and not refused(m, lambda: of(real="b").total([(F(1), a.poly("b"), []), (F(1), a.poly("1"), [])])))


def properties():
    """(name, function, True)"""
    return [(f"points.{f.__name__}", f, True)
            for f in (without_data, sums, contradictions, shown, integers, solved, rational_roots, names_anywhere, traps)]
