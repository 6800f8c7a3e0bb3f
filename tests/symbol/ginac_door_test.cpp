#include "symbol/ginac_door.hpp"

#include "exact/error.hpp"

#include <gtest/gtest.h>

namespace kov {
namespace {

GiNaC::ex read(const std::string& text, SymbolTable& symbols) {
  return to_ginac(parse_expression(text, "test"), symbols);
}

TEST(GinacDoor, RoundTrips) {
  SymbolTable symbols;
  for (const char* text :
       {"-a^2 + 3/4*b*c - 2^-3", "(a - b)/(c^2 + 1)^3", "sqrt(2)*a + I*b - 5*I/3",
        "sin(a)^2 + cos(a*b) - exp(-c)", "0", "1/sqrt(a)"}) {
    const GiNaC::ex once = read(text, symbols);
    const GiNaC::ex twice = read(to_formula(once), symbols);
    EXPECT_TRUE((once - twice).expand().is_zero()) << text << " became " << to_formula(once);
  }
}

TEST(GinacDoor, RefusesWhatIsNotExactOrNotKnown) {
  SymbolTable symbols;
  EXPECT_THROW(static_cast<void>(to_formula(GiNaC::numeric(0.5))), InvalidArgument);
  EXPECT_THROW(static_cast<void>(to_formula(GiNaC::tan(symbols["x"]))), InvalidArgument);
  EXPECT_THROW(static_cast<void>(read("wp(x)", symbols)), InputError);
  EXPECT_THROW(static_cast<void>(read("a/0", symbols)), InputError);
}

} // namespace
} // namespace kov
