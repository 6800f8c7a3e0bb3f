"""Properties of strata_leaves.py of the Python checker, functions of its modules (sys.modules) that are True: the places of a leaf
(strata_certificates.md 7.1 to 7.3, 7.5).  leaf_certificates.py has such leaves as certificates."""
from fractions import Fraction as F

from lowest import refused


def state(m, num="1", den="1", real=("a", "b"), membership=None, **signs):
    """What is known of a and b: signs, as nonzero=["a"], and that a fraction is an integer"""
    M = m["multivariate"]
    M.Work.left = 10**7
    names = {x: M.FIELD * (i + 1) for i, x in enumerate("ab")}
    s = m["stratum"].Stratum("z", names, {names[x] for x in real}, set(), num, den)
    for sign, fs in signs.items():
        for f in fs:
            s = s.also((s.poly(f), sign))
    if membership:
        s.integers.append((tuple(map(s.poly, membership)), True))
        s = s.also(units=[s.integers[0][0][1]])
    return s


def said(given):
    return {"chi": None, "irrational": None, "log": None, "bound": None} | given


def leaf(m, s, *places, by="torus-log", infinity=(), content="1", absent=None):
    """The Leaf for places (q, order, what is said of it), or None if it is refused"""
    rows, found = [said(more) | {"q": q, "order": order} for q, order, more in places], []
    d = {"by": by, "content": content, "places": rows, "infinity": said(dict(infinity)), "absent": absent, "growth": None}
    return None if refused(m, lambda: found.append(m["strata_leaves"].Leaf(s, d))) else found[0]


def bare(m, s=None, by="torus-log", **more):
    """A Leaf of which nothing was checked"""
    x = object.__new__(m["strata_leaves"].Leaf)
    vars(x).update({"s": s or state(m), "by": by, "absent": {}} | more)
    return x


def meeting(m):
    """Places and their roots stay apart, and orders do not drop"""
    def accepts(num, den, *places, infinity=(), **known):
        return leaf(m, state(m, num, den, **known), *places, infinity=infinity) is not None
    two, apart = ("z^2 - a", 1, {}), [("z", 1, {}), ("z - a", 1, {})]
    free = {"chi": ["-1", "1"]}
    return (accepts("z + b", "z^2 - a", two, nonzero=["a", "b^2 - a"]) and not accepts("z + b", "z^2 - a", two, nonzero=["b^2 - a"])
            and not accepts("z + b", "z^2 - a", two, nonzero=["a"])
            and accepts("z^4 + 1", "z^2 - a*z", *apart, nonzero=["a", "a^4 + 1"])
            and not accepts("z^4 + 1", "z^2 - a*z", *apart, nonzero=["a^4 + 1"])
            and not accepts("z^4 + 1", "z^2 - a*z", *apart, nonzero=["a"])
            and accepts("1", "z^4 - 2*z^3 + z^2", ("z", 2, {"chi": ["-5", "1"]}), ("z - 1", 2, {"chi": ["-5", "1"]}))
            and not accepts("0", "z^4 - 2*z^3 + z^2", ("z", 2, free), ("z - 1", 2, free))
            and accepts("a*z + 1", "z", ("z", 1, {}), nonzero=["a"], infinity={}) and not accepts("a*z + 1", "z", ("z", 1, {})))


def orders(m):
    """What may be said of a place of each order"""
    def accepts(k, **more):
        x = leaf(m, state(m, "1", f"z^{k}"), ("z", k, more))
        return x and (x.local.finite[0].logs, x.local.finite[0].irrational, x.local.finite[0].delta)
    return (accepts(1) == (1, False, 1) and accepts(1, log=True) == (1, False, 1) and accepts(3) == (0, False, None)
            and accepts(3, log=True) is None and accepts(4, log=True) is None and accepts(1, chi=["-1", "1"]) is None
            and accepts(1, bound=F(1)) is None and accepts(3, irrational="constant") is None)


