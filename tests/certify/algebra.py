"""Properties of function_algebra.py of the Python checker: functions of its modules (sys.modules) that are True.  A tower may
have names that nothing else uses, parameters may have high powers."""


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
    return [(f"algebra.{f.__name__}", f, True) for f in (sums_of_elements, common_factors, derivations, towers)]
