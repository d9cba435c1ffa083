// The joint ids of sides in NAME.vtkhdf: PointData/Joint.
#pragma once

#include <optional>
#include <vector>

#include "output/results_columns.hpp"

namespace blocks::output {

/// The joint id of the side that begins at each point. The data are absent as long as
/// all ids are 0, so that files of models without joints do not depend on them.
class JointColumn {
 public:
  /// vtk, steps: the groups /VTKHDF and /VTKHDF/Steps, which stay open.
  JointColumn(hid_t vtk, hid_t steps) : vtk_(vtk), steps_(steps) {}

  /// Opens the data of a file if it has them. Throws hdf5::Failure if their shape is
  /// wrong.
  void open();
  /// Writes the ids, (m), of frame number `frame`, which is the next one. Blocks with
  /// ids may be added after frames without them; those then have ids of 0.
  void put(long frame, const std::vector<int>& ids);
  /// Keeps the data of `frames` frames; the last of them has `corners` corners.
  void truncate(long frames, hsize_t corners);

 private:
  hid_t vtk_, steps_;
  std::optional<FrameColumn> column_;
};

}  // namespace blocks::output
