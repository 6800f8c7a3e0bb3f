#include "batch/kept_answers.hpp"

#include "commands.hpp"

#include <filesystem>
#include <fstream>

namespace kov::cli {
namespace {

int exit_of_answer(const Json& answer) {
  if (answer.contains("error")) {
    const Json& error = answer.at("error");
    const bool internal =
        error.is_string() && error.get<std::string>().starts_with("internal error");
    return internal ? exit_internal : exit_input;
  }
  return answer.contains("undecided") && !answer.at("undecided").is_null() ? exit_undecided
                                                                           : exit_decided;
}

Json read_answer(const std::string& line, const std::string& path, long number) {
  Json answer = Json::parse(line, nullptr, false);
  if (answer.is_object() && answer.contains("id")) return answer;
  throw InputError(path, number, 0, 1,
                   "this line is not an answer of a batch, so that nothing is added to the file",
                   "give another file to -o");
}

} // namespace

KeptAnswers kept_answers(const std::string& path) {
  KeptAnswers kept;
  std::ifstream in(path, std::ios::binary);
  if (!in && std::filesystem::exists(path))
    throw InputError(path, 0, 0, 1, "the file cannot be opened");
  long number = 0;
  for (std::string line;
       std::getline(in, line) && !in.eof();) { // at the end of the file: no whole line
    const Json answer = read_answer(line, path, ++number);
    kept.ids.push_back(answer.at("id"));
    kept.exit = worse(kept.exit, exit_of_answer(answer));
    for (const char* key : {"certificate_file", "loops_certificate_file"})
      if (answer.contains(key))
        kept.certificates.insert(std::filesystem::path(answer.at(key).get<std::string>()).stem());
    kept.bytes += line.size() + 1;
  }
  return kept;
}

} // namespace kov::cli
