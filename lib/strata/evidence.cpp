#include "strata/leaf.hpp"

namespace kov::strata {

Evidence::Evidence(const Evidence&) = default;
Evidence::Evidence(Evidence&&) noexcept = default;
Evidence& Evidence::operator=(const Evidence&) = default;
Evidence& Evidence::operator=(Evidence&&) noexcept = default;
Evidence::~Evidence() = default;

Leaf::Leaf() = default;
Leaf::Leaf(const Leaf&) = default;
Leaf::Leaf(Leaf&&) noexcept = default;
Leaf& Leaf::operator=(const Leaf&) = default;
Leaf& Leaf::operator=(Leaf&&) noexcept = default;
Leaf::~Leaf() = default;

} // namespace kov::strata
