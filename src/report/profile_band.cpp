#include "report/profile_band.hpp"

#include <algorithm>
#include <cmath>

#include "report/statistics.hpp"

namespace blocks::report {

ProfileGrid::ProfileGrid(double begin, double end) {
  for (std::size_t i = 0; i < profile_positions; ++i)
    positions_.push_back(
        std::lerp(begin, end,
                  static_cast<double>(i) / static_cast<double>(profile_positions - 1)));
}

std::vector<double> ProfileGrid::resampled(const ProfileValues& profile) const {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < profile.position.size(); ++i)
    if (std::isfinite(profile.value[i])) {
      x.push_back(profile.position[i]);
      y.push_back(profile.value[i]);
    }
  std::vector<double> values(positions_.size(), no_number);
  if (x.empty())
    return values;
  std::size_t next = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    while (next < x.size() && x[next] < positions_[i])
      ++next;
    if (next == 0 || next == x.size())
      values[i] = next == 0 ? y.front() : y.back();
    else
      values[i] = std::lerp(y[next - 1], y[next],
                            (positions_[i] - x[next - 1]) / (x[next] - x[next - 1]));
  }
  return values;
}

ProfileBand band_of(const std::vector<const std::vector<double>*>& profiles) {
  ProfileBand band;
  band.runs = profiles.size();
  std::vector<double> values;
  for (std::size_t i = 0; i < profile_positions; ++i) {
    values.clear();
    for (const std::vector<double>* profile : profiles)
      if (std::isfinite((*profile)[i]))
        values.push_back((*profile)[i]);
    std::sort(values.begin(), values.end());
    band.median.push_back(sorted_quantile(values, 0.5));
    band.low.push_back(sorted_quantile(values, 0.05));
    band.high.push_back(sorted_quantile(values, 0.95));
  }
  return band;
}

}  // namespace blocks::report
