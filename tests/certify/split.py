"""Properties of splitting.py of the Python checker: functions of its modules (sys.modules) that are True.  A whole theorem
takes longer than a mutant is given; here are the orbits, the sums over the poles, and one step alone."""
import copy
import math
from fractions import Fraction

import theorems

FIRST = {                                   # the sums of a monomial M1, M2, M3, Gamma1, ...: of k = 1, sigma = 1, then -1
    (0, 0, 0, 1, 0, 0): ["-_beta*_s*_Y - _beta*_s", "0", "_beta*_s*_Y + _beta*_s", "0"],
    (0, 0, 0, 0, 1, 0): ["0", "-_delta*_s*_Y + _delta*_s"] * 2,
    (0, 0, 0, 0, 0, 1): ["-_alpha*_s*_Y - _alpha*_s", "0"] * 2,
    (1, 0, 0, 0, 1, 0): ["0", "a*c*_beta*_delta*_s*_Y + a*c*_beta*_delta*_s"] * 2 + ["0"] * 4,
    (0, 0, 1, 0, 1, 1): [
        "0", "-a^3*b*c^2*_delta*_s*_F*_Y + a^3*b*c^2*_delta*_s*_F + a^2*b^2*c^2*_delta*_s*_F*_Y - a^2*b^2*c^2*_delta*_s*_F"] * 2 + [
        "-a^3*b*c^2*_delta*_F^2*_Y^2 - a^3*b*c^2*_delta*_F^2 + a^3*b*c^2*_delta*_Y^2 + a^3*b*c^2*_delta + "
        "a^2*b^2*c^2*_delta*_F^2*_Y^2 + a^2*b^2*c^2*_delta*_F^2 - a^2*b^2*c^2*_delta*_Y^2 - a^2*b^2*c^2*_delta", "0",
        "a^3*b*c^2*_delta*_F^2*_Y^2 + a^3*b*c^2*_delta*_F^2 - a^3*b*c^2*_delta*_Y^2 - a^3*b*c^2*_delta - "
        "a^2*b^2*c^2*_delta*_F^2*_Y^2 - a^2*b^2*c^2*_delta*_F^2 + a^2*b^2*c^2*_delta*_Y^2 + a^2*b^2*c^2*_delta"] + ["0"] * 5}


def orbits(m, n):
    """With a, b, c in front"""
    M, S = m["multivariate"], m["rule_splitting"]
    M.Work.left = 10**7
    at = [M.FIELD * i for i in range(12)]
    return S.Orbits(at[3:], [S.variable(x) for x in at[:3]], n), dict(zip(["a", "b", "c", *S.NAMES], at))


def series(m):
    """x/sinh x = 1 - x^2/6 + 7x^4/360 - 31x^6/15120, x/tanh x = 1 + x^2/3 - x^4/45 + 2x^6/945"""
    S, M = m["rule_splitting"], m["multivariate"]
    M.Work.left = 10**6
    wanted = [[1, Fraction(-1, 6), Fraction(7, 360), Fraction(-31, 15120)], [1, Fraction(1, 3), Fraction(-1, 45), Fraction(2, 945)]]
    for n in (6, 7):
        for top, numbers in zip((lambda k: Fraction(k == 0), lambda k: Fraction(1, math.factorial(2 * k))), wanted):
            f = S.over_sinh(top, n, M.P({2: 5}))
            if {k: Fraction(c, f.n) for k, c in f.p.items()} != {2 * k: c * 5**k for k, c in enumerate(numbers)}:
                return False
    return True


def quadratic(o, m, u, v, weights=(1, 1, 1)):
    """sum w_j u_j v_j"""
    S, one = m["rule_splitting"], m["multivariate"].P({0: 1})
    return o.reduced(S.total(x * y * S.Function(one * w) for x, y, w in zip(u, v, weights)))


