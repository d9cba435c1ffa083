// The wall and the pile: the program's time loop and other codes on the same scene.
#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>
#include <utility>

#include "blocks_code.hpp"
#include "box2d_code.hpp"
#include "linked_list.hpp"
#include "parts.hpp"
#include "pile.hpp"
#include "wall.hpp"

namespace blocks::bench {
namespace {

constexpr const char* deformable = "blocks, deformable";
constexpr long first_steps = 100;  // of a wall, not timed: its bricks meet

/// Box2D has its own way of coming to rest.
void settle(Contestant* box2d, long steps) {
  if (box2d != nullptr)
    box2d->run(steps);
}

/// Times all codes in turn; the first is what the others are compared with.
void compare(const Plan& plan, const std::string& part, const std::string& scene,
             const std::vector<Contestant*>& codes, double blocks, Report& report) {
  const auto times = take_turns(codes, plan.rounds, plan.seconds);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    Row row{part,
            scene,
            codes[i]->name(),
            codes[i]->threads(),
            blocks,
            codes[i]->name().starts_with("Box2D") ? "body-iteration" : "block-step",
            times[i].middle()};
    if (i > 0) {
      row.against = codes[0]->name();
      row.ratio = ratio(times[0], times[i]);
    }
    report.rows.push_back(row);
  }
}

void note_box2d(Report& report) {
  const std::string note = "Box2D was not found when this was compiled (libbox2d-dev): "
                           "its rows are left out";
  if (std::find(report.notes.begin(), report.notes.end(), note) == report.notes.end())
    report.notes.push_back(note);
}

/// Numbers of threads that this machine has cores for, beside one: 2, 4, 8.
std::vector<int> threads_to_time() {
  std::vector<int> all;
  for (unsigned threads = 2; threads <= 8; threads *= 2)
    if (threads <= std::thread::hardware_concurrency())
      all.push_back(static_cast<int>(threads));
  return all;
}

/// One thread by the clock, as several are timed.
class OneByClock : public Contestant {
 public:
  explicit OneByClock(BlocksCode& code) : code_(code) {}
  std::string name() const override { return "blocks, by the clock"; }
  bool by_clock() const override { return true; }
  double work_per_step() const override { return code_.work_per_step(); }
  void run(long steps) override { code_.run(steps); }

 private:
  BlocksCode& code_;
};

/// In turns of their own: waiting threads are in nobody's way.
void compare_threads(const Plan& plan, const std::string& part,
                     const std::string& scene, BlocksCode& ours, Report& report) {
  OneByClock one(ours);
  std::vector<Contestant*> codes{&one};
  std::vector<std::unique_ptr<BlocksCode>> several;
  for (const int threads : threads_to_time())
    codes.push_back(
        several
            .emplace_back(std::make_unique<BlocksCode>(ours.model(), "blocks", threads))
            .get());
  if (codes.size() > 1)
    compare(plan, part, scene, codes, ours.work_per_step(), report);
}

/// The program, the linked lists from the same state, Box2D from the start.
void compare_codes(const Plan& plan, const std::string& part, const std::string& scene,
                   BlocksCode& ours, Contestant* box2d, bool with_deformable,
                   Report& report) {
  LinkedListCode lists(ours.model(), Checks::report);
  LinkedListCode same_rules(ours.model(), Checks::program);
  std::vector<Contestant*> codes{&ours, &lists, &same_rules};
  if (box2d != nullptr)
    codes.push_back(box2d);
  else
    note_box2d(report);
  std::unique_ptr<BlocksCode> deforming;
  if (with_deformable) {
    Model soft = ours.model();
    soft.settings.rigid = false;
    deforming = std::make_unique<BlocksCode>(std::move(soft), deformable);
    codes.push_back(deforming.get());
  }
  compare(plan, part, scene, codes, ours.work_per_step(), report);
  compare_threads(plan, part, scene, ours, report);
}

std::string bricks(int power) {
  return grouped(std::lround(std::pow(10.0, power))) + " bricks";
}

/// A wall so large that only the program steps it, against its own cost for 10,000
/// bricks in the same steps.
void compare_sizes(const Plan& plan, int power, Report& report) {
  BlocksCode small(wall_of_power(4), "blocks, " + bricks(4));
  small.run(10);
  BlocksCode large(wall_of_power(power));
  large.run(10);
  const auto times = take_equal_turns({&small, &large}, plan.rounds, 4);
  const Ratio growth = ratio(times[0], times[1]);
  report.rows.push_back({"wall", bricks(power), large.name(), 1, large.work_per_step(),
                         "block-step", times[1].middle(), growth, small.name()});
  report.targets.push_back(
      {"a block-step of " + bricks(power) + " over one of " + bricks(4), growth.middle,
       1.5, false, " times"});
}

/// How many times as fast the program is with a second thread.
void add_thread_target(const std::string& scene, Report& report) {
  for (const Row& row : report.rows)
    if (row.part == "wall" && row.scene == scene && row.code == "blocks" &&
        row.threads == 2)
      report.targets.push_back({scene + ": gain by a second thread",
                                1.0 / row.ratio->middle, 1.8, true, " times"});
}

void add_targets(const std::string& scene, double box2d_limit, Report& report) {
  if (const Row* row = report.find("wall", scene, "Box2D 2.4.1"))
    report.targets.push_back({scene + ": block-steps/s over Box2D's body-iterations/s",
                              row->ratio->middle, box2d_limit, true, " times"});
  if (const Row* row = report.find("wall", scene, "linked lists of 1982"))
    report.targets.push_back({scene + ": over the linked lists of 1982",
                              row->ratio->middle, 20, true, " times"});
  if (const Row* row = report.find("wall", scene, deformable)) {
    report.targets.push_back({scene + ": deformable blocks over rigid ones",
                              row->ratio->middle, 1.5, false, " times"});
    // the report's saving of 10 %
    report.targets.push_back({scene + ": deformable blocks over rigid ones",
                              row->ratio->middle, 1.11, true, " times"});
  }
}

}  // namespace

void run_wall(const Plan& plan, Report& report) {
  for (int power = plan.smallest; power <= std::min(plan.largest, 5); ++power) {
    announce("wall of " + bricks(power));
    BlocksCode ours(wall_of_power(power));
    ours.run(first_steps);
    const auto box2d = box2d_code(wall_of_power(power));
    settle(box2d.get(), 20);
    compare_codes(plan, "wall", bricks(power), ours, box2d.get(), power <= 4, report);
    // 5 (100,000 bricks: 8) times Box2D v3, which did 3.6 times the iterations of 2.4.1
    if (power >= 3)
      add_targets(bricks(power), power == 5 ? 29 : 18, report);
    if (power == 4)
      add_thread_target(bricks(power), report);
  }
  if (plan.largest >= 6) {
    announce("wall of " + bricks(6));
    compare_sizes(plan, 6, report);
  }
}

void run_pile(const Plan& plan, Report& report) {
  announce("pile of " + grouped(plan.polygons) + " polygons");
  BlocksCode ours(loose_pile(plan.polygons));
  const Model& model = ours.model();
  while (model.time < 1.5)  // [T], the layers fall less than 3 [L]
    ours.run(100);
  const auto box2d = box2d_code(model);
  settle(box2d.get(), 100);
  compare_codes(plan, "pile", grouped(plan.polygons) + " polygons", ours, box2d.get(),
                true, report);
}

}  // namespace blocks::bench
