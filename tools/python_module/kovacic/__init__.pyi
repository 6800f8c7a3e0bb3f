"""Types of kovacic.  Formula: an exact value; a float is refused."""

import enum
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from os import PathLike
from typing import Any

Formula = Any  # int, Fraction, str, a SymPy expression, RationalFunction, MFraction
Name = Any  # str or a SymPy Symbol
Names = Any  # "a b", or several names
Sentences = Any  # "a > 0", a SymPy relation, or several
Path = str | PathLike[str]
Source = str | PathLike[str]  # a path, or (str with line breaks) the text itself


class Argument(enum.Enum):
    none = 0
    zero = 1
    p_curvature = 2
    torus_two_lines = 3
    torus_dihedral = 4
    torus_no_invariant = 5
    torus_one_line = 6
    torus_no_line = 7
    logarithm_one_line = 8
    logarithm_no_line = 9
    integral_exponents = 10
    two_quartics = 11
    two_radicals = 12
    fourth_power = 13
    dihedral = 14
    one_radical = 15
    line_alone = 16
    no_invariant = 17
    primitive = 18
    def __bool__(self) -> bool: ...


class ClassificationStatus(enum.Enum):
    integrable = 4
    non_integrable = 0
    open = 3
    depends = 2
    def __bool__(self) -> bool: ...


class Connected(enum.Enum):
    trivial = 0
    additive = 1
    torus = 2
    borel = 3
    sl2 = 4
    def __bool__(self) -> bool: ...


class Ended(enum.Enum):
    time = 0
    crossings = 1
    steps = 2
    stopped = 3
    broken = 4
    singular = 5
    idle = 6
    escaped = 7
    lost = 8
    def __bool__(self) -> bool: ...


class GroupType(enum.Enum):
    SL2 = 0
    Borel = 1
    T = 2
    Gm = 3
    cyclic = 4
    Dinf = 5
    D = 6
    A4 = 7
    S4 = 8
    A5 = 9
    def __bool__(self) -> bool: ...


class Method(enum.Enum):
    automatic = 0
    kovacic = 1
    engines = 2
    all = 3
    def __bool__(self) -> bool: ...


class NodeStatus(enum.Enum):
    proved = 0
    partial = 1
    trusted = 2
    reasoned = 3
    unbound = 4
    open = 5
    refuted = 6
    def __bool__(self) -> bool: ...


class Settled(enum.Enum):
    checked = 0
    stated = 1
    open = 2
    def __bool__(self) -> bool: ...


class Stability(enum.Enum):
    elliptic = 0
    hyperbolic = 1
    inverse_hyperbolic = 2
    def __bool__(self) -> bool: ...


class StratumStatus(enum.Enum):
    integrable = 0
    excluded = 1
    open = 2
    def __bool__(self) -> bool: ...


class SpectrumStatus(enum.Enum):
    no_equation = 0
    none = 1
    all = 2
    conditions = 3
    degrees = 4
    open = 5
    def __bool__(self) -> bool: ...


class Trichotomy(enum.Enum):
    irregular_or_irrational = 0
    logarithmic = 1
    rational_without_log = 2
    undetermined = 3
    def __bool__(self) -> bool: ...


class Truth(enum.Enum):
    no = 0
    yes = 1
    unknown = 2
    def __bool__(self) -> bool: ...


class VerdictKind(enum.Enum):
    non_integrable = 0
    no_obstruction = 1
    depends = 2
    undecided = 3
    integrable = 4
    failed = 5
    def __bool__(self) -> bool: ...


class Why(enum.Enum):
    parameter = 0
    budget = 1
    not_implemented = 2
    inexact = 3
    methods_disagree = 4
    def __bool__(self) -> bool: ...


class DomainError(Error, ArithmeticError): ...


class Error(Exception): ...


class OutOfBudget(Error): ...


class InternalError(Error, RuntimeError): ...


class WrongType(Error, TypeError): ...


class FreeParameters(Error, ValueError): ...


