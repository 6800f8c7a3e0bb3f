#include "theorem/goals.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "literature/literature.hpp"
#include "parameters/set.hpp"
#include "symbol/author_words.hpp"
#include "symbol/suggest.hpp"
#include "theorem/setting.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace kov {
namespace {

using Texts = std::vector<std::string>;
using Strata = std::vector<const ClassifiedStratum*>;

// Their own texts are for people: with derivatives.
std::string zero(const Equation& e) { return to_string(e.difference) + " = 0"; }
Texts equations_of(const std::vector<Equation>& all) {
  Texts texts;
  for (const Equation& e : all)
    texts.push_back(e.text.find('=') != std::string::npos ? e.text : zero(e));
  return texts;
}

/// The place of a stratum: values of parameters, and conditions.
struct Where {
  ParameterValues at;
  Texts conditions;

  [[nodiscard]] Texts all() const {
    Texts texts;
    for (const auto& [name, value] : at)
      texts.push_back(name + " = " + value);
    texts.insert(texts.end(), conditions.begin(), conditions.end());
    return texts;
  }
};

bool has_common_points(const Set& a, const Set& b) { return !a.within(b).is_empty(); }

// Strata with conditions that no polynomial can say.  Those without a common point, but for these conditions,
// are told apart: they may exclude other classes.
std::vector<Strata> special_strata(const SystemClassification& c) {
  std::vector<Strata> groups;
  for (const ClassifiedStratum& x : c.strata) {
    if (x.where.is_algebraic()) continue;
    Strata together{&x};
    std::erase_if(groups, [&](const Strata& g) {
      const bool meets = std::ranges::any_of(
          g, [&](const ClassifiedStratum* y) { return has_common_points(x.where, y->where); });
      if (meets) together.insert(together.end() - 1, g.begin(), g.end());
      return meets;
    });
    groups.push_back(std::move(together));
  }
  return groups;
}

bool is_excluded(const ClassifiedStratum* x) { return x->status == StratumStatus::excluded; }

class Goals {
public:
  Goals(const System& s, const SystemClassification& c, std::string system_file)
      : s_(s), c_(c), file_(std::move(system_file)) {}

  Theorem operator()() {
    t_.title = one_line(s_.title.empty() ? "The system of " + file_ : s_.title);
    t_.system = file_;
    find_constants();
    t_.algebraic.assign(constants_.begin(), constants_.end());
    TheoremNode& cover = t_.nodes.emplace_back();
    cover.id = "main";
    cover.kind = NodeKind::cover;
    cover.title = "The strata";
    for (const ClassifiedStratum& x : c_.strata)
      if (x.where.is_algebraic() && x.status == StratumStatus::integrable) put_integrable(x);
    put_excluded();
    put_open();
    for (const Strata& special : special_strata(c_))
      put_special(special);
    if (t_.nodes.size() == 1) throw DomainError("there is no stratum");
    for (std::size_t k = 1; k < t_.nodes.size(); ++k) {
      t_.nodes[k].algebraic = t_.algebraic;
      t_.nodes.front().needs.push_back(t_.nodes[k].id);
    }
    return std::move(t_);
  }

private:
  // ---- names

  [[nodiscard]] bool is_of_the_file(const std::string& name) const {
    return s_.ring()->find(name).has_value();
  }
  // Finds the constants in which the sets are written beside the parameters of the file.
  void find_constants() {
    for (const MPoly& p : c_.relations)
      for (const std::size_t i : used_variables(p)) {
        const std::string name = p.ring()->name(i);
        if (!is_of_the_file(name) && constants_.emplace(name, to_string(p)).second &&
            !is_constant(coefficients(p, i).back()))
          throw DomainError("the constant " + name + " does not exist for all parameters");
      }
  }
  [[nodiscard]] bool is_known(const std::string& name) const {
    return is_of_the_file(name) || constants_.contains(name);
  }

  // ---- sets

