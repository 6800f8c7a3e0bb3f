// Integrable strata that adjoin one another.

#include "classify/classify.hpp"
#include "classify/unite.hpp"
#include "integrals/known.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace kov {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

class Unite : public testing::Test {
protected:
  System s_ = read_system(parse_document(
      "system = {kind = 'hamiltonian', coordinates = ['x', 'y'], momenta = ['u', 'v'], "
      "parameters = ['a', 'b'], hamiltonian = '(u^2 + v^2 + a*x^2 + b*y^2)/2'}",
      "oscillators.toml"));
  Ring ring_ = s_.ring();
  MPoly a_ = MPoly::variable(ring_, "a"), b_ = MPoly::variable(ring_, "b");
  MFraction x_ = MFraction(MPoly::variable(ring_, "x")),
            u_ = MFraction(MPoly::variable(ring_, "u"));
  ParameterSet all_{ring_, s_.field.parameters};
  MFraction energy_ = u_ * u_ + MFraction(a_) * x_ * x_; // twice that of x

  ClassifiedStratum with(const ParameterSet& where, const MFraction& integral) const {
    return {where,
            {},
            StratumStatus::integrable,
            {{.value = *s_.field.hamiltonian, .hamiltonian = true}, {.value = integral}}};
  }
  SystemClassification united(std::vector<ClassifiedStratum> strata) const {
    SystemClassification c;
    c.strata = std::move(strata);
    Budget budget;
    budget.give(1e8);
    unite_integrable(s_, c, budget);
    return c;
  }
  std::vector<std::string> sets(const SystemClassification& c) const {
    return places(c, {StratumStatus::integrable});
  }
};

TEST_F(Unite, TheIntegralsOfBothServeAll) {
  const auto c = united({with(all_.where_zero(a_), u_), with(all_.where_nonzero(a_), energy_)});
  ASSERT_THAT(c.strata, SizeIs(1));
  EXPECT_EQ(c.strata.front().integrals.back().value, energy_);
  EXPECT_THAT(sets(c), ElementsAre("all parameters"));
}

TEST_F(Unite, InAnyOrderAndInSteps) {
  const ParameterSet off = all_.where_nonzero(a_).where_nonzero(a_ - b_);
  const auto c =
      united({with(all_.where_zero(a_).where_nonzero(b_), u_),
              with(all_.where_zero(a_).where_zero(b_), u_),
              with(all_.where_nonzero(a_).where_zero(a_ - b_), energy_), with(off, energy_)});
  ASSERT_THAT(c.strata, SizeIs(1));
  EXPECT_THAT(sets(c), ElementsAre("all parameters"));
}

// Integrals that are 0, depend on the others, or have no value on the smaller set.
TEST_F(Unite, IntegralsThatFailThereStay) {
  const MFraction h = *s_.field.hamiltonian;
  for (const MFraction& f :
       {MFraction(a_) * energy_, energy_ / MFraction(a_), h + MFraction(a_) * energy_}) {
    const auto c = united({with(all_.where_zero(a_), u_), with(all_.where_nonzero(a_), f)});
    EXPECT_THAT(c.strata, SizeIs(2)) << to_string(f);
    for (const ClassifiedStratum& x : c.strata)
      if (x.where.vanishes(a_)) {
        EXPECT_EQ(x.integrals.back().value, u_);
      }
  }
}

TEST_F(Unite, OtherStatusesAndSetsThatAreApartStay) {
  auto open = with(all_.where_zero(a_), u_);
  open.status = StratumStatus::open;
  EXPECT_THAT(united({open, with(all_.where_nonzero(a_), energy_)}).strata, SizeIs(2));
  const MPoly one(ring_, Integer(1));
  EXPECT_THAT(
      united({with(all_.where_zero(a_), u_), with(all_.where_zero(a_ - one), energy_)}).strata,
      SizeIs(2));
}

// The integral of one set is one on another only where it is constant along the field.
TEST_F(Unite, OnlyIntegralsAreEnough) {
  const Budget budget;
  const auto serves = [&](const MFraction& f, const ParameterSet& where) {
    return are_enough(s_, where, with(where, f).integrals, {}, budget);
  };
  EXPECT_TRUE(serves(energy_, all_));
  EXPECT_FALSE(serves(u_, all_));
  EXPECT_TRUE(serves(u_, all_.where_zero(a_)));
  EXPECT_FALSE(serves(*s_.field.hamiltonian, all_));
}

} // namespace
} // namespace kov
