// The statement of an accepted certificate of a theorem: theorem_certificates.md 9, 10.  The Python
// checker prints the same.

#include "certify/equation/statement.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/fact.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "proof/text/fields.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

const char* const checked = "checked";
const char* const stated = "part of the statement";
const char* const open_one = "NOT CHECKED";

template <class Words> struct OneWord {
  const Words& words;

  template <class T> void read(const Node& n, T& x, NoSetting&) const {
    const auto at = std::ranges::find(words, n.text(), [](T value) { return word_of(value); });
    if (at == words.end()) n.fail("an unknown word");
    x = *at;
  }
};
struct Name {
  static void read(const Node& n, std::string& x, NoSetting&) {
    x = n.text();
    if (!is_name(x)) n.fail("a name is expected");
  }
};

std::string text(const Conditions& all) {
  return joined(all, [](const Condition& c) { return text_of(c); });
}

void put_system(std::vector<std::string>& lines, const Family& f) {
  const PhaseSystem& s = f.system;
  const auto parameters = s.parameters();
  std::vector<std::string> real, complex;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    (!f.complex.empty() && f.complex[s.first_parameter() + i] ? complex : real)
        .push_back(parameters[i]);
  lines.push_back("the system " + quoted(f.name) +
                  (real.empty() ? "" : " with real parameters " + joined(real)) +
                  (complex.empty() ? ""
                                   : std::string(real.empty() ? " with" : " and") +
                                         " complex parameters " + joined(complex)));
  for (const std::string& line : shown_system(s))
    lines.push_back("  " + line);
  if (f.lagrangian) lines.push_back(shown_lagrangian(*f.lagrangian, s));
  if (!f.assumptions.empty()) lines.push_back("  " + text(f.assumptions));
}

std::string place(const TheoremFact& f) {
  std::vector<std::string> all;
  for (const Conditions& c : f.regions)
    all.push_back(c.empty() ? "everywhere" : "where " + text(c));
  return joined(all, "; or ");
}

// The places of an exception.  led: a symmetry leads there.
std::string places(const TheoremFact& f, bool led) {
  return place(f) + (led ? ", or where a symmetry leads there" : "");
}

// "X1, X2" in the order of the coordinates
std::string shown_field(const std::vector<PhaseFunction>& y) {
  return "(" + joined(y, [](const PhaseFunction& f) { return to_string(f); }) + ")";
}

// "first integral 'F': ..."
std::vector<std::string> claims_of(const ClaimedIntegrals& c) {
  return mapped<std::string>(c.claims, [](const auto& f) {
    return "first integral " + quoted(f.first) + ": " + to_string(f.second);
  });
}

// With a bracket: independent and in involution; without: they and the fields commute.
std::string integrable(const TheoremFact& f, bool led) {
  const std::string where = places(f, led);
  if (!f.trusted.empty()) return "  TRUSTED: integrable " + where + ": " + quoted(f.trusted);
  const ClaimedIntegrals& c = f.integrals.front();
  std::vector<std::string> said = claims_of(c);
  for (const auto& y : c.fields)
    said.push_back("commuting field " + shown_field(y));
  return "  integrable " + where + ": " + joined(said) +
         (c.not_shown.empty() ? "" : " (TRUSTED: " + joined(c.not_shown) + ")");
}

std::string exception(const TheoremFact& f, bool led) {
  std::string line = "  except possibly " + places(f, led);
  for (const ClaimedIntegrals& c : f.integrals)
    line += ": " + joined(claims_of(c)) + " (of " + quoted(c.family->name) +
            (c.level.empty()
                 ? ""
                 : "; on " + joined(c.level,
                                    [](const PhaseFunction& g) { return to_string(g) + " = 0"; })) +
            (f.way.empty() ? "" : "; " + joined(f.way, "; ")) + ")";
  return line;
}

std::string shown_symmetry(const TheoremFact& f) {
  const PhaseSystem& s = f.family->system;
  std::vector<std::string> said;
  for (std::size_t i = s.first_parameter(); i < s.ring->size(); ++i)
    if (std::string one = f.map->moved(i, " -> "); !one.empty()) said.push_back(std::move(one));
  if (said.empty()) said.emplace_back("none of the parameters");
  if (std::string where = f.map->adjoined(); !where.empty()) said.push_back(std::move(where));
  return "  a symmetry" + (f.regions.front().empty() ? "" : " " + place(f)) + ": " + joined(said);
}

} // namespace

