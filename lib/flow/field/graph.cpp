#include "flow/field/graph.hpp"

#include "exact/budget.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <optional>

namespace kov::flow {
namespace {

constexpr std::size_t max_nodes = 200'000;
constexpr long factored_terms = 400; // longer polynomials are not factored

long total_degree(const std::vector<unsigned long>& exponents) {
  long sum = 0;
  for (const unsigned long e : exponents)
    sum += static_cast<long>(e);
  return sum;
}

MPoly term_of(const MPoly& f, long i) {
  return MPoly::term(f.ring(), f.coefficient(i), f.exponents(i));
}

// f = content times a polynomial whose coefficients are coprime and begin with a positive one.
Integer content_of(const MPoly& f) {
  Integer content(0);
  for (long i = 0; i < f.length(); ++i)
    content = gcd(content, f.coefficient(i));
  return f.coefficient(0) < Integer(0) ? Integer(0) - content : content;
}

// The rational factor of f, and a key that f has in common with its multiples by numbers.  Requires f != 0.
std::pair<Rational, std::string> without_content(const MFraction& f) {
  const Integer above = content_of(f.num()), below = content_of(f.den());
  const auto rest = [&](const MPoly& p, const Integer& content) {
    return to_string(exact_div(p, MPoly(p.ring(), content)));
  };
  return {Rational(above, below), rest(f.num(), above) + "/" + rest(f.den(), below)};
}

} // namespace

// ---- nodes ----

NodeId Graph::keep(Node n, const std::string& key) {
  if (const auto known = ids_.find(key); known != ids_.end()) return known->second;
  if (nodes_.size() >= max_nodes)
    throw OutOfBudget("size limit: the field has too many operations");
  nodes_.push_back(std::move(n));
  return ids_[key] = static_cast<NodeId>(nodes_.size() - 1);
}

bool Graph::is_constant(NodeId n) const {
  const Node& x = node(n);
  return x.kind == Node::Kind::sum && x.terms.empty();
}

bool Graph::is_zero(NodeId n) const { return is_constant(n) && node(n).constant == Rational(); }

std::vector<NodeId> Graph::parts(NodeId n) const {
  const Node& x = node(n);
  if (x.kind == Node::Kind::variable) return {};
  if (x.kind == Node::Kind::square) return {x.a};
  if (x.kind != Node::Kind::sum) return {x.a, x.b};
  std::vector<NodeId> all;
  for (const auto& [c, part] : x.terms)
    all.push_back(part);
  return all;
}

NodeId Graph::variable(std::size_t i) {
  Node n;
  n.kind = Node::Kind::variable;
  n.variable = i;
  n.fixed = fixed_.contains(i);
  return keep(std::move(n), "x" + std::to_string(i));
}

static std::string key_of_sum(const Rational& constant, const Node::Terms& terms) {
  std::string key = "+" + to_string(constant);
  for (const auto& [c, id] : terms)
    key += "," + to_string(c) + "*" + std::to_string(id);
  return key;
}

// Short sums are taken apart: that costs less than another instruction.
NodeId Graph::sum(const Node::Terms& terms, const Rational& constant) {
  std::map<NodeId, Rational> all;
  Node n;
  n.constant = constant;
  for (const auto& [c, id] : terms) {
    const Node& part = node(id);
    if (part.kind == Node::Kind::sum && part.terms.size() <= 3) {
      n.constant = n.constant + c * part.constant;
      for (const auto& [inner, inner_id] : part.terms)
        all[inner_id] = all[inner_id] + c * inner;
    } else {
      all[id] = all[id] + c;
    }
  }
  n.fixed = true;
  for (const auto& [id, c] : all) {
    if (c == Rational()) continue;
    n.terms.emplace_back(c, id);
    n.fixed = n.fixed && node(id).fixed;
  }
  if (n.terms.size() == 1 && n.constant == Rational() && n.terms[0].first == Rational(1))
    return n.terms[0].second;
  const std::string key = key_of_sum(n.constant, n.terms);
  return keep(std::move(n), key);
}

NodeId Graph::sum_of_products(std::vector<Product> terms) {
  std::map<NodeId, int> uses;
  std::erase_if(terms, [&](const Product& p) { return is_zero(p.f) || is_zero(p.g); });
  for (Product& p : terms)
    for (NodeId* part : {&p.f, &p.g}) {
      const auto [c, rest] = without_factor(*part);
      p.c = p.c * c;
      *part = rest;
      if (!is_constant(rest)) ++uses[rest];
    }
  std::map<NodeId, Node::Terms> beside; // the most frequent factor: what it is multiplied with
  for (const Product& p : terms) {
    const bool first = uses[p.f] >= uses[p.g];
    beside[first ? p.f : p.g].emplace_back(p.c, first ? p.g : p.f);
  }
  Node::Terms all;
  for (const auto& [factor, others] : beside)
    all.emplace_back(Rational(1), product(factor, sum(others)));
  return sum(all);
}

std::pair<Rational, NodeId> Graph::without_factor(NodeId n) const {
  const Node& x = node(n);
  if (x.kind == Node::Kind::sum && x.terms.size() == 1 && x.constant == Rational())
    return x.terms[0];
  if (x.kind == Node::Kind::sum && x.terms.size() > 1) {
    Node::Terms opposite = x.terms;
    for (auto& [c, part] : opposite)
      c = -c;
    const auto known = ids_.find(key_of_sum(-x.constant, opposite));
    if (known != ids_.end() && known->second < n) return {Rational(-1), known->second};
  }
  return {Rational(1), n};
}

NodeId Graph::product(NodeId a, NodeId b) {
  for (const auto& [x, y] : {std::pair{a, b}, std::pair{b, a}})
    if (const Node& n = node(x); n.kind == Node::Kind::sum && n.terms.empty())
      return scaled(n.constant, y);
  const auto [c, p] = without_factor(a);
  const auto [d, q] = without_factor(b);
  Node n;
  n.kind = p == q ? Node::Kind::square : Node::Kind::product;
  n.a = std::min(p, q);
  n.b = std::max(p, q);
  n.fixed = node(p).fixed && node(q).fixed;
  const std::string key = "*" + std::to_string(n.a) + "," + std::to_string(n.b);
  return scaled(c * d, keep(std::move(n), key));
}

NodeId Graph::quotient(NodeId a, NodeId b) {
  if (is_zero(b)) throw DomainError("a denominator of the field is 0");
  if (is_zero(a)) return a;
  if (const Node& n = node(b); n.kind == Node::Kind::sum && n.terms.empty())
    return scaled(Rational(1) / n.constant, a);
  const auto [c, p] = without_factor(a);
  const auto [d, q] = without_factor(b);
  if (p == q) return constant(c / d);
  if (is_constant(p) && node(p).constant != Rational(1))
    return scaled(c * node(p).constant / d, quotient(constant(Rational(1)), q));
  if (node(q).fixed && !node(p).fixed) // one number instead of a recurrence
    return scaled(c / d, product(p, quotient(constant(Rational(1)), q)));
  Node n;
  n.kind = Node::Kind::quotient;
  n.a = p;
  n.b = q;
  n.fixed = node(p).fixed && node(q).fixed;
  const std::string key = "/" + std::to_string(p) + "," + std::to_string(q);
  return scaled(c / d, keep(std::move(n), key));
}

NodeId Graph::times(NodeId n, const MFraction& f) {
  return quotient(product(n, of(f.num())), of(f.den()));
}

NodeId Graph::power(NodeId a, long n) {
  if (n == 1) return a;
  const NodeId half = power(a, n / 2), even = product(half, half);
  return n % 2 == 0 ? even : product(a, power(a, n - 1));
}

NodeId Graph::root_power(NodeId root, long n) {
  if (n == 0) return constant(Rational(1));
  if (n == 1) return root;
  Node p;
  p.kind = Node::Kind::power;
  p.a = rule_of(node(root).variable)->of;
  p.b = root;
  p.exponent = n;
  return keep(std::move(p), "^" + std::to_string(root) + "," + std::to_string(n));
}

std::optional<Graph::Monomial> Graph::times(const Monomial& x, const Monomial& y, long sign) {
  if (x.root && y.root && *x.root != *y.root) return std::nullopt;
  return Monomial{sign > 0 ? x.c * y.c : x.c / y.c, x.root ? x.root : y.root,
                  x.exponent + sign * y.exponent};
}

// n as c r^e of one root r, from what is known of its parts.
std::optional<Graph::Monomial> Graph::monomial(NodeId n, const Monomials& known) const {
  const Node& x = node(n);
  switch (x.kind) {
  case Node::Kind::variable: {
    const Rule* rule = rule_of(x.variable);
    if (rule == nullptr || rule->kind != Rule::Kind::root) return std::nullopt;
    return Monomial{Rational(1), n, 1};
  }
  case Node::Kind::power:
    return Monomial{Rational(1), x.b, x.exponent};
  case Node::Kind::sum: {
    if (x.terms.empty()) return Monomial{x.constant, std::nullopt, 0};
    if (x.terms.size() > 1 || !(x.constant == Rational())) return std::nullopt;
    auto part = known.at(x.terms[0].second);
    if (part) part->c = x.terms[0].first * part->c;
    return part;
  }
  default:
    break;
  }
  const auto &a = known.at(x.a), &b = known.at(x.kind == Node::Kind::square ? x.a : x.b);
  if (!a || !b) return std::nullopt;
  return times(*a, *b, x.kind == Node::Kind::quotient ? -1 : 1);
}

std::vector<NodeId> Graph::with_powers(const std::vector<NodeId>& roots) {
  std::set<NodeId> needed(roots.begin(), roots.end());
  for (auto n = needed.rbegin(); n != needed.rend(); ++n) // parts have smaller ids
    for (const NodeId part : parts(*n))
      needed.insert(part);
  Monomials known;
  std::map<NodeId, NodeId> made;
  for (const NodeId n : needed) {
    const Node x = node(n);
    const auto& m = known[n] = monomial(n, known);
    const auto of = [&](NodeId part) { return made.at(part); };
    if (m && m->root && x.kind != Node::Kind::variable) {
      made[n] = scaled(m->c, root_power(*m->root, m->exponent));
    } else if (x.kind == Node::Kind::sum) {
      Node::Terms terms;
      for (const auto& [c, part] : x.terms)
        terms.emplace_back(c, of(part));
      made[n] = sum(terms, x.constant);
    } else if (x.kind == Node::Kind::product || x.kind == Node::Kind::square) {
      made[n] = product(of(x.a), of(x.kind == Node::Kind::square ? x.a : x.b));
    } else if (x.kind == Node::Kind::quotient) {
      const auto& below = known.at(x.b);
      made[n] = below && below->root
                    ? scaled(Rational(1) / below->c,
                             product(of(x.a), root_power(*below->root, -below->exponent)))
                    : quotient(of(x.a), of(x.b));
    } else {
      made[n] = n;
    }
  }
  return mapped<NodeId>(roots, [&](const NodeId n) { return made.at(n); });
}

// ---- sums of squares ----

namespace {

bool is_fixed_number(const std::vector<unsigned long>& exponents,
                     const std::set<std::size_t>& fixed) {
  for (std::size_t v = 0; v < exponents.size(); ++v)
    if (exponents[v] > 0 && !fixed.contains(v)) return false;
  return true;
}

bool is_fixed_number(const MPoly& f, const std::set<std::size_t>& fixed) {
  for (long i = 0; i < f.length(); ++i)
    if (!is_fixed_number(f.exponents(i), fixed)) return false;
  return true;
}

bool has_degree_two(const MPoly& f, const std::set<std::size_t>& fixed) {
  unsigned long most = 0;
  for (long i = 0; i < f.length(); ++i) {
    const auto e = f.exponents(i);
    unsigned long degree = 0;
    for (std::size_t v = 0; v < e.size(); ++v)
      degree += fixed.contains(v) ? 0 : e[v];
    most = std::max(most, degree);
  }
  return most == 2;
}

// c + a (x_1 +- x_2 ...) with a rational a, and more than one term: its terms cancel without another rounding.
bool is_sum_of_variables(const MPoly& form, const std::set<std::size_t>& fixed) {
  std::optional<Integer> a;
  for (long i = 0; i < form.length(); ++i) {
    const auto e = form.exponents(i);
    if (is_fixed_number(e, fixed)) continue;
    const Integer c = form.coefficient(i);
    if (total_degree(e) > 1 || (a && !(c == *a) && !(c == Integer(0) - *a))) return false;
    a = c;
  }
  return form.length() > 1;
}

// f = c (a x^2 + b x + rest): 4 a f/c = (2 a x + b)^2 + 4 a rest - b^2, and where b = 0 any number may be a.
struct Completed {
  Square square;
  MFraction factor; ///< of what is left
  MPoly left;
};
std::optional<Completed> complete_square(const MPoly& f, std::size_t x,
                                         const std::set<std::size_t>& fixed) {
  const std::vector<MPoly> c = coefficients(f, x);
  const Ring& ring = f.ring();
  if (c.size() != 3 || !is_fixed_number(c[2], fixed)) return std::nullopt;
  const MPoly variable = MPoly::variable(ring, x);
  if (kov::is_zero(c[1]))
    return Completed{{MFraction(c[2]), variable}, MFraction(ring, Rational(1)), c[0]};
  if (!kov::is_constant(c[2])) return std::nullopt;
  const MPoly four(ring, Integer(4)), two(ring, Integer(2)), form = two * c[2] * variable + c[1];
  const Integer content = content_of(form);
  const MFraction part =
      Rational(1) / Rational(Integer(4)) * (MFraction(ring, Rational(1)) / MFraction(c[2]));
  Square square{Rational(content * content) * part, exact_div(form, MPoly(ring, content)), false};
  square.is_difference = is_sum_of_variables(square.form, fixed);
  return Completed{std::move(square), part, four * c[2] * c[0] - c[1] * c[1]};
}

// A key that a sum has in common with its multiples by numbers.
std::string key_without_factor(const Rational& constant, const Node::Terms& terms) {
  const Rational first = terms.front().first;
  std::string key = to_string(constant / first);
  for (const auto& [c, part] : terms)
    key += "," + to_string(c / first) + "*" + std::to_string(part);
  return key;
}

} // namespace

std::optional<std::vector<Square>> squares_of(const MPoly& f, const std::set<std::size_t>& fixed) {
  if (!has_degree_two(f, fixed)) return std::nullopt;
  std::vector<Square> all;
  MFraction factor(f.ring(), Rational(1));
  MPoly left = f;
  while (!is_fixed_number(left, fixed)) {
    std::optional<Completed> next;
    for (const std::size_t x : used_variables(left))
      if (!next && !fixed.contains(x)) next = complete_square(left, x, fixed);
    if (!next) return std::nullopt;
    next->square.number *= factor;
    factor *= next->factor;
    left = next->left;
    all.push_back(std::move(next->square));
  }
  if (std::ranges::none_of(all, [](const Square& s) { return s.is_difference; }))
    return std::nullopt;
  if (!kov::is_zero(left)) all.push_back({factor * MFraction(left), MPoly(f.ring(), Integer(1))});
  return all;
}

NodeId Graph::of_squares(const std::vector<Square>& squares) {
  Node::Terms terms;
  for (const Square& s : squares) {
    const NodeId form = of(s.form);
    if (s.is_difference) {
      const Node& n = node(form);
      differences_.insert(key_without_factor(n.constant, n.terms));
    }
    terms.emplace_back(Rational(1), times(product(form, form), s.number));
  }
  return sum(terms);
}

NodeId Graph::argument_of_root(const MFraction& a) {
  if (!kov::is_constant(a.den())) return of(a);
  const auto squares = squares_of(a.num(), fixed_);
  return squares ? quotient(of_squares(*squares), of(a.den())) : of(a);
}

bool Graph::is_difference(NodeId id) const {
  const Node& n = node(id);
  return n.kind == Node::Kind::sum && !n.fixed && !n.terms.empty() && n.terms.size() < 8 &&
         differences_.contains(key_without_factor(n.constant, n.terms));
}

// ---- from the algebra ----

NodeId Graph::of_factors(const std::vector<MFactor>& factors) {
  NodeId all = constant(Rational(1));
  for (const MFactor& f : factors)
    all = product(power(of(f.base), f.exponent), all);
  return all;
}

// The variable to put outside of the brackets: a number if there is one, else the most frequent.
std::size_t Graph::outermost(const MPoly& f) const {
  std::map<std::size_t, long> terms;
  for (long i = 0; i < f.length(); ++i) {
    const auto e = f.exponents(i);
    for (std::size_t v = 0; v < e.size(); ++v)
      if (e[v] > 0) terms[v] += fixed_.contains(v) ? 1'000'000 : 1;
  }
  const auto most = std::ranges::max_element(
      terms, [](const auto& a, const auto& b) { return a.second < b.second; });
  return most->first;
}

// linear terms + x (what x divides) + the rest
NodeId Graph::of_terms(const MPoly& f) {
  Node::Terms terms;
  Rational constant;
  MPoly rest(f.ring());
  for (long i = 0; i < f.length(); ++i) {
    const long degree = total_degree(f.exponents(i));
    const MPoly term = term_of(f, i);
    if (degree == 0)
      constant = Rational(f.coefficient(i));
    else if (degree == 1)
      terms.emplace_back(Rational(f.coefficient(i)), variable(used_variables(term).front()));
    else
      rest += term;
  }
  if (!kov::is_zero(rest)) {
    const std::size_t x = outermost(rest);
    MPoly inside(f.ring()), outside(f.ring());
    for (long i = 0; i < rest.length(); ++i)
      (rest.exponents(i)[x] > 0 ? inside : outside) += term_of(rest, i);
    if (kov::is_zero(outside)) {
      terms.emplace_back(Rational(1),
                         product(variable(x), of(exact_div(inside, MPoly::variable(f.ring(), x)))));
    } else {
      terms.emplace_back(Rational(1), of(inside));
      terms.emplace_back(Rational(1), of(outside));
    }
  }
  return sum(terms, constant);
}

NodeId Graph::of_primitive(const MPoly& f) {
  if (f.length() <= factored_terms) {
    const auto [content, factors] = factor(f);
    long count = 0;
    for (const MFactor& x : factors)
      count += x.exponent;
    if (count > 1) return scaled(Rational(content), of_factors(factors));
    if (const auto squares = squares_of(f, fixed_);
        squares && !kov::is_constant(squares->back().form))
      return of_squares(*squares);
  }
  return of_terms(f);
}

NodeId Graph::of(const MPoly& f) {
  if (kov::is_zero(f)) return constant(Rational());
  if (kov::is_constant(f)) return constant(Rational(f.coefficient(0)));
  const Integer content = content_of(f);
  const MPoly primitive = exact_div(f, MPoly(f.ring(), content));
  const std::string key = to_string(primitive);
  const auto known = polynomials_.find(key);
  const NodeId n = known != polynomials_.end() ? known->second : of_primitive(primitive);
  polynomials_[key] = n;
  return scaled(Rational(content), n);
}

NodeId Graph::of(const MFraction& f) {
  if (kov::is_zero(f)) return constant(Rational());
  if (!fractions_.empty()) {
    const auto [factor, key] = without_content(f);
    if (const auto known = fractions_.find(key); known != fractions_.end())
      return scaled(factor, known->second);
  }
  return multiplied_out(f);
}

NodeId Graph::multiplied_out(const MFraction& f) { return quotient(of(f.num()), of(f.den())); }

void Graph::know(const MFraction& f, NodeId n) {
  if (kov::is_zero(f) || kov::is_constant(f)) return;
  const auto [factor, key] = without_content(f);
  fractions_.try_emplace(key, scaled(Rational(1) / factor, n));
}

// ---- derivatives ----

Graph::Gradient Graph::gradient(NodeId root, const std::function<bool(NodeId)>& stops) {
  std::map<NodeId, Node::Terms> parts; // of the derivative of root by the node
  parts[root] = {{Rational(1), constant(Rational(1))}};
  Gradient result;
  const auto add = [&](NodeId n, const Rational& c, NodeId d) {
    if (!node(n).fixed) parts[n].emplace_back(c, d);
  };
  for (NodeId n = root + 1; n-- > 0;) {
    const auto mine = parts.find(n);
    if (mine == parts.end()) continue;
    const NodeId d = sum(mine->second);
    const Node x = node(n);
    if (x.kind != Node::Kind::variable && stops && stops(n)) {
      result.at[n] = d;
      continue;
    }
    switch (x.kind) {
    case Node::Kind::variable:
      result.by[x.variable] = d;
      break;
    case Node::Kind::sum:
      for (const auto& [c, part] : x.terms)
        add(part, c, d);
      break;
    case Node::Kind::product:
      if (!node(x.a).fixed) add(x.a, Rational(1), product(d, x.b));
      if (!node(x.b).fixed) add(x.b, Rational(1), product(d, x.a));
      break;
    case Node::Kind::square:
      add(x.a, Rational(2), product(d, x.a));
      break;
    case Node::Kind::quotient: {
      const NodeId by_a = quotient(d, x.b);
      add(x.a, Rational(1), by_a);
      if (!node(x.b).fixed) add(x.b, Rational(-1), product(by_a, n));
      break;
    }
    case Node::Kind::power:
      add(x.b, Rational(x.exponent), product(d, quotient(n, x.b)));
    }
  }
  return result;
}

NodeId Graph::tangent(NodeId n, const std::map<std::size_t, NodeId>& v, Tangents& known) {
  if (const auto done = known.find(n); done != known.end()) return done->second;
  const Node x = node(n);
  const auto of_part = [&](NodeId part) { return tangent(part, v, known); };
  NodeId d = constant(Rational());
  if (x.fixed) return d;
  switch (x.kind) {
  case Node::Kind::variable:
    if (const auto direction = v.find(x.variable); direction != v.end()) d = direction->second;
    break;
  case Node::Kind::sum: {
    Node::Terms terms;
    for (const auto& [c, part] : x.terms)
      terms.emplace_back(c, of_part(part));
    d = sum(terms);
    break;
  }
  case Node::Kind::product:
    d = sum({{Rational(1), product(of_part(x.a), x.b)}, {Rational(1), product(x.a, of_part(x.b))}});
    break;
  case Node::Kind::square:
    d = scaled(Rational(2), product(x.a, of_part(x.a)));
    break;
  case Node::Kind::quotient:
    d = quotient(sum({{Rational(1), of_part(x.a)}, {Rational(-1), product(n, of_part(x.b))}}), x.b);
    break;
  case Node::Kind::power:
    d = scaled(Rational(x.exponent), product(n, quotient(of_part(x.b), x.b)));
  }
  return known[n] = d;
}

double products(const Graph& g, const std::vector<NodeId>& roots) {
  std::vector<NodeId> open = roots;
  std::set<NodeId> seen;
  double cost = 0;
  const auto serial = [&](NodeId n) { return !g.node(n).fixed; };
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    if (!serial(id) || !seen.insert(id).second) continue;
    const Node& n = g.node(id);
    if (n.kind == Node::Kind::sum) {
      cost += 0.02 * static_cast<double>(n.terms.size());
      for (const auto& [c, part] : n.terms)
        open.push_back(part);
    } else if (n.kind == Node::Kind::variable) {
      if (const Graph::Rule* rule = g.rule_of(n.variable)) {
        open.push_back(rule->of);
        cost += rule->kind == Graph::Rule::Kind::root ? 0.5 : 0.02;
      }
    } else {
      open.push_back(n.a);
      open.push_back(n.b);
      if (n.kind == Node::Kind::power) {
        cost += 1.5;
        continue;
      }
      const bool numbers = n.kind != Node::Kind::quotient && !(serial(n.a) && serial(n.b));
      cost += numbers ? 0.02 : n.kind == Node::Kind::square ? 0.5 : 1.0;
    }
  }
  return cost;
}

