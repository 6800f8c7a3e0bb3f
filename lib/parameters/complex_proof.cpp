#include "parameters/complex_proof.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/truth.hpp"
#include "parameters/squares.hpp"
#include "proof/algebra/arithmetic.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace kov {
namespace {

using Exponents = std::vector<unsigned long>;
using Cofactors = std::map<std::size_t, MPoly>;

constexpr std::size_t most_elements = 60, most_terms = 400;
constexpr double most_work = 1e7; // of one basis

// f = sum cofactors[i] (condition i)
struct Combination {
  MPoly f;
  Cofactors cofactors;
};

// scale m = rest + sum cofactors[i] (condition i)
struct Remainder {
  Integer scale{1};
  MPoly rest;
  Cofactors cofactors;
};

void add(Cofactors& to, const Cofactors& from, const MPoly& times) {
  for (const auto& [i, c] : from) {
    MPoly& sum = to.try_emplace(i, MPoly(times.ring())).first->second;
    sum = sum + c * times;
  }
}
Cofactors times(const Cofactors& all, const MPoly& f) {
  Cofactors result;
  add(result, all, f);
  return result;
}

std::optional<Exponents> quotient(const Exponents& a, const Exponents& b) {
  Exponents e = a;
  for (std::size_t i = 0; i < e.size(); ++i) {
    if (a[i] < b[i]) return std::nullopt;
    e[i] -= b[i];
  }
  return e;
}

/// A Gröbner basis of the equations that remembers how it is made of them.
class Basis {
public:
  Basis(Ring ring, const std::vector<Condition>& given, const Budget& budget)
      : ring_(std::move(ring)), budget_(budget) {
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i].sign == Sign::zero && !is_zero(given[i].p))
        add_element({given[i].p, {{i, MPoly(ring_, Integer(1))}}});
    const double end = meter() + most_work;
    while (!pairs_.empty() && all_.size() < most_elements && meter() < end) {
      budget_.check();
      const auto [degree, i, j] = *pairs_.begin();
      pairs_.erase(pairs_.begin());
      add_element(s_polynomial(all_[i], all_[j]));
    }
  }

  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::vector<MPoly> members() const { return mapped<MPoly>(all_, &Combination::f); }

  [[nodiscard]] Remainder reduced(MPoly f) const {
    Remainder r{Integer(1), MPoly(ring_), {}};
    while (!is_zero(f)) {
      budget_.check();
      const Exponents e = f.exponents(0);
      const Integer c = f.coefficient(0);
      const Combination* g = divisor(e);
      if (!g || f.length() > static_cast<long>(most_terms)) {
        const MPoly lead = MPoly::term(ring_, c, e);
        r.rest = r.rest + lead;
        f = f - lead;
        continue;
      }
      const Integer d = g->f.coefficient(0), common = gcd(c, d);
      Integer a = exact_div(d, common), b = exact_div(c, common);
      if (sign(a) < 0) {
        a = -a;
        b = -b;
      }
      const MPoly by = MPoly::term(ring_, b, *quotient(e, g->f.exponents(0)));
      const MPoly lift(ring_, a);
      f = lift * f - by * g->f;
      r.rest = lift * r.rest;
      r.scale = r.scale * a;
      for (auto& [i, x] : r.cofactors)
        x = lift * x;
      add(r.cofactors, g->cofactors, by);
    }
    return r;
  }

