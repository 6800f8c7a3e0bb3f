#include "strata/judge.hpp"

#include "exact/error.hpp"
#include "exact/factor.hpp"
#include "strata/bounds.hpp"
#include "strata/confluent.hpp"
#include "strata/first_case.hpp"
#include "strata/open_exponent.hpp"

#include <algorithm>

namespace kov::strata {

Leaf leaf_of(const Decision& d) {
  Leaf leaf;
  leaf.abelian = d.abelian;
  leaf.group = d.group;
  leaf.group_text = d.group ? describe(*d.group) : "";
  leaf.reason = d.reason;
  if (d.abelian == Truth::unknown) leaf.open_condition = d.reason;
  leaf.number = d;
  leaf.trace = d.trace;
  if (!is_zero(d.r)) {
    const auto places = squarefree_factors(d.r.den());
    leaf.irregular =
        order_at_infinity(d.r) < 2 ||
        std::any_of(places.begin(), places.end(), [](const Factor& f) { return f.exponent > 2; });
  }
  return leaf;
}

Leaf unsettled(const Unsettled& where, const std::string& otherwise) {
  Leaf leaf;
  leaf.open_condition = "abelian only if " + otherwise + (otherwise.empty() ? "" : ", or ") +
                        "these polynomials all vanish, which they do not for generic parameters";
  std::string together;
  for (const auto& p : where.together)
    together += (together.empty() ? "" : ", ") + brief(MFraction(p), 120);
  leaf.reason = "undecided: " + leaf.open_condition + ": " + together;
  return leaf;
}

namespace {

constexpr long most_unknowns = 40;

using Answer = std::variant<Leaf, Needs>;

Leaf decided(Truth abelian, const std::string& group_text, const std::string& reason,
             const std::optional<GaloisGroup>& group = {}) {
  Leaf leaf;
  leaf.abelian = abelian;
  leaf.group_text = group ? describe(*group) : group_text;
  leaf.group = group;
  leaf.reason = reason;
  return leaf;
}

class Judge {
public:
  Judge(const Scheme& s, const Region& region, const Budget& budget)
      : s_(s), region_(region), budget_(budget) {
    for (const auto& p : s.finite)
      places_.push_back(&p);
    places_.push_back(&s.infinity);
    for (const auto* p : places_)
      if (p->exponent == ExponentKind::open) open_.push_back(p);
  }

  Answer run() {
    find_torus();
    if (const auto* log = certain_log(); log != nullptr && !torus_.empty())
      return torus_and_logarithm(*log);
    const bool irrational = std::any_of(places_.begin(), places_.end(), [](const auto* p) {
      return p->exponent == ExponentKind::irrational;
    });
    if (!irrational)
      if (auto leaf = bessel_leaf(s_, region_)) return *std::move(leaf);
    if (auto leaf = weber_leaf(s_, region_)) return *std::move(leaf);
    if (!open_.empty()) return with_open_exponents();
    return torus_.empty() ? with_rational_exponents() : with_torus();
  }

private:
  void find_torus() {
    for (const auto* p : places_) {
      const std::string at = place_name(*p, s_.z);
      if (p->kind == PlaceKind::irregular || p->kind == PlaceKind::ramified)
        torus_ = "the equation is irregular at " + at;
      else if (p->exponent == ExponentKind::irrational)
        torus_ = "at " + at + " " + square_text(*p) + " " + p->irrational_because +
                 ", so that Delta is not rational";
      if (!torus_.empty()) return;
    }
  }
  [[nodiscard]] const ParametricPlace* certain_log() const {
    for (const auto* p : places_)
      if (p->log == Truth::yes && p->exponent == ExponentKind::rational) return p;
    return nullptr;
  }
  [[nodiscard]] std::string irreducible_text(const ExponentialBound& b) const {
    return b.odd_order ? "a place of odd order admits no exponential solution"
                       : "no exponential solution: its polynomial part would have degree at most " +
                             to_string(*b.d) + " < 0";
  }
  [[nodiscard]] static std::optional<GaloisGroup> sl2() { return GaloisGroup{GroupType::SL2, {}}; }

  Answer torus_and_logarithm(const ParametricPlace& log) const {
    const ExponentialBound exponential = exponential_bound(s_);
    const std::string why = torus_ + ", and there is a logarithm at " + place_name(log, s_.z) +
                            ": the group contains a torus and a unipotent matrix";
    if (exponential.excludes())
      return decided(Truth::no, "", why + "; " + irreducible_text(exponential), sl2());
    return decided(Truth::no, "SL(2, C) or the full triangular group", why);
  }

