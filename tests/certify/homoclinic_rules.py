"""Properties of homoclinic.py of the Python checker, functions of its modules (sys.modules) that are True (chaos.md 1 to 4).  A whole
certificate takes long: in the place of a flow there is an explicit map of the plane."""
import math
import random
from fractions import Fraction as F

from enclosure_rules import holds, units
from lowest import refused

LAMBDA = (5 + math.sqrt(21)) / 2                    # of (x, y) -> (x + y', y'), y' = y + 3 x (1 - x), at 0
AXES = [[1.0, 1.0], [LAMBDA - 4, 1 / LAMBDA - 4]]
XI, ETA, COUNT = 3.745633921721858e-05, 3.745542074112325e-05 / LAMBDA, 15


def mapped(x, y, at=(0, 0)):
    x, y = x - at[0], y - at[1]
    y = y + 3 * x * (1 - x)
    return x + y + at[0], y + at[1]


HERE = (F(1, 3), F(-1, 7))                          # where the fixed point of the toy is


class Toy:
    """Four coordinates x, y, x + 2 y, -x, and this map, moved; other: what a carried patch is changed by"""
    other = None

    def __init__(self, m, d):
        self.m, self.d, self.calls = m, d, 0

    def at(self, x, places):
        one, e = self.m["enclosures"].UNIT, self.m["enclosures"]

        def times(n, b):
            return b * e.Ball.of(n)
        by = [[-one, times(-2, one), one, e.ZERO], [times(3, one), e.ZERO, e.ZERO, times(3, one)]]
        return [x[2] - x[0] - times(2, x[1]), times(3, x[3] + x[0])], [[row[i] for i in places] for row in by]

    def chart(self, x):
        return (0, 1) if x[0].about() > 0.6 else (1, 2)

    def carried(self, patch, way=1):
        e, h = self.m["enclosures"], self.m["homoclinic"]
        thin = h.Patch(self, patch.chart, [b.middle() for b in patch.box], [row[0] for row in patch.x])
        x, y = self.of(patch.x, way), [row[:1] for row in self.of([row[:1] for row in thin.x], way)]
        self.calls += 1
        if Toy.other:
            x = Toy.other(self, way, x, e)
        return x, y

    def of(self, rows, way):
        e = self.m["enclosures"]
        x, y = ([row[0] - e.Ball.of(q), *row[1:]] for row, q in zip(rows, HERE))

        def plus(a, b, c=1):
            return [p + q * e.Ball.of(c) for p, q in zip(a, b)]

        def bent(x):                                # 3 x (1 - x)
            three = e.Ball.of(3)
            return [three * x[0] * (e.UNIT - x[0]), *(three * (e.UNIT - x[0] - x[0]) * b for b in x[1:])]
        if way > 0:
            y = plus(y, bent(x))
            x = plus(x, y)
        else:
            x = plus(x, y, -1)
            y = plus(y, bent(x), -1)
        x, y = ([row[0] + e.Ball.of(q), *row[1:]] for row, q in zip((x, y), HERE))
        return [x, y, plus(x, y, 2), [-b for b in x]]


def orbit(n=COUNT, xi=XI):
    p, out = (xi * AXES[0][0], xi * AXES[1][0]), []
    for _ in range(n - 1):
        p = mapped(*p)
        out.append(point(F(p[0]) + HERE[0], F(p[1]) + HERE[1]))
    return out


def point(x, y):
    return [x, y, x + 2 * y, -x]


def proved(m, other=None, **more):
    """The proof for the map, or None"""
    h, e = m["homoclinic"], m["enclosures"]
    d = {"chart": [0, 1], "point": point(*HERE), "axes": AXES, "reach": F(1, 20000), "xi": F(XI), "eta": F(ETA), "orbit": orbit()} | more
    d["axes"] = [[e.Ball.of(x).middle() for x in row] for row in d["axes"]]
    surface, h.Surface, found, Toy.other = h.Surface, lambda d: Toy(m, d), [], other
    try:
        return None if refused(m, lambda: found.append(h.Proof(d))) else found[0]
    finally:
        h.Surface, Toy.other = surface, None


def near(x, y=0):
    return point(HERE[0] + F(x), HERE[1] + F(y))


def proofs(m):
    one = m["enclosures"].ONE
    # what is given is a guess
    for guess in ((0, 0), (F(1, 2**50), 0), (0, F(1, 2**27)), (F(-1, 2**48), F(1, 2**25))):
        true = proved(m, point=near(*guess))
        if not true or not all(holds(m, b, q, one >> 30) for b, q in zip(true.p, HERE)) or len(true.kappa) != 2:
            return False
    moved = [[*z] for z in orbit()]
    moved[5][0] += F(1, 10**4)
    other = proved(m, chart=[0, 2], axes=[AXES[0], [1 + 2 * x for x in AXES[1]]])
    return (bool(other) and not proved(m, point=near(F(11, 10) / 2**20)) and not proved(m, point=near(0, F(11, 10) / 2**20))
            and not proved(m, point=near(F(1, 2000), F(1, 2000))) and not proved(m, xi=F(0), eta=F(0), orbit=[near(0)] * 5)
            and not proved(m, orbit=moved) and not proved(m, orbit=orbit()[1:])
            and not proved(m, axes=[row[::-1] for row in AXES]) and not proved(m, axes=[[1, 0], [0, 1]])
            and not proved(m, reach=F(1, 30000)) and not proved(m, reach=F(1, 4)) and not proved(m, xi=F(XI) * 2)
            and not proved(m, eta=-F(ETA)) and not proved(m, xi=-F(XI)) and proved(m, reach=F(XI) * F(1001, 1000)) is not None
            and not proved(m, reach=F(XI) * F(999, 1000)) and not proved(m, point=near(1))
            and not proved(m, xi=F(XI) + F(1, 2**16)) and not proved(m, reach=F(XI) * F(1001, 1000), xi=-F(XI)))


