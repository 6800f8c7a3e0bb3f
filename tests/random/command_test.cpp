// Random command lines, formulas, batch lines and files against the program: whatever comes, it
// ends with a documented exit code within its limits, never with 4 or a signal.

#include "support/random.hpp"
#include "support/smaller.hpp"

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace kov::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

// --- a grammar of formulas, with a little nonsense
// -----------------------------------------------

std::string number(Random& random) {
  static const Words special{"0",  "1",    "-1",   "1/2",         "-3/16",   "2/3", "1/0",
                             "10", "10^9", "2^64", "(10^12-1)/4", "sqrt(2)", "I",   "0.5"};
  return random.once_in(2) ? random.one_of(special) : std::to_string(random.between(-9, 9));
}

std::string formula(Random& random, const Words& names, int depth) {
  if (depth == 0 || random.once_in(4))
    return random.once_in(2) ? random.one_of(names) : number(random);
  const auto part = [&] { return formula(random, names, depth - 1); };
  switch (random.between(0, 9)) {
  case 0:
    return "(" + part() + ")^" + std::to_string(random.between(-3, 4));
  case 1:
    return "-(" + part() + ")";
  case 2:
    return "sqrt(" + part() + ")";
  case 3:
    return "(" + part() + ")^(" + part() + ")";
  default:
    return "(" + part() + ")" + random.one_of<std::string>({"+", "-", "*", "/", "/", "*"}) + "(" +
           part() + ")";
  }
}

// One character lost, doubled, or another one.
std::string damaged(Random& random, std::string text) {
  static const std::string letters = "()+-*/^'=,[]{}\"\\ \t\n\x01\xff"
                                     "0azZ_.;#";
  for (long n = random.between(0, 2); n > 0 && !text.empty(); --n) {
    const auto at = static_cast<std::size_t>(random.between(0, static_cast<long>(text.size()) - 1));
    const char other =
        letters[static_cast<std::size_t>(random.between(0, static_cast<long>(letters.size()) - 1))];
    if (random.once_in(3))
      text.erase(at, 1);
    else if (random.once_in(2))
      text.insert(at, 1, other);
    else
      text[at] = other;
  }
  return text;
}

std::string ode(Random& random, const Words& names) {
  return "(" + formula(random, names, 1) + ")*y'' + (" + formula(random, names, 1) + ")*y' + (" +
         formula(random, names, 2) + ")*y" + (random.once_in(2) ? " = 0" : "");
}

// --- command lines
// -------------------------------------------------------------------------------

const Words& with_parameter() {
  static const Words names{"z", "z", "z", "a"};
  return names;
}

std::string sentence(Random& random) {
  return random.one_of<std::string>({"a > 0", "a != 0", "a not an integer", "a = 1/2", "a complex",
                                     "a^2 = 2", "a > b", "a in Z", "b < 0", "a"});
}

Words flags(Random& random) {
  static const std::vector<Words> all{{"--case", "2"},
                                      {"--method", "all"},
                                      {"--method", "engines"},
                                      {"--method", "kovacic"},
                                      {"--trace"},
                                      {"--format", "json"},
                                      {"--format", "tex"},
                                      {"--exit-verdict"},
                                      {"-q"},
                                      {"-v"},
                                      {"--max-degree", "50"},
                                      {"--max-families", "3"},
                                      {"--max-print", "0"},
                                      {"--certificate", "proof.json"},
                                      {"--set", "a=1/2"},
                                      {"--set", "-1="},
                                      {"--set", "=3"},
                                      {"--parameter", "a"},
                                      {"--parameter", ""},
                                      {"--variable", "x"},
                                      {"--color", "always"},
                                      {"--manifold", "m"}};
  Words some;
  for (long n = random.between(0, 3); n > 0; --n) {
    const Words& f = random.one_of(all);
    some.insert(some.end(), f.begin(), f.end());
  }
  return some;
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

Words solve_line(Random& random) {
  Words words{"solve", "--timeout", "1", "--memory", "1024"};
  if (random.once_in(2))
    append(words, {"-r", damaged(random, formula(random, with_parameter(), 3))});
  else
    append(words, {"-e", damaged(random, ode(random, with_parameter()))});
  if (random.once_in(2)) append(words, {"--parameter", "a"});
  if (random.once_in(3)) append(words, {"--assume", damaged(random, sentence(random))});
  append(words, flags(random));
  return words;
}

Words family_line(Random& random) {
  Words words{random.one_of<std::string>({"lame", "potential"}), "--timeout", "1"};
  if (words[0] == "potential") {
    append(words, {"--degree", number(random)});
    if (random.once_in(2)) append(words, {"--eigenvalue", number(random)});
  } else {
    append(words, {"-n", number(random)});
    for (const char* name : {"--B", "--g2", "--g3"})
      if (random.once_in(2)) append(words, {name, formula(random, {"B", "s"}, 1)});
  }
  if (random.once_in(2)) append(words, flags(random));
  return words;
}

// --- files
// ---------------------------------------------------------------------------------------

std::string json_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text)
    out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return out + "\"";
}

