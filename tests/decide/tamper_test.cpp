// Certificates with something changed: what the judge still accepts must be true.  The truth is
// asked of the solver, for the equation that the changed certificate speaks of.

#include "corpus.hpp"

#include "certify/equation/check.hpp"
#include "exact/error.hpp"

#include <cstdlib>
#include <random>

namespace kov {
namespace {

using Path = Json::json_pointer;

void collect(const Json& j, const Path& at, std::vector<Path>& all) {
  if (at != Path()) all.push_back(at);
  if (j.is_object())
    for (const auto& [key, value] : j.items())
      collect(value, at / key, all);
  if (j.is_array())
    for (std::size_t i = 0; i < j.size(); ++i)
      collect(j[i], at / i, all);
}

class Tamperer {
public:
  explicit Tamperer(unsigned seed) : gen_(seed) {}

  // One to three changes; `other` lends its parts.
  Json operator()(Json c, const Json& other) {
    for (std::size_t k = 1 + pick(3); k > 0; --k)
      change(c, other);
    return c;
  }

private:
  std::size_t pick(std::size_t n) { return gen_() % n; }

  void change(Json& c, const Json& other) {
    static const char* const parts[] = {"r", "claim", "steps", "field"};
    if (pick(8) == 0) {
      const char* const part = parts[pick(4)];
      c[part] = other.at(part);
      return;
    }
    std::vector<Path> paths;
    collect(c, Path(), paths);
    const Path at = paths[pick(paths.size())];
    Json& parent = c.at(at.parent_pointer());
    Json& node = c.at(at);
    if (node.is_string()) {
      const Path from = paths[pick(paths.size())];
      node = pick(4) == 0 && c.at(from).is_string() ? c.at(from)
                                                    : Json(changed(node.get<std::string>()));
    } else if (node.is_boolean()) {
      node = !node.get<bool>();
    } else if (node.is_null()) {
      node = "2";
    } else if (parent.is_array() && parent.size() > 1 && pick(2) == 0) {
      std::swap(node, parent[pick(parent.size())]);
    } else if (parent.is_array() && pick(2) == 0) {
      parent.push_back(Json(node));
    } else if (parent.is_array()) {
      parent.erase(std::stoul(at.back()));
    } else if (pick(2) == 0) {
      node = node.is_array() ? Json::array() : Json::object();
    } else {
      parent.erase(at.back());
    }
  }

  std::string changed(const std::string& s) {
    static const std::vector<std::string> words = {"SL2",
                                                   "Borel",
                                                   "T",
                                                   "Gm",
                                                   "cyclic",
                                                   "Dinf",
                                                   "D",
                                                   "A4",
                                                   "S4",
                                                   "A5",
                                                   "Ga",
                                                   "trivial",
                                                   "infinity",
                                                   "degree",
                                                   "parity",
                                                   "nonzero",
                                                   "irreducible",
                                                   "sl2",
                                                   "diagonal",
                                                   "additive",
                                                   "borel",
                                                   "local",
                                                   "dihedral-genus-0",
                                                   "quaternion",
                                                   "octahedral",
                                                   "tetrahedral",
                                                   "icosahedral",
                                                   "invariant"};
    try {
      const Rational q = Rational::parse(s);
      const Rational near[] = {q + Rational(1),       q - Rational(1), -q,
                               q * Rational(2),       Rational(0),     q / Rational(2),
                               q + Rational(1, 2),    Rational(1),     q * q,
                               Rational(1000000000L), q * Rational(3)};
      return to_string(near[pick(std::size(near))]);
    } catch (const Error&) {
      return words[pick(words.size())];
    }
  }

  std::mt19937 gen_;
};

// Does the solver say what the certificate claims?
bool is_true(const certify::Certificate& c) {
  Options options;
  options.budget = Budget::of_seconds(5);
  options.want_solutions = false;
  const NormalForm equation{.r = RationalFunction(c.num, c.den), .p = RationalFunction()};
  const Decision d = decide(equation, options);
  const auto& claim = c.claim;
  return (!claim.group || (d.group && *claim.group == to_string(d.group->type))) &&
         (!claim.n || (d.group && claim.n == d.group->n)) &&
         (!claim.component || (d.component && *claim.component == to_string(*d.component))) &&
         (!claim.abelian || truth(*claim.abelian) == d.abelian);
}

std::vector<Json> certificates() {
  std::vector<Json> all;
  Options options;
  options.want_certificate = true;
  options.want_solutions = false;
  for (const char* file : {"public.jsonl", "pitfalls.jsonl"})
    for (const Json& entry : corpus(file))
      all.push_back(Json::parse(decide(equation_of(entry), options).certificate));
  return all;
}

// KOV_TAMPER_ROUNDS=100 for a long run
std::size_t rounds() {
  const char* text = std::getenv("KOV_TAMPER_ROUNDS");
  return text == nullptr ? 1 : std::stoul(text);
}

TEST(Tampered, WhatTheJudgeAcceptsIsTrue) {
  const std::vector<Json> genuine = certificates();
  Tamperer tamper(20261121);
  int accepted = 0;
  int refused = 0;
  for (std::size_t i = 0; i < genuine.size(); ++i)
    for (std::size_t k = 0; k < 60 * rounds(); ++k) {
      const Json changed = tamper(genuine[i], genuine[(i * 7 + k * 13 + 1) % genuine.size()]);
      try {
        const certify::Certificate c = certify::read_certificate(changed.dump());
        if (std::holds_alternative<certify::Rejected>(certify::check(c))) {
          ++refused;
          continue;
        }
        ++accepted;
        EXPECT_TRUE(is_true(c)) << changed.dump().substr(0, 3000);
      } catch (const InvalidArgument&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 10000);
  EXPECT_GT(accepted, 100); // unused primes, other names of steps, weaker claims
}

} // namespace
} // namespace kov
