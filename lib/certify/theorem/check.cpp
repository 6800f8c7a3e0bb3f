#include "certify/theorem/check.hpp"

#include "certify/equation/facts.hpp"
#include "certify/equation/statement.hpp"
#include "certify/system/check.hpp"
#include "certify/theorem/common_values.hpp"
#include "certify/theorem/darboux.hpp"
#include "certify/theorem/fact.hpp"
#include "certify/theorem/integrable.hpp"
#include "certify/theorem/lowest_order.hpp"
#include "certify/theorem/splitting.hpp"
#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "proof/text/checked.hpp"
#include "proof/text/limits.hpp"
#include "proof/text/meter.hpp"

#include <algorithm>

namespace kov::certify {

namespace {

constexpr std::size_t max_families = 40, max_theorem_steps = 200, max_word = 40,
                      max_step_text = 4000;
constexpr std::size_t max_proof_nodes = 200000;
constexpr int max_json_depth = 512;

class Steps {
public:
  explicit Steps(const Node& top) : top_(top) {}

  std::variant<TheoremAccepted, Rejected> operator()() {
    Keys k(top_);
    static_cast<void>(k.at("format").text());
    static_cast<void>(k.at("title").text());
    const auto families = k.at("systems").items(), steps = k.at("steps").items();
    k.done();
    if (families.size() > max_families || steps.empty() || steps.size() > max_theorem_steps)
      top_.fail("too many systems or steps");
    std::string at = "systems", id;
    try {
      for (const Node& n : families)
        put_family(n);
      for (std::size_t i = 0; i < steps.size(); ++i) {
        at = "step " + quoted_id(steps[i]);
        id = Keys(steps[i]).at("id").text();
        step(steps[i], i + 1 == steps.size());
      }
      at = id = "";
      for (std::size_t i = 0; i + 1 < steps.size(); ++i)
        need(facts_.is_named(Keys(steps[i]).at("id").text()), "a step is not used");
    } catch (const Refused& no) {
      return Rejected{no, at, id};
    } catch (const InvalidArgument&) {
      throw;
    } catch (const std::exception& e) {
      return Rejected{{e.what()}, at, id};
    }
    return accepted();
  }

private:
  static std::string quoted_id(const Node& n) {
    Keys k(n);
    std::string id = k.at("id").text().substr(0, 60);
    for (char& c : id)
      if (c < ' ' || c > '~') c = '?';
    return "'" + id + "' (" + k.at("rule").text().substr(0, 20) + ")";
  }

  TheoremAccepted accepted() const {
    TheoremAccepted yes{{},
                        0,
                        last_->trusts.size(),
                        0,
                        theorem_statement(*last_, parts_, symmetries_, led_),
                        last_->classes};
    for (const TheoremFact* f : parts_)
      yes.open += f->kind == FactKind::open ? 1 : 0;
    for (const NamedTheorem& t : named_theorems()) {
      if (!last_->used.contains(t.id)) continue;
      yes.theorems.push_back(t.id);
      for (const auto& [how, what] : t.hypotheses)
        yes.unchecked += how == "NOT CHECKED" ? 1 : 0;
    }
    return yes;
  }

  void put_family(const Node& n) {
    Arithmetic a;
    auto f = std::make_unique<Family>(read_family(n, a));
    for (const auto& g : families_)
      if (g->name == f->name) n.fail("a system occurs twice");
    families_.push_back(std::move(f));
  }

  void step(const Node& n, bool is_last) {
    Keys k(n);
    const std::string id = k.at("id").text(), rule = k.at("rule").text();
    need(!facts_.has(id), "the id occurs twice");
    need((rule == "cover") == is_last, "the last step is a cover, and no other");
    arithmetic_ = Arithmetic();
    Said f = rule == "certificate"     ? certificate(k)
             : rule == "leaf"          ? leaf(k)
             : rule == "literature"    ? literature(k)
             : rule == "integrals"     ? integrals(k)
             : rule == "splitting"     ? splitting(k)
             : rule == "place"         ? place(k)
             : rule == "symmetry"      ? symmetry(k)
             : rule == "lowest-order"  ? lowest_order(k)
             : rule == "integrable"    ? integrable(k, id)
             : rule == "darboux"       ? darboux(k)
             : rule == "common-values" ? common_values(k)
             : rule == "trusted"       ? trusted(k, id)
             : rule == "open"          ? somewhere(k, FactKind::open)
             : rule == "cover"         ? cover(k)
                               : (need(false, "an unknown rule"), somewhere(k, FactKind::open));
    k.done();
    std::vector<std::string> of = facts_.premises();
    last_ = &facts_.derive(id, std::move(f));
    if (CheckedSteps::wanted())
      CheckedSteps::add({"kovacic-theorem/1", "rule", rule, id, std::move(of), shown(*last_)});
  }

