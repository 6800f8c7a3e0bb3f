// Texts made to break a reader: each ends in one InvalidArgument or one Rejected, at once.

#include "certify/equation/check.hpp"
#include "exact/error.hpp"

#include <gtest/gtest.h>

#include <ctime>

namespace kov::certify::hostile_test {
namespace {

std::string repeated(const std::string& s, int n) {
  std::string out;
  for (int i = 0; i < n; ++i)
    out += s;
  return out;
}

std::string with_steps(const std::string& num, const std::string& den, const std::string& steps,
                       const std::string& minpoly = R"(["0","1"])") {
  return R"({"format":"kovacic-certificate/1","field":{"name":"","minpoly":)" + minpoly +
         R"(},"r":{"num":)" + num + R"(,"den":)" + den +
         R"(},"claim":{"group":"SL2","n":null,"component":null,"abelian":null},"steps":[)" + steps +
         "]}";
}

std::string step(const std::string& id, const std::string& rule, const std::string& premises,
                 const std::string& data) {
  return R"({"id":")" + id + R"(","rule":")" + rule + R"(","premises":[)" + premises +
         R"(],"data":)" + data + "}";
}

const std::string p61 = R"("p":"2305843009213693951","a":"0")";
const std::string end = "," + step("end", "conclude", R"("a")", R"({"theorem":"borel"})");

void refuse(const std::string& text) {
  const std::clock_t start = std::clock();
  try {
    const auto verdict = check(read_certificate(text));
    const auto* no = std::get_if<Rejected>(&verdict);
    EXPECT_NE(no, nullptr) << text.substr(0, 300);
  } catch (const InvalidArgument&) { // as good
  }
  EXPECT_LT(std::clock() - start, 10 * CLOCKS_PER_SEC) << text.substr(0, 300);
}

TEST(Hostile, Syntax) {
  for (const char* text : {"",
                           " ",
                           "{",
                           "}",
                           "[]",
                           "{}",
                           "null",
                           "NaN",
                           "Infinity",
                           "1",
                           "1e999",
                           "\"",
                           "\"\\u",
                           "\"\\uD800\"",
                           "{\"a\":1}",
                           "\xff\xfe",
                           "\xef\xbb\xbf{}",
                           "{\"a\":\"b\",\"a\":\"b\"}",
                           "{\"a\":\"b\"}x",
                           "[,]",
                           "{,}",
                           "tru"})
    refuse(text);
  refuse(repeated("[", 1000000));
  refuse(repeated("{\"a\":", 1000000));
  refuse(std::string(1000, '\0'));
  refuse("\"" + std::string(1 << 22, 'x'));
}

TEST(Hostile, Types) {
  const std::string r = R"(["0","1"])";
  const std::string good = step("a", "exponential", "", R"({"p":["1"],"num":["1"],"den":["1"]})");
  for (const char* bad : {"null", "true", "\"\"", "\"x\"", "\"1/0\"", "\"0/2\"", "\"-0\"", "\"01\"",
                          "\"1 \"", "\"1e9\"", "\"NaN\"", "[]", "{}", "[[[\"1\"]]]", "\"1.5\"",
                          "\"+1\"", "\"0x10\"", "\"--1\"", "[null]"}) {
    refuse(with_steps(std::string("[") + bad + "]", R"(["1"])", good + end));
    refuse(with_steps(r, bad, good + end));
    refuse(with_steps(r, R"(["1"])", good + end, bad));
    refuse(with_steps(r, R"(["1"])", bad));
    refuse(with_steps(r, R"(["1"])", step("a", "p-curvature", "", bad) + end));
  }
}

TEST(Hostile, Sizes) {
  const std::string huge = "1" + std::string(400, '0');
  const std::string z = R"(["0","1"])";
  const std::string one = R"(["1"])";
  for (const std::string& n :
       {std::string("1000000000"), std::string("-1"), std::string("0"), huge, "-" + huge,
        std::string("9223372036854775807"), std::string("4611686018427387903")}) {
    const std::string place =
        R"({"prime":{)" + p61 + R"(},"infinity":{},"places":[{"q":["0","1"],)";
    refuse(with_steps(one, z, step("a", "local", "", place + R"("order":")" + n + "\"}]}") + end));
    refuse(
        with_steps(z, one,
                   step("a", "invariant", "",
                        "{\"prime\":{" + p61 + R"(},"m":")" + n + R"(","p":["1"],"factors":[]})") +
                       end));
    refuse(with_steps(z, one,
                      step("a", "invariant", "",
                           "{\"prime\":{" + p61 +
                               R"(},"m":"2","p":["1"],"factors":[{"q":["0","1"],"e":")" + n +
                               R"("}]})") +
                          end));
    refuse(with_steps(
        z, one,
        step("a", "p-curvature", "", R"({"p":")" + n + R"(","a":"0","shows":"nonzero"})") + end));
    const std::string local =
        step("l", "local", "", "{\"prime\":{" + p61 + R"(},"infinity":{},"places":[]})") + ",";
    refuse(with_steps(
        z, one,
        local +
            step("a", "no-invariant", "\"l\"",
                 R"({"m":"4","by":"series",)" + p61 + R"(,"x0":"1","terms":")" + n + "\"}") +
            end));
    refuse(with_steps(z, one,
                      local +
                          step("a", "no-exponential", "\"l\"",
                               R"({"by":"series","place":"infinity",)" + p61 +
                                   R"(,"root":"0","delta":"1","lines":[],"terms":")" + n + "\"}") +
                          end));
  }
}

// Short texts whose products or common denominators would fill the memory.
TEST(Hostile, Bulk) {
  const std::string digits = "\"1" + std::string(150000, '7') + "\"";
  const std::string p61_prime = "{\"prime\":{" + p61 + "},";
  // (z - 777...)^200000 against a short den
  refuse(with_steps(R"(["1"])", "[" + repeated("\"0\",", 200000) + "\"1\"]",
                    step("a", "local", "",
                         p61_prime + R"("infinity":{},"places":[{"q":[)" + digits +
                             R"(,"1"],"order":"200000"}]})") +
                        end));
  std::string fractions = "[";
  for (int i = 0; i < 60000; ++i)
    fractions += "\"1/" + std::to_string(1000000007L + 2L * i) + "\",";
  refuse(with_steps(fractions + "\"1\"]", R"(["1"])",
                    step("a", "exponential", "", R"({"p":["1"],"num":["1"],"den":["1"]})") + end));
  refuse(
      with_steps("[" + repeated("\"1\",", 2000) + digits + "]", R"(["1"])",
                 step("a", "invariant", "",
                      p61_prime + R"("m":"200","p":["1"],"factors":[{"q":["0","1"],"e":"1"}]})") +
                     end));
  // many steps, each as long as is allowed
  std::string steps = step("l", "local", "", p61_prime + R"("infinity":{"eps2":[]},"places":[]})");
  for (int i = 0; i < 900; ++i)
    steps += "," + step("s" + std::to_string(i), "no-exponential", "\"l\"",
                        R"({"by":"series","place":"infinity",)" + p61 +
                            R"(,"root":"0","delta":"1","lines":[],"terms":"60000"})");
  refuse(with_steps(R"(["0","0","1"])", R"(["1"])", steps + end));
  std::string minpoly = "[";
  for (int i = 0; i < 24; ++i)
    minpoly += digits + ",";
  refuse(with_steps(R"(["0","1"])", R"(["1"])",
                    step("a", "exponential", "", R"({"p":["1"],"num":["1"],"den":["1"]})") + end,
                    minpoly + "\"1\"]"));
}

} // namespace
} // namespace kov::certify::hostile_test
