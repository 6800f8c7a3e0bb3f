"""An adversary of the checkers: false steps about equations whose group is known, as good as they can be made.

A false step is put into a genuine certificate of the same equation as one more premise of its conclusion, where nothing
else depends on it: whoever accepts the certificate has accepted the step.  What is false is read off from the group:
a reducible one has an exponential solution, D_n an invariant of degree 4, a finite one p-curvatures 0, and so on."""
import copy
import json

import traps
from certificate_format import Rejected, load
from exact import K
from group_rules import Checker
from modular import is_prime, madd, meval

REDUCIBLE, UNIPOTENT = {"Borel", "T", "Gm", "cyclic"}, {"SL2", "Borel", "T"}
ORDER = {"A4": 24, "S4": 48, "A5": 120}
PRIMES = [p for p in range(3, 50) if is_prime(p)]


def degrees(group, n):
    """Some m for which Sym^m has an invariant"""
    if group in ("Gm", "cyclic"):
        return {2, 4, 6, 8, 12}
    if group == "T":
        return {m for m in (2, 4, 6, 8, 12) if m % n == 0}
    return {"Dinf": {4, 8, 12}, "D": {4, 8, 12}, "A4": {6, 8, 12}, "S4": {8, 12}, "A5": {12}}.get(group, set())


def order(group, n):
    """Of a finite group, else 0"""
    return {"cyclic": n, "D": 4 * (n or 0)}.get(group, ORDER.get(group, 0))


def approximants(S, p):
    """All (length, connection polynomial, place of its first discrepancy) of Berlekamp and Massey."""
    C, B, l, m, b = [1], [1], 0, 1, 1
    for k in range(len(S)):
        d = sum(c * S[k - i] for i, c in enumerate(C) if i <= k) % p
        if not d:
            m += 1
            continue
        yield l, C, k
        new = madd(C, [0] * m + B, p, -d * pow(b, -1, p))
        B, b, l, m = (C, d, k + 1 - l, 1) if 2 * l <= k else (B, b, l, m + 1)
        C = new


