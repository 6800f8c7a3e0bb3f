"""Properties of tower.py and map.py of the Python checker: functions of its modules (sys.modules) that are True.
Whole theorems take longer than a mutant is given."""

SHOWN = {"node": "empty", "terms": [["1", "1"]], "zeros": [["1", "-1"]]}                # of 1
OF_A = {"node": "empty", "terms": [["1", "1", ["0", "1"]]], "zeros": [["1", "-1"]]}     # of a, which is assumed positive
IDLE = {"node": "empty", "terms": [["1", "1"]], "zeros": []}
CANONICAL = [["q1", "p1", "1"], ["q2", "p2", "1"]]
WEIGHTS, LOW = [2, 2, 3, 3], "p1^2 + p2^2 + q1^3 + q2^3"


def refused(m, f):
    try:
        f()
    except (m["certificate_format"].Rejected, m["certificate_format"].Malformed):
        return True
    return False


def roots(m):
    m["multivariate"].Work.left = 10**6
    t = m["tower"].Tower({"a": 0})
    if t.roots:
        return False
    t.adjoin("u", h=t.read("a + 1").p)
    if t.roots:
        return False
    t.adjoin("s", square=t.read(["a", "3"]))
    t.adjoin("r", square=t.read("s + u"))

    def zero(text):
        return t.is_zero(t.read(text).p, len(t.steps))
    names = refused(m, lambda: t.adjoin("s", square=t.read("2"))) and refused(m, lambda: t.adjoin("1s", square=t.read("2")))
    yes = ("0", "u*a + u - 1", "3*s^2 - a", "9*s^4 + 6*s^2 - a^2 - 2*a", "3*s^3 - s*a", "r^2 - s - u", "r^2*a + r^2 - s*a - s - 1",
           "3*r^4 - a - 6*s*u - 3*u^2", "r^3 - r*s - r*u", "2*u^2*a^2 + 4*u^2*a + 2*u^2 - 2")
    no = ("1", "a", "u*a - 1", "u*a + u + 1", "s^2 - a", "3*s^2 - a + s", "3*s^2 + a", "9*s^4 - 6*s^2 - a^2 - 2*a", "r^2 - s",
          "r^2 - s + u", "r - s", "r^2 - s - u + r", "3*s^3 + s*a", "r^3 - r*s", "u - s")
    t.adjoin("w", h=t.read("a^2 + 1").p)
    names = names and refused(m, lambda: t.need_zero(t.read("s"), ""))
    return t.roots and names and all(map(zero, yes)) and not any(map(zero, no))


def family(m, h, inverses=(), brackets=None, parameters=("a",), assumed=("a",), coordinates=("q1", "q2", "p1", "p2")):
    system = {"coordinates": list(coordinates), "functions": [], "relations": [], "field": None, "hamiltonian": h,
              "inverses": [{"name": u, "of": f} for u, f in inverses], "brackets": brackets or CANONICAL}
    return m["family"].Family({"name": "X", "parameters": list(parameters), "system": system,
                              "assumptions": [{"p": p, "sign": "positive"} for p in assumed]})


def lowest(m, x, y, weights=None, degree=6, units=(), orders=()):
    """x and y: of what family() makes a system"""
    m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 10**7, 1000

    def of(v):
        return family(m, v) if isinstance(v, str) else family(m, **v)
    d = {"weights": weights or WEIGHTS, "degree": degree, "units": list(units),
         "orders": [dict(zip(("inverse", "order", "part", "by"), row)) for row in orders]}
    return not refused(m, lambda: m["rule_lowest_order"].region_of(of(x), of(y), d, []))


