#include "kovacic/families.hpp"

#include "exact/error.hpp"

#include <algorithm>
#include <numeric>

namespace kov::kovacic {
namespace {

// A partial sum: the coordinates of an element of K over Q, times one common denominator.
// Coordinate 0 is the rational part.
using Sum = std::vector<Integer>;

Sum operator+(Sum a, const Sum& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] += b[i];
  return a;
}

Sum operator-(Sum a, const Sum& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
  return a;
}

struct Reached {
  Sum sum;
  Integer count; // how many partial families have this sum
};

bool by_sum(const Reached& a, const Reached& b) { return a.sum < b.sum; }

[[noreturn]] void too_many(const std::string& what, const Budget& budget) {
  throw OutOfBudget("family limit: " + what + ", the limit is " +
                    std::to_string(budget.max_families));
}

// Half of the places, with all sums that the first i of them can reach.
class Half {
public:
  explicit Half(std::size_t dimension) { layers_.push_back({{Sum(dimension), Integer(1)}}); }

  void add(std::size_t place, const std::vector<Sum>& options, const Budget& budget) {
    std::vector<Reached> next;
    for (const Sum& option : options) {
      budget.check();
      for (const Reached& r : layers_.back())
        next.push_back({r.sum + option, r.count});
    }
    std::ranges::sort(next, by_sum);
    std::vector<Reached> merged;
    for (Reached& r : next) {
      if (!merged.empty() && merged.back().sum == r.sum)
        merged.back().count += r.count;
      else
        merged.push_back(std::move(r));
    }
    if (merged.size() > static_cast<std::size_t>(std::max(1L, budget.max_families)))
      too_many(std::to_string(merged.size()) + " different partial sums of exponents", budget);
    layers_.push_back(std::move(merged));
    places_.push_back({place, options});
  }

  [[nodiscard]] const std::vector<Reached>& reached() const { return layers_.back(); }

  // All partial families with the given sum, as (place, choice) entries written into `choice`.
  template <class F> void each(const Sum& sum, std::vector<std::size_t>& choice, F&& f) const {
    descend(places_.size(), sum, choice, f);
  }

private:
  struct Entry {
    std::size_t place;
    std::vector<Sum> options;
  };

  template <class F>
  void descend(std::size_t i, const Sum& sum, std::vector<std::size_t>& choice, F& f) const {
    const auto at = std::ranges::lower_bound(layers_[i], Reached{sum, {}}, by_sum);
    if (at == layers_[i].end() || at->sum != sum) return;
    if (i == 0) return f();
    const Entry& entry = places_[i - 1];
    for (std::size_t j = 0; j < entry.options.size(); ++j) {
      choice[entry.place] = j;
      descend(i - 1, sum - entry.options[j], choice, f);
    }
  }

  std::vector<std::vector<Reached>> layers_;
  std::vector<Entry> places_;
};

// The rational part modulo the denominator, then the irrational coordinates: two halves fit
// together when these add up to zero.
Sum residue(const Sum& sum, const Integer& den) {
  Sum key = sum;
  if (!key.empty()) key[0] = key[0] - floor_div(key[0], den) * den;
  return key;
}

Sum opposite(const Sum& sum, const Integer& den) {
  Sum negative(sum.size());
  for (std::size_t i = 0; i < sum.size(); ++i)
    negative[i] = -sum[i];
  return residue(negative, den);
}

struct MatchedHalves {
  const Sum* left;
  const Sum* right;
  Integer degree;
};

std::vector<MatchedHalves> meet(const Half& left, const Half& right, const Integer& den,
                                const Budget& budget) {
  std::vector<std::pair<Sum, const Reached*>> keys;
  for (const Reached& r : right.reached())
    keys.emplace_back(residue(r.sum, den), &r);
  const auto by_key = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::ranges::sort(keys, by_key);
  std::vector<MatchedHalves> found;
  Integer families(0);
  for (const Reached& l : left.reached()) {
    budget.check();
    const std::pair<Sum, const Reached*> wanted{opposite(l.sum, den), nullptr};
    for (auto [at, end] = std::equal_range(keys.begin(), keys.end(), wanted, by_key); at != end;
         ++at) {
      const Integer scaled = l.sum[0] + at->second->sum[0];
      if (sign(scaled) < 0) continue;
      found.push_back({&l.sum, &at->second->sum, exact_div(scaled, den)});
      families += l.count * at->second->count;
      if (families > Integer(budget.max_families))
        too_many("more than " + std::to_string(budget.max_families) +
                     " families have a natural number as degree",
                 budget);
    }
  }
  std::ranges::sort(found, [](const MatchedHalves& a, const MatchedHalves& b) {
    if (a.degree != b.degree) return a.degree < b.degree;
    return std::tie(*a.left, *a.right) < std::tie(*b.left, *b.right);
  });
  return found;
}

// The contributions as integer vectors over one denominator.
std::vector<std::vector<Sum>> scaled(const std::vector<std::vector<NfElem>>& contributions,
                                     Integer& den, std::size_t& dimension) {
  den = Integer(1);
  dimension = 1;
  for (const auto& place : contributions)
    for (const NfElem& c : place) {
      dimension = std::max(dimension, static_cast<std::size_t>(c.field()->degree()));
      den = lcm(den, Integer(fmpq_poly_denref(c.raw())));
    }
  std::vector<std::vector<Sum>> all;
  for (const auto& place : contributions) {
    auto& options = all.emplace_back();
    for (const NfElem& c : place) {
      Sum& sum = options.emplace_back(dimension);
      for (std::size_t i = 0; i < dimension; ++i)
        sum[i] = (c.coeff(static_cast<long>(i)) * Rational(den)).num();
    }
  }
  return all;
}

} // namespace

void Families::require_all(const Budget& budget) const {
  if (left_out)
    throw OutOfBudget("degree limit: a polynomial of degree " + to_string(*left_out) +
                      " would be needed, the limit is " + std::to_string(budget.max_degree));
}

Families admissible_families(const std::vector<std::vector<NfElem>>& contributions,
                             const Budget& budget) {
  Families result;
  result.total = Integer(1);
  for (const auto& place : contributions)
    result.total *= Integer(place.size());
  if (is_zero(result.total)) return result;
  Integer den;
  std::size_t dimension = 1;
  const auto options = scaled(contributions, den, dimension);
  // places with equal options side by side, so that their sums merge
  std::vector<std::size_t> order(options.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order,
                           [&](std::size_t a, std::size_t b) { return options[a] < options[b]; });
  Half left(dimension);
  Half right(dimension);
  std::size_t from = 0;
  std::size_t to = order.size();
  while (from < to) {
    if (left.reached().size() <= right.reached().size()) {
      left.add(order[from], options[order[from]], budget);
      ++from;
    } else {
      --to;
      right.add(order[to], options[order[to]], budget);
    }
  }
  for (const MatchedHalves& match : meet(left, right, den, budget)) {
    budget.check();
    if (!fits_long(match.degree) || to_long(match.degree) > budget.max_degree) {
      result.left_out = match.degree;
      break;
    }
    Family family{std::vector<std::size_t>(options.size()), to_long(match.degree)};
    left.each(*match.left, family.choice, [&] {
      right.each(*match.right, family.choice, [&] { result.admissible.push_back(family); });
    });
  }
  return result;
}

} // namespace kov::kovacic
