// The same system in all units: theorem_certificates.md 18.

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// x_i -> s^(w_i) x_i, p_j -> s^(v_j) p_j, of which each part of the system is homogeneous.
class Scale {
public:
  Scale(const Family& x, const Node& weights) : x_(x), weights_(x.system.ring->size(), 0) {
    const PhaseSystem& s = x.system;
    const auto rows = weights.items();
    std::size_t k = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      if (i >= s.dimension && !x.is_parameter(i)) continue;
      weights_[i] = k < rows.size() ? rows[k++].count() : 1001;
      if (std::abs(weights_[i]) > 1000)
        weights.fail("weights up to 1000 are expected, for each name");
    }
    if (k < rows.size()) weights.fail("weights up to 1000 are expected, for each name");
    for (k = 0; k < s.inverses.size(); ++k)
      weights_[s.first_inverse() + k] = -degree(s.inverses[k]);
  }

  [[nodiscard]] bool moves(std::size_t i) const { return weights_[i] != 0; }
  /// "x 1, a -1": those that are not 0.
  [[nodiscard]] std::string text() const {
    std::string all;
    for (std::size_t i = 0; i < weights_.size(); ++i)
      if (moves(i) && (i < x_.system.dimension || x_.is_parameter(i)))
        all +=
            (all.empty() ? "" : ", ") + x_.system.ring->name(i) + " " + std::to_string(weights_[i]);
    return all;
  }

  void need_system() const {
    const PhaseSystem& s = x_.system;
    for (const PhaseSymbol& f : s.functions)
      for (const auto& [j, slope] : f.gradient)
        need(is_zero(slope.p), "a function of the coordinates");
    for (const MPoly& f : s.relations)
      degree(f);
    std::vector<long> shifts; // of the bracket, or of the time
    const auto shift = [&](const MPoly& f, long by) {
      if (!is_zero(f)) shifts.push_back(degree(f) - by);
    };
    if (s.hamiltonian) degree(s.hamiltonian->p);
    for (const PhaseBracket& b : s.brackets)
      shift(b.value.p, weights_[b.first] + weights_[b.second]);
    for (std::size_t j = 0; j < s.field.size() && !s.hamiltonian; ++j)
      shift(s.field[j].p, weights_[j]);
    need(std::ranges::adjacent_find(shifts, std::not_equal_to()) == shifts.end(),
         "not homogeneous");
  }
  // They hold in all units or in none.
  void need_conditions(const Conditions& all) const {
    for (const Condition& c : all) {
      need(!is_ordered(c.sign), "a sign that depends on the units");
      degree(c.p);
    }
  }

private:
  // The weight of all terms; refuses several.
  long degree(const MPoly& f) const {
    const auto [lowest, highest] = weights_of(f, weights_);
    need(lowest >= highest, "not homogeneous");
    return is_zero(f) ? 0 : lowest;
  }

  const Family& x_;
  Weights weights_;
};

} // namespace

Said rule::scale(Keys& step, Derivation& d) {
  const Family& x = d.family(step);
  const PhaseSystem& s = x.system;
  const TheoremFact& of = d.proved(step.at("of"));
  need_kind(of.kind == FactKind::not_integrable && of.family == &x);
  for (std::size_t i = s.first_parameter(); i < s.ring->size(); ++i)
    need(i < x.complex.size() && x.complex[i], "complex parameters are expected");
  const auto p = s.ring->find(step.at("parameter").text());
  if (!p || !x.is_parameter(*p)) step.at("parameter").fail("a parameter is expected");
  const Scale scale(x, step.at("weights"));
  scale.need_system();
  need(scale.moves(*p), "the parameter has the weight 0");

  Said f{FactKind::not_integrable, &x, {{}}};
  std::vector<Rational> values;
  for (const Condition& c : of.regions.front()) {
    if (c.sign != Sign::zero || used_variables(c.p) != std::vector{*p}) {
      f.regions.front().push_back(c);
      continue;
    }
    const auto line = coefficients(c.p, *p);
    need(line.size() == 2 && !is_zero(line[0]), "a value other than 0 is expected");
    values.push_back(-Rational(line[0].coefficient(0), line[1].coefficient(0)));
  }
  need(values.size() == 1, "the parameter has no value, or two");
  scale.need_conditions(f.regions.front());
  scale.need_conditions(x.assumptions);
  add_once(f.regions.front(), {MPoly::variable(s.ring, *p), Sign::nonzero});
  for (const IntegralClass& c : of.classes) {
    need(c.functions.empty() && c.through.empty() && c.without.empty() && c.frame.empty() &&
             c.kind != IntegralClass::Kind::real_analytic && c.near != IntegralClass::Near::level,
         "a class that other units may change");
    f.classes.push_back(c);
  }
  f.there = of.there; // of constants
  f.way = of.way;
  f.way.push_back("in units in which " + s.ring->name(*p) + " = " + to_string(values.front()) +
                  ", by the weights " + scale.text());
  f.shows_way = of.shows_way;
  return f;
}

} // namespace kov::certify