private:
  [[nodiscard]] const Combination* divisor(const Exponents& e) const {
    for (const Combination& g : all_)
      if (quotient(e, g.f.exponents(0))) return &g;
    return nullptr;
  }
  void add_element(Combination x) {
    Remainder r = reduced(x.f); // scale f = rest + ...
    if (is_zero(r.rest)) return;
    Cofactors c = times(x.cofactors, MPoly(ring_, r.scale));
    add(c, r.cofactors, MPoly(ring_, Integer(-1)));
    Combination next{std::move(r.rest), std::move(c)};
    divide_by_content(next);
    for (std::size_t i = 0; i < all_.size(); ++i)
      add_pair(i, next);
    all_.push_back(std::move(next));
  }
  static void divide_by_content(Combination& x) {
    Integer content(0);
    const auto join = [&](const MPoly& f) {
      for (long t = 0; t < f.length(); ++t)
        content = gcd(content, f.coefficient(t));
    };
    join(x.f);
    for (const auto& [i, c] : x.cofactors)
      join(c);
    const MPoly by(x.f.ring(), content);
    x.f = exact_div(x.f, by);
    for (auto& [i, c] : x.cofactors)
      c = exact_div(c, by);
  }
  // The S-polynomial of two whose leading monomials have no common variable reduces to 0.
  void add_pair(std::size_t i, const Combination& next) {
    const Exponents a = all_[i].f.exponents(0), b = next.f.exponents(0);
    unsigned long degree = 0;
    bool coprime = true;
    for (std::size_t k = 0; k < a.size(); ++k) {
      degree += std::max(a[k], b[k]);
      coprime = coprime && (a[k] == 0 || b[k] == 0);
    }
    if (!coprime) pairs_.emplace(degree, i, all_.size());
  }
  [[nodiscard]] Combination s_polynomial(const Combination& x, const Combination& y) const {
    const Exponents a = x.f.exponents(0), b = y.f.exponents(0);
    Exponents lcm_of(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
      lcm_of[i] = std::max(a[i], b[i]);
    const MPoly u = MPoly::term(ring_, y.f.coefficient(0), *quotient(lcm_of, a));
    const MPoly v = MPoly::term(ring_, x.f.coefficient(0), *quotient(lcm_of, b));
    Combination s{u * x.f - v * y.f, times(x.cofactors, u)};
    add(s.cofactors, times(y.cofactors, v), MPoly(ring_, Integer(-1)));
    return s;
  }

  Ring ring_;
  const Budget& budget_;
  std::vector<Combination> all_;
  std::set<std::tuple<unsigned long, std::size_t, std::size_t>> pairs_; ///< lowest degree first
};

Json empty_node(const Integer& scale, const std::vector<std::size_t>& factors, long power,
                const Cofactors& cofactors) {
  std::vector<Json> term{json_text(to_string(scale)), json_text("1")}, zeros;
  for (const std::size_t j : factors)
    term.push_back(json_list({json_text(std::to_string(j)), json_text(std::to_string(power))}));
  for (const auto& [i, c] : cofactors)
    if (!is_zero(c))
      zeros.push_back(json_list({json_text(std::to_string(i)), json_text(to_string(-c))}));
  return Json{Json::Object{{"node", json_text("empty")},
                           {"terms", json_list({json_list(std::move(term))})},
                           {"zeros", json_list(std::move(zeros))}}};
}

// A product of many factors grows beyond what anybody wants to read.
bool is_too_long(const Remainder& r) {
  const auto is_long = [](const MPoly& f) { return f.length() > static_cast<long>(most_terms); };
  return is_long(r.rest) ||
         std::ranges::any_of(r.cofactors, [&](const auto& c) { return is_long(c.second); });
}

} // namespace

std::optional<Json> ComplexProof::by_products(const std::vector<Condition>& given) const {
  std::vector<std::size_t> nonzero;
  for (std::size_t j = 0; j < given.size(); ++j)
    if (certify::excludes_zero(given[j].sign)) {
      if (is_zero(given[j].p)) return empty_node(Integer(1), {j}, 1, {});
      if (!is_constant(given[j].p)) nonzero.push_back(j);
    }
  const Basis basis(ring_, given, budget_);
  if (basis.empty()) return std::nullopt;
  const auto zero = [&](const std::vector<std::size_t>& factors,
                        long power) -> std::optional<Json> {
    Remainder all{Integer(1), MPoly(ring_, Integer(1)), {}};
    for (long e = 0; e < (factors.empty() ? 1 : power); ++e)
      for (std::size_t k = 0; k < std::max<std::size_t>(factors.size(), 1); ++k) {
        const MPoly g = factors.empty() ? MPoly(ring_, Integer(1)) : given[factors[k]].p;
        Remainder next = basis.reduced(all.rest * g);
        Cofactors c = times(all.cofactors, g * MPoly(ring_, next.scale));
        add(c, next.cofactors, MPoly(ring_, Integer(1)));
        all = {all.scale * next.scale, std::move(next.rest), std::move(c)};
        if (is_too_long(all)) return std::nullopt;
      }
    if (!is_zero(all.rest)) return std::nullopt;
    return empty_node(all.scale, factors, power, all.cofactors);
  };
  if (auto node = zero({}, 1)) return node;
  for (const std::size_t j : nonzero)
    if (auto node = zero({j}, 1)) return node;
  for (const long power : {1L, 2L})
    if (nonzero.size() > 1 || power > 1)
      if (auto node = zero(nonzero, power)) return node;
  return std::nullopt;
}

