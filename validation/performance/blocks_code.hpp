// The program's own time loop as a contestant.
#pragma once

#include "contestant.hpp"
#include "dynamics/step.hpp"
#include "model/model.hpp"
#include "timing.hpp"

namespace blocks::bench {

/// How many blocks of a model can move.
int free_blocks(const Model& model);

class BlocksCode : public Contestant {
 public:
  /// Steps the model from its present state.
  explicit BlocksCode(Model start, std::string name = "blocks", int threads = 1);

  std::string name() const override { return name_; }
  int threads() const override { return work_.workers->threads(); }
  double work_per_step() const override { return free_; }  ///< block-steps
  /// Throws std::runtime_error when a corner is no longer a number.
  void run(long steps) override;
  /// Runs that many steps. Returns how the time of a step divides: shares of 1.
  Phases run_phases(long steps);

  const Model& model();
  /// The next step begins with a search.
  bool searches() const { return !model_.search.current; }

 private:
  Model model_;
  long made_ = 0;  ///< steps
  dynamics::Workspace work_;
  std::string name_;
  int free_;
};

}  // namespace blocks::bench
