#!/usr/bin/env python3
"""Independent checker for kovacic-certificate/1, kovacic-strata/1, kovacic-system/1, kovacic-theorem/1, kovacic-jets/1,
kovacic-homoclinic/1, kovacic-loops/1 (Python 3 standard library only).

Nothing is searched for: each step is recomputed from its data and its premises.  Here is the judge of kovacic-certificate/1: a
statement about the differential Galois group G of y'' = r(z) y, r = num/den in K(z), K = Q(a) (docs/theory/certificates.md).
The others are strata.py, system.py, theorem.py, jets.py, homoclinic.py and loops.py; each names its page, and what it imports.

usage: kovacic_verify.py [--strict] [--explain] [--needs] FILE...   (- is standard input)
exit 0 accepted, 1 rejected, 2 malformed
"""
import sys

import checked
import explanation
import homoclinic
import jets
import loops
import statement
import strata
import system
import theorem
from certificate_format import CLAIM, Malformed, Rejected, load, need, parse, refusing, right
from conclusions import COMPONENT, conclude
from equation import Equation, Fact
from exact import K, ONE, irreducible
from group_rules import Checker
from multivariate import Work


def run(checker, rule, data, given):
    """One step: hands the premises to the rule by their kind."""
    local, v = (next((x for x in given if x.kind == k), None) for k in ("local", "invariant"))
    check = getattr(checker, rule.replace("-", "_"))
    if rule in ("local", "exponential", "invariant"):
        need(not given, "no premises are expected")
        return check(data)
    need(local or rule in ("p-curvature", "torsion-function", "good-reduction"), "a local premise is missing")
    if rule in ("no-exponential", "p-curvature", "no-invariant"):
        return check(data, local)
    need(v and v.m == 2 and v.branch.degree() > 0 and v.w_squared.c, "an invariant premise is missing")
    return check(data, local, v)


def tell(step, result):
    """For a reader"""
    row, found = ("rule", step["rule"]), statement.step(step["rule"], step["data"])
    if step["rule"] == "conclude":
        group, n, abelian = result
        row, found = ("theorem", step["data"]["theorem"]), "abelian" if abelian else "not abelian"
        found = f"G = {group}" + f"_{n}" * (n is not None) if group else found
    checked.add("kovacic-certificate/1", *row, step["id"], step["premises"], found)


@checked.file()
def prove(top):
    """Of an ordinary certificate: num, den, the claim, the number of trusted steps and the statement."""
    num, den, claim, steps = load(top)
    size = sum(c * c for c in K.m).bit_length() // 2 + K.d + 1
    right(K.d == 1 or size < 76, "the minimal polynomial is too large")
    right(K.d == 1 or irreducible(K.m), "the minimal polynomial is not proved irreducible")
    need(den.c and den.lead() == ONE, "den is not monic")
    need(num.c or den.degree() == 0, "r = 0 must be written with den = 1")
    checker, facts, used, trusted, result = Checker(num, den), {}, set(), [], None
    checker.spend(10**6)
    for step in steps:
        name, rule, data = step["id"], step["rule"], step["data"]
        with refusing(f"step {name!r} ({rule}): "):
            need(name not in facts, "the id occurs twice")
            need(all(x in facts for x in step["premises"]), "a premise is not an earlier step")
            used.update(step["premises"])
            given = [facts[x] for x in step["premises"]]
            if rule == "conclude":
                result, facts[name] = conclude(data["theorem"], given), Fact("conclusion")
            elif rule == "apply-theorem":
                need(any(x.kind == "conclusion" for x in given), "the theorem is not applied to a conclusion")
                facts[name] = Fact("conclusion")
                trusted.append((data["theorem"], data["statement"]))
            else:
                facts[name] = run(checker, rule, data, given)
            if checked.wanted:
                tell(step, result)
    need(steps[-1]["rule"] in ("conclude", "apply-theorem") and result, "the last step is not a conclusion")
    need(used >= {s["id"] for s in steps[:-1]}, "a step is not used")
    need(claim and ("n" not in claim or "group" in claim), "nothing is claimed")
    for key, value in zip(CLAIM, (result[0], result[1], COMPONENT[result[0]], result[2])):
        need(key not in claim or claim[key] == value, f"the claim does not follow: {key}")
    lines = statement.group(num, den, K.m, claim, trusted)
    checked.conclude((), "one equation, over C(z)")
    return num, den, claim, len(trusted), lines


def check(text, strict=False):
    """The number of trusted steps, a summary and the lines of the statement; strict: no hypothesis of a theorem may be
    unchecked.  Raises Malformed or Rejected."""
    top, Equation.spent, Work.left = parse(text), 0, 4 * 10**7
    form = top.get("format") if isinstance(top, dict) else None
    for judge in (theorem, system, homoclinic, jets, loops, strata):
        if form == judge.FORMAT:
            return judge.verify(top, prove, strict)
    *_, trusted, lines = prove(top)
    return trusted, "", lines


def shown(text):
    """What others wrote, in one line."""
    return "".join(x if x.isprintable() else "?" for x in text[:1000])


def judge(name, strict, more=()):
    """The exit code for one file, its line of output and what it states."""
    checked.start(bool(more))
    try:
        with open(0 if name == "-" else name, "rb", closefd=name != "-") as f:
            text = f.read(2**28 + 1)
        need(len(text) <= 2**28, "longer than 2^28 bytes")
        trusted, summary, lines = check(text.decode("utf-8"), strict)
        need(not trusted or not strict, f"{trusted} trusted steps, refused by --strict")
        lines += explanation.explained() if "--explain" in more else []
        lines += explanation.needed(trusted) if "--needs" in more else []
    except (Malformed, OSError, UnicodeDecodeError) as error:
        return 2, f"malformed: {shown(str(error))}", []
    except (Rejected, MemoryError) as error:
        return 1, f"rejected: {shown(str(error)) or 'out of memory'}", []
    return 0, f"accepted ({summary}{trusted} trusted step{'s' * (trusted != 1)})", lines


def main(args):
    names = [x for x in args if x not in ("--strict", "--explain", "--needs")]
    if not names:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        import resource
        resource.setrlimit(resource.RLIMIT_AS, (2**32, resource.getrlimit(resource.RLIMIT_AS)[1]))
        import signal
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)      # whoever reads has seen enough: `| head`
    except (ImportError, AttributeError, ValueError, OSError):
        pass                                # no ceiling for the memory on this system
    sys.stdout.reconfigure(errors="backslashreplace")      # a locale of ASCII
    worst = 0
    for name in names:
        code, line, stated = judge(name, "--strict" in args, [x for x in args if x in ("--explain", "--needs")])
        print("\n  ".join([line if len(names) == 1 else f"{shown(name)}: {line}", *stated]))
        worst = max(worst, code)
    return worst


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
