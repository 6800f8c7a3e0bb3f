#include "closed/kimura.hpp"

#include "closed/polyhedral.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {
namespace {

ExponentTriple sorted(ExponentTriple t) {
  std::ranges::sort(t, [](const Rational& a, const Rational& b) { return b < a; });
  return t;
}

Rational sum(const ExponentTriple& t) { return t[0] + t[1] + t[2]; }

// The member of least sum (then of greatest entries) of the orbit: fold every entry into [0, 1];
// what is left is x -> 1 - x for two entries at a time.
ExponentTriple canonical(const ExponentTriple& t) {
  std::optional<ExponentTriple> best;
  for (int pattern = 0; pattern < 4; ++pattern) { // which two are turned; 3 = none
    ExponentTriple u;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      u[at] = folded(t[at]);
      if (pattern != 3 && i != pattern) u[at] = Rational(1) - u[at];
    }
    u = sorted(u);
    if (!best || sum(u) < sum(*best) || (sum(u) == sum(*best) && *best < u)) best = u;
  }
  return *best;
}

bool is_half_integer(const Rational& q) { return q.den() == Integer(2); }

// Two exponents in 1/2 + Z: the group lies in the normaliser of a torus.
bool dihedral(const ExponentTriple& t) { return std::ranges::count_if(t, is_half_integer) >= 2; }

// Half the traces of p, q and pq, sorted: the exponents, and whether p and q generate an irreducible
// group, depend on them only.
std::array<Surd, 3> half_traces(const PolyhedralGroup& g, const Quaternion& p,
                                const Quaternion& q) {
  std::array<Surd, 3> w{p[0], q[0], g.real_part_of_product(p, q)};
  std::ranges::sort(w);
  return w;
}

std::set<ExponentTriple> triples_in(const PolyhedralGroup& g) {
  std::set<std::array<Surd, 3>> seen;
  std::set<ExponentTriple> classes;
  for (std::size_t a = 0; a < g.elements().size(); ++a)
    for (std::size_t b = a; b < g.elements().size(); ++b) { // (B, A) has the traces of (A, B)
      const Quaternion& p = g.elements()[a];
      const Quaternion& q = g.elements()[b];
      const auto w = half_traces(g, p, q);
      if (!seen.insert(w).second || !g.irreducible(p, q)) continue;
      const ExponentTriple t{g.exponent_of_real_part(w[0]), g.exponent_of_real_part(w[1]),
                             g.exponent_of_real_part(w[2])};
      if (!dihedral(t)) classes.insert(canonical(t));
    }
  return classes;
}

std::vector<SchwarzClass> generate() {
  std::vector<SchwarzClass> rows;
  std::set<ExponentTriple> seen; // of a smaller group: an irreducible pair is known by its traces
  for (const GroupType type : {GroupType::A4, GroupType::S4, GroupType::A5})
    for (const ExponentTriple& t : triples_in(PolyhedralGroup(type))) {
      if (!seen.insert(t).second) continue;
      const bool even = canonical({t[0] + Rational(1), t[1], t[2]}) != t;
      rows.push_back({t, even, type});
    }
  return rows;
}

std::string text(const ExponentTriple& t) {
  return "(" + to_string(t[0]) + ", " + to_string(t[1]) + ", " + to_string(t[2]) + ")";
}

// The entries collected for abelian_third_exponents: nu = +-key modulo 2.
using Found = std::map<Rational, AbelianRiemann>;

void add_reducible(Found& found, const Rational& l, const Rational& m) {
  for (const Rational& nu : {l + m + Rational(1), l - m + Rational(1)})
    found.try_emplace(folded(nu));
}

// l = +-x + i, m = +-y + j (modulo 2) allows nu = +-z + i + j.
void add_row(Found& found, const SchwarzClass& row, const Rational& l, const Rational& m) {
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        const Rational& x = row.exponents[order[0]];
        const Rational& y = row.exponents[order[1]];
        const Rational& z = row.exponents[order[2]];
        if (folded(l) == folded(x + Rational(i)) && folded(m) == folded(y + Rational(j)))
          found.try_emplace(folded(z + Rational(i + j)), AbelianRiemann{&row});
      }
  } while (std::next_permutation(order.begin(), order.end()));
}

} // namespace

Rational folded(const Rational& q) {
  const Rational rest = q - Rational(Integer(2) * floor(q / Rational(2)));
  return rest > Rational(1) ? Rational(2) - rest : rest;
}

const std::vector<SchwarzClass>& schwarz_classes() {
  static const std::vector<SchwarzClass> rows = generate();
  return rows;
}

const SchwarzClass* schwarz_class(const ExponentTriple& exponents) {
  for (const Rational& e : exponents) // no element of the three groups has a larger order in PSL2
    if (e.den() > Integer(5)) return nullptr;
  const ExponentTriple t = canonical(exponents);
  for (const SchwarzClass& row : schwarz_classes())
    if (row.exponents == t) return &row;
  return nullptr;
}

std::string sentence(const AbelianRiemann& a) {
  if (a.row != nullptr) return to_string(a.row->group) + ": the row " + text(a.row->exponents);
  return a.dihedral ? "dihedral: two exponents in 1/2 + Z"
                    : "reducible: l +- m +- nu is an odd integer";
}

Classes ThirdExponents::nu() const {
  Classes all;
  for (const ExponentClass& c : classes)
    all.push_back(c.nu);
  return all;
}

ThirdExponents abelian_third_exponents(const Rational& l, const Rational& m) {
  ThirdExponents answer;
  if (is_half_integer(l) && is_half_integer(m)) {
    answer.all = true;
    return answer;
  }
  Found found;
  add_reducible(found, l, m);
  if (is_half_integer(l) || is_half_integer(m))
    found.try_emplace(Rational(1, 2), AbelianRiemann{nullptr, true});
  for (const SchwarzClass& row : schwarz_classes())
    add_row(found, row, l, m);
  for (const auto& [nu0, by] : found) {
    const Rational other = Rational(1) - nu0; // nu0 and 1 - nu0 modulo 2 are +-nu0 modulo 1
    const bool both = found.contains(other);
    if (both && other < nu0) continue;
    answer.classes.push_back({{nu0, Rational(both ? 1 : 2)}, by});
  }
  return answer;
}

} // namespace kov
