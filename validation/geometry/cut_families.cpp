#include "validation/geometry/cut_families.hpp"

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/joint_sources.hpp"
#include "geometry/random.hpp"

namespace blocks::validation {
namespace {

using geometry::CutRequest;
using geometry::Decimal;
using geometry::DecimalPoint;
using geometry::Vec2;
using Whole = std::int64_t;

// The random numbers of one network. The modulus favours small results by less than
// 1e-6.
class Draw {
 public:
  Draw(std::uint64_t family, std::uint64_t number) : key_{1000 + family, number} {}
  /// low <= result <= high
  Whole whole(Whole low, Whole high) {
    const std::uint64_t bits = geometry::random_53_bits(key_, next_++, 0, 11);
    return low + static_cast<Whole>(bits % static_cast<std::uint64_t>(high - low + 1));
  }
  bool one_in(Whole n) { return whole(1, n) == 1; }
  double part() { return static_cast<double>(whole(0, 1'000'000)) * 1e-6; }
  Vec2 point() {
    const double x = part();
    return {x, part()};
  }
  geometry::StreamKey key() const { return key_; }

 private:
  geometry::StreamKey key_;
  std::uint64_t next_ = 0;
};

// Joints in a square of side 1.
struct Ends {
  Vec2 from, to;
};
using Network = std::vector<Ends>;

// Makes most traces longer about their middles, so that they separate cells.
Network prolonged(Draw& draw, Network network) {
  for (Ends& trace : network) {
    const Vec2 d =
        (0.5 * static_cast<double>(draw.whole(0, 4))) * (trace.to - trace.from);
    trace = {trace.from - d, trace.to + d};
  }
  return network;
}

Network random_traces(Draw& draw) {
  Network network;
  for (Whole n = draw.whole(3, 14); n > 0; --n) {
    const Vec2 from = draw.point();
    network.push_back({from, draw.point()});
  }
  return prolonged(draw, std::move(network));
}

Network parallel_traces(Draw& draw) {
  Network network;
  const double tilt = std::pow(10.0, -static_cast<double>(draw.whole(6, 16)));
  for (Whole n = draw.whole(2, 9); n > 0; --n) {
    const double left = 0.5 + tilt * draw.part();
    network.push_back({{-0.1, left}, {1.1, 0.5 + tilt * draw.part()}});
  }
  for (Whole n = draw.whole(1, 3); n > 0; --n) {
    const double x = draw.part();
    network.push_back({{x, -0.1}, {draw.part(), 1.1}});
  }
  return network;
}

// Each trace begins and ends on earlier ones, rounded.
Network traces_on_traces(Draw& draw) {
  Network network = {{{0.0, 0.4}, {1.0, 0.6}}, {{0.5, 0.0}, {0.45, 1.0}}};
  for (Whole n = draw.whole(3, 12); n > 0; --n) {
    const auto on = [&] {
      const auto last = static_cast<Whole>(network.size()) - 1;
      const Ends& trace = network[static_cast<std::size_t>(draw.whole(0, last))];
      return Vec2(trace.from + draw.part() * (trace.to - trace.from));
    };
    const Vec2 from = on();
    network.push_back({from, on()});
  }
  return network;
}

Network lines_through_one_point(Draw& draw) {
  Network network;
  const Vec2 p = draw.point();
  for (Whole n = draw.whole(4, 12); n > 0; --n) {
    const Vec2 d = 3.0 * (draw.point() - Vec2(0.5, 0.5));
    network.push_back({p - d, p + d});
  }
  if (draw.one_in(2))
    for (const Ends& more : random_traces(draw))
      network.push_back(more);
  return network;
}

// Few coordinates, so that joints overlap, follow the outline and end on corners.
Network lattice(Draw& draw) {
  Network network;
  const Whole n = draw.whole(2, 5);
  const auto point = [&] {
    const auto x = static_cast<double>(draw.whole(0, n));
    return Vec2(Vec2(x, static_cast<double>(draw.whole(0, n))) /
                static_cast<double>(n));
  };
  for (Whole k = draw.whole(4, 14); k > 0; --k) {
    const Vec2 from = point();
    network.push_back({from, point()});
  }
  return network;
}

// Joints that repeat others, or a part of them, with ends moved by some ulps.
Network coinciding_traces(Draw& draw) {
  Network network;
  for (Whole n = draw.whole(2, 5); n > 0; --n) {
    const Vec2 from = draw.point();
    network.push_back({from, draw.point()});
  }
  network = prolonged(draw, std::move(network));
  const auto moved = [&](Vec2 p) {
    for (double* x : {&p.x(), &p.y()})
      *x += 0x1p-53 * static_cast<double>(draw.whole(-3, 3));
    return p;
  };
  for (Whole n = draw.whole(2, 8); n > 0; --n) {
    const auto last = static_cast<Whole>(network.size()) - 1;
    const Ends trace = network[static_cast<std::size_t>(draw.whole(0, last))];
    const bool whole = draw.one_in(2);
    const double a = whole ? 0.0 : draw.part(), b = whole ? 1.0 : draw.part();
    const Vec2 d = trace.to - trace.from;
    const Vec2 from = moved(trace.from + a * d);
    network.push_back({from, moved(trace.from + b * d)});
  }
  return network;
}

Network any_traces(Draw& draw) {
  using Make = Network (*)(Draw&);
  constexpr std::array<Make, 6> all = {random_traces,    parallel_traces,
                                       traces_on_traces, lines_through_one_point,
                                       lattice,          coinciding_traces};
  return all[static_cast<std::size_t>(draw.whole(0, 5))](draw);
}

// How a network in the square is placed in space.
struct Frame {
  int exponent = 0;         // the square has the side 10^exponent
  Whole x = 0, y = 0;       // sides of the square between it and the origin
  bool as_doubles = false;  // ends of joints are doubles, not decimals
};

// The number 10^exponent * (value + offset). The value is rounded to 1e-17.
Decimal decimal(double value, Whole offset, int exponent) {
  constexpr Whole units = 100'000'000'000'000'000;
  const boost::multiprecision::cpp_int digits =
      boost::multiprecision::cpp_int(offset) * units +
      std::llround(value * static_cast<double>(units));
  const auto parsed =
      Decimal::parse(digits.str() + "e" + std::to_string(exponent - 17));
  if (!parsed)
    throw std::logic_error("a family left the range of decimals");
  return *parsed;
}

DecimalPoint placed(const Vec2& p, const Frame& frame) {
  return {decimal(p.x(), frame.x, frame.exponent),
          decimal(p.y(), frame.y, frame.exponent)};
}

CutRequest request(const Network& network, const std::vector<Vec2>& outline,
                   const Frame& frame) {
  CutRequest cuts;
  for (const Vec2& corner : outline)
    cuts.outline.push_back(placed(corner, frame));
  int id = 0;
  for (const Ends& joint : network) {
    const DecimalPoint from = placed(joint.from, frame), to = placed(joint.to, frame);
    if (frame.as_doubles)
      cuts.joints.push_back({Vec2(from.x.value(), from.y.value()),
                             Vec2(to.x.value(), to.y.value()), ++id % 4});
    else
      cuts.joints.push_back({from, to, ++id % 4});
  }
  return cuts;
}

const std::vector<Vec2> square = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};

std::vector<Vec2> notched(Draw& draw) {
  switch (draw.whole(0, 3)) {
  case 0:
    return {{0, 0}, {0.25, 1}, {0.5, draw.part() * 0.9}, {1, 1}, {0.9, 0}};
  case 1:  // an L
    return {{0, 0}, {0, 1}, {0.3, 1}, {0.3, 0.3}, {1, 0.3}, {1, 0}};
  case 2:  // a comb with slanted teeth
    return {{0, 0}, {0.1, 1}, {0.2, 0.2}, {0.4, 1}, {0.5, 0.2}, {0.8, 1}, {1, 0}};
  default: {  // a star about the middle
    std::vector<Vec2> star;
    constexpr std::array<std::array<double, 2>, 8> rays = {{{0, 1},
                                                            {0.7, 0.7},
                                                            {1, 0},
                                                            {0.7, -0.7},
                                                            {0, -1},
                                                            {-0.7, -0.7},
                                                            {-1, 0},
                                                            {-0.7, 0.7}}};
    for (const auto& ray : rays)
      star.push_back(Vec2(0.5, 0.5) +
                     (0.05 + 0.45 * draw.part()) * Vec2(ray[0], ray[1]));
    return star;
  }
  }
}

template <Network (*make)(Draw&), std::uint64_t family>
CutRequest in_square(std::uint64_t number) {
  Draw draw(family, number);
  Frame frame;
  frame.as_doubles = draw.one_in(2);
  return request(make(draw), square, frame);
}

CutRequest in_notched_outline(std::uint64_t number) {
  Draw draw(20, number);
  Frame frame;
  frame.as_doubles = draw.one_in(2);
  const auto outline = notched(draw);
  return request(any_traces(draw), outline, frame);
}

CutRequest far_away(std::uint64_t number) {
  Draw draw(21, number);
  Frame frame;
  frame.as_doubles = draw.one_in(2);
  Whole offset = 1;
  for (Whole n = draw.whole(1, 9); n > 0; --n)
    offset *= 10;
  frame.x = draw.one_in(2) ? offset : -draw.whole(0, offset);
  frame.y = draw.one_in(2) ? offset : -draw.whole(0, offset);
  const auto outline = draw.one_in(2) ? square : notched(draw);
  return request(any_traces(draw), outline, frame);
}

CutRequest scaled(std::uint64_t number) {
  Draw draw(22, number);
  Frame frame;
  frame.as_doubles = draw.one_in(2);
  frame.exponent = static_cast<int>(draw.whole(-6, 6));
  if (draw.one_in(3))
    frame.x = draw.whole(-1000, 1000);
  const auto outline = draw.one_in(2) ? square : notched(draw);
  return request(any_traces(draw), outline, frame);
}

// Points that are nearly on circles, so that vertices of the cells nearly coincide.
CutRequest voronoi(std::uint64_t number) {
  Draw draw(23, number);
  const auto outline = draw.one_in(2) ? square : notched(draw);
  CutRequest cuts = request({}, outline, {});
  geometry::VoronoiRequest cells;
  const double error =
      draw.one_in(4) ? 0.0 : std::pow(10.0, -static_cast<double>(draw.whole(3, 16)));
  const auto moved = [&](double x) { return x + error * (draw.part() - 0.5); };
  const auto n = static_cast<int>(draw.whole(2, 4));
  const bool hexagons = draw.one_in(2);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double shift = hexagons && j % 2 == 1 ? 0.5 : 0.0;
      const double x = moved((i + 0.25 + shift) / n);
      cells.points.emplace_back(x, moved((j + 0.5) / n));
    }
  cells.id = 1;
  cells.lloyd = draw.one_in(4) ? 1 : 0;
  cuts.joints = geometry::voronoi_cells(cells, cuts.outline).edges;
  if (draw.one_in(2))
    for (const auto& more : request(any_traces(draw), outline, {}).joints)
      cuts.joints.push_back(more);
  return cuts;
}

