#include "flow/scene/starts.hpp"

#include "exact/error.hpp"
#include "flow/number/rounded.hpp"
#include "symbol/input_error.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace kov::flow {
namespace {

// ---- functions of one argument ----

using MpfrFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

struct KnownFunction {
  MpfrFunction exact = nullptr;
  double (*quick)(double) = nullptr; ///< to a few units of the last digit
};

template <unsigned n> int nth_root(mpfr_ptr to, mpfr_srcptr x, mpfr_rnd_t mode) {
  return mpfr_rootn_ui(to, x, n, mode);
}
template <unsigned n> double quick_root(double x) {
  return n % 2 == 1 ? std::copysign(std::pow(std::abs(x), 1.0 / n), x) : std::pow(x, 1.0 / n);
}
template <unsigned... n>
void add_roots(std::map<std::string, KnownFunction>& all,
               std::integer_sequence<unsigned, n...> /*orders*/) {
  (all.emplace("root" + std::to_string(n), KnownFunction{nth_root<n>, quick_root<n>}), ...);
}

KnownFunction known_function(const std::string& name) {
  static const std::map<std::string, KnownFunction> all = [] {
    std::map<std::string, KnownFunction> named{
        {"sin", {mpfr_sin, std::sin}},
        {"cos", {mpfr_cos, std::cos}},
        {"tan", {mpfr_tan, std::tan}},
        {"exp", {mpfr_exp, std::exp}},
        {"log", {mpfr_log, std::log}},
        {"sqrt", {mpfr_sqrt, std::sqrt}},
        {"sinh", {mpfr_sinh, std::sinh}},
        {"cosh", {mpfr_cosh, std::cosh}},
        {"tanh", {mpfr_tanh, std::tanh}},
        {"atan", {mpfr_atan, std::atan}},
        {"asin", {mpfr_asin, std::asin}},
        {"acos", {mpfr_acos, std::acos}},
        {"cot", {mpfr_cot, [](double x) { return 1 / std::tan(x); }}},
        {"sec", {mpfr_sec, [](double x) { return 1 / std::cos(x); }}},
        {"csc", {mpfr_csc, [](double x) { return 1 / std::sin(x); }}}};
    add_roots(named, std::integer_sequence<unsigned, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,
                                           16, 17, 18, 19, 20, 21, 22, 23, 24>{});
    return named;
  }();
  const auto found = all.find(name);
  return found == all.end() ? KnownFunction{} : found->second;
}

template <class R> R value_of(MpfrFunction f, const R& x) {
  const PrecisionScope scope(std::max<long>(BigReal::bits(), 160));
  BigReal y = to_big(x);
  f(y.raw(), y.raw(), MPFR_RNDN);
  return rounded<R>(y);
}

// ---- coordinates -> all variables ----

const FunctionMeaning& meaning_of(const SystemScene& s, std::size_t variable) {
  for (const FunctionMeaning& m : s.meanings)
    if (m.variable == variable && known_function(m.name).exact != nullptr) return m;
  throw InputError(
      s.file, 0, 0, 1,
      "the function '" + s.system.ring()->name(variable) + "' has no value to start with",
      "means = \"sin(q)\": sin, cos, tan, exp, log, sqrt, sinh, cosh, tanh, atan, asin, acos");
}

template <class R> class Lift {
public:
  Lift(const SystemScene& s, const Field& f)
      : coordinates_(f.coordinates()), n_(f.variables().size()) {
    for (std::size_t i = coordinates_; i < n_; ++i) {
      const FunctionMeaning& m = meaning_of(s, f.variables()[i]);
      functions_.push_back({known_function(m.name).exact, Evaluator<R>(f, {m.argument})});
    }
  }
  // Twice, for arguments that are functions themselves: later ones may be needed by earlier ones.
  std::vector<R> operator()(const std::vector<R>& coordinates) {
    std::vector<R> x = coordinates;
    x.resize(n_);
    for (std::size_t round = 0; round <= functions_.size() && round < 4; ++round)
      for (std::size_t i = 0; i < functions_.size(); ++i)
        x[coordinates_ + i] = value_of(functions_[i].first, R(functions_[i].second(x.data())[0]));
    return x;
  }

  void set(const R* numbers) {
    for (auto& [function, argument] : functions_)
      argument.set(numbers);
  }

private:
  std::size_t coordinates_, n_;
  std::vector<std::pair<MpfrFunction, Evaluator<R>>> functions_;
};

// ---- equations ----

// False: the others are as many as coordinates.
bool section_is_one(const SystemScene& s) {
  return s.levels.size() + s.start.size() + 2 != s.system.field.dimension();
}

// The functions that have a known value at a start; the last two are those drawn.
std::vector<MFraction> equations_of(const SystemScene& s) {
  std::vector<MFraction> all;
  if (section_is_one(s)) all.push_back(s.section.value);
  for (const auto& level : s.levels)
    all.push_back(level.function.value);
  for (const SceneFormula& f : s.start)
    all.push_back(f.value);
  for (const SceneFormula& f : s.plot)
    all.push_back(f.value);
  return all;
}

template <class R> std::vector<R> targets_of(const SystemScene& s, const std::array<R, 2>& drawn) {
  std::vector<R> all;
  if (section_is_one(s)) all.push_back(R(0));
  for (const auto& level : s.levels)
    all.push_back(level.value.template as<R>());
  for (std::size_t i = 0; i < s.start.size(); ++i)
    all.push_back(R(0));
  all.insert(all.end(), drawn.begin(), drawn.end());
  return all;
}

// Values and derivatives by the coordinates of the equations.
template <class R> class StartEquations {
public:
  StartEquations(const SystemScene& s, const Field& f)
      : n_(f.coordinates()), lift_(s, f), all_(f, with_derivatives(s)) {}
  struct At {
    std::vector<R> value;            ///< of each equation
    std::vector<std::vector<R>> row; ///< its derivatives
  };
  At operator()(const std::vector<R>& coordinates) {
    const std::vector<R> x = lift_(coordinates);
    const std::vector<R>& all = all_(x.data());
    At at;
    for (std::size_t i = 0; i * (n_ + 1) < all.size(); ++i) {
      const auto from = all.begin() + static_cast<long>(i * (n_ + 1));
      at.value.push_back(*from);
      at.row.emplace_back(from + 1, from + static_cast<long>(n_) + 1);
    }
    return at;
  }
  void set(const R* numbers) {
    lift_.set(numbers);
    all_.set(numbers);
  }

private:
  static std::vector<MFraction> with_derivatives(const SystemScene& s) {
    std::vector<MFraction> all;
    for (const MFraction& f : equations_of(s)) {
      all.push_back(f);
      for (std::size_t j = 0; j < s.system.field.dimension(); ++j)
        all.push_back(partial(s.system.field, f, j));
    }
    return all;
  }
  std::size_t n_;
  Lift<R> lift_;
  Evaluator<R> all_;
};

template <class R> R size_of(const R& x) { return x < R(0) ? R(R(0) - x) : x; }

// a x = b by elimination with pivots; empty if singular.
template <class R> std::vector<R> solve(std::vector<std::vector<R>> a, std::vector<R> b) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (size_of(a[r][c]) > size_of(a[best][c])) best = r;
    if (!(size_of(a[best][c]) > R(0))) return {};
    std::swap(a[c], a[best]);
    std::swap(b[c], b[best]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const R factor = a[r][c] / a[c][c];
      for (std::size_t k = c; k < n; ++k)
        a[r][k] -= factor * a[c][k];
      b[r] -= factor * b[c];
    }
  }
  for (std::size_t c = 0; c < n; ++c)
    b[c] = b[c] / a[c][c];
  return b;
}

