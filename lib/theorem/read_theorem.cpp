#include "exact/lists.hpp"
#include "theorem/setting.hpp"
#include "theorem/theorem.hpp"

#include "jets/obstruction.hpp"
#include "literature/literature.hpp"
#include "symbol/author_words.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace kov {
namespace {

const std::map<std::string, NodeKind>& kinds() {
  static const std::map<std::string, NodeKind> names{
      {"claims", NodeKind::claims},       {"case", NodeKind::case_file},
      {"splitting", NodeKind::splitting}, {"lowest-order", NodeKind::lowest_order},
      {"theorem", NodeKind::theorem},     {"cover", NodeKind::cover},
      {"argument", NodeKind::argument},   {"trusted", NodeKind::trusted},
      {"open", NodeKind::open_part}};
  return names;
}

NodeKind kind_of(const Entry& e) {
  const auto it = kinds().find(e.string());
  if (it != kinds().end()) return it->second;
  std::vector<std::string> known;
  for (const auto& [name, kind] : kinds())
    known.push_back(name);
  const auto near = nearest(e.string(), known);
  throw e.error("unknown kind '" + e.string() + "'",
                near ? "did you mean " + *near + "?" : "kinds: " + enumerate(known));
}

std::string text_of(const Entry& e, std::string_view key) {
  const Entry* found = e.find(key);
  return found ? one_line(found->string()) : "";
}

std::vector<std::string> texts_of(const Entry& e, std::string_view key) {
  std::vector<std::string> all;
  if (const Entry* found = e.find(key))
    for (const std::string& text : found->strings())
      all.push_back(one_line(text));
  return all;
}

ParameterValues read_values(const Entry& e, std::string_view key) {
  ParameterValues values;
  const Entry* table = e.find(key);
  if (!table) return values;
  if (!table->is_table())
    throw table->error(std::string(key) + " is a table of values",
                       std::string(key) + " = { A = \"2*C\" }");
  for (const auto& [name, value] : table->members())
    values.emplace_back(one_line(name), one_line(value.string()));
  return values;
}

// A sample lies in the family that `where` describes.
void check_sample(const Entry& e, const TheoremNode& n) {
  const Entry* sample = e.find("sample");
  for (const auto& [name, value] : n.where)
    if (const Entry* twice = sample ? sample->find(name) : nullptr)
      throw twice->key_error("'" + name + "' has a value in where already (" + value + ")",
                             "a sample gives values to the parameters that where leaves free");
}

Hypothesis read_hypothesis(const Entry& e) {
  e.check_keys({"text", "by"});
  return {one_line(e.at("text").string()), text_of(e, "by"), false};
}

int read_order(const Entry& e) {
  const long order = e.integer();
  if (order < 1 || order > jets::largest_order)
    throw e.error("an order of variational equations is expected",
                  "1 to " + std::to_string(jets::largest_order));
  return static_cast<int>(order);
}

std::string read_expected(const Entry& e) {
  const std::vector<std::string> known{"non-integrable", "no-obstruction", "depends", "any"};
  if (!is_among(e.string(), known))
    throw e.error("'" + e.string() + "' is not a verdict that a proof may end in",
                  "one of " + enumerate(known));
  return e.string();
}

// The keys of each kind, besides words: those that it must have, and those that it may have.
struct KeysOfKind {
  std::vector<std::string> must, may;
};

KeysOfKind keys_of(NodeKind kind) {
  switch (kind) {
  case NodeKind::claims:
    return {{"file"},
            {"where", "of", "at", "if", "as", "roots", "time", "integral", "integrable", "step",
             "fields"}};
  case NodeKind::case_file:
    return {{"file"},
            {"where", "sample", "manifold", "expect", "order", "of", "at", "if", "as", "roots",
             "time", "levels", "step", "integrals"}};
  case NodeKind::trusted:
    return {
        {"step"},
        {"regions", "integrals", "integrable", "darboux", "part", "file", "levels", "manifold"}};
  case NodeKind::open_part:
    return {{}, {"regions"}};
  case NodeKind::splitting:
    return {{"file", "small"},
            {"where", "families", "triangle", "of", "at", "if", "as", "roots", "time"}};
  case NodeKind::lowest_order:
    return {{"file", "other"}, {"where"}};
  case NodeKind::theorem:
    return {{}, {"theorem", "of", "at", "if", "as", "roots", "time"}};
  case NodeKind::cover:
    return {{"needs"}, {"at", "if"}};
  default:
    return {};
  }
}

const std::vector<std::string> keys_of_all{"id",   "title", "statement", "note",
                                           "kind", "needs", "cite",      "hypotheses"};

// A key that a step does not look at would be a promise that nobody keeps.
void check_keys_of_kind(const Entry& e, NodeKind kind) {
  const KeysOfKind keys = keys_of(kind);
  const std::string name = to_string(kind);
  for (const std::string& key : keys.must) {
    const Entry* found = e.find(key);
    if (!found) throw e.error("a node of kind '" + name + "' needs '" + key + "'");
    if (found->strings().empty() || found->strings().front().empty())
      throw found->error("'" + key + "' of a node of kind '" + name + "' is empty");
  }
  const auto is_looked_at = [&](const std::string& key) {
    return is_among(key, keys.must) || is_among(key, keys.may) || is_among(key, keys_of_all);
  };
  for (const auto& [key, value] : e.members())
    if (!is_looked_at(key))
      throw value.key_error("a node of kind '" + name + "' does not look at '" + key + "'");
}

// A theorem node that names one of literature() is that theorem.
const LiteratureTheorem* read_literature(const Entry& e) {
  const Entry* named = e.find("theorem");
  if (!named) return nullptr;
  if (const LiteratureTheorem* t = literature_theorem(named->string())) return t;
  auto known = mapped<std::string>(literature(), &LiteratureTheorem::id);
  const auto near = nearest(named->string(), known);
  throw named->error("'" + named->string() + "' is not a theorem that this program knows",
                     near ? "did you mean " + *near + "?" : "known: " + enumerate(known));
}

// Certificates are files of this name.
std::string read_id(const Entry& e) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  };
  const std::string& id = e.string();
  if (id.empty() || !std::ranges::all_of(id, allowed))
    throw e.error("an id consists of letters, digits, - and _", "the title may be anything");
  return id;
}

