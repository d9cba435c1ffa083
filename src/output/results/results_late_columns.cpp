#include "output/results/results_late_columns.hpp"

#include <algorithm>

namespace blocks::output {
namespace {

using hdf5::Column;

constexpr hsize_t offsets_per_chunk = 256;

void remove(hid_t group, const std::string& name) {
  hdf5::check(H5Ldelete(group, name.c_str(), H5P_DEFAULT));
}

template <class T> hid_t stored_type();
template <> hid_t stored_type<int>() { return H5T_NATIVE_INT; }
template <> hid_t stored_type<double>() { return H5T_NATIVE_DOUBLE; }

}  // namespace

template <class T> void LateColumn<T>::open() {
  if (!hdf5::exists(vtk_, data_))
    return;
  if (!hdf5::exists(steps_, group_of_offsets_) || !hdf5::exists(steps_, offsets_)) {
    remove(vtk_, data_);  // the frame that added it was interrupted
    return;
  }
  Column values = Column::open(vtk_, data_), places = Column::open(steps_, offsets_);
  if (values.width() != width_ || places.width() != 1)
    throw hdf5::Failure(data_ + " has the wrong shape");
  column_.emplace(std::move(values), std::move(places));
}

template <class T> void LateColumn<T>::put(long frame, const std::vector<T>& values) {
  const auto rows = static_cast<hsize_t>(values.size()) / width_;
  if (!column_) {
    if (std::all_of(values.begin(), values.end(),
                    [](T value) { return value == T(0); }))
      return;
    column_.emplace(Column(vtk_, data_, stored_type<T>(), width_ == 1 ? 0 : width_,
                           chunk_rows(rows)),
                    Column(steps_, offsets_, H5T_NATIVE_INT64, 0, offsets_per_chunk));
    if (frame > 0)  // blocks keep their rows, so no earlier frame has more
      column_->template start_late<T>(frame, rows, width_);
  }
  column_->put(frame, rows, as_stored(values.data(), width_));
}

template <class T> void LateColumn<T>::truncate(long frames, hsize_t rows) {
  if (!column_)
    return;
  if (column_->frames() >= static_cast<hsize_t>(frames)) {
    column_->truncate(frames, rows);
    return;
  }
  column_.reset();  // the frame that added it was interrupted
  remove(vtk_, data_);
  remove(steps_, offsets_);
}

template class LateColumn<int>;
template class LateColumn<double>;

}  // namespace blocks::output
