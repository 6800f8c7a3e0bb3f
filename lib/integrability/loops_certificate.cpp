#include "integrability/loops_certificate.hpp"

#include "certify/loops/check.hpp"
#include "decide/decide.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "galois/exponential_form.hpp"
#include "integrability/variational_monodromy.hpp"
#include "monodromy/words.hpp"

#include <algorithm>
#include <map>

namespace kov {
namespace {

namespace mo = monodromy;
namespace ce = certify;

constexpr long first_bits = 192, most_bits = 4096, spare_bits = 64;
constexpr long grid_below = 6;

struct NoCertificate {
  std::string why;
};

// ---- polygons

Rational exact_value(const mo::Real& x) {
  Rational q;
  arf_get_fmpq(q.raw(), arb_midref(x.raw()));
  return q;
}

ce::LoopPoint exact_point(const mo::Point& p) { return {exact_value(p.x), exact_value(p.y)}; }

// Segments are at most half as long as their first point is away from the singularities.
class Polygons {
public:
  explicit Polygons(const mo::DifferentialSystem& s, const mo::Monodromy& m, const Budget& budget) {
    const auto places = mo::singular_points(s, mo::plan_bits, budget);
    for (const mo::SingularPoint& p : places)
      singularities_.push_back(mo::point(p.at));
    tree_ = mo::loops_of(places, m.base);
  }

  [[nodiscard]] ce::Polygon loop(std::size_t i) {
    const mo::Loop& l = tree_.loops.at(i);
    std::vector<mo::Point> there = vertices(l.approach), all = there;
    const std::vector<mo::Point> circle = vertices(l.circle);
    all.insert(all.end(), circle.begin() + 1, circle.end());
    all.insert(all.end(), there.rbegin() + 1, there.rend());
    points_ = {all.front()};
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
      walk_to(all[k + 1]);
    ce::Polygon out;
    for (const mo::Point& p : points_)
      out.push_back(exact_point(p));
    return out;
  }

private:
  static std::vector<mo::Point> vertices(const mo::Path& path) {
    std::vector<mo::Point> all{path.vertices.front()};
    for (std::size_t k = 0; k < path.joints.size(); ++k) {
      all.push_back(path.joints[k]);
      all.push_back(path.vertices[k + 1]);
    }
    return all;
  }

  [[nodiscard]] mo::Real distance(const mo::Point& p) const {
    std::optional<mo::Real> least;
    for (const mo::Point& s : singularities_) {
      const mo::Real d = abs(s - p);
      if (!least || d < *least) least = d;
    }
    return least.value();
  }

  void walk_to(const mo::Point& end) {
    const mo::Real half = mo::Real(1) / mo::Real(2);
    while (true) {
      const mo::Point here = points_.back();
      const mo::Real radius = distance(here), away = abs(end - here);
      if (!(half * radius < away)) break;
      const mo::Real part = max(half * radius, half * away); // no tiny rest
      const mo::Real step = min(part, mo::Real(11) / mo::Real(20) * radius);
      const mo::Point next = here + (step / away) * (end - here);
      points_.push_back(to_grid(next, exponent(distance(next)) - grid_below));
    }
    points_.push_back(end);
  }

  std::vector<mo::Point> singularities_;
  mo::LoopTree tree_;
  std::vector<mo::Point> points_;
};

// ---- what both certificates have

ce::LoopsCertificate begun(const std::string& title, const mo::DifferentialSystem& s) {
  if (!s.field->is_rational() && s.field->minpoly_coefficients() != std::vector<Integer>{1, 0, 1})
    throw NoCertificate{"certificates of matrices are over Q and Q(i)"};
  ce::LoopsCertificate c;
  c.title = title;
  c.field = s.field;
  for (const mo::Row& row : s.rows)
    c.rows.push_back({row.den, row.num});
  return c;
}

// Only the loops that a word has, numbered as they come.
class Loops {
public:
  Loops(const mo::DifferentialSystem& s, const mo::Monodromy& m, const Budget& budget)
      : polygons_(s, m, budget) {}