  static bool is_one_of(const MPoly& p, const std::vector<MPoly>& all) {
    return is_among(p, all) || is_among(-p, all);
  }
  [[nodiscard]] Where where_of(const Set& set) const {
    Where w;
    SolvedSet solved = solve(set);
    for (const auto& [i, value] : solved.values) {
      const std::string& name = set.ring()->name(i);
      if (is_zero(value) || is_constant(value.den()))
        w.at.emplace_back(name, to_string(value));
      else
        solved.left.push_back(MPoly::variable(set.ring(), i) * value.den() - value.num());
    }
    for (const MPoly& p : solved.left)
      if (!is_one_of(p, c_.relations)) w.conditions.push_back(to_string(Condition{p, Sign::zero}));
    for (const MPoly& p : kov::inequations(set))
      if (!is_one_of(p, c_.nonzero)) w.conditions.push_back(to_string(Condition{p, Sign::nonzero}));
    return w;
  }
  static void put_where(TheoremNode& n, const Where& w) {
    n.where = n.place.at = w.at;
    n.place.conditions = w.conditions;
  }
  static std::string title_of(const Where& w) {
    const std::string text = enumerate(w.all());
    return text.empty() ? "all parameters" : text;
  }
  // A set whose conditions are among those of another one has all of its points.
  static std::string title_of(const std::vector<Where>& all) {
    const auto has = [](const Where& wide, const Where& w) {
      return std::ranges::all_of(
          wide.all(), [own = w.all()](const std::string& c) { return is_among(c, own); });
    };
    std::vector<Where> widest;
    for (const Where& w : all) {
      if (std::ranges::any_of(widest, [&](const Where& x) { return has(x, w); })) continue;
      std::erase_if(widest, [&](const Where& x) { return has(w, x); });
      widest.push_back(w);
    }
    return joined(
        widest, [](const Where& w) { return title_of(w); }, "; or ");
  }
  TheoremNode& begin(const char* id, NodeKind kind, const std::string& title) {
    TheoremNode& n = t_.nodes.emplace_back();
    n.id = std::string(id) + "-" + std::to_string(++count_[id]);
    n.kind = kind;
    n.title = one_line(title);
    return n;
  }

  // ---- strata

  // Few sets with the same union.
  [[nodiscard]] std::vector<Set> few_places(const Strata& all) const {
    auto places = mapped<Set>(all, [&](const ClassifiedStratum* x) { return x->where; });
    return in_few_words(std::move(places), c_.nonzero);
  }
  [[nodiscard]] std::vector<Where> few(const Strata& all) const {
    return mapped<Where>(few_places(all), [&](const Set& p) { return where_of(p); });
  }
  // The stratum in this set with the fewest equations: what is written in its parameters holds on all of the set.
  static const ClassifiedStratum& most_general(const Strata& all, const Set& set) {
    const ClassifiedStratum* best = nullptr;
    const auto lies_in_it = [&](const Set& where) {
      const auto& equations = set.equations();
      return std::ranges::all_of(equations, [&](const MPoly& f) { return where.vanishes(f); });
    };
    for (const ClassifiedStratum* x : all)
      tried<OutOfBudget>([&] {
        if (lies_in_it(x->where) &&
            (!best || x->where.equations().size() < best->where.equations().size()))
          best = x;
      });
    return best ? *best : *all.front();
  }
  static void put_regions(TheoremNode& n, const std::vector<Where>& all) {
    for (const Where& w : all)
      add_once(n.regions, w.all());
  }
  void put_open() {
    std::vector<const ClassifiedStratum*> open;
    for (const ClassifiedStratum& x : c_.strata)
      if (x.where.is_algebraic() && x.status == StratumStatus::open) open.push_back(&x);
    if (open.empty()) return;
    const auto wheres = few(open);
    put_regions(begin("open", NodeKind::open_part, "Open: " + title_of(wheres)), wheres);
  }

  void put_integrable(const ClassifiedStratum& x) {
    const Where w = where_of(x.where);
    const bool has_logarithms = std::ranges::any_of(
        x.integrals, [](const FoundIntegral& f) { return !f.logarithms.empty(); });
    const bool is_checked = !has_logarithms && is_in_our_variables();
    TheoremNode& n = begin("integrable", is_checked ? NodeKind::claims : NodeKind::trusted,
                           "Integrable: " + title_of(w));
    n.integrable = true;
    n.step = one_line("the first integrals " + integrals_text(x));
    if (!is_checked) return put_regions(n, {w});
    n.file = file_;
    put_where(n, w);
    n.found.fields = x.field_components;
    for (const FoundIntegral& f : x.integrals)
      n.found.integrals.emplace_back(fresh("I" + std::to_string(n.found.integrals.size() + 1)),
                                     f.value);
  }
  [[nodiscard]] std::string fresh(std::string name) const {
    while (is_known(name) || s_.named.contains(name))
      name += "_";
    return name;
  }

