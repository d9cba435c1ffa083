#include "sweep/safety_outcome.hpp"

#include <fstream>

#include "output/file_tools.hpp"

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? *found : Json();
}

}  // namespace

Json safety_outcome(const std::string& summary_path) {
  if (!output::has_text(summary_path, 0, "{"))
    return {};
  std::ifstream in(summary_path, std::ios::binary);
  const Json summary = Json::parse(in, nullptr, false);
  if (!summary.is_object())
    return {};
  const auto proved = summary.find("factor_of_safety");
  if (proved == summary.end() || !proved->is_object())
    return {};
  return {{"lower", number_or_null(*proved, "lower")},
          {"upper", number_or_null(*proved, "upper")}};
}

}  // namespace blocks::sweep
