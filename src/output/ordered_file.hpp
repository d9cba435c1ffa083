// An HDF5 file driver whose file is sound at every moment: what readers may already
// follow is changed at flushes only, and in an order in which they never meet a
// reference to what is not there yet. kill -9 between any two writes loses nothing that
// was flushed before. After a failed write, which is reported, nothing more is written,
// so that HDF5 can close the file. Knows bytes and HDF5's superblock and B-tree nodes,
// nothing of BLOCKS.
#pragma once

#include <hdf5.h>

namespace blocks::output::hdf5 {

/// Makes files opened with this access list be written in order. Throws Failure.
void write_in_order(hid_t file_access);

}  // namespace blocks::output::hdf5
