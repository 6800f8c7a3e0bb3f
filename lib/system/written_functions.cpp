#include "system/written_functions.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
#include "exact/linear.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "exact/variables.hpp"
#include "system/vector_field.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace kov {
namespace {

using Family = FunctionsInFormulas::Family;
using Use = FunctionsInFormulas::Use;

constexpr std::size_t nothing = static_cast<std::size_t>(-1); // a function that has no own symbol
constexpr long longest_angle = 30;                            // sum of the multiples of the basis
constexpr long longest_exponent = 1000;
constexpr long highest_root = 24;

std::optional<Family> family_of(const std::string& function) {
  static const std::map<std::string, Family> known{
      {"sin", Family::angle},     {"cos", Family::angle},     {"tan", Family::angle},
      {"exp", Family::exponent},  {"sinh", Family::exponent}, {"cosh", Family::exponent},
      {"tanh", Family::exponent}, {"sqrt", Family::root},     {"log", Family::logarithm},
      {"ln", Family::logarithm}};
  const auto place = known.find(function);
  return place == known.end() ? std::nullopt : std::optional(place->second);
}

std::vector<std::string> prefixes(Family family) {
  switch (family) {
  case Family::angle:
    return {"sin", "cos"};
  case Family::exponent:
    return {"exp"};
  case Family::root:
    return {"root"};
  default:
    return {"log"};
  }
}

} // namespace

std::optional<Rational> written_number(const Expression& e) {
  using Kind = Expression::Kind;
  if (e.kind() == Kind::number) return Rational(e.number());
  if (e.kind() == Kind::negate) {
    const auto x = written_number(e.operand(0));
    return x ? std::optional(-*x) : std::nullopt;
  }
  if (e.kind() != Kind::quotient) return std::nullopt;
  const auto x = written_number(e.operand(0));
  const auto y = written_number(e.operand(1));
  return x && y && !is_zero(*y) ? std::optional(*x / *y) : std::nullopt;
}

long order_of_root(const std::string& function) {
  if (function == "sqrt") return 2;
  const bool is_numbered = function.starts_with("root") && function.size() > 4 &&
                           function.size() < 8 &&
                           std::all_of(function.begin() + 4, function.end(),
                                       [](char c) { return c >= '0' && c <= '9'; });
  if (is_numbered) return std::stol(function.substr(4));
  return 0;
}

FunctionsInFormulas::FunctionsInFormulas(const Entry& system, const Entry* more) {
  for (const char* key :
       {"hamiltonian", "lagrangian", "gyrostat", "bracket", "field", "define", "relations"})
    if (const Entry* e = system.find(key)) collect(*e);
  if (const Entry* functions = system.find("function"))
    for (const Entry* f : functions->list())
      if (const Entry* derivative = f->find("derivative")) collect(*derivative);
  for (const char* key : {"section", "where", "start", "plot"})
    if (const Entry* e = more == nullptr ? nullptr : more->find(key)) collect(*e);
  if (const Entry* levels = more == nullptr ? nullptr : more->find("levels"))
    collect_names(*levels);
  add_names_in_angles();
}

namespace {

void add_names(const Expression& e, std::vector<Expression>& all) {
  if (e.kind() == Expression::Kind::name) all.push_back(e);
  for (const Expression& x : e.operands())
    add_names(x, all);
}

} // namespace

// x and y of cos(x + y): they may be a better basis than the sums.
void FunctionsInFormulas::add_names_in_angles() {
  std::vector<Expression> all;
  for (const Use& u : uses_)
    if (u.family == Family::angle) add_names(u.argument, all);
  const std::size_t written = uses_.size();
  for (const Expression& name : all)
    note(Family::angle, name);
  for (std::size_t i = written; i < uses_.size(); ++i)
    uses_[i].is_written = false;
}

void FunctionsInFormulas::collect(const Entry& entry) {
  if (entry.is_table())
    for (const auto& [name, one] : entry.members())
      collect(one);
  if (entry.is_array())
    for (const Entry& one : entry.array())
      collect(one);
  if (entry.kind() != Entry::Kind::string) return;
  if (entry.string().find('(') == std::string::npos) return;
  // an error is reported when the formula is evaluated
  tried<InputError>([&] { collect(entry.expression(true)); });
}