  // Some Delta irrational or a place irregular, everywhere: only Sym^4 matters.
  Answer with_torus() {
    const ExponentialBound exponential = exponential_bound(s_);
    const InvariantBound four = invariant_bound(s_, 4);
    std::string none = four.why;
    if (four.form) {
      auto answer = search(*four.form, "in the normaliser of a torus");
      if (!std::holds_alternative<std::monostate>(answer)) return lift(std::move(answer));
      none = "Sym^4 has no rational solution";
    }
    const std::string why =
        torus_ + ": the identity component contains a torus; " + none + ", so that it is not one";
    if (exponential.excludes())
      return decided(Truth::no, "", why + "; " + irreducible_text(exponential), sl2());
    return decided(Truth::no, "SL(2, C) or the full triangular group", why);
  }

  using Searched = std::variant<std::monostate, Leaf, Needs>; // monostate: none on the stratum

  static Answer lift(Searched s) {
    if (auto* leaf = std::get_if<Leaf>(&s)) return std::move(*leaf);
    return std::get<Needs>(std::move(s));
  }

  // `otherwise`: where G0 may be abelian without an invariant of this form.
  Searched search(const InvariantForm& form, const std::string& group,
                  const std::string& otherwise = {}) {
    if (form.degree >= most_unknowns) {
      Leaf leaf;
      leaf.reason = "Sym^" + std::to_string(form.m) + " has " + std::to_string(form.degree + 1) +
                    " unknowns, the limit is " + std::to_string(most_unknowns);
      leaf.open_condition =
          "Sym^" + std::to_string(form.m) + " has a rational solution or not: not looked at";
      return leaf;
    }
    auto found = find_invariant(s_, form, region_, budget_);
    if (auto* needs = std::get_if<Needs>(&found)) return std::move(*needs);
    if (const auto& v = std::get<0>(found)) return abelian_by(*v, group);
    auto excluded = exclude_invariant(s_, form, region_, budget_);
    if (auto* needs = std::get_if<Needs>(&excluded)) return std::move(*needs);
    if (const auto* u = std::get_if<Unsettled>(&excluded)) return unsettled(*u, otherwise);
    return {};
  }

  [[nodiscard]] Leaf abelian_by(const ParametricInvariant& v, const std::string& group) const {
    std::string text = to_string(v.p);
    if (v.p.length() > 1) text = "(" + text + ")";
    for (std::size_t i = 0; i < s_.finite.size(); ++i)
      if (v.form.e[i] != 0)
        text += "*(" + to_string(s_.finite[i].q) + ")^(" + std::to_string(v.form.e[i]) + ")";
    Leaf leaf =
        decided(Truth::yes, group,
                "v = " + text + " solves the symmetric power Sym^" + std::to_string(v.form.m) +
                    " for all parameters of the stratum, and SL(2) and the full triangular "
                    "group have no invariants");
    leaf.invariant = v;
    return leaf;
  }

  // All Delta are rational constants and all places regular.
  Answer with_rational_exponents() {
    const ExponentialBound exponential = exponential_bound(s_);
    const ParametricPlace* log = certain_log();
    if (log != nullptr && exponential.excludes())
      return decided(Truth::no, "",
                     "the exponents are rational, there is a logarithm at " +
                         place_name(*log, s_.z) + "; " + irreducible_text(exponential),
                     sl2());
    if (auto answer = all_integral()) return *std::move(answer);
    if (const auto four = invariant_bound(s_, 4).form) {
      auto found = find_invariant(s_, *four, region_, budget_);
      if (auto* needs = std::get_if<Needs>(&found)) return std::move(*needs);
      if (const auto& v = std::get<0>(found))
        return abelian_by(*v, "in the normaliser of a torus, or T_n");
    }
    return by_invariants(exponential, log);
  }

  std::optional<Answer> all_integral() const {
    for (const auto* p : places_)
      if (!is_integer(p->delta)) return std::nullopt;
    for (const auto* p : places_)
      if (p->log == Truth::unknown && p->log_norm)
        return Needs{*p->log_norm, "there is no logarithm at " + place_name(*p, s_.z)};
    for (const auto* p : places_)
      if (p->log != Truth::no) return std::nullopt;
    const bool odd = std::all_of(s_.finite.begin(), s_.finite.end(), [](const auto& p) {
      return fmpz_is_odd(p.delta.num().raw()) != 0;
    });
    Leaf leaf = decided(Truth::yes, "", "all exponents are half-integers and there is no logarithm",
                        GaloisGroup{GroupType::cyclic, Integer(odd ? 1 : 2)});
    if (const auto two = invariant_bound(s_, 2).form; two && two->degree < most_unknowns)
      if (auto found = find_invariant(s_, *two, region_, budget_); found.index() == 0)
        leaf.invariant = std::get<0>(std::move(found)); // what a certificate shows
    return leaf;
  }

