#include "certify/theorem/map.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/rules.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

std::vector<std::string> adjoined_names(const Ring& x, const Node& adjoined) {
  std::vector<std::string> all = x->names(), names;
  for (const Node& n : adjoined.items()) {
    names.push_back(Keys(n).at("name").text());
    all.push_back(names.back());
  }
  if (all.size() > max_phase_names) adjoined.fail("more than 64 names");
  static_cast<void>(ring_of(adjoined, all));
  return names;
}

} // namespace

std::vector<std::string> inverse_names(const Ring& x, const PhaseSystem& y) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < y.inverses.size(); ++k) {
    all.push_back("_inverse" + std::to_string(k));
    while (x->find(all.back()))
      all.back() += "_";
  }
  return all;
}

Map::Map(const StepPlace& x, const Target& y, Keys& data, Arithmetic& a, std::size_t& nodes_left)
    : stratum_(x), x_(x.family->system), y_(y), a_(a), nodes_(nodes_left), by_name_(false),
      here_(stratum_, adjoined_names(x_.ring, data.at("adjoined")), a), constant_(here_.free()),
      known_(in().ring()->size(), false), values_(y.system->ring->size()) {
  for (std::size_t i = 0; i < x_.ring->size(); ++i)
    known_[i] = !x.at.contains(i);
  for (const Node& n : data.at("adjoined").items())
    adjoin(n);
  read_values(data.at("values"));
  need_rows();
  need_inverse(data.at("back"));
  const PhaseFunction bracket = unit(data.at("bracket"));
  need_same(bracket, unit(data.at("energy")));
  need_shown(data.at("shown"));
}

Map::Map(const StepPlace& x, const Target& y, const LevelValues& levels, const Node& shown,
         Arithmetic& a, std::size_t& nodes_left)
    : stratum_(x), x_(x.family->system), y_(y), a_(a), nodes_(nodes_left), by_name_(true),
      here_(stratum_, inverse_names(x_.ring, *y.system), a), constant_(here_.free()),
      values_(y.system->ring->size()) {
  need(x_.dimension == y.system->dimension, "another number of coordinates");
  need(x_.hamiltonian.has_value() == y.system->hamiltonian.has_value(), "a bracket, or none");
  read_names(levels);
  need_rows();
  need_same_functions();
  need_same(in().one(), in().one());
  need_shown(shown);
}

// ---- (M1)

void Map::adjoin(const Node& n) {
  Keys k(n);
  const Ring& ring = in().ring();
  const std::size_t x = ring->index(k.at("name").text());
  AdjoinedName name{x, std::nullopt, MPoly(ring)};
  if (const auto square = k.find("square")) {
    name.square = element(*square);
    need_constant(*name.square);
  } else {
    name.inverse_of = read_poly(ring, k.at("inverse"), constant_);
    const PhaseFunction h{name.inverse_of, Integer(1)},
        times{read_poly(ring, k.at("times"), constant_), Integer(1)};
    need(!is_zero(h.p), "the inverse of 0");
    const MPoly norm = read_poly(ring, k.at("norm"), here_.free());
    need_equal(in().times(h, times), {norm, {1}}, "the norm is another one");
    SetProof(here_.given(), nodes_).show({norm, Sign::nonzero}, k.at("by"));
  }
  k.done();
  here_.tower().adjoin(std::move(name));
  known_[x] = constant_[x] = true;
}

PhaseFunction Map::element(const Node& n) const {
  PhaseFunction f = read_phase_function(in().ring(), n);
  if (!is_in(f.p, known_)) n.fail("a name that is not known here");
  return f;
}

void Map::need_constant(const PhaseFunction& f) const {
  need(is_in(f.p, constant_), "not a function of the parameters");
}

// ---- (M2)

void Map::read_values(const Node& n) {
  const PhaseSystem& y = *y_.system;
  need_no_functions(y);
  const std::vector<bool> used = used_names(y);
  Keys k(n);
  for (std::size_t i = 0; i < y.ring->size(); ++i) {
    const bool is_inverse = i >= y.first_inverse() && i < y.first_parameter();
    const bool is_function = i >= y.dimension && i < y.first_inverse();
    if (is_function || (is_inverse && !used[i])) continue;
    values_[i] = element(k.at(y.ring->name(i)));
    if (i >= y.first_parameter()) need_constant(*values_[i]);
  }
  k.done();
}

