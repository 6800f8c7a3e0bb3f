#!/usr/bin/env python3
"""The residues of `kovacic check --order` against the flow itself, in floating point.

usage: flow_test.py PROGRAM

The k-jet of the flow around a solution of the plane q1 = 0 is carried numerically around a pole of the solution
(polynomials in two initial values, truncated at degree k; extrapolated midpoint rule) and written in the constants c1, c2
of the first variational equation.  It has to be 1 below the order of the first logarithm, and there
(c1, c2) + (2 pi i d/delta)(dR/dc2, -dR/dc1), R from the program (docs/theory/jets.md 4).  Nothing is shared with lib/jets.
"""

import cmath
import json
import math
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

TERMS = 60  # of the series that start the integration


class Vector(list):
    def __add__(a, b):
        return Vector(x + y for x, y in zip(a, b))

    def __sub__(a, b):
        return Vector(x - y for x, y in zip(a, b))

    def __rmul__(a, c):
        return Vector(c * x for x in a)

    def __truediv__(a, c):
        return Vector(x / c for x in a)


def product(p, q):
    r = [0j] * TERMS
    for i, a in enumerate(p):
        if a:
            for j in range(TERMS - i):
                r[i + j] += a * q[j]
    return r


def power(p, n):
    r = [1 + 0j] + [0j] * (TERMS - 1)
    for _ in range(n):
        r = product(r, p)
    return r


class Start:
    """The solution y and u1, u2 at a point near the pole, from their series in s, t = s^d."""

    def __init__(self, potential, energy, rho, radius):
        self.v = potential
        self.k = max(b for a, b in potential if a == 0)
        self.sigma = Fraction(-2, self.k - 2)
        self.scale = float(self.sigma * (self.sigma - 1)) / (-self.k * potential[(0, self.k)])
        self.d = math.lcm(self.sigma.denominator, *(r.denominator for r in rho))
        self.low = int(self.sigma * self.d)
        self.t = radius * cmath.exp(0.3j)
        self.s = radius ** (1 / self.d) * cmath.exp(0.3j / self.d)
        h = [self.energy(self.solution(e)) for e in (0, 1e-3)]
        self.series = self.solution(1e-3 * (energy - h[0]) / (h[1] - h[0]))
        self.y = self.at(self.series, self.low)
        w = self.normal_force()
        self.u = [self.at(self.normal(w, r, rho[0]), int(r * self.d)) for r in rho]

    def at(self, c, low):
        value = sum(x * self.s ** (low + n) for n, x in enumerate(c))
        slope = sum(x * self.s ** (low + n - self.d) * (low + n) / self.d for n, x in enumerate(c))
        return value, slope

    def energy(self, c):
        y, slope = self.at(c, self.low)
        return slope**2 / (2 * self.scale) + sum(x * y**b for (a, b), x in self.v.items() if a == 0)

    def solution(self, e):
        c = [1 + 0j] + [0j] * (TERMS - 1)
        for n in range(1, TERMS):
            rest = 0
            for (a, b), x in self.v.items():
                i = n - 2 * self.d - self.low * (b - 2)
                if a == 0 and b > 0 and i >= 0:
                    rest -= self.scale * b * x * power(c, b - 1)[i]
            m = Fraction(self.low + n, self.d)
            indicial = m * (m - 1) - (self.k - 1) * self.sigma * (self.sigma - 1)
            assert indicial or abs(rest) < 1e-9
            c[n] = rest / float(indicial) if indicial else e
        return c

    def normal_force(self):
        w = [0j] * TERMS
        for (a, b), x in self.v.items():
            if a == 2:
                shift = self.low * b + 2 * self.d
                p = power(self.series, b)
                for n in range(shift, TERMS):
                    w[n] -= 2 * self.scale * x * p[n - shift]
        return w

    def normal(self, w, rho, rho1):
        u = [1 + 0j] + [0j] * (TERMS - 1)
        for n in range(1, TERMS):
            m = rho + Fraction(n, self.d)
            indicial = m * (m - 1) - rho1 * (rho1 - 1)
            rest = sum(w[i] * u[n - i] for i in range(1, n + 1))
            assert indicial or abs(rest) < 1e-6
            u[n] = rest / float(indicial) if indicial else 0
        return u