  // Some choice of exponents leaves a natural number for the polynomial part.
  [[nodiscard]] bool lines_possible() const {
    const Families f = exponential_families(s_);
    return !f.complete || std::any_of(f.fixed.begin(), f.fixed.end(), [](const Rational& d) {
      return is_integer(d) && sign(d) >= 0;
    });
  }

  // Even, and a multiple of n: y^n rational for every exponential solution y.
  [[nodiscard]] Integer common_denominator() const {
    Integer n(2);
    for (const auto& p : s_.finite)
      n = lcm(n, ((Rational(1) + p.delta) * Rational(1, 2)).den());
    return n;
  }

  Answer by_invariants(const ExponentialBound& exponential, const ParametricPlace* log) {
    std::vector<long> degrees;
    if (log == nullptr) degrees.push_back(12);
    const Integer n = common_denominator();
    if (!exponential.excludes() && lines_possible()) {
      if (n > Integer(200)) {
        Leaf leaf;
        leaf.reason = "the exponents have the common denominator " + to_string(n);
        leaf.open_condition = "reducible or not: not looked at";
        return leaf;
      }
      const long degree = to_long(n);
      if (log != nullptr || 12 % degree != 0) degrees.push_back(degree);
    }
    std::string none;
    for (const long m : degrees) {
      const InvariantBound bound = invariant_bound(s_, m);
      if (bound.form) {
        // Sym^12 is asked first: where it has no solution Sym^n may have one
        auto answer =
            search(*bound.form,
                   m == 12 ? "finite, in the normaliser of a torus, or T_n" : "T_n, or cyclic",
                   m == degrees.back()
                       ? ""
                       : "Sym^" + std::to_string(degrees.back()) + " has a rational solution");
        if (!std::holds_alternative<std::monostate>(answer)) return lift(std::move(answer));
      }
      none +=
          (none.empty() ? "" : ", ") + ("Sym^" + std::to_string(m) + " has no rational solution" +
                                        (bound.form ? "" : " (" + bound.why + ")"));
    }
    if (log != nullptr)
      none = "there is a logarithm at " + place_name(*log, s_.z) + ", and " + none;
    else if (exponential.excludes())
      none = irreducible_text(exponential) + ", and " + none;
    else if (!lines_possible())
      none = "no exponents of an exponential solution leave a natural number for the degree of its "
             "polynomial part, and " +
             none;
    return decided(Truth::no, "", "the exponents are rational constants; " + none, sl2());
  }

  Answer with_open_exponents() {
    // An invariant of degree 4 for generic exponents settles all of them.
    if (const auto four = invariant_bound(s_, 4).form; four && four->degree < most_unknowns) {
      auto found = find_invariant(s_, *four, region_, budget_);
      if (auto* needs = std::get_if<Needs>(&found)) return std::move(*needs);
      if (const auto& v = std::get<0>(found))
        return abelian_by(*v, "in the normaliser of a torus, or T_n");
    }
    return judge_open_exponents(s_, open_, torus_, certain_log() != nullptr, region_);
  }

  const Scheme& s_;
  const Region& region_;
  const Budget& budget_;
  std::vector<const ParametricPlace*> places_;
  std::vector<const ParametricPlace*> open_;
  std::string torus_; ///< why G0 contains a torus; empty if that is not known
};

bool depends_on_parameters(const MFraction& r, std::size_t z) {
  const auto used = used_variables(r);
  return std::any_of(used.begin(), used.end(), [&](std::size_t i) { return i != z; });
}

} // namespace

Answer judge(const MFraction& r, std::size_t z, const Region& region, const Options& options) {
  if (is_zero(r) || !depends_on_parameters(r, z)) {
    NormalForm equation;
    if (!is_zero(r)) equation.r = to_rational_function(r, z);
    return leaf_of(decide(equation, options));
  }
  auto places = scheme(r, z, region, options.budget);
  if (auto* needs = std::get_if<Needs>(&places)) return std::move(*needs);
  const Scheme& s = std::get<Scheme>(places);
  auto answer = Judge(s, region, options.budget).run();
  if (auto* leaf = std::get_if<Leaf>(&answer); leaf != nullptr && options.want_trace)
    leaf->trace = first_case(r, z, region, options.budget);
  if (auto* leaf = std::get_if<Leaf>(&answer))
    leaf->irregular =
        s.infinity.order > 2 || std::any_of(s.finite.begin(), s.finite.end(),
                                            [](const ParametricPlace& p) { return p.order > 2; });
  return answer;
}

} // namespace kov::strata
