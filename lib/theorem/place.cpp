#include "theorem/place.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/lists.hpp"
#include "integrability/parameters.hpp"
#include "parameters/parametrised_set.hpp"
#include "symbol/given_text.hpp"
#include "symbol/input_error.hpp"
#include "system/formula.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

// Sentences name a file, and not where it lies on this machine.
std::string file_name(const System& s) { return s.file.substr(folder_of(s.file).size()); }

/// Parameters, coordinates and roots of the theorem's side; values of `at` are put in.
class PlaceScope : public Scope {
public:
  PlaceScope(const System& s, const ParameterValues& roots) : system_(&s) {
    std::vector<std::string> names = s.ring()->names();
    for (const auto& [name, square] : roots)
      names.push_back(name);
    ring_ = make_ring(names);
  }
  [[nodiscard]] const Ring& ring() const override { return ring_; }
  [[nodiscard]] std::optional<MFraction> value(const std::string& name) const override {
    const auto fixed = system_->values.find(name);
    if (fixed != system_->values.end()) return transfer(fixed->second, ring_);
    const auto i = ring_->find(name);
    return i ? std::optional(MFraction::variable(ring_, *i)) : std::nullopt;
  }
  [[nodiscard]] const std::vector<FunctionMeaning>& functions() const override { return none_; }
  [[nodiscard]] std::vector<std::string> known_names() const override { return ring_->names(); }
  [[nodiscard]] MFraction read(const std::string& text) const {
    return evaluate(parse_expression(text, origin_of_text("theorem file", text)), *this);
  }

private:
  const System* system_;
  Ring ring_;
  std::vector<FunctionMeaning> none_;
};

struct WrittenCondition {
  MFraction value; ///< left - right
  Sign sign = Sign::zero;
  std::vector<MFraction> names; ///< values of the names that stand in it
};

// "A > B", "L3 != 0", "A*C >= 1" as a relation of left - right.
WrittenCondition read_condition(const std::string& text, const PlaceScope& scope) {
  const auto c = comparison(text);
  if (!c)
    throw InputError("theorem file", 0, 0, 1, "'" + text + "' is not a condition",
                     "for example \"A > B\" or \"L3 != 0\"");
  const std::string left(c->left), right(c->right);
  WrittenCondition all{scope.read(left) - scope.read(right), c->sign, {}};
  for (const std::string& side : {left, right})
    for (const std::string& name : names_in(parse_expression(side, "theorem file")))
      if (const auto value = scope.value(name)) all.names.push_back(*value);
  return all;
}

// Quantities in an inequality are real.
void require(Assumptions& known, const Place& place, const PlaceScope& scope) {
  std::vector<WrittenCondition> all;
  for (const std::string& text : place.conditions)
    all.push_back(read_condition(text, scope));
  for (const WrittenCondition& c : all)
    if (certify::is_ordered(c.sign))
      for (const MFraction& name : c.names)
        known.declare_real(name);
  for (const WrittenCondition& c : all)
    known.require(c.value, c.sign);
}

} // namespace

MFraction composed(const MFraction& f, const std::map<std::size_t, MFraction>& values,
                   const Ring& ring) {
  // one ring for both sides, so that nothing is confused: y0, y1, ... stand for the variables of f
  std::vector<std::string> names = ring->names();
  const std::size_t first = names.size();
  for (std::size_t i = 0; i < f.ring()->size(); ++i)
    names.push_back("y_" + std::to_string(i));
  const Ring both = make_ring(names);
  const auto moved = [&](const MPoly& p) {
    MPoly sum = MPoly::term(both, Integer(0), std::vector<unsigned long>(names.size(), 0));
    for (long i = 0; i < p.length(); ++i) {
      std::vector<unsigned long> e(names.size(), 0);
      const auto exponents = p.exponents(i);
      std::ranges::copy(exponents, e.begin() + static_cast<long>(first));
      sum = sum + MPoly::term(both, p.coefficient(i), e);
    }
    return sum;
  };
  Substitution put;
  for (const auto& [i, value] : values)
    put[first + i] = transfer(value, both);
  return transfer(substitute(moved(f.num()), put) / substitute(moved(f.den()), put), ring);
}

namespace {

/// One comparison of two fields.
class FieldComparison {
public:
  FieldComparison(const System& whole, const System& base, const System& single, const Place& place)
      : whole_(whole), base_(base), single_(single), place_(place), scope_(base, place.roots),
        roots_(read_roots()), region_(parameters()) {}