std::vector<Condition> ComplexProof::real_ones(std::vector<Condition> given) const {
  for (Condition& c : given) {
    const auto used = used_variables(c.p);
    if (std::ranges::any_of(used, [&](std::size_t i) { return complex_[i]; }))
      c = {MPoly(ring_, Integer(1)), Sign::positive};
  }
  return given;
}

// One of the equations has no real solution.
std::optional<Json> ComplexProof::by_squares(const std::vector<Condition>& given) const {
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto used = used_variables(given[i].p);
    if (given[i].sign != Sign::zero || used.empty() ||
        std::ranges::any_of(used, [&](std::size_t j) { return complex_[j]; }))
      continue;
    const auto found = no_real_zero(given[i].p);
    if (!found) continue;
    std::vector<Json> terms;
    for (const SquareTerm& t : found->terms)
      terms.push_back(json_list({json_text(to_string(t.c)), json_text(to_string(t.q))}));
    return Json{
        Json::Object{{"node", json_text("empty")},
                     {"terms", json_list(std::move(terms))},
                     {"zeros", json_list({json_list({json_text(std::to_string(i)),
                                                     json_text(to_string(found->multiplier))})})}}};
  }
  return std::nullopt;
}

std::optional<Json> ComplexProof::by_signs(const std::vector<Condition>& given) const {
  if (std::ranges::none_of(given, certify::is_ordered, &Condition::sign)) return std::nullopt;
  return RealFacts(ring_, real_ones(given)).contradiction();
}

std::optional<Json> ComplexProof::real_contradiction(const std::vector<Condition>& given) const {
  constexpr int depth = 2;
  constexpr double most = 1e7;
  try {
    return refutation(ring_, real_ones(given), depth, at_most(budget_, most));
  } catch (const OutOfBudget&) {
    budget_.check();
    return std::nullopt;
  }
}

std::vector<MPoly> ComplexProof::consequences(const std::vector<Condition>& given) const {
  return Basis(ring_, given, budget_).members();
}

std::optional<Json> ComplexProof::contradiction(const std::vector<Condition>& given) const {
  if (auto node = by_products(given)) return node;
  if (auto node = by_squares(given)) return node;
  return by_signs(given);
}

std::optional<Json> ComplexProof::shown(std::vector<Condition> given, const Condition& c) const {
  given.push_back(negation(c));
  return contradiction(given);
}

namespace {

class TreeOfRegions {
public:
  TreeOfRegions(const ComplexProof& proof, const std::vector<RegionOfPart>& regions,
                const Budget& budget, std::vector<Condition>* gap)
      : proof_(proof), regions_(regions), budget_(budget), gap_(gap) {
    for (const RegionOfPart& r : regions_) {
      atoms_of_.emplace_back();
      for (const Condition& c : r.conditions) {
        const auto at = std::ranges::find(atoms_, c);
        atoms_of_.back().push_back(static_cast<std::size_t>(at - atoms_.begin()));
        if (at == atoms_.end()) atoms_.push_back(c);
      }
    }
  }

