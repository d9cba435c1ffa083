#include "run/stored.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <vector>

#include "output/hdf5_handle.hpp"

namespace blocks::testing {
namespace {

using output::hdf5::check;
using output::hdf5::Handle;
using Contents = std::map<std::string, std::string>;

/// Shape, then the bytes that `read` fills in.
template <class Read> std::string value(hid_t space, hid_t type, Read&& read) {
  const auto points =
      static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space)));
  std::vector<hsize_t> shape(
      static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  std::string text;
  for (const hsize_t extent : shape)
    text += std::to_string(extent) + " ";
  text += "of " + std::to_string(H5Tget_size(type)) + ": ";
  const std::size_t head = text.size();
  text.resize(head + points * H5Tget_size(type));
  if (points > 0)
    check(read(text.data() + head));
  return text;
}

herr_t visit_attribute(hid_t object, const char* name, const H5A_info_t*, void* into) {
  auto& [path, contents] = *static_cast<std::pair<std::string, Contents*>*>(into);
  const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Handle space(H5Aget_space(attribute.get()), H5Sclose);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  (*contents)[path + "@" + name] = value(space.get(), type.get(), [&](char* bytes) {
    return H5Aread(attribute.get(), type.get(), bytes);
  });
  return 0;
}

herr_t visit_object(hid_t file, const char* name, const H5O_info_t* info, void* into) {
  auto* contents = static_cast<Contents*>(into);
  const Handle object(H5Oopen(file, name, H5P_DEFAULT), H5Oclose);
  std::pair<std::string, Contents*> place(name, contents);
  H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_INC, nullptr, visit_attribute,
              &place);
  if (info->type != H5O_TYPE_DATASET)
    return 0;
  const Handle space(H5Dget_space(object.get()), H5Sclose);
  const Handle type(H5Dget_type(object.get()), H5Tclose);
  (*contents)[name] = value(space.get(), type.get(), [&](char* bytes) {
    return H5Dread(object.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes);
  });
  return 0;
}

}  // namespace

std::map<std::string, std::string> stored(const std::filesystem::path& file) {
  Contents contents;
  const Handle handle = output::hdf5::open_file(file.string(), false);
  EXPECT_GE(H5Ovisit(handle.get(), H5_INDEX_NAME, H5_ITER_INC, visit_object, &contents),
            0)
      << file;
  return contents;
}

}  // namespace blocks::testing
