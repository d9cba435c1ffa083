#include "exchange/geographic_crs.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace blocks::exchange {

bool is_geographic(long epsg) {
  // WGS 84 (also with heights), ETRS89, NAD83, NAD27, GDA94, GDA2020, NZGD2000,
  // CGCS2000, JGD2011, SIRGAS 2000, Hartebeesthoek94
  constexpr std::array codes{4326L, 4979L, 4258L, 4269L, 4267L, 4283L,
                             7844L, 4167L, 4490L, 6668L, 4674L, 4148L};
  return std::find(codes.begin(), codes.end(), epsg) != codes.end();
}

std::optional<std::string> geographic_crs(const Json& root) {
  // {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::4326"}}
  const auto member = [](const Json* object, const char* key) {
    return object && object->kind == Json::Kind::object ? object->find(key) : nullptr;
  };
  const Json* name = member(member(member(&root, "crs"), "properties"), "name");
  if (!name || name->kind != Json::Kind::string)
    return std::nullopt;
  const std::string& text = name->text;
  const std::size_t colon = text.rfind(':');
  const std::string last = colon == text.npos ? text : text.substr(colon + 1);
  if (last == "CRS84")
    return last;
  long code = 0;
  const auto end = std::from_chars(last.data(), last.data() + last.size(), code).ptr;
  if (end == last.data() + last.size() && text.find("EPSG") != text.npos &&
      is_geographic(code))
    return "EPSG:" + last;
  return std::nullopt;
}

std::string degrees_as_lengths(const std::string& system) {
  return "the coordinates are degrees (crs " + system + "), and are taken as lengths";
}

}  // namespace blocks::exchange
