#include "driven_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "errors.hpp"
#include "library/model_access.hpp"
#include "signal_watch.hpp"

namespace blocks::python {

using library::ModelAccess;

/// The call of step() or cards() by one thread. That thread may use the model in its
/// callbacks, also for steps.
class DrivenModel::Use {
 public:
  explicit Use(DrivenModel& model) : self_(model), before_(model.user_) {
    self_.simulation();
    self_.user_ = std::this_thread::get_id();
  }
  ~Use() { self_.user_ = before_; }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  DrivenModel& self_;
  std::thread::id before_;
};

/// While it exists, the lock of Python is released and nothing may use the model.
class DrivenModel::AtWork {
 public:
  explicit AtWork(DrivenModel& model) : self_(model) {
    self_.at_work_ = true;
    released_.emplace();
  }
  ~AtWork() {
    released_.reset();
    self_.at_work_ = false;
    if (self_.views_.exist())
      self_.blocks();  // brings them up to date
    if (self_.views_.exist_writable())
      self_.watch_.begin(self_.blocks());
    else
      self_.watch_.end();
  }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  DrivenModel& self_;
  std::optional<py::gil_scoped_release> released_;
};

DrivenModel::DrivenModel(const std::string& name,
                         const std::optional<std::string>& text, int threads,
                         bool moves) {
  const auto detach_views = [this] {
    if (simulation_)
      views_.detach(ModelAccess::stored_blocks(*simulation_));
  };
  // Cards may take long to make their blocks, and to make steps.
  const py::gil_scoped_release released;
  simulation_.emplace(ModelAccess::make(name, text, threads,
                                        moves ? Motions::made : Motions::left_out,
                                        {signal_watch(), detach_views}));
}

DrivenModel::~DrivenModel() {
  views_.hand_over(ModelAccess::stored_blocks(*simulation_));
}

Simulation& DrivenModel::simulation() {
  if (at_work_ || (user_ != std::thread::id() && user_ != std::this_thread::get_id()))
    throw std::runtime_error(at_work_ && user_ == std::this_thread::get_id()
                                 ? "the simulation is making steps"
                                 : "another thread is using the simulation");
  return *simulation_;
}

Blocks& DrivenModel::blocks() { return ModelAccess::blocks(simulation()); }
const Model& DrivenModel::model() { return ModelAccess::model(simulation()); }

int DrivenModel::index(int block) {
  const int n = simulation().blocks();
  if (block < 0 || block >= n)
    throw py::index_error("block " + std::to_string(block) + " is not in range 0 to " +
                          std::to_string(n - 1));
  return block;
}

void DrivenModel::cards(const std::string& text) {
  const Use use(*this);
  take_changes();
  const AtWork at_work(*this);
  simulation_->cards(text);
}

void DrivenModel::step(long count, std::optional<bool> read, long every,
                       const py::object& callback) {
  if (count < 0)
    throw py::value_error("the number of steps is negative: " + std::to_string(count));
  if (every < 0)
    throw py::value_error("`every` is negative: " + std::to_string(every));
  const Use use(*this);
  take_changes();
  if (count == 0)
    simulation_->step(0);
  const bool calls = every > 0 && !callback.is_none();
  wants_contacts_ = wants_contacts_ || calls;  // by the first call, perhaps
  for (long left = count; left > 0;) {
    const long part = calls ? std::min(left, every) : left;
    const bool reads = read.value_or(wants_contacts_ || part >= steps_worth_reading);
    wants_contacts_ = false;
    advance(part, reads);
    left -= part;
    if (!calls || part < every)
      continue;
    const py::object answer = callback();
    const int stops = PyObject_IsTrue(answer.ptr());
    if (stops < 0)
      throw py::error_already_set();
    take_changes();
    if (stops != 0)
      break;
  }
}

void DrivenModel::advance(long count, bool reads) {
  const AtWork at_work(*this);
  simulation_->step(count, reads);
}

long DrivenModel::steps_until(double time) {
  if (!std::isfinite(time))
    throw py::value_error("the time is not a finite number");
  const double left = time - simulation().time(), dt = simulation().time_step();
  if (!(left > 0.0) || !(dt > 0.0))
    return 0;
  if (left / dt > 0x1p62)
    throw py::value_error("there are too many steps to this time");
  return ModelAccess::steps_for(left, dt);
}

py::array DrivenModel::velocity() {
  take_changes();
  Blocks& all = blocks();
  watch_.begin(all);
  return views_.writable(all.velocity.data(), {all.size(), 2});
}

py::array DrivenModel::spin() {
  take_changes();
  Blocks& all = blocks();
  watch_.begin(all);
  return views_.writable(all.spin.data(), {all.size()});
}

void DrivenModel::set_velocities(const py::object& value) {
  velocity().attr("__setitem__")(py::ellipsis(), value);
  take_changes();
}

void DrivenModel::set_spins(const py::object& value) {
  spin().attr("__setitem__")(py::ellipsis(), value);
  take_changes();
}

void DrivenModel::set_velocity(int block, const Vec2& velocity,
                               std::optional<double> spin) {
  take_changes();
  const int b = index(block);
  Blocks& all = blocks();
  watch_.begin(all);
  all.velocity.col(b) = velocity;
  all.spin[b] = spin.value_or(all.spin[b]);
  take_changes();
}

void DrivenModel::set_force(int block, const Vec2& force) {
  take_changes();
  const std::string name = "block " + std::to_string(block);
  if (!force.allFinite())
    throw py::value_error("the force on " + name + " is not finite");
  if (!blocks().is_free(index(block)))
    throw py::value_error(name + " is not free, so no force moves it");
  simulation().set_force(block + 1, force);
}

void DrivenModel::take_changes() {
  Blocks& all = blocks();
  if (!watch_.has_changed(all) || ModelAccess::is_unsound(*simulation_))
    return;
  for (int b = 0; b < all.size(); ++b) {
    const bool finite = all.velocity.col(b).allFinite() && std::isfinite(all.spin[b]);
    if (!watch_.has_changed(all, b) || (finite && all.is_free(b)))
      continue;
    watch_.restore(all);
    const std::string name = "block " + std::to_string(b);
    throw py::value_error(finite ? name + " is not free, so its velocity cannot be set"
                                 : "the velocity of " + name + " is not finite");
  }
  ModelAccess::take_velocities(*simulation_);
  watch_.begin(all);
}

std::vector<ContactForce> DrivenModel::contacts() {
  wants_contacts_ = true;
  if (!simulation().is_read())
    raise("NotReadError",
          "the contacts of step " + std::to_string(simulation().steps()) +
              " are not known: step(read=True) reads the last step of a call");
  return simulation().contacts();
}

}  // namespace blocks::python
