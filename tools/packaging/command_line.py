"""The command line of kovacic as it describes itself: its --help, read.

    Program("kovacic").commands[0].options[1].shown     '-r R(z)'

The manual page and the completions are made from this, so that they cannot say anything else.
"""

import re
import subprocess
from dataclasses import dataclass, field

LINE = re.compile(r"^  (\S.*?)(?:  +(\S.*))?$")


@dataclass
class Option:
    shown: str  # -o,--output FILE
    meaning: str

    @property
    def names(self):
        return self.shown.split(" ")[0].split(",")

    @property
    def value(self):
        """FILE, or "" for a flag."""
        words = self.shown.replace(" REQUIRED", "").replace(" ...", "").split(" ")
        return words[1] if len(words) > 1 else ""

    @property
    def choices(self):
        """The words that it takes, where it takes one of a list: "auto, always or never"."""
        return self.value.split("|") if "|" in self.value and self.value.islower() or self.value == "1|2|3" \
            else listed(self.meaning)

    @property
    def common(self):
        return self.names[-1] in ("--help", "--output", "--color")


@dataclass
class Command:
    name: str
    summary: str
    usage: str = ""
    positionals: list = field(default_factory=list)
    options: list = field(default_factory=list)


class Program:
    def __init__(self, path):
        self.path = path
        text = said(path, "--help")
        head, rest = text.split("\nUsage:", 1)
        self.description = head.strip("\n").split("\n")
        self.exit_codes = " ".join(rest[rest.index("Exit codes: ") + len("Exit codes: "):].split())
        self.version = re.search(r"kovacic (\S+)", said(path, "--version")).group(1)
        names = section(rest, "Subcommands")
        self.commands = [self.command(name, summary) for name, summary in names]

    def command(self, name, summary):
        text = said(self.path, name, "--help")
        usage = re.search(r"^Usage: (.*)$", text, re.M).group(1)
        options = [Option(*pair) for pair in section(text, "Options")]
        return Command(name, summary, usage, section(text, "Positionals"), options)


def said(path, *arguments):
    return subprocess.run([path, *arguments], check=True, capture_output=True, text=True, timeout=60).stdout


def section(text, title):
    """The pairs below "title:"; a line that is indented further continues the one before it."""
    pairs = []
    lines = text.split("\n")
    for line in lines[lines.index(title + ":") + 1:] if title + ":" in lines else []:
        if not line.startswith("  "):
            break
        if line.startswith("   "):
            pairs[-1][1] = (pairs[-1][1] + " " + line.strip()).strip()
            continue
        shown, meaning = LINE.match(line).groups()
        pairs.append([shown, meaning or ""])
    return [tuple(pair) for pair in pairs]


def listed(meaning):
    """['text', 'json', 'tex'] of "text, json or tex ..."; [] of another sentence."""
    plain = re.sub(r" \([^)]*\)", "", meaning)
    found = re.match(r"(?:with --\w+: )?((?:[\w-]+, )*[\w-]+,? or [\w-]+)(?:$|[ ,;])", plain)
    return re.split(r", or | or |, ", found.group(1)) if found else []
