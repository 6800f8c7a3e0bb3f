// The statement of an accepted certificate of higher variational equations, as lines of text made
// from the parsed data alone: docs/theory/jet_certificates.md 5.  The Python checker prints the
// same.

#include "certify/equation/statement.hpp"

#include "certify/jets/check.hpp"

namespace kov::certify {

namespace {

class JetsStatement {
public:
  JetsStatement(const JetsCertificate& c, const JetsAccepted& found) : c_(c), found_(found) {}

  std::vector<std::string> operator()() {
    const PhaseFunction& h = c_.hamiltonian;
    lines_.push_back("the system " + quoted(c_.title) + parameters());
    lines_.push_back(
        "  " + pairs() + "H = " +
        (h.n == Integer(1) ? to_string(h.p) : "(" + to_string(h.p) + ")/" + to_string(h.n)));
    for (std::size_t i = 0; i < c_.field.tower.size(); ++i)
      lines_.push_back("  " + c_.field.ring->name(c_.field.variable(i)) + "^" +
                       std::to_string(c_.field.tower[i].degree) + " = " +
                       element(c_.field.tower[i].value));
    lines_.push_back("along the line (" + c_.phase->name(0) + ", " + c_.phase->name(1) +
                     ") = " + pair(c_.line.start) + " + y*" + pair(c_.line.along) + subspace());
    exceptions();
    lines_.push_back("is not integrable in Liouville's sense with first integrals that are "
                     "meromorphic near the phase curve, " +
                     level() + " (Morales-Ruiz, Ramis and Simo), as");
    lines_.push_back("  VE_" + std::to_string(c_.order) + " has the logarithm R = " +
                     element(c_.form) + " at the exponents " + exponent(0) + ", " + exponent(1));
    std::visit([&](const auto& x) { group(x); }, c_.group);
    return std::move(lines_);
  }

private:
  [[nodiscard]] std::string parameters() const {
    std::string all;
    for (std::size_t i = c_.e() + 1; i < c_.c1(); ++i)
      all += (all.empty() ? " with parameters " : ", ") + c_.field.ring->name(i);
    return all;
  }

  // Which momentum is that of which coordinate: "{q1, p1} = 1, {q2, p2} = 1, ".
  [[nodiscard]] std::string pairs() const {
    const std::size_t n = 2 + c_.others;
    std::string all;
    for (std::size_t i = 0; i < n; ++i)
      all += "{" + c_.phase->name(i) + ", " + c_.phase->name(i + n) + "} = 1, ";
    return all;
  }

  // As it was given: (p)/(n*(d_1)^2*(d_2)).
  [[nodiscard]] std::string element(const CurveFunction& f) const {
    std::string below = f.n == Integer(1) ? "" : to_string(f.n);
    for (std::size_t k = 0; k < f.over.size(); ++k)
      if (f.over[k] > 0)
        below += (below.empty() ? "(" : "*(") + to_string(c_.field.denominators[k]) + ")" +
                 (f.over[k] > 1 ? "^" + std::to_string(f.over[k]) : "");
    return below.empty() ? to_string(f.p) : "(" + to_string(f.p) + ")/(" + below + ")";
  }
  [[nodiscard]] std::string pair(const std::array<CurveFunction, 2>& two) const {
    return "(" + element(two[0]) + ", " + element(two[1]) + ")";
  }
  [[nodiscard]] std::string subspace() const {
    std::string all;
    for (std::size_t l = 2; l < 2 + c_.others; ++l)
      all += ", " + c_.phase->name(l) + " = 0";
    return all;
  }
  [[nodiscard]] std::string exponent(std::size_t i) const {
    return to_string(Rational(c_.normal[i]->low, c_.turns));
  }

  void exceptions() {
    for (const MPoly& d : c_.field.denominators)
      if (!is_constant(d)) lines_.push_back("  except where " + to_string(d) + " = 0");
    const MPoly& value = c_.obstruction.value.p;
    for (std::size_t i = c_.e() + 1; i < c_.c1(); ++i)
      if (uses(value, i)) {
        lines_.push_back("  except where " + to_string(value) + " = 0 for all " +
                         c_.field.ring->name(c_.e()));
        return;
      }
  }

  [[nodiscard]] std::string level() const {
    if (std::holds_alternative<ByGroup>(c_.group))
      return "at the energy " + to_string(found_.energy);
    return std::holds_alternative<ByHomogeneity>(c_.group)
               ? "for all but finitely many values of the energy"
               : "for all but countably many values of the energy";
  }

  void group(const ByFirstFamily&) {
    lines_.emplace_back("  the normal equation of the highest terms is in the first family");
  }
  void group(const ByHomogeneity&) {
    lines_.emplace_back("  the normal equation is homogeneous and in the first family");
  }
  void group(const ByEquilibria&) {
    lines_.emplace_back("  the exponents at the equilibria are not all rational");
  }
  void group(const ByGroup& x) {
    lines_.emplace_back("  the group of the normal equation is infinite:");
    for (const std::string& line : statement(x.certificate))
      lines_.push_back("  " + line);
  }

  const JetsCertificate& c_;
  const JetsAccepted& found_;
  std::vector<std::string> lines_;
};

} // namespace

std::vector<std::string> statement(const JetsCertificate& c, const JetsAccepted& found) {
  return JetsStatement(c, found)();
}

} // namespace kov::certify