def on_the_orbit(m):
    """|M|^2 = |Gamma|^2, M Gamma = F |M|^2, and the energy, at both poles of both orbits"""
    o, names = orbits(m, 4)
    F, read = m["rule_splitting"].Function, m["multivariate"].parse
    square = F(read("4*a^3*b*c*b - 4*a^2*b^2*c*b - 4*a^3*b*c*c + 4*a^2*b^2*c*c - 4*a^2*b*c^2*b + 4*a*b^2*c^2*b + 4*a^2*b*c^3 - 4*a*b^2*c^3",
                    names))               # 4 b (a - c) times a c (a - b) (b - c)
    energy = F(square.p * read("a*c", names))
    for sigma in (1, -1):
        for sign in (1, -1):
            x = o.coordinates(sigma, sign)
            M, G = x[:3], x[3:]
            of_m = quadratic(o, m, M, M)
            both, of_g = quadratic(o, m, M, G), quadratic(o, m, G, G)
            heat = quadratic(o, m, M, M, [read(w, names) for w in ("b*c", "a*c", "a*b")])
            t = F(o.theta**2)               # and zeta with each component of Gamma
            if (of_m - square * t).p or (of_g - square * t * F(o.zeta**2)).p or (heat - energy * t).p \
                    or (both - square * t * F(read("_F", names) * o.zeta)).p:
                return False
    return True


def sums(m):
    for e, wanted in FIRST.items():
        o, names = orbits(m, sum(e))
        one = m["multivariate"].P({0: 1})
        if [*o.sums([(e, one)])] != [m["multivariate"].parse(text, names) for text in wanted]:
            return False
    return True


def lower(m):
    """A monomial of lower degree is multiplied by 2 alpha beta delta once for each that is missing"""
    one = m["multivariate"].P({0: 1})
    for e in ((0, 0, 0, 1, 0, 0), (1, 0, 0, 0, 1, 0), (0, 0, 0, 0, 0, 2)):
        found = []
        for more in (0, 1, 2):
            o, names = orbits(m, sum(e) + more)
            unit = m["rule_splitting"].Function(m["multivariate"].parse("2*_alpha*_beta*_delta", names)**(2 - more) if more < 2 else one)
            row = o.residues([(e, one)], o.coordinates(1, -1))
            found.append({k: o.reduced(f * unit) for k, f in row.items()})
        if not found[0] or any(row.keys() != found[0].keys() or any((row[k] - f).p for k, f in found[0].items()) for row in found):
            return False
    return True


def euler(m):
    """The bracket of e(3): each pair over 1"""
    names, rows = ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"], theorems.system(theorems.HEAVY, "heavy_top.toml")["system"]["brackets"]

    def accepts(rows):
        m["multivariate"].Work.left = 10**7
        system = {"coordinates": names, "functions": [], "inverses": [], "relations": [], "field": None, "hamiltonian": "M1",
                  "brackets": rows}
        of, top = m["family"].brackets, m["family"].Family(m["theorem_statement"].SYMMETRIC_TOP).space
        return of(m["phase_space"].PhaseSpace(system, [])) == of(top)
    # M1, M3, Gamma1 and Gamma3 doubled: another basis, in which some brackets are over 4
    other = [[i, j, [f, "4"] if {i[-1], j[-1]} == {"1", "3"} else f] for i, j, f in rows]
    return accepts(rows) and not accepts(other) and not accepts([[i, j, [f, "2"]] for i, j, f in rows])


def step(m, change=lambda family, d: None):
    """Is the step of the heavy top accepted with this change?"""
    m["multivariate"].Work.left, m["condition"].ConditionSet.nodes = 4 * 10**7, 10**5
    d = copy.deepcopy(theorems.step(theorems.HEAVY, "three-step"))
    family = copy.deepcopy(theorems.system(theorems.HEAVY, "heavy_top.toml"))
    change(family, d)
    for key in ("functions", "relations", "field"):
        family["system"].setdefault(key, None if key == "field" else [])
    for key in ("order", "power"):
        d[key] = int(d[key])
    schema = {key: m["rule_splitting"].FIELDS[key] for key in ("moments", "small")}
    try:
        d |= m["certificate_format"].read(schema, {key: d[key] for key in schema}, "names")
        m["rule_splitting"].Splitting(m["family"].Family(family), d)
    except (m["certificate_format"].Rejected, m["certificate_format"].Malformed):
        return False
    return True


