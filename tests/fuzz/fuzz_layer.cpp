// Makes a LayerRequest of any bytes. The result is a layer whose certificate holds, or
// a LayerError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "geometry/layer.hpp"

namespace {

using namespace blocks::geometry;

/// Reads values from bytes, and zeros after their end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  int next() { return at_ < size_ ? data_[at_++] : 0; }
  /// Returns a decimal with up to five digits and an exponent from -12 to 15, mostly 0.
  Decimal decimal() {
    const int kind = next();
    const int digits = (kind & 1) != 0 ? next() : next() * 256 + next();
    const int exponent = (kind & 0xe) == 0 ? next() % 28 - 12 : 0;
    const std::string sign = (kind & 0x10) != 0 ? "-" : "";
    return Decimal::parse(sign + std::to_string(digits) + "e" +
                          std::to_string(exponent))
        .value();
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

/// Returns a layer request. Few random quadrilaterals are convex, so half of them are
/// nearly rectangles.
LayerRequest request_of(Bytes& bytes) {
  LayerRequest request;
  const int kind = bytes.next();
  auto& c = request.corners;
  if ((kind & 1) != 0) {
    c[0] = {bytes.decimal(), bytes.decimal()};
    c[2] = {bytes.decimal(), bytes.decimal()};
    c[1] = {(kind & 2) != 0 ? bytes.decimal() : c[0].x, c[2].y};
    c[3] = {c[2].x, (kind & 4) != 0 ? bytes.decimal() : c[0].y};
  } else {
    for (auto& corner : c)
      corner = {bytes.decimal(), bytes.decimal()};
  }
  request.spacing = static_cast<Spacing>((kind >> 4) % 3);
  request.count = bytes.next() % 64;
  if (request.spacing == Spacing::listed) {
    for (int i = 0; i < request.count; ++i) {
      request.bottom.push_back(bytes.decimal());
      request.top.push_back(bytes.decimal());
    }
  } else {
    request.angle_min = bytes.decimal();
    request.angle_max = bytes.decimal();
    if ((kind & 8) != 0)
      request.merge_ratio = bytes.decimal();
    request.stream = {static_cast<std::uint64_t>(bytes.next()),
                      static_cast<std::uint64_t>(bytes.next())};
  }
  return request;
}

void require(bool holds) {
  if (!holds)
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const LayerRequest request = request_of(bytes);
  try {
    const Layer layer = cut_layer(request);
    require(layer.certificate.holds && layer.certificate.fault.empty());
    require(certify_tiling(layer.mesh).holds);
    require(layer.mesh.cells.size() + layer.absorptions.size() ==
            static_cast<std::size_t>(request.count));
    // The layer has the corners of the deck.
    const auto n = layer.mesh.cells.size();
    const std::size_t ends[4] = {0, n + 1, 2 * n + 1, n};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& corner = request.corners[i];
      require(layer.mesh.vertices[ends[i]] == Vec2(corner.x.value(), corner.y.value()));
    }
  } catch (const LayerError& error) {
    require(error.what()[0] != '\0' && !error.hint.empty());
  }
  return 0;
}