std::size_t Map::of_x(std::size_t j) const {
  const PhaseSystem& y = *y_.system;
  const auto i = x_.ring->find(y.ring->name(j));
  const bool is_coordinate = j < y.dimension;
  need(i && *i >= (is_coordinate ? 0 : x_.dimension) &&
           *i < (is_coordinate ? x_.dimension : x_.first_inverse()),
       "the system has another name");
  return *i;
}

// Levels have no value, if none is given.
void Map::read_names(const LevelValues& levels) {
  const PhaseSystem& y = *y_.system;
  for (std::size_t j = 0; j < y.first_inverse(); ++j)
    values_[j] = in().variable(of_x(j));
  std::size_t valued = 0;
  for (std::size_t j = y.first_parameter(); j < y.ring->size(); ++j) {
    const std::string& name = y.ring->name(j);
    const auto i = x_.ring->find(name);
    need(i || !y_.chosen.contains(name),
         "a level in the value of a function, or of what it depends on");
    if (const auto value = levels.find(name); value != levels.end()) {
      need(!i, "a level is expected");
      values_[j] = here_.put(value->second);
      ++valued;
    }
    if (!i) continue;
    need(here_.free()[*i], "a parameter that has a value");
    values_[j] = in().variable(*i);
  }
  need(valued == levels.size(), "a level is expected");
  for (std::size_t k = 0; k < y.inverses.size(); ++k)
    values_[y.first_inverse() + k] = here_.inverse(x_.ring->size() + k, phi(y.inverses[k]));
}

void Map::need_rows() {
  need(x_.dimension == y_.system->dimension, "another number of coordinates");
  for (std::size_t i = 0; i < x_.dimension; ++i)
    rows_.push_back(linear_part(*values_[i]));
}

Map::Row Map::linear_part(const PhaseFunction& f) {
  Row row(x_.dimension, in().zero());
  MPoly rest = f.p;
  for (std::size_t j = 0; j < x_.dimension; ++j) {
    const Coefficients c = coefficients(f.p, j);
    need(c.size() <= 2, "the map is not affine");
    if (c.size() < 2) continue;
    row[j] = {c[1], f.n};
    need_constant(row[j]);
    rest = a_.minus(rest, a_.times(c[1], MPoly::variable(in().ring(), j)));
  }
  need_constant({rest, f.n});
  moves_origin_ = moves_origin_ || !is_zero(rest);
  return row;
}