  std::optional<Json> run(const std::vector<Condition>& assumed) {
    return node(assumed, std::vector<Truth>(atoms_.size(), Truth::unknown), most_depth);
  }

private:
  std::optional<Json> node(const std::vector<Condition>& given, std::vector<Truth> known,
                           int depth) {
    budget_.check();
    if (auto end = proof_.contradiction(given)) return end;
    const Basis basis(proof_.ring(), given, budget_);
    const std::vector<MPoly> nonzero = nowhere_zero(given, basis);
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      if (known[i] == Truth::unknown) known[i] = at_a_glance(atoms_[i], basis, nonzero);
    for (;;) {
      const std::size_t best = nearest(known);
      if (best == regions_.size() || depth == 0) {
        if (auto end = proof_.real_contradiction(given)) return end;
        if (gap_) *gap_ = given;
        return std::nullopt;
      }
      const auto& atoms = atoms_of_[best];
      const auto open =
          std::ranges::find_if(atoms, [&](std::size_t i) { return known[i] == Truth::unknown; });
      if (open == atoms.end()) return leaf(given, regions_[best]);
      known[*open] = look(given, atoms_[*open]);
      if (known[*open] == Truth::unknown) return split(given, known, atoms_[*open].p, depth);
    }
  }
  static std::vector<MPoly> nowhere_zero(const std::vector<Condition>& given, const Basis& basis) {
    std::vector<MPoly> all;
    for (const Condition& c : given)
      if (certify::excludes_zero(c.sign))
        all.push_back(certify::primitive(basis.reduced(c.p).rest));
    return all;
  }
  static Truth at_a_glance(const Condition& c, const Basis& basis,
                           const std::vector<MPoly>& nonzero) {
    const bool zero = c.sign == Sign::zero;
    if (!zero && c.sign != Sign::nonzero) return Truth::unknown;
    const MPoly rest = certify::primitive(basis.reduced(c.p).rest);
    if (is_zero(rest)) return zero ? Truth::yes : Truth::no;
    const bool known = is_constant(rest) || std::ranges::any_of(nonzero, [&](const MPoly& f) {
                         return f == rest || f == -rest;
                       });
    if (!known) return Truth::unknown;
    return zero ? Truth::no : Truth::yes;
  }
  [[nodiscard]] Truth look(const std::vector<Condition>& given, const Condition& c) const {
    if (proof_.shown(given, c)) return Truth::yes;
    return proof_.shown(given, negation(c)) ? Truth::no : Truth::unknown;
  }
  // The region that is not excluded and of which the fewest equations, then the fewest other conditions
  // are unknown: largest regions first, so that each case distinction is about one of their borders.
  [[nodiscard]] std::size_t nearest(const std::vector<Truth>& known) const {
    std::size_t best = regions_.size();
    std::pair<std::size_t, std::size_t> least;
    for (std::size_t k = 0; k < regions_.size(); ++k) {
      std::pair<std::size_t, std::size_t> lacks;
      bool excluded = false;
      for (const std::size_t i : atoms_of_[k]) {
        excluded = excluded || known[i] == Truth::no;
        if (known[i] == Truth::unknown)
          ++(atoms_[i].sign == Sign::zero ? lacks.first : lacks.second);
      }
      if (excluded || (best != regions_.size() && lacks >= least)) continue;
      best = k;
      least = lacks;
    }
    return best;
  }
  std::optional<Json> leaf(const std::vector<Condition>& given, const RegionOfPart& r) const {
    std::vector<Json> proofs;
    for (const Condition& c : r.conditions) {
      auto node = proof_.shown(given, c);
      if (!node) return std::nullopt;
      proofs.push_back(*std::move(node));
    }
    std::vector<Json> word;
    for (const std::size_t g : r.word)
      word.push_back(json_text(std::to_string(g)));
    Json::Object leaf{{"node", json_text("part")},
                      {"part", json_text(std::to_string(r.part))},
                      {"word", json_list(std::move(word))},
                      {"shown", json_list(std::move(proofs))}};
    if (r.region) leaf.emplace_back("region", json_text(std::to_string(*r.region)));
    return Json{std::move(leaf)};
  }
  // p = 0 or not; by sign if some region asks for the sign.
  std::optional<Json> split(const std::vector<Condition>& given, const std::vector<Truth>& known,
                            const MPoly& p, int depth) {
    const auto branch = [&](const MPoly& f, Sign sign) {
      auto more = given;
      more.push_back({f, sign});
      return node(more, known, depth - 1);
    };
    auto zero = branch(p, Sign::zero);
    if (!zero) return std::nullopt;
    if (std::ranges::none_of(atoms_, [&](const Condition& a) {
          return (a.sign == Sign::positive || a.sign == Sign::nonnegative) &&
                 (a.p == p || a.p == -p);
        })) {
      auto nonzero = branch(p, Sign::nonzero);
      if (!nonzero) return std::nullopt;
      return json_zero_node(p, *std::move(nonzero), *std::move(zero));
    }
    auto positive = branch(p, Sign::positive);
    if (!positive) return std::nullopt;
    auto negative = branch(-p, Sign::positive);
    if (!negative) return std::nullopt;
    return json_sign_node(p, *std::move(positive), *std::move(zero), *std::move(negative));
  }

  static constexpr int most_depth = 40;

  const ComplexProof& proof_;
  const std::vector<RegionOfPart>& regions_;
  const Budget& budget_;
  std::vector<Condition>* gap_;
  std::vector<Condition> atoms_;
  std::vector<std::vector<std::size_t>> atoms_of_;
};

} // namespace

std::optional<Json> tree_of_regions(const ComplexProof& proof,
                                    const std::vector<Condition>& assumed,
                                    const std::vector<RegionOfPart>& regions, const Budget& budget,
                                    std::vector<Condition>* gap) {
  return TreeOfRegions(proof, regions, budget, gap).run(assumed);
}

} // namespace kov