class Jets:
    """Polynomials in two variables up to a degree."""

    def __init__(self, degree):
        self.monomials = [(i, n - i) for n in range(degree + 1) for i in range(n, -1, -1)]
        place = {m: i for i, m in enumerate(self.monomials)}
        self.place = place
        self.table = [(place[a], place[b], place[(a[0] + b[0], a[1] + b[1])]) for a in place for b in place
                      if (a[0] + b[0], a[1] + b[1]) in place]

    def zero(self):
        return Vector([0j] * len(self.monomials))

    def times(self, p, q):
        r = self.zero()
        for i, j, k in self.table:
            if p[i] and q[j]:
                r[k] += p[i] * q[j]
        return r

    def powers(self, p, most):
        one = self.zero()
        one[0] = 1
        all_powers = [one]
        for _ in range(most):
            all_powers.append(self.times(all_powers[-1], p))
        return all_powers


def integrate(field, end, z, steps):
    """The extrapolated midpoint rule (Gragg, Bulirsch, Stoer) of order 16."""
    numbers = [2, 4, 6, 8, 10, 12, 14, 16]
    big = end / steps
    for k in range(steps):
        t, table = k * big, []
        for j, n in enumerate(numbers):
            h = big / n
            a, b = z, z + h * field(t, z)
            for m in range(1, n):
                a, b = b, a + 2 * h * field(t + m * h, b)
            table.append((a + b + h * field(t + big, b)) / 2)
            for i in range(j - 1, -1, -1):
                table[i] = table[i + 1] + (table[i + 1] - table[i]) / ((numbers[j] / numbers[i]) ** 2 - 1)
        z = table[0]
    return z


def change_of_constants(potential, energy, order, rho, radius):
    """(c1, c2) after d turns minus before, as polynomials, and the largest coefficient below the order."""
    start, jets = Start(potential, energy, rho, radius), Jets(order)
    root, size = cmath.sqrt(start.scale), len(jets.monomials)
    most = [max(m[i] for m in potential) for i in (0, 1)]

    def field(theta, z):
        x, y, px, py = (Vector(z[q * size : (q + 1) * size]) for q in range(4))
        xs, ys = jets.powers(x, most[0]), jets.powers(y, most[1])
        fx, fy = jets.zero(), jets.zero()
        for (a, b), c in potential.items():
            if a:
                fx = fx - (c * a) * jets.times(xs[a - 1], ys[b])
            if b:
                fy = fy - (c * b) * jets.times(xs[a], ys[b - 1])
        return (root * start.t * 1j * cmath.exp(1j * theta)) * Vector([*px, *py, *fx, *fy])

    x, y, px, py = (jets.zero() for _ in range(4))
    y[0], py[0] = start.y[0], start.y[1] / root
    for m, (u, slope) in zip(((1, 0), (0, 1)), start.u):
        x[jets.place[m]], px[jets.place[m]] = u, slope / root
    before = Vector([*x, *y, *px, *py])
    change = integrate(field, 2 * math.pi * start.d, before, 16 * start.d) - before
    dx, dp = change[:size], change[2 * size : 3 * size]
    (u1, v1), (u2, v2) = ((u, v / root) for u, v in start.u)
    det = u1 * v2 - u2 * v1
    c = [{m: (dx[i] * v2 - dp[i] * u2) / det for m, i in jets.place.items()},
         {m: (dp[i] * u1 - dx[i] * v1) / det for m, i in jets.place.items()}]
    below = max(abs(change[q * size + i]) for q in range(4) for m, i in jets.place.items() if sum(m) < order)
    return c, below / (1 + max(map(abs, before))), start.d


def ask(program, potential, energy, order):
    """Order, exponents and R(c1, c2) as a function of the program's answer; order None: no logarithm."""
    terms = " + ".join(f"({c})*q1^{a}*q2^{b}" for (a, b), c in potential.items())
    text = f"""[system]
kind = "hamiltonian"
coordinates = ["q1", "q2"]
momenta = ["p1", "p2"]
parameters = ["h"]
hamiltonian = "(p1^2 + p2^2)/2 + {terms}"
[[manifold]]
name = "N"
equations = ["q1 = 0", "p1 = 0"]
level = "H = h"
"""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "plane.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        run = subprocess.run([program, "check", path, "--order", str(order), "--format", "json"], capture_output=True,
                             text=True, check=False)
    higher = json.loads(run.stdout)["results"][0]["manifolds"][0]["higher_orders"]
    if "residue" not in higher:
        assert "open" not in higher, higher
        return None, {}
    residue = higher["residue"].replace("^", "**")
    degree = higher["order"] + 1
    names = {"E": float(Fraction(energy))}
    points = [(math.cos(2.1 * j + 0.3), math.sin(2.1 * j + 0.3)) for j in range(degree + 1)]
    matrix = [[x**i * y ** (degree - i) for i in range(degree + 1)]
              + [eval(residue, {"c1": x, "c2": y, **names})] for x, y in points]
    return higher["order"], solve(matrix)


