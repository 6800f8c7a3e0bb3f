// Laws of the local data: from the definition, the Fuchs relation, Moebius transformations.

#include "exact/fields.hpp"
#include "linode/singularities.hpp"
#include "support/equations.hpp"

#include <gtest/gtest.h>

#include <set>

namespace kov::singularities_laws_test {
namespace {

using namespace testing;

class LocalLaws : public OverFields {
protected:
  [[nodiscard]] RationalFunction line(const NfElem& c) const {
    return RationalFunction(z() - Poly(c));
  }
  [[nodiscard]] static RationalFunction number_function(const NfElem& c) {
    return RationalFunction(Poly(c));
  }
  [[nodiscard]] std::vector<NfElem> distinct(std::size_t n) {
    std::vector<NfElem> c;
    while (c.size() < n)
      if (NfElem e = element(); std::find(c.begin(), c.end(), e) == c.end()) c.push_back(e);
    return c;
  }
  [[nodiscard]] static const Singularity* at(const Singularities& s, const NfElem& c) {
    for (const Singularity& p : s.finite)
      if (degree(p.place) == 1 && -p.place.coeff(0) == c) return &p;
    return nullptr;
  }
};

// r = sum b_i/(z-c_i)^2 + a_i/(z-c_i) with sum a_i = 0: Delta_i^2 = 1 + 4 b_i, and the residue
// theorem for z r dz is the Fuchs relation Delta_inf^2 = 1 + 4 sum (b_i + a_i c_i).
TEST_P(LocalLaws, FuchsRelation) {
  for (int i = 0; i < 6; ++i) {
    const auto c = distinct(3);
    RationalFunction r;
    NfElem at_infinity;
    NfElem rest(k);
    std::vector<NfElem> b;
    for (std::size_t j = 0; j < c.size(); ++j) {
      b.push_back(nonzero());
      const NfElem a = j + 1 < c.size() ? element() : -rest;
      rest += a;
      r += number_function(b[j]) / (line(c[j]) * line(c[j])) + number_function(a) / line(c[j]);
      at_infinity += b[j] + a * c[j];
    }
    const Singularities s = singularities(r);
    ASSERT_EQ(s.finite.size(), 3U);
    for (std::size_t j = 0; j < c.size(); ++j) {
      const Singularity* p = at(s, c[j]);
      ASSERT_NE(p, nullptr);
      EXPECT_EQ(p->kind, PlaceKind::regular);
      EXPECT_EQ(p->order, 2);
      EXPECT_EQ(p->delta_squared, Poly(NfElem(1) + NfElem(4) * b[j]));
      EXPECT_EQ(p->degree(), 1);
      if (p->delta) {
        EXPECT_EQ(Poly(*p->delta * *p->delta), p->delta_squared);
        EXPECT_GE(sign(*p->delta), 0);
      }
    }
    if (s.infinity.order == 2) {
      EXPECT_EQ(s.infinity.delta_squared, Poly(NfElem(1) + NfElem(4) * at_infinity));
    } else {
      EXPECT_TRUE(is_zero(at_infinity));
    }
  }
}

// At a place q of any degree b = num/(den/q^2 q'^2) modulo q.
TEST_P(LocalLaws, ConjugatePlacesFromTheDefinition) {
  for (int i = 0; i < 4; ++i) {
    const Poly q = z() * z() + constant(43);
    const Poly num = poly(2) + constant(1);
    if (is_zero(num % q)) continue;
    const RationalFunction r(num, q * q);
    const Singularities s = singularities(r);
    ASSERT_EQ(s.finite.size(), 1U);
    const Poly slope = derivative(q);
    const Poly b = num * inverse_mod(slope * slope, q) % q;
    EXPECT_EQ(s.finite[0].delta_squared, constant(1) + constant(4) * b);
    EXPECT_EQ(s.finite[0].degree(), 2);
  }
}

TEST_P(LocalLaws, KindsFollowTheOrders) {
  const NfElem c = element();
  const struct {
    long order;
    PlaceKind finite, infinite;
  } table[] = {{1, PlaceKind::simple, PlaceKind::ramified},
               {2, PlaceKind::regular, PlaceKind::regular},
               {3, PlaceKind::ramified, PlaceKind::simple},
               {4, PlaceKind::irregular, PlaceKind::ordinary},
               {5, PlaceKind::ramified, PlaceKind::ordinary},
               {8, PlaceKind::irregular, PlaceKind::ordinary}};
  for (const auto& [order, finite, infinite] : table) {
    const Singularities s = singularities(RationalFunction(constant(1)) / pow(line(c), order));
    ASSERT_EQ(s.finite.size(), 1U);
    EXPECT_EQ(s.finite[0].order, order);
    EXPECT_EQ(s.finite[0].kind, finite);
    EXPECT_EQ(s.infinity.order, order);
    EXPECT_EQ(s.infinity.kind, infinite);
    EXPECT_EQ(s.finite[0].log == Truth::yes, order == 1);
    if (order == 3) {
      EXPECT_EQ(s.infinity.log, Truth::yes);
    }
  }
  EXPECT_EQ(singularities(RationalFunction(z())).infinity.kind, PlaceKind::ramified);
  EXPECT_EQ(singularities(RationalFunction(constant(-3))).infinity.kind, PlaceKind::irregular);
}

// omega = a (t^-nu + s_1 t^(1-nu) + ... + s_(nu-2) t^-2) + alpha/t + regular at 0, and a z^2 + b z
// + c + beta/z at infinity: what the tail of sqrt r shows is the polar part of omega.
TEST_P(LocalLaws, IrregularTailsAreThePolarPartOfASolution) {
  for (long nu = 2; nu <= 4; ++nu) {
    const NfElem a = nonzero();
    const NfElem alpha = element();
    RationalFunction omega = number_function(alpha) / RationalFunction(z());
    std::vector<NfElem> tail{NfElem(1)};
    for (long j = 1; j <= nu - 2; ++j)
      tail.push_back(element());
    for (std::size_t j = 0; j < tail.size(); ++j)
      omega += number_function(a * tail[j]) * pow(RationalFunction(z()), static_cast<long>(j) - nu);
    const NfElem lead = nonzero();
    const NfElem middle = element();
    omega += number_function(lead) * RationalFunction(z()) + number_function(middle);
    const Singularities s = singularities(from_omega(omega));
    ASSERT_EQ(s.finite.size(), 1U);
    const Singularity& p = s.finite[0];
    EXPECT_EQ(p.kind, PlaceKind::irregular);
    EXPECT_EQ(p.nu(), nu);
    EXPECT_EQ(p.leading, Poly(a * a));
    ASSERT_EQ(p.sqrt_tail.size(), tail.size());
    for (std::size_t j = 0; j < tail.size(); ++j)
      EXPECT_EQ(p.sqrt_tail[j], Poly(tail[j]));
    // alpha = (nu + eps)/2
    const NfElem eps = NfElem(2) * alpha - NfElem(nu);
    EXPECT_EQ(p.delta_squared, Poly(eps * eps));
    EXPECT_EQ(p.beta, Poly(eps * a));
    // at infinity: leading z^1, then the constant, and the growth exponent alpha
    EXPECT_EQ(s.infinity.nu(), 1);
    EXPECT_EQ(s.infinity.leading, Poly(lead * lead));
    ASSERT_EQ(s.infinity.sqrt_tail.size(), 2U);
    EXPECT_EQ(s.infinity.sqrt_tail[1], Poly(middle / lead));
    const NfElem growth = NfElem(2) * alpha + NfElem(1); // alpha = (eps - nu)/2
    EXPECT_EQ(s.infinity.delta_squared, Poly(growth * growth));
  }
}

// z -> (a z + b)/(c z + d) moves the places and keeps what they are.
TEST_P(LocalLaws, MoebiusTransformationsMoveThePlacesOnly) {
  const auto c = distinct(4);
  RationalFunction r = number_function(nonzero()) / pow(line(c[0]), 4) +
                       number_function(NfElem(Rational(3, 4))) / pow(line(c[1]), 2) +
                       number_function(nonzero()) / line(c[1]) +
                       number_function(nonzero()) / pow(line(c[2]), 3);
  // c[3] -> 0, and no place goes to infinity
  const RationalFunction f = line(c[3]) / (line(c[3]) - RationalFunction(Rational(1, 97)));
  const Singularities before = singularities(r);
  const Singularities after = singularities(pull_back(r, f));
  const auto everything = [](const Singularities& s) {
    std::multiset<std::string> all; // ordinary infinity is not a singularity
    const auto note = [&](const Singularity& p) {
      if (p.kind == PlaceKind::ordinary) return;
      const long nu = p.at_infinity && p.kind == PlaceKind::irregular ? p.nu() + 2 : p.nu();
      all.insert(std::to_string(static_cast<int>(p.kind)) + " " +
                 (p.kind == PlaceKind::ramified ? "" : to_string(p.delta_squared)) + " " +
                 (p.kind == PlaceKind::irregular ? std::to_string(nu) : "") + " " +
                 std::to_string(static_cast<int>(p.log)));
    };
    for (const Singularity& p : s.finite)
      note(p);
    note(s.infinity);
    return all;
  };
  EXPECT_EQ(everything(after), everything(before));
}

// A substitution that branches to the order e over a place multiplies its exponent difference.
TEST_P(LocalLaws, PowersMultiplyExponentDifferences) {
  const NfElem b = nonzero();
  const RationalFunction r = number_function(b) / pow(RationalFunction(z()), 2) +
                             number_function(nonzero()) / line(NfElem(1));
  for (long e = 2; e <= 4; ++e) {
    const Singularities s = singularities(pull_back(r, pow(RationalFunction(z()), e)));
    const Singularity* p = at(s, NfElem(0));
    const NfElem expected = NfElem(e * e) * (NfElem(1) + NfElem(4) * b);
    if (p == nullptr) {
      EXPECT_TRUE(is_one(expected));
      continue;
    }
    EXPECT_EQ(p->delta_squared, Poly(expected));
  }
}

KOV_OVER_ALL_FIELDS(LocalLaws);

TEST(Singularities, ZeroAndLimits) {
  EXPECT_THROW((void)singularities(RationalFunction(0)), InvalidArgument);
  Budget small;
  small.max_degree = 3;
  EXPECT_THROW((void)singularities(RationalFunction(Poly(1), pow(Poly::z(), 6)), small),
               OutOfBudget);
}

} // namespace
} // namespace kov::singularities_laws_test
