#include "dynamics/cracks/pieces.hpp"

#include <algorithm>
#include <utility>

#include "geometry/polygon.hpp"

namespace blocks::dynamics {
namespace {

bool has_first_corner(const geometry::SplitPiece& shape) {
  return std::find(shape.corner.begin(), shape.corner.end(), 0) != shape.corner.end();
}

/// Returns the stress without its tensile component at right angles to the chord.
Eigen::Vector4d relieved(const Eigen::Vector4d& stress, const Vec2& chord) {
  const Vec2 normal = Vec2(-chord.y(), chord.x()).normalized();
  const double x = normal.x(), y = normal.y();
  const double tension =
      x * x * stress[0] + x * y * (stress[1] + stress[2]) + y * y * stress[3];
  if (!(tension > 0.0))
    return stress;
  const double shear = stress[1] - tension * x * y;
  return {stress[0] - tension * x * x, shear, shear, stress[3] - tension * y * y};
}

}  // namespace

BlockSplit pieces_of(const Blocks& blocks, int b, geometry::Split cut) {
  if (cut.pieces[1].area > cut.pieces[0].area ||
      (cut.pieces[1].area == cut.pieces[0].area && !has_first_corner(cut.pieces[0])))
    std::swap(cut.pieces[0], cut.pieces[1]);
  BlockSplit split{.block = b, .pieces = {}, .ends = cut.ends, .joint = 0};
  auto& [stays, leaves] = split.pieces;
  const double mass = blocks.mass[b];
  const double whole = cut.pieces[0].area + cut.pieces[1].area;
  stays.mass = mass * cut.pieces[0].area / whole;
  leaves.mass = mass - stays.mass;
  const Eigen::Vector4d stress =
      relieved(blocks.stress.col(b), cut.ends[1].place - cut.ends[0].place);
  for (std::size_t p = 0; p < 2; ++p) {
    Piece& piece = split.pieces[p];
    piece.shape = std::move(cut.pieces[p]);
    const geometry::SectionProperties section =
        geometry::section_properties(piece.shape.outline);
    piece.centroid = section.centroid;
    const double density = piece.mass / section.area;
    piece.inertia = density * section.polar_moment;
    piece.second_moment = tensor_of(density * section.second_moment);
    piece.stress = stress;
  }
  // The velocity at the centroid of the first piece; the second one takes the rest of
  // the momentum. Equal spins take the rest of the angular momentum.
  const Vec2 centroid = blocks.centroid.col(b), velocity = blocks.velocity.col(b);
  const auto rate = blocks.strain_rate.col(b);
  const double spin = blocks.spin[b];
  const Vec2 arm = stays.centroid - centroid;
  stays.velocity = velocity + Vec2(rate[0] * arm.x() + (rate[1] - spin) * arm.y(),
                                   (rate[2] + spin) * arm.x() + rate[3] * arm.y());
  leaves.velocity = (mass * velocity - stays.mass * stays.velocity) / leaves.mass;
  double rest = blocks.inertia[b] * spin;
  for (const Piece& piece : split.pieces)
    rest -= piece.mass * geometry::cross(Vec2(piece.centroid - centroid),
                                         Vec2(piece.velocity - velocity));
  stays.spin = leaves.spin = rest / (stays.inertia + leaves.inertia);
  return split;
}

}  // namespace blocks::dynamics
