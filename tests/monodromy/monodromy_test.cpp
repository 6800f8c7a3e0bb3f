#include "monodromy/monodromy.hpp"

#include "symbol/rational_form.hpp"

#include <gmock/gmock.h>

namespace {
using namespace kov;
using namespace kov::monodromy;
} // namespace