def put(key, value):
    return lambda family, d: d.update({key: value})


def power(k):
    """H over a higher power of A B C, in an empty region"""
    def change(_, d):
        d["region"].append({"p": "0", "sign": "positive"})
        d["proof"] = {"node": "empty", "terms": [["1", "1", ["7", "1"]]], "zeros": []}
        d.update(power=k, first=" + ".join(f"2*Gamma{i}*A^{k}*B^{k}*C^{k}*L{i}" for i in (1, 2, 3)))
    return change


def hamiltonian(more):
    def change(family, _):
        h = family["system"]["hamiltonian"]
        h[0] += more
    return change


def bracket(i, text):
    return lambda family, d: family["system"]["brackets"][i].__setitem__(2, text)


def steps(m):
    wrong = [power(13), put("moments", ["B", "A", "C"]), put("moments", ["A", "B"]), put("moments", ["A", "B", "L1"]),
             put("small", ["L1", "L2", "A"]),
             put("small", ["L1", "L2", "M1"]), put("small", ["L2", "L1"]), put("order", 0), put("order", 2), put("power", 0), put("power",
                 2),
             put("power", 13), put("first", "2*Gamma1*A*B*C*L1 + 2*Gamma2*A*B*C*L2"), put("first", "0"),
             put("first", "Gamma1*A*B*C*L1 + 2*Gamma2*A*B*C*L2 + 2*Gamma3*A*B*C*L3"),
             hamiltonian(" + Gamma1*Gamma2*L1"), hamiltonian(" + M1*L1*Gamma1"), hamiltonian(" + M1^2*L1"), hamiltonian(" + Gamma1"),
             lambda family, d: d["region"].pop(0), lambda family, d: d["region"].pop(1),
             lambda family, d: d["region"].pop(2), lambda family, d: d["region"].pop(3)]
    right = [hamiltonian(""), hamiltonian(" + 5*M1*Gamma1*Gamma3*L1*L3*A - Gamma2^2*L2^2"), power(2), power(12)]
    return all(step(m, change) for change in right) and not any(step(m, change) for change in wrong)


def alone(m, change, proof=None, extra=(), **d):
    """The step with a proof that needs the sums no more: a condition of the region is 0 > 0"""
    def both(family, step_):
        step_["region"] = [{"p": "0", "sign": "positive"}, *extra, *step_["region"]]
        step_["proof"] = proof or {"node": "empty", "terms": [["1", "1", ["3", "1"]]], "zeros": []}
        step_.update(d)
        change(family, step_)
    return step(m, both)


def nothing(family, d):
    pass


def parameter(*names):
    return lambda family, d: family["parameters"].extend(names)


def without_l3(family, d):
    h = family["system"]["hamiltonian"]
    h[0] = h[0].replace(" + 2*Gamma3*u1*u2*u3*A*B*C*L3", "").replace(" + 2*Gamma2*u1*u2*u3*A*B*C*L2", "")
    d["first"] = "2*Gamma1*A*B*C*L1"
    family["parameters"].append("m")


def brackets(scale, over):
    def change(family, d):
        for row in family["system"]["brackets"]:
            row[2] = [row[2].replace("M", scale + "M").replace("Gamma", scale + "Gamma"), over]
    return change


def second_order(family, d):
    without_l3(family, d)
    family["system"]["hamiltonian"][0] = family["system"]["hamiltonian"][0].replace("2*Gamma1*u1*u2*u3*A*B*C*L1", "2*Gamma1^2*L1^2")
    d["first"] = "2*A*B*C*Gamma1^2*L1^2"