  static std::string step_of(const ExclusionReason& by) {
    std::string text = "along " + by.solution +
                       (by.level.empty() ? "" : " (" + sentence(by.level) + ")") + ": " + by.reason;
    if (!by.unchecked.empty()) text += "; NOT CHECKED: " + by.unchecked;
    return one_line(text);
  }
  [[nodiscard]] bool is_in_our_variables() const {
    return c_.variables.empty() || c_.are_curves_old;
  }
  [[nodiscard]] bool is_case(const ClassifiedStratum& x) const {
    return x.along && is_in_our_variables();
  }
  // Are both along one set, at one order?  A step that excludes one of them may exclude all.
  [[nodiscard]] bool are_together(const ClassifiedStratum& x, const ClassifiedStratum& y) const {
    const ExclusionReason &a = x.by.front(), &b = y.by.front();
    if (is_case(x) != is_case(y) || !(a.integrals == b.integrals) || a.unchecked != b.unchecked ||
        x.splitting != y.splitting)
      return false;
    if (!is_case(x)) return step_of(a) == step_of(b);
    return a.solution == b.solution && a.order == b.order &&
           equations_of(x.along->levels) == equations_of(y.along->levels);
  }
  void put_excluded() {
    std::vector<std::vector<const ClassifiedStratum*>> groups;
    for (const ClassifiedStratum& x : c_.strata) {
      if (!x.where.is_algebraic() || x.status != StratumStatus::excluded) continue;
      const auto known =
          std::ranges::find_if(groups, [&](const auto& g) { return are_together(*g.front(), x); });
      known == groups.end() ? groups.push_back({&x}) : known->push_back(&x);
    }
    for (const auto& group : groups)
      is_case(*group.front()) ? put_cases(group) : put_trusted(group);
  }
  // The steps of several strata, each once.
  static std::string steps_of(const std::vector<const ClassifiedStratum*>& group) {
    Texts steps;
    for (const ClassifiedStratum* x : group)
      add_once(steps, step_of(x->by.front()));
    return joined(steps, "; ");
  }
  void put_trusted(const std::vector<const ClassifiedStratum*>& group) {
    const auto wheres = few(group);
    const ExclusionReason& by = group.front()->by.front();
    TheoremNode& n = begin("excluded", NodeKind::trusted, "Not integrable: " + title_of(wheres));
    n.step = step_of(by);
    n.integrals = by.integrals;
    if (c_.variables.empty()) n.found.splitting = group.front()->splitting;
    for (const ClassifiedStratum* x : group)
      put_lowest(n, *x);
    put_darboux(n, by);
    put_regions(n, wheres);
  }
  static void put_lowest(TheoremNode& n, const ClassifiedStratum& x) {
    if (!x.from || !x.lowest) return;
    n.found.lowest = x.lowest;
    add_once(n.found.special, x.from);
  }
  // For these there is a rule.
  static bool put_darboux(TheoremNode& n, const ExclusionReason& by) {
    const auto rests_on = [&](Trusted::Step step) {
      return std::ranges::any_of(by.trusted, [&](const Trusted& t) { return t.step == step; });
    };
    const auto uses = [&](const LiteratureTheorem& t) { return is_among(&t, by.theorems); };
    const bool relation = rests_on(Trusted::Step::darboux_eigenvalues);
    if (!relation && !rests_on(Trusted::Step::darboux_logarithm)) return false;
    n.darboux = relation ? "relation" : "multiple";
    n.part = uses(ziglin_highest()) ? "highest" : uses(ziglin_lowest()) ? "lowest" : "all";
    return true;
  }
  void put_cases(const std::vector<const ClassifiedStratum*>& group) {
    const ExclusionReason& by = group.front()->by.front();
    for (const Set& p : few_places(group)) {
      const Where w = where_of(p);
      TheoremNode& n = begin("excluded", NodeKind::case_file, "Not integrable: " + title_of(w));
      n.step = steps_of(group);
      n.integrals = by.integrals;
      n.file = file_;
      n.order = by.order;
      put_where(n, w);
      put_manifold(n, *most_general(group, p).along);
      for (const ClassifiedStratum* x : group)
        if (x->from) {
          add_once(n.found.studies, x->from);
          n.found.change = x->change;
        }
      n.found.carried = n.found.studies.empty() && by.carried;
    }
  }
  void put_manifold(TheoremNode& n, const ManifoldSpec& m) const {
    const auto stated = [&](const ManifoldSpec& known) { return known.name == m.name; };
    if (m.line > 0 && std::ranges::any_of(s_.manifolds, stated)) {
      n.manifold = m.name;
      return;
    }
    put_found_manifold(n, m);
  }
  void put_found_manifold(TheoremNode& n, const ManifoldSpec& m) const {
    const std::string name = one_line(m.name);
    for (const ManifoldSpec& known : n.found.along)
      if (known.name == name) return;
    n.found.along.push_back(m);
    n.found.along.back().name = name;
    for (const auto* all : {&m.equations, &m.levels})
      for (const Equation& e : *all)
        for (const std::size_t i : used_variables(e.difference))
          if (const std::string& name = e.difference.ring()->name(i); !is_known(name))
            add_once(n.values, name);
  }

