"""Properties of loops.py of the Python checker, functions of its modules (sys.modules) that are True: what is read, and what the rules
say of matrices and of systems that are given exactly (loop_certificates.md 2 to 5).  loop_rules.py has whole certificates."""
from fractions import Fraction as F

from loop_rules import AROUND_0, BASE, GAUSS, RATIONALS
from lowest import refused

I = [0, 1]


def top(n=1, bits="64", loops=None, den=("1",), num=("1",), field=None, **more):
    rows = [{"den": list(den), "num": [list(num)] + [[]] * (n - 1)} for _ in range(n)]
    shows = {"by": "sl2", "A": [], "B": [], "C": []}
    return {"format": "kovacic-loops/1", "title": "", "field": field or RATIONALS, "system": rows, "bits": bits,
            "loops": [AROUND_0] if loops is None else loops, "shows": shows} | more


def reading(m):
    read = m["loops"].read_loops

    def accepts(*given, **more):
        return not refused(m, lambda: read(top(*given, **more)))
    many = ["0"] * 100
    rows = top(2)["system"]
    return (accepts(1) and accepts(8) and not accepts(9) and not accepts(system=[]) and accepts(den=[*many, "1"]) and accepts(num=[*many, "1"])
            and not accepts(den=[*many, "0", "1"]) and not accepts(num=[*many, "0", "1"]) and not accepts(den=[]) and accepts(num=[])
            and not accepts(system=rows[:1]) and not accepts(system=[*rows, rows[0]]) and accepts(bits="32") and accepts(bits="8192")
            and not accepts(bits="31") and not accepts(bits="8193") and not accepts(loops=[]) and accepts(loops=[[]])
            and accepts(loops=[[BASE]] * 16) and not accepts(loops=[[BASE]] * 17) and accepts(loops=[[BASE] * 1000] * 2)
            and not accepts(loops=[[BASE] * 1000, [BASE] * 1001]) and accepts(field=GAUSS, den=[["1", "1/2"], "3"])
            and not accepts(field=GAUSS | {"minpoly": ["2", "0", "1"]}) and not accepts(field=GAUSS | {"minpoly": ["1", "1"]})
            and not accepts(more="1") and not refused(m, lambda: read(top())) and m["exact"].K.d == 1)


def points(m):
    point = m["loops"].point
    large, small = F(2**400 - 1), F(1, 2**399)

    def no(*x):
        return refused(m, lambda: point(list(x)))
    return (point([F(3, 4), F(-5, 2)]) == (3, -10, 4) and point([F(-7), F(1, 8)]) == (-56, 1, 8) and point([F(0), F(6)]) == (0, 6, 1)
            and point([large, -large]) == (2**400 - 1, 1 - 2**400, 1) and point([small, 5 * small]) == (1, 5, 2**399)
            and no(large + 1, F(0)) and no(F(0), -large - 1) and no(small / 2, F(0)) and no(F(0), small / 2) and no(F(1, 3), F(1))
            and no(F(1), F(1, 3)) and no(F(1, 6), F(1, 8)) and no(F(1, 8), F(1, 6)) and no(F(1)) and no(F(1), F(1), F(1)) and no())


BITS = 40


def exact(m, rows, errors=None):
    """Enclosures of Gaussian integers"""
    e = m["enclosures"]
    rows = [[x if isinstance(x, tuple) else (x, 0) for x in row] for row in rows]
    return [[e.Ball(e.Gaussian(x << BITS, y << BITS), errors[i][j] if errors else 0) for j, (x, y) in enumerate(row)]
            for i, row in enumerate(rows)]


def value(a):
    return [[(F(x.m.x, 2**BITS), F(x.m.y, 2**BITS)) for x in row] for row in a]