  const Family& plain_family(Keys& k) {
    const Family& f = family(k);
    need(f.is_plain(), "a Hamiltonian system with real parameters is expected");
    return f;
  }
  const Family& family(Keys& k) {
    const std::string name = k.at("system").text();
    const auto found =
        std::ranges::find_if(families_, [&](const auto& f) { return f->name == name; });
    need(found != families_.end(), "there is no such system");
    return **found;
  }
  const TheoremFact& fact(const Node& n) { return facts_.premise(n.text()); }
  // From which a rule makes another fact: of one region, and not on trust.
  const TheoremFact& proved(const Node& n) {
    const TheoremFact& f = fact(n);
    need(f.trusts.empty() && !f.several, "what is on trust is named by the cover only");
    return f;
  }
  static void need_kind(const TheoremFact& f, bool right) {
    static_cast<void>(f);
    need(right, "the step says something else");
  }

  // ---- 5

  static Said certificate(Keys& k) { return said_by_certificate(k.at("certificate")); }

  // One leaf of a certificate that says "not abelian", where it says so.
  Said leaf(Keys& k) {
    const TheoremFact& of = fact(k.at("of"));
    const LeafSaid& x = of.leaves.at(index(k.at("leaf"), of.leaves.size(), "no such leaf"));
    need(x.trusted == 0, "a leaf on trust");
    Said f{FactKind::not_integrable, nullptr, {{}}};
    f.classes = {x.integrals};
    f.way = of.way;
    f.there = of.there;
    f.system = of.system;
    f.target = target_of(of, x);
    return f;
  }

  Said literature(Keys& k) {
    need(k.at("theorem").text() == "Ziglin 1983", "an unknown theorem");
    const Family& y = plain_family(k);
    const Json json = parse_json(symmetric_heavy_top());
    const Family known = read_family(Node(json, "Ziglin 1983", rationals()), arithmetic_);
    const PhaseSystem &s = y.system, &t = known.system;
    const auto alike = [&](const MPoly& f, const MPoly& g) { // their rings have the same names
      return transfer(g, s.ring) == MFraction(f);
    };
    const auto same = [&](const PhaseFunction& f, const PhaseFunction& g) {
      return f.n == g.n && alike(f.p, g.p);
    };
    bool equal = s.ring->names() == t.ring->names() && s.dimension == t.dimension &&
                 same(*s.hamiltonian, *t.hamiltonian) && s.brackets.size() == t.brackets.size() &&
                 s.inverses.size() == t.inverses.size() &&
                 y.assumptions.size() == known.assumptions.size();
    for (std::size_t i = 0; equal && i < s.inverses.size(); ++i)
      equal = alike(s.inverses[i], t.inverses[i]);
    for (std::size_t i = 0; equal && i < s.brackets.size(); ++i)
      equal = s.brackets[i].first == t.brackets[i].first &&
              s.brackets[i].second == t.brackets[i].second &&
              same(s.brackets[i].value, t.brackets[i].value);
    for (std::size_t i = 0; equal && i < y.assumptions.size(); ++i)
      equal = y.assumptions[i].sign == known.assumptions[i].sign &&
              alike(y.assumptions[i].p, known.assumptions[i].p);
    need(equal, "not the system of the theorem");
    Said f{FactKind::not_integrable, &y, {{}}};
    f.classes = {on_leaves()};
    f.used = {"Ziglin 1983"};
    return f;
  }