// ---- the motion ----

namespace {

constexpr long too_long =
    40; // terms of an H that nobody should multiply out if its formula is there

/// From X, or by a sweep from H to the variables, or to nodes of functions alone.
enum class Way : std::uint8_t { sweep, components, short_sweep };

class MotionBuilder {
public:
  MotionBuilder(const System& s, Graph graph) : s_(s), v_(s.field), graph_(std::move(graph)) {
    for (const FunctionSymbol& f : v_.functions)
      functions_[f.variable] = &f;
  }

  Motion build(Way way, const std::vector<MFraction>& used) {
    std::vector<NodeId> x =
        way == Way::components ? by_components() : by_hamiltonian(way == Way::short_sweep);
    Motion m{graph_, v_.dimension(), v_.coordinates, {}};
    m.derivatives = x;
    std::vector<NodeId> roots = x;
    for (const MFraction& f : functions_.empty() ? std::vector<MFraction>{} : used)
      roots.push_back(graph_.of(f));
    add_functions(m, std::move(roots));
    m.graph = std::move(graph_);
    return m;
  }

private:
  std::vector<NodeId> by_components() {
    return mapped<NodeId>(v_.components, [&](const MFraction& f) { return graph_.of(f); });
  }

  // X_i = sum_j {x_i, x_j} d_j H
  std::vector<NodeId> by_hamiltonian(bool is_short) {
    std::map<NodeId, std::vector<NodeId>> inner; // the derivatives of nodes by the coordinates
    const auto stops = [&](NodeId n) { return derivatives_are_there(n, inner); };
    const NodeId h = graph_.of(*v_.hamiltonian);
    const auto [by, at] = is_short ? graph_.gradient(h, stops) : graph_.gradient(h);
    const auto partial_by = [&](std::size_t variable) {
      const auto d = by.find(variable);
      return d == by.end() ? graph_.constant(Rational()) : d->second;
    };
    const NodeId one = graph_.constant(Rational(1));
    std::vector<std::vector<Graph::Product>> terms(v_.dimension());
    for (std::size_t j = 0; j < v_.dimension(); ++j)
      terms[j].push_back({Rational(1), partial_by(v_.coordinates[j]), one});
    for (const FunctionSymbol& f : v_.functions) {
      const NodeId outer = partial_by(f.variable);
      if (graph_.is_zero(outer)) continue;
      const Chain chain = chain_of(f);
      const NodeId factor = chain.slope ? graph_.times(outer, *chain.slope) : outer;
      for (std::size_t j = 0; j < v_.dimension(); ++j)
        if (!kov::is_zero(chain.inner[j]))
          terms[j].push_back({Rational(1), factor, graph_.of(chain.inner[j])});
    }
    for (const auto& [node, outer] : at)
      for (std::size_t j = 0; j < v_.dimension(); ++j)
        terms[j].push_back({Rational(1), outer, inner.at(node)[j]});
    std::vector<NodeId> d, x;
    for (auto& of_one : terms)
      d.push_back(graph_.sum_of_products(std::move(of_one)));
    for (std::size_t i = 0; i < v_.dimension(); ++i)
      x.push_back(combination((*v_.poisson)[i], d));
    return x;
  }

