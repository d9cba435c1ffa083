// Everything an HDF5 file holds, as text, so that two files can be compared item by
// item.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace blocks::testing {

/// Path of every dataset -> its type's size, shape and bytes; of every attribute
/// likewise, as PATH@NAME. A failure of the test if the file cannot be read.
std::map<std::string, std::string> stored(const std::filesystem::path& file);

}  // namespace blocks::testing
