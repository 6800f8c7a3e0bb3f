#include "integrals/known.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov {

// Integrals that depend on others, which quadratic polynomials may contain.
constexpr std::size_t most_dependent = 8;

namespace {

bool bracket_has_rank(const PhaseSpace& p, const Set& where, std::size_t rank,
                      const Budget& budget) {
  if (p.is_canonical()) return true;
  IndependentRows rows(p);
  for (const auto& row : *p.field.poisson)
    static_cast<void>(rows.add(where, row, budget));
  return rows.size() == rank;
}

} // namespace

KnownIntegrals KnownIntegrals::on(const Set& part) const {
  KnownIntegrals s = *this;
  s.where = part;
  return s;
}

std::size_t KnownIntegrals::casimirs() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(found, [](const FoundIntegral& f) { return f.casimir; }));
}

void KnownIntegrals::verify(const FoundIntegral& f) const {
  MFraction derivative = lie_derivative(space->field, f.value);
  for (const LogarithmicTerm& t : f.logarithms)
    derivative += t.times * lie_derivative(space->field, MFraction(t.of)) / MFraction(t.of);
  KOV_ENSURE(space->vanishes(where, derivative));
  if (!f.casimir) return;
  for (const MFraction& x : hamiltonian_field(space->field, *space->field.poisson, f.value))
    KOV_ENSURE(space->vanishes(where, x));
}

void KnownIntegrals::verify(const std::vector<MFraction>& y) const {
  KOV_ENSURE(commute(space->field.components, y));
  for (const FoundIntegral& f : found) {
    const auto d = gradient(space->field, f);
    MFraction along(space->field.ring);
    for (std::size_t i = 0; i < d.size(); ++i)
      along += d[i] * y[i];
    KOV_ENSURE(space->vanishes(where, along));
  }
}

std::optional<MPoly> KnownIntegrals::add(const FoundIntegral& f, const Budget& budget) {
  const auto answer = gradients.add(where, gradient(space->field, f), budget);
  if (answer.taken) {
    if (space->field.poisson &&
        std::ranges::all_of(commuting, [&](std::size_t j) { return commutes(f, found[j]); }))
      commuting.push_back(found.size());
    found.push_back(f);
  } else if (!answer.split && dependent.size() < most_dependent && f.logarithms.empty()) {
    dependent.push_back(f.value);
  }
  return answer.split;
}

std::optional<MPoly> KnownIntegrals::add(const std::vector<MFraction>& y, const Budget& budget) {
  IndependentRows frame(*space);
  auto answer = frame.add(where, space->field.components, budget);
  for (const auto& z : fields)
    if (answer.taken) answer = frame.add(where, z, budget);
  if (answer.taken) answer = frame.add(where, y, budget);
  if (answer.taken) fields.push_back(y);
  return answer.split;
}

bool KnownIntegrals::is_liouville(const Budget& budget) const {
  const std::size_t leaf = space->field.dimension() - casimirs();
  return leaf % 2 == 0 && commuting.size() == casimirs() + leaf / 2 &&
         bracket_has_rank(*space, where, leaf, budget);
}

bool KnownIntegrals::is_liouville_in_order(const Budget& budget) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (std::ranges::all_of(chosen, [&](std::size_t j) { return commutes(found[i], found[j]); }))
      chosen.push_back(i);
  if (chosen.size() < commuting.size()) return false;
  commuting = std::move(chosen);
  return is_liouville(budget);
}

bool KnownIntegrals::is_integrable(const Budget& budget) const {
  return space->field.poisson ? is_liouville(budget)
                              : found.size() + fields.size() + 1 >= space->field.dimension();
}

bool KnownIntegrals::has_all_casimirs(const Budget& budget) const {
  return bracket_has_rank(*space, where, space->field.dimension() - casimirs(), budget);
}

bool KnownIntegrals::commutes(const FoundIntegral& f, const FoundIntegral& g) const {
  return space->vanishes(where, poisson_bracket(space->field, f.value, g.value));
}

bool KnownIntegrals::commute(const std::vector<MFraction>& y,
                             const std::vector<MFraction>& z) const {
  const auto bracket = commutator(space->field, y, z);
  return std::ranges::all_of(bracket,
                             [&](const MFraction& f) { return space->vanishes(where, f); });
}

std::vector<FoundIntegral>
KnownIntegrals::commuting_first(const std::vector<FoundIntegral>& more) const {
  auto all = mapped<FoundIntegral>(commuting, [&](const std::size_t i) { return found[i]; });
  for (const FoundIntegral& f : more)
    if (std::ranges::all_of(all, [&](const FoundIntegral& g) { return commutes(f, g); }))
      all.push_back(f);
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!is_among(i, commuting)) all.push_back(found[i]);
  return all;
}

std::vector<std::vector<MFraction>> KnownIntegrals::fields_of_chosen() const {
  std::vector<std::vector<MFraction>> all;
  for (const std::size_t i : commuting)
    if (const FoundIntegral& f = found[i]; !f.casimir && !f.hamiltonian)
      all.push_back(hamiltonian_field(space->field, *space->field.poisson, f.value));
  return all;
}

Ansatz KnownIntegrals::quadratic() const {
  std::vector<MFraction> known, all;
  for (const FoundIntegral& f : found)
    known.push_back(f.value);
  known.insert(known.end(), dependent.begin(), dependent.end());
  const auto is_chosen = [&](std::size_t i) { return is_among(i, commuting); };
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!is_chosen(i)) all.push_back(known[i]);
    for (std::size_t j = i; j < known.size(); ++j)
      if (!is_chosen(i) || !is_chosen(j)) all.push_back(known[i] * known[j]);
  }
  const MPoly den = common_denominator(space->field.ring, all);
  return {.numerators = numerators(all, den), .denominator = den, .column = {}};
}

namespace {

void add_products(const KnownIntegrals& s, const Ansatz& ansatz, std::size_t i,
                  const MFraction& product, long left, std::vector<SparseRow>& rows) {
  if (rows.size() > 400) return;
  if (i == s.found.size()) {
    if (auto row = coordinates(*s.space, ansatz, product); row && !row->empty())
      rows.push_back(std::move(*row));
    return;
  }
  MFraction power = product;
  const long step = std::max(s.found[i].degree, 1L);
  for (long rest = left; rest >= 0; rest -= step) {
    add_products(s, ansatz, i + 1, power, rest, rows);
    if (rest >= step) power *= s.found[i].value;
  }
}

} // namespace

std::vector<SparseRow> KnownIntegrals::products(const Ansatz& ansatz, long degree) const {
  std::vector<SparseRow> rows;
  add_products(*this, ansatz, 0, MFraction(space->field.ring, Rational(1)), degree, rows);
  return rows;
}

} // namespace kov