  // A node of functions alone (no coordinate) whose derivatives need no more products than there are.
  bool derivatives_are_there(NodeId n, std::map<NodeId, std::vector<NodeId>>& inner) {
    std::vector<NodeId> open{n};
    std::set<std::size_t> used;
    for (std::set<NodeId> seen; !open.empty();) {
      const NodeId id = open.back();
      open.pop_back();
      if (graph_.node(id).fixed || !seen.insert(id).second) continue;
      const Node& x = graph_.node(id);
      if (x.kind == Node::Kind::variable && !functions_.contains(x.variable)) return false;
      if (x.kind == Node::Kind::variable) used.insert(x.variable);
      for (const NodeId part : graph_.parts(id))
        open.push_back(part);
    }
    std::vector<NodeId> all;
    const std::size_t before = graph_.size();
    for (std::size_t j = 0; j < v_.dimension(); ++j) {
      std::map<std::size_t, NodeId> rates;
      for (const std::size_t f : used)
        rates[f] = graph_.of(functions_.at(f)->gradient[j]);
      Graph::Tangents known;
      all.push_back(graph_.tangent(n, rates, known));
    }
    for (std::size_t id = before; id < graph_.size(); ++id)
      if (graph_.node(static_cast<NodeId>(id)).kind != Node::Kind::sum) return false;
    inner[n] = std::move(all);
    return true;
  }

