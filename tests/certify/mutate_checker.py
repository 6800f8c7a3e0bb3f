#!/usr/bin/env python3
"""Mutation test of the Python checker: changes one operator, comparison, sign, constant, index, `and`/`or`/`not` or
requirement of tools/verify at a time, and runs the traps on each mutant until one of them answers otherwise.

The traps are the properties of arithmetic.py, several_variables.py and groups.py, the genuine certificates (data,
data/strata), the false ones (false, and what false/strata.jsonl and false/changed.jsonl make of genuine ones) and the
hostile texts of traps.py.  A mutant is killed if a property fails, if a certificate is accepted instead of refused or the other way round, has another
statement, is "malformed" where it was refused, or takes too long.  Only traps that run through the changed line are
tried, those that killed a mutant of the same function first; a changed function takes the place of its code in the
modules that are loaded.  Survivors that change nothing a certificate could show are listed with the reason in
mutants.txt.

usage: mutate_checker.py [--sample N] [--seed S] [--module NAME...] [--function NAME] [--least PERCENT] [--jobs J] [--show]
                         [--traps N] [--certify TEST_CERTIFY]      (its certificates over strata, too)
"""
import argparse
import fnmatch
import os
import random
import resource
import select
import signal
import sys
import time
import traceback
import types
from collections import Counter, defaultdict

import arithmetic
import groups
import several_variables
import systems
import traps
from mutants import mutants, source

VERIFY = traps.VERIFY
MODULES = ["modular", "exact", "certificate_format", "multivariate", "places", "strata_format", "strata_invariant",
           "strata_leaves", "stratum", "statement", "first_integrals", "strata", "system_format", "phase_space",
           "function_algebra", "phase_curve", "system_statement", "system", "equation", "singular_points", "group_rules",
           "conclusions", "kovacic_verify"]
SECONDS = 2.0                               # for one trap, beside ten times what it takes unchanged
TOTAL = 0.5                                 # seconds for the traps of one mutant, unchanged; the fast ones first
SLOW = 0.3                                  # a trap that takes longer is left out
MEMORY = 3 * 2**30


class TooLong(BaseException):
    pass


def too_long(*_):
    raise TooLong


CODE = {name: compile(source(name), name + ".py", "exec") for name in MODULES}


def checker(module=None, code=None):
    """Fresh modules, one of them changed; kovacic_verify of them.  ceil and lcm are at hand for the mutants."""
    from math import ceil, floor, gcd, lcm
    for name in MODULES:
        sys.modules.pop(name, None)
    for name in MODULES:
        m = sys.modules[name] = types.ModuleType(name)
        m.__file__ = os.path.join(VERIFY, name + ".py")
        m.__dict__.update(ceil=ceil, floor=floor, lcm=lcm, gcd=gcd)
        exec(code if name == module else CODE[name], m.__dict__)
    return sys.modules["kovacic_verify"]


class Changed:
    """The checker with one function, or with a whole module where the change is in none, replaced."""
    loaded = None                           # the unchanged modules

    def __init__(self, module, function, code):
        self.module, self.function, self.code, self.undo = module, function, code, None

    def __enter__(self):
        if self.function is None:
            return checker(self.module, self.code)
        Changed.loaded = Changed.loaded or checker()
        live, code = sys.modules[self.module], self.code
        for name in self.function:
            live = vars(live)[name]
            code = next(x for x in code.co_consts if getattr(x, "co_name", None) == name)
        live = getattr(live, "fget", getattr(live, "__func__", live))
        self.undo, live.__code__ = (live, live.__code__), code
        return Changed.loaded

    def __exit__(self, *_):
        if self.undo:
            self.undo[0].__code__ = self.undo[1]
        else:
            Changed.loaded = None


