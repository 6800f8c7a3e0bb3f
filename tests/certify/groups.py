"""Properties of the table of conclusions and of the degree bounds of the Python checker (conclusions.py, places.py).

World: a group with facts that are true together of some equation.  Whatever a theorem concludes from some of the facts
has to be true, and the theorems that are named must conclude something from all of them."""
from fractions import Fraction
from itertools import combinations
from math import floor, lcm

THEOREMS = ["sl2-p-curvature", "sl2-irreducible-log", "sl2-irreducible-infinite", "sl2-irreducible-12", "borel", "additive",
            "diagonal", "dihedral-genus-0", "dihedral-infinite", "dihedral-holomorphic", "dihedral-finite",
            "dihedral-torsion", "quaternion", "tetrahedral", "octahedral", "icosahedral", "invariant-abelian",
            "torus-nonabelian", "no-theorem"]
ABELIAN = {"SL2": False, "Borel": False}


class Facts:
    """Makes the facts out of the modules of the checker"""

    def __init__(self, modules):
        self.m = modules
        exact = modules["exact"]
        exact.K.m, exact.K.d, exact.K.s = [0, 1], 1, 1
        self.irreducible, self.exponential = self.fact("irreducible"), self.fact("exponential")

    def fact(self, kind, **data):
        return self.m["equation"].Fact(kind, **data)

    def poly(self, *roots):
        exact = self.m["exact"]
        return exact.product(exact.Poly([-c, 1]) for c in roots)

    def place(self, root, order, delta=None, log=False, irrational=False):
        """root None: infinity"""
        x = self.m["places"].Place(None if root is None else self.poly(root), 1, order)
        x.delta = Fraction(1) if order <= 1 else None if delta is None else Fraction(delta)
        x.irrational, x.logs = irrational, int(log or order == 1 or delta == 0)
        return x

    def local(self, *finite, infinity=None):
        return self.m["places"].Local([self.place(i, *x[:1], **x[1]) for i, x in enumerate(finite)],
                                      infinity or self.place(None, 0))

    def invariant(self, m, p=(), factors=(), w=1):
        """v = prod (z - p) prod (z - c)^e over factors (c, e)"""
        exact, fs = self.m["exact"], [(self.poly(c), Fraction(e)) for c, e in factors]
        branch = exact.product(q for q, e in fs if e.denominator == 2)
        return self.m["equation"].Invariant("invariant", m=m, p=self.poly(*p), factors=fs, branch=branch,
                                            w_squared=exact.Poly([w] if m == 2 and w else []))

    def absent(self, *degrees):
        return [self.fact("no-invariant", m=m) for m in degrees]

    def curvature(self, p, shows="nonzero"):
        return self.fact("p-curvature", p=p, shows=shows)


def regular(delta, **more):
    return 2, {"delta": delta} | more


