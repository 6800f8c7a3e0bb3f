#pragma once
// The answer as data: the JSON object that `--format json` and batches print, and from which the
// text and LaTeX renderers read.  Format "kovacic-result/1".

#include "answer/answer.hpp"
#include "decide/decide.hpp"
#include "equation/read_equation.hpp"
#include "exact/letters.hpp"
#include "symbol/reading_note.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace kov::cli {

using Json = nlohmann::ordered_json;

/// Everything that is known before the solver runs; what it will find is null.
[[nodiscard]] Json open_result(const Json& id, const GivenEquation& equation);
/// The whole answer from the open result.  `seconds` is the time of reading and deciding;
/// solutions of more than `most_bytes` are not printed (0: no limit).
[[nodiscard]] Json closed_result(Json open, const Decision& decision, double seconds,
                                 std::size_t most_bytes, const Budget& budget);
/// Does one part of the work behind a verdict; what fails there is told under "failed", a list of
/// sentences, and costs this part only (decide/afterwards.hpp).
void do_part(Json& result, std::string_view part, const std::function<void()>& work);
/// The answer for an equation that could not even be read within the limits.
[[nodiscard]] Json unread_result(const Json& id);
/// Marks a result as undecided.  why: "budget", "parameter", "not-implemented", "inexact"
void set_undecided(Json& result, const std::string& why, const std::string& detail);

/// "solutions", the texts for programs, and "answer", what people read: y, where, unless, functions.
void put_answer(Json& result, const answer::Solutions& found);
/// The solutions in print: a basis where one is known, of the given equation where that is another
/// one; empty where there is only a polynomial for y'/y.
[[nodiscard]] std::vector<std::string> solutions_of(const Json& result);
/// Both solutions times exp(int gauge), those of y'' + p y' + q y = 0 with gauge = -p/2.  Null where
/// none are known, and where a limit leaves them out.
[[nodiscard]] Json basis_json(const Decision& decision, const RationalFunction& gauge,
                              std::size_t most_bytes, const Budget& budget);
/// {power, factor, polynomial}: y^power = factor*X for the solutions of y'' = r y, and the
/// coefficients of the polynomial of X (ascending).  given_factor: the factor for those of
/// the given equation, if gauge is not 0 and there is one.  {missing}: why there is none.
[[nodiscard]] Json polynomial_json(const Decision& decision, const RationalFunction& gauge,
                                   std::size_t most_bytes, const Budget& budget);
/// {equation, change, substitution, right_side}: the equation that was given, and what was done with
/// it, each where it was.
[[nodiscard]] Json given_json(const std::string& equation, const std::vector<ReadingNote>& notes);
/// "the given equation is y'' + y = x; its right side is left out here"; "" where that is decided.
/// For formats that show another equation only.
[[nodiscard]] std::string about_given(const Json& result);
/// The names of the question: the variables, parameters and unknowns of all its equations.
[[nodiscard]] std::set<std::string> names_of_question(const Json& result);
/// The letters that texts bring in (u, w, X, ...) beside the names of this equation.
[[nodiscard]] FreshLetters letters_beside(const Json& result);
/// y, or what the question calls the unknown function.
[[nodiscard]] std::string unknown_of(const Json& result);
/// Is y'' = r y another equation than the given one?
[[nodiscard]] bool is_transformed(const Json& result);

/// What the factor exp(-1/2 int p) does: the object under "original" of `result`.
void put_original_form(Json& result, const GivenEquation& equation, const Budget& budget);

/// A number, or a string where a reader of JSON would round it (beyond 2^53).
[[nodiscard]] Json json_integer(const Integer& n);

/// "yes", "no" or "undecided".
[[nodiscard]] const char* word_of(Truth t);
[[nodiscard]] std::string name_of(Unable::Why why);

} // namespace kov::cli