// One step of Newton's method; false if there is none.
template <class R>
bool newton_step(StartEquations<R>& equations, const std::vector<R>& targets, std::vector<R>& x) {
  const auto at = equations(x);
  std::vector<R> rest;
  for (std::size_t i = 0; i < targets.size(); ++i)
    rest.push_back(R(targets[i] - at.value[i]));
  const std::vector<R> d = solve(at.row, rest);
  if (d.empty()) return false;
  for (std::size_t j = 0; j < x.size(); ++j)
    x[j] += d[j];
  return true;
}

// ---- all starts over one place of the picture ----

// The real roots of c_0 + c_1 u + ... .
std::vector<double> real_roots(std::vector<double> c) {
  while (!c.empty() && c.back() == 0)
    c.pop_back();
  if (c.size() < 2 || c.size() > 64) return {};
  double bound = 0;
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    bound = std::max(
        bound, std::pow(std::abs(c[i] / c.back()), 1.0 / static_cast<double>(c.size() - 1 - i)));
  bound *= 2.1; // [Fujiwara1916]
  if (!(bound > 0) || !std::isfinite(bound)) return {};
  const int degree = static_cast<int>(c.size()) - 1;
  std::vector<double> b = c; // in u = bound (2 x - 1), x in [0, 1]
  double power = 1;
  for (double& x : b) {
    x *= power;
    power *= 2 * bound;
  }
  for (int i = 0; i < degree; ++i) // Taylor shift by -1/2
    for (int k = degree - 1; k >= i; --k)
      b[static_cast<std::size_t>(k)] -= b[static_cast<std::size_t>(k) + 1] / 2;
  bool above = b[0] > 0;
  int tangencies = 0;
  Root<double> roots[64];
  const int n = sign_changes(b.data(), degree, 0.0, above, true, true, roots, 64, tangencies);
  std::vector<double> all;
  for (int i = 0; i < n; ++i)
    all.push_back(bound * (2 * roots[i].x - 1));
  return all;
}

