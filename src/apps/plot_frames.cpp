#include "plot_frames.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "post/figure/movie.hpp"

namespace blocks::apps {
namespace {

/// Returns the frames between --from and --to. Throws std::runtime_error if there are
/// none.
std::vector<long> frames_between(const post::ResultsReader& results,
                                 const PlotOptions& options) {
  const auto& times = results.times();
  const double from = options.from.value_or(times.front()),
               to = options.to.value_or(times.back());
  std::vector<long> found;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] >= from && times[i] <= to)
      found.push_back(static_cast<long>(i));
  if (found.empty())
    throw std::runtime_error(
        fmt::format("{} has times {:g} to {:g}, none between {:g} and {:g}",
                    results.path(), times.front(), times.back(), from, to));
  return found;
}

/// Returns the frames at `count` evenly spaced times without duplicates.
std::vector<long> spread(const post::ResultsReader& results,
                         const std::vector<long>& among, int count) {
  const auto& times = results.times();
  const double from = times[static_cast<std::size_t>(among.front())],
               to = times[static_cast<std::size_t>(among.back())];
  std::vector<long> chosen;
  for (int k = 0; k < count; ++k) {
    const double at = count == 1 ? to : from + (to - from) * k / (count - 1);
    if (const long i = results.nearest(at); chosen.empty() || chosen.back() != i)
      chosen.push_back(i);
  }
  return chosen;
}

/// Returns every `every`-th frame, and the last.
std::vector<long> thinned(const std::vector<long>& among, int every) {
  std::vector<long> chosen;
  for (std::size_t i = 0; i < among.size(); ++i)
    if (i % static_cast<std::size_t>(every) == 0 || i + 1 == among.size())
      chosen.push_back(among[i]);
  return chosen;
}

}  // namespace

std::vector<long> chosen_frames(const post::ResultsReader& results,
                                const PlotOptions& options) {
  if (!options.times.empty()) {
    std::vector<long> frames;
    frames.reserve(options.times.size());
    for (const double time : options.times)
      frames.push_back(results.at(time));
    return frames;
  }
  const std::vector<long> between = frames_between(results, options);
  if (options.sheet > 0)
    return spread(results, between, options.sheet);
  if (post::is_movie(options.output))
    return thinned(between, options.every.value_or(1));
  return {between.back()};
}

}  // namespace blocks::apps
