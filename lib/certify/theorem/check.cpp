#include "certify/theorem/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/theorem/derivation.hpp"
#include "exact/error.hpp"
#include "proof/text/checked.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"

namespace kov::certify {

namespace {

constexpr std::size_t max_families = 40, max_theorem_steps = 200;
constexpr int max_json_depth = 512;

// "'ID' (RULE)", in ASCII.
std::string quoted_step(const Node& n) {
  Keys k(n);
  std::string id = k.at("id").text().substr(0, 60);
  for (char& c : id)
    if (c < ' ' || c > '~') c = '?';
  return "'" + id + "' (" + k.at("rule").text().substr(0, 20) + ")";
}

TheoremAccepted accepted(const Derivation& d) {
  const TheoremFact& last = d.last();
  TheoremAccepted yes{
      {},          0, last.trusts.size(), 0, theorem_statement(last, d.parts, d.symmetries, d.led),
      last.classes};
  for (const TheoremFact* f : d.parts)
    yes.open += f->kind == FactKind::open ? 1 : 0;
  for (const NamedTheorem& t : named_theorems()) {
    if (!last.used.contains(t.id)) continue;
    yes.theorems.push_back(t.id);
    for (const auto& [how, what] : t.hypotheses)
      yes.unchecked += how == "NOT CHECKED" ? 1 : 0;
  }
  return yes;
}

std::variant<TheoremAccepted, Rejected> judged(const Node& top) {
  Keys k(top);
  static_cast<void>(k.at("format").text());
  static_cast<void>(k.at("title").text());
  const auto families = k.at("systems").items(), steps = k.at("steps").items();
  k.done();
  if (families.size() > max_families || steps.empty() || steps.size() > max_theorem_steps)
    top.fail("too many systems or steps");
  Derivation d;
  std::string at = "systems", id;
  try {
    for (const Node& n : families)
      d.put_family(n);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      at = "step " + quoted_step(steps[i]);
      id = Keys(steps[i]).at("id").text();
      d.put_step(steps[i], i + 1 == steps.size());
    }
    at = id = "";
    d.need_all_used(steps);
  } catch (const Refused& no) {
    return Rejected{no, at, id};
  } catch (const InvalidArgument&) {
    throw;
  } catch (const std::exception& e) {
    return Rejected{{e.what()}, at, id};
  }
  return accepted(d);
}

} // namespace

std::variant<TheoremAccepted, Rejected> check_theorem(std::string_view text) {
  const Json json = parse_json(text, max_json_depth);
  const FileMeter all_steps;
  const CheckedSteps::File file;
  return judged(Node(json, "certificate", rationals()));
}

} // namespace kov::certify
