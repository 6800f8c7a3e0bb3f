#include "elementary/element.hpp"

#include "elementary/split_root.hpp"

#include "exact/joined.hpp"
#include "exact/letters.hpp"

#include <algorithm>
#include <set>

namespace kov::elementary {
namespace {

using Trig = Monomial::Trig;
using Name = Kernel::Name;

constexpr long most_terms = 400;
constexpr long most_power = 60;

std::vector<std::string> names_of(const std::string& variable,
                                  const std::vector<std::string>& parameters) {
  std::vector<std::string> all{variable, "sine'", "cosine'"}; // no name of a question has a prime
  for (std::size_t i = 0; i < Letters::max_roots; ++i)
    all.push_back("root" + std::to_string(i) + "'");
  all.insert(all.end(), parameters.begin(), parameters.end());
  return all;
}

// a*x*sqrt(2): parameters stand first.
std::vector<std::string> printed_order(std::vector<std::string> names) {
  std::ranges::rotate(names, names.begin() + static_cast<long>(Letters::first_parameter));
  return names;
}

bool is_atom(const std::string& s) { return s.find_first_of("+-*/^ ") == std::string::npos; }

// Is it a sum, outside of all parentheses?
bool is_sum(const std::string& s) {
  long depth = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    depth += s[i] == '(' ? 1 : s[i] == ')' ? -1 : 0;
    if (depth == 0 && i > 0 && (s[i] == '+' || s[i] == '-') && s[i - 1] != '^') return true;
  }
  return false;
}

bool is_product(const std::string& s) {
  long depth = 0;
  for (const char c : s) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (depth == 0 && (c == '*' || c == '/')) return true;
  }
  return false;
}

std::string factor_text(const std::string& s) {
  return is_sum(s) || s.front() == '-' ? "(" + s + ")" : s;
}
std::string below_text(const std::string& s) {
  return is_product(s) || is_sum(s) ? "(" + s + ")" : s;
}

Rational value_at_zero(const MFraction& f) {
  Substitution zeros;
  for (std::size_t i = 0; i < f.ring()->size(); ++i)
    zeros[i] = MFraction(f.ring(), Rational(0));
  try {
    return to_rational(substitute(f, zeros));
  } catch (const DomainError&) {
    return 0;
  }
}

bool is_small_integer(const MFraction& c) {
  return is_constant(c) && is_integer(to_rational(c)) &&
         abs(to_rational(c)) <= Rational(most_power);
}
bool is_half(const MFraction& c) { return is_constant(c) && to_rational(c) == Rational(1, 2); }

} // namespace

// ----- letters

Letters::Letters(const std::string& variable, const std::vector<std::string>& parameters,
                 const std::string& pi)
    : ring_(make_ring(names_of(variable, parameters))),
      printed_(make_ring(printed_order(ring_->names()))), pi_(ring_->find(pi)) {}

MFraction Letters::root(const MFraction& radicand) {
  if (is_zero(radicand)) return radicand;
  if (uses(radicand, x)) throw NotElementary("a root of a function");
  // n/d = n d/d^2, and squares stand outside
  MPoly inside(ring_, Integer(1));
  MFraction outside = number(1);
  const auto [content, factors] = factor(radicand.num() * radicand.den());
  const auto [square, rest] = square_part(content);
  outside = number(Rational(square)) / MFraction(radicand.den());
  inside *= MPoly(ring_, rest);
  for (const auto& [base, e] : factors) {
    outside *= pow(MFraction(base), e / 2);
    if (e % 2 != 0) inside *= base;
  }
  const MFraction under(inside);
  if (is_one(under)) return outside;
  const auto at = std::ranges::find(radicands_, under);
  const auto i = static_cast<std::size_t>(at - radicands_.begin());
  if (at == radicands_.end()) {
    if (radicands_.size() == max_roots) throw NotElementary("too many square roots");
    radicands_.push_back(under);
  }
  return outside * MFraction::variable(ring_, first_root + i);
}

MFraction Letters::reduced(MFraction f) const {
  for (std::size_t i = radicands_.size(); i-- > 0;) {
    const std::size_t r = first_root + i;
    if (!uses(f, r)) continue;
    const auto [a, b] = split_root(f, r, radicands_[i]);
    f = a + b * MFraction::variable(ring_, r);
  }
  return f;
}

