#include "splitting/andoyer_chart.hpp"

#include "exact/error.hpp"

namespace kov {
namespace {

std::vector<std::string> chart_names(const std::vector<std::string>& more) {
  std::vector<std::string> names{"l", "g",     "h",     "L",     "G",     "F", "p",
                                 "s", "sin_l", "cos_l", "sin_g", "cos_g", "e", "i"};
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

// The gradient of a function symbol from its nonzero partial derivatives.
FunctionSymbol symbol(const Ring& ring, const std::string& name, const std::string& meaning,
                      const std::map<std::string, MFraction>& partials) {
  FunctionSymbol f;
  f.variable = ring->index(name);
  f.meaning = meaning;
  for (const char* x : {"l", "g", "h", "L", "G", "F"})
    f.gradient.push_back(partials.contains(x) ? partials.at(x) : MFraction(ring));
  return f;
}

VectorField phase_space(const Ring& ring) {
  const auto x = [&](const char* n) { return MFraction::variable(ring, n); };
  VectorField v;
  v.ring = ring;
  for (const char* n : {"l", "g", "h", "L", "G", "F"})
    v.coordinates.push_back(ring->index(n));
  v.functions = {
      symbol(ring, "sin_l", "sin(l)", {{"l", x("cos_l")}}),
      symbol(ring, "cos_l", "cos(l)", {{"l", -x("sin_l")}}),
      symbol(ring, "sin_g", "sin(g)", {{"g", x("cos_g")}}),
      symbol(ring, "cos_g", "cos(g)", {{"g", -x("sin_g")}}),
      symbol(ring, "p", "sqrt(G^2 - L^2)", {{"L", -x("L") / x("p")}, {"G", x("G") / x("p")}}),
      symbol(ring, "s", "sqrt(G^2 - F^2)", {{"F", -x("F") / x("s")}, {"G", x("G") / x("s")}})};
  v.poisson = canonical_structure(ring, 3);
  return v;
}

SurdField chart_field(const Ring& ring) {
  const auto x = [&](const char* n) { return MFraction::variable(ring, n); };
  const MFraction one(ring, Rational(1));
  return SurdField(ring, {{ring->index("i"), -one},
                          {ring->index("p"), x("G") * x("G") - x("L") * x("L")},
                          {ring->index("s"), x("G") * x("G") - x("F") * x("F")},
                          {ring->index("cos_l"), one - x("sin_l") * x("sin_l")},
                          {ring->index("cos_g"), one - x("sin_g") * x("sin_g")}});
}

// {M_i, M_j} = -epsilon_ijk M_k, {M_i, Gamma_j} = -epsilon_ijk Gamma_k, {Gamma_i, Gamma_j} = 0.
void check_brackets(const AndoyerChart& c, CheckedIdentities& out) {
  const auto bracket = [&](const MFraction& f, const MFraction& g) {
    return poisson_bracket(c.phase, f, g);
  };
  bool momenta = true, mixed = true, gammas = true;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int k = (6 - i - j) % 3; // the third index, where i != j
      const long eps = i == j ? 0 : (j - i + 3) % 3 == 1 ? 1 : -1;
      const auto minus = [&](const Triple& v) { return Rational(-eps) * v[k]; };
      momenta =
          momenta && c.field.is_zero(bracket(c.momentum[i], c.momentum[j]) - minus(c.momentum));
      mixed = mixed && c.field.is_zero(bracket(c.momentum[i], c.gamma[j]) - minus(c.gamma));
      gammas = gammas && c.field.is_zero(bracket(c.gamma[i], c.gamma[j]));
    }
  out.push_back(
      {"{M_i, M_j} = -epsilon_ijk M_k in the canonical bracket of (l, g, h; L, G, F)", momenta});
  out.push_back({"{M_i, Gamma_j} = -epsilon_ijk Gamma_k", mixed});
  out.push_back({"{Gamma_i, Gamma_j} = 0", gammas});
}

} // namespace

AndoyerChart andoyer_chart(const std::vector<std::string>& more) {
  const Ring ring = make_ring(chart_names(more));
  AndoyerChart c{ring, phase_space(ring), chart_field(ring), {}, {}, {}, {}};
  const auto x = [&](const char* n) { return MFraction::variable(ring, n); };
  const MFraction zero(ring);
  c.momentum = {x("p") * x("sin_l"), x("p") * x("cos_l"), x("L")};
  c.e1 = {x("L") * x("sin_l") / x("G"), x("L") * x("cos_l") / x("G"), -x("p") / x("G")};
  c.e2 = {x("cos_l"), -x("sin_l"), zero};
  for (int k = 0; k < 3; ++k)
    c.gamma[k] = x("F") / (x("G") * x("G")) * c.momentum[k] +
                 x("s") / x("G") * (x("cos_g") * c.e1[k] + x("sin_g") * c.e2[k]);
  return c;
}

CheckedIdentities check_andoyer(const AndoyerChart& c) {
  CheckedIdentities out;
  check_brackets(c, out);
  const auto x = [&](const char* n) { return c.variable(n); };
  const auto zero = [&](const MFraction& f) { return c.field.is_zero(f); };
  const MFraction one(c.ring, Rational(1));
  out.push_back({"Gamma^2 = 1, M^2 = G^2, M . Gamma = F, M3 = L",
                 zero(dot(c.gamma, c.gamma) - one) &&
                     zero(dot(c.momentum, c.momentum) - x("G") * x("G")) &&
                     zero(dot(c.momentum, c.gamma) - x("F")) && zero(c.momentum[2] - x("L"))});
  const MFraction sine = x("G") * (c.momentum[1] * c.gamma[0] - c.momentum[0] * c.gamma[1]);
  const MFraction cosine = x("L") * x("F") - x("G") * x("G") * c.gamma[2];
  out.push_back(
      {"p sin l = M1, p cos l = M2, p s sin g = G (M2 Gamma1 - M1 Gamma2), "
       "p s cos g = M3 F - G^2 Gamma3: the quadrants of l and g, as p, s > 0",
       zero(sine - x("p") * x("s") * x("sin_g")) && zero(cosine - x("p") * x("s") * x("cos_g"))});
  return out;
}

std::map<long, MFraction> fourier_modes(const AndoyerChart& c, const MFraction& f) {
  const std::size_t e = c.ring->index("e");
  const MFraction z = MFraction::variable(c.ring, e); // e^(i g)
  const MFraction i = c.variable("i");
  const Rational half(Integer(1), Integer(2));
  const MFraction whole =
      c.field.reduce(substitute(f, {{c.ring->index("sin_g"), (half * (z - pow(z, -1))) / i},
                                    {c.ring->index("cos_g"), half * (z + pow(z, -1))}}));
  std::map<long, MFraction> modes;
  if (is_zero(whole)) return modes;
  const std::vector<MPoly> below = coefficients(whole.den(), e);
  for (std::size_t k = 0; k + 1 < below.size(); ++k)
    if (!is_zero(below[k])) throw DomainError("a trigonometric polynomial in g was expected");
  const std::vector<MPoly> above = coefficients(whole.num(), e);
  for (std::size_t k = 0; k < above.size(); ++k)
    if (!is_zero(above[k]))
      modes[static_cast<long>(k) - static_cast<long>(below.size()) + 1] =
          MFraction(above[k]) / MFraction(below.back());
  return modes;
}

} // namespace kov
