#include "exact/share.hpp"

namespace kov {

Budget part_of_the_work(Budget budget, double part) {
  if (part < 1 && budget.work_end && !budget.is_spent())
    budget.give(part * (*budget.work_end - meter()));
  return budget;
}

Budget at_most(Budget budget, double units) {
  if (!budget.work_end || *budget.work_end > meter() + units) budget.give(units);
  return budget;
}

} // namespace kov
