#include "galois/group.hpp"

#include <gtest/gtest.h>

#include <set>

namespace kov {
namespace {

// Every subgroup of SL(2, C) up to conjugation, with what Kovacic's theorem says of it.
struct Row {
  GaloisGroup group;
  Connected component;
  bool abelian;
  int kovacic;
  std::string name;
};

std::vector<Row> table() {
  const auto g = [](GroupType t, long n = 0) {
    return n == 0 ? GaloisGroup{t, {}} : GaloisGroup{t, Integer(n)};
  };
  return {{g(GroupType::SL2), Connected::sl2, false, 4, "SL(2, C)"},
          {g(GroupType::Borel), Connected::borel, false, 1,
           "the full Borel group (all triangular matrices)"},
          {g(GroupType::T, 1), Connected::additive, true, 1, "Ga (unipotent triangular matrices)"},
          {g(GroupType::T, 4), Connected::additive, true, 1, "T_4 = {(c d; 0 1/c) : c^4 = 1}"},
          {g(GroupType::T), Connected::additive, true, 1, "T_n = {(c d; 0 1/c) : c^n = 1}"},
          {g(GroupType::Gm), Connected::torus, true, 1, "Gm (all diagonal matrices)"},
          {g(GroupType::cyclic, 1), Connected::trivial, true, 1, "trivial"},
          {g(GroupType::cyclic, 6), Connected::trivial, true, 1, "cyclic of order 6 (diagonal)"},
          {g(GroupType::Dinf), Connected::torus, true, 2, "infinite dihedral"},
          {g(GroupType::D, 2), Connected::trivial, true, 2, "D_2 (binary dihedral of order 8)"},
          {g(GroupType::D, 5), Connected::trivial, true, 2, "D_5 (binary dihedral of order 20)"},
          {g(GroupType::D), Connected::trivial, true, 2, "D_n (binary dihedral of order 4n)"},
          {g(GroupType::A4), Connected::trivial, true, 3, "binary tetrahedral (order 24)"},
          {g(GroupType::S4), Connected::trivial, true, 3, "binary octahedral (order 48)"},
          {g(GroupType::A5), Connected::trivial, true, 3, "binary icosahedral (order 120)"}};
}

TEST(Group, ComponentsCasesAndNames) {
  for (const Row& row : table()) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(identity_component(row.group), row.component);
    EXPECT_EQ(is_abelian(identity_component(row.group)), row.abelian);
    EXPECT_EQ(kovacic_case(row.group), row.kovacic);
    EXPECT_EQ(describe(row.group), row.name);
  }
}

// Case 4 and the Borel group are those whose identity component is not abelian; a finite group is
// one with a trivial component; cases 2 and 3 are irreducible and have no unipotent part.
TEST(Group, TheTheoremsOfTheClassification) {
  for (const Row& row : table()) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(row.abelian, row.group.type != GroupType::SL2 && row.group.type != GroupType::Borel);
    if (row.kovacic == 3) {
      EXPECT_EQ(row.component, Connected::trivial);
    }
    if (row.component == Connected::additive || row.component == Connected::borel) {
      EXPECT_EQ(row.kovacic, 1);
    }
  }
}

TEST(Group, NamesTellTypesApart) {
  std::set<std::string> types, components;
  for (const Row& row : table()) {
    types.insert(to_string(row.group.type));
    components.insert(to_string(row.component));
  }
  EXPECT_EQ(types.size(), 10U);
  EXPECT_EQ(components, (std::set<std::string>{"trivial", "Ga", "Gm", "Borel", "SL2"}));
  EXPECT_EQ((GaloisGroup{GroupType::D, Integer(3)}), (GaloisGroup{GroupType::D, Integer(3)}));
  EXPECT_FALSE((GaloisGroup{GroupType::D, Integer(3)}) == (GaloisGroup{GroupType::D, {}}));
}

} // namespace
} // namespace kov
