#include "exact/chinese_lift.hpp"

#include "exact/error.hpp"

namespace kov {

ChineseLift::ChineseLift(Field k, std::size_t count)
    : k_(std::move(k)), count_(count),
      coordinates_(count * static_cast<std::size_t>(k_->degree())) {}

void ChineseLift::add(const std::vector<PrimeIdeal>& ideals,
                      const std::vector<std::vector<mp_limb_t>>& residues) {
  const auto d = static_cast<std::size_t>(k_->degree());
  KOV_ENSURE(ideals.size() == d && residues.size() == d);
  const mp_limb_t p = ideals.front().p;
  std::vector<mp_limb_t> at(d);
  std::vector<mp_limb_t> values(d);
  for (std::size_t i = 0; i < d; ++i)
    at[i] = ideals[i].generator;
  NmodPoly element(p);
  for (std::size_t j = 0; j < count_; ++j) {
    for (std::size_t i = 0; i < d; ++i)
      values[i] = residues[i].at(j);
    if (d == 1)
      element.set_coeff(0, values[0]); // a is rational there, whatever its image
    else
      nmod_poly_interpolate_nmod_vec(element.raw(), at.data(), values.data(),
                                     static_cast<slong>(d));
    for (std::size_t i = 0; i < d; ++i) {
      Integer& x = coordinates_[j * d + i];
      fmpz_CRT_ui(x.raw(), x.raw(), modulus_.raw(), element.coeff(static_cast<long>(i)), p, 0);
    }
    nmod_poly_zero(element.raw());
  }
  modulus_ *= Integer(p);
  ++primes_;
}

std::optional<std::vector<NfElem>> ChineseLift::reconstruct() const {
  const auto d = static_cast<std::size_t>(k_->degree());
  std::vector<NfElem> elements;
  elements.reserve(count_);
  for (std::size_t j = 0; j < count_; ++j) {
    NfElem e(k_);
    for (std::size_t i = 0; i < d; ++i) {
      const auto q = rational_reconstruction(coordinates_[j * d + i], modulus_);
      if (!q) return std::nullopt;
      fmpq_poly_set_coeff_fmpq(e.raw(), static_cast<slong>(i), q->raw());
    }
    elements.push_back(std::move(e));
  }
  return elements;
}

bool worth_a_try(std::size_t primes) noexcept {
  while (primes > 4 && primes % 2 == 0)
    primes /= 2;
  return primes <= 4;
}

} // namespace kov
