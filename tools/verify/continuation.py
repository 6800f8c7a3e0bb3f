"""Continuation of Y' = A(z) Y along polygons with proven errors, in integers (docs/theory/loop_certificates.md 3).

Numbers are pairs of integers over a power of two.  Whatever coefficients the series has, its residual is computed
exactly, and Gronwall's inequality turns it into a bound of the error."""
from math import isqrt

from certificate_format import need
from multivariate import spend

PIECES, NOISE, MARGIN, ROUNDS, GUARD = 9, 8, 128, 8, 16
SHARE = 2500                                # bits that are multiplied, for one unit of work


def times(a, b):
    return a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]


def plus(a, b):
    return a[0] + b[0], a[1] + b[1]


def above(a):
    """An integer >= |a|."""
    return isqrt(a[0] * a[0] + a[1] * a[1]) + 1


def below(a):
    """An integer <= |a|."""
    return isqrt(a[0] * a[0] + a[1] * a[1])


def times_power(x, e):
    """An integer >= x 2^e, 0 for 0."""
    return 0 if not x else x << e if e >= 0 else (x >> -e) + 1


def balanced(table):
    """Weights w such that rows and columns of table_ij 2^(w_j - w_i) have like size; any integers are correct."""
    n = len(table)
    w = [0] * n
    for i in [*range(n)] * ROUNDS:
        row, column = (max((times_power(x, e) for x, e in v), default=0) for v in
                       ([(table[i][j], w[j] - w[i]) for j in range(n) if j != i],
                        [(table[j][i], w[i] - w[j]) for j in range(n) if j != i]))
        if row and column:
            w[i] += (row.bit_length() - column.bit_length()) // 2
    return w


def shifted(f, degree, point, step, scale):
    """scale^degree f((point + step t)/scale) as a polynomial in t."""
    out, power = [], scale**(degree + 1 - len(f))
    for c in reversed(f):
        out = [plus(times(x, point), times(y, step)) for x, y in zip(out + [(0, 0)], [(0, 0)] + out)]
        out[0] = plus(out[0], (c[0] * power, c[1] * power))
        power *= scale
    return out


class Enclosure:
    """A matrix: entries times 2^bits are within `errors` of pairs of integers."""

    def __init__(self, rows, errors, bits):
        self.rows, self.errors, self.bits = rows, errors, bits

    def __mul__(self, o):
        columns, rows, errors = list(zip(*o.rows)), [], []
        sizes, far = [[above(x) for x in column] for column in columns], list(zip(*o.errors))
        for row, error in zip(self.rows, self.errors):
            rows.append([])
            errors.append([])
            for column, size, other in zip(columns, sizes, far):
                x = y = e = 0
                for a, b, s, f, g in zip(row, column, size, error, other):
                    x += a[0] * b[0] - a[1] * b[1]
                    y += a[0] * b[1] + a[1] * b[0]
                    e += above(a) * g + f * (s + g)
                rows[-1].append((x >> self.bits, y >> self.bits))
                errors[-1].append((e >> self.bits) + 3)
        return Enclosure(rows, errors, self.bits)

    def __sub__(self, o):
        return Enclosure([[(a[0] - b[0], a[1] - b[1]) for a, b in zip(r, s)] for r, s in zip(self.rows, o.rows)],
                         [[e + f for e, f in zip(r, s)] for r, s in zip(self.errors, o.errors)], self.bits)

    def __pow__(self, n):
        out = identity(len(self.rows), self.bits)
        for bit in bin(n)[2:]:
            out = out * out
            out = out * self if bit == "1" else out
        return out

    def scalar(self, i, j):
        return Enclosure([[self.rows[i][j]]], [[self.errors[i][j]]], self.bits)

    def not_zero(self, i=0, j=0):
        return below(self.rows[i][j]) > self.errors[i][j]


def identity(n, bits):
    return Enclosure([[(1 << bits, 0) if i == j else (0, 0) for j in range(n)] for i in range(n)],
                     [[0] * n for _ in range(n)], bits)


