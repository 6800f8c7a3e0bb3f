// The lowest-order system of a family: theorem_certificates.md 7.

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <set>

namespace kov::certify {

namespace {

// Refuses unless Y is the lowest-order system of X.
class LowestOrder {
public:
  LowestOrder(const Family& x, const Family& y, Keys& k, Arithmetic& a, std::size_t& nodes_left)
      : x_(x), y_(y), k_(k), a_(a), nodes_(nodes_left) {}

  void operator()() {
    const PhaseSystem &s = x_.system, &t = y_.system;
    need_same_names();
    read_weights(k_.at("weights"));
    need_bracket();
    const long degree = natural(k_.at("degree"), "a degree is out of range");
    need(orders(t.hamiltonian->p).is(degree), "not homogeneous");
    need_units();
    need_difference(degree, s);
  }

private:
  void need_same_names() const {
    const PhaseSystem &s = x_.system, &t = y_.system;
    const auto names = [](const PhaseSystem& z) { // without the inverses
      auto all = z.ring->names();
      all.erase(all.begin() + static_cast<long>(z.first_inverse()),
                all.begin() + static_cast<long>(z.first_parameter()));
      return all;
    };
    need(s.dimension == t.dimension && names(s) == names(t), "other names");
    const Conditions assumed = x_.renamed(y_.assumptions);
    for (const Condition& c : assumed)
      need(is_among(c, x_.assumptions), "it assumes more");
    need(s.brackets.size() == t.brackets.size(), "another bracket");
    for (std::size_t i = 0; i < s.brackets.size(); ++i) {
      const PhaseBracket &b = s.brackets[i], &c = t.brackets[i];
      need(b.first == c.first && b.second == c.second && b.value.n == c.value.n &&
               has_no_inverse(t, c.value.p) && in_ring(c.value.p, s.ring) == b.value.p,
           "another bracket");
    }
  }

  static bool has_no_inverse(const PhaseSystem& s, const MPoly& f) {
    const auto used = used_variables(f);
    return std::ranges::none_of(
        used, [&](std::size_t i) { return i >= s.first_inverse() && i < s.first_parameter(); });
  }

  void read_weights(const Node& n) {
    const auto rows = n.items(x_.system.dimension, "a weight for each coordinate is expected");
    for (const Node& w : rows) {
      const long x = w.count();
      if (x < 1 || x > 1000) w.fail("a weight of 1 or more is expected");
      weights_.push_back(x);
    }
  }
  static long natural(const Node& n, const char* why) {
    const long x = n.count();
    if (x < 0 || x > 1000000) n.fail(why);
    return x;
  }
  [[nodiscard]] WeightRange orders(const MPoly& f) const { return weights_of(f, weights_); }

  void need_bracket() const {
    std::set<long> shifts;
    const PhaseSystem& s = x_.system;
    for (const PhaseBracket& b : s.brackets) {
      need(has_no_inverse(s, b.value.p), "the bracket mixes orders");
      for (long t = 0; t < b.value.p.length(); ++t)
        shifts.insert(weights_[b.first] + weights_[b.second] -
                      weight_of(b.value.p.exponents(t), weights_));
    }
    need(shifts.size() <= 1, "the bracket mixes orders");
  }

  // The denominators of Y: free of coordinates, and not 0 at any admitted point of X.
  void need_units() {
    const auto rows =
        k_.at("units").items(y_.system.inverses.size(), "a node for each denominator is expected");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const MPoly& h = y_.system.inverses[i];
      need(orders(h).is(0), "not a polynomial");
      show({in_ring(h, x_.system.ring), Sign::nonzero}, rows[i]);
    }
  }
  // From the assumptions of X.
  void show(const Condition& c, const Node& by) {
    ConditionSet given = x_.where(x_.assumptions, a_);
    SetProof(given, nodes_).show(c, by);
  }

