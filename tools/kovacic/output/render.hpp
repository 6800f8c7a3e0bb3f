#pragma once
// The answer for people: text for a terminal, LaTeX for a paper.

#include "equation/question.hpp"
#include "equations/result.hpp"
#include "report/formula.hpp"

#include <string>

namespace kov::cli {

struct Style {
  bool color = false;
  bool trace = false;
  bool quiet = false;    ///< the first lines only
  bool whole = false;    ///< every stratum with its reason
  bool solutions = true; ///< or why there are none
};

/// Answer first, then the reason, then what can be done next.
[[nodiscard]] std::string text_of_result(const Json& result, const std::string& title,
                                         const Style& style);
/// Paragraphs for a LaTeX document (amsmath), or for a page of HTML.
[[nodiscard]] std::string page_of_result(const Json& result, const std::string& title,
                                         report::Markup m);

/// The verdict in a line: "LIOUVILLIAN SOLUTIONS exactly when q = 0".
[[nodiscard]] std::string headline(const Json& result);
/// The equation that is decided: y'' + p y' + q y = 0, or y'' = r y.
[[nodiscard]] std::string question_text(const Json& result, const std::string& unknown);
/// "SL(2, C)", "T_4", "D_3", ... of the object under "group"; "" for null.
[[nodiscard]] std::string group_text(const Json& group);
/// "the Borel group": the name of an identity component.
[[nodiscard]] std::string component_text(const std::string& name);
/// "abelian", "not abelian", ... for "yes", "no", "undecided".
[[nodiscard]] std::string whether_abelian(const Json& word);
/// Lines of at most `width` columns (0: of the page); the first one begins after `indent` columns already
/// written.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t indent,
                                  std::size_t width = 0);
/// "a, b, c" of an array of texts.
[[nodiscard]] std::string listed(const Json& texts);
/// A line of an answer: the label, then the text in a column of its own.
[[nodiscard]] std::string labelled(const std::string& label, const std::string& text,
                                   std::size_t indent = 2);
void put(std::ostream& out, const std::string& label, const std::string& text,
         std::size_t indent = 2);
/// The first line of an answer about a file: its name and title, on two lines if one is too short.
[[nodiscard]] std::string heading(const std::string& file, const std::string& title);
/// How the question was read, as the members read_as and notes of a JSON answer, and as lines of a text.
[[nodiscard]] Json reading_json(const AskedEquation& question);
[[nodiscard]] std::string reading_text(const Json& reading);

/// Which flag or page helps an answer that is undecided for this reason.
[[nodiscard]] std::string way_out(const std::string& why, const std::string& detail);
/// The lines "open" and "more" of an answer that a limit ended.
[[nodiscard]] std::string limit_lines(const std::string& limit);

} // namespace kov::cli
