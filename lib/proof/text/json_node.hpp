#pragma once
// Reading typed data out of JSON: every error is one InvalidArgument that names the path of the
// offending entry.

#include "exact/modular.hpp"
#include "exact/poly.hpp"
#include "proof/text/json.hpp"

#include <optional>

namespace kov::certify {

/// A value with the path that led to it, for messages.
class Node {
public:
  Node(const Json& j, std::string path, const Field& k) : j_(&j), path_(std::move(path)), k_(&k) {}

  [[noreturn]] void fail(const std::string& what) const;
  [[nodiscard]] bool is_null() const { return j_->is_null(); }
  [[nodiscard]] const Field& field() const { return *k_; }

  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] Integer integer() const;
  [[nodiscard]] long count() const;        ///< an integer, clamped
  [[nodiscard]] mp_limb_t modulus() const; ///< 0 if out of range: not a prime
  [[nodiscard]] mp_limb_t residue() const;
  [[nodiscard]] Rational rational() const;
  [[nodiscard]] std::vector<Node> items() const;
  /// So many; fails for this reason.
  [[nodiscard]] std::vector<Node> items(std::size_t n, const std::string& why) const;
  [[nodiscard]] Poly poly() const;

  [[nodiscard]] const Json& json() const { return *j_; }
  [[nodiscard]] const std::string& path() const { return path_; }

private:
  const Json* j_;
  std::string path_;
  const Field* k_;
};

/// An object whose keys are asked for one by one; done() refuses whatever was not asked for.
class Keys {
public:
  explicit Keys(const Node& n);
  [[nodiscard]] std::optional<Node> find(const std::string& key);
  [[nodiscard]] Node at(const std::string& key);
  void done() const;
  /// Coefficients are in this field from here on.
  void over(const Field& k) { n_ = Node(n_.json(), n_.path(), k); }

private:
  Node n_;
  std::vector<std::string> asked_;
};

/// The coefficients, ascending; those that are not rational as lists.
[[nodiscard]] Json json_of(const Poly& f);

/// Digits without sign and without a leading zero.
[[nodiscard]] bool is_natural(std::string_view s);
/// Letters, digits and _, at most 1000, no digit first.
[[nodiscard]] bool is_name(std::string_view s);

} // namespace kov::certify
