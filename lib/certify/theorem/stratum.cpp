#include "certify/theorem/stratum.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/check.hpp"
#include "certify/system/phase_space.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace kov::certify {

Conditions FamilyStratum::conditions() const {
  Conditions all;
  for (const auto& [i, value] : at)
    all.push_back({scaled(MPoly::variable(family->system.ring, i), value.n) - value.p, Sign::zero});
  all.insert(all.end(), region.begin(), region.end());
  return all;
}

namespace {

// The terms of f with other exponents, or left out; different ones stay different.
template <class Exponents> MPoly moved(const MPoly& f, const Ring& ring, Exponents change) {
  MPoly g(ring);
  for (long i = 0; i < f.length(); ++i) {
    auto e = f.exponents(i);
    if (!change(e)) continue;
    fmpz_mpoly_push_term_fmpz_ui(g.raw(), f.coefficient(i).raw(), e.data(), g.ctx());
  }
  fmpz_mpoly_sort_terms(g.raw(), g.ctx());
  return g;
}

// The remainder of f by a divisor whose leading coefficient in v is a number, up to a number.
MPoly remainder_in(const MPoly& f, const Coefficients& divisor, std::size_t v, Arithmetic& a) {
  const Coefficients rest = Elimination(a).pseudo_remainder(coefficients(f, v), divisor);
  MPoly sum(f.ring());
  for (std::size_t k = 0; k < rest.size(); ++k)
    sum = a.plus(sum, a.times(rest[k], pow(MPoly::variable(f.ring(), v), k)));
  return sum;
}

using Exponents = std::vector<unsigned long>;
using Images = std::vector<std::optional<PhaseFunction>>;
using Square = std::vector<std::vector<PhaseFunction>>;

/// X with the values put in, in its own names and some more.
class OnStratum {
public:
  OnStratum(const FamilyStratum& x, std::vector<std::string> more, Arithmetic& a)
      : x_(x), s_(x.family->system), ring_(ring_with(std::move(more))), in_(ring_, a), tower_(in_),
        given_(x.family->where({}, a)) {
    images_.resize(s_.ring->size());
    for (std::size_t i = 0; i < s_.ring->size(); ++i)
      images_[i] = in_.variable(i);
    for (const auto& [i, value] : x.at)
      images_[i] = PhaseFunction{in_ring(value.p, ring_), value.n};
    for (std::size_t k = 0; k < s_.inverses.size(); ++k)
      adjoin(s_.first_inverse() + k, put({s_.inverses[k], Integer(1)}), images_);
    for (const Conditions* all : {&x.family->assumptions, &x.region})
      for (const Condition& c : *all)
        given_.assume(primitive(Condition{in_ring(put({c.p, Integer(1)}).p, s_.ring), c.sign}));
  }

