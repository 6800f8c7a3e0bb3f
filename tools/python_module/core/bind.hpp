#pragma once
// The parts of the module, and what they share.

#include "computation.hpp"
#include "values.hpp"

#include <initializer_list>

namespace kov::python {

void bind_errors(py::module_& m);
void bind_values(py::module_& m);
void bind_equation(py::module_& m);
void bind_strata(py::module_& m);
void bind_spectrum(py::module_& m);
void bind_system(py::module_& m);
void bind_motion(py::module_& m);
void bind_classification(py::module_& m);
void bind_theorem(py::module_& m);
void bind_numerics(py::module_& m);
void bind_sections(py::module_& m);

/// A class whose values only the library makes, so that a verdict cannot be written by hand, and
/// whose truth is not asked with `if`.  names: what `case Type(...)` takes by position.
template <class T, class... Options>
py::class_<T, Options...> read_only(py::module_& m, const char* name, const char* documentation,
                                    std::initializer_list<const char*> names = {}) {
  py::class_<T, Options...> type(m, name, documentation);
  py::tuple positions(names.size());
  std::size_t i = 0;
  for (const char* n : names)
    positions[i++] = n;
  type.attr("__match_args__") = positions;
  type.def("__bool__", [name = std::string(name)](const T&) -> bool {
    throw py::type_error("a " + name +
                         " is not a truth value; ask for its .abelian, .verdict, ...");
  });
  return type;
}

} // namespace kov::python
