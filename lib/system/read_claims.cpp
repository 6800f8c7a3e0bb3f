// Claims, manifolds, the reduction, assumptions and expectations of a system file.

#include "exact/linear_fraction.hpp"
#include "exact/lists.hpp"
#include "symbol/author_words.hpp"
#include "symbol/suggest.hpp"
#include "system/read_system.hpp"

#include <algorithm>
#include <array>

namespace kov {
namespace {

constexpr std::array claim_sections{std::pair("integral", SystemClaim::Kind::integral),
                                    std::pair("casimir", SystemClaim::Kind::casimir),
                                    std::pair("darboux", SystemClaim::Kind::darboux),
                                    std::pair("poisson", SystemClaim::Kind::poisson),
                                    std::pair("equal", SystemClaim::Kind::equal)};

void read_claim(const Entry& e, SystemClaim& claim, const SystemScope& scope) {
  e.check_keys(
      {"name", "value", "first", "second", "left", "right", "with", "on", "holds", "source"});
  claim.line = e.line();
  if (const Entry* on = e.find("on")) claim.on = scope.equations(*on);
  if (const Entry* holds = e.find("holds")) claim.holds = holds->boolean();
  if (const Entry* source = e.find("source")) claim.source = one_line(source->string());
  if (const Entry* name = e.find("name")) claim.name = one_line(name->string());
  if (claim.kind == SystemClaim::Kind::equal && e.find("with")) {
    claim.other = one_line(e.at("with").string());
    claim.text = "the same vector field as " + claim.other;
    return;
  }
  if (claim.kind == SystemClaim::Kind::equal) {
    claim.value =
        evaluate(e.at("left").expression(), scope) - evaluate(e.at("right").expression(), scope);
    claim.text = one_line(e.at("left").string() + " = " + e.at("right").string());
    return;
  }
  const Entry* value = e.find("value");
  if (!value) {
    const auto known = scope.value(claim.name);
    if (!known) throw e.error("the key 'value' is missing");
    claim.value = *known;
    claim.text = claim.name;
  } else {
    claim.value = evaluate(value->expression(), scope);
    claim.text = one_line(value->string());
  }
  if (claim.kind == SystemClaim::Kind::poisson) {
    claim.first = evaluate(e.at("first").expression(), scope);
    claim.second = evaluate(e.at("second").expression(), scope);
    claim.text = one_line("{" + e.at("first").string() + ", " + e.at("second").string() +
                          "} = " + value->string());
  }
}

void read_weights(const Entry& document, const SystemScope& scope, System& s) {
  const Entry* expansion = document.find("expansion");
  if (!expansion) return;
  expansion->check_keys({"weights", "terms"});
  for (const auto& [name, entry] : expansion->at("weights").members()) {
    const auto i = scope.ring()->find(name);
    if (!i) throw entry.error("'" + name + "' is not a variable of this system");
    const MFraction w = evaluate(entry.expression(), scope);
    if (!is_constant(w) || !is_integer(to_rational(w)))
      throw entry.error("a weight must be an integer");
    s.weights[*i] = to_long(floor(to_rational(w)));
  }
  if (const Entry* terms = expansion->find("terms")) {
    const MFraction n = evaluate(terms->expression(), scope);
    if (!is_constant(n) || !is_integer(to_rational(n)) || to_rational(n) < Rational(1) ||
        to_rational(n) > Rational(20))
      throw terms->error("the number of terms must be an integer from 1 to 20");
    s.expansion_terms = to_long(floor(to_rational(n)));
  }
}

void check_assumption(const Assumption& a, const Entry& entry) {
  if (!is_constant(a.value) || a.holds_at(to_rational(a.value))) return;
  throw entry.error("the assumption '" + a.text + "' is violated by the values given",
                    "the left side minus the right side is " + to_string(to_rational(a.value)));
}

// A name that is put to a function of other parameters is real, and its value; of what the value is
// made of nothing is said, unless it is one parameter moved and scaled.
void say_real(const std::string& name, const SystemScope& scope, System& s) {
  if (const auto value = scope.value(name))
    if (const auto i = variable_of_linear_fraction(*value)) s.real.insert(s.ring()->name(*i));
}

Assumption read_condition(const Entry& entry, const SystemScope& scope, System& s) {
  const std::string& text = entry.string();
  const auto c = comparison(text);
  if (!c) throw entry.error("a condition was expected", "for example \"A + B >= C\" or \"d != 0\"");
  const auto side = [&](std::string_view part) {
    const auto at = static_cast<std::size_t>(part.data() - text.data());
    return parse_expression(std::string(part), origin_from(entry.origin(), at));
  };
  const Expression left = side(c->left), right = side(c->right);
  if (certify::is_ordered(c->sign))
    for (const Expression* one : {&left, &right})
      for (const std::string& name : names_in(*one))
        say_real(name, scope, s);
  return {c->sign, evaluate(left, scope) - evaluate(right, scope), one_line(text), entry.line()};
}

void require_parameters(const MFraction& f, const Entry& entry, const System& s) {
  for (const std::size_t i : used_variables(f))
    if (!is_among(i, s.field.parameters) && !is_among(i, s.field.constants))
      throw entry.error("'" + s.ring()->name(i) + "' is not a parameter",
                        "assumptions are about parameters");
}

} // namespace

bool Assumption::is_ordered() const { return is(Sign::positive) || is(Sign::nonnegative); }

bool Assumption::holds_at(const Rational& v) const {
  if (const auto* s = std::get_if<Sign>(&says)) return certify::allows(*s, sign(v));
  return !is(Sort::integer) || is_integer(v);
}

bool Assumption::holds_near(const Rational& v) const {
  const bool is_open = is_nonzero() || is(Sign::nonnegative);
  return is(Sort::real) || (is_open && !is_zero(v) && holds_at(v));
}

std::optional<Comparison> comparison(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, Sign>, 6> signs{{{">=", Sign::nonnegative},
                                                                    {"<=", Sign::nonnegative},
                                                                    {"!=", Sign::nonzero},
                                                                    {">", Sign::positive},
                                                                    {"<", Sign::positive},
                                                                    {"=", Sign::zero}}};
  for (const auto& [mark, sign] : signs) {
    const std::size_t at = text.find(mark);
    if (at == std::string_view::npos) continue;
    Comparison c{sign, text.substr(0, at), text.substr(at + mark.size())};
    if (mark[0] == '<') std::swap(c.left, c.right);
    return c;
  }
  return std::nullopt;
}

void forget_assumptions(std::size_t parameter, System& s) {
  std::erase_if(s.assumptions, [&](const Assumption& a) { return uses(a.value, parameter); });
  s.real.erase(s.ring()->name(parameter));
}

void assume_nonzero(const MPoly& p, long line, System& s) {
  const MFraction value(p);
  const auto is_known = [&](const Assumption& a) {
    return a.is(Sign::nonzero) && a.value == value;
  };
  if (!is_zero(p) && is_constant(p)) return;
  if (std::ranges::any_of(s.assumptions, is_known)) return;
  s.assumptions.push_back({Sign::nonzero, value, to_string(p) + " != 0", line});
}

namespace {

// A condition on a quotient says that it has a value.
void add_assumption(Assumption a, const Entry& entry, System& s) {
  require_parameters(a.value, entry, s);
  check_assumption(a, entry);
  const MFraction value = a.value;
  s.assumptions.push_back(std::move(a));
  if (!is_zero(value)) assume_nonzero(value.den(), entry.line(), s);
}

void read_assumptions(const Entry& document, const SystemScope& scope, System& s) {
  const Entry* assume = document.find("assume");
  if (!assume) return;
  scope.take_divisors(); // those of claims say nothing of the system
  const std::vector<std::pair<std::string, Assumption::Says>> words{
      {"positive", Sign::positive}, {"nonnegative", Sign::nonnegative}, {"nonzero", Sign::nonzero},
      {"real", Sort::real},         {"rational", Sort::rational},       {"integer", Sort::integer}};
  for (const auto& [name, entry] : assume->members()) {
    if (name == "conditions") {
      for (const Entry* one : entry.list())
        add_assumption(read_condition(*one, scope, s), *one, s);
      continue;
    }
    const auto v = scope.value(name);
    if (!v) throw entry.key_error("'" + name + "' is not a name of this system");
    const auto word =
        std::ranges::find_if(words, [&](const auto& w) { return w.first == entry.string(); });
    if (word == words.end()) {
      auto known = mapped<std::string>(words, [&](const auto& w) { return w.first; });
      throw entry.error("unknown assumption '" + entry.string() + "'",
                        "use one of " + enumerate(known) + ", or conditions = [\"...\"]");
    }
    if (word->second != Assumption::Says(Sign::nonzero)) say_real(name, scope, s);
    add_assumption({word->second, *v, name + " " + word->first, entry.line()}, entry, s);
  }
  for (const MPoly& d : scope.take_divisors())
    s.domain.require(d, s.field, scope.meanings);
}

void read_reduction(const Entry& e, const SystemScope& scope, System& s) {
  e.check_keys({"manifold", "normal", "variable", "change", "energy", "energy_parameter"});
  ReduceSpec r;
  r.line = e.line();
  r.variable_name = scope.independent;
  if (const Entry* m = e.find("manifold")) {
    r.manifold = one_line(m->string());
    if (std::ranges::none_of(s.manifolds,
                             [&](const ManifoldSpec& spec) { return spec.name == r.manifold; }))
      throw m->error("there is no manifold '" + r.manifold + "'");
  }
  if (const Entry* change = e.find("change")) {
    const Expression text = change->expression(true);
    if (text.kind() != Expression::Kind::equation ||
        text.operand(0).kind() != Expression::Kind::name ||
        text.operand(0).name() != scope.independent)
      throw text.error("a change of variable was expected",
                       "write it as '" + scope.independent + " = ...'");
    r.change = evaluate(text.operand(1), scope);
    r.change_text = one_line(change->string());
  }
  const auto coordinate = [&](const Entry& entry) {
    const auto i = scope.ring()->find(entry.string());
    if (!i || !is_among(entry.string(), scope.coordinates))
      throw entry.error("'" + entry.string() + "' is not a coordinate",
                        "coordinates: " + enumerate(scope.coordinates));
    return *i;
  };
  if (const Entry* normal = e.find("normal"))
    for (const Entry* one : normal->list()) {
      if (!r.unknown) r.unknown = coordinate(*one);
      r.normal.push_back(scope.ring()->name(coordinate(*one)));
    }
  if (const Entry* unknown = e.find("variable")) r.unknown = coordinate(*unknown);
  if (const Entry* energy = e.find("energy")) {
    r.energy = energy->string();
    if (r.energy != "auto")
      throw energy->error("energy can only be \"auto\"",
                          "a level is said in [[manifold]]: level = \"H = ...\"");
  }
  if (const Entry* h = e.find("energy_parameter")) r.energy_parameter = h->string();
  s.reductions.push_back(std::move(r));
}

} // namespace

void read_claims(const Entry& document, SystemScope& scope, System& s) {
  for (const auto& [section, kind] : claim_sections) { // names first: formulas may use them
    const Entry* claims = document.find(section);
    if (!claims || kind == SystemClaim::Kind::poisson || kind == SystemClaim::Kind::equal) continue;
    for (const Entry* e : claims->list())
      if (const Entry* name = e->find("name"); name && e->find("value"))
        scope.define(name->string(), e->at("value"));
  }
  for (const auto& [section, kind] : claim_sections) {
    const Entry* claims = document.find(section);
    if (!claims) continue;
    for (const Entry* e : claims->list()) {
      SystemClaim claim;
      claim.kind = kind;
      read_claim(*e, claim, scope);
      s.claims.push_back(std::move(claim));
    }
  }
  read_weights(document, scope, s);
  read_assumptions(document, scope, s);
}

void read_manifolds(const Entry& document, const SystemScope& scope, System& s) {
  if (const Entry* manifolds = document.find("manifold"))
    for (const Entry* e : manifolds->list()) {
      e->check_keys({"name", "equations", "level", "nonzero"});
      ManifoldSpec m;
      m.line = e->line();
      m.name = e->find("name") ? one_line(e->at("name").string())
                               : "manifold " + std::to_string(s.manifolds.size() + 1);
      m.equations = scope.equations(e->at("equations"));
      if (const Entry* level = e->find("level")) m.levels = scope.equations(*level);
      if (const Entry* nonzero = e->find("nonzero"))
        for (const Entry* one : nonzero->list())
          m.nonzero.push_back(evaluate(one->expression(), scope).num());
      s.manifolds.push_back(std::move(m));
    }
  if (const Entry* reduce = document.find("reduce"))
    for (const Entry* e : reduce->list())
      read_reduction(*e, scope, s);
}

void read_expectations(const Entry& document, const SystemScope& scope, System& s) {
  const Entry* expect = document.find("expect");
  if (!expect) return;
  for (const Entry* e : expect->list()) {
    e->check_keys({"where", "manifold", "verdict", "group", "identity_component", "abelian", "p",
                   "q", "r", "source", "case", "requires", "outcome"});
    SystemExpectation x;
    x.line = e->line();
    if (const Entry* where = e->find("where"))
      for (const auto& [name, value] : where->members())
        x.where.emplace_back(name, value.string());
    const auto text = [&](std::string_view key, std::string& to) {
      if (const Entry* v = e->find(key)) to = one_line(v->string());
    };
    text("manifold", x.manifold);
    text("verdict", x.verdict);
    text("group", x.group);
    text("identity_component", x.identity_component);
    text("abelian", x.abelian);
    text("source", x.source);
    if (const Entry* number = e->find("case")) x.kovacic_case = number->integer();
    if (const Entry* outcome = e->find("outcome")) {
      const std::array outcomes{"exponential", "imprimitive", "algebraic", "no-liouvillian"};
      const auto place = std::ranges::find(outcomes, outcome->string());
      if (place == outcomes.end())
        throw outcome->error("unknown outcome '" + outcome->string() + "'",
                             "use exponential, imprimitive, algebraic or no-liouvillian");
      x.kovacic_case = place - outcomes.begin() + 1;
    }
    const std::array verdicts{"", "non-integrable", "no-obstruction", "depends", "undecided"};
    if (!is_among(x.verdict, verdicts))
      throw e->at("verdict").error("unknown verdict '" + x.verdict + "'",
                                   "use non-integrable, no-obstruction, depends or undecided");
    scope.named[scope.independent] = MFraction::variable(scope.ring(), scope.independent);
    const auto formula = [&](std::string_view key, std::optional<MFraction>& to) {
      if (const Entry* v = e->find(key)) to = evaluate(v->expression(), scope);
    };
    formula("p", x.p);
    formula("q", x.q);
    formula("r", x.r);
    s.expectations.push_back(std::move(x));
  }
}

const ReduceSpec* reduction_for(const System& s, const std::string& manifold) {
  for (const auto& r : s.reductions)
    if (r.manifold.empty() || r.manifold == manifold) return &r;
  return nullptr;
}

} // namespace kov
