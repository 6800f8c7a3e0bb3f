"""Differential Galois groups and non-integrability proofs, exactly.

    >>> import kovacic
    >>> kovacic.solve("z^2 + 3").group
    GaloisGroup('Borel')

A verdict is a theorem: yes, no, or undecided with the reason.  No answer converts to bool; ask
`answer.abelian is Truth.no`.  Numbers are exact (int, Fraction, str, SymPy); a float is refused.

Every call takes `timeout` (seconds; None: no limit) and `max_work`; a limit ends in an undecided answer,
or in OutOfBudget where nothing is known.  Ctrl-C raises Interrupted, a KeyboardInterrupt, with what is known
in `.answer`.  Calls from several threads run side by side.

docs/guide/python.md has examples.
"""

import os as _os

from . import _answers, _convert, _core, _evidence, _examples, _show
from ._core import (  # noqa: F401
    Accepted, AlgebraicNumber, Argument, BlockReport, ByEngines, ByFormula, ByKovacic, CheckReport, ClaimReport,
    Classification, ClassificationStatus, ClassifiedStratum, Connected, Decision, DrawnOrbit, Ended, ExclusionReason,
    FixedPoint, FixedPoints, FoundIntegral, FoundManifold, GaloisGroup, GroupType, IntegralSearch, IntegralsOfSet, LameAnswer,
    LameConditions, LameFamily, LiouvillianSolution, ManifoldReport, Method, MFraction, Monodromy, NodeResult,
    NodeStatus, RationalFunction, Rejected, Settled, Solved, Spectrum, SpectrumFamily, SpectrumLevel,
    SpectrumPiece, SpectrumSeries, SpectrumStatus, Stability, StrataAnswer, Stratum,
    StratumStatus, SymbolicFamily, TheoremHypothesis, TheoremResult, TheoremUsed, Trichotomy, Truth, Unable,
    VerdictKind, Why)
from ._errors import (  # noqa: F401
    DomainError, Error, FreeParameters, InputError, InternalError, Interrupted, InvalidArgument, OutOfBudget,
    WrongType)
from ._map import map  # noqa: A004, F401
from ._scan import Scan, scan  # noqa: F401
from ._section import SystemSection  # noqa: F401
from ._system_object import System  # noqa: F401

__version__ = _core.version

_QUESTION, _THEOREM = 60, 600  # seconds, as in the command


@_answers.asked
def solve(equation=None, *, r=None, ode=None, p=None, q=None, variable=None, unknown=None, parameters=None,
          assume=None, set=None, minpoly=None, method="automatic", only_case=None, solutions=True, trace=False,
          certificate=False, timeout=_QUESTION, max_work=None, max_degree=None, max_families=None):
    """Decide one equation: solve("z^2 + 3") is y'' = (z^2 + 3) y, solve("z y'' + y' + z y = 0") a whole one.

        >>> kovacic.solve("y'' + y = sin(x)").solutions
        ['c1*cos(x) + c2*sin(x) - x*cos(x)/2']

    Text is read as the command reads it: 2x y', y(0) = 1 after a comma, LaTeX, a right side, an equation of Riccati.

    Exactly one of `equation`, `r` (y'' = r y), `ode`, or `p` and `q` (y'' + p y' + q y = 0).  Without parameters
    the answer is a Solved (a Decision with the equation as given), with parameters a StrataAnswer.

    unknown: the name of the unknown function, needed only where it has several letters that could be a product.
    parameters: names without a value; `assume` sentences about them: "n positive", "a != 0", "n not an integer",
    or SymPy relations.  The free symbols of a SymPy expression besides its variable are parameters, and what
    SymPy assumes of them is assumed.  set: {name: value}.
    """
    texts = _equation(equation, r, ode, p, q, variable, unknown, parameters, assume, set, minpoly)
    return _core.solve(_wishes(timeout, max_work, max_degree, max_families, method=_method(method),
                               only_case=_int(only_case, "only_case"), solutions=bool(solutions),
                               trace=bool(trace), certificate=bool(certificate)), texts)


