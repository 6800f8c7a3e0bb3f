// JSON -> Certificate.  Each rule has one function that lists its keys in the order of
// docs/theory/certificates.md; unknown, missing and doubled keys are errors.

#include "certify/certificate.hpp"
#include "certify/json.hpp"
#include "certify/limits.hpp"
#include "exact/error.hpp"

#include <algorithm>
#include <limits>

namespace kov::certify {

namespace {

bool is_natural(std::string_view s) { // no sign, no leading zero
  return !s.empty() && s.size() <= 200000 && s[0] >= '1' && s[0] <= '9' &&
         std::all_of(s.begin(), s.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_integer_text(std::string_view s) {
  return s == "0" || is_natural(s) || (s.size() > 1 && s[0] == '-' && is_natural(s.substr(1)));
}

bool is_rational_text(std::string_view s) {
  const std::size_t slash = s.find('/');
  if (slash == std::string_view::npos) return is_integer_text(s);
  return is_integer_text(s.substr(0, slash)) && s[0] != '0' && is_natural(s.substr(slash + 1));
}

// A value with the path that led to it, for messages.
class Node {
public:
  Node(const Json& j, std::string path, const Field& k) : j_(&j), path_(std::move(path)), k_(&k) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw InvalidArgument(path_ + ": " + what);
  }
  [[nodiscard]] bool is_null() const { return j_->is_null(); }
  [[nodiscard]] const Field& field() const { return *k_; }

  [[nodiscard]] std::string text() const {
    if (!j_->text()) fail("a string is expected");
    return *j_->text();
  }
  [[nodiscard]] Integer integer() const {
    if (!j_->text() || !is_integer_text(*j_->text())) fail("an integer in a string is expected");
    return Integer::parse(*j_->text());
  }
  [[nodiscard]] long count() const { // clamped
    const Integer n = integer();
    const long top = std::numeric_limits<long>::max() / 2;
    return fits_long(n) ? std::clamp(to_long(n), -top, top) : sign(n) * top;
  }
  [[nodiscard]] mp_limb_t modulus() const { // 0 if out of range: not a prime
    const long n = count();
    return n < 0 || n >= (long{1} << 62) ? 0 : static_cast<mp_limb_t>(n);
  }
  [[nodiscard]] mp_limb_t residue() const {
    const Integer n = integer();
    if (sign(n) < 0 || n >= Integer(long{1} << 62)) fail("a residue is expected");
    return static_cast<mp_limb_t>(to_long(n));
  }
  [[nodiscard]] Rational rational() const {
    if (!j_->text() || !is_rational_text(*j_->text())) fail("a rational number is expected");
    return Rational::parse(*j_->text());
  }
  [[nodiscard]] std::vector<Node> items() const {
    const auto* a = j_->array();
    if (!a || a->size() > max_length) fail("an array is expected");
    std::vector<Node> out;
    out.reserve(a->size());
    for (std::size_t i = 0; i < a->size(); ++i)
      out.emplace_back((*a)[i], path_ + "[" + std::to_string(i) + "]", *k_);
    return out;
  }
  [[nodiscard]] NfElem element() const {
    if (j_->text()) return {rational(), *k_};
    const auto* a = j_->array();
    if (!a || a->empty() || static_cast<long>(a->size()) > (*k_)->degree())
      fail("an element of the field is expected");
    NfElem e(*k_);
    long i = 0;
    for (const Node& n : items())
      fmpq_poly_set_coeff_fmpq(e.raw(), i++, n.rational().raw());
    return e;
  }
  [[nodiscard]] Poly poly() const {
    std::vector<NfElem> c;
    Integer common(1);
    std::size_t top = 0;
    for (const Node& n : items()) {
      c.push_back(n.element());
      const Integer below(c.back().raw()->den);
      common = lcm(common, below);
      top = std::max<std::size_t>(top, static_cast<std::size_t>(std::abs(_fmpz_vec_max_bits(
                                           c.back().raw()->coeffs, c.back().raw()->length))));
      const auto size = static_cast<double>(top + 2 * fmpz_bits(common.raw()));
      if (static_cast<double>(c.size()) * size > max_bulk) fail("the polynomial is too large");
    }
    if (!c.empty() && is_zero(c.back())) fail("the leading coefficient is 0");
    return c.empty() ? Poly(*k_) : Poly::from_coefficients(c);
  }
  [[nodiscard]] std::vector<mp_limb_t> residues() const {
    std::vector<mp_limb_t> c;
    for (const Node& n : items())
      c.push_back(n.residue());
    return c;
  }
  [[nodiscard]] PrimeIdeal prime() const;

  [[nodiscard]] const Json& json() const { return *j_; }
  [[nodiscard]] const std::string& path() const { return path_; }

private:
  const Json* j_;
  std::string path_;
  const Field* k_;
};

// An object whose keys are asked for one by one; the destructor of the reading function calls
// done(), which refuses whatever was not asked for.
class Keys {
public:
  explicit Keys(const Node& n) : n_(n) {
    if (!n.json().object()) n.fail("an object is expected");
  }
  [[nodiscard]] std::optional<Node> find(const std::string& key) {
    asked_.push_back(key);
    for (const auto& [k, v] : *n_.json().object())
      if (k == key) return Node(v, n_.path() + "." + key, n_.field());
    return std::nullopt;
  }
  [[nodiscard]] Node at(const std::string& key) {
    auto v = find(key);
    if (!v) n_.fail("key '" + key + "' is missing");
    return *v;
  }
  void done() const {
    for (const auto& [k, v] : *n_.json().object())
      if (std::find(asked_.begin(), asked_.end(), k) == asked_.end())
        n_.fail("unknown key '" + k + "'");
  }
  [[nodiscard]] PrimeIdeal prime() { return {at("p").modulus(), at("a").residue()}; }
  [[nodiscard]] std::optional<Poly> find_poly(const std::string& key) {
    const auto v = find(key);
    return v ? std::optional(v->poly()) : std::nullopt;
  }

private:
  Node n_;
  std::vector<std::string> asked_;
};

PrimeIdeal Node::prime() const {
  Keys k(*this);
  const PrimeIdeal p = k.prime();
  k.done();
  return p;
}

LogWitness read_log(const Node& n) {
  Keys k(n);
  LogWitness w;
  w.prime = k.prime();
  if (const auto roots = k.find("roots")) w.roots = roots->residues();
  k.done();
  return w;
}

LocalPlace read_place(const Node& n) {
  Keys k(n);
  LocalPlace x;
  x.q = k.at("q").poly();
  x.order = k.at("order").count();
  x.delta2 = k.find_poly("delta2");
  x.eps2 = k.find_poly("eps2");
  if (const auto v = k.find("irrational")) x.irrational = v->prime();
  if (const auto v = k.find("log")) x.log = read_log(*v);
  x.annihilator = k.find_poly("annihilator");
  k.done();
  return x;
}

Rule read_local(Keys& k) {
  Local x;
  x.prime = k.at("prime").prime();
  for (const Node& n : k.at("places").items())
    x.places.push_back(read_place(n));
  Keys inf(k.at("infinity"));
  x.infinity_eps2 = inf.find_poly("eps2");
  if (const auto v = inf.find("log")) x.infinity_log = read_log(*v);
  x.infinity_annihilator = inf.find_poly("annihilator");
  inf.done();
  return x;
}

Rule read_exponential(Keys& k) {
  return Exponential{k.at("p").poly(), k.at("num").poly(), k.at("den").poly()};
}

Rule read_invariant(Keys& k) {
  Invariant x;
  x.prime = k.at("prime").prime();
  x.m = k.at("m").count();
  x.p = k.at("p").poly();
  for (const Node& n : k.at("factors").items()) {
    Keys f(n);
    x.factors.push_back({f.at("q").poly(), f.at("e").rational()});
    f.done();
  }
  return x;
}

Rule read_no_exponential(Keys& k) {
  const Node by = k.at("by");
  if (by.text() == "parity") return NoExponential{ByParity{}};
  if (by.text() == "degree") return NoExponential{ByDegree{}};
  if (by.text() != "series") by.fail("parity, degree or series is expected");
  BySeries x;
  const Node place = k.at("place");
  if (place.text() != "infinity") x.place = place.count();
  x.prime = k.prime();
  x.root = k.at("root").residue();
  x.delta = k.at("delta").residue();
  x.terms = k.at("terms").count();
  for (const Node& n : k.at("lines").items()) {
    Keys l(n);
    x.lines.push_back({l.at("length").count(), l.at("approximant").residues()});
    l.done();
  }
  return NoExponential{x};
}

Rule read_p_curvature(Keys& k) { return PCurvature{k.prime(), k.at("shows").text()}; }

Rule read_no_invariant(Keys& k) {
  NoInvariant x;
  x.m = k.at("m").count();
  const Node by = k.at("by");
  if (by.text() == "degree")
    x.by = ByDegree{};
  else if (by.text() == "series")
    x.by = RankModP{k.prime(), k.at("x0").residue(), k.at("terms").count()};
  else
    by.fail("degree or series is expected");
  return x;
}

Rule read_torsion_function(Keys& k) {
  TorsionFunction x;
  x.n = k.at("n").count();
  x.a = k.at("a").poly();
  x.b = k.at("b").poly();
  x.den = k.at("den").poly();
  for (const Node& n : k.at("minimal").items()) {
    Keys t(n);
    x.minimal.push_back({t.at("l").count(), t.prime(), t.at("w").residue(), t.at("x1").residue(),
                         t.at("s1").residue(), t.at("x2").residue(), t.at("s2").residue()});
    t.done();
  }
  return x;
}

Rule read_rule(const Node& rule, const Node& data) {
  Keys k(data);
  const std::string name = rule.text();
  const auto read = [&]() -> Rule {
    if (name == "local") return read_local(k);
    if (name == "exponential") return read_exponential(k);
    if (name == "invariant") return read_invariant(k);
    if (name == "no-exponential") return read_no_exponential(k);
    if (name == "p-curvature") return read_p_curvature(k);
    if (name == "no-invariant") return read_no_invariant(k);
    if (name == "torsion-function") return read_torsion_function(k);
    if (name == "good-reduction") return GoodReduction{k.prime()};
    if (name == "conclude") return Conclude{k.at("theorem").text()};
    if (name == "apply-theorem")
      return ApplyTheorem{k.at("theorem").text(), k.at("statement").text()};
    rule.fail("unknown rule");
  };
  Rule r = read();
  k.done();
  return r;
}

Claim read_claim(const Node& n) {
  Keys k(n);
  Claim c;
  if (const Node v = k.at("group"); !v.is_null()) c.group = v.text();
  if (const Node v = k.at("n"); !v.is_null()) c.n = v.integer();
  if (const Node v = k.at("component"); !v.is_null()) c.component = v.text();
  if (const Node v = k.at("abelian"); !v.is_null()) {
    if (!v.json().truth()) v.fail("true, false or null is expected");
    c.abelian = *v.json().truth();
  }
  k.done();
  return c;
}

Field read_field(const Node& n) {
  Keys k(n);
  const std::string name = k.at("name").text();
  const Node minpoly = k.at("minpoly");
  std::vector<Integer> m;
  Integer squares;
  for (const Node& c : minpoly.items()) {
    m.push_back(c.integer());
    squares += m.back() * m.back();
    if (fmpz_bits(squares.raw()) / 2 + m.size() >= 76)
      minpoly.fail("the coefficients are too large");
  }
  k.done();
  if (m.size() < 2 || m.size() > 25 || m.back() != Integer(1) || (m.size() == 2 && !is_zero(m[0])))
    minpoly.fail("a monic polynomial of degree 1 (z itself) to 24 is expected");
  return m.size() == 2 ? rationals() : make_field(m, name);
}

} // namespace

Certificate read_certificate(std::string_view text) {
  if (text.size() > max_text) throw InvalidArgument("the certificate is longer than 2^28 bytes");
  const Json json = parse_json(text);
  Certificate c;
  Keys top(Node(json, "certificate", rationals()));
  const Node format = top.at("format");
  if (format.text() != "kovacic-certificate/1") format.fail("not kovacic-certificate/1");
  c.field = read_field(top.at("field"));
  const Node r = top.at("r");
  Keys fraction(Node(r.json(), "r", c.field));
  c.num = fraction.at("num").poly();
  c.den = fraction.at("den").poly();
  fraction.done();
  c.claim = read_claim(top.at("claim"));
  const auto steps = top.at("steps").items();
  if (steps.empty() || steps.size() > max_steps) format.fail("1 to 1000 steps are expected");
  for (const Node& n : steps) {
    Keys k(Node(n.json(), n.path(), c.field));
    Step s;
    s.id = k.at("id").text();
    for (const Node& p : k.at("premises").items())
      s.premises.push_back(p.text());
    s.rule = read_rule(k.at("rule"), k.at("data"));
    k.done();
    c.steps.push_back(std::move(s));
  }
  top.done();
  return c;
}

} // namespace kov::certify