  Said integrals(Keys& k) {
    const Family& y = family(k);
    const PhaseSpace space(y.system, arithmetic_);
    const auto field = space.field();
    Said f{FactKind::integrals, &y, {{}}};
    ClaimedIntegrals all{&y, {}, functions(y, k.at("level"))};
    for (const PhaseFunction& g : all.level)
      space.need_cleared(along(space, y, field, g), {}, "the level is not invariant");
    const auto claims = k.at("claims").items();
    if (claims.empty()) k.at("claims").fail("nothing is claimed");
    const Functions in(y.system.ring, arithmetic_);
    for (const Node& n : claims) {
      Keys c(n);
      const PhaseFunction value = function(y, c.at("value"));
      const auto cofactors = functions(y, c.at("cofactors"));
      if (cofactors.size() != all.level.size()) n.fail("a cofactor for each function is expected");
      PhaseFunction rest = along(space, y, field, value);
      for (std::size_t i = 0; i < cofactors.size(); ++i)
        rest = in.minus(rest, in.times(cofactors[i], all.level[i]));
      space.need_cleared(rest, {}, "not a first integral");
      all.claims.emplace_back(c.at("name").text(), value);
      c.done();
    }
    f.integrals.push_back(std::move(all));
    return f;
  }
  static PhaseFunction function(const Family& y, const Node& n) {
    PhaseFunction f = read_phase_function(y.system.ring, n);
    if (is_zero(f.n)) n.fail("a number is 0");
    return f;
  }
  static std::vector<PhaseFunction> functions(const Family& y, const Node& n) {
    return mapped<PhaseFunction>(n.items(), [&](const Node& x) { return function(y, x); });
  }
  static PhaseFunction along(const PhaseSpace& space, const Family& y,
                             const std::vector<PhaseFunction>& field, const PhaseFunction& f) {
    std::vector<PhaseFunction> df;
    for (std::size_t j = 0; j < y.system.dimension; ++j)
      df.push_back(space.partial(f, j));
    return space.product(field, df);
  }

  Said splitting(Keys& k) {
    const Family& y = plain_family(k);
    Said f{FactKind::not_integrable, &y, {need_splitting(y, k, arithmetic_, nodes_)}};
    f.classes = {real_analytic()};
    f.used = {"Ziglin 1980"};
    return f;
  }

  // ---- 4, 12

  ParameterFunctions read_at(const Family& x, const Node& n) {
    ParameterFunctions at;
    for (const Node& row : n.items()) {
      const auto pair = row.items();
      if (pair.size() != 2) row.fail("a parameter and its value are expected");
      const auto i = x.system.ring->find(pair[0].text());
      if (!i || !x.is_parameter(*i)) row.fail("a parameter is expected");
      need(!at.contains(*i), "a parameter is put twice");
      at[*i] = function(x, pair[1]);
    }
    for (const auto& [i, f] : at)
      need_others(f, x, at);
    return at;
  }
  static void need_others(const PhaseFunction& f, const Family& x, const ParameterFunctions& at) {
    for (const std::size_t j : used_variables(f.p))
      need(x.is_parameter(j) && !at.contains(j), "a function of the other parameters is expected");
  }

  StepPlace stratum_of(Keys& k, const Family& x) {
    return {&x, read_at(x, k.at("at")), x.region(k.at("region"))};
  }
  // The fact at X.
  static Said carried(const TheoremFact& of, const Map& map, const StepPlace& here) {
    Said f{of.kind, here.family, {here.conditions()}};
    for (const IntegralClass& c : of.classes)
      f.classes.push_back(map.carried(c));
    f.integrals = of.integrals;
    f.way = of.way;
    return f;
  }

  Said place(Keys& k) { return k.find("values") ? by_values(k) : by_names(k); }
  Said by_values(Keys& k) {
    const StepPlace here = stratum_of(k, plain_family(k));
    const TheoremFact& of = proved(k.at("of"));
    need_kind(of, of.kind == FactKind::not_integrable || of.kind == FactKind::integrals);
    need(!of.only_stratum && (!of.family || of.family->is_plain()), "another class");
    const Target y =
        of.target ? *of.target
                  : target_of(*of.family, of.regions.front(), of.kind == FactKind::not_integrable);
    const Map map(here, y, k, arithmetic_, nodes_);
    Said f = carried(of, map, here);
    // the system has no functions: their values choose nothing
    f.way.insert(f.way.end(), of.there.text.begin(), of.there.text.end());
    for (std::string& text : map.shown())
      f.way.push_back(std::move(text));
    f.shows_way = of.shows_way;
    return f;
  }

