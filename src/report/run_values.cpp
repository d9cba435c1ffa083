#include "report/run_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "post/chart/history.hpp"
#include "post/read/crack_tracker.hpp"
#include "post/read/frame_quantity.hpp"
#include "post/read/units.hpp"
#include "report/statistics.hpp"

namespace blocks::report {
namespace {

using When = Measure::When;

quantities::MaterialNumbers material_numbers(const post::ResultsReader& results) {
  quantities::MaterialNumbers numbers;
  for (const auto& [number, name] : results.material_names())
    numbers[name] = number;
  return numbers;
}

/// Returns the value at a time, linear between two points; NaN outside them.
double value_at(const std::vector<double>& time, const std::vector<double>& values,
                double at) {
  const auto next = std::lower_bound(time.begin(), time.end(), at);
  if (next == time.end())
    return no_number;
  const auto i = static_cast<std::size_t>(next - time.begin());
  if (*next == at)
    return values[i];
  if (i == 0)
    return no_number;
  return std::lerp(values[i - 1], values[i],
                   (at - time[i - 1]) / (time[i] - time[i - 1]));
}

/// Returns the largest (sign 1) or smallest (-1) value, without those that are NaN.
double extreme(const std::vector<double>& values, double sign) {
  double found = no_number;
  for (const double value : values)
    if (!std::isnan(value) && !(sign * value <= sign * found))
      found = value;
  return found;
}

double reduced_value(const Measure& measure, const std::vector<double>& time,
                     const std::vector<double>& values) {
  switch (measure.when) {
  case When::largest:
    return extreme(values, 1.0);
  case When::smallest:
    return extreme(values, -1.0);
  case When::time:
    return value_at(time, values, measure.time);
  case When::end:
    break;
  }
  return values.empty() ? no_number : values.back();
}

/// Returns the times of the frames that the measure needs; empty: all.
std::optional<post::TimeRange> frames_for(const Measure& measure,
                                          const std::vector<double>& times) {
  if (measure.when == When::end)
    return post::TimeRange{times.back(), times.back()};
  if (measure.when != When::time)
    return std::nullopt;
  const auto next = std::lower_bound(times.begin(), times.end(), measure.time);
  if (next == times.end() || (next == times.begin() && *next != measure.time))
    return post::TimeRange{times.back(), times.back()};  // the value is NaN
  return post::TimeRange{*next == measure.time ? *next : *(next - 1), *next};
}

std::string moment_words(const Measure& measure, const std::optional<Units>& units) {
  switch (measure.when) {
  case When::largest:
    return ", largest over time";
  case When::smallest:
    return ", smallest over time";
  case When::time:
    return " at " + post::time_text(measure.time, std::nullopt, units);
  case When::end:
    break;
  }
  return " at the end";
}

}  // namespace

RunReader::RunReader(const std::string& results, const ReadingOptions& options)
    : results_(results), frames_(options.frames) {
  if (options.units)
    results_.show_in(*options.units);
  if (options.compression_positive)
    results_.make_compression_positive();
}

void RunReader::read_curves(const std::vector<Measure>& measures,
                            const std::vector<std::size_t>& wanted, bool frames,
                            RunValues& values) const {
  std::vector<post::Curve> curves;
  post::TimeRange range{std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  bool all = !frames;
  for (const std::size_t i : wanted) {
    curves.push_back(measures[i].curve);
    const auto needed = frames_for(measures[i], results_.times());
    all = all || !needed;
    if (needed)
      range = {std::min(range.from, needed->from), std::max(range.to, needed->to)};
  }
  const post::History history =
      post::read_history({&results_}, curves, all ? post::TimeRange{} : range, frames,
                         material_numbers(results_));
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const Measure& measure = measures[wanted[k]];
    const post::Series& series = history.series[k];
    values.labels[wanted[k]] = {series.label + moment_words(measure, results_.units()),
                                series.dimension};
    values.values[wanted[k]] = reduced_value(measure, history.time, series.values);
    const std::vector<double>& times = frames ? results_.times() : history.time;
    if (measure.when == When::time && !times.empty() &&
        !(measure.time >= times.front() && measure.time <= times.back()))
      values.faults[wanted[k]] =
          fmt::format("{} has values at times {:g} to {:g}, not {:g}\n  hint: choose a "
                      "time in this "
                      "range, or {} for the end of each run",
                      results_.path(), times.front(), times.back(), measure.time,
                      measure.curve.name());
  }
}

RunValues RunReader::read(const std::vector<Measure>& measures,
                          const std::optional<ProfileQuestion>& profile) const {
  RunValues values;
  values.values.assign(measures.size(), no_number);
  values.faults.resize(measures.size());
  values.labels.resize(measures.size());
  std::set<std::string> recorded;
  if (!frames_)
    for (const post::Curve& curve : post::recorded_curves(results_))
      recorded.insert(curve.name());
  // Curves of the same source are read at once.
  std::vector<std::size_t> from_history, from_frames;
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (measures[i].from == Measure::From::curve)
      (recorded.contains(measures[i].curve.name()) ? from_history : from_frames)
          .push_back(i);
  for (const auto* wanted : {&from_history, &from_frames}) {
    const bool frames = wanted == &from_frames;
    try {
      if (!wanted->empty())
        read_curves(measures, *wanted, frames, values);
    } catch (const std::runtime_error&) {
      // One of the curves does not exist in this run; find out which.
      for (const std::size_t i : *wanted)
        try {
          read_curves(measures, {i}, frames, values);
        } catch (const std::runtime_error& fault) {
          values.faults[i] = fault.what();
        }
    }
  }
  if (!profile)
    return values;
  try {
    values.profile = read_profile(*profile);
  } catch (const std::runtime_error& fault) {
    // The run ended before the time of the profile, or it meets no block.
    values.profile_fault = fault.what();
    for (std::size_t i = 0; i < measures.size(); ++i)
      if (measures[i].from == Measure::From::profile)
        values.faults[i] = fault.what();
    return values;
  }
  const auto* kind = quantities::find_quantity(profile->quantity);
  for (std::size_t i = 0; i < measures.size(); ++i)
    if (measures[i].from == Measure::From::profile) {
      const bool largest = measures[i].key == "max";
      values.values[i] = extreme(values.profile->value, largest ? 1.0 : -1.0);
      values.labels[i] = {fmt::format("{} {} of the profile",
                                      largest ? "largest" : "smallest", kind->label),
                          kind->dimension};
    }
  return values;
}

ProfileValues RunReader::read_profile(const ProfileQuestion& question) const {
  const post::QuantityKind* kind = quantities::find_quantity(question.quantity);
  post::ResultsTracker tracker(results_);
  auto places = post::profile_places(tracker.first(), question.line);
  if (question.mirror)
    places = post::both_halves(places, *question.mirror);
  const long i = question.time ? results_.at(*question.time) : results_.frames() - 1;
  const post::Frame now = results_.frame(i);
  ProfileValues profile;
  for (const post::ProfilePlace& place : places)
    profile.position.push_back(place.position);
  profile.value = post::profile_values(places, *kind, now, tracker.at(i, now).first);
  return profile;
}

}  // namespace blocks::report
