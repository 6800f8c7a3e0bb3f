#include "classify/together.hpp"

#include "classify/pieces.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>

namespace kov {
namespace {

using Relation = Assumption::Relation;

// "c h + d > 0": a half-line for all values of the other parameters.
bool is_half_line(const Assumption& a, std::size_t h) {
  const bool open = a.relation == Relation::positive || a.relation == Relation::nonnegative;
  return open && is_constant(MFraction(a.value.den())) && degree(a.value.num(), h) == 1 &&
         is_constant(MFraction(coefficients(a.value.num(), h)[1]));
}

bool is_dense(const System& s, const std::vector<std::size_t>& levels, std::size_t h) {
  int half_lines = 0;
  for (const Assumption& a : s.assumptions) {
    if (!uses(a.value, h) || a.relation == Relation::nonzero || a.relation == Relation::real)
      continue;
    const bool alone = std::none_of(levels.begin(), levels.end(), [&](std::size_t other) {
      return other != h && uses(a.value, other);
    });
    if (!alone || !is_half_line(a, h) || ++half_lines > 1) return false;
  }
  return true;
}

} // namespace

std::vector<std::size_t> free_levels(const System& s) {
  const auto levels = level_parameters(s);
  std::vector<std::size_t> free;
  for (const std::size_t h : levels)
    if (is_dense(s, levels, h)) free.push_back(h);
  return free;
}

SystemClassification together(const System& s, const std::vector<Exclusion>& all,
                              const std::stop_token& stop) {
  SystemClassification c = nothing_known(s);
  std::vector<Piece> pieces{{all_parameters(s, free_levels(s), stop, c), {}}};
  for (const Exclusion& e : all)
    static_cast<void>(exclude(pieces, e, s, c)); // what is too hard stays open
  for (Piece& piece : pieces)
    leave_open(std::move(piece), c);
  finish(s, c);
  return c;
}

} // namespace kov