@_answers.asked
def check(source, *, set=None, manifold="", order=1, assume=None, trace=False, certificate=False, timeout=_QUESTION,
          max_work=None, max_degree=None, max_families=None):
    """A system file, by its path or as text with line breaks: what follows from each of its manifolds.

    A CheckReport; for an equation file what solve() returns.  set: {parameter: value}.
    order: of the variational equations, 1 to 7, where the first leaves something open.

        >>> text = kovacic.hamiltonian("(u^2 + v^2)/2 + x^2*y - y^3/3", "x y", "u v",
        ...                            manifolds=[{"equations": ["x = 0", "u = 0"], "level": "H = 1"}])
        >>> kovacic.check(text).manifolds[0].verdict
        VerdictKind.non_integrable
    """
    if not isinstance(manifold, str):
        raise WrongType(f"manifold: a str is expected, and not {manifold!r}")
    return _core.check(_wishes(timeout, max_work, max_degree, max_families, trace=bool(trace),
                               certificate=bool(certificate)),
                       _source(source), _convert.values(set), manifold, _int(order, "order"), _convert.texts(assume, "assume"))


@_answers.asked
def prove(path, *, timeout=_THEOREM, max_work=None, certificate=False):
    """A theorem file, run: a TheoremResult.  `timeout` is for all steps together.

        >>> kovacic.prove("cases/sliding_top/lemma3_theorem.toml")  # doctest: +SKIP
    """
    return _core.prove(_wishes(timeout, max_work, None, None, certificate=bool(certificate)), _path(path))


@_answers.asked
def verify(certificate):
    """A certificate, as JSON text or the path of a file: Accepted with what it states, or Rejected.

    Raises InvalidArgument for a text that is not a certificate.

        >>> kovacic.verify(kovacic.solve("z", certificate=True).certificate)
        <Accepted, 0 trusted steps>
    """
    text = certificate
    if isinstance(text, _os.PathLike) or (isinstance(text, str) and not text.lstrip().startswith("{")):
        text = _read(text)
    if not isinstance(text, str):
        raise WrongType(f"the text or the path of a certificate is expected, and not {certificate!r}")
    return _core.verify(_convert.plain(text, "the certificate"))


@_answers.asked
def lame(n=None, B=None, g2=None, g3=None, *, alpha=None, timeout=_QUESTION, max_work=None):
    """Lame's equation y_tt = (n(n+1) wp(t; g2, g3) + B) y.  What is not given is free.

    Numbers: a LameAnswer.  Free B, g2 or g3: LameConditions.  n or alpha = n(n+1) that depends on names: the
    families of values that leave a chance, as a list of LameFamily.

        >>> kovacic.lame("1/2", B=0, g2=4, g3=0).decision.abelian
        Truth.yes
    """
    given = [None if x is None else _convert.formula(x, what)
             for what, x in (("n", n), ("alpha", alpha), ("B", B), ("g2", g2), ("g3", g3))]
    if given[0] is not None and given[1] is not None:
        raise InvalidArgument("both n and alpha are given; alpha means n(n+1)")
    return _core.lame(_wishes(timeout, max_work, None, None, solutions=False), *given)


@_answers.asked
def integrals(source, degree=2, *, coefficients=None, set=None, timeout=_QUESTION, max_work=None):
    """First integrals of a system file, of this degree in the momenta, at all values of its parameters.

        >>> found = kovacic.integrals("H = (px^2 + py^2)/2 + x^2*y + 2*y^3", degree=2)
        >>> len(found.sets[0].integrals)
        2
    """
    return _core.integrals(_limits(timeout, max_work), _source(source), _convert.values(set),
                           _int(degree, "degree"), _int(coefficients, "coefficients"))


