#include "model/words/law_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "text/counted.hpp"

namespace blocks {
namespace {

std::string strength(const JointLaw& law) {
  std::string text = fmt::format(
      "fric {:g}, coh {:g}, ten {:g}; residual fric {:g}, coh {:g}, ten {:g}",
      law.friction, law.cohesion, law.tension, law.residual_friction,
      law.residual_cohesion, law.residual_tension);
  if (law.dilation > 0.0)
    text += fmt::format("; tan(dil) {:.6g}{}", law.dilation,
                        std::isinf(law.dilation_limit)
                            ? std::string()
                            : fmt::format(" up to a slip of {:g}", law.dilation_limit));
  return text;
}

/// "kn 1e+09 per area, Ks of STIFF"
std::string stiffnesses(const JointLaw& law) {
  const auto one = [](const char* per_area, const char* constant, double value) {
    return value > 0.0 ? fmt::format("{} {:g} per area", per_area, value)
                       : fmt::format("{} of STIFF", constant);
  };
  const std::string shear = one("ks", "Ks", law.shear_stiffness);
  return law.kind == LawKind::barton
             ? shear
             : one("kn", "Kn", law.normal_stiffness) + ", " + shear;
}

std::string values(const JointLaw& law) {
  switch (law.kind) {
  case LawKind::walton:
    return fmt::format("Walton, restitution {:g}, {}; {}", law.restitution,
                       strength(law), stiffnesses(law));
  case LawKind::barton:
    return fmt::format(
        "Barton-Bandis, JRC {:g}, JCS {:g}, phir {:g} degrees, upeak {:g}; "
        "kni {:g}, vm {:g}, knmax {:g}; {}",
        law.roughness, law.wall_strength, law.residual_angle, law.peak_slip,
        law.initial_stiffness, law.largest_closure, law.largest_stiffness,
        stiffnesses(law));
  case LawKind::coulomb:
    break;
  }
  return fmt::format("Mohr-Coulomb, {}; {}", strength(law), stiffnesses(law));
}

std::string material_text(const Settings& settings, int number) {
  const auto found = settings.materials.find(number);
  return found == settings.materials.end() || found->second.name.empty()
             ? std::to_string(number)
             : fmt::format("{} ({})", number, found->second.name);
}

/// Returns where the law of a joint id acts.
std::string places(const Model& model, int id) {
  const Blocks& blocks = model.blocks;
  long sides = 0;
  for (int c = 0; c < blocks.corners(); ++c)
    sides += blocks.joint[c] == id && !blocks.is_removed(blocks.corner_block[c]);
  std::string text;
  if (sides > 0)
    text = fmt::format("where two of {} with this id meet", counted(sides, "side"));
  for (const auto& [pair, joint] : model.settings.joint_of_materials)
    if (joint == id)
      text += fmt::format("{}between materials {} and {}", text.empty() ? "" : "; ",
                          material_text(model.settings, pair.first),
                          material_text(model.settings, pair.second));
  return text.empty() ? "nowhere: no side has this id, and no JPAIR card names it"
                      : text;
}

}  // namespace

std::string law_report(const Model& model) {
  std::string text;
  for (const auto& [id, law] : model.settings.joint_laws)
    text += fmt::format("joint {}: {}\njoint {} acts {}\n", id, values(law), id,
                        places(model, id));
  if (!text.empty())
    text += fmt::format("all other contacts: FRICTN {:g}, STIFF {:g}, {:g}\n",
                        model.settings.friction, model.settings.normal_stiffness,
                        model.settings.shear_stiffness);
  for (const Servo& servo : model.servos)
    text += fmt::format(
        "block {} is driven by a servo: normal stress {:g} on side {}, speed up to "
        "{:g}\n",
        servo.block + 1, servo.target, servo.side + 1, servo.max_speed);
  const auto has_servo = [&](int block) {
    return std::any_of(model.servos.begin(), model.servos.end(),
                       [&](const Servo& servo) { return servo.block == block; });
  };
  for (const Drive& drive : model.drives)
    if (!has_servo(drive.block))
      text += fmt::format("block {} is driven: velocity ({:g}, {:g}), spin {:g}\n",
                          drive.block + 1, drive.velocity.x(), drive.velocity.y(),
                          drive.spin);
  return text;
}

std::string bonds_line(const Model& model) {
  const ModelTotals sum = totals(model);
  std::string text =
      fmt::format("joints: {} with a law, {} bonded, {} failed",
                  counted(sum.with_law, "contact"), sum.bonded, sum.failed);
  if (model.bonds_made > 0)
    text +=
        fmt::format("; {} of {} broken", sum.broken, counted(model.bonds_made, "bond"));
  return text;
}

}  // namespace blocks
