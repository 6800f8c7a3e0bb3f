#include "theorem/theorem.hpp"

#include <algorithm>
#include <cctype>

namespace kov {
namespace {

void add_once(std::vector<std::string>& all, const std::string& one) {
  if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

std::string plural(std::size_t n, const std::string& one, const std::string& many = {}) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

} // namespace

std::size_t TheoremResult::count(NodeStatus s) const {
  return static_cast<std::size_t>(std::count_if(
      nodes.begin(), nodes.end(), [s](const NodeResult& n) { return n.status == s; }));
}

// A theorem that a step used by itself (Morales-Ramis) is listed unless the file has it as a node.
std::vector<std::string> TheoremResult::trusted_theorems() const {
  std::vector<std::string> all;
  const auto is_node = [&](std::string name) {
    for (char& c : name)
      c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::any_of(nodes.begin(), nodes.end(), [&](const NodeResult& n) {
      return n.status == NodeStatus::trusted && n.node.id == name;
    });
  };
  for (const NodeResult& n : nodes) {
    if (n.status == NodeStatus::trusted) add_once(all, n.node.title);
    for (const std::string& t : n.theorems)
      if (!is_node(t)) add_once(all, t);
  }
  return all;
}

std::vector<std::string> TheoremResult::trusted_steps() const {
  std::vector<std::string> all;
  for (const NodeResult& n : nodes)
    for (const std::string& t : n.trusted)
      add_once(all, n.node.title + ": " + t);
  return all;
}

std::vector<std::string> TheoremResult::unchecked_hypotheses() const {
  std::vector<std::string> all;
  for (const NodeResult& n : nodes)
    for (const Hypothesis& h : n.node.hypotheses)
      if (!h.checked) all.push_back(n.node.title + ": " + h.text);
  return all;
}

std::size_t TheoremResult::certificates() const {
  std::size_t sum = 0;
  for (const NodeResult& n : nodes)
    sum += n.certificates.size();
  return sum;
}

std::size_t TheoremResult::identities() const {
  std::size_t sum = 0;
  for (const NodeResult& n : nodes)
    sum += n.checks.size();
  return sum;
}

bool TheoremResult::complete() const {
  return count(NodeStatus::open) == 0 && count(NodeStatus::refuted) == 0;
}

std::string TheoremResult::time() const {
  const auto tenths = static_cast<long>(seconds * 10 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
}

std::string TheoremResult::conclusion() const {
  const std::size_t unchecked = unchecked_hypotheses().size();
  std::string text;
  const bool verdict_only = !nodes.empty() && nodes.front().node.expect == "any";
  if (verdict_only)
    text = complete() ? "DECIDED" : "NOT DECIDED";
  else if (count(NodeStatus::refuted) > 0)
    text =
        "NOT PROVED: " + plural(count(NodeStatus::refuted), "step was", "steps were") + " refuted";
  else if (count(NodeStatus::open) > 0)
    text = "NOT YET PROVED: " + plural(count(NodeStatus::open), "step is", "steps are") + " open";
  else
    text = count(NodeStatus::proved) == 0 ? "NOTHING IS PROVED HERE"
           : unchecked > 0                ? "PROVED, but for hypotheses that are not checked"
                                          : "PROVED";
  text += "; " + plural(count(NodeStatus::proved), "step") + " proved here, " +
          plural(trusted_theorems().size(), "theorem") + " of the literature trusted, " +
          (trusted_steps().empty() ? ""
                                   : plural(trusted_steps().size(), "other step") + " on trust, ") +
          plural(count(NodeStatus::reasoned), "argument") + " in words";
  if (unchecked > 0) text += ", " + plural(unchecked, "hypothesis", "hypotheses") + " not checked";
  return text;
}

} // namespace kov
