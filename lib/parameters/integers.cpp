#include "parameters/integers.hpp"

#include "exact/error.hpp"
#include "exact/flint.hpp"

#include <algorithm>
#include <map>

namespace kov {
namespace {

using Row = std::vector<Integer>;
using Rows = std::vector<Row>;

class Matrix {
public:
  Matrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(v_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  explicit Matrix(const Rows& rows) : Matrix(rows.size(), rows.empty() ? 0 : rows[0].size()) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < rows[i].size(); ++j)
        fmpz_set(at(i, j), rows[i][j].raw());
  }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { fmpz_mat_clear(v_); }

  [[nodiscard]] fmpz_mat_struct* raw() { return v_; }
  [[nodiscard]] fmpz* at(std::size_t i, std::size_t j) {
    return fmpz_mat_entry(v_, static_cast<slong>(i), static_cast<slong>(j));
  }
  [[nodiscard]] Row row(std::size_t i) {
    Row r(static_cast<std::size_t>(fmpz_mat_ncols(v_)));
    for (std::size_t j = 0; j < r.size(); ++j)
      fmpz_set(r[j].raw(), at(i, j));
    return r;
  }

private:
  fmpz_mat_t v_;
};

// U A = H in Hermite normal form; the rows of U beside zero rows of H are a basis of the relations
// u A = 0 with u in Z^n.
struct Hermite {
  Rows form, relations, transform;
};
Hermite hermite(const Rows& a) {
  const std::size_t n = a.size();
  Matrix matrix(a), form(n, n == 0 ? 0 : a[0].size()), transform(n, n);
  fmpz_mat_hnf_transform(form.raw(), transform.raw(), matrix.raw());
  Hermite h;
  for (std::size_t i = 0; i < n; ++i) {
    const Row left = form.row(i);
    const bool zero =
        std::all_of(left.begin(), left.end(), [](const Integer& x) { return is_zero(x); });
    (zero ? h.relations : h.transform).push_back(transform.row(i));
    if (!zero) h.form.push_back(left);
  }
  return h;
}

// The functions as rows of integers, up to one common factor.
Rows coordinates(const std::vector<MFraction>& functions) {
  Ring ring;
  for (const MFraction& f : functions)
    if (f.ring()) ring = f.ring();
  MPoly den(ring, Integer(1));
  for (const MFraction& f : functions)
    if (!is_zero(f)) den = den * exact_div(f.den(), gcd(den, f.den()));
  Integer content(1); // gcd() may drop integers
  for (const MFraction& f : functions)
    if (!is_zero(f)) content = lcm(content, (f * MFraction(den)).den().coefficient(0));
  std::map<std::vector<unsigned long>, std::size_t> columns;
  std::vector<MPoly> polynomials;
  for (const MFraction& f : functions) {
    const MFraction g = MFraction(den) * MFraction(MPoly(ring, content));
    polynomials.push_back(is_zero(f) ? MPoly(ring) : (f * g).num());
    for (long i = 0; i < polynomials.back().length(); ++i)
      columns.try_emplace(polynomials.back().exponents(i), columns.size());
  }
  Rows rows;
  for (const MPoly& p : polynomials) {
    Row row(columns.size(), Integer(0));
    for (long i = 0; i < p.length(); ++i)
      row[columns.at(p.exponents(i))] = p.coefficient(i);
    rows.push_back(std::move(row));
  }
  return rows;
}

// The integers n = n0 + sum of multiples of `steps` with M n = c; unset: none.
struct Coset {
  Row start;
  Rows steps;
};
std::optional<Coset> solutions(const Rows& m, const Row& c, std::size_t n) {
  Coset all{Row(n, Integer(0)), {}};
  Rows transposed(n, Row(m.size(), Integer(0)));
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < n; ++j)
      transposed[j][i] = m[i][j];
  if (m.empty()) { // no column for FLINT
    for (std::size_t j = 0; j < n; ++j) {
      all.steps.emplace_back(n, Integer(0));
      all.steps.back()[j] = Integer(1);
    }
    return all;
  }
  const Hermite h = hermite(transposed);
  Row left = c; // a combination of the rows of the form
  for (std::size_t i = 0; i < h.form.size(); ++i) {
    const Row& row = h.form[i];
    const auto pivot = static_cast<std::size_t>(
        std::find_if(row.begin(), row.end(), [](const Integer& x) { return !is_zero(x); }) -
        row.begin());
    const Rational y(left[pivot], row[pivot]);
    if (!is_integer(y)) return std::nullopt;
    for (std::size_t j = 0; j < row.size(); ++j)
      left[j] = left[j] - y.num() * row[j];
    for (std::size_t j = 0; j < n; ++j)
      all.start[j] = all.start[j] + y.num() * h.transform[i][j];
  }
  if (!std::all_of(left.begin(), left.end(), [](const Integer& x) { return is_zero(x); }))
    return std::nullopt;
  all.steps = h.relations;
  return all;
}

