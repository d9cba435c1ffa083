#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "joints/statistics.hpp"
#include "text/table.hpp"

namespace blocks::joints {
namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string with_interval(const Estimate& one) {
  return std::isfinite(one.low) && std::isfinite(one.high)
             ? fmt::format("{:.4g} ({:.4g} to {:.4g})", one.value, one.low, one.high)
             : number(one.value);
}

/// A table with one column for each map.
class Table {
 public:
  explicit Table(const std::vector<MapStatistics>& maps) : maps_(maps) {}

  void heading(const std::string& words) { rows_.push_back({words}); }

  template <class Cell> void row(const std::string& label, const Cell& cell) {
    std::vector<std::string> cells = {"  " + label};
    for (const MapStatistics& map : maps_)
      cells.push_back(words(cell(map)));
    rows_.push_back(std::move(cells));
  }

  std::string str() const { return text::aligned(rows_, 1); }

 private:
  static std::string words(const std::string& text) { return text; }
  static std::string words(double value) { return number(value); }
  static std::string words(std::size_t count) { return fmt::format("{}", count); }
  static std::string words(const Estimate& one) { return with_interval(one); }

  const std::vector<MapStatistics>& maps_;
  std::vector<std::vector<std::string>> rows_;
};

void add_nodes(Table& table) {
  table.heading("nodes");
  using Map = MapStatistics;
  table.row("I, ends in the rock", [](const Map& m) { return m.network.nodes.i; });
  table.row("Y, ends at a trace", [](const Map& m) { return m.network.nodes.y; });
  table.row("X, crossings", [](const Map& m) { return m.network.nodes.x; });
  table.row("E, at the window", [](const Map& m) { return m.network.nodes.window; });
  table.row("I : Y : X [%]", [](const Map& m) {
    const NodeCounts& n = m.network.nodes;
    const auto all = static_cast<double>(std::max<std::size_t>(n.i + n.y + n.x, 1));
    const auto share = [&](std::size_t k) {
      return 100.0 * static_cast<double>(k) / all;
    };
    return fmt::format("{:.1f} : {:.1f} : {:.1f}", share(n.i), share(n.y), share(n.x));
  });
  table.heading("branches");
  table.row("number", [](const Map& m) { return m.topology.branches; });
  table.row("C-C, C-I, I-I", [](const Map& m) {
    return fmt::format("{}, {}, {}", m.topology.cc, m.topology.ci, m.topology.ii);
  });
  table.row("cut by the window", [](const Map& m) { return m.topology.at_window; });
  table.row("mean length [L]", [](const Map& m) { return m.topology.mean_branch; });
  table.row("connections per branch",
            [](const Map& m) { return m.topology.connections_per_branch; });
  table.row("connections per trace",
            [](const Map& m) { return m.topology.connections_per_line; });
  table.row("B20 [1/L2]", [](const Map& m) { return m.topology.branch_density; });
  table.row("B22 [-]", [](const Map& m) { return m.topology.branch_intensity; });
}

void add_lengths(Table& table) {
  using Map = MapStatistics;
  table.heading("traces");
  table.row("parts in the window",
            [](const Map& m) { return m.network.pieces.size(); });
  table.row("0, 1, 2 hidden ends", [](const Map& m) {
    std::size_t n[3] = {};
    for (const Piece& piece : m.network.pieces)
      ++n[piece.hidden];
    return fmt::format("{}, {}, {}", n[0], n[1], n[2]);
  });
  table.row("P20 [1/L2]", [](const Map& m) { return m.density.p20; });
  table.row("P21 [1/L]", [](const Map& m) { return m.density.p21; });
  table.row("mean length P21/P20 [L]", [](const Map& m) { return m.density.by_ends; });
  table.row("  by counts (Mauldon) [L]",
            [](const Map& m) { return m.density.by_counts; });
  table.row("  exponential (Laslett) [L]",
            [](const Map& m) { return m.exponential.mean; });
  table.row("  lognormal (Laslett) [L]", [](const Map& m) { return m.lognormal.mean; });
  table.row("  deviation of ln length", [](const Map& m) {
    return std::isfinite(m.lognormal.log_likelihood) ? m.lognormal.law.spread : unknown;
  });
  table.row("better law (AIC)", [](const Map& m) -> std::string {
    const double difference = m.exponential.aic() - m.lognormal.aic();
    return std::isnan(difference) ? "-"
           : difference < 0.0     ? fmt::format("exponential, by {:.1f}", -difference)
                                  : fmt::format("lognormal, by {:.1f}", difference);
  });
}

/// Adds family k, or the scattered traces, k = -1.
void add_family(Table& table, int k) {
  using Map = MapStatistics;
  const auto family_of = [k](const Map& m) -> const FamilyStatistics* {
    if (k < 0)
      return !m.families.empty() && m.families.back().scattered ? &m.families.back()
                                                                : nullptr;
    const auto i = static_cast<std::size_t>(k);
    return i < m.mixture.families.size() ? &m.families[i] : nullptr;
  };
  const auto row = [&](const std::string& label, const auto& value) {
    table.row(label, [&](const Map& m) -> std::string {
      const FamilyStatistics* one = family_of(m);
      return one == nullptr ? "-" : value(*one);
    });
  };
  table.heading(k < 0 ? std::string("scattered directions")
                      : fmt::format("family {}", k + 1));
  if (k >= 0)
    row("direction [degrees]", [](const FamilyStatistics& f) {
      return fmt::format("{:.1f} +- {:.1f}", f.family.mean, f.deviation);
    });
  row("parts, share of length", [](const FamilyStatistics& f) {
    return fmt::format("{}, {:.0f} %", f.pieces, 100.0 * f.share);
  });
  row("P20 [1/L2]",
      [](const FamilyStatistics& f) { return with_interval(f.density.p20); });
  row("P21 [1/L]",
      [](const FamilyStatistics& f) { return with_interval(f.density.p21); });
  row("mean length P21/P20 [L]",
      [](const FamilyStatistics& f) { return with_interval(f.density.by_ends); });
  if (k < 0)
    return;
  row("mean spacing [L]",
      [](const FamilyStatistics& f) { return number(f.spacing.mean); });
  row("variation of spacing [-]",
      [](const FamilyStatistics& f) { return number(f.spacing.variation); });
  row("1 / frequency (Terzaghi) [L]",
      [](const FamilyStatistics& f) { return number(1.0 / f.spacing.corrected); });
}

void add_scanline(
    Table& table, const std::string& heading,
    const std::function<const SpacingStatistics&(const MapStatistics&)>& spacing_of) {
  table.heading(heading);
  table.row("length [L]", [&](const MapStatistics& m) { return spacing_of(m).length; });
  table.row("crossings",
            [&](const MapStatistics& m) { return spacing_of(m).crossings; });
  table.row("mean spacing [L]",
            [&](const MapStatistics& m) { return spacing_of(m).mean; });
  table.row("variation of spacing [-]",
            [&](const MapStatistics& m) { return spacing_of(m).variation; });
  table.row("P10 [1/L]",
            [&](const MapStatistics& m) { return spacing_of(m).frequency; });
  table.row("corrected (Terzaghi) [1/L]",
            [&](const MapStatistics& m) { return spacing_of(m).corrected; });
}

}  // namespace

