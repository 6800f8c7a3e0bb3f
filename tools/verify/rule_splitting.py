"""Splitting of separatrices of a perturbed Euler top (docs/theory/theorem_certificates.md 6; splitting.md)."""
from fractions import Fraction
from itertools import product as pairs
from math import factorial

from certificate_format import COND, need, right
from condition import ConditionSet
from core import Said
from family import Family, brackets
from monomials import parts
from multivariate import FIELD, MASK, ONE, P, parse
from phase_space import NOTHING, Function, total
from theorem_statement import REAL, SYMMETRIC_TOP
from tower import Tower

NAMES = ["_alpha", "_beta", "_delta", "_s", "_F", "_Y"]
MOST = 12
FIELDS = {"system": "text", "moments": ["text"] * 3, "small": ["text"] * 3, "order": "int", "first": "text", "power": "int",
          "region": [COND], "proof": "any"}


def variable(x, c=1):
    return P({1 << x: c})


def over_sinh(top, n, square):
    """x top(x)/sinh x up to x^n, by its square; top(k): the coefficient of x^(2k)"""
    found = []
    for k in range(n // 2 + 1):
        found.append(top(k) - sum(c / factorial(2 * (k - j) + 1) for j, c in enumerate(found)))
    return total(Function(square**k * c.numerator, c.denominator) for k, c in enumerate(found))


class Orbits:
    """theta times M, and theta zeta times Gamma, on the orbit sigma at the point z = sign i, up to theta^n"""

    def __init__(self, at, moments, n):
        a, b, c = moments
        self.alpha, self.beta, self.delta, self.s, self.F, self.Y, self.i, self.theta, self.zeta = map(variable, at)
        self.b, self.n, (self.imaginary, *self.at) = a * c, n, at[6:]
        self.square = {at[0]: c * (a - b), at[1]: a * (b - c), at[2]: b * (a - c), at[6]: ONE * -1,
                       at[3]: ONE - self.F * self.F}
        x = a * c * (a - b) * (b - c) * self.theta**2
        self.f, self.g = over_sinh(lambda k: Fraction(k == 0), n, x), over_sinh(lambda k: Fraction(1, factorial(2 * k)), n, x)

    def reduced(self, f):
        f = Function(P((k, c) for k, c in f.p.items() if k >> self.at[0] & MASK <= self.n), f.n)
        for x, square in self.square.items():
            even, odd = (Tower.even(f.p.coefficients(x)[half::2], Function(square)) for half in (0, 1))
            f = Function(even + odd * variable(x), f.n)
        return f

    def coordinates(self, sigma, sign):
        alpha, beta, delta, one, T, zeta = self.alpha, self.beta, self.delta, Function(self.theta), self.g, self.zeta

        def sum_of(*terms):
            return total(Function(c) * x for c, x in terms)
        V = sum_of((self.i * -sign, self.f))
        M = [sum_of((beta * 2, V)), sum_of((delta * (-2 * sigma), T)), sum_of((alpha * (2 * sigma), V))]

        def E(i):
            return [sum_of((i * alpha * alpha * beta * sigma, one), (i * i * beta * sigma, T)), sum_of((delta * -1, V)),
                    sum_of((alpha * -1, T), (i * alpha * beta * beta * -1, one))]
        rows = zip(M, E(self.i), E(self.i * -1))
        return M + [sum_of((self.F * zeta, x), (self.s * zeta**2, up), (self.s, down)) for x, up, down in rows]

    def sums(self, perturbation):
        """perturbation: pairs (exponents of the coordinates, coefficient).  Real and imaginary parts, k = 1, 2, ..."""
        rho = {(sigma, sign): self.residues(perturbation, self.coordinates(sigma, sign))
               for sigma, sign in pairs((1, -1), (1, -1))}
        for k, sigma in pairs(range(1, self.n + 1), (1, -1)):
            f = rho[sigma, 1].get(k, NOTHING) + rho[sigma, -1].get(k, NOTHING) * Function(self.Y**k)
            yield from (g.primitive() for g in (self.reduced(f).p.coefficients(self.imaginary) + [P(), P()])[:2])

    def residues(self, perturbation, x):
        """The coefficient of zeta^k/theta in the perturbation times exp(i k b theta)"""
        unit, known, found = self.alpha * self.beta * self.delta * 2, {(0,) * 6: Function(ONE)}, {}

        def monomial(e):
            if e not in known:
                j = next(j for j in range(6) if e[j])
                known[e] = self.reduced(x[j] * monomial((*e[:j], e[j] - 1, *e[j + 1:])))
            return known[e]
        theta, zeta = self.at
        for e, c in perturbation:
            d, shift, f = sum(e), sum(e[3:]), monomial(e)
            for k, row in enumerate(f.p.coefficients(zeta)[shift + 1:], 1):
                left = ((d - 1 - j, g) for j, g in enumerate(row.coefficients(theta)[:d]))
                part = total(Function(g * (self.i * self.b * k)**j, f.n * factorial(j)) for j, g in left)
                found[k] = self.reduced(found.get(k, NOTHING) + part * Function(c * unit**(self.n - d)))
        return found


def degree_of(k, places):
    return sum(k >> x & MASK for x in places)


class Splitting:
    """The region of a step `splitting` of this family, checked"""

    def __init__(self, family, d):
        self.family, self.space = family, family.space
        names = d["moments"] + d["small"]
        right(len(set(names)) == 6, "three moments and three parameters")
        right(all(x in family.names for x in names), "a parameter is expected")
        right(not set(NAMES + ["_i"]) & set(self.space.names), "a name is taken")
        self.moments, self.small = ([family.names[x] for x in d[key]] for key in ("moments", "small"))
        need(len(self.space.coordinates) == 6 and brackets(self.space) == brackets(Family(SYMMETRIC_TOP).space),
             "not the bracket of e(3)")           # {M_i, M_j} = -eps_ijk M_k, {M_i, G_j} = -eps_ijk G_k
        self.region = family.region(d["region"])
        self.need_scaling()
        P1 = parse(d["first"], {x: v for x, v in self.space.at.items() if x not in self.space.inverses})
        self.need_order(P1, d["order"], d["power"])
        a, b, c = (variable(x) for x in self.moments)
        for f in (a - b, b - c, c):
            need((f, "positive") in self.region, "the moments are not known to be ordered")
        self.need_split(P1, (a, b, c), d["proof"])

    def need_scaling(self):
        gamma = [FIELD * j for j in range(3, 6)]
        for f in [self.space.hamiltonian, *self.space.denominators.values()]:
            need(all(degree_of(k, gamma) == degree_of(k, self.small) for k in f.p), "the system does not scale")

    def need_order(self, first, order, power):
        coordinates = [FIELD * j for j in range(6)]
        need(order >= 1 and 1 <= power <= 12, "an order or a power is out of range")
        need(all(degree_of(k, self.small) == order and degree_of(k, coordinates) <= MOST for k in first), "not of this order")
        for h in self.space.denominators.values():
            free = [k for k in h.p if not degree_of(k, self.small)]
            need(len(free) == 1 and degree_of(free[0], self.moments) == sum(free[0] >> x & MASK for x in range(0, 64 * FIELD, FIELD)),
                 "a denominator may vanish")
        M, (a, b, c) = [variable(x) for x in coordinates[:3]], (variable(x) for x in self.moments)
        whole = (a * b * c)**(power - 1)
        euler = whole * (b * c * M[0]**2 + a * c * M[1]**2 + a * b * M[2]**2)
        rest = Function(whole * a * b * c * 2) * self.space.hamiltonian - Function(euler) - Function(first)
        need(all(degree_of(k, self.small) > order for k in self.space.cleared(rest).p), "another perturbation")

    def need_split(self, first, moments, proof):
        top = FIELD * len(self.space.names)
        at = [top + FIELD * j for j in range(9)]
        need(len(self.space.names) + 7 <= 64, "too many names")
        coordinates = [FIELD * j for j in range(6)]
        terms = [(tuple(k >> x & MASK for x in coordinates), c) for k, c in parts(first, coordinates).items()]
        degree = max((sum(e) for e, _ in terms), default=0)
        orbits = Orbits(at, moments, degree)
        names = self.family.names | dict(zip(NAMES, at))
        x = dict(zip(NAMES, (variable(k) for k in at)))
        given = self.family.assumptions + self.region + [(x[name], "positive") for name in NAMES]
        given.append((ONE - x["_Y"], "positive"))
        given += [(orbits.square[k] - variable(k)**2, "zero") for k in at[:3]]
        given.append((ONE - x["_F"]**2 - x["_s"]**2, "zero"))
        given += [(f, "zero") for f in orbits.sums(terms)]
        ConditionSet(names).also(*given).absent(proof)


def said(theorem, d):
    y = theorem.plain_family(d)
    return Said("N", y, [Splitting(y, d).region], [REAL], (), ["Ziglin 1980"])
