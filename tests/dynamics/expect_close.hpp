// A test of relative differences.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

/// Expects that a number differs from the right one by at most a part of it.
#define EXPECT_CLOSE(found, right, part)                                               \
  EXPECT_NEAR(found, right, (part)*std::abs(right))