std::string Letters::text(const MFraction& f) const {
  const MFraction ordered = transfer(f, printed_);
  std::string s =
      uses(f, x) ? to_string_by_powers(ordered, printed_->index(variable())) : to_string(ordered);
  for (std::size_t i = 0; i < radicands_.size(); ++i) {
    if (!uses(f, first_root + i)) continue;
    const std::string name = ring_->name(first_root + i), under = text(radicands_[i]),
                      meaning = under == "-1" ? "I" : "sqrt(" + under + ")";
    for (std::size_t at = s.find(name); at != std::string::npos;
         at = s.find(name, at + meaning.size()))
      s.replace(at, name.size(), meaning);
  }
  return s;
}

std::string Letters::text(const MPoly& f) const { return text(MFraction(f)); }

// ----- sums

Element::Element(LettersPtr letters, const MFraction& f) : letters_(std::move(letters)) {
  add(Monomial{{}, Element(letters_), Trig::none, Element(letters_), {}}, f);
}

Element::Element(LettersPtr letters, const Rational& c) : Element(letters, letters->number(c)) {}

namespace {

std::string text_of(const Monomial& m, const Letters& letters) {
  std::string s;
  for (const auto& [base, c] : m.powers)
    s += "{" + letters.text(base) + "}^{" + letters.text(c) + "}";
  if (!is_zero(m.exponent)) s += "exp{" + text(m.exponent) + "}";
  if (m.trig != Trig::none) s += (m.trig == Trig::cos ? "cos{" : "sin{") + text(m.angle) + "}";
  for (const auto& [kernel, name, power] : m.kernels)
    s += name + "^" + std::to_string(power);
  return s;
}

std::string name_of(const Kernel& k) {
  const std::string u = text(k.argument);
  switch (k.name) {
  case Name::log:
    return "log(" + u + ")";
  case Name::atan:
    return "atan(" + u + ")";
  case Name::inverse:
    return "inverse(" + u + ")";
  case Name::integral:
    return "int(" + u + ", " + k.argument.letters()->variable() + ")";
  }
  return {};
}

} // namespace

void Element::add(const Monomial& m, const MFraction& given) {
  const MFraction c = letters_->reduced(given);
  if (is_zero(c)) return;
  std::string key = text_of(m, *letters_);
  const auto at = terms_.find(key);
  if (at == terms_.end()) {
    if (static_cast<long>(terms_.size()) >= most_terms) throw NotElementary("too many terms");
    terms_.emplace(std::move(key), Term{std::make_shared<const Monomial>(m), c});
    return;
  }
  at->second.coefficient = letters_->reduced(at->second.coefficient + c);
  if (is_zero(at->second.coefficient)) terms_.erase(at);
}

std::optional<MFraction> Element::rational() const {
  if (terms_.empty()) return letters_ ? letters_->number(0) : MFraction();
  if (terms_.size() > 1 || !terms_.begin()->first.empty()) return std::nullopt;
  return terms_.begin()->second.coefficient;
}

bool is_zero(const Element& f) { return f.terms().empty(); }

bool is_constant(const Element& f) {
  return std::ranges::all_of(f.terms(), [](const auto& entry) {
    const auto& [m, c] = entry.second;
    const auto constant = [](const Monomial::Power& p) { return !uses(p.base, Letters::x); };
    return !uses(c, Letters::x) && std::ranges::all_of(m->powers, constant) &&
           is_constant(m->exponent) && is_constant(m->angle) &&
           std::ranges::all_of(m->kernels, [](const auto& k) {
             return k.kernel->name != Name::integral && is_constant(k.kernel->argument);
           });
  });
}

Element operator+(Element a, const Element& b) {
  if (!a.letters_) return b;
  for (const auto& [key, t] : b.terms_)
    a.add(*t.monomial, t.coefficient);
  return a;
}

Element operator-(Element a) {
  for (auto& [key, t] : a.terms_)
    t.coefficient = -t.coefficient;
  return a;
}

Element operator-(Element a, const Element& b) { return std::move(a) + -b; }

Element operator*(const MFraction& c, Element a) {
  Element product(a.letters_);
  for (const auto& [key, t] : a.terms_)
    product.add(*t.monomial, c * t.coefficient);
  return product;
}

namespace {

// exp(f), q^c, kernels and one sine or cosine are put together; what is rational goes into the coefficient.
class Product {
public:
  explicit Product(LettersPtr letters)
      : letters_(std::move(letters)),
        c_(letters_->number(1)), m_{{}, Element(letters_), Trig::none, Element(letters_), {}} {}

  void times(const Monomial& m, const MFraction& c) {
    c_ = letters_->reduced(c_ * c);
    for (const auto& p : m.powers)
      power(p.base, p.exponent);
    m_.exponent += m.exponent;
    for (const auto& k : m.kernels)
      kernel(k);
  }

