// Certificates over strata made to keep the judge busy: each ends in one reason, at once
// (docs/theory/strata_certificates.md 2).

#include "certify/strata_text.hpp"

#include <ctime>

namespace kov::certify::strata_hostile_test {
namespace {

// Refused, in a few seconds.
void refuse(const std::string& text, const std::string& words = "") {
  const std::clock_t start = std::clock();
  const std::string why = refusal(text);
  EXPECT_FALSE(why.empty()) << text.substr(0, 300);
  EXPECT_NE(why.find(words), std::string::npos) << why;
  EXPECT_LT(std::clock() - start, 8 * CLOCKS_PER_SEC) << why;
}

const std::string nine = R"(["a","b","c","d","e","f","g","h","k"])";

// (a + b + ... + 1) with the power e of each
std::string sum_of_all(const std::string& e = "1") {
  std::string s = "1";
  for (const char c : std::string("abcdefghk"))
    s += std::string(" + ") + c + "^" + e;
  return s;
}

std::string positive_lemma(const std::string& p, const std::string& terms) {
  return lemmas(R"({"p":")" + p + R"(","sign":"positive","terms":[)" + terms + "]}", open_node);
}

TEST(StrataHostile, Texts) {
  std::string nested_splits = open_node;
  for (int i = 0; i < 70; ++i)
    nested_splits = split("A", nested_splits, open_zero);
  refuse(StrataText{.tree = nested_splits}(), "64 deep");
  refuse(StrataText{.tree = std::string(100000, '[')}(), "deeply");
  std::string flat = "1";
  for (int i = 0; i < 20001; ++i)
    flat += " + A";
  refuse(StrataText{.num = flat, .tree = open_node}(), "20000 terms");
  refuse(StrataText{.num = "A^99999999999999999999", .tree = open_node}(), "10000");
  refuse(StrataText{.num = std::string(300000, '9'), .tree = open_node}(), "natural number");
  refuse(StrataText{.num = "1.5", .tree = open_node}(), "' + '");
  refuse(StrataText{.parameters = R"(["a","b","c","d","e","f","g","h","k","l","m","n","o"])",
                    .tree = open_node}(),
         "12 parameters");
}

// Powers and products that do not fit anywhere.
TEST(StrataHostile, Products) {
  StrataText t{.parameters = nine, .real = nine};
  t.assumptions = R"([{"p":")" + sum_of_all() + R"(","sign":"positive"}])";
  t.tree = positive_lemma("a", R"(["1",["condition","0","9999"]])");
  refuse(t(), "a limit");
  t.tree = positive_lemma("a", R"(["1",["square",")" + sum_of_all("9999") + R"(","9999"]])");
  refuse(t(), "a limit");
  // the same power in small pieces
  std::string factors = R"("1")";
  for (int i = 0; i < 2000; ++i)
    factors += R"(,["condition","0","1"])";
  t.tree = positive_lemma("a", "[" + factors + "]");
  refuse(t(), "a limit");
  // numbers
  t.assumptions = "[]";
  t.parameters = R"(["A"])";
  t.real = "[]";
  t.tree = positive_lemma("A", R"(["1",["square",")" + std::string(10000, '7') + R"(","9999"]])");
  refuse(t(), "a limit");
  // common denominators
  std::string terms;
  for (long i = 0; i < 60000; ++i)
    terms += R"(["1/)" + std::to_string(1000000007L + 2 * i) + "\"],";
  t.tree = positive_lemma("A", terms + R"(["1"])");
  refuse(t(), "a limit");
}

// x^9999 divided by x - (a + b + ...): the quotient of school division has no end.
TEST(StrataHostile, Divisions) {
  StrataText t{.parameters = nine};
  const std::string g = "a - b - c - d - e - f - g - h - k";
  t.tree =
      split(g, split(sum_of_all("9999"), split("b", open_node, empty_zero), empty_zero), open_zero);
  refuse(t(), "a limit");
  // solve: f of degree 9999 in x = -m/l
  t.tree = split("a*b - c - d - e - f - 1", open_node, open_zero);
  t.tree = split("b",
                 split(sum_of_all("9999"),
                       split("a*b - c - d - e - f - 1", open_node, solve("a", "z", "1", open_node)),
                       open_zero),
                 open_zero);
  refuse(t(), "a limit");
}

TEST(StrataHostile, Places) {
  StrataText t{.parameters = nine, .num = "z", .den = "z"};
  // orders and exponents far outside den
  t.tree = places("torus", "1", place("z", "9223372036854775807"));
  refuse(t(), "impossible");
  t.tree = places("torus", "1", place("z", "-1"));
  refuse(t(), "impossible");
  t.tree = leaf("yes", "invariant",
                R"("content":"1","places":[{"q":"z","order":"1","e":"1)" + std::string(300, '0') +
                    R"("}],"m":"2","p":"1")");
  refuse(t(), "too large");
  // a resultant of two dense polynomials in nine parameters
  std::string q = "z^12";
  std::string num = "z^11";
  for (int i = 0; i < 11; ++i) {
    for (const char c : std::string("abcdefghk")) {
      q += std::string(" + ") + c + "^" + std::to_string(i + 1) + "*z^" + std::to_string(i);
      num += std::string(" - ") + c + "^" + std::to_string(i + 2) + "*z^" + std::to_string(i);
    }
  }
  t.num = num;
  t.den = q;
  t.tree = places("irreducible-log", "1", place(q, "1"));
  refuse(t(), "a limit");
  // Sym^200 of it
  t.tree = leaf("yes", "invariant",
                R"("content":"1","places":[{"q":")" + q +
                    R"(","order":"1","e":"1"}],"m":"200","p":"z")");
  refuse(t(), "a limit");
}

