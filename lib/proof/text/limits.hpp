#pragma once
// Sizes above which a certificate is refused: they keep hostile input from running for ever.  The
// Python checker has the same numbers.

#include "exact/poly.hpp"

#include <cstddef>

namespace kov::certify {

inline constexpr std::size_t max_length = 200001; ///< coefficients of a polynomial
inline constexpr std::size_t max_steps = 1000;
inline constexpr std::size_t max_places = 20000;
inline constexpr double max_work = 4e9;   ///< elementary operations of one series or p-curvature
inline constexpr double max_total = 2e10; ///< elementary operations of all steps
inline constexpr double max_bulk = 4e9;   ///< bits: longest polynomial times largest coefficient
inline constexpr double max_matrix = 2e7; ///< entries
inline constexpr std::size_t max_text = std::size_t{1} << 28;
inline constexpr long max_sym = 200;       ///< m of Sym^m
inline constexpr long max_irregular = 200; ///< nu of a pole of order 2 nu

// Certificates over strata (strata_certificates.md 2).
inline constexpr std::size_t max_terms = 20000;      ///< of a polynomial that is read
inline constexpr std::size_t max_digits = 10000;     ///< of its coefficients
inline constexpr unsigned long max_exponent = 10000; ///< the same, exclusive
inline constexpr std::size_t max_nodes = 10000;
inline constexpr int max_node_depth = 64;
inline constexpr std::size_t max_parameters = 12;
inline constexpr mp_limb_t max_lemma_prime = 10000; ///< exclusive
inline constexpr long max_multiple = 1000000;       ///< of a membership
inline constexpr long max_unknowns = 40;            ///< of a linear system
inline constexpr double max_products = 1e8;         ///< term by term, of the whole run
inline constexpr double max_word_work = 4e9;     ///< the same, times the words of the coefficients
inline constexpr double max_result = 1e7;        ///< words of one polynomial that is computed
inline constexpr double max_number = 15625;      ///< words of the number below a fraction
inline constexpr long max_degree = 1000000;      ///< of a polynomial that is computed
inline constexpr double work_of_a_rational = 20; ///< one exponent, in products
inline constexpr std::size_t max_sums = 4000;    ///< of exponents

// Certificates of the whole way (system_certificates.md 2).
inline constexpr std::size_t max_phase_names = 64;
inline constexpr std::size_t max_coordinates = 40;
inline constexpr std::size_t max_tower = 32;
inline constexpr unsigned long max_curve_degree = 64; ///< of the function field over K(z)
inline constexpr unsigned long max_power = 1000;      ///< of a denominator
inline constexpr std::size_t max_denominators = 200;
inline constexpr std::size_t max_annihilators = 40;

// Certificates of matrices of loops (loop_certificates.md 2).
inline constexpr std::size_t max_loop_size = 8;
inline constexpr long max_loop_degree = 100;
inline constexpr long max_loop_bits = 8192;
inline constexpr std::size_t max_loops = 16;
inline constexpr std::size_t max_loop_points = 2000;
inline constexpr std::size_t max_loop_letters = 12;
inline constexpr long max_loop_power = 1000;
inline constexpr std::size_t max_loop_factors = 40;
inline constexpr ulong max_coordinate_bits = 400;
inline constexpr double max_loop_work = 1e11; ///< bits that are multiplied

// Certificates of higher variational equations (jet_certificates.md 2).
inline constexpr std::size_t max_jet_parameters = 6;
inline constexpr long max_turns = 100;
inline constexpr long max_order = 12;
inline constexpr long max_jet_terms = 2000;
inline constexpr std::size_t max_jet_cofactor = 100; ///< coefficients of a polynomial in y
inline constexpr double work_of_an_element = 750;    ///< one product in a series, in products
inline constexpr double work_of_its_term = 75;
inline constexpr long max_jet_power = 20;  ///< of a minor
inline constexpr long max_jet_degree = 40; ///< of a potential

// Certificates of homoclinic points (chaos.md 6).
inline constexpr long max_homoclinic_terms = 200; ///< of a polynomial, exclusive
inline constexpr long max_homoclinic_degree = 16; ///< in each variable
inline constexpr long max_homoclinic_period = 64;
inline constexpr long max_homoclinic_points = 400; ///< of the orbit, times the period
inline constexpr double max_homoclinic_work = 4e9; ///< products of intervals

/// Bits of the largest coefficient: of the numerators over a common denominator, and of that.
[[nodiscard]] inline double bits(const Poly& f) {
  const auto top = std::abs(_fmpz_vec_max_bits(f.raw()->coeffs, f.raw()->length));
  return static_cast<double>(top) + static_cast<double>(fmpz_bits(f.raw()->den));
}

} // namespace kov::certify
