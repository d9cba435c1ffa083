// Reads every frame of any bytes as a results file and continues a run after the first
// frame. FileError is allowed. HDF5 itself reads the bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/file_error.hpp"
#include "memory_file.hpp"
#include "output/results/results.hpp"
#include "post/read/results_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blocks;
  static const testing::MemoryFile file;
  file.hold({reinterpret_cast<const char*>(data), size});
  try {
    const post::ResultsReader reader(file.path());
    reader.title();
    reader.recorded();
    for (long i = 0; i < std::min(reader.frames(), 5L); ++i) {
      const post::Frame frame = reader.frame(i);
      const post::FrameContacts contacts = reader.contacts(i);
      if (frame.centroid.cols() != frame.size() ||
          contacts.point.cols() != contacts.size())
        std::abort();
      for (std::size_t b = 0; b < frame.joints.size(); ++b)
        if (frame.joints[b].size() != frame.outlines[b].size())
          std::abort();
    }
  } catch (const files::FileError&) {
  }
  try {
    output::ResultsWriter::run_id_of(file.path());
    output::ResultsWriter::identity_of(file.path());
    output::ResultsWriter::reopen(file.path(), 1);
  } catch (const files::FileError&) {
  }
  return 0;
}
