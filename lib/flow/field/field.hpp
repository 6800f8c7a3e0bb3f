#pragma once
// A system made ready for the integration: its field and section function as programs.

#include "flow/field/field_stepper.hpp"
#include "flow/field/program.hpp"
#include "flow/number/quantity.hpp"

#include <functional>
#include <memory>

namespace kov::flow {

/// q in R, to the last bit.
template <class R> [[nodiscard]] R number_as(const Rational& q);
template <> double number_as<double>(const Rational& q);
template <> long double number_as<long double>(const Rational& q);
template <> Twin1 number_as<Twin1>(const Rational& q);
template <> BigReal number_as<BigReal>(const Rational& q);

/// The numbers of a system without a rational value: parameters such as sqrt(2), algebraic constants.
using Values = std::map<std::size_t, Quantity>; ///< by variable of the ring

/// The part of a register that is read: the coefficient of the present order, that of order 0, or
/// the whole series.
enum class Room : std::uint8_t { present, first, whole };

class Field {
public:
  /// Errors  OutOfBudget: too large;  InvalidArgument: a parameter has no value
  /// needed: functions that an Evaluator will be asked for; tangent: with the first variational equation; written:
  /// how the file writes some functions.
  Field(const System& s, const MFraction& section, const std::vector<MFraction>& needed,
        const Values& values, bool tangent, const Graph* written = nullptr);

  [[nodiscard]] std::size_t coordinates() const noexcept { return motion_.coordinates; }
  /// Coordinates, then function symbols: as variables of the ring.
  [[nodiscard]] const std::vector<std::size_t>& variables() const noexcept {
    return motion_.variables;
  }
  [[nodiscard]] std::size_t tangent() const noexcept { return motion_.tangent.size(); }
  /// Parameters without a rational value, as variables of the ring: in the order of their numbers.
  [[nodiscard]] const std::vector<std::size_t>& numbers() const noexcept { return numbers_; }
  /// Products of series in an order (a square counts half).
  [[nodiscard]] double cost() const { return products(motion_.graph, motion_.series_roots()); }
  [[nodiscard]] const Motion& motion() const noexcept { return motion_; }

private:
  template <class R> friend class Tapes;
  template <class R> friend class Evaluator;
  friend class TermSize;
  void look_at_reads(const Program& p);
  Motion motion_;
  std::vector<std::size_t> numbers_; ///< parameters and constants that have a value here
  Values values_;
  std::unique_ptr<Registers> registers_, point_registers_;
  std::vector<Room> rooms_; ///< of each register
  Program field_, section_, section_at_;
  // The field's nodes stop one order before the last: what the section needs of them there, and what follows a rule.
  Program last_, followers_;
  std::vector<std::uint32_t>
      moving_;          ///< which variables have a derivative, with the tangent vector
  bool curved_ = false; ///< the section is not a linear function of the variables
};

/// The programs for steps of one order, with numbers of one type.  Refers to nothing outside of itself.
template <class R> class Tapes {
public:
  /// otherwise_rounded: numbers that R does not have are those on the other side of the rounding.
  Tapes(const Field& f, int order, bool otherwise_rounded = false);
  [[nodiscard]] const FieldTapes<R>& tapes() const noexcept { return tapes_; }
  [[nodiscard]] const R* values() const noexcept { return values_.data(); }
  Tapes(const Tapes&) = delete;
  Tapes& operator=(const Tapes&) = delete;

private:
  struct Kept {
    std::vector<Instruction> once, each;
    std::vector<SumTerm> terms;
    std::vector<R> numbers;
    using Place = std::function<std::uint32_t(std::uint32_t)>; ///< of a register
    Tape<R> tape(const Program& p, const Place& place, bool otherwise_rounded);
  };
  Kept field_, section_, section_at_, last_, followers_;
  std::vector<std::uint32_t> moving_, derivatives_;
  std::vector<LowPart> low_parts_;
  std::vector<R> values_;
  FieldTapes<R> tapes_;
};

/// Functions of the variables at a point: f_1(x), f_2(x), ...
template <class R> class Evaluator {
public:
  Evaluator(const Field& f, const std::vector<MFraction>& functions);
  /// x: the values of f.variables(), in their order.
  [[nodiscard]] const std::vector<R>& operator()(const R* x);
  /// Other values of f.numbers(), in their order.
  void set(const R* numbers);

private:
  std::vector<Instruction> once_, code_;
  std::vector<SumTerm> terms_;
  std::vector<R> numbers_, registers_, results_;
  std::vector<std::uint32_t> outputs_;
  std::size_t inputs_ = 0, given_ = 0; ///< variables, numbers
};

/// The size of the terms of a function at a point: (|c_1 x^e_1| + |c_2 x^e_2| + ...)/|denominator|.  Rounding leaves
/// units of it, however much the terms cancel.
class TermSize {
public:
  TermSize(const Field& f, const MFraction& function);
  /// x: the values of f.variables(), in their order.  least: |x_i| counts as least_i at least, in the numerator.
  [[nodiscard]] double operator()(const double* x, const double* least = nullptr);
  /// Other values of f.numbers(), in their order.
  void set(const double* numbers);

private:
  struct Term {
    double rational, coefficient;                      ///< coefficient: with the numbers
    std::vector<std::pair<std::size_t, long>> numbers; ///< place in f.numbers(), exponent
    std::vector<std::pair<std::size_t, long>> powers;  ///< place in x, exponent
  };
  static std::vector<Term> terms_of(const Field& f, const MPoly& p);
  std::vector<Term> num_;
  Evaluator<double> denominator_;
};

} // namespace kov::flow