def worlds(modules):
    """(name, group, n, facts, theorems that conclude from all of the facts)"""
    f = Facts(modules)
    every = f.absent(2, 4, 6, 8, 12)
    odd, even, unknown = (3, {}), (4, {}), (2, {})
    half, irrational = regular("1/2"), (2, {"irrational": True})
    yield "SL2", None, [f.local(odd), f.irreducible, f.curvature(7, "sl2"), f.curvature(5, "irreducible"), *every], \
        {"sl2-p-curvature", "sl2-irreducible-infinite", "sl2-irreducible-12", "torus-nonabelian"}
    yield "SL2", None, [f.local(regular(3, log=True)), f.irreducible, *every], \
        {"sl2-irreducible-log", "sl2-irreducible-infinite", "sl2-irreducible-12"}
    for deltas in (("1/4", "2/5"), ("1/6",), ("1/7",)):
        yield "SL2", None, [f.local(*map(regular, deltas)), f.irreducible, *f.absent(2, 4, 12)], \
            {"sl2-irreducible-infinite", "sl2-irreducible-12"}
    yield "SL2", None, [f.local(regular("1/4"), regular("2/5"), infinity=f.place(None, 2, "3/4")), f.irreducible, *f.absent(2, 4)], \
        {"sl2-irreducible-infinite"}
    for deltas in (("1/4", "1/3"), ("2/5", "1/3"), ("1/2",)):
        yield "SL2", None, [f.local(*map(regular, deltas)), f.curvature(5, "irreducible"), *f.absent(2, 4)], set()
    for place in (odd, even, irrational):
        yield "Borel", None, [f.local(place), f.exponential, f.curvature(7), *every], {"borel", "torus-nonabelian"}
    yield "Borel", None, [f.local(irrational, regular(2, log=True)), f.exponential, f.absent(8)[0]], {"borel"}
    yield "Borel", None, [f.local(irrational, unknown), f.exponential, f.curvature(5), f.absent(4)[0]], {"borel", "torus-nonabelian"}
    yield "T", 1, [f.local(regular(1, log=True)), f.exponential, f.curvature(5), f.invariant(1), f.invariant(4)], \
        {"additive", "invariant-abelian"}
    yield "T", 3, [f.local(regular("1/3"), regular(1), infinity=f.place(None, 2, "4/3")), f.exponential, *f.absent(2, 4, 8)], {"additive"}
    yield "T", 4, [f.local(regular("1/2", log=False), (1, {})), f.exponential, f.invariant(4), f.invariant(8), *f.absent(2, 6)], \
        {"additive", "invariant-abelian"}
    yield "Gm", None, [f.local(even), f.exponential, f.invariant(2), f.invariant(4), f.curvature(5)], {"diagonal", "invariant-abelian"}
    yield "Gm", None, [f.local(irrational, unknown), f.exponential, f.invariant(2)], {"diagonal", "invariant-abelian"}
    yield "cyclic", 12, [f.local(regular("2/3"), regular("1/2"), regular(1), infinity=f.place(None, 2, "1/7")), f.exponential,
                         f.invariant(2), f.invariant(4)], {"diagonal", "invariant-abelian"}
    yield "cyclic", 4, [f.local(half, half), v := f.invariant(2, factors=((0, "1/2"), (1, "1/2"))),
                        f.fact("torsion-function", n=1, of=v)], {"dihedral-genus-0", "dihedral-finite", "invariant-abelian"}
    yield "Dinf", None, [f.local(half, half, odd), f.invariant(2, factors=((0, "1/2"), (1, "1/2"))),
                         f.fact("torsion-function", n=3, of=f.invariant(2))], {"dihedral-infinite", "invariant-abelian"}
    yield "cyclic", 4, [f.local(half, half), f.exponential, f.invariant(4, p=(1,)), f.invariant(4, p=(2,))], {"invariant-abelian"}
    yield "D", 3, [f.irreducible, f.invariant(2, factors=[(0, "3/2"), (1, "1/2")])], {"invariant-abelian"}
    yield from imprimitive(f, every, half, irrational, odd)
    for group, known, none, theorem in (("A4", (6, 8, 12), (2, 4), "tetrahedral"), ("S4", (8, 12), (2, 4, 6), "octahedral"),
                                        ("A5", (12,), (2, 4, 6, 8), "icosahedral")):
        local = f.local(regular("1/2"), regular("1/3"), regular({"A4": "2/3", "S4": "1/4", "A5": "2/5"}[group]))
        yield group, None, [local, f.irreducible, *(f.invariant(m, p=(m,)) for m in known), *f.absent(*none), f.curvature(3), f.curvature(5)], \
            {theorem, "invariant-abelian"}


def imprimitive(f, every, half, irrational, odd):
    """D_n and D_inf: v = sqrt((z - 0) ... ) of degree 2, its square of degree 4"""
    def v_and(count):
        return [f.invariant(2, factors=[(i, "1/2") for i in range(count)]), f.invariant(4), f.irreducible, *f.absent(2)]
    four, poles = [half] * 4, [regular("1/3")]
    for place in (irrational, odd):
        yield "Dinf", None, [f.local(half, half, place), *v_and(2), f.curvature(7)], {"dihedral-infinite", "invariant-abelian"}
    yield "Dinf", None, [f.local(half, half, half), *v_and(3)], {"dihedral-holomorphic", "invariant-abelian"}

    sphere = [f.local(half, half, regular("1/3"), infinity=f.place(None, 2, "3/5")), *v_and(2)]
    yield "D", 15, sphere, {"dihedral-genus-0", "invariant-abelian"}
    yield "D", 3, [f.local(half, regular("1/3"), infinity=f.place(None, 2, "3/2")), *v_and(1)], {"dihedral-genus-0", "invariant-abelian"}
    yield "D", 5, [f.local(*four), w := f.invariant(2, p=(7,), factors=[(i, "1/2") for i in range(4)]),
                   f.fact("torsion-function", n=5, of=w)], {"dihedral-finite", "invariant-abelian"}
    # n = L N', |G| = 4 n: p-curvatures are 0 unless p divides 4 n; N' prime to q is at most the bound
    long = f.invariant(2, p=(7,), factors=[(i, "1/2") for i in range(4)])
    yield "D", 45, [f.local(*four, *poles), long, f.irreducible, f.fact("good-reduction", p=11, bound=15, of=long), f.curvature(3),
                    f.curvature(5)], {"invariant-abelian"}
    yield "D", 15, [f.local(*four), long, f.irreducible, f.fact("good-reduction", p=11, bound=15, of=long), f.curvature(3),
                    f.curvature(5)], {"invariant-abelian"}
    yield "D", 35, [f.local(*four), long, f.irreducible, f.fact("good-reduction", p=7, bound=6, of=long), f.curvature(5),
                    f.curvature(7)], {"invariant-abelian"}
    yield "D", 3, [f.local(*four, *poles), long, f.irreducible, f.fact("good-reduction", p=7, bound=2, of=long), f.curvature(3)], \
        {"invariant-abelian"}
    yield "Dinf", None, [f.local(*four, *poles), long, f.irreducible, f.fact("good-reduction", p=11, bound=34, of=long),
                         f.curvature(5), f.curvature(7), f.curvature(5)], {"dihedral-torsion", "invariant-abelian"}
    yield "D", 7, [f.local(*four), long, f.irreducible, f.fact("good-reduction", p=11, bound=6, of=f.invariant(2)), f.curvature(7)], \
        {"invariant-abelian"}
    yield "D", 2, [f.irreducible, *f.absent(2, 6), f.invariant(4, p=(1,)), f.invariant(4, p=(2,))], {"quaternion", "invariant-abelian"}
    yield "D", 7, [f.irreducible, *f.absent(2, 6), f.invariant(4, p=(1,), factors=((0, 1), (2, -1))),
                   f.invariant(4, p=(1,), factors=((0, 1), (2, -1)))], {"invariant-abelian"}
    yield "Dinf", None, [f.irreducible, f.invariant(2, w=0, factors=[(0, "1/2")]), f.invariant(4), f.local(half, irrational)], \
        {"invariant-abelian"}


