#include "tools/stored.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <vector>

#include "files/hdf5_handle.hpp"
#include "tools/program.hpp"

namespace blocks::testing {
namespace {

using hdf5::check;
using hdf5::Handle;
using Contents = std::map<std::string, std::string>;

/// Returns the shape and the bytes that `read` fills in.
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
  const Handle handle = hdf5::open_file(file.string(), false);
  EXPECT_GE(H5Ovisit(handle.get(), H5_INDEX_NAME, H5_ITER_INC, visit_object, &contents),
            0)
      << file;
  return contents;
}

std::map<std::string, std::string> left_by_run(const std::filesystem::path& folder,
                                               const std::string& name) {
  std::map<std::string, std::string> all;
  all["listing"] = slurp(folder / (name + ".out"));
  for (const auto& [item, value] : stored(folder / (name + ".vtkhdf")))
    if (item != "BLOCKS/run_id" && item != "BLOCKS/continues_run")
      all["results " + item] = value;
  for (const auto& [item, value] : stored(folder / (name + ".ckpt.h5")))
    if (item != "run/results_run")
      all["checkpoint " + item] = value;
  auto told = nlohmann::json::parse(slurp(folder / (name + ".summary.json")));
  for (const char* key : {"wall_seconds", "certificate"})
    told.erase(key);
  all["summary"] = told.dump(1);
  return all;
}

void expect_same(const std::map<std::string, std::string>& found,
                 const std::map<std::string, std::string>& wanted,
                 const std::string& how) {
  for (const auto& [item, value] : found)
    EXPECT_TRUE(wanted.contains(item)) << how << ": " << item << " is new";
  for (const auto& [item, value] : wanted) {
    const auto at = found.find(item);
    ASSERT_TRUE(at != found.end()) << how << ": no " << item;
    EXPECT_TRUE(at->second == value) << how << ": " << item << " differs";
  }
}

const std::string layers_and_loads =
    preliminary("SEED, 3\nFUNCTION, 3\n0, 0\n0.05, 1\n0.3, 0\n") +
    rectangle(-9, -2, 9, -1, true) +
    "ORIENT, -15, 15\nMERGE, 0.5\nLAYER, -20, 1, -8,-1, -8,0, 8,0, 8,-1, RANDOM\n"
    "SPLANE, -8, 5, -8, -5\nGRAVITY, 0, -9.81\nFRICTN, 0.4\nDAMPING, 0.3\n"
    "PLOTS, 0.01\nOUTPUT, 0.03, 2, 3\nPRESSBC, 2, 1, 1.E4, 2.E4, 0.01\nMOTION, 0.06\n"
    "DUMP\nLAYER, -20, 2, -8,1, -8,2, 8,2, 8,1, RANDOM\nFORCE, 25, 1.E3, 2.E3, 0.1\n"
    "SETVELM, 2, 0.3, -1, 0\nCYCLE, 70\nSETVEL, 3, 5, 60, 60, 0\nMOTION, 0.1\nSTOP\n";

}  // namespace blocks::testing
