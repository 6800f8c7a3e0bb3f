#pragma once
// The finite singularities of a system: exact (a root of an irreducible polynomial), and isolated.

#include "exact/budget.hpp"
#include "monodromy/differential_system.hpp"

#include <string>
#include <vector>

namespace kov::monodromy {

struct SingularPoint {
  Poly factor;    ///< monic irreducible over K; the point is one of its roots
  ComplexBall at; ///< contains this root of it and no other
};

/// The poles of A, one for each root, disjoint, with about `bits` bits each.
/// Cost   one factorisation of the common denominator
/// Errors OutOfBudget
[[nodiscard]] std::vector<SingularPoint> singular_points(const DifferentialSystem& s, long bits,
                                                         const Budget& budget = {});

/// "-5", "1/2*a", or "root(z^3 - 2, -0.629961 + 1.09112*I)".
[[nodiscard]] std::string to_string(const SingularPoint& p, const std::string& variable = "z",
                                    long digits = 10);

/// The roots of a squarefree polynomial over K under its embedding, disjoint.
[[nodiscard]] std::vector<ComplexBall> embedded_roots(const Poly& f, long bits);

} // namespace kov::monodromy
