// The profiles of many runs on common positions: the median and a band.
#pragma once

#include <cstddef>
#include <vector>

#include "report/run_values.hpp"

namespace blocks::report {

/// The number of positions of a profile, so that the memory for a run does not depend
/// on its number of blocks.
inline constexpr std::size_t profile_positions = 201;

/// The quantiles of the profiles of a group at each position.
struct ProfileBand {
  std::size_t runs = 0;
  std::vector<double> median, low, high;  ///< (profile_positions) 50, 5 and 95 %
};

/// Profiles of runs at equally spaced positions.
class ProfileGrid {
 public:
  /// Positions from `begin` to `end` [L].
  ProfileGrid(double begin, double end);

  const std::vector<double>& positions() const { return positions_; }

  /// Returns the values at the positions: linear between two places, and the value of
  /// the outermost place beyond it. Places without a value are left out. NaN if there
  /// are none.
  std::vector<double> resampled(const ProfileValues& profile) const;

 private:
  std::vector<double> positions_;
};

/// Returns the quantiles of profiles, each with profile_positions values. At each
/// position, values that are NaN do not count.
ProfileBand band_of(const std::vector<const std::vector<double>*>& profiles);

}  // namespace blocks::report
