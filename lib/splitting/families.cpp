#include "splitting/families.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

struct Branch {
  std::vector<std::size_t> zero, nonzero; ///< components of S
  std::vector<MPoly> moments;             ///< equations in a, b, c
};

class FamilySearch {
public:
  FamilySearch(const VanishingConditions& c, const Budget& budget)
      : c_(c), budget_(budget), cone_(moment_cone(c.ring)) {}

  std::vector<SplittingFamily> families;
  std::vector<EmptyBranch> empty;

  void split(Branch branch);

private:
  [[nodiscard]] bool uses_direction(const MPoly& f) const;
  [[nodiscard]] std::vector<MPoly> restricted(const Branch& b) const;
  [[nodiscard]] std::vector<MPoly> open_factors(const MPoly& f, const Branch& b,
                                                std::optional<NonzeroFactor>& why);
  void close(const Branch& b, NonzeroFactor f) { empty.push_back({name(b), std::move(f)}); }
  void leaf(const Branch& b, const std::optional<MPoly>& direction, bool exact);
  [[nodiscard]] std::optional<NonzeroFactor> same_signs(const MPoly& f, const Branch& b) const;
  [[nodiscard]] std::string name(const Branch& b) const;
  [[nodiscard]] MPoly in_moments(const MPoly& f) const;
  [[nodiscard]] MPoly simplified(const MPoly& f, const std::vector<MPoly>& moments) const;
  void find_witness(const Branch& b, const std::optional<MPoly>& direction, SplittingFamily& f);
  void decide_triangle(const Branch& b, SplittingFamily& f) const;
  [[nodiscard]] bool is_member(const Branch& b, const std::optional<MPoly>& direction,
                               const std::array<Rational, 3>& abc) const;

  const VanishingConditions& c_;
  const Budget& budget_;
  Cone cone_;
};

std::string FamilySearch::name(const Branch& b) const {
  std::string text;
  const auto add = [&](const std::string& s) { text += (text.empty() ? "" : ", ") + s; };
  for (const std::size_t v : b.zero)
    add(c_.ring->name(v) + " = 0");
  for (const std::size_t v : b.nonzero)
    add(c_.ring->name(v) + " != 0");
  for (const MPoly& g : b.moments)
    add(to_string(g) + " = 0");
  return text.empty() ? "all" : text;
}

bool FamilySearch::uses_direction(const MPoly& f) const { return uses_any(f, c_.direction); }

// The equations with the vanishing components put in.
std::vector<MPoly> FamilySearch::restricted(const Branch& b) const {
  Substitution zero;
  for (const std::size_t v : b.zero)
    zero[v] = MFraction(c_.ring);
  std::vector<MPoly> left;
  for (const MPoly& f : c_.equations) {
    const MFraction g = substitute(f, zero);
    if (!is_zero(g)) left.push_back(g.num());
  }
  return left;
}

// The factors that may vanish on the branch.
std::vector<MPoly> FamilySearch::open_factors(const MPoly& f, const Branch& b,
                                              std::optional<NonzeroFactor>& why) {
  using Why = NonzeroFactor::Why;
  std::vector<MPoly> open;
  const auto because = [&](NonzeroFactor x) {
    if (!why) why = std::move(x);
  };
  for (const MFactor& x : factor(f).second) {
    const auto is_component = [&](std::size_t v) { return x.base == MPoly::variable(c_.ring, v); };
    if (std::ranges::any_of(b.nonzero, is_component)) {
      because({Why::component, x.base});
      continue;
    }
    if (uses_direction(x.base)) {
      if (auto signs = same_signs(x.base, b))
        because(*std::move(signs));
      else
        open.push_back(x.base);
    } else if (is_among(x.base, b.moments)) {
      return {MPoly(c_.ring)}; // holds already
    } else {
      std::vector<SignIdentity> used;
      if (cone_.sign(x.base, b.moments, &used) == 0)
        open.push_back(x.base);
      else
        because({Why::one_sign, x.base, std::move(used)});
    }
  }
  return open;
}