void Map::need_inverse(const Node& back) const {
  const std::size_t n = rows_.size();
  const char* const why = "a square matrix is expected";
  std::vector<Row> columns(n);
  for (const Node& line : back.items(n, why)) {
    const auto entries = line.items(n, why);
    for (std::size_t j = 0; j < n; ++j) {
      columns[j].push_back(element(entries[j]));
      need_constant(columns[j].back());
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      need_equal(in().dot(rows_[i], columns[j]), in().integer(i == j ? 1 : 0),
                 "not the inverse matrix");
}

PhaseFunction Map::unit(const Node& pair) const {
  const auto parts = pair.items(2, "a number and its inverse are expected");
  PhaseFunction c = element(parts[0]);
  const PhaseFunction d = element(parts[1]);
  need_constant(c);
  need_constant(d);
  need_equal(in().times(c, d), in().one(), "not an inverse");
  return c;
}

// ---- (M3), (T1)

void Map::need_same(const PhaseFunction& bracket, const PhaseFunction& energy) const {
  const PhaseSystem& y = *y_.system;
  for (std::size_t k = 0; k < y.inverses.size(); ++k)
    if (const auto& u = values_[y.first_inverse() + k])
      need_equal(in().times(*u, phi(y.inverses[k])), in().one(),
                 "the value of an inverse is another one");
  if (!y.hamiltonian) {
    Row field;
    for (const PhaseFunction& f : x_.field)
      field.push_back(here_.put(f));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      need_equal(in().dot(rows_[i], field), phi(y.field[i]), "another field");
    return;
  }
  need_equal(here_.put(*x_.hamiltonian), in().times(energy, phi(*y.hamiltonian)),
             "another Hamiltonian");
  const PhaseSpace theirs(y, a_);
  Row ours;
  for (const PhaseBracket& b : x_.brackets)
    ours.push_back(here_.put(b.value));
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    Row moved(x_.dimension, in().zero()); // by the bracket
    for (std::size_t k = 0; k < ours.size(); ++k) {
      const PhaseBracket& b = x_.brackets[k];
      moved[b.first] = in().plus(moved[b.first], in().times(ours[k], rows_[j][b.second]));
      moved[b.second] = in().minus(moved[b.second], in().times(ours[k], rows_[j][b.first]));
    }
    for (std::size_t i = 0; i < j; ++i)
      need_equal(in().dot(rows_[i], moved), in().times(bracket, phi(theirs.bracket(i, j))),
                 "another bracket");
  }
}

void Map::need_same_functions() const {
  const PhaseSystem& y = *y_.system;
  const PhaseSpace theirs(y, a_), ours(x_, a_);
  for (std::size_t f = 0; f < y.functions.size(); ++f)
    for (std::size_t j = 0; j < y.dimension; ++j) {
      const PhaseFunction* left = ours.slope(of_x(y.dimension + f) - x_.dimension, of_x(j));
      const PhaseFunction* right = theirs.slope(f, j);
      need_equal(left ? here_.put(*left) : in().zero(), right ? phi(*right) : in().zero(),
                 "another gradient");
    }
  std::vector<MPoly> here, there;
  for (const MPoly& q : x_.relations)
    here.push_back(here_.put({q, {1}}).p);
  for (const MPoly& r : y.relations)
    there.push_back(phi(r).p);
  const auto is_in = [](const std::vector<MPoly>& all, const MPoly& f) {
    return std::ranges::any_of(all, [&](const MPoly& g) { return is_multiple(f, g); });
  };
  for (const MPoly& f : there)
    need(is_in(here, f), "a relation that the system has not");
  for (const MPoly& f : here)
    need(is_in(there, f) || !has_function_of_y(f) || holds(f),
         "a relation does not hold along the curve");
}

bool Map::has_function_of_y(const MPoly& f) const {
  const auto used = used_variables(f);
  return std::ranges::any_of(used, [&](std::size_t i) {
    const auto j = y_.system->ring->find(in().ring()->name(i));
    return j && *j >= y_.system->dimension && *j < y_.system->first_inverse();
  });
}

bool Map::holds(const MPoly& f) const {
  const PhaseSystem& y = *y_.system;
  const Ring& ring = y.ring;
  for (const std::size_t i : used_variables(f)) {
    const auto j = ring->find(in().ring()->name(i));
    if (!j || (*j >= y.first_inverse() && *j < y.first_parameter()))
      return false; // another name of X
  }
  return y_.way && holds_on_curve(*y_.way, in_ring(f, ring), a_);
}

// ---- (M4), (T2)

void Map::need_shown(const Node& n) {
  const auto rows = n.items();
  std::size_t next = 0;
  for (const AskedCondition& c : y_.asked) {
    if (is_plain(c)) continue;
    if (next == rows.size()) n.fail("not everything is shown");
    const Node& row = rows[next++];
    by_name_ ? show_by_name(c, row) : c.group.empty() ? show(c, row) : show_group(c, row);
  }
  if (next != rows.size()) n.fail("more is shown than is needed");
}

// Nothing is to be shown of an equation between values, of what is real by its names, and of "c h + d > 0" for a
// level h alone, once for each: real values of h that satisfy it fill an interval.
bool Map::is_plain(const AskedCondition& c) {
  if (!c.group.empty()) return false;
  if (!by_name_) {
    if (c.real || c.sign != Sign::zero) return false;
    need_equal(phi(c.f), in().zero(), "an equation does not hold");
    return true;
  }
  const auto used = used_variables(c.f);
  if (c.real) {
    const std::vector<bool>& complex = stratum_.family->complex;
    for (const std::size_t j : used)
      for (const std::size_t i :
           values_[j] ? used_variables(values_[j]->p) : std::vector<std::size_t>{})
        need(complex.empty() || !complex[i], "a parameter that need not be real");
    return true;
  }
  if (!is_ordered(c.sign)) return false;
  if (used.size() != 1 || used[0] < y_.system->first_parameter() || values_[used[0]]) return false;
  need(coefficients(c.f, used[0]).size() == 2, "a condition on a level");
  need(bounded_.insert(used[0]).second, "two conditions on a level");
  return true;
}

void Map::show(const AskedCondition& c, const Node& n) {
  Keys k(n);
  PhaseFunction f = phi(c.f);
  bool real = c.real;
  Sign sign = c.sign;
  if (const auto square = k.find("square")) {
    if (!square->json().truth() || !*square->json().truth()) square->fail("true is expected");
    need(real || sign == Sign::nonzero, "a square has no other sign");
    f = in().times(f, f);
    if (std::exchange(real, false)) sign = Sign::positive;
  }
  const MPoly over = read_poly(in().ring(), k.at("over"), here_.free()),
              value = read_poly(in().ring(), k.at("value"), here_.free());
  need_value(f, over, value);
  const bool is_number = is_constant(over) && !is_zero(over);
  if (sign == Sign::nonnegative && !is_number) sign = Sign::positive;
  SetProof(here_.given(), nodes_)
      .show(real ? Condition{over, Sign::nonzero} : Condition{value, sign}, k.at("by"));
  k.done();
}

void Map::need_value(const PhaseFunction& f, const MPoly& over, const MPoly& value) const {
  need_constant(f);
  need_equal(in().times(f, {a_.times(over, over), {1}}), {value, {1}}, "another value");
}

// If all members were 0, the values would be.
void Map::show_group(const AskedCondition& c, const Node& n) {
  Keys k(n);
  std::vector<MPoly> values;
  for (const Node& chosen : k.at("chosen").items()) {
    const auto parts = chosen.items(3, "an index and two polynomials are expected");
    const long i = parts[0].count();
    if (i < 0 || static_cast<std::size_t>(i) >= c.group.size()) chosen.fail("no such member");
    const MPoly value = read_poly(in().ring(), parts[2], here_.free());
    need_value(phi(c.group[static_cast<std::size_t>(i)]),
               read_poly(in().ring(), parts[1], here_.free()), value);
    values.push_back(value);
  }
  SetProof(here_.given(), nodes_).show_some(values, k.at("by"));
  k.done();
}

void Map::show_by_name(const AskedCondition& c, const Node& by) {
  SetProof proof(here_.given(), nodes_);
  if (c.group.empty() && c.sign != Sign::nonzero) {
    const Parts parts = by_levels(c.f);
    const std::vector<unsigned long> none(y_.system->ring->size(), 0);
    need(parts.size() == 1 && parts.begin()->first == none, "a condition on a level");
    proof.show({parts.begin()->second, c.sign}, by);
    return;
  }
  std::vector<MPoly> all;
  for (const MPoly& f : c.group.empty() ? std::vector<MPoly>{c.f} : c.group)
    for (const auto& [levels, part] : by_levels(f))
      all.push_back(part);
  proof.show_some(all, by);
}

Map::Parts Map::by_levels(const MPoly& f) const {
  constexpr std::size_t max_parts = 500;
  const PhaseSystem& y = *y_.system;
  std::vector<bool> is_level(y.ring->size());
  for (std::size_t j = 0; j < is_level.size(); ++j) {
    need(j >= y.first_parameter() || !uses(f, j), "a condition on the parameters is expected");
    is_level[j] = !values_[j];
  }
  Parts parts = parts_by(f, is_level);
  need_within(parts.size() <= max_parts, "too many monomials in the levels");
  if (parts.empty()) parts.emplace(std::vector<unsigned long>(y.ring->size(), 0), MPoly(y.ring));
  for (auto& [levels, part] : parts)
    part = phi(part).p;
  return parts;
}

// ---- carried over

const IntegralClass& Map::carried(const IntegralClass& c) const {
  if (by_name_) return c;
  need(c.functions.empty() && c.through.empty() && c.frame.empty(),
       "a class that speaks of functions, or of coordinates of a frame");
  need(c.without.empty() || keeps_others(c.without),
       "a class without coordinates that the map mixes with others");
  need(c.kind != IntegralClass::Kind::real_analytic || !here_.tower().has_roots(),
       "a real system, and a root");
  need(c.near != IntegralClass::Near::origin || !moves_origin_, "the origin moves");
  if (c.near == IntegralClass::Near::level) need_level(rigid_level);
  return c;
}

// f = even + odd r, r^2 = s: f = 0 for both roots where both are 0, and for none where even^2 - odd^2 s is not.
Conditions Map::before(const Conditions& all) const {
  Conditions found;
  for (const Condition& c : all)
    found.push_back({phi(c.p).p, c.sign});
  const auto& steps = here_.tower().steps();
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (!step->square) continue;
    need(step->square->n == Integer(1), "a number below");
    for (const Condition& c : std::exchange(found, {})) {
      const auto [even, odd] = halves(c.p, step->variable, *step->square, a_);
      if (is_zero(odd)) {
        found.push_back({even, c.sign});
        continue;
      }
      need(c.sign == Sign::zero || c.sign == Sign::nonzero, "a sign that depends on a root");
      if (c.sign == Sign::zero) {
        found.push_back({even, c.sign});
        found.push_back({odd, c.sign});
      } else {
        const MPoly norm = a_.times(a_.times(odd, odd), step->square->p);
        found.push_back({a_.minus(a_.times(even, even), norm), c.sign});
      }
    }
  }
  for (Condition& c : found) {
    need(is_in(c.p, here_.free()), "a polynomial in the parameters is expected");
    c.p = in_ring(c.p, x_.ring);
  }
  return found;
}

