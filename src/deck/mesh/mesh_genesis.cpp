// READ9 form (c): GENESIS, the mesh part of EXODUS I, as FASTQ and its successors write
// it to tape 9 (docs/mesh-formats.md). Only plane meshes are read; node and side sets
// are skipped.
#include <fmt/format.h>

#include "deck/mesh/mesh_forms.hpp"
#include "text/counted.hpp"

namespace blocks::deck::mesh {
namespace {

// Contents of the second record.
struct Header {
  std::size_t integer_width = 4;
  long nodes = 0, dimensions = 0, elements = 0, blocks = 0;
  long node_sets = 0, side_sets = 0;
  std::optional<long> version;  // tenth word, in later files only
};

// Reads NUMNP, NDIM, NUMEL, NELBLK, NUMNPS, LNPSNL, NUMESS, LESSEL, LESSNL(, version).
Header read_header(const Records& records) {
  Header header;
  const std::size_t length = records.length(1, "GENESIS sizes");
  if (length == 72 || length == 80)
    header.integer_width = 8;
  else if (length != 36 && length != 40)
    fail(records.place(1), fmt::format("the GENESIS sizes should be 9 or 10 integers "
                                       "of 4 or 8 bytes, the record has {}",
                                       counted(length, "byte")));
  const auto at = [&](std::size_t i) {
    return records.integer(1, i * header.integer_width, header.integer_width);
  };
  header.nodes = at(0);
  header.dimensions = at(1);
  header.elements = at(2);
  header.blocks = at(3);
  header.node_sets = at(4);
  header.side_sets = at(6);
  if (length == 10 * header.integer_width)
    header.version = at(9);
  if (header.dimensions != 2)
    fail(records.place(1), fmt::format("NDIM is {}; READ9 reads plane meshes (NDIM 2)",
                                       header.dimensions));
  if (header.nodes < 3 || header.elements < 1 || header.blocks < 1)
    fail(records.place(1), fmt::format("no mesh: NUMNP {}, NUMEL {}, NELBLK {}",
                                       header.nodes, header.elements, header.blocks));
  return header;
}

/// Returns the bytes per number, 4 or 8, if `count` numbers fill record i; otherwise
/// fails. Nothing is allocated before this check.
std::size_t width_of(const Records& records, std::size_t i, long count,
                     const std::string& what) {
  const std::size_t length = records.length(i, what);
  const auto n = static_cast<std::size_t>(count);
  if (count > 0 && length % n == 0 && (length / n == 4 || length / n == 8))
    return length / n;
  fail(records.place(i), fmt::format("{}: {} numbers expected, the record has {}", what,
                                     count, counted(length, "byte")));
}

void expect_width(const Records& records, std::size_t i, long count, std::size_t width,
                  const std::string& what) {
  if (width_of(records, i, count, what) != width)
    fail(records.place(i),
         fmt::format("{}: integers of {} bytes expected", what, width));
}

/// Returns the number of corners of an element with `links` nodes, which start with the
/// corners; 0 for a bar.
std::size_t corners_of(long links) {
  switch (links) {
  case 2:
    return 0;
  case 3:
  case 6:
    return 3;
  case 4:
  case 8:
  case 9:
    return 4;
  default:
    return 1;
  }
}

}  // namespace

MeshFile read_genesis(const Records& records) {
  const Header header = read_header(records);
  const std::size_t width = header.integer_width;
  std::size_t record = 2;

  // The record contains all x, then all y.
  if (header.nodes > INT32_MAX || header.elements > INT32_MAX)
    fail(records.place(1), fmt::format("NUMNP {} or NUMEL {} is too large for the file",
                                       header.nodes, header.elements));
  const std::size_t real_width =
      width_of(records, record, 2 * header.nodes, "coordinates");
  Elements elements;
  const auto n = static_cast<std::size_t>(header.nodes);
  for (std::size_t i = 0; i < n; ++i)
    elements.add_node(
        static_cast<long>(i) + 1, records.real(record, i * real_width, real_width),
        records.real(record, (n + i) * real_width, real_width), records.place(record));
  ++record;
  expect_width(records, record++, header.elements, width, "element map");

  long total = 0;
  std::size_t bars = 0;
  for (long b = 1; b <= header.blocks; ++b) {
    const std::string name = fmt::format("element block {}", b);
    expect_width(records, record, 4, width, name);
    const auto at = [&](std::size_t i) {
      return records.integer(record, i * width, width);
    };
    const long id = at(0), count = at(1), links = at(2);
    const std::size_t corners = corners_of(links);
    if (count < 0 || count > header.elements - total)
      fail(records.place(record), fmt::format("{} has {} elements, NUMEL is {}", name,
                                              count, header.elements));
    if (count > 0 && corners == 1)
      fail(records.place(record),
           fmt::format("{} has {} nodes per element; READ9 reads 3, 4, 6, 8 or 9", name,
                       links));
    ++record;
    if (count > 0)
      expect_width(records, record, count * links, width, name + " connectivity");
    else
      records.length(record, name + " connectivity");
    for (long e = 0; e < count && corners > 0; ++e) {
      std::array<long, 4> nodes{};
      for (std::size_t c = 0; c < corners; ++c)
        nodes[c] = records.integer(
            record, (static_cast<std::size_t>(e * links) + c) * width, width);
      elements.add(std::span(nodes).first(corners), id,
                   fmt::format("element {}", total + e + 1), records.place(record));
    }
    if (corners == 0)
      bars += static_cast<std::size_t>(count);
    total += count;
    ++record;
    // This record always exists and is never empty: FASTQ writes a number even if there
    // are no attributes.
    records.length(record++, name + " attributes");
  }
  if (total != header.elements)
    fail(records.place(1), fmt::format("NUMEL is {}, the element blocks have {}",
                                       header.elements, total));
  if (header.node_sets > 0)
    records.length(record + 4, "end of the node sets");
  if (header.side_sets > 0)
    records.length(record + 12, "end of the side sets");
  if (elements.blocks.empty())
    fail(records.place(1), "no triangles or quadrilaterals in the GENESIS file");

  MeshFile mesh;
  mesh.form = MeshForm::genesis;
  mesh.found =
      fmt::format("GENESIS, {}, {}, {}: {}",
                  header.version ? fmt::format("version word {}", *header.version)
                                 : "no version word",
                  describe(records, width, real_width),
                  counted(static_cast<std::size_t>(header.blocks), "element block"),
                  elements.found());
  if (bars > 0)
    mesh.found += fmt::format(" ({} skipped)", counted(bars, "bar"));
  mesh.blocks = std::move(elements.blocks);
  return mesh;
}

}  // namespace blocks::deck::mesh
