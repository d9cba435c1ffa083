#include "post/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

#include "post/model_quantity.hpp"
#include "post/quantity.hpp"

namespace blocks::post {
namespace {

using Of = Curve::Of;

/// The quantities of a corner: position, displacement and velocity.
const std::vector<std::string> corner_names = {
    "x", "y", "dx", "dy", "speed", "displacement", "vx", "vy"};

int whole_number(const std::string& digits) {
  const bool fine = !digits.empty() && digits.size() < 10 &&
                    digits.find_first_not_of("0123456789") == std::string::npos;
  return fine ? std::stoi(digits) : 0;
}

}  // namespace

std::string Curve::name() const {
  switch (of) {
  case Of::block:
    return fmt::format("{}:{}", quantity, block);
  case Of::corner:
    return fmt::format("{}:{}.{}", quantity, block, corner);
  case Of::largest:
    return quantity + ":max";
  case Of::smallest:
    return quantity + ":min";
  case Of::mean:
    return quantity + ":mean";
  case Of::sum:
    return quantity + ":sum";
  case Of::model:
    break;
  }
  return quantity;
}

std::string history_help() {
  std::string whole, corner;
  for (const auto& [name, kind] : other_kinds())
    whole += (whole.empty() ? "" : ", ") + name;
  for (const QuantityKind& kind : quantity_kinds())
    if (kind.additive)
      whole += ", " + kind.name;
  for (const std::string& name : corner_names)
    corner += (corner.empty() ? "" : ", ") + name;
  return "of blocks (:9, :max, :min, :mean, :sum): " + quantity_names() +
         "\nof corners (:9.2): " + corner + "\nof the model: " + whole;
}

Curve parse_curve(const std::string& text) {
  const auto colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const QuantityKind* kind = find_quantity(name);
  const OtherKind* other = find_other(name);
  if (!kind && !other)
    throw std::runtime_error("there is no quantity '" + name + "'\n" + history_help());
  Curve curve;
  curve.quantity = kind ? kind->name : name;
  const bool model_alone = other && other->whole;
  if (colon == std::string::npos) {
    if (kind && !kind->additive)
      throw std::runtime_error(
          fmt::format("{0} needs a block or a statistic: {0}:9 is that of block 9, "
                      "{0}:max the largest; also {0}:min, {0}:mean, {0}:sum",
                      name));
    return curve;
  }
  const std::string where = text.substr(colon + 1);
  static const std::map<std::string, Of> over_all = {{"max", Of::largest},
                                                     {"min", Of::smallest},
                                                     {"mean", Of::mean},
                                                     {"sum", Of::sum}};
  if (const auto found = over_all.find(where); found != over_all.end()) {
    curve.of = found->second;
  } else {
    const auto dot = where.find('.');
    curve.of = dot == std::string::npos ? Of::block : Of::corner;
    curve.block = whole_number(where.substr(0, dot));
    if (curve.of == Of::corner)
      curve.corner = whole_number(where.substr(dot + 1));
    if (curve.block < 1 || (curve.of == Of::corner && curve.corner < 1))
      throw std::runtime_error(fmt::format("'{}': after the colon give a block (9), a "
                                           "corner of it (9.2), max, min, mean or sum",
                                           text));
  }
  if (model_alone)
    throw std::runtime_error(
        fmt::format("{0} is a quantity of the whole model: write {0} alone", name));
  if (curve.of == Of::corner && std::find(corner_names.begin(), corner_names.end(),
                                          curve.quantity) == corner_names.end())
    throw std::runtime_error(fmt::format("a corner has no {}: choose {}", name,
                                         fmt::join(corner_names, ", ")));
  return curve;
}

}  // namespace blocks::post
