#pragma once
// One system in many notations: gauges, shifts, exchanges, curvilinear coordinates.

#include "system/system.hpp"

#include "support/random.hpp"

#include <string>
#include <vector>

namespace kov::test {

/// T + V(x, y) with one parameter a, and values of a at which it is asked.
struct Potential {
  std::string text; ///< in X and Y
  bool rational = true;
};

inline const std::vector<Potential>& potentials() {
  static const std::vector<Potential> all{
      {"(X^2 + Y^2)/2 + X^2*Y - Y^3/3"},
      {"a*X^2 + X^2*Y + 2*Y^3"},
      {"X^2*Y + 16*Y^3/3 + a*(X^2 + 16*Y^2)/2"},
      {"X^4 + 6*X^2*Y^2 + Y^4 + a*(X^2 + Y^2)"},
      {"X^4 + 12*X^2*Y^2 + 16*Y^4 + a*(X^2 + 4*Y^2)"},
      {"X^4 + 3*X^2*Y^2 + Y^4"},
      {"(X^2 + Y^2)/2 + a*X^2*Y^2"},
      {"(X^2 + Y^2)^2 + a*(X^2 + Y^2)"},
      {"a*(X^2 + 4*Y^2) + 1/X^2"},
      {"a*X*Y + X^2 + Y^2"},
      {"X^3/3 + a*Y^3"},
      {"X^2*Y + a*Y^3/3"},
      {"X^2*Y^2 + X^4/4"},
      {"a/(X^2 + Y^2) + X^2 + Y^2"},
      {"-1/sqrt(X^2 + Y^2) + a*X", false},
      {"-a/sqrt(X^2 + Y^2) + X^2 + Y^2", false},
  };
  return all;
}

inline std::string with(std::string text, const std::string& letters,
                        const std::vector<std::string>& values) {
  for (std::size_t i = 0; (i = text.find_first_of(letters, i)) != std::string::npos;) {
    const std::string value = "(" + values[letters.find(text[i])] + ")";
    text.replace(i, 1, value);
    i += value.size();
  }
  return text;
}

inline System read_text(const std::string& text) {
  return read_system(parse_document(text, "equivalent.toml"));
}
inline std::string hamiltonian_text(const std::string& h) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['a']\nhamiltonian = '" +
         h + "'\n";
}
inline std::string plain_text(const Potential& p) {
  return hamiltonian_text("(u^2 + v^2)/2 + " + with(p.text, "XY", {"x", "y"}));
}

/// p -> p + df/dq, q -> q + c, (q, p) -> (p, -q): some of them, one after the other.
inline std::string canonical_text(const Potential& p, Random& random) {
  const auto number = [&] { return "(" + std::to_string(random.between(-3, 3)) + ")"; };
  std::vector<std::string> now{"x", "y", "u", "v"}; // what the letters of the system stand for
  if (random.once_in(2)) {                          // f = k x^2 y + l x y + m x^3 + n y^2
    const std::string k = number(), l = number(), m = number(), n = number();
    now[2] = "u + 2*" + k + "*x*y + " + l + "*y + 3*" + m + "*x^2";
    now[3] = "v + " + k + "*x^2 + " + l + "*x + 2*" + n + "*y";
  }
  if (random.once_in(2)) {
    const std::string c = number(), d = number() + "/2";
    for (std::string& x : now)
      x = with(x, "xy", {"x + " + c, "y + " + d});
  }
  if (p.rational && random.once_in(2)) {
    const bool both = random.once_in(2);
    for (std::string& x : now)
      x = with(x, "xyuv", {"u", both ? "v" : "y", "-x", both ? "-y" : "v"});
  }
  const std::string t = "((U)^2 + (V)^2)/2";
  return hamiltonian_text(with(t, "UV", {now[2], now[3]}) + " + " +
                          with(p.text, "XY", {now[0], now[1]}));
}

/// Polar, parabolic and elliptic coordinates, by a Lagrangian; the root of X^2 + Y^2 is the distance to
/// the origin or to a focus.
inline std::string curvilinear_text(const Potential& p, std::size_t kind) {
  struct Coordinates {
    std::string kinetic, x, y, root;
  };
  const std::vector<Coordinates> all{
      {"(k^2 + m^2*l^2)/2", "m*cos(n)", "m*sin(n)", "m"},
      {"(m^2 + n^2)*(k^2 + l^2)/2", "(m^2 - n^2)/2", "m*n", "((m^2 + n^2)/2)"},
      {"(cosh(m)^2 - cos(n)^2)*(k^2 + l^2)/2", p.rational ? "cosh(m)*cos(n)" : "cosh(m)*cos(n) + 1",
       "sinh(m)*sin(n)", "(cosh(m) + cos(n))"}};
  const Coordinates& c = all[kind];
  std::string v = p.text;
  const std::string root = "sqrt(X^2 + Y^2)";
  if (const auto at = v.find(root); at != std::string::npos) v.replace(at, root.size(), c.root);
  return "[system]\nkind = 'lagrangian'\ncoordinates = ['m', 'n']\nvelocities = ['k', 'l']\n"
         "parameters = ['a']\nlagrangian = '" +
         c.kinetic + " - (" + with(v, "XY", {c.x, c.y}) + ")'\n";
}

} // namespace kov::test
