// The tree of a certificate over strata: reader, state, nodes, lemmas, leaves without places
// (docs/theory/strata_certificates.md 2-6).

#include "certify/strata_text.hpp"

namespace kov::certify::strata_tree_test {
namespace {

TEST(StrataReader, Polynomials) {
  const Ring ring = make_ring({"z", "A", "b_1"});
  for (const char* same : {"0", "A", "-A", "-z + 12*A^3*b_1 + 1", "-3*z^2*A + 7"})
    EXPECT_EQ(to_string(read_polynomial(ring, same)), same);
  EXPECT_EQ(to_string(read_polynomial(ring, "-0 + 0*A - z")), "-z");
  EXPECT_EQ(to_string(read_polynomial(ring, "A*A + A^2 - 2*A^0*A^2 + z^1")), "z");
  for (const char* bad :
       {"",   " ",  "+A",   "--A",  "A+1",     "A  + 1",   "A + ", "1.5",     "01",
        "00", "A^", "A^-1", "A^01", "A^10000", "A^9999*A", "A*2",  "2A",      "*A",
        "A*", "B",  "A/2",  "(A)",  "1e3",     "A - -1",   "A\n",  "\xce\xb1"})
    EXPECT_THROW(read_polynomial(ring, bad), InvalidArgument) << bad;
}

TEST(StrataReader, IsStrict) {
  const std::string good = StrataText{.num = "z + A", .tree = airy_leaf}();
  EXPECT_ACCEPTED(good);
  const std::pair<const char*, const char*> changes[] = {
      {R"("variable":"z")", R"("variable":"A")"},
      {R"(["A"])", R"(["A","A"])"},
      {R"(["A"])", R"(["A","1b"])"},
      {R"("real":[])", R"("real":["z"])"},
      {R"("real":[])", R"("real":["A","A"])"},
      {R"("generic":[])", R"("generic":[[]])"},
      {R"("generic":[],)", ""},
      {R"("claim":{"abelian":null})", R"("claim":{"abelian":"no"})"},
      {R"("claim":{"abelian":null})", R"("claim":{})"},
      {R"("node":"leaf")", R"("node":"leaf","more":"x")"},
      {R"("node":"leaf")", R"("node":"twig")"},
      {R"("abelian":"no")", R"("abelian":"perhaps")"},
      {R"("abelian":"no")", R"("abelian":"yes")"},
      {R"("infinity":{})", R"("infinity":{"q":"z"})"},
      {R"("assumptions":[])", R"("assumptions":[{"p":"A","sign":"dropped"}])"},
      {"kovacic-strata/1", "kovacic-strata/2"},
  };
  for (const auto& [part, by] : changes)
    EXPECT_REFUSED(replaced(good, part, by), "malformed");
  EXPECT_EQ(format_of(good), "kovacic-strata/1");
  EXPECT_EQ(format_of("[]"), std::nullopt);
}

TEST(StrataClaim, FollowsFromTheLeaves) {
  StrataText t{.num = "z + A", .tree = airy_leaf};
  for (const char* claim : {"null", "false"}) {
    t.claim = claim;
    EXPECT_ACCEPTED(t());
  }
  t.claim = "true";
  EXPECT_REFUSED(t(), "not every stratum is proved abelian");
  t.claim = "false";
  t.tree = split("A", airy_leaf, open_zero);
  EXPECT_REFUSED(t(), "not every stratum is proved not abelian");
  t.claim = "null";
  const auto yes = accepted(t());
  EXPECT_EQ(yes.not_abelian, 1U);
  EXPECT_EQ(yes.open, 1U);
  EXPECT_EQ(yes.claim, std::nullopt);
}

TEST(StrataTrusted, IsCounted) {
  StrataText t{.num = "z + A", .claim = "false"};
  const std::string trusted =
      R"({"zero":"trusted","abelian":"no","theorem":"Bessel","statement":"as in the book"})";
  t.tree = split("A", airy_leaf, trusted);
  EXPECT_EQ(accepted(t()).trusted, 1U);
  EXPECT_EQ(accepted(t()).not_abelian, 2U);
  EXPECT_REFUSED(replaced(t(), R"("abelian":"no","theorem")", R"("abelian":"yes","theorem")"),
                 "claim");
  EXPECT_EQ(accepted(replaced(t(), R"("abelian":"no","theorem")", R"("abelian":"empty","theorem")"))
                .empty,
            1U);
}

// y'' = (z + A) y at A = 0.
TEST(StrataSolve, ReplacesTheEquation) {
  StrataText t{.num = "z + A", .claim = "false"};
  t.tree = split("A", airy_leaf, solve("A", "z", "1", number("no", airy())));
  EXPECT_EQ(accepted(t()).not_abelian, 2U);
  const auto zero = [&](const std::string& z) {
    StrataText x = t;
    x.tree = split("A", airy_leaf, z);
    return x();
  };
  EXPECT_REFUSED(zero(solve("A", "z + 1", "1", number("no", airy()))), "not the same function");
  EXPECT_REFUSED(zero(solve("A", "", "", number("no", airy()))), "r is missing");
  EXPECT_REFUSED(zero(solve("A", "0", "0", number("no", airy()))), "den is 0");
  EXPECT_REFUSED(zero(solve("A", "z", "1", number("no", airy(R"(["1","1"])")))),
                 "another equation");
  EXPECT_REFUSED(zero(solve("A", "z", "1", number("yes", airy()))), "does not claim that");
  EXPECT_REFUSED(zero(solve("A", "z", "1", number("no", replaced(airy(), "parity", "degree")))),
                 "the nested certificate is refused");
  EXPECT_REFUSED(zero(solve("A", "z", "1", split("A", open_node, open_zero))), "solved for");
  EXPECT_REFUSED(zero(solve("A", "z", "1", split("2", open_node, open_zero))), "constant");
  EXPECT_REFUSED(zero(solve("A", "z", "1", split("z", open_node, open_zero))), "in the parameters");
  EXPECT_REFUSED(zero(number("no", airy())), "malformed");
}

// At A = 1 the equation is y'' = y, abelian: a common factor A - 1 must not hide the stratum.
TEST(StrataSolve, KeepsDenominators) {
  StrataText t{.parameters = R"(["A","B"])", .num = "A*z + A - z", .den = "A", .claim = "false"};
  const std::string false_outside = split("A - 1", open_node, R"({"zero":"outside"})");
  t.tree = split(
      "A",
      split("B", open_node, solve("B", "A^2*z + A^2 - 2*A*z - A + z", "A^2 - A", false_outside)),
      R"({"zero":"outside"})");
  t.claim = "null";
  EXPECT_REFUSED(t(), "not a divisor");
  t.tree = split("A", split("B", open_node, solve("B", "A*z + A - z", "A", false_outside)),
                 R"({"zero":"outside"})");
  EXPECT_REFUSED(t(), "den is not 0");
  t.tree = split("A", open_node, solve("A", "", "", R"({"node":"outside"})"));
  EXPECT_EQ(accepted(t()).outside, 1U);
  EXPECT_REFUSED(replaced(t(), R"({"node":"outside"})", airy_leaf), "den became 0");
  EXPECT_REFUSED(replaced(t(), R"({"zero":"solve","variable":"A",)",
                          R"({"zero":"solve","variable":"A","r":{"num":"z","den":"1"},)"),
                 "no r is expected");
}

// A B = 1 with A > 0: B > 0 and A > 0 stay, x = -m/l with l = B.
TEST(StrataSolve, ReplacesConditions) {
  StrataText t{.parameters = R"(["A","B"])", .num = "z"};
  t.real = R"(["A","B"])";
  t.assumptions = R"([{"p":"A","sign":"positive"},{"p":"A + 1","sign":"nonnegative"}])";
  // A* = B, times B for the even power: B is not 0 and B > 0 again from B^2 A = B
  const std::string lemma = R"({"p":"B","sign":"positive","terms":[["1",["condition","0","1"]]]})";
  const std::string positive = split(
      "B", split("A*B - 1", open_node, solve("A", "z", "1", lemmas(lemma, open_node))), open_zero);
  t.tree = positive;
  EXPECT_ACCEPTED(t());
  t.tree = replaced(positive, R"({"p":"B",)", R"({"p":"-B",)");
  EXPECT_REFUSED(t(), "not the sum");
  t.tree = replaced(positive, R"(["condition","0","1"])", R"(["condition","2","1"])");
  EXPECT_REFUSED(t(), "no such condition");
  t.tree = replaced(positive, R"(["condition","0","1"])", R"(["condition","1","1"])");
  EXPECT_REFUSED(t(), "known to be positive");
  // l may be 0
  t.tree = split("A*B - 1", open_node, solve("A", "z", "1", open_node));
  EXPECT_REFUSED(t(), "not known to be nonzero");
  t.tree = split("A^2 - 1", open_node, solve("A", "z", "1", open_node));
  EXPECT_REFUSED(t(), "not linear");
  // B is not real: no sign survives, but A is not 0
  t.real = R"(["A"])";
  t.tree = positive;
  EXPECT_REFUSED(t(), "the condition has no sign");
  t.tree =
      split("B",
            split("A*B - 1", open_node,
                  solve("A", "z", "1", split("B + 1", open_node, solve("B", "z", "1", open_node)))),
            open_zero);
  EXPECT_ACCEPTED(t());
}

TEST(StrataSolve, LearnsWhatIsReal) {
  StrataText t{.parameters = R"(["A","B"])", .num = "z"};
  t.real = R"(["A"])";
  const std::string square =
      R"({"p":"B^2 + 1","sign":"positive","terms":[["1",["square","B","1"]],["1"]]})";
  const auto with = [&](const std::string& l, const std::string& p) {
    t.tree =
        split(l, split(p, open_node, solve("A", "z", "1", lemmas(square, open_node))), open_zero);
    return t();
  };
  EXPECT_ACCEPTED(with("B - 2", "A*B - 2*A - 3*B + 1"));
  EXPECT_REFUSED(with("B - 2", "A*B - 2*A - 3*B + 6"), "not real"); // (A - 3)(B - 2)
  EXPECT_REFUSED(with("B - 2", "A*B - 2*A - B^2 + 1"), "not real");
  t.real = "[]";
  EXPECT_REFUSED(with("B - 2", "A*B - 2*A - 3*B + 1"), "not real");
}

TEST(StrataAssumed, NeedsAnEquation) {
  StrataText t{.parameters = R"(["A","B"])", .num = "z + A"};
  t.assumptions =
      R"([{"p":"2*A^2*B","sign":"zero"},{"p":"B","sign":"nonzero"},{"p":"A","sign":"nonnegative"},{"p":"0","sign":"zero"}])";
  const std::string then = solve("A", "z", "1", number("no", airy()));
  t.claim = "false";
  t.tree = assumed("0", "A", then);
  EXPECT_ACCEPTED(t());
  t.tree = assumed("0", "-3*A", then);
  EXPECT_ACCEPTED(t());
  for (const char* i : {"1", "2", "3", "4", "99999999999999999999"}) {
    t.tree = assumed(i, "A", then);
    EXPECT_REFUSED(t(), i[0] < '4' ? "not an equation" : "no such condition");
  }
  t.tree = assumed("0", "A + 1", then);
  EXPECT_REFUSED(t(), "does not imply");
  t.tree = assumed("0", "B", then);
  EXPECT_REFUSED(t(), "does not imply");
  t.assumptions = R"([{"p":"A*B","sign":"zero"}])";
  t.tree = assumed("0", "A", then);
  EXPECT_REFUSED(t(), "does not imply");
  t.tree = assumed("0", "1", then);
  EXPECT_REFUSED(t(), "constant");
}

TEST(StrataOutside, Generic) {
  StrataText t{.parameters = R"(["A","B"])", .num = "z + A"};
  t.generic = R"([["A*B","A^2"],["A","B"]])";
  t.tree = split("A", airy_leaf, R"({"zero":"outside","generic":"0"})");
  t.claim = "false";
  EXPECT_EQ(accepted(t()).outside, 1U);
  EXPECT_REFUSED(replaced(t(), R"("generic":"0")", R"("generic":"1")"), "may be nonzero");
  EXPECT_REFUSED(replaced(t(), R"("generic":"0")", R"("generic":"2")"), "no such group");
  EXPECT_REFUSED(replaced(t(), R"(,"generic":"0")", ""), "den is not 0");
  t.tree = split("A", airy_leaf, solve("A", "z", "1", R"({"node":"outside","generic":"0"})"));
  EXPECT_EQ(accepted(t()).outside, 1U);
  t.tree = split("B", airy_leaf, solve("B", "z + A", "1", R"({"node":"outside","generic":"0"})"));
  EXPECT_REFUSED(t(), "may be nonzero");
}

TEST(StrataEmpty, NeedsAContradiction) {
  StrataText t{.num = "z + A"};
  t.claim = "false";
  t.real = R"(["A"])";
  t.assumptions = R"([{"p":"A","sign":"positive"}])";
  t.tree = split("3*A^2", airy_leaf, empty_zero);
  EXPECT_EQ(accepted(t()).empty, 1U);
  t.tree = split("A + 1", airy_leaf, empty_zero);
  EXPECT_REFUSED(t(), "not known to be empty");
  // A + 1 = 0 but A > 0
  const std::string terms = R"("terms":[["1",["condition","0","1"]],["1"]])";
  t.tree = split("A + 1", airy_leaf, R"({"zero":"empty",)" + terms + "}");
  EXPECT_ACCEPTED(t());
  t.tree = split("A + 2", airy_leaf, R"({"zero":"empty",)" + terms + "}");
  EXPECT_REFUSED(t(), "is not 0");
  t.tree = split("A + 1", airy_leaf, solve("A", "z - 1", "1", R"({"node":"empty",)" + terms + "}"));
  EXPECT_ACCEPTED(t());
  EXPECT_REFUSED(replaced(t(), R"([["1",[)", R"([["2",[)"), "is not 0");
  EXPECT_REFUSED(replaced(t(), R"([["1",[)", R"([["-1",[)"), "malformed");
  t.tree = R"({"node":"empty"})";
  EXPECT_REFUSED(t(), "not known to be empty");
  t.tree = R"({"node":"empty","terms":[]})";
  EXPECT_REFUSED(t(), "no term");
  // nonzero and positive conditions that became 0, equations that became constants
  for (const char* sign : {"positive", "nonzero"}) {
    t.assumptions = std::string(R"([{"p":"A","sign":")") + sign + "\"}]";
    t.tree = split("A", airy_leaf, solve("A", "z", "1", R"({"node":"empty"})"));
    EXPECT_ACCEPTED(t());
  }
  t.assumptions = R"([{"p":"A - 1","sign":"zero"}])";
  EXPECT_ACCEPTED(t());
  t.assumptions = R"([{"p":"A","sign":"nonnegative"}])";
  EXPECT_REFUSED(t(), "not known to be empty");
}

TEST(StrataLemmas, SumsOfPositiveTerms) {
  StrataText t{.parameters = R"(["A","B"])", .num = "z + A"};
  t.real = R"(["A"])";
  t.assumptions = R"([{"p":"A","sign":"positive"},{"p":"B","sign":"nonnegative"}])";
  const auto with = [&](const std::string& lemma, const std::string& zero) {
    t.tree = lemmas(lemma, split(zero, open_node, empty_zero));
    return t();
  };
  // A^2 - A + 1 = (A - 1/2)^2 + 3/4
  const std::string good =
      R"({"p":"A^2 - A + 1","sign":"positive","terms":[["1/4",["square","2*A - 1","1"]],["3/4"]]})";
  EXPECT_ACCEPTED(with(good, "A^2 - A + 1"));
  EXPECT_REFUSED(with(good, "A^2 - A + 2"), "not known to be empty");
  EXPECT_REFUSED(with(replaced(good, "3/4", "1/2"), "A^2 - A + 1"), "not the sum");
  EXPECT_REFUSED(with(replaced(good, R"("3/4")", R"("-3/4")"), "A^2 - A + 1"), "malformed");
  EXPECT_REFUSED(with(replaced(good, R"("1"]],)", R"("0"]],)"), "A^2 - A + 1"), "malformed");
  // no positive term; A*B is not real; a condition without a sign
  EXPECT_REFUSED(
      with(R"({"p":"A^2 - 2*A + 1","sign":"nonzero","terms":[["1",["square","A - 1","1"]]]})",
           "A - 1"),
      "no term is known to be positive");
  EXPECT_REFUSED(
      with(R"({"p":"A^2*B^2 + 1","sign":"nonzero","terms":[["1",["square","A*B","1"]],["1"]]})",
           "A^2*B^2 + 1"),
      "not real");
  // B is, by its sign; and a product of what is not 0 is not 0
  EXPECT_ACCEPTED(with(
      R"({"p":"B^2 + 1","sign":"nonzero","terms":[["1",["square","B","1"]],["1"]]})", "B^2 + 1"));
  EXPECT_ACCEPTED(with(
      R"({"p":"A*B + 2*A","sign":"nonzero","terms":[["1",["condition","0","1"],["condition","1","1"]],["2",["condition","0","1"]]]})",
      "A*B + 2*A"));
  EXPECT_REFUSED(
      with(
          R"({"p":"A*B","sign":"nonzero","terms":[["1",["condition","0","1"],["condition","1","1"]]]})",
          "B"),
      "no term is known to be positive");
  // a later lemma uses an earlier one; times
  const std::string second =
      R"({"p":"A^2 - A + 2","sign":"positive","terms":[["1",["condition","2","1"]],["1"]]})";
  EXPECT_ACCEPTED(with(good + "," + second, "A^2 - A + 2"));
  EXPECT_REFUSED(with(second, "A^2 - A + 2"), "no such condition");
  const std::string cube =
      R"({"p":"A^2 - A + 1","times":"A + 1","sign":"nonzero","terms":[["1",["condition","0","3"]],["1"]]})";
  EXPECT_ACCEPTED(with(cube, "A^2 - A + 1"));
  EXPECT_REFUSED(with(replaced(cube, "nonzero", "positive"), "A^2 - A + 1"), "times is not known");
  // without terms
  const std::string factor = R"({"p":"B","times":"A*B","sign":"nonzero"})";
  t.assumptions = R"([{"p":"A*B^2","sign":"nonzero"}])";
  EXPECT_ACCEPTED(with(factor, "B"));
  EXPECT_REFUSED(with(replaced(factor, "A*B", "A"), "B"), "not known to be nonzero");
  EXPECT_REFUSED(with(replaced(factor, "nonzero", "positive"), "B"), "malformed");
}

// y'' = (z + A) y over Q(A), A^2 = 2, and 2 A^2 = 1: A = a/2.
TEST(StrataRoot, OneRootForAll) {
  StrataText t{.num = "z + A", .claim = "false"};
  const auto root = [&](const std::string& p, const std::string& c,
                        const std::string& abelian = "no") {
    t.tree = split(p, airy_leaf,
                   R"({"zero":"root","variable":"A","abelian":")" + abelian +
                       R"(","certificate":)" + c + "}");
    return t();
  };
  const std::string at_a = airy(R"([["0","1"],"1"])", true);
  const std::string at_half = airy(R"([["0","1/2"],"1"])", true);
  EXPECT_ACCEPTED(root("A^2 - 2", at_a));
  EXPECT_ACCEPTED(root("2*A^2 - 1", at_half));
  EXPECT_REFUSED(root("2*A^2 - 1", at_a), "another equation");
  EXPECT_REFUSED(root("A^2 - 3", at_a), "minimal polynomial");
  EXPECT_REFUSED(root("A^2 - 2*A", at_a), "minimal polynomial");
  EXPECT_REFUSED(root("A - 2", airy(R"(["2","1"])")), "degree 2");
  EXPECT_REFUSED(root("A^2 - 2", airy()), "minimal polynomial");
  EXPECT_REFUSED(root("A^2 - 2", at_a, "yes"), "does not claim that");
  t.parameters = R"(["A","B"])";
  EXPECT_REFUSED(root("A^2 - B", at_a), "another variable");
  t.num = "z + A + B";
  EXPECT_REFUSED(root("A^2 - 2", at_a), "has a parameter");
}

