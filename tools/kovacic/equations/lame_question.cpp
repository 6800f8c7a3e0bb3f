#include "equations/lame_question.hpp"

#include "symbol/rational_form.hpp"
#include "symbol/suggest.hpp"
#include "system/parameter_scope.hpp"

#include <algorithm>
#include <set>

namespace kov::cli {
namespace {

using Kind = Expression::Kind;

// I, sqrt(c), root(p, approx), c^(1/2).
std::optional<Expression> irrational_part(const Expression& e) {
  if (e.kind() == Kind::call || (e.kind() == Kind::name && e.name() == "I")) return e;
  if (e.kind() == Kind::power && e.operand(1).kind() == Kind::quotient) return e;
  for (const Expression& operand : e.operands())
    if (auto found = irrational_part(operand)) return found;
  return std::nullopt;
}

class Reader {
public:
  explicit Reader(const LameTexts& texts) : texts_(texts) {
    for (const auto& [name, value] : texts_.set)
      constants_.define_value(name, value);
    std::vector<Expression> all;
    for (const auto* e : {&texts_.n, &texts_.alpha, &texts_.b, &texts_.g2, &texts_.g3})
      if (*e) all.push_back(**e);
    for (const Expression& e : all)
      for (const std::string& name : free_names(e))
        constants_.reserve(name);
    constants_.gather(all);
  }

  LameQuestion read() {
    find_free();
    LameQuestion q;
    q.degree = degree();
    q.free = {free_.begin(), free_.end()};
    if (parameters_free_) {
      q.parameters = LameParameters<MFraction>{symbolic(texts_.b, "B"), symbolic(texts_.g2, "g2"),
                                               symbolic(texts_.g3, "g3")};
    } else {
      q.parameters =
          LameParameters<NfElem>{number(*texts_.b), number(*texts_.g2), number(*texts_.g3)};
    }
    if (!constants_.field()->is_rational() &&
        constants_.field()->name().find('(') == std::string::npos &&
        constants_.field()->name() != "I")
      q.constants = constants_.field()->letter() + " = " + constants_.definition();
    return q;
  }

private:
  [[nodiscard]] std::vector<std::string> free_names(const Expression& e) const {
    std::vector<std::string> names = names_in(e);
    std::erase_if(names,
                  [&](const std::string& n) { return n == "I" || constants_.is_defined(n); });
    return names;
  }

  void find_free() {
    const auto add = [&](const std::optional<Expression>& e, const std::string& name) {
      if (!e) free_.insert(name);
      if (e)
        for (const std::string& n : free_names(*e))
          free_.insert(n);
    };
    add(texts_.b, "B");
    add(texts_.g2, "g2");
    add(texts_.g3, "g3");
    parameters_free_ = !free_.empty();
    for (const auto* e : {&texts_.n, &texts_.alpha})
      if (*e) add(*e, "");
    ring_ = make_ring(free_.empty() ? std::vector<std::string>{"B"}
                                    : std::vector<std::string>(free_.begin(), free_.end()));
  }

  [[nodiscard]] NfElem number(const Expression& e) const {
    const Reading reading{.variable = "", .constants = &constants_, .budget = {}};
    return rational_function(e, reading).num().coeff(0);
  }

  [[nodiscard]] MFraction symbolic(const std::optional<Expression>& e,
                                   const std::string& name) const {
    if (!e) return MFraction::variable(ring_, std::string_view(name));
    if (const auto root = irrational_part(*e))
      throw root->error("a root beside free names (" +
                            enumerate(std::vector<std::string>(free_.begin(), free_.end())) + ")",
                        "give every name a value with --set, or write a name for the root");
    std::map<std::string, MFraction> values;
    for (const auto& [set_name, value] : texts_.set) {
      const NfElem x = number(value);
      if (!is_rational(x))
        throw value.error("an irrational value beside free names", "give every name a value");
      values.emplace(set_name, MFraction(ring_, to_rational(x)));
    }
    return evaluate(*e, ParameterScope(ring_, std::move(values)));
  }

  [[nodiscard]] LameDegree degree() const {
    if (texts_.n && texts_.alpha)
      throw texts_.alpha->error("both n and alpha are given", "alpha means n(n+1)");
    LameDegree d;
    if (!texts_.n && !texts_.alpha) {
      d.text = "n is not given";
      const Ring r = make_ring({"n"});
      const MFraction n = MFraction::variable(r, std::size_t{0});
      d.symbolic = n * n + n;
      return d;
    }
    const Expression& e = texts_.n ? *texts_.n : *texts_.alpha;
    const auto with = [&](const auto& x) { return texts_.n ? x * x + x : x; };
    d.text = (texts_.n ? "n = " : "alpha = n(n+1) = ") + std::string(e.text());
    if (free_names(e).empty())
      d.alpha = with(number(e));
    else
      d.symbolic = with(symbolic(e, ""));
    if (!d.alpha && is_constant(d.symbolic)) d.alpha = NfElem(to_rational(d.symbolic));
    return d;
  }

  const LameTexts& texts_;
  Constants constants_;
  std::set<std::string> free_;
  bool parameters_free_ = false;
  Ring ring_;
};

} // namespace

LameTexts lame_texts(const Settings& settings, const LameArguments& a) {
  return {formula("-n", a.n),    formula("--alpha", a.alpha), formula("--B", a.b),
          formula("--g2", a.g2), formula("--g3", a.g3),       settings.settings()};
}

LameTexts lame_texts(const Settings& settings, const Entry& document) {
  if (document.find("lame") == nullptr)
    throw document.error("this file has no [lame] table",
                         "kovacic solve FILE recognises the equation in other files");
  document.check_keys({"format", "title", "cite", "lame"});
  const Entry& table = document.at("lame");
  table.check_keys({"n", "alpha", "B", "g2", "g3"});
  const auto get = [&](std::string_view key) -> std::optional<Expression> {
    if (const Entry* e = table.find(key)) return e->expression();
    return std::nullopt;
  };
  return {get("n"), get("alpha"), get("B"), get("g2"), get("g3"), settings.settings()};
}

LameQuestion read_lame(const LameTexts& texts) { return Reader(texts).read(); }

} // namespace kov::cli
