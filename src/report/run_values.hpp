// Reads the measures and the profile of one run from its results file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/profile.hpp"
#include "post/read/results_reader.hpp"
#include "quantities/dimension.hpp"
#include "report/measure.hpp"

namespace blocks::report {

/// A profile across the model: a quantity along a line at one time.
struct ProfileQuestion {
  post::ProfileLine line;
  std::string quantity = "dy";
  std::optional<double> time;    ///< [T] empty: the last frame
  std::optional<double> mirror;  ///< [L] x of the plane of a half model
};

/// How results are read.
struct ReadingOptions {
  std::optional<Units> units;  ///< empty: those of the deck
  bool compression_positive = false;
  bool frames = false;  ///< not the samples of HISTORY
};

/// The values of a profile at its places, in ascending order of position.
struct ProfileValues {
  std::vector<double> position;  ///< (places) [L]
  std::vector<double> value;     ///< (places)
};

/// What a measure is called, and its dimension.
struct MeasureLabel {
  std::string label;  ///< "smallest displacement y at the end"
  quantities::Dimension dimension;
};

struct RunValues {
  std::vector<double> values;        ///< (measures) NaN: none
  std::vector<std::string> faults;   ///< (measures) why there is no value, or empty
  std::vector<MeasureLabel> labels;  ///< (measures) of curves and profiles
  std::optional<ProfileValues> profile;
  std::string profile_fault;  ///< why there is no profile, or empty
};

/// Reads the results of a run. Measures of outcomes are left NaN. Reads one frame at a
/// time, and only the frames that are needed. Throws std::runtime_error if the file
/// cannot be read.
class RunReader {
 public:
  RunReader(const std::string& results, const ReadingOptions& options);

  const post::ResultsReader& results() const { return results_; }
  RunValues read(const std::vector<Measure>& measures,
                 const std::optional<ProfileQuestion>& profile) const;

 private:
  void read_curves(const std::vector<Measure>& measures,
                   const std::vector<std::size_t>& wanted, bool frames,
                   RunValues& values) const;
  ProfileValues read_profile(const ProfileQuestion& question) const;

  post::ResultsReader results_;
  bool frames_;
};

}  // namespace blocks::report
