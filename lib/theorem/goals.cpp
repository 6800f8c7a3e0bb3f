#include "theorem/goals.hpp"

#include "exact/error.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "literature/literature.hpp"
#include "study/parameter_split.hpp"
#include "theorem/setting.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace kov {
namespace {

using Texts = std::vector<std::string>;
using Strata = std::vector<const ClassifiedStratum*>;

std::string list_of(const Texts& all) {
  std::string text = joined(all, [&](const std::string& one) { return toml_text(one); });
  return "[" + text + "]";
}
std::string single_line(std::string s) {
  for (char& c : s)
    if (c == '\n' || c == '\t') c = ' ';
  return s;
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

bool has_common_points(const ParameterSet& a, const ParameterSet& b) {
  ParameterSet both = a;
  for (const MPoly& f : b.equations())
    both = both.where_zero(f);
  for (const MPoly& f : b.inequations())
    both = both.where_nonzero(f);
  return !both.is_empty();
}

// Strata with conditions that no polynomial can say.  Those without a common point, but for these conditions,
// are told apart: they may exclude other classes.
std::vector<Strata> special_strata(const SystemClassification& c) {
  std::vector<Strata> groups;
  for (const ClassifiedStratum& x : c.strata) {
    if (x.special.empty()) continue;
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

class TheoremFile {
public:
  TheoremFile(const System& s, const SystemClassification& c, std::string system_file)
      : s_(s), c_(c), file_(std::move(system_file)) {}

  std::string operator()() {
    find_constants();
    for (const ClassifiedStratum& x : c_.strata)
      if (x.special.empty() && x.status == StratumStatus::integrable) put_integrable(x);
    put_excluded();
    put_open();
    for (const Strata& special : special_strata(c_))
      put_special(special);
    if (ids_.empty()) throw DomainError("there is no stratum");
    std::ostringstream out;
    out << "format = \"theorem/1\"\ntitle  = "
        << toml_text(single_line(s_.title.empty() ? "The system of " + file_ : s_.title))
        << "\nsystem = " << toml_text(file_) << "\n";
    if (!constants_.empty()) {
      out << "\n[algebraic]\n";
      for (const auto& [name, polynomial] : constants_)
        out << name << " = " << toml_text(polynomial) << "\n";
    }
    out << "\n[[node]]\nid    = \"main\"\nkind  = \"cover\"\ntitle = \"The strata\"\nneeds = "
        << list_of(ids_) << "\n"
        << nodes_.str();
    return out.str();
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
            used_variables(p).size() > 1)
          throw DomainError("the constant " + name + " is not a root of a polynomial with numbers");
      }
  }
  [[nodiscard]] bool is_known(const std::string& name) const {
    return is_of_the_file(name) || constants_.contains(name);
  }
  std::string id_of(const char* kind) {
    const std::string id = std::string(kind) + "-" + std::to_string(++count_[kind]);
    ids_.push_back(id);
    return id;
  }

  // ---- sets

  [[nodiscard]] bool is_assumed(const MPoly& p) const {
    return std::ranges::any_of(c_.nonzero, [&](const MPoly& q) { return q == p || q == -p; });
  }
  [[nodiscard]] bool is_relation(const MPoly& p) const {
    return std::ranges::any_of(c_.relations, [&](const MPoly& q) { return q == p || q == -p; });
  }
  [[nodiscard]] Where where_of(const ParameterSet& set) const {
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
      if (!is_relation(p)) w.conditions.push_back(to_string(Condition{p, Sign::zero}));
    for (const MPoly& p : kov::inequations(set))
      if (!is_assumed(p)) w.conditions.push_back(to_string(Condition{p, Sign::nonzero}));
    return w;
  }
  void put_where(const Where& w) {
    if (!w.at.empty()) {
      std::string values;
      for (const auto& [name, value] : w.at)
        values += (values.empty() ? "" : ", ") + name + " = " + toml_text(value);
      nodes_ << "where = { " << values << " }\nat    = { " << values << " }\n";
    }
    if (!w.conditions.empty()) nodes_ << "if    = " << list_of(w.conditions) << "\n";
  }
  static std::string title_of(const Where& w) {
    std::string text = joined(w.all());
    return text.empty() ? "all parameters" : text;
  }
  void begin(const char* id, const char* kind, const std::string& title) {
    nodes_ << "\n[[node]]\nid    = " << toml_text(id_of(id)) << "\nkind  = \"" << kind
           << "\"\ntitle = " << toml_text(single_line(title)) << "\n";
  }

  // ---- strata

  // Few sets with the same union.
  [[nodiscard]] std::vector<Where> few(const std::vector<const ClassifiedStratum*>& all) const {
    std::vector<ParameterPlace> places;
    for (const ClassifiedStratum* x : all)
      places.push_back({x->where, {}});
    std::vector<Where> wheres;
    for (const ParameterPlace& p : in_few_words(std::move(places), c_.nonzero))
      wheres.push_back(where_of(p.where));
    return wheres;
  }
  void put_regions(const std::vector<Where>& all) {
    std::string regions = joined(all, [&](const Where& w) { return list_of(w.all()); });
    nodes_ << "regions = [" << regions << "]\n";
  }
  static std::string title_of(const std::vector<Where>& all) {
    return joined(
        all, [&](const Where& w) { return title_of(w); }, "; or ");
  }
  void put_open() {
    std::vector<const ClassifiedStratum*> open;
    for (const ClassifiedStratum& x : c_.strata)
      if (x.special.empty() && x.status == StratumStatus::open) open.push_back(&x);
    if (open.empty()) return;
    const auto wheres = few(open);
    begin("open", "open", "Open: " + title_of(wheres));
    put_regions(wheres);
  }

  void put_integrable(const ClassifiedStratum& x) {
    const Where w = where_of(x.where);
    const bool has_logarithms = std::ranges::any_of(
        x.integrals, [](const FoundIntegral& f) { return !f.logarithms.empty(); });
    const std::string step = "the first integrals " + integrals_text(x);
    if (has_logarithms || !c_.variables.empty()) {
      begin("integrable", "trusted", "Integrable: " + title_of(w));
      nodes_ << "integrable = true\nstep  = " << toml_text(single_line(step)) << "\nregions = ["
             << list_of(w.all()) << "]\n";
      return;
    }
    begin("integrable", "claims", "Integrable: " + title_of(w));
    nodes_ << "file  = " << toml_text(file_)
           << "\nintegrable = true\nstep  = " << toml_text(single_line(step)) << "\n";
    put_where(w);
    if (!x.field_components.empty()) {
      std::string rows;
      for (const auto& row : x.field_components) {
        Texts entries;
        for (const MFraction& f : row)
          entries.push_back(to_string(f));
        rows += (rows.empty() ? "" : ", ") + list_of(entries);
      }
      nodes_ << "fields = [" << rows << "]\n";
    }
    std::size_t k = 0;
    for (const FoundIntegral& f : x.integrals)
      nodes_ << "[[node.integral]]\nname  = " << toml_text(fresh("I" + std::to_string(++k)))
             << "\nvalue = " << toml_text(to_string(f.value)) << "\n";
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
    return single_line(text);
  }
  void put_class(const IntegralClass& c) {
    Texts symbols;
    for (const auto& [coordinate, symbol] : c.through)
      add_once(symbols, symbol);
    std::string text = "kind = " + toml_text(std::string(word_of(c.kind))) +
                       ", near = " + toml_text(std::string(word_of(c.near)));
    if (c.on_leaf) text += ", on_leaf = true";
    if (!c.liouville) text += ", liouville = false";
    if (!c.functions.empty()) text += ", functions = " + list_of(c.functions);
    if (!c.without.empty()) text += ", without = " + list_of(c.without);
    if (!symbols.empty()) text += ", through = " + list_of(symbols);
    if (!c.frame.empty()) text += ", frame = " + toml_text(c.frame);
    nodes_ << "integrals = { " << text << " }\n";
  }

  [[nodiscard]] bool is_case(const ClassifiedStratum& x) const {
    return x.along && c_.variables.empty() && x.by.front().unchecked.empty();
  }
  // Are both along one set, at one order?  A step that excludes one of them may exclude all.
  [[nodiscard]] bool are_together(const ClassifiedStratum& x, const ClassifiedStratum& y) const {
    const ExclusionReason &a = x.by.front(), &b = y.by.front();
    if (is_case(x) != is_case(y) || !(a.integrals == b.integrals) || a.unchecked != b.unchecked)
      return false;
    if (!is_case(x)) return step_of(a) == step_of(b);
    return a.solution == b.solution && a.order == b.order &&
           equations_of(x.along->levels) == equations_of(y.along->levels);
  }
  void put_excluded() {
    std::vector<std::vector<const ClassifiedStratum*>> groups;
    for (const ClassifiedStratum& x : c_.strata) {
      if (!x.special.empty() || x.status != StratumStatus::excluded) continue;
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
      if (const std::string step = step_of(x->by.front()); !is_among(step, steps))
        steps.push_back(step);
    return joined(steps, "; ");
  }
  void put_trusted(const std::vector<const ClassifiedStratum*>& group) {
    const auto wheres = few(group);
    begin("excluded", "trusted", "Not integrable: " + title_of(wheres));
    nodes_ << "step  = " << toml_text(step_of(group.front()->by.front())) << "\n";
    put_class(group.front()->by.front().integrals);
    put_darboux(group.front()->by.front());
    put_regions(wheres);
  }
  // For these there is a rule.
  bool put_darboux(const ExclusionReason& by) {
    const auto rests_on = [&](Trusted::Step step) {
      return std::ranges::any_of(by.trusted, [&](const Trusted& t) { return t.step == step; });
    };
    const auto uses = [&](const LiteratureTheorem& t) { return is_among(&t, by.theorems); };
    const bool relation = rests_on(Trusted::Step::darboux_eigenvalues);
    if (!relation && !rests_on(Trusted::Step::darboux_logarithm)) return false;
    nodes_ << "darboux = \"" << (relation ? "relation" : "multiple") << "\"\npart = \""
           << (uses(ziglin_highest())  ? "highest"
               : uses(ziglin_lowest()) ? "lowest"
                                       : "all")
           << "\"\n";
    return true;
  }
  void put_cases(const std::vector<const ClassifiedStratum*>& group) {
    const ExclusionReason& by = group.front()->by.front();
    for (const Where& w : few(group)) {
      begin("excluded", "case", "Not integrable: " + title_of(w));
      nodes_ << "step  = " << toml_text(steps_of(group)) << "\n";
      put_class(by.integrals);
      nodes_ << "file  = " << toml_text(file_) << "\n";
      if (by.order > 1) nodes_ << "order = " << by.order << "\n";
      put_where(w);
      put_manifold(*group.front()->along);
    }
  }
  void put_manifold(const ManifoldSpec& m) {
    const auto stated = [&](const ManifoldSpec& known) { return known.name == m.name; };
    if (m.line > 0 && std::ranges::any_of(s_.manifolds, stated)) {
      nodes_ << "manifold = " << toml_text(m.name) << "\n";
      return;
    }
    Texts levels;
    for (const auto* all : {&m.equations, &m.levels})
      for (const Equation& e : *all)
        for (const std::size_t i : used_variables(e.difference)) {
          const std::string& name = e.difference.ring()->name(i);
          if (!is_known(name) && !is_among(name, levels)) levels.push_back(name);
        }
    if (!levels.empty()) nodes_ << "levels = " << list_of(levels) << "\n";
    Texts equations; // their texts are for people: with derivatives
    for (const Equation& e : m.equations)
      equations.push_back(zero(e));
    nodes_ << "[[node.manifold]]\nname  = " << toml_text(single_line(m.name))
           << "\nequations = " << list_of(equations) << "\n";
    if (!m.levels.empty()) nodes_ << "level = " << list_of(equations_of(m.levels)) << "\n";
    if (!m.nonzero.empty()) {
      Texts nonzero;
      for (const MPoly& p : m.nonzero)
        nonzero.push_back(to_string(p));
      nodes_ << "nonzero = " << list_of(nonzero) << "\n";
    }
  }
  static std::string zero(const Equation& e) { return to_string(e.difference) + " = 0"; }
  static Texts equations_of(const std::vector<Equation>& all) {
    Texts texts;
    for (const Equation& e : all)
      texts.push_back(e.text.find('=') != std::string::npos ? e.text : zero(e));
    return texts;
  }

  // ---- strata with conditions that no polynomial can say

  // If there are no others: what their exceptions are is covered by other strata, or by one another.
  void put_special(const Strata& special) {
    const std::vector<ParameterSet> left = united(without_others(special));
    if (left.empty()) return;
    Texts regions;
    for (const ParameterSet& set : left)
      regions.push_back(list_of(where_of(set).all()));
    std::string all = joined(regions);
    if (!std::ranges::all_of(special, is_excluded)) {
      begin("open", "open", "Open for some values of exponent differences");
      nodes_ << "regions = [" << all << "]\n";
      return;
    }
    Texts steps;
    std::vector<IntegralClass> classes;
    for (const ClassifiedStratum* x : special) {
      const std::string step = step_of(x->by.front());
      add_once(steps, step);
      classes.push_back(x->by.front().integrals);
    }
    classes = at_once(classes);
    if (classes.size() != 1)
      throw DomainError("strata with exceptional exponent differences for several classes of "
                        "first integrals");
    std::string text = "exponent differences are special at the other strata only";
    for (const std::string& step : steps)
      text += "; " + step;
    begin("excluded", "trusted", "Not integrable: exponent differences");
    nodes_ << "step  = " << toml_text(text) << "\n";
    put_class(classes.front());
    // The rule for Darboux points may exclude all of it by itself.
    for (const ClassifiedStratum* x : special)
      if (put_darboux(x->by.front())) break;
    nodes_ << "regions = [" << all << "]\n";
  }
  [[nodiscard]] std::vector<ParameterSet> without_others(const Strata& special) const {
    std::vector<ParameterSet> left;
    const MayVanish any = [](const MPoly&) { return true; };
    for (const ClassifiedStratum* x : special) {
      std::vector<ParameterSet> parts{x->where};
      for (const ClassifiedStratum& other : c_.strata) {
        if (!other.special.empty()) continue;
        std::vector<std::vector<MPoly>> nonzero;
        for (const MPoly& p : other.where.inequations())
          nonzero.push_back({p});
        std::vector<ParameterSet> outside;
        for (const ParameterSet& part : parts)
          for (ParameterSet& set : split_set(part, other.where.equations(), nonzero, any).outside)
            if (!set.is_empty()) outside.push_back(std::move(set));
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
  Texts ids_;
  std::ostringstream nodes_;
};

} // namespace

Strata beside_the_theorem(const SystemClassification& c) {
  Strata all;
  for (const Strata& special : special_strata(c))
    if (!std::ranges::all_of(special, is_excluded))
      std::ranges::copy_if(special, std::back_inserter(all), is_excluded);
  return all;
}

std::string theorem_file(const System& s, const SystemClassification& c,
                         const std::string& system_file) {
  return TheoremFile(s, c, system_file)();
}

} // namespace kov
