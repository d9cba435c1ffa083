// PRIVATE to geometry/: lines with integer coefficients, and points as their
// intersections. They need no common divisors, so they are faster than rationals.
#pragma once

#include <gmp.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/exact/shared_point.hpp"
#include "geometry/exact/whole.hpp"

namespace blocks::geometry::exact {

/// The line a x + b y + c = 0, without common divisors; (b, -a) is its direction. A
/// view, valid as long as its Lines do not change.
struct Line {
  mpz_t a, b, c;  ///< read only; nothing is to be cleared
};

/// Lines in few blocks of memory.
class Lines {
 public:
  void reserve(std::size_t count) { entries_.reserve(count); }
  /// Appends the line through two different points, in the direction from p to q.
  void add(const ExactPoint& p, const ExactPoint& q);
  std::size_t size() const { return entries_.size(); }
  Line operator[](std::size_t i) const;
  /// Returns the sign of (direction of i) x (direction of j): positive if j is turned
  /// to the left from i. Usually takes no exact numbers.
  int turn(std::size_t i, std::size_t j) const;
  bool are_parallel(std::size_t i, std::size_t j) const { return turn(i, j) == 0; }
  /// Whether the coefficients are the same. Lines through the same points in the same
  /// order have the same coefficients.
  bool are_equal(std::size_t i, std::size_t j) const;
  /// Returns a number that is the same for equal lines.
  std::uint64_t hash(std::size_t i) const;

 private:
  struct Entry {
    std::size_t begin;      ///< of its limbs
    std::int32_t sizes[3];  ///< numbers of limbs, with the signs of a, b, c
    double run, rise;       ///< direction, scaled to about 1, to 51 bits or more
  };
  std::size_t end_of(std::size_t i) const {
    return i + 1 < entries_.size() ? entries_[i + 1].begin : limbs_.size();
  }
  std::vector<Entry> entries_;
  std::vector<mp_limb_t> limbs_;
};

/// A point x / w, y / w with w > 0, which keeps its memory.
class Place {
 public:
  void set(const ExactPoint& p);
  /// Sets the intersection of two lines that are not parallel.
  void set(const Line& s, const Line& t);
  /// The nearest doubles, [L].
  Vec2 nearest() const;
  Point reduced() const;

  Whole x, y, w;

 private:
  Whole rest_;
};

/// Compares x, then y; negative if p is before q.
int compare(const Place& p, const Place& q);

/// Returns 1 if the point is on the left of the line, -1 on its right, 0 on it.
int side_of(const Line& line, const Place& p);

}  // namespace blocks::geometry::exact