def answer(v, text, seconds):
    """What the checker says to one text, the statement included; or whether a property holds."""
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        if callable(text):
            return "accepted" if text(sys.modules) else "rejected", 0, "", ()
        trusted, summary, lines = v.check(text)
        return "accepted", trusted, summary, tuple(lines)
    except v.Malformed:
        return ("malformed",)
    except v.Rejected:
        return ("rejected",)
    except TooLong:
        return ("too long",)
    except Exception as error:              # noqa: BLE001 (a mutant may do anything)
        return (type(error).__name__,)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def lines_of(v, text):
    """The lines of the checker that a text runs through, and those on the way to its refusal.  A function is left alone
    that goes round in circles."""
    found, left, old, refused = set(), {}, Counter(), set()

    def trace(frame, event, _):
        code = frame.f_code
        module = code.co_filename[:-3]
        if module not in CODE:
            return None
        rest = left.get(code)
        if rest is None:
            rest = left[code] = {x[2] for x in code.co_lines() if x[2]}
        old[code] += frame.f_lineno not in rest
        rest.discard(frame.f_lineno)
        found.add((module, frame.f_lineno))
        if not rest or old[code] > 500:
            frame.f_trace_lines = False
            return None
        return trace
    sys.settrace(trace)
    try:
        text(sys.modules) if callable(text) else v.check(text)
    except Exception as error:              # noqa: BLE001
        while error:
            for frame, line in traceback.walk_tb(error.__traceback__):
                refused.add((frame.f_code.co_filename[:-3], line))
            error = error.__context__
    finally:
        sys.settrace(None)
    return found, refused


def killed(mutant, todo, killers):
    """The trap that sees the mutant, or None; killers: how many mutants of this function a trap saw before."""
    name, module, function, code = mutant
    todo = sorted(todo, key=lambda t: -killers[t[0]])
    try:
        signal.setitimer(signal.ITIMER_REAL, SECONDS)
        with Changed(module, function, code) as v:
            signal.setitimer(signal.ITIMER_REAL, 0)
            for trap, text, expected, seconds in todo:
                if answer(v, text, SECONDS + 10 * seconds) != expected:
                    killers[trap] += 1
                    return trap
    except BaseException as error:          # noqa: BLE001
        return f"import: {type(error).__name__}"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    return None


def work(jobs, pipe):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    out = os.fdopen(pipe, "w", buffering=1)
    killers = defaultdict(Counter)
    for i, (mutant, todo) in jobs:
        by = killed(mutant, todo, killers[mutant[1:3]])
        out.write(f"{i}\t{by or ''}\n")
    out.close()
    os._exit(0)


def run_all(jobs, workers):
    """{number: trap that killed it, or ''}; a worker that is stuck in one operation is replaced."""
    results, queue, busy = {}, list(enumerate(jobs)), []

    def start(share):
        read, write = os.pipe()
        pid = os.fork()
        if pid == 0:
            os.close(read)
            work(share, write)
        os.close(write)
        busy.append({"pid": pid, "fd": read, "left": [i for i, _ in share], "share": share, "since": time.time(),
                     "text": ""})
    shares = [queue[k::workers] for k in range(workers)]
    for share in filter(None, shares):
        start(share)
    while busy:
        ready = select.select([w["fd"] for w in busy], [], [], 1)[0]
        for w in list(busy):
            if w["fd"] in ready:
                data = os.read(w["fd"], 1 << 16).decode()
                w["text"] += data
                *rows, w["text"] = w["text"].split("\n")
                for row in rows:
                    i, _, by = row.partition("\t")
                    results[int(i)] = by
                    if not by:
                        print("alive:", jobs[int(i)][0][0], f"  [{len(jobs[int(i)][1])} traps]", flush=True)
                    w["left"].remove(int(i))
                    w["since"] = time.time()
                ended = not data
            else:
                ended = time.time() - w["since"] > 60
                if ended:
                    os.kill(w["pid"], signal.SIGKILL)
            if ended:
                os.waitpid(w["pid"], 0)
                os.close(w["fd"])
                busy.remove(w)
                if w["left"]:               # it died or was stuck at the first that is left
                    results[w["left"][0]] = "the process ended"
                    rest = set(w["left"][1:])
                    if rest:
                        start([x for x in w["share"] if x[0] in rest])
    return results


