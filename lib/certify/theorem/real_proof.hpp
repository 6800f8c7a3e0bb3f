#pragma once
// Signs over the reals: a NODE proves that no real point satisfies all conditions of a list.
// theorem_certificates.md 2.

#include "certify/strata/arithmetic.hpp"
#include "certify/system/certificate.hpp"

#include <functional>

namespace kov::certify {

using Conditions = std::vector<Condition>;

/// The same sign, with coprime integer coefficients.
[[nodiscard]] Condition primitive(const Condition& c);
/// [{"p": P, "sign": SIGN}, ...]
[[nodiscard]] Conditions read_conditions(const Ring& ring, const Node& n);

class RealProof {
public:
  /// Takes nodes of other kinds than those of section 2.
  using Leaf = std::function<void(const Node&, Conditions&)>;

  /// real: by variable of the ring, which names may occur; complex: these, and they need not be real.
  RealProof(Ring ring, std::vector<bool> real, Arithmetic& a, std::size_t& nodes_left,
            std::vector<bool> complex = {})
      : ring_(std::move(ring)), real_(std::move(real)), complex_(std::move(complex)), a_(a),
        left_(nodes_left) {
    complex_.resize(ring_->size(), false);
  }

  /// Refuses a node that does not prove that there is no point.
  /// given: longer in between, not copied for each node
  void refute(const Node& n, Conditions& given, const Leaf& leaf = {}, int depth = max_node_depth);
  /// The same for the conditions and the negation of c.
  void show(const Condition& c, const Node& n, Conditions& given);

private:
  struct Term {
    Rational c;
    MPoly f;
    bool strict = false; ///< f is nowhere 0
    bool real = true;    ///< f >= 0 at each point
  };

  void refute_with(Condition more, const Node& n, Conditions& given, const Leaf& leaf, int depth);
  void contradiction(const Node& n, const Conditions& given);
  [[nodiscard]] Term term(const Node& n, const Conditions& given);
  [[nodiscard]] MPoly poly(const Node& n) const;
  [[nodiscard]] bool is_real(const MPoly& f) const;
  /// At each point with these conditions.
  [[nodiscard]] bool is_real(const MPoly& f, const Conditions& given) const;
  static const Condition& at(const Node& n, const Conditions& given);

  static constexpr int max_node_depth = 64;

  Ring ring_;
  std::vector<bool> real_, complex_;
  Arithmetic& a_;
  std::size_t& left_;
};

} // namespace kov::certify
