#include "post/page/view_forces.hpp"
#include "files/file_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace blocks::post {

void ViewForces::add_frame(const FrameContacts& contacts, const ViewShapes& shapes,
                           const std::string& path) {
  std::vector<Arrow> arrows;
  for (int i = 0; i < contacts.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int block = contacts.corner_block[k];
    if (block < 1 || block > shapes.blocks())
      continue;
    const int corner = shapes.corner_index(block, contacts.corner[k]);
    if (corner < 0)
      throw files::FileError(
          fmt::format("cannot read {}: it is damaged: a contact is at corner {} of "
                      "block {}, which has {}",
                      path, contacts.corner[k], block, shapes.corners_of(block)));
    const Eigen::Vector2d n = contacts.normal.col(i), t(n.y(), -n.x());
    const Eigen::Vector2d f =
        n * contacts.normal_force[i] - t * contacts.shear_force[i];
    const double turn = std::atan2(f.y(), f.x()) / (2 * std::numbers::pi);
    arrows.push_back({corner,
                      static_cast<unsigned char>(std::lround(256 * (turn + 1)) % 256),
                      f.norm()});
    largest_ = std::max(largest_, arrows.back().size);
  }
  std::stable_sort(arrows.begin(), arrows.end(),
                   [](const Arrow& a, const Arrow& b) { return a.corner < b.corner; });
  arrows_.push_back(std::move(arrows));
}

/// Stores the number of forces of each corner in each frame, then the direction and
/// size of all forces. They are stored as differences from the same corner in the
/// previous frame. The size is on a logarithmic scale of 255 steps over six decades
/// below the largest.
void ViewForces::store(ViewStore& store, int count) const {
  const auto corners = static_cast<std::size_t>(count);
  Bytes acting, directions, sizes;
  std::vector<Bytes> old_directions(corners), old_sizes(corners);
  for (const auto& arrows : arrows_) {
    std::vector<Bytes> new_directions(corners), new_sizes(corners);
    for (const Arrow& arrow : arrows) {
      const auto corner = static_cast<std::size_t>(arrow.corner);
      const auto append_change = [&](unsigned char value, Bytes& changes, Bytes& now,
                                     const Bytes& before) {
        const std::size_t rank = now.size();
        changes.push_back(static_cast<unsigned char>(
            value - (rank < before.size() ? before[rank] : 0)));
        now.push_back(value);
      };
      const double decades = arrow.size > 0.0 ? std::log10(arrow.size / largest_) : -9;
      append_change(arrow.direction, directions, new_directions[corner],
                    old_directions[corner]);
      append_change(static_cast<unsigned char>(
                        std::clamp(std::lround(255 * (1 + decades / 6)), 0L, 255L)),
                    sizes, new_sizes[corner], old_sizes[corner]);
    }
    for (const Bytes& of_corner : new_sizes)
      acting.push_back(static_cast<unsigned char>(of_corner.size()));
    old_directions = std::move(new_directions);
    old_sizes = std::move(new_sizes);
  }
  store.add_frames("acting", acting, corners);
  store.add("directions", "u8", directions);
  store.add("sizes", "u8", sizes);
}

std::vector<std::size_t> ViewForces::counts() const {
  std::vector<std::size_t> counts;
  for (const auto& arrows : arrows_)
    counts.push_back(arrows.size());
  return counts;
}

}  // namespace blocks::post
