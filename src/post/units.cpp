#include "post/units.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <span>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace blocks::post {
namespace {

/// Returns a unit with its power: "m", "m²", "s⁻¹"; empty for the power zero.
std::string factor(const std::string& unit, int power) {
  if (power == 0)
    return "";
  return power == 1 ? unit : unit + superscript(power);
}

/// A unit and its size in m, kg or s.
struct KnownUnit {
  const char* name;
  double size;
};
constexpr KnownUnit lengths[] = {{"m", 1.0},     {"mm", 1e-3},   {"cm", 1e-2},
                                 {"dm", 1e-1},   {"km", 1e3},    {"um", 1e-6},
                                 {"in", 0.0254}, {"ft", 0.3048}, {"yd", 0.9144}};
constexpr KnownUnit masses[] = {
    {"kg", 1.0}, {"g", 1e-3}, {"mg", 1e-6},       {"t", 1e3},
    {"Mg", 1e3}, {"kt", 1e6}, {"lb", 0.45359237}, {"slug", 14.593902937206364}};
constexpr KnownUnit times[] = {{"s", 1.0},        {"ms", 1e-3},  {"us", 1e-6},
                               {"min", 60.0},     {"h", 3600.0}, {"d", 86400.0},
                               {"yr", 31557600.0}};

double size_of(std::span<const KnownUnit> units, const std::string& name) {
  std::string list;
  for (const KnownUnit& unit : units) {
    if (name == unit.name)
      return unit.size;
    list += (list.empty() ? "" : ", ") + std::string(unit.name);
  }
  throw std::runtime_error("'" + name + "' cannot be converted; known are " + list);
}

double ratio(std::span<const KnownUnit> units, const std::string& from,
             const std::string& to) {
  return from == to ? 1.0 : size_of(units, from) / size_of(units, to);
}

}  // namespace

std::string superscript(int number) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴",
                                                         "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(number)))
    text += digits.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

Units Units::parse(const std::string& text) {
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
  return {ratio(lengths, from.length, to.length), ratio(masses, from.mass, to.mass),
          ratio(times, from.time, to.time)};
}

std::string time_text(double time, std::optional<double> asked,
                      const std::optional<Units>& units) {
  const std::string unit = units ? " " + unit_text({0, 0, 1, "s", ""}, units) : "";
  const std::string shown = fmt::format("{:.4g}{}", time, unit);
  const std::string wanted = fmt::format("{:.4g}{}", asked.value_or(time), unit);
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
