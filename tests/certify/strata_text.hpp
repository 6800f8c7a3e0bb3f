#pragma once
// Small certificates of the format kovacic-strata/1, put together from their parts.

#include "certify/strata/check.hpp"
#include "exact/error.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

namespace kov::certify {

struct StrataText {
  std::string parameters = R"(["A"])";
  std::string real = "[]";
  std::string assumptions = "[]";
  std::string generic = "[]";
  std::string num = "z", den = "1";
  std::string claim = "null";
  std::string tree = {};

  [[nodiscard]] std::string operator()() const {
    return R"({"format":"kovacic-strata/1","variable":"z","parameters":)" + parameters +
           R"(,"real":)" + real + R"(,"assumptions":)" + assumptions + R"(,"generic":)" + generic +
           R"(,"r":{"num":")" + num + R"(","den":")" + den + R"("},"claim":{"abelian":)" + claim +
           R"(},"tree":)" + tree + "}";
  }
};

/// text with the first occurrence of a part replaced, which has to be there.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << "no " << part << " in " << text;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

/// For the Python checker: the verdict and the text, as one line of the file that
/// KOV_CERTIFICATE_TEXTS names.
inline void record(bool accepted, const std::string& text) {
  const char* name = std::getenv("KOV_CERTIFICATE_TEXTS");
  if (name && text.find('\n') == std::string::npos)
    std::ofstream(name, std::ios::app) << (accepted ? "a " : "r ") << text << "\n";
}

/// Why a text is refused; empty if it is accepted.
inline std::string refusal(const std::string& text) {
  std::string why;
  try {
    const auto verdict = check_strata(read_strata_certificate(text));
    if (const auto* no = std::get_if<Rejected>(&verdict)) why = no->step + ": " + no->why;
  } catch (const InvalidArgument& e) {
    why = std::string("malformed: ") + e.what();
  }
  record(why.empty(), text);
  return why;
}

inline StrataAccepted accepted(const std::string& text) {
  const auto verdict = check_strata(read_strata_certificate(text));
  const auto* no = std::get_if<Rejected>(&verdict);
  EXPECT_EQ(no, nullptr) << (no ? no->step + ": " + no->why : "");
  record(no == nullptr, text);
  return no ? StrataAccepted{} : std::get<StrataAccepted>(verdict);
}

#define EXPECT_ACCEPTED(text) EXPECT_EQ(refusal(text), "")
/// The reason contains some words.
#define EXPECT_REFUSED(text, words)                                                                \
  EXPECT_NE(refusal(text).find(words), std::string::npos) << "instead: '" << refusal(text) << "'"

// ---- nodes

inline std::string split(const std::string& p, const std::string& nonzero,
                         const std::string& zero) {
  return R"({"node":"split","p":")" + p + R"(","nonzero":)" + nonzero + R"(,"zero":)" + zero + "}";
}
inline std::string assumed(const std::string& i, const std::string& p, const std::string& zero) {
  return R"({"node":"assumed","condition":")" + i + R"(","p":")" + p + R"(","zero":)" + zero + "}";
}
/// r: "" for none, else num and den.
inline std::string solve(const std::string& x, const std::string& num, const std::string& den,
                         const std::string& then) {
  const std::string r = num.empty() ? "" : R"("r":{"num":")" + num + R"(","den":")" + den + "\"},";
  return R"({"zero":"solve","variable":")" + x + "\"," + r + R"("then":)" + then + "}";
}
inline std::string lemmas(const std::string& list, const std::string& then) {
  return R"({"node":"lemmas","lemmas":[)" + list + R"(],"then":)" + then + "}";
}
inline std::string leaf(const std::string& abelian, const std::string& by,
                        const std::string& rest) {
  return R"({"node":"leaf","abelian":")" + abelian + R"(","by":")" + by + "\"," + rest + "}";
}
/// A leaf with places: content, the finite places, infinity.
inline std::string places(const std::string& by, const std::string& content,
                          const std::string& finite, const std::string& infinity = "",
                          const std::string& rest = "") {
  return leaf("no", by,
              R"("content":")" + content + R"(","places":[)" + finite + R"(],"infinity":{)" +
                  infinity + "}" + rest);
}
inline std::string place(const std::string& q, const std::string& order,
                         const std::string& rest = "") {
  return R"({"q":")" + q + R"(","order":")" + order + "\"" + (rest.empty() ? "" : "," + rest) + "}";
}
inline std::string number(const std::string& abelian, const std::string& certificate) {
  return leaf(abelian, "number", R"("certificate":)" + certificate);
}
inline const std::string open_node = R"({"node":"open","reason":"not looked at"})";
inline const std::string open_zero = R"({"zero":"open","reason":"not looked at"})";
inline const std::string empty_zero = R"({"zero":"empty"})";

