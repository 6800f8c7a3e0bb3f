"""Properties of continuation.py of the Python checker, functions of its modules (sys.modules) that are True: what is enclosed is inside,
what bounds is a bound, and neither is much wider than the same in exact numbers (loop_certificates.md 3)."""
import random
from fractions import Fraction as F

from lowest import refused


def product(a, b):
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def numbers(m):
    """Absolute values, sums and products in Z[i]; powers of 2, to either side"""
    c, G = m["continuation"], m["enclosures"].Gaussian
    some = [(a, b) for a in range(-9, 10) for b in range(-9, 10)] + [(10**30, -3 * 10**29), (0, 2**200)]
    return (all((abs(G(*x)) - 1)**2 <= x[0]**2 + x[1]**2 <= abs(G(*x))**2 and bool(G(*x)) == any(x) for x in some)
            and all(G(2, -3) * G(*x) == product((2, -3), x) and G(2, -3) + G(*x) == (2 + x[0], x[1] - 3) for x in some)
            and all(G(2, -3) - G(*x) == (2 - x[0], -3 - x[1]) and -G(*x) == (-x[0], -x[1]) and 0 + G(*x) == x for x in some)
            and G(5, -5) >> 1 == (2, -3) and G(7) == (7, 0)
            and all(c.times_power(0, e) == 0 for e in (-3, 0, 3)) and c.times_power(5, 0) == 5 and c.times_power(5, 3) == 40
            and all(F(x, 2**e) <= c.times_power(x, -e) <= F(x, 2**e) + 1 for x in range(1, 40) for e in range(1, 8)))


def weights(m):
    """Rows and columns of like size: 2^(w_j - w_i) table_ij; what is on the diagonal has no say"""
    balanced = m["continuation"].balanced
    for table in ([[7, 2**40], [1, 2**90]], [[0, 2**21, 0], [3, 0, 2**33], [2**9, 1, 0]], [[0, 1], [2**50, 0]], [[5, 0], [2**60, 7]]):
        n, w = len(table), balanced(table)
        sizes = [[F(x) * F(2)**(w[j] - w[i]) if i != j else F(0) for j, x in enumerate(row)] for i, row in enumerate(table)]
        for i in range(n):
            row, column = max(sizes[i]), max(sizes[j][i] for j in range(n))
            if row and column and not F(1, 16) <= row / column <= 16:
                return False
    return balanced([[2**50, 0], [0, 1]]) == [0, 0] == balanced([[5, 0], [2**60, 7]]) and balanced([[9]]) == [0]


def moved(m):
    """scale^degree f((point + step t)/scale)"""
    f, G = [(2, 1), (0, -3), (5, 0), (1, 1)], m["enclosures"].Gaussian
    point, step = G(3, -2), G(-1, 4)

    def value(t, scale, degree):
        x = F(point[0] + step[0] * t, scale), F(point[1] + step[1] * t, scale)
        v = (F(0), F(0))
        for c in reversed(f):
            v = product(v, x)
            v = v[0] + c[0], v[1] + c[1]
        return v[0] * scale**degree, v[1] * scale**degree

    def at(g, t):
        return tuple(sum(c[i] * t**k for k, c in enumerate(g)) for i in (0, 1))
    for scale, degree in ((1, 3), (4, 3), (8, 5)):
        g = m["continuation"].shifted(f, degree, point, step, scale)
        if len(g) != 4 or any(at(g, t) != value(t, scale, degree) for t in range(-3, 5)):
            return False
    return True


def random_matrix(gen, e, n, far=True):
    return [[e.Ball(e.Gaussian(gen.randrange(-200, 200), gen.randrange(-200, 200)), gen.randrange(1, 90) if far else 0)
             for _ in range(n)] for _ in range(n)]


