#pragma once
// The certificate format kovacic-certificate/1 as plain data, with its JSON reader and writer.
//
// A certificate states something about the differential Galois group of y'' = r y and lists typed
// steps that prove it.  docs/theory/certificates.md defines each rule, its data and the theorem
// behind it; check.hpp is the judge.  Nothing here is checked beyond syntax.

#include "exact/modular.hpp"
#include "exact/poly.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kov::certify {

class Node;
struct Json;

/// The claims of a certificate.  Names as in the JSON: group "SL2", "Borel", "T", "Gm", "cyclic",
/// "Dinf", "D", "A4", "S4", "A5"; component "trivial", "Ga", "Gm", "Borel", "SL2".  Unset = nothing
/// is claimed.
struct Claim {
  std::optional<std::string> group;
  std::optional<Integer> n; ///< of T_n, C_n, D_n
  std::optional<std::string> component;
  std::optional<bool> abelian; ///< of the identity component
};

/// Distinct roots of q modulo a prime at which a logarithm is seen.
struct LogWitness {
  PrimeIdeal prime;
  std::vector<mp_limb_t> roots; ///< at infinity: empty
};

struct LocalPlace {
  Poly q; ///< monic, squarefree; need not be irreducible
  long order = 0;
  std::optional<Poly> delta2;           ///< order 2: Delta^2 in K[c]/q
  std::optional<Poly> eps2;             ///< even order >= 4: (beta/a)^2 in K[c]/q
  std::optional<PrimeIdeal> irrational; ///< proves Delta irrational at every root
  std::optional<LogWitness> log;
  std::optional<Poly> annihilator; ///< in Q[T], of Delta^2 or eps^2
};

struct Local {
  PrimeIdeal prime; ///< prod q stays squarefree and coprime to num
  std::vector<LocalPlace> places;
  std::optional<Poly> infinity_eps2;
  std::optional<LogWitness> infinity_log;
  std::optional<Poly> infinity_annihilator;
};

struct Exponential { ///< omega = num/den + p'/p
  Poly p = Poly(1);
  Poly num, den = Poly(1);
};

struct InvariantFactor {
  Poly q;
  Rational e;
};

struct Invariant {  ///< v = p prod q^e solves Sym^m
  PrimeIdeal prime; ///< prod q stays squarefree
  long m = 0;
  Poly p = Poly(1);
  std::vector<InvariantFactor> factors;
};

struct ApproximantLine {
  long length = 0;
  std::vector<mp_limb_t> approximant; ///< ascending; coefficients of the linear recurrence
};

/// No exponential solution.
struct ByParity {};
struct ByDegree {};
struct BySeries {
  std::optional<long> place; ///< index into Local::places; unset = infinity
  PrimeIdeal prime;
  mp_limb_t root = 0;
  mp_limb_t delta = 0;
  long terms = 0;
  std::vector<ApproximantLine> lines;
};
struct NoExponential {
  std::variant<ByParity, ByDegree, BySeries> by;
};

struct PCurvature {
  PrimeIdeal prime;
  std::string shows; ///< "nonzero", "irreducible", "sl2"
};

struct RankModP {
  PrimeIdeal prime;
  mp_limb_t x0 = 0;
  long terms = 0;
};
struct NoInvariant {
  long m = 0;
  std::variant<ByDegree, RankModP> by;
};

/// Two points of s^2 = F0 modulo p that show that h is not an l-th power.
struct NotAPower {
  long l = 0;
  PrimeIdeal prime;
  mp_limb_t w = 0, x1 = 0, s1 = 0, x2 = 0, s2 = 0;
};

/// The largest order that the rule "torsion-function" accepts.
inline constexpr long largest_torsion_order = 1000000;

struct TorsionFunction { ///< h = (a + b w s)/den, h' = n w/(V s) h
  long n = 0;
  Poly a, b, den = Poly(1);
  std::vector<NotAPower> minimal;
};

/// The curve of an imprimitive equation stays smooth modulo p: bounds the order of torsion.
struct GoodReduction {
  PrimeIdeal prime;
};

/// A row of the fixed table of certificates.md 2: "sl2-p-curvature", "borel", ...
[[nodiscard]] bool is_theorem(std::string_view id);

struct Conclude {
  std::string theorem;
};

struct ApplyTheorem { ///< trusted
  std::string theorem, statement;
};

using Rule = std::variant<Local, Exponential, Invariant, NoExponential, PCurvature, NoInvariant,
                          TorsionFunction, GoodReduction, Conclude, ApplyTheorem>;

struct Step {
  std::string id;
  std::vector<std::string> premises;
  Rule rule;
};

struct Certificate {
  Field field = rationals();
  Poly num, den = Poly(1); ///< r = num/den, coprime, den monic
  Claim claim;
  std::vector<Step> steps;
};

/// The JSON name of a rule: "local", "exponential", ...
[[nodiscard]] std::string rule_name(const Rule& rule);

/// Throws InvalidArgument (one sentence, with the path of the offending entry) on anything that is
/// not a certificate of this format.  Counts too large for a long are clamped: the judge refuses
/// them.
[[nodiscard]] Certificate read_certificate(std::string_view text);
[[nodiscard]] std::string write_certificate(const Certificate& c);

/// A certificate of the format kovacic-certificate/1 inside other data.
[[nodiscard]] Certificate read_certificate(const Node& n);
[[nodiscard]] Json to_json(const Certificate& c);
/// The field of coefficients, by its minimal polynomial.
[[nodiscard]] Field read_field(const Node& n);
[[nodiscard]] Json to_json(const NumberField& k);
/// Within other data (fields.hpp).
template <class S> void read_entry(const Node& n, Certificate& x, S& /*setting*/) {
  x = read_certificate(n);
}
template <class S> [[nodiscard]] auto write_entry(const Certificate& x, S& /*setting*/) {
  return to_json(x);
}

} // namespace kov::certify
