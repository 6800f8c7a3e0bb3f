#include "strata/leaf_certificate.hpp"

#include "exact/error.hpp"
#include "exact/modular.hpp"
#include "strata/bounds.hpp"
#include "strata/irrational.hpp"

#include <algorithm>
#include <set>

namespace kov::strata {

using certify::Json;

Json number_certificate(const Decision& d) {
  if (d.certificate.empty())
    throw NoProof(d.no_certificate.empty() ? "no certificate was asked for" : d.no_certificate);
  return certify::parse_json(d.certificate);
}

namespace {

Json text(const std::string& s) { return Json{s}; }
Json text(const MPoly& p) { return Json{to_string(p)}; }
Json text(long n) { return Json{std::to_string(n)}; }

// The polynomials chi_i of the format: chi without denominators.
std::vector<MPoly> cleared(const std::vector<MFraction>& chi, const Ring& ring) {
  MPoly common(ring, Integer(1));
  for (const auto& c : chi)
    if (!is_zero(c)) common = common * exact_div(c.den(), gcd(common, c.den()));
  std::vector<MPoly> all;
  all.reserve(chi.size());
  for (const auto& c : chi)
    all.push_back(is_zero(c) ? MPoly(ring) : (c * MFraction(common)).num());
  for (std::size_t i = 0; i < chi.size(); ++i) // num() keeps no integer denominator
    KOV_ENSURE(MFraction(all[i]) == chi[i] * MFraction(common));
  return all;
}

// A place as the judge will see it.
struct CertifiedPlace {
  const ParametricPlace* place;
  Json::Object json;
  std::vector<MPoly> chi;
  bool open = false;
};

class LeafWriter {
public:
  LeafWriter(const MFraction& r, std::size_t z, const Region& region, KnownFacts& facts,
             std::vector<Lemma>& lemmas, const Budget& budget)
      : r_(r), z_(z), region_(region), facts_(facts), lemmas_(lemmas), budget_(budget) {
    auto found = scheme(r, z, region, budget);
    if (!std::holds_alternative<Scheme>(found)) throw NoProof("the places are not known");
    s_ = std::get<Scheme>(std::move(found));
  }

  Json invariant(const ParametricInvariant& v) {
    leading_coefficients();
    const auto c = coefficients(v.p, z_);
    if (std::none_of(c.begin(), c.end(),
                     [&](const MPoly& f) { return facts_.ensure_nonzero(f, lemmas_); }))
      throw NoProof("the invariant may vanish");
    Json::Array places;
    for (std::size_t i = 0; i < s_.finite.size(); ++i)
      places.push_back(Json{Json::Object{{"q", text(s_.finite[i].q)},
                                         {"order", text(s_.finite[i].order)},
                                         {"e", text(v.form.e[i])}}});
    return leaf("yes", "invariant",
                {{"content", text(content())},
                 {"places", Json{std::move(places)}},
                 {"m", text(v.form.m)},
                 {"p", text(v.p)}});
  }

  Json not_abelian() {
    leading_coefficients();
    separate_places();
    for (auto& p : s_.finite)
      places_.push_back({&p, {{"q", text(p.q)}, {"order", text(p.order)}}, {}});
    places_.push_back({&s_.infinity, {}, {}});
    for (auto& p : places_)
      describe(p);
    const std::string by = theorem();
    Json::Array finite;
    for (std::size_t i = 0; i + 1 < places_.size(); ++i)
      finite.push_back(Json{std::move(places_[i].json)});
    Json::Object data{{"content", text(content())},
                      {"places", Json{std::move(finite)}},
                      {"infinity", Json{std::move(places_.back().json)}}};
    if (!absent_.empty()) data.emplace_back("absent", Json{std::move(absent_)});
    return leaf("no", by, std::move(data));
  }

private:
  static Json leaf(const char* abelian, const std::string& by, Json::Object data) {
    Json::Object o{{"node", text("leaf")}, {"abelian", text(abelian)}, {"by", text(by)}};
    std::move(data.begin(), data.end(), std::back_inserter(o));
    return Json{std::move(o)};
  }

