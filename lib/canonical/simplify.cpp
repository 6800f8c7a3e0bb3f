#include "canonical/simplify.hpp"

#include "canonical/elementary.hpp"
#include "canonical/flat.hpp"
#include "exact/error.hpp"
#include "exact/lists.hpp"
#include "exact/tried.hpp"
#include "system/in_ring.hpp"

#include <algorithm>

namespace kov {
namespace {

constexpr std::size_t most_flat_degrees = 3; // of freedom, of flat coordinates

// Names that the ring does not have: X, Y, Z and U, V, W, or X1, ...
FlatNames add_names(std::size_t n, std::vector<std::string>& names) {
  const auto add = [&](const std::string& name) {
    std::string candidate = name;
    for (int k = 1; is_among(candidate, names); ++k)
      candidate = name + std::to_string(k);
    names.push_back(candidate);
    return names.size() - 1;
  };
  static const std::vector<std::string> q{"X", "Y", "Z"}, p{"U", "V", "W"};
  FlatNames all;
  for (std::size_t i = 0; i < std::min(n, most_flat_degrees); ++i)
    all.coordinates.push_back(add(q[i]));
  for (std::size_t i = 0; i < std::min(n, most_flat_degrees); ++i)
    all.momenta.push_back(add(p[i]));
  all.root = add("R");
  return all;
}

bool is_changed(const Form& form, const Form& before) {
  return form.field.coordinates != before.field.coordinates || form.forward != before.forward;
}

std::optional<Form> simpler(const Form& given, const FlatNames& names, const Budget& budget) {
  Form form = with_quadratic_kinetic_term(given);
  if (given.degrees() <= most_flat_degrees)
    if (auto flat = in_flat_coordinates(form, names, budget)) form = *std::move(flat);
  form = with_completed_square(form, budget);
  form = with_good_origin(form, budget);
  if (is_changed(form, given)) return form;
  return std::nullopt;
}

} // namespace

std::optional<CanonicalChange> simplified(const System& s, const Budget& budget) {
  if (s.kind != SystemKind::hamiltonian) return std::nullopt;
  using Change = std::optional<CanonicalChange>;
  return tried<OutOfBudget, DomainError, InvalidArgument>(
      [&]() -> Change { // else nothing is changed
        auto ring_names = s.ring()->names();
        const FlatNames names = add_names(s.field.dimension() / 2, ring_names);
        const auto given = form_of(in_ring(s, make_ring(ring_names)));
        const auto form = given ? simpler(*given, names, budget) : std::nullopt;
        if (!form) return std::nullopt;
        CanonicalChange change = finished(s, *form);
        return is_canonical(s, change, budget) ? Change(std::move(change)) : std::nullopt;
      });
}

} // namespace kov
