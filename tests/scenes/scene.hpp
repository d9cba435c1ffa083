// Small models in any frame of reference, for tests of the motion.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "dynamics/step.hpp"
#include "model/model.hpp"

namespace blocks::scenes {

/// A frame of reference turned by `angle` (anticlockwise) and shifted. Results must not
/// depend on it, up to rounding.
struct Frame {
  double angle = 0.0;
  Vec2 offset = Vec2::Zero();

  Vec2 turn(const Vec2& v) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
  }
  /// Turns a vector back into the frame.
  Vec2 back(const Vec2& v) const { return Frame{-angle, Vec2::Zero()}.turn(v); }
  Vec2 place(const Vec2& p) const { return turn(p) + offset; }
};

/// A model with its working memory. Lengths are in m, masses in kg, times in s.
class Scene {
 public:
  explicit Scene(Frame frame = {}, int threads = 1) : frame_(frame), work_(threads) {
    Settings& s = model.settings;
    s.max_blocks = 1000000;
    s.max_corners = 100;
    s.lower = frame.offset - Vec2(200, 200);
    s.upper = frame.offset + Vec2(200, 200);
    s.boxes_x = s.boxes_y = 200;
    s.contact_tolerance = 0.1;
    s.normal_stiffness = s.shear_stiffness = 1e7;
    s.fraction = 0.02;
    s.rigid = true;
    s.materials[1] = {1e10, 4e9, 2000.0};
  }

  /// Adds a block of material 1 and returns its index. Corners are clockwise, in the
  /// frame of the scene.
  int add(const geometry::Polygon& corners, bool fixed = false) {
    NewBlock block{{},
                   1,
                   model.settings.materials.at(1).density,
                   fixed ? Fixity::by_user : Fixity::free};
    for (const Vec2& p : corners)
      block.outline.push_back(frame_.place(p));
    model.blocks.append({block});
    model.search.invalidate();
    return model.blocks.size() - 1;
  }
  /// Adds the rectangle [x, x + w] x [y, y + h].
  int box(double x, double y, double w, double h, bool fixed = false) {
    return add({{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}}, fixed);
  }
  void gravity(double gx, double gy) { model.settings.gravity = frame_.turn({gx, gy}); }
  void velocity(int b, double vx, double vy, double spin = 0.0) {
    model.blocks.velocity.col(b) = frame_.turn({vx, vy});
    model.blocks.spin[b] = spin;
  }
  void plane(const Vec2& a, const Vec2& b) {
    model.settings.planes.push_back({frame_.place(a), frame_.place(b)});
  }

  void prepare() { dynamics::prepare(model); }
  dynamics::StepResult step() { return dynamics::step(model, work_); }
  void steps(long n) {
    prepare();
    for (long i = 0; i < n; ++i)
      step();
  }
  void run(double time) {
    prepare();
    const double end = model.time + time;
    while (model.time < end - 1e-9 * model.time_step.dt)
      step();
  }

  double dt() const { return model.time_step.dt; }
  double weight(int b) const {
    return model.blocks.mass[b] * model.settings.gravity.norm();
  }
  /// Return position and velocity in the frame of the scene.
  Vec2 centroid(int b) const {
    return frame_.back(Vec2(model.blocks.centroid.col(b)) - frame_.offset);
  }
  Vec2 velocity(int b) const { return frame_.back(model.blocks.velocity.col(b)); }

  Model model;

 private:
  Frame frame_;
  dynamics::Workspace work_;
};

/// Returns frames with random rotations and offsets of 0, 1, 1e3 and 1e6 in random
/// directions.
inline std::vector<Frame> random_frames(int count = 40) {
  std::vector<Frame> frames;
  std::uint64_t state = 0x9E3779B97F4A7C15ULL;
  const auto next = [&state] {  // Xorshift gives the same frames on every machine.
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return static_cast<double>(state >> 11) * 0x1p-53;
  };
  const double offsets[] = {0.0, 1.0, 1e3, 1e6};
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * next(), way = 6.283185307179586 * next();
    frames.push_back({angle, offsets[i % 4] * Vec2(std::cos(way), std::sin(way))});
  }
  return frames;
}

}  // namespace blocks::scenes