class InputError(Error, ValueError):
    file: str
    line: int
    column: int
    length: int
    message: str
    hint: str
    source_line: str


class InvalidArgument(Error, ValueError): ...


class Interrupted(KeyboardInterrupt):
    answer: Any


class Decision:
    __match_args__ = ('group', 'because')
    r: RationalFunction
    variable: str
    group: GaloisGroup | None
    component: Connected | None
    abelian: Truth
    kovacic_case: int | None
    because: ByEngines | ByKovacic | ByFormula | None
    reason: str
    undecided: Unable | None
    withdrawn: str | None
    second_opinion: int | None
    liouvillian: list[LiouvillianSolution]
    basis: tuple[str, str] | None
    polynomial_of_y: tuple[int, RationalFunction, list[RationalFunction]] | None
    no_solutions: str | None
    only_case: int | None
    trace: list[tuple[str, str]]
    certificate: str | None
    no_certificate: str
    refused: str
    seconds: float
    headline: str
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class Accepted:
    __match_args__ = ('statement', 'trusted_steps')
    trusted_steps: int
    statement: list[str]
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class AlgebraicNumber:
    letter: str
    minpoly: list[int]
    generator: tuple[str, list[int], complex, int] | None
    def sympy(self, symbols: Iterable[Any] = ()) -> Any: ...


class AssumedNotInteger:
    place: str
    twice: bool


class BlockReport:
    __match_args__ = ('answer',)
    unknowns: list[str]
    unknown: str | None
    change: str | None
    r: MFraction | None
    answer: Decision | StrataAnswer | None
    abelian: Truth
    merging: list[str]
    levels: list[tuple[str, str, Any, str]]
    note: str


class ByEngines:
    __match_args__ = ('argument',)
    argument: Argument
    kind: Trichotomy
    place: str | None
    exponential: RationalFunction | None
    pair: tuple[RationalFunction, Any] | None
    invariants: list[tuple[int, RationalFunction]]
    no_invariants: list[int]
    no_exponential: str | None
    p_curvature: int | None
    undecided: Unable | None
    reason: str


class ByFormula:
    __match_args__ = ('family', 'parameters')
    family: str
    equation: str
    parameters: dict[str, Any]
    reason: str
    engines: Unable | None


class ByKovacic: ...


class CheckReport:
    __match_args__ = ('verdict',)
    verdict: VerdictKind
    complete: bool
    integrals: str | None
    title: str
    file: str
    values: dict[str, Any]
    assumptions: list[str]
    claims: list[ClaimReport]
    manifolds: list[ManifoldReport]
    certificates: dict[str, Any]
    together: Classification
    seconds: float
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class ClaimReport:
    name: str
    text: str
    proved: Truth
    detail: str
    generic: list[str]


class ClassicalForm:
    family: str
    squares: dict
    values: dict
    centre: Any
    power: int


class ConditionFails: ...


class Classification:
    __match_args__ = ('status', 'strata')
    status: ClassificationStatus
    statement: str
    strata: list[ClassifiedStratum]
    integrals_class: str | None
    almost_all: ExclusionReason | None
    assumptions: list[str]
    theorems: list[str]
    trusted_steps: list[str]
    notes: list[str]
    stages: list[tuple[str, float]]
    complete: bool
    seconds: float
    def to_frame(self) -> Any: ...  # pandas.DataFrame
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class SpectrumLevel:
    __match_args__ = ('n', 'y')
    n: int
    fixed: tuple[str, MFraction] | None
    equations: list[MFraction]
    y: str | None


class SpectrumSeries:
    __match_args__ = ('value',)
    equation: MFraction
    value: MFraction | None
    integer: str
    every_energy: bool
    levels: list[SpectrumLevel]


class SpectrumFamily:
    __match_args__ = ('degree',)
    degree: MFraction
    levels: list[SpectrumLevel]
    open: str


