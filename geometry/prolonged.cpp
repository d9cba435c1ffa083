#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "geometry/exact/box_pairs.hpp"
#include "geometry/exact/shared_point.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/numeric_environment.hpp"

namespace blocks::geometry {
namespace {

using exact::Point;
using exact::Rational;
using exact::Vector;

struct Piece {
  Point from, to;
};

// An end of a trace and the direction in which it may be prolonged.
struct End {
  std::size_t trace;
  bool at_to;
  Point place;
  Vector direction;  ///< the trace, so parameter 1 prolongs it by its own length
  bool dangles = true;
  std::optional<Rational> hit;  ///< least parameter > 0

  Point target() const { return place + direction * *hit; }
  bool reaches(const Rational& s, const Rational& reach) const {
    return s * s * direction.squared_length() <= reach * reach;
  }
};

exact::Box box_of(const Point& p, const Point& q, std::size_t number) {
  Vec2 a = exact::nearest(p), b = exact::nearest(q);
  // Encloses the exact points, whose distance to the nearest doubles is below an ulp.
  const double slack =
      0x1p-50 * std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>()) +
      std::numeric_limits<double>::denorm_min();
  return exact::box_of({a, b}, number, slack);
}

bool contains(const Piece& piece, const Point& p) {
  if (exact::cross(piece.to - piece.from, p - piece.from) != 0)
    return false;
  return CGAL::collinear_are_ordered_along_line(piece.from, p, piece.to);
}

// Records where the prolonged end meets the piece.
void meet(const Piece& piece, End& end) {
  const auto record = [&end](const Rational& s) {
    if (s > 0 && (!end.hit || s < *end.hit))
      end.hit = s;
  };
  const Vector side = piece.to - piece.from, to_piece = piece.from - end.place;
  const Rational turn = exact::cross(end.direction, side);
  if (turn != 0) {
    const Rational along = exact::cross(to_piece, end.direction) / turn;
    if (along >= 0 && along <= 1)
      record(exact::cross(to_piece, side) / turn);
    return;
  }
  if (exact::cross(end.direction, to_piece) != 0)
    return;
  const Rational square = end.direction.squared_length();
  record(to_piece * end.direction / square);
  record((piece.to - end.place) * end.direction / square);
}

// Records where the prolongations of two loose ends meet. Returns false if they do not,
// or if the point is too far from one of them.
bool meet(End& a, End& b, const Rational& reach) {
  const Rational turn = exact::cross(a.direction, b.direction);
  if (turn == 0)
    return false;
  const Rational s = exact::cross(b.place - a.place, b.direction) / turn;
  const Rational t = exact::cross(b.place - a.place, a.direction) / turn;
  if (s <= 0 || t <= 0 || !a.reaches(s, reach) || !b.reaches(t, reach))
    return false;
  a.hit = a.hit ? std::min(*a.hit, s) : s;
  b.hit = b.hit ? std::min(*b.hit, t) : t;
  return true;
}

// Lets ends that reach no joint meet each other. A point counts if it is the first one
// for both, so that the order of the ends has no effect.
void meet_each_other(std::vector<End>& ends, const std::vector<exact::Box>& probes,
                     const Rational& reach, StepProgress& progress) {
  std::vector<exact::Box> left;
  for (const exact::Box& probe : probes)
    if (ends[probe.info()].dangles && !ends[probe.info()].hit)
      left.push_back(probe);
  std::vector<std::array<std::size_t, 2>> pairs;
  CGAL::box_self_intersection_d(left.begin(), left.end(),
                                [&](const exact::Box& a, const exact::Box& b) {
                                  progress.count(0, 1);
                                  if (meet(ends[a.info()], ends[b.info()], reach))
                                    pairs.push_back({a.info(), b.info()});
                                });
  std::vector<bool> is_joined(ends.size(), false);
  for (const auto& [a, b] : pairs)
    if (ends[a].target() == ends[b].target())
      is_joined[a] = is_joined[b] = true;
  for (const exact::Box& probe : left)
    if (!is_joined[probe.info()])
      ends[probe.info()].hit.reset();
}

bool is_inside(const std::vector<Point>& outline, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        (exact::cross(a - p, b - p) > 0) == (b.y() > a.y()))
      inside = !inside;
  }
  return inside;
}

}  // namespace

