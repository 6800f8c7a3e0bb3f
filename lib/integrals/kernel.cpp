#include "integrals/kernel.hpp"

#include "exact/flint.hpp"
#include "exact/lists.hpp"
#include "exact/meter.hpp"
#include "exact/nmod_matrix.hpp"
#include "exact/share.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <tuple>

namespace kov {
namespace {

// The integer or polynomial common divisor of a row that vanishes nowhere is taken out.
void make_primitive(const Set& where, SparseRow& row) {
  MPoly common(where.ring());
  for (const auto& [j, c] : row) {
    common = gcd(common, c);
    if (is_one(common)) return;
  }
  const auto [content, factors] = factor(common);
  MPoly unit(where.ring(), content);
  for (const MFactor& f : factors)
    if (where.is_nonzero(f.base)) unit *= pow(f.base, static_cast<unsigned long>(f.exponent));
  if (is_one(unit)) return;
  for (auto& [j, c] : row)
    c = exact_div(c, unit);
}

} // namespace

SparseRow without_denominators(const Ring& ring, const std::map<std::size_t, MFraction>& vector) {
  MPoly den(ring, Integer(1));
  for (const auto& [j, f] : vector)
    den = exact_div(den * f.den(), gcd(den, f.den()));
  SparseRow row;
  for (const auto& [j, f] : vector)
    row.emplace(j, f.num() * exact_div(den, f.den()));
  return row;
}

SparseRow restricted(const Set& where, const SparseRow& row) {
  std::map<std::size_t, MFraction> values;
  for (const auto& [j, c] : row)
    if (MFraction f = where.restrict(c); !is_zero(f)) values.emplace(j, std::move(f));
  SparseRow result = without_denominators(where.ring(), values);
  if (!result.empty()) make_primitive(where, result);
  return result;
}

namespace {

void restrict_rows(const Set& where, std::vector<SparseRow>& rows) {
  for (SparseRow& row : rows)
    row = restricted(where, row);
  std::erase_if(rows, [](const SparseRow& row) { return row.empty(); });
}

struct Place {
  std::size_t row, column;
};

// The shortest row with a constant, else the shortest with an entry that vanishes nowhere.
std::optional<Place> best_pivot(const Set& where, const std::vector<SparseRow>& rows) {
  std::optional<Place> best;
  std::tuple<int, std::size_t, long> cost{2, 0, 0};
  double visited = 0;
  for (const bool constants : {true, false}) {
    const int kind = constants ? 0 : 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (std::tuple{kind, rows[i].size(), 1L} >= cost) continue; // no entry of it is better
      visited += static_cast<double>(rows[i].size());
      for (const auto& [j, c] : rows[i]) {
        const std::tuple<int, std::size_t, long> here{kind, rows[i].size(), c.length()};
        if (here >= cost || is_constant(c) != constants) continue;
        if (!constants && !where.is_nonzero(c)) continue;
        cost = here;
        best = Place{i, j};
      }
    }
    if (best) break;
  }
  charge(visited);
  return best;
}

// row := (pivot row)[column] row - row[column] (pivot row), without common factors.
void reduce_row(const Set& where, SparseRow& row, const SparseRow& pivot, std::size_t column) {
  const MPoly& p = pivot.at(column);
  const MPoly g = gcd(p, row.at(column));
  const MPoly a = exact_div(p, g);
  const MPoly b = exact_div(row.at(column), g);
  if (!is_one(a))
    for (auto& [j, c] : row)
      c *= a;
  for (const auto& [j, c] : pivot) {
    MPoly& entry = row.try_emplace(j, where.ring()).first->second;
    entry -= b * c;
    if (is_zero(entry)) row.erase(j);
  }
  row = restricted(where, row);
}

void take_pivot(const Set& where, EchelonForm& e, Place at) {
  EchelonForm::Pivot pivot{at.column, std::move(e.rows[at.row])};
  e.rows.erase(e.rows.begin() + static_cast<long>(at.row));
  for (SparseRow& row : e.rows)
    if (row.contains(at.column)) reduce_row(where, row, pivot.row, at.column);
  std::erase_if(e.rows, [](const SparseRow& row) { return row.empty(); });
  e.pivots.push_back(std::move(pivot));
}

void take_pivots(const Set& where, EchelonForm& e, const Budget& budget) {
  while (const auto at = best_pivot(where, e.rows)) {
    budget.check();
    take_pivot(where, e, *at);
  }
}

// An irreducible polynomial that decides whether some entry is a pivot: of the shortest row, the
// simplest.  Requires rows, and no entry that vanishes nowhere.
MPoly splitting_factor(const Set& where, const std::vector<SparseRow>& rows) {
  const MPoly* best = nullptr;
  std::pair<std::size_t, long> cost;
  for (const SparseRow& row : rows)
    for (const auto& [j, c] : row)
      if (const std::pair here{row.size(), c.length()}; best == nullptr || here < cost) {
        best = &c;
        cost = here;
      }
  return where.doubtful_factors(*best).front();
}

constexpr double most_dense_work = 2e9; // products, of a matrix of numbers

double products(const EchelonForm& e) {
  const auto columns = static_cast<double>(e.columns);
  return static_cast<double>(e.rows.size()) * columns * columns;
}
bool is_small(const EchelonForm& e) { return products(e) <= most_dense_work; }

// The work of an elimination modulo a prime, in units of the meter.
double elimination_work(const EchelonForm& e) { return products(e) / 32; }

bool is_numerical(const EchelonForm& e) {
  return std::ranges::all_of(e.rows, [](const SparseRow& row) {
    return std::ranges::all_of(row, [](const auto& entry) { return is_constant(entry.second); });
  });
}

/// Columns that rows link.  A grading that the system respects leaves many blocks.
struct Block {
  std::vector<std::size_t> columns;
  EchelonForm form; ///< of these alone

