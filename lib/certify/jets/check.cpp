#include "certify/jets/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/jets/motion.hpp"
#include "certify/system/check.hpp"
#include "exact/joined.hpp"
#include "proof/text/checked.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// J7: why the group of the normal equation is infinite.
class NormalGroup {
public:
  NormalGroup(const JetsCertificate& c, const Motion& motion)
      : c_(c), motion_(motion), a_(motion.algebra()) {}

  JetsAccepted operator()() {
    std::visit([&](const auto& x) { check(x); }, c_.group);
    return std::move(found_);
  }

private:
  void check(const ByFirstFamily&) const { need_first_family(); }

  void check(const ByHomogeneity&) const {
    need_first_family();
    const long terms_of_w = motion_.difference() == Rational(1) ? 0 : 1;
    need(terms(motion_.tangential()) == 1 && terms(motion_.normal()) == terms_of_w,
         "the first variational equation is not homogeneous");
    need(is_zero(motion_.entry(0).p), "the form has a power of c2 alone");
  }

  void check(const ByEquilibria& x) const {
    const CurveFunction slope = motion_.by(motion_.potential(), c_.c2());
    need_one(x.first, slope, x.second, motion_.by(slope, c_.c2()));
    const Integer m = sum_of_squares().num() * sum_of_squares().den();
    need_within(m < Integer(1'000'000'000'000), "the sum of the squares is too large");
    need(is_no_sum_of_squares(to_long(m), motion_.degree() - 1), "the exponents may be rational");
  }

  void check(const ByGroup& x) {
    need(c_.field.ring->size() == 3 && c_.field.tower.empty(), "there are parameters or constants");
    const Rational h = found_.energy = at(motion_.energy(), x.e);
    const CurveFunction v = motion_.potential();
    const CurveFunction kinetic = a_.minus({MPoly(c_.field.ring, h.num()), h.den(), {}}, v);
    need_one(x.first, kinetic, x.second, motion_.by(v, c_.c2()));
    need(at(a_.reduced(c_.obstruction.value), x.e) != Rational(0), "the obstruction is 0 there");
    need_equation(x.certificate, polynomial(kinetic));
    found_.trusted = found_within(certify::check(x.certificate), "group: ").trusted_steps;
    const auto& component = x.certificate.claim.component;
    need(component && *component != "trivial", "the group is not said to be infinite");
  }

  // r m^2 = -3 g^2/4 + m (g'/2 + w), m = 2 A (h - v): the normal form of m u'' + g u' - w u = 0.
  void need_equation(const Certificate& inner, const Poly& kinetic) const {
    need(inner.num.field()->is_rational() && inner.den.field()->is_rational(),
         "the equation is over another field");
    const Poly m = Poly(2 * at(c_.line.inertias[1], 0)) * kinetic;
    const Poly g = polynomial(motion_.tangential()), w = polynomial(motion_.normal());
    const Poly right =
        Poly(Rational(-3, 4)) * g * g + m * (Poly(Rational(1, 2)) * derivative(g) + w);
    need(inner.num * m * m == inner.den * right && !kov::is_zero(inner.den),
         "the certificate is about another equation");
  }

  void need_first_family() const {
    const long k = motion_.degree();
    const auto integral = [&](int one) {
      return is_integer(Rational(k - 2) * (motion_.difference() + one) / Rational(2 * k));
    };
    need(integral(1) || integral(-1), "the exponents are not in the first family");
  }

  // rho1 (rho1 - 1)/(sigma (sigma - 1)), 4 rho1 (rho1 - 1) = delta^2 - 1
  [[nodiscard]] Rational sum_of_squares() const {
    const Rational sigma(-2, motion_.degree() - 2), delta = motion_.difference();
    return (delta * delta - 1) / (4 * sigma * (sigma - 1));
  }

  // m is not a sum of n >= 2 squares of rational numbers: jets.md 2.9.
  static bool is_no_sum_of_squares(long m, long n) {
    if (m < 0) return true;
    if (n > 3 || m == 0) return false;
    if (n == 3) {
      while (m % 4 == 0)
        m /= 4;
      return m % 8 == 7;
    }
    for (long p = 2; p * p <= m; ++p) {
      bool odd = false;
      for (; m % p == 0; m /= p)
        odd = !odd;
      if (odd && p % 4 == 3) return true;
    }
    return m % 4 == 3;
  }

  // k f + l g = 1, polynomials in y
  void need_one(const CurveRow& k, const CurveFunction& f, const CurveRow& l,
                const CurveFunction& g) const {
    need(a_.equal(a_.plus(a_.times(in_y(k), f), a_.times(in_y(l), g)), a_.integer(1)),
         "a polynomial is not proved to have simple roots");
  }
  [[nodiscard]] CurveFunction in_y(const CurveRow& row) const {
    CurveFunction sum = a_.zero();
    for (std::size_t k = row.size(); k-- > 0;) {
      for (const std::size_t i : {c_.e(), c_.c1(), c_.c2()})
        need(!uses(row[k].p, i), "a cofactor has a variable in it");
      sum = a_.plus(a_.times(sum, a_.variable(c_.c2())), row[k]);
    }
    return sum;
  }
  [[nodiscard]] long terms(const CurveFunction& f) const { // of a polynomial in y
    const auto c = coefficients(f.p, c_.c2());
    return std::ranges::count_if(c, [](const MPoly& x) { return !kov::is_zero(x); });
  }

