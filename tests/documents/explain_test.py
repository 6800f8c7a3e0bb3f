#!/usr/bin/env python3
"""`kovacic explain` knows every term of an answer.

usage: explain_test.py PROGRAM

The answers are those of the transcripts in tests/cli.  A word of six letters or more is known to `explain`, or it stands
in ordinary_words.txt as a word of everyday English (or of every mathematics).  A new word of an answer is entered there,
or, if a reader of the answer may ask what it means, in tools/kovacic/texts/topics.txt.
"""

import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
PROGRAM = sys.argv[1]
# what readers asked for, in the form in which answers have it, and short words
ASKED = ["NVE", "VE_3", "meromorphic", "Morales-Ramis", "Morales-Ruiz, Ramis and Simo", "Kimura", "stratum", "strata", "level",
         "Casimir functions", "identity component", "Liouvillian", "LIOUVILLIAN", "resonance", "monodromy", "symplectic leaf",
         "Zariski", "first integrals", "first_integral", "Bessel's", "T_4", "SL(2, C)", "Gm", "Dinf", "place", "poles", "radius",
         "torus", "loops", "NO OBSTRUCTION", "NON-INTEGRABLE", "DEPENDS ON THE PARAMETERS", "UNDECIDED", "trusted", "Sym^4"]
NONSENSE = ["flibbertigibbet", "zzz", "q2"]


def known(word):
    done = subprocess.run([PROGRAM, "explain", *word.split()], capture_output=True, encoding="utf-8", timeout=20)
    return done.returncode == 0 and len(done.stdout.splitlines()) > 2


def words_of_answers():
    found = {}
    for transcript in sorted((HERE.parent / "cli").glob("*.txt")):
        for number, line in enumerate(transcript.read_text().splitlines(), 1):
            if line.startswith(("$", "#", "= ", "! ")):  # commands and comments; errors speak of what was typed
                continue
            for word in re.findall(r"(?<![\w/.\\-])[A-Za-z]+(?:-[A-Za-z]+)*(?![\w/]|\.\w)", line):
                found.setdefault(word.lower(), f"{transcript.name}:{number}")
    return {word: where for word, where in found.items() if len(word) > 5}


def main():
    ordinary = set((HERE / "ordinary_words.txt").read_text().split())
    unknown = [f"{where}: {word}" for word, where in sorted(words_of_answers().items())
               if word not in ordinary and not known(word)]
    unknown += [f"asked for: {word}" for word in ASKED if not known(word)]
    unknown += [f"explained, and nonsense: {word}" for word in NONSENSE if known(word)]
    print("\n".join(unknown), f"{len(unknown)} words are neither explained nor ordinary", sep="\n")
    return 1 if unknown else 0


if __name__ == "__main__":
    sys.exit(main())
