"""What proves a verdict on a stratum, for `match`: lib/strata/evidence.hpp says what each one means."""

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True)
class IrregularPlace:
    """The equation is irregular there: the group contains a torus.

    >>> kovacic.IrregularPlace("infinity").place
    'infinity'
    """
    place: str


@dataclass(frozen=True)
class IrrationalDifference:
    """The exponent difference at this place is not rational.

    >>> kovacic.IrrationalDifference("z = 0").place
    'z = 0'
    """
    place: str


@dataclass(frozen=True)
class Logarithm:
    """At every root of the place.

    >>> kovacic.Logarithm("z = 1").place
    'z = 1'
    """
    place: str


@dataclass(frozen=True)
class DifferenceBound:
    """Delta^2 <= square, where it is real.

    >>> from fractions import Fraction
    >>> kovacic.DifferenceBound("z = 0", Fraction(9, 4)).square
    Fraction(9, 4)
    """
    place: str
    square: Fraction


@dataclass(frozen=True)
class ExcludedDifferences:
    """Delta is none of these.

    >>> from fractions import Fraction
    >>> kovacic.ExcludedDifferences("z = 0", [Fraction(1, 2)]).values
    [Fraction(1, 2)]
    """
    place: str
    values: list


@dataclass(frozen=True)
class NoProducts:
    """No exponents of y1 y2, whatever Delta is there.

    >>> kovacic.NoProducts("z = 0").place
    'z = 0'
    """
    place: str


@dataclass(frozen=True)
class AssumedNotInteger:
    """By assumption: Delta, or 2 Delta.

    >>> kovacic.AssumedNotInteger("z = 0", twice=True).twice
    True
    """
    place: str
    twice: bool


@dataclass(frozen=True)
class SeparatedNowhere:
    """Two differences d1, d2 are irrational, and the third is nowhere an integer n >= 1 with +-d1 +- d2 in n - 1, ..., 1 - n.

    >>> kovacic.SeparatedNowhere(["z^2 + 1"], "0").third
    '0'
    """
    pair: list
    third: str


@dataclass(frozen=True)
class NoExponential:
    """The degree of the polynomial part would be at most `degree` < 0, or a place has odd order.

    >>> from fractions import Fraction
    >>> kovacic.NoExponential(Fraction(-1, 2), False).degree
    Fraction(-1, 2)
    """
    degree: Fraction
    odd_order: bool


@dataclass(frozen=True)
class NoFamilies:
    """No exponents of an exponential solution leave a natural number for the degree.

    >>> kovacic.NoFamilies()
    NoFamilies()
    """


@dataclass(frozen=True)
class NoInvariant:
    """Sym^m has no rational solution.

    >>> kovacic.NoInvariant(4).m
    4
    """
    m: int


@dataclass(frozen=True)
class ExponentialFound:
    """There is an exponential solution for all parameters: y'/y = w.

    >>> kovacic.ExponentialFound("z").w
    'z'
    """
    w: object


@dataclass(frozen=True)
class InvariantFound:
    """A symmetric power has a rational solution.

    >>> kovacic.InvariantFound()
    InvariantFound()
    """


@dataclass(frozen=True)
class ClassicalForm:
    """The equation is a classical one in (z - centre)^power, whose numbers are given by squares or values.

    >>> kovacic.ClassicalForm("Whittaker", {"mu": "n^2"}, {"kappa": "n"}, "0", 1).family
    'Whittaker'
    """
    family: str
    squares: dict
    values: dict
    centre: object
    power: int


@dataclass(frozen=True)
class ConditionFails:
    """What an abelian identity component needs of the exponents does not hold.

    >>> kovacic.ConditionFails()
    ConditionFails()
    """


@dataclass(frozen=True)
class Number:
    """An equation without parameters was decided.

    >>> kovacic.Number(kovacic.solve("z")).decision.group
    GaloisGroup('SL2')
    """
    decision: object


@dataclass(frozen=True)
class OtherBlocks:
    """A verdict on other equations than r.

    >>> kovacic.OtherBlocks("the block of x, u").shown
    'the block of x, u'
    """
    shown: str


@dataclass(frozen=True)
class OfEquation:
    """The equation that was decided is not the one of the question.

    >>> kovacic.OfEquation("u", "z").unknown
    'u'
    """
    unknown: str
    r: object


@dataclass(frozen=True)
class Loop:
    """Counterclockwise around one singularity.  matrix: midpoints; decimals: (re, im) as text,
    every entry within `radius` of it."""
    place: str
    matrix: list
    decimals: list
    radius: str
