#pragma once
// One algebraic number: its minimal polynomial and an enclosure that singles out one root
// (Calcium's qqbar).  Used at the door only, to read constants and to decide which root is meant;
// everything after that computes in one number field (number_field.hpp).

#include "exact/ball.hpp"
#include "exact/number_field.hpp"

#include <memory>
#include <vector>

struct kov_qqbar_struct;

namespace kov {

/// An algebraic number.  Cost of + and *: a polynomial of degree deg a deg b is factored.
class QQbar {
public:
  QQbar();
  QQbar(const Rational& q);
  QQbar(std::integral auto n) : QQbar(Rational(n)) {}
  QQbar(const QQbar& o);
  QQbar(QQbar&& o) noexcept = default;
  QQbar& operator=(QQbar o) noexcept {
    v_.swap(o.v_);
    return *this;
  }
  ~QQbar() = default;

  [[nodiscard]] static QQbar i();
  [[nodiscard]] const kov_qqbar_struct* raw() const noexcept { return v_.get(); }

  friend QQbar operator+(const QQbar& a, const QQbar& b);
  friend QQbar operator*(const QQbar& a, const QQbar& b);
  friend QQbar operator*(const Integer& n, const QQbar& a);
  friend bool operator==(const QQbar& a, const QQbar& b);

  friend std::vector<QQbar> roots(const std::vector<Integer>& f);
  friend QQbar principal_root(const QQbar& a, unsigned long n);
  friend QQbar evaluate(const fmpq_poly_struct* f, const QQbar& a);

private:
  struct Free {
    void operator()(kov_qqbar_struct* x) const noexcept;
  };
  std::unique_ptr<kov_qqbar_struct, Free> v_;
};

/// Ascending, primitive, irreducible, positive leading coefficient.
/// Example minimal_polynomial(QQbar::i() + principal_root(2, 2))  // -> {9, 0, -2, 0, 1}
[[nodiscard]] std::vector<Integer> minimal_polynomial(const QQbar& a);
[[nodiscard]] long degree(const QQbar& a); ///< of the minimal polynomial
/// A ball around a, its parts rounded to `bits` bits.
[[nodiscard]] ComplexBall enclosure(const QQbar& a, long bits);
/// All roots of f (ascending coefficients, f != 0) with multiplicity: the real ones first, from the
/// largest down, then the others in a fixed order.
[[nodiscard]] std::vector<QQbar> roots(const std::vector<Integer>& f);
/// The n-th root with argument in (-pi/n, pi/n].  Cost: factors a polynomial of degree n deg(a).
[[nodiscard]] QQbar principal_root(const QQbar& a, unsigned long n);
/// f(a) for a rational polynomial f.
[[nodiscard]] QQbar evaluate(const fmpq_poly_struct* f, const QQbar& a);

/// a = (u + v sqrt(n))/w for a number of degree 2 (checked), n free of small squares.
/// Example quadratic_parts(roots({-1, -1, 1}).front())  // -> {1, 1, 2, 5}
struct Quadratic {
  Integer u, v, w, n;
};
[[nodiscard]] Quadratic quadratic_parts(const QQbar& a);

/// The field Q(a) for an algebraic integer a, with the embedding that sends its generator to a,
/// which is `scale` times what the letter means.
/// Errors  InvalidArgument if a is not an algebraic integer
/// Example field_of(principal_root(Rational(1, 2), 2), "a")->degree()  // -> throws InvalidArgument
[[nodiscard]] Field field_of(const QQbar& a, std::string letter, Integer scale = Integer(1));
/// Is x, under the chosen embedding of its field, the number a?  Decided exactly.
[[nodiscard]] bool equals(const NfElem& x, const QQbar& a);

} // namespace kov
