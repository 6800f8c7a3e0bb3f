#pragma once
// An object of a format, described once: describe(io, x) names its keys in the order of the format, and reads
// or writes them.  Unknown, missing and doubled keys are errors, and so is null where nothing is said of it.

#include "exact/joined.hpp"
#include "proof/algebra/arithmetic.hpp"
#include "proof/text/json_node.hpp"

#include <array>
#include <limits>
#include <variant>

namespace kov::certify {

/// The x of describe(io, x): constant where it is written.
template <class IO, class T> using In = std::conditional_t<IO::reads, T, const T>;

template <class Setting> class ObjectReader;
template <class Setting> class ObjectWriter;

/// For formats whose values need nothing besides.
struct NoSetting {};

// ---- how a value is written: read(node, x, setting), write(x, setting)

/// As its type says: read_entry and write_entry where a format has them, or an object with describe.  A
/// polynomial in several variables has the ring of the setting.
struct ByType {
  template <class T, class S> void read(const Node& n, T& x, S& s) const;
  template <class T, class S> [[nodiscard]] Json write(const T& x, S& s) const;
};

/// An integer between two others.
struct Between {
  long least = 0, most = std::numeric_limits<long>::max();
  const char* why = "a number is out of range";

  template <class T, class S> void read(const Node& n, T& x, S&) const {
    const long i = n.count();
    if (i < least || i > most) n.fail(why);
    x = static_cast<T>(i);
  }
  template <class T, class S> [[nodiscard]] Json write(T x, S&) const {
    return {std::to_string(x)};
  }
};
inline constexpr Between any_natural{.why = "a natural number is expected"};

struct Residue {
  template <class S> void read(const Node& n, mp_limb_t& x, S&) const { x = n.residue(); }
  template <class S> [[nodiscard]] Json write(mp_limb_t x, S&) const { return {std::to_string(x)}; }
};
struct Modulus {
  template <class S> void read(const Node& n, mp_limb_t& x, S&) const { x = n.modulus(); }
  template <class S> [[nodiscard]] Json write(mp_limb_t x, S&) const { return {std::to_string(x)}; }
};
/// A word for true, one for false.
struct Either {
  const char *yes, *no;

