// Files of traces and points. tests/corpus/bad_traces/FILE is refused with the messages
// in FILE.expected; names that begin with "points" are files of points.
#include "exchange/trace_reader.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "exchange/geojson_reader.hpp"
#include "exchange/mutants.hpp"
#include "tools/program.hpp"

namespace blocks::exchange {
namespace {

namespace fs = std::filesystem;

fs::path bad_traces() {
  return fs::path(BLOCKS_SOURCE_DIR) / "tests/corpus/bad_traces";
}

/// Describes joint, line and points of each trace: "3@2: (5e-1 1) (2 3)".
std::string describe(const TraceFile& file) {
  const auto decimal = [](const geometry::Decimal& value) {
    return value.digits() +
           (value.exponent() == 0 ? "" : "e" + std::to_string(value.exponent()));
  };
  std::string text;
  for (const Trace& trace : file.traces) {
    text += (trace.joint ? std::to_string(*trace.joint) : "-") + "@" +
            std::to_string(trace.line) + ":";
    for (const geometry::DecimalPoint& point : trace.points)
      text += " (" + decimal(point.x) + " " + decimal(point.y) + ")";
    text += "\n";
  }
  return text;
}

std::string messages(const TraceFile& file, std::string_view text) {
  return format(file.messages, "file", file.form, text);
}

TEST(BadTraces, GetExactlyTheseDiagnostics) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(bad_traces())) {
    if (entry.path().extension() == ".expected")
      continue;
    ++files;
    const std::string name = entry.path().filename().string();
    const std::string text = testing::slurp(entry.path());
    const bool points = name.starts_with("points");
    const TraceFile traces = points ? TraceFile{} : read_traces(text);
    const PointFile cells = points ? read_points(text) : PointFile{};
    const std::vector<Message>& found = points ? cells.messages : traces.messages;
    EXPECT_TRUE(has_errors(found)) << name;
    EXPECT_EQ(format(found, name, points ? cells.form : traces.form, text),
              testing::slurp(entry.path().string() + ".expected"));
  }
  EXPECT_GE(files, 20u);
}

TEST(Traces, FromGeoJsonKeepDigitsAndJoints) {
  const std::string text =
      R"({"type": "FeatureCollection", "features": [
{"type": "Feature", "properties": {"joint": 7}, "geometry":
 {"type": "GeometryCollection", "geometries": [
  {"type": "LineString", "coordinates": [[0.1, 0], [1.00000000000000000001, 2, 9]]},
  {"type": "MultiLineString", "coordinates": [[[0, 0], [0.0, 0], [3, 4], [5, 6]]]}]}},
{"type": "Feature", "properties": {"joint": null}, "geometry":
 {"type": "LineString", "coordinates": [[-1e-3, 0], [1, 1]]}}]})";
  const TraceFile file = read_traces(text);
  EXPECT_EQ(file.found, "GeoJSON, 3 polylines, 4 segments");
  EXPECT_EQ(describe(file), "7@4: (1e-1 0) (100000000000000000001e-20 2)\n"
                            "7@5: (0 0) (3 4) (5 6)\n"
                            "-@7: (-1e-3 0) (1 1)\n");
  const std::string said = messages(file, text);
  EXPECT_FALSE(has_errors(file.messages));
  for (const char* expected :
       {"file:4:52: warning: GeoJSON: 1 position has more than x and y\n",
        "file:5:57: warning: GeoJSON: 1 point repeats the point before and is "
        "dropped\n"})
    EXPECT_NE(said.find(expected), std::string::npos) << said;
}

TEST(Traces, FromWkt) {
  const std::string text =
      "\xEF\xBB\xBFSRID=4326;linestring z (0 0 1, 1 .5 2);\n"
      "GEOMETRYCOLLECTION (MULTILINESTRING ((1 1, 2 2), EMPTY, (3 3, 4 4, 5 6)))\n";
  const TraceFile file = read_traces(text);
  EXPECT_EQ(file.found, "WKT, 3 polylines, 4 segments");
  EXPECT_EQ(describe(file),
            "-@1: (0 0) (1 5e-1)\n-@2: (1 1) (2 2)\n-@2: (3 3) (4 4) (5 6)\n");
  EXPECT_FALSE(has_errors(file.messages));
  EXPECT_EQ(file.messages.size(), 3u);  // SRID, heights, EMPTY
}

TEST(Traces, FromCsvInAnyOrderOfColumns) {
  const std::string named = "# mapped\r\njoint; Y2; x1; \"y1\"; x2; note\r\n"
                            "2; 4; 1; 2; 3; a\r\n; 1; 0; 0; 1; b # c\r\n";
  const TraceFile file = read_traces(named);
  EXPECT_EQ(describe(file), "2@3: (1 2) (3 4)\n-@4: (0 0) (1 1)\n");
  EXPECT_EQ(file.messages.size(), 1u);  // the column "note"
  EXPECT_FALSE(has_errors(file.messages));
  EXPECT_EQ(describe(read_traces("0,0, 1.50,1")), "-@1: (0 0) (15e-1 1)\n");
  EXPECT_EQ(describe(read_traces("\n 0 0\t1 -2 \n")), "-@2: (0 0) (1 -2)\n");
}

/// A GeoJSON line with this member crs, which may be empty.
std::string line_with(const std::string& crs, const std::string& points) {
  return R"({"type": "FeatureCollection", )" + crs +
         R"("features": [{"type": "Feature", )" +
         R"("properties": {}, "geometry": {"type": "LineString", "coordinates": [)" +
         points + "]}}]}";
}
std::string crs(const std::string& name) {
  return R"("crs": {"type": "name", "properties": {"name": ")" + name + R"("}}, )";
}

