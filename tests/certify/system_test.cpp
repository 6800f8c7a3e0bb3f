// The rules of docs/theory/system_certificates.md, each with something true and something false that
// looks like it.

#include "certify/system_text.hpp"

namespace kov::certify::system_test {
namespace {

TEST(SystemCertificate, TheExampleIsAcceptedAndSaysWhatItProves) {
  const SystemText t;
  ASSERT_EQ(refused_by(t()), "");
  const auto lines = stated(t());
  EXPECT_EQ(lines[0], "the system \"a system\"");
  EXPECT_EQ(lines[1], "  {q1, p1} = 1, {q2, p2} = 1, H = (-q1^2*q2^2 + p1^2 + 2*p2)/2");
  EXPECT_EQ(lines[2],
            "along the phase curve with z = q2^2 on \"N\": q1 = 0, p1 = 0; levels p2 = 0");
  EXPECT_EQ(lines[3], "  w^2 = z");
  EXPECT_EQ(
      lines[4],
      "is not integrable in Liouville's sense with first integrals that are meromorphic also at "
      "the ends of the phase curve (points at infinity, equilibria, poles of the system) "
      "(Morales-Ramis), as");
  EXPECT_EQ(lines[5], "  y'' = ((1/4*z^2 - 3/16)/z^2) y");
}

TEST(SystemCertificate, WhatIsWrittenIsRead) {
  const SystemText t;
  EXPECT_EQ(refused_by(write_system_certificate(read_system_certificate(t()))), "");
}

// S1, S3, C4: symbols.

TEST(SystemCertificate, AnInverseHasTheValueOfAnInverse) {
  SystemText t;
  t.inverses = R"({"name":"u","of":"q2"})";
  EXPECT_EQ(refused_by(t()), "C4"); // the system is not defined where it has no value
  t.values += R"(,"u":["w","1","1"])";
  EXPECT_EQ(refused_by(t()), "");
  EXPECT_EQ(refused_by(replaced(t(), R"("u":["w","1","1"])", R"("u":["1","1","1"])")), "C4");
  EXPECT_EQ(refused_by(replaced(t(), R"("of":"q2")", R"("of":"2")")), "S1");
}

TEST(SystemCertificate, AFunctionMovesAsItsGradientSays) {
  SystemText t;
  t.functions = R"({"name":"s","meaning":"q2^2","gradient":{"q2":"2*q2"}})";
  t.values += R"(,"s":"z")";
  EXPECT_EQ(refused_by(t()), "");
  EXPECT_EQ(refused_by(replaced(t(), R"("2*q2")", R"("3*q2")")), "C4");
  EXPECT_EQ(refused_by(replaced(t(), R"("q2":"2*q2")", R"("p2":"2*q2")")), "S1");
  t.relations = R"("s - q2^2")";
  EXPECT_EQ(refused_by(t()), "");
  t.relations = R"("s - q2^2 - 1")";
  EXPECT_EQ(refused_by(t()), "C4");
  t.relations = R"("s - q2")";
  EXPECT_EQ(refused_by(t()), "S1");
}

TEST(SystemCertificate, FunctionsWithTheseGradientsExist) {
  SystemText t;
  t.functions = R"({"name":"f","meaning":"q1 q2","gradient":{"q1":"q2","q2":"q1"}})";
  EXPECT_EQ(refused_by(t()), "");
  EXPECT_EQ(refused_by(replaced(t(), R"("q2":"q1")", R"("q2":"2*q1")")), "S1");
  t.functions = R"({"name":"f","meaning":"a constant","gradient":{}})";
  EXPECT_EQ(refused_by(t()), "S1");
  t.relations = R"("f^2 - 2")";
  EXPECT_EQ(refused_by(t()), "C4"); // it has no value
}

TEST(SystemCertificate, WhatMovesAndIsLeftOutIsSaid) {
  SystemText t;
  t.functions = R"({"name":"e","meaning":"exp q2","gradient":{"q2":"e"}})";
  const std::string sentence = stated(t())[5];
  EXPECT_NE(sentence.find("and do not depend on e (Morales-Ramis)"), std::string::npos) << sentence;
  t.functions = R"({"name":"e","meaning":"of q1","gradient":{"q1":"1"}})"; // q1' = 0 on the curve
  EXPECT_EQ(stated(t())[5].find("do not depend"), std::string::npos);
}

// S2, S4: the field.

TEST(SystemCertificate, TheBracketIsOneOfPoisson) {
  const SystemText t;
  const std::string one = R"(["q1","p1","1"])";
  EXPECT_EQ(refused_by(replaced(t(), one, R"(["p1","q1","-1"])")), "");
  EXPECT_EQ(refused_by(replaced(t(), one, R"(["q1","p1","q2"])")), "S2"); // Jacobi
  EXPECT_EQ(refused_by(replaced(t(), one, R"(["q1","p1","2"])")), "N2");  // another field
  EXPECT_EQ(refused_by(replaced(t(), one, one + "," + R"(["p1","q1","-1"])")), "malformed");
}

TEST(SystemCertificate, TheFieldAloneWillDo) {
  SystemText t;
  t.dynamics = R"("field":["p1","1","q2^2*q1",["2*q2*q1^2","2"]])";
  EXPECT_EQ(refused_by(t()), "N3"); // without a bracket the vectors are meant themselves
  t.vectors = R"([["1","0","0","0"],["0","0","2*w","0"]])";
  EXPECT_EQ(refused_by(t()), "");
  EXPECT_NE(stated(t())[4].find("(Ayoul-Zung)"), std::string::npos);
  t.dynamics = R"("field":["p1","1","q2*q1","0"])";
  EXPECT_EQ(refused_by(t()), "N2");
  t.dynamics = R"("field":["p1","2","q2^2*q1","0"])";
  EXPECT_EQ(refused_by(t()), "C4");
}

TEST(SystemCertificate, ClaimsAreIdentitiesOnAllOfPhaseSpace) {
  SystemText t;
  const auto claim = [&](const std::string& kind, const std::string& value) {
    t.claims = R"({"kind":")" + kind + R"(","name":"F","value":)" + value + "}";
    return refused_by(t());
  };
  EXPECT_EQ(claim("integral", R"("2*p2 + p1^2 - q2^2*q1^2")"), "");
  EXPECT_EQ(claim("integral", R"("p2")"), "S4"); // constant on the curve only
  EXPECT_EQ(claim("casimir", R"("2*p2 + p1^2 - q2^2*q1^2")"), "S4");
  EXPECT_EQ(claim("casimir", R"("7")"), "");
  t.inverses = R"({"name":"u","of":"q2"})";
  t.values += R"(,"u":["w","1","1"])";
  EXPECT_EQ(claim("integral", R"("u*q2")"), "");
  EXPECT_EQ(claim("integral", R"("u*q2^2")"), "S4");
}

TEST(SystemCertificate, CofactorsBelongToTheRelations) {
  SystemText t; // c' = -s, s' = c
  t.functions = R"({"name":"c","meaning":"cos","gradient":{"q2":"-s"}},)"
                R"({"name":"s","meaning":"sin","gradient":{"q2":"c"}})";
  t.claims = R"({"kind":"integral","name":"F","value":"c^4 + 2*c^2*s^2 + s^4"})";
  EXPECT_EQ(refused_by(t()), ""); // X(F) = 0 without a relation
  t.claims = R"({"kind":"casimir","name":"F","value":"0","cofactors":[["0"]]})";
  EXPECT_EQ(refused_by(t()), "S4");
  t.claims =
      R"({"kind":"integral","name":"F","value":"c^2*s^2 + s^4 - s^2","cofactors":[["2*c*s"]]})";
  EXPECT_EQ(refused_by(t()), "S4"); // no relation
  t.relations = R"("c^2 + s^2 - 1")";
  EXPECT_EQ(refused_by(t()), "C4"); // F is 0; the relation has no value
  EXPECT_EQ(refused_by(replaced(t(), R"([["2*c*s"]])", R"([["c*s"]])")), "S4");
}

// C1, C2: the algebra.

TEST(SystemCertificate, TheTowerIsReduced) {
  const SystemText t;
  EXPECT_EQ(refused_by(replaced(t(), R"("value":"z")", R"("value":"w^2")")), "C1");
  EXPECT_EQ(refused_by(replaced(t(), R"("degree":"2")", R"("degree":"1")")), "malformed");
  EXPECT_EQ(refused_by(replaced(t(), R"("denominators":["z"])", R"("denominators":["w"])")), "C1");
  EXPECT_EQ(refused_by(replaced(t(), R"("denominators":["z"])", R"("denominators":["0"])")), "C1");
}

TEST(SystemCertificate, TheDerivationRespectsTheTower) {
  const SystemText t;
  const std::string derivative = R"("derivative":["w","2","1"])";
  EXPECT_EQ(refused_by(replaced(t(), derivative, R"("derivative":["w^3","2","2"])")),
            ""); // the same
  EXPECT_EQ(refused_by(replaced(t(), derivative, R"("derivative":["w","1","1"])")), "C2");
  EXPECT_EQ(refused_by(replaced(t(), derivative, R"("derivative":"0")")), "C2");
}

TEST(SystemCertificate, AnAlgebraWithZeroDivisorsIsNoHarm) {
  SystemText t; // i^2 = 1: two components, on both of which everything holds
  t.tower = R"([{"name":"w","degree":"2","value":"z","derivative":["w","2","1"]},)"
            R"({"name":"i","degree":"2","value":"1","derivative":"0"}])";
  EXPECT_EQ(refused_by(t()), "");
  t.vectors = R"([["0","0","i","0"],["-2*w","0","0","0"]])"; // right on one of them
  EXPECT_EQ(refused_by(t()), "N3");
  t.vectors = R"([["0","0","i^2","0"],["-2*w*i^4","0","0","0"]])";
  EXPECT_EQ(refused_by(t()), "");
}

// C4, C5, C6: the curve.

TEST(SystemCertificate, TheCurveIsASolution) {
  const SystemText t;
  EXPECT_EQ(refused_by(replaced(t(), R"("q2":"w")", R"("q2":"w + 1")")), "C5"); // later
  EXPECT_EQ(refused_by(replaced(t(), R"("p2":"0")", R"("p2":"z")")), "C4");
  EXPECT_EQ(refused_by(replaced(t(), R"("time":["w","2","1"])", R"("time":["w","3","1"])")), "C4");
  SystemText other; // the other branch of the root
  other.values = R"("q1":"0","q2":"-w","p1":"0","p2":"0")";
  other.time = R"(["-w","2","1"])";
  EXPECT_EQ(refused_by(other()), "N3");
  other.vectors = R"([["0","0","1","0"],["2*w","0","0","0"]])";
  EXPECT_EQ(refused_by(other()), "");
}

TEST(SystemCertificate, ANameWithoutAValueIsNotUsed) {
  SystemText t;
  t.values = R"("q1":"0","q2":"w","p1":"0")"; // nothing contains p2
  t.levels = "[]";
  EXPECT_EQ(refused_by(t()), "");
  t.levels = R"(["p2"])";
  EXPECT_EQ(refused_by(t()), "C6");
  t.values = R"("q2":"w","p1":"0","p2":"0")";
  EXPECT_EQ(refused_by(t()), "C4");
}

TEST(SystemCertificate, AnEquilibriumIsNoCurve) {
  SystemText t; // q1 = p1 = q2 = p2 = 0 for H = (p1^2 + ...)/2 solves C4 with any time
  t.dynamics =
      R"("hamiltonian":["p2^2 + p1^2 - q1^2","2"],"brackets":[["q1","p1","1"],["q2","p2","1"]])";
  t.values = R"("q1":"0","q2":"0","p1":"0","p2":"0")";
  EXPECT_EQ(refused_by(t()), "C5");
  t.change = R"("q2")";
  EXPECT_EQ(refused_by(t()), "C5");
}

TEST(SystemCertificate, TheCurveLiesOnWhatIsNamed) {
  SystemText t;
  t.equations = R"(["q1","p1","q1*q2"])";
  EXPECT_EQ(refused_by(t()), "");
  t.equations = R"(["q1","q2"])";
  EXPECT_EQ(refused_by(t()), "C6");
  t.equations = "[]";
  t.levels = R"([["2*p2 - 1","2"]])";
  EXPECT_EQ(refused_by(t()), "C6");
}

// C7: what the functions are along it.

TEST(SystemCertificate, NoFunctionIsAConstantInDisguise) {
  SystemText t;
  t.parameters = R"(["b"])";
  t.functions = R"({"name":"e","meaning":"exp q1","gradient":{"q1":"e"}})";
  t.tower = R"([{"name":"w","degree":"2","value":"z","derivative":["w","2","1"]},)"
            R"({"name":"i","degree":"2","value":"1","derivative":"0"}])";
  const auto with = [&](const std::string& value) {
    SystemText x = t;
    x.values += R"(,"e":")" + value + "\"";
    return refused_by(x());
  };
  EXPECT_EQ(with("1"), "");
  EXPECT_EQ(with("0"), "C7");
  EXPECT_EQ(with("i + 2"), "");   // 3 on one component, 1 on the other
  EXPECT_EQ(with("i + 1"), "C7"); // 2 on one component, 0 on the other
  EXPECT_EQ(with("b"), "C7");     // b = 0
  t.denominators = R"(["z","b"])";
  EXPECT_EQ(with("b"), "");
  t.functions = R"({"name":"e","meaning":"cos q1","gradient":{"q1":"-s"}},)"
                R"({"name":"s","meaning":"sin q1","gradient":{"q1":"e"}})";
  t.values += R"(,"s":"0")";
  EXPECT_EQ(with("1"), ""); // its second derivative
  EXPECT_EQ(with("0"), "C7");
  t.denominators = R"(["z"])";
  t.functions = R"({"name":"s","meaning":"","gradient":{"q1":"1"}},)"
                R"({"name":"e","meaning":"exp b q1","gradient":{"q1":"b*e"}})";
  EXPECT_EQ(with("1"), ""); // where b is not 0
  EXPECT_EQ(with("b - 1"), "C7");
}

TEST(SystemCertificate, ARelationFixesAConstant) {
  SystemText t;
  t.parameters = R"(["b"])";
  t.functions =
      R"({"name":"k","meaning":"","gradient":{}},{"name":"m","meaning":"","gradient":{}})";
  t.values += R"(,"k":"3","m":"0")";
  t.relations = R"("k*m")";
  EXPECT_EQ(refused_by(t()), "C7");
  t.relations = R"("k*m","k - 3")";
  EXPECT_EQ(refused_by(t()), "");
  t.relations = R"("k - m - 3","k*m")";
  EXPECT_EQ(refused_by(t()), "C7");
  t.relations = R"("b*k - 3*b","m")";
  EXPECT_EQ(refused_by(t()), "C7"); // b = 0
  t.denominators = R"(["z","b"])";
  EXPECT_EQ(refused_by(t()), "");
}

// N1 to N4: the equation.

TEST(SystemCertificate, AnnihilatorsSpanASubsystem) {
  SystemText t;
  t.annihilators = R"({"row":["0","1","0","0"],"matrix":["0"]})"; // d q2: q2' = 1
  t.rest = R"("0")";
  EXPECT_EQ(refused_by(t()), "");
  t.annihilators = R"({"row":["0","z","0","0"],"matrix":[["1","1","1"]]})"; // z d q2
  EXPECT_EQ(refused_by(t()), "");
  t.annihilators = R"({"row":["0","z","0","0"],"matrix":["0"]})";
  EXPECT_EQ(refused_by(t()), "N1");
  t.annihilators = R"({"row":["1","0","0","0"],"matrix":["0"]})";
  EXPECT_EQ(refused_by(t()), "N1");
}

TEST(SystemCertificate, TheRowIsNoAnnihilator) {
  SystemText t; // d q1 and w/(2z) d p1 span a subsystem, on which y = 0
  t.annihilators = R"({"row":["1","0","0","0"],"matrix":["0","1"]},)"
                   R"({"row":["0","0",["w","2","1"],"0"],"matrix":[["1","4"],["-1","2","1"]]})";
  t.rest = R"("0","0")";
  EXPECT_EQ(refused_by(t()), "N3");
  t.q = R"(["-1","1"])"; // any equation would do
  t.rest = R"(["-3","4"],"0")";
  EXPECT_EQ(refused_by(t()), "N3");
}

TEST(SystemCertificate, TheRowSatisfiesItsEquation) {
  SystemText t;
  EXPECT_EQ(refused_by(replaced(t(), R"("p":["1","2","1"])", R"("p":["1","3","1"])")), "N2");
  EXPECT_EQ(refused_by(replaced(t(), R"("q":["-1","4"])", R"("q":["1","4"])")), "N2");
  t.row = R"(["0","0","0","0"])";
  EXPECT_EQ(refused_by(t()), "N3");
  t.row = R"(["2","0","0","0"])";
  EXPECT_EQ(refused_by(t()), "N3");
  t.vectors = R"([["0","0",["1","2"],"0"],["-w","0","0","0"]])";
  EXPECT_EQ(refused_by(t()), "");
  t.row = R"(["1","0","0"])";
  EXPECT_EQ(refused_by(t()), "N2");
}

TEST(SystemCertificate, TheVectorsAreInTheirOrder) {
  SystemText t;
  t.vectors = R"([["-2*w","0","0","0"],["0","0","1","0"]])";
  EXPECT_EQ(refused_by(t()), "N3");
  t.vectors = R"([["0","z","1","0"],["-2*w","w","0","7"]])"; // d q1 does not see q2, p2
  EXPECT_EQ(refused_by(t()), "");
}

TEST(SystemCertificate, TheEquationIsThatOfTheRow) {
  SystemText t;
  t.equation = replaced(t.equation, R"("-3/16")", R"("-3/17")");
  EXPECT_EQ(refused_by(t()), "N4");
  t = {};
  t.equation = replaced(t.equation, R"("sl2-irreducible-infinite")", R"("sl2-irreducible-log")");
  EXPECT_EQ(refused_by(t()), "N4"); // the inner certificate is wrong
  t = {};
  t.equation = R"({"certificate":)" + std::string(weber) + R"(,"root":"0"})";
  EXPECT_EQ(refused_by(t()), "N4");
}

TEST(SystemCertificate, TheEquationSpeaksOfTheSystem) {
  SystemText t; // k^2 = 2 is a parameter of the inner certificate
  t.functions = R"({"name":"k","meaning":"a root","gradient":{}})";
  t.relations = R"("k^2 - 2")";
  t.tower = R"([{"name":"w","degree":"2","value":"z","derivative":["w","2","1"]},)"
            R"({"name":"k","degree":"2","value":"2","derivative":"0"}])";
  t.values += R"(,"k":"k")";
  t.claim = "false";
  StrataText inner;
  inner.parameters = R"(["k"])";
  inner.tree = R"({"node":"open","reason":"x"})";
  const auto with = [&](const std::string& num, const std::string& den,
                        const std::string& generic) {
    inner.num = num, inner.den = den, inner.generic = generic;
    t.equation = R"({"certificate":)" + inner() + "}";
    return refused_by(t());
  };
  EXPECT_EQ(with("4*z^2 - 3", "16*z^2", "[]"), "");
  EXPECT_EQ(with("2*k^2*z^2 - 3", "8*k^2*z^2", R"([["k"]])"), "");
  EXPECT_EQ(with("k^2*z - 2*z", "k^2 - 2", "[]"), "N4"); // 0 = 0
  EXPECT_EQ(with("4*z^2 - 3", "16*z^2", R"([["k^2 - 2"]])"), "N4");
  EXPECT_EQ(with("4*z^2 - 3", "16*z^2", R"([["k^2 - 2","k - 1"]])"), "");
  const auto assuming = [&](const std::string& assumptions, const std::string& real = "[]") {
    inner.assumptions = assumptions, inner.real = real;
    return with("4*z^2 - 3", "16*z^2", "[]");
  };
  EXPECT_EQ(assuming(R"([{"p":"k - 1","sign":"nonzero"},{"p":"k^2 - 2","sign":"zero"}])"), "");
  EXPECT_EQ(assuming(R"([{"p":"k^2 - 2","sign":"nonzero"}])"), "N4");
  EXPECT_EQ(assuming(R"([{"p":"k","sign":"zero"}])"), "N4");
  EXPECT_EQ(assuming(R"([{"p":"k^2","sign":"positive"}])"), "");
  EXPECT_EQ(assuming(R"([{"p":"k^2 - 3","sign":"nonnegative"}])"), "N4");
  EXPECT_EQ(assuming(R"([{"p":"k","sign":"positive"}])"), "N4"); // which root?
  EXPECT_EQ(assuming("[]", R"(["k"])"), "N4");
  t.relations = R"("k^2 - 1")"; // 1 on one component, -1 on the other
  t.tower = replaced(t.tower, R"("value":"2")", R"("value":"1")");
  inner.real = "[]";
  EXPECT_EQ(with("4*z^2 - 3", "16*z^2", R"([["k - 2"]])"), "");
  EXPECT_EQ(with("4*z^2 - 3", "16*z^2", R"([["k - 1"],["k + 1"]])"), "N4");
  EXPECT_EQ(with("4*k*z^2 - 4*z^2 - 3*k + 3", "16*k*z^2 - 16*z^2", "[]"), "N4");
  EXPECT_EQ(assuming(R"([{"p":"k - 1","sign":"nonzero"}])"), "N4");
}

TEST(SystemCertificate, TheClaimFollows) {
  SystemText t;
  t.claim = "false";
  EXPECT_EQ(refused_by(t()), "");
  t = {};
  t.equation = replaced(t.equation, R"("abelian":false)", R"("abelian":null)");
  EXPECT_EQ(refused_by(t()), "N4");
  t.claim = "false";
  EXPECT_EQ(refused_by(t()), "");
  EXPECT_EQ(stated(t())[4], "nothing follows from");
}

TEST(SystemCertificate, WhatIsNoCertificate) {
  const SystemText t;
  EXPECT_EQ(refused_by(replaced(t(), R"("title":)", R"("tittle":)")), "malformed");
  EXPECT_EQ(refused_by(replaced(t(), R"("time":["w","2","1"])", R"("time":["w","0","1"])")),
            "malformed");
  EXPECT_EQ(refused_by(replaced(t(), R"("time":["w","2","1"])", R"("time":["w","2","1","1"])")),
            "malformed");
  EXPECT_EQ(refused_by(replaced(t(), R"("time":["w","2","1"])", R"("time":["w","2","1001"])")),
            "malformed");
  EXPECT_EQ(refused_by(replaced(t(), R"("change":"q2^2")", R"("change":"q2^2 + w")")), "malformed");
  EXPECT_EQ(refused_by(replaced(t(), R"(["q1","q2","p1","p2"])", R"(["q1","q1","p1","p2"])")),
            "malformed");
}

} // namespace
} // namespace kov::certify::system_test