def denominator(of):
    def change(family, d):
        family["system"]["inverses"].append({"name": "w", "of": of})
        family["system"]["hamiltonian"][0] += " + w*L1*L2*Gamma1*Gamma2"
    return change


def seventh(family, d):
    """A coordinate more"""
    family["system"]["coordinates"].append("N")


def unordered(p):
    def change(_, d):
        d["region"] = [row for row in d["region"] if row["p"] != p]
    return change


def one_inverse(family, d):
    """1/(A B C) in the place of 1/A, 1/B and 1/C"""
    system = family["system"]
    h, n = system["hamiltonian"]
    for other in ("u1*u2*u3*A*B*C*", "u1*u2*u3*B*C", "u1*u2*u3*A*C", "u1*u2*u3*A*B"):
        h = h.replace(other, other.replace("u1*u2*u3", "w"))
    system["hamiltonian"], system["inverses"] = [h.replace("w*A*B*C*", ""), n], [{"name": "w", "of": "A*B*C"}]


def requirements(m):
    """Each of them alone: a change that nothing else refuses"""
    square = hamiltonian(" + 2*Gamma1^2*L1^2")
    right = [alone(m, nothing), alone(m, without_l3, small=["L1", "L2", "L3"]), alone(m, second_order, order=2),
             alone(m, parameter("m", "s")), alone(m, brackets("", "1")), alone(m, square),
             alone(m, denominator("A + L1*Gamma1")), alone(m, denominator("A^2*B + M2*L1*Gamma3 - L2*Gamma3")), alone(m,
                 denominator("5*C"))]
    mixed = [f"2*Gamma{i}*A*B*C*L{i}" for i in (1, 2, 3)] + ["2*M1*Gamma1*A*B*C*L1"]
    right += [alone(m, hamiltonian(" + 2*M1*Gamma1*L1"), first=" + ".join(mixed)), alone(m, one_inverse)]
    wrong = [alone(m, without_l3, moments=["A", "B", "C", "m"], small=["L1", "L2"]), alone(m, seventh), alone(m, unordered("A - B")),
             alone(m, unordered("B - C")), alone(m, unordered("C")), alone(m, without_l3, small=["L1", "m", "m"]), alone(m, parameter("m"),
                 small=["L1", "L2", "L3", "m"]),
             alone(m, without_l3, small=["L1", "m"]), alone(m, parameter("_s")), alone(m, parameter("_i")),
             alone(m, brackets("2*", "1")), alone(m, brackets("", "2")), alone(m, hamiltonian(" + 2*Gamma1*L1^2")),
             alone(m, nothing, order=0, first="0"), alone(m, square, first=" + ".join(f"2*Gamma{i}*A*B*C*L{i}" for i in (1, 2, 3))
                                                          + " + 2*A*B*C*Gamma1^2*L1^2"),
             alone(m, denominator("A - C")), alone(m, denominator("M1")), alone(m, denominator("A*L1*Gamma1")),
             alone(m, denominator("A + M1"))]
    # what is known of the orbit: after 3 assumptions, 6 of the region, 6 positive numbers and 1 - Y
    roots = [["A*C - B*C", 9, 16], ["A*B - A*C", 10, 17], ["A*B - B*C", 11, 18]]
    known = [alone(m, nothing, {"node": "empty", "terms": [["1", "1", [str(x), "2"]]], "zeros": [[str(f), "1"], ["4", "-1"]]},
                   [{"p": p, "sign": "zero"}]) for p, x, f in roots]
    circle = {"node": "empty", "terms": [["1", "1", ["12", "2"]], ["1", "1", ["13", "2"]]], "zeros": [["19", "1"], ["4", "-1"]]}
    return all(right) and not any(wrong) and all(known) and alone(m, nothing, circle, [{"p": "1", "sign": "zero"}])


def properties():
    """(name, function, True)"""
    return [(f"split.{f.__name__}", f, True) for f in (series, on_the_orbit, sums, lower, euler, steps, requirements)]