bool is_table_or_tables(const Entry* e) {
  return e != nullptr &&
         (e->is_table() || (e->is_array() && !e->array().empty() && e->array().front().is_table()));
}

IntegralClass read_class(const Entry& e) {
  const auto word = [&](const char* key, const auto& all, auto& value) {
    const Entry* given = e.find(key);
    if (!given) return;
    const auto found =
        std::ranges::find_if(all, [&](auto x) { return word_of(x) == given->string(); });
    if (found == all.end())
      throw given->error("'" + given->string() + "' is not a " + key + " of first integrals");
    value = *found;
  };
  e.check_keys(
      {"kind", "near", "on_leaf", "liouville", "functions", "without", "through", "frame"});
  IntegralClass c;
  word("kind", all_kinds, c.kind);
  word("near", all_places, c.near);
  if (const Entry* x = e.find("on_leaf")) c.on_leaf = x->boolean();
  if (const Entry* x = e.find("liouville")) c.liouville = x->boolean();
  c.functions = texts_of(e, "functions");
  c.without = texts_of(e, "without");
  for (const std::string& symbol : texts_of(e, "through"))
    c.through.emplace_back("", symbol);
  c.frame = text_of(e, "frame");
  return c;
}

std::vector<std::vector<std::string>> read_lists(const Entry& e, std::string_view key) {
  std::vector<std::vector<std::string>> all;
  if (const Entry* x = e.find(key))
    for (const Entry& list : x->array()) {
      all.emplace_back();
      for (const std::string& text : list.strings())
        all.back().push_back(one_line(text));
    }
  return all;
}

