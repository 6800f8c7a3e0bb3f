#include "system/written_functions.hpp"

#include "exact/error.hpp"
#include "exact/finite_algebra.hpp"
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

void subtract(Terms& from, const Rational& c, const Terms& what) {
  for (const auto& [m, x] : what) {
    Rational& here = from[m];
    here = here - c * x;
    if (is_zero(here)) from.erase(m);
  }
}

/// A basis of the Q-linear combinations of some functions, all of which are integral ones of it.
struct Basis {
  std::vector<std::size_t> of;                    ///< which of the functions, each divided by
  std::vector<Integer> divisors;                  ///< one of these
  std::vector<std::vector<Rational>> coordinates; ///< of each function, integers
};

class Elimination {
public:
  /// f is a combination of the basis, or its next element.
  void add(Terms f) {
    std::vector<Rational> known(of_.size());
    for (const Row& row : rows_) {
      const auto lead = f.find(row.value.begin()->first);
      if (lead == f.end()) continue;
      const Rational c = lead->second / row.value.begin()->second;
      subtract(f, c, row.value);
      for (std::size_t j = 0; j < row.in_basis.size(); ++j)
        known[j] = known[j] + c * row.in_basis[j];
    }
    if (f.empty()) return coordinates_.push_back(std::move(known));
    std::vector<Rational> unit(of_.size());
    unit.emplace_back(Integer(1));
    for (Rational& x : known)
      x = -x;
    known.emplace_back(Integer(1));
    of_.push_back(coordinates_.size());
    rows_.push_back({std::move(f), std::move(known)});
    coordinates_.push_back(std::move(unit));
  }
  [[nodiscard]] std::size_t rank() const { return of_.size(); }
  [[nodiscard]] Basis basis() {
    Basis b{of_, std::vector<Integer>(of_.size(), Integer(1)), std::move(coordinates_)};
    for (auto& row : b.coordinates) {
      row.resize(of_.size());
      for (std::size_t j = 0; j < row.size(); ++j)
        b.divisors[j] = lcm(b.divisors[j], row[j].den());
    }
    for (auto& row : b.coordinates)
      for (std::size_t j = 0; j < row.size(); ++j)
        row[j] = row[j] * Rational(b.divisors[j]);
    return b;
  }

private:
  struct Row {
    Terms value;
    std::vector<Rational> in_basis;
  };
  std::vector<Row> rows_;
  std::vector<std::size_t> of_;
  std::vector<std::vector<Rational>> coordinates_;
};

// ---- the symbols

class Declaration {
  using Known = std::vector<std::pair<Use, MFraction>>;

public:
  Declaration(FunctionsInFormulas::GrowingScope& scope, const FunctionsInFormulas::Declared& file)
      : scope_(scope), file_(file), moving_(file.coordinates), given_(file.constants),
        declared_(scope.functions()) {
    given_.insert(given_.end(), file.functions.begin(), file.functions.end());
    moving_.insert(moving_.end(), given_.begin(), given_.end());
    for (const FunctionMeaning& f : declared_)
      if (const auto family = family_of(f.name); family && *family != Family::root)
        note_argument(file_arguments_, f.argument);
  }

  /// Roots, and roots in these.
  void add_roots(std::vector<Use>& uses) {
    for (Known known = taken(uses, Family::root); !known.empty(); known = taken(uses, Family::root))
      roots(known);
  }
  /// The others all at once, as they may be combinations of each other.
  void add_transcendental(std::vector<Use>& uses) {
    std::stable_partition(uses.begin(), uses.end(), [](const Use& u) { // these names come first
      return u.argument.kind() == Expression::Kind::name;
    });
    const Known angular = with_best_angles(taken(uses, Family::angle));
    const Known exponents = taken(uses, Family::exponent);
    const auto plain = [this](const auto& one) { return is_rational(one.second); };
    with_basis(angular, [this](const auto& all, const Basis& b) { angles(all, b); });
    if (angular.empty() || // exp(I*x) is cos(x) + I*sin(x)
        (std::ranges::all_of(angular, plain) && std::ranges::all_of(exponents, plain)))
      with_basis(exponents, [this](const auto& all, const Basis& b) { exponentials(all, b); });
    logarithms(taken(uses, Family::logarithm));
  }
  WrittenFunctions result() { return std::move(all_); }

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

