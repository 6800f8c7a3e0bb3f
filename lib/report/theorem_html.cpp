#include "exact/joined.hpp"
#include "report/render_theorem.hpp"
#include "report/texts.hpp"

#include "theorem/prove.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <set>

namespace kov::report {
namespace {

constexpr Markup html = Markup::html;

std::string tag(const std::string& name, const std::string& inner,
                const std::string& attributes = {}) {
  return "<" + name + (attributes.empty() ? "" : " " + attributes) + ">" + inner + "</" + name +
         ">";
}

std::string badge(NodeStatus s, const std::string& text) {
  return tag("span", text, "class=\"badge " + to_string(s) + "\"");
}

std::string title_of(const NodeResult& n) { return prose(n.node.title, html); }

std::string tree(const TheoremResult& t) {
  std::set<std::string> seen;
  const std::function<std::string(const NodeResult&)> item = [&](const NodeResult& n) {
    std::string out = badge(n.status, status_of(n)) + " <a href=\"#" + verbatim(n.node.id, html) +
                      "\">" + title_of(n) + "</a>";
    if (n.rests_on_open) out += " <span class=\"soft\">(rests on open steps)</span>";
    if (!seen.insert(n.node.id).second)
      return tag("li", out + " <span class=\"soft\">(above)</span>");
    std::string inner;
    for (const Hypothesis& h : n.node.hypotheses)
      if (!h.checked)
        inner += tag("li", tag("span", "not checked", "class=\"badge open\"") +
                               " hypothesis: " + prose(h.text, html));
    for (const TheoremUsed& u : each_once(n.theorems))
      inner += tag("li", badge(NodeStatus::trusted, "trusted") + " " +
                             prose(u.theorem->in_words(), html));
    for (const std::string& c : n.node.needs)
      inner += item(*node_with(t, c));
    return tag("li", out + (inner.empty() ? "" : tag("ul", inner)));
  };
  std::string items;
  for (const NodeResult* n : roots(t))
    items += item(*n);
  return tag("ul", items, "class=\"tree\"");
}

std::string table(const Grid& g) {
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

std::string units(long thousandths) {
  return std::to_string(thousandths / 1000) + "." +
         std::to_string(1000 + thousandths % 1000).substr(1, 1);
}

std::string line(long x1, long y1, long x2, long y2) {
  return "<line x1=\"" + units(x1) + "\" y1=\"" + units(y1) + "\" x2=\"" + units(x2) + "\" y2=\"" +
         units(y2) + "\" stroke=\"#9aa4b2\"/>";
}

std::string picture(const PolePicture& p) {
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

// A theorem of the literature with its hypotheses.
std::string hypotheses_of(const TheoremUsed& use) {
  const LiteratureTheorem& t = *use.theorem;
  std::string list;
  for (const TheoremHypothesis& h : use.hypotheses)
    list += tag("li", prose(settled(h) + h.text, html),
                h.settled == Settled::open ? "class=\"warn\"" : "class=\"soft\"");
  return tag("li", tag("b", prose(t.name, html)) + " [" + prose(t.cite, html) +
                       "]: " + prose(t.statement, html) + tag("ul", list));
}

// The places of the first step, open to the eye.
std::string first_pictures(const TheoremResult& t) {
  std::string out;
  if (!t.nodes.empty() && t.nodes.front().node.kind == NodeKind::case_file)
    for (const PolePicture& p : t.nodes.front().pictures)
      if (!p.points.empty() && out.empty()) out = picture(p);
  return out;
}

std::string system(const TheoremResult& t, const InputFile& f) {
  std::string lines;
  for (const Formula& line : f.setting)
    lines += tag("dt", heading(line.label, html)) +
             tag("dd", formula(shortened(line.text, longest_on_a_page), html));
  return tag("p", tag("b", name_of_system(t, f, html) + ".") + " " + prose(f.assumed, html)) +
         tag("dl", lines);
}

// The systems that a step names; that of the theorem stands above.
std::string systems(const TheoremResult& t, const NodeResult& n) {
  std::string out;
  for (const InputFile& f : t.files)
    if ((f.name == n.node.file || f.name == n.node.other) && f.name != t.theorem.system &&
        !f.setting.empty())
      out += system(t, f);
  return out;
}

// The appendix: with what this was computed, from what, and what checks it again.
std::string appendix(const TheoremResult& t) {
  if (t.files.empty()) return "";
  std::string commands, files;
  for (const std::string& command : commands_to_check(t))
    commands += verbatim(command, html) + "\n";
  for (const InputFile& f : files_of(t))
    files += tag("tr", tag("td", verbatim(f.name, html)) +
                           tag("td", tag("code", f.sha256), "class=\"soft\""));
  return tag("h2", "How to check this") +
         (t.program.empty() ? "" : tag("p", "Computed by " + verbatim(t.program, html) + ".")) +
         tag("p", prose(how_to_check(t), html)) + tag("pre", commands) +
         (files.empty() ? ""
                        : tag("p", "The files, with SHA-256 of their bytes:", "class=\"caption\"") +
                              tag("div", tag("table", tag("tbody", files)), "class=\"scroll\""));
}

std::string bibliography(const TheoremResult& t) {
  std::string list;
  for (const Reference& r : references(t))
    list += tag("li", "[" + r.key + "] " + without_tex(r.authors) + ", " +
                          tag("i", without_tex(r.title)) + ", " + without_tex(r.published) + ".");
  return list.empty() ? "" : tag("h2", "References") + tag("ul", list);
}

std::string details_of(const TheoremResult& t, const NodeResult& n) {
  std::string out = systems(t, n);
  if (!n.statement.empty()) out += tag("p", prose(n.statement, html) + ".");
  if (!n.node.statement.empty())
    out += tag("p", prose(remark(n) + n.node.statement, html), "class=\"soft\"");
  std::string on = joined(n.node.needs, [&](const std::string& c) {
    return tag("a", title_of(*node_with(t, c)), "href=\"#" + verbatim(c, html) + "\"");
  });
  if (!on.empty()) out += tag("p", "Rests on: " + on, "class=\"soft\"");
  if (const std::string found = finding(n); !found.empty())
    out += tag("p", tag("b", "Found: ") + prose(found, html));
  for (const Hypothesis& h : n.node.hypotheses)
    out += h.checked ? tag("p",
                           "Hypothesis, for which the author names step " + verbatim(h.by, html) +
                               ": " + prose(h.text, html),
                           "class=\"soft\"")
                     : tag("p", "Hypothesis not checked: " + prose(h.text, html), "class=\"warn\"");
  std::string checks;
  for (const CheckedIdentity& c : n.checks)
    checks += tag("li", prose(c.statement, html), c.holds ? "" : "class=\"no\"");
  if (!checks.empty()) out += tag("ul", checks, "class=\"checks\"");
  std::string list;
  for (const Formula& f : n.formulas)
    list += tag("dt", heading(f.label, html)) +
            tag("dd", formula(shortened(f.text, longest_on_a_page), html));
  if (!list.empty()) out += tag("dl", list);
  for (const Grid& g : n.tables)
    out += table(g);
  for (const PolePicture& p : n.pictures)
    if (!p.points.empty()) out += picture(p);
  for (const TheoremUsed& u : each_once(n.theorems))
    out += tag("p", "By " + prose(u.theorem->in_words(), html) + ".");
  if (!n.node.file.empty())
    out += tag("p", "From the file " + tag("code", verbatim(n.node.file, html)) + ".",
               "class=\"soft\"");
  if (!n.node.note.empty()) out += tag("p", "Note: " + prose(n.node.note, html), "class=\"soft\"");
  return out;
}

std::string counts(const TheoremResult& t) {
  const auto count = [](std::size_t n, const std::string& one, const std::string& many) {
    return tag("li", tag("b", std::to_string(n)) + " " + (n == 1 ? one : many));
  };
  return tag("ul",
             count(t.count(NodeStatus::proved), "step proved here", "steps proved here") +
                 count(t.identities(), "exact identity checked", "exact identities checked") +
                 count(t.certificates(), "certificate accepted", "certificates accepted") +
                 count(t.uses().size(), "theorem trusted", "theorems trusted") +
                 count(t.trusted_steps().size(), "other step on trust", "other steps on trust") +
                 count(t.count(NodeStatus::reasoned), "argument in words", "arguments in words") +
                 count(t.unchecked_hypotheses().size(), "hypothesis not checked",
                       "hypotheses not checked") +
                 count(t.count(NodeStatus::open), "open", "open") +
                 tag("li", "in " + tag("b", t.time())),
             "class=\"counts\"");
}

} // namespace

std::string theorem_html(const TheoremResult& t) {
  std::string trusted;
  for (const std::string& s : t.trusted_steps())
    trusted += tag("li", prose(s, html));
  for (const std::string& s : t.unchecked_hypotheses())
    trusted += tag("li", "Hypothesis not checked: " + prose(s, html), "class=\"warn\"");
  for (const TheoremUsed& use : t.uses())
    trusted += hypotheses_of(use);
  if (trusted.empty()) trusted = tag("li", "nothing");
  std::string steps;
  for (const NodeResult& n : t.nodes)
    steps += tag("details",
                 tag("summary", badge(n.status, status_of(n)) + " " + title_of(n)) +
                     tag("div", details_of(t, n), "class=\"body\""),
                 "id=\"" + verbatim(n.node.id, html) + "\"" +
                     (n.status == NodeStatus::open ? " open" : ""));
  const std::string body =
      tag("h1", prose(t.theorem.title, html)) +
      (t.theorem.statement.empty()
           ? std::string()
           : tag("p", "The author&rsquo;s words: " + prose(t.theorem.statement, html),
                 "class=\"soft\"")) +
      tag("div", prose(t.conclusion(), html) + ".",
          std::string("class=\"verdict") + (!t.complete_but_for_words() ? " no\""
                                            : t.complete() && t.unchecked_hypotheses().empty()
                                                ? "\""
                                                : " but\"")) +
      (main_system(t) ? tag("details",
                            tag("summary", "The system") +
                                tag("div", system(t, *main_system(t)), "class=\"body\""),
                            "open")
                      : std::string()) +
      (t.statement().empty() ? std::string()
                             : tag("p", prose(t.statement(), html) + ".", "class=\"statement\"")) +
      counts(t) + first_pictures(t) + tag("h2", "What rests on what") + tree(t) +
      tag("h2", "Trusted, not proved here") + tag("ul", trusted) + tag("h2", "The steps") + steps +
      appendix(t) + bibliography(t);
  return html_page(t.theorem.title, body);
}

std::string html_page(const std::string& title, const std::string& body) {
  std::string page(text_file("page.html"));
  for (const auto& [mark, text] :
       {std::pair{"@title@", verbatim(title, html)},
        std::pair{"@style@", std::string(text_file("theorem.css"))}, std::pair{"@body@", body}})
    page.replace(page.find(mark), std::strlen(mark), text);
  return page;
}

} // namespace kov::report
