"""Checks certificates of a theorem, kovacic-theorem/1 (docs/theory/theorem_certificates.md; numbers are its sections).

Each step becomes a fact by its rule (facts.py); a step names earlier ones only.  condition.py has the signs (2), tower.py and
place.py the changes of variables (3, 4), splitting.py (6) and lowest_order.py (7) their steps."""
from functools import partial

import checked
import jets
import strata
import system
from certificate_format import Malformed, Rejected, need, read
from condition import ConditionSet
from darboux import Darboux
from facts import Facts, Said
from first_integrals import IntegralClass, casimirs, integrals, least
from lowest_order import lowest_order, parse_again
from multivariate import FIELD, P, parse
from phase_space import Function, PhaseSpace, total
from place import Family, Map, Target, equations
from splitting import Splitting
from statement import quoted
from stratum_of_family import Restriction, Stratum, integrability, read_class
from system_format import read_system, right
from system_statement import Shown, function
from theorem_format import FORMAT, NODES, read_theorem
from theorem_statement import LEAVES, LITERATURE, ORIGIN, REAL, RIGID, SYMMETRIC_TOP, first_integrals, shown, statement


def carried(c, map):
    """The class, of the system in other coordinates, as it is named there; what is not known of it is refused (4)."""
    need(not (c.functions or c.through or c.frame), "a class that speaks of functions, or of coordinates of a frame")
    need(not c.without or map.keeps_others(c.without), "a class without coordinates that the map mixes with others")
    need(c.kind != "real-analytic" or not map.tower.roots, "a real system, and a root")
    need(c.place != "origin" or not map.affine, "the origin moves")
    if c.place == "level":
        map.need_level(RIGID)
    return c


