#include "post/read/joint_faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace blocks::post {
namespace {

using Outline = std::vector<Eigen::Vector2d>;

/// Sides of two blocks form a face if the cosine of their directions is at most this.
constexpr double facing = -0.95;

/// Returns the outline of a block, from 1; nullptr if the frame has none with that
/// corner, also from 1.
const Outline* outline_with(const Frame& frame, int block, int corner) {
  if (block < 1 || block > frame.size())
    return nullptr;
  const Outline& outline = frame.outlines[static_cast<std::size_t>(block) - 1];
  return corner < 1 || corner > static_cast<int>(outline.size()) ? nullptr : &outline;
}

}  // namespace

std::vector<FacePart> face_parts(const Frame& frame, const FrameContacts& contacts) {
  std::vector<FacePart> parts;
  for (int i = 0; i < contacts.size() && !contacts.states.empty(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const LawState& state = contacts.states[k];
    if (state.law == 0)
      continue;
    const Outline *own =
                      outline_with(frame, contacts.corner_block[k], contacts.corner[k]),
                  *other =
                      outline_with(frame, contacts.edge_block[k], contacts.edge[k]);
    if (own == nullptr || other == nullptr)
      continue;
    const std::size_t n = own->size(),
                      c = static_cast<std::size_t>(contacts.corner[k]) - 1,
                      e = static_cast<std::size_t>(contacts.edge[k]) - 1;
    const Eigen::Vector2d &corner = (*own)[c], &start = (*other)[e];
    const Eigen::Vector2d edge = (*other)[(e + 1) % other->size()] - start;
    const double length = edge.norm();
    const Eigen::Vector2d along = edge / length;
    const double foot = std::clamp((corner - start).dot(along), 0.0, length);
    for (const std::size_t next : {(c + n - 1) % n, (c + 1) % n}) {
      // Blocks are clockwise, so a side runs from the corner before to this corner, or
      // from this one to the next.
      const bool is_before = next == (c + n - 1) % n;
      const Eigen::Vector2d side =
          is_before ? corner - (*own)[next] : (*own)[next] - corner;
      if (side.normalized().dot(along) > facing)
        continue;
      const double end = std::clamp(((*own)[next] - start).dot(along), 0.0, length);
      parts.push_back({i, start + foot * along, start + 0.5 * (foot + end) * along,
                       quantities::bond_of(state.bonded, state.failed),
                       std::abs(state.slip)});
    }
  }
  const auto rank = [](const FacePart& part) {
    const bool has_slipped = part.bond == Bond::failed || part.bond == Bond::weakened;
    return std::tuple(has_slipped, part.slip);
  };
  std::stable_sort(
      parts.begin(), parts.end(),
      [&](const FacePart& a, const FacePart& b) { return rank(a) < rank(b); });
  return parts;
}

}  // namespace blocks::post
