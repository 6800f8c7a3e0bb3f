#include "certify/loops/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/loops/continuation.hpp"
#include "exact/lists.hpp"
#include "exact/rational_function.hpp"
#include "proof/text/checked.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"

#include <algorithm>

namespace kov::certify {
namespace {

class LoopsCheck {
public:
  LoopsCheck(const LoopsCertificate& c, std::string& rule)
      : c_(c), rule_(rule), precision_(2 * c.bits) {}

  Accepted operator()() {
    const auto* not_abelian = std::get_if<ShowsNotAbelian>(&c_.shows);
    if (not_abelian != nullptr) {
      rule_ = "L4";
      find_order(*not_abelian);
    }
    rule_ = "L1";
    find_matrices();
    CheckedSteps::add_labels("kovacic-loops/1", {"L1"});
    if (not_abelian != nullptr) {
      check(*not_abelian);
      CheckedSteps::add_labels("kovacic-loops/1", {"L4"});
    } else {
      check(std::get<ShowsSl2>(c_.shows));
    }
    CheckedSteps::add({"kovacic-loops/1", "by", not_abelian ? "not-abelian" : "sl2"});
    return {trusted_};
  }

private:
  // ---- L1

  void find_matrices() {
    double work = max_loop_work;
    need(!c_.loops.front().empty(), "a loop is empty");
    const LoopPoint& base = c_.loops.front().front();
    const auto is_base = [&](const LoopPoint& p) { return p.x == base.x && p.y == base.y; };
    for (const Polygon& p : c_.loops)
      need(p.size() >= 3 && is_base(p.front()) && is_base(p.back()),
           "a loop is not closed at the base point");
    for (const Polygon& p : c_.loops)
      loops_.push_back(along(c_.rows, p, c_.bits, work));
    FileMeter::charge(max_products * (1 - work / max_loop_work), 0);
  }

  [[nodiscard]] Enclosures times(const Enclosures& a, const Enclosures& b) const {
    Enclosures c(a.size());
    acb_mat_mul(c.raw(), a.raw(), b.raw(), precision_);
    return c;
  }
  [[nodiscard]] Enclosures product(const LoopWord& w) const {
    need(!w.empty() && w.size() <= max_loop_letters, "a word is out of range");
    Enclosures m(static_cast<long>(c_.rows.size()));
    acb_mat_one(m.raw());
    for (const std::size_t i : w) {
      need(i < loops_.size(), "a word is out of range");
      const Enclosures next = times(loops_[i], m);
      acb_mat_set(m.raw(), next.raw());
    }
    return m;
  }

  // ---- L2

  [[nodiscard]] ComplexBall trace(const Enclosures& a) const {
    ComplexBall t;
    acb_mat_trace(t.raw(), a.raw(), precision_);
    return t;
  }
  [[nodiscard]] ComplexBall determinant(const Enclosures& a) const {
    ComplexBall d;
    acb_mat_det(d.raw(), a.raw(), precision_);
    return d;
  }
  static Enclosures adjugate(const Enclosures& a) {
    Enclosures b(2);
    acb_set(b.at(0, 0), a.at(1, 1));
    acb_set(b.at(1, 1), a.at(0, 0));
    acb_neg(b.at(0, 1), a.at(0, 1));
    acb_neg(b.at(1, 0), a.at(1, 0));
    return b;
  }
  [[nodiscard]] Enclosures square(const LoopWord& w) const {
    const Enclosures a = product(w);
    return times(a, a);
  }

  void check(const ShowsSl2& s) {
    rule_ = "L2";
    need(c_.rows.size() == 2, "the size is not 2");
    const Enclosures a = square(s.a), b = square(s.b), c = product(s.c);
    ComplexBall commutator = trace(times(times(a, b), times(adjugate(a), adjugate(b))));
    ComplexBall dets = determinant(a);
    acb_mul(dets.raw(), dets.raw(), determinant(b).raw(), precision_);
    acb_mul_2exp_si(dets.raw(), dets.raw(), 1);
    acb_sub(commutator.raw(), commutator.raw(), dets.raw(), precision_);
    need(acb_contains_zero(commutator.raw()) == 0, "A^2 and B^2 may have a common line");
    need(is_of_no_small_order(trace(c), determinant(c)), "C may be of a small order");
  }