def solve(m):
    """Gauss-Jordan; {i: coefficient of c1^i}."""
    n = len(m)
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(m[r][i]))
        m[i], m[pivot] = m[pivot], m[i]
        m[i] = [x / m[i][i] for x in m[i]]
        for r in range(n):
            if r != i:
                m[r] = [x - m[r][i] * y for x, y in zip(m[r], m[i])]
    return {i: m[i][n] for i in range(n)}


def compare(program, name, potential, energy, order, rho, radius=0.45):
    found, form = ask(program, potential, energy, order)
    exact = {m: Fraction(c) for m, c in potential.items()}
    rho = [Fraction(r) for r in rho]
    look_at = found or order
    c, below, d = change_of_constants({m: float(x) for m, x in exact.items()}, float(Fraction(energy)), look_at, rho,
                                      radius)
    factor = 2j * math.pi * d / float(rho[1] - rho[0])
    degree = look_at + 1
    worst, size = 0, 1e-3
    for i in range(look_at + 1):
        m = (i, look_at - i)
        wanted = (factor * form.get(i, 0) * (degree - i), -factor * form.get(i + 1, 0) * (i + 1))
        worst = max(worst, abs(c[0][m] - wanted[0]), abs(c[1][m] - wanted[1]))
        size = max(size, abs(wanted[0]), abs(wanted[1]))
    ok = below < 1e-6 and worst < 1e-5 * size
    print(f"{'ok' if ok else 'FAILED':7}{name:36} order {found or 'none up to ' + str(order)}: "
          f"below {below:.1e}, there {worst:.1e} of {size:.2e}")
    return ok


def henon_heiles(a, b, beta):
    return {(2, 0): Fraction(a) / 2, (0, 2): Fraction(b) / 2, (2, 1): Fraction(1), (0, 3): Fraction(beta) / 3}


def texts(potential):
    return {m: str(c) for m, c in potential.items()}


CASES = [
    ("Henon-Heiles b = 2", texts(henon_heiles("13/10", "-7/10", 2)), "2/5", 3, (-2, 3)),
    ("Henon-Heiles b = 1", texts(henon_heiles(1, 2, 1)), "1/2", 3, (-3, 4)),
    ("Henon-Heiles b = 1, A = B", texts(henon_heiles("6/5", "6/5", 1)), "1/2", 4, (-3, 4)),
    ("Henon-Heiles b = 6", texts(henon_heiles(1, "3/10", 6)), "1/2", 4, (-1, 2)),
    ("Henon-Heiles b = 16, B = 16A", texts(henon_heiles("1/2", 8, 16)), "3/10", 3, ("-1/2", "3/2")),
    ("cubic, lambda = 1", {(0, 3): "1/3", (2, 1): "1/2", (3, 0): "7/10"}, "1/2", 2, (-2, 3)),
    ("quartic, lambda = 1", {(0, 4): "1/4", (2, 2): "1/2", (3, 1): "3/10", (4, 0): "9/40"}, "1/2", 2, (-1, 2)),
    ("quartic, lambda = 3", {(2, 0): "1/2", (0, 2): "1/5", (0, 4): "1/2", (2, 2): "3", (4, 0): "5/4"}, "1/2", 3,
     (-2, 3)),
    ("quartic with odd terms", {(0, 4): "1/2", (0, 3): "1/3", (2, 2): "3", (2, 1): "1", (4, 0): "1/5", (3, 0): "1/7"},
     "2/5", 2, (-2, 3)),
    ("degree 5", {(0, 5): "1/5", (2, 3): "1/2", (3, 2): "1/5"}, "1/2", 2, ("-2/3", "5/3"), 0.3),
    ("degree 6", {(0, 6): "1/6", (2, 4): "1/2", (3, 3): "1/5", (4, 0): "1/7"}, "1/2", 2, ("-1/2", "3/2"), 0.3),
]

if __name__ == "__main__":
    sys.exit(0 if all([compare(sys.argv[1], *case) for case in CASES]) else 1)
