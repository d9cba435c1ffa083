#include "draw/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace blocks::draw {
namespace {

constexpr Colour hex(unsigned rgb) {
  return {(rgb >> 16) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0};
}

template <std::size_t n>
Colour interpolate(const std::array<Colour, n>& stops, double s) {
  const double at =
      std::clamp(s, 0.0, 1.0) * (n - 1);  // NaN compares false: first stop
  const auto i = at > 0.0 ? std::min(static_cast<std::size_t>(at), n - 2) : 0;
  const double f = at > 0.0 ? at - static_cast<double>(i) : 0.0;
  const Colour &a = stops[i], &b = stops[i + 1];
  return {a.r + f * (b.r - a.r), a.g + f * (b.g - a.g), a.b + f * (b.b - a.b)};
}

/// For magnitudes with an ordinary zero: YlGnBu of ColorBrewer, light yellow to dark
/// blue.
Colour ylgnbu(double s) {
  static constexpr std::array<Colour, 9> stops = {
      hex(0xffffd9), hex(0xedf8b1), hex(0xc7e9b4), hex(0x7fcdbb), hex(0x41b6c4),
      hex(0x1d91c0), hex(0x225ea8), hex(0x253494), hex(0x081d58)};
  return interpolate(stops, s);
}

/// For magnitudes: viridis, dark blue to yellow.
Colour viridis(double s) {
  static constexpr std::array<Colour, 9> stops = {
      hex(0x440154), hex(0x472d7b), hex(0x3b528b), hex(0x2c728e), hex(0x21918c),
      hex(0x28ae80), hex(0x5ec962), hex(0xaddc30), hex(0xfde725)};
  return interpolate(stops, s);
}

/// For magnitudes: cividis, dark blue to yellow, also for colour-blind readers.
Colour cividis(double s) {
  static constexpr std::array<Colour, 10> stops = {
      hex(0x00224e), hex(0x123570), hex(0x3b496c), hex(0x575d6d), hex(0x707173),
      hex(0x8a8678), hex(0xa59c74), hex(0xc3b369), hex(0xe1cc55), hex(0xfee838)};
  return interpolate(stops, s);
}

/// For magnitudes printed without colour: light to dark grey.
Colour grey(double s) {
  static constexpr std::array<Colour, 2> stops = {hex(0xf2f2f2), hex(0x1c1c1c)};
  return interpolate(stops, s);
}

struct NamedMap {
  std::string name;
  ColourMap map;
};

/// All maps, the most used first.
const std::vector<NamedMap>& named_maps() {
  static const std::vector<NamedMap> maps = {{"ylgnbu", {ylgnbu}},
                                             {"viridis", {viridis}},
                                             {"cividis", {cividis}},
                                             {"grey", {grey}},
                                             {"bluered", {diverging, true}}};
  return maps;
}

}  // namespace

Colour material_colour(int material) {
  static constexpr std::array<Colour, 8> palette = {
      hex(0xc9b79c), hex(0x6b7f8f), hex(0xb5886b), hex(0x8fa88b),
      hex(0xd8c27a), hex(0x8a7a99), hex(0xa9c1cf), hex(0x7d6b5d)};
  struct Shade {
    Colour with;
    double share;
  };
  static constexpr std::array<Shade, 5> rounds = {Shade{hex(0xffffff), 0.0},
                                                  {hex(0xffffff), 0.5},
                                                  {hex(0x000000), 0.35},
                                                  {hex(0xffffff), 0.75},
                                                  {hex(0x000000), 0.6}};
  const int all = static_cast<int>(palette.size() * rounds.size());
  const auto index = static_cast<std::size_t>(((material - 1) % all + all) % all);
  const Shade& shade = rounds[index / palette.size()];
  return mix(shade.with, palette[index % palette.size()], shade.share);
}

Colour diverging(double s) {
  static constexpr std::array<Colour, 9> stops = {
      hex(0x2166ac), hex(0x4393c3), hex(0x92c5de), hex(0xd1e5f0), hex(0xf7f7f7),
      hex(0xfddbc7), hex(0xf4a582), hex(0xd6604d), hex(0xb2182b)};
  return interpolate(stops, s);
}

Colour intensity(double s) {
  static constexpr std::array<Colour, 7> stops = {
      hex(0xfec488), hex(0xfc8961), hex(0xe75263), hex(0xb73779),
      hex(0x832681), hex(0x51127c), hex(0x1d1147)};
  return interpolate(stops, s);
}

Colour ColourMap::at(double s) const {
  const double at = first + (last - first) * std::clamp(s, 0.0, 1.0);
  return stops(reversed ? 1.0 - at : at);
}

ColourMap ColourMap::for_range(double low, double high) const {
  ColourMap part = *this;
  if (diverging && low < high) {
    const double largest = std::max(-low, high);
    part.first = low >= 0.0 ? 0.5 : 0.5 * (1.0 + low / largest);
    part.last = high <= 0.0 ? 0.5 : 0.5 * (1.0 + high / largest);
  }
  return part;
}

ColourMap colour_map(const std::string& name) {
  const bool reversed = name.ends_with("_r");
  const std::string plain = reversed ? name.substr(0, name.size() - 2) : name;
  for (const NamedMap& known : named_maps())
    if (known.name == plain) {
      ColourMap map = known.map;
      map.reversed = reversed;
      return map;
    }
  throw std::runtime_error("there is no colour map '" + name + "': choose " +
                           colour_map_names());
}

std::vector<std::string> all_colour_maps() {
  std::vector<std::string> names;
  for (const NamedMap& known : named_maps())
    names.push_back(known.name);
  return names;
}

std::string usual_colour_map(Zero zero) {
  return zero == Zero::middle ? "bluered" : zero == Zero::lowest ? "ylgnbu" : "viridis";
}

std::string colour_map_names() {
  return "ylgnbu (light to dark), viridis, cividis, grey (light to dark), bluered "
         "(centred on 0), or one of them in reverse, such as viridis_r";
}

double luminance(const Colour& c) {
  const auto linear = [](double s) {  // sRGB
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

bool is_dark(const Colour& c) {
  constexpr double equal_contrast = 0.179;  // of black and white: (1 + f) f = (L + f)^2
  return luminance(c) < equal_contrast;
}

Colour outline_on(const Colour& ground, bool faint) {
  constexpr Colour black{0, 0, 0}, light{1, 1, 1};
  return is_dark(ground) ? mix(ground, light, faint ? 0.7 : 0.4)
                         : mix(ground, black, faint ? 0.65 : 0.3);
}

Colour rim_of_line(const Colour& line) {
  constexpr Colour dark{0.16, 0.16, 0.18}, light{1, 1, 1};
  constexpr double pale = 0.2;
  return luminance(line) > pale ? dark : light;
}

std::string css(const Colour& colour) {
  const auto byte = [](double part) {
    return std::lround(255.0 * std::clamp(part, 0.0, 1.0));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.r), byte(colour.g),
                     byte(colour.b));
}

Colour mix(const Colour& a, const Colour& b, double share) {
  return {b.r + share * (a.r - b.r), b.g + share * (a.g - b.g),
          b.b + share * (a.b - b.b)};
}

}  // namespace blocks::draw
