#include "dynamics/preparation/travel_time.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include "dynamics/preparation/packed_contacts.hpp"
#include "dynamics/search/near_pairs.hpp"

namespace blocks::dynamics {
namespace {

/// The free blocks that each block touches, and the time to get there.
using Ways = std::vector<std::vector<std::pair<int, double>>>;

/// Returns the normal stiffness of the contacts that act, by pair, low < high, [F/L].
std::map<std::pair<int, int>, double> acting_stiffness(const Model& model) {
  std::map<std::pair<int, int>, double> stiffness;
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const bool has_law = i < model.law_states.size() && model.law_states[i].law != 0;
    stiffness[pair_of(model.blocks, model.contacts[i])] +=
        has_law ? model.law_states[i].stiffness : model.settings.normal_stiffness;
  }
  return stiffness;
}

/// Returns how much a deformable block gives under a force, [L/F]: about that of a
/// square. Rigid blocks give nothing.
double compliance(const Model& model, int b) {
  if (model.settings.rigid)
    return 0.0;
  const Material& material =
      model.settings.materials.at(model.blocks.material[static_cast<std::size_t>(b)]);
  return 1.0 / material.c11();
}

Ways ways_of(const Model& model) {
  const Blocks& blocks = model.blocks;
  const double tolerance = model.settings.contact_tolerance;
  const auto acting = acting_stiffness(model);
  Ways ways(static_cast<std::size_t>(blocks.size()));
  NearSearch memory;
  std::vector<NearPair> pairs;
  find_near_pairs(blocks, tolerance, memory, pairs);
  for (const auto& [low, high] : pairs) {
    if (!blocks.is_free(low) || !blocks.is_free(high))
      continue;
    const auto found = acting.find({low, high});
    const double stiffness = found != acting.end()
                                 ? found->second
                                 : model.settings.normal_stiffness *
                                       touching_corners(blocks, low, high, tolerance);
    if (!(stiffness > 0.0))
      continue;
    const double mass = 0.5 * (blocks.inertial_mass(low) + blocks.inertial_mass(high));
    const double give =
        1.0 / stiffness + 0.5 * (compliance(model, low) + compliance(model, high));
    const double time = std::sqrt(mass * give);
    ways[static_cast<std::size_t>(low)].push_back({high, time});
    ways[static_cast<std::size_t>(high)].push_back({low, time});
  }
  return ways;
}

/// The block that is reached last, and when.
struct Farthest {
  int block = 0;
  double time = 0.0;
};

/// Follows the quickest ways from a block (Dijkstra). Marks the blocks that it reaches.
Farthest farthest_from(int start, const Ways& ways, std::vector<char>& reached) {
  using Arrival = std::pair<double, int>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> next;
  std::vector<char> done(ways.size(), 0);
  Farthest last{start, 0.0};
  next.push({0.0, start});
  while (!next.empty()) {
    const auto [time, b] = next.top();
    next.pop();
    const auto at = static_cast<std::size_t>(b);
    if (done[at] != 0)
      continue;
    done[at] = reached[at] = 1;
    last = {b, time};
    for (const auto& [other, step] : ways[at])
      if (done[static_cast<std::size_t>(other)] == 0)
        next.push({time + step, other});
  }
  return last;
}

}  // namespace

double longest_travel_time(const Model& model) {
  const Ways ways = ways_of(model);
  std::vector<char> reached(ways.size(), 0);
  double longest = 0.0;
  for (int b = 0; b < model.blocks.size(); ++b)
    if (const auto at = static_cast<std::size_t>(b);
        reached[at] == 0 && !ways[at].empty()) {
      const Farthest end = farthest_from(b, ways, reached);
      longest = std::max(longest, farthest_from(end.block, ways, reached).time);
    }
  return longest;
}

}  // namespace blocks::dynamics
