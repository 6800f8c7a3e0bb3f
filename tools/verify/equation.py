"""What the rules of kovacic-certificate/1 work with (docs/theory/certificates.md 1, 2): an equation y'' = r y, its
reductions modulo primes and its expansions at a point; and what checked steps establish."""
from math import floor
from operator import mul

from certificate_format import LENGTH, need
from exact import K, ZERO, product
from modular import is_prime, mdiff, meval, mgcd, minverse, mmul, mshift

WORK, TOTAL = 4 * 10**9, 2 * 10**10         # elementary operations of one step, of all steps


class Fact:
    def __init__(self, kind, **data):
        self.kind = kind
        self.__dict__.update(data)


class Invariant(Fact):
    """v = p prod q^e solves Sym^m.  branch = F0, the product of the q with half-integer e.  m = 2: w_squared is the
    constant v'^2 - 2 v v'' + 4 r v^2."""

    def fraction(self):
        """v/sqrt(F0) = A/B"""
        powers = [(q, floor(e)) for q, e in self.factors]
        size = sum(abs(e) * q.bits() for q, e in powers)
        need(all(abs(e) * q.degree() * max(1, size / LENGTH) <= LENGTH for q, e in powers), "an exponent is too large")
        return product([self.p] + [q**e for q, e in powers if e > 0]), product(q**-e for q, e in powers if e < 0)

    @property
    def holomorphic_quotient(self):
        """Is w dz/v holomorphic?  (dihedral_torsion.md 8)"""
        growth = sum(e * q.degree() for q, e in self.factors)
        return self.p.degree() <= 0 and all(2 * e <= 1 for _, e in self.factors) and 2 * growth >= 3


class Equation:
    """y'' = (num/den) y over K"""
    spent = 0                               # of TOTAL, by all certificates of a file

    def __init__(self, num, den):
        self.num, self.den, self.dn, self.dd = num, den, num.degree(), den.degree()
        self.length = self.dn + self.dd + 2

    def spend(self, work):
        Equation.spent += work
        need(Equation.spent <= TOTAL, "the certificate is too much work")

    def good(self, d):
        """A prime p where r is integral, and the image a of the generator: p, reduction K[z] -> F_p[z], num, den."""
        p, a = d["p"], d["a"]
        self.spend(20 * self.length)
        need(2 < p < 2**62 and is_prime(p), "p is not an odd prime below 2^62")
        need(a < p and meval(K.m, a, p) == 0, "a is not a root of the minimal polynomial modulo p")

        def reduce(f):
            need(f.q % p, "p divides a denominator")
            return f.image(a, p)
        return p, reduce, reduce(self.num), reduce(self.den)

    def reduced_curve(self, d, v):
        """The curve S^2 = w^2 F0 modulo a good prime that does not ramify, w^2 a unit there (dihedral_torsion.md 6): p,
        reduction, F0, w^2."""
        p, reduce = self.good(d)[:2]
        square = sum(reduce(v.w_squared))
        need(meval(mdiff(K.m, p), d["a"], p), "the prime ramifies")
        need(square, "w^2 is not a unit modulo p")
        return p, reduce, reduce(v.branch), square

    def need_squarefree(self, f, d, other=ZERO):
        p, reduce = self.good(d)[:2]
        g = reduce(f)
        need(len(mgcd(g, mdiff(g, p), p)) == 1, "not squarefree modulo p")
        need(not other.c or len(mgcd(g, reduce(other), p)) == 1, "a common factor modulo p")

    @staticmethod
    def expansion(p, num, den, root, order):
        """Numerator and denominator of t^order r, as polynomials in t = z - root; root = None: of r(1/t)/t^4."""
        if root is None:
            need(len(den) - len(num) == 4 - order, "the order at infinity changes modulo p")
            return num[::-1], den[::-1]
        need(root < p and meval(den, root, p) == 0, "not a root of the place modulo p")
        n, d = mshift(num, root, p), mshift(den, root, p)
        need(n and n[0] and len(d) > order and not any(d[:order]) and d[order], "the order changes modulo p")
        return n, d[order:]

    def riccati(self, n, d, order, s0, terms, p):
        """S = t^nu omega with S_0 = s0, modulo t^terms; None when a logarithm forbids it (riccati_one_place.md 2)."""
        nu, S = max(1, order // 2), [s0]
        need(terms * (terms + self.length) <= WORK, "too many terms")
        self.spend(terms * (terms + self.length))
        r = [0] * (2 * nu - order) + mmul(n, minverse(d, p, terms), p, terms)
        r = (r + [0] * terms)[:terms]
        need((s0 * s0 - (s0 if nu == 1 else 0) - r[0]) % p == 0, "delta is not the square root that it should be")
        for i in range(1, terms):
            rhs = r[i] - sum(map(mul, S[1:], S[:0:-1]))
            lead = (2 * s0 + (i - 1 if nu == 1 else 0)) % p
            if nu > 1 and i >= nu - 1:
                rhs -= (i - 2 * nu + 1) * S[i - nu + 1]
            if not lead:
                need(rhs % p and nu == 1, "the expansion is not unique")
                return None
            S.append(rhs * pow(lead, -1, p) % p)
        return S
