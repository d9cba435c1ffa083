#include "post/page/view_shapes.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>

namespace blocks::post {
namespace {

Eigen::Matrix2Xd arms(const std::vector<Eigen::Vector2d>& outline,
                      const Eigen::Vector2d& centroid) {
  Eigen::Matrix2Xd r(2, static_cast<Eigen::Index>(outline.size()));
  for (std::size_t c = 0; c < outline.size(); ++c)
    r.col(static_cast<Eigen::Index>(c)) = outline[c] - centroid;
  return r;
}
Eigen::Matrix2Xd arms(const Frame& frame, int b) {
  return arms(frame.outlines[static_cast<std::size_t>(b)], frame.centroid.col(b));
}

/// Rounds a strain to steps; NaN, with which a run may end, becomes 0.
int in_strain_steps(double strain) {
  return std::isnan(strain) ? 0
                            : static_cast<int>(std::lround(std::clamp(
                                  strain / ViewShapes::strain_step, -1e9, 1e9)));
}

}  // namespace

ViewShapes::ViewShapes(const ResultsReader& results)
    : results_(results), last_outlines_(results.last_outlines(results.frames() - 1)) {}

void ViewShapes::add_frame(const Frame& now, const CrackedBlocks& cracked) {
  for (int b = 0; b < blocks(); ++b) {
    const Eigen::Matrix2d strain =
        b < now.size() ? follow(now, cracked, b) : Eigen::Matrix2d::Zero();
    for (const double value : strain.reshaped())
      strain_.push_back(in_strain_steps(value));
  }
  frames_.push_back(current_);
}

void ViewShapes::add(Shape shape, const Eigen::Vector2d& origin, double mass,
                     double inertia) {
  const auto block = static_cast<std::size_t>(shape.block), index = shapes_.size();
  if (block == current_.size()) {
    current_.push_back(0);
    first_shape_.push_back(index);
  }
  current_[block] = static_cast<int>(index);
  first_corner_.push_back(first_corner_.back() + static_cast<int>(shape.arms.cols()));
  origin_.insert(origin_.end(), {origin.x(), origin.y()});
  mass_.push_back(static_cast<float>(mass));
  inertia_.push_back(static_cast<float>(inertia));
  shapes_.push_back(std::move(shape));
}

/// Adds the shape of a block that is removed in all frames of the page.
void ViewShapes::add_hidden(int b) {
  const double none = std::nan("");
  const auto& outline = last_outlines_[static_cast<std::size_t>(b)];
  Shape shape{b, 0, 0.0, {}, Eigen::Matrix2d::Identity(), 0.0, {}, {}};
  shape.arms =
      arms(outline, outline.empty() ? Eigen::Vector2d::Zero().eval() : outline.front());
  add(std::move(shape), {none, none}, none, none);
}

void ViewShapes::refuse(const Frame& now, int b) const {
  throw std::runtime_error(fmt::format(
      "{}: block {} has changed its outline at time {:g}; the page cannot show that",
      results_.path(), b + 1, now.time));
}

/// Returns the strain of the arms of a block before its rotation. Also records new
/// shapes and whether a block is strained.
Eigen::Matrix2d ViewShapes::follow(const Frame& now, const CrackedBlocks& cracked,
                                   int b) {
  const auto block = static_cast<std::size_t>(b);
  const bool is_new = block == current_.size();
  if (now.is_removed(b)) {
    if (is_new)
      add_hidden(b);
    return Eigen::Matrix2d::Zero();
  }
  const Eigen::Matrix2Xd r = arms(now, b);
  const int version = cracked.version[block];
  if (is_new || shapes_[static_cast<std::size_t>(current_[block])].version != version) {
    // The origin is NaN for a block that was made later; the page then uses x and y.
    const bool is_later = cracked.later[block] != 0;
    const bool from_first = version == 0 && !is_later;
    const Eigen::Matrix2Xd own = from_first ? arms(cracked.first, b) : r;
    add({b,
         version,
         from_first ? cracked.first.angle[b] : now.angle[b],
         own,
         (own * own.transpose()).inverse(),
         own.colwise().norm().maxCoeff(),
         {},
         {}},
        is_later ? Eigen::Vector2d::Constant(std::nan("")).eval()
                 : cracked.first.centroid.col(b).eval(),
        now.mass[b], now.inertia[b]);
  }
  Shape& shape = shapes_[static_cast<std::size_t>(current_[block])];
  if (block < now.joints.size())
    shape.joints = now.joints[block];
  if (shape.faces.empty() && !cracked.faces[block].empty()) {
    shape.faces = cracked.faces[block];
    has_faces_ = true;
  }
  if (r.cols() != shape.arms.cols())
    refuse(now, b);
  const double turn = now.angle[b] - shape.angle;
  const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
  if ((r - rotation * shape.arms).cwiseAbs().maxCoeff() < 1e-6 * shape.extent)
    return Eigen::Matrix2d::Zero();
  strained_ = true;
  const Eigen::Matrix2d map = r * shape.arms.transpose() * shape.inverse;
  if ((r - map * shape.arms).cwiseAbs().maxCoeff() > 1e-4 * shape.extent)
    refuse(now, b);
  return rotation.transpose() * map - Eigen::Matrix2d::Identity();
}

int ViewShapes::corners_of(int block) const {
  const auto b = static_cast<std::size_t>(block) - 1;
  if (block < 1 || b >= current_.size())
    return 0;
  return static_cast<int>(shapes_[static_cast<std::size_t>(current_[b])].arms.cols());
}

int ViewShapes::corner_index(int block, int corner) const {
  if (corner < 1 || corner > corners_of(block))
    return -1;
  const int shape = current_[static_cast<std::size_t>(block) - 1];
  return first_corner_[static_cast<std::size_t>(shape)] + corner - 1;
}

void ViewShapes::end_frames() {
  for (const std::vector<int>& frame : frames_)
    for (std::size_t b = 0; b < first_shape_.size(); ++b)
      of_.push_back(b < frame.size() ? static_cast<std::size_t>(frame[b])
                                     : first_shape_[b]);
  frames_.clear();
}

void ViewShapes::store_first(ViewStore& store) const {
  std::vector<float> arm, angle;
  for (const Shape& shape : shapes_) {
    for (const double value : shape.arms.reshaped())
      arm.push_back(static_cast<float>(value));
    angle.push_back(static_cast<float>(shape.angle * 180 / std::numbers::pi));
  }
  // Values of eight bytes come first, so that arrays stay aligned.
  store.add("origin", "f64", origin_);
  store.add("arm", "f32", arm);
  store.add("angle", "f32", angle);
  store.add("mass", "f32", mass_);
  store.add("inertia", "f32", inertia_);
  if (shapes_.size() > first_shape_.size())
    store.add_whole("shape", {of_.begin(), of_.end()}, first_shape_.size());
}

void ViewShapes::store_rest(ViewStore& store) const {
  if (strained_)
    store.add_whole("strain", strain_, 4 * static_cast<std::size_t>(blocks()));
  std::vector<std::uint16_t> corners;
  for (const Shape& shape : shapes_)
    corners.push_back(static_cast<std::uint16_t>(shape.arms.cols()));
  store.add("corners", "u16", corners);
  if (const std::vector<int> ids = joint_ids(); !ids.empty())
    store.add("joint", "u16", joints_of_sides(ids));
  if (!has_faces_)
    return;
  std::vector<std::uint32_t> faces(static_cast<std::size_t>(this->corners()));
  for (std::size_t s = 0; s < shapes_.size(); ++s)
    for (std::size_t k = 0; k < shapes_[s].faces.size(); ++k)
      faces[static_cast<std::size_t>(first_corner_[s]) + k] =
          static_cast<std::uint32_t>(shapes_[s].faces[k]);
  store.add("crack", "u32", faces);
}

std::vector<int> ViewShapes::joint_ids() const {
  std::set<int> ids = {0};
  for (const Shape& shape : shapes_)
    ids.insert(shape.joints.begin(), shape.joints.end());
  return ids.size() > 1 ? std::vector<int>(ids.begin(), ids.end()) : std::vector<int>();
}

/// Returns the index of the joint id of each side, in the order of all corners.
std::vector<std::uint16_t>
ViewShapes::joints_of_sides(const std::vector<int>& ids) const {
  std::vector<std::uint16_t> indices(static_cast<std::size_t>(corners()));
  for (std::size_t s = 0; s < shapes_.size(); ++s)
    for (std::size_t k = 0; k < shapes_[s].joints.size(); ++k)
      indices[static_cast<std::size_t>(first_corner_[s]) + k] =
          static_cast<std::uint16_t>(
              std::lower_bound(ids.begin(), ids.end(), shapes_[s].joints[k]) -
              ids.begin());
  return indices;
}

}  // namespace blocks::post
