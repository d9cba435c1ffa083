// The random networks whose statistics are known exactly, and the exact values.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "validation/cells/estimate.hpp"

namespace blocks::validation {

/// A quantity with an exact mean.
struct Quantity {
  std::string name;     ///< "E area"
  std::string formula;  ///< of the exact value
  double exact = 0.0;
  Statistic statistic = nullptr;
};

/// One kind of network in one outline.
struct Case {
  std::string group;  ///< heading of its table
  std::string name;
  int networks = 0;                          ///< number of networks of a full run
  Window window = {{0.0, 0.0}, {0.0, 0.0}};  ///< empty: no cell is sampled
  Identity identity = Identity::none;
  double mean_area = 1.0;  ///< [L^2] exact mean area of a cell
  /// Returns the outline with the joints of this seed.
  std::function<geometry::CutRequest(std::uint64_t seed)> make = {};
  std::vector<Quantity> quantities = {};
};

/// Returns all cases. The names of the groups are consecutive.
std::vector<Case> cases();

/// Returns the samples of the networks with the seeds first + 0, ..., first + count -
/// 1, in this order.
std::vector<Sums> samples(const Case& one, std::uint64_t first, int count, int threads);

}  // namespace blocks::validation