  [[nodiscard]] const Functions& in() const { return in_; }
  [[nodiscard]] const Tower& tower() const { return tower_; }
  [[nodiscard]] ConditionSet& given() { return given_; }
  /// f of X
  [[nodiscard]] PhaseFunction put(const PhaseFunction& f) const { return in_.composed(f, images_); }
  /// u = 1/h, h = p/n: the name stands for 1/p
  void adjoin(std::size_t name, const PhaseFunction& h, Images& images,
              std::optional<std::size_t> image_of = {}) {
    need(!is_zero(h.p), "a denominator is 0");
    tower_.adjoin({name, std::nullopt, h.p});
    images[image_of.value_or(name)] =
        PhaseFunction{scaled(MPoly::variable(ring_, name), h.n), Integer(1)};
  }
  /// Is f cleared to 0, also modulo relations that are monic in a function of their own and equations
  /// of the stratum that are monic in a parameter?
  [[nodiscard]] bool vanishes(const PhaseFunction& f) const {
    MPoly p = cleared(f.p);
    for (std::size_t v = s_.first_inverse(); v-- > s_.dimension && !is_zero(p);)
      for (const MPoly& r : s_.relations)
        if (const auto monic = monic_in(r, v)) {
          p = remainder_in(p, *monic, v, in_.arithmetic());
          break;
        }
    if (is_zero(p)) return true;
    std::vector<MPoly> equations;
    for (const Condition& c : given_.conditions())
      if (c.sign == Sign::zero) equations.push_back(in_ring(c.p, ring_));
    return is_zero(modulo_equations(p, equations, in_.arithmetic()));
  }
  /// A polynomial that is not 0 only where f is not, for all branches of the functions: the resultants with
  /// relations that are monic in a function of their own; other functions stay.
  [[nodiscard]] MPoly norm(MPoly f) const {
    for (std::size_t v = s_.first_inverse(); v-- > s_.dimension;) {
      if (!uses(f, v)) continue;
      std::optional<Coefficients> monic;
      for (const MPoly& r : s_.relations)
        if (!monic) monic = monic_in(r, v);
      if (!monic) continue;
      Elimination e(in_.arithmetic());
      const Coefficients rest = e.pseudo_remainder(coefficients(f, v), *monic);
      f = rest.empty() ? MPoly(ring_) : rest.size() == 1 ? rest[0] : e.resultant(*monic, rest);
    }
    return f;
  }
  /// f times all the denominators that its inverses need.
  [[nodiscard]] MPoly cleared(MPoly f) const {
    const auto& steps = tower_.steps();
    for (auto u = steps.rbegin(); u != steps.rend(); ++u) {
      MPoly sum(ring_);
      for (const MPoly& c : coefficients(f, u->variable))
        sum = in_.arithmetic().plus(in_.arithmetic().times(sum, u->inverse_of), c);
      f = std::move(sum);
    }
    return f;
  }

private:
  // The coefficients of a relation in v, the last of its functions, if the leading one is a number.
  [[nodiscard]] std::optional<Coefficients> monic_in(const MPoly& r, std::size_t v) const {
    const MPoly here = put({r, Integer(1)}).p;
    if (!uses(here, v)) return std::nullopt;
    for (std::size_t w = v + 1; w < s_.first_inverse(); ++w)
      if (uses(here, w)) return std::nullopt;
    Coefficients all = coefficients(here, v);
    if (all.size() < 2 || !is_constant(all.back())) return std::nullopt;
    return all;
  }
  [[nodiscard]] Ring ring_with(std::vector<std::string> more) const {
    auto names = s_.ring->names();
    for (std::string& name : more) {
      while (s_.ring->find(name))
        name += "_";
      names.push_back(std::move(name));
    }
    return make_ring(names);
  }

  const FamilyStratum& x_;
  const PhaseSystem& s_;
  Ring ring_;
  Functions in_;
  Tower tower_;
  Images images_;
  ConditionSet given_;
};

// ---- the system of a certificate

/// Y is X there; what its parameters satisfy.
class SystemOnStratum {
public:
  SystemOnStratum(const FamilyStratum& x, const Target& y, const LevelValues& levels, Arithmetic& a,
                  std::size_t& nodes)
      : x_(x), s_(x.family->system), y_(*y.system), target_(y), levels_(levels), a_(a),
        nodes_(nodes), on_(x, inverse_names(y_), a) {}

  void need_same_system() {
    need(s_.dimension == y_.dimension, "another number of coordinates");
    need(s_.hamiltonian.has_value() == y_.hamiltonian.has_value(), "a bracket, or none");
    name_all();
    for (std::size_t j = 0; j < y_.dimension; ++j)
      place_.push_back(of_x(y_.ring->name(j), 0, s_.dimension));
    need_same_functions();
    const PhaseSpace theirs(y_, a_), ours(s_, a_);
    if (!y_.hamiltonian) {
      for (std::size_t j = 0; j < y_.dimension; ++j)
        need_same(s_.field[place_[j]], y_.field[j], "another field");
      return;
    }
    need_same(*s_.hamiltonian, *y_.hamiltonian, "another Hamiltonian");
    for (std::size_t i = 0; i < y_.dimension; ++i)
      for (std::size_t j = i + 1; j < y_.dimension; ++j)
        need_same(ours.bracket(place_[i], place_[j]), theirs.bracket(i, j), "another bracket");
  }

