"""Certificates by hand, true ones beside false ones that a plausible mistake in a rule would accept: a sign, a factor that
occurs twice, v = 0, a power instead of its root, an annihilator of something else.  certificates() yields what is
stated, the text and whether it is right."""
import json
from fractions import Fraction as F

PRIME = {"p": "1009", "a": "0"}
Z = ["0", "1"]
AIRY, EULER = (Z, ["1"]), (["1"], ["0", "0", "1"])              # y'' = z y; z^2 y'' = y: Delta^2 = 5
AT_ZERO = {"q": Z, "order": "2", "delta2": ["5"]}


def certificate(equation, claim, *steps):
    rows = [{"id": f"s{i}", "rule": rule, "premises": premises, "data": data} for i, (rule, premises, data) in enumerate(steps)]
    return json.dumps({"format": "kovacic-certificate/1", "field": {"name": "", "minpoly": ["0", "1"]},
                       "r": dict(zip(("num", "den"), equation)), "steps": rows,
                       "claim": {k: claim.get(k) for k in ("group", "n", "component", "abelian")}})


def local(*places):
    return "local", [], {"prime": PRIME, "places": list(places), "infinity": {}}


def invariant(m, p=("1",), *factors):
    return "invariant", [], {"prime": PRIME, "m": str(m), "p": list(p), "factors": [{"q": list(q), "e": e} for q, e in factors]}


def exponential(p, num, den):
    return "exponential", [], {"p": list(p), "num": list(num), "den": list(den)}


def conclude(theorem, *premises):
    return "conclude", [f"s{i}" for i in premises], {"theorem": theorem}


def abelian(equation, *v):
    return certificate(equation, {"abelian": True}, invariant(*v), conclude("invariant-abelian", 0))


def diagonal(equation, group, n, place, *v):
    claim = {"group": group, "n": n}
    return certificate(equation, claim, local(*place), invariant(2, *v), conclude("diagonal", 0, 1))


def solutions():
    yield "v = 0 solves everything", abelian(AIRY, 2, []), False
    yield "constants are not invariants", abelian(AIRY, 0), False
    no_invariant = ("no-invariant", ["s0"], {"m": "2", "by": "degree"})
    for p, num, den in ((["1"], ["1"], ["1"]), (["1"], [], ["1"]), (["1"], Z, ["1"]), ([], ["1"], ["1"]), (["1"], [], [])):
        yield "not a solution of Airy's equation", certificate(
            AIRY, {"group": "Borel"}, local(), exponential(p, num, den), no_invariant, conclude("borel", 0, 1, 2)), False
    for m, right in ((1, True), (200, True), (201, False)):
        yield f"v = 1 where r = 0, m = {m}", abelian(([], ["1"]), m), right
    yield "r = 0", diagonal(([], ["1"]), "cyclic", "1", [], Z), True
    yield "r = 0 over z", abelian(([], Z), 1), False
    two = ["2"], ["0", "0", "1"]
    yield "y = z^2", abelian(two, 1, ["1"], (Z, "2")), True
    yield "y = 1/z", abelian(two, 1, ["1"], (Z, "-1")), True
    nine = [AT_ZERO | {"delta2": ["9"]}]
    yield "w = 0 where v = y^2", diagonal(two, "cyclic", "1", nine, ["1"], (Z, "4")), False
    yield "y1 y2 = z", diagonal(two, "cyclic", "1", nine, ["1"], (Z, "1")), True
    yield "a place is not in the list", diagonal(two, "cyclic", "1", [], ["1"], (Z, "1")), False


def factors():
    yield "y1 y2 = z", diagonal(EULER, "Gm", None, [AT_ZERO], ["1"], (Z, "1")), True
    yield "infinity shows the torus", diagonal(EULER, "Gm", None, [{"q": Z, "order": "2"}], ["1"], (Z, "1")), True
    yield "z = sqrt(z) sqrt(z) does not branch", certificate(
        EULER, {"group": "Dinf"}, local(AT_ZERO), invariant(2, ["1"], (Z, "1/2"), (Z, "1/2")), conclude("dihedral-infinite", 0, 1)), False
    yield "2 z is not monic", diagonal(EULER, "Gm", None, [AT_ZERO], ["1"], (["0", "2"], "1")), False
    for q in (["1"], ["3"], []):
        yield f"{q} is not a factor", diagonal(EULER, "Gm", None, [AT_ZERO], ["1"], (Z, "1"), (q, "1")), False
    yield "z^3 has degree 6", abelian(EULER, 4, ["1"], (Z, "3")), False
    yield "z^2 has degree 4", abelian(EULER, 4, ["1"], (Z, "2")), True
    yield "z z has degree 4", abelian(EULER, 4, Z, (Z, "1")), True


