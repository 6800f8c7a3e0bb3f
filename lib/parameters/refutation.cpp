#include "parameters/refutation.hpp"

#include "certify/equation/facts.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "parameters/combination.hpp"
#include "proof/algebra/arithmetic.hpp"
#include "proof/condition/show.hpp"

#include <algorithm>

namespace kov {

namespace {

MPoly number(const Ring& ring, const Integer& c) { return {ring, c}; }

Integer power_of(const Integer& b, long e) {
  Integer p(1);
  for (long i = 0; i < e; ++i)
    p = p * b;
  return p;
}

void add(std::map<std::size_t, MPoly>& all, std::size_t i, const MPoly& f) {
  const auto [at, is_new] = all.try_emplace(i, f);
  if (!is_new) at->second = at->second + f;
}

// l^d f(x = -m/l) for b = l x + m, d the degree of f in x.
MPoly substituted(const MPoly& f, std::size_t x, const MPoly& b) {
  const auto c = coefficients(f, x), line = coefficients(b, x);
  MPoly sum(f.ring()), lift = number(f.ring(), Integer(1));
  for (std::size_t k = c.size(); k-- > 0;) {
    sum = sum * -line[0] + c[k] * lift;
    if (k > 0) lift = lift * line[1];
  }
  return sum;
}

// f = ratio g, or nothing.
std::optional<Rational> ratio_of(const MPoly& f, const MPoly& g) {
  if (is_zero(f) || is_zero(g) || f.length() != g.length()) return std::nullopt;
  const Rational r = Rational(f.coefficient(0), g.coefficient(0));
  if (!(certify::scaled(f, r.den()) == certify::scaled(g, r.num()))) return std::nullopt;
  return r;
}

Integer coefficient_in(const MPoly& f, const std::vector<unsigned long>& monomial) {
  for (long t = 0; t < f.length(); ++t)
    if (f.exponents(t) == monomial) return f.coefficient(t);
  return Integer(0);
}

} // namespace

Json json_text(std::string s) { return Json{std::move(s)}; }
Json json_list(std::vector<Json> all) { return Json{Json::Array(std::move(all))}; }

Json json_sign_node(const MPoly& p, Json positive, Json zero, Json negative) {
  return Json{Json::Object{{"node", json_text("sign")},
                           {"p", json_text(to_string(p))},
                           {"positive", std::move(positive)},
                           {"zero", std::move(zero)},
                           {"negative", std::move(negative)}}};
}

Json json_zero_node(const MPoly& p, Json nonzero, Json zero) {
  return Json{Json::Object{{"node", json_text("zero")},
                           {"p", json_text(to_string(p))},
                           {"nonzero", std::move(nonzero)},
                           {"zero", std::move(zero)}}};
}

const Factorizations::Factors& Factorizations::of(const MPoly& f) {
  std::string name = to_string(f);
  const auto at = known_.find(name);
  return at != known_.end() ? at->second : known_.emplace(std::move(name), factor(f)).first->second;
}

RealFacts::RealFacts(Ring ring, std::vector<Condition> given, SharedFactorizations factorizations)
    : ring_(std::move(ring)), given_(std::move(given)), factorizations_(std::move(factorizations)) {
  solve();
  for (const Condition& c : given_)
    reduced_.push_back(reduced(c.p));
}

ReducedPoly RealFacts::reduced(const MPoly& f) const {
  ReducedPoly r{Integer(1), f, {}};
  for (const Basis& b : basis_) {
    const long d = degree(r.rest, b.x);
    if (d <= 0) continue;
    const Integer lift = power_of(coefficients(b.b, b.x)[1].coefficient(0), d);
    MPoly rest = substituted(r.rest, b.x, b.b);
    const MPoly c = exact_div(certify::scaled(r.rest, lift) - rest, b.b);
    r.scale = r.scale * lift;
    for (auto& [i, g] : r.cofactors)
      g = certify::scaled(g, lift);
    for (const auto& [i, g] : b.cofactors)
      add(r.cofactors, i, c * g);
    r.rest = std::move(rest);
  }
  return r;
}

// A new member of the basis, or one of the other equations.
bool RealFacts::put_equation(std::size_t i) {
  ReducedPoly r = reduced(given_[i].p);
  for (auto& [k, g] : r.cofactors)
    g = -g;
  add(r.cofactors, i, number(ring_, r.scale));
  r.scale = Integer(1); // now rest = sum cofactors
  if (is_zero(r.rest)) return false;
  if (is_constant(r.rest)) {
    number_ = r;
    return false;
  }
  for (const std::size_t x : used_variables(r.rest)) {
    const auto c = coefficients(r.rest, x);
    if (c.size() != 2 || !is_constant(c[1])) continue;
    const bool negative = sign(c[1].coefficient(0)) < 0;
    if (negative)
      for (auto& [k, g] : r.cofactors)
        g = -g;
    basis_.push_back({x, negative ? -r.rest : r.rest, r.cofactors});
    return true;
  }
  equations_.push_back(std::move(r));
  return false;
}

// Sums and differences of equations with the same monomials, and no multiples of others.
void RealFacts::combine_equations() {
  const auto monomials = [](const MPoly& f) {
    std::vector<std::vector<unsigned long>> all;
    for (long t = 0; t < f.length(); ++t)
      all.push_back(f.exponents(t));
    return all;
  };
  std::ranges::stable_sort(
      equations_, [](const auto& a, const auto& b) { return a.rest.length() < b.rest.length(); });
  std::vector<ReducedPoly> kept;
  const auto keep = [&](const ReducedPoly& e) {
    if (!is_zero(e.rest) && std::ranges::none_of(kept, [&](const ReducedPoly& k) {
          return divides(k.rest, e.rest).has_value();
        }))
      kept.push_back(e);
  };
  for (std::size_t i = 0; i < equations_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (monomials(equations_[i].rest) == monomials(equations_[j].rest))
        for (const long s : {1L, -1L}) {
          ReducedPoly sum = equations_[i];
          sum.rest = sum.rest + certify::scaled(equations_[j].rest, Integer(s));
          for (const auto& [k, g] : equations_[j].cofactors)
            add(sum.cofactors, k, certify::scaled(g, Integer(s)));
          keep(sum);
        }
  for (const ReducedPoly& e : equations_)
    keep(e);
  equations_ = std::move(kept);
}

void RealFacts::solve() {
  std::vector<bool> done(given_.size(), false);
  for (bool again = true; again;) {
    again = false;
    equations_.clear();
    for (std::size_t i = 0; i < given_.size() && !number_; ++i)
      if (given_[i].sign == Sign::zero && !done[i] && put_equation(i)) again = done[i] = true;
  }
  combine_equations();
}

RealFacts::Term RealFacts::one() const {
  return {Rational(1), number(ring_, Integer(1)), {}, true};
}

RealFacts::Term RealFacts::power(std::size_t i, long e) const {
  Term t = one();
  t.powers.emplace_back(i, e);
  t.strict = certify::excludes_zero(given_[i].sign);
  return t;
}

// sum of the terms + sum of multiples of equations = 0, if it is so.
std::optional<Json> RealFacts::finish(const std::vector<Term>& terms) const {
  Integer common(1);
  for (const Term& t : terms)
    common = lcm(common, t.c.den());
  MPoly sum(ring_);
  for (const Term& t : terms) {
    MPoly f = t.q * t.q;
    for (const auto& [i, e] : t.powers)
      f = f * pow(given_[i].p, static_cast<unsigned long>(e));
    sum = sum + certify::scaled(f, t.c.num() * exact_div(common, t.c.den()));
  }
  ReducedPoly r = reduced(sum);
  if (!is_zero(r.rest)) {
    const auto e = std::ranges::find_if(equations_, [&](const ReducedPoly& x) {
      return divides(certify::primitive(x.rest), r.rest).has_value();
    });
    if (e == equations_.end()) return std::nullopt;
    const MPoly primitive = certify::primitive(e->rest), m = *divides(primitive, r.rest);
    const Integer content = exact_div(e->rest.coefficient(0), primitive.coefficient(0));
    r.scale = r.scale * content; // content rest = m (e->rest)
    for (auto& [i, g] : r.cofactors)
      g = certify::scaled(g, content);
    for (const auto& [i, g] : e->cofactors)
      add(r.cofactors, i, m * g);
  }
  const Integer factor = common * r.scale;
  std::vector<Json> shown_terms, zeros;
  for (const Term& t : terms) {
    std::vector<Json> entry{json_text(to_string(t.c * Rational(factor))),
                            json_text(to_string(t.q))};
    for (const auto& [i, e] : t.powers)
      entry.push_back(json_list({json_text(std::to_string(i)), json_text(std::to_string(e))}));
    shown_terms.push_back(json_list(std::move(entry)));
  }
  for (const auto& [i, g] : r.cofactors)
    if (!is_zero(g))
      zeros.push_back(json_list({json_text(std::to_string(i)), json_text(to_string(-g))}));
  return Json{Json::Object{{"node", json_text("empty")},
                           {"terms", json_list(std::move(shown_terms))},
                           {"zeros", json_list(std::move(zeros))}}};
}

// A strict condition whose polynomial is 0, an ordered one that is a negative number, an equation
// that is a number.
std::optional<Json> RealFacts::plain() const {
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const MPoly& f = reduced_[i].rest;
    if (is_zero(f) && certify::excludes_zero(given_[i].sign))
      return finish({power(i, given_[i].sign == Sign::positive ? 1 : 2)});
    if (!is_zero(f) && is_constant(f) && is_ordered(given_[i].sign) && sign(f.coefficient(0)) < 0) {
      Term t = one();
      t.c = Rational(-f.coefficient(0), reduced_[i].scale);
      return finish({power(i, 1), t});
    }
  }
  if (!number_) return std::nullopt;
  const Integer c = number_->rest.coefficient(0);
  std::vector<Json> zeros;
  for (const auto& [i, g] : number_->cofactors)
    zeros.push_back(
        json_list({json_text(std::to_string(i)), json_text(to_string(sign(c) > 0 ? -g : g))}));
  return Json{Json::Object{
      {"node", json_text("empty")},
      {"terms", json_list({json_list({json_text(to_string(abs(c))), json_text("1")})})},
      {"zeros", json_list(std::move(zeros))}}};
}

// A condition that is a multiple of q and says its sign, or that it is not 0.
std::optional<RealFacts::Known> RealFacts::known(const MPoly& q, bool ordered) const {
  std::optional<Known> weak;
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const Sign s = given_[i].sign;
    if (ordered ? !is_ordered(s) : !certify::excludes_zero(s)) continue;
    const auto r = ratio_of(reduced_[i].rest, q);
    if (!r) continue;
    const Known found{i, *r / Rational(reduced_[i].scale)};
    if (s != Sign::nonnegative) return found;
    weak = found;
  }
  return weak;
}