  void need_asked(const Node& shown) {
    const auto rows = shown.items();
    std::size_t next = 0;
    SetProof proof(on_.given(), nodes_);
    for (const AskedCondition& c : target_.asked) {
      if (c.real || is_of_one_level(c)) {
        need_real(c);
        continue;
      }
      if (next == rows.size()) shown.fail("not everything is shown");
      const Node& by = rows[next++];
      const bool group = !c.group.empty();
      if (!group && c.sign != Sign::nonzero) {
        const auto parts = by_levels(c.f);
        need(parts.size() == 1 && parts.front().first == Exponents(y_.ring->size(), 0),
             "a condition on a level");
        proof.show({parts.front().second, c.sign}, by);
        continue;
      }
      std::vector<MPoly> all;
      for (const MPoly& f : group ? c.group : std::vector<MPoly>{c.f})
        for (const auto& [levels, part] : by_levels(f))
          all.push_back(part);
      proof.show_some(all, by);
    }
    if (next != rows.size()) shown.fail("more is shown than is needed");
  }

private:
  static std::vector<std::string> inverse_names(const PhaseSystem& y) {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < y.inverses.size(); ++k)
      all.push_back("_inverse" + std::to_string(k));
    return all;
  }
  // The name of X with this text, in a range.
  [[nodiscard]] std::size_t of_x(const std::string& name, std::size_t from, std::size_t to) const {
    const auto i = s_.ring->find(name);
    need(i && *i >= from && *i < to, "the system has another name");
    return *i;
  }
  // Values of the names of Y; a level has none.
  void name_all() {
    images_.resize(y_.ring->size());
    for (std::size_t j = 0; j < y_.first_inverse(); ++j)
      images_[j] = on_.in().variable(
          j < y_.dimension ? of_x(y_.ring->name(j), 0, s_.dimension)
                           : of_x(y_.ring->name(j), s_.dimension, s_.first_inverse()));
    std::size_t valued = 0;
    for (std::size_t j = y_.first_parameter(); j < y_.ring->size(); ++j) {
      const auto i = s_.ring->find(y_.ring->name(j));
      need(i || !target_.chosen.contains(y_.ring->name(j)),
           "a level in the value of a function, or of what it depends on");
      const auto value = levels_.find(y_.ring->name(j));
      if (value != levels_.end()) {
        need(!i, "a level is expected");
        images_[j] = on_.put(value->second);
        ++valued;
      }
      if (!i) continue;
      need(x_.family->is_parameter(*i) && !x_.at.contains(*i), "a parameter that has a value");
      images_[j] = on_.in().variable(*i);
    }
    need(valued == levels_.size(), "a level is expected");
    for (std::size_t k = 0; k < y_.inverses.size(); ++k)
      on_.adjoin(s_.ring->size() + k, on_.in().composed({y_.inverses[k], Integer(1)}, images_),
                 images_, y_.first_inverse() + k);
  }
  void need_same(const PhaseFunction& ours, const PhaseFunction& theirs, const char* why) const {
    const PhaseFunction f = on_.in().minus(on_.put(ours), on_.in().composed(theirs, images_));
    need(on_.tower().clears(f), why);
  }
  void need_same_functions() {
    const PhaseSpace theirs(y_, a_), ours(s_, a_);
    const PhaseFunction zero{MPoly(y_.ring), Integer(1)}, none{MPoly(s_.ring), Integer(1)};
    for (std::size_t f = 0; f < y_.functions.size(); ++f) {
      const std::size_t g =
          of_x(y_.ring->name(y_.dimension + f), s_.dimension, s_.first_inverse()) - s_.dimension;
      for (std::size_t j = 0; j < y_.dimension; ++j) {
        const PhaseFunction* left = ours.gradient(g, place_[j]);
        const PhaseFunction* right = theirs.gradient(f, j);
        need_same(left ? *left : none, right ? *right : zero, "another gradient");
      }
    }
    need_same_relations();
  }
  void need_same_relations() {
    std::vector<MPoly> here, there;
    for (const MPoly& q : s_.relations)
      here.push_back(primitive(on_.put({q, Integer(1)}).p));
    for (const MPoly& r : y_.relations)
      there.push_back(primitive(on_.in().composed({r, Integer(1)}, images_).p));
    const auto is_in = [](const std::vector<MPoly>& all, const MPoly& f) {
      return std::ranges::any_of(all, [&](const MPoly& g) { return f == g || f == -g; });
    };
    for (const MPoly& f : there)
      need(is_in(here, f), "a relation that the system has not");
    for (const MPoly& f : here)
      need(is_in(there, f) || !has_function_of_y(f) || holds(f),
           "a relation does not hold along the curve");
  }
  [[nodiscard]] bool has_function_of_y(const MPoly& f) const {
    const auto used = used_variables(f);
    return std::ranges::any_of(used, [&](std::size_t i) {
      const auto j = y_.ring->find(on_.in().ring()->name(i));
      return j && *j >= y_.dimension && *j < y_.first_inverse();
    });
  }
  // Is it 0 along the curve?
  [[nodiscard]] bool holds(const MPoly& f) const {
    for (const std::size_t i : used_variables(f))
      if (!y_.ring->find(on_.in().ring()->name(i))) return false;
    return target_.way && holds_on_curve(*target_.way, in_ring(f, y_.ring), a_);
  }

