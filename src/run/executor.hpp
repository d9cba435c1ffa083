// Makes time pass: MOTION and CYCLE, with output when it is due (CYCLE of Appendix B).
#pragma once

#include <chrono>
#include <optional>
#include <set>

#include "dynamics/stepper.hpp"
#include "run/audit_watch.hpp"
#include "run/console.hpp"
#include "run/motion_watch.hpp"
#include "run/run.hpp"
#include "run/run_files.hpp"

namespace blocks::run {

/// How a stretch of steps ended.
enum class Outcome {
  finished,
  unsound,
  unsound_deck,
  time_limit,
  step_limit,
  interrupted
};

class Executor {
 public:
  Executor(Model& model, RunFiles& files, Console& console, const RunOptions& options);

  /// Goes on where a checkpoint of the same deck was written.
  void resume(const output::Progress& progress);

  /// The next command is this one.
  void set_card(long index);
  /// Runs the steps of a MOTION (an interval of time) or CYCLE (a number of steps)
  /// card, or those that were left of it.
  Outcome motion(double interval);
  Outcome cycle(long steps);

  /// Part of the whole deck that a card's steps make up, for the progress line.
  void set_share(double from, double to) { share_from_ = from, share_to_ = to; }

  /// DUMP.
  void dump();
  /// A deck in which no time passed is echoed all the same.
  void finish();
  /// Of the run, if it is wanted, else null.
  dynamics::Profile* profile() { return work_.profile; }
  /// --profile: where the time went.
  void tell_profile();

  /// Keeps a warning that was shown already, for listing and summary.
  void remember(const std::string& message);
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// What the certificate told, for checkpoints.
  void set_overlaps(const std::vector<geometry::BlockOverlap>& overlaps) {
    progress_.overlaps = overlaps;
  }
  /// Where the run stands.
  output::Progress progress() const;
  /// Of an unsound run: writes the last good state that was kept. Its step, -1: none
  /// was.
  long save_good_state();
  /// The steps of the next card are those left of one begun before.
  bool begun() const { return begun_; }
  const AuditWatch& audit() const { return audit_; }

 private:
  void echo();
  void start();
  bool passes_audit();
  void tell_what_remains() const;
  Outcome advance(long steps);
  Outcome march(long steps);
  /// What is left of a card begun before; `all` of one that begins.
  long left_of(long all) const { return begun_ ? progress_.steps_left : all; }
  /// By the step that comes.
  bool output_due() const;
  void output_if_due();
  void watch(const dynamics::StepResult& moved);
  void warn(const std::string& message);
  Outcome pressed_for_time();
  bool keeps_good_states() const;
  void keep_good_state();
  void save_checkpoint();
  /// The last one is at least so many seconds old, and as old as what it took allows.
  bool good_state_due(double seconds) const;
  bool time_is_up() const;
  bool checkpoint_due() const;

  using Clock = std::chrono::steady_clock;
  Model& model_;
  RunFiles& files_;
  Console& console_;
  const RunOptions& options_;
  dynamics::Workspace work_;
  dynamics::Stepper stepper_;
  dynamics::Profile profile_;
  AuditWatch audit_;
  std::vector<std::string> warnings_;
  MotionWatch watch_;
  output::Progress progress_;
  bool begun_ = false;  ///< the next card's first steps were made before
  bool echoed_ = false, started_moving_ = false;
  double share_from_ = 0.0, share_to_ = 1.0;
  double half_depth_ = 0.0;  ///< [L] half the least depth of any block
  long steps_made_ = 0;      ///< in this run of the program
  static constexpr double between_good_states = 0.1;  ///< [s]
  Clock::time_point started_ = Clock::now(), saved_ = Clock::now();
  /// A state between two steps, in memory, for the case that the run becomes unsound.
  struct GoodState {
    Model model;
    output::Progress progress;
    Clock::time_point kept;
    double took;  ///< [s]
  };
  std::optional<GoodState> good_;
  bool saved_once_ = false;  ///< a checkpoint was written
};

/// Steps that a MOTION of this interval takes: ceil(interval / dt - 1e-9)
/// (docs/cards.md#motion).
long steps_for(double interval, double dt);

}  // namespace blocks::run
