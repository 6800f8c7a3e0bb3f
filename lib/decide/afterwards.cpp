#include "decide/afterwards.hpp"

#include <new>
#include <utility>

namespace kov {
namespace {

PartObserver& observer() {
  static PartObserver one;
  return one;
}

void look_at(std::string_view part) {
  if (observer()) observer()(part);
}

} // namespace

void observe_parts(PartObserver o) { observer() = std::move(o); }

std::string failure_of(std::string_view part, std::string_view why) {
  return "an error of the program in " + std::string(part) + ": " + std::string(why);
}

std::string failure_of(std::string_view part, const std::function<void()>& work) {
  try {
    look_at(part);
    work();
    look_at(part);
  } catch (const Contradiction&) {
    throw;
  } catch (const OutOfBudget&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    return failure_of(part, e.what());
  }
  return {};
}

std::string failure_or_limit_of(std::string_view part, const std::function<void()>& work) {
  try {
    return failure_of(part, work);
  } catch (const OutOfBudget& limit) {
    return std::string(part) + ": " + limit.what();
  }
}

} // namespace kov