bool Map::has_same_coordinates() const {
  const auto &x = x_.ring->names(), &y = y_.system->ring->names();
  const auto n = static_cast<std::ptrdiff_t>(x_.dimension);
  return x_.dimension == y_.system->dimension && std::equal(x.begin(), x.begin() + n, y.begin());
}

bool Map::keeps_others(const std::vector<std::string>& names) const {
  std::vector<bool> among(x_.dimension, false);
  for (const std::string& name : names) {
    const auto i = x_.ring->find(name);
    if (!i || *i >= x_.dimension) return false;
    among[*i] = true;
  }
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t k = 0; k < x_.dimension; ++k)
      if (!among[i] && among[k] && !is_zero(rows_[i][k].p)) return false;
  return has_same_coordinates();
}

void Map::need_level(const std::string& f) const {
  need(has_same_coordinates(), "other coordinates");
  const PhaseFunction here{in_ring(read_polynomial(x_.ring, f), in().ring()), Integer(1)};
  const PhaseFunction image = phi(read_polynomial(y_.system->ring, f));
  need(here_.tower().clears(in().minus(image, here)) ||
           here_.tower().clears(in().plus(image, here)),
       "another level");
}

// ---- as text

std::string Map::moved(std::size_t i, const char* arrow) const {
  const std::string& name = y_.system->ring->name(i);
  const PhaseFunction& f = *values_[i];
  const auto same = in().ring()->find(name);
  const bool stays = same && f.n == Integer(1) && f.p == MPoly::variable(in().ring(), *same);
  return stays ? "" : name + arrow + to_string(f);
}

std::string Map::adjoined() const {
  std::string where;
  for (const AdjoinedName& a : here_.tower().steps())
    if (a.variable >= x_.ring->size())
      where +=
          (where.empty() ? "where " : ", ") + in().ring()->name(a.variable) +
          (a.square ? "^2 = " + to_string(*a.square) : " = 1/(" + to_string(a.inverse_of) + ")");
  return where;
}

std::vector<std::string> Map::shown() const {
  const PhaseSystem& y = *y_.system;
  std::string names;
  for (std::size_t i = 0; i < y.ring->size(); ++i)
    if (i < y.dimension || i >= y.first_parameter())
      if (const std::string one = moved(i, " = "); !one.empty())
        names += (names.empty() ? "its names: " : ", ") + one;
  std::vector<std::string> all{names, adjoined()};
  std::erase(all, "");
  return all;
}

} // namespace kov::certify
