#include "study/scene_deck.hpp"

#include <fmt/format.h>

#include "model/safe_fraction.hpp"

namespace blocks::study {
namespace {

/// The cards CREATE of a block. Each of their lines begins with `before`.
std::string create_card(const Blocks& blocks, int b, const char* before) {
  const geometry::Polygon outline = blocks.outline(b);
  std::string card = fmt::format("{}CREATE, {}, {}, {}\n", before, outline.size(),
                                 blocks.material[b], blocks.is_free(b) ? 0 : 1);
  for (const int axis : {0, 1}) {
    card += before;
    for (std::size_t i = 0; i < outline.size(); ++i)
      card += fmt::format("{}{}",
                          i == 0       ? ""
                          : i % 4 == 0 ? fmt::format(",\n{}", before)
                                       : ", ",
                          outline[i][axis]);
    card += '\n';
  }
  return card;
}

/// The preliminary cards.
std::string settings_cards(const Settings& s, int blocks) {
  std::string cards = fmt::format(
      "START, {}, {}\n{}\nXLIMITS, {}, {}\nYLIMITS, {}, {}\nBOXES, {}, {}, {}\n"
      "STIFF, {}, {}\nFRACTION, {}\n",
      blocks, 100, s.title, s.lower.x(), s.upper.x(), s.lower.y(), s.upper.y(),
      s.boxes_x, s.boxes_y, s.contact_tolerance, s.normal_stiffness, s.shear_stiffness,
      fraction_in_force(s));
  for (const auto& [number, material] : s.materials)
    cards += fmt::format("MATERIAL, {}, {}, {}, {}\n", number, material.youngs_modulus,
                         material.shear_modulus, material.density);
  if (!s.joint_laws.empty())
    cards += "FUNCTION, 2\n0, 1\n1.E30, 1\n";  // of the forces
  return cards + (s.rigid ? "RIGID\nEND\n" : "END\n");
}

/// The cards of bonded pieces.
std::string bond_cards(const Model& model) {
  std::string cards;
  for (const auto& [id, law] : model.settings.joint_laws)
    cards += fmt::format("JOINT, {}, {}, {}, {}, {}, {}, {}, , , {}, {}\n", id,
                         law.friction, law.cohesion, law.tension, law.residual_friction,
                         law.residual_cohesion, law.residual_tension,
                         law.normal_stiffness, law.shear_stiffness);
  for (const auto& [materials, id] : model.settings.joint_of_materials)
    cards += fmt::format("JPAIR, {}, {}, {}\n", materials.first, materials.second, id);
  if (!cards.empty())
    cards += "BOND\n";
  for (const CentroidForce& load : model.loads.forces)
    cards += fmt::format("FORCE, {}, {}, {}\n", load.block + 1, load.force.x(),
                         load.force.y());
  return cards;
}

}  // namespace

std::string deck_of_frame(const Scene& scene, const Frame& frame, long steps) {
  const Model model = place(scene.model, frame, Corners::sharp);
  const Blocks& blocks = model.blocks;
  Settings settings = model.settings;
  if (settings.title.empty())
    settings.title = scene.name;
  std::string deck = fmt::format("$ {}: {}\n", scene.name, scene.what);
  deck += settings_cards(settings, blocks.size());
  for (int b = 0; b < blocks.size(); ++b)
    deck += create_card(blocks, b, "");
  if (scene.uncut)
    deck +=
        "$ The domain in one piece:\n" +
        create_card(place(scene.uncut->model, frame, Corners::sharp).blocks, 0, "$ ");
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.is_free(b))
      deck += fmt::format("SETVEL, {}, 0, {}, {}, {}\n", b + 1, blocks.velocity(0, b),
                          blocks.velocity(1, b), blocks.spin[b]);
  deck += bond_cards(model);
  deck += fmt::format("GRAVITY, {}, {}\nFRICTN, {}\nDAMPING, {}\nCYCLE, {}\nSTOP\n",
                      settings.gravity.x(), settings.gravity.y(), settings.friction,
                      settings.damping, steps);
  return deck;
}

}  // namespace blocks::study
