#include "post/chart/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "post/read/crack_tracker.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/material_list.hpp"
#include "quantities/energy.hpp"

namespace blocks::post {
namespace {

using Subject = Curve::Subject;
using quantities::OtherKind;
using quantities::Statistic;
using How = Statistic::How;

/// Returns "largest speed", "90th percentile of y", ...
std::string reduced_label(const Statistic& statistic, const std::string& label) {
  switch (statistic.how) {
  case How::largest:
    return "largest " + label;
  case How::smallest:
    return "smallest " + label;
  case How::mean:
    return "mean " + label;
  case How::sum:
    return "sum of " + label;
  case How::percentile:
    break;
  }
  return fmt::format("percentile {} of {}", statistic.percent, label);
}

std::string label_of(const Curve& curve, const std::string& label) {
  switch (curve.subject) {
  case Subject::block:
    return fmt::format("{} of block {}", label, curve.first);
  case Subject::corner:
    return fmt::format("{} of block {}, corner {}", label, curve.first, curve.corner);
  case Subject::joint:
  case Subject::pair: {
    const std::string place =
        curve.subject == Subject::joint
            ? fmt::format("joint {}", curve.joint)
            : fmt::format("blocks {} and {}", curve.first, curve.last);
    return fmt::format(
        "{} of {}", curve.has_statistic ? reduced_label(curve.statistic, label) : label,
        place);
  }
  case Subject::blocks:
    break;
  case Subject::model:
    return label;
  }
  const std::string reduced = reduced_label(curve.statistic, label);
  if (curve.all_blocks())
    return reduced;
  return reduced + (curve.material.empty()
                        ? (curve.ranges.empty() ? fmt::format(", blocks {} to {}",
                                                              curve.first, curve.last)
                                                : ", blocks " + curve.numbers())
                        : ", material " + curve.material);
}

Series empty_series(const Curve& curve, bool compression_positive) {
  if (const OtherKind* other = quantities::find_other(curve.quantity)) {
    const bool largest =
        other->natural == How::largest && curve.subject == Subject::model;
    return {curve,
            label_of(curve, largest ? "largest " + other->label : other->label),
            other->label,
            other->dimension,
            {}};
  }
  const QuantityKind& kind = *quantities::find_quantity(curve.quantity);
  return {curve,
          label_of(curve, kind.label),
          kind.label + sign_convention(kind, compression_positive),
          kind.dimension,
          {}};
}

/// What is asked of the results.
struct Question {
  const std::vector<const ResultsReader*>& parts;
  const std::vector<Curve>& curves;
  const TimeRange& range;
  const quantities::MaterialNumbers& materials;
  bool compression_positive;