// sign c monomial^2 as one Term; false: it is not seen to be >= 0.
bool RealFacts::put_group(std::vector<Term>& all, const MPoly& c, const MPoly& monomial, int sign,
                          std::vector<Split>* missing) const {
  const auto& [content, factors] = factorizations_->of(c);
  Term t = one();
  t.c = Rational(content) * Rational(sign);
  const auto square = [&](const MPoly& q, long half) {
    if (const auto k = known(q, false)) {
      t.powers.emplace_back(k->condition, 2 * half);
      for (long i = 0; i < 2 * half; ++i)
        t.c = t.c / k->ratio;
      return;
    }
    t.q = t.q * pow(q, static_cast<unsigned long>(half));
    t.strict = false;
    if (missing) missing->push_back({q, false});
  };
  bool seen = true;
  for (const MFactor& f : factors) {
    if (f.exponent > 1) square(f.base, f.exponent / 2);
    if (f.exponent % 2 == 0) continue;
    const auto k = known(f.base, true);
    if (!k) {
      if (missing) missing->insert(missing->begin(), {f.base, true});
      seen = false;
      continue;
    }
    t.c = t.c / k->ratio;
    t.powers.emplace_back(k->condition, 1);
    t.strict = t.strict && given_[k->condition].sign == Sign::positive;
  }
  for (const std::size_t x : used_variables(monomial))
    square(MPoly::variable(ring_, x), degree(monomial, x));
  if (!seen || !(t.c > Rational(0))) return false;
  all.push_back(std::move(t));
  return true;
}

