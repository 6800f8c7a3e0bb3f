#include "closed/generic_form.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

std::string root_text(const MFraction& square) {
  const auto root = square_root(square);
  return root ? to_string(*root) : "sqrt(" + to_string(square) + ")";
}

GenericForm told(ClassicalAnswer answer, const MFraction& z, std::vector<MPoly> generic) {
  GenericForm all{std::move(answer), std::move(generic), "", {}, ""};
  const ClassicalForm& form = all.answer.form;
  const auto& x = all.answer.x;
  const auto& scale = all.answer.scale;
  NamedNumbers named = numbers_of(form, z.ring());
  if (scale && to_string(scale->second) == scale->first) named.letter.keep(scale->first);
  if (x == z && to_string(z) == "x") named.letter.keep("x");
  if (scale) named.all.emplace_back(named.letter(scale->first), to_string(scale->second));
  all.numbers = std::move(named.all);
  all.equation =
      named.letter.in(canonical_equation(form.family, form.family == Classical::bessel && !scale));
  const bool moved = form.family != Classical::euler && form.family != Classical::riemann;
  if (x != z) all.change = named.letter(moved ? "x" : "v") + " = " + to_string(x);
  return all;
}

} // namespace

NamedNumbers numbers_of(const ClassicalForm& form, const Ring& ring) {
  NamedNumbers named{FreshLetters(ring), {}};
  for (const auto& [name, square] : form.squares)
    named.all.emplace_back(name, root_text(square));
  for (const auto& [name, value] : form.values)
    named.all.emplace_back(name, to_string(value));
  for (const auto& [name, value] : named.all)
    if (value == name)
      for (const std::string& letter : names_in_text(name)) // n of 2*n + 1
        named.letter.keep(letter);
  for (auto& [name, value] : named.all)
    name = named.letter.in(name);
  return named;
}

std::string abelian_where(const std::vector<Part>& parts) {
  std::string where;
  for (const Part& p : parts)
    if (p.abelian == Truth::yes) where += (where.empty() ? "" : ", or where ") + in_words(p);
  return where;
}

Truth GenericForm::abelian() const {
  const Truth first = answer.parts.front().abelian;
  const bool same =
      std::ranges::all_of(answer.parts, [&](const Part& p) { return p.abelian == first; });
  return same ? first : Truth::unknown;
}

std::string GenericForm::summary() const {
  if (abelian() == Truth::yes) return "the identity component is always abelian";
  if (abelian() == Truth::no) return "the identity component is never abelian";
  return "the identity component is abelian exactly where " + abelian_where(answer.parts);
}

std::optional<GenericForm> generic_form(const MFraction& r, std::size_t z, ParametrisedSet region,
                                        const Budget& budget) {
  std::vector<MPoly> generic;
  if (is_zero(r)) return std::nullopt;
  for (;;) {
    std::variant<std::monostate, ClassicalAnswer, Needs> found;
    auto places = scheme(r, z, region, budget);
    if (auto* needs = std::get_if<Needs>(&places))
      found = std::move(*needs);
    else
      found = classical_answer(std::get<Scheme>(places), region, budget);
    if (found.index() == 0) return std::nullopt;
    if (auto* answer = std::get_if<ClassicalAnswer>(&found))
      return told(std::move(*answer), MFraction::variable(r.ring(), z), std::move(generic));
    generic.push_back(std::get<Needs>(found).p);
    region = region.where_nonzero(generic.back());
  }
}

} // namespace kov::strata
