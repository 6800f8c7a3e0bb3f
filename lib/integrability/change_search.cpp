#include "integrability/change_search.hpp"

#include "algebraize/cyclic_vector.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr long few_places = 5; // as many as the equations that are known by name have

/// The changes tried without success, with one sentence for all that failed in the same way.
class FailedChanges {
public:
  void add(const MFraction& phi, const std::string& message) {
    const std::string begin = "z = " + to_string(phi) + " ";
    if (!message.starts_with(begin)) return add({}, message, message);
    add(to_string(phi), message, "z " + message.substr(begin.size()));
  }
  [[nodiscard]] std::string text() const {
    return joined(
        ways_,
        [&](const Way& way) {
          return way.changes.size() <= 1 ? way.message : together(way.changes) + way.how;
        },
        "; ");
  }

private:
  struct Way {
    std::vector<std::string> changes;
    std::string message, how;
  };
  void add(const std::string& change, const std::string& message, const std::string& how) {
    auto same = std::ranges::find_if(ways_, [&](const Way& w) { return w.how == how; });
    if (same == ways_.end()) same = ways_.insert(ways_.end(), {{}, message, how});
    if (!change.empty()) same->changes.push_back(change);
  }
  // "for z = x, y, x^2 and 5 more: "
  static std::string together(const std::vector<std::string>& changes) {
    constexpr std::size_t shown = 3;
    std::string text = "for z = ";
    for (std::size_t k = 0; k < std::min(shown, changes.size()); ++k)
      text += (k == 0 ? "" : ", ") + changes[k];
    if (changes.size() > shown) text += " and " + std::to_string(changes.size() - shown) + " more";
    return text + ": ";
  }

  std::vector<Way> ways_;
};

class ChangeSearch {
public:
  ChangeSearch(const System& s, const InvariantManifold& m, const Budget& budget,
               BlockReport& block)
      : s_(s), m_(m), budget_(budget), block_(block) {
    for (const auto& e : block.scalar)
      divisors_.insert(divisors_.end(), e.divisors.begin(), e.divisors.end());
  }

  void given(const MFraction& phi) {
    attempt(phi);
    if (!block_.ode && better_)
      failures_.add(phi, "the change z = " + to_string(*better_) + " would do");
    finish();
  }
  void proposed(const std::vector<MFraction>& changes) {
    for (const auto& phi : changes) {
      better_.reset();
      attempt(phi);
      if (better_ && !block_.ode) attempt(*better_);
    }
    finish();
  }

  /// With the change that was chosen.  What was found stays where a limit ends this.
  void with_combinations(const UnknownsOfBlock& of) {
    if (!block_.ode || block_.ode->singular_places < few_places) return;
    const MFraction phi = block_.ode->phi;
    try {
      for (const auto& c : cyclic_combinations(*block_.ode->field, s_.z, of.system, of.members)) {
        auto e = scalar_equation(s_.field, m_, of.system, of.members, c);
        if (!e) continue;
        e->divisors.insert(e->divisors.end(), divisors_.begin(), divisors_.end());
        block_.scalar.push_back(*std::move(e));
        attempt_equation(phi, block_.scalar.back());
      }
    } catch (const OutOfBudget& limit) {
      note(phi, {limit.what()});
    }
  }

private:
  void attempt_equation(const MFraction& phi, const NormalVariationalEquation& e) {
    auto made = FunctionField::make(s_.field, m_, s_.z, phi, e.divisors, budget_, 2 * smallest_);
    if (const auto* failure = std::get_if<ChangeFailure>(&made)) return note(phi, *failure);
    auto result =
        algebraize(std::make_shared<const FunctionField>(std::get<FunctionField>(std::move(made))),
                   s_.z, phi, e, false);
    if (const auto* failure = std::get_if<ChangeFailure>(&result)) return note(phi, *failure);
    auto& ode = std::get<AlgebraicOde>(result);
    if (ode.singular_places < block_.ode->singular_places) block_.ode = std::move(ode);
  }
  // A limit is one of this change: others may be easier.
  void attempt(const MFraction& phi) {
    budget_.check();
    try {
      find_equations(phi);
    } catch (const OutOfBudget& limit) {
      note(phi, {"z = " + to_string(phi) + ": " + limit.what()});
    }
  }
  void find_equations(const MFraction& phi) {
    // a map of much higher degree than one that works brings more singular places
    auto made = FunctionField::make(s_.field, m_, s_.z, phi, divisors_, budget_, 2 * smallest_);
    if (const auto* failure = std::get_if<ChangeFailure>(&made)) return note(phi, *failure);
    const auto field =
        std::make_shared<const FunctionField>(std::get<FunctionField>(std::move(made)));
    for (const auto& e : block_.scalar) {
      auto result = algebraize(field, s_.z, phi, e, !block_.ode);
      if (const auto* failure = std::get_if<ChangeFailure>(&result)) {
        note(phi, *failure);
        continue;
      }
      auto& ode = std::get<AlgebraicOde>(result);
      smallest_ = std::min(smallest_, field->algebra().dimension());
      if (!block_.ode || ode.singular_places < block_.ode->singular_places)
        block_.ode = std::move(ode);
    }
  }
  void note(const MFraction& phi, const ChangeFailure& failure) {
    failures_.add(phi, failure.message);
    if (failure.better) better_ = failure.better;
  }
  void finish() {
    if (block_.ode) return;
    const auto factors = factors_on_components(m_);
    std::string product = joined(
        factors, [](const MPoly& f) { return "(" + to_string(f) + ")"; }, "*");
    using What = Missing::What;
    block_.missing = {{factors.empty() ? What::no_change : What::no_change_on_all_components,
                       failures_.text(), product}};
  }

  const System& s_;
  const InvariantManifold& m_;
  const Budget& budget_;
  BlockReport& block_;
  std::vector<MPoly> divisors_;
  FailedChanges failures_;
  std::optional<MFraction> better_;
  std::size_t smallest_ = 100;
};

} // namespace

void find_change(const System& s, const InvariantManifold& m, const MFraction* given,
                 const Budget& budget, BlockReport& block,
                 const std::optional<UnknownsOfBlock>& also) {
  ChangeSearch search(s, m, budget, block);
  if (given)
    search.given(*given);
  else
    search.proposed(propose_changes(s.field, m));
  if (also) search.with_combinations(*also);
}

} // namespace kov
