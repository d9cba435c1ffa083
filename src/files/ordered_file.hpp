// An HDF5 file driver that keeps the file consistent at every moment. Parts that
// readers may refer to change only at flushes. They are written in an order in which no
// reader finds a reference to missing data. A kill -9 between any two writes loses
// nothing that was flushed before.
//
// After a failed write, which is reported, nothing more is written, so that HDF5 can
// close the file. The driver interprets HDF5's superblock and B-tree nodes and is
// independent of BLOCKS.
#pragma once

#include <hdf5.h>

namespace blocks::hdf5 {

/// Selects this driver for files opened with the access list. Throws Failure.
void write_in_order(hid_t file_access);

}  // namespace blocks::hdf5
