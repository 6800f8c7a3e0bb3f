#include "strata/parametric_basis.hpp"

#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "strata/exponential_families.hpp"
#include "strata/invariant_system.hpp"
#include "strata/log_integral.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

using Texts = std::vector<std::string>;

std::string factor_text(const std::string& s) {
  const bool atom = s.find_first_of("+-*/^ ") == std::string::npos;
  return atom ? s : "(" + s + ")";
}
std::string product(const std::string& a, const std::string& b) {
  return a == "1" ? b : b == "1" ? a : a + "*" + b;
}

class Basis {
public:
  Basis(const Question& q, const MFraction& gauge, const Leaf& leaf, const ParametrisedSet& region,
        const Budget& budget)
      : q_(q), z_(q.z), leaf_(leaf), region_(region), budget_(budget), r_(region.restrict(q.r)),
        gauge_(region.restrict(gauge)) {}

  std::vector<ParametricSolutions> operator()() {
    if (is_zero(r_)) {
      of_zero();
    } else if (const auto v = product_of_solutions()) {
      by_product(*v, r_, gauge_, region_, {});
    } else if (const auto w = exponential()) {
      by_exponential(*w);
    }
    return std::move(all_);
  }

private:
  [[nodiscard]] MFraction d(const MFraction& f) const { return derivative(f, z_); }
  [[nodiscard]] MFraction number(const Rational& c) const { return {r_.ring(), c}; }
  [[nodiscard]] std::string z_name() const { return r_.ring()->name(z_); }

  // ---- what is known