def matrices(m):
    """Products and differences of complex enclosures contain those of what is inside, and hardly more"""
    e, gen = m["enclosures"], random.Random(5)

    def right(a, b, p, i, j, bits):
        unit, pairs = F(1, 2**bits), [(x, row[j]) for x, row in zip(a[i], b)]
        exact = [sum(product(x.m, y.m)[k] for x, y in pairs) * unit for k in (0, 1)]
        least = sum((abs(x.m) - 1) * y.r + (abs(y.m) - 1) * x.r + x.r * y.r for x, y in pairs) * unit
        most = sum(abs(x.m) * y.r + abs(y.m) * x.r + x.r * y.r for x, y in pairs) * unit
        lost = max(abs(x - y) for x, y in zip(exact, p[i][j].m))
        return lost < len(pairs) and least + lost <= p[i][j].r <= most + 3 * len(pairs)
    for n, bits, far in ((1, 4, True), (2, 5, True), (3, 4, False), (2, 0, True), (2, 9, False)):
        a, b = (random_matrix(gen, e, n, far) for _ in "ab")
        with e.precision(bits):
            p = e.matrix(a, b)
        if e.Ball.bits != 112 or not all(right(a, b, p, i, j, bits) for i in range(n) for j in range(n)):
            return False
        x, y = a[0][0], b[0][0]
        if ((x - y).m, (x - y).r, (x + y).m, (x + y).r) != (x.m - y.m, x.r + y.r, x.m + y.m, x.r + y.r):
            return False

    def ball(x, y, r):
        return e.Ball(e.Gaussian(x, y), r)
    with e.precision(6):
        third = e.matrix(e.matrix([[ball(64, 0, 0), ball(128, 64, 0)], [ball(0, 0, 0), ball(-64, 0, 0)]], [[ball(0, 64, 0)], [ball(64, 0, 0)]]),
                         [[ball(64, 0, 0)]])
    return ([[x.m for x in row] for row in third] == [[(128, 128)], [(-64, 0)]]
            and not ball(3, 4, 5).not_zero() and ball(3, 4, 4).not_zero() and not ball(3, 3, 5).not_zero() and ball(-5, 4, 5).not_zero()
            and not ball(0, 0, 0).not_zero() and e.Ball(7, 5).not_zero() and not e.Ball(-7, 7).not_zero())


def rows_of(*rows):
    """(den, num, ...) as pairs of integers"""
    def pairs(f):
        return [x if isinstance(x, tuple) else (x, 0) for x in f]
    return [(pairs(den), [pairs(f) for f in num]) for den, *num in rows]


# y1' = y1 + (z + 2 i) y2, (z^2 + 9) y2' = (3 - i z) y1 + 5 y2
ROWS = rows_of(((1,), (1,), ((0, 2), 1)), ((9, 0, 1), (3, (0, -1)), (5,)))
START, END = (-3, 2, 4), (1, 1, 2)


def segment(m, rows=ROWS, start=START, end=END, bits=80):
    m["multivariate"].Work.left = 10**9
    return m["continuation"].Segment(rows, start, end, bits)


def value(f, t):
    out = (F(0), F(0))
    for x in reversed(f):
        out = product(out, (t, F(0)))
        out = out[0] + x[0], out[1] + x[1]
    return out


def square(x):
    return x[0]**2 + x[1]**2


def on_the_segment(m):
    """Rows in t: num dz/dt over den, up to a common factor of each row"""
    s = segment(m)
    step = (F(5, 4), F(0))

    def right(i, j, t):
        z = F(-3, 4) + step[0] * t, F(1, 2)
        den, num = value(ROWS[i][0], F(0)), (F(0), F(0))
        den, num = ((F(0), F(0)) for _ in "12")
        for k, x in enumerate(ROWS[i][0]):
            power = (F(1), F(0))
            for _ in range(k):
                power = product(power, z)
            den = tuple(a + b for a, b in zip(den, product(x, power)))
        for k, x in enumerate(ROWS[i][1][j]):
            power = step
            for _ in range(k):
                power = product(power, z)
            num = tuple(a + b for a, b in zip(num, product(x, power)))
        return product(value(s.nums[i][j], t), den) == product(value(s.dens[i], t), num)
    back = segment(m, start=END, end=START)
    return (all(right(i, j, F(t, 7)) for i in (0, 1) for j in (0, 1) for t in range(9)) and s.degree == 2
            and all(product(value(s.nums[i][j], F(t, 7)), value(back.dens[i], 1 - F(t, 7)))
                    == tuple(-x for x in product(value(back.nums[i][j], 1 - F(t, 7)), value(s.dens[i], F(t, 7))))
                    for i in (0, 1) for j in (0, 1) for t in range(9)))


