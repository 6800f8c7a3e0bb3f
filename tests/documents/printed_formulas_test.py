#!/usr/bin/env python3
"""Every printed solution, read back as it stands, solves the equation: in text, JSON and the scripts for other programs.

usage: printed_formulas_test.py PROGRAM

Random equations over number fields with solutions of every kind: exponentials, radicals, and functions with a name.  What
is printed is evaluated with 40 digits at random points; derivatives are differences.  KOV_RANDOM_SEED and
KOV_RANDOM_ROUNDS as in tests/support/random.hpp.
"""

import json
import os
import random
import re
import subprocess
import sys

try:
    import mpmath
    from mpmath import mp, mpc, mpf
except ImportError:
    print("left out: needs mpmath")
    sys.exit(0)

PROGRAM = sys.argv[1]
mp.dps = 60
SCRIPTS = ["sympy", "maxima", "maple", "mathematica", "sage"]
NUMBERS = ["1", "-1", "2", "-3", "1/2", "-2/3", "I", "2*I", "(1+I)", "(2-I)/3", "sqrt(2)", "(1+sqrt(2))", "-sqrt(3)/2", "(sqrt(2)+I)",
           "root(e0^3-2, 1.26)", "(root(e0^3-2, 1.26)-1)", "sqrt(-5)"]
LETTERS = ["z", "x", "t", "r", "y", "n", "c", "F", "k", "m", "w", "u", "E", "N", "S", "Q", "D", "C", "K", "O", "lambda", "y1", "s"]


# ---- a formula of ours, or of a script, as a number

def root(p, at):
    return mpmath.findroot(p, mpmath.mpmathify(at), tol=1e-100, maxsteps=200)


FUNCTIONS = {"sqrt": mpmath.sqrt, "exp": mpmath.exp, "log": mpmath.log, "erf": mpmath.erf, "erfi": mpmath.erfi, "Ei": mpmath.ei, "expintegral_ei": mpmath.ei,
             "I": mpc(0, 1), "pi": mp.pi, "Pi": mp.pi, "Integer": mpf, "root": root, "Sqrt": mpmath.sqrt, "Exp": mpmath.exp, "Log": mpmath.log,
             "Erf": mpmath.erf, "Erfi": mpmath.erfi, "ExpIntegralEi": mpmath.ei,
             **{name: getattr(mpmath, name) for name in ("sin", "cos", "besselj", "bessely", "besseli", "besselk", "airyai", "airybi", "hyp1f1",
                                                          "hyperu", "hyp2f1", "legenp", "legenq", "pcfd")},
             "airyaiprime": lambda x: mpmath.airyai(x, derivative=1), "airybiprime": lambda x: mpmath.airybi(x, derivative=1)}


def with_roots(text):
    """The name inside root(p, at), RootOf(p, x, at) is bound there."""
    text = re.sub(r"\broot\(([^,()]*(?:\([^()]*\)[^,()]*)*),", lambda m: f"root(lambda {bound(m.group(1))}: {m.group(1)},", text)
    return re.sub(r"\bRootOf\(([^,]*), (\w+),", r"root(lambda \2: \1,", text)


def bound(polynomial):
    return next(iter(set(re.findall(r"[A-Za-z_]\w*", polynomial)) - {"I"}))


def numbers(text):
    """Integers are exact quotients in our formulas: 1/3 must not be a float."""
    return re.sub(r"(?<![\w.])(\d+(?:\.\d+)?)(?![\w.])", r"mpf('\1')", text)


def evaluate(text, names):
    text = numbers(with_roots(text.replace("^", "**").replace("%i", "I").replace("%", "")))
    text = re.sub(r"\blambda_?\b(?! \w+:)", "lambda_", text)
    return mpc(eval(text, {**FUNCTIONS, "mpf": mpf, **{"lambda_" if n == "lambda" else n: v for n, v in names.items()}}))  # noqa: S307


def second_derivative(f, at):
    """From values on a small circle."""
    step, n = mpf("1e-4"), 16
    values = [(mpmath.expjpi(mpf(2 * k) / n), f(at + step * mpmath.expjpi(mpf(2 * k) / n))) for k in range(n)]
    return 2 * sum(v / w**2 for w, v in values) / n / step**2


def solves(y, r, rng):
    """Is y'' = r y near a random point?"""
    at = mpc(rng.uniform(1.1, 1.9), rng.uniform(0.2, 0.7))
    left, right = second_derivative(y, at), r(at) * y(at)
    return abs(left - right) <= mpf("1e-15") * (abs(left) + abs(right) + abs(y(at)))


# ---- equations