def of_size_two(m):
    """Trace, determinant, adjugate; L2 for integral matrices"""
    l, e = m["loops"], m["enclosures"]
    a = exact(m, [[(1, 2), (3, -1)], [(0, 5), (-2, 1)]], [[1, 2], [3, 4]])
    with e.precision(BITS):
        trace, det, adjugate = [[l.trace(a)]], [[e.determinant(a)]], e.adjugate(a)
    right = (value(trace) == [[(-1, 3)]] and value(det) == [[(-4 - 5, 1 - 4 - 15)]] and trace[0][0].r == 5
             and value(adjugate) == [[(-2, 1), (-3, 1)], [(0, -5), (1, 2)]] and [[x.r for x in row] for row in adjugate] == [[4, 2], [3, 1]])

    def shows(A, B, C, det=1, n=2):
        loops = [exact(m, [[x * det for x in row] for row in rows]) for rows in (A, B, C)]
        with e.precision(BITS):
            return not refused(m, lambda: l.need_sl2({"system": [None] * n}, {"A": [0], "B": [1], "C": [2]}, loops))
    A, B = [[1, 1], [0, 1]], [[1, 0], [1, 1]]

    def power(t, d=1):
        return [[t, -d], [1, 0]]
    return (right and shows(A, B, power(3)) and shows(A, B, power(5), 7) and shows(A, B, power(7, 2)) and not shows(A, A, power(3))
            and not shows(A, [[1, 5], [0, 1]], power(3)) and not shows(A, B, power(0)) and not shows(A, B, power(1)) and not shows(A, B, power(2))
            and not shows(A, B, power(2), 3) and not shows(A, B, power(2, 2)) and not shows(A, B, power(3, 9)) and not shows([[0, 1], [1, 0]], B, power(3))
            and not shows(A, B, power(-1)) and not shows(A, B, power(4, 4)) and not shows(A, B, power(2, 4)) and shows(A, B, power(4, 3))
            and shows(A, B, power(5, 5)) and not shows(A, B, [[(1, 1), 0], [(0, 0), (1, -1)]]))


def entries(m):
    """L3 for integral matrices"""
    l = m["loops"]
    e = m["enclosures"]
    loops = [exact(m, rows) for rows in ([[1, 1, 0], [0, 1, 0], [0, 0, 1]], [[1, 0, 0], [0, 1, 2], [0, 0, 1]])]

    def shows(n=1, a=1, b=1, u=(0,), v=(1,), row=0, column=2, loops=loops):
        given = {"A": {"word": list(u), "power": a}, "B": {"word": list(v), "power": b}, "row": row, "column": column}
        with e.precision(BITS):
            return not refused(m, lambda: l.need_not_abelian(given, loops, n))

    def product(word):
        with e.precision(BITS):
            return value(l.product(word, loops))
    other = [exact(m, [[int(x[0]) for x in column] for column in zip(*value(a))]) for a in loops]
    return (shows() and shows(row=2, column=0, loops=other) and not shows(loops=other) and shows(3, 6, 9) and not shows(3, 6, 8) and not shows(3, 5, 9)
            and shows(1000, 1000, 1000) and not shows(row=1) and not shows(column=1)
            and not shows(row=3) and not shows(column=3) and not shows(row=-3) and not shows(column=-1) and not shows(u=()) and not shows(v=())
            and shows(u=(0,) * 12) and not shows(u=(0,) * 13) and not shows(u=(2,)) and not shows(u=(-2,)) and not shows(u=(0, -2))
            and shows(u=(0, 1)) and product([0, 1])[0] == [(1, 0), (1, 0), (0, 0)] and product([1, 0])[0][2] == (2, 0)
            and not shows(u=(0, 2)))


def over(m, field, *rows):
    """A quotient of polynomials with coefficients [a, b] = a + b i"""
    l, K = m["loops"], m["exact"].K
    l.set_field([1, 0, 1] if field == 2 else [0, 1])
    polys = []
    for f in rows:
        q = 1
        for c in f:
            for x in c if isinstance(c, list) else [c]:
                q *= F(x).denominator
        c = [[F(x) * q for x in (c if isinstance(c, list) else [c])] for c in f]
        polys.append(m["exact"].Poly([int(x) for row in c for x in [*row, *[0] * (K.s - len(row))]], q))
    return polys[0] if len(polys) == 1 else l.Quotient(*polys)