// sign f as a sum of Terms: by the powers of the variables that occur to even powers only.
std::optional<std::vector<RealFacts::Term>>
RealFacts::terms_of(const MPoly& f, int sign, bool by_squares, std::vector<Split>* missing) const {
  std::map<std::vector<unsigned long>, MPoly> groups;
  std::vector<bool> even(ring_->size(), by_squares);
  for (long t = 0; t < f.length(); ++t) {
    const auto e = f.exponents(t);
    for (std::size_t i = 0; i < e.size(); ++i)
      even[i] = even[i] && e[i] % 2 == 0;
  }
  for (long t = 0; t < f.length(); ++t) {
    auto rest = f.exponents(t);
    std::vector<unsigned long> half(rest.size(), 0);
    for (std::size_t i = 0; i < rest.size(); ++i)
      if (even[i]) half[i] = std::exchange(rest[i], 0) / 2;
    MPoly& c = groups.try_emplace(half, MPoly(ring_)).first->second;
    c = c + MPoly::term(ring_, f.coefficient(t), rest);
  }
  std::vector<Term> all;
  bool good = true;
  for (const auto& [half, c] : groups) {
    const MPoly monomial = MPoly::term(ring_, Integer(1), half);
    const std::size_t before = all.size();
    if (put_group(all, c, monomial, sign, missing)) continue;
    all.resize(before); // term by term
    for (long t = 0; t < c.length() && good; ++t)
      good = put_group(all, MPoly::term(ring_, c.coefficient(t), c.exponents(t)), monomial, sign,
                       nullptr);
    if (!good && !missing) return std::nullopt;
  }
  if (!good) return std::nullopt;
  return all;
}

