// The record of cracks in NAME.vtkhdf: /BLOCKS/cracks, and the cell data Parent
// (docs/cracks.md#the-record).
#pragma once

#include <optional>

#include "model/model.hpp"
#include "output/results/results_columns.hpp"

namespace blocks::output {

/// A row for each crack, and for each frame the number of cracks so far. The data are
/// absent as long as the deck has no CRACK card, so that files of other decks do not
/// depend on them. Earlier frames then have no cracks.
class CrackColumns {
 public:
  /// vtk, steps, own: the groups /VTKHDF, /VTKHDF/Steps and /BLOCKS, which stay open.
  CrackColumns(hid_t vtk, hid_t steps, hid_t own)
      : vtk_(vtk), steps_(steps), own_(own) {}

  /// Opens the data of a file if it has them. Throws hdf5::Failure if their shape is
  /// wrong.
  void open();
  /// Writes the cracks since the last frame, and the parents of all blocks, as those of
  /// frame number `frame`, which is the next one.
  void put(long frame, const Model& model);
  /// Keeps the data of `frames` frames; the last of them has `blocks` blocks.
  void truncate(long frames, hsize_t blocks);

 private:
  struct Columns {
    hdf5::Column step, time, parent, child, cause, stress, from, to, moved;
    hdf5::Column parent_area, child_area;
    hdf5::Column kinetic_before, kinetic_after, strain_before, strain_after;
    hdf5::Column counts;
  };
  /// Calls act(column, name, type, width) for each column; the last one is `counts`.
  template <class Act> static void visit(Columns& columns, Act&& act);
  void create(long frame, hsize_t blocks);
  void remove();
  void put_records(const Model& model);

  hid_t vtk_, steps_, own_;
  std::optional<FrameColumn> parents_;
  std::optional<Columns> columns_;
  hsize_t rows_ = 0;  ///< cracks of the last frame
};

}  // namespace blocks::output
