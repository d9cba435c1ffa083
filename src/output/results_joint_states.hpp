// The states of the laws of joints (docs/laws.md) of each frame, in /BLOCKS/contacts.
#pragma once

#include <optional>

#include "model/model.hpp"
#include "output/hdf5_handle.hpp"

namespace blocks::output {

/// The rows are those of the other columns of contacts. The columns are absent as long
/// as the model has no JOINT card, so that files of other models do not depend on them.
/// Contacts of earlier frames then have zeros.
class JointStateColumns {
 public:
  /// own: the group /BLOCKS, which stays open.
  explicit JointStateColumns(hid_t own) : own_(own) {}

  /// Opens the columns of a file if it has them. Throws hdf5::Failure if one is missing
  /// or has the wrong shape.
  void open();
  /// Writes the states of all contacts between blocks from row `first` on, and zeros
  /// for the contacts with planes that follow them, up to row `end`.
  void put(hsize_t first, hsize_t end, const Model& model);
  /// Keeps the first `rows` rows.
  void truncate(hsize_t rows);

 private:
  struct Columns {
    hdf5::Column law, bonded, failed;
    hdf5::Column slip, path, dilation, closure, plastic, stiffness, shear_stiffness,
        length;
  };
  /// Calls act(column, name, is_whole) for each column.
  template <class Act> static void visit(Columns& columns, Act&& act);
  void create();

  hid_t own_;
  std::optional<Columns> columns_;
};

}  // namespace blocks::output
