#include "literature/integral_class.hpp"

#include "exact/joined.hpp"
#include "exact/lists.hpp"

#include <algorithm>
#include <optional>

namespace kov {
namespace {

using Kind = IntegralClass::Kind;
using Near = IntegralClass::Near;
using Names = std::vector<std::string>;

bool is_part(const Names& part, const Names& of) {
  return std::ranges::all_of(part, [&](const std::string& x) { return is_among(x, of); });
}
Names both(const Names& a, const Names& b) {
  Names all;
  std::ranges::copy_if(a, std::back_inserter(all),
                       [&](const std::string& x) { return is_among(x, b); });
  return all;
}
Names either(Names a, const Names& b) {
  std::ranges::copy_if(b, std::back_inserter(a),
                       [&](const std::string& x) { return !is_among(x, a); });
  return a;
}

bool is_near_curves(const IntegralClass& c) {
  return c.kind == Kind::meromorphic && (c.near == Near::curve || c.near == Near::closed_curve);
}

// Are functions of the kind of `inner` where it says of the kind of `outer` where that says?
bool is_kind_of(const IntegralClass& inner, const IntegralClass& outer) {
  if (is_near_curves(inner) &&
      is_near_curves(outer)) // what holds near a larger set holds near a part
    return is_part(outer.curves, inner.curves) &&
           (outer.near == Near::curve || inner.near == Near::closed_curve);
  // Rational in the coordinates: on the closure of each curve; in function symbols: where they are holomorphic.
  if (inner.kind == Kind::rational && outer.kind == Kind::meromorphic)
    return outer.near == Near::curve || (outer.near != Near::level && inner.functions.empty());
  return inner.kind == outer.kind && inner.near == outer.near;
}

// Does it forbid all that `outer` forbids?
bool forbids_as(const IntegralClass& inner, const IntegralClass& outer) {
  return is_part(outer.without, inner.without) &&
         std::ranges::all_of(inner.through, [&](const auto& x) {
           return !is_among(x.first, outer.without) || is_among(x, outer.through);
         });
}

// The exceptions (`through`) of either class that the other one allows as well.
std::vector<std::pair<std::string, std::string>> let_through(const IntegralClass& a,
                                                             const IntegralClass& b) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const auto& x : a.through)
    if (!is_among(x.first, b.without) || is_among(x, b.through)) all.push_back(x);
  for (const auto& x : b.through)
    if (!is_among(x.first, a.without)) all.push_back(x);
  return all;
}

// Both contain it.
std::optional<IntegralClass> common(const IntegralClass& a, const IntegralClass& b) {
  if (contains(a, b) == Truth::yes) return b;
  if (contains(b, a) == Truth::yes) return a;
  IntegralClass c = a;
  if (is_near_curves(a) && is_near_curves(b)) {
    c.near = std::max(a.near, b.near);
    c.curves = either(a.curves, b.curves);
  } else if (b.kind == Kind::rational) {
    c.kind = b.kind;
    c.near = b.near;
    c.curves.clear();
  }
  c.on_leaf = a.on_leaf || b.on_leaf;
  c.functions = both(a.functions, b.functions);
  c.through = let_through(a, b);
  c.without = either(a.without, b.without);
  const bool in_both = contains(a, c) == Truth::yes && contains(b, c) == Truth::yes;
  return in_both ? std::optional(c) : std::nullopt;
}

// If there is one class only, "meromorphic" is enough: near the phase curve, as the theorem has it.
std::string kind_and_place(const IntegralClass& c, bool alone) {
  if (c.kind == Kind::rational) return "rational";
  const std::string kind = c.kind == Kind::meromorphic ? "meromorphic" : "real-analytic";
  switch (c.near) {
  case Near::curve:
    return alone ? kind : kind + " near the phase curves";
  case Near::closed_curve:
    return kind + " also at the ends of the phase curve (points at infinity, equilibria, poles of "
                  "the system)";
  case Near::level:
    return kind + " on the leaves with F2 = 0";
  case Near::origin:
    return kind + " near the origin";
  default:
    return kind + " on the whole " + (c.kind == Kind::real_analytic ? "real " : "") + "phase space";
  }
}

