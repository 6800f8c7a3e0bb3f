#include "certify/equation/check.hpp"

#include "certify/equation/rules.hpp"
#include "certify/equation/statement.hpp"
#include "exact/error.hpp"
#include "exact/overloaded.hpp"
#include "proof/text/checked.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov::certify {

namespace {

class EquationCheck {
public:
  explicit EquationCheck(const Certificate& c)
      : c_(c), judge_{.field = c.field, .equation = {c.num, c.den}} {}

  Accepted operator()() {
    need_header();
    std::set<std::string> used;
    for (const Step& s : c_.steps) {
      take(s);
      used.insert(s.premises.begin(), s.premises.end());
    }
    need(ends_with_conclusion(), "the last step is not a conclusion");
    for (std::size_t i = 0; i + 1 < c_.steps.size(); ++i)
      need(used.count(c_.steps[i].id) == 1, "a step is not used");
    need_claim();
    return {trusted_};
  }

private:
  void need_header() const {
    need(!is_zero(c_.den) && is_one(lead(c_.den)), "den is not monic");
    need(!is_zero(c_.num) || degree(c_.den) == 0, "r = 0 must be written with den = 1");
  }

  void take(const Step& s) {
    try {
      need(facts_.count(s.id) == 0, "the id occurs twice");
      Premises premises;
      for (const std::string& p : s.premises) {
        const auto f = facts_.find(p);
        need(f != facts_.end(), "a premise is not an earlier step");
        premises.push_back(&f->second);
      }
      facts_.emplace(s.id, fact(s.rule, premises));
      if (CheckedSteps::wanted()) tell(s);
    } catch (const Refused& r) {
      throw Rejected{{rule_name(s.rule) + ": " + r.why, r.limit}, s.id};
    } catch (const std::exception& e) {
      throw Rejected{{rule_name(s.rule) + ": " + e.what()}, s.id};
    }
  }

  void tell(const Step& s) const {
    const auto* by = std::get_if<Conclude>(&s.rule);
    CheckedSteps::add({"kovacic-certificate/1", by ? "theorem" : "rule",
                       by ? by->theorem : rule_name(s.rule), s.id, s.premises,
                       by ? concluded() : shown(s.rule)});
  }
  [[nodiscard]] std::string concluded() const {
    if (result_.group)
      return "G = " + *result_.group + (result_.n ? "_" + to_string(*result_.n) : "");
    return result_.abelian == true ? "abelian" : "not abelian";
  }

  Fact fact(const Rule& rule, const Premises& p) {
    const auto alone = [&] { need(p.empty(), "no premises are expected"); };
    return std::visit(
        Overloaded{
            [&](const Local& d) -> Fact { return alone(), check_local(judge_, d); },
            [&](const Exponential& d) -> Fact { return alone(), check_exponential(judge_, d); },
            [&](const Invariant& d) -> Fact { return alone(), check_invariant(judge_, d); },
            [&](const NoExponential& d) -> Fact {
              return check_no_exponential(judge_, d, local(p));
            },
            [&](const PCurvature& d) -> Fact {
              return check_p_curvature(judge_, d, find<LocalFact>(p));
            },
            [&](const NoInvariant& d) -> Fact { return check_no_invariant(judge_, d, local(p)); },
            [&](const TorsionFunction& d) -> Fact {
              return check_torsion_function(judge_, d, imprimitive(p), find<LocalFact>(p));
            },
            [&](const GoodReduction& d) -> Fact {
              return check_good_reduction(judge_, d, imprimitive(p));
            },
            [&](const Conclude& d) -> Fact { return result_ = conclude(d.theorem, p); },
            [&](const ApplyTheorem&) -> Fact {
              need(find<Conclusion>(p) != nullptr, "the theorem is not applied to a conclusion");
              ++trusted_;
              return result_;
            }},
        rule);
  }

  static const LocalFact& local(const Premises& p) {
    const auto* x = find<LocalFact>(p);
    need(x != nullptr, "a local premise is missing");
    return *x;
  }
  static const InvariantFact& imprimitive(const Premises& p) {
    const auto* v = find<InvariantFact>(p);
    need(v && is_quadratic(*v) && degree(v->branch) > 0, "an invariant premise is missing");
    return *v;
  }

  [[nodiscard]] bool ends_with_conclusion() const {
    const Rule& last = c_.steps.back().rule;
    return std::holds_alternative<Conclude>(last) || std::holds_alternative<ApplyTheorem>(last);
  }

  void need_claim() const {
    const Claim& k = c_.claim;
    need(k.group || k.component || k.abelian, "nothing is claimed");
    need(k.group || !k.n, "n belongs to a group");
    static const std::map<std::string, std::string> components = {
        {"SL2", "SL2"},        {"Borel", "Borel"}, {"T", "Ga"},      {"Gm", "Gm"},
        {"cyclic", "trivial"}, {"Dinf", "Gm"},     {"D", "trivial"}, {"A4", "trivial"},
        {"S4", "trivial"},     {"A5", "trivial"}};
    std::optional<std::string> component;
    if (result_.group) component = components.at(*result_.group);
    need(!k.group || k.group == result_.group, "the claim does not follow: group");
    need(!k.n || k.n == result_.n, "the claim does not follow: n");
    need(!k.component || k.component == component, "the claim does not follow: component");
    need(!k.abelian || k.abelian == result_.abelian, "the claim does not follow: abelian");
  }

  const Certificate& c_;
  Judge judge_;
  std::map<std::string, Fact> facts_; // nodes do not move
  Conclusion result_;
  std::size_t trusted_ = 0;
};

} // namespace

std::variant<Accepted, Rejected> check(const Certificate& c) {
  const CheckedSteps::File file;
  try {
    need(!c.steps.empty(), "there are no steps");
    return EquationCheck(c)();
  } catch (const Rejected& step) {
    return step;
  } catch (const Refused& r) {
    return Rejected{r};
  } catch (const std::exception& e) {
    return Rejected{{e.what()}};
  }
}

} // namespace kov::certify
