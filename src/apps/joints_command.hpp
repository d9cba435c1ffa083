// `blocks joints`: statistics of fracture traces, and joint sets fitted to them.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "apps/options/common_options.hpp"
#include "convert/joint_maps.hpp"

namespace blocks::apps {

struct JointsOptions {
  convert::MapInput input;
  double shortest = 0.0;               ///< [L] >= 0
  std::vector<std::string> scanlines;  ///< "x1,y1,x2,y2"
  std::vector<std::string> outputs;    ///< files; empty: print a table
  bool json = false;                   ///< print JSON instead of the table
  FigureSize size;                     ///< of a figure
  std::string deck;  ///< of the fit; empty: the name of the input with .deck, here
};

void add_joint_statistics_options(CLI::App& command, JointsOptions& options);
void add_joint_fit_options(CLI::App& command, JointsOptions& options);

/// Prints or writes the statistics. Returns a code of run::ExitCode.
int joint_statistics(const JointsOptions& options);

/// Fits joint sets to one map and writes a deck. Returns a code of run::ExitCode.
int fit_joints(const JointsOptions& options);

}  // namespace blocks::apps