Prolongation prolonged(const std::vector<JointSegment>& traces, const Decimal& snap,
                       const std::vector<JointSegment>& others,
                       const std::vector<DecimalPoint>& outline,
                       const ProgressFunction& progress) {
  const RoundToNearest mode;
  Prolongation result;
  result.traces = traces;
  const Rational reach = exact::rational(snap);
  if (reach <= 0)
    return result;
  StepProgress reading(progress, "prolong traces", 0.0, 0.3);
  std::vector<Piece> pieces;
  for (const auto* joints : {&traces, &others})
    for (const JointSegment& joint : *joints) {
      reading.count(0, 1);
      pieces.push_back({exact::point_of(joint.from), exact::point_of(joint.to)});
    }
  std::vector<Point> corners;
  for (const DecimalPoint& corner : outline)
    corners.push_back(exact::rational(corner));
  for (std::size_t i = 0; i < corners.size(); ++i)
    pieces.push_back({corners[i], corners[(i + 1) % corners.size()]});
  // An end inside meets the outline within the width and height of its box.
  const auto [left, right] =
      std::minmax_element(corners.begin(), corners.end(),
                          [](const Point& p, const Point& q) { return p.x() < q.x(); });
  const auto [low, high] =
      std::minmax_element(corners.begin(), corners.end(),
                          [](const Point& p, const Point& q) { return p.y() < q.y(); });
  const Rational probed =
      std::min<Rational>(reach, right->x() - left->x() + high->y() - low->y());

  std::vector<End> ends;
  std::vector<exact::Box> probes, boxes;
  for (std::size_t i = 0; i < traces.size(); ++i)
    for (const bool at_to : {false, true}) {
      reading.count(i, traces.size());
      const Point& place = at_to ? pieces[i].to : pieces[i].from;
      const Point& back = at_to ? pieces[i].from : pieces[i].to;
      if (place == back)
        continue;
      const Vector direction = place - back;
      // Not less than the parameter at the reach; the hit is compared exactly.
      const Rational far =
          probed / std::max<Rational>(abs(direction.x()), abs(direction.y()));
      probes.push_back(box_of(place, place + direction * far, ends.size()));
      ends.push_back({i, at_to, place, direction, true, {}});
    }
  for (std::size_t i = 0; i < pieces.size(); ++i)
    boxes.push_back(box_of(pieces[i].from, pieces[i].to, i));
  StepProgress meeting(progress, "prolong traces", 0.3, 1.0);
  CGAL::box_intersection_d(probes.begin(), probes.end(), boxes.begin(), boxes.end(),
                           [&](const exact::Box& probe, const exact::Box& box) {
                             meeting.count(0, 1);
                             End& end = ends[probe.info()];
                             if (box.info() == end.trace || !end.dangles)
                               return;
                             const Piece& piece = pieces[box.info()];
                             if (contains(piece, end.place))
                               end.dangles = false;
                             else
                               meet(piece, end);
                           });
  for (End& end : ends) {
    meeting.count(1, 1);
    end.dangles = end.dangles && is_inside(corners, end.place);
    result.loose += end.dangles ? 1 : 0;
    if (end.hit && !end.reaches(*end.hit, reach))
      end.hit.reset();
  }
  meet_each_other(ends, probes, reach, meeting);
  for (const End& end : ends) {
    if (!end.dangles || !end.hit)
      continue;
    JointSegment& trace = result.traces[end.trace];
    (end.at_to ? trace.to : trace.from) = exact::exact_point(end.target());
    ++result.ends;
    const double length =
        exact::nearest(*end.hit) * std::hypot(exact::nearest(end.direction.x()),
                                              exact::nearest(end.direction.y()));
    const Vec2 place = exact::nearest(end.place);
    if (result.ends == 1 ||
        std::tuple(length, place.x(), place.y()) >
            std::tuple(result.largest, result.place.x(), result.place.y())) {
      result.largest = length;
      result.place = place;
    }
  }
  return result;
}

}  // namespace blocks::geometry
