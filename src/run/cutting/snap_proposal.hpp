// Proposes snap for a TRACES card that says nothing about its loose ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exchange/trace_reader.hpp"
#include "geometry/joint_sources.hpp"

namespace blocks::run {

/// Loose ends of a trace file that stop just short of another joint.
struct SnapProposal {
  std::string message;     ///< how many, how far at most, and where
  std::string hint;        ///< the snap that prolongs them
  bool is_common = false;  ///< whether they are many of the loose ends
};

/// Returns the mean distance between the two ends of a trace, [L]; 0 without traces.
double mean_extent(const std::vector<exchange::Trace>& traces);

/// Examines the ends of traces that are inside the outline and on no other joint. Those
/// that reach another joint or a side of the outline, if they are prolonged by a
/// fiftieth of the mean length [L] of a trace, were most likely meant to end there.
/// They are common if they are a quarter of all loose ends: of ends that are not meant
/// to meet, in a network whose traces cross ten others, an eighth does so by chance.
/// others: joints that are not from this file. Returns nothing if no end is so near.
std::optional<SnapProposal>
propose_snap(const std::vector<geometry::JointSegment>& traces, double extent,
             const std::vector<geometry::JointSegment>& others,
             const std::vector<geometry::DecimalPoint>& outline,
             const geometry::ProgressFunction& progress = {});

}  // namespace blocks::run