// The points of a body over a place of the sphere: N = M - B = G n with the unit vector n = (sqrt(1-y^2) sin l, sqrt(1-y^2) cos l, y),
// y = L/G, and on the section g = pi/2 (side +1) or 3pi/2 (side -1), with F1 = Gamma.Gamma and s = F2/(G sqrt F1):
//   Gamma = sqrt(F1) ( s n +- sqrt(1-s^2) (cos l, -sin l, 0) )      (paper, eq. (ADvariables) at cos g = 0).
// So (l, y) and G >= |F2|/sqrt F1 give a point, and the energy fixes G.  (The general search has six equations there.)
template <class R> class OverSphere {
public:
  OverSphere(const SystemScene& s, const Field& f)
      : own_(s.body->own), energy_(f, {*s.system.field.hamiltonian}), level_(own_.energy.as<R>()),
        length_(own_.length.as<R>()), casimir_(own_.casimir.as<R>()) {}

  /// Every G that the level allows, ascending; found by a scan of 400 values and bisection, so that two values closer
  /// than the scan may be missed.
  std::vector<std::vector<R>> all(const R& l, const R& y) {
    const double most = largest_momentum();
    const double least = std::abs(casimir_) / std::sqrt(length_) * (1 + 1e-13);
    std::vector<std::vector<R>> found;
    const int cells = 400;
    const double start = std::max(least, most * 1e-9);
    double low = start, at_low = excess(l, y, low);
    for (int i = 1; i <= cells && most > start; ++i) {
      const double high = start + (most - start) * i / cells;
      const double at_high = excess(l, y, high);
      if ((at_low > 0) != (at_high > 0)) {
        double a = low, c = high;
        for (int k = 0; k < 100; ++k) {
          const double middle = (a + c) / 2;
          ((excess(l, y, middle) > 0) == (at_low > 0) ? a : c) = middle;
        }
        found.push_back(at(l, y, a));
      }
      low = high;
      at_low = at_high;
    }
    return found;
  }

  /// That near another one, to the last digit: secant steps on H(G) = H.
  std::vector<R> near(const R& l, const R& y, double size) {
    const auto positive = [](const R& x) { return x < R(0) ? R(R(0) - x) : x; };
    R g0 = R(size), g1 = R(size) * (R(1) + R(1) / R(1 << 30));
    R e0 = excess(l, y, g0), e1 = excess(l, y, g1);
    for (int i = 0; i < 12 && !(e1 == e0); ++i) {
      const R g2 = g1 - e1 * (g1 - g0) / (e1 - e0);
      if (g2 == g1) break;
      g0 = g1;
      e0 = e1;
      g1 = g2;
      e1 = excess(l, y, g1);
    }
    return at(l, y, positive(e0) < positive(e1) ? g0 : g1);
  }

private:
  const Scene& own_;
  Evaluator<R> energy_;
  R level_, length_, casimir_;

  [[nodiscard]] std::vector<R> at(const R& l, const R& y, const R& size) const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const R sl = sin(l), cl = cos(l), root = sqrt(length_), s = casimir_ / (size * root);
    const R below = sqrt(R(1) - y * y), flat = root * sqrt(R(1) - s * s);
    const R across = own_.section.side > 0 ? flat : R(R(0) - flat);
    const std::array<R, 3> n{R(below * sl), R(below * cl), y};
    return {size * n[0],
            size * n[1],
            size * n[2],
            root * s * n[0] + across * cl,
            root * s * n[1] - across * sl,
            root * s * y};
  }
  R excess(const R& l, const R& y, const R& size) {
    return energy_(at(l, y, size).data())[0] - level_;
  }

  // A bound of G: H >= M^2/(2 tr J) - weight with J = I + m v v^T, |v| <= |L| |Gamma|, for the sliding tip and
  // J = I otherwise, |m g L.Gamma| <= weight.
  [[nodiscard]] double largest_momentum() const {
    const auto sum = [](const std::array<Quantity, 3>& v) {
      double all = 0;
      for (const Quantity& q : v)
        all += std::abs(q.as<double>());
      return all;
    };
    const double lever = sum(own_.lever), mass = own_.mass.as<double>();
    double moments = sum({own_.inertia[0][0], own_.inertia[1][1], own_.inertia[2][2]});
    if (own_.sliding) moments += mass * lever * lever * length_;
    const double weight = mass * std::abs(own_.gravity.as<double>()) * lever * std::sqrt(length_);
    return std::sqrt(2 * moments * (std::abs(level_) + weight)) * 1.01 + 2 * sum(own_.gyrostat);
  }
};

