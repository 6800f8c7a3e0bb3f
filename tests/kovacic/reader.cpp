#include "kovacic/reader.hpp"

#include <cctype>
#include <stdexcept>

namespace kov::testing {
namespace {

class Reader {
public:
  Reader(const std::string& text, Field k) : k_(std::move(k)) {
    for (const char c : text)
      if (std::isspace(static_cast<unsigned char>(c)) == 0) text_ += c;
  }

  RationalFunction all() {
    RationalFunction f = sum();
    if (at_ != text_.size()) throw std::invalid_argument("cannot read " + text_.substr(at_));
    return f;
  }

private:
  bool take(const std::string& token) {
    if (text_.compare(at_, token.size(), token) != 0) return false;
    at_ += token.size();
    return true;
  }

  RationalFunction sum() {
    RationalFunction f = product();
    while (true) {
      if (take("+"))
        f += product();
      else if (take("-"))
        f -= product();
      else
        return f;
    }
  }

  RationalFunction product() {
    RationalFunction f = signed_power();
    while (true) {
      if (text_.compare(at_, 2, "**") != 0 && take("*"))
        f *= signed_power();
      else if (take("/"))
        f = f / signed_power();
      else
        return f;
    }
  }

  RationalFunction signed_power() {
    if (take("-")) return -signed_power();
    RationalFunction f = atom();
    if (take("^") || take("**")) {
      const bool parenthesis = take("(");
      const bool negative = take("-");
      const long e = to_long(digits());
      if (parenthesis) close();
      f = pow(f, negative ? -e : e);
    }
    return f;
  }

  RationalFunction atom() {
    if (take("(")) {
      RationalFunction f = sum();
      close();
      return f;
    }
    if (take("sqrt(")) {
      digits();
      close();
      return constant(NfElem::generator(k_));
    }
    if (take("I") || take("a")) return constant(NfElem::generator(k_));
    if (take("z")) return RationalFunction(Poly::z());
    return RationalFunction(Rational(digits()));
  }

  void close() {
    if (!take(")")) throw std::invalid_argument("expected ) at " + text_.substr(at_));
  }

  Integer digits() {
    std::string d;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0)
      d += text_[at_++];
    return Integer::parse(d);
  }

  static RationalFunction constant(const NfElem& c) { return RationalFunction(Poly(c)); }

  Field k_;
  std::string text_;
  std::size_t at_ = 0;
};

} // namespace

Field field_of(const std::string& text) {
  if (const auto at = text.find("sqrt("); at != std::string::npos)
    return make_field({Integer(-std::stol(text.substr(at + 5))), 0, 1}, "s");
  if (text.find('I') != std::string::npos) return make_field({1, 0, 1}, "I");
  return rationals();
}

RationalFunction read(const std::string& text, const Field& k) { return Reader(text, k).all(); }

} // namespace kov::testing
