// Two blocks to draw, and a folder for the figures.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "post/read/results_reader.hpp"

namespace blocks::post {

/// Returns two unit squares side by side, of materials 1 and 2. The second one is
/// fixed.
inline Frame two_squares() {
  Frame frame;
  frame.outlines = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}, {{1, 0}, {1, 1}, {2, 1}, {2, 0}}};
  frame.number = {1, 2};
  frame.material = {1, 2};
  frame.fixed = {0, 1};
  frame.centroid = (Eigen::Matrix2Xd(2, 2) << 0.5, 1.5, 0.5, 0.5).finished();
  frame.velocity = (Eigen::Matrix2Xd(2, 2) << 3, 0, 4, 0).finished();
  frame.angle = Eigen::Vector2d(0.1, -0.2);
  frame.spin = Eigen::Vector2d::Zero();
  frame.stress = Eigen::Matrix4Xd::Zero(4, 2);
  frame.stress.col(0) << 3, 1, 1, 3;
  return frame;
}

/// A new temporary folder. The destructor removes it.
class Folder {
 public:
  Folder() { std::filesystem::create_directories(path_); }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("blocks_figure_" + std::to_string(getpid()));
};

/// Reads the whole file.
inline std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace blocks::post
