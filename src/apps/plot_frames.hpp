// The frames that `blocks plot` draws.
#pragma once

#include <vector>

#include "plot_command.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::apps {

/// Returns the indices of the frames nearest to the times of the options, of those at
/// the times of a sheet, of those of a movie, or the last one. Throws
/// std::runtime_error if there are none between --from and --to.
std::vector<long> chosen_frames(const post::ResultsReader& results,
                                const PlotOptions& options);

}  // namespace blocks::apps
