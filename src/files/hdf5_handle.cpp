#include "files/hdf5_handle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <new>

#include "files/ordered_file.hpp"

namespace blocks::hdf5 {
namespace {

herr_t take_first(unsigned depth, const H5E_error2_t* entry, void* text) {
  if (depth != 0 || entry->desc == nullptr)
    return 0;
  try {
    *static_cast<std::string*>(text) = entry->desc;
  } catch (const std::bad_alloc&) {  // no exception may pass through HDF5
    return -1;
  }
  return 0;
}

/// Returns the reason if the text of HDF5 means a file without its end; otherwise
/// empty. HDF5 counts the end from the start of its data, after the user block.
std::string truncation(const std::string& text) {
  unsigned long long end = 0, start = 0, whole = 0;
  return std::sscanf(text.c_str(),
                     "truncated file: eof = %llu, sblock->base_addr = %llu, stored_eof "
                     "= %llu",
                     &end, &start, &whole) == 3
             ? truncated(start + end, whole)
             : std::string();
}

Handle property_list(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

Handle file_access(bool writable) {
  // Failures become exceptions, so the library must not print them.
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Handle access = property_list(H5P_FILE_ACCESS);
  check(H5Pset_file_locking(access.get(), 0, 1));
  if (writable)
    write_in_order(access.get());
  return access;
}

Handle link_creation() {
  Handle links = property_list(H5P_LINK_CREATE);
  check(H5Pset_create_intermediate_group(links.get(), 1));
  return links;
}

Handle text_type(std::size_t length, H5T_cset_t characters) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  check(H5Tset_size(type.get(), std::max<std::size_t>(length, 1)));
  check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
  check(H5Tset_cset(type.get(), characters));
  return type;
}

/// Throws Failure if a dataset claims more values than the file has bytes. A damaged or
/// fabricated file thus cannot cause large allocations or long loops.
void expect_in_file(hid_t object, const std::string& name, hsize_t values) {
  const Handle file(H5Iget_file_id(object), H5Fclose);
  hsize_t bytes = 0;
  check(H5Fget_filesize(file.get(), &bytes));
  if (values > bytes)
    throw Failure(name + " is longer than the file");
}

/// Throws Failure if the path leads to another place or file. HDF5 would open that
/// file, and wait for ever if it is a FIFO. Files of BLOCKS have no such links.
void expect_no_links(hid_t parent, const std::string& path) {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = path.find('/', end + 1);
    const std::string part = path.substr(0, end);
    H5L_info_t link;
    if (H5Lget_info(parent, part.c_str(), &link, H5P_DEFAULT) < 0)
      return;  // opening it reports the reason
    if (link.type != H5L_TYPE_HARD)
      throw Failure(part + " is a link to another place or file");
  }
}

/// Opens a dataset whose values are in this file.
Handle open_dataset(hid_t parent, const std::string& path) {
  expect_no_links(parent, path);
  Handle dataset = [&] {
    try {
      return Handle(H5Dopen2(parent, path.c_str(), H5P_DEFAULT), H5Dclose);
    } catch (const Failure& fault) {
      throw Failure(path + ": " + fault.what());
    }
  }();
  const Handle creation(H5Dget_create_plist(dataset.get()), H5Pclose);
  if (H5Pget_layout(creation.get()) == H5D_VIRTUAL ||
      H5Pget_external_count(creation.get()) != 0)
    throw Failure(path + " is stored in another file");
  return dataset;
}

/// The rows per chunk of a dataset; 1 if it is not chunked.
hsize_t rows_of_chunk(hid_t dataset) {
  const Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  hsize_t chunk[2] = {1, 1};
  if (H5Pget_layout(creation.get()) == H5D_CHUNKED)
    check(H5Pget_chunk(creation.get(), 2, chunk));
  return std::max<hsize_t>(chunk[0], 1);
}

void expect_one(const Handle& space, const std::string& name) {
  if (H5Sget_simple_extent_npoints(space.get()) != 1)
    throw Failure(name + " is not one value");
}

void expect_number(const Handle& type, const std::string& name) {
  const H5T_class_t kind = H5Tget_class(type.get());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Tget_size(type.get()) > 8)
    throw Failure(name + " has no numbers");
}

