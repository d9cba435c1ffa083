#include "post/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "post/model_quantity.hpp"
#include "post/quantity.hpp"

namespace blocks::post {
namespace {

using Of = Curve::Of;
using Eigen::VectorXd;

Reduction reduction(Of of, Reduction natural) {
  switch (of) {
  case Of::largest:
    return Reduction::largest;
  case Of::smallest:
    return Reduction::smallest;
  case Of::mean:
    return Reduction::mean;
  case Of::sum:
    return Reduction::sum;
  case Of::model:
  case Of::block:
  case Of::corner:
    break;
  }
  return natural;
}

/// Returns the position, displacement or velocity of one corner.
double of_corner(const std::string& name, int block, int corner, const Frame& now,
                 const Frame& first) {
  const auto b = static_cast<std::size_t>(block), c = static_cast<std::size_t>(corner);
  const Eigen::Vector2d at = now.outlines[b][c], arm = at - now.centroid.col(block);
  if (name == "x" || name == "y")
    return name == "x" ? at.x() : at.y();
  if (name == "dx" || name == "dy" || name == "displacement") {
    if (b >= first.outlines.size() || c >= first.outlines[b].size())
      return 0.0;
    const Eigen::Vector2d d = at - first.outlines[b][c];
    return name == "dx" ? d.x() : name == "dy" ? d.y() : d.norm();
  }
  // v + spin x arm + strain rate arm (13), (14)
  const auto& e = now.strain_rate;
  const Eigen::Vector2d v =
      now.velocity.col(block) +
      Eigen::Vector2d(-now.spin[block] * arm.y(), now.spin[block] * arm.x()) +
      Eigen::Vector2d(e(0, block) * arm.x() + e(1, block) * arm.y(),
                      e(2, block) * arm.x() + e(3, block) * arm.y());
  return name == "vx" ? v.x() : name == "vy" ? v.y() : v.norm();
}

std::string label_of(const Curve& curve, const std::string& label) {
  switch (curve.of) {
  case Of::block:
    return fmt::format("{} of block {}", label, curve.block);
  case Of::corner:
    return fmt::format("{} of block {}, corner {}", label, curve.block, curve.corner);
  case Of::largest:
    return "largest " + label;
  case Of::smallest:
    return "smallest " + label;
  case Of::mean:
    return "mean " + label;
  case Of::sum:
    return "sum of " + label;
  case Of::model:
    break;
  }
  return label;
}

/// Returns the values of the blocks that are not removed.
VectorXd of_present(const Frame& now, const VectorXd& values) {
  VectorXd present(now.count_present());
  Eigen::Index k = 0;
  for (int b = 0; b < now.size(); ++b)
    if (!now.is_removed(b))
      present[k++] = values[b];
  return present;
}

/// Returns the value of one curve in one frame; NaN if its block does not exist yet or
/// is removed.
double value(const Curve& curve, const Frame& now, const Frame& first,
             const FrameContacts& contacts) {
  const bool there = curve.block <= now.size() &&
                     (curve.block < 1 || !now.is_removed(curve.block - 1));
  if (const OtherKind* other = find_other(curve.quantity)) {
    if (other->whole)
      return other->whole(now);
    if (curve.of != Of::block)
      return reduce(reduction(curve.of, other->natural), other->rows(contacts));
    return there ? per_block(*other, contacts, now.size())[curve.block - 1]
                 : std::nan("");
  }
  if (curve.of == Of::block || curve.of == Of::corner) {
    if (!there)
      return std::nan("");
    if (curve.of == Of::corner)
      return of_corner(curve.quantity, curve.block - 1, curve.corner - 1, now, first);
  }
  const VectorXd values = find_quantity(curve.quantity)->values(now, first);
  return curve.of == Of::block
             ? values[curve.block - 1]
             : reduce(reduction(curve.of, Reduction::sum), of_present(now, values));
}

}  // namespace

History read_history(const std::vector<const ResultsReader*>& parts,
                     const std::vector<Curve>& curves, const TimeRange& range) {
  const ResultsReader &begin = *parts.front(), &end = *parts.back();
  History history{begin.path(), begin.title(), {}, {}};
  for (std::size_t i = 1; i < parts.size(); ++i)
    history.file += " + " + parts[i]->path();
  const Frame first = begin.frame(0);
  bool with_contacts = false;
  for (const Curve& curve : curves) {
    const OtherKind* other = find_other(curve.quantity);
    const QuantityKind* kind = find_quantity(curve.quantity);
    with_contacts = with_contacts || (other && other->rows);
    const std::string label = other ? other->label : kind->label;
    const std::string sign =
        other ? "" : sign_convention(*kind, first.compression_positive);
    Curve read_as = curve;  // "overlap" alone means the largest overlap
    if (other && other->natural == Reduction::largest && curve.of == Of::model)
      read_as.of = Of::largest;
    history.series.push_back({curve,
                              label_of(read_as, label),
                              label + sign,
                              other ? other->dimension : kind->dimension,
                              {}});
  }
  const auto check = [&](const Frame& last, const auto& outlines) {
    for (const Curve& curve : curves) {
      if (curve.block > last.size())
        throw std::runtime_error(fmt::format("{} has blocks 1 to {}, no block {}",
                                             end.path(), last.size(), curve.block));
      if (curve.of != Of::corner)
        continue;
      const auto corners = outlines[static_cast<std::size_t>(curve.block) - 1].size();
      if (static_cast<std::size_t>(curve.corner) > corners)
        throw std::runtime_error(
            fmt::format("{}: block {} has corners 1 to {}, no corner {}", end.path(),
                        curve.block, corners, curve.corner));
    }
  };
  // Blocks are never taken out of the list, even if they are removed from the model.
  check(end.frame(end.frames() - 1), end.last_outlines(end.frames() - 1));
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const ResultsReader& results = *parts[part];
    const double next = part + 1 < parts.size()
                            ? parts[part + 1]->times().front()
                            : std::numeric_limits<double>::infinity();
    for (long i = 0; i < results.frames(); ++i) {
      const double t = results.times()[static_cast<std::size_t>(i)];
      if (t < range.from || t > range.to || t >= next)
        continue;
      const Frame now = results.frame(i);
      const FrameContacts contacts =
          with_contacts ? results.contacts(i) : FrameContacts{};
      history.time.push_back(t);
      for (Series& series : history.series)
        series.values.push_back(value(series.curve, now, first, contacts));
    }
  }
  if (history.time.empty())
    throw std::runtime_error(fmt::format("{} has times {:g} to {:g}, none between {:g} "
                                         "and {:g}",
                                         history.file, begin.times().front(),
                                         end.times().back(), range.from, range.to));
  return history;
}

}  // namespace blocks::post
