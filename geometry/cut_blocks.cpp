#include "geometry/cut_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "geometry/exact/kernels.hpp"
#include "geometry/polygon.hpp"

namespace blocks::geometry {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// A vertex moves by at most this many units in the last place of the largest coordinate
// at a time, as corners of layers do.
constexpr double max_units = 64.0;
constexpr int max_rounds = 64;

class BlockMaker {
 public:
  BlockMaker(CutResult& result, StraightCorners dropped, StepProgress& progress)
      : result_(result), progress_(progress), vertices_(result.mesh.vertices),
        dropped_(std::move(dropped)), axes_(vertices_.size()) {
    for (std::size_t c = 0; c < dropped_.size(); ++c)
      if (std::find(dropped_[c].begin(), dropped_[c].end(), true) != dropped_[c].end())
        cells_.push_back(c);
    note_axes();
  }
  void move_out() {
    bool moving = true;
    for (int round = 0; round < max_rounds && moving; ++round) {
      moving = false;
      for_each_intruder([&](std::size_t, std::size_t, int v, const Vec2& a,
                            const Vec2& b) { moving = leave(v, a, b) || moving; });
    }
  }
  // A vertex that is still inside the block remains its corner. This changes the sides
  // beside it, so all are tested again.
  void keep_intruders() {
    for (bool changed = true; changed;) {
      changed = false;
      for_each_intruder(
          [&](std::size_t cell, std::size_t i, int, const Vec2&, const Vec2&) {
            dropped_[cell][i] = false;
            changed = true;
          });
    }
    for (const std::size_t cell : cells_) {
      progress_.count(0, 1);
      Polygon outline;
      for (const int v : block(cell).corners)
        outline.push_back(vertices_[index(v)]);
      const OutlineCheck check = check_outline(outline);
      if (check.fault != OutlineFault::none || check.anticlockwise)
        std::fill(dropped_[cell].begin(), dropped_[cell].end(), false);
    }
  }
  CutBlock block(std::size_t cell) const {
    CutBlock made;
    for (std::size_t i = 0; i < dropped_[cell].size(); ++i)
      if (!dropped_[cell][i]) {
        made.corners.push_back(result_.mesh.cells[cell][i]);
        made.joints.push_back(result_.joints[cell][i]);
      }
    return made;
  }
  const StraightCorners& dropped() const { return dropped_; }

 private:
  struct Axes {
    bool horizontal = false, vertical = false;
  };

