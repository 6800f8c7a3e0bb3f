#include "jets/words.hpp"

#include "decide/words.hpp"
#include "exact/error.hpp"

namespace kov::jets {

std::string to_string(OutOfScope why) {
  switch (why) {
  case OutOfScope::several_constants:
    return "there are several algebraic constants";
  case OutOfScope::reducible_relation:
    return "the relation of the algebraic constant is reducible";
  case OutOfScope::related_coordinates:
    return "there is a relation between the coordinates";
  case OutOfScope::not_polynomial:
    return "the system is not a polynomial one of two degrees of freedom";
  case OutOfScope::not_natural:
    return "H is not (a*p1^2 + b*p2^2)/2 + V with a polynomial V";
  case OutOfScope::no_line:
    return "the manifold has no equation of a line of configurations";
  case OutOfScope::inertias_differ:
    return "the two inertias differ, and the line is not a coordinate axis";
  case OutOfScope::isotropic_line:
    return "the line is isotropic";
  case OutOfScope::force_off_the_line:
    return "the force does not point along the line";
  case OutOfScope::low_degree:
    return "the potential on the plane is of degree < 3";
  case OutOfScope::irregular:
    return "the normal equation is irregular at infinity";
  case OutOfScope::exponents_with_parameters:
    return "the exponents at infinity depend on the parameters";
  case OutOfScope::exponents_irrational_or_equal:
    return "the exponents at infinity are irrational or equal";
  case OutOfScope::large_denominator:
    return "the exponents at infinity have a large denominator";
  case OutOfScope::first_order_logarithm:
    return "the first variational equation has a logarithm at infinity";
  }
  return "";
}

std::vector<Trusted> trusted(const HigherObstruction& o) {
  if (!o.certificate.empty()) return {};
  std::vector<Trusted> all{{Trusted::Step::series}};
  if (o.group && !o.group->checked) all.push_back({Trusted::Step::group_of_normal_equation});
  return all;
}

Levels level(const HigherObstruction& o) {
  switch (o.because) {
  case InfiniteGroup::decided:
    return {Levels::Which::of_energy, {{{"H", to_string(*o.energy)}}}};
  case InfiniteGroup::homogeneous:
    return {Levels::Which::all_but_finitely_many};
  default:
    return {Levels::Which::all_but_countably_many};
  }
}

namespace {

std::string why_infinite(const HigherObstruction& o) {
  switch (o.because) {
  case InfiniteGroup::decided:
    return "no quadratic form but 0 commutes with R, and the group of the normal equation is "
           "infinite: " +
           kov::reason(*o.group);
  case InfiniteGroup::homogeneous:
    return "the identity component of the group of the normal equation, which is homogeneous with "
           "exponents in the first family, is Ga, and its quadratic form does not commute with R";
  case InfiniteGroup::equilibria:
    return "no quadratic form but 0 commutes with R, and the group of the normal equation is "
           "infinite: not all of its exponents at equilibria are rational, because the sum of "
           "their "
           "squares is not a sum of " +
           std::to_string(o.place.degree - 1) + " squares of rational numbers";
  default:
    return "no quadratic form but 0 commutes with R, and the group of the normal equation is "
           "infinite, as that of its highest terms is, whose exponents are in the first family";
  }
}

// "R(c1, c2) = 3*c2*c1^3", and what stands for the energy if it occurs
std::string residue(const HigherOrders& orders) {
  const InvariantPlane& plane = *orders.plane;
  const MFraction& form = orders.obstruction->logarithm.form;
  const auto name = [&](std::size_t i) { return plane.ring->name(i); };
  return "R(" + name(plane.c1) + ", " + name(plane.c2) + ") = " + to_factored_string(form) +
         (uses(form, plane.energy) ? ", " + name(plane.energy) + " the energy" : "");
}

} // namespace

std::string reason(const HigherOrders& orders) {
  KOV_ENSURE(orders.obstruction.has_value());
  const HigherObstruction& o = *orders.obstruction;
  return "VE_" + std::to_string(o.logarithm.order) +
         " is the first with a logarithm at infinity on the curve (exponents " +
         to_string(o.place.rho1) + ", " + to_string(o.place.rho2) +
         (o.place.sign < 0 ? ", the place -infinity" : "") +
         (o.within.empty() ? "" : ", in the subspace " + o.within) + "), with the residue " +
         residue(orders) + "; " + why_infinite(o);
}

} // namespace kov::jets