  void power(const MPoly& base, const MFraction& exponent) {
    auto at = std::ranges::find(m_.powers, base, &Monomial::Power::base);
    if (at == m_.powers.end()) {
      m_.powers.push_back({base, letters_->number(0)});
      std::ranges::sort(m_.powers,
                        [](const auto& a, const auto& b) { return compare(a.base, b.base) < 0; });
      at = std::ranges::find(m_.powers, base, &Monomial::Power::base);
    }
    MFraction sum = letters_->reduced(at->exponent + exponent);
    const Integer whole = floor(value_at_zero(sum));
    if (!is_zero(whole)) {
      if (abs(Rational(whole)) > Rational(most_power)) throw NotElementary("a large power");
      c_ *= pow(MFraction(base), to_long(whole));
      sum -= letters_->number(Rational(whole));
    }
    if (is_half(sum) && !uses(base, Letters::x)) {
      c_ = letters_->reduced(c_ * letters_->root(MFraction(base)));
      sum = letters_->number(0);
    }
    if (is_zero(sum))
      m_.powers.erase(at);
    else
      at->exponent = sum;
  }

  void kernel(const Monomial::KernelPower& k) {
    const auto at = std::ranges::lower_bound(m_.kernels, k.text, {}, &Monomial::KernelPower::text);
    if (at == m_.kernels.end() || at->text != k.text)
      m_.kernels.insert(at, k);
    else
      at->power += k.power;
  }

  [[nodiscard]] const MFraction& coefficient() const { return c_; }
  [[nodiscard]] Monomial monomial(Trig trig, const Element& angle) const {
    Monomial m = m_;
    m.trig = trig;
    m.angle = angle;
    for (auto& k : m.kernels) // u^n (1/u)^n
      for (auto& below : m.kernels)
        if (below.text == "inverse(" + k.text + ")") {
          const long both = std::min(k.power, below.power);
          k.power -= both;
          below.power -= both;
        }
    std::erase_if(m.kernels, [](const auto& k) { return k.power == 0; });
    return m;
  }

private:
  LettersPtr letters_;
  MFraction c_;
  Monomial m_;
};

// cos(r pi) for r in [0, 1/2] where it is a square root.
std::optional<MFraction> cosine_in_quadrant(const Rational& r, Letters& letters) {
  const MFraction half = letters.number(Rational(1, 2));
  if (is_zero(r)) return letters.number(1);
  if (r == Rational(1, 6)) return half * letters.root(letters.number(3));
  if (r == Rational(1, 4)) return half * letters.root(letters.number(2));
  if (r == Rational(1, 3)) return half;
  if (r == Rational(1, 2)) return letters.number(0);
  return std::nullopt;
}

// The cosine or sine of a multiple of pi.
std::optional<MFraction> special_value(Trig trig, const Element& angle) {
  Letters& letters = *angle.letters();
  const auto f = letters.pi() ? angle.rational() : std::nullopt;
  if (!f || is_zero(*f)) return std::nullopt;
  const MFraction q = *f / MFraction::variable(letters.ring(), *letters.pi());
  if (!is_constant(q)) return std::nullopt;
  Rational r = to_rational(q);
  if (trig == Trig::sin) r = r - Rational(1, 2); // sin(h) = cos(h - pi/2)
  r = abs(r - Rational(2) * Rational(floor(r / Rational(2) + Rational(1, 2))));
  const bool second = r > Rational(1, 2);
  const auto c = cosine_in_quadrant(second ? Rational(1) - r : r, letters);
  return c && second ? -*c : c;
}

// Adds c p cos(angle) or c p sin(angle), the angle made positive.
void add_trig(Element& sum, const Product& p, const Rational& c, Trig trig, Element angle) {
  const LettersPtr& letters = sum.letters();
  Rational factor = c;
  if (trig != Trig::none)
    if (const auto value = special_value(trig, angle))
      return sum.add(p.monomial(Trig::none, Element(letters)),
                     letters->number(c) * *value * p.coefficient());
  if (is_zero(angle)) {
    if (trig == Trig::sin) return;
    trig = Trig::none;
    angle = Element(letters);
  } else if (trig != Trig::none &&
             sign(angle.terms().begin()->second.coefficient.num().coefficient(0)) < 0) {
    angle = -angle;
    if (trig == Trig::sin) factor = -factor;
  }
  sum.add(p.monomial(trig, angle), letters->number(factor) * p.coefficient());
}

void multiply(Element& sum, const Element::Term& a, const Element::Term& b) {
  Product p(sum.letters());
  p.times(*a.monomial, a.coefficient);
  p.times(*b.monomial, b.coefficient);
  const Trig s = a.monomial->trig, t = b.monomial->trig;
  const Element &g = a.monomial->angle, &h = b.monomial->angle;
  if (s == Trig::none || t == Trig::none) {
    const bool first = s != Trig::none;
    return add_trig(sum, p, 1, first ? s : t, first ? g : h);
  }
  const Rational half(1, 2);
  if (s == t) { // cos g cos h, sin g sin h
    add_trig(sum, p, half, Trig::cos, g - h);
    add_trig(sum, p, s == Trig::cos ? half : -half, Trig::cos, g + h);
  } else { // sin g cos h
    add_trig(sum, p, half, Trig::sin, g + h);
    add_trig(sum, p, s == Trig::sin ? half : -half, Trig::sin, g - h);
  }
}

const LettersPtr& letters_of(const Element& a, const Element& b) {
  return a.letters() ? a.letters() : b.letters();
}

Monomial unit(const LettersPtr& letters) {
  return {{}, Element(letters), Trig::none, Element(letters), {}};
}

Element of_kernel(Name name, const Element& argument) {
  const auto kernel = std::make_shared<const Kernel>(Kernel{name, argument});
  Monomial m = unit(argument.letters());
  m.kernels.push_back({kernel, name_of(*kernel), 1});
  Element e(argument.letters());
  e.add(m, argument.letters()->number(1));
  return e;
}

} // namespace