/// Reads the stored text without its padding.
template <class Read>
std::string fetch_text(hid_t object, const std::string& name, const Handle& type,
                       const Handle& space, Read&& read) {
  if (H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0)
    throw Failure(name + " is not a text");
  expect_one(space, name);
  expect_in_file(object, name, H5Tget_size(type.get()));
  std::string text(H5Tget_size(type.get()), '\0');
  check(read(text.data()));
  const auto end = text.find_last_not_of('\0');
  text.resize(end == std::string::npos ? 0 : end + 1);
  return text;
}

}  // namespace

std::string truncated(std::uint64_t bytes, std::uint64_t whole) {
  return fmt::format("it is truncated, it has {} of {} bytes; copy it again or repeat "
                     "the run",
                     bytes, whole);
}

std::string last_error() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &text);
  // The description reads "unable to open file: name = 'x', errno = 2, error message =
  // 'No such file...', ...".
  const std::string mark = "error message = '";
  if (const auto start = text.find(mark); start != std::string::npos) {
    const auto from = start + mark.size();
    return text.substr(from, text.find('\'', from) - from);
  }
  if (std::string reason = truncation(text); !reason.empty())
    return reason;
  return text.empty() ? "unknown HDF5 error" : text;
}

Handle create_file(const std::string& path, hsize_t user_block) {
  const Handle access = file_access(true), creation = property_list(H5P_FILE_CREATE);
  check(H5Pset_userblock(creation.get(), user_block));
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()),
          H5Fclose};
}

Handle open_file(const std::string& path, bool writable) {
  std::error_code ignored;
  const auto there = std::filesystem::status(path, ignored);
  if (std::filesystem::is_fifo(there) || std::filesystem::is_character_file(there))
    throw Failure("it is not a regular file");  // opening it may never end
  const Handle access = file_access(writable);
  return {H5Fopen(path.c_str(), writable ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access.get()),
          H5Fclose};
}

Handle create_group(hid_t parent, const std::string& path) {
  const Handle links = link_creation();
  return {H5Gcreate2(parent, path.c_str(), links.get(), H5P_DEFAULT, H5P_DEFAULT),
          H5Gclose};
}

Handle open_group(hid_t parent, const std::string& path) {
  expect_no_links(parent, path);
  return {H5Gopen2(parent, path.c_str(), H5P_DEFAULT), H5Gclose};
}