  Located run() {
    Located found;
    try {
      found.objection = objection();
    } catch (const DomainError& why) {
      found.objection = why.what();
    }
    found.checks = checks_;
    if (found.objection.empty()) found.map = map_found();
    found.trusted = region_.trusted();
    return found;
  }

private:
  [[nodiscard]] const Ring& ring() const { return scope_.ring(); }
  [[nodiscard]] PlaceMap map_found() const {
    PlaceMap all{ring(), roots_, {}, jacobian_, bracket_, time_};
    for (const auto& [i, value] : map_)
      all.values.emplace(single_.ring()->name(i), value);
    return all;
  }

  [[nodiscard]] Roots read_roots() const {
    std::vector<Roots::Root> squares;
    for (const auto& [name, square] : place_.roots)
      squares.emplace_back(*scope_.ring()->find(name), scope_.read(square));
    return Roots(std::move(squares));
  }
  // The region of the parameters, with all that is known about them.
  [[nodiscard]] ParametrisedSet parameters() const {
    Assumptions known = assumptions_on(whole_, scope_.ring());
    require(known, place_, scope_);
    return {scope_.ring(), known};
  }
  [[nodiscard]] bool is_parametric(const MFraction& f) const {
    const auto used = used_variables(f);
    return std::ranges::none_of(used, [&](std::size_t i) {
      const auto here = base_.ring()->find(ring()->name(i));
      return here && is_among(*here, base_.field.coordinates);
    });
  }
  // Nowhere zero for the parameters of the place.
  [[nodiscard]] bool is_nonzero(const MPoly& p) const {
    return is_parametric(MFraction(p)) && region_.provably_nonzero(roots_.norm(p));
  }

  std::string objection() {
    if (single_.field.dimension() != base_.field.dimension())
      return "it has " + std::to_string(single_.field.dimension()) + " variables, and not " +
             std::to_string(base_.field.dimension());
    if (!single_.field.relations.empty() || !base_.field.relations.empty())
      return "systems with relations are not compared";
    if (!single_.field.functions.empty() || !base_.field.functions.empty())
      return "systems with functions are not compared";
    for (const auto& [name, text] : place_.roots) {
      const MFraction square = scope_.read(text);
      if (!is_parametric(square) || !is_nonzero(square.den()))
        return name + " is not a function of the parameters there";
    }
    if (const auto why = read_maps(); !why.empty()) return why;
    if (const auto why = not_a_change_of_variables(); !why.empty()) return why;
    if (const auto why = other_field(); !why.empty()) return why;
    if (const auto why = other_bracket(); !why.empty()) return why;
    return too_much_assumed();
  }

  // y and q as functions of x and p.
  std::string read_maps() {
    for (const auto& [name, text] : place_.as) {
      const auto i = single_.ring()->find(name);
      if (!i) return "'" + name + "' is not a name of " + file_name(single_);
      map_[*i] = scope_.read(text);
    }
    for (std::size_t i = 0; i < single_.ring()->size(); ++i) {
      const std::string& name = single_.ring()->name(i);
      if (!map_.contains(i) && base_.ring()->find(name))
        if (const auto same = scope_.value(name)) map_[i] = *same;
    }
    time_ = place_.time.empty() ? MFraction(ring(), Rational(1)) : scope_.read(place_.time);
    for (const auto& [i, value] : map_) {
      if (!is_nonzero(value.den()))
        return single_.ring()->name(i) + " = " + brief(value) + " divides by what may be 0";
      if (!is_coordinate(i) && !is_parametric(value))
        return "the parameter " + single_.ring()->name(i) +
               " is put to a function of the variables";
    }
    if (is_zero(time_) || !is_nonzero(time_.num()) || !is_nonzero(time_.den()))
      return "the factor of time may be 0";
    return "";
  }

  [[nodiscard]] bool is_coordinate(std::size_t i) const {
    const auto& all = single_.field.coordinates;
    return is_among(i, all);
  }

  std::string not_a_change_of_variables() {
    const std::size_t n = base_.field.dimension();
    std::vector<std::vector<MFraction>> jacobian;
    for (const std::size_t i : single_.field.coordinates) {
      jacobian.emplace_back();
      if (!map_.contains(i)) return "nothing is said about " + single_.ring()->name(i);
      for (std::size_t j = 0; j < n; ++j) {
        jacobian.back().push_back(derivative(map_.at(i), *ring()->find(base_.field.name(j))));
        if (!is_parametric(jacobian.back().back()))
          return single_.ring()->name(i) + " is not a linear function of the variables";
      }
    }
    const MFraction d = determinant(jacobian, ring());
    if (is_zero(d) || !is_nonzero(d.num())) return "the change of variables may be singular";
    jacobian_ = std::move(jacobian);
    return "";
  }