  Said by_names(Keys& k) {
    const StepPlace here = stratum_of(k, family(k));
    const TheoremFact& of = proved(k.at("of"));
    need_kind(of, of.kind == FactKind::not_integrable && of.target.has_value());
    const LevelValues levels = read_levels(here, k.find("levels"));
    const Map map(here, *of.target, levels, k.at("shown"), arithmetic_, nodes_);
    Said f = carried(of, map, here);
    if (!levels.empty()) f.way.push_back(shown_levels(levels));
    f.there = with_levels(of.there, *of.system, here.family->system);
    f.shows_way = true;
    return f;
  }
  // Functions of the parameters that are left.
  LevelValues read_levels(const StepPlace& here, const std::optional<Node>& n) {
    LevelValues levels;
    if (!n) return levels;
    for (const Node& row : n->items()) {
      const auto pair = row.items();
      if (pair.size() != 2) row.fail("a level and its value are expected");
      const PhaseFunction f = function(*here.family, pair[1]);
      need_others(f, *here.family, here.at);
      need(levels.emplace(pair[0].text(), f).second, "a level is put twice");
    }
    return levels;
  }
  static std::string shown_levels(const LevelValues& levels) {
    std::vector<std::string> said;
    for (const auto& [name, value] : levels)
      said.push_back(name + " = " + to_string(value));
    return "at " + joined(said);
  }
  // The values of the functions, with the parameters in them that the family has not.
  static FunctionsThere with_levels(FunctionsThere there, const PhaseSystem& y,
                                    const PhaseSystem& x) {
    std::vector<std::string> levels;
    for (std::size_t j = y.first_parameter(); j < y.ring->size(); ++j)
      if (const std::string& name = y.ring->name(j);
          there.names.contains(name) && !x.ring->find(name))
        levels.push_back(name);
    for (std::string& text : there.text)
      text += levels.empty() ? "" : ", for some value of " + joined(levels);
    return there;
  }

  Said integrable(Keys& k, const std::string& id) {
    const StepPlace here = stratum_of(k, family(k));
    Said f{FactKind::integrable, here.family, {here.conditions()}};
    f.integrals.push_back(need_integrable(here, k, arithmetic_, nodes_));
    for (const std::string& what : f.integrals.front().not_shown)
      f.trusts.insert({id, what});
    return f;
  }

  // ---- 16

  Said darboux(Keys& k) {
    const StepPlace here = stratum_of(k, family(k));
    return need_darboux(here, k, arithmetic_, nodes_);
  }

  // ---- 17

  Said common_values(Keys& k) {
    const StepPlace here = stratum_of(k, family(k));
    const auto of = k.at("of").items(), leaves = k.at("leaves").items(),
               shown = k.at("shown").items();
    if (of.size() != 2 || leaves.size() != 2 || shown.size() != 2)
      k.at("of").fail("two leaves are expected");
    Said f{FactKind::not_integrable, here.family, {here.conditions()}};
    const auto all_levels = k.find("levels");
    const auto levels = all_levels ? all_levels->items() : std::vector<Node>{};
    if (all_levels && levels.size() != 2) all_levels->fail("levels for both are expected");
    std::vector<ExponentDifference> two;
    for (const std::size_t i : {0, 1}) {
      const TheoremFact& curve = proved(of[i]);
      need_kind(curve, curve.kind == FactKind::not_integrable || curve.kind == FactKind::leaves);
      const LeafSaid& leaf =
          curve.criteria[index(leaves[i], curve.criteria.size(), "no such leaf")];
      need(leaf.difference.has_value(), "not one exponent difference");
      const Target y = target_of(curve, leaf);
      const LevelValues at =
          read_levels(here, all_levels ? std::optional(levels[i]) : std::nullopt);
      const Map map(here, y, at, shown[i], arithmetic_, nodes_);
      add_once(f.classes, map.carried(leaf.integrals));
      f.way.insert(f.way.end(), curve.way.begin(), curve.way.end());
      if (!at.empty()) f.way.push_back(shown_levels(at));
      need(with_levels(curve.there, *curve.system, here.family->system).text.empty(),
           "functions have values there, which may be others along the other curve");
      two.emplace_back(in_parameters(*leaf.difference, *curve.system, here));
    }
    f.shows_way = true;
    Here stratum(here, {}, arithmetic_);
    for (const Condition& c :
         need_no_common_values({two[0], two[1]}, k, stratum.given(), arithmetic_, nodes_))
      f.regions.front().push_back(c);
    return f;
  }
  // The same in the parameters of X that are left, if they are those of Y.
  static OneDifference in_parameters(OneDifference d, const PhaseSystem& y, const StepPlace& here) {
    const Ring& ring = here.family->system.ring;
    for (MPoly* f : {&d.square.num, &d.square.den}) {
      for (const std::size_t i : used_variables(*f)) {
        const auto j = ring->find(y.ring->name(i));
        need(i >= y.first_parameter() && j && here.family->is_parameter(*j) &&
                 !here.at.contains(*j),
             "the difference depends on a level");
      }
      *f = in_ring(*f, ring);
    }
    return d;
  }

