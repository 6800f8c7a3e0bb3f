#include "integrability/variational_monodromy.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "integrability/constants.hpp"

#include "decide/decide.hpp"
#include "galois/exponential_form.hpp"

#include <algorithm>

namespace kov {
namespace {

void refuse_parameters(const System& s, const Matrix& a) {
  std::string names;
  for (const std::size_t i : s.field.parameters)
    if (std::ranges::any_of(a, [&](const auto& row) {
          return std::ranges::any_of(row, [&](const MFraction& f) {
            const auto used = used_variables(f);
            return is_among(i, used);
          });
        }))
      names += (names.empty() ? "" : ", ") + s.ring()->name(i);
  if (!names.empty())
    throw InvalidArgument("matrices of numbers need values for " + names + ": --set NAME=VALUE");
}

std::vector<std::vector<RationalFunction>> with_numbers(const System& s, const Matrix& matrix,
                                                        std::size_t z) {
  refuse_parameters(s, matrix);
  const ConstantField constants = ConstantField::make(s.field);
  std::vector<std::vector<RationalFunction>> a;
  for (const auto& row : matrix) {
    a.emplace_back();
    for (const MFraction& entry : row)
      a.back().push_back(constants.convert(entry, z));
  }
  return a;
}

NumericalVariation with_numbers(const System& s, const RationalSystem& r, const MFraction& phi) {
  return {r.names, r.change, monodromy::make_system(with_numbers(s, r.a, r.z)), r, phi};
}

// Smaller first, then fewer singularities.
std::pair<long, long> size_of(const NumericalVariation& v) {
  return {v.system.size(), degree(monodromy::common_denominator(v.system))};
}

class Search {
public:
  Search(const System& s, const InvariantManifold& m, const LinearSystem& linear,
         const std::vector<MPoly>& divisors, const Budget& budget)
      : s_(s), m_(m), linear_(linear), divisors_(divisors), budget_(budget) {}

  void attempt(const MFraction& phi) {
    budget_.check();
    const auto result = rational_system(s_.field, m_, s_.z, phi, linear_, divisors_, budget_);
    if (const auto* failure = std::get_if<ChangeFailure>(&result)) return note(failure->message);
    const auto& r = std::get<RationalSystem>(result);
    if (static_cast<long>(r.a.size()) > monodromy::largest_size)
      return note(r.change + " gives a system of size " + std::to_string(r.a.size()) +
                  " (the largest is " + std::to_string(monodromy::largest_size) + ")");
    auto v = with_numbers(s_, r, phi);
    if (!best_ || size_of(v) < size_of(*best_)) best_ = std::move(v);
  }

  [[nodiscard]] const std::optional<NumericalVariation>& best() const { return best_; }
  [[nodiscard]] std::string failures() const { return joined(failures_, "; "); }

private:
  void note(const std::string& failure) { add_once(failures_, failure); }

