#include "quantities/curve_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::quantities {
namespace {

using Subject = Curve::Subject;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool is_displacement(const std::string& name) {
  return name == "displacement" || name == "dx" || name == "dy";
}

/// Returns the position, displacement or velocity of one corner, both from 0.
double of_corner(const std::string& name, int block, int corner, const BlockStates& now,
                 const Positions& first) {
  if (corner >= now.corners.count(block))
    return none;
  const Eigen::Vector2d at = now.corners.at(block, corner),
                        arm = at - now.centroid.col(block);
  if (name == "x" || name == "y")
    return name == "x" ? at.x() : at.y();
  if (is_displacement(name)) {
    const bool is_later = block >= first.centroid.cols();
    if (corner >= first.corners.count(block))
      return is_later ? 0.0 : none;
    const Eigen::Vector2d d = at - first.corners.at(block, corner);
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

}  // namespace

MaterialNumbers material_numbers(const Settings& settings) {
  MaterialNumbers numbers;
  for (const auto& [number, material] : settings.materials)
    if (!material.name.empty())
      numbers[material.name] = number;
  return numbers;
}

int material_number(const std::string& material, const MaterialNumbers& numbers) {
  if (const auto found = numbers.find(material); found != numbers.end())
    return found->second;
  const bool digits = material.size() < 10 &&
                      material.find_first_not_of("0123456789") == std::string::npos;
  return digits && !material.empty() ? std::stoi(material) : 0;
}

CurveValues::CurveValues(const std::vector<Curve>& curves,
                         const MaterialNumbers& numbers) {
  for (const Curve& curve : curves)
    curves_.push_back({curve, find_quantity(curve.quantity), find_other(curve.quantity),
                       material_number(curve.material, numbers)});
}

bool CurveValues::has_contacts() const {
  return std::any_of(curves_.begin(), curves_.end(), [](const Reader& reader) {
    return reader.other && !reader.other->whole;
  });
}

bool CurveValues::has_displacements() const {
  return std::any_of(curves_.begin(), curves_.end(), [](const Reader& reader) {
    return is_displacement(reader.curve.quantity);
  });
}

bool CurveValues::has_unbalanced() const {
  return std::any_of(curves_.begin(), curves_.end(), [](const Reader& reader) {
    return is_of_equilibrium(reader.curve.quantity);
  });
}

bool CurveValues::has_local_ratios() const {
  return std::any_of(curves_.begin(), curves_.end(), [](const Reader& reader) {
    return is_of_local_ratio(reader.curve.quantity);
  });
}

bool CurveValues::has_water() const {
  return std::any_of(curves_.begin(), curves_.end(), [](const Reader& reader) {
    return is_of_water(reader.curve.quantity);
  });
}

void CurveValues::evaluate(const State& now, const Positions& first,
                           std::span<double> values) {
  for (std::size_t i = 0; i < curves_.size(); ++i)
    values[i] = value(curves_[i], now, first);
}

/// Fills of_blocks_ with the quantity of each block, or reduces the contacts to one
/// value.
double CurveValues::of_contacts(const Reader& reader, const State& now) {
  const OtherKind& kind = *reader.other;
  const Curve& curve = reader.curve;
  if (curve.subject == Subject::model || curve.all_blocks()) {
    scratch_.clear();
    for (const ContactState& contact : now.contacts)
      scratch_.push_back(kind.contact(contact));
    const Statistic statistic =
        curve.subject == Subject::model ? Statistic{kind.natural} : curve.statistic;
    return scratch_.empty() ? 0.0 : reduce(statistic, scratch_);
  }
  of_blocks_.resize(static_cast<std::size_t>(now.blocks.size()));
  kind.of_contacts(now.contacts, of_blocks_);
  return none;
}

/// Returns the value of the contacts of a joint or of two blocks: NaN if there is no
/// contact, unless they are summed.
double CurveValues::of_joint(const Reader& reader, const State& now) {
  const OtherKind& kind = *reader.other;
  const Curve& curve = reader.curve;
  double length = 0.0;
  scratch_.clear();
  for (const ContactState& contact : now.contacts) {
    const auto [low, high] = std::minmax(contact.corner_block, contact.edge_block);
    const bool counts = curve.subject == Subject::joint
                            ? contact.state.law == curve.joint
                            : low == curve.first && high == curve.last;
    if (!counts)
      continue;
    scratch_.push_back(kind.along(contact));
    length += contact.state.length;
  }
  if (kind.per_length) {
    const double sum = scratch_.empty() ? 0.0 : reduce({Statistic::How::sum}, scratch_);
    return length > 0.0 ? sum / length : 0.0;
  }
  const Statistic statistic =
      curve.has_statistic ? curve.statistic : Statistic{kind.natural_of_joint};
  if (scratch_.empty())
    return statistic.how == Statistic::How::sum ? 0.0 : none;
  return reduce(statistic, scratch_);
}

double CurveValues::value(const Reader& reader, const State& now,
                          const Positions& first) {
  const Curve& curve = reader.curve;
  if (reader.other) {
    if (reader.other->whole)
      return reader.other->whole(now);
    if (curve.of_contacts())
      return of_joint(reader, now);
    const double whole = of_contacts(reader, now);
    if (curve.subject == Subject::model || curve.all_blocks())
      return whole;
  }
  const auto of_block = [&](int b) {
    return reader.other ? of_blocks_[static_cast<std::size_t>(b)]
                        : reader.kind->value(now.blocks, first, b);
  };
  const int blocks = now.blocks.size();
  if (curve.subject == Subject::block || curve.subject == Subject::corner) {
    const int b = curve.first - 1;
    if (b >= blocks || now.blocks.is_removed(b))
      return none;
    return curve.subject == Subject::block
               ? of_block(b)
               : of_corner(curve.quantity, b, curve.corner - 1, now.blocks, first);
  }
  const bool ranged = curve.first > 0;
  scratch_.clear();
  for (int b = ranged ? curve.first - 1 : 0;
       b < (ranged ? std::min(curve.last, blocks) : blocks); ++b) {
    const bool other_material =
        !curve.material.empty() &&
        now.blocks.material[static_cast<std::size_t>(b)] != reader.material;
    if (other_material || !reader.curve.has_block(b + 1) || now.blocks.is_removed(b))
      continue;
    const double value = of_block(b);
    if (!(is_displacement(curve.quantity) && std::isnan(value)))
      scratch_.push_back(value);
  }
  if (curve.subject == Subject::model)
    return scratch_.empty() ? 0.0 : reduce({Statistic::How::sum}, scratch_);
  return scratch_.empty() ? none : reduce(curve.statistic, scratch_);
}

}  // namespace blocks::quantities
