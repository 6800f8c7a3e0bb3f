#include "algebraize/rational_system.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <numeric>

namespace kov {
namespace {

using Element = FunctionField::Element;

// A basis of the function field over K(z), K with the algebraic constants: of standard monomials
// without constants.
class Basis {
public:
  Basis(const FunctionField& f, const VectorField& v, const Budget& budget)
      : f_(f), budget_(budget), columns_(f.algebra().dimension()) {
    for (const std::size_t i : f.algebra().ideal().main())
      constant_.push_back(is_among(i, v.constants));
    for (const Monomial& monomial : f.algebra().basis())
      if (part(monomial, true) == monomial) constants_.push_back(monomial);
    for (const Monomial& monomial : f.algebra().basis())
      if (part(monomial, false) == monomial && rests_.size() < f.degree()) try_rest(monomial);
  }

  [[nodiscard]] std::size_t size() const noexcept { return rests_.size(); }
  /// No relation between a constant and the rest.
  [[nodiscard]] bool is_product() const {
    const std::size_t n = f_.algebra().dimension();
    return size() * constants_.size() == n &&
           null_space(columns_, n, f_.algebra().ring(), budget_).empty();
  }

  [[nodiscard]] Element element(std::size_t k) const { return monomial(rests_[k]); }

  /// The coefficients of an element, functions of z, the parameters and the constants.
  [[nodiscard]] std::vector<MFraction> coordinates(const Element& e) const {
    const auto x = solve_linear(columns_, e, budget_);
    KOV_ENSURE(x.has_value());
    std::vector<MFraction> c(size(), MFraction(f_.algebra().ring()));
    for (std::size_t i = 0; i < x->size(); ++i)
      if (!is_zero((*x)[i]))
        c[i / constants_.size()] += (*x)[i] * value(constants_[i % constants_.size()]);
    return c;
  }

  [[nodiscard]] MFraction function(std::size_t k) const { return value(rests_[k]); }
  [[nodiscard]] std::string name(std::size_t k) const {
    return k == 0 ? std::string() : "/(" + to_string(function(k)) + ")";
  }

private:
  // Takes the monomial unless it is a combination of those before, over the constants.
  void try_rest(const Monomial& rest) {
    const Element b = monomial(rest);
    if (!rests_.empty() && solve_linear(columns_, b, budget_)) return;
    rests_.push_back(rest);
    for (const Monomial& c : constants_) {
      const Element product = f_.algebra().multiply(monomial(c), b);
      for (std::size_t i = 0; i < columns_.size(); ++i)
        columns_[i].push_back(product[i]);
    }
  }
  [[nodiscard]] Element monomial(const Monomial& m) const {
    Element e = f_.algebra().zero();
    const auto& all = f_.algebra().basis();
    const auto at = std::ranges::find(all, m) - all.begin();
    e[static_cast<std::size_t>(at)] = MFraction(f_.algebra().ring(), Rational(1));
    return e;
  }
  [[nodiscard]] Monomial part(Monomial m, bool constant) const {
    for (std::size_t i = 0; i < m.size(); ++i)
      if (constant_[i] != constant) m[i] = 0;
    return m;
  }
  [[nodiscard]] MFraction value(const Monomial& m) const {
    KPoly p(MonomialOrder{0});
    p.emplace(m, MFraction(f_.algebra().ring(), Rational(1)));
    return f_.algebra().ideal().from_kpoly(p);
  }

  const FunctionField& f_;
  const Budget& budget_;
  std::vector<bool> constant_; // by main variable
  std::vector<Monomial> constants_, rests_;
  Matrix columns_; // the products of the rests with the constants
};

using ElementMatrix = std::vector<std::vector<Element>>;

// J/z'
std::optional<ElementMatrix> divided_by_z_dot(const FunctionField& f, const Matrix& j) {
  ElementMatrix a;
  for (const auto& row : j) {
    a.emplace_back();
    for (const MFraction& entry : row) {
      const auto e = f.evaluate(entry);
      if (!e) return std::nullopt;
      a.back().push_back(f.algebra().multiply(*e, f.inverse_z_dot()));
    }
  }
  return a;
}

// Row (i, k) and column (j, l) at i d + k and j d + l.
Matrix restricted(const FunctionField& f, const Basis& basis, const ElementMatrix& a) {
  const std::size_t d = basis.size(), n = a.size();
  Matrix big(n * d, std::vector<MFraction>(n * d, MFraction(f.algebra().ring())));
  for (std::size_t l = 0; l < d; ++l) {
    const Element b = basis.element(l);
    const auto change = basis.coordinates(f.derivative(b));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const auto c = basis.coordinates(f.algebra().multiply(a[i][j], b));
        for (std::size_t k = 0; k < d; ++k) {
          big[i * d + k][j * d + l] = c[k];
          if (i == j) big[i * d + k][j * d + l] -= change[k];
        }
      }
  }
  return big;
}

// The connected part of the graph "uses or is used by" that holds `start`, ascending.
std::vector<std::size_t> connected_part(const Matrix& a, std::size_t start) {
  std::vector<bool> seen(a.size());
  std::vector<std::size_t> part{start};
  seen[start] = true;
  for (std::size_t k = 0; k < part.size(); ++k)
    for (std::size_t j = 0; j < a.size(); ++j)
      if (!seen[j] && (!is_zero(a[part[k]][j]) || !is_zero(a[j][part[k]]))) {
        seen[j] = true;
        part.push_back(j);
      }
  std::ranges::sort(part);
  return part;
}

// One connected part for each unknown.
std::vector<std::size_t> enough(const Matrix& a, std::size_t d) {
  std::vector<bool> covered(a.size() / d);
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    if (covered[i]) continue;
    for (const std::size_t j : connected_part(a, i * d)) {
      covered[j / d] = true;
      chosen.push_back(j);
    }
  }
  std::ranges::sort(chosen);
  return chosen;
}

