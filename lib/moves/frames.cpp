#include "moves/frames.hpp"

#include "exact/finite_algebra.hpp"
#include "exact/linear.hpp"
#include "integrability/parameters.hpp"
#include "integrals/ansatz.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_dimensions = 6;

/// Polynomials in the coordinates as rows of a linear system: one for each monomial, with coefficients in
/// the parameters.
class MonomialRows {
public:
  explicit MonomialRows(const System& s) : s_(s) {}

  void begin_equations() { rows_.clear(); }
  void add(std::size_t column, const MPoly& f) {
    for (const auto& [monomial, c] : by_monomials(f, s_.field.coordinates))
      rows_[monomial].try_emplace(column, s_.ring()).first->second += MFraction(c);
  }
  void put_equations(std::size_t columns, Matrix& all) const {
    for (const auto& [monomial, row] : rows_) {
      all.emplace_back(columns, MFraction(s_.ring()));
      for (const auto& [column, entry] : row)
        all.back()[column] = entry;
    }
  }

private:
  const System& s_;
  std::map<std::vector<unsigned long>, std::map<std::size_t, MFraction>> rows_;
};

// J has polynomial entries over Q.
bool is_polynomial(const System& s) {
  for (const auto& row : *s.field.poisson)
    for (const MFraction& entry : row)
      if (!is_constant(MFraction(entry.den()))) return false;
  return true;
}

// Linear vector fields A x that keep the bracket: xi(J_ij) = sum_k A_ik J_kj + A_jk J_ik.
std::vector<Matrix> derivations(const System& s, const Budget& budget) {
  const VectorField& v = s.field;
  const std::size_t n = v.dimension();
  const Matrix& bracket = *v.poisson;
  Matrix equations;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      MonomialRows rows(s);
      for (std::size_t r = 0; r < n; ++r)
        for (std::size_t c = 0; c < n; ++c) {
          MFraction f = MFraction::variable(v.ring, v.coordinates[c]) *
                        derivative(bracket[i][j], v.coordinates[r]);
          if (i == r) f -= bracket[c][j];
          if (j == r) f -= bracket[i][c];
          rows.add(n * r + c, f.num()); // denominators are numbers, and 1 as J is that of the file
        }
      rows.put_equations(n * n, equations);
    }
  std::vector<Matrix> all;
  for (const auto& solution : null_space(std::move(equations), n * n, v.ring, budget)) {
    all.emplace_back(n);
    for (std::size_t i = 0; i < n; ++i)
      all.back()[i].assign(solution.begin() + static_cast<long>(n * i),
                           solution.begin() + static_cast<long>(n * (i + 1)));
  }
  return all;
}

std::vector<std::size_t> moving_parameters(const System& s) {
  std::vector<std::size_t> all;
  for (const std::size_t p : s.field.parameters)
    if (uses(*s.field.hamiltonian, p)) all.push_back(p);
  return all;
}

std::vector<MFraction> linear_field(const System& s, const Matrix& a) {
  std::vector<MFraction> all;
  for (const auto& row : a) {
    all.emplace_back(s.ring());
    for (std::size_t j = 0; j < row.size(); ++j)
      if (!is_zero(row[j]))
        all.back() += row[j] * MFraction::variable(s.ring(), s.field.coordinates[j]);
  }
  return all;
}

Matrix product(const Matrix& a, const Matrix& b, const Ring& ring) {
  Matrix c(a.size(), std::vector<MFraction>(a.size(), MFraction(ring)));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t k = 0; k < a.size(); ++k)
        c[i][j] += a[i][k] * b[k][j];
  return c;
}

// A^3 = -A: exp(t A) = 1 + sin t A + (1 - cos t) A^2.
bool is_rotation(const Matrix& a, const Ring& ring) {
  const Matrix cube = product(product(a, a, ring), a, ring);
  bool some = false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j) {
      if (!is_constant(a[i][j]) || !is_zero(cube[i][j] + a[i][j])) return false;
      some = some || !is_zero(a[i][j]);
    }
  return some;
}

/// p' = a q, q' = -a p with a = 1 or -1
struct RotatedPair {
  std::size_t p = 0, q = 0;
  int a = 1;
};

// Unset: eta is not a rotation of pairs of parameters.
std::optional<std::vector<RotatedPair>> pairs(const System& s, const Substitution& moving) {
  std::vector<RotatedPair> all;
  for (const auto& [p, value] : moving) {
    const auto used = used_variables(value);
    if (used.size() != 1) return std::nullopt;
    const std::size_t q = used.front();
    const MFraction x = MFraction::variable(s.ring(), p), y = MFraction::variable(s.ring(), q);
    const int a = value == y ? 1 : value == -y ? -1 : 0;
    const auto back = moving.find(q);
    if (a == 0 || q == p || back == moving.end() || !(back->second == Rational(-a) * x))
      return std::nullopt;
    if (p < q) all.push_back({p, q, a});
  }
  return all;
}

// Nothing is assumed of it but that it is real.
bool is_free(const System& s, std::size_t p) {
  return std::ranges::none_of(s.assumptions, [&](const Assumption& a) {
    return uses(a.value, p) && !(a.is(Sort::real) && a.value == MFraction::variable(s.ring(), p));
  });
}

