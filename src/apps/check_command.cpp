#include "check_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <ranges>

#include "post/figure.hpp"
#include "run/geometry_report.hpp"

namespace blocks::apps {
namespace {

post::Frame frame_of(const Blocks& blocks) {
  post::Frame frame;
  for (int b = 0; b < blocks.size(); ++b) {
    frame.outlines.push_back(blocks.outline(b));
    frame.number.push_back(b + 1);
    frame.fixed.push_back(blocks.is_free(b) ? 0 : 1);
  }
  frame.material = blocks.material;
  frame.centroid = blocks.centroid;
  return frame;
}

/// The same places that the text lists.
std::vector<post::Mark> marks_of(const run::GeometryReport& report) {
  using Kind = post::Mark::Kind;
  constexpr std::size_t most = 10;
  std::vector<post::Mark> marks;
  for (const auto& place : report.aspect.worst)
    marks.push_back({Kind::slender, place.at, {}, {place.block}});
  for (const auto& place : report.angle.worst)
    marks.push_back({Kind::angle, place.at, {}, {}});
  const auto& slits = report.joints.slits;
  for (const auto& slit : slits | std::views::take(static_cast<std::ptrdiff_t>(
                                      std::min(most, report.gaps()))))
    marks.push_back({Kind::gap, slit.place, {}, {}});
  for (const auto& pair : report.certificate.overlaps)
    marks.push_back({Kind::overlap,
                     pair.place,
                     report.certificate.overlaps.size() <= most
                         ? fmt::format("{} and {}: area {:.3g}", pair.first + 1,
                                       pair.second + 1, pair.area)
                         : std::string(),
                     {pair.first, pair.second}});
  return marks;
}

void draw(const std::string& path, const Model& model,
          const run::GeometryReport& report) {
  const post::Frame frame = frame_of(model.blocks);
  post::FigureOptions options;
  options.marks = marks_of(report);
  options.subtitle = verdict(report.certificate);
  // Drawn first, so that a wrong name costs nobody an older figure.
  const std::string ending = std::filesystem::path(path).extension().string();
  const std::string fresh = path + ".new" + ending;
  post::draw_frame(fresh, frame, frame, model.settings.title, options);
  std::error_code fault;
  if (std::filesystem::is_regular_file(path, fault))
    std::filesystem::rename(path, path + ".bak", fault);
  std::filesystem::rename(fresh, path);
}

}  // namespace

void add_geometry_options(CLI::App& command, GeometryOptions& options) {
  auto* report = command.add_flag("--geometry", options.report,
                                  "report shapes, overlaps, gaps and joints of the "
                                  "blocks; exit 3 when blocks overlap");
  command.add_flag("--json", options.json, "the report on the geometry as JSON")
      ->needs(report);
  command
      .add_option("--plot", options.plot,
                  "draw the blocks with the places of the report: .png, .svg or .pdf")
      ->needs(report);
}

int check(const run::RunOptions& options, const GeometryOptions& geometry) {
  if (!geometry.report)
    return run::check_deck(options);
  const auto checked = run::build_checked(options);
  if (checked.code != run::done)
    return checked.code;
  const auto report = run::examine_geometry(checked.file, checked.model);
  if (!options.quiet)
    fmt::print("{}", geometry.json ? run::json(report) : run::text(report));
  if (!geometry.plot.empty()) {
    try {
      draw(geometry.plot, checked.model, report);
    } catch (const std::exception& error) {
      fmt::print(stderr, "blocks: error: {}\n", error.what());
      return run::file_error;
    }
  }
  return report.certificate.holds() ? run::done : run::deck_error;
}

}  // namespace blocks::apps
