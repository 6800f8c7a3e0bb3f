#pragma once
// The system along the curve: the rules C1 to C7 of system_certificates.md.

#include "certify/system/check.hpp"
#include "certify/system/curve_algebra.hpp"
#include "certify/system/phase_space.hpp"
#include "certify/system/terms.hpp"

#include <set>
#include <utility>

namespace kov::certify {

class AlongCurve {
public:
  /// C1.  rule: is set to the one that was last begun
  AlongCurve(const Way& w, Arithmetic& a, std::string& rule)
      : s_(w.system), c_(w.curve), a_(a), rule_(rule), space_(s_, a), algebra_(c_, a),
        values_(s_.ring->size()) {
    for (std::size_t i = s_.first_parameter(); i < s_.ring->size(); ++i)
      values_[i] = algebra_.variable(c_.ring->index(s_.ring->name(i)));
    for (const auto& [i, value] : c_.values)
      values_[i] = algebra_.reduced(value);
  }

  void need_claims(const std::vector<ClaimedFunction>& claims) { ///< S1, S2, S4
    rule_ = "S1";
    space_.need_symbols();
    rule_ = "S2";
    field_ = space_.field();
    rule_ = "S4";
    for (const ClaimedFunction& c : claims)
      space_.need_claim(c, field_);
  }
  void need_curve() { ///< C2 to C7
    rule_ = "C2";
    algebra_.need_derivation();
    rule_ = "C4";
    for (const PhaseFunction& x : field_)
      static_cast<void>(at(x)); // has a value
    need_functions();
    rule_ = "C5";
    need(algebra_.equal(at(c_.change), algebra_.variable(c_.z())),
         "the change of variable is not z on the curve");
    rule_ = "C6";
    for (const auto* all : {&c_.equations, &c_.levels})
      for (const PhaseFunction& f : *all)
        need(is_zero(at(f).p), "an equation or a level does not hold on the curve");
    rule_ = "C7";
    need_no_constant_in_disguise();
  }

  [[nodiscard]] const CurveAlgebra& algebra() const { return algebra_; }
  [[nodiscard]] const PhaseSpace& space() const { return space_; }
  [[nodiscard]] const std::vector<PhaseFunction>& field() const { return field_; }
  /// By phase variable.
  [[nodiscard]] const CurveAlgebra::Values& values() const { return values_; }
  [[nodiscard]] CurveFunction at(const PhaseFunction& f) const { ///< f(x)
    return CurveAlgebra::over(algebra_.evaluate(f.p, values_), f.n);
  }
  [[nodiscard]] CurveFunction at(const MPoly& f) const { return algebra_.evaluate(f, values_); }
  [[nodiscard]] CurveRow at(const std::vector<PhaseFunction>& row) const {
    CurveRow all;
    for (const PhaseFunction& f : row)
      all.push_back(at(f));
    return all;
  }
  /// Is it 0 along the curve?  false: a name has no value.
  [[nodiscard]] bool holds(const MPoly& f) const { return is_known(f) && is_zero(at(f).p); }

  /// By phase variable: the functions that have a value (fixed: the fixed ones, too), and the coordinates with
  /// a value on which they depend.
  [[nodiscard]] std::vector<bool> seen_by_functions(bool fixed) const {
    std::vector<bool> seen(s_.ring->size(), false);
    for (std::size_t f = 0; f < s_.functions.size(); ++f) {
      const std::size_t s = s_.dimension + f;
      if (!values_[s] || (fixed_[s] && !fixed)) continue;
      seen[s] = true;
      const auto arguments = names_behind(s_, {s});
      for (std::size_t j = 0; j < s_.dimension; ++j)
        seen[j] = seen[j] || (arguments[j] && values_[j]);
    }
    return seen;
  }
  /// Section 7: the names of what is left out and moves.
  [[nodiscard]] std::vector<std::string> moving() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < s_.first_inverse(); ++i) {
      if (values_[i]) continue;
      const auto v = velocity(i);
      if (!v || !is_zero(v->p)) names.push_back(s_.ring->name(i));
    }
    return names;
  }

