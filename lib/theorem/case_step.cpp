// The step "case": the verdict of a system file.

#include "integrability/check.hpp"
#include "linode/singularities.hpp"
#include "theorem/prove.hpp"

#include "exact/algebraic.hpp"

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
PolePicture picture_of(const Singularities& all, const std::string& z) {
  PolePicture picture{
      "Singular points of r in the " + z + "-plane", "Re " + z, "Im " + z, {}, false};
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

void show_decision(NodeResult& n, const Decision& d) {
  if (is_zero(d.r)) return;
  const Singularities s = singularities(d.r);
  Grid exponents{"Exponent differences", {"place", "order", "difference", "logarithm"}, {}};
  for (const Singularity& one : s.finite)
    exponents.rows.push_back(row_of(one, d.variable));
  exponents.rows.push_back(row_of(s.infinity, d.variable));
  n.tables.push_back(std::move(exponents));
  n.pictures.push_back(picture_of(s, d.variable));
  n.formulas.push_back({"group", d.group ? describe(*d.group) : "not determined"});
  if (!d.certificate.empty()) ++n.certificates;
}

void show_block(NodeResult& n, const System& s, const BlockReport& b) {
  if (b.ode) {
    n.formulas.push_back({"change of variable", b.ode->change});
    n.formulas.push_back({"r(" + s.ring()->name(b.ode->z) + ")", to_factored_string(b.ode->r)});
  }
  if (b.decision) show_decision(n, *b.decision);
  for (const EnergyResult& e : b.energies) {
    if (!e.decision || e.decision->abelian == Truth::unknown) continue;
    n.formulas.push_back({"energy", e.condition});
    if (e.r) n.formulas.push_back({"r there", to_string(*e.r)});
    show_decision(n, *e.decision);
  }
}

std::string reason_of(const ManifoldReport& m) {
  std::string text;
  for (const BlockReport& b : m.blocks) {
    if (b.decision) return b.decision->reason;
    for (const EnergyResult& e : b.energies)
      if (e.decision && e.decision->abelian == Truth::no)
        return e.condition + ": " + e.decision->reason;
    if (!b.note.empty()) text = b.note;
  }
  for (const std::string& r : m.reasons)
    if (text.empty()) text = r;
  return text;
}

} // namespace

void prove_case(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  const System s = read_system(directory + n.node.file, n.node.where);
  CheckOptions check;
  check.decide = options.decide;
  check.decide.want_certificate = true;
  check.only_manifold = n.node.manifold;
  const CheckReport report = check_system(s, check);
  for (const Assumption& a : s.assumptions)
    n.formulas.push_back({"assumed", a.text});
  for (const ManifoldReport& m : report.manifolds) {
    if (m.failure) {
      n.status = NodeStatus::open;
      n.summary = m.failure->message;
      return;
    }
    n.checks.push_back({"the manifold " + m.name + " is invariant", m.manifold.has_value()});
    for (const BlockReport& b : m.blocks)
      show_block(n, s, b);
    n.summary = reason_of(m);
    if (to_string(m.verdict) != n.node.expect) continue;
    n.status = NodeStatus::proved;
    if (m.verdict == VerdictKind::non_integrable) n.theorems.push_back(m.theorem);
    return;
  }
}

} // namespace kov
