#pragma once
// Work among polynomials in several variables, counted in products of terms, so that a search that
// does not end stops at the same place on every machine; the clock of the Budget comes on top.

#include "exact/budget.hpp"
#include "exact/multivariate.hpp"

#include <string>

namespace kov {

/// The size of a value: terms, each as long as the longest number in machine words; of a fraction that
/// of the larger side; at least 1.
/// Example size_of(MPoly(make_ring({"x"}), Integer(5)))  // -> 1
[[nodiscard]] double size_of(const MPoly& f) noexcept;
[[nodiscard]] double size_of(const MFraction& f) noexcept;

/// The work of one search.
/// Given   Budget little; little.max_work = 10; Work work(little, "this search");
/// Example work.add(8)  // -> done
/// Example work.add(8)  // -> throws OutOfBudget
class Work {
public:
  /// what: "a Gröbner basis", for the message.
  Work(const Budget& budget, const char* what) : budget_(budget), what_(what) { budget_.check(); }

  /// Before an operation on a and b.   Errors  OutOfBudget, also for the time and a stop
  void add(const MFraction& a, const MFraction& b) { add(size_of(a) * size_of(b)); }
  /// Before steps that cost as much as `products` products of terms.
  void add(double products) {
    done_ += products;
    if (done_ > budget_.max_work) stop();
    if (done_ < next_look_) return;
    budget_.check();
    next_look_ = done_ + 1e5; // products between two looks at the clock
  }

private:
  [[noreturn]] void stop() const;

  const Budget& budget_;
  const char* what_;
  double done_ = 0, next_look_ = 1e5;
};

} // namespace kov
