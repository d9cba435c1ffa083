#include "sweep/study_tables.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <stdexcept>

#include "files/file_error.hpp"
#include "run/run.hpp"
#include "run/support/shell_word.hpp"
#include "sweep/json_fields.hpp"
#include "sweep/outcome.hpp"
#include "sweep/study_outcome.hpp"

namespace blocks::sweep {
namespace {

using Json = nlohmann::ordered_json;

/// The frames of a variant in a scene, or why it could not make its blocks in one.
struct VariantFrames {
  std::vector<study::FrameValues> frames;
  std::string refused;
};

struct SceneFrames {
  std::string scene;
  long steps = 0;
  std::string refused;
  std::map<std::string, VariantFrames> variants;
};

study::FrameValues values_of(const Json& json, int frame) {
  const auto value = [&](const char* name) {
    return find_field(json, name).is_null() ? study::not_asked
                                            : read_number(json, name);
  };
  return {frame,
          value("could_hang") > 0,
          value("hung") > 0,
          value("fell") > 0,
          value("wrong_signs"),
          value("wrong_tangents"),
          value("phantom"),
          value("missed"),
          value("speed_lost"),
          value("energy_error"),
          value("diverged_step"),
          json.contains("deep") && read_number(json, "deep") > 0,
          json.contains("kind") ? read_text(json, "kind") : "",
          json.contains("why") ? read_text(json, "why") : ""};
}

/// Returns the outcome of a run that is done, or whose scene could not be made.
Outcome finished_outcome(const std::string& folder, const Plan& plan, std::size_t id) {
  const std::string again = "blocks sweep " + run::shell_path(folder);
  auto outcome = read_outcome(run_folder(folder, id));
  if (!outcome)
    throw files::FileError(
        fmt::format("run {} of {} ({}) is not done\n  hint: '{}' goes on with it", id,
                    folder, words_of(plan.runs[id - 1]), again));
  if (outcome->code != run::done && outcome->code != run::deck_error)
    throw files::FileError(
        fmt::format("run {} of {} ({}) ended with {}: {}\n  hint: '{} --retry' goes on "
                    "with it",
                    id, folder, words_of(plan.runs[id - 1]), outcome->status,
                    outcome->message, again));
  return *std::move(outcome);
}

void add(SceneFrames& scene, const Outcome& outcome, const Plan& plan, int frame) {
  if (outcome.code == run::deck_error) {
    if (scene.refused.empty())
      scene.refused = outcome.message;
    return;
  }
  const Json& measured = find_field(outcome.measured, "study");
  scene.steps = static_cast<long>(
      read_whole_number(measured, "steps", std::numeric_limits<int>::max()));
  for (const std::string& name : plan.variants) {
    VariantFrames& variant = scene.variants[name];
    const Json& json = find_field(measured, name.c_str());
    if (!json.contains("refused"))
      variant.frames.push_back(values_of(json, frame));
    else if (variant.refused.empty())
      variant.refused = read_text(json, "refused");
  }
}

study::Study study_of(const SceneFrames& frames, const Plan& plan) {
  const study::Scene scene = study::make_scene(frames.scene);
  study::Study study;
  study.scene = scene.name;
  study.what = scene.what;
  study.steps = frames.steps > 0 ? frames.steps : scene.steps;
  study.refused = frames.refused;
  study.must_pass = scene.must_pass;
  if (!study.refused.empty())
    return study;
  for (const std::string& name : plan.variants) {
    const VariantFrames& variant = frames.variants.at(name);
    const study::Variant& rules = *study::find_variant(name);
    if (variant.refused.empty()) {
      study.rows.push_back(study::summarise(rules, variant.frames, study_seed));
    } else {
      study::Row& row = study.rows.emplace_back();
      row.variant = &rules;
      row.refused = variant.refused;
    }
  }
  return study;
}

}  // namespace

std::vector<study::Study> read_studies(const std::string& folder, const Plan& plan) {
  if (plan.kind != Kind::study)
    throw files::FileError(
        fmt::format("{} is not the sweep of a study\n  hint: 'blocks sweep all --study "
                    "--seeds 0-999' makes one",
                    folder));
  std::vector<SceneFrames> scenes;
  for (std::size_t id = 1; id <= plan.runs.size(); ++id) {
    const Variation& run = plan.runs[id - 1];
    const std::string scene = scene_of(run);
    // The runs of a scene follow each other.
    if (scenes.empty() || scenes.back().scene != scene)
      scenes.push_back({scene, 0, {}, {}});
    const Outcome outcome = finished_outcome(folder, plan, id);
    try {
      add(scenes.back(), outcome, plan, static_cast<int>(run.seed.value()));
    } catch (const std::runtime_error& fault) {
      throw files::FileError(fmt::format("cannot read the outcome of run {} of {}: {}",
                                         id, folder, fault.what()));
    }
  }
  std::vector<study::Study> studies;
  for (const SceneFrames& frames : scenes)
    studies.push_back(study_of(frames, plan));
  return studies;
}

}  // namespace blocks::sweep
