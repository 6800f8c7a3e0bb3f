"""This program on the same equations: answers and processor time."""

import json
import subprocess
import sys

# A small process between this one and the program: what a process needs at its peak includes what
# its parent held when it was forked.
MEASURE = """
import os, subprocess, sys, json
child = subprocess.Popen(sys.argv[1:])
_, status, usage = os.wait4(child.pid, 0)
print(json.dumps([usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024]), file=sys.stderr)
"""


def run(program, equations, timeout, extra=()):
    """One process, one line for each equation.  Returns the results, processor seconds for each equation
    (reading, deciding and printing, the start of the process included) and the peak memory in bytes."""
    lines = "".join(json.dumps({"id": i, "r": r}) + "\n" for i, r in enumerate(equations))
    command = [program, "solve", "--batch", "-", "--timeout", str(timeout), *extra]
    ran = subprocess.run([sys.executable, "-c", MEASURE, *command], input=lines, capture_output=True, text=True)
    seconds, memory = json.loads(ran.stderr.splitlines()[-1])
    return [json.loads(line) for line in ran.stdout.splitlines()], seconds / len(equations), memory


def group_of(result):
    group = result.get("group")
    if not group:
        return result.get("error") or result.get("reason") or "undecided"
    return group["type"] + (f"_{group['n']}" if group.get("n") else "")


def ask(program, r, timeout):
    """Result, seconds without the start of the process."""
    results, first, _ = run(program, [r], timeout)
    if first > 1:
        return results[0], first
    count = max(2, min(200, int(0.3 / max(first, 0.0015))))
    results, many, _ = run(program, [r] * count, timeout)
    # the difference of two runs leaves the start out
    return results[0], max(1e-5, (many * count - first) / (count - 1))


def claims(result):
    """What the answer asserts, in the form of substitute.cpp."""
    for s in result.get("liouvillian") or []:
        if s["kind"] == "exponential":
            yield {"omega": s["omega"]}
        else:
            terms = [f"({c})*omega^{i}" for i, c in enumerate(s["minimal_polynomial"])]
            yield {"polynomial": "+".join(terms)}