Element operator*(const Element& a, const Element& b) {
  Element product(letters_of(a, b));
  for (const auto& [k, s] : a.terms_)
    for (const auto& [l, t] : b.terms_)
      multiply(product, s, t);
  return product;
}

namespace {

// 1/(c m) where m has no sine, cosine or logarithm.
std::optional<Element> inverse_of_term(const Element& f) {
  if (f.terms().size() != 1) return std::nullopt;
  const auto& [m, c] = f.terms().begin()->second;
  const auto plain = [](const auto& k) { return k.kernel->name == Name::inverse; };
  if (m->trig != Trig::none || !std::ranges::all_of(m->kernels, plain)) return std::nullopt;
  const LettersPtr& letters = f.letters();
  Product p(letters);
  Monomial inverse = unit(letters);
  inverse.exponent = -m->exponent;
  p.times(inverse, letters->number(1) / c);
  for (const auto& [base, e] : m->powers)
    p.power(base, -e);
  Element sum(letters);
  sum.add(p.monomial(Trig::none, Element(letters)), p.coefficient());
  for (const auto& k : m->kernels)
    sum *= pow(k.kernel->argument, k.power);
  return sum;
}

} // namespace

Element operator/(const Element& a, const Element& b) {
  if (is_zero(b)) throw NotElementary("division by zero");
  if (auto inverse = inverse_of_term(b)) return a * *inverse;
  // what all terms have stands outside of 1/u
  Monomial common = *b.terms().begin()->second.monomial;
  common.trig = Trig::none;
  common.angle = Element(b.letters());
  common.kernels.clear();
  const std::string shared = text_of(common, *b.letters());
  const bool all_have_it =
      !shared.empty() && std::ranges::all_of(b.terms(), [&](const auto& entry) {
        Monomial m = common;
        m.powers = entry.second.monomial->powers;
        m.exponent = entry.second.monomial->exponent;
        return text_of(m, *b.letters()) == shared;
      });
  if (all_have_it) {
    Element factor(b.letters());
    factor.add(common, b.letters()->number(1));
    return (a / factor) / (b / factor);
  }
  const MFraction& first = b.terms().begin()->second.coefficient;
  MPoly above = first.num(), below = first.den();
  for (const auto& [key, t] : b.terms()) {
    above = gcd(above, t.coefficient.num());
    below = below * exact_div(t.coefficient.den(), gcd(below, t.coefficient.den()));
  }
  MFraction outside(below, above);
  if (sign(first.num().coefficient(0)) < 0) outside = -outside;
  return outside * (a * of_kernel(Name::inverse, outside * b));
}

Element pow(const Element& f, long n) {
  if (n < 0) return pow(f.number(1) / f, -n);
  if (n > most_power) throw NotElementary("a large power");
  Element product = f.number(1);
  for (; n > 0; --n)
    product *= f;
  return product;
}

std::optional<Rational> ratio(const Element& a, const Element& b) {
  const MFraction q = a.letters()->reduced(a.terms().begin()->second.coefficient /
                                           b.terms().begin()->second.coefficient);
  if (!is_constant(q) || !is_zero(a - q * b)) return std::nullopt;
  return to_rational(q);
}

// ----- functions

