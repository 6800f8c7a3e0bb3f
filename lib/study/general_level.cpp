#include "study/general_level.hpp"
#include "exact/lists.hpp"
#include "exact/variables.hpp"

#include <algorithm>

namespace kov {
namespace {

/// Decides whether one statement holds for no general level, and what it says otherwise.
class AtSomeLevel {
public:
  explicit AtSomeLevel(const std::vector<std::size_t>& levels) : levels_(levels) {}

  [[nodiscard]] bool never() const { return never_; }
  [[nodiscard]] const std::vector<MFraction>& changing() const { return changing_; }

  Assertion operator()(const AllRational& s) { return all_in_a_countable_set(s); }
  Assertion operator()(const InRow& s) { return all_in_a_countable_set(s); }
  Assertion operator()(const Separated& s) { return all_in_a_countable_set(s); }
  Assertion operator()(const LameIsFinite& s) { return s; }
  Assertion operator()(const SeparatedPair& s) { // the others may change together
    never_ = changes(s.squares.front());
    if (never_) changing_.push_back(s.squares.front());
    return s;
  }

  Assertion operator()(const SomeIn& s) {
    SomeIn left = s;
    left.squares.clear();
    for (const MFraction& x : s.squares)
      (changes(x) ? changing_ : left.squares).push_back(x);
    left.or_all_rational = s.or_all_rational && left.squares.size() == s.squares.size();
    never_ = left.squares.size() < s.count;
    return left;
  }

  // Keeps only the sums x1 +- x2 +- ... that do not depend on the level.
  Assertion operator()(const SumIn& s) {
    if (std::ranges::none_of(s.squares, [&](const MFraction& x) { return changes(x); })) return s;
    const auto all = sums(s.squares);
    if (!all) return s;
    Squares left;
    for (const MFraction& x : *all)
      if (!changes(x)) left.push_back(x * x);
    if (left.size() > 1) return s;
    for (const MFraction& x : *all)
      if (changes(x)) changing_.push_back(x);
    never_ = left.empty();
    return left.empty() ? s : SumIn{left, s.classes};
  }

  // An integer does not change, and the other two change by the same or by opposite numbers.
  Assertion operator()(const WithoutLogarithm& s) {
    Squares moving, fixed;
    for (const MFraction& x : s.squares)
      (changes(x) ? moving : fixed).push_back(x);
    if (moving.empty()) return s;
    if (moving.size() != 2) { // a sum with a number that does not change changes
      never_ = true;
      changing_ = moving;
      return s;
    }
    const auto both = sums(moving);
    if (!both) return s;
    changing_ = moving;
    for (const MFraction& x : *both)
      if (!changes(x)) return Separated{{fixed.front(), x * x}};
    never_ = true;
    changing_.insert(changing_.end(), both->begin(), both->end());
    return s;
  }

private:
  [[nodiscard]] bool changes(const MFraction& x) const { return uses_any(x, levels_); }
  template <class S> Assertion all_in_a_countable_set(const S& s) {
    const auto moving =
        std::ranges::find_if(s.squares, [&](const MFraction& x) { return changes(x); });
    if (moving != s.squares.end()) {
      never_ = true;
      changing_.push_back(*moving);
    }
    return s;
  }
  // x1 +- x2 +- ..., each up to sign; unset: a number is not a function of parameters and levels.
  static std::optional<std::vector<MFraction>> sums(const Squares& squares) {
    std::vector<MFraction> all;
    for (const MFraction& square : squares) {
      const auto root = square_root(square);
      if (!root) return std::nullopt;
      if (all.empty()) {
        all.push_back(*root);
        continue;
      }
      std::vector<MFraction> more;
      for (const MFraction& x : all)
        for (const MFraction& y : {x + *root, x - *root})
          more.push_back(y);
      all = std::move(more);
    }
    return all;
  }

  const std::vector<std::size_t>& levels_;
  bool never_ = false;
  std::vector<MFraction> changing_;
};

} // namespace

AtGeneralLevel at_general_level(std::vector<std::vector<Statement>> parts,
                                const std::vector<std::size_t>& levels) {
  AtGeneralLevel all;
  const auto need = [&](const std::vector<MFraction>& changing) {
    for (const MFraction& x : changing)
      add_once(all.changing, x);
  };
  for (auto& part : parts) {
    std::vector<Statement> left;
    bool never = false;
    for (const Statement& c : part) {
      if (!c.holds) continue; // that more may hold is not a mistake
      AtSomeLevel s(levels);
      left.push_back({std::visit(s, c.says), true});
      need(s.changing());
      if ((never = s.never())) break;
    }
    if (!never) all.parts.push_back(std::move(left));
  }
  return all;
}

} // namespace kov