def characters():
    """r = (Delta^2 - 1)/(4 z^2): the order of the group is the denominator of (1 + Delta)/2."""
    for r, n, square in (("-2/9", "3", "1/9"), ("-3/16", "4", "1/4"), ("-5/36", "6", "4/9")):
        equation, place = ([r], ["0", "0", "1"]), AT_ZERO | {"delta2": [square]}
        for k in ("2", "3", "4", "6", "12"):
            yield f"cyclic of order {n}, not {k}", diagonal(equation, "cyclic", k, [place], ["1"], (Z, "1")), k == n
        yield "nothing shows that G is not diagonal", certificate(
            equation, {"group": "T", "n": n}, local(place), exponential(["1"], [f"1/{n}"], Z), conclude("additive", 0, 1)), False


def semi_invariants():
    """S4, exponents 1/2, 1/3, 1/4 at 0, 1, infinity: v = z^(3/2) (z-1)^2 has degree 6, but only v^2 is an invariant; A4 has one."""
    p = "1152921504606859327"
    line = {"by": "series", "place": "0", "p": p, "a": "0", "root": "1", "delta": "384307168202286442", "terms": "10", "lines": [
        {"length": "3", "approximant": ["1", "1091036145693848232", "748445506189983092", "552824357752659031"]},
        {"length": "3", "approximant": ["1", "296725159895045703", "644556765503152181", "637484565439903714"]}]}
    places = [{"q": ["-1", "1"], "order": "2", "delta2": ["1/9"]}, {"q": Z, "order": "2", "delta2": ["1/4"]}]
    for e in ("3/2", "1", "2"):
        yield f"an invariant of degree 6, e = {e}", certificate(
            (["-3/16", "115/576", "-15/64"], ["0", "0", "1", "-2", "1"]), {"group": "A4"}, local(*places),
            ("no-exponential", ["s0"], line), ("no-invariant", ["s0"], {"m": "4", "by": "degree"}),
            invariant(6, ["1"], (Z, e), (["-1", "1"], "2")), conclude("tetrahedral", 1, 2, 3)), False


def annihilators():
    """Delta^2 = c/10 at the roots c of z^2 - 2, so that |Delta| < 1 and D_1 < 0; a logarithm at infinity."""
    def conjugate(delta2, chi, num=("-2", "1/5")):
        place = {"q": ["-2", "0", "1"], "order": "2", "delta2": delta2} | ({} if chi is None else {"annihilator": chi})
        return certificate((num, ["4", "0", "-4", "0", "1"]), {"group": "SL2"}, local(place),
                           ("no-exponential", ["s0"], {"by": "degree"}), conclude("sl2-irreducible-log", 0, 1))
    right = (["-1/50", "0", "1"], ["1/50", "0", "-1"], ["0", "-1/50", "0", "1"], ["-1/5000", "-1/50", "1/100", "1"])
    wrong = (["2", "-1/50", "-100", "1"], ["-1/51", "0", "1"], ["1/50", "0", "1"], ["-1/50", "1"], ["1"], [], None,
             ["0", "0", "1"], ["-1/10", "1"])
    for chi in right + wrong:
        yield f"an annihilator of c/10: {chi}", conjugate(["0", "1/10"], chi), chi in right
    yield "Delta^2 of another sign", conjugate(["0", "-1/10"], right[0]), False
    yield "Delta^2 with another constant", conjugate(["1/100", "1/10"], right[0]), False
    yield "Delta^2 = 5 + c is too large", conjugate(["5", "1"], ["23", "-10", "1"], ("8", "2")), False


# ---- D_n: v = -(z + 3) s, s^2 = z + 4, w = 1/n, u^n = h = (1 + s)/(1 - s)

