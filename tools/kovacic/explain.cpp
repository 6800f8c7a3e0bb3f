// kovacic explain WORD: what a word in an answer or an error means, and what to do about it.

#include "commands.hpp"
#include "explain_topics.hpp"
#include "render.hpp"
#include "symbol/suggest.hpp"

#include <algorithm>

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

std::vector<std::string> names_of(const Topic& topic) {
  std::vector<std::string> names;
  const std::string all = topic.names;
  for (std::size_t at = 0, bar = 0; bar != std::string::npos; at = bar + 1) {
    bar = all.find('|', at);
    names.push_back(all.substr(at, bar == std::string::npos ? bar : bar - at));
  }
  return names;
}

const Topic* topic_called(const std::string& word) {
  for (const std::string& reading : readings(word))
    for (const Topic& topic : explain_topics())
      for (const std::string& name : names_of(topic))
        if (plain_word(name) == reading) return &topic;
  for (const std::string& reading : readings(word)) // a part of a name of several words
    for (const Topic& topic : explain_topics())
      for (const std::string& name : names_of(topic))
        if (reading.size() > 3 &&
            ("-" + plain_word(name) + "-").find("-" + reading + "-") != std::string::npos)
          return &topic;
  return nullptr;
}

} // namespace

int explain(const Settings& settings, const std::string& word) {
  std::vector<std::string> first, every;
  for (const Topic& topic : explain_topics()) {
    const auto names = names_of(topic);
    first.push_back(names.front());
    every.insert(every.end(), names.begin(), names.end());
  }
  if (word.empty()) {
    write_output(
        settings,
        "kovacic explain WORD, where WORD is one of these or another word of an answer\n\n  " +
            wrapped(enumerate(first), 2) + "\n");
    return exit_decided;
  }
  if (const Topic* topic = topic_called(word)) {
    const auto names = names_of(*topic);
    const std::vector<std::string> others(names.begin() + 1, names.end());
    write_output(settings,
                 names.front() + "\n\n" + wrapped(topic->text, 0) +
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
