#include "study/cut_domain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/split.hpp"

namespace blocks::study {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double half_width = 3.5;  // of a domain
constexpr double thickness = 2.5;   // of a domain below its lowest surface

double in_radians(double degrees) { return degrees * pi / 180.0; }

double distance_to_side(const Vec2& point, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double t = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - t * along).norm();
}

/// The interior angle at corner i of a clockwise outline, in [0, 2 pi).
double interior_angle(const Polygon& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const Vec2 to = outline[(i + 1) % n] - outline[i];
  const Vec2 from = outline[(i + n - 1) % n] - outline[i];
  const double angle = std::atan2(geometry::cross(to, from), to.dot(from));
  return angle < 0.0 ? -angle : 2.0 * pi - angle;
}

using Surface = std::vector<Vec2>;  ///< from left to right, without the two ends

/// A V with its bottom at the origin.
Surface draw_notch(Draws& draw, double low, double high) {
  const double half = draw.between(low, high);
  const double max = std::min({10.0, half - 8.0, 84.0 - half});
  const double tilt = draw.below(2) == 0 ? 0.0 : draw.between(-max, max);
  const double left = in_radians(half + tilt), right = in_radians(half - tilt);
  const double a = draw.between(0.7, 1.6), b = draw.between(0.7, 1.6);
  return {{-a * std::sin(left), a * std::cos(left)},
          {0, 0},
          {b * std::sin(right), b * std::cos(right)}};
}

/// A step with its foot at the origin; its face makes this angle with the horizontal.
Surface step(double degrees, double height) {
  const double back = degrees == 90.0 ? 0.0 : height / std::tan(in_radians(degrees));
  return {{0, 0}, {back, height}};
}

Surface draw_ledges(Draws& draw) {
  const double first = draw.between(0.1, 0.3), second = draw.between(0.1, 0.3);
  const double tread = draw.between(0.2, 0.6);
  return {{0, 0}, {0, first}, {tread, first}, {tread, first + second}};
}

Surface draw_step_and_notch(Draws& draw) {
  const double height = draw.between(0.2, 0.8);
  Surface surface = {{-1.8, height}, {-1.8, 0}};
  const Surface notch = draw_notch(draw, 20, 55);
  for (const Vec2& p : notch)
    surface.push_back(p + Vec2(0, -notch.front().y()));
  return surface;
}

Surface draw_bump(Draws& draw) {
  const double height = draw.between(0.06, 0.4);
  const double left = draw.between(0.1, 0.6), right = draw.between(0.1, 0.6);
  return {{-left, 0}, {0, height}, {right, 0}};
}

Surface draw_surface(Draws& draw, const std::string& kind) {
  if (kind == "flat")
    return {};
  if (kind == "ridge")
    return {{0, 0}};
  if (kind == "notch")
    return draw_notch(draw, 15, 80);
  const double height = draw.between(0.15, 1.2);
  if (kind == "step")
    return step(draw.below(2) == 0 ? 90.0 : draw.between(50, 90), height);
  if (kind == "ledges")
    return draw_ledges(draw);
  if (kind == "step-notch")
    return draw_step_and_notch(draw);
  if (kind == "overhang")
    return step(draw.between(100, 140), std::max(0.3, height));
  return draw_bump(draw);
}

/// Whether both pieces of a cut are wide and blunt enough.
bool is_sound(const geometry::Split& split) {
  return split.fault == geometry::SplitFault::none &&
         std::all_of(split.pieces.begin(), split.pieces.end(), [](const auto& piece) {
           return narrowest_width(piece.outline) >= min_width &&
                  sharpest_angle(piece.outline) >= min_angle;
         });
}

/// The sharpest re-entrant corner.
Vec2 sharpest_corner(const CutDomain& domain) {
  std::size_t found = 0;
  double max = 0.0;
  for (std::size_t i = 0; i < domain.outline.size(); ++i)
    if (const double angle = interior_angle(domain.outline, i); angle > max)
      max = angle, found = i;
  return domain.outline[found];
}

