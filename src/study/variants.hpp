// The variants of the contact decision that `blocks study contacts` compares. Each one
// replaces Workspace::rule in the step; the time loop is the same.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "dynamics/step.hpp"
#include "study/scene.hpp"

namespace blocks::study {

/// The number of computed signs, and how many differ from exact arithmetic.
struct SignTally {
  long areas = 0, wrong_areas = 0;        ///< signs of (19)
  long tangents = 0, wrong_tangents = 0;  ///< answers to (20)
};

/// A run with the rules of a variant, including their state from step to step.
class VariantRun {
 public:
  virtual ~VariantRun() = default;
  /// Updates the pairs of blocks.
  virtual void find(Model& model, dynamics::Workspace& work) = 0;
  /// Makes one step. Call it after find().
  virtual dynamics::StepResult step(Model& model, dynamics::Workspace& work) = 0;
};

struct Variant {
  std::string_view name, what;
  Corners corners;
  std::unique_ptr<VariantRun> (*start)();
  /// Compares the arithmetic of the variant with exact arithmetic. It tests every
  /// corner of a pair of near blocks against every edge of the other block.
  void (*judge_signs)(const Blocks&, const dynamics::PairIndex&, SignTally&);
};

/// All variants in the order of the tables. The first one is the default rules.
const std::vector<Variant>& all_variants();

/// Returns the variant with this name, or null if there is none.
const Variant* find_variant(std::string_view name);

}  // namespace blocks::study
