#include "integrability/normal_identity.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <set>

namespace kov {
namespace {

using Element = FunctionField::Element;
using Row = CurveRows::Row;

// Covectors that vanish where the variational equation is restricted: the differentials of the
// integrals that eliminate, and those of the unknowns to which the block leads.
class Annihilators {
public:
  Annihilators(const ManifoldReport& m, const CurveRows& rows) : m_(m), rows_(rows) {
    for (const std::size_t i : m.normal.equations)
      df_.push_back(rows.gradient(m.manifold->equations[i].difference));
  }

  [[nodiscard]] const Row& of_unknown(const std::string& name) const {
    const auto& names = m_.normal.system.names;
    const auto at = std::ranges::find(names, name);
    KOV_ENSURE(at != names.end());
    return df_[static_cast<std::size_t>(at - names.begin())];
  }

  [[nodiscard]] Row of_unknowns(const std::vector<std::pair<std::string, MPoly>>& all) const {
    Row sum(df_.front().size(), rows_.constant(0));
    for (const auto& [name, c] : all)
      add(sum, rows_.value(MFraction(c)), of_unknown(name));
    return sum;
  }

  /// The differentials of the integrals that were used, in their order.
  [[nodiscard]] std::vector<Row> of_integrals() const {
    std::vector<Row> all;
    auto next = m_.normal.integrals.begin();
    for (const Elimination& e : m_.reduced.eliminations) {
      while (next != m_.normal.integrals.end() && next->name != e.integral)
        ++next;
      KOV_ENSURE(next != m_.normal.integrals.end());
      all.push_back(combined(next->coefficients));
      ++next;
    }
    return all;
  }

  /// The rows of the unknowns outside the block on which its equations depend.
  [[nodiscard]] std::vector<Row> of_other_blocks(const std::vector<std::string>& block) const {
    const LinearSystem& r = m_.reduced.system;
    const auto inside = [&](std::size_t i) { return is_among(r.names[i], block); };
    std::vector<bool> reached(r.names.size());
    for (std::size_t round = 0; round < r.names.size(); ++round)
      for (std::size_t i = 0; i < r.names.size(); ++i)
        for (std::size_t j = 0; j < r.names.size(); ++j)
          if ((inside(i) || reached[i]) && !inside(j) && !reached[j] &&
              !m_.manifold->vanishes_on_curve(r.a[i][j]))
            reached[j] = true;
    std::vector<Row> all;
    for (std::size_t j = 0; j < r.names.size(); ++j)
      if (reached[j]) all.push_back(of_unknown(r.names[j]));
    return all;
  }

private:
  [[nodiscard]] Row combined(const std::vector<MFraction>& c) const {
    Row sum(df_.front().size(), rows_.constant(0));
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (is_zero(c[i])) continue;
      add(sum, rows_.value(c[i]), df_[i]);
    }
    return sum;
  }
  void add(Row& sum, const Element& factor, const Row& row) const {
    for (std::size_t k = 0; k < sum.size(); ++k)
      if (!is_zero(row[k])) sum[k] = sum[k] + rows_.times(factor, row[k]);
  }

  const ManifoldReport& m_;
  const CurveRows& rows_;
  std::vector<Row> df_;
};

/// Annihilators and vectors.
class IdentityFinder {
public:
  explicit IdentityFinder(const CurveRows& rows) : rows_(rows) {}

protected:
  // left_i = sum rest_il lambda_l, with the fewest of these annihilators that span a subsystem.
  bool restrict_to(const std::vector<Row>& all, const std::vector<Row>& left) {
    std::vector<Row> rests, matrices;
    std::vector<bool> needed(all.size());
    for (const Row& row : left) {
      auto c = rows_.combination(all, row);
      if (!c) return false;
      for (std::size_t l = 0; l < all.size(); ++l)
        if (!is_zero((*c)[l])) needed[l] = true;
      rests.push_back(*std::move(c));
    }
    for (const Row& row : all) {
      auto a = rows_.combination(all, rows_.nabla(row));
      if (!a) return false;
      matrices.push_back(*std::move(a));
    }
    for (std::size_t round = 0; round < all.size(); ++round)
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < all.size() && needed[i]; ++j)
          if (!is_zero(matrices[i][j])) needed[j] = true;
    const auto chosen = [&](const Row& row) {
      Row part;
      for (std::size_t j = 0; j < all.size(); ++j)
        if (needed[j]) part.push_back(row[j]);
      return part;
    };
    for (const Row& rest : rests)
      id_.rests.push_back(chosen(rest));
    for (std::size_t i = 0; i < all.size(); ++i)
      if (needed[i]) {
        id_.annihilators.push_back(all[i]);
        id_.matrices.push_back(chosen(matrices[i]));
      }
    return true;
  }