std::string sentence_of(const IntegralClass& c, bool alone) {
  std::string text = kind_and_place(c, alone);
  if (!c.functions.empty()) text += " (in the coordinates and " + joined(c.functions) + ")";
  if (c.on_leaf) text += " and independent on the symplectic leaf of the phase curve";
  if (!c.without.empty()) text += " and do not depend on " + joined(c.without);
  Names symbols;
  for (const auto& [coordinate, symbol] : c.through)
    add_once(symbols, symbol);
  if (!symbols.empty()) text += " otherwise than through " + joined(symbols);
  return c.frame.empty() ? text : text + " (in the coordinates " + c.frame + ")";
}

} // namespace

Truth contains(const IntegralClass& outer, const IntegralClass& inner) {
  const bool yes = outer.liouville == inner.liouville && outer.frame == inner.frame &&
                   is_kind_of(inner, outer) && forbids_as(inner, outer) &&
                   is_part(inner.functions, outer.functions) && (!outer.on_leaf || inner.on_leaf);
  return yes ? Truth::yes : Truth::unknown;
}

std::vector<IntegralClass> at_once(const std::vector<IntegralClass>& classes) {
  std::vector<IntegralClass> all;
  for (IntegralClass c : classes) {
    for (std::size_t i = 0; i < all.size();) {
      const auto meet = common(all[i], c);
      if (!meet) {
        ++i;
        continue;
      }
      c = *meet;
      all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;
    }
    all.push_back(std::move(c));
  }
  return all;
}

std::string_view word_of(Kind k) {
  switch (k) {
  case Kind::rational:
    return "rational";
  case Kind::meromorphic:
    return "meromorphic";
  default:
    return "real-analytic";
  }
}

std::string_view word_of(Near n) {
  switch (n) {
  case Near::curve:
    return "curve";
  case Near::closed_curve:
    return "closed curve";
  case Near::level:
    return "level";
  case Near::origin:
    return "origin";
  default:
    return "phase space";
  }
}

bool has_rational_functions(const IntegralClass& c) {
  return contains(c, {.kind = Kind::rational, .on_leaf = c.on_leaf, .frame = c.frame}) ==
         Truth::yes;
}

std::optional<IntegralClass> carried(const IntegralClass& c, const MapFacts& map) {
  if ((c.kind == Kind::real_analytic && !map.real) || c.near == Near::level ||
      !c.functions.empty() || !c.through.empty() || !c.frame.empty())
    return std::nullopt;
  IntegralClass there = c;
  if (c.without.empty()) return there;
  there.without.clear();
  Names kept; // the x on which the y that are left depend
  for (const auto& [y, xs] : map.uses)
    if (!is_among(y, c.without)) kept = either(kept, xs);
  for (const auto& x : map.uses) // the same names before and behind the map
    if (!is_among(x.first, kept)) there.without.push_back(x.first);
  if (there.without.size() != c.without.size()) return std::nullopt;
  return there;
}

std::string sentence(const IntegralClass& c) { return sentence_of(c, true); }

std::string sentence(const std::vector<IntegralClass>& classes) {
  const bool alone = classes.size() == 1;
  std::string text = alone ? "" : "at once ";
  for (std::size_t i = 0; i < classes.size(); ++i)
    text += (i == 0                    ? ""
             : i + 1 == classes.size() ? " and "
                                       : ", ") +
            sentence_of(classes[i], alone);
  return text;
}

std::string first_integrals(const std::vector<IntegralClass>& classes) {
  const bool fields =
      std::ranges::any_of(classes, [](const IntegralClass& c) { return !c.liouville; });
  return std::string("first integrals ") + (fields ? "and commuting vector fields " : "") +
         "that are " + sentence(classes);
}

} // namespace kov
