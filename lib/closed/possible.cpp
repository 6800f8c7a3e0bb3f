#include "closed/possible.hpp"

#include "closed/statement.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

constexpr std::size_t most_values = 4000; // of t

// x = slope t + at
struct Line {
  Rational slope, at;
};
Line operator+(const Line& a, const Line& b) { return {a.slope + b.slope, a.at + b.at}; }
Line operator-(const Line& a) { return {-a.slope, -a.at}; }
NfElem value(const Line& x, const NfElem& t) { return NfElem(x.slope) * t + NfElem(x.at); }

// t is a function of the parameters, or a square root of one.
struct Base {
  MFraction t;
  bool squared = false; ///< t^2 is given
};

std::optional<Line> line_of_function(const MFraction& f, const MFraction& t) {
  if (const auto c = constant_value(f)) return Line{Rational(0), *c};
  const std::size_t x = used_variables(t).front();
  const auto slope = constant_value(derivative(f, x) / derivative(t, x));
  if (!slope) return std::nullopt;
  const auto at = constant_value(f - *slope * t);
  return at ? std::optional(Line{*slope, *at}) : std::nullopt;
}

// The line of the number with this square, up to sign.
std::optional<Line> line_of_root(const MFraction& square, const Base& base) {
  if (is_number(square)) {
    const auto root = constant_root(square);
    return root ? std::optional(Line{Rational(0), *root}) : std::nullopt;
  }
  if (base.squared) {
    const auto c = constant_value(square / base.t);
    const auto slope = c ? exact_sqrt(*c) : std::nullopt;
    return slope ? std::optional(Line{*slope, Rational(0)}) : std::nullopt;
  }
  const auto root = square_root(square);
  return root ? line_of_function(*root, base.t) : std::nullopt;
}

const Squares* squares_in(const Assertion& s) {
  if (std::holds_alternative<LameIsFinite>(s) || std::holds_alternative<SeparatedPair>(s))
    return nullptr; // not about exponents, one by one
  return &squares_of(s);
}

std::vector<Base> bases(const std::vector<Statement>& all, const ParametrisedSet& region) {
  std::vector<Base> found;
  const auto add = [&](Base b) {
    if (std::ranges::none_of(found, [&](const Base& old) {
          return old.squared == b.squared &&
                 (old.squared ? constant_value(b.t / old.t).has_value()
                              : line_of_function(b.t, old.t).has_value());
        }))
      found.push_back(std::move(b));
  };
  for (const Statement& c : all)
    if (const Squares* squares = squares_in(c.says))
      for (const MFraction& s : *squares)
        if (!is_number(s)) {
          const auto root = square_root(s);
          add({root ? *root : s, !root});
        }
  for (const Membership& m : region.memberships())
    if (!is_number(m.value)) add({m.value});
  return found;
}

std::vector<Line> signed_sums(const std::vector<Line>& lines) {
  std::vector<Line> sums;
  for (const Line& x : lines) {
    std::vector<Line> more;
    for (const Line& s : sums) {
      more.push_back(s + x);
      more.push_back(s + -x);
    }
    if (sums.empty()) more.push_back(x);
    sums = std::move(more);
  }
  return sums;
}

// a/b and c/d: the least common multiple of the numerators over the gcd of the denominators.
Rational common_multiple(const Rational& a, const Rational& b) {
  return {lcm(a.num(), b.num()), gcd(a.den(), b.den())};
}

// The conditions that are about linear functions of t.
class ConditionsOnLine {
public:
  ConditionsOnLine(const Base& base, const std::vector<Statement>& all,
                   const ParametrisedSet& region)
      : base_(base), region_(region) {
    for (const Statement& c : all)
      if (add(c)) conditions_.push_back(&c);
    if (base.squared) return;
    for (const Membership& m : region.memberships())
      if (const auto x = line_of_function(m.value, base.t)) {
        memberships_.emplace_back(*x, m.in_integers);
        add_values({*x}, all_integers);
        all_.push_back(*x);
      }
  }

  [[nodiscard]] bool empty() {
    find_window();
    if (!within_limit() || irrational_point()) return false;
    std::vector<Rational> values = critical_values();
    Integer den(1);
    for (const Rational& t : values)
      den = lcm(den, t.den());
    const NfElem other(
        Rational(Integer(1), Integer(2) * den + Integer(1))); // rational, not critical
    if (holds(other)) return false;
    return std::ranges::none_of(values,
                                [&](const Rational& t) { return holds(NfElem(t)) && admitted(t); });
  }

private:
  struct Critical { // where the line is in the class the truth may change
    Line x;
    Residues c;
  };

