#pragma once
// The proof of the verdict on a stratum, and what is left open, as values: the report (words.hpp)
// and the certificate (leaf_certificate.hpp) are two renderings of them.  Places are given by their
// number in the scheme of the leaf.
//
// Source  docs/theory/strata.md, 3 to 8

#include "certify/strata/certificate.hpp"
#include "closed/criteria.hpp"
#include "decide/decide.hpp"
#include "strata/bounds.hpp"

namespace kov::strata {

/// The theorem that was used.  `certificate`: the rule of strata_certificates.md 6 and 7, if it has
/// one.
/// Example std::get<Leaf>(decide_leaf(z + a, 0, everywhere)).by  // -> Conclusion::torus
enum class Conclusion : std::uint8_t {
  none,             ///< nothing was decided
  number,           ///< an equation without parameters (certificate: number)
  invariant,        ///< a symmetric power has a rational solution (invariant)
  half_integers,    ///< exponents in Z/2, no logarithm (invariant, where one of degree 2 was found)
  torus_log,        ///< a torus and a unipotent matrix (torus-log)
  irreducible_log,  ///< no exponential solution, and a logarithm (irreducible-log)
  torus,            ///< a torus, and Sym^4 without solution (torus)
  rational,         ///< all Delta rational, no invariants (rational)
  one_open,         ///< one Delta depends on the parameters and is bounded (one-open)
  several_open,     ///< several are (open)
  separated,        ///< three places, two differences irrational (separated)
  no_products,      ///< a torus, and no exponents of y1 y2 whatever Delta is
  assumed_integers, ///< a torus, and Delta or 2 Delta is assumed to be no integer
  classical,        ///< the closed answer of a classical equation
  not_special,      ///< what an abelian component needs of the exponents fails (strata.md 6.4)
  other_blocks      ///< there is another equation here: what was decided of it
};

// ---- places

struct IrregularPlace {
  PlaceIndex place = 0;
};
struct IrrationalDifference { ///< how it is known: ParametricPlace::irrational
  PlaceIndex place = 0;
};
struct Logarithm { ///< at every root of the place
  PlaceIndex place = 0;
};
struct DifferenceBound { ///< Delta^2 <= square, where it is real
  PlaceIndex place = 0;
  Rational square;
};
struct ExcludedDifferences { ///< Delta is none of these
  PlaceIndex place = 0;
  std::vector<Rational> values; ///< ascending
};
struct NoProducts { ///< no exponents of y1 y2, whatever Delta is there
  PlaceIndex place = 0;
};
struct AssumedNotInteger { ///< by assumption: Delta, or 2 Delta
  PlaceIndex place = 0;
  bool twice = false;
};

/// Two differences d1, d2 are irrational and the third is nowhere a natural number n with +-d1 +- d2
/// among n - 1, n - 3, ..., 1 - n.
struct SeparatedNowhere {
  std::vector<PlaceIndex> pair; ///< one place with two roots, or two places
  PlaceIndex third = 0;
  std::optional<certify::Growth> growth; ///< d1^2 and d2^2 are conjugate, and grow with n
  std::optional<Rational> bound;         ///< of the square of the third difference
  std::vector<MPoly> nonzero;            ///< excludes the values of n that are left
};

// ---- solutions

struct NoExponential { ///< bound.excludes()
  ExponentialBound bound;
};
/// No exponents of an exponential solution leave a natural number for the degree, or none with a polynomial part
/// of that degree.
struct NoFamilies {};
struct NoInvariant { ///< Sym^m has no rational solution: the exponents say it, or minors
  long m = 0;
  InvariantBound bound;
  std::optional<Excluded> excluded{}; ///< set where bound.form is
};
struct ExponentialFound { ///< y'/y = w for all parameters
  MFraction w;
};
struct InvariantFound {
  ParametricInvariant v;
};

// ---- closed answers and other equations

struct Number {
  Decision decision;
};
/// A verdict on other equations than r: shown to the user; no code reads it.
struct OtherBlocks {
  std::string shown;
  bool irregular = true; ///< a place of what decided, or it is not known
};
/// The equation that was decided is not the one of the question: shown to the user; no code reads it.
struct OfEquation {
  std::string unknown;
  MFraction r;
};

// ---- what is left open

struct NoEquation { ///< r does not mean anything here
  enum class Why : std::uint8_t { no_value, reduction, no_level };
  Why why = Why::no_value;
  std::string shown{}; ///< in the words of who made the reduction
};
struct NotSolved { ///< p = 0 is not solved for a parameter
  MPoly p;
  Event why;
};
/// Abelian only if some 2 Delta is an integer at these places or, without a torus, all Delta are
/// rational.
struct SomeDifference {
  std::vector<PlaceIndex> places;
  bool torus = false;
};
struct RationalDifference { ///< only if Delta is rational there
  PlaceIndex place = 0;
};
struct IntegralDifference { ///< only if Delta, or 2 Delta, is a positive integer there
  PlaceIndex place = 0;
  bool twice = false;
};
/// Only where these vanish together, or: another symmetric power of degree m has a solution; or the
/// differences are special.
struct MinorsVanish {
  std::vector<MPoly> together;
  std::variant<std::monostate, long, SomeDifference> otherwise{};
};
struct TooManyUnknowns { ///< of Sym^m
  long m = 0, degree = 0;
};
struct LargeDenominator { ///< of the exponents
  Integer n;
};
struct OpenNumber {}; ///< Number says why
struct ByParts {};    ///< exactly on some of Leaf::parts
struct RefusedByChecker {
  std::string shown;
};
/// The equation is decided, and is not all of the question: shown to the user; no code reads it.
struct NotStudied {
  std::string shown;
};

using OpenReason = std::variant<NoEquation, NotSolved, SomeDifference, RationalDifference,
                                IntegralDifference, MinorsVanish, TooManyUnknowns, LargeDenominator,
                                OpenNumber, ByParts, RefusedByChecker, NotStudied>;

/// A necessary condition of an abelian component (an OpenReason "abelian only if") does not hold.
struct ConditionFails {
  OpenReason condition;
};

using AnyEvidence =
    std::variant<IrregularPlace, IrrationalDifference, Logarithm, DifferenceBound,
                 ExcludedDifferences, NoProducts, AssumedNotInteger, SeparatedNowhere,
                 NoExponential, NoFamilies, NoInvariant, InvariantFound, ExponentialFound,
                 ClassicalForm, ConditionFails, Number, OtherBlocks, OfEquation>;

/// The variant for std::visit and std::get_if.  It is copied and destroyed in evidence.cpp, and not in each
/// file that does so: that takes seconds of the compiler.
struct Evidence : AnyEvidence {
  using AnyEvidence::AnyEvidence;
  Evidence(const Evidence&);
  Evidence(Evidence&&) noexcept;
  Evidence& operator=(const Evidence&);
  Evidence& operator=(Evidence&&) noexcept;
  ~Evidence();
};

} // namespace kov::strata
