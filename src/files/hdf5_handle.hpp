// A thin layer over the HDF5 C API. Handles close themselves, failures are exceptions
// with the system's reason, and columns grow row by row.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace blocks::hdf5 {

/// An HDF5 error and its reason. The file name is added by the caller.
class Failure : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The reason why a file cannot be read that has only its first `bytes` of `whole`
/// bytes.
std::string truncated(std::uint64_t bytes, std::uint64_t whole);

/// The innermost reason on HDF5's error stack, or the system's error message if it has
/// one.
std::string last_error();

/// Returns the result. Throws Failure if it is negative.
template <class T> T check(T result) {
  if (result < 0)
    throw Failure(last_error());
  return result;
}

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle() = default;
  /// Takes ownership of `id`. Throws Failure if it is not valid.
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(check(id)), close_(closer) {}
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  /// Closes the identifier. Throws Failure on error, because closing a file writes its
  /// last bytes.
  void close() {
    if (id_ >= 0)
      check(close_(std::exchange(id_, -1)));
  }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_ = -1;
  herr_t (*close_)(hid_t) = nullptr;
};

/// The HDF5 type of T, in memory and in the file.
template <class T> hid_t type_of() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_NATIVE_DOUBLE;
  else if constexpr (std::is_same_v<T, std::int64_t>)
    return H5T_NATIVE_INT64;
  else if constexpr (std::is_same_v<T, std::uint64_t>)
    return H5T_NATIVE_UINT64;
  else if constexpr (std::is_same_v<T, int>)
    return H5T_NATIVE_INT;
  else if constexpr (std::is_same_v<T, char>)
    return H5T_NATIVE_CHAR;
  else {
    static_assert(std::is_same_v<T, unsigned char>, "no HDF5 type for it");
    return H5T_NATIVE_UCHAR;
  }
}

/// Objects are only opened if their data are in this file. Links, external storage and
/// virtual datasets, which could lead to any file of the machine, are refused.
///
/// Files are never locked, so that they can be read during a run. Files being written
/// are consistent at every moment (ordered_file.hpp). `user_block` is the number of
/// bytes at the head that HDF5 does not use.
Handle create_file(const std::string& path, hsize_t user_block = 0);
Handle open_file(const std::string& path, bool writable);

Handle create_group(hid_t parent, const std::string& path);
Handle open_group(hid_t parent, const std::string& path);
bool exists(hid_t parent, const std::string& name);

/// Scalar attributes. An existing one is overwritten in place.
void write_attribute(hid_t object, const std::string& name, std::int64_t value);
std::int64_t read_attribute(hid_t object, const std::string& name);
void write_real_attribute(hid_t object, const std::string& name, double value);
double read_real_attribute(hid_t object, const std::string& name);
/// An ASCII string of fixed length, as VTK requires.
void write_text_attribute(hid_t object, const std::string& name,
                          const std::string& value);
std::string read_text_attribute(hid_t object, const std::string& name);

/// A text of any length as a scalar dataset. Missing groups are created.
void write_text(hid_t parent, const std::string& path, const std::string& text);
std::string read_text(hid_t parent, const std::string& path);

/// A dataset that grows in its first dimension: rows of `width` values each.
class Column {
 public:
  Column() = default;
  /// If `width` is 0, the dataset is one-dimensional. `checked` adds a Fletcher-32
  /// checksum to every chunk.
  Column(hid_t parent, const std::string& path, hid_t type, hsize_t width,
         hsize_t chunk_rows, bool checked = false);
  static Column open(hid_t parent, const std::string& path);

  hsize_t rows() const { return rows_; }
  hsize_t width() const { return width_ == 0 ? 1 : width_; }
  /// The number of rows per chunk.
  hsize_t chunk_rows() const { return chunk_rows_; }

  /// Writes `count` rows from `row` on. The dataset grows as needed.
  template <class T> void put(hsize_t row, const T* values, hsize_t count) {
    transfer(row, count, type_of<T>(), values, nullptr);
  }
  /// Reads `count` rows from `row` on. Throws Failure if they do not all exist.
  template <class T> std::vector<T> read(hsize_t row, hsize_t count) {
    require(row, count);
    std::vector<T> values(count * width());
    transfer(row, count, type_of<T>(), nullptr, values.data());
    return values;
  }
  template <class T> T at(hsize_t row) { return read<T>(row, 1).front(); }

  /// Removes the rows from `rows` on. Throws Failure if there are fewer.
  void truncate(hsize_t rows);

 private:
  void require(hsize_t row, hsize_t count) const;
  void resize(hsize_t rows);
  void transfer(hsize_t row, hsize_t count, hid_t type, const void* from, void* into);

  std::string path_;
  Handle dataset_;
  hsize_t rows_ = 0, width_ = 0, chunk_rows_ = 1;
};

}  // namespace blocks::hdf5