  // (x^2 - 3 x d + d^2) x (x - d)(x - 2 d)(x - 4 d) != 0, x = t^2
  [[nodiscard]] bool is_of_no_small_order(const ComplexBall& t, const ComplexBall& d) const {
    ComplexBall x, factor, value;
    acb_sqr(x.raw(), t.raw(), precision_);
    acb_mul_si(factor.raw(), d.raw(), 3, precision_);
    acb_sub(factor.raw(), x.raw(), factor.raw(), precision_);
    acb_mul(value.raw(), factor.raw(), x.raw(), precision_);
    acb_addmul(value.raw(), d.raw(), d.raw(), precision_);
    for (const long k : {0, 1, 2, 4}) {
      acb_mul_si(factor.raw(), d.raw(), k, precision_);
      acb_sub(factor.raw(), x.raw(), factor.raw(), precision_);
      acb_mul(value.raw(), value.raw(), factor.raw(), precision_);
    }
    return acb_contains_zero(value.raw()) == 0;
  }

  // ---- L3

  [[nodiscard]] Enclosures power(const LoopElement& e) const {
    need(e.power >= 1 && e.power % to_long(order_) == 0, "a power is not proved to be unipotent");
    Enclosures m = product(e.word);
    acb_mat_pow_ui(m.raw(), m.raw(), static_cast<ulong>(e.power), precision_);
    return m;
  }

  void check(const ShowsNotAbelian& s) {
    rule_ = "L3";
    const Enclosures a = power(s.a), b = power(s.b);
    need(s.row < c_.rows.size() && s.column < c_.rows.size(), "an entry is out of range");
    Enclosures c = times(a, b);
    acb_mat_sub(c.raw(), c.raw(), times(b, a).raw(), precision_);
    need(acb_contains_zero(c.at(static_cast<long>(s.row), static_cast<long>(s.column))) == 0,
         "the entry may be 0");
  }

  // ---- L4

  [[nodiscard]] RationalFunction entry(std::size_t i, std::size_t j) const {
    return {c_.rows[i].num[j], c_.rows[i].den};
  }

  void find_order(const ShowsNotAbelian& s) {
    std::vector<std::size_t> seen;
    for (const LoopBlock& b : s.blocks) {
      need(b.unknowns.size() == 1 || b.unknowns.size() == 2, "a block is larger than 2");
      for (const std::size_t i : b.unknowns) {
        need(i < c_.rows.size() && !is_among(i, seen), "the blocks are not a partition");
        seen.push_back(i);
      }
      for (const std::size_t i : b.unknowns)
        for (std::size_t j = 0; j < c_.rows.size(); ++j)
          need(is_zero(c_.rows[i].num[j]) || is_among(j, seen), "the blocks are in another order");
      order_ = lcm(order_, b.unknowns.size() == 1 ? order_of_one(b) : order_of_two(b));
      need(!(Integer(max_loop_power) < order_), "the orders are too large");
    }
    need(seen.size() == c_.rows.size(), "the blocks are not a partition");
  }

  // m with exp(int f)^m rational: f = sum e q'/q, m the common denominator of all e.
  static Integer radical(const RationalFunction& f, const std::vector<RadicalFactor>& factors) {
    need(factors.size() <= max_loop_factors, "too many factors");
    RationalFunction sum(0);
    Integer m(1);
    for (const RadicalFactor& x : factors) {
      need(degree(x.q) > 0, "a factor is constant");
      sum += RationalFunction(x.e) * RationalFunction(derivative(x.q), x.q);
      m = lcm(m, x.e.den());
    }
    need(f == sum, "the logarithmic derivative is another one");
    return m;
  }

  [[nodiscard]] Integer order_of_one(const LoopBlock& b) const {
    need(!b.certificate, "a certificate of a block of order 1");
    return radical(entry(b.unknowns[0], b.unknowns[0]), b.factors);
  }

