// The answer at a point of the parameters is not weaker than the general one.

#include "classify/classify.hpp"

#include "support/points.hpp"

#include <gtest/gtest.h>

namespace kov::points_test {
namespace {

using test::Point;
using test::status_at;

using Components = std::vector<std::pair<std::string, std::string>>;

std::string field_text(const Components& components) {
  std::string names, formulas;
  for (const auto& [x, formula] : components) {
    names += "'" + x + "', ";
    formulas += x + " = '" + formula + "'\n";
  }
  return "[system]\nkind = 'vector-field'\ncoordinates = [" + names +
         "]\nparameters = ['a', 'b']\n[system.field]\n" + formulas;
}
std::string planar_text(const std::string& h) {
  return "[system]\nkind = 'hamiltonian'\ncoordinates = ['x', 'y']\nmomenta = ['u', 'v']\n"
         "parameters = ['a', 'b']\nhamiltonian = '" +
         h + "'\n";
}

std::string status(const std::string& text, const Point& point, bool fixed) {
  ParameterValues values;
  if (fixed)
    for (const auto& [name, value] : point)
      values.emplace_back(name, to_string(value));
  ClassifyOptions options;
  options.check.decide.budget.give(1e8 * 30);
  const auto c = classify_system(read_system(parse_document(text, "point.toml"), values), options);
  return status_at(c, fixed ? Point{} : point);
}

// At special values there are more integrals, blocks of the variations fall apart, ...
TEST(Points, AreNotWeaker) {
  const std::vector<std::string> families{
      field_text({{"x", "1"}, {"y", "a*x*y + z"}, {"z", "b*y"}}),
      field_text({{"x", "1"}, {"y", "a*x^2*y + z"}, {"z", "b*x*y"}}),
      field_text({{"x", "1"}, {"y", "b*z"}, {"z", "a*x*z + y"}}),
      planar_text("(u^2 + v^2 + x^2 + y^2)/2 + a*x^2*y + b*y^3")};
  for (const std::string& family : families)
    for (const Point& point : std::vector<Point>{{{"a", 1}, {"b", 0}},
                                                 {{"a", -2}, {"b", 0}},
                                                 {{"a", 0}, {"b", 1}},
                                                 {{"a", 3}, {"b", 2}}}) {
      const std::string general = status(family, point, false);
      if (general != "open") {
        EXPECT_EQ(status(family, point, true), general)
            << family << to_string(point.at("a")) << ", " << to_string(point.at("b"));
      }
    }
}

} // namespace
} // namespace kov::points_test