  // v with v = y1 y2; of a solution of Sym^4 its root, if that is rational.
  [[nodiscard]] std::optional<MFraction> product_of_solutions() const {
    for (const Evidence& e : leaf_.because) {
      const auto* found = std::get_if<InvariantFound>(&e);
      if (found == nullptr || !leaf_.scheme) continue;
      const ParametricInvariant& i = found->v;
      if (i.form.m != 2 && i.form.m != 4) continue;
      MFraction v(i.p);
      for (std::size_t k = 0; k < i.form.e.size(); ++k)
        v = v * pow(MFraction(leaf_.scheme->finite[k].q), i.form.e[k]);
      v = region_.restrict(v);
      if (i.form.m == 4) {
        const auto root = root_up_to_constants(v);
        if (!root) continue;
        v = *root;
      }
      if (is_product(v)) return v;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::optional<MFraction> root_up_to_constants(const MFraction& v) const {
    MFraction root = number(Rational(1));
    for (const bool above : {true, false})
      for (const MFactor& f : factor(above ? v.num() : v.den()).second) {
        if (!uses(f.base, z_)) continue;
        if (f.exponent % 2 != 0) return std::nullopt;
        const MFraction half = pow(MFraction(f.base), f.exponent / 2);
        root = above ? root * half : root / half;
      }
    return root;
  }
  [[nodiscard]] MFraction wronskian_squared(const MFraction& v, const MFraction& r) const {
    const MFraction v1 = d(v);
    return v1 * v1 - Rational(2) * (v * d(v1)) + Rational(4) * (r * v * v);
  }
  [[nodiscard]] bool is_product(const MFraction& v) const {
    return !is_zero(v) && !uses(wronskian_squared(v, r_), z_);
  }

  [[nodiscard]] std::optional<MFraction> exponential() const {
    for (const Evidence& e : leaf_.because)
      if (const auto* found = std::get_if<ExponentialFound>(&e)) {
        const MFraction w = region_.restrict(found->w);
        if (is_zero(d(w) + w * w - r_)) return w;
      }
    const bool none = leaf_.group && (leaf_.group->type == GroupType::SL2);
    if (none || !leaf_.scheme) return std::nullopt;
    return exponential_solutions(*leaf_.scheme, region_, budget_).w;
  }

  // ---- formulas

  // The conditions under which a formula has a value.
  void need(const LogIntegral& y, const ParametrisedSet& region,
            std::vector<MPoly>& nonzero) const {
    const Defined where = defined_where(y, z_);
    for (const MPoly& p : where.denominators)
      need(p, region, nonzero);
    for (const auto& all : where.bases) {
      const bool known = std::ranges::any_of(
          all, [&](const MPoly& c) { return !is_zero(c) && region.provably_nonzero(c); });
      if (!known) need(all.back(), region, nonzero);
    }
  }
  static void need(const MPoly& p, const ParametrisedSet& region, std::vector<MPoly>& nonzero) {
    for (const MPoly& f : irreducible_parts(p))
      if (!region.provably_nonzero(f) && !is_among(f, nonzero)) nonzero.push_back(f);
  }

  static std::string power_text(const MPoly& base, const std::string& exponent) {
    const std::string b = factor_text(to_string(base));
    return exponent == "1" ? b : b + "^" + factor_text(exponent);
  }
  // The exponential of the integral of w, in closed form or as exp(int(w, z)).
  [[nodiscard]] std::string exp_of(const MFraction& w, const ParametrisedSet& region,
                                   std::vector<MPoly>& nonzero) const {
    const auto y = log_integral(w, z_);
    if (!y) {
      need(w.den(), region, nonzero, true);
      return "exp(int(" + to_string(w) + ", " + z_name() + "))";
    }
    need(*y, region, nonzero);
    std::string text = "1";
    for (const auto& [base, exponent] : y->powers)
      text = product(text, power_text(base, to_string(exponent)));
    if (!is_zero(y->exponential)) text = product(text, "exp(" + to_string(y->exponential) + ")");
    return text;
  }
  // The same for w = a + s*sqrt(n)*b.
  [[nodiscard]] std::string exp_of(const MFraction& a, const MFraction& b, const std::string& root,
                                   const ParametrisedSet& region,
                                   std::vector<MPoly>& nonzero) const {
    const auto one = log_integral(a, z_), two = log_integral(b, z_);
    if (!one || !two) {
      need(a.den(), region, nonzero, true);
      need(b.den(), region, nonzero, true);
      return "exp(int(" + to_string(a) + " + " + root + "*" + factor_text(to_string(b)) + ", " +
             z_name() + "))";
    }
    need(*one, region, nonzero);
    need(*two, region, nonzero);
    std::string text = "1";
    for (const auto& [base, exponent] : one->powers)
      if (!shares(base, two->powers)) text = product(text, power_text(base, to_string(exponent)));
    for (const auto& [base, exponent] : two->powers) {
      std::string sum = with_root(exponent, root);
      for (const auto& [other, constant] : one->powers)
        if (other == base)
          sum = to_string(constant) + (sum[0] == '-' ? " - " + sum.substr(1) : " + " + sum);
      text = product(text, power_text(base, sum));
    }
    std::string inside = is_zero(one->exponential) ? "" : to_string(one->exponential);
    if (!is_zero(two->exponential)) {
      const std::string term = with_root(two->exponential, root);
      inside = inside.empty()   ? term
               : term[0] == '-' ? inside + " - " + term.substr(1)
                                : inside + " + " + term;
    }
    return inside.empty() ? text : product(text, "exp(" + inside + ")");
  }
  static bool shares(const MPoly& base, const std::vector<std::pair<MPoly, MFraction>>& all) {
    return std::ranges::any_of(all, [&](const auto& x) { return x.first == base; });
  }
  static std::string with_root(const MFraction& f, const std::string& root) {
    if (is_one(f)) return root;
    if (to_string(f)[0] == '-') return "-" + with_root(-f, root);
    return factor_text(to_string(f)) + "*" + root;
  }

  void need(const MPoly& den, const ParametrisedSet& region, std::vector<MPoly>& nonzero,
            bool) const {
    for (const MFactor& f : factor(den).second) {
      const auto c = coefficients(f.base, z_);
      const bool known = std::ranges::any_of(
          c, [&](const MPoly& x) { return !is_zero(x) && region.provably_nonzero(x); });
      if (!known) need(c.back(), region, nonzero);
    }
  }

  void add(ParametricSolutions s) {
    for (std::string& y : s.y) {
      if (y.size() > longest) return;
      y = without_outer(std::move(y));
    }
    all_.push_back(std::move(s));
  }

  // (c + x) by itself
  static std::string without_outer(std::string y) {
    long depth = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      depth += y[i] == '(' ? 1 : y[i] == ')' ? -1 : 0;
      if (depth == 0) return i + 1 == y.size() && i > 0 ? y.substr(1, i - 1) : y;
    }
    return y;
  }

  void of_zero() {
    ParametricSolutions s;
    const std::string y = exp_of(gauge_, region_, s.nonzero);
    s.y = {y, product(z_name(), y)};
    add(std::move(s));
  }

  // y1 and y1 int(f, z), closed where the residues of f vanish.
  [[nodiscard]] std::string second(const std::string& y1, const std::string& f) const {
    return product(y1, "int(" + f + ", " + z_name() + ")");
  }

  void by_product(const MFraction& v, const MFraction& r, const MFraction& gauge,
                  const ParametrisedSet& region, std::vector<MPoly> zero) {
    const MFraction square = wronskian_squared(v, r);
    const MFraction half = Rational(1, 2) * d(v) / v + gauge;
    ParametricSolutions s;
    s.zero = zero;
    if (is_zero(square)) {
      const std::string y1 = exp_of(half, region, s.nonzero);
      const MFraction inverse = number(Rational(1)) / v;
      need(v.num(), region, s.nonzero, true);
      s.y = {y1, product(y1, integral_text(inverse, region, s.nonzero))};
      return add(std::move(s));
    }
    need(square.num(), region, s.nonzero);
    const std::vector<MPoly> special = s.nonzero;
    const RootParts c = parts_of_root(square);
    const MFraction part = Rational(1, 2) * c.square / v;
    if (!solves(half - gauge, part, c.rest, r)) return;
    const bool rational = is_one(MFraction(c.rest));
    const std::string root = "sqrt(" + to_string(c.rest) + ")";
    for (const bool plus : {true, false})
      s.y.push_back(rational ? exp_of(plus ? half + part : half - part, region, s.nonzero)
                             : exp_of(half, plus ? part : -part, root, region, s.nonzero));
    add(std::move(s));
    if (!zero.empty()) return;
    for (const MPoly& p : special)
      where_equal(v, p, region);
  }

  // C = 0 on a part of the stratum that the tree had no reason to tell apart.
  void where_equal(const MFraction& v, const MPoly& p, const ParametrisedSet& region) {
    const auto there = region.where_zero(p);
    const auto* zero = std::get_if<ParametrisedSet>(&there);
    if (zero == nullptr) return;
    tried<DomainError>([&] { // without a value there nothing is said
      const MFraction v0 = zero->restrict(v), r0 = zero->restrict(r_);
      if (!is_zero(v0) && is_zero(wronskian_squared(v0, r0)))
        by_product(v0, r0, zero->restrict(gauge_), *zero, {p});
    });
  }

  // (a + c b)' + (a + c b)^2 = r with c^2 = n
  [[nodiscard]] bool solves(const MFraction& a, const MFraction& b, const MPoly& n,
                            const MFraction& r) const {
    return is_zero(d(a) + a * a + MFraction(n) * b * b - r) &&
           is_zero(d(b) + Rational(2) * (a * b));
  }

  // int f: closed where no residue is left.
  [[nodiscard]] std::string integral_text(const MFraction& f, const ParametrisedSet& region,
                                          std::vector<MPoly>& nonzero) const {
    const auto y = log_integral(f, z_);
    need(f.den(), region, nonzero, true);
    if (!y) return "int(" + to_string(f) + ", " + z_name() + ")";
    need(*y, region, nonzero);
    std::string text = is_zero(y->exponential) ? "" : to_string(y->exponential);
    for (const auto& [base, residue] : y->powers)
      text += (text.empty() ? "" : " + ") +
              product(is_one(residue) ? "1" : factor_text(to_string(residue)),
                      "log(" + to_string(base) + ")");
    return factor_text(text);
  }

  void by_exponential(const MFraction& w) {
    if (!is_zero(d(w) + w * w - r_)) return;
    ParametricSolutions s;
    const std::string y1 = exp_of(w + gauge_, region_, s.nonzero);
    const std::string f = exp_of(Rational(-2) * w, region_, s.nonzero);
    s.y = {y1, second(y1, f)};
    add(std::move(s));
  }

  static constexpr std::size_t longest = 2000; // characters of one formula

  const Question& q_;
  std::size_t z_;
  const Leaf& leaf_;
  const ParametrisedSet& region_;
  const Budget& budget_;
  MFraction r_, gauge_;
  std::vector<ParametricSolutions> all_;
};

} // namespace