  void need(const MPoly& p, const char* what) {
    if (!facts_.ensure_nonzero(p, lemmas_))
      throw NoProof(std::string(what) + ": " + brief(MFraction(p), 120) +
                    " != 0 has no exact proof");
  }

  [[nodiscard]] MPoly content() const {
    MPoly den = r_.den();
    for (const auto& p : s_.finite)
      den = exact_div(den, pow(p.q, static_cast<unsigned long>(p.order)));
    return den;
  }
  void leading_coefficients() {
    need(content(), "the content of the denominator");
    for (const auto& p : s_.finite)
      need(coefficients(p.q, z_).back(), "a leading coefficient");
  }
  void separate_places() {
    for (std::size_t i = 0; i < s_.finite.size(); ++i) {
      const MPoly& q = s_.finite[i].q;
      if (degree(q, z_) > 1) need(resultant(q, derivative(q, z_), z_), "a discriminant");
      for (std::size_t j = 0; j < i; ++j)
        need(resultant(q, s_.finite[j].q, z_), "a resultant");
      if (s_.finite[i].order != 2) need(resultant(q, r_.num(), z_), "the order of a pole");
    }
    const long o = s_.infinity.order;
    if (o == 1 || o >= 3) need(coefficients(r_.num(), z_).back(), "the order at infinity");
  }

  // chi, irrational, log; places whose logarithms the format does not show count as unknown.
  void describe(CertifiedPlace& p) {
    auto& place = const_cast<ParametricPlace&>(*p.place); // of s_
    if (place.kind != PlaceKind::regular) return;
    p.chi = cleared(place.chi, r_.ring());
    Json::Array chi;
    for (const auto& c : p.chi)
      chi.push_back(text(c));
    p.json.emplace_back("chi", Json{std::move(chi)});
    need(p.chi.back(), "chi");
    if (place.exponent == ExponentKind::irrational)
      p.json.emplace_back("irrational", text(irrational(p.chi)));
    p.open = place.exponent == ExponentKind::open;
    if (place.exponent != ExponentKind::rational || place.log != Truth::yes ||
        place.delta == Rational(0))
      return;
    const auto defect = place.degree(z_) == 1 ? log_norm(place) : std::nullopt;
    if (defect && facts_.ensure_nonzero(*defect, lemmas_))
      p.json.emplace_back("log", Json{true});
    else
      place.log = Truth::unknown;
  }
  [[nodiscard]] std::optional<MPoly> log_norm(const ParametricPlace& p) const {
    return logarithm_defect(r_, z_, p, region_);
  }

  std::string irrational(const std::vector<MPoly>& chi) {
    if (chi.size() == 2 && (is_zero(chi[0]) || is_constant(MFraction(chi[0], chi[1]))))
      return "constant";
    for (const bool negative : {false, true})
      if (std::all_of(chi.begin(), chi.end(), [&](const MPoly& c) {
            return facts_.ensure_positive(negative ? -c : c, lemmas_);
          }))
        return "positive";
    if (chi.size() == 3) {
      const MPoly four(r_.ring(), Integer(4));
      if (std::all_of(chi.begin(), chi.end(), [&](const MPoly& c) { return facts_.is_real(c); }) &&
          facts_.ensure_positive(four * chi[2] * chi[0] - chi[1] * chi[1], lemmas_))
        return "discriminant";
    }
    throw NoProof("that an exponent is irrational has no exact proof");
  }

