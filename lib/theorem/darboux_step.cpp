#include "theorem/darboux_step.hpp"

#include "certify/equation/facts.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "theorem/modulo_stratum.hpp"

#include <algorithm>

namespace kov {
namespace {

using certify::DarbouxChart;
using certify::DarbouxForms;
using certify::PotentialPart;

using Depends = NoDarbouxStep::Depends;
using Why = NoDarbouxStep::Why;

[[noreturn]] void not_found(Why why, std::string of = {}) {
  throw NoDarbouxStep{why, std::move(of)};
}
std::string list_of(const std::vector<Rational>& values) {
  return "{" + joined(values, [](const Rational& x) { return to_string(x); }) + "}";
}

const char* name_of_part(PotentialPart part) {
  return part == PotentialPart::all ? "all" : part == PotentialPart::highest ? "highest" : "lowest";
}

// f without its common factors with g, and these.
std::pair<MPoly, MPoly> divided(MPoly f, const std::vector<MPoly>& others) {
  MPoly taken(f.ring(), Integer(1));
  for (const MPoly& g : others)
    for (MPoly common = gcd(f, g); !is_constant(common); common = gcd(f, g)) {
      f = exact_div(f, common);
      taken = taken * common;
    }
  return {f, taken};
}

class InChart {
public:
  InChart(const certify::StepPlace& x, const std::vector<Condition>& given, const DarbouxSaid& said,
          const CaseProof& proof, const DarbouxChart& chart, bool on_stratum)
      : x_(x), ring_(x.family->system.ring), given_(given), said_(said), proof_(proof),
        chart_(chart), forms_(certify::darboux_forms(x, chart, a_)), one_(ring_, Integer(1)),
        there_only_(ring_, chart.coordinates[0], given), on_stratum_(on_stratum) {}

  Json::Object operator()() {
    try {
      return members();
    } catch (NoDarbouxStep& no) {
      no.depends = depends_;
      throw;
    }
  }

private:
  Json::Object members() {
    depends_ = Depends::on_chart;
    if (degree(forms_.directions, w()) != chart_.degree) not_found(Why::at_infinity);
    depends_ = Depends::on_nothing;
    put_there();
    const auto [proper, rest, unit] = on_stratum_ ? factors_there() : factors();
    proper_ = proper;
    const long n = degree(proper_, w());
    if (n < 1) not_found(Why::none_proper);
    need_identity(unit * forms_.directions - proper_ * rest);
    show(forms_.determinant);
    depends_ = Depends::on_chart;
    show(lead(forms_.circle, 2));
    show(lead(forms_.directions, chart_.degree));
    show(unit);
    show(lead(proper_, n));
    depends_ = Depends::on_nothing;
    show(certify::resultant_in(proper_, forms_.circle, w(), a_));
    show(certify::resultant_in(proper_, forms_.potential, w(), a_));
    Json::Object all{{"coordinates", names(chart_.coordinates)},
                     {"momenta", names(chart_.momenta)},
                     {"part", json_text(name_of_part(said_.part))},
                     {"degree", json_text(std::to_string(chart_.degree))},
                     {"chart", json_list({json_text(std::to_string(chart_.a)),
                                          json_text(std::to_string(chart_.b))})},
                     {"says", json_text(said_.relation ? "relation" : "multiple")},
                     {"unit", json_text(to_string(unit))},
                     {"proper", json_text(to_string(proper_))},
                     {"rest", json_text(to_string(rest))}};
    if (uses(rest, w())) all.emplace_back("improper", improper(rest));
    depends_ = Depends::on_statement;
    const MPoly discriminant = certify::resultant_in(proper_, derivative(proper_, w()), w(), a_);
    show(discriminant, said_.relation ? Sign::nonzero : Sign::zero);
    auto [isotropic, sum] = at_isotropic();
    all.emplace_back("isotropic", std::move(isotropic));
    std::vector<Json> choices = said_.relation ? all_choices(sum) : std::vector<Json>{};
    all.emplace_back("zeros", json_list(std::move(zeros_)));
    all.emplace_back("shown", json_list(std::move(shown_)));
    all.emplace_back("choices", json_list(std::move(choices)));
    return all;
  }