  template <class S> void read(const Node& n, bool& x, S&) const {
    x = n.text() == yes;
    if (!x && n.text() != no) n.fail(std::string(yes) + " or " + no + " is expected");
  }
  template <class S> [[nodiscard]] Json write(bool x, S&) const {
    return {std::string(x ? yes : no)};
  }
};
inline constexpr Either yes_or_no{"yes", "no"};
/// An optional value that is there.
struct Stated {
  template <class T, class S> void read(const Node& n, std::optional<T>& x, S& s) const {
    ByType{}.read(n, x.emplace(), s);
  }
  template <class T, class S> [[nodiscard]] Json write(const std::optional<T>& x, S& s) const {
    return ByType{}.write(*x, s);
  }
};
/// An optional value, null if unset.
template <class How = ByType> struct OrNull {
  How how{};

  template <class T, class S> void read(const Node& n, std::optional<T>& x, S& s) const {
    if (!n.is_null()) how.read(n, x.emplace(), s);
  }
  template <class T, class S> [[nodiscard]] Json write(const std::optional<T>& x, S& s) const {
    return x ? how.write(*x, s) : Json{};
  }
};
/// A list, each entry in the same way; of an array just as many.
template <class How = ByType> struct Each {
  How how{};
  std::size_t most = std::numeric_limits<std::size_t>::max();
  const char* entries = "entries";

  template <class T, class S> void read(const Node& n, std::vector<T>& all, S& s) const {
    const auto items = n.items();
    if (items.size() > most) n.fail("more than " + std::to_string(most) + " " + entries);
    all.clear();
    all.reserve(items.size());
    for (const Node& item : items)
      how.read(item, all.emplace_back(), s);
  }
  template <class T, std::size_t N, class S>
  void read(const Node& n, std::array<T, N>& all, S& s) const {
    const auto items = n.items(N, std::to_string(N) + " " + entries + " are expected");
    for (std::size_t i = 0; i < N; ++i)
      how.read(items[i], all[i], s);
  }
  template <class List, class S> [[nodiscard]] Json write(const List& all, S& s) const {
    Json::Array list;
    for (const auto& x : all)
      list.push_back(how.write(x, s));
    return {std::move(list)};
  }
};
/// An object, described where it stands: f(io, x).
template <class F> struct Described {
  F f;

  template <class T, class S> void read(const Node& n, T& x, S& s) const {
    ObjectReader<S> io(n, s);
    f(io, x);
    io.done();
  }
  template <class T, class S> [[nodiscard]] Json write(const T& x, S& s) const {
    ObjectWriter<S> io(s);
    f(io, x);
    return io.take();
  }
};
template <class F> Described(F) -> Described<F>;
/// By its describe.
inline constexpr Described whole{[](auto& io, auto& x) { describe(io, x); }};

/// The names of the alternatives of a variant.
template <std::size_t N> using Words = std::array<const char*, N>;
/// An object whose key names its kind, with the entries of that kind.
template <std::size_t N> auto one_of(const char* key, const Words<N>& words) {
  return Described{[key, &words](auto& io, auto& x) { io.one_of(key, x, words); }};
}

// ---- objects

template <class IO, class V> void describe_kind(IO& io, V& x) {
  std::visit(
      [&io](auto& kind) {
        if constexpr (!std::is_empty_v<std::remove_cvref_t<decltype(kind)>>) describe(io, kind);
      },
      x);
}

template <class S> class ObjectReader {
public:
  static constexpr bool reads = true;
  ObjectReader(const Node& n, S& s) : setting(s), keys_(n) {}

  template <class T, class How = ByType>
  ObjectReader& operator()(const char* key, T& x, const How& how = {}) {
    how.read(keys_.at(key), x, setting);
    return *this;
  }
  /// Absent if unset.
  template <class T, class How = ByType>
  ObjectReader& operator()(const char* key, std::optional<T>& x, const How& how = {}) {
    if (const auto n = keys_.find(key)) how.read(*n, x.emplace(), setting);
    return *this;
  }
  /// An optional value in a way of its own.
  template <class T, class How>
  ObjectReader& always(const char* key, std::optional<T>& x, const How& how) {
    how.read(keys_.at(key), x, setting);
    return *this;
  }
  /// Absent if there is no entry.
  template <class T, class How = Each<>>
  ObjectReader& unless_empty(const char* key, std::vector<T>& x, const How& how = {}) {
    if (const auto n = keys_.find(key)) how.read(*n, x, setting);
    return *this;
  }
  /// There only if it holds.
  ObjectReader& if_true(const char* key, bool& x) {
    if (const auto n = keys_.find(key)) ByType{}.read(*n, x, setting);
    check(x || !has(key), key, "true is expected");
    return *this;
  }
  /// Entries of the object itself, there if the key is.
  template <class T> ObjectReader& within(const char* key, std::optional<T>& x) {
    if (has(key)) describe(*this, x.emplace());
    return *this;
  }
  template <class F> ObjectReader& object(const char* key, const F& f) {
    ObjectReader inner(keys_.at(key), setting);
    f(inner);
    inner.done();
    return *this;
  }
  ObjectReader& format(const char* name) {
    check(keys_.at("format").text() == name, "format", "not " + std::string(name));
    return *this;
  }
  template <class V, std::size_t N>
  ObjectReader& kind(const char* key, V& x, const Words<N>& words) {
    static_assert(std::variant_size_v<V> == N);
    const Node n = keys_.at(key);
    std::size_t i = 0;
    while (i < N && n.text() != words[i])
      ++i;
    if (i == N) n.fail(joined({words.begin(), words.end()}, ", ", " or ") + " is expected");
    emplace(x, i);
    return *this;
  }
  template <class V, std::size_t N>
  ObjectReader& one_of(const char* key, V& x, const Words<N>& words) {
    kind(key, x, words);
    describe_kind(*this, x);
    return *this;
  }
  /// A text that the reader has by other means.
  template <class F> ObjectReader& known(const char* key, const F&) {
    static_cast<void>(keys_.at(key));
    return *this;
  }

  [[nodiscard]] bool has(const char* key) { return keys_.find(key).has_value(); }
  void check(bool holds, const char* key, const std::string& why) {
    if (!holds) keys_.at(key).fail(why);
  }
  /// The coefficients of what follows are in this field.
  void over(const Field& k) { keys_.over(k); }
  /// The member `name` of each object in this list, if there is one.
  [[nodiscard]] std::vector<std::string> names_in(const char* key) {
    std::vector<std::string> all;
    if (const auto list = keys_.find(key))
      for (const Node& n : list->items())
        all.push_back(Keys(n).at("name").text());
    return all;
  }
  /// Throws InvalidArgument at the key where names are equal or no names.
  [[nodiscard]] Ring ring_of(const char* key, const std::vector<std::string>& names) {
    return certify::ring_of(keys_.at(key), names);
  }
  void done() const { keys_.done(); }

  S& setting;

private:
  template <std::size_t I = 0, class V> static void emplace(V& x, std::size_t i) {
    if constexpr (I < std::variant_size_v<V>)
      i == I ? static_cast<void>(x.template emplace<I>()) : emplace<I + 1>(x, i);
  }

  Keys keys_;
};

template <class S> class ObjectWriter {
public:
  static constexpr bool reads = false;
  explicit ObjectWriter(S& s) : setting(s) {}

  template <class T, class How = ByType>
  ObjectWriter& operator()(const char* key, const T& x, const How& how = {}) {
    out_.emplace_back(key, how.write(x, setting));
    return *this;
  }
  template <class T, class How = ByType>
  ObjectWriter& operator()(const char* key, const std::optional<T>& x, const How& how = {}) {
    return x ? (*this)(key, *x, how) : *this;
  }
  template <class T, class How>
  ObjectWriter& always(const char* key, const std::optional<T>& x, const How& how) {
    out_.emplace_back(key, how.write(x, setting));
    return *this;
  }
  template <class T, class How = Each<>>
  ObjectWriter& unless_empty(const char* key, const std::vector<T>& x, const How& how = {}) {
    return x.empty() ? *this : (*this)(key, x, how);
  }
  ObjectWriter& if_true(const char* key, bool x) { return x ? (*this)(key, x) : *this; }
  template <class T> ObjectWriter& within(const char* /*key*/, const std::optional<T>& x) {
    if (x) describe(*this, *x);
    return *this;
  }
  template <class F> ObjectWriter& object(const char* key, const F& f) {
    ObjectWriter inner(setting);
    f(inner);
    out_.emplace_back(key, inner.take());
    return *this;
  }
  ObjectWriter& format(const char* name) { return (*this)("format", std::string(name)); }
  template <class V, std::size_t N>
  ObjectWriter& kind(const char* key, const V& x, const Words<N>& words) {
    static_assert(std::variant_size_v<V> == N);
    return (*this)(key, std::string(words.at(x.index())));
  }
  template <class V, std::size_t N>
  ObjectWriter& one_of(const char* key, const V& x, const Words<N>& words) {
    kind(key, x, words);
    describe_kind(*this, x);
    return *this;
  }
  template <class F> ObjectWriter& known(const char* key, const F& text) {
    return (*this)(key, std::string(text()));
  }
  static void check(bool /*holds*/, const char* /*key*/, const char* /*why*/) {}
  static bool has(const char* /*key*/) { return false; }
  static void over(const Field& /*k*/) {}
  [[nodiscard]] Json take() { return {std::move(out_)}; }

  S& setting;

private:
  Json::Object out_;
};

template <class IO> void describe(IO& io, In<IO, PrimeIdeal>& p) {
  io("p", p.p, Modulus{})("a", p.generator, Residue{});
}

// ---- values

template <class T> inline constexpr bool is_list = false;
template <class T> inline constexpr bool is_list<std::vector<T>> = true;
template <class T, std::size_t N> inline constexpr bool is_list<std::array<T, N>> = true;

template <class T, class S> void ByType::read(const Node& n, T& x, S& s) const {
  if constexpr (requires { read_entry(n, x, s); })
    read_entry(n, x, s);
  else if constexpr (std::is_same_v<T, std::string>)
    x = n.text();
  else if constexpr (std::is_same_v<T, bool>)
    x = n.truth();
  else if constexpr (std::is_same_v<T, long>)
    x = n.count();
  else if constexpr (std::is_same_v<T, Integer>)
    x = n.integer();
  else if constexpr (std::is_same_v<T, Rational>)
    x = n.rational();
  else if constexpr (std::is_same_v<T, Poly>)
    x = n.poly();
  else if constexpr (std::is_same_v<T, MPoly>)
    x = read_poly(*s.ring, n);
  else if constexpr (is_list<T>)
    Each<>{}.read(n, x, s);
  else
    whole.read(n, x, s);
}

template <class T, class S> Json ByType::write(const T& x, S& s) const {
  if constexpr (requires { write_entry(x, s); })
    return write_entry(x, s);
  else if constexpr (std::is_same_v<T, std::string>)
    return {x};
  else if constexpr (std::is_same_v<T, bool>)
    return {x};
  else if constexpr (std::is_same_v<T, long>)
    return {std::to_string(x)};
  else if constexpr (std::is_same_v<T, Poly>)
    return json_of(x);
  else if constexpr (std::is_same_v<T, Integer> || std::is_same_v<T, Rational> ||
                     std::is_same_v<T, MPoly>)
    return {to_string(x)};
  else if constexpr (is_list<T>)
    return Each<>{}.write(x, s);
  else
    return whole.write(x, s);
}

// ---- files

/// By its describe.   Throws InvalidArgument
template <class C, class S = NoSetting> C read_whole(const Node& n) {
  C c;
  S setting;
  whole.read(n, c, setting);
  return c;
}
template <class C, class S = NoSetting> C read_whole(std::string_view text, int max_depth = 64) {
  const Json json = parse_json(text, max_depth);
  return read_whole<C, S>(Node(json, "certificate", rationals()));
}
template <class S = NoSetting, class C> Json whole_json(const C& c) {
  S setting;
  return whole.write(c, setting);
}

} // namespace kov::certify
