// Half of a symmetric model beside a symmetry plane moves like half of the full model.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "output/checkpoint/checkpoint.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

const std::string outline = "OUTLINE, 4, 1\n0, 0, 8, 8\n0, 8, 8, 0\n";
const std::string layers = "ORIENT, -15, 15\n"
                           "LAYER, -6, 1, 0,0, 0,2, 8,2, 8,0, RANDOM\n"
                           "LAYER, -6, 1, 0,2, 0,5, 8,5, 8,2, RANDOM\n"
                           "LAYER, -6, 1, 0,5, 0,8, 8,8, 8,5, RANDOM\n";
const std::string cut_rock = outline + "JSET, 1, 30, 5, 1.5, .3, 6, 2, .5, .2\n"
                                       "JSET, 2, 110, 8, 1.5, .4, 5, 2, 1, .3\n"
                                       "CUT, .1, .05\n";

std::string start(double stiffness, bool rigid) {
  return fmt::format(
      "START, 300, 40\nHALF A MODEL\nXLIMITS, -20, 20\nYLIMITS, -10, 10\n"
      "BOXES, 10, 10, 0.1\nSTIFF, {0:g}, {0:g}\nFRACTION, 0.02\n"
      "MATERIAL, 1, 1.E9, 4.E8, 1000\nMATERIAL, 2, 1.E9, 4.E8, 1000\n{1}"
      "END\n",
      stiffness, rigid ? "RIGID\n" : "");
}

/// Returns the CREATE card of a block, or of its mirror image of material 2.
std::string created(const Model& model, int b, bool mirrored) {
  geometry::Polygon corners = model.blocks.outline(b);
  if (mirrored) {
    for (geometry::Vec2& corner : corners)
      corner.x() = -corner.x();
    std::reverse(corners.begin(), corners.end());
  }
  std::string xs, ys;
  for (const geometry::Vec2& corner : corners) {
    xs += fmt::format("{}{:.17g}", xs.empty() ? "" : ", ", corner.x());
    ys += fmt::format("{}{:.17g}", ys.empty() ? "" : ", ", corner.y());
  }
  return fmt::format("CREATE, {}, {}, {}\n{}\n{}\n", corners.size(), mirrored ? 2 : 1,
                     model.blocks.is_free(b) ? 0 : 1, xs, ys);
}

class HalfModel : public ::testing::Test {
 protected:
  Model ran(const std::string& deck) {
    run_text(folder_, "half", deck);
    output::CheckpointInfo info;
    return output::read_checkpoint((folder_ / "half.ckpt.h5").string(), info);
  }
  TemporaryFolder folder_;
};

// All joints have the law 7, those on the plane STIFF. In the full model each corner on
// the plane has two contacts, which close twice as fast: four times STIFF in the half.
TEST_F(HalfModel, MovesLikeTheFullOne) {
  const std::string law = "JOINT, 7, .3, , , , , , , , 4.E8, 2.E8\n"
                          "JPAIR, 1, 1, 7\nJPAIR, 2, 2, 7\n";
  const std::string rest = "FRICTN, 0\nGRAVITY, 0, -10\nLOCDAMP, .5\n";
  const std::string in_situ = "INSITU, -4.E4, -8.E4, 0, 5.E3, 1.E4\n";
  for (const std::string& rock : {layers, cut_rock})
    for (const std::string& stress : {in_situ, std::string()})
      for (const bool rigid : {true, false}) {
        SCOPED_TRACE(rock + stress + (rigid ? "rigid" : "deformable"));
        const Model made = ran(start(4e7, rigid) + rectangle(0, -1, 9, 0, true) +
                               rectangle(8, 0, 9, 8, true) + rock + "CYCLE, 1\n");
        std::string right, left;
        for (int b = 0; b < made.blocks.size(); ++b)
          right += created(made, b, false), left += created(made, b, true);
        const std::string motion =
            law + rest + stress + "REMOVE, in(-2.5, 1.5, 2.5, 4.5)\nCYCLE, 400\nSTOP\n";
        const Model half =
            ran(start(4e7, rigid) + right + "SPLANE, 0, 9, 0, -9\n" + motion);
        const Model full = ran(start(1e7, rigid) + right + left + motion);
        ASSERT_EQ(full.blocks.size(), 2 * half.blocks.size());
        ASSERT_NEAR(full.time_step.dt, half.time_step.dt, 1e-12 * half.time_step.dt);
        double largest = 0.0, difference = 0.0;
        for (int b = 0; b < half.blocks.size(); ++b) {
          const geometry::Vec2 way =
              half.blocks.centroid.col(b) - made.blocks.centroid.col(b);
          largest = std::max(largest, way.norm());
          difference = std::max(difference, geometry::Vec2(half.blocks.centroid.col(b) -
                                                           full.blocks.centroid.col(b))
                                                .norm());
        }
        EXPECT_GT(largest, 3e-4);
        // Without INSITU the contacts of corners that just touch begin by rounding.
        EXPECT_LE(difference, (stress.empty() ? 1e-4 : 1e-8) * largest);
      }
}

}  // namespace
}  // namespace blocks::testing
