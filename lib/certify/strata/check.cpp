// The walk through the tree: strata_certificates.md 4 and 5.

#include "certify/strata/check.hpp"

#include "certify/equation/statement.hpp"
#include "certify/strata/classical.hpp"
#include "certify/strata/rules.hpp"
#include "exact/joined.hpp"
#include "proof/text/checked.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

class Walk {
public:
  explicit Walk(const StrataCertificate& c) : c_(c) {}

  StrataAccepted operator()() {
    node(*c_.tree, Stratum(c_, arithmetic_));
    path_ = "claim";
    const std::size_t other = count_.open + count_.by_criterion;
    need(c_.abelian != true || count_.not_abelian + other == 0,
         "not every stratum is proved abelian");
    need(c_.abelian != false || count_.abelian + other == 0,
         "not every stratum is proved not abelian");
    count_.claim = c_.abelian;
    return count_;
  }

  [[nodiscard]] const std::string& path() const { return path_; } ///< of the node that failed

private:
  // Visits a child; the path is not restored when something is refused.
  template <class F> void at(const std::string& name, F visit) {
    const std::size_t length = path_.size();
    path_ += "." + name;
    visit();
    path_.resize(length);
  }
  Stratum copy(const Stratum& s) {
    arithmetic_.charge(s.size());
    return s;
  }

  void node(const StrataNode& n, Stratum s) {
    std::visit([&](const auto& x) { take(x, s, nullptr); }, n.kind);
  }
  void where_zero(const WhereZero& z, Stratum& s, const MPoly& p) {
    under({p, Sign::zero},
          [&] { at("zero", [&] { std::visit([&](const auto& x) { take(x, s, &p); }, z); }); });
  }
  template <class F> void under(Condition c, F visit) {
    way_.push_back(std::move(c));
    visit();
    way_.pop_back();
  }
  void say(bool abelian, Denial d) {
    if (abelian) {
      ++count_.abelian;
      return;
    }
    ++count_.not_abelian;
    count_.denials.push_back(here(std::move(d)));
  }
  [[nodiscard]] Denial here(Denial d) const {
    for (const Condition& c : way_) // copied for each leaf, exponent by exponent
      FileMeter::charge(2.0 * static_cast<double>(c.p.length()) *
                            static_cast<double>(c.p.ring() ? c.p.ring()->size() : 0),
                        0);
    d.path = way_;
    return d;
  }

  // ---- nodes; p = 0 is known where p is given

  [[nodiscard]] std::string said(const std::string& what) const {
    return (way_.empty() ? "always" : joined(way_, [](const Condition& c) { return text_of(c); })) +
           ": " + what;
  }
  // A leaf with its rule and the conditions on the way to it.
  void tell(const char* key, const std::string& rule, const std::string& what) const {
    if (CheckedSteps::wanted())
      CheckedSteps::add({"kovacic-strata/1", key, rule, "", {}, said(what)});
  }
  void state(const std::string& what) { count_.lines.push_back("  " + said(what)); }
  static std::string trusted_steps(std::size_t n) {
    return n > 0 ? ", " + std::to_string(n) + " trusted" : "";
  }

  void take(const SplitNode& n, Stratum& s, const MPoly*) {
    s.need_parameters(n.p);
    need(!is_constant(n.p), "the polynomial is constant");
    under({n.p, Sign::nonzero}, [&] {
      at("nonzero", [&] {
        Stratum t = copy(s);
        t.add_unit(n.p);
        node(*n.nonzero, std::move(t));
      });
    });
    where_zero(n.zero, s, n.p);
  }

  void take(const AssumedNode& n, Stratum& s, const MPoly*) {
    s.need_parameters(n.p);
    need(!is_constant(n.p), "the polynomial is constant");
    const MPoly& f = s.condition(n.condition, {Sign::zero});
    need(!is_zero(f), "the condition is not an equation");
    MPoly rest = s.rest(f);
    const MPoly base = primitive(n.p);
    bool divided = false;
    while (const auto q = is_constant(rest) ? std::nullopt : arithmetic_.quotient(rest, base)) {
      rest = *q;
      divided = true;
    }
    need(divided && is_constant(rest), "the condition does not imply that the polynomial is 0");
    where_zero(n.zero, s, n.p);
  }

