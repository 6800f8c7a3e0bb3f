#include "equations/known_basis.hpp"

#include "elementary/homogeneous.hpp"
#include "elementary/read.hpp"
#include "exact/tried.hpp"

namespace kov::cli {

std::optional<elementary::Basis> known_basis(const std::vector<Expression>& shown,
                                             const Decision& decision,
                                             const RationalFunction& gauge, bool is_in_its_variable,
                                             const elementary::LettersPtr& letters) {
  using elementary::Basis;
  std::optional<Basis> basis;
  if (shown.size() == 2)
    basis = tried<elementary::NotElementary>([&] {
      return std::optional(
          Basis{elementary::element(shown[0], letters), elementary::element(shown[1], letters)});
    });
  if (!basis && decision.proof() != nullptr && is_in_its_variable)
    basis = elementary::basis_from(*decision.proof(), decision.solutions, gauge, letters);
  return basis;
}

} // namespace kov::cli
