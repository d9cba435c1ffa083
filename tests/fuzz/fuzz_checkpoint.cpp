// Reads any bytes as a checkpoint, with their own checksum and with a valid one. The
// result is a model that a run can continue, or FileError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "dynamics/stepper.hpp"
#include "files/file_error.hpp"
#include "memory_file.hpp"
#include "output/checkpoint/checkpoint.hpp"
#include "output/sealed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blocks;
  static const testing::MemoryFile file;
  std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const bool forged : {false, true}) {
    if (forged)
      bytes = samples::sealed(std::move(bytes));
    file.hold(bytes);
    try {
      output::CheckpointInfo info;
      Model model = output::read_checkpoint(file.path(), info);
      if (model.blocks.size() == 0)
        continue;
      dynamics::Workspace work;
      dynamics::prepare(model);
      dynamics::Stepper stepper(model, work);
      stepper.advance(true);
      stepper.up_to_date();
    } catch (const files::FileError&) {
    }
  }
  return 0;
}
