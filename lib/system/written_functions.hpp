#pragma once
// Functions as formulas write them: sin(q1 - q2), exp(-x/2), sqrt(x^2 + y^2), (x^2 + y^2)^(-3/2),
// sqrt(a).  A symbol is declared for each that is needed, with its derivative and the relations
// between them, so that the author need not do it.
//
// Exponentials of u_1, ..., u_n are powers of those of a basis of the Q-linear combinations of the
// u_i; sines and cosines are polynomials in those of a basis of the angles.
//
// Source  docs/theory/mechanics.md (1), "Functions in formulas"

#include "symbol/document.hpp"
#include "system/formula.hpp"

#include <set>

namespace kov {

/// A symbol f(u), with u and df/du.
struct WrittenFunction {
  std::size_t variable = 0;
  std::string meaning; ///< "sin(q1)"
  MFraction argument;
  MFraction slope;
};

/// The functions that the formulas write, as symbols.
struct WrittenFunctions {
  std::vector<WrittenFunction> symbols;
  std::vector<std::size_t> constants; ///< roots of what depends on nothing that moves
  std::vector<MPoly> relations;
  std::vector<FunctionMeaning> meanings; ///< of all functions that occur
  std::vector<MPoly> nonzero; ///< in the parameters: else the arguments depend on one another
};

/// The functions in the formulas of [system], by their texts, and in those of another table that asks for more of the
/// same system (a scene: section, where, start, plot, the names of its levels).
class FunctionsInFormulas {
public:
  explicit FunctionsInFormulas(const Entry& system, const Entry* more = nullptr);

  /// Names for all symbols that may be needed; none of them is in `taken`.
  [[nodiscard]] std::vector<std::string> names(std::set<std::string> taken);

  /// The scope of the names of the formulas, while functions are added to it.
  class GrowingScope : public Scope {
  public:
    virtual void add(const FunctionMeaning& meaning) = 0;
  };
  /// The names that the file itself declares.
  struct Declared {
    std::vector<std::size_t> coordinates, velocities, constants;
    std::vector<std::size_t> functions; ///< their meanings, where they are given, are in the scope
  };
  /// The functions that no declared function means; what cannot be treated is left out, and whoever
  /// evaluates a formula with it complains.
  /// Errors   InputError: a velocity under a function, or a declared function of which it is not known
  ///          what holds between it and a written one
  /// Requires names(), in the ring of the scope
  [[nodiscard]] WrittenFunctions declare(GrowingScope& scope, const Declared& declared) const;

  enum class Family : std::uint8_t { angle, exponent, root, logarithm };
  /// All functions of one argument that belong together.
  struct Use {
    Family family;
    Expression argument;
    long root = 1; ///< roots: the least common multiple of the orders
    std::vector<std::string> symbols = {};
    bool is_written = true; ///< else an angle that angles are sums of
  };

private:
  void collect(const Entry& entry);
  void collect_names(const Entry& table);
  void collect(const Expression& e);
  void add_names_in_angles();
  void note(Family family, const Expression& argument, long root = 1);

  std::vector<Use> uses_; ///< inner ones first
};

/// Relations that hold between functions because of what they mean: sin(u)^2 + cos(u)^2 - 1,
/// exp(u) exp(-u) - 1, sqrt(u)^2 - u.  Not all that hold.
/// Given   const Ring ring = make_ring({"q", "s", "c"});
/// Given   const MFraction q = MFraction::variable(ring, "q");
/// Example implied_relations({{1, "sin", q, {}}, {2, "cos", q, {}}}, ring)  // -> {s^2 + c^2 - 1}
[[nodiscard]] std::vector<MPoly> implied_relations(const std::vector<FunctionMeaning>& meanings,
                                                   const Ring& ring);

/// A number that a formula writes: 3, -1/2.
/// Example *written_number(parse_expression("-1/2", "f"))  // -> -1/2
[[nodiscard]] std::optional<Rational> written_number(const Expression& e);
/// The order of the root that a function takes: 2 of "sqrt", n of "root<n>"; else 0.
/// Example order_of_root("root3")  // -> 3
[[nodiscard]] long order_of_root(const std::string& function);

} // namespace kov