  static bool is_root(const FunctionMeaning& f) { return order_of_root(f.name) != 0; }
  static void note_argument(std::vector<MFraction>& all, const MFraction& argument) {
    add_once(all, argument);
  }
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
                         (is_root(*meaning) || family_of(meaning->name)) &&
                         !uses_function_of_file(meaning->argument);
      if (!known)
        throw u.argument.error("a function is written here, and '" + scope_.ring()->name(i) +
                                   "' is declared: what holds between them is not known",
                               "write all functions of [system] in its formulas, or declare all");
    }
  }

  // ---- independence over the complex numbers

  // d f/d x_j, through the roots.
  MFraction slope(const MFraction& f, std::size_t j) const {
    MFraction sum = derivative(f, file_.coordinates[j]);
    for (const WrittenFunction& r : all_.symbols)
      if (uses(f, r.variable)) sum += derivative(f, r.variable) * r.slope * slope(r.argument, j);
    return sum;
  }
  [[nodiscard]] std::vector<MFraction> gradient_of(const MFraction& f) const {
    std::vector<MFraction> all;
    for (std::size_t j = 0; j < file_.coordinates.size(); ++j)
      all.push_back(slope(f, j));
    return all;
  }
  // As a polynomial in what moves: its coefficients, without those of the relations of roots.
  [[nodiscard]] std::vector<MPoly> coefficients_of(const MFraction& f) const {
    std::vector<std::size_t> roots;
    for (const Root& r : roots_)
      roots.push_back(used_variables(r.value).front());
    const Ideal relations(f.ring(), roots, all_.relations);
    const MFraction here =
        roots.empty() ? MFraction(f.num()) : relations.normal_form(MFraction(f.num()));
    std::map<std::vector<unsigned long>, MFraction> parts;
    const MPoly num = here.num();
    for (long t = 0; t < num.length(); ++t) {
      auto moving = num.exponents(t), still = moving;
      for (std::size_t i = 0; i < moving.size(); ++i)
        (!is_among(i, moving_) ? moving : still)[i] = 0;
      const auto part = parts.try_emplace(moving, MFraction(f.ring())).first;
      part->second += MFraction(MPoly::term(f.ring(), num.coefficient(t), still));
    }
    std::vector<MPoly> all;
    for (const auto& [monomial, part] : parts)
      if (!is_zero(part)) all.push_back(part.num());
    return all;
  }
  void require_independent(const std::vector<MFraction>& more, const Use& u) {
    if (!are_independent(more))
      throw u.argument.error(
          "the arguments of the functions that are written depend on one another, "
          "so that the functions do not take all values at once",
          "declare symbols for them: [[system.function]] with means and derivative");
  }
  // The arguments take all values near a point, whatever the parameters: a minor of their gradients
  // has a coefficient that is a number, or is noted.  False: they depend on one another.
  bool are_independent(const std::vector<MFraction>& more) {
    Matrix rows;
    for (const MFraction& f : file_arguments_) { // these may depend on one another
      rows.push_back(gradient_of(f));
      if (rank(rows) < rows.size()) rows.pop_back();
    }
    for (const std::vector<MFraction>* functions : {&std::as_const(written_), &more})
      for (const MFraction& f : *functions)
        rows.push_back(gradient_of(f));
    return rows.size() <= file_.coordinates.size() && note_minor(rows);
  }
  static std::size_t rank(const Matrix& rows) {
    return rows[0].size() - null_space(rows, rows[0].size(), rows[0][0].ring()).size();
  }
  bool note_minor(const Matrix& rows) {
    std::optional<MPoly> best;
    const bool never_zero =
        some_minor(rows, file_.coordinates.size(), rows[0][0].ring(), [&](const MFraction& d) {
          for (const MPoly& c : coefficients_of(d)) {
            if (is_constant(c)) return true;
            if (!best || c.length() < best->length()) best = c;
          }
          return false;
        });
    if (never_zero) return true;
    if (!best) return false;
    all_.nonzero.push_back(*best);
    return true;
  }

  [[nodiscard]] bool moves(const MPoly& f) const { return uses_any(f, moving_); }
  [[nodiscard]] bool moves(const MFraction& f) const {
    return !is_zero(f) && (moves(f.num()) || moves(f.den()));
  }
  [[nodiscard]] bool is_transcendental(const MFraction& f) const {
    return uses_any(f, transcendental_);
  }

  MFraction symbol(const std::string& name) const {
    return MFraction::variable(scope_.ring(), name);
  }
  MFraction number(const Rational& c) const { return {scope_.ring(), c}; }
  void mean(const std::string& function, const MFraction& argument, const MFraction& value,
            std::size_t variable = nothing) {
    FunctionMeaning m{variable, function, argument, {}};
    if (variable == nothing) m.value = value;
    all_.meanings.push_back(m);
    scope_.add(m);
  }
  void declare(const std::string& function, const MFraction& argument, const MFraction& name,
               const MFraction& slope) {
    const std::size_t i = used_variables(name).front();
    all_.symbols.push_back({i, function + "(" + to_string(argument) + ")", argument, slope});
    moving_.push_back(i);
  }

  // ---- angles and exponentials

  // More angles than there are independent ones: in sums of the coordinates the symmetries of the
  // formulas are hard to see.
  [[nodiscard]] Known with_best_angles(Known all) const {
    std::erase_if(all,
                  [this](const auto& one) { return !one.first.is_written && !moves(one.second); });
    Known written = all;
    std::erase_if(written, [](const auto& one) { return !one.first.is_written; });
    const auto rank = rank_of(written);
    return rank && *rank < written.size() && rank == rank_of(all) ? all : written;
  }
  // The rank of arguments that are polynomials.
  static std::optional<std::size_t> rank_of(const Known& all) {
    Elimination whole;
    for (const auto& [u, argument] : all) {
      if (!is_constant(argument.den())) return std::nullopt;
      whole.add(terms_of(argument.num()));
    }
    return whole.rank();
  }

  // Only where no combination is a constant, whose sine or exponential nobody knows.
  template <class F> void with_basis(Known all, F declare_on) {
    std::erase_if(all, [this](const auto& one) {
      if (is_zero(one.second)) mean_at_zero(one.second);
      return is_zero(one.second);
    });
    if (all.empty()) return;
    require_known_functions(all.front().first);
    if (all.size() > 1 &&
        !std::ranges::all_of(all, [this](const auto& x) { return is_normal(x.second); }))
      return;
    MPoly den(scope_.ring(), Integer(1));
    for (const auto& [u, argument] : all) {
      if (!moves(argument) || is_transcendental(argument) || uses_function_of_file(argument))
        return;
      den = exact_div(den * argument.den(), gcd(den, argument.den()));
    }
    if (all.size() > 1 && moves(den)) return;
    Elimination whole, moving;
    for (const auto& [u, argument] : all) {
      Terms terms = terms_of((argument * MFraction(den)).num());
      whole.add(terms);
      std::erase_if(terms, [&](const auto& t) {
        return !moves(MPoly::term(scope_.ring(), Integer(1), t.first)) && !moves(den);
      });
      moving.add(std::move(terms));
    }
    if (whole.rank() != moving.rank()) return;
    const Basis basis = whole.basis();
    std::vector<MFraction> elements;
    for (std::size_t j = 0; j < basis.of.size(); ++j)
      elements.push_back(element(all, basis, j));
    require_independent(elements, all.front().first);
    written_.insert(written_.end(), elements.begin(), elements.end());
    declare_on(all, basis);
  }

  void mean_at_zero(const MFraction& zero) {
    for (const char* function : {"sin", "tan", "sinh", "tanh"})
      mean(function, zero, number(0));
    for (const char* function : {"cos", "exp", "cosh"})
      mean(function, zero, number(1));
  }
  // Written in one way only: no symbols of the file, and roots in the numerator with exponents below
  // their orders, which are linearly independent over the rational functions.
  [[nodiscard]] bool is_normal(const MFraction& f) const {
    for (const std::size_t i : given_)
      if (uses(f, i)) return false;
    return std::ranges::all_of(roots_, [&](const Root& r) {
      const std::size_t i = used_variables(r.value).front();
      return !uses(f.den(), i) && degree(f.num(), i) < r.order;
    });
  }

  [[nodiscard]] bool is_rational(const MFraction& f) const {
    const auto in_f = [&](std::size_t i) { return uses(f, i); };
    return std::ranges::none_of(given_, in_f) && std::ranges::none_of(roots_, [&](const Root& r) {
             return in_f(used_variables(r.value).front());
           });
  }

  static MFraction element(const Known& all, const Basis& b, std::size_t j) {
    return Rational(Integer(1), b.divisors[j]) * all[b.of[j]].second;
  }

  void angles(const Known& all, const Basis& b) {
    std::vector<std::pair<MFraction, MFraction>> of_basis; // cosine, sine
    for (std::size_t j = 0; j < b.of.size(); ++j) {
      const auto& names = all[b.of[j]].first.symbols;
      const MFraction s = symbol(names[0]), c = symbol(names[1]), u = element(all, b, j);
      declare("sin", u, s, c);
      declare("cos", u, c, -s);
      transcendental_.push_back(scope_.ring()->index(names[0]));
      transcendental_.push_back(scope_.ring()->index(names[1]));
      all_.relations.push_back((s * s + c * c - number(1)).num());
      mean("sin", u, s, scope_.ring()->index(names[0]));
      mean("cos", u, c, scope_.ring()->index(names[1]));
      of_basis.emplace_back(c, s);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto sum = angle_sum(of_basis, b.coordinates[i]);
      if (!sum) continue;
      const auto& [c, s] = *sum;
      const MFraction& u = all[i].second;
      mean("sin", u, s);
      mean("cos", u, c);
      mean("tan", u, s / c);
    }
  }
  std::optional<std::pair<MFraction, MFraction>>
  angle_sum(const std::vector<std::pair<MFraction, MFraction>>& of_basis,
            const std::vector<Rational>& multiples) const {
    MFraction c = number(1), s = number(0);
    Rational length;
    for (const Rational& k : multiples)
      length = length + abs(k);
    if (length > Rational(longest_angle)) return std::nullopt;
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
    return std::pair(c, s);
  }

  void exponentials(const Known& all, const Basis& b) {
    std::vector<MFraction> of_basis;
    for (std::size_t j = 0; j < b.of.size(); ++j) {
      const std::string& name = all[b.of[j]].first.symbols[0];
      const MFraction e = symbol(name), u = element(all, b, j);
      declare("exp", u, e, e);
      transcendental_.push_back(scope_.ring()->index(name));
      mean("exp", u, e, scope_.ring()->index(name));
      of_basis.push_back(e);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      MFraction e = number(1);
      Rational length;
      for (const Rational& k : b.coordinates[i])
        length = length + abs(k);
      if (length > Rational(1000)) continue;
      for (std::size_t j = 0; j < of_basis.size(); ++j)
        e *= pow(of_basis[j], to_long(b.coordinates[i][j].num()));
      const MFraction& u = all[i].second;
      const MFraction inverse = number(1) / e;
      mean("exp", u, e);
      mean("sinh", u, Rational(1, 2) * (e - inverse));
      mean("cosh", u, Rational(1, 2) * (e + inverse));
      mean("tanh", u, (e - inverse) / (e + inverse));
    }
  }

  void logarithms(const Known& all) {
    MPoly seen(scope_.ring(), Integer(1));
    for (const auto& [u, argument] : all) {
      require_known_functions(u);
      if (!moves(argument) || is_transcendental(argument) || uses_function_of_file(argument))
        continue;
      if (all.size() > 1 && !is_rational(argument)) continue;
      require_independent({argument}, u);
      written_.push_back(argument);
      const MPoly parts = argument.num() * argument.den();
      if (!is_constant(gcd(seen, parts))) continue; // logarithms of products are sums
      seen *= parts;
      const MFraction l = symbol(u.symbols[0]);
      declare("log", argument, l, number(1) / argument);
      transcendental_.push_back(scope_.ring()->index(u.symbols[0]));
      mean("log", argument, l, scope_.ring()->index(u.symbols[0]));
      mean("ln", argument, l);
    }
  }

  // ---- roots

  struct Root {
    MFraction of, value;
    long order;
  };

  void roots(const Known& all) {
    for (const auto& [u, argument] : all) {
      if (u.root > highest_root) continue;
      if (auto known = known_root(argument, u.root)) {
        mean_roots(argument, *known, u.root, nothing);
        continue;
      }
      const MFraction r = symbol(u.symbols[0]);
      const std::size_t i = scope_.ring()->index(u.symbols[0]);
      const auto power = pow(r, u.root);
      all_.relations.push_back((power * MFraction(argument.den()) - argument.num()).num());
      if (moves(argument))
        declare(u.root == 2 ? "sqrt" : "root" + std::to_string(u.root), argument, r,
                r / (Rational(u.root) * argument));
      else
        all_.constants.push_back(i);
      mean_roots(argument, r, u.root, i);
      roots_.push_back({argument, r, u.root});
    }
  }
  void mean_roots(const MFraction& of, const MFraction& root, long order, std::size_t variable) {
    if (order == 2) return mean("sqrt", of, root, variable);
    mean("root" + std::to_string(order), of, root, variable);
    if (order % 2 == 0) mean("sqrt", of, pow(root, order / 2));
  }
  // The root of c^n f or of c^n/f, where the root of f has a symbol, or of a power of a number.
  std::optional<MFraction> known_root(const MFraction& of, long order) const {
    if (is_zero(of)) return number(0);
    if (is_constant(of)) {
      const auto c = exact_root(to_rational(of), order);
      if (c) return number(*c);
    }
    for (const Root& r : roots_) {
      if (r.order % order != 0) continue;
      const MFraction root = pow(r.value, r.order / order);
      for (const bool inverse : {false, true}) {
        const MFraction ratio = inverse ? of * r.of : of / r.of;
        if (!is_constant(ratio)) continue;
        if (const auto c = exact_root(to_rational(ratio), order))
          return number(*c) * (inverse ? number(1) / root : root);
      }
    }
    return std::nullopt;
  }
  static std::optional<Rational> exact_root(const Rational& q, long order) {
    if (sign(q) <= 0) return std::nullopt;
    Integer num, den;
    const auto n = static_cast<unsigned long>(order);
    if (fmpz_root(num.raw(), q.num().raw(), static_cast<slong>(n)) == 0) return std::nullopt;
    if (fmpz_root(den.raw(), q.den().raw(), static_cast<slong>(n)) == 0) return std::nullopt;
    return Rational(num, den);
  }

  FunctionsInFormulas::GrowingScope& scope_;
  const FunctionsInFormulas::Declared& file_;
  std::vector<std::size_t> moving_, given_, transcendental_;
  std::vector<MFraction> file_arguments_, written_; ///< of sines, exponentials, logarithms
  std::vector<FunctionMeaning> declared_;
  std::vector<Root> roots_;
  WrittenFunctions all_;
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
