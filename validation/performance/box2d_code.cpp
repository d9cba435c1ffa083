#include "box2d_code.hpp"

#ifdef BLOCKS_BENCH_BOX2D
#include <box2d/box2d.h>

#include <vector>
#endif

namespace blocks::bench {

#ifdef BLOCKS_BENCH_BOX2D
namespace {

constexpr int velocity_iterations = 8, position_iterations = 3;

class Box2dCode : public Contestant {
 public:
  explicit Box2dCode(const Model& start) : world_(vector(start.settings.gravity)) {
    world_.SetAllowSleeping(false);
    world_.SetContinuousPhysics(false);
    const Blocks& blocks = start.blocks;
    for (int b = 0; b < blocks.size(); ++b) {
      b2BodyDef body;
      body.type = blocks.is_free(b) ? b2_dynamicBody : b2_staticBody;
      body.position = vector(blocks.centroid.col(b));
      body.linearVelocity = vector(blocks.velocity.col(b));
      body.angularVelocity = static_cast<float>(blocks.spin[b]);
      std::vector<b2Vec2> corners;
      for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c)
        corners.push_back(vector(blocks.present_arm(c)));
      b2PolygonShape shape;
      shape.Set(corners.data(), static_cast<int32>(corners.size()));
      b2FixtureDef fixture;
      fixture.shape = &shape;
      fixture.density = static_cast<float>(blocks.mass[b] / blocks.area[b]);
      fixture.friction = static_cast<float>(start.settings.friction);
      world_.CreateBody(&body)->CreateFixture(&fixture);
      free_ += blocks.is_free(b) ? 1 : 0;
    }
    for (const Plane& plane : start.settings.planes) {
      b2EdgeShape shape;
      shape.SetTwoSided(vector(plane.a), vector(plane.b));
      b2FixtureDef fixture;
      fixture.shape = &shape;
      fixture.friction = 0.0f;  // Box2D takes the geometric mean of both sides.
      const b2BodyDef body;
      world_.CreateBody(&body)->CreateFixture(&fixture);
    }
  }

  std::string name() const override { return "Box2D 2.4.1"; }
  double work_per_step() const override { return free_ * velocity_iterations; }
  void run(long steps) override {
    for (long i = 0; i < steps; ++i)
      world_.Step(1.0f / 60.0f, velocity_iterations, position_iterations);
  }

 private:
  static b2Vec2 vector(const Vec2& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y())};
  }
  b2World world_;
  double free_ = 0.0;
};

}  // namespace

bool has_box2d() { return true; }

std::unique_ptr<Contestant> box2d_code(const Model& start) {
  const Blocks& blocks = start.blocks;
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.convex[b] || blocks.corners_of(b) > b2_maxPolygonVertices)
      return nullptr;
  return start.loads.none() ? std::make_unique<Box2dCode>(start) : nullptr;
}
#else
bool has_box2d() { return false; }

std::unique_ptr<Contestant> box2d_code(const Model&) { return nullptr; }
#endif

}  // namespace blocks::bench
