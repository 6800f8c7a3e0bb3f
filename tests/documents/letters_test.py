#!/usr/bin/env python3
"""No letter that the program brings in (n, p, F, x, r, y1, ...) is one that the question has.

usage: letters_test.py PROGRAM

Each equation is asked in letters that occur nowhere else, and in letters drawn from all that the program prints as
bound ones.  The two answers are then the same up to names: each name of the first stands for one of the second, and two
names never for one.  KOV_RANDOM_SEED and KOV_RANDOM_ROUNDS as in tests/support/random.hpp.
"""

import os
import random
import re
import subprocess
import sys

PROGRAM = sys.argv[1]
FORMATS = ["text", "json", "tex", "sympy", "maxima", "maple", "mathematica", "sage"]
# what a question can be called; a is an article, too
LETTERS = ["a", "b", "c", "f", "g", "h", "j", "k", "l", "m", "n", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z", "B",
           "C", "D", "F", "H", "K", "L", "M", "N", "O", "P", "Q", "R", "S", "T", "X", "Y", "nu", "mu", "g2", "g3", "y1", "y2", "P1", "Delta",
           "lambda", "y_factor", "Q_z", "n_1", "p_1", "x_1", "r_", "y_", "w_1"]
WORDS = ["equation", "factor", "operator", "print", "diff", "exp", "in", "Symbol"]  # of scripts, and of English
BOOKS = {"D", "J", "K", "M", "P", "Q", "U", "Y"}  # functions in books: besselk(n, x) stands for K_n(x) where K is a name
# {z}: the variable, {a} and {b}: parameters; one of each kind of sentence and solution
EQUATIONS = [
    ("-r", "3*{z}", ""), ("-r", "2*{z}^2 + 7", ""), ("-r", "4*{z}^2 - 3", ""), ("-r", "-(1+I)^2+(1/9-1/4)/{z}^2", ""),
    ("-r", "1/4 + 3/{z} - 2/(9*{z}^2)", ""), ("-r", "-1/({z}+1)^3", ""), ("-r", "2/{z} + 1/(3*{z}^2)", ""),
    ("-r", "{z}^3 + 1", ""), ("-r", "{z}^2 + 3", ""), ("-r", "(2*{z}^4-1)/{z}^2", ""),
    ("-r", "1/{z} - 3/(16*{z}^2)", ""), ("-r", "-3/(16*{z}^2) - 2/(9*({z}-1)^2) + 3/(16*{z}*({z}-1))", ""),
    ("-r", "-3/(16*{z}^2) - 2/(9*({z}-1)^2) + 3/(16*{z}*({z}-1))", "--polynomial"),
    ("-r", "-3/(16*{z}^2) - 2/(9*({z}-1)^2) + 5/({z}*({z}-1))", ""), ("-r", "-3/16/({z}^2+1)^2", ""),
    ("-r", "root({z}^3-2, 1.26)*sqrt(5)/{z}^2".replace("{z}^3", "e0^3"), ""),
    ("-e", "{z}^2*y0'' + {z}*y0' + ({z}^2 - 1/4)*y0 = 0", ""), ("-e", "{z}*y0'' + y0' + {z}*y0 = 0", ""),
    ("-e", "y0'' = (2/{z}^2+1)*y0", ""), ("-e", "4*({z}^3-{z})*y0''+2*(3*{z}^2-1)*y0'-(2*{z}+1)*y0 = 0", ""),
    ("-e", "(2*{z}-1)*y0'' + {z}*y0 = 0", ""),
    ("-r", "-3/(16*{z}^2)-2/(9*({z}-1)^2)+{a}/({z}*({z}-1))", "ab"), ("-r", "{a}*{z}^2 + {b}", "ab"), ("-r", "{a}*{z}", "ab"),
    ("-r", "{a} + {b}/{z} + 2/{z}^2", "ab"), ("-r", "{a}/{z}^2 + {b}", "ab"), ("-r", "({a}^2-1)/(4*{z}^2)", "ab"),
    ("-r", "({a}^2-1)/(4*{z}^2) + ({b}^2-1)/(4*({z}-1)^2) + (1-{a}^2-{b}^2+1/9)/(4*{z}*({z}-1))", "ab"),
    ("-e", "(4*{z}^3-1)*y0''+6*{z}^2*y0'-({a}*({a}+1)*{z}+{b})*y0 = 0", "ab"), ("-r", "{z}^3 + {a}*{z} + {b}", "ab"),
    ("-r", "{a}/({z}-{b})^3", "ab"), ("-e", "diff(y0({z}),{z},2) + {a}*{z}*y0({z}) = 0", "ab"),
]
BASE = {"z": "zqz", "a": "aqa", "b": "bqb"}


