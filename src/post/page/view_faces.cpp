#include "post/page/view_faces.hpp"

#include <cmath>
#include <limits>

namespace blocks::post {
namespace {

/// What is less than a billionth of the length of a face becomes 0.
float rounded(double value, double length) {
  return std::abs(value) > 1e-9 * length ? four_digits(value) : 0.0F;
}

}  // namespace

void ViewFaces::add_frame(const Frame& now, const CrackedBlocks& cracked,
                          const ViewShapes& shapes) {
  auto& frame = frames_.emplace_back();
  if (cracks_ != cracked.cracks)  // only cracks make new faces
    known_ = find_faces(cracked.first, cracked.later);
  cracks_ = cracked.cracks;
  for (const Face& face : known_) {
    const auto motion = motion_of(face, now);
    if (!motion)
      continue;
    const auto index = [&](const SidePart& part) {
      return shapes.corner_index(part.block + 1, static_cast<int>(part.side) + 1);
    };
    const std::pair sides(index(face.own), index(face.other));
    const auto [found, is_new] =
        faces_.try_emplace(sides, static_cast<std::uint32_t>(faces_.size()));
    if (is_new) {
      for (const int side : {sides.first, sides.second})
        sides_.push_back(static_cast<std::uint32_t>(side));
      for (const SidePart* part : {&face.own, &face.other})
        for (const double end : part->ends)
          parts_.push_back(static_cast<float>(end));
    }
    const double length = (motion->own[1] - motion->own[0]).norm();
    Values& values = frame.emplace_back(Values{found->second, {}, {}});
    for (int end = 0; end < 2; ++end) {
      const auto at = static_cast<std::size_t>(end);
      values.opening[at] = rounded(motion->opening[end], length);
      values.shear[at] = rounded(motion->shear[end], length);
    }
  }
}

void ViewFaces::store(ViewStore& store) const {
  const std::size_t rows = 2 * faces_.size();
  DigitColumn opening{rows, {}, {}}, shear = opening;
  for (const auto& frame : frames_) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> openings(rows, none), shears(rows, none);
    for (const Values& values : frame)
      for (std::size_t end = 0; end < 2; ++end) {
        openings[2 * values.face + end] = values.opening[end];
        shears[2 * values.face + end] = values.shear[end];
      }
    for (std::size_t row = 0; row < rows; ++row) {
      opening.add(openings[row]);
      shear.add(shears[row]);
    }
  }
  store.add("face_side", "u32", sides_);
  store.add("face_part", "f32", parts_);
  store.add_digits("opening", opening);
  store.add_digits("shear_displacement", shear);
}

}  // namespace blocks::post
