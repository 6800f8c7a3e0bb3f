#include "symbol/known_functions.hpp"

#include <map>

namespace kov {
namespace {

struct TableRow {
  const char *name, *arguments, *means, *slope;
};

// DLMF 9.2, 10.6, 10.29, 12.8, 13.3, 14.10, 15.5
constexpr TableRow entries[]{
    {"exp", "x", "", "exp(x)"},
    {"log", "x", "", "1/x"},
    {"ln", "x", "log(x)", ""},
    {"sqrt", "x", "x^(1/2)", ""},
    {"sin", "x", "", "cos(x)"},
    {"cos", "x", "", "-sin(x)"},
    {"tan", "x", "sin(x)/cos(x)", ""},
    {"cot", "x", "cos(x)/sin(x)", ""},
    {"sec", "x", "1/cos(x)", ""},
    {"csc", "x", "1/sin(x)", ""},
    {"sinh", "x", "", "cosh(x)"},
    {"cosh", "x", "", "sinh(x)"},
    {"tanh", "x", "sinh(x)/cosh(x)", ""},
    {"coth", "x", "cosh(x)/sinh(x)", ""},
    {"sech", "x", "1/cosh(x)", ""},
    {"csch", "x", "1/sinh(x)", ""},
    {"atan", "x", "", "1/(1 + x^2)"},
    {"arctan", "x", "atan(x)", ""},
    {"asin", "x", "", "1/sqrt(1 - x^2)"},
    {"acos", "x", "", "-1/sqrt(1 - x^2)"},
    {"asinh", "x", "", "1/sqrt(1 + x^2)"},
    {"acosh", "x", "", "1/(sqrt(x - 1)*sqrt(x + 1))"},
    {"atanh", "x", "", "1/(1 - x^2)"},
    {"erf", "x", "", "2/sqrt(pi)*exp(-x^2)"},
    {"erfi", "x", "", "2/sqrt(pi)*exp(x^2)"},
    {"Ei", "x", "", "exp(x)/x"},
    {"airyai", "x", "", "airyaiprime(x)"},
    {"airybi", "x", "", "airybiprime(x)"},
    {"airyaiprime", "x", "", "x*airyai(x)"},
    {"airybiprime", "x", "", "x*airybi(x)"},
    {"besselj", "n x", "", "besselj(n - 1, x) - n/x*besselj(n, x)"},
    {"bessely", "n x", "", "bessely(n - 1, x) - n/x*bessely(n, x)"},
    {"besseli", "n x", "", "besseli(n - 1, x) - n/x*besseli(n, x)"},
    {"besselk", "n x", "", "-besselk(n - 1, x) - n/x*besselk(n, x)"},
    {"pcfd", "n x", "", "x/2*pcfd(n, x) - pcfd(n + 1, x)"},
    {"hyp1f1", "a b x", "", "a/b*hyp1f1(a + 1, b + 1, x)"},
    {"hyperu", "a b x", "", "-a*hyperu(a + 1, b + 1, x)"},
    {"hyp2f1", "a b c x", "", "a*b/c*hyp2f1(a + 1, b + 1, c + 1, x)"},
    {"legenp", "n m x", "",
     "((n + 1)*x*legenp(n, m, x) - (n - m + 1)*legenp(n + 1, m, x))/(1 - x^2)"},
    {"legenq", "n m x", "",
     "((n + 1)*x*legenq(n, m, x) - (n - m + 1)*legenq(n + 1, m, x))/(1 - x^2)"}};

std::map<std::string, KnownFunction> all_functions() {
  std::map<std::string, KnownFunction> all;
  for (const TableRow& e : entries) {
    KnownFunction f;
    for (const char* c = e.arguments; *c != '\0'; c += c[1] == ' ' ? 2 : 1)
      f.arguments.emplace_back(1, *c);
    const auto formula = [&](const char* text) {
      return *text == '\0' ? std::nullopt
                           : std::optional(parse_expression(std::string(text), e.name));
    };
    f.means = formula(e.means);
    f.slope = formula(e.slope);
    all.emplace(e.name, std::move(f));
  }
  return all;
}

} // namespace

const KnownFunction* known_function(const std::string& name, std::size_t arguments) {
  static const std::map<std::string, KnownFunction> all = all_functions();
  const auto it = all.find(name);
  return it == all.end() || it->second.arguments.size() != arguments ? nullptr : &it->second;
}

} // namespace kov
