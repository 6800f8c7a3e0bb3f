#pragma once
// Enumerations of lib/flow as those of Python.

#include "values.hpp"

#include "flow/chaos/periodic_orbit.hpp"

namespace pybind11::detail {
KOV_PYTHON_ENUM(kov::flow::Ended, "Ended");
KOV_PYTHON_ENUM(kov::flow::Stability, "Stability");
} // namespace pybind11::detail
