#pragma once
// Exact values as Python has them: int, fractions.Fraction; and ours where Python has none.

#include "decide/decide.hpp"
#include "exact/multivariate.hpp"
#include "exact/rational_function.hpp"

#include <pybind11/pybind11.h>

#include <initializer_list>
#include <string>
#include <utility>

namespace kov::python {

namespace py = pybind11;

/// A rational function with the name of its variable, which the C++ value does not know.
struct Function {
  RationalFunction f;
  std::string variable = "z";
};

[[nodiscard]] py::object to_python(const Integer& n);  ///< int
[[nodiscard]] py::object to_python(const Rational& q); ///< fractions.Fraction
[[nodiscard]] py::object to_python(const NfElem& a);   ///< Fraction, or AlgebraicNumber
/// What a letter in texts stands for: (letter, minimal polynomial, value, scale), of scale times the
/// letter; None over Q and where the text says it, as I and sqrt(2) do.
[[nodiscard]] py::object generator_of(const Field& k);
[[nodiscard]] Integer to_integer(const py::int_& n); ///< of any size

/// The text as LaTeX.
[[nodiscard]] std::string latex(const std::string& formula);

/// The class of Python (an enum.Enum) for an enumeration of ours; its members are equal and identical
/// to each other wherever they come from, and have no truth value.
template <class E> inline py::handle python_enum; // never freed: the interpreter may be gone first

/// Makes it, as a member of the module.
template <class E>
void enumeration(py::module_& m, const char* name,
                 std::initializer_list<std::pair<const char*, E>> members) {
  py::list all;
  for (const auto& [member, value] : members)
    all.append(py::make_tuple(member, static_cast<int>(value)));
  const py::object base = py::module_::import("kovacic._enums").attr("Answer");
  python_enum<E> = base(name, all, py::arg("module") = "kovacic").release();
  m.attr(name) = python_enum<E>;
}

} // namespace kov::python

namespace pybind11::detail {

/// Enumerations of ours are members of python_enum<E>; the name is for signatures.
#define KOV_PYTHON_ENUM(E, Name)                                                                   \
  template <> struct type_caster<E> {                                                              \
    PYBIND11_TYPE_CASTER(E, const_name(Name));                                                     \
    bool load(handle source, bool) {                                                               \
      if (!isinstance(source, kov::python::python_enum<E>)) return false;                          \
      value = static_cast<E>(source.attr("value").cast<int>());                                    \
      return true;                                                                                 \
    }                                                                                              \
    static handle cast(E e, return_value_policy, handle) {                                         \
      return kov::python::python_enum<E>(static_cast<int>(e)).release();                           \
    }                                                                                              \
  }
KOV_PYTHON_ENUM(kov::Truth, "Truth");
KOV_PYTHON_ENUM(kov::Unable::Why, "Why");
KOV_PYTHON_ENUM(kov::GroupType, "GroupType");
KOV_PYTHON_ENUM(kov::Connected, "Connected");
KOV_PYTHON_ENUM(kov::Argument, "Argument");
KOV_PYTHON_ENUM(kov::Trichotomy, "Trichotomy");
KOV_PYTHON_ENUM(kov::Method, "Method");

template <> struct type_caster<kov::Integer> {
  PYBIND11_TYPE_CASTER(kov::Integer, const_name("int"));
  bool load(handle source, bool) {
    if (!PyLong_Check(source.ptr()) || PyBool_Check(source.ptr())) return false;
    value = kov::python::to_integer(reinterpret_borrow<int_>(source));
    return true;
  }
  static handle cast(const kov::Integer& n, return_value_policy, handle) {
    return kov::python::to_python(n).release();
  }
};

template <> struct type_caster<kov::Rational> {
  PYBIND11_TYPE_CASTER(kov::Rational, const_name("Fraction"));
  bool load(handle source, bool) {
    if (!isinstance(source, module_::import("numbers").attr("Rational"))) return false;
    if (PyBool_Check(source.ptr())) return false;
    value = kov::Rational(kov::python::to_integer(int_(source.attr("numerator"))),
                          kov::python::to_integer(int_(source.attr("denominator"))));
    return true;
  }
  static handle cast(const kov::Rational& q, return_value_policy, handle) {
    return kov::python::to_python(q).release();
  }
};

} // namespace pybind11::detail
