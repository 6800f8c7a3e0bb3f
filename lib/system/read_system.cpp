// [system]: the vector field.  Claims, manifolds and expectations are
// in read_claims.cpp.

#include "system/read_system.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"
#include "symbol/author_words.hpp"
#include "symbol/suggest.hpp"
#include "system/relations.hpp"

#include <algorithm>
#include <span>

namespace kov {
namespace {

std::vector<std::size_t> indices(const Ring& ring, const std::vector<std::string>& names) {
  return mapped<std::size_t>(names, [&](const auto& name) { return ring->index(name); });
}

void read_functions(const Entry& system, SystemScope& scope, System& s) {
  VectorField& v = s.field;
  const Entry* functions = system.find("function");
  static const std::vector<const Entry*> none;
  const auto list = functions ? functions->list() : none;
  for (const Entry* f : list) {
    f->check_keys({"name", "means", "derivative"});
    FunctionSymbol symbol;
    symbol.variable = v.ring->index(f->at("name").string());
    symbol.gradient.assign(v.dimension(), MFraction(v.ring));
    if (const Entry* means = f->find("means")) {
      symbol.meaning = means->string();
      const Expression e = means->expression();
      if (e.kind() != Expression::Kind::call || e.operands().size() != 1)
        throw e.error("a function of one argument was expected", "for example means = \"sin(q1)\"");
      FunctionMeaning meaning{symbol.variable, e.name(), evaluate(e.operand(0), scope)};
      for (const FunctionMeaning& other : scope.meanings)
        if (other.name == meaning.name && other.argument == meaning.argument)
          throw means->error("'" + v.ring->name(symbol.variable) + "' and '" +
                             v.ring->name(other.variable) + "' are the same function");
      scope.meanings.push_back(std::move(meaning));
    }
    v.functions.push_back(std::move(symbol));
  }
  FunctionsInFormulas::Declared declared{
      v.coordinates, indices(v.ring, scope.velocities), v.constants, {}};
  for (const FunctionSymbol& f : v.functions)
    declared.functions.push_back(f.variable);
  const WrittenFunctions written = scope.written.declare(scope, declared);
  for (const MPoly& p : written.nonzero)
    assume_nonzero(p, 0, s);
  for (const WrittenFunction& f : written.symbols)
    scope.unused.erase(v.ring->name(f.variable));
  for (const std::size_t i : written.constants)
    scope.unused.erase(v.ring->name(i));
  std::size_t k = 0; // derivatives may use all symbols, so that they come second
  for (const Entry* f : list) {
    for (const auto& [name, entry] : f->at("derivative").members()) {
      const auto place = std::ranges::find(scope.coordinates, name);
      if (place == scope.coordinates.end())
        throw entry.error("'" + name + "' is not a coordinate",
                          "coordinates: " + enumerate(scope.coordinates));
      v.functions[k].gradient[static_cast<std::size_t>(place - scope.coordinates.begin())] =
          evaluate(entry.expression(), scope);
    }
    ++k;
  }
  v.constants.insert(v.constants.end(), written.constants.begin(), written.constants.end());
  v.relations = written.relations;
  for (const WrittenFunction& f : written.symbols) {
    FunctionSymbol symbol{f.variable, f.meaning, {}};
    for (std::size_t j = 0; j < v.dimension(); ++j)
      symbol.gradient.push_back(f.slope * partial(v, f.argument, j));
    v.functions.push_back(std::move(symbol));
  }
}

// df/du of what a symbol s = f(u) is said to mean: a rational function of s and u; or its square.
struct SymbolSlope {
  MFraction value;
  bool squared = false;
};
std::optional<SymbolSlope> slope_of(const FunctionMeaning& m) {
  const MFraction s = MFraction::variable(m.argument.ring(), m.variable);
  const MFraction one(m.argument.ring(), Rational(1));
  if (m.name == "exp") return SymbolSlope{s};
  if (m.name == "log" || m.name == "ln") return SymbolSlope{one / m.argument};
  if (m.name == "tan") return SymbolSlope{one + s * s};
  if (m.name == "tanh") return SymbolSlope{one - s * s};
  if (m.name == "sin" || m.name == "cos") return SymbolSlope{one - s * s, true};
  if (m.name == "sinh") return SymbolSlope{one + s * s, true};
  if (m.name == "cosh") return SymbolSlope{s * s - one, true};
  if (const long n = order_of_root(m.name)) return SymbolSlope{s / (Rational(n) * m.argument)};
  return std::nullopt;
}

// Refuses a declared derivative that contradicts `means`.
void require_derivatives(const Entry& system, const SystemScope& scope, const VectorField& v) {
  const Ideal relations = relation_ideal(v);
  for (const FunctionMeaning& m : scope.meanings) {
    if (m.value) continue;
    const auto f = std::ranges::find_if(
        v.functions, [&](const FunctionSymbol& s) { return s.variable == m.variable; });
    const auto slope = slope_of(m);
    if (f == v.functions.end() || !slope || is_zero(m.argument)) continue;
    for (std::size_t j = 0; j < v.dimension(); ++j) {
      const MFraction inner = partial(v, m.argument, j), given = f->gradient[j];
      const MFraction difference = slope->squared ? given * given - slope->value * inner * inner
                                                  : given - slope->value * inner;
      if (!is_zero_modulo(difference, relations))
        throw system.error("the derivative of '" + v.ring->name(m.variable) + "' by " + v.name(j) +
                           ", " + to_string(given) + ", is not that of " + f->meaning);
    }
  }
}

void read_relations(const Entry& system, const SystemScope& scope, VectorField& v) {
  const Entry* relations = system.find("relations");
  if (relations)
    for (const Entry* r : relations->list()) {
      const MFraction f = scope.equation(*r).difference;
      if (is_zero(f)) continue; // at the values that are set
      if (is_constant(f)) throw r->error("this relation does not hold at the values that are set");
      const auto main = v.main_variables();
      if (!uses_any(f.num(), main))
        throw r->error("a relation between parameters is an assumption",
                       "write it below [assume]: conditions = [...]");
      v.relations.push_back(f.num());
    }
  const Entry& place = relations ? *relations : system;
  for (const MPoly& f : implied_relations(scope.meanings, v.ring))
    if (!is_zero_modulo(MFraction(f), relation_ideal(v))) v.relations.push_back(f);
  const Ideal ideal = relation_ideal(v);
  if (ideal.is_unit()) throw place.error("the relations contradict each other");
  for (const auto& f : v.relations)
    for (std::size_t j = 0; j < v.dimension(); ++j)
      if (const MFraction d = partial(v, MFraction(f), j); !is_zero_modulo(d, ideal))
        throw place.error("the relation " + to_string(f) + " = 0 does not agree with the " +
                          "derivatives of its functions: its derivative by " + v.name(j) + " is " +
                          to_string(d));
  if (const auto why = reducible_relations(v))
    throw place.error(*why, "write the relation of the one that is meant; a constant can also "
                            "be given a value, like a parameter");
  const Entry* functions = system.find("function") ? system.find("function") : &system;
  for (const auto& f : v.functions) // a gradient is closed
    for (std::size_t i = 0; i < v.dimension(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!is_zero_modulo(partial(v, f.gradient[i], j) - partial(v, f.gradient[j], i), ideal))
          throw functions->error("there is no function '" + v.ring->name(f.variable) +
                                 "' with these derivatives: those by " + v.name(i) + " and " +
                                 v.name(j) + " do not commute");
  for (const std::size_t i : v.constants) {
    const std::string& name = v.ring->name(i);
    if (!any_uses(v.relations, i))
      throw system.at("constants")
          .error("the relation of the constant '" + name + "' is missing",
                 "for example relations = [\"" + name + "^2 = 2\"]");
  }
}

SystemKind read_kind(const Entry& system) {
  const Entry& kind = system.at("kind");
  const std::vector<std::pair<std::string, SystemKind>> kinds{
      {"hamiltonian", SystemKind::hamiltonian},
      {"vector-field", SystemKind::vector_field},
      {"euler-poisson", SystemKind::euler_poisson},
      {"lagrangian", SystemKind::lagrangian},
      {"poisson", SystemKind::poisson},
      {"newton", SystemKind::newton}};
  std::vector<std::string> names;
  for (const auto& [name, value] : kinds) {
    if (name == kind.string()) return value;
    names.push_back(name);
  }
  const auto guess = nearest(kind.string(), names);
  throw kind.error("unknown kind of system '" + kind.string() + "'",
                   guess ? "did you mean '" + *guess + "'?" : "kinds: " + enumerate(names));
}

std::vector<MFraction> read_gyrostat(const Entry& system, const SystemScope& scope) {
  std::vector<MFraction> b(3, MFraction(scope.ring()));
  if (const Entry* g = system.find("gyrostat")) {
    if (g->array().size() != 3) throw g->error("the gyrostatic moment has three components");
    for (std::size_t i = 0; i < 3; ++i)
      b[i] = evaluate(g->array()[i].expression(), scope);
  }
  return b;
}

Matrix read_bracket(const Entry& system, const SystemScope& scope, std::size_t n) {
  const Entry& bracket = system.at("bracket");
  Matrix j;
  for (const Entry& row : bracket.array()) {
    j.emplace_back();
    for (const Entry& entry : row.array())
      j.back().push_back(evaluate(entry.expression(), scope));
    if (j.back().size() != n)
      throw row.error("a row of the bracket needs one entry per coordinate");
  }
  if (j.size() != n) throw bracket.error("the bracket needs one row per coordinate");
  return j;
}

// A line for each of the first n coordinates.
std::vector<MFraction> read_lines(const Entry& lines, const SystemScope& scope, std::size_t n) {
  if (!lines.is_table())
    throw lines.error("'" + lines.name() + "' must be a table",
                      "write [system." + lines.name() + "] and then x = \"...\" lines");
  const std::span names = std::span(scope.coordinates).first(n);
  std::vector<std::optional<MFraction>> values(n);
  for (const auto& [name, entry] : lines.members()) {
    const auto place = std::ranges::find(names, name);
    if (place == names.end())
      throw entry.error("'" + name + "' is not a coordinate", "coordinates: " + enumerate(names));
    values[static_cast<std::size_t>(place - names.begin())] = evaluate(entry.expression(), scope);
  }
  for (std::size_t j = 0; j < n; ++j)
    if (!values[j])
      throw lines.error("the " +
                        std::string(lines.name() == "field" ? "derivative" : "acceleration") +
                        " of '" + names[j] + "' is missing");
  return mapped<MFraction>(values, [](const auto& value) { return *value; });
}

// x'' = F(x, v): a field of positions and velocities.
void read_newton(const Entry& system, const SystemScope& scope, System& s) {
  VectorField& v = s.field;
  const std::size_t n = names_of(system, "coordinates").size();
  if (v.dimension() != 2 * n)
    throw system.at("velocities").error("as many velocities as coordinates are needed");
  for (std::size_t j = 0; j < n; ++j)
    v.components.push_back(MFraction::variable(v.ring, v.coordinates[n + j]));
  for (MFraction& f : read_lines(system.at("acceleration"), scope, n))
    v.components.push_back(std::move(f));
  s.kind = SystemKind::vector_field;
}

void require_e3(const Entry& system, const SystemScope& scope) {
  if (scope.coordinates.size() != 6)
    throw system.at("coordinates")
        .error("six coordinates are needed", "M1, M2, M3, Gamma1, Gamma2, Gamma3, in this order; a "
                                             "Lagrangian of other coordinates needs velocities");
}

// The velocities occur in L alone, the momenta do not, and L has a value: what it is divided by may
// be a factor of its Hamiltonian.
void require_lagrangian(const Entry& lagrangian, const SystemScope& scope,
                        const std::vector<std::size_t>& momenta, System& s) {
  const VectorField& v = s.field;
  for (const std::string& name : scope.velocities) {
    const std::size_t i = v.ring->index(name);
    const auto has = [i](const auto& f) { return uses(f, i); };
    const bool elsewhere = std::ranges::any_of(v.relations, has) ||
                           std::ranges::any_of(v.functions, [&](const FunctionSymbol& f) {
                             return std::ranges::any_of(f.gradient, has);
                           });
    if (elsewhere)
      throw lagrangian.error("the velocity '" + name + "' is in a relation, or in a derivative",
                             "the Lagrangian has to be quadratic in the velocities");
  }
  const bool rigid = scope.velocities.size() == 3 && scope.coordinates.size() == 6 &&
                     momenta.size() == 3 && v.coordinates.front() == momenta.front();
  for (const std::size_t i : momenta)
    if (uses(scope.lagrangian, i))
      throw lagrangian.error("the " + std::string(rigid ? "angular momentum" : "momentum") + " '" +
                             v.ring->name(i) + "' is in the Lagrangian");
  for (const MFactor& f : factor(scope.lagrangian.den()).second) {
    const auto used = used_variables(f.base);
    if (std::ranges::all_of(used, [&](std::size_t i) { return is_among(i, v.parameters); }))
      assume_nonzero(f.base, lagrangian.line(), s);
  }
}

// M = dL/dOmega or p = dL/dq' solved for the velocities, and the Hamiltonian.
Legendre read_lagrangian(const Entry& system, SystemScope& scope,
                         const std::vector<std::size_t>& momenta, System& s) {
  const Entry& lagrangian = system.at("lagrangian");
  scope.lagrangian = evaluate(lagrangian.expression(), scope);
  require_lagrangian(lagrangian, scope, momenta, s);
  try {
    const auto w = indices(scope.ring(), scope.velocities);
    Legendre l = legendre(scope.lagrangian, w, momenta);
    Substitution velocities;
    for (std::size_t i = 0; i < w.size(); ++i)
      velocities[w[i]] = l.velocities[i];
    for (auto& [name, value] : scope.named) // definitions that the Lagrangian has used already
      value = substitute(value, velocities);
    for (std::size_t i = 0; i < w.size(); ++i)
      scope.named[scope.velocities[i]] = l.velocities[i];
    return l;
  } catch (const DomainError& e) {
    throw lagrangian.error(e.what());
  }
}

// A Lagrangian L(q, q'): from here on a Hamiltonian system.
void read_mechanical(const Entry& system, SystemScope& scope, System& s) {
  VectorField& v = s.field;
  const std::size_t n = v.dimension() / 2;
  if (scope.velocities.size() != n)
    throw system.at("velocities").error("as many velocities as coordinates are needed");
  v.poisson = canonical_structure(v.ring, n);
  v.hamiltonian =
      read_lagrangian(system, scope,
                      {v.coordinates.begin() + static_cast<long>(n), v.coordinates.end()}, s)
          .hamiltonian;
  s.kind = SystemKind::hamiltonian;
}

void read_rigid_body(const Entry& system, SystemScope& scope, System& s) {
  VectorField& v = s.field;
  if (scope.velocities.size() != 3)
    throw system.at("angular_velocity").error("three angular velocities are needed");
  const Legendre l =
      read_lagrangian(system, scope, {v.coordinates[0], v.coordinates[1], v.coordinates[2]}, s);
  v.hamiltonian = l.hamiltonian;
  s.lagrangian = scope.lagrangian;
  s.velocities = indices(v.ring, scope.velocities);
  s.velocity_values = l.velocities;
}

// Refuses keys that a kind of system does not read: they would be passed over in silence.
void require_keys_of(SystemKind kind, const Entry& system) {
  using enum SystemKind;
  const std::vector<std::pair<std::string, std::vector<SystemKind>>> readers{
      {"momenta", {hamiltonian, SystemKind::lagrangian}},
      {"hamiltonian", {hamiltonian, euler_poisson, poisson}},
      {"lagrangian", {SystemKind::lagrangian}},
      {"velocities", {SystemKind::lagrangian, newton}},
      {"acceleration", {newton}},
      {"angular_velocity", {SystemKind::lagrangian}},
      {"gyrostat", {euler_poisson, SystemKind::lagrangian}},
      {"bracket", {poisson}},
      {"field", {vector_field}}};
  for (const auto& [key, kinds] : readers)
    if (const Entry* entry = system.find(key); entry && !is_among(kind, kinds))
      throw entry->key_error("'" + key + "' is not for a system of kind " +
                             system.at("kind").string());
  if (!system.find("velocities")) return;
  for (const std::string key : {"angular_velocity", "gyrostat"})
    if (const Entry* entry = system.find(key))
      throw entry->key_error("'" + key +
                             "' is for a rigid body, which has no velocities beside it");
}

// The Hamiltonian and the structure matrix, or the field itself.
void read_dynamics(const Entry& system, SystemScope& scope, System& s) {
  VectorField& v = s.field;
  const std::size_t n = v.dimension();
  require_keys_of(s.kind, system);
  const bool mechanical = system.find("velocities") != nullptr;
  switch (s.kind) {
  case SystemKind::vector_field:
    v.components = read_lines(system.at("field"), scope, n);
    return;
  case SystemKind::newton:
    return read_newton(system, scope, s);
  case SystemKind::hamiltonian:
    if (names_of(system, "momenta").size() * 2 != n)
      throw system.at("momenta").error("as many momenta as coordinates are needed");
    v.poisson = canonical_structure(v.ring, n / 2);
    break;
  case SystemKind::poisson:
    v.poisson = read_bracket(system, scope, n);
    break;
  case SystemKind::euler_poisson:
  case SystemKind::lagrangian:
    if (mechanical) break;
    require_e3(system, scope);
    s.gyrostat = read_gyrostat(system, scope);
    v.poisson = e3_structure(v.ring, v.coordinates, s.gyrostat);
  }
  if (mechanical)
    read_mechanical(system, scope, s);
  else if (s.kind == SystemKind::lagrangian)
    read_rigid_body(system, scope, s);
  else
    v.hamiltonian = evaluate(system.at("hamiltonian").expression(), scope);
  v.components = hamiltonian_field(v, *v.poisson, *v.hamiltonian);
}

// Refuses denominators that are 0 by the relations: 1 - s^2 - c^2 where s^2 + c^2 = 1.
void require_denominators(const Entry& system, const VectorField& v) {
  const Ideal relations = relation_ideal(v);
  for (const MPoly& d : denominators(v))
    if (is_zero_modulo(MFraction(d), relations))
      throw system.error("division by zero: " + to_string(d) + " is 0 by the relations");
}

// The domain by the divisors of what is written, and by those of the field.
ParameterDomain domain_of(const SystemScope& scope, const VectorField& v) {
  ParameterDomain all;
  for (const auto& divisors : {scope.take_divisors(), denominators(v)})
    for (const MPoly& d : divisors)
      all.require(d, v, scope.meanings);
  for (const FunctionMeaning& m : scope.meanings)
    if ((m.name == "log" || m.name == "ln") && !is_zero(m.argument))
      all.require(m.argument.num(), v, scope.meanings);
  return all;
}

// Constants that stand for a written root.
std::map<std::string, std::string> roots_of_constants(const SystemScope& scope,
                                                      const VectorField& v) {
  std::map<std::string, std::string> all;
  for (const FunctionMeaning& m : scope.meanings)
    if (!m.value && is_among(m.variable, v.constants))
      all[v.ring->name(m.variable)] = m.name + "(" + to_string(m.argument) + ")";
  return all;
}

// A function of a number, at special values of the parameters, is known by its name.
void note_functions(const SystemScope& scope, VectorField& v) {
  for (FunctionSymbol& f : v.functions)
    for (const FunctionMeaning& m : scope.meanings)
      if (!m.value && m.variable == f.variable) {
        f.function = m.name;
        f.argument = m.argument;
      }
}

} // namespace

void read_vector_field(const Entry& document, SystemScope& scope, System& s) {
  const Entry& system = document.at("system");
  s.kind = read_kind(system);
  VectorField& v = s.field;
  v.ring = scope.ring();
  v.coordinates = indices(v.ring, scope.coordinates);
  for (const auto& name : scope.constants)
    if (!scope.values.count(name)) v.constants.push_back(v.ring->index(name));
  for (const auto& name : scope.parameters)
    if (!scope.values.count(name)) v.parameters.push_back(v.ring->index(name));
  s.z = v.ring->index(scope.independent);
  if (v.coordinates.empty()) throw system.error("a system needs coordinates");
  read_functions(system, scope, s);
  read_relations(system, scope, v);
  require_derivatives(system, scope, v);
  read_dynamics(system, scope, s);
  require_denominators(system, v);
  note_functions(scope, v);
  s.roots = roots_of_constants(scope, v);
  s.domain = domain_of(scope, v);
  if (v.poisson && s.kind == SystemKind::poisson)
    if (const auto failure = structure_failure(v, *v.poisson, relation_ideal(v)))
      throw system.at("bracket").error("this bracket is not a Poisson bracket: " + *failure);
  if (v.hamiltonian && !scope.named.count("H") && !v.ring->find("H"))
    scope.named["H"] = *v.hamiltonian;
}

System read_system(const Entry& document, SystemScope& scope) {
  document.check_keys({"format", "title", "cite", "system", "set", "assume", "expansion",
                       "manifold", "integral", "casimir", "darboux", "poisson", "equal", "reduce",
                       "expect", "scene"}); // [scene] is for lib/flow
  if (const Entry* format = document.find("format"); format && format->string() != "equation/1")
    throw format->error("unknown format '" + format->string() + "'",
                        "this program reads equation/1");
  System s;
  s.file = document.file();
  if (const Entry* title = document.find("title")) s.title = one_line(title->string());
  if (const Entry* cite = document.find("cite"))
    for (const std::string& key : cite->strings())
      s.cite.push_back(one_line(key));
  read_vector_field(document, scope, s);
  read_claims(document, scope, s);
  read_manifolds(document, scope, s);
  read_expectations(document, scope, s);
  s.named = scope.named;
  s.values = scope.values;
  return s;
}

System read_system(const Entry& document, const ParameterValues& settings) {
  SystemScope scope(document, settings);
  return read_system(document, scope);
}

System read_system(const std::string& path, const ParameterValues& settings) {
  return read_system(read_document(path), settings);
}

bool is_system_document(const Entry& document) {
  const Entry* system = document.find("system"); // in a theorem file: the name of one
  return system != nullptr && system->is_table();
}

} // namespace kov
