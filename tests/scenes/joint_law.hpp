// A joint law for tests of the motion, and frames to test it in.
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

}  // namespace blocks::scenes
