#include "jets/obstruction.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "jets/certificate.hpp"
#include "jets/squares.hpp"
#include "jets/subspace.hpp"
#include "linode/normal_form.hpp"

#include <algorithm>
#include <array>

namespace kov::jets {
namespace {

constexpr long first_terms = 24;
constexpr long most_terms = 1500;

// The coefficients of c1^i c2^(n - i) in f, a homogeneous polynomial of degree n in c1, c2.
std::vector<MFraction> binary_coefficients(const InvariantPlane& plane, const MFraction& f,
                                           std::size_t n) {
  std::vector<MFraction> all(n + 1);
  const auto by_c1 = coefficients(f, plane.c1);
  for (std::size_t i = 0; i < by_c1.size(); ++i) {
    const auto by_c2 = coefficients(by_c1[i], plane.c2);
    if (by_c2.size() > n - i) all[i] = plane.reduced(by_c2[n - i]);
  }
  return all;
}

using Column = std::array<MFraction, 3>;

MFraction determinant(const Column& a, const Column& b, const Column& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

} // namespace

std::vector<MPoly> commuting_determinants(const InvariantPlane& plane, const MFraction& form) {
  const MFraction c1 = MFraction::variable(plane.ring, plane.c1);
  const MFraction c2 = MFraction::variable(plane.ring, plane.c2);
  const MFraction r1 = derivative(form, plane.c1), r2 = derivative(form, plane.c2);
  if (is_zero(form)) return {};
  const auto exponents = form.num().exponents(0);
  const std::size_t n = exponents[plane.c1] + exponents[plane.c2]; // the degree of the form
  const std::array<std::vector<MFraction>, 3> rows{binary_coefficients(plane, c1 * r2, n),
                                                   binary_coefficients(plane, c2 * r2 - c1 * r1, n),
                                                   binary_coefficients(plane, c2 * r1, n)};
  std::vector<Column> columns;
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    Column c{rows[0][i], rows[1][i], rows[2][i]};
    if (std::ranges::any_of(c, [](const MFraction& x) { return !is_zero(x); }))
      columns.push_back(std::move(c));
  }
  std::vector<MPoly> all;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = i + 1; j < columns.size(); ++j)
      for (std::size_t k = j + 1; k < columns.size(); ++k)
        if (const MFraction d = plane.reduced(determinant(columns[i], columns[j], columns[k]));
            !is_zero(d))
          add_once(all, squarefree_part(d.num()));
  return all;
}

bool in_first_family(long degree, const Rational& difference) {
  const auto integral = [&](int one) {
    return is_integer(Rational(degree - 2) * (difference + one) / Rational(2 * degree));
  };
  return integral(1) || integral(-1);
}

namespace {

// e is linear in the energy.
MFraction at_energy(const MFraction& f, const Place& place, const InvariantPlane& plane) {
  const MFraction slope = derivative(place.energy, plane.e);
  KOV_ENSURE(!is_zero(slope) && !uses(slope, plane.e));
  const MFraction start = substitute(place.energy, {{plane.e, MFraction(plane.ring)}});
  const MFraction energy = MFraction::variable(plane.ring, plane.energy);
  return plane.reduced(substitute(f, {{plane.e, (energy - start) / slope}}));
}

// a b != 0 is a != 0 and b != 0; each is said once.
std::vector<std::vector<MPoly>> by_factors(const std::vector<std::vector<MPoly>>& all) {
  std::vector<std::vector<MPoly>> finer;
  const auto add = [&](const std::vector<MPoly>& list) { add_once(finer, list); };
  for (const auto& list : all)
    if (list.size() > 1)
      add(list);
    else
      for (const MFactor& f : factor(list.front()).second)
        add({f.base});
  return finer;
}

// (2.7)
bool homogeneous(HigherObstruction& found, const InvariantPlane& plane) {
  const Place& place = found.place;
  const Logarithm& log = found.logarithm;
  const auto is_monomial = [&](const MFraction& f) {
    const auto c = coefficients(f, plane.y);
    return std::ranges::count_if(c, [](const MFraction& x) { return !is_zero(x); }) <= 1;
  };
  const Substitution on_plane{{plane.x, MFraction(plane.ring)}};
  const MFraction normal = substitute(derivative(plane.across, plane.x), on_plane);
  const bool vanishes = place.difference() == Rational(1); // the coefficient of y^(k - 2)
  const bool applies = is_monomial(substitute(plane.along, on_plane)) &&
                       (vanishes ? is_zero(normal) : is_monomial(normal)) &&
                       in_first_family(place.degree, place.difference());
  const MPoly form = log.form.num();
  const MFraction last = substitute(log.form, {{plane.c1, MFraction(plane.ring)}});
  if (!applies || !is_zero(plane.reduced(last))) return false;
  found.because = InfiniteGroup::homogeneous;
  auto& list = found.not_all_zero.emplace_back();
  for (const MPoly& c : nonzero_coefficients(form, {plane.c1, plane.c2, plane.energy}))
    add_once(list, squarefree_part(plane.norm(c)));
  return true;
}

// (2.9) The squares of the exponents at the equilibria, of which there are k - 1, have this sum.
bool by_equilibria(HigherObstruction& found, const InvariantPlane& plane) {
  const Place& p = found.place;
  const Rational sigma(-2, p.degree - 2);
  const Rational sum = p.rho1 * (p.rho1 - 1) / (sigma * (sigma - 1));
  if (may_be_sum_of_squares(sum, p.degree - 1)) return false;
  const MPoly slope = derivative(plane.potential, plane.y).num();
  const MFraction simple = plane.reduced(MFraction(kov::discriminant(slope, plane.y)));
  if (is_zero(simple)) return false;
  found.not_all_zero.push_back({squarefree_part(plane.norm(simple.num()))});
  return true;
}

// No parameters, no algebraic constants.
bool numeric(const InvariantPlane& plane) {
  const auto used = [&](const MFraction& f) {
    for (const std::size_t i : used_variables(f))
      if (i != plane.x && i != plane.y) return true;
    return false;
  };
  return !used(plane.across) && !used(plane.along) && !used(plane.inertia) &&
         !used(plane.potential);
}

class ObstructionSearch {
public:
  ObstructionSearch(const System& whole, const Subspace& inside, const HigherOptions& options)
      : whole_(whole), inside_(inside), options_(options), budget_(options.decide.budget) {
    result_.up_to = options.order;
    auto plane = invariant_plane(inside.system, inside.manifold);
    if (auto* no = std::get_if<OutOfScope>(&plane))
      note(to_string(*no));
    else
      result_.plane = std::get<InvariantPlane>(std::move(plane));
  }

