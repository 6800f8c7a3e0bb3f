"""Properties of function_algebra.py of the Python checker: functions of its modules (sys.modules) that are True.  A tower may
have names that nothing else uses, parameters may have high powers."""
from fractions import Fraction as F


def algebra(m, tower, denominators=("z", "A*z + A", "6")):
    m["multivariate"].Work.left = 10**7
    curve = {"variable": "z", "denominators": list(denominators),
             "tower": [{"name": n, "degree": d, "value": v, "derivative": w} for n, d, v, w in tower]}
    return m["function_algebra"].FunctionAlgebra(curve, ["A", "B", "C"])


def refused(m, tower, denominators=("z", "A*z + A", "6")):
    try:
        algebra(m, tower, denominators)
    except (m["certificate_format"].Rejected, m["certificate_format"].Malformed, AttributeError):
        return True
    return False


def square_root(m):
    return algebra(m, [("u", 2, "z", ["u", "2", "1"])])


def same(R, f, g):
    return not R.read(f) - R.read(g)


def sums_of_elements(m):
    R = square_root(m)
    f, g = R.read("A^3*B^2*u + C^2*z^5 - z^2"), R.read("A^3*B^2*u - C^2*z^5 + z^2")
    return (not f * g - R.read("A^6*B^4*z - C^4*z^10 + 2*C^2*z^7 - z^4") and bool(f * g) and not f - f and bool(f + f)
            and not R.read("u")**3 - R.read("z*u") and not (f + R.sum([])) - f and not (R.sum([]) + f) - f)


def common_factors(m):
    R = square_root(m)
    return (same(R, ["A*z*u + A*u + z*A + A", "1", "0", "1"], "u + 1") and same(R, ["u + z", "1", "1"], ["z*u + z^2", "1", "2"])
            and not same(R, ["A*z*u + A*u + A^2*z + A^2", "1", "0", "1"], "u + 1") and same(R, ["2*u", "6"], ["u", "3"])
            and same(R, ["u + 1", "1", "0", "0", "2"], ["u + 1", "36"]) and not same(R, ["u", "1", "1"], "u"))


def derivations(m):
    R = square_root(m)
    f = R.read(["u + z^3", "1", "2", "1"]).derivative()      # (u + z^3)/(z^2 A (z + 1))
    g = R.read(["u*z + u + 6*z^4 + 6*z^3 - 4*u*z - 4*u - 4*z^4 - 4*z^3 - 2*z*u - 2*z^4", "2", "3", "2"]) * R.read("A")
    return not f - g and not R.read("B^2*A").derivative() and bool(f)


def substitutions(m):
    """Elements and functions for the names of a polynomial, each of which has one; numbers, parts, determinants"""
    R, parse, P = square_root(m), m["multivariate"].parse, m["multivariate"].P
    f, x, y = parse("3*x^2*y - 5*y^3 + 7*x^4 + 2", {"x": 0, "y": 96}), R.read(["u + z", "1", "1"]), R.read("A - u")
    put, known = R.put_in(f, 6, {0: {1: x}, 96: {1: y}}) * 6, {0: {1: R.sum([])}, 96: {1: y}}
    tower, Function, powers = m["tower"], m["tower"].Function, {1: 2}

    def composed(*given):
        return tower.compose(Function(f, 6), {k: Function(parse(v, R.names), n) for k, v, n in given})
    half, one = composed((0, "A + z", 2), (96, "B", 3)), R.one
    rows = [[R.read(v) for v in row.split()] for row in ("u A z", "1 B u", "z^2 u 3")]
    a, b, c = rows
    raised = m["multivariate"].raised
    return (not put - (x * x * y * 3 - y**3 * 5 + x**4 * 7 + one * 2) and not R.put_in(f, 1, known) - (one * 2 - y**3 * 5)
            and refuses(m, lambda: R.put_in(f, 1, {0: {1: x}})) and refuses(m, lambda: composed((0, "A", 1)))
            and not half - (Function(parse("A^2*B + 2*A*z*B + z^2*B", R.names), 24) - Function(parse("5*B^3", R.names), 162)
                            + Function(parse("7*A^4 + 28*A^3*z + 42*A^2*z^2 + 28*A*z^3 + 7*z^4", R.names), 96) + Function(parse("1", R.names), 3))
            and not R.determinant(rows) - (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                                           + a[2] * (b[0] * c[1] - b[1] * c[0])) and not R.determinant([]) - one
            and [v.number() for v in (one * 3, R.sum([]), R.read(["7", "2"]), R.read(["1", "1", "1"]), x, R.read("C"))] == [3, 0, F(7, 2), None, None, None]
            and [v.in_tower() for v in (one, x, R.sum([]), R.read("C"))] == [False, True, False, False]
            and raised(powers, 13) == 2**13 and all(v == 2**k for k, v in powers.items())
            and P(f).parts((1 << 32) - 1) == {0: parse("2 - 5*y^3", {"y": 96}), 2: parse("3*y", {"y": 96}), 4: {0: 7}})


def norms(m):
    """Determinants of multiplications, and which of them are 0 for no value of the parameters and all z"""
    R, multivariate = algebra(m, [("u", 2, "z", ["u", "2", "1"]), ("v", 3, "A", "0")]), m["multivariate"]

    def poly(text):
        return multivariate.parse(text, R.names)

    def norm(v, text):
        return multivariate.ratio(R.norm(R.read(v)), poly(text)) not in (None, 0)

    def unit(text, *where):
        return R.is_unit(poly(text), list(map(poly, where)))
    return (norm("u + v", "A^2 - z^3") and norm("2*u*v", "z^3*A^2") and norm("B + v", "B^6 + 2*A*B^3 + A^2") and norm("B", "B")
            and norm(["u + v", "3", "2", "1"], "A^2 - z^3") and not R.norm(R.sum([])) and unit("z^2*A + z^3*A") and unit("B*z + 2") and not unit("B*z")
            and unit("B*z", "B") and not unit("B*z + C", "B") and not unit("0") and unit("7") and R.names_in("C + v") == {"A", "C", "v"}
            and R.names_in(["B", "1", "0", "1"]) == {"A", "B", "z"} and refuses(m, lambda: R.row(["1", "u"], 3)) and len(R.row(["1", "u"], 2)) == 2)


def refuses(m, f):
    try:
        f()
    except m["certificate_format"].Rejected:
        return True
    return False


def towers(m):
    right = ["u", "2", "1"]                                 # u' = u/(2 z)
    low = [("u", 2, "z", right), ("v", 2, "A", "0"), ("w", 2, "B", "0"), ("x", 2, "w*v", "0")]
    return (not refused(m, low) and refused(m, [("u", 2, "z", "0")]) and refused(m, [("u", 2, "z", ["u", "1", "1"])])
            and not refused(m, [("u", 3, "z", ["u", "3", "1"])]) and refused(m, [("u", 3, "z", right)])
            and refused(m, [("v", 2, "u", "0"), ("u", 2, "A", "0")]) and refused(m, [("u", 2, "u^2", "0")])
            and not refused(m, [("u", 2, "2*u - 1", "0")]) and refused(m, [("u", 1, "1", "0")])
            and refused(m, [], ["0"]) and not refused(m, [], ["1"]))


def properties():
    """(name, function, True)"""
    return [(f"algebra.{f.__name__}", f, True) for f in (sums_of_elements, common_factors, derivations, substitutions, norms, towers)]
