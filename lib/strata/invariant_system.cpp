#include "strata/invariant_system.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/flint.hpp"
#include "exact/lists.hpp"
#include "exact/work.hpp"

#include <algorithm>

namespace kov::strata {
namespace {

// A minor with more terms than that is not worth a stratum of its own.
constexpr long most_terms = 30;

using Matrix = std::vector<std::vector<MPoly>>; // rows: powers of z; columns: coefficients of P

class LinearConditions {
public:
  LinearConditions(const Scheme& s, const InvariantForm& form, const Budget& budget)
      : z_(s.z), m_(form.m), budget_(budget), s_(one(s)), theta_(s.r.ring()) {
    for (const auto& p : s.finite)
      s_ *= pow(p.q, static_cast<unsigned long>((p.order + 1) / 2));
    for (std::size_t i = 0; i < s.finite.size(); ++i)
      if (form.e[i] != 0)
        theta_ += MPoly(s.r.ring(), Integer(form.e[i])) * derivative(s.finite[i].q, z_) *
                  exact_div(s_, s.finite[i].q);
    const MFraction potential = s.r * MFraction(s_ * s_);
    potential_ = potential.num();
    content_ = potential.den(); // free of z: S^2 r is a polynomial in z
    KOV_ENSURE(!uses(content_, z_));
    ds_ = derivative(s_, z_);
  }

  /// T_(m+1) for P = z^j, times a power of content_.
  [[nodiscard]] MPoly last(long j) const {
    MPoly before(s_.ring());
    MPoly now = pow(MPoly::variable(s_.ring(), z_), static_cast<unsigned long>(j));
    for (long i = 0; i <= m_; ++i) {
      budget_.check();
      const MPoly i_poly(s_.ring(), Integer(i));
      MPoly next = content_ * (s_ * derivative(now, z_) + (theta_ - i_poly * ds_) * now);
      next -= MPoly(s_.ring(), Integer(i * (m_ - i + 1))) * potential_ * before;
      // T_(i-1) enters with one factor content_ more than T_i
      before = content_ * now;
      now = std::move(next);
    }
    return now;
  }

private:
  static MPoly one(const Scheme& s) { return {s.r.ring(), Integer(1)}; }

  std::size_t z_;
  long m_;
  const Budget& budget_;
  MPoly s_, theta_, potential_, content_, ds_;
};

Matrix matrix(const Scheme& s, const InvariantForm& form, const Budget& budget) {
  const LinearConditions conditions(s, form, budget);
  Matrix rows;
  const auto columns = static_cast<std::size_t>(form.degree + 1);
  for (std::size_t j = 0; j < columns; ++j) {
    const auto c = coefficients(conditions.last(static_cast<long>(j)), s.z);
    while (rows.size() < c.size())
      rows.emplace_back(columns, MPoly(s.r.ring()));
    for (std::size_t i = 0; i < c.size(); ++i)
      rows[i][j] = c[i];
  }
  return rows;
}

// L_0 = v, L_1 = v', L_(i+1) = L_i' - i (m-i+1) r L_(i-1); L_(m+1) v = 0.
bool solves(const Scheme& s, const ParametricInvariant& found) {
  MFraction before(s.r.ring());
  MFraction now(found.p);
  for (std::size_t i = 0; i < s.finite.size(); ++i)
    now *= pow(MFraction(s.finite[i].q), found.form.e[i]);
  const long m = found.form.m;
  for (long i = 0; i <= m; ++i) {
    MFraction next = derivative(now, s.z) - Rational(i * (m - i + 1)) * s.r * before;
    before = std::move(now);
    now = std::move(next);
  }
  return is_zero(now);
}

// The columns are independent at one point, so that they are over Q(parameters): no elimination
// among functions is needed.  false: not seen.
bool independent_at_a_point(const Matrix& rows, std::size_t columns) {
  if (rows.size() < columns) return false;
  const Ring& ring = rows.front().front().ring();
  Substitution point;
  long value = 1009;
  for (std::size_t i = 0; i < ring->size(); ++i, value += 4 * value % 97 + 30)
    point[i] = MFraction(ring, Rational(value));
  fmpz_mat_t m;
  fmpz_mat_init(m, static_cast<slong>(rows.size()), static_cast<slong>(columns));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < columns; ++j)
      if (!is_zero(rows[i][j]))
        if (const MFraction v = substitute(rows[i][j], point); !is_zero(v))
          fmpz_set(fmpz_mat_entry(m, static_cast<slong>(i), static_cast<slong>(j)),
                   to_rational(v).num().raw());
  const slong rank = fmpz_mat_rank(m);
  fmpz_mat_clear(m);
  return rank == static_cast<slong>(columns);
}

bool simpler(const MPoly& a, const MPoly& b) {
  return a.length() != b.length() ? a.length() < b.length() : compare(a, b) < 0;
}

} // namespace