bool exists(hid_t parent, const std::string& name) {
  expect_no_links(parent, name);
  return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

namespace {

template <class T> void put_attribute(hid_t object, const std::string& name, T value) {
  Handle attribute;
  if (H5Aexists(object, name.c_str()) > 0) {
    attribute = Handle(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  } else {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    attribute = Handle(H5Acreate2(object, name.c_str(), type_of<T>(), space.get(),
                                  H5P_DEFAULT, H5P_DEFAULT),
                       H5Aclose);
  }
  check(H5Awrite(attribute.get(), type_of<T>(), &value));
}

template <class T> T get_attribute(hid_t object, const std::string& name) {
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  expect_one(space, name);
  expect_number(type, name);
  T value = 0;
  check(H5Aread(attribute.get(), type_of<T>(), &value));
  return value;
}

}  // namespace

void write_attribute(hid_t object, const std::string& name, std::int64_t value) {
  put_attribute(object, name, value);
}
std::int64_t read_attribute(hid_t object, const std::string& name) {
  return get_attribute<std::int64_t>(object, name);
}
void write_real_attribute(hid_t object, const std::string& name, double value) {
  put_attribute(object, name, value);
}
double read_real_attribute(hid_t object, const std::string& name) {
  return get_attribute<double>(object, name);
}

void write_text_attribute(hid_t object, const std::string& name,
                          const std::string& value) {
  const Handle type = text_type(value.size(), H5T_CSET_ASCII);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), type.get(), space.get(),
                                    H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  check(H5Awrite(attribute.get(), type.get(), value.data()));
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  return fetch_text(object, name, type, space, [&](char* text) {
    return H5Aread(attribute.get(), type.get(), text);
  });
}

void write_text(hid_t parent, const std::string& path, const std::string& text) {
  // An empty text is stored as one padding byte.
  const Handle type = text_type(text.size(), H5T_CSET_UTF8), links = link_creation();
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle dataset(H5Dcreate2(parent, path.c_str(), type.get(), space.get(),
                                  links.get(), H5P_DEFAULT, H5P_DEFAULT),
                       H5Dclose);
  check(
      H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
}

std::string read_text(hid_t parent, const std::string& path) {
  const Handle dataset = open_dataset(parent, path);
  const Handle type(H5Dget_type(dataset.get()), H5Tclose);
  const Handle space(H5Dget_space(dataset.get()), H5Sclose);
  return fetch_text(dataset.get(), path, type, space, [&](char* text) {
    return H5Dread(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text);
  });
}

Column::Column(hid_t parent, const std::string& path, hid_t type, hsize_t width,
               hsize_t chunk_rows, bool checked)
    : path_(path), width_(width), chunk_rows_(chunk_rows) {
  const int rank = width == 0 ? 1 : 2;
  const hsize_t start[2] = {0, width}, limit[2] = {H5S_UNLIMITED, width};
  const hsize_t chunk[2] = {chunk_rows, width};
  const Handle space(H5Screate_simple(rank, start, limit), H5Sclose);
  const Handle creation = property_list(H5P_DATASET_CREATE), links = link_creation();
  check(H5Pset_chunk(creation.get(), rank, chunk));
  if (checked)
    check(H5Pset_fletcher32(creation.get()));
  dataset_ = Handle(H5Dcreate2(parent, path.c_str(), type, space.get(), links.get(),
                               creation.get(), H5P_DEFAULT),
                    H5Dclose);
}

Column Column::open(hid_t parent, const std::string& path) {
  Column column;
  column.path_ = path;
  column.dataset_ = open_dataset(parent, path);
  const Handle space(H5Dget_space(column.dataset_.get()), H5Sclose);
  expect_number(Handle(H5Dget_type(column.dataset_.get()), H5Tclose), path);
  const int rank = check(H5Sget_simple_extent_ndims(space.get()));
  if (rank < 1 || rank > 2)
    throw Failure(path + " has the wrong shape");
  hsize_t extent[2] = {0, 1};
  check(H5Sget_simple_extent_dims(space.get(), extent, nullptr));
  constexpr hsize_t max = std::numeric_limits<hsize_t>::max();
  if (extent[1] < 1)
    throw Failure(path + " has the wrong shape");
  expect_in_file(column.dataset_.get(), path,
                 extent[0] > max / extent[1] ? max : extent[0] * extent[1]);
  column.rows_ = extent[0];
  column.width_ = rank == 2 ? extent[1] : 0;
  column.chunk_rows_ = rows_of_chunk(column.dataset_.get());
  return column;
}

void Column::require(hsize_t row, hsize_t count) const {
  if (row > rows_ || count > rows_ - row)
    throw Failure(path_ + " is too short");
}

void Column::resize(hsize_t rows) {
  const hsize_t extent[2] = {rows, width_};
  check(H5Dset_extent(dataset_.get(), extent));
  rows_ = rows;
}

void Column::truncate(hsize_t rows) {
  require(rows, 0);
  if (rows < rows_)
    resize(rows);
}

void Column::transfer(hsize_t row, hsize_t count, hid_t type, const void* from,
                      void* into) {
  if (count == 0)
    return;
  if (from != nullptr && row + count > rows_)
    resize(row + count);
  const int rank = width_ == 0 ? 1 : 2;
  const hsize_t start[2] = {row, 0}, size[2] = {count, width_};
  const Handle in_file(H5Dget_space(dataset_.get()), H5Sclose);
  check(H5Sselect_hyperslab(in_file.get(), H5S_SELECT_SET, start, nullptr, size,
                            nullptr));
  const Handle in_memory(H5Screate_simple(rank, size, nullptr), H5Sclose);
  check(from != nullptr ? H5Dwrite(dataset_.get(), type, in_memory.get(), in_file.get(),
                                   H5P_DEFAULT, from)
                        : H5Dread(dataset_.get(), type, in_memory.get(), in_file.get(),
                                  H5P_DEFAULT, into));
}

}  // namespace blocks::hdf5
