#include "exact/lists.hpp"
#include "theorem/theorem.hpp"

#include "symbol/suggest.hpp"
#include "theorem/prove.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace kov {
namespace {

std::string plural(std::size_t n, const std::string& one, const std::string& many = {}) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

// A hypothesis that one of two uses leaves open is open.
void leave_open(TheoremUsed& all, const TheoremUsed& here) {
  for (const TheoremHypothesis& h : here.hypotheses) {
    if (h.settled != Settled::open) continue;
    const auto same = std::ranges::find_if(
        all.hypotheses, [&](const TheoremHypothesis& x) { return x.text == h.text; });
    if (same == all.hypotheses.end())
      all.hypotheses.push_back(h);
    else
      *same = h;
  }
}

bool asks_for_a_verdict(const NodeResult& n) {
  return n.node.kind == NodeKind::case_file && n.node.expect != "non-integrable";
}

// The verdict, and for which values of the parameters; a neutral word if there are several.
std::string decided(const std::vector<NodeResult>& nodes) {
  const NodeResult& first = nodes.front();
  const std::string one = first.headline.empty() ? "DECIDED" : first.headline;
  const auto asked = std::ranges::count_if(nodes, asks_for_a_verdict);
  const bool all_alike = std::ranges::all_of(nodes, [&](const NodeResult& n) {
    return !asks_for_a_verdict(n) || n.headline == first.headline;
  });
  if (!all_alike) return "DECIDED: the verdicts differ with the parameters";
  if (asked > 1) return one + ", for each of " + std::to_string(asked) + " sets of values";
  std::string values;
  for (const auto& [name, value] : first.node.where)
    values += (values.empty() ? ", at " : ", ") + name + " = " + value;
  return one + values;
}

template <class Number> std::size_t sum(const std::vector<NodeResult>& nodes, Number of) {
  std::size_t all = 0;
  for (const NodeResult& n : nodes)
    all += static_cast<std::size_t>(of(n));
  return all;
}

// Two nodes may have one title.
std::vector<std::string> steps_on_trust(const NodeResult& n) {
  std::vector<std::string> own;
  for (const Trusted& t : n.trusted)
    add_once(own, t.step == Trusted::Step::by_author && !t.of.empty()
                      ? sentence(t)
                      : n.node.title + ": " + sentence(t));
  return own;
}

bool is_ours(NodeStatus s) { return s == NodeStatus::proved || s == NodeStatus::partial; }
bool is_open(NodeStatus s) {
  return s == NodeStatus::open || s == NodeStatus::refuted || s == NodeStatus::unbound;
}

} // namespace

std::string status_of(const NodeResult& n) {
  return to_string(n.status) + (is_ours(n.status) && n.steps_on_trust > 0
                                    ? ", with " + plural(n.steps_on_trust, "step") + " on trust"
                                    : "");
}

void settle_statuses(TheoremResult& result) {
  std::vector<NodeResult>& all = result.nodes;
  std::map<std::string, std::size_t> at;
  std::vector<std::size_t> own;
  for (const NodeResult& n : all) {
    at[n.node.id] = own.size();
    own.push_back(steps_on_trust(n).size());
  }
  for (NodeResult& n : all) {
    std::vector<std::size_t> below{at.at(n.node.id)};
    std::vector<char> seen(all.size());
    n.steps_on_trust = 0;
    n.rests_on_open = false;
    for (std::size_t k = 0; k < below.size(); ++k) {
      const NodeResult& one = all[below[k]];
      if (std::exchange(seen[below[k]], 1)) continue;
      n.steps_on_trust += own[below[k]];
      n.rests_on_open |= k > 0 && is_open(one.status);
      for (const std::string& id : one.node.needs)
        below.push_back(at.at(id));
    }
    if (is_ours(n.status)) n.status = n.rests_on_open ? NodeStatus::partial : NodeStatus::proved;
  }
}

std::size_t TheoremResult::count(NodeStatus s) const {
  return sum(nodes, [s](const NodeResult& n) { return n.status == s ? 1 : 0; });
}

std::vector<TheoremUsed> each_once(const std::vector<TheoremUsed>& uses) {
  std::vector<TheoremUsed> all;
  for (const TheoremUsed& here : uses) {
    const auto known =
        std::ranges::find_if(all, [&](const TheoremUsed& u) { return u.theorem == here.theorem; });
    if (known == all.end())
      all.push_back(here);
    else
      leave_open(*known, here);
  }
  return all;
}

std::vector<TheoremUsed> TheoremResult::uses() const {
  std::vector<TheoremUsed> all;
  for (const NodeResult& n : nodes)
    all.insert(all.end(), n.theorems.begin(), n.theorems.end());
  return each_once(all);
}

std::vector<std::string> TheoremResult::trusted_steps() const {
  std::vector<std::string> all;
  for (const NodeResult& n : nodes)
    for (std::string& step : steps_on_trust(n))
      all.push_back(std::move(step));
  return all;
}

