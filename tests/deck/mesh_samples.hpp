// Helpers for the tests of the mesh formats of READ9 (docs/mesh-formats.md): temporary
// files, messages of refusals, and binary files.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include "deck/mesh/mesh_readers.hpp"

namespace blocks::deck::testing {

using geometry::Polygon;
using geometry::Vec2;

inline const std::string samples = BLOCKS_SOURCE_DIR "/tests/data/mesh/";

/// Returns the content of a sample file.
inline std::string sample(const std::string& name) {
  std::ifstream in(samples + name, std::ios::binary);
  return {(std::istreambuf_iterator<char>(in)), {}};
}

/// A temporary file. The destructor removes it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() /
              ("blocks_mesh_" + std::to_string(getpid()))) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

inline MeshFile read(const std::string& bytes) {
  const TemporaryFile file(bytes);
  return read_mesh(file.path());
}

/// Returns the message of a refusal without the name of the file, for example ":3:
/// ...",
/// ": record 2: ..." or ": ...".
inline std::string refusal(const std::string& bytes) {
  const TemporaryFile file(bytes);
  try {
    read_mesh(file.path());
  } catch (const MeshError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with(file.path())) << message;
    return message.substr(file.path().size());
  }
  return "read without complaint";
}

inline std::string replaced(std::string text, const std::string& from,
                            const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

/// Records between 4-byte markers, as a Fortran program writes them.
struct FortranFile {
  bool big_endian = false;
  std::size_t integer_width = 4, real_width = 8;
  std::string bytes, record;

  static std::string number(std::uint64_t value, std::size_t width, bool big) {
    std::string text;
    for (std::size_t i = 0; i < width; ++i)
      text += static_cast<char>(value >> 8 * (big ? width - 1 - i : i));
    return text;
  }
  FortranFile& integers(std::initializer_list<long> values) {
    for (const long value : values)
      record += number(static_cast<std::uint64_t>(value), integer_width, big_endian);
    return *this;
  }
  FortranFile& reals(std::initializer_list<double> values) {
    for (const double value : values)
      record += real_width == 4
                    ? number(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4,
                             big_endian)
                    : number(std::bit_cast<std::uint64_t>(value), 8, big_endian);
    return *this;
  }
  FortranFile& text(std::string value, std::size_t length) {
    value.resize(length, ' ');
    record += value;
    return *this;
  }
  FortranFile& end() {
    const std::string marker = number(record.size(), 4, big_endian);
    bytes += marker + record + marker;
    record.clear();
    return *this;
  }
};

/// Returns a GENESIS file with a square and a triangle. Block 5 has an anticlockwise
/// quadrilateral of 8 nodes, block 2 a quadrilateral with a repeated node.
inline FortranFile genesis(bool big = false, std::size_t integers = 4,
                           std::size_t reals = 8, bool version = true) {
  FortranFile file{big, integers, reals, "", ""};
  file.text("A SQUARE AND A TRIANGLE", 80).end();
  file.integers({9, 2, 2, 2, 0, 0, 0, 0, 0});
  if (version)
    file.integers({1});
  file.end();
  file.reals({0, 2, 2, 0, 1, 2, 1, 0, 4}).reals({0, 0, 2, 2, 0, 1, 2, 1, 0.5}).end();
  file.integers({1, 2}).end();
  file.integers({5, 1, 8, 0}).end();
  file.integers({1, 2, 3, 4, 5, 6, 7, 8}).end().reals({0}).end();
  file.integers({2, 1, 4, 1}).end();
  file.integers({2, 9, 3, 3}).end().reals({1}).end();
  for (int set = 0; set < 13; ++set)
    file.integers({0}).end();
  return file;
}

/// Returns region records: two regions that share two nodes, a region of bars between
/// them, and boundary lists. The second region does not repeat the shared nodes.
inline FortranFile regions(bool big = false, std::size_t integers = 4,
                           std::size_t reals = 8) {
  FortranFile file{big, integers, reals, "", ""};
  file.integers({1, 4, 2, 3, 3, 0, 1}).end();
  const double x[] = {0, 1, 1, 0}, y[] = {0, 0, 1, 1};
  for (int i = 0; i < 4; ++i)
    file.integers({101 + i}).reals({x[i], y[i]});
  file.end().integers({101, 102, 103, 104}).end();
  file.integers({101, 102}).end().integers({1, 1, 101}).end();
  file.integers({1, 0, 0, 0, 9, 1, 1}).end().integers({101, 102, 0, 0}).end();
  file.integers({1, 2, 0, 0, 4, 0, 1}).end();
  file.integers({105}).reals({2, 0}).integers({106}).reals({2, 1}).end();
  return file.integers({102, 105, 106, 103}).end();
}

inline const Polygon square_clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
inline const Polygon right_clockwise{{1, 0}, {1, 1}, {2, 1}, {2, 0}};

}  // namespace blocks::deck::testing
