#include "systems/study_report.hpp"

#include "decide/words.hpp"
#include "equations/present_strata.hpp"
#include "integrability/matrices.hpp"
#include "integrability/parameters.hpp"
#include "output/render.hpp"
#include "study/headline_words.hpp"
#include "symbol/author_words.hpp"
#include "systems/classification_report.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace kov::cli {
std::string title_of_manifold(const System& s, const std::string& name) {
  std::string title = s.file + "  [" + name + "]";
  for (const auto& [parameter, value] : s.values)
    title += "  " + parameter + " = " + to_string(value);
  return title;
}

Meaning meaning_of(Verdict v) {
  return v == Verdict::integrable       ? Meaning::positive
         : v == Verdict::non_integrable ? Meaning::negative
                                        : Meaning::open;
}

namespace {

// The beginning of what would fill a page.
std::string cut(const std::string& text, Detail detail) {
  constexpr std::size_t five_lines = 430;
  if (detail == Detail::whole || text.size() <= five_lines) return text;
  return text.substr(0, five_lines) + " ... (--verbose shows the rest)";
}

std::string headline(study::HeadlineWords words, Detail detail) {
  words.except = cut(words.except, detail);
  return one_line(words);
}

void put_decision(std::ostringstream& out, const Decision& d, std::size_t indent) {
  std::string group = d.group ? "G = " + describe(*d.group) : "G not determined";
  if (d.component) group += ", identity component " + to_string(*d.component);
  group += ", " + whether_abelian(word_of(d.abelian));
  put(out, "group", group, indent);
  put(out, "because", reason(d), indent);
  Json steps = Json::object();
  put_trace(steps, d.trace);
  print_trace(out, steps);
}

void print(std::ostringstream& out, const strata::StrataAnswer& a, Detail detail) {
  Json j;
  put_strata(j, a);
  j["trusted"] = Json::array(); // said once for all blocks
  print_strata(out, j, detail == Detail::whole);
}

// r in three lines, or what its poles are.
std::string shape_of(const AlgebraicOde& ode, const std::string& z) {
  constexpr std::size_t three_lines = 260;
  const MPoly numerator = ode.r.num();
  std::string whole = to_factored_string(ode.r);
  if (whole.size() <= three_lines) return whole;
  const std::string below = to_factored_string(MFraction(ode.r.den()));
  return (below.size() <= three_lines ? "N(" + z + ")/(" + below + "), N"
                                      : "a quotient whose numerator is") +
         " of degree " + std::to_string(degree(numerator, ode.z)) + " with " +
         std::to_string(numerator.length()) + " terms (--verbose shows them)";
}

void put_level(std::ostringstream& out, const EnergyResult& e, Detail detail) {
  put(out, "at", sentence(e.at) + "  (" + why(e) + ")");
  if (e.decision) put_decision(out, *e.decision, 4);
  if (e.strata) print(out, *e.strata, detail);
  if (!e.missing.empty()) put(out, "note", cut(note(e.missing), detail), 4);
}

// A level that decides is enough.
bool decides(const EnergyResult& e) {
  return (e.decision && e.decision->abelian == Truth::no) ||
         (e.strata && e.strata->decided() && somewhere_not_abelian(*e.strata));
}

void put_levels(std::ostringstream& out, const std::vector<EnergyResult>& all, Detail detail) {
  const auto one = std::ranges::find_if(all, decides);
  if (detail == Detail::whole || one == all.end())
    for (const EnergyResult& e : all)
      put_level(out, e, detail);
  else
    put_level(out, *one, detail);
}

void put_block(std::ostringstream& out, const System& s, const BlockReport& b, Detail detail) {
  if (b.ode) {
    const std::string z = s.ring()->name(b.ode->z);
    put(out, "change", b.ode->change + ", y the variation of " + b.ode->unknown);
    put(out, "equation",
        "y'' = r(" + z + ") y,  r = " +
            (detail == Detail::whole ? to_factored_string(b.ode->r) : shape_of(*b.ode, z)));
  }
  if (b.decision) put_decision(out, *b.decision, 2);
  if (b.strata) print(out, *b.strata, detail);
  if (detail == Detail::whole)
    for (const auto& f : b.special)
      put(out, "merging", "singular places meet where " + to_string(f) + " = 0");
  put_levels(out, b.energies, detail);
  if (!b.missing.empty()) put(out, "note", cut(note(b.missing), detail));
}

void put_trust(std::ostringstream& out, const std::vector<Trusted>& steps) {
  if (!steps.empty())
    put(out, "trusted",
        std::to_string(steps.size()) + (steps.size() == 1 ? " step: " : " steps: ") +
            joined(sentences(steps), "; "));
}

// Which flag sets the first limit among the reasons.
void put_way_out(std::ostringstream& out, const std::vector<std::string>& reasons) {
  for (const std::string& reason : reasons)
    if (const std::string way = way_out("budget", reason); way != way_out("budget", ""))
      return put(out, "more", way);
}

// Below a headline of higher order: its reasons, and then what the first order says.
void put_obstruction(std::ostringstream& out, const study::CurveStudy& m, Detail detail) {
  const ExclusionReason& by = m.higher->excluded->by;
  if (!by.unchecked.empty()) put(out, "NOT CHECKED", by.unchecked);
  put(out, "because", by.reason);
  put_trust(out, by.trusted);
  put(out, "order 1", headline(study::in_words(m.first), detail));
}

std::string nothing_found(const study::HigherOrders& h) {
  return h.planes.open.empty() ? "no obstruction up to VE_" + std::to_string(h.up_to) +
                                     " (no logarithm at infinity; this proves nothing)"
                               : "OPEN: " + h.planes.open;
}

void put_first_order(std::ostringstream& out, const System& s, const ManifoldReport& m,
                     bool undecided, Detail detail) {
  for (const std::string& constant : s.adjoined)
    if (!m.blocks.empty()) put(out, "where", constant);
  for (const auto& e : m.reduced.eliminations)
    put(out, "reduced",
        "the variation of " + e.unknown + " by the linear integral d" + e.integral + " = 0");
  for (const auto& b : m.blocks)
    put_block(out, s, b, detail);
  if (m.blocks.empty())
    for (const auto& r : reasons(m))
      put(out, "because", r);
  else if (m.verdict == Verdict::undecided && m.left_out)
    put(out, "open", reasons(m).back());
  if (m.matrices && !m.blocks.empty()) put(out, "because", reason(*m.matrices));
  if (undecided) put_way_out(out, reasons(m));
  if (m.verdict != Verdict::undecided || m.by) put_trust(out, trusted_steps(m));
}

void put_manifold(std::ostringstream& out, const System& s, const study::CurveStudy& study,
                  Detail detail) {
  const ManifoldReport& m = study.first;
  const Verdict verdict = study.headline.verdict;
  const bool undecided = verdict == Verdict::undecided || verdict == Verdict::failed;
  if (detail == Detail::nothing && !undecided) return;
  out << title_of_manifold(s, m.name) << "\n";
  if (m.failure) return put(out, "error", m.failure->message);
  out << "  " << painted(wrapped(headline(in_words(study), detail), 2), meaning_of(verdict))
      << "\n";
  if (m.manifold)
    for (const auto& line : m.manifold->rewritten)
      put(out, "note", line);
  const bool by_higher = study.higher && study.higher->excluded;
  if (by_higher) put_obstruction(out, study, detail);
  if (const std::string open = not_checked(m);
      !open.empty() && (m.verdict != Verdict::undecided || m.by))
    put(out, "NOT CHECKED", open);
  if (detail != Detail::headline || undecided) put_first_order(out, s, m, undecided, detail);
  if (study.higher && !by_higher)
    put(out, "order " + std::to_string(study.higher->up_to), nothing_found(*study.higher));
  for (const std::string& part : study.failed)
    put(out, "failed", part);
}

std::string with_names_replaced(const std::string& text,
                                const std::map<std::string, std::string>& meaning) {
  const auto of_a_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && of_a_name(text[end]))
      ++end;
    const std::string word = text.substr(i, std::max<std::size_t>(end - i, 1));
    const auto known = meaning.find(word);
    i += word.size();
    if (known == meaning.end()) {
      out += word;
      continue;
    }
    // root1^2 is B^(2/3), as root1 is B^(1/3)
    const std::string& said = known->second;
    const auto root = said.rfind("^(1/");
    const bool is_root = root != std::string::npos && said.find(')', root) + 1 == said.size();
    std::size_t digits = i + 1;
    while (is_root && text[i] == '^' && digits < text.size() && std::isdigit(text[digits]) != 0)
      ++digits;
    out += said;
    if (digits > i + 1 && text[i] == '^') {
      out.replace(out.size() - (said.size() - root) + 2, 1, text.substr(i + 1, digits - i - 1));
      i = digits;
    }
  }
  return out;
}

