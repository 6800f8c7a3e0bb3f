#include "exact/joined.hpp"
#include "report/render_theorem.hpp"
#include "report/texts.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace kov::report {
namespace {

constexpr Markup tex = Markup::tex;

std::string title_of(const NodeResult& n) { return prose(n.node.title, tex); }

std::size_t number_of(const TheoremResult& t, const std::string& id) {
  for (std::size_t i = 0; i < t.nodes.size(); ++i)
    if (t.nodes[i].node.id == id) return i + 1;
  return 0;
}

// Long polynomials break at their signs when they are set in the line.
std::string paragraph(const std::string& label, const std::string& text) {
  return "\\par\\hangindent=1.5em " + heading(label, tex) + ": " + text + "\n";
}

// Widths of the columns, in percent: as the square root of the longest entry, so that a long text gets
// more and a short one enough.
std::vector<long> widths(const Grid& g, std::size_t columns) {
  std::vector<long> weight(columns, 3);
  for (const auto& row : g.rows)
    for (std::size_t i = 0; i < std::min(columns, row.size()); ++i)
      while (weight[i] * weight[i] < static_cast<long>(row[i].size()))
        ++weight[i];
  const long sum = std::accumulate(weight.begin(), weight.end(), 0L);
  for (long& x : weight)
    x = (99 - 3 * static_cast<long>(columns - 1)) * x / sum; // 12pt between two columns
  return weight;
}

std::string table(const Grid& g) {
  const std::size_t n = std::max<std::size_t>(1, g.header.size());
  std::string out = "\\par{\\small\n\\begin{longtable}{@{}";
  for (const long percent : widths(g, n))
    out += ">{\\raggedright\\arraybackslash}p{0." + std::string(percent < 10 ? "0" : "") +
           std::to_string(percent) + "\\linewidth}";
  const std::string head =
      "\\hline\n" +
      joined(
          g.header, [](const std::string& cell) { return prose(cell, tex); }, " & ") +
      "\\\\\\hline";
  out += "@{}}\n\\multicolumn{" + std::to_string(n) + "}{@{}l@{}}{\\textit{" +
         prose(g.caption, tex) + "}}\\\\[2pt]\n" + head + "\\endfirsthead\n" + head + "\\endhead\n";
  if (g.rows.empty()) out += "none\\\\\n";
  const auto entry = [](const std::string& cell) { return prose(shortened(cell, 600), tex); };
  for (const auto& row : g.rows)
    out += joined(row, entry, " & ") + "\\\\\n";
  return out + "\\hline\n\\end{longtable}}\n";
}

std::string thousandths(long x) {
  return std::to_string(x / 1000) + "." + std::to_string(1000 + x % 1000).substr(1);
}

std::string picture(const PolePicture& p) {
  const PlacedPicture q = place(p, {100000, 56000, 1700, 3000}); // in millimetres
  std::string out = "\\begin{center}\\setlength{\\unitlength}{1mm}\\begin{picture}(100,56)\n";
  if (q.axis_y) out += "\\put(0," + thousandths(*q.axis_y) + "){\\line(1,0){100}}\n";
  if (q.axis_x) out += "\\put(" + thousandths(*q.axis_x) + ",0){\\line(0,1){56}}\n";
  for (const PlacedPoint& x : q.points) {
    const std::string at = "\\put(" + thousandths(x.x) + "," + thousandths(x.y) + ")";
    out += at + "{\\circle" + (x.special ? "*" : "") + "{1.4}}\n";
    out += "\\put(" + thousandths(x.label_x) + "," + thousandths(x.label_y) + "){\\footnotesize " +
           label(x.label, tex) + "}\n";
  }
  return out + "\\end{picture}\\par{\\small " + prose(p.caption, tex) + "}\\end{center}\n";
}

// A system as a reader needs it: names, bracket, equations as its file writes them.
std::string system(const TheoremResult& t, const InputFile& f) {
  std::string out =
      "\\par\\textbf{" + name_of_system(t, f, tex) + ".} " + prose(f.assumed, tex) + "\n{\\small\n";
  for (const Formula& line : f.setting)
    out += paragraph(line.label, formula(shortened(line.text, longest_on_a_page), tex));
  return out + "\\par}\n";
}

// "[3]", where the list at the end has the work; else the key.
std::string cited(const std::string& key) {
  return reference(key) ? "\\cite{" + key + "}" : "[" + prose(key, tex) + "]";
}

std::string bibliography(const TheoremResult& t) {
  const auto works = references(t);
  if (works.empty()) return "";
  std::string out = "\\begin{thebibliography}{99}\n";
  for (const Reference& r : works)
    out += "\\bibitem{" + r.key + "} " + r.authors + ", \\emph{" + r.title + "}, " + r.published +
           ".\n";
  return out + "\\end{thebibliography}\n";
}

// The appendix: with what this was computed, from what, and what checks it again.
std::string appendix(const TheoremResult& t) {
  if (t.files.empty()) return "";
  std::string out = "\\section*{Appendix: how to check this}\n";
  if (!t.program.empty()) out += "Computed by " + verbatim(t.program, tex) + ".\n";
  out += "\\par " + prose(how_to_check(t), tex) + "\n\\begin{quote}\\small\n";
  for (const std::string& command : commands_to_check(t))
    out += "\\texttt{" + verbatim(command, tex) + "}\\\\\n";
  out += "\\end{quote}\n";
  if (files_of(t).empty()) return out;
  out += "\\par The files, with SHA-256 of their bytes:\n"
         "\\begin{itemize}\\setlength{\\itemsep}{0pt}\n";
  for (const InputFile& f : files_of(t))
    out += "\\item " + verbatim(f.name, tex) + "\\\\{\\footnotesize\\texttt{" + f.sha256 + "}}\n";
  return out + "\\end{itemize}\n";
}

// The systems of a step that no earlier one has shown.
std::string new_systems(const TheoremResult& t, const NodeResult& n, std::set<std::string>& shown) {
  std::string out;
  for (const InputFile& f : t.files)
    if ((f.name == n.node.file || f.name == n.node.other) && !f.setting.empty() &&
        shown.insert(f.name).second)
      out += system(t, f);
  return out;
}

std::string step(const TheoremResult& t, const NodeResult& n, std::set<std::string>& shown) {
  std::string out = "\n\\subsection*{" + std::to_string(number_of(t, n.node.id)) + ". " +
                    title_of(n) + "\\quad\\status{" + status_of(n) + "}}\n" +
                    new_systems(t, n, shown) + (n.statement.empty() ? "" : "\\par ") +
                    (n.statement.empty() ? "" : prose(n.statement, tex) + ".\n") +
                    (n.node.statement.empty()
                         ? ""
                         : "\\par\\textit{" + prose(remark(n) + n.node.statement, tex) + "}\n");
  if (!n.node.needs.empty()) {
    out += "\\par Rests on";
    bool first = true;
    for (const std::string& c : n.node.needs) {
      out += (first ? " " : ", ") + std::to_string(number_of(t, c));
      first = false;
    }
    out += ".\n";
  }
  if (const std::string found = finding(n); !found.empty())
    out += "\\par\\textbf{Found:} " + prose(found, tex) + ".\n";
  for (const Hypothesis& h : n.node.hypotheses)
    out += paragraph(h.checked ? "Hypothesis, for which the author names step " + h.by
                               : "HYPOTHESIS NOT CHECKED",
                     prose(h.text, tex));
  if (!n.checks.empty()) {
    out += "\\begin{itemize}\\setlength{\\itemsep}{0pt}\\small\n";
    for (const CheckedIdentity& c : n.checks)
      out += std::string("\\item[") + (c.holds ? "$\\checkmark$" : "NO") + "] " +
             prose(c.statement, tex) + "\n";
    out += "\\end{itemize}\n";
  }
  for (const Formula& f : n.formulas)
    out += paragraph(f.label, formula(shortened(f.text, longest_on_a_page), tex));
  for (const Grid& g : n.tables)
    out += table(g);
  for (const PolePicture& p : n.pictures)
    if (!p.points.empty()) out += picture(p);
  for (const TheoremUsed& u : each_once(n.theorems))
    out += "\\par By " + prose(u.theorem->in_words(), tex) + ".\n";
  if (!n.node.note.empty()) out += paragraph("Note", prose(n.node.note, tex));
  return out;
}

std::string branch(std::size_t depth, const std::string& text, const std::string& status) {
  return "\\branch{" + std::to_string(depth) + "}{" + text + " \\status{" + status + "}}\n";
}

std::string tree(const TheoremResult& t) {
  std::string out;
  std::set<std::string> seen;
  const std::function<void(const NodeResult&, std::size_t)> put = [&](const NodeResult& n,
                                                                      std::size_t depth) {
    out += branch(depth, std::to_string(number_of(t, n.node.id)) + ". " + title_of(n),
                  status_of(n) + (n.rests_on_open ? ", rests on open steps" : ""));
    if (!seen.insert(n.node.id).second) return;
    for (const Hypothesis& h : n.node.hypotheses)
      if (!h.checked) out += branch(depth + 1, "a hypothesis", "NOT CHECKED");
    for (const TheoremUsed& u : each_once(n.theorems))
      out += branch(depth + 1, prose(u.theorem->in_words(), tex), "trusted");
    for (const std::string& c : n.node.needs)
      put(t.nodes[number_of(t, c) - 1], depth + 1);
  };
  for (const NodeResult* n : roots(t))
    put(*n, 0);
  return "{\\parskip=1pt\n" + out + "\\par}\n";
}

} // namespace