TEST(StrataNumber, HasNoParameter) {
  StrataText t{.num = "1", .claim = "true", .tree = number("yes", exponential)};
  EXPECT_EQ(accepted(t()).abelian, 1U);
  t.num = "2";
  t.den = "2";
  EXPECT_ACCEPTED(t());
  t.num = "A";
  EXPECT_REFUSED(t(), "has a parameter");
  t.num = "1";
  t.tree = number("yes", replaced(exponential, R"("m":"2","p":["1"])", R"("m":"2","p":["0","1"])"));
  EXPECT_REFUSED(t(), "refused");
}

// y'' = A/z^2 y: y1 y2 = z for all A.
TEST(StrataInvariant, AtEveryPoint) {
  StrataText t{.num = "A", .den = "z^2", .claim = "true"};
  t.tree = leaf("yes", "invariant",
                R"("content":"1","places":[{"q":"z","order":"2","e":"1"}],"m":"2","p":"1")");
  EXPECT_ACCEPTED(t());
  EXPECT_ACCEPTED(replaced(replaced(t(), R"("e":"1")", R"("e":"0")"), R"("p":"1")", R"("p":"z")"));
  EXPECT_ACCEPTED(replaced(replaced(t(), R"("e":"1")", R"("e":"2")"), R"("m":"2")", R"("m":"4")"));
  EXPECT_REFUSED(replaced(t(), R"("e":"1")", R"("e":"2")"), "does not vanish");
  EXPECT_REFUSED(replaced(t(), R"("m":"2")", R"("m":"4")"), "does not vanish");
  EXPECT_REFUSED(replaced(t(), R"("m":"2")", R"("m":"0")"), "1 to 200");
  EXPECT_REFUSED(replaced(t(), R"("m":"2")", R"("m":"201")"), "1 to 200");
  EXPECT_REFUSED(replaced(t(), R"("p":"1")", R"("p":"0")"), "may vanish");
  EXPECT_REFUSED(replaced(t(), R"("p":"1")", R"("p":"A")"), "may vanish");
  EXPECT_REFUSED(replaced(t(), R"("order":"2")", R"("order":"1")"), "not the product");
  EXPECT_REFUSED(replaced(t(), R"("order":"2")", R"("order":"0")"), "impossible");
  EXPECT_REFUSED(replaced(t(), R"("abelian":"yes")", R"("abelian":"no")"), "malformed");
  t.den = "A*z^2";
  t.num = "1";
  EXPECT_REFUSED(replaced(t(), R"("content":"1")", R"("content":"A")"), "content is not known");
  t.assumptions = R"([{"p":"A","sign":"nonzero"}])";
  EXPECT_ACCEPTED(replaced(t(), R"("content":"1")", R"("content":"A")"));
}

} // namespace
} // namespace kov::certify::strata_tree_test
