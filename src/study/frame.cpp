#include "study/frame.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "study/draws.hpp"

namespace blocks::study {
namespace {

/// The convergents of tan 10 degrees, as numerator and denominator.
std::vector<std::pair<double, double>> convergents() {
  std::vector<std::pair<double, double>> found;
  double x = std::tan(std::numbers::pi / 18.0);
  double h0 = 1, h1 = 0, k0 = 0, k1 = 1;  // previous and present convergent, at term 0
  for (int term = 0; term < 9; ++term) {
    x = 1.0 / x;
    const double a = std::floor(x);
    x -= a;
    h0 = std::exchange(h1, a * h1 + h0), k0 = std::exchange(k1, a * k1 + k0);
    found.emplace_back(h1, k1);
  }
  return found;
}

std::pair<double, double> direction(Draws& draw) {
  constexpr std::array<std::array<double, 3>, 5> triples{
      {{4, 3, 5}, {12, 5, 13}, {15, 8, 17}, {24, 7, 25}, {21, 20, 29}}};
  static const auto tangents = convergents();
  double x = 1.0, y = 0.0, length = 1.0;
  const int kind = draw.below(10), which = draw.below(1000);
  const double angle = 2.0 * std::numbers::pi * draw();
  if (kind == 1) {
    std::tie(y, x) = tangents[which % tangents.size()];
    length = std::hypot(x, y);
  } else if (kind == 2 || kind == 3) {
    const auto& triple = triples[which % triples.size()];
    x = triple[0], y = triple[1], length = triple[2];
  } else if (kind > 3) {
    x = std::cos(angle), y = std::sin(angle);
  }
  for (int quarter = draw.below(4); quarter > 0; --quarter)
    x = std::exchange(y, x) * -1.0;
  return {x / length, y / length};
}

}  // namespace

Frame random_frame(const FrameChoice& choice, int number, double length) {
  Draws draw(choice.seed, number);
  Frame frame;
  std::tie(frame.cosine, frame.sine) = direction(draw);
  const double exponent = -3.0 + 9.0 * draw();
  const bool binary = draw.below(4) == 0;
  frame.scale = binary ? std::exp2(std::round(exponent / std::log10(2.0)))
                       : std::pow(10.0, exponent);
  frame.scale = choice.scale.value_or(frame.scale);
  constexpr std::array offsets = {0.0, 1.0, 1e3, 1e6, 1e9};
  const double drawn = offsets[static_cast<std::size_t>(draw.below(5))];
  const double distance = choice.offset.value_or(drawn) * length * frame.scale;
  const double way = 2.0 * std::numbers::pi * draw();
  frame.offset = distance * Vec2(std::cos(way), std::sin(way));
  return frame;
}

}  // namespace blocks::study
