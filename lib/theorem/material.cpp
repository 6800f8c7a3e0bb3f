#include "theorem/material.hpp"

#include "exact/joined.hpp"
#include "integrability/way.hpp"
#include "linode/singularities.hpp"

#include "decide/words.hpp"
#include "exact/algebraic.hpp"
#include "exact/error.hpp"
#include "strata/words.hpp"

#include <algorithm>

namespace kov {
namespace {

std::string difference(const Singularity& s, const std::string& z) {
  if (s.kind == PlaceKind::ramified) return "irregular, ramified";
  if (s.kind == PlaceKind::irregular) return "irregular";
  if (s.delta) return to_string(*s.delta);
  return "sqrt(" + to_string(RationalFunction(s.delta_squared), z) + ")";
}

std::vector<std::string> row_of(const Singularity& s, const std::string& z) {
  const std::string place =
      s.at_infinity ? "infinity" : to_string(RationalFunction(s.place), z) + " = 0";
  return {place, std::to_string(s.order), difference(s, z),
          s.log == Truth::yes  ? "yes"
          : s.log == Truth::no ? "no"
                               : "not asked"};
}

// The roots of the places, as numbers for the eye.
PolePicture picture_of(const Singularities& all, const std::string& z, const std::string& where) {
  PolePicture picture{"Singular points of r in the " + z + "-plane" + where +
                          "; at each the exponent difference, filled: a logarithm",
                      "Re " + z,
                      "Im " + z,
                      {},
                      false};
  for (const Singularity& s : all.finite) {
    if (!s.place.field()->is_rational() || s.degree() > 24) continue;
    std::vector<Integer> c;
    Integer common(1);
    for (long i = 0; i <= s.degree(); ++i)
      common = lcm(common, to_rational(s.place.coeff(i)).den());
    for (long i = 0; i <= s.degree(); ++i)
      c.push_back((to_rational(s.place.coeff(i)) * Rational(common)).num());
    for (const QQbar& root : roots(c)) {
      const ComplexBall x = enclosure(root, 64);
      Ball re, im;
      acb_get_real(re.raw(), x.raw());
      acb_get_imag(im.raw(), x.raw());
      picture.points.push_back(
          {lower_bound(re), lower_bound(im), difference(s, z), s.log == Truth::yes});
    }
  }
  return picture;
}

void show_decision(NodeResult& n, const Decision& d, const std::string& where = {}) {
  if (is_zero(d.r)) return;
  const Singularities s = singularities(d.r);
  Grid exponents{"Exponent differences" + where, {"place", "order", "difference", "logarithm"}, {}};
  for (const Singularity& one : s.finite)
    exponents.rows.push_back(row_of(one, d.variable));
  exponents.rows.push_back(row_of(s.infinity, d.variable));
  n.tables.push_back(std::move(exponents));
  n.pictures.push_back(picture_of(s, d.variable, where));
  n.formulas.push_back({"group", d.group ? describe(*d.group) : "not determined"});
}

std::string answer(Truth abelian) {
  return abelian == Truth::yes ? "abelian" : abelian == Truth::no ? "not abelian" : "undecided";
}

void show_strata(NodeResult& n, const strata::StrataAnswer& a, const std::string& where = {}) {
  Grid grid{"Strata of the parameters" + where + ", with the identity component of the group",
            {"stratum", "group", "identity component", "because"},
            {}};
  for (const strata::Stratum& s : a.strata)
    grid.rows.push_back({to_string(s.conditions), strata::group_text(s.leaf),
                         answer(s.leaf.abelian), strata::reason(s.leaf)});
  for (const std::string& u : a.unvisited)
    grid.rows.push_back({u, "", "undecided", "a limit was reached"});
  n.tables.push_back(std::move(grid));
}

// "c", or what comes after it in the alphabet, so that no name c0, c1, ... is taken.
std::string free_letter(const Ring& ring, std::size_t indices) {
  for (char letter = 'c'; letter <= 'z'; ++letter) {
    const auto taken = [&](std::size_t k) {
      return ring->find(letter + std::to_string(k)).has_value();
    };
    bool is_free = true;
    for (std::size_t k = 0; k < indices; ++k)
      is_free = is_free && !taken(k);
    if (is_free) return {letter};
  }
  return "coefficient";
}

// r(z) whole: a long numerator by powers of z, with names for the coefficients.
void show_equation(NodeResult& n, const MFraction& r, const Ring& ring, std::size_t z) {
  constexpr std::size_t fits_a_line = 160;
  const std::string label = "r(" + ring->name(z) + ")";
  const std::string whole = to_factored_string(r);
  if (whole.size() <= fits_a_line || degree(r.num(), z) < 1) {
    n.formulas.push_back({label, whole});
    return;
  }
  const auto coefficient = coefficients(r.num(), z);
  const std::string letter = free_letter(ring, coefficient.size());
  std::string top;
  for (std::size_t k = coefficient.size(); k-- > 0;) {
    if (is_zero(coefficient[k])) continue;
    top += (top.empty() ? "" : " + ") + letter + std::to_string(k) +
           (k == 0   ? ""
            : k == 1 ? "*" + ring->name(z)
                     : "*" + ring->name(z) + "^" + std::to_string(k));
  }
  const std::string bottom = to_factored_string(MFraction(r.den()));
  n.formulas.push_back({label, "(" + top + ")" + (bottom == "1" ? "" : "/(" + bottom + ")")});
  for (std::size_t k = coefficient.size(); k-- > 0;)
    if (!is_zero(coefficient[k]))
      n.formulas.push_back(
          {letter + std::to_string(k), to_factored_string(MFraction(coefficient[k]))});
}

// No name of the system.
std::string free_unknown(const Ring& ring) {
  for (const char* name : {"y", "w", "eta", "xi", "zeta"})
    if (!ring->find(name)) return name;
  return "unknown";
}

// y'' + a y' + b y = 0
std::string second_order(const std::string& y, const MFraction& a, const MFraction& b) {
  const auto term = [](const MFraction& f, const std::string& times) {
    if (is_zero(f)) return std::string{};
    return " + " + (is_one(f) ? times : "(" + to_factored_string(f) + ")*" + times);
  };
  return y + "''" + term(a, y + "'") + term(b, y) + " = 0";
}

// The normal variational equation by time, the curve, and the equation in z: "a logarithm at z = 1"
// speaks of this z.
void show_way(NodeResult& n, const Ring& ring, const AlgebraicOde& ode,
              const std::vector<NormalVariationalEquation>& all) {
  constexpr std::size_t longest = 240;
  const auto put = [&](const std::string& label, const std::string& text) {
    if (text.size() <= longest) n.formulas.push_back({label, text});
  };
  const std::string &z = ring->name(ode.z), y = free_unknown(ring);
  const auto chosen =
      std::ranges::find_if(all, [&](const auto& e) { return e.unknown == ode.unknown; });
  if (chosen != all.end())
    put("by time, " + y + " the variation of " + ode.unknown,
        second_order(y, chosen->a1, chosen->a0));
  n.formulas.push_back({"change of variable", ode.change});
  if (ode.p && ode.q) put("by " + z, second_order(y, *ode.p, *ode.q));
}

MFraction as_fraction(const certify::PhaseCurve& c, const certify::CurveFunction& f) {
  MPoly below(c.ring, f.n);
  for (std::size_t i = 0; i < f.over.size(); ++i)
    below = below * pow(c.denominators[i], f.over[i]);
  return MFraction(f.p) / MFraction(below);
}

// The solution as the certificate has it: each coordinate, and the time, as functions of z and of roots.
void show_solution(NodeResult& n, const certify::Way& way) {
  const certify::PhaseCurve& c = way.curve;
  std::string curve;
  const auto add = [&curve](const std::string& left, const std::string& right) {
    if (left != right) curve += (curve.empty() ? "" : ", ") + left + " = " + right;
  };
  for (const auto& [i, value] : c.values)
    if (i < way.system.first_inverse())
      add(way.system.ring->name(i), to_factored_string(as_fraction(c, value)));
  for (std::size_t i = 0; i < c.tower.size(); ++i)
    add(c.ring->name(c.variable(i)) + "^" + std::to_string(c.tower[i].degree),
        to_factored_string(as_fraction(c, c.tower[i].value)));
  n.formulas.push_back({"phase curve", curve});
  n.formulas.push_back(
      {"on it dt/d" + c.ring->name(c.z()), to_factored_string(as_fraction(c, c.time))});
  std::string domain;
  for (const MPoly& d : c.denominators)
    if (uses(d, c.z())) domain += (domain.empty() ? "" : ", ") + to_string(d);
  if (!domain.empty()) n.formulas.push_back({"where none of these is 0", domain});
}

void show_block(NodeResult& n, const System& s, const BlockReport& b) {
  if (b.ode) {
    show_way(n, s.ring(), *b.ode, b.scalar);
    if (b.way) show_solution(n, b.way->way);
    show_equation(n, b.ode->r, s.ring(), b.ode->z);
  }
  if (b.decision) show_decision(n, *b.decision);
  if (b.strata) show_strata(n, *b.strata);
  for (const EnergyResult& e : b.energies) {
    if (e.strata) {
      n.formulas.push_back({"energy", sentence(e.at)});
      show_strata(n, *e.strata, " where " + sentence(e.at));
    }
    if (!e.decision || e.decision->abelian == Truth::unknown) continue;
    n.formulas.push_back({"energy", sentence(e.at)});
    if (e.r) n.formulas.push_back({"r there", to_string(*e.r)});
    show_decision(n, *e.decision, " where " + sentence(e.at));
  }
}

// The equations of a manifold and the levels on it, as written.
void show_manifold(NodeResult& n, const System& s, const std::string& name) {
  for (const ManifoldSpec& m : s.manifolds) {
    if (m.name != name) continue;
    n.formulas.push_back({"manifold " + name, joined(m.equations, &Equation::text)});
    if (!m.levels.empty())
      n.formulas.push_back({"levels on " + name, joined(m.levels, &Equation::text)});
  }
}

} // namespace

void show_curve(NodeResult& n, const System& s, const study::CurveStudy& m,
                const std::vector<NamedCertificate>& certificates) {
  show_manifold(n, s, m.name());
  if (!m.higher || m.first.manifold)
    n.checks.push_back(
        {"the manifold " + m.name() + " is invariant", m.first.manifold.has_value()});
  for (const BlockReport& b : m.first.blocks)
    show_block(n, s, b);
  for (const NamedCertificate& c : certificates) // what has none is a trusted step
    if (!c.json.empty()) n.certificates.push_back(c.json);
}

} // namespace kov
