// Leaves that rest on the closed criterion of a classical equation (strata_certificates.md 7.8):
// each family, after a change of variable, and what is close to it and false.

#include "certify/strata_text.hpp"

#include "certify/equation/statement.hpp"

#include <ctime>
#include <regex>

namespace kov::certify::strata_classical_test {
namespace {

std::vector<std::string> stated(const std::string& text) {
  return statement(read_strata_certificate(text), accepted(text));
}

std::string fraction(const std::string& num, const std::string& den = "1") {
  return R"({"num":")" + num + R"(","den":")" + den + R"("})";
}
std::string number(const std::string& square, const std::string& root = "") {
  return R"({"square":)" + square + (root.empty() ? "" : R"(,"root":)" + root) + "}";
}
std::string shown(const std::string& value, bool integral, const std::string& times = "1") {
  return R"(,"shown":[{"value":)" + value + R"(,"integral":)" + (integral ? "true" : "false") +
         R"(,"times":")" + times + R"(","membership":"0"}])";
}
std::string membership(const std::string& value, bool integral, const std::string& rational = "") {
  const std::string in_Q = rational.empty() ? "" : R"(,"rational":)" + rational;
  return in_Q + R"(,"memberships":[)" + value.substr(0, value.size() - 1) + R"(,"integral":)" +
         (integral ? "true" : "false") + "}]";
}

struct Leaf {
  std::string abelian = "where", by, change = fraction("z"), equation, numbers;
  std::string factors = {}, more = {};

