#include "run/builder/history_card.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "text/suggest.hpp"

namespace blocks::run {
namespace {

using quantities::CurveFault;

/// Returns the nearest name of a quantity, or an empty text.
std::string nearest_quantity(const std::string& word) {
  std::vector<std::string_view> names = {"ke"};
  for (const auto& kind : quantities::quantity_kinds())
    names.push_back(kind.name);
  for (const auto& [name, kind] : quantities::other_kinds())
    names.push_back(name);
  return text::suggest(word, names);
}

std::string hint_for(const CurveFault& fault) {
  if (fault.unknown.empty())
    return fault.hint;
  const std::string near = nearest_quantity(fault.unknown);
  return near.empty() ? "quantities: " + quantities::block_quantity_names()
                      : "did you mean '" + near + "'?";
}

}  // namespace

std::vector<NamedCurve> named_curves(const deck::Command& command,
                                     deck::Diagnostics& diagnostics) {
  const auto& card = std::get<deck::History>(command.card);
  std::vector<NamedCurve> curves;
  if (card.quantities.empty())
    for (const char* usual : quantities::usual_curves)
      curves.push_back({quantities::parse_curve(usual), command.where});
  std::map<std::string, std::vector<deck::SourceLocation>> places;
  for (const deck::Word& word : card.quantities) {
    try {
      NamedCurve named{quantities::parse_curve(word.value), word.where};
      places[named.curve.name()].push_back(word.where);
      curves.push_back(std::move(named));
    } catch (const CurveFault& fault) {
      diagnostics.error(word.where, command.name, fault.what(), hint_for(fault));
    }
  }
  for (const auto& [name, at] : places)
    if (at.size() > 1)
      diagnostics.error(
          at[1], command.name,
          fmt::format("{} is named {}", name,
                      at.size() == 2 ? "twice" : fmt::format("{} times", at.size())),
          "name every quantity once");
  return curves;
}

quantities::MaterialNumbers material_numbers(const Settings& settings) {
  quantities::MaterialNumbers numbers;
  for (const auto& [number, material] : settings.materials)
    if (!material.name.empty())
      numbers[material.name] = number;
  return numbers;
}

}  // namespace blocks::run
