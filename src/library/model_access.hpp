// The model behind a Simulation, for interfaces to other languages.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "dynamics/cracks/cracking.hpp"
#include "library/simulation_state.hpp"
#include "run/executor/executor.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::library {

/// Opens what Simulation hides. A reference to the model or its blocks shows the state
/// of the moment; it stays valid as long as the Simulation.
class ModelAccess {
 public:
  /// Makes a Simulation. name: of the deck in messages, or its path if there is no
  /// text.
  static Simulation make(const std::string& name,
                         const std::optional<std::string>& text, int threads,
                         Motions motions, Hooks hooks) {
    return Simulation(std::make_unique<Simulation::State>(
        name, text ? "" : run::deck_folder(name), text ? *text : run::read_deck(name),
        threads, motions, std::move(hooks)));
  }
  /// Returns the model after the last step.
  static Model& model(Simulation& simulation) { return simulation.state_->current(); }
  /// Returns its blocks, without writing the list of contacts if it need not be.
  static Blocks& blocks(Simulation& simulation) { return simulation.state_->blocks(); }
  /// Returns its blocks as they are in memory, perhaps before the last steps.
  static Blocks& stored_blocks(Simulation& simulation) {
    return simulation.state_->model.blocks;
  }
  /// The number of steps of an interval, as MOTION makes them.
  static long steps_for(double interval, double dt) {
    return run::steps_for(interval, dt);
  }
  /// To be called when velocities or spins of blocks() have been changed.
  static void take_velocities(Simulation& simulation) {
    simulation.state_->take_velocities_and_loads();
  }
  static bool is_unsound(const Simulation& simulation) {
    return !simulation.state_->unsound.empty();
  }
  /// Throws UnsoundRun if an earlier step was unsound.
  static void must_be_sound(const Simulation& simulation) {
    simulation.state_->must_be_sound();
  }
};

}  // namespace blocks::library