  bool add(const Statement& c) {
    const Squares* squares = squares_in(c.says);
    if (squares == nullptr) return false;
    std::vector<Line> lines;
    for (const MFraction& s : *squares) {
      const auto x = line_of_root(s, base_);
      if (!x) return false;
      lines.push_back(*x);
    }
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!is_zero((*squares)[i])) values_.emplace_back((*squares)[i], lines[i]);
    all_.insert(all_.end(), lines.begin(), lines.end());
    for (const auto& some : subsets(lines))
      for (const Line& x : signed_sums(some))
        if (!is_zero(x.slope)) bound_ = std::max(bound_, abs(x.at / x.slope));
    std::visit([&](const auto& s) { find_critical(s, lines); }, c.says);
    return true;
  }
  static std::vector<std::vector<Line>> subsets(const std::vector<Line>& lines) {
    std::vector<std::vector<Line>> all{{}};
    for (const Line& x : lines)
      for (std::size_t i = all.size(); i-- > 0;) {
        all.push_back(all[i]);
        all.back().push_back(x);
      }
    all.erase(all.begin());
    return all;
  }

  void add_values(const std::vector<Line>& lines, const Residues& c) {
    step_ = common_multiple(step_, c.step);
    for (const Line& x : signed_sums(lines))
      if (!is_zero(x.slope)) {
        critical_.push_back({x, c});
        if (!is_zero(c.a)) critical_.push_back({x, {-c.a, c.step}});
      }
  }
  void find_critical(const SumIn& s, const std::vector<Line>& lines) {
    for (const Residues& c : s.classes)
      add_values(lines, c);
  }
  void find_critical(const AllRational&, const std::vector<Line>&) {}
  void find_critical(const SomeIn& s, const std::vector<Line>& lines) {
    for (const Line& x : lines)
      for (const Residues& c : s.classes.value_or(Classes{}))
        add_values({x}, c);
  }
  void find_critical(const Separated&, const std::vector<Line>& lines) {
    for (const Line& x : lines)
      add_values({x}, all_integers);
  }
  void find_critical(const WithoutLogarithm&, const std::vector<Line>& lines) {
    for (const auto& some : subsets(lines))
      if (some.size() < 3) add_values(some, all_integers);
  }
  void find_critical(const InRow&, const std::vector<Line>& lines) { // denominators up to 5
    for (const Line& x : lines)
      for (const long d : {3, 4, 5})
        add_values({x}, {Rational(0), Rational(1, d)});
  }
  void find_critical(const SeparatedPair&, const std::vector<Line>&) {}
  void find_critical(const LameIsFinite&, const std::vector<Line>&) {}

  // For |t| > bound_ no sum changes its sign, and t + period_ is like t.
  void find_window() {
    period_ = Rational(1);
    for (const Line& x : all_)
      if (!is_zero(x.slope)) period_ = common_multiple(period_, step_ / abs(x.slope));
  }
  [[nodiscard]] bool within_limit() const {
    Rational count(0);
    for (const Critical& c : critical_)
      count = count + Rational(2) * (bound_ + period_) * abs(c.x.slope) / c.c.step + Rational(1);
    return count < Rational(static_cast<long>(most_values));
  }
  [[nodiscard]] std::vector<Rational> critical_values() const {
    const Rational end = bound_ + period_;
    std::vector<Rational> all;
    for (const Critical& c : critical_) { // slope t + at = a + step k
      const Rational step = c.c.step / abs(c.x.slope);
      const Rational first = (c.c.a - c.x.at) / c.x.slope;
      for (Rational t = first - Rational(floor((first + end) / step)) * step; !(end < t);
           t = t + step)
        all.push_back(t);
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  [[nodiscard]] bool holds(const NfElem& t) const {
    const bool member = std::ranges::all_of(memberships_, [&](const auto& m) {
      const NfElem v = value(m.first, t);
      return (is_rational(v) && is_integer(to_rational(v))) == m.second;
    });
    const auto square = [&](const MFraction& s) {
      const auto found =
          std::ranges::find_if(values_, [&](const auto& known) { return known.first == s; });
      const NfElem x = value(found->second, t);
      return x * x;
    };
    return member &&
           std::ranges::all_of(conditions_, [&](const auto* c) { return is_so(*c, square); });
  }

  // All irrational t are alike: sqrt(2) stands for them.
  [[nodiscard]] bool irrational_point() const {
    const auto used = used_variables(base_.t);
    const bool rational = !base_.squared && std::ranges::all_of(used, [&](std::size_t i) {
      return region_.is_rational(i);
    });
    static const Field field = make_field({-2, 0, 1}, "w");
    return !rational && holds(NfElem::generator(field));
  }

  // t may have this value, or one that differs from it by a multiple of the period.
  [[nodiscard]] bool admitted(const Rational& t) const {
    const MFraction f = base_.t - MFraction(base_.t.ring(), base_.squared ? t * t : t);
    if (!is_plainly_nonzero(f.num(), region_)) return true;
    if (!(bound_ < abs(t))) return false;
    if (base_.squared || !is_constant(base_.t.den())) return true;
    // t and what is beyond it
    const MFraction beyond = Rational(sign(t)) * base_.t - MFraction(base_.t.ring(), bound_);
    const MPoly den = beyond.den();
    return region_.exact_sign_of(beyond.num()) * sign(den.coefficient(0)) >= 0;
  }

  const Base& base_;
  const ParametrisedSet& region_;
  std::vector<const Statement*> conditions_;
  std::vector<std::pair<Line, bool>> memberships_;
  std::vector<std::pair<MFraction, Line>> values_; ///< squares, and their roots
  std::vector<Line> all_;
  std::vector<Critical> critical_;
  Rational step_{2}, bound_{0}, period_{1};
};

} // namespace

bool proved_empty(const std::vector<Statement>& all, const ParametrisedSet& region) {
  const auto found = bases(all, region);
  return std::ranges::any_of(
      found, [&](const Base& base) { return ConditionsOnLine(base, all, region).empty(); });
}

} // namespace kov::strata