def sheets(m):
    """What comes back on another sheet is refused: of the fixed point, the region, each link"""
    def lifted(x, e):
        return [[row[0] + e.UNIT, *row[1:]] for row in x]
    calls = []

    def counted(toy, way, x, e):
        calls.append(way)
        return x
    if not proved(m, counted):
        return False
    # the fixed point, with larger boxes as is needed; the region and its inverse; the links, likewise
    back = calls.index(-1)

    def refused_at(i):
        seen = []

        def other(toy, way, x, e):
            seen.append(way)
            return lifted(x, e) if len(seen) - 1 == i else x
        return not proved(m, other)
    last = len(calls) - COUNT
    return back >= 2 and (last - back - 1) % COUNT == 0 and all(map(refused_at, [back - 2, back - 1, back, *range(last, len(calls))]))


class Held:
    """In the place of a patch: it holds some things only"""

    def __init__(self, x, *held):
        self.x, self.held = x, held

    def holds(self, x):
        return x in self.held


def blank(m, **more):
    proof = object.__new__(m["homoclinic"].Proof)
    vars(proof).update(more)
    return proof


def searches(m):
    """(2), (4): boxes grow until the test contracts, four times; what is far from its guess, or no contraction, is refused"""
    h, e = m["homoclinic"], m["enclosures"]
    kept = {x: vars(h)[x] for x in ("contraction", "approximate_inverse", "Patch")}
    far, first = h.FAR, e.ONE >> 90

    def connected(*shifts, ends=None):
        seen, left = [], [[e.Ball(0, s) if s >= 0 else e.Ball(s) for s in row] for row in shifts]
        h.contraction = lambda c, value, slope, radius: left.pop(0)
        h.approximate_inverse = lambda slope: seen.append("inverse") or "inverse"
        surface = type("S", (), {"chart": lambda self, x: (0, x[0].about())})()
        proof = blank(m, d={"xi": F(1, 3), "eta": F(-1, 5), "orbit": [[F(7), F(1), F(2), F(1, 3)]]}, chart=[1, 2], surface=surface)
        proof.equations = lambda radius: (seen.append([*radius]), (None, None))[1]
        proof.ends = lambda radius: seen.append(("ends", radius))
        if refused(m, proof.connection) or proof.n != 2 or proof.charts != [[1, 2], (0, 7), [1, 2]] or proof.points[0][3].r or proof.xi.r:
            return None
        return seen

    def fixed(*shifts, holds=True):
        seen, left = [], [[e.Ball(*s) for s in row] for row in shifts]
        h.contraction = lambda c, value, slope, radius: (seen.append((c, [v.m for v in value], radius)), left.pop(0))[1]
        h.approximate_inverse = lambda slope: [[b.m for b in row] for row in slope]
        h.Patch = lambda surface, chart, box, near: (seen.append([(b.m, b.r) for b in box]), Held("patch", *["x"] * holds))[1]
        image, thin = [[e.Ball(10 * i + k) for k in range(3)] for i in range(4)], [[e.Ball(100 * i)] for i in range(4)]

        class Images(list):
            def __eq__(self, other):
                return other == "x"
        surface = type("S", (), {"carried": lambda self, patch: (Images(image), thin)})()
        proof = blank(m, chart=[1, 3], near=[e.Ball(k) for k in (4, 5, 6, 7)], surface=surface)
        return None if refused(m, proof.fixed_point) else ([(b.m, b.r) for b in proof.p], seen)
    try:
        good = connected([5, 6, 7, 8], [10, 12, 14, 16])
        later = connected([5, 6, 7, 8], [11, 1, 1, 1], [22, 2, 2, 2])
        right = good == [[0] * 4, "inverse", [11, 13, 15, 17], ("ends", [11, 13, 15, 17])] and later[-1] == ("ends", [23, 27, 31, 35])
        right = right and connected(*[[1] * 4] * 4) is not None and connected([1] * 4, *[[3, 7, 15, 31][k:k + 1] * 4 for k in range(3)]) is None
        right = right and connected([0] * 4, [1, 0, 0, 0], [2, 0, 0, 0])[-1] == ("ends", [3, 3, 3, 3])
        right = right and connected([far - 1, 1, 1, 1], [0] * 4) is not None and connected([far, 1, 1, 1], [0] * 4) is None
        right = right and connected([0] * 4, [0, 0, -far, 0], [0] * 4) is None and connected([0] * 4, [1, 1, 1, 0], [2] * 4) is not None
        one = fixed([(3, 2), (-4, 0)])
        slope = [[11 - e.ONE, 12], [31, 32 - e.ONE]]
        right = right and one == ([(8, 2), (3, 0)], [[(5, first), (7, first)], (slope, [100 - 5, 300 - 7], [first] * 2)])
        two = fixed([(3 * first, 0), (0, 1)], [(0, 6 * first - 1), (0, 2 * first - 1)])
        right = right and two and two[1][2] == [(5, 6 * first + 1), (7, 2 * first + 1)] and fixed([(0, first), (0, 0)], [(0, 1), (0, 1)])[1][2][0][1] == 2 * first + 1
        right = right and fixed([(0, 0), (0, 0)], holds=False) is None and fixed([(far, 0), (0, 0)], [(0, 0)] * 2) is None
        right = right and fixed([(0, 0), (0, far)], [(0, 0)] * 2) is None and fixed([(far - 1, 0), (0, 0)], [(0, 0)] * 2) is not None
        return right and fixed(*[[(0, (first + 1 << k) - 1), (0, 0)] for k in range(4)]) is None
    finally:
        vars(h).update(kept)


