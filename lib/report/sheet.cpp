#include "report/sheet.hpp"

#include "exact/joined.hpp"
#include "report/render_theorem.hpp"
#include "report/solution.hpp"
#include "symbol/expression.hpp"

#include <algorithm>
#include <numeric>

namespace kov::report {
namespace {

constexpr Markup tex = Markup::tex, html = Markup::html;

std::string tag(const std::string& name, const std::string& inner,
                const std::string& attributes = {}) {
  return "<" + name + (attributes.empty() ? "" : " " + attributes) + ">" + inner + "</" + name +
         ">";
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

std::string table_tex(const Grid& g) {
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

std::string table_html(const Grid& g) {
  std::string head, body;
  for (const std::string& h : g.header)
    head += tag("th", prose(h, html));
  if (g.rows.empty()) body = tag("tr", tag("td", "none"));
  for (const auto& row : g.rows) {
    std::string cells;
    for (const std::string& c : row)
      cells += tag("td", formula(shortened(c, 600), html));
    body += tag("tr", cells);
  }
  const std::string whole = tag("table", tag("thead", tag("tr", head)) + tag("tbody", body));
  return tag("p", prose(g.caption, html), "class=\"caption\"") +
         tag("div", whole, "class=\"scroll\"");
}

std::string thousandths(long x) {
  return std::to_string(x / 1000) + "." + std::to_string(1000 + x % 1000).substr(1);
}

std::string picture_tex(const PolePicture& p) {
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

std::string units(long thousandths) {
  return std::to_string(thousandths / 1000) + "." +
         std::to_string(1000 + thousandths % 1000).substr(1, 1);
}

std::string line(long x1, long y1, long x2, long y2) {
  return "<line x1=\"" + units(x1) + "\" y1=\"" + units(y1) + "\" x2=\"" + units(x2) + "\" y2=\"" +
         units(y2) + "\" stroke=\"#9aa4b2\"/>";
}

std::string picture_html(const PolePicture& p) {
  const PlacedPicture q = place(p, {420000, 240000, 6500, 12000});
  const auto down = [&](long y) { return q.height - y; };
  std::string out;
  if (p.strip && q.band)
    out += "<rect x=\"0\" y=\"" + units(down(q.band->second)) + "\" width=\"420\" height=\"" +
           units(q.band->second - q.band->first) + "\" fill=\"#eef2f8\"/>";
  if (q.axis_y) out += line(0, down(*q.axis_y), q.width, down(*q.axis_y));
  if (q.axis_x) out += line(*q.axis_x, 0, *q.axis_x, q.height);
  const auto words = [](long x, long y, const std::string& s, const std::string& anchor) {
    return "<text x=\"" + units(x) + "\" y=\"" + units(y) + "\" font-size=\"12\" text-anchor=\"" +
           anchor + "\" fill=\"#1d2430\">" + label(s, html) + "</text>";
  };
  for (const PlacedPoint& x : q.points)
    out += "<circle cx=\"" + units(x.x) + "\" cy=\"" + units(down(x.y)) + "\" r=\"4.5\" fill=\"" +
           (x.special ? "#b3261e" : "#2458a6") + "\"/>" +
           words(x.label_x, down(x.label_y) - 2000, x.label, "start");
  if (q.axis_y) out += words(q.width - 3000, down(*q.axis_y) - 5000, p.horizontal, "end");
  if (q.axis_x) out += words(*q.axis_x - 6000, 14000, p.vertical, "end");
  return tag("figure", tag("svg", out,
                           "viewBox=\"0 0 420 240\" width=\"420\" height=\"240\" role=\"img\" "
                           "xmlns=\"http://www.w3.org/2000/svg\" "
                           "style=\"border:1px solid #d9dee6;border-radius:.4rem\"") +
                           tag("figcaption", prose(p.caption, html)));
}

std::string with_class(const std::string& style) {
  return style.empty() ? "" : "class=\"" + style + "\"";
}

std::string displayed(const std::string& formula, Markup m) {
  try {
    return solution(parse_expression(formula, "page", true), m);
  } catch (const InputError&) {
    const std::string text = verbatim(formula, m);
    return m == tex ? "\\mathtt{" + text + "}" : "<mtext>" + text + "</mtext>";
  }
}

} // namespace

std::string Sheet::strong(const std::string& markup) const {
  return tex_ ? "\\textbf{" + markup + "}" : tag("b", markup);
}

std::string Sheet::cited(const std::string& key) const {
  return tex_ && reference(key) ? "\\cite{" + key + "}" : "[" + prose(key) + "]";
}

std::string Sheet::marked(const std::string& status, const std::string& words,
                          const std::string& title) const {
  return tex_ ? title + " \\status{" + words + "}"
              : tag("span", words, "class=\"badge " + status + "\"") + " " + title;
}

std::string Sheet::link(const std::string& id, const std::string& markup) const {
  return tex_ ? markup : tag("a", markup, "href=\"#" + verbatim(id, html) + "\"");
}

void Sheet::heading(const std::string& words) {
  out_ += tex_ ? "\\section*{" + words + "}\n" : tag("h2", words) + "\n";
}

void Sheet::paragraph(const std::string& markup, const std::string& style) {
  if (!tex_)
    out_ += tag(style == "verdict" || style.starts_with("verdict ") ? "div" : "p", markup,
                with_class(style)) +
            "\n";
  else
    out_ += "\\par " +
            (style == "remark" ? "\\textit{" + markup + "}"
             : style == "warn" ? strong(markup)
                               : markup) +
            "\n";
}

void Sheet::display(const std::vector<std::string>& formulas) {
  const std::string space = tex_ ? ",\\quad " : "<mo>,</mo><mspace width=\"1em\"/>";
  const std::string all = joined(
      formulas, [&](const std::string& f) { return displayed(f, m_); }, space);
  out_ += tex_ ? "\\[ " + all + " \\]\n" : "<p><math display=\"block\">" + all + "</math></p>\n";
}

void Sheet::begin_list(const std::string& style) {
  const bool commands = style == "commands";
  lists_.push_back(tex_ ? (commands ? "\\end{quote}\n" : "\\end{itemize}\n")
                        : (commands ? "</pre>\n" : "</ul>\n"));
  if (tex_)
    out_ += commands ? "\\begin{quote}\\small\n"
                     : "\\begin{itemize}\\setlength{\\itemsep}{0pt}" +
                           std::string(style.empty() ? "" : "\\small") + "\n";
  else
    out_ += commands ? "<pre>" : "<ul " + with_class(style) + ">\n";
}

void Sheet::item(const std::string& markup, const std::string& style) {
  if (lists_.back().find("quote") != std::string::npos)
    out_ += "\\texttt{" + markup + "}\\\\\n";
  else if (lists_.back().find("pre") != std::string::npos)
    out_ += markup + "\n";
  else if (tex_)
    out_ += (style == "yes"  ? "\\item[$\\checkmark$] "
             : style == "no" ? "\\item[NO] "
                             : "\\item ") +
            (style == "warn" ? strong(markup) : markup) + "\n";
  else
    out_ += tag("li", markup, with_class(style == "yes" ? "" : style)) + "\n";
}

void Sheet::end_list() {
  out_ += lists_.back();
  lists_.pop_back();
}

// Long polynomials break at their signs, since LaTeX has them in the line.
void Sheet::labelled(const std::vector<Formula>& lines) {
  std::string all;
  for (const Formula& line : lines) {
    const std::string label = report::heading(line.label, m_),
                      f = formula(shortened(line.text, longest_on_a_page), m_);
    all += tex_ ? "\\par\\hangindent=1.5em " + label + ": " + f + "\n"
                : tag("dt", label) + tag("dd", f);
  }
  if (!lines.empty()) out_ += tex_ ? "{\\small\n" + all + "\\par}\n" : tag("dl", all) + "\n";
}

void Sheet::table(const Grid& g) { out_ += tex_ ? table_tex(g) : table_html(g); }

void Sheet::picture(const PolePicture& p) {
  if (!p.points.empty()) out_ += tex_ ? picture_tex(p) : picture_html(p);
}

void Sheet::branch(std::size_t depth, const std::string& markup) {
  const std::string at = std::to_string(depth);
  out_ += tex_ ? "\\branch{" + at + "}{" + markup + "}\n"
               : tag("p", markup, "class=\"branch\" style=\"--depth:" + at + "\"") + "\n";
}

void Sheet::begin_box(const std::string& markup, const std::string& id, bool open) {
  out_ += tex_ ? "\n\\subsection*{" + markup + "}\n"
               : "<details id=\"" + verbatim(id, html) + "\"" + (open ? " open" : "") + ">" +
                     tag("summary", markup) + "<div class=\"body\">\n";
}

void Sheet::end_box() {
  if (!tex_) out_ += "</div></details>\n";
}

void Sheet::bibliography(const std::vector<Reference>& works) {
  if (works.empty()) return;
  out_ += tex_ ? "\\begin{thebibliography}{99}\n" : tag("h2", "References") + "<ul>\n";
  for (const Reference& r : works)
    out_ += tex_ ? "\\bibitem{" + r.key + "} " + r.authors + ", \\emph{" + r.title + "}, " +
                       r.published + ".\n"
                 : tag("li", "[" + r.key + "] " + without_tex(r.authors) + ", " +
                                 tag("i", without_tex(r.title)) + ", " + without_tex(r.published) +
                                 ".") +
                       "\n";
  out_ += tex_ ? "\\end{thebibliography}\n" : "</ul>\n";
}

} // namespace kov::report
