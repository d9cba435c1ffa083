// The list of all fields of a checkpoint: those of the run, and those of its model.
#pragma once

#include "output/checkpoint/checkpoint.hpp"
#include "output/checkpoint/model_fields.hpp"

namespace blocks::output {

/// Visits the contents of the report's "restart tape": the data of the run and the
/// model.
template <class M, class Info, class Archive>
void visit_checkpoint(M& model, Info& info, Archive& ar) {
  auto& [deck_file, deck_text, overrides, results, results_run, results_frames,
         listing_bytes, version, progress] = info;
  ar("run/deck_file", deck_file);
  ar("run/deck_text", deck_text);
  ar("run/overrides", overrides);
  ar("run/results", results);
  ar("run/results_run", results_run);
  ar({"run/results_frames", count_from_0}, results_frames);
  ar({"run/listing_bytes", count_from_0}, listing_bytes);
  ar("run/version", version);
  {
    auto& [card, steps_left, below_ratio, frames, samples, bytes, tabled_step,
           half_depth, fast_reported, flight_reported, deep_reported, finished,
           warnings, overlaps] = progress;
    ar({"run/progress/card", count_from_0}, card);
    ar({"run/progress/steps_left", count_from_0}, steps_left);
    ar("run/progress/below_ratio", below_ratio);
    ar({"run/progress/frames", count_from_0}, frames);
    ar({"run/progress/samples", count_from_0}, samples);
    ar({"run/progress/listing_bytes", count_from_0}, bytes);
    // It is -1 if there is no table yet.
    ar({"run/progress/tabled_step", {-1.0, 0x1p53, "a number from -1"}}, tabled_step);
    // It is infinite if no block is convex.
    ar({"run/progress/half_depth", {0.0, infinite, "a number from 0"}}, half_depth);
    ar("run/progress/fast_told", fast_reported);
    ar("run/progress/flight_told", flight_reported);
    ar("run/progress/deep_told", deep_reported);
    ar("run/progress/finished", finished);
    ar("run/progress/warnings", warnings);
    ar.records("run/progress/overlaps", overlaps, [](auto& column, auto& overlap) {
      auto& [first, second, area, place, depth] = overlap;
      column({"first", IndexOf::block}, first);
      column({"second", IndexOf::block}, second);
      column({"area", not_negative}, area);
      column("x", place.x());
      column("y", place.y());
      column({"depth", not_negative}, depth);
    });
  }
  visit_model(model, ar);
}

}  // namespace blocks::output