  /// Whether part i has this time, and not the next part.
  bool has_time(std::size_t i, double t) const {
    return t >= range.from && t <= range.to && is_of_part(i, t);
  }
  /// Whether the next part does not have this time.
  bool is_of_part(std::size_t i, double t) const {
    return i + 1 == parts.size() || t < parts[i + 1]->times().front();
  }
  /// The name of a curve with the number of its material.
  std::string key(Curve curve) const {
    const int number = quantities::material_number(curve.material, materials);
    if (number > 0)
      curve.material = std::to_string(number);
    return curve.name();
  }
};

/// Returns the outlines of all blocks, each from the last frame of all parts that shows
/// it: a removed block has none there.
std::vector<std::vector<Eigen::Vector2d>>
last_outlines(const std::vector<const ResultsReader*>& parts) {
  auto outlines = parts.back()->last_outlines(parts.back()->frames() - 1);
  for (std::size_t i = parts.size() - 1; i-- > 0;) {
    if (std::none_of(outlines.begin(), outlines.end(),
                     [](const auto& outline) { return outline.empty(); }))
      break;
    const auto earlier = parts[i]->last_outlines(parts[i]->frames() - 1);
    for (std::size_t b = 0; b < std::min(outlines.size(), earlier.size()); ++b)
      if (outlines[b].empty())
        outlines[b] = earlier[b];
  }
  return outlines;
}

/// Whether a block that has split had this corner in some frame.
bool had_corner(const Question& question, const Curve& curve) {
  const auto b = static_cast<std::size_t>(curve.first) - 1;
  if (question.parts.back()->cracks().empty())
    return false;
  for (const ResultsReader* part : question.parts)
    for (long i = 0; i < part->frames(); ++i) {
      const Frame frame = part->frame(i);
      if (b < frame.outlines.size() &&
          static_cast<std::size_t>(curve.corner) <= frame.outlines[b].size())
        return true;
    }
  return false;
}

void require_places(const Question& question) {
  const ResultsReader& results = *question.parts.back();
  const Frame last = results.frame(results.frames() - 1);  // blocks keep their numbers
  std::vector<std::vector<Eigen::Vector2d>> outlines;  // read if a corner is asked for
  const std::set<int> materials(last.material.begin(), last.material.end());
  for (const Curve& curve : question.curves) {
    if (curve.quantity.starts_with(quantities::energy_prefix))
      throw std::runtime_error(fmt::format("{} has no {}: name it on the HISTORY card",
                                           results.path(), curve.name()));
    const OtherKind* kind = quantities::find_other(curve.quantity);
    if (((kind != nullptr && kind->of_laws) || curve.joint > 0) && !results.has_laws())
      throw std::runtime_error(
          fmt::format("{} has no joints with a law, so there is no {}\n  hint: the "
                      "cards JOINT and JPAIR give joints a law",
                      results.path(), curve.name()));
    if (quantities::is_of_equilibrium(curve.quantity) && !results.has_unbalanced())
      throw std::runtime_error(results.path() + ": " + no_unbalanced_text());
    if (curve.last > last.size())
      throw std::runtime_error(fmt::format("{} has blocks 1 to {}, no block {}",
                                           results.path(), last.size(), curve.last));
    if (!curve.material.empty() && !materials.contains(quantities::material_number(
                                       curve.material, question.materials)))
      throw std::runtime_error(fmt::format("{} has no blocks of material {}: choose {}",
                                           results.path(), curve.material,
                                           material_list(results)));
    if (curve.subject != Subject::corner)
      continue;
    if (outlines.empty())
      outlines = last_outlines(question.parts);
    const std::size_t corners =
        outlines[static_cast<std::size_t>(curve.first) - 1].size();
    if (static_cast<std::size_t>(curve.corner) > corners &&
        !had_corner(question, curve))
      throw std::runtime_error(
          fmt::format("{}: block {} has corners 1 to {}, no corner {}", results.path(),
                      curve.first, corners, curve.corner));
  }
}

void add_frames(const Question& question, History& history) {
  require_places(question);
  Frame before = question.parts.front()->frame(0);
  CrackTracker tracker(before, question.parts.back()->cracks());
  quantities::CurveValues values_of(question.curves, question.materials);
  std::vector<double> values(values_of.size());
  for (std::size_t part = 0; part < question.parts.size(); ++part) {
    const ResultsReader& results = *question.parts[part];
    for (long i = 0; i < results.frames(); ++i) {
      const double t = results.times()[static_cast<std::size_t>(i)];
      if (!question.is_of_part(part, t))
        break;
      // Earlier frames are needed to follow the pieces of blocks that split.
      const bool shown = t >= question.range.from && t <= question.range.to;
      if (!shown && (tracker.cracks().empty() || t > question.range.to))
        continue;
      Frame now = results.frame(i);
      tracker.advance(before, now);
      if (!shown) {
        before = std::move(now);
        continue;
      }
      std::vector<quantities::ContactState> contacts;
      if (values_of.has_contacts())
        contacts = states_of(results.contacts(i));
      values_of.evaluate({now.time, now.step, states_of(now), contacts, nullptr,
                          now.unbalanced_ratio, static_cast<std::size_t>(now.cracks)},
                         states_of(tracker.blocks().first), values);
      history.time.push_back(t);
      for (std::size_t k = 0; k < values.size(); ++k)
        history.series[k].values.push_back(values[k]);
      before = std::move(now);
    }
  }
}

/// The factor that gives recorded values of a curve the sign of the reader; 0 if the
/// values of other blocks or directions would be needed: the largest tension is not the
/// largest compression.
double sign_of(const Curve& curve, bool compression_positive) {
  const QuantityKind* kind = quantities::find_quantity(curve.quantity);
  if (!compression_positive || kind == nullptr || !quantities::is_stress(*kind))
    return 1.0;
  const How how = curve.statistic.how;
  const bool ordered =
      curve.subject == Subject::blocks && how != How::sum && how != How::mean;
  return ordered || kind->name == "p1" || kind->name == "p2" ? 0.0 : -1.0;
}

/// The histories that the parts recorded.
class Recorded {
 public:
  explicit Recorded(const Question& question) : question_(question) {
    for (const ResultsReader* part : question.parts)
      parts_.push_back(part->recorded());
    for (const auto& sections : parts_)
      for (const RecordedHistory& section : sections)
        for (const std::string& name : section.quantities)
          keys_.insert(key(name));
  }

  /// Whether any of the curves was recorded.
  bool has_any() const {
    const auto& curves = question_.curves;
    return std::any_of(curves.begin(), curves.end(),
                       [this](const Curve& c) { return has(c); });
  }

