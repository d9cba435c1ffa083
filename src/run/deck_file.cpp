#include "run/deck_file.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "output/results.hpp"

namespace blocks::run {

std::string read_deck(const std::string& path) {
  if (path == "-")
    return {std::istreambuf_iterator<char>(std::cin), {}};
  if (std::filesystem::is_directory(path))
    throw output::FileError("cannot read " + path + ": it is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw output::FileError("cannot read " + path + ": " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string output_name(const std::string& deck, const std::string& given) {
  const std::string stem =
      deck == "-" ? "blocks" : std::filesystem::path(deck).stem().string();
  if (given.ends_with('/'))  // a folder
    return given + stem;
  return given.empty() ? stem : given;
}

std::string deck_folder(const std::string& deck) {
  return deck == "-" ? std::string()
                     : std::filesystem::path(deck).parent_path().string();
}

std::string beside(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace blocks::run
