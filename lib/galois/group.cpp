#include "galois/group.hpp"

#include "exact/error.hpp"

namespace kov {

Connected identity_component(const GaloisGroup& g) {
  switch (g.type) {
  case GroupType::SL2:
    return Connected::sl2;
  case GroupType::Borel:
    return Connected::borel;
  case GroupType::T:
    return Connected::additive;
  case GroupType::Gm:
  case GroupType::Dinf:
    return Connected::torus;
  case GroupType::cyclic:
  case GroupType::D:
  case GroupType::A4:
  case GroupType::S4:
  case GroupType::A5:
    return Connected::trivial;
  }
  throw InternalError("unknown group type");
}

std::string to_string(GroupType t) {
  switch (t) {
  case GroupType::SL2:
    return "SL2";
  case GroupType::Borel:
    return "Borel";
  case GroupType::T:
    return "T";
  case GroupType::Gm:
    return "Gm";
  case GroupType::cyclic:
    return "cyclic";
  case GroupType::Dinf:
    return "Dinf";
  case GroupType::D:
    return "D";
  case GroupType::A4:
    return "A4";
  case GroupType::S4:
    return "S4";
  case GroupType::A5:
    return "A5";
  }
  throw InternalError("unknown group type");
}

std::string to_string(Connected c) {
  switch (c) {
  case Connected::trivial:
    return "trivial";
  case Connected::additive:
    return "Ga";
  case Connected::torus:
    return "Gm";
  case Connected::borel:
    return "Borel";
  case Connected::sl2:
    return "SL2";
  }
  throw InternalError("unknown identity component");
}

std::string describe(const GaloisGroup& g) {
  const std::string n = g.n ? to_string(*g.n) : "n";
  switch (g.type) {
  case GroupType::SL2:
    return "SL(2, C)";
  case GroupType::Borel:
    return "the full Borel group (all triangular matrices)";
  case GroupType::T:
    return g.n && *g.n == Integer(1) ? "Ga (unipotent triangular matrices)"
                                     : "T_" + n + " = {(c d; 0 1/c) : c^" + n + " = 1}";
  case GroupType::Gm:
    return "Gm (all diagonal matrices)";
  case GroupType::cyclic:
    return g.n && *g.n == Integer(1) ? "trivial" : "cyclic of order " + n + " (diagonal)";
  case GroupType::Dinf:
    return "infinite dihedral";
  case GroupType::D:
    return "D_" + n + " (binary dihedral of order " + (g.n ? to_string(*g.n * Integer(4)) : "4n") +
           ")";
  case GroupType::A4:
    return "binary tetrahedral (order 24)";
  case GroupType::S4:
    return "binary octahedral (order 48)";
  case GroupType::A5:
    return "binary icosahedral (order 120)";
  }
  throw InternalError("unknown group type");
}

int kovacic_case(const GaloisGroup& g) {
  switch (g.type) {
  case GroupType::SL2:
    return 4;
  case GroupType::A4:
  case GroupType::S4:
  case GroupType::A5:
    return 3;
  case GroupType::Dinf:
  case GroupType::D:
    return 2;
  default:
    return 1;
  }
}

} // namespace kov
