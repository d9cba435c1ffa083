// A joint law for tests of the motion, and frames and a heap to test it in.
#pragma once

#include "model/joint_law.hpp"
#include "scenes/scene.hpp"

namespace blocks::scenes {

inline const Frame three_frames[] = {{}, {0.7, {3, -2}}, {-2.2, {1000, 500}}};

/// Returns a law with cohesion, tensile strength and stiffnesses of its own.
inline JointLaw cohesive() {
  JointLaw law;
  law.friction = law.residual_friction = 0.5;
  law.cohesion = 2e5, law.tension = 1e5;
  law.normal_stiffness = law.shear_stiffness = 1e9;
  return law;
}

/// Gives all contacts of a scene this law, with joint id 7.
inline void use_law(Scene& scene, const JointLaw& law) {
  scene.model.settings.joint_laws[7] = law;
  scene.model.settings.joint_of_materials[{1, 1}] = 7;
}

/// Returns a heap of leaning bricks between a floor and a wall, which falls and slides.
inline Scene heap(bool rigid, int threads = 1) {
  Scene scene({0.3, {10, 20}}, threads);
  scene.model.settings.rigid = rigid;
  scene.model.settings.damping = 0.2;
  scene.box(-2, -1, 24, 1, true);
  scene.box(-2, 0, 1, 8, true);
  for (int row = 0; row < 6; ++row)
    for (int i = 0; i < 15; ++i) {
      const double lean = 0.05 * ((7 * i + 3 * row) % 5 - 2);
      const double x = i + 0.3 * (row % 2), y = 1.01 * row;
      scene.add({{x, y}, {x + lean, y + 1}, {x + 0.98 + lean, y + 1}, {x + 0.98, y}});
    }
  scene.gravity(0.5, -10);
  return scene;
}

}  // namespace blocks::scenes
