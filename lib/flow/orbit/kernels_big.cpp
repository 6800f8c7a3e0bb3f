// The kernels over MPFR.
#include "exact/error.hpp"
#include "flow/number/big_real.hpp"
#include "flow/orbit/kernel_table.hpp"

#include <vector>

namespace kov::flow {

void integrate(const Effects& e, const Model<BigReal>& model, bool sliding,
               const Run<BigReal>& run) {
  const std::size_t set = effect_index(e);
  if (set == effect_sets.size()) throw InvalidArgument("this set of effects is not compiled");
  if (run.order < 4 || run.order > max_degree)
    throw InvalidArgument("the order of the Taylor steps must be 4 to " +
                          std::to_string(max_degree) + ", not " + std::to_string(run.order));
  std::vector<BigReal> storage(storage_size<BigReal>(run.order));
  integrate_with<BigReal>(set, model, sliding, run, storage.data());
}

} // namespace kov::flow
