#include "exact/joined.hpp"
#include "output/render.hpp"
#include "report/sheet.hpp"

#include "symbol/expression.hpp"

namespace kov::cli {
namespace {

using report::Markup;
using report::Sheet;

// In LaTeX these run on, as a paragraph.
void say(Sheet& page, std::string text) {
  if (text.starts_with("the ")) text[0] = 'T';
  page.paragraph(page.prose(text) + ".");
}

// The polynomial of this unknown; coefficients ascending.
std::string polynomial(const Json& c, const std::string& unknown) {
  std::string sum;
  for (std::size_t i = c.size(); i-- > 0;) {
    const std::string factor = c[i].get<std::string>();
    if (factor == "0") continue;
    sum += (sum.empty() ? "" : " + ") + (factor == "1" && i > 0 ? "" : "(" + factor + ")");
    if (i > 0) sum += (factor == "1" ? "" : "*") + unknown;
    if (i > 1) sum += "^" + std::to_string(i);
  }
  return sum + " = 0";
}

void put_polynomial_of_y(Sheet& page, const Json& result) {
  if (!result.contains("polynomial_of_y")) return;
  const Json& y = result.at("polynomial_of_y");
  const FreshLetters letter = letters_beside(result);
  const std::string x = letter("X");
  if (y.contains("missing"))
    return say(page, "No polynomial of " + unknown_of(result) + ": " +
                         y.at("missing").get<std::string>());
  const bool given = y.contains("given_factor");
  const std::string factor = y.at(given ? "given_factor" : "factor").get<std::string>();
  page.display({(is_transformed(result) && !given ? letter("u") : unknown_of(result)) + "^" +
                    y.at("power").dump() + " = " + (factor == "1" ? "" : "(" + factor + ")*") + x,
                polynomial(y.at("polynomial"), x)});
}

// y = ..., or y1 = ... and y2 = ...
void put_each(Sheet& page, const std::string& y, const Json& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    page.display(
        {y + (all.size() > 1 ? std::to_string(i + 1) : "") + " = " + all[i].get<std::string>()});
}

void put_solutions(Sheet& page, const Json& result) {
  const FreshLetters letter = letters_beside(result);
  const std::string u = is_transformed(result) ? letter("u") : unknown_of(result), w = letter("w");
  if (result.at("liouvillian").is_array())
    for (const Json& x : result.at("liouvillian"))
      if (x.contains("minimal_polynomial"))
        page.display({w + " = " + u + "'/" + u, polynomial(x.at("minimal_polynomial"), w)});
  if (result.at("solutions").is_array())
    put_each(page,
             result.contains("whole") ? result.at("whole").at("unknown").get<std::string>()
                                      : unknown_of(result),
             result.at("solutions"));
}

// One item for each stratum: for which parameters, and what is so there.
void put_strata(Sheet& page, const Json& result) {
  if (result.contains("contradictory")) say(page, "No parameters satisfy the assumptions");
  if (const Json& given = result.value("assumed", Json::array()); !given.empty())
    say(page, "Assumed: " + listed(given));
  if (result.contains("domain"))
    say(page, "There is an equation for " + listed(result.at("domain")) + " only");
  if (result.contains("no_equation")) // and a list without items is an error of LaTeX
    return say(page, result.at("no_equation").get<std::string>());
  page.begin_list();
  for (const Json& x : result.at("strata")) {
    const std::string group = x.at("group_text"), where = listed(x.at("conditions"));
    page.item(
        page.strong(page.prose(where.empty() ? "For all parameters" : "Where " + where) + ":"));
    if (x.contains("equation"))
      say(page, "Here the equation is " + x.at("equation").get<std::string>());
    say(page, (group.empty() ? "" : "The group is " + group + ". ") + "Its identity component is " +
                  whether_abelian(x.at("abelian")) + ": " + x.at("reason").get<std::string>());
    for (const Json& part : x.value("solutions", Json::array())) {
      if (!part.at("where").empty()) say(page, "Where " + listed(part.at("where")));
      put_each(page, unknown_of(result), part.at("y"));
    }
  }
  for (const Json& u : result.value("unvisited", Json::array())) {
    page.item(page.strong(page.prose("Where " + u.get<std::string>()) + ":"));
    say(page, "Open");
  }
  page.end_list();
  if (const Json& steps = result.at("trusted"); !steps.empty())
    say(page, "On trust: " + listed(steps));
}

// "The group is SL(2, C), its identity component SL(2, C), not abelian", as much of it as is known.
void put_group(Sheet& page, const Json& result) {
  const Json& component = result.at("identity_component");
  const std::string abelian = result.at("abelian"), group = group_text(result.at("group"));
  say(page, (group.empty() ? "The group is undecided" : "The group is " + group) +
                (component.is_null()
                     ? ", its identity component"
                     : ", its identity component " + component_text(component.get<std::string>())) +
                (abelian == "depends" ? " is abelian or not as the parameters are"
                                      : ", " + whether_abelian(result.at("abelian"))));
}

void put_equation(Sheet& page, const Json& result, bool given) {
  if (given) {
    std::vector<std::string> all{result.at("equation").get<std::string>()};
    if (result.contains("whole"))
      for (const Json& value : result.at("whole").value("values", Json::array()))
        all.push_back(value.get<std::string>());
    page.display(all);
  }
  if (result.contains("strata")) page.paragraph(page.strong(page.prose(headline(result))));
  put_solutions(page, result);
  const Json from = result.value("given", Json::object());
  if (result.at("r").is_null() || (given && !is_transformed(result) && from.size() < 2)) return;
  const std::string u = is_transformed(result) ? letters_beside(result)("u") : unknown_of(result);
  std::string how;
  for (const char* key : {"change", "substitution"})
    if (from.contains(key)) how += ", with " + from.at(key).get<std::string>();
  if (is_transformed(result))
    how += ", with " + unknown_of(result) + " = " + u + "*" +
           result.at("original").at("factor").get<std::string>();
  if (from.contains("right_side")) how += ", without the right side";
  if (given) say(page, "What follows is about this form of it" + how);
  page.display({u + "'' = (" + result.at("r").get<std::string>() + ")*" + u});
}

} // namespace

std::string page_of_result(const Json& result, const std::string& title, Markup m) {
  Sheet page(m);
  if (!title.empty()) page.paragraph(page.strong(page.prose(title)));
  put_equation(page, result, result.value("equation", Json()).is_string());
  if (result.contains("strata")) {
    put_strata(page, result);
  } else {
    put_group(page, result);
    if (!result.at("case").is_null())
      say(page, "Case " + result.at("case").dump() + " of Kovacic's algorithm");
    if (const std::string reason = result.at("reason"); !reason.empty()) say(page, reason);
    if (result.contains("second_opinion"))
      say(page, "A second opinion: " + result.at("second_opinion").at("text").get<std::string>());
  }
  put_polynomial_of_y(page, result);
  return page.text();
}

} // namespace kov::cli