  [[nodiscard]] bool has_torus() const {
    return std::any_of(places_.begin(), places_.end(), [](const CertifiedPlace& p) {
      return p.place->kind == PlaceKind::irregular || p.place->kind == PlaceKind::ramified ||
             (p.place->kind == PlaceKind::regular && p.place->exponent == ExponentKind::irrational);
    });
  }
  [[nodiscard]] bool has_log() const {
    return std::any_of(places_.begin(), places_.end(), [](const CertifiedPlace& p) {
      return p.place->kind == PlaceKind::simple ||
             (p.place->kind == PlaceKind::regular && p.place->exponent == ExponentKind::rational &&
              p.place->log == Truth::yes);
    });
  }

  // B with Delta^2 <= B, written to the place.
  void bound(CertifiedPlace& p) {
    const auto b = p.place->chi.size() == 2 ? bound_of_square(*p.place, region_) : std::nullopt;
    if (b) {
      const MPoly den(r_.ring(), b->den());
      const MPoly room = (MPoly(r_.ring(), b->num()) * p.chi[1] + den * p.chi[0]) * p.chi[1];
      if (is_zero(room) || facts_.ensure_positive(room, lemmas_)) {
        p.json.emplace_back("bound", text(to_string(*b)));
        bounds_.push_back(*b);
      }
    }
  }

  std::string theorem() {
    const bool torus = has_torus();
    const bool log = has_log();
    if (torus && log) return "torus-log";
    std::vector<CertifiedPlace*> open;
    for (auto& p : places_)
      if (p.open) open.push_back(&p);
    for (auto* p : open)
      bound(*p);
    std::optional<Rational> largest;
    if (!open.empty() && bounds_.size() == open.size())
      largest = *std::max_element(bounds_.begin(), bounds_.end());
    const bool no_line = exponential_bound(s_, largest).excludes();
    if (log && no_line) return "irreducible-log";
    if (bounds_.size() < open.size()) throw NoProof("no bound of Delta^2 has an exact proof");
    if (open.empty() && !torus) {
      rational(log, no_line || !lines_possible());
      return "rational";
    }
    absent(4);
    if (open.empty()) return "torus";
    exclude_values(open);
    return open.size() == 1 ? "one-open" : "open";
  }

  // The judge wants to see that Delta has none of certain values: the solver has split those that
  // signs do not exclude.
  void exclude_values(const std::vector<CertifiedPlace*>& open) {
    for (const auto* p : open) {
      if (p->chi.size() != 2) throw NoProof("an open exponent of degree > 1");
      for (const Rational& v : candidates(*p->place)) {
        const MPoly at = where_square_is(*p->place, v * v);
        if (!facts_.ensure_nonzero(at, lemmas_) && region_.is_nonzero(at))
          throw NoProof("Delta != " + to_string(v) + " has no exact proof");
      }
    }
  }

  // More values than the judge asks for: all with a small denominator, and those of lines.
  [[nodiscard]] std::set<Rational> candidates(const ParametricPlace& p) const {
    const Rational most =
        bounds_.empty() ? Rational(0) : *std::max_element(bounds_.begin(), bounds_.end());
    std::set<Rational> all;
    for (long n = 1; n <= 5; ++n)
      for (long a = 0; Rational(a * a, n * n) <= most + Rational(2); ++a)
        all.insert(Rational(a, n));
    const Families lines = exponential_families(s_, p);
    const long d = p.degree(z_);
    for (const Rational& fixed : lines.fixed)
      for (long j = -d; lines.complete && j <= d; j += 2)
        for (long k = 0; j != 0 && all.size() < 4000; ++k) {
          const Rational v = Rational(2) * (Rational(k) - fixed) / Rational(j);
          if (sign(Rational(k) - fixed) > 0 && v * v > most) break;
          if (v * v <= most) all.insert(abs(v));
        }
    return all;
  }

  [[nodiscard]] bool lines_possible() const {
    const Families f = exponential_families(s_);
    return !f.complete || std::any_of(f.fixed.begin(), f.fixed.end(), [](const Rational& d) {
      return is_integer(d) && sign(d) >= 0;
    });
  }

