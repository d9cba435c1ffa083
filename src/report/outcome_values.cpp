#include "report/outcome_values.hpp"

#include <algorithm>

#include "report/factor_of_safety.hpp"
#include "report/statistics.hpp"

namespace blocks::report {
namespace {

using Json = nlohmann::ordered_json;

const std::set<std::string> meant_as_shares = {"hung",     "fell", "could_hang",
                                               "diverged", "deep", "certificate"};

/// Returns the object with the numbers of a variant, or of the layers; null if there is
/// none.
const Json* numbers_of(const sweep::Outcome& outcome, const std::string& variant) {
  const char* part = variant.empty() ? "layers" : "study";
  const auto found = outcome.measured.find(part);
  if (found == outcome.measured.end() || !found->is_object())
    return nullptr;
  if (variant.empty())
    return &*found;
  const auto row = found->find(variant);
  return row == found->end() || !row->is_object() ? nullptr : &*row;
}

double number(const Json& json) {
  if (json.is_boolean())
    return json.get<bool>() ? 1.0 : 0.0;
  return json.is_number() ? json.get<double>() : no_number;
}

/// Calls visit(name, value) for every number, and for every part of a distribution.
template <class Visit>
void for_each_number(const sweep::Outcome& outcome, const Visit& visit) {
  for (const std::string& variant : measured_variants(outcome)) {
    const Json* numbers = numbers_of(outcome, variant);
    if (numbers == nullptr)
      continue;
    for (const auto& [name, value] : numbers->items())
      if (value.is_object())
        for (const auto& [part, of_part] : value.items())
          visit(name + ':' + part, of_part);
      else
        visit(name, value);
  }
}

}  // namespace

std::vector<std::string> measured_variants(const sweep::Outcome& outcome) {
  std::vector<std::string> names;
  const auto study = outcome.measured.find("study");
  if (study != outcome.measured.end() && study->is_object())
    for (const auto& [name, row] : study->items())
      if (row.is_object())
        names.push_back(name);
  return names.empty() ? std::vector<std::string>{no_variant} : names;
}

std::set<std::string> measured_names(const sweep::Outcome& outcome) {
  std::set<std::string> names;
  for_each_number(outcome, [&](const std::string& name, const Json& value) {
    if (value.is_number() || value.is_boolean() || value.is_null())
      names.insert(name);
  });
  return names;
}

std::set<std::string> measured_shares(const sweep::Outcome& outcome) {
  std::set<std::string> names;
  for_each_number(outcome, [&](const std::string& name, const Json& value) {
    if (value.is_boolean() || meant_as_shares.contains(name))
      names.insert(name);
  });
  return names;
}

double measured_value(const sweep::Outcome& outcome, const std::string& variant,
                      const std::string& name) {
  const Json* numbers = numbers_of(outcome, variant);
  if (numbers == nullptr)
    return no_number;
  // Nothing is expected to move in such a frame, so it does not count.
  const auto can_hang = numbers->find("could_hang");
  if (name == "hung" && can_hang != numbers->end() && number(*can_hang) == 0.0)
    return no_number;
  if (const auto whole = numbers->find(name); whole != numbers->end())
    return number(*whole);
  const auto colon = name.rfind(':');
  if (colon == std::string::npos)
    return no_number;
  const auto parts = numbers->find(name.substr(0, colon));
  if (parts == numbers->end() || !parts->is_object())
    return no_number;
  const auto part = parts->find(name.substr(colon + 1));
  return part == parts->end() ? no_number : number(*part);
}

double value_of(const Measure& measure, const sweep::Outcome& outcome,
                const std::string& variant, double scale) {
  if (safety_names().contains(measure.key)) {
    const auto bracket = safety_bracket(outcome);
    return bracket ? safety_value(*bracket, measure) : no_number;
  }
  return measure.with_limit(scale * measured_value(outcome, variant, measure.key));
}

std::vector<std::string> usual_names(const std::set<std::string>& names, bool study) {
  const std::vector<std::string> telling =
      study ? std::vector<std::string>{"hung",   "fell",       "phantom",
                                       "missed", "speed_lost", "energy_error"}
            : std::vector<std::string>{"blocks",
                                       "aspect:p50",
                                       "aspect:max",
                                       "shortest_side:min",
                                       "smallest_angle:min",
                                       "absorbed",
                                       "angles_redrawn",
                                       "p21",
                                       "t_vertices",
                                       "x_vertices",
                                       "certificate"};
  std::vector<std::string> usual;
  for (const std::string& name : telling)
    if (names.contains(name))
      usual.push_back(name);
  return usual.empty() ? std::vector<std::string>(names.begin(), names.end()) : usual;
}

}  // namespace blocks::report