  Said somewhere(Keys& k, FactKind kind) {
    Said f{kind, &family(k), {}};
    f.several = true;
    for (const Node& n : k.at("regions").items())
      f.regions.push_back(f.family->region(n));
    if (f.regions.empty()) k.at("regions").fail("a region is expected");
    return f;
  }
  Said trusted(Keys& k, const std::string& id) {
    const std::string says = k.at("says").text();
    need(says == "not integrable" || says == "integrable", "a trusted step says something else");
    Said f = somewhere(k, says == "integrable" ? FactKind::integrable : FactKind::not_integrable);
    f.trusted = k.at("step").text();
    if (f.trusted.empty() || f.trusted.size() > max_step_text)
      k.at("step").fail("the name of the step is expected");
    f.trusts.insert({id, f.trusted});
    if (f.kind == FactKind::not_integrable) f.classes = {read_class(k.at("class"))};
    return f;
  }

  Said symmetry(Keys& k) {
    const Family& x = plain_family(k);
    const auto at = k.find("at"), region = k.find("region");
    const StepPlace here{&x, at ? read_at(x, *at) : ParameterFunctions{},
                         region ? x.region(*region) : Conditions{}};
    const bool any = !k.at("adjoined").items().empty();
    auto map = std::make_shared<Map>(here, target_of(x, {}, any), k, arithmetic_, nodes_);
    need(!map->moves_origin(), "the origin moves");
    for (std::size_t i = x.system.first_parameter(); i < x.system.ring->size(); ++i)
      need(map->parameter(i).n == Integer(1), "a number below");
    Said f{FactKind::symmetry, &x, {here.conditions()}};
    f.map = std::move(map);
    return f;
  }

  Said lowest_order(Keys& k) {
    const Family& x = plain_family(k);
    const TheoremFact& of = proved(k.at("of"));
    need_kind(of, of.kind == FactKind::not_integrable);
    need(of.family != nullptr && of.family->is_plain(),
         "the step is about a system of a certificate");
    const auto has_parts = [](const IntegralClass& c) { // these are rational
      return contains(c, {.kind = IntegralClass::Kind::rational}) == Truth::yes;
    };
    for (const IntegralClass& c : of.classes)
      need(has_parts(c) || c == real_analytic(),
           "a class that parts of lowest order need not have");
    need_lowest_order(x, *of.family, k, arithmetic_, nodes_);
    Said f{FactKind::not_integrable, &x, {renamed(of.regions.front(), x)}};
    for (const IntegralClass& c : of.classes)
      if (!has_parts(c)) f.classes.push_back(c);
    f.classes.push_back(near_origin());
    f.used = {"Ziglin 1982"};
    return f;
  }

  // ---- 8

  Said cover(Keys& k) {
    const Family& x = family(k);
    for (const Node& n : k.at("symmetries").items())
      symmetries_.push_back(&of_kind(n, x, FactKind::symmetry, FactKind::symmetry));
    for (const Node& n : k.at("parts").items())
      parts_.push_back(&part_about(n, x));
    Said all{FactKind::not_integrable, &x, {{}}};
    for (const TheoremFact* f : parts_)
      for (const IntegralClass& c : f->classes)
        add_least(c, all.classes);
    need(!all.classes.empty() ||
             std::ranges::any_of(parts_,
                                 [](const auto* f) { return f->kind == FactKind::integrable; }),
         "nothing says that it is not integrable");
    ConditionSet given = x.where(x.assumptions, arithmetic_);
    SetProof(given, nodes_).absent(k.at("tree"), [&](const Node& n, ConditionSet& here) {
      part(n, here);
    });
    return all;
  }
  // Integrals of a class are of each one that contains it: that one is not named beside it.
  static void add_least(const IntegralClass& c, std::vector<IntegralClass>& all) {
    const auto is_part = [](const IntegralClass& inner, const IntegralClass& outer) {
      return inner == outer || (inner.through.empty() && contains(outer, inner) == Truth::yes);
    };
    if (std::ranges::any_of(all, [&](const auto& known) { return is_part(known, c); })) return;
    std::erase_if(all, [&](const auto& known) { return is_part(c, known); });
    all.push_back(c);
  }
  const TheoremFact& of_kind(const Node& n, const Family& x, FactKind one, FactKind other) {
    const TheoremFact& f = fact(n);
    need_kind(f, f.kind == one || f.kind == other);
    need(f.family == &x, "a step is about another system");
    return f;
  }
  const TheoremFact& part_about(const Node& n, const Family& x) {
    const TheoremFact& f = fact(n);
    need_kind(f, f.kind != FactKind::symmetry && f.kind != FactKind::leaves);
    need(f.family == &x, "a step is about another system");
    return f;
  }