def asked(equation, names, output):
    option, text, kind = equation
    for letter, name in names.items():
        text = text.replace("{" + letter + "}", name)
    command = [PROGRAM, "solve", option, text, "--variable", names["z"], "--format", output]
    if kind == "ab":
        command += ["--parameter", names["a"], "--parameter", names["b"]]
        command += ["--verbose"] if output == "text" else []  # how strata are put together depends on the length of lines
    if kind == "--polynomial":
        command += ["--polynomial-of-y"]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", timeout=60)
    return done.returncode, done.stdout, " ".join(repr(x) for x in command)


def tokens(text):
    """Names, and what is between them without blanks; an article is not a name."""
    text = re.sub(r'"seconds": [^,\n]*|\n  time .*', "", text.replace("SL(2, C)", "SL2").replace("C(", "field("))
    text = re.sub(r"Symbol\('\w+'\)", "Symbol", text)  # shows the question's letter
    text = text.replace(" times this factor", "").replace("the given equation is ", "")  # a name can be these words
    text = re.sub(r"\n(#|/\*|\(\*) where .*", "", text.replace("\\_", "_"))  # conditions are in the letters of the question, too
    text = re.sub(r"\\mathrm\{(\w+)\}", r"\1", text)  # TeX's names of several letters
    text = re.sub(r"_\{(\w+)\}", r"_\1", text.replace("\\,", ""))
    if text.startswith("\\["):  # in a sentence of TeX a name that looks like a word is one: formulas are compared without their signs
        text = re.sub(r"\$|\\cdot", " ", text.replace("\\textsuperscript", "^").replace("\\sqrt", "sqrt"))
        text = text.replace("{", "(").replace("}", ")")
    found = []
    for match in re.finditer(r"(?<=[a-z])'s\b|\\?[A-Za-z_][A-Za-z0-9_]*|[0-9.]+|\S", text):
        word = match.group()
        article = word == "a" and re.match(r" *\n? *[a-z][a-z]", text[match.end():match.end() + 80]) and re.search(r"([a-z,:(] *|^\s*)$", text[:match.start()][-30:])
        found.append("ARTICLE" if article else word)
    return found


def complaint(base, other):
    first, second = tokens(base), tokens(other)
    if len(first) != len(second):
        return f"{len(first)} and {len(second)} words"
    to, back = {}, {}
    for one, two in zip(first, second):
        if re.match(r"[A-Za-z_\\]", one) is None:
            if one != two:
                return f"{one} became {two}"
        elif to.setdefault(one, two) != two:
            return f"{one} became {to[one]} and {two}"
        elif back.setdefault(two, one) != one:
            return f"{back[two]} and {one} both are {two}"
    return ""


def attack(seed, known):
    rng = random.Random(seed)
    equation = rng.choice(EQUATIONS)
    output = rng.choice(FORMATS)
    z, *parameters = rng.sample(LETTERS + (WORDS if FORMATS.index(output) > 2 else []), 3)
    names = dict(zip("zab", [z, *sorted(parameters)]))  # scripts name parameters in this order
    if BOOKS & set(names.values()):
        return False
    key = (EQUATIONS.index(equation), output)
    if key not in known:
        known[key] = asked(equation, BASE, output)
    code, text, command = asked(equation, names, output)
    wrong = complaint(known[key][1], text) if code == known[key][0] else f"exit {known[key][0]} became {code}"
    if wrong:
        print(f"{command}\n  {wrong}\n  (KOV_RANDOM_SEED={seed} KOV_RANDOM_ROUNDS=1)")
    return bool(wrong)


def main():
    first = int(os.environ.get("KOV_RANDOM_SEED") or 1)
    rounds = int(os.environ.get("KOV_RANDOM_ROUNDS") or 60)
    known = {}
    failures = sum(attack(seed, known) for seed in range(first, first + rounds))
    print(f"{rounds} rounds, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