def times(a, b):
    c = [F(0)] * max(0, len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += F(x) * y
    return c


def plus(*fs):
    return [sum((F(f[i]) for f in fs if i < len(f)), F(0)) for i in range(max(map(len, fs)))]


def scaled(a, k):
    return [F(k) * x for x in a]


def texts(a):
    while a and not a[-1]:
        a = a[:-1]
    return [str(F(x)) for x in a]


ROOT, BRANCH = [3, 1], [4, 1]


def torsion(n, h, minimal=(), by_places=True, told=None, v=(["-1"], (["4", "1"], "1/2"), (["3", "1"], "1"))):
    """That h = (a + b w s)/c shows D_told; r = w^2/(4 v^2) - (v'/v)^2/4 + v''/(2 v)."""
    num = plus(scaled(BRANCH, F(1, 4 * n * n)), scaled(times([11, 3], [11, 3]), F(1, 16)),
               scaled(plus(times(BRANCH, BRANCH), scaled(times(ROOT, ROOT), F(1, 2))), F(-1, 2)))
    places = local({"q": ["3", "1"], "order": "2", "delta2": [str(F(1, n * n))]}, {"q": ["4", "1"], "order": "2", "delta2": ["1/4"]})
    steps = [places] * by_places + [invariant(2, *v)]
    a, b, c = map(texts, h)
    steps.append(("torsion-function", [f"s{i}" for i in range(len(steps))],
                  {"n": str(n if told is None else told), "a": a, "b": b, "den": c, "minimal": list(minimal)}))
    return certificate((texts(num), texts(times(times(ROOT, ROOT), times(BRANCH, BRANCH)))),
                       {"group": "D", "n": str(told or n)}, *steps, conclude("dihedral-finite", len(steps) - 2, len(steps) - 1))


def function(n, k):
    """h^k, by h = (5 + z + 2 s)/(-3 - z)"""
    a, b, c = [F(1)], [F(0)], [F(1)]
    for _ in range(k):
        a, b, c = plus(times(a, [5, 1]), times(scaled(b, 2), BRANCH)), plus(scaled(a, 2), times(b, [5, 1])), times(c, [-3, -1])
    return a, scaled(b, n), c


def witness(n, k, l, power=False):
    """Two points modulo a prime at which the quotient of h^k is not an l-th power, or is one; as a list, empty without"""
    for p in (x for x in (7, 13, 19, 31, 37, 43) if x % l == 1):
        w, found = pow(n, -1, p), []
        a, b, c = ([int(x) for x in f] for f in function(n, k))
        for x, s in ((x, s) for x in range(p) for s in range(1, p) if (s * s - x - 4) % p == 0):
            u, e, g = (sum(y * x**i for i, y in enumerate(f)) % p for f in (a, b, c))
            if g and (u + e * w * s) % p:
                found.append((x, s, (u + e * w * s) * pow(g, -1, p)))
        for x1, s1, h1 in found:
            for x2, s2, h2 in found:
                if x1 != x2 and (pow(h1 * pow(h2, -1, p), (p - 1) // l, p) == 1) is power:
                    numbers = {"l": l, "p": p, "a": 0, "w": w, "x1": x1, "s1": s1, "x2": x2, "s2": s2}
                    return [{key: str(y) for key, y in numbers.items()}]
    return []


def least_orders():
    for n in (2, 3, 6, 9):
        h, known = function(n, 1), [x for l in (2, 3) if n % l == 0 for x in witness(n, 1, l)]
        yield f"D_{n} by the places", torsion(n, h), True
        yield f"D_{n} by witnesses", torsion(n, h, known, False), True
        for i in range(len(known)):
            yield f"D_{n}: a prime without a witness", torsion(n, h, known[:i] + known[i + 1:], False), False
        inverse = texts(scaled(times(ROOT, ROOT), -1)), (["4", "1"], "1/2"), (["3", "1"], "-1")
        yield f"D_{n}: v with a negative exponent", torsion(n, h, v=inverse), True
        for k in (2, 3):
            power, known = function(n, k), [x for l in (2, 3) if n * k % l == 0 for x in witness(n, k, l)]
            yield f"h^{k} has the exponent {n * k}", torsion(n, power, told=n * k), False
            yield f"h^{k} with the witnesses that there are", torsion(n, power, known, told=n * k), False
            yield f"h^{k}: powers are not witnesses", torsion(n, power, known + witness(n, k, k, True), told=n * k), False


def witnesses():
    n, h = 6, function(6, 1)
    known = [x for l in (2, 3) for x in witness(n, 1, l)]
    for i, x in enumerate(known):
        def put(key, value, i=i, x=x):
            return torsion(n, h, [x | {key: str(value)} if j == i else y for j, y in enumerate(known)], False)
        p = int(x["p"])
        for key, value in (("w", 0), ("w", p + int(x["w"])), ("w", 2), ("s1", 0), ("s2", 0), ("p", 5), ("p", 11), ("l", 4), ("l", 1),
                           ("l", 6), ("l", 5), ("a", 1), ("s1", 999), ("s1", p + int(x["s1"])), ("x1", p + int(x["x1"])), ("a", p)):
            yield f"a witness with {key} = {value}", put(key, value), False
        flip = x | {key: str(p - int(x[key])) for key in ("w", "s1", "s2")}
        yield "the other root of w^2 on the other sheet", torsion(n, h, known[:i] + [flip] + known[i + 1:], False), True
        same = x | {"x2": x["x1"], "s2": x["s1"]}
        yield "the same point twice", torsion(n, h, known[:i] + [same] + known[i + 1:], False), False


def functions():
    n = 6
    a, b, c = function(n, 1)
    for what, h in (("0", ([], [], [1])), ("h/0", (a, b, [])), ("0/0", ([], [], [])), ("1/h", (a, scaled(b, -1), c)), ("1", ([1], [], [1])),
                    ("the second equation fails", ([0, 0, 1], scaled(times([0, 2], [-3, -1]), n), [1])),
                    ("the first equation fails", (scaled([-3, -1], F(1, 2 * n)), [1], [1]))):
        yield f"not h: {what}", torsion(n, h), False
    yield "n = 0", torsion(n, ([1], [], [1]), told=0), False
    yield "h of another n", torsion(3, function(3, 1), told=6), False
    yield "n of another h", torsion(6, function(6, 1), told=3), False


def certificates():
    for family in (solutions, factors, characters, semi_invariants, annihilators, least_orders, witnesses, functions):
        for why, text, right in family():
            yield f"{family.__name__}: {why}", text, right
