#pragma once
// A certificate asks conditions of the point at which it is used; some of its names are levels: parameters that only
// its own system has.

#include "theorem/strata_parts.hpp"

namespace kov {

class AskedThere {
public:
  explicit AskedThere(const StrataParts& s) : s_(s) {}

  // Equations on the way to a leaf are solved for levels.
  [[nodiscard]] Substitution levels_of(const certify::Target& y) const {
    Substitution levels;
    for (const certify::AskedCondition& c : y.asked) {
      if (c.real || !c.group.empty() || c.sign != Sign::zero) continue;
      const MFraction f = substitute(MFraction(c.f), levels);
      if (is_zero(f)) continue;
      for (const std::size_t i : used_variables(f.num())) {
        if (!is_level(f.num().ring()->name(i)) || degree(f.num(), i) != 1 ||
            !is_constant(coefficients(f.num(), i)[1]))
          continue;
        StrataParts::put_in(levels, i, f.num());
        break;
      }
    }
    return levels;
  }
  // Places where all that is asked holds: x with more conditions, as few as are seen to be needed.
  [[nodiscard]] std::vector<PartPlace> where_asked(const certify::Target& y,
                                                   const PartPlace& x) const {
    constexpr std::size_t most = 4;
    std::vector<PartPlace> all{x};
    for (const certify::AskedCondition& c : y.asked) {
      if (needs_no_node(c, x)) continue;
      std::vector<PartPlace> next;
      for (const PartPlace& there : all) {
        if (shown(c, there)) {
          next.push_back(there);
          continue;
        }
        for (const Condition& part : parts_of(c, there)) {
          if (is_zero(part.p) || is_constant(part.p) || next.size() == most) continue;
          auto region = there.region;
          region.push_back({certify::primitive(part.p), part.sign});
          PartPlace smaller = s_.family.placed(there.put, std::move(region));
          smaller.levels = there.levels;
          if (shown(c, smaller)) next.push_back(std::move(smaller));
        }
      }
      all = std::move(next);
    }
    std::erase_if(all,
                  [&](const PartPlace& p) { return s_.proof.contradiction(p.given).has_value(); });
    return all;
  }
  [[nodiscard]] certify::LevelValues level_values(const PartPlace& x) const {
    certify::LevelValues values;
    for (const auto& [i, f] : x.levels) {
      const Ring& ring = s_.family.ring();
      const std::string& name = f.ring()->name(i);
      values[name] = {transfer(f, ring).num(), f.den().coefficient(0)};
    }
    return values;
  }
  // [[name, FUNCTION], ...]
  [[nodiscard]] Json level_rows(const PartPlace& x) const {
    std::vector<Json> rows;
    for (const auto& [name, value] : level_values(x))
      rows.push_back(json_list({json_text(name), certify::to_json(value)}));
    return json_list(std::move(rows));
  }
  // As the judge wants it, which looks at it here already.   Errors  DomainError
  [[nodiscard]] std::vector<Json> shown_of(const certify::Target& y, const PartPlace& x) const {
    std::vector<Json> all;
    for (const certify::AskedCondition& c : y.asked) {
      if (needs_no_node(c, x)) continue;
      auto node = shown(c, x);
      if (!node) throw DomainError("a condition of a certificate is not shown");
      all.push_back(*std::move(node));
    }
    certify::Arithmetic a;
    std::size_t nodes = 100000;
    const certify::Map checked(x, y, level_values(x),
                               certify::Node(json_list(all), "shown", rationals()), a, nodes);
    return all;
  }

private:
  using Exponents = std::vector<unsigned long>;

  // The parts of a polynomial by the monomials in the levels, in the order of the judge.
  [[nodiscard]] std::vector<std::pair<Exponents, MPoly>> by_levels(const MPoly& given,
                                                                   const PartPlace& x) const {
    const MPoly f = substitute(given, x.levels).num();
    const auto level_part = [&](const Exponents& e) {
      Exponents levels(e.size(), 0);
      for (std::size_t j = 0; j < e.size(); ++j)
        if (is_level(f.ring()->name(j))) levels[j] = e[j];
      return levels;
    };
    std::map<Exponents, MPoly> all;
    for (long t = 0; t < f.length(); ++t) {
      const Exponents e = f.exponents(t);
      Exponents here(s_.family.ring()->size(), 0);
      for (std::size_t j = 0; j < e.size(); ++j)
        if (e[j] > 0 && !is_level(f.ring()->name(j)))
          here[s_.family.ring()->index(f.ring()->name(j))] = e[j];
      MPoly& sum = all.try_emplace(level_part(e), MPoly(s_.family.ring())).first->second;
      sum = sum + MPoly::term(s_.family.ring(), f.coefficient(t), here);
    }
    if (all.empty()) all.emplace(Exponents(f.ring()->size(), 0), MPoly(s_.family.ring()));
    return {all.begin(), all.end()};
  }
  [[nodiscard]] bool is_level(const std::string& name) const {
    return !s_.family.ring()->find(name).has_value();
  }
  // A condition that the judge settles by itself.
  [[nodiscard]] bool needs_no_node(const certify::AskedCondition& c, const PartPlace& x) const {
    if (c.real) return true;
    if (!c.group.empty() || !certify::is_ordered(c.sign)) return false;
    const auto used = used_variables(c.f);
    return used.size() == 1 && is_level(c.f.ring()->name(used.front())) &&
           !x.levels.contains(used.front());
  }
  // Conditions on the parameters, one of which is enough: for some values of the levels it holds then.
  [[nodiscard]] std::vector<Condition> parts_of(const certify::AskedCondition& c,
                                                const PartPlace& x) const {
    std::vector<Condition> all;
    for (const MPoly& f : c.group.empty() ? std::vector{c.f} : c.group)
      for (const auto& [levels, part] : by_levels(f, x))
        all.push_back({part, c.sign});
    return all;
  }
  [[nodiscard]] std::optional<Json> shown(const certify::AskedCondition& c,
                                          const PartPlace& x) const {
    auto parts = parts_of(c, x);
    if (c.sign != Sign::nonzero) return s_.proof.shown(x.given, parts.front());
    auto zeros = x.given;
    for (const Condition& part : parts)
      zeros.push_back({part.p, Sign::zero});
    return s_.proof.contradiction(zeros);
  }

  const StrataParts& s_;
};

} // namespace kov