// The largest difference.
double largest_difference(const std::vector<double>& value, const std::vector<double>& targets) {
  double most = 0;
  for (std::size_t i = 0; i < targets.size(); ++i)
    most = std::max(most, std::isfinite(value[i]) ? std::abs(value[i] - targets[i]) : INFINITY);
  return most;
}

class Sheets {
public:
  Sheets(const SystemScene& s, const Field& f) : s_(s), f_(f), n_(f.coordinates()), lift_(s, f) {
    std::vector<MFraction> conditions{lie_derivative(s.system.field, s.section.value)};
    if (s.where) conditions.push_back(s.where->value);
    conditions_ = std::make_unique<Evaluator<double>>(f, conditions);
    if (s.body) sphere_ = std::make_unique<OverSphere<double>>(s, f);
    if (s.body) return;
    equations_ = std::make_unique<StartEquations<double>>(s, f);
    plan();
  }

  /// The states over this place.
  std::vector<std::vector<double>> over(const std::array<double, 2>& drawn) {
    std::vector<std::vector<double>> found;
    if (s_.body) {
      found = sphere_->all(drawn[0], drawn[1]);
      const SectionRule& rule = s_.body->own.section;
      std::erase_if(found, [&](const auto& x) { // on a pole the rate is 0
        return !((*conditions_)(x.data())[0] > 0 ? rule.rising : rule.falling);
      });
      return found;
    }
    const std::vector<double> targets = targets_of(s_, drawn);
    for (const std::vector<double>& guess : guesses(targets))
      if (auto x = solution(guess, targets)) add(found, *x);
    std::ranges::sort(found);
    return found;
  }

  void set(const double* numbers) {
    if (equations_) equations_->set(numbers);
    lift_.set(numbers);
    conditions_->set(numbers);
    if (polynomial_) polynomial_->set(numbers);
  }

  [[nodiscard]] bool in_direction(const std::vector<double>& coordinates) {
    const std::vector<double> x = lift_(coordinates);
    const auto& at = (*conditions_)(x.data());
    if (!(at[0] > 0 ? s_.rising : at[0] < 0 && s_.falling)) return false;
    return at.size() < 2 || at[1] > 0;
  }

private:
  struct Linear { // equation `number` gives coordinate `place`: c0 + c1 x
    std::size_t number, place;
    double c0, c1;
  };

