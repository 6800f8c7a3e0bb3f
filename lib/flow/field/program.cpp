#include "flow/field/program.hpp"

#include "exact/error.hpp"

#include <algorithm>

namespace kov::flow {

Registers::Registers(std::vector<std::size_t> inputs) : inputs_(std::move(inputs)) {
  for (const std::size_t variable : inputs_)
    input_of_[variable] = count_++;
}

std::uint32_t Registers::input(std::size_t variable) const {
  const auto found = input_of_.find(variable);
  if (found == input_of_.end()) throw InvalidArgument("a variable of the field has no value");
  return found->second;
}

class Compiler {
public:
  Compiler(const Graph& g, Registers& r, bool series) : g_(g), r_(r), series_(series) {}

  Program compile(const std::vector<NodeId>& roots, bool again) {
    collect(roots, again);
    for (const NodeId id : order_)
      if (g_.node(id).fixed) emit(program_.once, id);
    std::map<int, std::vector<NodeId>> levels;
    for (const NodeId id : order_)
      if (!g_.node(id).fixed) levels[level(id)].push_back(id);
    for (const auto& [height, nodes] : levels)
      emit_level(nodes);
    for (const NodeId root : roots)
      program_.outputs.push_back(r_.of_.at(root));
    return std::move(program_);
  }

private:
  // New nodes (again: all nodes) in an order in which the parts of each come before it: their ids rise.
  void collect(std::vector<NodeId> open, bool again) {
    std::set<NodeId> found;
    while (!open.empty()) {
      const NodeId id = open.back();
      open.pop_back();
      if ((!again && r_.of_.contains(id)) || !found.insert(id).second) continue;
      const std::vector<NodeId> parts = parts_of(id);
      open.insert(open.end(), parts.begin(), parts.end());
    }
    for (const NodeId id : found) {
      const Node& n = g_.node(id);
      if (n.kind == Node::Kind::variable) {
        r_.of_[id] = r_.input(n.variable);
        if (rule_of(n) != nullptr) order_.push_back(id);
      } else {
        if (!r_.of_.contains(id)) r_.of_[id] = r_.count_++;
        order_.push_back(id);
      }
    }
  }

  [[nodiscard]] std::vector<NodeId> parts_of(NodeId id) const {
    const Node& n = g_.node(id);
    if (n.kind == Node::Kind::variable) {
      const Graph::Rule* rule = rule_of(n);
      return rule == nullptr ? std::vector<NodeId>{} : std::vector{rule->of};
    }
    return g_.parts(id);
  }

  [[nodiscard]] const Graph::Rule* rule_of(const Node& n) const {
    return series_ && n.kind == Node::Kind::variable ? g_.rule_of(n.variable) : nullptr;
  }

  // 0 for what is there already.
  int level(NodeId id) {
    const Node& n = g_.node(id);
    if (n.fixed || (n.kind == Node::Kind::variable && rule_of(n) == nullptr)) return 0;
    if (!std::ranges::binary_search(order_, id)) return 0;
    if (const auto known = levels_.find(id); known != levels_.end()) return known->second;
    int most = 0;
    for (const NodeId part : parts_of(id))
      most = std::max(most, level(part));
    return levels_[id] = most + 1;
  }

  [[nodiscard]] bool is_scaling(const Node& n) const {
    return n.kind == Node::Kind::product && g_.node(n.a).fixed != g_.node(n.b).fixed;
  }

  // Nodes that are alike stand together: the processor works on all of them at once
  // (machine_code.hpp).
  void emit_level(const std::vector<NodeId>& nodes) {
    std::vector<Factors> products, squares;
    for (const NodeId id : nodes) {
      const Node& n = g_.node(id);
      if (n.kind == Node::Kind::square)
        squares.push_back({n.a, n.a, id});
      else if (n.kind == Node::Kind::product && !is_scaling(n))
        products.push_back({n.a, n.b, id});
    }
    share(products);
    emit_groups(Instruction::Op::products, products);
    emit_groups(Instruction::Op::squares, squares);
    for (const NodeId id : nodes)
      if (g_.node(id).kind == Node::Kind::sum || is_scaling(g_.node(id))) emit(program_.each, id);
    for (const NodeId id : nodes)
      if (g_.node(id).kind == Node::Kind::quotient) emit(program_.each, id);
    for (const NodeId id : nodes)
      if (g_.node(id).kind == Node::Kind::power) emit_power(id);
    for (const NodeId id : nodes)
      if (g_.node(id).kind == Node::Kind::variable) emit_rule(id);
  }

  struct Factors {
    NodeId a, b, product;
  };

  // The factor that more of these products have is the first one, and those that share it stand together: its
  // coefficients are read once for all of them.
  static void share(std::vector<Factors>& products) {
    std::map<NodeId, int> uses;
    for (const Factors& f : products) {
      ++uses[f.a];
      ++uses[f.b];
    }
    for (Factors& f : products)
      if (uses[f.b] > uses[f.a]) std::swap(f.a, f.b);
    std::ranges::stable_sort(products, [&](const Factors& x, const Factors& y) {
      return uses[x.a] != uses[y.a] ? uses[x.a] > uses[y.a] : x.a < y.a;
    });
  }