void FunctionsInFormulas::collect_names(const Entry& table) {
  for (const auto& [name, one] : table.members())
    tried<InputError>([&] { collect(parse_expression(name, "levels")); });
}

void FunctionsInFormulas::collect(const Expression& e) {
  using Kind = Expression::Kind;
  for (const Expression& x : e.operands())
    collect(x);
  if (e.kind() == Kind::call && e.operands().size() == 1) {
    if (const auto family = family_of(e.name()))
      note(*family, e.operand(0), *family == Family::root ? 2 : 1);
  } else if (e.kind() == Kind::power) {
    const auto exponent = written_number(e.operand(1));
    if (exponent && !is_integer(*exponent) && exponent->den() <= Integer(highest_root))
      note(Family::root, e.operand(0), to_long(exponent->den()));
  }
}

void FunctionsInFormulas::note(Family family, const Expression& argument, long root) {
  for (Use& u : uses_)
    if (u.family == family && u.argument.text() == argument.text()) {
      u.root = std::lcm(u.root, root);
      return;
    }
  uses_.push_back({family, argument, root});
}

std::vector<std::string> FunctionsInFormulas::names(std::set<std::string> taken) {
  std::vector<std::string> all;
  std::map<Family, int> count;
  for (Use& u : uses_) {
    const bool plain = u.argument.kind() == Expression::Kind::name;
    const std::string end = plain ? "_" + u.argument.name() : std::to_string(++count[u.family]);
    for (std::string name : prefixes(u.family)) {
      name += end;
      while (!taken.insert(name).second)
        name += '_';
      u.symbols.push_back(name);
      all.push_back(name);
    }
  }
  return all;
}

namespace {

// ---- Q-linear combinations

using Terms = std::map<std::vector<unsigned long>, Rational>;

Terms terms_of(const MPoly& f) {
  Terms all;
  for (long i = 0; i < f.length(); ++i)
    all.emplace(f.exponents(i), Rational(f.coefficient(i)));
  return all;
}

/// A basis of the Q-linear combinations of some functions, all of which are integral ones of it.
struct RationalBasis {
  std::vector<std::size_t> of;                    ///< which of the functions, each divided by
  std::vector<Integer> divisors;                  ///< one of these
  std::vector<std::vector<Rational>> coordinates; ///< of each function, integers
};

// The functions that are no combination of those before.
RationalBasis basis_of(const std::vector<Terms>& all) {
  std::map<std::vector<unsigned long>, std::vector<Rational>> by_monomial;
  for (std::size_t j = 0; j < all.size(); ++j)
    for (const auto& [m, c] : all[j])
      by_monomial.try_emplace(m, all.size()).first->second[j] = c;
  std::vector<std::vector<Rational>> rows;
  for (auto& [m, row] : by_monomial)
    rows.push_back(std::move(row));
  RationalBasis b{row_reduce(rows, std::views::iota(std::size_t{0}, all.size())), {}, {}};
  b.divisors.assign(b.of.size(), Integer(1));
  for (std::size_t i = 0; i < b.of.size(); ++i)
    for (const Rational& x : rows[i])
      b.divisors[i] = lcm(b.divisors[i], x.den());
  for (std::size_t j = 0; j < all.size(); ++j) {
    b.coordinates.emplace_back();
    for (std::size_t i = 0; i < b.of.size(); ++i)
      b.coordinates[j].push_back(rows[i][j] * Rational(b.divisors[i]));
  }
  return b;
}

// ---- the symbols

using Known = std::vector<std::pair<Use, MFraction>>;

/// The symbols that are declared, and all functions that have a meaning.
class FunctionSymbols {
public:
  FunctionSymbols(FunctionsInFormulas::GrowingScope& scope,
                  const FunctionsInFormulas::Declared& file)
      : scope_(scope), moving_(file.coordinates) {
    moving_.insert(moving_.end(), file.constants.begin(), file.constants.end());
    moving_.insert(moving_.end(), file.functions.begin(), file.functions.end());
  }