// Tables of a system file, what is trusted, and where.
void read_tables(const Entry& e, TheoremNode& n) {
  const bool manifold = is_table_or_tables(e.find("manifold"));
  if (!manifold) n.manifold = text_of(e, "manifold");
  if (manifold || is_table_or_tables(e.find("integral")))
    n.tables = e.only(manifold ? std::vector<std::string>{"manifold"}
                               : std::vector<std::string>{"integral"});
  n.values = texts_of(e, "levels");
  if (const Entry* x = e.find("integrable")) n.integrable = x->boolean();
  n.step = text_of(e, "step");
  n.darboux = text_of(e, "darboux");
  n.part = text_of(e, "part");
  if (!n.darboux.empty()) {
    if (n.darboux != "relation" && n.darboux != "multiple")
      throw e.at("darboux").error("one of: relation, multiple");
    if (n.part != "all" && n.part != "highest" && n.part != "lowest")
      throw e.at("part").error("one of: all, highest, lowest");
  }
  if (const Entry* x = e.find("integrals")) n.integrals = read_class(*x);
  n.regions = read_lists(e, "regions");
  n.fields = read_lists(e, "fields");
}

TheoremNode read_node(const Entry& e) {
  e.check_keys({"id",      "title",      "statement", "note",       "kind",   "needs",
                "cite",    "hypotheses", "file",      "other",      "where",  "manifold",
                "expect",  "small",      "families",  "triangle",   "sample", "theorem",
                "of",      "at",         "if",        "as",         "roots",  "time",
                "order",   "levels",     "integral",  "integrable", "step",   "integrals",
                "regions", "fields",     "darboux",   "part"});
  TheoremNode n;
  n.kind = kind_of(e.at("kind"));
  check_keys_of_kind(e, n.kind);
  n.id = read_id(e.at("id"));
  n.title = text_of(e, "title");
  if (n.title.empty()) n.title = n.id;
  n.statement = text_of(e, "statement");
  if (n.kind == NodeKind::argument) (void)e.at("statement");
  n.note = text_of(e, "note");
  n.theorem = read_literature(e);
  n.needs = texts_of(e, "needs");
  n.cite = texts_of(e, "cite");
  n.file = text_of(e, "file");
  n.other = text_of(e, "other");
  read_tables(e, n);
  if (const Entry* x = e.find("expect")) n.expect = read_expected(*x);
  if (const Entry* x = e.find("order")) n.order = read_order(*x);
  n.small = texts_of(e, "small");
  n.families = texts_of(e, "families");
  if (const Entry* t = e.find("triangle")) n.triangle = t->boolean();
  n.where = read_values(e, "where");
  n.place = {text_of(e, "of"),        read_values(e, "at"), texts_of(e, "if"),
             read_values(e, "roots"), read_values(e, "as"), text_of(e, "time")};
  if (!n.place.of.empty()) n.needs.push_back(n.place.of);
  n.sample = read_values(e, "sample");
  check_sample(e, n);
  if (const Entry* h = e.find("hypotheses"))
    for (const Entry* one : h->list())
      n.hypotheses.push_back(read_hypothesis(*one));
  n.line = e.line();
  return n;
}

Symmetry read_symmetry(const Entry& e) {
  e.check_keys({"title", "as"});
  (void)e.at("as");
  return {text_of(e, "title"), read_values(e, "as")};
}

bool read_expectation(const Entry& document) {
  const Entry* e = document.find("expect");
  if (!e) return false;
  if (e->string() != "open" && e->string() != "proved")
    throw e->error("a theorem is expected to be 'proved' or 'open'");
  return e->string() == "open";
}

using NodesById = std::map<std::string, const TheoremNode*>;

