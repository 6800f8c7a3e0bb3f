#include "closed/number_answers.hpp"

#include "closed/criterion.hpp"

#include <functional>

namespace kov {
namespace {

// Every statement is decided, so that there is one answer.  The variables of
// the ring are the squares.
class NumberAsker {
public:
  explicit NumberAsker(std::vector<NfElem> squares)
      : holds_([this](const Assertion& s) {
          return is_so({s}, [this](const MFraction& f) { return value(f); });
        }),
        squares_(std::move(squares)) {}
  explicit NumberAsker(const Poly& three)
      : holds_([&three](const Assertion& s) { return is_so_of_three(s, three); }),
        rational_(rational_roots(three)) {}
  NumberAsker(const NumberAsker&) = delete;
  NumberAsker& operator=(const NumberAsker&) = delete;

  [[nodiscard]] static MFraction square(std::size_t i) {
    static const Ring ring = make_ring({"l", "m", "n"});
    return MFraction::variable(ring, i);
  }

  template <class Yes, class No> void split(const Assertion& s, Yes yes, No no) const {
    known(s) == Truth::yes ? yes() : no();
  }
  [[nodiscard]] Truth known(const Assertion& s) const {
    if (const auto* all = std::get_if<AllRational>(&s)) // also of some of three
      return truth(
          std::ranges::all_of(all->squares, [&](const auto& x) { return root(x).has_value(); }));
    return truth(holds_(s));
  }
  [[nodiscard]] std::optional<Rational> root(const MFraction& x) const {
    if (!squares_.empty()) {
      const NfElem v = value(x);
      return is_rational(v) ? exact_sqrt(to_rational(v)) : std::nullopt;
    }
    const std::size_t i = used_variables(x).front();
    return i < rational_.size() ? exact_sqrt(rational_[i]) : std::nullopt;
  }
  [[nodiscard]] static bool varies(const MFraction& /*square*/) { return false; }

  void add(GroupType type, std::optional<Integer> n, const char* reason) {
    answer = ClosedAnswer::of({type, std::move(n)}, reason);
  }
  void add(Truth abelian, strata::GroupBound /*bound*/, const char* reason) {
    answer = {std::nullopt, abelian, reason};
  }

  ClosedAnswer answer;

private:
  // A multiple of one square.
  [[nodiscard]] NfElem value(const MFraction& f) const {
    const std::size_t i = used_variables(f).front();
    return squares_[i] * NfElem(to_rational(f / square(i)));
  }

  std::function<bool(const Assertion&)> holds_;
  std::vector<NfElem> squares_;    ///< empty: three that are known together
  std::vector<Rational> rational_; ///< the first of those three
};

ClosedAnswer asked(NumberAsker& three) {
  strata::RiemannCriterion({NumberAsker::square(0), NumberAsker::square(1), NumberAsker::square(2)},
                           three)
      .run();
  const auto& group = three.answer.group;
  if (group && group->n && (group->type == GroupType::cyclic || group->type == GroupType::T))
    three.answer.reason += "; its radical order is " + to_string(*group->n);
  return std::move(three.answer);
}

} // namespace

ClosedAnswer riemann_answer(const SquaredExponents& s) {
  NumberAsker three(std::vector<NfElem>(s.begin(), s.end()));
  return asked(three);
}

ClosedAnswer riemann_answer(const Poly& squares) {
  NumberAsker three(squares);
  return asked(three);
}

ClosedAnswer euler_answer(const NfElem& square) {
  NumberAsker one(std::vector<NfElem>{square});
  strata::euler_criterion(one, NumberAsker::square(0));
  return std::move(one.answer);
}

ClosedAnswer whittaker_answer(const NfElem& k_squared, const NfElem& m_squared) {
  NumberAsker two(std::vector<NfElem>{k_squared, m_squared});
  strata::whittaker_criterion(two, NumberAsker::square(0), NumberAsker::square(1));
  return std::move(two.answer);
}

ClosedAnswer ramified_bessel_answer(const NfElem& m_squared) {
  NumberAsker one(std::vector<NfElem>{m_squared});
  strata::ramified_bessel_criterion(one, NumberAsker::square(0));
  return std::move(one.answer);
}

ClosedAnswer polynomial_answer(const Poly& r) {
  std::vector<NfElem> c;
  for (long i = 0; i <= degree(r); ++i)
    c.push_back(r.coeff(i));
  const bool even = degree(r) > 0 && degree(r) % 2 == 0;
  NumberAsker one(std::vector<NfElem>{even ? strata::exponent_squared(c) : NfElem(0)});
  strata::polynomial_criterion(one, degree(r), NumberAsker::square(0));
  return std::move(one.answer);
}

} // namespace kov
