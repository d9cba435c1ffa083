// The water in NAME.vtkhdf: PointData/WaterPressure, CellData/WaterForce and
// /BLOCKS/water.
#pragma once

#include <optional>

#include "model/model.hpp"
#include "output/results_late_columns.hpp"

namespace blocks::output {

/// The pressure of water at both ends of the side that begins at each point, its force
/// on each block, and the water table of each frame as a line. They are absent as long
/// as there is no water.
class WaterColumns {
 public:
  /// vtk, steps, own: the groups /VTKHDF, /VTKHDF/Steps and /BLOCKS, which stay open.
  WaterColumns(hid_t vtk, hid_t steps, hid_t own)
      : pressures_(vtk, steps, "PointData", "WaterPressure", 2),
        forces_(vtk, steps, "CellData", "WaterForce", 3), own_(own) {}

  /// Opens the data of a file if it has them. Throws hdf5::Failure if their shape is
  /// wrong.
  void open();
  /// Writes the water of frame number `frame`, which is the next one.
  void put(long frame, const Model& model);
  /// Keeps the data of `frames` frames; the last of them has so many blocks and
  /// corners.
  void truncate(long frames, hsize_t blocks, hsize_t corners);

 private:
  struct Table {
    hdf5::Column points;        ///< [L] (w, 2)
    hdf5::Column first, count;  ///< (s) of each frame
  };
  template <class Make> static Table visit(const Make& make);
  void put_table(long frame, const Model& model);
  void remove_table();

  LateColumn<double> pressures_, forces_;
  hid_t own_;
  std::optional<Table> table_;
};

/// Returns the water table as a line of points, [L], from the left to the right, as
/// long as three times the width of the blocks; none without a table.
std::vector<Vec2> water_line(const Model& model);

}  // namespace blocks::output