/// A point of the surface at which a joint begins. It may be an inner corner of the
/// surface, the end of an earlier joint, or any point.
Vec2 draw_start(Draws& draw, const CutDomain& domain) {
  const int kind = draw.below(10);
  if (kind < 2 && !domain.ends.empty())
    return domain.ends[static_cast<std::size_t>(
        draw.below(static_cast<int>(domain.ends.size())))];
  if (kind < 4 && domain.sharpest < 0.49 * pi)
    return sharpest_corner(domain);
  if (kind < 6 && domain.surface > 2)
    return domain.outline[static_cast<std::size_t>(1 + draw.below(domain.surface - 2))];
  while (true) {
    const auto side = static_cast<std::size_t>(draw.below(domain.surface - 1));
    const double part = draw();
    const Vec2 point =
        (1.0 - part) * domain.outline[side] + part * domain.outline[side + 1];
    if (std::abs(point.x()) < 1.6)
      return point;
  }
}

/// The direction of a joint: vertical, parallel to a face, or at 35 to 145 degrees.
Vec2 draw_direction(Draws& draw, const CutDomain& domain) {
  const int kind = draw.below(10);
  const double angle = in_radians(draw.between(35, 145));
  const auto side = static_cast<std::size_t>(draw.below(domain.surface - 1));
  if (kind < 2)
    return {0, 1};
  if (kind < 4 &&
      std::abs(domain.outline[side + 1].y() - domain.outline[side].y()) >
          0.7 * std::abs(domain.outline[side + 1].x() - domain.outline[side].x()))
    return domain.outline[side + 1] - domain.outline[side];
  return {std::cos(angle), std::sin(angle)};
}

bool is_on_border(const Vec2& point, const Polygon& piece) {
  for (std::size_t i = 0; i < piece.size(); ++i)
    if (distance_to_side(point, piece[i], piece[(i + 1) % piece.size()]) < 1e-9)
      return true;
  return false;
}

/// Cuts the pieces that the joint begins in. If it continues, it also cuts the other
/// pieces; otherwise it ends at the first joint that it meets. Returns whether a piece
/// was cut.
bool cut_pieces(CutDomain& domain, const Vec2& start, const Vec2& along,
                bool continues) {
  std::vector<Polygon> pieces;
  bool has_cut = false;
  for (Polygon& piece : domain.pieces) {
    if (continues || is_on_border(start, piece)) {
      geometry::Split split =
          geometry::split_outline(piece, {start, along, min_width}, 0.0);
      if (is_sound(split)) {
        has_cut = true;
        for (geometry::SplitPiece& half : split.pieces)
          pieces.push_back(std::move(half.outline));
        continue;
      }
    }
    pieces.push_back(std::move(piece));
  }
  domain.pieces = std::move(pieces);
  return has_cut;
}

/// Collects the points of the surface that are corners of at least two pieces.
std::vector<Vec2> joint_ends(const CutDomain& domain) {
  std::vector<Vec2> once, ends;
  const auto has = [](const std::vector<Vec2>& points, const Vec2& p) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec2& q) { return (p - q).norm() < 1e-9; });
  };
  for (const Polygon& piece : domain.pieces)
    for (const Vec2& corner : piece) {
      if (surface_side(domain, corner) < 0)
        continue;
      if (!has(once, corner))
        once.push_back(corner);
      else if (!has(ends, corner))
        ends.push_back(corner);
    }
  return ends;
}

}  // namespace

const std::vector<std::string>& domain_kinds() {
  static const std::vector<std::string> kinds = {
      "flat", "ridge", "notch", "step", "ledges", "step-notch", "overhang", "bump"};
  return kinds;
}

