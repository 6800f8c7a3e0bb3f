#include "parameter_points.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov::test {
namespace {

const std::string root_name = "t";

MFraction in_larger(const MFraction& f, const Ring& ring) {
  return is_zero(f) ? MFraction(ring) : transfer(f, ring);
}

bool contains(const std::vector<std::size_t>& all, std::size_t x) {
  return std::find(all.begin(), all.end(), x) != all.end();
}

} // namespace

RationalFunction ParameterPoint::at(const MFraction& f) const {
  const MFraction there = substitute(in_larger(f, larger()), values_);
  if (is_zero(there)) return {};
  if (field_->is_rational()) return to_rational_function(there, z_);
  return to_rational_function(there, z_, AlgebraicConstant{t_, field_});
}

NfElem ParameterPoint::number(const MFraction& f) const {
  const RationalFunction v = at(f);
  return is_zero(v) ? NfElem(0) : v.num().coeff(0) / v.den().coeff(0);
}

bool ParameterPoint::holds(const Condition& c) const {
  const NfElem v = number(MFraction(c.p));
  switch (c.sign) {
  case Sign::zero:
    return is_zero(v);
  case Sign::nonzero:
    return !is_zero(v);
  case Sign::positive:
    return is_rational(v) && sign(to_rational(v)) > 0;
  default:
    return is_rational(v) && sign(to_rational(v)) >= 0;
  }
}

bool ParameterPoint::meets(const Assumptions& all) const {
  const bool conditions = std::all_of(all.conditions.begin(), all.conditions.end(),
                                      [&](const Condition& c) { return holds(c); });
  const auto rational = [&](std::size_t i) {
    return is_rational(number(MFraction::variable(larger(), i)));
  };
  const auto member = [&](const Membership& m) {
    const NfElem v = number(m.value);
    return (is_rational(v) && is_integer(to_rational(v))) == m.in_integers;
  };
  return conditions && std::all_of(all.real.begin(), all.real.end(), rational) &&
         std::all_of(all.rational.begin(), all.rational.end(), rational) &&
         std::all_of(all.memberships.begin(), all.memberships.end(), member);
}

std::string ParameterPoint::minpoly() const {
  Poly m;
  long i = 0;
  for (const Integer& c : field_->minpoly_coefficients())
    m.set_coeff(i++, NfElem(Rational(c)));
  return to_string(m, root_name);
}

std::string ParameterPoint::minpoly_option() const {
  return field_->is_rational() ? "" : " --minpoly '" + minpoly() + "'";
}

std::string ParameterPoint::text(const Ring& ring) const {
  std::string s;
  for (const auto& [i, v] : values_)
    s += (s.empty() ? "" : ", ") + ring->name(i) + " = " + to_string(v);
  return field_->is_rational() ? s : s + ", t a root of " + minpoly();
}

namespace {

// Equations are solved one after the other: linear ones for a variable, the last one by a root.
class PointFinder {
public:
  PointFinder(const strata::Question& q, const std::vector<MPoly>& zero, Random& random)
      : q_(q), random_(random) {
    auto names = q.r.ring()->names();
    names.push_back(root_name);
    ring_ = make_ring(names);
    t_ = names.size() - 1;
    for (std::size_t i = 0; i < t_; ++i)
      if (i != q.z) free_.push_back(i);
    for (const MPoly& p : zero)
      if (!is_zero(p)) equations_.push_back(in_larger(MFraction(p), ring_).num());
  }

  std::optional<ParameterPoint> operator()() {
    while (random_.once_in(4) && !free_.empty()) // singular points are met on purpose
      set(random_.one_of(free_), MFraction(ring_, Rational(random_.between(-1, 1))));
    while (solve_a_linear_one()) {
    }
    if (!consistent() || equations_.size() > 1) return std::nullopt;
    if (equations_.size() == 1 ? !take_a_root() : !choose_freely()) return std::nullopt;
    Substitution values; // backwards: a value uses those that were set after it
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
      values[step->first] = substitute(step->second, values);
    return ParameterPoint(q_.z, t_, std::move(values), field_);
  }

private:
  void set(std::size_t x, const MFraction& value) {
    steps_.emplace_back(x, value);
    std::erase(free_, x);
    std::vector<MPoly> left;
    for (const MPoly& p : equations_) {
      const MFraction there = substitute(p, {{x, value}});
      if (!is_zero(there)) left.push_back(there.num());
    }
    equations_ = std::move(left);
  }

  [[nodiscard]] bool consistent() const {
    return std::none_of(equations_.begin(), equations_.end(),
                        [](const MPoly& p) { return is_constant(p); });
  }

  bool solve_a_linear_one() {
    for (const MPoly& p : equations_)
      for (const std::size_t x : used_variables(p)) {
        if (degree(p, x) != 1) continue;
        const auto line = coefficients(p, x);
        set(x, -(MFraction(line[0]) / MFraction(line[1])));
        return true;
      }
    return false;
  }

  Rational rational() { return {random_.between(-6, 9), random_.between(1, 4)}; }

  bool take_a_root() {
    const auto used = used_variables(equations_.front());
    const std::size_t x = random_.one_of(used);
    for (const std::size_t i : std::vector(free_))
      if (i != x) set(i, MFraction(ring_, rational()));
    if (equations_.empty()) {
      set(x, MFraction(ring_, rational()));
      return true;
    }
    if (!consistent()) return false;
    const MPoly p = random_.one_of(irreducible_parts(equations_.front()));
    const auto c = coefficients(p, x);
    const long n = degree(p, x);
    const auto number = [](const MPoly& f) { return is_zero(f) ? Integer(0) : f.coefficient(0); };
    const Integer lead = number(c.back());
    if (n == 1) {
      set(x, MFraction(ring_, -(Rational(number(c[0])) / Rational(lead))));
      return true;
    }
    if (n > 3) return false;
    std::vector<Integer> minimal; // of lead*x
    for (long i = 0; i < n; ++i)
      minimal.push_back(number(c[static_cast<std::size_t>(i)]) *
                        pow(lead, static_cast<unsigned long>(n - 1 - i)));
    minimal.emplace_back(1);
    field_ = make_field(minimal, root_name);
    set(x, (Rational(1) / Rational(lead)) * MFraction::variable(ring_, t_));
    return true;
  }

  bool choose_freely() {
    const bool gaussian = random_.once_in(2);
    const MFraction i = MFraction::variable(ring_, t_);
    bool complex = false;
    for (const std::size_t x : std::vector(free_)) {
      MFraction v(ring_, rational());
      if (gaussian && !contains(q_.assumptions.real, x) && !contains(q_.assumptions.rational, x)) {
        if (random_.once_in(2)) v = MFraction(ring_);
        v += MFraction(ring_, rational()) * i;
        complex = true;
      }
      set(x, v);
    }
    if (complex) field_ = make_field({1, 0, 1}, root_name);
    return true;
  }

  const strata::Question& q_;
  Random& random_;
  Ring ring_;
  std::size_t t_ = 0;
  std::vector<std::size_t> free_;
  std::vector<MPoly> equations_;
  std::vector<std::pair<std::size_t, MFraction>> steps_;
  Field field_ = rationals();
};

} // namespace

std::optional<ParameterPoint> random_point(const strata::Question& q,
                                           const std::vector<MPoly>& zero, Random& random) {
  try {
    return PointFinder(q, zero, random)();
  } catch (const DomainError&) { // a denominator that vanishes there
    return std::nullopt;
  }
}

} // namespace kov::test
