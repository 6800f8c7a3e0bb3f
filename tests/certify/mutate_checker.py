#!/usr/bin/env python3
"""Mutation test of the Python checker: changes one operator, comparison, sign, constant, index, `and`/`or`/`not` or
requirement of tools/verify at a time, and runs the traps on each mutant until one of them answers otherwise.

The traps are the genuine certificates (data, data/strata), the false ones (false, and what false/strata.jsonl and
false/changed.jsonl make of genuine ones) and the hostile texts of traps.py.  A mutant is killed if a trap is accepted
instead of refused or the other way round, has another statement, is "malformed" where it was refused, or takes too
long.  Survivors that change nothing a certificate could show are listed with the reason in mutants.txt.

usage: mutate_checker.py [--sample N] [--seed S] [--module NAME] [--least PERCENT] [--jobs J] [--show]
"""
import argparse
import ast
import copy
import fnmatch
import os
import random
import resource
import select
import signal
import sys
import time
import types

import traps

VERIFY = traps.VERIFY
MODULES = ["modular", "exact", "certificate_format", "multivariate", "places", "strata_format", "strata_leaves", "stratum",
           "statement", "strata", "equation", "singular_points", "group_rules", "conclusions", "kovacic_verify"]
LIMIT = 2.0                                 # seconds for one trap, beside ten times what it takes unchanged
TOTAL = 0.5                                 # seconds for the traps of one mutant, unchanged; the fast ones first
SLOW = 0.1                                  # a trap that takes longer is left out
MEMORY = 3 * 2**30
COMPARE = {ast.Lt: [ast.LtE, ast.Gt], ast.LtE: [ast.Lt, ast.GtE], ast.Gt: [ast.GtE, ast.Lt], ast.GtE: [ast.Gt, ast.LtE],
           ast.Eq: [ast.NotEq], ast.NotEq: [ast.Eq], ast.In: [ast.NotIn], ast.NotIn: [ast.In], ast.Is: [ast.IsNot],
           ast.IsNot: [ast.Is]}
OPERATOR = {ast.Add: [ast.Sub], ast.Sub: [ast.Add], ast.Mult: [ast.Add], ast.FloorDiv: [ast.Mult], ast.Div: [ast.Mult],
            ast.Mod: [ast.Mult], ast.Pow: [ast.Mult], ast.LShift: [ast.RShift], ast.RShift: [ast.LShift],
            ast.BitAnd: [ast.BitOr], ast.BitOr: [ast.BitAnd]}
SWAPPED = {"any": "all", "all": "any", "min": "max", "max": "min", "ceil": "floor", "floor": "ceil", "lcm": "gcd"}
UNTOUCHED = ("spend", "charge", "cost")     # estimates of work: limits, not rules


def source(module):
    with open(os.path.join(VERIFY, module + ".py"), encoding="utf-8") as f:
        return f.read()


# ---- mutants ---------------------------------------------------------------------------------------------------------

