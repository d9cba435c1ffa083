#include "output/results_names.hpp"

#include <charconv>
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
  return names;
}

}  // namespace blocks::output
