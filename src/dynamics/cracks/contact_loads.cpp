#include "dynamics/cracks/contact_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "dynamics/preparation/face_loads.hpp"

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The least force that can split a block of each material, [F].
std::map<int, double> min_forces(const Settings& settings, double part) {
  std::map<int, double> min;
  for (const auto& [material, rule] : settings.crack_rules)
    if (rule.point_strength > 0.0)
      min[material] = 0.5 * std::numbers::pi * rule.point_strength * part *
                      std::sqrt(rule.min_area);
  return min;
}

auto first_of(const std::vector<std::pair<int, PointLoad>>& loads, int b) {
  return std::lower_bound(
      loads.begin(), loads.end(), b,
      [](const auto& load, int block) { return load.first < block; });
}

}  // namespace

ContactLoads::ContactLoads(const Model& model, double part) {
  const Blocks& blocks = model.blocks;
  const std::map<int, double> min = min_forces(model.settings, part);
  if (min.empty())
    return;
  int material = 0;
  double enough = infinite;
  const auto add = [&](int corner, const Vec2& at, const Vec2& force) {
    const int b = blocks.corner_block[corner];
    if (blocks.material[b] != material) {
      material = blocks.material[b];
      const auto found = min.find(material);
      enough = found == min.end() ? infinite : found->second;
    }
    if (blocks.is_free(b) && force.squaredNorm() >= enough * enough)
      loads_.emplace_back(b, PointLoad{at, force});
  };
  for (const Contact& contact : model.contacts) {
    const Vec2 at = blocks.corner.col(contact.corner);
    const Vec2 force = force_on_corner(blocks, contact);
    add(contact.corner, at, force);
    add(contact.edge, at, -force);
  }
  for (const PlaneContact& contact : model.plane_contacts)
    if (contact.active)
      add(contact.corner, blocks.corner.col(contact.corner),
          force_on_corner(model.settings.planes[contact.plane], contact));
  std::stable_sort(loads_.begin(), loads_.end(),
                   [](const auto& l, const auto& r) { return l.first < r.first; });
}

bool ContactLoads::may_crack(int b) const {
  const auto first = first_of(loads_, b);
  return loads_.end() - first >= 2 && first->first == b && (first + 1)->first == b;
}

std::vector<PointLoad> ContactLoads::of(int b) const {
  std::vector<PointLoad> own;
  for (auto load = first_of(loads_, b); load != loads_.end() && load->first == b;
       ++load)
    own.push_back(load->second);
  return own;
}

}  // namespace blocks::dynamics