class Finder(ast.NodeVisitor):
    """Collects (node, field, index, replacement, what) for one module."""

    def __init__(self):
        self.found, self.where = [], []

    def put(self, parent, field, index, new, what):
        self.found.append((parent, field, index, new, what, ".".join(self.where)))

    def visit(self, node):
        named = isinstance(node, (ast.FunctionDef, ast.ClassDef))
        if named:
            self.where.append(node.name)
        for field, value in ast.iter_fields(node):
            for i, child in enumerate(value if isinstance(value, list) else [value]):
                if isinstance(child, ast.AST) and not self.skipped(node, field, child):
                    self.mutate(node, field, i if isinstance(value, list) else None, child)
                    self.visit(child)
        if named:
            self.where.pop()

    @staticmethod
    def skipped(parent, field, node):
        if isinstance(node, ast.JoinedStr) or field in ("decorator_list", "annotation"):
            return True
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            return True                     # a docstring
        call = node.value if isinstance(node, ast.Expr) else node
        if isinstance(call, ast.Call):
            name = getattr(call.func, "id", getattr(call.func, "attr", ""))
            return name in UNTOUCHED
        return isinstance(node, ast.FunctionDef) and node.name in UNTOUCHED

    def mutate(self, parent, field, index, node):
        def put(new, what):
            self.put(parent, field, index, ast.copy_location(new, node), what)
        if isinstance(node, ast.Compare):
            for i, op in enumerate(node.ops):
                for other in COMPARE[type(op)]:
                    new = copy.deepcopy(node)
                    new.ops[i] = other()
                    put(new, ast.unparse(new))
        elif isinstance(node, ast.BinOp):
            for other in OPERATOR.get(type(node.op), []):
                if not isinstance(node.left, (ast.JoinedStr, ast.Constant)) or not isinstance(
                        getattr(node.left, "value", 0), str):
                    new = ast.BinOp(node.left, other(), node.right)
                    put(new, ast.unparse(new))
        elif isinstance(node, ast.BoolOp):
            new = ast.BoolOp(ast.Or() if isinstance(node.op, ast.And) else ast.And(), node.values)
            put(new, ast.unparse(new))
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub)):
            put(node.operand, ast.unparse(node.operand) + " for " + ast.unparse(node))
        elif isinstance(node, (ast.If, ast.IfExp, ast.While)):
            new = copy.copy(node)
            new.test = ast.copy_location(ast.UnaryOp(ast.Not(), node.test), node.test)
            put(new, "not " + ast.unparse(node.test))
        elif isinstance(node, ast.AugAssign) and type(node.op) in OPERATOR:
            new = ast.AugAssign(node.target, OPERATOR[type(node.op)][0](), node.value)
            put(new, ast.unparse(new))
        elif isinstance(node, ast.Constant):
            if isinstance(node.value, bool):
                put(ast.Constant(not node.value), f"{not node.value} for {node.value}")
            elif isinstance(node.value, int):
                put(ast.Constant(node.value + 1), f"{node.value + 1} for {node.value}")
        elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            put(ast.Pass(), "without " + ast.unparse(node)[:200])
        elif isinstance(node, ast.Name) and node.id in SWAPPED and isinstance(node.ctx, ast.Load):
            put(ast.Name(SWAPPED[node.id], ast.Load()), f"{SWAPPED[node.id]} for {node.id}")


def mutants(module):
    """(name, function that makes the changed code object)"""
    tree = ast.parse(source(module))
    finder = Finder()
    finder.visit(tree)
    for parent, field, index, new, what, where in finder.found:
        def make(parent=parent, field=field, index=index, new=new):
            old = getattr(parent, field)
            if index is None:
                setattr(parent, field, new)
            else:
                old, value = old[index], old
                value[index] = new
            try:
                return compile(ast.fix_missing_locations(tree), module + ".py", "exec")
            finally:
                if index is None:
                    setattr(parent, field, old)
                else:
                    value[index] = old
        what = " ".join(what.split())
        yield f"{module}.{where}: {what}" if where else f"{module}: {what}", new.lineno, make


# ---- running ---------------------------------------------------------------------------------------------------------

class TooLong(BaseException):
    pass


def too_long(*_):
    raise TooLong


CODE = {name: compile(source(name), name + ".py", "exec") for name in MODULES}


def checker(module=None, code=None):
    """Fresh modules, one of them changed; kovacic_verify of them.  ceil and lcm are at hand for the mutants."""
    for name in MODULES:
        sys.modules.pop(name, None)
    for name in MODULES:
        m = sys.modules[name] = types.ModuleType(name)
        m.__file__ = os.path.join(VERIFY, name + ".py")
        from math import ceil, floor, gcd, lcm
        m.__dict__.update(ceil=ceil, floor=floor, lcm=lcm, gcd=gcd)
        exec(code if name == module else CODE[name], m.__dict__)
    return sys.modules["kovacic_verify"]


def answer(v, text, seconds):
    """What the checker says to one text, the statement included."""
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
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


