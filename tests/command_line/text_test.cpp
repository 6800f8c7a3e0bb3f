// Texts for people: axes of pictures, lines that fit.

#include "output/page_width.hpp"
#include "sections/axis_label.hpp"

#include <gtest/gtest.h>

namespace kov::cli::text_test {
namespace {

TEST(AxisLabel, NamesOfMechanics) {
  EXPECT_EQ(axis_label("x"), "{/:Italic x}");
  EXPECT_EQ(axis_label("px"), "{/:Italic p_{x}}");
  EXPECT_EQ(axis_label("p_theta"), "{/:Italic p_{θ}}");
  EXPECT_EQ(axis_label("theta"), "{/:Italic θ}");
  EXPECT_EQ(axis_label("q1"), "{/:Italic q}_{1}");
  EXPECT_EQ(axis_label("theta_2"), "{/:Italic θ}_{2}");
}

TEST(AxisLabel, FormulasAndOtherNames) {
  EXPECT_EQ(axis_label("x^2 + y"), "{/:Italic x}^2 + {/:Italic y}");
  EXPECT_EQ(axis_label("sin_phi"), "sin\\_phi");
  EXPECT_EQ(axis_label("energy"), "energy");
  EXPECT_EQ(axis_label("a{b}"), "{/:Italic a}\\{{/:Italic b}\\}");
  EXPECT_EQ(axis_label(""), "");
}

TEST(Folded, NothingIsWiderThanThePage) {
  EXPECT_EQ(folded("  because   one two three four\n", 26),
            "  because   one two three\n            four\n");
  EXPECT_EQ(folded("short\n", 22), "short\n");
  EXPECT_EQ(folded("short", 22), "short");
  EXPECT_EQ(folded("# one two three four five\n", 20), "# one two three four\n#   five\n");
}

TEST(Folded, WhatHasNoBlanksStays) {
  EXPECT_EQ(folded("abcdefghijklmnop\n", 8), "abcdefghijklmnop\n");
  EXPECT_EQ(folded("  abcdefghijklmnop qr\n", 8), "  abcdefghijklmnop\n    qr\n");
}

} // namespace
} // namespace kov::cli::text_test