  void plan() {
    const std::vector<MFraction> all = equations_of(s_);
    if (all.size() != n_)
      throw InputError(
          s_.file, 0, 0, 1,
          std::to_string(n_) + " coordinates at a start, but section, levels, start and plot are " +
              std::to_string(all.size()) + " equations",
          all.size() < n_
              ? "levels = {...} or start = [\"x = 0\", ...] give more; or give whole states"
              : "leave some out, or give whole states");
    std::vector<bool> used(all.size()), known(n_);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const auto one = linear(all[i], i); one && !known[one->place]) {
        linear_.push_back(*one);
        used[i] = known[one->place] = true;
      }
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!used[i]) open_.push_back(i);
    for (std::size_t j = 0; j < n_; ++j)
      if (!known[j]) unknown_.push_back(j);
    if (unknown_.size() == 1) plan_polynomial(all[open_[0]]);
  }

  [[nodiscard]] std::optional<Linear> linear(const MFraction& f, std::size_t number) const {
    const auto variables = used_variables(f);
    if (variables.size() != 1 || !is_constant(MFraction(f.den())) ||
        degree(f.num(), variables[0]) != 1)
      return std::nullopt;
    const auto& x = s_.system.field.coordinates;
    const auto place = std::ranges::find(x, variables[0]);
    if (place == x.end()) return std::nullopt;
    const auto c = coefficients(f.num(), variables[0]);
    const Rational den = to_rational(MFraction(f.den()));
    return Linear{number, static_cast<std::size_t>(place - x.begin()),
                  number_as<double>(to_rational(MFraction(c[0])) / den),
                  number_as<double>(to_rational(MFraction(c[1])) / den)};
  }

  // num - target den, as a polynomial in the unknown, if no function depends on that.
  void plan_polynomial(const MFraction& f) {
    const std::size_t u = s_.system.field.coordinates[unknown_[0]];
    for (const FunctionMeaning& m : s_.meanings)
      if (uses(m.argument, u)) return;
    std::vector<MFraction> parts;
    for (const MPoly& part : {f.num(), f.den()}) {
      const auto c = coefficients(part, u);
      (parts.empty() ? num_terms_ : den_terms_) = c.size();
      for (const MPoly& one : c)
        parts.emplace_back(one);
    }
    polynomial_ = std::make_unique<Evaluator<double>>(f_, parts);
  }

  std::vector<std::vector<double>> guesses(const std::vector<double>& targets) {
    std::vector<double> x(n_);
    for (const Linear& l : linear_)
      x[l.place] = (targets[l.number] - l.c0) / l.c1;
    if (unknown_.empty()) return {x};
    return polynomial_ ? roots_over(x, targets[open_[0]]) : scattered(x);
  }

  std::vector<std::vector<double>> roots_over(std::vector<double> x, double target) {
    const std::vector<double> all = lift_(x);
    const auto& c = (*polynomial_)(all.data());
    std::vector<double> p(std::max(num_terms_, den_terms_));
    for (std::size_t i = 0; i < num_terms_; ++i)
      p[i] += c[i];
    for (std::size_t i = 0; i < den_terms_; ++i)
      p[i] -= target * c[num_terms_ + i];
    std::vector<std::vector<double>> guesses;
    for (const double root : real_roots(p)) {
      x[unknown_[0]] = root;
      guesses.push_back(x);
    }
    return guesses;
  }

  // The same for every place: starts do not depend on chance.
  [[nodiscard]] std::vector<std::vector<double>> scattered(const std::vector<double>& x) const {
    std::mt19937 gen(20);
    std::uniform_real_distribution<double> size(-1.5, 1.0), sign(-1, 1);
    std::vector<std::vector<double>> guesses;
    for (int i = 0; i < 64; ++i) {
      guesses.push_back(x);
      for (const std::size_t j : unknown_)
        guesses.back()[j] = std::copysign(std::pow(10, size(gen)), sign(gen));
    }
    return guesses;
  }

  // Newton's method with halved steps.
  std::optional<std::vector<double>> solution(std::vector<double> x,
                                              const std::vector<double>& targets) {
    auto at = (*equations_)(x);
    double size = largest_difference(at.value, targets);
    for (int i = 0; i < 60 && size > 0; ++i) {
      std::vector<double> rest;
      for (std::size_t k = 0; k < targets.size(); ++k)
        rest.push_back(targets[k] - at.value[k]);
      const std::vector<double> d = solve(at.row, rest);
      if (d.empty()) return std::nullopt;
      double part = 1;
      bool better = false;
      for (; part > 1e-4 && !better; part /= 2) {
        std::vector<double> next = x;
        for (std::size_t j = 0; j < n_; ++j)
          next[j] += part * d[j];
        const auto there = (*equations_)(next);
        if (const double now = largest_difference(there.value, targets); now < size) {
          better = true;
          x = next;
          at = there;
          size = now;
        }
      }
      if (!better) break;
    }
    double scale = 1e-300; // what rounding leaves of an equation
    for (const auto& row : at.row)
      for (std::size_t j = 0; j < n_; ++j)
        scale = std::max(scale, std::abs(row[j]) * std::max(std::abs(x[j]), 1e-3));
    return size <= 1e-10 * scale ? std::optional(x) : std::nullopt;
  }

  void add(std::vector<std::vector<double>>& found, const std::vector<double>& x) {
    if (!in_direction(x)) return;
    for (const auto& other : found) {
      double apart = 0;
      for (std::size_t j = 0; j < n_; ++j)
        apart = std::max(apart, std::abs(x[j] - other[j]) / (1e-3 + std::abs(x[j])));
      if (apart < 1e-6) return;
    }
    found.push_back(x);
  }

  const SystemScene& s_;
  const Field& f_;
  std::size_t n_;
  std::unique_ptr<OverSphere<double>> sphere_;        ///< for a body
  std::unique_ptr<StartEquations<double>> equations_; ///< for any other system
  Lift<double> lift_;
  std::unique_ptr<Evaluator<double>> conditions_, polynomial_;
  std::vector<Linear> linear_;
  std::vector<std::size_t> open_, unknown_; ///< equations; coordinates
  std::size_t num_terms_ = 0, den_terms_ = 0;
};

