#!/usr/bin/env python3
"""Runs a transcript of the command line and compares.

usage: transcript.py PROGRAM TRANSCRIPT [--update]

A transcript is a list of blocks

    $ kovacic solve -r '2z'
    what standard output shows
    ! what standard error shows, every line marked
    = exit code (left out when it is 0)

Lines before the first "$" and lines that begin with "# " between blocks are comments.  Commands run
in bash, in a fresh copy of the directory files/ beside the transcript; times are replaced by <time>.
With --update the transcript is rewritten with what came out.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def blocks(text):
    """Comments and blocks in order: ('#', lines) or ('$', command, expected lines).

    A comment stands at the top or after an empty line; a # inside an answer belongs to the answer.
    """
    parts, current, before = [], None, ""
    for line, before in zip(text.splitlines(), [""] + text.splitlines()):
        if line.startswith("$ "):
            current = ("$", line[2:], [])
            parts.append(current)
        elif current is None or ((line.startswith("# ") or line == "#") and before == ""):
            if not parts or parts[-1][0] != "#":
                parts.append(("#", "", []))
            parts[-1][2].append(line)
            current = None if line.startswith("#") else current
        else:
            current[2].append(line)
    return parts


def run(command, program, directory):
    environment = dict(os.environ, PATH=f"{directory}/bin:{os.environ['PATH']}", TERM="dumb")
    environment.pop("NO_COLOR", None)
    done = subprocess.run(["bash", "-c", command], cwd=f"{directory}/files", env=environment,
                          stdin=subprocess.DEVNULL, capture_output=True, timeout=100)
    out = done.stdout.decode("utf-8", "replace").splitlines()
    err = ["! " + line for line in done.stderr.decode("utf-8", "replace").splitlines()]
    lines = [normalised(line) for line in out + err]
    return lines + ([f"= {done.returncode}"] if done.returncode != 0 else [])


def normalised(line):
    line = re.sub(r'"seconds": ?[-+.e0-9]+', '"seconds": <time>', line)
    line = re.sub(r'"seconds":[-+.e0-9]+', '"seconds":<time>', line)
    line = re.sub(r'"work": [-+.e0-9]+', '"work": <work>', line)
    line = re.sub(r"^(  time +)[.0-9]+ ms", r"\1<time>", line)
    return line.rstrip()


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    transcript = pathlib.Path(sys.argv[2]).resolve()
    update = "--update" in sys.argv
    failed, rewritten = 0, []
    with tempfile.TemporaryDirectory() as directory:
        os.mkdir(f"{directory}/bin")
        os.symlink(program, f"{directory}/bin/kovacic")
        shutil.copytree(transcript.parent / "files", f"{directory}/files")
        for kind, command, expected in blocks(transcript.read_text()):
            if kind == "#":
                rewritten += expected
                continue
            while expected and expected[-1] == "":
                expected.pop()
            found = run(command, program, directory)
            while found and found[-1] == "":
                found.pop()
            rewritten += ["$ " + command, *found, ""]
            if found != expected and not update:
                failed += 1
                print(f"$ {command}\n--- expected\n" + "\n".join(expected) +
                      "\n--- found\n" + "\n".join(found) + "\n")
    if update:
        while rewritten and rewritten[-1] == "":
            rewritten.pop()
        transcript.write_text("\n".join(rewritten) + "\n")
    print(f"{transcript.name}: {'updated' if update else f'{failed} differences'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