  // Dual to the rows and 0 on the annihilators; whole: not through the bracket.
  bool find_vectors(std::vector<Row> rows, bool whole) {
    const std::size_t size = rows.size();
    rows.insert(rows.end(), id_.annihilators.begin(), id_.annihilators.end());
    for (Row& row : rows)
      if (!whole) row = rows_.through_bracket(row);
    for (std::size_t i = 0; i < size; ++i) {
      Row right(rows.size(), rows_.constant(0));
      right[i] = rows_.constant(1);
      auto x = rows_.solve(rows, right);
      if (!x) return false;
      id_.vectors.push_back(*std::move(x));
    }
    return true;
  }

  const CurveRows& rows_;
  NormalIdentity id_;
};

class OfEquation : IdentityFinder {
public:
  OfEquation(const ManifoldReport& report, const BlockReport& block, const CurveRows& rows)
      : IdentityFinder(rows), m_(report), block_(block), ode_(*block.ode), f_(*ode_.field) {}

  std::optional<NormalIdentity> operator()() {
    return find_identity() ? std::optional(id_) : std::nullopt;
  }

private:
  [[nodiscard]] const NormalVariationalEquation& scalar() const {
    const auto at = std::ranges::find_if(block_.scalar,
                                         [&](const auto& e) { return e.unknown == ode_.unknown; });
    KOV_ENSURE(at != block_.scalar.end());
    return *at;
  }

  bool find_identity() {
    const auto square = rows_.times(f_.inverse_z_dot(), f_.inverse_z_dot());
    id_.p = rows_.times(f_.z_ddot() + rows_.times(rows_.value(scalar().a1), f_.z_dot()), square);
    id_.q = rows_.times(rows_.value(scalar().a0), square);
    const Annihilators found(m_, rows_);
    const Row row = found.of_unknowns(scalar().combination), first = rows_.nabla(row);
    id_.rows = {row};
    Row left = rows_.nabla(first);
    for (std::size_t k = 0; k < left.size(); ++k)
      left[k] = left[k] + rows_.times(id_.p, first[k]) + rows_.times(id_.q, row[k]);
    auto all = found.of_integrals();
    if (!restrict_to(all, {left})) {
      std::ranges::move(found.of_other_blocks(block_.unknowns), std::back_inserter(all));
      if (!restrict_to(all, {left})) return false;
    }
    return find_vectors({row, first}, false);
  }

  const ManifoldReport& m_;
  const BlockReport& block_;
  const AlgebraicOde& ode_;
  const FunctionField& f_;
};

class OfSystem : IdentityFinder {
public:
  using IdentityFinder::IdentityFinder;

  // xi = y b, so that y is the differential of the function divided by b.
  std::optional<NormalIdentity> operator()(const RationalSystem& system,
                                           const UnknownsOfSystem& unknowns) {
    const std::set<std::size_t> different(system.unknowns.begin(), system.unknowns.end());
    if (different.size() != system.unknowns.size()) return std::nullopt;
    for (std::size_t i = 0; i < system.unknowns.size(); ++i) {
      const auto over = rows_.solve({{rows_.value(system.basis[i])}}, {rows_.constant(1)});
      if (!over) return std::nullopt;
      Row row = covector(unknowns.unknowns[system.unknowns[i]]);
      for (Element& x : row)
        x = rows_.times(over->front(), x);
      id_.rows.push_back(std::move(row));
    }
    std::vector<Row> left, all;
    for (std::size_t i = 0; i < id_.rows.size(); ++i) {
      left.push_back(rows_.nabla(id_.rows[i]));
      for (std::size_t j = 0; j < id_.rows.size(); ++j) {
        if (is_zero(system.a[i][j])) continue;
        const Element a = rows_.value(system.a[i][j]);
        for (std::size_t k = 0; k < left[i].size(); ++k)
          left[i][k] = left[i][k] - rows_.times(a, id_.rows[j][k]);
      }
    }
    for (const Differential& d : unknowns.eliminated)
      all.push_back(covector(d));
    return restrict_to(all, left) && find_vectors(id_.rows, unknowns.whole) ? std::optional(id_)
                                                                            : std::nullopt;
  }

private:
  [[nodiscard]] Row covector(const Differential& d) const {
    Row sum;
    for (const auto& [c, f] : d) {
      const Element factor = rows_.value(c);
      const Row df = rows_.gradient(f);
      if (sum.empty()) sum.assign(df.size(), rows_.constant(0));
      for (std::size_t k = 0; k < df.size(); ++k)
        sum[k] = sum[k] + rows_.times(factor, df[k]);
    }
    return sum;
  }
};

} // namespace

std::optional<NormalIdentity> normal_identity(const ManifoldReport& report,
                                              const BlockReport& block, const CurveRows& rows) {
  return OfEquation(report, block, rows)();
}

std::optional<NormalIdentity> normal_identity(const RationalSystem& system,
                                              const UnknownsOfSystem& unknowns,
                                              const CurveRows& rows) {
  return OfSystem(rows)(system, unknowns);
}

} // namespace kov