TEST(StrataHostile, Values) {
  StrataText t{.real = R"(["A"])", .num = "z^2 + A", .den = "z^2"};
  const std::string zeros(299, '0');
  t.assumptions = R"([{"p":"10)" + zeros + R"( - A","sign":"positive"}])";
  // B - Delta^2 = 4 (10^300 - A)
  t.tree = places("one-open", "1",
                  place("z", "2", R"("chi":["-4*A - 1","1"],"bound":"40)" + zeros + "\""));
  refuse(t(), "not proved");
  t.tree = replaced(t.tree, "40" + zeros, "40" + zeros.substr(1) + "1");
  refuse(t(), "a limit");
  t.tree = replaced(t.tree, "one-open", "open");
  refuse(t(), "a limit");
}

// The matrix of an invariant with more unknowns than are allowed, and an m outside the limits.
TEST(StrataHostile, Matrices) {
  StrataText t{.num = "A*z^2 + 9999", .den = "4*z^2"}; // Delta = 100
  const auto with = [&](const std::string& m) {
    t.tree = split("A",
                   places("torus", "4", place("z", "2", R"("chi":["-10000","1"])"), "",
                          R"(,"absent":[{"m":")" + m + R"(","minors":[]}])"),
                   open_zero);
    return t();
  };
  refuse(with("4"), "a limit: the size of a linear system");
  refuse(with("1000000000"), "degree 4");
}

// Many nodes with long lists of conditions.
TEST(StrataHostile, Copies) {
  StrataText t{.parameters = R"(["A"])"};
  std::string conditions = R"({"p":"A","sign":"nonnegative"})";
  for (int i = 0; i < 20000; ++i)
    conditions += R"(,{"p":"A","sign":"nonnegative"})";
  t.assumptions = "[" + conditions + "]";
  // copied at every node
  std::string tree = open_node;
  for (int i = 0; i < 12; ++i)
    tree = split("A", tree, solve("A", "z", "1", open_node));
  t.tree = tree;
  const std::clock_t start = std::clock();
  EXPECT_EQ(refusal(t()), "");
  EXPECT_LT(std::clock() - start, 8 * CLOCKS_PER_SEC);
}

} // namespace
} // namespace kov::certify::strata_hostile_test
