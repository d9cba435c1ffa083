#include "validation/cells/cases.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <exception>
#include <numbers>
#include <thread>

#include "validation/cells/networks.hpp"

namespace blocks::validation {
namespace {

using namespace geometry;
using std::numbers::pi;

// Statistics of the typical cell.
double mean(const Sums& s, int index) { return s[index] / s[sum::cells]; }
double mean_area(const Sums& s) { return mean(s, sum::area); }
double mean_perimeter(const Sums& s) { return mean(s, sum::perimeter); }
double mean_sides(const Sums& s) { return mean(s, sum::sides); }
double triangle_part(const Sums& s) { return mean(s, sum::triangles); }
double mean_edge(const Sums& s) { return s[sum::edge_length] / s[sum::edges]; }
double area_ratio(const Sums& s) {
  return mean(s, sum::area_square) / std::pow(mean_area(s), 2);
}
double area_variance(const Sums& s) {
  return mean(s, sum::area_square) - std::pow(mean_area(s), 2);
}
double relative_variance(const Sums& s) { return area_ratio(s) - 1.0; }
double variation(const Sums& s) { return std::sqrt(area_ratio(s) - 1.0); }
double side_variance(const Sums& s) {
  return mean(s, sum::sides_square) - std::pow(mean_sides(s), 2);
}
double mean_faces(const Sums& s) { return s[sum::faces] / s[sum::networks]; }
double mean_p21(const Sums& s) { return s[sum::p21] / s[sum::networks]; }

// A cell extends upwards and sideways from its lowest point, so the window needs no
// margin at its lower side.
void add_poisson_lines(std::vector<Case>& all) {
  constexpr double tau = 2.0, size = 10.0, margin = 10.0;
  const auto outline = rectangle(size + 2 * margin, size + margin);
  Case one{"Poisson lines", "tau = 2", 4000};
  one.window = {{margin, 0.0}, {margin + size, size}};
  one.identity = Identity::lines;
  one.mean_area = pi / (tau * tau);
  one.make = [=](std::uint64_t seed) { return poisson_lines(outline, tau, seed); };
  one.quantities = {
      {"E area", "pi / tau^2", one.mean_area, mean_area},
      {"E perimeter", "2 pi / tau", 2 * pi / tau, mean_perimeter},
      {"E sides", "4", 4.0, mean_sides},
      {"E A^2 / (E A)^2", "pi^2 / 2", pi * pi / 2, area_ratio},
      {"variance of sides", "(pi^2 - 8) / 2", (pi * pi - 8) / 2, side_variance},
      {"part of triangles", "2 - pi^2 / 6", 2 - pi * pi / 6, triangle_part},
      {"P21", "tau", tau, mean_p21}};
  all.push_back(one);
}

void add_windows(std::vector<Case>& all) {
  constexpr double tau = 2.0;
  const auto add = [&](const std::string& name, const std::vector<Vec2>& corners) {
    double twice = 0.0, around = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
      twice += cross(b, a);
      around += (b - a).norm();
    }
    const auto outline = polygon(corners);
    Case one{"Poisson lines in a convex window", name + ", tau = 2", 8000};
    one.identity = Identity::lines;
    one.make = [=](std::uint64_t seed) { return poisson_lines(outline, tau, seed); };
    one.quantities = {{"E faces", "1 + tau P / pi + tau^2 A / pi",
                       1 + tau * around / pi + tau * tau * twice / 2 / pi, mean_faces}};
    all.push_back(one);
  };
  add("square 5 x 5", {{0, 0}, {0, 5}, {5, 5}, {5, 0}});
  add("rectangle 12 x 1", {{0, 0}, {0, 1}, {12, 1}, {12, 0}});
  add("pentagon", {{0, 3}, {2, 10}, {9, 9}, {10, 4}, {6, 0}});
}

void add_exponential_sets(std::vector<Case>& all) {
  const auto add = [&](double s1, double s2, double angle) {
    const double sine = std::sin(angle * pi / 180.0);
    constexpr double size = 20.0;
    // A side of a cell is longer with probability exp(-15) or less.
    const double margin = std::ceil(15.0 * std::max(s1, s2) / sine);
    const auto outline = rectangle(size + 2 * margin, size + margin);
    Case one{"Two NEGEXP sets",
             fmt::format("s1 = {}, s2 = {}, a = {} degrees", s1, s2, angle), 2000};
    one.window = {{margin, 0.0}, {margin + size, size}};
    one.identity = Identity::lines;
    one.mean_area = s1 * s2 / sine;
    one.make = [=](std::uint64_t seed) {
      std::vector<JointSet> sets = {distant_set(10.0, s1, seed, 1),
                                    distant_set(10.0 + angle, s2, seed, 2)};
      for (JointSet& set : sets)
        set.law = SpacingLaw::negexp;
      return request(outline, sets);
    };
    one.quantities = {{"E area", "s1 s2 / sin a", one.mean_area, mean_area},
                      {"CV of area", "sqrt 3", std::sqrt(3.0), variation}};
    all.push_back(one);
  };
  add(0.5, 1.5, 90.0);
  add(1.0, 2.0, 60.0);
  add(0.8, 0.5, 25.0);
}

void add_uniform_sets(std::vector<Case>& all) {
  constexpr double size = 40.0, margin = 6.0, space = 2.0;
  const auto outline = rectangle(size + 2 * margin, size + margin);
  Case one{"Two UNIFORM sets", "s = 2, sdev = 1, at right angles", 2000};
  one.window = {{margin, 0.0}, {margin + size, size}};
  one.identity = Identity::lines;
  one.mean_area = space * space;
  one.make = [=](std::uint64_t seed) {
    std::vector<JointSet> sets = {distant_set(15.0, space, seed, 1),
                                  distant_set(105.0, space, seed, 2)};
    for (JointSet& set : sets)
      set.spacing.deviation = decimal(1.0);
    return request(outline, sets);
  };
  one.quantities = {{"E area", "s^2", one.mean_area, mean_area},
                    {"CV^2 of area", "(13/12)^2 - 1", std::pow(13.0 / 12.0, 2) - 1,
                     relative_variance}};
  all.push_back(one);
}

void add_persistence(std::vector<Case>& all) {
  constexpr double trace = 3.0, gap = 2.0, space = 0.5;
  const auto outline = rectangle(20.0, 20.0);
  const auto add = [&](const std::string& name, SpacingLaw law, bool deviates) {
    Case one{"Persistence: trace 3, gap 2, space 0.5", name, 1000};
    one.make = [=](std::uint64_t seed) {
      JointSet set = distant_set(35.0, space, seed, 1);
      set.law = law;
      set.trace.mean = decimal(trace);
      set.gap.mean = decimal(gap);
      if (law == SpacingLaw::poisson)
        set.start = {decimal(4.0), decimal(7.0)};
      if (deviates) {
        set.dip.deviation = decimal(10.0);
        set.spacing.deviation = decimal(law == SpacingLaw::uniform ? 0.4 : 0.0);
        set.trace.deviation = decimal(2.0);
        set.gap.deviation = decimal(2.0);
      }
      return request(outline, {set});
    };
    one.quantities = {{"P21 before pruning", "trace / ((trace + gap) space)",
                       trace / ((trace + gap) * space), mean_p21}};
    all.push_back(one);
  };
  add("UNIFORM", SpacingLaw::uniform, false);
  add("UNIFORM, half ranges", SpacingLaw::uniform, true);
  add("NEGEXP", SpacingLaw::negexp, false);
  add("NEGEXP, half ranges", SpacingLaw::negexp, true);
  add("POISSON", SpacingLaw::poisson, false);
  add("POISSON, half ranges", SpacingLaw::poisson, true);
}

// The number of points is drawn from Poisson's law, as the exact values require.
void add_voronoi(std::vector<Case>& all) {
  constexpr double lambda = 4.0, size = 10.0, margin = 2.5, side = size + 2 * margin;
  const auto outline = rectangle(side, side);
  Case one{"Poisson Voronoi cells", "lambda = 4", 1200};
  one.window = {{margin, margin}, {margin + size, margin + size}};
  one.identity = Identity::voronoi;
  one.mean_area = 1.0 / lambda;
  one.make = [=](std::uint64_t seed) {
    return poisson_voronoi(outline, lambda * side * side, seed);
  };
  const double root = std::sqrt(lambda);
  one.quantities = {{"E area", "1 / lambda", 1 / lambda, mean_area},
                    {"E sides", "6", 6.0, mean_sides},
                    {"E perimeter", "4 / sqrt(lambda)", 4 / root, mean_perimeter},
                    {"E edge", "2 / (3 sqrt(lambda))", 2 / (3 * root), mean_edge},
                    {"variance of area", "0.28018 / lambda^2",
                     0.28018 / (lambda * lambda), area_variance},
                    {"variance of sides", "1.7808", 1.7808, side_variance}};
  all.push_back(one);
}

}  // namespace

std::vector<Case> cases() {
  std::vector<Case> all;
  add_poisson_lines(all);
  add_windows(all);
  add_exponential_sets(all);
  add_uniform_sets(all);
  add_persistence(all);
  add_voronoi(all);
  return all;
}

std::vector<Sums> samples(const Case& one, std::uint64_t first, int count,
                          int threads) {
  std::vector<Sums> result(static_cast<std::size_t>(count));
  std::atomic<int> next = 0;
  std::exception_ptr fault;
  std::atomic<bool> failed = false;
  const auto work = [&] {
    try {
      for (int i = next++; i < count && !failed; i = next++)
        result[static_cast<std::size_t>(i)] =
            sample(one.make(first + static_cast<std::uint64_t>(i)), one.window,
                   one.identity, one.mean_area);
    } catch (...) {
      if (!failed.exchange(true))
        fault = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> more;
    for (int t = 1; t < threads; ++t)
      more.emplace_back(work);
    work();
  }
  if (fault)
    std::rethrow_exception(fault);
  return result;
}

}  // namespace blocks::validation
