#include "elementary/undetermined.hpp"

#include "elementary/linear_system.hpp"

#include <algorithm>
#include <set>

namespace kov::elementary {
namespace {

using Trig = Monomial::Trig;
using Kernels = std::vector<Monomial::KernelPower>;

constexpr std::size_t most_unknowns = 150, most_with_parameters = 60;

bool is_rational_with(const Element& f) {
  return std::ranges::all_of(f.terms(),
                             [](const auto& entry) {
                               const Monomial& m = *entry.second.monomial;
                               return m.trig == Trig::none && is_zero(m.exponent) &&
                                      m.powers.empty();
                             }) &&
         derivative(f).rational().has_value();
}

/// The terms with the same powers, exponential and angle.
struct Group {
  Monomial type; ///< without kernels; trig: cos where there is an angle
  Element f;
};

class Undetermined {
public:
  Undetermined(const std::vector<MFraction>& c, const Group& g)
      : letters_(g.f.letters()), c_(c), type_(g.type), f_(g.f) {
    for (const auto& [key, t] : f_.terms()) {
      long total = 0;
      for (const auto& k : t.monomial->kernels) {
        if (std::ranges::find(kernels_, k.text, &Monomial::KernelPower::text) == kernels_.end())
          kernels_.push_back(k);
        total += k.power;
      }
      kernel_degree_ = std::max(kernel_degree_, total);
      poles(t.coefficient);
      degree_ = std::max(degree_, degree(t.coefficient.num(), Letters::x) -
                                      degree(t.coefficient.den(), Letters::x));
    }
    for (const MFraction& one : c_)
      if (!is_zero(one)) poles(one / c_.back());
    for (const auto& k : kernels_)
      poles(*derivative(kernel(k)).rational());
    for (const auto& p : type_.powers)
      poles(letters_->number(1) / MFraction(p.base), 0);
  }

  static bool is_symbolic(const MFraction& f) {
    return std::ranges::any_of(used_variables(f),
                               [](std::size_t i) { return i >= Letters::first_root; });
  }

  std::optional<Element> operator()() {
    symbolic_ = std::ranges::any_of(c_, is_symbolic) ||
                std::ranges::any_of(f_.terms(), [](const auto& entry) {
                  return is_symbolic(entry.second.coefficient);
                });
    const long order = static_cast<long>(c_.size()) - 1;
    const long bound = kernels_.empty() ? 0 : kernel_degree_ + order;
    for (const long more : {order + 1, order + 5})
      for (long k = 0; k <= (poles_.empty() ? 0 : 2); ++k)
        if (auto y = attempt(kernels_, bound, more, k)) return y;
    Kernels with_logs = kernels_;
    for (const auto& [base, e] : poles_) {
      const Element ell = log(Element(letters_, MFraction(base)));
      const auto& k = ell.terms().begin()->second.monomial->kernels;
      if (k.size() == 1 && std::ranges::find(with_logs, k.front().text,
                                             &Monomial::KernelPower::text) == with_logs.end())
        with_logs.push_back(k.front());
    }
    if (with_logs.size() == kernels_.size()) return std::nullopt;
    for (long k = 0; k <= 2; ++k)
      if (auto y = attempt(with_logs, kernel_degree_ + order, order, k)) return y;
    return std::nullopt;
  }

private:
  // The places where f or the equation has a pole, and the orders of f.
  void poles(const MFraction& f, long counted = 1) {
    for (const auto& [base, e] : factor(f.den()).second) {
      if (!uses(base, Letters::x)) continue;
      const auto at = std::ranges::find(poles_, base, &MFactor::base);
      if (at == poles_.end())
        poles_.push_back({base, e * counted});
      else
        at->exponent = std::max(at->exponent, e * counted);
    }
  }

  [[nodiscard]] Element kernel(const Monomial::KernelPower& k) const {
    Element e(letters_);
    Monomial m{{}, Element(letters_), Trig::none, Element(letters_), {k}};
    m.kernels.front().power = 1;
    e.add(m, letters_->number(1));
    return e;
  }

