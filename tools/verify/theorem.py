"""Checks certificates of a theorem, kovacic-theorem/1 (docs/theory/theorem_certificates.md; numbers are its sections).

Each step becomes a fact by its rule (rule_NAME.py, core.py); a step names earlier ones only.  condition.py has the signs (2), family.py
the systems, tower.py and map.py the changes of variables (3, 4, 12)."""
from importlib import import_module
from pathlib import Path

import checked
from certificate_format import need, read, refusing, right
from condition import ConditionSet
from core import Facts
from family import FAMILY, Family, Here
from map import MAP
from phase_space import Function
from system_format import complete
from theorem_statement import LITERATURE, first_integrals, shown, statement

FORMAT = "kovacic-theorem/1"
FAMILIES, STEPS, NODES = 40, 200, 200000
# Each rule has the FIELDS of its data and said(theorem, step), which refuses what does not follow.
RULES = {path.stem.removeprefix("rule_").replace("_", "-"): import_module(path.stem)
         for path in sorted(Path(__file__).parent.glob("rule_*.py"))}


def read_theorem(top):
    top = read({"format": "text", "title": "text", "systems": [FAMILY], "steps": ["any"]}, top, "certificate")
    right(len(top["systems"]) <= FAMILIES and 1 <= len(top["steps"]) <= STEPS, "too many systems or steps")
    names = [s["name"] for s in top["systems"]]
    right(len(set(names)) == len(names), "a system occurs twice")
    for family in top["systems"]:
        complete(family["system"], family["parameters"])
    top["steps"] = [read_step(v) for v in top["steps"]]
    return top


def read_step(v):
    rule = v.get("rule") if isinstance(v, dict) else None
    right(isinstance(rule, str), "a rule is expected")
    need(rule in RULES, "an unknown rule")
    more = MAP if rule == "place" and "values" in v else {}         # without: by names
    d = read(RULES[rule].FIELDS | more | {"id": "text", "rule": "text"}, v, rule)
    right(not more or d["levels"] is None, "a level of a map that has values")
    return d


class Theorem:
    """The systems and the facts so far, and how a step names them"""

    def __init__(self, top, prove):
        self.prove, self.facts, self.led = prove, Facts(), set()
        self.families = {d["name"]: Family(d) for d in top["systems"]}
        for i, d in enumerate(top["steps"]):
            with refusing(f"step {d['id'][:60]!r} ({d['rule']}): "):
                need(d["id"] not in self.facts, "the id occurs twice")
                need((d["rule"] == "cover") == (i == len(top["steps"]) - 1), "the last step is a cover, and no other")
                said = self.said(d["rule"], d)
                of = self.facts.premises()
                self.last = self.facts.derive(d["id"], said)
                if checked.wanted:
                    checked.add(FORMAT, "rule", d["rule"], d["id"], of, shown(self.last))
        need(self.facts.named >= {d["id"] for d in top["steps"][:-1]}, "a step is not used")

    def said(self, rule, d):
        return RULES[rule].said(self, d)

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

    def here(self, d, plain=False):
        """The family where the parameters `at` are functions of the others, and on the region"""
        x = self.plain_family(d) if plain else self.family(d)
        at = self.put(d["at"] or [], x.names)
        right(set(at) <= set(x.names), "a parameter is expected")
        return Here(x, at, x.region(d["region"] or []))

    @staticmethod
    def put(rows, names):
        """{name: its value}, functions of the other names"""
        put = dict(rows)
        need(len(put) == len(rows), "a name is put twice")
        return {x: Function.read(v, {name: at for name, at in names.items() if name not in put}) for x, v in put.items()}

    @staticmethod
    def functions_there(of, here):
        """The values of the functions of which a fact speaks, of which some parameters are levels here"""
        levels = [name for name in of.target.parameters if name in of.names and name not in here.space.at]
        return [text + f", for some value of {', '.join(levels)}" * bool(levels) for text in of.there]


@checked.file()
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
