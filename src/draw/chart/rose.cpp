#include "draw/chart/rose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/axes.hpp"
#include "draw/joint_colours.hpp"

namespace blocks::draw {
namespace {

constexpr Colour ring_colour{0.82, 0.82, 0.83};
constexpr double rose_entry = 44;  ///< height of an entry of the legend
constexpr double letter = 14, small_letter = 12.5;

class RoseDrawing {
 public:
  RoseDrawing(Pen& pen, const RosePlace& place, const Directions& directions)
      : pen_(pen), cairo_(pen.cairo()), place_(place), directions_(directions),
        sum_(directions.groups.begin()->second.sectors.size(), 0.0) {
    for (const auto& [id, one] : directions.groups)
      for (std::size_t k = 0; k < sum_.size(); ++k)
        sum_[k] += one.sectors[k];
    max_ = *std::max_element(sum_.begin(), sum_.end());
  }

  void draw() {
    disc();
    rings();
    std::vector<double> below(sum_.size(), 0.0);
    for (const auto& [id, one] : directions_.groups)
      for (std::size_t k = 0; k < below.size(); ++k) {
        if (one.sectors[k] > 0.0)
          sector(k, radius(below[k]), radius(below[k] + one.sectors[k]),
                 joint_colour(id));
        below[k] += one.sectors[k];
      }
    rim();
    means();
  }

 private:
  /// Returns the radius that encloses a share of all lengths in one sector.
  double radius(double share) const {
    return place_.radius * std::sqrt(std::min(share / max_, 1.0));
  }
  Eigen::Vector2d at(double degrees, double r) const {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {place_.x + r * std::cos(angle), place_.y - r * std::sin(angle)};
  }
  void arc(double r, double from, double to) {
    constexpr double step = 2.0;  // degrees
    const int parts =
        std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / step)));
    for (int i = 0; i <= parts; ++i) {
      const Eigen::Vector2d p = at(from + (to - from) * i / parts, r);
      cairo_line_to(cairo_, p.x(), p.y());
    }
  }

  void disc() {
    cairo_new_path(cairo_);
    arc(place_.radius, 0, 180);
    cairo_close_path(cairo_);
    pen_.fill({0.965, 0.965, 0.968});
  }

  /// Draws circles of equal share of length, with their percentages below the base.
  void rings() {
    constexpr double gap = 9;
    double last = 0.0;
    for (const double percent : nice_ticks(0.0, 100.0 * max_, 4)) {
      const double r = radius(percent / 100.0);
      if (percent <= 0.0)
        continue;
      if (place_.radius - r > 4.0) {  // not beside the outline
        cairo_new_path(cairo_);
        arc(r, 0, 180);
        pen_.stroke(0.8, ring_colour);
      }
      const std::string words = fmt::format("{:g} %", percent);
      const double half = 0.5 * pen_.width(words, small_letter);
      if (r - half >= last + gap && r + half < place_.radius + 18) {
        pen_.text(words, place_.x + r, place_.y + 9, small_letter, muted, 0.5, 0);
        last = r + half;
      }
    }
    for (int degrees = 30; degrees < 180; degrees += 30)
      line(degrees, 0.0, place_.radius, 0.8, ring_colour);
  }

  void line(double degrees, double from, double to, double width, const Colour& c) {
    const Eigen::Vector2d a = at(degrees, from), b = at(degrees, to);
    pen_.line(a.x(), a.y(), b.x(), b.y(), width, c);
  }

  /// Draws sector k; half of sector 0 is at 180 degrees.
  void sector(std::size_t k, double inner, double outer, const Colour& colour) {
    const double half = 0.5 * directions_.sector;
    const double middle = directions_.sector * static_cast<double>(k);
    const auto part = [&](double from, double to) {
      cairo_new_path(cairo_);
      arc(outer, from, to);
      if (inner > 0.0)
        arc(inner, to, from);
      else
        cairo_line_to(cairo_, place_.x, place_.y);
      cairo_close_path(cairo_);
      pen_.fill_and_stroke(colour, 0.9, white);
    };
    if (k == 0) {
      part(0.0, half);
      part(180.0 - half, 180.0);
    } else {
      part(middle - half, middle + half);
    }
  }

  void rim() {
    cairo_new_path(cairo_);
    arc(place_.radius, 0, 180);
    cairo_close_path(cairo_);
    pen_.stroke(1.0, ink);
    for (int degrees = 0; degrees <= 180; degrees += 10) {
      const bool is_named = degrees % 30 == 0;
      line(degrees, place_.radius, place_.radius + (is_named ? 7 : 4), 1.0, ink);
      if (!is_named)
        continue;
      const Eigen::Vector2d p = at(degrees, place_.radius + 16);
      const double across = std::cos(degrees * std::numbers::pi / 180.0);
      const double up = std::sin(degrees * std::numbers::pi / 180.0);
      pen_.text(fmt::format("{}°", degrees), p.x(), p.y(), letter, ink,
                0.5 - 0.5 * across, 0.5 + 0.5 * up);
    }
    pen_.text("direction, anticlockwise from x", place_.x, place_.y + 32, 15, ink, 0.5,
              0, 2.0 * (place_.radius + RosePlace::beside));
  }

  /// Marks the mean direction of each group that has one, outside of the half disc.
  void means() {
    for (const auto& [id, one] : directions_.groups) {
      if (!one.deviation)
        continue;
      constexpr double half_width = 1.3, length = 11;  // of a triangle
      const double r = place_.radius + 1;
      const double wide = std::min(half_width * 250.0 / place_.radius, 4.0);
      for (const auto& p : {at(one.mean, r), at(one.mean - wide, r + length),
                            at(one.mean + wide, r + length)})
        cairo_line_to(cairo_, p.x(), p.y());
      cairo_close_path(cairo_);
      pen_.fill_and_stroke(joint_colour(id), 0.8, white);
    }
  }

  Pen& pen_;
  cairo_t* cairo_;
  const RosePlace& place_;
  const Directions& directions_;
  std::vector<double> sum_;  ///< of all groups, by sector
  double max_ = 0.0;         ///< the largest of them
};

