// Certificates of homoclinic points (docs/theory/chaos.md 6): those of the finder are accepted, and
// whatever is changed in one is refused.

#include "certify/homoclinic/check.hpp"
#include "certify/homoclinic/flow.hpp"
#include "exact/error.hpp"
#include "proof/text/json.hpp"
#include "support/source_dir.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace kov::certify::homoclinic_test {
namespace {

std::string contents(const std::string& name) {
  std::ifstream in(test::in_source("/tests/certify/homoclinic_data/" + name + ".json"));
  std::ostringstream s;
  s << in.rdbuf();
  return s.str();
}

/// The section that refuses a text; empty if it is accepted.
std::string refused_by(const std::string& text) {
  try {
    const auto verdict = check_homoclinic(read_homoclinic_certificate(text));
    const auto* no = std::get_if<Rejected>(&verdict);
    return no ? no->step : "";
  } catch (const InvalidArgument&) {
    return "malformed";
  }
}

using Change = std::pair<std::string, std::string>; ///< a key, and JSON that is put there

Json& entry(Json& j, const std::string& key) {
  auto& all = std::get<Json::Object>(j.value);
  const auto at =
      std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.first == key; });
  if (at != all.end()) return at->second;
  all.emplace_back(key, Json{});
  return all.back().second;
}

std::string changed(const std::string& name, const std::vector<Change>& changes) {
  Json j = parse_json(contents(name));
  for (const auto& [key, value] : changes)
    entry(j, key) = parse_json(value);
  return to_string(j);
}

std::string refused_with(const std::string& key, const std::string& value) {
  return refused_by(changed("henon_heiles_8", {{key, value}}));
}

TEST(HomoclinicCertificate, ThoseOfTheFinderAreAccepted) {
  for (const char* name : {"henon_heiles_6", "henon_heiles_8", "henon_heiles_12"})
    EXPECT_EQ(refused_by(contents(name)), "") << name;
}

TEST(HomoclinicCertificate, WhatIsStated) {
  const HomoclinicCertificate c = read_homoclinic_certificate(contents("henon_heiles_8"));
  const auto found = std::get<HomoclinicAccepted>(check_homoclinic(c));
  EXPECT_EQ(found.trusted, 1U);
  const auto lines = statement(c, found);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_NE(lines[0].find("on the level H = 1/8;"), std::string::npos);
  EXPECT_EQ(lines[2], "has a hyperbolic fixed point at y = -0.185405087091, v = 0 and a transverse "
                      "homoclinic point to it.");
}

// Each entry says something else: about another map, or a guess that is no more near.
TEST(HomoclinicCertificate, EveryEntryCounts) {
  EXPECT_EQ(refused_with("level", R"("1/7")"), "2");
  EXPECT_EQ(refused_with("level", R"("0.12500001")"), "2");
  EXPECT_EQ(refused_with("hamiltonian", // integrable
                         R"(["6*x^2*y + 3*x^2 + 2*y^3 + 3*y^2 + 3*u^2 + 3*v^2", "6"])"),
            "2");
  EXPECT_EQ(
      refused_with("hamiltonian", R"(["6*x^2*y + 3*x^2 - 2*y^3 + 3*y^2 + 3*u^2 + 3*v^2", "7"])"),
      "2");
  EXPECT_EQ(refused_with("variables", R"(["y", "x", "u", "v"])"), "2");
  EXPECT_EQ(refused_with("section", R"(["x + y", "1"])"), "2");
  EXPECT_EQ(refused_with("direction", R"("downward")"), "2");
  EXPECT_EQ(refused_with("where", R"(["-1", "1"])"), "2");
  EXPECT_EQ(refused_with("where", R"(["v", "1"])"), "2"); // 0 at the fixed point
  EXPECT_EQ(refused_with("period", R"("2")"), "3");
  EXPECT_EQ(refused_with("point", R"(["0", "-0.184", "0.45", "0"])"), "2");
  EXPECT_EQ(refused_with("chart", R"(["0", "3"])"), "2");
  EXPECT_EQ(refused_with("axes", R"([["1", "0"], ["0", "1"]])"), "3");
  EXPECT_EQ(refused_with("axes", R"([["1", "1"], ["1", "1"]])"), "3");
  EXPECT_EQ(refused_with("reach", R"("0.01")"), "3");
  EXPECT_EQ(refused_with("reach", R"("1e-9")"), "4");
  EXPECT_EQ(refused_with("xi", R"("0")"), "4");
  EXPECT_EQ(refused_with("xi", R"("1e-6")"), "4");
  EXPECT_EQ(refused_with("eta", R"("0")"), "4");
  EXPECT_EQ(refused_with("eta", R"("-1e-6")"), "4");
}

TEST(HomoclinicCertificate, AMovedOrbitIsRefused) {
  const Json true_one = parse_json(contents("henon_heiles_8"));
  for (const std::size_t k : {0, 7, 15, 22}) {
    Json moved = true_one;
    auto& orbit = std::get<Json::Array>(entry(moved, "orbit").value);
    auto& z = std::get<Json::Array>(orbit.at(k).value);
    z[1] = Json{std::to_string(std::stod(*z[1].text()) + 1e-3)};
    EXPECT_EQ(refused_by(to_string(moved)), "4") << k;
    Json left_out = true_one;
    auto& shorter = std::get<Json::Array>(entry(left_out, "orbit").value);
    shorter.erase(shorter.begin() + static_cast<long>(k));
    EXPECT_EQ(refused_by(to_string(left_out)), "4") << k;
  }
}

