// Writes a .vtu file: an unstructured grid with cell data, readable by ParaView and
// VisIt (XML, appended raw data).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace blocks::post {

struct VtuArray {
  std::string name;
  int components;  ///< values per cell; the values of a cell are contiguous
  std::variant<std::vector<double>, std::vector<int>> values;
};

/// Cells in the plane z = 0.
struct VtuGrid {
  Eigen::Matrix2Xd points;  ///< [L]
  std::vector<std::int64_t> connectivity,
      ends;           ///< (cells) end of the points of each cell
  int cell_type = 7;  ///< 7 polygons, 1 single points; a cell without points is empty
  std::vector<VtuArray> cell_data;
  double time = 0.0;
  std::int64_t step = 0;
};

/// Returns the columns of a (2, n) matrix as points in space, (3 n).
std::vector<double> in_space(const Eigen::Matrix2Xd& plane);

/// Writes the file. Throws files::FileError if it cannot be written.
void write_vtu(const std::string& path, const VtuGrid& grid);

}  // namespace blocks::post
