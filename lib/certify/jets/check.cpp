#include "certify/jets/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/jets/motion.hpp"
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
    const std::size_t terms_of_w = motion_.difference() == Rational(1) ? 0 : 1;
    need(terms(motion_.tangential()) == 1 && terms(motion_.normal()) == terms_of_w,
         "the first variational equation is not homogeneous");
    need(is_zero(motion_.entry(0).p), "the form has a power of c2 alone");
  }

  void check(const ByEquilibria& x) const {
    const CurveRow v = slope(motion_.potential());
    need_one(x.first, v, x.second, slope(v));
    const Integer m = sum_of_squares().num() * sum_of_squares().den();
    need_within(m < Integer(1'000'000'000'000), "the sum of the squares is too large");
    need(is_no_sum_of_squares(to_long(m), motion_.degree() - 1), "the exponents may be rational");
  }

  void check(const ByGroup& x) {
    need(c_.field.ring->size() == 3 && c_.field.tower.empty(), "there are parameters or constants");
    const CurveRow v = motion_.potential();
    found_.energy = at(motion_.energy(), x.e);
    CurveRow kinetic; // h - v
    for (const CurveFunction& f : v)
      kinetic.push_back(a_.times(a_.integer(-1), f));
    const Rational h = found_.energy;
    kinetic[0] = a_.plus(kinetic[0], {MPoly(c_.field.ring, h.num()), h.den(), {}});
    need_one(x.first, kinetic, x.second, slope(v));
    need(at(a_.reduced(c_.obstruction.value), x.e) != Rational(0), "the obstruction is 0 there");
    need_equation(x.certificate, polynomial(kinetic));
    const auto verdict = certify::check(x.certificate);
    if (const auto* no = std::get_if<Rejected>(&verdict))
      throw Refused{"group: " + (no->step.empty() ? "" : no->step + ": ") + no->why, no->limit};
    found_.trusted = std::get<Accepted>(verdict).trusted_steps;
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

  // f g + k l = 1
  void need_one(const CurveRow& f, const CurveRow& g, const CurveRow& k, const CurveRow& l) const {
    for (const auto* row : {&f, &k})
      for (const CurveFunction& x : *row)
        for (const std::size_t i : {c_.e(), c_.c1(), c_.c2()})
          need(!uses(x.p, i), "a cofactor has a variable in it");
    CurveRow sum = product(f, g);
    const CurveRow other = product(k, l);
    sum.resize(std::max({sum.size(), other.size(), std::size_t{1}}), a_.zero());
    for (std::size_t i = 0; i < other.size(); ++i)
      sum[i] = a_.plus(sum[i], other[i]);
    sum[0] = a_.plus(sum[0], a_.integer(-1));
    for (const CurveFunction& x : sum)
      need(kov::is_zero(x.p), "a polynomial is not proved to have simple roots");
  }
  [[nodiscard]] CurveRow product(const CurveRow& f, const CurveRow& g) const {
    if (f.empty() || g.empty()) return {};
    CurveRow all(f.size() + g.size() - 1, a_.zero());
    for (std::size_t i = 0; i < f.size(); ++i)
      for (std::size_t j = 0; j < g.size(); ++j)
        all[i + j] = a_.plus(all[i + j], a_.times(f[i], g[j]));
    return all;
  }
  [[nodiscard]] CurveRow slope(const CurveRow& f) const {
    CurveRow all;
    for (std::size_t i = 1; i < f.size(); ++i)
      all.push_back(a_.times(a_.integer(static_cast<long>(i)), f[i]));
    return all;
  }
  static std::size_t terms(const CurveRow& f) {
    return static_cast<std::size_t>(
        std::ranges::count_if(f, [](const CurveFunction& x) { return !kov::is_zero(x.p); }));
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
  [[nodiscard]] Poly polynomial(const CurveRow& f) const {
    Poly all;
    for (std::size_t i = 0; i < f.size(); ++i)
      all.set_coeff(static_cast<long>(i), NfElem(at(f[i], 0)));
    return all;
  }

  const JetsCertificate& c_;
  const Motion& motion_;
  const CurveAlgebra& a_;
  JetsAccepted found_;
};

} // namespace

std::variant<JetsAccepted, Rejected> check_jets(const JetsCertificate& c) {
  const CheckedSteps::File file;
  std::string rule = "J1";
  try {
    Arithmetic arithmetic;
    Motion motion(c, arithmetic);
    try {
      motion.need_line();
      motion.need_place();
      motion.need_normal();
      motion.need_jets();
      motion.need_residues();
      motion.need_minor();
      rule = "J7";
      JetsAccepted found = NormalGroup(c, motion)();
      CheckedSteps::add_labels("kovacic-jets/1", {"J1", "J2", "J3", "J4", "J5", "J6"});
      constexpr std::array reasons{"first-family", "homogeneous", "equilibria", "group"};
      CheckedSteps::add({"kovacic-jets/1", "by", reasons[c.group.index()]});
      return found;
    } catch (...) {
      if (rule != "J7") rule = motion.rule();
      throw;
    }
  } catch (const Refused& no) {
    return Rejected{no, rule};
  } catch (const std::exception& e) {
    return Rejected{{e.what()}, rule};
  }
}

} // namespace kov::certify
