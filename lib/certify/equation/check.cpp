#include "certify/equation/check.hpp"

#include "certify/equation/rules.hpp"
#include "certify/equation/statement.hpp"
#include "exact/error.hpp"
#include "proof/text/checked.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov::certify {

namespace {

struct FailedStep { // what check() reports
  std::string step, why;
  bool limit = false;
};

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
      facts_.emplace(s.id,
                     std::visit([&](const auto& data) { return fact(data, premises); }, s.rule));
      if (CheckedSteps::wanted()) tell(s);
    } catch (const Refused& r) {
      throw FailedStep{s.id, rule_name(s.rule) + ": " + r.why, r.limit};
    } catch (const std::exception& e) {
      throw FailedStep{s.id, rule_name(s.rule) + ": " + e.what()};
    }
  }

  void tell(const Step& s) const {
    const auto* by = std::get_if<Conclude>(&s.rule);
    CheckedSteps::add({"kovacic-certificate/1", by ? "theorem" : "rule",
                       by ? to_string(by->theorem) : rule_name(s.rule), s.id, s.premises,
                       by ? concluded() : shown(s.rule)});
  }
  [[nodiscard]] std::string concluded() const {
    if (result_.group)
      return "G = " + *result_.group + (result_.n ? "_" + to_string(*result_.n) : "");
    return result_.abelian == true ? "abelian" : "not abelian";
  }

  Fact fact(const Local& d, const Premises& p) const {
    need(p.empty(), "no premises are expected");
    return check_local(judge_, d);
  }
  Fact fact(const Exponential& d, const Premises& p) const {
    need(p.empty(), "no premises are expected");
    return check_exponential(judge_, d);
  }
  Fact fact(const Invariant& d, const Premises& p) const {
    need(p.empty(), "no premises are expected");
    return check_invariant(judge_, d);
  }
  Fact fact(const NoExponential& d, const Premises& p) const {
    return check_no_exponential(judge_, d, local(p));
  }
  Fact fact(const PCurvature& d, const Premises& p) const {
    return check_p_curvature(judge_, d, find<LocalFact>(p));
  }
  Fact fact(const NoInvariant& d, const Premises& p) const {
    return check_no_invariant(judge_, d, local(p));
  }
  Fact fact(const TorsionFunction& d, const Premises& p) const {
    return check_torsion_function(judge_, d, imprimitive(p), find<LocalFact>(p));
  }
  Fact fact(const GoodReduction& d, const Premises& p) const {
    return check_good_reduction(judge_, d, imprimitive(p));
  }
  Fact fact(const Conclude& d, const Premises& p) {
    result_ = conclude(d.theorem, p);
    return result_;
  }
  Fact fact(const ApplyTheorem&, const Premises& p) {
    need(find<Conclusion>(p) != nullptr, "the theorem is not applied to a conclusion");
    ++trusted_;
    return result_;
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
  } catch (const FailedStep& f) {
    return Rejected{{f.why, f.limit}, f.step};
  } catch (const Refused& r) {
    return Rejected{r};
  } catch (const std::exception& e) {
    return Rejected{{e.what()}};
  }
}

} // namespace kov::certify