def weights(m):
    def accepts(x, y=LOW, **more):
        return lowest(m, x, y, **more)
    one = {"h": "p1^2 + q1^2 + p2*q2"}
    other = {"h": LOW, "brackets": [["q1", "p1", "2"], ["q2", "p2", "2"]]}
    curved = {"h": "p1^2 + q1^2 + p2", "brackets": [["q1", "p1", "1"], ["q2", "p2", "q2"]]}
    return (accepts(LOW + " + q1^4 + a*p1^2*q2") and not accepts(LOW + " + q1*p1*a") and not accepts(LOW + " + q1^4 + q1^2")
            and not accepts(LOW, LOW + " + q1^4") and not accepts("2*p1^2 + p2^2 + q1^3 + q2^3") and not accepts(LOW + " + q1^4", degree=5)
            and not accepts(LOW, "p1^4", degree=12) and accepts(one, one, weights=[1] * 4, degree=2)
            and accepts(LOW, weights=[40, 40, 60, 60], degree=120) and not accepts(LOW, weights=[2, 2, 3]) and not accepts(LOW, weights=[*WEIGHTS, 1])
            and not accepts("p1^2 + q1^2 + q1^3", "p1^2 + q1^2", weights=[3, 0, 3, 6])
            and not accepts("p1^2 + q1^3 + p2^2", "p1^2 + q1^3", weights=[2, 2, 3, 4])
            and accepts(curved, curved, weights=[1, 3, 1, 2], degree=2) and not accepts(curved, curved, weights=[1, 2, 1, 3], degree=2)
            and accepts(other, other) and not accepts(LOW, other)
            and not accepts({"h": LOW, "coordinates": ["q1", "q2", "p1", "p2"]}, {"h": LOW, "coordinates": ["q2", "q1", "p1", "p2"]})
            and not accepts(LOW, {"h": LOW, "parameters": [], "assumed": []}) and not accepts({"h": LOW, "assumed": []})
            and not accepts(LOW, {"h": LOW, "assumed": ["a", "a + 1"]}) and accepts(LOW, {"h": LOW, "assumed": []}))


def denominators(m):
    x = {"h": "u*q1^3 + u*q2^3 + u*p1^2 + u*p2^2", "inverses": [("u", "q2 + 1")]}
    beyond = x | {"h": LOW + " + u*q1^4*q2"}
    zero = {"h": "u*q2*q1^3 + u*a*q1^4 + u*q2*p1^2 + u*a*q1*p1^2 + u*q1^4*q2", "inverses": [("u", "q2 + a*q1")]}
    high = zero | {"h": zero["h"].replace("u*q1^4*q2", "u*q1^4*a")}
    of_a = {"h": "u*a*q1^4 + u*a*q1*p1^2 + u*q1^4*q2", "inverses": [("u", "a*q1 + q2^2")]}
    two = {"h": "u*w*p1^2 + u*q1^3", "inverses": [("u", "q2 + 1"), ("w", "a")]}
    over = {"h": "w*p1^2 + q1^3", "inverses": [("w", "a")]}
    mixed = {"h": LOW, "inverses": [("u", "a")], "brackets": [["q1", "p1", "1"], ["q2", "p2", "u"]]}
    moving = {"h": "u*p1^2 + q1^3", "inverses": [("u", "q2 + a")]}
    cubic = "q1^3 + p1^2"
    u, w = ("u", 0, "1", SHOWN), ("w", 0, "a", OF_A)

    def accepts(x, y, *orders, **more):
        return lowest(m, x, y, orders=orders, **more)
    return (accepts(x, LOW, u) and not accepts(x, LOW) and not accepts(x, LOW, ("u", 0, "2", SHOWN))
            and not accepts(x, LOW, ("u", 0, "1", IDLE)) and not accepts(x, LOW, ("w", 0, "1", SHOWN)) and not accepts(x, LOW, u, u)
            and not accepts(x, LOW + " + q1^3", u) and accepts(beyond, LOW, u) and not accepts(beyond, LOW, ("u", 2, "1", SHOWN))
            and not accepts(beyond, LOW, ("u", 1, "1", SHOWN))
            and accepts(zero, cubic, ("u", 2, "1", SHOWN)) and accepts(zero, cubic, ("u", 2, "a", OF_A))
            and not accepts(high, cubic, ("u", 2, "1", SHOWN)) and not accepts(zero, cubic, ("u", 0, "1", SHOWN))
            and accepts(of_a, cubic, ("u", 2, "a", OF_A)) and not accepts(of_a | {"assumed": []}, {"h": cubic, "assumed": []}, (
                "u", 2, "a", OF_A)) and not accepts(of_a | {"assumed": []}, {"h": cubic, "assumed": []}, ("u", 2, "1", SHOWN | {"zeros": [["0", "-1"]]}))
            and accepts(two, over, u, w, units=[OF_A]) and not accepts(two, over, u, w, units=[IDLE]) and not accepts(two, over, u, w)
            and not accepts(two, over, w, u, units=[OF_A]) and not accepts(mixed, mixed, ("u", 0, "a", OF_A), units=[OF_A])
            and not accepts(moving, moving, ("u", 0, "a", OF_A), units=[OF_A]))


def properties():
    """(name, function, True)"""
    return [(f"lowest.{f.__name__}", f, True) for f in (roots, weights, denominators)]