std::variant<std::optional<ParametricInvariant>, Needs>
find_invariant(const Scheme& s, const InvariantForm& form, const ParametrisedSet& region,
               const Budget& budget) {
  const Matrix conditions = matrix(s, form, budget);
  const auto columns = static_cast<std::size_t>(form.degree + 1);
  if (independent_at_a_point(conditions, columns)) return std::nullopt;
  std::vector<std::vector<MFraction>> rows;
  for (const auto& row : conditions)
    if (std::ranges::any_of(row, [](const MPoly& f) { return !is_zero(f); }))
      rows.emplace_back(row.begin(), row.end());
  MFraction p(s.r.ring(), Rational(1)); // no conditions: every P will do
  if (!rows.empty()) {
    const auto kernel = null_space(std::move(rows), columns, s.r.ring(), budget);
    if (kernel.empty()) return std::nullopt;
    p = MFraction(s.r.ring());
    for (std::size_t j = kernel[0].size(); j-- > 0;)
      p = p * MFraction::variable(s.r.ring(), s.z) + kernel[0][j];
  }
  KOV_ENSURE(!is_zero(p));
  MPoly primitive = p.num(); // its coefficients may still have a common factor
  MPoly content(s.r.ring());
  for (const auto& c : coefficients(primitive, s.z))
    content = gcd(content, c);
  ParametricInvariant found{form, exact_div(primitive, content)};
  KOV_ENSURE(solves(s, found));
  std::optional<MPoly> doubt;
  for (const auto& c : coefficients(found.p, s.z)) {
    if (is_zero(c)) continue;
    const auto d = region.doubtful_factor(c);
    if (!d) return found;
    if (!doubt || simpler(*d, *doubt)) doubt = d;
  }
  return Needs{*doubt, {Event::Kind::invariant_vanishes}};
}

namespace {

// A maximal minor, by Bareiss's elimination with the rows taken in the given order of preference.
MaximalMinor maximal_minor(const Matrix& rows, const std::vector<std::size_t>& preference,
                           const Budget& budget) {
  const std::size_t columns = rows.front().size();
  Matrix sorted;
  for (const std::size_t i : preference)
    sorted.push_back(rows[i]);
  std::vector<std::size_t> order(preference);
  const Ring ring = sorted.front().front().ring();
  MPoly previous(ring, Integer(1));
  Work work(budget, "a minor of the conditions for an invariant");
  for (std::size_t k = 0; k < columns; ++k) {
    std::size_t pivot = k;
    while (pivot < sorted.size() && is_zero(sorted[pivot][k]))
      ++pivot;
    KOV_ENSURE(pivot < sorted.size()); // full rank over Q(parameters)
    const auto to_front = [&](auto& all) {
      const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
      std::rotate(at(k), at(pivot), at(pivot) + 1);
    };
    to_front(sorted);
    to_front(order);
    const MPoly p = sorted[k][k];
    for (std::size_t i = k + 1; i < sorted.size(); ++i) {
      for (std::size_t j = columns; j-- > k;) {
        work.add(size_of(p) * size_of(sorted[i][j]) +
                 size_of(sorted[i][k]) * size_of(sorted[k][j]));
        sorted[i][j] = exact_div(p * sorted[i][j] - sorted[i][k] * sorted[k][j], previous);
      }
    }
    previous = p;
  }
  order.resize(columns);
  return {{order.begin(), order.end()}, previous};
}

// Several orders of the rows: simplest first, from the top, from the bottom, from the middle.
std::vector<std::vector<std::size_t>> preferences(const Matrix& rows) {
  std::vector<std::size_t> up;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (std::ranges::any_of(rows[i], [](const MPoly& f) { return !is_zero(f); })) up.push_back(i);
  auto simple = up;
  const auto weight = [&](std::size_t i) {
    long sum = 0;
    for (const auto& f : rows[i])
      sum += is_zero(f) ? 0 : f.length();
    return sum;
  };
  std::ranges::stable_sort(simple,
                           [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
  const std::vector<std::size_t> down(up.rbegin(), up.rend());
  auto middle = up;
  std::rotate(middle.begin(), middle.begin() + static_cast<std::ptrdiff_t>(middle.size() / 2),
              middle.end());
  return {std::move(simple), down, std::move(up), std::move(middle)};
}

bool one_parameter(const Matrix& rows) {
  std::vector<std::size_t> seen;
  for (const auto& row : rows)
    for (const auto& f : row)
      for (const std::size_t i : used_variables(f))
        add_once(seen, i);
  return seen.size() <= 1;
}

std::optional<MPoly> simplest_doubt(const MPoly& p, const ParametrisedSet& region) {
  std::optional<MPoly> doubt;
  if (is_constant(p)) return doubt;
  for (const auto& f : irreducible_parts(p))
    if (!region.provably_nonzero(f) && (!doubt || simpler(f, *doubt))) doubt = f;
  return doubt;
}

} // namespace

// Sym^m has a solution at a point exactly where all maximal minors vanish.  A minor without
// doubtful factors settles it; so does, with one parameter, a gcd of several minors without them,
// because what is left of the minors has no common root.
std::variant<Excluded, Needs, Unsettled> exclude_invariant(const Scheme& s,
                                                           const InvariantForm& form,
                                                           const ParametrisedSet& region,
                                                           const Budget& budget) {
  const Matrix rows = matrix(s, form, budget);
  const bool univariate = one_parameter(rows);
  const Event why{.kind = Event::Kind::invariant_appears, .m = form.m};
  MPoly common(s.r.ring());
  Excluded proof;
  std::vector<MPoly> doubts; // the simplest one of each minor
  for (const auto& preference : preferences(rows)) {
    const MaximalMinor minor = maximal_minor(rows, preference, budget);
    const auto doubt = simplest_doubt(minor.value, region);
    if (!doubt) return Excluded{{minor}};
    doubts.push_back(*doubt);
    common = gcd(common, minor.value);
    proof.minors.push_back(minor);
    if (univariate && !simplest_doubt(common, region)) return proof;
  }
  if (const auto doubt = simplest_doubt(common, region)) return Needs{*doubt, why};
  std::ranges::sort(doubts, simpler);
  if (doubts.front().length() <= most_terms) return Needs{doubts.front(), why};
  return Unsettled{std::move(doubts)};
}

} // namespace kov::strata
