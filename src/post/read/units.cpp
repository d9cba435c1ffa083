#include "post/read/units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "draw/number_text.hpp"
#include "quantities/units.hpp"

namespace blocks::post {

using namespace draw;

namespace {

/// Returns a unit with its power: "m", "m²", "s⁻¹"; empty for the power zero.
std::string factor(const std::string& unit, int power) {
  if (power == 0)
    return "";
  return power == 1 ? unit : unit + superscript(power);
}

double size_of(const quantities::KnownUnits& known, const std::string& name) {
  if (const auto size = known.size_of(name))
    return *size;
  throw std::runtime_error("'" + name + "' cannot be converted; known are " +
                           known.names());
}

double ratio(const quantities::KnownUnits& known, const std::string& from,
             const std::string& to) {
  return from == to ? 1.0 : size_of(known, from) / size_of(known, to);
}

}  // namespace

std::string names_of(const Units& units) {
  return units.length + ',' + units.mass + ',' + units.time;
}

Units parse_units(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');)
    names.push_back(name);
  if (names.size() != 3 || names[0].empty() || names[1].empty() || names[2].empty())
    throw std::runtime_error(
        "expected units of length, mass and time, such as m,kg,s, found '" + text +
        "'");
  return {names[0], names[1], names[2]};
}

double UnitScale::of(const Dimension& d) const {
  return std::pow(length, d.length) * std::pow(mass, d.mass) * std::pow(time, d.time);
}

UnitScale UnitScale::between(const Units& from, const Units& to) {
  return {ratio(quantities::known_lengths(), from.length, to.length),
          ratio(quantities::known_masses(), from.mass, to.mass),
          ratio(quantities::known_times(), from.time, to.time)};
}

std::string time_text(double time, std::optional<double> requested,
                      const std::optional<Units>& units) {
  const std::string unit = units ? " " + unit_text({0, 0, 1, "s", ""}, units) : "";
  const std::string shown = fmt::format("{:.4g}{}", time, unit);
  const std::string wanted = fmt::format("{:.4g}{}", requested.value_or(time), unit);
  return "t = " + shown + (shown == wanted ? "" : ", nearest to " + wanted);
}

std::string unit_text(const Dimension& d, const std::optional<Units>& units) {
  if (units && units->length == "m" && units->mass == "kg" && units->time == "s" &&
      *d.si != '\0')
    return d.si;
  const Units u = units.value_or(Units{"L", "M", "T"});
  std::string text = d.angle;
  for (const std::string& part :
       {factor(u.mass, d.mass), factor(u.length, d.length), factor(u.time, d.time)})
    if (!part.empty())
      text += (text.empty() ? "" : " ") + part;
  return text;
}

}  // namespace blocks::post
