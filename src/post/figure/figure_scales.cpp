#include "post/figure/figure_scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "post/figure/sides.hpp"
#include "post/read/force_network.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/joint_faces.hpp"
#include "post/read/joint_ids.hpp"
#include "post/read/piece_families.hpp"
#include "quantities/statistic.hpp"

namespace blocks::post {

using namespace draw;

namespace {

/// Returns the median of the positive numbers, so that a single impact does not hide
/// all other values.
double usual(std::vector<double> largest) {
  std::erase_if(largest, [](double value) { return !(value > 0.0); });
  if (largest.empty())
    return 0.0;
  const auto middle = largest.begin() + static_cast<long>(largest.size() / 2);
  std::nth_element(largest.begin(), middle, largest.end());
  return *middle;
}

}  // namespace

std::vector<std::string> arrow_names() { return {"velocity", "displacement", "force"}; }

Eigen::Matrix2Xd arrow_vectors(const std::string& name, const Picture& picture) {
  if (name == "velocity")
    return picture.now.velocity;
  if (name == "force")
    return picture.now.force;
  if (name == "displacement") {
    Eigen::Matrix2Xd moved(2, picture.now.size());
    moved.row(0) = quantity("dx", picture.now, picture.first).values.transpose();
    moved.row(1) = quantity("dy", picture.now, picture.first).values.transpose();
    return moved;
  }
  throw std::runtime_error("there are no arrows for '" + name +
                           "': choose velocity, displacement or force");
}

void ScaleSurvey::include_corners(const Frame& frame) {
  for (const auto& outline : frame.outlines)
    for (const Eigen::Vector2d& p : outline) {
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
}

void ScaleSurvey::include(const Picture& picture) {
  const Frame& now = picture.now;
  // If all blocks are removed, the picture shows the empty place where they were.
  include_corners(now.count_present() > 0 ? now : picture.original_frame());
  found_.block_counts.insert(now.count_present());
  for (int b = 0; b < now.size(); ++b) {
    if (now.is_removed(b))
      continue;
    found_.materials.insert(now.material[static_cast<std::size_t>(b)]);
    found_.fixed = found_.fixed || now.fixed[static_cast<std::size_t>(b)] != 0;
  }
  if (options_.original)
    include_corners(picture.original_frame());
  found_.cracks = found_.cracks || (options_.shows_cracks() &&
                                    picture.cracked != nullptr && now.cracks > 0);
  found_.water = found_.water || !now.water_line.empty();
  if (options_.shows_joints())
    found_.joints.merge(joints_of(now));
  if (options_.shows_bonds())
    for (const FacePart& part : face_parts(now, picture.contacts)) {
      found_.bonds.insert(part.bond);
      found_.slip = std::max(found_.slip, part.slip);
    }
  const auto include_values = [&](const Eigen::VectorXd& values) {
    for (const double value : values)
      if (std::isfinite(value)) {
        min_ = std::min(min_, value);
        max_ = std::max(max_, value);
      }
  };
  if (options_.shows_faces()) {
    const Zero zero = face_quantity(options_.colour).zero;
    centred_ = map_of(options_, zero).diverging;
    for (int mirrored = 0; mirrored <= (options_.mirror ? 1 : 0); ++mirrored)
      for (const ValuedSide& side :
           valued_sides(options_.colour, picture, mirrored == 1)) {
        include_values(side.values);
        if (zero == Zero::lowest)
          min_ = std::min(min_, 0.0);
      }
  }
  if (options_.shows_quantity()) {
    const Quantity shown =
        quantity(options_.colour, picture.now, picture.first, picture.contacts);
    logarithmic_ = shown.logarithmic;
    centred_ = map_of(options_, shown.zero).diverging;
    include_values(shown.values);
    if (options_.mirror)
      include_values(in_mirror(options_.colour, shown.values, options_.mirror_x));
  }
  if (options_.forces) {
    const auto links = force_network(picture.contacts);
    forces_.push_back(links.empty() ? 0.0 : links.back().force.norm());
  }
  if (!options_.arrows.empty()) {
    const Eigen::Matrix2Xd vectors = arrow_vectors(options_.arrows, picture);
    std::vector<double> lengths;
    for (int b = 0; b < now.size(); ++b)
      if (const double length = vectors.col(b).norm();
          length > 0.0 && !now.is_removed(b))
        lengths.push_back(length);
    include_arrows(lengths);
  }
  if (picture.now.area.size() > 0)
    found_.block_size = std::sqrt(usual(
        {picture.now.area.data(), picture.now.area.data() + picture.now.area.size()}));
}

void ScaleSurvey::include_arrows(std::vector<double> lengths) {
  if (lengths.empty())
    return;
  longest_arrow_ =
      std::max(longest_arrow_, *std::max_element(lengths.begin(), lengths.end()));
  const double percent = options_.arrow_scale.value_or(ArrowScale()).percent;
  arrows_.push_back(
      quantities::reduce({quantities::Statistic::How::percentile, percent}, lengths));
}

ValueRange ScaleSurvey::colours() const {
  ValueRange range;
  if (options_.range) {
    range = {(*options_.range)[0], (*options_.range)[1]};
    if (!(range.low < range.high))
      throw std::runtime_error("the range of the colours needs low < high");
    range.logarithmic = logarithmic_ && range.low > 0.0;
  } else if (logarithmic_ && max_ > 0.0) {
    // Small values would otherwise share one colour with those of fixed blocks, 0.
    constexpr int decades = 4;  // with more, neighbouring decades look the same
    range = ValueRange::of_decades(0.0, max_, decades);
  } else if (min_ <= max_) {
    range.low = std::min(0.0, min_);
    range.high = max_;
    // Values of one sign need only half of the colours, and those of nearly one sign
    // little more.
    constexpr double little = 0.1;
    const double largest = std::max(std::abs(min_), std::abs(max_));
    const bool is_lopsided =
        min_ < 0.0 && max_ > 0.0 && std::min(-min_, max_) < little * largest;
    if (centred_ && !is_lopsided) {
      range.low = min_ < 0.0 ? -largest : 0.0;
      range.high = max_ > 0.0 ? largest : 0.0;
    }
    if (!(range.high > range.low)) {  // all values are equal
      range.high = range.low + 1.0;
      if (centred_)
        range.low = -1.0, range.high = 1.0;
    }
  }
  return range;
}

FigureScales ScaleSurvey::scales() const {
  FigureScales result = found_;
  if (options_.zoom) {
    result.view = *options_.zoom;
    if (!(result.view[0] < result.view[1] && result.view[2] < result.view[3]))
      throw std::runtime_error("the zoom needs xmin < xmax and ymin < ymax");
  } else if (low_.x() <= high_.x()) {
    double left = low_.x(), right = high_.x();
    if (options_.mirror) {
      left = std::min(left, 2.0 * options_.mirror_x - high_.x());
      right = std::max(right, 2.0 * options_.mirror_x - low_.x());
    }
    const double margin =
        std::max(0.03 * std::max(right - left, high_.y() - low_.y()), 1e-12);
    result.view = {left - margin, right + margin, low_.y() - margin,
                   high_.y() + margin};
  }
  if (options_.shows_joints() && found_.joints.empty())
    throw std::runtime_error(no_joints_text());
  if (options_.shows_bonds() && found_.bonds.empty())
    throw std::runtime_error(no_laws_text());
  if (options_.shows_faces() && min_ > max_)
    throw std::runtime_error(no_faces_text(options_.colour));
  if (options_.shows_families() && found_.materials == std::set<int>{0})
    throw std::runtime_error("no block has split at the times drawn\n  hint: blocks "
                             "split if their material has a CRACK card");
  if (const QuantityKind* kind = quantities::find_quantity(options_.colour);
      kind && is_internal_stress(*kind) && min_ == 0.0 && max_ == 0.0)
    throw std::runtime_error(
        "every stress is 0: RIGID blocks have no stress, and other blocks have none "
        "before they deform; choose another quantity or time");
  result.colours = colours();
  if (options_.range) {
    result.cuts_low = min_ < result.colours.low && min_ <= max_;
    result.cuts_high = max_ > result.colours.high;
  }
  result.is_zero = min_ == 0.0 && max_ == 0.0 && !options_.range;
  result.force = usual(forces_);
  const bool is_given = options_.arrow_scale && options_.arrow_scale->value > 0.0;
  result.arrow = is_given ? options_.arrow_scale->value : usual(arrows_);
  result.cuts_arrows = options_.arrow_scale && longest_arrow_ > result.arrow;
  return result;
}

void for_each_picture(const ResultsReader& results, const std::vector<long>& frames,
                      const FigureOptions& options,
                      const std::function<void(std::size_t, const Picture&)>& action) {
  const bool with_contacts =
      options.forces || options.shows_bonds() || quantities::find_other(options.colour);
  ResultsTracker tracker(results);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    Frame now = results.frame(frames[k]);
    if (options.shows_families())
      now.material = families_of(now);
    const FrameContacts contacts =
        with_contacts ? results.contacts(frames[k]) : FrameContacts{};
    const CrackedBlocks& cracked = tracker.at(frames[k], now);
    action(k, {now, cracked.first, contacts, &tracker.first(), &cracked});
  }
}

ColourMap map_of(const FigureOptions& options, Zero zero) {
  if (options.colour_map.empty())
    return colour_map(usual_colour_map(zero));
  return colour_map(options.colour_map);
}

ColourMap map_of(const FigureOptions& options, Zero zero, const ValueRange& range) {
  return map_of(options, zero).for_range(range.low, range.high);
}

FigureScales survey_scales(const ResultsReader& results,
                           const std::vector<long>& frames,
                           const FigureOptions& options) {
  if (frames.empty())
    throw std::runtime_error("there is no time to draw");
  ScaleSurvey survey(options);
  for_each_picture(results, frames, options,
                   [&](std::size_t, const Picture& one) { survey.include(one); });
  return survey.scales();
}

void require_blocks_in_zoom(const ResultsReader& results,
                            const std::vector<long>& frames,
                            const FigureOptions& options) {
  if (!options.zoom)
    return;
  const Eigen::Vector4d& zoom = *options.zoom;
  if (!(zoom[0] < zoom[1] && zoom[2] < zoom[3]))
    throw std::runtime_error("the zoom needs xmin < xmax and ymin < ymax");
  Eigen::Vector4d all(1e300, -1e300, 1e300, -1e300);  // ordered like the zoom
  for (const long i : frames)
    for (const auto& outline : results.frame(i).outlines) {
      Eigen::Vector4d box(1e300, -1e300, 1e300, -1e300);
      for (const Eigen::Vector2d& p : outline)
        for (const double x :
             {p.x(), options.mirror ? 2.0 * options.mirror_x - p.x() : p.x()})
          box = {std::min(box[0], x), std::max(box[1], x), std::min(box[2], p.y()),
                 std::max(box[3], p.y())};
      if (box[0] <= zoom[1] && box[1] >= zoom[0] && box[2] <= zoom[3] &&
          box[3] >= zoom[2])
        return;
      all = {std::min(all[0], box[0]), std::max(all[1], box[1]),
             std::min(all[2], box[2]), std::max(all[3], box[3])};
    }
  throw std::runtime_error(fmt::format(
      "there is no block in the zoom: the blocks lie in x {:.6g} to {:.6g}, "
      "y {:.6g} to {:.6g}",
      all[0], all[1], all[2], all[3]));
}

}  // namespace blocks::post
