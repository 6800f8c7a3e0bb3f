#pragma once
// The meaning of names in a formula whose free names are parameters.

#include "system/formula.hpp"

#include <map>

namespace kov {

/// Every variable of the ring by its name, names with values, and roots like sqrt(2) that stand for
/// a variable.
///
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const ParameterScope scope(ring, {{"b", MFraction(ring, Rational(2))}});
/// Example *scope.value("a")  // -> a
/// Example *scope.value("b")  // -> 2
/// Example scope.value("c")  // -> none
class ParameterScope : public Scope {
public:
  ParameterScope(Ring ring, std::map<std::string, MFraction> values,
                 std::vector<FunctionMeaning> functions = {})
      : ring_(std::move(ring)), values_(std::move(values)), functions_(std::move(functions)) {}

  [[nodiscard]] const Ring& ring() const override { return ring_; }
  [[nodiscard]] std::optional<MFraction> value(const std::string& name) const override {
    if (const auto v = values_.find(name); v != values_.end()) return v->second;
    if (ring_->find(name)) return MFraction::variable(ring_, name);
    return std::nullopt;
  }
  [[nodiscard]] const std::vector<FunctionMeaning>& functions() const override {
    return functions_;
  }
  [[nodiscard]] std::vector<std::string> known_names() const override { return ring_->names(); }

private:
  Ring ring_;
  std::map<std::string, MFraction> values_;
  std::vector<FunctionMeaning> functions_;
};

} // namespace kov