std::string theorem_tex(const TheoremResult& t) {
  std::string out(text_file("preamble.tex"));
  out += "\\title{" + prose(t.theorem.title, tex) +
         "}\\author{}\\date{}\n\\begin{document}\n\\maketitle\n";
  std::set<std::string> shown;
  if (const InputFile* of = main_system(t)) {
    out += system(t, *of) + "\\medskip\n\n";
    shown.insert(of->name);
  }
  if (!t.statement().empty())
    out += "\\textbf{Theorem.} \\emph{" + prose(t.statement(), tex) + ".}\n\n";
  if (!t.theorem.statement.empty())
    out += "\\textit{The author's words:} " + prose(t.theorem.statement, tex) + "\n\n";
  out +=
      prose(t.conclusion(), tex) + ". " + std::to_string(t.identities()) +
      (t.identities() == 1 ? " exact identity was checked, " : " exact identities were checked, ") +
      std::to_string(t.certificates()) +
      (t.certificates() == 1 ? " certificate accepted, in " : " certificates accepted, in ") +
      t.time() + ".";
  for (const std::string& key : t.theorem.cite)
    out += " " + cited(key);
  out += "\n";
  out += "\\section*{What rests on what}\n" + tree(t);
  out += "\\section*{Trusted}\n\\begin{itemize}\n";
  for (const std::string& s : t.trusted_steps())
    out += "\\item " + prose(s, tex) + "\n";
  for (const std::string& s : t.unchecked_hypotheses())
    out += "\\item \\textbf{Hypothesis not checked.} " + prose(s, tex) + "\n";
  for (const TheoremUsed& use : t.uses()) {
    const LiteratureTheorem& theorem = *use.theorem;
    out += "\\item " + prose(theorem.name, tex) + " " + cited(theorem.cite) + ": " +
           prose(theorem.statement, tex) + "\n";
    if (use.hypotheses.empty()) continue;
    out += "\\begin{itemize}\n";
    for (const TheoremHypothesis& h : use.hypotheses)
      out += "\\item " + prose(settled(h) + h.text, tex) + "\n";
    out += "\\end{itemize}\n";
  }
  if (out.ends_with("\\begin{itemize}\n")) out += "\\item nothing\n";
  out += "\\end{itemize}\n\\section*{The steps}\n";
  for (const NodeResult& n : t.nodes)
    out += step(t, n, shown);
  return out + appendix(t) + bibliography(t) + "\\end{document}\n";
}

} // namespace kov::report
