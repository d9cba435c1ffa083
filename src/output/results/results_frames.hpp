// The frames of NAME.vtkhdf: their datasets, and what a frame adds to them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "output/results/results.hpp"
#include "output/results/results_columns.hpp"
#include "output/results/results_contacts.hpp"
#include "output/results/results_cracks.hpp"
#include "output/results/results_late_columns.hpp"
#include "output/results/results_water.hpp"

namespace blocks::output {

/// The groups of a results file. They stay open as long as its frames are written.
struct ResultsGroups {
  hdf5::Handle vtk;    ///< /VTKHDF
  hdf5::Handle steps;  ///< /VTKHDF/Steps
  hdf5::Handle own;    ///< /BLOCKS
};

/// The cells of all blocks in VTK's form. The cell of a removed block has no corners,
/// so other programs do not draw it.
struct ResultsCells {
  std::vector<int> starts = {0};  ///< (n + 1) where the corners of each cell begin
  std::vector<int> corners;       ///< corners of all cells

  explicit ResultsCells(const Blocks& blocks);
};

class ResultsFrames {
 public:
  /// Creates the datasets, with chunks for a model of this size. `unbalanced` adds the
  /// unbalanced forces, their ratio and the local ratios.
  static std::unique_ptr<ResultsFrames> create(const ResultsGroups& groups,
                                               const Model& model, bool unbalanced);
  /// Opens the datasets of a file that has frames. Throws hdf5::Failure if one is
  /// missing or has the wrong shape.
  static std::unique_ptr<ResultsFrames> open(const ResultsGroups& groups);

  /// Keeps the first `count` frames.
  void truncate(long count);
  /// Writes the model as frame number `frame`, from 0, which is the next one.
  void put(long frame, const Model& model);
  /// The step of a frame.
  std::int64_t step(long frame);
  FirstPositions first_positions(const ResultsGroups& groups);

 private:
  /// Visits all datasets. make(group, name, type, width, rows per chunk) creates or
  /// opens one.
  template <class Make>
  ResultsFrames(const ResultsGroups& groups, Make&& make, hsize_t blocks,
                hsize_t corners, bool unbalanced);
  bool has_topology(const ResultsCells& now);
  void put_topology(const Blocks& blocks);
  void put_cells(long frame, const Blocks& blocks);
  void put_frame_data(long frame, const Model& model);
  void put_unbalanced(long frame, const Model& model);

  hdf5::Column points_, connectivity_, offsets_, types_;
  hdf5::Column number_of_points_, number_of_cells_, number_of_ids_;
  hdf5::Column values_, number_of_parts_, part_offsets_, point_offsets_, cell_offsets_,
      id_offsets_;
  std::map<std::string, FrameColumn> cells_;
  LateColumn<int> joints_;
  WaterColumns water_;
  CrackColumns cracks_;
  std::map<std::string, hdf5::Column> frame_data_, frame_offsets_, frame_sizes_;
  std::unique_ptr<ContactColumns> contacts_;

  /// Position of the topology written last; part_ is -1 if there is none.
  std::int64_t part_ = -1, first_cell_ = 0, first_id_ = 0;
};

}  // namespace blocks::output
