// kovacic explain WORD: what a word in an answer or an error means, and what to do about it.

#include "commands.hpp"
#include "output/render.hpp"
#include "output/texts.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>
#include <sstream>

namespace kov::cli {
namespace {

// "first integrals", "First_Integral" and "first-integral" are one word.
std::string plain_word(std::string word) {
  for (char& c : word)
    c = c == ' ' || c == '_' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const char* ending : {"'s", "'"})
    if (word.ends_with(ending)) word.resize(word.size() - std::string_view(ending).size());
  return word;
}

// A plural, and T_4, D_3 for T and D.
std::vector<std::string> readings(const std::string& word) {
  std::vector<std::string> all{plain_word(word)};
  const std::string plain = all.front();
  if (plain.ends_with("ies")) all.push_back(plain.substr(0, plain.size() - 3) + "y");
  if (plain.ends_with("es")) all.push_back(plain.substr(0, plain.size() - 2));
  if (plain.ends_with("s")) all.push_back(plain.substr(0, plain.size() - 1));
  if (const auto bar = word.find_first_of("_^"); bar != std::string::npos)
    all.push_back(plain_word(word.substr(0, bar)));
  return all;
}

struct Topic {
  std::vector<std::string> names;
  std::string text; ///< one paragraph
};

std::vector<std::string> names_in(const std::string& line) {
  std::vector<std::string> names;
  for (std::size_t at = 0, bar = 0; bar != std::string::npos; at = bar + 3) {
    bar = line.find(" | ", at);
    names.push_back(line.substr(at, bar == std::string::npos ? bar : bar - at));
  }
  return names;
}

std::vector<Topic> read_topics() {
  std::vector<Topic> all;
  std::istringstream lines{std::string(text_file("topics.txt"))};
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  "))
      all.back().text += (all.back().text.empty() ? "" : " ") + line.substr(2);
    else if (!line.empty() && line.front() != '#')
      all.push_back({names_in(line), ""});
  return all;
}

const Topic* topic_called(const std::string& word, const std::vector<Topic>& all) {
  for (const std::string& reading : readings(word))
    for (const Topic& topic : all)
      for (const std::string& name : topic.names)
        if (plain_word(name) == reading) return &topic;
  for (const std::string& reading : readings(word)) // a part of a name of several words
    for (const Topic& topic : all)
      for (const std::string& name : topic.names)
        if (reading.size() > 3 &&
            ("-" + plain_word(name) + "-").find("-" + reading + "-") != std::string::npos)
          return &topic;
  return nullptr;
}

} // namespace

int explain(const Settings& settings, const std::string& word) {
  std::vector<std::string> first, every;
  const std::vector<Topic> all = read_topics();
  for (const Topic& topic : all) {
    first.push_back(topic.names.front());
    every.insert(every.end(), topic.names.begin(), topic.names.end());
  }
  if (word.empty()) {
    write_output(
        settings,
        "kovacic explain WORD, where WORD is one of these or another word of an answer\n\n  " +
            wrapped(enumerate(first), 2) + "\n");
    return exit_decided;
  }
  if (const Topic* topic = topic_called(word, all)) {
    const std::vector<std::string> others(topic->names.begin() + 1, topic->names.end());
    write_output(settings,
                 topic->names.front() + "\n\n" + wrapped(topic->text, 0) +
                     (others.empty() ? "" : "\n\n" + wrapped("Also: " + listed(Json(others)), 0)) +
                     "\n");
    return exit_decided;
  }
  const auto near = nearest(word, every);
  complain(settings, "nothing is known about '" + word + "'",
           near ? "did you mean " + *near + "?" : "kovacic explain lists the words");
  return exit_input;
}

} // namespace kov::cli
