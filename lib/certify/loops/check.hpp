#pragma once
// The format kovacic-loops/1 as plain data, with its JSON reader and writer, and its judge: a system
// Y' = A(z) Y over Q(z) or Q(i)(z), closed polygons, words in them, and what strict inequalities
// between the matrices of the words show.  docs/theory/loop_certificates.md defines every entry
// (names in comments are its rules).  Nothing is checked beyond syntax and limits when it is read.

#include "certify/equation/check.hpp"
#include "proof/text/json_node.hpp"

namespace kov::certify {

/// den Y_i' = sum num_j Y_j
struct LoopRow {
  Poly den;
  std::vector<Poly> num;
};

/// x + i y, dyadic.
struct LoopPoint {
  Rational x, y;
};
using Polygon = std::vector<LoopPoint>;

/// Indices of polygons, the first one continued along first.
using LoopWord = std::vector<std::size_t>;

/// L2
struct ShowsSl2 {
  LoopWord a, b, c;
};

/// e of q in sum e q'/q.
struct RadicalFactor {
  Poly q;
  Rational e;
};
/// L4.  One unknown, or two with the certificate of the normal form of the first of them.
struct LoopBlock {
  std::vector<std::size_t> unknowns;
  std::vector<RadicalFactor> factors;
  std::optional<Certificate> certificate;
};
struct LoopElement {
  LoopWord word;
  long power = 1;
};
/// L3
struct ShowsNotAbelian {
  LoopElement a, b;
  std::size_t row = 0, column = 0;
  std::vector<LoopBlock> blocks;
};

struct LoopsCertificate {
  std::string title;
  Field field;
  std::vector<LoopRow> rows;
  long bits = 0;
  std::vector<Polygon> loops; ///< L1
  std::variant<ShowsSl2, ShowsNotAbelian> shows;
};

/// Throws InvalidArgument (one sentence, with the path of the offending entry) on anything that is
/// not a certificate of this format or exceeds its limits.
[[nodiscard]] LoopsCertificate read_loops_certificate(std::string_view text);
[[nodiscard]] LoopsCertificate read_loops_certificate(const Node& n);
[[nodiscard]] std::string write_loops_certificate(const LoopsCertificate& c);
[[nodiscard]] Json to_json(const LoopsCertificate& c);

/// Accepts one or names the first rule that fails; continues along the polygons by itself.  Never throws.
/// Cost  a Taylor series of about `bits` terms for each segment and each unknown
[[nodiscard]] std::variant<Accepted, Rejected> check_loops(const LoopsCertificate& c);
/// The lines of section 5.  Requires a certificate that was accepted.
[[nodiscard]] std::vector<std::string> statement(const LoopsCertificate& c);

} // namespace kov::certify