namespace {

// exp(f) is exp(rest) times powers of polynomials times `factor`: n log(g) is a power of g, for a whole number n also
// where g is no polynomial.
void split_exponent(const Element& f, Element& rest, std::vector<Monomial::Power>& powers,
                    Element& factor) {
  for (const auto& [key, t] : f.terms()) {
    const auto& k = t.monomial->kernels;
    const bool logarithm = k.size() == 1 && k.front().power == 1 &&
                           k.front().kernel->name == Name::log && key == k.front().text + "^1" &&
                           !uses(t.coefficient, Letters::x);
    const auto inside = logarithm ? k.front().kernel->argument.rational() : std::nullopt;
    if (inside && is_one(inside->den()))
      powers.push_back({inside->num(), t.coefficient});
    else if (logarithm && is_small_integer(t.coefficient))
      factor *= pow(k.front().kernel->argument, to_long(to_rational(t.coefficient).num()));
    else
      rest.add(*t.monomial, t.coefficient);
  }
}

} // namespace

Element exp(const Element& f) {
  const LettersPtr& letters = f.letters();
  Element rest(letters), e(letters), factor = f.number(1);
  std::vector<Monomial::Power> powers;
  split_exponent(f, rest, powers, factor);
  Monomial m = unit(letters);
  m.exponent = rest;
  Product p(letters);
  p.times(m, letters->number(1));
  for (const auto& [base, c] : powers)
    p.power(base, c);
  e.add(p.monomial(Trig::none, Element(letters)), p.coefficient());
  return e * factor;
}

Element cos(const Element& f) {
  Element e(f.letters());
  add_trig(e, Product(f.letters()), 1, Trig::cos, f);
  return e;
}

Element sin(const Element& f) {
  Element e(f.letters());
  add_trig(e, Product(f.letters()), 1, Trig::sin, f);
  return e;
}

Element log(const Element& f) {
  const LettersPtr& letters = f.letters();
  if (is_zero(f)) throw NotElementary("the logarithm of 0");
  if (f.terms().size() > 1 || f.terms().begin()->second.monomial->trig != Trig::none ||
      !f.terms().begin()->second.monomial->kernels.empty())
    return of_kernel(Name::log, f);
  const auto& [m, c] = f.terms().begin()->second;
  Element sum = m->exponent;
  const auto logarithm = [&](const MPoly& base) {
    return of_kernel(Name::log, {letters, MFraction(base)});
  };
  const auto take = [&](const MPoly& p, long sign) {
    const auto [content, factors] = factor(p);
    MPoly number(letters->ring(), content); // a minus sign stays with the first factor
    bool minus = kov::sign(content) < 0;
    if (minus) number = -number;
    for (const auto& [base, e] : factors) {
      const bool here = minus && e % 2 != 0;
      if (here) minus = false;
      sum += letters->number(Rational(sign * e)) * logarithm(here ? -base : base);
    }
    if (minus) number = -number;
    if (!is_one(number)) sum += letters->number(Rational(sign)) * logarithm(number);
  };
  take(c.num(), 1);
  take(c.den(), -1);
  for (const auto& [base, e] : m->powers)
    sum += e * logarithm(base);
  return sum;
}

Element atan(const Element& f) {
  if (is_zero(f)) return f;
  if (sign(f.terms().begin()->second.coefficient.num().coefficient(0)) < 0)
    return -of_kernel(Name::atan, -f);
  const auto& [m, c] = f.terms().begin()->second; // of tan(h): h, up to a constant
  if (f.terms().size() == 1 && is_one(c) && m->trig == Trig::sin && m->kernels.size() == 1 &&
      m->kernels.front().power == 1 && is_zero(f - sin(m->angle) / cos(m->angle)))
    return m->angle;
  return of_kernel(Name::atan, f);
}

Element unevaluated_integral(const Element& f) { return of_kernel(Name::integral, f); }

Element power(const Element& f, const MFraction& c) {
  const LettersPtr& letters = f.letters();
  if (is_small_integer(c)) {
    const long n = to_long(to_rational(c).num());
    return pow(f, n);
  }
  if (uses(c, Letters::x) || f.terms().size() != 1) throw NotElementary("a power of a sum");
  const auto& [m, factor_of_all] = f.terms().begin()->second;
  if (m->trig != Trig::none || !m->kernels.empty()) throw NotElementary("a power of a function");
  Product p(letters);
  Monomial e = unit(letters);
  e.exponent = c * m->exponent;
  p.times(e, letters->number(1));
  for (const auto& [base, exponent] : m->powers)
    p.power(base, letters->reduced(c * exponent));
  const auto take = [&](const MPoly& poly, const MFraction& by) {
    const auto [content, factors] = factor(poly);
    MPoly number(letters->ring(), content);
    bool minus = sign(content) < 0;
    if (minus) number = -number;
    for (const auto& [base, n] : factors) {
      const bool here = minus && n % 2 != 0;
      if (here) minus = false;
      p.power(here ? -base : base, letters->number(Rational(n)) * by);
    }
    if (minus) number = -number;
    if (!is_one(number)) p.power(number, by);
  };
  take(factor_of_all.num(), c);
  take(factor_of_all.den(), -c);
  Element result(letters);
  result.add(p.monomial(Trig::none, Element(letters)), p.coefficient());
  return result;
}

