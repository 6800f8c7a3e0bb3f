// kovacic spectrum: for which E has y'' = r(z; E) y a Liouvillian solution?

#include "spectrum/spectrum.hpp"

#include "answer/answer.hpp"
#include "answer/notation.hpp"
#include "commands.hpp"
#include "equation/parametric_equation.hpp"
#include "equations/present_strata.hpp"
#include "equations/recognized.hpp"
#include "exact/joined.hpp"
#include "exact/lists.hpp"
#include "galois/group.hpp"
#include "output/render.hpp"
#include "parameters/statement.hpp"
#include "strata/log_integral.hpp"
#include "symbol/written.hpp"
#include "systems/mechanics.hpp"

#include <algorithm>
#include <sstream>

namespace kov::cli {
namespace {

using spectrum::AlgebraicSpectrum;
using spectrum::DegreeFamily;
using SpectrumLevel = spectrum::Level;
using spectrum::Piece;
using spectrum::Series;

struct Asked {
  EquationPart part;
  ParametricEquation equation; ///< of the part
  Json reading;
  std::size_t energy = 0;
  answer::Given given; ///< in the letters in which it was asked
};

struct AskedForAll {
  std::vector<Asked> parts;
  std::vector<EquationPart> none; ///< without an equation, or with one that is not known
};

// The variable and the parameters, as they were inferred.
ReadingNote names_note(const EquationText& text) {
  ReadingNote n{ReadingNote::What::names, {"", text.variable}};
  if (text.ode) n.of.front() = equation_names(text).unknown;
  n.of.insert(n.of.end(), text.parameters.begin(), text.parameters.end());
  return n;
}

AskedEquation question_of(const Settings& settings, const SpectrumArguments& a) {
  EquationText given;
  given.variable = a.variable;
  given.unknown = a.unknown;
  given.parameters = {a.energy};
  given.set = settings.settings();
  given.assume = assumed_texts(settings.assume, "--assume");
  AskedEquation question =
      asked_equation({a.r, a.ode, {}, {}, {}}, std::move(given), Door::options);
  EquationText& text = question.text;
  text.parameters.clear();
  take_all_parameters(text, a.energy);
  std::erase_if(question.notes,
                [](const ReadingNote& n) { return n.what == ReadingNote::What::names; });
  question.notes.insert(question.notes.begin(), names_note(text));
  return question;
}

AskedForAll read(const Settings& settings, const SpectrumArguments& a) {
  const AskedEquation question = question_of(settings, a);
  AskedForAll all;
  for (EquationPart& part : read_parts(question.text)) {
    if (!part.equation) {
      all.none.push_back(std::move(part));
      continue;
    }
    Asked asked{part, *part.equation, reading_json(question), 0,
                answer::given_equation(question.text)};
    try {
      asked.energy = energy_of(asked.equation, a.energy);
    } catch (const InvalidArgument& e) {
      throw InvalidArgument(std::string(e.what()) + " by --for NAME");
    }
    all.parts.push_back(std::move(asked));
  }
  return all;
}

// "E^2 - 8 = 0", "E*(E - 8)*(E + 8) = 0"
std::string equation_text(const MPoly& f) {
  const auto factors = factor(f).second;
  const bool irreducible = factors.size() == 1 && factors.front().exponent == 1;
  return (irreducible ? to_string(factors.front().base) : to_factored_string(MFraction(f))) +
         " = 0";
}

// Factored, unless that is one pair of parentheses.
std::string value_text(const MFraction& f) {
  if (is_zero(f) || !is_one(f.den())) return to_factored_string(f);
  const auto factors = factor(f.num()).second;
  return factors.size() == 1 && factors.front().exponent == 1 ? to_string(f)
                                                              : to_factored_string(f);
}

// ---- text

class Text {
public:
  Text(const Asked& asked, const AlgebraicSpectrum& spectrum)
      : q_(asked.equation.question), energy_(q_.r.ring()->name(asked.energy)), asked_(asked),
        spectrum_(spectrum) {}

  // first: it stands at the top of the answer
  std::string run(bool first) {
    if (first) {
      std::string question = written(asked_.given.ode);
      for (const auto& [name, value] : asked_.given.values)
        question += ", " + name + " = " + written(value);
      out_ << wrapped(question, 6) << '\n';
    }
    if (!asked_.part.where.empty())
      out_ << "where " << wrapped(answer::in_words(asked_.part), 6) << '\n';
    below(2, headline());
    if (first)
      for (const std::string& sentence : in_words(asked_.equation.assumed, q_.r.ring()))
        put("assumed", sentence);
    if (spectrum_.strata.contradictory) put("note", "no parameters satisfy the assumptions");
    for (const Piece& p : spectrum_.pieces)
      piece(p);
    if (const std::string u = FreshLetters(q_.r.ring())("u"); !is_zero(asked_.equation.p))
      put("in " + u, u + "'' = (" + to_string_by_powers(q_.r, q_.z) + ") " + u +
                         ": the groups are those of this equation");
    if (first) out_ << reading_text(asked_.reading);
    for (const std::string& text : spectrum_.strata.unvisited)
      put("open", "not studied, a limit was reached: " + text);
    for (const std::string& text : sentences(spectrum_.trusted))
      put("trusted", "the solver: " + text);
    return out_.str();
  }

private:
  void below(std::size_t indent, const std::string& text) {
    out_ << std::string(indent, ' ') << wrapped(text, indent + 2) << '\n';
  }
  void put(const std::string& label, const std::string& text) { cli::put(out_, label, text); }

