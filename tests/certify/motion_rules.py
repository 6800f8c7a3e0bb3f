"""Properties of motion.py and jet_series.py of the Python checker: functions of its modules (sys.modules) that are True.  Each rule
of jet_certificates.md 4 is asked with what the rules before it are about put there."""
from itertools import combinations

from lowest import refused
from motions import data


def motion(m, h, n=2, denominators=(), constants=(), **line):
    """J1 for H, with the parameters a and b, or None"""
    m["multivariate"].Work.left, found = 10**7, []
    names = [f"{x}{i + 1}" for x in "qp" for i in range(n)]
    d = {"parameters": ["a", "b"], "variables": ["e", "c1", "c2"], "denominators": list(denominators), "constants": list(constants),
         "system": {"coordinates": names[:n], "momenta": names[n:], "hamiltonian": h},
         "line": {"start": ["0", "0"], "across": ["1", "0"], "along": ["0", "1"], "masses": ["1", "1"], "inertias": ["1", "1"]} | line}
    return None if refused(m, lambda: found.append(m["motion"].Motion(d))) else found[0]


def half(potential):
    """(p1^2 + p2^2)/2 + V"""
    return [f"p1^2 + p2^2 + {potential}", "2"]


def same(x, f, text):
    """A polynomial in x and y, which are called c1 and c2, is what the text says"""
    return not f - x.R.read(text)


def charts(m):
    """V at q = start + x across + y along, the forces, and kinetic energy with parameters in it"""
    first = motion(m, half("2*q1^2*q2 - 8*q1*q2 + 8*q2 + 2*q2^3"), start=["2", "0"])
    second = motion(m, half("2*q1^2*q2 - 6*q1^2 + 2*q2^2"), start=["0", "3"])
    mass = motion(m, ["a*p1^2 + p2^2 + 2*q1^2 + 2*q2^3", "2"], denominators=["a"], masses=[["1", "1", "1"], "1"], inertias=["a", "1"])
    wide = motion(m, ["p1^2 + p2^2 + p3^2 + 2*q2^3 + 2*q3^2*q1", "2"], 3)
    if not (first and second and mass and wide):
        return False
    return (same(first, first.potential, "c1^2*c2 + c2^3") and same(first, first.across, "-2*c1*c2")
            and same(first, first.along, "-c1^2 - 3*c2^2") and same(second, second.potential, "c1^2*c2 + c2^2 + 6*c2 + 9")
            and same(mass, mass.across, "-2*c1*a") and same(wide, wide.potential, "c2^3")
            and same(first, first.along.part(first.x, 0), "-3*c2^2") and same(first, first.potential.part(first.y, 1), "c1^2")
            and not any(first.along.part(first.x, i) for i in (-1, 1, 3))
            and motion(m, ["2*p1^2 + p2^2 + 2*q2^3", "2"]) is None and motion(m, ["a*p1^2 + p2^2 + 2*q2^3", "2"]) is None
            and motion(m, ["p1^2 + p2^2 + p1^2*p2 + 2*q2^3", "2"]) is None and motion(m, ["p1^2 + p2^2 + p1*p2^2 + 2*q2^3", "2"]) is None
            and motion(m, ["p1^2 + p2^2 + p3^2 + 2*q2^3 + 2*q3*q1", "2"], 3) is None
            and motion(m, half("2*q1^2*q2^40")) is not None and motion(m, half("2*q1^40*q2")) is not None
            and all(motion(m, half(f)) is None for f in ("2*p1", "2*p1*p2", "2*q1*p2", "2*q2^41", "2*q1^41*q2")))


def constants(m):
    x = motion(m, half("2*q2^3"))

    def free(text, of_e=False):
        return not refused(m, lambda: x.need_free(x.R.read(text), of_e))
    return (free("a") and not free("e") and not free("a*e + 1") and not free("c1") and not free("b*c2") and free("e", True)
            and not free("c2*e", True)
            and not free("c1", True) and not refused(m, lambda: x.constant("a*b")) and refused(m, lambda: x.constant("e"))
            and motion(m, half("2*q2^3"), constants=[{"name": "w", "degree": 3, "value": "a"}]) is not None
            and motion(m, half("2*q2^3"), constants=[{"name": "w", "degree": 3, "value": "c1"}]) is None)