  // The gradient of a function symbol: a slope times the gradient of its argument, where that is what it is.
  struct Chain {
    std::optional<MFraction> slope;
    std::vector<MFraction> inner;
  };
  [[nodiscard]] Chain chain_of(const FunctionSymbol& f) const {
    const Chain plain{std::nullopt, f.gradient};
    if (f.function.empty() || kov::is_zero(f.argument)) return plain;
    Chain chain{std::nullopt, kov::gradient(v_, f.argument)};
    for (std::size_t j = 0; j < v_.dimension(); ++j) {
      if (kov::is_zero(chain.inner[j]) != kov::is_zero(f.gradient[j])) return plain;
      if (kov::is_zero(chain.inner[j])) continue;
      const MFraction slope = f.gradient[j] / chain.inner[j];
      if (chain.slope && !(*chain.slope == slope)) return plain;
      chain.slope = slope;
    }
    return chain.slope ? chain : plain;
  }

  // s = sqrt(u): the slope is 1/(2 s), which is s/(2 u)
  [[nodiscard]] static bool is_root(const FunctionSymbol& f, const Chain& chain, const Ring& ring) {
    if (f.function != "sqrt" || !chain.slope) return false;
    const MFraction s = MFraction::variable(ring, f.variable), twice = Rational(2) * *chain.slope;
    return kov::is_one(twice * s) || twice * f.argument == s;
  }

