// The steps about vector fields: claims, lowest order.

#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "theorem/prove.hpp"
#include "theorem/setting.hpp"

#include "certify/theorem/computed.hpp"
#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "integrability/parameters.hpp"
#include "symbol/author_words.hpp"
#include "symbol/suggest.hpp"
#include "system/claims.hpp"
#include "system/formula.hpp"
#include "system/in_ring.hpp"
#include "system/weights.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

std::string on_level(const SystemClaim& c) {
  return c.on.empty() ? "" : " on " + joined(c.on, &Equation::text);
}

// Formulas only: the name of a claim may be any words, and is said if it is an identifier.
std::string words(const SystemClaim& c) {
  using Kind = SystemClaim::Kind;
  const bool is_named = is_identifier(c.name) && c.name != c.text;
  const std::string value =
      c.name == c.text && !is_identifier(c.name) ? to_string(c.value) : c.text;
  const std::string formula = is_named ? c.name + " = " + value : value;
  switch (c.kind) {
  case Kind::integral:
    return formula + " is a first integral" + on_level(c);
  case Kind::casimir:
    return formula + " is a Casimir function" + on_level(c);
  case Kind::darboux:
    return formula + " is a Darboux polynomial: " + (is_identifier(c.name) ? c.name : value) +
           " = 0 is invariant" + on_level(c);
  default: // brackets and identities carry their own = sign
    return c.text + on_level(c);
  }
}

// A claim that is expected to fail: it fails for some parameters, as far as this goes.
std::string refutation(const System& s, bool proved) {
  if (proved) return ": claimed to fail, but it holds";
  return s.field.parameters.empty() ? ": claimed to fail, and it does"
                                    : ": claimed not to hold for all parameters, and it does not";
}

// Ziglin's lemma is about power series in the coordinates, which all count at least 1.
std::string no_grading(const System& s) {
  const auto& x = s.field.coordinates;
  for (const auto& [i, weight] : s.weights)
    if (!is_among(i, x)) return s.ring()->name(i) + " has a weight and is not a coordinate";
  for (const std::size_t i : x)
    if (const auto w = s.weights.find(i); w == s.weights.end() || w->second < 1)
      return "the coordinate " + s.ring()->name(i) + " has no weight of 1 or more";
  return "";
}

// The lowest-order part is the same formula for all parameters: that of the denominator is nowhere
// 0.  (Of e x/(e + y) it is x, but 0 for e = 0.)
bool keeps_its_lowest_order(const System& s, const MFraction& f) {
  if (is_zero(f)) return true;
  const auto all = nonzero_coefficients(lowest_part(f.den(), s.weights), s.field.coordinates);
  return std::ranges::any_of(all, [&](const MPoly& c) { return not_excluded(s, {c}).empty(); });
}

std::string other_lowest_order_somewhere(const System& s) {
  for (std::size_t j = 0; j < s.field.dimension(); ++j)
    if (!keeps_its_lowest_order(s, s.field.components[j])) return s.field.name(j) + "'";
  if (s.field.poisson)
    for (const auto& row : *s.field.poisson)
      for (const MFraction& entry : row)
        if (!keeps_its_lowest_order(s, entry)) return "the bracket";
  return "";
}

// The systems whose lowest order is understood here.
void require_lowest_order(const System& s, const System& other) {
  if (s.weights.empty()) throw DomainError(s.file + " has no [expansion] with weights");
  for (const System* one : {&s, &other})
    if (!one->field.functions.empty() || !one->field.relations.empty())
      throw DomainError("the lowest order of a system with functions or relations is not known");
  if (const auto why = no_grading(s); !why.empty()) throw DomainError(why);
  if (const auto what = other_lowest_order_somewhere(s); !what.empty())
    throw DomainError("the lowest order of " + what + " may be another one for some parameters");
}

bool same_function(const MFraction& f, const MFraction& g) {
  if (is_zero(f) || is_zero(g)) return is_zero(f) && is_zero(g);
  for (const std::size_t v : used_variables(f))
    if (!g.ring()->find(f.ring()->name(v))) return false;
  return transfer(f, g.ring()) == g;
}