def jets(m, h="2*q2^3", free=True, **more):
    """The Jets of which J1 was checked; free: all series pass for solutions"""
    x = object.__new__(m["motion"].Jets)
    vars(x).update(vars(motion(m, half(h))))
    vars(x).update({"turns": 1} | more)
    if free:
        x.need_solution = lambda *given: None
    return x


def series(m, x, c, end=None):
    return m["jet_series"].Series(x.R, {k: x.R.read(v) for k, v in c.items()}, *([] if end is None else [end]))


def solutions(m):
    """x'' = force as far as x is given, t = s^3; homogeneous coefficients"""
    x = jets(m, free=False, turns=3)

    def solves(c, force, last=9, end=10):
        return not refused(m, lambda: x.need_solution(series(m, x, c, end), series(m, x, force), last))

    def homogeneous(degree, *terms):
        return not refused(m, lambda: x.series((5, list(terms)), degree))
    three = x.series((-2, ["c1", "0", "e*c2"]), 1)
    return (solves({3: "1"}, {4: "1"}) and not solves({3: "1"}, {3: "1"}) and not solves({3: "1"}, {4: "1"}, 10)
            and not solves({3: "1"}, {4: "1"}, 11)
            and solves({6: "1"}, {0: "2"}) and not solves({6: "1"}, {0: "1"}) and not solves({6: "1"}, {}) and solves({}, {}, 99, None)
            and not solves({}, {9: "1"}, 99, None) and solves({}, {4: "a"}) and not solves({}, {3: "a"})
            and homogeneous(1, "c1", "a*c2 + e*c1", "0") and not homogeneous(1, "c1", "c1*c2") and not homogeneous(1, "c1*c2")
            and not homogeneous(2, "c1*c2", "c1") and not homogeneous(1, "c1 + 1") and homogeneous(0, "1", "e^2")
            and x.series(None, 3).zero() and (three.start(), three.end) == (-2, 1) and not three[0] - x.R.read("e*c2"))


def places(m):
    """J2, but that the series is a solution"""
    def accepts(v, low, terms, scale="-6", turns=1, across="", given=True, **more):
        x = jets(m, v + across, turns=turns, **more)
        x.scale = x.constant(scale)
        return not refused(m, lambda: x.need_place({"solution": (low, terms) if given else None}))
    cubic, right = "2*q2^3", ["1", "0", "0", "0", "0", "0", "e"]
    # V = y^3, so that g = -3 y^2, and y = t^-2 + ... + e t^4
    return (accepts(cubic, -2, right, "-2") and not accepts(cubic, -2, right, "2") and not accepts(cubic, -2, right, "-4")
            and not accepts(cubic, -2, ["2", *right[1:]], "-2") and not accepts(cubic, -2, ["0", "1", *right[2:]], "-2")
            and not accepts(cubic, -3, ["1", "1", *right[1:]], "-2") and not accepts(cubic, -2, right[:6], "-2")
            and not accepts(cubic, -2, [*right[:6], "2*e"], "-2")
            and not accepts(cubic, -2, [*right[:6], "1"], "-2") and not accepts(cubic, -2, right, "-2", given=False)
            and not accepts("2*q2^2", -2, right, "-2") and not accepts("2*q2", -2, right, "-2") and not accepts("2", -2, right, "-2")
            # k = 5: two thirds of a turn; with three turns y = s^-2 + ... + e s^8
            and not accepts("2*q2^5", -1, ["1", "0", "0", "0", "e"], ["-2", "5"])
            and accepts("2*q2^5", -2, ["1", *["0"] * 9, "e"], ["-2", "9"], 3)
            and not accepts("2*q2^5", -2, ["1", *["0"] * 9, "e"], ["-2", "5"], 3)
            and accepts("2*q2^4", -1, ["1", "0", "0", "0", "e"], ["-1", "2"])
            and accepts("2*q2^4", -1, ["1", "0", "0", "0", "e"], ["-1", "2"], across=" + 2*q1^2*q2^2")
            and not accepts("2*q2^4", -1, ["1", "0", "0", "0", "e"], ["-1", "2"], across=" + 2*q1^2*q2^3")
            and accepts(cubic, -2, right, "-2", across=" + q1^2*q2") and not accepts(cubic, -2, right, "-2", across=" + q1^2*q2^2"))