class Adversary:
    """Of one genuine certificate"""

    def __init__(self, top):
        self.top, claim = top, top["claim"]
        self.group, self.n = claim["group"], claim["n"] and int(claim["n"])
        num, den, _, self.steps = load(copy.deepcopy(top))
        self.equation = Checker(num, den)
        self.given = next((s for s in top["steps"] if s["rule"] == "local"), None)
        self.local = self.given and self.equation.local(next(s for s in self.steps if s["rule"] == "local")["data"])

    def primes(self):
        """Small primes with an image of the generator"""
        for p in PRIMES:
            for a in range(p if K.d > 1 else 1):
                if not meval(K.m, a, p):
                    yield p, {"p": str(p), "a": str(a)}

    def false_steps(self):
        """(rule, premises, data, why it is false)"""
        local = [self.given["id"]] if self.given else []
        if local and self.group in REDUCIBLE:
            for data in [{"by": "parity"}, {"by": "degree"}, *self.series()]:
                yield "no-exponential", local, data, "there is an exponential solution"
        for m in sorted(degrees(self.group, self.n)) if local else []:
            for data in [{"by": "degree"}, *self.ranks(m)]:
                yield "no-invariant", local, {"m": str(m)} | data, f"there is an invariant of degree {m}"
        for p, prime in self.primes():
            shown = ["sl2"] if self.group != "SL2" else []
            shown += ["irreducible"] if self.group in REDUCIBLE else []
            shown += ["nonzero"] if order(self.group, self.n) % p else []
            for shows in shown:
                yield "p-curvature", local, prime | {"shows": shows}, f"p = {p} does not show {shows}"
        if self.local:
            yield from (("local", [], data, why) for data, why in self.places())

    def close_steps(self):
        """(rule, premises, data, why): steps with as few terms as possible and one less, true or false"""
        local = [self.given["id"]] if self.given else []
        for _, prime in list(self.primes())[:4]:
            yield from (("p-curvature", local, prime | {"shows": x}, f"{x} or not") for x in ("nonzero", "irreducible", "sl2"))
        for m in (0, 2, 3, 4, 6, 200, 202) if local else []:
            ranks = [*self.ranks(m, (53, 211))] if 0 < m < 7 else []
            ranks += [x | {"terms": str(n)} for x in ranks[:1] for n in (52, 53, 54)]
            ranks += [x | {"x0": str(n)} for x in ranks[1:2] for n in (0, 1, 52, 53)]
            yield from (("no-invariant", local, {"m": str(m)} | x, f"an invariant of degree {m} or none")
                        for x in [{"by": "degree"}, *ranks])
        yield from (("no-exponential", local, x, "a line or none") for x in (self.series(True) if local else []))

    # ---- no exponential solution

    def series(self, close=False):
        """At each place and for each square root the lines with the longest approximants there are."""
        for index, x in [*enumerate(self.local.finite), ("infinity", self.local.infinity)]:
            for p, prime in list(self.primes())[2::4]:
                for root in range(p) if x.q else [0]:
                    for delta in range((p + 1) // 2):
                        try:
                            yield from self.lines(index, x, p, prime, root, delta, close)
                        except (Rejected, ArithmeticError, ValueError, LookupError):
                            pass

    def lines(self, index, x, p, prime, root, delta, close, terms=40):
        _, _, num, den = self.equation.good({k: int(v) for k, v in prime.items()})
        n, e = self.equation.expansion(p, num, den, root if x.q else None, x.order)
        starts = dict.fromkeys((1 + s) * (p + 1) // 2 % p if x.order <= 2 else s % p for s in (delta, -delta))
        found = [self.equation.riccati(n, e, x.order, s, terms, p) for s in starts]
        known = [sorted(approximants(S, p), key=lambda a: a[2] + 1 - a[0]) for S in found if S]
        if not all(known):
            return
        for i in range(max(map(len, known), default=0)) if close else [-1]:
            chosen = [row[min(i, len(row) - 1)] for row in known]
            last = 1 + max((k for _, _, k in chosen), default=terms - 1) if close else terms
            yield {"by": "series", "place": str(index), **prime, "root": str(root), "delta": str(delta), "terms": str(last),
                   "lines": [{"length": str(l), "approximant": list(map(str, C))} for l, C, _ in chosen]}

    # ---- no invariant

    def ranks(self, m, primes=(1009, 10007)):
        try:
            D = max(-1, self.local.degree_bound(m))
        except Rejected:
            return
        for p in primes:
            for a in range(p if K.d > 1 else 1):
                if not meval(K.m, a, p):
                    for more in (-1, 0, 1, 5):
                        yield {"by": "series", "p": str(p), "a": str(a), "x0": str(3 + more), "terms": str(D + m + 2 + more)}
                    break

    # ---- the places

    def places(self):
        data = self.given["data"]
        if self.group not in UNIPOTENT:
            yield from self.logarithms(data)
        for i, (x, given) in enumerate(zip(self.local.finite, data["places"])):
            if x.order == 2 and x.delta is not None:
                for p, prime in self.primes():
                    other = {k: v for k, v in given.items() if k in ("q", "order")} | {"irrational": prime}
                    yield traps.changed(data, ["places", i], other), f"Delta = {x.delta} is rational (place {i}, p = {p})"

    def logarithms(self, data):
        for p, prime in self.primes():
            for i, x in enumerate(self.local.finite):
                for c in range(p) if x.order == 2 else []:
                    yield (traps.changed(data, ["places", i, "log"], prime | {"roots": [str(c)]}),
                           f"no logarithm at place {i} (p = {p}, root {c})")
            if self.local.infinity.order == 2:
                yield traps.changed(data, ["infinity", "log"], prime), f"no logarithm at infinity (p = {p})"


def steps(names, close=False):
    """(name, rule, premises, data, why) for the certificates of data that are named: false ones, or close ones"""
    for name in names:
        adversary = Adversary(json.loads(traps.read("data", name + ".json")))
        yield from ((name, *step) for step in (adversary.close_steps() if close else adversary.false_steps()))
