#include "draw/chart/directions.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace blocks::draw {
namespace {

constexpr double half_turn = 180.0;
constexpr double degree = std::numbers::pi / half_turn;
/// With this many pieces, sectors of 5 degrees have enough pieces each.
constexpr std::size_t many_pieces = 400;
constexpr double wide_sector = 10.0, fine_sector = 5.0;
/// Below this resultant of unit vectors (0: all directions alike, 1: all the same) a
/// mean direction says nothing.
constexpr double min_resultant = 0.4;

}  // namespace

Directions direction_statistics(const std::vector<DirectedLength>& lengths) {
  double total = 0.0;
  for (const DirectedLength& one : lengths)
    total += one.length;
  Directions result;
  result.sector = lengths.size() < many_pieces ? wide_sector : fine_sector;
  const auto sectors = static_cast<std::size_t>(std::lround(half_turn / result.sector));
  std::map<int, std::complex<double>> sums;  // of doubled angles, because they are axes
  for (const DirectedLength& piece : lengths) {
    GroupDirections& one = result.groups[piece.group];
    one.sectors.resize(sectors);
    const long nearest = std::lround(piece.direction / result.sector);
    one.sectors[static_cast<std::size_t>(nearest) % sectors] += piece.length / total;
    one.share += piece.length / total;
    sums[piece.group] +=
        piece.length / total * std::polar(1.0, 2.0 * piece.direction * degree);
  }
  for (auto& [id, one] : result.groups) {
    const double angle = 0.5 * std::arg(sums[id]) / degree;
    one.mean = angle < 0.0 ? angle + half_turn : angle;
    const double resultant = std::min(std::abs(sums[id]) / one.share, 1.0);
    if (resultant >= min_resultant)
      one.deviation = 0.5 * std::sqrt(2.0 * std::abs(std::log(resultant))) / degree;
  }
  return result;
}

double median_of(std::vector<double> values) {
  if (values.empty())
    return 0.0;
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1)
    return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace blocks::draw
