#include "run/deck_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <variant>

#include "output/file_tools.hpp"
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

std::string mesh_path(const deck::Read9& card, const std::string& folder,
                      const std::string& tape9) {
  return card.file.given ? beside(folder, card.file.value) : tape9;
}

std::string mesh_sums(const deck::Deck& deck, const std::string& folder,
                      const std::string& tape9) {
  std::string lines;
  for (const deck::Command& command : deck.commands)
    if (const auto* card = std::get_if<deck::Read9>(&command.card)) {
      const std::string path = mesh_path(*card, folder, tape9);
      std::error_code ignored;
      if (!std::filesystem::is_regular_file(path, ignored))
        continue;  // reading the mesh reports the error
      std::ifstream in(path, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(in), {}};
      output::Fnv1a sum;
      sum.add(bytes.data(), bytes.size());
      lines += fmt::format("READ9 in line {}: a mesh of fnv1a {}\n", command.where.line,
                           sum.text());
    }
  return lines;
}

long first_difference(std::string_view one, std::string_view other) {
  const auto [here, there] =
      std::mismatch(one.begin(), one.end(), other.begin(), other.end());
  return 1 + std::count(one.begin(), here, '\n');
}

std::string deck_folder(const std::string& deck) {
  return deck == "-" ? std::string()
                     : std::filesystem::path(deck).parent_path().string();
}

std::string beside(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

}  // namespace blocks::run
