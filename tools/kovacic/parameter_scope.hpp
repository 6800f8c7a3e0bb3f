#pragma once
// What names mean in a formula whose free names are parameters.

#include "system/formula.hpp"

#include <map>
#include <string>
#include <vector>

namespace kov::cli {

/// Every variable of the ring by its name, and names with rational values.
class ParameterScope : public Scope {
public:
  ParameterScope(Ring ring, std::map<std::string, Rational> values)
      : ring_(std::move(ring)), values_(std::move(values)) {}
  [[nodiscard]] const Ring& ring() const override { return ring_; }
  [[nodiscard]] std::optional<MFraction> value(const std::string& name) const override {
    if (const auto at = values_.find(name); at != values_.end())
      return MFraction(ring_, at->second);
    if (const auto i = ring_->find(name)) return MFraction::variable(ring_, *i);
    return std::nullopt;
  }
  [[nodiscard]] const std::vector<FunctionMeaning>& functions() const override { return none_; }
  [[nodiscard]] std::vector<std::string> known_names() const override { return ring_->names(); }

private:
  Ring ring_;
  std::map<std::string, Rational> values_;
  std::vector<FunctionMeaning> none_;
};

} // namespace kov::cli