  // ---- strata with conditions that no polynomial can say

  // If there are no others: what their exceptions are is covered by other strata, or by one another.
  void put_special(const Strata& special) {
    const std::vector<Set> left = united(without_others(special));
    if (left.empty()) return;
    auto wheres = mapped<Where>(left, [&](const Set& set) { return where_of(set); });
    if (!std::ranges::all_of(special, is_excluded))
      return put_regions(
          begin("open", NodeKind::open_part, "Open for some values of exponent differences"),
          wheres);
    const auto classes = at_once(mapped<IntegralClass>(
        special, [](const ClassifiedStratum* x) { return x->by.front().integrals; }));
    if (classes.size() != 1)
      throw DomainError("strata with exceptional exponent differences for several classes of "
                        "first integrals");
    TheoremNode& n = begin("excluded", NodeKind::trusted, "Not integrable: " + title_of(wheres));
    n.step = "exponent differences are special at the other strata only; " + steps_of(special);
    n.integrals = classes.front();
    for (const ClassifiedStratum* x : special) {
      if (!x->from || x->change) continue;
      add_once(n.found.special, x->from);
      n.found.lowest = x->lowest;
      if (!is_case(*x)) continue;
      n.file = file_;
      put_found_manifold(n, *x->along);
    }
    // The rule for Darboux points may exclude all of it by itself.
    for (const ClassifiedStratum* x : special)
      if (put_darboux(n, x->by.front())) break;
    put_regions(n, wheres);
  }
  [[nodiscard]] std::vector<Set> without_others(const Strata& special) const {
    std::vector<Set> left;
    const MayVanish any = [](const MPoly&) { return true; };
    for (const ClassifiedStratum* x : special) {
      std::vector<Set> parts{x->where.without_statements()};
      for (const ClassifiedStratum& other : c_.strata) {
        if (!other.where.is_algebraic()) continue;
        std::vector<Set> outside;
        for (const Set& part : parts) {
          CutParts cut = split(part, cut_of(other.where), any);
          if (cut.inside.empty()) {
            outside.push_back(part); // as it is: it need not be cut
            continue;
          }
          for (Set& set : cut.outside)
            if (!set.is_empty()) outside.push_back(std::move(set));
        }
        parts = std::move(outside);
      }
      std::move(parts.begin(), parts.end(), std::back_inserter(left));
    }
    return left;
  }

  const System& s_;
  const SystemClassification& c_;
  std::string file_;
  std::map<std::string, std::string> constants_;
  std::map<std::string, std::size_t> count_;
  Theorem t_;
};

/// Goals as a theorem file, for people.
class TheoremFile {
public:
  explicit TheoremFile(const Theorem& t) : t_(t) {}