def kinds(m):
    """Delta, what is irrational or open, the bounds and the logarithms of a regular place: Delta^2 = 1 + 4c at the root of z"""
    def of(c, chi=None, by="torus-log", **more):
        signs = {k: more.pop(k) for k in ("positive", "nonzero", "real") if k in more}
        x = leaf(m, state(m, f"z + {c}", "z^2", **signs), ("z", 2, {"chi": chi} | more), by=by)
        if x is None:
            return None
        x, = x.local.finite
        return x.delta, x.irrational, x.open, x.real, x.b, x.logs
    a = ["-4*a - 1", "1"]
    squared, other = ["16*a^2 + 8*a + 1", "-8*a - 2", "1"], ["16*a^2 + 8*a + 2", "-8*a - 2", "1"]
    is_open, below, signs = (None, True, True, None, None, 0), (None, True, False, F(0), None, 0), ["16*a^2 + 8*a + 1", "-8*a - 2", "1"]
    return (of("2", ["-9", "1"]) == of("2", ["-18", "2"]) == (3, False, False, 3, None, 0) and of("2", ["9", "1"]) is None
            and of("2", ["-9", "1"], irrational="constant") is None
            and of("1", ["-5", "1"], irrational="constant") == (None, True, False, F(9, 4), None, 0)
            and of("a", a) == of("a", a, "open") == of("a") == of("a", by="irreducible-log") == of("a", squared) == is_open
            and of("a", by="open") is None and of("a", squared, "one-open") is None and of("a", other) is None
            and of("a", ["-4*a^2 - a", "a"]) is None and of("a", ["-4*a^2 - a", "a"], nonzero=["a"]) == is_open
            and of("a", []) is None and of("a", ["1"]) is None and of("a", ["0", "0"]) is None
            and of("a", a, bound=F(2), positive=["1 - 4*a"]) == (None, True, True, F(3, 2), F(3, 2), 0)
            and of("a", a, bound=F(2)) is None and of("a", bound=F(2)) is None and of("a", squared, bound=F(0)) is None
            and of("a", a, irrational="positive", positive=["-4*a - 1"]) == below and of("a", a, irrational="positive") is None
            and of("a", squared, irrational="positive", positive=signs) == (None, True, False, None, None, 0)
            and of("a", a, irrational="constant") is None and of("a", a, irrational="faith", positive=["-4*a - 1"]) is None)


def logs(m):
    """A logarithm at a place of one root whose Delta is 0, or a natural number with a defect that is not 0"""
    def at(num, den, q, square, content="1", **more):
        x = leaf(m, state(m, num, den, nonzero=["a"]), (q, 2, {"chi": [str(-square), "1"]} | more), content=content)
        return x and x.local.finite[0].logs
    two = "z^4 - 2*z^2 + 1"
    return (at("z - 1", "4*z^2", "z", 0, "4") == at("z - 1", "4*z^2", "z", 0, "4", log=True) == 1
            and at("z^3 - z - 1", two, "z^2 - 1", 0) == at("z^3 - z - 1", two, "z^2 - 1", 0, log=True) == 2
            and at("z^3 + a*z", "z^2", "z", 1, log=True) == 1 and at("z^3 + b*z", "z^2", "z", 1, log=True) is None
            and at("z^3 + a*z", "z^2", "z", 1) == 0 and at("z^3 - z", two, "z^2 - 1", 1, log=True) is None
            and at("z^3 - z", two, "z^2 - 1", 1) == 0)


def signs(m):
    """What is real, a bound of Delta^2 = -a0/a1, and no root that is a square"""
    s = state(m, real="a", positive=["a", "b", "4*a - 1", "4*b - 1"])
    x = bare(m, s)
    a, b, one, zero = (s.poly(f) for f in ("a", "b", "1", "0"))

    def squares(positive, f):
        s = state(m, real="a", positive=positive)
        return bare(m, s).is_bound(F(1), zero, s.poly(f))

    def why(reason, *chi):
        found = []
        return not refused(m, lambda: found.append(x.is_irrational(reason, chi, None))) and found[0]
    turned = bare(m, state(m, real="a", positive=["-b^2"]))     # b = i: b (T - 1)(T - 4) and b T (T - 1) have real roots
    return (s.is_real(a) and s.is_real(one) and s.is_real(b * -2) and not s.is_real(b * b) and not s.is_real(a * b)
            # Delta^2 = 2/3
            and x.is_bound(F(2, 3), b * -2, b * 3) and x.is_bound(F(2, 3), a * -2, a * 3) and not x.is_bound(F(1, 3), b * -2, b * 3)
            # of Delta^2 = 0, where a^2 or b^2 is positive: a is real, and -b known to be so by its sign
            and squares(["a^2"], "a") and squares(["b^2", "-b"], "b") and not squares(["b^2"], "b") and not squares(["-b"], "b")
            and why("positive", a, b) and why("positive", a * -1, b * -1) and not why("positive", a, b * -1)
            and not why("positive", a, zero)
            and why("discriminant", a, one, one) and not why("discriminant", a, a * -1, one) and not why("discriminant", a, one, one, one)
            and not why("discriminant", a, one) and not why("discriminant", one, b, one) and not why("square", a, one, one)
            and all(refused(m, lambda chi=chi: turned.is_irrational("discriminant", chi, None)) for chi in ([b * 4, b * -5, b], [zero, b * -1, b]))
            and why("discriminant", b, one, one) and not why("discriminant", b + one, one, one))


def properties():
    """(name, function, True)"""
    return [(f"places_of_leaves.{f.__name__}", f, True) for f in (meeting, orders, kinds, logs, signs)]
