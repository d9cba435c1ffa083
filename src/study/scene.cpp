#include "study/scene.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace blocks::study {
namespace {

constexpr double g = 10.0;  ///< [L/T^2]

/// A scene in the making; lengths in m, masses in kg, times in s.
class Draft {
 public:
  Draft(std::string name, std::string what, long steps) {
    scene_.name = std::move(name), scene_.what = std::move(what);
    scene_.steps = steps;
    Settings& s = scene_.model.settings;
    s.max_blocks = 1000, s.max_corners = 1000;
    s.lower = {-30, -30}, s.upper = {30, 30};
    s.boxes_x = s.boxes_y = 30;
    s.contact_tolerance = 0.1;
    s.normal_stiffness = s.shear_stiffness = 1e7;
    s.fraction = 0.02;
    s.rigid = true;
    s.materials[1] = {1e10, 4e9, 2000.0};
    scene_.conservative = true;
  }
  int add(const geometry::Polygon& outline, bool fixed) {
    scene_.model.blocks.append(
        {{outline, 1, 2000.0, fixed ? Fixity::by_user : Fixity::free}});
    return scene_.model.blocks.size() - 1;
  }
  /// The rectangle [x, x + w] x [y, y + h].
  int box(double x, double y, double w, double h, bool fixed = false) {
    return add({{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}}, fixed);
  }
  void gravity(double x, double y) { scene_.model.settings.gravity = {x, y}; }
  void stiffness(double k) {
    scene_.model.settings.normal_stiffness = scene_.model.settings.shear_stiffness = k;
  }
  void velocity(int b, double x, double y) {
    scene_.model.blocks.velocity.col(b) << x, y;
  }
  void rub(double friction, double damping) {
    scene_.model.settings.friction = friction;
    scene_.model.settings.damping = damping;
    scene_.conservative = false;
  }
  /// Block b moves by this, all others stay.
  Scene moves(int b, std::function<Vec2(long steps, double dt)> way) {
    const int n = scene_.model.blocks.size();
    scene_.expected = [n, b, way](long steps, double dt) {
      Eigen::Matrix2Xd all = Eigen::Matrix2Xd::Zero(2, n);
      all.col(b) = way(steps, dt);
      return all;
    };
    return scene_;
  }
  /// Accelerates freely: velocities first, then positions.
  Scene falls(int b) {
    return moves(b, [a = scene_.model.settings.gravity](long k, double dt) {
      return Vec2(
          a * (0.5 * static_cast<double>(k) * static_cast<double>(k + 1) * dt * dt));
    });
  }
  Scene rests(double size) {
    scene_.size = size;
    return moves(0, [](long, double) { return Vec2(0, 0); });
  }