  const System& s_;
  const InvariantManifold& m_;
  const LinearSystem& linear_;
  const std::vector<MPoly>& divisors_;
  const Budget& budget_;
  std::optional<NumericalVariation> best_;
  std::vector<std::string> failures_;
};

} // namespace

NumericalVariation numerical_variation(const System& s, const InvariantManifold& m,
                                       const LinearSystem& linear,
                                       const std::vector<MPoly>& divisors, const Budget& budget) {
  Search search(s, m, linear, divisors, budget);
  const ReduceSpec* reduce = reduction_for(s, m.name);
  if (reduce != nullptr && reduce->change) search.attempt(*reduce->change);
  if (!search.best())
    for (const MFraction& phi : propose_changes(s.field, m))
      search.attempt(phi);
  if (!search.best())
    throw InvalidArgument("no change of variable leads to a system over the rational functions" +
                          (search.failures().empty() ? "" : ": " + search.failures()));
  return *search.best();
}

namespace {

namespace mo = monodromy;

// The coefficients of F, if it is a squarefree polynomial of degree 3 or 4.
std::optional<Poly> elliptic(const RationalFunction& f) {
  if (degree(f.den()) > 0 || degree(f.num()) < 3 || degree(f.num()) > 4) return std::nullopt;
  if (degree(gcd(f.num(), derivative(f.num()))) > 0) return std::nullopt;
  return scale(f.num(), NfElem(1) / f.den().coeff(0));
}

// Changes of variable one after the other: that of the file, then the proposed ones.
std::vector<MFraction> changes_for(const System& s, const InvariantManifold& m) {
  std::vector<MFraction> all;
  const ReduceSpec* reduce = reduction_for(s, m.name);
  if (reduce != nullptr && reduce->change) all.push_back(*reduce->change);
  std::ranges::move(propose_changes(s.field, m), std::back_inserter(all));
  return all;
}

} // namespace

EllipticVariation elliptic_variation(const System& s, const InvariantManifold& m,
                                     const LinearSystem& linear, const Budget& budget) {
  std::string failures;
  const auto note = [&](const std::string& why) {
    failures += (failures.empty() ? "" : "; ") + why;
  };
  for (const MFraction& phi : changes_for(s, m)) {
    budget.check();
    const auto result = system_on_two_sheets(s.field, m, s.z, phi, linear, budget);
    if (const auto* failure = std::get_if<ChangeFailure>(&result)) {
      note(failure->message);
      continue;
    }
    const auto& on_curve = std::get<SystemOnTwoSheets>(result);
    const auto f = elliptic(with_numbers(s, {{on_curve.z_dot_squared}}, s.z)[0][0]);
    if (!f) {
      note("for " + on_curve.change +
           " the curve (dz/dt)^2 = F(z) is not of genus one with the time as its integral");
      continue;
    }
    return {on_curve.names,
            on_curve.change,
            {with_numbers(s, on_curve.even, s.z), with_numbers(s, on_curve.odd, s.z), *f}};
  }
  throw InvalidArgument("the phase curve is not (dz/dt)^2 = F(z), F of degree 3 or 4" +
                        (failures.empty() ? "" : ": " + failures));
}

std::optional<EllipticBlockProof> prove_non_abelian(const mo::EllipticSystem& s,
                                                    const mo::EllipticMonodromy& m,
                                                    const Budget& budget) {
  auto pattern = s.even;
  for (std::size_t i = 0; i < s.size(); ++i)
    for (std::size_t j = 0; j < s.size(); ++j)
      pattern[i][j] = RationalFunction(is_zero(s.even[i][j]) && is_zero(s.odd[i][j]) ? 0 : 1);
  const mo::Monodromy known = mo::elements(m);
  for (const auto& block : diagonal_blocks(mo::make_system(pattern)))
    if (block.size() == 2)
      if (auto words = prove_sl2(diagonal_block(known, block), budget))
        return EllipticBlockProof{block, *std::move(words)};
  return std::nullopt;
}

namespace {

constexpr long largest_order = 1000;

// The orders of all elements of the group divide it (T_n: the orders of their eigenvalues).
std::optional<Integer> exponent_of(const GaloisGroup& g) {
  switch (g.type) {
  case GroupType::cyclic:
  case GroupType::T:
    return g.n;
  case GroupType::D:
    return g.n ? std::optional(lcm(Integer(2) * *g.n, Integer(4))) : std::nullopt;
  case GroupType::A4:
    return Integer(12);
  case GroupType::S4:
    return Integer(24);
  case GroupType::A5:
    return Integer(60);
  default:
    return std::nullopt;
  }
}

// y1'' + p y1' + q y1 = 0 for Y' = (a b; c d) Y with b != 0.
std::optional<Integer> order_of_two(const mo::DifferentialSystem& s, std::size_t i, std::size_t j,
                                    const Budget& budget) {
  const RationalFunction a = entry(s, i, i), b = entry(s, i, j), c = entry(s, j, i),
                         d = entry(s, j, j);
  const RationalFunction e = derivative(b) / b + d;
  const NormalForm equation = normal_form(-(a + e), -(derivative(a) + b * c - a * e));
  const auto factor =
      radical_order(logarithmic_parts(RationalFunction(Rational(-1, 2)) * equation.p, budget));
  if (!factor) return std::nullopt;
  Options options;
  options.budget = budget;
  options.want_solutions = false;
  const Decision decision = decide(equation, options);
  const auto exponent = decision.group ? exponent_of(*decision.group) : std::nullopt;
  return exponent ? std::optional(lcm(*factor, *exponent)) : std::nullopt;
}

std::optional<Integer> order_of_block(const mo::DifferentialSystem& s,
                                      const std::vector<std::size_t>& block, const Budget& budget) {
  if (block.size() == 1)
    return radical_order(logarithmic_parts(entry(s, block[0], block[0]), budget));
  return block.size() == 2 ? order_of_two(s, block[0], block[1], budget) : std::nullopt;
}

} // namespace

std::optional<long> eigenvalue_order(const mo::DifferentialSystem& s, const Budget& budget) {
  Integer n(1);
  for (const auto& block : diagonal_blocks(s)) {
    const auto order = order_of_block(s, block, budget);
    if (!order) return std::nullopt;
    n = lcm(n, *order);
  }
  if (Integer(largest_order) < n) return std::nullopt;
  return to_long(n);
}

std::optional<NonAbelianVariation> prove_non_abelian(const mo::DifferentialSystem& s,
                                                     const mo::Monodromy& m, const Budget& budget) {
  NonAbelianVariation proof;
  proof.unipotent = mo::prove_non_abelian(m, unipotent_elements(s, m, budget), budget);
  if (proof.unipotent) return proof;
  for (const auto& block : diagonal_blocks(s))
    if (block.size() == 2) {
      proof.block_proof = prove_sl2(diagonal_block(m, block), budget);
      proof.block = block;
      if (proof.block_proof) return proof;
    }
  const auto n = eigenvalue_order(s, budget);
  if (!n) return std::nullopt;
  proof.by_blocks = true;
  proof.unipotent = mo::prove_non_abelian(m, all_short_words(m, *n), budget);
  return proof.unipotent ? std::optional(std::move(proof)) : std::nullopt;
}

} // namespace kov
