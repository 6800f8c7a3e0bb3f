#include "certify/equation/statement.hpp"

#include "exact/joined.hpp"
#include "exact/lists.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

void once(std::vector<std::string>& lines, std::string line) { add_once(lines, std::move(line)); }

// ---- certificates.md 4

void add_term(std::string& s, const Rational& c, const std::vector<std::string>& powers) {
  if (is_zero(c)) return;
  if (s.empty())
    s = sign(c) < 0 ? "-" : "";
  else
    s += sign(c) < 0 ? " - " : " + ";
  const Rational size = abs(c);
  std::vector<std::string> factors;
  if (size != Rational(1) || powers.empty()) factors.push_back(to_string(size));
  factors.insert(factors.end(), powers.begin(), powers.end());
  s += joined(factors, "*");
}

void add_power(std::vector<std::string>& powers, const char* name, long e) {
  if (e > 0) powers.push_back(e == 1 ? name : name + ("^" + std::to_string(e)));
}

std::string poly_text(const Poly& f, const char* variable = "z") {
  std::string s;
  for (long i = degree(f); i >= 0; --i) {
    const NfElem c = f.coeff(i);
    for (long j = c.field()->degree() - 1; j >= 0; --j) {
      std::vector<std::string> powers;
      add_power(powers, variable, i);
      add_power(powers, "a", j);
      add_term(s, c.coeff(j), powers);
    }
  }
  return s.empty() ? "0" : s;
}

std::string minimal_polynomial(const Field& k) {
  return poly_text(Poly::from_coefficients(mapped<NfElem>(
                       k->minpoly_coefficients(), [](const Integer& c) { return Rational(c); })),
                   "a");
}

std::string claimed(const Claim& c) {
  std::vector<std::string> said;
  const std::string group = "the differential Galois group is ";
  const std::string component = "its identity component is ";
  if (c.group) said.push_back(group + *c.group + (c.n ? "_" + to_string(*c.n) : ""));
  if (c.component) said.push_back(component + *c.component);
  if (c.abelian)
    said.push_back((c.component ? "" : component) + (*c.abelian ? "abelian" : "not abelian"));
  return joined(said, ", ");
}

// ---- the data of a step

std::string in_brackets(const Poly& f) { return "(" + poly_text(f) + ")"; }
std::string modulo(const PrimeIdeal& p) { return " modulo " + std::to_string(p.p); }

std::string step_text(const Local& x) {
  std::string s;
  for (const LocalPlace& e : x.places)
    s += (s.empty() ? "" : "*") + in_brackets(e.q) +
         (e.order == 1 ? "" : "^" + std::to_string(e.order));
  return "den = " + (s.empty() ? "1" : s);
}
std::string step_text(const Exponential& x) {
  return "omega = " + in_brackets(x.num) + "/" + in_brackets(x.den) +
         (degree(x.p) > 0 ? " + p'/p, p = " + poly_text(x.p) : "");
}
std::string step_text(const Invariant& x) {
  std::string s = "m = " + std::to_string(x.m) + ", v = " + in_brackets(x.p);
  for (const InvariantFactor& f : x.factors)
    if (!is_zero(f.e)) s += "*" + in_brackets(f.q) + "^(" + to_string(f.e) + ")";
  return s;
}
std::string step_text(const NoExponential& x) {
  const auto* series = std::get_if<BySeries>(&x.by);
  return series                                   ? "by series" + modulo(series->prime)
         : std::holds_alternative<ByParity>(x.by) ? "by parity"
                                                  : "by degree";
}
std::string step_text(const PCurvature& x) { return x.shows + modulo(x.prime); }
std::string step_text(const NoInvariant& x) {
  const auto* rank = std::get_if<RankModP>(&x.by);
  return "m = " + std::to_string(x.m) +
         (rank ? ", by series" + modulo(rank->prime) : ", by degree");
}
std::string step_text(const TorsionFunction& x) {
  return "n = " + std::to_string(x.n) + ", h = (" + in_brackets(x.a) + " + " + in_brackets(x.b) +
         " w s)/" + in_brackets(x.den);
}
std::string step_text(const GoodReduction& x) { return "p = " + std::to_string(x.prime.p); }
std::string step_text(const Conclude&) { return ""; }
std::string step_text(const ApplyTheorem& x) {
  return quoted(x.theorem) + ": " + quoted(x.statement);
}