 private:
  Scene scene_;
};

Scene figure4b() {
  Draft draft("figure4b", "of two blocks side by side one is fixed and one falls", 530);
  draft.box(0, 0, 1, 1, true);
  const int b = draft.box(-1, 0, 1, 1);
  draft.gravity(0, -g);
  return draft.falls(b);
}

Scene diagonal() {
  Draft draft("diagonal", "a block falls past the top corner of its diagonal neighbour",
              530);
  draft.box(0, 0, 1, 1, true);
  const int b = draft.box(-1, 1, 1, 1);
  draft.gravity(0, -g);
  return draft.falls(b);
}

Scene stack() {
  Draft draft("stack", "four aligned bricks stand on a floor", 1500);
  draft.rub(0.6, 0.5);
  draft.box(-3, -1, 6, 1, true);
  for (int i = 0; i < 4; ++i)
    draft.box(-1, 0.5 * i, 2, 0.5);
  draft.gravity(0, -g);
  return draft.rests(0.5);
}

Scene wall() {
  Draft draft("wall", "a brick wall in running bond stands on a floor", 1500);
  draft.rub(0.6, 0.5);
  draft.box(-1, -1, 6, 1, true);
  for (int row = 0; row < 4; ++row) {
    const bool even = row % 2 == 0;
    for (int i = 0; i < 4; ++i)
      if (even || i < 3)
        draft.box(i + (even ? 0.0 : 0.5), 0.5 * row, 1, 0.5);
    if (!even) {
      draft.box(0, 0.5 * row, 0.5, 0.5);
      draft.box(3.5, 0.5 * row, 0.5, 0.5);
    }
  }
  draft.gravity(0, -g);
  return draft.rests(0.5);
}

/// A box of 1 m slides over so many fixed ones at 10 m/s.
Scene braked(Draft draft, double friction, int boxes) {
  constexpr double speed = 10.0;
  draft.rub(friction, 0.2);
  for (int i = 0; i < boxes; ++i)
    draft.box(i - 1, -1, 1, 1, true);
  const int b = draft.box(0, 0, 1, 1);
  draft.velocity(b, speed, 0);
  draft.gravity(0, -g);
  return draft.moves(b, [friction](long k, double dt) {
    const double t = static_cast<double>(k) * dt;
    return Vec2(speed * t - 0.5 * friction * g * t * t, 0);
  });
}

Scene floor_of_boxes() {
  return braked(
      {"floor", "a box slides over a floor of boxes and is braked by friction", 1060},
      0.4, 10);
}

Scene soft_floor() {
  Draft draft("soft",
              "a box slides over a floor of boxes so soft that it sinks in by 1 % of "
              "their width",
              600);
  draft.stiffness(1e6);
  return braked(draft, 0.1, 20);
}

Scene slot() {
  Draft draft("slot",
              "a thin slab falls down a slot exactly as wide, pressed to a side", 1500);
  draft.box(-1.02, -1, 1, 1, true);
  draft.box(0, -1, 1, 1, true);
  const int b = draft.box(-0.02, -0.05, 0.02, 0.2);
  draft.gravity(0.01 * g, -g);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(0, -0.5 * g * static_cast<double>(k) * static_cast<double>(k + 1) * dt *
                       dt);
  });
}

Scene plate() {
  Draft draft("plate",
              "a thin plate strikes a floor so fast that it sinks in by its thickness",
              600);
  draft.stiffness(1e6);
  draft.box(-10, -1, 20, 1, true);
  const int b = draft.box(0, 0.01, 1, 0.02);
  draft.velocity(b, 3.0, -6.0);
  return draft.moves(
      b, [](long k, double dt) { return Vec2(3.0 * static_cast<double>(k) * dt, 0); });
}

Scene nose() {
  Draft draft("nose",
              "a block with a front of 40 degrees is pulled over a floor of boxes",
              1600);
  draft.stiffness(1e6);
  draft.rub(0.0, 0.1);
  for (int i = 0; i < 10; ++i)
    draft.box(0.25 * i - 1.25, -1, 0.25, 1, true);
  const double back = 0.3 / std::tan(40.0 * std::numbers::pi / 180.0);
  const int b = draft.add({{-1, 0}, {-1, 0.3}, {-back, 0.3}, {0, 0}}, false);
  draft.gravity(0.3, -g);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(0.15 * static_cast<double>(k) * static_cast<double>(k + 1) * dt * dt,
                0);
  });
}

Scene tip() {
  constexpr double speed = 3.0;
  Draft draft("tip", "a tip strikes a floor of boxes and glides over a joint", 600);
  draft.stiffness(1e9);
  for (int i = 0; i < 4; ++i)
    draft.box(0.5 * i - 1, -1, 0.5, 1, true);
  // its middle over the tip, so that it does not turn; at the joint when it is deepest
  const double side = 0.4 * std::tan(std::numbers::pi / 6.0), start = -0.0045;
  const int b =
      draft.add({{start, 0.001}, {start - side, 0.401}, {start + side, 0.401}}, false);
  draft.velocity(b, speed, -speed);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(speed * static_cast<double>(k) * dt, 0);
  });
}

