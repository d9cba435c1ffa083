#include "validation/geometry/naive_cut.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace blocks::validation {
namespace {

using geometry::CutRequest;
using geometry::Mesh;
using geometry::Vec2;

struct Segment {
  Vec2 from, to;
  std::vector<double> splits;  // parameters from 0 to 1
  Vec2 at(double s) const { return from + s * (to - from); }
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double area_of(const std::vector<Vec2>& nodes, const std::vector<int>& loop) {
  double sum = 0.0;  // positive if anticlockwise
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += geometry::cross(nodes[at(loop[i])] - nodes[at(loop[0])],
                           nodes[at(loop[(i + 1) % loop.size()])] - nodes[at(loop[0])]);
  return sum / 2.0;
}

class Cutter {
 public:
  Cutter(const CutRequest& request, double tolerance) {
    Vec2 low(HUGE_VAL, HUGE_VAL), high = -low;
    for (const auto& corner : request.outline) {
      corners_.emplace_back(corner.x.value(), corner.y.value());
      low = low.cwiseMin(corners_.back());
      high = high.cwiseMax(corners_.back());
    }
    tolerance_ = tolerance * (high - low).maxCoeff();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      segments_.push_back({corners_[i], corners_[(i + 1) % corners_.size()], {}});
    for (const auto& joint : request.joints)
      if (joint.from.nearest() != joint.to.nearest())
        segments_.push_back({joint.from.nearest(), joint.to.nearest(), {}});
  }

