#include "certify/theorem/place.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/check.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {

void Family::need_parameters(const MPoly& f) const {
  for (const std::size_t i : used_variables(f))
    need(is_parameter(i), "a polynomial in the parameters is expected");
}

Conditions Family::region(const Node& n) const {
  Conditions all = read_conditions(system.ring, n);
  for (const Condition& c : all)
    need_parameters(c.p);
  return all;
}

bool Family::is_plain() const {
  return system.hamiltonian && system.functions.empty() && system.relations.empty() &&
         std::ranges::none_of(complex, [](bool x) { return x; });
}

ConditionSet Family::where(const Conditions& given, Arithmetic& a) const {
  std::vector<bool> names(system.ring->size(), false), real = names;
  for (std::size_t i = system.first_parameter(); i < real.size(); ++i) {
    names[i] = true;
    real[i] = complex.empty() || !complex[i];
  }
  ConditionSet s(system.ring, a, std::move(names), std::move(real));
  for (const Condition& c : given)
    s.assume(c);
  return s;
}

Target target_of(const Family& f, const Conditions& region, bool real) {
  Target t{&f.system, {}};
  for (std::size_t i = f.system.first_parameter(); real && i < f.system.ring->size(); ++i)
    t.asked.push_back({true, Sign::nonzero, MPoly::variable(f.system.ring, i)});
  for (const Conditions* all : {&f.assumptions, &region})
    for (const Condition& c : *all)
      t.asked.push_back({false, c.sign, c.p});
  return t;
}

std::vector<bool> used_names(const PhaseSystem& s) {
  std::vector<bool> used(s.ring->size(), false);
  std::vector<MPoly> left;
  if (s.hamiltonian) left.push_back(s.hamiltonian->p);
  for (const PhaseBracket& b : s.brackets)
    left.push_back(b.value.p);
  for (const PhaseFunction& f : s.field)
    left.push_back(f.p);
  while (!left.empty()) {
    const MPoly f = std::move(left.back());
    left.pop_back();
    for (const std::size_t i : used_variables(f)) {
      if (used[i]) continue;
      used[i] = true;
      if (i >= s.first_inverse() && i < s.first_parameter())
        left.push_back(s.inverses[i - s.first_inverse()]);
      if (i >= s.dimension && i < s.first_inverse())
        for (const auto& [j, g] : s.functions[i - s.dimension].gradient)
          left.push_back(g.p);
    }
  }
  return used;
}

void need_no_functions(const PhaseSystem& s) {
  const std::vector<bool> used = used_names(s);
  for (std::size_t i = s.dimension; i < s.first_inverse(); ++i)
    need(!used[i], "a function occurs in the system");
}

Map::Map(const Family& x, const ParameterFunctions& at, const Conditions& region, const Target& y,
         Keys& data, Arithmetic& a, std::size_t& nodes_left)
    : x_(x), y_(y), a_(a), nodes_(nodes_left) {
  const Node adjoined = data.at("adjoined");
  read_names(adjoined);
  start(at);
  given_.emplace(ring_, a_, free_, free_);
  for (const Conditions* all : {&x_.assumptions, &region})
    for (const Condition& c : *all)
      given_->assume(primitive(Condition{moved({c.p, Integer(1)}).p, c.sign}));
  for (const Node& n : adjoined.items())
    adjoin(n);
  read_values(data.at("values"));
  need_change(data.at("back"));
  const PhaseFunction bracket = unit(data.at("bracket"));
  need_same(bracket, unit(data.at("energy")));
  need_shown(data.at("shown"));
}

void Map::read_names(const Node& adjoined) {
  auto names = x_.system.ring->names();
  for (const Node& n : adjoined.items())
    names.push_back(Keys(n).at("name").text());
  if (names.size() > max_phase_names) adjoined.fail("more than 64 names");
  for (const std::string& s : names)
    if (!is_name(s) || std::ranges::count(names, s) != 1)
      adjoined.fail("different names of letters, digits and _ are expected");
  ring_ = make_ring(names);
  functions_ = std::make_unique<Functions>(ring_, a_);
  tower_ = std::make_unique<Tower>(*functions_);
}