  [[nodiscard]] bool is_level(std::size_t j) const { return !images_[j].has_value(); }
  // f by the monomials in the levels, the parts in the names of X.
  [[nodiscard]] std::vector<std::pair<Exponents, MPoly>> by_levels(const MPoly& f) const {
    std::set<Exponents> monomials;
    const auto of_levels = [&](const Exponents& e) {
      Exponents levels(e.size(), 0);
      for (std::size_t j = 0; j < e.size(); ++j) {
        need(e[j] == 0 || j >= y_.first_parameter(), "a condition on the parameters is expected");
        if (is_level(j)) levels[j] = e[j];
      }
      return levels;
    };
    for (long t = 0; t < f.length(); ++t)
      monomials.insert(of_levels(f.exponents(t)));
    if (monomials.empty()) monomials.insert(Exponents(y_.ring->size(), 0));
    need_within(monomials.size() <= max_parts, "too many monomials in the levels");
    std::vector<std::pair<Exponents, MPoly>> all;
    for (const Exponents& m : monomials) {
      const MPoly part = moved(f, y_.ring, [&](Exponents& e) {
        if (of_levels(e) != m) return false;
        for (std::size_t j = 0; j < e.size(); ++j)
          if (is_level(j)) e[j] = 0;
        return true;
      });
      all.emplace_back(m, in_ring(on_.in().composed({part, Integer(1)}, images_).p, s_.ring));
    }
    return all;
  }
  // "c h + d > 0" of a level h alone, once for each: real values of h that satisfy it fill an interval.
  [[nodiscard]] bool is_of_one_level(const AskedCondition& c) {
    if (!c.group.empty() || c.real) return false;
    if (c.sign != Sign::positive && c.sign != Sign::nonnegative) return false;
    const auto used = used_variables(c.f);
    if (used.size() != 1 || used[0] < y_.first_parameter() || !is_level(used[0])) return false;
    need(coefficients(c.f, used[0]).size() == 2, "a condition on a level");
    need(bounded_.insert(used[0]).second, "two conditions on a level");
    return true;
  }
  void need_real(const AskedCondition& c) const {
    if (!c.real) return;
    for (const std::size_t j : used_variables(c.f)) {
      if (is_level(j)) continue;
      for (const std::size_t i : used_variables(images_[j]->p))
        need(x_.family->complex.empty() || !x_.family->complex[i],
             "a parameter that need not be real");
    }
  }

  static constexpr std::size_t max_parts = 500;

  const FamilyStratum& x_;
  const PhaseSystem &s_, &y_;
  const Target& target_;
  const LevelValues& levels_;
  Arithmetic& a_;
  std::size_t& nodes_;
  OnStratum on_;
  Images images_;
  std::vector<std::size_t> place_; ///< of the coordinates of Y among those of X
  std::set<std::size_t> bounded_;
};

// ---- first integrals

/// The functions and fields of X with their derivatives.
class IntegralsOnStratum {
public:
  IntegralsOnStratum(const FamilyStratum& x, Arithmetic& a)
      : s_(x.family->system), a_(a), on_(x, {}, a), space_(s_, a), field_(space_.field()) {}

  [[nodiscard]] OnStratum& on() { return on_; }
  [[nodiscard]] const PhaseSpace& space() const { return space_; }
  [[nodiscard]] const std::vector<PhaseFunction>& field() const { return field_; }

  [[nodiscard]] std::vector<PhaseFunction> gradient(const PhaseFunction& f) const {
    std::vector<PhaseFunction> df;
    for (std::size_t j = 0; j < s_.dimension; ++j)
      df.push_back(space_.partial(f, j));
    return df;
  }
  [[nodiscard]] Square gradients(const ClaimedIntegrals& c) const {
    Square rows;
    for (const auto& [name, f] : c.claims)
      rows.push_back(gradient(f));
    return rows;
  }
  [[nodiscard]] Square structure() const {
    Square rows;
    for (std::size_t i = 0; i < s_.dimension; ++i) {
      rows.emplace_back();
      for (std::size_t j = 0; j < s_.dimension; ++j)
        rows.back().push_back(space_.bracket(i, j));
    }
    return rows;
  }
  [[nodiscard]] Square fields(const ClaimedIntegrals& c) const {
    Square rows{field_};
    rows.insert(rows.end(), c.fields.begin(), c.fields.end());
    return rows;
  }
  /// All rows, or those of the columns; cleared of inverses.
  [[nodiscard]] MPoly minor(const Square& rows, const std::vector<std::size_t>& columns) const {
    Square m;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto& row = rows.at(rows.size() == columns.size() ? k : columns[k]);
      m.emplace_back();
      for (const std::size_t j : columns)
        m.back().push_back(on_.put(row[j]));
    }
    return on_.norm(on_.cleared(determinant(m).p));
  }

