// The columns of NAME.vtkhdf, written frame by frame. Cell data that do not change are
// stored once; the offsets of later frames refer to them.
#pragma once

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "files/hdf5_handle.hpp"

namespace blocks::output {

/// Returns the rows per chunk, from the rows per frame. A large frame fills whole
/// chunks; small frames share one.
inline hsize_t chunk_rows(hsize_t rows) {
  constexpr hsize_t min = 256, max = 16384;
  if (rows == 0)
    return min;
  if (rows < min)
    return rows * ((min + rows - 1) / rows);
  const hsize_t chunks = (rows + max - 1) / max;
  return (rows + chunks - 1) / chunks;
}

/// The number of rows assembled, compared and written at a time. It bounds the memory
/// that a frame needs, for any size of the model.
constexpr hsize_t rows_at_once = 16384;

/// A source of rows that are in memory as they are written, with `width` values each.
template <class T> auto as_stored(const T* values, std::size_t width = 1) {
  return [=](hsize_t first, hsize_t) { return values + first * width; };
}

/// A source of rows of one value, value(row), computed when they are written.
template <class T, class Value> auto made_of(Value value) {
  return [value, made = std::vector<T>()](hsize_t first, hsize_t count) mutable {
    made.clear();
    for (hsize_t row = first; row < first + count; ++row)
      made.push_back(static_cast<T>(value(row)));
    return static_cast<const T*>(made.data());
  };
}

/// Calls act(first, count) for successive pieces of the rows until it returns false.
/// Returns whether all calls returned true. The rows are those of a column from `at`
/// on. No piece divides a chunk, so that no chunk is written twice.
template <class Act>
bool piece_by_piece(const hdf5::Column& column, hsize_t at, hsize_t rows, Act&& act) {
  for (hsize_t first = 0, next; first < rows; first = next) {
    const hsize_t end = at + first + rows_at_once, beyond = end % column.chunk_rows();
    next = std::min(rows, end - (beyond < rows_at_once ? beyond : 0) - at);
    if (!act(first, next - first))
      return false;
  }
  return true;
}

/// Writes rows from `at` on. source(first, count) returns their values, which are valid
/// until the next call.
template <class Source>
void put_rows(hdf5::Column& column, hsize_t at, hsize_t rows, Source&& source) {
  piece_by_piece(column, at, rows, [&](hsize_t first, hsize_t count) {
    column.put(at + first, source(first, count), count);
    return true;
  });
}

/// Whether the rows from `at` on equal those of the source, bit for bit.
template <class Source>
bool has_rows(hdf5::Column& column, hsize_t at, hsize_t rows, Source&& source) {
  return piece_by_piece(column, at, rows, [&](hsize_t first, hsize_t count) {
    const auto* values = source(first, count);
    using Value = std::remove_cvref_t<decltype(*values)>;
    const std::vector<Value> stored = column.read<Value>(at + first, count);
    return std::memcmp(stored.data(), values, stored.size() * sizeof(Value)) == 0;
  });
}

/// A column of data with one offset per frame. Rows that do not change are written
/// once: block numbers, masses, the stress of rigid blocks. Changes are detected by
/// comparison with the file.
class FrameColumn {
 public:
  FrameColumn(hdf5::Column data, hdf5::Column offsets)
      : data_(std::move(data)), offsets_(std::move(offsets)) {}

  template <class Source> void put(long frame, hsize_t rows, Source&& source) {
    const bool same = offset_ >= 0 && rows_ == rows &&
                      has_rows(data_, static_cast<hsize_t>(offset_), rows, source);
    if (!same) {
      offset_ = -1;  // remains -1 if writing fails
      const hsize_t end = data_.rows();
      put_rows(data_, end, rows, source);
      rows_ = rows;
      offset_ = static_cast<std::int64_t>(end);
    }
    offsets_.put(static_cast<hsize_t>(frame), &offset_, 1);
  }

  /// Makes up for a column that begins after `frames` frames: writes `rows` rows of
  /// `width` zeros, to which all these frames refer.
  template <class T> void start_late(long frames, hsize_t rows, hsize_t width = 1) {
    const std::vector<T> zeros(rows * width, T(0));
    put_rows(data_, 0, rows, as_stored(zeros.data(), width));
    rows_ = rows;
    offset_ = 0;
    const std::int64_t zero = 0;
    for (long frame = 0; frame < frames; ++frame)
      offsets_.put(static_cast<hsize_t>(frame), &zero, 1);
  }

  /// The number of frames that have an offset.
  hsize_t frames() const { return offsets_.rows(); }

  /// Keeps the data of `frames` frames; the last of them has `rows` rows.
  void truncate(long frames, hsize_t rows) {
    const auto kept = static_cast<hsize_t>(frames);
    offset_ = frames == 0 ? -1 : offsets_.at<std::int64_t>(kept - 1);
    rows_ = rows;
    data_.truncate(offset_ < 0 ? 0 : static_cast<hsize_t>(offset_) + rows);
    offsets_.truncate(kept);
  }

 private:
  hdf5::Column data_, offsets_;
  std::int64_t offset_ = -1;  ///< of the last frame; -1: none
  hsize_t rows_ = 0;          ///< of the last frame
};

}  // namespace blocks::output
