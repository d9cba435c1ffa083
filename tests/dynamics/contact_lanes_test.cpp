// Every instruction set gives the same bits.
#include "dynamics/contact_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

namespace blocks::dynamics {
namespace {

/// Numbers of every size, of both signs, and zeros.
class Numbers {
 public:
  void fill(Lanes& lanes) {
    for (double& x : lanes)
      x = kind_(random_) == 0 ? 0.0 : std::ldexp(uniform_(random_), power_(random_));
  }
  double positive() { return std::abs(uniform_(random_)) + 0x1p-20; }

 private:
  std::mt19937_64 random_{11};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
  std::uniform_int_distribution<int> power_{-30, 30}, kind_{0, 9};
};

template <class Batch> Batch blank() {
  Batch batch;
  std::memset(static_cast<void*>(&batch), 0, sizeof batch);
  return batch;
}

TEST(ContactLanes, EveryInstructionSetGivesTheSameBits) {
  Numbers numbers;
  const ContactLanes& baseline = all_contact_lanes().front();
  EXPECT_EQ(baseline.name, "baseline");
  for (int trial = 0; trial < 2000; ++trial) {
    auto where = blank<OverlapLanes>();
    for (Lanes* lanes :
         {&where.xc, &where.yc, &where.x1, &where.y1, &where.x2, &where.y2})
      numbers.fill(*lanes);
    auto acting = blank<ForceLanes>();
    for (Lanes* lanes :
         {&acting.tangent_x, &acting.tangent_y, &acting.overlap, &acting.arm_ax,
          &acting.arm_ay, &acting.arm_bx, &acting.arm_by, &acting.vax, &acting.vay,
          &acting.vbx, &acting.vby, &acting.spin_a, &acting.spin_b, &acting.damping,
          &acting.normal_elastic, &acting.shear_elastic})
      numbers.fill(*lanes);
    for (int r = 0; r < 4; ++r)
      numbers.fill(acting.rate_a[r]), numbers.fill(acting.rate_b[r]);
    for (int k = 0; k < lane_count; ++k)
      acting.starting[k] = k % 3 == 0;
    const ContactLaw law{numbers.positive(), numbers.positive(), numbers.positive(),
                         numbers.positive()};
    auto expected_where = where;
    baseline.overlaps(expected_where);
    for (const bool rigid : {true, false}) {
      auto expected = acting;
      baseline.forces(expected, law, rigid);
      for (const ContactLanes& lanes : all_contact_lanes()) {
        auto found = acting;
        lanes.forces(found, law, rigid);
        ASSERT_EQ(std::memcmp(&found, &expected, sizeof found), 0) << lanes.name;
        auto found_where = where;
        lanes.overlaps(found_where);
        ASSERT_EQ(std::memcmp(&found_where, &expected_where, sizeof found_where), 0)
            << lanes.name;
      }
    }
  }
}

}  // namespace
}  // namespace blocks::dynamics
