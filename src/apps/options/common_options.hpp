// Options that several commands have with the same meaning.
#pragma once

#include <CLI/App.hpp>
#include <string>

#include "draw/page_size.hpp"

namespace blocks::apps {

/// Adds --units: the units of length, mass and time in which values are shown.
void add_units_option(CLI::App& command, std::string& units);

/// The size of a figure: `size` in print, "85mm", if it is not empty; otherwise `width`
/// in pixels or points, 100 to 20000.
struct FigureSize {
  double width = 1200;
  std::string size = {};

  /// Throws std::runtime_error if `size` is no size.
  draw::PageSize page() const;
};

/// Adds --width and --size, which exclude each other.
void add_size_options(CLI::App& command, FigureSize& size);

}  // namespace blocks::apps
