#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/exact/segment_boxes.hpp"
#include "geometry/exact/shared_point.hpp"
#include "geometry/joint_sources.hpp"
#include "geometry/numeric_environment.hpp"

namespace blocks::geometry {
namespace {

using exact::Enclosure;
using exact::Interval;
using exact::Point;
using exact::Rational;
using exact::RoundToNearestAgain;
using exact::RoundUpwards;
using exact::Vector;

// An end of a trace, which may be prolonged along the trace. Its parameter is the
// prolongation over the length of the trace.
struct End {
  End(std::size_t number, bool is_last) : trace(number), at_to(is_last) {}
  std::size_t trace;
  bool at_to;
  bool dangles = true;
  bool is_open = true;               ///< a nearer piece may still be found
  std::optional<std::size_t> piece;  ///< the first one that the prolonged end meets
  Interval at = 0.0;                 ///< encloses the parameter there
};

bool contains(const Point& from, const Point& to, const Point& p) {
  return exact::cross(to - from, p - from) == 0 &&
         CGAL::collinear_are_ordered_along_line(from, p, to);
}

// Returns the least parameter > 0 at which the prolonged end meets the piece.
std::optional<Rational> meet(const Point& from, const Point& to, const Point& end,
                             const Vector& direction) {
  std::optional<Rational> hit;
  const auto record = [&hit](const Rational& s) {
    if (s > 0 && (!hit || s < *hit))
      hit = s;
  };
  const Vector side = to - from, to_piece = from - end;
  const Rational turn = exact::cross(direction, side);
  if (turn != 0) {
    const Rational along = exact::cross(to_piece, direction) / turn;
    if (along >= 0 && along <= 1)
      record(exact::cross(to_piece, side) / turn);
  } else if (exact::cross(direction, to_piece) == 0) {
    const Rational square = direction.squared_length();
    record(to_piece * direction / square);
    record((to - end) * direction / square);
  }
  return hit;
}

// An end that is prolonged, by a parameter > 0.
struct Hit {
  std::size_t end = 0;
  Rational at;
};

// Whether two loose ends, prolonged by at most the reach, meet in a point, and its
// parameters.
std::optional<std::array<Rational, 2>> meet(const Point& a, const Vector& along_a,
                                            const Point& b, const Vector& along_b,
                                            const Rational& reach) {
  const Rational turn = exact::cross(along_a, along_b);
  if (turn == 0)
    return {};
  const Rational s = exact::cross(b - a, along_b) / turn;
  const Rational t = exact::cross(b - a, along_a) / turn;
  const Rational square = reach * reach;
  if (s <= 0 || t <= 0 || s * s * along_a.squared_length() > square ||
      t * t * along_b.squared_length() > square)
    return {};
  return std::array<Rational, 2>{s, t};
}

class Prolonger {
 public:
  Prolonger(const std::vector<JointSegment>& traces, const Decimal& snap,
            const std::vector<JointSegment>& others,
            const std::vector<DecimalPoint>& outline)
      : traces_(traces), others_(others), reach_(exact::rational(snap)) {
    for (std::size_t i = 0; i < outline.size(); ++i)
      sides_.push_back({outline[i], outline[(i + 1) % outline.size()]});
  }

  Prolongation run(const ProgressFunction& progress) {
    Prolongation result;
    result.traces = traces_;
    if (reach_ <= 0 || traces_.empty() || sides_.empty())
      return result;
    StepProgress reading(progress, "prolong traces", 0.0, 0.2);
    prepare(reading);
    StepProgress meeting(progress, "prolong traces", 0.2, 0.8);
    // Most ends meet a piece soon, so the probes are short at first.
    for (double begin = 0.0, end = step_; begin < probed_; begin = end, end *= 4.0)
      probe(begin, std::min(end, probed_), meeting);
    StepProgress moving(progress, "prolong traces", 0.8, 1.0);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      moving.count(i, ends_.size());
      if (!ends_[i].dangles || !is_inside(place(ends_[i])))
        continue;
      ++result.loose;
      if (const auto at = first_hit(ends_[i]))
        move({i, *at}, result);
      else
        left.push_back(i);
    }
    for (const Hit& hit : common_points(left, moving))
      move(hit, result);
    return result;
  }

 private:
  const JointSegment& piece(std::size_t i) const {
    return i < traces_.size() ? traces_[i]
           : i < traces_.size() + others_.size()
               ? others_[i - traces_.size()]
               : sides_[i - traces_.size() - others_.size()];
  }
  std::size_t pieces() const { return traces_.size() + others_.size() + sides_.size(); }
  const ExactPoint& place(const End& end) const {
    return end.at_to ? traces_[end.trace].to : traces_[end.trace].from;
  }
  const ExactPoint& back(const End& end) const {
    return end.at_to ? traces_[end.trace].from : traces_[end.trace].to;
  }
  Point exact_place(const End& end) const { return exact::point_of(place(end)); }
  Vector exact_direction(const End& end) const {
    return exact_place(end) - exact::point_of(back(end));
  }

