// JSON -> HomoclinicCertificate, in the order of chaos.md 6; unknown, missing and doubled keys are
// errors.

#include "certify/homoclinic/certificate.hpp"
#include "exact/error.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <regex>

namespace kov::certify {
namespace {

constexpr std::size_t longest_number = 60;
constexpr long largest_exponent = 400;

Integer natural(const std::string& s) {
  Integer n;
  if (!s.empty()) fmpz_set_str(n.raw(), s.c_str(), 10);
  return n;
}

// "-3/8", "0.125", "1.25e-7"
Rational number(const Node& n) {
  static const std::regex form("-?(?:([0-9]+)/(0*[1-9][0-9]*)|(?=\\.?[0-9])([0-9]*)\\.?([0-9]*)"
                               "(?:[eE]([-+]?)0*([0-9]{1,3}))?)");
  const std::string s = n.text();
  std::smatch m;
  if (s.size() >= longest_number || !std::regex_match(s, m, form)) n.fail("a number is expected");
  Rational x(natural(m[1].matched ? m[1] : m[3].str() + m[4].str()),
             m[2].matched ? natural(m[2]) : Integer(1));
  const long e = m[6].matched ? std::stol(m[6]) : 0;
  if (e >= largest_exponent) n.fail("a number is too small or large");
  const long power = (m[5] == "-" ? -e : e) - static_cast<long>(m[4].length());
  Integer ten;
  fmpz_ui_pow_ui(ten.raw(), 10, static_cast<ulong>(std::abs(power)));
  x = power < 0 ? x / Rational(ten) : x * Rational(ten);
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