def some(facts):
    """At most three, or all but at most one"""
    for k in (0, 1, 2, 3, len(facts) - 1, len(facts)):
        yield from combinations(facts, min(k, len(facts)))


def conclusions(modules):
    conclude, F = modules["conclusions"].conclude, modules["certificate_format"]
    for group, n, facts, theorems in worlds(modules):
        for given in some(facts):
            for theorem in THEOREMS:
                try:
                    said = conclude(theorem, list(given))
                except F.Rejected:
                    if theorem in theorems and len(given) == len(facts):
                        return False
                    continue
                if theorem == "no-theorem" or said[2] is not ABELIAN.get(group, True) or said[0] is not None and said[:2] != (group, n):
                    return False
    return True


# ---- places.py

def exponents(modules):
    """The table of local_exponents.md 2.1 and 3, from its proof"""
    f = Facts(modules)
    for m in range(2, 26, 2):
        for a in range(0, 14):
            for b in range(1, 14):
                delta = Fraction(a, b)
                least = min(Fraction(m, 2) - i * delta for i in range(m // 2 + 1) if (i * delta).denominator == 1)
                x = f.place(0, 2, delta, log=not a)
                if x.lowest(m) != (Fraction(m, 2) if not a else least):
                    return False
                if b == 1 and f.place(0, 2, delta, log=True).lowest(m) != m * (1 + delta) / 2:
                    return False
        if f.place(0, 2, irrational=True).lowest(m) != m // 2 or f.place(0, 1).lowest(m) != m or f.place(None, -3).lowest(m) != 0:
            return False
        if any(f.place(0, k).lowest(m) != (None if m * k % 4 else m * k // 4) for k in range(3, 9)):
            return False
    return True


def bounds(modules):
    """D_m, D_1 and the orders of the characters"""
    f, F = Facts(modules), modules["certificate_format"]

    def place(root, order, n, **data):
        x = f.place(root, order)
        x.__dict__.update(data, n=n)
        return x
    Local = modules["places"].Local
    two = place(0, 2, 2, delta=Fraction(1, 3), real=Fraction(1, 3))
    log = place(1, 2, 3, delta=Fraction(4), real=Fraction(4), logs=3)
    part = place(1, 2, 3, delta=Fraction(4), real=Fraction(4), logs=2)
    four = place(2, 4, 1, real=Fraction(5, 2))
    simple, far = place(3, 1, 2, logs=2), place(None, 6, 1, real=Fraction(1))
    for finite, infinity in (([two], f.place(None, 0)), ([two, log, simple], far), ([part, four], place(None, 2, 1, delta=Fraction(3), real=Fraction(3))),
                             ([simple], f.place(None, 1)), ([], far)):
        local = Local(finite, infinity)
        alpha = {two: Fraction(1, 3), log: Fraction(5, 2), part: Fraction(-3, 2), four: Fraction(-1, 4), simple: 1, far: 1}
        at_infinity = alpha.get(infinity, Fraction(-1) if infinity.order == 2 else infinity.order)
        least = {two: 1, log: 10, part: -6, four: 4, simple: 4, far: 6}
        if local.degree_bound_1() != floor(1 - at_infinity - sum(x.n * alpha[x] for x in finite)):
            return False
        low = least.get(infinity, -4 if infinity.order == 2 else 4 * infinity.order)
        if local.degree_bound(4) != 4 - low - sum(x.n * (least[x] if x is not two else 2) for x in finite):
            return False
        deltas = [x.delta for x in finite]
        rational = None not in deltas and all(x.order <= 2 for x in local.all)
        try:
            order = local.character_order()
        except F.Rejected:
            order = None
        if order != (lcm(*(((1 + d) / 2).denominator for d in deltas)) if rational else None):
            return False
    return local.degree_bound(2) == 2 - 3 and Local([four, f.place(0, 5)], far).degree_bound(2) == -1


def properties():
    """(name, function, True)"""
    return [(f"groups.{f.__name__}", f, True) for f in (conclusions, exponents, bounds)]
