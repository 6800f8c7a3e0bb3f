// The statement of an accepted certificate of higher variational equations, as lines of text made
// from the parsed data alone: docs/theory/jet_certificates.md 5.  The Python checker prints the
// same.

#include "certify/equation/statement.hpp"

#include "certify/jets/check.hpp"
#include "certify/system/check.hpp"
#include "exact/joined.hpp"

namespace kov::certify {

namespace {

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

std::vector<std::string> statement(const JetsCertificate& c, const JetsAccepted& found) {
  const Ring &phase = c.phase, &field = c.field.ring;
  const std::size_t n = 2 + c.others;
  std::vector<std::string> parameters, pairs, lines;
  for (std::size_t i = c.e() + 1; i < c.c1(); ++i)
    parameters.push_back(field->name(i));
  lines.push_back("the system " + quoted(c.title) +
                  (parameters.empty() ? "" : " with parameters " + joined(parameters)));
  for (std::size_t i = 0; i < n; ++i) // which momentum is that of which coordinate
    pairs.push_back("{" + phase->name(i) + ", " + phase->name(i + n) + "} = 1");
  lines.push_back("  " + joined(pairs) + ", H = " + to_string(c.hamiltonian));
  for (std::size_t i = 0; i < c.field.tower.size(); ++i)
    lines.push_back("  " + shown_step(c.field, i));
  const auto pair = [&](const std::array<CurveFunction, 2>& two) {
    return "(" + shown_element(c.field, two[0]) + ", " + shown_element(c.field, two[1]) + ")";
  };
  std::string line = "along the line (" + phase->name(0) + ", " + phase->name(1) +
                     ") = " + pair(c.line.start) + " + y*" + pair(c.line.along);
  for (std::size_t l = 2; l < n; ++l)
    line += ", " + phase->name(l) + " = 0";
  lines.push_back(line);
  for (const MPoly& d : c.field.denominators)
    if (!is_constant(d)) lines.push_back("  except where " + to_string(d) + " = 0");
  const MPoly& value = c.obstruction.value.p;
  bool depends = false;
  for (std::size_t i = c.e() + 1; i < c.c1(); ++i)
    depends = depends || uses(value, i);
  if (depends)
    lines.push_back("  except where " + to_string(value) + " = 0 for all " + field->name(c.e()));
  const auto* group = std::get_if<ByGroup>(&c.group);
  const auto& [why, energies] = reasons.at(c.group.index());
  lines.push_back("is not integrable in Liouville's sense with first integrals that are "
                  "meromorphic near the phase curve, " +
                  (energies + (group ? to_string(found.energy) : "")) +
                  " (Morales-Ruiz, Ramis and Simo), as");
  const auto exponent = [&](std::size_t i) {
    return to_string(Rational(c.normal[i]->low, c.turns));
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
