"""Values as the text of a formula, and formulas as SymPy expressions.

int, Fraction, str and SymPy expressions are exact and go in; float is not, and is refused.
"""

import functools
import numbers
import re
import sys
from fractions import Fraction

from . import _core
from ._errors import InvalidArgument, OutOfBudget, WrongType

NAME = re.compile(r"[A-Za-z_]\w*\Z", re.ASCII)


def is_sympy(x):
    sympy = sys.modules.get("sympy")
    return sympy is not None and isinstance(x, sympy.Basic)


def formula(x, what="the formula"):
    """The text of a value in the program's grammar."""
    if isinstance(x, str):
        return plain(x, what)
    if isinstance(x, numbers.Rational) and not isinstance(x, bool):
        n, d = _core.decimal(int(x.numerator)), _core.decimal(int(x.denominator))
        return n if d == "1" else f"{n}/{d}"
    if isinstance(x, (_core.RationalFunction, _core.AlgebraicNumber)) and x.generator is not None:
        raise InvalidArgument(f"{what}: {x} is written with a number {x.generator[0]} that a text does not tell; write "
                              "the constants as sqrt(...) or root(p(x), approx), and give them with set")
    if isinstance(x, (_core.RationalFunction, _core.MFraction, _core.AlgebraicNumber)):
        return str(x)
    if is_sympy(x):
        return from_sympy(x)
    if isinstance(x, numbers.Number) and not isinstance(x, bool):
        raise WrongType(f"{what}: {x!r} is not exact; write Fraction(1, 2), \"1/2\" or a SymPy Rational")
    raise WrongType(f"{what}: an int, Fraction, str or SymPy expression is expected, and not {x!r}")


def plain(text, what):
    """A text that has bytes: half a surrogate pair has none."""
    try:
        text.encode()
    except UnicodeEncodeError as wrong:
        raise InvalidArgument(f"{what}: {wrong}") from None
    return text


def name(x, what="a name"):
    """A str or a SymPy Symbol that formulas can use."""
    text = x if isinstance(x, str) else symbol_name(x) if is_sympy(x) and x.is_Symbol else None
    if text is None:
        raise WrongType(f"{what}: a str or a SymPy Symbol is expected, and not {x!r}")
    if not NAME.match(text):
        raise InvalidArgument(f"{what}: {text!r} is not a name (a letter, then letters, digits and _)")
    return text


def names(x, what):
    """"a b", "a, b", ["a", Symbol("b")], Symbol("a")"""
    if x is None:
        return []
    if isinstance(x, str):
        return [name(part, what) for part in re.split(r"[\s,]+", x.strip()) if part]
    if is_sympy(x) and x.is_Symbol:
        return [name(x, what)]
    try:
        return [name(part, what) for part in x]
    except TypeError as wrong:
        if isinstance(wrong, WrongType):
            raise
        raise WrongType(f"{what}: names are expected, and not {x!r}") from None


def values(x, what="set"):
    """{"a": 1, Symbol("b"): Fraction(1, 2)} as pairs of texts."""
    if x is None:
        return []
    if not hasattr(x, "items"):
        raise WrongType(f"{what}: a dict of names and values is expected, and not {x!r}")
    return [(name(key, what), formula(value, f"{what}[{key}]")) for key, value in x.items()]


def texts(x, what):
    """A str or several."""
    if x is None:
        return []
    if isinstance(x, str):
        return [plain(x, what)]
    try:
        return [sentence(part, what) for part in x]
    except TypeError as wrong:
        if isinstance(wrong, WrongType):
            raise
    return [sentence(x, what)]


def sentence(x, what):
    """An assumption: text, or a SymPy relation such as a > 0."""
    if isinstance(x, str):
        return plain(x, what)
    if is_sympy(x) and x.is_Relational:
        return f"{from_sympy(x.lhs)} {x.rel_op.replace('==', '=')} {from_sympy(x.rhs)}"
    raise WrongType(f"{what}: a sentence such as \"a > 0\" is expected, and not {x!r}")


# ---- SymPy


def symbol_name(symbol):
    import sympy

    text = symbol.name
    if isinstance(symbol, (sympy.Dummy, sympy.Wild)) or not NAME.match(text) or text == "I":
        raise InvalidArgument(f"the symbol {text!r} has no name that a formula can use")
    return text


MOST_NODES = 1000000


