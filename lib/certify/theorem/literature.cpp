// A theorem of the literature about one family: theorem_certificates.md 9.

#include "certify/equation/facts.hpp"
#include "certify/theorem/rules.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

// The family of [Ziglin1983].
constexpr const char* symmetric_heavy_top = R"({"name": "Ziglin 1983",
"parameters": ["A", "C", "L1", "L2", "L3"],
"system": {"coordinates": ["M1", "M2", "M3", "Gamma1", "Gamma2", "Gamma3"],
"inverses": [{"name": "u1", "of": "C"}, {"name": "u2", "of": "A"}],
"hamiltonian": ["M1^2*u1*u2*C + M2^2*u1*u2*C + M3^2*u1*u2*A + 2*Gamma1*u1*u2*A*C*L1 + )"
                                            R"(2*Gamma2*u1*u2*A*C*L2 + 2*Gamma3*u1*u2*A*C*L3", "2"],
"brackets": [["M1", "M2", "-M3"], ["M1", "M3", "M2"], ["M1", "Gamma2", "-Gamma3"],
["M1", "Gamma3", "Gamma2"], ["M2", "M3", "-M1"], ["M2", "Gamma1", "Gamma3"],
["M2", "Gamma3", "-Gamma1"], ["M3", "Gamma1", "-Gamma2"], ["M3", "Gamma2", "Gamma1"]]},
"assumptions": [{"p": "A", "sign": "positive"}, {"p": "C", "sign": "positive"},
{"p": "L1^2 + L2^2", "sign": "positive"}, {"p": "A - C", "sign": "nonzero"},
{"p": "A^2 - 4*A*C + 4*C^2 + L3^2", "sign": "positive"},
{"p": "A^2 - 8*A*C + 16*C^2 + L3^2", "sign": "positive"}]})";

// The same names, Hamiltonian, brackets and assumptions.
bool is_same_family(const Family& x, const Family& y) {
  const PhaseSystem &s = x.system, &t = y.system;
  if (s.ring->names() != t.ring->names() || s.dimension != t.dimension) return false;
  const auto alike = [&](const MPoly& f, const MPoly& g) { return f == in_ring(g, s.ring); };
  const auto same = [&](const PhaseFunction& f, const PhaseFunction& g) {
    return f.n == g.n && alike(f.p, g.p);
  };
  return same(*s.hamiltonian, *t.hamiltonian) &&
         std::ranges::equal(s.inverses, t.inverses, alike) &&
         std::ranges::equal(s.brackets, t.brackets,
                            [&](const PhaseBracket& a, const PhaseBracket& b) {
                              return a.first == b.first && a.second == b.second &&
                                     same(a.value, b.value);
                            }) &&
         x.assumptions == x.renamed(y.assumptions);
}

} // namespace

Said rule::literature(Keys& step, Derivation& d) {
  need(step.at("theorem").text() == "Ziglin 1983", "an unknown theorem");
  const Family& y = d.plain_family(step);
  const Json json = parse_json(symmetric_heavy_top);
  const Family known = read_family(Node(json, "Ziglin 1983", rationals()), d.arithmetic());
  need(is_same_family(y, known), "not the system of the theorem");
  Said f{FactKind::not_integrable, &y, {{}}};
  f.classes = {on_leaves()};
  f.used = {"Ziglin 1983"};
  return f;
}

} // namespace kov::certify
