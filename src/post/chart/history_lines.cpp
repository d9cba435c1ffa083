#include "post/chart/history_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "post/chart/run_band.hpp"

namespace blocks::post {
namespace {

namespace fs = std::filesystem;

std::string joined(const RunParts& run, bool with_folder) {
  std::string name;
  for (const std::string& file : run.files)
    name += (name.empty() ? "" : " + ") +
            (with_folder ? fs::path(file).replace_extension() : fs::path(file).stem())
                .string();
  return name;
}

/// Returns the panel with this axis label, and adds it if there is none.
draw::ChartPanel& panel(std::vector<draw::ChartPanel>& panels, const RunLine& line) {
  const auto found =
      std::find_if(panels.begin(), panels.end(), [&](const draw::ChartPanel& p) {
        return p.y_label == line.y_label;
      });
  if (found != panels.end())
    return *found;
  panels.push_back({line.y_label, {}, line.logarithmic});
  return panels.back();
}

draw::ChartLine band(const std::vector<draw::ChartLine>& lines,
                     const std::string& what) {
  draw::ChartLine line = band_of(lines);
  line.legend = what + ", median";
  line.band_legend =
      fmt::format("{:g} to {:g} % of {} runs", band_low, band_high, lines.size());
  return line;
}

}  // namespace

std::vector<std::string> run_names(const std::vector<RunParts>& runs) {
  std::vector<std::string> names(runs.size());
  if (runs.size() < 2)
    return names;
  const bool seeds_differ = std::any_of(
      runs.begin(), runs.end(), [&](const auto& r) { return r.seed != runs[0].seed; });
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string own = joined(runs[i], false);
    const auto same = std::count_if(runs.begin(), runs.end(), [&](const auto& other) {
      return joined(other, false) == own;
    });
    names[i] = same > 1 ? joined(runs[i], true) : own;
    if (seeds_differ)
      names[i] += fmt::format(" (seed {})", runs[i].seed);
  }
  return names;
}

std::string legend_of(const std::string& curve, const std::string& run) {
  return run.empty() ? curve : curve + ", " + run;
}

std::vector<draw::ChartPanel> panels_of(const std::vector<RunLine>& lines, bool bands) {
  using Key = std::pair<std::string, std::string>;
  std::map<Key, std::vector<draw::ChartLine>> same;
  for (const RunLine& line : lines)
    same[{line.y_label, line.what}].push_back({line.legend, line.x, line.y});
  std::vector<draw::ChartPanel> panels;
  std::map<Key, std::size_t> drawn;
  for (const RunLine& line : lines) {
    const Key key{line.y_label, line.what};
    const auto& all = same.at(key);
    const std::size_t i = drawn[key]++;
    const bool is_band = bands && all.size() > max_single_runs;
    if (!is_band)
      panel(panels, line).lines.push_back(all[i]);
    else if (i == 0)
      panel(panels, line).lines.push_back(band(all, line.what));
  }
  return panels;
}

}  // namespace blocks::post