def normal(m):
    """J3, but that the series are solutions: the exponents, and a 1 at the beginning"""
    def accepts(*rows, turns=1):
        x = jets(m, turns=turns)
        x.w, x.powers, x.scale = x.R.sum([]), {}, x.one
        return not refused(m, lambda: x.need_normal({"normal": rows})) and x.rho
    one = ["1", "a", "0"]
    return (accepts((-2, one), (3, one)) == [-2, 3] and accepts((0, one), (3, one), turns=3) == [0, 1] and not accepts((-2, one), (4, one))
            and not accepts((3, one), (-2, one)) and not accepts((1, one), (1, one), turns=2) and not accepts((-2, ["2"]), (3, one))
            and not accepts((-2, one), (3, ["a"])) and not accepts((-3, ["0", "1"]), (3, one)) and not accepts(None, (3, one))
            and not accepts((-2, one), None) and not accepts((-2, []), (3, one)) and not accepts((-2, one), (3, [])))


def forms(m):
    """J6: an entry of the form, or a determinant of three columns; the form has r_i at c1^i c2^(4 - i)"""
    r = {i: v for i, v in enumerate((2, -3, 5, 7, 11))}

    def made(columns, alone, form=r):
        x = jets(m, order=3)
        x.form = x.R.read(" + ".join(f"{v}*c1^{i}*c2^{4 - i}" for i, v in form.items() if v > 0) + "".join(
            f" - {-v}*c1^{i}*c2^{4 - i}" for i, v in form.items() if v < 0))
        return lambda value, cofactor="1", power=1: not refused(m, lambda: x.need_minor(
            {"columns": list(columns), "value": value, "cofactor": cofactor, "power": power}, alone))

    def rows(j):
        return (5 - j) * r.get(j - 1, 0), (4 - 2 * j) * r.get(j, 0), (j + 1) * r.get(j + 1, 0)

    def value(columns):
        (a, b, c), (d, e, f), (g, h, i) = map(rows, columns)
        return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    right = all((f := made(columns, False))(str(v)) and not f(str(-v))
                and not f(str(v + 1)) for columns in combinations(range(6), 3) if (v := value(columns)))
    alone, three = made([1], True), made([0, 1, 2], False)
    v = value((0, 1, 2))
    return (right and v and alone("-3") and not alone("3") and alone("9", power=1, cofactor="-3") and alone("3", "-9", 3)
            and alone("e", ["-e", "3"])
            and not alone("c1", ["-c1", "3"]) and not alone("c2", ["-c2", "3"]) and not alone("0", "0") and not made([1, 2], True)("-3")
            and not made([], True)("-3") and not made([1, 1], True)("-3") and not made([1, 0, 2], False)(str(-v))
            and not made([0, 1, 2, 3], False)(str(v)) and not made([0, 1], False)(str(v)) and not three("0", "0")
            and three("a", ["a" if v > 0 else "-a", str(abs(v))]))


def laurent(m):
    """Series with their ends"""
    x = jets(m)
    exact = series(m, x, {})

    def of(c, end=None):
        return series(m, x, c, end)

    def same(f, g):
        return f.end == g.end and f.c.keys() == g.c.keys() and all(not f.c[k] - g.c[k] for k in f.c)
    f, g, big = of({-2: "1", 1: "a"}, 3), of({0: "e", 4: "1"}, 5), of({}, 4)
    whole = of({-1: "2", 2: "1"})
    below = of({-5: "1"}, -2)
    return (same(f, of({-2: "1", 1: "a", 3: "b", 4: "1"}, 3)) and not f[0] - x.R.sum([]) and not exact[7] - x.R.sum([])
            and same(below * exact, exact) and same(exact * below, exact) and not f[1] - x.R.read("a")
            and refused(m, lambda: f[3]) and not refused(m, lambda: f[2]) and exact.zero() and not big.zero() and not whole.zero()
            and same(f * g, of({-2: "e", 1: "a*e", 2: "1"}, 3)) and same(f * whole, of({-3: "2", 0: "2*a + 1"}, 2))
            and same(whole * whole, of({-2: "4", 1: "4", 4: "1"})) and same(f * exact, exact) and same(exact * f, exact)
            and same(exact * exact, exact)
            and same(big * f, of({}, 2)) and same(f * big, of({}, 2)) and same(f * 0, exact) and same(f * 2, of({-2: "2", 1: "2*a"}, 3))
            and same(f + g, of({-2: "1", 0: "e", 1: "a"}, 3)) and same(f - f, of({}, 3)) and not f.coefficient(exact, 99)
            and not exact.coefficient(f, 99)
            and not f.coefficient(g, 2) - x.R.one and refused(m, lambda: f.coefficient(g, 3))
            and not whole.coefficient(whole, 99) - x.R.sum([])
            and same(f.derivative(3), of({-5: ["-2", "3"], -2: ["a", "3"]}, 0)) and same(whole.derivative(1), of({-2: "-2", 1: "2"}))
            and (f.start(), big.start(), exact.start()) == (-2, 4, m["jet_series"].EXACT))