// sign f as a sum of Terms of which one is strict, if need be with a multiple of a positive condition.
std::optional<std::vector<RealFacts::Term>>
RealFacts::strict_terms_of(const MPoly& f, int sign, bool by_squares,
                           std::vector<Split>* missing) const {
  const auto has_strict = [](const std::vector<Term>& all) {
    return std::ranges::any_of(all, [](const Term& t) { return t.strict; });
  };
  auto plain = terms_of(f, sign, by_squares, missing);
  if (plain && has_strict(*plain)) return plain;
  if (!by_squares) return std::nullopt;
  for (std::size_t i = 0; i < given_.size(); ++i) {
    const ReducedPoly& g = reduced_[i];
    if (given_[i].sign != Sign::positive || g.rest.length() < 2) continue;
    const auto c = coefficient_in(f, g.rest.exponents(0));
    const Rational ratio = Rational(Integer(sign) * c, g.rest.coefficient(0));
    if (!(ratio > Rational(0))) continue;
    const MPoly rest =
        certify::scaled(f, Integer(sign) * ratio.den()) - certify::scaled(g.rest, ratio.num());
    auto all = terms_of(rest, 1, true, nullptr);
    if (!all) continue;
    for (Term& t : *all)
      t.c = t.c / Rational(ratio.den());
    all->push_back(power(i, 1));
    all->back().c = ratio * Rational(g.scale);
    return all;
  }
  return std::nullopt;
}

