// The reader of GeoJSON on any bytes, and all that import does with what it reads.
#include <cstddef>
#include <cstdint>

#include "exchange/geojson_reader.hpp"
#include "fuzz_outlines.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  blocks::exchange::use(blocks::exchange::read_geojson(text), text);
  return 0;
}