std::string statistics_text(const std::vector<MapStatistics>& maps) {
  Table table(maps);
  std::size_t families = 0, scanlines = 0;
  bool scattered = false;
  for (const MapStatistics& map : maps) {
    families = std::max(families, map.mixture.families.size());
    scattered = scattered || (!map.families.empty() && map.families.back().scattered);
    scanlines = std::max(scanlines, map.scanlines.size());
  }
  table.row("", [](const MapStatistics& m) { return m.name; });
  table.row("area of the window [L2]",
            [](const MapStatistics& m) { return m.network.area; });
  add_nodes(table);
  add_lengths(table);
  table.heading("directions");
  table.row("families",
            [](const MapStatistics& m) { return m.mixture.families.size(); });
  for (std::size_t k = 0; k < families; ++k)
    add_family(table, static_cast<int>(k));
  if (scattered)
    add_family(table, -1);
  add_scanline(
      table, "20 scanlines along x",
      [](const MapStatistics& m) -> const auto& { return m.along_x; });
  add_scanline(
      table, "20 scanlines along y",
      [](const MapStatistics& m) -> const auto& { return m.along_y; });
  for (std::size_t k = 0; k < scanlines; ++k)
    add_scanline(
        table, fmt::format("--scanline {}", k + 1),
        [k](const MapStatistics& m) -> const auto& { return m.scanlines[k]; });
  return table.str();
}

}  // namespace blocks::joints
