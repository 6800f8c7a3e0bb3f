#pragma once
// The two perturbations of the Euler top that the tests of this room speak of.

#include "splitting/residue_sums.hpp"
#include "support/source_dir.hpp"

#include <map>
#include <string>
#include <vector>

namespace kov {

inline const std::vector<std::string> small{"L1", "L2", "L3"};

inline const SplittingData& sliding_top() {
  static const SplittingData d = splitting_data(perturbation_of_euler(
      read_system(test::in_source("/cases/sliding_top/sliding_top.toml"), {{"g", "0"}}), small));
  return d;
}

inline const SplittingData& heavy_top() {
  static const SplittingData d = splitting_data(
      perturbation_of_euler(read_system(test::in_source("/cases/classics/heavy_top.toml")), small));
  return d;
}

inline const StripResidues& residues_of(const SplittingData& d, long k, int sign) {
  for (const StripResidues& r : d.residues)
    if (r.k == k && r.sign == sign) return r;
  throw InvalidArgument("no such mode");
}

class Names {
public:
  explicit Names(const SplittingData& d) : d_(d) {}
  MFraction operator()(const char* name) const { return d_.space.chart.variable(name); }
  [[nodiscard]] MFraction number(long n) const { return {d_.space.chart.ring, Rational(n)}; }

private:
  const SplittingData& d_;
};

inline MFraction operator*(long n, const MFraction& f) { return Rational(n) * f; }

/// The letters of the formulas for the sliding top, and what one asks of them.
struct SlidingTopLetters {
  const SplittingData& d = sliding_top();
  Names x{d};
  MFraction al = x("alpha"), be = x("beta"), de = x("delta"), b = x("b"), i = x("i");
  MFraction s1 = x("L1"), s2 = x("L2"), s3 = x("L3");
  MFraction a2 = al * al, b2 = be * be, d2 = a2 + b2;

  [[nodiscard]] bool equal(const MFraction& f, const MFraction& g) const {
    return d.space.field.is_zero(f - g);
  }
  [[nodiscard]] MFraction re(const MFraction& f) const {
    return d.space.field.parts(d.space.field.reduce(f), d.space.chart.ring->index("i")).first;
  }
  [[nodiscard]] MFraction im(const MFraction& f) const {
    return d.space.field.parts(d.space.field.reduce(f), d.space.chart.ring->index("i")).second;
  }
  [[nodiscard]] MFraction at(const MFraction& f,
                             const std::map<std::string, MFraction>& values) const {
    Substitution by;
    for (const auto& [name, value] : values)
      by[d.space.chart.ring->index(name)] = value;
    return d.space.field.reduce(substitute(f, by));
  }
  [[nodiscard]] MFraction at_zero(const MFraction& f, const std::vector<std::string>& names) const {
    std::map<std::string, MFraction> values;
    for (const std::string& n : names)
      values[n] = x.number(0);
    return at(f, values);
  }
};

} // namespace kov
