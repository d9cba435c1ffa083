// Executes MOTION, CYCLE, SOLVE and FOS and writes output when it is due (CYCLE of
// Appendix B).
#pragma once

#include <chrono>
#include <optional>
#include <set>

#include "dynamics/stepper.hpp"
#include "run/executor/console.hpp"
#include "run/executor/history_recorder.hpp"
#include "run/executor/run_files.hpp"
#include "run/safety/safety_trial.hpp"
#include "run/support/run_options.hpp"
#include "run/watch/audit_watch.hpp"
#include "run/watch/convergence.hpp"
#include "run/watch/crack_watch.hpp"
#include "run/watch/motion_watch.hpp"

namespace blocks::run {

/// How the steps of a card ended.
enum class Outcome {
  finished,
  end_time,  ///< of --until, before the end of the deck
  unsound,
  unsound_deck,
  time_limit,
  step_limit,
  interrupted
};

class Executor {
 public:
  Executor(Model& model, RunFiles& files, Console& console, const RunOptions& options);

  /// Resumes the same deck where a checkpoint was written.
  void resume(const output::Progress& progress);

  /// Sets the index of the next command.
  void set_card(long index);
  /// Makes the steps of a MOTION (a time interval) or CYCLE (a number of steps) card.
  /// If the card was begun before a restart, only its remaining steps are made.
  Outcome motion(double interval);
  Outcome cycle(long steps);
  /// Makes the steps of a SOLVE card until the forces are balanced, and records how it
  /// ended in Model::solves. `line` is that of the card.
  Outcome solve(const deck::Solve& card, int line);
  /// Makes the trials of a FOS card, which leave the model as it is, and records them
  /// in Model::safety_trials. `line` is that of the card.
  Outcome factor_of_safety(const deck::Fos& card, int line);
  /// Steps that remain to the time of --until; without it, the largest number.
  long steps_to_end() const;

  /// Sets the part of the whole deck that the next card's steps cover, for the progress
  /// line.
  void set_share(double from, double to) { share_from_ = from, share_to_ = to; }

  /// Executes DUMP.
  void dump();
  /// Executes SAVE: writes a checkpoint with this path.
  void save(const std::string& path);
  /// Echoes the input if no time passed, and reports the audit totals.
  void finish();
  /// The profile of the run; null unless it was requested.
  dynamics::Profile* profile() { return work_.profile; }
  /// Prints the table of --profile, if it was requested.
  void tell_profile();

  /// Records a warning that was already shown, for listing and summary.
  void remember(const std::string& message);
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Sets the overlaps that the certificate reported, for checkpoints.
  void set_overlaps(const std::vector<geometry::BlockOverlap>& overlaps) {
    progress_.overlaps = overlaps;
  }
  /// Registers that a card has changed the model.
  void card_has_acted() { changed_ = true; }
  /// Whether the model differs from the frame of its step, if there is one.
  bool has_changed() const { return changed_; }
  /// The current position of the run, for checkpoints.
  output::Progress progress() const;
  /// After an unsound run, writes the last good state that was kept. Returns its step,
  /// or -1 if there is none.
  long save_good_state();
  /// Whether the next card was begun before a restart, so that only some of its steps
  /// remain.
  bool begun() const { return begun_; }
  const AuditWatch& audit() const { return audit_; }

 private:
  void echo_input();
  void begin_card();
  bool passes_audit();
  void tell_what_remains() const;
  /// Makes the steps of a card, from a model that cards may have changed.
  Outcome make_steps(long steps);
  Outcome make_each_step(long steps);
  /// What follows a step; all of it needs a step that is read.
  struct StepPlan {
    bool audited = false, row = false, sampled = false;
    bool tested = false;  ///< for equilibrium
    bool pause = false;   ///< the run may stop, save its state or show its progress
    bool read = false;
  };
  /// Plans step `i` of the card, from 1 to `last`.
  StepPlan plan_step(long i, long last) const;
  /// Makes a step and what follows it. Returns false if it was unsound.
  bool make_step(const StepPlan& plan);
  /// Whether the card ends with the last step, which has `left` steps after it.
  bool ends_card(long left) const;
  /// Begins mass scaling for a SOLVE card and tells about it.
  void scale_masses();
  void end_card();
  /// The completed share of the whole run after `made` of `last` steps of the card.
  double share_after(long made, long last) const;
  /// The remaining steps of a card that was begun before a restart; otherwise `all`.
  long steps_left(long all) const { return begun_ ? progress_.steps_left : all; }
  /// Whether output is due after the next step.
  bool is_output_due() const;
  /// Whether the histories need the state after the next step.
  bool is_sample_due() const;
  void write_due_output();
  /// Warns of what the step has done to blocks.
  void warn_of_motion(const dynamics::StepResult& moved);
  /// Splits the blocks whose strength the step has reached, and tells about them.
  void split_blocks();
  void warn(const std::string& message);
  /// Keeps the states that are due. Returns why the run has to stop, or `finished`.
  Outcome stop_if_due();
  void tell_trials_remain() const;
  /// The ending of the files of a trial: "stable" or "failing", with the number of the
  /// FOS card if it is not the first one.
  std::string name_of_state(TrialOutcome outcome) const;
  /// Writes the files of the state of a trial that bounds the factor of safety now.
  void write_trial(const Model& base, const TrialResult& made);
  bool keeps_good_states() const;
  void keep_good_state();
  void save_checkpoint();
  /// Whether the last good state is at least `seconds` old and keeping another one
  /// takes at most a fiftieth of the time.
  bool is_good_state_due(double seconds) const;
  bool time_is_up() const;
  bool is_checkpoint_due() const;

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
  CrackWatch crack_watch_;
  HistoryRecorder recorder_;
  output::Progress progress_;
  bool begun_ = false;                  ///< the next card was begun before a restart
  std::optional<Convergence> solving_;  ///< of the SOLVE card whose steps are made
  int solve_line_ = 0;
  bool echoed_ = false, started_moving_ = false;
  bool changed_ = false;  ///< by a card since the last step
  double share_from_ = 0.0, share_to_ = 1.0;
  double half_depth_ = 0.0;  ///< [L] half the least depth of a convex block
  long steps_made_ = 0;      ///< since the program started
  static constexpr double between_good_states = 0.1;  ///< [s]
  Clock::time_point started_ = Clock::now(), saved_ = Clock::now();
  /// A state between two steps, kept in memory in case the run becomes unsound.
  struct GoodState {
    Model model;
    output::Progress progress;
    Clock::time_point kept;
    double took;  ///< [s]
  };
  std::optional<GoodState> good_;
  bool saved_once_ = false;  ///< a checkpoint was written
};

/// The number of steps of a MOTION of this interval: ceil(interval / dt - 1e-9)
/// (docs/cards.md#motion).
long steps_for(double interval, double dt);

}  // namespace blocks::run
