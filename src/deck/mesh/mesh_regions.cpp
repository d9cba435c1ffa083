// READ9 form (d): region records, the scratch tape of QMESH's descendants FASTQ and
// RENUM. It is the nearest relative of the lost tape of 1973 (docs/mesh-formats.md).
#include <fmt/format.h>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck::mesh {
namespace {

// Header of a region: KKK, NNN, KNBC, KSBC, NUMREG, BAR, M1.
struct Region {
  long elements = 0, nodes = 0, node_flags = 0, side_flags = 0, id = 0;
  bool bars = false;
};

class Reader {
 public:
  explicit Reader(const Records& records)
      : records_(records), width_(records.length(0, "region header") / 7) {}

  MeshFile read();

 private:
  const Records& records_;
  std::size_t width_;           // width of integers and logicals
  std::size_t real_width_ = 0;  // known after the first nodes
  std::size_t record_ = 0;
  std::size_t bars_ = 0;
  Elements elements_;

  Region header() const;
  void nodes(const Region& region);
  void elements(const Region& region);
  void skip(long count, const std::string& what);
  long integer(std::size_t offset) const {
    return records_.integer(record_, offset, width_);
  }
};

Region Reader::header() const {
  if (records_.length(record_, "region header") != 7 * width_)
    fail(records_.place(record_),
         fmt::format("a region header should have {} bytes, the record has {}",
                     7 * width_, records_.length(record_, "region header")));
  Region region{integer(0),          integer(width_),     integer(2 * width_),
                integer(3 * width_), integer(4 * width_), integer(5 * width_) != 0};
  for (const long count :
       {region.elements, region.nodes, region.node_flags, region.side_flags})
    if (count < 0 || count > INT32_MAX)
      fail(records_.place(record_),
           fmt::format("region {}: {} is not a valid count", region.id, count));
  return region;
}

// Reads (NUID, X, Y) x NNN. Nodes shared with an earlier region are not repeated, so
// the record may be missing.
void Reader::nodes(const Region& region) {
  if (region.nodes == 0)
    return;
  const auto n = static_cast<std::size_t>(region.nodes);
  const std::size_t length = records_.length(record_, "nodes of the region");
  std::size_t real_width = 0;
  if (length == n * (width_ + 8))
    real_width = 4;
  if (length == n * (width_ + 16))
    real_width = 8;
  if (real_width == 0 || (real_width_ != 0 && real_width != real_width_))
    fail(records_.place(record_),
         fmt::format("region {}: {} nodes expected, the record has {}", region.id, n,
                     counted(length, "byte")));
  real_width_ = real_width;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t at = i * (width_ + 2 * real_width);
    elements_.add_node(magnitude(integer(at)),
                       records_.real(record_, at + width_, real_width),
                       records_.real(record_, at + width_ + real_width, real_width),
                       records_.place(record_));
  }
  ++record_;
}

// Reads LXK(4, KKK): anticlockwise node ids; a fourth id of 0 marks a triangle.
void Reader::elements(const Region& region) {
  const auto n = static_cast<std::size_t>(region.elements);
  const std::size_t length = records_.length(record_, "elements of the region");
  if (n > 0 && length != n * 4 * width_)
    fail(records_.place(record_),
         fmt::format("region {}: {} elements expected, the record has {}", region.id, n,
                     counted(length, "byte")));
  for (std::size_t e = 0; e < n && !region.bars; ++e) {
    std::array<long, 4> corners{};
    for (std::size_t c = 0; c < 4; ++c)
      corners[c] = magnitude(integer((4 * e + c) * width_));
    elements_.add(std::span(corners).first(corners[3] == 0 ? 3 : 4), region.id,
                  fmt::format("region {} element {}", region.id, e + 1),
                  records_.place(record_));
  }
  if (region.bars)
    bars_ += n;
  ++record_;
}

void Reader::skip(long count, const std::string& what) {
  if (count == 0)
    return;
  if (records_.length(record_, what) != static_cast<std::size_t>(count) * width_)
    fail(records_.place(record_),
         fmt::format("{}: {} expected", what,
                     counted(static_cast<std::size_t>(count), "integer")));
  ++record_;
}

MeshFile Reader::read() {
  std::size_t regions = 0;
  for (; record_ < records_.size(); ++regions) {
    const Region region = header();
    ++record_;
    nodes(region);
    elements(region);
    skip(region.node_flags, "node boundary list");
    skip(region.side_flags, "side boundary list");
  }
  if (elements_.blocks.empty())
    fail(records_.place(0), "no elements in the region records");
  MeshFile mesh;
  mesh.form = MeshForm::regions;
  mesh.found =
      fmt::format("region records, {}, {}: {}", describe(records_, width_, real_width_),
                  counted(regions, "region"), elements_.found());
  if (bars_ > 0)
    mesh.found += fmt::format(" ({} skipped)", counted(bars_, "bar"));
  mesh.blocks = std::move(elements_.blocks);
  return mesh;
}

}  // namespace

MeshFile read_regions(const Records& records) { return Reader(records).read(); }

}  // namespace blocks::deck::mesh
