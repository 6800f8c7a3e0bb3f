"""Checks certificates of a theorem, kovacic-theorem/1 (docs/theory/theorem_certificates.md; numbers are its sections).

Each step becomes a fact by its rule (core.py, with the cover: 8); a step names earlier ones only.  condition.py has the signs (2),
family.py the systems, tower.py and map.py the changes of variables (3, 4, 7, 12), splitting.py (6), integrable.py (13) and darboux.py
(16) their steps."""
from functools import partial

import checked
import jets
import strata
import system
from certificate_format import need, refusing, right
from common_values import CommonValues, Difference
from condition import ConditionSet
from core import Cover, Facts, Said
from darboux import Darboux
from family import Family, Here, Target
from first_integrals import IntegralClass, casimirs, integrals
from integrable import Integrable
from map import Map, carried, lowest_order
from multivariate import FIELD, P, parse
from phase_space import Function, PhaseSpace, total
from splitting import Splitting
from statement import quoted
from system_format import read_system
from system_statement import Shown
from theorem_format import FORMAT, NODES, read_class, read_theorem
from theorem_statement import LEAVES, LITERATURE, ORIGIN, REAL, SYMMETRIC_TOP, first_integrals, shown, statement


class Theorem:
    def __init__(self, top, prove):
        self.prove, self.facts, self.led = prove, Facts(), set()
        self.families = {d["name"]: Family(d) for d in top["systems"]}
        for i, d in enumerate(top["steps"]):
            with refusing(f"step {d['id'][:60]!r} ({d['rule']}): "):
                need(d["id"] not in self.facts, "the id occurs twice")
                need((d["rule"] == "cover") == (i == len(top["steps"]) - 1), "the last step is a cover, and no other")
                said = getattr(self, d["rule"].replace("-", "_"))(d)
                of = self.facts.premises()
                self.last = self.facts.derive(d["id"], said)
                if checked.wanted:
                    checked.add(FORMAT, "rule", d["rule"], d["id"], of, shown(self.last))
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
        need(everywhere or inner.denials or inner.criteria, "no leaf says \"not abelian\"")
        excluded = integrals(curve, inner.denials + [x for x, _ in inner.criteria], casimirs(claims))
        only = curve.space.brackets is None or bool(excluded.functions or excluded.without)
        target = Target(curve.space, top["parameters"], list(self.asked(top, curve)), curve)
        shown = Shown(curve)
        way, (there, names) = [f"{shown.phase_curve(top)} of {quoted(top['title'])}"], shown.functions_explained()
        used = "Ayoul-Zung" if curve.space.brackets is None or any(x.whole for x in inner.denials) else "Morales-Ramis"
        at = {x: curve.space.at[x] for x in top["parameters"]}

        def leaf(x, more):
            path = [(Function(parse(text, at)), says) for text, says in x.path]
            there = Target(curve.space, top["parameters"], target.conditions + path, curve)
            return there, more, partial(integrals, curve, [x], casimirs(claims))
        leaves, criteria = [leaf(x, x.trust) for x in inner.denials], [leaf(*x) for x in inner.criteria]
        return Said("N" if everywhere else "L", None, [()], [excluded], (), [used], (), way, target=target, only_stratum=only,
                    there=there, names=names, leaves=leaves, criteria=criteria)

    def leaf(self, d):
        """One leaf of a certificate that says "not abelian", where it says so"""
        of = self.fact(d["of"], "N", "L")
        need(0 <= d["leaf"] < len(of.leaves), "no such leaf")
        target, trust, excluded = of.leaves[d["leaf"]]
        need(not trust, "a leaf on trust")
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

    # -- changes of variables (4, 7, 12)

    def here(self, d, plain=False):
        """The family where the parameters `at` are functions of the others, and on the region"""
        x = self.plain_family(d) if plain else self.family(d)
        at = self.put(d["at"] or [], x.names)
        right(set(at) <= set(x.names), "a parameter is expected")
        return Here(x, at, x.region(d["region"] or []))

    def put(self, rows, names):
        """{name: its value}, functions of the other names"""
        right(all(len(v) == 2 and isinstance(v[0], str) for v in rows), "a name and its value are expected")
        put = dict(rows)
        need(len(put) == len(rows), "a name is put twice")
        return {x: Function.read(v, {name: at for name, at in names.items() if name not in put}) for x, v in put.items()}

    def place(self, d):
        """The fact of another system: by the values of its names, or by the same names and some levels"""
        by_names = "values" not in d
        here, of = self.here(d, not by_names), self.proved(d["of"], "N", *["I"] * (not by_names))
        if by_names:
            need(of.target is not None, "the step says something else")
            d = d | {"levels": self.put(d["levels"] or [], here.free)}
        else:
            need(not of.only_stratum and (of.family is None or of.family.is_plain()), "another class")
        map = Map(here, of.target or Target.of(of.family, of.regions[0], of.kind == "N"), d)
        there = self.there(of, here) if by_names else of.there
        return Said(of.kind, here.family, [here.conditions()], [carried(c, map) for c in of.classes], of.integrals, (), (),
                    [*of.way, *([] if by_names else there), *map.shown()], shows_way=by_names or of.shows_way, there=there if by_names else ())

    @staticmethod
    def there(of, here):
        """The values of the functions of which a fact speaks, of which some parameters are levels here"""
        levels = [name for name in of.target.parameters if name in of.names and name not in here.space.at]
        return [text + f", for some value of {', '.join(levels)}" * bool(levels) for text in of.there]

    def symmetry(self, d):
        here = self.here(d, True)
        map = Map(here, Target.of(here.family, [], bool(d["adjoined"])), d)
        need(not map.affine, "the origin moves")
        need(all(map.values[v].n == 1 for v in here.family.names.values()), "a number below")
        return Said("S", here.family, [here.conditions()], map=map)

    def lowest_order(self, d):
        x, of = self.plain_family(d), self.proved(d["of"], "N")
        need(of.family is not None and of.family.is_plain(), "the step is about a system of a certificate")
        kept = [c for c in of.classes if not c.has_rational()]
        need(set(kept) <= {REAL}, "a class that parts of lowest order need not have")
        region = lowest_order(x, of.family, d, of.regions[0])
        return Said("N", x, [region], [*kept, ORIGIN], of.integrals, ["Ziglin 1982"])

    # -- strata of complex parameters, steps on trust (13 to 15)

    def darboux(self, d):
        here = self.here(d)
        classes, used, way = Darboux(here, d).fact()
        return Said("N", here.family, [here.conditions()], classes, (), used, (), way, shows_way=True)

    # -- two curves (17)

    def common_values(self, d):
        levels = [[], []] if d["levels"] is None else d["levels"]
        right(len(d["of"]) == len(d["leaves"]) == len(d["shown"]) == len(levels) == 2, "two leaves are expected")
        differences, classes, way = [], [], []
        for name, leaf, rows, put in zip(d["of"], d["leaves"], d["shown"], levels):
            here, of = self.here(d), self.proved(name, "N", "L")
            need(0 <= leaf < len(of.criteria), "no such leaf")
            target, difference, excluded = of.criteria[leaf]
            need(difference is not None, "not one exponent difference")
            map = Map(here, target, {"shown": rows, "levels": self.put(put, here.free)})
            classes.append(carried(excluded(), map))
            way += [*of.way, *map.shown()]
            need(not self.there(of, here), "functions have values there, which may be others along the other curve")
            known, times, square = difference
            differences.append(Difference(known, times, *(self.in_parameters(text, target, here) for text in square)))
        found = CommonValues(*differences, d, here.given)
        return Said("N", here.family, [here.conditions() + found.conditions()], list(dict.fromkeys(classes)), (), (), (), way,
                    shows_way=True)

    @staticmethod
    def in_parameters(text, target, here):
        """The same polynomial in the parameters of X that are left, if they are those of Y"""
        of_y = parse(text, {x: target.space.at[x] for x in target.space.at})
        need(of_y.variables() <= {target.space.at[x] for x in target.parameters if x in here.free}, "the difference depends on a level")
        return parse(text, here.free)

    def integrable(self, d):
        here = self.here(d)
        shown = Integrable(here, d)
        return Said("J", here.family, [here.conditions()], (), [(here.family, shown.claims, shown.fields, shown.not_shown)], (),
                    [(d["id"], what) for what in shown.not_shown])

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

    def cover(self, d):
        self.symmetries = [self.fact(name, "S") for name in d["symmetries"]]
        self.parts = [self.fact(name, "N", "I", "J", "O") for name in d["parts"]]
        cover = Cover(self.family(d), self.symmetries, self.parts, d["tree"])
        self.led = cover.led
        return Said("N", self.family(d), [()], cover.classes)


@checked.file
def verify(top, prove, strict):
    """The number of trusted steps, a summary and the statement; strict: no hypothesis may be unchecked.  Raises Malformed or
    Rejected."""
    ConditionSet.nodes = NODES
    top = read_theorem(top)
    with refusing():
        theorem = Theorem(top, prove)
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