def bounds(m):
    """On each piece the sum of the absolute values of Taylor coefficients, and what the first is above the others"""
    margin = m["continuation"].MARGIN
    plain = rows_of(((1, 1), (2,), (), (3,)), ((2, 0, 1), (1,), (0, 1), (2,)), ((3,), (7, 2, (0, 1)), (), (1,)))
    for rows, start, end in ((ROWS, START, END), (plain, (0, 0, 1), (1, 0, 1)), (plain, (0, 0, 1), (0, 1, 2))):
        s = segment(m, rows, start, end)
        for k in (2, 3):
            found = s.pieces(k)
            if found is None:
                return False
            tables, least = found
            if len(tables) != 2**k or not all(right_piece(s, k, j, table, margin) for j, table in enumerate(tables)):
                return False
            for i, low in enumerate(least):
                exact = min(sizes(s.dens[i], k, j)[1] for j in range(2**k))
                if not exact - F(2 * s.degree + 5, 2**((k + 1) * s.degree)) - 1 <= low <= exact:
                    return False
    def accepts(*rows):
        return not refused(m, lambda: segment(m, rows_of(*rows), (0, 0, 1), (1, 0, 1)))
    # zeros at -1/4, 1/4, and above the middle of the first of 512 pieces: by 1/900, by 1/2000
    return (accepts(((1, 4), (1,))) and not accepts(((-1, 4), (1,))) and accepts((((-225, -256), 230400), (1,)))
            and not accepts((((-125, -64), 128000), (1,))) and not accepts(((1, 1), (1,)), ((-1, 4), ())))


def sizes(f, k, j):
    """Squares are avoided: at most |Re| + |Im|, at least |Re| if real.  Upper and lower bounds of |f| on the piece j of 2^k"""
    mid, radius, out = F(2 * j + 1, 2**(k + 1)), F(1, 2**(k + 1)), []
    for n in range(len(f)):
        x = (F(0), F(0))
        for d in range(len(f) - 1, n - 1, -1):
            b = 1
            for i in range(n):
                b = b * (d - i) // (i + 1)
            x = x[0] + f[d][0] * b * mid**(d - n), x[1] + f[d][1] * b * mid**(d - n)
        out.append(root(square(x)) * radius**n)
    return sum(out), (out or [F(0)])[0] - sum(out[1:])


