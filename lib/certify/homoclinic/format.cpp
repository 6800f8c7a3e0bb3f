// JSON -> HomoclinicCertificate, in the order of chaos.md 6.

#include "certify/homoclinic/check.hpp"
#include "proof/text/fields.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <regex>

namespace kov::certify {
namespace {

constexpr std::size_t longest_number = 60;
constexpr long largest_exponent = 400;

/// "-3/8", "0.125", "1.25e-7"
struct Decimal {
  static void read(const Node& n, Rational& x, const CurveSetting&) {
    static const std::regex form("-?(?:([0-9]+)/(0*[1-9][0-9]*)|(?=\\.?[0-9])([0-9]*)\\.?([0-9]*)"
                                 "(?:[eE]([-+]?)0*([0-9]{1,3}))?)");
    const std::string s = n.text();
    std::smatch m;
    if (s.size() >= longest_number || !std::regex_match(s, m, form)) n.fail("a number is expected");
    x = Rational(natural(m[1].matched ? m[1] : m[3].str() + m[4].str()),
                 m[2].matched ? natural(m[2]) : Integer(1));
    const long e = m[6].matched ? std::stol(m[6]) : 0;
    if (e >= largest_exponent) n.fail("a number is too small or large");
    const long power = (m[5] == "-" ? -e : e) - static_cast<long>(m[4].length());
    Integer ten;
    fmpz_ui_pow_ui(ten.raw(), 10, static_cast<ulong>(std::abs(power)));
    x = power < 0 ? x / Rational(ten) : x * Rational(ten);
    if (s[0] == '-') x = -x;
  }

private:
  static Integer natural(const std::string& s) {
    Integer n;
    if (!s.empty()) fmpz_set_str(n.raw(), s.c_str(), 10);
    return n;
  }
};
constexpr Each<Decimal> numbers{.entries = "numbers"};
constexpr Each<Each<Decimal>> lists{numbers};

struct SmallPolynomial {
  static void read(const Node& n, PhaseFunction& f, const CurveSetting& s) {
    if (n.items().size() != 2) n.fail("a polynomial over an integer is expected");
    f = read_phase_function(*s.ring, n);
    bool small = f.p.length() < max_homoclinic_terms;
    for (std::size_t i = 0; i < 4; ++i)
      small = small && degree(f.p, i) <= max_homoclinic_degree;
    if (!small) n.fail("a polynomial is not of this format");
  }
};

} // namespace

template <class IO> void describe(IO& io, HomoclinicCertificate& x) {
  std::vector<std::string> names;
  io.format("kovacic-homoclinic/1")("variables", names);
  io.check(names.size() == 4, "variables", "four names are expected");
  x.ring = io.ring_of("variables", names);
  io.setting.ring = &x.ring;
  io("hamiltonian", x.hamiltonian, SmallPolynomial{})("level", x.level, Decimal{});
  io("section", x.section, SmallPolynomial{})("direction", x.rising, Either{"upward", "downward"});
  io.always("where", x.where, OrNull<SmallPolynomial>{});
  io("period", x.period, Between{1, max_homoclinic_period, "a period is 1 to 64"});
  io("point", x.point, numbers)("chart", x.chart, Each<Between>{{0, 3, "a chart is two places"}});
  io.check(x.chart[0] < x.chart[1], "chart", "a chart is two places");
  io("axes", x.axes, lists)("reach", x.reach, Decimal{});
  io.check(Rational(0) < x.reach && x.reach < Rational(1), "reach", "the reach is not in (0, 1)");
  io("xi", x.xi, Decimal{})("eta", x.eta, Decimal{})("orbit", x.orbit, lists);
  io.check(static_cast<long>(x.orbit.size()) * x.period <= max_homoclinic_points, "orbit",
           "the orbit is too long");
  io.check(!x.orbit.empty(), "orbit", "there is no orbit");
}

HomoclinicCertificate read_homoclinic_certificate(std::string_view text) {
  return read_whole<HomoclinicCertificate, CurveSetting>(text);
}

} // namespace kov::certify