// v1, ..., vk and 1, with what their relations leave of the integers.
class Lattice {
public:
  explicit Lattice(std::vector<MFraction> integral) : v_(std::move(integral)) {
    Ring ring;
    for (const MFraction& f : v_)
      if (f.ring()) ring = f.ring();
    one_ = MFraction(ring, Rational(1));
    std::vector<MFraction> all = v_;
    all.push_back(one_);
    Rows m;
    Row c;
    for (Row& relation : hermite(coordinates(all)).relations) {
      c.push_back(-relation.back());
      relation.pop_back();
      m.push_back(std::move(relation));
    }
    coset_ = solutions(m, c, v_.size());
  }
  [[nodiscard]] bool empty() const { return !coset_; }

  // Of a function in the span.
  [[nodiscard]] Truth is_integral(const MFraction& v) const {
    std::vector<MFraction> all{v};
    all.insert(all.end(), v_.begin(), v_.end());
    all.push_back(one_);
    for (const Row& relation : hermite(coordinates(all)).relations)
      if (!is_zero(relation[0])) return value(relation);
    return Truth::unknown;
  }

private:
  // v = -(mu1 v1 + ... + c)/mu0: a + gZ on the coset.
  [[nodiscard]] Truth value(const Row& relation) const {
    const Rational scale = Rational(-1) / Rational(relation[0]);
    const auto combination = [&](const Row& n) {
      Integer sum(0);
      for (std::size_t i = 0; i < n.size(); ++i)
        sum = sum + relation[i + 1] * n[i];
      return scale * Rational(sum);
    };
    const Rational a = combination(coset_->start) + scale * Rational(relation.back());
    bool integral = is_integer(a);
    Integer den = a.den();
    std::vector<Rational> steps;
    for (const Row& s : coset_->steps) {
      steps.push_back(combination(s));
      integral = integral && is_integer(steps.back());
      den = lcm(den, steps.back().den());
    }
    if (integral) return Truth::yes;
    Integer g = den; // a + sum of steps is an integer: modulo den
    for (const Rational& s : steps)
      g = gcd(g, (Rational(den) * s).num());
    return is_integer(Rational(den) * a / Rational(g)) ? Truth::unknown : Truth::no;
  }

  std::vector<MFraction> v_;
  MFraction one_;
  std::optional<Coset> coset_;
};

std::vector<MFraction> members(const std::vector<Membership>& known) {
  std::vector<MFraction> all;
  for (const Membership& m : known)
    if (m.in_integers && !is_zero(m.value)) all.push_back(m.value);
  return all;
}

bool breaks(const Lattice& lattice, const std::vector<Membership>& known) {
  return lattice.empty() || std::any_of(known.begin(), known.end(), [&](const Membership& m) {
           return !m.in_integers &&
                  (is_zero(m.value) || lattice.is_integral(m.value) == Truth::yes);
         });
}

} // namespace

Truth is_integral(const std::vector<Membership>& known, const MFraction& v) {
  if (is_zero(v)) return Truth::yes;
  if (is_constant(v)) return truth(is_integer(to_rational(v)));
  if (known.empty()) return Truth::unknown;
  std::vector<MFraction> all = members(known);
  if (!all.empty()) {
    const Lattice lattice(all);
    if (lattice.empty()) return Truth::unknown; // no point: whoever asks finds out elsewhere
    if (const Truth t = lattice.is_integral(v); t != Truth::unknown) return t;
  }
  all.push_back(v); // what would follow?
  return breaks(Lattice(all), known) ? Truth::no : Truth::unknown;
}

bool contradict(const std::vector<Membership>& known) {
  const auto all = members(known);
  if (all.empty())
    return std::any_of(known.begin(), known.end(), [](const Membership& m) {
      const bool integral =
          is_zero(m.value) || (is_constant(m.value) && is_integer(to_rational(m.value)));
      return integral && !m.in_integers;
    });
  return breaks(Lattice(all), known);
}

} // namespace kov