std::string batch_line(Random& random) {
  const std::string id = random.one_of<std::string>(
      {"1", "\"a\"", "123456789012345678901234567890", "null", "[1, 2]", "1e400", "{}"});
  std::string line = "{\"id\": " + id +
                     ", \"r\": " + json_text(damaged(random, formula(random, with_parameter(), 2)));
  if (random.once_in(2))
    line += ", \"parameters\": " + random.one_of<std::string>({"[\"a\"]", "[\"a\", \"\"]", "[]",
                                                               "[\"1\"]", "\"a\"", "[3]"});
  if (random.once_in(3)) line += ", \"assumptions\": [" + json_text(sentence(random)) + "]";
  return random.once_in(4) ? damaged(random, line + "}") : line + "}";
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

std::string equation_file(Random& random) {
  return damaged(random, "format = \"equation/1\"\n[ode]\nvariable = \"z\"\nr = \"" +
                             formula(random, {"z"}, 3) + "\"\n[[expect]]\ngroup = \"SL2\"\n");
}

Words file_line(Random& random, const fs::path& directory) {
  if (random.once_in(2)) {
    std::string lines;
    for (long n = random.between(1, 4); n > 0; --n)
      lines += batch_line(random) + "\n";
    write(directory / "lines.jsonl", lines);
    return {"solve", "--batch", "lines.jsonl", "--timeout", "1", "--memory", "1024"};
  }
  write(directory / "equation.toml", equation_file(random));
  return {random.one_of<std::string>({"check", "test"}), "equation.toml", "--timeout", "1"};
}

// --- the program
// ---------------------------------------------------------------------------------

// The exit code, or minus the signal.
int run(const Words& words, const fs::path& directory) {
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string log = directory / "log";
    const int out = ::open(log.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    const int null = ::open("/dev/null", O_RDONLY);
    ::dup2(null, 0);
    ::dup2(out, 1);
    ::dup2(out, 2);
    std::vector<char*> arguments{const_cast<char*>(KOV_PROGRAM)};
    for (const std::string& word : words)
      arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (::chdir(directory.c_str()) == 0) {
      ::alarm(60); // far beyond every limit above
      ::execv(KOV_PROGRAM, arguments.data());
    }
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::string contents(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string shown(const Words& words) {
  std::string text = "kovacic";
  for (const std::string& word : words) {
    text += " '";
    for (const char c : word)
      text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += "'";
  }
  return text;
}

// The same end with less in it, also in a file.
std::string made_smaller(Words words, int exit, const fs::path& directory, const Random& random) {
  for (std::string& word : words)
    if (!word.starts_with('-'))
      word = smaller(
          word,
          [&](const std::string& next) {
            const std::string before = std::exchange(word, next);
            const bool same = run(words, directory) == exit;
            word = before;
            return same;
          },
          40);
  return "smaller: " + shown(words) + "\nin " + written_failure(random.seed(), shown(words)) + "\n";
}

TEST(RandomCommands, EndWithADocumentedExitCode) {
  fs::path directory = fs::temp_directory_path() / ("kovacic-attack-" + std::to_string(::getpid()));
  fs::create_directories(directory);
  random_rounds(400, [&](Random& random) {
    const long kind = random.between(0, 5);
    const Words words = kind < 3   ? solve_line(random)
                        : kind < 4 ? family_line(random)
                                   : file_line(random, directory);
    const int exit = run(words, directory);
    const bool verdict = std::find(words.begin(), words.end(), "--exit-verdict") != words.end();
    const bool documented = (exit >= 0 && exit <= 3) || (verdict && (exit == 10 || exit == 20));
    EXPECT_TRUE(documented) << shown(words) << "\nexit " << exit << "\n"
                            << (documented ? "" : made_smaller(words, exit, directory, random))
                            << contents(directory / "log").substr(0, 2000) << "\nlines.jsonl\n"
                            << contents(directory / "lines.jsonl") << "\nequation.toml\n"
                            << contents(directory / "equation.toml");
  });
  fs::remove_all(directory);
}

} // namespace
} // namespace kov::test