Scene needle() {
  constexpr double speed = 3.0, width = 0.02;
  const double c = std::cos(std::numbers::pi / 18.0),
               s = std::sin(std::numbers::pi / 18.0);
  Draft draft("needle", "a needle strikes a wide floor at 10 degrees and glides on",
              600);
  draft.box(-10, -1, 20, 1, true);
  // corners from its foot: along it by t, across by w
  const auto at = [&](double t, double w) {
    return Vec2(2.0 + t * s - w * c, 0.005 + t * c + w * s);
  };
  const int b = draft.add({at(0, 0), at(0, width), at(1, width), at(1, 0)}, false);
  draft.velocity(b, -speed, -speed);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(-speed * static_cast<double>(k) * dt, 0);
  });
}

Scene wedge() {
  Draft draft("wedge", "a wedge slides along one slanted face and leaves the other",
              530);
  draft.add({{-3, 0}, {-3, 1}, {-0.3, 1}, {-0.6, 0}}, true);
  draft.add({{0.6, 0}, {0.3, 1}, {3, 1}, {3, 0}}, true);
  const int b = draft.add({{-0.6, 0}, {-0.3, 1}, {0.3, 1}, {0.6, 0}}, false);
  const Vec2 down = Vec2(-0.3, -1.0).normalized();
  draft.gravity(g * down.x(), g * down.y());
  return draft.falls(b);
}

Scene tee() {
  Draft draft("tee",
              "a block moves out of two T-junctions, between a floor and a ceiling",
              530);
  draft.box(-2, -1, 6, 1, true);
  draft.box(-2, 1, 6, 1, true);
  draft.box(-1, 0, 1, 1, true);
  const int b = draft.box(0, 0, 1, 1);
  draft.gravity(g, 0);
  return draft.falls(b);
}

Scene shaft() {
  Draft draft("shaft", "a brick falls down a shaft of bricks exactly as wide", 1060);
  for (int i = 0; i < 6; ++i) {
    draft.box(-1, -0.5 * i, 1, 0.5, true);
    draft.box(1, -0.5 * i, 1, 0.5, true);
  }
  const int b = draft.box(0, 0, 1, 0.5);
  draft.gravity(0, -g);
  return draft.falls(b);
}

Scene slab() {
  Draft draft("slab", "a thin plate passes under a thin slab without touching it",
              1000);
  draft.box(0, 0, 1, 0.1, true);
  draft.rub(0.4, 0.0);
  const int b = draft.box(-1.1, -0.06, 1, 0.05);
  draft.velocity(b, 10, -0.1);
  return draft.moves(b, [](long k, double dt) {
    return Vec2(static_cast<double>(k) * dt * Vec2(10, -0.1));
  });
}

struct Named {
  std::string_view name;
  Scene (*make)();
};
constexpr std::array scenes = {Named{"figure4b", figure4b},
                               Named{"diagonal", diagonal},
                               Named{"stack", stack},
                               Named{"wall", wall},
                               Named{"floor", floor_of_boxes},
                               Named{"wedge", wedge},
                               Named{"tee", tee},
                               Named{"shaft", shaft},
                               Named{"slab", slab},
                               Named{"soft", soft_floor},
                               Named{"needle", needle},
                               Named{"slot", slot},
                               Named{"plate", plate},
                               Named{"nose", nose},
                               Named{"tip", tip}};

}  // namespace

const std::vector<std::string_view>& scene_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const Named& scene : scenes)
      all.push_back(scene.name);
    return all;
  }();
  return names;
}

Scene make_scene(std::string_view name) {
  for (const Named& scene : scenes)
    if (scene.name == name)
      return scene.make();
  throw std::out_of_range("there is no scene " + std::string(name));
}

Scene scene_of_deck(const std::string& name, const Model& model) {
  Scene scene;
  scene.name = name;
  scene.what = model.settings.title;
  scene.model = model;
  scene.steps = 2000;
  double area = 0.0;
  int count = 0;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (model.blocks.is_free(b))
      area += model.blocks.area[b], ++count;
  scene.size = count > 0 ? std::sqrt(area / count) : 1.0;
  scene.known_motion = false;
  scene.least_share = 0.5, scene.least_way = 0.5;
  scene.most_sinking = 0.5;
  scene.conservative = false;
  return scene;
}

}  // namespace blocks::study