  [[nodiscard]] SparseRow row_of_the_whole(const SparseRow& row) const {
    SparseRow whole;
    for (const auto& [j, c] : row)
      whole.emplace(columns[j], c);
    return whole;
  }
};

std::vector<Block> blocks_of(const EchelonForm& e) {
  std::vector<std::size_t> linked(e.columns);
  std::iota(linked.begin(), linked.end(), 0);
  const auto first = [&](std::size_t j) {
    while (linked[j] != j)
      j = linked[j] = linked[linked[j]];
    return j;
  };
  for (const SparseRow& row : e.rows)
    for (const auto& [j, c] : row) {
      const std::size_t one = first(j), other = first(row.begin()->first);
      linked[std::max(one, other)] = std::min(one, other);
    }
  std::vector<Block> blocks;
  std::map<std::size_t, std::size_t> known; // by first columns
  std::vector<std::size_t> place(e.columns);
  for (std::size_t j = 0; j < e.columns; ++j) {
    const auto [at, is_new] = known.try_emplace(first(j), blocks.size());
    if (is_new) blocks.emplace_back();
    Block& block = blocks[at->second];
    place[j] = block.columns.size();
    block.columns.push_back(j);
    block.form.columns = block.columns.size();
  }
  for (const SparseRow& row : e.rows) {
    if (row.empty()) continue;
    SparseRow& here = blocks[known.at(first(row.begin()->first))].form.rows.emplace_back();
    for (const auto& [j, c] : row)
      here.emplace(place[j], c);
  }
  return blocks;
}

// Rows that are independent modulo a prime, hence over Q; almost always as many as can be.
std::vector<std::size_t> independent_rows(const EchelonForm& e) {
  const mp_limb_t p = 2305843009213693951UL; // 2^61 - 1
  NmodMatrix transposed(e.columns, e.rows.size(), p);
  for (std::size_t i = 0; i < e.rows.size(); ++i)
    for (const auto& [j, c] : e.rows[i])
      transposed(j, i) = fmpz_fdiv_ui(c.coefficient(0).raw(), p);
  charge(elimination_work(e));
  return transposed.row_reduce();
}

/// Reduced echelon form of independent rows.
class NumericalForm {
public:
  NumericalForm(const EchelonForm& e, const std::vector<std::size_t>& rows) : e_(e) {
    fmpz_mat_init(m_, static_cast<slong>(rows.size()), static_cast<slong>(e.columns));
    fmpz_init(den_);
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const auto& [j, c] : e.rows[rows[i]])
        fmpz_set(entry(i, j), c.coefficient(0).raw());
    charge(4 * elimination_work(e)); // several primes
    fmpz_mat_rref(m_, den_, m_);
    std::size_t column = 0;
    for (std::size_t i = 0; i < rows.size(); ++i, ++column) {
      while (fmpz_is_zero(entry(i, column)))
        free_.push_back(column++);
      pivots_.push_back(column);
    }
    for (; column < e.columns; ++column)
      free_.push_back(column);
  }
  NumericalForm(const NumericalForm&) = delete;
  NumericalForm& operator=(const NumericalForm&) = delete;
  ~NumericalForm() {
    fmpz_mat_clear(m_);
    fmpz_clear(den_);
  }

