#!/usr/bin/env python3
"""Mutation test of the Python checker: runs the traps on every mutant (mutants.py) of tools/verify until one of them
answers otherwise, and prints the score.

A trap is a certificate, right or wrong, which both checkers judge alike (traps.py: everything in data and false, and what
certificates() of a module beside this file yields), or a property of a function (properties() of such a module).  A mutant is
killed if it accepts what is refused or the other way round, states something else, ends in an error that is not a refusal, or
takes too long.  Only traps that run through the changed line are tried: first those that killed another mutant of the same
function, then those that are refused at the line, then the fast ones; properties last.  Each mutant has a process of its
own, so that it can leave nothing behind.  Mutants that change no rule stand in mutants.txt with the reason, and are counted.

usage: mutate_checker.py [--sample N] [--seed S] [--module NAME...] [--function NAME] [--least PERCENT] [--jobs J]
                         [--traps N] [--seconds S] [--cache FILE] [--out FILE]
"""
import argparse
import gc
import hashlib
import os
import pickle
import random
import resource
import select
import signal
import sys
import time
import traceback
import types
from array import array
from collections import Counter, defaultdict, namedtuple

import traps
from mutants import equivalent, is_equivalent, modules, mutants, source

SECONDS = 2                                 # of processor time for one trap, beside ten times what it takes unchanged;
FAST, SLOW = 0.004, 0.5                     # a trap that takes longer is traced by functions, or left out
MEMORY = 3 * 2**30
MODULES = modules()
CODE = {name: compile(source(name), name + ".py", "exec") for name in MODULES}

# text: a certificate or a function of the modules; said: the answer of the unchanged checker; seconds: its time; lines: the
# lines of the checker that it runs through, refused: those on the way to its refusal, as numbers (at)
Trap = namedtuple("Trap", "name text said seconds lines refused")


def at(module, line):
    return MODULES.index(module) * 10**4 + line


def checker(module=None, code=None):
    """Fresh modules, one of them changed; kovacic_verify of them.  ceil and lcm are at hand for the mutants."""
    from math import ceil, floor, gcd, lcm
    for name in MODULES:
        sys.modules.pop(name, None)
    for name in MODULES:
        m = sys.modules[name] = types.ModuleType(name)
        m.__file__ = os.path.join(traps.VERIFY, name + ".py")
        m.__dict__.update(ceil=ceil, floor=floor, lcm=lcm, gcd=gcd)
        exec(code if name == module else CODE[name], m.__dict__)
    return sys.modules["kovacic_verify"]


def answer(v, text):
    """What the checker says to one text, the statement included; or whether a property holds."""
    try:
        if callable(text):
            return "accepted" if text(sys.modules) else "refused",
        return "accepted", *v.check(text)
    except (v.Malformed, v.Rejected):
        return "refused",
    except Exception as error:              # noqa: BLE001 (a mutant may do anything)
        return type(error).__name__,


def lines_of(v, text, whole, wanted=None):
    """The lines of the checker that a text runs through (of those that are wanted), and those on the way to its refusal.  A
    function is left alone that goes round in circles; whole: all the lines of each function that is called, which is faster."""
    found, left, old, refused = set(), {}, Counter(), set()

    def trace(frame, event, _):
        code = frame.f_code
        rest = left.get(code)
        if rest is None:                    # the lines of this code that were not seen yet
            lines = {x[2] for x in code.co_lines() if x[2]} if code.co_filename[:-3] in CODE else ()
            left[code] = rest = {x for x in lines if wanted is None or at(code.co_filename[:-3], x) in wanted}
        if whole:
            found.update(at(code.co_filename[:-3], x) for x in rest)
            rest.clear()
        if not rest:
            return None
        if frame.f_lineno in rest:
            rest.discard(frame.f_lineno)
            found.add(at(code.co_filename[:-3], frame.f_lineno))
        else:
            old[code] += 1
            if old[code] > 100:
                rest.clear()
        return trace
    sys.settrace(trace)
    try:
        text(sys.modules) if callable(text) else v.check(text)
    except Exception as error:              # noqa: BLE001
        while error:
            for frame, line in traceback.walk_tb(error.__traceback__):
                if frame.f_code.co_filename[:-3] in CODE:
                    refused.add(at(frame.f_code.co_filename[:-3], line))
            error = error.__context__
    finally:
        sys.settrace(None)
    return array("I", found), array("I", refused)


