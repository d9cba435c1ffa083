// The step allocates nothing: memory is asked for at a search, if at all.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "scenes/scene.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) &&                            \
    !defined(__SANITIZE_THREAD__)

// Eigen asks malloc directly, so operator new would not see it.
extern "C" void* __libc_malloc(std::size_t size);
namespace {
std::atomic<long> asked = 0;
}
extern "C" void* malloc(std::size_t size) {
  ++asked;
  return __libc_malloc(size);
}

namespace blocks {
namespace {

TEST(Step, AllocatesNothing) {
  for (const bool rigid : {true, false}) {
    scenes::Scene scene;
    Settings& s = scene.model.settings;
    s.rigid = rigid;
    s.friction = 0.3, s.damping = 0.3;
    scene.box(-10, -1, 20, 1, true);
    for (int row = 0; row < 6; ++row)
      for (int i = 0; i < 6; ++i)
        scene.add({{i + 0.1 * row, row * 1.02},
                   {i + 0.1 + 0.1 * row, row * 1.02 + 1},
                   {i + 0.9 + 0.1 * row, row * 1.02 + 1},
                   {i + 0.95 + 0.1 * row, row * 1.02}});
    scene.plane({-9, 5}, {-9, -5});
    scene.gravity(0.5, -10);
    scene.run(0.3);
    long searches = 0, quiet = 0;
    for (int i = 0; i < 2000; ++i) {
      const long updates = scene.model.search.updates, before = asked;
      scene.step();
      if (scene.model.search.updates != updates) {
        ++searches;
        continue;
      }
      ++quiet;
      ASSERT_EQ(asked, before) << "step " << i;
    }
    EXPECT_GT(quiet, 1500);
    EXPECT_GT(totals(scene.model).active_contacts, 20);
    EXPECT_LT(searches, 200);
    EXPECT_GT(asked, 0);  // the count itself
  }
}

}  // namespace
}  // namespace blocks

#endif