// The same coordinates have the same brackets; true if `g` has no bracket.
bool same_bracket(const VectorField& f, const VectorField& g) {
  if (!g.poisson) return true;
  if (!f.poisson || f.dimension() != g.dimension()) return false;
  for (std::size_t i = 0; i < f.dimension(); ++i)
    for (std::size_t j = 0; j < f.dimension(); ++j)
      if (f.name(i) != g.name(i) || !same_function((*f.poisson)[i][j], (*g.poisson)[i][j]))
        return false;
  return true;
}

void conclude(NodeResult& n, const std::string& proved) {
  n.status = all_hold(n.checks) ? NodeStatus::proved : NodeStatus::refuted;
  n.summary = proved;
  if (n.status == NodeStatus::refuted)
    for (const CheckedIdentity& c : n.checks)
      if (!c.holds) n.summary = "false: " + c.statement;
}

// A point with small coordinates, pseudo-random, where the equations hold and f is defined.
class Points {
public:
  explicit Points(const Ring& ring) : ring_(ring) {}
  Substitution next() {
    Substitution point;
    for (std::size_t i = 0; i < ring_->size(); ++i) {
      state_ = state_ * 6364136223846793005UL + 1442695040888963407UL;
      point[i] = MFraction(ring_, Rational(static_cast<long>((state_ >> 33U) % 7U) - 3));
    }
    return point;
  }

private:
  Ring ring_;
  std::uint64_t state_ = 1;
};

// The rank of a matrix of functions at a point, or 0 if one is not defined there: at most the rank
// in general.
std::size_t rank_at(const System& s, const Matrix& fields, const Substitution& point) {
  Matrix rows = fields;
  try {
    for (auto& row : rows)
      for (MFraction& x : row)
        x = is_zero(x) ? MFraction(s.ring(), Rational(0)) : substitute(x, point);
  } catch (const DomainError&) {
    return 0;
  }
  return s.field.dimension() - null_space(rows, s.field.dimension(), s.ring()).size();
}

constexpr int most_points = 3000, most_points_on_level = 12;

// Enough commuting integrals for Liouville's sense: H and those that the file claims, with as many
// independent Hamiltonian fields as half the rank of the bracket; on the level of the claims.
void put_further_integrals(NodeResult& n, const System& s) {
  if (n.status != NodeStatus::proved || !s.field.poisson || !s.field.hamiltonian) return;
  if (!s.field.relations.empty() || !s.field.functions.empty()) return;
  std::vector<MFraction> functions{*s.field.hamiltonian}, level;
  std::string names;
  for (const SystemClaim& c : s.claims) {
    if (c.kind != SystemClaim::Kind::integral || !c.holds) continue;
    functions.push_back(c.value);
    names += (names.empty() ? "" : ", ") + words(c);
    for (const Equation& e : c.on)
      level.push_back(e.difference);
  }
  for (std::size_t i = 1; i < functions.size() && level.empty(); ++i)
    for (std::size_t j = 1; j < i; ++j)
      if (!is_zero(poisson_bracket(s.field, functions[i], functions[j]))) return;
  if (functions.size() > 2 && !level.empty()) return; // do they commute there?
  // the rank in general: at special points the bracket has a smaller one
  const std::size_t needed =
      s.field.dimension() - null_space(*s.field.poisson, s.field.dimension(), s.ring()).size();
  Matrix fields;
  for (const MFraction& f : functions)
    fields.push_back(hamiltonian_field(s.field, *s.field.poisson, f));
  Points points(s.ring());
  int on_level = 0;
  for (int tries = 0; tries < most_points && on_level < most_points_on_level; ++tries) {
    const Substitution point = points.next();
    if (std::ranges::any_of(level, [&](const MFraction& f) {
          return !is_zero(substitute(f.num(), point)) || is_zero(substitute(f.den(), point));
        }))
      continue;
    ++on_level;
    if (2 * rank_at(s, fields, point) < needed) continue;
    n.says = Conclusion::has_integral;
    n.integrals = names;
    n.checks.push_back({"H and these integrals commute, and for generic values enough of them are "
                        "independent: at a rational point their Hamiltonian fields have rank " +
                            std::to_string(rank_at(s, fields, point)),
                        true});
    n.statement += ". So it is integrable in Liouville's sense" +
                   std::string(needed < s.field.dimension() ? ", on symplectic leaves" : "") +
                   std::string(level.empty() ? "" : " on that level") +
                   " for generic values of its parameters";
    return;
  }
}

} // namespace

