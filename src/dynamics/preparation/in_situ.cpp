#include "dynamics/preparation/in_situ.hpp"

#include <algorithm>
#include <vector>

#include "dynamics/loads/applied_force.hpp"
#include "dynamics/loads/loads.hpp"
#include "dynamics/preparation/in_situ_contacts.hpp"
#include "dynamics/preparation/in_situ_planes.hpp"
#include "dynamics/search/near_pairs.hpp"
#include "model/removal.hpp"

namespace blocks::dynamics {
namespace {

void set_stresses(Blocks& blocks, const StressField& field) {
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_removed(b)) {
      const Eigen::Matrix2d stress = field.at(blocks.centroid(1, b));
      blocks.stress.col(b) << stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1);
    }
}

/// Sets the forces of all blocks to those of loads and listed contacts, as the next
/// step finds them.
void set_forces(Model& model) {
  Blocks& blocks = model.blocks;
  blocks.force.setZero();
  blocks.moment.setZero();
  blocks.applied.setZero();
  add_loads_of_cards(model);
  if (!model.loads.water.none())
    add_water(model, 0, blocks.size());
  for (const PlaneContact& contact : model.plane_contacts)
    add_force(blocks, blocks.corner_block[contact.corner],
              blocks.present_arm(contact.corner),
              force_on_corner(model.settings.planes[contact.plane], contact));
  for (const Contact& contact : model.contacts) {
    const Vec2 force = force_on_corner(blocks, contact);
    const Vec2 place = blocks.corner.col(contact.corner);
    const int ours = blocks.corner_block[contact.corner],
              other = blocks.corner_block[contact.edge];
    add_force(blocks, ours, place - blocks.centroid.col(ours), force);
    add_force(blocks, other, place - blocks.centroid.col(other), -force);
  }
  for (int b = 0; b < blocks.size(); ++b)
    blocks.applied.col(b) /= blocks.area[b];
}

/// Loads the faces of those pairs of blocks for which `chosen(pair)` is true.
template <class Chosen> InSituReport load_pairs(Model& model, const Chosen& chosen) {
  Settings& settings = model.settings;
  const bool had_states = settings.in_situ || !settings.joint_laws.empty();
  settings.in_situ = true;
  const double tolerance = flush_tolerance(settings);
  InSituReport report;
  LawTable laws;
  laws.make(settings, model.blocks);
  NearSearch memory;
  std::vector<NearPair> pairs;
  find_near_pairs(model.blocks, tolerance, memory, pairs);
  ContactLoading loading(model, laws, report);
  PairLoads loads(model.blocks, settings.ground);
  for (const NearPair& pair : pairs) {
    if (!chosen(pair))
      continue;
    loads.clear();
    each_face(model.blocks, pair.low, pair.high, [&](const Face& face) {
      if (face.is_flush(tolerance, same_point * face.length_of_side()))
        loads.add(face), ++report.faces;
    });
    loading.load(loads.all());
  }
  loading.finish();
  if (report.contacts == 0 && !had_states) {
    settings.in_situ = false;
    model.law_states.clear();
  }
  return report;
}

}  // namespace

void InSituReport::add_weak(const geometry::Vec2& at, double its_normal,
                            double its_shear, double loses) {
  if (weak++ > 0 && loses <= lost)
    return;
  weakest = at;
  normal = its_normal, shear = its_shear, lost = loses;
}

double flush_tolerance(const Settings& settings) {
  constexpr double part_of_ctol = 0.01;
  return part_of_ctol * settings.contact_tolerance;
}

InSituReport load_faces(Model& model, const StressField& field) {
  const Blocks& blocks = model.blocks;
  model.settings.ground = field;
  model.fixed_in_ground.clear();
  for (int b = 0; b < blocks.size(); ++b)
    if (!blocks.is_free(b) && !blocks.is_driven(b) && !blocks.is_removed(b))
      model.fixed_in_ground.push_back(b);
  if (!model.settings.rigid)
    set_stresses(model.blocks, field);
  InSituReport report = load_pairs(model, [](const NearPair&) { return true; });
  const auto every_block = [](int) { return true; };
  load_planes(model, every_block, report);
  set_forces(model);
  return report;
}

void free_in_ground(Model& model, const std::vector<int>& chosen) {
  free_blocks(model, chosen);
  std::vector<int>& fixed = model.fixed_in_ground;
  const std::vector<int> before = fixed;
  std::erase_if(fixed, [&](int b) { return model.blocks.is_free(b); });
  if (fixed.size() == before.size())
    return;
  const auto had_no_contacts = [&](int b) {
    return std::binary_search(before.begin(), before.end(), b);
  };
  InSituReport report = load_pairs(model, [&](const NearPair& pair) {
    return had_no_contacts(pair.low) && had_no_contacts(pair.high);
  });
  load_planes(model, had_no_contacts, report);
  if (report.faces > 0)
    set_forces(model);
}

}  // namespace blocks::dynamics