  [[nodiscard]] std::string headline() const {
    const auto has = [&](Piece::Status s) {
      return std::ranges::any_of(spectrum_.pieces, [&](const Piece& p) { return p.status == s; });
    };
    using enum Piece::Status;
    if (has(conditions) || has(degrees) || has(all))
      return std::string("LIOUVILLIAN SOLUTIONS for these values of ") + energy_ +
             (spectrum_.decided() ? ", and no others" : "; others are not excluded");
    return spectrum_.decided() ? "NO LIOUVILLIAN SOLUTION for any " + energy_ : "UNDECIDED";
  }

  void piece(const Piece& p) {
    const std::string where = p.conditions.empty() ? "" : "where " + to_string(p.conditions) + ": ";
    switch (p.status) {
    case Piece::Status::no_equation:
      return put("none", where + "the equation means nothing there");
    case Piece::Status::none:
      return put("none", where + "the group is SL(2, C)");
    case Piece::Status::all:
      return put("all",
                 where + (p.conditions.empty() ? "every " + energy_ : "all of these") + groups(p));
    case Piece::Status::open:
      return put("open", where + open_reason(p));
    case Piece::Status::conditions:
      put("exactly", where + alternatives(p) + groups(p));
      for (const Series& s : p.series)
        series(s);
      if (!p.series.empty() && !p.unsolved.empty())
        below(12, "the other conditions are not solved for " + energy_);
      return;
    case Piece::Status::degrees:
      put("exactly", where + "if an exponential solution P exp(...) exists, P a polynomial:");
      for (const DegreeFamily& f : p.families)
        degrees(f);
    }
  }

  static std::string groups(const Piece& p) {
    std::string text;
    std::vector<std::string> seen;
    for (const GaloisGroup& g : p.groups) {
      const std::string one = describe(g);
      if (is_among(one, seen)) continue;
      seen.push_back(one);
      text += (text.empty() ? "; group " : " or ") + one;
    }
    return text;
  }

  static std::string alternatives(const Piece& p) {
    std::vector<Statement> none;
    for (const Statement& c : p.where)
      none.push_back(negation(c));
    return "if " + joined(
                       with_contraries(none), [](const auto& c) { return c.contrary; }, "; or ");
  }

  // The solution of the given equation; empty where p has no integral in closed form.
  [[nodiscard]] std::string solution(const SpectrumLevel& level, const std::string& before) const {
    const auto factor = strata::log_integral(asked_.equation.gauge, q_.z);
    if (!level.y || !factor) return {};
    spectrum::Eigenfunction y = *level.y;
    y.exponent += factor->exponential;
    y.powers.insert(y.powers.end(), factor->powers.begin(), factor->powers.end());
    const std::string plain = spectrum::to_string(y, q_.z);
    answer::Given there = asked_.given;
    if (level.fixed)
      there.values.insert_or_assign(q_.r.ring()->name(level.fixed->first),
                                    parse_expression(to_string(level.fixed->second), "a value"));
    const auto shown = answer::shown(there, {parse_expression(plain, "a solution")});
    return before + there.unknown + " = " +
           (shown.y.empty() ? plain : answer::for_people(shown.y.front()));
  }

  void series(const Series& s) {
    const std::string integer = s.equation.ring()->name(s.n);
    const std::string equation = equation_text(s.equation);
    const std::string some = ", for some integer " + integer;
    below(12, s.every_energy ? "every " + energy_ + " where " + equation + some
              : s.value      ? energy_ + " = " + value_text(*s.value) + some
                             : equation + some);
    for (const SpectrumLevel& level : s.first)
      if (level.y)
        below(14, integer + " = " + std::to_string(level.n) + ":  " + energy_ + " = " +
                      to_factored_string(level.fixed->second) + solution(level, ",  "));
  }

  void degrees(const DegreeFamily& f) {
    const bool number = is_constant(f.degree);
    if (!number)
      below(12, "the degree of P: " + kov::to_string(f.degree) + " = N, a natural number");
    for (const SpectrumLevel& level : f.first)
      below(14, (number ? "" : "N = " + std::to_string(level.n) + ":  ") + conditions(level) +
                    solution(level, ",  "));
    if (!f.open.empty()) put("open", f.open);
  }

  [[nodiscard]] std::string conditions(const SpectrumLevel& level) const {
    std::string text;
    const auto add = [&](const std::string& one) { text += (text.empty() ? "" : ", ") + one; };
    if (level.fixed)
      add(q_.r.ring()->name(level.fixed->first) + " = " + kov::to_string(level.fixed->second));
    for (const MPoly& f : level.equations)
      add(equation_text(f));
    return text.empty() ? "every " + energy_ : text;
  }

