"""One family of exceptions: everything that kovacic raises is a kovacic.Error, but Interrupted."""


import re


class Error(Exception):
    """Base of everything that this module raises.

    >>> issubclass(kovacic.InputError, kovacic.Error)
    True
    """


class InvalidArgument(Error, ValueError):
    """The caller broke a precondition.

    >>> try: kovacic.solve("z", r="z")
    ... except kovacic.InvalidArgument as wrong: print(wrong)
    two equations are given
    """


class WrongType(Error, TypeError):
    """A value that cannot be an exact one: a float, None, ...

    >>> try: kovacic.solve(0.5)
    ... except kovacic.WrongType as wrong: print(type(wrong).__mro__[2].__name__)
    TypeError
    """


class DomainError(Error, ArithmeticError):
    """Mathematically undefined: a division by the zero function.

    >>> issubclass(kovacic.DomainError, ArithmeticError)
    True
    """


class OutOfBudget(Error):
    """A limit was reached, and nothing is known.

    >>> issubclass(kovacic.OutOfBudget, kovacic.Error)
    True
    """


class FreeParameters(Error, ValueError):
    """Parameters without a value where one equation with numbers is needed.

    >>> try: kovacic.monodromy("z + a", variable="z")
    ... except kovacic.Error as wrong: print(isinstance(wrong, ValueError))
    True
    """


class InternalError(Error, RuntimeError):
    """A self-check failed: a mistake of the program, never a property of the input.

    >>> issubclass(kovacic.InternalError, RuntimeError)
    True
    """


class InputError(Error, ValueError):
    """A mistake in a formula or a file; str() shows the line with a caret below the mistake.

    >>> try: kovacic.solve("z^")
    ... except kovacic.InputError as wrong: print(wrong.column)
    3
    """

    def __init__(self, shown, file="", line=0, column=0, length=1, message="", hint="", source_line=""):
        key = re.match(r"\s*(\w+)\s*=", source_line) if file == "system" else None
        if key:  # of a System, whose file nobody wrote: the argument
            argument = {"hamiltonian": "H", "lagrangian": "L"}.get(key[1], key[1])
            shown = shown.replace(f"system:{line}:{column}", argument, 1)
        super().__init__(shown.rstrip("\n"))
        self._all = (shown, file, line, column, length, message, hint, source_line)
        self.file, self.line, self.column, self.length = file, line, column, length
        self.message, self.hint, self.source_line = message, hint, source_line

    def __reduce__(self):
        return InputError, self._all


class Interrupted(KeyboardInterrupt):
    """Ctrl-C; `answer` is what was known by then (undecided where it stopped), or None.

    >>> kovacic.Interrupted().answer is None
    True
    """

    def __init__(self, answer=None):
        super().__init__("stopped by Ctrl-C" if answer is None else "stopped by Ctrl-C; see .answer")
        self.answer = answer
