#include "exact/lists.hpp"
#include "theorem/theorem.hpp"

#include "symbol/suggest.hpp"

#include <algorithm>

namespace kov {
namespace {

void add_text(std::vector<std::string>& all, const std::string& one) { add_once(all, one); }

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

} // namespace

std::size_t TheoremResult::count(NodeStatus s) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(nodes, [s](const NodeResult& n) { return n.status == s; }));
}

std::vector<TheoremUsed> TheoremResult::uses() const {
  std::vector<TheoremUsed> all;
  for (const NodeResult& n : nodes)
    for (const TheoremUsed& here : n.theorems) {
      const auto known = std::ranges::find_if(
          all, [&](const TheoremUsed& u) { return u.theorem == here.theorem; });
      if (known == all.end())
        all.push_back(here);
      else
        leave_open(*known, here);
    }
  return all;
}

std::vector<std::string> TheoremResult::trusted_steps() const {
  std::vector<std::string> all;
  for (const NodeResult& n : nodes) { // two steps may have one title
    std::vector<std::string> own;
    for (const Trusted& t : n.trusted)
      add_text(own, t.step == Trusted::Step::by_author && !t.of.empty()
                        ? sentence(t)
                        : n.node.title + ": " + sentence(t));
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
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
  const bool is_ours = !nodes.empty() && nodes.front().status == NodeStatus::proved;
  return is_ours && count(NodeStatus::open) == 0 && count(NodeStatus::refuted) == 0 &&
         count(NodeStatus::unbound) == 0 && count(NodeStatus::reasoned) == 0;
}

bool TheoremResult::complete_but_for_open_parts() const {
  const auto parts = static_cast<std::size_t>(std::ranges::count_if(nodes, [](const NodeResult& n) {
    return n.node.kind == NodeKind::open_part && n.status == NodeStatus::open;
  }));
  const bool is_ours = !nodes.empty() && (nodes.front().status == NodeStatus::proved ||
                                          nodes.front().status == NodeStatus::partial);
  return is_ours && count(NodeStatus::open) == parts && count(NodeStatus::refuted) == 0 &&
         count(NodeStatus::unbound) == 0 && count(NodeStatus::reasoned) == 0;
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
  if (const auto n = trusted_steps().size(); n > 0)
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
  if (!complete()) return "NOTHING IS PROVED HERE"; // somebody else's proof
  return is_verdict ? decided(nodes) : "PROVED";
}

std::string TheoremResult::statement() const {
  if (!complete_but_for_open_parts()) return "";
  std::string text = nodes.front().statement;
  if (asks_for_a_verdict(nodes.front())) // each set of values has a verdict of its own
    for (std::size_t i = 1; i < nodes.size(); ++i)
      if (asks_for_a_verdict(nodes[i])) text += ". " + nodes[i].statement;
  return text;
}

// The proved steps and their certificates, counted in words; a report on one file has no whole to certify.
std::string TheoremResult::computed() const {
  const auto certified =
      static_cast<std::size_t>(std::ranges::count_if(nodes, [](const NodeResult& n) {
        return n.status == NodeStatus::proved && !n.certificates.empty();
      }));
  const bool has_whole = !nodes.empty() && nodes.front().node.kind == NodeKind::cover;
  const std::string steps = plural(count(NodeStatus::proved), "step") + " computed here, ";
  if (!bundle.empty()) return steps + "all that the statement rests on in one certificate";
  return steps + std::to_string(certified) + " of them with certificates" +
         (no_bundle.empty() || !has_whole ? ""
                                          : "; no certificate of the whole (" + no_bundle + ")");
}

std::string TheoremResult::conclusion() const {
  const std::string conditions = complete_but_for_open_parts() ? given() : "";
  return verdict() + (conditions.empty() ? "" : ", given " + conditions) + "; " + computed();
}

} // namespace kov
