// Files that `blocks import` refuses, tests/corpus/bad_exchange/FILE. FILE.expected has
// what it prints on standard error. Mutants of GeoJSON and WKT are read or refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "exchange/geojson_reader.hpp"
#include "exchange/mutants.hpp"
#include "exchange/soundness.hpp"
#include "exchange/wkt_reader.hpp"
#include "tools/program.hpp"

namespace blocks::exchange {
namespace {

namespace fs = std::filesystem;
using testing::slurp;
using testing::TemporaryFolder;

std::vector<fs::path> bad_files() {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(fs::path(BLOCKS_SOURCE_DIR) /
                                                  "tests/corpus/bad_exchange"))
    if (entry.path().extension() != ".expected")
      found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

class BadFile : public ::testing::TestWithParam<fs::path> {};

// A refused import writes no file.
TEST_P(BadFile, GetsExactlyTheseDiagnostics) {
  const TemporaryFolder folder;
  const std::string name = GetParam().filename().string();
  fs::copy_file(GetParam(), folder / name);
  const testing::Outcome import = testing::blocks("import " + name, folder.path());
  EXPECT_EQ(import.code, 3);
  EXPECT_EQ(import.err, slurp(GetParam().string() + ".expected"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadFile, ::testing::ValuesIn(bad_files()),
                         [](const auto& one) {
                           std::string name = one.param.filename().string();
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

// Without files the test above would pass.
TEST(BadFiles, AreFound) { EXPECT_GE(bad_files().size(), 35u); }

// Outlines that are read have finite corners.
TEST(BadFiles, MutantsAreReadOrRefused) {
  const std::vector<std::string> seeds = {
      R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )"
      R"({"material": 2, "fixed": true, "joints": [3, 0, 2]}, "geometry": {"type": "Polygon", )"
      R"("coordinates": [[[0, 0], [1.5, 0], [1.5, 1e0], [0, 0]]]}}, {"type": )"
      R"("Feature", "properties": null, "geometry": {"type": "MultiPolygon", )"
      R"("coordinates": [[[[2, 0], [3, 0], [3, 1], [2, 0]]]]}}]})",
      "POLYGON ((0 0, 1.5 0, 1.5 1e0, 0 0))\nMULTIPOLYGON Z (((2 0 1, 3 0 1, 3 1 1, 2 "
      "0 "
      "1)), EMPTY);GEOMETRYCOLLECTION (POLYGON M ((5 0 3, 6 0 0, 6 1 2, 5 0 3)))\n"};
  const std::vector<std::string> splices = {
      "-",     "1e999", "1e308",   "NaN",
      "[",     "]",     "(",       ")",
      ",",     "\"",    "{}",      "null",
      "EMPTY", "\xff",  "\\u0000", "[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["};
  std::mt19937 random(1982);
  std::size_t read = 0, refused = 0;
  for (int mutant = 0; mutant < 8000; ++mutant) {
    const bool wkt = mutant % 2 == 1;
    const std::string bytes = testing::mutant_of(seeds[wkt], splices, random);
    const OutlineFile file = wkt ? read_wkt(bytes) : read_geojson(bytes);
    const std::string said = format(file.messages, "mutant", "form", bytes);
    if (has_errors(file.messages)) {
      ++refused;
      EXPECT_NE(said.find(": error: "), said.npos);
      continue;
    }
    ++read;
    std::vector<geometry::Polygon> outlines;
    for (const Outline& outline : file.outlines) {
      ASSERT_GE(outline.corners.size(), 3u);
      for (const geometry::Vec2& corner : outline.corners)
        ASSERT_TRUE(corner.allFinite());
      if (!outline.joints.empty()) {
        ASSERT_EQ(outline.joints.size(), outline.corners.size());
      }
      outlines.push_back(outline.corners);
    }
    examine(outlines);
  }
  EXPECT_GT(read, 200u);
  EXPECT_GT(refused, 4000u);
}

}  // namespace
}  // namespace blocks::exchange
