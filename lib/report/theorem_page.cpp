#include "exact/joined.hpp"
#include "report/render_theorem.hpp"
#include "report/sheet.hpp"
#include "report/texts.hpp"
#include "theorem/prove.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <set>

namespace kov::report {
namespace {

class TheoremPage {
public:
  TheoremPage(const TheoremResult& t, Markup m) : t_(t), m_(m), s_(m) {}

  std::string operator()() {
    if (const InputFile* f = main_system(t_)) system(*f);
    if (!t_.statement().empty())
      s_.paragraph((m_ == Markup::tex ? "\\textbf{Theorem.} \\emph{" : "<b>Theorem.</b> ") +
                       prose(t_.statement()) + (m_ == Markup::tex ? ".}" : "."),
                   "statement");
    if (!t_.theorem.statement.empty())
      s_.paragraph("The author's words: " + prose(t_.theorem.statement), "remark");
    s_.paragraph(prose(t_.conclusion()) + ".", !t_.complete_but_for_words() ? "verdict no"
                                               : t_.complete() && t_.unchecked_hypotheses().empty()
                                                   ? "verdict"
                                                   : "verdict but");
    counts();
    if (!t_.nodes.empty() && t_.nodes.front().node.kind == NodeKind::case_file)
      for (const PolePicture& p : t_.nodes.front().pictures)
        s_.picture(p);
    s_.heading("What rests on what");
    for (const NodeResult* n : roots(t_))
      tree(*n, 0);
    trusted();
    s_.heading("The steps");
    for (const NodeResult& n : t_.nodes)
      step(n);
    appendix();
    s_.bibliography(references(t_));
    return s_.text();
  }

private:
  [[nodiscard]] std::string prose(const std::string& text) const { return report::prose(text, m_); }
  [[nodiscard]] std::string title_of(const NodeResult& n) const {
    return std::to_string(&n - t_.nodes.data() + 1) + ". " + prose(n.node.title);
  }
  [[nodiscard]] std::string marked(const NodeResult& n, const std::string& title) const {
    return s_.marked(to_string(n.status), status_of(n), title);
  }
  // A system as a reader needs it: names, bracket, equations as its file writes them.
  void system(const InputFile& f) {
    if (f.setting.empty() || !shown_.insert(f.name).second) return;
    s_.paragraph(s_.strong(name_of_system(t_, f, m_) + ".") + " " + prose(f.assumed));
    s_.labelled(f.setting);
  }
  void counts() {
    const auto count = [](std::size_t n, const std::string& one, const std::string& many) {
      return std::to_string(n) + " " + (n == 1 ? one : many);
    };
    std::string text = joined(std::vector{
        count(t_.count(NodeStatus::proved), "step proved here", "steps proved here"),
        count(t_.identities(), "exact identity checked", "exact identities checked"),
        count(t_.certificates(), "certificate accepted", "certificates accepted"),
        count(t_.uses().size(), "theorem trusted", "theorems trusted"),
        count(t_.trusted_steps().size(), "other step on trust", "other steps on trust"),
        count(t_.count(NodeStatus::reasoned), "argument in words", "arguments in words"),
        count(t_.unchecked_hypotheses().size(), "hypothesis not checked", "hypotheses not checked"),
        count(t_.count(NodeStatus::open), "open", "open")});
    text += ", in " + t_.time() + ".";
    for (const std::string& key : t_.theorem.cite)
      text += " " + s_.cited(key);
    s_.paragraph(text, "soft");
  }
  void tree(const NodeResult& n, std::size_t depth) {
    const bool again = !seen_.insert(n.node.id).second;
    s_.branch(depth, marked(n, s_.link(n.node.id, title_of(n)) +
                                   (n.rests_on_open ? " (rests on open steps)" : "") +
                                   (again ? " (above)" : "")));
    if (again) return;
    for (const Hypothesis& h : n.node.hypotheses)
      if (!h.checked)
        s_.branch(depth + 1, s_.marked("open", "not checked", "hypothesis: " + prose(h.text)));
    for (const TheoremUsed& u : each_once(n.theorems))
      s_.branch(depth + 1, s_.marked("trusted", "trusted", prose(u.theorem->in_words())));
    for (const std::string& c : n.node.needs)
      tree(*node_with(t_, c), depth + 1);
  }
  void trusted() {
    s_.heading("Trusted, not proved here");
    s_.begin_list();
    for (const std::string& s : t_.trusted_steps())
      s_.item(prose(s));
    for (const std::string& s : t_.unchecked_hypotheses())
      s_.item("Hypothesis not checked: " + prose(s), "warn");
    for (const TheoremUsed& use : t_.uses()) {
      const LiteratureTheorem& theorem = *use.theorem;
      s_.item(s_.strong(prose(theorem.name)) + " " + s_.cited(theorem.cite) + ": " +
              prose(theorem.statement));
      if (use.hypotheses.empty()) continue;
      s_.begin_list();
      for (const TheoremHypothesis& h : use.hypotheses)
        s_.item(prose(settled(h) + h.text), h.settled == Settled::open ? "warn" : "soft");
      s_.end_list();
    }
    if (t_.trusted_steps().empty() && t_.unchecked_hypotheses().empty() && t_.uses().empty())
      s_.item("nothing");
    s_.end_list();
  }
  void step(const NodeResult& n) {
    s_.begin_box(marked(n, title_of(n)), n.node.id, n.status == NodeStatus::open);
    for (const InputFile& f : t_.files)
      if (f.name == n.node.file || f.name == n.node.other) system(f);
    if (!n.statement.empty()) s_.paragraph(prose(n.statement) + ".");
    if (!n.node.statement.empty()) s_.paragraph(prose(remark(n) + n.node.statement), "remark");
    if (!n.node.needs.empty())
      s_.paragraph("Rests on " +
                       joined(n.node.needs,
                              [&](const std::string& c) {
                                const NodeResult& other = *node_with(t_, c);
                                return m_ == Markup::tex
                                           ? std::to_string(&other - t_.nodes.data() + 1)
                                           : s_.link(c, title_of(other));
                              }) +
                       ".",
                   "soft");
    if (const std::string found = finding(n); !found.empty())
      s_.paragraph(s_.strong("Found:") + " " + prose(found) + ".");
    for (const Hypothesis& h : n.node.hypotheses)
      s_.paragraph((h.checked ? "Hypothesis, for which the author names step " + prose(h.by)
                              : "Hypothesis not checked") +
                       ": " + prose(h.text),
                   h.checked ? "soft" : "warn");
    if (!n.checks.empty()) {
      s_.begin_list("checks");
      for (const CheckedIdentity& c : n.checks)
        s_.item(prose(c.statement), c.holds ? "yes" : "no");
      s_.end_list();
    }
    s_.labelled(n.formulas);
    for (const Grid& g : n.tables)
      s_.table(g);
    for (const PolePicture& p : n.pictures)
      s_.picture(p);
    for (const TheoremUsed& u : each_once(n.theorems))
      s_.paragraph("By " + prose(u.theorem->in_words()) + ".");
    if (!n.node.note.empty()) s_.paragraph("Note: " + prose(n.node.note), "soft");
    s_.end_box();
  }
  // How the result was computed, from which files, and which commands check it again.
  void appendix() {
    if (t_.files.empty()) return;
    s_.heading("How to check this");
    if (!t_.program.empty()) s_.paragraph("Computed by " + verbatim(t_.program, m_) + ".");
    s_.paragraph(prose(how_to_check(t_)));
    s_.begin_list("commands");
    for (const std::string& command : commands_to_check(t_))
      s_.item(verbatim(command, m_));
    s_.end_list();
    if (files_of(t_).empty()) return;
    s_.paragraph("The files, with SHA-256 of their bytes:");
    s_.begin_list("files");
    for (const InputFile& f : files_of(t_))
      s_.item(verbatim(f.name, m_) + (m_ == Markup::tex
                                          ? "\\\\{\\footnotesize\\texttt{" + f.sha256 + "}}"
                                          : "<br><code>" + f.sha256 + "</code>"));
    s_.end_list();
  }

  const TheoremResult& t_;
  Markup m_;
  Sheet s_;
  std::set<std::string> shown_{}, seen_{};
};

} // namespace

std::string theorem_tex(const TheoremResult& t) {
  return std::string(text_file("preamble.tex")) + "\\title{" + prose(t.theorem.title, Markup::tex) +
         "}\\author{}\\date{}\n\\begin{document}\n\\maketitle\n" + TheoremPage(t, Markup::tex)() +
         "\\end{document}\n";
}

std::string theorem_html(const TheoremResult& t) {
  return html_page(t.theorem.title, "<h1>" + prose(t.theorem.title, Markup::html) + "</h1>\n" +
                                        TheoremPage(t, Markup::html)());
}

std::string html_page(const std::string& title, const std::string& body) {
  std::string page(text_file("page.html"));
  for (const auto& [mark, text] :
       {std::pair{"@title@", verbatim(title, Markup::html)},
        std::pair{"@style@", std::string(text_file("theorem.css"))}, std::pair{"@body@", body}})
    page.replace(page.find(mark), std::strlen(mark), text);
  return page;
}

} // namespace kov::report
