#pragma once
// The parts of the reader of system files; used by read_*.cpp, and by who reads more of the same file (lib/flow).

#include "system/system.hpp"
#include "system/written_functions.hpp"

#include <set>
#include <utility>

namespace kov {

/// The names of one file: variables of the ring, fixed values, definitions, named functions.
/// Definitions are evaluated when they are first used, so that their order does not matter.
class SystemScope : public FunctionsInFormulas::GrowingScope {
public:
  /// more: another table with formulas of this system, which may use functions that the system does not.
  SystemScope(const Entry& document, const ParameterValues& settings, const Entry* more = nullptr);

  [[nodiscard]] const Ring& ring() const override { return ring_; }
  [[nodiscard]] std::optional<MFraction> value(const std::string& name) const override;
  [[nodiscard]] const std::vector<FunctionMeaning>& functions() const override { return meanings; }
  [[nodiscard]] std::vector<std::string> known_names() const override;
  [[nodiscard]] Equation equation(const Entry& entry) const;
  [[nodiscard]] std::vector<Equation> equations(const Entry& entry) const;
  void add(const FunctionMeaning& meaning) override { meanings.push_back(meaning); }
  void divides_by(const MFraction& f) const override;
  /// The divisors since the last call.
  std::vector<MPoly> take_divisors() const { return std::exchange(divisors_, {}); }
  /// A name for a formula that is evaluated at its first use.
  void define(const std::string& name, const Entry& entry);

  std::vector<std::string> coordinates, velocities, function_names, constants, parameters;
  std::string independent;
  std::vector<FunctionMeaning> meanings;
  FunctionsInFormulas written;  ///< in [system]
  std::set<std::string> unused; ///< names of symbols that no formula needs: unknown names
  MFraction lagrangian;         ///< kind lagrangian only
  mutable std::map<std::string, MFraction> values; ///< fixed parameters
  mutable std::map<std::string, MFraction> named;

private:
  void read_settings(const ParameterValues& settings);
  void fix(const std::string& name, const Expression& e);
  [[nodiscard]] std::optional<MFraction> fixed_value(const std::string& name) const;

  const Entry* document_;
  mutable std::vector<MPoly> divisors_;
  Ring ring_;
  std::map<std::string, const Entry*> definitions_;
  std::map<std::string, Expression> pending_;
  mutable std::set<std::string> open_; ///< being evaluated, to see circles
};

/// The strings of an entry; none where there is no such entry.
[[nodiscard]] std::vector<std::string> names_of(const Entry& system, std::string_view key);
/// Requires  scope = SystemScope(document, settings); then it knows all names of the file.
[[nodiscard]] System read_system(const Entry& document, SystemScope& scope);
void read_vector_field(const Entry& document, SystemScope& scope, System& s);
void read_claims(const Entry& document, SystemScope& scope, System& s);
void read_manifolds(const Entry& document, const SystemScope& scope, System& s);
void read_expectations(const Entry& document, const SystemScope& scope, System& s);

} // namespace kov
