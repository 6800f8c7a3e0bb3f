#pragma once
// The letters of canonical forms (l, m, n of Riemann's equation, k, m of Whittaker's ...) beside
// names that the given equation has for something else: these letters get an index.

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kov {

/// For each letter of the canonical forms among `taken` a name that is not: n -> n_1.  A letter
/// whose value is the name itself means the same on both sides and stays.
/// Example fresh_names({{"n", "2"}, {"m", "m"}}, {"m", "n"})  // -> {{n, n_1}}
[[nodiscard]] std::map<std::string, std::string>
fresh_names(const std::vector<std::pair<std::string, std::string>>& parameters,
            const std::set<std::string>& taken);

/// The text with whole names replaced.
/// Example renamed("n + nu", {{"n", "n_1"}})  // -> n_1 + nu
[[nodiscard]] std::string renamed(const std::string& text,
                                  const std::map<std::string, std::string>& names);

} // namespace kov