std::array<double, 2> numbers(const std::array<Quantity, 2>& pair) {
  return {pair[0].as<double>(), pair[1].as<double>()};
}

class Collection {
public:
  Collection(const SystemScene& s, const Field& f, const std::atomic<bool>* stop)
      : s_(s), stop_(stop), drawn_(f, {s.plot[0].value, s.plot[1].value}), lift_(s, f) {
    if (!s.seeds.empty() || s.columns > 0 || s.random > 0) sheets_ = std::make_unique<Sheets>(s, f);
  }

  std::vector<FieldStart> all(std::size_t* skipped) {
    for (std::size_t i = 0; i < s_.states.size(); ++i)
      state(i);
    for (std::size_t i = 0; i < s_.seeds.size(); ++i)
      if (!place(numbers(s_.seeds[i]), i))
        throw InputError(s_.file, 0, 0, 1,
                         "the level has no point over " + s_.plot[0].text + " = " +
                             s_.seeds[i][0].text() + ", " + s_.plot[1].text + " = " +
                             s_.seeds[i][1].text() + " with the wanted direction",
                         "a grid instead of seeds shows where the level has points");
    std::size_t missing = grid();
    random();
    if (starts_.empty() && stopped())
      throw InputError(s_.file, 0, 0, 1, "stopped before a place on the level was found");
    if (starts_.empty())
      throw InputError(s_.file, 0, 0, 1,
                       "no place of the range lies on the level with the wanted direction",
                       "other [scene.levels], a wider range, or direction = \"both\"");
    if (skipped != nullptr) *skipped = missing;
    return std::move(starts_);
  }

private:
  void state(std::size_t i) {
    FieldStart start;
    for (const Quantity& x : s_.states[i])
      start.x.push_back(x.as<double>());
    const std::vector<double> x = lift_(start.x);
    const auto& drawn = drawn_(x.data());
    start.drawn = {drawn[0], drawn[1]};
    start.state = i;
    starts_.push_back(start);
  }

  bool place(const std::array<double, 2>& drawn, std::optional<std::size_t> seed) {
    if (stopped()) return true;
    const auto states = sheets_->over(drawn);
    for (const auto& x : states)
      starts_.push_back({x, drawn, seed, std::nullopt});
    return !states.empty();
  }

