// The states of the laws of joints (docs/laws.md) of each frame, in /BLOCKS/contacts.
#pragma once

#include <vector>

#include "files/hdf5_handle.hpp"
#include "model/model.hpp"

namespace blocks::output {

/// The rows are those of the other columns of contacts. The columns are absent as long
/// as the model has no JOINT card, so that files of other models do not depend on them.
/// Contacts of earlier frames then have zeros.
class LawStateColumns {
 public:
  /// own: the group /BLOCKS, which stays open.
  explicit LawStateColumns(hid_t own) : own_(own) {}

  /// Opens the columns of a file if it has them. Throws hdf5::Failure if one is missing
  /// or has the wrong shape.
  void open();
  /// Writes the states of all contacts between blocks from row `first` on, and zeros
  /// for the contacts with planes that follow them, up to row `end`.
  void put(hsize_t first, hsize_t end, const Model& model);
  /// Keeps the first `rows` rows.
  void truncate(hsize_t rows);

 private:
  void create();

  hid_t own_;
  std::vector<hdf5::Column> columns_;  ///< in the order of each_law_field, or none
};

}  // namespace blocks::output
