#include "elementary/trig_form.hpp"

#include "elementary/split_root.hpp"

#include <algorithm>

namespace kov::elementary {
namespace {

using Trig = Monomial::Trig;
using Name = Kernel::Name;

constexpr long most_multiple = 24;

class Converter {
public:
  explicit Converter(const Element& f) : letters_(f.letters()) {}

  std::optional<TrigForm> operator()(const Element& f) {
    if (!gather(f) || angles_.empty()) return std::nullopt;
    Integer above(0), below(1);
    for (const Element& a : angles_) {
      const auto r = ratio(a, angles_.front());
      if (!r) return std::nullopt;
      above = gcd(above * r->den(), r->num() * below);
      below = below * r->den();
      const Integer common = gcd(above, below);
      above = exact_div(above, common);
      below = exact_div(below, common);
    }
    angle_ = letters_->number(Rational(above, below)) * angles_.front();
    TrigForm form{angle_, {}};
    std::map<std::string, std::pair<Monomial, MFraction>> sums;
    for (const auto& [key, t] : f.terms()) {
      Monomial outer = *t.monomial;
      auto value = taken_out(outer);
      if (!value) return std::nullopt;
      Element single(letters_);
      single.add(outer, letters_->number(1));
      const auto at =
          sums.try_emplace(single.terms().begin()->first, outer, letters_->number(0)).first;
      at->second.second += t.coefficient * *value;
    }
    for (auto& [key, sum] : sums) {
      const auto [even, odd] = even_and_odd(sum.second);
      form.parts.emplace(key, TrigForm::Part{sum.first, even, odd});
    }
    return form;
  }

private:
  // All angles, also those inside of 1/u.
  bool gather(const Element& f) {
    for (const auto& [key, t] : f.terms()) {
      const Monomial& m = *t.monomial;
      if (m.trig != Trig::none) angles_.push_back(m.angle);
      for (const auto& k : m.kernels)
        if (k.kernel->name == Name::inverse && !gather(k.kernel->argument)) return false;
    }
    return true;
  }

  // The sines, cosines and 1/u of a monomial, which loses them.
  std::optional<MFraction> taken_out(Monomial& m) const {
    MFraction value = letters_->number(1);
    if (m.trig != Trig::none) {
      const auto n = ratio(m.angle, angle_);
      if (!n || !is_integer(*n) || abs(*n) > Rational(most_multiple)) return std::nullopt;
      value = multiple(to_long(n->num()), m.trig);
      m.trig = Trig::none;
      m.angle = Element(letters_);
    }
    std::vector<Monomial::KernelPower> others;
    for (const auto& k : m.kernels) {
      if (k.kernel->name != Name::inverse) {
        others.push_back(k);
        continue;
      }
      MFraction sum = letters_->number(0);
      for (const auto& [key, t] : k.kernel->argument.terms()) {
        Monomial inner = *t.monomial;
        const auto v = taken_out(inner);
        if (!v || !inner.powers.empty() || !is_zero(inner.exponent) || !inner.kernels.empty())
          return std::nullopt;
        sum += t.coefficient * *v;
      }
      const auto [even, odd] = even_and_odd(sum);
      if (is_zero(even) && is_zero(odd)) return std::nullopt;
      value = value / pow(sum, k.power);
    }
    m.kernels = others;
    return value;
  }

  // cos(n h) and sin(n h) by Chebyshev's recurrence.
  [[nodiscard]] MFraction multiple(long n, Trig trig) const {
    const MFraction c = MFraction::variable(letters_->ring(), Letters::cosine),
                    s = MFraction::variable(letters_->ring(), Letters::sine);
    const bool minus = n < 0 && trig == Trig::sin;
    n = std::abs(n);
    MFraction before = trig == Trig::cos ? letters_->number(1) : letters_->number(0),
              now = trig == Trig::cos ? c : s;
    if (n == 0) return before;
    for (long k = 1; k < n; ++k)
      before = std::exchange(now, letters_->number(2) * c * now - before);
    return minus ? -now : now;
  }

  [[nodiscard]] std::pair<MFraction, MFraction> even_and_odd(const MFraction& f) const {
    const MFraction c = MFraction::variable(letters_->ring(), Letters::cosine);
    auto [even, odd] = split_root(f, Letters::sine, letters_->number(1) - c * c);
    return {letters_->reduced(even), letters_->reduced(odd)};
  }

  LettersPtr letters_;
  std::vector<Element> angles_;
  Element angle_;
};

// c^n, as multiples of the angle.
Element polynomial_at(const MPoly& p, const Element& cosine) {
  Element sum(cosine.letters()), power = cosine.number(1);
  for (const MPoly& c : coefficients(p, Letters::cosine)) {
    sum += MFraction(c) * power;
    power *= cosine;
  }
  return sum;
}

Element quotient(const MFraction& f, const Element& angle, bool times_sine) {
  const LettersPtr& letters = angle.letters();
  const Element cosine = cos(angle), sine = sin(angle);
  const MPoly c = MPoly::variable(letters->ring(), Letters::cosine),
              one(letters->ring(), Integer(1));
  MPoly den = f.den();
  long sines = times_sine ? 1 : 0; // the power of sin h
  MFraction top(f.num());
  while (auto rest = divides(one - c * c, den)) {
    den = *rest;
    sines -= 2;
  }
  Element result = polynomial_at(f.num(), cosine);
  const auto [content, factors] = factor(den);
  result = (letters->number(1) / letters->number(Rational(content))) * result;
  for (const auto& [base, e] : factors)
    result *= uses(base, Letters::cosine)
                  ? pow(cosine.number(1) / polynomial_at(base, cosine), e)
                  : Element(letters, letters->number(1) / pow(MFraction(base), e));
  return result * (sines >= 0 ? pow(sine, sines) : pow(cosine.number(1) / sine, -sines));
}

} // namespace

std::optional<TrigForm> trig_form(const Element& f) {
  if (is_zero(f)) return std::nullopt;
  return Converter(f)(f);
}

Element from_trig_form(const TrigForm& form) {
  Element sum(form.angle.letters());
  for (const auto& [key, part] : form.parts) {
    Element outer(form.angle.letters());
    outer.add(part.outer, form.angle.letters()->number(1));
    sum += outer * (quotient(part.even, form.angle, false) + quotient(part.odd, form.angle, true));
  }
  return sum;
}

Element simplified(const Element& f) {
  const auto has_inverse = [](const auto& entry) {
    return std::ranges::any_of(entry.second.monomial->kernels,
                               [](const auto& k) { return k.kernel->name == Name::inverse; });
  };
  if (std::ranges::none_of(f.terms(), has_inverse)) return f;
  const auto form = trig_form(f);
  return form ? from_trig_form(*form) : f;
}

} // namespace kov::elementary