  // y1'' + p y1' + q y1 = 0 of the block (a b; c d).
  [[nodiscard]] Integer order_of_two(const LoopBlock& block) {
    const std::size_t i = block.unknowns[0], j = block.unknowns[1];
    const RationalFunction a = entry(i, i), b = entry(i, j), c = entry(j, i);
    need(!is_zero(b), "the block is triangular");
    const RationalFunction e = derivative(b) / b + entry(j, j);
    const RationalFunction p = -(a + e), q = -(derivative(a) + b * c - a * e);
    const RationalFunction half(Rational(1, 2));
    const RationalFunction r = half * half * p * p + half * derivative(p) - q;
    const Integer m = radical(-half * p, block.factors);
    need(block.certificate.has_value(), "a certificate is missing");
    const Certificate& inner = *block.certificate;
    trusted_ += found_within(certify::check(inner)).trusted_steps;
    need(inner.field->is_rational() ||
             inner.field->minpoly_coefficients() == c_.field->minpoly_coefficients(),
         "the equation is over another field");
    const Poly num = moved(inner.num), den = moved(inner.den);
    need(!is_zero(den) && r == RationalFunction(num, den),
         "the certificate is about another equation");
    return lcm(m, order_of(inner.claim));
  }

  // The same coefficients in the field of the system.
  [[nodiscard]] Poly moved(const Poly& f) const {
    Poly out(c_.field);
    for (long k = 0; k <= degree(f); ++k) {
      const NfElem x = f.coeff(k);
      NfElem y(x.coeff(0));
      if (x.field()->degree() == 2) y += NfElem(x.coeff(1)) * NfElem::generator(c_.field);
      out.set_coeff(k, y);
    }
    return out;
  }

  // The orders of the eigenvalues of all elements divide it.
  static Integer order_of(const Claim& claim) {
    need(claim.group.has_value(), "the group is not finite, cyclic or T");
    const std::string& g = *claim.group;
    if (g == "A4") return Integer(12);
    if (g == "S4") return Integer(24);
    if (g == "A5") return Integer(60);
    need(g == "cyclic" || g == "T" || g == "D", "the group is not finite, cyclic or T");
    need(claim.n && Integer(0) < *claim.n, "the group has no order");
    return g == "D" ? lcm(Integer(2) * *claim.n, Integer(4)) : *claim.n;
  }

  const LoopsCertificate& c_;
  std::string& rule_; ///< the one that was last begun
  long precision_;
  std::vector<Enclosures> loops_;
  Integer order_{1};
  std::size_t trusted_ = 0;
};

} // namespace

std::variant<Accepted, Rejected> check_loops(const LoopsCertificate& c) {
  const CheckedSteps::File file;
  std::string rule;
  return verdict_at(rule, [&] { return LoopsCheck(c, rule)(); });
}

std::vector<std::string> statement(const LoopsCertificate& c) {
  std::vector<std::string> lines{"the system " + quoted(c.title) +
                                 (c.field->is_rational() ? "" : ", a^2 + 1 = 0")};
  for (std::size_t i = 0; i < c.rows.size(); ++i) {
    std::string terms;
    for (std::size_t j = 0; j < c.rows[i].num.size(); ++j)
      if (!is_zero(c.rows[i].num[j]))
        terms += (terms.empty() ? "(" : " + (") + over_field(c.rows[i].num[j]) + ") y" +
                 std::to_string(j + 1);
    lines.push_back("  (" + over_field(c.rows[i].den) + ") y" + std::to_string(i + 1) +
                    "' = " + (terms.empty() ? "0" : terms));
  }
  lines.emplace_back(std::holds_alternative<ShowsSl2>(c.shows)
                         ? "has a differential Galois group that is SL(2, C) up to scalars: its "
                           "image in PGL(2, C) is everything"
                         : "has a differential Galois group whose identity component is not "
                           "abelian");
  return lines;
}

} // namespace kov::certify
