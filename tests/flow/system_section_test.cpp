// Sections of any system: the programs against the field that lib/system holds, orbits against many digits, against
// the hand-made kernels of the rigid body and against closed answers.

#include "flow/field/written.hpp"
#include "flow/scene/system_section.hpp"
#include "support.hpp"

#include "symbol/document.hpp"
#include "symbol/input_error.hpp"

#include <gtest/gtest.h>

#include <random>

namespace kov::flow::system_section_test {
namespace {

SystemScene scene_of(const std::string& text) {
  return read_system_scenes(parse_document(text, "test.toml")).front();
}

SystemScene scene_in(const std::string& file, const std::string& name = {}) {
  for (SystemScene& s :
       read_system_scenes(read_document(kov::test::in_source("/cases/sections/") + file)))
    if (name.empty() || s.name == name) return s;
  throw InvalidArgument("no scene " + name);
}

// ---- the graph is the field ----

struct Sample {
  std::string file;
  ParameterValues values;
};

const std::vector<Sample>& samples() {
  static const std::vector<Sample> all{
      {"sections/henon_heiles.toml", {}},
      {"sections/double_pendulum.toml", {}},
      {"sections/stoermer.toml", {}},
      {"sections/lorenz.toml", {{"s", "10"}, {"r", "28"}, {"b", "8/3"}}},
      {"sections/abc_flow.toml", {{"A", "1"}, {"B", "-2/3"}, {"C", "3/7"}}},
      {"sections/van_der_waals.toml", {{"E", "-1/3"}, {"g", "2/5"}, {"b", "3"}}},
      {"classics/swinging_atwood.toml", {{"mu", "5/2"}, {"h", "1"}}},
      {"classics/heavy_top.toml", {}},
      {"sliding_top/sliding_top.toml",
       {{"A", "1"},
        {"B", "2/3"},
        {"C", "1/2"},
        {"m", "1"},
        {"g", "7/5"},
        {"L1", "1/3"},
        {"L2", "-1/5"},
        {"L3", "2/7"}}}};
  return all;
}

Rational dice(std::mt19937& gen) {
  std::uniform_int_distribution<long> pick(1, 19);
  return (pick(gen) % 2 == 0 ? Rational(1) : Rational(-1)) * Rational(pick(gen)) /
         Rational(pick(gen));
}

// The nodes at a point, by the machine.
std::vector<double> values_of(const Graph& g, const std::vector<NodeId>& nodes,
                              const std::map<std::size_t, Rational>& at) {
  std::vector<std::size_t> inputs;
  std::vector<double> registers;
  for (const auto& [variable, value] : at) {
    inputs.push_back(variable);
    registers.push_back(number_as<double>(value));
  }
  Registers places(inputs);
  const Program p = compile(g, nodes, places);
  std::vector<double> numbers;
  for (const Rational& q : p.numbers)
    numbers.push_back(number_as<double>(q));
  registers.resize(places.count());
  for (const auto* code : {&p.once, &p.each})
    for (const Instruction& i : *code)
      machine::execute(i, p.terms.data(), numbers.data(), registers.data(), 0);
  std::vector<double> out;
  for (const std::uint32_t reg : p.outputs)
    out.push_back(registers[reg]);
  return out;
}

// A system with the graph of what its file writes.
struct WrittenSystem {
  Entry document;
  SystemScope scope;
  System system;
  Written written;
  explicit WrittenSystem(Entry e, const ParameterValues& values = {})
      : document(std::move(e)), scope(document, values), system(read_system(document, scope)),
        written(document, scope, system) {}
  explicit WrittenSystem(const Sample& s)
      : WrittenSystem(read_document(kov::test::in_source("/cases/") + s.file), s.values) {}
  explicit WrittenSystem(const std::string& text) : WrittenSystem(parse_document(text, "w.toml")) {}
  [[nodiscard]] double cost(bool as_written = true) const {
    const Motion m = motion_of(system, {}, as_written ? &written.graph() : nullptr);
    return products(m.graph, m.series_roots());
  }
};

void compare_with_field(const System& s, const Motion& m, std::mt19937& gen,
                        const std::string& file) {
  {
    std::map<std::size_t, Rational> at;
    Substitution exact;
    for (std::size_t i = 0; i < s.ring()->size(); ++i) {
      at[i] = dice(gen);
      exact.emplace(i, MFraction(s.ring(), at[i]));
    }
    const std::vector<double> x = values_of(m.graph, m.derivatives, at);
    for (std::size_t j = 0; j < m.variables.size(); ++j) {
      MFraction f = j < m.coordinates
                        ? s.field.components[j]
                        : lie_derivative(s.field, MFraction::variable(s.ring(), m.variables[j]));
      const double expected = number_as<double>(to_rational(substitute(f, exact)));
      EXPECT_NEAR(x[j], expected, 1e-11 * (1 + std::abs(expected))) << file << " " << j;
    }
  }
}

TEST(Motion, ItsDerivativesAreTheFieldOfEverySystemFile) {
  std::mt19937 gen(21);
  for (const Sample& sample : samples()) {
    const WrittenSystem w(sample);
    compare_with_field(w.system, motion_of(w.system, {}), gen, sample.file);
    compare_with_field(w.system, motion_of(w.system, {}, &w.written.graph()), gen,
                       sample.file + " as written");
  }
}

const char* const pendulum_header =
    "[system]\nkind = 'hamiltonian'\ncoordinates = ['q1', 'q2']\nmomenta = ['p1', 'p2']\n";

// The same system in other words: as quotients, with definitions, with functions in the formula, multiplied out.
TEST(Motion, WhatIsWrittenShortIsShort) {
  const std::string head = pendulum_header, d = "cos(q1 - q2)",
                    squares = "(p1^2 + 2*p2^2 - 2*p1*p2*";
  const WrittenSystem quotient(head + "hamiltonian = '" + squares + d +
                               ")/(2 + 2*sin(q1 - q2)^2) + 3 - 2*cos(q1) - cos(q2)'\n");
  const WrittenSystem defined(head + "hamiltonian = 'above/(2*below) + 3 - 2*cos(q1) - cos(q2)'\n" +
                              "[system.define]\nabove = '" + squares + d +
                              ")'\nbelow = '1 + sin(q1 - q2)^2'\n");
  EXPECT_LT(quotient.cost(), 35);
  EXPECT_NEAR(quotient.cost(), defined.cost(), 1);
  EXPECT_LT(quotient.cost(), 0.6 * quotient.cost(false));
  const WrittenSystem file(Sample{"sections/double_pendulum.toml", {}});
  EXPECT_LT(file.cost(), 24.1);
}

// The derivatives of cos(q1 - q2) and sin(q1 - q2), which stand there in functions of q1 and of q2, are there already;
// so are those of sums of angles, of hyperbolic functions, and of products of exponentials.
TEST(Motion, DerivativesOfFunctionsThatAreThereCostNothing) {
  const auto functions = [](const char* plus, const char* odd, const char* even) {
    std::string all;
    for (const char* i : {"1", "2"})
      all += std::string("[[system.function]]\nname = 's") + i + "'\nmeans = '" + odd + "(q" + i +
             ")'\nderivative = {q" + i + " = 'c" + i + "'}\n[[system.function]]\nname = 'c" + i +
             "'\nmeans = '" + even + "(q" + i + ")'\nderivative = {q" + i + " = '" + plus + "s" +
             i + "'}\n";
    return all;
  };
  const std::string kinetic = "hamiltonian = '(p1^2 + 2*p2^2 - 2*p1*p2*";
  std::mt19937 gen(24);
  for (const auto& [formula, symbols] : std::vector<std::pair<std::string, std::string>>{
           {"(c1*c2 + s1*s2))/(2 + 2*(s1*c2 - c1*s2)^2)", functions("-", "sin", "cos")},
           {"(c1*c2 - s1*s2))/(2 + 2*(s1*c2 + c1*s2)^2)", functions("-", "sin", "cos")},
           {"(c1*c2 - s1*s2))/(3 + (s1*c2 - c1*s2)^2)", functions("", "sinh", "cosh")},
           {"(c1*c2 + s1*s2))/(3 + (s1*c2 + c1*s2)^2)", functions("", "sinh", "cosh")},
           // q1 itself beside the functions: that node is no place to stop at
           {"(q1*c1*c2 + s1*s2))/(2 + 2*(s1*c2 - c1*s2)^2)", functions("-", "sin", "cos")}}) {
    const WrittenSystem w(pendulum_header + kinetic + formula + "'\n" + symbols);
    const Motion m = motion_of(w.system, {}, &w.written.graph());
    compare_with_field(w.system, m, gen, formula);
    EXPECT_LT(w.cost(), formula[1] == 'q' ? 34 : 27) << formula;
  }
}

// A long formula that cancels is not taken at its word.
TEST(Motion, WhatIsWrittenLongIsShortToo) {
  const WrittenSystem w(std::string("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y']\n") +
                        "[system.field]\nx = '(x + y)^4 - x^4 - y^4 - 4*x^3*y - 4*x*y^3 - "
                        "6*x^2*y^2 + y'\ny = '-x'\n");
  EXPECT_LT(w.cost(), 0.2);
  std::mt19937 gen(23);
  compare_with_field(w.system, motion_of(w.system, {}, &w.written.graph()), gen, "cancels");
}

TEST(Motion, AFactorOfSeveralTermsIsMultipliedOnce) {
  const auto cost = [](const std::string& h) {
    return WrittenSystem("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = "
                         "['u', 'v']\nhamiltonian = '" +
                         h + "'\n")
        .cost();
  };
  // x^2, y^2, r; 1/r, 1/r^2, 1/r^3 and twice that
  EXPECT_LT(cost("(u^2 + v^2)/2 - 1/sqrt(x^2 + y^2)"), 6.5);
  EXPECT_LT(cost("(u^2 + v^2)/2 + exp(-x^2 - y^2)"), 6.6);
}

// p = r^n of r = sqrt(a), by its own recurrence: p^2 a^-n = 1 or p^2 = a^n, as series, however small a is.
template <class R> void compare_power(int n, const R& r0, const R& unit, double allowed) {
  constexpr int order = 24, stride = order + 1;
  std::vector<R> s(5 * stride), numbers{R(n) / R(2), R(n) / R(2) + R(1)};
  Instruction i;
  i.op = Instruction::Op::power;
  i.exponent = n;
  i.a[0] = 0; // the series a
  i.b[0] = stride;
  for (std::uint32_t k = 0; k < 3; ++k)
    i.out[k] = (2 + k) * stride;
  i.a[1] = 0;
  i.a[2] = 1;
  R *a = s.data(), *p = s.data() + 2 * stride;
  s[stride] = r0;
  for (int k = 0; k <= order; ++k)
    a[k] = k == 0 ? r0 * r0 : unit * R((7 * k * k + 3) % 11 - 5) / R(8 * k);
  for (int k = 0; k <= order; ++k)
    machine::execute<R>(i, nullptr, numbers.data(), s.data(), k);
  using Series = std::vector<double>; // of numbers that are rounded where they are large
  const auto times = [](const std::vector<R>& x, const std::vector<R>& y, Series& sizes) {
    std::vector<R> z(stride);
    sizes.assign(stride, 0);
    for (int k = 0; k <= order; ++k)
      for (int j = 0; j <= k; ++j) {
        z[k] += x[j] * y[k - j];
        sizes[k] += std::abs(to_double(R(x[j] * y[k - j])));
      }
    return z;
  };
  Series sizes;
  const std::vector<R> base(a, a + stride), one(p, p + stride);
  std::vector<R> product = times(one, one, sizes);
  std::vector<R> other(stride);
  other[0] = R(1);
  for (int k = 0; k < std::abs(n); ++k)
    (n < 0 ? product : other) = times(n < 0 ? product : other, base, sizes);
  for (int k = 0; k <= order; ++k)
    ASSERT_LE(std::abs(to_double(R(product[k] - other[k]))), allowed * (sizes[k] + 1e-300))
        << n << " order " << k;
  EXPECT_EQ(to_double(p[0]) < 0, to_double(r0) < 0 && n % 2 != 0) << n;
}

TEST(Motion, PowersOfRootsHaveTheirOwnRecurrence) {
  for (const int n : {-7, -5, -4, -3, -2, -1, 2, 3, 5})
    for (const double r : {1.25, -0.75, 1e-9, -1e-15, 3e12}) {
      const double unit = r * r;
      compare_power<double>(n, r, unit, 1e-11);
      compare_power<long double>(n, r, unit, 1e-14);
      compare_power<Twin1>(n, Twin1(r), Twin1(unit), 1e-27);
      const PrecisionScope scope(200);
      compare_power<BigReal>(n, BigReal(r), BigReal(unit), 1e-55);
    }
}

TEST(Motion, PowersOfRootsAreUsedWhereTheySaveProducts) {
  const auto costs = [](const std::string& h, bool tangent) {
    const WrittenSystem w("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = "
                          "['u', 'v']\nhamiltonian = '(u^2 + v^2)/2 + " +
                          h + "'\n");
    Motion plain = motion_of(w.system, {}, &w.written.graph()), powers = plain;
    use_powers(powers);
    std::mt19937 gen(25);
    compare_with_field(w.system, powers, gen, h);
    if (tangent)
      for (Motion* m : {&plain, &powers})
        add_tangent(*m, w.system.ring()->size());
    return std::pair{products(plain.graph, plain.series_roots()),
                     products(powers.graph, powers.series_roots())};
  };
  for (const bool tangent : {false, true}) {
    for (const char* h : {"-1/sqrt(x^2 + y^2)", "-2/(3*sqrt(x^2 + y^2)^3)", "sqrt(1 + x^2 + y^2)^5",
                          "-1/sqrt(x^2 + y^2) + 1/(5*sqrt(x^2 + y^2)^3)"}) {
      const auto [plain, powers] = costs(h, tangent);
      EXPECT_LE(powers, plain) << h;
    }
    const char* const two = "-9/10/sqrt((x + 1/10)^2 + y^2) - 1/10/sqrt((x - 9/10)^2 + y^2)";
    const char* const three =
        "-1/sqrt(x^2 + y^2) - 2/sqrt((x - 1)^2 + y^2) - 3/sqrt(x^2 + (y - 1)^2)";
    for (const char* h : {two, three}) {
      const auto [plain, powers] = costs(h, tangent);
      EXPECT_LE(powers, 0.87 * plain) << h;
    }
  }
  const auto [plain, powers] = costs("x^4 + y^4", false);
  EXPECT_EQ(plain, powers);
}

TEST(Motion, TheFirstVariationIsTheJacobianTimesV) {
  std::mt19937 gen(22);
  for (const Sample& sample : samples()) {
    const System s = read_system(kov::test::in_source("/cases/") + sample.file, sample.values);
    Motion m = motion_of(s, {});
    add_tangent(m, s.ring()->size());
    std::map<std::size_t, Rational> at;
    Substitution exact;
    for (std::size_t i = 0; i < s.ring()->size(); ++i) {
      at[i] = dice(gen);
      exact.emplace(i, MFraction(s.ring(), at[i]));
    }
    for (const std::size_t v : m.tangent)
      at[v] = dice(gen);
    const std::vector<double> dv = values_of(m.graph, m.deviations, at);
    for (std::size_t j = 0; j < m.coordinates; ++j) {
      double expected = 0, size = 1;
      for (std::size_t i = 0; i < m.variables.size(); ++i) {
        const MFraction d = derivative(s.field.components[j], m.variables[i]);
        const double term = number_as<double>(to_rational(substitute(d, exact)) * at[m.tangent[i]]);
        expected += term;
        size += std::abs(term);
      }
      EXPECT_NEAR(dv[j], expected, 1e-11 * size) << sample.file << " " << j;
    }
  }
}

TEST(Motion, WhatIsZeroCostsNothing) {
  const auto cost = [](const std::string& h) {
    const System s = read_system(
        parse_document("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = "
                       "['u', 'v']\nparameters = ['a']\nhamiltonian = '" +
                           h + "'\n[set]\na = 0\n",
                       "h.toml"));
    const Motion m = motion_of(s, {});
    return products(m.graph, m.derivatives);
  };
  EXPECT_DOUBLE_EQ(cost("(u^2 + v^2)/2 + x^2*y - y^3/3 + a*x^4*y^3/(1 + x^2)"),
                   cost("(u^2 + v^2)/2 + x^2*y - y^3/3"));
  EXPECT_LT(cost("(u^2 + v^2)/2 + x^2*y - y^3/3"), 2.2); // x y, x^2, y^2
  EXPECT_LT(cost("(u^2 + v^2)/2 + (x^2 + y^2)^5"), 6.3); // not multiplied out
}

// ---- orbits ----

// Two roots, and two times two quotients, side by side.
const char* const two_centres =
    "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
    "hamiltonian = '(u^2 + v^2)/2 + y*u - x*v - 9/10/sqrt((x + 1/10)^2 + y^2) - "
    "1/10/sqrt((x - 9/10)^2 + y^2)'\n"
    "[scene]\nsection = 'y'\nlevels = {H = '-19/10'}\nplot = ['x', 'u']\n"
    "range = [['1/5', '2/5'], ['-1/10', '1/10']]\ngrid = [3, 3]\ncrossings = 6\n"
    "indicator = 'megno'\n";

// Several powers of one root; a root that is never 0.
const char* const powers_of_roots =
    "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
    "hamiltonian = '(u^2 + v^2)/2 - 1/sqrt(x^2 + 2*y^2) + 1/(5*sqrt(x^2 + 2*y^2)^3) + "
    "sqrt(1 + x^2 + y^2)^3/10'\n"
    "[scene]\nsection = 'y'\nlevels = {H = '-1/5'}\nplot = ['x', 'u']\n"
    "range = [['3/5', '6/5'], ['-1/10', '1/10']]\ngrid = [3, 3]\ncrossings = 6\n"
    "indicator = 'megno'\n";

// The code of the processor rounds as the machine does.
TEST(SystemSection, NativeCodeGivesTheSameBits) {
  for (const char* file :
       {"henon_heiles.toml", "swinging_atwood.toml", "stoermer.toml", "double_pendulum.toml",
        "lorenz.toml", "spring_pendulum.toml", two_centres, powers_of_roots})
    for (const int lanes : {4, 8}) {
      SystemScene s = *file == '[' ? scene_of(file) : scene_in(file);
      s.crossings = 6;
      s.columns = std::min(s.columns, 3);
      s.rows = std::min(s.rows, 3);
      SystemSectionOptions native, machine;
      native.lanes = machine.lanes = lanes;
      machine.native = false;
      const SystemSection a = simulate(s, native), b = simulate(s, machine);
      ASSERT_EQ(a.points.size(), b.points.size()) << file;
      for (std::size_t i = 0; i < a.points.size(); ++i) {
        EXPECT_EQ(a.points[i].t, b.points[i].t) << file;
        EXPECT_EQ(a.points[i].at, b.points[i].at) << file;
      }
      for (std::size_t i = 0; i < a.orbits.size(); ++i) {
        EXPECT_EQ(a.orbits[i].steps, b.orbits[i].steps) << file;
        EXPECT_EQ(a.orbits[i].indicators.megno, b.orbits[i].indicators.megno) << file;
      }
    }
}

// In more digits: the first crossings of each orbit, and how many there are in all.
TEST(SystemSection, PointsAndTheirNumberAgreeWithFortyDigits) {
  for (const char* file :
       {"henon_heiles.toml", "swinging_atwood.toml", "stoermer.toml", "double_pendulum.toml"}) {
    SystemScene s = scene_in(file);
    s.indicator = Indicator::none;
    s.columns = 2;
    s.rows = 2;
    s.crossings = 4; // the chaotic ones multiply an error by more than ten at a turn
    const SystemSection in_double = simulate(s);
    s.digits = 34;
    s.tolerance = "10^-30";
    const SystemSection precise = simulate(s);
    ASSERT_EQ(in_double.points.size(), precise.points.size()) << file;
    ASSERT_GE(precise.points.size(), 8U) << file;
    double worst = 0;
    for (std::size_t i = 0; i < precise.points.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        worst = std::max(worst, std::abs(in_double.points[i].at[k] - precise.points[i].at[k]));
    EXPECT_LE(worst, 1e-9) << file;
    EXPECT_LE(in_double.drift, 1e-13) << file;
    EXPECT_LE(*std::max_element(precise.drifts.begin(),
                                precise.drifts.end() - (precise.integrals.back() == "functions")),
              1e-28)
        << file;
  }
}

TEST(SystemSection, AllArithmeticsAgree) {
  const auto compare = [](SystemScene s, long crossings) {
    s.indicator = Indicator::none;
    s.columns = 2;
    s.rows = 2;
    s.crossings = crossings;
    const SystemSection first = simulate(s);
    ASSERT_FALSE(first.points.empty()) << s.title;
    for (const int digits : {18, 30, 40}) {
      s.digits = digits;
      const SystemSection other = simulate(s);
      ASSERT_EQ(first.points.size(), other.points.size()) << s.title;
      for (std::size_t i = 0; i < first.points.size(); ++i)
        EXPECT_NEAR(first.points[i].at[1], other.points[i].at[1], 1e-10)
            << s.title << " " << other.arithmetic;
    }
  };
  compare(scene_in("henon_heiles.toml", "henon_heiles_12"), 10);
  compare(scene_of(two_centres), 4);
  compare(scene_of(powers_of_roots), 4);
  compare(scene_in("double_pendulum.toml", "double_pendulum_1"), 4);
  compare(scene_in("swinging_atwood.toml"), 4);
}

TEST(SystemSection, AnOrbitDoesNotDependOnItsCompanionsOrOnThreads) {
  SystemScene s = scene_in("double_pendulum.toml", "double_pendulum_3");
  s.columns = 3;
  s.rows = 3;
  s.crossings = 20;
  SystemSectionOptions options;
  options.lanes = 1;
  const SystemSection one = simulate(s, options);
  for (const int lanes : {4, 8}) {
    options.lanes = lanes;
    options.threads = 2;
    const SystemSection other = simulate(s, options);
    ASSERT_EQ(one.points.size(), other.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i)
      ASSERT_EQ(one.points[i].at, other.points[i].at) << lanes << " " << i;
    for (std::size_t i = 0; i < one.orbits.size(); ++i)
      EXPECT_EQ(one.orbits[i].indicators.megno, other.orbits[i].indicators.megno);
  }
}

// ---- units, closed answers, hard cases ----

TEST(SystemSection, UnitsDoNotMatter) {
  const std::string rest = "section = 'x'\nplot = ['y', 'v']\ncrossings = 40\n";
  const auto henon_heiles = [&](const std::string& h, const std::string& start) {
    return simulate(
        scene_of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
                 "hamiltonian = '" +
                 h + "'\n[scene]\n" + rest + "states = [" + start + "]\n"));
  };
  const SystemSection plain =
      henon_heiles("(u^2 + v^2)/2 + (x^2 + y^2)/2 + x^2*y - y^3/3", "[0, '1/10', '2/5', 0]");
  // x, y in units of 10^-6, u, v in units of 10^6: canonical
  const SystemSection scaled =
      henon_heiles("(u^2 + v^2)*10^12/2 + (x^2 + y^2)/(2*10^12) + (x^2*y - y^3/3)/10^18",
                   "[0, 100000, '4/10^7', 0]");
  ASSERT_EQ(plain.points.size(), 40U);
  ASSERT_EQ(scaled.points.size(), 40U);
  EXPECT_NEAR(plain.points.back().t, scaled.points.back().t, 1e-9);
  EXPECT_NEAR(plain.points.back().at[0] * 1e6, scaled.points.back().at[0], 1e-3);
  EXPECT_NEAR(static_cast<double>(plain.orbits[0].steps),
              static_cast<double>(scaled.orbits[0].steps), 10);
  EXPECT_LE(scaled.drift, 1e-13);
}

TEST(SystemSection, ARegularOrbitHasMegnoTwoAndASaddleItsExponent) {
  const std::string frame =
      "[scene]\nsection = 'x - y'\nplot = ['x', 'u']\nindicator = 'megno'\ndirection = 'both'\n";
  const SystemSection regular = simulate(
      scene_of("[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
               "hamiltonian = '(u^2 + v^2)/2 + x^4/4 + 3*y^4/4'\n" +
               frame + "states = [[1, 0, 0, '1/2']]\ntime = 3000\n"));
  EXPECT_NEAR(regular.orbits[0].indicators.megno, 2, 0.1);
  EXPECT_LE(regular.orbits[0].indicators.lyapunov, 0.01);
  const SystemSection saddle =
      simulate(scene_of("[system]\nkind = 'vector-field'\ncoordinates = ['x', 'y', "
                        "'u']\n[system.field]\nx = '2*x'\ny = '-3*y'\nu = '1'\n" +
                        frame + "states = [['1/10^9', 1, 0]]\ntime = 12\n"));
  EXPECT_NEAR(saddle.orbits[0].indicators.lyapunov, 2,
              0.15); // x grows: so does its unit, log(26)/12
  const SystemSection lorenz = simulate([] {
    SystemScene s = scene_in("lorenz.toml", "lorenz_return");
    s.crossings = 4000;
    return s;
  }());
  for (const DrawnOrbit& o : lorenz.orbits) // 0.9056, Sprott
    EXPECT_NEAR(o.indicators.lyapunov, 0.9056, std::max(5 * o.indicators.lyapunov_error, 0.01));
}

TEST(SystemSection, ACollisionEndsAnOrbitWithItsName) {
  const std::string kepler =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "hamiltonian = '(u^2 + v^2)/2 - 1/r'\nrelations = ['r^2 = x^2 + "
      "y^2']\n[[system.function]]\nname = 'r'\n"
      "means = 'sqrt(x^2 + y^2)'\nderivative = {x = 'x/r', y = 'y/r'}\n"
      "[scene]\nsection = 'x - 1/2'\ndirection = 'both'\nplot = ['x', 'u']\ntime = 10\n";
  const SystemSection fall = simulate(scene_of(kepler + "states = [[1, 0, 0, 0]]\n"));
  EXPECT_EQ(fall.orbits[0].ended, Ended::singular);
  EXPECT_NEAR(fall.orbits[0].time, M_PI / std::sqrt(8.0), 1e-8); // falls from 1 to 0
  ASSERT_EQ(fall.points.size(), 1U);
  const SystemSection close =
      simulate(scene_of(kepler + "states = [[1, 0, 0, '1/1000']]\n")); // passes at 5e-7
  EXPECT_EQ(close.orbits[0].ended, Ended::time);
  EXPECT_LE(close.drift, 1e-6);
}

// Near the separatrix of the pendulum: H - 1 = +-10^-13 decides whether it turns over.
TEST(SystemSection, BesideASeparatrixTheSideIsKept) {
  const auto pendulum = [](const char* h) {
    return simulate(
        scene_of("[system]\nkind = 'hamiltonian'\ncoordinates = ['q']\nmomenta = "
                 "['p']\nhamiltonian = 'p^2/2 - c'\n"
                 "relations = ['s^2 + c^2 = 1']\n[[system.function]]\nname = 's'\nmeans = "
                 "'sin(q)'\nderivative = {q = 'c'}\n"
                 "[[system.function]]\nname = 'c'\nmeans = 'cos(q)'\nderivative = {q = '-s'}\n"
                 "[scene]\nsection = 's'\nwhere = 'c'\ndirection = 'both'\nplot = ['q', "
                 "'p']\ncrossings = 6\ntolerance = '10^-19'\n"
                 "states = [[0, '" +
                 std::string(h) + "']]\n"));
  };
  const SystemSection below = pendulum("2 - 1/10^13"), above = pendulum("2 + 1/10^13");
  ASSERT_EQ(below.points.size(), 6U);
  ASSERT_EQ(above.points.size(), 6U);
  EXPECT_LE(std::abs(below.points.back().at[0]), 1e-6);    // it swings back
  EXPECT_NEAR(above.points.back().at[0], 12 * M_PI, 1e-6); // it goes round
  EXPECT_LE(below.drift, 1e-14);
}

TEST(SystemSection, EverySheetOfTheLevelHasItsOrbit) {
  // u on the section: u^2/2 + u^4/4 + ... = h has +-; "both" keeps both signs, "upward" one
  const std::string text =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
      "hamiltonian = 'u^4/4 - u^2/2 + v^2/2 + x^2/2 + y^2/2'\n[scene]\nsection = 'x'\n"
      "levels = {H = '-1/8'}\nplot = ['y', 'v']\ncrossings = 3\nseeds = [['1/10', '1/10']]\n";
  EXPECT_EQ(simulate(scene_of(text + "direction = 'both'\n")).orbits.size(), 4U);
  EXPECT_EQ(simulate(scene_of(text)).orbits.size(), 2U); // where u^3 - u > 0
  // six coordinates, three levels: by Newton's method
  const SystemSection top =
      simulate(scene_of("format = 'scene/1'\nsystem = '" +
                        kov::test::in_source("/cases/sliding_top/sliding_top.toml") +
                        "'\nset = {A = 1, B = '2/3', C = '1/2', m = 1, g = 0, L1 = '8/9', L2 = 0, "
                        "L3 = 0}\nsection = 'M1'\n"
                        "levels = {H = '3/2', 'Gamma1^2 + Gamma2^2 + Gamma3^2' = 1, 'M1*Gamma1 + "
                        "M2*Gamma2 + M3*Gamma3' = '1/20'}\n"
                        "plot = ['Gamma1', 'M2']\ncrossings = 5\nseeds = [['1/10', '1/5']]\n"));
  EXPECT_GE(top.orbits.size(), 1U);
  EXPECT_LE(top.drift, 1e-13);
}

TEST(SystemScene, ComplaintsHaveAPlace) {
  const std::string good =
      "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\nparameters "
      "= ['a']\n"
      "hamiltonian = '(u^2 + v^2 + x^2 + a*y^2)/2'\n[scene]\nset = {a = 2}\nsection = 'x'\n"
      "levels = {H = 1}\nplot = ['y', 'v']\ncrossings = 3\nseeds = [[0, 0]]\n";
  EXPECT_EQ(simulate(scene_of(good)).points.size(), 3U);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"section = 'x'", "section = 'xx'"},
           {"section = 'x'", "section = '3'"},
           {"set = {a = 2}", ""},
           {"set = {a = 2}", "set = {b = 2}"},
           {"H = 1", "G = 1"},
           {"H = 1", "H = '-1'"},
           {"levels = {H = 1}", ""},
           {"crossings = 3", ""},
           {"crossings = 3", "crossing = 3"},
           {"plot = ['y', 'v']", "plot = ['y', 'v', 'u']"},
           {"[[0, 0]]", "[[0, 10]]"},
           {"[[0, 0]]", "[]"},
           {"set = {a = 2}", "set = {a = 'sqrt(-1)'}"}})
    EXPECT_THROW(static_cast<void>(simulate(scene_of(with(from, to)))), InputError) << to;
  EXPECT_EQ(simulate(scene_of(with("a = 2", "a = 'sqrt(2)'"))).points.size(), 3U);
}

} // namespace
} // namespace kov::flow::system_section_test
