// The meaning of the names of a system file, and [set].

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "symbol/suggest.hpp"
#include "system/read_system.hpp"

#include <algorithm>
#include <utility>

namespace kov {

std::vector<std::string> names_of(const Entry& system, std::string_view key) {
  const Entry* e = system.find(key);
  return e ? e->strings() : std::vector<std::string>{};
}

namespace {

const Entry* section(const Entry& document, std::string_view name) { return document.find(name); }

/// The new independent variable: what [reduce] calls it, or the first free letter.
std::string independent_name(const Entry& document, const std::vector<std::string>& taken) {
  if (const Entry* reduce = section(document, "reduce"))
    for (const Entry* r : reduce->list())
      if (const Entry* change = r->find("change")) {
        const Expression e = change->expression(true);
        if (e.kind() != Expression::Kind::equation || e.operand(0).kind() != Expression::Kind::name)
          throw e.error("a change of variable was expected", "write it as 'z = Gamma3^2'");
        return e.operand(0).name();
      }
  for (const char* name : {"z", "w", "zeta", "independent"})
    if (!is_among(name, taken)) return name;
  return "independent_";
}

/// The names of integrals, Casimirs and Darboux polynomials, and of [system.define].
std::vector<std::string> named_formulas(const Entry& document) {
  std::vector<std::string> names;
  for (const char* kind : {"integral", "casimir", "darboux"})
    if (const Entry* claims = document.find(kind))
      for (const Entry* claim : claims->list())
        if (const Entry* name = claim->find("name")) names.push_back(name->string());
  if (const Entry* define = document.at("system").find("define"))
    for (const auto& [name, entry] : define->members())
      names.push_back(name);
  return names;
}

/// The h of level = ["H = h"], where nothing else is called so: the value of a level is a free constant.
std::vector<std::string> level_constants(const Entry& document,
                                         const std::vector<std::string>& declared) {
  std::vector<std::string> found;
  const Entry* manifolds = document.find("manifold");
  if (manifolds == nullptr) return found;
  std::vector<std::string> known = named_formulas(document);
  known.insert(known.end(), declared.begin(), declared.end());
  const auto take = [&](const Expression& level) {
    if (level.kind() != Expression::Kind::equation) return;
    if (level.operand(1).kind() != Expression::Kind::name) return;
    const std::string& name = level.operand(1).name();
    if (name == "H" || name == "I") return;
    if (nearest(name, known)) return; // known, or a mistake in writing
    add_once(found, name);
  };
  for (const Entry* m : manifolds->list())
    if (const Entry* levels = m->find("level"))
      for (const Entry* level : levels->list())
        take(level->expression(true));
  return found;
}

} // namespace

SystemScope::SystemScope(const Entry& document, const ParameterValues& settings, const Entry* more)
    : written(document.at("system"), more), document_(&document) {
  const Entry& system = document.at("system");
  system.check_keys({"kind", "coordinates", "momenta", "parameters", "constants", "hamiltonian",
                     "lagrangian", "velocities", "angular_velocity", "gyrostat", "bracket", "field",
                     "acceleration", "relations", "define", "function"});
  coordinates = names_of(system, "coordinates");
  auto momenta = names_of(system, "momenta");
  velocities = names_of(system, "velocities");
  if (system.find("acceleration")) momenta = std::exchange(velocities, {}); // they are coordinates
  if (!velocities.empty() && momenta.empty())
    for (const std::string& q : coordinates)
      momenta.push_back("p_" + q);
  coordinates.insert(coordinates.end(), momenta.begin(), momenta.end());
  if (velocities.empty()) velocities = names_of(system, "angular_velocity");
  parameters = names_of(system, "parameters");
  constants = names_of(system, "constants");
  if (const Entry* f = system.find("function"))
    for (const Entry* one : f->list())
      function_names.push_back(one->at("name").string());
  std::vector<std::string> all;
  for (const auto* part : {&coordinates, &velocities, &function_names, &constants, &parameters})
    all.insert(all.end(), part->begin(), part->end());
  for (const std::string& name : level_constants(document, all)) {
    parameters.push_back(name);
    all.push_back(name);
  }
  independent = independent_name(document, all);
  all.insert(all.begin(), independent);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (std::find(all.begin(), all.begin() + static_cast<long>(i), all[i]) !=
        all.begin() + static_cast<long>(i))
      throw system.error("the name '" + all[i] + "' is declared twice",
                         all[i] == independent ? "give the new variable of [reduce] another name"
                                               : "");
  std::set<std::string> taken(all.begin(), all.end());
  if (const Entry* d = system.find("define"))
    for (const auto& [name, entry] : d->members())
      taken.insert(name);
  const auto names = written.names(std::move(taken));
  unused.insert(names.begin(), names.end());
  all.insert(all.begin() + static_cast<long>(1 + coordinates.size()), names.begin(), names.end());
  ring_ = make_ring(all);
  if (const Entry* d = system.find("define"))
    for (const auto& [name, entry] : d->members())
      define(name, entry);
  read_settings(settings);
}

void SystemScope::define(const std::string& name, const Entry& entry) {
  if (ring_->find(name)) throw entry.error("the name '" + name + "' is declared twice");
  definitions_.emplace(name, &entry);
}

void SystemScope::fix(const std::string& name, const Expression& e) {
  const auto is_in = [&](const std::vector<std::string>& all) { return is_among(name, all); };
  if (!is_in(parameters) && !is_in(constants)) {
    const auto guess = nearest(name, parameters);
    throw e.error("'" + name + "' is not a parameter of this system",
                  guess ? "did you mean '" + *guess + "'?"
                        : "parameters: " + enumerate(parameters));
  }
  pending_.insert_or_assign(name, e);
}

void SystemScope::read_settings(const ParameterValues& settings) {
  if (const Entry* set = section(*document_, "set"))
    for (const auto& [name, entry] : set->members())
      fix(name, entry.expression());
  for (const auto& [name, text] : settings)
    fix(name, parse_expression(
                  text, origin_from(origin_of_text("--set", name + "=" + text), name.size() + 1)));
  const auto pending = pending_;
  for (const auto& [name, e] : pending)
    static_cast<void>(fixed_value(name));
}

// A fixed value may use other parameters (C = "2*A"), in any order, without a circle.
std::optional<MFraction> SystemScope::fixed_value(const std::string& name) const {
  if (const auto known = values.find(name); known != values.end()) return known->second;
  const auto waiting = pending_.find(name);
  if (waiting == pending_.end()) return std::nullopt;
  if (!open_.insert(name).second)
    throw waiting->second.error("the value of '" + name + "' is defined by itself");
  MFraction v = evaluate(waiting->second, *this);
  for (const std::size_t i : used_variables(v)) {
    const std::string& used = ring_->name(i);
    if (!is_among(used, parameters) && !is_among(used, constants))
      throw waiting->second.error("the value of a parameter cannot depend on '" + used + "'");
  }
  open_.erase(name);
  values[name] = v;
  return v;
}

std::optional<MFraction> SystemScope::value(const std::string& name) const {
  if (auto v = fixed_value(name)) return v;
  if (const auto v = named.find(name); v != named.end()) return v->second;
  if (name == independent || unused.contains(name)) return std::nullopt; // ours, in no formula
  if (const auto i = ring_->find(name)) return MFraction::variable(ring_, *i);
  const auto waiting = definitions_.find(name);
  if (waiting == definitions_.end()) return std::nullopt;
  if (!open_.insert(name).second)
    throw waiting->second->error("'" + name + "' is defined by itself");
  try {
    MFraction v = evaluate(waiting->second->expression(), *this);
    open_.erase(name);
    named[name] = v;
    return v;
  } catch (const Error&) { // a function that is not known yet, perhaps
    open_.erase(name);
    throw;
  }
}

void SystemScope::divides_by(const MFraction& f) const {
  const MPoly d = f.num();
  if (!is_constant(d) && !is_among(d, divisors_)) divisors_.push_back(d);
}

std::vector<std::string> SystemScope::known_names() const {
  std::vector<std::string> names(ring_->names());
  std::erase(names, independent);
  std::erase_if(names, [this](const std::string& name) { return unused.contains(name); });
  for (const auto& [name, entry] : definitions_)
    names.push_back(name);
  for (const auto& [name, entry] : named)
    add_once(names, name);
  return names;
}

Equation SystemScope::equation(const Entry& entry) const {
  const Expression e = entry.expression(true);
  return {evaluate_equation(e, *this), entry.string()};
}
std::vector<Equation> SystemScope::equations(const Entry& entry) const {
  return mapped<Equation>(entry.list(), [&](const Entry* one) { return equation(*one); });
}

namespace {

/// The names of a system that has been read.
class FinishedScope : public Scope {
public:
  explicit FinishedScope(const System& s) : s_(&s) {}
  [[nodiscard]] const Ring& ring() const override { return s_->ring(); }
  [[nodiscard]] std::optional<MFraction> value(const std::string& name) const override {
    if (const auto v = s_->values.find(name); v != s_->values.end()) return v->second;
    if (const auto v = s_->named.find(name); v != s_->named.end()) return v->second;
    if (const auto i = s_->ring()->find(name)) return MFraction::variable(s_->ring(), *i);
    return std::nullopt;
  }
  [[nodiscard]] const std::vector<FunctionMeaning>& functions() const override { return none_; }
  [[nodiscard]] std::vector<std::string> known_names() const override {
    std::vector<std::string> names(s_->ring()->names());
    for (const auto& [name, value] : s_->named)
      names.push_back(name);
    return names;
  }

private:
  const System* s_;
  std::vector<FunctionMeaning> none_;
};

} // namespace

MFraction formula(const System& s, const std::string& text) {
  return evaluate(parse_expression(text, "formula"), FinishedScope(s));
}

Assumption condition(const System& s, const std::string& text) {
  const Comparison c = comparison(text).value();
  return {c.sign, formula(s, std::string(c.left)) - formula(s, std::string(c.right)), text};
}

} // namespace kov
