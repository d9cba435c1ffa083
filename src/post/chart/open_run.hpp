// The results of one run, which may be in several files.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "post/chart/history.hpp"
#include "post/read/results_reader.hpp"

namespace blocks::post {

/// The results of one run in the order of time.
class OpenRun {
 public:
  /// Opens the files of a run. Values are shown in `units`, if these are given, and
  /// stresses are positive in compression if `compression_positive`.
  OpenRun(const RunParts& run, const std::optional<Units>& units,
          bool compression_positive) {
    for (const std::string& file : run.files) {
      parts_.push_back(std::make_unique<ResultsReader>(file));
      if (units)
        parts_.back()->show_in(*units);
      if (compression_positive)
        parts_.back()->make_compression_positive();
    }
  }
  /// The open files, in the order of time.
  std::vector<const ResultsReader*> parts() const {
    std::vector<const ResultsReader*> all;
    for (const auto& part : parts_)
      all.push_back(part.get());
    return all;
  }
  /// The numbers of the materials that have a name.
  quantities::MaterialNumbers material_numbers() const {
    quantities::MaterialNumbers numbers;
    for (const auto& [number, name] : first().material_names())
      numbers[name] = number;
    return numbers;
  }
  /// The part with the beginning of the run.
  const ResultsReader& first() const { return *parts_.front(); }
  /// The part with the end of the run.
  const ResultsReader& last() const { return *parts_.back(); }
  /// Returns the latest part that has begun at this time, or the first one.
  const ResultsReader& at(double time) const {
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part)
      if ((*part)->times().front() <= time)
        return **part;
    return first();
  }

 private:
  std::vector<std::unique_ptr<ResultsReader>> parts_;
};

}  // namespace blocks::post