void require_known(const std::string& name, const std::vector<std::string>& known,
                   const std::string& what) {
  if (is_among(name, known)) return;
  const auto near = nearest(name, known);
  throw InputError("", 0, 0, 1, "'" + name + "' is not a " + what,
                   near            ? "did you mean " + *near + "?"
                   : known.empty() ? "there is none"
                                   : "known: " + enumerate(known));
}

std::vector<std::string> free_parameters(const System& s) {
  std::vector<std::string> names;
  for (const std::size_t i : s.field.parameters)
    if (!s.values.contains(s.ring()->name(i))) names.push_back(s.ring()->name(i));
  return names;
}

std::string beside(const std::string& directory, const std::string& file) {
  return file.starts_with('/') ? file : directory + file;
}

std::string values_of(const System& s) {
  return joined(s.values, [](const auto& v) { return v.first + " = " + to_string(v.second); });
}

void show_setting(NodeResult& n, const System& s) {
  if (!s.values.empty()) n.formulas.push_back({"with", values_of(s)});
}

std::string not_integrable(const std::vector<IntegralClass>& excluded) {
  return "The system is not integrable with " + first_integrals(excluded);
}

void prove_trusted(NodeResult& n) {
  n.status = NodeStatus::trusted;
  n.on_trust = true;
  n.trusted = {{Trusted::Step::by_author, n.node.step}};
  n.summary = n.node.step;
  n.says = n.node.integrable ? Conclusion::has_integral : Conclusion::not_integrable;
  if (n.node.integrable)
    n.integrals = n.node.step;
  else
    n.excluded = {n.node.integrals};
  n.statement = n.node.integrable ? "The system is integrable" : not_integrable(n.excluded);
}

void prove_or_trust(NodeResult& n, const ProveOptions& options,
                    const std::function<void(NodeResult&)>& prove) {
  if (n.node.step.empty() || !options.found) return prove(n);
  NodeResult trial = n;
  tried<Error>([&] { prove(trial); }); // else it stays on trust
  const auto says = n.node.integrable ? Conclusion::has_integral : Conclusion::not_integrable;
  const bool is_found = trial.status == NodeStatus::proved && trial.says == says;
  if (is_found || trial.status == NodeStatus::refuted) {
    n = std::move(trial);
    return;
  }
  prove_trusted(n);
  n.is_word = true;
}

namespace {

// The claims of a stratum as what it is integrable by; the certificate has their independence.
void say_integrable(NodeResult& n, const System& s) {
  if (!n.node.integrable || n.status != NodeStatus::proved) return;
  n.says = Conclusion::has_integral;
  for (const SystemClaim& c : s.claims)
    if (c.kind == SystemClaim::Kind::integral)
      n.integrals += (n.integrals.empty() ? "" : ", ") + words(c);
}

void prove_all_claims(NodeResult& n, const std::string& directory, const ProveOptions& options);

} // namespace

void prove_claims(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  prove_or_trust(n, options, [&](NodeResult& x) { prove_all_claims(x, directory, options); });
}