// ----- calculus

namespace {

// A monomial as a product, but for what is left out.
Element as_element(const LettersPtr& letters, const Monomial& m, const MFraction& c) {
  Element e(letters);
  e.add(m, c);
  return e;
}

Element derivative_of(const Monomial::KernelPower& k, const LettersPtr& letters) {
  const Element& u = k.kernel->argument;
  switch (k.kernel->name) {
  case Name::log:
    return derivative(u) / u;
  case Name::atan:
    return derivative(u) / (u * u + u.number(1));
  case Name::inverse:
    return -derivative(u) * pow(of_kernel(Name::inverse, u), 2);
  case Name::integral:
    return u;
  }
  return Element(letters);
}

} // namespace

Element derivative(const Element& f) {
  const LettersPtr& letters = f.letters();
  Element sum(letters);
  for (const auto& [key, t] : f.terms()) {
    const Monomial& m = *t.monomial;
    const Element whole = as_element(letters, m, t.coefficient);
    sum.add(m, derivative(t.coefficient, Letters::x));
    Element rate = derivative(m.exponent); // of the logarithm of what has no zero
    for (const auto& [base, c] : m.powers)
      rate += Element(letters, c * MFraction(derivative(base, Letters::x)) / MFraction(base));
    if (!is_zero(rate)) sum += rate * whole;
    if (m.trig != Trig::none) {
      Monomial other = m;
      other.trig = m.trig == Trig::cos ? Trig::sin : Trig::cos;
      sum += derivative(m.angle) *
             as_element(letters, other, m.trig == Trig::cos ? -t.coefficient : t.coefficient);
    }
    for (std::size_t i = 0; i < m.kernels.size(); ++i) {
      Monomial lower = m;
      const long n = lower.kernels[i].power--;
      if (n == 1) lower.kernels.erase(lower.kernels.begin() + static_cast<long>(i));
      sum += letters->number(Rational(n)) *
             (derivative_of(m.kernels[i], letters) * as_element(letters, lower, t.coefficient));
    }
  }
  return sum;
}

Element compose(const Element& f, const Element& g) {
  const LettersPtr& letters = g.letters();
  const auto at = [&](const MPoly& p) {
    Element sum(letters), power = g.number(1);
    for (const MPoly& c : coefficients(p, Letters::x)) {
      sum += MFraction(c) * power;
      power *= g;
    }
    return sum;
  };
  Element sum(letters);
  for (const auto& [key, t] : f.terms()) {
    const Monomial& m = *t.monomial;
    Element product = at(t.coefficient.num()) / at(t.coefficient.den());
    for (const auto& [base, c] : m.powers)
      product *= power(at(base), c);
    if (!is_zero(m.exponent)) product *= exp(compose(m.exponent, g));
    if (m.trig != Trig::none) {
      const Element angle = compose(m.angle, g);
      product *= m.trig == Trig::cos ? cos(angle) : sin(angle);
    }
    for (const auto& [kernel, name, n] : m.kernels) {
      const Element u = compose(kernel->argument, g);
      const Element value = kernel->name == Name::log       ? log(u)
                            : kernel->name == Name::atan    ? atan(u)
                            : kernel->name == Name::inverse ? u.number(1) / u
                            : is_constant(g)                ? Element(letters)
                                             : unevaluated_integral(u * derivative(g));
      product *= pow(value, n);
    }
    sum += product;
  }
  return sum;
}

// ----- text

namespace {

class Writer {
public:
  explicit Writer(const Letters& letters) : letters_(letters) {}