  std::string operator()() {
    out_ << "format = \"theorem/1\"\ntitle  = " << toml_text(t_.title)
         << "\nsystem = " << toml_text(t_.system) << "\n";
    if (!t_.algebraic.empty()) out_ << "\n[algebraic]\n";
    for (const auto& [name, polynomial] : t_.algebraic)
      out_ << name << " = " << toml_text(polynomial) << "\n";
    for (const TheoremNode& n : t_.nodes)
      put(n);
    return out_.str();
  }

private:
  void put(const TheoremNode& n) {
    out_ << "\n[[node]]\nid    = " << toml_text(n.id)
         << "\nkind  = " << toml_text(to_string(n.kind)) << "\ntitle = " << toml_text(n.title)
         << "\n";
    if (!n.needs.empty()) out_ << "needs = " << toml_list(n.needs) << "\n";
    if (!n.file.empty()) out_ << "file  = " << toml_text(n.file) << "\n";
    if (n.integrable) out_ << "integrable = true\n";
    if (!n.step.empty()) out_ << "step  = " << toml_text(n.step) << "\n";
    if (!n.integrable && !n.step.empty()) put_class(n.integrals);
    if (!n.darboux.empty())
      out_ << "darboux = " << toml_text(n.darboux) << "\npart = " << toml_text(n.part) << "\n";
    if (n.order > 1) out_ << "order = " << n.order << "\n";
    put_where(n);
    if (!n.regions.empty())
      out_ << "regions = [" << joined(n.regions, [](const Texts& all) { return toml_list(all); })
           << "]\n";
    if (!n.manifold.empty()) out_ << "manifold = " << toml_text(n.manifold) << "\n";
    if (!n.values.empty()) out_ << "levels = " << toml_list(n.values) << "\n";
    put_found(n.found);
  }
  void put_where(const TheoremNode& n) {
    const std::string values =
        joined(n.where, [](const auto& v) { return v.first + " = " + toml_text(v.second); });
    if (!values.empty()) out_ << "where = { " << values << " }\nat    = { " << values << " }\n";
    if (!n.place.conditions.empty()) out_ << "if    = " << toml_list(n.place.conditions) << "\n";
  }
  void put_class(const IntegralClass& c) {
    Texts symbols;
    for (const auto& [coordinate, symbol] : c.through)
      add_once(symbols, symbol);
    std::string text = "kind = " + toml_text(std::string(word_of(c.kind))) +
                       ", near = " + toml_text(std::string(word_of(c.near)));
    if (c.on_leaf) text += ", on_leaf = true";
    if (!c.liouville) text += ", liouville = false";
    if (!c.functions.empty()) text += ", functions = " + toml_list(c.functions);
    if (!c.without.empty()) text += ", without = " + toml_list(c.without);
    if (!symbols.empty()) text += ", through = " + toml_list(symbols);
    if (!c.frame.empty()) text += ", frame = " + toml_text(c.frame);
    out_ << "integrals = { " << text << " }\n";
  }
  void put_found(const FoundStep& found) {
    const auto texts = [](const auto& all) {
      return toml_list(mapped<std::string>(all, [](const auto& f) { return to_string(f); }));
    };
    if (!found.fields.empty()) out_ << "fields = [" << joined(found.fields, texts) << "]\n";
    for (const auto& [name, value] : found.integrals)
      out_ << "[[node.integral]]\nname  = " << toml_text(name)
           << "\nvalue = " << toml_text(to_string(value)) << "\n";
    for (const ManifoldSpec& m : found.along) {
      out_ << "[[node.manifold]]\nname  = " << toml_text(m.name)
           << "\nequations = " << toml_list(mapped<std::string>(m.equations, zero)) << "\n";
      if (!m.levels.empty()) out_ << "level = " << toml_list(equations_of(m.levels)) << "\n";
      if (!m.nonzero.empty()) out_ << "nonzero = " << texts(m.nonzero) << "\n";
    }
  }

  const Theorem& t_;
  std::ostringstream out_;
};

// The words of a case or of claims, without their check.
TheoremNode word_of(const TheoremNode& n) {
  TheoremNode word;
  word.kind = NodeKind::trusted;
  word.id = n.id;
  word.title = n.title;
  word.step = n.step;
  word.integrable = n.integrable;
  word.integrals = n.integrals;
  word.algebraic = n.algebraic;
  word.regions = {Where{n.place.at, n.place.conditions}.all()};
  return word;
}

} // namespace

Strata beside_the_theorem(const SystemClassification& c) {
  Strata all;
  for (const Strata& special : special_strata(c))
    if (!std::ranges::all_of(special, is_excluded))
      std::ranges::copy_if(special, std::back_inserter(all), is_excluded);
  return all;
}

Theorem goals(const System& s, const SystemClassification& c, const std::string& system_file) {
  return Goals(s, c, system_file)();
}

std::string theorem_file(Theorem goals, const std::string& system_file, ProveOptions options) {
  Theorem alone = goals;
  for (TheoremNode& n : alone.nodes)
    n.found.studies.clear(), n.found.carried = false;
  options.found = true;
  options.with_bundle = false;
  const TheoremResult again = prove(alone, options);
  goals.system = system_file;
  for (TheoremNode& n : goals.nodes) {
    if (node_with(again, n.id)->is_word) n = word_of(n);
    if (!n.file.empty()) n.file = system_file;
  }
  return TheoremFile(goals)();
}

} // namespace kov
