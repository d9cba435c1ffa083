#include "common_options.hpp"

#include <CLI/CLI.hpp>

namespace blocks::apps {

void add_units_option(CLI::App& command, std::string& units) {
  command.add_option("--units", units,
                     "units of length, mass and time, such as m,kg,s: values are "
                     "converted if the deck has a UNITS card, otherwise the units are "
                     "only named");
}

draw::PageSize FigureSize::page() const {
  return size.empty() ? draw::PageSize::on_screen(width)
                      : draw::PageSize::in_print(size);
}

void add_size_options(CLI::App& command, FigureSize& size) {
  auto* width =
      command
          .add_option("--width", size.width, "width of a figure, in pixels or points")
          ->check(CLI::Range(100, 20000));
  command.add_option("--size", size.size, draw::PageSize::help())->excludes(width);
}

}  // namespace blocks::apps