def polynomials(m):
    """By degree in c1 and c2: a x + x^2 y + 7 y for x = f + g, y = h + f, each in two degrees; and a polynomial in y alone"""
    x = jets(m)
    f, g, h = (series(m, x, c) for c in ({0: "1", 1: "2"}, {0: "3"}, {2: "5"}))
    none, Jet = series(m, x, {}), m["jet_series"].Jet
    known = {x.x: {1: Jet([f, g, none])}, x.y: {1: Jet([h, f, none])}}
    value = x.put(x.R.read("7*c2 + c1^2*c2 + a*c1"), known, lambda k: Jet([k, none, none]))
    expected = [h * 7 + f * f * h + f * x.R.read("a"), f * 7 + f * g * h * 2 + f * f * f + g * x.R.read("a"), g * g * h + f * f * g * 2]
    line = x.put(x.R.read(["3*c2^2 - e*c2 + a", "2"]), {x.y: {1: f}}) * 2 - (f * f * 3 - f * x.R.read("e") + x.number(x.R.read("a")))
    return len(value.parts) == 3 and not line.c and all(not (u - v).c and u.end == v.end for u, v in zip(value.parts, expected))


def reading(m):
    """Sizes and numbers of a certificate"""
    read, m["multivariate"].Work.left = m["jets_format"].read_jets, 10**7

    def accepts(*rows):
        return not refused(m, lambda: read(data("henon_heiles_number", *rows)))

    def divided(v):
        d, found = data("henon_heiles_number", ("system hamiltonian", v)), []
        return not refused(m, lambda: found.append(m["jets_format"].hamiltonian(d))) and found[0][1]
    three = data("henon_heiles_number")["place"]["normal"]
    return (accepts() and not accepts(("place normal +", three[0])) and not accepts(("place normal 1",))
            and not accepts(("place turns", "0"))
            and not accepts(("place turns", "-1")) and accepts(("place turns", "1")) and not accepts(("jets order", "1"))
            and accepts(("obstruction columns", ["0", "4"])) and not accepts(("obstruction columns", ["-1", "4"]))
            and divided("p1^2") == divided(["p1^2", "1"]) == 1 and divided(["p1^2", "2"]) == 2
            and not any(map(divided, (["p1^2", "0"], ["p1^2", "-1"], ["p1^2"], ["p1^2", "1", "1"], ["p1^2", ["1"]]))))


def shown(m):
    """An element over its denominators, and over a number"""
    x = motion(m, half("2*q2^3"), denominators=["a", "b + 1", "2"])
    show = m["jets_format"].Shown(x.d, x.R).element
    return [show(v) for v in ("a*e + c1", ["a", "2"], ["a", "1", "0", "1"], ["a - e", "3", "2", "1", "3"], ["a", "1", "0", "0", "2"])] == [
        "e*a + c1", "(a)/(2)", "(a)/((b + 1))", "(-e + a)/(3*(a)^2*(b + 1)*(2)^3)", "(a)/((2)^2)"]


def errors(m):
    """What goes wrong in the rules is a refusal."""
    jets, top = m["jets"], data("cubic")
    true = jets.Jets

    def fails(error):
        def raising(d):
            raise error("no")
        jets.Jets = raising
        return refused(m, lambda: jets.verify(top, None))
    try:
        return all(map(fails,
                       (ZeroDivisionError, OverflowError, ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError,
                        MemoryError)))
    finally:
        jets.Jets = true


def properties():
    """(name, function, True)"""
    return [(f"motion_rules.{f.__name__}", f, True) for f in (charts, constants, solutions, places, normal, forms, laurent, polynomials,
        reading,
                                                              shown, errors)]