std::string percent_text(double share) {
  return share < 0.001 ? "< 0.1 %"
                       : fmt::format("{:.{}f} %", 100 * share, share < 0.1 ? 1 : 0);
}

/// Returns "35.0° ± 1.2°"; a mean that would be written as 180.0 is 0.0.
std::string direction_text(const GroupDirections& one) {
  constexpr double last_written = 179.95;
  return one.deviation
             ? fmt::format("{:.1f}° ± {:.1f}°",
                           one.mean < last_written ? one.mean : 0.0, *one.deviation)
             : "no preferred direction";
}

}  // namespace

void draw_rose(Pen& pen, const RosePlace& place, const Directions& directions) {
  RoseDrawing(pen, place, directions).draw();
}

double rose_legend_height(const Directions& directions) {
  return rose_entry *
         static_cast<double>(std::min(directions.groups.size(), max_joints_listed + 1));
}

void draw_rose_legend(Pen& pen, double x, double top, double width,
                      const Directions& directions,
                      const std::function<std::string(int)>& name_of) {
  constexpr double indent = 30;
  double y = top;
  std::size_t listed = 0;
  for (const auto& [id, one] : directions.groups) {
    if (++listed > max_joints_listed) {
      pen.text(fmt::format("and {} more", directions.groups.size() - max_joints_listed),
               x + indent, y + 8, letter, ink, 0, 0.5, width - indent);
      return;
    }
    cairo_rectangle(pen.cairo(), x, y, 20, 15);
    pen.fill(joint_colour(id));
    pen.text(name_of(id), x + indent, y + 7.5, letter, ink, 0, 0.5, width - indent);
    pen.text(fmt::format("{}, {} of the length", direction_text(one),
                         percent_text(one.share)),
             x + indent, y + 25, small_letter, muted, 0, 0.5, width - indent);
    y += rose_entry;
  }
}

}  // namespace blocks::draw
