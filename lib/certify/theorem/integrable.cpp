#include "certify/theorem/computed.hpp"

#include "certify/equation/facts.hpp"
#include "certify/system/phase_space.hpp"
#include "certify/theorem/rules.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <utility>

namespace kov::certify {

namespace {

// The remainder of f by a divisor whose leading coefficient in v is a number, up to a number.
MPoly remainder_in(const MPoly& f, const Coefficients& divisor, std::size_t v, Arithmetic& a) {
  const Coefficients rest = Elimination(a).pseudo_remainder(coefficients(f, v), divisor);
  MPoly sum(f.ring());
  for (std::size_t k = 0; k < rest.size(); ++k)
    sum = a.plus(sum, a.times(rest[k], pow(MPoly::variable(f.ring(), v), k)));
  return sum;
}

using Square = std::vector<std::vector<PhaseFunction>>;

// ---- first integrals

/// The functions and fields of X with their derivatives.
class IntegralsOnStratum {
public:
  IntegralsOnStratum(const StepPlace& x, Arithmetic& a)
      : s_(x.family->system), a_(a), on_(x, {}, a), space_(s_, a), field_(space_.field()) {
    for (const MPoly& r : s_.relations)
      add_monic(on_.put({r, Integer(1)}).p);
    for (const Condition& c : on_.given().conditions())
      if (c.sign == Sign::zero) equations_.push_back(c.p);
  }

  [[nodiscard]] Here& on() { return on_; }
  [[nodiscard]] const PhaseSpace& space() const { return space_; }
  [[nodiscard]] const std::vector<PhaseFunction>& field() const { return field_; }

  /// Is f cleared to 0, also modulo relations that are monic in a function of their own and equations
  /// of the stratum that are monic in a parameter?
  [[nodiscard]] bool vanishes(const PhaseFunction& f) const {
    MPoly p = on_.tower().cleared(on_.put(f).p);
    for (auto r = relations_.rbegin(); r != relations_.rend(); ++r)
      p = remainder_in(p, r->second, r->first, a_);
    return is_zero(modulo_equations(p, equations_, a_));
  }
  [[nodiscard]] Square gradients(const ClaimedIntegrals& c) const {
    Square rows;
    for (const auto& [name, f] : c.claims)
      rows.push_back(space_.gradient(f));
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
    MPoly f = on_.tower().cleared(determinant(m));
    Elimination e(a_); // for all branches of the functions; other functions stay
    for (auto r = relations_.rbegin(); r != relations_.rend(); ++r) {
      if (!uses(f, r->first)) continue;
      const Coefficients rest = e.pseudo_remainder(coefficients(f, r->first), r->second);
      f = rest.empty()       ? MPoly(f.ring())
          : rest.size() == 1 ? rest[0]
                             : e.resultant(r->second, rest);
    }
    return f;
  }

private:
  // Times a number: each row over its common denominator.
  [[nodiscard]] MPoly determinant(const Square& m) const {
    std::vector<std::vector<MPoly>> rows;
    for (const auto& row : m) {
      Integer n(1);
      for (const PhaseFunction& f : row)
        n = a_.common_multiple(n, f.n);
      rows.emplace_back();
      for (const PhaseFunction& f : row)
        rows.back().push_back(a_.scaled(f.p, exact_div(n, f.n)));
    }
    return rows.empty() ? on_.in().one().p : Elimination(a_).determinant(std::move(rows));
  }
  // The coefficients in the last of the functions of a relation, if the leading one is a number; the first such
  // relation of a function counts.
  void add_monic(const MPoly& r) {
    for (std::size_t v = s_.first_inverse(); v-- > s_.dimension;) {
      if (!uses(r, v)) continue;
      Coefficients c = coefficients(r, v);
      if (is_constant(c.back())) relations_.emplace(v, std::move(c));
      return;
    }
  }

  const PhaseSystem& s_;
  Arithmetic& a_;
  Here on_;
  PhaseSpace space_;
  std::vector<PhaseFunction> field_;
  std::map<std::size_t, Coefficients> relations_; ///< monic in this function, the last one in them
  std::vector<MPoly> equations_;                  ///< of the stratum
};

class Integrability {
public:
  Integrability(const StepPlace& x, Keys& data, Arithmetic& a, std::size_t& nodes)
      : x_(x), s_(x.family->system), nodes_(nodes), data_(data), in_(x, a) {}

