#include "literature/levels.hpp"
#include "exact/joined.hpp"

namespace kov {

std::string sentence(const LevelEquation& e) { return e.left + " = " + e.right; }

std::string sentence(const LevelChoice& c) {
  return joined(c, [&](const LevelEquation& e) { return sentence(e); });
}

std::string sentence(const std::vector<LevelChoice>& all) {
  if (all.size() == 1) return sentence(all.front());
  return joined(
      all, [&](const LevelChoice& c) { return c.empty() ? "a general level" : sentence(c); },
      " or ");
}

Levels levels_at(const LevelChoice& c) {
  if (c.empty()) return {};
  return {Levels::Which::these, {c}};
}

namespace {

std::string which_levels(const Levels& l) {
  using Which = Levels::Which;
  switch (l.which) {
  case Which::none:
    return "";
  case Which::these:
    return sentence(l.values);
  case Which::of_energy:
    return "at the energy " + sentence(l.values);
  case Which::all_but_special:
    return "all levels of the first integrals except special ones";
  case Which::all_but_finitely_many:
    return "for all but finitely many values of the energy";
  case Which::all_but_countably_many:
    return "for all but countably many values of the energy";
  case Which::energy_not_zero:
    return "energy not 0";
  case Which::energy_of_part_not_zero:
    return "energy of this part not 0";
  }
  return "";
}

} // namespace

std::string sentence(const Levels& l) {
  std::string text = which_levels(l), scaled;
  const auto add = [](std::string& all, const std::string& one) {
    all += (all.empty() ? "" : ", ") + one;
  };
  for (const std::string& equation : l.fixed)
    add(text, equation);
  for (const std::string& name : l.ones)
    add(scaled, name + " = 1");
  if (!scaled.empty()) add(text, scaled + " by a change of scale");
  return text;
}

} // namespace kov