  const strata::Question& q_;
  std::string energy_;
  const Asked& asked_;
  const AlgebraicSpectrum& spectrum_;
  std::ostringstream out_;
};

// ---- JSON

Json as_json(const SpectrumLevel& level, const Ring& ring, std::size_t z) {
  Json j = {{"N", level.n}, {"equations", texts(level.equations)}};
  if (level.fixed) j["fixed"] = {{ring->name(level.fixed->first), to_string(level.fixed->second)}};
  if (level.y) j["y"] = spectrum::to_string(*level.y, z);
  return j;
}

Json as_json(const std::vector<SpectrumLevel>& levels, const Ring& ring, std::size_t z) {
  return list_of(levels, [&](const SpectrumLevel& level) { return as_json(level, ring, z); });
}

const char* status_text(Piece::Status s) {
  switch (s) {
  case Piece::Status::no_equation:
    return "no equation";
  case Piece::Status::none:
    return "none";
  case Piece::Status::all:
    return "all";
  case Piece::Status::conditions:
    return "conditions";
  case Piece::Status::degrees:
    return "degrees";
  case Piece::Status::open:
    return "open";
  }
  throw InternalError("status of a piece");
}

Json as_json(const Piece& p, const Ring& ring, std::size_t z) {
  Json series = Json::array();
  for (const Series& s : p.series)
    series.push_back({{"every_energy", s.every_energy},
                      {"value", s.value ? Json(to_string(*s.value)) : Json(nullptr)},
                      {"equation", to_string(s.equation)},
                      {"integer", s.equation.ring()->name(s.n)},
                      {"first", as_json(s.first, ring, z)}});
  Json degrees = Json::array();
  for (const DegreeFamily& f : p.families)
    degrees.push_back({{"degree", to_string(f.degree)},
                       {"first", as_json(f.first, ring, z)},
                       {"open", text_or_null(f.open)}});
  return {{"conditions", to_string(p.conditions)},
          {"status", status_text(p.status)},
          {"where", texts(p.where)},
          {"series", series},
          {"unsolved", texts(p.unsolved)},
          {"degrees", degrees},
          {"groups", list_of(p.groups, group_json)},
          {"open", p.why_open ? Json(open_reason(p)) : Json(nullptr)}};
}

Json as_json(const Asked& asked, const AlgebraicSpectrum& spectrum) {
  const auto& q = asked.equation.question;
  Json pieces = Json::array();
  for (const Piece& p : spectrum.pieces)
    pieces.push_back(as_json(p, q.r.ring(), q.z));
  Json j = {{"format", "kovacic-spectrum/1"},
            {"r", to_string(q.r)},
            {"for", q.r.ring()->name(asked.energy)},
            {"y_solves", "y'' = r y"},
            {"variable", asked.equation.variable},
            {"p", to_string(asked.equation.p)},
            {"assumptions", in_words(asked.equation.assumed, q.r.ring())},
            {"pieces", pieces},
            {"not_studied", spectrum.strata.unvisited},
            {"trusted", sentences(spectrum.trusted)},
            {"decided", spectrum.decided()}};
  j.update(asked.reading);
  return j;
}

} // namespace

int spectrum(const Settings& settings, const SpectrumArguments& arguments) {
  if (arguments.r.has_value() + arguments.ode.has_value() != 1) {
    complain(settings, arguments.r ? "two equations are given" : "no equation is given",
             "write e.g. kovacic spectrum -r 'z^6 - 7*z^2 - E'");
    return exit_input;
  }
  const Report report = supervised(settings, arguments.r ? "-r" : "-e", [&] {
    const AskedForAll asked = read(settings, arguments);
    spectrum::SpectrumOptions options;
    options.levels = arguments.levels;
    options.strata.decide = settings.solver_options();
    options.strata.decide.ask_the_judge = true;
    std::string text;
    bool decided = true;
    Json json;
    for (const Asked& one : asked.parts) {
      options.strata.decide.variable = one.equation.variable;
      const AlgebraicSpectrum found =
          spectrum::algebraic_spectrum(one.equation.question, one.energy, options);
      if (!found.strata.refusal.empty())
        throw InternalError("our own checker refuses the strata: " + found.strata.refusal);
      const bool last = &one == &asked.parts.back();
      if (found.strata.contradictory && !(last && json.is_null())) continue; // no values there
      decided = decided && found.decided();
      text += Text(one, found).run(json.is_null());
      Json here = as_json(one, found);
      if (!one.part.where.empty()) here["where"] = answer::in_words(one.part);
      if (json.is_null())
        json = std::move(here);
      else
        json["elsewhere"].push_back(std::move(here));
    }
    for (const EquationPart& part : asked.none) {
      const bool open = part.none.empty();
      decided = decided && !open;
      const std::string why = open ? "not decided: " + part.open : "there is no equation";
      text += "where " + wrapped(answer::in_words(part) + ": " + why, 6) + "\n";
      json["elsewhere"].push_back(
          {{"where", answer::in_words(part)}, {open ? "open" : "none", why}});
    }
    json["decided"] = decided;
    return Report{decided ? exit_decided : exit_undecided, text, json};
  });
  return written_report(settings, report);
}

} // namespace kov::cli