  HigherOrders run() {
    if (result_.plane) look();
    if (result_.obstruction) certify();
    result_.open = joined(why_open_, "; ");
    return std::move(result_);
  }

private:
  // An obstruction whose certificate our own checker refuses is withdrawn.
  void certify() {
    why_open_.clear();
    Certified c = certificate(whole_, inside_, *result_.obstruction);
    result_.obstruction->certificate = std::move(c.json);
    result_.obstruction->no_certificate = c.none;
    if (!c.refused) return;
    result_.obstruction.reset();
    note("an obstruction was withdrawn: " + c.none);
  }

  void note(const std::string& why) { add_once(why_open_, why); }

  void look() {
    try {
      for (const int sign : {1, -1})
        if (!result_.obstruction && (sign == 1 || two_places_)) look(sign);
    } catch (const OutOfBudget& limit) {
      note(limit.what());
    }
  }

  // One place over infinity if the degree is odd, two that y -> -y exchanges if it is even.
  void look(int sign) {
    plane_ = sign == 1 ? *result_.plane : result_.plane->reflected();
    for (long terms = first_terms;; terms += terms / 2) {
      budget_.check();
      try {
        return look(sign, terms);
      } catch (const NeedsMoreTerms&) {
        if (terms > most_terms) throw OutOfBudget("the series would need too many terms");
      }
    }
  }

  void look(int sign, long terms) {
    auto expanded = place_at_infinity(plane_, terms, budget_);
    if (auto* no = std::get_if<OutOfScope>(&expanded)) return note(to_string(*no));
    Place& place = std::get<Place>(expanded);
    place.sign = sign;
    two_places_ = place.degree % 2 == 0;
    auto log = first_logarithm(plane_, place, options_.order, budget_);
    if (!log) return;
    HigherObstruction found;
    found.local_form = log->form;
    log->form = at_energy(log->form, place, plane_);
    found.logarithm = *std::move(log);
    found.place = place;
    found.plane = plane_;
    for (const std::size_t l : inside_.others)
      for (const std::size_t i : {l, l + whole_.field.dimension() / 2})
        found.within += whole_.ring()->name(whole_.field.coordinates[i]) + " = ";
    if (!found.within.empty()) found.within += "0";
    judge(std::move(found));
  }

  void judge(HigherObstruction found) {
    const Place& place = found.place;
    const Logarithm& log = found.logarithm;
    const auto determinants = commuting_determinants(plane_, log.form);
    if (!homogeneous(found, plane_) && !by_determinants(determinants, found))
      return note("VE_" + std::to_string(log.order) +
                  " has a logarithm at infinity, R = " + brief(log.form, 120) +
                  (determinants.empty()
                       ? ", which commutes with a quadratic form: nothing follows"
                       : ", but the group of the normal equation is not known to be infinite"));
    for (const MPoly& p : plane_.nonzero)
      found.not_all_zero.push_back({plane_.norm(p)});
    for (const MPoly& p : {place.time_scale.num(), place.time_scale.den()})
      found.not_all_zero.push_back({plane_.norm(p)});
    found.not_all_zero = by_factors(found.not_all_zero);
    result_.obstruction = std::move(found);
  }

