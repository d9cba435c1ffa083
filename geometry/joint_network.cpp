#include "geometry/joint_network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/block_shape.hpp"
#include "geometry/corner_in_edge.hpp"
#include "geometry/exact/box_pairs.hpp"
#include "geometry/rounding.hpp"

namespace blocks::geometry {
namespace {

/// The corners that meet, as disjoint sets. Each set is known by its smallest member.
class MeetingCorners {
 public:
  explicit MeetingCorners(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t vertex_of(std::size_t corner) {
    while (parent_[corner] != corner)
      corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::size_t one, std::size_t other) {
    one = vertex_of(one), other = vertex_of(other);
    parent_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Returns the length along which the edge c -> d touches the edge a -> b of another
/// clockwise block, up to reach.
double touching_length(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d,
                       double reach) {
  const Vec2 edge = b - a;
  if (edge.dot(d - c) >= 0.0)
    return 0.0;  // edges that touch have opposite directions
  const double length = edge.stableNorm();
  const auto along = [&](const Vec2& p) { return edge.dot(p - a) / length; };
  const auto aside = [&](const Vec2& p) { return cross(edge, p - a) / length; };
  const double from = along(d), to = along(c);
  const double low = std::max(from, 0.0), high = std::min(to, length);
  if (high - low <= reach)
    return 0.0;  // the edges share at most a corner
  const double slope = (aside(c) - aside(d)) / (to - from);
  const auto aside_at = [&](double place) { return aside(d) + slope * (place - from); };
  return std::abs(aside_at(low)) <= reach && std::abs(aside_at(high)) <= reach
             ? high - low
             : 0.0;
}

double touching_length(const Polygon& p, const Polygon& q, double reach) {
  double length = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = 0; j < q.size(); ++j)
      length += touching_length(p[i], p[(i + 1) % p.size()], q[j],
                                q[(j + 1) % q.size()], reach);
  return length;
}

}  // namespace

JointNetwork find_joint_network(const std::vector<Polygon>& outlines) {
  double reach = 0.0;
  std::vector<std::size_t> first = {0};
  for (const Polygon& outline : outlines) {
    reach = std::max(reach, rounding_units * coarsest_ulp(outline));
    first.push_back(first.back() + outline.size());
  }
  MeetingCorners meeting(first.back());
  std::vector<char> is_inside(first.back(), 0);
  struct Joint {
    std::size_t block, other;
    double length;
  };
  std::vector<Joint> joints;
  const auto find_inside = [&](std::size_t from, std::size_t to) {
    for (std::size_t c = 0; c < outlines[from].size(); ++c)
      if (is_inside_an_edge(outlines[from][c], outlines[to], reach))
        is_inside[first[from] + c] = 1;
  };
  exact::for_each_close_pair(outlines, std::vector<double>(outlines.size(), reach),
                             [&](std::size_t i, std::size_t j) {
                               const Polygon &p = outlines[i], &q = outlines[j];
                               find_inside(i, j);
                               find_inside(j, i);
                               for (std::size_t c = 0; c < p.size(); ++c)
                                 for (std::size_t d = 0; d < q.size(); ++d)
                                   if ((p[c] - q[d]).norm() <= reach)
                                     meeting.join(first[i] + c, first[j] + d);
                               if (const double length = touching_length(p, q, reach);
                                   length > 0.0)
                                 joints.push_back({i, j, length});
                             });
  // The order of the pairs may differ from call to call, and the sum must not.
  std::sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) {
    return std::tie(a.block, a.other) < std::tie(b.block, b.other);
  });
  JointNetwork network;
  for (const Joint& joint : joints)
    network.length += joint.length;
  struct Vertex {
    int corners = 0;
    bool is_inside = false;
  };
  std::vector<Vertex> vertices(first.back());
  for (std::size_t c = 0; c < first.back(); ++c) {
    Vertex& vertex = vertices[meeting.vertex_of(c)];
    ++vertex.corners;
    vertex.is_inside = vertex.is_inside || is_inside[c] != 0;
  }
  for (const Vertex& vertex : vertices)
    if (vertex.is_inside)
      ++network.t_vertices;
    else if (vertex.corners >= 4)
      ++network.x_vertices;
  return network;
}

}  // namespace blocks::geometry
