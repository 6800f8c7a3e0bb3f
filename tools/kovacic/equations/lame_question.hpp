#pragma once
// What `kovacic lame` is asked: n (or alpha = n(n+1)), B, g2 and g3 as numbers or with free names.

#include "closed/lame.hpp"
#include "commands.hpp"
#include "symbol/document.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kov::cli {

/// The texts, as given.
struct LameTexts {
  std::optional<Expression> n, alpha, b, g2, g3;
  std::vector<std::pair<std::string, Expression>> set;
};

/// alpha = n(n+1), if it is a number.
struct LameDegree {
  std::optional<NfElem> alpha;
  MFraction symbolic; ///< alpha otherwise
  std::string text;   ///< "n = 3/2", "alpha = 2 - 2*A/C"
};

struct LameQuestion {
  LameDegree degree;
  std::variant<LameParameters<NfElem>, LameParameters<MFraction>> parameters;
  std::vector<std::string> free; ///< names without a value
  std::string constants;         ///< "s = root(x^2 - 2, 1.41)"; empty over Q
};

/// From options, or the [lame] table of a file.
[[nodiscard]] LameTexts lame_texts(const Settings& settings, const LameArguments& arguments);
[[nodiscard]] LameTexts lame_texts(const Settings& settings, const Entry& document);

/// A value that is not given is a free name: B, g2 or g3.
/// Errors  InputError: neither or both of n and alpha; roots beside free names
[[nodiscard]] LameQuestion read_lame(const LameTexts& texts);

} // namespace kov::cli
