"""Answers as values: equal where they say the same, and pickled as their question.

A pickle is text that anybody can write, and no verdict comes out of one: an answer is asked for again where it is read.
Numbers for the eye (sections) are pickled as they are.
"""

import copy
import enum
import functools
import inspect
import weakref

from . import _core, _show
from ._errors import Error, WrongType

_FORMS = {"seconds", "stages", "trace", "certificate", "certificates", "second_opinion", "pruned"}  # not what is said
_questions = {}  # id: (weak reference, question)


def asked(function):
    """The answers of a function remember what was asked."""

    @functools.wraps(function)
    def asking(*args, **kwargs):
        answer = function(*args, **kwargs)
        question = (function.__name__, copy.copy(args), {k: copy.copy(v) for k, v in kwargs.items()})
        for place, one in enumerate(answer) if isinstance(answer, list) else [(None, answer)]:
            key = id(one)
            _questions[key] = (weakref.ref(one, lambda _, key=key: _questions.pop(key, None)), (*question, place))
        return answer

    return asking


def again(name, args, kwargs, place):
    import kovacic

    answer = getattr(kovacic, name)(*args, **kwargs)
    return answer if place is None else answer[place]


def _reduce(answer, _protocol):
    if id(answer) not in _questions:
        raise WrongType(f"a {type(answer).__name__} is a part of an answer: pickle the answer")
    name, args, kwargs, place = _questions[id(answer)][1]
    complete = getattr(answer, "complete", True) and getattr(answer, "undecided", None) is None
    return again, (name, args, {**kwargs, "timeout": None} if complete and name != "verify" else kwargs, place)


@functools.cache
def _properties(kind):
    return [n for n, p in inspect.getmembers(kind, lambda p: isinstance(p, property)) if n not in _FORMS]


def _same(a, b):
    if type(a) is not type(b):
        return False
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(_same, a, b))
    if isinstance(a, dict):
        return list(a) == list(b) and all(_same(a[k], b[k]) for k in a)
    if type(a) in _ANSWERS:
        return a is b or all(_same(_value(a, n), _value(b, n)) for n in _properties(type(a)))
    return a == b


def _value(answer, name):
    try:
        return getattr(answer, name)
    except Error as limit:
        return repr(limit)


def plain(x):
    """A value as JSON has it."""
    if x is None or isinstance(x, (bool, int, float, str)):
        return x
    if isinstance(x, enum.Enum):
        return x.name
    if isinstance(x, dict):
        return {str(key): plain(value) for key, value in x.items()}
    if isinstance(x, (list, tuple)):
        return [plain(value) for value in x]
    return to_dict(x) if type(x) in _ANSWERS else str(x)


def to_dict(self):
    """The answer as dicts, lists, texts and numbers, for json.dumps and the like.

        >>> kovacic.solve("u'' = t*u").to_dict()["solutions"]
        ['airyai(t)', 'airybi(t)']
    """
    return {n: plain(_value(self, n)) for n in _properties(type(self))}


def latex(self):
    r"""The answer as a paragraph of LaTeX.

        >>> print(kovacic.solve("u'' = t*u").latex().splitlines()[0])
        $u'' = t\, u$
    """
    parts = [_core.latex(self.equation) if hasattr(self, "equation") else ""]
    solutions = getattr(self, "solutions", None)
    if isinstance(solutions, list) and all(isinstance(s, str) for s in solutions):
        y = getattr(self, "unknown", "y")
        parts += [_core.latex(f"{y} = {s}") for s in solutions]
    parts += [_core.prose(getattr(self, n)) for n in ("headline", "statement", "conclusion") if isinstance(getattr(self, n, None), str)]
    return "\n".join(filter(None, parts)) or _core.prose(str(self))


def report(self, path):
    """Writes the answer as a page of HTML, or as an article in LaTeX where the name ends in .tex.

        >>> kovacic.solve("z").report("airy.html")                # doctest: +SKIP
    """
    if str(path).endswith(".tex"):
        text = self.tex() if hasattr(self, "tex") else (
            "\\documentclass{article}\n\\usepackage{amsmath,amssymb}\n\\begin{document}\n"
            + self.latex().replace("\n", "\n\n") + "\n\\end{document}\n")
    else:
        text = self.html() if hasattr(self, "html") else (
            f"<!DOCTYPE html><meta charset='utf-8'><title>{type(self).__name__}</title>{self._repr_html_()}\n")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _plain(kind):
    """A class of the library whose values are compared by nothing but their identity."""
    return isinstance(kind, type) and kind.__eq__ is object.__eq__ and bool(_properties(kind))


_ANSWERS = [kind for kind in vars(_core).values() if _plain(kind)]
for _kind in _ANSWERS:
    _kind.__eq__ = lambda self, other: _same(self, other) if type(self) is type(other) else NotImplemented
    _kind.__hash__ = lambda self: hash(repr(self))
    if _kind.__repr__ is object.__repr__:
        _kind.__repr__ = lambda self: f"<{type(self).__name__}>"
    _kind.__copy__ = lambda self: self
    _kind.__deepcopy__ = lambda self, _: self
    if not hasattr(_kind, "_repr_html_"):
        _kind._repr_html_ = lambda self: _show.values(to_dict(self))
    if "__setstate__" not in vars(_kind):
        _kind.__reduce_ex__ = _reduce
