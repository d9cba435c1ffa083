// A block for export to other programs. Plain structs, independent of the model and the
// results.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::exchange {

struct BlockRecord {
  int number = 0;  ///< from 1
  int material = 0;
  std::string material_name;  ///< may be empty
  bool fixed = false;
  double area = 0.0;          ///< [L^2]
  geometry::Polygon outline;  ///< [L] clockwise, not closed
  /// Joint id of the side from corner i to i + 1; empty: 0 for all sides.
  std::vector<int> joints = {};
  std::vector<std::pair<std::string, double>> results;  ///< name and value
};

/// Returns the shortest decimal that reads back as the same double.
std::string shortest(double value);

/// Tests whether a side of any block has a joint id other than 0. Only then do the
/// writers mention joints.
bool has_joints(const std::vector<BlockRecord>& blocks);

/// One position of a ring as GeoJSON and WKT have it.
struct RingPosition {
  geometry::Vec2 corner;  ///< [L]
  int joint = 0;          ///< of the side that begins here in the order of the ring
};

/// Returns corner 1, the other corners in reverse order (anticlockwise), and corner 1
/// again. Side k of the ring is side n - k + 1 of the block, with both counted from 1.
std::vector<RingPosition> closed_ring(const BlockRecord& block);

/// Returns a GeoJSON FeatureCollection with one feature per line. The name of a
/// material is the property "material_name". Rings are
/// anticlockwise (RFC 7946) and begin and end with corner 1. Joint ids are the property
/// "joints", in the order of the sides of the ring. time: written as a member
/// of the collection. Values that are not finite become null.
std::string write_geojson(const std::vector<BlockRecord>& blocks,
                          std::optional<double> time = {});

/// Returns WKT with one POLYGON per line; rings are as in GeoJSON. Joint ids make it
/// POLYGON M, where m is the id of the side that begins at the position. WKT cannot
/// hold materials.
std::string write_wkt(const std::vector<BlockRecord>& blocks);

/// Returns Gmsh 2.2 ASCII. Corners at the same point share a node; elements are
/// anticlockwise from corner 1; the material is the physical group, with its name if it
/// has one. A block with more than 4 corners becomes triangles, and a joint id becomes
/// the physical group of a line element. Throws std::invalid_argument that names a
/// block without triangles, because its outline is not simple.
std::string write_gmsh(const std::vector<BlockRecord>& blocks);

/// Tests whether elements cannot hold all of the blocks. Then write_gmsh() adds the
/// section $Blocks (docs/mesh-formats.md), which also says which blocks are fixed.
bool needs_rings(const std::vector<BlockRecord>& blocks);

/// Returns an ASCII DXF of R12. A block is a closed POLYLINE on the layer of its
/// material ("2_granite", "material_2"), a side with a joint id a LINE on the layer
/// "joint_3". unit: of length, as UNITS names it; empty: none is stated.
std::string write_dxf(const std::vector<BlockRecord>& blocks, const std::string& unit);

/// The scale of a drawing.
struct SvgScale {
  double scale = 0.0;      ///< > 0; 1:100 has 100
  double unit_in_m = 1.0;  ///< [m] the unit of length of the coordinates
  std::string unit;        ///< its name; empty: not known
};

/// Returns the largest usual scale (1, 2 or 5 times a power of ten) at which the blocks
/// fit on a page of A4.
double default_scale(const std::vector<BlockRecord>& blocks, double unit_in_m);

/// Returns an SVG that is true to scale: its width and height are in mm, its
/// coordinates those of the blocks, with y reversed. joint_colour: returns "#rrggbb"
/// for an id.
std::string write_svg(const std::vector<BlockRecord>& blocks, const SvgScale& scale,
                      const std::function<std::string(int)>& joint_colour);

}  // namespace blocks::exchange
