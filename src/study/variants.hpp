// Every variant of the contact decision that `blocks study contacts` compares. Each
// replaces dynamics::ContactRules in the step of runs; the time loop is the same.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "dynamics/step.hpp"
#include "study/scene.hpp"

namespace blocks::study {

/// Answers and how many of them differ from exact arithmetic.
struct SignTally {
  long areas = 0, wrong_areas = 0;        ///< signs of (19)
  long tangents = 0, wrong_tangents = 0;  ///< (20)
};

/// One run by the rules of a variant, with what these remember from step to step.
class VariantRun {
 public:
  virtual ~VariantRun() = default;
  /// Brings the pairs of blocks up to date.
  virtual void find(Model& model, dynamics::Workspace& work) = 0;
  /// One step, after find().
  virtual dynamics::StepResult step(Model& model, dynamics::Workspace& work) = 0;
};

struct Variant {
  std::string_view name, what;
  Corners corners;
  std::unique_ptr<VariantRun> (*start)();
  /// Compares the arithmetic of the variant with the exact one: every corner of a pair
  /// of near blocks against every edge of the other block.
  void (*judge_signs)(const Blocks&, const dynamics::PairIndex&, SignTally&);
};

/// In the order of the tables; the first is the rules of every run.
const std::vector<Variant>& all_variants();

/// Null when there is none of that name.
const Variant* find_variant(std::string_view name);

}  // namespace blocks::study