def lines_of(module_lines, v, text):
    """The lines of the checker that a text runs through."""
    def trace(frame, event, _):
        name = os.path.basename(frame.f_code.co_filename)[:-3]
        if name not in CODE or not frame.f_code.co_filename.endswith(name + ".py"):
            return None
        module_lines.add((name, frame.f_lineno))
        return trace
    sys.settrace(trace)
    try:
        answer(v, text, 60)
    finally:
        sys.settrace(None)
    return module_lines


def killed(name, module, code, todo):
    """The trap that sees the mutant, or None."""
    try:
        signal.setitimer(signal.ITIMER_REAL, LIMIT)
        v = checker(module, code)
    except BaseException as error:          # noqa: BLE001
        return f"import: {type(error).__name__}"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    for trap, text, expected, seconds in todo:
        if answer(v, text, LIMIT + 10 * seconds) != expected:
            return trap
    return None


def work(jobs, pipe):
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    out = os.fdopen(pipe, "w", buffering=1)
    for i, (name, module, code, todo) in jobs:
        by = killed(name, module, code, todo)
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


def within(todo, seconds):
    """The fast half and a fixed choice of the others, as long as the time allows."""
    todo, chosen = list(todo), []
    random.Random(1).shuffle(rest := todo[len(todo) // 2:])
    for trap in todo[:len(todo) // 2] + rest:
        seconds -= trap[3]
        if seconds < 0:
            break
        chosen.append(trap)
    return chosen


def equivalent():
    """Patterns of mutants that change nothing, from mutants.txt: pattern, then the reason after ' # '."""
    with open(os.path.join(traps.HERE, "mutants.txt"), encoding="utf-8") as f:
        rows = [line.rstrip("\n").partition("  # ")[0].rstrip() for line in f]
    return [x for x in rows if x and not x.startswith("#")]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--sample", type=int)
    options.add_argument("--seed", type=int, default=13)
    options.add_argument("--module")
    options.add_argument("--least", type=float, default=0)
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--show", action="store_true", help="every mutant with the trap that kills it")
    given = options.parse_args()
    signal.signal(signal.SIGALRM, too_long)
    sys.path.insert(0, VERIFY)
    known = equivalent()
    every = [(name, module, line, make) for module in MODULES if given.module in (None, module)
             for name, line, make in mutants(module)]
    considered = [m for m in every if not any(fnmatch.fnmatchcase(m[0], x) for x in known)]
    chosen = considered
    if given.sample and given.sample < len(considered):
        chosen = random.Random(given.seed).sample(considered, given.sample)
    v, all_traps = checker(), []
    for trap, text, accepted in traps.certificates():
        start = time.process_time()
        said = answer(v, text, 60)
        seconds = time.process_time() - start
        if (said[0] == "accepted") != accepted:
            print(f"the unchanged checker: {trap}: {said[0]}")
            return 1
        if seconds < SLOW:
            all_traps.append((trap, text, said, seconds, lines_of(set(), v, text)))
    all_traps.sort(key=lambda t: t[3])
    at = {}
    for trap, text, said, seconds, lines in all_traps:
        for line in lines:
            at.setdefault(line, []).append((trap, text, said, seconds))
    jobs = []
    for name, module, line, make in chosen:
        todo = at.get((module, line)) or ([t[:4] for t in all_traps] if "." not in name.split(":")[0] else [])
        jobs.append((name, module, make(), within(todo, TOTAL)))
    results = run_all(jobs, given.jobs)
    alive = sorted(f"{name}   [line {chosen[i][2]}, {len(jobs[i][3])} traps]" for i, (name, *_) in enumerate(jobs)
                   if not results.get(i))
    if given.show:
        for i, (name, *_) in enumerate(jobs):
            print(f"{name}\t{results.get(i) or 'ALIVE'}")
    score = 100 * (1 - len(alive) / max(1, len(jobs)))
    for name in alive:
        print("alive:", name)
    print(f"{len(every)} mutants, {len(every) - len(considered)} of them known to be equivalent; {len(jobs)} run against "
          f"{len(all_traps)} traps: {len(jobs) - len(alive)} killed, {score:.1f} %")
    return 0 if score >= given.least else 1


if __name__ == "__main__":
    sys.exit(main())