// ---- strata_certificates.md 8

std::string parameters(const StrataCertificate& c) {
  std::vector<std::string> in_C, in_R, in_Q, kinds;
  for (std::size_t i = 1; i < c.ring->size(); ++i)
    (c.rational[i] ? in_Q : c.real[i] ? in_R : in_C).push_back(c.ring->name(i));
  for (const auto& [names, field] : {std::pair(in_C, " in C"), {in_R, " in R"}, {in_Q, " in Q"}})
    if (!names.empty()) kinds.push_back(joined(names, ", ") + field);
  return kinds.empty() ? "the equation" : "all " + joined(kinds, "; ");
}

std::string given(const StrataCertificate& c) {
  std::vector<std::string> all;
  for (const Condition& x : c.assumptions)
    once(all, text_of(x));
  for (const auto& [value, integral] : c.memberships)
    once(all, "(" + to_string(value.num) + ")/(" + to_string(value.den) + ") " +
                  (integral ? "in Z" : "not in Z"));
  return all.empty() ? "" : " with " + joined(all, ", ");
}

} // namespace

std::string shown(const Rule& rule) {
  return std::visit([](const auto& x) { return step_text(x); }, rule);
}

std::string over_field(const Poly& f) { return poly_text(f); }

std::string quoted(const std::string& text) {
  std::string s = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) == 0x80U) continue;                        // inside a character of UTF-8
    s += byte < 0x20 || byte >= 0x7F ? '?' : c == '"' ? '\'' : c; // it does not end its quotation
  }
  return s + "\"";
}

std::string equation_text(const std::string& num, const std::string& den) {
  const auto factor = [](const std::string& text, const char* signs) {
    return text.find_first_of(signs) == std::string::npos ? text : "(" + text + ")";
  };
  if (den == "1" && num == "1") return "y'' = y";
  if (den == "1") return "y'' = " + factor(num, " /") + " y";
  return "y'' = (" + factor(num, " /") + "/" + factor(den, " /*") + ") y";
}

std::vector<std::string> statement(const Certificate& c) {
  std::string equation = equation_text(poly_text(c.num), poly_text(c.den));
  if (!c.field->is_rational()) equation += ", " + minimal_polynomial(c.field) + " = 0";
  std::vector<std::string> lines{std::move(equation), claimed(c.claim)};
  for (const Step& s : c.steps)
    if (const auto* x = std::get_if<ApplyTheorem>(&s.rule))
      lines.push_back("trusted, " + quoted(x->theorem) + ": " + quoted(x->statement));
  return lines;
}

std::vector<std::string> statement(const StrataCertificate& c, const StrataAccepted& found) {
  std::vector<std::string> lines{"for " + parameters(c) + given(c)};
  for (const auto& group : c.generic) {
    if (std::ranges::any_of(group, [](const MPoly& f) { return is_constant(f) && !is_zero(f); }))
      continue;
    const auto text = [](const MPoly& f) { return to_string(f); };
    once(lines, "except where " + joined(group, text, " = ") + " = 0");
  }
  const auto used = used_variables(c.r.den);
  if (std::ranges::any_of(used, [](std::size_t i) { return i != 0; }))
    lines.push_back("except where " + to_string(c.r.den) + " = 0 for all " + c.ring->name(0));
  const char* said = !c.abelian ? "on these strata:" : *c.abelian ? "abelian" : "not abelian";
  lines.push_back("the identity component of the differential Galois group of " +
                  equation_text(to_string(c.r.num), to_string(c.r.den)) + " is " + said);
  lines.insert(lines.end(), found.lines.begin(), found.lines.end());
  return lines;
}

} // namespace kov::certify