// An ordered condition, or an equation, whose polynomial is seen to have one sign.
std::optional<Json> RealFacts::by_signs(std::vector<Split>* missing) const {
  for (const bool by_squares : {false, true}) {
    for (std::size_t i = 0; i < given_.size(); ++i) {
      if (!is_ordered(given_[i].sign) || is_constant(reduced_[i].rest)) continue;
      const bool last = i + 1 == given_.size();
      const bool strict = given_[i].sign == Sign::positive;
      auto all = strict
                     ? terms_of(reduced_[i].rest, -1, by_squares, last ? missing : nullptr)
                     : strict_terms_of(reduced_[i].rest, -1, by_squares, last ? missing : nullptr);
      if (!all) continue;
      for (Term& t : *all)
        t.c = t.c / Rational(reduced_[i].scale);
      all->push_back(power(i, 1));
      if (auto node = finish(*all)) return node;
    }
    for (const ReducedPoly& e : equations_)
      for (const int s : {1, -1})
        if (const auto all = strict_terms_of(e.rest, s, by_squares, missing))
          if (auto node = finish(*all)) return node;
  }
  return std::nullopt;
}

// An equation that is a product of what is not 0.
std::optional<Json> RealFacts::by_factors() const {
  for (const ReducedPoly& e : equations_) {
    Term t = one();
    bool all = true;
    for (const MFactor& f : factorizations_->of(e.rest).second) {
      const auto k = known(f.base, false);
      all = all && k && given_[k->condition].sign != Sign::nonnegative;
      if (all) t.powers.emplace_back(k->condition, 2 * f.exponent);
    }
    if (!all) continue;
    if (auto node = finish({t})) return node;
  }
  return std::nullopt;
}

// A combination of ordered conditions with positive numbers.
std::optional<Json> RealFacts::by_combination() const {
  std::vector<std::size_t> used;
  std::map<std::vector<unsigned long>, std::size_t> rows;
  for (std::size_t i = 0; i < given_.size(); ++i)
    if (is_ordered(given_[i].sign) && !is_zero(reduced_[i].rest) && reduced_[i].rest.length() <= 12)
      used.push_back(i);
  for (const std::size_t i : used)
    for (long t = 0; t < reduced_[i].rest.length(); ++t)
      rows.try_emplace(reduced_[i].rest.exponents(t), rows.size());
  rows.try_emplace(std::vector<unsigned long>(ring_->size(), 0), rows.size());
  std::vector<std::vector<Rational>> a(rows.size(),
                                       std::vector<Rational>(used.size() + 1, Rational(0)));
  std::vector<bool> strict(used.size() + 1, true);
  for (std::size_t j = 0; j < used.size(); ++j) {
    const ReducedPoly& f = reduced_[used[j]];
    strict[j] = given_[used[j]].sign == Sign::positive;
    for (long t = 0; t < f.rest.length(); ++t)
      a[rows[f.rest.exponents(t)]][j] = Rational(f.rest.coefficient(t), f.scale);
  }
  a[rows[std::vector<unsigned long>(ring_->size(), 0)]][used.size()] = Rational(1);
  const auto solution = nonnegative_combination(a, strict);
  if (!solution) return std::nullopt;
  std::vector<Term> terms;
  for (std::size_t j = 0; j <= used.size(); ++j) {
    if (!((*solution)[j] > Rational(0))) continue;
    terms.push_back(j < used.size() ? power(used[j], 1) : one());
    terms.back().c = (*solution)[j];
  }
  return finish(terms);
}

