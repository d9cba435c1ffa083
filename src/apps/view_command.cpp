#include "view_command.hpp"
#include "fault.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>

#include "apps/options/common_options.hpp"
#include "files/check_outputs.hpp"
#include "files/file_tools.hpp"
#include "post/page/view_page.hpp"
#include "run/run.hpp"

namespace blocks::apps {

void add_view_options(CLI::App& command, ViewOptions& options) {
  command.add_option("FILE", options.file, "results of a run, NAME.vtkhdf")->required();
  command.add_option("-o,--output", options.output,
                     "the page (default: NAME.html, in this folder)");
  command.add_option("--every", options.every, "take every Nth frame, and the last")
      ->check(CLI::Range(1L, 1000000000L));
  command.add_option("--mirror", options.mirror,
                     "also show the other half, mirrored about this x");
  add_units_option(command, options.units);
}

int view(ViewOptions options) {
  try {
    if (options.output.empty())
      options.output = std::filesystem::path(options.file).stem().string() + ".html";
    const std::string ending =
        std::filesystem::path(options.output).extension().string();
    if (ending != ".html" && ending != ".htm")
      throw std::runtime_error("the page's name must end in .html, found '" +
                               options.output + "'");
    if (files::same_file(options.file, options.output))
      throw std::runtime_error(options.file +
                               " would be overwritten: choose another -o NAME");
    if (options.mirror && !std::isfinite(*options.mirror))
      throw std::runtime_error(
          "--mirror needs the x of the symmetry plane of a half model");
    files::check_outputs({options.output});
    post::ResultsReader results(options.file);
    if (!options.units.empty())
      results.show_in(post::parse_units(options.units));
    const std::string page =
        post::view_page(post::view_data(results, options.every, options.mirror));
    files::replace_file_keeping_older(options.output, page);
    const auto size = static_cast<double>(page.size());
    fmt::print("{}: {}, open it in a browser\n", options.output,
               size < 1e6 ? fmt::format("{:.0f} kB", size / 1e3)
                          : fmt::format("{:.1f} MB", size / 1e6));
    return run::done;
  } catch (const std::runtime_error& error) {
    return tell_fault(error);
  }
}

}  // namespace blocks::apps
