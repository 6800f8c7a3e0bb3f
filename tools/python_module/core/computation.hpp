#pragma once
// A computation that Python waits for: it runs without the interpreter's lock, and Ctrl-C stops it.
//
// Ctrl-C reaches Python only after the computation has returned.  So for its duration SIGINT also
// asks the Budget to stop; what is proved by then is kept, and goes with the KeyboardInterrupt.

#include "exact/budget.hpp"

#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <optional>
#include <string>

namespace kov::python {

namespace py = pybind11;

/// What a call may spend.  The clock starts with the computation.
struct Limits {
  std::optional<double> timeout; ///< seconds
  std::optional<double> max_work;
  std::optional<long> max_degree, max_families;

  /// Errors  InvalidArgument for a limit that is not positive
  [[nodiscard]] Budget budget() const;
};

/// While it lives, SIGINT requests a stop.  Outside the main thread it does nothing: Python hands
/// the signal to the main thread only.
class Interrupt {
public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
  [[nodiscard]] const std::atomic<bool>* flag() const { return &raised_; }
  [[nodiscard]] bool raised() const { return raised_; }
  void raise() noexcept; ///< from the signal handler

private:
  std::stop_source source_;
  std::atomic<bool> raised_{false};
  Interrupt* outer_ = nullptr;
  bool installed_ = false;
};

/// Raises kovacic.Interrupted with what is known, if Python's own handler wants an exception.
void raise_if_interrupted(const py::object& known);

/// work(budget, interrupt) without the interpreter's lock; its value as a Python object.
template <class Work> py::object computed(const Limits& limits, const Work& work) {
  Interrupt interrupt;
  Budget budget = limits.budget();
  budget.stop = interrupt.token();
  std::optional<decltype(work(budget, interrupt))> value;
  std::exception_ptr failed;
  PyThreadState* here = PyEval_SaveThread();
  try {
    value.emplace(work(budget, interrupt));
  } catch (...) {
    failed = std::current_exception();
  }
  PyEval_RestoreThread(here); // ends the thread when Python is at its end: not from a destructor
  if (failed) {
    if (interrupt.raised()) raise_if_interrupted(py::none());
    std::rethrow_exception(failed);
  }
  py::object result = py::cast(std::move(*value));
  if (interrupt.raised()) raise_if_interrupted(result);
  return result;
}

} // namespace kov::python