// f >= 0 and -r f >= 0 with r > 0, where f is not 0.
std::optional<Json> RealFacts::by_opposites() const {
  const auto ratio = [&](std::size_t i, const MPoly& q) {
    return is_ordered(given_[i].sign) ? ratio_of(reduced_[i].rest, q) : std::nullopt;
  };
  for (std::size_t k = 0; k < given_.size(); ++k) {
    if (!certify::excludes_zero(given_[k].sign)) continue;
    for (std::size_t i = 0; i < given_.size(); ++i) {
      const auto r = ratio(i, reduced_[k].rest);
      for (std::size_t j = 0; r && j < i; ++j) {
        const auto opposite = ratio(j, reduced_[k].rest);
        if (!opposite || !(*r * *opposite < Rational(0))) continue;
        Term product = power(i, 1), square = power(k, 2);
        product.powers.emplace_back(j, 1);
        product.strict = false;
        square.c = -*r * *opposite * Rational(reduced_[k].scale * reduced_[k].scale) /
                   Rational(reduced_[i].scale * reduced_[j].scale);
        if (auto node = finish({product, square})) return node;
      }
    }
  }
  return std::nullopt;
}

std::optional<Json> RealFacts::contradiction() const {
  if (auto node = plain()) return node;
  if (auto node = by_factors()) return node;
  if (auto node = by_combination()) return node;
  if (auto node = by_opposites()) return node;
  return by_signs(nullptr);
}

std::vector<RealFacts::Split> RealFacts::splits() const {
  std::vector<Split> all;
  for (const ReducedPoly& e : equations_) { // factors of equations
    const auto& factors = factorizations_->of(e.rest).second;
    for (const MFactor& f : factors)
      if (!known(f.base, false) && (factors.size() > 1 || f.exponent > 1))
        all.push_back({f.base, false});
  }
  if (all.empty()) static_cast<void>(by_signs(&all));
  for (std::size_t i = 0; i < given_.size(); ++i) // parts of sums of squares
    if (given_[i].sign == Sign::positive && reduced_[i].rest.length() > 1)
      static_cast<void>(terms_of(reduced_[i].rest, 1, true, &all));
  std::vector<Split> different;
  for (const Split& s : all) {
    const bool is_known = known(s.p, s.ordered).has_value() || is_constant(s.p) ||
                          is_zero(reduced(s.p).rest) ||
                          std::ranges::any_of(equations_, [&](const ReducedPoly& e) {
                            return divides(certify::primitive(e.rest), s.p).has_value();
                          });
    const bool again = std::ranges::any_of(
        different, [&](const Split& d) { return ratio_of(d.p, s.p).has_value(); });
    if (!is_known && !again) different.push_back(s);
  }
  return different;
}

namespace {

constexpr std::size_t most_branches = 3;

std::vector<Condition> with(std::vector<Condition> given, const MPoly& p, Sign sign) {
  given.push_back({p, sign});
  return given;
}

// One branch of a case distinction, and the conditions there.
struct Branch {
  std::vector<Condition> given;
  std::optional<Json> node;
};

std::vector<Branch> branches(const std::vector<Condition>& given, const RealFacts::Split& s) {
  if (s.ordered)
    return {{with(given, s.p, Sign::positive), {}},
            {with(given, s.p, Sign::zero), {}},
            {with(given, -s.p, Sign::positive), {}}};
  return {{with(given, s.p, Sign::nonzero), {}}, {with(given, s.p, Sign::zero), {}}};
}

Json node_of(const RealFacts::Split& s, std::vector<Branch>& all) {
  if (s.ordered)
    return json_sign_node(s.p, *std::move(all[0].node), *std::move(all[1].node),
                          *std::move(all[2].node));
  return json_zero_node(s.p, *std::move(all[0].node), *std::move(all[1].node));
}

struct Search {
  const Ring& ring;
  const Budget& budget;
  SharedFactorizations factorizations;
  [[nodiscard]] RealFacts facts(const std::vector<Condition>& given) const {
    return RealFacts(ring, given, factorizations);
  }
};

// The branches that are closed at once; how many are not.
std::size_t close(const Search& search, std::vector<Branch>& all) {
  std::size_t open = 0;
  for (Branch& b : all) {
    search.budget.check();
    b.node = search.facts(b.given).contradiction();
    open += b.node ? 0 : 1;
  }
  return open;
}

std::optional<Json> refuted(const Search& search, const std::vector<Condition>& given, int depth);

std::optional<Json> follow(const Search& search, const RealFacts::Split& s, std::vector<Branch> all,
                           int depth) {
  for (Branch& b : all)
    if (!b.node && !(b.node = refuted(search, b.given, depth - 1))) return std::nullopt;
  return node_of(s, all);
}

// A case distinction of which one case is left is a lemma, and is not taken back.
std::optional<Json> refuted(const Search& search, const std::vector<Condition>& given, int depth) {
  search.budget.check();
  const RealFacts facts = search.facts(given);
  if (auto node = facts.contradiction()) return node;
  if (depth == 0) return std::nullopt;
  std::vector<std::pair<RealFacts::Split, std::vector<Branch>>> open;
  for (const RealFacts::Split& s : facts.splits()) {
    std::vector<Branch> all = branches(given, s);
    if (close(search, all) <= 1) return follow(search, s, std::move(all), depth);
    open.emplace_back(s, std::move(all));
  }
  open.resize(std::min(open.size(), most_branches));
  for (auto& [s, all] : open)
    if (auto node = follow(search, s, std::move(all), depth)) return node;
  return std::nullopt;
}

} // namespace

