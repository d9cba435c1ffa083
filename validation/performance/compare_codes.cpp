#include "compare_codes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "blocks_code.hpp"
#include "box2d_code.hpp"
#include "linked_list.hpp"

namespace blocks::bench {
namespace {

using Code = std::unique_ptr<Contestant>;

// Box2D makes these steps untimed, because it approaches rest in its own way.
constexpr long box2d_steps = 20;

using Start = std::function<Code()>;

/// Restarts a code after a number of steps, so that a short event can be timed for the
/// length of a turn.
class Replay : public Contestant {
 public:
  Replay(Start start, long window)
      : start_(std::move(start)), window_(window), code_(start_()) {}

  std::string name() const override { return code_->name(); }
  int threads() const override { return code_->threads(); }
  double work_per_step() const override { return code_->work_per_step(); }
  void run(long steps) override {
    while (steps > 0) {
      if (made_ == window_) {
        code_ = start_();
        made_ = 0;
      }
      const long now = std::min(steps, window_ - made_);
      code_->run(now);
      made_ += now;
      steps -= now;
    }
  }

 private:
  Start start_;
  long window_, made_ = 0;  ///< in steps
  Code code_;
};

/// Times one thread by wall-clock time, like two threads.
class ByClock : public Contestant {
 public:
  explicit ByClock(Contestant& code) : code_(code) {}
  std::string name() const override { return code_.name() + ", by the clock"; }
  bool by_clock() const override { return true; }
  double work_per_step() const override { return code_.work_per_step(); }
  void run(long steps) override { code_.run(steps); }

 private:
  Contestant& code_;
};

/// Returns the number of steps of the scene's window, or 0 if it has none.
long window_steps(const Scene& scene, const Model& state) {
  return std::lround(scene.window / state.time_step.dt);
}

/// Returns the code; if the scene has a window, the code is restarted after it.
Code replayed(const Scene& scene, const Model& state, const Start& start) {
  const long window = window_steps(scene, state);
  return window > 0 ? std::make_unique<Replay>(start, window) : start();
}

/// Returns the program. It refers to the state, which must outlive it.
Code program(const Scene& scene, const Model& state, int threads) {
  return replayed(scene, state, [&state, threads] {
    return std::make_unique<BlocksCode>(
        state, state.settings.rigid ? rigid_blocks : deformable_blocks, threads);
  });
}

/// A code that takes turns, and the index of the code that it is compared with.
struct Entry {
  Contestant* code;
  std::size_t against;  ///< its own index: no comparison
};

/// Times the codes in turns and adds a row for each.
void time_entries(const Plan& plan, const Scene& scene, double blocks,
                  const std::vector<Entry>& entries, Report& report) {
  std::vector<Contestant*> codes;
  for (const Entry& entry : entries)
    codes.push_back(entry.code);
  const auto times = take_turns(codes, plan.rounds, plan.seconds);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    Row row{.part = scene.part,
            .scene = scene.name,
            .code = codes[i]->name(),
            .threads = codes[i]->threads(),
            .blocks = blocks,
            .unit = codes[i]->name() == box2d_name ? "body-iteration" : "block-step",
            .cost = times[i].middle(),
            .state = scene.state};
    if (const std::size_t other = entries[i].against; other != i) {
      row.against = codes[other]->name();
      row.ratio = ratio(times[other], times[i]);
    }
    report.rows.push_back(row);
  }
}

/// Times one and two threads in separate turns, in which no other code uses the cores.
void time_threads(const Plan& plan, const Scene& scene, const Code& rigid,
                  const Model& rigid_state, const Code& deformable,
                  const Model& deformable_state, Report& report) {
  if (std::thread::hardware_concurrency() < 2) {
    report.note("This machine has one core: two threads are left out");
    return;
  }
  ByClock one_rigid(*rigid), one_deformable(*deformable);
  const Code two_rigid = program(scene, rigid_state, 2),
             two_deformable = program(scene, deformable_state, 2);
  time_entries(plan, scene, rigid->work_per_step(),
               {{&one_rigid, 0},
                {two_rigid.get(), 0},
                {&one_deformable, 2},
                {two_deformable.get(), 2}},
               report);
}

/// Divides the cost of a block-step, in nanoseconds, among the phases. A window is
/// profiled from its start. Otherwise the same number of steps precedes the profile.
Phases profiled(const Plan& plan, const Scene& scene, const Model& state, double cost) {
  BlocksCode code(state);
  long steps = window_steps(scene, state);
  if (steps == 0) {
    const double step = 1e-9 * cost * code.work_per_step();  // seconds
    steps = std::max(min_profiled, std::lround(plan.seconds / step));
    code.run(steps);
  }
  const Phases share = code.run_phases(steps);
  return {cost * share.decisions, cost * share.forces, cost * share.motion,
          cost * share.search};
}

}  // namespace

void compare_codes(const Plan& plan, const Scene& scene, Report& report) {
  announce(scene.name + ", " + scene.state);
  const Model rigid_state = advanced(scene, true),
              deformable_state = advanced(scene, false);
  const Code rigid = program(scene, rigid_state, 1),
             deformable = program(scene, deformable_state, 1);
  std::vector<Entry> entries{{rigid.get(), 0}, {deformable.get(), 0}};
  Code lists;
  if (LinkedListCode::can_step(rigid_state)) {
    lists = replayed(scene, rigid_state, [&rigid_state] {
      return std::make_unique<LinkedListCode>(rigid_state);
    });
    entries.push_back({lists.get(), 0});
  } else {
    report.note("Linked lists are left out of " + scene.part +
                ": they have neither symmetry planes nor loads nor concave blocks");
  }
  const Code box2d = box2d_code(rigid_state);
  if (box2d != nullptr) {
    box2d->run(box2d_steps);
    entries.push_back({box2d.get(), 0});
  } else {
    report.note(has_box2d() ? "Box2D is left out of " + scene.part +
                                  ": it has no pressures on sides, concave polygons "
                                  "or polygons of more than 8 corners"
                            : "Box2D is left out: libbox2d-dev was not found when "
                              "this was compiled");
  }
  const auto first = report.rows.size();
  time_entries(plan, scene, rigid->work_per_step(), entries, report);
  Row& own = report.rows[first];
  own.phases = profiled(plan, scene, rigid_state, own.cost);
  time_threads(plan, scene, rigid, rigid_state, deformable, deformable_state, report);
}

}  // namespace blocks::bench
