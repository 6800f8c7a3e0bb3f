#pragma once
// Reads what to_string writes, into any type with + - * / and pow: sums, products, quotients,
// powers with natural exponents, numbers and names.  It shares nothing with the parser of the
// program, so that a text has to be right and not only agreed upon.

#include "exact/integer.hpp"

#include <cctype>
#include <map>
#include <stdexcept>
#include <string>

namespace kov::testing {

template <class T> class ReadBack {
public:
  /// The value of each name, and the way from a number.
  ReadBack(std::map<std::string, T> names, T (*number)(const Integer&, const T& like))
      : names_(std::move(names)), number_(number) {}

  [[nodiscard]] T operator()(const std::string& text) {
    text_.clear();
    at_ = 0;
    for (const char c : text)
      if (c != ' ') text_ += c;
    T value = sum();
    if (at_ != text_.size()) throw std::invalid_argument("cannot read '" + text + "'");
    return value;
  }

private:
  [[nodiscard]] bool take(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  [[nodiscard]] std::string run(int (*kind)(int)) {
    std::string word;
    while (at_ < text_.size() && kind(static_cast<unsigned char>(text_[at_])) != 0)
      word += text_[at_++];
    return word;
  }
  [[nodiscard]] T sum() {
    T value = take('-') ? -product() : product();
    while (true) {
      if (take('+'))
        value = value + product();
      else if (take('-'))
        value = value - product();
      else
        return value;
    }
  }
  [[nodiscard]] T product() {
    T value = power();
    while (true) {
      if (take('*'))
        value = value * power();
      else if (take('/'))
        value = value / power();
      else
        return value;
    }
  }
  [[nodiscard]] T power() {
    T base = atom();
    if (!take('^')) return base;
    const auto e = static_cast<unsigned>(std::stoul(run(std::isdigit)));
    return pow(base, e);
  }
  [[nodiscard]] T atom() {
    if (take('(')) {
      T value = sum();
      if (!take(')')) throw std::invalid_argument("')' is missing in '" + text_ + "'");
      return value;
    }
    if (const std::string digits = run(std::isdigit); !digits.empty())
      return number_(Integer::parse(digits), names_.begin()->second);
    const std::string name = run(std::isalnum);
    return names_.at(name);
  }

  std::map<std::string, T> names_;
  T (*number_)(const Integer&, const T&);
  std::string text_;
  std::size_t at_ = 0;
};

} // namespace kov::testing
