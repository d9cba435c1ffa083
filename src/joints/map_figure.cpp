#include "joints/map_figure.hpp"

#include <fmt/format.h>

#include <cmath>

#include "draw/chart/rose_figure.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "joints/node_triangle.hpp"
#include "text/counted.hpp"

namespace blocks::joints {
namespace {

using draw::Histogram;

draw::Directions directions_of(const MapStatistics& map) {
  std::vector<draw::DirectedLength> lengths;
  for (std::size_t i = 0; i < map.network.pieces.size(); ++i)
    lengths.push_back({map.mixture.member[i] < 0 ? static_cast<int>(map.families.size())
                                                 : map.mixture.member[i] + 1,
                       map.network.pieces[i].direction, map.network.pieces[i].length});
  return draw::direction_statistics(lengths);
}

std::string corrected(const Estimate& one) {
  return std::isfinite(one.value) ? fmt::format("mean {:.3g}, corrected", one.value)
                                  : std::string("longer than the window");
}

std::vector<Histogram> histograms_of(const MapStatistics& map) {
  std::vector<double> traces, branches;
  for (const Piece& piece : map.network.pieces)
    if (piece.length > 0.0)
      traces.push_back(piece.length);
  for (const Branch& branch : map.network.branches)
    if (branch.length > 0.0)
      branches.push_back(branch.length);
  std::vector<Histogram> found = {{"visible length of traces [L]", std::move(traces),
                                   false, corrected(map.density.by_ends), "traces"}};
  if (!branches.empty())
    found.push_back({"length of branches [L]", std::move(branches), false,
                     fmt::format("mean {:.3g}", map.topology.mean_branch), "branches"});
  return found;
}

constexpr std::size_t plots = 3;  ///< the triangle is the first

void draw_map(draw::Pen& pen, const std::vector<MapStatistics>& maps, std::size_t k,
              const draw::PageSize& page, const draw::RoseLayout& layout) {
  const MapStatistics& map = maps[k];
  const double connections = map.topology.connections_per_branch;
  draw::draw_rose_figure(
      pen, layout, page,
      {maps.size() > 1 ? fmt::format("{}  {}", k + 1, map.name) : map.name,
       fmt::format(
           "{}    P20 {:.3g} / L²    P21 {:.3g} / L    connections per branch {}",
           counted(map.network.pieces.size(), "trace"), map.density.p20.value,
           map.density.p21.value,
           std::isfinite(connections) ? fmt::format("{:.3g}", connections)
                                      : std::string("-")),
       directions_of(map),
       [&](int id) {
         return map.families[static_cast<std::size_t>(id - 1)].scattered
                    ? std::string("scattered")
                    : fmt::format("family {}", id);
       },
       histograms_of(map), 1});
  std::vector<NodeCounts> nodes;
  for (const MapStatistics& one : maps)
    nodes.push_back(one.network.nodes);
  draw_node_triangle(pen, layout.plots[0], nodes, k);
}

}  // namespace

void draw_map_figure(const std::string& path, const std::vector<MapStatistics>& maps,
                     const draw::PageSize& page) {
  draw::PageSize part = page;
  part.height = page.height / static_cast<double>(maps.size());
  std::vector<draw::RoseLayout> layouts;
  double height = 0.0;
  for (const MapStatistics& map : maps) {
    layouts.emplace_back(draw::rose_legend_height(directions_of(map)), plots, part,
                         true);
    height += layouts.back().height;
  }
  draw::write_page(path, page, height, [&](cairo_t* cairo) {
    double top = 0.0;
    for (std::size_t k = 0; k < maps.size(); ++k) {
      cairo_save(cairo);
      cairo_rectangle(cairo, 0.0, top, page.width, layouts[k].height);
      cairo_clip(cairo);
      cairo_translate(cairo, 0.0, top);
      draw::Pen pen(cairo, page);
      draw_map(pen, maps, k, page, layouts[k]);
      cairo_restore(cairo);
      top += layouts[k].height;
    }
  });
}

}  // namespace blocks::joints