std::size_t TheoremResult::words_of_the_file() const {
  return sum(nodes, [&](const NodeResult& n) {
    return !found && (n.on_trust || n.node.integrable) ? steps_on_trust(n).size() : 0;
  });
}

std::vector<std::string> TheoremResult::unchecked_hypotheses() const {
  std::vector<std::string> all;
  for (const NodeResult& n : nodes)
    for (const Hypothesis& h : n.node.hypotheses)
      if (!h.checked) all.push_back(n.node.title + ": " + h.text);
  for (const TheoremUsed& u : uses())
    for (const TheoremHypothesis& h : u.hypotheses)
      if (h.settled == Settled::open) all.push_back(u.theorem->name + ": " + h.text);
  return all;
}

std::size_t TheoremResult::certificates() const {
  return sum(nodes, [](const NodeResult& n) { return n.certificates.size(); });
}

std::size_t TheoremResult::identities() const {
  return sum(nodes, [](const NodeResult& n) { return n.checks.size(); });
}

bool TheoremResult::complete() const {
  return complete_but_for_words() && words_of_the_file() == 0;
}

bool TheoremResult::complete_but_for_words() const {
  return complete_but_for_open_parts() && count(NodeStatus::open) == 0;
}

bool TheoremResult::complete_but_for_open_parts() const {
  const std::size_t parts = sum(nodes, [](const NodeResult& n) {
    return n.node.kind == NodeKind::open_part && n.status == NodeStatus::open ? 1 : 0;
  });
  return !nodes.empty() && is_ours(nodes.front().status) && count(NodeStatus::open) == parts &&
         count(NodeStatus::refuted) == 0 && count(NodeStatus::unbound) == 0 &&
         count(NodeStatus::reasoned) == 0;
}

std::string TheoremResult::time() const {
  const auto tenths = static_cast<long>(seconds * 10 + 0.5);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " s";
}

// The givens of the proof: everything that is not computed here.
std::string TheoremResult::given() const {
  const std::size_t unchecked = unchecked_hypotheses().size();
  std::vector<std::string> all;
  if (const auto n = uses().size(); n > 0)
    all.push_back(plural(n, "theorem") + " of the literature");
  if (const auto n = trusted_steps().size() - words_of_the_file(); n > 0)
    all.push_back(plural(n, "other step") + " on trust");
  if (unchecked > 0) all.push_back(plural(unchecked, "hypothesis", "hypotheses") + " NOT CHECKED");
  return enumerate(all);
}

std::string TheoremResult::verdict() const {
  const bool is_verdict = !nodes.empty() && asks_for_a_verdict(nodes.front());
  if (const auto n = count(NodeStatus::refuted); n > 0)
    return "NOT PROVED: " + plural(n, "step was", "steps were") + " refuted";
  std::vector<std::string> missing;
  if (const auto n = count(NodeStatus::open); n > 0)
    missing.push_back(plural(n, "step is", "steps are") + " open");
  if (const auto n = count(NodeStatus::unbound); n > 0)
    missing.push_back(plural(n, "step is", "steps are") +
                      " NOT CHECKED to be about the theorem's system");
  if (const auto n = count(NodeStatus::reasoned); n > 0)
    missing.push_back(plural(n, "argument") + " in words " + (n == 1 ? "is" : "are") +
                      " NOT CHECKED");
  if (!missing.empty())
    return std::string(is_verdict ? "NOT DECIDED: " : "NOT PROVED: ") + enumerate(missing);
  if (!complete_but_for_words()) return "NOTHING IS PROVED HERE"; // somebody else's proof
  const std::size_t words = words_of_the_file();
  const bool is_alone =
      is_among(Trusted{Trusted::Step::composition, no_bundle}, nodes.front().trusted);
  return (is_verdict ? decided(nodes)
          : is_alone ? "PROVED BUT FOR A CERTIFICATE"
                     : "PROVED") +
         (words == 0 ? "" : ", except " + plural(words, "step") + " that the file takes on trust");
}

std::string TheoremResult::statement() const {
  if (!complete_but_for_open_parts()) return "";
  std::string text = nodes.front().statement;
  if (asks_for_a_verdict(nodes.front())) // each set of values has a verdict of its own
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (asks_for_a_verdict(nodes[i])) text += ". " + nodes[i].statement;
  return text;
}

// The proved steps and their certificates, counted in words.
std::string TheoremResult::computed() const {
  const std::size_t certified = sum(nodes, [](const NodeResult& n) {
    return n.status == NodeStatus::proved && !n.certificates.empty() ? 1 : 0;
  });
  const std::string steps = plural(count(NodeStatus::proved), "step") + " computed here, ";
  if (!bundle.empty()) return steps + "all that the statement rests on in one certificate";
  return steps + std::to_string(certified) + " of them with certificates";
}

std::string TheoremResult::conclusion() const {
  const std::string conditions = complete_but_for_open_parts() ? given() : "";
  return verdict() + (conditions.empty() ? "" : ", given " + conditions) + "; " + computed();
}

} // namespace kov