def root(x, n=10**30):
    """Of a fraction, to 30 digits"""
    from math import isqrt
    return F(isqrt(x.numerator * n * n // x.denominator), n)


def right_piece(s, k, j, table, margin):
    unit = F(1, 2**((k + 1) * s.degree))
    for den, num, bounds_of_row in zip(s.dens, s.nums, table):
        low = sizes(den, k, j)[1]
        for f, bound in zip(num, bounds_of_row):
            high = sizes(f, k, j)[0]
            slack = (s.degree + 2) * unit
            if not f and bound or f and not high / low - F(1, 10**20) <= F(bound, 2**margin) <= (
                    high + slack) / (low - 2 * slack) + F(1, 2**100):
                return False
    return True


def growth(m):
    """The integral of the weighted norm, rounded up; the first number of pieces that is enough"""
    def made(tables, least, enough=2):
        s = object.__new__(m["continuation"].Segment)
        asked = []

        def pieces(k):
            asked.append(k)
            return (tables, least) if k >= enough else None
        s.pieces = pieces
        return s.gronwall(), asked
    unit = 2**m["continuation"].MARGIN
    flat = [[[3 * unit, 0], [0, 5 * unit]], [[20 * unit, 0], [0, 2 * unit]], [[0, 0], [0, 0]], [[unit, 0], [0, unit]]]
    big = [[[0, 2**20 * unit], [unit, 0]]] * 4
    (total, least, w), asked = made(flat, [7, 9])
    (large, _, v), _ = made(big, [1, 1])
    upper = [[[40 * unit, 24 * unit], [8 * unit, 16 * unit]], [[0, 0], [0, 0]], [[8 * unit, 0], [0, 56 * unit]], [[0, 0], [0, 0]]]
    (some, _, u), _ = made(upper, [1, 1])
    rows = [max(sum(F(x) * F(2)**(u[j] - u[i]) for j, x in enumerate(row)) for i, row in enumerate(t)) / unit for t in upper]
    wide, seven = made(flat * 2, [7, 9], 3)
    return (total in (7, 8) and total > F(5 + 20 + 0 + 1, 4) and least == [7, 9] and w == [0, 0] and asked == [2]
            and 2**10 <= large <= 2**12 and abs(v[1] - v[0] + 10) <= 2 and sum(rows) / 4 < some <= sum(rows) / 4 + 2
            and seven == [2, 3] and wide[0] in (7, 8) and made(flat, [7, 9], 9)[1] == list(range(2, 10))
            and refused(m, lambda: made(flat, [7, 9], 10)))


def series(m):
    """The residual of the polynomials is computed coefficient by coefficient: D_i Y_i' - sum B_ij Y_j"""
    for rows, start, end, bits in ((ROWS, START, END, 80), (rows_of(((1, 1), (F(1), 1)), ), (0, 0, 1), (1, 0, 2), 48),
                                   (rows_of((((3, 4),), (1, (0, 2))),), (0, 0, 1), (1, 0, 1), 40)):
        rows = [(den, [[(int(x), int(y)) for x, y in f] for f in num]) for den, num in rows]
        s, n, seen = segment(m, rows, start, end, bits), len(rows), []
        right, s.right = s.right, None
        for k in range(n):
            def checked(i, y, slope):
                seen.append(y)
                found, f, rest, last = right(i, y, slope), s.dens[i], (0, 0), len(y[0]) - 1
                for l in range(1, len(f)):
                    if 0 <= last + 1 - l and last + 1 - l <= last:
                        v = product(f[l], y[i][last + 1 - l])
                        rest = rest[0] - (last + 1 - l) * v[0], rest[1] - (last + 1 - l) * v[1]
                for j, f in enumerate(s.nums[i]):
                    for l, c in enumerate(f):
                        if 0 <= last - l:
                            v = product(c, y[j][last - l])
                            rest = rest[0] + v[0], rest[1] + v[1]
                same.append(found == rest)
                return found
            s.right, same = checked, []
            sums, residual = s.column(k)
            y = [row[:-s.degree - 1] for row in seen[-1]]               # without what is behind the last one
            if not all(same):
                return False
            if [row[0] for row in y] != [(1 << bits, 0) if i == k else (0, 0) for i in range(n)]:
                return False
            if list(sums) != [(sum(u for u, _ in row), sum(v for _, v in row)) for row in y] or not all(
                    tail_is_small(row, s) for row in y):
                return False
            for i in range(n):
                exact = exact_residual(s, i, y)
                if not sum(root(square(x)) for x in exact) - 1 <= residual[i] <= sum(root(square(x)) for x in exact) + len(exact) + 5:
                    return False
                if max(max(map(abs, x)) for x in exact[:len(y[0]) - 1]) > (len(y[0]) + 1) * 9 * max(map(abs, s.dens[i][0])):
                    return False
    return True


def tail_is_small(row, s):
    """It ends where the noise begins, and not long after"""
    small = [max(map(abs, x)) < 1 << s.degree + 8 for x in row]
    ends = next(k for k in range(len(small)) if all(small[k:]))
    return s.degree + 2 <= len(row) - ends <= s.degree + 8 or not any(map(any, row))


def exact_residual(s, i, y):
    """In order, with as many coefficients as there are"""
    n = max(len(s.dens[i]) + len(y[i]), *(len(f) + len(y[j]) for j, f in enumerate(s.nums[i])))
    out = [(0, 0)] * n
    for k, d in enumerate(s.dens[i]):
        for l, x in enumerate(y[i]):
            if l:
                v = product(d, x)
                out[k + l - 1] = out[k + l - 1][0] + l * v[0], out[k + l - 1][1] + l * v[1]
    for j, f in enumerate(s.nums[i]):
        for k, c in enumerate(f):
            for l, x in enumerate(y[j]):
                v = product(c, x)
                out[k + l] = out[k + l][0] - v[0], out[k + l][1] - v[1]
    return out


def errors(m):
    """max |E_i|/|D_i| 2^-w_i, times 3^growth, in the weights"""
    def made(weights, least, residual, growth):
        s = object.__new__(m["continuation"].Segment)
        s.weights, s.least, s.growth, s.dens = weights, least, growth, [None] * len(least)
        s.column = lambda k: ([(10 * i + k, -k) for i in range(len(least))], [r * (k + 1) for r in residual])
        return s.matrix()
    for weights, least, residual, growth in (([0, 0], [1, 1], [100, 7], 1), ([3, -2], [7, 5], [1000, 3000], 2), ([-4, 0], [1, 3], [64, 10**6], 4),
                                             ([0, 9, 2], [10**3, 10, 9], [10**7, 0, 10**4], 3)):
        e, n = made(weights, least, residual, growth), len(least)
        if [[x.m for x in row] for row in e] != [[(10 * i + k, -k) for k in range(n)] for i in range(n)]:
            return False
        for k in range(n):
            norm = max(F(r * (k + 1), low) / F(2)**w for r, low, w in zip(residual, least, weights)) * 3**growth
            for i, w in enumerate(weights):
                most = (max((F(r * (k + 1), low) + 1) / F(2)**x for r, low, x in zip(residual, least, weights)) + F(1, 2**max(
                    weights))) * 3**growth * F(2)**w + 1
                if not norm * F(2)**w <= e[i][k].r <= most:
                    return False
    return True


def ends(m):
    """A series that does not converge is given up behind 8 bits + 64 terms"""
    long = segment(m, rows_of(((100, 99), (100,))), (0, 0, 1), (1, 0, 1), 40)       # ratio 0.99
    asked = []
    right, long.right = long.right, None
    long.right = lambda i, y, slope: (asked.append(len(y[0]) - 1), right(i, y, slope))[1]
    return refused(m, lambda: long.column(0)) and max(asked) == 8 * 40 + 63


def closed(m):
    """Along a polygon, the last segment first; y' = y/z doubles from 1 to 2 and is back at 1"""
    c, m["multivariate"].Work.left = m["continuation"], 10**9
    rows = rows_of(((0, 1), (1,)))
    with m["enclosures"].precision(60):
        one = c.along(rows, [(2, 0, 1), (3, 0, 1), (3, 1, 1)], 60)
        back = c.along(rows, [(2, 0, 1), (3, 0, 1), (3, 1, 1), (3, 0, 1), (2, 0, 1)], 60)
        two = c.along(rows_of(((0, 1), (), (1,)), ((1,), (), ())), [(2, 0, 1), (3, 0, 1), (3, 1, 1), (2, 1, 1), (2, 0, 1)], 60)

    def holds(x, number, bits=60):
        return max(abs(F(a) - F(b) * 2**bits) for a, b in zip(x[0][0].m, number)) <= x[0][0].r < 2**30
    return (holds(one, (F(3, 2), F(1, 2))) and holds(back, (1, 0)) and [len(r) for r in two] == [2, 2]
            and not two[0][1].not_zero() and not two[1][0].not_zero() and two[0][0].not_zero() and max(x.r for row in two for x in row) < 2**30)


def work(m):
    """What is counted is an estimate, and is never nothing"""
    s, left = segment(m), m["multivariate"].Work.left
    s.column(0)
    return m["multivariate"].Work.left + 10 < left < 10**9 - 10


def properties():
    """(name, function, True)"""
    some = (numbers, weights, moved, matrices, on_the_segment, bounds, growth, series, errors, ends, closed, work)
    return [(f"continuation_rules.{f.__name__}", f, True) for f in some]
