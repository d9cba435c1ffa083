// A builder for the scenes of the study.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

#include "study/scene.hpp"

namespace blocks::study::scenes {

inline constexpr double g = 10.0;  ///< [L/T^2]

inline double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Builds a scene. Lengths are in m, masses in kg, times in s.
class SceneBuilder {
 public:
  SceneBuilder(std::string name, std::string what, long steps) {
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
  int add(const geometry::Polygon& outline, bool fixed, int material = 1) {
    Model& model = scene_.model;
    model.blocks.append(
        {{outline, material, model.settings.materials.at(material).density,
          fixed ? Fixity::by_user : Fixity::free}});
    return model.blocks.size() - 1;
  }
  /// Adds the rectangle [x, x + w] x [y, y + h].
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
  /// Returns the scene. Block b is expected to move by way(steps, dt); all others stay.
  Scene moves(int b, std::function<Vec2(long steps, double dt)> way) {
    const int n = scene_.model.blocks.size();
    scene_.expected = [n, b, way](long steps, double dt) {
      Eigen::Matrix2Xd all = Eigen::Matrix2Xd::Zero(2, n);
      all.col(b) = way(steps, dt);
      return all;
    };
    return scene_;
  }
  /// Returns the scene. Block b is expected to fall freely; velocities are updated
  /// before positions.
  Scene falls(int b) {
    return moves(b, [a = scene_.model.settings.gravity](long k, double dt) {
      return Vec2(
          a * (0.5 * static_cast<double>(k) * static_cast<double>(k + 1) * dt * dt));
    });
  }
  /// Makes material 2 of this density, whose faces have a joint law between each other.
  void joint_material(double density, const JointLaw& law) {
    Settings& settings = scene_.model.settings;
    settings.materials[2] = settings.materials.at(1);
    settings.materials[2].density = density;
    settings.joint_laws[1] = law;
    settings.joint_of_materials[{2, 2}] = 1;
  }
  /// Holds the free block b against gravity by a force at its centroid.
  void make_weightless(int b) {
    Model& model = scene_.model;
    model.loads.forces.push_back(
        {b, -model.blocks.mass[b] * model.settings.gravity, TimeFunction::always});
  }
  /// Sets the spin of block b, positive anticlockwise, [1/T].
  void spin(int b, double rate) { scene_.model.blocks.spin[b] = rate; }
  /// Sets the time step as a fraction of the critical one.
  void fraction(double share) { scene_.model.settings.fraction = share; }
  const Model& model() const { return scene_.model; }
  Scene rests(double size) {
    scene_.size = size;
    return moves(0, [](long, double) { return Vec2(0, 0); });
  }

 private:
  Scene scene_;
};

}  // namespace blocks::study::scenes