@_answers.asked
def spectrum(equation=None, *, r=None, ode=None, energy="E", variable=None, unknown=None, assume=None, set=None,
             levels=4, timeout=_QUESTION, max_work=None):
    """For which values of `energy` has the equation a Liouvillian solution?  A Spectrum, in pieces.

    Every name without a value is a parameter, as in the command `kovacic spectrum`; levels: how many N are written
    out, with eigenfunctions.

        >>> [piece.series[0].value for piece in kovacic.spectrum("x^2 - E").pieces if piece.series]
        [MFraction('2*N + 1')]
    """
    texts = _equation(equation, r, ode, None, None, variable, unknown, None, assume, set, None)
    return _core.spectrum(_limits(timeout, max_work), texts, _convert.name(energy, "energy"), _int(levels, "levels"))


@_answers.asked
def classify(source, *, degree=None, search=True, set=None, timeout=_THEOREM, max_work=None):
    """For which parameters is a system integrable?  A Classification: strata with proofs, the rest open.

        >>> print(kovacic.classify("H = p1^2/2 + p2^2/2 + q1^2*q2 + 2*q2^3").statement)
        The system is integrable.

    source: a System, a Hamiltonian as text (whose letters are guessed), a system file by its path or as text.

    degree: of the first integrals that are looked for (4, and 6 where sets are open and work is left); search=False: no solutions but the manifolds of the file.
    """
    return _core.classify(_limits(timeout, max_work), _source(source), _convert.values(set),
                          _int(degree, "degree"), bool(search))


@_answers.asked
def monodromy(equation=None, *, r=None, ode=None, p=None, q=None, variable=None, unknown=None, set=None,
              minpoly=None, digits=30, timeout=_QUESTION, max_work=None):
    """Monodromy matrices of (y, y') with proven radii of at most 10^-digits.

        >>> len(kovacic.monodromy("-3/(16*z^2)").loops)
        1
    """
    texts = _equation(equation, r, ode, p, q, variable, unknown, None, None, set, minpoly)
    return _core.monodromy(_limits(timeout, max_work), texts, _int(digits, "digits"))


def section(source, *, scene=None, threads=1, progress=None, timeout=None):
    """The Poincare section of a scene: a SystemSection.  source: a scene file or a system file with scenes (its path, or
    its text), of which `scene` is the name of one.  progress(done, all) is called after each orbit.

        >>> S = kovacic.System("p^2/2 + q^2/2", "q", "p")
        >>> text = S.to_text() + '[scene]\\nsection = "q"\\nplot = ["q", "p"]\\nstates = [[1, 0]]\\ncrossings = 5\\n'
        >>> len(kovacic.section(text).points)
        5
    """
    from . import _section

    return _section.computed(_limits(timeout, None), _section.scene_of(_source(source), scene), threads, progress)


@_answers.asked
def fixed_points(source, *, timeout=None):
    """Periodic orbits that meet the section of a body's scene once, each proved or with the reason why not.

        >>> kovacic.fixed_points("cases/sliding_top/scenes/asymmetric_sliding.toml")  # doctest: +SKIP
    """
    return _core.fixed_points(_limits(timeout, None), _source(source))


def hamiltonian(H, coordinates, momenta, *, parameters=None, manifolds=(), assume=None, title="", set=None):
    """The text of a system file for check() and integrals(), from a Hamiltonian (SymPy or text).

    manifolds: dicts with the keys name, equations, level, and change (z = ..., a formula) and variable for the
    reduction, if it is not to be proposed.  assume: sentences such as "a > 0", or SymPy relations.

        >>> print(kovacic.hamiltonian("p^2/2 + q^4", "q", "p").splitlines()[0])
        format = "equation/1"
    """
    from . import _system

    return _system.hamiltonian(H, coordinates, momenta, parameters, manifolds, assume, title, set)


