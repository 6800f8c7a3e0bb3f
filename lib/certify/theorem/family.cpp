#include "certify/theorem/family.hpp"

#include "certify/equation/facts.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

std::vector<bool> Family::parameters(const ParameterFunctions& at) const {
  std::vector<bool> all(system.ring->size(), false);
  for (std::size_t i = system.first_parameter(); i < all.size(); ++i)
    all[i] = !at.contains(i);
  return all;
}

bool Family::is_plain() const {
  return system.hamiltonian && system.functions.empty() && system.relations.empty() &&
         std::ranges::none_of(complex, [](bool x) { return x; });
}

ConditionSet Family::where(const Conditions& given, Arithmetic& a) const {
  std::vector<bool> real = parameters();
  for (std::size_t i = 0; i < complex.size(); ++i)
    if (complex[i]) real[i] = false;
  ConditionSet s(system.ring, a, parameters(), std::move(real));
  for (const Condition& c : given)
    s.assume(c);
  return s;
}

Family read_family(const Node& n, Arithmetic& a) {
  Keys k(n);
  Family f;
  f.name = k.at("name").text();
  std::vector<std::string> parameters;
  for (const Node& x : k.at("parameters").items())
    parameters.push_back(x.text());
  if (parameters.size() > max_parameters) n.fail("too many parameters");
  const Node system = k.at("system");
  f.system = read_phase_system(system, parameters);
  if (const auto complex = k.find("complex")) {
    f.complex.assign(f.system.ring->size(), false);
    for (const Node& x : complex->items()) {
      const auto i = f.system.ring->find(x.text());
      if (!i || !f.is_parameter(*i) || f.complex[*i]) x.fail("a parameter is expected");
      f.complex[*i] = true;
    }
  }
  const PhaseSpace space(f.system, a);
  space.need_symbols();
  static_cast<void>(space.field());
  f.assumptions = f.region(k.at("assumptions"));
  if (const auto lagrangian = k.find("lagrangian"))
    f.lagrangian = read_lagrangian(*lagrangian, f.system, a);
  k.done();
  const std::vector<bool> used = used_names(f.system);
  for (std::size_t i = f.system.first_inverse(); i < f.system.first_parameter(); ++i)
    need(used[i], "an inverse that is not one of the system");
  return f;
}

Target target_of(const Family& f, const Conditions& region, bool real) {
  Target t{&f.system, {}};
  for (std::size_t i = f.system.first_parameter(); real && i < f.system.ring->size(); ++i)
    t.asked.push_back({true, Sign::nonzero, MPoly::variable(f.system.ring, i)});
  for (const Conditions* all : {&f.assumptions, &region})
    for (const Condition& c : *all)
      t.asked.push_back({false, c.sign, c.p});
  return t;
}

std::vector<bool> used_names(const PhaseSystem& s) {
  std::vector<std::size_t> all;
  const auto add = [&](const PhaseFunction& f) {
    const auto used = used_variables(f.p);
    all.insert(all.end(), used.begin(), used.end());
  };
  if (s.hamiltonian) add(*s.hamiltonian);
  for (const PhaseBracket& b : s.brackets)
    add(b.value);
  std::ranges::for_each(s.field, add);
  return names_behind(s, std::move(all));
}

void need_no_functions(const PhaseSystem& s) {
  const std::vector<bool> used = used_names(s);
  for (std::size_t i = s.dimension; i < s.first_inverse(); ++i)
    need(!used[i], "a function occurs in the system");
}

Conditions StepPlace::conditions() const {
  Conditions all;
  for (const auto& [i, value] : at)
    all.push_back({scaled(MPoly::variable(family->system.ring, i), value.n) - value.p, Sign::zero});
  all.insert(all.end(), region.begin(), region.end());
  return all;
}

namespace {

Ring ring_with(const Ring& ring, const std::vector<std::string>& more) {
  if (more.empty()) return ring;
  auto names = ring->names();
  names.insert(names.end(), more.begin(), more.end());
  return make_ring(names);
}

} // namespace

Here::Here(const StepPlace& x, const std::vector<std::string>& more, Arithmetic& a)
    : ring_(ring_with(x.family->system.ring, more)), in_(ring_, a), tower_(a),
      free_(ring_->size(), false) {
  const PhaseSystem& s = x.family->system;
  std::vector<bool> real = free_;
  for (std::size_t i = 0; i < s.ring->size(); ++i) {
    images_.emplace_back(in_.variable(i));
    free_[i] = x.family->is_parameter(i) && !x.at.contains(i);
    real[i] = free_[i] && (x.family->complex.empty() || !x.family->complex[i]);
  }
  for (const auto& [i, f] : x.at)
    images_[i] = PhaseFunction{in_ring(f.p, ring_), f.n};
  for (std::size_t k = 0; k < s.inverses.size(); ++k)
    images_[s.first_inverse() + k] =
        inverse(s.first_inverse() + k, put({s.inverses[k], Integer(1)}));
  given_.emplace(ring_, a, free_, std::move(real));
  for (const Conditions* all : {&x.family->assumptions, &x.region})
    for (const Condition& c : *all)
      given_->assume(primitive(Condition{put({c.p, Integer(1)}).p, c.sign}));
}

PhaseFunction Here::inverse(std::size_t name, const PhaseFunction& h) {
  need(!is_zero(h.p), "a denominator is 0");
  const MPoly p = primitive(h.p);
  tower_.adjoin({name, std::nullopt, p});
  return {scaled(MPoly::variable(ring_, name), h.n),
          exact_div(h.p.coefficient(0), p.coefficient(0))};
}

} // namespace kov::certify
