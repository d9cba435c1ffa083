#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "study/scene.hpp"
#include "study/variants.hpp"
#include "sweep/make_plan.hpp"
#include "text/suggest.hpp"

namespace blocks::sweep {
namespace {

/// Throws AxisFault unless the name is one of these.
void expect_known(const char* what, const std::string& name,
                  const std::vector<std::string_view>& names) {
  if (std::find(names.begin(), names.end(), name) != names.end())
    return;
  const std::string near = text::suggest(name, names);
  throw AxisFault(fmt::format("there is no {} '{}'", what, name),
                  (near.empty() ? "" : "did you mean " + near + "? ") +
                      "'blocks study contacts --list' shows scenes and variants");
}

std::vector<std::string> scenes_of(const std::string& text) {
  const auto& known = study::scene_names();
  if (text == "all")
    return {known.begin(), known.end()};
  const Axis scenes = parse_axis("study.scene=" + text);
  for (const std::string& scene : scenes.values)
    expect_known("scene", scene, {known.begin(), known.end()});
  return scenes.values;
}

std::vector<std::string> variants_of(const std::vector<std::string>& given) {
  std::vector<std::string_view> known;
  for (const study::Variant& variant : study::all_variants())
    known.push_back(variant.name);
  if (given.empty())
    return {known.begin(), known.end()};
  for (const std::string& variant : given)
    expect_known("variant", variant, known);
  return given;
}

}  // namespace

Plan make_study_plan(const Request& request) {
  if (!request.sets.empty() || !request.table.empty() || !request.sobol.empty() ||
      request.until || request.audit_every > 0)
    throw AxisFault(
        "the scenes of a study have no deck, so --set, --table, --sobol, --until "
        "and --audit do not apply",
        "give --seeds (numbers of frames) and --variants");
  if (request.seeds.empty())
    throw AxisFault("a study needs the numbers of its frames",
                    "for example --seeds 0-999");
  Plan plan;
  plan.kind = Kind::study;
  plan.name = "study";
  plan.version = BLOCKS_VERSION;
  plan.numerics = numerics();
  plan.variants = variants_of(request.variants);
  plan.runs =
      combine({}, {{"scene", scenes_of(request.deck)}}, parse_seeds(request.seeds));
  plan.axes = axes_of(plan.runs.front());
  return plan;
}

}  // namespace blocks::sweep
