#include "output/results/results_names.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

namespace blocks::output {

void write_names(hid_t own, const Settings& settings) {
  if (const Units& units = settings.units; units.known())
    hdf5::write_text(own, "units",
                     units.length + '\n' + units.mass + '\n' + units.time + '\n');
  std::string lines;
  for (const auto& [number, material] : settings.materials)
    if (!material.name.empty())
      lines += std::to_string(number) + ' ' + material.name + '\n';
  if (!lines.empty())
    hdf5::write_text(own, "materials", lines);
}

void write_planes(hid_t own, const std::vector<Plane>& planes) {
  if (planes.empty())
    return;
  constexpr hsize_t planes_per_chunk = 16;
  hdf5::Column column =
      hdf5::exists(own, "planes")
          ? hdf5::Column::open(own, "planes")
          : hdf5::Column(own, "planes", H5T_NATIVE_DOUBLE, 4, planes_per_chunk);
  for (hsize_t k = column.rows(); k < planes.size(); ++k) {
    const auto& [a, b] = planes[k];
    const double row[4] = {a.x(), a.y(), b.x(), b.y()};
    column.put(k, row, 1);
  }
}

ResultsNames read_names(hid_t own) {
  ResultsNames names;
  if (hdf5::exists(own, "units")) {
    std::istringstream lines(hdf5::read_text(own, "units"));
    Units& units = names.units;
    for (std::string* name : {&units.length, &units.mass, &units.time})
      if (!std::getline(lines, *name) || name->empty())
        throw hdf5::Failure("units does not name length, mass and time");
  }
  if (hdf5::exists(own, "materials")) {
    std::istringstream lines(hdf5::read_text(own, "materials"));
    for (std::string line; std::getline(lines, line);) {
      int number = 0;
      const char* const end = line.data() + line.size();
      const auto [rest, fault] = std::from_chars(line.data(), end, number);
      if (fault != std::errc() || rest == end || *rest != ' ')
        throw hdf5::Failure("materials has a line without a number and a name");
      names.materials[number] = std::string(rest + 1, end);
    }
  }
  if (hdf5::exists(own, "planes")) {
    hdf5::Column column = hdf5::Column::open(own, "planes");
    if (column.width() != 4)
      throw hdf5::Failure("planes has the wrong shape");
    const auto rows = column.read<double>(0, column.rows());
    for (std::size_t k = 0; k < rows.size(); k += 4) {
      names.planes.push_back({{rows[k], rows[k + 1]}, {rows[k + 2], rows[k + 3]}});
      const double length = (names.planes.back().b - names.planes.back().a).norm();
      if (!std::isfinite(length) || !(length > 0.0))
        throw hdf5::Failure("planes has values that are not finite, or equal points");
    }
  }
  return names;
}

}  // namespace blocks::output
