#pragma once
// The algebraic spectrum of y'' = r(z; E, parameters) y: for which E is there a Liouvillian solution?
//
//   closed answers   Whittaker's, Bessel's, Riemann's, ... equation: "some k +- m is in 1/2 + Z" is
//                    solved for E, a formula in an integer N (Coulomb, Morse, Poeschl-Teller, ...)
//   degrees          an exponential solution of each degree N: a polynomial in E, or a value of E
//                    (quasi-exactly solvable potentials)
//
// Source  Acosta-Humanez, Morales-Ruiz, Weil 2011; docs/theory/spectrum.md

#include "strata/decide_strata.hpp"
#include "strata/exponential_families.hpp"

namespace kov::spectrum {

/// y = (sum p_i z^i) prod base^power exp(exponent), a solution where the equations of its level hold.
struct Eigenfunction {
  std::vector<MFraction> p;
  std::vector<std::pair<MPoly, MFraction>> powers;
  MFraction exponent;
};

/// E and parameters with a solution of one degree.
struct Level {
  long n = 0;
  std::optional<std::pair<std::size_t, MFraction>> fixed; ///< a parameter (or E) and its value
  std::vector<MPoly> equations;                           ///< each = 0
  std::optional<Eigenfunction> y;
};

/// Values of E, for each integer N.  E solves `equation` = 0, of which `value` is the solution if it
/// has degree 1; where E is not in it, every E is a value at the parameters that solve it for some N.
/// All of this is in a ring of its own, which has N, and square roots by their names.
struct Series {
  MPoly equation;
  bool every_energy = false; ///< E is not in it
  std::optional<MFraction> value;
  std::size_t n = 0;             ///< N, in that ring
  std::vector<Level> first = {}; ///< eigenfunctions of the first N
};

/// All solutions of one degree condition: degree = N is a natural number.
struct DegreeFamily {
  MFraction degree;
  std::vector<Level> first; ///< those of the first N
  std::string open;         ///< what was not found or not looked at, or empty
};

/// The result on one stratum of the parameters (E among them).
struct Piece {
  enum class Status : std::uint8_t {
    no_equation, ///< r means nothing there
    none,        ///< no E: SL(2, C)
    all,         ///< every E
    conditions,  ///< exactly where one of `where` holds
    degrees,     ///< exactly where one of `families` has a solution
    open         ///< `why_open`
  };
  enum class Open : std::uint8_t {
    group,             ///< it is not known
    group_of_a_part,   ///< it is not known on one of several
    several_without,   ///< parts are without solutions
    assumed_equations, ///< which the search of exponential solutions does not know
    no_places,         ///< of the equation
    families,          ///< `ended`: why they cannot be written down
    limit              ///< `ended`: which
  };
  std::vector<Condition> conditions;
  Status status = Status::open;
  std::vector<Statement> where;    ///< an alternative each
  std::vector<Series> series;      ///< those of `where` that were solved for E
  std::vector<Statement> unsolved; ///< the others
  std::vector<DegreeFamily> families;
  std::vector<GaloisGroup> groups; ///< that occur where there are solutions
  std::optional<Open> why_open{};
  std::string ended{};
};
/// Why nothing is known; empty: something is.
[[nodiscard]] std::string open_reason(const Piece& p);

struct AlgebraicSpectrum {
  std::vector<Piece> pieces;    ///< disjoint
  std::vector<Trusted> trusted; ///< steps that no checker repeats
  strata::StrataAnswer strata;  ///< on which this rests
  [[nodiscard]] bool decided() const;
};

struct SpectrumOptions {
  long levels = 4; ///< how many N are written out
  strata::StrataLimits strata = {};
};

/// Never throws for a legal question: limits end in open pieces.
/// Errors  InvalidArgument: E is the variable
/// Given   strata::Question weber; weber.r = z * z + a;
/// Example algebraic_spectrum(weber, 1).pieces.at(0).series.size()  // -> 1
/// Example to_string(*algebraic_spectrum(weber, 1).pieces.at(0).series.at(0).value)  // -> 2*N + 1
[[nodiscard]] AlgebraicSpectrum algebraic_spectrum(const strata::Question& q, std::size_t energy,
                                                   const SpectrumOptions& options = {});

/// "(z^2 + a)*z^(1/2)*exp(-z^2/2)", up to a factor without z.
[[nodiscard]] std::string to_string(const Eigenfunction& y, std::size_t z);

} // namespace kov::spectrum