  void take(const LemmasNode& n, Stratum& s, const MPoly*) {
    for (std::size_t i = 0; i < n.lemmas.size(); ++i)
      at("lemmas[" + std::to_string(i) + "]", [&] { lemma(n.lemmas[i], s); });
    at("then", [&] { node(*n.then, std::move(s)); });
  }

  static const char* word(bool abelian) { return abelian ? "abelian" : "not abelian"; }

  void take(const LeafNode& n, Stratum& s, const MPoly*) {
    if (const auto* c = std::get_if<ByClassical>(&n.by)) {
      classical(n.abelian, *c, s);
      const std::string words =
          n.abelian ? word(*n.abelian) : "abelian exactly where " + criterion(*c);
      state(words + " (" + c->family + ")");
      return tell("by", c->family, words);
    }
    const std::size_t before = count_.trusted;
    proved(n, s);
    const auto* x = std::get_if<ByPlaces>(&n.by);
    const std::string by = x                                        ? x->theorem
                           : std::holds_alternative<ByNumber>(n.by) ? "number"
                                                                    : "invariant";
    state(word(n.abelian.value()) + (" (" + by + trusted_steps(count_.trusted - before) + ")"));
    tell("by", by, word(n.abelian.value()));
  }
  void proved(const LeafNode& n, Stratum& s) {
    const bool abelian = n.abelian.value();
    if (const auto* x = std::get_if<ByNumber>(&n.by)) {
      const std::size_t trusted = check_number(s, *x, abelian);
      count_.trusted += trusted;
      return say(abelian, denial_of(x->certificate, trusted));
    }
    if (const auto* v = std::get_if<ByInvariant>(&n.by)) {
      need(abelian, "an invariant proves 'yes'"), check_invariant(s, *v);
      return say(true, {});
    }
    const auto& leaf = std::get<ByPlaces>(n.by);
    need(!abelian, "the theorem proves 'no'"), check_places(s, leaf);
    const Fraction& r = s.r();
    const bool finite =
        std::ranges::all_of(leaf.places, [](const StratumPlace& p) { return p.order <= 2; });
    say(false, {.regular = finite && (is_zero(r.num) || degree(r.den, 0) - degree(r.num, 0) >= 2)});
  }
  void classical(std::optional<bool> abelian, const ByClassical& leaf, Stratum& s) {
    const Truth found = check_classical(s, leaf);
    need(!abelian || found == truth(*abelian), "the criterion is not shown to say that");
    if (abelian) return say(*abelian, {});
    ++count_.by_criterion;
    const bool regular = leaf.family == "riemann"; // it is pulled back from such an equation
    count_.criteria.push_back({here({.regular = regular}), one_difference(leaf, arithmetic_)});
  }

  void take(const EmptyStratum& n, Stratum& s, const MPoly* p) {
    if (n.violation) {
      s.need_violated(n.violation->membership, n.violation->value, p);
    } else if (n.terms) {
      need(vanishes(sum(*n.terms, s, false).first, p, arithmetic_),
           "the sum of the terms is not 0");
    } else {
      need(s.plainly_empty() || (p && s.is_unit(*p)), "the stratum is not known to be empty");
    }
    ++count_.empty;
  }

  void take(const OutsideStratum& n, Stratum& s, const MPoly* p) {
    const auto zero = [&](const MPoly& f) { return vanishes(f, p, arithmetic_); };
    if (n.generic) {
      const auto& group = s.group(*n.generic);
      need(std::ranges::all_of(group, zero), "a polynomial of the group may be nonzero");
    } else {
      need(!s.defined() || zero(s.r().den), "den is not 0");
    }
    ++count_.outside;
  }