  ClaimedIntegrals operator()() {
    all_.family = x_.family;
    for (const Node& n : data_.at("claims").items()) {
      Keys k(n);
      const std::string name = k.at("name").text();
      all_.claims.emplace_back(name, read_function(*x_.family, k.at("value")));
      k.done();
    }
    for (const Node& row : data_.at("fields").items())
      all_.fields.push_back(
          mapped<PhaseFunction>(row.items(s_.dimension, "an entry for each coordinate is expected"),
                                [&](const Node& n) { return read_function(*x_.family, n); }));
    const Square rows = in_.gradients(all_);
    for (const auto& df : rows)
      need_zero(in().dot(in_.field(), df), "not a first integral");
    s_.hamiltonian ? need_liouville(rows) : need_commuting(rows);
    return std::move(all_);
  }

private:
  [[nodiscard]] const Functions& in() const { return in_.space().in(); }
  void need_zero(const PhaseFunction& f, const char* why) { need(in_.vanishes(f), why); }

  // In involution; as many as the rank of the bracket asks for.
  void need_liouville(const Square& rows) {
    need(all_.fields.empty(), "fields beside a bracket");
    const Square structure = in_.structure();
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = i + 1; j < rows.size(); ++j) {
        std::vector<PhaseFunction> moved;
        for (const auto& row : structure)
          moved.push_back(in().dot(row, rows[j]));
        need_zero(in().dot(rows[i], moved), "not in involution");
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
        need_zero(in().dot(y, df), "not constant along a field");
    for (std::size_t i = 0; i < fields.size(); ++i)
      for (std::size_t j = i + 1; j < fields.size(); ++j)
        need_commute(fields[i], fields[j]);
    if (!rows.empty() || !data_.at("independent").is_null())
      need_minor("independent", "independence", rows, rows.size());
    if (rows.size() == s_.dimension && all_.fields.empty()) { // all points are equilibria
      need(data_.at("rank").is_null(), "no rank is asked for");
      return;
    }
    need(fields.size() + rows.size() == s_.dimension, "not as many integrals as are needed");
    need_minor("rank", "the rank", fields, fields.size());
  }
  void need_commute(const std::vector<PhaseFunction>& x, const std::vector<PhaseFunction>& y) {
    for (std::size_t j = 0; j < s_.dimension; ++j)
      need_zero(in().minus(in_.space().along(x, y[j]), in_.space().along(y, x[j])),
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
    SetProof proof(in_.on().given(), nodes_);
    show_value(k, x_, c, Sign::nonzero, proof, "another value");
    k.done();
  }
  [[nodiscard]] std::vector<std::size_t> coordinates(const Node& n) const {
    std::vector<std::size_t> all;
    for (const Node& x : n.items()) {
      all.push_back(read_coordinate(s_, x));
      need(std::ranges::count(all, all.back()) == 1, "a coordinate is expected");
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
    const auto items = n.items(s_.dimension, "an exponent for each coordinate is expected");
    const auto exponents = mapped<long>(items, [](const Node& x) { return x.count(); });
    std::vector<bool> coordinates(s_.ring->size(), false);
    std::fill_n(coordinates.begin(), s_.dimension, true);
    MPoly found(s_.ring);
    for (const auto& [e, part] : parts_by(f, coordinates)) {
      bool is_here = true, is_beside = true;
      for (std::size_t j = 0; j < s_.dimension; ++j) {
        const bool same = static_cast<long>(e[j]) == exponents[j];
        is_here = is_here && same;
        is_beside = is_beside && (same || is_argument(j));
      }
      for (std::size_t j = s_.dimension; j < s_.first_parameter(); ++j)
        need(!is_beside || !uses(part, j), "a name that is not a parameter");
      if (is_here) found = part;
    }
    return found;
  }

  static constexpr std::size_t max_minor = 8;

  const StepPlace& x_;
  const PhaseSystem& s_;
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

Said rule::integrable(Keys& step, Derivation& d) {
  const StepPlace here = d.place(step, d.family(step));
  Said f{FactKind::integrable, here.family, {here.conditions()}};
  f.integrals.push_back(Integrability(here, step, d.arithmetic(), d.nodes())());
  for (const std::string& what : f.integrals.front().not_shown)
    f.trusts.insert({d.id(), what});
  return f;
}

MPoly minor_of(const StepPlace& x, const ClaimedIntegrals& c, bool rank,
               const std::vector<std::size_t>& columns, Arithmetic& a) {
  const IntegralsOnStratum in(x, a);
  const bool bracket = x.family->system.hamiltonian.has_value();
  return in.minor(!rank ? in.gradients(c) : bracket ? in.structure() : in.fields(c), columns);
}

} // namespace kov::certify
