// Leaves with places of certificates over strata (docs/theory/strata_certificates.md 7): every
// theorem with an equation to which it applies, and what is close to it and false.

#include "certify/strata_text.hpp"

namespace kov::certify::strata_leaves_test {
namespace {

// y'' = (z^2 + A) y: D_4 = -2; z + A: order 5 at infinity.
TEST(StrataTorus, IrregularAtInfinity) {
  for (const char* num : {"z^2 + A", "z + A", "z^3 + A*z - A"})
    EXPECT_ACCEPTED((StrataText{.num = num, .claim = "false", .tree = airy_leaf}()));
  // the order may drop where A = 0
  EXPECT_REFUSED((StrataText{.num = "A*z + 1", .tree = airy_leaf}()),
                 "the order at infinity may drop");
  EXPECT_REFUSED((StrataText{.num = "A", .tree = airy_leaf}()), "the order at infinity may drop");
  EXPECT_REFUSED((StrataText{.num = "0", .tree = airy_leaf}()), "r is 0");
  EXPECT_REFUSED((StrataText{.num = "z", .den = "A", .tree = airy_leaf}()), "not the product");
  EXPECT_REFUSED((StrataText{.num = "z", .den = "A", .tree = places("torus", "A", "")}()),
                 "content is not known");
  EXPECT_REFUSED(
      (StrataText{.num = "z + A", .tree = places("torus", "1", "", R"("chi":["1","1"])")}()),
      "another order than 2");
  EXPECT_REFUSED((StrataText{.num = "z + A", .tree = places("bus", "1", "")}()), "unknown theorem");
  EXPECT_REFUSED((StrataText{.num = "z + A", .tree = places("torus-log", "1", "")}()), "logarithm");
  EXPECT_REFUSED((StrataText{.num = "1", .tree = airy_leaf}()), "degree 4"); // abelian
}

// 1/(4 z^2) + A/z: Delta^2 = 2 at 0, order 3 at infinity where A is not 0.
TEST(StrataTorus, ConstantIrrationalDifference) {
  StrataText t{.num = "1 + 4*A*z", .den = "4*z^2"};
  const auto with = [&](const std::string& q) {
    t.tree = split("A", places("torus", "4", q), open_zero);
    return t();
  };
  const std::string good = place("z", "2", R"("chi":["-2","1"],"irrational":"constant")");
  EXPECT_ACCEPTED(with(good));
  EXPECT_ACCEPTED(with(replaced(good, R"("-2","1")", R"("-2*A","A")")));
  EXPECT_REFUSED(with(replaced(good, "-2", "-3")), "chi does not vanish");
  EXPECT_REFUSED(with(replaced(good, "-2", "-2*A")), "chi does not vanish");
  EXPECT_REFUSED(with(replaced(good, "constant", "positive")), "one sign");
  EXPECT_REFUSED(with(replaced(good, "constant", "discriminant")), "degree 2");
  EXPECT_REFUSED(with(replaced(good, "constant", "generic")), "is expected");
  EXPECT_REFUSED(with(replaced(good, R"(,"irrational":"constant")", "")), "is open");
  EXPECT_REFUSED(with(place("z", "2")), "not known");
  EXPECT_REFUSED(with(place("z", "2", R"("irrational":"constant")")), "chi is missing");
  EXPECT_REFUSED(with(place("z", "1")), "not the product");
  EXPECT_REFUSED(with(place("z - 1", "2", R"("chi":["-2","1"],"irrational":"constant")")),
                 "not the product");
  // Delta^2 = 4 is not an irrational number
  t.num = "3 + 4*A*z";
  EXPECT_REFUSED(with(replaced(good, "-2", "-4")), "is rational");
}

// -(A + 1)/(4 z^2) + 1/z: Delta^2 = -A < 0.
TEST(StrataTorus, NegativeSquares) {
  StrataText t{.num = "4*z - A - 1", .den = "4*z^2", .claim = "false"};
  t.assumptions = R"([{"p":"A","sign":"positive"}])";
  t.tree = places("torus", "4", place("z", "2", R"("chi":["A","1"],"irrational":"positive")"));
  EXPECT_ACCEPTED(t());
  EXPECT_ACCEPTED(replaced(t(), R"(["A","1"])", R"(["-3*A","-3"])"));
  EXPECT_REFUSED(replaced(t(), R"(["A","1"])", R"(["-A","1"])"), "chi does not vanish");
  EXPECT_REFUSED(replaced(t(), "positive\"}]", "nonnegative\"}]"), "one sign");
  EXPECT_REFUSED(replaced(t(), "positive\"}]", "nonzero\"}]"), "one sign");
  EXPECT_REFUSED(replaced(t(), R"(["A","1"])", R"(["A^2","A"])"), "one sign");
}

// B z/(z^2 + 1)^2: Delta^2 = 1 -+ iB, chi = T^2 - 2T + 1 + B^2, and a logarithm at infinity.
TEST(StrataTorus, ComplexSquares) {
  StrataText t{.parameters = R"(["B"])",
               .real = R"(["B"])",
               .num = "B*z",
               .den = "z^4 + 2*z^2 + 1",
               .claim = "false"};
  t.assumptions = R"([{"p":"B","sign":"positive"}])";
  const std::string torus =
      places("torus-log", "1",
             place("z^2 + 1", "2", R"("chi":["B^2 + 1","-2","1"],"irrational":"discriminant")"));
  t.tree = lemmas(R"({"p":"B^2","sign":"positive","terms":[["1",["square","B","1"]]]})", torus);
  EXPECT_ACCEPTED(t());
  EXPECT_REFUSED(replaced(t(), R"("B^2 + 1")", R"("B^2 + 2")"), "chi does not vanish");
  EXPECT_REFUSED(replaced(t(), R"("irrational":"discriminant")", R"("irrational":"positive")"),
                 "one sign");
  EXPECT_REFUSED(replaced(t(), R"(,"irrational":"discriminant")", ""), "no place shows a torus");
  EXPECT_REFUSED(replaced(t(), R"("order":"2")", R"("order":"3")"), "not those of den");
  t.real = "[]";
  EXPECT_REFUSED(replaced(t(), R"("square","B","1")", R"("condition","0","2")"), "not real");
  t.real = R"(["B"])";
  t.tree = torus;
  EXPECT_REFUSED(t(), "not known to be negative");
}

// (A z + B)/(z^2 - 2)^2 + 1/z: a torus at infinity and a logarithm at 0; the exponents at
// z^2 = 2, Delta^2 = 1 + (B +- A sqrt(2))/2, are of no importance there, and elsewhere are needed.
TEST(StrataTorusLog, AsksNothingOfOpenPlaces) {
  StrataText t{.parameters = R"(["A","B"])",
               .num = "A*z^2 + B*z + z^4 - 4*z^2 + 4",
               .den = "z^5 - 4*z^3 + 4*z",
               .claim = "false"};
  const std::string chi = R"("chi":["B^2 - 2*A^2 + 4*B + 4","-4*B - 8","4"])";
  const auto by = [&](const std::string& theorem) {
    t.tree = places(theorem, "1", place("z", "1") + "," + place("z^2 - 2", "2", chi));
    return t();
  };
  EXPECT_ACCEPTED(by("torus-log"));
  EXPECT_REFUSED(replaced(by("torus-log"), "4*B + 4", "4*B + 5"), "chi does not vanish");
  EXPECT_ACCEPTED(by("irreducible-log")); // ramified at infinity
  for (const std::string theorem : {"torus", "rational", "one-open", "open"})
    EXPECT_REFUSED(by(theorem), "an exponent difference is not known");
}

// q may not have multiple roots or share them.
TEST(StrataPlaces, AreSeparate) {
  StrataText t{.num = "1", .den = "z^2 - A"};
  t.tree = split("A", places("irreducible-log", "1", place("z^2 - A", "1")), open_zero);
  EXPECT_REFUSED(t(), "an exponential solution");
  StrataText two = t;
  two.tree = places("irreducible-log", "1", place("z^2 - A", "1"));
  EXPECT_REFUSED(two(), "multiple root");
  two.den = "z^2 - A*z";
  two.tree = places("irreducible-log", "1", place("z", "1") + "," + place("z - A", "1"));
  EXPECT_REFUSED(two(), "common root");
  two.den = "A*z^2 + z";
  two.tree = places("irreducible-log", "1", place("z", "1") + "," + place("A*z + 1", "1"));
  EXPECT_REFUSED(two(), "leading coefficient of a place");
  two.den = "z^2 - 1";
  two.num = "z - A";
  two.tree = places("irreducible-log", "1", place("z - 1", "1") + "," + place("z + 1", "1"));
  EXPECT_REFUSED(two(), "the order of a place may drop");
}

// A/(z (z-1) (z+1)): three logarithms and one at infinity, D_1 = -3.
TEST(StrataIrreducibleLog, DegreeBound) {
  StrataText t{.num = "A", .den = "z^3 - z", .claim = "false"};
  t.assumptions = R"([{"p":"A","sign":"nonzero"}])";
  t.tree = places("irreducible-log", "1", place("z", "1") + "," + place("z^2 - 1", "1"));
  EXPECT_ACCEPTED(t());
  EXPECT_ACCEPTED(replaced(t(), R"("order":"1"}])", R"("order":"1","log":true}])"));
  t.assumptions = "[]";
  EXPECT_REFUSED(t(), "the order of a place may drop");
}

// A/(z (z-1)): Delta^2 = 1 + 4A at infinity, D_1 = -1 - (1 - |Re Delta|)/2 < 0 for |Re Delta| < 3.
TEST(StrataIrreducibleLog, BoundedDifference) {
  StrataText t{.real = R"(["A"])", .num = "A", .den = "z^2 - z", .claim = "false"};
  t.assumptions = R"([{"p":"A","sign":"nonzero"},{"p":"1 - A","sign":"positive"}])";
  t.tree = places("irreducible-log", "1", place("z", "1") + "," + place("z - 1", "1"),
                  R"("chi":["-4*A - 1","1"],"bound":"5")");
  EXPECT_ACCEPTED(t());
  EXPECT_REFUSED(replaced(t(), R"("bound":"5")", R"("bound":"4")"), "the bound is not proved");
  EXPECT_REFUSED(replaced(t(), R"(,"bound":"5")", ""), "an exponential solution");
  EXPECT_REFUSED(replaced(t(), R"("-4*A - 1")", R"("-4*A + 1")"), "chi does not vanish");
  EXPECT_REFUSED(replaced(t(), "positive", "nonnegative"), "the bound is not proved");
  // |Re Delta| = 3 for Delta^2 = 9: a polynomial solution may exist
  StrataText wide = t;
  wide.assumptions = replaced(t.assumptions, "1 - A", "2 - A");
  wide.tree = replaced(t.tree, R"("bound":"5")", R"("bound":"9")");
  EXPECT_REFUSED(wide(), "an exponential solution");
  // one open place, and chi(9) = 8 - 4A is not 0: the same by values of Delta
  wide.tree = replaced(wide.tree, "irreducible-log", "one-open");
  EXPECT_ACCEPTED(wide());
  wide.assumptions = replaced(t.assumptions, "1 - A", "7 - 4*A"); // Delta^2 < 8
  EXPECT_REFUSED(replaced(wide(), R"("bound":"9")", R"("bound":"25/4")"),
                 "the bound is not proved");
  wide.assumptions = replaced(t.assumptions, "1 - A", "3 - A"); // Delta^2 < 13, Delta = 3 at A = 2
  EXPECT_REFUSED(replaced(wide(), R"("bound":"9")", R"("bound":"13")"),
                 "difference 3 is not excluded");
}

// A bound needs a real chi_1: A = C = i gives Delta^2 = 1 though A^2 C^2 > 0.
TEST(StrataOpen, BoundsAreReal) {
  StrataText t{.parameters = R"(["A","C"])", .num = "-C^2*z - z + 4*C^2", .den = "4*C^2*z^3"};
  t.num = "4*C^2*z - C^2 - 1";
  t.den = "4*C^2*z^2"; // Delta^2 = -1/C^2
  t.assumptions = R"([{"p":"A*C","sign":"nonzero"},{"p":"A^2*C^2","sign":"positive"}])";
  const std::string known =
      R"({"p":"C","times":"A","sign":"nonzero"},{"p":"A","times":"C","sign":"nonzero"})";
  t.tree =
      lemmas(known, places("open", "4*C^2", place("z", "2", R"("chi":["A","A*C^2"],"bound":"0")")));
  EXPECT_REFUSED(t(), "not known to be real");
  t.real = R"(["A","C"])";
  EXPECT_ACCEPTED(t());
}

// 1 + A/z^2, Bessel: Delta^2 = 1 + 4A < 9; abelian for Delta = 1, 3, ... only.
TEST(StrataOneOpen, Torus) {
  StrataText t{.real = R"(["A"])", .num = "z^2 + A", .den = "z^2", .claim = "null"};
  t.assumptions = R"([{"p":"2 - A","sign":"positive"}])";
  const std::string open =
      places("one-open", "1", place("z", "2", R"("chi":["-4*A - 1","1"],"bound":"9")"));
  const std::string zero = solve("A", "1", "1", number("yes", exponential));
  const std::string other = solve("A", "4*z^2 + 3", "4*z^2", number("no", bessel_1));
  t.tree = split("A", split("4*A - 3", open, other), zero);
  EXPECT_ACCEPTED(t());
  EXPECT_EQ(accepted(t()).not_abelian, 2U);
  EXPECT_EQ(accepted(t()).abelian, 1U);
  t.tree = split("A", open, zero);
  EXPECT_REFUSED(t(), "difference 2 is not excluded");
  t.tree = split("4*A - 3", open, other);
  EXPECT_REFUSED(t(), "difference 1 is not excluded");
  t.assumptions = R"([{"p":"3 - A","sign":"positive"}])";
  t.tree = split("A", split("4*A - 3", open, other), zero);
  EXPECT_REFUSED(t(), "the bound is not proved");
  EXPECT_REFUSED(replaced(t(), R"("bound":"9")", R"("bound":"13")"),
                 "difference 3 is not excluded");
  EXPECT_REFUSED(replaced(t(), R"(,"bound":"9")", ""), "has no bound");
  t.assumptions = R"([{"p":"2 - A","sign":"positive"}])";
  EXPECT_REFUSED(replaced(t(), "one-open", "torus"), "is open");
}

// A/z^2 + B/(z-1)^2 + 1 with A, B < 0: Delta^2 < 1 at both places.
TEST(StrataOpen, SeveralPlaces) {
  StrataText t{.parameters = R"(["A","B"])", .real = R"(["A","B"])", .claim = "false"};
  t.num = "A*z^2 - 2*A*z + A + B*z^2 + z^4 - 2*z^3 + z^2";
  t.den = "z^4 - 2*z^3 + z^2";
  t.assumptions =
      R"([{"p":"-A","sign":"positive"},{"p":"-B","sign":"positive"},{"p":"16*A + 3","sign":"nonzero"},{"p":"16*B + 3","sign":"nonzero"}])";
  t.tree = places("open", "1",
                  place("z", "2", R"("chi":["-4*A - 1","1"],"bound":"1")") + "," +
                      place("z - 1", "2", R"("chi":["-4*B - 1","1"],"bound":"1")"));
  EXPECT_ACCEPTED(t());
  EXPECT_REFUSED(replaced(t(), "16*A + 3", "16*A + 1"), "difference 1/2 is not excluded");
  EXPECT_REFUSED(replaced(t(), "16*B + 3", "16*B + 1"), "difference 1/2 is not excluded");
  EXPECT_REFUSED(replaced(t(), R"(,"bound":"1")", ""), "has no bound");
  EXPECT_REFUSED(replaced(t(), R"("open")", R"("one-open")"), "not exactly one");
  // no open place at all proves nothing
  EXPECT_REFUSED((StrataText{.num = "z + A", .tree = places("open", "1", "")}()), "is open");
}

// Delta = 0 at 0, 1, -1 and infinity, and Delta = 1/3 at all four: SL(2) for all accessory
// parameters.
TEST(StrataRational, FourPlaces) {
  const std::string three =
      place("z", "2", R"("chi":["0","1"])") + "," + place("z^2 - 1", "2", R"("chi":["0","1"])");
  StrataText t{
      .num = "-z^4 + A*z^3 - 2*z^2 - A*z - 1", .den = "4*z^6 - 8*z^4 + 4*z^2", .claim = "false"};
  t.tree = places("rational", "4", three, R"("chi":["0","1"])");
  EXPECT_ACCEPTED(t());
  EXPECT_REFUSED(replaced(t(), "A*z^3", "A^2*z^3"), "chi does not vanish");
  EXPECT_ACCEPTED(replaced(t(), R"("rational")", R"("irreducible-log")"));
  StrataText u{
      .num = "-2*z^4 + A*z^3 - 4*z^2 - A*z - 2", .den = "9*z^6 - 18*z^4 + 9*z^2", .claim = "false"};
  const std::string third = R"("chi":["-1","9"])";
  u.tree =
      places("rational", "9", place("z", "2", third) + "," + place("z^2 - 1", "2", third), third);
  EXPECT_ACCEPTED(u());
  EXPECT_REFUSED(replaced(u(), R"("rational")", R"("irreducible-log")"),
                 "no place has a logarithm");
  EXPECT_REFUSED(replaced(u(), R"("rational")", R"("torus")"), "no place shows a torus");
  EXPECT_REFUSED(replaced(u(), R"("rational")", R"("open")"), "is open");
}

// 3/(4 z^2) + A/z + B: Delta = 2, the defect is B - A^2.  In z -> C z - 1 as well.
TEST(StrataLogarithm, Defect) {
  StrataText t{.parameters = R"(["A","B"])", .num = "4*B*z^2 + 4*A*z + 3", .den = "4*z^2"};
  const auto with = [&](const std::string& known, const std::string& q,
                        const std::string& content) {
    t.tree = split(
        "B",
        split(known, places("torus-log", content, place(q, "2", R"("chi":["-4","1"],"log":true)")),
              open_zero),
        open_zero);
    return t();
  };
  EXPECT_ACCEPTED(with("A^2 - B", "z", "4"));
  EXPECT_ACCEPTED(with("A^2 - B", "2*z", "1"));
  EXPECT_REFUSED(with("A^2 + B", "z", "4"), "the logarithm is not proved");
  EXPECT_REFUSED(with("A", "z", "4"), "the logarithm is not proved");
  EXPECT_REFUSED(replaced(with("A^2 - B", "z", "4"), R"(,"log":true)", ""),
                 "no place has a logarithm");
  t.num = "16*B*z^2 - 16*B*z + 4*B + 16*A*z - 8*A + 12";
  t.den = "16*z^2 - 16*z + 4";
  EXPECT_ACCEPTED(with("A^2 - B", "2*z - 1", "4"));
  t.parameters = R"(["A","B","C"])";
  t.num = "4*B*C^2*z^2 - 8*B*C*z + 4*B + 4*A*C^2*z - 4*A*C + 3*C^2";
  t.den = "4*C^2*z^2 - 8*C*z + 4";
  const std::string shifted = with("A^2 - B", "C*z - 1", "4");
  EXPECT_REFUSED(shifted, "leading coefficient of a place");
  t.assumptions = R"([{"p":"C","sign":"nonzero"}])";
  EXPECT_ACCEPTED(t());
  EXPECT_REFUSED(with("A^2 + B", "C*z - 1", "4"), "the logarithm is not proved");
  // Delta = 1/2 has none
  StrataText half{.num = "-3 + 16*z", .den = "16*z^2"};
  half.tree = places("torus-log", "16", place("z", "2", R"("chi":["-1","4"],"log":true)"));
  EXPECT_REFUSED(half(), "none can be tested");
}

// A + 5/(16 z^2): Delta = 3/2, D_4 = 1; the matrix of p = x_0 + x_1 z has rank 2 where A is not 0.
TEST(StrataAbsent, Minors) {
  StrataText t{.num = "16*A*z^2 + 5", .den = "16*z^2"};
  const std::string minor = R"({"m":"4","minors":[{"rows":["2","1"],"times":"1"}]})";
  const auto with = [&](const std::string& absent) {
    t.tree = split("A",
                   places("torus", "16", place("z", "2", R"("chi":["-9","4"])"), "",
                          R"(,"absent":[)" + absent + "]"),
                   open_zero);
    return t();
  };
  EXPECT_ACCEPTED(with(minor));
  EXPECT_ACCEPTED(with(replaced(minor, R"("2","1")", R"("4","3")")));
  EXPECT_ACCEPTED(with(replaced(minor, R"("times":"1")", R"("times":"-7*A")")));
  EXPECT_REFUSED(with(replaced(minor, R"("times":"1")", R"("times":"0")")), "full rank");
  EXPECT_REFUSED(with(replaced(minor, R"("times":"1")", R"("times":"A + 1")")), "full rank");
  EXPECT_REFUSED(with(replaced(minor, R"("2","1")", R"("1","3")")), "full rank");
  EXPECT_REFUSED(with(replaced(minor, R"("2","1")", R"("2","77")")), "full rank");
  EXPECT_REFUSED(with(replaced(minor, R"("2","1")", R"("2","2")")), "different rows");
  EXPECT_REFUSED(with(replaced(minor, R"("2","1")", R"("2")")), "different rows");
  EXPECT_REFUSED(with(replaced(minor, R"("2","1")", R"("2","-1")")), "malformed");
  EXPECT_REFUSED(with(replaced(minor, R"("m":"4")", R"("m":"6")")), "degree 4");
  EXPECT_REFUSED(with(""), "degree 4");
  t.tree = places("torus", "16", place("z", "2", R"("chi":["-9","4"])"), "",
                  R"(,"absent":[)" + minor + "]");
  EXPECT_REFUSED(t(), "may drop");
}

// 1 + A/z + 5/(16 z^2): the minors of the rows 2, 1 and 3, 4 are 4A^2 + 1 and 16A^2 - 5 up to
// constants, and 4 (4A^2 + 1) - (16A^2 - 5) = 9.
TEST(StrataAbsent, MinorsWithoutCommonRoot) {
  StrataText t{.num = "16*z^2 + 16*A*z + 5", .den = "16*z^2", .claim = "false"};
  const auto with = [&](const std::string& minors) {
    t.tree = places("torus", "16", place("z", "2", R"("chi":["-9","4"])"), "",
                    R"(,"absent":[{"m":"4",)" + minors + "}]");
    return t();
  };
  const std::string bezout =
      R"("minors":[{"rows":["2","1"],"times":"512"},{"rows":["3","4"],"times":"-175"}])";
  EXPECT_ACCEPTED(with(bezout));
  EXPECT_REFUSED(with(replaced(bezout, "512", "511")), "full rank");
  EXPECT_REFUSED(with(replaced(bezout, R"("3","4")", R"("4","3")")), "full rank"); // the sign
  const std::string prime =
      R"("prime":"10007","minors":[{"rows":["2","1"],"times":"1"},{"rows":["3","4"],"times":"1"}])";
  EXPECT_ACCEPTED(with(prime));
  const std::string zero = R"({"rows":["2","77"],"times":"1"})"; // a minor that is 0
  EXPECT_ACCEPTED(with(replaced(prime, R"("minors":[)", R"("minors":[)" + zero + ",")));
  EXPECT_REFUSED(with(R"("prime":"10007","minors":[)" + zero + "," + zero + "]"), "common factor");
  EXPECT_REFUSED(with(replaced(prime, "10007", "3")), "common factor"); // 4A^2 + 1 = 16A^2 - 5
  EXPECT_REFUSED(with(replaced(prime, "10007", "2")), "degree");
  EXPECT_REFUSED(with(replaced(prime, "10007", "10005")), "the prime");
  EXPECT_REFUSED(with(replaced(prime, "10007", "2147483659")), "the prime");
  EXPECT_REFUSED(with(replaced(prime, R"("times":"1")", R"("times":"2")")), "all times are 1");
  EXPECT_REFUSED(with(replaced(prime, R"(["3","4"])", R"(["2","1"])")), "common factor");
  EXPECT_REFUSED(with(replaced(prime, R"({"rows":["2","1"],"times":"1"},)", "")), "two minors");
}

} // namespace
} // namespace kov::certify::strata_leaves_test