// The rotation by the angle at which q becomes 0 and p the root r of p^2 + q^2.
Equivalence rotation(const System& s, const Matrix& a, const std::vector<RotatedPair>& all) {
  Equivalence e;
  std::vector<std::string> names = s.ring()->names();
  std::string root = "r";
  while (s.ring()->find(root))
    root += "_";
  names.push_back(root);
  e.ring = make_ring(names);
  e.root = names.size() - 1;
  const auto x = [&](std::size_t i) { return MFraction::variable(e.ring, i); };
  const RotatedPair& first = all.front();
  const MFraction r = x(*e.root), one(e.ring, Rational(1));
  const MFraction cosine = x(first.p) / r, sine = Rational(first.a) * x(first.q) / r;
  e.square = MPoly::variable(s.ring(), first.p) * MPoly::variable(s.ring(), first.p) +
             MPoly::variable(s.ring(), first.q) * MPoly::variable(s.ring(), first.q);
  for (const RotatedPair& pair : all) {
    e.parameters[pair.p] = cosine * x(pair.p) + Rational(pair.a) * sine * x(pair.q);
    e.parameters[pair.q] = cosine * x(pair.q) - Rational(pair.a) * sine * x(pair.p);
  }
  e.parameters[first.p] = r;
  e.parameters[first.q] = MFraction(e.ring);
  const Matrix square = product(a, a, s.ring());
  for (std::size_t i = 0; i < a.size(); ++i) {
    e.phase.push_back(x(s.field.coordinates[i]));
    for (std::size_t j = 0; j < a.size(); ++j)
      e.phase[i] +=
          (sine * transfer(a[i][j], e.ring) + (one - cosine) * transfer(square[i][j], e.ring)) *
          x(s.field.coordinates[j]);
  }
  e.time = e.bracket = one;
  const auto& name = [&](std::size_t i) { return s.ring()->name(i); };
  e.real = s.real.contains(name(first.p)) && s.real.contains(name(first.q));
  return e;
}

} // namespace

std::vector<InfinitesimalSymmetry> infinitesimal_symmetries(const System& s, const Budget& budget) {
  const VectorField& v = s.field;
  if (!v.hamiltonian || !v.poisson || !v.functions.empty() || !v.relations.empty() ||
      !v.constants.empty() || v.dimension() > most_dimensions || !is_polynomial(s))
    return {};
  const std::vector<Matrix> phase = derivations(s, budget);
  const std::vector<std::size_t> parameters = moving_parameters(s);
  const std::size_t columns = phase.size() + parameters.size();
  // d(N/D) = (D dN - N dD)/D^2
  const MPoly &n = v.hamiltonian->num(), &d = v.hamiltonian->den();
  MonomialRows rows(s);
  for (std::size_t k = 0; k < phase.size(); ++k) {
    const auto field = linear_field(s, phase[k]);
    MFraction numerator(s.ring());
    for (std::size_t i = 0; i < v.dimension(); ++i)
      numerator += field[i] * MFraction(d * derivative(n, v.coordinates[i]) -
                                        n * derivative(d, v.coordinates[i]));
    rows.add(k, numerator.num());
  }
  for (std::size_t k = 0; k < parameters.size(); ++k)
    rows.add(phase.size() + k, d * derivative(n, parameters[k]) - n * derivative(d, parameters[k]));
  Matrix equations;
  rows.put_equations(columns, equations);
  Matrix kernel = null_space(std::move(equations), columns, s.ring(), budget);
  row_reduce(kernel, std::views::iota(std::size_t{0}, columns)); // what can be constant is
  std::vector<InfinitesimalSymmetry> all;
  for (const auto& row : kernel) {
    InfinitesimalSymmetry one{
        Matrix(v.dimension(), std::vector<MFraction>(v.dimension(), MFraction(s.ring()))), {}};
    for (std::size_t k = 0; k < phase.size(); ++k)
      for (std::size_t i = 0; !is_zero(row[k]) && i < v.dimension(); ++i)
        for (std::size_t j = 0; j < v.dimension(); ++j)
          one.phase[i][j] += row[k] * phase[k][i][j];
    for (std::size_t k = 0; k < parameters.size(); ++k)
      if (!is_zero(row[phase.size() + k])) one.moving[parameters[k]] = row[phase.size() + k];
    all.push_back(std::move(one));
  }
  return all;
}

std::optional<Frame> find_frame(const System& s, const Budget& budget) {
  for (const InfinitesimalSymmetry& y : infinitesimal_symmetries(s, budget)) {
    if (y.moving.empty() || !is_rotation(y.phase, s.ring())) continue;
    const auto rotated = pairs(s, y.moving);
    if (!rotated || std::ranges::any_of(*rotated, [&](const RotatedPair& pair) {
          return !is_free(s, pair.p) || !is_free(s, pair.q);
        }))
      continue;
    Frame frame{rotated->front().q, rotation(s, y.phase, *rotated)};
    if (holds(s, frame.to)) return frame;
  }
  return std::nullopt;
}

} // namespace kov
