// Sizes of pages, and numbers in texts.
#include "draw/page_size.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "draw/number_text.hpp"

namespace blocks::draw {
namespace {

TEST(PageSize, ReadsMillimetresInchesAndColumns) {
  constexpr double mm = 72 / 25.4;
  const auto width = [](const char* text) {
    const PageSize page = PageSize::in_print(text);
    return page.unit * page.width;
  };
  EXPECT_NEAR(width("85mm"), 85 * mm, 1e-9);
  EXPECT_NEAR(width("8.5cm"), 85 * mm, 1e-9);
  EXPECT_NEAR(width("3.5in"), 252, 1e-9);
  EXPECT_NEAR(width("single"), 85 * mm, 1e-9);
  EXPECT_NEAR(width("double"), 175 * mm, 1e-9);
  const PageSize both = PageSize::in_print("85mmx60mm");
  EXPECT_NEAR(both.unit * both.height, 60 * mm, 1e-9);
  for (const char* wrong : {"85", "mm", "85pt", "85mmx", "5mm", "85mmx1mm", "", "nan"})
    EXPECT_THROW(PageSize::in_print(wrong), std::runtime_error) << wrong;
}

TEST(NumberText, HasTrueMinusSigns) {
  EXPECT_EQ(with_minus_signs("LAYER-2 of -3 (-4) 1e-05"), "LAYER-2 of −3 (−4) 1e−05");
}

}  // namespace
}  // namespace blocks::draw