class Theorem:
    def __init__(self, top, prove):
        self.prove, self.facts, self.led = prove, Facts(), set()
        self.families = {d["name"]: Family(d) for d in top["systems"]}
        for i, d in enumerate(top["steps"]):
            try:
                need(d["id"] not in self.facts, "the id occurs twice")
                need((d["rule"] == "cover") == (i == len(top["steps"]) - 1), "the last step is a cover, and no other")
                said = getattr(self, d["rule"].replace("-", "_"))(d)
                of = self.facts.premises()
                self.last = self.facts.derive(d["id"], said)
                if checked.wanted:
                    checked.add(FORMAT, "rule", d["rule"], d["id"], of, shown(self.last))
            except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as why:
                raise Rejected(f"step {d['id'][:60]!r}: {type(why).__name__}: {why}") from None
            except Rejected as why:
                raise Rejected(f"step {d['id'][:60]!r} ({d['rule']}): {why}") from None
        need(self.facts.named >= {d["id"] for d in top["steps"][:-1]}, "a step is not used")

    def family(self, d):
        need(d["system"] in self.families, "there is no such system")
        return self.families[d["system"]]

    def plain_family(self, d):
        need(self.family(d).is_plain(), "a Hamiltonian system with real parameters is expected")
        return self.families[d["system"]]

    def fact(self, name, *kinds):
        f = self.facts.premise(name)
        need(f.kind in kinds, "the step says something else")
        return f

    def proved(self, name, *kinds):
        """A fact from which a rule makes another one: of one region, and not on trust"""
        f = self.fact(name, *kinds)
        need(not f.trusts and not f.several, "what is on trust is named by the cover only")
        return f

    # -- single systems (5)

    def certificate(self, d):
        if isinstance(d["certificate"], dict) and d["certificate"].get("format") == jets.FORMAT:
            return self.jets(d["certificate"])
        right(isinstance(d["certificate"], dict) and d["certificate"].get("format") == system.FORMAT, "another format")
        top = read_system(d["certificate"])
        curve, claims, inner = system.accept(top, self.prove)
        everywhere = not inner.trust and top["claim"]["not_integrable"]
        need(everywhere or inner.denials, "no leaf says \"not abelian\"")
        excluded = integrals(curve, inner.denials, casimirs(claims))
        only = curve.space.brackets is None or bool(excluded.functions or excluded.without)
        target = Target(curve.space, top["parameters"], list(self.asked(top, curve)), curve)
        shown = Shown(curve)
        way, (there, names) = [f"{shown.phase_curve(top)} of {quoted(top['title'])}"], shown.functions_explained()
        used = "Ayoul-Zung" if curve.space.brackets is None or inner.denials[0].whole else "Morales-Ramis"
        at = {x: curve.space.at[x] for x in top["parameters"]}
        leaves = [([(Function(parse(text, at)), says) for text, says in x.path], x.trust,
                   partial(integrals, curve, [x], casimirs(claims))) for x in inner.denials]
        return Said("N" if everywhere else "L", None, [()], [excluded], (), [used], (), way, target=target, only_stratum=only,
                    there=there, names=names, leaves=leaves)

    def leaf(self, d):
        """One leaf of a certificate that says "not abelian", where it says so"""
        of = self.fact(d["of"], "N", "L")
        need(0 <= d["leaf"] < len(of.leaves), "no such leaf")
        asked, trust, excluded = of.leaves[d["leaf"]]
        need(not trust, "a leaf on trust")
        target = Target(of.target.space, of.target.parameters, of.target.conditions + asked, of.target.curve)
        return Said("N", None, [()], [excluded()], (), (), (), of.way, target=target, there=of.there, names=of.names)

    def jets(self, certificate):
        """Of higher variational equations: canonical coordinates"""
        d, orders, group = jets.accept(certificate, self.prove)
        need(not group.trust, "not without trust")
        need(not d["constants"], "an algebraic constant among the parameters")
        q, p = d["system"]["coordinates"], d["system"]["momenta"]
        phase = {"coordinates": [*q, *p], "functions": [], "inverses": [], "relations": [], "field": None,
                 "hamiltonian": d["system"]["hamiltonian"], "brackets": [[x, y, "1"] for x, y in zip(q, p)]}
        space, e = PhaseSpace(phase, d["parameters"]), d["variables"][0]
        names = {x: space.at[x] for x in d["parameters"]}
        value = d["obstruction"]["value"]
        groups = [(Function(parse(text, names)), "nonzero") for text in d["denominators"]]
        rows = parse(value if isinstance(value, str) else value[0], names | {e: FIELD * 100}).coefficients(FIELD * 100)
        groups.append(([Function(f) for f in rows or [P()]], "some"))
        way = [f"VE_{orders.order} along a line of {quoted(d['title'])}"]
        return Said("N", None, [()], [IntegralClass()], (), ["Morales-Ramis-Simo"], (), way,
                    target=Target(space, d["parameters"], groups), only_stratum=True)

    @staticmethod
    def asked(top, curve):
        """What the certificate asks of a point"""
        names = {x: curve.space.at[x] for x in top["parameters"]}
        inner = top["equation"]["certificate"]

        def coefficients(text, z):
            rows = parse(text, names | {z: FIELD * 100}).coefficients(FIELD * 100)
            return [Function(f) for f in rows or [P()]], "some"
        if inner["format"] == strata.FORMAT:
            need(not inner.get("memberships") and not inner.get("rational"), "memberships are not looked at here")
            need(set(inner["parameters"]) <= set(names), "an algebraic constant among the parameters")
            for x in inner["real"]:
                yield Function(parse(x, names)), "real"
            for c in inner["assumptions"]:
                yield Function(parse(c["p"], names)), c["sign"]
            for group in inner["generic"]:
                yield [Function(parse(text, names)) for text in group], "some"
            yield coefficients(inner["r"]["den"], inner["variable"])
        for text in top["curve"]["denominators"]:
            yield coefficients(text, curve.variable)

    def literature(self, d):
        need(d["theorem"] == "Ziglin 1983", "an unknown theorem")
        y, known = self.plain_family(d), Family(SYMMETRIC_TOP)
        same = y.data["coordinates"] == known.data["coordinates"] and y.parameters == known.parameters and \
            y.space.at == known.space.at and y.space.hamiltonian.p == known.space.hamiltonian.p and \
            y.space.hamiltonian.n == known.space.hamiltonian.n and y.assumptions == known.assumptions and \
            {u: h.p for u, h in y.space.denominators.items()} == {u: h.p for u, h in known.space.denominators.items()} and \
            {k: f.p for k, f in y.space.brackets.items()} == {k: f.p for k, f in known.space.brackets.items()} and \
            all(f.n == 1 for f in y.space.brackets.values())
        need(same, "not the system of the theorem")
        return Said("N", y, [()], [LEAVES], (), ["Ziglin 1983"])

    def integrals(self, d):
        y = self.family(d)
        space = y.space
        right(d["claims"], "nothing is claimed")
        level = [space.read(v) for v in d["level"]]
        for g in level:
            space.need_zero(self.along(space, g), "the level is not invariant")
        lines = []
        for claim in d["claims"]:
            f, cofactors = space.read(claim["value"]), [space.read(v) for v in claim["cofactors"]]
            right(len(cofactors) == len(level), "a cofactor for each function of the level is expected")
            rest = self.along(space, f) - total(c * g for c, g in zip(cofactors, level))
            space.need_zero(rest, "not a first integral")
            lines.append((claim["name"], f))
        return Said("I", y, [()], (), [(y, lines, level)])

    @staticmethod
    def along(space, f):
        return total(x * space.d(f, j) for j, x in enumerate(space.field))

    def splitting(self, d):
        y = self.plain_family(d)
        return Said("N", y, [Splitting(y, d).region], [REAL], (), ["Ziglin 1980"])

    # -- changes of variables (4)

    def place(self, d):
        x, of = self.plain_family(d), self.proved(d["of"], "N", "I")
        need(not of.only_stratum and (of.family is None or of.family.is_plain()), "another class")
        at = self.read_at(x, d)
        region = x.region(d["region"])
        target = of.target or Target.of(of.family, of.regions[0], of.kind == "N")
        map = Map(x, at, region, target, d)
        return Said(of.kind, x, [equations(x, at) + region], [carried(c, map) for c in of.classes], of.integrals, (), (),
                    [*of.way, *of.there, *map.shown()], shows_way=of.shows_way)

    def read_at(self, x, d):
        rows = d["at"] or []
        right(all(len(v) == 2 and isinstance(v[0], str) and v[0] in x.names for v in rows), "a parameter is expected")
        at, free = {}, {name: v for name, v in x.names.items() if name not in {v[0] for v in rows}}
        for name, value in rows:
            need(name not in at, "a parameter is put twice")
            at[name] = self.function(value, free)
        return at

    @staticmethod
    def function(v, names):
        p, n = (v, "1") if isinstance(v, str) else v
        right(isinstance(p, str) and isinstance(n, str), "a polynomial over a number is expected")
        n = read("int", n, "a number")
        right(n >= 1, "a number is out of range")
        return Function(parse(p, names), n)

    def symmetry(self, d):
        x = self.plain_family(d)
        at, region = self.read_at(x, d), x.region(d["region"] or [])
        map = Map(x, at, region, Target.of(x, [], bool(d["adjoined"])), d)
        need(not map.affine, "the origin moves")
        need(all(map.values[v].n == 1 for v in x.names.values()), "a number below")
        return Said("S", x, [equations(x, at) + region], map=map)

    def lowest_order(self, d):
        x, of = self.plain_family(d), self.proved(d["of"], "N")
        need(of.family is not None and of.family.is_plain(), "the step is about a system of a certificate")
        kept = [c for c in of.classes if not c.has_rational()]
        need(set(kept) <= {REAL}, "a class that parts of lowest order need not have")
        lowest_order(x, of.family, d)
        region = [(parse_again(f, of.family, x), says) for f, says in of.regions[0]]
        return Said("N", x, [region], [*kept, ORIGIN], of.integrals, ["Ziglin 1982"])

    # -- strata of complex parameters, steps on trust (12 to 15)

    def stratum(self, d):
        x, of = self.family(d), self.proved(d["of"], "N")
        need(of.target is not None, "the step says something else")
        here = Stratum(x, self.read_at(x, d), x.region(d["region"]))
        values = self.read_levels(here, d["levels"] or [])
        Restriction(here, of.target, values).need_asked(d["shown"])
        at = [f"at {', '.join(f'{h} = {function(values[h], x.space.names)}' for h in sorted(values))}"] * bool(values)
        levels = [name for name in of.target.parameters if name in of.names and name not in x.space.at]
        there = [text + f", for some value of {', '.join(levels)}" * bool(levels) for text in of.there]
        return Said("N", x, [here.conditions()], of.classes, (), (), (), [*of.way, *at], shows_way=True, there=there)

    def read_levels(self, here, rows):
        """Functions of the parameters that are left"""
        right(all(len(v) == 2 and isinstance(v[0], str) for v in rows), "a level and its value are expected")
        need(len({v[0] for v in rows}) == len(rows), "a level is put twice")
        free = {name: v for name, v in here.family.names.items() if name not in here.values}
        return {name: self.function(value, free) for name, value in rows}

    def darboux(self, d):
        x = self.family(d)
        here = Stratum(x, self.read_at(x, d), x.region(d["region"]))
        classes, used, way = Darboux(here, d).fact()
        return Said("N", x, [here.conditions()], classes, (), used, (), way, shows_way=True)

    def integrable(self, d):
        x = self.family(d)
        here = Stratum(x, self.read_at(x, d), x.region(d["region"]))
        shown = integrability(here, d)
        return Said("J", x, [here.conditions()], (), [shown], (), [(d["id"], what) for what in shown[3]])

    def trusted(self, d):
        x = self.family(d)
        right(d["says"] in ("integrable", "not integrable") and d["regions"] and 0 < len(d["step"]) <= 4000, "a trusted step")
        no = d["says"] == "not integrable"
        right(no == (d["class"] is not None), "the class of first integrals")
        return Said("N" if no else "J", x, [x.region(rows) for rows in d["regions"]], [read_class(d["class"])] if no else (),
                    (), (), [(d["id"], d["step"])], several=True, trusted=d["step"])

    def open(self, d):
        x = self.family(d)
        right(d["regions"], "a region is expected")
        return Said("O", x, [x.region(rows) for rows in d["regions"]], several=True)

    # -- the cover (8)

    def cover(self, d):
        x = self.family(d)
        self.symmetries = [self.fact(name, "S") for name in d["symmetries"]]
        self.parts = [self.fact(name, "N", "I", "J", "O") for name in d["parts"]]
        need(all(f.family is x for f in self.symmetries + self.parts), "a step is about another system")
        need(any(f.kind in ("N", "J") for f in self.parts), "nothing says that it is not integrable")
        x.where(x.assumptions).absent(d["tree"], self.part)
        return Said("N", x, [()], least(c for f in self.parts for c in f.classes))

    def part(self, v, given):
        d = read({"node": "text", "part": "int", "word": ["int"], "shown": ["any"], "region?": "int"}, v, "part")
        need(d["node"] == "part" and 0 <= d["part"] < len(self.parts) and len(d["word"]) <= 40, "no such part")
        f = self.parts[d["part"]]
        right((d["region"] is not None) == f.several, "the region of the part")
        need(0 <= (d["region"] or 0) < len(f.regions), "no such region")
        conditions = f.regions[d["region"] or 0]
        need(all(0 <= i < len(self.symmetries) for i in d["word"]), "no such symmetry")
        for s in (self.symmetries[i] for i in d["word"]):
            self.led.add(f)
            for c in f.classes:
                carried(c, s.map)
            conditions = s.map.before(conditions) + s.regions[0]
        right(len(d["shown"]) == len(conditions), "each condition of the part must be shown")
        for (g, sign), by in zip(conditions, d["shown"]):
            given.show(g, sign, by)


