// Sets of parameters that a change of variables takes into others.
//
// Source  docs/theory/moves.md (1, 2)

#include "classify/board.hpp"
#include "classify/shares.hpp"
#include "exact/lists.hpp"
#include "exact/share.hpp"
#include "exact/tried.hpp"
#include "integrability/parameters.hpp"

#include <algorithm>
#include <utility>

namespace kov {
namespace {

// All of its points are taken into `target`.
bool is_taken_into(const Undecided& piece, const Equivalence& e, const Set& target) {
  const auto holds_for = [&](const std::vector<MPoly>& all, const auto& condition) {
    return std::ranges::all_of(all, [&](const MPoly& f) {
      const auto here = pulled_back(e, f);
      return here && condition(*here);
    });
  };
  return holds_for(target.equations(), [&](const MPoly& f) { return piece.where.vanishes(f); }) &&
         holds_for(target.inequations(), [&](const MPoly& f) { return piece.where.is_nonzero(f); });
}

bool lies_in(const Set& set, const Set& larger) {
  const auto& equations = larger.equations();
  const auto& inequations = larger.inequations();
  return std::ranges::all_of(equations, [&](const MPoly& f) { return set.vanishes(f); }) &&
         std::ranges::all_of(inequations, [&](const MPoly& f) { return set.is_nonzero(f); });
}

bool may_meet(const Set& set, const Set& target) {
  const auto equations = target.equations();
  return std::ranges::all_of(equations, [&](const MPoly& f) { return set.vanishes(f); });
}

// A set that follows one that follows it, in parts, is studied after all.
void study_or_leave_open(Board& b, const Follower& follower, Undecided piece) {
  auto next = follower.by.root ? std::nullopt : in_solved_parameters(Round{b.known, piece}, piece);
  if (next) {
    b.symmetries.clear();
    b.waiting.push_back(*std::move(next));
  } else {
    b.open.push_back(std::move(piece));
  }
}

/// Carries what is known of the set that is followed over to the parts of the one that follows.
class Settling {
public:
  Settling(Board& b, const Follower& follower, const MayVanish& possible)
      : b_(b), follower_(follower), possible_(possible),
        budget_(part_of_the_work(b.budget(), share::follower)), left_{follower.piece} {}

  void run() {
    take_strata();
    meet_conditions();
    take_strata(); // at common values
    take_open();
    for (Undecided& piece : left_)
      if (!is_empty(piece)) study_or_leave_open(b_, follower_, std::move(piece));
  }

private:
  // A rotation with r^2 = f says nothing where f = 0.  Over the reals that set may be empty.
  [[nodiscard]] bool is_empty(const Undecided& piece) {
    return tried<OutOfBudget>([&] { return has_no_real_point(b_, piece.where); });
  }
  template <class Use> void take(const ClassifiedStratum& x, const Use& use) {
    if (left_.empty() || budget_.is_spent()) return;
    tried<OutOfBudget>([&] { // at a limit nothing is carried
      if (!may_meet(x.where, follower_.of)) return;
      const auto here = carried(b_.known.system, follower_.by, x);
      if (!here) return;
      auto rest = left_;
      auto parts = cut(rest, *here, possible_, budget_);
      left_ = std::move(rest);
      for (Undecided& part : parts)
        use(std::move(part), *here);
    });
  }
  void take_strata() {
    const std::vector<ClassifiedStratum> known = b_.result.strata;
    for (const ClassifiedStratum& x : known)
      take(x, [&](Undecided part, const Preimage& here) {
        ClassifiedStratum y = here.stratum;
        y.where = std::move(part.where);
        b_.result.strata.push_back(std::move(y));
      });
  }
  void meet_conditions() {
    std::vector<Undecided> parts;
    for (const Undecided& piece : left_)
      std::ranges::move(met(b_, Round{b_.known, piece}, piece), std::back_inserter(parts));
    left_ = std::move(parts);
  }
  void take_open() {
    const std::vector<Undecided> open = b_.open;
    for (const Undecided& piece : open)
      take({.where = piece.where}, [&](Undecided part, const Preimage& /*here*/) {
        note(part, in_words(follower_.by), "the set that this one becomes is open");
        b_.open.push_back(std::move(part));
      });
  }

  Board& b_;
  const Follower& follower_;
  const MayVanish& possible_;
  Budget budget_;
  std::vector<Undecided> left_;
};

} // namespace

bool has_no_real_point(Board& b, const Set& where) {
  std::vector<Condition> all;
  for (const MPoly& f : where.equations())
    all.push_back({f, Sign::zero});
  for (const MPoly& f : where.inequations())
    all.push_back({f, Sign::nonzero});
  const auto proof = refuted_over_the_reals(b.known.system, all);
  if (proof) add_each_once(b.result.trusted, *proof);
  return proof.has_value();
}

bool is_ruled_out_by_an_order(Board& b, const Set& where) {
  const auto& assumed = b.known.system.assumptions;
  const bool ordered = std::ranges::any_of(assumed, [](const Assumption& a) {
    return a.is_ordered() && used_variables(a.value).size() > 1;
  });
  return ordered && !where.equations().empty() && has_no_real_point(b, where);
}

std::vector<Undecided> cut(std::vector<Undecided>& pieces, const Cut& x, const MayVanish& possible,
                           const Budget& budget) {
  std::vector<Undecided> inside, left;
  const auto put = [](std::vector<Set> sets, const Undecided& piece, std::vector<Undecided>& all) {
    for (Set& set : sets)
      all.push_back(piece.on(std::move(set)));
  };
  for (const Undecided& piece : pieces) {
    budget.check();
    // where something vanishes the equations need not cut
    CutParts nonzero = split(piece.where, {.not_all_zero = x.not_all_zero}, possible);
    put(std::move(nonzero.outside), piece, left);
    for (const Set& set : nonzero.inside) {
      CutParts zero = split(set, {.zero = x.zero, .statements = x.statements}, possible);
      put(std::move(zero.inside), piece, inside);
      put(std::move(zero.outside), piece, left);
    }
  }
  pieces = std::move(left);
  return inside;
}

namespace {

std::optional<Follower> follower_of_some(const Board& b, const Undecided& piece) {
  const std::size_t equations = piece.where.equations().size();
  for (const Set& target : b.studied) {
    if (target.equations().size() != equations || lies_in(piece.where, target)) continue;
    for (const Equivalence& e : b.symmetries)
      if (is_taken_into(piece, e, target) && holds(b.known.system, e))
        return Follower{piece, target, e};
  }
  return std::nullopt;
}

} // namespace

bool follows_another(Board& b, const Undecided& piece) {
  if (!piece.where.is_algebraic() || b.symmetries.empty()) return false;
  // too hard to tell: it is studied
  auto follower = tried<OutOfBudget>([&] { return follower_of_some(b, piece); });
  if (follower)
    b.followers.push_back(*std::move(follower));
  else
    b.studied.push_back(piece.where);
  return follower.has_value();
}

// The later ones first: an earlier one may follow a set of which they are parts.
void settle_followers(Board& b) {
  auto all = std::exchange(b.followers, {});
  const MayVanish possible = may_vanish(b.known.system);
  for (auto follower = all.rbegin(); follower != all.rend(); ++follower)
    Settling(b, *follower, possible).run();
}

} // namespace kov