// Any network, cleaned with emin and amin up to 0.9 of the domain.
CutRequest cleaned(std::uint64_t number) {
  Draw draw(24, number);
  CutRequest cuts;
  switch (draw.whole(0, 3)) {
  case 0:
    cuts = far_away(draw.whole(0, 1'000'000));
    break;
  case 1:
    cuts = scaled(draw.whole(0, 1'000'000));
    break;
  case 2:
    cuts = voronoi(draw.whole(0, 1'000'000));
    break;
  default:
    cuts = in_notched_outline(draw.whole(0, 1'000'000));
  }
  Vec2 low(HUGE_VAL, HUGE_VAL), high = -low;
  double twice = 0.0;
  const std::size_t n = cuts.outline.size();
  const auto corner = [&](std::size_t i) {
    return Vec2(cuts.outline[i % n].x.value(), cuts.outline[i % n].y.value());
  };
  for (std::size_t i = 0; i < n; ++i) {
    low = low.cwiseMin(corner(i));
    high = high.cwiseMax(corner(i));
    const Vec2 p = corner(i) - corner(0), q = corner(i + 1) - corner(0);
    twice += q.x() * p.y() - p.x() * q.y();
  }
  const auto amount = [&draw] {
    if (draw.one_in(3))
      return 0.9 * draw.part();
    return std::pow(10.0, -static_cast<double>(draw.whole(0, 12))) * draw.part() * 0.9;
  };
  if (!draw.one_in(6))
    cuts.emin = amount() * (high - low).maxCoeff();
  if (!draw.one_in(6))
    cuts.amin = amount() * twice / 2.0;
  return cuts;
}

