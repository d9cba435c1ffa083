// The content of HDF5 files as text, so that tests can compare files item by item.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace blocks::testing {

/// Returns shape, size of the type and bytes of every dataset by its path, and of every
/// attribute by PATH@NAME. The test fails if the file cannot be read.
std::map<std::string, std::string> stored(const std::filesystem::path& file);

/// Returns all that the run NAME wrote, by file and item, without the identity of the
/// run and its wall clock time.
std::map<std::string, std::string> left_by_run(const std::filesystem::path& folder,
                                               const std::string& name);

/// Requires that both runs wrote the same. `how` describes the runs in messages.
void expect_same(const std::map<std::string, std::string>& found,
                 const std::map<std::string, std::string>& wanted,
                 const std::string& how);

/// The text of a deck with layers, loads and cards between its motions.
extern const std::string layers_and_loads;

}  // namespace blocks::testing
