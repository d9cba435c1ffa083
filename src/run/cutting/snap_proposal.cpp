#include "run/cutting/snap_proposal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "text/counted.hpp"

namespace blocks::run {
namespace {

constexpr double near_length = 0.02;   // of the mean extent of a trace
constexpr double common_share = 0.25;  // of all loose ends

/// Returns a number of two digits that is more than the length and its rounding errors.
std::string rounded_up(double length) {
  const auto rounded = [](double value) {
    return std::stod(fmt::format("{:.1e}", value));
  };
  const double nearest = rounded(length);  // within 5 per cent
  return fmt::format("{}", nearest > length * (1.0 + 1e-12) ? nearest
                                                            : rounded(1.06 * length));
}

}  // namespace

double mean_extent(const std::vector<exchange::Trace>& traces) {
  double sum = 0.0;
  for (const exchange::Trace& trace : traces) {
    const geometry::DecimalPoint &a = trace.points.front(), &b = trace.points.back();
    sum += std::hypot(b.x.value() - a.x.value(), b.y.value() - a.y.value());
  }
  return traces.empty() ? 0.0 : sum / static_cast<double>(traces.size());
}

std::optional<SnapProposal>
propose_snap(const std::vector<geometry::JointSegment>& traces, double extent,
             const std::vector<geometry::JointSegment>& others,
             const std::vector<geometry::DecimalPoint>& outline,
             const geometry::ProgressFunction& progress) {
  const auto reach =
      geometry::Decimal::parse(fmt::format("{:.3g}", near_length * extent));
  if (!reach)  // beyond the range of doubles
    return {};
  const geometry::Prolongation found =
      geometry::prolonged(traces, *reach, others, outline, progress);
  if (found.ends == 0)
    return {};
  const bool all = found.ends == found.loose;
  return SnapProposal{
      fmt::format("{}{} short of another joint or of the outline, by {:.3g}{}, at "
                  "({:.6g}, {:.6g})",
                  all ? counted(static_cast<long>(found.ends), "loose end")
                      : fmt::format("{} of {} loose ends", found.ends, found.loose),
                  found.ends == 1 ? " stops" : " stop", found.largest,
                  found.ends == 1 ? "" : " at most", found.place.x(), found.place.y()),
      fmt::format("give snap {} to prolong {}, or snap 0 to leave {} loose",
                  rounded_up(found.largest), found.ends == 1 ? "it" : "them",
                  found.ends == 1 ? "it" : "them"),
      static_cast<double>(found.ends) >=
          common_share * static_cast<double>(found.loose)};
}

}  // namespace blocks::run