  // The row is a combination of those that were reduced.
  [[nodiscard]] bool spans(const SparseRow& row) const {
    std::vector<Integer> dense(e_.columns);
    for (const auto& [j, c] : row)
      dense[j] = c.coefficient(0);
    for (const std::size_t j : free_) {
      Integer sum = -(dense[j] * denominator());
      for (std::size_t i = 0; i < pivots_.size(); ++i)
        if (!is_zero(dense[pivots_[i]]) && !fmpz_is_zero(entry(i, j)))
          fmpz_addmul(sum.raw(), dense[pivots_[i]].raw(), entry(i, j));
      if (!is_zero(sum)) return false;
    }
    return true;
  }
  [[nodiscard]] EchelonForm result(const Set& where) const {
    EchelonForm done;
    done.columns = e_.columns;
    for (std::size_t i = 0; i < pivots_.size(); ++i) {
      SparseRow row{{pivots_[i], MPoly(where.ring(), denominator())}};
      for (const std::size_t j : free_)
        if (!fmpz_is_zero(entry(i, j))) row.emplace(j, MPoly(where.ring(), Integer(entry(i, j))));
      done.pivots.push_back({pivots_[i], restricted(where, row)});
    }
    return done;
  }

private:
  [[nodiscard]] fmpz* entry(std::size_t i, std::size_t j) const {
    return fmpz_mat_entry(m_, static_cast<slong>(i), static_cast<slong>(j));
  }
  [[nodiscard]] Integer denominator() const { return Integer(den_); }

  const EchelonForm& e_;
  fmpz_mat_t m_;
  fmpz_t den_;
  std::vector<std::size_t> pivots_, free_;
};

// The result of elimination; unset: a parameter occurs, or the prime was a bad one.
std::optional<EchelonForm> eliminated(const Set& where, const EchelonForm& e) {
  if (e.rows.empty() || !is_small(e) || !is_numerical(e)) return std::nullopt;
  const auto rows = independent_rows(e);
  if (rows.size() == e.columns) {
    EchelonForm full{e.columns, {}};
    for (std::size_t j = 0; j < e.columns; ++j)
      full.pivots.push_back({j, {{j, MPoly(where.ring(), Integer(1))}}});
    return full;
  }
  const NumericalForm form(e, rows);
  if (!std::ranges::all_of(e.rows, [&](const SparseRow& row) { return form.spans(row); }))
    return std::nullopt;
  return form.result(where);
}

// Takes the pivots of the blocks in which no parameter occurs.
void eliminate_numbers(const Set& where, EchelonForm& e) {
  std::vector<SparseRow> left;
  for (const Block& block : blocks_of(e)) {
    const auto done = eliminated(where, block.form);
    if (!done)
      for (const SparseRow& row : block.form.rows)
        left.push_back(block.row_of_the_whole(row));
    else
      for (const auto& pivot : done->pivots)
        e.pivots.push_back({block.columns[pivot.column], block.row_of_the_whole(pivot.row)});
  }
  e.rows = std::move(left);
}

// The steps of both: until no rows are left, divide by a factor and do `at_zero` where it is 0; then the
// leaf.  Nothing is left of `where` after this if its last part is empty.
template <class AtZero, class Leaf>
void divide_by_factors(Set& where, EchelonForm& e, const AtZero& at_zero, const Leaf& leaf,
                       const Budget& budget) {
  restrict_rows(where, e.rows);
  eliminate_numbers(where, e);
  for (;;) {
    take_pivots(where, e, budget);
    if (e.rows.empty()) return leaf(where, e);
    const MPoly f = splitting_factor(where, e.rows);
    const Set zero = where.where_zero(f);
    where = where.where_nonzero(f);
    if (!zero.is_empty()) at_zero(zero, e);
    if (where.is_empty()) return;
    restrict_rows(where, e.rows);
  }
}

} // namespace