// sum p_e S^e with even exponents, components that do not vanish, and coefficients of one sign.
std::optional<NonzeroFactor> FamilySearch::same_signs(const MPoly& f, const Branch& b) const {
  std::map<std::vector<unsigned long>, MPoly> terms;
  for (long t = 0; t < f.length(); ++t) {
    auto e = f.exponents(t);
    std::vector<unsigned long> in_s(e.size(), 0);
    for (const std::size_t v : c_.direction)
      std::swap(in_s[v], e[v]);
    terms[in_s] += MPoly::term(c_.ring, f.coefficient(t), e);
  }
  int sign = 0;
  bool nonzero_term = false;
  std::vector<SignIdentity> used;
  for (const auto& [e, p] : terms) {
    bool sure = true;
    for (const std::size_t v : c_.direction) {
      if (e[v] % 2 != 0) return std::nullopt;
      sure = sure && (e[v] == 0 || is_among(v, b.nonzero));
    }
    const int s = cone_.sign(p, b.moments, &used);
    if (s == 0 || (sign != 0 && s != sign)) return std::nullopt;
    sign = s;
    nonzero_term = nonzero_term || sure;
  }
  if (!nonzero_term) return std::nullopt;
  return NonzeroFactor{NonzeroFactor::Why::coefficients, f, std::move(used)};
}

void FamilySearch::split(Branch branch) {
  budget_.check();
  if (branch.zero.size() == c_.direction.size()) return; // S = 0 is excluded
  std::optional<MPoly> relation;
  bool exact = true;
  for (const MPoly& f : restricted(branch)) {
    std::optional<NonzeroFactor> why;
    const std::vector<MPoly> open = open_factors(f, branch, why);
    if (open.empty()) return close(branch, why.value_or(NonzeroFactor{}));
    if (is_zero(open.front())) continue; // this equation holds
    for (const std::size_t v : c_.direction) {
      const bool decided = is_among(v, branch.nonzero);
      if (decided || !uses(f, v)) continue;
      Branch one = branch, other = std::move(branch);
      one.zero.push_back(v);
      other.nonzero.push_back(v);
      split(std::move(one));
      return split(std::move(other));
    }
    if (std::ranges::any_of(open, [&](const MPoly& g) { return uses_direction(g); })) {
      if (open.size() > 1 || relation) { // not solved together: the larger family is kept
        exact = false;
        continue;
      }
      relation = open.front();
      continue;
    }
    for (const MPoly& g : open) {
      Branch with = branch;
      with.moments.push_back(g);
      split(std::move(with));
    }
    return;
  }
  leaf(branch, relation, exact);
}

// A polynomial in a, b, c, S as one in the moments A = 1/a, ...
MPoly FamilySearch::in_moments(const MPoly& f) const {
  const auto inverse = [&](const char* n) { return pow(MFraction::variable(c_.ring, n), -1); };
  const MFraction g = substitute(f, {{c_.ring->index("a"), inverse("A")},
                                     {c_.ring->index("b"), inverse("B")},
                                     {c_.ring->index("c"), inverse("C")}});
  MPoly product(c_.ring, Integer(1));
  for (const MFactor& x : factor(g.num()).second)
    product *= pow(x.base, static_cast<unsigned long>(x.exponent));
  return product;
}

// On a linear equation for A the first moment is put in; factors in the moments that have one sign for
// A > B > C > 0 go.  Nothing is known of the signs of the components of S.
MPoly FamilySearch::simplified(const MPoly& f, const std::vector<MPoly>& moments) const {
  const auto x = [&](const char* n) { return MFraction::variable(c_.ring, n); };
  const std::size_t a = c_.ring->index("A");
  Substitution ordered{{c_.ring->index("B"), x("C") + x("u")}, {a, x("C") + x("u") + x("v")}};
  MFraction value(f);
  for (const MPoly& g : moments) {
    const std::vector<MPoly> k = coefficients(g, a);
    if (k.size() != 2 || !is_constant(k[1])) continue;
    const MFraction solved = -MFraction(k[0]) / MFraction(k[1]);
    value = substitute(value, {{a, solved}});
    // then B > C and A > B are what is left of the order
    ordered = {{c_.ring->index("B"), x("C") + x("u")}};
  }
  if (is_zero(value)) return value.num();
  MPoly product(c_.ring, Integer(1));
  for (const MFactor& y : factor(value.num()).second)
    if (uses_direction(y.base) || Cone(ordered).sign(y.base) == 0)
      product *= pow(y.base, static_cast<unsigned long>(y.exponent));
  return product;
}

