#pragma once
// The steps that a judge has accepted, for a reader (docs/theory/rules.toml has a row for each rule).

#include <initializer_list>
#include <string>
#include <vector>

namespace kov::certify {

struct CheckedStep {
  std::string format, key, rule; ///< of the row
  std::string id{};              ///< in the file
  std::vector<std::string> of{}; ///< ids of the steps from which it follows
  std::string found{};           ///< its data or its conclusion, in formulas
  std::size_t inside = 0;        ///< 1: of a certificate within the file, 2: of one within that
};

/// The steps that the judges of this thread accept while it lives; without one nothing is kept.
///
/// Example
///   const CheckedSteps steps;
///   check(certificate);
///   steps.all().size()  // -> 4
class CheckedSteps {
public:
  CheckedSteps();
  ~CheckedSteps();
  CheckedSteps(const CheckedSteps&) = delete;
  CheckedSteps& operator=(const CheckedSteps&) = delete;

  [[nodiscard]] static bool wanted();
  static void add(CheckedStep step);
  static void add_labels(const char* format, std::initializer_list<const char*> labels);
  [[nodiscard]] const std::vector<CheckedStep>& all() const { return all_; }

  /// A judge of one file, which may be within another one.
  struct File {
    File();
    ~File();
    File(const File&) = delete;
    File& operator=(const File&) = delete;
  };

private:
  std::vector<CheckedStep> all_;
};

} // namespace kov::certify