def measured(given, wanted, cache):
    """The traps, run once on the unchanged checker; fast ones first.  cache: a file with those that were run before."""
    v, key = checker(), hashlib.sha256(repr((sorted(wanted), *map(source, MODULES))).encode()).digest()
    old, known = {}, {}
    if cache and os.path.exists(cache):
        with open(cache, "rb") as f:
            old = pickle.load(f)
    for name, text, accepted in given:
        mark = None if callable(text) else (key, hashlib.sha256(text.encode()).digest())
        if mark not in old or mark is None:
            start = time.process_time()
            said = answer(v, text)
            seconds = time.process_time() - start
            old[mark] = said, seconds, *lines_of(v, text, callable(text) or seconds > FAST, wanted)
        if (old[mark][0][0] == "accepted") != accepted:
            raise SystemExit(f"the unchanged checker: {name}: {old[mark][0][0]}")
        if old[mark][1] < SLOW or callable(text):
            known[name, mark] = Trap(name, text, *old[mark])
    if cache:
        with open(cache, "wb") as f:
            pickle.dump({k: x for k, x in old.items() if k and k[0] == key}, f)
    return sorted(known.values(), key=lambda t: t.seconds)


class Order:
    """Which traps are tried on a mutant, and in which order"""

    def __init__(self, all_traps, seconds):
        self.all, self.seconds = all_traps, seconds
        self.at, self.refused, self.killers = defaultdict(list), defaultdict(list), defaultdict(Counter)
        self.through = {name: [t for t in all_traps if any(x // 10**4 == i for x in t.lines)] for i, name in enumerate(MODULES)}
        for trap in all_traps:
            for line in trap.lines:
                self.at[line].append(trap)
            for line in trap.refused:
                self.refused[line].append(trap)

    def of(self, mutant):
        """As long as the time allows: those that are refused here, some that are right, the fast ones, a fixed choice of the others"""
        place = at(mutant.module, mutant.line)
        here = self.at[place] or (self.through[mutant.module] or self.all if mutant.function is None else [])
        killers = self.killers[mutant.module, mutant.function]
        first = sorted((t for t in here if killers[t.name]), key=lambda t: -killers[t.name])[:20]
        refused = [t for line in range(place, place - 3, -1) for t in self.refused[line][:20]]      # the start of a statement
        right = [t for t in here if t.said[0] == "accepted"]
        half = len(here) // 2
        rest = here[:half] + random.Random(1).sample(here[half:], len(here) - half)
        chosen = {}
        for some, seconds in ((first, self.seconds / 3), (refused, self.seconds / 3), (right, self.seconds / 3), (rest, self.seconds)):
            for t in some:
                if t.text not in chosen and not callable(t.text) and seconds > 0:
                    chosen[t.text], seconds = t, seconds - t.seconds
        return [*chosen.values(), *(t for t in here if callable(t.text))]

    def killed(self, mutant, trap):
        self.killers[mutant.module, mutant.function][trap.name] += 1


def change(mutant):
    """The changed function takes the place of its code in the modules that are loaded; else all are loaded anew."""
    if mutant.function is None:
        return checker(mutant.module, mutant.code())
    live = sys.modules[mutant.module]
    for name in mutant.function:
        live = vars(live)[name]
    live = getattr(live, "fget", getattr(live, "__func__", live))
    live.__code__ = mutant.code()
    return sys.modules["kovacic_verify"]


def try_all(mutant, todo, pipe):
    """In a process of its own: writes the number of the trap that kills the mutant; SIGPROF ends it where it takes too long."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    said = b"-1"
    try:
        v = change(mutant)
        for i, trap in enumerate(todo):
            signal.setitimer(signal.ITIMER_PROF, SECONDS + 10 * trap.seconds)
            if answer(v, trap.text) != trap.said:
                said = b"%d" % i
                break
    except BaseException:                   # noqa: BLE001
        said = b"-2"
    os.write(pipe, said)
    os._exit(0)


def run_all(chosen, order, jobs):
    """Yields each mutant with the name of the trap that killed it, or None, and with the number of traps; the processes one
    after the other, or `jobs` at a time."""
    waiting, busy = iter(chosen), {}
    gc.freeze()                             # so that a child copies little
    while True:
        while len(busy) < jobs and (mutant := next(waiting, None)):
            todo, (read, write) = order.of(mutant), os.pipe()
            if not (pid := os.fork()):
                try_all(mutant, todo, write)
            os.close(write)
            busy[read] = pid, mutant, todo
        if not busy:
            return
        for read in select.select(list(busy), [], [])[0]:
            pid, mutant, todo = busy.pop(read)
            said = os.read(read, 99)
            os.close(read)
            os.waitpid(pid, 0)
            i = int(said or b"-3")
            if i >= 0:
                order.killed(mutant, todo[i])
            yield mutant, todo[i].name if i >= 0 else {-1: None, -2: "not loaded", -3: "too long"}[i], len(todo)


def chosen_mutants(given):
    """How many there are, patterns of equivalent ones with their numbers, and the mutants to be run"""
    every = [x for name in given.module for x in mutants(name) if given.function in (None, x.name.split(":")[0])]
    patterns, count = equivalent(), Counter()
    for x in every:
        count.update([p for p in patterns if is_equivalent(x, [p])][:1])
    rest = [x for x in every if not is_equivalent(x, patterns)]
    if given.sample and given.sample < len(rest):
        rest = random.Random(given.seed).sample(rest, given.sample)
    return len(every), count, rest


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--sample", type=int, help="how many mutants are drawn; all of them if missing")
    parser.add_argument("--traps", type=int, help="how many certificates are drawn as traps; all of them if missing")
    parser.add_argument("--seed", type=int, default=13)
    parser.add_argument("--module", nargs="+", default=MODULES)
    parser.add_argument("--function", help="MODULE.FUNCTION or MODULE.CLASS.FUNCTION")
    parser.add_argument("--least", type=float, default=0, help="a lower score is a failure")
    parser.add_argument("--seconds", type=float, default=2, help="for the certificates of one mutant, unchanged")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--cache", help="a file that keeps what the traps ran through")
    parser.add_argument("--out", help="a file for every mutant with the trap that killed it")
    return parser.parse_args()


def main():
    given = options()
    sys.path.insert(0, traps.VERIFY)
    total, count, chosen = chosen_mutants(given)
    texts, properties = list(traps.certificates()), traps.properties()
    if given.traps:
        texts = random.Random(given.seed).sample(texts, min(given.traps, len(texts)))
    all_traps = measured([*texts, *properties], {at(x.module, x.line) for x in chosen}, given.cache)
    table, by_property = defaultdict(Counter), 0
    with open(given.out or os.devnull, "w", encoding="utf-8", buffering=1) as out:
        for mutant, by, tried in run_all(chosen, Order(all_traps, given.seconds), given.jobs):
            table[mutant.module][bool(by)] += 1
            by_property += by in {name for name, *_ in properties}
            print(f"{mutant.name}\t{by or f'ALIVE {tried}'}", file=out)
            if not by:
                print(f"alive: {mutant.name}  [{tried} traps]", flush=True)
    for module, n in table.items():
        print(f"{module:20} {n[True] + n[False]:5} mutants, {100 * n[True] / (n[True] + n[False]):5.1f} % killed")
    for pattern, reason in equivalent().items():
        if count[pattern]:
            print(f"{count[pattern]:4} left out: {pattern}: {reason}")
    dead = sum(n[True] for n in table.values())
    score = 100 * dead / max(1, len(chosen))
    print(f"{total} mutants, {sum(count.values())} of them equivalent (mutants.txt); {len(chosen)} run against {len(all_traps)} traps: "
          f"{dead} killed ({by_property} of them by a property only), {score:.1f} %")
    return 0 if score >= given.least else 1


if __name__ == "__main__":
    sys.exit(main())
