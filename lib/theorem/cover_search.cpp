#include "theorem/cover_search.hpp"

#include "exact/truth.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr int most_depth = 40, cover_proof_depth = 2;

class CoverSearch {
public:
  CoverSearch(Ring ring, const std::vector<CoverPiece>& pieces, const Budget& budget)
      : ring_(std::move(ring)), pieces_(pieces), budget_(budget) {
    for (const CoverPiece& p : pieces_) {
      atoms_of_.emplace_back();
      for (const Condition& c : p.region) {
        const auto at = std::ranges::find(atoms_, c);
        atoms_of_.back().push_back(static_cast<std::size_t>(at - atoms_.begin()));
        if (at == atoms_.end()) atoms_.push_back(c);
      }
    }
  }

  std::optional<Json> run(const std::vector<Condition>& assumed) {
    return node(assumed, std::vector<Truth>(atoms_.size(), Truth::unknown), most_depth);
  }

private:
  using Known = std::vector<Truth>;

  std::optional<Json> node(const std::vector<Condition>& given, Known known, int depth) {
    budget_.check();
    const RealFacts facts(ring_, given, factorizations_);
    if (auto end = facts.contradiction()) return end;
    if (depth == 0) return std::nullopt;
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      if (known[i] == Truth::unknown) known[i] = look(given, facts, atoms_[i]);
    const std::size_t best = choose(known);
    if (best == pieces_.size()) return std::nullopt; // a gap, as far as this goes
    const auto open = std::ranges::find_if(
        atoms_of_[best], [&](std::size_t i) { return known[i] == Truth::unknown; });
    if (open == atoms_of_[best].end()) return leaf(given, pieces_[best]);
    return split(given, known, atoms_[*open], depth);
  }

  // Quick: by what follows without a case distinction.
  [[nodiscard]] Truth look(const std::vector<Condition>& given, const RealFacts& facts,
                           const Condition& c) const {
    const MPoly rest = facts.reduced(c.p).rest;
    if (is_zero(rest))
      return c.sign == Sign::zero || c.sign == Sign::nonnegative ? Truth::yes : Truth::no;
    if (follows(given, c)) return Truth::yes;
    return follows(given, negation(c)) ? Truth::no : Truth::unknown;
  }
  [[nodiscard]] bool follows(std::vector<Condition> given, const Condition& c) const {
    given.push_back(negation(c));
    return RealFacts(ring_, std::move(given), factorizations_).contradiction().has_value();
  }

  // The piece that is not excluded and lacks least.
  [[nodiscard]] std::size_t choose(const Known& known) const {
    std::size_t best = pieces_.size(), least = 0;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      std::size_t unknown = 0;
      bool excluded = false;
      for (const std::size_t i : atoms_of_[k]) {
        unknown += known[i] == Truth::unknown ? 1 : 0;
        excluded = excluded || known[i] == Truth::no;
      }
      if (excluded || (best != pieces_.size() && unknown >= least)) continue;
      best = k;
      least = unknown;
    }
    return best;
  }

  std::optional<Json> leaf(const std::vector<Condition>& given, const CoverPiece& piece) const {
    std::vector<Json> word, proofs;
    for (const std::size_t i : piece.word)
      word.push_back(json_text(std::to_string(i)));
    for (const Condition& c : piece.region) {
      auto proof = shown(ring_, given, c, cover_proof_depth, budget_, factorizations_);
      if (!proof) return std::nullopt;
      proofs.push_back(*std::move(proof));
    }
    return Json{Json::Object{{"node", json_text("part")},
                             {"part", json_text(std::to_string(piece.part))},
                             {"word", json_list(std::move(word))},
                             {"shown", json_list(std::move(proofs))}}};
  }

  // p = 0 or not; by sign if some region asks for the sign.
  [[nodiscard]] RealFacts::Split split_for(const std::vector<Condition>& given,
                                           const Condition& c) const {
    auto with = given;
    with.push_back(negation(c));
    const auto splits = RealFacts(ring_, with, factorizations_).splits();
    if (c.sign == Sign::positive && c.p.length() > 1)
      for (const RealFacts::Split& s : splits)
        if (!s.ordered && s.p.length() < c.p.length()) return s;
    const bool ordered = std::ranges::any_of(atoms_, [&](const Condition& a) {
      return certify::is_ordered(a.sign) && (a.p == c.p || a.p == -c.p);
    });
    return {c.p, ordered};
  }

  std::optional<Json> split(const std::vector<Condition>& given, const Known& known,
                            const Condition& c, int depth) {
    const RealFacts::Split s = split_for(given, c);
    const auto branch = [&](const MPoly& p, Sign sign) {
      auto more = given;
      more.push_back({p, sign});
      return node(more, known, depth - 1);
    };
    auto zero = branch(s.p, Sign::zero);
    if (!zero) return std::nullopt;
    if (!s.ordered) {
      auto nonzero = branch(s.p, Sign::nonzero);
      if (!nonzero) return std::nullopt;
      return json_zero_node(s.p, *std::move(nonzero), *std::move(zero));
    }
    auto positive = branch(s.p, Sign::positive);
    if (!positive) return std::nullopt;
    auto negative = branch(-s.p, Sign::positive);
    if (!negative) return std::nullopt;
    return json_sign_node(s.p, *std::move(positive), *std::move(zero), *std::move(negative));
  }

  Ring ring_;
  const std::vector<CoverPiece>& pieces_;
  const Budget& budget_;
  SharedFactorizations factorizations_ = std::make_shared<Factorizations>();
  std::vector<Condition> atoms_;
  std::vector<std::vector<std::size_t>> atoms_of_; ///< of each piece
};

} // namespace

std::optional<Json> cover_tree(const Ring& ring, const std::vector<Condition>& assumed,
                               const std::vector<CoverPiece>& pieces, const Budget& budget) {
  return CoverSearch(ring, pieces, budget).run(assumed);
}

} // namespace kov