private:
  [[nodiscard]] bool is_known(const MPoly& f) const {
    const auto used = used_variables(f);
    return std::ranges::all_of(used, [&](std::size_t i) { return values_[i].has_value(); });
  }

  // d/dt of a coordinate or a function along the curve; unset: it has no value there.
  [[nodiscard]] std::optional<CurveFunction> velocity(std::size_t variable) const {
    if (variable < s_.dimension) return at(field_[variable]);
    CurveFunction sum = algebra_.zero();
    for (const auto& [j, g] : s_.functions[variable - s_.dimension].gradient) {
      if (is_zero(g.p)) continue;
      if (!is_known(g.p)) return std::nullopt;
      sum = algebra_.plus(sum, algebra_.times(at(g), at(field_[j])));
    }
    return sum;
  }

  void need_functions() const {
    for (const MPoly& r : s_.relations)
      need(is_zero(at(r).p), "a relation does not hold on the curve");
    for (std::size_t i = 0; i < s_.first_parameter(); ++i) {
      const bool is_inverse = i >= s_.first_inverse();
      if (!values_[i]) {
        need(!is_inverse, "an inverse has no value on the curve");
      } else if (is_inverse) {
        const CurveFunction h = at(s_.inverses[i - s_.first_inverse()]);
        need(algebra_.equal(algebra_.times(*values_[i], h), algebra_.one()),
             "the value of an inverse is none");
      } else {
        const auto v = velocity(i);
        need(v && algebra_.equal(algebra_.derivative(*values_[i]), algebra_.times(c_.time, *v)),
             "the curve is not a solution of the system");
      }
    }
  }

  // ---- C7

  void need_no_constant_in_disguise() {
    fixed_.assign(s_.ring->size(), true);
    for (std::size_t i = s_.dimension; i < s_.first_parameter(); ++i)
      fixed_[i] = false;
    fixed_ = space_.algebraic(fixed_, [&](const MPoly& f) {
      return is_known(f) && algebra_.is_unit(algebra_.norm(at(f)), {});
    });
    for (std::size_t f = 0; f < s_.functions.size(); ++f) {
      if (fixed_[s_.dimension + f]) continue;
      const auto& gradient = s_.functions[f].gradient;
      need(
          std::ranges::any_of(gradient, [](const auto& entry) { return !is_zero(entry.second.p); }),
          "a constant that no relation fixes");
      need(!values_[s_.dimension + f] || moves(s_.functions[f], false) ||
               moves(s_.functions[f], true),
           "a function has the value of a constant: no derivative has an inverse on the curve");
    }
    need_own_names();
  }
  // A name in the values that are shown is not another one of the system.
  void need_own_names() const {
    const auto seen = seen_by_functions(true);
    for (const auto& [i, value] : c_.values) {
      if (!seen[i]) continue;
      for (const std::string& x : names_in(c_, value)) {
        const auto k = s_.ring->find(x);
        if (!k || *k >= s_.first_inverse()) continue;
        const std::size_t w = c_.ring->index(x);
        need(values_[*k] ? algebra_.equal(*values_[*k], algebra_.variable(w)) : w == c_.z(),
             "a name of the tower is another one of the system");
      }
    }
  }

  // Has a derivative an inverse at each point at which the gradient is not 0?  divided: the entries and what is
  // derived from them are divided by the factor of the entry that has no functions in it: where that is 0 the
  // entry is.
  [[nodiscard]] bool moves(const PhaseSymbol& f, bool divided) const {
    constexpr int max_order = 8;
    constexpr std::size_t max_derivatives = 5000; // of one order
    struct Derivative {
      std::size_t entry, last; // of the gradient; the coordinate of the last derivation
      PhaseFunction value;
    };
    std::vector<Derivative> layer, next;
    std::vector<std::vector<MPoly>> factors;
    std::vector<MPoly> common;
    std::set<std::size_t> left;
    const auto without = [&](std::size_t entry, const PhaseFunction& g) {
      if (is_constant(common[entry])) return g;
      const Content c = content(g.p);
      return is_multiple(c.factor, common[entry]) ? PhaseFunction{c.rest, {1}} : g;
    };
    for (const auto& [j, g] : f.gradient) {
      const std::size_t entry = factors.size();
      common.push_back(divided && !is_zero(g.p) ? content(g.p).factor : MPoly(s_.ring, {1}));
      auto& factor = factors.emplace_back();
      if (is_zero(g.p)) continue;
      if (const MPoly c = content(g.p, true).factor; !is_constant(c)) factor.push_back(at(c).p);
      left.insert(entry);
      layer.push_back({entry, 0, without(entry, g)});
    }
    for (int order = 1;; ++order, layer = std::exchange(next, {})) {
      for (const Derivative& d : layer) {
        if (!is_known(d.value.p)) continue;
        const MPoly norm = algebra_.norm(at(d.value));
        if (is_constant(common[d.entry]) && algebra_.is_unit(norm, {})) return true;
        if (left.contains(d.entry) && algebra_.is_unit(norm, factors[d.entry])) left.erase(d.entry);
      }
      if (left.empty() || order == max_order) return left.empty();
      for (const Derivative& d : layer)
        for (std::size_t j = d.last; j < s_.dimension; ++j)
          if (auto slope = space_.partial(d.value, j); !is_zero(slope.p))
            next.push_back({d.entry, j, without(d.entry, slope)});
      need_within(next.size() <= max_derivatives, "too many derivatives of a function");
    }
  }

  // f = factor * rest up to a number: coordinates and parameters in the factor (constant: parameters), nothing of
  // it in the rest; the factor is 1 if there are no such two.
  struct Content {
    MPoly factor, rest;
  };
  [[nodiscard]] Content content(const MPoly& f, bool constant = false) const {
    std::vector<bool> kept(s_.ring->size());
    for (std::size_t i = 0; i < kept.size(); ++i)
      kept[i] = (i >= s_.dimension || constant) && i < s_.first_parameter();
    const auto parts = parts_by(f, kept);
    const MPoly c = primitive(parts.begin()->second);
    MPoly rest(s_.ring);
    for (const auto& [own, part] : parts) {
      if (!is_multiple(part, c)) return {MPoly(s_.ring, {1}), f};
      rest += *a_.quotient(part, c) * MPoly::term(s_.ring, {1}, own);
    }
    return {c, rest};
  }

  const PhaseSystem& s_;
  const PhaseCurve& c_;
  Arithmetic& a_;
  std::string& rule_;
  PhaseSpace space_;
  CurveAlgebra algebra_;
  std::vector<PhaseFunction> field_;
  CurveAlgebra::Values values_; ///< by phase variable
  std::vector<bool> fixed_; ///< by phase variable: algebraic over the coordinates and parameters
};

} // namespace kov::certify