template <class IO> void describe(IO& io, IntegralClass& c) {
  using Kind = IntegralClass::Kind;
  using Near = IntegralClass::Near;
  std::vector<std::string> through;
  io("kind", c.kind, OneWord{all_kinds})("near", c.near, OneWord{all_places});
  io.check(c.near != Near::level, "near", "an unknown word");
  const bool everywhere = c.near == Near::phase_space;
  io.check(c.kind != (everywhere ? Kind::meromorphic : Kind::real_analytic), "near",
           "real-analytic functions are those on the phase space, meromorphic ones are not");
  io("on_leaf", c.on_leaf, yes_or_no)("liouville", c.liouville, yes_or_no);
  io("functions", c.functions, Each<Name>{})("without", c.without, Each<Name>{});
  io("through", through, Each<Name>{})("frame", c.frame);
  for (const std::string& symbol : through)
    c.through.emplace_back("", symbol);
  io.check(std::ranges::none_of(c.frame, [](char x) { return x < ' ' || x > '~'; }), "frame",
           "one line is expected");
}

const std::vector<NamedTheorem>& named_theorems() {
  static const std::vector<NamedTheorem> all{
      {"Morales-Ramis",
       "Morales-Ruiz and Ramis (2001)",
       {{checked, "the system is Hamiltonian on the leaves of a Poisson structure (S2)"},
        {checked, "the curve is a phase curve and no equilibrium (C4, C5)"},
        {stated,
         "the first integrals are meromorphic near the curve, and independent together with the "
         "Casimir functions (or on its leaf)"}}},
      {"Morales-Ramis-Simo",
       "Morales-Ruiz, Ramis and Simo (2007)",
       {{checked, "the curve is a phase curve of a Hamiltonian system (J1, J2)"},
        {stated, "the first integrals are meromorphic near the curve"}}},
      {"Morales-Ramis, potentials",
       "Morales-Ruiz and Ramis on homogeneous potentials (2001)",
       {{checked,
         "all Darboux points are known; the sum over their eigenvalues, and the table (16)"},
        {stated,
         "the first integrals are meromorphic near the phase curves through these points"}}},
      {"Morales-Ramis-Simo, potentials",
       "Morales-Ruiz, Ramis and Simo on homogeneous potentials (2007)",
       {{checked, "a Darboux point is multiple (16)"},
        {stated, "the first integrals are meromorphic near the phase curve through this point"}}},
      {"Ziglin, parts",
       "Ziglin's lemma on parts of highest or lowest degree (1982)",
       {{checked, "all other terms of the Hamiltonian have lower, or higher, weights (16)"},
        {stated, "the first integrals are rational"}}},
      {"Ayoul-Zung",
       "Ayoul and Zung (2010)",
       {{checked, "the curve is a phase curve and no equilibrium (C4, C5)"},
        {stated, "first integrals and commuting vector fields are meromorphic near the curve"}}},
      {"Ziglin 1980",
       "Ziglin on the splitting of separatrices (1980)",
       {{checked, "hypotheses 1 to 6, for a perturbation of the Euler top (Z1 to Z3)"},
        {stated, "the first integral is real-analytic near the closure of the orbit"}}},
      {"Ziglin 1982",
       "Ziglin's lemma on lowest-order parts (1982)",
       {{checked, "the bracket and the lowest-order terms are weight-homogeneous (7)"},
        {stated, "the first integrals are meromorphic near the origin"}}},
      {"Ziglin 1983",
       "Ziglin on the symmetric heavy top (1983)",
       {{stated, "the first integrals are meromorphic on the leaves with F2 = 0"},
        {open_one, "first integrals that are independent are so on the leaves with F2 = 0"}}}};
  return all;
}

IntegralClass read_class(const Node& n) { return read_whole<IntegralClass>(n); }

bool on_one_leaf(const std::vector<IntegralClass>& classes) {
  return std::ranges::any_of(classes, [](const IntegralClass& c) { return c.on_leaf; });
}