  void emit_groups(Instruction::Op op, const std::vector<Factors>& nodes) {
    for (std::size_t first = 0; first < nodes.size(); first += group) {
      Instruction i;
      i.op = op;
      i.count = static_cast<std::uint8_t>(std::min(group, nodes.size() - first));
      for (std::size_t k = 0; k < i.count; ++k) {
        i.out[k] = r_.of_.at(nodes[first + k].product);
        i.a[k] = r_.of_.at(nodes[first + k].a);
        i.b[k] = r_.of_.at(nodes[first + k].b);
      }
      program_.each.push_back(i);
    }
  }

  void emit_rule(NodeId id) {
    const Graph::Rule* rule = rule_of(g_.node(id));
    Instruction i;
    i.op = rule->kind == Graph::Rule::Kind::root ? Instruction::Op::root : Instruction::Op::copy;
    i.out[0] = r_.of_.at(id);
    i.a[0] = r_.of_.at(rule->of);
    if (i.op == Instruction::Op::root) i.out[1] = inverse(i.out[0]);
    program_.each.push_back(i);
  }

  void emit_power(NodeId id) {
    const Node& n = g_.node(id);
    Instruction i;
    i.op = Instruction::Op::power;
    i.exponent = static_cast<int>(n.exponent);
    i.out[0] = r_.of_.at(id);
    i.out[1] = inverse(i.out[0]);
    i.out[2] = weighted(i.out[0]);
    i.a[0] = r_.of_.at(n.a);
    i.b[0] = r_.of_.at(n.b);
    const Rational half = Rational(n.exponent) / Rational(2);
    i.a[1] = number(half);
    i.a[2] = number(half + Rational(1));
    program_.each.push_back(i);
  }

  // The register of k p_k.
  std::uint32_t weighted(std::uint32_t reg) {
    const auto [place, fresh] = r_.weighted_of_.try_emplace(reg, r_.count_);
    if (fresh) ++r_.count_;
    return place->second;
  }

  // x - 1/3, of which 3 x - 1 is a multiple, is as exact as x is known where x is nearly 1/3.
  void add_low_parts(Instruction& i, const Node& n) {
    const auto first =
        std::ranges::find_if(n.terms, [this](const auto& t) { return !g_.node(t.second).fixed; });
    const Rational factor = first->first;
    for (const auto& [c, part] : n.terms)
      program_.terms.push_back({r_.of_.at(part), number(c / factor)});
    i.b[2] = static_cast<std::uint32_t>(program_.terms.size());
    for (const auto& [c, part] : n.terms)
      if (!g_.node(part).fixed) program_.terms.push_back({low(part), number(c / factor)});
    i.b[1] = static_cast<std::uint32_t>(program_.terms.size());
    if (i.a[1] != Instruction::none) i.a[1] = number(n.constant / factor);
    i.a[2] = number(factor);
  }
  std::uint32_t low(NodeId variable) {
    const auto [place, fresh] = r_.low_of_.try_emplace(r_.of_.at(variable), r_.count_);
    if (fresh) ++r_.count_;
    return place->second;
  }

  // The register that keeps the inverse for this one.
  std::uint32_t inverse(std::uint32_t reg) {
    const auto [place, fresh] = r_.inverse_of_.try_emplace(reg, r_.count_);
    if (fresh) ++r_.count_;
    return place->second;
  }

  std::uint32_t number(const Rational& c) {
    const auto [place, fresh] =
        numbers_.try_emplace(c, static_cast<std::uint32_t>(program_.numbers.size()));
    if (fresh) program_.numbers.push_back(c);
    return place->second;
  }

  void emit(std::vector<Instruction>& code, NodeId id) {
    const Node& n = g_.node(id);
    Instruction i;
    i.out[0] = r_.of_.at(id);
    if (n.kind == Node::Kind::sum) {
      i.op = Instruction::Op::sum;
      i.a[0] = static_cast<std::uint32_t>(program_.terms.size());
      for (const auto& [c, part] : n.terms)
        program_.terms.push_back({r_.of_.at(part), number(c)});
      i.b[0] = static_cast<std::uint32_t>(program_.terms.size());
      i.a[1] = n.constant == Rational() ? Instruction::none : number(n.constant);
      if (series_ && g_.is_difference(id)) add_low_parts(i, n);
    } else {
      const bool turn = is_scaling(n) && g_.node(n.b).fixed;
      i.op = n.kind == Node::Kind::quotient ? Instruction::Op::quotient
             : is_scaling(n)                ? Instruction::Op::scaled
             : n.kind == Node::Kind::square ? Instruction::Op::squares
                                            : Instruction::Op::products;
      i.a[0] = r_.of_.at(turn ? n.b : n.a);
      i.b[0] = r_.of_.at(turn ? n.a : n.b);
      if (n.kind == Node::Kind::quotient) i.out[1] = inverse(i.out[0]);
    }
    code.push_back(i);
  }

  const Graph& g_;
  Registers& r_;
  bool series_;
  Program program_;
  std::vector<NodeId> order_; ///< the new nodes, rising
  std::map<NodeId, int> levels_;
  std::map<Rational, std::uint32_t> numbers_;
};

Program compile(const Graph& g, const std::vector<NodeId>& roots, Registers& registers,
                bool series) {
  return Compiler(g, registers, series).compile(roots, false);
}
Program compile_again(const Graph& g, const std::vector<NodeId>& roots, Registers& registers) {
  return Compiler(g, registers, true).compile(roots, true);
}

} // namespace kov::flow