  Mesh cut() {
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (std::size_t j = i + 1; j < segments_.size(); ++j)
        split(segments_[i], segments_[j]);
    make_edges();
    for (std::size_t round = 0;; ++round) {
      if (round > 10'000)
        throw std::runtime_error("does not end");
      remove_dangling();
      trace();
      if (!remove_useless())
        break;
    }
    return mesh();
  }

 private:
  void split(Segment& a, Segment& b) const {
    const Vec2 u = a.to - a.from, v = b.to - b.from, w = b.from - a.from;
    const double turn = geometry::cross(u, v);
    const double eps_a = tolerance_ / u.norm(), eps_b = tolerance_ / v.norm();
    if (std::abs(turn) > 1e-12 * u.norm() * v.norm()) {
      const double s = geometry::cross(w, v) / turn, t = geometry::cross(w, u) / turn;
      if (s > -eps_a && s < 1.0 + eps_a && t > -eps_b && t < 1.0 + eps_b) {
        a.splits.push_back(std::clamp(s, 0.0, 1.0));
        b.splits.push_back(std::clamp(t, 0.0, 1.0));
      }
    }
    // Ends on the other segment, also where the two overlap.
    const auto add = [this](Segment& s, const Vec2& p) {
      const Vec2 d = s.to - s.from;
      const double along = std::clamp(d.dot(p - s.from) / d.squaredNorm(), 0.0, 1.0);
      if ((s.at(along) - p).norm() < tolerance_)
        s.splits.push_back(along);
    };
    add(a, b.from);
    add(a, b.to);
    add(b, a.from);
    add(b, a.to);
  }
  int node(const Vec2& p) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if ((nodes_[i] - p).norm() < tolerance_)
        return static_cast<int>(i);
    nodes_.push_back(p);
    return static_cast<int>(nodes_.size()) - 1;
  }
  bool is_inside(const Vec2& p) const {
    bool inside = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
        inside = !inside;
    }
    return inside;
  }
  void make_edges() {
    for (const Vec2& corner : corners_)
      node(corner);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      Segment& s = segments_[i];
      s.splits.insert(s.splits.end(), {0.0, 1.0});
      std::sort(s.splits.begin(), s.splits.end());
      int last = -1;
      for (const double part : s.splits) {
        const int here = node(s.at(part));
        if (last >= 0 && here != last &&
            (i < corners_.size() ||
             is_inside((nodes_[at(here)] + nodes_[at(last)]) / 2)))
          connect(last, here);
        last = here;
      }
    }
  }
  void connect(int a, int b) {
    around_[a].insert(b);
    around_[b].insert(a);
  }
  void disconnect(int a, int b) {
    around_[a].erase(b);
    around_[b].erase(a);
  }
  // Removes ends that dangle, and what is not connected to the outline.
  void remove_dangling() {
    std::set<int> found = {0};
    std::vector<int> open = {0};
    while (!open.empty()) {
      const int v = open.back();
      open.pop_back();
      for (const int w : around_[v])
        if (found.insert(w).second)
          open.push_back(w);
    }
    for (std::size_t v = 0; v < nodes_.size(); ++v)
      if (!found.contains(static_cast<int>(v)))
        around_.erase(static_cast<int>(v));
    for (bool changed = true; changed;) {
      changed = false;
      for (auto& [v, others] : around_)
        if (others.size() == 1) {
          disconnect(v, *others.begin());
          changed = true;
          break;
        }
    }
  }
  // Traces the faces on the left of all directed edges by angles.
  void trace() {
    std::map<std::pair<int, int>, int> next;
    for (const auto& [v, others] : around_) {
      std::vector<std::pair<double, int>> order;
      for (const int w : others) {
        const Vec2 d = nodes_[at(w)] - nodes_[at(v)];
        order.emplace_back(std::atan2(d.y(), d.x()), w);
      }
      std::sort(order.begin(), order.end());
      // From w to v, the face on the left turns to the edge before v -> w.
      for (std::size_t i = 0; i < order.size(); ++i)
        next[{order[i].second, v}] =
            order[(i + order.size() - 1) % order.size()].second;
    }
    faces_.clear();
    std::set<std::pair<int, int>> done;
    for (const auto& [edge, unused] : next) {
      if (done.contains(edge))
        continue;
      std::vector<int> face;
      for (auto e = edge; done.insert(e).second; e = {e.second, next.at(e)})
        face.push_back(e.first);
      faces_.push_back(std::move(face));
    }
  }
  // Removes edges with one face on both sides, and loops that meet the rest of a face
  // in one node. Returns whether there were any.
  bool remove_useless() {
    std::vector<std::pair<int, int>> useless;
    for (const std::vector<int>& face : faces_) {
      std::set<std::pair<int, int>> sides;
      for (std::size_t i = 0; i < face.size(); ++i)
        sides.emplace(face[i], face[(i + 1) % face.size()]);
      for (const auto& [a, b] : sides)
        if (sides.contains({b, a}))
          useless.emplace_back(a, b);
      std::map<int, std::size_t> seen;
      for (std::size_t i = 0; i < face.size() && useless.empty(); ++i) {
        const auto [first, is_new] = seen.try_emplace(face[i], i);
        if (is_new)
          continue;
        std::vector<int> loop(face.begin() + static_cast<std::ptrdiff_t>(first->second),
                              face.begin() + static_cast<std::ptrdiff_t>(i)),
            rest(face.begin(),
                 face.begin() + static_cast<std::ptrdiff_t>(first->second));
        rest.insert(rest.end(), face.begin() + static_cast<std::ptrdiff_t>(i),
                    face.end());
        if (std::abs(area_of(nodes_, loop)) > std::abs(area_of(nodes_, rest)))
          std::swap(loop, rest);
        for (std::size_t k = 0; k < loop.size(); ++k)
          useless.emplace_back(loop[k], loop[(k + 1) % loop.size()]);
      }
    }
    for (const auto& [a, b] : useless)
      disconnect(a, b);
    return !useless.empty();
  }
  Mesh mesh() const {
    Mesh result;
    result.vertices = nodes_;
    for (std::vector<int> face : faces_) {
      const double area = area_of(nodes_, face);
      if (area == 0.0)
        continue;
      std::reverse(face.begin(), face.end());
      if (area > 0.0)
        result.cells.push_back(face);  // clockwise now
      else if (result.outline.empty() ||
               -area > std::abs(area_of(nodes_, result.outline)))
        result.outline = {face.rbegin(), face.rend()};
    }
    if (result.outline.empty())
      throw std::runtime_error("no outline");
    return result;
  }

  std::vector<Vec2> corners_, nodes_;
  std::vector<Segment> segments_;
  std::map<int, std::set<int>> around_;
  std::vector<std::vector<int>> faces_;
  double tolerance_ = 0.0;
};

}  // namespace

Mesh naive_cut(const CutRequest& request, double tolerance) {
  return Cutter(request, tolerance).cut();
}

}  // namespace blocks::validation