  // The value of f at e, if f has no parameters.
  [[nodiscard]] Rational at(const CurveFunction& f, const Rational& e) const {
    const auto c = coefficients(f.p, c_.e());
    Rational sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) {
      need(is_constant(c[i]), "a number is expected");
      sum =
          sum * e + (kov::is_zero(c[i]) ? Rational(0) : Rational(c[i].coefficient(0), Integer(1)));
    }
    Rational below(f.n, Integer(1));
    for (std::size_t k = 0; k < f.over.size(); ++k)
      for (unsigned long j = 0; j < f.over[k]; ++j)
        below *= Rational(c_.field.denominators[k].coefficient(0), Integer(1));
    return sum / below;
  }
  [[nodiscard]] Poly polynomial(const CurveFunction& f) const { // in y
    Poly all;
    const auto c = coefficients(f.p, c_.c2());
    for (std::size_t i = 0; i < c.size(); ++i)
      all.set_coeff(static_cast<long>(i), NfElem(at({c[i], f.n, f.over}, 0)));
    return all;
  }

  const JetsCertificate& c_;
  const Motion& motion_;
  const CurveAlgebra& a_;
  JetsAccepted found_;
};

// By reason: why the group is infinite, and the energies of which this is said.
constexpr std::array<std::array<const char*, 2>, 4> reasons{
    {{"the normal equation of the highest terms is in the first family",
      "for all but countably many values of the energy"},
     {"the normal equation is homogeneous and in the first family",
      "for all but finitely many values of the energy"},
     {"the exponents at the equilibria are not all rational",
      "for all but countably many values of the energy"},
     {"the group of the normal equation is infinite:", "at the energy "}}};

} // namespace

std::variant<JetsAccepted, Rejected> check_jets(const JetsCertificate& c) {
  const CheckedSteps::File file;
  std::string rule = "J1";
  return verdict_at(rule, [&] {
    Arithmetic arithmetic;
    Motion motion(c, arithmetic, rule);
    motion.need_line();
    motion.need_place();
    motion.need_normal();
    motion.need_jets();
    motion.need_residues();
    motion.need_minor();
    rule = "J7";
    JetsAccepted found = NormalGroup(c, motion)();
    CheckedSteps::add_labels("kovacic-jets/1", {"J1", "J2", "J3", "J4", "J5", "J6"});
    constexpr std::array names{"first-family", "homogeneous", "equilibria", "group"};
    CheckedSteps::add({"kovacic-jets/1", "by", names[c.group.index()]});
    return found;
  });
}

std::vector<std::string> statement(const JetsCertificate& c, const JetsAccepted& found) {
  const Ring &phase = c.system.ring, &field = c.field.ring;
  std::vector<std::string> parameters, lines;
  for (std::size_t i = c.e() + 1; i < c.c1(); ++i)
    parameters.push_back(field->name(i));
  lines.push_back("the system " + quoted(c.title) +
                  (parameters.empty() ? "" : " with parameters " + joined(parameters)));
  lines.push_back("  " + shown_system(c.system).front());
  for (std::size_t i = 0; i < c.field.tower.size(); ++i)
    lines.push_back("  " + shown_step(c.field, i));
  const auto pair = [&](const std::array<CurveFunction, 2>& two) {
    return "(" + shown_element(c.field, two[0]) + ", " + shown_element(c.field, two[1]) + ")";
  };
  std::string line = "along the line (" + phase->name(0) + ", " + phase->name(1) +
                     ") = " + pair(c.line.start) + " + y*" + pair(c.line.along);
  for (std::size_t l = 2; l < c.system.dimension / 2; ++l)
    line += ", " + phase->name(l) + " = 0";
  lines.push_back(line);
  for (const MPoly& d : c.field.denominators)
    if (!is_constant(d)) lines.push_back("  except where " + to_string(d) + " = 0");
  const MPoly& value = c.obstruction.value.p;
  const auto used = used_variables(value);
  if (std::ranges::any_of(used, [&](std::size_t i) { return i > c.e() && i < c.c1(); }))
    lines.push_back("  except where " + to_string(value) + " = 0 for all " + field->name(c.e()));
  const auto* group = std::get_if<ByGroup>(&c.group);
  const auto& [why, energies] = reasons.at(c.group.index());
  lines.push_back("is not integrable in Liouville's sense with first integrals that are "
                  "meromorphic near the phase curve, " +
                  (energies + (group ? to_string(found.energy) : "")) +
                  " (Morales-Ruiz, Ramis and Simo), as");
  const auto exponent = [&](std::size_t i) {
    return to_string(Rational(c.normal[i].low, c.turns));
  };
  lines.push_back("  VE_" + std::to_string(c.order) +
                  " has the logarithm R = " + shown_element(c.field, c.form) +
                  " at the exponents " + exponent(0) + ", " + exponent(1));
  lines.push_back(std::string("  ") + why);
  for (const std::string& inner :
       group ? statement(group->certificate) : std::vector<std::string>{})
    lines.push_back("  " + inner);
  return lines;
}

} // namespace kov::certify
