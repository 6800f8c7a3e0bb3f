#pragma once
// Values as text, for the examples of the headers (tests/examples.py).
//
//   yes no, 3, "text"       bool (yes, no), numbers, strings
//   none                    an optional or pointer without a value
//   {a, b}                  pairs, tuples, containers, and structs with their members in order
//   Truth::unknown          enumerators, unless there is a to_string
//   x^2 - 1                 everything that has a to_string
//   throws DomainError      an exception of that type

#include "exact/error.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <cxxabi.h>
#include <optional>
#include <ranges>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeinfo>

namespace kov::testing {

template <class T> [[nodiscard]] std::string shown(const T& value);

namespace detail {

/// "kov::Expression::Kind::equation" -> "Kind::equation"
[[nodiscard]] inline std::string last_names(const std::string& name, int count) {
  std::size_t from = name.size();
  while (count-- > 0 && from != std::string::npos && from > 0)
    from = name.rfind("::", from - 1);
  return from == std::string::npos || from == 0 ? name : name.substr(from + 2);
}

// The compiler's name of an enumerator: "[with auto V = kov::Truth::yes]", or "(kov::Truth)7".
template <auto V> [[nodiscard]] std::string enumerator() {
  const std::string text = __PRETTY_FUNCTION__;
  const std::size_t from = text.find("V = ") + 4;
  return text.substr(from, text.find_first_of(";]", from) - from);
}

template <class E, int... values>
[[nodiscard]] std::string enumerator_of(E e, std::integer_sequence<int, values...>) {
  std::string name;
  ((static_cast<int>(e) == values ? static_cast<void>(name = enumerator<static_cast<E>(values)>())
                                  : static_cast<void>(0)),
   ...);
  return last_names(name, 2);
}

// Stands for any member while the members of a struct are counted.
struct Any {
  template <class T> operator T() const; // NOLINT(google-explicit-constructor)
};
template <class T, class... Members> [[nodiscard]] consteval std::size_t members() {
  if constexpr (requires { T{Members{}..., Any{}}; })
    return members<T, Members..., Any>();
  else
    return sizeof...(Members);
}

template <class... Members> [[nodiscard]] std::string listed(const Members&... members) {
  std::string text;
  ((text += (text.empty() ? "" : ", ") + shown(members)), ...);
  return "{" + text + "}";
}

template <class T> [[nodiscard]] std::string struct_shown(const T& value) {
  constexpr std::size_t n = members<T>();
  static_assert(1 <= n && n <= 6, "show one of its members");
  if constexpr (n == 1) {
    const auto& [a] = value;
    return listed(a);
  } else if constexpr (n == 2) {
    const auto& [a, b] = value;
    return listed(a, b);
  } else if constexpr (n == 3) {
    const auto& [a, b, c] = value;
    return listed(a, b, c);
  } else if constexpr (n == 4) {
    const auto& [a, b, c, d] = value;
    return listed(a, b, c, d);
  } else if constexpr (n == 5) {
    const auto& [a, b, c, d, e] = value;
    return listed(a, b, c, d, e);
  } else {
    const auto& [a, b, c, d, e, f] = value;
    return listed(a, b, c, d, e, f);
  }
}

template <class T> [[nodiscard]] std::string tuple_shown(const T& value) {
  return std::apply([](const auto&... members) { return listed(members...); }, value);
}

template <class T>
concept Optional = requires(const T& t) {
  *t;
  static_cast<bool>(t);
};

} // namespace detail

template <class T> std::string shown(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "yes" : "no";
  } else if constexpr (std::is_convertible_v<T, std::string_view>) {
    return std::string(std::string_view(value));
  } else if constexpr (requires {
                         { to_string(value) } -> std::convertible_to<std::string>;
                       }) {
    return to_string(value);
  } else if constexpr (std::is_enum_v<T>) {
    return detail::enumerator_of(value, std::make_integer_sequence<int, 40>());
  } else if constexpr (std::is_arithmetic_v<T>) {
    std::ostringstream out;
    out << value;
    return out.str();
  } else if constexpr (std::ranges::range<const T>) {
    std::string text;
    for (const auto& member : value)
      text += (text.empty() ? "" : ", ") + shown(member);
    return "{" + text + "}";
  } else if constexpr (detail::Optional<T>) {
    return value ? shown(*value) : "none";
  } else if constexpr (requires { std::tuple_size<T>::value; }) {
    return detail::tuple_shown(value);
  } else {
    return detail::struct_shown(value);
  }
}

/// What an example shows: its value, or the type of its exception with the message.
template <class Compute> [[nodiscard]] std::string outcome(const Compute& compute) {
  try {
    if constexpr (std::is_void_v<decltype(compute())>)
      return compute(), "done";
    else
      return shown(compute());
  } catch (const std::exception& e) {
    char* name = abi::__cxa_demangle(typeid(e).name(), nullptr, nullptr, nullptr);
    const std::string type = detail::last_names(name, 1);
    std::free(name); // NOLINT(cppcoreguidelines-no-malloc)
    return "throws " + type + ": " + e.what();
  }
}

/// The test of one example.  After "throws DomainError" the message may be left out.
template <class Compute>
void example(const char* file, int line, const Compute& compute, const std::string& expected) {
  const std::string found = outcome(compute);
  const bool thrown = expected.starts_with("throws ") && found.starts_with(expected + ": ");
  if (found != expected && !thrown)
    ADD_FAILURE_AT(file, line) << "the example gives\n  " << found << "\nand says\n  " << expected;
}

} // namespace kov::testing