def closings(m):
    """Both ends are in the region and not p; each image lies on the next patch; the region and its two images"""
    h, e = m["homoclinic"], m["enclosures"]
    near, far = (1000, 999), (-1000, 499)

    def ends(x=near, y=far, reach=2000, patches=("a", "b", "c"), images=("A", "B", "C"), radius=(999, 0, 0, 499)):
        held = [Held("a"), Held("b", "A"), Held("c", "B")]
        for patch, name in zip(held, patches):
            patch.x = name
        proof = blank(m, xi=e.Ball(x[0]), eta=e.Ball(y[0]), reach=reach, region=Held("r", "a", "C"), patches=held, n=3,
                      images=[(i, None) for i in images])
        return not refused(m, lambda: proof.ends([x[1], 5, 7, y[1]]))

    def region(holds=("at", "+", "-"), cone=lambda a: ([[b.m for b in row] for row in a])):
        kept, seen = {x: vars(h)[x] for x in ("Patch", "cone", "by_chart")}, []
        sheet = {"at": [1], "+": [2], "-": [3]}
        h.Patch = lambda surface, chart, box, near: (seen.append([(b.m, b.r) for b in box]), Held("r", *(sheet[x] for x in holds)))[1]
        units_of = [[e.Ball.of(x) for x in row] for row in ((1, 2), (3, 4))]
        h.by_chart, h.cone = lambda x, chart: units_of, lambda a: [[round(b.about(), 6) for b in row] for row in a]
        ways = []
        surface = type("S", (), {"carried": lambda self, patch, way: (ways.append(way), ([2] if way > 0 else [3], None))[1]})()
        axes = [[e.Ball.of(x) for x in row] for row in ((2, -1), (1, 3))]
        proof = blank(m, d={"axes": axes, "reach": F(1, 4)}, p=[e.Ball.of(5), e.Ball.of(7)], surface=surface, chart=[0, 1], near=None,
                      at_p=Held([1]))
        try:
            return None if refused(m, proof.manifolds) else (seen, ways, proof.kappa, proof.reach)
        finally:
            vars(h).update(kept)
    # A^-1 (1 2; 3 4) A for A = (2 -1; 1 3): (1/7) (22 20; 16 13)
    m1 = [[round((3 * a + c) / 7, 6) for a, c in zip((4, 5), (10, 9))], [round((2 * c - a) / 7, 6) for a, c in zip((4, 5), (10, 9))]]
    found = region()
    right = found and found[1] == [1, -1] and found[2] == [m1, [row[::-1] for row in m1[::-1]]] and found[3] == e.ONE // 4
    boxes = found[0][0]
    right = right and [b[0] for b in boxes] == [5 * e.ONE, 7 * e.ONE] and [abs(b[1] - units(m, q)) < 9 for b, q in zip(boxes, (F(3, 4), F(1)))] == [
        True, True] and not any(map(region, (("+", "-"), ("at", "-"), ("at", "+"))))
    return (right and ends() and not ends((1000, 1000)) and not ends(y=(-1000, 1000)) and not ends(reach=1999) and not ends(y=(1500, 500), reach=2000)
            and ends(y=(1500, 499), reach=2000) and not ends(x=(0, 0)) and not ends(x=(-1000, 1000)) and not ends(patches=("b", "b", "c"))
            and not ends(images=("B", "B", "C")) and not ends(images=("A", "C", "C")) and not ends(images=("A", "B", "B")))


def coincident(m):
    """A linear map and one of no hyperbolic point"""
    def linear(toy, way, x, e):
        return x
    h = m["homoclinic"]
    bent, Toy.of = Toy.of, lambda self, rows, way: [*rows]
    try:
        identity = proved(m, linear) is None
    finally:
        Toy.of = bent
    return identity and h.Surface.__name__ == "Surface"