  /// Adds the samples of all sections that have all curves. If they cannot be used,
  /// returns why, and adds none.
  std::string add_to(History& history) const {
    for (const Curve& curve : question_.curves) {
      if (!has(curve))
        return curve.name() + " was not recorded";
      if (sign_of(curve, question_.compression_positive) == 0.0)
        return curve.name() + " was recorded with tension positive";
    }
    if (quantities::CurveValues(question_.curves).has_displacements()) {
      if (parts_.size() > 1)
        return "recorded displacements of each part begin at its own first frame";
      // Frames have no energies.
      if (!question_.parts.back()->cracks().empty() && !has_energies())
        return "recorded displacements end where a block splits";
    }
    std::vector<std::vector<Rows>> rows;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      rows.push_back(rows_of(parts_[part]));
      if (rows.back().empty())
        return fmt::format("no HISTORY card of {} has all of them",
                           question_.parts[part]->path());
    }
    for (std::size_t part = 0; part < parts_.size(); ++part)
      for (const Rows& of_section : rows[part])
        add_section(part, of_section, history);
    return {};
  }

 private:
  /// A section, and the row of each curve in it.
  struct Rows {
    const RecordedHistory* section;
    std::vector<Eigen::Index> of_curves;
  };

  bool has_energies() const {
    return std::any_of(question_.curves.begin(), question_.curves.end(),
                       [](const Curve& curve) {
                         return curve.quantity.starts_with(quantities::energy_prefix);
                       });
  }

  bool has(const Curve& curve) const { return keys_.contains(question_.key(curve)); }

  std::string key(const std::string& name) const {
    return question_.key(quantities::parse_curve(name));
  }

  std::vector<Rows> rows_of(const std::vector<RecordedHistory>& sections) const {
    std::vector<Rows> found;
    for (const RecordedHistory& section : sections) {
      Rows rows{&section, {}};
      for (const Curve& curve : question_.curves)
        for (std::size_t i = 0; i < section.quantities.size(); ++i)
          if (key(section.quantities[i]) == question_.key(curve)) {
            rows.of_curves.push_back(static_cast<Eigen::Index>(i));
            break;
          }
      if (rows.of_curves.size() == question_.curves.size())
        found.push_back(std::move(rows));
    }
    return found;
  }

  /// Two sections may have the time at which one of them ends and the other begins.
  void add_section(std::size_t part, const Rows& rows, History& history) const {
    for (std::size_t i = 0; i < rows.section->time.size(); ++i) {
      const double t = rows.section->time[i];
      if (!question_.has_time(part, t) ||
          (!history.time.empty() && t <= history.time.back()))
        continue;
      history.time.push_back(t);
      for (std::size_t k = 0; k < rows.of_curves.size(); ++k)
        history.series[k].values.push_back(
            sign_of(question_.curves[k], question_.compression_positive) *
            rows.section->values(rows.of_curves[k], static_cast<Eigen::Index>(i)));
    }
  }

  const Question& question_;
  std::vector<std::vector<RecordedHistory>> parts_;
  std::set<std::string> keys_;
};

}  // namespace

History read_history(const std::vector<const ResultsReader*>& parts,
                     const std::vector<Curve>& curves, const TimeRange& range,
                     bool frames, const quantities::MaterialNumbers& materials) {
  const ResultsReader &begin = *parts.front(), &end = *parts.back();
  const Question question{parts, curves, range, materials,
                          begin.is_compression_positive()};
  History history{begin.path(), begin.title(), {}, {}};
  for (std::size_t i = 1; i < parts.size(); ++i)
    history.file += " + " + parts[i]->path();
  for (const Curve& curve : curves)
    history.series.push_back(empty_series(curve, question.compression_positive));
  if (frames) {
    add_frames(question, history);
  } else if (const Recorded recorded(question); !recorded.has_any()) {
    add_frames(question, history);
  } else if (history.without_samples = recorded.add_to(history);
             !history.without_samples.empty()) {
    add_frames(question, history);
  }
  if (history.time.empty())
    throw std::runtime_error(fmt::format("{} has times {:g} to {:g}, none between {:g} "
                                         "and {:g}",
                                         history.file, begin.times().front(),
                                         end.times().back(), range.from, range.to));
  return history;
}

std::vector<Curve> recorded_curves(const ResultsReader& results) {
  std::vector<Curve> curves;
  if (const auto sections = results.recorded(); !sections.empty())
    for (const std::string& name : sections.back().quantities)
      curves.push_back(quantities::parse_curve(name));
  return curves;
}

}  // namespace blocks::post