std::size_t indent_of(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// Does the second line go on with the first, because its first word did not fit there?
bool goes_on(const std::string& first, const std::string& second) {
  const std::size_t indent = indent_of(second), begin = indent_of(first),
                    word = std::min(second.find(' ', indent), second.size()) - indent,
                    hanging = indent == begin + 2 ? 2 : 0; // put_below counts from the second line
  return (indent > begin || begin > 10) && indent >= begin &&
         first.size() + hanging + 1 + word > page_width();
}

// root1, exp1, cos_theta: names that nobody wrote.  A name of the file may be a word of the answer (a, r, G).
bool is_made_name(const std::string& name, const std::string& function) {
  const std::string stem = function == "sqrt" || function.starts_with("root") ? "root" : function;
  if (name.starts_with(function + "_") || name.starts_with(stem + "_")) return true;
  return name.starts_with(stem) && name.size() > stem.size() &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(stem.size()), name.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

// root3(x + 1) is (x + 1)^(1/3).
std::string with_powers(const std::string& meaning) {
  const auto open = meaning.find('(');
  if (!meaning.starts_with("root") || open == std::string::npos || open < 5) return meaning;
  const std::string of = meaning.substr(open + 1, meaning.size() - open - 2);
  return (is_identifier(of) ? of : "(" + of + ")") + "^(1/" + meaning.substr(4, open - 4) + ")";
}

std::map<std::string, std::string> written_names(const System& s) {
  std::map<std::string, std::string> meaning;
  for (const auto& [name, root] : s.roots)
    if (is_made_name(name, "sqrt")) meaning[name] = with_powers(with_names_replaced(root, meaning));
  for (const FunctionSymbol& f : s.field.functions)
    if (const std::string& name = s.ring()->name(f.variable);
        !f.meaning.empty() && is_made_name(name, f.function))
      meaning[name] = with_powers(with_names_replaced(f.meaning, meaning)); // with others inside
  return meaning;
}

} // namespace

std::string in_written_names(const System& s, const std::string& sentence) {
  return with_names_replaced(sentence, written_names(s));
}

void put_written_names(const System& s, Json& j) {
  if (j.is_string()) j = in_written_names(s, j.get<std::string>());
  if (j.is_structured())
    for (Json& part : j)
      put_written_names(s, part);
}

std::string with_written_roots(const System& s, const std::string& text) {
  const std::map<std::string, std::string> meaning = written_names(s);
  if (meaning.empty()) return text;
  std::istringstream in(text);
  std::string out, before;
  for (std::string line; std::getline(in, line); before = line) {
    const std::string written = with_names_replaced(line, meaning);
    if (!out.empty() && goes_on(before, line)) // wrapped again, with longer names
      out.back() = ' ', out += written.substr(indent_of(written)) + '\n';
    else
      out += written + '\n';
  }
  return folded(out, page_width());
}

std::vector<std::string> named_roots(const System& s) {
  std::vector<std::string> all;
  for (const FunctionSymbol& f : s.field.functions)
    if (const std::string& name = s.ring()->name(f.variable);
        !f.meaning.empty() && f.function == "sqrt" && !is_made_name(name, f.function))
      all.push_back(name + " = " + f.meaning);
  return all;
}

std::string text_of(const System& s, const study::CurveStudy& m, Detail detail) {
  std::ostringstream out;
  put_manifold(out, s, m, detail);
  if (detail >= Detail::brief)
    for (const std::string& root : named_roots(s))
      put(out, "function", root);
  return with_written_roots(s, out.str());
}

std::string text_of(const System& s, const SystemClassification& c, Verdict verdict,
                    Detail detail) {
  std::ostringstream out;
  out << title_of_manifold(s, "all manifolds together") << "\n  "
      << painted(wrapped(one_line(study::in_words(verdict, !c.excluded.empty())), 2),
                 meaning_of(verdict))
      << "\n";
  if (c.excluded.empty()) return out.str();
  put(out, verdict == Verdict::undecided ? "so far" : "theorem", statement(c));
  if (!c.assumptions.empty()) put(out, "assumed", joined(c.assumptions, ", "));
  if (detail == Detail::headline) return out.str();
  for (const ExcludedTogether& e : excluded_together(c, ExcludedFor::the_same_reason))
    put(out, "excluded",
        joined(texts_of(c, e.places), "; or ") + ": " + cut(reason_of(*e.by), detail));
  put(out, "by", joined(theorem_names(c.theorems), ", "));
  return with_written_roots(s, out.str());
}

} // namespace kov::cli