// Everything that is named is there, and no hypothesis is its own proof.
void check_names(const Theorem& t, const NodesById& by_id, const Entry& document) {
  std::vector<std::string> ids;
  for (const auto& [id, n] : by_id)
    ids.push_back(id);
  const auto known = [&](const std::string& id, const TheoremNode& n) {
    if (by_id.contains(id)) return;
    const auto near = nearest(id, ids);
    throw document.error("node '" + n.id + "' refers to '" + id + "', which is not there",
                         near ? "did you mean " + *near + "?" : "");
  };
  for (const TheoremNode& n : t.nodes) {
    for (const std::string& id : n.needs)
      known(id, n);
    for (const Hypothesis& h : n.hypotheses) {
      if (h.by.empty()) continue;
      known(h.by, n);
      if (h.by == n.id)
        throw document.error("node '" + n.id + "' checks its own hypothesis '" + h.text + "'",
                             "'by' names another node, whose computation checks it");
    }
  }
}

// No circles, and everything carries the root: a step that the theorem does not need would only
// make it look better.
void check_tree(const Theorem& t, const NodesById& by_id, const Entry& document) {
  std::set<std::string> open, done;
  const std::function<void(const TheoremNode&)> visit = [&](const TheoremNode& n) {
    if (done.contains(n.id)) return;
    if (!open.insert(n.id).second)
      throw document.error("node '" + n.id + "' rests on itself: a circle of needs");
    for (const std::string& id : n.needs)
      visit(*by_id.at(id));
    open.erase(n.id);
    done.insert(n.id);
  };
  visit(t.nodes.front());
  const std::set<std::string> used = done;
  for (const TheoremNode& n : t.nodes)
    visit(n);
  for (const TheoremNode& n : t.nodes)
    if (!used.contains(n.id))
      throw document.error("nothing rests on node '" + n.id + "': the first node, '" +
                               t.nodes.front().id + "', does not need it",
                           "add it to the needs of a node, or leave it out");
}

void check_references(const Theorem& t, const Entry& document) {
  NodesById by_id;
  for (const TheoremNode& n : t.nodes)
    if (!by_id.emplace(n.id, &n).second)
      throw document.error("the id '" + n.id + "' is used twice");
  check_names(t, by_id, document);
  check_tree(t, by_id, document);
}

} // namespace

std::string to_string(NodeKind k) {
  for (const auto& [name, kind] : kinds())
    if (kind == k) return name;
  return "";
}

std::string to_string(NodeStatus s) {
  switch (s) {
  case NodeStatus::proved:
    return "proved";
  case NodeStatus::partial:
    return "in part";
  case NodeStatus::trusted:
    return "trusted";
  case NodeStatus::reasoned:
    return "in words";
  case NodeStatus::refuted:
    return "refuted";
  case NodeStatus::unbound:
    return "unbound";
  default:
    return "open";
  }
}

Theorem read_theorem(const Entry& document) {
  document.check_keys({"format", "title", "statement", "cite", "node", "system", "symmetry",
                       "expect", "algebraic"});
  if (!has_format(document, "theorem"))
    throw document.error("a theorem file begins with format = \"theorem/1\"");
  if (document.at("format").string() != "theorem/1")
    throw document.at("format").error("this program reads format theorem/1");
  Theorem t;
  t.file = document.file();
  t.sha256 = sha256(document.file_text());
  t.title = one_line(document.at("title").string());
  t.statement = text_of(document, "statement");
  t.system = text_of(document, "system");
  if (const Entry* all = document.find("symmetry"))
    for (const Entry* e : all->list())
      t.symmetries.push_back(read_symmetry(*e));
  t.algebraic = read_values(document, "algebraic");
  t.expected_open = read_expectation(document);
  t.cite = texts_of(document, "cite");
  for (const Entry* e : document.at("node").list())
    t.nodes.push_back(read_node(*e));
  for (TheoremNode& n : t.nodes)
    n.algebraic = t.algebraic;
  constexpr std::size_t most = 2000; // the tree is walked by recursion
  if (t.nodes.size() > most)
    throw document.error("a theorem has at most " + std::to_string(most) + " nodes");
  if (t.nodes.empty()) throw document.error("a theorem needs at least one [[node]]");
  check_references(t, document);
  return t;
}

} // namespace kov
