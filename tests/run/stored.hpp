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

/// All the run NAME left in the folder, by file and item; what names the run and its
/// clock is left out.
std::map<std::string, std::string> left_by_run(const std::filesystem::path& folder,
                                               const std::string& name);

/// Tests that both runs left the same. how: for messages.
void expect_same(const std::map<std::string, std::string>& found,
                 const std::map<std::string, std::string>& wanted,
                 const std::string& how);

/// A deck with layers, loads and cards between its motions.
extern const std::string layers_and_loads;

}  // namespace blocks::testing