def quotients(m):
    l = m["loops"]
    right = True
    for field, i in ((1, 2), (2, I)):
        def q(*rows, field=field):
            return over(m, field, *rows)
        f, g = q([1, i], [0, 3]), q([2], [i, 1])
        # (1 + i z)/(3 z) and 2/(i + z)
        square = [-1, 0] if field == 2 else 4
        sums = [i, [0, 0], i] if field == 2 else [2, 5, 2]
        right = right and not f == g and f + g == q(plus(sums, [0, 6, 0]), times3(i)) and f + f * -1 == q([], [1]) and f + g * -1 == q(
            plus(sums, [0, -6, 0]), times3(i))
        right = right and f * g == q([2, times(2, i)], times3(i)) and f * F(-1, 2) == q([F(-1, 2), times(F(-1, 2), i)], [0, 3])
        right = right and f.diff() == q([-1], [0, 0, 3]) and g.diff() == q([-2], [square, times(2, i), 1])
    return right and not over(m, 1, [1], [2]) == over(m, 1, [1], [3])


def plus(f, g):
    return [[F(a[0]) + b, a[1]] if isinstance(a, list) else F(a) + b for a, b in zip(f, g)]


def times(c, i):
    return [c * x for x in i] if isinstance(i, list) else c * i


def times3(i):
    """3 z (i + z)"""
    return [0, times(3, i), 3]


def radicals(m):
    """The common denominator of the exponents of a logarithmic derivative, over Q and Q(i)"""
    l = m["loops"]

    def order(f, *factors):
        found = []
        given = [{"q": q, "e": F(e)} for q, e in factors]
        return None if refused(m, lambda: found.append(l.radical(f, given))) else found[0]
    right = True
    for field, i in ((1, 3), (2, I)):
        z, w = over(m, field, [0, 1]), over(m, field, [times(-1, i), 1])
        # (1/4)/z + (5/6)/(z - i)
        f = over(m, field, [times(F(-1, 4), i), F(13, 12)], [0, times(-1, i), 1])
        right = right and order(f, (z, F(1, 4)), (w, F(5, 6))) == 12 and order(f, (w, F(5, 6)), (z, F(1, 8)), (z, F(1, 8))) == 24
        right = right and order(f, (z, F(5, 6)), (w, F(1, 4))) is None and order(f, (z, F(1, 4)), (w, F(-5, 6))) is None
        right = right and order(f, (z, F(1, 4)), (w, F(5, 6)), (over(m, field, [5]), 1)) is None and order(f) is None
        right = right and order(over(m, field, [], [1])) == 1 and order(over(m, field, [2], [0, 1]), *[(z, F(1, 20))] * 40) == 20
        right = right and order(over(m, field, [2], [0, 1]), *[(z, F(2, 41))] * 41) is None and order(f, (over(m, field, []), 1)) is None
        right = right and m["exact"].from_rows(l.coefficients(over(m, field, [F(1, 2), times(F(2, 3), i), F(5)]))) == over(m, field, [F(1, 2), times(F(2, 3), i), F(5)])
        rows = l.coefficients(over(m, field, [F(1, 2), 0, F(-1, 3)]))
        right = right and [row[0] for row in rows] == [F(1, 2), 0, F(-1, 3)] and [len(row) for row in rows[:2]] == [field] * 2
    half = over(m, 2, [[F(1, 2), F(-3, 4)], 0, [0, 5], 1])
    return right and l.gaussian(half, 8) == [(4, -6), (0, 0), (0, 40), (8, 0)] and l.gaussian(over(m, 1, [F(1, 3), 2]), 6) == [(2, 0), (12, 0)]