private:
  // Expands along the first row.
  [[nodiscard]] PhaseFunction determinant(const Square& m) const {
    if (m.empty()) return on_.in().one();
    PhaseFunction sum = on_.in().zero();
    for (std::size_t j = 0; j < m.size(); ++j) {
      if (is_zero(m[0][j].p)) continue;
      Square rest;
      for (std::size_t i = 1; i < m.size(); ++i) {
        rest.push_back(m[i]);
        rest.back().erase(rest.back().begin() + static_cast<long>(j));
      }
      const PhaseFunction term = on_.in().times(m[0][j], determinant(rest));
      sum = j % 2 == 0 ? on_.in().plus(sum, term) : on_.in().minus(sum, term);
    }
    return sum;
  }

  const PhaseSystem& s_;
  Arithmetic& a_;
  OnStratum on_;
  PhaseSpace space_;
  std::vector<PhaseFunction> field_;
};

class Integrability {
public:
  Integrability(const FamilyStratum& x, Keys& data, Arithmetic& a, std::size_t& nodes)
      : x_(x), s_(x.family->system), a_(a), nodes_(nodes), data_(data), in_(x, a) {}

  ClaimedIntegrals operator()() {
    all_.family = x_.family;
    for (const Node& n : data_.at("claims").items()) {
      Keys k(n);
      const std::string name = k.at("name").text();
      all_.claims.emplace_back(name, function(k.at("value")));
      k.done();
    }
    for (const Node& row : data_.at("fields").items())
      read_field(row);
    const Square rows = in_.gradients(all_);
    for (const auto& df : rows)
      need_zero(in_.space().product(in_.field(), df), "not a first integral");
    s_.hamiltonian ? need_liouville(rows) : need_commuting(rows);
    return std::move(all_);
  }

private:
  [[nodiscard]] PhaseFunction function(const Node& n) const {
    PhaseFunction f = read_phase_function(s_.ring, n);
    if (is_zero(f.n)) n.fail("a number is 0");
    return f;
  }
  void read_field(const Node& row) {
    std::vector<PhaseFunction> y;
    for (const Node& n : row.items())
      y.push_back(function(n));
    if (y.size() != s_.dimension) row.fail("an entry for each coordinate is expected");
    all_.fields.push_back(std::move(y));
  }
  void need_zero(const PhaseFunction& f, const char* why) {
    need(in_.on().vanishes(in_.on().put(f)), why);
  }

