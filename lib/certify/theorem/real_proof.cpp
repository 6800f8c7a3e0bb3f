#include "certify/theorem/real_proof.hpp"

#include "certify/equation/facts.hpp"
#include "exact/error.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr std::size_t max_terms_of_a_node = 1000, max_zeros = 200;
constexpr long max_exponent_of_a_factor = 100;
constexpr mp_limb_t max_bits_of_a_number = 33220;

Sign sign_of(const Node& n) {
  const std::string text = n.text();
  if (text == "positive") return Sign::positive;
  if (text == "nonnegative") return Sign::nonnegative;
  if (text == "nonzero") return Sign::nonzero;
  if (text != "zero") n.fail("a sign is expected");
  return Sign::zero;
}

Condition negation(const Condition& c) {
  switch (c.sign) {
  case Sign::positive:
    return {-c.p, Sign::nonnegative};
  case Sign::nonnegative:
    return {-c.p, Sign::positive};
  case Sign::nonzero:
    return {c.p, Sign::zero};
  default:
    return {c.p, Sign::nonzero};
  }
}

bool has_sign(const Condition& c) {
  return c.sign == Sign::positive || c.sign == Sign::nonnegative;
}

// f by a number, g not 0.
bool is_multiple(const MPoly& f, const MPoly& g) {
  const MPoly a = primitive(f), b = primitive(g);
  return a == b || a == -b;
}

// The common denominator of the terms of a node is written by nobody: 10000 digits.
void need_short(const Integer& n) {
  need_within(fmpz_bits(n.raw()) <= max_bits_of_a_number, "a limit: the length of a number");
}

} // namespace

Condition primitive(const Condition& c) { return {primitive(c.p), c.sign}; }

Conditions read_conditions(const Ring& ring, const Node& n) {
  Conditions all;
  for (const Node& x : n.items()) {
    Keys k(x);
    all.push_back({read_poly(ring, k.at("p")), sign_of(k.at("sign"))});
    k.done();
  }
  return all;
}

void RealProof::refute(const Node& n, Conditions& given, const Leaf& leaf, int depth) {
  need_within(left_ > 0 && depth > 0, "too many nodes");
  --left_;
  a_.charge(static_cast<double>(10 + given.size()));
  Keys k(n);
  const std::string kind = k.at("node").text();
  if (kind == "empty") return contradiction(n, given);
  if (kind != "sign" && kind != "zero") {
    if (!leaf) n.fail("an unknown node");
    return leaf(n, given);
  }
  const MPoly p = poly(k.at("p"));
  const auto branch = [&](const char* key, const MPoly& f, Sign sign) {
    refute_with({f, sign}, k.at(key), given, leaf, depth - 1);
  };
  if (kind == "sign") {
    need(is_real(p, given), "the sign of what need not be real");
    branch("positive", p, Sign::positive);
    branch("zero", p, Sign::zero);
    branch("negative", -p, Sign::positive);
  } else {
    branch("nonzero", p, Sign::nonzero);
    branch("zero", p, Sign::zero);
  }
  k.done();
}

void RealProof::refute_with(Condition more, const Node& n, Conditions& given, const Leaf& leaf,
                            int depth) {
  given.push_back(std::move(more));
  refute(n, given, leaf, depth);
  given.pop_back();
}

// The negation of a sign is one for what is real only.
void RealProof::show(const Condition& c, const Node& n, Conditions& given) {
  need(!has_sign(c) || is_real(c.p, given), "the sign of what need not be real");
  refute_with(negation(c), n, given, {}, max_node_depth);
}

MPoly RealProof::poly(const Node& n) const {
  MPoly f = read_poly(ring_, n);
  for (const std::size_t i : used_variables(f))
    if (!real_[i] && !complex_[i]) n.fail("a name that is not real");
  return f;
}

bool RealProof::is_real(const MPoly& f) const {
  const auto used = used_variables(f);
  return std::ranges::none_of(used, [&](std::size_t i) { return complex_[i]; });
}

// Its variables are, or a condition says so of a multiple by a number.
bool RealProof::is_real(const MPoly& f, const Conditions& given) const {
  return is_real(f) || std::ranges::any_of(given, [&](const Condition& c) {
           return has_sign(c) && !is_zero(c.p) && is_multiple(f, c.p);
         });
}

const Condition& RealProof::at(const Node& n, const Conditions& given) {
  const long i = n.count();
  need(i >= 0 && static_cast<std::size_t>(i) < given.size(), "there is no such condition");
  return given[static_cast<std::size_t>(i)];
}

RealProof::Term RealProof::term(const Node& n, const Conditions& given) {
  const auto parts = n.items();
  if (parts.size() < 2) n.fail("a term is expected");
  const MPoly q = poly(parts[1]);
  Term t{parts[0].rational(), a_.times(q, q), !is_zero(q) && is_constant(q)};
  need(t.c > Rational(0), "a factor is not positive");
  need_short(t.c.num());
  t.real = is_real(q);
  for (std::size_t j = 2; j < parts.size(); ++j) {
    const auto pair = parts[j].items();
    if (pair.size() != 2) parts[j].fail("an index and an exponent are expected");
    const Condition& f = at(pair[0], given);
    const long e = pair[1].count();
    need(e >= 1 && e <= max_exponent_of_a_factor, "an exponent is out of range");
    need(f.sign != Sign::zero, "a factor has no sign");
    t.real = t.real && (f.sign != Sign::nonzero || (e % 2 == 0 && is_real(f.p)));
    t.strict = t.strict && f.sign != Sign::nonnegative;

    t.f = a_.times(t.f, a_.power(f.p, static_cast<unsigned long>(e)));
  }
  return t;
}

void RealProof::contradiction(const Node& n, const Conditions& given) {
  Keys k(n);
  static_cast<void>(k.at("node"));
  const auto terms = k.at("terms").items(), zeros = k.at("zeros").items();
  k.done();
  if (terms.size() > max_terms_of_a_node || zeros.size() > max_zeros) n.fail("too many terms");
  std::vector<Term> all;
  Integer common(1);
  for (const Node& t : terms) {
    all.push_back(term(t, given));
    need_short(all.back().c.den());
    common = a_.common_multiple(common, all.back().c.den());
    need_short(common);
  }
  MPoly sum(ring_);
  for (const Term& t : all)
    sum = a_.plus(sum, a_.scaled(t.f, t.c.num() * exact_div(common, t.c.den())));
  for (const Node& z : zeros) {
    const auto pair = z.items();
    if (pair.size() != 2) z.fail("an index and a polynomial are expected");
    const Condition& f = at(pair[0], given);
    need(f.sign == Sign::zero, "a condition is not one of sign zero");
    sum = a_.plus(sum, a_.scaled(a_.times(poly(pair[1]), f.p), common));
  }
  need(std::ranges::any_of(all, [](const Term& t) { return t.strict; }), "no term is strict");
  need(all.size() == 1 || std::ranges::all_of(all, [](const Term& t) { return t.real; }),
       "a factor has no sign");
  need(is_zero(sum), "the sum is not 0");
}

} // namespace kov::certify
