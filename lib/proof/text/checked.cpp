#include "proof/text/checked.hpp"

#include <utility>

namespace kov::certify {

static thread_local std::vector<CheckedStep>* steps = nullptr;
static thread_local std::size_t files = 0;

CheckedSteps::CheckedSteps() { steps = &all_; }
CheckedSteps::~CheckedSteps() { steps = nullptr; }
CheckedSteps::File::File() { ++files; }
CheckedSteps::File::~File() { --files; }

bool CheckedSteps::wanted() { return steps != nullptr; }

void CheckedSteps::add(CheckedStep step) {
  if (steps == nullptr) return;
  step.inside = files - 1;
  steps->push_back(std::move(step));
}

void CheckedSteps::add_labels(const char* format, std::initializer_list<const char*> labels) {
  for (const char* label : labels)
    add({format, "label", label});
}

} // namespace kov::certify
