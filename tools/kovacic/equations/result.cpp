#include "equations/result.hpp"

#include "answer/notation.hpp"
#include "answer/solve.hpp"
#include "decide/afterwards.hpp"
#include "decide/words.hpp"
#include "equations/recognized.hpp"
#include "exact/letters.hpp"
#include "exact/tried.hpp"
#include "galois/algebraic_solution.hpp"
#include "symbol/expression.hpp"

#include <algorithm>
#include <functional>
#include <set>

namespace kov::cli {

void do_part(Json& result, std::string_view part, const std::function<void()>& work) {
  if (std::string failed = failure_of(part, work); !failed.empty())
    result["failed"].push_back(std::move(failed));
}

Json json_integer(const Integer& n) {
  const Integer limit = pow(Integer(2), 53);
  if (n <= limit && n >= -limit) return to_long(n);
  return to_string(n);
}

Json basis_json(const Decision& d, const RationalFunction& gauge, std::size_t most_bytes,
                const Budget& budget) {
  try {
    const auto both = answer::basis_of(d, gauge, budget);
    if (!both || (most_bytes > 0 && both->first.size() + both->second.size() > most_bytes))
      return nullptr;
    return {both->first, both->second};
  } catch (const OutOfBudget&) {
    return nullptr;
  }
}

Json polynomial_json(const Decision& d, const RationalFunction& gauge, std::size_t most_bytes,
                     const Budget& budget) {
  const auto missing = [](const std::string& why) { return Json{{"missing", why}}; };
  if (d.no_solutions) return missing(to_string(*d.no_solutions));
  if (!d.group || d.proof() == nullptr) return missing("the group is not known");
  try {
    const auto y = algebraic_solution(*d.proof(), d.r, budget);
    if (!y) return missing("the group is none of A4, S4, A5");
    Json j = {{"power", y->power},
              {"factor", to_string(y->factor, d.variable)},
              {"polynomial", Json::array()}};
    if (!is_zero(gauge))
      if (const auto given = times_exponential(*y, gauge, budget))
        j["given_factor"] = to_string(given->factor, d.variable);
    std::size_t bytes = 0;
    for (const Poly& c : y->polynomial) {
      j["polynomial"].push_back(to_string(c, d.variable));
      bytes += j["polynomial"].back().get_ref<const std::string&>().size();
      if (most_bytes > 0 && bytes > most_bytes)
        return missing("size limit: it takes more than " + std::to_string(most_bytes >> 20) +
                       " MiB");
    }
    return j;
  } catch (const OutOfBudget& limit) {
    return missing(limit.what());
  }
}

namespace {

Json solution(const PrintedSolution& s, const std::string& note) {
  Json j;
  if (s.minimal_polynomial.empty()) {
    j["kind"] = "exponential";
    j["y"] = s.y;
    j["omega"] = s.omega;
  } else {
    j["kind"] = "minimal-polynomial";
    j["minimal_polynomial"] = s.minimal_polynomial;
  }
  if (!note.empty()) j["note"] = note;
  return j;
}

// Absent where nothing is known; all of them, or why there are none.
void put_solutions(Json& j, const Decision& d, std::size_t most_bytes, const Budget& budget) {
  if (d.no_solutions) {
    j["no_solutions"] = to_string(*d.no_solutions);
    return;
  }
  if (!d.group && d.solutions.empty()) return;
  try {
    Json all = Json::array();
    const std::string failed = failure_of("printing the solutions", [&] {
      for (const PrintedSolution& s : printed_solutions(d, most_bytes, budget))
        all.push_back(solution(s, note(d.solutions[all.size()])));
    });
    if (failed.empty())
      j["liouvillian"] = std::move(all);
    else
      j["no_solutions"] = failed;
  } catch (const OutOfBudget& limit) {
    j["no_solutions"] = limit.what();
  }
}

// The basis, if "liouvillian" names one line or a minimal polynomial only.
void put_basis(Json& j, const Decision& d, std::size_t most_bytes, const Budget& budget) {
  if (d.solutions.size() != 1) return;
  if (Json both = basis_json(d, {}, most_bytes, budget); !both.is_null())
    j["basis"] = std::move(both);
}

} // namespace

const char* word_of(Truth t) {
  return t == Truth::yes ? "yes" : t == Truth::no ? "no" : "undecided";
}

std::string name_of(Unable::Why why) {
  switch (why) {
  case Unable::Why::parameter:
    return "parameter";
  case Unable::Why::budget:
    return "budget";
  case Unable::Why::not_implemented:
    return "not-implemented";
  case Unable::Why::inexact:
    return "inexact";
  case Unable::Why::methods_disagree:
    return "methods-disagree";
  }
  throw InternalError("unknown reason code");
}

Json unread_result(const Json& id) {
  static const Json blank{{"format", "kovacic-result/1"},
                          {"id", nullptr},
                          {"variable", nullptr},
                          {"r", nullptr},
                          {"group", nullptr},
                          {"identity_component", nullptr},
                          {"abelian", "undecided"},
                          {"case", nullptr},
                          {"equation", nullptr},
                          {"solutions", nullptr},
                          {"liouvillian", nullptr},
                          {"reason", ""},
                          {"undecided", nullptr},
                          {"seconds", nullptr},
                          {"recognized", nullptr}};
  Json j = blank;
  j["id"] = id;
  return j;
}

Json open_result(const Json& id, const GivenEquation& equation) {
  Json j = unread_result(id);
  j["variable"] = equation.variable;
  if (equation.form == GivenEquation::Form::ode) j["unknown"] = equation.unknown;
  j["r"] = to_string(equation.normal_form.r, equation.variable);
  if (!equation.constant.empty()) j["constants"] = {{equation.constant, equation.constant_meaning}};
  if (equation.unknown != "y") j["unknown"] = equation.unknown;
  return j;
}

Json closed_result(Json open, const Decision& d, double seconds, std::size_t most_bytes,
                   const Budget& budget) {
  Json j = std::move(open);
  if (d.group) j["group"] = group_json(*d.group);
  if (d.component) j["identity_component"] = to_string(*d.component);
  j["abelian"] = word_of(d.abelian);
  if (d.kovacic_case) j["case"] = *d.kovacic_case;
  put_solutions(j, d, most_bytes, budget);
  do_part(j, "the basis of the solutions", [&] { put_basis(j, d, most_bytes, budget); });
  do_part(j, "the words for the reason", [&] { j["reason"] = reason(d); });
  if (d.undecided)
    j["undecided"] = {{"why", name_of(d.undecided->why)}, {"detail", d.undecided->detail}};
  j["seconds"] = seconds;
  if (!d.trace.empty()) {
    j["trace"] = Json::array();
    for (const kovacic::Step& step : d.trace)
      j["trace"].push_back({{"step", name(step)}, {"text", step.text}});
  }
  if (!d.no_certificate.empty()) j["no_certificate"] = d.no_certificate;
  if (!d.refused.empty()) j["refused_by_checker"] = d.refused;
  return j;
}

void set_undecided(Json& result, const std::string& why, const std::string& detail) {
  result["reason"] = detail;
  result["undecided"] = {{"why", why}, {"detail", detail}};
}

Json given_json(const std::string& equation, const std::vector<ReadingNote>& notes) {
  using What = ReadingNote::What;
  Json j{{"equation", equation}};
  for (const ReadingNote& n : notes) {
    if (n.what == What::variable) j["change"] = n.of.at(0);
    if (n.what == What::riccati || n.what == What::bernoulli) j["substitution"] = n.of.at(0);
    if (n.what == What::first_order) j["with_constants"] = n.of.at(0);
    if (n.what == What::homogeneous) j["right_side"] = n.of.at(1);
  }
  if (j.contains("change") && j.contains("substitution")) // u' in it is by the given variable
    j["substitution"] = j["substitution"].get<std::string>() + " (before the change of variable)";
  return j;
}

std::string about_given(const Json& result) {
  if (!result.contains("given")) return {};
  const Json& given = result.at("given");
  std::string text = "the given equation is " + given.at("equation").get<std::string>();
  if (given.contains("right_side")) text += "; its right side is left out here";
  if (given.contains("with_constants"))
    text += "; here its solutions without the right side, with the constants";
  if (given.contains("substitution"))
    text += "; here " + given.at("substitution").get<std::string>();
  if (given.contains("change"))
    text += "; here in the variable " + given.at("change").get<std::string>();
  return text;
}

std::string unknown_of(const Json& result) {
  return result.contains("unknown") ? result.at("unknown").get<std::string>()
                                    : letters_beside(result)("y");
}

std::set<std::string> names_of_question(const Json& result) {
  std::set<std::string> taken;
  const auto take = [&](const Json& text) {
    if (text.is_string()) taken.merge(names_in_text(text.get_ref<const std::string&>()));
  };
  take(result.at("variable"));
  take(result.at("r"));
  if (result.contains("original"))
    for (const char* key : {"p", "q"})
      take(result.at("original").at(key));
  if (result.contains("constants"))
    for (const auto& [name, meaning] : result.at("constants").items())
      taken.merge(names_in_text(name));
  if (result.contains("unknown")) take(result.at("unknown"));
  if (result.contains("given"))
    for (const Json& text : result.at("given"))
      take(text);
  for (const char* function : {"I", "exp", "sin", "cos", "sqrt"})
    taken.erase(function);
  return taken;
}

FreshLetters letters_beside(const Json& result) {
  FreshLetters letters(names_of_question(result));
  if (result.contains("unknown") && result.at("unknown") == "y") letters.keep("y");
  return letters;
}

bool is_transformed(const Json& result) {
  return result.contains("original") && result.at("original").at("factor") != "1";
}

namespace {

// Is a function of the formula called like one of the names?
bool has_function(const Expression& e,
                  const std::function<bool(const Expression& call)>& is_called_so) {
  return (e.kind() == Expression::Kind::call && is_called_so(e)) ||
         std::ranges::any_of(e.operands(), [&](const Expression& part) {
           return has_function(part, is_called_so);
         });
}

// x**2*besselk(K, x) as x^2*besselk(K, x)
std::string with_carets(std::string text) {
  for (auto at = text.find("**"); at != std::string::npos; at = text.find("**", at))
    text.replace(at, 2, "^");
  return text;
}

} // namespace

void put_answer(Json& result, const answer::Solutions& found) {
  std::set<std::string> names{result.at("variable").get<std::string>()};
  for (const char* key : {"r", "equation"})
    if (result.contains(key) && result.at(key).is_string())
      tried<InputError>([&] { // an operator is no equation
        for (const std::string& name :
             names_in(parse_expression(result.at(key).get<std::string>(), key, true)))
          names.insert(name);
      });
  const auto has = [&](const auto& is_called_so) {
    return std::ranges::any_of(found.y,
                               [&](const Expression& y) { return has_function(y, is_called_so); });
  };
  if (has([&](const Expression& call) { return names.contains(call.name()); })) {
    result["solutions"] = Json::array(); // a variable called exp
    return;
  }
  const bool in_books = !has([&](const Expression& call) { // K_n(x) beside a parameter K
    const auto books = answer::in_books(call);
    return books && names.contains(books->letter);
  });
  result["solutions"] = answer::for_programs(found);
  Json answer{{"y", Json::array()}};
  for (const Expression& y : found.y)
    answer["y"].push_back(in_books ? answer::for_people(y) : with_carets(answer::for_programs(y)));
  if (!found.where.empty()) answer["where"] = found.where;
  if (!found.unless.empty()) answer["unless"] = found.unless;
  if (const std::string functions = answer::meaning_of_functions(found);
      in_books && !functions.empty())
    answer["functions"] = functions;
  if (!found.read_back) answer["not_read_back"] = true;
  for (const std::string& text : found.failed)
    result["failed"].push_back(text);
  if (!found.y.empty()) result["answer"] = std::move(answer);
}

std::vector<std::string> solutions_of(const Json& result) {
  if (is_transformed(result) && result.at("original").contains("solutions"))
    return result.at("original").at("solutions").get<std::vector<std::string>>();
  if (result.contains("basis")) return result.at("basis").get<std::vector<std::string>>();
  std::vector<std::string> all;
  if (result.at("liouvillian").is_array())
    for (const Json& s : result.at("liouvillian"))
      if (s.contains("y")) all.push_back(s.at("y").get<std::string>());
  return all;
}

// y = u exp(-1/2 int p), u'' = r u.  Scalars are central: docs/theory/normal_form.md, 1.5.
void put_original_form(Json& result, const GivenEquation& e, const Budget& budget) {
  if (derivative(e.p) * RationalFunction(Rational(1, 2)) +
          e.p * e.p * RationalFunction(Rational(1, 4)) - e.q !=
      e.normal_form.r)
    throw Contradiction("the normal form is not the one of the given equation");
  Json j = {{"form", e.form == GivenEquation::Form::pq ? "p, q" : "equation"},
            {"p", to_string(e.p, e.variable)},
            {"q", to_string(e.q, e.variable)}};
  answer::GaugeFactor by{"exp(-1/2*int(" + to_string(e.p, e.variable) + "))"};
  do_part(result, "the factor of the solutions", [&] { by = answer::factor_of(e, budget); });
  static const char* const kinds[]{"unknown", "rational", "algebraic", "transcendental"};
  const std::string kind = kinds[static_cast<std::size_t>(by.kind)];
  j["factor"] = by.text;
  j["factor_kind"] = kind;
  if (is_zero(e.p)) {
    j["note"] = "the equation is in normal form already";
    result["original"] = std::move(j);
    return;
  }
  std::string note = "solutions are those of u'' = r*u times the factor; it multiplies the group "
                     "by scalars only, so the identity component is abelian for both or for none";
  if (kind == "rational") note += "; the factor is rational, so the groups are equal";
  if (kind == "algebraic") note += "; the factor is algebraic, so both groups are finite or none";
  if (kind == "transcendental")
    note += "; the factor is transcendental, so the group of the given equation is infinite";
  j["note"] = letters_beside({{"variable", e.variable}, {"r", nullptr}, {"original", j}}).in(note);
  result["original"] = std::move(j);
}

} // namespace kov::cli