// (M1): the inverses of X, with `at` put in.
void Map::start(const ParameterFunctions& at) {
  const PhaseSystem& s = x_.system;
  const std::size_t old = s.ring->size();
  constant_.assign(ring_->size(), false);
  known_.assign(ring_->size(), false);
  put_.resize(old);
  for (std::size_t i = 0; i < old; ++i) {
    known_[i] = !at.contains(i);
    constant_[i] = known_[i] && x_.is_parameter(i);
    put_[i] = in().variable(i);
  }
  free_ = constant_;
  for (const auto& [i, f] : at)
    put_[i] = PhaseFunction{in_ring(f.p, ring_), f.n};
  for (std::size_t k = 0; k < s.inverses.size(); ++k) {
    const std::size_t u = s.first_inverse() + k;
    const PhaseFunction h = moved({s.inverses[k], Integer(1)});
    need(!is_zero(h.p), "a denominator is 0");
    const MPoly p = primitive(h.p); // h = c p/n
    tower_->adjoin({u, std::nullopt, p});
    put_[u] = PhaseFunction{scaled(MPoly::variable(ring_, u), h.n),
                            exact_div(h.p.coefficient(0), p.coefficient(0))};
  }
}

PhaseFunction Map::moved(const PhaseFunction& f) const { return in().composed(f, put_); }

std::string Map::moved(std::size_t i, const char* arrow) const {
  const std::string& name = y_.system->ring->name(i);
  const PhaseFunction& f = *values_[i];
  const auto same = ring_->find(name);
  const bool stays = same && f.n == Integer(1) && f.p == MPoly::variable(ring_, *same);
  return stays ? "" : name + arrow + to_string(f);
}

std::string Map::adjoined() const {
  std::string where;
  for (const AdjoinedName& a : tower_->steps())
    if (a.variable >= x_.system.ring->size())
      where +=
          (where.empty() ? "where " : ", ") + ring_->name(a.variable) +
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

// f = even + odd r, r^2 = s: f = 0 for both roots where both are 0, and for none where even^2 - odd^2 s is not.
Conditions Map::before(const Conditions& all) const {
  Conditions found;
  for (const Condition& c : all)
    found.push_back({phi(c.p).p, c.sign});
  const auto& steps = tower_->steps();
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
    if (!step->square) continue;
    need(step->square->n == Integer(1), "a number below");
    const MPoly& square = step->square->p;
    for (const Condition& c : std::exchange(found, {})) {
      const Coefficients rows = coefficients(c.p, step->variable);
      MPoly half[2] = {MPoly(ring_), MPoly(ring_)};
      for (std::size_t k = rows.size(); k-- > 0;)
        half[k % 2] = a_.plus(a_.times(half[k % 2], square), rows[k]);
      const auto& [even, odd] = half;
      if (is_zero(odd)) {
        found.push_back({even, c.sign});
        continue;
      }
      need(c.sign == Sign::zero || c.sign == Sign::nonzero, "a sign that depends on a root");
      if (c.sign == Sign::zero) {
        found.push_back({even, c.sign});
        found.push_back({odd, c.sign});
      } else {
        const MPoly norm = a_.times(a_.times(odd, odd), square);
        found.push_back({a_.minus(a_.times(even, even), norm), c.sign});
      }
    }
  }
  for (Condition& c : found) {
    need(is_in(c.p, free_), "a polynomial in the parameters is expected");
    c.p = in_ring(c.p, x_.system.ring);
  }
  return found;
}

PhaseFunction Map::element(const Node& n) const {
  PhaseFunction f = read_phase_function(ring_, n);
  if (!is_in(f.p, known_)) n.fail("a name that is not known here");
  if (is_zero(f.n)) n.fail("a number is 0");
  return f;
}

void Map::need_constant(const PhaseFunction& f) const {
  need(is_in(f.p, constant_), "not a function of the parameters");
}

