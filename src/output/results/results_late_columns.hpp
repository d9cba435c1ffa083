// Data of points or cells in NAME.vtkhdf that not every model has: joint ids and water.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/results/results_columns.hpp"

namespace blocks::output {

/// `width` numbers of type T for each point or cell. The data are absent as long as all
/// of them are 0, so that files of models without do not depend on them.
template <class T> class LateColumn {
 public:
  /// vtk, steps: the groups /VTKHDF and /VTKHDF/Steps, which stay open. group:
  /// PointData or CellData.
  LateColumn(hid_t vtk, hid_t steps, const std::string& group, const std::string& name,
             hsize_t width = 1)
      : vtk_(vtk), steps_(steps), data_(group + "/" + name),
        group_of_offsets_(group + "Offsets"), offsets_(group_of_offsets_ + "/" + name),
        width_(width) {}

  /// Whether the file has the data.
  bool exists() const { return column_.has_value(); }
  /// Opens the data of a file if it has them. Throws hdf5::Failure if their shape is
  /// wrong.
  void open();
  /// Writes the values, (rows * width), of frame number `frame`, which is the next one.
  /// Values may begin after frames without them; those then have zeros.
  void put(long frame, const std::vector<T>& values);
  /// Keeps the data of `frames` frames; the last of them has `rows` points or cells.
  void truncate(long frames, hsize_t rows);

 private:
  hid_t vtk_, steps_;
  std::string data_, group_of_offsets_, offsets_;
  hsize_t width_;
  std::optional<FrameColumn> column_;
};

extern template class LateColumn<int>;
extern template class LateColumn<double>;

}  // namespace blocks::output
