// Models that the audit judges after each step.
#pragma once

#include <random>

#include "audit/audit.hpp"
#include "audit/make_exact_rule.hpp"
#include "dynamics/search/list_tolerance.hpp"
#include "dynamics/stepper.hpp"
#include "dynamics/workspace.hpp"
#include "scenes/scene.hpp"

namespace blocks::testing {

/// A model that is stepped, with the data of its last step that the audit needs. The
/// model may have an internal order.
class AuditedRun {
 public:
  explicit AuditedRun(Model& stepped) : model(stepped), stepper_(stepped, work_) {}

  void step() {
    before = stepper_.up_to_date().blocks;
    held = audit::held_contacts(model);
    left = model.search.current ? model.search.left : dynamics::list_tolerance(model);
    stepper_.advance(true);
    stepper_.complete();
    listed = stepper_.listed_pairs();
  }
  /// Judges the last step.
  audit::Findings audit() const {
    return audit::audit({before, model.contacts, model.settings, left, listed,
                         model.order, held, model.law_states, model.kept,
                         model.plane_contacts});
  }

  Model& model;
  Blocks before;
  std::vector<audit::HeldContact> held;
  double left = 0.0;
  std::vector<audit::BlockPair> listed;

 private:
  dynamics::Workspace work_;
  dynamics::Stepper stepper_;
};

/// Makes one step of a scene and judges it.
inline audit::Findings audited_step(scenes::Scene& scene) {
  scene.prepare();
  AuditedRun run(scene.model);
  run.step();
  return run.audit();
}

/// Returns rubble that falls between walls: regular and squeezed polygons of 3 to 7
/// corners and stars. The floor consists of boxes side by side.
inline scenes::Scene rubble(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  scenes::Scene scene(scenes::random_frames()[seed % 40]);
  scene.model.settings.friction = 0.4;
  scene.model.settings.damping = 0.2;
  scene.model.settings.rigid = seed % 2 == 0;
  for (int i = 0; i < 8; ++i)
    scene.box(i - 4, -1, 1, 1, i % 3 == 0 || i == 7);
  scene.box(-5, -1, 1, 5, true);
  scene.box(4, -1, 1, 5, true);
  scene.box(-4, -2, 8, 1, true);
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 5; ++i) {
      const int n = 3 + static_cast<int>(random() % 5);
      const double squeeze = random() % 3 == 0 ? 0.2 : 1.0, turn = uniform(0, 6.283);
      geometry::Polygon corners;
      for (int k = 0; k < n; ++k) {
        const double angle = -6.283185307179586 * (k + uniform(-0.3, 0.3)) / n;
        const double radius = n > 4 && seed % 4 > 1 && k % 2 == 1 ? 0.3 : 0.6;
        corners.push_back(
            Vec2(-2.8 + 1.4 * i, 0.7 + 1.3 * row) +
            scenes::Frame{turn, Vec2::Zero()}.turn(
                radius * Vec2(std::cos(angle), squeeze * std::sin(angle))));
      }
      scene.add(corners);
    }
  scene.gravity(1, -10);
  return scene;
}

}  // namespace blocks::testing
