// The columns of NAME.vtkhdf as frames see them: a column of cell data that repeats
// itself is not written again but found through its offset.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "output/hdf5_handle.hpp"

namespace blocks::output {

/// Rows per frame -> rows per chunk: a frame fills whole chunks, small frames share
/// one.
inline hsize_t chunk_rows(hsize_t rows) {
  constexpr hsize_t least = 256, most = 16384;
  if (rows == 0)
    return least;
  if (rows < least)
    return rows * ((least + rows - 1) / rows);
  const hsize_t chunks = (rows + most - 1) / most;
  return (rows + chunks - 1) / chunks;
}

/// Rows that differ from frame to frame, each frame with an offset. Unchanged rows are
/// written once: block numbers, masses, the stress of rigid blocks.
class FrameColumn {
 public:
  FrameColumn(hdf5::Column data, hdf5::Column offsets)
      : data_(std::move(data)), offsets_(std::move(offsets)) {}

  template <class T> void put(long frame, const T* values, hsize_t rows) {
    const std::size_t bytes = rows * data_.width() * sizeof(T);
    const auto* raw = reinterpret_cast<const unsigned char*>(values);
    const bool same = offset_ >= 0 && last_.size() == bytes &&
                      (bytes == 0 || std::memcmp(last_.data(), raw, bytes) == 0);
    if (!same) {
      offset_ = -1;  // stays so when the writing fails
      const auto offset = static_cast<std::int64_t>(data_.rows());
      data_.put(data_.rows(), values, rows);
      last_.assign(raw, raw + bytes);
      offset_ = offset;
    }
    offsets_.put(static_cast<hsize_t>(frame), &offset_, 1);
  }

  /// Keeps what `frames` frames need; `rows` of the last of them.
  void truncate(long frames, hsize_t rows) {
    const auto kept = static_cast<hsize_t>(frames);
    last_.clear();
    offset_ = frames == 0 ? -1 : offsets_.at<std::int64_t>(kept - 1);
    if (offset_ >= 0)
      last_ = data_.bytes(static_cast<hsize_t>(offset_), rows);
    data_.truncate(offset_ < 0 ? 0 : static_cast<hsize_t>(offset_) + rows);
    offsets_.truncate(kept);
  }

 private:
  hdf5::Column data_, offsets_;
  std::vector<unsigned char> last_;
  std::int64_t offset_ = -1;  ///< -1: nothing to repeat
};

}  // namespace blocks::output
