// The chart of Sobol indices.
#include <cmath>

#include "report/charts.hpp"

namespace blocks::report {

draw::DotChart index_chart(const Ensemble& ensemble, const Sensitivity& sensitivity,
                           std::size_t column) {
  draw::DotSeries first{"first order, 95 % interval (bootstrap)", {}, {}, {}};
  draw::DotSeries total{"total, 95 % interval (bootstrap)", {}, {}, {}};
  bool any = false;
  for (const SobolIndex& one : sensitivity.quantities[column].parameters) {
    any = any || std::isfinite(one.first) || std::isfinite(one.total);
    first.value.push_back(one.first);
    first.low.push_back(one.first_interval.low);
    first.high.push_back(one.first_interval.high);
    total.value.push_back(one.total);
    total.low.push_back(one.total_interval.low);
    total.high.push_back(one.total_interval.high);
  }
  if (!any)
    return {};
  return {"Sobol index of " + ensemble.columns[column].label,
          sensitivity.parameters,
          {first, total}};
}

}  // namespace blocks::report
