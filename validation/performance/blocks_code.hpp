// The time loop of the program as a contestant.
#pragma once

#include "contestant.hpp"
#include "dynamics/step.hpp"
#include "model/model.hpp"
#include "timing.hpp"

namespace blocks::bench {

/// Returns the number of blocks of a model that can move.
int free_blocks(const Model& model);

class BlocksCode : public Contestant {
 public:
  /// Starts from the present state of the model.
  explicit BlocksCode(Model start, std::string name = "blocks", int threads = 1);

  std::string name() const override { return name_; }
  int threads() const override { return work_.workers->threads(); }
  double work_per_step() const override { return free_; }  ///< block-steps
  /// Throws std::runtime_error if a corner is no longer finite.
  void run(long steps) override;
  /// Runs `steps` steps. Returns the share of each phase in the time of a step.
  Phases run_phases(long steps);

  const Model& model();
  /// Does the next step begin with a search?
  bool searches() const { return !model_.search.current; }

 private:
  Model model_;
  long made_ = 0;  ///< steps
  dynamics::Workspace work_;
  std::string name_;
  int free_;
};

}  // namespace blocks::bench
