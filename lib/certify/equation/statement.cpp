#include "certify/equation/statement.hpp"

#include "certify/strata/classical.hpp"
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

std::string poly_text(const Poly& f) {
  std::string s;
  for (long i = degree(f); i >= 0; --i) {
    const NfElem c = f.coeff(i);
    for (long j = c.field()->degree() - 1; j >= 0; --j) {
      std::vector<std::string> powers;
      add_power(powers, "z", i);
      add_power(powers, "a", j);
      add_term(s, c.coeff(j), powers);
    }
  }
  return s.empty() ? "0" : s;
}

std::string minimal_polynomial(const Field& k) {
  std::string s;
  const auto m = k->minpoly_coefficients();
  for (std::size_t j = m.size(); j-- > 0;) {
    std::vector<std::string> powers;
    add_power(powers, "a", static_cast<long>(j));
    add_term(s, Rational(m[j]), powers);
  }
  return s;
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

std::size_t trusted_steps(const Certificate& c) {
  return static_cast<std::size_t>(std::ranges::count_if(
      c.steps, [](const Step& s) { return std::holds_alternative<ApplyTheorem>(s.rule); }));
}

// ---- strata_certificates.md 8

class StrataStatement {
public:
  explicit StrataStatement(const StrataCertificate& c) : c_(c) {}

  std::vector<std::string> operator()() {
    lines_.push_back("for " + parameters() + given());
    exceptions();
    const char* said = !c_.abelian ? "on these strata:" : *c_.abelian ? "abelian" : "not abelian";
    lines_.push_back("the identity component of the differential Galois group of " +
                     equation_text(to_string(c_.r.num), to_string(c_.r.den)) + " is " + said);
    node(*c_.tree);
    return std::move(lines_);
  }

private:
  [[nodiscard]] std::string parameters() const {
    std::vector<std::string> in_C;
    std::vector<std::string> in_R;
    std::vector<std::string> in_Q;
    for (std::size_t i = 1; i < c_.ring->size(); ++i)
      (c_.rational[i] ? in_Q : c_.real[i] ? in_R : in_C).push_back(c_.ring->name(i));
    std::vector<std::string> kinds;
    for (const auto& [names, field] : {std::pair(in_C, " in C"), {in_R, " in R"}, {in_Q, " in Q"}})
      if (!names.empty()) kinds.push_back(joined(names, ", ") + field);
    return kinds.empty() ? "the equation" : "all " + joined(kinds, "; ");
  }

  [[nodiscard]] std::string given() const {
    std::vector<std::string> all;
    for (const Condition& x : c_.assumptions)
      once(all, text_of(x));
    for (const auto& [value, integral] : c_.memberships)
      once(all, "(" + to_string(value.num) + ")/(" + to_string(value.den) + ") " +
                    (integral ? "in Z" : "not in Z"));
    return all.empty() ? "" : " with " + joined(all, ", ");
  }

  void exceptions() {
    for (const auto& group : c_.generic) {
      if (std::ranges::any_of(group, [](const MPoly& f) { return is_constant(f) && !is_zero(f); }))
        continue;
      const auto text = [](const MPoly& f) { return to_string(f); };
      once(lines_, "except where " + joined(group, text, " = ") + " = 0");
    }
    const auto used = used_variables(c_.r.den);
    if (std::ranges::any_of(used, [](std::size_t i) { return i != 0; }))
      lines_.push_back("except where " + to_string(c_.r.den) + " = 0 for all " + c_.ring->name(0));
  }

  void say(const std::string& what) {
    lines_.push_back("  " + (path_.empty() ? "always" : joined(path_, ", ")) + ": " + what);
  }
  void node(const StrataNode& n) {
    std::visit([&](const auto& x) { take(x); }, n.kind);
  }
  void where_zero(const MPoly& p, const WhereZero& z) {
    path_.push_back(to_string(p) + " = 0");
    std::visit([&](const auto& x) { take(x); }, z);
    path_.pop_back();
  }

  void take(const SplitNode& n) {
    path_.push_back(to_string(n.p) + " != 0");
    node(*n.nonzero);
    path_.pop_back();
    where_zero(n.p, n.zero);
  }
  void take(const AssumedNode& n) { where_zero(n.p, n.zero); }
  void take(const LemmasNode& n) { node(*n.then); }
  void take(const SolvedStratum& n) { node(*n.then); }
  void take(const LeafNode& n) {
    if (const auto* c = std::get_if<ByClassical>(&n.by))
      return say((n.abelian ? word(*n.abelian) : "abelian exactly where " + criterion(*c)) + " (" +
                 c->family + ")");
    const bool abelian = n.abelian.value();
    if (const auto* x = std::get_if<ByNumber>(&n.by)) return nested(abelian, "number", *x);
    const auto* x = std::get_if<ByPlaces>(&n.by);
    say(word(abelian) + " (" + (x ? to_string(x->theorem) : "invariant") + ")");
  }
  void take(const RootStratum& n) { nested(n.abelian, "root", n); }
  void take(const EmptyStratum&) {}
  void take(const OutsideStratum&) {}
  void take(const OpenStratum& n) { say("undecided (" + quoted(n.reason) + ")"); }
  void take(const TrustedStratum& n) {
    say((n.abelian == "empty" ? "no points" : word(n.abelian == "yes")) + " (trusted, " +
        quoted(n.theorem) + ": " + quoted(n.statement) + ")");
  }

  template <class Leaf> void nested(bool abelian, const std::string& by, const Leaf& leaf) {
    const std::size_t k = trusted_steps(leaf.certificate);
    say(word(abelian) + " (" + by + (k > 0 ? ", " + std::to_string(k) + " trusted" : "") + ")");
  }
  static std::string word(bool abelian) { return abelian ? "abelian" : "not abelian"; }

  const StrataCertificate& c_;
  std::vector<std::string> path_, lines_;
};

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

std::vector<std::string> statement(const StrataCertificate& c) { return StrataStatement(c)(); }

} // namespace kov::certify