  // sum_j f_j n_j
  NodeId combination(const std::vector<MFraction>& f, const std::vector<NodeId>& n) {
    std::vector<Graph::Product> terms;
    for (std::size_t j = 0; j < n.size(); ++j)
      if (!kov::is_zero(f[j])) terms.push_back({Rational(1), graph_.of(f[j]), n[j]});
    return graph_.sum_of_products(std::move(terms));
  }

  // The functions that the roots use, those that their derivatives use, and so on.
  void add_functions(Motion& m, std::vector<NodeId> open) {
    std::set<NodeId> seen;
    while (!open.empty()) {
      const NodeId id = open.back();
      open.pop_back();
      if (!seen.insert(id).second) continue;
      const Node n = graph_.node(id);
      if (n.kind == Node::Kind::sum)
        for (const auto& [c, part] : n.terms)
          open.push_back(part);
      else if (n.kind != Node::Kind::variable)
        open.insert(open.end(), {n.a, n.b});
      else if (const auto f = functions_.find(n.variable); f != functions_.end()) {
        const std::vector<NodeId> x(m.derivatives.begin(),
                                    m.derivatives.begin() + static_cast<long>(m.coordinates));
        m.variables.push_back(n.variable);
        const Chain chain = chain_of(*f->second);
        const NodeId inner = combination(chain.inner, x);
        m.derivatives.push_back(chain.slope ? graph_.times(inner, *chain.slope) : inner);
        if (is_root(*f->second, chain, v_.ring)) {
          graph_.follow(n.variable,
                        {Graph::Rule::Kind::root, graph_.argument_of_root(f->second->argument)});
          open.push_back(graph_.rule_of(n.variable)->of);
        }
        open.push_back(m.derivatives.back());
        for (const MFraction& d : f->second->gradient)
          open.push_back(graph_.of(d));
      }
    }
  }

