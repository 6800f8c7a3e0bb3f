#!/usr/bin/env python3
"""The same theorem whatever else the machine does, and with four times the work nothing is taken back.

usage: busy_test.py PROGRAM [FILE...]

Each file is classified with a work limit that ends some of its searches: alone, on one core beside busy loops, and
with more work.  The first two answers are the same, but for the seconds; what is decided in the first is decided so
in the last.
"""

import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FILES = ["cases/classics/heavy_top_symmetric.toml", "cases/classify/henon_heiles.toml", "cases/classics/spring_pendulum.toml"]
WORK = 2e6  # of one search; the whole has a hundred times as much


def classified(program, path, work, flags=()):
    command = [program, "classify", str(path), "--max-work", str(work), "--timeout", "0", *flags]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def theorem(program, path, work):
    answer = json.loads(classified(program, path, work, ["--format", "json"]))
    assert answer["complete"], f"{path}: the clock ended it"
    del answer["seconds"]
    return answer


def units(program, path, work):
    return re.findall(r"spent +(\S+ units)", classified(program, path, work, ["--verbose"]))


def beside_busy_loops(task):
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(cores)})
    loops = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(2)]
    try:
        return task()
    finally:
        for loop in loops:
            loop.kill()
            loop.wait()
        os.sched_setaffinity(0, cores)


def decided(answer, status):
    return sum(s["status"] == status for s in answer["strata"])


def main():
    program, wrong = str(pathlib.Path(sys.argv[1]).resolve()), 0
    for name in sys.argv[2:] or FILES:
        path = ROOT / name
        alone = theorem(program, path, WORK)
        busy = beside_busy_loops(lambda p=path: theorem(program, p, WORK))
        if alone != busy:
            print(f"{name}: beside busy loops the answer is another one")
            wrong += 1
        if units(program, path, WORK) != beside_busy_loops(lambda p=path: units(program, p, WORK)):
            print(f"{name}: beside busy loops the work is another one")
            wrong += 1
        more = theorem(program, path, 4 * WORK)
        was_open, is_open = decided(alone, "open"), decided(more, "open")
        if alone["status"] != "open" and more["status"] != alone["status"] or (is_open and not was_open):
            print(f"{name}: with more work less is decided: {alone['statement']} / {more['statement']}")
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
