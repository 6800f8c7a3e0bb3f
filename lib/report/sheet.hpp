#pragma once
// A page that is written from top to bottom, in LaTeX or in HTML.

#include "literature/references.hpp"
#include "report/formula.hpp"
#include "theorem/theorem.hpp"

namespace kov::report {

/// Arguments called markup are made by `prose`, `strong`, `cited` and `marked`; others are plain texts.
class Sheet {
public:
  explicit Sheet(Markup m) : m_(m), tex_(m == Markup::tex) {}

  [[nodiscard]] std::string prose(const std::string& text) const { return report::prose(text, m_); }
  [[nodiscard]] std::string strong(const std::string& markup) const;
  [[nodiscard]] std::string cited(const std::string& key) const;
  /// A mark with the status, and a title.
  [[nodiscard]] std::string marked(const std::string& status, const std::string& words,
                                   const std::string& title) const;
  [[nodiscard]] std::string link(const std::string& id, const std::string& markup) const;

  void heading(const std::string& words);
  /// `style` is a class of theorem.css; LaTeX sets "remark" in italics and "warn" in bold letters.
  void paragraph(const std::string& markup, const std::string& style = {});
  /// Formulas on a line of their own.
  void display(const std::vector<std::string>& formulas);
  /// `style`: "checks" for what was checked, "commands", or nothing.
  void begin_list(const std::string& style = {});
  void item(const std::string& markup, const std::string& style = {});
  void end_list();
  void labelled(const std::vector<Formula>& lines);
  void table(const Grid& g);
  void picture(const PolePicture& p);
  void branch(std::size_t depth, const std::string& markup);
  void begin_box(const std::string& markup, const std::string& id, bool open);
  void end_box();
  void bibliography(const std::vector<Reference>& works);

  [[nodiscard]] const std::string& text() const { return out_; }

private:
  Markup m_;
  bool tex_;
  std::string out_;
  std::vector<std::string> lists_; ///< how those that are open end
};

} // namespace kov::report
