#pragma once
// The lowest-order system of a family: theorem_certificates.md 7.

#include "certify/theorem/family.hpp"

namespace kov::certify {

/// Refuses unless Y is the lowest-order system of X.
void need_lowest_order(const Family& x, const Family& y, Keys& data, Arithmetic& a,
                       std::size_t& nodes_left);

/// Conditions on the parameters of Y with the names of X.
[[nodiscard]] Conditions renamed(const Conditions& of_y, const Family& x);

} // namespace kov::certify
