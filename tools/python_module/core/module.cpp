// One family of exceptions: kovacic.Error.  An InputError shows the line with the caret.

#include "bind.hpp"
#include "equation/read_equation.hpp"
#include "symbol/input_error.hpp"

namespace kov::python {
namespace {

void set(const char* name, const py::object& argument) {
  const py::object type = py::module_::import("kovacic._errors").attr(name);
  PyErr_SetObject(type.ptr(), argument.ptr());
}

// Bytes of any kind become text.
py::str text(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace"));
}

void set_input_error(const InputError& e) {
  const py::object type = py::module_::import("kovacic._errors").attr("InputError");
  const py::object error = type(text(render(e)), text(e.file()), e.line(), e.column(), e.length(),
                                text(e.message()), text(e.hint()), text(e.source_line()));
  PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& e) {
    set_input_error(e);
  } catch (const FreeParameters& e) {
    set("FreeParameters", text(e.what()));
  } catch (const InvalidArgument& e) {
    set("InvalidArgument", text(e.what()));
  } catch (const DomainError& e) {
    set("DomainError", text(e.what()));
  } catch (const OutOfBudget& e) {
    set("OutOfBudget", text(e.what()));
  } catch (const InternalError& e) {
    set("InternalError", text(e.what()));
  } catch (const Error& e) {
    set("Error", text(e.what()));
  }
}

} // namespace

void bind_errors(py::module_&) { py::register_local_exception_translator(&translate); }

} // namespace kov::python

PYBIND11_MODULE(_core, m) {
  m.doc() = "The compiled part of kovacic; import kovacic instead.";
  kov::python::bind_errors(m);
  kov::python::bind_values(m);
  kov::python::bind_equation(m);
  kov::python::bind_strata(m);
  kov::python::bind_spectrum(m);
  kov::python::bind_system(m);
  kov::python::bind_motion(m);
  m.attr("version") = KOV_VERSION;
  kov::python::bind_classification(m);
  kov::python::bind_theorem(m);
  kov::python::bind_numerics(m);
  kov::python::bind_sections(m);
}
