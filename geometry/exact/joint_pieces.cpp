#include "geometry/exact/joint_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/exact/shared_point.hpp"

namespace blocks::geometry::exact {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Returns the part of p -> q inside the window, or nothing. Products of coordinates
// beyond it could overflow.
std::optional<std::pair<ExactPoint, ExactPoint>> clipped(const ExactPoint& from,
                                                         const ExactPoint& to) {
  const Rational limit(4.0 * largest_coordinate);
  const Point p = point_of(from), q = point_of(to);
  Rational first = 0, last = 1;  // of p + t (q - p)
  const auto d = q - p;
  for (const auto& [start, run] : {std::pair(p.x(), d.x()), std::pair(p.y(), d.y())}) {
    if (run == 0) {
      if (abs(start) > limit)
        return {};
      continue;
    }
    Rational in = (-limit - start) / run, out = (limit - start) / run;
    if (out < in)
      std::swap(in, out);
    first = std::max(first, in);
    last = std::min(last, out);
  }
  if (!(first < last))
    return {};
  return std::pair(exact_point(p + first * d), exact_point(p + last * d));
}

bool is_far(const ExactPoint& p) {
  return p.nearest().cwiseAbs().maxCoeff() > 4.0 * largest_coordinate;
}

// Collects the ends of sides and joints, and numbers them in their order.
class Ends {
 public:
  void reserve(std::size_t count) { points_.reserve(count); }
  void add(ExactPoint from, ExactPoint to) {
    points_.push_back(std::move(from));
    points_.push_back(std::move(to));
  }
  std::size_t size() const { return points_.size(); }
  // Returns the different points in their order, and the number of each one added.
  std::vector<ExactPoint> sorted(std::vector<int>& numbers, StepProgress& progress) {
    struct Keyed {
      double x;
      int index;
    };
    std::vector<Keyed> order;
    order.reserve(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      order.push_back({points_[i].nearest().x(), static_cast<int>(i)});
    std::sort(order.begin(), order.end(), [&](const Keyed& a, const Keyed& b) {
      progress.count(0, 1);
      // Rounding keeps the order, so different doubles decide.
      return a.x != b.x ? a.x < b.x
                        : compare(points_[at(a.index)], points_[at(b.index)]) < 0;
    });
    std::vector<ExactPoint> result;
    result.reserve(points_.size());
    numbers.resize(points_.size());
    for (const Keyed& key : order) {
      progress.count(0, 1);
      ExactPoint& point = points_[at(key.index)];
      if (result.empty() || compare(result.back(), point) != 0)
        result.push_back(std::move(point));
      numbers[at(key.index)] = static_cast<int>(result.size()) - 1;
    }
    return result;
  }

 private:
  std::vector<ExactPoint> points_;
};

// Splits what overlaps on one line at all ends.
class Overlaps {
 public:
  Overlaps(const std::vector<Piece>& given, JointPieces& result)
      : given_(given), result_(result) {}

  void split(StepProgress& progress) {
    struct Keyed {
      std::uint64_t line;  ///< equal for equal lines
      int index;
    };
    std::vector<Keyed> order;
    order.reserve(given_.size());
    for (std::size_t i = 0; i < given_.size(); ++i) {
      progress.count(0, 1);
      order.push_back({result_.lines.hash(i), static_cast<int>(i)});
    }
    std::sort(order.begin(), order.end(), [&](const Keyed& a, const Keyed& b) {
      progress.count(0, 1);
      return a.line != b.line ? a.line < b.line : a.index < b.index;
    });
    std::vector<bool> is_alone(given_.size(), false);
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
      progress.count(0, 1);
      end = i + 1;
      while (end < order.size() && order[end].line == order[i].line)
        ++end;
      if (end == i + 1) {
        is_alone[at(order[i].index)] = true;
        continue;
      }
      std::vector<std::vector<int>> lines;  // usually one
      for (std::size_t k = i; k < end; ++k) {
        const int index = order[k].index;
        const auto same =
            std::find_if(lines.begin(), lines.end(), [&](const std::vector<int>& line) {
              return result_.lines.are_equal(at(line.front()), at(index));
            });
        (same == lines.end() ? lines.emplace_back() : *same).push_back(index);
      }
      for (std::vector<int>& line : lines)
        split_line(line);
    }
    for (std::size_t i = 0; i < given_.size(); ++i)
      if (is_alone[i])
        result_.pieces.push_back(given_[i]);
  }

