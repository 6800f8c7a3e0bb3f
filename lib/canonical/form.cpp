#include "canonical/form.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <set>

namespace kov {

bool Form::is_constant_of_motion(const MFraction& f) const {
  const auto used = used_variables(f);
  return std::ranges::none_of(used, [&](std::size_t i) {
    const auto is = [i](const FunctionSymbol& s) { return s.variable == i; };
    return is_among(i, field.coordinates) || std::ranges::any_of(field.functions, is);
  });
}

long Form::length() const {
  long all = field.hamiltonian->num().length() + field.hamiltonian->den().length();
  for (const MPoly& r : field.relations)
    all += r.length();
  return all;
}

std::optional<Form> form_of(const System& s) {
  const VectorField& v = s.field;
  if (s.kind != SystemKind::hamiltonian || !v.hamiltonian || !v.poisson || v.dimension() % 2 != 0 ||
      *v.poisson != canonical_structure(v.ring, v.dimension() / 2))
    return std::nullopt;
  Form form{v, {}};
  for (const std::size_t i : v.coordinates)
    form.forward.push_back(form.variable(i));
  return form;
}

namespace {

std::vector<MFraction> gradient_after(const Form& form, const FunctionSymbol& f,
                                      const Substitution& old) {
  const VectorField& v = form.field;
  std::vector<MFraction> all(v.dimension(), MFraction(v.ring));
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    if (is_zero(f.gradient[j])) continue;
    const auto x = old.find(v.coordinates[j]);
    const MFraction slope = substitute(f.gradient[j], old);
    for (std::size_t k = 0; k < v.dimension(); ++k)
      all[k] += slope * derivative(x == old.end() ? form.variable(v.coordinates[j]) : x->second,
                                   v.coordinates[k]);
  }
  return all;
}

} // namespace

Form changed(const Form& form, const Substitution& old, const Substitution& now) {
  Form next = form;
  VectorField& v = next.field;
  v.hamiltonian = substitute(*form.field.hamiltonian, old);
  for (MPoly& r : v.relations)
    r = substitute(r, old).num();
  for (std::size_t k = 0; k < v.functions.size(); ++k)
    v.functions[k].gradient = gradient_after(form, form.field.functions[k], old);
  Substitution user;
  for (std::size_t k = 0; k < v.dimension(); ++k)
    user[v.coordinates[k]] = form.forward[k];
  for (const auto& [i, value] : form.functions)
    user[i] = value;
  for (std::size_t k = 0; k < v.dimension(); ++k)
    if (const auto x = now.find(v.coordinates[k]); x != now.end())
      next.forward[k] = substitute(x->second, user);
  return next;
}

