#include "check_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "files/check_outputs.hpp"
#include "model/words/certificate_text.hpp"
#include "post/figure/figure.hpp"
#include "run/reports/geometry_report.hpp"

namespace blocks::apps {
namespace {

post::Frame frame_of(const Blocks& blocks) {
  post::Frame frame;
  for (int b = 0; b < blocks.size(); ++b) {
    frame.number.push_back(b + 1);
    frame.fixed.push_back(static_cast<int>(blocks.fixity[static_cast<std::size_t>(b)]));
  }
  frame.outlines = blocks.present_outlines();
  frame.material = blocks.material;
  frame.centroid = blocks.centroid;
  return frame;
}

/// Adds marks at the places that the text lists, and their legend. The least serious
/// kind comes first, so that the most serious is drawn on top.
void mark_places(const run::GeometryReport& report, post::FigureOptions& options) {
  using Kind = draw::Mark::Kind;
  constexpr std::size_t max = 10;
  const auto name = [&](Kind kind, const char* what, std::size_t shown,
                        std::size_t count) {
    if (count > 0)
      options.mark_names.insert(options.mark_names.begin(),
                                {kind, what,
                                 shown < count ? fmt::format("{} of {}", shown, count)
                                               : fmt::format("{}", count)});
  };
  const auto first = [&](const auto& list, std::size_t count, Kind kind,
                         const char* what) {
    const std::size_t shown = std::min(max, count);
    for (std::size_t i = 0; i < shown; ++i)
      options.marks.push_back({kind, list[i].place, {}, {}});
    name(kind, what, shown, count);
  };
  const auto worst = [&](const run::Measure& measure, Kind kind, const char* what) {
    for (const auto& place : measure.worst)
      options.marks.push_back(
          {kind,
           place.at,
           {},
           kind == Kind::slender ? std::vector{place.block} : std::vector<int>()});
    name(kind, what, measure.worst.size(), measure.worst.size());
  };
  const auto& proof = report.certificate;
  first(proof.joints.t_junctions, proof.joints.t_junctions.size(), Kind::junction,
        "T-junction");
  worst(report.aspect, Kind::slender, "slender");
  worst(report.angle, Kind::angle, "sharp");
  worst(report.edge, Kind::edge, "short side");
  first(proof.joints.slits, proof.gaps(), Kind::gap, "gap");
  for (const auto& pair : proof.overlaps)
    options.marks.push_back(
        {Kind::overlap,
         pair.place,
         proof.overlaps.size() <= max
             ? fmt::format("{} and {}: area {}", pair.first + 1, pair.second + 1,
                           geometry::positive_text(pair.area, 3))
             : std::string(),
         {pair.first, pair.second}});
  name(Kind::overlap, "overlap", proof.overlaps.size(), proof.overlaps.size());
}

void draw(const std::string& path, const Model& model,
          const run::GeometryReport& report) {
  const post::Frame frame = frame_of(model.blocks);
  post::FigureOptions options;
  if (model.settings.units.known())
    options.units = model.settings.units;
  for (const auto& [number, material] : model.settings.materials)
    if (!material.name.empty())
      options.material_names[number] = material.name;
  mark_places(report, options);
  options.subtitle = verdict(report.certificate);
  post::draw_frame(path, frame, frame, model.settings.title, options);
}

}  // namespace

void add_geometry_options(CLI::App& command, GeometryOptions& options) {
  auto* report = command.add_flag("--geometry", options.report,
                                  "report shapes, overlaps, gaps and joints of the "
                                  "blocks; exit 3 when blocks overlap");
  command.add_flag("--json", options.json, "print the geometry report as JSON")
      ->needs(report);
  command
      .add_option("--plot", options.plot,
                  "draw the blocks and mark what the report lists: .png, .svg or .pdf")
      ->needs(report);
}

int check(const run::RunOptions& options, const GeometryOptions& geometry) {
  if (!geometry.report)
    return run::check_deck(options);
  files::check_outputs({geometry.plot});
  const auto checked = run::build_checked(options);
  if (checked.code != run::done)
    return checked.code;
  const auto report =
      run::examine_geometry(checked.file, checked.model,
                            checked.certificate ? checked.certificate->moved : 0);
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
