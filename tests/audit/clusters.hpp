// Random clusters of two to five blocks, of kinds that are difficult for a contact
// rule.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "model/blocks.hpp"

namespace blocks::testing {

/// Generates clusters from a seed.
class Clusters {
 public:
  explicit Clusters(std::uint64_t seed) : random_(seed) {}

  static constexpr int kinds = 13;
  /// Returns blocks of one kind, in half of the cases in a turned frame.
  std::vector<NewBlock> make(int kind) {
    outlines_.clear();
    switch (kind) {
    case 0:
      lattice_polygons();
      break;
    case 1:
      smooth_polygons();
      break;
    case 2:
      reentrant();
      break;
    case 3:
      wall();
      break;
    case 4:
      block_over_joint();
      break;
    case 5:
      near_ten_degrees();
      break;
    case 6:
      rising_surface();
      break;
    case 7:
      flush_bricks();
      break;
    case 8:
      reentrant_over_joint();
      break;
    case 9:
      wedges();
      break;
    case 10:
      prongs();
      break;
    case 11:
      notch();
      break;
    default:
      pieces();
      break;
    }
    return in_frame();
  }
  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  int whole(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool one_in(int n) { return whole(n) == 0; }

 private:
  using Polygon = geometry::Polygon;

  void add(Polygon outline) {
    if (one_in(5))
      outline = with_straight_corner(outline);
    if (clockwise_area(outline) > 1e-9)
      outlines_.push_back(std::move(outline));
  }
  /// Splits one side into two or three sides in line.
  Polygon with_straight_corner(Polygon outline) {
    const std::size_t i =
        static_cast<std::size_t>(whole(static_cast<int>(outline.size())));
    const Vec2 from = outline[i], to = outline[(i + 1) % outline.size()];
    const double place = one_in(2) ? 0.5 : uniform(0.1, 0.9);
    std::vector<Vec2> between = {from + place * (to - from)};
    if (one_in(3))
      between.push_back(between[0] + 0.25 * (to - between[0]));
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   between.begin(), between.end());
    return outline;
  }
  void box(double x, double y, double w, double h) {
    add({{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}});
  }
  static double clockwise_area(const Polygon& outline) {
    double area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
      area += 0.5 * (q.x() * p.y() - p.x() * q.y());
    }
    return area;
  }
  /// Returns the convex hull of points, clockwise and without straight corners.
  static Polygon hull(Polygon points) {
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
      return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    };
    std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
      return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    Polygon found;
    for (int half = 0; half < 2; ++half) {
      const std::size_t begin = found.size();
      for (const Vec2& p : points) {
        while (found.size() >= begin + 2 &&
               turn(found[found.size() - 2], found.back(), p) >= 0.0)
          found.pop_back();
        found.push_back(p);
      }
      found.pop_back();
      std::reverse(points.begin(), points.end());
    }
    return found;
  }
  /// Returns zero, or a number of either sign with a magnitude from 1e-12 to 0.1.
  double small() {
    if (one_in(4))
      return 0.0;
    return (one_in(2) ? 1.0 : -1.0) * std::pow(10.0, uniform(-12.0, -1.0));
  }
  /// Returns an overlap of blocks, in some cases a multiple of a power of two for exact
  /// ties.
  double overlap() {
    return one_in(3) ? 0.0625 * whole(5) : std::pow(10.0, uniform(-7.0, -0.6));
  }
  Polygon turned(const Polygon& outline, double angle, const Vec2& about) {
    Polygon found;
    const double c = std::cos(angle), s = std::sin(angle);
    for (const Vec2& p : outline) {
      const Vec2 arm = p - about;
      found.push_back(about +
                      Vec2(c * arm.x() - s * arm.y(), s * arm.x() + c * arm.y()));
    }
    return found;
  }
  Polygon regular(const Vec2& centre) {
    const int n = 3 + whole(5);
    const double squeeze = one_in(3) ? 0.2 : 1.0, phase = uniform(0.0, 6.3);
    const double radius = uniform(0.4, 1.2);
    Polygon found;
    for (int k = 0; k < n; ++k) {
      const double angle = phase - 6.283185307179586 * (k + uniform(-0.3, 0.3)) / n;
      found.push_back(centre +
                      radius * Vec2(std::cos(angle), squeeze * std::sin(angle)));
    }
    return hull(found);
  }

  void lattice_polygons() {
    const int size = 3 + whole(5);
    for (int b = 2 + whole(4); b > 0; --b) {
      Polygon points;
      const Vec2 corner(whole(3), whole(3));
      for (int k = 3 + whole(4); k > 0; --k)
        points.push_back(corner + Vec2(whole(size), whole(size)));
      add(hull(points));
    }
  }
  void smooth_polygons() {
    for (int b = 2 + whole(4); b > 0; --b)
      add(regular({uniform(-0.8, 0.8), uniform(-0.8, 0.8)}));
  }
  Polygon reentrant_outline() {
    switch (whole(5)) {
    case 0:
      return {{0, 0}, {0, 3}, {1, 3}, {1, 1}, {3, 1}, {3, 0}};
    case 1:
      return {{0, 0}, {0, 3}, {1, 3}, {1, 1}, {2, 1}, {2, 3}, {3, 3}, {3, 0}};
    case 2:
      return {{0, 0}, {0, 1}, {0, 3}, {1, 3}, {1, 2}, {1, 1}, {3, 1}, {3, 0}};
    case 3:
      return {{0, 0}, {1, 3}, {2, 2}, {3, 3}, {4, 0}, {2, 1}};
    default:
      return {{0, 0}, {0, 2}, {2, 2}, {2, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 0}};
    }
  }
  Polygon reentrant_at(const Vec2& place) {
    Polygon outline = reentrant_outline();
    for (int quarters = whole(4); quarters > 0; --quarters)
      for (Vec2& p : outline)
        p = Vec2(p.y(), 3.0 - p.x());
    const double scale = one_in(2) ? 1.0 : 0.5;
    for (Vec2& p : outline)
      p = place + scale * p;
    return outline;
  }
  void reentrant() {
    add(reentrant_at({0, 0}));
    for (int b = 1 + whole(3); b > 0; --b) {
      const Vec2 place(0.5 * whole(7) - 1.5 + small(), 0.5 * whole(7) - 1.5 + small());
      if (one_in(3))
        box(place.x() + 1.0, place.y() + 1.0, 1, 0.5 * (1 + whole(4)));
      else if (one_in(2))
        add(reentrant_at(place));
      else
        add(turned(reentrant_at(place), uniform(-0.3, 0.3), place));
    }
  }
  void wall() {
    box(small(), small(), 2, 1);
    box(2 + small(), small(), 2, 1);
    box((one_in(2) ? 1.0 : 0.5 * whole(5)) + small(), 1 - overlap() + small(), 2, 1);
    if (one_in(2))
      box(3 + small(), 1 + small(), 2, 1);
    if (one_in(2))
      box(-1 + small(), 1 + small(), 2, 1);
  }
  /// Two or three blocks are side by side, and one is over a joint between them.
  void block_over_joint() {
    const double gap = small() * 0.1, step = small() * 0.5;
    box(-2, -1, 2, 1);
    box(gap, -1 + step, 2, 1);
    if (one_in(3))
      box(-2 + small(), -2 + small(), 2, 1);
    else if (one_in(3))
      box(2 + gap + small(), -1 + small(), 2, 1);
    const double deep = overlap(), x = uniform(-1.2, 0.3);
    if (one_in(3)) {
      add({{x, -deep},
           {x + small(), 1},
           {x + 1, 1},
           {x + 1 + small(), -deep + small()}});
    } else {
      const Polygon over = {{x, -deep}, {x, 1}, {x + 1, 1}, {x + 1, -deep}};
      add(turned(over, uniform(-0.4, 0.4), over[one_in(2) ? 0 : 3]));
    }
  }
  void near_ten_degrees() {
    constexpr double ten = 10.0 * 3.14159265358979323846 / 180.0;
    const double offs[] = {0.0, 1e-16, -1e-16, 1e-13, -1e-13, 1e-6, -1e-6};
    box(-2, -1, one_in(2) ? 4 : 2, 1);
    if (one_in(2))
      box(small() * 0.1, -1 + small(), 2, 1);
    const double angle = (one_in(2) ? ten : -ten) + offs[whole(7)];
    const double deep = overlap(), x = uniform(-1.5, 1.0), w = uniform(0.3, 2.0);
    Polygon over = {{x, -deep}, {x, 1}, {x + w, 1}, {x + w, -deep}};
    if (one_in(2))  // Both sides at the corner face the floor.
      over.push_back({x + 0.5 * w, -deep - 0.5 * w * std::tan(ten)});
    add(turned(over, angle, over[one_in(2) ? 0 : 3]));
    if (one_in(3))
      add(turned(outlines_.back(), uniform(-0.3, 0.3), {x, 0.5}));
  }
  /// The surface of the block beside the joint rises or falls.
  void rising_surface() {
    const double rise = one_in(2) ? uniform(-0.5, 1.0) : uniform(-3.0, 0.5);
    const double start = small() * 0.5, gap = small() * 0.1;
    box(-2, -1, 2, 1);
    add(hull({{gap, -1},
              {gap, start},
              {2 + gap, start + 2 * rise},
              {2 + gap, std::min(-1.0, start + 2 * rise)}}));
    const double deep = overlap(), x = uniform(-0.6, 0.3);
    Polygon over = {{x - 1, -deep}, {x - 1, 1}, {x, 1}, {x, -deep}};
    if (one_in(2))
      over[2].x() += uniform(-0.6, 0.6);
    add(one_in(2) ? over : turned(over, uniform(-0.8, 0.8), over[3]));
    if (one_in(3))
      box(x + small(), small(), 1, 1);
  }
  /// Bricks on a lattice share corners and sides. Some of them are moved a little.
  void flush_bricks() {
    for (int b = 3 + whole(3); b > 0; --b) {
      const double unit = one_in(4) ? 0.0625 : 1.0;
      const bool moved = one_in(3);
      box(whole(4) + (moved ? small() : 0.0), whole(3) + (moved ? small() : 0.0),
          1 + whole(2) + (one_in(3) ? unit * 0.5 : 0.0), 1 + (one_in(3) ? unit : 0.0));
    }
  }
  void reentrant_over_joint() {
    box(-3, -1, 3, 1);
    box(small() * 0.1, -1 + small(), 3, 1);
    add(turned(reentrant_at({uniform(-2.5, 0.5), -overlap()}),
               one_in(2) ? small() : 0.0, {0, 0}));
    if (one_in(2))
      add(reentrant_at({uniform(-3, 3), 1 - overlap()}));
  }

  /// Thin blocks with sharp corners, nearly parallel to one another.
  void wedges() {
    for (int b = 2 + whole(3); b > 0; --b) {
      const Vec2 at(uniform(-1.0, 1.0), uniform(-0.15, 0.15));
      const double length = uniform(0.5, 2.0), thick = uniform(0.02, 0.3);
      Polygon outline;
      for (int k = 3 + whole(4); k > 0; --k)
        outline.push_back(at + Vec2(length * uniform(-1, 1), thick * uniform(-1, 1)));
      if (one_in(2))  // The block has an acute corner under a long side.
        outline = {at, at + Vec2(length, 0),
                   at + Vec2(length * uniform(0.3, 0.9), -thick)};
      add(turned(hull(outline), uniform(-0.2, 0.2) + (one_in(2) ? 0.0 : 3.1416), at));
    }
  }
  /// Blocks with slanted prongs, whose parts have inner sides at sharp angles.
  void prongs() {
    for (int b = 2 + whole(2); b > 0; --b) {
      const double x = uniform(0.35, 0.8), deep = uniform(0.3, 0.9);
      const double lean = uniform(-0.4, 0.4);
      Polygon outline = {{0, 0},        {lean, 1},         {lean + 0.3, 1 + small()},
                         {x, 1 - deep}, {lean + 0.9, 1.0}, {lean + 1.2, 1 + small()},
                         {1, 0}};
      const Vec2 at(uniform(-0.6, 0.6), uniform(-0.6, 0.6));
      for (Vec2& p : outline)
        p += at;
      if (one_in(3))
        box(at.x(), at.y(), uniform(0.2, 1.5), uniform(0.1, 0.5));
      else
        add(turned(outline,
                   one_in(3) ? 0.5 * 3.14159265358979 * whole(4)
                             : uniform(-0.3, 0.3) + 3.1416 * whole(2),
                   at));
    }
  }

  /// Two or three blocks, or one, form a notch, and the tip of a wedge is at its
  /// bottom.
  void notch() {
    const double left = std::tan(uniform(0.1, 1.2)),
                 right = std::tan(uniform(0.1, 1.2));
    const double gap = small() * 0.1, step = small() * 0.1;
    if (one_in(5)) {
      add({{-3, -1}, {-3, 1}, {-left, 1}, {0, 0}, {right, 1}, {3, 1}, {3, -1}});
    } else {
      add({{-4, -1}, {-4, 1}, {-left, 1}, {0, 0}, {0, -1}});
      add({{gap, -1}, {gap, step}, {gap + right, 1 + step}, {4, 1 + step}, {4, -1}});
      if (one_in(3))
        box(gap + 4 + small(), -1 + small(), 1, 2);
    }
    const Vec2 tip(small() * 0.5, (one_in(4) ? 1.0 : -1.0) * overlap());
    const double wide = one_in(3) ? 1.0 : uniform(0.3, 1.1);
    const Polygon wedge = {tip, tip + Vec2(-wide * left, 1),
                           tip + Vec2(wide * right, 1)};
    add(one_in(2) ? wedge : turned(wedge, uniform(-0.3, 0.3), tip));
    if (one_in(3))
      box(tip.x() + uniform(-1.0, 0.0), tip.y() + 1 - overlap(), 1, 0.5);
  }

  /// Pieces of rock whose corners meet in a point, where joints cross or one joint ends
  /// at another one. Each piece is moved a little. Some are needles.
  void pieces() {
    constexpr double half_turn = 3.14159265358979323846;
    std::vector<double> angles = {0.0, half_turn};
    for (int k = 1 + whole(3); k > 0; --k)
      angles.push_back(one_in(2) ? 0.25 * half_turn * (1 + whole(7))
                                 : uniform(0.05, 2.0 * half_turn));
    std::sort(angles.begin(), angles.end());
    angles.push_back(2.0 * half_turn);
    const double far = uniform(0.5, 2.0);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
      const double from = angles[i], to = angles[i + 1];
      const Vec2 moved(0.2 * small(), 0.2 * small());
      const auto end = [&](double angle) {
        return Vec2(moved + far * Vec2(std::cos(angle), std::sin(angle)));
      };
      Polygon outline = {moved, end(to), end(0.5 * (from + to)), end(from)};
      if (one_in(4))
        outline = turned(outline, 0.1 * small(), moved);
      add(outline);
    }
  }

  std::vector<NewBlock> in_frame() {
    const double angle = one_in(2) ? uniform(0.0, 6.283) : 0.0;
    const double scale = std::ldexp(1.0, whole(5) - 2);
    const Vec2 offset =
        one_in(3) ? Vec2(uniform(-50, 50), uniform(-50, 50)) : Vec2(0, 0);
    std::shuffle(outlines_.begin(), outlines_.end(), random_);
    std::vector<NewBlock> found;
    for (Polygon outline : outlines_) {
      if (angle != 0.0)
        outline = turned(outline, angle, {0, 0});
      std::rotate(outline.begin(),
                  outline.begin() + whole(static_cast<int>(outline.size())),
                  outline.end());
      for (Vec2& p : outline)
        p = scale * p + offset;
      NewBlock block;
      block.outline = outline, block.density = 1.0;
      block.fixity = one_in(4) ? Fixity::by_user : Fixity::free;
      found.push_back(block);
    }
    return found;
  }

  std::mt19937_64 random_;
  std::vector<Polygon> outlines_;
};

}  // namespace blocks::testing