@checked.file
def verify(top, prove, strict):
    """The number of trusted steps, a summary and the statement; strict: no hypothesis may be unchecked.  Raises Malformed or
    Rejected."""
    ConditionSet.nodes = NODES
    top = read_theorem(top)
    try:
        theorem = Theorem(top, prove)
    except (ArithmeticError, ValueError, LookupError, TypeError, AttributeError, RecursionError, MemoryError) as why:
        raise Rejected(f"{type(why).__name__}: {why}") from None
    last = theorem.last
    lines = statement(last, theorem)
    used = [LITERATURE[name] for name in LITERATURE if name in last.used]
    unchecked = sum(how == "NOT CHECKED" for _, hypotheses in used for how, _ in hypotheses)
    open_ones = f"{unchecked} {'hypothesis' if unchecked == 1 else 'hypotheses'} NOT CHECKED"
    need(not unchecked or not strict, f"{open_ones}, refused by --strict")
    limits = f"{first_integrals(last.classes)}; " if last.classes else ""
    said = "; nothing is said where it says so" * any(f.kind == "O" for f in theorem.parts)
    checked.conclude(last.used, f"{limits}parameters without the exceptions of the statement{said}")
    said = f"given {len(used)} theorem{'s' * (len(used) != 1)} of the literature"
    return len(last.trusts), said + f" and {open_ones}" * bool(unchecked) + "; ", lines