  // Calls visit for dropped vertices inside the block, with the side that they are in.
  template <typename Visit> void for_each_intruder(Visit visit) {
    for (const std::size_t cell : cells_) {
      progress_.count(0, 1);
      const std::vector<int>& loop = result_.mesh.cells[cell];
      const std::size_t n = loop.size();
      std::size_t before = 0, after = 0;  // ends of the side; i is inside
      bool is_new = true;                 // no vertex of this side was visited
      while (dropped_[cell][before])
        before = (before + n - 1) % n;
      for (std::size_t i = 0; i < n; ++i) {
        if (!dropped_[cell][i]) {
          before = i;
          is_new = true;
          continue;
        }
        if (is_new)
          for (after = i; dropped_[cell][after];)
            after = (after + 1) % n;
        is_new = false;
        const Vec2 a = vertices_[index(loop[before])],
                   b = vertices_[index(loop[after])];
        if (is_inside(a, b, vertices_[index(loop[i])]))
          visit(cell, i, loop[i], a, b);
        if (!dropped_[cell][i])
          before = i;
      }
    }
  }
  static bool is_inside(const Vec2& a, const Vec2& b, const Vec2& p) {
    return CGAL::orientation(exact::point(a), exact::point(b), exact::point(p)) ==
           CGAL::RIGHT_TURN;
  }
  void note_axes() {
    for (const std::vector<int>& loop : result_.mesh.cells) {
      progress_.count(0, 1);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int v = loop[i], w = loop[(i + 1) % loop.size()];
        for (const int end : {v, w}) {
          Axes& axes = axes_[index(end)];
          axes.horizontal =
              axes.horizontal || vertices_[index(v)].y() == vertices_[index(w)].y();
          axes.vertical =
              axes.vertical || vertices_[index(v)].x() == vertices_[index(w)].x();
        }
      }
    }
  }
  // Moves the vertex out of the side a -> b, along the axis of an axis-parallel edge if
  // that is enough. Returns whether it moved.
  bool leave(int v, const Vec2& a, const Vec2& b) {
    const Vec2 from = vertices_[index(v)];
    const Vec2 out(a.y() - b.y(), b.x() - a.x());
    const Axes axes = axes_[index(v)];
    const int steeper = std::abs(out.x()) > std::abs(out.y()) ? 0 : 1;
    const int kept = axes.horizontal == axes.vertical ? steeper
                     : axes.horizontal                ? 0
                                                      : 1;
    const double largest =
        std::max(a.lpNorm<Eigen::Infinity>(), from.lpNorm<Eigen::Infinity>());
    for (const int axis : {kept, steeper}) {
      double step =
          std::nextafter(largest, std::numeric_limits<double>::max()) - largest;
      for (; step <= max_units * 0x1p-52 * largest && out[axis] != 0.0; step *= 2.0) {
        Vec2 to = from;
        to[axis] += std::copysign(step, out[axis]);
        if (is_inside(a, b, to))
          continue;
        vertices_[index(v)] = to;
        return true;
      }
    }
    return false;
  }

  CutResult& result_;
  StepProgress& progress_;
  std::vector<Vec2>& vertices_;
  StraightCorners dropped_;
  std::vector<Axes> axes_;
  std::vector<std::size_t> cells_;  ///< with dropped vertices
};

std::size_t count(const StraightCorners& corners) {
  std::size_t sum = 0;
  for (const auto& of_cell : corners)
    sum += static_cast<std::size_t>(std::count(of_cell.begin(), of_cell.end(), true));
  return sum;
}

}  // namespace

std::size_t short_sides(const CutResult& result, double emin) {
  if (emin == 0.0)
    return 0;
  std::set<std::pair<int, int>> found;
  for (const CutBlock& block : result.blocks)
    for (std::size_t i = 0; i < block.corners.size(); ++i) {
      const int v = block.corners[i], w = block.corners[(i + 1) % block.corners.size()];
      if ((result.mesh.vertices[index(v)] - result.mesh.vertices[index(w)])
              .squaredNorm() < emin * emin)
        found.emplace(std::min(v, w), std::max(v, w));
    }
  return found.size();
}

void make_blocks(CutResult& result, const StraightCorners& straight,
                 StepProgress progress) {
  const std::vector<Vec2> before = result.mesh.vertices;
  const auto finish = [&](BlockMaker& maker) {
    maker.keep_intruders();
    result.blocks.clear();
    result.blocks.reserve(result.mesh.cells.size());
    for (std::size_t c = 0; c < result.mesh.cells.size(); ++c) {
      progress.count(0, 1);
      result.blocks.push_back(maker.block(c));
    }
    result.report.kept_t_vertices = count(straight) - count(maker.dropped());
    result.report.moved_t_vertices = 0;
    for (std::size_t v = 0; v < before.size(); ++v)
      result.report.moved_t_vertices += before[v] != result.mesh.vertices[v] ? 1U : 0U;
    result.certificate = certify_tiling(result.mesh, &progress);
  };
  BlockMaker maker(result, straight, progress);
  maker.move_out();
  finish(maker);
  if (!result.certificate.holds && result.report.moved_t_vertices > 0) {
    result.mesh.vertices = before;  // thin cells may leave no space to move
    BlockMaker careful(result, straight, progress);
    finish(careful);
  }
}

}  // namespace blocks::geometry