  [[nodiscard]] const Ring& ring() const { return scope_.ring(); }
  [[nodiscard]] std::size_t index(const std::string& name) const { return ring()->index(name); }
  [[nodiscard]] MFraction symbol(const std::string& name) const {
    return MFraction::variable(ring(), name);
  }
  [[nodiscard]] MFraction number(const Rational& c) const { return {ring(), c}; }
  [[nodiscard]] const std::vector<std::size_t>& moving() const { return moving_; }
  [[nodiscard]] bool moves(const MPoly& f) const { return uses_any(f, moving_); }
  [[nodiscard]] bool moves(const MFraction& f) const {
    return !is_zero(f) && (moves(f.num()) || moves(f.den()));
  }

  void mean(const std::string& function, const MFraction& argument, const MFraction& value,
            std::size_t variable = nothing) {
    FunctionMeaning m{variable, function, argument, {}};
    if (variable == nothing) m.value = value;
    all.meanings.push_back(m);
    scope_.add(m);
  }
  void mean_at_zero(const MFraction& zero) {
    for (const char* function : {"sin", "tan", "sinh", "tanh"})
      mean(function, zero, number(0));
    for (const char* function : {"cos", "exp", "cosh"})
      mean(function, zero, number(1));
  }
  void declare(const std::string& function, const MFraction& argument, const MFraction& name,
               const MFraction& slope) {
    const std::size_t i = used_variables(name).front();
    all.symbols.push_back({i, function + "(" + to_string(argument) + ")", argument, slope});
    moving_.push_back(i);
  }
  /// The same of a function that is no root.
  void declare_meant(const std::string& function, const MFraction& argument, const MFraction& name,
                     const MFraction& slope) {
    declare(function, argument, name, slope);
    mean(function, argument, name, used_variables(name).front());
  }

  WrittenFunctions all;

private:
  FunctionsInFormulas::GrowingScope& scope_;
  std::vector<std::size_t> moving_;
};

std::optional<Rational> exact_root(const Rational& q, long order) {
  if (sign(q) <= 0) return std::nullopt;
  Integer num, den;
  const auto n = static_cast<unsigned long>(order);
  if (fmpz_root(num.raw(), q.num().raw(), static_cast<slong>(n)) == 0) return std::nullopt;
  if (fmpz_root(den.raw(), q.den().raw(), static_cast<slong>(n)) == 0) return std::nullopt;
  return Rational(num, den);
}

/// The roots that have symbols.
class WrittenRoots {
public:
  explicit WrittenRoots(FunctionSymbols& symbols) : symbols_(symbols) {}

  void add(const Known& all) {
    for (const auto& [u, argument] : all) {
      if (u.root > highest_root) continue;
      if (auto known = known_root(argument, u.root)) {
        mean(argument, *known, u.root, nothing);
        continue;
      }
      const MFraction r = symbols_.symbol(u.symbols[0]);
      const std::size_t i = symbols_.index(u.symbols[0]);
      const auto power = pow(r, u.root);
      symbols_.all.relations.push_back((power * MFraction(argument.den()) - argument.num()).num());
      if (symbols_.moves(argument))
        symbols_.declare(u.root == 2 ? "sqrt" : "root" + std::to_string(u.root), argument, r,
                         r / (Rational(u.root) * argument));
      else
        symbols_.all.constants.push_back(i);
      mean(argument, r, u.root, i);
      roots_.push_back({argument, r, u.root});
      variables_.push_back(i);
    }
  }
  [[nodiscard]] const std::vector<std::size_t>& variables() const { return variables_; }
  /// In the numerator, with exponents below their orders: such products are linearly independent over the rational
  /// functions.
  [[nodiscard]] bool are_reduced(const MFraction& f) const {
    return std::ranges::all_of(roots_, [&](const RootOf& r) {
      const std::size_t i = used_variables(r.value).front();
      return !uses(f.den(), i) && degree(f.num(), i) < r.order;
    });
  }

private:
  struct RootOf {
    MFraction of, value;
    long order;
  };
  void mean(const MFraction& of, const MFraction& root, long order, std::size_t variable) {
    if (order == 2) return symbols_.mean("sqrt", of, root, variable);
    symbols_.mean("root" + std::to_string(order), of, root, variable);
    if (order % 2 == 0) symbols_.mean("sqrt", of, pow(root, order / 2));
  }
  // The root of c^n f or of c^n/f, where the root of f has a symbol, or of a power of a number.
  [[nodiscard]] std::optional<MFraction> known_root(const MFraction& of, long order) const {
    if (is_zero(of)) return symbols_.number(0);
    if (is_constant(of)) {
      const auto c = exact_root(to_rational(of), order);
      if (c) return symbols_.number(*c);
    }
    for (const RootOf& r : roots_) {
      if (r.order % order != 0) continue;
      const MFraction root = pow(r.value, r.order / order);
      for (const bool inverse : {false, true}) {
        const MFraction ratio = inverse ? of * r.of : of / r.of;
        if (!is_constant(ratio)) continue;
        if (const auto c = exact_root(to_rational(ratio), order))
          return symbols_.number(*c) * (inverse ? symbols_.number(1) / root : root);
      }
    }
    return std::nullopt;
  }

