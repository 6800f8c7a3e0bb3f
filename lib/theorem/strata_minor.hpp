#pragma once
// Why gradients, a bracket or fields have their rank on a stratum: a minor with a coefficient that is not 0 there.

#include "theorem/strata_parts.hpp"

namespace kov {

class ShownMinor {
public:
  explicit ShownMinor(const StrataParts& s) : s_(s) {}

  // A minor with a coefficient that is not 0 on the stratum; null: it is on trust.
  Json operator()(const certify::ClaimedIntegrals& c, bool rank, std::size_t size,
                  const PartPlace& x) {
    const std::size_t d = s_.family.phase().dimension;
    constexpr std::size_t most_tries = 200;
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < size; ++i)
      columns.push_back(i);
    for (std::size_t tries = 0; tries < most_tries && size <= d; ++tries) {
      if (auto found = coefficient(minor_polynomial(x, c, rank, columns), x)) {
        std::vector<Json> names;
        for (const std::size_t i : columns)
          names.push_back(json_text(s_.family.phase().ring->name(i)));
        found->emplace(found->begin(), "columns", json_list(std::move(names)));
        return Json{*std::move(found)};
      }
      if (!next(columns, d)) break;
    }
    return {};
  }

private:
  using Exponents = std::vector<unsigned long>;

  // 0 where the format has no rule for its functions.
  [[nodiscard]] MPoly minor_polynomial(const PartPlace& x, const certify::ClaimedIntegrals& c,
                                       bool rank, const std::vector<std::size_t>& columns) const {
    try {
      certify::Arithmetic a;
      return certify::minor_of(x, c, rank, columns, a);
    } catch (const certify::Refused&) {
      return MPoly(s_.family.ring());
    }
  }
  static bool next(std::vector<std::size_t>& columns, std::size_t d) {
    const std::size_t n = columns.size();
    for (std::size_t k = n; k-- > 0;) {
      if (columns[k] + (n - k) >= d) continue;
      ++columns[k];
      for (std::size_t i = k + 1; i < n; ++i)
        columns[i] = columns[i - 1] + 1;
      return true;
    }
    return false;
  }
  [[nodiscard]] std::optional<Json::Object> coefficient(const MPoly& f, const PartPlace& x) const {
    const std::size_t d = s_.family.phase().dimension;
    std::map<Exponents, MPoly> all;
    const std::set<Exponents> with_functions = beside_functions(f);
    for (long t = 0; t < f.length(); ++t) {
      Exponents e = f.exponents(t);
      if (with_functions.contains(without_arguments(e))) continue;
      const Exponents monomial(e.begin(), e.begin() + static_cast<long>(d));
      std::fill(e.begin(), e.begin() + static_cast<long>(d), 0);
      MPoly& sum = all.try_emplace(monomial, MPoly(f.ring())).first->second;
      sum = sum + MPoly::term(f.ring(), f.coefficient(t), e);
    }
    std::vector<std::pair<Exponents, MPoly>> sorted(all.begin(), all.end());
    std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) {
      return total_degree(a.second) < total_degree(b.second);
    });
    constexpr std::size_t most_tries = 30;
    for (std::size_t k = 0; k < sorted.size() && k < most_tries; ++k) {
      const auto& [monomial, c] = sorted[k];
      const MPoly value = certify::primitive(s_.family.moved({c, Sign::nonzero}).p);
      if (is_zero(value)) continue;
      auto node = s_.proof.shown(x.given, {value, Sign::nonzero});
      if (!node) continue;
      std::vector<Json> exponents;
      for (const unsigned long e : monomial)
        exponents.push_back(json_text(std::to_string(e)));
      return Json::Object{{"monomial", json_list(std::move(exponents))},
                          {"value", json_text(to_string(value))},
                          {"by", *std::move(node)}};
    }
    return std::nullopt;
  }
  // The powers of those coordinates on which no function depends.
  [[nodiscard]] Exponents without_arguments(Exponents e) const {
    e.resize(s_.family.phase().dimension);
    for (const certify::PhaseSymbol& f : s_.family.phase().functions)
      for (const auto& [j, slope] : f.gradient)
        e[j] = 0;
    return e;
  }
  [[nodiscard]] std::set<Exponents> beside_functions(const MPoly& f) const {
    std::set<Exponents> all;
    const auto first = static_cast<long>(s_.family.phase().dimension);
    const auto last = static_cast<long>(s_.family.phase().first_parameter());
    for (long t = 0; t < f.length(); ++t) {
      const Exponents e = f.exponents(t);
      if (std::any_of(e.begin() + first, e.begin() + last, [](auto n) { return n > 0; }))
        all.insert(without_arguments(e));
    }
    return all;
  }

  const StrataParts& s_;
};

} // namespace kov