namespace {

// The first of x1, x2, ... that nothing is called.
std::string fresh(const std::string& name, std::set<std::string>& taken) {
  std::string candidate;
  int k = 0;
  do
    candidate = name + std::to_string(++k);
  while (taken.contains(candidate));
  taken.insert(candidate);
  return candidate;
}

// Functions that occur in H, and what their derivatives need.
void keep_needed_functions(VectorField& v) {
  std::set<std::size_t> needed;
  const auto add = [&](const MFraction& f) {
    bool grown = false;
    for (const std::size_t i : used_variables(f))
      grown = needed.insert(i).second || grown;
    return grown;
  };
  bool grown = add(*v.hamiltonian);
  const auto is_needed = [&](const FunctionSymbol& f) { return needed.contains(f.variable); };
  while (grown) {
    grown = false;
    for (const FunctionSymbol& f : v.functions)
      if (is_needed(f))
        for (const MFraction& slope : f.gradient)
          grown = add(slope) || grown;
    for (const MPoly& r : v.relations)
      if (std::ranges::any_of(v.functions,
                              [&](const auto& f) { return is_needed(f) && uses(r, f.variable); }))
        grown = add(MFraction(r)) || grown;
  }
  const auto left_out = [&](std::size_t i) {
    return std::ranges::any_of(v.functions,
                               [&](const auto& f) { return f.variable == i && !is_needed(f); });
  };
  std::erase_if(v.relations, [&](const MPoly& r) {
    const auto used = used_variables(r);
    return std::ranges::any_of(used, left_out);
  });
  std::erase_if(v.functions, [&](const FunctionSymbol& f) { return !is_needed(f); });
}

/// The names of the new system: those of the old one, but for changed variables.
class Renaming {
public:
  Renaming(const System& s, const Form& form) : form_(form) {
    const Ring& big = form.field.ring;
    std::set<std::string> taken(big->names().begin(), big->names().end());
    std::vector<std::string> both = big->names(), names{s.ring()->name(s.z)};
    for (std::size_t k = 0; k < form.field.dimension(); ++k) {
      const std::size_t i = form.field.coordinates[k];
      const bool same = form.forward[k] == form.variable(i);
      const std::string name =
          same || !s.ring()->find(big->name(i)) ? big->name(i) : fresh(big->name(i), taken);
      if (name != big->name(i)) {
        both.push_back(name);
        renamed_[i] = both.size() - 1;
      }
      names.push_back(name);
    }
    const VectorField& v = form.field;
    for (const FunctionSymbol& f : v.functions)
      names.push_back(big->name(f.variable));
    for (const auto* more : {&v.constants, &v.parameters})
      for (const std::size_t i : *more)
        names.push_back(big->name(i));
    both_ = make_ring(both);
    ring_ = make_ring(names);
    for (const auto& [from, to] : renamed_)
      values_[from] = MFraction::variable(both_, to);
  }
  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] MFraction operator()(const MFraction& f) const {
    return transfer(substitute(transfer(f, both_), values_), ring_);
  }
  [[nodiscard]] std::size_t operator()(std::size_t i) const {
    const auto renamed = renamed_.find(i);
    return renamed == renamed_.end() ? ring_->index(form_.field.ring->name(i))
                                     : ring_->index(both_->name(renamed->second));
  }

private:
  const Form& form_;
  Ring both_, ring_;
  std::map<std::size_t, std::size_t> renamed_;
  Substitution values_;
};

VectorField renamed(const VectorField& from, const Renaming& to) {
  VectorField v = from;
  v.ring = to.ring();
  for (auto* all : {&v.coordinates, &v.constants, &v.parameters})
    for (std::size_t& i : *all)
      i = to(i);
  for (FunctionSymbol& f : v.functions) {
    f.variable = to(f.variable);
    for (MFraction& slope : f.gradient)
      slope = to(slope);
  }
  for (MPoly& r : v.relations)
    r = to(MFraction(r)).num();
  v.hamiltonian = to(*from.hamiltonian);
  for (auto& row : *v.poisson)
    for (MFraction& entry : row)
      entry = to(entry);
  v.components = hamiltonian_field(v, *v.poisson, *v.hamiltonian);
  return v;
}

} // namespace

CanonicalChange finished(const System& s, const Form& form) {
  Form last = form;
  keep_needed_functions(last.field);
  const Renaming to(s, last);
  CanonicalChange change;
  System& now = change.system;
  now.file = s.file;
  now.title = s.title;
  now.cite = s.cite;
  now.kind = s.kind == SystemKind::hamiltonian ? s.kind : SystemKind::poisson;
  now.field = renamed(last.field, to);
  now.named["H"] = *now.field.hamiltonian;
  now.z = now.ring()->index(s.ring()->name(s.z));
  now.adjoined = s.adjoined;
  const auto is_kept = [&](const auto& f) {
    return std::ranges::all_of(used_variables(f), [&](std::size_t i) {
      return now.ring()->find(s.ring()->name(i)).has_value();
    });
  };
  for (const auto& list : s.domain.lists())
    if (std::ranges::all_of(list, is_kept))
      now.domain.require(mapped<MPoly>(
          list, [&](const MPoly& p) { return transfer(MFraction(p), now.ring()).num(); }));
  for (const Assumption& a : s.assumptions) {
    if (!is_kept(a.value)) continue;
    now.assumptions.push_back(a);
    now.assumptions.back().value = transfer(a.value, now.ring());
  }
  for (const MFraction& f : last.forward)
    change.variables.push_back(transfer(f, s.ring()));
  for (const auto& [i, value] : last.functions)
    if (now.ring()->find(form.field.ring->name(i)))
      change.functions[now.ring()->index(form.field.ring->name(i))] = transfer(value, s.ring());
  return change;
}

} // namespace kov
