#pragma once
// The format kovacic-jets/1 as plain data, with its JSON reader and writer, and its judge: a natural system of two
// degrees of freedom (in an invariant subspace, if there are more), a line of configurations, the series of its
// variational equations at a place over infinity, the residue at which the first logarithm appears, and why the
// group of the normal equation is infinite.  docs/theory/jet_certificates.md defines every entry (names in
// comments are its rules).  Nothing is checked beyond syntax and limits when it is read.

#include "certify/system/check.hpp"

#include <array>

namespace kov::certify {

/// J1.  q = start + x across + y along; masses m_i: H = (p1^2/m1 + p2^2/m2)/2 + V.
struct JetLine {
  std::array<CurveFunction, 2> start, across, along, masses;
  std::array<CurveFunction, 2> inertias; ///< of x and y
};

/// sum of c[i] s^(low + i), + O(s^end); as it is made, exactly 0.
struct LocalSeries {
  static constexpr long exact = 1L << 40; ///< the end of a finite sum
  long low = 0;
  CurveRow c;
  long end = exact;

  [[nodiscard]] bool is_exact_zero() const { return c.empty() && end == exact; }
  /// Below this exponent there is nothing.
  [[nodiscard]] long start() const { return c.empty() ? end : low; }
};

/// J6.  cofactor times the minor of these columns is value^power; value is free of constants and
/// not 0.
struct JetMinor {
  std::vector<long> columns; ///< powers of c1: three, or one for ByHomogeneity
  CurveFunction cofactor, value;
  long power = 1;
};

// J7: why the group of the normal equation is infinite.
struct ByFirstFamily {};
struct ByHomogeneity {};
/// first v' + second v'' = 1, polynomials in y
struct ByEquilibria {
  CurveRow first, second;
};
/// At this value of e; with its energy h, first (h - v) + second v' = 1.
struct ByGroup {
  Rational e;
  CurveRow first, second;
  Certificate certificate;
};
using WhyInfinite = std::variant<ByFirstFamily, ByHomogeneity, ByEquilibria, ByGroup>;

struct JetsCertificate {
  std::string title;
  /// With e for the variable z, and the parameters, c1, c2 after it; the tower has the algebraic
  /// constants.  Of the rest nothing is used.
  PhaseCurve field;
  /// Positions and their momenta, those after the first two 0 on an invariant subspace; parameters, algebraic
  /// constants.
  PhaseSystem system;
  JetLine line;
  long turns = 1; ///< d: t = s^d
  CurveFunction time_scale;
  LocalSeries solution;
  std::array<LocalSeries, 2> normal;
  std::vector<LocalSeries> across, along; ///< of degree 2, ..., order - 1 in c1, c2
  long order = 2;
  CurveFunction form;
  JetMinor obstruction;
  WhyInfinite group;

  [[nodiscard]] std::size_t e() const { return field.z(); }
  [[nodiscard]] std::size_t c1() const { return field.ring->size() - 2; }
  [[nodiscard]] std::size_t c2() const { return field.ring->size() - 1; }
};

/// Throws InvalidArgument (one sentence, with the path of the offending entry) on anything that is
/// not a certificate of this format or exceeds its limits.
[[nodiscard]] JetsCertificate read_jets_certificate(std::string_view text);
[[nodiscard]] std::string write_jets_certificate(const JetsCertificate& c);

struct JetsAccepted {
  std::size_t trusted = 0; ///< steps of the inner certificate that are taken on faith
  Rational energy;         ///< with ByGroup
};

/// Never throws.  Rejected::step is the rule.
/// Cost  counted polynomial products (Arithmetic)
[[nodiscard]] std::variant<JetsAccepted, Rejected> check_jets(const JetsCertificate& c);

/// The lines of section 5.  Requires a certificate that was accepted, with what was found.
[[nodiscard]] std::vector<std::string> statement(const JetsCertificate& c,
                                                 const JetsAccepted& found);

} // namespace kov::certify
