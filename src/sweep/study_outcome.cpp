#include "sweep/study_outcome.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "study/study.hpp"

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

/// The row of one frame: its means are the values of this frame.
Json as_json(const study::Row& row) {
  if (!row.refused.empty())
    return {{"refused", row.refused}};
  const auto value = [](const study::Estimate& estimate) {
    return std::isfinite(estimate.value) ? Json(estimate.value) : Json();
  };
  Json json = {{"could_hang", std::isnan(row.hang_ups.value) ? 0 : 1},
               {"hung", row.hung},
               {"fell", row.fell},
               {"wrong_signs", value(row.wrong_signs)},
               {"wrong_tangents", value(row.wrong_tangents)},
               {"phantom", value(row.phantom)},
               {"missed", value(row.missed)},
               {"speed_lost", value(row.speed_lost)},
               {"energy_error", value(row.energy)},
               {"diverged", row.diverged},
               {"diverged_step", value(row.divergence_step)}};
  if (row.kinds.empty())
    return json;
  json["deep"] = row.deep;
  json["kind"] = row.kinds.front().kind;
  json["why"] = row.reasons.empty() ? "" : row.reasons.front().why;
  return json;
}

}  // namespace

std::string scene_of(const Variation& run) {
  const std::string& set = run.sets.front();
  return set.substr(set.find('=') + 1);
}

Json study_outcome(study::Scene scene, int frame, std::uint64_t seed,
                   const std::vector<std::string>& variants) {
  study::StudyChoice choice;
  choice.frames.seed = seed;
  choice.first = frame;
  choice.count = 1;
  for (const std::string& name : variants) {
    choice.variants.push_back(study::find_variant(name));
    if (choice.variants.back() == nullptr)
      throw std::out_of_range("there is no variant '" + name + "'");
  }
  const study::Study study = study::run_study(std::move(scene), choice);
  if (!study.refused.empty())
    throw study::UnfitBlock(study.refused);
  Json result = {{"steps", study.steps}};
  for (const study::Row& row : study.rows)
    result[std::string(row.variant->name)] = as_json(row);
  return result;
}

Json study_outcome(const std::string& scene, int frame, std::uint64_t seed,
                   const std::vector<std::string>& variants) {
  return study_outcome(study::make_scene(scene), frame, seed, variants);
}

}  // namespace blocks::sweep
