// Every variant of the contact decision that `blocks study contacts` compares, as
// policies of dynamics::ContactDecision. The time loop knows nothing of them.
#pragma once

#include <cmath>

#include "dynamics/contact_decision.hpp"
#include "dynamics/motion.hpp"
#include "study/lists.hpp"
#include "study/scene.hpp"

namespace blocks::study {

/// Where an edge begins and ends.
enum class Ends {
  strict,     ///< a corner on the limit is out
  inclusive,  ///< a corner on the limit is in
  slack       ///< in up to 1e-6 of the edge's length beyond
};

/// Twice the area of (19) as printed, in absolute coordinates.
struct PrintedArea {
  using Number = double;
  static double twice(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    return p1.x() * c.y() + c.x() * p2.y() + p2.x() * p1.y() - p1.y() * c.x() -
           c.y() * p2.x() - p2.y() * p1.x();
  }
};

/// (19) on differences to the edge's first corner.
template <class Float> struct TranslatedArea {
  using Number = Float;
  static Float twice(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Float x1 = p1.x(), y1 = p1.y();
    return (c.x() - x1) * (p2.y() - y1) - (c.y() - y1) * (p2.x() - x1);
  }
};

/// Signs as a plain program takes them: whatever the rounded numbers say.
template <class Area, Ends ends> struct PlainSigns {
  using Number = typename Area::Number;
  struct Vector {
    Number x, y;
    Vector(const Vec2& from, const Vec2& to)
        : x(Number(to.x()) - from.x()), y(Number(to.y()) - from.y()) {}
    Number dot(const Vector& o) const { return x * o.x + y * o.y; }
    Number cross(const Vector& o) const { return x * o.y - y * o.x; }
  };
  static bool in(Number distance, Number slack) {
    return ends == Ends::strict      ? distance > 0
           : ends == Ends::inclusive ? distance >= 0
                                     : distance + slack >= 0;
  }

  static int overlap_sign(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Number area = Area::twice(c, p1, p2);
    return int{area > 0} - int{area < 0};
  }
  static bool inside_edge(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Vector e(p1, p2);
    return in(Area::twice(c, p1, p2), Number(geometry::contact_slack) * e.dot(e));
  }
  static bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                           const Vec2& p2) {
    return Vector(centroid, c).cross(Vector(p1, p2)) <= 0;
  }
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    const Vector e(p1, p2);
    const Number along = Vector(p1, c).dot(e), square = e.dot(e);
    const Number slack = Number(geometry::contact_slack) * square;
    return in(along, slack) && in(square - along, slack);
  }
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    const Vector e(p1, p2), t(c, neighbour);
    const Number sine = e.cross(t) / (std::sqrt(e.dot(e)) * std::sqrt(t.dot(t)));
    return sine >= -std::sin(Number(10) * std::acos(Number(-1)) / 180);
  }
  static int compare_depth(const Vec2& c, const Vec2& p1, const Vec2& p2,
                           const Vec2& q1, const Vec2& q2) {
    const Vector p(p1, p2), q(q1, q2);
    const Number depth = Area::twice(c, p1, p2) / std::sqrt(p.dot(p));
    const Number other = Area::twice(c, q1, q2) / std::sqrt(q.dot(q));
    return int{depth > other} - int{depth < other};
  }
};

/// The same questions answered exactly for the stored doubles.
template <Ends ends> struct ExactSigns : dynamics::ExactRules {
  /// Sign of (c - o).(p2 - p1): within_depth asks for that of (c - o) x (p2 - p1), and
  /// turning p1 and p2 by a right angle is exact.
  static bool not_before(const Vec2& c, const Vec2& o, const Vec2& p1, const Vec2& p2) {
    return geometry::within_depth(c, o, {-p2.y(), p2.x()}, {-p1.y(), p1.x()});
  }
  static bool inside_edge(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    if constexpr (ends == Ends::slack)
      return geometry::near_or_inside(c, p1, p2);
    const int sign = geometry::overlap_sign(c, p1, p2);
    return ends == Ends::strict ? sign > 0 : sign >= 0;
  }
  static bool between(const Vec2& c, const Vec2& p1, const Vec2& p2) {
    if constexpr (ends == Ends::slack)
      return geometry::between(c, p1, p2);
    else if constexpr (ends == Ends::inclusive)
      return not_before(c, p1, p1, p2) && not_before(c, p2, p2, p1);
    else
      return !not_before(c, p1, p2, p1) && !not_before(c, p2, p1, p2);
  }
};

/// Which of the rules are in force. As it stands: ours.
struct Use {
  bool whole_block = true;  ///< "between" of a convex block as a whole, not of the edge
  bool far_edges_meet = true;  ///< an edge not the nearest meets the corner's block
  bool facing = true;          ///< (20)
  bool nearest_edge = true;    ///< of a block's edges only the nearest acts
  bool depth = true;           ///< not deeper than the centroid
  bool shield = true;
  bool hands_over = true;
  List list = List::reach;
};

/// What a program of 1982 had: neither nearest edge nor depth nor the rest of ours.
inline constexpr Use report_rules = {.whole_block = false,
                                     .far_edges_meet = false,
                                     .facing = true,
                                     .nearest_edge = false,
                                     .depth = false,
                                     .shield = false,
                                     .hands_over = false,
                                     .list = List::near};

template <class Signs, Use use> struct VariantRules : Signs {
  static constexpr bool whole_block = use.whole_block;
  static constexpr bool far_edges_meet = use.far_edges_meet;
  static constexpr bool shield = use.shield && use.nearest_edge;
  static constexpr bool hands_over = use.hands_over;
  static constexpr bool keeps_decisions = false;

  static bool within_depth(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                           const Vec2& p2) {
    return !use.depth || Signs::within_depth(c, centroid, p1, p2);
  }
  static bool in_reach_of_edge(const Vec2& c, const Vec2& centroid, const Vec2& p1,
                               const Vec2& p2) {
    return Signs::inside_edge(c, p1, p2) && Signs::between(c, p1, p2) &&
           within_depth(c, centroid, p1, p2);
  }
  static bool faces_edge(const Vec2& c, const Vec2& neighbour, const Vec2& p1,
                         const Vec2& p2) {
    return !use.facing || Signs::faces_edge(c, neighbour, p1, p2);
  }
};

/// Answers asked and answers that differ from exact arithmetic.
struct SignTally {
  long areas = 0, wrong_areas = 0;        ///< signs of (19)
  long tangents = 0, wrong_tangents = 0;  ///< (20)
};

/// One variant, callable.
struct Variant {
  std::string_view name, what;
  Corners corners;
  /// Brings list and groups up to date.
  void (*find)(Model&, dynamics::SearchBuffers&);
  /// Contact forces by the variant's rules, and the rest of the step.
  dynamics::Displacement (*step)(Model&, dynamics::SearchBuffers&);
  /// Every record of the list, judged by exact arithmetic without the filters.
  void (*judge_signs)(const Model&, SignTally&);
};

/// In the order of the tables; the first is the rules of every run.
const std::vector<Variant>& all_variants();

/// Null when there is none of that name.
const Variant* find_variant(std::string_view name);

}  // namespace blocks::study
