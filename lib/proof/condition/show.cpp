#include "proof/condition/show.hpp"

#include "proof/text/refused.hpp"

namespace kov::certify {

namespace {

constexpr std::size_t max_terms_of_a_node = 1000, max_zeros = 200;
constexpr unsigned long max_exponent_of_a_factor = 100;

std::vector<Node> pair_of(const Node& n, const char* what) {
  auto pair = n.items();
  if (pair.size() != 2) n.fail(what);
  return pair;
}

} // namespace

void SetProof::absent(const Node& n, const Part& part, int depth) {
  need_within(left_ > 0 && depth > 0, "too many nodes");
  --left_;
  set_.arithmetic().charge(static_cast<double>(10 + set_.conditions().size()));
  Keys k(n);
  const std::string kind = k.at("node").text();
  if (kind == "empty") return contradiction(n);
  if (kind != "sign" && kind != "zero") {
    if (!part) n.fail("an unknown node");
    return part(n, set_);
  }
  const MPoly p = read_poly(set_.ring(), k.at("p"), set_.names());
  const bool sign = kind == "sign";
  std::vector<std::pair<Node, Condition>> branches{
      {k.at(sign ? "positive" : "nonzero"), {p, sign ? Sign::positive : Sign::nonzero}},
      {k.at("zero"), {p, Sign::zero}}};
  if (sign) branches.emplace_back(k.at("negative"), Condition{-p, Sign::positive});
  k.done();
  need(!sign || set_.is_real(p), "the sign of what need not be real");
  for (auto& [child, more] : branches)
    absent_with(std::move(more), child, part, depth - 1);
}

void SetProof::absent_with(Condition more, const Node& n, const Part& part, int depth) {
  set_.assume(std::move(more));
  absent(n, part, depth);
  set_.forget();
}

void SetProof::show(const Condition& c, const Node& n) {
  need(!is_ordered(c.sign) || set_.is_real(c.p), "the sign of what need not be real");
  absent_with(negation(c), n, {}, max_depth);
}

void SetProof::show_some(const std::vector<MPoly>& all, const Node& n) {
  for (const MPoly& f : all)
    set_.assume({f, Sign::zero});
  absent(n);
  for (std::size_t i = 0; i < all.size(); ++i)
    set_.forget();
}

SignTerm SetProof::term(const Node& n) const {
  const auto parts = n.items();
  if (parts.size() < 2) n.fail("a term is expected");
  SignTerm t{parts[0].rational(), read_poly(set_.ring(), parts[1], set_.names())};
  for (std::size_t j = 2; j < parts.size(); ++j) {
    const auto pair = pair_of(parts[j], "an index and an exponent are expected");
    t.powers.emplace_back(static_cast<std::size_t>(pair[0].count()),
                          static_cast<unsigned long>(pair[1].count()));
  }
  return t;
}

// sum of the TERMs + sum P f = 0
void SetProof::contradiction(const Node& n) {
  Keys k(n);
  static_cast<void>(k.at("node"));
  const auto terms = k.at("terms").items(), zeros = k.at("zeros").items();
  k.done();
  if (terms.size() > max_terms_of_a_node || zeros.size() > max_zeros) n.fail("too many terms");
  std::vector<SignTerm> all;
  for (const Node& t : terms)
    all.push_back(term(t));
  std::vector<std::pair<std::size_t, MPoly>> multiples;
  for (const Node& z : zeros) {
    const auto pair = pair_of(z, "an index and a polynomial are expected");
    multiples.emplace_back(static_cast<std::size_t>(pair[0].count()),
                           read_poly(set_.ring(), pair[1], set_.names()));
  }
  // all is read: from here on it is judged
  for (const SignTerm& t : all)
    for (const auto& [i, e] : t.powers)
      need(e >= 1 && e <= max_exponent_of_a_factor, "an exponent is out of range");
  auto [sum, common] = set_.sum(all, false);
  Arithmetic& a = set_.arithmetic();
  for (const auto& [i, p] : multiples)
    sum = a.plus(sum, a.scaled(a.times(p, set_.condition(i, {Sign::zero})), common));
  need(is_zero(sum), "the sum is not 0");
}

} // namespace kov::certify
