// The water in NAME.vtkhdf: CellData/WaterForce and /BLOCKS/water.
#pragma once

#include <optional>

#include "model/model.hpp"
#include "output/results/results_late_columns.hpp"

namespace blocks::output {

/// The force of water on each block, and for each frame the parts of sides on which its
/// pressure is linear, and the water table as a line. They are absent as long as there
/// is no water.
class WaterColumns {
 public:
  /// vtk, steps, own: the groups /VTKHDF, /VTKHDF/Steps and /BLOCKS, which stay open.
  WaterColumns(hid_t vtk, hid_t steps, hid_t own)
      : forces_(vtk, steps, "CellData", "WaterForce", 3), own_(own) {}

  /// Opens the data of a file if it has them. Throws hdf5::Failure if their shape is
  /// wrong.
  void open();
  /// Writes the water of frame number `frame`, which is the next one.
  void put(long frame, const Model& model);
  /// Keeps the data of `frames` frames; the last of them has so many blocks.
  void truncate(long frames, hsize_t blocks);

 private:
  struct Lists {
    hdf5::Column corner;  ///< (r) where the side of each part begins, from 0
    hdf5::Column part;    ///< (r, 4) t0, t1 [-], p0, p1 [F/L^2] of WetPart
    hdf5::Column point;   ///< (w, 2) [L] of the tables
    /// (s, 2) of each frame: first row and number of rows of the parts, of the points
    hdf5::Column parts_of_frame, points_of_frame;
  };
  template <class Make> static Lists visit(const Make& make);
  void put_lists(long frame, const Model& model);
  void remove_lists();

  LateColumn<double> forces_;
  hid_t own_;
  std::optional<Lists> lists_;
};

/// Returns the water table as a line of points, [L], from the left to the right, as
/// long as three times the width of the blocks; none without a table.
std::vector<Vec2> water_line(const Model& model);

}  // namespace blocks::output