  std::string other_field() {
    for (std::size_t i = 0; i < single_.field.dimension(); ++i) {
      const MFraction& y = single_.field.components[i];
      if (!is_zero(y))
        for (const std::size_t v : used_variables(y))
          if (!map_.contains(v)) return "nothing is said about " + single_.ring()->name(v);
      MFraction left = MFraction(ring(), Rational(0));
      for (std::size_t j = 0; j < base_.field.dimension(); ++j)
        if (!is_zero(jacobian_[i][j]) && !is_zero(base_.field.components[j]))
          left = left + jacobian_[i][j] * transfer(base_.field.components[j], ring());
      const MFraction right =
          is_zero(y) ? MFraction(ring(), Rational(0)) : time_ * composed(y, map_, ring());
      if (!roots_.vanishes(left - right)) {
        checks_.push_back({single_.field.name(i) + "' of " + file_name(single_) + " is that of " +
                               file_name(base_),
                           false});
        return "its field is another one: " + single_.field.name(i) + "' differs";
      }
    }
    checks_.push_back(
        {"the field of " + file_name(single_) + " is that of " + file_name(base_) + words(), true});
    return "";
  }

  // Commuting integrals stay so if the bracket is the same up to a factor that depends on the
  // parameters only.
  std::string other_bracket() {
    if (!single_.field.poisson) return "";
    if (!base_.field.poisson) return file_name(base_) + " has no bracket";
    const Matrix& theirs = *single_.field.poisson;
    std::optional<MFraction> factor;
    for (std::size_t i = 0; i < theirs.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const MFraction ours = bracket(i, j);
        const MFraction other = is_zero(theirs[i][j]) ? MFraction(ring(), Rational(0))
                                                      : composed(theirs[i][j], map_, ring());
        if (!factor && !roots_.vanishes(other)) factor = ours / other;
        if (factor ? !roots_.vanishes(ours - *factor * other) : !roots_.vanishes(ours))
          return "its Poisson bracket is another one";
      }
    if (factor && (!is_parametric(*factor) || is_zero(*factor) || !is_nonzero(factor->num())))
      return "its Poisson bracket is another one";
    bracket_ = factor;
    checks_.push_back({"the Poisson brackets agree, up to a constant factor", true});
    return "";
  }
  // {y_i, y_j} by the bracket of the theorem's system.
  [[nodiscard]] MFraction bracket(std::size_t i, std::size_t j) const {
    MFraction sum = MFraction(ring(), Rational(0));
    for (std::size_t k = 0; k < jacobian_.size(); ++k)
      for (std::size_t l = 0; l < jacobian_.size(); ++l) {
        const MFraction& b = (*base_.field.poisson)[k][l];
        if (!is_zero(b) && !is_zero(jacobian_[i][k]) && !is_zero(jacobian_[j][l]))
          sum = sum + jacobian_[i][k] * jacobian_[j][l] * transfer(b, ring());
      }
    return sum;
  }

  [[nodiscard]] std::string words() const {
    std::string text;
    for (const auto& [name, value] : place_.at)
      text += (text.empty() ? " at " : ", ") + name + " = " + value;
    std::string put;
    for (const auto& [name, value] : place_.as)
      put += (put.empty() ? ", with " : ", ") + name + " = " + value;
    for (const auto& [name, value] : place_.roots)
      put += (put.empty() ? ", with " : ", ") + name + "^2 = " + value;
    if (!place_.time.empty()) put += ", time multiplied by " + place_.time;
    return text + put;
  }

