#include "manifold/lines.hpp"

#include "exact/variables.hpp"
#include "manifold/zeros.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov {
namespace {

/// One chart: the line, and what has to vanish on it.
class LineChart {
public:
  LineChart(const VectorField& v, std::size_t dependent) : v_(v), dependent_(dependent) {
    auto names = v.ring->names();
    for (const char* unknown : {"slope of the line", "offset of the line", "ratio of the momenta"})
      names.emplace_back(unknown);
    ring_ = make_ring(names);
    const std::size_t first = v.ring->size();
    offset_ = first + 1;
    ratio_ = first + 2;
    unknowns_ = {offset_, ratio_};
    if (dependent == 1) unknowns_.insert(unknowns_.begin(), first);
  }

  void find(Lines& all, const Budget& budget) const {
    const auto equations = invariance();
    if (!equations) return;
    auto constants = quadratic_constants(v_);
    for (QuadraticConstant& c : constants)
      c.relation = transfer(MFraction(c.relation), ring_).num();
    ZeroSearch search(ring_, unknowns_, std::move(constants), budget);
    search.run(*equations);
    for (const Substitution& x : search.zeros)
      all.lines.push_back({dependent_, dependent_ == 1 ? back(x.at(v_.ring->size())) : zero(),
                           back(x.at(offset_)), back(x.at(ratio_))});
    for (const auto& list : search.special) {
      std::vector<MPoly> here;
      for (const MPoly& p : list)
        here.push_back(back(MFraction(p)).num());
      all.special.push_back(std::move(here));
    }
    for (const MPoly& d : search.wanted)
      all.wanted.push_back(back(MFraction(d)).num());
  }

private:
  // The coefficients of x_free and p_free; unset where the field has a pole on every line.
  [[nodiscard]] std::optional<std::vector<MPoly>> invariance() const {
    const std::size_t free = 1 - dependent_;
    const MFraction slope = dependent_ == 1 ? unknown(v_.ring->size()) : MFraction(ring_);
    const Substitution line{
        {v_.coordinates[dependent_], slope * unknown(v_.coordinates[free]) + unknown(offset_)},
        {v_.coordinates[dependent_ + 2], unknown(ratio_) * unknown(v_.coordinates[free + 2])}};
    std::vector<MPoly> all;
    try {
      for (const std::size_t part : {0U, 2U}) {
        const MFraction along = part == 0 ? slope : unknown(ratio_);
        const MFraction f =
            substitute(component(dependent_ + part) - along * component(free + part), line);
        add_coefficients(f.num(), {v_.coordinates[free], v_.coordinates[free + 2]}, all);
      }
    } catch (const DomainError&) {
      return std::nullopt;
    }
    return all;
  }
  static void add_coefficients(const MPoly& f, const std::vector<std::size_t>& variables,
                               std::vector<MPoly>& all) {
    std::ranges::move(nonzero_coefficients(f, variables), std::back_inserter(all));
  }
  [[nodiscard]] MFraction component(std::size_t i) const {
    return transfer(v_.components[i], ring_);
  }
  [[nodiscard]] MFraction unknown(std::size_t i) const { return MFraction::variable(ring_, i); }
  [[nodiscard]] MFraction back(const MFraction& f) const { return transfer(f, v_.ring); }
  [[nodiscard]] MFraction zero() const { return MFraction(v_.ring); }

  const VectorField& v_;
  std::size_t dependent_;
  Ring ring_;
  std::size_t offset_ = 0, ratio_ = 0;
  std::vector<std::size_t> unknowns_;
};

} // namespace

Lines find_lines(const VectorField& v, const Budget& budget) {
  Lines all;
  if (v.dimension() != 4 || !v.functions.empty()) return all;
  for (const std::size_t dependent : {1U, 0U})
    LineChart(v, dependent).find(all, budget);
  return all;
}

} // namespace kov
