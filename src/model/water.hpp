// Water at rest that presses on the sides of blocks: WATER and JWATER (docs/water.md).
#pragma once

#include <vector>

#include "model/blocks.hpp"

namespace blocks {

/// WATER: a table as a function of the horizontal place, linear between its points and
/// level beyond them. While it rises or falls, its levels change linearly in time.
struct WaterTable {
  double gamma = 0.0;          ///< [F/L^3] weight of the water, > 0 if there are points
  geometry::Vec2 up = {0, 1};  ///< unit vector against gravity
  std::vector<double> place;   ///< [L] horizontal places, increasing; empty: no water
  std::vector<double> from, to;  ///< [L] levels along `up` before and after the change
  double begin = 0.0, duration = 0.0;  ///< [T] of the change
  bool drains = false;                 ///< after the change there is no water

  bool none() const { return place.empty(); }
  /// Returns the unit vector to the right, normal to `up`.
  geometry::Vec2 across() const { return {up.y(), -up.x()}; }
  /// Returns the part of the change that has passed, 0 to 1.
  double passed(double time) const;
};

/// JWATER: a pressure between two points that acts on the sides of a joint id in place
/// of the table. Without pressures the sides are dry. While it rises, the table's
/// pressure on these sides falls.
struct JointWater {
  int joint = 0;                          ///< joint id; 0: sides without one
  geometry::Vec2 a = {0, 0}, b = {0, 0};  ///< [L]
  double p1 = 0.0, p2 = 0.0;              ///< [F/L^2] at a and b, linear between them
  double reach = 0.0;  ///< [L] the distance from the line up to which it acts
  double begin = 0.0, duration = 0.0;  ///< [T] in which it takes the table's place

  /// Returns the part of the change that has passed, 0 to 1.
  double passed(double time) const;
  bool is_dry() const { return p1 == 0.0 && p2 == 0.0; }
};

struct Water {
  WaterTable table;
  std::vector<JointWater> joints;  ///< in the order of the cards

  bool none() const { return table.none() && joints.empty(); }
  /// Returns whether sides with this joint id have a pressure of their own.
  bool has_own(int joint) const;
  /// Returns whether block b has such sides.
  bool has_own(const Blocks& blocks, int b) const;
  /// Returns whether levels or pressures change after this time.
  bool will_change(double time) const;
};

/// A part of a side on which the pressure is linear, from p0 at t0 to p1 at t1.
struct WetPart {
  double t0, t1;  ///< 0 at the first corner of the side, 1 at the last
  double p0, p1;  ///< [F/L^2] >= 0
};

/// The integrals of a pressure p over a side, as the loads at its ends: of p (1 - t)
/// and of p t over t from 0 to 1, [F/L^2]. The force at an end is its load times the
/// inward normal of the length of the side.
struct EndLoads {
  double first = 0.0, second = 0.0;
};

/// The resultant of the water on one block.
struct BlockWater {
  geometry::Vec2 force = {0, 0};          ///< [F]
  double moment = 0.0;                    ///< [F L] about the centroid, anticlockwise
  double sums[4] = {0.0, 0.0, 0.0, 0.0};  ///< [F L] f_i x_j of (9): xx, xy, yx, yy
  bool acts = false;
};

/// The water at one time. It never allocates. It refers to the water, which has to live
/// as long. Each thread needs its own.
class WaterNow {
 public:
  WaterNow(const Water& water, double time);

  /// Returns the level of the table at a horizontal place, [L]. It must have points.
  double level_at(double s) const;
  /// Returns whether there is a table at this time.
  bool has_table() const { return has_table_; }
  /// Calls visit(t0, p0, t1, p1) for each part of the side from a to b on which the
  /// pressure is linear and above 0: from p0 at t0 to p1 at t1, where t runs from 0 at
  /// a to 1 at b. Where parts of several cards lie on each other, their pressures add
  /// up.
  template <class Visit>
  void each_part(const geometry::Vec2& a, const geometry::Vec2& b, int joint,
                 const Visit& visit) const;
  /// Appends these parts to a list.
  void add_parts(const geometry::Vec2& a, const geometry::Vec2& b, int joint,
                 std::vector<WetPart>& parts) const;
  /// Integrates the pressure on the side from a to b exactly.
  EndLoads on_side(const geometry::Vec2& a, const geometry::Vec2& b, int joint) const;
  /// Returns the resultant on block b. If its sides carry the table's pressure and lie
  /// under one straight part of it, that follows from the area (docs/water.md#blocks).
  BlockWater on_block(const Blocks& blocks, int b);
  /// Sets forces to the resultant on each block, (2, n) [F]; 0 for removed ones.
  void forces_on(const Blocks& blocks, Eigen::Matrix2Xd& forces);

 private:
  /// A straight part of the table between two horizontal places. The pressure below it
  /// is gradient . (x - point), where the point is on the table.
  struct Part {
    double left = 1.0, right = 0.0;  ///< [L] without places at first
    geometry::Vec2 point = {0, 0}, gradient = {0, 0};
    double slope = 0.0;

    double pressure(const geometry::Vec2& at) const { return gradient.dot(at - point); }
  };
  std::size_t part_at(double s) const;
  Part part(std::size_t k) const;
  double level(std::size_t k) const;
  /// The same as each_part() for the table, its pressures times a weight.
  template <class Visit>
  void each_table_part(const geometry::Vec2& a, const geometry::Vec2& b, double weight,
                       const Visit& visit) const;
  bool under_one_part(const Blocks& blocks, int b, BlockWater& result);

  const Water& water_;
  double time_, passed_;
  bool has_table_;
  geometry::Vec2 across_;
  Part last_;  ///< over the block before, which is usually that of the next one
};

}  // namespace blocks
