#pragma once
// Statements on roots of squares, by the classes in which one of them is.

#include "parameters/statement.hpp"

#include <utility>

namespace kov::test {

struct Kind {
  using Optional = std::optional<Classes>;
  static inline const Optional rational{}, integer{Classes{all_integers}},
      half_integer{Classes{multiples_of_a_half}}, odd_half{Classes{half_integers}};
};

inline Statement some(std::optional<Classes> classes, Squares squares,
                      bool or_all_rational = false) {
  return {SomeIn{std::move(squares), std::move(classes), or_all_rational}};
}
inline SomeIn& numbers(Statement& s) { return std::get<SomeIn>(s.says); }
inline const SomeIn& numbers(const Statement& s) { return std::get<SomeIn>(s.says); }

} // namespace kov::test
