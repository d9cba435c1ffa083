// `blocks study contacts`: variants of the contact decision side by side.
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
  long steps = 0;                        ///< 0: the scene's own
  std::vector<const Variant*> variants;  ///< default need not be among them
  int threads = 1;
  /// Its run is what is expected of a deck; null: that of the default rules.
  const Variant* expected = nullptr;
};

/// One line of the table: a variant in a scene over all frames.
struct Row {
  const Variant* variant = nullptr;
  int frames = 0;
  Estimate wrong_signs;     ///< share of the signs of (19), mean over the frames
  Estimate wrong_tangents;  ///< share of the answers to (20), likewise
  Estimate phantom;         ///< share of the contacts that act
  Estimate missed;          ///< share of the contacts that should
  long hung = 0, fell = 0;
  Estimate hang_ups, fall_throughs;  ///< share of the frames; NaN: nothing could hang
  Estimate speed_lost;               ///< mean over the frames; NaN: not asked
  Estimate energy;                   ///< mean of the error; NaN: not asked
  double worst_energy = not_asked;
  long diverged = 0;                  ///< frames
  Estimate divergences;               ///< share of the frames
  Estimate divergence_step;           ///< median of the first one, over those frames
  std::vector<int> hung_in, fell_in;  ///< numbers of frames
  std::string refused;  ///< why the variant did not run in this scene; empty: it did
};

struct Study {
  std::string scene, what;
  long steps = 0;
  std::vector<Row> rows;
  std::string refused;    ///< why the default rules cannot run, then there are no rows
  std::string doubt;      ///< why a deck's own run is no measure; empty: it is one
  std::string again;      ///< options that make the same frames once more
  std::string expected;   ///< variant whose run is the measure; empty: a scene's motion
  bool must_pass = true;  ///< the default rules pass the scene in every frame
};

/// Runs every variant in the same frames. The same result for any number of threads. A
/// variant whose blocks cannot be made in every frame is refused.
Study run_study(Scene scene, const StudyChoice& choice);

}  // namespace blocks::study
