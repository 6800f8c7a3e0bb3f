#pragma once
// Elements as rational functions in the sine and the cosine of one angle.

#include "elementary/element.hpp"

namespace kov::elementary {

/// sum over monomials m without sine, cosine and 1/u of m (even + odd sin h): even and odd are rational functions in
/// cosine = cos h, in lowest terms.
struct TrigForm {
  struct Part {
    Monomial outer;
    MFraction even, odd;
  };
  Element angle; ///< h
  std::map<std::string, Part> parts;
};

/// Nothing where two angles have no common part, and where 1/u has something else in it.
[[nodiscard]] std::optional<TrigForm> trig_form(const Element& f);
/// The element again, with denominators 1/sin(h) where that is shorter.
/// Given   const auto letters = std::make_shared<Letters>("x", std::vector<std::string>{});
/// Given   const Element t(letters, letters->variable_value());
/// Example text(from_trig_form(*trig_form(sin(t) / cos(t) * sin(t + t))))  // -> 1 - cos(2*x)
[[nodiscard]] Element from_trig_form(const TrigForm& form);

} // namespace kov::elementary