void for_each_kernel(Set where, EchelonForm e, const KernelLeaf& leaf, const Budget& budget) {
  divide_by_factors(
      where, e,
      [&](const Set& zero, const EchelonForm& rest) { for_each_kernel(zero, rest, leaf, budget); },
      leaf, budget);
}

void share_among_kernels(Set where, EchelonForm e, const KernelParts& parts, const Budget& budget) {
  try {
    divide_by_factors(
        where, e,
        [&](const Set& zero, const EchelonForm& rest) {
          share_among_kernels(zero, rest, parts, part_of_the_work(budget, 0.5));
        },
        [&](const Set& set, const EchelonForm& done) { parts.leaf(set, done, budget); }, budget);
  } catch (const OutOfBudget& limit) {
    parts.open(where, limit);
  }
}

std::vector<std::map<std::size_t, MFraction>> kernel_basis(const Set& where, const EchelonForm& e) {
  std::set<std::size_t> bound;
  for (const auto& pivot : e.pivots)
    bound.insert(pivot.column);
  std::vector<std::map<std::size_t, MFraction>> basis;
  for (std::size_t free = 0; free < e.columns; ++free) {
    if (bound.contains(free)) continue;
    std::map<std::size_t, MFraction> v{{free, MFraction(where.ring(), Rational(1))}};
    for (auto pivot = e.pivots.rbegin(); pivot != e.pivots.rend(); ++pivot) {
      MFraction sum(where.ring());
      for (const auto& [j, c] : pivot->row)
        if (const auto x = v.find(j); x != v.end()) sum += MFraction(c) * x->second;
      if (is_zero(sum)) continue;
      const MFraction num = where.restrict(sum.num());
      if (is_zero(num)) continue;
      v[pivot->column] = -(num / MFraction(sum.den())) / MFraction(pivot->row.at(pivot->column));
    }
    basis.push_back(std::move(v));
  }
  return basis;
}

std::vector<std::size_t> gauge_columns(const Set& where, EchelonForm e, const Budget& budget) {
  restrict_rows(where, e.rows);
  take_pivots(where, e, budget);
  return mapped<std::size_t>(e.pivots, [&](const auto& pivot) { return pivot.column; });
}

namespace {

// Sums of the rows with random factors, a few more than columns: where their rank is full, that of the rows is.
// Each row is part of two of them; a few rows are taken as they are.
void add_sums(NmodMatrix& sums, const EchelonForm& e) {
  std::mt19937_64 generator(20261126);
  const nmod_t mod = sums.mod();
  const bool are_few = sums.rows() == e.rows.size();
  for (std::size_t k = 0; k < e.rows.size(); ++k)
    for (int part = 0; part < (are_few ? 1 : 2); ++part) {
      const std::size_t i = are_few ? k : generator() % sums.rows();
      const ulong factor = are_few ? 1 : generator() % mod.n;
      for (const auto& [j, c] : e.rows[k]) {
        const ulong x = fmpz_fdiv_ui(c.coefficient(0).raw(), mod.n);
        ulong& entry = sums(i, j);
        entry = nmod_add(entry, nmod_mul(factor, x, mod), mod);
      }
    }
}

bool are_independent(const EchelonForm& e) {
  const std::size_t n = e.columns;
  if (e.rows.size() < n || e.rows.size() * n > 20'000'000 || !is_numerical(e)) return false;
  const std::size_t height = e.rows.size() <= 3 * n + 16 ? e.rows.size() : n + 16;
  NmodMatrix sums(height, n, 2147483629UL);
  add_sums(sums, e);
  charge(static_cast<double>(height) * static_cast<double>(n) * static_cast<double>(n) / 32);
  return sums.has_independent_columns();
}

} // namespace

bool independent_modulo_a_prime(const EchelonForm& e) {
  const auto blocks = blocks_of(e);
  return std::ranges::all_of(blocks, [](const Block& b) { return are_independent(b.form); });
}

} // namespace kov
