// Reads any bytes as WKT and does all steps of an import.
#include <cstddef>
#include <cstdint>

#include "exchange/wkt_reader.hpp"
#include "fuzz_outlines.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  blocks::exchange::use(blocks::exchange::read_wkt(text), text);
  return 0;
}