  // The orders of the inverses of X, and what they add for this polynomial.
  long read_orders(const MPoly& difference) {
    const PhaseSystem& s = x_.system;
    const auto rows =
        k_.at("orders").items(s.inverses.size(), "an order for each inverse is expected");
    long sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Keys row(rows[i]);
      const std::size_t u = s.first_inverse() + i;
      if (row.at("inverse").text() != s.ring->name(u)) rows[i].fail("another inverse is expected");
      const long order = natural(row.at("order"), "an order is out of range");
      const MPoly part = read_poly(s.ring, row.at("part"), x_.parameters());
      need(orders(s.inverses[i]).lowest >= order, "an order is another one");
      need(has_part(s.inverses[i], order, part), "no such part of lowest order");
      show({part, Sign::nonzero}, row.at("by"));
      row.done();
      sum += std::max(0L, kov::degree(difference, u)) * order;
    }
    return sum;
  }
  [[nodiscard]] bool has_part(const MPoly& h, long order, const MPoly& part) const {
    std::vector<bool> coordinates(h.ring()->size(), false);
    std::fill_n(coordinates.begin(), weights_.size(), true);
    const auto all = parts_by(h, coordinates);
    return std::ranges::any_of(all, [&](const auto& x) {
      return weight_of(x.first, weights_) == order && x.second == part;
    });
  }

  // The names of X, then the inverses of Y.
  void need_difference(long degree, const PhaseSystem& s) {
    const PhaseSystem& t = y_.system;
    auto names = s.ring->names();
    for (const std::string& name : inverse_names(s.ring, t))
      names.push_back(name);
    need(names.size() <= 64, "too many names");
    const Ring both = make_ring(names);
    const Functions in(both, a_);
    const auto ours = [&](const PhaseFunction& f) { return in.composed(f, images(s, both, 0)); };
    const auto theirs = [&](const PhaseFunction& f) {
      return in.composed(f, images(t, both, s.ring->size()));
    };
    MPoly f = in.minus(ours(*s.hamiltonian), theirs(*t.hamiltonian)).p;
    const long bound = degree + read_orders(f);
    for (std::size_t i = 0; i < s.inverses.size(); ++i)
      f = without_inverse(f, s.first_inverse() + i, ours({s.inverses[i], Integer(1)}).p, a_);
    for (std::size_t i = 0; i < t.inverses.size(); ++i)
      f = without_inverse(f, s.ring->size() + i, theirs({t.inverses[i], Integer(1)}).p, a_);
    need(orders(f).lowest > bound, "another system of lowest order");
  }
  // Names of X, or of Y with its inverses at this place.
  static Functions::Values images(const PhaseSystem& z, const Ring& both, std::size_t inverses) {
    Functions::Values all;
    for (std::size_t i = 0; i < z.ring->size(); ++i) {
      const bool is_inverse = i >= z.first_inverse() && i < z.first_parameter();
      const std::size_t at = is_inverse && inverses > 0 ? inverses + i - z.first_inverse()
                                                        : both->index(z.ring->name(i));
      all.emplace_back(PhaseFunction{MPoly::variable(both, at), Integer(1)});
    }
    return all;
  }

  const Family &x_, &y_;
  Keys& k_;
  Arithmetic& a_;
  std::size_t& nodes_;
  Weights weights_; ///< of the coordinates
};

} // namespace

Said rule::lowest_order(Keys& step, Derivation& d) {
  const Family& x = d.plain_family(step);
  const TheoremFact& of = d.proved(step.at("of"));
  need_kind(of.kind == FactKind::not_integrable);
  need(of.family != nullptr && of.family->is_plain(),
       "the step is about a system of a certificate");
  const auto has_parts = [](const IntegralClass& c) { // these are rational
    return contains(c, {.kind = IntegralClass::Kind::rational}) == Truth::yes;
  };
  for (const IntegralClass& c : of.classes)
    need(has_parts(c) || c == real_analytic(), "a class that parts of lowest order need not have");
  LowestOrder(x, *of.family, step, d.arithmetic(), d.nodes())();
  Said f{FactKind::not_integrable, &x, {x.renamed(of.regions.front())}};
  for (const IntegralClass& c : of.classes)
    if (!has_parts(c)) f.classes.push_back(c);
  f.classes.push_back(near_origin());
  f.used = {"Ziglin 1982"};
  return f;
}

} // namespace kov::certify
