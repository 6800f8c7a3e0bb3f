#include "proof/text/json_node.hpp"

#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "proof/text/limits.hpp"

#include <algorithm>
#include <limits>

namespace kov::certify {

bool is_natural(std::string_view s) { // no sign, no leading zero
  return !s.empty() && s.size() <= 200000 && s[0] >= '1' && s[0] <= '9' &&
         std::ranges::all_of(s, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_name(std::string_view s) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  return !s.empty() && s.size() <= 1000 && letter(s[0]) &&
         std::ranges::all_of(s, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

namespace {

bool is_integer_text(std::string_view s) {
  return s == "0" || is_natural(s) || (s.size() > 1 && s[0] == '-' && is_natural(s.substr(1)));
}

bool is_rational_text(std::string_view s) {
  const std::size_t slash = s.find('/');
  if (slash == std::string_view::npos) return is_integer_text(s);
  return is_integer_text(s.substr(0, slash)) && s[0] != '0' && is_natural(s.substr(slash + 1));
}

} // namespace

void Node::fail(const std::string& what) const { throw InvalidArgument(path_ + ": " + what); }

std::string Node::text() const {
  if (!j_->text()) fail("a string is expected");
  return *j_->text();
}

bool Node::truth() const {
  if (!j_->truth()) fail("true or false is expected");
  return *j_->truth();
}

Integer Node::integer() const {
  if (!j_->text() || !is_integer_text(*j_->text())) fail("an integer in a string is expected");
  return Integer::parse(*j_->text());
}

long Node::count() const { // clamped
  const Integer n = integer();
  const long top = std::numeric_limits<long>::max() / 2;
  return fits_long(n) ? std::clamp(to_long(n), -top, top) : sign(n) * top;
}

mp_limb_t Node::modulus() const { // 0 if out of range: not a prime
  const long n = count();
  return n < 0 || n >= (long{1} << 62) ? 0 : static_cast<mp_limb_t>(n);
}

mp_limb_t Node::residue() const {
  const Integer n = integer();
  if (sign(n) < 0 || n >= Integer(long{1} << 62)) fail("a residue is expected");
  return static_cast<mp_limb_t>(to_long(n));
}

Rational Node::rational() const {
  if (!j_->text() || !is_rational_text(*j_->text())) fail("a rational number is expected");
  return Rational::parse(*j_->text());
}

std::vector<Node> Node::items() const {
  const auto* a = j_->array();
  if (!a || a->size() > max_length) fail("an array is expected");
  std::vector<Node> out;
  out.reserve(a->size());
  for (std::size_t i = 0; i < a->size(); ++i)
    out.emplace_back((*a)[i], path_ + "[" + std::to_string(i) + "]", *k_);
  return out;
}

std::vector<Node> Node::items(std::size_t n, const std::string& why) const {
  auto all = items();
  if (all.size() != n) fail(why);
  return all;
}

// The coordinates of all coefficients over one denominator, which most of them have: so FLINT's polynomial is
// made at once.
Poly Node::poly() const {
  Poly f(*k_);
  const auto stride = static_cast<std::size_t>(f.stride());
  std::vector<Integer> num, den;
  Integer common(1);
  std::size_t top = 0, length = 0;
  const auto add = [&](const Node& n) {
    if (!n.j_->text() || !is_rational_text(*n.j_->text())) n.fail("a rational number is expected");
    const std::string_view text = *n.j_->text();
    const std::size_t slash = std::min(text.find('/'), text.size());
    num.push_back(Integer::parse(text.substr(0, slash)));
    den.push_back(slash == text.size() ? Integer(1) : Integer::parse(text.substr(slash + 1)));
    if (den.back() != common) common = lcm(common, den.back());
    top = std::max<std::size_t>(top, fmpz_bits(num.back().raw()));
  };
  for (const Node& n : items()) {
    num.resize(stride * length);
    den.resize(num.size(), common);
    if (!n.j_->array())
      add(n);
    else if (const auto all = n.items(); static_cast<long>(all.size()) <= (*k_)->degree())
      std::ranges::for_each(all, add);
    if (num.size() == stride * length) n.fail("an element of the field is expected");
    const auto size = static_cast<double>(top + 2 * fmpz_bits(common.raw()));
    if (static_cast<double>(++length) * size > max_bulk) fail("the polynomial is too large");
  }
  const auto n = static_cast<slong>(num.size());
  fmpq_poly_fit_length(f.raw(), n);
  _fmpq_poly_set_length(f.raw(), n);
  for (std::size_t i = 0; i < num.size(); ++i) {
    const Integer c = den[i] == common ? num[i] : num[i] * exact_div(common, den[i]);
    fmpz_set(f.raw()->coeffs + i, c.raw());
  }
  _fmpq_poly_normalise(f.raw());
  if (length > 0 && fmpq_poly_length(f.raw()) <= static_cast<slong>(stride * (length - 1)))
    fail("the leading coefficient is 0");
  fmpz_set(f.raw()->den, common.raw());
  fmpq_poly_canonicalise(f.raw());
  return f;
}

Json json_of(const Poly& f) {
  Json::Array all;
  for (long i = 0; i <= degree(f); ++i) {
    const NfElem e = f.coeff(i);
    if (is_rational(e)) {
      all.push_back({to_string(e.coeff(0))});
      continue;
    }
    Json::Array parts;
    for (long k = 0; k <= fmpq_poly_degree(e.raw()); ++k)
      parts.push_back({to_string(e.coeff(k))});
    all.push_back({std::move(parts)});
  }
  return {std::move(all)};
}

Keys::Keys(const Node& n) : n_(n) {
  if (!n.json().object()) n.fail("an object is expected");
}

std::optional<Node> Keys::find(const std::string& key) {
  asked_.push_back(key);
  for (const auto& [k, v] : *n_.json().object())
    if (k == key) return Node(v, n_.path() + "." + key, n_.field());
  return std::nullopt;
}

Node Keys::at(const std::string& key) {
  auto v = find(key);
  if (!v) n_.fail("key '" + key + "' is missing");
  return *v;
}

void Keys::done() const {
  for (const auto& [k, v] : *n_.json().object())
    if (!is_among(k, asked_)) n_.fail("unknown key '" + k + "'");
}

} // namespace kov::certify