def jacobians(m):
    """Of the equations for xi, z_1, z_2, eta: their values in the middle, and derivatives by all of them"""
    h, e = m["homoclinic"], m["enclosures"]
    axes = [[F(1), F(1, 2)], [F(-3, 4), F(5, 4)]]
    near = point(F(1, 8), F(1, 4))
    z = [(F(1, 2), F(1, 4)), (F(1, 4), F(3, 8)), (F(3, 8), F(-1, 4))]
    xi, eta, kappa = F(1, 16), F(-1, 32), F(1, 128)
    for use in (F(0), kappa):
        proof = object.__new__(h.Proof)
        proof.d = {"axes": [[e.Ball.of(x) for x in row] for row in axes], "xi": xi, "eta": eta, "orbit": None}
        proof.surface = Toy(m, proof.d)
        proof.chart, proof.near, proof.p = [0, 1], [e.Ball.of(q) for q in near], [e.Ball.of(q) for q in near[:2]]
        proof.kappa = [e.Ball.of(use), e.Ball.of(use / 2)]
        proof.xi, proof.eta = e.Ball.of(xi), e.Ball.of(eta)
        proof.points = [[e.Ball.of(q) for q in (x, y, x + 2 * y, -x)] for x, y in z]
        proof.charts = [(0, 1), *(proof.surface.chart(p) for p in proof.points), (0, 1)]
        proof.n = 4
        value, slope = proof.equations([0] * 8)
        for one, two in ((0, 0), (1, 1), (-1, 1)):
            want = exact_equations(axes, near, z, (xi, eta), (one * use, two * use / 2), proof.charts)
            width = units(m, 16 * use) + 2**12
            for i in range(8):
                if not holds(m, value[i], want[0][i], width) or len(slope[i]) != 8:
                    return False
                if not all(holds(m, b, q, width) for b, q in zip(slope[i], want[1][i])):
                    return False
        proof.links([2**k for k in range(60, 68)])
        first = proof.on_graph(0, proof.xi.wider(2**60))
        boxes = [[b.r for b in patch.box] for patch in proof.patches]
        if boxes != [[b.r for b in first], [2**61, 2**62], [2**63, 2**64], [2**65, 2**66]] or [proof.tangent(k)[i].m for k in (0, 1) for i in (
                0, 1)] != [units(m, axes[i][k]) for k in (0, 1) for i in (0, 1)]:
            return False
    return True


def exact_equations(axes, near, z, ends, slopes, charts):
    """w(xi) = slope * xi"""
    def matrix(x):
        k = 3 * (1 - 2 * (x - HERE[0]))
        return [[1 + k, F(1)], [k, F(1)]]

    def apply(a, v):
        return [sum(x * y for x, y in zip(row, v)) for row in a]
    full = [[1, 0], [0, 1], [1, 2], [-1, 0]]
    xi, eta = ends
    u = [row[0] + slopes[0] * row[1] for row in axes]
    s = [row[1] + slopes[1] * row[0] for row in axes]
    start = [p + xi * c for p, c in zip(near, u)]
    last = [p + eta * c for p, c in zip(near, s)]
    points, values, rows = [tuple(start), *z], [], [[F(0)] * 8 for _ in range(8)]
    for k, p in enumerate(points):
        image, chart = point(*mapped(*p, HERE)), charts[k + 1]
        to = point(*z[k]) if k < 3 else point(*last)
        values += [image[i] - to[i] for i in chart]
        d = matrix(p[0])
        columns = [apply(d, u)] if k == 0 else [apply(d, v) for v in inverse_chart(charts[k], full)]
        for j, column in enumerate(columns):
            for i, place in enumerate(chart):
                rows[2 * k + i][j if k == 0 else 2 * k - 1 + j] = sum(x * y for x, y in zip(full[place], column))
        for i in (0, 1):
            if k < 3:
                rows[2 * k + i][2 * k + 1 + i] = F(-1)
            else:
                rows[2 * k + i][7] = -s[i]
    return values, rows


def inverse_chart(chart, full):
    """dx, dy for each of the two coordinates of the chart"""
    (a, b), (c, d) = (full[i] for i in chart)
    n = F(a * d - b * c)
    return [[d / n, -c / n], [-b / n, a / n]]


