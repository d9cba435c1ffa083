// The acting contacts of each frame under /BLOCKS/contacts, frame after frame.
#pragma once

#include <functional>

#include "files/hdf5_handle.hpp"
#include "model/model.hpp"
#include "output/results/results_law_states.hpp"

namespace blocks::output {

/// Blocks, corners and edges are numbered from 1; an edge has the number of its first
/// corner. A corner on a symmetry plane has edge block 0 and the plane's number as
/// edge.
class ContactColumns {
 public:
  /// make(name, type, width, rows per chunk) creates or opens a column.
  using Make = std::function<hdf5::Column(const std::string&, hid_t, hsize_t, hsize_t)>;
  /// own: the group /BLOCKS, which stays open.
  ContactColumns(const Make& make, hid_t own);

  /// Opens what a file may lack: the states of laws. Throws hdf5::Failure.
  void open() { states_.open(); }

  void put(long frame, const Model& model);
  void truncate(long frames);

 private:
  hdf5::Column corner_block_, corner_, edge_block_, edge_;
  hdf5::Column point_, normal_, normal_force_, shear_force_, overlap_;
  hdf5::Column offsets_, counts_;
  LawStateColumns states_;
  hsize_t rows_ = 0;
};

}  // namespace blocks::output