  // With its sign.
  [[nodiscard]] std::string term(const Monomial& m, const MFraction& c) const {
    MPoly num = c.num(), den = c.den();
    std::string above, below;
    const auto put = [](std::string& where, const std::string& factor) {
      where += (where.empty() ? "" : "*") + factor;
    };
    std::string later, kernels;
    for (const auto& [base, exponent] : m.powers) {
      MFraction total = exponent;
      while (auto q = divides(base, num)) {
        num = *q;
        total += letters_.number(1);
      }
      while (auto q = divides(base, den)) {
        den = *q;
        total -= letters_.number(1);
      }
      const bool negative = is_constant(total) && sign(to_rational(total)) < 0;
      put(negative ? below : later, power_text(letters_.text(base), negative ? -total : total));
    }
    if (!is_zero(m.exponent)) put(later, "exp(" + text(m.exponent) + ")");
    const std::string angle = "(" + (m.trig == Trig::none ? "" : text(m.angle)) + ")";
    std::string call = m.trig == Trig::none ? "" : (m.trig == Trig::cos ? "cos" : "sin") + angle;
    const std::string other =
        m.trig == Trig::none ? "" : (m.trig == Trig::cos ? "sin" : "cos") + angle;
    for (const auto& [kernel, name, power] : m.kernels) {
      const bool inverse = kernel->name == Name::inverse;
      long n = power;
      if (inverse && !call.empty() && text(kernel->argument) == other) { // sin/cos = tan
        call = (m.trig == Trig::cos ? "cot" : "tan") + angle;
        if (--n == 0) continue;
      }
      const std::string base = inverse ? text(kernel->argument) : name;
      put(inverse ? below : kernels, power_text(base, letters_.number(Rational(n))));
    }
    if (!call.empty()) put(later, call);
    if (!kernels.empty()) put(later, kernels);
    // sums in coefficients stand as they are, with a sign in front
    std::string front = letters_.text(num);
    const bool minus = front.front() == '-' && (!is_sum(front) || all_minus(front));
    if (minus) front = letters_.text(-num);
    if (front != "1" || later.empty())
      above = later.empty() && !is_one(den) ? front : later.empty() ? front : factor_text(front);
    if (!later.empty()) put(above, later);
    std::string down = letters_.text(den);
    if (down == "1")
      down = below;
    else if (!below.empty())
      down = factor_text(down) + "*" + below;
    if (!down.empty()) above = (is_sum(above) ? "(" + above + ")" : above) + "/" + below_text(down);
    return (minus ? "-" : "") + (minus && is_sum(above) ? "(" + above + ")" : above);
  }

private:
  static bool all_minus(const std::string& s) {
    long depth = 0;
    for (std::size_t i = 1; i < s.size(); ++i) {
      depth += s[i] == '(' ? 1 : s[i] == ')' ? -1 : 0;
      if (depth == 0 && s[i] == '+') return false;
    }
    return true;
  }
  [[nodiscard]] std::string power_text(const std::string& base, const MFraction& e) const {
    if (is_one(e)) return factor_text(base);
    if (is_half(e)) return "sqrt(" + base + ")";
    const std::string n = letters_.text(e);
    const bool call = base.find('(') != std::string::npos && base.back() == ')' && !is_sum(base) &&
                      !is_product(base);
    return (is_atom(base) || call ? base : "(" + base + ")") + "^" +
           (is_atom(n) ? n : "(" + n + ")");
  }

