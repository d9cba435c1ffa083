#include "model/loads.hpp"

#include <algorithm>
#include <cstddef>

namespace blocks {

double TimeFunction::factor(double time, double arrival) const {
  if (arrival == always)
    return 1.0;
  const double since = time - arrival;
  if (since < 0.0 || t.empty())
    return 0.0;
  if (since < t.front())
    return p.front();
  if (since >= t.back())
    return p.back();
  const auto after = std::upper_bound(t.begin(), t.end(), since);
  const auto i = static_cast<std::size_t>(after - t.begin());
  const double s = (since - t[i - 1]) / (t[i] - t[i - 1]);
  return p[i - 1] + s * (p[i] - p[i - 1]);
}

}  // namespace blocks