  // The assumptions of the file of the step must follow.
  std::string too_much_assumed() {
    std::vector<std::size_t> chosen;
    std::string implied;
    for (const Assumption& a : single_.assumptions) {
      for (const std::size_t v : used_variables(a.value))
        if (!map_.contains(v) && !is_level(v)) return "it assumes that " + a.text;
      if (uses_level(a.value)) { // levels may be chosen: one linear condition leaves some
        if (used_variables(a.value).size() != 1 || degree_of(a.value) != 1)
          return "it assumes that " + a.text;
        if (a.is(Sort::real)) continue;
        chosen.push_back(used_variables(a.value).front());
        if (std::ranges::count(chosen, chosen.back()) > 1)
          return "it assumes that " + a.text + ", besides another condition on this level";
        continue;
      }
      const MFraction value = composed(a.value, map_, ring());
      const auto* sign = std::get_if<Sign>(&a.says);
      if (sign ? !follows(value, *sign) : !a.is(Sort::real) || !is_real_there(value))
        return "it assumes that " + a.text;
      implied += (implied.empty() ? "" : ", ") + a.text;
    }
    for (const std::string& name : single_.real)
      if (const std::size_t i = *single_.ring()->find(name); !is_level(i) && !is_real_there(i))
        return "it assumes that " + name + " is real";
    if (!implied.empty())
      checks_.push_back({"what " + file_name(single_) + " assumes follows: " + implied, true});
    return "";
  }
  [[nodiscard]] bool is_level(std::size_t v) const {
    const auto& x = single_.field.components;
    return std::ranges::none_of(x, [&](const MFraction& f) { return !is_zero(f) && uses(f, v); });
  }
  [[nodiscard]] bool uses_level(const MFraction& f) const {
    const auto used = used_variables(f);
    return std::ranges::any_of(used, [&](std::size_t v) { return is_level(v); });
  }
  static long degree_of(const MFraction& f) {
    return is_constant(f.den()) ? degree(f.num(), used_variables(f).front()) : -1;
  }
  [[nodiscard]] bool is_real_there(std::size_t i) const {
    const auto there = map_.find(i);
    return there != map_.end() && is_real_there(there->second);
  }
  [[nodiscard]] bool is_real_there(const MFraction& value) const {
    return is_real(roots_.reduced(value.num())) && is_real(roots_.reduced(value.den()));
  }
  [[nodiscard]] bool follows(const MFraction& value, Sign sign) const {
    const MFraction num = roots_.reduced(value.num()), den = roots_.reduced(value.den());
    if (sign == Sign::zero) return is_zero(num);
    if (sign == Sign::nonzero) return !is_zero(num) && is_nonzero(num.num());
    if (region_.exact_sign_of(num.num()) * region_.exact_sign_of(num.den()) *
            region_.exact_sign_of(den.num()) * region_.exact_sign_of(den.den()) >
        0)
      return true; // whether or not all that it is made of is real
    const MFraction whole = num / den;
    const auto used = used_variables(whole);
    if (roots_.uses_root(whole) ||
        !std::ranges::all_of(used, [&](std::size_t i) { return region_.is_real(i); }))
      return false;
    const MPoly product = whole.num() * whole.den();
    if (sign == Sign::nonnegative && is_zero(product)) return true;
    if (region_.sign_of(product) > 0) return true;
    return region_.refutes({certify::negation({product, sign})});
  }

  // Made of real parameters and of roots of what is not negative.
  [[nodiscard]] bool is_real(const MFraction& f) const {
    const auto used = used_variables(f);
    return std::ranges::all_of(used, [&](std::size_t i) {
      const auto& roots = roots_.all();
      const auto root = std::ranges::find_if(roots, [&](const auto& r) { return r.first == i; });
      if (root == roots.end()) return region_.is_real(i);
      return is_real(root->second) && follows(root->second, Sign::nonnegative);
    });
  }

  const System& whole_;
  const System& base_;
  const System& single_;
  const Place& place_;
  PlaceScope scope_;
  Roots roots_;
  ParametrisedSet region_;
  std::map<std::size_t, MFraction> map_;
  std::vector<std::vector<MFraction>> jacobian_;
  MFraction time_;
  std::optional<MFraction> bracket_;
  CheckedIdentities checks_;
};

} // namespace

std::vector<Condition> conditions_of(const System& whole, const Place& place) {
  const PlaceScope scope(whole, {});
  Assumptions all;
  require(all, place, scope);
  return all.conditions;
}

Assumptions region_of(const System& whole, const Place& place) {
  const PlaceScope scope(whole, {});
  Assumptions all;
  for (const auto& [name, text] : place.at) {
    const auto i = scope.ring()->find(name);
    if (!i)
      throw InputError("theorem file", 0, 0, 1,
                       "'" + name + "' is not a parameter of " + file_name(whole));
    if (const auto own = whole.ring()->find(name); !own || !is_among(*own, whole.field.parameters))
      throw DomainError("'" + name + "' has a fixed value in " + file_name(whole));
    all.require(MFraction::variable(scope.ring(), *i) - scope.read(text), Sign::zero);
  }
  require(all, place, scope);
  return all;
}

Located locate(const std::string& whole, const std::string& base, const System& single,
               const Place& place) {
  const System there = read_system(whole, place.at);
  const System here = read_system(base, place.at);
  Located found = FieldComparison(there, here, single, place).run();
  found.region = region_of(read_system(whole), place);
  return found;
}

} // namespace kov