  FunctionSymbols& symbols_;
  std::vector<RootOf> roots_;
  std::vector<std::size_t> variables_;
};

// ---- independence over the complex numbers

// d f/dx, through the symbols.
MFraction slope(const MFraction& f, std::size_t x, const std::vector<WrittenFunction>& symbols) {
  MFraction sum = derivative(f, x);
  for (const WrittenFunction& r : symbols)
    if (uses(f, r.variable))
      sum += derivative(f, r.variable) * r.slope * slope(r.argument, x, symbols);
  return sum;
}

/// The arguments of sines, exponentials, logarithms, which take all values near a point, whatever the parameters.
class IndependentArguments {
public:
  IndependentArguments(std::vector<std::size_t> coordinates,
                       const std::vector<FunctionMeaning>& declared, const WrittenRoots& roots,
                       FunctionSymbols& symbols)
      : coordinates_(std::move(coordinates)), roots_(roots), symbols_(symbols) {
    for (const FunctionMeaning& f : declared)
      if (const auto family = family_of(f.name); family && *family != Family::root)
        add_once(of_file_, f.argument);
  }

  void add(const std::vector<MFraction>& more, const Use& u) {
    if (!are_independent(more))
      throw u.argument.error(
          "the arguments of the functions that are written depend on one another, "
          "so that the functions do not take all values at once",
          "declare symbols for them: [[system.function]] with means and derivative");
    written_.insert(written_.end(), more.begin(), more.end());
  }

private:
  // A minor of their gradients has a coefficient that is a number, or is noted.  False: they depend on one another.
  bool are_independent(const std::vector<MFraction>& more) const {
    Matrix rows;
    const auto add_gradient = [&](const MFraction& f) {
      auto& row = rows.emplace_back();
      for (const std::size_t x : coordinates_)
        row.push_back(slope(f, x, symbols_.all.symbols));
    };
    for (const MFraction& f : of_file_) { // these may depend on one another
      add_gradient(f);
      if (coordinates_.size() - null_space(rows, coordinates_.size(), f.ring()).size() <
          rows.size())
        rows.pop_back();
    }
    for (const auto* functions : {&written_, &more})
      std::ranges::for_each(*functions, add_gradient);
    if (rows.size() > coordinates_.size()) return false;
    std::optional<MPoly> best;
    const bool never_zero =
        some_minor(rows, coordinates_.size(), symbols_.ring(), [&](const MFraction& d) {
          for (const MPoly& c : coefficients_of(d)) {
            if (is_constant(c)) return true;
            if (!best || c.length() < best->length()) best = c;
          }
          return false;
        });
    if (!never_zero && best) symbols_.all.nonzero.push_back(*best);
    return never_zero || best;
  }
  // As a polynomial in what moves, without what the relations of roots say.
  [[nodiscard]] std::vector<MPoly> coefficients_of(const MFraction& f) const {
    const Ideal relations(f.ring(), roots_.variables(), symbols_.all.relations);
    const MFraction here =
        roots_.variables().empty() ? MFraction(f.num()) : relations.normal_form(MFraction(f.num()));
    std::vector<std::size_t> moving = symbols_.moving();
    std::ranges::sort(moving);
    return is_zero(here) ? std::vector<MPoly>{} : nonzero_coefficients(here.num(), moving);
  }