  void take(const OpenStratum& n, Stratum&, const MPoly*) {
    ++count_.open;
    state("undecided (" + quoted(n.reason) + ")");
  }

  void take(const TrustedStratum& n, Stratum&, const MPoly*) {
    ++count_.trusted;
    state((n.abelian == "empty" ? "no points" : word(n.abelian == "yes")) +
          (" (trusted, " + quoted(n.theorem) + ": " + quoted(n.statement) + ")"));
    n.abelian == "empty" ? void(++count_.empty) : say(n.abelian == "yes", {.trusted = 1});
  }

  void take(const SolvedStratum& n, Stratum& s, const MPoly* p) {
    s.solve(*p, n);
    at("then", [&] { node(*n.then, std::move(s)); });
  }

  void take(const RootStratum& n, Stratum& s, const MPoly* p) {
    const std::size_t trusted = check_root(s, *p, n);
    count_.trusted += trusted;
    say(n.abelian, denial_of(n.certificate, trusted));
    state(word(n.abelian) + (" (root" + trusted_steps(trusted) + ")"));
    tell("zero", "root", word(n.abelian));
  }

  // ---- 5

  void lemma(const Lemma& l, Stratum& s) {
    s.need_parameters(l.p);
    if (l.violation) {
      need(!l.positive && !is_constant(l.p), "a membership shows that a polynomial is not 0");
      s.need_violated(l.violation->membership, l.violation->value, &l.p);
    } else if (l.prime) {
      need(!l.positive, "a prime shows that a polynomial is not 0");
      s.need_no_rational_root(l.p, *l.prime);
    } else {
      need_sum(l, s);
    }
    if (l.positive)
      s.assume(Condition{l.p, Sign::positive});
    else
      s.add_unit(l.p);
  }

  void need_sum(const Lemma& l, Stratum& s) {
    MPoly left = l.p;
    if (l.times) {
      s.need_parameters(*l.times);
      need(!l.positive || s.is_positive(*l.times), "times is not known to be positive");
      left = arithmetic_.times(left, *l.times);
    }
    if (l.terms) {
      const auto [right, denominator] = sum(*l.terms, s, l.positive);
      need(scaled(left, denominator) == right, "p times is not the sum of the terms");
    } else {
      need(!l.positive && s.is_unit(left), "p times is not known to be nonzero");
    }
  }

  [[nodiscard]] std::pair<MPoly, Integer> sum(const std::vector<LemmaTerm>& terms, const Stratum& s,
                                              bool positive) {
    std::vector<SignTerm> all;
    for (const LemmaTerm& t : terms) {
      SignTerm& x = all.emplace_back(t.c, MPoly(c_.ring, Integer(1)), t.powers);
      for (const auto& [q, e] : t.squares) {
        s.need_parameters(q);
        x.q = arithmetic_.times(x.q, arithmetic_.power(q, e));
      }
    }
    return s.sum(all, positive);
  }

  const StrataCertificate& c_;
  Arithmetic arithmetic_;
  StrataAccepted count_;
  std::string path_ = "tree";
  std::vector<Condition> way_; ///< to the node
};

bool is_regular(const Poly& num, const Poly& den) {
  const Poly first = derivative(den);
  return kov::degree(gcd(gcd(den, first), derivative(first))) <= 0 &&
         (is_zero(num) || kov::degree(den) - kov::degree(num) >= 2);
}

} // namespace

Denial denial_of(const Certificate& c, std::size_t trusted) {
  return {is_regular(c.num, c.den), c.claim.group == "SL2", trusted};
}

std::variant<StrataAccepted, Rejected> check_strata(const StrataCertificate& c) {
  if (c.variable != 0) return Rejected{{"the variable is not the first one of the ring"}};
  const FileMeter all_certificates;
  const CheckedSteps::File file;
  Walk walk(c);
  try {
    return walk();
  } catch (const Refused& r) {
    return Rejected{r, walk.path()};
  } catch (const std::exception& e) {
    return Rejected{{e.what()}, walk.path()};
  }
}

} // namespace kov::certify