def groups(m):
    """L4 for two unknowns: y1' = y1/(3 z) + y2, y2' = c y1 + y2/(2 z), r = 1/z + 7: the group as it is claimed"""
    l, K = m["loops"], m["exact"].K
    # e = 1/(2 z), p = -5/(6 z), p^2/4 + p'/2 = (25/144 + 60/144)/z^2, a e - a' = (1/6 + 1/3)/z^2, c = a e - a' - q
    r = [[0, 1, 7], [0, 0, 1]]

    def order(claim, unknowns=(0, 1), r=r, given=True, e=F(5, 12), inner=1, field=1, flip=False):
        z = over(m, field, [0, 1])
        c = over(m, field, [F(72 - 85, 144), 1, 7], [0, 0, 1])
        a = [[over(m, field, [F(1, 3)], [0, 1]), over(m, field, [1], [1])], [c, over(m, field, [F(1, 2)], [0, 1])]]
        if flip:
            a = [row[::-1] for row in a[::-1]]
        minimal = K.m

        def prove(certificate):
            num, den = (over(m, inner, f) for f in r)
            return num, den, claim, 3, []
        found, block = [], {"factors": [{"q": z, "e": e}], "certificate": {} if given else None}
        said = None if refused(m, lambda: found.append(l.order_of_two(a, unknowns, block, prove))) else found[0]
        return said and (*said, K.m == minimal)

    def n(group, n=None, **more):
        found = order({"group": group, "n": n}, **more)
        return found and found[0]
    right = (order({"group": "cyclic", "n": 1}) == (12, 3, True) and n("cyclic", 8) == 24 and n("T", 5) == 60 and n("D", 1) == 12 and n("D", 4) == 24
             and n("D", 7) == 84 and n("A4") == 12 and n("S4") == 24 and n("A5") == 60 and n("A5", e=F(5, 12)) == 60)
    return (right and not any(n(x, k) for x, k in (("cyclic", 0), ("cyclic", None), ("T", None), ("D", -1), ("SL2", 3), ("Gm", 2), ("Dinf", None), (None, 4)))
            and order({"n": 4}) is None and n("T", 1, given=False) is None and n("T", 1, e=F(-5, 12)) is None and n("T", 1, e=F(1, 2)) is None
            and n("T", 1, unknowns=(1, 0)) is None and n("T", 2, unknowns=(1, 0), flip=True) == 12 and n("T", 1, flip=True) is None
            and n("T", 1, r=[[0, 1, 8], [0, 0, 1]]) is None and n("T", 1, r=[[], []]) is None and n("T", 1, r=[[0, 1, 7], []]) is None
            and n("T", 1, r=[[0, 2, 14], [0, 0, 2]]) == 12 and order({"group": "T", "n": 1}, field=2, inner=1) == (12, 3, True)
            and order({"group": "T", "n": 1}, field=2, inner=2) == (12, 3, True) and n("T", 1, field=1, inner=2) is None
            and n("T", 1, r=[[I, 7], [0, 1]], field=1, inner=2) is None)            # its integers in a row are those of r


def partitions(m):
    """The order of the blocks, and the least common multiple"""
    l = m["loops"]

    def row(den, *num):
        return {"den": over(m, 1, den), "num": [over(m, 1, f) for f in num]}
    d = {"system": [row([0, 1], [F(1, 4)], [1], []), row([-1, 1], [], [F(1, 6)], []), row([0, 1], [5], [7], [F(1, 9)])]}
    exponents = [([0, 1], F(1, 4)), ([-1, 1], F(1, 6)), ([0, 1], F(1, 9))]

    def order(*blocks, **more):
        rows = [{"unknowns": list(b), "factors": [{"q": over(m, 1, q), "e": e} for q, e in [exponents[b[0]]] if b] if b else [],
                 "certificate": None} | more for b in blocks]
        found = []
        return None if refused(m, lambda: found.append(l.eigenvalue_order(d, {"blocks": rows}, None))) else found[0]
    two, l.order_of_two = l.order_of_two, lambda a, unknowns, block, prove: (10 if unknowns == [0, 1] else 14, 2)
    try:
        pair = order([0, 1], [2]) == (90, 2) and order([2], [0, 1]) is None and order([1, 0], [2]) == (126, 2) and order([0, 1, 2]) is None
        large = order([0, 1], [2]) is not None
        l.order_of_two = lambda *given: (500, 1)
        large = large and order([0, 1], [2]) is None
        exponents[2] = ([0, 1], F(1, 9))
    finally:
        l.order_of_two = two
    return (pair and large and order([1], [0], [2]) == (36, 0) and order([0], [1], [2]) is None and order([1], [2], [0]) is None
            and order([1], [0]) is None and order([1], [0], [2], [2]) is None and order([1], [0], [2], []) is None
            and order([1], [0], [2], certificate={}) is None and order() is None)


