"""Why the group of a normal equation is infinite (J7 of jet_certificates.md): certificates, and properties of jets.py of the
Python checker, functions of its modules (sys.modules) that are True."""
import json
from fractions import Fraction as F

from lowest import refused
from motion_rules import jets, motion, half
from motions import data


def in_y(x, coefficients):
    """The polynomial in y with these coefficients, ascending"""
    return x.R.sum(x.constant(c) * x.R.name(x.y)**i for i, c in enumerate(coefficients))


def stub(m, k=3, rho=(-2, 3), g=("0", "0", "1"), w=("0", "1"), sigma=None, r=(), h="2*q2^3", **more):
    """Jets with these data; r: the coefficients of c1^i c2^(3 - i) in the form"""
    x = jets(m, h)
    constant = {"g": in_y(x, g), "w": in_y(x, w)}
    vars(x).update(constant | {"k": k, "rho": [F(v) for v in rho], "sigma": F(-2, k - 2) if sigma is None else sigma, "order": 2} | more)
    x.form = x.R.read(" + ".join(f"{v}*c1^{i}*c2^{3 - i}" for i, v in enumerate(r) if v) or "0")
    return x


def accepts(m, group, **more):
    x = stub(m, **more)
    return not refused(m, lambda: m["jets"].NormalGroup(x, group, None))


def families(m):
    """The exponents, and one term each"""
    def first(k, delta):
        return accepts(m, {"by": "first-family"}, k=k, rho=(0, F(delta)))

    def homogeneous(delta=5, **more):
        return accepts(m, {"by": "homogeneous"}, rho=(0, F(delta)), **more)
    return (first(3, 5) and first(3, 7) and not first(3, 6) and not first(3, "1/5") and first(4, 3) and not first(4, 2)
            and not first(4, "1/3")
            and first(5, "7/3") and first(5, "13/3") and not first(5, 3) and first(6, 2) and not first(6, 3)
            and homogeneous() and homogeneous(7) and not homogeneous(6) and not homogeneous(g=("1", "0", "1")) and not homogeneous(g=("0",))
            and not homogeneous(w=("1", "1")) and not homogeneous(w=("0",)) and not homogeneous(w=()) and homogeneous(1, w=(), k=3)
            and homogeneous(1, w=("0", "0")) and not homogeneous(1, w=("0", "1")) and not homogeneous(1, w=(), g=("1", "1"))
            and homogeneous(r=(0, 5, 7, 11)) and homogeneous(r=(0, 0, 1, 0)) and not homogeneous(r=(3, 0, 0, 0))
            and not homogeneous(r=(3, 5, 0, 0)))


def equilibria(m):
    """(delta^2 - 1)/(4 sigma (sigma - 1)) is not a sum of k - 1 squares"""
    def of(k, delta, first=("0",), second=("1",), v=("0", "1")):
        x = stub(m, k=k, rho=(0, F(delta)))
        x.v = in_y(x, v)
        return not refused(m, lambda: m["jets"].NormalGroup(x, {"by": "equilibria", "first": first, "second": second}, None))
    one = {"first": ["1"], "second": []}
    # k = 3: (delta^2 - 1)/24; 4: /8; 5: (delta^2 - 1) 9/40
    return (of(3, 5, **one) is False and of(3, 7, **one) is False and of(3, "1/2", **one) and of(3, 19, **one) and of(3, 11, **one) is False
            and of(4, 5, **one) is False and of(4, 15, **one) and of(4, 3, **one) is False and of(5, 7, **one) is False
            and of(5, "1/3", **one)
            and not of(4, 15, first=["2"]) and not of(4, 15, first=[]))


def cofactors(m):
    """first f + second g = 1, for long lists, too"""
    x = stub(m)
    group = object.__new__(m["jets"].NormalGroup)
    group.jets, group.R = x, x.R

    def one(first, f, second, g):
        return not refused(m, lambda: group.need_one(first, in_y(x, f), second, in_y(x, g)))
    zeros = ["0"] * 12
    return (one(["1"], ["1"], [], []) and one([], [], ["2"], [["1", "2"]]) and not one(["1"], ["1"], ["1"], ["1"])
            and not one(["2"], ["1"], [], ["1"])
            and one(["1", *zeros], ["1"], [], []) and one([], [], ["1", *zeros], ["1"]) and one(["1"], ["1", *zeros], [], [])
            and one([], [], ["1"], ["1", *zeros]) and one(["1", "1"], ["1", "-1"], ["0", "1"], ["0", "1"])
            and not one(["1", "1"], ["1", "-1"], [], [])
            and not one(["1", *zeros, "1"], ["1"], [], []) and not one(["e"], ["1"], [], []) and one(["1", "a"], ["1"], ["-a"], ["0", "1"]))


def numbers(m):
    """The value of an element at e"""
    x = motion(m, half("2*q2^3"), denominators=["a", "2"], constants=[{"name": "w", "degree": 2, "value": "2"}])
    group = object.__new__(m["jets"].NormalGroup)
    group.R = x.R

    def value(text, *e):
        found = []
        return not refused(m, lambda: found.append(group.number(x.R.read(text), *e))) and found[0]
    return (value("e + 2") == 2 and value("e^2 + 2*e", F(3)) == 15 and value(["e", "3"], F(1, 2)) == F(1, 6)
            and value(["5", "3", "0", "2"]) == F(5, 12)
            and value("w*e + 1") is False and value(["1", "1", "1"]) is False and value("0") == 0 and value("w^2") == 2)


def plus(f, g):
    n = max(len(f), len(g))
    return [x + y for x, y in zip(f + [F(0)] * (n - len(f)), g + [F(0)] * (n - len(g)))]


