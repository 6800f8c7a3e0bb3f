#!/usr/bin/python3
"""The manual pages, from what exists: nothing is written twice.

usage: manual.py PROGRAM DIRECTORY

    kovacic(1)               the --help of the program and of each of its commands
    kovacic-system(5)        docs/guide/system-files.md
    kovacic-certificate(5)   docs/theory/certificates.md, strata_certificates.md, system_certificates.md, theorem_certificates.md
"""

import os
import pathlib
import re
import sys
import time

from command_line import Program
from docutils import nodes
from docutils.core import publish_string
from docutils.transforms import Transform
from docutils.writers import manpage
from myst_parser.parsers.docutils_ import Parser

ROOT = pathlib.Path(__file__).resolve().parents[2]
SEE_ALSO = "kovacic(1), kovacic-system(5), kovacic-certificate(5); the guide is in /usr/share/doc/kovacic-doc"


class RowsAsTerms(Transform):
    """A table of two columns is a list of terms: a terminal is narrow.  Links lose their target."""

    default_priority = 900

    def apply(self):
        for table in list(self.document.findall(nodes.table)):
            rows = [[entry.children for entry in row.children] for row in table.findall(nodes.row)]
            if rows and all(len(row) == 2 for row in rows):
                table.replace_self(nodes.definition_list("", *(self.term(*row) for row in rows[1:])))
        for link in list(self.document.findall(nodes.reference)):
            link.replace_self(link.children)

    @staticmethod
    def term(name, meaning):
        words = [child for paragraph in name for child in paragraph.children]
        return nodes.definition_list_item("", nodes.term("", "", *words), nodes.definition("", *meaning))


class PageParser(Parser):
    def get_transforms(self):
        return [*super().get_transforms(), RowsAsTerms]


class Translator(manpage.Translator):
    def visit_raw(self, node):  # comments in HTML
        raise nodes.SkipNode


class Writer(manpage.Writer):
    def __init__(self):
        super().__init__()
        self.translator_class = Translator


def page(name, section, summary, text):
    """The sections of a text in Markdown as a page in roff."""
    source = f"# {name}\n\n{text}\n\n## SEE ALSO\n\n{SEE_ALSO}\n"
    roff = publish_string(source, parser=PageParser(), writer=Writer(),
                          settings_overrides={"report_level": 4, "_disable_config": True}).decode()
    macros = roff[roff.index(".nr rst2man-indent-level"):]
    body = macros[macros.index("\n.SH ", macros.index("\n.SH NAME") + 1):]
    head = f'.TH "{name.upper()}" "{section}" "{day()}" "kovacic {VERSION}" "kovacic"\n'
    return f"'\\\" t\n{head}{macros[:macros.index('.TH') if '.TH' in macros else macros.index('.SH NAME')]}" \
           f".SH NAME\n{name} \\- {summary}{body}"


def day():
    """The day of SOURCE_DATE_EPOCH, so that the same source gives the same page."""
    return time.strftime("%Y-%m-%d", time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", time.time()))))


def literal(text):
    return text.replace("\\", "\\\\").replace("*", "\\*").replace("_", "\\_").replace("<", "\\<").replace("`", "\\`")


def terms(pairs):
    """Options, commands: a table of two columns, which becomes a list of terms."""
    if not pairs:
        return ""
    rows = "".join(f"| {cell(name)} | {cell(meaning)} |\n" for name, meaning in pairs)
    return f"\n| | |\n|---|---|\n{rows}\n"


def cell(text):
    return literal(text).replace("|", "\\|")


def commands_page(program):
    """kovacic(1)."""
    text = "## SYNOPSIS\n\n**kovacic** *COMMAND* [*OPTIONS*] [*FILE*...]\n\n## DESCRIPTION\n\n"
    text += "\n".join(f"    {line.strip()}" if line.startswith("  ") else f"\n{literal(line)}\n"
                      for line in program.description)
    text += "\n\n## COMMANDS\n" + terms([(c.name, c.summary) for c in program.commands])
    for command in program.commands:
        text += f"\n## {command.name.upper()}\n\n{literal(command.usage)}\n\n{literal(command.summary)}\n"
        text += terms(command.positionals) + terms([(o.shown, o.meaning) for o in command.options if not o.common])
    common = {o.shown: o.meaning for c in program.commands for o in c.options if o.common}
    text += "\n## OPTIONS OF ALL COMMANDS\n" + terms(sorted(common.items()))
    return text + f"\n## EXIT STATUS\n\n{literal(program.exit_codes)}\n"


WORDS_OF_TEX = {"le": "<=", "ge": ">=", "ne": "!=", "to": "->", "mapsto": "->", "pm": "+-", "cdot": "*", "times": "x", "infty": "infinity",
                "in": "in", "dots": "...", "Rightarrow": "=>", "mid": "|", "quad": " ", "qquad": "  "}


def plain_formula(tex):
    """A formula of the pages as one types it."""
    tex = re.sub(r"\\(?:operatorname|mathrm|mathbb)\{([^{}]*)\}", r"\1", tex)
    tex = re.sub(r"\\tfrac(\d)(\d) ?", r"\1/\2 ", tex)
    tex = re.sub(r"([_^])\{(\w+)\}", r"\1\2", tex)
    tex = re.sub(r"([_^])\{([^{}]*)\}", r"\1(\2)", tex)
    tex = re.sub(r"\\sqrt\{([^{}]*)\}", r"sqrt(\1)", tex)
    tex = re.sub(r"\\([A-Za-z]+) ?", lambda word: WORDS_OF_TEX.get(word.group(1), word.group(1)) + " ", tex)
    return re.sub(r" +(?=[,;)]|$)", "", re.sub(r"\\([{}|])", r"\1", tex)).replace("  ", " ").strip()


def without_title(path):
    """A page for a terminal: without the box of the site, formulas as text."""
    title, text = (ROOT / path).read_text(encoding="utf-8").split("\n", 1)
    text = re.sub(r"^:::.*\n", "", text, flags=re.M)
    parts = re.split(r"(^```.*?^```|`[^`\n]*`)", text, flags=re.M | re.S)  # code stays
    formula = re.compile(r"\$\$?([^$]+)\$\$?")
    text = "".join(part if i % 2 else formula.sub(lambda found: literal(plain_formula(found.group(1))), part)
                   for i, part in enumerate(parts))
    return f"## {title.lstrip('# ') if 'certificates' in path else 'DESCRIPTION'}\n{text}"


def main():
    global VERSION
    program, directory = Program(sys.argv[1]), pathlib.Path(sys.argv[2])
    VERSION = program.version
    pages = {
        ("kovacic", 1): ("differential Galois groups and non-integrability proofs, exactly", commands_page(program)),
        ("kovacic-system", 5): ("files that describe a mechanical system to kovacic",
                                without_title("docs/guide/system-files.md")),
        ("kovacic-certificate", 5): ("proofs that kovacic writes and checks",
                                     "\n".join(without_title(f"docs/theory/{name}certificates.md")
                                               for name in ("", "strata_", "system_")))}
    for (name, section), (summary, text) in pages.items():
        folder = directory / f"man{section}"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / f"{name}.{section}").write_text(page(name, section, summary, text), encoding="utf-8")


VERSION = ""
if __name__ == "__main__":
    main()
