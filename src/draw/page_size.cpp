#include "draw/page_size.hpp"

#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace blocks::draw {
namespace {

constexpr double point = 1.0, inch = 72.0 * point, mm = inch / 25.4;
constexpr double usual_text = 14.0;                      ///< [units]
constexpr double print_unit = 8.0 * point / usual_text;  ///< usual text has 8 points
constexpr double shortest = 30.0 * mm, longest = 2000 * mm;  ///< sides of a figure

[[noreturn]] void refuse(const std::string& text) {
  throw std::runtime_error(
      "--size needs a width such as 85mm, 8.5cm, 3.5in, single (85mm) or double "
      "(175mm), "
      "or a width and a height such as 85mmx60mm, each from 30mm to 2000mm, found '" +
      text + "'");
}

/// Returns a length such as "85mm" [points]; NaN if it cannot be read.
double length_of(const std::string& text) {
  static const std::map<std::string, double> units = {
      {"mm", mm}, {"cm", 10.0 * mm}, {"in", inch}};
  if (text == "single")
    return 85.0 * mm;
  if (text == "double")
    return 175.0 * mm;
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const auto unit = units.find(end);
  return end == text.c_str() || unit == units.end() ? std::nan("")
                                                    : number * unit->second;
}

}  // namespace

const char* PageSize::help() {
  return "size of a figure in print, with text of 7 to 9 pt: 85mm, 3.5in, single "
         "(85mm), double (175mm), or with the height, 85mmx60mm; a PNG has 300 dpi";
}

PageSize PageSize::on_screen(double width) {
  PageSize page;
  page.unit = width / page.width;
  return page;
}

PageSize PageSize::in_print(const std::string& text) {
  const auto cross = text.find('x');
  const double width = length_of(text.substr(0, cross));
  const double height =
      cross == std::string::npos ? 0.0 : length_of(text.substr(cross + 1));
  const auto usable = [](double side) { return side >= shortest && side <= longest; };
  if (!usable(width) || (cross != std::string::npos && !usable(height)))
    refuse(text);
  PageSize page;
  page.unit = print_unit;
  page.width = width / page.unit;
  page.height = height / page.unit;
  page.printed = true;
  page.min_text = 7.0 * point / page.unit;
  page.max_text = 9.0 * point / page.unit;
  return page;
}

}  // namespace blocks::draw
