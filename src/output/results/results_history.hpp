// The histories of the HISTORY card under /BLOCKS/history. Each section 1, 2, ... has
// the samples of one request: a later card, or a continuation that asks for other
// quantities, begins a new section.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/hdf5_handle.hpp"
#include "model/settings.hpp"

namespace blocks::output {

/// What the attribute `sampling` of a section says.
inline constexpr const char* history_sampling =
    "multiples of the interval; linear interpolation between the two steps around each "
    "of them";

/// Samples are kept in memory until flush(); readers see them after publish().
class HistorySections {
 public:
  /// `results` is the group /BLOCKS. Existing sections keep their first `rows` samples
  /// altogether. Throws hdf5::Failure if they have fewer.
  HistorySections(hid_t results, long rows);

  /// Makes this request the current one. Returns the time of its last sample if the
  /// last section has the same request, so that it continues.
  std::optional<double> begin(const HistoryRequest& request);
  /// Adds a sample with a value for each quantity. Returns true if so many are in
  /// memory that flush() should follow.
  bool add(double time, std::span<const double> values);
  /// The number of samples of all sections.
  long rows() const { return rows_; }
  bool flushed() const { return times_.empty(); }

  /// Writes the samples in memory behind those that readers see.
  void flush();
  /// Lets readers see them. Between flush() and this call the file must be flushed.
  void publish();

 private:
  struct Section {
    hdf5::Handle group;
    hdf5::Column time, values;
    hsize_t rows = 0;
  };
  Section open(int number) const;
  Section create(int number) const;
  bool is_of(const Section& section, const HistoryRequest& request) const;

  hid_t results_;
  HistoryRequest request_;
  int used_ = 0;      ///< number of the last section with samples
  int sections_ = 0;  ///< number of sections in the file
  std::optional<Section> current_;
  bool published_ = true;
  long rows_ = 0;
  std::vector<double> times_, values_;  ///< samples in memory
};

}  // namespace blocks::output