/// y'' = (z + A) y is never abelian: a torus, D_4 = -1.
inline const std::string airy_leaf = places("torus", "1", "");

// ---- ordinary certificates, written by `kovacic solve --certificate`

inline std::string nested(const std::string& field, const std::string& num, const std::string& den,
                          const std::string& claim, const std::string& steps) {
  return R"({"format":"kovacic-certificate/1","field":)" + field + R"(,"r":{"num":)" + num +
         R"(,"den":)" + den + R"(},"claim":)" + claim + R"(,"steps":[)" + steps + "]}";
}
inline const std::string over_q = R"({"name":"","minpoly":["0","1"]})";
inline const std::string claims_sl2 =
    R"({"group":"SL2","n":null,"component":"SL2","abelian":false})";
inline const std::string claims_gm = R"({"group":"Gm","n":null,"component":"Gm","abelian":true})";

/// y'' = (z + c) y over Q or Q(sqrt 2), SL(2).
inline std::string airy(const std::string& num = R"(["0","1"])", bool irrational = false) {
  const std::string a = irrational ? "385864230469287070" : "0";
  return nested(
      irrational ? R"({"name":"a","minpoly":["-2","0","1"]})" : over_q, num, R"(["1"])", claims_sl2,
      R"({"id":"local","rule":"local","premises":[],"data":{"prime":{"p":"1152921504606859327","a":")" +
          a +
          R"("},"places":[],"infinity":{}}},{"id":"irreducible","rule":"no-exponential","premises":["local"],"data":{"by":"parity"}},{"id":"no-invariant-4","rule":"no-invariant","premises":["local"],"data":{"m":"4","by":"degree"}},{"id":"conclusion","rule":"conclude","premises":["local","irreducible","no-invariant-4"],"data":{"theorem":"sl2-irreducible-infinite"}})");
}
/// y'' = y.
inline const std::string exponential = nested(
    over_q, R"(["1"])", R"(["1"])", claims_gm,
    R"({"id":"local","rule":"local","premises":[],"data":{"prime":{"p":"1152921504606859327","a":"0"},"places":[],"infinity":{}}},{"id":"invariant","rule":"invariant","premises":[],"data":{"prime":{"p":"1152921504606859327","a":"0"},"m":"2","p":["1"],"factors":[]}},{"id":"conclusion","rule":"conclude","premises":["local","invariant"],"data":{"theorem":"diagonal"}})");
/// y'' = (1 + 3/(4 z^2)) y, SL(2).
inline const std::string bessel_1 = nested(
    over_q, R"(["3/4","0","1"])", R"(["0","0","1"])", claims_sl2,
    R"({"id":"local","rule":"local","premises":[],"data":{"prime":{"p":"1152921504606859327","a":"0"},"places":[{"q":["0","1"],"order":"2","delta2":["4"],"log":{"p":"1152921504606859327","a":"0","roots":["0"]}}],"infinity":{"eps2":[]}}},{"id":"irreducible","rule":"no-exponential","premises":["local"],"data":{"by":"degree"}},{"id":"conclusion","rule":"conclude","premises":["local","irreducible"],"data":{"theorem":"sl2-irreducible-log"}})");

} // namespace kov::certify
