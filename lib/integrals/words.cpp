#include "integrals/find.hpp"

namespace kov {
namespace {

// "+ c*x" after other terms; c*1 is c.
void add_term(std::string& text, const MFraction& c, const std::string& x) {
  const bool minus = c.num().length() == 1 && to_string(c).front() == '-';
  const MFraction size = minus ? -c : c;
  std::string factor = is_one(size) ? "" : to_string(size);
  if (factor.find_first_of("+-/ ") != std::string::npos) factor = "(" + factor + ")";
  const std::string sign = minus ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ");
  text += sign + factor + (factor.empty() ? "" : "*") + x;
}

// Products of powers as such.
std::string short_text(const MFraction& f) {
  const std::string plain = to_string(f);
  const std::string factored = to_factored_string(f);
  return 2 * factored.size() < plain.size() ? factored : plain;
}

// Without a number in front, its first coefficient positive.
MFraction primitive(const MFraction& f) {
  if (is_zero(f)) return f;
  const auto content = [](const MPoly& p) {
    Integer g;
    for (long i = 0; i < p.length() && g != Integer(1); ++i)
      g = gcd(g, p.coefficient(i));
    return g;
  };
  const Rational size(content(f.den()), content(f.num()));
  return (sign(f.num().coefficient(0)) < 0 ? -size : size) * f;
}

} // namespace

std::string to_string(const FoundIntegral& f) {
  if (f.logarithms.empty()) return short_text(f.hamiltonian ? f.value : primitive(f.value));
  std::string text = is_zero(f.value) ? "" : to_string(f.value);
  for (const LogarithmicTerm& t : f.logarithms)
    add_term(text, t.times, "log(" + to_string(t.of) + ")");
  return text;
}

std::string field_text(const VectorField& v, const std::vector<MFraction>& field) {
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (!is_zero(field[i])) add_term(text, field[i], "d/d" + v.name(i));
  return text;
}

MFraction shortest_form(const VectorField& v, const MFraction& f) {
  const auto size = [](const MFraction& g) { return g.num().length() + g.den().length(); };
  MFraction best = primitive(f);
  for (const MPoly& relation : v.relations)
    for (const FunctionSymbol& x : v.functions) {
      if (degree(relation, x.variable) != 2) continue;
      const std::vector<MPoly> r = coefficients(relation, x.variable);
      if (!is_constant(r[2]) || !is_zero(r[1])) continue;
      const MFraction square = MFraction(-r[0]) / MFraction(r[2]);
      const auto lowered = [&](const MPoly& p) {
        const std::vector<MPoly> c = coefficients(p, x.variable);
        MFraction sum(p.ring());
        for (std::size_t i = 0; i < c.size(); ++i)
          sum += MFraction(c[i]) * pow(square, static_cast<long>(i / 2)) *
                 pow(MFraction::variable(p.ring(), x.variable), static_cast<long>(i % 2));
        return sum;
      };
      const MFraction below = lowered(best.den());
      if (is_zero(below)) continue;
      const MFraction g = lowered(best.num()) / below;
      if (is_zero(g)) return g;
      if (size(g) < size(best)) best = primitive(g);
    }
  return best;
}

} // namespace kov
