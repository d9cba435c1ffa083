#include "output/results_joints.hpp"

#include <algorithm>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr const char *data = "PointData/Joint", *group_of_offsets = "PointDataOffsets",
                     *offsets = "PointDataOffsets/Joint";
constexpr hsize_t offsets_per_chunk = 256;

void remove(hid_t group, const char* name) {
  hdf5::check(H5Ldelete(group, name, H5P_DEFAULT));
}

}  // namespace

void JointColumn::open() {
  if (!hdf5::exists(vtk_, data))
    return;
  if (!hdf5::exists(steps_, group_of_offsets) || !hdf5::exists(steps_, offsets)) {
    remove(vtk_, data);  // the frame that added it was interrupted
    return;
  }
  Column ids = Column::open(vtk_, data), places = Column::open(steps_, offsets);
  if (ids.width() != 1 || places.width() != 1)
    throw hdf5::Failure("Joint has the wrong shape");
  column_.emplace(std::move(ids), std::move(places));
}

void JointColumn::put(long frame, const std::vector<int>& ids) {
  const auto corners = static_cast<hsize_t>(ids.size());
  if (!column_) {
    if (std::all_of(ids.begin(), ids.end(), [](int id) { return id == 0; }))
      return;
    column_.emplace(Column(vtk_, data, H5T_NATIVE_INT, 0, chunk_rows(corners)),
                    Column(steps_, offsets, H5T_NATIVE_INT64, 0, offsets_per_chunk));
    if (frame > 0)  // corners are never removed, so no earlier frame has more
      column_->start_late<int>(frame, corners);
  }
  column_->put(frame, corners, as_stored(ids.data()));
}

void JointColumn::truncate(long frames, hsize_t corners) {
  if (!column_)
    return;
  if (column_->frames() >= static_cast<hsize_t>(frames)) {
    column_->truncate(frames, corners);
    return;
  }
  column_.reset();  // the frame that added it was interrupted
  remove(vtk_, data);
  remove(steps_, offsets);
}

}  // namespace blocks::output
