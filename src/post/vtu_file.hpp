// One .vtu file: an unstructured grid with data on its cells, as every ParaView and
// VisIt reads it (XML, appended raw data).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace blocks::post {

struct VtuArray {
  std::string name;
  int components;  ///< values per cell, one cell after the other
  std::variant<std::vector<double>, std::vector<int>> values;
};

/// Cells of the plane, z = 0.
struct VtuGrid {
  Eigen::Matrix2Xd points;  ///< [L]
  std::vector<std::int64_t> connectivity,
      ends;           ///< (cells) one behind the last point of each cell
  int cell_type = 7;  ///< 7 polygons, 1 single points
  std::vector<VtuArray> cell_data;
  double time = 0.0;
  std::int64_t step = 0;
};

/// (3 n) the columns of a plane as points of space.
std::vector<double> in_space(const Eigen::Matrix2Xd& plane);

/// Throws output::FileError when it cannot be written.
void write_vtu(const std::string& path, const VtuGrid& grid);

}  // namespace blocks::post