  void part(const Node& n, ConditionSet& given) {
    Keys k(n);
    if (k.at("node").text() != "part") n.fail("an unknown node");
    const TheoremFact& f = *parts_[index(k.at("part"), parts_.size(), "no such part")];
    const auto word = k.at("word").items(), shown = k.at("shown").items();
    need(word.size() <= max_word, "no such part");
    Conditions region =
        f.regions[f.several ? index(k.at("region"), f.regions.size(), "no such region") : 0];
    for (const Node& w : word) {
      const TheoremFact& s = *symmetries_[index(w, symmetries_.size(), "no such symmetry")];
      led_.insert(&f);
      for (const IntegralClass& c : f.classes)
        static_cast<void>(s.map->carried(c));
      region = s.map->before(region);
      region.insert(region.end(), s.regions.front().begin(), s.regions.front().end());
    }
    if (shown.size() != region.size()) n.fail("each condition of the part must be shown");
    SetProof proof(given, nodes_);
    for (std::size_t i = 0; i < shown.size(); ++i)
      proof.show(region[i], shown[i]);
    k.done();
  }
  static std::size_t index(const Node& n, std::size_t size, const char* why) {
    const long i = n.count();
    need(i >= 0 && static_cast<std::size_t>(i) < size, why);
    return static_cast<std::size_t>(i);
  }

  Node top_;
  std::vector<std::unique_ptr<Family>> families_;
  Facts facts_;
  std::vector<const TheoremFact*> parts_, symmetries_;
  std::set<const TheoremFact*> led_; ///< parts to which a symmetry leads
  const TheoremFact* last_ = nullptr;
  Arithmetic arithmetic_;
  std::size_t nodes_ = max_proof_nodes;
};

} // namespace

Family read_family(const Node& n, Arithmetic& a) {
  Keys k(n);
  Family f;
  f.name = k.at("name").text();
  std::vector<std::string> parameters;
  for (const Node& x : k.at("parameters").items())
    parameters.push_back(x.text());
  if (parameters.size() > max_parameters) n.fail("too many parameters");
  const Node system = k.at("system");
  f.system = read_phase_system(system, parameters);
  if (const auto complex = k.find("complex")) {
    f.complex.assign(f.system.ring->size(), false);
    for (const Node& x : complex->items()) {
      const auto i = f.system.ring->find(x.text());
      if (!i || !f.is_parameter(*i) || f.complex[*i]) x.fail("a parameter is expected");
      f.complex[*i] = true;
    }
  }
  const PhaseSpace space(f.system, a);
  space.need_symbols();
  static_cast<void>(space.field());
  f.assumptions = f.region(k.at("assumptions"));
  if (const auto lagrangian = k.find("lagrangian"))
    f.lagrangian = read_lagrangian(*lagrangian, f.system, a);
  k.done();
  const std::vector<bool> used = used_names(f.system);
  for (std::size_t i = f.system.first_inverse(); i < f.system.first_parameter(); ++i)
    need(used[i], "an inverse that is not one of the system");
  return f;
}

std::variant<TheoremAccepted, Rejected> check_theorem(std::string_view text) {
  const Json json = parse_json(text, max_json_depth);
  const FileMeter all_steps;
  const CheckedSteps::File file;
  return Steps(Node(json, "certificate", rationals()))();
}

} // namespace kov::certify
