// Small models for the tests of files. All their values differ.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "files/file_error.hpp"
#include "model/model.hpp"
#include "output/results/results.hpp"

namespace blocks::samples {

/// Adds the rectangle [x, x + w] x [y, y + h] with density 2.
inline void add_box(Model& model, double x, double y, double w, double h,
                    Fixity fixity = Fixity::free, int layer = 0) {
  model.blocks.append(
      {{{{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}}, 3, 2.0, fixity, layer}});
}

inline void add_triangle(Model& model, double x, double y) {
  model.blocks.append({{{{x, y}, {x, y + 1}, {x + 1, y}}, 4, 1.5, Fixity::free, 0}});
}

/// Returns a model with settings only.
inline Model no_blocks() {
  Model model;
  model.settings.lower = {-10, -10};
  model.settings.upper = {10, 10};
  model.settings.fraction = 0.05;
  return model;
}

/// Returns a box in contact with a fixed one below, and a plane.
inline Model two_blocks() {
  Model model = no_blocks();
  Settings& s = model.settings;
  s.title = "Two blocks";
  s.max_blocks = 10;
  s.max_corners = 4;
  s.boxes_x = 4;
  s.boxes_y = 2;
  s.normal_stiffness = 1e7;
  s.shear_stiffness = 5e6;
  s.friction = 0.5;
  s.gravity = {0, -9.81};
  s.rigid = true;
  s.materials[3] = {1e10, 4e9, 2.0, "sandstone"};
  s.planes.push_back({{-5, 1}, {-5, 0}});
  add_box(model, -4, -1, 8, 1, Fixity::by_user);
  add_box(model, -1, -0.0625, 2, 2);
  model.contacts = {{4, 1, 0.5, 0.0, 0.75, -0.125, 0.0625}};
  model.plane_contacts.emplace_back();
  model.blocks.velocity.col(1) = Vec2(0.5, -0.25);
  model.blocks.force.col(1) = Vec2(-0.125, 0.75);
  model.blocks.stress.col(1) << 1, 2, 2, -3;
  model.time_step = {0.001, 1, 2, false};
  model.steps = 7;
  model.time = 0.007;
  return model;
}

/// Adds laws of joints, the states of the two contacts and a drive to two_blocks() with
/// two contacts. The first contact is in tension.
inline void add_laws(Model& model) {
  JointLaw& coulomb = model.settings.joint_laws[5];
  coulomb.friction = 0.75, coulomb.residual_friction = 0.5;
  coulomb.cohesion = 8, coulomb.residual_cohesion = 4;
  coulomb.tension = 2, coulomb.residual_tension = 1;
  coulomb.dilation = 0.25, coulomb.dilation_limit = 0.125;
  coulomb.normal_stiffness = 1e6, coulomb.shear_stiffness = 2e6;
  JointLaw& walton = model.settings.joint_laws[6];
  walton.kind = LawKind::walton, walton.restitution = 0.625;
  JointLaw& barton = model.settings.joint_laws[7];
  barton.kind = LawKind::barton, barton.roughness = 10, barton.wall_strength = 1e4;
  barton.residual_angle = 30, barton.peak_slip = 0.25, barton.initial_stiffness = 1e5;
  barton.largest_closure = 0.5, barton.largest_stiffness = 1e6;
  model.settings.joint_of_materials[{3, 3}] = 5;
  model.law_states = {
      {5, 3e6, 4e6, -0.03125, 0.0625, 0.015625, 0.0078125, 0.25, true, false, 0.75},
      {0, 1e7, 5e6, 0, 0, 0, 0, 0, false, true, 0}};
  model.bonds_made = 3;
  model.contacts[0].normal_elastic = model.contacts[0].normal_force = -0.5;
  model.contacts[0].overlap = -0.0625;
  model.drives = {{0, {0.375, -0.625}, 0.875}};
  model.servos = {{0, 2, -4.5, 1.25}};
  model.blocks.fixity[0] = Fixity::driven;
  model.blocks.velocity.col(0) = model.drives[0].velocity;
  model.blocks.spin[0] = model.drives[0].spin;
}

/// Returns the record of a crack of block 2, whose other piece is block 3.
inline CrackRecord crack_of_block_2() {
  CrackRecord crack;
  crack.step = 6, crack.time = 0.00625;
  crack.parent = 1, crack.child = 2;
  crack.stress = 1.25e6;
  crack.from = {-1.5, 4.5}, crack.to = {1.5, 0.5};
  crack.moved = 0.0078125;
  crack.parent_area = 5.0, crack.child_area = 3.0;
  crack.kinetic_before = 8.0, crack.kinetic_after = 6.5;
  crack.strain_before = 20.0, crack.strain_after = 2.25;
  return crack;
}

/// A new temporary folder. The destructor removes it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name =
        (std::filesystem::temp_directory_path() / "blocks-output-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

inline std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline void overwrite(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// Returns the message of the FileError that `action` throws, or an empty text.
template <class Action> std::string file_error(Action&& action) {
  try {
    action();
  } catch (const files::FileError& error) {
    return error.what();
  }
  return {};
}

}  // namespace blocks::samples