def krawczyk(m):
    """-C F + (1 - C J) (-r ... r)"""
    h, e, gen = m["homoclinic"], m["enclosures"], random.Random(11)
    for n in (2, 3):
        for _ in range(6):
            c, j = ([[F(gen.randrange(-20, 20), 8) for _ in range(n)] for _ in range(n)] for _ in "cj")
            value, radius = [F(gen.randrange(-20, 20), 8) for _ in range(n)], [F(gen.randrange(20), 16) for _ in range(n)]
            found = h.contraction([[e.Ball.of(x) for x in row] for row in c], [e.Ball.of(x) for x in value],
                                  [[e.Ball.of(x) for x in row] for row in j], [int(units(m, r)) for r in radius])
            for i, ball in enumerate(found):
                middle = -sum(c[i][k] * value[k] for k in range(n))
                size = sum(abs((i == k) - sum(c[i][l] * j[l][k] for l in range(n))) * radius[k] for k in range(n))
                if not all(holds(m, ball, middle + s * size, units(m, size) + 99) for s in (1, -1)):
                    return False
    wide = h.contraction([[e.UNIT]], [e.ZERO], [[e.Ball(e.ONE, e.ONE >> 4)]], [16])
    for a in ([[F(3), F(1)], [F(5), F(-2)]], [[F(0), F(2), F(1)], [F(1), F(0), F(-3)], [F(4), F(1, 2), F(1)]], [[F(1, 1000), F(1)], [F(1), F(1)]]):
        b, n = h.approximate_inverse([[e.Ball.of(x) for x in row] for row in a]), len(a)
        for i in range(n):
            for k in range(n):
                if abs(sum(a[i][l] * F(b[l][k].m, e.ONE) for l in range(n)) - (i == k)) > F(1, 10**10) or b[i][k].r:
                    return False
    rest = h.contraction([[e.UNIT]], [e.ZERO], [[e.Ball(0, e.ONE)]], [e.ONE])       # 1 - (-1 ... 1), times that
    return wide[0].most() in (1, 2, 3, 4) and holds(m, rest[0], 2) and refused(m, lambda: h.approximate_inverse([[e.UNIT, e.UNIT], [e.UNIT, e.UNIT]]))


def cones(m):
    """The least 2^-k, 4 <= k <= 40, that satisfies 3.1 for all matrices"""
    h, e, gen = m["homoclinic"], m["enclosures"], random.Random(2)

    def least(a):
        for k in range(40, 3, -1):
            kappa = F(1, 2**k)
            (a0, b0), (c0, d0) = [[(abs(x) - r, abs(x) + r) for x, r in row] for row in a]
            stretch = a0[0] - b0[1] * kappa
            if stretch > 1 and c0[1] + d0[1] * kappa < kappa * stretch:
                return kappa
        return None
    seen = set()
    given = [[[(F(3), F(1, 9)), (F(2), F(0))], [(F(0), F(1, 2**t)), (F(1, 3), F(1, 99))]] for t in range(2, 44, 3)]
    for _ in range(40):
        given.append([[(F(gen.randrange(-40, 40), 16), F(gen.randrange(4), 16)) for _ in "ab"],
                      [(F(gen.randrange(-8, 8), 16 * 2**gen.randrange(12)), F(gen.randrange(4), 1024)) for _ in "cd"]])
    given += [[[(F(9, 8), F(0)), (F(2), F(0))], [(F(0), F(0)), (F(1, 2), F(0))]], [[(F(17, 16), F(0)), (F(1), F(0))], [(F(1, 32), F(0)), (F(0), F(0))]],
              [[(F(-3), F(0)), (F(2), F(0))], [(F(0), F(0)), (F(1, 2), F(0))]], [[(F(1, 2), F(0)), (F(0), F(0))], [(F(0), F(0)), (F(1, 4), F(0))]],
              [[(F(2), F(0)), (F(0), F(0))], [(F(0), F(0)), (F(3), F(0))]], [[(F(1), F(0)), (F(0), F(0))], [(F(0), F(0)), (F(0), F(0))]],
              [[(F(1), F(3)), (F(0), F(0))], [(F(0), F(0)), (F(0), F(0))]]]
    given += [[[(F(17, 16), F(0)), (F(10), F(0))], [(F(1, 20), F(0)), (F(0), F(0))]], [[(F(2), F(0)), (F(0), F(0))], [(F(1, 8), F(0)), (F(0), F(0))]]]
    for a in given:
        want, found = least(a), []
        matrix = [[e.Ball(int(units(m, x)), int(units(m, r))) for x, r in row] for row in a]
        if refused(m, lambda matrix=matrix, found=found: found.append(h.cone(matrix))) != (want is None):
            return False
        if want is not None and found[0].m not in (units(m, want), units(m, want * 2)):
            return False
        seen.add(want)
    return len(seen) > 8


def matrices(m):
    h, e = m["homoclinic"], m["enclosures"]
    a, b = [[F(2), F(3)], [F(-1), F(5)]], [[F(1, 2), F(7)], [F(4), F(-3)]]

    def balls(a):
        return [[e.Ball.of(x) for x in row] for row in a]

    def same(balls, rows):
        return all(holds(m, x, q, 60) for row, r in zip(balls, rows) for x, q in zip(row, r))
    return (holds(m, e.determinant(balls(a)), 13, 9) and same(h.inverse(balls(a)), [[F(5, 13), F(-3, 13)], [F(1, 13), F(2, 13)]])
            and same(e.matrix(balls(a), balls(b)), [[13, 5], [F(39, 2), -22]]) and same([h.apply(balls(a), balls(b)[1])], [[-1, -19]])
            and refused(m, lambda: h.inverse(balls([[F(1), F(2)], [F(2), F(4)]])))
            and h.by_chart([[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]], (1, 3)) == [[4, 5], [10, 11]])