  // The monomials of this type with these kernels, up to a total degree.
  [[nodiscard]] std::vector<Element> monomials(const Kernels& kernels, long bound) const {
    std::vector<Kernels> all{{}};
    for (const auto& k : kernels) {
      std::vector<Kernels> more;
      for (const Kernels& one : all) {
        long total = 0;
        for (const auto& p : one)
          total += p.power;
        for (long n = 0; total + n <= bound; ++n) {
          more.push_back(one);
          if (n == 0) continue;
          more.back().push_back(k);
          more.back().back().power = n;
        }
      }
      all = std::move(more);
    }
    std::vector<Element> monomials;
    for (Kernels& k : all) {
      std::ranges::sort(k, {}, &Monomial::KernelPower::text);
      Monomial m = type_;
      m.kernels = k;
      for (const Trig trig : {Trig::cos, Trig::sin}) {
        if (m.trig != Trig::none) m.trig = trig;
        Element e(letters_);
        e.add(m, letters_->number(1));
        monomials.push_back(e);
        if (m.trig == Trig::none) break;
      }
    }
    return monomials;
  }

  // Denominators: the poles of f, one order lower, as they are, and one more.
  [[nodiscard]] std::optional<Element> attempt(const Kernels& kernels, long bound, long more,
                                               long raise) const {
    MFraction d = letters_->number(1);
    for (const auto& [base, e] : poles_)
      d = d * pow(MFraction(base), std::max(e - 1 + raise, 0L));
    const long n = std::max(degree_, 0L) + more + degree(d.num(), Letters::x);
    const std::vector<Element> all = monomials(kernels, bound);
    if (all.size() * static_cast<std::size_t>(n + 1) >
        (symbolic_ ? most_with_parameters : most_unknowns))
      return std::nullopt;
    std::vector<Element> unknowns, images;
    for (const Element& m : all) {
      std::vector<Element> rates{m};
      while (rates.size() < c_.size())
        rates.push_back(derivative(rates.back()));
      for (long i = 0; i <= n; ++i) {
        std::vector<MFraction> r{pow(letters_->variable_value(), i) / d};
        while (r.size() < c_.size())
          r.push_back(derivative(r.back(), Letters::x));
        Element image(letters_);
        for (std::size_t k = 0; k < c_.size(); ++k) { // (r m)^(k)
          Integer binomial(1);
          for (std::size_t j = 0; j <= k && !is_zero(c_[k]); ++j) {
            image += (letters_->number(Rational(binomial)) * c_[k] * r[j]) * rates[k - j];
            binomial = exact_div(binomial * Integer(static_cast<long>(k - j)),
                                 Integer(static_cast<long>(j + 1)));
          }
        }
        images.push_back(image);
        unknowns.push_back(r[0] * m);
      }
    }
    const auto c = coefficients_of(f_, images);
    if (!c) return std::nullopt;
    Element y(letters_);
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      if (!is_zero((*c)[j])) y += (*c)[j] * unknowns[j];
    return y;
  }

  LettersPtr letters_;
  std::vector<MFraction> c_;
  Monomial type_;
  Element f_;
  Kernels kernels_;
  long kernel_degree_ = 0, degree_ = 0;
  std::vector<MFactor> poles_;
  bool symbolic_ = false; ///< are there letters besides x?
};

} // namespace

bool has_rational_derivatives(const Monomial& m) {
  const auto good = [](const auto& k) {
    return (k.kernel->name == Kernel::Name::log || k.kernel->name == Kernel::Name::atan) &&
           k.kernel->argument.rational().has_value();
  };
  return (is_zero(m.exponent) || is_rational_with(m.exponent)) &&
         (m.trig == Trig::none || is_rational_with(m.angle)) &&
         std::ranges::all_of(m.kernels, good);
}

std::optional<Element> undetermined(const std::vector<MFraction>& c, const Element& f) {
  const LettersPtr& letters = f.letters();
  std::map<std::string, Group> groups;
  for (const auto& [key, t] : f.terms()) {
    if (!has_rational_derivatives(*t.monomial)) return std::nullopt;
    Monomial type = *t.monomial;
    type.kernels.clear();
    if (type.trig != Trig::none) type.trig = Trig::cos;
    Element one(letters);
    one.add(type, letters->number(1));
    Group& g =
        groups.try_emplace(one.terms().begin()->first, Group{type, Element(letters)}).first->second;
    g.f.add(*t.monomial, t.coefficient);
  }
  Element y(letters);
  for (const auto& [key, g] : groups) {
    const auto part = Undetermined(c, g)();
    if (!part) return std::nullopt;
    y += *part;
  }
  return y;
}

} // namespace kov::elementary