class SpectrumPiece:
    __match_args__ = ('status',)
    status: SpectrumStatus
    conditions: str
    where: list[str]
    series: list[SpectrumSeries]
    unsolved: list[str]
    families: list[SpectrumFamily]
    groups: list[GaloisGroup]
    why: str


class Spectrum:
    __match_args__ = ('pieces',)
    pieces: list[SpectrumPiece]
    energy: str
    decided: bool
    assumptions: list[str]
    trusted_steps: list[str]
    not_studied: list[str]
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class ClassifiedStratum:
    __match_args__ = ('status', 'conditions')
    conditions: list[str]
    status: StratumStatus
    integrals: list[FoundIntegral]
    fields: list[str]
    by: list[ExclusionReason]
    open_after: list[str]


class DifferenceBound:
    place: str
    square: Fraction


class ExcludedDifferences:
    place: str
    values: list


class ExponentialFound:
    w: Any


class FixedPoint:
    __match_args__ = ('stability', 'at')
    at: list[float]
    x: list[float]
    period: float
    trace: float
    multiplier: list[float]
    stability: Stability
    proved: bool
    error: float
    trace_error: float
    why: str


class FixedPoints:
    __match_args__ = ('points',)
    points: list[FixedPoint]
    index_sum: int
    cells: int
    cells_without_index: int
    unexplained_cells: int
    stopped: bool
    degenerate: bool


class ExclusionReason:
    __match_args__ = ('solution', 'reason')
    solution: str
    level: str
    order: int
    reason: str
    theorems: list[str]
    trusted: list[str]
    not_checked: str
    statement: str
    integrals_class: str


class FoundIntegral:
    __match_args__ = ('value',)
    value: MFraction
    degree: int
    casimir: bool
    hamiltonian: bool
    logarithms: list[tuple[MFraction, MFraction]]


class GaloisGroup:
    __match_args__ = ('type', 'n')
    type: GroupType
    n: int | None
    identity_component: Connected
    kovacic_case: int


class FoundManifold:
    __match_args__ = ('equations',)
    equations: list[str]
    kind: str
    dimension: int
    leaf_dimension: int
    equilibria: bool


class IntegralSearch:
    __match_args__ = ('sets',)
    searched: str
    sets: list[IntegralsOfSet]
    elsewhere: IntegralsOfSet | None
    not_covered: list[str]
    assumed: list[str]
    assumed_equations: list[str]
    finished: bool
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class IntegralsOfSet:
    __match_args__ = ('integrals',)
    searched: str
    equations: list[str]
    inequations: list[str]
    integrals: list[FoundIntegral]
    values: list[MFraction]
    commuting: list[int]
    liouville: bool
    only_declared_relations: bool
    complete: bool
    complete_for_smooth: bool
    open: str | None


class InvariantFound: ...


class IrrationalDifference:
    place: str


class IrregularPlace:
    place: str


class LameAnswer:
    __match_args__ = ('abelian', 'group')
    decision: Decision
    abelian: Truth
    group: GaloisGroup | None
    closed: str
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class LameConditions:
    __match_args__ = ('polynomials', 'discriminant')
    n: Fraction | None
    discriminant: MFraction
    polynomials: list[MFraction]
    always: bool
    never: bool
    abelian: Truth
    reducible: MFraction | None
    octahedral: list[MFraction]
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class LameFamily:
    numerator: int
    denominator: int
    which: str


class LiouvillianSolution:
    __match_args__ = ('y',)
    y: str | None
    omega: RationalFunction | None
    minimal_polynomial: list[RationalFunction]
    note: str
    generator: tuple[str, list[int], complex, int] | None
    def sympy(self, symbols: Iterable[Any] = ()) -> Any: ...


class Logarithm:
    place: str


class Loop:
    place: str
    matrix: list
    decimals: list
    radius: str


class MFraction:
    names: list[str]
    def factored(self) -> str: ...
    def sympy(self, symbols: Iterable[Any] = ()) -> Any: ...


