#!/usr/bin/env python3
"""usage: effect_instructions_test.py KOVACIC

What nothing drawn or watched depends on costs at most 2 % of the instructions of a section, counted by callgrind
(exit code 77 without valgrind: skipped).  For each return: a long run less a short one.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

H = "(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3"
STATES = [["1/5", "0", "3/10", "1/10"], ["0", "1/10", "2/5", "-1/10"], ["-1/10", "3/10", "1/4", "1/5"], ["1/7", "-1/5", "1/3", "0"]]


def scene(crossings, head="", extra="", h=H, also="", more="", beside=""):
    names = (["x", "y", "z"], ["u", "v", "w"]) if also else (["x", "y"], ["u", "v"])
    states = [s[:2] + ["0"] + s[2:] + ["0"] if also else s for s in STATES]
    body = f"section = 'x'\nplot = ['y', 'v']\nstates = {states}\ncrossings = {crossings}\n"
    other = f"[[scene]]\nname = 'other'\n{beside}{body}" if beside else ""
    return (f"[system]\nkind = 'hamiltonian'\ncoordinates = {names[0]}\nmomenta = {names[1]}\n{head}hamiltonian = '{h}'\n{extra}"
            f"[[scene]]\nname = 'drawn'\n{more}{body}{other}")


EFFECTS = {
    "plain": {},
    "roots that cancel": {"head": "parameters = ['a']\n", "h": H + " + a*x^4", "more": "set = {a = 'sqrt(2) - sqrt(2)'}\n"},
    "functions that nothing uses": {"extra": "[[system.function]]\nname = 's'\nmeans = 'sin(x)'\nderivative = {x = 'c'}\n"
                                             "[[system.function]]\nname = 'c'\nmeans = 'cos(x)'\nderivative = {x = '-s'}\n"},
    "a coordinate that nothing depends on": {"also": "z"},
    "exponents that another scene asks for": {"beside": "exponents = 'all'\n"},
    "winding that another scene asks for": {"beside": "winding = true\n"},
    "an indicator that another scene asks for": {"beside": "indicator = 'megno'\n"},
    "what is said not to be wanted": {"more": "winding = false\n"},
    "another integral to watch": {"extra": f"[[integral]]\nname = 'J'\nvalue = '({H})^2'\n"},
}


def instructions(program, directory, text):
    (directory / "scene.toml").write_text(text)
    log = directory / "log"
    subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={directory / 'calls'}", f"--log-file={log}",
                    program, "section", "scene.toml", "--scene", "drawn", "--pictures", "none", "-o", "out", "-q"],
                   cwd=directory, check=True, stdout=subprocess.DEVNULL)
    return int(re.search(r"Collected : (\d+)", log.read_text())[1])


def main():
    if shutil.which("valgrind") is None:
        print("no valgrind: instructions are not counted")
        return 77
    failed, program = 0, str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name)
        cost = {}

        def measure(effect):
            few, many = (instructions(program, directory, scene(crossings, **effect)) for crossings in (50, 200))
            return many - few

        for what, effect in EFFECTS.items():
            cost[what] = measure(effect)
            if cost[what] > 1.02 * cost["plain"]:  # what is told of the progress depends on the clock
                cost[what] = min(cost[what], measure(effect))
    for what, n in cost.items():
        ratio = n / cost["plain"]
        print(f"{ratio:.4f}  {what}")
        failed += ratio > 1.02
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