  std::size_t grid() {
    std::size_t missing = 0;
    for (int i = 0; i < s_.columns; ++i)
      for (int k = 0; k < s_.rows;
           ++k) { // off the lines of symmetry, so that mirror images are different orbits
        const double u = (i + 0.3819660112501051) / s_.columns, v = (k + 0.5) / s_.rows;
        if (!place(at(u, v), std::nullopt)) ++missing;
      }
    return missing;
  }

  void random() {
    std::mt19937 gen(7);
    std::uniform_real_distribution<double> part(0, 1);
    const auto begun = starts_.size(), wanted = begun + static_cast<std::size_t>(s_.random);
    for (std::size_t tries = 0;
         starts_.size() < wanted && !stopped() && tries < 200 * (starts_.size() - begun + 100);
         ++tries) { // a level that fills less than 1/200 of the range is not looked for for ever
      const double u = part(gen), v = part(gen);
      static_cast<void>(place(at(u, v), std::nullopt));
    }
  }

  [[nodiscard]] std::array<double, 2> at(double u, double v) const {
    const auto x = numbers((*s_.range)[0]), y = numbers((*s_.range)[1]);
    return {x[0] + u * (x[1] - x[0]), y[0] + v * (y[1] - y[0])};
  }

  [[nodiscard]] bool stopped() const { return stop_ != nullptr && stop_->load(); }

  const SystemScene& s_;
  const std::atomic<bool>* stop_;
  Evaluator<double> drawn_;
  Lift<double> lift_;
  std::unique_ptr<Sheets> sheets_;
  std::vector<FieldStart> starts_;
};

} // namespace

Field field_of_starts(const SystemScene& s) {
  std::vector<MFraction> used{s.plot[0].value, s.plot[1].value};
  for (const SceneFormula& f : s.start)
    used.push_back(f.value);
  for (const auto& level : s.levels)
    used.push_back(level.function.value);
  if (s.where) used.push_back(s.where->value);
  used.push_back(lie_derivative(s.system.field, s.section.value));
  return {s.system, s.section.value, used, s.values, false};
}

std::vector<FieldStart> starts_of(const SystemScene& scene, const Field& field,
                                  std::size_t* skipped, const std::atomic<bool>* stop) {
  return Collection(scene, field, stop).all(skipped);
}

struct Places::Parts : Sheets {
  using Sheets::Sheets;
};

Places::Places(const SystemScene& scene, const Field& field)
    : parts_(std::make_unique<Parts>(scene, field)) {}
Places::~Places() = default;
std::vector<std::vector<double>> Places::over(const std::array<double, 2>& drawn) {
  return parts_->over(drawn);
}
void Places::set(const std::vector<double>& numbers) { parts_->set(numbers.data()); }

// ---- refinement ----

template <class R> struct StartRefiner<R>::Parts {
  const SystemScene& scene;
  const Field& field;
  Lift<R> lift;
  std::unique_ptr<StartEquations<R>> equations; ///< for places of the picture
  std::unique_ptr<Evaluator<R>> gradients;      ///< of the function symbols, for the tangent vector
  using S = std::conditional_t<std::is_same_v<R, Twin1>, BigReal, R>; // a pair has no sine
  std::unique_ptr<OverSphere<S>> sphere = {};

  // The state of a body.
  std::vector<R> over_sphere(const FieldStart& start) {
    if (!sphere) sphere = std::make_unique<OverSphere<S>>(scene, field);
    std::array<S, 2> at{S(start.drawn[0]), S(start.drawn[1])};
    for (std::size_t i = 0; i < 2 && start.seed; ++i)
      at[i] = scene.seeds[*start.seed][i].template as<S>();
    const auto& n = start.x;
    std::vector<R> x;
    for (const S& one : sphere->near(at[0], at[1], std::hypot(n[0], n[1], n[2])))
      if constexpr (std::is_same_v<R, S>)
        x.push_back(one);
      else
        x.push_back(to_twin(one));
    return x;
  }
};