CutDomain draw_domain(Draws& draw, const std::string& kind) {
  Surface inner = draw_surface(draw, kind);
  const auto slope = [&] { return draw.below(2) == 0 ? 0.0 : draw.between(-0.2, 0.2); };
  double left = slope(), right = slope();
  if (kind == "flat")
    right = left;
  if (kind == "ridge")
    left = draw.between(0.1, 1.5), right = -draw.between(0.0, 1.5);
  const bool mirrored = draw.below(2) == 0;
  const Vec2 first = inner.empty() ? Vec2(0, 0) : inner.front();
  const Vec2 last = inner.empty() ? Vec2(0, 0) : inner.back();
  CutDomain domain;
  domain.kind = kind;
  Surface& surface = domain.outline;
  surface.emplace_back(-half_width, first.y() + left * (-half_width - first.x()));
  surface.insert(surface.end(), inner.begin(), inner.end());
  surface.emplace_back(half_width, last.y() + right * (half_width - last.x()));
  if (mirrored) {
    std::reverse(surface.begin(), surface.end());
    for (Vec2& p : surface)
      p.x() = -p.x();
  }
  domain.surface = static_cast<int>(surface.size());
  double lowest = 0.0;
  for (const Vec2& p : surface)
    lowest = std::min(lowest, p.y());
  domain.outline.emplace_back(half_width, lowest - thickness);
  domain.outline.emplace_back(-half_width, lowest - thickness);
  domain.sharpest = 0.5 * pi;
  for (std::size_t i = 0; i < domain.outline.size(); ++i) {
    const double opening = 2.0 * pi - interior_angle(domain.outline, i);
    domain.sharpest = std::min(domain.sharpest, 0.5 * opening);
  }
  domain.pieces = {domain.outline};
  return domain;
}

void cut_domain(Draws& draw, int joints, CutDomain& domain) {
  constexpr int max_attempts = 40;
  for (int attempt = 0; attempt < max_attempts && domain.joints < joints; ++attempt) {
    const Vec2 start = draw_start(draw, domain);
    const Vec2 along = draw_direction(draw, domain);
    const bool continues = draw.below(10) < 6;
    if (cut_pieces(domain, start, along, continues)) {
      ++domain.joints;
      domain.ends = joint_ends(domain);
    }
  }
}

Polygon marked_outline(const CutDomain& domain) {
  Polygon marked;
  for (std::size_t i = 0; i < domain.outline.size(); ++i) {
    const Vec2 a = domain.outline[i];
    marked.push_back(a);
    std::vector<Vec2> inside;
    for (const Vec2& end : domain.ends)
      if (surface_side(domain, end) == static_cast<int>(i) && (end - a).norm() > 1e-9 &&
          (end - domain.outline[(i + 1) % domain.outline.size()]).norm() > 1e-9)
        inside.push_back(end);
    std::sort(inside.begin(), inside.end(), [&](const Vec2& p, const Vec2& q) {
      return (p - a).squaredNorm() < (q - a).squaredNorm();
    });
    marked.insert(marked.end(), inside.begin(), inside.end());
  }
  return marked;
}

int surface_side(const CutDomain& domain, const Vec2& point) {
  for (int i = 0; i + 1 < domain.surface; ++i)
    if (distance_to_side(point, domain.outline[static_cast<std::size_t>(i)],
                         domain.outline[static_cast<std::size_t>(i) + 1]) < 1e-9)
      return i;
  return -1;
}

double narrowest_width(const Polygon& piece) {
  const std::size_t n = piece.size();
  double min = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    min = std::min(min, (piece[(i + 1) % n] - piece[i]).norm());
    for (std::size_t c = 0; c < n; ++c)
      if (c != i && c != (i + 1) % n)
        min = std::min(min, distance_to_side(piece[c], piece[i], piece[(i + 1) % n]));
  }
  return min;
}

double sharpest_angle(const Polygon& piece) {
  double min = 2.0 * pi;
  for (std::size_t i = 0; i < piece.size(); ++i)
    min = std::min(min, interior_angle(piece, i));
  return min * 180.0 / pi;
}

}  // namespace blocks::study
