#include "computation.hpp"

#include <cmath>
#include <csignal>

#include <unistd.h>

namespace kov::python {
namespace {

std::atomic<Interrupt*> latest{nullptr};
pthread_t main_thread{};
struct sigaction pythons = {};

// Any thread may be given the signal of a process; only in the main one is `latest` still there.
extern "C" void on_interrupt(int signal) {
  if (::gettid() != ::getpid()) {
    ::pthread_kill(main_thread, signal);
    return;
  }
  if (Interrupt* running = latest.load()) running->raise();
  pythons.sa_handler(signal);
}

double positive(const char* name, double value) {
  if (value > 0) return value; // and not NaN
  throw InvalidArgument(std::string(name) + " must be positive, and is " + Budget::number(value));
}

} // namespace

Budget Limits::budget() const {
  constexpr double forever = 1e9; // seconds: more does not fit the clock
  Budget b;
  if (timeout && positive("timeout", *timeout) < forever) b = Budget::of_seconds(*timeout);
  if (max_work) b.max_work = positive("max_work", *max_work);
  if (max_degree)
    b.max_degree = static_cast<long>(positive("max_degree", static_cast<double>(*max_degree)));
  if (max_families)
    b.max_families =
        static_cast<long>(positive("max_families", static_cast<double>(*max_families)));
  return b;
}

Interrupt::Interrupt() {
  if (::gettid() != ::getpid()) return;
  main_thread = ::pthread_self();
  outer_ = latest.exchange(this);
  installed_ = true;
  if (outer_ != nullptr) return; // a computation inside a callback of another one
  struct sigaction ours = {};
  ::sigaction(SIGINT, nullptr, &pythons);
  const bool a_handler = (pythons.sa_flags & SA_SIGINFO) == 0 && pythons.sa_handler != SIG_DFL &&
                         pythons.sa_handler != SIG_IGN;
  if (!a_handler) {
    latest = nullptr;
    installed_ = false;
    return;
  }
  ours = pythons;
  ours.sa_handler = &on_interrupt;
  ::sigaction(SIGINT, &ours, nullptr);
}

Interrupt::~Interrupt() {
  if (!installed_) return;
  if (outer_ == nullptr) ::sigaction(SIGINT, &pythons, nullptr);
  latest = outer_;
}

// Atomic operations only: no callback is ever registered at the stop source.
void Interrupt::raise() noexcept {
  raised_ = true;
  source_.request_stop();
  if (outer_ != nullptr) outer_->raise();
}

void raise_if_interrupted(const py::object& known) {
  if (PyErr_CheckSignals() == 0) return;
  if (PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) == 0) throw py::error_already_set();
  PyErr_Clear();
  const py::object type = py::module_::import("kovacic._errors").attr("Interrupted");
  const py::object error = type(known);
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

} // namespace kov::python
