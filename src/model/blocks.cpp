#include "model/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/convex_parts.hpp"
#include "geometry/polygon.hpp"

namespace blocks {

geometry::Polygon Blocks::outline(int b) const {
  geometry::Polygon result;
  result.reserve(static_cast<std::size_t>(corners_of(b)));
  for (int c = first_corner[b]; c < first_corner[b + 1]; ++c)
    result.emplace_back(corner.col(c));
  return result;
}

void Blocks::append(const std::vector<NewBlock>& added) {
  const int old_blocks = size();
  const int old_corners = corners();
  int new_corners = old_corners;
  for (const NewBlock& block : added) {
    if (block.outline.size() > geometry::max_corners)
      throw std::invalid_argument("a block has at most " +
                                  std::to_string(geometry::max_corners) + " corners");
    if (!block.joints.empty() && block.joints.size() != block.outline.size())
      throw std::invalid_argument("a block needs one joint id for each side");
    new_corners += static_cast<int>(block.outline.size());
  }
  const int new_blocks = old_blocks + static_cast<int>(added.size());

  arm.conservativeResize(2, new_corners);
  corner.conservativeResize(2, new_corners);
  const auto grow = [&](auto& column) {
    column.conservativeResize(column.rows(), new_blocks);
    column.rightCols(new_blocks - old_blocks).setZero();
  };
  const auto grow_vector = [&](Eigen::VectorXd& vector) {
    vector.conservativeResize(new_blocks);
    vector.tail(new_blocks - old_blocks).setZero();
  };
  for (Eigen::VectorXd* vector : {&area, &mass, &inertia, &angle, &spin, &moment})
    grow_vector(*vector);
  for (Eigen::Matrix2Xd* column : {&centroid, &velocity, &force})
    grow(*column);
  for (Eigen::Matrix4Xd* column :
       {&second_moment, &gradient, &applied, &stress, &strain_rate})
    grow(*column);
  gradient.rightCols(new_blocks - old_blocks).colwise() =
      Eigen::Vector4d(1.0, 0.0, 0.0, 1.0);

  int b = old_blocks;
  for (const NewBlock& block : added) {
    const geometry::SectionProperties section =
        geometry::section_properties(block.outline);
    if (!(section.area > 0.0) || !(block.density > 0.0) || !std::isfinite(section.area))
      throw std::invalid_argument("a block needs a positive area and density");
    area[b] = section.area;
    mass[b] = block.density * section.area;
    inertia[b] = block.density * section.polar_moment;
    second_moment.col(b) = tensor_of(block.density * section.second_moment);
    centroid.col(b) = section.centroid;
    material.push_back(block.material);
    fixity.push_back(block.fixity);
    layer.push_back(block.layer);
    const int first = first_corner.back(),
              count = static_cast<int>(block.outline.size());
    convex.push_back(geometry::check_outline(block.outline).convex ? 1 : 0);
    if (!convex.back())
      cut(b, block.outline);
    joint.insert(joint.end(), block.joints.begin(), block.joints.end());
    joint.resize(static_cast<std::size_t>(first + count), 0);
    int c = first;
    for (const Vec2& point : block.outline) {
      corner.col(c) = point;
      arm.col(c) = point - section.centroid;
      corner_block.push_back(b);
      next.push_back(c + 1 == first + count ? first : c + 1);
      previous.push_back(c == first ? first + count - 1 : c - 1);
      ++c;
    }
    first_corner.push_back(c);
    ++b;
  }
}

void Blocks::cut(int b, const geometry::Polygon& outline) {
  for (const std::vector<int>& part : geometry::convex_parts(outline)) {
    cuts.push_back(b);
    cuts.push_back(static_cast<int>(part.size()));
    cuts.insert(cuts.end(), part.begin(), part.end());
  }
}

std::vector<geometry::Polygon> Blocks::present_outlines() const {
  std::vector<geometry::Polygon> outlines(static_cast<std::size_t>(size()));
  for (int b = 0; b < size(); ++b)
    if (!is_removed(b))
      outlines[static_cast<std::size_t>(b)] = outline(b);
  return outlines;
}

int Blocks::count_present() const {
  return size() -
         static_cast<int>(std::count(fixity.begin(), fixity.end(), Fixity::removed));
}

void Blocks::fix(int b, Fixity why) {
  fixity[b] = why;
  velocity.col(b).setZero();
  spin[b] = 0.0;
  strain_rate.col(b).setZero();
}

}  // namespace blocks
