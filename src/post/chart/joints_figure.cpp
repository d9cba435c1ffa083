#include "post/chart/joints_figure.hpp"

#include <fmt/format.h>

#include <numeric>

#include "draw/chart/rose_figure.hpp"
#include "draw/number_text.hpp"
#include "post/chart/joint_statistics.hpp"
#include "text/counted.hpp"

namespace blocks::post {

using namespace draw;

namespace {

std::vector<Histogram> histograms_of(const JointStatistics& joints,
                                     const FigureOptions& options) {
  constexpr Dimension area{2, 0, 0, "m²", ""};
  const std::string unit = unit_text(area, options.units);
  const double mean = std::accumulate(joints.sides.begin(), joints.sides.end(), 0.0) /
                      static_cast<double>(joints.sides.size());
  return {Histogram{options.with_unit("area", area), joints.area, false,
                    fmt::format("median {:.3g} {}", median_of(joints.area), unit)},
          {"aspect ratio", joints.aspect, false,
           fmt::format("median {:.3g}", median_of(joints.aspect))},
          {"number of sides", joints.sides, true, fmt::format("mean {:.3g}", mean)}};
}

}  // namespace

void draw_joints_figure(const std::string& path, const Frame& frame,
                        const std::string& title, const FigureOptions& options) {
  const JointStatistics joints = joint_statistics(frame);
  const std::string subtitle =
      fmt::format("{}    {}    {}", time_text(frame.time, std::nullopt, options.units),
                  counted(joints.area.size(), "block") + " at joints",
                  counted(joints.directions.groups.size(), "joint id"));
  draw_rose_figure(path, options.page,
                   {options.title.value_or(title.empty() ? "BLOCKS" : title),
                    options.subtitle.empty() ? subtitle : options.subtitle,
                    joints.directions,
                    [](int id) { return fmt::format("joint {}", id); },
                    histograms_of(joints, options)});
}

}  // namespace blocks::post
