#include "post/page/view_bonds.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "quantities/bond.hpp"

namespace blocks::post {
namespace {

/// Rounds to 12 binary digits. A page shows three decimal digits, and the zeros that
/// follow take little space.
float rounded(double value) {
  constexpr std::uint32_t dropped = 0xfff, half = 0x800;
  const auto exact = static_cast<float>(value);
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(exact) + half) & ~dropped);
}

}  // namespace

void ViewBonds::add_frame(const FrameContacts& contacts, const ViewShapes& shapes) {
  std::uint32_t count = 0;
  for (int i = 0; i < contacts.size() && !contacts.states.empty(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const LawState& state = contacts.states[k];
    if (state.law == 0)
      continue;
    const int corner =
                  shapes.corner_index(contacts.corner_block[k], contacts.corner[k]),
              edge = shapes.corner_index(contacts.edge_block[k], contacts.edge[k]);
    if (corner < 0 || edge < 0)
      continue;
    ++count;
    corner_.push_back(static_cast<std::uint32_t>(corner));
    edge_.push_back(static_cast<std::uint32_t>(edge));
    bond_.push_back(
        static_cast<unsigned char>(quantities::bond_of(state.bonded, state.failed)));
    slip_.push_back(rounded(state.slip));
    dilation_.push_back(rounded(state.offset));
    normal_.push_back(rounded(contacts.normal_force[i]));
    shear_.push_back(rounded(contacts.shear_force[i]));
    length_.push_back(rounded(state.length));
    largest_slip_ = std::max(largest_slip_, std::abs(state.slip));
  }
  counts_.push_back(count);
}

void ViewBonds::store(ViewStore& store) const {
  store.add("bond_counts", "u32", counts_);
  store.add("bond_corner", "u32", corner_);
  store.add("bond_edge", "u32", edge_);
  store.add("bond_slip", "f32", slip_);
  store.add("bond_dilation", "f32", dilation_);
  store.add("bond_normal", "f32", normal_);
  store.add("bond_shear", "f32", shear_);
  store.add("bond_length", "f32", length_);
  store.add("bond_state", "u8", bond_);
}

}  // namespace blocks::post