  const Letters& letters_;
};

// exp(g) + exp(-g) = 2 cosh(g), exp(g) - exp(-g) = 2 sinh(g), times what both have.
std::vector<std::string> hyperbolic_terms(const Element& f, std::set<std::string>& used) {
  std::vector<std::string> found;
  const Letters& letters = *f.letters();
  for (const auto& [key, t] : f.terms()) {
    if (used.contains(key) || is_zero(t.monomial->exponent)) continue;
    Monomial mirror = *t.monomial;
    mirror.exponent = -mirror.exponent;
    const std::string other = text_of(mirror, letters);
    const auto at = f.terms().find(other);
    if (at == f.terms().end() || other == key || used.contains(other)) continue;
    const bool even = at->second.coefficient == t.coefficient,
               odd = at->second.coefficient == -t.coefficient;
    if (!even && !odd) continue;
    const bool positive =
        sign(t.monomial->exponent.terms().begin()->second.coefficient.num().coefficient(0)) > 0;
    const MFraction c = letters.number(2) * (positive ? t.coefficient : at->second.coefficient);
    Monomial rest = *t.monomial;
    const Element g = positive ? rest.exponent : mirror.exponent;
    rest.exponent = Element(f.letters());
    const std::string call = std::string(even ? "cosh(" : "sinh(") + text(g) + ")";
    std::string s =
        Writer(letters).term(rest, c * MFraction::variable(letters.ring(), Letters::sine));
    s.replace(s.find("sine'"), 5, call);
    found.push_back(s);
    used.insert(key);
    used.insert(other);
  }
  return found;
}

// Terms over the same 1/u stand over one line.
std::vector<std::string> fractions(const Element& f, std::set<std::string>& used) {
  std::map<std::string, std::pair<Monomial, Element>> sums; // by what stands below
  std::map<std::string, std::vector<std::string>> keys;
  for (const auto& [key, t] : f.terms()) {
    Monomial below = unit(f.letters()), above = *t.monomial;
    const auto is_below = [](const auto& k) { return k.kernel->name == Name::inverse; };
    std::ranges::copy_if(above.kernels, std::back_inserter(below.kernels), is_below);
    if (below.kernels.empty()) continue;
    std::erase_if(above.kernels, is_below);
    const std::string text = text_of(below, *f.letters());
    sums.try_emplace(text, below, Element(f.letters()))
        .first->second.second.add(above, t.coefficient);
    keys[text].push_back(key);
  }
  std::vector<std::string> found;
  for (const auto& [text_below, sum] : sums) {
    if (keys[text_below].size() < 2) continue;
    used.insert(keys[text_below].begin(), keys[text_below].end());
    const std::string one_over = Writer(*f.letters()).term(sum.first, f.letters()->number(1));
    found.push_back(factor_text(text(sum.second)) + one_over.substr(1));
  }
  return found;
}

// m log(A) - m log(B) = m log((A)/(B))
std::vector<std::string> logarithms_of_quotients(const Element& f, std::set<std::string>& used) {
  std::vector<std::string> found;
  const auto logarithm_in = [](const Monomial& m) {
    const auto is_log = [](const auto& k) { return k.kernel->name == Name::log && k.power == 1; };
    return std::ranges::count_if(m.kernels, is_log) == 1 ? std::ranges::find_if(m.kernels, is_log)
                                                         : m.kernels.end();
  };
  for (const auto& [key, t] : f.terms())
    for (const auto& [other, s] : f.terms()) {
      if (used.contains(key) || used.contains(other) || !(s.coefficient == -t.coefficient))
        continue;
      if (sign(t.coefficient.num().coefficient(0)) < 0) continue; // the other way round
      const auto at = logarithm_in(*t.monomial), there = logarithm_in(*s.monomial);
      if (at == t.monomial->kernels.end() || there == s.monomial->kernels.end()) continue;
      Monomial m = *t.monomial, without = *s.monomial;
      m.kernels.erase(m.kernels.begin() + (at - t.monomial->kernels.begin()));
      without.kernels.erase(without.kernels.begin() + (there - s.monomial->kernels.begin()));
      if (text_of(m, *f.letters()) != text_of(without, *f.letters())) continue;
      const std::string above = text(at->kernel->argument), below = text(there->kernel->argument);
      m.kernels.push_back(*at);
      m.kernels.back().text = "log(" + factor_text(above) + "/" + below_text(below) + ")";
      found.push_back(Writer(*f.letters()).term(m, t.coefficient));
      used.insert(key);
      used.insert(other);
    }
  return found;
}

} // namespace

std::string text(const Element& f, bool hyperbolic) {
  if (is_zero(f)) return "0";
  std::set<std::string> used;
  std::vector<std::string> all;
  if (hyperbolic) all = hyperbolic_terms(f, used);
  std::ranges::copy(fractions(f, used), std::back_inserter(all));
  std::ranges::copy(logarithms_of_quotients(f, used), std::back_inserter(all));
  const Writer write(*f.letters());
  for (const auto& [key, t] : f.terms())
    if (!used.contains(key) && !key.empty()) all.push_back(write.term(*t.monomial, t.coefficient));
  if (const auto rational = f.terms().find(""); rational != f.terms().end())
    all.push_back(write.term(*rational->second.monomial, rational->second.coefficient));
  // a sum begins with what is added
  std::ranges::stable_partition(all, [](const std::string& s) { return s.front() != '-'; });
  std::string s;
  for (const std::string& t : all)
    s += s.empty() ? t : t.front() == '-' ? " - " + t.substr(1) : " + " + t;
  return s;
}

std::vector<std::string> excluded(const Element& f) {
  std::set<std::string> all;
  const auto take = [&](const auto& self, const Element& e) -> void {
    for (const auto& [key, t] : e.terms()) {
      for (const auto& [base, n] : factor(t.coefficient.den()).second)
        if (!uses(base, Letters::x)) all.insert(e.letters()->text(base));
      self(self, t.monomial->exponent);
      self(self, t.monomial->angle);
      for (const auto& k : t.monomial->kernels)
        self(self, k.kernel->argument);
    }
  };
  take(take, f);
  return {all.begin(), all.end()};
}

} // namespace kov::elementary