  [[nodiscard]] std::size_t w() const { return chart_.coordinates[0]; }
  /// unit g0 = proper rest
  struct Factors {
    MPoly proper, rest, unit;
  };
  [[nodiscard]] Factors factors() const {
    auto [proper, rest] =
        divided(at_place(forms_.directions).first,
                {at_place(forms_.potential).first, at_place(forms_.circle).first});
    return {std::move(proper), std::move(rest), at_place(forms_.directions).second};
  }
  // The factors, with common ones that exist on the stratum only.
  [[nodiscard]] Factors factors_there() const {
    Factors f{forms_.directions, one_, one_};
    for (const MPoly& other : {forms_.potential, forms_.circle})
      while (degree(f.proper, w()) > 0) {
        const MPoly d = there_only_.common(f.proper, other);
        if (is_zero(d) || degree(d, w()) < 1) break;
        auto [q, s] = there_only_.divided(f.proper, d);
        f = {std::move(q), f.rest * d, f.unit * s};
      }
    if (is_zero(f.proper)) not_found(Why::none_proper);
    f.rest = f.rest * there_only_.content(f.proper);
    f.proper = there_only_.primitive(f.proper);
    return f;
  }
  [[nodiscard]] Json names(const std::array<std::size_t, 2>& two) const {
    return json_list({json_text(ring_->name(two[0])), json_text(ring_->name(two[1]))});
  }
  [[nodiscard]] MPoly lead(const MPoly& f, long d) const {
    const auto all = coefficients(f, w());
    return static_cast<long>(all.size()) > d ? all[static_cast<std::size_t>(d)] : MPoly(ring_);
  }

  // An equation that is left and linear in a parameter: factors are looked for where it is solved.
  void put_there() {
    for (const Condition& c : given_) {
      if (c.sign != Sign::zero || is_zero(c.p)) continue;
      for (const std::size_t i : used_variables(c.p)) {
        if (degree(c.p, i) != 1 || there_.contains(i)) continue;
        const auto line = coefficients(c.p, i);
        there_ = {{i, -MFraction(line[0]) / MFraction(line[1])}};
        return;
      }
    }
  }
  // f there, as a quotient.
  [[nodiscard]] std::pair<MPoly, MPoly> at_place(const MPoly& f) const {
    if (there_.empty() || is_zero(f)) return {f, one_};
    const MFraction g = substitute(f, there_);
    if (is_zero(g)) not_found(Why::form_vanishes);
    return {g.num(), g.den()};
  }

  Json row(const MPoly& f, Sign sign) const {
    const MPoly value = certify::primitive(f);
    if (is_zero(value) && sign == Sign::nonzero) not_found(Why::zero_value);
    auto by = proof_.shown(given_, value, sign);
    if (!by && sign == Sign::nonzero)
      throw NoDarbouxStep{Why::not_shown, brief(value, 80), {value}};
    if (!by) not_found(Why::not_shown, brief(value, 80));
    return Json{Json::Object{{"value", json_text(to_string(value))}, {"by", *std::move(by)}}};
  }
  void show(const MPoly& f, Sign sign = Sign::nonzero) { shown_.push_back(row(f, sign)); }
  void need_identity(const MPoly& f) {
    for (const MPoly& c : coefficients(f, w()))
      if (!is_zero(c)) zeros_.push_back(row(c, Sign::zero));
  }

  Json improper(const MPoly& rest) {
    if (on_stratum_) return improper_there(rest);
    const auto [p, below_p] = at_place(forms_.potential);
    const auto [c, below_c] = at_place(forms_.circle);
    MPoly both = one_, scale = one_;
    constexpr long most_power = 8;
    for (long power = 1; power <= most_power; ++power) {
      both = both * p * c;
      scale = scale * below_p * below_c;
      const auto cofactor = divides(rest, both);
      if (!cofactor) continue;
      const MPoly whole = pow(forms_.potential * forms_.circle, static_cast<unsigned long>(power));
      need_identity(scale * whole - rest * *cofactor);
      show(scale);
      return Json{Json::Object{{"scale", json_text(to_string(scale))},
                               {"cofactor", json_text(to_string(*cofactor))},
                               {"power", json_text(std::to_string(power))}}};
    }
    not_found(Why::improper);
  }

  Json improper_there(const MPoly& rest) {
    constexpr unsigned long most_power = 4;
    for (unsigned long power = 1; power <= most_power; ++power) {
      const MPoly whole = pow(forms_.potential * forms_.circle, power);
      const auto [q, s] = there_only_.divided(whole, rest);
      if (!there_only_.vanishes(s * whole - rest * q)) continue;
      need_identity(s * whole - rest * q);
      show(s);
      return Json{Json::Object{{"scale", json_text(to_string(s))},
                               {"cofactor", json_text(to_string(q))},
                               {"power", json_text(std::to_string(power))}}};
    }
    not_found(Why::improper);
  }