  const System& s_;
  const VectorField& v_;
  Graph graph_;
  std::map<std::size_t, const FunctionSymbol*> functions_;
};

} // namespace

Motion motion_of(const System& s, const std::vector<MFraction>& used, const Graph* written) {
  const VectorField& v = s.field;
  std::set<std::size_t> fixed(v.parameters.begin(), v.parameters.end());
  fixed.insert(v.constants.begin(), v.constants.end());
  std::optional<Motion> best;
  const auto cost = [](const Motion& m) { return products(m.graph, m.series_roots()); };
  const auto terms = [](const MFraction& f) { return f.num().length() + f.den().length(); };
  const bool long_h = written != nullptr && v.hamiltonian && terms(*v.hamiltonian) > too_long;
  for (const bool as_written : {false, true})
    for (const Way way : {Way::sweep, Way::components, Way::short_sweep}) {
      const bool from_h = way != Way::components;
      if ((as_written && written == nullptr) || (from_h && !(v.hamiltonian && v.poisson))) continue;
      if (!as_written && long_h) continue;
      Motion m = MotionBuilder(s, as_written ? *written : Graph(fixed)).build(way, used);
      const double saving =
          as_written || way == Way::short_sweep ? 0.9 : 1; // else factors are kept
      if (!best || cost(m) < saving * cost(*best)) best = std::move(m);
    }
  return *std::move(best);
}