Matrix selected(const Matrix& a, const std::vector<std::size_t>& indices) {
  Matrix b;
  for (const std::size_t i : indices) {
    b.emplace_back();
    for (const std::size_t j : indices)
      b.back().push_back(a[i][j]);
  }
  return b;
}

} // namespace

std::variant<RationalSystem, ChangeFailure>
rational_system(const VectorField& v, const InvariantManifold& m, std::size_t z,
                const MFraction& phi, const LinearSystem& s, const std::vector<MPoly>& divisors,
                const Budget& budget) {
  auto field = FunctionField::make(v, m, z, phi, divisors, budget);
  if (auto* failure = std::get_if<ChangeFailure>(&field)) return *std::move(failure);
  const auto& f = std::get<FunctionField>(field);
  const Basis basis(f, v, budget);
  if (!basis.is_product())
    return ChangeFailure{"the algebraic constants are not independent of the curve"};
  const auto a = divided_by_z_dot(f, s.a);
  if (!a) return ChangeFailure{"an entry of the system has a pole along the whole curve"};
  const Matrix all = restricted(f, basis, *a);
  const std::vector<std::size_t> indices = enough(all, basis.size());
  RationalSystem result;
  for (const std::size_t i : indices) {
    result.names.push_back(s.names[i / basis.size()] + basis.name(i % basis.size()));
    result.unknowns.push_back(i / basis.size());
    result.basis.push_back(basis.function(i % basis.size()));
  }
  result.a = selected(all, indices);
  result.change = v.ring->name(z) + " = " + to_string(phi);
  result.z = z;
  result.field_degree = f.degree();
  result.inverted = f.inverted();
  return result;
}

namespace {

// K(z, w), w = dz/dt, in the basis 1, w.
class FieldOverZ {
public:
  FieldOverZ(const FunctionField& f, const Basis& basis)
      : f_(f), basis_(basis), w_(basis.coordinates(f.z_dot())) {}

  [[nodiscard]] bool is_generated() const { return !is_zero(w_[1]); }
  /// w^2, if it is a function of z.
  [[nodiscard]] std::optional<MFraction> square() const {
    const auto c = basis_.coordinates(f_.algebra().multiply(f_.z_dot(), f_.z_dot()));
    return is_zero(c[1]) ? std::optional(c[0]) : std::nullopt;
  }
  /// The coefficients of 1 and w.
  [[nodiscard]] std::pair<MFraction, MFraction> parts(const Element& e) const {
    const auto c = basis_.coordinates(e);
    const MFraction odd = c[1] / w_[1];
    return {c[0] - odd * w_[0], odd};
  }

private:
  const FunctionField& f_;
  const Basis& basis_;
  std::vector<MFraction> w_;
};

} // namespace

std::variant<SystemOnTwoSheets, ChangeFailure>
system_on_two_sheets(const VectorField& v, const InvariantManifold& m, std::size_t z,
                     const MFraction& phi, const LinearSystem& s, const Budget& budget) {
  auto field = FunctionField::make(v, m, z, phi, {}, budget);
  if (auto* failure = std::get_if<ChangeFailure>(&field)) return *std::move(failure);
  const auto& f = std::get<FunctionField>(field);
  const Basis basis(f, v, budget);
  if (!basis.is_product())
    return ChangeFailure{"the algebraic constants are not independent of the curve"};
  SystemOnTwoSheets result{s.names, {}, {}, {}, v.ring->name(z) + " = " + to_string(phi), z};
  if (basis.size() != 2) return ChangeFailure{result.change + " is not of degree 2 on the curve"};
  const FieldOverZ sheets(f, basis);
  const auto square = sheets.square();
  if (!sheets.is_generated() || !square)
    return ChangeFailure{"the curve is not (dz/dt)^2 = F(z) for " + result.change};
  result.z_dot_squared = *square;
  for (const auto& row : s.a) {
    result.even.emplace_back();
    result.odd.emplace_back();
    for (const MFraction& entry : row) {
      const auto e = f.evaluate(entry);
      if (!e) return ChangeFailure{"an entry of the system has a pole along the whole curve"};
      auto [even, odd] = sheets.parts(*e);
      result.even.back().push_back(std::move(even));
      result.odd.back().push_back(std::move(odd));
    }
  }
  return result;
}

} // namespace kov
