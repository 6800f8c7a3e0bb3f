#pragma once
// A vector field as a graph of operations on power series.
//
// The algebra holds rational functions of the phase variables, of function symbols s (sin q, a square root, ...)
// and of parameters.  A function symbol is one more variable with s' = sum_j (ds/dx_j) x_j', so that every system
// becomes x' = X(x) with rational X, and the k-th coefficient of X(x(t)) comes from those of x up to k by
//
//   sum       (c0 + sum c_i n_i)_k = sum c_i (n_i)_k        a few operations
//   product   (a b)_k = sum_j a_j b_(k-j)                   k + 1 multiplications
//   square    (a^2)_k                                       half as many
//   quotient  q = a/b:  b_0 q_k = a_k - sum_(j<k) q_j b_(k-j)
//   power     p = r^n, r = sqrt(a), c = n/2:  a_0 p_k = c sum_(j<k) p_j a_(k-j) - ((c + 1)/k) sum_(j<k) j p_j a_(k-j)
//   root      r = sqrt(a), a function symbol: 2 r_0 r_k = a_k - sum_(0<j<k) r_j r_(k-j) instead of r' = a'/(2 r)
//
// A node exists once: the same subexpression is the same node.  A coefficient that is 0 makes no node.  What does
// not depend on the phase variables (parameters without a rational value) is `fixed`: it is a number, not a series.
//
// Source  [JorbaZou2005] for the recurrences; [GriewankWalther2008] for both derivatives

#include "system/system.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kov::flow {

using NodeId = std::uint32_t;

struct Node {
  enum class Kind : std::uint8_t { variable, sum, product, square, quotient, power };
  using Terms = std::vector<std::pair<Rational, NodeId>>;
  Kind kind = Kind::sum;
  bool fixed = false;       ///< does not depend on the phase variables
  std::size_t variable = 0; ///< variable: its index in the ring
  Rational constant;        ///< sum: the term without a node
  Terms terms = {};         ///< sum: by rising node, no coefficient 0; empty: a constant
  NodeId a = 0, b = 0;      ///< a b, a^2, a/b; power: b^exponent, where b = sqrt(a) is a variable
  long exponent = 0;        ///< power
};

/// number * form^2 with a number that has no phase variables and a form of degree one: a square, or, where the form is
/// 1, a constant.
struct Square {
  MFraction number;
  MPoly form;
  /// Is the form c + a (x_1 +- x_2 ...) with a rational a, and more than a variable?  Then it can be computed as exactly as
  /// the x_i are known, however much its terms cancel.
  bool is_difference = false;
};
/// f as a sum of squares, by completing them, if it is one of degree two with a difference among them: of
/// x^2 - 2 x + 1 + y^2 that is (x - 1)^2 + y^2.  `fixed` says which variables are numbers.
[[nodiscard]] std::optional<std::vector<Square>> squares_of(const MPoly& f,
                                                            const std::set<std::size_t>& fixed);

class Graph {
public:
  /// The variables in `fixed` are numbers.
  explicit Graph(std::set<std::size_t> fixed) : fixed_(std::move(fixed)) {}

  [[nodiscard]] const Node& node(NodeId n) const { return nodes_.at(n); }
  [[nodiscard]] std::size_t size() const noexcept { return nodes_.size(); }
  [[nodiscard]] std::vector<NodeId> parts(NodeId n) const; ///< what it is made of
  [[nodiscard]] bool is_zero(NodeId n) const;
  [[nodiscard]] bool is_constant(NodeId n) const;

  NodeId constant(const Rational& c) { return sum({}, c); }
  NodeId variable(std::size_t i);
  NodeId sum(const Node::Terms& terms, const Rational& constant = {});
  /// c1 f1 g1 + c2 f2 g2 + ..., a factor of several of them put outside of the brackets.
  struct Product {
    Rational c;
    NodeId f, g;
  };
  NodeId sum_of_products(std::vector<Product> terms);
  NodeId product(NodeId a, NodeId b);
  NodeId quotient(NodeId a, NodeId b); ///< Requires b != 0.
  NodeId times(NodeId n, const MFraction& f);
  NodeId power(NodeId a, long n); ///< Requires n >= 1.
  NodeId root_power(NodeId root,
                    long n); ///< Requires root is a variable that follows a square root
  /// The same functions, with powers of roots, r^-3, as such, which have a recurrence of their own.
  std::vector<NodeId> with_powers(const std::vector<NodeId>& roots);
  /// A rational function: factors are kept, what remains is multiplied out by Horner's rule, the most frequent
  /// variable first.  Errors  OutOfBudget
  NodeId of(const MFraction& f);
  NodeId of(const MPoly& f);
  NodeId multiplied_out(const MFraction& f); ///< whatever is known of f
  /// The series of a variable from order 1 on, if it is not that of its derivative: the square root of a node, or
  /// the node itself.
  struct Rule {
    enum class Kind : std::uint8_t { root, copy } kind;
    NodeId of;
  };
  void follow(std::size_t variable, const Rule& rule) { rules_.insert_or_assign(variable, rule); }
  [[nodiscard]] const Rule* rule_of(std::size_t variable) const {
    const auto found = rules_.find(variable);
    return found == rules_.end() ? nullptr : &found->second;
  }
  /// The same function, as a sum of squares if it is one.
  NodeId argument_of_root(const MFraction& a);
  /// Is it a multiple of a difference, whose square is part of a sum of squares?
  [[nodiscard]] bool is_difference(NodeId n) const;
  /// From now on `of` makes this node of f, and c times it of c f.  Requires  n is f
  void know(const MFraction& f, NodeId n);