class ManifoldReport:
    __match_args__ = ('verdict',)
    name: str
    verdict: VerdictKind
    failure: str | None
    by: TheoremUsed | None
    integrals: str
    statement: str
    not_checked: str | None
    reasons: list[str]
    blocks: list[BlockReport]
    matrices: str | None
    notes: list[str]
    trusted_steps: list[str]
    not_studied: str | None
    headline: str
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class Monodromy:
    __match_args__ = ('loops',)
    base: tuple[str, str]
    loops: list[Loop]
    self_tests: list[str]
    proves: GroupType | None
    words: list[list[int]] | None
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class NoExponential:
    degree: Fraction
    odd_order: bool


class NoFamilies: ...


class NoInvariant:
    m: int


class NoProducts:
    place: str


class NodeResult:
    __match_args__ = ('status',)
    id: str
    title: str
    kind: str
    needs: list[str]
    status: NodeStatus
    statement: str
    summary: str
    rests_on_open: bool
    steps_on_trust: int
    integrals: str
    excluded: list[str]
    theorems: list[TheoremUsed]
    trusted: list[str]
    certificates: list[str]
    seconds: float


class Number:
    decision: Any


class OfEquation:
    unknown: str
    r: Any


class OtherBlocks:
    shown: str


class RationalFunction:
    variable: str
    num: list[Fraction | AlgebraicNumber]
    den: list[Fraction | AlgebraicNumber]
    generator: tuple[str, list[int], complex, int] | None
    def __init__(self, text: str | int | Fraction, variable: str = "z") -> None: ...
    def diff(self) -> RationalFunction: ...
    def sympy(self, symbols: Iterable[Any] = ()) -> Any: ...
    def __add__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __radd__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __sub__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __rsub__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __mul__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __rmul__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __truediv__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __rtruediv__(self, other: RationalFunction | int | Fraction) -> RationalFunction: ...
    def __pow__(self, e: int) -> RationalFunction: ...
    def __neg__(self) -> RationalFunction: ...
    def __call__(self, at: int | Fraction) -> Fraction | AlgebraicNumber: ...


class Rejected:
    __match_args__ = ('step', 'why')
    step: str
    why: str
    limit: bool
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class DrawnOrbit:
    start: list[float]
    crossings: int
    tangencies: int
    steps: int
    time: float
    drift: float
    ended: Ended
    megno: float
    lyapunov: float
    fli: float


class SystemSection:
    title: str
    labels: tuple[str, str]
    indicator: str | None
    allowed_drift: float
    orbit: Any  # numpy.ndarray, or array.array
    t: Any
    x: Any
    y: Any
    points: Any  # numpy.ndarray
    colors: Any
    orbits: list[DrawnOrbit]
    integrals: list[str]
    drifts: list[float]
    drift: float
    arithmetic: str
    skipped: int
    stopped: bool
    cut_short: int
    def plot(self, ax: Any = None, **options: Any) -> Any: ...  # matplotlib Axes


class Solved(Decision):
    unknown: str
    equation: str
    solutions: list[str]
    p: RationalFunction
    q: RationalFunction
    factor: str
    basis: tuple[str, str] | None
    polynomial_of_y: tuple[int, RationalFunction, list[RationalFunction]] | None
    constants: dict[str, str]


class StrataAnswer:
    __match_args__ = ('strata',)
    abelian: Truth
    group: GaloisGroup | None
    strata: list[Stratum]
    domain: list[str]
    assumed: list[str]
    unvisited: list[str]
    trusted: list[str]
    pruned: list[str]
    contradictory: bool
    refused: str
    decided: bool
    r: MFraction
    equation: str | None
    solutions: list[str]
    elsewhere: list[tuple[str, StrataAnswer | None]]
    variable: str
    family: SymbolicFamily | None
    seconds: float
    certificate: str | None
    def at(self, value: dict[str, Fraction]) -> Stratum | None: ...
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class Stratum:
    __match_args__ = ('abelian', 'group')
    conditions: list[str]
    where: str
    abelian: Truth
    group: GaloisGroup | None
    group_text: str
    reason: str
    because: list[Any]
    undecided: str | None
    no_equation: bool
    trace: list[tuple[str, str]]


