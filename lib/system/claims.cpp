#include "system/claims.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"

#include <algorithm>
#include <random>

namespace kov {
namespace {

MFraction reduced(const MFraction& f, const Ideal& level) {
  if (level.is_zero_ideal() || is_zero(f)) return f;
  return level.normal_form(MFraction(f.num())) / MFraction(f.den());
}

ClaimResult refuted(const std::string& what, const MFraction& f) {
  return {false, what + " = " + brief(f), f, {}, {}};
}

// X(G) = K G: G divides X(G) modulo the relations, that is, X(G) is in the ideal of G.
ClaimResult check_darboux(const VectorField& v, const SystemClaim& claim, const Budget& budget) {
  const MFraction derivative = lie_derivative(v, claim.value);
  const MPoly g = claim.value.num();
  const MFraction cofactor = derivative / claim.value;
  if (!is_zero(gcd(cofactor.den(), g)) && is_constant(gcd(cofactor.den(), g)))
    return {true, "X(G) = K G with K = " + brief(cofactor), cofactor, {}, {}};
  auto generators = set_generators(claim.on);
  generators.push_back(g); // with its multiplicities: 2 x is not a multiple of x^2
  const Ideal level = relation_ideal(v, generators, {}, budget);
  if (level.is_unit()) return refuted("G = 0 is empty; X(G)", derivative);
  if (is_in(derivative, level))
    return {true,
            "X(G) is in the ideal of G and the relations",
            MFraction(v.ring),
            level.inverted(),
            {}};
  return refuted(vanishes_on(derivative, level)
                     ? "X(G) vanishes on G = 0 and is not a multiple of G; modulo G: X(G)"
                     : "on G = 0: X(G)",
                 reduced(derivative, level));
}

// Factors in the parameters alone.
void add_parameter_factors(const VectorField& v, const MPoly& p, std::vector<MPoly>& all) {
  const auto main = v.main_variables();
  for (const MFactor& x : factor(p).second)
    if (!uses_any(x.base, main) && !is_among(x.base, all)) all.push_back(x.base);
}

// The zeros at which the claim divides by 0 and the field does not: there it says nothing.
std::vector<MPoly> meaningless(const VectorField& v, const SystemClaim& claim) {
  std::vector<MPoly> of_field, of_claim;
  for (const MFraction& x : v.components)
    add_parameter_factors(v, x.den(), of_field);
  for (const MFraction* f : {&claim.value, &claim.first, &claim.second})
    if (f->ring()) add_parameter_factors(v, f->den(), of_claim);
  for (const Equation& e : claim.on)
    add_parameter_factors(v, e.difference.den(), of_claim);
  std::erase_if(of_claim, [&](const MPoly& g) { return is_among(g, of_field); });
  return of_claim;
}

// The ideal of the level has to contain the derivatives of its generators: that they vanish on the
// level proves nothing where it has multiplicities.
std::optional<ClaimResult> not_invariant(const VectorField& v, const std::vector<Equation>& on,
                                         const Ideal& level) {
  for (const Equation& e : on) {
    if (is_zero(e.difference)) continue;
    const MFraction d = lie_derivative(v, MFraction(squarefree_part(e.difference.num())));
    if (is_in(d, level)) continue;
    return refuted(vanishes_on(d, level)
                       ? "the level " + e.text +
                             " has multiplicities, and is not proved invariant; " +
                             "modulo its equations the derivative"
                       : "the level " + e.text + " is not invariant; its derivative",
                   reduced(d, level));
  }
  return std::nullopt;
}

ClaimResult checked(const VectorField& v, const SystemClaim& claim, const Budget& budget) {
  if (claim.kind == SystemClaim::Kind::darboux) return check_darboux(v, claim, budget);
  const Ideal level = relation_ideal(v, set_generators(claim.on), {}, budget);
  if (level.is_unit())
    throw InvalidArgument("the level of the claim '" + claim.name + "' is empty");
  if (const auto den = pole_along(v, level); den && !claim.on.empty())
    throw InvalidArgument("the vector field is not defined on the level of the claim '" +
                          claim.name + "': the denominator " + to_string(*den) + " vanishes there");
  const auto decide = [&](const MFraction& f, const std::string& what) -> ClaimResult {
    if (is_zero(f)) return {true, what + " = 0 identically", f, {}, {}};
    if (vanishes_on(f, level))
      return {true,
              what + " = 0 modulo the relations and the level",
              MFraction(v.ring),
              level.inverted(),
              {}};
    return refuted(what, reduced(f, level));
  };
  switch (claim.kind) {
  case SystemClaim::Kind::integral:
    // On a level set that is not itself invariant the statement would be empty: check it first.
    if (const auto failure = not_invariant(v, claim.on, level)) return *failure;
    return decide(lie_derivative(v, claim.value), "d/dt " + claim.name);
  case SystemClaim::Kind::casimir: {
    if (!v.poisson) throw InvalidArgument("this system has no Poisson structure");
    const auto x = hamiltonian_field(v, *v.poisson, claim.value);
    for (std::size_t j = 0; j < x.size(); ++j)
      if (const auto r = decide(x[j], "{" + v.name(j) + ", " + claim.name + "}"); !r.proved)
        return r;
    return {true, "J grad " + claim.name + " = 0", MFraction(v.ring), level.inverted(), {}};
  }
  case SystemClaim::Kind::poisson:
    return decide(poisson_bracket(v, claim.first, claim.second) - claim.value,
                  "left side - right side");
  default:
    return decide(claim.value, "left side - right side");
  }
}

} // namespace

ClaimResult check_claim(const VectorField& v, const SystemClaim& claim, const Budget& budget) {
  ClaimResult result = checked(v, claim, budget);
  if (result.proved)
    for (MPoly& g : meaningless(v, claim))
      add_once(result.generic, std::move(g));
  return result;
}

System with_known_casimirs(System s) {
  const VectorField& v = s.field;
  if (!v.poisson || v.dimension() != 6 || s.kind == SystemKind::hamiltonian) return s;
  const auto x = [&](std::size_t k) { return MFraction::variable(v.ring, v.coordinates[k]); };
  MFraction square(v.ring), product(v.ring);
  for (std::size_t k = 0; k < 3; ++k) {
    square += x(3 + k) * x(3 + k);
    product += (s.gyrostat.empty() ? x(k) : x(k) - s.gyrostat[k]) * x(3 + k);
  }
  const auto is_named = [&](const MFraction& f) {
    return std::ranges::any_of(s.claims, [&](const SystemClaim& c) {
      return c.kind == SystemClaim::Kind::casimir && c.on.empty() && !is_zero(c.value) &&
             is_constant(c.value / f);
    });
  };
  for (const MFraction& f : {square, product}) {
    SystemClaim c;
    c.kind = SystemClaim::Kind::casimir;
    c.value = f;
    c.text = to_string(f);
    if (!is_named(f) && check_claim(v, c).proved) s.claims.push_back(std::move(c));
  }
  return s;
}

ClaimResult check_euler_lagrange(const System& s) {
  if (!s.lagrangian) throw InvalidArgument("the Euler-Lagrange form needs kind = \"lagrangian\"");
  const VectorField& v = s.field;
  Substitution velocities;
  for (std::size_t i = 0; i < 3; ++i)
    velocities[s.velocities[i]] = s.velocity_values[i];
  const auto x = [&](std::size_t k) { return MFraction::variable(v.ring, v.coordinates[k]); };
  const Ideal relations = relation_ideal(v);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::size_t k = i % 3;
    const std::size_t a = (k + 1) % 3;
    const std::size_t b = (k + 2) % 3;
    const auto force = [&](std::size_t j) {
      return substitute(derivative(*s.lagrangian, v.coordinates[3 + j]), velocities);
    };
    const auto& w = s.velocity_values;
    const MFraction expected = i < 3
                                   ? (x(a) - s.gyrostat[a]) * w[b] - (x(b) - s.gyrostat[b]) * w[a] +
                                         force(a) * x(3 + b) - force(b) * x(3 + a)
                                   : x(3 + a) * w[b] - x(3 + b) * w[a];
    if (const MFraction d = v.components[i] - expected; !is_zero_modulo(d, relations))
      return refuted("the component " + v.name(i) + "': Poisson form - Euler-Lagrange form", d);
  }
  return {true, "all six components agree", MFraction(v.ring), {}, {}};
}

