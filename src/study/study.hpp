// `blocks study contacts`: compares variants of the contact decision.
#pragma once

#include <string>
#include <vector>

#include "study/measure.hpp"
#include "study/statistics.hpp"

namespace blocks::study {

struct StudyChoice {
  FrameChoice frames;
  int first = 0;                         ///< number of the first frame
  int count = 20;                        ///< frames
  long steps = 0;                        ///< 0: the default of the scene
  std::vector<const Variant*> variants;  ///< need not contain the default
  int threads = 1;
  /// The variant whose run is the expected motion of a deck; null selects the default
  /// rules.
  const Variant* expected = nullptr;
};

/// What failed first in a frame.
struct Reason {
  int frame = 0;  ///< its number
  std::string kind, why;
};

/// The frames of one kind of a scene, and how many of them failed.
struct KindCount {
  std::string kind;
  int frames = 0;
  long failed = 0;  ///< in any way
  long hung = 0, fell = 0, deep = 0;
};

/// One line of the table: a variant in a scene over all frames.
struct Row {
  const Variant* variant = nullptr;
  int frames = 0;
  Estimate wrong_signs;     ///< share of wrong signs of (19), mean over the frames
  Estimate wrong_tangents;  ///< share of wrong answers to (20), likewise
  Estimate phantom;         ///< share of the acting contacts
  Estimate missed;          ///< share of the contacts that should act
  long hung = 0, fell = 0;
  Estimate hang_ups, fall_throughs;  ///< share of the frames; NaN: nothing could hang
  Estimate speed_lost;               ///< mean over the frames; NaN: not measured
  Estimate energy;                   ///< mean of the error; NaN: not measured
  double worst_energy = not_asked;
  long diverged = 0;                  ///< frames
  Estimate divergences;               ///< share of these frames
  Estimate divergence_step;           ///< median of the first step, over those frames
  std::vector<int> hung_in, fell_in;  ///< numbers of the frames
  // Only beside an uncut domain:
  long deep = 0;                 ///< frames in which a contact was too deep
  Estimate deep_frames;          ///< share of these frames; NaN: not measured
  std::vector<int> deep_in;      ///< numbers of the frames
  std::vector<KindCount> kinds;  ///< of the scene
  std::vector<Reason> reasons;   ///< of the frames that failed
  std::string refused;           ///< why the variant did not run; empty if it did
};

struct Study {
  std::string scene, what;
  long steps = 0;
  std::vector<Row> rows;
  std::string refused;    ///< why the default rules cannot run; then no rows
  std::string doubt;      ///< why a deck's run is no valid reference; or empty
  std::string again;      ///< options that reproduce the frames
  std::string expected;   ///< variant that gives the reference run; or empty
  bool must_pass = true;  ///< the default rules must pass in every frame
  /// Why hang-ups and fall-throughs are not counted for a deck; or empty. The rows then
  /// have none.
  std::string not_counted = {};
};

/// What was measured of a variant in one frame; NaN if it was not measured.
struct FrameValues {
  int frame = 0;  ///< its number
  bool could_hang = false, hung = false, fell = false;
  double wrong_signs = not_asked, wrong_tangents = not_asked;  ///< shares, 0 to 1
  double phantom = not_asked, missed = not_asked;              ///< likewise
  double speed_lost = not_asked, energy_error = not_asked;
  double diverged = not_asked;  ///< first step that differs; NaN: none
  bool deep = false;            ///< a contact was too deep, see Outcome
  std::string kind = {};        ///< of the scene, in which frames are counted together
  std::string why = {};         ///< what failed first; may be empty
};

/// Returns the deck of the first frame of the choice, see deck_of_frame. Throws
/// UnfitBlock.
std::string first_deck(const Scene& scene, const StudyChoice& choice);

/// Returns the line of a variant. seed: of the frames, from which the resamples of the
/// intervals are drawn. The result depends on the order of the frames.
Row summarise(const Variant& variant, const std::vector<FrameValues>& frames,
              std::uint64_t seed);

/// Removes the counts of hang-ups and fall-throughs if they mean nothing: the run that
/// they are counted against is no valid reference, or its own variant does not repeat
/// it in any of several frames.
void drop_void_counts(Study& study);

/// Runs every variant in the same frames. The result does not depend on the number of
/// threads. A variant is refused if its blocks cannot be made in every frame.
Study run_study(Scene scene, const StudyChoice& choice);

}  // namespace blocks::study