  // Decides by the determinants at the level of the file, if that is a number; else for almost
  // all levels; else at some level.
  bool by_determinants(const std::vector<MPoly>& determinants, HigherObstruction& found) {
    if (determinants.empty()) return false;
    const auto& level = result_.plane->level;
    if (numeric(plane_) && level && is_constant(*level) && decided_at(*level, determinants, found))
      return true;
    if (in_first_family(found.place.degree, found.place.difference()))
      found.because = InfiniteGroup::first_family;
    else if (by_equilibria(found, plane_))
      found.because = InfiniteGroup::equilibria;
    else
      return numeric(plane_) && decided_somewhere(determinants, found);
    std::vector<MPoly> parts;
    for (const MPoly& d : determinants)
      for (const MPoly& c : nonzero_coefficients(d, {plane_.energy}))
        add_once(parts, squarefree_part(plane_.norm(c)));
    found.not_all_zero.push_back(std::move(parts));
    return true;
  }

  bool decided_somewhere(const std::vector<MPoly>& determinants, HigherObstruction& found) {
    const std::vector<Rational> levels{1, -1, 2, Rational(1, 3), 7};
    return std::ranges::any_of(levels, [&](const Rational& h) {
      return decided_at(MFraction(plane_.ring, h), determinants, found);
    });
  }

  // The curve y'^2 = 2 A (h - V) is smooth, R does not commute there, and the normal equation
  // 2A(h - V) u_yy + g u_y - w u = 0 has an infinite group.
  bool decided_at(const MFraction& h, const std::vector<MPoly>& determinants,
                  HigherObstruction& found) {
    const Substitution here{{plane_.energy, h}};
    if (std::ranges::all_of(determinants,
                            [&](const MPoly& d) { return is_zero(substitute(d, here)); }))
      return false;
    const Substitution on_plane{{plane_.x, MFraction(plane_.ring)}};
    const MFraction kinetic = h - plane_.potential;
    if (is_zero(kov::discriminant(kinetic.num(), plane_.y))) return false;
    const MFraction twice = 2 * (plane_.inertia * kinetic);
    const MFraction p = substitute(plane_.along, on_plane) / twice;
    const MFraction q = -(substitute(derivative(plane_.across, plane_.x), on_plane) / twice);
    Options options = options_.decide;
    options.want_certificate = true;
    options.want_solutions = false;
    options.want_trace = false;
    Decision d = decide(
        normal_form(to_rational_function(p, plane_.y), to_rational_function(q, plane_.y)), options);
    if (!d.component || *d.component == Connected::trivial || d.withdrawn) return false;
    found.because = InfiniteGroup::decided;
    found.energy = h;
    found.group = std::move(d);
    return true;
  }

  const System& whole_;
  const Subspace& inside_;
  const HigherOptions& options_;
  const Budget& budget_;
  InvariantPlane plane_; ///< the one looked at, reflected for the second place
  bool two_places_ = false;
  HigherOrders result_;
  std::vector<std::string> why_open_;
};

HigherOrders within(const System& s, const Subspace& inside, const HigherOptions& options) {
  HigherOrders open;
  open.up_to = options.order;
  try {
    return ObstructionSearch(s, inside, options).run();
  } catch (const OutOfBudget& limit) {
    open.open = limit.what();
  } catch (const DomainError& undefined) { // a division by 0 at these values
    open.open = undefined.what();
  }
  return open;
}

} // namespace

HigherOrders higher_orders(const System& s, const ManifoldSpec& m, const HigherOptions& options) {
  if (options.order < 2 || options.order > largest_order)
    throw InvalidArgument("the order must be between 2 and " + std::to_string(largest_order));
  HigherOrders all;
  all.up_to = options.order;
  std::vector<std::string> whys;
  for (const Subspace& inside : invariant_subspaces(s, m)) {
    HigherOrders one = within(s, inside, options);
    if (one.obstruction || inside.others.empty()) return one;
    add_once(whys, one.open.empty() ? std::string("no logarithm at infinity") : one.open);
  }
  all.open = whys.empty()
                 ? "the line is in no invariant subspace of two degrees of freedom, two of "
                   "the coordinates with their momenta"
                 : "in subspaces of two degrees of freedom: " + joined(whys);
  return all;
}

} // namespace kov::jets