  [[nodiscard]] ce::LoopWord word(const mo::Word& w) {
    ce::LoopWord out;
    for (const std::size_t i : w) {
      const auto [it, is_new] = number_.emplace(i, all_.size());
      if (is_new) all_.push_back(polygons_.loop(i));
      out.push_back(it->second);
    }
    return out;
  }
  [[nodiscard]] const std::vector<ce::Polygon>& all() const { return all_; }

private:
  Polygons polygons_;
  std::map<std::size_t, std::size_t> number_;
  std::vector<ce::Polygon> all_;
};

// With as many bits as the judge needs, and some to spare for one that rounds otherwise.
std::string judged(ce::LoopsCertificate c, const Budget& budget) {
  std::string why;
  for (c.bits = first_bits; c.bits <= most_bits; c.bits *= 2) {
    budget.check();
    auto verdict = ce::check_loops(c);
    if (std::holds_alternative<ce::Accepted>(verdict)) {
      ce::LoopsCertificate generous = c;
      generous.bits += spare_bits;
      verdict = ce::check_loops(generous);
      if (std::holds_alternative<ce::Accepted>(verdict))
        return ce::write_loops_certificate(generous);
    }
    const auto& no = std::get<ce::Rejected>(verdict);
    why = no.step + ": " + no.why;
    if (no.limit || no.step == "L4") break; // more bits change nothing
  }
  throw NoCertificate{"the judge refuses it: " + why};
}

template <class F> LoopsProof made(F make) {
  try {
    return {make(), {}};
  } catch (const NoCertificate& no) {
    return {{}, no.why};
  } catch (const OutOfBudget& limit) {
    return {{}, limit.what()};
  }
}

// ---- blocks

std::vector<ce::RadicalFactor> radical_factors(const RationalFunction& f, const Budget& budget) {
  std::vector<ce::RadicalFactor> factors;
  for (const LogarithmicParts::Residue& x : logarithmic_parts(f, budget).residues) {
    if (degree(x.rho) > 0 || !is_rational(x.rho.coeff(0)))
      throw NoCertificate{"a residue is not rational"};
    factors.push_back({x.q, to_rational(x.rho.coeff(0))});
  }
  return factors;
}

ce::LoopBlock block_of_two(const mo::DifferentialSystem& s, std::vector<std::size_t> unknowns,
                           const Budget& budget) {
  const RationalFunction a = entry(s, unknowns[0], unknowns[0]),
                         b = entry(s, unknowns[0], unknowns[1]),
                         c = entry(s, unknowns[1], unknowns[0]);
  const RationalFunction e = derivative(b) / b + entry(s, unknowns[1], unknowns[1]);
  const NormalForm equation = normal_form(-(a + e), -(derivative(a) + b * c - a * e));
  Options options;
  options.budget = budget;
  options.want_solutions = false;
  options.want_certificate = true;
  const Decision decision = decide(equation, options);
  if (decision.certificate.empty())
    throw NoCertificate{"there is no certificate of a block: " + decision.no_certificate};
  return {std::move(unknowns),
          radical_factors(RationalFunction(Rational(-1, 2)) * equation.p, budget),
          ce::read_certificate(decision.certificate)};
}

// In an order such that rows use unknowns of their own and earlier blocks only.
std::vector<ce::LoopBlock> blocks_of(const mo::DifferentialSystem& s, const Budget& budget) {
  auto left = diagonal_blocks(s);
  std::vector<std::size_t> seen;
  std::vector<ce::LoopBlock> out;
  while (!left.empty()) {
    const auto is_next = [&](const std::vector<std::size_t>& block) {
      return std::ranges::all_of(block, [&](std::size_t i) {
        for (std::size_t j = 0; j < s.rows.size(); ++j)
          if (!is_zero(s.rows[i].num[j]) && !is_among(j, block) && !is_among(j, seen)) return false;
        return true;
      });
    };
    const auto it = std::ranges::find_if(left, is_next);
    if (it == left.end() || it->size() > 2) throw NoCertificate{"a block is larger than 2"};
    seen.insert(seen.end(), it->begin(), it->end());
    if (it->size() == 1)
      out.push_back({*it, radical_factors(entry(s, it->front(), it->front()), budget), {}});
    else
      out.push_back(block_of_two(s, *it, budget));
    left.erase(it);
  }
  return out;
}

mo::NonAbelianProof two_words(const mo::DifferentialSystem& s, const mo::Monodromy& m,
                              const Budget& budget) {
  const auto n = eigenvalue_order(s, budget);
  if (!n) throw NoCertificate{"the blocks do not make powers unipotent"};
  const auto words = all_short_words(m, *n);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      budget.check();
      if (auto proof = checked(m, words[j], words[i])) return *std::move(proof);
    }
  throw NoCertificate{"no two short words are seen not to commute"};
}

// A diagonal block by itself.
mo::DifferentialSystem part(const mo::DifferentialSystem& s,
                            const std::vector<std::size_t>& unknowns) {
  std::vector<std::vector<RationalFunction>> a;
  for (const std::size_t i : unknowns) {
    a.emplace_back();
    for (const std::size_t j : unknowns)
      a.back().push_back(entry(s, i, j));
  }
  return mo::make_system(a);
}

} // namespace

LoopsProof sl2_certificate(const std::string& title, const mo::DifferentialSystem& s,
                           const mo::Monodromy& m, const Budget& budget) {
  return made([&] {
    ce::LoopsCertificate c = begun(title, s);
    const auto proof = prove_no_small_group(m, budget);
    if (!proof) throw NoCertificate{"the matrices do not prove it"};
    Loops loops(s, m, budget);
    ce::ShowsSl2 shows;
    shows.a = loops.word(proof->a);
    shows.b = loops.word(proof->b);
    shows.c = loops.word(proof->c);
    c.shows = shows;
    c.loops = loops.all();
    return judged(std::move(c), budget);
  });
}

LoopsProof not_abelian_certificate(const NonAbelianVariation& known, const std::string& title,
                                   const mo::DifferentialSystem& s, const mo::Monodromy& m,
                                   const Budget& budget) {
  if (known.block_proof)
    return sl2_certificate("a diagonal block of " + title, part(s, known.block),
                           mo::diagonal_block(m, known.block), budget);
  return made([&] {
    ce::LoopsCertificate c = begun(title, s);
    const mo::NonAbelianProof proof = two_words(s, m, budget);
    Loops loops(s, m, budget);
    ce::ShowsNotAbelian shows;
    shows.a = {loops.word(proof.a.loops.value()), proof.a.power};
    shows.b = {loops.word(proof.b.loops.value()), proof.b.power};
    shows.row = proof.row;
    shows.column = proof.column;
    shows.blocks = blocks_of(s, budget);
    c.shows = std::move(shows);
    c.loops = loops.all();
    return judged(std::move(c), budget);
  });
}

} // namespace kov