TEST(HomoclinicCertificate, TheFixedPointIsNoHomoclinicPointToItself) {
  const Json point =
      entry(*std::make_unique<Json>(parse_json(contents("henon_heiles_8"))), "point");
  const std::string p = to_string(point);
  EXPECT_EQ(refused_by(changed("henon_heiles_8", {{"xi", R"("0")"},
                                                  {"eta", R"("0")"},
                                                  {"orbit", "[" + p + "," + p + "," + p + "]"}})),
            "4");
}

// x'' = -x beside y'' = y - y^3, whose manifolds coincide: y = sqrt(2)/cosh(t), seen whenever x = 0.
TEST(HomoclinicCertificate, ManifoldsThatCoincideAreRefused) {
  const auto text = [](double x) {
    std::ostringstream s;
    s.precision(17);
    s << x;
    return "\"" + s.str() + "\"";
  };
  std::string orbit;
  for (int k = -2; k <= 2; ++k) {
    const double t = 2 * M_PI * k, y = std::sqrt(2.0) / std::cosh(t);
    orbit += std::string(k > -2 ? "," : "") + "[\"0\"," + text(y) + ",\"1\"," +
             text(-y * std::tanh(t)) + "]";
  }
  const double e = 2 * std::sqrt(2.0) * std::exp(-6 * M_PI);
  EXPECT_EQ(refused_by(changed("henon_heiles_8",
                               {{"hamiltonian", R"(["2*u^2 + 2*v^2 + 2*x^2 - 2*y^2 + y^4", "4"])"},
                                {"level", R"("1/2")"},
                                {"point", R"(["0", "0", "1", "0"])"},
                                {"axes", R"([["1", "1"], ["1", "-1"]])"},
                                {"reach", text(1.5 * e)},
                                {"xi", text(e)},
                                {"eta", text(e)},
                                {"orbit", "[" + orbit + "]"}})),
            "4");
}

TEST(HomoclinicCertificate, WhatIsNoCertificateIsMalformed) {
  const std::vector<Change> all{{"chart", R"(["1", "7"])"},
                                {"chart", R"(["1", "1"])"},
                                {"level", R"("two")"},
                                {"level", R"("1/0")"},
                                {"level", R"("1/")"},
                                {"level", R"("")"},
                                {"level", R"("-")"},
                                {"level", R"("1E999999999")"},
                                {"level", R"("1e")"},
                                {"orbit", "[]"},
                                {"period", R"("0")"},
                                {"period", R"("65")"},
                                {"reach", R"("1e9999")"},
                                {"reach", R"("0")"},
                                {"reach", R"("2")"},
                                {"hamiltonian", R"(["x^2", "0"])"},
                                {"hamiltonian", R"(["x^2", "-1"])"},
                                {"hamiltonian", R"(["x^17", "1"])"},
                                {"hamiltonian", R"("x^2")"},
                                {"section", R"(["z", "1"])"},
                                {"direction", R"("both")"},
                                {"variables", R"(["x", "x", "u", "v"])"},
                                {"variables", R"(["x", "y", "u"])"},
                                {"more", R"("1")"},
                                {"point", R"(["0", "0", "1"])"},
                                {"axes", R"([["1"], ["2"]])"},
                                {"format", R"("kovacic-homoclinic/2")"}};
  for (const auto& [key, value] : all)
    EXPECT_EQ(refused_with(key, value), "malformed") << key << " " << value;
  EXPECT_EQ(refused_by("{}"), "malformed");
}

TEST(HomoclinicCertificate, WorkHasALimit) { // a field whose orbits need very small steps
  EXPECT_NE(refused_with("hamiltonian",
                         R"(["600000000*x^16*y^16*u^16*v^16 + 3*u^2 + 3*v^2 + 3*x^2", "6"])"),
            "");
}

// ---- enclosures

TEST(SectionFlow, AnOscillatorComesBackAfterOneTurn) {
  const Ring ring = make_ring({"x", "y", "u", "v"});
  const auto poly = [&](const char* text) { return read_polynomial(ring, text); };
  const PhaseFunction h{poly("u^2 + v^2 + x^2 + y^2"), Integer(2)}, x{poly("x"), Integer(1)};
  SectionFlow flow(h, x, {}, true);
  const Interval half = Interval(Rational(Integer(1), Integer(2)));
  for (const int way : {1, -1}) {
    const std::array<Interval, 2> off{Interval::around_zero(power_of_two(-40)),
                                      Interval::around_zero(power_of_two(-40))};
    State at{Interval(0), half + off[0], Interval(1), off[1]}, thin{0, half, 1, 0};
    at.resize(12);
    at[4 + 1] = at[8 + 3] = Interval(1);
    flow.to_crossing(at, thin, off, way);
    const Interval y = at[1] - half, rate = at[4 + 1] - Interval(1);
    EXPECT_TRUE(y.has_zero());
    EXPECT_TRUE(y.most() < power_of_two(-38)); // the identity, not much widened
    EXPECT_TRUE(rate.has_zero());
    EXPECT_TRUE(rate.most() < power_of_two(-36));
    EXPECT_TRUE((thin[1] - half).most() < power_of_two(-65));
  }
}

} // namespace
} // namespace kov::certify::homoclinic_test
