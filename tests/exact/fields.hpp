#pragma once
// The constant fields of the suites, and random elements with small coefficients.

#include "exact/poly.hpp"
#include "exact/rational_function.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

#include <ostream>

namespace kov {

// What a failed comparison shows.
inline void PrintTo(const Integer& a, std::ostream* out) { *out << to_string(a); }
inline void PrintTo(const Rational& a, std::ostream* out) { *out << to_string(a); }
inline void PrintTo(const NfElem& a, std::ostream* out) { *out << to_string(a); }
inline void PrintTo(const Poly& a, std::ostream* out) { *out << to_string(a); }
inline void PrintTo(const RationalFunction& a, std::ostream* out) { *out << to_string(a); }

} // namespace kov

namespace kov::testing {

/// One field per kind that the program meets, by name.
struct NamedField {
  const char* name;
  std::vector<Integer> minimal_polynomial; ///< ascending
  const char* letter;
  long scale = 1;
};

inline const std::vector<NamedField>& named_fields() {
  static const std::vector<NamedField> all{
      {"Rationals", {0, 1}, ""},
      {"Gaussian", {1, 0, 1}, "I"},
      {"RealQuadratic", {-2, 0, 1}, "s"},
      {"QuadraticWithLinearTerm", {-1, -1, 1}, "a"}, // the golden ratio
      {"ScaledLetter", {-6, 0, 1}, "a", 2},          // 2 a^2 = 3
      {"CubicS3", {1, 1, 0, 1}, "a"},
      {"CubicCyclic", {-1, -2, 1, 1}, "a"}, // 2 cos(2 pi/7)
      {"EighthRootsOfUnity", {1, 0, 0, 0, 1}, "a"},
      {"QuinticS5", {-1, -1, 0, 0, 0, 1}, "a"},
  };
  return all;
}

inline Field make(const NamedField& f) {
  if (f.minimal_polynomial.size() == 2) return rationals();
  return make_field(f.minimal_polynomial, f.letter, 0, Integer(f.scale));
}

/// The choices of one suite: the same in every run, others with KOV_RANDOM_SEED.
inline test::Random choices(std::uint64_t suite) {
  return test::Random(test::number_in_environment("KOV_RANDOM_SEED", 1) + 1000 * suite);
}

/// A suite over all of them.
class OverFields : public ::testing::TestWithParam<std::size_t> {
protected:
  Field k = make(named_fields()[GetParam()]);
  test::Random random = choices(1 + GetParam());

  [[nodiscard]] long number(long low, long high) { return random.between(low, high); }
  [[nodiscard]] Rational rational(long size = 9) {
    return {Integer(number(-size, size)), Integer(number(1, size))};
  }
  [[nodiscard]] NfElem element() {
    NfElem e(k);
    for (long i = 0; i < k->degree(); ++i)
      e += NfElem(rational()) * pow(NfElem::generator(k), static_cast<unsigned long>(i));
    return coerce(e, k);
  }
  [[nodiscard]] NfElem nonzero() {
    while (true)
      if (NfElem e = element(); !is_zero(e)) return e;
  }
  /// Of degree at most n.
  [[nodiscard]] Poly poly(long n) {
    std::vector<NfElem> c;
    for (long i = number(-1, n); i >= 0; --i)
      c.push_back(element());
    return coerce(Poly::from_coefficients(c), k);
  }
  /// Of degree n exactly, leading coefficient 1.
  [[nodiscard]] Poly monic_poly(long n) {
    std::vector<NfElem> c;
    for (long i = 0; i < n; ++i)
      c.push_back(element());
    c.emplace_back(1);
    return coerce(Poly::from_coefficients(c), k);
  }
  [[nodiscard]] RationalFunction function(long n) { return {poly(n), monic_poly(number(0, n))}; }
  [[nodiscard]] Poly constant(long n) const { return coerce(Poly(n), k); }
  [[nodiscard]] Poly z() const { return coerce(Poly::z(), k); }
};

inline std::string field_name(const ::testing::TestParamInfo<std::size_t>& info) {
  return named_fields()[info.param].name;
}

} // namespace kov::testing

#define KOV_OVER_ALL_FIELDS(suite)                                                                 \
  INSTANTIATE_TEST_SUITE_P(                                                                        \
      Fields, suite, ::testing::Range<std::size_t>(0, ::kov::testing::named_fields().size()),      \
      ::kov::testing::field_name)
