#pragma once
// Work, counted: what a thread has done so far, the same in every run on every machine, so that a
// search that ends for its work ends at the same place.
//
// Counted are the memory that FLINT asks for (memory.hpp: it follows the size of what is computed,
// inside gcds and factorisations as well), and by charge() what is computed in place: products of
// polynomials and matrices, balls, and Z3.

namespace kov {

extern constinit thread_local double meter_reading; ///< through meter() and charge()

/// The work of this thread so far, in units of about ten nanoseconds (docs/theory/work.md).
[[nodiscard]] inline double meter() noexcept { return meter_reading; }
/// Given   const auto charged = [] { const double before = meter(); charge(7); return meter() - before; };
/// Example charged() == 7  // -> yes
inline void charge(double units) noexcept { meter_reading += units; }

/// Work that is done while it lives is not counted: words about what was found, for the user.
class Unmetered {
public:
  Unmetered() = default;
  Unmetered(const Unmetered&) = delete;
  Unmetered& operator=(const Unmetered&) = delete;
  ~Unmetered() { meter_reading = before_; }

private:
  double before_ = meter();
};

} // namespace kov