  std::vector<std::size_t> coordinates_;
  const WrittenRoots& roots_;
  FunctionSymbols& symbols_;
  std::vector<MFraction> of_file_, written_;
};

// ---- sines and exponentials of sums

MFraction element(const Known& all, const RationalBasis& b, std::size_t j) {
  return Rational(Integer(1), b.divisors[j]) * all[b.of[j]].second;
}

// The rank of arguments that are polynomials.
std::optional<std::size_t> rank_of(const Known& all) {
  std::vector<Terms> terms;
  for (const auto& [u, argument] : all) {
    if (!is_constant(argument.den())) return std::nullopt;
    terms.push_back(terms_of(argument.num()));
  }
  return basis_of(terms).of.size();
}

// More angles than there are independent ones: in sums of the coordinates the symmetries of the
// formulas are hard to see.
Known with_best_angles(Known all, const FunctionSymbols& symbols) {
  std::erase_if(
      all, [&](const auto& one) { return !one.first.is_written && !symbols.moves(one.second); });
  Known written = all;
  std::erase_if(written, [](const auto& one) { return !one.first.is_written; });
  const auto rank = rank_of(written);
  return rank && *rank < written.size() && rank == rank_of(all) ? all : written;
}

Rational length(const std::vector<Rational>& multiples) {
  Rational sum;
  for (const Rational& k : multiples)
    sum = sum + abs(k);
  return sum;
}

using CosineAndSine = std::pair<MFraction, MFraction>;

CosineAndSine angle_sum(const std::vector<CosineAndSine>& of_basis,
                        const std::vector<Rational>& multiples) {
  const Ring& ring = of_basis.front().first.ring();
  MFraction c(ring, Rational(1)), s(ring);
  for (std::size_t j = 0; j < multiples.size(); ++j) {
    const auto& [cj, sj] = of_basis[j];
    const long n = to_long(multiples[j].num());
    for (long k = 0; k < std::abs(n); ++k) {
      const MFraction turned = n > 0 ? sj : -sj;
      const MFraction next = c * cj - s * turned;
      s = s * cj + c * turned;
      c = next;
    }
  }
  return {c, s};
}

void declare_angles(const Known& all, const RationalBasis& b, FunctionSymbols& symbols) {
  std::vector<CosineAndSine> of_basis;
  for (std::size_t j = 0; j < b.of.size(); ++j) {
    const auto& names = all[b.of[j]].first.symbols;
    const MFraction s = symbols.symbol(names[0]), c = symbols.symbol(names[1]);
    const MFraction u = element(all, b, j);
    symbols.declare("sin", u, s, c);
    symbols.declare("cos", u, c, -s);
    symbols.all.relations.push_back((s * s + c * c - symbols.number(1)).num());
    symbols.mean("sin", u, s, symbols.index(names[0]));
    symbols.mean("cos", u, c, symbols.index(names[1]));
    of_basis.emplace_back(c, s);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (length(b.coordinates[i]) > Rational(longest_angle)) continue;
    const auto [c, s] = angle_sum(of_basis, b.coordinates[i]);
    const MFraction& u = all[i].second;
    symbols.mean("sin", u, s);
    symbols.mean("cos", u, c);
    symbols.mean("tan", u, s / c);
  }
}

void declare_exponentials(const Known& all, const RationalBasis& b, FunctionSymbols& symbols) {
  std::vector<MFraction> of_basis;
  for (std::size_t j = 0; j < b.of.size(); ++j) {
    of_basis.push_back(symbols.symbol(all[b.of[j]].first.symbols[0]));
    symbols.declare_meant("exp", element(all, b, j), of_basis[j], of_basis[j]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (length(b.coordinates[i]) > Rational(longest_exponent)) continue;
    MFraction e = symbols.number(1);
    for (std::size_t j = 0; j < of_basis.size(); ++j)
      e *= pow(of_basis[j], to_long(b.coordinates[i][j].num()));
    const MFraction& u = all[i].second;
    const MFraction inverse = symbols.number(1) / e;
    symbols.mean("exp", u, e);
    symbols.mean("sinh", u, Rational(1, 2) * (e - inverse));
    symbols.mean("cosh", u, Rational(1, 2) * (e + inverse));
    symbols.mean("tanh", u, (e - inverse) / (e + inverse));
  }
}

class Declaration {
public:
  Declaration(FunctionsInFormulas::GrowingScope& scope, const FunctionsInFormulas::Declared& file)
      : scope_(scope), file_(file), given_(file.constants), declared_(scope.functions()),
        symbols_(scope, file), roots_(symbols_),
        arguments_(file.coordinates, declared_, roots_, symbols_) {
    given_.insert(given_.end(), file.functions.begin(), file.functions.end());
  }

  /// Roots, and roots in these.
  void add_roots(std::vector<Use>& uses) {
    for (Known known = taken(uses, Family::root); !known.empty(); known = taken(uses, Family::root))
      roots_.add(known);
  }
  /// The others all at once, as they may be combinations of each other.
  void add_transcendental(std::vector<Use>& uses) {
    std::stable_partition(uses.begin(), uses.end(), [](const Use& u) { // these names come first
      return u.argument.kind() == Expression::Kind::name;
    });
    const Known angular = with_best_angles(taken(uses, Family::angle), symbols_);
    const Known exponents = taken(uses, Family::exponent);
    const auto plain = [this](const auto& one) { return is_rational(one.second); };
    with_basis(angular, declare_angles);
    if (angular.empty() || // exp(I*x) is cos(x) + I*sin(x)
        (std::ranges::all_of(angular, plain) && std::ranges::all_of(exponents, plain)))
      with_basis(exponents, declare_exponentials);
    logarithms(taken(uses, Family::logarithm));
  }
  WrittenFunctions result() { return std::move(symbols_.all); }

private:
  // The functions whose arguments are known by now.
  Known taken(std::vector<Use>& uses, Family family) const {
    Known known;
    std::erase_if(uses, [&](const Use& u) {
      if (u.family != family) return false;
      auto argument = argument_of(u);
      if (!argument) return false;
      require_no_velocity(u, *argument);
      if (!is_declared(u, *argument)) known.emplace_back(u, *std::move(argument));
      return true;
    });
    return known;
  }
  std::optional<MFraction> argument_of(const Use& u) const {
    try {
      return evaluate(u.argument, scope_);
    } catch (const Error&) { // unknown as yet, or reported when the formula is evaluated
      return std::nullopt;
    }
  }
  [[nodiscard]] bool is_declared(const Use& u, const MFraction& argument) const {
    return std::ranges::any_of(declared_, [&](const FunctionMeaning& f) {
      return family_of(f.name) == u.family && f.argument == argument;
    });
  }
  void require_no_velocity(const Use& u, const MFraction& argument) const {
    for (const std::size_t i : file_.velocities)
      if (uses(argument, i))
        throw u.argument.error("the velocity '" + scope_.ring()->name(i) + "' is under a function",
                               "the Lagrangian has to be quadratic in the velocities");
  }

  // ---- beside functions that the file declares

  [[nodiscard]] bool uses_function_of_file(const MFraction& f) const {
    return uses_any(f, file_.functions);
  }
  // Functions without a meaning, or with one that is not known here, are refused: nobody knows what holds
  // between them and a sine, an exponential or a logarithm.
  void require_known_functions(const Use& u) const {
    for (const std::size_t i : file_.functions) {
      const auto meaning = std::ranges::find_if(
          declared_, [&](const FunctionMeaning& f) { return f.variable == i; });
      const bool known = meaning != declared_.end() &&
                         (order_of_root(meaning->name) != 0 || family_of(meaning->name)) &&
                         !uses_function_of_file(meaning->argument);
      if (!known)
        throw u.argument.error("a function is written here, and '" + scope_.ring()->name(i) +
                                   "' is declared: what holds between them is not known",
                               "write all functions of [system] in its formulas, or declare all");
    }
  }

  // Already there, or a function of what is not constant, of functions of the file or of other written ones.
  [[nodiscard]] bool cannot_be_argument(const MFraction& f) const {
    return !symbols_.moves(f) || uses_any(f, transcendental_) || uses_function_of_file(f);
  }

  // Only where no combination is a constant, whose sine or exponential nobody knows.
  void with_basis(Known all,
                  void (*declare_on)(const Known&, const RationalBasis&, FunctionSymbols&)) {
    std::erase_if(all, [this](const auto& one) {
      if (is_zero(one.second)) symbols_.mean_at_zero(one.second);
      return is_zero(one.second);
    });
    if (all.empty()) return;
    require_known_functions(all.front().first);
    if (all.size() > 1 &&
        !std::ranges::all_of(all, [this](const auto& x) { return is_normal(x.second); }))
      return;
    MPoly den(symbols_.ring(), Integer(1));
    for (const auto& [u, argument] : all) {
      if (cannot_be_argument(argument)) return;
      den = exact_div(den * argument.den(), gcd(den, argument.den()));
    }
    if (all.size() > 1 && symbols_.moves(den)) return;
    std::vector<Terms> whole, moving;
    for (const auto& [u, argument] : all) {
      Terms terms = terms_of((argument * MFraction(den)).num());
      whole.push_back(terms);
      std::erase_if(terms, [&](const auto& t) {
        return !symbols_.moves(MPoly::term(symbols_.ring(), Integer(1), t.first)) &&
               !symbols_.moves(den);
      });
      moving.push_back(std::move(terms));
    }
    const RationalBasis basis = basis_of(whole);
    if (basis.of.size() != basis_of(moving).of.size()) return;
    std::vector<MFraction> elements;
    for (std::size_t j = 0; j < basis.of.size(); ++j)
      elements.push_back(element(all, basis, j));
    arguments_.add(elements, all.front().first);
    declare_on(all, basis, symbols_);
    for (const std::size_t j : basis.of)
      for (const std::string& name : all[j].first.symbols)
        transcendental_.push_back(symbols_.index(name));
  }

  // Written in one way only: no symbols of the file.
  [[nodiscard]] bool is_normal(const MFraction& f) const {
    return !uses_any(f, given_) && roots_.are_reduced(f);
  }
  [[nodiscard]] bool is_rational(const MFraction& f) const {
    return !uses_any(f, given_) && !uses_any(f, roots_.variables());
  }

  void logarithms(const Known& all) {
    MPoly seen(symbols_.ring(), Integer(1));
    for (const auto& [u, argument] : all) {
      require_known_functions(u);
      if (cannot_be_argument(argument) || (all.size() > 1 && !is_rational(argument))) continue;
      arguments_.add({argument}, u);
      const MPoly parts = argument.num() * argument.den();
      if (!is_constant(gcd(seen, parts))) continue; // logarithms of products are sums
      seen *= parts;
      const MFraction l = symbols_.symbol(u.symbols[0]);
      transcendental_.push_back(symbols_.index(u.symbols[0]));
      symbols_.declare_meant("log", argument, l, symbols_.number(1) / argument);
      symbols_.mean("ln", argument, l);
    }
  }

  FunctionsInFormulas::GrowingScope& scope_;
  const FunctionsInFormulas::Declared& file_;
  std::vector<std::size_t> given_, transcendental_;
  std::vector<FunctionMeaning> declared_;
  FunctionSymbols symbols_;
  WrittenRoots roots_;
  IndependentArguments arguments_;
};

} // namespace

std::vector<MPoly> implied_relations(const std::vector<FunctionMeaning>& meanings,
                                     const Ring& ring) {
  std::vector<MPoly> all;
  const MFraction one(ring, Rational(1));
  const auto value = [&](const FunctionMeaning& m) {
    return m.value ? *m.value : MFraction::variable(ring, m.variable);
  };
  const auto add = [&](const MFraction& f) {
    if (!is_zero(f)) all.push_back(f.num());
  };
  for (const FunctionMeaning& f : meanings) {
    if (const long n = order_of_root(f.name)) add(pow(value(f), n) - f.argument);
    for (const FunctionMeaning& g : meanings) {
      const bool same = f.argument == g.argument;
      if (f.name == "sin" && g.name == "cos" && same)
        add(value(f) * value(f) + value(g) * value(g) - one);
      if (f.name == "sinh" && g.name == "cosh" && same)
        add(value(g) * value(g) - value(f) * value(f) - one);
      if (f.name == "exp" && g.name == "exp" && &f < &g && is_zero(f.argument + g.argument))
        add(value(f) * value(g) - one);
    }
  }
  return all;
}

WrittenFunctions FunctionsInFormulas::declare(GrowingScope& scope, const Declared& declared) const {
  Declaration declaration(scope, declared);
  std::vector<Use> left = uses_;
  declaration.add_roots(left);
  declaration.add_transcendental(left);
  declaration.add_roots(left);
  return declaration.result();
}

} // namespace kov
