#include "dynamics/preparation/in_situ_planes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dynamics/loads/symmetry_planes.hpp"

namespace blocks::dynamics {
namespace {

/// The forces of a plane on a corner, [F].
struct CornerLoad {
  double normal = 0.0, shear = 0.0;
};

/// A plane with its unit vectors.
class PlaneFrame {
 public:
  explicit PlaneFrame(const Plane& plane)
      : origin_(plane.a), along_((plane.b - plane.a).normalized()),
        inward_(-along_.y(), along_.x()) {}

  double depth(const Vec2& at) const { return inward_.dot(origin_ - at); }
  /// Returns whether the side lies on the plane and the block in front of it.
  bool is_on(const Vec2& from, const Vec2& to, double tolerance) const {
    return std::abs(depth(from)) <= tolerance && std::abs(depth(to)) <= tolerance &&
           along_.dot(to - from) < 0.0;
  }
  CornerLoad load_of(const Eigen::Matrix2d& force) const {
    return {-inward_.dot(force * inward_), along_.dot(force * inward_)};
  }

 private:
  Vec2 origin_, along_, inward_;
};

}  // namespace

void load_planes(Model& model, const std::function<bool(int block)>& chosen,
                 InSituReport& report) {
  if (model.settings.planes.empty())
    return;
  const Blocks& blocks = model.blocks;
  const StressField& field = model.settings.ground;
  const double tolerance = flush_tolerance(model.settings);
  std::vector<PlaneContact> memory;
  update_plane_contacts(model, memory, tolerance);
  model.search.invalidate();  // the list has only the corners on the planes
  std::vector<PlaneContact>& list = model.plane_contacts;
  std::vector<CornerLoad> loads(list.size());
  std::vector<char> loaded(list.size());
  const auto place_of = [&](int plane, int corner) {
    const auto found =
        std::lower_bound(list.begin(), list.end(), std::pair(plane, corner),
                         [](const PlaneContact& one, const std::pair<int, int>& key) {
                           return std::pair(one.plane, one.corner) < key;
                         });
    return static_cast<std::size_t>(found - list.begin());
  };
  for (std::size_t i = 0; i < list.size(); ++i) {
    const int from = list[i].corner, to = blocks.next[from];
    const PlaneFrame plane(model.settings.planes[list[i].plane]);
    const Vec2 a = blocks.corner.col(from), b = blocks.corner.col(to);
    if (!chosen(blocks.corner_block[from]) || !plane.is_on(a, b, tolerance))
      continue;
    ++report.faces;
    const Eigen::Matrix2d at[2] = {field.at(a.y()), field.at(b.y())};
    const std::size_t place[2] = {i, place_of(list[i].plane, to)};
    for (int end = 0; end < 2; ++end) {
      const CornerLoad more =
          plane.load_of(((b - a).norm() / 6.0) * (2.0 * at[end] + at[1 - end]));
      loads[place[end]].normal += more.normal;
      loads[place[end]].shear += more.shear;
      loaded[place[end]] = 1;
    }
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!loaded[i])
      continue;
    PlaneContact& contact = list[i];
    const auto [normal, shear] = loads[i];
    const Vec2 at = blocks.corner.col(contact.corner);
    const double depth = PlaneFrame(model.settings.planes[contact.plane]).depth(at);
    contact.active = normal > 0.0;
    contact.normal_elastic = contact.normal_force = std::max(0.0, normal);
    contact.overlap = std::max(0.0, depth);
    const double pressed = normal / model.settings.normal_stiffness;
    contact.offset = contact.active ? std::max(0.0, pressed - depth) : 0.0;
    report.contacts += contact.active;
    report.open += normal < 0.0;
    constexpr double rounding = 1e-9;
    report.sheared += std::abs(shear) > rounding * std::abs(normal);
  }
}

bool has_sides_on(const Model& model, const Plane& plane) {
  const Blocks& blocks = model.blocks;
  const PlaneFrame frame(plane);
  const double tolerance = flush_tolerance(model.settings);
  for (int c = 0; c < blocks.corners(); ++c)
    if (blocks.is_free(blocks.corner_block[c]) &&
        frame.is_on(blocks.corner.col(c), blocks.corner.col(blocks.next[c]), tolerance))
      return true;
  return false;
}

}  // namespace blocks::dynamics