  // The orders of the potential in the isotropic directions; one of them may be a function of the parameters
  // on the stratum.
  std::pair<Json, Rational> at_isotropic() {
    if (!said_.relation)
      return {Json{Json::Object{{"order", json_text("0")},
                                {"scale", json_text("1")},
                                {"rest", json_text(to_string(forms_.potential))}}},
              Rational(0)};
    using Power = ModuloStratum::DivisorPower;
    const MPoly line = there_only_.common(forms_.circle, forms_.potential);
    const long n = is_zero(line) ? 0 : degree(line, w());
    Power first{forms_.potential, one_, 0};
    long second = 0;
    Json::Object lines, all;
    if (n == 2) first = there_only_.order(forms_.potential, forms_.circle);
    if (n == 1) {
      const auto [other, over] = there_only_.divided(forms_.circle, line);
      need_identity(over * forms_.circle - line * other);
      show(over);
      first = there_only_.order(forms_.potential, line);
      const Power rest = there_only_.order(first.rest, other);
      second = rest.order;
      first = {rest.rest, first.scale * rest.scale, first.order};
      lines = {{"factors", json_list({json_text(to_string(line)), json_text(to_string(other))})},
               {"over", json_text(to_string(over))},
               {"order", json_text(std::to_string(second))}};
      need_identity(first.scale * forms_.potential -
                    pow(line, static_cast<unsigned long>(first.order)) *
                        pow(other, static_cast<unsigned long>(second)) * first.rest);
    } else {
      second = first.order;
      need_identity(first.scale * forms_.potential -
                    pow(forms_.circle, static_cast<unsigned long>(second)) * first.rest);
    }
    if (2 * first.order == chart_.degree || 2 * second == chart_.degree)
      not_found(Why::unknown_sum);
    show(first.scale);
    show(certify::resultant_in(first.rest, forms_.circle, w(), a_));
    all = {{"order", json_text(std::to_string(first.order))},
           {"scale", json_text(to_string(first.scale))},
           {"rest", json_text(to_string(first.rest))}};
    if (!lines.empty()) all.emplace_back("lines", Json{std::move(lines)});
    return {Json{std::move(all)}, -Rational(chart_.degree, 2 * (chart_.degree - 2 * first.order)) -
                                      Rational(chart_.degree, 2 * (chart_.degree - 2 * second))};
  }

  std::vector<Json> all_choices(const Rational& sum) {
    std::vector<Json> all;
    const auto chi = certify::eigenvalues_at(forms_, chart_, proper_, a_);
    const long n = degree(proper_, w());
    if (static_cast<long>(chi.size()) != n + 1) not_found(Why::eigenvalues);
    for (const auto& values : certify::eigenvalue_sets(chart_.degree, n, sum)) {
      auto conditions = given_;
      std::vector<Json> told, equations;
      std::vector<MPoly> unknown;
      for (const Rational& value : values)
        told.push_back(json_text(to_string(value)));
      for (const MPoly& f : certify::equations_for(chi, values, a_)) {
        conditions.push_back({certify::primitive(f), Sign::zero});
        equations.push_back(json_text(to_string(conditions.back().p)));
        if (!is_zero(f)) unknown.push_back(conditions.back().p);
      }
      auto by = proof_.refutation(conditions);
      if (!by) throw NoDarbouxStep{Why::choice, list_of(values), std::move(unknown)};
      all.push_back(Json{Json::Object{{"values", json_list(std::move(told))},
                                      {"equations", json_list(std::move(equations))},
                                      {"by", *std::move(by)}}});
    }
    return all;
  }

