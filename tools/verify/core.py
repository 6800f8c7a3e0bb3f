"""Facts, and the cover that puts them together (docs/theory/calculus.md 1, 2, 5).  No rule makes a fact: a rule says something, and
Facts makes a fact of it and of all steps that the rule has looked at."""
from copy import copy

from certificate_format import need, read, right
from first_integrals import least
from map import carried


class Said:
    """The conclusion of a rule.  kind: N, I, S (1), J (integrable), L (leaves of a certificate) or O (nothing is said); regions: it
    is said of each; several: a part names one of them; classes: K, in the order in which they came; integrals: lines; used: names of
    theorems; trusts: what nothing repeats; way: texts, the phase curve and the maps from it; there: the values of functions of which
    it speaks, as text, with these names; target: the conditions, for a place; leaves: of a certificate, of each that says "not
    abelian", the conditions of its points, its trust and a function that gives the class; criteria: the same of those that say "where",
    with a difference for the trust"""

    def __init__(self, kind, family, regions, classes=(), integrals=(), used=(), trusts=(), way=(), *, target=None, map=None,
                 several=False, trusted="", only_stratum=False, shows_way=False, there=(), names=(), leaves=(), criteria=()):
        self.kind, self.family, self.regions, self.several = kind, family, [list(r) for r in regions], several
        self.classes, self.integrals, self.way, self.target, self.map = list(classes), list(integrals), list(way), target, map
        self.used, self.trusts, self.only_stratum = frozenset(used), frozenset(trusts), only_stratum
        self.trusted, self.shows_way, self.there, self.names = trusted, shows_way, list(there), names
        self.leaves, self.criteria = list(leaves), list(criteria)


class Facts:
    """The steps so far.  named: those that a later one has looked at"""

    def __init__(self):
        self.__all, self.__premises, self.named = {}, [], set()

    def __contains__(self, name):
        return name in self.__all

    def premise(self, name):
        """A step before; the next fact rests on it."""
        need(name in self.__all, "there is no such step before")
        self.named.add(name)
        self.__premises.append(self.__all[name])
        return self.__all[name]

    def premises(self):
        """The ids of those of the next fact"""
        return list(dict.fromkeys(name for p in self.__premises for name, f in self.__all.items() if f is p))

    def derive(self, name, said):
        """The fact has the theorems, the trust and the limits of its premises as well, whatever its rule says."""
        premises, self.__premises = self.__premises, []
        fact = self.__all[name] = copy(said)
        fact.used = said.used.union(*(f.used for f in premises))
        fact.trusts = said.trusts.union(*(f.trusts for f in premises))
        fact.only_stratum = said.only_stratum or any(f.only_stratum for f in premises)
        return fact


class Cover:
    """Each admitted point of the family lies in a region of a part, or a word of symmetries leads there.  led: the parts to which one
    leads"""

    def __init__(self, family, symmetries, parts, tree):
        need(all(f.family is family for f in symmetries + parts), "a step is about another system")
        need(any(f.kind in ("N", "J") for f in parts), "nothing says that it is not integrable")
        self.symmetries, self.parts, self.led = symmetries, parts, set()
        family.where(family.assumptions).absent(tree, self.part)
        self.classes = least(c for f in parts for c in f.classes)

    def part(self, v, given):
        """The points here lie there, by what is shown of each of its conditions, with the symmetries put in."""
        d = read({"node": "text", "part": "int", "word": ["int"], "shown": ["any"], "region?": "int"}, v, "part")
        need(d["node"] == "part" and 0 <= d["part"] < len(self.parts) and len(d["word"]) <= 40, "no such part")
        f, region = self.parts[d["part"]], d["region"] or 0
        right((d["region"] is not None) == f.several, "the region of the part")
        need(0 <= region < len(f.regions) and all(0 <= i < len(self.symmetries) for i in d["word"]), "no such region, or symmetry")
        conditions = f.regions[region]
        for s in (self.symmetries[i] for i in d["word"]):
            self.led.add(f)
            for c in f.classes:
                carried(c, s.map)
            conditions = s.map.before(conditions) + s.regions[0]
        right(len(d["shown"]) == len(conditions), "each condition of the part must be shown")
        for (g, sign), by in zip(conditions, d["shown"]):
            given.show(g, sign, by)
