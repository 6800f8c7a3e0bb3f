#pragma once
// The certificate format kovacic-strata/1 as plain data, with its JSON reader and writer: a tree of
// strata of parameter values, each leaf with its own proof.  docs/theory/strata_certificates.md
// defines every entry (numbers in comments are its sections); strata_check.hpp is the judge.
// Nothing here is checked beyond syntax and the limits of section 2.

#include "certify/equation/certificate.hpp"
#include "proof/condition/condition.hpp"

#include <cstdint>
#include <memory>

namespace kov::certify {

// ---- 5: lemmas

struct LemmaTerm { ///< c > 0 times powers of conditions and squares q^(2e)
  Rational c{1};
  std::vector<std::pair<std::size_t, unsigned long>> powers{};
  std::vector<std::pair<MPoly, unsigned long>> squares{};
};
/// The value that a membership would have and has not.
struct Violation {
  std::size_t membership = 0;
  Rational value;
};
struct Lemma { ///< p times = sum of the terms; without terms: p times is known to be nonzero
  MPoly p;
  std::optional<MPoly> times{};
  bool positive = false;
  std::optional<std::vector<LemmaTerm>> terms{};
  std::optional<Violation> violation{}; ///< where p = 0
  std::optional<mp_limb_t> prime{};     ///< modulo which p has no root
};

// ---- 6, 7: what a leaf proves and from what

struct ByNumber {
  Certificate certificate;
};
struct InvariantPlace {
  MPoly q;
  long order = 0;
  Integer e;
};
struct ByInvariant { ///< v = p prod q^e solves Sym^m
  MPoly content, p;
  std::vector<InvariantPlace> places;
  long m = 0;
};

struct StratumPlace {
  std::optional<MPoly> q{}; ///< unset at infinity
  long order = 0;           ///< as stated; at infinity it is computed
  std::vector<MPoly> chi{}; ///< empty: not given
  std::optional<std::string> irrational{};
  bool log = false;
  std::optional<Rational> bound{};
};
struct Minor {
  std::vector<long> rows;
  MPoly times;
};
struct AbsentInvariant {
  long m = 0;
  std::vector<Minor> minors;
  std::optional<mp_limb_t> prime; ///< shows that the minors have no common root
};
/// The bound of growth in `separated`, with d1^2 and d2^2 conjugate complex numbers:
/// 2 (d1^2 + d2^2) >= factor Delta^2 - shift.
struct Growth {
  Rational factor, shift;
};
/// A row of 7.6: "torus-log", "torus", ...
[[nodiscard]] bool is_places_theorem(std::string_view id);

struct ByPlaces {
  std::string theorem;
  MPoly content;
  std::vector<StratumPlace> places; ///< the finite ones
  StratumPlace infinity;
  std::vector<AbsentInvariant> absent;
  std::optional<Growth> growth{}; ///< separated
};

/// A number that is known by its square; root: a function with this square.
struct SquaredNumber {
  Fraction square;
  std::optional<Fraction> root{};
};
/// One number that is no constant is `times` of the exponent differences of Riemann's equation; the
/// others are these.
struct OneDifference {
  std::vector<Rational> known;
  std::size_t times = 0;
  Fraction square;
};
/// 7.8: z -> change turns the classical equation y'' = equation y into the one of the stratum.
struct ByClassical {
  std::string family; ///< whittaker, bessel, riemann, lame
  Fraction change, equation;
  std::vector<MPoly> factors; ///< riemann, lame: the finite places
  std::vector<SquaredNumber> numbers;
  std::vector<ShownMembership> shown;
};

// ---- 4: nodes

struct StrataNode;
using Subtree = std::unique_ptr<const StrataNode>;

struct EmptyStratum {
  std::optional<std::vector<LemmaTerm>> terms{};
  std::optional<Violation> violation{};
};
struct OutsideStratum {
  std::optional<std::size_t> generic{};
};
struct OpenStratum {
  std::string reason;
};
struct TrustedStratum {
  std::string abelian; ///< "yes", "no", "empty"
  std::string theorem, statement;
};
struct SolvedStratum { ///< p = l x + m
  std::size_t variable = 0;
  std::optional<Fraction> r;
  Subtree then;
};
struct RootStratum {
  std::size_t variable = 0;
  Certificate certificate;
  bool abelian = false;
};
/// The node for the points with p = 0.
using WhereZero = std::variant<SolvedStratum, RootStratum, EmptyStratum, OutsideStratum,
                               OpenStratum, TrustedStratum>;

struct SplitNode {
  MPoly p;
  Subtree nonzero;
  WhereZero zero;
};
struct AssumedNode {
  std::size_t condition = 0;
  MPoly p;
  WhereZero zero;
};
struct LemmasNode {
  std::vector<Lemma> lemmas;
  Subtree then;
};
struct LeafNode {
  std::optional<bool> abelian = false; ///< unset: exactly where the criterion of ByClassical holds
  std::variant<ByNumber, ByInvariant, ByPlaces, ByClassical> by;
};

struct StrataNode {
  std::variant<SplitNode, AssumedNode, LemmasNode, LeafNode, EmptyStratum, OutsideStratum,
               OpenStratum, TrustedStratum>
      kind;
};

struct StrataCertificate {
  Ring ring;                  ///< of z and the parameters
  std::size_t variable = 0;   ///< z: the reader puts it first, and the checker takes no other place
  std::vector<bool> real;     ///< by variable; the rational ones among them
  std::vector<bool> rational; ///< by variable
  std::vector<Condition> assumptions;
  std::vector<Membership> memberships;
  std::vector<std::vector<MPoly>> generic;
  Fraction r;
  std::optional<bool> abelian; ///< what is claimed
  Subtree tree;
};

/// The value of "format" in a certificate, if the text is an object that has one: cheap, and
/// nothing else is looked at.
[[nodiscard]] std::optional<std::string> format_of(std::string_view text);

/// Throws InvalidArgument (one sentence, with the path of the offending entry) on anything that is
/// not a certificate of this format or exceeds its limits.
[[nodiscard]] StrataCertificate read_strata_certificate(std::string_view text);
[[nodiscard]] StrataCertificate read_strata_certificate(const Node& n);

/// The text that read_strata_certificate() reads.
[[nodiscard]] std::string write_strata_certificate(const StrataCertificate& c);
[[nodiscard]] Json to_json(const StrataCertificate& c);

} // namespace kov::certify