  [[nodiscard]] std::string operator()() const {
    return R"({"node":"leaf","abelian":")" + abelian + R"(","by":")" + by + R"(","change":)" +
           change + R"(,"equation":)" + equation +
           (factors.empty() ? "" : R"(,"factors":)" + factors) + R"(,"numbers":[)" + numbers + "]" +
           more + "}";
  }
};

// ---- Bessel's equation: m = nu

const Leaf bessel{.by = "whittaker",
                  .equation = fraction("4*A^2 - 4*z^2 - 1", "4*z^2"),
                  .numbers = number(fraction("0")) + "," + number(fraction("A^2"), fraction("A"))};

StrataText bessel_text(const std::string& tree) {
  return {.num = "4*A^2 - 4*z^2 - 1", .den = "4*z^2", .tree = tree};
}

TEST(StrataClassical, BesselByItsOrder) {
  const auto text = bessel_text(bessel());
  EXPECT_ACCEPTED(text());
  EXPECT_EQ(accepted(text()).by_criterion, 1U);
  EXPECT_EQ(stated(text()).back(),
            "  always: abelian exactly where sqrt((A^2)/(1)) + 1/2 is an integer (whittaker)");
  for (const char* claim : {"true", "false"})
    EXPECT_REFUSED(replaced(text(), R"("abelian":null)", R"("abelian":)" + std::string(claim)),
                   "not every stratum");
  // another exponent, another sign, another root, a number too many
  const auto with = [](const std::string& part, const std::string& by) {
    return bessel_text(replaced(bessel(), part, by))();
  };
  EXPECT_REFUSED(with(R"("square":{"num":"A^2")", R"("square":{"num":"A^2 + 1")"), "another");
  EXPECT_REFUSED(with("4*A^2 - 4*z^2 - 1", "4*A^2 + 4*z^2 - 1"), "another equation");
  EXPECT_REFUSED(with("4*A^2 - 4*z^2 - 1", "4*A^2 - 4*z^2 + 1"), "another equation");
  EXPECT_REFUSED(with(R"("root":{"num":"A")", R"("root":{"num":"A + 1")"), "another square");
  EXPECT_REFUSED(with(R"("num":"0")", R"("num":"1")"), "another number");
  EXPECT_REFUSED(with(R"({"num":"z")", R"({"num":"2*z")"), "another equation");
  EXPECT_REFUSED(with(R"({"num":"z")", R"({"num":"A")"), "may be constant");
  EXPECT_REFUSED(with("whittaker", "bessel"), "numerator");
  EXPECT_REFUSED(with("whittaker", "riemann"), "places");
  EXPECT_REFUSED(with(R"("numbers":[)", R"("numbers":[{"square":{"num":"0","den":"1"}},)"),
                 "numbers of the family");
  EXPECT_ACCEPTED(with(R"("num":"z","den":"1")", R"("num":"-z","den":"1")"));
}

TEST(StrataClassical, MembershipsDecide) {
  const auto with = [](const std::string& abelian, const std::string& value, bool integral,
                       const std::string& assumed, bool is_in, const std::string& times = "1") {
    Leaf leaf = bessel;
    leaf.abelian = abelian;
    leaf.more = shown(value, integral, times);
    return bessel_text(leaf() + membership(assumed, is_in))();
  };
  const auto half = fraction("2*A - 1", "2");
  EXPECT_ACCEPTED(with("yes", half, true, half, true));
  EXPECT_ACCEPTED(with("no", half, false, half, false));
  EXPECT_ACCEPTED(with("yes", half, true, fraction("2*A + 7", "2"), true));
  EXPECT_ACCEPTED(with("yes", half, true, fraction("1 - 2*A", "2"), true, "-1"));
  EXPECT_ACCEPTED(with("no", half, false, fraction("2*A"), false, "2")); // 2A is none
  EXPECT_ACCEPTED(with("no", half, false, fraction("6*A"), false, "6"));
  // the other word, the other membership, the other class, twice and half
  EXPECT_REFUSED(with("no", half, true, half, true), "not shown to say");
  EXPECT_REFUSED(with("yes", half, false, half, false), "not shown to say");
  EXPECT_REFUSED(with("yes", half, true, half, false), "something else");
  EXPECT_REFUSED(with("no", half, false, half, true), "nothing follows");
  EXPECT_ACCEPTED(with("no", half, false, fraction("A"), true)); // A - 1/2 - A is not an integer
  EXPECT_ACCEPTED(with("no", half, false, fraction("6*A - 1", "3"), true, "2"));
  EXPECT_REFUSED(with("no", half, false, fraction("2*A"), true, "2"), "nothing follows");
  EXPECT_REFUSED(with("yes", half, true, fraction("A"), true), "nothing follows");
  EXPECT_REFUSED(with("yes", fraction("A"), true, fraction("A"), true), "not shown to say");
  EXPECT_REFUSED(with("no", half, false, fraction("A"), false), "nothing follows");
  EXPECT_REFUSED(with("yes", half, true, fraction("2*A"), true, "2"), "nothing follows");
  EXPECT_REFUSED(with("no", half, false, fraction("2*A"), false), "nothing follows");
  EXPECT_REFUSED(with("no", half, false, fraction("2*A", "3"), false, "2"), "nothing follows");
  Leaf bare = bessel;
  bare.abelian = "yes";
  EXPECT_REFUSED(bessel_text(bare() + membership(half, true))(), "not shown to say");
  EXPECT_REFUSED(bessel_text(bare())(), "not shown to say");
  bare.more = shown(half, true);
  EXPECT_REFUSED(bessel_text(bare())(), "no such membership");
  bare.more = shown(half, true, "10000000");
  EXPECT_REFUSED(bessel_text(bare() + membership(half, true))(), "limit");
}

// ---- the text: a parameter may be called k, m, n or Z

std::string without_brackets(const std::string& text) {
  return std::regex_replace(text, std::regex(R"(\([^()]*\))"), "");
}
// The criterion names nothing but the parameters, which stand in brackets.
void expect_no_letters(const std::string& certificate) {
  const std::string said = stated(certificate).back();
  EXPECT_FALSE(std::regex_search(without_brackets(said), std::regex(R"(\b[b-zA-Z]\b)"))) << said;
}

TEST(StrataClassical, AParameterMayBeCalledLikeTheOrder) {
  const std::string r = "16*m^2 - 4*z^2 + 16*m + 3"; // order 2m + 1
  const Leaf leaf{.by = "whittaker",
                  .equation = fraction(r, "4*z^2"),
                  .numbers = number(fraction("0")) + "," +
                             number(fraction("4*m^2 + 4*m + 1"), fraction("2*m + 1"))};
  const StrataText text{.parameters = R"(["m"])", .num = r, .den = "4*z^2", .tree = leaf()};
  EXPECT_ACCEPTED(text());
  EXPECT_EQ(stated(text()).back(),
            "  always: abelian exactly where sqrt((4*m^2 + 4*m + 1)/(1)) + 1/2 is an integer "
            "(whittaker)");
  expect_no_letters(text());
}

// ---- hostile: refused before anything is expanded

TEST(StrataClassical, OnlySmallEquations) {
  const auto with = [](const std::string& num, const std::string& den, const std::string& change) {
    Leaf leaf = bessel;
    leaf.equation = fraction(num, den);
    leaf.change = change;
    const std::clock_t start = std::clock();
    const std::string why = refusal(bessel_text(leaf())());
    EXPECT_LT(std::clock() - start, CLOCKS_PER_SEC) << num;
    return why;
  };
  EXPECT_NE(with("z^9999", "z^9999 + 1", fraction("z + 1")).find("family"), std::string::npos);
  EXPECT_NE(with("z^9999", "1", fraction("z^2 + A*z", "z - 1")).find("family"), std::string::npos);
  EXPECT_NE(with("z", "z^7", fraction("z + 1")).find("family"), std::string::npos);
  EXPECT_NE(with("z^5", "z^2", fraction("z + 1")).find("family"), std::string::npos);
  const std::string one = number(fraction("A^2"), fraction("A"));
  std::string numbers = one;
  for (int i = 0; i < 4; ++i)
    numbers += "," + one;
  EXPECT_REFUSED(
      bessel_text(replaced(replaced(bessel(), "whittaker", "bessel"), bessel.numbers, numbers))(),
      "numbers of the family");
  const std::string half = fraction("2*A - 1", "2");
  const std::string entry =
      R"({"value":)" + half + R"(,"integral":true,"times":"1","membership":"0"})";
  Leaf leaf = bessel;
  leaf.more = R"(,"shown":[)" + entry;
  for (int i = 0; i < 1000; ++i)
    leaf.more += "," + entry;
  leaf.more += "]";
  EXPECT_REFUSED(bessel_text(leaf() + membership(half, true))(), "a limit");
}

// z -> z^2 and z -> 1/z
TEST(StrataClassical, ChangesOfVariable) {
  Leaf leaf = bessel;
  leaf.change = fraction("z^2");
  StrataText text{.num = "16*A^2 - 16*z^4 - 1", .den = "4*z^2", .tree = leaf()};
  EXPECT_ACCEPTED(text());
  text.num = "16*A^2 - 16*z^4 - 4"; // without the Schwarzian derivative
  EXPECT_REFUSED(text(), "another equation");
  leaf.change = fraction("1", "z");
  text = {.num = "4*A^2*z^2 - z^2 - 4", .den = "4*z^4", .tree = leaf()};
  EXPECT_ACCEPTED(text());
  leaf.change = fraction("A*z"); // constant where A = 0
  text = {.num = "4*A^2 - 4*A^2*z^2 - 1", .den = "4*z^2", .tree = leaf()};
  EXPECT_REFUSED(text(), "may be constant");
  text.tree = split("A", leaf(), open_zero);
  EXPECT_ACCEPTED(text());
}

// ---- Whittaker: a/4 + b/z + ..., k^2 = b^2/a

TEST(StrataClassical, WhittakersNumbers) {
  Leaf leaf{.by = "whittaker",
            .equation = fraction("z^2 - 4*A*z + 4*B^2 - 1", "4*z^2"),
            .numbers = number(fraction("A^2"), fraction("A")) + "," +
                       number(fraction("B^2"), fraction("B"))};
  StrataText text{.parameters = R"(["A","B"])",
                  .num = "z^2 - 4*A*z + 4*B^2 - 1",
                  .den = "4*z^2",
                  .tree = leaf()};
  EXPECT_ACCEPTED(text());
  expect_no_letters(text());
  leaf.abelian = "no";
  const auto value = fraction("2*A + 2*B - 1", "2");
  leaf.more = shown(value, false);
  const auto with = [&](const std::string& given) {
    text.tree = leaf() + membership(given, false);
    return text();
  };
  EXPECT_ACCEPTED(with(value));
  EXPECT_REFUSED(with(fraction("A + B", "2")), "nothing follows");
  leaf.more = shown(fraction("2*B"), false); // 2m
  EXPECT_ACCEPTED(with(fraction("2*B")));
  leaf.more = shown(fraction("A"), false); // k
  EXPECT_REFUSED(with(fraction("A")), "not shown to say");
  leaf.abelian = "yes"; // both integers, and no word of their signs
  leaf.more = shown(value, true);
  text.tree = leaf() + membership(value, true);
  EXPECT_REFUSED(text(), "not shown to say");
  // numbers that do not depend on the parameter: k = 1, m = 3/2, then m = 1/2
  leaf = {.abelian = "yes",
          .by = "whittaker",
          .equation = fraction("A^2*z^2 - 4*A*z + 8", "4*z^2"),
          .numbers = number(fraction("1")) + "," + number(fraction("9", "4"))};
  text.num = "A^2*z^2 - 4*A*z + 8";
  text.tree = split("A", leaf(), open_zero);
  EXPECT_ACCEPTED(text());
  EXPECT_REFUSED(replaced(text(), R"("abelian":"yes")", R"("abelian":"no")"), "not shown to say");
  text.tree = leaf();
  EXPECT_REFUSED(text(), "numerator");
}

// ---- ramified: b/z + (n^2 - 1)/(4 z^2)

TEST(StrataClassical, RamifiedBessel) {
  const Leaf leaf{.by = "bessel",
                  .equation = fraction("4*B*z + A^2 - 1", "4*z^2"),
                  .numbers = number(fraction("A^2"), fraction("A"))};
  StrataText text{.parameters = R"(["A","B"])",
                  .num = "4*B*z + A^2 - 1",
                  .den = "4*z^2",
                  .tree = split("B", leaf(), open_zero)};
  EXPECT_ACCEPTED(text());
  StrataText not_zero = text;
  not_zero.assumptions = R"([{"p":"B","sign":"nonzero"}])";
  not_zero.tree = leaf();
  expect_no_letters(not_zero());
  EXPECT_REFUSED(replaced(text(), R"({"num":"A^2","den":"1"})", R"({"num":"A^2","den":"4"})"),
                 "another square");
  text.tree = leaf(); // B may be 0: Euler's equation, always abelian
  EXPECT_REFUSED(text(), "numerator");
}

// ---- Legendre: 0, 0, 2n + 1

const Leaf legendre{.by = "riemann",
                    .equation = fraction("A^2*z^2 + A*z^2 - A^2 - A - 1", "z^4 - 2*z^2 + 1"),
                    .numbers = number(fraction("0")) + "," +
                               number(fraction("4*A^2 + 4*A + 1"), fraction("2*A + 1")),
                    .factors = R"(["z^2 - 1"])"};

StrataText legendre_text(const std::string& tree) {
  return {.num = "A^2*z^2 + A*z^2 - A^2 - A - 1", .den = "z^4 - 2*z^2 + 1", .tree = tree};
}

TEST(StrataClassical, LegendresIndex) {
  EXPECT_ACCEPTED(legendre_text(legendre())());
  expect_no_letters(legendre_text(legendre())());
  Leaf leaf = legendre;
  leaf.abelian = "yes";
  leaf.more = shown(fraction("A"), true);
  EXPECT_ACCEPTED(legendre_text(leaf() + membership(fraction("A"), true))());
  EXPECT_REFUSED(legendre_text(leaf() + membership(fraction("2*A"), true))(), "nothing follows");
  leaf.abelian = "no";
  leaf.more = shown(fraction("A"), false);
  EXPECT_ACCEPTED(legendre_text(leaf() + membership(fraction("A"), false))());
  const auto with = [](const std::string& part, const std::string& by) {
    return legendre_text(replaced(legendre(), part, by))();
  };
  EXPECT_REFUSED(with(R"(["z^2 - 1"])", R"(["z - 1"])"), "enough places");
  EXPECT_REFUSED(with(R"(["z^2 - 1"])", R"(["z^2 - 2*z + 1"])"), "may meet");
  EXPECT_REFUSED(with(R"(["z^2 - 1"])", R"(["z^2 - 2"])"), "denominator");
  EXPECT_REFUSED(with(R"("numbers":[{"square":{"num":"0")", R"("numbers":[{"square":{"num":"1")"),
                 "another exponent difference");
  EXPECT_REFUSED(with("4*A^2 + 4*A + 1", "4*A^2 + 4*A + 2"), "another");
  EXPECT_REFUSED(with("riemann", "lame"), "enough places");
}

// Three parameters: a sum that is odd says nothing of irrational numbers.
TEST(StrataClassical, RationalExponents) {
  const Leaf leaf{.abelian = "yes",
                  .by = "riemann",
                  .equation = fraction("C^2*z^2 + B^2*z - C^2*z - A^2*z - z^2 + A^2 + z - 1",
                                       "4*z^4 - 8*z^3 + 4*z^2"),
                  .numbers = number(fraction("A^2"), fraction("A")) + "," +
                             number(fraction("B^2"), fraction("B")) + "," +
                             number(fraction("C^2"), fraction("C")),
                  .factors = R"(["z","z - 1"])",
                  .more = shown(fraction("A + B + C - 1", "2"), true)};
  StrataText text{.parameters = R"(["A","B","C"])",
                  .num = "C^2*z^2 + B^2*z - C^2*z - A^2*z - z^2 + A^2 + z - 1",
                  .den = "4*z^4 - 8*z^3 + 4*z^2"};
  const auto odd = fraction("A + B + C - 1", "2");
  text.tree = leaf() + membership(odd, true, R"(["A","B"])");
  EXPECT_ACCEPTED(text());
  text.tree = leaf() + membership(odd, true, R"(["A"])");
  EXPECT_REFUSED(text(), "not shown to say");
  text.tree = leaf() + membership(fraction("A + B + C", "2"), true, R"(["A","B","C"])");
  EXPECT_REFUSED(text(), "nothing follows");
}

// ---- Lame: (2n + 1)^2 = 1 + 4 n(n+1), f = 4 z^3 - 4 z

TEST(StrataClassical, LamesIndex) {
  // f''/(4f) - 3 f'^2/(16 f^2) + (n(n+1) z + 1)/f, times 16 f^2 = 256 (z^3 - z)^2
  const std::string num = "64*A^2*z^4 + 64*A*z^4 - 48*z^4 + 64*z^3 - 64*A^2*z^2 - 64*A*z^2"
                          " - 96*z^2 - 64*z - 48";
  const std::string den = "256*z^6 - 512*z^4 + 256*z^2";
  Leaf leaf{.by = "lame",
            .equation = fraction(num, den),
            .numbers = number(fraction("1", "4")) + "," +
                       number(fraction("4*A^2 + 4*A + 1"), fraction("2*A + 1")),
            .factors = R"(["z^3 - z"])"};
  StrataText text{.num = num, .den = den, .tree = leaf()};
  EXPECT_ACCEPTED(text());
  expect_no_letters(text());
  EXPECT_REFUSED(replaced(text(), R"("num":"1","den":"4")", R"("num":"1","den":"9")"), "another");
  EXPECT_REFUSED(replaced(text(), R"("by":"lame")", R"("by":"riemann")"), "another place");
  const auto with = [&](const std::string& abelian, const std::string& value, bool integral,
                        const std::string& given) {
    leaf.abelian = abelian;
    leaf.more = shown(value, integral);
    text.tree = leaf() + membership(given, integral);
    return text();
  };
  EXPECT_ACCEPTED(with("yes", fraction("A"), true, fraction("A")));
  EXPECT_ACCEPTED(with("no", fraction("60*A"), false, fraction("60*A")));
  EXPECT_REFUSED(with("no", fraction("A"), false, fraction("A")), "not shown to say");
  EXPECT_REFUSED(with("no", fraction("6*A"), false, fraction("6*A")), "not shown to say");
  EXPECT_REFUSED(with("yes", fraction("2*A"), true, fraction("2*A")), "not shown to say");
}

} // namespace
} // namespace kov::certify::strata_classical_test
