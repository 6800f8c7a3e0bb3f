// JSON -> HomoclinicCertificate, in the order of chaos.md 6; unknown, missing and doubled keys are
// errors.

#include "certify/homoclinic/certificate.hpp"
#include "exact/error.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>

namespace kov::certify {
namespace {

constexpr std::size_t longest_number = 60;
constexpr long largest_exponent = 400;

Rational power_of_ten(long e) {
  Integer p;
  fmpz_ui_pow_ui(p.raw(), 10, static_cast<ulong>(std::abs(e)));
  return e < 0 ? Rational(Integer(1), p) : Rational(p, Integer(1));
}

// Digits from `at` on, which is moved behind them.
std::string digits(std::string_view s, std::size_t& at) {
  const std::size_t from = at;
  while (at < s.size() && s[at] >= '0' && s[at] <= '9')
    ++at;
  return std::string(s.substr(from, at - from));
}

Integer natural(const std::string& s) {
  Integer n;
  if (!s.empty()) fmpz_set_str(n.raw(), s.c_str(), 10);
  return n;
}

// "-3/8", "0.125", "1.25e-7"
Rational number(const Node& n) {
  const std::string s = n.text();
  if (s.empty() || s.size() >= longest_number) n.fail("a number is a short string");
  std::size_t at = s[0] == '-' ? 1 : 0;
  const std::string whole = digits(s, at);
  Rational x;
  if (at < s.size() && s[at] == '/') {
    const Integer below = natural(digits(s, ++at));
    if (whole.empty() || at < s.size() || below == Integer(0)) n.fail("a number is expected");
    x = Rational(natural(whole), below);
  } else {
    std::string part;
    if (at < s.size() && s[at] == '.') part = digits(s, ++at);
    if (whole.empty() && part.empty()) n.fail("a number is expected");
    long e = 0;
    if (at < s.size() && (s[at] == 'e' || s[at] == 'E')) {
      ++at;
      const bool negative = at < s.size() && s[at] == '-';
      if (at < s.size() && (s[at] == '-' || s[at] == '+')) ++at;
      const std::string power = digits(s, at);
      if (power.empty()) n.fail("a number is expected");
      if (!(natural(power) < Integer(largest_exponent))) n.fail("a number is too small or large");
      e = to_long(natural(power)) * (negative ? -1 : 1);
    }
    if (at < s.size()) n.fail("a number is expected");
    x = Rational(natural(whole + part), Integer(1)) *
        power_of_ten(e - static_cast<long>(part.size()));
  }
  return s[0] == '-' ? -x : x;
}

template <std::size_t N> std::array<Rational, N> numbers(const Node& n) {
  const auto items = n.items();
  if (items.size() != N) n.fail(std::to_string(N) + " numbers are expected");
  std::array<Rational, N> all;
  std::ranges::transform(items, all.begin(), number);
  return all;
}

PhaseFunction polynomial(const Ring& ring, const Node& n) {
  if (n.items().size() != 2) n.fail("a polynomial over an integer is expected");
  PhaseFunction f = read_phase_function(ring, n);
  bool small = f.p.length() < max_homoclinic_terms && Integer(0) < f.n;
  for (std::size_t i = 0; i < ring->size(); ++i)
    small = small && degree(f.p, i) <= max_homoclinic_degree;
  if (!small) n.fail("a polynomial is not of this format");
  return f;
}

std::array<std::size_t, 2> chart(const Node& n) {
  const auto both = n.items();
  if (both.size() != 2) n.fail("a chart is two places");
  const long i = both[0].count(), j = both[1].count();
  if (i < 0 || j <= i || j > 3) n.fail("a chart is two places");
  return {static_cast<std::size_t>(i), static_cast<std::size_t>(j)};
}

void read_orbit(HomoclinicCertificate& c, const Node& n) {
  for (const Node& z : n.items()) {
    c.orbit.push_back(numbers<4>(z));
    if (static_cast<long>(c.orbit.size()) * c.period > max_homoclinic_points)
      n.fail("the orbit is too long");
  }
  if (c.orbit.empty()) n.fail("there is no orbit");
}

} // namespace

HomoclinicCertificate read_homoclinic_certificate(std::string_view text) {
  const Json json = parse_json(text);
  const Node top(json, "certificate", rationals());
  Keys k(top);
  HomoclinicCertificate c;
  const Node format = k.at("format");
  if (format.text() != "kovacic-homoclinic/1") format.fail("not kovacic-homoclinic/1");
  const Node names = k.at("variables");
  const auto four = read_texts(names, 4);
  if (four.size() != 4) names.fail("four names are expected");
  c.ring = ring_of(names, four);
  c.hamiltonian = polynomial(c.ring, k.at("hamiltonian"));
  c.level = number(k.at("level"));
  c.section = polynomial(c.ring, k.at("section"));
  const Node direction = k.at("direction");
  c.rising = direction.text() == "upward";
  if (!c.rising && direction.text() != "downward")
    direction.fail("the direction is upward or downward");
  const Node where = k.at("where");
  if (!where.is_null()) c.where = polynomial(c.ring, where);
  const Node period = k.at("period");
  c.period = period.count();
  if (c.period < 1 || c.period > max_homoclinic_period) period.fail("a period is 1 to 64");
  c.point = numbers<4>(k.at("point"));
  c.chart = chart(k.at("chart"));
  const Node axes = k.at("axes");
  const auto rows = axes.items();
  if (rows.size() != 2) axes.fail("axes are a matrix");
  c.axes = {numbers<2>(rows[0]), numbers<2>(rows[1])};
  const Node reach = k.at("reach");
  c.reach = number(reach);
  if (!(Rational(0) < c.reach) || !(c.reach < Rational(1)))
    reach.fail("the reach is not in (0, 1)");
  c.xi = number(k.at("xi"));
  c.eta = number(k.at("eta"));
  read_orbit(c, k.at("orbit"));
  k.done();
  return c;
}

} // namespace kov::certify
