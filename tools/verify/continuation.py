"""Continuation of Y' = A(z) Y along polygons with proven errors, in integers (docs/theory/loop_certificates.md 3).

Numbers are in Z[i] over a power of two.  Whatever coefficients the series has, its residual is computed
exactly, and Gronwall's inequality turns it into a bound of the error."""
from functools import reduce

from certificate_format import need
from enclosures import Ball, Gaussian, matrix
from multivariate import spend

PIECES, NOISE, MARGIN, ROUNDS, GUARD = 9, 8, 128, 8, 16
SHARE = 2500                                # bits that are multiplied, for one unit of work


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
        out = [x * point + y * step for x, y in zip([*out, Gaussian(0)], [Gaussian(0), *out])]
        out[0] += Gaussian(*c) * Gaussian(power)
        power *= scale
    return out


class Segment:
    """z = start + (end - start) t; the rows den Y_i' = sum num Y_j are over the Gaussian integers."""

    def __init__(self, rows, start, end, bits):
        scale = max(start[2], end[2])
        point, target = (Gaussian(*x[:2]) * Gaussian(scale // x[2]) for x in (start, end))
        step, self.bits, self.dens, self.nums = target - point, bits, [], []
        by, along = Gaussian(scale << GUARD), step * Gaussian(1 << GUARD)       # so that lower bounds are not small integers
        for den, num in rows:
            degree = max(len(den), *map(len, num)) - 1
            self.dens.append([tuple(c * by) for c in shifted(den, degree, point, step, scale)])
            self.nums.append([[tuple(c * along) for c in shifted(f, degree, point, step, scale)] if f else [] for f in num])
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
                return list(map(abs, shifted(f, self.degree, Gaussian(2 * j + 1), Gaussian(1), 2**(k + 1))))
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
        columns, w = [], self.weights
        for m in range(len(self.dens)):
            value, residual = self.column(m)
            most = max(times_power((r // low) + 1, max(w) - x) for r, low, x in zip(residual, self.least, w))
            columns.append([Ball(v, times_power(most * 3**self.growth, x - max(w))) for v, x in zip(value, w)])
        return list(zip(*columns))

    def right(self, i, y, slope):
        """What the recurrence puts on the right of den_0 times the next coefficient of y_i'"""
        a = b = 0
        for f, s in zip(self.nums[i], y):
            for (c, d), (u, v) in zip(f, s[:-len(f) - 1:-1]):
                a += c * u - d * v
                b += c * v + d * u
        f = self.dens[i][1:]
        for (c, d), (u, v) in zip(f, slope[i][:-len(f) - 1:-1]):
            a -= c * u - d * v
            b -= c * v + d * u
        return a, b

    def column(self, m):
        """The sum of a series with Y(0) = e_m, and bounds of the residuals for |t| <= 1."""
        n, bits = len(self.dens), self.bits
        y, slope = [[(int(i == m) << bits, 0)] for i in range(n)], [[] for _ in range(n)]       # and y'
        residual, quiet, k = [0] * n, 0, 0
        small = 1 << (self.degree + NOISE)
        heads = [(f[0], f[0][0]**2 + f[0][1]**2) for f in self.dens]
        while quiet <= self.degree + 1:
            need(k < 8 * bits + 64, "a series does not converge")
            spend(n * (n + 1) * (self.degree + 1) * (bits + 200) // SHARE)
            new, k = [], k + 1
            for i, ((c, d), norm) in enumerate(heads):
                a, b = self.right(i, y, slope)
                w = norm * k
                u, v = (2 * (a * c + b * d) + w) // (2 * w), (2 * (b * c - a * d) + w) // (2 * w)
                residual[i] += abs(Gaussian(k * (c * u - d * v) - a, k * (c * v + d * u) - b))
                new.append((u, v))
            for s, t, (u, v) in zip(y, slope, new):
                s.append((u, v))
                t.append((k * u, k * v))
            quiet = quiet + 1 if all(abs(u) < small and abs(v) < small for u, v in new) else 0
        for _ in range(self.degree + 1):
            residual = [r + abs(Gaussian(*self.right(i, y, slope))) for i, r in enumerate(residual)]
            for s in (*y, *slope):
                s.append((0, 0))
        return [Gaussian(*map(sum, zip(*s))) for s in y], residual


def along(rows, polygon, bits):
    """Continuation along a closed polygon: Y becomes Y M, Y = 1 at its first point."""
    steps = (Segment(rows, start, end, bits).matrix() for start, end in zip(polygon, polygon[1:]))
    return reduce(lambda m, step: matrix(step, m), steps)
