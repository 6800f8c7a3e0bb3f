#!/usr/bin/env python3
"""The examples of the pages are what the program does.

usage: examples_test.py PROGRAM [PAGE...]
       examples_test.py PROGRAM --write PAGE...      puts what the commands print below them (read what changes)

In a block of a page, `$ command` is run (in bash, in a directory of the page where cases/ and tests/ are) and compared with
the lines below it, where "..." stands for any text; nothing below it asks only that the command understood its input.
--write leaves a command alone whose lines have "..." in them and are right.
A command without `$` is not run (it may take hours, or need files that only the reader has), but its sub-command and its
flags have to exist.
"""

import contextlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/packaging"))
sys.dont_write_bytecode = True
from command_line import Program  # noqa: E402

COMMANDS = ("kovacic", "tools/run", "kovacic_verify.py", "export_certificate.py")


def blocks(text):
    """The fenced blocks without a language, or of the shell."""
    return [body for language, body in re.findall(r"^```([^\n]*)\n(.*?)^```", text, re.M | re.S) if language in ("", "sh", "console")]


def examples(block):
    """(command, expected lines) of what is run."""
    found = []
    for line in block.split("\n"):
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found:
            found[-1][1].append(line)
    for command, expected in found:
        while expected and not expected[-1].strip():
            expected.pop()
    return [x for x in found if x[0].split()[0] in COMMANDS and "FILE" not in x[0]]


def matches(expected, said):
    """The same words; where lines break depends on their length."""
    pattern = "(?s:.*?)".join(re.escape(" ".join(part.split())) for part in " ".join(expected).split("..."))
    return re.fullmatch(pattern.replace(r"(?s:.*?)", r" ?(?s:.*?) ?"), " ".join(said.split())) is not None


@contextlib.contextmanager
def place_of_a_page():
    with tempfile.TemporaryDirectory() as directory:
        for name in ("cases", "tests"):
            os.symlink(ROOT / name, f"{directory}/{name}")
        yield directory


def run(command, directory):
    command = re.sub("^tools/run ", "kovacic ", command)
    script = (f'kovacic() {{ "{PROGRAM}" "$@"; }}; kovacic_verify.py() {{ "{ROOT}/tools/verify/kovacic_verify.py" "$@"; }}; '
              f'export_certificate.py() {{ "{ROOT}/tools/export_certificate.py" "$@"; }}; {command}')
    return subprocess.run(["bash", "-c", script], cwd=directory, capture_output=True, encoding="utf-8", timeout=300)


def written(block, directory):
    """The block with what its commands print now."""
    text = block
    for command, expected in examples(block):
        said = re.sub(r"(?m)^ +time +[\d.]+ m?s$", "...", run(command, directory).stdout.rstrip("\n"))
        if not (expected and "..." in " ".join(expected) and matches(expected, said)):
            old = "\n".join([f"$ {command}", *expected])
            text = text.replace(old, f"$ {command}\n{said}", 1)
    return text


def write(page):
    text = page.read_text(encoding="utf-8")
    with place_of_a_page() as directory:
        for block in blocks(text):
            text = text.replace(f"\n{block}```", f"\n{written(block, directory)}```", 1)
    page.write_text(text, encoding="utf-8")


class Examples(unittest.TestCase):
    def test_what_is_run(self):
        for page in pages():
            with place_of_a_page() as directory:
                for block in blocks(page.read_text(encoding="utf-8")):
                    for command, expected in examples(block):
                        with self.subTest(page=page.name, command=command):
                            self.compare(command, expected, directory)

    def compare(self, command, expected, directory):
        done = run(command, directory)
        self.assertIn(done.returncode, (0, 1, 3, 10, 20), done.stderr)
        if expected:
            self.assertTrue(matches(expected, done.stdout), f"{command}\n{done.stdout}\nand the page says\n" + "\n".join(expected))

    def test_what_is_named(self):
        commands = {command.name: command for command in Program(PROGRAM).commands}
        count = 0
        for page in pages():
            for block in blocks(page.read_text(encoding="utf-8")):
                for line in re.findall(r"^(?:kovacic|tools/run) (\S.*)$", block.replace("\\\n", " "), re.M):
                    words = re.sub(r"\s+#.*", "", re.sub(r"'[^']*'|\"[^\"]*\"", "X", line)).split()
                    if not re.fullmatch("[a-z-]+", words[0]):
                        continue
                    with self.subTest(page=page.name, line=line):
                        count += 1
                        self.assertIn(words[0], commands)
                        known = {name for option in commands[words[0]].options for name in option.names}
                        for word in words[1:]:
                            if re.match("--?[a-zA-Z]", word):
                                self.assertIn(word.split("=")[0], known)
        self.assertGreaterEqual(count, 0 if PAGES else 20)


def pages():
    return [pathlib.Path(page) for page in PAGES] or [ROOT / "README.md", *sorted(ROOT.glob("docs/*.md")), *sorted(ROOT.glob("docs/guide/*.md")),
                                                       *sorted(ROOT.glob("docs/theory/*.md"))]


PROGRAM, PAGES = str(pathlib.Path(sys.argv[1]).resolve()), [x for x in sys.argv[2:] if x != "--write"]
if __name__ == "__main__":
    if "--write" in sys.argv:
        for page in pages():
            write(page)
    else:
        unittest.main(argv=sys.argv[:1])
