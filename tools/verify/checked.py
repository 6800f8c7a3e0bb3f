"""The steps that were accepted, for a reader: docs/theory/rules.toml has a row for each rule.  No judgement looks at them."""
from contextlib import contextmanager
from typing import NamedTuple

wanted, steps, files = False, [], []
said = {"uses": (), "limits": ""}           # of the statement: theorems of the literature, and of what it does not speak


class Step(NamedTuple):
    """key, rule: of the row; of: ids of the steps from which it follows; found: its data or its conclusion; inside: 1 in a
    certificate within the file"""
    form: str
    key: str
    rule: str
    id: str
    of: tuple
    found: str
    inside: int


@contextmanager
def file():
    """The steps are those of one file, which may be within another one."""
    files.append(None)
    try:
        yield
    finally:
        files.pop()


def add(form, key, rule, id="", of=(), found=""):
    if wanted:
        steps.append(Step(form, key, rule, id, tuple(of), found, len(files) - 1))


def label(form, names):
    for name in names.split():
        add(form, "label", name)


def start(is_wanted):
    global wanted
    wanted = is_wanted
    steps.clear()


def conclude(uses, limits):
    said.update(uses=uses, limits=limits)
