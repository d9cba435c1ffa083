#include "post/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

#include "post/quantity.hpp"

namespace blocks::post {
namespace {

using Of = Curve::Of;
using Eigen::VectorXd;

/// Of the contacts or of the model as a whole.
struct OtherKind {
  const char* label;
  Dimension dimension;
  Of natural;  ///< how the rows of contacts become one number
  std::function<VectorXd(const FrameContacts&)> rows;  ///< empty: of the model
  std::function<double(const Frame&)> whole;
};

const std::map<std::string, OtherKind>& other_kinds() {
  constexpr Dimension force{0, 1, -2, "N/m", ""}, length{1, 0, 0, "m", ""}, pure{};
  static const std::map<std::string, OtherKind> kinds = {
      {"contacts",
       {"contacts",
        pure,
        Of::sum,
        [](const FrameContacts& c) -> VectorXd { return VectorXd::Ones(c.size()); },
        {}}},
      {"normal_force",
       {"normal contact force",
        force,
        Of::sum,
        [](const FrameContacts& c) { return c.normal_force; },
        {}}},
      {"shear_force",
       {"shear contact force",
        force,
        Of::sum,
        [](const FrameContacts& c) -> VectorXd { return c.shear_force.cwiseAbs(); },
        {}}},
      {"overlap",
       {"overlap",
        length,
        Of::largest,
        [](const FrameContacts& c) { return c.overlap; },
        {}}},
      {"step",
       {"step",
        pure,
        Of::model,
        {},
        [](const Frame& f) { return static_cast<double>(f.step); }}},
      {"blocks",
       {"blocks", pure, Of::model, {}, [](const Frame& f) { return 1.0 * f.size(); }}},
      {"time", {"time", {0, 0, 1, "s", ""}, Of::model, {}, [](const Frame& f) {
                  return f.time;
                }}}};
  return kinds;
}

const OtherKind* find_other(const std::string& name) {
  const auto found = other_kinds().find(name);
  return found == other_kinds().end() ? nullptr : &found->second;
}

double reduce(Of of, const VectorXd& values) {
  if (of == Of::sum)  // in the order of the blocks, as the run sums
    return std::accumulate(values.begin(), values.end(), 0.0);
  if (values.size() == 0)
    return 0.0;
  return of == Of::largest    ? values.maxCoeff()
         : of == Of::smallest ? values.minCoeff()
                              : values.mean();
}

/// x, y, displacement and velocity of one corner; the names a corner has.
const std::vector<std::string> corner_names = {
    "x", "y", "dx", "dy", "speed", "displacement", "vx", "vy"};

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

/// The number of one curve in one frame.
double value(const Curve& curve, const Frame& now, const Frame& first,
             const FrameContacts& contacts) {
  const bool there = curve.block <= now.size();
  if (const OtherKind* other = find_other(curve.quantity)) {
    if (other->whole)
      return other->whole(now);
    VectorXd rows = other->rows(contacts);
    if (curve.of != Of::block)
      return reduce(curve.of == Of::model ? other->natural : curve.of, rows);
    if (!there)
      return std::nan("");
    std::vector<double> own;
    for (std::size_t i = 0; i < contacts.corner.size(); ++i)
      if (contacts.corner_block[i] == curve.block ||
          contacts.edge_block[i] == curve.block)
        own.push_back(rows[static_cast<Eigen::Index>(i)]);
    return reduce(other->natural,
                  Eigen::Map<VectorXd>(own.data(), static_cast<long>(own.size())));
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
             : reduce(curve.of == Of::model ? Of::sum : curve.of, values);
}

int whole_number(const std::string& digits) {
  const bool fine = !digits.empty() && digits.size() < 10 &&
                    digits.find_first_not_of("0123456789") == std::string::npos;
  return fine ? std::stoi(digits) : 0;
}

}  // namespace

std::string Curve::name() const {
  switch (of) {
  case Of::block:
    return fmt::format("{}:{}", quantity, block);
  case Of::corner:
    return fmt::format("{}:{}.{}", quantity, block, corner);
  case Of::largest:
    return quantity + ":max";
  case Of::smallest:
    return quantity + ":min";
  case Of::mean:
    return quantity + ":mean";
  case Of::sum:
    return quantity + ":sum";
  case Of::model:
    break;
  }
  return quantity;
}

std::string history_help() {
  std::string whole, corner;
  for (const auto& [name, kind] : other_kinds())
    whole += (whole.empty() ? "" : ", ") + name;
  for (const QuantityKind& kind : quantity_kinds())
    if (kind.additive)
      whole += ", " + kind.name;
  for (const std::string& name : corner_names)
    corner += (corner.empty() ? "" : ", ") + name;
  return "of blocks (:9, :max, :min, :mean, :sum): " + quantity_names() +
         "\nof corners (:9.2): " + corner + "\nof the model: " + whole;
}

Curve parse_curve(const std::string& text) {
  const auto colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const QuantityKind* kind = find_quantity(name);
  const OtherKind* other = find_other(name);
  if (!kind && !other)
    throw std::runtime_error("there is no quantity '" + name + "'\n" + history_help());
  Curve curve;
  curve.quantity = kind ? kind->name : name;
  const bool model_alone = other && other->whole;
  if (colon == std::string::npos) {
    if (kind && !kind->additive)
      throw std::runtime_error(fmt::format(
          "{0} of what? {0}:9 is that of block 9, {0}:max the largest; also {0}:min, "
          "{0}:mean, {0}:sum",
          name));
    return curve;
  }
  const std::string where = text.substr(colon + 1);
  static const std::map<std::string, Of> over_all = {{"max", Of::largest},
                                                     {"min", Of::smallest},
                                                     {"mean", Of::mean},
                                                     {"sum", Of::sum}};
  if (const auto found = over_all.find(where); found != over_all.end()) {
    curve.of = found->second;
  } else {
    const auto dot = where.find('.');
    curve.of = dot == std::string::npos ? Of::block : Of::corner;
    curve.block = whole_number(where.substr(0, dot));
    if (curve.of == Of::corner)
      curve.corner = whole_number(where.substr(dot + 1));
    if (curve.block < 1 || (curve.of == Of::corner && curve.corner < 1))
      throw std::runtime_error(fmt::format(
          "'{}': behind the colon stands a block (9), a corner of it (9.2), max, min, "
          "mean or sum",
          text));
  }
  if (model_alone)
    throw std::runtime_error(
        fmt::format("{0} is a number of the whole model: write {0} alone", name));
  if (curve.of == Of::corner && std::find(corner_names.begin(), corner_names.end(),
                                          curve.quantity) == corner_names.end())
    throw std::runtime_error(fmt::format("a corner has no {}: choose {}", name,
                                         fmt::join(corner_names, ", ")));
  return curve;
}

History read_history(const ResultsReader& results, const std::vector<Curve>& curves,
                     const TimeRange& range) {
  History history{results.path(), results.title(), {}, {}};
  bool with_contacts = false;
  for (const Curve& curve : curves) {
    const OtherKind* other = find_other(curve.quantity);
    const QuantityKind* kind = find_quantity(curve.quantity);
    with_contacts = with_contacts || (other && other->rows);
    const std::string label = other ? other->label : kind->label;
    Curve read_as = curve;  // "overlap" is the largest one
    if (other && other->natural == Of::largest && curve.of == Of::model)
      read_as.of = Of::largest;
    history.series.push_back({curve,
                              label_of(read_as, label),
                              label,
                              other ? other->dimension : kind->dimension,
                              {}});
  }
  const Frame first = results.frame(0);
  const auto check = [&](const Frame& last) {
    for (const Curve& curve : curves) {
      if (curve.block > last.size())
        throw std::runtime_error(fmt::format("{} has blocks 1 to {}, no block {}",
                                             results.path(), last.size(), curve.block));
      if (curve.of != Of::corner)
        continue;
      const auto corners =
          last.outlines[static_cast<std::size_t>(curve.block) - 1].size();
      if (static_cast<std::size_t>(curve.corner) > corners)
        throw std::runtime_error(
            fmt::format("{}: block {} has corners 1 to {}, no corner {}",
                        results.path(), curve.block, corners, curve.corner));
    }
  };
  check(results.frame(results.frames() - 1));  // blocks are added, never taken away
  const auto& times = results.times();
  for (long i = 0; i < results.frames(); ++i) {
    const double t = times[static_cast<std::size_t>(i)];
    if (t < range.from || t > range.to)
      continue;
    const Frame now = results.frame(i);
    const FrameContacts contacts =
        with_contacts ? results.contacts(i) : FrameContacts{};
    history.time.push_back(t);
    for (Series& series : history.series)
      series.values.push_back(value(series.curve, now, first, contacts));
  }
  if (history.time.empty())
    throw std::runtime_error(fmt::format("{} has times {:g} to {:g}, none between {:g} "
                                         "and {:g}",
                                         results.path(), times.front(), times.back(),
                                         range.from, range.to));
  return history;
}

}  // namespace blocks::post