  void prepare(StepProgress& progress) {
    Vec2 low = sides_[0].from.nearest(), high = low;
    for (const JointSegment& side : sides_) {
      low = low.cwiseMin(side.from.nearest());
      high = high.cwiseMax(side.from.nearest());
    }
    for (std::size_t i = 0; i < traces_.size(); ++i)
      for (const bool at_to : {false, true}) {
        progress.count(0, 1);
        const Vec2& p = (at_to ? traces_[i].to : traces_[i].from).nearest();
        const bool may_be_inside =
            (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
        if (may_be_inside && exact::compare(traces_[i].from, traces_[i].to) != 0)
          ends_.emplace_back(i, at_to);
      }
    const RoundUpwards upwards;
    // An end inside meets the outline within the width and height of its box.
    const double size = (high - low).sum();
    probed_ = std::min(exact::rounded_towards(reach_, 1), 2.0 * size);
    const auto count = static_cast<double>(pieces());
    step_ = std::min(size / std::sqrt(count), probed_);
    double sum = 0.0;
    for (std::size_t i = 0; i < pieces(); ++i) {
      progress.count(0, 1);
      sum += std::min((piece(i).to.nearest() - piece(i).from.nearest()).norm(), size);
    }
    const double longest = std::max(4.0 * step_, sum / count);
    // What an end inside meets first is in the box of the outline.
    for (std::size_t i = 0; i < pieces(); ++i) {
      progress.count(1, 1);
      exact::add_boxes(piece(i).from, piece(i).to, low, high, longest, i, boxes_);
    }
  }

  // Finds what open ends meet at distances from `begin` to `end`, [L], where a distance
  // is the larger component.
  void probe(double begin, double end, StepProgress& progress) {
    std::vector<exact::Box> probes;
    {
      const RoundUpwards upwards;
      for (std::size_t i = 0; i < ends_.size(); ++i)
        if (ends_[i].is_open) {
          progress.count(0, 1);
          add_boxes(exact::enclosure(place(ends_[i])), direction(ends_[i]), begin, end,
                    step_, i, probes);
        }
    }
    if (probes.empty())
      return;
    CGAL::box_intersection_d(probes.begin(), probes.end(), boxes_.begin(), boxes_.end(),
                             [&](const exact::Box& probe, const exact::Box& box) {
                               progress.count(0, 1);
                               End& one = ends_[probe.info()];
                               if (box.info() != one.trace && one.dangles)
                                 test(box.info(), one);
                             });
    const RoundUpwards upwards;
    for (End& one : ends_)
      if (one.is_open) {
        progress.count(0, 1);
        // What lies behind the first piece is of no interest.
        one.is_open = one.dangles && !(one.piece && distance(one).sup() <= end);
      }
  }

  // The direction of an end, whose larger component is about 1.
  Enclosure direction(const End& end) const {
    const Enclosure d = exact::enclosure(place(end)) - exact::enclosure(back(end));
    const Interval largest = CGAL::max(CGAL::abs(d.x), CGAL::abs(d.y));
    if (largest.inf() > 0.0)
      return {d.x / largest, d.y / largest};
    const Vector v = exact_direction(end);  // of a trace that doubles cannot tell
    const Rational length = std::max<Rational>(abs(v.x()), abs(v.y()));
    return exact::around(
        Vec2(exact::nearest(v.x() / length), exact::nearest(v.y() / length)));
  }
  // Encloses the distance of the first piece, as in probe().
  Interval distance(const End& end) const {
    const Enclosure d = exact::enclosure(place(end)) - exact::enclosure(back(end));
    return end.at * CGAL::max(CGAL::abs(d.x), CGAL::abs(d.y));
  }

  void test(std::size_t number, End& end) {
    const RoundUpwards upwards;
    const JointSegment& joint = piece(number);
    const Enclosure p = exact::enclosure(place(end)),
                    along = p - exact::enclosure(back(end)),
                    from = exact::enclosure(joint.from) - p,
                    to = exact::enclosure(joint.to) - p;
    const Interval left = exact::cross(along, from), right = exact::cross(along, to);
    const auto side = exact::certain_sign(left), other = exact::certain_sign(right);
    if (side && other && *side * *other > 0)
      return;
    if (side && other && *side * *other < 0) {
      const Interval at = exact::cross(from, to) / (right - left);
      if (at.sup() < 0.0)
        return;
      if (at.inf() > 0.0)
        return consider(number, at, end);
    }
    const Point a = exact::point_of(joint.from), b = exact::point_of(joint.to);
    if (contains(a, b, exact_place(end)))
      end.dangles = false;
    else if (const auto hit = meet(a, b, exact_place(end), exact_direction(end)))
      consider(number, exact::around(exact::nearest(*hit)), end);
  }

  Rational parameter(std::size_t number, const End& end) const {
    return *meet(exact::point_of(piece(number).from), exact::point_of(piece(number).to),
                 exact_place(end), exact_direction(end));
  }
  void consider(std::size_t number, const Interval& at, End& end) const {
    if (end.piece && at.inf() > end.at.sup())
      return;
    if (end.piece && at.sup() >= end.at.inf() &&
        (*end.piece == number || parameter(*end.piece, end) <= parameter(number, end)))
      return;
    end.piece = number;
    end.at = at;
  }

  bool is_inside(const ExactPoint& p) const {
    const RoundUpwards upwards;
    const auto is_above = [&p](const ExactPoint& corner) {
      if (corner.nearest().y() != p.nearest().y())
        return corner.nearest().y() > p.nearest().y();
      return exact::point_of(corner).y() > exact::point_of(p).y();
    };
    bool inside = false;
    for (const JointSegment& side : sides_) {
      const bool rises = is_above(side.to);
      if (is_above(side.from) == rises)
        continue;
      const Enclosure at = exact::enclosure(p);
      auto turn = exact::certain_sign(exact::cross(exact::enclosure(side.from) - at,
                                                   exact::enclosure(side.to) - at));
      if (!turn) {
        const Point place = exact::point_of(p);
        turn = static_cast<int>(CGAL::sign(exact::cross(
            exact::point_of(side.from) - place, exact::point_of(side.to) - place)));
      }
      if ((*turn > 0) == rises)
        inside = !inside;
    }
    return inside;
  }

  // Returns where the end meets a piece, if that is near enough.
  std::optional<Rational> first_hit(const End& end) const {
    if (!end.piece)
      return {};
    const Rational hit = parameter(*end.piece, end);
    return hit * hit * exact_direction(end).squared_length() <= reach_ * reach_
               ? std::optional(hit)
               : std::nullopt;
  }

  // Lets ends that reach no joint meet each other. A point counts if it is the first
  // one for both, so that the order of the ends has no effect.
  std::vector<Hit> common_points(const std::vector<std::size_t>& left,
                                 StepProgress& progress) const {
    std::vector<exact::Box> probes;
    {
      const RoundUpwards upwards;
      for (const std::size_t i : left) {
        progress.count(0, 1);
        add_boxes(exact::enclosure(place(ends_[i])), direction(ends_[i]), 0.0, probed_,
                  step_, i, probes);
      }
    }
    std::vector<std::array<std::size_t, 2>> near;
    CGAL::box_self_intersection_d(probes.begin(), probes.end(),
                                  [&](const exact::Box& a, const exact::Box& b) {
                                    progress.count(0, 1);
                                    if (a.info() != b.info())
                                      near.push_back({std::min(a.info(), b.info()),
                                                      std::max(a.info(), b.info())});
                                  });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::map<std::size_t, Rational> first;
    std::vector<std::pair<Hit, Hit>> meetings;
    for (const auto& [a, b] : near) {
      progress.count(0, 1);
      const auto at = meet(exact_place(ends_[a]), exact_direction(ends_[a]),
                           exact_place(ends_[b]), exact_direction(ends_[b]), reach_);
      if (!at)
        continue;
      meetings.push_back({{a, (*at)[0]}, {b, (*at)[1]}});
      for (const Hit& hit : {meetings.back().first, meetings.back().second})
        if (const auto [known, is_new] = first.emplace(hit.end, hit.at);
            !is_new && hit.at < known->second)
          known->second = hit.at;
    }
    std::map<std::size_t, Rational> found;
    for (const auto& [a, b] : meetings)
      if (first.at(a.end) == a.at && first.at(b.end) == b.at) {
        found.emplace(a.end, a.at);
        found.emplace(b.end, b.at);
      }
    std::vector<Hit> hits;
    for (auto& [end, at] : found)
      hits.push_back({end, std::move(at)});
    return hits;
  }

  void move(const Hit& hit, Prolongation& result) const {
    const End& end = ends_[hit.end];
    const Vector direction = exact_direction(end);
    JointSegment& trace = result.traces[end.trace];
    (end.at_to ? trace.to : trace.from) =
        exact::exact_point(exact_place(end) + direction * hit.at);
    ++result.ends;
    const double length =
        exact::nearest(hit.at) *
        std::hypot(exact::nearest(direction.x()), exact::nearest(direction.y()));
    const Vec2& from = place(end).nearest();
    if (result.ends == 1 ||
        std::tuple(length, from.x(), from.y()) >
            std::tuple(result.largest, result.place.x(), result.place.y())) {
      result.largest = length;
      result.place = from;
    }
  }

  const std::vector<JointSegment>&traces_, &others_;
  std::vector<JointSegment> sides_;  ///< of the outline
  Rational reach_;                   ///< [L]
  double probed_ = 0.0;              ///< [L] largest distance of a piece
  double step_ = 0.0;                ///< [L] size of the boxes of probes
  std::vector<End> ends_;
  std::vector<exact::Box> boxes_;  ///< of the pieces
};

}  // namespace

Prolongation prolonged(const std::vector<JointSegment>& traces, const Decimal& snap,
                       const std::vector<JointSegment>& others,
                       const std::vector<DecimalPoint>& outline,
                       const ProgressFunction& progress) {
  const RoundToNearest mode;
  return Prolonger(traces, snap, others, outline).run(progress);
}

}  // namespace blocks::geometry