def whole(m):
    """Loops are closed and have one base; rows are over the integers; both rules are asked; errors are refusals"""
    l, seen = m["loops"], []
    l.along, along = (lambda rows, loop, bits: seen.append((rows, loop, bits))), l.along

    def matrices(*loops, den=(F(2, 3), 1), num=(F(1, 4),), field=1):
        d = {"system": [{"den": over(m, field, list(den)), "num": [over(m, field, list(num))]}], "loops": list(loops), "bits": 77}
        return not refused(m, lambda: l.matrices(d))
    p, q, r = (0, 0, 1), (1, 0, 1), (0, 1, 1)
    try:
        right = (matrices([p, q, p]) and seen[-1] == ([([(8, 0), (12, 0)], [[(3, 0)]])], [p, q, p], 77) and matrices([p, q, r, p], [p, r, p])
                 and not matrices([p, q, r]) and not matrices([p, p]) and not matrices([p]) and not matrices([]) and not matrices([p, q, p], [q, p, q])
                 and not matrices([p, q, p], [p, q, r]) and not matrices([p, q, p], [q, r, p]) and not matrices([p, q, p], [])
                 and matrices([p, q, p], den=([0, 1], 1), num=([1, F(1, 2)],), field=2) and seen[-1][0] == [([(0, 2), (2, 0)], [[(2, 1)]])])
    finally:
        l.along = along
    steps, kept = [], {x: vars(l)[x] for x in ("need_sl2", "need_not_abelian", "eigenvalue_order", "matrices")}
    l.need_sl2 = lambda *x: steps.append("sl2")
    l.need_not_abelian = lambda shows, loops, n: steps.append((loops, n))
    l.eigenvalue_order, l.matrices = lambda *x: (7, 2), lambda d: 5
    element, text = {"word": [], "power": "1"}, top()
    other = text | {"shows": {"by": "not-abelian", "A": element, "B": element, "row": "0", "column": "0", "blocks": []}}

    def fails(error):
        def raising(*x):
            raise error("no")
        l.need_sl2 = raising
        return refused(m, lambda: l.verify(text, None))
    try:
        one, two = l.verify(text, None), l.verify(other, None)
        lines = l.verify(top(field=GAUSS, num=[]), None)[2]
        errors = (ZeroDivisionError, OverflowError, ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError, MemoryError)
        right = right and steps == ["sl2", (5, 7), "sl2"] and one[:2] == (0, "") and two[:2] == (2, "") and all(map(fails, errors))
    finally:
        vars(l).update(kept)
    return (right and lines[:2] == ['the system "", a^2 + 1 = 0', "  (1) y1' = 0"] and one[2][:2] == ['the system ""', "  (1) y1' = (1) y1"]
            and "SL(2, C)" in one[2][-1] and "not abelian" in two[2][-1] and len(one[2]) == 3)


def properties():
    """(name, function, True)"""
    every = (reading, points, of_size_two, entries, quotients, radicals, groups, partitions, whole)
    return [(f"loop_functions.{f.__name__}", f, True) for f in every]