template <class R>
StartRefiner<R>::StartRefiner(const SystemScene& scene, const Field& field)
    : parts_(new Parts{scene, field, Lift<R>(scene, field), nullptr, nullptr}) {
  if (!scene.body && equations_of(scene).size() == field.coordinates())
    parts_->equations = std::make_unique<StartEquations<R>>(scene, field);
  if (field.tangent() == 0) return;
  std::vector<MFraction> all;
  for (std::size_t i = field.coordinates(); i < field.variables().size(); ++i)
    for (const FunctionSymbol& f : scene.system.field.functions)
      if (f.variable == field.variables()[i])
        all.insert(all.end(), f.gradient.begin(), f.gradient.end());
  parts_->gradients = std::make_unique<Evaluator<R>>(field, all);
}

template <class R> StartRefiner<R>::~StartRefiner() = default;

template <class R> void StartRefiner<R>::set(const std::vector<R>& numbers) {
  parts_->lift.set(numbers.data());
  if (parts_->equations) parts_->equations->set(numbers.data());
  if (parts_->gradients) parts_->gradients->set(numbers.data());
}

template <class R> std::vector<R> StartRefiner<R>::operator()(const FieldStart& start) {
  const SystemScene& s = parts_->scene;
  std::vector<R> x;
  for (std::size_t j = 0; j < start.x.size(); ++j)
    x.push_back(start.state ? s.states[*start.state][j].template as<R>() : R(start.x[j]));
  if (!start.state && !start.given && s.body) return parts_->over_sphere(start);
  if (!start.state && !start.given) {
    std::array<R, 2> drawn{R(start.drawn[0]), R(start.drawn[1])};
    for (std::size_t i = 0; i < 2 && start.seed; ++i)
      drawn[i] = s.seeds[*start.seed][i].template as<R>();
    const std::vector<R> targets = targets_of(s, drawn);
    const int steps = std::is_same_v<R, double> ? 2 : std::is_same_v<R, BigReal> ? 6 : 3;
    for (int i = 0; i < steps; ++i) {
      std::vector<R> next = x;
      if (!newton_step(*parts_->equations, targets, next)) break;
      x = next;
    }
  }
  std::vector<R> all = parts_->lift(x);
  if (parts_->field.tangent() == 0) return all;
  const std::size_t n = x.size(), functions = all.size() - n;
  const std::vector<R> gradient = (*parts_->gradients)(all.data());
  std::vector<R> v;
  for (std::size_t j = 0; j < n; ++j) // any direction will do, but none of a symmetry
    v.push_back(R(std::cos(1 + 2.4 * static_cast<double>(j))) * (size_of(x[j]) + R(1) / R(8)));
  for (std::size_t i = 0; i < functions; ++i) {
    R d(0);
    for (std::size_t j = 0; j < n; ++j)
      d += gradient[i * n + j] * v[j];
    v.push_back(d);
  }
  all.insert(all.end(), v.begin(), v.end());
  return all;
}

template class StartRefiner<double>;
template class StartRefiner<long double>;
template class StartRefiner<Twin1>;
template class StartRefiner<BigReal>;

template <class R> struct MeaningCheck<R>::One {
  KnownFunction function;
  Evaluator<R> argument;
};

template <class R> MeaningCheck<R>::MeaningCheck(const SystemScene& scene, const Field& field) {
  for (std::size_t i = field.coordinates(); i < field.variables().size(); ++i) {
    const FunctionMeaning& m = meaning_of(scene, field.variables()[i]);
    places_.push_back(i);
    all_.push_back({known_function(m.name), Evaluator<R>(field, {m.argument})});
  }
}

template <class R> MeaningCheck<R>::~MeaningCheck() = default;

template <class R> double MeaningCheck<R>::deviation(std::size_t i, const R* x) {
  const R& argument = all_[i].argument(x)[0];
  const R& symbol = x[places_[i]];
  if constexpr (std::is_same_v<R, double>)
    return std::abs(symbol - all_[i].function.quick(argument));
  else
    return std::abs(to_double(R(symbol - value_of(all_[i].function.exact, argument))));
}

template class MeaningCheck<double>;
template class MeaningCheck<long double>;
template class MeaningCheck<Twin1>;
template class MeaningCheck<BigReal>;

} // namespace kov::flow