def check_size(expression):
    """SymPy walks through common parts again and again: refuse what is too large written out.

    Cost: each part once.
    """
    sizes, waiting = {}, [expression]  # by identity
    while waiting:
        node = waiting[-1]
        open_ = [part for part in node.args if id(part) not in sizes]
        if open_:
            waiting += open_
        else:
            sizes[id(node)] = 1 + sum(sizes[id(part)] for part in node.args)
            waiting.pop()
            if sizes[id(node)] > MOST_NODES:
                raise OutOfBudget(f"the expression written out has more than {MOST_NODES} parts")
    return expression


def symbols_of(expression):
    """{name: Symbol}; two different symbols of one name are refused."""
    found = {}
    for symbol in check_size(expression).free_symbols:
        text = symbol_name(symbol)
        if found.setdefault(text, symbol) != symbol:
            raise InvalidArgument(f"two different symbols are called {text}")
    return found


@functools.cache
def _printer():
    from sympy.printing.str import StrPrinter

    class Printer(StrPrinter):
        def _print_Symbol(self, x):
            return symbol_name(x)

        def _print_Integer(self, x):
            return _core.decimal(int(x))

        def _print_Rational(self, x):
            return f"{_core.decimal(int(x.p))}/{_core.decimal(int(x.q))}"

        def _print_Float(self, x):
            raise WrongType(f"{x} is not exact; write Rational(1, 2), or nsimplify(...) if that is meant")

        def _print_Derivative(self, x):
            if len(x.variable_count) != 1:
                raise InvalidArgument(f"{x}: a derivative with respect to one variable is expected")
            (variable, order), = x.variable_count
            return f"diff({self._print(x.expr)}, {self._print(variable)}, {int(order)})"

        def _print_Equality(self, x):
            return f"{self._print(x.lhs)} = {self._print(x.rhs)}"

        def _print_ComplexRootOf(self, x):
            near = complex(x.evalf(30))
            text = self._print(x.poly.as_expr())
            return f"root({text}, {near.real:.17f} + {near.imag:.17f}*I)"

    return Printer({"order": "none"})


def from_sympy(expression):
    """The formula of a SymPy expression or equation, for our parser."""
    import sympy

    symbols_of(expression)
    known = (sympy.Symbol, sympy.Rational, sympy.Float, type(sympy.I), sympy.Tuple)
    try:
        for atom in expression.atoms():
            if not isinstance(atom, known) or isinstance(atom, (type(sympy.nan), type(sympy.oo))):
                raise InvalidArgument(f"{atom} is not a number that a formula can use")
        return _printer().doprint(expression)
    except RecursionError:
        raise OutOfBudget("the expression is nested too deeply") from None


def assumptions_of(symbols):
    """What SymPy's symbols say of themselves, as sentences: Symbol("a", positive=True) is "a positive"."""
    said = []
    for text, symbol in sorted(symbols.items()):
        for words in (("positive", "negative", "nonnegative", "nonzero"), ("integer", "rational", "real")):
            said += [f"{text} {word}" for word in words if getattr(symbol, "is_" + word)][:1]
    return said


ROOT = re.compile(r"root\(([^,]*), ?([^,()]*)\)")


def to_sympy(text, symbols=(), generator=None):
    """A formula of ours as a SymPy expression.

    symbols: to be used for the names (with their assumptions); others are plain ones.
    generator: (letter, minimal polynomial, value, scale), what a letter of the text means.
    """
    import sympy

    known = {s.name: s for s in symbols}
    known["I"] = sympy.I
    if generator is not None:
        letter, minpoly, value, scale = generator
        known[letter] = nearest_root(sympy.Poly(minpoly[::-1], sympy.Symbol("x")), value) / scale
    while said := ROOT.search(text):
        letter = f"root_{len(known)}_"
        polynomial = sympy.Poly(to_sympy(said[1]))
        near = complex(sympy.sympify(said[2].replace("^", "**"), locals={"I": sympy.I}))
        known[letter] = nearest_root(polynomial, near)
        text = text[:said.start()] + letter + text[said.end():]
    functions = {"exp": sympy.exp, "sqrt": sympy.sqrt, "log": sympy.log}
    for word in set(re.findall(r"[A-Za-z_]\w*", text)) - set(known):
        if word in ("int", "root", "sum", "prod"):
            raise InvalidArgument(f"this has no counterpart in SymPy: {text}")
        known[word] = functions.get(word) or sympy.Symbol(word)
    return sympy.sympify(text.replace("^", "**"), locals=known, rational=True)


def nearest_root(polynomial, value):
    roots = polynomial.all_roots(multiple=True, radicals=False)
    return min(roots, key=lambda root: abs(complex(root) - value))
