#include "parameters/integers.hpp"

#include "exact/error.hpp"
#include "exact/flint.hpp"

#include <flint/fmpz_lll.h>

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
    const bool zero = std::ranges::all_of(left, [](const Integer& x) { return is_zero(x); });
    (zero ? h.relations : h.transform).push_back(transform.row(i));
    if (!zero) h.form.push_back(left);
  }
  return h;
}

Integer size(const Integer& x) { return sign(x) < 0 ? -x : x; }

// A basis of short vectors of the lattice that the rows span; they are independent.
Rows short_basis(const Rows& rows) {
  if (rows.empty()) return rows;
  Matrix matrix(rows);
  fmpz_lll_t context;
  fmpz_lll_context_init_default(context);
  fmpz_lll(matrix.raw(), nullptr, context);
  Rows short_ones;
  for (std::size_t i = 0; i < rows.size(); ++i)
    short_ones.push_back(matrix.row(i));
  return short_ones;
}

// n modulo the lattice of the relations, and short: with a last coordinate that is large for n and
// 0 for the relations, n is the vector of a short basis that has it.
Row shortened(const Row& n, Rows relations) {
  Integer large(1);
  for (const Row& row : relations)
    for (const Integer& x : row)
      large = large + size(x);
  for (const Integer& x : n)
    large = large + size(x);
  large = large * pow(Integer(2), n.size());
  for (Row& row : relations)
    row.push_back(Integer(0));
  relations.push_back(n);
  relations.back().push_back(large);
  for (Row& row : short_basis(relations)) {
    const Integer last = row.back();
    if (!(size(last) == large)) continue;
    row.pop_back();
    for (Integer& x : row)
      x = Integer(sign(last)) * x;
    return row;
  }
  return n;
}

// A polynomial and a number such that both times each of the functions is in Z[t].  A constant that
// is a combination of the functions with integers is in Z/of_constants(), by Gauss' lemma.
struct Denominator {
  MPoly polynomial;
  Integer number;

  [[nodiscard]] Integer of_constants() const {
    Integer content(0);
    for (long i = 0; i < polynomial.length(); ++i)
      content = gcd(content, polynomial.coefficient(i));
    return number * content;
  }
};
Denominator common_denominator(const std::vector<MFraction>& functions) {
  Ring ring;
  for (const MFraction& f : functions)
    if (f.ring()) ring = f.ring();
  Denominator d{MPoly(ring, Integer(1)), Integer(1)};
  for (const MFraction& f : functions)
    if (!is_zero(f)) d.polynomial = d.polynomial * exact_div(f.den(), gcd(d.polynomial, f.den()));
  for (const MFraction& f : functions) // gcd() may drop integers
    if (!is_zero(f)) d.number = lcm(d.number, (f * MFraction(d.polynomial)).den().coefficient(0));
  return d;
}

