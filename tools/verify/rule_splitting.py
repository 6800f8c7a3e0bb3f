"""Splitting of separatrices of a perturbed Euler top (docs/theory/theorem_certificates.md 6; splitting.md)."""
from itertools import product as pairs

from certificate_format import COND, need, right
from condition import ConditionSet
from core import Said
from family import Family
from multivariate import FIELD, MASK, ONE, P, parse
from phase_space import Function, total
from theorem_statement import REAL, SYMMETRIC_TOP
from tower import Tower

NAMES = ["_alpha", "_beta", "_delta", "_s", "_F", "_Y"]
MOST = 12
FIELDS = {"system": "text", "moments": ["text"], "small": ["text"], "order": "int", "first": "text", "power": "int",
          "region": [COND], "proof": "any"}


def variable(x, c=1):
    return P({1 << x: c})


def series_of_sinh(n, q):
    """x/sinh x and x/tanh x in theta, x^2 = q theta^2, up to theta^n: from 1/k!, by division"""
    sinh, cosh, fact = [], [], 1
    for k in range(n + 2):
        fact *= max(k, 1)
        (sinh if k % 2 else cosh).append(Function(ONE, fact))
    one = [Function(ONE)] + [Function(P())] * (n // 2)
    rows = []
    for top in (one, cosh):
        quotient = []
        for k in range(n // 2 + 1):
            quotient.append(top[k] - total(quotient[j] * sinh[k - j] for j in range(k)))
        rows.append([quotient[k // 2] * Function(q**(k // 2)) if k % 2 == 0 else Function(P()) for k in range(n + 1)])
    return rows


class Orbits:
    """theta times the coordinates on the orbit sigma at the point z = sign i, as series in theta whose coefficients are
    polynomials; by their power of zeta."""

    def __init__(self, at, moments, degree):
        a, b, c = moments
        self.alpha, self.beta, self.delta, self.s, self.F, self.Y, self.i = (variable(x) for x in at)
        self.imaginary = at[6]
        self.square = {at[0]: c * (a - b), at[1]: a * (b - c), at[2]: b * (a - c), at[6]: ONE * -1,
                       at[3]: ONE - self.F * self.F}
        self.b, self.n = a * c, degree
        self.f, self.g = series_of_sinh(degree, a * c * (a - b) * (b - c))

    def reduced(self, f):
        for x, square in self.square.items():
            even, odd = (Tower.even(f.p.coefficients(x)[half::2], Function(square)) for half in (0, 1))
            f = Function(even + odd * variable(x), f.n)
        return f

    def coordinates(self, sigma, sign):
        one = [Function(P()), Function(ONE)] + [Function(P())] * (self.n - 1)       # theta
        V = [Function(self.i * -sign) * x for x in self.f]
        alpha, beta, delta = self.alpha, self.beta, self.delta

        def sum_of(*terms):
            return [total(Function(c) * row[k] for c, row in terms) for k in range(self.n + 1)]
        T = self.g
        M = [sum_of((beta * 2, V)), sum_of((delta * (-2 * sigma), T)), sum_of((alpha * (2 * sigma), V))]

        def E(i):
            return [sum_of((i * alpha * alpha * beta * sigma, one), (i * i * beta * sigma, T)), sum_of((delta * -1, V)),
                    sum_of((alpha * -1, T), (i * alpha * beta * beta * -1, one))]
        up, down = E(self.i), E(self.i * -1)
        momentum = [{0: row} for row in M]
        gamma = [{0: sum_of((self.F, M[j])), 1: sum_of((self.s, up[j])), -1: sum_of((self.s, down[j]))} for j in range(3)]
        return momentum + gamma

    def times(self, a, b):
        """Laurent polynomials in zeta of series"""
        c = {}
        for (k, u), (m, v) in pairs(a.items(), b.items()):
            row = c.setdefault(k + m, [Function(P())] * (self.n + 1))
            for r in range(self.n + 1):
                row[r] = row[r] + total(u[j] * v[r - j] for j in range(r + 1))
        return {k: [self.reduced(x) for x in row] for k, row in c.items()}

    def sums(self, perturbation):
        """perturbation: pairs (exponents of the coordinates, coefficient).  Real and imaginary parts, k = 1, 2, ..."""
        rho = {(sigma, sign): self.residues(perturbation, self.coordinates(sigma, sign))
               for sigma, sign in pairs((1, -1), (1, -1))}
        for k, sigma in pairs(range(1, self.n + 1), (1, -1)):
            f = rho[sigma, 1].get(k, Function(P())) + rho[sigma, -1].get(k, Function(P())) * Function(self.Y**k)
            yield from (g.primitive() for g in (self.reduced(f).p.coefficients(self.imaginary) + [P(), P()])[:2])

    def residues(self, perturbation, x):
        """The coefficient of zeta^k/theta in the perturbation times exp(i k b theta)"""
        unit, known, found = self.alpha * self.beta * self.delta * 2, {}, {}

        def monomial(e):
            if e not in known:
                j = next((j for j in range(6) if e[j]), None)
                known[e] = {0: [Function(ONE)] + [Function(P())] * self.n} if j is None else \
                    self.times(x[j], monomial((*e[:j], e[j] - 1, *e[j + 1:])))
            return known[e]
        for e, c in perturbation:
            d = sum(e)
            for k, row in monomial(e).items():
                if k > 0 and d > 0:
                    exponential, step = Function(ONE), Function(self.i * self.b * k)
                    for j in range(d):                          # (i k b theta)^j/j!
                        part = exponential * row[d - 1 - j] * Function(c * unit**(self.n - d))
                        found[k] = self.reduced(found.get(k, Function(P())) + part)
                        exponential = exponential * step * Function(ONE, j + 1)
        return found


def euler_bracket(space):
    """{M_i, M_j} = -eps_ijk M_k, {M_i, G_j} = -eps_ijk G_k"""
    wanted = Family(SYMMETRIC_TOP).space.brackets
    return {pair: (f.p, f.n) for pair, f in space.brackets.items() if f} == {pair: (f.p, f.n) for pair, f in wanted.items()}


def degree_of(k, places):
    return sum(k >> x & MASK for x in places)


class Splitting:
    """The region of a step `splitting` of this family, checked"""

    def __init__(self, family, d):
        self.family, self.space = family, family.space
        names = d["moments"] + d["small"]
        right(len(d["moments"]) == len(d["small"]) == 3 and len(set(names)) == 6, "three moments and three parameters")
        right(all(x in family.names for x in names), "a parameter is expected")
        right(not set(NAMES + ["_i"]) & set(self.space.names), "a name is taken")
        self.moments, self.small = ([family.names[x] for x in d[key]] for key in ("moments", "small"))
        need(len(self.space.coordinates) == 6 and euler_bracket(self.space), "not the bracket of e(3)")
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
        at = [top + FIELD * j for j in range(7)]
        need(len(self.space.names) + 7 <= 64, "too many names")
        coordinates, terms = [FIELD * j for j in range(6)], {}
        for k, c in first.items():
            e = tuple(k >> x & MASK for x in coordinates)
            rest = k - sum(n << x for n, x in zip(e, coordinates))
            terms.setdefault(e, {})[rest] = c
        degree = max((sum(e) for e in terms), default=0)
        orbits = Orbits(at, moments, degree)
        names = self.family.names | dict(zip(NAMES, at))
        x = dict(zip(NAMES, (variable(k) for k in at)))
        given = self.family.assumptions + self.region + [(x[name], "positive") for name in NAMES]
        given.append((ONE - x["_Y"], "positive"))
        given += [(orbits.square[k] - variable(k)**2, "zero") for k in at[:3]]
        given.append((ONE - x["_F"]**2 - x["_s"]**2, "zero"))
        given += [(f, "zero") for f in orbits.sums([(e, P(rest)) for e, rest in terms.items()])]
        ConditionSet(names).also(*given).absent(proof)


def said(theorem, d):
    y = theorem.plain_family(d)
    return Said("N", y, [Splitting(y, d).region], [REAL], (), ["Ziglin 1980"])