def to_sympy(value, symbols=()):
    """A RationalFunction, MFraction, number, solution or formula of ours as a SymPy expression.

    symbols: those to use for the names; others become plain symbols.

        >>> kovacic.to_sympy("z^2 + 1/2")
        z**2 + 1/2
    """
    if isinstance(value, LiouvillianSolution):
        if value.y is None:
            raise InvalidArgument("this solution is given by the minimal polynomial of y'/y")
        return _convert.to_sympy(value.y, symbols, value.generator)
    if isinstance(value, (RationalFunction, AlgebraicNumber)):
        return _convert.to_sympy(str(value), symbols, value.generator)
    return _convert.to_sympy(_convert.formula(value), symbols)


# ---- arguments


def _limits(timeout, max_work, max_degree=None, max_families=None):
    return _core.Limits(timeout=_number(timeout, "timeout"), max_work=_number(max_work, "max_work"),
                        max_degree=_int(max_degree, "max_degree"), max_families=_int(max_families, "max_families"))


def _wishes(timeout, max_work, max_degree, max_families, **options):
    return _core.Wishes(limits=_limits(timeout, max_work, max_degree, max_families), **options)


def _number(x, what):
    if x is None or (isinstance(x, (int, float)) and not isinstance(x, bool)):
        return x
    raise WrongType(f"{what}: a number or None is expected, and not {x!r}")


def _int(x, what):
    if x is None:
        return None
    if not isinstance(x, int) or isinstance(x, bool):
        raise WrongType(f"{what}: an int is expected, and not {x!r}")
    if abs(x) >= 2**31:
        raise InvalidArgument(f"{what} is too large")
    return x


def _method(x):
    if isinstance(x, Method):
        return x
    if x not in Method.__members__:
        raise InvalidArgument(f"method: one of {', '.join(Method.__members__)} is expected, and not {x!r}")
    return Method.__members__[x]


def _is_whole_equation(x):
    if isinstance(x, str):
        return any(sign in x for sign in ("'", "=", "diff(", "Derivative(", "\u2033", "\u2032", "\\frac", "\\ddot", "\\prime"))
    if _convert.is_sympy(x):
        import sympy

        return isinstance(x, sympy.Equality) or _convert.check_size(x).has(sympy.Derivative)
    return False


def _unknown_variable(ode):
    """z of y(z), in a SymPy equation."""
    import sympy

    applied = ode.atoms(sympy.core.function.AppliedUndef)
    variables = {argument for f in applied for argument in f.args}
    if len(variables) != 1 or not next(iter(variables)).is_Symbol:
        raise InvalidArgument(f"one unknown function of one variable is expected in {ode}")
    return variables.pop()


def _unknown_function(ode):
    """The name of y, in a SymPy equation; None where there are several."""
    import sympy

    names = {str(f.func) for f in ode.atoms(sympy.core.function.AppliedUndef)}
    return names.pop() if len(names) == 1 else None


def _equation(equation, r, ode, p, q, variable, unknown, parameters, assume, set, minpoly):
    if equation is not None:
        if r is not None or ode is not None or p is not None or q is not None:
            raise InvalidArgument("two equations are given")
        r, ode = (None, equation) if _is_whole_equation(equation) else (equation, None)
    if (r is not None) + (ode is not None) + (p is not None or q is not None) != 1 or (p is None) != (q is None):
        raise InvalidArgument('one equation is expected: solve("z"), solve(ode="y\'\' = z*y"), or p and q')
    given = [x for x in (r, ode, p, q) if _convert.is_sympy(x)]
    if ode is not None and given:
        variable = _unknown_variable(ode) if variable is None else variable
        unknown = _unknown_function(ode) if unknown is None else unknown
    free = {}
    for expression in given:
        free |= _convert.symbols_of(expression)
    variable = "" if variable is None else _convert.name(variable, "variable")
    unknown = "" if unknown is None else _convert.name(unknown, "unknown")
    names, sentences = _convert.names(parameters, "parameters"), _convert.texts(assume, "assume")
    pairs = _convert.values(set)
    if free:
        if not variable and len(free) > 1:
            raise InvalidArgument(f"which of {', '.join(sorted(free))} is the variable?  write variable=...")
        own = {n: s for n, s in free.items() if n != (variable or n) and n not in dict(pairs)}
        names += [n for n in own if n not in names]
        sentences = _convert.assumptions_of(own) + sentences
        variable = variable or next(iter(free))
    text = [None if x is None else _convert.formula(x, what)
            for what, x in (("r", r), ("the equation", ode), ("p", p), ("q", q), ("minpoly", minpoly))]
    return _core.QuestionTexts(*text, variable, unknown, names, sentences, pairs)


