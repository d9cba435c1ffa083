#include "run/support/deck_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <variant>

#include "files/file_tools.hpp"
#include "files/fnv1a.hpp"

namespace blocks::run {
namespace {

/// Whether the path is a stream that the shell has opened for this program, such as
/// standard input or <(COMMAND), which may be a pipe.
bool is_open_stream(const std::string& path) {
  return path == "/dev/stdin" || path.starts_with("/dev/fd/") ||
         path.starts_with("/proc/self/fd/");
}

}  // namespace

std::string read_deck(const std::string& path) {
  if (path == "-")
    return {std::istreambuf_iterator<char>(std::cin), {}};
  if (!is_open_stream(path) || std::filesystem::is_directory(path))
    files::expect_regular(path);
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw files::FileError("cannot read " + path + ": " + std::strerror(errno));
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

std::string file_sums(const deck::Deck& deck, const std::string& folder,
                      const std::string& tape9) {
  std::string lines;
  const auto add = [&](const char* card, deck::SourceLocation where, const char* what,
                       const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
      return;  // reading the file reports the error
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    files::Fnv1a sum;
    sum.add(bytes.data(), bytes.size());
    lines += fmt::format("{} in line {}: {} of fnv1a {}\n", card, where.line, what,
                         sum.text());
  };
  for (const deck::Command& command : deck.commands) {
    if (const auto* card = std::get_if<deck::Read9>(&command.card))
      add("READ9", command.where, "a mesh", mesh_path(*card, folder, tape9));
    const auto* cut = std::get_if<deck::Cut>(&command.card);
    if (cut != nullptr && cut->outline.file.given)
      add("OUTLINE", cut->outline.where, "an outline",
          beside(folder, cut->outline.file.value));
    for (std::size_t i = 0; cut != nullptr && i < cut->joints.size(); ++i) {
      if (const auto* traces = std::get_if<deck::Traces>(&cut->joints[i]))
        add("TRACES", traces->where, "traces", beside(folder, traces->file.value));
      const auto* cells = std::get_if<deck::Voronoi>(&cut->joints[i]);
      if (cells != nullptr && cells->file.given)
        add("VORONOI", cells->where, "points", beside(folder, cells->file.value));
    }
  }
  return lines;
}

bool holds_file_sums(std::string_view text) {
  for (const char* card : {"READ9 ", "OUTLINE ", "TRACES ", "VORONOI "})
    if (text.starts_with(card))
      return true;
  return false;
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