// The functions as rows of integers, up to one common factor.
Rows coordinates(const std::vector<MFraction>& functions) {
  const auto [den, number] = common_denominator(functions);
  std::map<std::vector<unsigned long>, std::size_t> columns;
  std::vector<MPoly> polynomials;
  for (const MFraction& f : functions) {
    const MFraction g = MFraction(den) * MFraction(MPoly(den.ring(), number));
    polynomials.push_back(is_zero(f) ? MPoly(den.ring()) : (f * g).num());
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

// Integers n with n A = c, for the rows of A; unset: there are none.
std::optional<Row> integer_solution(const Rows& a, Row c) {
  const Hermite h = hermite(a);
  Row n(a.size(), Integer(0));
  for (std::size_t i = 0; i < h.form.size(); ++i) { // c as a combination of the rows of the form
    const Row& row = h.form[i];
    const auto pivot = static_cast<std::size_t>(
        std::ranges::find_if(row, [](const Integer& x) { return !is_zero(x); }) - row.begin());
    const Rational y(c[pivot], row[pivot]);
    if (!is_integer(y)) return std::nullopt;
    for (std::size_t j = 0; j < row.size(); ++j)
      c[j] = c[j] - y.num() * row[j];
    for (std::size_t j = 0; j < n.size(); ++j)
      n[j] = n[j] + y.num() * h.transform[i][j];
  }
  if (!std::ranges::all_of(c, [](const Integer& x) { return is_zero(x); })) return std::nullopt;
  return n;
}

// Integers n with n1 f1 + n2 f2 + ... - g an integer.
std::optional<Row> combination(std::vector<MFraction> f, const MFraction& g) {
  const std::size_t n = f.size();
  f.emplace_back(g.ring(), Rational(1));
  f.push_back(g);
  Rows rows = coordinates(f);
  const Row last = std::move(rows.back());
  rows.pop_back();
  auto found = integer_solution(rows, last);
  if (!found) return found;
  found->resize(n);
  Rows relations = hermite(rows).relations;
  for (Row& relation : relations)
    relation.resize(n);
  return shortened(*found, std::move(relations));
}

// Integers n with n1 f1 + n2 f2 + ... a constant that is not an integer.
std::optional<Row> fractional_constant(std::vector<MFraction> f, const Ring& ring) {
  const Integer N = common_denominator(f).of_constants();
  f.emplace_back(ring, Rational(Integer(1), N));
  for (Row& relation : short_basis(hermite(coordinates(f)).relations))
    if (!is_integer(Rational(relation.back(), N))) {
      relation.pop_back();
      return relation;
    }
  return std::nullopt;
}

// The known facts about integers, by their places in the list of memberships.
struct Known {
  std::vector<std::size_t> in, out;
  std::vector<MFraction> integers;

  explicit Known(const std::vector<Membership>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      (all[i].in_integers ? in : out).push_back(i);
      if (all[i].in_integers) integers.push_back(all[i].value);
    }
  }
  // Multiples of the integers, as multiples of all memberships
  [[nodiscard]] Row spread(const Row& n, std::size_t size) const {
    Row all(size, Integer(0));
    for (std::size_t i = 0; i < in.size(); ++i)
      all[in[i]] = n[i];
    return all;
  }
};

} // namespace

std::optional<Rational> violated(const Membership& m, const MFraction& v) {
  if (!is_constant(v)) return std::nullopt;
  const Rational c = to_rational(v);
  return is_integer(c) == m.in_integers ? std::nullopt : std::optional(c);
}

std::optional<IntegerProof> integer_proof(const std::vector<Membership>& all, const MFraction& v) {
  if (all.empty() || is_zero(v)) return std::nullopt;
  const Known known(all);
  if (const auto n = combination(known.integers, v))
    return IntegerProof{true, Integer(1), known.spread(*n, all.size()), {}};
  std::vector<MFraction> with_v = known.integers;
  with_v.push_back(v);
  const auto refuted = [&](const Row& n, std::optional<std::size_t> none) {
    return IntegerProof{false, n.back(), known.spread(n, all.size()), none};
  };
  if (const auto n = fractional_constant(with_v, v.ring()); n && !is_zero(n->back()))
    return refuted(*n, std::nullopt);
  for (const std::size_t i : known.out) // what would be an integer if v were one
    if (!is_zero(all[i].value))
      if (const auto n = combination(with_v, all[i].value); n && !is_zero(n->back()))
        return refuted(*n, i);
  return std::nullopt;
}

Truth is_integral(const std::vector<Membership>& known, const MFraction& v) {
  if (is_zero(v)) return Truth::yes;
  if (is_constant(v)) return truth(is_integer(to_rational(v)));
  const auto proof = integer_proof(known, v);
  return proof ? truth(proof->integral) : Truth::unknown;
}

bool contradict(const std::vector<Membership>& all) {
  const Known known(all);
  if (!known.integers.empty() && fractional_constant(known.integers, all[0].value.ring()))
    return true;
  return std::ranges::any_of(known.out, [&](std::size_t i) {
    return is_zero(all[i].value) || combination(known.integers, all[i].value);
  });
}

} // namespace kov