// A local map can have small numbers, and a wrong crs can have numbers beyond degrees.
TEST(Traces, ThatAreDegreesAreWarnedOf) {
  const std::string place = "[5.3241, 60.3897], [5.3245, 60.3900]";
  const auto told = [](const std::string& text) {
    const TraceFile file = read_traces(text);
    EXPECT_FALSE(has_errors(file.messages));
    return messages(file, text);
  };
  for (const std::string name :
       {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326", "EPSG:4258"})
    EXPECT_NE(
        told(line_with(crs(name), place)).find("the coordinates are degrees (crs "),
        std::string::npos)
        << name;
  EXPECT_NE(told(line_with("", place)).find("the coordinates look like degrees"),
            std::string::npos);
  for (const std::string& lengths :
       {line_with(crs("urn:ogc:def:crs:EPSG::25832"), place),
        line_with(R"("crs": null, )", place), line_with("", "[0, 0], [40, 60]"),
        line_with("", "[100, 50], [120, 55]"),
        line_with("", "[412300, 6731800], [412300.5, 6731800]"),
        line_with(crs("urn:ogc:def:crs:OGC:1.3:CRS84"), "[0, 0], [412300, 6731800]"),
        line_with(R"("crs": {"properties": 7}, )", place)})
    EXPECT_EQ(told(lengths), "") << lengths;
}

TEST(Outlines, ThatAreDegreesAreWarnedOf) {
  const auto polygon = [](const std::string& name, const std::string& ring) {
    std::string text = line_with(crs(name), "[" + ring + "]");
    return text.replace(text.find("LineString"), 10, "Polygon");
  };
  const std::string name = "urn:ogc:def:crs:OGC:1.3:CRS84";
  const OutlineFile degrees =
      read_geojson(polygon(name, "[5, 60], [6, 60], [6, 61], [5, 60]"));
  ASSERT_EQ(degrees.messages.size(), 1u);
  EXPECT_EQ(degrees.messages[0].text,
            "the coordinates are degrees (crs CRS84), and are taken as lengths");
  EXPECT_TRUE(read_geojson(polygon(name, "[0, 0], [600, 0], [600, 600], [0, 0]"))
                  .messages.empty());
}

TEST(Points, FromAllForms) {
  for (const std::string text :
       {R"({"type": "GeometryCollection", "geometries": [{"type": "Point",
            "coordinates": [1, 0.2]}, {"type": "MultiPoint", "coordinates": [[3, 4]]}]})",
        "POINT (1 0.2)\nMULTIPOINT ((3 4))", "MULTIPOINT (1 0.2, 3 4)",
        "1, 0.2\n3, 4\n", "y x\n.2 1\n4 3"}) {
    const PointFile file = read_points(text);
    EXPECT_TRUE(file.messages.empty()) << text;
    ASSERT_EQ(file.points.size(), 2u) << text;
    EXPECT_EQ(file.points[0].y.digits() + "e" +
                  std::to_string(file.points[0].y.exponent()),
              "2e-1");
    EXPECT_EQ(file.points[1].x.value(), 3);
  }
}

// Traces that are read have at least two points, and each differs from the last.
TEST(Traces, MutantsAreReadOrRefused) {
  const std::vector<std::string> seeds = {
      R"({"type": "Feature", "properties": {"joint": 2}, "geometry": {"type": )"
      R"("MultiLineString", "coordinates": [[[0, 0], [1.5, 0]], [[2, 0], [3, 1e0]]]}})",
      "LINESTRING (0 0, 1.5 0, 1.5 1e0)\nMULTILINESTRING Z ((2 0 1, 3 0 1), EMPTY);",
      "x1, y1, x2, y2, joint\n0, 0, 1, 1, 2\n3, 4, 5.5, 6, \n"};
  const std::vector<std::string> splices = {"-", "1e999", "NaN",  "[",    "]",
                                            "(", ")",     ",",    "\"",   "{}",
                                            ";", "#",     "null", "\xff", "\n"};
  std::mt19937 random(1982);
  std::size_t read = 0, refused = 0;
  for (int mutant = 0; mutant < 6000; ++mutant) {
    const std::string bytes = testing::mutant_of(
        seeds[static_cast<std::size_t>(mutant) % seeds.size()], splices, random);
    const TraceFile file = read_traces(bytes);
    read_points(bytes);
    if (has_errors(file.messages)) {
      ++refused;
      EXPECT_NE(messages(file, bytes).find(": error: "), std::string::npos);
      continue;
    }
    ++read;
    ASSERT_FALSE(file.traces.empty()) << bytes;
    for (const Trace& trace : file.traces) {
      ASSERT_GE(trace.points.size(), 2u) << bytes;
      for (std::size_t i = 1; i < trace.points.size(); ++i)
        ASSERT_TRUE(trace.points[i].x.digits() != trace.points[i - 1].x.digits() ||
                    trace.points[i].x.exponent() != trace.points[i - 1].x.exponent() ||
                    trace.points[i].y.digits() != trace.points[i - 1].y.digits() ||
                    trace.points[i].y.exponent() != trace.points[i - 1].y.exponent())
            << bytes;
    }
  }
  EXPECT_GT(read, 300u);
  EXPECT_GT(refused, 2000u);
}

}  // namespace
}  // namespace blocks::exchange