def times(f, g):
    total = [F(0)] * (len(f) + len(g))
    for i, x in enumerate(f):
        for j, y in enumerate(g):
            total[i + j] += x * y
    return total


def bezout(f, g):
    """a and b with a f + b g = 1"""
    rows = [[f, [F(1)], [F(0)]], [g, [F(0)], [F(1)]]]
    while True:
        for row in rows:
            row[:] = [list(x) for x in row]
            while row[0] and not row[0][-1]:
                row[0].pop()
        rows.sort(key=lambda row: -len(row[0]))
        long, short = rows
        if len(short[0]) == 1:
            return [[x / short[0][0] for x in side] for side in short[1:]]
        factor = [F(0)] * (len(long[0]) - len(short[0])) + [-long[0][-1] / short[0][-1]]
        rows[0] = [plus(x, times(factor, y)) for x, y in zip(long, short)]


def energies(m):
    """The equation of a certificate at the energy 5, v = y^3 + 2 y + 1, w = 4 y + 1"""
    exact = m["exact"]
    v, w, h, inertia = [F(1), F(2), F(0), F(1)], [F(1), F(4)], F(5), F(3)

    def text(x):
        return [str(x.numerator), str(x.denominator)]
    x = stub(m, w=["1", "4"], g=[text(-inertia * c) for c in (2, 0, 3)])
    x.v, x.value = in_y(x, map(text, v)), x.R.read("e - 2")
    x.line = {"inertias": [x.one, x.one * 3]}
    kinetic = plus([h], [-c for c in v])
    first, second = ([text(c) for c in side] for side in bezout(kinetic, [F(2), F(0), F(3)]))
    g, M = [-inertia * c for c in (2, 0, 3)], [2 * inertia * c for c in kinetic]
    slope = [-inertia * 6 * F(c) for c in (0, 1)]
    num = plus([F(-3, 4) * c for c in times(g, g)], times(M, plus([c / 2 for c in slope], w)))

    def of(num=num, den=times(M, M), field=1, component="Gm", e="7", d=None, first=first, energy=h, second=second):
        exact.K.m, exact.K.d, exact.K.s = ([0, 1], 1, 1) if field == 1 else ([-2, 0, 1], 2, 3)

        def poly(f):
            n = 1
            for c in f:
                n *= c.denominator
            return exact.Poly([int(c * n) for c in f], n)
        group = object.__new__(m["jets"].NormalGroup)
        group.jets, group.R = x, x.R
        x.d = {"parameters": [], "constants": []} | (d or {})
        group.level = lambda: x.constant(text(energy))
        claim = {"component": component} if component else {}
        try:
            return not refused(m, lambda: group.of_certificate({"e": F(e), "first": first, "second": second, "certificate": None},
                                                               lambda _: (poly(num), poly(den), claim, 2,
                                                                   ["said"]))) and (group.trust, group.lines)
        finally:
            exact.K.m, exact.K.d, exact.K.s = [0, 1], 1, 1
    other = [c + (i == 1) for i, c in enumerate(num)]
    return (of() == (2, ["said"]) and not of(num=other) and not of(num=[-c for c in num]) and not of(den=M) and not of(component="trivial")
            and not of(component=None) and not of(e="2") and not of(d={"constants": [1]}) and not of(d={"parameters": ["a"]})
            and not of(field=2)
            and not of(energy=F(4)) and not of(first=[]) and of(num=[2 * c for c in num], den=[2 * c for c in times(M, M)]) == (2, ["said"])
            and not of(num=[*num[:-1], num[-1] + 1]) and not of(num=[num[0] + 1, *num[1:]]))


def squares(m):
    """Sums of n squares of rational numbers"""
    none = m["jets"].no_sum_of_squares

    def sums(n, most=60):
        return {a * a + b * b + c * c for a in range(9) for b in range(9) for c in range(9 if n == 3 else 1)} & set(range(most))
    two = {k for k in range(1, 60) if not none(k, 2)}
    # k d^2 is a sum of two squares only if k is one
    return (two == sums(2) - {0} and {k for k in range(1, 60) if not none(k, 3)} == sums(3) - {0} and not any(none(k, 4) for k in range(60))
            and not none(0, 2) and not none(0, 3) and all(none(-k, n) for k in (1, 5) for n in (2, 3, 4)) and none(3 * 49, 2)
            and not none(9 * 49, 2)
            and none(7 * 64, 3) and not none(2 * 64, 3) and none(999983 * 3, 2) and refused(m, lambda: none(10**12, 4))
            and not none(10**12 - 1, 4))


def certificates():
    """(name, text, is it right?)"""
    one, airy = data("one_energy"), data("../airy-naive")
    obstruction = one["obstruction"]
    yield "another equation", json.dumps(data("one_energy", ("group certificate", airy))), False
    yield "a constant, and a group for one value", json.dumps(data("one_energy",
        ("constants", [{"name": "j", "degree": "2", "value": "5"}]))), False
    # cofactor times the minor is 1, and e is 1495/756
    p, n = int(obstruction["cofactor"][0]), obstruction["cofactor"][1]
    for a, b, right in ((756, -1495, False), (756, -1494, True)):
        given = obstruction | {"value": f"{a}*e - {-b}", "cofactor": [f"{p * a}*e + {p * b}", n]}
        yield f"the value {given['value']}", json.dumps(data("one_energy", ("obstruction", given))), right
    entry = {"columns": ["3"], "cofactor": ["1", "12"], "value": "1", "power": "1"}
    yield "a force of two terms", json.dumps(data("henon_heiles_number", ("obstruction", entry), ("group", {"by": "homogeneous"}))), False


def properties():
    """(name, function, True)"""
    return [(f"infinite_groups.{f.__name__}", f, True) for f in (families, equilibria, cofactors, numbers, energies, squares)]