namespace {

// A function that is 0 where the equations hold that are assumed of parameters.
bool vanishes_as_assumed(const System& s, const MFraction& f) {
  const auto& names = s.field.parameters;
  const auto of_parameters = [&](const MPoly& p) { return uses_only(p, names); };
  std::vector<MPoly> equations;
  for (const Assumption& a : s.assumptions)
    if (a.is(Sign::zero) && of_parameters(a.value.num())) equations.push_back(a.value.num());
  certify::Arithmetic arithmetic;
  return !is_zero(f) && !equations.empty() && is_constant(MFraction(f.den())) &&
         is_zero(certify::modulo_equations(f.num(), equations, arithmetic));
}

// The integrals and fields of a stratum: those that a search has found, as if the file claimed them, or those of
// the file, as if a search had found them.
void share_what_is_found(System& s, TheoremNode& n) {
  if (!n.integrable) return;
  for (const auto& [name, value] : n.found.integrals) {
    SystemClaim& claim = s.claims.emplace_back();
    claim.name = name;
    claim.text = to_string(value);
    claim.value = in_names_of(s, value);
  }
  if (n.found.integrals.empty())
    for (const SystemClaim& claim : s.claims)
      if (claim.kind == SystemClaim::Kind::integral && claim.on.empty())
        n.found.integrals.emplace_back(claim.name, claim.value);
  for (const auto& row : n.fields) {
    n.found.fields.emplace_back();
    for (const std::string& text : row)
      n.found.fields.back().push_back(formula(s, text));
  }
}

void prove_all_claims(NodeResult& n, const std::string& directory, const ProveOptions& options) {
  System s = read_system(document_of(n.node, directory), n.node.where);
  show_setting(n, s);
  share_what_is_found(s, n.node);
  for (const SystemClaim& c : s.claims) {
    ClaimResult result = check_claim(s, c, options.decide.budget);
    if (!result.proved && n.node.integrable && c.kind == SystemClaim::Kind::integral)
      result.proved = vanishes_as_assumed(s, result.witness);
    std::string where;
    for (const MPoly& g : not_excluded(s, result.generic))
      where += (where.empty() ? " where " : ", ") + to_string(g) + " != 0";
    if (!where.empty())
      n.node.hypotheses.push_back(
          {"the parameters are such that '" + words(c) + "' is proved:" + where.substr(6), "",
           false});
    n.checks.push_back(
        {words(c) + (c.holds ? where : refutation(s, result.proved)), result.proved == c.holds});
  }
  if (n.checks.empty()) throw DomainError(n.node.file + " claims nothing");
  if (n.node.integrable &&
      !all_hold(n.checks)) { // where equations of the stratum hold it may be one
    n.checks.clear();
    throw DomainError("a first integral was not confirmed");
  }
  conclude(n, "every claim of the file is decided by an exact identity");
  for (const CheckedIdentity& c : n.checks)
    n.statement +=
        (n.statement.empty() ? assumptions_of(s) + "For the " + titled(s) + ": " : "; ") +
        c.statement;
  if (n.node.integrable && !options.found) // a search has shown it, or the certificate will
    n.trusted.push_back({Trusted::Step::gap, "the first integrals are independent and enough"});
  if (n.node.integrable) return say_integrable(n, s);
  put_further_integrals(n, s);
}

} // namespace

void prove_lowest_order(NodeResult& n, const std::string& directory) {
  const System s = read_system(beside(directory, n.node.file), n.node.where);
  show_setting(n, s);
  const System other = read_system(beside(directory, n.node.other), n.node.where);
  require_lowest_order(s, other);
  const LowestSystem low = lowest_system(s, s.expansion_terms);
  n.checks.push_back({"both systems have " + std::to_string(s.field.dimension()) + " coordinates",
                      s.field.dimension() == other.field.dimension()});
  n.checks.push_back({"the bracket is weight-homogeneous", low.structure.has_value()});
  n.checks.push_back({"the bracket of " + n.node.other + " is that of " + n.node.file,
                      same_bracket(s.field, other.field)});
  n.checks.push_back({"the lowest-order field is the Hamiltonian field of the lowest term of H",
                      low.is_hamiltonian});
  for (std::size_t j = 0; j < s.field.dimension(); ++j) {
    const std::string& x = s.field.name(j);
    const bool same = j < other.field.dimension() && other.field.name(j) == x &&
                      same_function(low.components[j], other.field.components[j]);
    n.checks.push_back({"lowest order of " + x + "' = " + x + "' of " + n.node.other, same});
  }
  for (const WeightTerm& t : low.hamiltonian)
    n.formulas.push_back(
        {"the part of H of weight " + std::to_string(t.degree), to_string(t.value)});
  n.statement = assumptions_of(s) + "The lowest-order terms of the " + titled(s) + " are the " +
                titled(other);
  conclude(n, "the lowest-order terms are the " + titled(other));
}

} // namespace kov
