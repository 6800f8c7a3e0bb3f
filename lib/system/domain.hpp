#pragma once
// The domain of the parameters: the values at which every formula of a file means something.
//
// A denominator d(x; p), or the argument of a logarithm, must not vanish for all x.  That is a
// list of polynomials in p of which not all are 0 (the coefficients of an irreducible factor of d).
// The lists are made once, when the file is read, from what is written: 1/(x^2 + y^2/a^2) is
// a^2/(a^2*x^2 + y^2), which has a value at a = 0, where the file has none.

#include "system/formula.hpp"
#include "system/vector_field.hpp"

namespace kov {

class ParameterDomain {
public:
  /// Not all of these polynomials in the parameters and algebraic constants vanish.
  using NotAllZero = std::vector<MPoly>;

  /// f is not 0 for all values of the phase variables; roots are what is under them.
  /// meanings: of the function symbols of v
  void require(const MPoly& f, const VectorField& v, const std::vector<FunctionMeaning>& meanings);
  void require(NotAllZero list);

  [[nodiscard]] const std::vector<NotAllZero>& lists() const noexcept { return lists_; }
  /// The only members of their lists.
  [[nodiscard]] std::vector<MPoly> nonzero() const;
  /// The system does not exist where these polynomials vanish: all of one list are among them.
  template <class Vanishes> [[nodiscard]] bool excludes(const Vanishes& vanishes) const {
    for (const NotAllZero& list : lists_) {
      bool all = true;
      for (const MPoly& p : list)
        all = all && vanishes(p);
      if (all) return true;
    }
    return false;
  }

  /// The domain with values for some of the parameters.  Throws DomainError if the system does not exist there.
  [[nodiscard]] ParameterDomain at(const Substitution& values) const;
  /// The domain in a ring with the same names.
  [[nodiscard]] ParameterDomain in(const Ring& ring) const;

private:
  void add(NotAllZero list); ///< unless another says as much

  std::vector<NotAllZero> lists_;
};

/// "a != 0", "a != 0 or b != 0"
/// Given   const Ring ring = make_ring({"a", "b"});
/// Given   const MPoly a = MPoly::variable(ring, 0), b = MPoly::variable(ring, 1);
/// Example in_words({a, b})  // -> a != 0 or b != 0
[[nodiscard]] std::string in_words(const ParameterDomain::NotAllZero& list);

} // namespace kov
