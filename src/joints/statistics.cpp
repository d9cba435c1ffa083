#include "joints/statistics.hpp"

#include <cmath>
#include <stdexcept>

namespace blocks::joints {
namespace {

/// Lines of each default scanline direction. More lines do not add independent
/// crossings.
constexpr int scanlines_per_direction = 20;

double half_turn(double degrees) {
  return degrees - 180.0 * std::round(degrees / 180.0);
}

/// Returns the statistics of family k, or of scattered traces, k = -1.
FamilyStatistics family_statistics(const Network& network, const Mixture& mixture,
                                   int k) {
  FamilyStatistics one;
  one.scattered = k < 0;
  if (one.scattered)
    one.family.mean = 90.0;
  else
    one.family = mixture.families[static_cast<std::size_t>(k)];
  std::vector<Piece> members;
  std::vector<char> chosen(network.pieces.size(), 0);
  double length = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < network.pieces.size(); ++i) {
    if (mixture.member[i] != k)
      continue;
    chosen[i] = 1;
    members.push_back(network.pieces[i]);
    length += network.pieces[i].length;
    const double off = half_turn(network.pieces[i].direction - one.family.mean);
    squares += off * off;
  }
  one.pieces = members.size();
  if (members.size() > 1 && !one.scattered)
    one.deviation = std::sqrt(squares / static_cast<double>(members.size() - 1));
  if (one.scattered)
    one.family.weight = static_cast<double>(members.size()) /
                        static_cast<double>(network.pieces.size());
  one.share = length / network.length();
  one.density = trace_density(members, network.window);
  one.spacing =
      spacing_statistics(parallel_scanlines(network.window, one.family.mean + 90.0,
                                            scanlines_per_direction),
                         network, chosen);
  return one;
}

}  // namespace

Topology topology_of(const Network& network) {
  const NodeCounts& nodes = network.nodes;
  Topology t;
  t.branches = 0.5 * static_cast<double>(nodes.degrees);
  t.lines = 0.5 * static_cast<double>(nodes.i + nodes.y);
  for (const Branch& branch : network.branches) {
    const auto is = [&](End end) { return (branch.from == end) + (branch.to == end); };
    ++(is(End::window) > 0       ? t.at_window
       : is(End::connected) == 2 ? t.cc
       : is(End::connected) == 1 ? t.ci
                                 : t.ii);
  }
  const double length = network.length();
  t.branch_density = t.branches / network.area;
  if (t.branches > 0.0) {
    t.mean_branch = length / t.branches;
    t.connections_per_branch =
        static_cast<double>(nodes.degrees - nodes.i) / t.branches;
    t.branch_intensity = length * length / (network.area * t.branches);
  }
  if (t.lines > 0.0)
    t.connections_per_line = 2.0 * static_cast<double>(nodes.y + nodes.x) / t.lines;
  return t;
}

MapStatistics statistics_of(const TraceMap& map, const StatisticsOptions& options) {
  MapStatistics found;
  found.name = map.name;
  found.shortest = options.shortest;
  found.network = network_of(map);
  const Network& network = found.network;
  if (network.pieces.empty())
    throw std::runtime_error(map.name + ": no trace is inside the window\n  hint: give "
                                        "traces and window in the same coordinates");
  found.topology = topology_of(network);
  found.density = trace_density(network.pieces, network.window);
  const LengthSample sample =
      length_sample(network.pieces, network.window, options.shortest);
  found.exponential = fit_length_law(LengthForm::exponential, sample);
  found.lognormal = fit_length_law(LengthForm::lognormal, sample);
  std::vector<double> directions;
  for (const Piece& piece : network.pieces)
    directions.push_back(piece.direction);
  found.mixture = find_families(directions, options.max_families);
  for (int k = 0; k < static_cast<int>(found.mixture.families.size()); ++k)
    found.families.push_back(family_statistics(network, found.mixture, k));
  if (FamilyStatistics rest = family_statistics(network, found.mixture, -1);
      rest.pieces > 0)
    found.families.push_back(std::move(rest));
  const auto along = [&](double degrees) {
    return spacing_statistics(
        parallel_scanlines(network.window, degrees, scanlines_per_direction), network);
  };
  found.along_x = along(0.0);
  found.along_y = along(90.0);
  for (const Scanline& line : options.scanlines)
    found.scanlines.push_back(spacing_statistics({line}, network));
  return found;
}

}  // namespace blocks::joints