ClaimResult check_same_field(const VectorField& v, const VectorField& other) {
  if (v.dimension() != other.dimension())
    return {false, "the other system has another number of coordinates", MFraction(v.ring), {}, {}};
  const Ideal relations = relation_ideal(v);
  for (std::size_t j = 0; j < v.dimension(); ++j) {
    const auto k = std::ranges::find_if(
        other.coordinates, [&](std::size_t i) { return other.ring->name(i) == v.name(j); });
    if (k == other.coordinates.end())
      return {false, "the other system has no coordinate " + v.name(j), MFraction(v.ring), {}, {}};
    const MFraction theirs =
        transfer(other.components[static_cast<std::size_t>(k - other.coordinates.begin())], v.ring);
    if (const MFraction d = v.components[j] - theirs; !is_zero_modulo(d, relations))
      return refuted("the difference of the two components " + v.name(j) + "'", d);
  }
  return {true, "all components agree", MFraction(v.ring), {}, {}};
}

ClaimResult check_claim(const System& s, const SystemClaim& claim, const Budget& budget) {
  if (claim.other.empty()) return check_claim(s.field, claim, budget);
  if (claim.other == "euler-lagrange") return check_euler_lagrange(s);
  const std::size_t slash = s.file.find_last_of('/');
  const std::string folder = slash == std::string::npos ? "" : s.file.substr(0, slash + 1);
  return check_same_field(s.field, read_system(folder + claim.other).field);
}

