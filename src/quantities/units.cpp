#include "quantities/units.hpp"

namespace blocks::quantities {

std::optional<double> KnownUnits::size_of(const std::string& name) const {
  for (const Unit& unit : units)
    if (name == unit.name)
      return unit.size;
  return std::nullopt;
}

std::string KnownUnits::names() const {
  std::string list;
  for (const Unit& unit : units)
    list += (list.empty() ? "" : ", ") + std::string(unit.name);
  return list;
}

const KnownUnits& known_lengths() {
  static const KnownUnits lengths{"length",
                                  {{"m", 1.0},
                                   {"mm", 1e-3},
                                   {"cm", 1e-2},
                                   {"dm", 1e-1},
                                   {"km", 1e3},
                                   {"um", 1e-6},
                                   {"in", 0.0254},
                                   {"ft", 0.3048},
                                   {"yd", 0.9144}}};
  return lengths;
}

const KnownUnits& known_masses() {
  static const KnownUnits masses{"mass",
                                 {{"kg", 1.0},
                                  {"g", 1e-3},
                                  {"mg", 1e-6},
                                  {"t", 1e3},
                                  {"Mg", 1e3},
                                  {"kt", 1e6},
                                  {"lb", 0.45359237},
                                  {"slug", 14.593902937206364}}};
  return masses;
}

const KnownUnits& known_times() {
  static const KnownUnits times{"time",
                                {{"s", 1.0},
                                 {"ms", 1e-3},
                                 {"us", 1e-6},
                                 {"min", 60.0},
                                 {"h", 3600.0},
                                 {"d", 86400.0},
                                 {"yr", 31557600.0}}};
  return times;
}

}  // namespace blocks::quantities
