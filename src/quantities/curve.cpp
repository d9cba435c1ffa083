#include "quantities/curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "quantities/energy.hpp"
#include "quantities/model_quantity.hpp"
#include "quantities/quantity.hpp"

namespace blocks::quantities {
namespace {

using Subject = Curve::Subject;
using Ranges = std::vector<std::pair<int, int>>;

/// The quantities of a corner: position, displacement and velocity.
const std::vector<std::string> corner_names = {
    "x", "y", "dx", "dy", "speed", "displacement", "vx", "vy"};

constexpr const char* places =
    "after the colon give block 9, its corner 9.2, or several blocks: 6-9, 6-9/12 or "
    "material=2, alone or with max, min, mean, sum or a percentile from p0 to p100; "
    "for "
    "quantities of contacts also joint=1 or the two blocks 2+3";

/// Returns a whole number from 1, or 0 if the text is none.
int whole_number(const std::string& digits) {
  const bool fine = !digits.empty() && digits.size() < 10 &&
                    digits.find_first_not_of("0123456789") == std::string::npos;
  return fine ? std::stoi(digits) : 0;
}

/// Reads ranges such as "6-9/12". Returns false if they do not ascend.
bool read_ranges(const std::string& where, Curve& curve) {
  curve.subject = Subject::blocks;
  for (std::size_t begin = 0; begin <= where.size();) {
    const std::size_t end = std::min(where.find('/', begin), where.size());
    const std::string range = where.substr(begin, end - begin);
    const std::size_t mark = range.find('-');
    const int first = whole_number(range.substr(0, mark));
    const int last =
        mark == std::string::npos ? first : whole_number(range.substr(mark + 1));
    const int before = curve.ranges.empty() ? 0 : curve.ranges.back().second;
    if (first <= before || last < first)
      return false;
    curve.ranges.emplace_back(first, last);
    begin = end + 1;
  }
  curve.first = curve.ranges.front().first;
  curve.last = curve.ranges.back().second;
  return true;
}

/// Reads "9", "9.2", "6-9", "2+3", "material=2" or "joint=1". Returns false if it is
/// none of them.
bool read_place(const std::string& where, Curve& curve) {
  const std::string material = "material=";
  if (where.starts_with(material)) {
    curve.subject = Subject::blocks;
    curve.material = where.substr(material.size());
    return !curve.material.empty();
  }
  const std::string joint = "joint=";
  if (where.starts_with(joint)) {
    curve.subject = Subject::joint;
    curve.joint = whole_number(where.substr(joint.size()));
    return curve.joint > 0;
  }
  if (where.find('/') != std::string::npos)
    return read_ranges(where, curve);
  const auto mark = where.find_first_of(".-+");
  curve.first = curve.last = whole_number(where.substr(0, mark));
  curve.subject = Subject::block;
  if (mark == std::string::npos)
    return curve.first > 0;
  const int second = whole_number(where.substr(mark + 1));
  if (where[mark] == '.')
    curve.subject = Subject::corner, curve.corner = second;
  else if (where[mark] == '+')
    curve.subject = Subject::pair, curve.last = std::max(curve.first, second),
    curve.first = std::min(curve.first, second);
  else
    curve.subject = Subject::blocks, curve.last = second;
  return curve.first > 0 && second > 0;
}

/// Reads what is after the first colon: a place, a statistic, or both.
void read_where(const std::string& text, const std::string& where, Curve& curve) {
  if (Statistic::parse(where, curve.statistic)) {
    curve.subject = Subject::blocks;
    return;
  }
  std::string place = where;
  bool reduced = false;
  if (const auto colon = where.rfind(':'); colon != std::string::npos) {
    reduced = Statistic::parse(where.substr(colon + 1), curve.statistic);
    if (reduced)
      place = where.substr(0, colon);
  }
  if (!read_place(place, curve))
    throw CurveFault(fmt::format("cannot read the place in '{}'", text), places);
  if (curve.first > curve.last)
    throw CurveFault(
        fmt::format("'{}' begins with the higher number", text),
        fmt::format("write {}:{}-{}", curve.quantity, curve.last, curve.first));
  if (reduced && curve.subject != Subject::blocks && !curve.of_contacts())
    throw CurveFault(
        fmt::format("'{}': {} is for several blocks", text, curve.statistic.name()),
        places);
  curve.has_statistic = reduced && curve.of_contacts();
}

/// Returns "6-9/12" of ranges; a single block alone is "6-6", because "6" has no
/// statistic.
std::string text_of(const Ranges& ranges) {
  std::string text;
  for (const auto& [first, last] : ranges) {
    text += (text.empty() ? "" : "/") + std::to_string(first);
    if (last > first || ranges.size() == 1)
      text += "-" + std::to_string(last);
  }
  return text;
}

/// Lists the quantities of the contacts of a joint or of two blocks.
std::string contact_quantities() {
  std::string names;
  for (const auto& [name, kind] : other_kinds())
    if (!kind.whole)
      names += (names.empty() ? "" : ", ") + name;
  return names;
}

std::string joint_places(const std::string& name) {
  return fmt::format("{0}:joint=1 is that of the joint with id 1, {0}:2+3 that between "
                     "blocks 2 and 3",
                     name);
}

}  // namespace

std::string Curve::numbers() const {
  return text_of(ranges.empty() ? Ranges{{first, last}} : ranges);
}

bool Curve::has_block(int number) const {
  const auto after = std::upper_bound(
      ranges.begin(), ranges.end(), number,
      [](int wanted, const auto& range) { return wanted < range.first; });
  return ranges.empty() || (after != ranges.begin() && number <= (after - 1)->second);
}

std::string place_of_blocks(const std::vector<int>& blocks) {
  Ranges ranges;
  for (const int b : blocks) {
    if (!ranges.empty() && ranges.back().second == b)
      ranges.back().second = b + 1;
    else
      ranges.emplace_back(b + 1, b + 1);
  }
  return text_of(ranges);
}

std::string Curve::name() const {
  switch (subject) {
  case Subject::model:
    return quantity;
  case Subject::block:
    return fmt::format("{}:{}", quantity, first);
  case Subject::corner:
    return fmt::format("{}:{}.{}", quantity, first, corner);
  case Subject::joint:
  case Subject::pair: {
    const std::string where = subject == Subject::pair
                                  ? fmt::format("{}+{}", first, last)
                                  : fmt::format("joint={}", joint);
    return fmt::format("{}:{}{}", quantity, where,
                       has_statistic ? ":" + statistic.name() : "");
  }
  case Subject::blocks:
    break;
  }
  if (all_blocks())
    return fmt::format("{}:{}", quantity, statistic.name());
  const std::string place = material.empty() ? numbers() : "material=" + material;
  const bool usual = statistic.how == Statistic::How::mean;
  return fmt::format("{}:{}{}", quantity, place, usual ? "" : ":" + statistic.name());
}

std::string history_help() {
  std::string whole;
  for (const auto& [name, kind] : other_kinds())
    if (!kind.per_length)
      whole += (whole.empty() ? "" : ", ") + name;
  for (const QuantityKind& kind : quantity_kinds())
    if (kind.additive)
      whole += ", " + kind.name;
  return "of blocks (:9, :6-9, :material=2, :max, :min, :mean, :sum, :p90): " +
         quantity_names() +
         "\nof corners (:9.2): " + fmt::format("{}", fmt::join(corner_names, ", ")) +
         "\nof joints with a law or of two blocks (:joint=1, :2+3): " +
         contact_quantities() + "\nof the model: " + whole;
}

namespace {

/// Whether the part of a name before the colon is that of the energy account.
bool is_energy(std::string name) {
  for (char& c : name)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name + ':' == energy_prefix;
}

/// Returns the quantity of the model with this name, a colon included.
Curve named(const std::string& text) {
  Curve curve;
  for (const char c : text)
    curve.quantity += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return curve;
}

/// Reads "energy:NAME", which names a quantity of the model.
Curve parse_energy(const std::string& text) {
  if (const OtherKind* kind = find_other(text); kind == nullptr) {
    std::string names;
    for (const EnergyQuantity& one : energy_quantities())
      names += (names.empty() ? "" : ", ") + (energy_prefix + one.name);
    throw CurveFault("the energy account has no entry '" + text + "'", names);
  }
  return named(text);
}

}  // namespace

Curve parse_curve(const std::string& text) {
  const auto colon = text.find(':');
  const std::string name = text.substr(0, colon);
  if (is_energy(name))
    return parse_energy(text);
  if (colon != std::string::npos && find_other(text) != nullptr)
    return named(text);  // unbalanced:local
  const QuantityKind* kind = find_quantity(name);
  const OtherKind* other = find_other(name);
  if (!kind && !other) {
    CurveFault fault("there is no quantity '" + name + "'", history_help());
    fault.unknown = name;
    throw fault;
  }
  Curve curve;
  curve.quantity = kind ? kind->name : name;
  const bool only_joints = other && other->per_length;
  if (only_joints && colon == std::string::npos)
    throw CurveFault(fmt::format("{} needs a joint or two blocks", name),
                     joint_places(name));
  if (colon == std::string::npos) {
    if (kind && !kind->additive)
      throw CurveFault(fmt::format("{} needs a block or a statistic", name),
                       fmt::format("{0}:9 is that of block 9, {0}:6-9 the mean of "
                                   "blocks 6 to 9, {0}:max the largest; also {0}:min, "
                                   "{0}:mean, {0}:sum, {0}:p90",
                                   name));
    return curve;
  }
  if (other && other->whole)
    throw CurveFault(fmt::format("{} is a quantity of the whole model", name),
                     fmt::format("write {} alone", name));
  read_where(text, text.substr(colon + 1), curve);
  if (curve.of_contacts() && kind)
    throw CurveFault(fmt::format("{} is a quantity of blocks, not of contacts", name),
                     "a joint or two blocks have: " + contact_quantities());
  if (only_joints && !curve.of_contacts())
    throw CurveFault(fmt::format("{} is a quantity of joints", name),
                     joint_places(name));
  if (only_joints && curve.has_statistic)
    throw CurveFault(fmt::format("{} is a sum of forces over a length, without a "
                                 "statistic",
                                 name),
                     joint_places(name));
  if (curve.subject == Subject::pair && curve.first == curve.last)
    throw CurveFault(fmt::format("'{}' has the same block twice", text),
                     "a contact has two blocks");
  if (curve.subject == Subject::corner &&
      std::find(corner_names.begin(), corner_names.end(), curve.quantity) ==
          corner_names.end())
    throw CurveFault(
        fmt::format("a corner has no {}", name),
        fmt::format("quantities of a corner: {}", fmt::join(corner_names, ", ")));
  return curve;
}

}  // namespace blocks::quantities
