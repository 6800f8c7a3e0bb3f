"""Properties of jet_series.py and jets.py of the Python checker: functions of its modules (sys.modules) that are True."""
import algebra


def refused(m, f):
    try:
        f()
    except m["certificate_format"].Rejected:
        return True
    return False


def series(m):
    R, S = algebra.square_root(m), m["jet_series"].Series

    def of(c, *end):
        return S(R, {k: R.read(x) for k, x in c.items()}, *end)

    def same(f, c, end=m["jet_series"].EXACT):
        g = of(c, end)
        return f.end == end and f.c.keys() == g.c.keys() and not any(f.c[k] - g.c[k] for k in g.c)
    f, g, exact, zero = of({-2: "1", 1: "u"}, 3), of({-1: "A", 0: "-1", 4: "1"}, 2), of({1: "B", 2: "2"}), S(R)
    return (same(f, {-2: "1", 1: "u"}, 3) and same(g, {-1: "A", 0: "-1"}, 2) and same(of({2: "0", 1: "1"}), {1: "1"})
            and zero.zero() and not exact.zero() and not of({}, 5).zero() and of({}, 5).start() == 5 and f.start() == -2
            and same(f + g, {-2: "1", -1: "A", 0: "-1", 1: "u"}, 2) and same(f - g, {-2: "1", -1: "-A", 0: "1", 1: "u"}, 2)
            and same(exact + exact, {1: "2*B", 2: "4"}) and same(exact - exact, {}) and same(f + zero, {-2: "1", 1: "u"}, 3)
            and same(f * g, {-3: "A", -2: "-1"}, 0) and same(g * f, {-3: "A", -2: "-1"}, 0) and same(f * exact, {
                -1: "B", 0: "2", 2: "u*B", 3: "2*u"}, 4) and same(exact * exact, {2: "B^2", 3: "4*B", 4: "4"}) and (f * zero).zero()
            and (zero * f).zero() and (f * 0).zero() and same(f * 3, {-2: "3", 1: "3*u"}, 3)
            and same(of({0: "1", 1: "u"}, 4) * of({0: "1", 1: "-u"}, 4), {0: "1", 2: "-z"}, 4)
            and not f[1] - R.read("u") and not f[2] and not f[-7] and refused(m, lambda: f[3]) and not exact[100]
            and not f.coefficient(g, -3) - R.read("A") and not f.coefficient(g, -1) and refused(m, lambda: f.coefficient(g, 0))
            and not f.coefficient(exact, 3) - R.read("2*u") and not f.coefficient(zero, 50) and not zero.coefficient(f, 50)
            and same(f.derivative(1), {-3: "-2", 0: "u"}, 2) and same(f.derivative(3), {-5: ["-2", "3"], -2: ["u", "3"]}, 0)
            and same(exact.derivative(2), {-1: ["B", "2"], 0: "2"}))


def sums_of_squares(m):
    """Three squares: not 4^a (8 b + 7); two: no prime 4 k + 3 to an odd power"""
    none = m["jets"].no_sum_of_squares
    squares = [i * i for i in range(31)]
    two = {a + b for a in squares for b in squares}
    three = {a + b for a in two for b in squares}
    return (all(none(n, 2) == (n not in two) and none(n, 3) == (n not in three) and not none(n, 4) and not none(n, 5) for n in range(900))
            and all(none(-1, n) and none(-49, n) for n in (2, 3, 4, 5)) and none(3 * 10**10, 2) and none(10**12 - 1, 3)
            and refused(m, lambda: none(10**12, 2)))


def properties():
    """(name, function, True)"""
    return [(f"laurent.{f.__name__}", f, True) for f in (series, sums_of_squares)]
