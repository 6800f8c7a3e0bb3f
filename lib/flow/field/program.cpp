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
  Compiler(const Graph& g, Registers& r) : g_(g), r_(r) {}

  Program compile(const std::vector<NodeId>& roots) {
    collect(roots);
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
  // New nodes in an order in which the parts of each come before it: their ids rise.
  void collect(std::vector<NodeId> open) {
    std::set<NodeId> found;
    while (!open.empty()) {
      const NodeId id = open.back();
      open.pop_back();
      if (r_.of_.contains(id) || !found.insert(id).second) continue;
      const std::vector<NodeId> parts = parts_of(id);
      open.insert(open.end(), parts.begin(), parts.end());
    }
    for (const NodeId id : found) {
      const Node& n = g_.node(id);
      if (n.kind == Node::Kind::variable) {
        r_.of_[id] = r_.input(n.variable);
      } else {
        r_.of_[id] = r_.count_++;
        order_.push_back(id);
      }
    }
  }

  [[nodiscard]] std::vector<NodeId> parts_of(NodeId id) const {
    const Node& n = g_.node(id);
    if (n.kind == Node::Kind::variable) return {};
    if (n.kind == Node::Kind::square) return {n.a};
    if (n.kind != Node::Kind::sum) return {n.a, n.b};
    std::vector<NodeId> parts;
    for (const auto& [c, part] : n.terms)
      parts.push_back(part);
    return parts;
  }

  // 0 for what is there already.
  int level(NodeId id) {
    if (g_.node(id).fixed || g_.node(id).kind == Node::Kind::variable) return 0;
    if (!std::binary_search(order_.begin(), order_.end(), id)) return 0;
    if (const auto known = levels_.find(id); known != levels_.end()) return known->second;
    int most = 0;
    for (const NodeId part : parts_of(id))
      most = std::max(most, level(part));
    return levels_[id] = most + 1;
  }

  [[nodiscard]] bool is_scaling(const Node& n) const {
    return n.kind == Node::Kind::product && g_.node(n.a).fixed != g_.node(n.b).fixed;
  }

  void emit_level(const std::vector<NodeId>& nodes) {
    std::vector<NodeId> products, squares;
    for (const NodeId id : nodes) {
      const Node& n = g_.node(id);
      if (n.kind == Node::Kind::square)
        squares.push_back(id);
      else if (n.kind == Node::Kind::product && !is_scaling(n))
        products.push_back(id);
    }
    emit_groups(Instruction::Op::products, products);
    emit_groups(Instruction::Op::squares, squares);
    for (const NodeId id : nodes) {
      const Node& n = g_.node(id);
      if (n.kind == Node::Kind::sum || n.kind == Node::Kind::quotient || is_scaling(n))
        emit(program_.each, id);
    }
  }

  void emit_groups(Instruction::Op op, const std::vector<NodeId>& nodes) {
    for (std::size_t first = 0; first < nodes.size(); first += group) {
      Instruction i;
      i.op = op;
      i.count = static_cast<std::uint8_t>(std::min(group, nodes.size() - first));
      for (std::size_t k = 0; k < i.count; ++k) {
        const Node& n = g_.node(nodes[first + k]);
        i.out[k] = r_.of_.at(nodes[first + k]);
        i.a[k] = r_.of_.at(n.a);
        i.b[k] = r_.of_.at(n.b);
      }
      program_.each.push_back(i);
    }
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
    } else {
      const bool turn = is_scaling(n) && g_.node(n.b).fixed;
      i.op = n.kind == Node::Kind::quotient ? Instruction::Op::quotient
             : is_scaling(n)                ? Instruction::Op::scaled
             : n.kind == Node::Kind::square ? Instruction::Op::squares
                                            : Instruction::Op::products;
      i.a[0] = r_.of_.at(turn ? n.b : n.a);
      i.b[0] = r_.of_.at(turn ? n.a : n.b);
      if (n.kind == Node::Kind::quotient) i.out[1] = r_.count_++;
    }
    code.push_back(i);
  }

  const Graph& g_;
  Registers& r_;
  Program program_;
  std::vector<NodeId> order_; ///< the new nodes, rising
  std::map<NodeId, int> levels_;
  std::map<Rational, std::uint32_t> numbers_;
};

Program compile(const Graph& g, const std::vector<NodeId>& roots, Registers& registers) {
  return Compiler(g, registers).compile(roots);
}

} // namespace kov::flow
