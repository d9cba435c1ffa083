#include "geometry/numeric_environment.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <string>

#ifdef __SSE2__
#include <pmmintrin.h>
#endif

namespace blocks::geometry {
namespace {

TEST(NumericEnvironment, NoticesADirectedRoundingMode) {
  EXPECT_EQ(check_numeric_environment(), "");
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string fault = check_numeric_environment();
    std::fesetround(FE_TONEAREST);
    EXPECT_NE(fault.find("rounding"), std::string::npos) << mode;
  }
  EXPECT_EQ(check_numeric_environment(), "");
}

#ifdef __SSE2__
TEST(NumericEnvironment, NoticesFlushedSubnormals) {
  EXPECT_EQ(check_numeric_environment(), "");
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  const std::string flush = check_numeric_environment();
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
  EXPECT_NE(flush.find("FTZ"), std::string::npos);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  const std::string zero = check_numeric_environment();
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_OFF);
  EXPECT_NE(zero.find("DAZ"), std::string::npos);
  EXPECT_EQ(check_numeric_environment(), "");
}
#endif

}  // namespace
}  // namespace blocks::geometry