RootParts parts_of_root(const MFraction& f) {
  const Ring& ring = f.ring();
  MFraction root(ring, Rational(1));
  MPoly rest(ring, Integer(1));
  Integer content(1), below(1);
  for (const bool above : {true, false}) {
    const auto [c, factors] = factor(above ? f.num() : f.den());
    (above ? content : below) = c;
    for (const MFactor& x : factors) {
      const MFraction half = pow(MFraction(x.base), x.exponent / 2);
      root = above ? root * half : root / half;
      if (x.exponent % 2 == 0) continue;
      rest *= x.base;
      if (!above) root = root / MFraction(x.base);
    }
  }
  const auto [s, n] =
      square_part(content * below); // sqrt(content/below) = sqrt(content*below)/below
  return {root * MFraction(ring, Rational(s, below)), rest * MPoly(ring, n)};
}

std::optional<ParametrisedSet> region_of(const Question& q, const Stratum& s,
                                         const std::vector<MPoly>& domain) {
  ParametrisedSet region(q.r.ring(), q.assumptions);
  const auto vanishes = [&](const MPoly& p) { // false: in several ways
    const auto parts = irreducible_parts(p);
    if (parts.size() != 1) return false;
    auto there = region.where_zero(parts.front());
    if (!std::holds_alternative<ParametrisedSet>(there)) return false;
    region = std::get<ParametrisedSet>(std::move(there));
    return true;
  };
  for (std::size_t i = q.assumptions.conditions.size(); i > 0 && region.pending(); --i)
    if (!vanishes(*region.pending())) return std::nullopt;
  if (region.pending()) return std::nullopt;
  const auto restricted = [&](const MPoly& p) { return region.restrict(MFraction(p)).num(); };
  for (const MPoly& p : domain)
    for (const MPoly& f : irreducible_parts(p))
      region = region.where_nonzero(f);
  for (const Condition& c : s.conditions) {
    const MPoly p = restricted(c.p);
    if (c.sign == Sign::zero) {
      if (is_zero(p)) continue;
      if (!vanishes(p)) return std::nullopt;
    } else if (c.sign == Sign::nonzero) {
      if (is_zero(p)) return std::nullopt;
      for (const MPoly& f : irreducible_parts(p))
        region = region.where_nonzero(f);
    }
  }
  return region;
}

std::vector<ParametricSolutions> solutions_on(const Question& q, const MFraction& gauge,
                                              const Leaf& leaf, const ParametrisedSet& region,
                                              const Budget& budget) {
  // nothing: a limit, or a value that the stratum does not have
  return tried<OutOfBudget, DomainError>([&] { return Basis(q, gauge, leaf, region, budget)(); });
}

} // namespace kov::strata