std::optional<Json> refutation(const Ring& ring, const std::vector<Condition>& given, int depth,
                               const Budget& budget, const SharedFactorizations& known) {
  return refuted({ring, budget, known ? known : std::make_shared<Factorizations>()}, given, depth);
}

std::optional<Json> shown(const Ring& ring, std::vector<Condition> given, const Condition& c,
                          int depth, const Budget& budget, const SharedFactorizations& known) {
  given.push_back(negation(c));
  return refutation(ring, given, depth, budget, known);
}

namespace {

// The ring of the names that occur, and the conditions in it: they may come from others.
Ring in_own_ring(std::vector<Condition>& conditions) {
  std::vector<std::string> names;
  for (const Condition& c : conditions)
    for (const std::size_t i : used_variables(c.p))
      add_once(names, c.p.ring()->name(i));
  Ring ring = make_ring(std::move(names));
  for (Condition& c : conditions)
    c.p = is_zero(c.p) ? MPoly(ring) : transfer(MFraction(c.p), ring).num();
  return ring;
}

// A node for conditions of real variables, if it is found soon and the judge accepts it.
std::optional<Json> accepted_refutation(const Ring& ring, std::vector<Condition> conditions,
                                        int depth, double most_work) {
  Budget budget;
  budget.give(most_work);
  try {
    auto node = refutation(ring, conditions, depth, budget);
    if (!node) return std::nullopt;
    certify::Arithmetic arithmetic;
    std::size_t nodes = 10000;
    certify::ConditionSet set(ring, arithmetic);
    for (const Condition& c : conditions)
      set.assume(c);
    certify::SetProof(set, nodes).absent(certify::Node(*node, "node", rationals()));
    return node;
  } catch (const OutOfBudget&) {
    return std::nullopt;
  } catch (const certify::Refused&) {
    return std::nullopt;
  }
}

} // namespace

bool is_refuted_exactly(std::vector<Condition> conditions) {
  constexpr int depth = 4;
  constexpr double most_work = 2e7;
  const Ring ring = in_own_ring(conditions);
  return accepted_refutation(ring, std::move(conditions), depth, most_work).has_value();
}

std::optional<KnownSign> sign_follows(std::vector<Condition> known, MPoly p) {
  constexpr int depth = 2;
  constexpr double most_work = 1e6;
  if (is_zero(p)) return std::nullopt;
  for (const int sign : {1, -1}) {
    std::vector<Condition> all = known;
    all.push_back(negation({sign > 0 ? p : -p, Sign::positive}));
    const Ring ring = in_own_ring(all);
    if (auto node = accepted_refutation(ring, std::move(all), depth, most_work))
      return KnownSign{sign, *std::move(node)};
  }
  return std::nullopt;
}

} // namespace kov
