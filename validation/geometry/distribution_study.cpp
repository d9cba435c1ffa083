// Measures the widths and angles that random spacing and ORIENT give: the tables of
// docs/distributions.md.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/layer.hpp"

namespace {

using namespace blocks::geometry;

std::string fixed(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// Requests a layer of height 1 with a mean block width of hundredths/100.
LayerRequest layer_of(int blocks, int hundredths, const std::string& angle,
                      int number) {
  const Decimal length =
      Decimal::parse(std::to_string(static_cast<long>(blocks) * hundredths) + "e-2")
          .value();
  LayerRequest request;
  request.corners = {{{0, 0}, {0, 1}, {length, 1}, {length, 0}}};
  request.spacing = Spacing::random;
  request.count = blocks;
  request.angle_min = Decimal::parse("-" + angle).value();
  request.angle_max = Decimal::parse(angle).value();
  request.stream = {71, static_cast<std::uint64_t>(number)};
  return request;
}

std::string widths_row(int blocks, int hundredths) {
  const int layers = 200000 / blocks;
  const double mean = hundredths / 100.0;
  const auto n = static_cast<std::size_t>(blocks);
  std::vector<double> place(n, 0.0);
  double square = 0.0;
  double product = 0.0;
  double min = 3.0;
  double max = 0.0;
  for (int k = 0; k < layers; ++k) {
    const Layer layer = cut_layer(layer_of(blocks, hundredths, "0", k));
    const auto width = [&](std::size_t i) {
      return layer.mesh.vertices[i + 1].x() - layer.mesh.vertices[i].x();
    };
    for (std::size_t i = 0; i < n; ++i) {
      const double d = width(i) - mean;
      place[i] += d;
      square += d * d;
      product += i > 0 ? d * (width(i - 1) - mean) : 0.0;
      min = std::min(min, width(i));
      max = std::max(max, width(i));
    }
  }
  const double count = static_cast<double>(layers) * blocks;
  const double deviation = std::sqrt(square / count);
  double worst = 0.0;
  for (const double sum : place)
    worst = std::max(worst, std::abs(sum) / layers);
  const double error =
      deviation * std::sqrt(blocks / (blocks - 1.0) /
                            layers);  // standard error of the mean at one place
  std::ostringstream row;
  row << "| " << blocks << " | " << fixed(mean, 2) << " | " << layers << " | "
      << fixed(deviation, 4) << " | "
      << fixed(std::min(mean - 0.2, 3.0 - mean) / std::sqrt(3.0), 4) << " | "
      << fixed(min, 4) << " | " << fixed(max, 4) << " | "
      << fixed(product / (count - layers) / (square / count), 4) << " | "
      << fixed(-1.0 / (blocks - 1), 4) << " | " << fixed(worst / error, 2) << " |\n";
  return row.str();
}

std::string angles_row(const std::string& angle, int hundredths) {
  constexpr int blocks = 400;
  constexpr int layers = 50;
  long redrawn = 0;
  long ruled = 0;
  long sides = 0;
  double sum = 0.0;
  double square = 0.0;
  for (int k = 0; k < layers; ++k) {
    const Layer layer = cut_layer(layer_of(blocks, hundredths, angle, k));
    redrawn += layer.redrawn;
    ruled += layer.ruled;
    const auto& v = layer.mesh.vertices;
    const std::size_t n = layer.mesh.cells.size();
    for (std::size_t i = 1; i < n; ++i) {
      const Vec2 side = v[n + 1 + i] - v[i];
      const double a = std::atan2(-side.x(), side.y()) * 180.0 / std::numbers::pi;
      sum += a;
      square += a * a;
      ++sides;
    }
  }
  const double count = static_cast<double>(sides);
  const double uniform = std::stod(angle) / std::sqrt(3.0);
  std::ostringstream row;
  row << "| +-" << angle << " | " << fixed(hundredths / 100.0, 2) << " | "
      << fixed(static_cast<double>(redrawn) / count, 3) << " | "
      << fixed(100.0 * static_cast<double>(ruled) / count, 2) << " % | "
      << fixed(sum / count, 2) << " | " << fixed(std::sqrt(square / count), 2) << " | "
      << fixed(uniform, 2) << " |\n";
  return row.str();
}

std::string tables() {
  std::string text =
      R"(# Random widths and angles as they come

Written by `./go validate layers`; do not edit. The law: docs/distributions.md.

Widths over height. Uniform: standard deviation of the uniform law about the mean that
fits between 0.2 and 3, the limit for many blocks. Correlation is that of neighbours;
-1/(n-1) is that of any two widths with a fixed sum. Worst place: the largest deviation
of the mean width at one place of the layer, in its standard errors.

| blocks n | mean | layers | deviation | uniform | least | greatest | correlation | -1/(n-1) | worst place |
|---|---|---|---|---|---|---|---|---|---|
)";
  for (const int blocks : {2, 5, 20, 1000})
    for (const int hundredths : {30, 60, 160, 250})
      text += widths_row(blocks, hundredths);
  text +=
      R"(
Angles of the sides in degrees, 50 layers of 400 blocks. Redrawn: number of angles drawn
again, per side. Ruled: share of sides that took the ruling. Uniform: the deviation if no
side were drawn again.

| ORIENT | mean width/height | redrawn | ruled | mean | deviation | uniform |
|---|---|---|---|---|---|---|
)";
  for (const char* angle : {"5", "15", "30", "45", "60", "79.999"})
    for (const int hundredths : {50, 100, 200})
      text += angles_row(angle, hundredths);
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"random widths and angles as they come"};
  std::string report;
  app.add_option("--report", report, "write NAME.md");
  CLI11_PARSE(app, argc, argv);
  const std::string text = tables();
  std::cout << text;
  if (report.empty())
    return 0;
  std::ofstream out(report + ".md");
  out << text;
  out.flush();
  if (!out) {
    std::cerr << "blocks: error: cannot write " << report << ".md\n";
    return 5;
  }
  return 0;
}
