#pragma once
// A small certificate of the format kovacic-system/1 and its variations.
//
// H = p2 + p1^2/2 - q2^2 q1^2/2 along q1 = p1 = p2 = 0, where q2 = t and xi'' = t^2 xi.  With z = q2^2
// the field of the curve is K(z)[w], w^2 = z.

#include "certify/strata_text.hpp"
#include "certify/system/check.hpp"

namespace kov::certify {

inline const char* const weber =
    R"({"format":"kovacic-certificate/1","field":{"name":"","minpoly":["0","1"]},)"
    R"("r":{"num":["-3/16","0","1/4"],"den":["0","0","1"]},)"
    R"("claim":{"group":"SL2","n":null,"component":"SL2","abelian":false},"steps":[)"
    R"({"id":"local","rule":"local","premises":[],"data":{"prime":{"p":"1152921504606859327","a":"0"},)"
    R"("places":[{"q":["0","1"],"order":"2","delta2":["1/4"]}],"infinity":{"eps2":[]}}},)"
    R"({"id":"line","rule":"no-exponential","premises":["local"],"data":{"by":"degree"}},)"
    R"({"id":"four","rule":"no-invariant","premises":["local"],"data":{"m":"4","by":"degree"}},)"
    R"({"id":"end","rule":"conclude","premises":["local","line","four"],)"
    R"("data":{"theorem":"sl2-irreducible-infinite"}}]})";

struct SystemText {
  std::string parameters = "[]";
  std::string functions = "", inverses = "", relations = "";
  std::string dynamics = R"("hamiltonian":["2*p2 + p1^2 - q2^2*q1^2","2"],)"
                         R"("brackets":[["q1","p1","1"],["q2","p2","1"]])";
  std::string claims = "";
  std::string equations = R"(["q1","p1"])", levels = R"(["p2"])";
  std::string change = R"("q2^2")";
  std::string denominators = R"(["z"])";
  std::string tower = R"([{"name":"w","degree":"2","value":"z","derivative":["w","2","1"]}])";
  std::string values = R"("q1":"0","q2":"w","p1":"0","p2":"0")";
  std::string time = R"(["w","2","1"])";
  std::string annihilators = "";
  std::string row = R"(["1","0","0","0"])";
  std::string p = R"(["1","2","1"])", q = R"(["-1","4"])";
  std::string rest = "";
  std::string vectors = R"([["0","0","1","0"],["-2*w","0","0","0"]])";
  std::string equation = std::string(R"({"certificate":)") + weber + "}";
  std::string claim = "true";

  [[nodiscard]] std::string operator()() const {
    return R"({"format":"kovacic-system/1","title":"a system","parameters":)" + parameters +
           R"(,"system":{"coordinates":["q1","q2","p1","p2"],"functions":[)" + functions +
           R"(],"inverses":[)" + inverses + R"(],"relations":[)" + relations + "]," + dynamics +
           R"(},"claims":[)" + claims + R"(],"curve":{"manifold":"N","equations":)" + equations +
           R"(,"levels":)" + levels + R"(,"variable":"z","change":)" + change +
           R"(,"denominators":)" + denominators + R"(,"tower":)" + tower + R"(,"values":{)" +
           values + R"(},"time":)" + time + R"(},"normal":{"annihilators":[)" + annihilators +
           R"(],"row":)" + row + R"(,"p":)" + p + R"(,"q":)" + q + R"(,"rest":[)" + rest +
           R"(],"vectors":)" + vectors + R"(},"equation":)" + equation +
           R"(,"claim":{"not_integrable":)" + claim + "}}";
  }
};

/// The rule that refuses a text; empty if it is accepted.
inline std::string refused_by(const std::string& text) {
  std::string rule;
  try {
    const auto verdict = check_way(read_system_certificate(text));
    if (const auto* no = std::get_if<Rejected>(&verdict)) rule = no->step;
  } catch (const InvalidArgument&) {
    rule = "malformed";
  }
  record(rule.empty(), text);
  return rule;
}

/// The lines of the statement.
inline std::vector<std::string> stated(const std::string& text) {
  const SystemCertificate c = read_system_certificate(text);
  const auto verdict = check_way(c);
  if (const auto* no = std::get_if<Rejected>(&verdict)) return {no->step + ": " + no->why};
  return statement(c, std::get<SystemAccepted>(verdict));
}

} // namespace kov::certify