constexpr std::array<CutFamily, 11> all_families = {{
    {"random", "random traces in a square", 150, in_square<random_traces, 0>},
    {"parallel", "nearly parallel joints, 1e-6 to 1e-16 apart, and 1 to 3 across", 100,
     in_square<parallel_traces, 1>},
    {"on traces", "traces that begin and end on others, rounded", 100,
     in_square<traces_on_traces, 2>},
    {"one point", "4 to 12 lines through one point, rounded", 80,
     in_square<lines_through_one_point, 3>},
    {"lattice", "few coordinates: joints overlap and end on corners", 70,
     in_square<lattice, 4>},
    {"coinciding", "joints repeated with ends moved by up to 3 units", 100,
     in_square<coinciding_traces, 5>},
    {"notched", "any of these in an outline that is not convex", 80,
     in_notched_outline},
    {"offset", "any of these, 10 to 1e9 sides away from the origin", 100, far_away},
    {"scaled", "any of these, 1e-6 to 1e6 in size", 60, scaled},
    {"Voronoi", "cells of nearly cocircular points, half of them with joints", 60,
     voronoi},
    {"cleaned", "the last four with emin and amin up to 0.9 of the domain", 100,
     cleaned},
}};

}  // namespace

std::span<const CutFamily> cut_families() { return all_families; }

}  // namespace blocks::validation
