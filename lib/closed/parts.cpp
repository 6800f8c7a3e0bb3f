#include "closed/parts.hpp"

#include "exact/joined.hpp"

namespace kov::strata {

std::string in_words(const Part& part) {
  return joined(
      part.where, [](const Statement& s) { return to_string(s); }, " and ");
}

Truth holds_on(const Assertion& s, const std::vector<Statement>& before,
               const ParametrisedSet& region) {
  if (const Truth known = holds_on(s, region); known != Truth::unknown) return known;
  for (const bool holds : {true, false}) {
    std::vector<Statement> here = before;
    here.push_back({s, holds});
    if (proved_empty(here, region)) return truth(!holds);
  }
  return Truth::unknown;
}

void Parts::add(GroupType type, std::optional<Integer> n, const char* /*reason*/) {
  const GaloisGroup g{type, std::move(n)};
  parts_.push_back({path_, truth(is_abelian(identity_component(g))), g});
}

} // namespace kov::strata
