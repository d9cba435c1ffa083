// A Simulation as Python drives it: its views, the changes that Python writes to them,
// and the threads that may use it.
#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "blocks/simulation.hpp"
#include "model/model.hpp"
#include "velocity_watch.hpp"
#include "views.hpp"

namespace blocks::python {

/// Counts blocks from 0, as Python does. Call all functions with the lock of Python.
class DrivenModel {
 public:
  DrivenModel(const std::string& name, const std::optional<std::string>& text,
              int threads, bool moves);
  ~DrivenModel();
  DrivenModel(const DrivenModel&) = delete;
  DrivenModel& operator=(const DrivenModel&) = delete;

  /// Returns the simulation. Throws std::runtime_error while it makes steps, and while
  /// another thread is in step() or cards().
  Simulation& simulation();
  /// Returns the blocks and the model after the last step.
  Blocks& blocks();
  const Model& model();
  /// Returns the index of a block. Throws py::index_error.
  int index(int block);

  /// Executes cards without the lock of Python.
  void cards(const std::string& text);
  /// Makes `count` steps without the lock of Python, and calls `callback` after every
  /// `every` steps (0: never) until it returns a true value. What handlers of signals
  /// raise ends it after a step.
  void step(long count, std::optional<bool> read, long every,
            const py::object& callback);
  /// The number of steps from now to a time, 0 if it has passed.
  long steps_until(double time);

  py::array velocity();
  py::array spin();
  void set_velocities(const py::object& value);
  void set_spins(const py::object& value);
  void set_velocity(int block, const Vec2& velocity, std::optional<double> spin);
  void set_force(int block, const Vec2& force);
  /// Takes over what Python has written to views. Throws py::value_error, and undoes
  /// it, if a velocity is not finite or its block is not free.
  void take_changes();

  /// The contacts of the last step. Raises NotReadError if it was not read.
  std::vector<ContactForce> contacts();
  const Views& views() const { return views_; }

 private:
  /// From this number of steps on, reading the last one takes little of the time.
  static constexpr long steps_worth_reading = 50;
  class Use;
  class AtWork;

  /// Makes steps; afterwards, or after an exception, watches the present velocities.
  void advance(long count, bool reads);

  Views views_;  // before simulation_, whose steps detach them
  VelocityWatch watch_;
  std::thread::id user_;  ///< the thread in step() or cards(); none: the default value
  bool at_work_ = false;  ///< the lock of Python is released
  bool wants_contacts_ = false;  ///< contacts were asked for since the last steps
  std::optional<Simulation> simulation_;
};

}  // namespace blocks::python