def _path(x, expected="a path"):
    if isinstance(x, (str, _os.PathLike)):
        text = _os.fspath(x)
        if isinstance(text, str) and "\0" not in text:
            return _convert.plain(text, "the path")
    raise WrongType(f"{expected} is expected, and not {x!r}")


def _text_or_path(x):
    """(text, name) of a document: a str with a line break is the text itself, one that is a formula a Hamiltonian."""
    if isinstance(x, System):
        return x.to_text(), "system"
    if isinstance(x, str) and "\n" not in x and not x.endswith((".toml", ".json")) and set(x) & set("^*+=") and not _os.path.exists(x):
        return System(x).to_text(), "system"
    if isinstance(x, str) and "\n" in x:
        return _convert.plain(x, "the text"), "text"
    return "", _path(x, "system: a formula, a System or the path of a file")


def _source(x):
    return _core.Source(*_text_or_path(x))


def _read(path):
    try:
        with open(_path(path), encoding="utf-8") as file:
            return file.read()
    except (OSError, UnicodeDecodeError) as wrong:
        raise InvalidArgument(f"{path}: {wrong}") from None


# ---- what only Python knows of the values

def _to_frame(self):
    """The strata as a pandas frame: conditions, status, integrals, and what excludes them.

        >>> S = kovacic.System("(p1^2 + p2^2)/2 + q1^2*q2 + b*q2^3/3", ["q1", "q2"], ["p1", "p2"])
        >>> frame = S.classify().to_frame()                       # doctest: +SKIP
    """
    import pandas

    rows = [{"conditions": ", ".join(s.conditions), "status": s.status.name,
             "integrals": "; ".join(str(x) for x in s.integrals), "by": "; ".join(f"along {x.solution}: {x.reason}" for x in s.by)} for s in self.strata]
    return pandas.DataFrame(rows, columns=["conditions", "status", "integrals", "by"])


Classification.to_frame = _to_frame
for _type in (RationalFunction, MFraction, AlgebraicNumber, LiouvillianSolution):
    _type.sympy = to_sympy
for _type in (RationalFunction, MFraction, AlgebraicNumber, GaloisGroup):
    _type.__copy__ = lambda self: self
    _type.__deepcopy__ = lambda self, _: self
for _type, _shown in (
        (Decision, _show.decision), (StrataAnswer, _show.strata), (ManifoldReport, _show.manifold),
        (CheckReport, _show.report), (TheoremResult, _show.theorem), (Accepted, _show.verdict),
        (Rejected, _show.verdict), (IntegralSearch, _show.integrals), (Classification, _show.classification),
        (Monodromy, _show.monodromy)):
    _type._repr_html_ = _shown
for _type in (Decision, StrataAnswer, ManifoldReport, CheckReport, TheoremResult, Accepted, Rejected, IntegralSearch,
              Classification, Monodromy, Spectrum, LameAnswer, LameConditions):
    _type.to_dict, _type.latex, _type.report = _answers.to_dict, _answers.latex, _answers.report

from ._evidence import (  # noqa: E402, F401
    AssumedNotInteger, ClassicalForm, ConditionFails, DifferenceBound, ExcludedDifferences, ExponentialFound,
    InvariantFound, IrrationalDifference, IrregularPlace, Logarithm, Loop, NoExponential, NoFamilies, NoInvariant, NoProducts,
    Number, OfEquation, OtherBlocks, SeparatedNowhere)

_examples.attach(globals())
__all__ = sorted(_name for _name in dir() if not _name.startswith("_"))