namespace {

// Values of the parameters at which all that is assumed holds, and strictly.  Equations are not
// solved: none is found where one is left.
std::optional<Substitution> admitted_point(const System& s, std::mt19937& generator) {
  std::uniform_int_distribution<int> number(-9, 30);
  Substitution point;
  for (const std::size_t i : s.field.parameters)
    point[i] = MFraction(s.ring(), Rational(number(generator)));
  for (const Assumption& a : s.assumptions) {
    MFraction value(s.ring());
    try {
      value = substitute(a.value, point);
    } catch (const DomainError&) {
      return std::nullopt;
    }
    if (!is_zero(value) && !is_constant(value)) return std::nullopt; // algebraic constants
    const Rational x = is_zero(value) ? Rational(0) : to_rational(value);
    if (!(a.is_ordered() ? sign(x) > 0 : a.holds_at(x))) return std::nullopt;
  }
  return point;
}

// A function that is not 0 for general parameters may be 0 at all that are assumed.
bool is_not_zero_as_assumed(const System& s, const MFraction& f) {
  if (s.assumptions.empty()) return true;
  std::mt19937 generator(7);
  for (int k = 0; k < 1000; ++k)
    if (const auto point = admitted_point(s, generator))
      if (tried<DomainError>([&] { return !is_zero(substitute(f, *point)); })) return true;
  return false;
}

} // namespace

ClaimResult decide_claim(const System& s, const SystemClaim& claim, const Budget& budget) {
  try {
    ClaimResult result = check_claim(s, claim, budget);
    if (!result.proved && claim.other.empty() && !is_not_zero_as_assumed(s, result.witness))
      result.open = result.detail =
          "false for general parameters; of those that are assumed nothing is said";
    return result;
  } catch (const OutOfBudget& limit) {
    ClaimResult result;
    result.witness = MFraction(s.ring());
    result.open = result.detail = limit.what();
    return result;
  }
}

std::vector<ClaimReport> decide_claims(const System& s, const Budget& budget) {
  std::vector<ClaimReport> all;
  for (const auto& claim : s.claims)
    all.push_back({claim, decide_claim(s, claim, budget)});
  return all;
}

bool is_met(const SystemClaim& claim, const ClaimResult& result) noexcept {
  return result.open.empty() && result.proved == claim.holds;
}

} // namespace kov
