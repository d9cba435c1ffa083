#include "post/read/face_motion.hpp"

#include <algorithm>

namespace blocks::post {
namespace {

using Vector = Eigen::Vector2d;

/// Of the shorter side: the largest distance and the least common part of a face.
constexpr double near = 0.01;
/// The sides of a face have this cosine of their directions at most.
constexpr double facing = -0.95;

struct Side {
  int block;
  std::size_t side;
  Vector from, to, low, high;
  double length() const { return (to - from).norm(); }
};

std::vector<Side> sides_of(const Frame& frame, const std::vector<char>& later) {
  std::vector<Side> sides;
  for (std::size_t b = 0; b < frame.outlines.size(); ++b) {
    const auto& outline = frame.outlines[b];
    if (b < later.size() && later[b] != 0)
      continue;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vector &from = outline[k], &to = outline[(k + 1) % outline.size()];
      if (from.allFinite() && to.allFinite() && from != to)
        sides.push_back(
            {static_cast<int>(b), k, from, to, from.cwiseMin(to), from.cwiseMax(to)});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.low.x() < b.low.x(); });
  return sides;
}

/// Returns opening and shear of both ends, without those of the first frame.
Eigen::Matrix2d apart(const Face& face, const Frame& frame) {
  // Blocks are clockwise, so the outside of a side is to its left.
  const Vector along = (face.own.along(frame).normalized() -
                        face.other.along(frame).normalized())
                           .normalized(),
               outwards(-along.y(), along.x());
  Eigen::Matrix2d both;
  for (int end = 0; end < 2; ++end) {
    const Vector gap = face.other.at(frame, end) - face.own.at(frame, end);
    both.col(end) << gap.dot(outwards), gap.dot(along);
  }
  return both;
}

std::optional<Face> face_of(const Side& own, const Side& other, const Frame& first) {
  const double length = own.length(), other_length = other.length(),
               reach = near * std::min(length, other_length);
  if (own.block == other.block || ((other.low - own.high).array() > reach).any() ||
      ((own.low - other.high).array() > reach).any())
    return std::nullopt;
  const Vector along = (own.to - own.from) / length,
               back = (other.to - other.from) / other_length;
  if (along.dot(back) > facing)
    return std::nullopt;
  Face face{{own.block,
             own.side,
             {std::max(0.0, (other.to - own.from).dot(along) / length),
              std::min(1.0, (other.from - own.from).dot(along) / length)}},
            {other.block, other.side, {}},
            Eigen::Matrix2d::Zero()};
  if (!((face.own.ends[1] - face.own.ends[0]) * length >= reach))
    return std::nullopt;
  for (int end = 0; end < 2; ++end) {
    const Vector at = own.from + face.own.ends[end] * (own.to - own.from);
    face.other.ends[end] =
        std::clamp((at - other.from).dot(back) / other_length, 0.0, 1.0);
  }
  face.first = apart(face, first);
  return (face.first.row(0).array().abs() <= reach).all() ? std::optional(face)
                                                          : std::nullopt;
}

}  // namespace

Eigen::Vector2d SidePart::at(const Frame& frame, int end) const {
  return frame.outlines[static_cast<std::size_t>(block)][side] +
         ends[end] * along(frame);
}

Eigen::Vector2d SidePart::along(const Frame& frame) const {
  const auto& outline = frame.outlines[static_cast<std::size_t>(block)];
  return outline[(side + 1) % outline.size()] - outline[side];
}

std::vector<Face> find_faces(const Frame& first, const std::vector<char>& later) {
  const std::vector<Side> sides = sides_of(first, later);
  std::vector<Face> faces;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double reach = sides[i].high.x() + near * sides[i].length();
    for (std::size_t k = i + 1; k < sides.size() && sides[k].low.x() <= reach; ++k)
      if (const auto face = face_of(sides[i], sides[k], first))
        faces.push_back(*face);
  }
  return faces;
}

std::optional<FaceMotion> motion_of(const Face& face, const Frame& now) {
  for (const SidePart* part : {&face.own, &face.other}) {
    const auto block = static_cast<std::size_t>(part->block);
    if (block >= now.outlines.size() || part->side >= now.outlines[block].size())
      return std::nullopt;
  }
  const Vector own = face.own.along(now), other = face.other.along(now);
  if (!(own.normalized().dot(other.normalized()) <= facing))
    return std::nullopt;
  const Eigen::Matrix2d moved = apart(face, now) - face.first;
  const double length = (face.own.ends[1] - face.own.ends[0]) * own.norm();
  if (moved.rowwise().mean().cwiseAbs().maxCoeff() > length)
    return std::nullopt;
  return FaceMotion{{face.own.at(now, 0), face.own.at(now, 1)},
                    {face.other.at(now, 0), face.other.at(now, 1)},
                    moved.row(0),
                    moved.row(1)};
}

std::vector<FaceMotion> face_motions(const Frame& now, const Frame& first,
                                     const CrackedBlocks* cracked) {
  std::vector<FaceMotion> motions;
  for (const Face& face :
       find_faces(first, cracked != nullptr ? cracked->later : std::vector<char>()))
    if (const auto motion = motion_of(face, now))
      motions.push_back(*motion);
  return motions;
}

}  // namespace blocks::post