  // In involution; as many as the rank of the bracket asks for.
  void need_liouville(const Square& rows) {
    need(all_.fields.empty(), "fields beside a bracket");
    const Square structure = in_.structure();
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = i + 1; j < rows.size(); ++j) {
        std::vector<PhaseFunction> moved;
        for (const auto& row : structure)
          moved.push_back(in_.space().product(row, rows[j]));
        need_zero(in_.space().product(rows[i], moved), "not in involution");
      }
    const std::size_t m = rows.size();
    need_minor("independent", "independence", rows, m);
    need(m <= s_.dimension && 2 * m >= s_.dimension, "not as many integrals as are needed");
    need_minor("rank", "the rank", structure, 2 * (s_.dimension - m));
  }

  // Fields that commute, and integrals that are constant along them: together as many as variables.
  void need_commuting(const Square& rows) {
    const Square fields = in_.fields(all_);
    for (const auto& y : all_.fields)
      for (const auto& df : rows)
        need_zero(in_.space().product(y, df), "not constant along a field");
    for (std::size_t i = 0; i < fields.size(); ++i)
      for (std::size_t j = i + 1; j < fields.size(); ++j)
        need_commute(fields[i], fields[j]);
    if (!rows.empty()) need_minor("independent", "independence", rows, rows.size());
    if (rows.size() == s_.dimension && all_.fields.empty()) { // all points are equilibria
      need(data_.at("rank").is_null(), "no rank is asked for");
      return;
    }
    need(fields.size() + rows.size() == s_.dimension, "not as many integrals as are needed");
    need_minor("rank", "the rank", fields, fields.size());
  }
  void need_commute(const std::vector<PhaseFunction>& x, const std::vector<PhaseFunction>& y) {
    const Functions in(s_.ring, a_);
    for (std::size_t j = 0; j < s_.dimension; ++j)
      need_zero(in.minus(in_.space().product(x, in_.gradient(y[j])),
                         in_.space().product(y, in_.gradient(x[j]))),
                "the fields do not commute");
  }

  // A minor is not the zero function, at each point of the stratum; or on trust.
  void need_minor(const char* key, const char* what, const Square& rows, std::size_t size) {
    const Node n = data_.at(key);
    if (n.is_null()) {
      all_.not_shown.emplace_back(what);
      return;
    }
    Keys k(n);
    const auto columns = coordinates(k.at("columns"));
    need(columns.size() == size && size <= max_minor, "a minor of another size");
    const MPoly c = coefficient(in_.minor(rows, columns), k.at("monomial"));
    const MPoly value = read_poly(s_.ring, k.at("value"));
    need(is_multiple(value, c), "another coefficient");
    SetProof(in_.on().given(), nodes_).show({value, Sign::nonzero}, k.at("by"));
    k.done();
  }
  [[nodiscard]] std::vector<std::size_t> coordinates(const Node& n) const {
    std::vector<std::size_t> all;
    for (const Node& x : n.items()) {
      const auto i = s_.ring->find(x.text());
      need(i && *i < s_.dimension, "a coordinate is expected");
      need(!is_among(*i, all), "a coordinate is expected");
      all.push_back(*i);
    }
    return all;
  }
  // Does a function depend on the coordinate?
  [[nodiscard]] bool is_argument(std::size_t j) const {
    return std::ranges::any_of(s_.functions, [&](const PhaseSymbol& f) {
      return std::ranges::any_of(f.gradient, [&](const auto& entry) { return entry.first == j; });
    });
  }
  // The coefficient of a monomial in the coordinates: exponents, one for each.  No function occurs
  // beside the same powers of those coordinates on which none depends.
  [[nodiscard]] MPoly coefficient(const MPoly& f, const Node& n) const {
    const auto items = n.items();
    if (items.size() != s_.dimension) n.fail("an exponent for each coordinate is expected");
    std::vector<long> exponents;
    for (const Node& x : items)
      exponents.push_back(x.count());
    std::vector<bool> argument;
    for (std::size_t j = 0; j < s_.dimension; ++j)
      argument.push_back(is_argument(j));
    return moved(f, s_.ring, [&](Exponents& e) {
      bool is_here = true;
      for (std::size_t j = 0; j < s_.dimension; ++j) {
        const bool same = static_cast<long>(std::exchange(e[j], 0)) == exponents[j];
        if (!same && !argument[j]) return false;
        is_here = is_here && same;
      }
      for (std::size_t j = s_.dimension; j < s_.first_parameter(); ++j)
        need(e[j] == 0, "a name that is not a parameter");
      return is_here;
    });
  }

  static constexpr std::size_t max_minor = 8;

  const FamilyStratum& x_;
  const PhaseSystem& s_;
  Arithmetic& a_;
  std::size_t& nodes_;
  Keys& data_;
  IntegralsOnStratum in_;
  ClaimedIntegrals all_;
};

} // namespace

MPoly modulo_equations(MPoly f, const std::vector<MPoly>& equations, Arithmetic& a) {
  for (std::size_t v = f.ring()->size(); v-- > 0 && !is_zero(f);)
    for (const MPoly& g : equations) {
      if (is_zero(g) || is_constant(g) || used_variables(g).back() != v) continue;
      const Coefficients all = coefficients(g, v);
      if (!is_constant(all.back())) continue;
      f = remainder_in(f, all, v, a);
      break;
    }
  return f;
}

void need_restriction(const FamilyStratum& x, const Target& y, const LevelValues& levels,
                      const Node& shown, Arithmetic& a, std::size_t& nodes_left) {
  SystemOnStratum r(x, y, levels, a, nodes_left);
  r.need_same_system();
  r.need_asked(shown);
}

ClaimedIntegrals need_integrable(const FamilyStratum& x, Keys& data, Arithmetic& a,
                                 std::size_t& nodes_left) {
  return Integrability(x, data, a, nodes_left)();
}

MPoly minor_of(const FamilyStratum& x, const ClaimedIntegrals& c, bool rank,
               const std::vector<std::size_t>& columns, Arithmetic& a) {
  const IntegralsOnStratum in(x, a);
  const bool bracket = x.family->system.hamiltonian.has_value();
  return in.minor(!rank ? in.gradients(c) : bracket ? in.structure() : in.fields(c), columns);
}

} // namespace kov::certify