 private:
  void split_line(std::vector<int>& line) {
    std::stable_sort(line.begin(), line.end(), [this](int i, int j) {
      return given_[at(i)].from < given_[at(j)].from;
    });
    std::vector<int> run;  // without gaps
    int farthest = -1;
    for (const int i : line) {
      const Piece& one = given_[at(i)];
      if (!run.empty() && one.from >= farthest) {
        split_run(run);
        run.clear();
      }
      farthest = run.empty() ? one.to : std::max(farthest, one.to);
      run.push_back(i);
    }
    split_run(run);
  }

  void split_run(const std::vector<int>& run) {
    if (run.size() == 1) {
      result_.pieces.push_back(given_[at(run[0])]);
      return;
    }
    std::vector<int> ends;
    for (const int i : run)
      ends.insert(ends.end(), {given_[at(i)].from, given_[at(i)].to});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<int> by_end = run;
    std::sort(by_end.begin(), by_end.end(),
              [this](int i, int j) { return given_[at(i)].to < given_[at(j)].to; });
    std::multiset<int> joints;  // of what contains the present part
    std::set<int> sides;        // at most one, because the outline is simple
    std::size_t begun = 0, ended = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      for (; begun < run.size() && given_[at(run[begun])].from == ends[k]; ++begun)
        if (given_[at(run[begun])].outline)
          sides.insert(run[begun]);
        else
          joints.insert(given_[at(run[begun])].joint);
      for (; ended < run.size() && given_[at(by_end[ended])].to == ends[k]; ++ended)
        if (given_[at(by_end[ended])].outline)
          sides.erase(by_end[ended]);
        else
          joints.erase(joints.find(given_[at(by_end[ended])].joint));
      const auto named = joints.upper_bound(0);
      const bool on_outline = !sides.empty();
      result_.pieces.push_back(
          {ends[k], ends[k + 1], on_outline ? *sides.begin() : run[0],
           on_outline || named == joints.end() ? 0 : *named, on_outline});
    }
  }

  const std::vector<Piece>& given_;
  JointPieces& result_;
};

}  // namespace

JointPieces joint_pieces(const std::vector<Point>& outline,
                         const std::vector<JointSegment>& joints,
                         StepProgress& progress) {
  JointPieces result;
  Ends ends;
  ends.reserve(2 * (outline.size() + joints.size()));
  std::vector<Piece> given;
  given.reserve(outline.size() + joints.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    ends.add(exact_point(outline[i]), exact_point(outline[(i + 1) % outline.size()]));
    given.push_back({.outline = true});
  }
  for (const JointSegment& joint : joints) {
    progress.count(0, 1);
    if (compare(joint.from, joint.to) == 0)
      continue;
    if (!is_far(joint.from) && !is_far(joint.to)) {
      ends.add(joint.from, joint.to);
    } else if (auto part = clipped(joint.from, joint.to)) {
      ends.add(std::move(part->first), std::move(part->second));
    } else {
      continue;
    }
    given.push_back({.joint = joint.id});
  }
  std::vector<int> numbers;
  result.ends = ends.sorted(numbers, progress);
  for (std::size_t i = 0; i < given.size(); ++i)
    std::tie(given[i].from, given[i].to) =
        std::minmax(numbers[2 * i], numbers[2 * i + 1]);
  // The sweep takes lines in the order of their first ends, so they are near in memory.
  const auto by_first_end = [&progress](const Piece& a, const Piece& b) {
    progress.count(0, 1);
    return std::tie(a.from, a.to, a.line) < std::tie(b.from, b.to, b.line);
  };
  std::sort(given.begin() + static_cast<std::ptrdiff_t>(outline.size()), given.end(),
            by_first_end);
  result.lines.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    progress.count(0, 1);
    given[i].line = static_cast<int>(i);
    result.lines.add(result.ends[at(given[i].from)], result.ends[at(given[i].to)]);
  }
  result.pieces.reserve(given.size());
  Overlaps(given, result).split(progress);
  std::sort(result.pieces.begin(), result.pieces.end(), by_first_end);
  return result;
}

}  // namespace blocks::geometry::exact
