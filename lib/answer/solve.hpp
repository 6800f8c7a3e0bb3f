#pragma once
// The driver for one equation: which equation is decided, with numbers or for all values of its parameters, and what is
// made of the answer.  Every command and the Python module ask here, and only show what they get.

#include "answer/answer.hpp"
#include "closed/generic_form.hpp"
#include "equation/question.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kov::answer {

// ----- numbers

/// The equation y'' = r y that is decided for a given one.
struct Decidable {
  NormalForm form;
  std::string variable;   ///< as it is printed: z, or (z - c)
  RationalFunction gauge; ///< -p/2 of the given equation, in this variable
};
[[nodiscard]] Decidable in_its_variable(const GivenEquation& equation);
/// In z - c, where the equation is over a smaller field there or its numbers are small.
[[nodiscard]] Decidable in_small_numbers(const GivenEquation& equation);

/// The decision, and the certificate of what only a formula decides.
/// Given   EquationText airy_text;
/// Given   airy_text.r = parse_expression("x", "-r"), airy_text.variable = "x";
/// Example decided(in_its_variable(read_equation(airy_text)), {}).abelian  // -> Truth::no
[[nodiscard]] Decision decided(const Decidable& equation, Options options);

/// exp(-1/2 int p), by which solutions of y'' = r y are multiplied: unevaluated where a limit is reached.
struct GaugeFactor {
  enum class Kind : std::uint8_t { unknown, rational, algebraic, transcendental };
  std::string text;
  Kind kind = Kind::unknown;
};
[[nodiscard]] GaugeFactor factor_of(const GivenEquation& equation, const Budget& budget);

/// The equation with its right side, its initial values, or in the unknown of Riccati's; each formula is read back.
/// shown: solutions of the homogeneous equation.
/// Requires  asked.whole
[[nodiscard]] elementary::WholeAnswer whole_of(const AskedEquation& asked,
                                               const std::vector<Expression>& shown);

/// A classical equation by its formula and by the engines.
struct DecidedTwice {
  ClosedAnswer closed;
  Decision decision;
  [[nodiscard]] Truth abelian() const;
  [[nodiscard]] std::optional<GaloisGroup> group() const;
};
/// Throws  Contradiction: one of the two proofs is wrong
[[nodiscard]] DecidedTwice decided_twice(ClosedAnswer closed, const RationalFunction& r,
                                         const Options& options);
/// Throws  Contradiction
void ensure_agreement(const ClosedAnswer& closed, const Decision& decision);

// ----- all values of the parameters

/// The answer for a part of the parameters.
struct FamilyPart {
  EquationPart part;
  std::optional<Given> given{};                 ///< the equation there
  std::optional<strata::StrataAnswer> answer{}; ///< unset: there is no equation, or it is not known
  std::optional<FamilySolutions> solutions{};
  std::string failed{}; ///< what went wrong in the search for solutions: an error of ours
};

/// An equation with parameters.  Parts that the assumptions exclude are left out, unless nothing else is there.
struct Family {
  std::vector<FamilyPart> parts;
  bool whole = false;                         ///< there are no others
  bool first_is_left_out = false;             ///< that in which a change of variable is made
  std::optional<strata::GenericForm> known{}; ///< the classical equation that the first part is

  /// The strata of all parts that have an answer, on its domain.
  [[nodiscard]] std::vector<strata::Stratum> strata() const;
  /// Was each value of the parameters looked at?
  [[nodiscard]] bool is_complete() const;
  /// yes, no: for all values; unknown: not decided, or not for all the same.
  [[nodiscard]] Truth abelian() const;
  /// The group, where it is one for all values.
  [[nodiscard]] std::optional<GaloisGroup> group() const;
  [[nodiscard]] const std::string& refusal() const; ///< of our own checker; "" for none
};

/// solutions: unset where nobody asks for them.  told: called when a part is decided, before its solutions.
/// Errors  as read_parts
[[nodiscard]] Family decide_family(const EquationText& text, strata::StrataLimits limits,
                                   const std::optional<Style>& solutions = {},
                                   const std::function<void(const Family&)>& told = {});

/// "a != 0, b = 0"
[[nodiscard]] std::string in_words(const EquationPart& part);

} // namespace kov::answer