static std::vector<std::string> shown_way(const TheoremFact& f) {
  std::vector<std::string> all = f.way;
  all.insert(all.end(), f.there.text.begin(), f.there.text.end());
  return all;
}

// " ", or ", for functions with s = 0 there, "; of several lists each with the parts of which it is said.
static std::string functions_there(const std::vector<const TheoremFact*>& parts) {
  std::vector<std::string> all;
  for (const TheoremFact* f : parts)
    for (const std::string& text : f->there.text)
      add_once(all, text);
  if (all.empty()) return " ";
  const bool several = all.size() > 1;
  for (std::string& list : all) {
    std::vector<std::string> where;
    for (const TheoremFact* f : parts)
      if (const auto& has = f->there.text; is_among(list, has)) where.push_back(place(*f));
    if (several) list += " (" + joined(where, "; or ") + ")";
  }
  return ", " + joined(all, ", or ") + ", ";
}

std::string shown(const TheoremFact& f) {
  const std::string of = f.family ? quoted(f.family->name) + ", " + place(f) : joined(f.way, "; ");
  std::vector<std::string> claims;
  for (const ClaimedIntegrals& c : f.integrals)
    for (const auto& [name, value] : c.claims)
      claims.push_back(quoted(name));
  switch (f.kind) {
  case FactKind::symmetry:
    return quoted(f.family->name) + "," + shown_symmetry(f).substr(1);
  case FactKind::leaves:
    return of + ": not integrable at " + std::to_string(f.leaves.size()) + " leaves";
  case FactKind::open:
    return of + ": nothing is said";
  case FactKind::integrals:
    return of + ": first integrals " + joined(claims);
  case FactKind::integrable:
    return of + ": integrable" + (claims.empty() ? "" : " with " + joined(claims));
  case FactKind::not_integrable:
    return of + (f.classes.empty() ? ": integrable"
                                   : ": not integrable with " + first_integrals(f.classes));
  }
  return of;
}

std::vector<std::string> theorem_statement(const TheoremFact& last,
                                           const std::vector<const TheoremFact*>& parts,
                                           const std::vector<const TheoremFact*>& symmetries,
                                           const std::set<const TheoremFact*>& led) {
  std::vector<std::string> lines;
  put_system(lines, *last.family);
  const auto has = [&](FactKind kind) {
    return std::ranges::any_of(parts, [&](const auto* f) { return f->kind == kind; });
  };
  const std::string but = std::string(has(FactKind::integrable) && !last.classes.empty()
                                          ? ", but where it is integrable"
                                          : "") +
                          (has(FactKind::open) ? ", but where nothing is said" : "");
  lines.push_back((last.classes.empty() ? std::string("is integrable")
                                        : "is not integrable" + functions_there(parts) + "with " +
                                              first_integrals(last.classes)) +
                  ", where the denominators are not 0 for all coordinates" + but +
                  (last.trusts.empty() ? "" : ", if what is marked TRUSTED holds"));
  for (const TheoremFact* f : parts)
    if (f->kind == FactKind::not_integrable && !f->trusted.empty())
      lines.push_back("  TRUSTED: not integrable with " + first_integrals(f->classes) + " " +
                      place(*f) + ": " + quoted(f->trusted));
    else if (f->shows_way || on_one_leaf(f->classes))
      lines.push_back("  " + place(*f) + ": " + joined(shown_way(*f), "; "));
  for (const TheoremFact* f : parts)
    if (f->kind == FactKind::integrable) lines.push_back(integrable(*f, led.contains(f)));
  for (const TheoremFact* f : parts)
    if (f->kind == FactKind::open)
      lines.push_back("  nothing is said " + places(*f, led.contains(f)));
  for (const TheoremFact* f : parts)
    if (f->kind == FactKind::integrals) lines.push_back(exception(*f, !symmetries.empty()));
  for (const TheoremFact* f : symmetries)
    lines.push_back(shown_symmetry(*f));
  for (const NamedTheorem& t : named_theorems()) {
    if (!last.used.contains(t.id)) continue;
    lines.push_back("given " + t.title);
    for (const auto& [how, what] : t.hypotheses)
      lines.push_back("  " + how + ": " + what);
  }
  return lines;
}

} // namespace kov::certify