def some_equation(rng):
    a, b, c = (rng.choice(NUMBERS) for _ in range(3))
    kinds = ["({a})^2", "({a})^2*{z}^2 + ({a})*(1+2*{n})", "(({a})^2-1)/(4*{z}^2)", "(({a})^2-1/4)/({z}-({b}))^2",  # exponentials
             "({a})^2 + {n}*({n}+1)/{z}^2", "({a})/{z} - 3/(16*{z}^2)", "-3/(16*({z}-({b}))^2)",
             "({a})*{z} + ({b})", "({a})/({z}-1)^5",  # Airy, Bessel, Whittaker, hypergeometric
             "-({a})^2 + (1/9-1/4)/{z}^2", "({a})+(({b})^2-1/4)/{z}^2", "({a})/{z} + ({b})/{z}^2", "({a}) + ({b})/{z} + 3/{z}^2", "({a})^2*{z}^2+({b})",
             "-3/(16*{z}^2)-2/(9*({z}-1)^2)+({a})/({z}*({z}-1))", "9*({a})*{z}^4 - 5/(36*{z}^2)*0 + 2*({a})^2*{z}"]
    names = dict(a=a, b=b, c=c, z=rng.choice(LETTERS), n=rng.randrange(3))
    return rng.choice(kinds).format(**names), names["z"]


def run(r, z, output, *more):
    command = [PROGRAM, "solve", "-r", r, "--variable", z, "--format", output, *more]
    return subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60).stdout


def constants(result):
    return {name: evaluate(meaning, {}) for name, meaning in result.get("constants", {}).items() if re.fullmatch(r"[A-Za-z_]\w*", name) and name != "I"}


# ---- what is printed

def of_json(r, z, rng):
    result = json.loads(run(r, z, "json"))
    if not result.get("r") or "z - " in z:
        return
    given = result["variable"] if re.fullmatch(r"\w+", result["variable"] or "") else None
    if given is None:
        return
    known = constants(result)

    def function(text):
        return lambda at: evaluate(text, {**known, given: at})

    right = function(result["r"])
    moved = function(r)
    at = mpc("1.3", "0.4")
    if abs(right(at) - moved(at)) > 1e-20 * (1 + abs(right(at))):
        yield "r", f"{result['r']} is another function"
    texts = [s["y"] for s in result.get("liouvillian") or [] if "y" in s] + (result.get("basis") or [])
    for text in texts:
        if "int(" not in text and not solves(function(text), right, rng):
            yield "solution", text
    for text in result.get("solutions") or []:  # of the given equation, in its variable
        y = lambda at, text=text: evaluate(text, {**known, z: at})  # noqa: E731
        if "int(" not in text and not solves(y, moved, rng):
            yield "solution of the given equation", text


def assignments(script, program):
    """name -> formula, as the program would read it."""
    pattern = {"maxima": r"^(\w+) : (.*)\$$", "maple": r"^(\w+) := (.*):$", "mathematica": r"^(\w+) = (.*);$"}.get(program, r"^(\w+) = (.*)$")
    for name, formula in re.findall(pattern, script, re.M):
        if not re.search(r"Symbol\(|var\(|unction\(|Eq\(|==|diff\(|Ore|D\[|''", formula):
            yield name, formula.replace("[", "(").replace("]", ")") if program == "mathematica" else formula


def of_script(r, z, program, rng):
    script = run(r, z, program)
    if any(word in script for word in ("ntegra", "int(", "all_roots", "QQbar", "Solve", "solve(")):
        return
    formulas, values = dict(assignments(script, program)), {}
    own = next((n for n in ("r", "r_", "r0") if n in formulas), None)
    if own is None:
        yield program, "no r in the script"
        return
    names = {"".join(c for c in z if c != "_")} | {z, z + "_", z + "0"}

    def function(text):
        return lambda at: evaluate(text, {**values, **{n: at for n in names}})

    for name, formula in formulas.items():
        if name not in (own,) and not re.match(r"^(y\d|P\d|y_|Q|factor)", name) and name not in names:
            values[name] = evaluate(formula, values)
    right, given = function(formulas[own]), function(formulas[own])
    at = mpc("1.3", "0.4")
    if abs(right(at) - evaluate(r, {z: at})) > 1e-20 * (1 + abs(right(at))):
        yield program, f"r = {formulas[own]} is another function"
    for name, formula in formulas.items():
        if re.match(r"^y[12](_|0)*$", name) and name not in names and not solves(function(formula), given, rng):
            yield program, f"{name} = {formula}"


def attack(seed):
    rng = random.Random(seed)
    r, z = some_equation(rng)
    try:
        wrong = list(of_json(r, z, rng)) if rng.randrange(2) else list(of_script(r, z, rng.choice(SCRIPTS), rng))
    except (NameError, SyntaxError, TypeError, ValueError, ZeroDivisionError, AttributeError) as unread:
        wrong = [("not read", f"{type(unread).__name__}: {unread}")]
    for what, text in wrong:
        print(f"solve -r '{r}' --variable {z}: {what}: {text}\n  (KOV_RANDOM_SEED={seed} KOV_RANDOM_ROUNDS=1)")
    return bool(wrong)


def main():
    first = int(os.environ.get("KOV_RANDOM_SEED") or 1)
    rounds = int(os.environ.get("KOV_RANDOM_ROUNDS") or 40)
    failures = sum(attack(seed) for seed in range(first, first + rounds))
    print(f"{rounds} rounds, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