  const certify::StepPlace& x_;
  Ring ring_;
  const std::vector<Condition>& given_;
  const DarbouxSaid& said_;
  const CaseProof& proof_;
  DarbouxChart chart_;
  certify::Arithmetic a_;
  DarbouxForms forms_;
  MPoly one_, proper_;
  Substitution there_;
  ModuloStratum there_only_;
  bool on_stratum_;                       ///< common factors are looked for that exist there only
  Depends depends_ = Depends::on_nothing; ///< of what is shown next
  std::vector<Json> zeros_, shown_;
};

// Pairs of a coordinate and its momentum, as the brackets say.
bool find_pairs(const certify::PhaseSystem& s, DarbouxChart& chart) {
  if (s.dimension != 4 || s.brackets.size() != 2) return false;
  for (const std::size_t j : {0U, 1U}) {
    const auto& b = s.brackets[j];
    if (!is_constant(b.value.p) || is_zero(b.value.p)) return false;
    const bool plus = sign(b.value.p.coefficient(0)) > 0;
    chart.coordinates[j] = plus ? b.first : b.second;
    chart.momenta[j] = plus ? b.second : b.first;
  }
  return true;
}

// The degrees of the terms without momenta there.
std::vector<long> degrees(const certify::StepPlace& x, const DarbouxChart& chart) {
  Substitution put;
  for (const auto& [i, value] : x.at)
    put[i] = MFraction(value.p) / MFraction(MPoly(value.p.ring(), value.n));
  const MFraction h = substitute(MFraction(x.family->system.hamiltonian->p), put);
  std::vector<long> all;
  if (is_zero(h)) return all;
  for (long t = 0; t < h.num().length(); ++t) {
    const auto e = h.num().exponents(t);
    if (e[chart.momenta[0]] + e[chart.momenta[1]] == 0)
      all.push_back(static_cast<long>(e[chart.coordinates[0]] + e[chart.coordinates[1]]));
  }
  std::erase(all, 0);
  return all;
}

std::variant<Json::Object, NoDarbouxStep> members_in(const certify::StepPlace& x,
                                                     const std::vector<Condition>& given,
                                                     const DarbouxSaid& said,
                                                     const CaseProof& proof,
                                                     const DarbouxChart& chart, bool on_stratum) {
  try {
    return InChart(x, given, said, proof, chart, on_stratum)();
  } catch (const NoDarbouxStep& no) {
    return no;
  } catch (const certify::Refused& no) {
    return NoDarbouxStep{Why::refused, no.why, {}, Depends::on_chart};
  }
}

} // namespace

std::string sentence(const NoDarbouxStep& no) {
  switch (no.why) {
  case Why::other_system:
    return "the rule asks for two degrees of freedom and constant masses";
  case Why::no_potential:
    return "there is no potential";
  case Why::refused:
    return "the rule does not apply: " + no.of;
  case Why::at_infinity:
    return "a direction is at infinity in each chart";
  case Why::form_vanishes:
    return "a form vanishes on the stratum";
  case Why::none_proper:
    return "no direction is one of a Darboux point";
  case Why::zero_value:
    return "a polynomial that must not vanish is 0";
  case Why::not_shown:
    return "no proof was found for the sign of " + no.of;
  case Why::improper:
    return "it was not shown which directions are not those of Darboux points";
  case Why::unknown_sum:
    return "the sum of the inverses of the eigenvalues is not known";
  case Why::eigenvalues:
    return "the polynomial of the eigenvalues has another degree";
  case Why::choice:
    return "no proof was found that the eigenvalues are not " + no.of;
  case Why::limit:
    return "the work limit of the step was reached";
  }
  throw InternalError("a reason without a sentence");
}

std::variant<Json::Object, NoDarbouxStep> darboux_members(const certify::StepPlace& x,
                                                          const std::vector<Condition>& given,
                                                          const DarbouxSaid& said,
                                                          const CaseProof& proof) {
  DarbouxChart chart;
  chart.part = said.part;
  if (!x.family->system.hamiltonian || !find_pairs(x.family->system, chart))
    return NoDarbouxStep{Why::other_system};
  const auto all = degrees(x, chart);
  if (all.empty()) return NoDarbouxStep{Why::no_potential};
  chart.degree = said.part == PotentialPart::lowest ? *std::ranges::min_element(all)
                                                    : *std::ranges::max_element(all);
  const bool has_equations = ModuloStratum(x.family->system.ring, 0, given).has_equations();
  constexpr std::array<std::pair<long, long>, 6> charts{
      {{1, 0}, {3, 4}, {5, 12}, {0, 1}, {2, 1}, {1, 3}}};
  std::optional<NoDarbouxStep> farthest;
  std::array<bool, 2> done{false, !has_equations}; // no other chart helps
  for (const auto& [a, b] : charts)
    for (const bool on_stratum : {false, true}) {
      if (done[on_stratum ? 1 : 0]) continue;
      chart.a = a;
      chart.b = b;
      auto found = members_in(x, given, said, proof, chart, on_stratum);
      const auto* no = std::get_if<NoDarbouxStep>(&found);
      if (no == nullptr) return found;
      done[on_stratum ? 1 : 0] = no->depends != Depends::on_chart;
      const bool of_statement = no->depends == Depends::on_statement ||
                                (farthest && farthest->depends == Depends::on_statement);
      if (!farthest || farthest->why < no->why) farthest = *no;
      if (of_statement) farthest->depends = Depends::on_statement;
    }
  return *farthest;
}

} // namespace kov
