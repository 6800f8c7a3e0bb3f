#include "family/family.hpp"

#include "family/sentence.hpp"
#include "system/formula.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {
namespace {

class FamilyScope : public Scope {
public:
  FamilyScope(Ring ring, std::map<std::string, MFraction> values)
      : ring_(std::move(ring)), values_(std::move(values)) {}

  [[nodiscard]] const Ring& ring() const override { return ring_; }
  [[nodiscard]] std::optional<MFraction> value(const std::string& name) const override {
    if (const auto v = values_.find(name); v != values_.end()) return v->second;
    if (ring_->find(name)) return MFraction::variable(ring_, name);
    return std::nullopt;
  }
  [[nodiscard]] const std::vector<FunctionMeaning>& functions() const override { return none_; }
  [[nodiscard]] std::vector<std::string> known_names() const override { return ring_->names(); }

private:
  Ring ring_;
  std::map<std::string, MFraction> values_;
  std::vector<FunctionMeaning> none_;
};

// sqrt, root, I: another field than Q, which parameters do not go with yet.
bool is_rational_formula(const Expression& e) {
  if (e.kind() == Expression::Kind::call) return false;
  if (e.kind() == Expression::Kind::name && e.name() == "I") return false;
  return std::all_of(e.operands().begin(), e.operands().end(), is_rational_formula);
}

void assume(strata::Assumptions& all, const Sentence& s, const FamilyScope& scope) {
  MFraction value = evaluate(s.left, scope);
  const auto declare_real = [&](const MFraction& f) {
    const auto used = used_variables(f);
    if (used.size() == 1 && f == MFraction::variable(scope.ring(), used[0]))
      all.real.push_back(used[0]);
  };
  switch (s.kind) {
  case Sentence::Kind::sign:
    if (s.right) value -= evaluate(*s.right, scope);
    return all.require(value, s.sign);
  case Sentence::Kind::membership:
    if (s.holds) declare_real(value);
    value -= evaluate(*s.right, scope);
    all.memberships.push_back({Rational(Integer(1), s.modulus) * value, s.holds});
    return;
  default:
    if (s.real) declare_real(value);
  }
}

} // namespace

std::vector<std::string> names_in_assumption(const std::string& text) {
  std::set<std::string> names;
  for (const Sentence& s : sentences(text)) {
    for (const auto& n : names_in(s.left))
      names.insert(n);
    if (s.right)
      for (const auto& n : names_in(*s.right))
        names.insert(n);
  }
  return {names.begin(), names.end()};
}

bool is_assumption(const std::string& text) {
  try {
    return !sentences(text).empty();
  } catch (const InputError&) {
    return false;
  }
}

Family read_family(const EquationText& text) {
  std::vector<const Expression*> formulas;
  for (const auto* e : {&text.r, &text.p, &text.q})
    if (*e) formulas.push_back(&**e);
  const bool rational = std::all_of(formulas.begin(), formulas.end(),
                                    [](const auto* e) { return is_rational_formula(*e); });
  if (text.ode || text.minpoly || !rational) throw FreeParameters(text.parameters);
  Family f;
  f.variable = text.variable.empty() ? "z" : text.variable;
  std::set<std::string> fixed;
  for (const auto& [name, value] : text.set)
    fixed.insert(name);
  std::vector<std::string> names;
  for (const auto& p : text.parameters)
    if (!fixed.contains(p) && p != f.variable &&
        std::find(names.begin(), names.end(), p) == names.end())
      names.push_back(p);
  names.push_back(f.variable);
  const Ring ring = make_ring(names);
  std::map<std::string, MFraction> values;
  for (const auto& [name, value] : text.set)
    values[name] = evaluate(value, FamilyScope(ring, values));
  const FamilyScope scope(ring, values);
  strata::Question& q = f.question;
  q.z = ring->index(f.variable);
  if (text.r) {
    q.r = evaluate(*text.r, scope);
  } else {
    const MFraction p = evaluate(*text.p, scope);
    q.r = Rational(1, 4) * (p * p) + Rational(1, 2) * derivative(p, q.z) - evaluate(*text.q, scope);
  }
  if (!q.r.ring()) q.r = MFraction(ring);
  for (const auto& a : text.assume)
    for (const Sentence& s : sentences(a)) {
      for (const Expression* side : {&s.left, s.right ? &*s.right : nullptr})
        if (side != nullptr)
          if (const auto used = names_in(*side);
              std::find(used.begin(), used.end(), f.variable) != used.end())
            throw side->error("'" + f.variable + "' is the variable of the equation",
                              "assumptions are about parameters");
      assume(q.assumptions, s, scope);
    }
  return f;
}

} // namespace kov
