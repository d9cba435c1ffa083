// Small DXF drawings for tests.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace blocks::testing {

/// Groups of codes and values, as in {{0, "LINE"}, {8, "joints"}, {10, "0"}}.
using DxfGroups = std::vector<std::pair<int, std::string>>;

inline std::string dxf_groups(const DxfGroups& groups) {
  std::string text;
  for (const auto& [code, value] : groups)
    text += fmt::format("{:>3}\n{}\n", code, value);
  return text;
}

inline std::string dxf_number(double value) { return fmt::format("{}", value); }

inline std::string dxf_line(const std::string& layer, double x1, double y1, double x2,
                            double y2) {
  return dxf_groups({{0, "LINE"},
                     {8, layer},
                     {10, dxf_number(x1)},
                     {20, dxf_number(y1)},
                     {11, dxf_number(x2)},
                     {21, dxf_number(y2)}});
}

/// A closed LWPOLYLINE.
inline std::string dxf_ring(const std::string& layer,
                            const std::vector<std::pair<double, double>>& points) {
  DxfGroups groups = {
      {0, "LWPOLYLINE"}, {8, layer}, {90, std::to_string(points.size())}, {70, "1"}};
  for (const auto& [x, y] : points) {
    groups.emplace_back(10, dxf_number(x));
    groups.emplace_back(20, dxf_number(y));
  }
  return dxf_groups(groups);
}

/// unit: $INSUNITS; 0: none.
inline std::string dxf_drawing(const std::string& entities, int unit = 0) {
  std::string text;
  if (unit > 0)
    text = dxf_groups({{0, "SECTION"},
                       {2, "HEADER"},
                       {9, "$INSUNITS"},
                       {70, std::to_string(unit)},
                       {0, "ENDSEC"}});
  return text + dxf_groups({{0, "SECTION"}, {2, "ENTITIES"}}) + entities +
         dxf_groups({{0, "ENDSEC"}, {0, "EOF"}});
}

}  // namespace blocks::testing