class Segment:
    """z = start + (end - start) t; the rows den Y_i' = sum num Y_j are over the Gaussian integers."""

    def __init__(self, rows, start, end, bits):
        scale = max(start[2], end[2])
        point, target = ([v * (scale // x[2]) for v in x[:2]] for x in (start, end))
        step, self.bits = (target[0] - point[0], target[1] - point[1]), bits
        self.dens, self.nums = [], []
        for den, num in rows:
            degree = max(len(den), *map(len, num)) - 1
            by, along = (scale << GUARD, 0), times(step, (1 << GUARD, 0))         # so that lower bounds are not small integers
            self.dens.append([times(c, by) for c in shifted(den, degree, point, step, scale)])
            self.nums.append([[times(c, along) for c in shifted(f, degree, point, step, scale)] if f else [] for f in num])
        self.degree = max(len(f) for f in self.dens + [f for row in self.nums for f in row]) - 1
        self.growth, self.least, self.weights = self.gronwall()

    def gronwall(self):
        """An integer >= the integral of the weighted norm of A, lower bounds of each den on the segment, the weights."""
        for k in range(2, PIECES + 1):
            found = self.pieces(k)
            if found:
                tables, least = found
                n = len(least)
                w = balanced([[max(t[i][j] for t in tables) for j in range(n)] for i in range(n)])
                total = sum(max(sum(times_power(x, w[j] - w[i]) for j, x in enumerate(row)) for i, row in enumerate(t))
                            for t in tables)
                return (total >> (MARGIN + k)) + 1, least, w
        need(False, "a segment comes too near to a singularity")

    def pieces(self, k):
        """Bounds of |num_ij|/|den_i| times 2^MARGIN for each of 2^k pieces, and those of |den_i|; None: too few pieces."""
        tables, least = [], [None] * len(self.dens)
        for j in range(2**k):
            def on_piece(f):                     # 2^((k+1) degree) f in u, |u| <= 1, about the middle of the piece
                spend(len(f)**2 * (self.bits + 1000) // SHARE)
                return [above(c) for c in shifted(f, self.degree, (2 * j + 1, 0), (1, 0), 2**(k + 1))]
            tables.append([])
            for i, (den, num) in enumerate(zip(self.dens, self.nums)):
                d = on_piece(den)
                low = d[0] - 2 - sum(d[1:])
                if low <= 0:
                    return None
                tables[-1].append([(sum(on_piece(f)) << MARGIN) // low + 1 if f else 0 for f in num])
                low >>= (k + 1) * self.degree
                least[i] = low if least[i] is None else min(least[i], low)
        return (tables, least) if all(least) else None

    def matrix(self):
        columns, errors, w = [], [], self.weights
        for m in range(len(self.dens)):
            value, residual = self.column(m)
            columns.append(value)
            most = max(times_power((r // low) + 1, max(w) - x) for r, low, x in zip(residual, self.least, w))
            errors.append([times_power(most * 3**self.growth, x - max(w)) for x in w])
        return Enclosure([list(row) for row in zip(*columns)], [list(row) for row in zip(*errors)], self.bits)

    def right(self, i, k, y, last):
        """What the recurrence puts on the right of den_0 (k + 1) y_(k+1); coefficients behind the last one are 0."""
        a = b = 0
        for j, f in enumerate(self.nums[i]):
            s = y[j]
            for l in range(max(0, k - last), min(k + 1, len(f))):
                (c, d), (u, v) = f[l], s[k - l]
                a += c * u - d * v
                b += c * v + d * u
        f, s = self.dens[i], y[i]
        for l in range(max(1, k + 1 - last), min(k + 1, len(f))):
            (c, d), (u, v), e = f[l], s[k + 1 - l], k + 1 - l
            a -= e * (c * u - d * v)
            b -= e * (c * v + d * u)
        return a, b

    def column(self, m):
        """The sum of a series with Y(0) = e_m, and bounds of the residuals for |t| <= 1."""
        n, bits = len(self.dens), self.bits
        y = [[(1 << bits, 0) if i == m else (0, 0)] for i in range(n)]
        residual, quiet, k = [0] * n, 0, 0
        small = 1 << (self.degree + NOISE)
        heads = [(f[0], f[0][0]**2 + f[0][1]**2) for f in self.dens]
        while quiet <= self.degree + 1:
            need(k < 8 * bits + 64, "a series does not converge")
            spend(n * (n + 1) * (self.degree + 1) * (bits + 200) // SHARE)
            new = []
            for i, ((c, d), norm) in enumerate(heads):
                a, b = self.right(i, k, y, k)
                w = norm * (k + 1)
                u, v = (2 * (a * c + b * d) + w) // (2 * w), (2 * (b * c - a * d) + w) // (2 * w)
                residual[i] += above(((k + 1) * (c * u - d * v) - a, (k + 1) * (c * v + d * u) - b))
                new.append((u, v))
            for s, x in zip(y, new):
                s.append(x)
            k += 1
            quiet = quiet + 1 if all(abs(u) < small and abs(v) < small for u, v in new) else 0
        for i in range(n):
            for j in range(k, k + self.degree + 1):
                residual[i] += above(self.right(i, j, y, k))
        return [(sum(u for u, _ in s), sum(v for _, v in s)) for s in y], residual


def along(rows, polygon, bits):
    """Continuation along a closed polygon: Y becomes Y M, Y = 1 at its first point."""
    matrix = identity(len(rows), bits)
    for start, end in zip(polygon, polygon[1:]):
        matrix = Segment(rows, start, end, bits).matrix() * matrix
    return matrix