  void rational(bool log, bool no_line) {
    if (!log) absent(12);
    if (no_line) return;
    Integer n(2);
    for (const auto& p : s_.finite)
      n = lcm(n, ((Rational(1) + p.delta) * Rational(1, 2)).den());
    if (n > Integer(200))
      throw NoProof("the exponents have the common denominator " + to_string(n));
    if (log || n != Integer(12)) absent(to_long(n));
  }

  // Sym^m has no rational solution: by degree, or by minors.
  void absent(long m) {
    const InvariantBound bound = invariant_bound(s_, m);
    if (!bound.form) return;
    const auto answer = exclude_invariant(s_, *bound.form, region_, budget_);
    const auto* excluded = std::get_if<Excluded>(&answer);
    if (excluded == nullptr) throw NoProof("Sym^" + std::to_string(m) + " is not excluded");
    Json::Array minors;
    for (const auto& minor : excluded->minors) {
      Json::Array rows;
      for (const std::size_t i : minor.rows)
        rows.push_back(text(static_cast<long>(i)));
      minors.push_back(Json{Json::Object{{"rows", Json{std::move(rows)}}, {"times", text(1L)}}});
    }
    Json::Object data{{"m", text(m)}, {"minors", Json{std::move(minors)}}};
    if (excluded->minors.size() == 1)
      need(excluded->minors.front().value, "a minor");
    else
      data.emplace_back("prime", text(separating_prime(excluded->minors)));
    absent_.push_back(Json{std::move(data)});
  }

  // A prime modulo which the minors, without the factors that are known, stay without a common
  // root.
  long separating_prime(const std::vector<Minor>& minors) {
    std::vector<MPoly> rest;
    for (const auto& minor : minors) {
      for (const auto& f : irreducible_parts(minor.value))
        (void)facts_.ensure_nonzero(f, lemmas_);
      rest.push_back(facts_.without_known_factors(minor.value));
    }
    const auto x = used_variables(minors.front().value).front();
    mp_limb_t p = 1UL << 30;
    for (int attempt = 0; attempt < 20; ++attempt) {
      p = n_nextprime(p, 1);
      const auto modulo = [&](const MPoly& f) {
        NmodPoly g(p);
        const auto c = coefficients(f, x);
        for (std::size_t i = 0; i < c.size(); ++i)
          if (!is_zero(c[i]))
            g.set_coeff(static_cast<long>(i), fmpz_fdiv_ui(c[i].coefficient(0).raw(), p));
        return g;
      };
      NmodPoly common = modulo(rest.front());
      if (kov::degree(common) != degree(rest.front(), x)) continue;
      for (const auto& f : rest)
        common = gcd(common, modulo(f));
      if (kov::degree(common) <= 0) return static_cast<long>(p);
    }
    throw NoProof("no prime separates the minors");
  }

  const MFraction& r_;
  std::size_t z_;
  const Region& region_;
  KnownFacts& facts_;
  std::vector<Lemma>& lemmas_;
  const Budget& budget_;
  Scheme s_;
  std::vector<CertifiedPlace> places_;
  std::vector<Rational> bounds_; // of the open places
  Json::Array absent_;
};

} // namespace

Json leaf_certificate(const Leaf& leaf, const MFraction& r, std::size_t z, const Region& region,
                      KnownFacts& facts, std::vector<Lemma>& lemmas, const Budget& budget) {
  if (leaf.number)
    return Json{Json::Object{{"node", text("leaf")},
                             {"abelian", text(leaf.abelian == Truth::yes ? "yes" : "no")},
                             {"by", text("number")},
                             {"certificate", number_certificate(*leaf.number)}}};
  if (leaf.invariant)
    return LeafWriter(r, z, region, facts, lemmas, budget).invariant(*leaf.invariant);
  if (leaf.abelian != Truth::no) throw NoProof(leaf.reason);
  return LeafWriter(r, z, region, facts, lemmas, budget).not_abelian();
}

} // namespace kov::strata
