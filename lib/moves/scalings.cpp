#include "moves/scalings.hpp"

#include "exact/finite_algebra.hpp"

namespace kov {
namespace {

/// Linear equations for the weights: of the variables of the ring, then of the time and the bracket.
class WeightEquations {
public:
  explicit WeightEquations(const System& s) : ring_(s.ring()), v_(s.field) {
    for (const MPoly& f : v_.relations)
      add_homogeneous(f);
    for (std::size_t j = 0; j < v_.dimension(); ++j)
      add(v_.components[j], {{v_.coordinates[j], 1}, {time(), 1}});
    for (const FunctionSymbol& u : v_.functions)
      for (std::size_t j = 0; j < v_.dimension(); ++j)
        add(u.gradient[j], {{u.variable, 1}, {v_.coordinates[j], -1}});
    if (v_.poisson)
      for (std::size_t i = 0; i < v_.dimension(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          add((*v_.poisson)[i][j],
              {{v_.coordinates[i], 1}, {v_.coordinates[j], 1}, {bracket(), 1}});
    for (const std::size_t c : v_.constants)
      add_row({{c, 1}});
  }

  [[nodiscard]] Matrix all() const { return null_space(rows_, ring_->size() + 2, ring_); }

private:
  using Row = std::map<std::size_t, long>;

  [[nodiscard]] std::size_t time() const { return ring_->size(); }
  [[nodiscard]] std::size_t bracket() const { return ring_->size() + 1; }

  void add_row(const Row& row) {
    std::vector<MFraction> all(ring_->size() + 2, MFraction(ring_));
    for (const auto& [i, c] : row)
      all[i] = MFraction(ring_, Rational(c));
    rows_.push_back(std::move(all));
  }
  static Row exponents(const MPoly& f, long term) {
    Row row;
    const auto e = f.exponents(term);
    for (std::size_t i = 0; i < e.size(); ++i)
      if (e[i] > 0) row[i] = static_cast<long>(e[i]);
    return row;
  }
  static Row minus(Row a, const Row& b) {
    for (const auto& [i, c] : b)
      a[i] -= c;
    return a;
  }
  void add_homogeneous(const MPoly& f) {
    for (long t = 1; t < f.length(); ++t)
      add_row(minus(exponents(f, t), exponents(f, 0)));
  }
  // f is homogeneous with this weight.
  void add(const MFraction& f, const Row& weight) {
    if (is_zero(f)) return;
    add_homogeneous(f.num());
    add_homogeneous(f.den());
    add_row(minus(minus(exponents(f.num(), 0), exponents(f.den(), 0)), weight));
  }

  Ring ring_;
  const VectorField& v_;
  Matrix rows_;
};

} // namespace

Matrix scalings(const System& s) { return WeightEquations(s).all(); }

} // namespace kov