def energy(m, **more):
    """x = 0 on the level 25/8 of two oscillators"""
    h, parse, FIELD = m["homoclinic"], m["multivariate"].parse, m["multivariate"].FIELD
    m["multivariate"].Work.left = 10**7
    at = {x: FIELD * i for i, x in enumerate("xyuv")}
    d = {"hamiltonian": (parse("16*u^2 + 16*x^2 + 16*v^2 + y^2", at), 32), "section": (parse("3*x", at), 2), "where": (parse("y + 100", at), 1),
         "level": F(25, 8), "direction": "upward", "period": 1} | more
    return h.Surface(d)


class SlowSurface:
    """u = q, whose slope is known badly: Newton's steps are too short"""

    def __init__(self, m, q):
        self.m, self.q = m, q

    def at(self, x, places):
        e = self.m["enclosures"]
        by = [[e.UNIT, e.ZERO, e.ZERO, e.ZERO], [e.ZERO, e.ZERO, e.Ball.between(e.ONE, 4 * e.ONE), e.ZERO]]
        return [x[0], x[2] - e.Ball.of(self.q)], [[row[i] for i in places] for row in by]


def patches(m):
    """u = sqrt(2 h - v^2 - y^2/16) over (y, v), and y over (x, v)"""
    h, e = m["homoclinic"], m["enclosures"]
    s = energy(m)
    near, size = [e.Ball.of(q) for q in (0, 6, F(3, 2), F(5, 4))], F(1, 2**30)              # not quite on the level
    exact = F(25, 4) - F(25, 16) - F(36, 16)
    box = [near[1].wider(int(units(m, size))), near[3].wider(int(units(m, size)))]
    p = h.Patch(s, [1, 3], box, near)
    root = F(math.isqrt(exact.numerator * 10**80 // exact.denominator), 10**40)
    for i in (-1, 0, 1):
        for j in (-1, 0, 1):
            y, v = F(6) + i * size, F(5, 4) + j * size
            q = F(25, 4) - v * v - y * y / 16
            u = F(math.isqrt(q.numerator * 10**60 // q.denominator), 10**30)
            wanted = [F(0), y, u, v], [[0, 0], [1, 0], [-y / 16 / u, -v / u], [0, 1]]
            for row, value, slope in zip(p.x, *wanted):
                if not holds(m, row[0], value, units(m, 9 * size)) or not all(holds(m, b, q, units(m, 90 * size)) for b, q in zip(row[1:], slope)):
                    return False
    thin = h.Patch(s, [1, 3], [b.middle() for b in box], near)
    other = h.Patch(s, [1, 3], [b.middle() for b in box], [near[0], near[1], -near[2], near[3]])
    rough = h.Patch(s, [1, 3], box, [near[0], near[1], e.Ball.of(F(9, 5)), near[3]])
    third = F(1, 3)
    slow = h.Patch(SlowSurface(m, third), [1, 3], [near[1], near[3]], [e.ZERO, e.ZERO, e.Ball.of(F(5, 16)), e.ZERO])
    if not holds(m, slow.x[2][0], third) or slow.x[2][0].r > e.ONE >> 8:
        return False
    joined = p.joined([e.UNIT, -e.UNIT], [near[1], near[3]])
    return (holds(m, thin.x[2][0], root, 2**12) and holds(m, other.x[2][0], -root, 2**12) and holds(m, rough.x[2][0], root)
            and p.holds(thin.x) and p.holds(p.x) and not p.holds(other.x) and not other.holds(thin.x) and p.rest == [0, 2]
            and [b.m for b in joined] == [near[1].m, e.ONE, near[3].m, -e.ONE] and units(m, 1) > p.sheet[1].r
            and refused(m, lambda: h.Patch(s, [1, 3], [near[1].wider(e.ONE * 30), near[3]], near))
            and refused(m, lambda: h.Patch(s, [0, 3], [near[0], near[3]], near))
            and refused(m, lambda: h.Patch(energy(m, level=F(1)), [1, 3], box, near)))


def surfaces(m):
    """Equations and derivatives; the best chart; what the flow makes of a patch"""
    h, e = m["homoclinic"], m["enclosures"]
    s = energy(m)
    x = [e.Ball.of(q) for q in (F(1, 2), F(6), F(3, 2), F(5, 4))]
    value, by = s.at(x, (2, 0, 1))
    level = F(1, 2) * (F(9, 4) + F(1, 4) + F(25, 16) + F(36, 16)) - F(25, 8)
    right = (holds(m, value[0], F(3, 4), 99) and holds(m, value[1], level, 999)
             and all(holds(m, b, q, 99) for b, q in zip([*by[0], *by[1]], (F(0), F(3, 2), F(0), F(3, 2), F(1, 2), F(3, 8)))))
    for surface, up in ((s, 1), (energy(m, direction="downward"), -1)):
        for way, flow in surface.flows.items():
            fields = [b.about() * way for b in flow.field.at(x)]
            right = right and fields == [1.5, 1.25, -0.5, -0.375] and flow.section.at(x)[0].about() == 0.75 * up * way
            right = right and [b.about() for b in flow.slope.at(x)] == [1.5 * up * way, 0, 0, 0] and flow.side.at(x)[0].about() == 106
    right = right and s.chart(x) == (1, 3) and len(s.flows) == 2
    fast = [e.Ball.of(q) for q in (0, 1, F(1, 8), 2)]
    right = right and s.chart(fast) == (1, 2)
    seen = []

    def returned(x, thin, off, way):
        seen.append((off, way, len(x[0]), len(thin[0])))
        return [[row[0] + e.UNIT, *row[1:]] for row in x], [[row[0] + e.UNIT] for row in thin]
    three = energy(m, period=3)
    for way, flow in three.flows.items():
        flow.returned = lambda x, thin, off, way=way: returned(x, thin, off, way)
    near = [e.Ball.of(q) for q in (F(0), F(6), F(3, 2), F(5, 4))]
    patch = h.Patch(three, [1, 3], [near[1].wider(7), near[3].wider(9)], near)
    found, thin = three.carried(patch, -1)
    right = right and len(seen) == 3 and all((way, a, b) == (-1, 3, 1) and [c.r for c in off] == [7, 9] and [c.m for c in off] == [0, 0]
                                             for off, way, a, b in seen)
    right = right and found[1][0].about() == 9 and thin[1][0].about() == 9 and thin[1][0].r == 0 and found[1][0].r == 7
    patch.sheet = [b.wider(0) for b in (e.UNIT, e.UNIT)]
    return right and refused(m, lambda: three.carried(patch)) and (three.carried(h.Patch(three, [1, 3], [near[1], near[3]], near)), seen[-1][1])[1] == 1


def two_oscillators(m):
    """Surface and flow together: (y, v) -> (4 v, -y/4), and its inverse"""
    h, e = m["homoclinic"], m["enclosures"]
    near = [e.Ball.of(q) for q in (F(0), F(6), F(3, 2), F(5, 4))]
    for way, period, image, by in ((1, 1, (F(5), F(-3, 2)), ((0, 4), (F(-1, 4), 0))), (-1, 1, (F(-5), F(3, 2)), ((0, -4), (F(1, 4), 0))),
                                   (1, 2, (F(-6), F(-5, 4)), ((-1, 0), (0, -1)))):
        s = energy(m, period=period)
        p = h.Patch(s, [1, 3], [near[1].wider(2**60), near[3].wider(2**61)], near)
        x, thin = s.carried(p, way)
        for row, one, q, slope in zip((x[1], x[3]), (thin[1], thin[3]), image, by):
            if not holds(m, one[0], q, 2**60) or not holds(m, row[0], q, 2**70) or not all(
                    holds(m, b, c, 2**80) for b, c in zip(row[1:], slope)):
                return False
    return True


TOP = {"format": "kovacic-homoclinic/1", "variables": ["x", "y", "u", "v"], "hamiltonian": ["x*y^3 + u", "2"], "level": "1/8",
       "section": ["x - y", "3"], "direction": "upward", "where": None, "period": "1", "point": ["1", "-2e-1", "3.5", "1/4"], "chart": ["1", "3"],
       "axes": [["1", "2"], ["3", "4"]], "reach": "1e-3", "xi": "-1/5", "eta": "0.25", "orbit": [["1", "2", "3", "4"], ["5", "6", "7", "8"]]}


def reading(m):
    h, e = m["homoclinic"], m["enclosures"]

    def accepts(**more):
        m["multivariate"].Work.left = 10**7
        return not refused(m, lambda: h.read_homoclinic({k: v for k, v in (TOP | more).items() if v != "missing"}))
    d, at = h.read_homoclinic(TOP), m["multivariate"].FIELD
    point = ["1", "2", "3", "4"]
    right = (d["level"], d["reach"], d["xi"], d["eta"], d["period"], d["chart"]) == (F(1, 8), F(1, 1000), F(-1, 5), F(1, 4), 1, [1, 3])
    right = right and d["point"] == [1, F(-1, 5), F(7, 2), F(1, 4)] and d["orbit"] == [[1, 2, 3, 4], [5, 6, 7, 8]] and d["where"] == ({0: 1}, 1)
    right = right and d["section"] == ({1: 1, 1 << at: -1}, 3) and d["hamiltonian"][1] == 2 and h.read_homoclinic(TOP | {"where": ["x", "7"]})["where"] == ({1: 1}, 7)
    right = right and [[b.m for b in row] for row in d["axes"]] == [[e.ONE, 2 * e.ONE], [3 * e.ONE, 4 * e.ONE]] and [
        b.r for row in h.read_homoclinic(TOP | {"axes": [["1/3"] * 2] * 2})["axes"] for b in row] == [0] * 4
    yes = [{"level": "1e399"}, {"level": "5."}, {"level": ".5"}, {"level": "-007/08"}, {"level": "1e+007"}, {"level": "1" * 59}, {"level": "1E-399"}, {"level": "-3"}, {"direction": "downward"}, {"period": "64", "orbit": [point]},
           {"chart": ["0", "1"]}, {"chart": ["2", "3"]}, {"orbit": [point]}, {"orbit": [point] * 400}, {"orbit": [point] * 200, "period": "2"}, {"reach": "999/1000"},
           {"hamiltonian": ["x^16", "1"]}, {"hamiltonian": ["x", "9" * 1000]}, {"variables": ["x", "y", "u", "v" * 1000], "hamiltonian": ["x", "1"]},
           {"section": [" + ".join(f"{k + 2}*x^{k % 16}*y^{k // 16}" for k in range(199)), "1"]}]
    no = [{"more": "1"}, {"level": "missing"}, {"variables": ["x", "y", "u"]}, {"variables": ["x", "y", "u", "x"]}, {"variables": ["x", "y", "u", 3]},
          {"variables": ["x", "y", "u", "v w"]}, {"variables": ["x", "y", "u", "v" * 1001], "hamiltonian": ["x", "1"]}, {"variables": "xyuv"},
          {"variables": ["x", "y", "u", "\u00e9"], "hamiltonian": ["x", "1"]},
          {"variables": ["x", "y", "u", "v", "w"]}, {"hamiltonian": ["x"]}, {"hamiltonian": "x"}, {"hamiltonian": "x1"}, {"orbit": 5}, {"axes": 5}, {"hamiltonian": ["x", "1", "1"]},
          {"hamiltonian": ["x", 1]}, {"hamiltonian": [["x"], "1"]}, {"hamiltonian": ["x", "0"]}, {"hamiltonian": ["x", "-1"]},
          {"hamiltonian": ["x", "9" * 200001]}, {"hamiltonian": ["x", "01"]}, {"hamiltonian": ["x", ""]}, {"hamiltonian": ["x^17", "1"]}, {"hamiltonian": ["x*v^17", "1"]},
          {"hamiltonian": ["x", "1a"]},
          {"section": [" + ".join(f"{k + 2}*x^{k % 16}*y^{k // 16}" for k in range(200)), "1"]}, {"section": ["w", "1"]}, {"where": ["x", "0"]},
          {"where": "x"}, {"direction": "up"}, {"direction": None}, {"period": "0"}, {"period": "65", "orbit": [point]}, {"period": 1}, {"period": "1.0"},
          {"chart": ["0", "4"]}, {"chart": ["1", "1"]}, {"chart": ["3", "1"]}, {"chart": ["1"]}, {"chart": [1, 3]}, {"chart": ["-1", "1"]},
          {"orbit": []}, {"orbit": [point] * 401}, {"orbit": [point] * 201, "period": "2"}, {"orbit": "x"}, {"orbit": [point[:3]]},
          {"orbit": [[*point, "5"]]}, {"orbit": ["1234"]}, {"axes": [["1", "2"]]}, {"axes": [["1", "2"]] * 3}, {"axes": "12"}, {"axes": [["1"], ["2"]]},
          {"axes": [["1", "2"], ["3", "x"]]}, {"point": point[:3]}, {"point": [*point, "1"]}, {"point": "1234"}, {"reach": "0"}, {"reach": "1"},
          {"reach": "-1/2"}, {"reach": "2"}, {"level": "1e400"}, {"level": "1e-400"}, {"level": "1" * 60}, {"level": "1/0"}, {"level": 1},
          {"level": "x"}, {"level": "1_0/8_0"}, {"level": " 1/8 "}, {"level": "\u0661/8"}, {"level": "+1"}, {"level": "1/2e5"}, {"level": "."},
          {"level": "1/8\n"}, {"level": "1e 5"}, {"level": "/8"}, {"level": "1e"}, {"level": "1e1e1"}, {"xi": ["1"]}, {"eta": None}]
    return right and all(accepts(**x) for x in yes) and not any(accepts(**x) for x in no)


def statements(m):
    """What is said, and that an error is a refusal"""
    h, e = m["homoclinic"], m["enclosures"]
    proof, found = h.Proof, []

    class Proved:
        def __init__(self, d):
            self.p = [e.Ball.of(F(3, 4)), e.Ball.of(F(-1, 2))]

    def failing(error):
        def raising(d):
            raise error("no")
        h.Proof = raising
        return refused(m, lambda: h.verify(TOP))
    try:
        h.Proof = Proved
        found = [h.verify(TOP), h.verify(TOP | {"where": ["x + 2*y", "5"], "period": "3", "direction": "downward"})]
        found.append(h.verify(TOP | {"period": "2"}))
        errors = all(map(failing, (ZeroDivisionError, OverflowError, ValueError)))
    finally:
        h.Proof = proof
    one, two, three = found
    return (errors and one[:2] == (1, "") == two[:2] and three[2][1].endswith("upward, to the power 2") and one[2][:3] == [
        "H = (x*y^3 + u)/2 with x' = dH/du, ..., on the level H = 1/8;", "the map of the section (x - y)/3 = 0, upward",
        "has a hyperbolic fixed point at y = 0.75, v = -0.5 and a transverse homoclinic point to it."] and "constant" in one[2][-1]
        and two[2][1] == "the map of the section (x - y)/3 = 0, downward, where (x + 2*y)/5 > 0, to the power 3" and len(one[2]) == 5)


def properties():
    """(name, function, True)"""
    every = (matrices, cones, krawczyk, jacobians, patches, surfaces, two_oscillators, reading, statements, proofs, sheets, searches, closings,
             coincident)
    return [(f"homoclinic_rules.{f.__name__}", f, True) for f in every]