class SymbolicFamily:
    family: str
    equation: str
    parameters: dict[str, Any]
    cases: list[Any]
    generic: list[MFraction]
    summary: str


class TheoremHypothesis:
    text: str
    settled: Settled
    how: str


class TheoremResult:
    __match_args__ = ('complete',)
    title: str
    nodes: list[NodeResult]
    statement: str
    verdict: str
    conclusion: str
    complete: bool
    theorems: list[TheoremUsed]
    trusted_steps: list[str]
    unchecked_hypotheses: list[str]
    seconds: float
    def text(self) -> str: ...
    def json(self) -> str: ...
    def tex(self) -> str: ...
    def html(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def report(self, path: Path) -> None: ...


class TheoremUsed:
    __match_args__ = ('id',)
    id: str
    name: str
    statement: str
    cite: str
    hypotheses: list[TheoremHypothesis]
    integrals: str


class Unable:
    __match_args__ = ('why', 'detail')
    why: Why
    detail: str


class SeparatedNowhere:
    pair: list
    third: str


def solve(equation: Formula | None = None, *, r: Formula | None = None, ode: Formula | None = None, p: Formula | None = None,
          q: Formula | None = None, variable: Name | None = None, unknown: Name | None = None,
          parameters: Names | None = None,
          assume: Sentences | None = None, set: Mapping[Name, Formula] | None = None, minpoly: Formula | None = None,
          method: Method | str = "automatic", only_case: int | None = None, solutions: bool = True, trace: bool = False,
          certificate: bool = False, timeout: float | None = 60, max_work: float | None = None,
          max_degree: int | None = None, max_families: int | None = None) -> Any: ...  # Solved, or StrataAnswer


def check(source: Source, *, set: Mapping[Name, Formula] | None = None, manifold: str = "", order: int = 1,
          assume: Sentences | None = None, trace: bool = False, certificate: bool = False, timeout: float | None = 60,
          max_work: float | None = None, max_degree: int | None = None,
          max_families: int | None = None) -> Any: ...  # CheckReport, or as solve()


def prove(path: Path, *, timeout: float | None = 600, max_work: float | None = None,
          certificate: bool = False) -> TheoremResult: ...


def verify(certificate: Source) -> Accepted | Rejected: ...


def lame(n: Formula | None = None, B: Formula | None = None, g2: Formula | None = None, g3: Formula | None = None, *,
         alpha: Formula | None = None, timeout: float | None = 60,
         max_work: float | None = None) -> LameAnswer | LameConditions | list[LameFamily]: ...


def integrals(source: Source, degree: int = 2, *, coefficients: int | None = None,
              set: Mapping[Name, Formula] | None = None, timeout: float | None = 60,
              max_work: float | None = None) -> IntegralSearch: ...


def classify(source: Source, *, degree: int | None = None, search: bool = True, set: Mapping[Name, Formula] | None = None,
             timeout: float | None = 600, max_work: float | None = None) -> Classification: ...


def spectrum(equation: Formula | None = None, *, r: Formula | None = None, ode: Formula | None = None,
             energy: Name = "E", variable: Name | None = None, unknown: Name | None = None,
             assume: Sentences | None = None,
             set: Mapping[Name, Formula] | None = None, levels: int = 4, timeout: float | None = 60,
             max_work: float | None = None) -> Spectrum: ...


def monodromy(equation: Formula | None = None, *, r: Formula | None = None, ode: Formula | None = None,
              p: Formula | None = None, q: Formula | None = None, variable: Name | None = None,
              unknown: Name | None = None,
              set: Mapping[Name, Formula] | None = None, minpoly: Formula | None = None, digits: int = 30,
              timeout: float | None = 60, max_work: float | None = None) -> Monodromy: ...


def section(source: Source, *, scene: str | None = None, threads: int = 1,
            progress: Callable[[int, int], Any] | None = None, timeout: float | None = None) -> SystemSection: ...


def fixed_points(source: Source, *, timeout: float | None = None) -> FixedPoints: ...


class System:
    def __init__(self, H: Formula, coordinates: Names | None = None, momenta: Names | None = None, *, parameters: Names | None = None,
                 assume: Sentences | None = None, set: Mapping[Name, Formula] | None = None, title: str = "",
                 manifolds: Mapping[str, Any] | Sequence[Mapping[str, Any]] = ()) -> None: ...
    @classmethod
    def lagrangian(cls, L: Formula, coordinates: Names | None = None, velocities: Names | None = None, *, parameters: Names | None = None,
                   assume: Sentences | None = None, set: Mapping[Name, Formula] | None = None, title: str = "",
                   manifolds: Mapping[str, Any] | Sequence[Mapping[str, Any]] = ()) -> System: ...
    @classmethod
    def poisson(cls, H: Formula, coordinates: Names, bracket: Any, *, parameters: Names | None = None,
                assume: Sentences | None = None, set: Mapping[Name, Formula] | None = None, title: str = "",
                manifolds: Mapping[str, Any] | Sequence[Mapping[str, Any]] = ()) -> System: ...
    @classmethod
    def field(cls, field: Mapping[Name, Formula] | Sequence[Formula], coordinates: Names | None = None, *,
              parameters: Names | None = None, assume: Sentences | None = None,
              set: Mapping[Name, Formula] | None = None, title: str = "",
              manifolds: Mapping[str, Any] | Sequence[Mapping[str, Any]] = ()) -> System: ...
    @classmethod
    def from_text(cls, text: str) -> System: ...
    @property
    def kind(self) -> str: ...
    @property
    def coordinates(self) -> list[str]: ...
    @property
    def parameters(self) -> list[str]: ...
    @property
    def hamiltonian(self) -> MFraction | None: ...
    def to_text(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    def latex(self) -> str: ...
    def equations(self, sympy: bool = False) -> dict[str, Any]: ...
    def variational_equations(self) -> Any: ...  # a SymPy matrix
    def classify(self, *, degree: int | None = None, search: bool = True, set: Mapping[Name, Formula] | None = None,
                 timeout: float | None = 60, max_work: float | None = None) -> Classification: ...
    def check(self, **options: Any) -> CheckReport: ...
    def with_manifolds(self, manifolds: Any = None) -> System: ...
    def integrals(self, degree: int = 2, **options: Any) -> IntegralSearch: ...
    def find_manifolds(self, *, timeout: float | None = 60, max_work: float | None = None) -> list[FoundManifold]: ...
    def section(self, section: Formula, levels: Mapping[Formula, Formula] | None = None, *, plot: Sequence[Formula],
                range: Any = None, grid: Sequence[int] | None = None, seeds: Any = None, random: int | None = None, states: Any = None,
                crossings: int | None = None, time: Formula | None = None, threads: int = 1,
                progress: Callable[[int, int], Any] | None = None, timeout: float | None = None, **more: Any) -> SystemSection: ...


def hamiltonian(H: Formula, coordinates: Names, momenta: Names, *, parameters: Names | None = None,
                manifolds: Mapping[str, Any] | Sequence[Mapping[str, Any]] = (), assume: Sentences | None = None,
                title: str = "", set: Mapping[Name, Formula] | None = None) -> str: ...


def map(questions: Iterable[str | Mapping[str, Any]] | PathLike[str], *, out: Path | None = None, client: Any = None,
        jobs: int | None = None, chunk: int = 32, options: Sequence[str] = (),
        command: str | None = None) -> list[dict[str, Any]] | PathLike[str]: ...


class Scan:
    values: Any
    shape: tuple[int, ...]
    path: PathLike[str]


def scan(path: Path, *, scene: str | None = None, out: Path | None = None, client: Any = None, jobs: int | None = None,
         parts: int | None = None, command: str | None = None) -> Scan: ...


def to_sympy(value: Any, symbols: Iterable[Any] = ()) -> Any: ...