void Map::adjoin(const Node& n) {
  Keys k(n);
  const std::size_t x = ring_->index(k.at("name").text());
  AdjoinedName name{x, std::nullopt, MPoly(ring_)};
  if (const auto square = k.find("square")) {
    name.square = element(*square);
    need_constant(*name.square);
  } else {
    name.inverse_of = read_poly(ring_, k.at("inverse"), constant_);
    const PhaseFunction h{name.inverse_of, Integer(1)},
        times{read_poly(ring_, k.at("times"), constant_), Integer(1)};
    need(!is_zero(h.p), "the inverse of 0");
    const MPoly norm = read_poly(ring_, k.at("norm"), free_);
    need(tower_->clears(in().minus(in().times(h, times), {norm, Integer(1)})),
         "the norm is another one");
    SetProof(*given_, nodes_).show({norm, Sign::nonzero}, k.at("by"));
  }
  k.done();
  tower_->adjoin(std::move(name));
  known_[x] = constant_[x] = true;
}

// (M2)
void Map::read_values(const Node& n) {
  const PhaseSystem& y = *y_.system;
  need_no_functions(y);
  const std::vector<bool> used = used_names(y);
  values_.resize(y.ring->size());
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

PhaseFunction Map::put_in(const PhaseFunction& f) const { return in().composed(f, values_); }
PhaseFunction Map::phi(const MPoly& f) const { return put_in({f, Integer(1)}); }

Map::Row Map::linear_part(const PhaseFunction& f) {
  Row row;
  MPoly rest = f.p;
  for (std::size_t j = 0; j < x_.system.dimension; ++j) {
    const Coefficients c = coefficients(f.p, j);
    need(c.size() <= 2, "the map is not affine");
    row.push_back(c.size() == 2 ? PhaseFunction{c[1], f.n} : in().zero());
    need_constant(row.back());
    if (c.size() == 2) rest = a_.minus(rest, a_.times(c[1], MPoly::variable(ring_, j)));
  }
  need_constant({rest, f.n});
  moves_origin_ = moves_origin_ || !is_zero(rest);
  return row;
}

void Map::need_change(const Node& back) {
  const std::size_t n = x_.system.dimension;
  need(n == y_.system->dimension, "another number of coordinates");
  for (std::size_t i = 0; i < n; ++i)
    s_.push_back(linear_part(*values_[i]));
  const auto rows = back.items();
  if (rows.size() != n) back.fail("a square matrix is expected");
  Square inverse;
  for (const Node& row : rows) {
    inverse.emplace_back();
    for (const Node& entry : row.items()) {
      inverse.back().push_back(element(entry));
      need_constant(inverse.back().back());
    }
    if (inverse.back().size() != n) row.fail("a square matrix is expected");
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      PhaseFunction sum = in().zero();
      for (std::size_t k = 0; k < n; ++k)
        sum = in().plus(sum, in().times(s_[i][k], inverse[k][j]));
      need(tower_->clears(i == j ? in().minus(sum, in().one()) : sum), "not the inverse matrix");
    }
}

PhaseFunction Map::unit(const Node& pair) const {
  const auto parts = pair.items();
  if (parts.size() != 2) pair.fail("a number and its inverse are expected");
  PhaseFunction c = element(parts[0]);
  const PhaseFunction d = element(parts[1]);
  need_constant(c);
  need_constant(d);
  need(tower_->clears(in().minus(in().times(c, d), in().one())), "not an inverse");
  return c;
}

// (M3)
void Map::need_same(const PhaseFunction& bracket, const PhaseFunction& energy) const {
  const PhaseSystem &x = x_.system, &y = *y_.system;
  const PhaseSpace theirs(y, a_);
  for (std::size_t k = 0; k < y.inverses.size(); ++k)
    if (const auto& u = values_[y.first_inverse() + k])
      need(tower_->clears(in().minus(in().times(*u, phi(y.inverses[k])), in().one())),
           "the value of an inverse is another one");
  need(
      tower_->clears(in().minus(moved(*x.hamiltonian), in().times(energy, put_in(*y.hamiltonian)))),
      "another Hamiltonian");
  for (std::size_t i = 0; i < x.dimension; ++i)
    for (std::size_t j = i + 1; j < x.dimension; ++j) {
      PhaseFunction sum = in().zero();
      for (const PhaseBracket& b : x.brackets) {
        const auto part = in().minus(in().times(s_[i][b.first], s_[j][b.second]),
                                     in().times(s_[i][b.second], s_[j][b.first]));
        if (!is_zero(part.p)) sum = in().plus(sum, in().times(part, moved(b.value)));
      }
      need(tower_->clears(in().minus(sum, in().times(bracket, put_in(theirs.bracket(i, j))))),
           "another bracket");
    }
}

bool Map::has_same_coordinates() const {
  const PhaseSystem &x = x_.system, &y = *y_.system;
  bool same = x.dimension == y.dimension;
  for (std::size_t i = 0; same && i < x.dimension; ++i)
    same = x.ring->name(i) == y.ring->name(i);
  return same;
}

bool Map::keeps_others(const std::vector<std::string>& names) const {
  std::vector<bool> among(s_.size(), false);
  bool kept = has_same_coordinates();
  for (const std::string& name : names) {
    const auto i = x_.system.ring->find(name);
    kept = kept && i && *i < among.size();
    if (kept) among[*i] = true;
  }
  for (std::size_t i = 0; kept && i < among.size(); ++i)
    for (std::size_t j = 0; kept && !among[i] && j < among.size(); ++j)
      kept = !among[j] || is_zero(s_[i][j].p);
  return kept;
}

void Map::need_level(const std::string& f) const {
  const PhaseSystem &x = x_.system, &y = *y_.system;
  need(has_same_coordinates(), "other coordinates");
  const PhaseFunction here{in_ring(read_polynomial(x.ring, f), ring_), Integer(1)};
  const PhaseFunction image = phi(read_polynomial(y.ring, f));
  need(tower_->clears(in().minus(image, here)) || tower_->clears(in().plus(image, here)),
       "another level");
}

// (M4)
void Map::need_shown(const Node& n) {
  const auto rows = n.items();
  std::size_t next = 0;
  for (const AskedCondition& c : y_.asked) {
    if (!c.real && c.sign == Sign::zero) {
      need(tower_->clears(phi(c.f)), "an equation does not hold");
      continue;
    }
    if (next == rows.size()) n.fail("not everything is shown");
    const Node& row = rows[next++];
    if (!c.group.empty()) {
      need_group(c, row);
      continue;
    }
    Keys k(row);
    PhaseFunction f = phi(c.f);
    bool real = c.real;
    Sign sign = c.sign;
    if (const auto square = k.find("square")) {
      if (!square->json().truth() || !*square->json().truth()) square->fail("true is expected");
      need(real || sign == Sign::nonzero, "a square has no other sign");
      f = in().times(f, f);
      if (std::exchange(real, false)) sign = Sign::positive;
    }
    const MPoly over = read_poly(ring_, k.at("over"), free_),
                value = read_poly(ring_, k.at("value"), free_);
    need_value(f, over, value);
    const bool is_number = is_constant(over) && !is_zero(over);
    if (sign == Sign::nonnegative && !is_number) sign = Sign::positive;
    SetProof(*given_, nodes_)
        .show(real ? Condition{over, Sign::nonzero} : Condition{value, sign}, k.at("by"));
    k.done();
  }
  if (next != rows.size()) n.fail("more is shown than is needed");
}

void Map::need_value(const PhaseFunction& f, const MPoly& over, const MPoly& value) const {
  need_constant(f);
  const PhaseFunction square{a_.times(over, over), Integer(1)};
  need(tower_->clears(in().minus(in().times(f, square), {value, Integer(1)})), "another value");
}

// If all members were 0, the values would be.
void Map::need_group(const AskedCondition& c, const Node& n) {
  Keys k(n);
  std::vector<MPoly> values;
  for (const Node& chosen : k.at("chosen").items()) {
    const auto parts = chosen.items();
    if (parts.size() != 3) chosen.fail("an index and two polynomials are expected");
    const long i = parts[0].count();
    if (i < 0 || static_cast<std::size_t>(i) >= c.group.size()) chosen.fail("no such member");
    const MPoly value = read_poly(ring_, parts[2], free_);
    need_value(phi(c.group[static_cast<std::size_t>(i)]), read_poly(ring_, parts[1], free_), value);
    values.push_back(value);
  }
  SetProof(*given_, nodes_).show_some(values, k.at("by"));
  k.done();
}

} // namespace kov::certify