void use_powers(Motion& m) {
  Motion other = m;
  other.derivatives = other.graph.with_powers(m.derivatives);
  const auto cost = [](const Motion& one) { return products(one.graph, one.series_roots()); };
  if (cost(other) < 0.9 * cost(m)) m = std::move(other);
}

void add_tangent(Motion& m, std::size_t ring_size) {
  std::map<std::size_t, NodeId> v;
  for (std::size_t i = 0; i < m.variables.size(); ++i) {
    m.tangent.push_back(ring_size + i);
    v[m.variables[i]] = m.graph.variable(ring_size + i);
  }
  Graph::Tangents known;
  for (std::size_t i = 0; i < m.variables.size(); ++i) {
    m.deviations.push_back(m.graph.tangent(m.derivatives[i], v, known));
    const Graph::Rule* rule = m.graph.rule_of(m.variables[i]);
    if (rule == nullptr || rule->kind != Graph::Rule::Kind::root) continue;
    const NodeId of_argument = m.graph.tangent(rule->of, v, known);
    const NodeId twice = m.graph.sum({{Rational(2), m.graph.variable(m.variables[i])}});
    m.graph.follow(m.tangent[i], {Graph::Rule::Kind::copy, m.graph.quotient(of_argument, twice)});
  }
}

std::vector<NodeId> Motion::series_roots() const {
  std::vector<NodeId> roots, followers;
  Graph g = graph; // has these variables already
  const auto add = [&](std::size_t variable, NodeId derivative) {
    if (graph.rule_of(variable) == nullptr)
      roots.push_back(derivative);
    else
      followers.push_back(g.variable(variable));
  };
  for (std::size_t i = 0; i < variables.size(); ++i)
    add(variables[i], derivatives[i]);
  for (std::size_t i = 0; i < tangent.size(); ++i)
    add(tangent[i], deviations[i]);
  roots.insert(roots.end(), followers.begin(), followers.end());
  return roots;
}

} // namespace kov::flow
