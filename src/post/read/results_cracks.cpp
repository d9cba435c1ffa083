#include "post/read/results_cracks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "post/read/results_file.hpp"

namespace blocks::post {

double Crack::angle() const {
  const Eigen::Vector2d along = to - from;
  const double degrees = std::atan2(along.y(), along.x()) * (180.0 / std::numbers::pi);
  constexpr double rounding = 1e-9;  // a horizontal chord has the angle 0
  if (std::abs(degrees) < rounding || std::abs(degrees) > 180.0 - rounding)
    return 0.0;
  return degrees < 0.0 ? degrees + 180.0 : degrees;
}

hsize_t ResultsReader::File::count_cracks(hsize_t i) const {
  // A run that was interrupted while it added the group left it without a count.
  if (!hdf5::exists(own.get(), "cracks") || !hdf5::exists(own.get(), crack_counts))
    return 0;
  Column counts = Column::open(own.get(), crack_counts);
  if (counts.rows() <= i)
    return 0;
  const auto count = counts.at<std::int64_t>(i);
  if (count < 0)
    throw Failure(std::string(crack_counts) + " is negative");
  return static_cast<hsize_t>(count);
}

std::vector<Crack> ResultsReader::File::read_cracks() const {
  const hsize_t n = times.empty() ? 0 : count_cracks(times.size() - 1);
  if (n == 0)
    return {};
  const auto open = [&](const char* name, hsize_t width) {
    const std::string dataset = std::string("cracks/") + name;
    Column column = Column::open(own.get(), dataset);
    if (column.width() != width)
      throw Failure(dataset + " has the wrong shape");
    return column;
  };
  const auto steps_of = open("step", 1).read<std::int64_t>(0, n);
  std::vector<Crack> cracks(n);
  for (std::size_t i = 0; i < n; ++i)
    cracks[i].step = static_cast<long>(steps_of[i]);
  const auto whole = [&](const char* name, auto&& set) {
    const std::vector<int> values = open(name, 1).read<int>(0, n);
    for (std::size_t i = 0; i < n; ++i)
      set(cracks[i], values[i]);
  };
  const auto real = [&](const char* name, double Crack::*value) {
    const auto values = open(name, 1).read<double>(0, n);
    for (std::size_t i = 0; i < n; ++i)
      cracks[i].*value = values[i];
  };
  const auto place = [&](const char* name, Eigen::Vector2d Crack::*value) {
    const auto values = open(name, 3).read<double>(0, n);
    for (std::size_t i = 0; i < n; ++i)
      cracks[i].*value = {values[3 * i], values[3 * i + 1]};
  };
  whole("parent", [](Crack& crack, int value) { crack.parent = value; });
  whole("child", [](Crack& crack, int value) { crack.child = value; });
  whole("cause", [](Crack& crack, int value) { crack.by_points = value != 0; });
  real("time", &Crack::time);
  real("stress", &Crack::stress);
  place("from", &Crack::from);
  place("to", &Crack::to);
  real("moved", &Crack::moved);
  real("parent_area", &Crack::parent_area);
  real("child_area", &Crack::child_area);
  real("kinetic_before", &Crack::kinetic_before);
  real("kinetic_after", &Crack::kinetic_after);
  real("strain_before", &Crack::strain_before);
  real("strain_after", &Crack::strain_after);
  const auto blocks = static_cast<std::int64_t>(
      count("NumberOfCells", step_value("PartOffsets", times.size() - 1)));
  for (const Crack& crack : cracks)
    for (const int block : {crack.parent, crack.child})
      if (block < 1 || block > blocks)
        throw Failure(fmt::format("cracks is out of range: block {} is not in 1 to {}",
                                  block, blocks));
  return cracks;
}

std::vector<int> ResultsReader::File::parents(hsize_t i, hsize_t n) const {
  // A run that was interrupted while it added the column left frames without an offset.
  if (!hdf5::exists(vtk.get(), "CellData/Parent") ||
      !hdf5::exists(steps.get(), "CellDataOffsets/Parent") ||
      Column::open(steps.get(), "CellDataOffsets/Parent").rows() <= i)
    return {};
  return cells<int>("Parent", i, n, 1);
}

}  // namespace blocks::post