bool FamilySearch::is_member(const Branch& b, const std::optional<MPoly>& direction,
                             const std::array<Rational, 3>& abc) const {
  if (!(sign(abc[0]) > 0 && abc[0] < abc[1] && abc[1] < abc[2])) return false;
  Substitution at;
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = MFraction(c_.ring, abc[k]);
  for (const MPoly& g : b.moments)
    if (!is_zero(substitute(g, at))) return false;
  if (!direction) return true;
  // coefficients of opposite signs: the squares have a positive ratio
  const MFraction f = substitute(*direction, at);
  if (is_zero(f)) return true;
  for (long t = 0; t < f.num().length(); ++t) // only squares have a sign
    for (const unsigned long e : f.num().exponents(t))
      if (e % 2 != 0) return false;
  int positive = 0, negative = 0;
  for (long t = 0; t < f.num().length(); ++t)
    ++(sign(f.num().coefficient(t)) > 0 ? positive : negative);
  return positive > 0 && negative > 0;
}

// a and b from a small grid, c from an equation that is linear in c; the triangle inequality if
// possible.
void FamilySearch::find_witness(const Branch& b, const std::optional<MPoly>& direction,
                                SplittingFamily& f) {
  const std::size_t c = c_.ring->index("c");
  for (long p = 1; p < 12; ++p)
    for (long q = p + 1; q < 24; ++q) {
      std::vector<Rational> candidates;
      for (long r = q + 1; r < 30; ++r)
        candidates.emplace_back(r);
      for (const MPoly& g : b.moments) {
        const MFraction line =
            substitute(g, {{c_.ring->index("a"), MFraction(c_.ring, Rational(p))},
                           {c_.ring->index("b"), MFraction(c_.ring, Rational(q))}});
        const auto k = is_zero(line) ? std::vector<MPoly>{} : coefficients(line.num(), c);
        if (k.size() == 2 && is_constant(k[0]) && is_constant(k[1]))
          candidates = {-to_rational(MFraction(k[0]) / MFraction(k[1]))};
      }
      for (const Rational& r : candidates) {
        const std::array<Rational, 3> abc{Rational(p), Rational(q), r};
        if (!is_member(b, direction, abc)) continue;
        const std::array<Rational, 3> moments{Rational(1) / abc[0], Rational(1) / abc[1],
                                              Rational(1) / abc[2]};
        const bool triangle = moments[0] <= moments[1] + moments[2];
        if (!f.witness || triangle) f.witness = moments;
        if (triangle) {
          f.triangle = Truth::yes;
          return;
        }
      }
    }
}

void FamilySearch::decide_triangle(const Branch& b, SplittingFamily& f) const {
  if (f.triangle == Truth::yes) return;
  const auto x = [&](const char* n) { return MFraction::variable(c_.ring, n); };
  // A <= B + C  <=>  b c <= a b + a c
  const MPoly triangle = (x("a") * x("b") + x("a") * x("c") - x("b") * x("c")).num();
  if (cone_.sign(triangle, b.moments, nullptr) < 0) f.triangle = Truth::no;
}

// exact: no equation was left out, so that a member is one indeed.
void FamilySearch::leaf(const Branch& b, const std::optional<MPoly>& direction, bool exact) {
  SplittingFamily f;
  for (const std::size_t v : b.zero)
    f.zero.push_back(c_.ring->name(v));
  for (const MPoly& g : b.moments)
    f.moments.push_back(in_moments(g));
  if (exact) find_witness(b, direction, f);
  decide_triangle(b, f);
  if (direction) f.direction = simplified(in_moments(*direction), f.moments);
  families.push_back(std::move(f));
}

} // namespace

std::string sentence(const NonzeroFactor& f) {
  std::string text;
  switch (f.why) {
  case NonzeroFactor::Why::component:
    return to_string(f.factor) + " != 0 here";
  case NonzeroFactor::Why::one_sign:
    text = to_string(f.factor) + " has one sign for 0 < a < b < c";
    break;
  case NonzeroFactor::Why::coefficients:
    text = "all coefficients of " + brief(MFraction(f.factor), 120) +
           " have one sign for 0 < a < b < c";
  }
  for (std::size_t k = 0; k < f.by.size(); ++k)
    text += (k == 0 ? "; " : ", ") + to_string(f.by[k]);
  return text;
}

SplittingClassification classify_families(const VanishingConditions& c, const Budget& budget) {
  FamilySearch classifier(c, budget);
  classifier.split({});
  return {c, std::move(classifier.families), std::move(classifier.empty)};
}

std::string describe(const SplittingFamily& f) {
  std::string text;
  const auto add = [&](const std::string& s) { text += (text.empty() ? "" : ", ") + s; };
  for (const std::string& s : f.zero)
    add(s + " = 0");
  for (const MPoly& g : f.moments)
    add(to_string(g) + " = 0");
  if (f.direction) add(to_string(*f.direction) + " = 0");
  return text.empty() ? "all bodies" : text;
}

} // namespace kov
