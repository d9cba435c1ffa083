// Reads any bytes as a drawing, and does all steps of an import.
#include <cstddef>
#include <cstdint>

#include "exchange/dxf_reader.hpp"
#include "exchange/trace_reader.hpp"
#include "fuzz_outlines.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  blocks::exchange::use(blocks::exchange::read_dxf(text), text);
  const auto traces = blocks::exchange::read_traces(text);
  blocks::exchange::format(traces.messages, "fuzz", traces.form, text);
  return 0;
}