  /// d(root)/dx_i for every variable x_i that it uses: one sweep from the root to the variables.  At a node where
  /// `stops` says so it ends, and the derivative by that node is in `at`; x_i stands for what is on other ways.
  struct Gradient {
    std::map<std::size_t, NodeId> by;
    std::map<NodeId, NodeId> at = {};
  };
  Gradient gradient(NodeId root, const std::function<bool(NodeId)>& stops = {});
  /// sum_i d(n)/dx_i v_i for given v_i; `known` keeps what has been found for these v.
  using Tangents = std::map<NodeId, NodeId>;
  NodeId tangent(NodeId n, const std::map<std::size_t, NodeId>& v, Tangents& known);

private:
  NodeId keep(Node n, const std::string& key);
  /// c r^exponent; root: none if it is a constant.
  struct Monomial {
    Rational c;
    std::optional<NodeId> root;
    long exponent = 0;
  };
  using Monomials = std::map<NodeId, std::optional<Monomial>>;
  [[nodiscard]] std::optional<Monomial> monomial(NodeId n, const Monomials& known) const;
  [[nodiscard]] static std::optional<Monomial> times(const Monomial& x, const Monomial& y,
                                                     long sign);
  NodeId scaled(const Rational& c, NodeId n) { return sum({{c, n}}); }
  /// n = c m with the largest such c split off; m = n if there is none.
  /// For a sum whose opposite is there already: -1.
  [[nodiscard]] std::pair<Rational, NodeId> without_factor(NodeId n) const;
  NodeId of_primitive(const MPoly& f);
  NodeId of_squares(const std::vector<Square>& squares);
  NodeId of_factors(const std::vector<MFactor>& factors);
  NodeId of_terms(const MPoly& f);
  [[nodiscard]] std::size_t outermost(const MPoly& f) const;

  std::set<std::size_t> fixed_;
  std::vector<Node> nodes_;
  std::map<std::string, NodeId> ids_;
  std::map<std::string, NodeId> polynomials_;
  std::map<std::size_t, Rule> rules_;
  std::set<std::string> differences_;       ///< without their rational factors
  std::map<std::string, NodeId> fractions_; ///< that are known, without their rational factors
};

/// The motion x' = X(x) with its function symbols.
struct Motion {
  Graph graph;
  std::size_t coordinates = 0; ///< how many of the variables are coordinates: the first
  std::vector<std::size_t>
      variables; ///< in the ring: the coordinates, then the functions that are needed
  std::vector<NodeId> derivatives;       ///< of the variables
  std::vector<NodeId> deviations = {};   ///< of the tangent vector (add_tangent)
  std::vector<std::size_t> tangent = {}; ///< its variables, beyond the ring
  /// The nodes of which the series of all of them are made, with the tangent vector: derivatives,
  /// and variables with a rule.
  [[nodiscard]] std::vector<NodeId> series_roots() const;
};

/// The motion of a system, with at least the functions that `used` depends on.
/// Given   written: how the file writes some functions (written.hpp)
/// Cost    the least of: X multiplied out or as it is written, or by one sweep from H, multiplied out or written, which
///         may end at nodes of function symbols alone whose derivatives cost nothing: those of cos(q_1 - q_2), written
///         with sines and cosines, are the nodes of sin(q_1 - q_2)
/// Errors  OutOfBudget
[[nodiscard]] Motion motion_of(const System& s, const std::vector<MFraction>& used,
                               const Graph* written = nullptr);
/// Makes powers of square roots of what they are, r^-3, where that saves products of series.
void use_powers(Motion& m);
/// Adds the first variational equation v' = DX(x) v.
void add_tangent(Motion& m, std::size_t ring_size);

/// Products of series (a square counts half) that the nodes need together: the cost of an order.
[[nodiscard]] double products(const Graph& g, const std::vector<NodeId>& roots);

} // namespace kov::flow
