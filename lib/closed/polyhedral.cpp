#include "closed/polyhedral.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace kov {
namespace {

const Quaternion one{Surd{4, 0}, Surd{}, Surd{}, Surd{}};
const Quaternion half_of_all{Surd{2, 0}, Surd{2, 0}, Surd{2, 0}, Surd{2, 0}};

Surd operator-(const Surd& x) { return {-x.a, -x.b}; }

} // namespace

PolyhedralGroup::PolyhedralGroup(GroupType type) : type_(type) {
  std::size_t size = 0;
  if (type == GroupType::A4) {
    size = 24;
    close({half_of_all, {Surd{}, Surd{4, 0}, Surd{}, Surd{}}}); // (1+i+j+k)/2, i
  } else if (type == GroupType::S4) {
    size = 48;
    close({half_of_all, {Surd{0, 2}, Surd{0, 2}, Surd{}, Surd{}}}); // (1+i)/sqrt 2
  } else if (type == GroupType::A5) {
    size = 120;
    d_ = 5; // (g + i/g + j)/2, g = (1 + sqrt 5)/2
    close({half_of_all, {Surd{1, 1}, Surd{-1, 1}, Surd{2, 0}, Surd{}}});
  } else {
    throw InvalidArgument("only A4, S4 and A5 are polyhedral groups");
  }
  KOV_ENSURE(elements_.size() == size);
  set_exponents();
}

// sum x_i y_i in these coordinates: a coordinate of a product, so integral, though single terms are
// not.
Surd PolyhedralGroup::product_sum(const std::array<Surd, 4>& x,
                                  const std::array<Surd, 4>& y) const {
  long a = 0;
  long b = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    a += x[i].a * y[i].a + d_ * x[i].b * y[i].b;
    b += x[i].a * y[i].b + x[i].b * y[i].a;
  }
  KOV_ENSURE(a % 4 == 0 && b % 4 == 0);
  return {a / 4, b / 4};
}

Quaternion PolyhedralGroup::multiply(const Quaternion& p, const Quaternion& q) const {
  return {product_sum(p, {q[0], -q[1], -q[2], -q[3]}), product_sum(p, {q[1], q[0], q[3], -q[2]}),
          product_sum(p, {q[2], -q[3], q[0], q[1]}), product_sum(p, {q[3], q[2], -q[1], q[0]})};
}

Surd PolyhedralGroup::real_part_of_product(const Quaternion& p, const Quaternion& q) const {
  return product_sum(p, {q[0], -q[1], -q[2], -q[3]});
}

bool PolyhedralGroup::irreducible(const Quaternion& p, const Quaternion& q) const {
  // Two unit quaternions have a common eigenvector exactly when they commute (both are unitary).
  return multiply(p, q) != multiply(q, p);
}

void PolyhedralGroup::close(std::vector<Quaternion> generators) {
  std::set<Quaternion> seen{one};
  elements_ = {one};
  for (std::size_t i = 0; i < elements_.size(); ++i)
    for (const Quaternion& g : generators) {
      const Quaternion next = multiply(elements_[i], g);
      if (seen.insert(next).second) elements_.push_back(next);
      KOV_ENSURE(elements_.size() <= 120);
    }
}

long PolyhedralGroup::order(const Quaternion& q) const {
  long n = 1;
  for (Quaternion power = q; power != one; power = multiply(power, q))
    ++n;
  return n;
}

// x < y: the sign of (a + b sqrt d) for the difference.
bool PolyhedralGroup::less(const Surd& x, const Surd& y) const {
  const long a = y.a - x.a;
  const long b = y.b - x.b;
  if (a >= 0 && b >= 0) return a > 0 || b > 0;
  if (a <= 0 && b <= 0) return false;
  return a > 0 ? a * a > d_ * b * b : d_ * b * b > a * a;
}

// An element of order n has real part cos(2 pi k/n), 0 <= k <= n/2, so that cos(pi Delta) = -w
// gives Delta = 1 - 2k/n.  The greatest real part among the elements of order n has k = 1 (the
// powers of an element by exponents prime to n are in the group), and its powers show the others.
void PolyhedralGroup::set_exponents() {
  std::map<long, Quaternion> greatest;
  std::vector<long> orders;
  for (const Quaternion& q : elements_) {
    const long n = order(q);
    orders.push_back(n);
    const auto [at, fresh] = greatest.try_emplace(n, q);
    if (!fresh && less(at->second[0], q[0])) at->second = q;
  }
  std::map<Surd, Rational> known;
  for (const auto& [n, generator] : greatest) {
    Quaternion power = one;
    for (long k = 0; 2 * k <= n; ++k, power = multiply(power, generator))
      known.try_emplace(power[0], Rational(1) - Rational(2 * k, n));
  }
  by_real_part_.assign(known.begin(), known.end());
  for (const Quaternion& q : elements_)
    exponent_.push_back(known.at(q[0]));
}

const Rational& PolyhedralGroup::exponent_of_real_part(const Surd& w) const {
  const auto at =
      std::ranges::lower_bound(by_real_part_, w, {}, [](const auto& entry) { return entry.first; });
  KOV_ENSURE(at != by_real_part_.end() && at->first == w);
  return at->second;
}

} // namespace kov
