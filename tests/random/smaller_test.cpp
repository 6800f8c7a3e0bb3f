// What makes failing formulas smaller.

#include "support/smaller.hpp"

#include <gtest/gtest.h>

namespace kov::test {
namespace {

bool has_all(const std::string& text, const std::vector<std::string>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const std::string& one) { return text.find(one) != std::string::npos; });
}

TEST(Smaller, KeepsWhatFails) {
  const auto smallest = [](const std::string& text, const std::vector<std::string>& wanted) {
    return smaller(text, [&](const std::string& t) { return has_all(t, wanted); });
  };
  EXPECT_EQ(smallest("(3*z^2+17*z-5)/(z^2-1)^2+1/z", {"1/z"}), "1/z");
  EXPECT_EQ(smallest("a*(z-12345)^2+b/(z*(z-1))", {"b/"}), "b/0");
  EXPECT_EQ(smallest("sqrt(a^2+1)*z+4", {"sqrt("}), "sqrt(0)");
  EXPECT_EQ(smallest("12345678*z", {"z"}), "z");
  EXPECT_EQ(smallest("z", {"z"}), "z");
}

TEST(Smaller, AsksNotForever) {
  int asked = 0;
  const std::string text = "a+b+c+d+e+f+g+h";
  EXPECT_EQ(smaller(
                text, [&](const std::string&) { return ++asked < 0; }, 7),
            text);
  EXPECT_EQ(asked, 7);
}

} // namespace
} // namespace kov::test