def within(todo, refused_here, seconds):
    """The properties, what is refused at the changed line, and of the others the fast ones and a fixed choice, as long as
    the time allows."""
    first = [t for t in todo if callable(t[1])] + refused_here[:20]
    names = {t[0] for t in first}
    todo = [t for t in todo if t[0] not in names]
    random.Random(1).shuffle(rest := todo[len(todo) // 2:])
    chosen = []
    for trap in todo[:len(todo) // 2] + rest:
        seconds -= trap[3]
        if seconds < 0:
            break
        chosen.append(trap)
    return first + chosen


def equivalent():
    """Patterns of mutants that change nothing, from mutants.txt: pattern, then the reason after ' # '."""
    with open(os.path.join(traps.HERE, "mutants.txt"), encoding="utf-8") as f:
        rows = [line.rstrip("\n").partition("  # ")[0].rstrip() for line in f]
    return [x for x in rows if x and not x.startswith("#")]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--sample", type=int)
    options.add_argument("--seed", type=int, default=13)
    options.add_argument("--module", nargs="+", default=MODULES)
    options.add_argument("--function", help="MODULE.FUNCTION or MODULE.CLASS.FUNCTION")
    options.add_argument("--least", type=float, default=0)
    options.add_argument("--certify")
    options.add_argument("--traps", type=int, help="how many certificates are drawn as traps; all of them if missing")
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--show", action="store_true", help="every mutant with the trap that kills it")
    given = options.parse_args()
    signal.signal(signal.SIGALRM, too_long)
    sys.path.insert(0, VERIFY)
    known = equivalent()
    every = [(name, module, line, function, make) for module in given.module
             for name, line, function, make in mutants(module)
             if given.function in (None, name.split(":")[0])]
    considered = [m for m in every if not any(fnmatch.fnmatchcase(m[0], x) for x in known)]
    chosen = considered
    if given.sample and given.sample < len(considered):
        chosen = random.Random(given.seed).sample(considered, given.sample)
    v, all_traps = checker(), []
    properties = arithmetic.properties() + several_variables.properties() + groups.properties()
    others = traps.of_the_judge(given.certify) if given.certify else []
    texts = [*traps.certificates(), *systems.certificates(), *others]
    if given.traps:
        texts = random.Random(given.seed).sample(texts, min(given.traps, len(texts)))
    for trap, text, accepted in [*properties, *texts]:
        start = time.process_time()
        said = answer(v, text, 60)
        seconds = time.process_time() - start
        if (said[0] == "accepted") != accepted:
            print(f"the unchanged checker: {trap}: {said[0]}")
            return 1
        if seconds < SLOW or callable(text):
            all_traps.append((trap, text, said, seconds, *lines_of(v, text)))
    all_traps.sort(key=lambda t: t[3])
    at, refused_at = defaultdict(list), defaultdict(list)
    for *trap, lines, refused in all_traps:
        for line in lines:
            at[line].append(tuple(trap))
        for line in refused:
            refused_at[line].append(tuple(trap))
    jobs = []
    for name, module, line, function, make in chosen:
        todo = at[module, line] or ([t[:4] for t in all_traps] if function is None else [])
        here = [t for i in range(line, line - 3, -1) for t in refused_at[module, i]]        # the start of a statement
        jobs.append(((name, module, function, make()), within(todo, here, TOTAL)))
    results = run_all(jobs, given.jobs)
    table = defaultdict(Counter)
    for i, ((name, module, *_), _) in enumerate(jobs):
        table[module][bool(results.get(i))] += 1
        if given.show:
            print(f"{name}\t{results.get(i) or 'ALIVE'}")
    for module, n in table.items():
        print(f"{module:20} {n[True] + n[False]:5} mutants, {100 * n[True] / (n[True] + n[False]):5.1f} % killed")
    dead = sum(n[True] for n in table.values())
    score = 100 * dead / max(1, len(jobs))
    print(f"{len(every)} mutants, {len(every) - len(considered)} of them known to be equivalent; {len(jobs)} run against "
          f"{len(all_traps)} traps: {dead} killed, {score:.1f} %")
    return 0 if score >= given.least else 1


if __name__ == "__main__":
    sys.exit(main())
